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
constant float LOG2_E = 1.442695;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape violet_tone_shape = ProfileShape {0.98472655, 0.17410813, 2.425296, 2.1444545, 0.35, 0.43399706, 0.1847509, 0u};
constant ProfileShape gold_tone_shape = ProfileShape {0.9887711, 0.14943813, 3.6826046, 2.8423793, 0.3, 0.2547288, 0.11251208, 0u};
constant ProfileShape green_sheen_tone_shape = ProfileShape {0.99820054, 0.059964005, 5.2949586, 2.6937559, 0.12, 0.1805348, 0.07889118, 0u};
constant ProfileShape glint_tone_shape = ProfileShape {0.99955004, 0.029995501, 25.006668, 2.4986002, 0.06, 0.039271776, 0.016918294, 0u};

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

metal::float2 sin_cos_quick(
    float x
) {
    float y_1 = x * x;
    float s_4 = x * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 0.0000026347564))))))));
    float c = 1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (0.00002477458 - (y_1 * 0.00000026297516)))))))));
    return metal::float2(s_4, c);
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
    float w_5 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_5, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_5 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_5, c_1);
    metal::float2 turned = ((s_5 <= 0.0) & (s_5 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + (convexity * (convex - concave));
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

Angle parametrization_specular_balanced(
    Light light_3,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d = ((2.0 * metal::dot(normal, view)) * normal) - view;
    return Angle {0.5 * metal::length(d - light_3.direction), 0.5 * metal::length(d + light_3.direction)};
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

float profile_soft_quick_2_(
    float s_1,
    ProfileShape shape_2
) {
    float q_1 = s_1 * shape_2.scale;
    return (s_1 <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q_1 * q_1), 0.0), shape_2.exponent);
}

float profile_ramp_quick(
    float s_2,
    float w,
    ProfileShape shape_3
) {
    float width = metal::sqrt((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation));
    float from_offset = s_2 * (2.0 + ((s_2 * s_2) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_3.edge_mean - from_offset) / metal::max(width, 0.000001)), 0.0, 1.0);
    return (w <= 0.0) ? ((s_2 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_ramp_quick_2_(
    float s_3,
    float w_1,
    ProfileShape shape_4
) {
    float width_1 = metal::sqrt((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation));
    float from_offset_1 = s_3 * (2.0 + ((s_3 * s_3) * 0.33333334));
    float ramp_1 = metal::clamp(0.5 + ((shape_4.edge_mean - from_offset_1) / width_1), 0.0, 1.0);
    return (w_1 <= 0.0) ? ((s_3 <= 0.0000004) ? 1.0 : 0.0) : ramp_1;
}

float profile_filtered_quick(
    Angle u_3,
    float w_2,
    ProfileShape shape_5
) {
    if (shape_5.kind == PROFILE_AMBIENT) {
        return 1.0;
    }
    metal::float2 _e7 = profile_place(u_3, shape_5);
    bool is_narrow = (w_2 > 0.0) & (w_2 >= (3.4641016 * shape_5.edge_deviation));
    if ((shape_5.kind == PROFILE_STEP) | is_narrow) {
        float _e20 = profile_ramp_quick(_e7.x, w_2, shape_5);
        return _e20;
    }
    float _e22 = profile_soft_quick(_e7.x, shape_5);
    if (w_2 < (0.1 * shape_5.edge_deviation)) {
        return _e22;
    }
    float r = 0.19364917 * w_2;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e48 = profile_soft_quick((_e7.x * turn.y) - (_e7.y * turn.x), shape_5);
    float _e56 = profile_soft_quick((_e7.x * turn.y) + (_e7.y * turn.x), shape_5);
    return (((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0;
}

float profile_filtered_quick_2_(
    Angle u_4,
    float w_3,
    ProfileShape shape_6
) {
    metal::float2 place = metal::float2((u_4.half_sin * shape_6.half_cos_offset) - (u_4.half_cos * shape_6.half_sin_offset), (u_4.half_cos * shape_6.half_cos_offset) + (u_4.half_sin * shape_6.half_sin_offset));
    float _e19 = profile_soft_quick_2_(place.x, shape_6);
    if (w_3 < (0.1 * shape_6.edge_deviation)) {
        return _e19;
    }
    float r_1 = 0.19364917 * w_3;
    metal::float2 turn_1 = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
    float _e45 = profile_soft_quick_2_((place.x * turn_1.y) - (place.y * turn_1.x), shape_6);
    float _e53 = profile_soft_quick_2_((place.x * turn_1.y) + (place.y * turn_1.x), shape_6);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_filtered_quick_3_(
    Angle u_5,
    float w_4,
    ProfileShape shape_7
) {
    metal::float2 place_1 = metal::float2((u_5.half_sin * shape_7.half_cos_offset) - (u_5.half_cos * shape_7.half_sin_offset), (u_5.half_cos * shape_7.half_cos_offset) + (u_5.half_sin * shape_7.half_sin_offset));
    bool is_narrow_1 = (w_4 > 0.0) & (w_4 >= (3.4641016 * shape_7.edge_deviation));
    if (false | is_narrow_1) {
        float _e28 = profile_ramp_quick_2_(place_1.x, w_4, shape_7);
        return _e28;
    }
    float _e30 = profile_soft_quick_2_(place_1.x, shape_7);
    if (w_4 < (0.1 * shape_7.edge_deviation)) {
        return _e30;
    }
    float r_2 = 0.19364917 * w_4;
    metal::float2 turn_2 = metal::float2(r_2 * (1.0 - ((0.16666667 * r_2) * r_2)), 1.0 - ((0.5 * r_2) * r_2));
    float _e56 = profile_soft_quick_2_((place_1.x * turn_2.y) - (place_1.y * turn_2.x), shape_7);
    float _e64 = profile_soft_quick_2_((place_1.x * turn_2.y) + (place_1.y * turn_2.x), shape_7);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_8
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_8);
    return _e8;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_9
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift_1);
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_9);
    return _e8;
}

float profile_balanced_3_(
    Angle angle_2,
    float shift_2,
    ProfileShape shape_10
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift_2);
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_10);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float glint_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.2, -20.0, 20.0))))));
    metal::float4 _e22 = look.wing_case_color_concave;
    metal::float4 _e25 = look.wing_case_color_convex;
    metal::float4 _e28 = look.wing_case_color_concave;
    metal::float4 wing_case_color = _e22 + (glint_convexity * (_e25 - _e28));
    metal::float3 _e36 = look.key.direction;
    metal::float3 _e45 = look.key.direction;
    Angle hollows_angle = Angle {0.5 * metal::length(surface.normal - _e36), 0.5 * metal::length(surface.normal + _e45)};
    float wing_case_warp = ((2.0 * glint_convexity) - 1.0) * 0.2;
    ProfileShape _e59 = look.wing_case_tone_shape;
    float _e60 = profile_balanced(hollows_angle, wing_case_warp, _e59);
    Light _e63 = look.key;
    LitLayer _e64 = light_apply(_e63, wing_case_color, _e60);
    Composite _e74 = blend_add(metal::float4(0.0157, 0.0627, 0.0392, 1.0), _e64.color, _e64.tone, 1.0, true);
    Color _e85 = curvature_color(glint_convexity, metal::float4(0.3529, 0.1647, 0.4314, 1.0), metal::float4(0.1098, 0.0627, 0.251, 1.0));
    Light _e88 = look.side;
    Angle _e91 = parametrization_specular_balanced(_e88, surface.normal, surface.view);
    float gold_warp = ((2.0 * glint_convexity) - 1.0) * 0.15;
    float _e99 = profile_balanced_2_(_e91, gold_warp, violet_tone_shape);
    Light _e102 = look.side;
    LitLayer _e103 = light_apply_2_(_e102, _e85, _e99);
    metal::float4 violet_blend = metal::clamp(metal::float4(_e74.xyz + (_e103.tone * _e103.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    metal::float4 _e119 = look.gold_color_convex;
    Color _e125 = curvature_color(glint_convexity, _e119, metal::float4(0.2902, 0.3529, 0.0627, 1.0));
    Light _e128 = look.key;
    Angle _e131 = parametrization_specular_balanced(_e128, surface.normal, surface.view);
    float _e133 = profile_balanced_3_(_e131, gold_warp, gold_tone_shape);
    Light _e136 = look.key;
    LitLayer _e137 = light_apply(_e136, _e125, _e133);
    Composite _e148 = blend_finish(violet_blend, violet_blend.xyz + (_e137.tone * _e137.color.xyz), 1.0, _e137.color.w, true);
    metal::float4 _e151 = look.green_sheen_color_convex;
    Color _e157 = curvature_color(glint_convexity, _e151, metal::float4(0.1647, 0.5412, 0.3529, 1.0));
    float green_sheen_warp = ((2.0 * glint_convexity) - 1.0) * 0.1;
    float _e165 = profile_balanced_3_(_e131, green_sheen_warp, green_sheen_tone_shape);
    Light _e168 = look.key;
    LitLayer _e169 = light_apply(_e168, _e157, _e165);
    Composite _e180 = blend_finish(_e148, _e148.xyz + (_e169.tone * _e169.color.xyz), 1.0, _e169.color.w, true);
    Color _e188 = curvature_color(glint_convexity, metal::float4(1.0), metal::float4(0.8471, 1.0, 0.8784, 1.0));
    float glint_warp = ((2.0 * glint_convexity) - 1.0) * 0.05;
    float _e196 = profile_balanced_3_(_e131, glint_warp, glint_tone_shape);
    Light _e199 = look.key;
    LitLayer _e200 = light_apply_2_(_e199, _e188, _e196);
    metal::float4 glint_blend = metal::clamp(metal::float4(_e180.xyz + (_e200.tone * (_e200.color.xyz - _e180.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    float hollows_convexity = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(surface.kappa * 0.3, -20.0, 20.0))))));
    metal::float4 _e237 = look.hollows_color_concave;
    metal::float4 _e242 = look.hollows_color_concave;
    metal::float4 hollows_color = _e237 + (hollows_convexity * (metal::float4(1.0) - _e242));
    Light _e248 = look.key;
    LitLayer _e250 = light_apply_3_(_e248, hollows_color, 1.0);
    Composite _e261 = blend_finish(glint_blend, glint_blend.xyz * (_e250.tone * _e250.color.xyz), 1.0, _e250.color.w, true);
    return _e261;
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
