// Organ, symbolic blue: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure7-organ.json says what to put there and how to draw.
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

/// What is known before the fragment.
struct Look {
    Light eye;
    metal::float3x3 camera_from_world;
    Light key;
    Light side;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
    float kappa;
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

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};

constant ProfileShape tone_tone_shape = ProfileShape {0.99875027, 0.04997917, 1.1528398, 1.361735,
    0.1, 1.1474836, 0.4845149, 0u};
constant ProfileShape shade_tone_shape = ProfileShape {0.9950042, 0.099833414, 1.4670527, 1.847488,
    0.2, 0.7777539, 0.33241227, 0u};
constant ProfileShape light_tone_shape = ProfileShape {0.99875027, 0.04997917, 2.9163208, 3.0838382,
    0.1, 0.3121117, 0.13987324, 0u};
constant ProfileShape edge_tone_shape = ProfileShape {0.8525245, 0.52268726, 5.0334897, 2.4651666,
    1.1, 0.19658314, 0.08474467, 0u};

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
metal::float2 sin_cos_quick(
    float x
) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666666 + y
        * (0.0083332425 + y * (-0.0001982274 + y * 0.0000026347564))));
    float c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (0.00002477458 - y * 0.00000026297516))));
    return metal::float2(s, c);
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
    float s = u.half_sin * t.y - u.half_cos * t.x;
    float c = u.half_cos * t.y + u.half_sin * t.x;
    metal::float2 upper = c <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, c);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    metal::float2 turned = ((s <= 0.0) & (s < c)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(
    Angle u,
    metal::float2 t
) {
    float s = u.half_sin - 0.0;
    metal::float2 upper = u.half_cos
        <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, u.half_cos);
    metal::float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + convexity * (convex - concave);
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + tone * (color.xyz - below.xyz), 1.0),
        metal::float4(0.0), metal::float4(1.0));
}

Composite blend_alpha_2(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), metal::float4(0.0),
        metal::float4(1.0));
}

Composite blend_shade(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + opacity
        * (below.xyz * metal::mix(metal::float3(1.0), color.xyz, tone) - below.xyz), 1.0),
        metal::float4(0.0), metal::float4(1.0));
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
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0),
        metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4(color.xyz * light.color * split.y, 1.0), tone * split.x};
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

Angle parametrization_screen_aligned_balanced(
    Light light,
    metal::float3 normal,
    metal::float3x3 camera_from_world
) {
    metal::float3 d = camera_from_world * normal;
    return Angle {0.5 * metal::length(d - light.own_direction), 0.5
        * metal::length(d + light.own_direction)};
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(
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
    metal::float2 place = metal::float2(u.half_sin * shape.half_cos_offset - u.half_cos
        * shape.half_sin_offset, u.half_cos * shape.half_cos_offset + u.half_sin
        * shape.half_sin_offset);
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
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
        return profile_ramp_quick(place.x, w, shape);
    }
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned_2(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

float profile_balanced_3(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Tone (Light layer)
    float light_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + metal::exp2(2.88539
        * metal::clamp(surface.kappa * 0.2, -20.0, 20.0))));
    Color tone_color = curvature_color(light_convexity, metal::float4(0.3529, 0.5882, 0.7843, 1.0),
        metal::float4(0.1412, 0.3137, 0.4784, 1.0));
    Angle tone_angle = Angle {0.5 * metal::length(surface.normal - look.key.direction), 0.5
        * metal::length(surface.normal + look.key.direction)};
    float tone_warp = (2.0 * light_convexity - 1.0) * 0.3;
    float tone_tone = profile_balanced(tone_angle, tone_warp, tone_tone_shape);
    LitLayer tone_lit = light_apply(look.key, tone_color, tone_tone);
    Composite tone_blend = blend_alpha(metal::float4(0.102, 0.2275, 0.3529, 1.0), tone_lit.color,
        tone_lit.tone, 1.0, true);

    // Shade (Light layer)
    Color shade_color = curvature_color(light_convexity, metal::float4(0.2275, 0.4157, 0.6039, 1.0),
        metal::float4(0.0863, 0.1882, 0.2902, 1.0));
    Angle shade_angle = Angle {0.5 * metal::length(surface.normal - look.side.direction), 0.5
        * metal::length(surface.normal + look.side.direction)};
    float shade_warp = (2.0 * light_convexity - 1.0) * -0.2;
    float shade_tone = profile_balanced(shade_angle, shade_warp, shade_tone_shape);
    LitLayer shade_lit = light_apply(look.side, shade_color, shade_tone);
    Composite shade_blend = blend_shade(tone_blend, shade_lit.color, shade_lit.tone, 0.8, true);

    // Light (Light layer)
    Angle light_angle = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    float light_tone = profile_balanced_2(light_angle, 0.0, light_tone_shape);
    LitLayer light_lit = light_apply(look.key, metal::float4(0.8784, 0.9569, 1.0, 1.0), light_tone);
    Composite light_blend = blend_alpha_2(shade_blend, light_lit.color, light_lit.tone, 0.6, true);

    // Edge (Light layer)
    Angle edge_angle = parametrization_screen_aligned_balanced(look.eye, surface.normal,
        look.camera_from_world);
    float edge_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + metal::exp2(2.88539
        * metal::clamp(surface.kappa * 0.1, -20.0, 20.0))));
    float edge_warp = (2.0 * edge_convexity - 1.0) * 0.2;
    float edge_tone = profile_balanced_3(edge_angle, edge_warp, edge_tone_shape);
    LitLayer edge_lit = light_apply(look.eye, metal::float4(1.0), edge_tone);
    metal::float4 edge_blend = metal::clamp(metal::float4(light_blend.xyz + 0.55
        * (light_blend.xyz * (edge_lit.tone * edge_lit.color.xyz) - light_blend.xyz), 1.0),
        metal::float4(0.0), metal::float4(1.0));

    return edge_blend;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_2 [[user(loc1), center_perspective]];
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
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        texel.x};
    return fs_mainOutput { shade(surface, look) };
}
