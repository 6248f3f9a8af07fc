// Travel poster: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// travel-poster.json says what to put there and how to draw.
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
    Light key;
    Light sky;
};
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
    float kappa;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Angle {
    float half_sin;
    float half_cos;
};
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
struct LitLayer {
    Color color;
    float tone;
    char _pad2[12];
};
struct ProfileShape {
    float half_cos_offset;
    float half_sin_offset;
    float scale;
    float exponent;
    float offset;
    float edge_mean;
    float edge_deviation;
    uint kind;
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
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant ProfileShape evening_sun_tone_shape = ProfileShape {1.0, 0.0, 1.0955735, 1.6395584, 0.0, 1.1385497, 0.5052584, 0u};
constant ProfileShape sky_tone_shape = ProfileShape {1.0, 0.0, 1.229384, 1.2860026, 0.0, 1.0836705, 0.44442755, 0u};
constant ProfileShape glow_tone_shape = ProfileShape {0.99875027, 0.04997917, 2.425296, 2.5857167, 0.1, 0.4039123, 0.17722374, 0u};
constant Ramp seven_inks = Ramp {type_6 {{metal::float4(0.0863, 0.1333, 0.2471, 1.0), metal::float4(0.1725, 0.3176, 0.3882, 1.0), metal::float4(0.4863, 0.2275, 0.2706, 1.0), metal::float4(0.7686, 0.3294, 0.2471, 1.0), metal::float4(0.8784, 0.5412, 0.298, 1.0), metal::float4(0.9412, 0.7608, 0.4824, 1.0), metal::float4(0.9843, 0.9333, 0.7961, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.15, 0.3, 0.45), metal::float4(0.6, 0.8, 1.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 7u, 0u};

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float whole = metal::rint(x);
    float f = x - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_1
) {
    float clamped_1 = metal::max(x_1, -126.0);
    float whole_1 = metal::rint(clamped_1);
    float f_1 = clamped_1 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_2
) {
    uint bits = as_type<uint>(x_2);
    int exponent_3 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_3) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_3) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

metal::float2 sin_cos_tiny(
    float x_3
) {
    float y_1 = x_3 * x_3;
    float s = x_3 * (1.0 + (y_1 * (-0.16666667 + (y_1 * 0.008333334))));
    float c = 1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * 0.0013888889)))));
    return metal::float2(s, c);
}

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen(
    metal::float3 v_1
) {
    metal::float3 _e5 = normalize_moderate(v_1, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_4 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_4, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_1 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_1, c_1);
    metal::float2 turned = ((s_1 <= 0.0) & (s_1 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_2 = u_2.half_sin - 0.0;
    metal::float2 upper_1 = (u_2.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, u_2.half_cos);
    metal::float2 turned_1 = ((s_2 <= 0.0) & (s_2 < u_2.half_cos)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

float powered(
    float base,
    float exponent
) {
    float magnitude = metal::abs(base);
    float _e5 = log2_stable(metal::max(magnitude, SMALLEST_NORMAL));
    float _e7 = exp2_stable(exponent * _e5);
    return (magnitude < SMALLEST_NORMAL) ? 0.0 : _e7;
}

float footprint_of(
    float x_4
) {
    float _e1 = metal::dfdx(x_4);
    float _e2 = metal::dfdy(x_4);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float stairs_integral(
    float x_5,
    float count
) {
    float inside = metal::min(x_5, count);
    float stair = metal::min(metal::floor(inside), 6.0);
    float beyond = metal::max(x_5 - count, 0.0);
    return (stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * 6.0);
}

float stairs_integral_2_(
    float x_6,
    float count_1
) {
    float inside_1 = metal::max(x_6, 0.0);
    float stair_1 = metal::floor(inside_1);
    return (stair_1 * (((0.5 * (stair_1 - 1.0)) + inside_1) - stair_1)) + 0.0;
}

float stairs_filtered(
    float x_7,
    float count_2,
    float w
) {
    if (w <= 1.0) {
        float edge = metal::clamp(metal::rint(x_7), 1.0, 6.0);
        return (edge - 1.0) + metal::clamp(0.5 + ((x_7 - edge) / w), 0.0, 1.0);
    }
    float half_1 = 0.5 * w;
    float _e22 = stairs_integral(x_7 + half_1, count_2);
    float _e24 = stairs_integral_2_(x_7 - half_1, count_2);
    return (_e22 - _e24) / (2.0 * half_1);
}

float linear_of_srgb(
    float coded
) {
    float size = metal::abs(coded);
    float _e6 = log2_stable((size + 0.055) / 1.055);
    float _e9 = exp2_stable(2.4 * _e6);
    float value = (size <= 0.04045) ? (size / 12.92) : _e9;
    return value;
}

float linear_of_srgb_2_(
    float coded_1
) {
    float size_1 = metal::abs(coded_1);
    float value_1 = (size_1 <= 0.04045) ? (size_1 / 12.92) : metal::pow((size_1 + 0.055) / 1.055, 2.4);
    return value_1;
}

float srgb_of_linear(
    float light
) {
    float size_2 = metal::abs(light);
    float _e3 = powered(size_2, 0.41666666);
    float value_2 = (size_2 <= 0.0031308) ? (size_2 * 12.92) : ((1.055 * _e3) - 0.055);
    return (light < 0.0) ? -(value_2) : value_2;
}

metal::float3 oklab_of_linear(
    metal::float3 rgb
) {
    float _e8 = powered(metal::abs(metal::dot(rgb, metal::float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    float _e16 = powered(metal::abs(metal::dot(rgb, metal::float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    float _e24 = powered(metal::abs(metal::dot(rgb, metal::float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return metal::float3(((0.21045426 * _e8) + (0.7936178 * _e16)) - (0.004072047 * _e24), ((1.9779985 * _e8) - (2.4285922 * _e16)) + (0.4505937 * _e24), ((0.025904037 * _e8) + (0.78277177 * _e16)) - (0.80867577 * _e24));
}

metal::float3 oklab_of_linear_2_(
    metal::float3 rgb_1
) {
    float l = metal::pow(metal::abs(metal::dot(rgb_1, metal::float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    float m = metal::pow(metal::abs(metal::dot(rgb_1, metal::float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    float s_3 = metal::pow(metal::abs(metal::dot(rgb_1, metal::float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return metal::float3(((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s_3), ((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s_3), ((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s_3));
}

metal::float3 oklab_of_linear_3_(
    metal::float3 rgb_2
) {
    float l_1 = metal::pow(metal::dot(rgb_2, metal::float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m_1 = metal::pow(metal::dot(rgb_2, metal::float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s_4 = metal::pow(metal::dot(rgb_2, metal::float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return metal::float3(((0.21045426 * l_1) + (0.7936178 * m_1)) - (0.004072047 * s_4), ((1.9779985 * l_1) - (2.4285922 * m_1)) + (0.4505937 * s_4), ((0.025904037 * l_1) + (0.78277177 * m_1)) - (0.80867577 * s_4));
}

metal::float3 linear_of_oklab(
    metal::float3 lab
) {
    float l_2 = (lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z);
    float m_2 = (lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z);
    float s_5 = (lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z);
    metal::float3 cubes = metal::float3((l_2 * l_2) * l_2, (m_2 * m_2) * m_2, (s_5 * s_5) * s_5);
    return metal::float3(metal::dot(cubes, metal::float3(4.0767417, -3.3077116, 0.23096994)), metal::dot(cubes, metal::float3(-1.268438, 2.6097574, -0.34131938)), metal::dot(cubes, metal::float3(-0.0041960864, -0.7034186, 1.7076147)));
}

metal::float3 oklab_of_srgb(
    metal::float3 coded_2
) {
    metal::float3 _e23 = oklab_of_linear_3_(metal::float3(metal::pow((coded_2.x + 0.055) / 1.055, 2.4), metal::pow((coded_2.y + 0.055) / 1.055, 2.4), metal::pow((coded_2.z + 0.055) / 1.055, 2.4)));
    return _e23;
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

metal::float3 palette_blend(
    Ramp palette,
    metal::float3 rgb_3,
    float softness
) {
    type_6 colors = {};
    uint i = 0u;
    metal::float3 found = metal::float3(0.0);
    float nearest = 1000000000000000000000000000000.0;
    colors = palette.colors;
    float _e6 = linear_of_srgb_2_(rgb_3.x);
    float _e8 = linear_of_srgb_2_(rgb_3.y);
    float _e10 = linear_of_srgb_2_(rgb_3.z);
    metal::float3 _e12 = oklab_of_linear_2_(metal::float3(_e6, _e8, _e10));
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e43 = i;
            i = _e43 + 1u;
        }
        loop_init = false;
        uint _e20 = i;
        if (!((_e20 < 7u))) {
            break;
        }
        uint _e24 = i;
        metal::float4 _e26 = colors.inner[_e24];
        metal::float3 _e28 = oklab_of_srgb(_e26.xyz);
        float far = metal::min(metal::length(_e28 - _e12), 100000000000000000000000000000.0);
        metal::float3 _e33 = found;
        uint _e34 = i;
        metal::float4 _e36 = colors.inner[_e34];
        float _e38 = nearest;
        found = (far < _e38) ? _e36.xyz : _e33;
        float _e41 = nearest;
        nearest = metal::min(_e41, far);
    }
    metal::float3 _e46 = found;
    return _e46;
}

Color posterize_lightness(
    Color color,
    int steps,
    float softness_1
) {
    float _e4 = linear_of_srgb(color.x);
    float _e6 = linear_of_srgb(color.y);
    float _e8 = linear_of_srgb(color.z);
    metal::float3 _e10 = oklab_of_linear(metal::float3(_e4, _e6, _e8));
    float _e19 = footprint_of(_e10.x);
    float _e24 = stairs_filtered(7.0 * metal::clamp(_e10.x, 0.0, 1.0), 7.0, metal::length(metal::float2(7.0 * _e19, softness_1)));
    float stepped = metal::clamp(_e24 / 6.0, 0.0, 1.0);
    float kept = (_e10.x > 0.0001) ? (stepped / metal::max(_e10.x, 0.0001)) : 0.0;
    metal::float3 _e44 = srgb_of_oklab(metal::float3(stepped, _e10.yz * metal::min(kept, 1.0)));
    return metal::float4(metal::clamp(_e44, metal::float3(0.0), metal::float3(1.0)), 1.0);
}

Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + (convexity * (convex - concave));
}

Composite blend_add(
    Composite below,
    Color color_1,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (tone * color_1.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light_1,
    Color color_2,
    float tone_1
) {
    metal::float2 split = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4((color_2.xyz * light_1.color) * split.y, 1.0), tone_1 * split.x};
}

Angle parametrization_specular_balanced(
    Light light_2,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d_1 = ((2.0 * metal::dot(normal, view)) * normal) - view;
    return Angle {0.5 * metal::length(d_1 - light_2.direction), 0.5 * metal::length(d_1 + light_2.direction)};
}

float profile_power(
    float q,
    float exponent_1
) {
    float log_base = 0.0;
    if (q >= 1.0) {
        return 0.0;
    }
    if (q < 0.5) {
        float _e11 = log1p_negative_small(q * q);
        log_base = LOG2_E * _e11;
    } else {
        float _e18 = log2_stable((1.0 - q) * (1.0 + q));
        log_base = _e18;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable(exponent_1 * _e19);
    return metal::min(_e21, 1.0);
}

float profile_point(
    Angle u_3,
    ProfileShape shape
) {
    float s_6 = u_3.half_sin - (u_3.half_cos * 0.0);
    if ((s_6 <= 0.0) | false) {
        return 1.0;
    }
    float q_2 = s_6 * shape.scale;
    float _e15 = profile_power(q_2, shape.exponent);
    return _e15;
}

float profile_point_2_(
    Angle u_4,
    ProfileShape shape_1
) {
    float s_7 = u_4.half_sin - 0.0;
    if ((s_7 <= 0.0) | false) {
        return 1.0;
    }
    float q_3 = s_7 * shape_1.scale;
    float _e13 = profile_power(q_3, shape_1.exponent);
    return _e13;
}

float profile_power_2_(
    float q_1,
    float exponent_2
) {
    float log_base_1 = 0.0;
    if (q_1 >= 1.0) {
        return 0.0;
    }
    if (q_1 < 0.5) {
        float _e11 = log1p_negative_small(q_1 * q_1);
        log_base_1 = LOG2_E * _e11;
    } else {
        float _e18 = log2_stable((1.0 - q_1) * (1.0 + q_1));
        log_base_1 = _e18;
    }
    float _e19 = log_base_1;
    float _e21 = exp2_stable_2_(exponent_2 * _e19);
    return metal::min(_e21, 1.0);
}

float profile_point_3_(
    Angle u_5,
    ProfileShape shape_2
) {
    float s_8 = (u_5.half_sin * shape_2.half_cos_offset) - (u_5.half_cos * shape_2.half_sin_offset);
    if ((s_8 <= 0.0) | false) {
        return 1.0;
    }
    float q_4 = s_8 * shape_2.scale;
    float _e17 = profile_power_2_(q_4, shape_2.exponent);
    return _e17;
}

float profile_filtered(
    Angle u_6,
    float w_1,
    ProfileShape shape_3
) {
    float _e3 = profile_point(u_6, shape_3);
    bool is_wide = w_1 < (0.1 * shape_3.edge_deviation);
    if ((is_wide | (w_1 <= 0.0)) | false) {
        return _e3;
    }
    metal::float2 _e15 = sin_cos_tiny(0.19364917 * w_1);
    Angle _e16 = angle_turned(u_6, _e15);
    float _e17 = profile_point(_e16, shape_3);
    Angle _e22 = angle_turned(u_6, metal::float2(-(_e15.x), _e15.y));
    float _e23 = profile_point(_e22, shape_3);
    return (((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0;
}

float profile_filtered_2_(
    Angle u_7,
    float w_2,
    ProfileShape shape_4
) {
    float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_1 = w_2 < (0.1 * shape_4.edge_deviation);
    if ((is_wide_1 | (w_2 <= 0.0)) | false) {
        return _e3;
    }
    metal::float2 _e15 = sin_cos_tiny(0.19364917 * w_2);
    Angle _e16 = angle_turned(u_7, _e15);
    float _e17 = profile_point_2_(_e16, shape_4);
    Angle _e22 = angle_turned(u_7, metal::float2(-(_e15.x), _e15.y));
    float _e23 = profile_point(_e22, shape_4);
    return (((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0;
}

float profile_filtered_3_(
    Angle u_8,
    float w_3,
    ProfileShape shape_5
) {
    float _e3 = profile_point_3_(u_8, shape_5);
    bool is_wide_2 = w_3 < (0.1 * shape_5.edge_deviation);
    if ((is_wide_2 | (w_3 <= 0.0)) | false) {
        return _e3;
    }
    metal::float2 _e15 = sin_cos_tiny(0.19364917 * w_3);
    Angle _e16 = angle_turned(u_8, _e15);
    float _e17 = profile_point_3_(_e16, shape_5);
    Angle _e22 = angle_turned(u_8, metal::float2(-(_e15.x), _e15.y));
    float _e23 = profile_point_3_(_e22, shape_5);
    return (((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0;
}

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_6
) {
    metal::float2 _e5 = sin_cos_tiny(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_6);
    return _e8;
}

float profile_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_7
) {
    Angle _e6 = angle_turned_2_(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_3_(
    Angle angle_2,
    float shift_2,
    ProfileShape shape_8
) {
    Angle _e6 = angle_turned_2_(angle_2, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float evening_sun_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.12, -20.0, 20.0))))));
    Color _e30 = curvature_color(evening_sun_convexity, metal::float4(0.93, 0.62, 0.36, 1.0), metal::float4(0.66, 0.24, 0.24, 1.0));
    metal::float3 _e35 = look.key.direction;
    metal::float3 _e44 = look.key.direction;
    Angle evening_sun_angle = Angle {0.5 * metal::length(surface.normal - _e35), 0.5 * metal::length(surface.normal + _e44)};
    float evening_sun_warp = ((2.0 * evening_sun_convexity) - 1.0) * 0.1;
    float _e57 = profile(evening_sun_angle, evening_sun_warp, evening_sun_tone_shape);
    Light _e60 = look.key;
    LitLayer _e61 = light_apply(_e60, _e30, _e57);
    Composite _e71 = blend_add(metal::float4(0.07, 0.1, 0.22, 1.0), _e61.color, _e61.tone, 1.0, true);
    metal::float3 _e76 = look.sky.direction;
    metal::float3 _e85 = look.sky.direction;
    Angle sky_angle = Angle {0.5 * metal::length(surface.normal - _e76), 0.5 * metal::length(surface.normal + _e85)};
    float _e93 = profile_2_(sky_angle, 0.0, sky_tone_shape);
    Light _e96 = look.sky;
    LitLayer _e102 = light_apply(_e96, metal::float4(0.02, 0.24, 0.3, 1.0), _e93);
    Composite _e107 = blend_add(_e71, _e102.color, _e102.tone, 1.0, true);
    Light _e110 = look.key;
    Angle _e113 = parametrization_specular_balanced(_e110, surface.normal, surface.view);
    float _e116 = profile_3_(_e113, 0.0, glow_tone_shape);
    Light _e119 = look.key;
    LitLayer _e125 = light_apply(_e119, metal::float4(0.42, 0.38, 0.24, 1.0), _e116);
    Composite _e130 = blend_add(_e107, _e125.color, _e125.tone, 1.0, true);
    Color _e133 = posterize_lightness(_e130, 7, 0.02);
    metal::float3 _e137 = palette_blend(seven_inks, _e133.xyz, 0.0);
    metal::float4 seven_inks_2_ = metal::float4(_e137, 1.0);
    return seven_inks_2_;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_1 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_1 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e23 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position)), _e23.x};
    metal::float4 _e26 = shade(surface_1, look);
    return fs_mainOutput { _e26 };
}
