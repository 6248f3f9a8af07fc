#version 450 core
// A mood, by one handle: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// mood.json says what to put there and how to draw.
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

/// What is known before the fragment.
struct Look {
    vec4 back_light_color_convex;
    Light back;
    ProfileShape back_light_tone_shape;
    vec4 highlight_color_convex;
    Light key;
    ProfileShape highlight_tone_shape;
    vec4 body_color_convex;
    ProfileShape body_tone_shape;
    vec4 shadow;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
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

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// v with 0 for each component that is NaN or infinite.
vec4 finite_vec4(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual(floatBitsToUint(v) & exponent, exponent));
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

/// log2(1 - y) for y in [0, 1): a series near 0, where 1 - y would round y away, else the
/// hardware's; -100 at 1.
float log2_one_minus(float y) {
    float series = -y * LOG2_E * (1.0 + y * (0.5 + y * (0.33333334 + y * (0.25 + y * 0.2))));
    return y < 0.0625 ? series : log2(max(1.0 - y, 7.888609e-31));
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
    float s = u.half_sin - 0.0;
    vec2 upper = u.half_cos <= 0.0 ? vec2(1.0, 0.0) : vec2(s, u.half_cos);
    vec2 turned = (s <= 0.0 && s < u.half_cos) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// Mix from `below` to `blended` by `opacity`, with `alpha` as its alpha; clamped to [0, 1] if
/// `clamped`. At opacity 0 the result is exactly `below`, whatever that is.
vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if (opacity <= 0.0) {
        return below;
    }
    vec4 mixed = vec4(below.xyz + opacity * (blended - below.xyz), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    float a = opacity * color.w;
    float alpha = below.w + tone * a * (1.0 - below.w);
    return blend_finish(below, below.xyz + tone * (color.xyz - below.xyz), alpha, a, clamped);
}

/// A light's intensity as two factors: x dims the layer (at most 1), y brightens the color (at
/// least 1).
vec2 light_split(float intensity) {
    return vec2(min(intensity, 1.0), max(intensity, 1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = light_split(light.intensity);
    return LitLayer(vec4(color.xyz * light.color * split.y, color.w), tone * split.x);
}

Angle parametrization_specular_balanced(Light light, vec3 normal, vec3 view) {
    vec3 d = 2.0 * dot(normal, view) * normal - view;
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

/// [`profile_power`] by the hardware's logarithm and exponential, but for a series where the
/// exponent would amplify their errors.
float profile_power_quick(float q, float exponent) {
    float y = min(q * q, 1.0);
    float power = exp2(max(exponent * log2_one_minus(y), -126.0));
    return q >= 1.0 ? 0.0 : clamp(power, 0.0, 1.0);
}

/// Sine and cosine of half the angle from tau to u.
vec2 profile_place(Angle u, ProfileShape shape) {
    return vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float profile_power_quick_value = profile_power_quick(s * shape.scale, shape.exponent);
    return s <= 0.0 ? 1.0 : profile_power_quick_value;
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    // 2 asin(s) by its series: the ramp is narrow.
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (shape.edge_mean - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
    if (shape.kind == PROFILE_AMBIENT) {
        return 1.0;
    }
    vec2 place = profile_place(u, shape);
    bool is_narrow = w > 0.0 && w >= 3.4641016 * shape.edge_deviation;
    if (shape.kind == PROFILE_STEP || is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    // Half of the quadrature's reach is below 0.1.
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Body (Light layer)
    Angle body_angle = Angle(0.5 * length(surface.normal - u_look.key.direction), 0.5
        * length(surface.normal + u_look.key.direction));
    float body_tone = profile_balanced(body_angle, 0.0, u_look.body_tone_shape);
    LitLayer body_lit = light_apply(u_look.key, u_look.body_color_convex, body_tone);
    vec4 body_blend = blend_finish(u_look.shadow, u_look.shadow.xyz + body_lit.tone
        * (body_lit.color.xyz - u_look.shadow.xyz), u_look.shadow.w + body_lit.tone
        * body_lit.color.w * (1.0 - u_look.shadow.w), body_lit.color.w, true);

    // Highlight (Light layer)
    Angle highlight_angle = parametrization_specular_balanced(u_look.key, surface.normal,
        surface.view);
    float highlight_tone = profile_balanced(highlight_angle, 0.0, u_look.highlight_tone_shape);
    LitLayer highlight_lit = light_apply(u_look.key, u_look.highlight_color_convex, highlight_tone);
    vec4 highlight_blend = blend_alpha(body_blend, highlight_lit.color, highlight_lit.tone, 0.7,
        true);

    // Back-light (Light layer)
    Angle back_light_angle = Angle(0.5 * length(surface.normal - u_look.back.direction), 0.5
        * length(surface.normal + u_look.back.direction));
    float back_light_tone = profile_balanced(back_light_angle, 0.0, u_look.back_light_tone_shape);
    LitLayer back_light_lit = light_apply(u_look.back, u_look.back_light_color_convex,
        back_light_tone);
    vec4 back_light_blend = blend_finish(highlight_blend, highlight_blend.xyz
        + back_light_lit.tone * back_light_lit.color.xyz, highlight_blend.w, back_light_lit.color.w,
        true);

    vec4 output_ = finite_vec4(back_light_blend.w
        <= 0.0 ? back_light_blend : vec4(back_light_blend.xyz / vec3(back_light_blend.w),
        back_light_blend.w));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position));
    out_color = finite_vec4(shade(surface));
}
