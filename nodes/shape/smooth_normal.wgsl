import chiaro::numeric;

/// Smooth normal
///
/// The surface's normal without its fine detail, as if it had been sanded down: for broad, calm
/// shading of busy models, or to hold detail against. Nothing is mixed across outlines or from one
/// object to another.
///
/// @choice scale "Scale" default=medium fine="Fine" small="Small" medium="Medium" large="Large" :
///   Over how much of the picture's height it is smoothed: 1/570, 1/250, 1/125 or 1/60.
/// @param normal from=normal hidden
/// @param smooth_1 "Smoothed a little" from=smooth_normal_1 hidden
/// @param smooth_2 "Smoothed" from=smooth_normal_2 hidden
/// @param smooth_3 "Smoothed more" from=smooth_normal_3 hidden
/// @param smooth_4 "Smoothed most" from=smooth_normal_4 hidden
/// @return normal "Normal" : Unit, world space.
/// @source Rusinkiewicz et al. 2006
fn smooth_normal_fine(normal: vec3f, smooth_1: vec3f) -> vec3f {
    return normalize_or(smooth_1, normal);
}

fn smooth_normal_small(normal: vec3f, smooth_2: vec3f) -> vec3f {
    return normalize_or(smooth_2, normal);
}

fn smooth_normal_medium(normal: vec3f, smooth_3: vec3f) -> vec3f {
    return normalize_or(smooth_3, normal);
}

fn smooth_normal_large(normal: vec3f, smooth_4: vec3f) -> vec3f {
    return normalize_or(smooth_4, normal);
}
