// Anime face: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// anime-face.json says what to put there and how to draw.
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
    Light eye;
    metal::float3x3 camera_from_world;
    Light back;
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::packed_float3 position_object;
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
struct VectorParts {
    float x;
    float y;
    float z;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};
constant ProfileShape edge_of_the_shadow_shape = ProfileShape {0.7960838, 0.6051864, 15.395454, 2.8429606, 1.3, 0.060679536, 0.026670605, 0u};
constant ProfileShape lit_shape = ProfileShape {0.7775727, 0.628793, 0.0, 1.0, 1.36, 0.0, 0.0, 1u};
constant ProfileShape shine_tone_shape = ProfileShape {0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0, 1u};
constant ProfileShape rim_light_tone_shape = ProfileShape {0.90896577, 0.4168708, 0.0, 1.0, 0.86, 0.0, 0.0, 1u};
constant ProfileShape contour_tone_shape = ProfileShape {0.819648, 0.57286745, 0.0, 1.0, 1.22, 0.0, 0.0, 1u};

metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!(((largest > 0.000000000000000000000000000001) & true))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    return ((as_type<uint>(square) & 2139095040u) == 2139095040u) ? otherwise : (scaled * (1.0 / metal::sqrt(square)));
}

metal::float3 normalize_quick(
    metal::float3 v_1,
    metal::float3 otherwise_1
) {
    float square_1 = metal::dot(v_1, v_1);
    bool is_usable = (square_1 > 0.000000000000000000000000000001) & true;
    return is_usable ? (v_1 * metal::rsqrt(is_usable ? square_1 : 1.0)) : otherwise_1;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_2
) {
    return v_2 * metal::rsqrt(metal::max(metal::dot(v_2, v_2), 0.000000000000000000000000000001));
}

metal::float2 sin_cos_quick(
    float x
) {
    float y = x * x;
    float s_3 = x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 0.0000026347564))))))));
    float c = 1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (0.00002477458 - (y * 0.00000026297516)))))))));
    return metal::float2(s_3, c);
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
    float s_4 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_4, c_1);
    metal::float2 turned = ((s_4 <= 0.0) & (s_4 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_5 = u_2.half_sin - 0.0;
    metal::float2 upper_1 = (u_2.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_5, u_2.half_cos);
    metal::float2 turned_1 = ((s_5 <= 0.0) & (s_5 < u_2.half_cos)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
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

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

Composite blend_shade(
    Composite below_1,
    Color color_1,
    float tone_1,
    float opacity_1,
    bool clamped_1
) {
    return metal::min(metal::float4(below_1.xyz + (opacity_1 * ((below_1.xyz * metal::mix(metal::float3(1.0), color_1.xyz, tone_1)) - below_1.xyz)), 1.0), metal::float4(1.0));
}

Composite blend_shade_2_(
    Composite below_2,
    Color color_2,
    float tone_2,
    float opacity_2,
    bool clamped_2
) {
    return metal::clamp(metal::float4(below_2.xyz + (opacity_2 * ((below_2.xyz * metal::mix(metal::float3(1.0), color_2.xyz, tone_2)) - below_2.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
}

LitLayer light_apply(
    Light light,
    Color color_3,
    float tone_3
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color_3.xyz * light.color) * split.y, 1.0), split.x};
}

LitLayer light_apply_2_(
    Light light_1,
    Color color_4,
    float tone_4
) {
    metal::float2 split_1 = metal::float2(metal::min(light_1.intensity, 1.0), metal::max(light_1.intensity, 1.0));
    return LitLayer {metal::float4(light_1.color * split_1.y, 1.0), tone_4 * split_1.x};
}

LitLayer light_apply_3_(
    Light light_2,
    Color color_5,
    float tone_5
) {
    metal::float2 split_2 = metal::float2(metal::min(light_2.intensity, 1.0), metal::max(light_2.intensity, 1.0));
    return LitLayer {metal::float4((color_5.xyz * light_2.color) * split_2.y, 1.0), tone_5 * split_2.x};
}

Angle parametrization_diffuse_balanced(
    Light light_3,
    metal::float3 normal
) {
    metal::float3 _e6 = normalize_quick(normal, metal::float3(0.0, 0.0, 1.0));
    return Angle {0.5 * metal::length(_e6 - light_3.direction), 0.5 * metal::length(_e6 + light_3.direction)};
}

Angle parametrization_specular_balanced(
    Light light_4,
    metal::float3 normal_1,
    metal::float3 view
) {
    metal::float3 d = ((2.0 * metal::dot(normal_1, view)) * normal_1) - view;
    return Angle {0.5 * metal::length(d - light_4.direction), 0.5 * metal::length(d + light_4.direction)};
}

Angle parametrization_screen_aligned_balanced(
    Light light_5,
    metal::float3 normal_2,
    metal::float3x3 camera_from_world
) {
    metal::float3 d_1 = camera_from_world * normal_2;
    return Angle {0.5 * metal::length(d_1 - light_5.own_direction), 0.5 * metal::length(d_1 + light_5.own_direction)};
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

float profile_ramp_quick_2_(
    float s_2,
    float w_1,
    ProfileShape shape_2
) {
    float width_1 = metal::sqrt(w_1 * w_1);
    float from_offset_1 = s_2 * (2.0 + ((s_2 * s_2) * 0.33333334));
    float ramp_1 = metal::clamp(0.5 + ((0.0 - from_offset_1) / metal::max(width_1, 0.000001)), 0.0, 1.0);
    return (w_1 <= 0.0) ? ((s_2 <= 0.0000004) ? 1.0 : 0.0) : ramp_1;
}

float profile_filtered_quick(
    Angle u_3,
    float w_2,
    ProfileShape shape_3
) {
    metal::float2 place = metal::float2((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset), (u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset));
    bool is_narrow = (w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation));
    if (false | is_narrow) {
        float _e28 = profile_ramp_quick(place.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_3);
    if (w_2 < (0.1 * shape_3.edge_deviation)) {
        return _e30;
    }
    float r = 0.19364917 * w_2;
    metal::float2 turn = metal::float2(r * (1.0 - ((0.16666667 * r) * r)), 1.0 - ((0.5 * r) * r));
    float _e56 = profile_soft_quick((place.x * turn.y) - (place.y * turn.x), shape_3);
    float _e64 = profile_soft_quick((place.x * turn.y) + (place.y * turn.x), shape_3);
    return (((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_4
) {
    Angle _e6 = angle_turned_2_(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_5
) {
    Angle _e6 = angle_turned_2_(angle_1, metal::float2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset), _e14, shape_5);
    return _e15;
}

float profile_balanced_3_(
    Angle angle_2,
    float shift_2,
    ProfileShape shape_6
) {
    metal::float2 _e5 = sin_cos_quick(0.5 * shift_2);
    Angle _e6 = angle_turned(angle_2, _e5);
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_((_e6.half_sin * shape_6.half_cos_offset) - (_e6.half_cos * shape_6.half_sin_offset), _e14, shape_6);
    return _e15;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 place_1 = surface.position_object;
    metal::float3 from_the_face_s_middle = place_1 - metal::float3(0.0, 0.52, -0.18);
    metal::float3 flattened = from_the_face_s_middle * metal::float3(1.0, 0.35, 1.0);
    metal::float3 _e14 = normalize_or(flattened, metal::float3(0.0));
    VectorParts high = VectorParts {surface.position_object[0], surface.position_object[1], surface.position_object[2]};
    float is_face = metal::smoothstep(0.02, 0.16, high.y);
    metal::float3 face_or_body = metal::mix(surface.normal, _e14, is_face);
    metal::float3 shading_direction = face_or_body * metal::rsqrt(metal::max(metal::dot(face_or_body, face_or_body), 0.000000000000000000000000000001));
    Light _e32 = look.key;
    Angle _e33 = parametrization_diffuse_balanced(_e32, shading_direction);
    float _e36 = profile_balanced(_e33, 0.0, edge_of_the_shadow_shape);
    float soft_dark = 1.0 - _e36;
    Composite _e51 = blend_shade(metal::float4(0.9843, 0.8902, 0.8118, 1.0), metal::float4(0.9412, 0.5412, 0.4157, 1.0), soft_dark, 0.55, true);
    float _e54 = profile_balanced_2_(_e33, 0.0, lit_shape);
    float in_shadow = 1.0 - _e54;
    Composite _e64 = blend_shade_2_(_e51, metal::float4(0.698, 0.4784, 0.6588, 1.0), in_shadow, 0.85, true);
    float _e67 = transition_balanced(surface.kappa, 0.55);
    Color _e75 = curvature_color(_e67, metal::float4(1.0), metal::float4(0.2902, 0.1412, 0.251, 1.0));
    Light _e78 = look.eye;
    LitLayer _e80 = light_apply(_e78, _e75, 1.0);
    metal::float4 inked_hollows_blend = metal::clamp(metal::float4(_e64.xyz + (0.9 * ((_e64.xyz * (_e80.tone * _e80.color.xyz)) - _e64.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Light _e102 = look.key;
    Angle _e105 = parametrization_specular_balanced(_e102, surface.normal, surface.view);
    float _e108 = transition_balanced(surface.kappa, 0.2);
    float shine_warp = ((2.0 * _e108) - 1.0) * 0.05;
    float _e116 = profile_balanced_3_(_e105, shine_warp, shine_tone_shape);
    Light _e119 = look.key;
    LitLayer _e122 = light_apply_2_(_e119, metal::float4(1.0), _e116);
    Composite _e127 = blend_alpha(inked_hollows_blend, _e122.color, _e122.tone, 0.85, true);
    metal::float3 _e132 = look.back.direction;
    metal::float3 _e141 = look.back.direction;
    Angle rim_light_angle = Angle {0.5 * metal::length(surface.normal - _e132), 0.5 * metal::length(surface.normal + _e141)};
    float rim_light_warp = ((2.0 * _e108) - 1.0) * 0.15;
    float _e154 = profile_balanced_3_(rim_light_angle, rim_light_warp, rim_light_tone_shape);
    Light _e157 = look.back;
    LitLayer _e163 = light_apply_3_(_e157, metal::float4(1.0, 0.9647, 0.9176, 1.0), _e154);
    Composite _e168 = blend_alpha(_e127, _e163.color, _e163.tone, 0.9, true);
    Light _e171 = look.eye;
    metal::float3x3 _e175 = look.camera_from_world;
    Angle _e176 = parametrization_screen_aligned_balanced(_e171, surface.normal, _e175);
    float _e179 = transition_balanced(surface.kappa, 0.12);
    float contour_warp = ((2.0 * _e179) - 1.0) * 0.28;
    float _e187 = profile_balanced_3_(_e176, contour_warp, contour_tone_shape);
    Light _e190 = look.eye;
    LitLayer _e193 = light_apply_2_(_e190, metal::float4(1.0), _e187);
    metal::float4 contour_blend = metal::clamp(metal::float4(_e168.xyz * (_e193.tone * _e193.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return contour_blend;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_3 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_3 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_3 [[user(loc2), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.position_object, varyings_1.normal_3 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_3 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e24 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_3, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, _e24.x};
    metal::float4 _e27 = shade(surface_1, look);
    return fs_mainOutput { _e27 };
}
