import chiaro::numeric;

/// Mirrored view
///
/// The view direction mirrored at the surface: what a mirror would show. It makes highlights and
/// reflections that move with the eye.
///
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @return mirrored "Mirrored view" : Unit, away from the surface, world space.
/// @error balanced 1e-6 : each component, for normals between 1e-15 and 1e18 long; others count as
///   having none
/// @source BADF eq. 4
fn mirrored_view(normal: vec3f, view: vec3f) -> vec3f {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    return normalize_or(2.0 * dot(n, view) * n - view, n);
}

fn mirrored_view_balanced(normal: vec3f, view: vec3f) -> vec3f {
    let n = normalize_quick(normal, vec3f(0.0, 0.0, 1.0));
    return 2.0 * dot(n, view) * n - view;
}
