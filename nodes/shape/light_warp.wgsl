import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::curvature;
import chiaro::shape;

/// Warp light
///
/// Bends a light over the surface's shape: bumps and ridges draw it toward themselves, hollows push
/// it away, so that every layer it lights shows more of the form. Flat places see it as it is, and
/// so does the outline.
///
/// @param light "Light" wire : Its color and intensity stay, and so does its direction for
///   Screen-aligned layers.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param amount "Amount" default=1 min=0 max=4 : By how many halvings of its distance from the
///   normal the light is drawn at most; below 0 hollows draw it.
/// @param slope "Slope" default=0.03 min=0 max=1 : How soon the surface counts as curved.
/// @param tensor "Curvature tensor" from=curvature_tensor : xx, xy and yy in camera axes, in
///   1/viewport-height.
/// @param view from=view hidden
/// @param camera_from_world from=camera_from_world hidden
/// @return light "Light" : From there.
/// @bypass light when amount = 0 : its amount is 0
/// @bypass light when slope = 0 : its slope is 0, so that nothing counts as curved
/// @error fast 0.1 : of the direction, where the surface is smooth, of triangles of a pixel or so;
///   large triangles and creases show, and no pass is needed
/// @source Vergne et al. 2009
fn light_warp(
    light: Light,
    normal: vec3f,
    amount: f32,
    slope: f32,
    tensor: vec3f,
    view: vec3f,
    camera_from_world: mat3x3f,
) -> Light {
    let n = normalize_or(normal, view);
    let most = clamp(bounded(amount), -8.0, 8.0) * seen_well(dot(n, view));
    let warped = warped_light(light.direction, n, view, camera_from_world, tensor_safe(tensor),
        most, slope);
    let is_flat = (most == 0.0) | (slope == 0.0);
    return Light(select(warped, light.direction, is_flat), light.own_direction, light.color,
        light.intensity);
}
