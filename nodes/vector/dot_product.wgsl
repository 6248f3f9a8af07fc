import chiaro::total;

/// Dot product
///
/// How much two directions agree: 1 the same, 0 at right angles, -1 opposite. For longer vectors
/// times their lengths.
///
/// @param a "A" default=0,0,0 : The one.
/// @param b "B" default=0,0,0 : The other.
/// @return dot "Dot product" : The sum of the products of their components.
fn dot_product(a: vec3f, b: vec3f) -> f32 {
    return bounded(dot(bounded_vec3(a), bounded_vec3(b)));
}
