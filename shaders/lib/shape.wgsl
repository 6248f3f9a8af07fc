// Shape shown by bending light: exaggerated shading (Rusinkiewicz et al. 2006), light warping and
// radiance scaling (Vergne et al. 2009, 2010), and contours.
import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::curvature;

/// Shading of the detail that a finer normal has beyond a coarser one: -1 where the finer turns
/// from the light, 1 where it turns toward the light. The light is laid at the coarser normal's
/// horizon, so that detail is lit as well as can be, however the light falls.
fn detail_lit(finer: vec3f, coarser: vec3f, light: vec3f, contrast: f32) -> f32 {
    let across = light - dot(light, coarser) * coarser;
    // Straight under the light there is no direction along the surface, and detail fades.
    let toward = across / max(length(across), 0.05);
    return clamp(contrast * dot(finer, toward), -1.0, 1.0);
}

/// `place` times the symmetric matrix (xx, xy, yy) in which each principal curvature k of the
/// tensor has become 2^(-amount tanh(slope k)).
fn warped_place(tensor: vec3f, place: vec2f, amount: f32, slope: f32) -> vec2f {
    let k = principal_curvatures(tensor);
    let most = exp2_stable(-amount * curvature_signed(k.x, slope));
    let least = exp2_stable(-amount * curvature_signed(k.y, slope));
    let half_apart = vec2f(0.5 * (tensor.x - tensor.z), tensor.y);
    // The principal axes are found without an angle; where both curvatures are the same any axes
    // will do.
    let axes = half_apart / max(length(half_apart), 1e-20);
    let turned = vec2f(axes.x * place.x + axes.y * place.y, axes.y * place.x - axes.x * place.y);
    return 0.5 * (most + least) * place + 0.5 * (most - least) * turned;
}

/// The light's direction after light warping: its stereographic projection from the point opposite
/// the normal is drawn nearer along convex directions and away along concave ones.
fn warped_light(light: vec3f, n: vec3f, view: vec3f, camera_from_world: mat3x3f, tensor: vec3f,
    amount: f32, slope: f32) -> vec3f {
    // The picture's axes, at right angles to the line of sight, and then tilted as the surface is.
    let right = vec3f(1.0, 0.0, 0.0) * camera_from_world;
    let x = normalize_or(right - dot(right, view) * view, vec3f(1.0, 0.0, 0.0));
    let y = cross(view, x);
    let between = (view + n) / max(1.0 + dot(view, n), 0.01);
    let along_x = x - dot(n, x) * between;
    let along_y = y - dot(n, y) * between;
    let place = vec2f(dot(light, along_x), dot(light, along_y)) / max(1.0 + dot(light, n), 1e-4);
    let q = warped_place(tensor, place, amount, slope);
    let square = dot(q, q);
    return normalize_or(2.0 * q.x * along_x + 2.0 * q.y * along_y + (1.0 - square) * n, light);
}

/// A tone from 0 to 1 scaled by e^curved where it is dark and by e^-curved where it is light; the
/// tone `turning` stays.
fn radiance_scaled(tone: f32, curved: f32, turning: f32) -> f32 {
    let e = exponential_of(curved);
    let dark = turning * (1.0 - tone);
    let light = tone * (1.0 - turning);
    return tone * (e * dark + light) / max(dark + e * light, 1e-20);
}

/// Share of a pixel that a line covers which is `width` pixels wide and `distance` pixels away.
fn line_covers(distance: f32, width: f32) -> f32 {
    return clamp(width + 0.5 - distance, 0.0, min(width, 1.0));
}

/// Trust in curvature on the screen: 0 at the outline, where curvature has no bound and no digits,
/// 1 where the surface is seen well.
fn seen_well(facing: f32) -> f32 {
    return eased(facing, 0.05, 0.3);
}
