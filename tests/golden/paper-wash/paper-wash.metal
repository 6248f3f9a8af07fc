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
    metal::float4 eye;
    metal::float4 screen;
};
struct Object {
    metal::float4x4 world_from_object;
    metal::float3x3 world_from_normal;
    float id;
    float cutoff;
    char _pad4[8];
};
struct Light {
    metal::float3 direction;
    metal::float3 own_direction;
    metal::packed_float3 color;
    float intensity;
};
struct Look {
    metal::float2 viewport;
    char _pad1[8];
    Light key;
};
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
struct Ramp {
    type_6 colors;
    type_7 places;
    uint count;
    uint interpolation;
    char _pad4[8];
};
struct StretchedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct SpacedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct MarkPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct PaperGrain {
    float tone;
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
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant Ramp indigo_to_warm_paper = Ramp {type_6 {{metal::float4(0.13, 0.14, 0.33, 1.0), metal::float4(0.24, 0.36, 0.56, 1.0), metal::float4(0.53, 0.66, 0.72, 1.0), metal::float4(0.9, 0.8, 0.68, 1.0), metal::float4(0.975, 0.95, 0.9, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.35, 0.62, 0.82), metal::float4(1.0, 0.0, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 5u, 1u};

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

float log2_stable(
    float x
) {
    uint bits = as_type<uint>(x);
    int exponent_1 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

metal::float3 normalize_moderate(
    metal::float3 v_1,
    metal::float3 otherwise
) {
    float square = metal::dot(v_1, v_1);
    return (square > 0.000000000000000000000000000001) ? (v_1 * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen(
    metal::float3 v_2
) {
    metal::float3 _e5 = normalize_moderate(v_2, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(
    float x_1
) {
    uint bits_1 = as_type<uint>(x_1);
    uint magnitude = bits_1 & 2147483647u;
    float largest = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0);
}

metal::float4 bounded_vec4_(
    metal::float4 v_3
) {
    metal::uint4 bits_2 = as_type<metal::uint4>(v_3);
    metal::uint4 magnitude_1 = bits_2 & metal::uint4(2147483647u);
    metal::float4 largest_1 = as_type<metal::float4>((bits_2 & metal::uint4(2147483648u)) | metal::uint4(2139095039u));
    metal::float4 numbers = metal::select(metal::float4(0.0), largest_1, magnitude_1 == metal::uint4(2139095040u));
    return metal::select(numbers, v_3, magnitude_1 < metal::uint4(2139095040u));
}

float divided(
    float a,
    float b
) {
    if (metal::abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e7 = bounded(a / b);
    return _e7;
}

float footprint_of(
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d_1, d_1)));
    return _e6;
}

float footprint_of_2_(
    float x_3
) {
    float _e1 = metal::dfdx(x_3);
    float _e2 = metal::dfdy(x_3);
    metal::float2 d_2 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_2, d_2));
}

float stairs_integral(
    float x_4,
    float count
) {
    float inside = metal::min(x_4, count);
    float stair = metal::min(metal::floor(inside), 3.0);
    float beyond = metal::max(x_4 - count, 0.0);
    return (stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * 3.0);
}

float stairs_integral_2_(
    float x_5,
    float count_1
) {
    float inside_1 = metal::max(x_5, 0.0);
    float stair_1 = metal::floor(inside_1);
    return (stair_1 * (((0.5 * (stair_1 - 1.0)) + inside_1) - stair_1)) + 0.0;
}

float stairs_filtered(
    float x_6,
    float count_2,
    float w
) {
    if (w <= 1.0) {
        float edge = metal::clamp(metal::rint(x_6), 1.0, 3.0);
        return (edge - 1.0) + metal::clamp(0.5 + ((x_6 - edge) / w), 0.0, 1.0);
    }
    float half_ = 0.5 * w;
    float _e22 = stairs_integral(x_6 + half_, count_2);
    float _e24 = stairs_integral_2_(x_6 - half_, count_2);
    return (_e22 - _e24) / (2.0 * half_);
}

metal::float4 hermite(
    metal::float4 a_1,
    metal::float4 b_1,
    metal::float4 from_a,
    metal::float4 to_b,
    float t
) {
    metal::float4 d_3 = b_1 - a_1;
    return a_1 + (t * (from_a + (t * ((((3.0 * d_3) - (2.0 * from_a)) - to_b) + (t * ((from_a + to_b) - (2.0 * d_3)))))));
}

float harmonic_slope(
    float before,
    float span_before,
    float after,
    float span_after
) {
    if ((before * after) <= 0.0) {
        return 0.0;
    }
    float weight_before = (2.0 * span_after) + span_before;
    float weight_after = span_after + (2.0 * span_before);
    float _e18 = divided(weight_before + weight_after, (weight_before / before) + (weight_after / after));
    return _e18;
}

metal::float4 ramp_slope(
    metal::float4 rise_before,
    float span_before_1,
    metal::float4 rise_after,
    float span_after_1
) {
    float _e5 = divided(rise_before.x, span_before_1);
    float _e7 = divided(rise_after.x, span_after_1);
    float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    float _e10 = divided(rise_before.y, span_before_1);
    float _e12 = divided(rise_after.y, span_after_1);
    float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    float _e15 = divided(rise_before.z, span_before_1);
    float _e17 = divided(rise_after.z, span_after_1);
    float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    float _e20 = divided(rise_before.w, span_before_1);
    float _e22 = divided(rise_after.w, span_after_1);
    float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return metal::float4(_e8, _e13, _e18, _e23);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

Color ramp_at(
    Ramp ramp,
    float x_7,
    float w_1
) {
    type_6 colors = {};
    type_7 places = {};
    uint i_2_ = 1u;
    uint at = 0u;
    metal::float4 from_a_1 = metal::float4(0.0);
    metal::float4 to_b_1 = metal::float4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e28 = i_2_;
            i_2_ = _e28 + 1u;
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 5u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e17 = i_2_;
        uint _e21 = i_2_;
        float _e25 = places.inner[naga_div(_e17, 4u)][naga_mod(_e21, 4u)];
        at = (_e25 <= x_7) ? _e16 : _e15;
    }
    uint _e31 = at;
    uint _e35 = at;
    float place_5 = places.inner[naga_div(_e31, 4u)][naga_mod(_e35, 4u)];
    uint _e40 = at;
    if (((_e40 + 1u) >= 5u) | (x_7 <= place_5)) {
        uint _e47 = at;
        metal::float4 _e49 = colors.inner[_e47];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = _e50 + 1u;
    float _e59 = places.inner[naga_div(after_1, 4u)][naga_mod(after_1, 4u)];
    float span = _e59 - place_5;
    float _e62 = divided(x_7 - place_5, span);
    float t_1 = metal::clamp(_e62, 0.0, 1.0);
    uint _e69 = at;
    if (_e69 > 0u) {
        uint _e72 = at;
        uint _e78 = at;
        float before_1 = places.inner[naga_div(_e72 - 1u, 4u)][naga_mod(_e78 - 1u, 4u)];
        uint _e85 = at;
        metal::float4 _e87 = colors.inner[_e85];
        uint _e88 = at;
        metal::float4 _e92 = colors.inner[_e88 - 1u];
        metal::float4 _e96 = colors.inner[after_1];
        uint _e97 = at;
        metal::float4 _e99 = colors.inner[_e97];
        metal::float4 _e101 = ramp_slope(_e87 - _e92, place_5 - before_1, _e96 - _e99, span);
        from_a_1 = _e101;
    }
    if ((after_1 + 1u) < 5u) {
        float _e119 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e119 - (place_5 + span);
        metal::float4 _e123 = colors.inner[after_1];
        uint _e124 = at;
        metal::float4 _e126 = colors.inner[_e124];
        metal::float4 _e131 = colors.inner[after_1 + 1u];
        metal::float4 _e133 = colors.inner[after_1];
        metal::float4 _e135 = ramp_slope(_e123 - _e126, span, _e131 - _e133, next);
        to_b_1 = _e135;
    }
    uint _e136 = at;
    metal::float4 _e138 = colors.inner[_e136];
    metal::float4 _e140 = colors.inner[after_1];
    metal::float4 _e141 = from_a_1;
    metal::float4 _e143 = to_b_1;
    metal::float4 _e145 = hermite(_e138, _e140, span * _e141, span * _e143, t_1);
    metal::float4 _e146 = bounded_vec4_(_e145);
    return _e146;
}

Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

Color output(
    Composite color_1
) {
    Color _e1 = straight(color_1);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_4 = {};
    v_4 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_4.x;
    uint _e10 = v_4.y;
    uint _e12 = v_4.z;
    v_4.x = _e8 + (_e10 * _e12);
    uint _e16 = v_4.y;
    uint _e18 = v_4.z;
    uint _e20 = v_4.x;
    v_4.y = _e16 + (_e18 * _e20);
    uint _e24 = v_4.z;
    uint _e26 = v_4.x;
    uint _e28 = v_4.y;
    v_4.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_4;
    metal::uint3 _e32 = v_4;
    v_4 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_4.x;
    uint _e40 = v_4.y;
    uint _e42 = v_4.z;
    v_4.x = _e38 + (_e40 * _e42);
    uint _e46 = v_4.y;
    uint _e48 = v_4.z;
    uint _e50 = v_4.x;
    v_4.y = _e46 + (_e48 * _e50);
    uint _e54 = v_4.z;
    uint _e56 = v_4.x;
    uint _e58 = v_4.y;
    v_4.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_4;
    return _e61;
}

float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a_2 = (axis == 0u) ? d.y : d.x;
    float b_2 = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a_2 : -(a_2)) + (((hash.z >> 31u) == 0u) ? b_2 : -(b_2));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(
    metal::float3 p,
    uint seed_1
) {
    int i = 0;
    float sum = 0.0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_4 = p - corner;
    metal::float3 f = ((d_4 * d_4) * d_4) * ((d_4 * ((d_4 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
    metal::int3 cell = naga_f2i32(corner);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e64 = i;
            i = as_type<int>(as_type<uint>(_e64) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e21 = i;
        if (!((_e21 < 8))) {
            break;
        }
        int _e25 = i;
        int _e28 = i;
        int _e33 = i;
        metal::int3 at_2 = metal::int3(_e25 & 1, (_e28 >> 1u) & 1, _e33 >> 2u);
        metal::float3 weight = metal::select(metal::float3(1.0) - f, f, at_2 == metal::int3(1));
        float _e44 = sum;
        metal::uint3 _e58 = hash_pcg3d(as_type<metal::uint3>(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at_2))) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
        float _e61 = gradient_dot(_e58, d_4 - static_cast<metal::float3>(at_2));
        sum = _e44 + (((weight.x * weight.y) * 0.5) * _e61);
    }
    float _e67 = sum;
    return metal::clamp(0.5 + (0.48244 * _e67), 0.0, 1.0);
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    return metal::min((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective), MOST_ON_SCREEN);
}

metal::float3 anchor_on_screen(
    metal::float3 origin,
    float perspective_1,
    float scale_1
) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return metal::clamp(metal::float3(origin.x * _e5, -(origin.y) * _e5, _e5), metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
}

metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 from_middle = pixel - (0.5 * viewport);
    return metal::float2(from_middle.x, -(from_middle.y)) / metal::float2(metal::max(viewport.y, 1.0));
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 turn = metal::float2(0.0, 1.0);
    metal::float3 x_8 = (turn.y * along) + (turn.x * across);
    metal::float3 y = (turn.y * across) - (turn.x * along);
    metal::float2 turned = metal::float2((turn.y * place.x) + (turn.x * place.y), (turn.y * place.y) - (turn.x * place.x));
    metal::float3 stretch_4 = metal::float3(metal::dot(x_8, x_8), metal::dot(x_8, y), metal::dot(y, y));
    return StretchedPlace {turned, {}, stretch_4};
}

SpacedPlace spaced(
    metal::float2 place_1,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count_3
) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = is_pixel ? (count_3 / metal::max(viewport_1.y, 1.0)) : count_3;
    metal::float2 p_1 = metal::clamp(place_1 * scale_2, metal::float2(-4194304.0), metal::float2(4194304.0));
    return SpacedPlace {p_1, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : stretch};
}

float area_square(
    metal::float3 stretch_1
) {
    float sum_1 = stretch_1.x + stretch_1.z;
    return metal::max((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y), (sum_1 * sum_1) / 66.0);
}

MarkPlace mark_place_object(
    float angle_1,
    metal::float3 anchor,
    metal::float2 pixel_1,
    metal::float2 viewport_2
) {
    float size = metal::clamp(anchor.z, 0.000001, 1000000.0);
    metal::float2 _e8 = place_in_picture(pixel_1, viewport_2);
    metal::float2 place_6 = (_e8 - metal::float2(anchor.x, -(anchor.y))) / metal::float2(size);
    StretchedPlace _e26 = mark_place_of(place_6, metal::float3(1.0 / size, 0.0, 0.0), metal::float3(0.0, 1.0 / size, 0.0), angle_1);
    return MarkPlace {_e26.place, {}, _e26.stretch};
}

float paper_octave(
    metal::float2 place_2,
    int zoom,
    float w_2,
    float fiber,
    uint seed_2
) {
    float scale_3 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom) + as_type<uint>(127))) << 23u);
    metal::float2 p_2 = metal::clamp(place_2 * scale_3, metal::float2(-4194304.0), metal::float2(4194304.0));
    uint own = seed_2 + (7u * as_type<uint>(zoom));
    float _e23 = perlin_noise(metal::float3(p_2, 0.5), own);
    float grain = _e23 - 0.5;
    metal::float2 q = metal::clamp(2.7 * metal::float2((0.8 * p_2.x) - (0.6 * p_2.y), (0.6 * p_2.x) + (0.8 * p_2.y)), metal::float2(-4194304.0), metal::float2(4194304.0));
    float _e52 = perlin_noise(metal::float3(q, 0.5), own + 1u);
    float felt = _e52 - 0.5;
    float coarse_seen = 1.0 - metal::smoothstep(0.5, 1.0, w_2 * scale_3);
    float felt_seen = 1.0 - metal::smoothstep(0.5, 1.0, (2.7 * w_2) * scale_3);
    return metal::clamp(0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt))), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float paper_height(
    SpacedPlace at_1,
    float fiber_1,
    uint seed_3
) {
    float height = {};
    metal::float2 x_9 = metal::dfdx(at_1.place);
    metal::float2 y_1 = metal::dfdy(at_1.place);
    float w_3 = metal::sqrt(metal::max(metal::dot(x_9, x_9), metal::dot(y_1, y_1)));
    float _e12 = area_square(at_1.stretch);
    float _e16 = log2_stable(metal::max(metal::sqrt(_e12), 0.000000000000000000000000000001));
    float level = metal::clamp(-0.5 * _e16, -16.0, 16.0);
    float zoom_1 = metal::floor(level);
    float f_1 = level - zoom_1;
    float _e26 = paper_octave(at_1.place, naga_f2i32(zoom_1), w_3, fiber_1, seed_3);
    height = _e26;
    if (f_1 > 0.0) {
        float _e30 = height;
        float _e35 = paper_octave(at_1.place, as_type<int>(as_type<uint>(naga_f2i32(zoom_1)) + as_type<uint>(1)), w_3, fiber_1, seed_3);
        float both = metal::mix(_e30, _e35, f_1);
        height = metal::clamp(0.5 + ((both - 0.5) / metal::sqrt((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))), 0.0, 1.0);
    }
    float _e53 = height;
    return _e53;
}

PaperGrain paper_grain(
    float value,
    metal::float2 place_3,
    metal::float3 stretch_2,
    float count_4,
    float tooth,
    float fiber_2,
    int seed_4,
    metal::float2 viewport_3
) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_4);
    float _e10 = paper_height(_e8, fiber_2, 5u);
    return PaperGrain {1.0 - metal::clamp(0.5 + (((0.0 * (_e10 - 0.5)) * 0.5) * 0.5), 0.0, 1.0), _e10};
}

PaperGrain paper_grain_2_(
    float value_1,
    metal::float2 place_4,
    metal::float3 stretch_3,
    float count_5,
    float tooth_1,
    float fiber_3,
    int seed_5,
    metal::float2 viewport_4
) {
    SpacedPlace _e8 = spaced(place_4, stretch_3, viewport_4, count_5);
    float _e10 = paper_height(_e8, fiber_3, 0u);
    float ink = 1.0 - metal::clamp(value_1, 0.0, 1.0);
    return PaperGrain {1.0 - metal::clamp(ink + ((((8.0 * tooth_1) * (_e10 - 0.5)) * ink) * (1.0 - ink)), 0.0, 1.0), _e10};
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    float light_and_shade = metal::max((metal::dot(surface.normal, _e5) + 0.5) / 1.5, 0.0);
    metal::float2 _e18 = look.viewport;
    MarkPlace _e19 = mark_place_object(0.0, surface.anchor, surface.pixel, _e18);
    metal::float2 _e29 = look.viewport;
    PaperGrain _e30 = paper_grain(0.5, _e19.place, _e19.stretch, 11.0, 0.0, 0.7, 5, _e29);
    float _e32 = bounded(_e30.height);
    float uneven_edge = metal::mix(-0.2, 0.2, _e32 - 0.0);
    float wet = light_and_shade + uneven_edge;
    float _e45 = footprint_of_2_(wet);
    float _e51 = stairs_filtered(4.0 * metal::clamp(wet, 0.0, 1.0), 4.0, metal::length(metal::float2(4.0 * _e45, 0.22)));
    float washes = metal::clamp(_e51 / 3.0, 0.0, 1.0);
    float pigment_in_them = metal::mix(washes, wet, 0.35);
    metal::float2 _e67 = look.viewport;
    PaperGrain _e68 = paper_grain_2_(pigment_in_them, _e19.place, _e19.stretch, 260.0, 0.2, 0.6, 0, _e67);
    float _e71 = bounded(_e68.tone);
    float _e73 = footprint_of(_e68.tone);
    Color _e74 = ramp_at(indigo_to_warm_paper, _e71, _e73);
    metal::float4 output_alpha = metal::float4(_e74.xyz, metal::clamp(_e74.w, 0.0, 1.0));
    Composite _e81 = premultiplied(output_alpha);
    Color _e82 = output(_e81);
    return _e82;
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
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e14 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, _e14 * vertex_.normal};
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
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    metal::float4 _e10 = view.screen;
    metal::float4 _e15 = view.screen;
    metal::float4x4 _e20 = view.camera_from_world;
    metal::float4 _e24 = object.world_from_object[3];
    float _e33 = view.eye.w;
    float _e38 = view.clip_from_world[0].y;
    float _e43 = view.clip_from_world[1].y;
    float _e48 = view.clip_from_world[2].y;
    metal::float3 _e51 = anchor_on_screen((_e20 * metal::float4(_e24.xyz, 1.0)).xyz, _e33, metal::length(metal::float3(_e38, _e43, _e48)));
    Surface surface_1 = Surface {normal, (in.clip.xy * _e10.xy) + _e15.zw, {}, _e51};
    metal::float4 _e53 = shade(surface_1, look);
    metal::float4 _e54 = finite_vec4_(_e53);
    return fs_mainOutput { _e54 };
}
