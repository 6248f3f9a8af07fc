// Ten lights, one edge after the sum: made by Chiaro 0.1.0, WGSL.
// What turns parameters and lights into the `Look` uniform of the module `draw`,
// called before drawing by the steps of `host` in the JSON file. Run it or port it.

/// Straight RGBA.
alias Color = vec4f;

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

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(v);
    let magnitude = bits & vec4u(0x7fffffffu);
    let largest = bitcast<vec4f>((bits & vec4u(0x80000000u)) | vec4u(0x7f7fffffu));
    let numbers = select(vec4f(0.0), largest, magnitude == vec4u(0x7f800000u));
    return select(numbers, v, magnitude < vec4u(0x7f800000u));
}

/// Light
///
/// A light of the look, as it arrives at the surface. Its data (type, direction, color) is kept
/// with the look's lights; turning the illumination frame turns every light in it.
fn light_directional(direction: vec3f, own_direction: vec3f, color: vec3f,
    intensity: f32) -> Light {
    return Light(direction, own_direction, color, intensity);
}

/// Light parts
///
/// Takes a light apart, for shading that the other nodes do not know.
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

fn multiply_color(a: Color, b: Color) -> Color {
    return bounded_vec4(a * b);
}

fn color_from_float(value: f32) -> vec4f {
    return vec4f(vec3f(value), 1.0);
}
