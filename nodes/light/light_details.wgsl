import chiaro::types;
import chiaro::light;
import chiaro::numeric;
import chiaro::total;

/// Light details
///
/// All that is known of a light where it arrives, on wires of their own. In a group that runs for
/// each light of a set, that light.
///
/// @param light "Light" light_name : The light's id.
/// @param direction from=light.direction hidden
/// @param light_position from=light.position hidden
/// @param aim from=light.aim hidden
/// @param color from=light.color hidden
/// @param intensity from=light.intensity hidden
/// @param cone from=light.cone hidden
/// @param fading from=light.fading hidden
/// @param index default=0 index : Number of the light.
/// @param count default=1 count : Number of all lights.
/// @param position "Position" from=position : Where the light arrives; point and spot lights only.
fn light_details_directional(direction: vec3f, color: vec3f, intensity: f32, index: f32,
    count: f32) -> LightDetails {
    return LightDetails(direction, vec4f(color, 1.0), intensity, 0.0, 1.0, 1.0, index, count,
        intensity);
}

fn light_details_point(light_position: vec3f, color: vec3f, intensity: f32, fading: vec2f,
    index: f32, count: f32, position: vec3f) -> LightDetails {
    let offset = light_position - position;
    let distance = length_of(offset);
    let falloff = light_fading(distance, fading);
    return LightDetails(normalize_or(offset, vec3f(0.0, 0.0, 1.0)), vec4f(color, 1.0), intensity,
        distance, falloff, 1.0, index, count, intensity * falloff);
}

fn light_details_spot(light_position: vec3f, aim: vec3f, color: vec3f, intensity: f32, cone: vec2f,
    fading: vec2f, index: f32, count: f32, position: vec3f) -> LightDetails {
    let offset = light_position - position;
    let direction = normalize_or(offset, vec3f(0.0, 0.0, 1.0));
    let distance = length_of(offset);
    let falloff = light_fading(distance, fading);
    let within = light_cone(dot(-direction, aim), cone);
    return LightDetails(direction, vec4f(color, 1.0), intensity, distance, falloff, within, index,
        count, intensity * falloff * within);
}

struct LightDetails {
    /// Unit, toward the light, world space.
    direction: vec3f,
    /// The light's color, opaque.
    color: Color,
    /// The light's intensity, before distance and cone; 0 or more.
    energy: f32,
    /// From the surface to the light, in scene units; 0 for directional lights.
    distance: f32,
    /// What the distance leaves of the light, 0 to 1.
    falloff: f32,
    /// What the cone of a spot light leaves of it, 0 to 1.
    cone: f32,
    /// Number of the light among those that the group runs for, from 0.
    index: f32,
    /// Number of those lights.
    count: f32,
    /// What arrives of the light: energy, fall-off and cone together.
    reach: f32,
}
