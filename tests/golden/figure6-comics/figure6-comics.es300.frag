#version 300 es
// Comics: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-comics.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    vec3 direction;
    /// Unit, toward the light, in the light's own frame.
    vec3 own_direction;
    /// Straight RGB.
    vec3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    Light key;
    Light rim;
    Light fill;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    float kappa;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

struct LitLayer {
    /// The color under this light.
    vec4 color;
    /// The tone under this light.
    float tone;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    uint kind;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

const ProfileShape key_tone_shape = ProfileShape(0.8472551, 0.5311862, 0.0, 1.0, 1.12, 0.0, 0.0,
    1u);
const ProfileShape bounce_tone_shape = ProfileShape(0.9358968, 0.35227424, 0.0, 1.0, 0.72, 0.0, 0.0,
    1u);
const ProfileShape light_tone_shape = ProfileShape(0.96638995, 0.25708055, 0.0, 1.0, 0.52, 0.0, 0.0,
    1u);
const ProfileShape rim_tone_shape = ProfileShape(0.9130889, 0.40776044, 0.0, 1.0, 0.84, 0.0, 0.0,
    1u);
const ProfileShape highlight_tone_shape = ProfileShape(0.99280864, 0.119712204, 0.0, 1.0, 0.24, 0.0,
    0.0, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
vec2 sin_cos_quick(float x) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666666 + y
        * (0.0083332425 + y * (-0.0001982274 + y * 2.6347564e-6))));
    float c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (2.477458e-5 - y * 2.6297516e-7))));
    return vec2(s, c);
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, vec2 t) {
    float s = u.half_sin * t.y - u.half_cos * t.x;
    float c = u.half_cos * t.y + u.half_sin * t.x;
    vec2 upper = c <= 0.0 ? vec2(1.0, 0.0) : vec2(s, c);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    vec2 turned = (s <= 0.0 && s < c) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return concave + convexity * (convex - concave);
}

float transition_balanced(float kappa, float slope) {
    return 0.5 + 0.5 * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(kappa * slope, -20.0, 20.0))));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + tone * (color.xyz - below.xyz), 1.0), vec4(0.0), vec4(1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

Angle parametrization_diffuse_balanced(Light light, vec3 normal) {
    return Angle(0.5 * length(normal - light.direction), 0.5 * length(normal + light.direction));
}

Angle parametrization_specular_balanced(Light light, vec3 normal, vec3 view) {
    vec3 d = 2.0 * dot(normal, view) * normal - view;
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Shadow (Light layer)
    float key_convexity = transition_balanced(surface.kappa, 0.35);
    vec4 shadow_color = curvature_color(key_convexity, vec4(0.7059, 0.3412, 0.2902, 1.0),
        vec4(0.2941, 0.1098, 0.2, 1.0));
    LitLayer shadow_lit = light_apply(u_look.key, shadow_color, 1.0);
    vec4 shadow_blend = blend_alpha(vec4(0.8863, 0.6275, 0.4353, 1.0), shadow_lit.color,
        shadow_lit.tone, 1.0, true);

    // Key (Light layer)
    vec4 key_color = curvature_color(key_convexity, vec4(0.9529, 0.6902, 0.4392, 1.0),
        vec4(0.7686, 0.3451, 0.2902, 1.0));
    Angle light_angle = parametrization_diffuse_balanced(u_look.key, surface.normal);
    float key_warp = (2.0 * key_convexity - 1.0) * 0.45;
    float key_tone = profile_balanced(light_angle, key_warp, key_tone_shape);
    LitLayer key_lit = light_apply(u_look.key, key_color, key_tone);
    vec4 key_blend = blend_alpha(shadow_blend, key_lit.color, key_lit.tone, 1.0, true);

    // Bounce (Light layer)
    float light_convexity = transition_balanced(surface.kappa, 0.3);
    vec4 bounce_color = curvature_color(light_convexity, vec4(0.8157, 0.4863, 0.3686, 1.0),
        vec4(0.549, 0.2275, 0.298, 1.0));
    Angle bounce_angle = parametrization_diffuse_balanced(u_look.fill, surface.normal);
    float bounce_warp = (2.0 * light_convexity - 1.0) * 0.35;
    float bounce_tone = profile_balanced(bounce_angle, bounce_warp, bounce_tone_shape);
    LitLayer bounce_lit = light_apply(u_look.fill, bounce_color, bounce_tone);
    vec4 bounce_blend = blend_alpha(key_blend, bounce_lit.color, bounce_lit.tone, 1.0, true);

    // Light (Light layer)
    vec4 light_color = curvature_color(light_convexity, vec4(1.0, 0.851, 0.6275, 1.0),
        vec4(0.9412, 0.6431, 0.4078, 1.0));
    float light_warp = (2.0 * light_convexity - 1.0) * 0.3;
    float light_tone = profile_balanced(light_angle, light_warp, light_tone_shape);
    LitLayer light_lit = light_apply(u_look.key, light_color, light_tone);
    vec4 light_blend = blend_alpha(bounce_blend, light_lit.color, light_lit.tone, 1.0, true);

    // Rim (Light layer)
    float highlight_convexity = transition_balanced(surface.kappa, 0.25);
    vec4 rim_color = curvature_color(highlight_convexity, vec4(1.0, 0.9569, 0.8627, 1.0),
        vec4(0.949, 0.6588, 0.4196, 1.0));
    Angle rim_angle = parametrization_diffuse_balanced(u_look.rim, surface.normal);
    float rim_warp = (2.0 * highlight_convexity - 1.0) * 0.2;
    float rim_tone = profile_balanced(rim_angle, rim_warp, rim_tone_shape);
    LitLayer rim_lit = light_apply(u_look.rim, rim_color, rim_tone);
    vec4 rim_blend = blend_alpha(light_blend, rim_lit.color, rim_lit.tone, 1.0, true);

    // Highlight (Light layer)
    vec4 highlight_color = curvature_color(highlight_convexity, vec4(1.0, 0.9804, 0.9412, 1.0),
        vec4(1.0, 0.8863, 0.7216, 1.0));
    Angle highlight_angle = parametrization_specular_balanced(u_look.key, surface.normal,
        surface.view);
    float highlight_warp = (2.0 * highlight_convexity - 1.0) * 0.1;
    float highlight_tone = profile_balanced(highlight_angle, highlight_warp, highlight_tone_shape);
    LitLayer highlight_lit = light_apply(u_look.key, highlight_color, highlight_tone);
    vec4 highlight_blend = blend_alpha(rim_blend, highlight_lit.color, highlight_lit.tone, 1.0,
        true);

    return highlight_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        texel.x);
    out_color = shade(surface);
}
