// Without directional control: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure5-unkeyed.json says what to put there and how to draw.
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
    Light key;
    Light back;
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
constant ProfileShape diffuse_tone_shape = ProfileShape {0.99875027, 0.04997917, 1.3613818, 1.3042344, 0.1, 0.957938, 0.38615924, 0u};
constant ProfileShape back_light_tone_shape = ProfileShape {0.9624252, 0.27154693, 3.3838634, 1.9110762, 0.55, 0.32249987, 0.13348491, 0u};
constant ProfileShape highlight_tone_shape = ProfileShape {0.9959527, 0.08987855, 11.126125, 3.022525, 0.18, 0.08196669, 0.036355104, 0u};

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
    float back_light_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.25, -20.0, 20.0))))));
    Color _e30 = curvature_color(back_light_convexity, metal::float4(0.1647, 0.1843, 0.2392, 1.0), metal::float4(0.0706, 0.0784, 0.1098, 1.0));
    Light _e33 = look.key;
    LitLayer _e35 = light_apply(_e33, _e30, 1.0);
    Composite _e45 = blend_add(metal::float4(0.0784, 0.0863, 0.1137, 1.0), _e35.color, _e35.tone, 1.0, true);
    Color _e56 = curvature_color(back_light_convexity, metal::float4(0.498, 0.6039, 0.3216, 1.0), metal::float4(0.2471, 0.4, 0.251, 1.0));
    metal::float3 _e61 = look.key.direction;
    metal::float3 _e70 = look.key.direction;
    Angle diffuse_angle = Angle {0.5 * metal::length(surface.normal - _e61), 0.5 * metal::length(surface.normal + _e70)};
    float diffuse_warp = ((2.0 * back_light_convexity) - 1.0) * 0.3;
    float _e83 = profile_balanced(diffuse_angle, diffuse_warp, diffuse_tone_shape);
    Light _e86 = look.key;
    LitLayer _e87 = light_apply(_e86, _e56, _e83);
    Composite _e92 = blend_add(_e45, _e87.color, _e87.tone, 1.0, true);
    Color _e103 = curvature_color(back_light_convexity, metal::float4(0.7882, 0.8471, 1.0, 1.0), metal::float4(0.4784, 0.5608, 0.8157, 1.0));
    metal::float3 _e108 = look.back.direction;
    metal::float3 _e117 = look.back.direction;
    Angle back_light_angle = Angle {0.5 * metal::length(surface.normal - _e108), 0.5 * metal::length(surface.normal + _e117)};
    float back_light_warp = ((2.0 * back_light_convexity) - 1.0) * 0.1;
    float _e130 = profile_balanced_2_(back_light_angle, back_light_warp, back_light_tone_shape);
    Light _e133 = look.back;
    LitLayer _e134 = light_apply(_e133, _e103, _e130);
    Composite _e139 = blend_add(_e92, _e134.color, _e134.tone, 1.0, true);
    float highlight_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.2, -20.0, 20.0))))));
    Color _e166 = curvature_color(highlight_convexity, metal::float4(1.0), metal::float4(0.8745, 0.9098, 0.7529, 1.0));
    Light _e169 = look.key;
    Angle _e172 = parametrization_specular_balanced(_e169, surface.normal, surface.view);
    float highlight_warp = ((2.0 * highlight_convexity) - 1.0) * 0.05;
    float _e180 = profile_balanced_2_(_e172, highlight_warp, highlight_tone_shape);
    Light _e183 = look.key;
    LitLayer _e184 = light_apply(_e183, _e166, _e180);
    Composite _e189 = blend_add(_e139, _e184.color, _e184.tone, 1.0, true);
    return _e189;
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
