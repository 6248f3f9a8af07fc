import chiaro::numeric;

/// Camera-space normal
///
/// The normal in the picture's own axes: x to the right, y up, z toward the viewer. Shading made
/// from it stays with the camera while the object turns.
///
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param camera_from_world from=camera_from_world hidden
/// @return normal "Camera normal" : Unit.
/// @error balanced 1e-6 : each component, for normals between 1e-15 and 1e18 long; others count as
///   having none
fn camera_normal(normal: vec3f, camera_from_world: mat3x3f) -> vec3f {
    return normalize_or(camera_from_world * normalize_or(normal, vec3f(0.0)), vec3f(0.0, 0.0, 1.0));
}

fn camera_normal_balanced(normal: vec3f, camera_from_world: mat3x3f) -> vec3f {
    return normalize_quick(camera_from_world * normal, vec3f(0.0, 0.0, 1.0));
}
