import chiaro::numeric;
import chiaro::total;
import chiaro::material;

/// Fresnel
///
/// More toward the rim, as glass, water and lacquer reflect: Schlick's approximation.
///
/// @param at_normal "Straight on" default=0.04 min=0 max=1 : What is reflected where the surface
///   faces the eye.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @return amount "Amount" : Up to 1, at the rim.
/// @unit
/// @source Schlick 1994
fn fresnel(at_normal: f32, normal: vec3f, view: vec3f) -> f32 {
    let cosine = clamp(dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view), 0.0, 1.0);
    return schlick(factor_of(at_normal, true), cosine);
}
