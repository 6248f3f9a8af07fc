// Watercolor wash: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// watercolor-wash.json says what to put there and how to draw.
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
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    metal::float4 screen;
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
    metal::float2 viewport;
    char _pad1[8];
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
    metal::float2 pixel;
    char _pad4[8];
    metal::float3 anchor;
};

typedef metal::float4 Color;
struct type_6 {
    metal::float4 inner[16];
};

struct type_7 {
    metal::float4 inner[4];
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    type_6 colors;
    /// Places of the stops, in increasing order, four to a vector.
    type_7 places;
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
    char _pad4[8];
};

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    metal::float2 place;
    char _pad1[8];
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    metal::float3 stretch;
};

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};

struct MarkPlace {
    /// Along the strokes, and across them.
    metal::float2 place;
    char _pad1[8];
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    metal::float3 stretch;
};

struct PaperGrain {
    /// The tone as the paper shows it.
    float tone;
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    float height;
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
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant Ramp two_pigments = Ramp {type_6 {{metal::float4(0.1843, 0.4353, 0.5608, 1.0),
    metal::float4(0.2471, 0.6039, 0.5255, 1.0), metal::float4(0.7882, 0.6353, 0.2353, 1.0),
    metal::float4(0.8471, 0.451, 0.3529, 1.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0)}},
    type_7 {{metal::float4(0.0, 0.45, 0.75, 1.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, 4u, 1u};

/// v with 0 for each component that is NaN or infinite.
metal::float4 finite_vec4(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(
    float x
) {
    uint bits = as_type<uint>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return static_cast<float>(exponent) + z
        * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
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

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
metal::float3 normalize_seen(
    metal::float3 v
) {
    return normalize_moderate(v, metal::float3(0.0, 0.0, 1.0));
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

/// [`bounded`], component by component.
metal::float3 bounded_vec3(
    metal::float3 v
) {
    metal::uint3 bits = as_type<metal::uint3>(v);
    metal::uint3 magnitude = bits & metal::uint3(2147483647u);
    metal::float3 largest = as_type<metal::float3>((bits & metal::uint3(2147483648u))
        | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest,
        magnitude == metal::uint3(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint3(2139095040u));
}

/// [`bounded`], component by component.
metal::float4 bounded_vec4(
    metal::float4 v
) {
    metal::uint4 bits = as_type<metal::uint4>(v);
    metal::uint4 magnitude = bits & metal::uint4(2147483647u);
    metal::float4 largest = as_type<metal::float4>((bits & metal::uint4(2147483648u))
        | metal::uint4(2139095039u));
    metal::float4 numbers = metal::select(metal::float4(0.0), largest,
        magnitude == metal::uint4(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint4(2139095040u));
}

/// a / b; 0 where b is 0.
float divided(
    float a,
    float b
) {
    if (metal::abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// [`mixed`], component by component.
metal::float3 mixed_vec3(
    metal::float3 a,
    metal::float3 b,
    float t
) {
    metal::float3 d = bounded_vec3(b - a);
    return bounded_vec3(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
metal::float3 mixed_vec3_2(
    metal::float3 a,
    metal::float3 b,
    float t
) {
    metal::float3 d = b - a;
    return bounded_vec3(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
metal::float4 mixed_vec4(
    metal::float4 a,
    metal::float4 b,
    float t
) {
    metal::float4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased_2(
    float x,
    float low,
    float high
) {
    float t = metal::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return metal::sqrt(metal::dot(d, d));
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

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
metal::float4 color_mixed(
    metal::float4 a,
    metal::float3 blended,
    float factor
) {
    metal::float3 a_2 = bounded_vec3(a.xyz);
    return metal::float4(bounded_vec3(a_2 + factor * bounded_vec3(bounded_vec3(blended) - a_2)),
        1.0);
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
metal::float4 hermite(
    metal::float4 a,
    metal::float4 b,
    metal::float4 from_a,
    metal::float4 to_b,
    float t
) {
    metal::float4 d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// [`ramp_slope`] of one component.
float harmonic_slope(
    float before,
    float span_before,
    float after,
    float span_after
) {
    if (before * after <= 0.0) {
        return 0.0;
    }
    float weight_before = 2.0 * span_after + span_before;
    float weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
metal::float4 ramp_slope(
    metal::float4 rise_before,
    float span_before,
    metal::float4 rise_after,
    float span_after
) {
    float harmonic_slope_value = harmonic_slope(divided(rise_before.x, span_before), span_before,
        divided(rise_after.x, span_after), span_after);
    float divided_value = divided(rise_after.y, span_after);
    float divided_value_1 = divided(rise_after.z, span_after);
    float harmonic_slope_value_1 = harmonic_slope(divided(rise_before.z, span_before), span_before,
        divided_value_1, span_after);
    float divided_value_2 = divided(rise_after.w, span_after);
    float harmonic_slope_value_2 = harmonic_slope(divided(rise_before.w, span_before), span_before,
        divided_value_2, span_after);
    return metal::float4(harmonic_slope_value,
        harmonic_slope(divided(rise_before.y, span_before), span_before, divided_value, span_after),
        harmonic_slope_value_1, harmonic_slope_value_2);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
Color ramp_at(
    Ramp ramp,
    float x,
    float w
) {
    type_6 colors = {};
    type_7 places = {};
    uint at = 0u;
    metal::float4 from_a = metal::float4(0.0);
    metal::float4 to_b = metal::float4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    for (uint i_2 = 1u; i_2 < 4u; i_2++) {
        float places_now = places.inner[0][naga_mod(i_2, 4u)];
        at = places_now <= x ? i_2 : at;
    }
    float place = places.inner[0][naga_mod(at, 4u)];
    if ((at + 1u >= 4u) | (x <= place)) {
        return colors.inner[at];
    }
    uint after = at + 1u;
    float span = places.inner[naga_div(after, 4u)][naga_mod(after, 4u)] - place;
    float t = metal::clamp(divided(x - place, span), 0.0, 1.0);
    if (at > 0u) {
        float before = places.inner[naga_div(at - 1u, 4u)][naga_mod(at - 1u, 4u)];
        metal::float4 ramp_slope_value = ramp_slope(colors.inner[at] - colors.inner[at - 1u],
            place - before, colors.inner[after] - colors.inner[at], span);
        from_a = ramp_slope_value;
    }
    if (after + 1u < 4u) {
        float next = places.inner[naga_div(after + 1u, 4u)][naga_mod(after + 1u, 4u)]
            - (place + span);
        to_b = ramp_slope(colors.inner[after] - colors.inner[at], span, colors.inner[after + 1u]
            - colors.inner[after], next);
    }
    return bounded_vec4(hermite(colors.inner[at], colors.inner[after], span * from_a, span * to_b,
        t));
}

Color mix_colors_multiply(
    Color a,
    Color b,
    float factor
) {
    return metal::float4(mixed_vec3_2(a.xyz, a.xyz * b.xyz, factor), 1.0);
}

Color mix_colors_multiply_2(
    Color a,
    Color b,
    float factor
) {
    metal::float3 blended = a.xyz * b.xyz;
    return metal::float4(blended - 0.25 * bounded_vec3(blended - bounded_vec3(a.xyz)),
        bounded(a.w));
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

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise_2(
    metal::float3 p,
    uint seed
) {
    float sum = 0.0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d = p - corner;
    metal::float3 f = d * d * d * (d * (d * 6.0 - metal::float3(15.0)) + metal::float3(10.0));
    metal::int3 cell = naga_f2i32(corner);
    for (int i = 0; i < 8; i++) {
        metal::int3 at = metal::int3(i & 1, (i >> 1u) & 1, i >> 2u);
        metal::float3 weight = metal::select(metal::float3(1.0) - f, f, at == metal::int3(1));
        metal::uint3 hash_pcg3d_value = hash_pcg3d(as_type<metal::uint3>(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at))) + seed * metal::uint3(2654435769u,
            2246822507u, 3266489909u));
        sum = sum + weight.x * weight.y * 0.5
            * gradient_dot(hash_pcg3d_value, d - static_cast<metal::float3>(at));
    }
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
            octave = metal::mix(0.5, perlin_noise(place, 11u + static_cast<uint>(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return metal::min(sum / 1.5, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
float fractal_noise_2(
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
    for (int i = 0; i < 4; i++) {
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
    return metal::min(sum / total, 1.0);
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    // Clip space is 2 high.
    return metal::min(0.5 * scale / metal::mix(1.0, metal::max(depth, 0.000001), perspective),
        MOST_ON_SCREEN);
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
metal::float3 anchor_on_screen(
    metal::float3 origin,
    float perspective,
    float scale
) {
    float size = size_on_screen(-origin.z, perspective, scale);
    return metal::clamp(metal::float3(origin.x * size, -origin.y * size, size),
        metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 from_middle = pixel - 0.5 * viewport;
    return metal::float2(from_middle.x, -from_middle.y)
        / metal::float2(metal::max(viewport.y, 1.0));
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 turn = metal::float2(0.0, 1.0);
    metal::float3 x = turn.y * along + turn.x * across;
    metal::float3 y = turn.y * across - turn.x * along;
    metal::float2 turned = metal::float2(turn.y * place.x + turn.x * place.y, turn.y * place.y
        - turn.x * place.x);
    metal::float3 stretch = metal::float3(metal::dot(x, x), metal::dot(x, y), metal::dot(y, y));
    return StretchedPlace {turned, {}, stretch};
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced(
    metal::float2 place,
    metal::float3 stretch,
    metal::float2 viewport,
    float count
) {
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / metal::max(viewport.y, 1.0) : count;
    metal::float2 p = metal::clamp(place * scale, metal::float2(-4194304.0),
        metal::float2(4194304.0));
    return SpacedPlace {p, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : stretch};
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
float area_square(
    metal::float3 stretch
) {
    float sum = stretch.x + stretch.z;
    return metal::max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

MarkPlace mark_place_object(
    float angle,
    metal::float3 anchor,
    metal::float2 pixel,
    metal::float2 viewport
) {
    float size = metal::clamp(anchor.z, 0.000001, 1000000.0);
    metal::float2 place = (place_in_picture(pixel, viewport) - metal::float2(anchor.x, -anchor.y))
        / metal::float2(size);
    StretchedPlace m = mark_place_of(place, metal::float3(1.0 / size, 0.0, 0.0),
        metal::float3(0.0, 1.0 / size, 0.0), angle);
    return MarkPlace {m.place, {}, m.stretch};
}

/// The height of paper in one octave; paper finer than a pixel is flat.
float paper_octave(
    metal::float2 place,
    int zoom,
    float w,
    float fiber,
    uint seed
) {
    float scale = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom)
        + as_type<uint>(127))) << 23u);
    metal::float2 p = metal::clamp(place * scale, metal::float2(-4194304.0),
        metal::float2(4194304.0));
    uint own = seed + 7u * as_type<uint>(zoom);
    float grain = perlin_noise_2(metal::float3(p, 0.5), own) - 0.5;
    metal::float2 q = metal::clamp(2.7
        * metal::float2(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), metal::float2(-4194304.0),
        metal::float2(4194304.0));
    float felt = perlin_noise_2(metal::float3(q, 0.5), own + 1u) - 0.5;
    float coarse_seen = 1.0 - metal::smoothstep(0.5, 1.0, w * scale);
    float felt_seen = 1.0 - metal::smoothstep(0.5, 1.0, 2.7 * w * scale);
    return metal::clamp(0.5 + 1.4 * (coarse_seen * grain + fiber * felt_seen * felt), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// The height of paper, from 0 to 1 and 1/2 on average. Where an octave fades into the next, both
/// octaves are seen.
float paper_height(
    SpacedPlace at,
    float fiber,
    uint seed
) {
    float height = {};
    metal::float2 x = metal::dfdx(at.place);
    metal::float2 y = metal::dfdy(at.place);
    float w = metal::sqrt(metal::max(metal::dot(x, x), metal::dot(y, y)));
    float log2_stable_value = log2_stable(metal::max(metal::sqrt(area_square(at.stretch)),
        0.000000000000000000000000000001));
    float level = metal::clamp(-0.5 * log2_stable_value, -16.0, 16.0);
    float zoom = metal::floor(level);
    float f = level - zoom;
    height = paper_octave(at.place, naga_f2i32(zoom), w, fiber, seed);
    if (f > 0.0) {
        float paper_octave_value = paper_octave(at.place,
            as_type<int>(as_type<uint>(naga_f2i32(zoom)) + as_type<uint>(1)), w, fiber, seed);
        float both = metal::mix(height, paper_octave_value, f);
        height = metal::clamp(0.5 + (both - 0.5) / metal::sqrt(f * f + (1.0 - f) * (1.0 - f)), 0.0,
            1.0);
    }
    return height;
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain(
    float value,
    metal::float2 place,
    metal::float3 stretch,
    float count,
    float tooth,
    float fiber,
    int seed,
    metal::float2 viewport
) {
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 0u);
    return PaperGrain {1.0 - metal::clamp(0.5 + 8.0 * tooth * (height - 0.5) * 0.5 * 0.5, 0.0, 1.0),
        height};
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
float outer_contour(
    float width,
    metal::float3 normal,
    metal::float3 view,
    metal::float2 viewport
) {
    float facing = metal::clamp(metal::dot(normal, view), 0.0, 1.0);
    float pixels = width * metal::clamp(viewport.y, 1.0, 100000.0) / 1000.0;
    float distance = facing / metal::max(2.0 * footprint_of(facing), 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp(pixels + 0.5 - distance, 0.0, metal::min(pixels, 1.0)) * near;
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

float noise_perlin_2(
    metal::float3 position,
    float scale,
    int octaves,
    float roughness,
    int seed
) {
    metal::float3 p = position * scale;
    return fractal_noise_2(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float drift = noise_perlin(surface.position_object, 1.5, 2, 0.5, 11);
    float spread = metal::clamp((drift - 0.32) / 0.36, 0.0, 1.0);
    Color two_pigments_2 = ramp_at(two_pigments, spread, footprint_of(spread));
    // Reflectance
    float shade_2 = metal::max((metal::dot(surface.normal, look.key.direction) + 0.45) / 1.45, 0.0);
    float tone = metal::min((shade_2 - 0.0) / 0.85, 1.0);
    float water = noise_perlin_2(surface.position_object, 2.2, 4, 0.55, 0);
    float how_far_it_runs = metal::mix(-0.24, 0.24, water - 0.0);
    float wet_tone = tone + how_far_it_runs;
    float first_wash = eased_2(wet_tone, 0.82, 0.7);
    float k1 = first_wash * 0.62;
    Color wash_on_paper = mix_colors_multiply(metal::float4(0.9843, 0.9686, 0.9255, 1.0),
        two_pigments_2, k1);
    Color deeper = mix_colors_multiply_2(two_pigments_2, metal::float4(0.3529, 0.3098, 0.5255, 1.0),
        0.75);
    float second_wash = eased_2(wet_tone, 0.42, 0.34);
    float k2 = second_wash * 0.6;
    metal::float3 mixed_vec3_value = mixed_vec3(bounded_vec3(wash_on_paper.xyz),
        bounded_vec3(wash_on_paper.xyz * deeper.xyz), k2);
    // Mix colors
    metal::float4 second_on_the_first = metal::float4(mixed_vec3_value, 1.0);
    float pigment_s_rim = metal::smoothstep(0.66, 0.72, wet_tone) * first_wash;
    float second_rim = metal::smoothstep(0.29, 0.34, wet_tone) * second_wash;
    float k3 = metal::max(pigment_s_rim, second_rim) * 0.34;
    // Mix colors
    metal::float4 rims_2 = color_mixed(second_on_the_first, second_on_the_first.xyz * deeper.xyz,
        k3);
    MarkPlace sheet = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    PaperGrain paper = paper_grain(0.5, sheet.place, sheet.stretch, 240.0, 0.6, 0.6, 0,
        look.viewport);
    float settled_pigment = metal::mix(0.9, 1.03, bounded(paper.tone) - 0.0);
    metal::float4 grain = bounded_vec4(rims_2 * metal::float4(metal::float3(settled_pigment), 1.0));
    float pencil = outer_contour(2.2, surface.normal, surface.view, look.viewport);
    float soft = pencil * 0.7;
    // Mix colors
    metal::float4 pencil_line = mixed_vec4(bounded_vec4(grain),
        metal::float4(0.2902, 0.2588, 0.2824, 1.0), soft);
    return finite_vec4(pencil_line);
}

struct vs_mainInput {
    metal::float3 position_2 [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position_2, varyings.normal_1 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, vertex_.position,
        object.world_from_normal * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_2 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_1 [[user(loc2), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_2, varyings_1.position_object,
        varyings_1.normal_1 };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float3 anchor_on_screen_value = anchor_on_screen((view.camera_from_world
        * metal::float4(object.world_from_object[3].xyz, 1.0)).xyz, view.eye.w,
        metal::length(metal::float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, in.clip.xy * view.screen.xy + view.screen.zw, {},
        anchor_on_screen_value};
    return fs_mainOutput { finite_vec4(shade(surface, look)) };
}
