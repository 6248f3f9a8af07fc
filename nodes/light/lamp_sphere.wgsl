import chiaro::types;
import chiaro::numeric;
import chiaro::filter;

/// Lamp sphere
///
/// Where a surface lies on the sphere around a lamp, as coordinates for any image or pattern: down
/// from where the lamp points to its back, and around. A directional light has no such sphere, and
/// all lies where it points.
///
/// @param light "Light" light_name : The light's id.
/// @param light_position from=light.position hidden
/// @param aim from=light.aim hidden
/// @param spin "Spin" unit=rad default=0 : Turns the sphere around where the lamp points.
/// @param toward "Toward" widget=direction default=0,-1,0 : Where a point light points; a spot
///   light has a direction of its own.
/// @param position "Position" from=position : Where the light arrives.
/// @return uv "UV" : Around the lamp from 0 to 1, from its right as it looks and upward from there;
///   and from 1 where it points to 0 at its back, each half a step of 256 before the end, so that a
///   picture of 256 rows that repeats does not mix the two.
/// @unit
fn lamp_sphere_directional() -> vec2f {
    return vec2f(0.0, 1.0 - 0.5 * SPHERE_ROW);
}

fn lamp_sphere_point(light_position: vec3f, spin: f32, toward: vec3f, position: vec3f) -> vec2f {
    let seen = place_along(position, light_position, axes_turned(toward, spin));
    // For who looks along z, x is to the left.
    let around = angle_of_point(seen.y, -seen.x) / (2.0 * PI);
    let away = angle_of_point(length(seen.xy), seen.z) / PI;
    return vec2f(select(around, around + 1.0, around < 0.0),
        clamp(1.0 - away, 0.5 * SPHERE_ROW, 1.0 - 0.5 * SPHERE_ROW));
}

fn lamp_sphere_spot(light_position: vec3f, aim: vec3f, spin: f32, position: vec3f) -> vec2f {
    return lamp_sphere_point(light_position, spin, aim, position);
}

/// A row of the pictures that lamp files are read as, as a share of the height.
const SPHERE_ROW: f32 = 1.0 / 256.0;
