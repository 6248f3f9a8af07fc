// Chalk: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// chalk-board.json says what to put there and how to draw.
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
    Light back;
    metal::float2 viewport;
    char _pad2[8];
    Light key;
};
struct Surface {
    metal::packed_float3 normal;
    float kappa;
    metal::float2 pixel;
    char _pad3[8];
    metal::float3 anchor;
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
struct StretchedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct SpacedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct MarkPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct PaperGrain {
    float tone;
    float height;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 normal;
};
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape orange_chalk_shape = ProfileShape {0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5, 0.43399706, 0.1847509, 0u};

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
    float square_1 = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square_1));
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
    float r = ((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 0.00000062783295);
    float sign = 1.0 - (2.0 * metal::abs(turns - (2.0 * metal::trunc(turns * 0.5))));
    metal::float2 _e27 = sin_cos_quarter(metal::clamp(r, -1.5707964, HALF_PI));
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
    float t_5 = small / large;
    bool is_wide = t_5 > 0.41421357;
    float r_1 = is_wide ? ((small - large) / (small + large)) : t_5;
    float r2_ = r_1 * r_1;
    float series_1 = r_1 * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_5 = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_1 > x_6) ? (HALF_PI - a_5) : a_5;
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
    float t_6 = metal::clamp(_e6, 0.0, 1.0);
    return (t_6 * t_6) * (3.0 - (2.0 * t_6));
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
    Color a_3,
    Color b_3,
    float factor
) {
    metal::float4 _e3 = bounded_vec4_(a_3);
    metal::float4 _e4 = bounded_vec4_(b_3);
    float _e6 = factor_of(factor, true);
    metal::float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float kappa_safe(
    float kappa
) {
    bool is_nan = (as_type<uint>(kappa) & 2147483647u) > 2139095040u;
    return is_nan ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0);
}

float curvature_signed(
    float kappa_1,
    float slope
) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_6 = _e2 * metal::clamp(_e4, -1000000000000000000000000000000.0, 1000000000000000000000000000000.0);
    float magnitude_1 = metal::min(metal::abs(a_6), 50.0);
    if (magnitude_1 < 0.0625) {
        float a2_ = a_6 * a_6;
        return a_6 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e28 = exp2_stable(-2.88539 * magnitude_1);
    float t_7 = (1.0 - _e28) / (1.0 + _e28);
    return (a_6 >= 0.0) ? t_7 : -(t_7);
}

float transition(
    float kappa_2,
    float slope_1
) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return 0.5 + (0.5 * _e2);
}

float kappa_surface(
    float kappa_3
) {
    float _e1 = kappa_safe(kappa_3);
    return _e1;
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
    metal::float3 normal
) {
    metal::float3 _e6 = normalize_or(normal, metal::float3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light.direction);
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

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_6 = {};
    v_6 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = _e8 + (_e10 * _e12);
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = _e16 + (_e18 * _e20);
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_6;
    metal::uint3 _e32 = v_6;
    v_6 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = _e38 + (_e40 * _e42);
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = _e46 + (_e48 * _e50);
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_6;
    return _e61;
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
    metal::uint3 hash,
    metal::float3 d_1
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a_7 = (axis == 0u) ? d_1.y : d_1.x;
    float b_5 = (axis == 2u) ? d_1.y : d_1.z;
    return (((hash.y >> 31u) == 0u) ? a_7 : -(a_7)) + (((hash.z >> 31u) == 0u) ? b_5 : -(b_5));
}

metal::float3 fade_quintic(
    metal::float3 t_4
) {
    return ((t_4 * t_4) * t_4) * ((t_4 * ((t_4 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(
    metal::float3 p,
    uint seed_2
) {
    float sum = 0.0;
    int i = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_2 = p - corner;
    metal::float3 _e4 = fade_quintic(d_2);
    metal::int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e46 = i;
            i = as_type<int>(as_type<uint>(_e46) + as_type<uint>(1));
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
            metal::int3 at_1 = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at_1 == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_1) + as_type<metal::uint3>(at_1)), seed_2);
            float _e42 = gradient_dot(_e39, d_2 - static_cast<metal::float3>(at_1));
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e42);
        }
    }
    float _e48 = sum;
    return metal::clamp(0.5 + (0.48244 * _e48), 0.0, 1.0);
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    float _e10 = bounded((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective));
    return _e10;
}

metal::float3 anchor_on_screen(
    metal::float3 origin,
    float perspective_1,
    float scale_1
) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    metal::float3 _e12 = bounded_vec3_(metal::float3(origin.x * _e5, -(origin.y) * _e5, _e5));
    return _e12;
}

metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 _e2 = bounded_vec2_(pixel);
    metal::float2 from_middle = _e2 - (0.5 * viewport);
    return metal::float2(from_middle.x, -(from_middle.y)) / metal::float2(metal::max(viewport.y, 1.0));
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle_1
) {
    metal::float2 _e4 = sin_cos_of(angle_1);
    metal::float3 _e10 = bounded_vec3_((_e4.y * along) + (_e4.x * across));
    metal::float3 _e16 = bounded_vec3_((_e4.y * across) - (_e4.x * along));
    metal::float2 _e17 = bounded_vec2_(place);
    metal::float2 turned_1 = metal::float2((_e4.y * _e17.x) + (_e4.x * _e17.y), (_e4.y * _e17.y) - (_e4.x * _e17.x));
    metal::float3 most = metal::float3(1000000000000000.0);
    metal::float3 stretch_3 = metal::clamp(metal::float3(metal::dot(_e10, _e10), metal::dot(_e10, _e16), metal::dot(_e16, _e16)), -(most), most);
    metal::float2 _e41 = bounded_vec2_(turned_1);
    return StretchedPlace {_e41, {}, stretch_3};
}

SpacedPlace spaced(
    metal::float2 place_1,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count
) {
    float _e4 = bounded(count);
    float number = metal::clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = is_pixel ? (number / metal::max(viewport_1.y, 1.0)) : number;
    metal::float2 _e19 = bounded_vec2_(place_1);
    metal::float2 _e21 = bounded_vec2_(_e19 * scale_2);
    metal::float2 p_3 = metal::clamp(_e21, metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float3 _e27 = bounded_vec3_(stretch);
    metal::float3 s_4 = metal::clamp(_e27, metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
    return SpacedPlace {p_3, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : s_4};
}

float area_square(
    metal::float3 stretch_1
) {
    float sum_1 = stretch_1.x + stretch_1.z;
    return metal::max((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y), (sum_1 * sum_1) / 66.0);
}

float octave_of(
    float square
) {
    float _e5 = log_stable(metal::clamp(square, 0.000000000000000000000000000001, 1000000000000000000000000000000.0));
    return metal::clamp(-0.7213475 * _e5, -16.0, 16.0);
}

MarkPlace mark_place_object(
    float angle_2,
    metal::float3 anchor,
    metal::float2 pixel_1,
    metal::float2 viewport_2
) {
    float _e5 = bounded(anchor.z);
    float size = metal::clamp(_e5, 0.000001, 1000000.0);
    metal::float2 _e9 = place_in_picture(pixel_1, viewport_2);
    metal::float2 _e15 = bounded_vec2_(_e9 - metal::float2(anchor.x, -(anchor.y)));
    metal::float2 place_4 = _e15 / metal::float2(size);
    StretchedPlace _e28 = mark_place_of(place_4, metal::float3(1.0 / size, 0.0, 0.0), metal::float3(0.0, 1.0 / size, 0.0), angle_2);
    return MarkPlace {_e28.place, {}, _e28.stretch};
}

float caught_ink(
    float ink,
    float height,
    float tooth
) {
    float _e3 = bounded(ink);
    float amount = metal::clamp(_e3, 0.0, 1.0);
    float _e7 = bounded(tooth);
    float rough = metal::clamp(_e7, 0.0, 1.0);
    return metal::clamp(amount + ((((8.0 * rough) * (height - 0.5)) * amount) * (1.0 - amount)), 0.0, 1.0);
}

float paper_octave(
    metal::float2 place_2,
    int zoom,
    float w_1,
    float fiber,
    uint seed_3
) {
    float _e5 = power_of_two(zoom);
    metal::float2 p_4 = metal::clamp(place_2 * _e5, metal::float2(-4194304.0), metal::float2(4194304.0));
    uint own = seed_3 + (7u * as_type<uint>(zoom));
    float _e18 = perlin_noise(metal::float3(p_4, 0.5), own);
    float grain = _e18 - 0.5;
    metal::float2 q_2 = metal::clamp(2.7 * metal::float2((0.8 * p_4.x) - (0.6 * p_4.y), (0.6 * p_4.x) + (0.8 * p_4.y)), metal::float2(-4194304.0), metal::float2(4194304.0));
    float _e47 = perlin_noise(metal::float3(q_2, 0.5), own + 1u);
    float felt = _e47 - 0.5;
    float _e53 = eased(w_1 * _e5, 0.5, 1.0);
    float coarse_seen = 1.0 - _e53;
    float _e61 = eased((2.7 * w_1) * _e5, 0.5, 1.0);
    float felt_seen = 1.0 - _e61;
    return metal::clamp(0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt))), 0.0, 1.0);
}

float paper_height(
    SpacedPlace at,
    float fiber_1,
    uint seed_4
) {
    float height_1 = {};
    metal::float2 x_13 = metal::dfdx(at.place);
    metal::float2 y_2 = metal::dfdy(at.place);
    float _e11 = bounded(metal::sqrt(metal::max(metal::dot(x_13, x_13), metal::dot(y_2, y_2))));
    float _e13 = area_square(at.stretch);
    float _e15 = octave_of(metal::sqrt(_e13));
    float zoom_1 = metal::floor(_e15);
    float f_1 = _e15 - zoom_1;
    float _e18 = bounded(fiber_1);
    float fine = metal::clamp(_e18, 0.0, 1.0);
    float _e24 = paper_octave(at.place, naga_f2i32(zoom_1), _e11, fine, seed_4);
    height_1 = _e24;
    if (f_1 > 0.0) {
        float _e28 = height_1;
        float _e33 = paper_octave(at.place, as_type<int>(as_type<uint>(naga_f2i32(zoom_1)) + as_type<uint>(1)), _e11, fine, seed_4);
        float both = metal::mix(_e28, _e33, f_1);
        height_1 = metal::clamp(0.5 + ((both - 0.5) / metal::sqrt((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))), 0.0, 1.0);
    }
    float _e51 = height_1;
    return _e51;
}

PaperGrain paper_grain(
    float value,
    metal::float2 place_3,
    metal::float3 stretch_2,
    float count_1,
    float tooth_1,
    float fiber_2,
    int seed_5,
    metal::float2 viewport_3
) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    float _e10 = paper_height(_e8, fiber_2, as_type<uint>(seed_5));
    float _e12 = factor_of(value, true);
    float _e15 = caught_ink(1.0 - _e12, _e10, tooth_1);
    return PaperGrain {1.0 - _e15, _e10};
}

float reflectance_wrap(
    Light light_1,
    metal::float3 normal_1,
    float wrap
) {
    float _e3 = bounded(wrap);
    float w_3 = metal::clamp(_e3, 0.0, 1.0);
    metal::float3 _e11 = normalize_or(normal_1, metal::float3(0.0, 0.0, 1.0));
    float cosine = metal::dot(_e11, light_1.direction);
    return metal::max((cosine + w_3) / (1.0 + w_3), 0.0);
}

float invert(
    float value_1
) {
    float _e3 = bounded(1.0 - value_1);
    return _e3;
}

float map_range(
    float value_2,
    float from_low_1,
    float from_high_1,
    float to_low_1,
    float to_high_1,
    bool clamped_2
) {
    float _e6 = remapped(value_2, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(
    float a_4,
    float b_4
) {
    float _e3 = bounded(a_4 * b_4);
    return _e3;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.15);
    float _e12 = map_range(_e6, 0.0, 0.9, 0.0, 1.0, true);
    float _e18 = map_range(_e12, 0.0, 0.6, 0.05, 0.5, true);
    float _e19 = invert(_e18);
    metal::float2 _e25 = look.viewport;
    MarkPlace _e26 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e25);
    metal::float2 _e35 = look.viewport;
    PaperGrain _e36 = paper_grain(_e19, _e26.place, _e26.stretch, 120.0, 0.6, 0.5, 5, _e35);
    float _e38 = invert(_e36.tone);
    Color _e49 = mix_colors_normal(metal::float4(0.1216, 0.1647, 0.1686, 1.0), metal::float4(0.4275, 0.5098, 0.5647, 1.0), _e38);
    Light _e52 = look.back;
    Angle _e54 = parametrization_diffuse(_e52, surface_1.normal);
    float _e57 = profile(_e54, 0.0, orange_chalk_shape);
    float _e58 = invert(_e57);
    metal::float2 _e67 = look.viewport;
    PaperGrain _e68 = paper_grain(_e58, _e26.place, _e26.stretch, 220.0, 0.8, 0.5, 9, _e67);
    float _e70 = invert(_e68.tone);
    Color _e76 = mix_colors_normal(_e49, metal::float4(0.9412, 0.6353, 0.3608, 1.0), _e70);
    float _e78 = kappa_surface(surface_1.kappa);
    float _e80 = transition(_e78, 0.16);
    float _e86 = map_range(_e80, 0.15, 0.5, 0.1, 1.0, true);
    float _e87 = multiply(_e12, _e86);
    float _e88 = invert(_e87);
    metal::float2 _e97 = look.viewport;
    PaperGrain _e98 = paper_grain(_e88, _e26.place, _e26.stretch, 260.0, 0.62, 0.5, 3, _e97);
    float _e100 = invert(_e98.tone);
    Color _e106 = mix_colors_normal(_e76, metal::float4(0.9686, 0.9529, 0.9098, 1.0), _e100);
    Composite _e107 = premultiplied(_e106);
    Color _e108 = output(_e107);
    return _e108;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 normal [[user(loc0), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view.clip_from_world;
    out.clip = _e12 * world;
    metal::float3x3 _e17 = object.world_from_normal;
    out.normal = _e17 * vertex_.normal;
    Varyings _e20 = out;
    const auto _tmp = _e20;
    return vs_mainOutput { _tmp.clip, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 normal_2 [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.normal_2 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_2 = is_front ? _e7 : -(_e7);
    surface.normal = normal_2;
    metal::float4 _e18 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.kappa = _e18.x;
    metal::float4 _e25 = view.screen;
    metal::float4 _e30 = view.screen;
    surface.pixel = (in.clip.xy * _e25.xy) + _e30.zw;
    metal::float4x4 _e36 = view.camera_from_world;
    metal::float4 _e40 = object.world_from_object[3];
    float _e49 = view.eye.w;
    float _e54 = view.clip_from_world[0].y;
    float _e59 = view.clip_from_world[1].y;
    float _e64 = view.clip_from_world[2].y;
    metal::float3 _e67 = anchor_on_screen((_e36 * metal::float4(_e40.xyz, 1.0)).xyz, _e49, metal::length(metal::float3(_e54, _e59, _e64)));
    surface.anchor = _e67;
    Surface _e68 = surface;
    metal::float4 _e69 = shade(_e68, look);
    metal::float4 _e70 = finite_vec4_(_e69);
    return fs_mainOutput { _e70 };
}
