#version 300 es
// Painted light: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// painted-light.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
    Light back;
    Light lamp;
    Light window;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
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
    vec3 normal;
};

const ProfileShape body_tone_shape = ProfileShape(0.60240144, 0.7981933, 21.601328, 1.0, 1.84858,
    0.06173407, 0.021818977, 0u);
const ProfileShape light_tone_shape = ProfileShape(0.9976349, 0.06873576, 2.5909312, 1.0, 0.13758,
    0.5226457, 0.18761672, 0u);
const ProfileShape behind_tone_shape = ProfileShape(0.9921977, 0.12467473, 2.425296, 1.7791567,
    0.25, 0.46467006, 0.1911372, 0u);

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
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

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + tone * color.xyz, 1.0), vec4(0.0), vec4(1.0));
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

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), 1.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_2(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    bool is_narrow = w > 0.0 && w >= 3.4641016 * shape.edge_deviation;
    if (is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_3(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    float point = profile_soft_quick_2(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick_2(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

float profile_balanced_3(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick_3(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Body (Light layer)
    Angle body_angle = parametrization_diffuse_balanced(u_look.window, surface.normal);
    float body_tone = profile_balanced(body_angle, 0.0, body_tone_shape);
    LitLayer body_lit = light_apply(u_look.window, vec4(0.18708, 0.62392, 0.48886, 1.0), body_tone);
    vec4 body_blend = blend_add(vec4(0.14678, 0.1201, 0.28662, 1.0), body_lit.color, body_lit.tone,
        1.0, true);

    // Light (Light layer)
    Angle light_angle = parametrization_diffuse_balanced(u_look.lamp, surface.normal);
    float light_tone = profile_balanced_2(light_angle, 0.0, light_tone_shape);
    LitLayer light_lit = light_apply(u_look.lamp, vec4(0.81701, 0.67278, 0.30725, 1.0), light_tone);
    vec4 light_blend = blend_add(body_blend, light_lit.color, light_lit.tone, 1.0, true);

    // Behind (Light layer)
    Angle behind_angle = parametrization_diffuse_balanced(u_look.back, surface.normal);
    float behind_tone = profile_balanced_3(behind_angle, 0.0, behind_tone_shape);
    LitLayer behind_lit = light_apply(u_look.back, vec4(0.08, 0.09, 0.1, 1.0), behind_tone);
    vec4 behind_blend = blend_add(light_blend, behind_lit.color, behind_lit.tone, 1.0, true);

    return behind_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal);
    out_color = shade(surface);
}
