// Ten lights, each with its own edge: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// lights-apart.json says what to put there and how to draw.
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
    Light moon;
    float moon_intensity;
    char _pad2[12];
    Light violet;
    float violet_intensity;
    char _pad4[12];
    Light rose;
    float rose_intensity;
    char _pad6[12];
    Light amber;
    float amber_intensity;
    char _pad8[12];
    Light gold;
    float gold_intensity;
    char _pad10[12];
    Light coral;
    float coral_intensity;
    char _pad12[12];
    Light magenta;
    float magenta_intensity;
    char _pad14[12];
    Light cobalt;
    float cobalt_intensity;
    char _pad16[12];
    Light turquoise;
    float turquoise_intensity;
    char _pad18[12];
    Light azure;
    float azure_intensity;
    char _pad20[12];
    metal::float4 lamps_moon_strength;
    metal::float4 lamps_violet_strength;
    metal::float4 lamps_rose_strength;
    metal::float4 lamps_amber_strength;
    metal::float4 lamps_gold_strength;
    metal::float4 lamps_coral_strength;
    metal::float4 lamps_magenta_strength;
    metal::float4 lamps_cobalt_strength;
    metal::float4 lamps_turquoise_strength;
    metal::float4 lamps_azure_strength;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
};

typedef metal::float4 Color;
/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
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
    metal::float3 normal;
};

constant ProfileShape lamps_moon_tone_shape = ProfileShape {0.9358968, 0.35227424, 66.66917,
    2.499803, 0.72, 0.014726315, 0.0063439487, 0u};

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
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

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
Color limit_color(
    Color color,
    float limit,
    float softness
) {
    metal::float3 c = metal::clamp(color.xyz, metal::float3(-1000000000000000000.0),
        metal::float3(1000000000000000000.0));
    float knee = 1.0 - softness;
    float brightest = metal::max(metal::max(c.x, c.y), c.z);
    if (brightest <= knee) {
        return metal::float4(c, 2.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + metal::min(above, room) * (metal::max(above, room) / (above + room));
    return metal::float4(c * metal::min(pressed / brightest, 1.0), 2.0);
}

Angle parametrization_diffuse_balanced(
    Light light,
    metal::float3 normal
) {
    return Angle {0.5 * metal::length(normal - light.direction), 0.5
        * metal::length(normal + light.direction)};
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
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

Color sum_of_lights_color(
    Color value,
    Color before_sum,
    float reach
) {
    return reach > 0.0 ? metal::float4(before_sum.xyz + value.xyz, 1.0) : before_sum;
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Lamps moon (Each lamp)
    Angle lamps_moon_angle = parametrization_diffuse_balanced(look.moon, surface.normal);
    float lamps_moon_tone = profile_balanced(lamps_moon_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_moon_lit = look.lamps_moon_strength
        * metal::float4(metal::float3(lamps_moon_tone), 1.0);

    // Lamps violet (Each lamp)
    Angle lamps_violet_angle = parametrization_diffuse_balanced(look.violet, surface.normal);
    float lamps_violet_tone = profile_balanced(lamps_violet_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_violet_lit = look.lamps_violet_strength
        * metal::float4(metal::float3(lamps_violet_tone), 1.0);

    // Lamps rose (Each lamp)
    Angle lamps_rose_angle = parametrization_diffuse_balanced(look.rose, surface.normal);
    float lamps_rose_tone = profile_balanced(lamps_rose_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_rose_lit = look.lamps_rose_strength
        * metal::float4(metal::float3(lamps_rose_tone), 1.0);

    // Lamps amber (Each lamp)
    Angle lamps_amber_angle = parametrization_diffuse_balanced(look.amber, surface.normal);
    float lamps_amber_tone = profile_balanced(lamps_amber_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_amber_lit = look.lamps_amber_strength
        * metal::float4(metal::float3(lamps_amber_tone), 1.0);

    // Lamps gold (Each lamp)
    Angle lamps_gold_angle = parametrization_diffuse_balanced(look.gold, surface.normal);
    float lamps_gold_tone = profile_balanced(lamps_gold_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_gold_lit = look.lamps_gold_strength
        * metal::float4(metal::float3(lamps_gold_tone), 1.0);

    // Lamps coral (Each lamp)
    Angle lamps_coral_angle = parametrization_diffuse_balanced(look.coral, surface.normal);
    float lamps_coral_tone = profile_balanced(lamps_coral_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_coral_lit = look.lamps_coral_strength
        * metal::float4(metal::float3(lamps_coral_tone), 1.0);

    // Lamps magenta (Each lamp)
    Angle lamps_magenta_angle = parametrization_diffuse_balanced(look.magenta, surface.normal);
    float lamps_magenta_tone = profile_balanced(lamps_magenta_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_magenta_lit = look.lamps_magenta_strength
        * metal::float4(metal::float3(lamps_magenta_tone), 1.0);

    // Lamps cobalt (Each lamp)
    Angle lamps_cobalt_angle = parametrization_diffuse_balanced(look.cobalt, surface.normal);
    float lamps_cobalt_tone = profile_balanced(lamps_cobalt_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_cobalt_lit = look.lamps_cobalt_strength
        * metal::float4(metal::float3(lamps_cobalt_tone), 1.0);

    // Lamps turquoise (Each lamp)
    Angle lamps_turquoise_angle = parametrization_diffuse_balanced(look.turquoise, surface.normal);
    float lamps_turquoise_tone = profile_balanced(lamps_turquoise_angle, 0.0,
        lamps_moon_tone_shape);
    metal::float4 lamps_turquoise_lit = look.lamps_turquoise_strength
        * metal::float4(metal::float3(lamps_turquoise_tone), 1.0);

    // Lamps azure (Each lamp)
    Angle lamps_azure_angle = parametrization_diffuse_balanced(look.azure, surface.normal);
    float lamps_azure_tone = profile_balanced(lamps_azure_angle, 0.0, lamps_moon_tone_shape);
    metal::float4 lamps_azure_lit = look.lamps_azure_strength
        * metal::float4(metal::float3(lamps_azure_tone), 1.0);
    metal::float4 lamps_azure_sum = look.azure_intensity
        > 0.0 ? metal::float4(metal::float3(0.0) + lamps_azure_lit.xyz, 1.0) : metal::float4(0.0,
        0.0, 0.0, 1.0);

    // Lamps turquoise
    Color lamps_turquoise_sum = sum_of_lights_color(lamps_turquoise_lit, lamps_azure_sum,
        look.turquoise_intensity);

    // Lamps cobalt
    Color lamps_cobalt_sum = sum_of_lights_color(lamps_cobalt_lit, lamps_turquoise_sum,
        look.cobalt_intensity);

    // Lamps magenta
    Color lamps_magenta_sum = sum_of_lights_color(lamps_magenta_lit, lamps_cobalt_sum,
        look.magenta_intensity);

    // Lamps coral
    Color lamps_coral_sum = sum_of_lights_color(lamps_coral_lit, lamps_magenta_sum,
        look.coral_intensity);

    // Lamps gold
    Color lamps_gold_sum = sum_of_lights_color(lamps_gold_lit, lamps_coral_sum,
        look.gold_intensity);

    // Lamps amber
    Color lamps_amber_sum = sum_of_lights_color(lamps_amber_lit, lamps_gold_sum,
        look.amber_intensity);

    // Lamps rose
    Color lamps_rose_sum = sum_of_lights_color(lamps_rose_lit, lamps_amber_sum,
        look.rose_intensity);

    // Lamps violet
    Color lamps_violet_sum = sum_of_lights_color(lamps_violet_lit, lamps_rose_sum,
        look.violet_intensity);

    // Lamps moon
    Color lamps_moon_sum = sum_of_lights_color(lamps_moon_lit, lamps_violet_sum,
        look.moon_intensity);

    Color dark = lamps_moon_sum + metal::float4(0.07, 0.05, 0.1, 1.0);
    return metal::float4(limit_color(dark, 1.0, 0.4).xyz, 1.0);
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 normal [[user(loc0), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 normal_1 [[user(loc0), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.normal_1 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal};
    return fs_mainOutput { shade(surface, look) };
}
