// Dual lighting, soft: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure6-dual-soft.json says what to put there and how to draw.
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
    Light warm;
    Light cool;
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
constant ProfileShape warm_side_tone_shape = ProfileShape {0.9971888, 0.07492971, 1.3940078, 1.4345639, 0.15, 0.90231395, 0.36981526, 0u};
constant ProfileShape cool_side_tone_shape = ProfileShape {0.99875027, 0.04997917, 1.5079876, 1.4054453, 0.1, 0.83293223, 0.33645248, 0u};
constant ProfileShape sheen_tone_shape = ProfileShape {0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u};

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

metal::float2 sin_cos_quick(
    float x
) {
    float y = x * x;
    float s_2 = x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 0.0000026347564))))))));
    float c = 1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (0.00002477458 - (y * 0.00000026297516)))))))));
    return metal::float2(s_2, c);
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
    float s_3 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, c_1);
    metal::float2 turned = ((s_3 <= 0.0) & (s_3 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + (convexity * (convex - concave));
}

float transition_balanced(
    float kappa,
    float slope
) {
    return 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(kappa * slope, -20.0, 20.0))))));
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
    float _e19 = profile_soft_quick(place.x, shape_2);
    if (w_1 < (0.1 * shape_2.edge_deviation)) {
        return _e19;
    }
    float r = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e45 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_2);
    float _e53 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_2);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_filtered_quick_2_(
    Angle u_3,
    float w_2,
    ProfileShape shape_3
) {
    metal::float2 place_1 = metal::float2((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset), (u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset));
    bool is_narrow = (w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place_1.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_3);
    if (w_2 < (0.1 * shape_3.edge_deviation)) {
        return _e30;
    }
    float r_1 = 0.19364917 * w_2;
    metal::float2 turn_1 = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
    float _e56 = profile_soft_quick((place_1.x * turn_1.y) - (place_1.y * turn_1.x), shape_3);
    float _e64 = profile_soft_quick((place_1.x * turn_1.y) + (place_1.y * turn_1.x), shape_3);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift_1);
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float _e3 = transition_balanced(surface.kappa, 0.25);
    Color _e14 = curvature_color(_e3, metal::float4(0.1137, 0.0941, 0.1333, 1.0), metal::float4(0.0392, 0.0314, 0.0549, 1.0));
    Light _e17 = look.warm;
    LitLayer _e19 = light_apply(_e17, _e14, 1.0);
    Composite _e29 = blend_add(metal::float4(0.051, 0.0431, 0.0706, 1.0), _e19.color, _e19.tone, 1.0, true);
    float _e32 = transition_balanced(surface.kappa, 0.22);
    Color _e43 = curvature_color(_e32, metal::float4(0.851, 0.5451, 0.3059, 1.0), metal::float4(0.4784, 0.1843, 0.1333, 1.0));
    metal::float3 _e48 = look.warm.direction;
    metal::float3 _e57 = look.warm.direction;
    Angle warm_side_angle = Angle {0.5 * metal::length(surface.normal - _e48), 0.5 * metal::length(surface.normal + _e57)};
    float warm_side_warp = ((2.0 * _e32) - 1.0) * 0.3;
    float _e70 = profile_balanced(warm_side_angle, warm_side_warp, warm_side_tone_shape);
    Light _e73 = look.warm;
    LitLayer _e74 = light_apply(_e73, _e43, _e70);
    Composite _e79 = blend_add(_e29, _e74.color, _e74.tone, 1.0, true);
    Color _e90 = curvature_color(_e32, metal::float4(0.3098, 0.498, 0.7216, 1.0), metal::float4(0.1098, 0.1922, 0.3412, 1.0));
    metal::float3 _e95 = look.cool.direction;
    metal::float3 _e104 = look.cool.direction;
    Angle cool_side_angle = Angle {0.5 * metal::length(surface.normal - _e95), 0.5 * metal::length(surface.normal + _e104)};
    float cool_side_warp = ((2.0 * _e32) - 1.0) * 0.25;
    float _e117 = profile_balanced(cool_side_angle, cool_side_warp, cool_side_tone_shape);
    Light _e120 = look.cool;
    LitLayer _e121 = light_apply(_e120, _e90, _e117);
    Composite _e126 = blend_add(_e79, _e121.color, _e121.tone, 1.0, true);
    float _e129 = transition_balanced(surface.kappa, 0.2);
    Color _e140 = curvature_color(_e129, metal::float4(0.4196, 0.3176, 0.2196, 1.0), metal::float4(0.2, 0.1373, 0.1098, 1.0));
    Light _e143 = look.warm;
    Angle _e146 = parametrization_specular_balanced(_e143, surface.normal, surface.view);
    float sheen_warp = ((2.0 * _e129) - 1.0) * 0.1;
    float _e154 = profile_balanced_2_(_e146, sheen_warp, sheen_tone_shape);
    Light _e157 = look.warm;
    LitLayer _e158 = light_apply(_e157, _e140, _e154);
    Composite _e163 = blend_add(_e126, _e158.color, _e158.tone, 1.0, true);
    return _e163;
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
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e23 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position)), _e23.x};
    metal::float4 _e26 = shade(surface_1, look);
    return fs_mainOutput { _e26 };
}
