import chiaro::types;
import chiaro::filter;

/// Light place
///
/// Where a surface lies in the picture that a light throws, as coordinates for any image or
/// pattern: gobos, window crosses, leaves. A lamp throws it like a projector, a directional light
/// like the sun.
///
/// @param light "Light" light_name : The light's id.
/// @param direction from=light.direction hidden
/// @param light_position from=light.position hidden
/// @param aim from=light.aim hidden
/// @param angle "Angle" unit=rad default=pi/8 min=pi/180 max=pi/2.1 : Half of the picture's height
///   as a lamp sees it.
/// @param size "Size" default=1 min=0.001 max=1000 : Half of the picture's height that a
///   directional light throws, in scene units.
/// @param center "Center" default=0,0,0 : The place that the middle of a directional light's
///   picture falls on, in world space.
/// @param spin "Spin" unit=rad default=0 : Turns the picture.
/// @param toward "Toward" widget=direction default=0,-1,0 : Where a point light throws it; a spot
///   light's goes where it points.
/// @param position "Position" from=position : Where the light arrives.
fn light_place_directional(direction: vec3f, size: f32, center: vec3f, spin: f32,
    position: vec3f) -> PlaceInLight {
    let seen = place_along(position, center, axes_turned(-direction, spin));
    return place_in_light(seen.xy / half_size(vec3f(size)).x);
}

fn light_place_point(light_position: vec3f, angle: f32, spin: f32, toward: vec3f,
    position: vec3f) -> PlaceInLight {
    let seen = place_along(position, light_position, axes_turned(toward, spin));
    let turn = sin_cos_of(clamp(bounded(angle), 0.001, 1.55));
    // Behind the lamp it throws nothing.
    let at = seen.xy * (turn.y / turn.x) / max(seen.z, 1e-3);
    return place_in_light(select(vec2f(FAR_FROM_SHAPE), at, seen.z > 1e-3));
}

fn light_place_spot(light_position: vec3f, aim: vec3f, angle: f32, spin: f32,
    position: vec3f) -> PlaceInLight {
    return light_place_point(light_position, angle, spin, aim, position);
}

struct PlaceInLight {
    /// From 0,0 at the picture's lower left corner to 1,1 at its upper right one, as the light sees
    /// it.
    uv: vec2f,
    /// 1 within the picture, 0 outside of it.
    inside: f32,
}

fn place_in_light(at: vec2f) -> PlaceInLight {
    let near = clamp(at, vec2f(-FAR_FROM_SHAPE), vec2f(FAR_FROM_SHAPE));
    let inside = share_beside(max(abs(near.x), abs(near.y)), 0.0, 1.0, true);
    // For who looks along z, x is to the left.
    return PlaceInLight(0.5 + 0.5 * vec2f(-near.x, near.y), inside);
}
