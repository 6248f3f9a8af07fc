// Drawn, for contrast: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// material-drawn.json says what to put there and how to draw.
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
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
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
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant ProfileShape body_tone_shape = ProfileShape {0.86532396, 0.501213, 5.743557, 2.0104687, 1.05, 0.18576889, 0.077249795, 0u};
constant ProfileShape window_tone_shape = ProfileShape {0.9887711, 0.14943813, 50.003334, 8.498813, 0.3, 0.011653547, 0.0057055796, 0u};
constant ProfileShape rim_tone_shape = ProfileShape {0.9305076, 0.36627254, 10.016686, 2.4912605, 0.75, 0.09820393, 0.042312488, 0u};

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
    int exponent_2 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_2) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_2) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
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
    float y_2 = x_3 * x_3;
    float s = x_3 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334))));
    float c = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * 0.0013888889)))));
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

float atan2_positive(
    float y_1,
    float x_4
) {
    float small = metal::min(y_1, x_4);
    float large = metal::max(y_1, x_4);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_2 = small / large;
    bool is_wide = t_2 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_2;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y_1 > x_4) ? (HALF_PI - a) : a;
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
    float s_2 = u_2.half_sin - (u_2.half_cos * 0.0);
    float c_2 = u_2.half_cos + (u_2.half_sin * 0.0);
    metal::float2 upper_1 = (c_2 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_2);
    metal::float2 turned_1 = ((s_2 <= 0.0) & (s_2 < c_2)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (tone * (color.xyz - below.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_1,
    float tone_1
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_1.xyz * light.color) * split.y, 1.0), tone_1 * split.x};
}

Angle parametrization_specular(
    Light light_1,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 mirrored = ((2.0 * metal::dot(normal, view)) * normal) - view;
    metal::float3 _e8 = normalize_moderate(mirrored, normal);
    return Angle {0.5 * metal::length(_e8 - light_1.direction), 0.5 * metal::length(_e8 + light_1.direction)};
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
    return metal::min(_e21, 1.0);
}

float profile_point(
    Angle u_3,
    ProfileShape shape
) {
    float s_3 = (u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset);
    if ((s_3 <= 0.0) | false) {
        return 1.0;
    }
    float q_2 = s_3 * shape.scale;
    float _e17 = profile_power(q_2, shape.exponent);
    return _e17;
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
    float s_4 = (u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset);
    if ((s_4 <= 0.0) | false) {
        return 1.0;
    }
    float q_3 = s_4 * shape_1.scale;
    float _e17 = profile_power_2_(q_3, shape_1.exponent);
    return _e17;
}

float profile_filtered(
    Angle u_5,
    float w,
    ProfileShape shape_2
) {
    float _e3 = profile_point(u_5, shape_2);
    bool is_wide_1 = w < (0.1 * shape_2.edge_deviation);
    if ((is_wide_1 | (w <= 0.0)) | false) {
        return _e3;
    }
    if (true & (w >= (3.4641016 * shape_2.edge_deviation))) {
        float width = metal::sqrt((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation));
        float _e32 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return metal::clamp(0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e32)) / width), 0.0, 1.0);
    }
    metal::float2 _e44 = sin_cos_tiny(0.19364917 * w);
    Angle _e45 = angle_turned(u_5, _e44);
    float _e46 = profile_point(_e45, shape_2);
    Angle _e51 = angle_turned(u_5, metal::float2(-(_e44.x), _e44.y));
    float _e52 = profile_point(_e51, shape_2);
    return (((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0;
}

float profile_filtered_2_(
    Angle u_6,
    float w_1,
    ProfileShape shape_3
) {
    float _e3 = profile_point_2_(u_6, shape_3);
    bool is_wide_2 = w_1 < (0.1 * shape_3.edge_deviation);
    if ((is_wide_2 | (w_1 <= 0.0)) | false) {
        return _e3;
    }
    if (true & (w_1 >= (3.4641016 * shape_3.edge_deviation))) {
        float width_1 = metal::sqrt((w_1 * w_1) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation));
        float _e32 = atan2_positive(u_6.half_sin, u_6.half_cos);
        return metal::clamp(0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e32)) / width_1), 0.0, 1.0);
    }
    metal::float2 _e44 = sin_cos_tiny(0.19364917 * w_1);
    Angle _e45 = angle_turned(u_6, _e44);
    float _e46 = profile_point_2_(_e45, shape_3);
    Angle _e51 = angle_turned(u_6, metal::float2(-(_e44.x), _e44.y));
    float _e52 = profile_point_2_(_e51, shape_3);
    return (((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0;
}

float profile_filtered_3_(
    Angle u_7,
    float w_2,
    ProfileShape shape_4
) {
    float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_3 = w_2 < (0.1 * shape_4.edge_deviation);
    if ((is_wide_3 | (w_2 <= 0.0)) | false) {
        return _e3;
    }
    if (true & (w_2 >= (3.4641016 * shape_4.edge_deviation))) {
        float width_2 = metal::sqrt((w_2 * w_2) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation));
        float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return metal::clamp(0.5 + (((0.75 + shape_4.edge_mean) - (2.0 * _e32)) / width_2), 0.0, 1.0);
    }
    metal::float2 _e44 = sin_cos_tiny(0.19364917 * w_2);
    Angle _e45 = angle_turned(u_7, _e44);
    float _e46 = profile_point_2_(_e45, shape_4);
    Angle _e51 = angle_turned(u_7, metal::float2(-(_e44.x), _e44.y));
    float _e52 = profile_point_2_(_e51, shape_4);
    return (((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0;
}

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_5
) {
    Angle _e6 = angle_turned_2_(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_5);
    return _e8;
}

float profile_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_6
) {
    Angle _e6 = angle_turned_2_(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_6);
    return _e8;
}

float profile_3_(
    Angle angle_2,
    float shift_2,
    ProfileShape shape_7
) {
    Angle _e6 = angle_turned_2_(angle_2, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_3_(_e6, _e7, shape_7);
    return _e8;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle body_angle = Angle {0.5 * metal::length(surface_1.normal - _e5), 0.5 * metal::length(surface_1.normal + _e14)};
    float _e22 = profile(body_angle, 0.0, body_tone_shape);
    Light _e25 = look.key;
    LitLayer _e31 = light_apply(_e25, metal::float4(0.2471, 0.4863, 0.7686, 1.0), _e22);
    Composite _e41 = blend_alpha(metal::float4(0.1333, 0.1882, 0.3098, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = look.key;
    Angle _e47 = parametrization_specular(_e44, surface_1.normal, surface_1.view);
    float _e50 = profile_2_(_e47, 0.0, window_tone_shape);
    Light _e53 = look.key;
    LitLayer _e59 = light_apply(_e53, metal::float4(0.9686, 0.9843, 1.0, 1.0), _e50);
    metal::float4 window_blend = metal::clamp(metal::float4(_e41.xyz + (_e59.tone * (_e59.color.xyz - _e41.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float3 _e79 = look.back.direction;
    metal::float3 _e88 = look.back.direction;
    Angle rim_angle = Angle {0.5 * metal::length(surface_1.normal - _e79), 0.5 * metal::length(surface_1.normal + _e88)};
    float _e96 = profile_3_(rim_angle, 0.0, rim_tone_shape);
    Light _e99 = look.back;
    LitLayer _e105 = light_apply(_e99, metal::float4(0.2314, 0.3725, 0.5255, 1.0), _e96);
    metal::float4 output = metal::clamp(metal::float4(window_blend.xyz + (_e105.tone * _e105.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return output;
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
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    Surface surface = {};
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    surface.normal = normal_1;
    metal::float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = metal::normalize(_e11.xyz - (_e16 * in.position));
    Surface _e21 = surface;
    metal::float4 _e22 = shade(_e21, look);
    return fs_mainOutput { _e22 };
}
