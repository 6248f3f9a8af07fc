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
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape shadow_side_shape = ProfileShape {0.7484994, 0.66313547, 0.0, 1.0, 1.45, 0.0, 0.0, 1u};
constant ProfileShape window_shape = ProfileShape {0.99804753, 0.062459316, 0.0, 1.0, 0.125, 0.0, 0.0, 1u};
constant ProfileShape spark_shape = ProfileShape {0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

float finite_or(
    float x_1,
    float otherwise
) {
    bool _e2 = is_finite(x_1);
    return _e2 ? x_1 : otherwise;
}

metal::float3 finite_vec3_(
    metal::float3 v
) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return metal::float3(_e3, _e6, _e9);
}

metal::float4 finite_vec4_(
    metal::float4 v_1
) {
    metal::float3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return metal::float4(_e2, _e5);
}

metal::float3 normalize_or(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    bool local = {};
    float largest = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest > 0.000000000000000000000000000001) {
        local = largest < 1000000000000000000000000000000.0;
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    metal::float3 scaled = v_2 * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

float power_of_two(
    int n
) {
    return as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(n) + as_type<uint>(127))) << 23u);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

float exp2_stable(
    float x_2
) {
    float clamped_5 = metal::clamp(x_2, -150.0, 127.99999);
    float whole = metal::rint(clamped_5);
    float f = (clamped_5 - whole) * LN_2_;
    float p = 1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127)))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two(as_type<int>(as_type<uint>(naga_f2i32(whole)) - as_type<uint>(half_whole)));
    return (p * _e33) * _e37;
}

float log_stable(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    int shift_2 = static_cast<int>((bits - 1060439283u) >> 23u);
    int exponent_1 = (shift_2 >= 256) ? as_type<int>(as_type<uint>(shift_2) - as_type<uint>(512)) : shift_2;
    float mantissa = as_type<float>(bits - (static_cast<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    float series = (2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111))))))));
    return (static_cast<float>(exponent_1) * LN_2_) + series;
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
    float s = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s) * c, 1.0 - ((2.0 * s) * s));
}

Angle angle_between(
    metal::float3 d,
    metal::float3 l
) {
    float p_1 = metal::length(d - l);
    float s_1 = metal::length(d + l);
    float k = 1.0 / metal::sqrt(metal::max((p_1 * p_1) + (s_1 * s_1), 0.000000000000000000000000000001));
    return Angle {p_1 * k, s_1 * k};
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
    float series_1 = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_2 = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_2 > x_5) ? (HALF_PI - a_2) : a_2;
}

float angle_radians(
    Angle u
) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return 2.0 * _e3;
}

Angle angle_of(
    float radians
) {
    float _e2 = finite_or(radians, 0.0);
    float half_angle = 0.5 * metal::clamp(_e2, 0.0, PI);
    metal::float2 _e8 = sin_cos_quarter(half_angle);
    return Angle {metal::max(_e8.x, 0.0), metal::max(_e8.y, 0.0)};
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    bool local_1 = {};
    float s_2 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_1);
    if (s_2 <= 0.0) {
        local_1 = s_2 < c_1;
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    metal::float2 turned = _e32 ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_shifted(
    Angle u_2,
    float shift
) {
    metal::float2 _e7 = sin_cos_quarter(0.5 * metal::clamp(shift, -3.1415927, PI));
    Angle _e8 = angle_turned(u_2, _e7);
    return _e8;
}

float angle_footprint(
    Angle u_3
) {
    metal::float2 half_ = metal::float2(u_3.half_sin, u_3.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_1 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    float _e13 = finite_or(w_1, 0.5);
    return metal::min(_e13, 0.5);
}

float bounded(
    float x_6
) {
    uint bits_1 = as_type<uint>(x_6);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float2 bounded_vec2_(
    metal::float2 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return metal::float2(_e2, _e4);
}

float mixed(
    float a,
    float b,
    float t_1
) {
    float _e4 = bounded(b - a);
    float _e14 = bounded((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4)));
    return _e14;
}

float place_between(
    float x_7,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_7 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_7 - low) / _e12);
    return _e14;
}

float eased(
    float x_8,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_8);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_3 = metal::clamp(_e6, 0.0, 1.0);
    return (t_3 * t_3) * (3.0 - (2.0 * t_3));
}

float factor_of(
    float x_9,
    bool clamped
) {
    float _e2 = bounded(x_9);
    float _e3 = bounded(x_9);
    return clamped ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

float angle_of_point(
    float y_3,
    float x_10
) {
    metal::float2 _e3 = bounded_vec2_(metal::float2(x_10, y_3));
    metal::float2 p_2 = metal::abs(_e3);
    metal::float2 scaled_1 = (metal::max(p_2.x, p_2.y) > 1.0) ? (0.5 * p_2) : p_2;
    float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_1 = (x_10 < 0.0) ? (PI - _e15) : _e15;
    return (y_3 < 0.0) ? -(turned_1) : turned_1;
}

float footprint_of(
    float x_11
) {
    float _e1 = metal::dfdx(x_11);
    float _e2 = metal::dfdy(x_11);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d_1, d_1)));
    return _e6;
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

metal::float3 any_orthogonal(
    metal::float3 n_1
) {
    float sign = (n_1.z >= 0.0) ? 1.0 : -1.0;
    float a_3 = -1.0 / (sign + n_1.z);
    return metal::float3(1.0 + (((sign * n_1.x) * n_1.x) * a_3), ((sign * n_1.x) * n_1.y) * a_3, -(sign) * n_1.x);
}

metal::float3 normal(
    metal::float3 normal_1
) {
    return normal_1;
}

Angle angle_between_directions(
    metal::float3 a_1,
    metal::float3 b_1
) {
    metal::float3 z_2 = metal::float3(0.0, 0.0, 1.0);
    metal::float3 _e6 = normalize_or(a_1, z_2);
    metal::float3 _e7 = normalize_or(b_1, z_2);
    Angle _e8 = angle_between(_e6, _e7);
    return _e8;
}

DirectionParts direction_within(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis
) {
    metal::float3 _e7 = normalize_or(direction, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e10 = normalize_or(x_axis, metal::float3(0.0));
    metal::float3 _e13 = normalize_or(y_axis, metal::float3(0.0));
    return DirectionParts {_e7, _e10, _e13, metal::float2(metal::dot(_e7, _e10), metal::dot(_e7, _e13))};
}

metal::float3 direction_moved(
    DirectionParts parts,
    metal::float2 by
) {
    metal::float2 step = metal::clamp(by, metal::float2(-1000000.0), metal::float2(1000000.0));
    metal::float3 moved = (parts.direction + (step.x * parts.x_axis)) + (step.y * parts.y_axis);
    metal::float3 _e18 = normalize_or(moved, parts.direction);
    return (metal::dot(moved, moved) > 0.000001) ? _e18 : parts.direction;
}

metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 _e6 = normalize_or(toward, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e11 = normalize_or(up, metal::float3(0.0, 1.0, 0.0));
    metal::float3 leaning = metal::cross(_e11, _e6);
    float square_1 = metal::dot(leaning, leaning);
    metal::float3 aside = (metal::abs(_e6.x) > 0.7) ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = (square_1 > 0.00000001) ? leaning : metal::cross(aside, _e6);
    metal::float3 _e38 = normalize_or(across - (metal::dot(across, _e6) * _e6), metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(_e38, metal::cross(_e6, _e38), _e6);
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
    metal::float2 _e27 = sin_cos_quarter(metal::clamp((1.0 - (2.0 * sector)) * half_sector, 0.0, HALF_PI));
    metal::float2 _e30 = sin_cos_quarter(metal::min(half_sector, HALF_PI));
    float corner = _e30.x;
    float straight_1 = (inner * corner) / metal::max((inner * _e27.x) + _e18.x, 0.000001);
    return metal::mix(straight_1, 1.0, round);
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
    float x_12,
    float y_4
) {
    DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    metal::float2 side = metal::select(metal::float2(-1.0), metal::float2(1.0), _e5.place >= metal::float2(0.0));
    metal::float3 _e21 = direction_moved(_e5, -(metal::max(metal::float2(x_12, y_4), metal::float2(0.0))) * side);
    return _e21;
}

metal::float3 square_direction(
    metal::float3 direction_3,
    metal::float3 x_axis_2,
    metal::float3 y_axis_2,
    float amount,
    float sharpness
) {
    bool local_2 = {};
    DirectionParts _e5 = direction_within(direction_3, x_axis_2, y_axis_2);
    float square_2 = metal::dot(_e5.place, _e5.place);
    float apart = metal::abs(_e5.place.x) - metal::abs(_e5.place.y);
    float aside_1 = metal::clamp((apart * apart) / metal::max(square_2, 0.00000000000000000001), 0.0, 1.0);
    float _e23 = bounded(sharpness);
    float sharp = metal::clamp(_e23, 1.0, 1024.0);
    float _e29 = log1p_negative(aside_1);
    float _e31 = exp2_stable((sharp * LOG2_E) * _e29);
    if (square_2 > 0.00000000000000000001) {
        local_2 = aside_1 < 1.0;
    } else {
        local_2 = false;
    }
    bool _e39 = local_2;
    float corner_1 = _e39 ? _e31 : 0.0;
    metal::float3 _e49 = direction_moved(_e5, (-(metal::clamp(amount, 0.0, 1.0)) * corner_1) * _e5.place);
    return _e49;
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
    metal::float3 z_3 = metal::float3(0.0, 0.0, 1.0);
    DirectionParts _e12 = direction_within(direction_4, x_axis_3, y_axis_3);
    metal::float3 _e14 = normalize_or(middle, z_3);
    Angle _e15 = angle_between(_e12.direction, _e14);
    float _e20 = angle_of_point(_e12.place.y, _e12.place.x);
    float _e21 = bounded(turn_1);
    float around = (_e20 - metal::clamp(_e21, -10000.0, 10000.0)) / 6.2831855;
    float _e38 = star_reach(around, static_cast<float>(metal::clamp(rays_1, 2, 64)), metal::clamp(inner_1, 0.01, 1.0), metal::clamp(round_1, 0.0, 1.0));
    float _e39 = angle_radians(_e15);
    Angle _e41 = angle_of(_e39 / _e38);
    return _e41;
}

Composite blend_finish(
    Composite below,
    metal::float3 blended,
    float alpha,
    float opacity,
    bool clamped_1
) {
    if (opacity <= 0.0) {
        return below;
    }
    metal::float4 mixed_1 = metal::float4(below.xyz + (opacity * (blended - below.xyz)), alpha);
    return clamped_1 ? metal::clamp(mixed_1, metal::float4(0.0), metal::float4(1.0)) : mixed_1;
}

Composite blend_add(
    Composite below_1,
    Color color,
    float tone,
    float opacity_1,
    bool clamped_2
) {
    Composite _e12 = blend_finish(below_1, below_1.xyz + (tone * color.xyz), below_1.w, opacity_1 * color.w, clamped_2);
    return _e12;
}

Composite blend_alpha(
    Composite below_2,
    Color color_1,
    float tone_1,
    float opacity_2,
    bool clamped_3
) {
    float a_4 = opacity_2 * color_1.w;
    float alpha_1 = below_2.w + ((tone_1 * a_4) * (1.0 - below_2.w));
    Composite _e20 = blend_finish(below_2, below_2.xyz + (tone_1 * (color_1.xyz - below_2.xyz)), alpha_1, a_4, clamped_3);
    return _e20;
}

Composite blend_shade(
    Composite below_3,
    Color color_2,
    float tone_2,
    float opacity_3,
    bool clamped_4
) {
    Composite _e14 = blend_finish(below_3, below_3.xyz * metal::mix(metal::float3(1.0), color_2.xyz, tone_2), below_3.w, opacity_3 * color_2.w, clamped_4);
    return _e14;
}

Color output(
    Composite color_3
) {
    Color _e1 = straight(color_3);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(
    Light light_1,
    metal::float3 normal_2
) {
    metal::float3 _e6 = normalize_or(normal_2, metal::float3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light_1.direction);
    return _e8;
}

float profile_power(
    float q,
    float exponent
) {
    float log_base = 0.0;
    if (q >= 1.0) {
        return 0.0;
    }
    if (q < 0.5) {
        float _e10 = log1p_negative_small(q * q);
        log_base = _e10;
    } else {
        float _e16 = log_stable((1.0 - q) * (1.0 + q));
        log_base = _e16;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable((exponent * LOG2_E) * _e19);
    return metal::clamp(_e21, 0.0, 1.0);
}

float profile_point(
    Angle u_4,
    ProfileShape shape
) {
    bool local_3 = {};
    float s_3 = (u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset);
    if (!((s_3 <= 0.0))) {
        local_3 = shape.kind == PROFILE_AMBIENT;
    } else {
        local_3 = true;
    }
    bool _e18 = local_3;
    if (_e18) {
        return 1.0;
    }
    if (shape.kind == PROFILE_STEP) {
        return (s_3 <= 0.0000004) ? 1.0 : 0.0;
    }
    float q_1 = s_3 * shape.scale;
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(
    Angle u_5,
    float w,
    ProfileShape shape_1
) {
    bool local_4 = {};
    bool local_5 = {};
    float _e3 = profile_point(u_5, shape_1);
    if (!((w <= 0.0))) {
        local_4 = shape_1.kind == PROFILE_AMBIENT;
    } else {
        local_4 = true;
    }
    bool _e13 = local_4;
    if (_e13) {
        return _e3;
    }
    if (shape_1.edge_deviation < 0.145) {
        local_5 = w >= (3.4641016 * shape_1.edge_deviation);
    } else {
        local_5 = false;
    }
    bool _e24 = local_5;
    if (_e24) {
        float width_1 = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
        float _e36 = angle_radians(u_5);
        return metal::clamp(0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_1), 0.0, 1.0);
    }
    if (w < (0.1 * shape_1.edge_deviation)) {
        return _e3;
    }
    metal::float2 _e50 = sin_cos_quarter(0.19364917 * w);
    Angle _e51 = angle_turned(u_5, _e50);
    float _e52 = profile_point(_e51, shape_1);
    Angle _e57 = angle_turned(u_5, metal::float2(-(_e50.x), _e50.y));
    float _e58 = profile_point(_e57, shape_1);
    return (((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0;
}

float profile(
    Angle angle,
    float shift_1,
    ProfileShape shape_2
) {
    Angle _e3 = angle_shifted(angle, shift_1);
    float _e4 = angle_footprint(_e3);
    float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
}

float rim(
    Light light_2,
    metal::float3 normal_3,
    metal::float3 view_1,
    float width,
    float softness,
    float follow
) {
    metal::float3 _e10 = normalize_or(normal_3, metal::float3(0.0, 0.0, 1.0));
    float facing = metal::clamp(metal::dot(_e10, view_1), 0.0, 1.0);
    float _e16 = factor_of(width, true);
    float _e18 = factor_of(softness, true);
    float _e20 = footprint_of(facing);
    float edge = metal::max(_e16 * _e18, metal::min(_e20, 1.0));
    metal::float3 aside_2 = _e10 - view_1;
    float further = (facing > 0.5) ? ((0.5 * metal::dot(aside_2, aside_2)) - (1.0 - _e16)) : (_e16 - facing);
    float within = (further / metal::max(edge, 0.000001)) + ((softness > 0.0) ? 0.0 : 0.5);
    float inside = (_e16 <= 0.0) ? 0.0 : metal::clamp(within, 0.0, 1.0);
    metal::float3 across_1 = light_2.direction - (metal::dot(light_2.direction, view_1) * view_1);
    metal::float3 _e61 = normalize_or(across_1, metal::float3(0.0));
    float side_1 = metal::dot(_e10 - (metal::dot(_e10, view_1) * view_1), _e61);
    float _e66 = eased(side_1, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return inside * _e69;
}

float invert(
    float value
) {
    float _e3 = bounded(1.0 - value);
    return _e3;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    float _e8 = profile(_e5, 0.0, shadow_side_shape);
    float _e9 = invert(_e8);
    Composite _e22 = blend_shade(metal::float4(0.83, 0.19, 0.18, 1.0), metal::float4(0.52, 0.25, 0.46, 1.0), _e9, 1.0, true);
    metal::float3 _e24 = normal(surface_1.normal);
    Light _e27 = look.key;
    metal::float3 _e29 = half_vector(_e27, surface_1.view);
    AxesAround _e34 = axes(_e29, metal::float3(0.0, 1.0, 0.0));
    metal::float3 _e39 = split_direction(_e24, _e34.x_axis, _e34.y_axis, 0.15, 0.15);
    metal::float3 _e44 = square_direction(_e39, _e34.x_axis, _e34.y_axis, 0.3, 4.0);
    Angle _e45 = angle_between_directions(_e44, _e29);
    float _e48 = profile(_e45, 0.0, window_shape);
    Composite _e56 = blend_alpha(_e22, metal::float4(1.0, 0.97, 0.9, 1.0), _e48, 0.95, true);
    Light _e59 = look.spark;
    metal::float3 _e61 = half_vector(_e59, surface_1.view);
    AxesAround _e66 = axes(_e61, metal::float3(0.0, 1.0, 0.0));
    Angle _e74 = star_angle(surface_1.normal, _e61, _e66.x_axis, _e66.y_axis, 4, 0.28, 0.0, 0.3);
    float _e77 = profile(_e74, 0.0, spark_shape);
    Composite _e85 = blend_alpha(_e56, metal::float4(1.0, 0.83, 0.42, 1.0), _e77, 1.0, true);
    Light _e88 = look.back;
    float _e94 = rim(_e88, surface_1.normal, surface_1.view, 0.38, 0.15, 1.0);
    Composite _e102 = blend_add(_e85, metal::float4(0.55, 0.72, 1.0, 1.0), _e94, 0.75, true);
    Color _e103 = output(_e102);
    return _e103;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_4 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_2.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    Varyings _e22 = out;
    const auto _tmp = _e22;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_4 [[user(loc1), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_4 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_4 = is_front ? _e7 : -(_e7);
    surface.normal = normal_4;
    metal::float4 _e15 = view_2.eye;
    float _e20 = view_2.eye.w;
    metal::float4 _e26 = view_2.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    Surface _e34 = surface;
    metal::float4 _e35 = shade(_e34, look);
    metal::float4 _e36 = finite_vec4_(_e35);
    return fs_mainOutput { _e36 };
}
