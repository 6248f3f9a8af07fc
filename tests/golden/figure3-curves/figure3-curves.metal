// Profile curves: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1).
// figure3-curves.json says what to put there and how to draw.
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
struct Surface {
    metal::float2 uv;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Angle {
    float half_sin;
    float half_cos;
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
struct VectorParts {
    float x;
    float y;
    float z;
};
struct Vertex {
    metal::float3 position;
    metal::float2 uv;
    char _pad2[8];
};
struct Varyings {
    metal::float4 clip;
    metal::float2 uv;
    char _pad2[8];
};
constant float PI = 3.1415927;
constant float LOG2_E = 1.442695;
constant ProfileShape lambert_shape = ProfileShape {1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u};
constant ProfileShape half_lambert_shape = ProfileShape {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u};
constant ProfileShape custom_shape = ProfileShape {0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928, 0.2351043, 0u};

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

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x_2
) {
    float whole = metal::rint(x_2);
    float f = x_2 - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_3
) {
    float clamped_2 = metal::max(x_3, -126.0);
    float whole_1 = metal::rint(clamped_2);
    float f_1 = clamped_2 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_4
) {
    uint bits = as_type<uint>(x_4);
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

metal::float2 sin_cos_quarter(
    float x_5
) {
    float h = 0.5 * x_5;
    float h2_ = h * h;
    float s = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s) * c, 1.0 - ((2.0 * s) * s));
}

metal::float2 sin_cos_tiny(
    float x_6
) {
    float y_1 = x_6 * x_6;
    float s_1 = x_6 * (1.0 + (y_1 * (-0.16666667 + (y_1 * 0.008333334))));
    float c_1 = 1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * 0.0013888889)))));
    return metal::float2(s_1, c_1);
}

Angle angle_of(
    float radians
) {
    float _e2 = finite_or(radians, 0.0);
    float half_angle = 0.5 * metal::clamp(_e2, 0.0, PI);
    metal::float2 _e8 = sin_cos_quarter(half_angle);
    return Angle {metal::max(_e8.x, 0.0), metal::max(_e8.y, 0.0)};
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
    float s_2 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_2 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_2 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_2);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < c_2)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_3 = u_2.half_sin - (u_2.half_cos * 0.0);
    float c_3 = u_2.half_cos + (u_2.half_sin * 0.0);
    metal::float2 upper_1 = (c_3 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, c_3);
    metal::float2 turned_1 = ((s_3 <= 0.0) & (s_3 < c_3)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

float footprint_of(
    float x_7
) {
    float _e1 = metal::dfdx(x_7);
    float _e2 = metal::dfdy(x_7);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float step_filtered(
    float x_8,
    float edge,
    float w
) {
    float d_1 = x_8 - edge;
    return (w < 0.000000000000000000000000000001) ? ((d_1 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_1 / w), 0.0, 1.0);
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::float4(below.xyz + (tone * (color.xyz - below.xyz)), 1.0);
}

Composite blend_alpha_2_(
    Composite below_1,
    Color color_1,
    float tone_1,
    float opacity_1,
    bool clamped_1
) {
    return metal::clamp(metal::float4(below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
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
    float _e20 = exp2_stable(_e19);
    return metal::min(_e20, 1.0);
}

float profile_point(
    Angle u_3,
    ProfileShape shape
) {
    float s_4 = u_3.half_sin - (u_3.half_cos * 0.0);
    if ((s_4 <= 0.0) | false) {
        return 1.0;
    }
    float q_3 = s_4 * shape.scale;
    float _e15 = profile_power(q_3, 1.0);
    return _e15;
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
    float _e21 = exp2_stable(exponent_1 * _e19);
    return metal::min(_e21, 1.0);
}

float profile_point_2_(
    Angle u_4,
    ProfileShape shape_1
) {
    float s_5 = u_4.half_sin - (u_4.half_cos * 0.0);
    if ((s_5 <= 0.0) | false) {
        return 1.0;
    }
    float q_4 = s_5 * shape_1.scale;
    float _e15 = profile_power_2_(q_4, shape_1.exponent);
    return _e15;
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
    float _e21 = exp2_stable_2_(exponent_2 * _e19);
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
    float _e23 = profile_point_2_(_e22, shape_4);
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
    Angle _e6 = angle_turned_2_(angle, metal::float2(0.0, 1.0));
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

VectorParts separate_vector(
    metal::float3 vector
) {
    return VectorParts {vector.x, vector.y, 0.0};
}

metal::float4 shade(
    Surface surface_1
) {
    metal::float2 uv = surface_1.uv;
    VectorParts _e4 = separate_vector(metal::float3(uv, 0.0));
    float tone_2 = (_e4.y - 0.14) / 0.72;
    float _e11 = footprint_of(tone_2);
    float _e15 = step_filtered(tone_2, -0.006, metal::length(metal::float2(_e11, 0.0)));
    float _e17 = footprint_of(tone_2);
    float _e21 = step_filtered(tone_2, 0.006, metal::length(metal::float2(_e17, 0.0)));
    float angles_line = _e15 - _e21;
    float angles_tone = metal::max(angles_line, 0.0);
    Composite _e37 = blend_alpha(metal::float4(0.98, 0.965, 0.925, 1.0), metal::float4(0.24, 0.26, 0.3, 1.0), angles_tone, 1.0, true);
    float angle_3 = metal::mix(0.0, 3.1415927, (_e4.x - 0.08) / 0.84);
    float _e47 = footprint_of(angle_3);
    float _e51 = step_filtered(angle_3, -0.012, metal::length(metal::float2(_e47, 0.0)));
    float _e53 = footprint_of(angle_3);
    float _e57 = step_filtered(angle_3, 0.012, metal::length(metal::float2(_e53, 0.0)));
    float tones_line = _e51 - _e57;
    float tones_tone = metal::max(tones_line, 0.0);
    metal::float4 tones = metal::max(metal::float4(_e37.xyz + (tones_tone * (metal::float3(0.24, 0.26, 0.3) - _e37.xyz)), 1.0), metal::float4(0.0));
    float _e76 = footprint_of(angle_3);
    float _e80 = step_filtered(angle_3, 0.492, metal::length(metal::float2(_e76, 0.0)));
    float _e82 = footprint_of(angle_3);
    float _e86 = step_filtered(angle_3, 0.508, metal::length(metal::float2(_e82, 0.0)));
    float offset_line = _e80 - _e86;
    float offset_tone = metal::max(offset_line, 0.0);
    Composite _e97 = blend_alpha_2_(tones, metal::float4(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55, true);
    float _e99 = footprint_of(angle_3);
    float _e103 = step_filtered(angle_3, 0.942, metal::length(metal::float2(_e99, 0.0)));
    float _e105 = footprint_of(angle_3);
    float _e109 = step_filtered(angle_3, 0.958, metal::length(metal::float2(_e105, 0.0)));
    float falloff_line = _e103 - _e109;
    float falloff_tone = metal::max(falloff_line, 0.0);
    Composite _e120 = blend_alpha_2_(_e97, metal::float4(0.2, 0.38, 0.78, 1.0), falloff_tone, 0.55, true);
    float _e122 = footprint_of(angle_3);
    float _e126 = step_filtered(angle_3, 1.792, metal::length(metal::float2(_e122, 0.0)));
    float _e128 = footprint_of(angle_3);
    float _e132 = step_filtered(angle_3, 1.808, metal::length(metal::float2(_e128, 0.0)));
    float cutoff_line = _e126 - _e132;
    float cutoff_tone = metal::max(cutoff_line, 0.0);
    Composite _e143 = blend_alpha_2_(_e120, metal::float4(0.2, 0.38, 0.78, 1.0), cutoff_tone, 0.55, true);
    Angle _e144 = angle_of(angle_3);
    float _e147 = profile(_e144, 0.0, lambert_shape);
    float lambert_off = tone_2 - _e147;
    float _e150 = footprint_of(lambert_off);
    float _e154 = step_filtered(lambert_off, -0.012, metal::length(metal::float2(_e150, 0.0)));
    float _e156 = footprint_of(lambert_off);
    float _e160 = step_filtered(lambert_off, 0.012, metal::length(metal::float2(_e156, 0.0)));
    float lambert_line = _e154 - _e160;
    float lambert_tone = metal::max(lambert_line, 0.0);
    metal::float4 lambert_2_ = metal::clamp(metal::float4(_e143.xyz + (lambert_tone * (metal::float3(0.8, 0.2, 0.17) - _e143.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Angle _e180 = angle_of(angle_3);
    float _e183 = profile_2_(_e180, 0.0, half_lambert_shape);
    float half_lambert_off = tone_2 - _e183;
    float _e186 = footprint_of(half_lambert_off);
    float _e190 = step_filtered(half_lambert_off, -0.012, metal::length(metal::float2(_e186, 0.0)));
    float _e192 = footprint_of(half_lambert_off);
    float _e196 = step_filtered(half_lambert_off, 0.012, metal::length(metal::float2(_e192, 0.0)));
    float half_lambert_line = _e190 - _e196;
    float half_lambert_tone = metal::max(half_lambert_line, 0.0);
    metal::float4 half_lambert_2_ = metal::clamp(metal::float4(lambert_2_.xyz + (half_lambert_tone * (metal::float3(0.18, 0.55, 0.27) - lambert_2_.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Angle _e216 = angle_of(angle_3);
    float _e219 = profile_3_(_e216, 0.0, custom_shape);
    float custom_off = tone_2 - _e219;
    float _e222 = footprint_of(custom_off);
    float _e226 = step_filtered(custom_off, -0.012, metal::length(metal::float2(_e222, 0.0)));
    float _e228 = footprint_of(custom_off);
    float _e232 = step_filtered(custom_off, 0.012, metal::length(metal::float2(_e228, 0.0)));
    float custom_line = _e226 - _e232;
    float custom_tone = metal::max(custom_line, 0.0);
    metal::float4 output = metal::clamp(metal::float4(half_lambert_2_.xyz + (custom_tone * (metal::float3(0.5, 0.31, 0.14) - half_lambert_2_.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return output;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float2 uv [[attribute(3)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float2 uv [[user(loc0), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.uv };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view.clip_from_world;
    out.clip = _e12 * world;
    out.uv = vertex_.uv;
    Varyings _e16 = out;
    const auto _tmp = _e16;
    return vs_mainOutput { _tmp.clip, _tmp.uv };
}


struct fs_mainInput {
    metal::float2 uv [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
) {
    const Varyings in = { clip, varyings_1.uv };
    Surface surface = {};
    surface.uv = in.uv;
    Surface _e4 = surface;
    metal::float4 _e5 = shade(_e4);
    return fs_mainOutput { _e5 };
}
