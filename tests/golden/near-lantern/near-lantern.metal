// Near the lantern: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// near-lantern.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    metal::float4 eye;
};

struct Object {
    metal::float4x4 world_from_object;
    /// The inverse transpose, for normals.
    metal::float3x3 world_from_normal;
    float id;
    char _pad3[12];
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    metal::float3 direction;
    /// Unit, toward the light, in the light's own frame.
    metal::float3 own_direction;
    /// Straight RGB.
    metal::packed_float3 color;
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
    metal::float4 back_light_color_convex;
    Light back;
    metal::float4 highlight_color_convex;
    Light key;
    metal::float4 body_color_convex;
    ProfileShape body_tone_shape;
    metal::float4 shadow;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
};

typedef metal::float4 Color;
typedef metal::float4 Composite;
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
    Color color;
    /// The tone under this light.
    float tone;
    char _pad2[12];
};

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};

constant float LOG2_E = 1.442695;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape highlight_tone_shape = ProfileShape {0.9950042, 0.099833414, 6.6917324,
    4.960133, 0.2, 0.11088749, 0.05215291, 0u};
constant ProfileShape back_light_tone_shape = ProfileShape {0.9553365, 0.29552022, 5.743557,
    2.0104687, 0.6, 0.18576889, 0.077249795, 0u};

/// v with 0 for each component that is NaN or infinite.
metal::float4 finite_vec4(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

/// log2(1 - y) for y in [0, 1): a series near 0, where 1 - y would round y away, else the
/// hardware's; -100 at 1.
float log2_one_minus(
    float y
) {
    float series = -y * LOG2_E * (1.0 + y * (0.5 + y * (0.33333334 + y * (0.25 + y * 0.2))));
    return y < 0.0625 ? series : metal::log2(metal::max(1.0 - y,
        0.0000000000000000000000000000007888609));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(
    Angle u,
    metal::float2 t
) {
    float s = u.half_sin - 0.0;
    metal::float2 upper = u.half_cos
        <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, u.half_cos);
    metal::float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

/// Mix from `below` to `blended` by `opacity`, with `alpha` as its alpha; clamped to [0, 1] if
/// `clamped`. At opacity 0 the result is exactly `below`, whatever that is.
Composite blend_finish(
    Composite below,
    metal::float3 blended,
    float alpha,
    float opacity,
    bool clamped
) {
    if (opacity <= 0.0) {
        return below;
    }
    metal::float4 mixed = metal::float4(below.xyz + opacity * (blended - below.xyz), alpha);
    return metal::clamp(mixed, metal::float4(0.0), metal::float4(1.0));
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    float a = opacity * color.w;
    float alpha = below.w + tone * a * (1.0 - below.w);
    return blend_finish(below, below.xyz + tone * (color.xyz - below.xyz), alpha, a, clamped);
}

/// A light's intensity as two factors: x dims the layer (at most 1), y brightens the color (at
/// least 1).
metal::float2 light_split(
    float intensity
) {
    return metal::float2(metal::min(intensity, 1.0), metal::max(intensity, 1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(
    Light light,
    Color color,
    float tone
) {
    metal::float2 split = light_split(light.intensity);
    return LitLayer {metal::float4(color.xyz * light.color * split.y, color.w), tone * split.x};
}

Angle parametrization_specular_balanced(
    Light light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d = 2.0 * metal::dot(normal, view) * normal - view;
    return Angle {0.5 * metal::length(d - light.direction), 0.5
        * metal::length(d + light.direction)};
}

/// [`profile_power`] by the hardware's logarithm and exponential, but for a series where the
/// exponent would amplify their errors.
float profile_power_quick(
    float q,
    float exponent
) {
    float y = metal::min(q * q, 1.0);
    float power = metal::exp2(metal::max(exponent * log2_one_minus(y), -126.0));
    return q >= 1.0 ? 0.0 : metal::clamp(power, 0.0, 1.0);
}

/// Sine and cosine of half the angle from tau to u.
metal::float2 profile_place(
    Angle u,
    ProfileShape shape
) {
    return metal::float2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float profile_power_quick_value = profile_power_quick(s * shape.scale, shape.exponent);
    return s <= 0.0 ? 1.0 : profile_power_quick_value;
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_2(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : metal::pow(metal::max(1.0 - q * q, 0.0), shape.exponent);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(
    float s,
    float w,
    ProfileShape shape
) {
    float width = metal::sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    // 2 asin(s) by its series: the ramp is narrow.
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = metal::clamp(0.5 + (shape.edge_mean - from_offset) / metal::max(width, 0.000001),
        0.0, 1.0);
    return w <= 0.0 ? (s <= 0.0000004 ? 1.0 : 0.0) : ramp;
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick_2(
    float s,
    float w,
    ProfileShape shape
) {
    float width = metal::sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = metal::clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return w <= 0.0 ? (s <= 0.0000004 ? 1.0 : 0.0) : ramp;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(
    Angle u,
    float w,
    ProfileShape shape
) {
    if (shape.kind == PROFILE_AMBIENT) {
        return 1.0;
    }
    metal::float2 place = profile_place(u, shape);
    bool is_narrow = (w > 0.0) & (w >= 3.4641016 * shape.edge_deviation);
    if ((shape.kind == PROFILE_STEP) | is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    // Half of the quadrature's reach is below 0.1.
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(
    Angle u,
    float w,
    ProfileShape shape
) {
    metal::float2 place = metal::float2(u.half_sin * shape.half_cos_offset - u.half_cos
        * shape.half_sin_offset, u.half_cos * shape.half_cos_offset + u.half_sin
        * shape.half_sin_offset);
    bool is_narrow = (w > 0.0) & (w >= 3.4641016 * shape.edge_deviation);
    if (is_narrow) {
        return profile_ramp_quick_2(place.x, w, shape);
    }
    float point = profile_soft_quick_2(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick_2(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Body (Light layer)
    Angle body_angle = Angle {0.5 * metal::length(surface.normal - look.key.direction), 0.5
        * metal::length(surface.normal + look.key.direction)};
    float body_tone = profile_balanced(body_angle, 0.0, look.body_tone_shape);
    LitLayer body_lit = light_apply(look.key, look.body_color_convex, body_tone);
    Composite body_blend = blend_finish(look.shadow, look.shadow.xyz + body_lit.tone
        * (body_lit.color.xyz - look.shadow.xyz), look.shadow.w + body_lit.tone * body_lit.color.w
        * (1.0 - look.shadow.w), body_lit.color.w, true);

    // Highlight (Light layer)
    Angle highlight_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    float highlight_tone = profile_balanced_2(highlight_angle, 0.0, highlight_tone_shape);
    LitLayer highlight_lit = light_apply(look.key, look.highlight_color_convex, highlight_tone);
    Composite highlight_blend = blend_alpha(body_blend, highlight_lit.color, highlight_lit.tone,
        0.9, true);

    // Back-light (Light layer)
    Angle back_light_angle = Angle {0.5 * metal::length(surface.normal - look.back.direction), 0.5
        * metal::length(surface.normal + look.back.direction)};
    float back_light_tone = profile_balanced_2(back_light_angle, 0.0, back_light_tone_shape);
    LitLayer back_light_lit = light_apply(look.back, look.back_light_color_convex, back_light_tone);
    Composite back_light_blend = blend_finish(highlight_blend, highlight_blend.xyz
        + back_light_lit.tone * back_light_lit.color.xyz, highlight_blend.w, back_light_lit.color.w,
        true);

    metal::float4 output = finite_vec4(back_light_blend.w
        <= 0.0 ? back_light_blend : metal::float4(back_light_blend.xyz
        / metal::float3(back_light_blend.w), back_light_blend.w));
    return output;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_1 [[user(loc1), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position)};
    return fs_mainOutput { finite_vec4(shade(surface, look)) };
}
