// Shading profile: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// figure3-profile.json says what to put there and how to draw.
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
    ProfileShape profile_tone_shape;
};
struct Surface {
    metal::float3 normal;
};
typedef metal::float4 Color;
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
constant float LOG2_E = 1.442695;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

float log2_one_minus(
    float y
) {
    float series = (-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2))))))));
    return (y < 0.0625) ? series : metal::log2(metal::max(1.0 - y, 0.0000000000000000000000000000007888609));
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
    float s_2 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, u_1.half_cos);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

LitLayer light_apply(
    Light light,
    Color color,
    float tone
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color.xyz * light.color) * split.y, 1.0), tone * split.x};
}

float profile_power_quick(
    float q,
    float exponent
) {
    float y_1 = metal::min(q * q, 1.0);
    float _e5 = log2_one_minus(y_1);
    float power = metal::exp2(metal::max(exponent * _e5, -126.0));
    return (q >= 1.0) ? 0.0 : metal::clamp(power, 0.0, 1.0);
}

metal::float2 profile_place(
    Angle u_2,
    ProfileShape shape
) {
    return metal::float2((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset), (u_2.half_cos * shape.half_cos_offset) + (u_2.half_sin * shape.half_sin_offset));
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
    float w,
    ProfileShape shape_2
) {
    float width = metal::sqrt((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_2.edge_mean - from_offset) / metal::max(width, 0.000001)), 0.0, 1.0);
    return (w <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_filtered_quick(
    Angle u_3,
    float w_1,
    ProfileShape shape_3
) {
    if (shape_3.kind == PROFILE_AMBIENT) {
        return 1.0;
    }
    metal::float2 _e7 = profile_place(u_3, shape_3);
    bool is_narrow = (w_1 > 0.0) & (w_1 >= (3.4641016 * shape_3.edge_deviation));
    if ((shape_3.kind == PROFILE_STEP) | is_narrow) {
        float _e20 = profile_ramp_quick(_e7.x, w_1, shape_3);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_3);
    if (w_1 < (0.1 * shape_3.edge_deviation)) {
        return _e22;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
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
    LitLayer _e33 = light_apply(_e27, metal::float4(0.949, 0.8941, 0.7843, 1.0), _e24);
    metal::float4 profile_blend = metal::clamp(metal::float4(metal::float3(0.1098, 0.1333, 0.1882) + (_e33.tone * _e33.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return profile_blend;
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
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    Surface surface_1 = Surface {normal};
    metal::float4 _e7 = shade(surface_1, look);
    return fs_mainOutput { _e7 };
}
