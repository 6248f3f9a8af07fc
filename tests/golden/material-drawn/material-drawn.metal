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
constant ProfileShape body_tone_shape = ProfileShape {0.86532396, 0.501213, 5.743557, 2.0104687, 1.05, 0.18576889, 0.077249795, 0u};
constant ProfileShape window_tone_shape = ProfileShape {0.9887711, 0.14943813, 50.003334, 8.498813, 0.3, 0.011653547, 0.0057055796, 0u};
constant ProfileShape rim_tone_shape = ProfileShape {0.9305076, 0.36627254, 10.016686, 2.4912605, 0.75, 0.09820393, 0.042312488, 0u};

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
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

Angle parametrization_specular_balanced(
    Light light_1,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d = ((2.0 * metal::dot(normal, view)) * normal) - view;
    return Angle {0.5 * metal::length(d - light_1.direction), 0.5 * metal::length(d + light_1.direction)};
}

float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return (s <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q * q), 0.0), shape.exponent);
}

float profile_ramp_quick(
    float s_1,
    float w,
    ProfileShape shape_1
) {
    float width = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_1.edge_mean - from_offset) / width), 0.0, 1.0);
    return (w <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_filtered_quick(
    Angle u_2,
    float w_1,
    ProfileShape shape_2
) {
    metal::float2 place = metal::float2((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset), (u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset));
    bool is_narrow = (w_1 > 0.0) & (w_1 >= (3.4641016 * shape_2.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place.x, w_1, shape_2);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_2);
    if (w_1 < (0.1 * shape_2.edge_deviation)) {
        return _e30;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e56 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_2);
    float _e64 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_2);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_3
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle body_angle = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    float _e22 = profile_balanced(body_angle, 0.0, body_tone_shape);
    Light _e25 = look.key;
    LitLayer _e31 = light_apply(_e25, metal::float4(0.2471, 0.4863, 0.7686, 1.0), _e22);
    Composite _e41 = blend_alpha(metal::float4(0.1333, 0.1882, 0.3098, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = look.key;
    Angle _e47 = parametrization_specular_balanced(_e44, surface.normal, surface.view);
    float _e50 = profile_balanced(_e47, 0.0, window_tone_shape);
    Light _e53 = look.key;
    LitLayer _e59 = light_apply(_e53, metal::float4(0.9686, 0.9843, 1.0, 1.0), _e50);
    metal::float4 window_blend = metal::clamp(metal::float4(_e41.xyz + (_e59.tone * (_e59.color.xyz - _e41.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float3 _e79 = look.back.direction;
    metal::float3 _e88 = look.back.direction;
    Angle rim_angle = Angle {0.5 * metal::length(surface.normal - _e79), 0.5 * metal::length(surface.normal + _e88)};
    float _e96 = profile_balanced(rim_angle, 0.0, rim_tone_shape);
    Light _e99 = look.back;
    LitLayer _e105 = light_apply(_e99, metal::float4(0.2314, 0.3725, 0.5255, 1.0), _e96);
    metal::float4 rim_blend = metal::clamp(metal::float4(window_blend.xyz + (_e105.tone * _e105.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return rim_blend;
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
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position))};
    metal::float4 _e19 = shade(surface_1, look);
    return fs_mainOutput { _e19 };
}
