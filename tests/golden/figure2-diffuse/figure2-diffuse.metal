// Diffuse parametrization: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// figure2-diffuse.json says what to put there and how to draw.
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
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
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

struct type_5 {
    metal::float4 inner[16];
};

struct type_6 {
    metal::float4 inner[4];
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    type_5 colors;
    /// Places of the stops, in increasing order, four to a vector.
    type_6 places;
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
    char _pad4[8];
};

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 normal;
};

constant float HALF_PI = 1.5707964;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant Ramp color_code = Ramp {type_5 {{metal::float4(1.0, 0.9686, 0.8392, 1.0),
    metal::float4(1.0, 0.8196, 0.4, 1.0), metal::float4(0.9529, 0.4471, 0.1725, 1.0),
    metal::float4(0.7843, 0.1961, 0.3529, 1.0), metal::float4(0.4157, 0.1725, 0.549, 1.0),
    metal::float4(0.1529, 0.2039, 0.4353, 1.0), metal::float4(0.0431, 0.0627, 0.149, 1.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, type_6 {{metal::float4(0.0, 0.1, 0.22, 0.36),
    metal::float4(0.52, 0.72, 1.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 7u, 1u};

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

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
float atan2_positive(
    float y,
    float x
) {
    float small = metal::min(y, x);
    float large = metal::max(y, x);
    if (large <= 0.0) {
        return 0.0;
    }
    float t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    bool is_wide = t > 0.41421357;
    float r = is_wide ? (small - large) / (small + large) : t;
    float r2 = r * r;
    float series = r * (1.0 + r2 * (-0.33333334 + r2
        * (0.2 + r2 * (-0.14285715 + r2
        * (0.11111111 + r2 * (-0.09090909 + r2
        * (0.07692308 + r2 * (-0.06666667 + r2 * 0.05882353))))))));
    float a = is_wide ? series + 0.7853982 : series;
    return y > x ? HALF_PI - a : a;
}

/// The angle u in radians.
float angle_radians(
    Angle u
) {
    return 2.0 * atan2_positive(u.half_sin, u.half_cos);
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
    return metal::sqrt(metal::dot(d, d));
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
    type_5 colors = {};
    type_6 places = {};
    uint at = 0u;
    metal::float4 from_a = metal::float4(0.0);
    metal::float4 to_b = metal::float4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    for (uint i_2 = 1u; i_2 < 7u; i_2++) {
        float places_now = places.inner[naga_div(i_2, 4u)][naga_mod(i_2, 4u)];
        at = places_now <= x ? i_2 : at;
    }
    float place = places.inner[naga_div(at, 4u)][naga_mod(at, 4u)];
    if ((at + 1u >= 7u) | (x <= place)) {
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
    if (after + 1u < 7u) {
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


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Parametrization
    Angle angle = Angle {0.5 * metal::length(surface.normal - look.key.direction), 0.5
        * metal::length(surface.normal + look.key.direction)};
    float angle_over_pi = angle_radians(angle) / 3.1415927;
    Color color_code_2 = ramp_at(color_code, angle_over_pi, footprint_of(angle_over_pi));
    metal::float4 output_alpha = metal::float4(color_code_2.xyz,
        metal::clamp(color_code_2.w, 0.0, 1.0));
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
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.normal };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal};
    return fs_mainOutput { finite_vec4(shade(surface, look)) };
}
