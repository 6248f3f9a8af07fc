import chiaro::types;
import chiaro::filter;

/// Decay
///
/// Weakens a lamp's light with the distance, by a power: 2 as nature does, 1 gentler, 0 not at all.
/// Up to the start it passes whole. A directional light does not decay.
///
/// @param light "Light" light_name : The light's id.
/// @param light_position from=light.position hidden
/// @param start "Start" default=1 min=0.001 max=100 : Up to here all of it passes, in scene units.
/// @param power "Power" default=2 min=0 max=8 : How fast it weakens from there.
/// @param share "Share" default=1 min=0 max=1 : What passes the filters before it.
/// @param position "Position" from=position : Where the light arrives.
/// @return share "Share" : How much of the light passes, from 0 to 1.
/// @unit
fn decay_directional(share: f32) -> f32 {
    return share_kept(share);
}

fn decay_point(light_position: vec3f, start: f32, power: f32, share: f32, position: vec3f) -> f32 {
    let near = clamp(bounded(start), 0.001, 1e6);
    let farther = near / max(lamp_distance(light_position, position), near);
    return share_kept(share) * min(powered(farther, clamp(bounded(power), 0.0, 64.0)), 1.0);
}

fn decay_spot(light_position: vec3f, start: f32, power: f32, share: f32, position: vec3f) -> f32 {
    return decay_point(light_position, start, power, share, position);
}
