import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::local;

/// Local light
///
/// Bends a light and changes its strength around a place on the surface, and leaves it as it is
/// elsewhere: light as an artist wants it to fall, where the real one would not.
///
/// @param light "Light" wire : What is changed; chain several of these for several places.
/// @param bend "Bend" default=0,0,0 : Added to the light's direction at the place, world space; 1
///   is as long as that.
/// @param strength "Strength" default=1 min=0 max=4 : The light's intensity is multiplied by this
///   at the place.
/// @param center "Center" default=0,0,1 : The place, in the space of the position.
/// @param radius "Radius" default=0.5 min=0 max=10 : How far it reaches.
/// @param hardness "Hardness" default=0 min=0 max=1 : How much of the radius is full before it
///   falls.
/// @param position "Position" from=position_object : In the object's own space, it goes along with
///   the object.
/// @return light "Light" : As it arrives there.
/// @bypass light when bend = 0 and strength = 1 : it changes neither direction nor strength
/// @source Todo et al. 2007
fn local_light(
    light: Light,
    bend: vec3f,
    strength: f32,
    center: vec3f,
    radius: f32,
    hardness: f32,
    position: vec3f,
) -> Light {
    let weight = near_place(position, center, radius, hardness);
    let bent = light.direction + weight * clamp(bounded_vec3(bend), vec3f(-1e6), vec3f(1e6));
    // The direction of a sum of nearly 0 would be rounding's.
    let direction = select(light.direction, normalize_or(bent, light.direction),
        (dot(bent, bent) > 1e-6) & (weight > 0.0));
    let intensity = light.intensity * mixed(1.0, clamp(bounded(strength), 0.0, 1e6), weight);
    return Light(direction, light.own_direction, light.color, min(intensity, 1e30));
}
