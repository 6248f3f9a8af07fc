import chiaro::numeric;

/// Facing ratio
///
/// 1 where the surface faces the eye, 0 at its rim: for rim light, outlines, dusty cloth and candy edges.
///
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @return facing "Facing" : n . v, 0 where the normal points away.
/// @unit
fn facing(normal: vec3f, view: vec3f) -> f32 {
    return clamp(dot(normalize_or(normal, vec3f(0.0)), view), 0.0, 1.0);
}
