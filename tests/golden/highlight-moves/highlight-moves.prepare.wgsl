// A highlight, moved: made by Chiaro 0.1.0, WGSL.
// What turns parameters and lights into the `Look` uniform of the module `draw`,
// called before drawing by the steps of `host` in the JSON file. Run it or port it.

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

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

/// A share (an opacity, a mask) clamped to [0, 1]: beyond, a mix would go past what it mixes.
fn unit_share(share: f32) -> f32 {
    return clamp(share, 0.0, 1.0);
}

/// `color` with its alpha clamped to [0, 1].
fn with_unit_alpha(color: Color) -> Color {
    return vec4f(color.xyz, unit_share(color.w));
}

/// Premultiplied RGBA of a straight color.
fn premultiplied(color: Color) -> Composite {
    return vec4f(color.xyz * color.w, color.w);
}

/// Base
///
/// The color under the first layer, which may be transparent. (The BADF paper calls it C0.)
fn base(color: Color) -> Composite {
    return premultiplied(color);
}

/// Light
///
/// A light of the look, as it arrives at the surface. Its data (type, direction, color) is kept
/// with the look's lights; turning the illumination frame turns every light in it.
fn light_directional(direction: vec3f, own_direction: vec3f, color: vec3f,
    intensity: f32) -> Light {
    return Light(direction, own_direction, color, intensity);
}
