import chiaro::numeric;

/// Facing ratio
///
/// 1 where the surface faces the eye, 0 at its rim: for rim light, outlines, dusty cloth and candy
/// edges.
///
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @return facing "Facing" : n . v, 0 where the normal points away.
/// @unit
/// @error balanced 1e-6 : for normals between 1e-15 and 1e18 long; others count as having none
fn facing(normal: vec3f, view: vec3f) -> f32 {
    return clamp(dot(normalize_or(normal, vec3f(0.0)), view), 0.0, 1.0);
}

fn facing_balanced(normal: vec3f, view: vec3f) -> f32 {
    return clamp(dot(normalize_quick(normal, vec3f(0.0)), view), 0.0, 1.0);
}
