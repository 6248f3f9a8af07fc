// Ink outlines: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0), line_nearness_map texture(1), facet_map texture(2).
// ink-outlines.json says what to put there and how to draw.
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
    metal::float3x3 camera_from_world;
    metal::float2 viewport;
    char _pad2[8];
    Light key;
    float object_id;
    char _pad4[12];
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
    metal::packed_float3 position_camera;
    float depth;
    metal::float3 curvature_tensor;
    metal::float4 line_nearness;
    metal::float2 middle_surface;
    float magnification;
    char _pad9[4];
};

typedef metal::float4 Color;
typedef metal::float4 Composite;
struct type_7 {
    metal::float4 inner[16];
};

struct type_8 {
    metal::float4 inner[4];
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    type_7 colors;
    /// Places of the stops, in increasing order, four to a vector.
    type_8 places;
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
    char _pad4[8];
};

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    metal::float4 kinds;
    /// Of borders of ids.
    float ids;
    char _pad2[12];
};

struct Outline {
    /// From 0 beside lines to 1 on them.
    float line;
    /// The line's kind where it is drawn: 1 a silhouette, 2 a crease, 3 a border of objects, 4 a
    /// border of materials, 5 a border of ids; 0 beside lines.
    float kind;
    /// To the nearest edge of a kind that is drawn, in pixels; as far as lines reach where none is
    /// near.
    float distance;
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
constant uint INTERPOLATION_SMOOTH = 1u;
constant uint INTERPOLATION_STEPPED = 2u;
constant uint NOISE_PERLIN = 1u;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
constant float MOST_ON_SCREEN = 1000000000000000.0;
/// What is no nearer than this many pixels is not near at all: less is rounding.
constant float LEAST_NEARNESS = 0.000001;
constant Ramp three_washes = Ramp {type_7 {{metal::float4(0.4353, 0.5255, 0.6588, 1.0),
    metal::float4(0.7882, 0.6471, 0.549, 1.0), metal::float4(0.949, 0.851, 0.6941, 1.0),
    metal::float4(1.0, 0.9647, 0.8784, 1.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0)}},
    type_8 {{metal::float4(0.0, 0.36, 0.54, 0.93), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, 4u, 2u};
constant Ramp ink = Ramp {type_7 {{metal::float4(0.0784, 0.102, 0.2, 1.0),
    metal::float4(0.3529, 0.1647, 0.1098, 1.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}},
    type_8 {{metal::float4(0.1, 0.85, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, 2u, 1u};

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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(
    metal::float3 v
) {
    metal::float3 dx = metal::dfdx(v);
    metal::float3 dy = metal::dfdy(v);
    return bounded(metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy))));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(
    float x,
    float edge,
    float w
) {
    float d = bounded(x - edge);
    if (w < 0.000000000000000000000000000001) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return metal::clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered_2(
    float x,
    float edge,
    float w
) {
    float d = x - edge;
    return w < 0.000000000000000000000000000001 ? (d >= 0.0 ? 1.0 : 0.0) : metal::clamp(0.5 + d / w,
        0.0, 1.0);
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
    type_7 colors = {};
    type_8 places = {};
    metal::float4 color = {};
    uint i = 1u;
    uint at = 0u;
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    metal::float4 from_a = metal::float4(0.0);
    metal::float4 to_b = metal::float4(0.0);
    uint count = metal::min(ramp.count, 16u);
    if (count == 0u) {
        return metal::float4(0.0);
    }
    colors = ramp.colors;
    places = ramp.places;
    if (ramp.interpolation == INTERPOLATION_STEPPED) {
        color = colors.inner[0];
        for (; i < count; i++) {
            float step_filtered_value = step_filtered(x,
                places.inner[naga_div(i, 4u)][naga_mod(i, 4u)], w);
            color = color + (colors.inner[i] - colors.inner[i - 1u]) * step_filtered_value;
        }
        return bounded_vec4(color);
    }
    for (uint i_1 = 1u; i_1 < count; i_1++) {
        float places_now = places.inner[naga_div(i_1, 4u)][naga_mod(i_1, 4u)];
        at = places_now <= x ? i_1 : at;
    }
    float place = places.inner[naga_div(at, 4u)][naga_mod(at, 4u)];
    if ((at + 1u >= count) | (x <= place)) {
        return bounded_vec4(colors.inner[at]);
    }
    uint after = at + 1u;
    float span = places.inner[naga_div(after, 4u)][naga_mod(after, 4u)] - place;
    float t = metal::clamp(divided(x - place, span), 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        return mixed_vec4(colors.inner[at], colors.inner[after], t);
    }
    if (at > 0u) {
        float before = places.inner[naga_div(at - 1u, 4u)][naga_mod(at - 1u, 4u)];
        metal::float4 ramp_slope_value = ramp_slope(colors.inner[at] - colors.inner[at - 1u],
            place - before, colors.inner[after] - colors.inner[at], span);
        from_a = ramp_slope_value;
    }
    if (after + 1u < count) {
        float next = places.inner[naga_div(after + 1u, 4u)][naga_mod(after + 1u, 4u)]
            - (place + span);
        to_b = ramp_slope(colors.inner[after] - colors.inner[at], span, colors.inner[after + 1u]
            - colors.inner[after], next);
    }
    return bounded_vec4(hermite(colors.inner[at], colors.inner[after], span * from_a, span * to_b,
        t));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
Color ramp_at_2(
    Ramp ramp,
    float x,
    float w
) {
    type_7 colors = {};
    type_8 places = {};
    metal::float4 color = {};
    colors = ramp.colors;
    places = ramp.places;
    color = colors.inner[0];
    for (uint i = 1u; i < 4u; i++) {
        float step_filtered_2_value = step_filtered_2(x, places.inner[0][naga_mod(i, 4u)], w);
        color = color + (colors.inner[i] - colors.inner[i - 1u]) * step_filtered_2_value;
    }
    return color;
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

/// The number of an object in texels, from 1 on.
float object_number(
    float object
) {
    return object - 4096.0 * metal::floor(object / 4096.0) + 1.0;
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

float reflectance_half_lambert(
    Light light,
    metal::float3 normal
) {
    float half_ = 0.5 + 0.5 * metal::dot(normal, light.direction);
    return metal::min(half_ * half_, 1.0);
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
metal::float4 own_nearness(
    metal::float4 nearness,
    metal::float2 middle,
    float depth,
    float object,
    float pixels,
    float reach
) {
    bool local = {};
    bool local_1 = {};
    bool is_same_object = middle.y == object_number(object);
    float behind = (depth - middle.x) * pixels;
    if (!(metal::abs(middle.y) < 0.5)) {
        if (is_same_object) {
            local_1 = metal::abs(behind) <= 8.0625;
        } else {
            local_1 = false;
        }
        local = local_1;
    } else {
        local = true;
    }
    // Slivers of the same surface are seen on the planes of their own triangles. Bounds are none of
    // the round numbers that depths of things put together by hand have.
    bool is_own = local;
    bool is_in_front = behind < (is_same_object ? -8.0625 : -2.0625);
    metal::float4 other = metal::float4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths(
    float width,
    metal::float4 shares,
    float ids
) {
    metal::float4 widths = metal::min(width, 10000.0) * shares;
    return LineWidths {metal::select(metal::float4(0.0), widths, widths > metal::float4(0.000001)),
        0.0};
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
float inner_line_covers(
    float distance,
    float width
) {
    return metal::clamp(width + 0.5 - distance, 0.0, metal::min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
metal::float4 middle_line_covers(
    metal::float4 distance,
    metal::float4 width
) {
    metal::float4 half_ = 0.5 * width;
    return metal::clamp(metal::min(distance + metal::float4(0.5), half_)
        - metal::max(distance - metal::float4(0.5), -half_), metal::float4(0.0),
        metal::float4(1.0));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
metal::float4 lines_cover(
    metal::float4 nearness,
    metal::float4 widths,
    float reach
) {
    metal::float4 distance = metal::float4(reach) - nearness;
    metal::float4 covers = metal::float4(inner_line_covers(distance.x, widths.x),
        middle_line_covers(distance, widths).yzw);
    return metal::select(metal::float4(0.0), covers, nearness > metal::float4(0.000001));
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
float inner_contour_suggestive(
    float width,
    float limit,
    float softness,
    metal::float3 tensor,
    metal::float3 normal,
    metal::float3 view,
    metal::float3x3 camera_from_world,
    metal::float3 place,
    metal::float2 viewport
) {
    metal::float3 n = camera_from_world * normal;
    float square = metal::dot(n.xy, n.xy);
    float radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / metal::max(square, 0.000001);
    metal::float2 change = metal::float2(metal::dfdx(radial), metal::dfdy(radial));
    metal::float3 v = camera_from_world * view;
    metal::float3 row = metal::dfdy(place);
    float up = (row - metal::dot(row, v) * v).y >= 0.0 ? 1.0 : -1.0;
    float height = metal::clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(change.x * n.x + up * change.y * n.y)
        * metal::rsqrt(metal::max(square, 0.000001));
    float pixels = 0.5 * width * height / 1000.0;
    float distance = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float x = toward_eye * height * 0.05;
    float footprint_of_value = footprint_of(x);
    float strength = metal::clamp(0.5 + (x - limit)
        / metal::length(metal::float2(metal::min(footprint_of_value, 1000000000000000.0), 24.0)),
        0.0, 1.0);
    return metal::clamp(pixels + 0.5 - distance, 0.0, metal::min(pixels, 1.0)) * strength
        * metal::smoothstep(0.05, 0.3, metal::dot(normal, view));
}

Outline drawn_outline(
    LineWidths line_widths,
    metal::float4 of_edges,
    float reach
) {
    float kind = {};
    metal::float4 signed_ = metal::clamp(of_edges, metal::float4(-reach), metal::float4(reach));
    metal::float4 nearness = metal::abs(signed_);
    metal::float4 widths = metal::float4(line_widths.kinds.xyz, signed_.w
        < 0.0 ? 0.0 : line_widths.kinds.w);
    metal::float4 covers = lines_cover(nearness, widths, reach);
    float line = metal::max(metal::max(covers.x, covers.y), metal::max(covers.z, covers.w));
    float least = line - 0.0009765625;
    kind = signed_.w < 0.0 ? 5.0 : 4.0;
    kind = covers.z >= least ? 3.0 : kind;
    kind = covers.y >= least ? 2.0 : kind;
    kind = covers.x >= least ? 1.0 : kind;
    metal::float4 near = metal::select(metal::float4(0.0), nearness, widths > metal::float4(0.0));
    float nearest = metal::max(metal::max(near.x, near.y), metal::max(near.z, near.w));
    return Outline {line, line > 0.0009765625 ? kind : 0.0, reach - nearest};
}

/// Outline
///
/// Ink where forms end, fold and meet, as values to be drawn in any color: silhouettes, creases,
/// borders of objects, of materials and of ids, each as wide as it is told. A silhouette is drawn
/// by what lies in front, as wide as it is; where two surfaces meet, each draws its half of the
/// line. Wire the width to a curvature, a tone or a noise and lines taper.
Outline outline_height(
    float width,
    float silhouettes,
    float creases,
    float borders,
    float material_borders,
    float id_borders,
    metal::float4 nearness,
    metal::float2 middle,
    float depth,
    float object,
    metal::float2 viewport,
    float magnification
) {
    float pixels = magnification * viewport.y;
    float reach = metal::min(16.0 * metal::max(metal::rint(viewport.y / 800.0), 1.0), 31.0);
    metal::float4 own = own_nearness(nearness, middle, depth, object, pixels, reach);
    metal::float4 shares = metal::float4(silhouettes, creases, borders, material_borders);
    LineWidths widths = line_widths(width * (0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, own, reach);
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
    float light_and_dark = reflectance_half_lambert(look.key, surface.normal);
    Color three_washes_2 = ramp_at_2(three_washes, light_and_dark, footprint_of_2(light_and_dark));
    Color ink_2 = ramp_at(ink, light_and_dark, footprint_of_2(light_and_dark));
    float heavy_in_the_shade = metal::mix(1.6, 8.0,
        metal::clamp((light_and_dark - 0.75) / -0.6, 0.0, 1.0));
    float hand = noise_perlin(surface.position_object, 3.5, 2, 0.5, 0);
    float pressure = metal::mix(0.7, 1.3, hand - 0.0);
    float width = heavy_in_the_shade * pressure;
    Outline pen = outline_height(width, 1.0, 0.6, 1.0, 0.6, 0.0, surface.line_nearness,
        surface.middle_surface, surface.depth, look.object_id, look.viewport,
        surface.magnification);
    float folds = inner_contour_suggestive(2.2, 24.0, 1.0, surface.curvature_tensor, surface.normal,
        surface.view, look.camera_from_world, surface.position_camera, look.viewport);
    float all_strokes = metal::max(pen.line, folds);
    // Mix colors
    metal::float4 ink_on_the_washes = mixed_vec4(three_washes_2, bounded_vec4(ink_2), all_strokes);
    metal::float4 output_alpha = metal::float4(ink_on_the_washes.xyz,
        metal::clamp(ink_on_the_washes.w, 0.0, 1.0));
    Color output_2 = output(premultiplied(output_alpha));
    return output_2;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position_1, varyings.normal_2 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, vertex_.position,
        object.world_from_normal * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_2 [[user(loc2), center_perspective]];
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
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> line_nearness_map [[texture(1)]]
, metal::texture2d<float, metal::access::sample> facet_map [[texture(2)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object,
        varyings_1.normal_2 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_1 = line_nearness_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_2 = facet_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_3 = facet_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    float size_on_screen_value = size_on_screen(-(view.camera_from_world
        * metal::float4(in.position, 1.0)).z, view.eye.w,
        metal::length(metal::float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, (view.camera_from_world * metal::float4(in.position, 1.0)).xyz,
        -(view.camera_from_world * metal::float4(in.position, 1.0)).z, texel.xyz, texel_1,
        metal::float2(texel_2.z, metal::floor(metal::abs(texel_3.w))), size_on_screen_value};
    return fs_mainOutput { finite_vec4(shade(surface, look)) };
}
