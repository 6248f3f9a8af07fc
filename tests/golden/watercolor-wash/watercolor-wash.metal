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
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint INTERPOLATION_SMOOTH = 1u;
constant uint INTERPOLATION_STEPPED = 2u;
constant uint NOISE_PERLIN = 1u;
constant uint NOISE_SIMPLEX = 2u;
constant uint NOISE_WORLEY = 3u;
constant float SIMPLEX_SCALE = 38.4553;
constant float WORLEY_MEAN = 0.5205;
constant Ramp two_pigments = Ramp {type_6 {{metal::float4(0.1843, 0.4353, 0.5608, 1.0), metal::float4(0.2471, 0.6039, 0.5255, 1.0), metal::float4(0.7882, 0.6353, 0.2353, 1.0), metal::float4(0.8471, 0.451, 0.3529, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.45, 0.75, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 4u, 1u};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

float finite_or(
    float x_1,
    float otherwise
) {
    bool _e2 = is_finite(x_1);
    return _e2 ? x_1 : otherwise;
}

metal::float3 finite_vec3_(
    metal::float3 v
) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return metal::float3(_e3, _e6, _e9);
}

metal::float4 finite_vec4_(
    metal::float4 v_1
) {
    metal::float3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return metal::float4(_e2, _e5);
}

metal::float3 normalize_or(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    bool local = {};
    float largest = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest > 0.000000000000000000000000000001) {
        local = largest < 1000000000000000000000000000000.0;
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    metal::float3 scaled = v_2 * (1.0 / largest);
    float square_1 = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square_1));
}

float power_of_two(
    int n
) {
    return as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(n) + as_type<uint>(127))) << 23u);
}

float log_stable(
    float x_2
) {
    uint bits = as_type<uint>(x_2);
    int shift = static_cast<int>((bits - 1060439283u) >> 23u);
    int exponent = (shift >= 256) ? as_type<int>(as_type<uint>(shift) - as_type<uint>(512)) : shift;
    float mantissa = as_type<float>(bits - (static_cast<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    float series = (2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111))))))));
    return (static_cast<float>(exponent) * LN_2_) + series;
}

metal::float2 sin_cos_quarter(
    float x_3
) {
    float h = 0.5 * x_3;
    float h2_ = h * h;
    float s = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s) * c, 1.0 - ((2.0 * s) * s));
}

metal::float2 sin_cos(
    float x_4
) {
    float turns = metal::rint(x_4 * 0.31830987);
    float r = ((x_4 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 0.00000062783295);
    float sign = 1.0 - (2.0 * metal::abs(turns - (2.0 * metal::trunc(turns * 0.5))));
    metal::float2 _e27 = sin_cos_quarter(metal::clamp(r, -1.5707964, HALF_PI));
    return sign * _e27;
}

float bounded(
    float x_5
) {
    uint bits_1 = as_type<uint>(x_5);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_5 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float2 bounded_vec2_(
    metal::float2 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return metal::float2(_e2, _e4);
}

metal::float3 bounded_vec3_(
    metal::float3 v_4
) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float4 bounded_vec4_(
    metal::float4 v_5
) {
    float _e2 = bounded(v_5.x);
    float _e4 = bounded(v_5.y);
    float _e6 = bounded(v_5.z);
    float _e8 = bounded(v_5.w);
    return metal::float4(_e2, _e4, _e6, _e8);
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

float mixed(
    float a_1,
    float b_1,
    float t
) {
    float _e4 = bounded(b_1 - a_1);
    float _e14 = bounded((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4)));
    return _e14;
}

metal::float3 mixed_vec3_(
    metal::float3 a_2,
    metal::float3 b_2,
    float t_1
) {
    float _e5 = mixed(a_2.x, b_2.x, t_1);
    float _e8 = mixed(a_2.y, b_2.y, t_1);
    float _e11 = mixed(a_2.z, b_2.z, t_1);
    return metal::float3(_e5, _e8, _e11);
}

metal::float4 mixed_vec4_(
    metal::float4 a_3,
    metal::float4 b_3,
    float t_2
) {
    metal::float3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_2);
    float _e8 = mixed(a_3.w, b_3.w, t_2);
    return metal::float4(_e5, _e8);
}

float place_between(
    float x_6,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_6 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_6 - low) / _e12);
    return _e14;
}

float remapped(
    float x_7,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    float _e6 = bounded(x_7);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, clamped ? metal::clamp(_e9, 0.0, 1.0) : _e9);
    return _e16;
}

float eased(
    float x_8,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_8);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = metal::clamp(_e6, 0.0, 1.0);
    return (t_5 * t_5) * (3.0 - (2.0 * t_5));
}

float factor_of(
    float x_9,
    bool clamped_1
) {
    float _e2 = bounded(x_9);
    float _e3 = bounded(x_9);
    return clamped_1 ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

metal::float2 sin_cos_of(
    float x_10
) {
    float _e1 = bounded(x_10);
    metal::float2 _e2 = sin_cos(_e1);
    return metal::clamp(_e2, metal::float2(-1.0), metal::float2(1.0));
}

float footprint_of(
    float x_11
) {
    float _e1 = metal::dfdx(x_11);
    float _e2 = metal::dfdy(x_11);
    metal::float2 d_2 = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d_2, d_2)));
    return _e6;
}

float footprint_of_vec3_(
    metal::float3 v_6
) {
    metal::float3 dx = metal::dfdx(v_6);
    metal::float3 dy = metal::dfdy(v_6);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy))));
    return _e7;
}

float step_filtered(
    float x_12,
    float edge,
    float w
) {
    float _e4 = bounded(x_12 - edge);
    if (w < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

metal::float4 color_mixed(
    metal::float4 a_4,
    metal::float3 blended,
    float factor
) {
    metal::float3 _e4 = bounded_vec3_(a_4.xyz);
    metal::float3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    metal::float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_4.w);
    return metal::float4(_e8, _e10);
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

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

Color ramp_at(
    Ramp ramp,
    float x_13,
    float w_1
) {
    type_6 colors = {};
    type_7 places = {};
    metal::float4 color = {};
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_1 = {};
    metal::float4 from_a_1 = metal::float4(0.0);
    metal::float4 to_b_1 = metal::float4(0.0);
    uint count_2 = metal::min(ramp.count, 16u);
    if (count_2 == 0u) {
        return metal::float4(0.0);
    }
    colors = ramp.colors;
    places = ramp.places;
    if (ramp.interpolation == INTERPOLATION_STEPPED) {
        metal::float4 _e18 = colors.inner[0];
        color = _e18;
        uint2 loop_bound = uint2(4294967295u);
        bool loop_init = true;
        while(true) {
            if (metal::all(loop_bound == uint2(0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                uint _e47 = i;
                i = _e47 + 1u;
            }
            loop_init = false;
            uint _e22 = i;
            if (_e22 < count_2) {
            } else {
                break;
            }
            {
                metal::float4 _e24 = color;
                uint _e25 = i;
                metal::float4 _e27 = colors.inner[_e25];
                uint _e28 = i;
                metal::float4 _e32 = colors.inner[_e28 - 1u];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places.inner[naga_div(_e34, 4u)][naga_mod(_e38, 4u)];
                float _e43 = step_filtered(x_13, _e42, w_1);
                color = _e24 + ((_e27 - _e32) * _e43);
            }
        }
        metal::float4 _e49 = color;
        metal::float4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e71 = i_1;
            i_1 = _e71 + 1u;
        }
        loop_init_1 = false;
        uint _e55 = i_1;
        if (_e55 < count_2) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places.inner[naga_div(_e59, 4u)][naga_mod(_e63, 4u)];
            at = (_e67 <= x_13) ? _e58 : _e57;
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_4 = places.inner[naga_div(_e73, 4u)][naga_mod(_e77, 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count_2))) {
        local_1 = x_13 <= place_4;
    } else {
        local_1 = true;
    }
    bool _e91 = local_1;
    if (_e91) {
        uint _e92 = at;
        metal::float4 _e94 = colors.inner[_e92];
        metal::float4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = _e96 + 1u;
    float _e105 = places.inner[naga_div(after_1, 4u)][naga_mod(after_1, 4u)];
    float span_1 = _e105 - place_4;
    float _e108 = divided(x_13 - place_4, span_1);
    float t_6 = metal::clamp(_e108, 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        uint _e115 = at;
        metal::float4 _e117 = colors.inner[_e115];
        metal::float4 _e119 = colors.inner[after_1];
        metal::float4 _e120 = mixed_vec4_(_e117, _e119, t_6);
        return _e120;
    }
    uint _e127 = at;
    if (_e127 > 0u) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places.inner[naga_div(_e130 - 1u, 4u)][naga_mod(_e136 - 1u, 4u)];
        uint _e143 = at;
        metal::float4 _e145 = colors.inner[_e143];
        uint _e146 = at;
        metal::float4 _e150 = colors.inner[_e146 - 1u];
        metal::float4 _e154 = colors.inner[after_1];
        uint _e155 = at;
        metal::float4 _e157 = colors.inner[_e155];
        metal::float4 _e159 = ramp_slope(_e145 - _e150, place_4 - before_1, _e154 - _e157, span_1);
        from_a_1 = _e159;
    }
    if ((after_1 + 1u) < count_2) {
        float _e173 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e173 - (place_4 + span_1);
        metal::float4 _e177 = colors.inner[after_1];
        uint _e178 = at;
        metal::float4 _e180 = colors.inner[_e178];
        metal::float4 _e185 = colors.inner[after_1 + 1u];
        metal::float4 _e187 = colors.inner[after_1];
        metal::float4 _e189 = ramp_slope(_e177 - _e180, span_1, _e185 - _e187, next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    metal::float4 _e192 = colors.inner[_e190];
    metal::float4 _e194 = colors.inner[after_1];
    metal::float4 _e195 = from_a_1;
    metal::float4 _e197 = to_b_1;
    metal::float4 _e199 = hermite(_e192, _e194, span_1 * _e195, span_1 * _e197, t_6);
    metal::float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

Composite premultiplied(
    Color color_1
) {
    return metal::float4(color_1.xyz * color_1.w, color_1.w);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

Color mix_colors_normal(
    Color a_6,
    Color b_5,
    float factor_1
) {
    metal::float4 _e3 = bounded_vec4_(a_6);
    metal::float4 _e4 = bounded_vec4_(b_5);
    float _e6 = factor_of(factor_1, true);
    metal::float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

Color mix_colors_multiply(
    Color a_7,
    Color b_6,
    float factor_2
) {
    metal::float4 _e6 = color_mixed(a_7, a_7.xyz * b_6.xyz, factor_2);
    return _e6;
}

float combine_tones_union(
    float a_8,
    float b_7
) {
    float _e3 = factor_of(a_8, true);
    float _e5 = factor_of(b_7, true);
    return metal::max(_e3, _e5);
}

Color output(
    Composite color_2
) {
    Color _e1 = straight(color_2);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Color ramp_plain(
    float value,
    Ramp ramp_1
) {
    float _e2 = footprint_of(value);
    float _e3 = bounded(value);
    Color _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_7 = {};
    v_7 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_7.x;
    uint _e10 = v_7.y;
    uint _e12 = v_7.z;
    v_7.x = _e8 + (_e10 * _e12);
    uint _e16 = v_7.y;
    uint _e18 = v_7.z;
    uint _e20 = v_7.x;
    v_7.y = _e16 + (_e18 * _e20);
    uint _e24 = v_7.z;
    uint _e26 = v_7.x;
    uint _e28 = v_7.y;
    v_7.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_7;
    metal::uint3 _e32 = v_7;
    v_7 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_7.x;
    uint _e40 = v_7.y;
    uint _e42 = v_7.z;
    v_7.x = _e38 + (_e40 * _e42);
    uint _e46 = v_7.y;
    uint _e48 = v_7.z;
    uint _e50 = v_7.x;
    v_7.y = _e46 + (_e48 * _e50);
    uint _e54 = v_7.z;
    uint _e56 = v_7.x;
    uint _e58 = v_7.y;
    v_7.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_7;
    return _e61;
}

metal::float3 unit_of_hash(
    metal::uint3 hash
) {
    return static_cast<metal::float3>(hash >> metal::uint3(8u)) * 0.000000059604645;
}

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

float gradient_dot(
    metal::uint3 hash_1,
    metal::float3 d
) {
    uint axis = naga_mod(hash_1.x >> 8u, 3u);
    float a_12 = (axis == 0u) ? d.y : d.x;
    float b_11 = (axis == 2u) ? d.y : d.z;
    return (((hash_1.y >> 31u) == 0u) ? a_12 : -(a_12)) + (((hash_1.z >> 31u) == 0u) ? b_11 : -(b_11));
}

metal::float3 fade_quintic(
    metal::float3 t_4
) {
    return ((t_4 * t_4) * t_4) * ((t_4 * ((t_4 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(
    metal::float3 p,
    uint seed_2
) {
    float sum = 0.0;
    int i_2 = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 _e4 = fade_quintic(p - corner);
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e45 = i_2;
            i_2 = as_type<int>(as_type<uint>(_e45) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e10 = i_2;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i_2;
            int _e16 = i_2;
            int _e21 = i_2;
            metal::int3 at_2 = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at_2 == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at_2)), seed_2);
            metal::float3 _e40 = unit_of_hash(_e39);
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e40.x);
        }
    }
    float _e47 = sum;
    return _e47;
}

float perlin_noise(
    metal::float3 p_1,
    uint seed_3
) {
    float sum_1 = 0.0;
    int i_3 = 0;
    metal::float3 corner_1 = metal::floor(p_1);
    metal::float3 d_4 = p_1 - corner_1;
    metal::float3 _e4 = fade_quintic(d_4);
    metal::int3 cell_2 = naga_f2i32(corner_1);
    uint2 loop_bound_3 = uint2(4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (metal::all(loop_bound_3 == uint2(0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e46 = i_3;
            i_3 = as_type<int>(as_type<uint>(_e46) + as_type<uint>(1));
        }
        loop_init_3 = false;
        int _e10 = i_3;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i_3;
            int _e16 = i_3;
            int _e21 = i_3;
            metal::int3 at_3 = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight_1 = metal::select(metal::float3(1.0) - _e4, _e4, at_3 == metal::int3(1));
            float _e32 = sum_1;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_2) + as_type<metal::uint3>(at_3)), seed_3);
            float _e42 = gradient_dot(_e39, d_4 - static_cast<metal::float3>(at_3));
            sum_1 = _e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42);
        }
    }
    float _e48 = sum_1;
    return metal::clamp(0.5 + (0.48244 * _e48), 0.0, 1.0);
}

float simplex_corner(
    metal::float3 d_1,
    metal::uint3 hash_2
) {
    float t_7 = metal::max(0.5 - metal::dot(d_1, d_1), 0.0);
    float _e10 = gradient_dot(hash_2, d_1);
    return (((t_7 * t_7) * t_7) * t_7) * _e10;
}

float simplex_noise(
    metal::float3 p_2,
    uint seed_4
) {
    float sum_2 = {};
    metal::float3 corner_2 = metal::floor(p_2 + metal::float3(((p_2.x + p_2.y) + p_2.z) / 3.0));
    metal::float3 d_5 = (p_2 - corner_2) + metal::float3(((corner_2.x + corner_2.y) + corner_2.z) / 6.0);
    metal::bool3 is_first = metal::bool3(d_5.x >= d_5.y, d_5.y >= d_5.z, d_5.z > d_5.x);
    metal::float3 g = metal::select(metal::float3(0.0), metal::float3(1.0), is_first);
    metal::float3 l = metal::float3(1.0) - g;
    metal::float3 second = metal::min(g, l.zxy);
    metal::float3 third = metal::max(g, l.zxy);
    metal::int3 cell_3 = naga_f2i32(corner_2);
    metal::uint3 _e45 = lattice_hash(cell_3, seed_4);
    float _e46 = simplex_corner(d_5, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    metal::uint3 _e55 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_3) + as_type<metal::uint3>(naga_f2i32(second))), seed_4);
    float _e56 = simplex_corner((d_5 - second) + metal::float3(0.16666667), _e55);
    sum_2 = _e48 + _e56;
    float _e58 = sum_2;
    metal::uint3 _e65 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_3) + as_type<metal::uint3>(naga_f2i32(third))), seed_4);
    float _e66 = simplex_corner((d_5 - third) + metal::float3(0.33333334), _e65);
    sum_2 = _e58 + _e66;
    float _e68 = sum_2;
    metal::uint3 _e75 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_3) + as_type<metal::uint3>(metal::int3(1))), seed_4);
    float _e76 = simplex_corner(d_5 - metal::float3(0.5), _e75);
    sum_2 = _e68 + _e76;
    float _e79 = sum_2;
    return metal::clamp(0.5 + (SIMPLEX_SCALE * _e79), 0.0, 1.0);
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

float worley_noise(
    metal::float3 p_3,
    uint seed_5
) {
    float nearest = 1.0;
    int i_4 = 0;
    metal::float3 corner_3 = metal::floor(p_3);
    metal::float3 d_6 = p_3 - corner_3;
    metal::int3 cell_4 = naga_f2i32(corner_3);
    uint2 loop_bound_4 = uint2(4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (metal::all(loop_bound_4 == uint2(0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e40 = i_4;
            i_4 = as_type<int>(as_type<uint>(_e40) + as_type<uint>(1));
        }
        loop_init_4 = false;
        int _e9 = i_4;
        if (_e9 < 27) {
        } else {
            break;
        }
        {
            int _e12 = i_4;
            int _e17 = i_4;
            int _e24 = i_4;
            metal::int3 at_4 = metal::int3(as_type<int>(as_type<uint>(naga_mod(_e12, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_mod(naga_div(_e17, 3), 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e24, 9)) - as_type<uint>(1)));
            metal::uint3 _e32 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_4) + as_type<metal::uint3>(at_4)), seed_5);
            metal::float3 _e33 = unit_of_hash(_e32);
            metal::float3 offset = (static_cast<metal::float3>(at_4) + _e33) - d_6;
            float _e36 = nearest;
            nearest = metal::min(_e36, metal::dot(offset, offset));
        }
    }
    float _e42 = nearest;
    return metal::sqrt(_e42);
}

float noise_octave(
    uint kind,
    metal::float3 p_4,
    uint seed_6
) {
    switch(kind) {
        case 1u: {
            float _e3 = perlin_noise(p_4, seed_6);
            return _e3;
        }
        case 2u: {
            float _e4 = simplex_noise(p_4, seed_6);
            return _e4;
        }
        case 3u: {
            float _e5 = worley_noise(p_4, seed_6);
            return _e5;
        }
        default: {
            float _e6 = value_noise(p_4, seed_6);
            return _e6;
        }
    }
}

float fractal_noise(
    uint kind_1,
    metal::float3 p_5,
    int octaves,
    float roughness,
    int seed_7,
    float w_2
) {
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_5 = 0;
    float octave = {};
    float mean = (kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5;
    float _e11 = bounded(roughness);
    float gain = metal::clamp(_e11, 0.0, 1.0);
    uint2 loop_bound_5 = uint2(4294967295u);
    bool loop_init_5 = true;
    while(true) {
        if (metal::all(loop_bound_5 == uint2(0u))) { break; }
        loop_bound_5 -= uint2(loop_bound_5.y == 0u, 1u);
        if (!loop_init_5) {
            int _e75 = i_5;
            i_5 = as_type<int>(as_type<uint>(_e75) + as_type<uint>(1));
        }
        loop_init_5 = false;
        int _e25 = i_5;
        if (_e25 < metal::clamp(octaves, 1, 8)) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            float _e34 = eased(w_2 * _e30, 0.5, 1.0);
            float visible = 1.0 - _e34;
            octave = mean;
            if (visible > 0.0) {
                float _e40 = frequency;
                int _e42 = i_5;
                metal::float3 place_5 = metal::clamp((p_5 * _e40) + (static_cast<float>(_e42) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
                int _e56 = i_5;
                float _e59 = noise_octave(kind_1, place_5, as_type<uint>(seed_7) + static_cast<uint>(_e56));
                octave = metal::mix(mean, _e59, visible);
            }
            float _e61 = sum_3;
            float _e62 = strength;
            float _e63 = octave;
            sum_3 = _e61 + (_e62 * _e63);
            float _e66 = total;
            float _e67 = strength;
            total = _e66 + _e67;
            float _e69 = strength;
            strength = _e69 * gain;
            float _e71 = frequency;
            frequency = _e71 * 2.0;
        }
    }
    float _e77 = sum_3;
    float _e78 = total;
    return metal::clamp(_e77 / _e78, 0.0, 1.0);
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    float _e10 = bounded((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective));
    return _e10;
}

metal::float3 anchor_on_screen(
    metal::float3 origin,
    float perspective_1,
    float scale_1
) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    metal::float3 _e12 = bounded_vec3_(metal::float3(origin.x * _e5, -(origin.y) * _e5, _e5));
    return _e12;
}

metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 _e2 = bounded_vec2_(pixel);
    metal::float2 from_middle = _e2 - (0.5 * viewport);
    return metal::float2(from_middle.x, -(from_middle.y)) / metal::float2(metal::max(viewport.y, 1.0));
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 _e4 = sin_cos_of(angle);
    metal::float3 _e10 = bounded_vec3_((_e4.y * along) + (_e4.x * across));
    metal::float3 _e16 = bounded_vec3_((_e4.y * across) - (_e4.x * along));
    metal::float2 _e17 = bounded_vec2_(place);
    metal::float2 turned = metal::float2((_e4.y * _e17.x) + (_e4.x * _e17.y), (_e4.y * _e17.y) - (_e4.x * _e17.x));
    metal::float3 most = metal::float3(1000000000000000.0);
    metal::float3 stretch_3 = metal::clamp(metal::float3(metal::dot(_e10, _e10), metal::dot(_e10, _e16), metal::dot(_e16, _e16)), -(most), most);
    metal::float2 _e41 = bounded_vec2_(turned);
    return StretchedPlace {_e41, {}, stretch_3};
}

SpacedPlace spaced(
    metal::float2 place_1,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count
) {
    float _e4 = bounded(count);
    float number = metal::clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_3 = is_pixel ? (number / metal::max(viewport_1.y, 1.0)) : number;
    metal::float2 _e19 = bounded_vec2_(place_1);
    metal::float2 _e21 = bounded_vec2_(_e19 * scale_3);
    metal::float2 p_6 = metal::clamp(_e21, metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float3 _e27 = bounded_vec3_(stretch);
    metal::float3 s_1 = metal::clamp(_e27, metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
    return SpacedPlace {p_6, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : s_1};
}

float area_square(
    metal::float3 stretch_1
) {
    float sum_4 = stretch_1.x + stretch_1.z;
    return metal::max((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y), (sum_4 * sum_4) / 66.0);
}

float octave_of(
    float square
) {
    float _e5 = log_stable(metal::clamp(square, 0.000000000000000000000000000001, 1000000000000000000000000000000.0));
    return metal::clamp(-0.7213475 * _e5, -16.0, 16.0);
}

MarkPlace mark_place_object(
    float angle_1,
    metal::float3 anchor,
    metal::float2 pixel_1,
    metal::float2 viewport_2
) {
    float _e5 = bounded(anchor.z);
    float size = metal::clamp(_e5, 0.000001, 1000000.0);
    metal::float2 _e9 = place_in_picture(pixel_1, viewport_2);
    metal::float2 _e15 = bounded_vec2_(_e9 - metal::float2(anchor.x, -(anchor.y)));
    metal::float2 place_6 = _e15 / metal::float2(size);
    StretchedPlace _e28 = mark_place_of(place_6, metal::float3(1.0 / size, 0.0, 0.0), metal::float3(0.0, 1.0 / size, 0.0), angle_1);
    return MarkPlace {_e28.place, {}, _e28.stretch};
}

float caught_ink(
    float ink,
    float height,
    float tooth
) {
    float _e3 = bounded(ink);
    float amount = metal::clamp(_e3, 0.0, 1.0);
    float _e7 = bounded(tooth);
    float rough = metal::clamp(_e7, 0.0, 1.0);
    return metal::clamp(amount + ((((8.0 * rough) * (height - 0.5)) * amount) * (1.0 - amount)), 0.0, 1.0);
}

float paper_octave(
    metal::float2 place_2,
    int zoom,
    float w_3,
    float fiber,
    uint seed_8
) {
    float _e5 = power_of_two(zoom);
    metal::float2 p_7 = metal::clamp(place_2 * _e5, metal::float2(-4194304.0), metal::float2(4194304.0));
    uint own = seed_8 + (7u * as_type<uint>(zoom));
    float _e18 = perlin_noise(metal::float3(p_7, 0.5), own);
    float grain = _e18 - 0.5;
    metal::float2 q = metal::clamp(2.7 * metal::float2((0.8 * p_7.x) - (0.6 * p_7.y), (0.6 * p_7.x) + (0.8 * p_7.y)), metal::float2(-4194304.0), metal::float2(4194304.0));
    float _e47 = perlin_noise(metal::float3(q, 0.5), own + 1u);
    float felt = _e47 - 0.5;
    float _e53 = eased(w_3 * _e5, 0.5, 1.0);
    float coarse_seen = 1.0 - _e53;
    float _e61 = eased((2.7 * w_3) * _e5, 0.5, 1.0);
    float felt_seen = 1.0 - _e61;
    return metal::clamp(0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt))), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float paper_height(
    SpacedPlace at_1,
    float fiber_1,
    uint seed_9
) {
    float height_1 = {};
    metal::float2 x_14 = metal::dfdx(at_1.place);
    metal::float2 y = metal::dfdy(at_1.place);
    float _e11 = bounded(metal::sqrt(metal::max(metal::dot(x_14, x_14), metal::dot(y, y))));
    float _e13 = area_square(at_1.stretch);
    float _e15 = octave_of(metal::sqrt(_e13));
    float zoom_1 = metal::floor(_e15);
    float f = _e15 - zoom_1;
    float _e18 = bounded(fiber_1);
    float fine = metal::clamp(_e18, 0.0, 1.0);
    float _e24 = paper_octave(at_1.place, naga_f2i32(zoom_1), _e11, fine, seed_9);
    height_1 = _e24;
    if (f > 0.0) {
        float _e28 = height_1;
        float _e33 = paper_octave(at_1.place, as_type<int>(as_type<uint>(naga_f2i32(zoom_1)) + as_type<uint>(1)), _e11, fine, seed_9);
        float both = metal::mix(_e28, _e33, f);
        height_1 = metal::clamp(0.5 + ((both - 0.5) / metal::sqrt((f * f) + ((1.0 - f) * (1.0 - f)))), 0.0, 1.0);
    }
    float _e51 = height_1;
    return _e51;
}

PaperGrain paper_grain(
    float value_1,
    metal::float2 place_3,
    metal::float3 stretch_2,
    float count_1,
    float tooth_1,
    float fiber_2,
    int seed_10,
    metal::float2 viewport_3
) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    float _e10 = paper_height(_e8, fiber_2, as_type<uint>(seed_10));
    float _e12 = factor_of(value_1, true);
    float _e15 = caught_ink(1.0 - _e12, _e10, tooth_1);
    return PaperGrain {1.0 - _e15, _e10};
}

float reflectance_wrap(
    Light light,
    metal::float3 normal,
    float wrap
) {
    float _e3 = bounded(wrap);
    float w_4 = metal::clamp(_e3, 0.0, 1.0);
    metal::float3 _e11 = normalize_or(normal, metal::float3(0.0, 0.0, 1.0));
    float cosine = metal::dot(_e11, light.direction);
    return metal::max((cosine + w_4) / (1.0 + w_4), 0.0);
}

float add(
    float a_9,
    float b_8
) {
    float _e3 = bounded(a_9 + b_8);
    return _e3;
}

float map_range(
    float value_2,
    float from_low_1,
    float from_high_1,
    float to_low_1,
    float to_high_1,
    bool clamped_2
) {
    float _e6 = remapped(value_2, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(
    float a_10,
    float b_9
) {
    float _e3 = bounded(a_10 * b_9);
    return _e3;
}

Color multiply_color(
    Color a_11,
    Color b_10
) {
    metal::float4 _e3 = bounded_vec4_(a_11 * b_10);
    return _e3;
}

float smooth_step_value(
    float value_3,
    float low_2,
    float high_2
) {
    float _e3 = eased(value_3, low_2, high_2);
    return _e3;
}

float line_covers(
    float distance,
    float width
) {
    return metal::clamp((width + 0.5) - distance, 0.0, metal::min(width, 1.0));
}

float outer_contour(
    float width_1,
    metal::float3 normal_1,
    metal::float3 view,
    metal::float2 viewport_4
) {
    metal::float3 _e6 = normalize_or(normal_1, metal::float3(0.0));
    float facing = metal::clamp(metal::dot(_e6, view), 0.0, 1.0);
    float _e11 = bounded(width_1);
    float pixels = (metal::clamp(_e11, 0.0, 10000.0) * metal::clamp(viewport_4.y, 1.0, 100000.0)) / 1000.0;
    float _e22 = footprint_of(facing);
    float distance_1 = facing / metal::max(2.0 * _e22, 0.000001);
    float _e30 = eased(facing, 0.45, 0.75);
    float near = 1.0 - _e30;
    float _e33 = line_covers(distance_1, pixels);
    return _e33 * near;
}

float noise_perlin(
    metal::float3 position,
    float scale_2,
    int octaves_1,
    float roughness_1,
    int seed_11
) {
    metal::float3 _e6 = bounded_vec3_(position * scale_2);
    float _e8 = footprint_of_vec3_(_e6);
    float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_1, seed_11, _e8);
    return _e9;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    float _e6 = noise_perlin(surface_1.position_object, 1.5, 2, 0.5, 11);
    float _e12 = map_range(_e6, 0.32, 0.68, 0.0, 1.0, true);
    Color _e14 = ramp_plain(_e12, two_pigments);
    Light _e17 = look.key;
    float _e20 = reflectance_wrap(_e17, surface_1.normal, 0.45);
    float _e26 = map_range(_e20, 0.0, 0.85, 0.0, 1.0, true);
    float _e32 = noise_perlin(surface_1.position_object, 2.2, 4, 0.55, 0);
    float _e38 = map_range(_e32, 0.0, 1.0, -0.24, 0.24, false);
    float _e39 = add(_e26, _e38);
    float _e42 = smooth_step_value(_e39, 0.82, 0.7);
    float _e44 = multiply(_e42, 0.62);
    Color _e50 = mix_colors_multiply(metal::float4(0.9843, 0.9686, 0.9255, 1.0), _e14, _e44);
    Color _e57 = mix_colors_multiply(_e14, metal::float4(0.3529, 0.3098, 0.5255, 1.0), 0.75);
    float _e60 = smooth_step_value(_e39, 0.42, 0.34);
    float _e62 = multiply(_e60, 0.6);
    Color _e63 = mix_colors_multiply(_e50, _e57, _e62);
    float _e66 = smooth_step_value(_e39, 0.66, 0.72);
    float _e67 = multiply(_e66, _e42);
    float _e70 = smooth_step_value(_e39, 0.29, 0.34);
    float _e71 = multiply(_e70, _e60);
    float _e72 = combine_tones_union(_e67, _e71);
    float _e74 = multiply(_e72, 0.34);
    Color _e75 = mix_colors_multiply(_e63, _e57, _e74);
    metal::float2 _e81 = look.viewport;
    MarkPlace _e82 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e81);
    metal::float2 _e92 = look.viewport;
    PaperGrain _e93 = paper_grain(0.5, _e82.place, _e82.stretch, 240.0, 0.6, 0.6, 0, _e92);
    float _e100 = map_range(_e93.tone, 0.0, 1.0, 0.9, 1.03, false);
    Color _e104 = multiply_color(_e75, metal::float4(metal::float3(_e100), 1.0));
    metal::float2 _e110 = look.viewport;
    float _e111 = outer_contour(2.2, surface_1.normal, surface_1.view, _e110);
    float _e113 = multiply(_e111, 0.7);
    Color _e119 = mix_colors_normal(_e104, metal::float4(0.2902, 0.2588, 0.2824, 1.0), _e113);
    Composite _e120 = premultiplied(_e119);
    Color _e121 = output(_e120);
    return _e121;
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
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_2 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_1.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    out.position_object = vertex_.position;
    metal::float3x3 _e21 = object.world_from_normal;
    out.normal = _e21 * vertex_.normal;
    Varyings _e24 = out;
    const auto _tmp = _e24;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
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
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object, varyings_1.normal_2 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_2 = is_front ? _e7 : -(_e7);
    surface.normal = normal_2;
    metal::float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    metal::float4 _e26 = view_1.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    surface.position_object = in.position_object;
    metal::float4 _e41 = view_1.screen;
    metal::float4 _e46 = view_1.screen;
    surface.pixel = (in.clip.xy * _e41.xy) + _e46.zw;
    metal::float4x4 _e52 = view_1.camera_from_world;
    metal::float4 _e56 = object.world_from_object[3];
    float _e65 = view_1.eye.w;
    float _e70 = view_1.clip_from_world[0].y;
    float _e75 = view_1.clip_from_world[1].y;
    float _e80 = view_1.clip_from_world[2].y;
    metal::float3 _e83 = anchor_on_screen((_e52 * metal::float4(_e56.xyz, 1.0)).xyz, _e65, metal::length(metal::float3(_e70, _e75, _e80)));
    surface.anchor = _e83;
    Surface _e84 = surface;
    metal::float4 _e85 = shade(_e84, look);
    metal::float4 _e86 = finite_vec4_(_e85);
    return fs_mainOutput { _e86 };
}
