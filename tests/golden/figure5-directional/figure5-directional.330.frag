#version 330 core
// Directional control: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure5-directional.json says what to put there and how to draw.
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
    vec4 highlight_color_convex;
    vec4 highlight_color_concave;
    Light key;
    vec4 back_light_color_convex;
    vec4 back_light_color_concave;
    float back_light_warp_amount;
    Light back;
    ProfileShape back_light_tone_shape;
    ProfileShape diffuse_tone_shape;
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

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

const float PI = 3.1415927;
const float LOG2_E = 1.442695;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape highlight_tone_shape = ProfileShape(0.9959527, 0.08987855, 11.126125, 3.022525,
    0.18, 0.08196669, 0.036355104, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

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

/// Mix from `below` to `blended` by `opacity`, with `alpha` as its alpha; clamped to [0, 1] if
/// `clamped`. At opacity 0 the result is exactly `below`, whatever that is.
vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped) {
    if (opacity <= 0.0) {
        return below;
    }
    vec4 mixed = vec4(below.xyz + opacity * (blended - below.xyz), alpha);
    return clamp(mixed, vec4(0.0), vec4(1.0));
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

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply_2(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), split.x);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply_3(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), tone * split.x);
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

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_2(float s, ProfileShape shape) {
    float q = s * shape.scale;
    float log2_one_minus_value = log2_one_minus(min(q * q, 1.0));
    return s <= 0.0 ? 1.0 : (q >= 1.0 ? 0.0 : min(exp2(max(shape.exponent * log2_one_minus_value,
        -126.0)), 1.0));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_3(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
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

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick_2(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    bool is_narrow = w > 0.0 && w >= 3.4641016 * shape.edge_deviation;
    if (shape.kind == PROFILE_STEP || is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_3(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    bool is_narrow = w > 0.0 && w >= 3.4641016 * shape.edge_deviation;
    if (is_narrow) {
        return profile_ramp_quick_2(place.x, w, shape);
    }
    float point = profile_soft_quick_3(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick_3(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick_3(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * clamp(shift, -3.1415927, PI)));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

float profile_balanced_3(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick_3(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Fill (Light layer)
    float back_light_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(surface.kappa * 0.25, -20.0, 20.0))));
    vec4 fill_color = curvature_color(back_light_convexity, vec4(0.1647, 0.1843, 0.2392, 1.0),
        vec4(0.0706, 0.0784, 0.1098, 1.0));
    LitLayer fill_lit = light_apply_2(u_look.key, fill_color, 1.0);
    vec4 fill_blend = clamp(vec4(vec3(0.0784, 0.0863, 0.1137) + fill_lit.tone * fill_lit.color.xyz,
        1.0), vec4(0.0), vec4(1.0));

    // Diffuse (Light layer)
    vec4 diffuse_color = curvature_color(back_light_convexity, vec4(0.498, 0.6039, 0.3216, 1.0),
        vec4(0.2471, 0.4, 0.251, 1.0));
    Angle diffuse_angle = Angle(0.5 * length(surface.normal - u_look.key.direction), 0.5
        * length(surface.normal + u_look.key.direction));
    float diffuse_warp = (2.0 * back_light_convexity - 1.0) * 0.3;
    float diffuse_tone = profile_balanced(diffuse_angle, diffuse_warp, u_look.diffuse_tone_shape);
    LitLayer diffuse_lit = light_apply_3(u_look.key, diffuse_color, diffuse_tone);
    vec4 diffuse_blend = clamp(vec4(fill_blend.xyz + diffuse_lit.tone * diffuse_lit.color.xyz, 1.0),
        vec4(0.0), vec4(1.0));

    // Back-light (Light layer)
    vec4 back_light_color = u_look.back_light_color_concave + back_light_convexity
        * (u_look.back_light_color_convex - u_look.back_light_color_concave);
    Angle back_light_angle = Angle(0.5 * length(surface.normal - u_look.back.direction), 0.5
        * length(surface.normal + u_look.back.direction));
    float back_light_warp = (2.0 * back_light_convexity - 1.0)
        * clamp(u_look.back_light_warp_amount, -3.1415927, 3.1415927);
    float back_light_tone = profile_balanced_2(back_light_angle, back_light_warp,
        u_look.back_light_tone_shape);
    LitLayer back_light_lit = light_apply(u_look.back, back_light_color, back_light_tone);
    vec4 back_light_blend = blend_finish(diffuse_blend, diffuse_blend.xyz + back_light_lit.tone
        * back_light_lit.color.xyz, 1.0, back_light_lit.color.w, true);

    // Highlight (Light layer)
    float highlight_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(surface.kappa * 0.2, -20.0, 20.0))));
    vec4 highlight_color = u_look.highlight_color_concave + highlight_convexity
        * (u_look.highlight_color_convex - u_look.highlight_color_concave);
    Angle highlight_angle = parametrization_specular_balanced(u_look.key, surface.normal,
        surface.view);
    float highlight_warp = (2.0 * highlight_convexity - 1.0) * 0.05;
    float highlight_tone = profile_balanced_3(highlight_angle, highlight_warp,
        highlight_tone_shape);
    LitLayer highlight_lit = light_apply(u_look.key, highlight_color, highlight_tone);
    vec4 highlight_blend = blend_finish(back_light_blend, back_light_blend.xyz
        + highlight_lit.tone * highlight_lit.color.xyz, 1.0, highlight_lit.color.w, true);

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
