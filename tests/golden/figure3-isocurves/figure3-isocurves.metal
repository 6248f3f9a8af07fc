// Profile isocurves: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// figure3-isocurves.json says what to put there and how to draw.
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
    Light key;
    float cut_off;
    float fall_off;
    float offset;
    char _pad4[4];
    ProfileShape profile_tone_shape;
};
struct Surface {
    metal::float3 normal;
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
    metal::float3 normal;
};
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;

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

float log2_one_minus(
    float y
) {
    float series = (-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2))))))));
    return (y < 0.0625) ? series : metal::log2(metal::max(1.0 - y, 0.0000000000000000000000000000007888609));
}

float atan2_positive(
    float y_1,
    float x
) {
    float small = metal::min(y_1, x);
    float large = metal::max(y_1, x);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_1 = small / large;
    bool is_wide = t_1 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_1;
    float r2_ = r * r;
    float series_1 = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_1 > x) ? (HALF_PI - a) : a;
}

float angle_radians(
    Angle u
) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return 2.0 * _e3;
}

float angle_footprint(
    Angle u_1
) {
    metal::float2 half_ = metal::float2(u_1.half_sin, u_1.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_3 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_3, 0.5);
}

Angle angle_turned(
    Angle u_2,
    metal::float2 t
) {
    float s_2 = u_2.half_sin - 0.0;
    metal::float2 upper = (u_2.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, u_2.half_cos);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < u_2.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float bounded(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0);
}

float footprint_of(
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
    metal::float2 d = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
    return _e6;
}

float step_filtered(
    float x_3,
    float edge,
    float w
) {
    float _e4 = bounded(x_3 - edge);
    if (w < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
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

float profile_power_quick(
    float q,
    float exponent
) {
    float y_2 = metal::min(q * q, 1.0);
    float _e5 = log2_one_minus(y_2);
    float power = metal::exp2(metal::max(exponent * _e5, -126.0));
    return (q >= 1.0) ? 0.0 : metal::clamp(power, 0.0, 1.0);
}

metal::float2 profile_place(
    Angle u_3,
    ProfileShape shape
) {
    return metal::float2((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset), (u_3.half_cos * shape.half_cos_offset) + (u_3.half_sin * shape.half_sin_offset));
}

float profile_soft_quick(
    float s,
    ProfileShape shape_1
) {
    float _e5 = profile_power_quick(s * shape_1.scale, shape_1.exponent);
    return (s <= 0.0) ? 1.0 : _e5;
}

float profile_ramp_quick(
    float s_1,
    float w_1,
    ProfileShape shape_2
) {
    float width = metal::sqrt((w_1 * w_1) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_2.edge_mean - from_offset) / metal::max(width, 0.000001)), 0.0, 1.0);
    return (w_1 <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_filtered_quick(
    Angle u_4,
    float w_2,
    ProfileShape shape_3
) {
    if (shape_3.kind == PROFILE_AMBIENT) {
        return 1.0;
    }
    metal::float2 _e7 = profile_place(u_4, shape_3);
    bool is_narrow = (w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation));
    if ((shape_3.kind == PROFILE_STEP) | is_narrow) {
        float _e20 = profile_ramp_quick(_e7.x, w_2, shape_3);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_3);
    if (w_2 < (0.1 * shape_3.edge_deviation)) {
        return _e22;
    }
    float r_1 = 0.19364917 * w_2;
    metal::float2 turn = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
    float _e48 = profile_soft_quick((_e7.x * turn.y) - (_e7.y * turn.x), shape_3);
    float _e56 = profile_soft_quick((_e7.x * turn.y) + (_e7.y * turn.x), shape_3);
    return (((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float threshold(
    float value,
    float edge_1,
    float softness
) {
    float _e3 = bounded(value);
    float _e4 = footprint_of(value);
    float _e9 = step_filtered(_e3, edge_1, metal::length(metal::float2(metal::min(_e4, 1000000000000000.0), softness)));
    return _e9;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle profile_angle = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    ProfileShape _e23 = look.profile_tone_shape;
    float _e24 = profile_balanced(profile_angle, 0.0, _e23);
    Light _e27 = look.key;
    LitLayer _e33 = light_apply(_e27, metal::float4(0.86, 0.8, 0.7, 1.0), _e24);
    metal::float4 profile_blend = metal::clamp(metal::float4(metal::float3(0.11, 0.13, 0.19) + (_e33.tone * _e33.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    float _e50 = angle_radians(profile_angle);
    float _e53 = look.offset;
    float _e55 = bounded(_e50 - _e53);
    float _e58 = threshold(_e55, 0.012, 0.0);
    float _e61 = threshold(_e55, -0.012, 0.0);
    float offset_isocurve_line = _e61 - _e58;
    float offset_isocurve_tone = metal::max(offset_isocurve_line, 0.0);
    Composite _e72 = blend_alpha(profile_blend, metal::float4(0.16, 0.36, 0.85, 1.0), offset_isocurve_tone, 1.0, true);
    float _e73 = angle_radians(profile_angle);
    float _e76 = look.fall_off;
    float _e78 = bounded(_e73 - _e76);
    float _e81 = threshold(_e78, 0.012, 0.0);
    float _e84 = threshold(_e78, -0.012, 0.0);
    float falloff_isocurve_line = _e84 - _e81;
    float falloff_isocurve_tone = metal::max(falloff_isocurve_line, 0.0);
    Composite _e95 = blend_alpha(_e72, metal::float4(0.16, 0.36, 0.85, 1.0), falloff_isocurve_tone, 1.0, true);
    float _e96 = angle_radians(profile_angle);
    float _e99 = look.cut_off;
    float _e101 = bounded(_e96 - _e99);
    float _e104 = threshold(_e101, 0.012, 0.0);
    float _e107 = threshold(_e101, -0.012, 0.0);
    float cutoff_isocurve_line = _e107 - _e104;
    float cutoff_isocurve_tone = metal::max(cutoff_isocurve_line, 0.0);
    Composite _e118 = blend_alpha(_e95, metal::float4(0.16, 0.36, 0.85, 1.0), cutoff_isocurve_tone, 1.0, true);
    return _e118;
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
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.normal };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    Surface surface_1 = Surface {normal};
    metal::float4 _e7 = shade(surface_1, look);
    return fs_mainOutput { _e7 };
}
