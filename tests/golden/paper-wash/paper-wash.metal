// Paper wash: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// paper-wash.json says what to put there and how to draw.
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
    metal::float2 pixel;
    char _pad2[8];
    metal::float3 anchor;
};

typedef metal::float4 Color;
typedef metal::float4 Composite;
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
    metal::float3 normal;
};

constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant Ramp indigo_to_warm_paper = Ramp {type_6 {{metal::float4(0.13, 0.14, 0.33, 1.0),
    metal::float4(0.24, 0.36, 0.56, 1.0), metal::float4(0.53, 0.66, 0.72, 1.0),
    metal::float4(0.9, 0.8, 0.68, 1.0), metal::float4(0.975, 0.95, 0.9, 1.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0)}},
    type_7 {{metal::float4(0.0, 0.35, 0.62, 0.82), metal::float4(1.0, 0.0, 0.0, 0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 5u, 1u};

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

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return bounded(metal::sqrt(metal::dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return metal::sqrt(metal::dot(d, d));
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
float stairs_integral(
    float x,
    float count
) {
    float inside = metal::min(x, count);
    float stair = metal::min(metal::floor(inside), 3.0);
    float beyond = metal::max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * 3.0;
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
float stairs_integral_2(
    float x,
    float count
) {
    float inside = metal::max(x, 0.0);
    float stair = metal::floor(inside);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + 0.0;
}

/// The stairs floor(x) from 0 to `count` - 1, averaged over a footprint of `w`; x in [0, count],
/// count at least 2.
float stairs_filtered(
    float x,
    float count,
    float w
) {
    if (w <= 1.0) {
        float edge = metal::clamp(metal::rint(x), 1.0, 3.0);
        return edge - 1.0 + metal::clamp(0.5 + (x - edge) / w, 0.0, 1.0);
    }
    float half_ = 0.5 * w;
    return (stairs_integral(x + half_, count) - stairs_integral_2(x - half_, count))
        / (2.0 * half_);
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

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
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
    for (uint i_2 = 1u; i_2 < 5u; i_2++) {
        float places_now = places.inner[naga_div(i_2, 4u)][naga_mod(i_2, 4u)];
        at = places_now <= x ? i_2 : at;
    }
    float place = places.inner[naga_div(at, 4u)][naga_mod(at, 4u)];
    if ((at + 1u >= 5u) | (x <= place)) {
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
    if (after + 1u < 5u) {
        float next = places.inner[naga_div(after + 1u, 4u)][naga_mod(after + 1u, 4u)]
            - (place + span);
        to_b = ramp_slope(colors.inner[after] - colors.inner[at], span, colors.inner[after + 1u]
            - colors.inner[after], next);
    }
    return bounded_vec4(hermite(colors.inner[at], colors.inner[after], span * from_a, span * to_b,
        t));
}

/// Premultiplied RGBA of a straight color.
Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
Color output(
    Composite color
) {
    return finite_vec4(straight(color));
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
    float grain = perlin_noise(metal::float3(p, 0.5), own) - 0.5;
    metal::float2 q = metal::clamp(2.7
        * metal::float2(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), metal::float2(-4194304.0),
        metal::float2(4194304.0));
    float felt = perlin_noise(metal::float3(q, 0.5), own + 1u) - 0.5;
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
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 5u);
    return PaperGrain {1.0 - metal::clamp(0.5 + 0.0 * (height - 0.5) * 0.5 * 0.5, 0.0, 1.0),
        height};
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_2(
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
    float ink = 1.0 - metal::clamp(value, 0.0, 1.0);
    return PaperGrain {1.0 - metal::clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink),
        0.0, 1.0), height};
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Reflectance
    float light_and_shade = metal::max((metal::dot(surface.normal, look.key.direction) + 0.5) / 1.5,
        0.0);
    MarkPlace paper_that_goes_along = mark_place_object(0.0, surface.anchor, surface.pixel,
        look.viewport);
    PaperGrain where_water_stood = paper_grain(0.5, paper_that_goes_along.place,
        paper_that_goes_along.stretch, 11.0, 0.0, 0.7, 5, look.viewport);
    float uneven_edge = metal::mix(-0.2, 0.2, bounded(where_water_stood.height) - 0.0);
    float wet = light_and_shade + uneven_edge;
    float footprint_of_2_value = footprint_of_2(wet);
    float stairs_filtered_value = stairs_filtered(4.0 * metal::clamp(wet, 0.0, 1.0), 4.0,
        metal::length(metal::float2(4.0 * footprint_of_2_value, 0.22)));
    // Bands
    float washes = metal::clamp(stairs_filtered_value / 3.0, 0.0, 1.0);
    float pigment_in_them = metal::mix(washes, wet, 0.35);
    PaperGrain tooth_of_the_paper = paper_grain_2(pigment_in_them, paper_that_goes_along.place,
        paper_that_goes_along.stretch, 260.0, 0.2, 0.6, 0, look.viewport);
    Color indigo_to_warm_paper_2 = ramp_at(indigo_to_warm_paper, bounded(tooth_of_the_paper.tone),
        footprint_of(tooth_of_the_paper.tone));
    metal::float4 output_alpha = metal::float4(indigo_to_warm_paper_2.xyz,
        metal::clamp(indigo_to_warm_paper_2.w, 0.0, 1.0));
    return output(premultiplied(output_alpha));
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 normal [[user(loc0), center_perspective]];
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
    const Varyings in = { clip, varyings_1.normal };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float3 anchor_on_screen_value = anchor_on_screen((view.camera_from_world
        * metal::float4(object.world_from_object[3].xyz, 1.0)).xyz, view.eye.w,
        metal::length(metal::float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = Surface {normal, in.clip.xy * view.screen.xy + view.screen.zw, {},
        anchor_on_screen_value};
    return fs_mainOutput { finite_vec4(shade(surface, look)) };
}
