import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::material;

/// Detail
///
/// The second coordinate of a two-dimensional tone ramp: how much detail a place deserves, by its
/// distance, its focus or how it faces the eye. Into Tone map it makes shading calmer far away, or
/// at silhouettes.
///
/// @choice by "By" default=depth depth="Distance" focus="Focus" place="Place"
///   orientation="Orientation" highlight="Highlight" : Distance falls from Near to Far; Focus falls
///   on both sides of Near until it is that many times nearer or farther as Far is; Place falls
///   from Near to Far around a point; Orientation is 1 where the surface faces the eye, Highlight
///   where it mirrors a light to it.
/// @param near "Near" default=2 min=0 : In scene units; the detail is 1 from here on inward.
/// @param far "Far" default=8 min=0 : In scene units; the detail is 0 from here on.
/// @param power "Power" default=1 min=0 max=16 : Orientation and Highlight: how fast it falls.
/// @param center "Center" default=0,0,0 : Place: the point, world space.
/// @param light "Light" wire : Highlight: which one.
/// @param depth from=depth hidden
/// @param position from=position hidden
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @return detail "Detail" : From 0 to 1, by the logarithm of distances, as eyes judge them.
/// @unit
/// @source Barla et al. 2006
fn detail_depth(near: f32, far: f32, depth: f32) -> f32 {
    let place = place_between(logarithm_of(depth), logarithm_of(near), logarithm_of(far));
    return 1.0 - clamp(place, 0.0, 1.0);
}

fn detail_focus(near: f32, far: f32, depth: f32) -> f32 {
    let off = abs(logarithm_of(depth) - logarithm_of(near));
    let reach = abs(logarithm_of(far) - logarithm_of(near));
    return 1.0 - clamp(place_between(off, 0.0, reach), 0.0, 1.0);
}

fn detail_place(near: f32, far: f32, center: vec3f, position: vec3f) -> f32 {
    return detail_depth(near, far, length_of(position - bounded_vec3(center)));
}

fn detail_highlight(power: f32, light: Light, normal: vec3f, view: vec3f) -> f32 {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let mirrored = normalize_or(2.0 * dot(n, view) * n - view, n);
    let cosine = max(dot(mirrored, light.direction), 0.0);
    return min(cosine_power(cosine, sine_squared(mirrored, light.direction),
        clamp(bounded(power), 0.0, 1e3)), 1.0);
}

fn detail_orientation(power: f32, normal: vec3f, view: vec3f) -> f32 {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    return min(cosine_power(abs(dot(n, view)), sine_squared(n, view),
        clamp(bounded(power), 0.0, 1e3)), 1.0);
}
