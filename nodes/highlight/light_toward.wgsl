import chiaro::types;
import chiaro::numeric;

/// Light toward
///
/// A light as it is, but from another direction: bend a light's direction with the nodes beside
/// this one, lock it to the eye or to the surface, and every layer takes it as any other light.
///
/// @param light "Light" wire : Its color and intensity stay, and so does its direction for
///   Screen-aligned layers.
/// @param direction "Direction" default=0,0,0 : Toward the light, world space, any length; without
///   one it stays.
/// @return light "Light" : From there.
/// @source Anjyo et al. 2006
fn light_toward(light: Light, direction: vec3f) -> Light {
    return Light(normalize_or(direction, light.direction), light.own_direction, light.color,
        light.intensity);
}
