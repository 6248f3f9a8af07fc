import chiaro::numeric;
import chiaro::total;

/// Reflect
///
/// A vector that comes in and bounces off a surface. For the view direction, which points out, take
/// Mirrored view.
///
/// @param vector "Vector" default=0,0,-1 : Toward the surface.
/// @param normal "Normal" from=normal : Any length; without one, the vector goes on as it is.
/// @return vector "Vector" : Away from the surface, as long as before.
fn reflect_vector(vector: vec3f, normal: vec3f) -> vec3f {
    let n = normalize_or(normal, vec3f(0.0));
    let v = bounded_vec3(vector);
    return bounded_vec3(v - 2.0 * dot(n, v) * n);
}
