// Half-tone comic: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_2 buffer(0), object buffer(1), look buffer(2).
// halftone-comic.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    metal::float4 eye;
    metal::float4 screen;
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
    metal::float2 viewport;
    char _pad2[8];
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float2 pixel;
    char _pad3[8];
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
    metal::float3 normal;
};
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape not_in_deep_shade_shape = ProfileShape {0.65243745, 0.75784254, 0.0, 1.0, 1.72, 0.0, 0.0, 1u};
constant ProfileShape highlight_shape = ProfileShape {0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0, 0.0, 1u};

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
    float p_1 = 1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127)))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two(as_type<int>(as_type<uint>(naga_f2i32(whole)) - as_type<uint>(half_whole)));
    return (p_1 * _e33) * _e37;
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

metal::float2 sin_cos(
    float x_5
) {
    float turns = metal::rint(x_5 * 0.31830987);
    float r_1 = ((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 0.00000062783295);
    float sign = 1.0 - (2.0 * metal::abs(turns - (2.0 * metal::trunc(turns * 0.5))));
    metal::float2 _e27 = sin_cos_quarter(metal::clamp(r_1, -1.5707964, HALF_PI));
    return sign * _e27;
}

Angle angle_between(
    metal::float3 d,
    metal::float3 l
) {
    float p_2 = metal::length(d - l);
    float s_1 = metal::length(d + l);
    float k = 1.0 / metal::sqrt(metal::max((p_2 * p_2) + (s_1 * s_1), 0.000000000000000000000000000001));
    return Angle {p_2 * k, s_1 * k};
}

float atan2_positive(
    float y_1,
    float x_6
) {
    float small = metal::min(y_1, x_6);
    float large = metal::max(y_1, x_6);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_4 = small / large;
    bool is_wide = t_4 > 0.41421357;
    float r_2 = is_wide ? ((small - large) / (small + large)) : t_4;
    float r2_ = r_2 * r_2;
    float series_1 = r_2 * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_8 = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_1 > x_6) ? (HALF_PI - a_8) : a_8;
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
    float x_7
) {
    uint bits_1 = as_type<uint>(x_7);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_7 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float2 bounded_vec2_(
    metal::float2 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return metal::float2(_e2, _e4);
}

metal::float3 bounded_vec3_(
    metal::float3 v_4
) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float4 bounded_vec4_(
    metal::float4 v_5
) {
    float _e2 = bounded(v_5.x);
    float _e4 = bounded(v_5.y);
    float _e6 = bounded(v_5.z);
    float _e8 = bounded(v_5.w);
    return metal::float4(_e2, _e4, _e6, _e8);
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

metal::float3 mixed_vec3_(
    metal::float3 a_1,
    metal::float3 b_1,
    float t_2
) {
    float _e5 = mixed(a_1.x, b_1.x, t_2);
    float _e8 = mixed(a_1.y, b_1.y, t_2);
    float _e11 = mixed(a_1.z, b_1.z, t_2);
    return metal::float3(_e5, _e8, _e11);
}

metal::float4 mixed_vec4_(
    metal::float4 a_2,
    metal::float4 b_2,
    float t_3
) {
    metal::float3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_3);
    float _e8 = mixed(a_2.w, b_2.w, t_3);
    return metal::float4(_e5, _e8);
}

float place_between(
    float x_8,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_8 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_8 - low) / _e12);
    return _e14;
}

float remapped(
    float x_9,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    float _e6 = bounded(x_9);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, clamped ? metal::clamp(_e9, 0.0, 1.0) : _e9);
    return _e16;
}

float eased(
    float x_10,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_10);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = metal::clamp(_e6, 0.0, 1.0);
    return (t_5 * t_5) * (3.0 - (2.0 * t_5));
}

float factor_of(
    float x_11,
    bool clamped_1
) {
    float _e2 = bounded(x_11);
    float _e3 = bounded(x_11);
    return clamped_1 ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

metal::float2 sin_cos_of(
    float x_12
) {
    float _e1 = bounded(x_12);
    metal::float2 _e2 = sin_cos(_e1);
    return metal::clamp(_e2, metal::float2(-1.0), metal::float2(1.0));
}

metal::float2 footprint_of_vec2_(
    metal::float2 v_6
) {
    metal::float2 dx_1 = metal::dfdx(v_6);
    metal::float2 dy_1 = metal::dfdy(v_6);
    metal::float2 _e7 = bounded_vec2_(metal::sqrt((dx_1 * dx_1) + (dy_1 * dy_1)));
    return _e7;
}

metal::float4 color_mixed(
    metal::float4 a_3,
    metal::float3 blended,
    float factor
) {
    metal::float3 _e4 = bounded_vec3_(a_3.xyz);
    metal::float3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    metal::float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_3.w);
    return metal::float4(_e8, _e10);
}

Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

Color mix_colors_normal(
    Color a_4,
    Color b_3,
    float factor_1
) {
    metal::float4 _e3 = bounded_vec4_(a_4);
    metal::float4 _e4 = bounded_vec4_(b_3);
    float _e6 = factor_of(factor_1, true);
    metal::float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

Color mix_colors_multiply(
    Color a_5,
    Color b_4,
    float factor_2
) {
    metal::float4 _e6 = color_mixed(a_5, a_5.xyz * b_4.xyz, factor_2);
    return _e6;
}

float facing(
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 _e4 = normalize_or(normal, metal::float3(0.0));
    return metal::clamp(metal::dot(_e4, view), 0.0, 1.0);
}

Color output(
    Composite color_1
) {
    Color _e1 = straight(color_1);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(
    Light light,
    metal::float3 normal_1
) {
    metal::float3 _e6 = normalize_or(normal_1, metal::float3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light.direction);
    return _e8;
}

Angle parametrization_specular(
    Light light_1,
    metal::float3 normal_2,
    metal::float3 view_1
) {
    metal::float3 _e7 = normalize_or(normal_2, metal::float3(0.0, 0.0, 1.0));
    metal::float3 mirrored = ((2.0 * metal::dot(_e7, view_1)) * _e7) - view_1;
    metal::float3 _e13 = normalize_or(mirrored, _e7);
    Angle _e15 = angle_between(_e13, light_1.direction);
    return _e15;
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
        float width = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
        float _e36 = angle_radians(u_5);
        return metal::clamp(0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width), 0.0, 1.0);
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

metal::float2 turned_by(
    metal::float2 p,
    float angle_1
) {
    metal::float2 _e2 = sin_cos_of(angle_1);
    return metal::float2((_e2.y * p.x) - (_e2.x * p.y), (_e2.x * p.x) + (_e2.y * p.y));
}

metal::float2 screen_cells(
    metal::float2 place,
    metal::float2 viewport,
    float lines,
    float angle_2
) {
    metal::float2 most = metal::float2(4194304.0);
    metal::float2 _e6 = bounded_vec2_(place);
    float _e7 = bounded(lines);
    metal::float2 _e15 = bounded_vec2_(_e6 * (metal::max(_e7, 0.0) / metal::max(viewport.y, 1.0)));
    metal::float2 _e18 = turned_by(metal::clamp(_e15, -(most), most), angle_2);
    return metal::clamp(_e18, -(most), most);
}

float dot_radius(
    float share
) {
    float a_6 = {};
    int i = 0;
    float t_6 = metal::clamp(share, 0.0, 1.0);
    if (t_6 <= 0.7853982) {
        return metal::sqrt(t_6 * 0.31830987);
    }
    float s_4 = metal::min((t_6 - 0.7853982) / (1.0 - 0.7853982), 1.0);
    a_6 = metal::mix(0.5227232 * metal::sqrt(s_4), 0.7853982 - (0.3275682 * metal::sqrt(1.0 - s_4)), s_4);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e63 = i;
            i = as_type<int>(as_type<uint>(_e63) + as_type<uint>(1));
        }
        loop_init = false;
        int _e28 = i;
        if (_e28 < 2) {
        } else {
            break;
        }
        {
            float _e31 = a_6;
            metal::float2 _e34 = sin_cos_quarter(metal::clamp(_e31, 0.0, 0.7853982));
            float tangent = _e34.x / _e34.y;
            float square_1 = 1.0 / (_e34.y * _e34.y);
            float _e44 = a_6;
            float sector = 0.7853982 - _e44;
            float slope = ((2.0 * sector) * square_1) * tangent;
            float _e50 = a_6;
            a_6 = metal::clamp(_e50 - ((slope > 0.001) ? ((((sector * square_1) + tangent) - t_6) / slope) : 0.0), 0.0, 0.7853982);
        }
    }
    float _e65 = a_6;
    metal::float2 _e66 = sin_cos_quarter(_e65);
    return 0.5 / _e66.y;
}

float disk_filtered(
    float d_1,
    float r,
    float w_1
) {
    bool local_5 = {};
    if (w_1 < 0.000000000000000000000000000001) {
        if (d_1 <= r) {
            local_5 = r > 0.0;
        } else {
            local_5 = false;
        }
        bool _e11 = local_5;
        return _e11 ? 1.0 : 0.0;
    }
    float square_2 = r * r;
    float least = (w_1 * w_1) / 3.0;
    float inner = metal::sqrt(metal::max(square_2, least) - (0.25 * least));
    return metal::clamp(0.5 + ((inner - d_1) / w_1), 0.0, 1.0) * metal::min(square_2 / least, 1.0);
}

float ink_of_dots(
    metal::float2 cell,
    float share_1,
    float w_2
) {
    float ink = {};
    bool local_6 = {};
    float width_1 = metal::min(w_2, 1.0);
    float _e8 = dot_radius(share_1);
    float _e9 = disk_filtered(metal::length(cell - metal::rint(cell)), _e8, width_1);
    ink = _e9;
    float hole = metal::sqrt(metal::max(1.0 - share_1, 0.0) * 0.31830987);
    float _e22 = eased(width_1, 0.3 * hole, 0.9 * hole);
    float _e25 = eased(share_1, 0.5, 0.7);
    float is_star = _e22 * _e25;
    if (is_star > 0.0) {
        float _e29 = ink;
        float _e36 = disk_filtered(metal::length((cell - metal::floor(cell)) - metal::float2(0.5)), hole, width_1);
        ink = metal::mix(_e29, 1.0 - _e36, is_star);
    }
    float _e40 = ink;
    float _e43 = eased(w_2, 0.4, 1.0);
    float mean = metal::mix(_e40, share_1, _e43);
    if (!((share_1 <= 0.0))) {
        local_6 = share_1 >= 1.0;
    } else {
        local_6 = true;
    }
    bool _e53 = local_6;
    return _e53 ? share_1 : mean;
}

float reflectance_wrap(
    Light light_2,
    metal::float3 normal_3,
    float wrap
) {
    float _e3 = bounded(wrap);
    float w_4 = metal::clamp(_e3, 0.0, 1.0);
    metal::float3 _e11 = normalize_or(normal_3, metal::float3(0.0, 0.0, 1.0));
    float cosine = metal::dot(_e11, light_2.direction);
    return metal::max((cosine + w_4) / (1.0 + w_4), 0.0);
}

float invert(
    float value
) {
    float _e3 = bounded(1.0 - value);
    return _e3;
}

float map_range(
    float value_1,
    float from_low_1,
    float from_high_1,
    float to_low_1,
    float to_high_1,
    bool clamped_2
) {
    float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(
    float a_7,
    float b_5
) {
    float _e3 = bounded(a_7 * b_5);
    return _e3;
}

float smooth_step_value(
    float value_2,
    float low_2,
    float high_2
) {
    float _e3 = eased(value_2, low_2, high_2);
    return _e3;
}

float halftone_dots(
    float value_3,
    metal::float2 place_1,
    float lines_1,
    float angle_3,
    metal::float2 viewport_1
) {
    metal::float2 _e5 = screen_cells(place_1, viewport_1, lines_1, angle_3);
    metal::float2 _e6 = footprint_of_vec2_(_e5);
    float _e8 = factor_of(value_3, true);
    float _e14 = ink_of_dots(_e5, 1.0 - _e8, metal::max(_e6.x, _e6.y));
    return 1.0 - _e14;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.25);
    float _e12 = map_range(_e6, 0.1, 0.75, 0.15, 1.0, true);
    metal::float2 _e18 = look.viewport;
    float _e19 = halftone_dots(_e12, surface_1.pixel, 78.0, 0.2617994, _e18);
    Color _e30 = mix_colors_normal(metal::float4(0.91, 0.3, 0.24, 1.0), metal::float4(1.0, 0.87, 0.58, 1.0), _e19);
    Light _e33 = look.key;
    Angle _e35 = parametrization_diffuse(_e33, surface_1.normal);
    float _e38 = profile(_e35, 0.0, not_in_deep_shade_shape);
    float _e39 = invert(_e38);
    float _e41 = multiply(_e39, 0.62);
    float _e42 = invert(_e41);
    metal::float2 _e48 = look.viewport;
    float _e49 = halftone_dots(_e42, surface_1.pixel, 78.0, 1.3089969, _e48);
    float _e50 = invert(_e49);
    Color _e56 = mix_colors_multiply(_e30, metal::float4(0.24, 0.3, 0.58, 1.0), _e50);
    Light _e59 = look.key;
    Angle _e62 = parametrization_specular(_e59, surface_1.normal, surface_1.view);
    float _e65 = profile(_e62, 0.0, highlight_shape);
    Color _e71 = mix_colors_normal(_e56, metal::float4(1.0, 0.99, 0.95, 1.0), _e65);
    float _e74 = facing(surface_1.normal, surface_1.view);
    float _e77 = smooth_step_value(_e74, 0.3, 0.22);
    Color _e83 = mix_colors_normal(_e71, metal::float4(0.09, 0.07, 0.13, 1.0), _e77);
    Composite _e84 = premultiplied(_e83);
    Color _e85 = output(_e84);
    return _e85;
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
    metal::float4 _e39 = view_2.screen;
    metal::float4 _e44 = view_2.screen;
    surface.pixel = (in.clip.xy * _e39.xy) + _e44.zw;
    Surface _e47 = surface;
    metal::float4 _e48 = shade(_e47, look);
    metal::float4 _e49 = finite_vec4_(_e48);
    return fs_mainOutput { _e49 };
}
