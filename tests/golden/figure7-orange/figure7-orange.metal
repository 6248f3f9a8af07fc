// Orange peel: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure7-orange.json says what to put there and how to draw.
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
    Light key;
    Light fill;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position;
    metal::packed_float3 position_object;
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
    metal::float3 position_object;
    metal::float3 normal;
};

constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint NOISE_PERLIN = 1u;
constant ProfileShape flesh_tone_shape = ProfileShape {0.99875027, 0.04997917, 1.1220733, 1.2466265,
    0.1, 1.2259196, 0.51338285, 0u};
constant ProfileShape shade_tone_shape = ProfileShape {0.9950042, 0.099833414, 1.6523834, 1.9165641,
    0.2, 0.67495763, 0.28714308, 0u};
constant ProfileShape waxy_sheen_tone_shape = ProfileShape {0.9996875, 0.024997396, 2.2990327,
    2.8187852, 0.05, 0.41226318, 0.18345885, 0u};
constant ProfileShape glint_tone_shape = ProfileShape {0.9992001, 0.039989334, 14.297388, 3.2165964,
    0.08, 0.062200632, 0.027819062, 0u};

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!((largest > 0.000000000000000000000000000001)
        & (largest < 1000000000000000000000000000000.0))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

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

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(
    float x
) {
    uint bits = as_type<uint>(x);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(
    float x,
    float low,
    float high
) {
    float t = metal::clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The length of v, also where its square would over- or underflow.
float length_of(
    metal::float3 v
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (largest < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(largest * metal::length(v / metal::float3(largest)));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(
    metal::float3 v
) {
    metal::float3 dx = metal::dfdx(v);
    metal::float3 dy = metal::dfdy(v);
    return bounded(metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy))));
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

/// The normal of a surface that is raised by a height (Mikkelsen 2010): `along_x` and `along_y`
/// hold how position (xyz) and height (w) change from pixel to pixel. Where position does not
/// change, or the surface is seen edge-on, the normal stays as it is. Slopes end at 10, which is 84
/// degrees, so that silhouettes do not sparkle.
metal::float3 bumped_normal(
    metal::float4 along_x,
    metal::float4 along_y,
    metal::float3 normal
) {
    float largest = metal::max(length_of(along_x.xyz), length_of(along_y.xyz));
    if ((largest < 0.000000000000000001) | (largest > 1000000000000000000.0)) {
        return normal;
    }
    metal::float3 s = along_x.xyz / metal::float3(largest);
    metal::float3 t = along_y.xyz / metal::float3(largest);
    metal::float2 rise = metal::clamp(metal::float2(along_x.w, along_y.w) / metal::float2(largest),
        metal::float2(-1000000.0), metal::float2(1000000.0));
    metal::float3 right = metal::cross(t, normal);
    metal::float3 up = metal::cross(normal, s);
    float area = metal::dot(s, right);
    if (metal::abs(area) < 0.000001) {
        return normal;
    }
    metal::float3 slope = (rise.x * right + rise.y * up) / metal::float3(area);
    float steepness = metal::length(slope);
    metal::float3 limited = slope * (metal::min(steepness, 10.0)
        / metal::max(steepness, 0.00000000000000000001));
    return normalize_or(normal - limited, normal);
}

/// Bump map
///
/// Bends the normal as if the surface were raised by a height: from a picture, a noise or anything
/// else. It needs no texture coordinates.
metal::float3 bump_map(
    float height,
    float scale,
    metal::float3 normal,
    metal::float3 position
) {
    float raised = height * scale;
    metal::float4 along_x = metal::float4(metal::dfdx(position), metal::dfdx(raised));
    metal::float4 along_y = metal::float4(metal::dfdy(position), metal::dfdy(raised));
    return bumped_normal(along_x, along_y, normal);
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
    return metal::clamp(metal::float4(below.xyz + 0.75
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
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_3(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned_2(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v = {};
    v = seed * 1664525u + metal::uint3(1013904223u);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> metal::uint3(16u));
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

/// The hash of a lattice point.
metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed
) {
    return hash_pcg3d(as_type<metal::uint3>(cell) + seed
        * metal::uint3(2654435769u, 2246822507u, 3266489909u));
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
metal::float3 fade_quintic(
    metal::float3 t
) {
    return t * t * t * (t * (t * 6.0 - metal::float3(15.0)) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(
    metal::float3 p,
    uint seed
) {
    float sum = 0.0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d = p - corner;
    metal::float3 f = fade_quintic(d);
    metal::int3 cell = naga_f2i32(corner);
    for (int i = 0; i < 8; i++) {
        metal::int3 at = metal::int3(i & 1, (i >> 1u) & 1, i >> 2u);
        metal::float3 weight = metal::select(metal::float3(1.0) - f, f, at == metal::int3(1));
        metal::uint3 lattice_hash_value = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at)),
            seed);
        sum = sum + weight.x * weight.y * weight.z
            * gradient_dot(lattice_hash_value, d - static_cast<metal::float3>(at));
    }
    // The twelve gradients reach 1.0364 at most.
    return metal::clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
float fractal_noise(
    uint kind,
    metal::float3 p,
    int octaves,
    float roughness,
    int seed,
    float w
) {
    float octave = {};
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum = 0.0;
    for (int i = 0; i < 2; i++) {
        float visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        octave = 0.5;
        if (visible > 0.0) {
            metal::float3 place = metal::clamp(p * frequency + static_cast<float>(i)
                * metal::float3(17.31, 5.17, 11.73), metal::float3(-4194304.0),
                metal::float3(4194304.0));
            octave = metal::mix(0.5, perlin_noise(place, 0u + static_cast<uint>(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return metal::min(sum / 1.5, 1.0);
}

float noise_perlin(
    metal::float3 position,
    float scale,
    int octaves,
    float roughness,
    int seed
) {
    metal::float3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Flesh (Light layer)
    float shade_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + metal::exp2(2.88539
        * metal::clamp(surface.kappa * 0.1, -20.0, 20.0))));
    Color flesh_color = curvature_color(shade_convexity, metal::float4(0.9686, 0.6039, 0.1176, 1.0),
        metal::float4(0.8471, 0.4118, 0.0392, 1.0));

    float pores = noise_perlin(surface.position_object, 14.0, 2, 0.5, 0);
    metal::float3 rind = bump_map(pores, 0.035, surface.normal, surface.position);

    // Flesh
    Angle flesh_angle = Angle {0.5 * metal::length(rind - look.key.direction), 0.5
        * metal::length(rind + look.key.direction)};
    float flesh_warp = (2.0 * shade_convexity - 1.0) * 0.2;
    float flesh_tone = profile_balanced(flesh_angle, flesh_warp, flesh_tone_shape);
    LitLayer flesh_lit = light_apply(look.key, flesh_color, flesh_tone);
    Composite flesh_blend = blend_alpha(metal::float4(0.4314, 0.1647, 0.0235, 1.0), flesh_lit.color,
        flesh_lit.tone, 1.0, true);

    // Shade (Light layer)
    Color shade_color = curvature_color(shade_convexity, metal::float4(0.7216, 0.2824, 0.0471, 1.0),
        metal::float4(0.5412, 0.1843, 0.0392, 1.0));
    Angle shade_angle = Angle {0.5 * metal::length(rind - look.fill.direction), 0.5
        * metal::length(rind + look.fill.direction)};
    float shade_warp = (2.0 * shade_convexity - 1.0) * 0.1;
    float shade_tone = profile_balanced(shade_angle, shade_warp, shade_tone_shape);
    LitLayer shade_lit = light_apply(look.fill, shade_color, shade_tone);
    Composite shade_blend = blend_shade(flesh_blend, shade_lit.color, shade_lit.tone, 0.75, true);

    // Waxy sheen (Light layer)
    Angle glint_angle = parametrization_specular_balanced(look.key, rind, surface.view);
    float waxy_sheen_tone = profile_balanced_2(glint_angle, 0.0, waxy_sheen_tone_shape);
    LitLayer waxy_sheen_lit = light_apply(look.key, metal::float4(0.4157, 0.2902, 0.1333, 1.0),
        waxy_sheen_tone);
    metal::float4 waxy_sheen_blend = metal::clamp(metal::float4(shade_blend.xyz + 0.55
        * (shade_blend.xyz + waxy_sheen_lit.tone * waxy_sheen_lit.color.xyz - shade_blend.xyz),
        1.0), metal::float4(0.0), metal::float4(1.0));

    // Glint (Light layer)
    float glint_tone = profile_balanced_3(glint_angle, 0.0, glint_tone_shape);
    LitLayer glint_lit = light_apply(look.key, metal::float4(1.0), glint_tone);
    Composite glint_blend = blend_alpha_2(waxy_sheen_blend, glint_lit.color, glint_lit.tone, 0.85,
        true);

    return glint_blend;
}

struct vs_mainInput {
    metal::float3 position_2 [[attribute(0)]];
    metal::float3 normal_3 [[attribute(1)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_2, varyings.normal_3 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, vertex_.position,
        object.world_from_normal * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_2 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_3 [[user(loc2), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position_2, varyings_1.position_object,
        varyings_1.normal_3 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position, in.position_object, texel.x};
    return fs_mainOutput { shade(surface, look) };
}
