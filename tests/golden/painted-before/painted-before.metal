// Painted light, before: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// painted-before.json says what to put there and how to draw.
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
    Light lamp;
    Light window;
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
    metal::float3 normal;
};
constant ProfileShape body_tone_shape = ProfileShape {0.9921977, 0.12467473, 1.2081645, 1.573837, 0.25, 1.0277877, 0.44035247, 0u};
constant ProfileShape light_tone_shape = ProfileShape {0.9950042, 0.099833414, 2.0858297, 2.2877648, 0.2, 0.49455804, 0.21395217, 0u};
constant ProfileShape behind_tone_shape = ProfileShape {0.9921977, 0.12467473, 2.425296, 2.1444545, 0.25, 0.43399706, 0.1847509, 0u};

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
    float w_1 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_1, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_1 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_1, u_1.half_cos);
    metal::float2 turned = ((s_1 <= 0.0) & (s_1 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Composite blend_add(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (tone * color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_1,
    float tone_1
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_1.xyz * light.color) * split.y, 1.0), tone_1 * split.x};
}

Angle parametrization_diffuse_balanced(
    Light light_1,
    metal::float3 normal
) {
    return Angle {0.5 * metal::length(normal - light_1.direction), 0.5 * metal::length(normal + light_1.direction)};
}

float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return (s <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q * q), 0.0), shape.exponent);
}

float profile_filtered_quick(
    Angle u_2,
    float w,
    ProfileShape shape_1
) {
    metal::float2 place = metal::float2((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset), (u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset));
    float _e19 = profile_soft_quick(place.x, shape_1);
    if (w < (0.1 * shape_1.edge_deviation)) {
        return _e19;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e45 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_1);
    float _e53 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_1);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_2
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light _e3 = look.window;
    Angle _e5 = parametrization_diffuse_balanced(_e3, surface.normal);
    float _e8 = profile_balanced(_e5, 0.0, body_tone_shape);
    Light _e11 = look.window;
    LitLayer _e17 = light_apply(_e11, metal::float4(0.42, 0.38, 0.38, 1.0), _e8);
    Composite _e27 = blend_add(metal::float4(0.2, 0.18, 0.22, 1.0), _e17.color, _e17.tone, 1.0, true);
    Light _e30 = look.lamp;
    Angle _e32 = parametrization_diffuse_balanced(_e30, surface.normal);
    float _e35 = profile_balanced(_e32, 0.0, light_tone_shape);
    Light _e38 = look.lamp;
    LitLayer _e44 = light_apply(_e38, metal::float4(0.14, 0.13, 0.12, 1.0), _e35);
    Composite _e49 = blend_add(_e27, _e44.color, _e44.tone, 1.0, true);
    Light _e52 = look.back;
    Angle _e54 = parametrization_diffuse_balanced(_e52, surface.normal);
    float _e57 = profile_balanced(_e54, 0.0, behind_tone_shape);
    Light _e60 = look.back;
    LitLayer _e66 = light_apply(_e60, metal::float4(0.08, 0.09, 0.1, 1.0), _e57);
    Composite _e71 = blend_add(_e49, _e66.color, _e66.tone, 1.0, true);
    return _e71;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e14 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, _e14 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 normal_1 [[user(loc0), center_perspective]];
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
    const Varyings in = { clip, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    Surface surface_1 = Surface {normal_1};
    metal::float4 _e7 = shade(surface_1, look);
    return fs_mainOutput { _e7 };
}
