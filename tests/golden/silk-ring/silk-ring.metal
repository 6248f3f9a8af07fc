// Silk: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// silk-ring.json says what to put there and how to draw.
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
    Light low;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
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

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    metal::float3 direction;
    metal::float3 x_axis;
    metal::float3 y_axis;
    /// The direction's cosines with the two axes.
    metal::float2 place;
    char _pad4[8];
};

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    metal::float3 x_axis;
    /// Unit, upright.
    metal::float3 y_axis;
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

constant uint NOISE_PERLIN = 1u;
constant ProfileShape lit_side_shape = ProfileShape {0.9950042, 0.099833414, 1.1883951, 1.7298278,
    0.2, 1.0107075, 0.4419037, 0u};
constant ProfileShape band_shape = ProfileShape {0.9998875, 0.014999437, 9.541332, 4.980432, 0.03,
    0.07759806, 0.03648918, 0u};
constant ProfileShape second_band_shape = ProfileShape {1.0, 0.0, 6.6917324, 12.899528, 0.0,
    0.07171497, 0.035865854, 0u};

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

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return square > 0.000000000000000000000000000001 ? v
        * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001)) : otherwise;
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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(
    metal::float3 v
) {
    metal::float3 dx = metal::dfdx(v);
    metal::float3 dy = metal::dfdy(v);
    return bounded(metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy))));
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
metal::float3 any_orthogonal(
    metal::float3 n
) {
    float sign = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign + n.z);
    return metal::float3(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
DirectionParts direction_within(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis
) {
    metal::float3 y = y_axis * metal::rsqrt(metal::max(metal::dot(y_axis, y_axis),
        0.000000000000000000000000000001));
    return DirectionParts {direction, x_axis, y,
        metal::float2(metal::dot(direction, x_axis), metal::dot(direction, y))};
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
metal::float3 direction_moved(
    DirectionParts parts,
    metal::float2 by
) {
    metal::float3 moved = parts.direction + by.x * parts.x_axis + by.y * parts.y_axis;
    metal::float3 normalize_moderate_value = normalize_moderate(moved, parts.direction);
    return metal::dot(moved, moved) > 0.000001 ? normalize_moderate_value : parts.direction;
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 leaning = metal::cross(up, toward);
    float square = metal::dot(leaning, leaning);
    metal::float3 aside = metal::abs(toward.x)
        > 0.7 ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = square > 0.00000001 ? leaning : metal::cross(aside, toward);
    metal::float3 x = normalize_moderate(across - metal::dot(across, toward) * toward,
        metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(x, metal::cross(toward, x), toward);
}

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
AxesAround axes(
    metal::float3 direction,
    metal::float3 up
) {
    metal::float3x3 axes_2 = axes_around(direction, up);
    return AxesAround {axes_2[0], axes_2[1]};
}

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
metal::float3 half_vector(
    Light light,
    metal::float3 view
) {
    metal::float3 half_ = light.direction + view;
    metal::float3 any_orthogonal_value = any_orthogonal(view);
    return normalize_or(metal::dot(half_, half_) > 0.000000000001 ? half_ : any_orthogonal_value,
        view);
}

/// Stretch direction
///
/// Makes a highlight longer along an axis (above 0) or shorter (below 0): streaks of silk, hair and
/// brushed metal.
metal::float3 stretch_direction(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis,
    float x,
    float y
) {
    DirectionParts bent = direction_within(direction, x_axis, y_axis);
    return direction_moved(bent, -metal::float2(x, y) * bent.place);
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::float4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
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
    Angle warped = angle_turned_2(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
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
    // Parametrization
    Angle turned_from_the_key = Angle {0.5 * metal::length(surface.normal - look.key.direction),
        0.5 * metal::length(surface.normal + look.key.direction)};
    float lit_side = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    Composite body = blend_alpha(metal::float4(0.2275, 0.102, 0.2431, 1.0),
        metal::float4(0.4824, 0.1843, 0.3882, 1.0), lit_side, 1.0, true);
    metal::float3 normal = surface.normal;
    metal::float3 half_ = half_vector(look.key, surface.view);
    AxesAround upright = axes(half_, metal::float3(0.0, 1.0, 0.0));
    metal::float3 band_without_end = stretch_direction(normal, upright.x_axis, upright.y_axis,
        0.985, 0.0);
    // Angle between directions
    Angle from_the_band = Angle {0.5 * metal::length(band_without_end - half_), 0.5
        * metal::length(band_without_end + half_)};
    float strands = noise_perlin(surface.position_object, 14.0, 2, 0.5, 0);
    float waver = metal::mix(-0.05, 0.05, strands - 0.0);
    float band = profile_balanced_2(from_the_band, waver, band_shape);
    Composite band_on_top = blend_alpha_2(body, metal::float4(0.9529, 0.6627, 0.7059, 1.0), band,
        0.95, true);
    metal::float3 low_half = half_vector(look.low, surface.view);
    AxesAround upright_2 = axes(low_half, metal::float3(0.0, 1.0, 0.0));
    metal::float3 second_band = stretch_direction(normal, upright_2.x_axis, upright_2.y_axis, 0.985,
        0.0);
    // Angle between directions
    Angle from_the_second = Angle {0.5 * metal::length(second_band - low_half), 0.5
        * metal::length(second_band + low_half)};
    float second_band_2 = profile_balanced_2(from_the_second, waver, second_band_shape);
    // Blend
    metal::float4 second_band_on_top = metal::clamp(metal::float4(band_on_top.xyz + 0.8
        * (band_on_top.xyz + second_band_2 * metal::float3(0.3529, 0.2471, 0.549)
        - band_on_top.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return second_band_on_top;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position_1, varyings.normal };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, vertex_.position,
        object.world_from_normal * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object,
        varyings_1.normal };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object};
    return fs_mainOutput { shade(surface, look) };
}
