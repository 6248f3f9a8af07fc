import chiaro::types;
import chiaro::total;

/// Layers of lights
///
/// Lays what comes of each light over what came of those before, in the order of the lights, in a
/// group that runs for each light of a set.
///
/// @param before_layers default=0,0,0,0 before=layers : The layers of the lights before.
/// @param reach default=1 reach : How bright the light arrives; what does not arrive is left out.
/// @param color "Color" default=0,0,0,0 : What comes of one light, straight; its alpha is what it
///   covers.
/// @return layers "Layers" : Of all lights that arrive, for a layer's below or over it.
/// @bound color
fn layers_of_lights(color: Color, before_layers: Composite, reach: f32) -> Composite {
    let over = bounded_vec4(vec4f(color.xyz * color.w, color.w) + before_layers * (1.0 - color.w));
    return select(before_layers, over, reach > 0.0);
}
