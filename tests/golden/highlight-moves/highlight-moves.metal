// A highlight, moved: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_2 buffer(0), object buffer(1), look buffer(2).
// highlight-moves.json says what to put there and how to draw.
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
    float turn_angle;
    float move_x;
    float move_y;
    float stretch_x;
    float stretch_y;
    float split_x;
    float split_y;
    float square_amount;
    metal::float4 body;
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
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant ProfileShape lit_side_shape = ProfileShape {0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733, 0.08138281, 0u};
constant ProfileShape highlight_shape = ProfileShape {0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0, 0.0, 1u};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

metal::float3 normalize_or(
    metal::float3 v_1,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v_1.x), metal::abs(v_1.y)), metal::abs(v_1.z));
    if (!(((largest > 0.000000000000000000000000000001) & (largest < 1000000000000000000000000000000.0)))) {
        return otherwise;
    }
    metal::float3 scaled = v_1 * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x_1
) {
    float clamped_1 = metal::max(x_1, -126.0);
    float whole = metal::rint(clamped_1);
    float f = clamped_1 - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_2
) {
    uint bits = as_type<uint>(x_2);
    int exponent_1 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

float log_stable(
    float x_3
) {
    float _e2 = log2_stable(x_3);
    return LN_2_ * _e2;
}

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

float log1p_negative(
    float y_1
) {
    if (y_1 < 0.25) {
        float _e3 = log1p_negative_small(y_1);
        return _e3;
    }
    float _e8 = log_stable(metal::max(1.0 - y_1, 0.000000000000000000000000000000000000011754944));
    return _e8;
}

metal::float2 sin_cos_quarter(
    float x_4
) {
    float h = 0.5 * x_4;
    float h2_ = h * h;
    float s_3 = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s_3) * c, 1.0 - ((2.0 * s_3) * s_3));
}

metal::float2 sin_cos(
    float x_5
) {
    float turns = metal::rint(x_5 * 0.31830987);
    float r = ((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 0.00000062783295);
    float sign = 1.0 - (2.0 * metal::abs(turns - (2.0 * metal::trunc(turns * 0.5))));
    metal::float2 _e27 = sin_cos_quarter(metal::clamp(r, -1.5707964, HALF_PI));
    return sign * _e27;
}

metal::float3 normalize_moderate(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    float square_1 = metal::dot(v_2, v_2);
    return (square_1 > 0.000000000000000000000000000001) ? (v_2 * metal::rsqrt(metal::max(square_1, 0.000000000000000000000000000001))) : otherwise_1;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_3
) {
    return v_3 * metal::rsqrt(metal::max(metal::dot(v_3, v_3), 0.000000000000000000000000000001));
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
    float s_4 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_4, u_1.half_cos);
    metal::float2 turned = ((s_4 <= 0.0) & (s_4 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_5 = u_2.half_sin - (u_2.half_cos * 0.0);
    float c_1 = u_2.half_cos + (u_2.half_sin * 0.0);
    metal::float2 upper_1 = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_5, c_1);
    metal::float2 turned_1 = ((s_5 <= 0.0) & (s_5 < c_1)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

metal::float3 bounded_vec3_(
    metal::float3 v_4
) {
    metal::uint3 bits_1 = as_type<metal::uint3>(v_4);
    metal::uint3 magnitude = bits_1 & metal::uint3(2147483647u);
    metal::float3 largest_1 = as_type<metal::float3>((bits_1 & metal::uint3(2147483648u)) | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest_1, magnitude == metal::uint3(2139095040u));
    return metal::select(numbers, v_4, magnitude < metal::uint3(2139095040u));
}

float footprint_of(
    float x_6
) {
    float _e1 = metal::dfdx(x_6);
    float _e2 = metal::dfdy(x_6);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

metal::float3 any_orthogonal(
    metal::float3 n
) {
    float sign_1 = (n.z >= 0.0) ? 1.0 : -1.0;
    float a = -1.0 / (sign_1 + n.z);
    return metal::float3(1.0 + (((sign_1 * n.x) * n.x) * a), ((sign_1 * n.x) * n.y) * a, -(sign_1) * n.x);
}

DirectionParts direction_within(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis
) {
    metal::float3 y_4 = y_axis * metal::rsqrt(metal::max(metal::dot(y_axis, y_axis), 0.000000000000000000000000000001));
    return DirectionParts {direction, x_axis, y_4, metal::float2(metal::dot(direction, x_axis), metal::dot(direction, y_4))};
}

metal::float3 direction_moved(
    DirectionParts parts,
    metal::float2 by
) {
    metal::float2 step = metal::clamp(by, metal::float2(-1000000.0), metal::float2(1000000.0));
    metal::float3 moved = (parts.direction + (step.x * parts.x_axis)) + (step.y * parts.y_axis);
    metal::float3 _e18 = normalize_moderate(moved, parts.direction);
    return (metal::dot(moved, moved) > 0.000001) ? _e18 : parts.direction;
}

metal::float3 direction_moved_2_(
    DirectionParts parts_1,
    metal::float2 by_1
) {
    metal::float3 moved_1 = (parts_1.direction + (by_1.x * parts_1.x_axis)) + (by_1.y * parts_1.y_axis);
    metal::float3 _e13 = normalize_moderate(moved_1, parts_1.direction);
    return (metal::dot(moved_1, moved_1) > 0.000001) ? _e13 : parts_1.direction;
}

metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 _e6 = normalize_moderate(up, metal::float3(0.0, 1.0, 0.0));
    metal::float3 leaning = metal::cross(_e6, toward);
    float square_2 = metal::dot(leaning, leaning);
    metal::float3 aside = (metal::abs(toward.x) > 0.7) ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = (square_2 > 0.00000001) ? leaning : metal::cross(aside, toward);
    metal::float3 _e33 = normalize_moderate(across - (metal::dot(across, toward) * toward), metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(_e33, metal::cross(toward, _e33), toward);
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

metal::float3 split_direction(
    metal::float3 direction_2,
    metal::float3 x_axis_1,
    metal::float3 y_axis_1,
    float x_7,
    float y_2
) {
    DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    metal::float2 side = metal::select(metal::float2(-1.0), metal::float2(1.0), _e5.place >= metal::float2(0.0));
    metal::float3 _e21 = direction_moved(_e5, -(metal::max(metal::float2(x_7, y_2), metal::float2(0.0))) * side);
    return _e21;
}

metal::float3 square_direction(
    metal::float3 direction_3,
    metal::float3 x_axis_2,
    metal::float3 y_axis_2,
    float amount,
    float sharpness
) {
    DirectionParts _e5 = direction_within(direction_3, x_axis_2, y_axis_2);
    float square_3 = metal::dot(_e5.place, _e5.place);
    float apart = metal::abs(_e5.place.x) - metal::abs(_e5.place.y);
    float aside_1 = metal::min((apart * apart) / metal::max(square_3, 0.00000000000000000001), 1.0);
    float _e24 = log1p_negative(aside_1);
    float _e26 = exp2_stable((sharpness * LOG2_E) * _e24);
    float corner = ((square_3 > 0.00000000000000000001) & (aside_1 < 1.0)) ? _e26 : 0.0;
    metal::float3 _e41 = direction_moved_2_(_e5, (-(metal::clamp(amount, 0.0, 1.0)) * corner) * _e5.place);
    return _e41;
}

metal::float3 stretch_direction(
    metal::float3 direction_4,
    metal::float3 x_axis_3,
    metal::float3 y_axis_3,
    float x_8,
    float y_3
) {
    DirectionParts _e5 = direction_within(direction_4, x_axis_3, y_axis_3);
    metal::float3 _e13 = direction_moved(_e5, -(metal::min(metal::float2(x_8, y_3), metal::float2(1.0))) * _e5.place);
    return _e13;
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    float alpha = below.w + ((tone * opacity) * (1.0 - below.w));
    return metal::clamp(metal::float4(below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz)), alpha), metal::float4(0.0), metal::float4(1.0));
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
    float r_1 = 0.19364917 * w_2;
    metal::float2 turn = metal::float2(r_1 * (1.0 - ((0.16666667 * r_1) * r_1)), 1.0 - ((0.5 * r_1) * r_1));
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
    metal::float3 aside_2 = normal - view_1;
    float further = (facing > 0.5) ? ((0.5 * metal::dot(aside_2, aside_2)) - (1.0 - width)) : (width - facing);
    float within = (further / edge) + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across_1 = light_1.direction - (metal::dot(light_1.direction, view_1) * view_1);
    float side_1 = metal::dot(normal - (metal::dot(normal, view_1) * view_1), across_1 * metal::rsqrt(metal::max(metal::dot(across_1, across_1), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side_1), follow);
}

metal::float3 rotate_vector(
    metal::float3 vector,
    metal::float3 axis,
    float angle_2
) {
    metal::float2 _e5 = sin_cos(0.5 * angle_2);
    metal::float2 half_2 = metal::clamp(_e5, metal::float2(-1.0), metal::float2(1.0));
    metal::float3 aside_3 = metal::cross(axis, vector);
    metal::float3 _e23 = bounded_vec3_(vector + ((2.0 * half_2.x) * ((half_2.y * aside_3) + (half_2.x * metal::cross(axis, aside_3)))));
    return _e23;
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
    metal::float4 _e27 = look.body;
    metal::float4 _e31 = look.body;
    metal::float4 _e43 = look.body;
    float _e50 = look.body.w;
    metal::float4 shadow = metal::clamp(metal::float4(_e27.xyz + ((_e31.xyz * metal::mix(metal::float3(1.0), metal::float3(0.45, 0.36, 0.62), in_the_dark)) - _e43.xyz), _e50), metal::float4(0.0), metal::float4(1.0));
    metal::float3 normal_1 = surface.normal;
    Light _e60 = look.key;
    metal::float3 _e62 = half_vector(_e60, surface.view);
    float _e69 = look.turn_angle;
    metal::float3 _e70 = rotate_vector(metal::float3(0.0, 1.0, 0.0), _e62, _e69);
    AxesAround _e71 = axes(_e62, _e70);
    DirectionParts _e74 = direction_within(normal_1, _e71.x_axis, _e71.y_axis);
    float _e77 = look.move_x;
    float _e80 = look.move_y;
    metal::float3 _e82 = direction_moved(_e74, metal::float2(_e77, _e80));
    float _e87 = look.stretch_x;
    float _e90 = look.stretch_y;
    metal::float3 _e91 = stretch_direction(_e82, _e71.x_axis, _e71.y_axis, _e87, _e90);
    float _e96 = look.split_x;
    float _e99 = look.split_y;
    metal::float3 _e100 = split_direction(_e91, _e71.x_axis, _e71.y_axis, _e96, _e99);
    float _e105 = look.square_amount;
    metal::float3 _e107 = square_direction(_e100, _e71.x_axis, _e71.y_axis, _e105, 4.0);
    Angle from_the_highlight = Angle {0.5 * metal::length(_e107 - _e62), 0.5 * metal::length(_e107 + _e62)};
    float _e119 = profile_balanced_2_(from_the_highlight, 0.0, highlight_shape);
    Composite _e127 = blend_alpha(shadow, metal::float4(1.0, 0.98, 0.92, 1.0), _e119, 0.96, true);
    Light _e130 = look.back;
    float _e136 = rim(_e130, surface.normal, surface.view, 0.3, 0.2, 1.0);
    metal::float4 rim_s_light = metal::clamp(metal::float4(_e127.xyz + (0.5 * ((_e127.xyz + (_e136 * metal::float3(0.55, 0.75, 1.0))) - _e127.xyz)), _e127.w), metal::float4(0.0), metal::float4(1.0));
    metal::float4 _e167 = finite_vec4_((rim_s_light.w <= 0.0) ? rim_s_light : metal::float4(rim_s_light.xyz / metal::float3(rim_s_light.w), rim_s_light.w));
    return _e167;
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
    metal::float4 _e20 = finite_vec4_(_e19);
    return fs_mainOutput { _e20 };
}
