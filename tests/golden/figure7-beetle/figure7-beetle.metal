// Beetle: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure7-beetle.json says what to put there and how to draw.
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
    metal::float4 hollows_color_concave;
    Light key;
    metal::float4 green_sheen_color_convex;
    metal::float4 gold_color_convex;
    Light side;
    metal::float4 wing_case_color_convex;
    metal::float4 wing_case_color_concave;
    ProfileShape wing_case_tone_shape;
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
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape violet_tone_shape = ProfileShape {0.98472655, 0.17410813, 2.425296, 2.1444545, 0.35, 0.43399706, 0.1847509, 0u};
constant ProfileShape gold_tone_shape = ProfileShape {0.9887711, 0.14943813, 3.6826046, 2.8423793, 0.3, 0.2547288, 0.11251208, 0u};
constant ProfileShape green_sheen_tone_shape = ProfileShape {0.99820054, 0.059964005, 5.2949586, 2.6937559, 0.12, 0.1805348, 0.07889118, 0u};
constant ProfileShape glint_tone_shape = ProfileShape {0.99955004, 0.029995501, 25.006668, 2.4986002, 0.06, 0.039271776, 0.016918294, 0u};

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float clamped_2 = metal::clamp(x, -126.0, 127.99999);
    float whole = metal::rint(clamped_2);
    float f = clamped_2 - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_1
) {
    float whole_1 = metal::rint(x_1);
    float f_1 = x_1 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_3_(
    float x_2
) {
    float clamped_3 = metal::max(x_2, -126.0);
    float whole_2 = metal::rint(clamped_3);
    float f_2 = clamped_3 - whole_2;
    float twice_2 = 2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724)))))))))));
    return twice_2 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_2)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
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

metal::float2 sin_cos_eighth(
    float x_4
) {
    float y_2 = x_4 * x_4;
    float s = x_4 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 0.0000027557319))))))));
    float c = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-0.000024801588 + (y_2 * 0.0000002755732)))))))));
    return metal::float2(s, c);
}

metal::float2 sin_cos_tiny(
    float x_5
) {
    float y_3 = x_5 * x_5;
    float s_1 = x_5 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334))));
    float c_1 = 1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889)))));
    return metal::float2(s_1, c_1);
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

float atan2_positive(
    float y_1,
    float x_6
) {
    float small = metal::min(y_1, x_6);
    float large = metal::max(y_1, x_6);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_1 = small / large;
    bool is_wide = t_1 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_1;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y_1 > x_6) ? (HALF_PI - a) : a;
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_3 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_3, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_2 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_2 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_2 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_2);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < c_2)) ? metal::float2(0.0, 1.0) : upper;
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

Composite blend_add(
    Composite below_1,
    Color color,
    float tone,
    float opacity_1,
    bool clamped_1
) {
    Composite _e11 = blend_finish(below_1, below_1.xyz + (tone * color.xyz), 1.0, color.w, clamped_1);
    return _e11;
}

metal::float2 light_split(
    float intensity
) {
    return metal::float2(metal::min(intensity, 1.0), metal::max(intensity, 1.0));
}

LitLayer light_apply(
    Light light,
    Color color_1,
    float tone_1
) {
    metal::float2 _e4 = light_split(light.intensity);
    return LitLayer {metal::float4((color_1.xyz * light.color) * _e4.y, color_1.w), tone_1 * _e4.x};
}

LitLayer light_apply_2_(
    Light light_1,
    Color color_2,
    float tone_2
) {
    metal::float2 split = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4((color_2.xyz * light_1.color) * split.y, 1.0), tone_2 * split.x};
}

LitLayer light_apply_3_(
    Light light_2,
    Color color_3,
    float tone_3
) {
    metal::float2 split_1 = metal::float2(metal::min(light_2.intensity, 1.0), metal::max(light_2.intensity, 1.0));
    return LitLayer {metal::float4((color_3.xyz * light_2.color) * split_1.y, color_3.w), split_1.x};
}

Angle parametrization_specular(
    Light light_3,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 mirrored = ((2.0 * metal::dot(normal, view)) * normal) - view;
    metal::float3 _e8 = normalize_moderate(mirrored, normal);
    return Angle {0.5 * metal::length(_e8 - light_3.direction), 0.5 * metal::length(_e8 + light_3.direction)};
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
    Angle u_2,
    ProfileShape shape
) {
    float s_3 = (u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset);
    if ((s_3 <= 0.0) | (shape.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    if (shape.kind == PROFILE_STEP) {
        return (s_3 <= 0.0000004) ? 1.0 : 0.0;
    }
    float q_3 = s_3 * shape.scale;
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
    Angle u_3,
    ProfileShape shape_1
) {
    float s_4 = (u_3.half_sin * shape_1.half_cos_offset) - (u_3.half_cos * shape_1.half_sin_offset);
    if ((s_4 <= 0.0) | false) {
        return 1.0;
    }
    float q_4 = s_4 * shape_1.scale;
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
    Angle u_4,
    ProfileShape shape_2
) {
    float s_5 = (u_4.half_sin * shape_2.half_cos_offset) - (u_4.half_cos * shape_2.half_sin_offset);
    if ((s_5 <= 0.0) | false) {
        return 1.0;
    }
    float q_5 = s_5 * shape_2.scale;
    float _e17 = profile_power_3_(q_5, shape_2.exponent);
    return _e17;
}

float profile_filtered(
    Angle u_5,
    float w,
    ProfileShape shape_3
) {
    float _e3 = profile_point(u_5, shape_3);
    bool is_wide_1 = w < (0.1 * shape_3.edge_deviation);
    if ((is_wide_1 | (w <= 0.0)) | (shape_3.kind == PROFILE_AMBIENT)) {
        return _e3;
    }
    if ((shape_3.edge_deviation < 0.145) & (w >= (3.4641016 * shape_3.edge_deviation))) {
        float width = metal::sqrt((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation));
        float _e36 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return metal::clamp(0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e36)) / width), 0.0, 1.0);
    }
    metal::float2 _e48 = sin_cos_tiny(0.19364917 * w);
    Angle _e49 = angle_turned(u_5, _e48);
    float _e50 = profile_point(_e49, shape_3);
    Angle _e55 = angle_turned(u_5, metal::float2(-(_e48.x), _e48.y));
    float _e56 = profile_point(_e55, shape_3);
    return (((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0;
}

float profile_filtered_2_(
    Angle u_6,
    float w_1,
    ProfileShape shape_4
) {
    float _e3 = profile_point_2_(u_6, shape_4);
    bool is_wide_2 = w_1 < (0.1 * shape_4.edge_deviation);
    if ((is_wide_2 | (w_1 <= 0.0)) | false) {
        return _e3;
    }
    metal::float2 _e15 = sin_cos_tiny(0.19364917 * w_1);
    Angle _e16 = angle_turned(u_6, _e15);
    float _e17 = profile_point_2_(_e16, shape_4);
    Angle _e22 = angle_turned(u_6, metal::float2(-(_e15.x), _e15.y));
    float _e23 = profile_point_2_(_e22, shape_4);
    return (((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0;
}

float profile_filtered_3_(
    Angle u_7,
    float w_2,
    ProfileShape shape_5
) {
    float _e3 = profile_point_3_(u_7, shape_5);
    bool is_wide_3 = w_2 < (0.1 * shape_5.edge_deviation);
    if ((is_wide_3 | (w_2 <= 0.0)) | false) {
        return _e3;
    }
    if (true & (w_2 >= (3.4641016 * shape_5.edge_deviation))) {
        float width_1 = metal::sqrt((w_2 * w_2) + ((12.0 * shape_5.edge_deviation) * shape_5.edge_deviation));
        float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return metal::clamp(0.5 + (((shape_5.offset + shape_5.edge_mean) - (2.0 * _e32)) / width_1), 0.0, 1.0);
    }
    metal::float2 _e44 = sin_cos_tiny(0.19364917 * w_2);
    Angle _e45 = angle_turned(u_7, _e44);
    float _e46 = profile_point_3_(_e45, shape_5);
    Angle _e51 = angle_turned(u_7, metal::float2(-(_e44.x), _e44.y));
    float _e52 = profile_point_3_(_e51, shape_5);
    return (((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0;
}

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_6
) {
    metal::float2 _e5 = sin_cos_eighth(0.5 * shift);
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
    metal::float2 _e5 = sin_cos_tiny(0.5 * shift_1);
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
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
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    float _e3 = curvature_signed(surface_1.kappa, 0.2);
    float glint_convexity = 0.5 + (0.5 * _e3);
    metal::float4 _e10 = look.wing_case_color_concave;
    metal::float4 _e13 = look.wing_case_color_convex;
    metal::float4 _e16 = look.wing_case_color_concave;
    metal::float4 wing_case_color = _e10 + (glint_convexity * (_e13 - _e16));
    metal::float3 _e24 = look.key.direction;
    metal::float3 _e33 = look.key.direction;
    Angle hollows_angle = Angle {0.5 * metal::length(surface_1.normal - _e24), 0.5 * metal::length(surface_1.normal + _e33)};
    float wing_case_warp = ((2.0 * glint_convexity) - 1.0) * 0.2;
    ProfileShape _e47 = look.wing_case_tone_shape;
    float _e48 = profile(hollows_angle, wing_case_warp, _e47);
    Light _e51 = look.key;
    LitLayer _e52 = light_apply(_e51, wing_case_color, _e48);
    Composite _e62 = blend_add(metal::float4(0.0157, 0.0627, 0.0392, 1.0), _e52.color, _e52.tone, 1.0, true);
    Color _e73 = curvature_color(glint_convexity, metal::float4(0.3529, 0.1647, 0.4314, 1.0), metal::float4(0.1098, 0.0627, 0.251, 1.0));
    Light _e76 = look.side;
    Angle _e79 = parametrization_specular(_e76, surface_1.normal, surface_1.view);
    float gold_warp = ((2.0 * glint_convexity) - 1.0) * 0.15;
    float _e87 = profile_2_(_e79, gold_warp, violet_tone_shape);
    Light _e90 = look.side;
    LitLayer _e91 = light_apply_2_(_e90, _e73, _e87);
    metal::float4 violet_blend = metal::clamp(metal::float4(_e62.xyz + (_e91.tone * _e91.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float4 _e107 = look.gold_color_convex;
    Color _e113 = curvature_color(glint_convexity, _e107, metal::float4(0.2902, 0.3529, 0.0627, 1.0));
    Light _e116 = look.key;
    Angle _e119 = parametrization_specular(_e116, surface_1.normal, surface_1.view);
    float _e121 = profile_3_(_e119, gold_warp, gold_tone_shape);
    Light _e124 = look.key;
    LitLayer _e125 = light_apply(_e124, _e113, _e121);
    Composite _e136 = blend_finish(violet_blend, violet_blend.xyz + (_e125.tone * _e125.color.xyz), 1.0, _e125.color.w, true);
    metal::float4 _e139 = look.green_sheen_color_convex;
    Color _e145 = curvature_color(glint_convexity, _e139, metal::float4(0.1647, 0.5412, 0.3529, 1.0));
    float green_sheen_warp = ((2.0 * glint_convexity) - 1.0) * 0.1;
    float _e153 = profile_3_(_e119, green_sheen_warp, green_sheen_tone_shape);
    Light _e156 = look.key;
    LitLayer _e157 = light_apply(_e156, _e145, _e153);
    Composite _e168 = blend_finish(_e136, _e136.xyz + (_e157.tone * _e157.color.xyz), 1.0, _e157.color.w, true);
    Color _e176 = curvature_color(glint_convexity, metal::float4(1.0), metal::float4(0.8471, 1.0, 0.8784, 1.0));
    float glint_warp = ((2.0 * glint_convexity) - 1.0) * 0.05;
    float _e184 = profile_3_(_e119, glint_warp, glint_tone_shape);
    Light _e187 = look.key;
    LitLayer _e188 = light_apply_2_(_e187, _e176, _e184);
    metal::float4 glint_blend = metal::clamp(metal::float4(_e168.xyz + (_e188.tone * (_e188.color.xyz - _e168.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float _e206 = curvature_signed(surface_1.kappa, 0.3);
    float hollows_convexity = 0.5 + (0.5 * _e206);
    metal::float4 _e213 = look.hollows_color_concave;
    metal::float4 _e218 = look.hollows_color_concave;
    metal::float4 hollows_color = _e213 + (hollows_convexity * (metal::float4(1.0) - _e218));
    Light _e224 = look.key;
    LitLayer _e226 = light_apply_3_(_e224, hollows_color, 1.0);
    Composite _e237 = blend_finish(glint_blend, glint_blend.xyz * (_e226.tone * _e226.color.xyz), 1.0, _e226.color.w, true);
    return _e237;
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
    return fs_mainOutput { _e30 };
}
