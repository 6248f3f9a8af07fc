import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::antialias;

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
///
/// @param light "Light" wire : The side.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @param width "Width" default=0.35 min=0 max=1 : How far it reaches in from the silhouette: 1 is
///   to the middle.
/// @param softness "Softness" default=0.5 min=0 max=1 : 0 is flat with a hard edge, 1 fades all the
///   way.
/// @param follow "Follow the light" default=1 min=0 max=1 : 0 runs all around, 1 only on the
///   light's side.
/// @return tone "Tone" : From 0 to 1.
/// @unit
/// @source Mitchell et al. 2007, rim lights of illustrative rendering
fn rim(light: Light, normal: vec3f, view: vec3f, width: f32, softness: f32, follow: f32) -> f32 {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let facing = clamp(dot(n, view), 0.0, 1.0);
    let reach = factor_of(width, true);
    // The edge is as wide as softness wants, but never narrower than a pixel.
    let edge = max(reach * factor_of(softness, true), min(footprint_of(facing), 1.0));
    // Where the normal is nearly straight at the eye a cosine has no digits left, and the vectors'
    // difference has them.
    let aside = n - view;
    let further = select(reach - facing, 0.5 * dot(aside, aside) - (1.0 - reach), facing > 0.5);
    let within = further / max(edge, 1e-6) + select(0.5, 0.0, softness > 0.0);
    let inside = select(clamp(within, 0.0, 1.0), 0.0, reach <= 0.0);
    // `across` is the light's direction across the eye's: from the far side of the object (-1) to
    // the near one (1).
    let across = light.direction - dot(light.direction, view) * view;
    // Only the normal's part across the eye's direction counts, too: where the light is nearly
    // behind, rounding leaves a little of that direction in `across`.
    let side = dot(n - dot(n, view) * view, normalize_or(across, vec3f(0.0)));
    return inside * mixed(1.0, eased(side, 0.0, 0.5), factor_of(follow, true));
}
