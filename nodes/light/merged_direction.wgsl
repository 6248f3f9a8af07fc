import chiaro::types;
import chiaro::convert;
import chiaro::numeric;
import chiaro::total;

/// Merged direction
///
/// Adds the lights' directions by weight, in a group that runs for each light of a set: shaded
/// once, with the one light that Light from parts makes of it, a figure has one terminator however
/// many lights there are.
///
/// @param before_direction default=0,0,0 before=direction : Of the lights before.
/// @param before_color default=0,0,0,1 before=color : Of the lights before.
/// @param before_intensity default=0 before=intensity : Of the lights before.
/// @param before_sum default=0,0,0 before=sum : Of the lights before.
/// @param reach default=1 reach : How bright the light arrives; what does not arrive is left out.
/// @param light "Light" wire : One light.
/// @param weight "Weight" default=1 min=0 : How much it counts beside its brightness.
fn merged_direction(light: Light, weight: f32, before_direction: vec3f, before_color: Color,
    before_intensity: f32, before_sum: vec3f, reach: f32) -> MergedDirection {
    let w = clamp(bounded(weight), 0.0, 1e6) * min(light.intensity, 1e6);
    // What an f32 can no longer tell from nothing gives no direction.
    if (reach <= 0.0) | (w < 1e-20) {
        return MergedDirection(before_direction, before_color, before_intensity, before_sum);
    }
    let bright = w * max(luminance(vec4f(light.color, 1.0)), 0.0);
    let sum = before_sum + light.direction * bright;
    let intensity = before_intensity + w;
    let color = mixed_vec4(before_color, vec4f(light.color, 1.0), w / intensity);
    return MergedDirection(normalize_or(sum, light.direction), color, intensity, sum);
}

struct MergedDirection {
    /// Unit, world space, toward where most of the light comes from; 0 where no light arrives.
    direction: vec3f,
    /// The lights' colors mixed by weight, opaque.
    color: Color,
    /// The lights' intensities times their weights, together.
    intensity: f32,
    /// The lights' directions times how bright each is, together.
    sum: vec3f,
}
