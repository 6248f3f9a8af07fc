import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::shape;

/// Exaggerated shading
///
/// Shows detail of every size in every light, as makers of maps and technical illustrators do: at
/// each scale the light comes from where it rakes along the surface.
///
/// @choice scales "Scales" default=four two="Two" three="Three" four="Four" :
///   How many sizes of detail are told apart; each one more costs a pass over the picture.
/// @param light "Light" wire : Its direction counts, not its color.
/// @param normal "Normal" from=normal : World space; any length but 0. Detail is what it has beyond
///   the smooth ones.
/// @param contrast "Contrast" default=6 min=0 max=20 : How steep the shading of each scale is.
/// @param detail "Detail" default=0.5 min=-2 max=2 : Above 0 fine detail counts more, below 0 large
///   shapes do.
/// @param smooth_1 "Smooth normal 1" from=smooth_normal_1 : World space; any length but 0.
/// @param smooth_2 "Smooth normal 2" from=smooth_normal_2 : A smoother one.
/// @param smooth_3 "Smooth normal 3" from=smooth_normal_3 : A smoother one still.
/// @param smooth_4 "Smooth normal 4" from=smooth_normal_4 : The smoothest.
/// @return tone "Tone" : From 0 to 1; 0.5 where light rakes along all of it.
/// @unit
/// @source Rusinkiewicz et al. 2006
fn exaggerated_two(
    light: Light,
    normal: vec3f,
    contrast: f32,
    detail: f32,
    smooth_1: vec3f,
    smooth_2: vec3f,
) -> f32 {
    let a = clamp(bounded(contrast), 0.0, 50.0);
    let r = exp2_stable(-clamp(bounded(detail), -8.0, 8.0));
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let n1 = normalize_or(smooth_1, n);
    let n2 = normalize_or(smooth_2, n1);
    let l = light.direction;
    let sum = detail_lit(n, n1, l, a) + r * (detail_lit(n1, n2, l, a) + r * dot(n2, l));
    return clamp(0.5 + 0.5 * sum / (1.0 + r * (1.0 + r)), 0.0, 1.0);
}

fn exaggerated_three(
    light: Light,
    normal: vec3f,
    contrast: f32,
    detail: f32,
    smooth_1: vec3f,
    smooth_2: vec3f,
    smooth_3: vec3f,
) -> f32 {
    let a = clamp(bounded(contrast), 0.0, 50.0);
    let r = exp2_stable(-clamp(bounded(detail), -8.0, 8.0));
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let n1 = normalize_or(smooth_1, n);
    let n2 = normalize_or(smooth_2, n1);
    let n3 = normalize_or(smooth_3, n2);
    let l = light.direction;
    let coarse = detail_lit(n2, n3, l, a) + r * dot(n3, l);
    let sum = detail_lit(n, n1, l, a) + r * (detail_lit(n1, n2, l, a) + r * coarse);
    return clamp(0.5 + 0.5 * sum / (1.0 + r * (1.0 + r * (1.0 + r))), 0.0, 1.0);
}

fn exaggerated_four(
    light: Light,
    normal: vec3f,
    contrast: f32,
    detail: f32,
    smooth_1: vec3f,
    smooth_2: vec3f,
    smooth_3: vec3f,
    smooth_4: vec3f,
) -> f32 {
    let a = clamp(bounded(contrast), 0.0, 50.0);
    let r = exp2_stable(-clamp(bounded(detail), -8.0, 8.0));
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let n1 = normalize_or(smooth_1, n);
    let n2 = normalize_or(smooth_2, n1);
    let n3 = normalize_or(smooth_3, n2);
    let n4 = normalize_or(smooth_4, n3);
    let l = light.direction;
    let coarse = detail_lit(n2, n3, l, a) + r * (detail_lit(n3, n4, l, a) + r * dot(n4, l));
    let sum = detail_lit(n, n1, l, a) + r * (detail_lit(n1, n2, l, a) + r * coarse);
    return clamp(0.5 + 0.5 * sum / (1.0 + r * (1.0 + r * (1.0 + r * (1.0 + r)))), 0.0, 1.0);
}
