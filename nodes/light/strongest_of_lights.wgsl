import chiaro::types;
import chiaro::total;

/// Strongest of lights
///
/// What comes of the strongest light, in a group that runs for each light of a set. Lights that are
/// nearly as strong as the strongest are mixed in, so that nothing flickers where one takes over
/// from another.
///
/// @param before_color default=0,0,0,1 before=color : Of the lights before.
/// @param before_strength default=0 before=strength : The greatest strength of the lights before.
/// @param before_weights default=0 before=weights : Their weights together.
/// @param reach default=1 reach : How bright the light arrives; what does not arrive is left out.
/// @param color "Color" default=0,0,0,1 : What comes of one light.
/// @param strength "Strength" default=1 min=0 max=1000 : How strong the light is here.
/// @param margin "Margin" default=0.1 min=0.01 max=1 : A light weaker by this counts 1/256.
fn strongest_of_lights(color: Color, strength: f32, margin: f32, before_color: Color,
    before_strength: f32, before_weights: f32, reach: f32) -> StrongestLight {
    if reach <= 0.0 {
        return StrongestLight(before_color, before_strength, before_weights);
    }
    let s = clamp(bounded(strength), 0.0, 1e6);
    let steepness = 8.0 / clamp(bounded(margin), 0.01, 1e6);
    // Weights are relative to the strongest light so far, so that none of them overflows.
    let strongest = max(before_strength, s);
    let before = before_weights * exp2(max((before_strength - strongest) * steepness, -100.0));
    let own = exp2(max((s - strongest) * steepness, -100.0));
    let weights = before + own;
    return StrongestLight(mixed_vec4(before_color, bounded_vec4(color), own / weights), strongest,
        weights);
}

struct StrongestLight {
    /// Of the strongest lights that arrive; black where none does.
    color: Color,
    /// Strength of the strongest light.
    strength: f32,
    /// Weights of all lights, where the strongest has 1.
    weights: f32,
}
