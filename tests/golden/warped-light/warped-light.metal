// Warped light: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_6 buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0).
// warped-light.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    metal::float4 eye;
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
    Light back;
    Light key;
    metal::float3x3 camera_from_world;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 curvature_tensor;
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
struct RampPlace {
    metal::float4 before;
    metal::float4 after;
    float t;
    char _pad3[12];
};
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint INTERPOLATION_SMOOTH = 1u;
constant uint INTERPOLATION_STEPPED = 2u;
constant Ramp jade = Ramp {type_6 {{metal::float4(0.0157, 0.1294, 0.1216, 1.0), metal::float4(0.0588, 0.3529, 0.298, 1.0), metal::float4(0.2471, 0.6275, 0.4784, 1.0), metal::float4(0.7137, 0.8784, 0.6902, 1.0), metal::float4(0.9333, 0.9725, 0.8471, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.35, 0.65, 0.9), metal::float4(1.0, 0.0, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};

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
    float square = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

float power_of_two(
    int n
) {
    return as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(n) + as_type<uint>(127))) << 23u);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

float exp2_stable(
    float x_2
) {
    float clamped_1 = metal::clamp(x_2, -150.0, 127.99999);
    float whole = metal::rint(clamped_1);
    float f = (clamped_1 - whole) * LN_2_;
    float p = 1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127)))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two(as_type<int>(as_type<uint>(naga_f2i32(whole)) - as_type<uint>(half_whole)));
    return (p * _e33) * _e37;
}

float log_stable(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    int shift = static_cast<int>((bits - 1060439283u) >> 23u);
    int exponent_1 = (shift >= 256) ? as_type<int>(as_type<uint>(shift) - as_type<uint>(512)) : shift;
    float mantissa = as_type<float>(bits - (static_cast<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    float series = (2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111))))))));
    return (static_cast<float>(exponent_1) * LN_2_) + series;
}

float bounded(
    float x_4
) {
    uint bits_1 = as_type<uint>(x_4);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_4 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float3 bounded_vec3_(
    metal::float3 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    float _e6 = bounded(v_3.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float4 bounded_vec4_(
    metal::float4 v_4
) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    float _e8 = bounded(v_4.w);
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

float powered(
    float base,
    float exponent
) {
    bool local_1 = {};
    float _e2 = bounded(base);
    float _e3 = bounded(exponent);
    if (_e3 == 1.0) {
        return _e2;
    }
    if (_e3 == 0.0) {
        return 1.0;
    }
    if (_e3 == 2.0) {
        float _e12 = bounded(_e2 * _e2);
        return _e12;
    }
    float magnitude_1 = metal::abs(_e2);
    if (magnitude_1 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e18 = log_stable(magnitude_1);
    float _e21 = bounded(_e3 * (LOG2_E * _e18));
    float _e22 = exp2_stable(_e21);
    bool is_even = metal::floor(_e3 * 0.5) == (_e3 * 0.5);
    if (_e2 < 0.0) {
        local_1 = !(is_even);
    } else {
        local_1 = false;
    }
    bool _e36 = local_1;
    return _e36 ? -(_e22) : _e22;
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
    float x_5,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_5 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_5 - low) / _e12);
    return _e14;
}

float eased(
    float x_6,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_6);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_6 = metal::clamp(_e6, 0.0, 1.0);
    return (t_6 * t_6) * (3.0 - (2.0 * t_6));
}

float factor_of(
    float x_7,
    bool clamped
) {
    float _e2 = bounded(x_7);
    float _e3 = bounded(x_7);
    return clamped ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

float footprint_of(
    float x_8
) {
    float _e1 = metal::dfdx(x_8);
    float _e2 = metal::dfdy(x_8);
    metal::float2 d = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
    return _e6;
}

float step_filtered(
    float x_9,
    float edge,
    float w
) {
    float _e4 = bounded(x_9 - edge);
    if (w < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

float linear_of_srgb(
    float coded
) {
    float _e1 = bounded(coded);
    float size = metal::abs(_e1);
    float _e8 = powered((size + 0.055) / 1.055, 2.4);
    float value_1 = (size <= 0.04045) ? (size / 12.92) : _e8;
    return (coded < 0.0) ? -(value_1) : value_1;
}

float srgb_of_linear(
    float light
) {
    float _e1 = bounded(light);
    float size_1 = metal::abs(_e1);
    float _e4 = powered(size_1, 0.41666666);
    float value_2 = (size_1 <= 0.0031308) ? (size_1 * 12.92) : ((1.055 * _e4) - 0.055);
    float _e18 = bounded((light < 0.0) ? -(value_2) : value_2);
    return _e18;
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

float cube_root(
    float x_10
) {
    float _e3 = powered(metal::abs(x_10), 0.33333334);
    return (x_10 < 0.0) ? -(_e3) : _e3;
}

metal::float3 oklab_of_linear(
    metal::float3 rgb
) {
    metal::float3 _e1 = bounded_vec3_(rgb);
    metal::float3 c = metal::clamp(_e1, metal::float3(-1000000000.0), metal::float3(1000000000.0));
    float _e12 = cube_root(metal::dot(c, metal::float3(0.41222146, 0.53633255, 0.051445995)));
    float _e18 = cube_root(metal::dot(c, metal::float3(0.2119035, 0.6806995, 0.10739696)));
    float _e24 = cube_root(metal::dot(c, metal::float3(0.08830246, 0.28171885, 0.6299787)));
    return metal::float3(((0.21045426 * _e12) + (0.7936178 * _e18)) - (0.004072047 * _e24), ((1.9779985 * _e12) - (2.4285922 * _e18)) + (0.4505937 * _e24), ((0.025904037 * _e12) + (0.78277177 * _e18)) - (0.80867577 * _e24));
}

metal::float3 linear_of_oklab(
    metal::float3 lab
) {
    metal::float3 _e1 = bounded_vec3_(lab);
    metal::float3 c_1 = metal::clamp(_e1, metal::float3(-1000000.0), metal::float3(1000000.0));
    float l = (c_1.x + (0.39633778 * c_1.y)) + (0.21580376 * c_1.z);
    float m = (c_1.x - (0.105561346 * c_1.y)) - (0.06385417 * c_1.z);
    float s = (c_1.x - (0.08948418 * c_1.y)) - (1.2914855 * c_1.z);
    metal::float3 cubes = metal::float3((l * l) * l, (m * m) * m, (s * s) * s);
    return metal::float3(metal::dot(cubes, metal::float3(4.0767417, -3.3077116, 0.23096994)), metal::dot(cubes, metal::float3(-1.268438, 2.6097574, -0.34131938)), metal::dot(cubes, metal::float3(-0.0041960864, -0.7034186, 1.7076147)));
}

metal::float3 oklab_of_srgb(
    metal::float3 coded_1
) {
    float _e2 = linear_of_srgb(coded_1.x);
    float _e4 = linear_of_srgb(coded_1.y);
    float _e6 = linear_of_srgb(coded_1.z);
    metal::float3 _e8 = oklab_of_linear(metal::float3(_e2, _e4, _e6));
    return _e8;
}

metal::float3 srgb_of_oklab(
    metal::float3 lab_1
) {
    metal::float3 _e1 = linear_of_oklab(lab_1);
    float _e3 = srgb_of_linear(_e1.x);
    float _e5 = srgb_of_linear(_e1.y);
    float _e7 = srgb_of_linear(_e1.z);
    return metal::float3(_e3, _e5, _e7);
}

metal::float4 ends_kept(
    metal::float4 a_5,
    metal::float4 b_4,
    float t_3,
    metal::float3 rgb_1
) {
    metal::float3 _e4 = bounded_vec3_(rgb_1);
    float _e7 = mixed(a_5.w, b_4.w, t_3);
    metal::float4 mixed_color = metal::float4(_e4, _e7);
    metal::float4 _e9 = bounded_vec4_(b_4);
    metal::float4 _e13 = bounded_vec4_(a_5);
    return (t_3 <= 0.0) ? _e13 : ((t_3 >= 1.0) ? _e9 : mixed_color);
}

metal::float4 mixed_in_oklab(
    metal::float4 a_6,
    metal::float4 b_5,
    float t_4
) {
    metal::float3 _e4 = oklab_of_srgb(a_6.xyz);
    metal::float3 _e6 = oklab_of_srgb(b_5.xyz);
    metal::float3 _e7 = mixed_vec3_(_e4, _e6, t_4);
    metal::float3 _e8 = srgb_of_oklab(_e7);
    metal::float4 _e9 = ends_kept(a_6, b_5, t_4, _e8);
    return _e9;
}

metal::float4 hermite(
    metal::float4 a_7,
    metal::float4 b_6,
    metal::float4 from_a,
    metal::float4 to_b,
    float t_5
) {
    metal::float4 d_1 = b_6 - a_7;
    return a_7 + (t_5 * (from_a + (t_5 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_5 * ((from_a + to_b) - (2.0 * d_1)))))));
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
    float x_11,
    float w_1
) {
    type_6 colors = {};
    type_7 places = {};
    metal::float4 color = {};
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_2 = {};
    metal::float4 from_a_1 = metal::float4(0.0);
    metal::float4 to_b_1 = metal::float4(0.0);
    uint count = metal::min(ramp.count, 16u);
    if (count == 0u) {
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
            if (_e22 < count) {
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
                float _e43 = step_filtered(x_11, _e42, w_1);
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
        if (_e55 < count) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places.inner[naga_div(_e59, 4u)][naga_mod(_e63, 4u)];
            at = (_e67 <= x_11) ? _e58 : _e57;
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_1 = places.inner[naga_div(_e73, 4u)][naga_mod(_e77, 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_2 = x_11 <= place_1;
    } else {
        local_2 = true;
    }
    bool _e91 = local_2;
    if (_e91) {
        uint _e92 = at;
        metal::float4 _e94 = colors.inner[_e92];
        metal::float4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = _e96 + 1u;
    float _e105 = places.inner[naga_div(after_1, 4u)][naga_mod(after_1, 4u)];
    float span_1 = _e105 - place_1;
    float _e108 = divided(x_11 - place_1, span_1);
    float t_7 = metal::clamp(_e108, 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        uint _e115 = at;
        metal::float4 _e117 = colors.inner[_e115];
        metal::float4 _e119 = colors.inner[after_1];
        metal::float4 _e120 = mixed_vec4_(_e117, _e119, t_7);
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
        metal::float4 _e159 = ramp_slope(_e145 - _e150, place_1 - before_1, _e154 - _e157, span_1);
        from_a_1 = _e159;
    }
    if ((after_1 + 1u) < count) {
        float _e173 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e173 - (place_1 + span_1);
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
    metal::float4 _e199 = hermite(_e192, _e194, span_1 * _e195, span_1 * _e197, t_7);
    metal::float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

RampPlace ramp_place(
    Ramp ramp_1,
    float x_12
) {
    type_6 colors_1 = {};
    type_7 places_1 = {};
    uint at_1 = 0u;
    uint i_2 = 1u;
    uint count_1 = metal::min(ramp_1.count, 16u);
    if (count_1 == 0u) {
        return RampPlace {metal::float4(0.0), metal::float4(0.0), 0.0};
    }
    colors_1 = ramp_1.colors;
    places_1 = ramp_1.places;
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            uint _e37 = i_2;
            i_2 = _e37 + 1u;
        }
        loop_init_2 = false;
        uint _e21 = i_2;
        if (_e21 < count_1) {
        } else {
            break;
        }
        {
            uint _e23 = at_1;
            uint _e24 = i_2;
            uint _e25 = i_2;
            uint _e29 = i_2;
            float _e33 = places_1.inner[naga_div(_e25, 4u)][naga_mod(_e29, 4u)];
            at_1 = (_e33 <= x_12) ? _e24 : _e23;
        }
    }
    uint _e39 = at_1;
    uint after_2 = metal::min(_e39 + 1u, count_1 - 1u);
    uint _e45 = at_1;
    uint _e49 = at_1;
    float place_2 = places_1.inner[naga_div(_e45, 4u)][naga_mod(_e49, 4u)];
    float _e61 = places_1.inner[naga_div(after_2, 4u)][naga_mod(after_2, 4u)];
    float _e63 = divided(x_12 - place_2, _e61 - place_2);
    float t_8 = metal::clamp(_e63, 0.0, 1.0);
    uint _e67 = at_1;
    metal::float4 _e69 = colors_1.inner[_e67];
    metal::float4 _e71 = colors_1.inner[after_2];
    float _e74 = eased(t_8, 0.0, 1.0);
    return RampPlace {_e69, _e71, (ramp_1.interpolation == INTERPOLATION_SMOOTH) ? _e74 : t_8};
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

Color mix_colors_screen(
    Color a_8,
    Color b_7,
    float factor_1
) {
    metal::float4 _e10 = color_mixed(a_8, (a_8.xyz + b_7.xyz) - (a_8.xyz * b_7.xyz), factor_1);
    return _e10;
}

float kappa_safe(
    float kappa
) {
    bool is_nan = (as_type<uint>(kappa) & 2147483647u) > 2139095040u;
    return is_nan ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0);
}

float curvature_signed(
    float kappa_1,
    float slope
) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_10 = _e2 * metal::clamp(_e4, -1000000000000000000000000000000.0, 1000000000000000000000000000000.0);
    float magnitude_2 = metal::min(metal::abs(a_10), 50.0);
    if (magnitude_2 < 0.0625) {
        float a2_ = a_10 * a_10;
        return a_10 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e28 = exp2_stable(-2.88539 * magnitude_2);
    float t_9 = (1.0 - _e28) / (1.0 + _e28);
    return (a_10 >= 0.0) ? t_9 : -(t_9);
}

metal::float3 tensor_safe(
    metal::float3 tensor
) {
    float _e2 = kappa_safe(tensor.x);
    float _e4 = kappa_safe(tensor.y);
    float _e6 = kappa_safe(tensor.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float2 principal_curvatures(
    metal::float3 tensor_1
) {
    float mean = 0.5 * (tensor_1.x + tensor_1.z);
    float spread = metal::length(metal::float2(0.5 * (tensor_1.x - tensor_1.z), tensor_1.y));
    float far = mean + ((mean >= 0.0) ? spread : -(spread));
    float _e26 = divided((tensor_1.x * tensor_1.z) - (tensor_1.y * tensor_1.y), far);
    return (mean >= 0.0) ? metal::float2(far, _e26) : metal::float2(_e26, far);
}

Color output(
    Composite color_2
) {
    Color _e1 = straight(color_2);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

metal::float3 half_of(
    metal::float3 light_1,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = light_1 + view;
    metal::float3 _e8 = normalize_or((metal::dot(half_, half_) > 0.000000000001) ? half_ : normal, normal);
    return _e8;
}

float sine_squared(
    metal::float3 a_9,
    metal::float3 b_8
) {
    metal::float3 across = metal::cross(a_9, b_8);
    return metal::min(metal::dot(across, across), 1.0);
}

Reflection reflection_of(
    metal::float3 light_2,
    metal::float3 normal_1,
    metal::float3 view_1
) {
    metal::float3 _e3 = half_of(light_2, normal_1, view_1);
    float n_h = metal::clamp(metal::dot(normal_1, _e3), 0.0, 1.0);
    float v_h = metal::clamp(metal::dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection {metal::dot(normal_1, light_2), metal::dot(normal_1, view_1), n_h, v_h, _e14};
}

float width_of_roughness(
    float roughness
) {
    float _e1 = bounded(roughness);
    float r_1 = metal::clamp(_e1, 0.0, 1.0);
    return metal::max(r_1 * r_1, 0.001);
}

float schlick(
    float at_normal,
    float cosine
) {
    float m_1 = metal::clamp(1.0 - cosine, 0.0, 1.0);
    float m2_ = m_1 * m_1;
    return at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m_1));
}

float ggx(
    Reflection r,
    float width,
    float at_normal_1
) {
    bool local_3 = {};
    if (!((r.n_l <= 0.0))) {
        local_3 = r.n_v <= 0.0;
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return 0.0;
    }
    float a2_1 = width * width;
    float bottom = metal::max(r.sine2_ + ((a2_1 * r.n_h) * r.n_h), 0.000000000001);
    float distribution = a2_1 / (bottom * bottom);
    float toward_light = r.n_v * metal::sqrt(((r.n_l * r.n_l) * (1.0 - a2_1)) + a2_1);
    float toward_eye = r.n_l * metal::sqrt(((r.n_v * r.n_v) * (1.0 - a2_1)) + a2_1);
    float visibility = 0.5 / metal::max(toward_light + toward_eye, 0.000000001);
    float _e53 = schlick(at_normal_1, r.v_h);
    return metal::min(((distribution * visibility) * _e53) * r.n_l, 1000000.0);
}

Color ramp_oklab(
    float value,
    Ramp ramp_2
) {
    float _e2 = footprint_of(value);
    if (ramp_2.interpolation == INTERPOLATION_STEPPED) {
        float _e6 = bounded(value);
        Color _e7 = ramp_at(ramp_2, _e6, _e2);
        return _e7;
    }
    float _e8 = bounded(value);
    RampPlace _e9 = ramp_place(ramp_2, _e8);
    metal::float4 _e13 = mixed_in_oklab(_e9.before, _e9.after, _e9.t);
    return _e13;
}

float reflectance_wrap(
    Light light_3,
    metal::float3 normal_2,
    float wrap
) {
    float _e3 = bounded(wrap);
    float w_2 = metal::clamp(_e3, 0.0, 1.0);
    metal::float3 _e11 = normalize_or(normal_2, metal::float3(0.0, 0.0, 1.0));
    float cosine_1 = metal::dot(_e11, light_3.direction);
    return metal::max((cosine_1 + w_2) / (1.0 + w_2), 0.0);
}

float reflectance_ggx(
    Light light_4,
    metal::float3 normal_3,
    metal::float3 view_2,
    float roughness_1,
    float at_normal_2
) {
    metal::float3 _e10 = normalize_or(normal_3, metal::float3(0.0, 0.0, 1.0));
    Reflection _e11 = reflection_of(light_4.direction, _e10, view_2);
    float _e12 = width_of_roughness(roughness_1);
    float _e13 = bounded(at_normal_2);
    float _e17 = ggx(_e11, _e12, metal::clamp(_e13, 0.0, 1.0));
    return _e17;
}

float rim(
    Light light_5,
    metal::float3 normal_4,
    metal::float3 view_3,
    float width_1,
    float softness,
    float follow
) {
    metal::float3 _e10 = normalize_or(normal_4, metal::float3(0.0, 0.0, 1.0));
    float facing_1 = metal::clamp(metal::dot(_e10, view_3), 0.0, 1.0);
    float _e16 = factor_of(width_1, true);
    float _e18 = factor_of(softness, true);
    float _e20 = footprint_of(facing_1);
    float edge_1 = metal::max(_e16 * _e18, metal::min(_e20, 1.0));
    metal::float3 aside = _e10 - view_3;
    float further = (facing_1 > 0.5) ? ((0.5 * metal::dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing_1);
    float within = (further / metal::max(edge_1, 0.000001)) + ((softness > 0.0) ? 0.0 : 0.5);
    float inside = (_e16 <= 0.0) ? 0.0 : metal::clamp(within, 0.0, 1.0);
    metal::float3 across_1 = light_5.direction - (metal::dot(light_5.direction, view_3) * view_3);
    metal::float3 _e61 = normalize_or(across_1, metal::float3(0.0));
    float side = metal::dot(_e10 - (metal::dot(_e10, view_3) * view_3), _e61);
    float _e66 = eased(side, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return inside * _e69;
}

metal::float2 warped_place(
    metal::float3 tensor_2,
    metal::float2 place,
    float amount,
    float slope_1
) {
    metal::float2 _e4 = principal_curvatures(tensor_2);
    float _e7 = curvature_signed(_e4.x, slope_1);
    float _e9 = exp2_stable(-(amount) * _e7);
    float _e12 = curvature_signed(_e4.y, slope_1);
    float _e14 = exp2_stable(-(amount) * _e12);
    metal::float2 half_apart = metal::float2(0.5 * (tensor_2.x - tensor_2.z), tensor_2.y);
    metal::float2 axes = half_apart / metal::float2(metal::max(metal::length(half_apart), 0.00000000000000000001));
    metal::float2 turned = metal::float2((axes.x * place.x) + (axes.y * place.y), (axes.y * place.x) - (axes.x * place.y));
    return ((0.5 * (_e9 + _e14)) * place) + ((0.5 * (_e9 - _e14)) * turned);
}

metal::float3 warped_light(
    metal::float3 light_6,
    metal::float3 n_1,
    metal::float3 view_4,
    metal::float3x3 camera_from_world,
    metal::float3 tensor_3,
    float amount_1,
    float slope_2
) {
    metal::float3 right = metal::float3(1.0, 0.0, 0.0) * camera_from_world;
    metal::float3 _e19 = normalize_or(right - (metal::dot(right, view_4) * view_4), metal::float3(1.0, 0.0, 0.0));
    metal::float3 y = metal::cross(view_4, _e19);
    metal::float3 between = (view_4 + n_1) / metal::float3(metal::max(1.0 + metal::dot(view_4, n_1), 0.01));
    metal::float3 along_x = _e19 - (metal::dot(n_1, _e19) * between);
    metal::float3 along_y = y - (metal::dot(n_1, y) * between);
    metal::float2 place_3 = metal::float2(metal::dot(light_6, along_x), metal::dot(light_6, along_y)) / metal::float2(metal::max(1.0 + metal::dot(light_6, n_1), 0.0001));
    metal::float2 _e45 = warped_place(tensor_3, place_3, amount_1, slope_2);
    float square_1 = metal::dot(_e45, _e45);
    metal::float3 _e60 = normalize_or((((2.0 * _e45.x) * along_x) + ((2.0 * _e45.y) * along_y)) + ((1.0 - square_1) * n_1), light_6);
    return _e60;
}

float seen_well(
    float facing
) {
    float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

Light light_warp(
    Light light_7,
    metal::float3 normal_5,
    float amount_2,
    float slope_3,
    metal::float3 tensor_4,
    metal::float3 view_5,
    metal::float3x3 camera_from_world_1
) {
    bool local_4 = {};
    metal::float3 _e7 = normalize_or(normal_5, view_5);
    float _e8 = bounded(amount_2);
    float _e13 = seen_well(metal::dot(_e7, view_5));
    float most = metal::clamp(_e8, -8.0, 8.0) * _e13;
    metal::float3 _e16 = tensor_safe(tensor_4);
    metal::float3 _e17 = warped_light(light_7.direction, _e7, view_5, camera_from_world_1, _e16, most, slope_3);
    if (!((most == 0.0))) {
        local_4 = slope_3 == 0.0;
    } else {
        local_4 = true;
    }
    bool is_flat = local_4;
    return Light {is_flat ? light_7.direction : _e17, light_7.own_direction, light_7.color, light_7.intensity};
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    metal::float3x3 _e11 = look.camera_from_world;
    Light _e12 = light_warp(_e3, surface_1.normal, 1.4, 0.03, surface_1.curvature_tensor, surface_1.view, _e11);
    float _e15 = reflectance_wrap(_e12, surface_1.normal, 0.6);
    Color _e17 = ramp_oklab(_e15, jade);
    float _e22 = reflectance_ggx(_e12, surface_1.normal, surface_1.view, 0.42, 0.09);
    Color _e28 = mix_colors_screen(_e17, metal::float4(1.0, 0.9569, 0.8627, 1.0), _e22);
    Light _e31 = look.back;
    float _e37 = rim(_e31, surface_1.normal, surface_1.view, 0.5, 0.8, 1.0);
    Color _e43 = mix_colors_screen(_e28, metal::float4(0.1843, 0.5608, 0.7216, 1.0), _e37);
    Composite _e44 = premultiplied(_e43);
    Color _e45 = output(_e44);
    return _e45;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_6 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_6 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_6 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_6.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    Varyings _e22 = out;
    const auto _tmp = _e22;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_6 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_6 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_6 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_6 = is_front ? _e7 : -(_e7);
    surface.normal = normal_6;
    metal::float4 _e15 = view_6.eye;
    float _e20 = view_6.eye.w;
    metal::float4 _e26 = view_6.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    metal::float4 _e40 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.curvature_tensor = _e40.xyz;
    Surface _e42 = surface;
    metal::float4 _e43 = shade(_e42, look);
    metal::float4 _e44 = finite_vec4_(_e43);
    return fs_mainOutput { _e44 };
}
