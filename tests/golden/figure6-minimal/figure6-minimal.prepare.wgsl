// Minimal: made by Chiaro 0.1.0, WGSL.
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

/// Mix from `below` to `blended` by `opacity`, with `alpha` as its alpha; clamped to [0, 1] if
/// `clamped`. At opacity 0 the result is exactly `below`, whatever that is.
fn blend_finish(below: Composite, blended: vec3f, alpha: f32, opacity: f32,
    clamped: bool) -> Composite {
    if opacity <= 0.0 {
        return below;
    }
    let mixed = vec4f(below.xyz + opacity * (blended - below.xyz), alpha);
    return select(mixed, clamp(mixed, vec4f(0.0), vec4f(1.0)), clamped);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    let a = opacity * color.w;
    let alpha = below.w + tone * a * (1.0 - below.w);
    return blend_finish(below, below.xyz + tone * (color.xyz - below.xyz), alpha, a, clamped);
}

/// A light's intensity as two factors: x dims the layer (at most 1), y brightens the color (at
/// least 1).
fn light_split(intensity: f32) -> vec2f {
    return vec2f(min(intensity, 1.0), max(intensity, 1.0));
}

/// Light
///
/// A light of the look, as it arrives at the surface. Its data (type, direction, color) is kept
/// with the look's lights; turning the illumination frame turns every light in it.
fn light_directional(direction: vec3f, own_direction: vec3f, color: vec3f,
    intensity: f32) -> Light {
    return Light(direction, own_direction, color, intensity);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = light_split(light.intensity);
    return LitLayer(vec4f(color.xyz * light.color * split.y, color.w), tone * split.x);
}

struct LitLayer {
    /// The color under this light.
    color: Color,
    /// The tone under this light.
    tone: f32,
}
