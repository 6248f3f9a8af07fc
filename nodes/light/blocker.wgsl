import chiaro::types;
import chiaro::filter;

/// Blocker
///
/// Stands in a light's way and casts a drawn shadow: where the way from the surface to the light
/// passes through it, it is dark. A ball, a box, a capsule or a card, which nobody sees.
///
/// @param light "Light" light_name : The light's id.
/// @param direction from=light.direction hidden
/// @param light_position from=light.position hidden
/// @choice shape "Shape" default=ball ball="Ball" box="Box" capsule="Capsule" card="Card" : What
///   stands in the way.
/// @param center "Center" default=0,1.5,0 : Where it stands, in world space.
/// @param toward "Toward" widget=direction default=0,1,0 : Where its own z axis points: along a
///   capsule, out of a card.
/// @param spin "Spin" unit=rad default=0 : Turns it around that axis.
/// @param size "Size" default=0.3,0.3,0.3 : Half its width, height and depth, in scene units. A
///   capsule is as thick as the first and as long as the last, with its round ends beyond.
/// @param softness "Softness" default=0 min=0 max=4 : How far its edge fades outward, in its own
///   sizes.
/// @param density "Density" default=1 min=0 max=1 : How much it takes away.
/// @param inverted "Invert" default=false : Lets light through where the shape is, and nowhere
///   else.
/// @param share "Share" default=1 min=0 max=1 : What passes the filters before it.
/// @param position "Position" from=position : Where the light arrives.
/// @return share "Share" : How much of the light passes, from 0 to 1.
/// @unit
fn blocker_directional(direction: vec3f, shape: i32, center: vec3f, toward: vec3f, spin: f32,
    size: vec3f, softness: f32, density: f32, inverted: bool, share: f32, position: vec3f) -> f32 {
    let axes = axes_turned(toward, spin);
    let way = LightWay(place_along(position, center, axes),
        1e6 * place_along(direction, vec3f(0.0), axes));
    let m = way_past_shape(way, shape, half_size(size));
    return share_kept(share) * share_beside(m, softness, density, inverted);
}

fn blocker_point(light_position: vec3f, shape: i32, center: vec3f, toward: vec3f, spin: f32,
    size: vec3f, softness: f32, density: f32, inverted: bool, share: f32, position: vec3f) -> f32 {
    let axes = axes_turned(toward, spin);
    let way = LightWay(place_along(position, center, axes),
        place_along(light_position, position, axes));
    let m = way_past_shape(way, shape, half_size(size));
    return share_kept(share) * share_beside(m, softness, density, inverted);
}

fn blocker_spot(light_position: vec3f, shape: i32, center: vec3f, toward: vec3f, spin: f32,
    size: vec3f, softness: f32, density: f32, inverted: bool, share: f32, position: vec3f) -> f32 {
    return blocker_point(light_position, shape, center, toward, spin, size, softness, density,
        inverted, share, position);
}
