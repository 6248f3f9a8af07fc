import chiaro::types;
import chiaro::numeric;
import chiaro::surface;
import chiaro::total;

/// Light by tone
///
/// Moves a light between the horizon and the normal by a tone: bright looks straight down, dark
/// grazes. A painted surface (HCBTF) with other strokes for lower lights then shows those where
/// several lights, a shadow or an ambient term leave it darker, in place of dimming the strokes
/// that are there.
///
/// @param light "Light" wire : Where around the normal the result stands; its own height does not
///   matter.
/// @param tone "Tone" default=1 min=0 max=1 : 1 is straight above, 0 just above the horizon, as
///   Lambert's cosine.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @return light "Light" : With the light's color and intensity.
/// @source thesis 12
fn light_by_tone(light: Light, tone: f32, normal: vec3f) -> Light {
    let frame = world_from_tangent(light.direction, vec3f(0.0), normal);
    // The light never lies quite on the horizon, where rounding would put some of the surface into
    // the dark.
    let height = clamp(bounded(tone), 1e-3, 1.0);
    let direction = normalize_or(height * frame[2]
        + sqrt(max(1.0 - height * height, 0.0)) * frame[0], frame[2]);
    return Light(direction, light.own_direction, light.color, light.intensity);
}
