// Highlight shapes: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_2 buffer(0), object buffer(1), look buffer(2).
// highlight-shapes.json says what to put there and how to draw.
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
    Light spark;
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
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant ProfileShape shadow_side_shape = ProfileShape {0.7484994, 0.66313547, 0.0, 1.0, 1.45, 0.0, 0.0, 1u};
constant ProfileShape window_shape = ProfileShape {0.99804753, 0.062459316, 0.0, 1.0, 0.125, 0.0, 0.0, 1u};
constant ProfileShape spark_shape = ProfileShape {0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u};

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
    int exponent = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
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
    float s_1 = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s_1) * c, 1.0 - ((2.0 * s_1) * s_1));
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

Angle angle_of(
    float radians
) {
    float half_angle = 0.5 * metal::min(radians, PI);
    metal::float2 _e5 = sin_cos_quarter(half_angle);
    return Angle {metal::max(_e5.x, 0.0), metal::max(_e5.y, 0.0)};
}

float atan2_positive(
    float y_2,
    float x_5
) {
    float small = metal::min(y_2, x_5);
    float large = metal::max(y_2, x_5);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_2 = small / large;
    bool is_wide = t_2 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_2;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y_2 > x_5) ? (HALF_PI - a) : a;
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
    float s_2 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, u_1.half_cos);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_3 = u_2.half_sin - (u_2.half_cos * 0.0);
    float c_1 = u_2.half_cos + (u_2.half_sin * 0.0);
    metal::float2 upper_1 = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_3, c_1);
    metal::float2 turned_1 = ((s_3 <= 0.0) & (s_3 < c_1)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

float angle_of_point(
    float y_3,
    float x_6
) {
    metal::float2 p = metal::abs(metal::float2(x_6, y_3));
    metal::float2 scaled_1 = (metal::max(p.x, p.y) > 1.0) ? (0.5 * p) : p;
    float _e14 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_2 = (x_6 < 0.0) ? (PI - _e14) : _e14;
    return (y_3 < 0.0) ? -(turned_2) : turned_2;
}

float footprint_of(
    float x_7
) {
    float _e1 = metal::dfdx(x_7);
    float _e2 = metal::dfdy(x_7);
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

DirectionParts direction_within(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis
) {
    metal::float3 y_5 = y_axis * metal::rsqrt(metal::max(metal::dot(y_axis, y_axis), 0.000000000000000000000000000001));
    return DirectionParts {direction, x_axis, y_5, metal::float2(metal::dot(direction, x_axis), metal::dot(direction, y_5))};
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

float star_reach(
    float turn,
    float rays,
    float inner,
    float round
) {
    float half_sector = PI / rays;
    float sector = metal::abs((turn * rays) - metal::floor((turn * rays) + 0.5));
    metal::float2 _e18 = sin_cos_quarter(metal::min((2.0 * sector) * half_sector, HALF_PI));
    metal::float2 _e26 = sin_cos_quarter(metal::max((1.0 - (2.0 * sector)) * half_sector, 0.0));
    metal::float2 _e27 = sin_cos_quarter(half_sector);
    float corner = _e27.x;
    float straight = (inner * corner) / metal::max((inner * _e26.x) + _e18.x, 0.000001);
    return metal::mix(straight, 1.0, round);
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
    float x_8,
    float y_4
) {
    DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    metal::float2 side = metal::select(metal::float2(-1.0), metal::float2(1.0), _e5.place >= metal::float2(0.0));
    metal::float3 _e18 = direction_moved(_e5, -(metal::float2(x_8, y_4)) * side);
    return _e18;
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
    float corner_1 = ((square_3 > 0.00000000000000000001) & (aside_1 < 1.0)) ? _e26 : 0.0;
    metal::float3 _e38 = direction_moved(_e5, (-(amount) * corner_1) * _e5.place);
    return _e38;
}

Angle star_angle(
    metal::float3 direction_4,
    metal::float3 middle,
    metal::float3 x_axis_3,
    metal::float3 y_axis_3,
    int rays_1,
    float inner_1,
    float round_1,
    float turn_1
) {
    DirectionParts _e8 = direction_within(direction_4, x_axis_3, y_axis_3);
    Angle u_3 = Angle {0.5 * metal::length(_e8.direction - middle), 0.5 * metal::length(_e8.direction + middle)};
    float _e24 = angle_of_point(_e8.place.y, _e8.place.x);
    float around = (_e24 - turn_1) / 6.2831855;
    float _e29 = star_reach(around, 4.0, inner_1, round_1);
    float _e32 = atan2_positive(u_3.half_sin, u_3.half_cos);
    Angle _e36 = angle_of((2.0 * _e32) / _e29);
    return _e36;
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

float profile_ramp_quick(
    float s,
    float w,
    ProfileShape shape
) {
    float width_1 = metal::sqrt(w * w);
    float from_offset = s * (2.0 + ((s * s) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((0.0 - from_offset) / metal::max(width_1, 0.000001)), 0.0, 1.0);
    return (w <= 0.0) ? ((s <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_1
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset), _e14, shape_1);
    return _e15;
}

float profile_balanced_2_(
    Angle angle_1,
    float shift_1,
    ProfileShape shape_2
) {
    Angle _e6 = angle_turned_2_(angle_1, metal::float2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick((_e6.half_sin * shape_2.half_cos_offset) - (_e6.half_cos * shape_2.half_sin_offset), _e14, shape_2);
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

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle turned_from_the_key = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    float _e22 = profile_balanced(turned_from_the_key, 0.0, shadow_side_shape);
    float in_the_dark = 1.0 - _e22;
    metal::float4 shadow = metal::min(metal::float4(metal::float3(0.83, 0.19, 0.18) * metal::mix(metal::float3(1.0), metal::float3(0.52, 0.25, 0.46), in_the_dark), 1.0), metal::float4(1.0));
    Light _e44 = look.key;
    metal::float3 _e46 = half_vector(_e44, surface.view);
    AxesAround _e51 = axes(_e46, metal::float3(0.0, 1.0, 0.0));
    metal::float3 _e57 = split_direction(surface.normal, _e51.x_axis, _e51.y_axis, 0.15, 0.15);
    metal::float3 _e62 = square_direction(_e57, _e51.x_axis, _e51.y_axis, 0.3, 4.0);
    Angle window_angle = Angle {0.5 * metal::length(_e62 - _e46), 0.5 * metal::length(_e62 + _e46)};
    float _e74 = profile_balanced_2_(window_angle, 0.0, window_shape);
    Composite _e82 = blend_alpha(shadow, metal::float4(1.0, 0.97, 0.9, 1.0), _e74, 0.95, true);
    Light _e85 = look.spark;
    metal::float3 _e87 = half_vector(_e85, surface.view);
    AxesAround _e92 = axes(_e87, metal::float3(0.0, 1.0, 0.0));
    Angle _e100 = star_angle(surface.normal, _e87, _e92.x_axis, _e92.y_axis, 4, 0.28, 0.0, 0.3);
    float _e103 = profile_balanced_2_(_e100, 0.0, spark_shape);
    metal::float4 spark_s_light = metal::clamp(metal::float4(_e82.xyz + (_e103 * (metal::float3(1.0, 0.83, 0.42) - _e82.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    Light _e122 = look.back;
    float _e128 = rim(_e122, surface.normal, surface.view, 0.38, 0.15, 1.0);
    metal::float4 rim_s_light = metal::clamp(metal::float4(spark_s_light.xyz + (0.75 * ((spark_s_light.xyz + (_e128 * metal::float3(0.55, 0.72, 1.0))) - spark_s_light.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
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
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position))};
    metal::float4 _e19 = shade(surface_1, look);
    return fs_mainOutput { _e19 };
}
