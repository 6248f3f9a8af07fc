import chiaro::types;
import chiaro::numeric;
import chiaro::total;

/// Cool to warm
///
/// Technical illustration's shading: from a cool color on the far side to a warm one toward the
/// light, so that outlines and highlights, which are darker and lighter, stay readable everywhere.
///
/// @param light "Light" wire : Toward the warm side.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param color "Color" default=0.8,0.3,0.2,1 : The object's own color; its alpha stays.
/// @param cool "Cool" default=0,0,0.55,1 : What it is mixed toward on the far side.
/// @param warm "Warm" default=0.3,0.3,0,1 : What it is mixed toward on the light's side.
/// @param cool_amount "Own color, cool" default=0.25 min=0 max=1 : How much of the own color is
///   added to the cool one.
/// @param warm_amount "Own color, warm" default=0.5 min=0 max=1 : How much of the own color is
///   added to the warm one.
/// @return color "Color" : Straight RGBA.
/// @source Gooch et al. 1998
fn gooch(
    light: Light,
    normal: vec3f,
    color: Color,
    cool: Color,
    warm: Color,
    cool_amount: f32,
    warm_amount: f32,
) -> Color {
    let t = 0.5 + 0.5 * dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
    let own = bounded_vec3(color.xyz);
    let far = bounded_vec3(cool.xyz + factor_of(cool_amount, true) * own);
    let near = bounded_vec3(warm.xyz + factor_of(warm_amount, true) * own);
    return vec4f(mixed_vec3(far, near, clamp(t, 0.0, 1.0)), bounded(color.w));
}
