// Highlights, cut and joined: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_2 buffer(0), object buffer(1), look buffer(2).
// highlight-cut.json says what to put there and how to draw.
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
struct DirectionParts {
    metal::float3 direction;
    metal::float3 x_axis;
    metal::float3 y_axis;
    metal::float2 place;
    char _pad4[8];
};
struct AxesAround {
    metal::float3 x_axis;
    metal::float3 y_axis;
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
constant ProfileShape lit_side_shape = ProfileShape {0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733, 0.08138281, 0u};
constant ProfileShape disc_shape = ProfileShape {0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u};
constant ProfileShape bite_shape = ProfileShape {0.9887711, 0.14943813, 0.0, 1.0, 0.3, 0.0, 0.0, 1u};
constant ProfileShape dot_shape = ProfileShape {0.99875027, 0.04997917, 0.0, 1.0, 0.1, 0.0, 0.0, 1u};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!(((largest > 0.000000000000000000000000000001) & (largest < 1000000000000000000000000000000.0)))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

metal::float3 normalize_moderate(
    metal::float3 v_1,
    metal::float3 otherwise_1
) {
    float square_1 = metal::dot(v_1, v_1);
    return (square_1 > 0.000000000000000000000000000001) ? (v_1 * metal::rsqrt(metal::max(square_1, 0.000000000000000000000000000001))) : otherwise_1;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_2
) {
    return v_2 * metal::rsqrt(metal::max(metal::dot(v_2, v_2), 0.000000000000000000000000000001));
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
    float s_3 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, u_1.half_cos);
    metal::float2 turned = ((s_3 <= 0.0) & (s_3 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_4 = u_2.half_sin - (u_2.half_cos * 0.0);
    float c = u_2.half_cos + (u_2.half_sin * 0.0);
    metal::float2 upper_1 = (c <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_4, c);
    metal::float2 turned_1 = ((s_4 <= 0.0) & (s_4 < c)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

float footprint_of(
    float x_1
) {
    float _e1 = metal::dfdx(x_1);
    float _e2 = metal::dfdy(x_1);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

metal::float3 any_orthogonal(
    metal::float3 n
) {
    float sign = (n.z >= 0.0) ? 1.0 : -1.0;
    float a_1 = -1.0 / (sign + n.z);
    return metal::float3(1.0 + (((sign * n.x) * n.x) * a_1), ((sign * n.x) * n.y) * a_1, -(sign) * n.x);
}

Angle angle_between_directions(
    metal::float3 a,
    metal::float3 b
) {
    return Angle {0.5 * metal::length(a - b), 0.5 * metal::length(a + b)};
}

DirectionParts direction_within(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis
) {
    metal::float3 y = y_axis * metal::rsqrt(metal::max(metal::dot(y_axis, y_axis), 0.000000000000000000000000000001));
    return DirectionParts {direction, x_axis, y, metal::float2(metal::dot(direction, x_axis), metal::dot(direction, y))};
}

metal::float3 direction_moved(
    DirectionParts parts,
    metal::float2 by
) {
    metal::float3 moved = (parts.direction + (by.x * parts.x_axis)) + (by.y * parts.y_axis);
    metal::float3 _e13 = normalize_moderate(moved, parts.direction);
    return (metal::dot(moved, moved) > 0.000001) ? _e13 : parts.direction;
}

metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 leaning = metal::cross(up, toward);
    float square_2 = metal::dot(leaning, leaning);
    metal::float3 aside = (metal::abs(toward.x) > 0.7) ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = (square_2 > 0.00000001) ? leaning : metal::cross(aside, toward);
    metal::float3 _e28 = normalize_moderate(across - (metal::dot(across, toward) * toward), metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(_e28, metal::cross(toward, _e28), toward);
}

AxesAround axes(
    metal::float3 direction_1,
    metal::float3 up_1
) {
    metal::float3x3 _e2 = axes_around(direction_1, up_1);
    return AxesAround {_e2[0], _e2[1]};
}

metal::float3 half_vector(
    Light light,
    metal::float3 view
) {
    metal::float3 half_1 = light.direction + view;
    metal::float3 _e4 = any_orthogonal(view);
    metal::float3 _e9 = normalize_or((metal::dot(half_1, half_1) > 0.000000000001) ? half_1 : _e4, view);
    return _e9;
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
    float width_1 = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
    float from_offset = s_1 * (2.0 + ((s_1 * s_1) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((shape_1.edge_mean - from_offset) / width_1), 0.0, 1.0);
    return (w <= 0.0) ? ((s_1 <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_ramp_quick_2_(
    float s_2,
    float w_1,
    ProfileShape shape_2
) {
    float width_2 = metal::sqrt(w_1 * w_1);
    float from_offset_1 = s_2 * (2.0 + ((s_2 * s_2) * 0.33333334));
    float ramp_1 = metal::clamp(0.5 + ((0.0 - from_offset_1) / metal::max(width_2, 0.000001)), 0.0, 1.0);
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
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
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

float rim(
    Light light_1,
    metal::float3 normal,
    metal::float3 view_1,
    float width,
    float softness,
    float follow
) {
    float facing = metal::clamp(metal::dot(normal, view_1), 0.0, 1.0);
    float _e11 = footprint_of(facing);
    float edge = metal::max(width * softness, metal::min(_e11, 1.0));
    metal::float3 aside_1 = normal - view_1;
    float further = (facing > 0.5) ? ((0.5 * metal::dot(aside_1, aside_1)) - (1.0 - width)) : (width - facing);
    float within = (further / edge) + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across_1 = light_1.direction - (metal::dot(light_1.direction, view_1) * view_1);
    float side = metal::dot(normal - (metal::dot(normal, view_1) * view_1), across_1 * metal::rsqrt(metal::max(metal::dot(across_1, across_1), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side), follow);
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle turned_from_the_key = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    float _e22 = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    float in_the_dark = 1.0 - _e22;
    metal::float4 shadow = metal::float4(metal::float3(0.62, 0.16, 0.26) * metal::mix(metal::float3(1.0), metal::float3(0.5, 0.33, 0.56), in_the_dark), 1.0);
    metal::float3 normal_1 = surface.normal;
    Light _e42 = look.key;
    metal::float3 _e44 = half_vector(_e42, surface.view);
    Angle _e45 = angle_between_directions(normal_1, _e44);
    float _e48 = profile_balanced_2_(_e45, 0.0, disc_shape);
    AxesAround _e53 = axes(_e44, metal::float3(0.0, 1.0, 0.0));
    DirectionParts _e56 = direction_within(normal_1, _e53.x_axis, _e53.y_axis);
    metal::float3 _e60 = direction_moved(_e56, metal::float2(-0.13, 0.13));
    Angle _e61 = angle_between_directions(_e60, _e44);
    float _e64 = profile_balanced_2_(_e61, 0.0, bite_shape);
    float crescent = metal::min(_e48, 1.0 - _e64);
    DirectionParts _e70 = direction_within(normal_1, _e53.x_axis, _e53.y_axis);
    metal::float3 _e74 = direction_moved(_e70, metal::float2(-0.06, 0.06));
    Angle _e75 = angle_between_directions(_e74, _e44);
    float _e78 = profile_balanced_2_(_e75, 0.0, dot_shape);
    float crescent_and_dot = metal::max(crescent, _e78);
    Composite _e87 = blend_alpha(shadow, metal::float4(1.0, 0.97, 0.9, 1.0), crescent_and_dot, 0.96, true);
    Light _e90 = look.back;
    float _e96 = rim(_e90, surface.normal, surface.view, 0.42, 0.08, 1.0);
    float rim_in_the_dark_only = metal::min(_e96, in_the_dark);
    metal::float4 rim_s_light = metal::clamp(metal::float4(_e87.xyz + (0.6 * ((_e87.xyz + (rim_in_the_dark_only * metal::float3(1.0, 0.62, 0.5))) - _e87.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return rim_s_light;
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
, constant View& view_2 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_2.clip_from_world;
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
, constant View& view_2 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_2 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    Surface surface_1 = Surface {normal_2, metal::normalize(_e8.xyz - (_e13 * in.position))};
    metal::float4 _e19 = shade(surface_1, look);
    return fs_mainOutput { _e19 };
}
