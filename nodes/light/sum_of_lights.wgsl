import chiaro::types;
import chiaro::total;

/// Sum of lights
///
/// Adds what comes of each light, in a group that runs for each light of a set. Thresholds before
/// it stand for each light, those behind it after the sum.
///
/// @param before_sum default=0 before=sum : The sum of the lights before.
/// @param reach default=1 reach : How bright the light arrives; what does not arrive is left out.
/// @param value "Value" default=0 : What comes of one light; a color counts as much as its alpha.
/// @return sum "Sum" : Of all lights that arrive; a color is opaque.
fn sum_of_lights(value: f32, before_sum: f32, reach: f32) -> f32 {
    return select(before_sum, bounded(before_sum + value), reach > 0.0);
}

fn sum_of_lights_vec3(value: vec3f, before_sum: vec3f, reach: f32) -> vec3f {
    return select(before_sum, bounded_vec3(before_sum + value), reach > 0.0);
}

fn sum_of_lights_color(value: Color, before_sum: Color, reach: f32) -> Color {
    let sum = vec4f(bounded_vec3(before_sum.xyz + value.xyz * value.w), before_sum.w);
    return select(before_sum, sum, reach > 0.0);
}
