// Watercolor wash: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// watercolor-wash.json says what to put there and how to draw.
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
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint NOISE_PERLIN = 1u;
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant Ramp two_pigments = Ramp {type_6 {{metal::float4(0.1843, 0.4353, 0.5608, 1.0), metal::float4(0.2471, 0.6039, 0.5255, 1.0), metal::float4(0.7882, 0.6353, 0.2353, 1.0), metal::float4(0.8471, 0.451, 0.3529, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.45, 0.75, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 4u, 1u};

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

metal::float3 bounded_vec3_(
    metal::float3 v_3
) {
    metal::uint3 bits_2 = as_type<metal::uint3>(v_3);
    metal::uint3 magnitude_1 = bits_2 & metal::uint3(2147483647u);
    metal::float3 largest_1 = as_type<metal::float3>((bits_2 & metal::uint3(2147483648u)) | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest_1, magnitude_1 == metal::uint3(2139095040u));
    return metal::select(numbers, v_3, magnitude_1 < metal::uint3(2139095040u));
}

metal::float4 bounded_vec4_(
    metal::float4 v_4
) {
    metal::uint4 bits_3 = as_type<metal::uint4>(v_4);
    metal::uint4 magnitude_2 = bits_3 & metal::uint4(2147483647u);
    metal::float4 largest_2 = as_type<metal::float4>((bits_3 & metal::uint4(2147483648u)) | metal::uint4(2139095039u));
    metal::float4 numbers_1 = metal::select(metal::float4(0.0), largest_2, magnitude_2 == metal::uint4(2139095040u));
    return metal::select(numbers_1, v_4, magnitude_2 < metal::uint4(2139095040u));
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

metal::float3 mixed_vec3_(
    metal::float3 a_1,
    metal::float3 b_1,
    float t
) {
    metal::float3 _e4 = bounded_vec3_(b_1 - a_1);
    metal::float3 _e14 = bounded_vec3_((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4)));
    return _e14;
}

metal::float3 mixed_vec3_2_(
    metal::float3 a_2,
    metal::float3 b_2,
    float t_1
) {
    metal::float3 d_1 = b_2 - a_2;
    metal::float3 _e13 = bounded_vec3_((t_1 < 0.5) ? (a_2 + (t_1 * d_1)) : (b_2 - ((1.0 - t_1) * d_1)));
    return _e13;
}

metal::float4 mixed_vec4_(
    metal::float4 a_3,
    metal::float4 b_3,
    float t_2
) {
    metal::float4 _e4 = bounded_vec4_(b_3 - a_3);
    metal::float4 _e14 = bounded_vec4_((t_2 < 0.5) ? (a_3 + (t_2 * _e4)) : (b_3 - ((1.0 - t_2) * _e4)));
    return _e14;
}

float eased(
    float x_2,
    float low,
    float high
) {
    float _e3 = bounded(x_2);
    float _e7 = bounded((_e3 - low) / 0.5);
    float t_5 = metal::clamp(_e7, 0.0, 1.0);
    return (t_5 * t_5) * (3.0 - (2.0 * t_5));
}

float eased_2_(
    float x_3,
    float low_1,
    float high_1
) {
    float t_6 = metal::clamp((x_3 - low_1) / (high_1 - low_1), 0.0, 1.0);
    return (t_6 * t_6) * (3.0 - (2.0 * t_6));
}

float footprint_of(
    float x_4
) {
    float _e1 = metal::dfdx(x_4);
    float _e2 = metal::dfdy(x_4);
    metal::float2 d_2 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_2, d_2));
}

float footprint_of_vec3_(
    metal::float3 v_5
) {
    metal::float3 dx = metal::dfdx(v_5);
    metal::float3 dy = metal::dfdy(v_5);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy))));
    return _e7;
}

metal::float4 color_mixed(
    metal::float4 a_4,
    metal::float3 blended,
    float factor
) {
    metal::float3 _e4 = bounded_vec3_(a_4.xyz);
    metal::float3 _e5 = bounded_vec3_(blended);
    metal::float3 _e7 = bounded_vec3_(_e5 - _e4);
    metal::float3 _e10 = bounded_vec3_(_e4 + (factor * _e7));
    return metal::float4(_e10, 1.0);
}

metal::float4 hermite(
    metal::float4 a_5,
    metal::float4 b_4,
    metal::float4 from_a,
    metal::float4 to_b,
    float t_3
) {
    metal::float4 d_3 = b_4 - a_5;
    return a_5 + (t_3 * (from_a + (t_3 * ((((3.0 * d_3) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_3)))))));
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

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

Color ramp_at(
    Ramp ramp,
    float x_5,
    float w
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
            uint _e25 = i_2_;
            i_2_ = _e25 + 1u;
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 4u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e18 = i_2_;
        float _e22 = places.inner[0][naga_mod(_e18, 4u)];
        at = (_e22 <= x_5) ? _e16 : _e15;
    }
    uint _e29 = at;
    float place_4 = places.inner[0][naga_mod(_e29, 4u)];
    uint _e34 = at;
    if (((_e34 + 1u) >= 4u) | (x_5 <= place_4)) {
        uint _e41 = at;
        metal::float4 _e43 = colors.inner[_e41];
        return _e43;
    }
    uint _e44 = at;
    uint after_1 = _e44 + 1u;
    float _e53 = places.inner[naga_div(after_1, 4u)][naga_mod(after_1, 4u)];
    float span = _e53 - place_4;
    float _e56 = divided(x_5 - place_4, span);
    float t_7 = metal::clamp(_e56, 0.0, 1.0);
    uint _e63 = at;
    if (_e63 > 0u) {
        uint _e66 = at;
        uint _e72 = at;
        float before_1 = places.inner[naga_div(_e66 - 1u, 4u)][naga_mod(_e72 - 1u, 4u)];
        uint _e79 = at;
        metal::float4 _e81 = colors.inner[_e79];
        uint _e82 = at;
        metal::float4 _e86 = colors.inner[_e82 - 1u];
        metal::float4 _e90 = colors.inner[after_1];
        uint _e91 = at;
        metal::float4 _e93 = colors.inner[_e91];
        metal::float4 _e95 = ramp_slope(_e81 - _e86, place_4 - before_1, _e90 - _e93, span);
        from_a_1 = _e95;
    }
    if ((after_1 + 1u) < 4u) {
        float _e113 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e113 - (place_4 + span);
        metal::float4 _e117 = colors.inner[after_1];
        uint _e118 = at;
        metal::float4 _e120 = colors.inner[_e118];
        metal::float4 _e125 = colors.inner[after_1 + 1u];
        metal::float4 _e127 = colors.inner[after_1];
        metal::float4 _e129 = ramp_slope(_e117 - _e120, span, _e125 - _e127, next);
        to_b_1 = _e129;
    }
    uint _e130 = at;
    metal::float4 _e132 = colors.inner[_e130];
    metal::float4 _e134 = colors.inner[after_1];
    metal::float4 _e135 = from_a_1;
    metal::float4 _e137 = to_b_1;
    metal::float4 _e139 = hermite(_e132, _e134, span * _e135, span * _e137, t_7);
    metal::float4 _e140 = bounded_vec4_(_e139);
    return _e140;
}

Color mix_colors_multiply(
    Color a_6,
    Color b_5,
    float factor_1
) {
    metal::float3 _e7 = mixed_vec3_2_(a_6.xyz, a_6.xyz * b_5.xyz, factor_1);
    return metal::float4(_e7, 1.0);
}

Color mix_colors_multiply_2_(
    Color a_7,
    Color b_6,
    float factor_2
) {
    metal::float3 blended_1 = a_7.xyz * b_6.xyz;
    metal::float3 _e7 = bounded_vec3_(a_7.xyz);
    metal::float3 _e9 = bounded_vec3_(blended_1 - _e7);
    float _e14 = bounded(a_7.w);
    return metal::float4(blended_1 - (0.25 * _e9), _e14);
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_6 = {};
    v_6 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = _e8 + (_e10 * _e12);
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = _e16 + (_e18 * _e20);
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_6;
    metal::uint3 _e32 = v_6;
    v_6 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = _e38 + (_e40 * _e42);
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = _e46 + (_e48 * _e50);
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_6;
    return _e61;
}

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a_8 = (axis == 0u) ? d.y : d.x;
    float b_7 = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a_8 : -(a_8)) + (((hash.z >> 31u) == 0u) ? b_7 : -(b_7));
}

metal::float3 fade_quintic(
    metal::float3 t_4
) {
    return ((t_4 * t_4) * t_4) * ((t_4 * ((t_4 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(
    metal::float3 p,
    uint seed_2
) {
    float sum = 0.0;
    int i = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_4 = p - corner;
    metal::float3 _e4 = fade_quintic(d_4);
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e46 = i;
            i = as_type<int>(as_type<uint>(_e46) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e10 = i;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            metal::int3 at_2 = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at_2 == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at_2)), seed_2);
            float _e42 = gradient_dot(_e39, d_4 - static_cast<metal::float3>(at_2));
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e42);
        }
    }
    float _e48 = sum;
    return metal::clamp(0.5 + (0.48244 * _e48), 0.0, 1.0);
}

float perlin_noise_2_(
    metal::float3 p_1,
    uint seed_3
) {
    int i_1 = 0;
    float sum_1 = 0.0;
    metal::float3 corner_1 = metal::floor(p_1);
    metal::float3 d_5 = p_1 - corner_1;
    metal::float3 f = ((d_5 * d_5) * d_5) * ((d_5 * ((d_5 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
    metal::int3 cell_2 = naga_f2i32(corner_1);
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e64 = i_1;
            i_1 = as_type<int>(as_type<uint>(_e64) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e21 = i_1;
        if (!((_e21 < 8))) {
            break;
        }
        int _e25 = i_1;
        int _e28 = i_1;
        int _e33 = i_1;
        metal::int3 at_3 = metal::int3(_e25 & 1, (_e28 >> 1u) & 1, _e33 >> 2u);
        metal::float3 weight_1 = metal::select(metal::float3(1.0) - f, f, at_3 == metal::int3(1));
        float _e44 = sum_1;
        metal::uint3 _e58 = hash_pcg3d(as_type<metal::uint3>(as_type<metal::int3>(as_type<metal::uint3>(cell_2) + as_type<metal::uint3>(at_3))) + (seed_3 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
        float _e61 = gradient_dot(_e58, d_5 - static_cast<metal::float3>(at_3));
        sum_1 = _e44 + (((weight_1.x * weight_1.y) * 0.5) * _e61);
    }
    float _e67 = sum_1;
    return metal::clamp(0.5 + (0.48244 * _e67), 0.0, 1.0);
}

float fractal_noise(
    uint kind,
    metal::float3 p_2,
    int octaves,
    float roughness,
    int seed_4,
    float w_1
) {
    float octave = {};
    int i_2 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_2 = 0.0;
    uint2 loop_bound_3 = uint2(4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (metal::all(loop_bound_3 == uint2(0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e66 = i_2;
            i_2 = as_type<int>(as_type<uint>(_e66) + as_type<uint>(1));
        }
        loop_init_3 = false;
        int _e17 = i_2;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased(w_1 * _e21, 0.5, 1.0);
        float visible = 1.0 - _e25;
        octave = 0.5;
        if (visible > 0.0) {
            float _e31 = frequency;
            int _e33 = i_2;
            metal::float3 place_5 = metal::clamp((p_2 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_2;
            float _e50 = perlin_noise(place_5, 11u + static_cast<uint>(_e47));
            octave = metal::mix(0.5, _e50, visible);
        }
        float _e53 = sum_2;
        float _e54 = strength;
        float _e55 = octave;
        sum_2 = _e53 + (_e54 * _e55);
        float _e58 = total;
        float _e59 = strength;
        total = _e58 + _e59;
        float _e61 = strength;
        strength = _e61 * roughness;
        float _e63 = frequency;
        frequency = _e63 * 2.0;
    }
    float _e69 = sum_2;
    return metal::min(_e69 / 1.5, 1.0);
}

float fractal_noise_2_(
    uint kind_1,
    metal::float3 p_3,
    int octaves_1,
    float roughness_1,
    int seed_5,
    float w_2
) {
    float octave_1 = {};
    int i_3 = 0;
    float frequency_1 = 1.0;
    float strength_1 = 1.0;
    float total_1 = 0.0;
    float sum_3 = 0.0;
    uint2 loop_bound_4 = uint2(4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (metal::all(loop_bound_4 == uint2(0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e66 = i_3;
            i_3 = as_type<int>(as_type<uint>(_e66) + as_type<uint>(1));
        }
        loop_init_4 = false;
        int _e17 = i_3;
        if (!((_e17 < 4))) {
            break;
        }
        float _e21 = frequency_1;
        float _e25 = eased(w_2 * _e21, 0.5, 1.0);
        float visible_1 = 1.0 - _e25;
        octave_1 = 0.5;
        if (visible_1 > 0.0) {
            float _e31 = frequency_1;
            int _e33 = i_3;
            metal::float3 place_6 = metal::clamp((p_3 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_3;
            float _e50 = perlin_noise(place_6, 0u + static_cast<uint>(_e47));
            octave_1 = metal::mix(0.5, _e50, visible_1);
        }
        float _e53 = sum_3;
        float _e54 = strength_1;
        float _e55 = octave_1;
        sum_3 = _e53 + (_e54 * _e55);
        float _e58 = total_1;
        float _e59 = strength_1;
        total_1 = _e58 + _e59;
        float _e61 = strength_1;
        strength_1 = _e61 * roughness_1;
        float _e63 = frequency_1;
        frequency_1 = _e63 * 2.0;
    }
    float _e69 = sum_3;
    float _e70 = total_1;
    return metal::min(_e69 / _e70, 1.0);
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
    metal::float3 x_6 = (turn.y * along) + (turn.x * across);
    metal::float3 y = (turn.y * across) - (turn.x * along);
    metal::float2 turned = metal::float2((turn.y * place.x) + (turn.x * place.y), (turn.y * place.y) - (turn.x * place.x));
    metal::float3 stretch_3 = metal::float3(metal::dot(x_6, x_6), metal::dot(x_6, y), metal::dot(y, y));
    return StretchedPlace {turned, {}, stretch_3};
}

SpacedPlace spaced(
    metal::float2 place_1,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count
) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_4 = is_pixel ? (count / metal::max(viewport_1.y, 1.0)) : count;
    metal::float2 p_4 = metal::clamp(place_1 * scale_4, metal::float2(-4194304.0), metal::float2(4194304.0));
    return SpacedPlace {p_4, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : stretch};
}

float area_square(
    metal::float3 stretch_1
) {
    float sum_4 = stretch_1.x + stretch_1.z;
    return metal::max((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y), (sum_4 * sum_4) / 66.0);
}

MarkPlace mark_place_object(
    float angle_1,
    metal::float3 anchor,
    metal::float2 pixel_1,
    metal::float2 viewport_2
) {
    float size = metal::clamp(anchor.z, 0.000001, 1000000.0);
    metal::float2 _e8 = place_in_picture(pixel_1, viewport_2);
    metal::float2 place_7 = (_e8 - metal::float2(anchor.x, -(anchor.y))) / metal::float2(size);
    StretchedPlace _e26 = mark_place_of(place_7, metal::float3(1.0 / size, 0.0, 0.0), metal::float3(0.0, 1.0 / size, 0.0), angle_1);
    return MarkPlace {_e26.place, {}, _e26.stretch};
}

float paper_octave(
    metal::float2 place_2,
    int zoom,
    float w_3,
    float fiber,
    uint seed_6
) {
    float scale_5 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom) + as_type<uint>(127))) << 23u);
    metal::float2 p_5 = metal::clamp(place_2 * scale_5, metal::float2(-4194304.0), metal::float2(4194304.0));
    uint own = seed_6 + (7u * as_type<uint>(zoom));
    float _e23 = perlin_noise_2_(metal::float3(p_5, 0.5), own);
    float grain = _e23 - 0.5;
    metal::float2 q = metal::clamp(2.7 * metal::float2((0.8 * p_5.x) - (0.6 * p_5.y), (0.6 * p_5.x) + (0.8 * p_5.y)), metal::float2(-4194304.0), metal::float2(4194304.0));
    float _e52 = perlin_noise_2_(metal::float3(q, 0.5), own + 1u);
    float felt = _e52 - 0.5;
    float coarse_seen = 1.0 - metal::smoothstep(0.5, 1.0, w_3 * scale_5);
    float felt_seen = 1.0 - metal::smoothstep(0.5, 1.0, (2.7 * w_3) * scale_5);
    return metal::clamp(0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt))), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float paper_height(
    SpacedPlace at_1,
    float fiber_1,
    uint seed_7
) {
    float height = {};
    metal::float2 x_7 = metal::dfdx(at_1.place);
    metal::float2 y_1 = metal::dfdy(at_1.place);
    float w_4 = metal::sqrt(metal::max(metal::dot(x_7, x_7), metal::dot(y_1, y_1)));
    float _e12 = area_square(at_1.stretch);
    float _e16 = log2_stable(metal::max(metal::sqrt(_e12), 0.000000000000000000000000000001));
    float level = metal::clamp(-0.5 * _e16, -16.0, 16.0);
    float zoom_1 = metal::floor(level);
    float f_1 = level - zoom_1;
    float _e26 = paper_octave(at_1.place, naga_f2i32(zoom_1), w_4, fiber_1, seed_7);
    height = _e26;
    if (f_1 > 0.0) {
        float _e30 = height;
        float _e35 = paper_octave(at_1.place, as_type<int>(as_type<uint>(naga_f2i32(zoom_1)) + as_type<uint>(1)), w_4, fiber_1, seed_7);
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
    float count_1,
    float tooth,
    float fiber_2,
    int seed_8,
    metal::float2 viewport_3
) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    float _e10 = paper_height(_e8, fiber_2, 0u);
    return PaperGrain {1.0 - metal::clamp(0.5 + ((((8.0 * tooth) * (_e10 - 0.5)) * 0.5) * 0.5), 0.0, 1.0), _e10};
}

float outer_contour(
    float width,
    metal::float3 normal,
    metal::float3 view,
    metal::float2 viewport_4
) {
    float facing = metal::clamp(metal::dot(normal, view), 0.0, 1.0);
    float pixels = (width * metal::clamp(viewport_4.y, 1.0, 100000.0)) / 1000.0;
    float _e15 = footprint_of(facing);
    float distance = facing / metal::max(2.0 * _e15, 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp((pixels + 0.5) - distance, 0.0, metal::min(pixels, 1.0)) * near;
}

float noise_perlin(
    metal::float3 position,
    float scale_2,
    int octaves_2,
    float roughness_2,
    int seed_9
) {
    metal::float3 p_6 = position * scale_2;
    float _e7 = footprint_of_vec3_(p_6);
    float _e8 = fractal_noise(NOISE_PERLIN, p_6, octaves_2, roughness_2, seed_9, _e7);
    return _e8;
}

float noise_perlin_2_(
    metal::float3 position_1,
    float scale_3,
    int octaves_3,
    float roughness_3,
    int seed_10
) {
    metal::float3 p_7 = position_1 * scale_3;
    float _e7 = footprint_of_vec3_(p_7);
    float _e8 = fractal_noise_2_(NOISE_PERLIN, p_7, octaves_3, roughness_3, seed_10, _e7);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float _e6 = noise_perlin(surface.position_object, 1.5, 2, 0.5, 11);
    float spread = metal::clamp((_e6 - 0.32) / 0.36, 0.0, 1.0);
    float _e15 = footprint_of(spread);
    Color _e16 = ramp_at(two_pigments, spread, _e15);
    metal::float3 _e21 = look.key.direction;
    float shade_2_ = metal::max((metal::dot(surface.normal, _e21) + 0.45) / 1.45, 0.0);
    float tone = metal::min((shade_2_ - 0.0) / 0.85, 1.0);
    float _e40 = noise_perlin_2_(surface.position_object, 2.2, 4, 0.55, 0);
    float how_far_it_runs = metal::mix(-0.24, 0.24, _e40 - 0.0);
    float wet_tone = tone + how_far_it_runs;
    float _e49 = eased_2_(wet_tone, 0.82, 0.7);
    float k1_ = _e49 * 0.62;
    Color _e57 = mix_colors_multiply(metal::float4(0.9843, 0.9686, 0.9255, 1.0), _e16, k1_);
    Color _e64 = mix_colors_multiply_2_(_e16, metal::float4(0.3529, 0.3098, 0.5255, 1.0), 0.75);
    float _e67 = eased_2_(wet_tone, 0.42, 0.34);
    float k2_ = _e67 * 0.6;
    metal::float3 _e71 = bounded_vec3_(_e57.xyz);
    metal::float3 _e75 = bounded_vec3_(_e57.xyz * _e64.xyz);
    metal::float3 _e76 = mixed_vec3_(_e71, _e75, k2_);
    metal::float4 second_on_the_first = metal::float4(_e76, 1.0);
    float pigment_s_rim = metal::smoothstep(0.66, 0.72, wet_tone) * _e49;
    float second_rim = metal::smoothstep(0.29, 0.34, wet_tone) * _e67;
    float k3_ = metal::max(pigment_s_rim, second_rim) * 0.34;
    metal::float4 _e93 = color_mixed(second_on_the_first, second_on_the_first.xyz * _e64.xyz, k3_);
    metal::float2 _e99 = look.viewport;
    MarkPlace _e100 = mark_place_object(0.0, surface.anchor, surface.pixel, _e99);
    metal::float2 _e110 = look.viewport;
    PaperGrain _e111 = paper_grain(0.5, _e100.place, _e100.stretch, 240.0, 0.6, 0.6, 0, _e110);
    float _e113 = bounded(_e111.tone);
    float settled_pigment = metal::mix(0.9, 1.03, _e113 - 0.0);
    metal::float4 _e123 = bounded_vec4_(_e93 * metal::float4(metal::float3(settled_pigment), 1.0));
    metal::float2 _e129 = look.viewport;
    float _e130 = outer_contour(2.2, surface.normal, surface.view, _e129);
    float soft = _e130 * 0.7;
    metal::float4 _e133 = bounded_vec4_(_e123);
    metal::float4 _e139 = mixed_vec4_(_e133, metal::float4(0.2902, 0.2588, 0.2824, 1.0), soft);
    metal::float4 _e140 = finite_vec4_(_e139);
    return _e140;
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
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_2, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
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
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_2, varyings_1.position_object, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e23 = view_1.screen;
    metal::float4 _e28 = view_1.screen;
    metal::float4x4 _e33 = view_1.camera_from_world;
    metal::float4 _e37 = object.world_from_object[3];
    float _e46 = view_1.eye.w;
    float _e51 = view_1.clip_from_world[0].y;
    float _e56 = view_1.clip_from_world[1].y;
    float _e61 = view_1.clip_from_world[2].y;
    metal::float3 _e64 = anchor_on_screen((_e33 * metal::float4(_e37.xyz, 1.0)).xyz, _e46, metal::length(metal::float3(_e51, _e56, _e61)));
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, (in.clip.xy * _e23.xy) + _e28.zw, {}, _e64};
    metal::float4 _e66 = shade(surface_1, look);
    metal::float4 _e67 = finite_vec4_(_e66);
    return fs_mainOutput { _e67 };
}
