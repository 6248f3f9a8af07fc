import chiaro::types;
import chiaro::numeric;
import chiaro::total;

/// Light from parts
///
/// A light of a direction, a color and an intensity of your own, as any layer takes it.
///
/// @param direction "Direction" widget=direction default=0,0,1 : Toward the light, world space, any
///   length.
/// @param color "Color" default=1,1,1,1 : The light's color; its alpha does not count.
/// @param intensity "Intensity" default=1 min=0 max=10 : A factor on the color.
/// @return light "Light" : From there.
fn light_from_parts(direction: vec3f, color: Color, intensity: f32) -> Light {
    let toward = normalize_or(direction, vec3f(0.0, 0.0, 1.0));
    return Light(toward, toward, bounded_vec3(color.xyz), clamp(bounded(intensity), 0.0, 1e30));
}
