// Light where it is wanted: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_3 buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0).
// local-control.json says what to put there and how to draw.
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
    metal::float3x3 camera_from_world;
    metal::float2 viewport;
    char _pad2[8];
    Light back;
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
    metal::float3 position_camera;
    metal::float3 curvature_tensor;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Angle {
    float half_sin;
    float half_cos;
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
    metal::float3 position_object;
    metal::float3 normal;
};
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape soft_tone_shape = ProfileShape {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u};

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
    float clamped_3 = metal::clamp(x_2, -150.0, 127.99999);
    float whole = metal::rint(clamped_3);
    float f = (clamped_3 - whole) * LN_2_;
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
    float y_1,
    float x_5
) {
    float small = metal::min(y_1, x_5);
    float large = metal::max(y_1, x_5);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_2 = small / large;
    bool is_wide = t_2 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_2;
    float r2_ = r * r;
    float series_1 = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_2 = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_1 > x_5) ? (HALF_PI - a_2) : a_2;
}

float angle_radians(
    Angle u
) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return 2.0 * _e3;
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
    float w_3 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    float _e13 = finite_or(w_3, 0.5);
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

metal::float3 bounded_vec3_(
    metal::float3 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    float _e6 = bounded(v_3.z);
    return metal::float3(_e2, _e4, _e6);
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

float length_of(
    metal::float3 v_4
) {
    metal::float3 _e1 = bounded_vec3_(v_4);
    float largest_2 = metal::max(metal::max(metal::abs(_e1.x), metal::abs(_e1.y)), metal::abs(_e1.z));
    if (largest_2 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e17 = bounded(largest_2 * metal::length(_e1 / metal::float3(largest_2)));
    return _e17;
}

float footprint_of(
    float x_10
) {
    float _e1 = metal::dfdx(x_10);
    float _e2 = metal::dfdy(x_10);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d_1, d_1)));
    return _e6;
}

float edge_width(
    float w,
    float softness
) {
    float _e4 = bounded(softness);
    return metal::length(metal::float2(metal::min(w, 1000000000000000.0), metal::clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(
    float x_11,
    float edge,
    float w_1
) {
    float _e4 = bounded(x_11 - edge);
    if (w_1 < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w_1);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

float kappa_safe(
    float kappa
) {
    bool is_nan = (as_type<uint>(kappa) & 2147483647u) > 2139095040u;
    return is_nan ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0);
}

metal::float3 tensor_safe(
    metal::float3 tensor
) {
    float _e2 = kappa_safe(tensor.x);
    float _e4 = kappa_safe(tensor.y);
    float _e6 = kappa_safe(tensor.z);
    return metal::float3(_e2, _e4, _e6);
}

float combine_tones_union(
    float a_1,
    float b_1
) {
    float _e3 = factor_of(a_1, true);
    float _e5 = factor_of(b_1, true);
    return metal::max(_e3, _e5);
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

Composite blend_alpha(
    Composite below_1,
    Color color,
    float tone,
    float opacity_1,
    bool clamped_2
) {
    float a_3 = opacity_1 * color.w;
    float alpha_1 = below_1.w + ((tone * a_3) * (1.0 - below_1.w));
    Composite _e20 = blend_finish(below_1, below_1.xyz + (tone * (color.xyz - below_1.xyz)), alpha_1, a_3, clamped_2);
    return _e20;
}

Color output(
    Composite color_1
) {
    Color _e1 = straight(color_1);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float near_place(
    metal::float3 position,
    metal::float3 center,
    float radius,
    float hardness
) {
    metal::float3 _e4 = bounded_vec3_(position);
    metal::float3 _e5 = bounded_vec3_(center);
    float _e7 = length_of(_e4 - _e5);
    float _e8 = bounded(radius);
    float reach = metal::max(_e8, 0.0);
    float _e12 = factor_of(hardness, true);
    float _e14 = eased(_e7, reach * _e12, reach);
    return 1.0 - _e14;
}

Light local_light(
    Light light,
    metal::float3 bend,
    float strength,
    metal::float3 center_1,
    float radius_1,
    float hardness_1,
    metal::float3 position_1
) {
    bool local_2 = {};
    float _e7 = near_place(position_1, center_1, radius_1, hardness_1);
    metal::float3 _e9 = bounded_vec3_(bend);
    metal::float3 bent = light.direction + (_e7 * metal::clamp(_e9, metal::float3(-1000000.0), metal::float3(1000000.0)));
    metal::float3 _e19 = normalize_or(bent, light.direction);
    if (metal::dot(bent, bent) > 0.000001) {
        local_2 = _e7 > 0.0;
    } else {
        local_2 = false;
    }
    bool _e28 = local_2;
    metal::float3 direction = _e28 ? _e19 : light.direction;
    float _e32 = bounded(strength);
    float _e36 = mixed(1.0, metal::clamp(_e32, 0.0, 1000000.0), _e7);
    float intensity = light.intensity * _e36;
    return Light {direction, light.own_direction, light.color, metal::min(intensity, 1000000000000000000000000000000.0)};
}

float local_tone(
    float tone_1,
    float amount,
    metal::float3 center_2,
    float radius_2,
    float hardness_2,
    metal::float3 position_2
) {
    float _e6 = near_place(position_2, center_2, radius_2, hardness_2);
    float _e7 = bounded(tone_1);
    float _e11 = bounded(amount);
    return metal::clamp(metal::clamp(_e7, 0.0, 1.0) + (_e6 * metal::clamp(_e11, -1.0, 1.0)), 0.0, 1.0);
}

Angle parametrization_diffuse(
    Light light_1,
    metal::float3 normal
) {
    metal::float3 _e6 = normalize_or(normal, metal::float3(0.0, 0.0, 1.0));
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
    float w_2,
    ProfileShape shape_1
) {
    bool local_4 = {};
    bool local_5 = {};
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_4 = shape_1.kind == PROFILE_AMBIENT;
    } else {
        local_4 = true;
    }
    bool _e13 = local_4;
    if (_e13) {
        return _e3;
    }
    if (shape_1.edge_deviation < 0.145) {
        local_5 = w_2 >= (3.4641016 * shape_1.edge_deviation);
    } else {
        local_5 = false;
    }
    bool _e24 = local_5;
    if (_e24) {
        float width_4 = metal::sqrt((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
        float _e36 = angle_radians(u_5);
        return metal::clamp(0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_4), 0.0, 1.0);
    }
    if (w_2 < (0.1 * shape_1.edge_deviation)) {
        return _e3;
    }
    metal::float2 _e50 = sin_cos_quarter(0.19364917 * w_2);
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

float threshold(
    float value,
    float edge_1,
    float softness_1
) {
    float _e3 = footprint_of(value);
    float _e4 = bounded(value);
    float _e5 = bounded(edge_1);
    float _e6 = edge_width(_e3, softness_1);
    float _e7 = step_filtered(_e4, _e5, _e6);
    return _e7;
}

float rim(
    Light light_2,
    metal::float3 normal_1,
    metal::float3 view,
    float width,
    float softness_2,
    float follow
) {
    metal::float3 _e10 = normalize_or(normal_1, metal::float3(0.0, 0.0, 1.0));
    float facing_1 = metal::clamp(metal::dot(_e10, view), 0.0, 1.0);
    float _e16 = factor_of(width, true);
    float _e18 = factor_of(softness_2, true);
    float _e20 = footprint_of(facing_1);
    float edge_2 = metal::max(_e16 * _e18, metal::min(_e20, 1.0));
    metal::float3 aside = _e10 - view;
    float further = (facing_1 > 0.5) ? ((0.5 * metal::dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing_1);
    float within = (further / metal::max(edge_2, 0.000001)) + ((softness_2 > 0.0) ? 0.0 : 0.5);
    float inside = (_e16 <= 0.0) ? 0.0 : metal::clamp(within, 0.0, 1.0);
    metal::float3 across = light_2.direction - (metal::dot(light_2.direction, view) * view);
    metal::float3 _e61 = normalize_or(across, metal::float3(0.0));
    float side = metal::dot(_e10 - (metal::dot(_e10, view) * view), _e61);
    float _e66 = eased(side, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return inside * _e69;
}

float line_covers(
    float distance,
    float width_1
) {
    return metal::clamp((width_1 + 0.5) - distance, 0.0, metal::min(width_1, 1.0));
}

float seen_well(
    float facing
) {
    float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

float faded_in(
    float x_12,
    float limit,
    float softness_3
) {
    float _e3 = bounded(limit);
    float at = metal::max(_e3, 0.0);
    float _e6 = footprint_of(x_12);
    float _e10 = factor_of(softness_3, true);
    float _e12 = edge_width(_e6, metal::min(at, 1000000000.0) * _e10);
    float _e13 = bounded(x_12);
    float _e14 = step_filtered(_e13, at, _e12);
    return _e14;
}

float inner_contour_suggestive(
    float width_2,
    float limit_1,
    float softness_4,
    metal::float3 tensor_1,
    metal::float3 normal_2,
    metal::float3 view_1,
    metal::float3x3 camera_from_world,
    metal::float3 place,
    metal::float2 viewport
) {
    metal::float3 n_1 = camera_from_world * normal_2;
    metal::float3 _e10 = tensor_safe(tensor_1);
    float square_1 = metal::dot(n_1.xy, n_1.xy);
    float radial = ((((_e10.x * n_1.x) * n_1.x) + (((2.0 * _e10.y) * n_1.x) * n_1.y)) + ((_e10.z * n_1.y) * n_1.y)) / metal::max(square_1, 0.000001);
    float _e36 = metal::dfdx(radial);
    float _e37 = metal::dfdy(radial);
    metal::float2 change = metal::float2(_e36, _e37);
    metal::float3 v_5 = camera_from_world * view_1;
    metal::float3 row = metal::dfdy(place);
    float up = ((row - (metal::dot(row, v_5) * v_5)).y >= 0.0) ? 1.0 : -1.0;
    float height = metal::clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(((change.x * n_1.x) + ((up * change.y) * n_1.y))) * metal::rsqrt(metal::max(square_1, 0.000001));
    float _e67 = bounded(width_2);
    float pixels = ((0.5 * metal::clamp(_e67, 0.0, 10000.0)) * height) / 1000.0;
    float distance_1 = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float _e84 = faded_in((toward_eye * height) * 0.05, limit_1, softness_4);
    float _e85 = line_covers(distance_1, pixels);
    float _e88 = seen_well(metal::dot(normal_2, view_1));
    return (_e85 * _e84) * _e88;
}

float outer_contour(
    float width_3,
    metal::float3 normal_3,
    metal::float3 view_2,
    metal::float2 viewport_1
) {
    metal::float3 _e6 = normalize_or(normal_3, metal::float3(0.0));
    float facing_2 = metal::clamp(metal::dot(_e6, view_2), 0.0, 1.0);
    float _e11 = bounded(width_3);
    float pixels_1 = (metal::clamp(_e11, 0.0, 10000.0) * metal::clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0;
    float _e22 = footprint_of(facing_2);
    float distance_2 = facing_2 / metal::max(2.0 * _e22, 0.000001);
    float _e30 = eased(facing_2, 0.45, 0.75);
    float near = 1.0 - _e30;
    float _e33 = line_covers(distance_2, pixels_1);
    return _e33 * near;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    Light _e16 = local_light(_e3, metal::float3(0.9, 0.25, 0.5), 1.0, metal::float3(0.12, 0.42, 0.5), 0.5, 0.4, surface_1.position_object);
    Light _e29 = local_light(_e16, metal::float3(0.4, 0.1, 0.35), 1.0, metal::float3(-0.05, -0.35, 0.5), 0.4, 0.2, surface_1.position_object);
    Angle _e31 = parametrization_diffuse(_e29, surface_1.normal);
    float _e34 = profile(_e31, 0.0, soft_tone_shape);
    float _e43 = local_tone(_e34, -0.45, metal::float3(0.0, 0.02, 0.45), 0.3, 0.1, surface_1.position_object);
    float _e52 = local_tone(_e43, 0.5, metal::float3(-0.2, 0.72, 0.4), 0.17, 0.5, surface_1.position_object);
    float _e55 = threshold(_e52, 0.55, 0.0);
    Composite _e68 = blend_alpha(metal::float4(0.36, 0.36, 0.6, 1.0), metal::float4(0.96, 0.72, 0.47, 1.0), _e55, 1.0, true);
    float _e71 = threshold(_e52, 0.97, 0.0);
    Composite _e79 = blend_alpha(_e68, metal::float4(1.0, 0.93, 0.76, 1.0), _e71, 1.0, true);
    Light _e82 = look.back;
    float _e88 = rim(_e82, surface_1.normal, surface_1.view, 0.3, 0.1, 1.0);
    Composite _e96 = blend_alpha(_e79, metal::float4(0.72, 0.86, 1.0, 1.0), _e88, 0.7, true);
    metal::float2 _e102 = look.viewport;
    float _e103 = outer_contour(3.0, surface_1.normal, surface_1.view, _e102);
    metal::float3x3 _e112 = look.camera_from_world;
    metal::float2 _e116 = look.viewport;
    float _e117 = inner_contour_suggestive(2.0, 20.0, 0.3, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e112, surface_1.position_camera, _e116);
    float _e118 = combine_tones_union(_e103, _e117);
    Composite _e126 = blend_alpha(_e96, metal::float4(0.17, 0.13, 0.28, 1.0), _e118, 0.85, true);
    Color _e127 = output(_e126);
    return _e127;
}

struct vs_mainInput {
    metal::float3 position_3 [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_3 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_3, varyings.normal_4 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_3.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    out.position_object = vertex_.position;
    metal::float3x3 _e21 = object.world_from_normal;
    out.normal = _e21 * vertex_.normal;
    Varyings _e24 = out;
    const auto _tmp = _e24;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_3 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_4 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_3 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position_3, varyings_1.position_object, varyings_1.normal_4 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_4 = is_front ? _e7 : -(_e7);
    surface.normal = normal_4;
    metal::float4 _e15 = view_3.eye;
    float _e20 = view_3.eye.w;
    metal::float4 _e26 = view_3.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    surface.position_object = in.position_object;
    metal::float4x4 _e39 = view_3.camera_from_world;
    surface.position_camera = (_e39 * metal::float4(in.position, 1.0)).xyz;
    metal::float4 _e51 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.curvature_tensor = _e51.xyz;
    Surface _e53 = surface;
    metal::float4 _e54 = shade(_e53, look);
    metal::float4 _e55 = finite_vec4_(_e54);
    return fs_mainOutput { _e55 };
}
