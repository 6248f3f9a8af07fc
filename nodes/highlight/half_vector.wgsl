import chiaro::types;
import chiaro::numeric;
import chiaro::surface;

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
///
/// @param light "Light" wire : The highlight's light.
/// @param view from=view hidden
/// @return direction "Direction" : Unit, world space; across the eye's direction where the light is
///   exactly behind.
/// @source Anjyo and Hiramitsu 2003
fn half_vector(light: Light, view: vec3f) -> vec3f {
    let half = light.direction + view;
    return normalize_or(select(any_orthogonal(view), half, dot(half, half) > 1e-12), view);
}
