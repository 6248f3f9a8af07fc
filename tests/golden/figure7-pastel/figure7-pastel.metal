// Pastel: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure7-pastel.json says what to put there and how to draw.
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
struct Look {
    Light back;
    Light key;
    float light_warp_amount;
    char _pad3[12];
    ProfileShape light_tone_shape;
    float shade_warp_amount;
    char _pad5[12];
    Light cool;
    ProfileShape shade_tone_shape;
    float shade_blend_opacity;
    float light_blend_opacity;
    float reddish_rim_blend_opacity;
    char _pad10[4];
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
struct LitLayer {
    Color color;
    float tone;
    char _pad2[12];
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
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape white_chalk_tone_shape = ProfileShape {0.99875027, 0.04997917, 3.1317647, 2.7420828, 0.1, 0.3043368, 0.13399889, 0u};
constant ProfileShape reddish_rim_tone_shape = ProfileShape {0.9887711, 0.14943813, 2.5679324, 1.9696738, 0.3, 0.42241916, 0.17683415, 0u};

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

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent_3 = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent_3) != exponent_3);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x_2
) {
    float clamped_3 = metal::clamp(x_2, -126.0, 127.99999);
    float whole = metal::rint(clamped_3);
    float f = clamped_3 - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_3
) {
    float clamped_4 = metal::max(x_3, -126.0);
    float whole_1 = metal::rint(clamped_4);
    float f_1 = clamped_4 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_3_(
    float x_4
) {
    float whole_2 = metal::rint(x_4);
    float f_2 = x_4 - whole_2;
    float twice_2 = 2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724)))))))))));
    return twice_2 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_2)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_5
) {
    uint bits = as_type<uint>(x_5);
    int exponent_4 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_4) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_4) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

metal::float2 sin_cos_quarter(
    float x_6
) {
    float h = 0.5 * x_6;
    float h2_ = h * h;
    float s = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s) * c, 1.0 - ((2.0 * s) * s));
}

metal::float2 sin_cos_eighth(
    float x_7
) {
    float y_2 = x_7 * x_7;
    float s_1 = x_7 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 0.0000027557319))))))));
    float c_1 = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-0.000024801588 + (y_2 * 0.0000002755732)))))))));
    return metal::float2(s_1, c_1);
}

metal::float2 sin_cos_tiny(
    float x_8
) {
    float y_3 = x_8 * x_8;
    float s_2 = x_8 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334))));
    float c_2 = 1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889)))));
    return metal::float2(s_2, c_2);
}

metal::float3 normalize_moderate(
    metal::float3 v_1,
    metal::float3 otherwise_1
) {
    float square = metal::dot(v_1, v_1);
    return (square > 0.000000000000000000000000000001) ? (v_1 * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise_1;
}

metal::float3 normalize_seen(
    metal::float3 v_2
) {
    metal::float3 _e5 = normalize_moderate(v_2, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(
    float y_1,
    float x_9
) {
    float small = metal::min(y_1, x_9);
    float large = metal::max(y_1, x_9);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_1 = small / large;
    bool is_wide = t_1 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_1;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y_1 > x_9) ? (HALF_PI - a) : a;
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_3 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    float _e13 = finite_or(w_3, 0.5);
    return metal::min(_e13, 0.5);
}

float angle_footprint_2_(
    Angle u_1
) {
    metal::float2 half_1 = metal::float2(u_1.half_sin, u_1.half_cos);
    metal::float2 dx_1 = metal::dfdx(half_1);
    metal::float2 dy_1 = metal::dfdy(half_1);
    float w_4 = 2.0 * metal::sqrt(metal::dot(dx_1, dx_1) + metal::dot(dy_1, dy_1));
    return metal::min(w_4, 0.5);
}

Angle angle_turned(
    Angle u_2,
    metal::float2 t
) {
    float s_3 = (u_2.half_sin * t.y) - (u_2.half_cos * t.x);
    float c_3 = (u_2.half_cos * t.y) + (u_2.half_sin * t.x);
    metal::float2 upper = (c_3 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, c_3);
    metal::float2 turned = ((s_3 <= 0.0) & (s_3 < c_3)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + (convexity * (convex - concave));
}

float curvature_signed(
    float kappa,
    float slope
) {
    float a_1 = (((as_type<uint>(kappa) & 2147483647u) > 2139095040u) ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0)) * slope;
    float magnitude = metal::min(metal::abs(a_1), 50.0);
    if (magnitude < 0.0625) {
        float a2_ = a_1 * a_1;
        return a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e32 = exp2_stable(-2.88539 * magnitude);
    float t_2 = (1.0 - _e32) / (1.0 + _e32);
    return (a_1 >= 0.0) ? t_2 : -(t_2);
}

Composite blend_finish(
    Composite below,
    metal::float3 blended,
    float alpha,
    float opacity,
    bool clamped
) {
    if (opacity <= 0.0) {
        return below;
    }
    metal::float4 mixed = metal::float4(below.xyz + (opacity * (blended - below.xyz)), alpha);
    return metal::clamp(mixed, metal::float4(0.0), metal::float4(1.0));
}

Composite blend_alpha(
    Composite below_1,
    Color color,
    float tone,
    float opacity_1,
    bool clamped_1
) {
    float alpha_1 = below_1.w + ((tone * opacity_1) * (1.0 - below_1.w));
    return metal::clamp(metal::float4(below_1.xyz + (opacity_1 * ((below_1.xyz + (tone * (color.xyz - below_1.xyz))) - below_1.xyz)), alpha_1), metal::float4(0.0), metal::float4(1.0));
}

Composite blend_shade(
    Composite below_2,
    Color color_1,
    float tone_1,
    float opacity_2,
    bool clamped_2
) {
    return metal::clamp(metal::float4(below_2.xyz + (opacity_2 * ((below_2.xyz * metal::mix(metal::float3(1.0), color_1.xyz, tone_1)) - below_2.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_2,
    float tone_2
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_2.xyz * light.color) * split.y, 1.0), split.x};
}

LitLayer light_apply_2_(
    Light light_1,
    Color color_3,
    float tone_3
) {
    metal::float2 split_1 = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4((color_3.xyz * light_1.color) * split_1.y, 1.0), tone_3 * split_1.x};
}

Angle parametrization_specular(
    Light light_2,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 mirrored = ((2.0 * metal::dot(normal, view)) * normal) - view;
    metal::float3 _e8 = normalize_moderate(mirrored, normal);
    return Angle {0.5 * metal::length(_e8 - light_2.direction), 0.5 * metal::length(_e8 + light_2.direction)};
}

float profile_power(
    float q,
    float exponent
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
    float _e21 = exp2_stable(exponent * _e19);
    return metal::clamp(_e21, 0.0, 1.0);
}

float profile_point(
    Angle u_3,
    ProfileShape shape
) {
    float s_4 = (u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset);
    if ((s_4 <= 0.0) | (shape.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    if (shape.kind == PROFILE_STEP) {
        return (s_4 <= 0.0000004) ? 1.0 : 0.0;
    }
    float q_3 = s_4 * shape.scale;
    float _e27 = profile_power(q_3, shape.exponent);
    return _e27;
}

float profile_power_2_(
    float q_1,
    float exponent_1
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
    float _e21 = exp2_stable_2_(exponent_1 * _e19);
    return metal::min(_e21, 1.0);
}

float profile_point_2_(
    Angle u_4,
    ProfileShape shape_1
) {
    float s_5 = (u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset);
    if ((s_5 <= 0.0) | false) {
        return 1.0;
    }
    float q_4 = s_5 * shape_1.scale;
    float _e17 = profile_power_2_(q_4, shape_1.exponent);
    return _e17;
}

float profile_power_3_(
    float q_2,
    float exponent_2
) {
    float log_base_2 = 0.0;
    if (q_2 >= 1.0) {
        return 0.0;
    }
    if (q_2 < 0.5) {
        float _e11 = log1p_negative_small(q_2 * q_2);
        log_base_2 = LOG2_E * _e11;
    } else {
        float _e18 = log2_stable((1.0 - q_2) * (1.0 + q_2));
        log_base_2 = _e18;
    }
    float _e19 = log_base_2;
    float _e21 = exp2_stable_3_(exponent_2 * _e19);
    return metal::min(_e21, 1.0);
}

float profile_point_3_(
    Angle u_5,
    ProfileShape shape_2
) {
    float s_6 = (u_5.half_sin * shape_2.half_cos_offset) - (u_5.half_cos * shape_2.half_sin_offset);
    if ((s_6 <= 0.0) | false) {
        return 1.0;
    }
    float q_5 = s_6 * shape_2.scale;
    float _e17 = profile_power_3_(q_5, shape_2.exponent);
    return _e17;
}

float profile_filtered(
    Angle u_6,
    float w,
    ProfileShape shape_3
) {
    float _e3 = profile_point(u_6, shape_3);
    bool is_wide_1 = w < (0.1 * shape_3.edge_deviation);
    if ((is_wide_1 | (w <= 0.0)) | (shape_3.kind == PROFILE_AMBIENT)) {
        return _e3;
    }
    if ((shape_3.edge_deviation < 0.145) & (w >= (3.4641016 * shape_3.edge_deviation))) {
        float width = metal::sqrt((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation));
        float _e36 = atan2_positive(u_6.half_sin, u_6.half_cos);
        return metal::clamp(0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e36)) / width), 0.0, 1.0);
    }
    metal::float2 _e48 = sin_cos_tiny(0.19364917 * w);
    Angle _e49 = angle_turned(u_6, _e48);
    float _e50 = profile_point(_e49, shape_3);
    Angle _e55 = angle_turned(u_6, metal::float2(-(_e48.x), _e48.y));
    float _e56 = profile_point(_e55, shape_3);
    return (((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0;
}

float profile_filtered_2_(
    Angle u_7,
    float w_1,
    ProfileShape shape_4
) {
    float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_2 = w_1 < (0.1 * shape_4.edge_deviation);
    if ((is_wide_2 | (w_1 <= 0.0)) | false) {
        return _e3;
    }
    if (true & (w_1 >= (3.4641016 * shape_4.edge_deviation))) {
        float width_1 = metal::sqrt((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation));
        float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return metal::clamp(0.5 + (((shape_4.offset + shape_4.edge_mean) - (2.0 * _e32)) / width_1), 0.0, 1.0);
    }
    metal::float2 _e44 = sin_cos_tiny(0.19364917 * w_1);
    Angle _e45 = angle_turned(u_7, _e44);
    float _e46 = profile_point_2_(_e45, shape_4);
    Angle _e51 = angle_turned(u_7, metal::float2(-(_e44.x), _e44.y));
    float _e52 = profile_point_2_(_e51, shape_4);
    return (((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0;
}

float profile_filtered_3_(
    Angle u_8,
    float w_2,
    ProfileShape shape_5
) {
    float _e3 = profile_point_3_(u_8, shape_5);
    bool is_wide_3 = w_2 < (0.1 * shape_5.edge_deviation);
    if ((is_wide_3 | (w_2 <= 0.0)) | false) {
        return _e3;
    }
    metal::float2 _e15 = sin_cos_tiny(0.19364917 * w_2);
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
    metal::float2 _e8 = sin_cos_quarter(0.5 * metal::clamp(shift, -3.1415927, PI));
    Angle _e9 = angle_turned(angle, _e8);
    float _e10 = angle_footprint(_e9);
    float _e11 = profile_filtered(_e9, _e10, shape_6);
    return _e11;
}

float profile_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_7
) {
    metal::float2 _e5 = sin_cos_eighth(0.5 * shift_1);
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint_2_(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_3_(
    Angle angle_2,
    float shift_2,
    ProfileShape shape_8
) {
    metal::float2 _e5 = sin_cos_tiny(0.5 * shift_2);
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint_2_(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    float _e3 = curvature_signed(surface_1.kappa, 0.14);
    float light_convexity = 0.5 + (0.5 * _e3);
    Color _e18 = curvature_color(light_convexity, metal::float4(0.9647, 0.9059, 0.8157, 1.0), metal::float4(0.6118, 0.2902, 0.1961, 1.0));
    Light _e21 = look.key;
    LitLayer _e23 = light_apply(_e21, _e18, 1.0);
    Composite _e33 = blend_shade(metal::float4(0.9137, 0.8627, 0.7765, 1.0), _e23.color, _e23.tone, 0.9, true);
    Color _e44 = curvature_color(light_convexity, metal::float4(0.7686, 0.4157, 0.2824, 1.0), metal::float4(0.4863, 0.1765, 0.1216, 1.0));
    metal::float3 _e49 = look.cool.direction;
    metal::float3 _e58 = look.cool.direction;
    Angle shade_angle = Angle {0.5 * metal::length(surface_1.normal - _e49), 0.5 * metal::length(surface_1.normal + _e58)};
    float _e70 = look.shade_warp_amount;
    float shade_warp = ((2.0 * light_convexity) - 1.0) * metal::clamp(_e70, -3.1415927, 3.1415927);
    ProfileShape _e77 = look.shade_tone_shape;
    float _e78 = profile(shade_angle, shade_warp, _e77);
    Light _e81 = look.cool;
    LitLayer _e82 = light_apply_2_(_e81, _e44, _e78);
    float _e94 = look.shade_blend_opacity;
    Composite _e96 = blend_finish(_e33, _e33.xyz * metal::mix(metal::float3(1.0), _e82.color.xyz, _e82.tone), 1.0, _e94, true);
    Color _e107 = curvature_color(light_convexity, metal::float4(1.0, 0.9725, 0.9176, 1.0), metal::float4(0.9098, 0.7059, 0.5686, 1.0));
    metal::float3 _e112 = look.key.direction;
    metal::float3 _e121 = look.key.direction;
    Angle light_angle = Angle {0.5 * metal::length(surface_1.normal - _e112), 0.5 * metal::length(surface_1.normal + _e121)};
    float _e133 = look.light_warp_amount;
    float light_warp = ((2.0 * light_convexity) - 1.0) * metal::clamp(_e133, -3.1415927, 3.1415927);
    ProfileShape _e140 = look.light_tone_shape;
    float _e141 = profile(light_angle, light_warp, _e140);
    Light _e144 = look.key;
    LitLayer _e145 = light_apply_2_(_e144, _e107, _e141);
    float _e157 = look.light_blend_opacity;
    float _e165 = look.light_blend_opacity;
    Composite _e167 = blend_finish(_e96, _e96.xyz + (_e145.tone * (_e145.color.xyz - _e96.xyz)), 1.0 + ((_e145.tone * _e157) * 0.0), _e165, true);
    float _e170 = curvature_signed(surface_1.kappa, 0.3);
    float white_chalk_convexity = 0.5 + (0.5 * _e170);
    Color _e182 = curvature_color(white_chalk_convexity, metal::float4(1.0), metal::float4(1.0, 0.9412, 0.8627, 1.0));
    Light _e185 = look.key;
    Angle _e188 = parametrization_specular(_e185, surface_1.normal, surface_1.view);
    float white_chalk_warp = ((2.0 * white_chalk_convexity) - 1.0) * 0.3;
    float _e196 = profile_2_(_e188, white_chalk_warp, white_chalk_tone_shape);
    Light _e199 = look.key;
    LitLayer _e200 = light_apply_2_(_e199, _e182, _e196);
    Composite _e205 = blend_alpha(_e167, _e200.color, _e200.tone, 0.85, true);
    float _e208 = curvature_signed(surface_1.kappa, 0.2);
    float reddish_rim_convexity = 0.5 + (0.5 * _e208);
    Color _e223 = curvature_color(reddish_rim_convexity, metal::float4(0.7059, 0.3294, 0.2275, 1.0), metal::float4(0.4784, 0.1647, 0.1098, 1.0));
    metal::float3 _e228 = look.back.direction;
    metal::float3 _e237 = look.back.direction;
    Angle reddish_rim_angle = Angle {0.5 * metal::length(surface_1.normal - _e228), 0.5 * metal::length(surface_1.normal + _e237)};
    float reddish_rim_warp = ((2.0 * reddish_rim_convexity) - 1.0) * 0.1;
    float _e250 = profile_3_(reddish_rim_angle, reddish_rim_warp, reddish_rim_tone_shape);
    Light _e253 = look.back;
    LitLayer _e254 = light_apply_2_(_e253, _e223, _e250);
    float _e266 = look.reddish_rim_blend_opacity;
    Composite _e268 = blend_finish(_e205, _e205.xyz * metal::mix(metal::float3(1.0), _e254.color.xyz, _e254.tone), _e205.w, _e266, true);
    metal::float4 _e279 = finite_vec4_((_e268.w <= 0.0) ? _e268 : metal::float4(_e268.xyz / metal::float3(_e268.w), _e268.w));
    return _e279;
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
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_1.clip_from_world;
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
    Surface surface = {};
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    surface.normal = normal_1;
    metal::float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = metal::normalize(_e11.xyz - (_e16 * in.position));
    metal::float4 _e27 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.kappa = _e27.x;
    Surface _e29 = surface;
    metal::float4 _e30 = shade(_e29, look);
    metal::float4 _e31 = finite_vec4_(_e30);
    return fs_mainOutput { _e31 };
}
