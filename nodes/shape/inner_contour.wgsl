import chiaro::numeric;
import chiaro::total;
import chiaro::antialias;
import chiaro::curvature;
import chiaro::shape;

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
///
/// @choice lines "Lines" default=suggestive suggestive="Suggestive" valleys="Valleys"
///   ridges="Ridges" : Suggestive lines are those that become outlines when the eye moves a little;
///   Valleys lie where the surface is hollow, Ridges where it bulges.
/// @param width "Width" default=3 min=0 max=40 : Suggestive: in thousandths of the picture's
///   height.
/// @param limit "Limit" default=20 min=0 max=200 : Weaker ones are left out; a curvature in
///   1/viewport-height.
/// @param softness "Softness" default=0.5 min=0 max=1 : How gradually weak ones fade.
/// @param tensor "Curvature tensor" from=curvature_tensor : xx, xy and yy in camera axes, in
///   1/viewport-height.
/// @param normal from=normal hidden
/// @param view from=view hidden
/// @param camera_from_world from=camera_from_world hidden
/// @param place from=position_camera hidden
/// @param viewport from=viewport hidden
/// @return line "Line" : 1 on a line, 0 elsewhere.
/// @unit
/// @error fast 1 : where a line is drawn or not, which follows triangles and creases more closely;
///   no pass is needed
/// @source DeCarlo et al. 2003
fn inner_contour_suggestive(
    width: f32,
    limit: f32,
    softness: f32,
    tensor: vec3f,
    normal: vec3f,
    view: vec3f,
    camera_from_world: mat3x3f,
    place: vec3f,
    viewport: vec2f,
) -> f32 {
    let n = camera_from_world * normal;
    let h = tensor_safe(tensor);
    let square = dot(n.xy, n.xy);
    // The curvature in the direction in which the surface leaves the line of sight; it is 0 along
    // these lines.
    let radial = (h.x * n.x * n.x + 2.0 * h.y * n.x * n.y + h.z * n.y * n.y) / max(square, 1e-6);
    let change = vec2f(dpdx(radial), dpdy(radial));
    // `up` is 1 where the next row of pixels is farther up in the picture, -1 where it is farther
    // down.
    let v = camera_from_world * view;
    let row = dpdy(place);
    let up = select(-1.0, 1.0, (row - dot(row, v) * v).y >= 0.0);
    let height = clamp(viewport.y, 1.0, 1e5);
    let toward_eye = -(change.x * n.x + up * change.y * n.y) * inverseSqrt(max(square, 1e-6));
    let pixels = 0.5 * clamp(bounded(width), 0.0, 1e4) * height / 1000.0;
    let distance = abs(radial) / max(length(change), 1e-6);
    // Over a twentieth of the picture's height the surface is to become as curved as the limit.
    let strength = faded_in(toward_eye * height * 0.05, limit, softness);
    return line_covers(distance, pixels) * strength * seen_well(dot(normal, view));
}

fn inner_contour_valleys(limit: f32, softness: f32, tensor: vec3f, normal: vec3f,
    view: vec3f) -> f32 {
    let least = principal_curvatures(tensor_safe(tensor)).y;
    return faded_in(-least, limit, softness) * seen_well(dot(normal, view));
}

fn inner_contour_ridges(limit: f32, softness: f32, tensor: vec3f, normal: vec3f,
    view: vec3f) -> f32 {
    let greatest = principal_curvatures(tensor_safe(tensor)).x;
    return faded_in(greatest, limit, softness) * seen_well(dot(normal, view));
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
fn faded_in(x: f32, limit: f32, softness: f32) -> f32 {
    let at = max(bounded(limit), 0.0);
    let width = edge_width(footprint_of(x), min(at, 1e9) * factor_of(softness, true));
    return step_filtered(bounded(x), at, width);
}
