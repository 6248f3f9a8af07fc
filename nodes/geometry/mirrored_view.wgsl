import chiaro::numeric;

/// Mirrored view
///
/// The view direction mirrored at the surface: what a mirror would show. It makes highlights and reflections that move
/// with the eye.
///
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @return mirrored "Mirrored view" : Unit, away from the surface, world space.
/// @source BADF eq. 4
fn mirrored_view(normal: vec3f, view: vec3f) -> vec3f {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    return normalize_or(2.0 * dot(n, view) * n - view, n);
}
