// Far and turned: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// far-and-turned.json says what to put there and how to draw.
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
    metal::float4 back_light_color_convex;
    Light back;
    ProfileShape back_light_tone_shape;
    metal::float4 highlight_color_convex;
    Light key;
    metal::float4 body_color_convex;
    ProfileShape body_tone_shape;
    metal::float4 shadow;
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
constant ProfileShape highlight_tone_shape = ProfileShape {0.9971888, 0.07492971, 5.743557, 3.1871848, 0.15, 0.1556229, 0.06963291, 0u};

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent_2 = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent_2) != exponent_2);
}

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
    float clamped_3 = metal::max(x_1, -126.0);
    float whole_1 = metal::rint(clamped_3);
    float f_1 = clamped_3 - whole_1;
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
    float y_2 = x_3 * x_3;
    float s = x_3 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334))));
    float c = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * 0.0013888889)))));
    return metal::float2(s, c);
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
    float w_2 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_2, 0.5);
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
    float a_1 = opacity_1 * color.w;
    float alpha_1 = below_1.w + ((tone * a_1) * (1.0 - below_1.w));
    Composite _e20 = blend_finish(below_1, below_1.xyz + (tone * (color.xyz - below_1.xyz)), alpha_1, a_1, clamped_1);
    return _e20;
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
    return metal::clamp(_e21, 0.0, 1.0);
}

float profile_point(
    Angle u_3,
    ProfileShape shape
) {
    float s_3 = (u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset);
    if ((s_3 <= 0.0) | (shape.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    if (shape.kind == PROFILE_STEP) {
        return (s_3 <= 0.0000004) ? 1.0 : 0.0;
    }
    float q_2 = s_3 * shape.scale;
    float _e27 = profile_power(q_2, shape.exponent);
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
    if ((is_wide_1 | (w <= 0.0)) | (shape_2.kind == PROFILE_AMBIENT)) {
        return _e3;
    }
    if ((shape_2.edge_deviation < 0.145) & (w >= (3.4641016 * shape_2.edge_deviation))) {
        float width = metal::sqrt((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation));
        float _e36 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return metal::clamp(0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e36)) / width), 0.0, 1.0);
    }
    metal::float2 _e48 = sin_cos_tiny(0.19364917 * w);
    Angle _e49 = angle_turned(u_5, _e48);
    float _e50 = profile_point(_e49, shape_2);
    Angle _e55 = angle_turned(u_5, metal::float2(-(_e48.x), _e48.y));
    float _e56 = profile_point(_e55, shape_2);
    return (((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0;
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

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    Angle _e6 = angle_turned_2_(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_4);
    return _e8;
}

float profile_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    Angle _e6 = angle_turned_2_(angle_1, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_2_(_e6, _e7, shape_5);
    return _e8;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle body_angle = Angle {0.5 * metal::length(surface_1.normal - _e5), 0.5 * metal::length(surface_1.normal + _e14)};
    ProfileShape _e23 = look.body_tone_shape;
    float _e24 = profile(body_angle, 0.0, _e23);
    Light _e27 = look.key;
    metal::float4 _e30 = look.body_color_convex;
    LitLayer _e31 = light_apply(_e27, _e30, _e24);
    metal::float4 _e34 = look.shadow;
    metal::float4 _e37 = look.shadow;
    metal::float4 _e44 = look.shadow;
    float _e52 = look.shadow.w;
    float _e60 = look.shadow.w;
    Composite _e68 = blend_finish(_e34, _e37.xyz + (_e31.tone * (_e31.color.xyz - _e44.xyz)), _e52 + ((_e31.tone * _e31.color.w) * (1.0 - _e60)), _e31.color.w, true);
    Light _e71 = look.key;
    Angle _e74 = parametrization_specular(_e71, surface_1.normal, surface_1.view);
    float _e77 = profile_2_(_e74, 0.0, highlight_tone_shape);
    Light _e80 = look.key;
    metal::float4 _e83 = look.highlight_color_convex;
    LitLayer _e84 = light_apply(_e80, _e83, _e77);
    Composite _e89 = blend_alpha(_e68, _e84.color, _e84.tone, 0.8, true);
    metal::float3 _e94 = look.back.direction;
    metal::float3 _e103 = look.back.direction;
    Angle back_light_angle = Angle {0.5 * metal::length(surface_1.normal - _e94), 0.5 * metal::length(surface_1.normal + _e103)};
    ProfileShape _e112 = look.back_light_tone_shape;
    float _e113 = profile(back_light_angle, 0.0, _e112);
    Light _e116 = look.back;
    metal::float4 _e119 = look.back_light_color_convex;
    LitLayer _e120 = light_apply(_e116, _e119, _e113);
    Composite _e131 = blend_finish(_e89, _e89.xyz + (_e120.tone * _e120.color.xyz), _e89.w, _e120.color.w, true);
    metal::float4 _e142 = finite_vec4_((_e131.w <= 0.0) ? _e131 : metal::float4(_e131.xyz / metal::float3(_e131.w), _e131.w));
    return _e142;
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
    metal::float4 _e23 = finite_vec4_(_e22);
    return fs_mainOutput { _e23 };
}
