import chiaro::types;
import chiaro::total;

/// Greatest of lights
///
/// The greatest of what comes of each light, in a group that runs for each light of a set: many
/// lights never burn out where one does not.
///
/// @param before_greatest default=0 before=greatest : The greatest of the lights before.
/// @param reach default=1 reach : How bright the light arrives; what does not arrive is left out.
/// @param value "Value" default=0 : What comes of one light; a color counts as much as its alpha.
/// @return greatest "Greatest" : Of all lights that arrive, 0 or more, of a color channel by
///   channel; a color is opaque.
fn greatest_of_lights(value: f32, before_greatest: f32, reach: f32) -> f32 {
    return select(before_greatest, max(before_greatest, bounded(value)), reach > 0.0);
}

fn greatest_of_lights_vec3(value: vec3f, before_greatest: vec3f, reach: f32) -> vec3f {
    return select(before_greatest, max(before_greatest, bounded_vec3(value)), reach > 0.0);
}

fn greatest_of_lights_color(value: Color, before_greatest: Color, reach: f32) -> Color {
    let greatest = max(before_greatest.xyz, bounded_vec3(value.xyz * value.w));
    return select(before_greatest, vec4f(greatest, before_greatest.w), reach > 0.0);
}
