import chiaro::types;
import chiaro::filter;

/// Distance ramp
///
/// Lets light begin and end where an artist wants it to, by its way from the lamp. A directional
/// light comes from everywhere and passes whole.
///
/// @param light "Light" light_name : The light's id.
/// @param light_position from=light.position hidden
/// @param near_from "Near from" default=0 min=0 max=100 : Nothing arrives up to here.
/// @param near_to "Near to" default=0 min=0 max=100 : All of it arrives from here on.
/// @param far_from "Far from" default=2 min=0 max=100 : All of it arrives up to here.
/// @param far_to "Far to" default=4 min=0 max=100 : Nothing arrives from here on.
/// @param share "Share" default=1 min=0 max=1 : What passes the filters before it.
/// @param position "Position" from=position : Where the light arrives.
/// @return share "Share" : How much of the light passes, from 0 to 1.
/// @unit
fn distance_ramp_directional(share: f32) -> f32 {
    return share_kept(share);
}

fn distance_ramp_point(light_position: vec3f, near_from: f32, near_to: f32, far_from: f32,
    far_to: f32, share: f32, position: vec3f) -> f32 {
    let distance = lamp_distance(light_position, position);
    let near = vec2f(bounded(near_from), max(bounded(near_from), bounded(near_to)));
    let far = vec2f(bounded(far_from), max(bounded(far_from), bounded(far_to)));
    return share_kept(share) * eased(distance, near.x, near.y)
        * (1.0 - eased(distance, far.x, far.y));
}

fn distance_ramp_spot(light_position: vec3f, near_from: f32, near_to: f32, far_from: f32,
    far_to: f32, share: f32, position: vec3f) -> f32 {
    return distance_ramp_point(light_position, near_from, near_to, far_from, far_to, share,
        position);
}
