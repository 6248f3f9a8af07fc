import chiaro::numeric;

/// Refract
///
/// A direction bent as it enters glass or water. Where nothing enters, as seen from under water at
/// a low angle, it is reflected instead.
///
/// @param vector "Vector" default=0,0,-1 : Toward the surface; any length.
/// @param normal "Normal" from=normal : Toward where the vector comes from; any length.
/// @param ratio "Ratio" default=0.667 min=0 max=4 : Index of refraction outside over inside: into
///   glass 1/1.5.
/// @return vector "Vector" : Unit, or 0 where the vector has no direction.
fn refract_vector(vector: vec3f, normal: vec3f, ratio: f32) -> vec3f {
    let v = normalize_or(vector, vec3f(0.0));
    let n = normalize_or(normal, vec3f(0.0));
    let eta = clamp(finite_or(ratio, 0.0), 0.0, 1e6);
    let along = dot(n, v);
    let left = 1.0 - eta * eta * (1.0 - along * along);
    let bent = eta * v - (eta * along + sqrt(max(left, 0.0))) * n;
    return normalize_or(select(bent, v - 2.0 * along * n, left < 0.0), v);
}
