// Light that wavers: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// bent-light.json says what to put there and how to draw.
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
    metal::float2 viewport;
    char _pad1[8];
    Light eye;
    Light key;
    metal::float3 parts_direction;
    metal::float3 axes_of_the_light_x_axis;
    metal::float3 axes_of_the_light_y_axis;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
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
struct LightParts {
    metal::float3 direction;
    Color color;
    float intensity;
    char _pad3[12];
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
constant uint NOISE_PERLIN = 1u;
constant uint NOISE_SIMPLEX = 2u;
constant uint NOISE_WORLEY = 3u;
constant float SIMPLEX_SCALE = 38.4553;
constant float WORLEY_MEAN = 0.5205;
constant ProfileShape lit_shape = ProfileShape {0.8253356, 0.5646425, 25.006668, 1.7790966, 1.2, 0.04446849, 0.018017149, 0u};
constant ProfileShape brightest_shape = ProfileShape {0.9358968, 0.35227424, 40.004166, 3.6241908, 0.72, 0.021168118, 0.009611014, 0u};
constant ProfileShape window_shape = ProfileShape {0.9963897, 0.08489768, 0.0, 1.0, 0.17, 0.0, 0.0, 1u};

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
    float clamped_4 = metal::clamp(x_2, -150.0, 127.99999);
    float whole = metal::rint(clamped_4);
    float f = (clamped_4 - whole) * LN_2_;
    float p_6 = 1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127)))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two(as_type<int>(as_type<uint>(naga_f2i32(whole)) - as_type<uint>(half_whole)));
    return (p_6 * _e33) * _e37;
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
    float p_7 = metal::length(d - l);
    float s_1 = metal::length(d + l);
    float k = 1.0 / metal::sqrt(metal::max((p_7 * p_7) + (s_1 * s_1), 0.000000000000000000000000000001));
    return Angle {p_7 * k, s_1 * k};
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
    float t_3 = small / large;
    bool is_wide = t_3 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_3;
    float r2_ = r * r;
    float series_1 = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_1 = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_1 > x_5) ? (HALF_PI - a_1) : a_1;
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
    float w_2 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    float _e13 = finite_or(w_2, 0.5);
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

float remapped(
    float x_8,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    float _e6 = bounded(x_8);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, clamped ? metal::clamp(_e9, 0.0, 1.0) : _e9);
    return _e16;
}

float eased(
    float x_9,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_9);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_4 = metal::clamp(_e6, 0.0, 1.0);
    return (t_4 * t_4) * (3.0 - (2.0 * t_4));
}

float footprint_of(
    float x_10
) {
    float _e1 = metal::dfdx(x_10);
    float _e2 = metal::dfdy(x_10);
    metal::float2 d_3 = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d_3, d_3)));
    return _e6;
}

float footprint_of_vec3_(
    metal::float3 v_4
) {
    metal::float3 dx_1 = metal::dfdx(v_4);
    metal::float3 dy_1 = metal::dfdy(v_4);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx_1, dx_1), metal::dot(dy_1, dy_1))));
    return _e7;
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

metal::float3 position_object(
    metal::float3 position_object_1
) {
    return position_object_1;
}

metal::float3 view_2_(
    metal::float3 view_2_1
) {
    return view_2_1;
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

AxesAround axes(
    metal::float3 direction_1,
    metal::float3 up_1
) {
    metal::float3x3 _e2 = axes_around(direction_1, up_1);
    return AxesAround {_e2[0], _e2[1]};
}

Light light_toward(
    Light light,
    metal::float3 direction_2
) {
    metal::float3 _e3 = normalize_or(direction_2, light.direction);
    return Light {_e3, light.own_direction, light.color, light.intensity};
}

metal::float3 shift_direction(
    metal::float3 direction_3,
    metal::float3 x_axis_1,
    metal::float3 y_axis_1,
    float x_11,
    float y_2
) {
    DirectionParts _e5 = direction_within(direction_3, x_axis_1, y_axis_1);
    metal::float3 _e7 = direction_moved(_e5, metal::float2(x_11, y_2));
    return _e7;
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
    float a_2 = opacity_1 * color.w;
    float alpha_1 = below_1.w + ((tone * a_2) * (1.0 - below_1.w));
    Composite _e20 = blend_finish(below_1, below_1.xyz + (tone * (color.xyz - below_1.xyz)), alpha_1, a_2, clamped_2);
    return _e20;
}

Color output(
    Composite color_1
) {
    Color _e1 = straight(color_1);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
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
    bool local_2 = {};
    float s_3 = (u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset);
    if (!((s_3 <= 0.0))) {
        local_2 = shape.kind == PROFILE_AMBIENT;
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
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
    bool local_3 = {};
    bool local_4 = {};
    float _e3 = profile_point(u_5, shape_1);
    if (!((w <= 0.0))) {
        local_3 = shape_1.kind == PROFILE_AMBIENT;
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if (shape_1.edge_deviation < 0.145) {
        local_4 = w >= (3.4641016 * shape_1.edge_deviation);
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width_2 = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
        float _e36 = angle_radians(u_5);
        return metal::clamp(0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_2), 0.0, 1.0);
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

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_5 = {};
    v_5 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_5.x;
    uint _e10 = v_5.y;
    uint _e12 = v_5.z;
    v_5.x = _e8 + (_e10 * _e12);
    uint _e16 = v_5.y;
    uint _e18 = v_5.z;
    uint _e20 = v_5.x;
    v_5.y = _e16 + (_e18 * _e20);
    uint _e24 = v_5.z;
    uint _e26 = v_5.x;
    uint _e28 = v_5.y;
    v_5.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_5;
    metal::uint3 _e32 = v_5;
    v_5 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_5.x;
    uint _e40 = v_5.y;
    uint _e42 = v_5.z;
    v_5.x = _e38 + (_e40 * _e42);
    uint _e46 = v_5.y;
    uint _e48 = v_5.z;
    uint _e50 = v_5.x;
    v_5.y = _e46 + (_e48 * _e50);
    uint _e54 = v_5.z;
    uint _e56 = v_5.x;
    uint _e58 = v_5.y;
    v_5.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_5;
    return _e61;
}

metal::float3 unit_of_hash(
    metal::uint3 hash
) {
    return static_cast<metal::float3>(hash >> metal::uint3(8u)) * 0.000000059604645;
}

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

float gradient_dot(
    metal::uint3 hash_1,
    metal::float3 d_1
) {
    uint axis = naga_mod(hash_1.x >> 8u, 3u);
    float a_3 = (axis == 0u) ? d_1.y : d_1.x;
    float b_1 = (axis == 2u) ? d_1.y : d_1.z;
    return (((hash_1.y >> 31u) == 0u) ? a_3 : -(a_3)) + (((hash_1.z >> 31u) == 0u) ? b_1 : -(b_1));
}

metal::float3 fade_quintic(
    metal::float3 t_2
) {
    return ((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(
    metal::float3 p,
    uint seed_2
) {
    float sum = 0.0;
    int i = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 _e4 = fade_quintic(p - corner);
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e45 = i;
            i = as_type<int>(as_type<uint>(_e45) + as_type<uint>(1));
        }
        loop_init = false;
        int _e10 = i;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            metal::int3 at = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at)), seed_2);
            metal::float3 _e40 = unit_of_hash(_e39);
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e40.x);
        }
    }
    float _e47 = sum;
    return _e47;
}

float perlin_noise(
    metal::float3 p_1,
    uint seed_3
) {
    float sum_1 = 0.0;
    int i_1 = 0;
    metal::float3 corner_1 = metal::floor(p_1);
    metal::float3 d_4 = p_1 - corner_1;
    metal::float3 _e4 = fade_quintic(d_4);
    metal::int3 cell_2 = naga_f2i32(corner_1);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e46 = i_1;
            i_1 = as_type<int>(as_type<uint>(_e46) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e10 = i_1;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i_1;
            int _e16 = i_1;
            int _e21 = i_1;
            metal::int3 at_1 = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight_1 = metal::select(metal::float3(1.0) - _e4, _e4, at_1 == metal::int3(1));
            float _e32 = sum_1;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_2) + as_type<metal::uint3>(at_1)), seed_3);
            float _e42 = gradient_dot(_e39, d_4 - static_cast<metal::float3>(at_1));
            sum_1 = _e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42);
        }
    }
    float _e48 = sum_1;
    return metal::clamp(0.5 + (0.48244 * _e48), 0.0, 1.0);
}

float simplex_corner(
    metal::float3 d_2,
    metal::uint3 hash_2
) {
    float t_5 = metal::max(0.5 - metal::dot(d_2, d_2), 0.0);
    float _e10 = gradient_dot(hash_2, d_2);
    return (((t_5 * t_5) * t_5) * t_5) * _e10;
}

float simplex_noise(
    metal::float3 p_2,
    uint seed_4
) {
    float sum_2 = {};
    metal::float3 corner_2 = metal::floor(p_2 + metal::float3(((p_2.x + p_2.y) + p_2.z) / 3.0));
    metal::float3 d_5 = (p_2 - corner_2) + metal::float3(((corner_2.x + corner_2.y) + corner_2.z) / 6.0);
    metal::bool3 is_first = metal::bool3(d_5.x >= d_5.y, d_5.y >= d_5.z, d_5.z > d_5.x);
    metal::float3 g = metal::select(metal::float3(0.0), metal::float3(1.0), is_first);
    metal::float3 l_1 = metal::float3(1.0) - g;
    metal::float3 second = metal::min(g, l_1.zxy);
    metal::float3 third = metal::max(g, l_1.zxy);
    metal::int3 cell_3 = naga_f2i32(corner_2);
    metal::uint3 _e45 = lattice_hash(cell_3, seed_4);
    float _e46 = simplex_corner(d_5, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    metal::uint3 _e55 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_3) + as_type<metal::uint3>(naga_f2i32(second))), seed_4);
    float _e56 = simplex_corner((d_5 - second) + metal::float3(0.16666667), _e55);
    sum_2 = _e48 + _e56;
    float _e58 = sum_2;
    metal::uint3 _e65 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_3) + as_type<metal::uint3>(naga_f2i32(third))), seed_4);
    float _e66 = simplex_corner((d_5 - third) + metal::float3(0.33333334), _e65);
    sum_2 = _e58 + _e66;
    float _e68 = sum_2;
    metal::uint3 _e75 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_3) + as_type<metal::uint3>(metal::int3(1))), seed_4);
    float _e76 = simplex_corner(d_5 - metal::float3(0.5), _e75);
    sum_2 = _e68 + _e76;
    float _e79 = sum_2;
    return metal::clamp(0.5 + (SIMPLEX_SCALE * _e79), 0.0, 1.0);
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

float worley_noise(
    metal::float3 p_3,
    uint seed_5
) {
    float nearest = 1.0;
    int i_2 = 0;
    metal::float3 corner_3 = metal::floor(p_3);
    metal::float3 d_6 = p_3 - corner_3;
    metal::int3 cell_4 = naga_f2i32(corner_3);
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e40 = i_2;
            i_2 = as_type<int>(as_type<uint>(_e40) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e9 = i_2;
        if (_e9 < 27) {
        } else {
            break;
        }
        {
            int _e12 = i_2;
            int _e17 = i_2;
            int _e24 = i_2;
            metal::int3 at_2 = metal::int3(as_type<int>(as_type<uint>(naga_mod(_e12, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_mod(naga_div(_e17, 3), 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e24, 9)) - as_type<uint>(1)));
            metal::uint3 _e32 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_4) + as_type<metal::uint3>(at_2)), seed_5);
            metal::float3 _e33 = unit_of_hash(_e32);
            metal::float3 offset = (static_cast<metal::float3>(at_2) + _e33) - d_6;
            float _e36 = nearest;
            nearest = metal::min(_e36, metal::dot(offset, offset));
        }
    }
    float _e42 = nearest;
    return metal::sqrt(_e42);
}

float noise_octave(
    uint kind,
    metal::float3 p_4,
    uint seed_6
) {
    switch(kind) {
        case 1u: {
            float _e3 = perlin_noise(p_4, seed_6);
            return _e3;
        }
        case 2u: {
            float _e4 = simplex_noise(p_4, seed_6);
            return _e4;
        }
        case 3u: {
            float _e5 = worley_noise(p_4, seed_6);
            return _e5;
        }
        default: {
            float _e6 = value_noise(p_4, seed_6);
            return _e6;
        }
    }
}

float fractal_noise(
    uint kind_1,
    metal::float3 p_5,
    int octaves,
    float roughness,
    int seed_7,
    float w_1
) {
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_3 = 0;
    float octave = {};
    float mean = (kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5;
    float _e11 = bounded(roughness);
    float gain = metal::clamp(_e11, 0.0, 1.0);
    uint2 loop_bound_3 = uint2(4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (metal::all(loop_bound_3 == uint2(0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e75 = i_3;
            i_3 = as_type<int>(as_type<uint>(_e75) + as_type<uint>(1));
        }
        loop_init_3 = false;
        int _e25 = i_3;
        if (_e25 < metal::clamp(octaves, 1, 8)) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            float _e34 = eased(w_1 * _e30, 0.5, 1.0);
            float visible = 1.0 - _e34;
            octave = mean;
            if (visible > 0.0) {
                float _e40 = frequency;
                int _e42 = i_3;
                metal::float3 place = metal::clamp((p_5 * _e40) + (static_cast<float>(_e42) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
                int _e56 = i_3;
                float _e59 = noise_octave(kind_1, place, as_type<uint>(seed_7) + static_cast<uint>(_e56));
                octave = metal::mix(mean, _e59, visible);
            }
            float _e61 = sum_3;
            float _e62 = strength;
            float _e63 = octave;
            sum_3 = _e61 + (_e62 * _e63);
            float _e66 = total;
            float _e67 = strength;
            total = _e66 + _e67;
            float _e69 = strength;
            strength = _e69 * gain;
            float _e71 = frequency;
            frequency = _e71 * 2.0;
        }
    }
    float _e77 = sum_3;
    float _e78 = total;
    return metal::clamp(_e77 / _e78, 0.0, 1.0);
}

float map_range(
    float value,
    float from_low_1,
    float from_high_1,
    float to_low_1,
    float to_high_1,
    bool clamped_3
) {
    float _e6 = remapped(value, from_low_1, from_high_1, to_low_1, to_high_1, clamped_3);
    return _e6;
}

float line_covers(
    float distance,
    float width
) {
    return metal::clamp((width + 0.5) - distance, 0.0, metal::min(width, 1.0));
}

float outer_contour(
    float width_1,
    metal::float3 normal_1,
    metal::float3 view_2_2,
    metal::float2 viewport
) {
    metal::float3 _e6 = normalize_or(normal_1, metal::float3(0.0));
    float facing = metal::clamp(metal::dot(_e6, view_2_2), 0.0, 1.0);
    float _e11 = bounded(width_1);
    float pixels = (metal::clamp(_e11, 0.0, 10000.0) * metal::clamp(viewport.y, 1.0, 100000.0)) / 1000.0;
    float _e22 = footprint_of(facing);
    float distance_1 = facing / metal::max(2.0 * _e22, 0.000001);
    float _e30 = eased(facing, 0.45, 0.75);
    float near = 1.0 - _e30;
    float _e33 = line_covers(distance_1, pixels);
    return _e33 * near;
}

float noise_perlin(
    metal::float3 position,
    float scale,
    int octaves_1,
    float roughness_1,
    int seed_8
) {
    metal::float3 _e6 = bounded_vec3_(position * scale);
    float _e8 = footprint_of_vec3_(_e6);
    float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_1, seed_8, _e8);
    return _e9;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    metal::float3 _e2 = position_object(surface_1.position_object);
    float _e7 = noise_perlin(_e2, 3.5, 2, 0.5, 1);
    float _e13 = map_range(_e7, 0.0, 1.0, -0.22, 0.22, true);
    float _e18 = noise_perlin(_e2, 3.5, 2, 0.5, 5);
    float _e24 = map_range(_e18, 0.0, 1.0, -0.22, 0.22, true);
    metal::float3 _e27 = look.parts_direction;
    metal::float3 _e30 = look.axes_of_the_light_x_axis;
    metal::float3 _e33 = look.axes_of_the_light_y_axis;
    metal::float3 _e34 = shift_direction(_e27, _e30, _e33, _e13, _e24);
    Light _e37 = look.key;
    Light _e38 = light_toward(_e37, _e34);
    Angle _e40 = parametrization_diffuse(_e38, surface_1.normal);
    float _e43 = profile(_e40, 0.0, lit_shape);
    Composite _e56 = blend_alpha(metal::float4(0.1529, 0.251, 0.3765, 1.0), metal::float4(0.3098, 0.5608, 0.6118, 1.0), _e43, 1.0, true);
    float _e59 = profile(_e40, 0.0, brightest_shape);
    Composite _e67 = blend_alpha(_e56, metal::float4(0.6627, 0.8392, 0.7569, 1.0), _e59, 1.0, true);
    metal::float3 _e69 = view_2_(surface_1.view);
    AxesAround _e74 = axes(_e69, metal::float3(0.0, 1.0, 0.0));
    metal::float3 _e79 = shift_direction(_e69, _e74.x_axis, _e74.y_axis, -0.32, 0.36);
    Light _e82 = look.eye;
    Light _e83 = light_toward(_e82, _e79);
    Angle _e85 = parametrization_diffuse(_e83, surface_1.normal);
    float _e88 = profile(_e85, 0.0, window_shape);
    Composite _e96 = blend_alpha(_e67, metal::float4(0.9922, 0.9647, 0.8902, 1.0), _e88, 1.0, true);
    metal::float2 _e102 = look.viewport;
    float _e103 = outer_contour(3.0, surface_1.normal, surface_1.view, _e102);
    Composite _e111 = blend_alpha(_e96, metal::float4(0.0784, 0.1294, 0.2275, 1.0), _e103, 1.0, true);
    Color _e112 = output(_e111);
    return _e112;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_2 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    out.position_object = vertex_.position;
    metal::float3x3 _e21 = object.world_from_normal;
    out.normal = _e21 * vertex_.normal;
    Varyings _e24 = out;
    const auto _tmp = _e24;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object_2 [[user(loc1), center_perspective]];
    metal::float3 normal_2 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object_2, varyings_1.normal_2 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_2 = is_front ? _e7 : -(_e7);
    surface.normal = normal_2;
    metal::float4 _e15 = view.eye;
    float _e20 = view.eye.w;
    metal::float4 _e26 = view.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    surface.position_object = in.position_object;
    Surface _e36 = surface;
    metal::float4 _e37 = shade(_e36, look);
    metal::float4 _e38 = finite_vec4_(_e37);
    return fs_mainOutput { _e38 };
}
