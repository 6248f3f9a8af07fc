import chiaro::types;
import chiaro::light;

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
///
/// @param light "Light" wire : The layer's light.
/// @param color "Color" default=1,1,1,1 : The layer's color, straight.
/// @param tone "Tone" default=1 : The layer's tone.
/// @bound color
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = light_split(light.intensity);
    return LitLayer(vec4f(color.xyz * light.color * split.y, color.w), tone * split.x);
}

struct LitLayer {
    /// The color under this light.
    color: Color,
    /// The tone under this light.
    tone: f32,
}
