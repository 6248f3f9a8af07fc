import chiaro::types;

/// Light parts
///
/// Takes a light apart, for shading that the other nodes do not know.
///
/// @param light "Light" wire : The light as it arrives at the surface.
fn light_parts(light: Light) -> LightParts {
    return LightParts(light.direction, vec4f(light.color, 1.0), light.intensity);
}

struct LightParts {
    /// Unit, toward the light, world space.
    direction: vec3f,
    /// The light's color, opaque.
    color: Color,
    /// With the light's distance and cone attenuation; 0 or more.
    intensity: f32,
}
