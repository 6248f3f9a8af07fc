import chiaro::types;
import chiaro::total;

/// Mix of lights
///
/// The mean of what comes of each light by weight, in a group that runs for each light of a set: as
/// bright as one light, however many there are.
///
/// @param before_mix default=0,0,0,1 before=mix : The mix of the lights before.
/// @param before_weights default=0 before=weights : Their weights together.
/// @param reach default=1 reach : How bright the light arrives; what does not arrive is left out.
/// @param color "Color" default=0,0,0,1 : What comes of one light.
/// @param weight "Weight" default=1 min=0 : How much it counts.
fn mix_of_lights(color: Color, weight: f32, before_mix: Color, before_weights: f32,
    reach: f32) -> LightMix {
    let w = clamp(bounded(weight), 0.0, 1e18);
    let weights = min(before_weights + w, 1e30);
    if (reach <= 0.0) | (w <= 0.0) {
        return LightMix(before_mix, before_weights);
    }
    return LightMix(mixed_vec4(before_mix, bounded_vec4(color), w / weights), weights);
}

struct LightMix {
    /// Of all lights that arrive; black where none does.
    mix: Color,
    /// Sum of the weights.
    weights: f32,
}
