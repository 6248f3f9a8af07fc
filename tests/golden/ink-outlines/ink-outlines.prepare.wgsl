// Ink outlines: made by Chiaro 0.1.0, WGSL.
// What turns parameters and lights into the `Look` uniform of the module `draw`,
// called before drawing by the steps of `host` in the JSON file. Run it or port it.

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    direction: vec3f,
    /// Unit, toward the light, in the light's own frame.
    own_direction: vec3f,
    /// Straight RGB.
    color: vec3f,
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    intensity: f32,
}

/// Light
///
/// A light of the look, as it arrives at the surface. Its data (type, direction, color) is kept
/// with the look's lights; turning the illumination frame turns every light in it.
fn light_directional(direction: vec3f, own_direction: vec3f, color: vec3f,
    intensity: f32) -> Light {
    return Light(direction, own_direction, color, intensity);
}
