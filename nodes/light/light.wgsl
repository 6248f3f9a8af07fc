import chiaro::types;
import chiaro::light;

/// Light
///
/// A light of the look, as it arrives at the surface. Its data (type, direction, color) is kept
/// with the look's lights; turning the illumination frame turns every light in it.
///
/// @param light "Light" light_name : The light's id.
/// @param direction from=light.direction hidden
/// @param own_direction from=light.own_direction hidden
/// @param light_position from=light.position hidden
/// @param aim from=light.aim hidden
/// @param own_from_world from=light.own_from_world hidden
/// @param color from=light.color hidden
/// @param intensity from=light.intensity hidden
/// @param cone from=light.cone hidden
/// @param fading from=light.fading hidden
/// @param position "Position" from=position : Where the light arrives; point and spot lights only.
/// @return light "Light" : Direction, color and intensity at the surface.
fn light_directional(direction: vec3f, own_direction: vec3f, color: vec3f,
    intensity: f32) -> Light {
    return Light(direction, own_direction, color, intensity);
}

fn light_point(
    light_position: vec3f,
    own_from_world: mat3x3f,
    color: vec3f,
    intensity: f32,
    fading: vec2f,
    position: vec3f,
) -> Light {
    return light_at(light_position, own_from_world, color, intensity, fading, position);
}

fn light_spot(
    light_position: vec3f,
    aim: vec3f,
    own_from_world: mat3x3f,
    color: vec3f,
    intensity: f32,
    cone: vec2f,
    fading: vec2f,
    position: vec3f,
) -> Light {
    var light = light_at(light_position, own_from_world, color, intensity, fading, position);
    light.intensity *= light_cone(dot(-light.direction, aim), cone);
    return light;
}
