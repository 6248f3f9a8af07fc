import chiaro::types;
import chiaro::filter;

/// Barn doors
///
/// Four flaps before a lamp that cut its light off at straight edges. A directional light has none.
///
/// @param light "Light" light_name : The light's id.
/// @param light_position from=light.position hidden
/// @param aim from=light.aim hidden
/// @param left "Left" unit=rad default=pi/8 min=0 max=pi/2 : How far the light goes to the left of
///   where the lamp points, as the lamp sees it.
/// @param right "Right" unit=rad default=pi/8 min=0 max=pi/2 : To the right.
/// @param top "Top" unit=rad default=pi/8 min=0 max=pi/2 : Upward.
/// @param bottom "Bottom" unit=rad default=pi/8 min=0 max=pi/2 : Downward.
/// @param spin "Spin" unit=rad default=0 : Turns the flaps around the lamp.
/// @param softness "Softness" unit=rad default=0 min=0 max=pi/4 : How wide the edges fade.
/// @param toward "Toward" widget=direction default=0,-1,0 : Where a point light's flaps look; a
///   spot light's look where it points.
/// @param share "Share" default=1 min=0 max=1 : What passes the filters before it.
/// @param position "Position" from=position : Where the light arrives.
/// @return share "Share" : How much of the light passes, from 0 to 1.
/// @unit
fn barn_doors_directional(share: f32) -> f32 {
    return share_kept(share);
}

fn barn_doors_point(light_position: vec3f, left: f32, right: f32, top: f32, bottom: f32, spin: f32,
    softness: f32, toward: vec3f, share: f32, position: vec3f) -> f32 {
    let seen = place_along(position, light_position, axes_turned(toward, spin));
    return share_kept(share) * share_of_doors(seen, vec4f(left, right, top, bottom), softness);
}

fn barn_doors_spot(light_position: vec3f, aim: vec3f, left: f32, right: f32, top: f32, bottom: f32,
    spin: f32, softness: f32, share: f32, position: vec3f) -> f32 {
    let seen = place_along(position, light_position, axes_turned(aim, spin));
    return share_kept(share) * share_of_doors(seen, vec4f(left, right, top, bottom), softness);
}
