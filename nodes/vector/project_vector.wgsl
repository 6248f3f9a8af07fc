import chiaro::numeric;
import chiaro::total;

/// Project vector
///
/// Splits a vector into what goes along another one and what goes across it. Across a normal lies
/// what is left on the surface.
///
/// @param vector "Vector" default=0,0,0 : What is split.
/// @param onto "Onto" from=normal : Any length; without one, nothing goes along it.
fn project_vector(vector: vec3f, onto: vec3f) -> ProjectedVector {
    let v = bounded_vec3(vector);
    let d = normalize_or(onto, vec3f(0.0));
    let along = bounded_vec3(bounded(dot(v, d)) * d);
    return ProjectedVector(along, bounded_vec3(v - along));
}

struct ProjectedVector {
    /// The part along the other vector.
    along: vec3f,
    /// The part at right angles to it.
    across: vec3f,
}
