// Profile curves: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1).
// figure3-curves.json says what to put there and how to draw.
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
struct Surface {
    metal::float2 uv;
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
struct VectorParts {
    float x;
    float y;
    float z;
};
struct Vertex {
    metal::float3 position;
    metal::float2 uv;
    char _pad2[8];
};
struct Varyings {
    metal::float4 clip;
    metal::float2 uv;
    char _pad2[8];
};
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape lambert_shape = ProfileShape {1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u};
constant ProfileShape half_lambert_shape = ProfileShape {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u};
constant ProfileShape custom_shape = ProfileShape {0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928, 0.2351043, 0u};

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
    float s_1 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_1, c_1);
    if (s_1 <= 0.0) {
        local_1 = s_1 < c_1;
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

float footprint_of(
    float x_9
) {
    float _e1 = metal::dfdx(x_9);
    float _e2 = metal::dfdy(x_9);
    metal::float2 d = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
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
    float x_10,
    float edge,
    float w_1
) {
    float _e4 = bounded(x_10 - edge);
    if (w_1 < 0.000000000000000000000000000001) {
        return (_e4 >= 0.0) ? 1.0 : 0.0;
    }
    float _e13 = bounded(_e4 / w_1);
    return metal::clamp(0.5 + _e13, 0.0, 1.0);
}

float unit_share(
    float share
) {
    return metal::clamp(share, 0.0, 1.0);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

metal::float2 uv(
    metal::float2 uv_1
) {
    return uv_1;
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
    float s_2 = (u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset);
    if (!((s_2 <= 0.0))) {
        local_2 = shape.kind == PROFILE_AMBIENT;
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
    if (_e18) {
        return 1.0;
    }
    if (shape.kind == PROFILE_STEP) {
        return (s_2 <= 0.0000004) ? 1.0 : 0.0;
    }
    float q_1 = s_2 * shape.scale;
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(
    Angle u_5,
    float w_2,
    ProfileShape shape_1
) {
    bool local_3 = {};
    bool local_4 = {};
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_3 = shape_1.kind == PROFILE_AMBIENT;
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if (shape_1.edge_deviation < 0.145) {
        local_4 = w_2 >= (3.4641016 * shape_1.edge_deviation);
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width = metal::sqrt((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
        float _e36 = angle_radians(u_5);
        return metal::clamp(0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width), 0.0, 1.0);
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

float map_range(
    float value_1,
    float from_low_1,
    float from_high_1,
    float to_low_1,
    float to_high_1,
    bool clamped_3
) {
    float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_3);
    return _e6;
}

float subtract(
    float a_1,
    float b_1
) {
    float _e3 = bounded(a_1 - b_1);
    return _e3;
}

VectorParts separate_vector(
    metal::float3 vector
) {
    return VectorParts {vector.x, vector.y, vector.z};
}

metal::float4 shade(
    Surface surface_1
) {
    metal::float2 _e2 = uv(surface_1.uv);
    VectorParts _e5 = separate_vector(metal::float3(_e2, 0.0));
    float _e12 = map_range(_e5.y, 0.14, 0.86, 0.0, 1.0, false);
    float _e15 = threshold(_e12, -0.006, 0.0);
    float _e18 = threshold(_e12, 0.006, 0.0);
    float _e19 = subtract(_e15, _e18);
    float _e20 = unit_share(_e19);
    Composite _e33 = blend_alpha(metal::float4(0.98, 0.965, 0.925, 1.0), metal::float4(0.24, 0.26, 0.3, 1.0), _e20, 1.0, true);
    float _e40 = map_range(_e5.x, 0.08, 0.92, 0.0, 3.1415927, false);
    float _e43 = threshold(_e40, -0.012, 0.0);
    float _e46 = threshold(_e40, 0.012, 0.0);
    float _e47 = subtract(_e43, _e46);
    float _e48 = unit_share(_e47);
    Composite _e56 = blend_alpha(_e33, metal::float4(0.24, 0.26, 0.3, 1.0), _e48, 1.0, true);
    float _e59 = threshold(_e40, 0.492, 0.0);
    float _e62 = threshold(_e40, 0.508, 0.0);
    float _e63 = subtract(_e59, _e62);
    float _e64 = unit_share(_e63);
    Composite _e72 = blend_alpha(_e56, metal::float4(0.2, 0.38, 0.78, 1.0), _e64, 0.55, true);
    float _e75 = threshold(_e40, 0.942, 0.0);
    float _e78 = threshold(_e40, 0.958, 0.0);
    float _e79 = subtract(_e75, _e78);
    float _e80 = unit_share(_e79);
    Composite _e88 = blend_alpha(_e72, metal::float4(0.2, 0.38, 0.78, 1.0), _e80, 0.55, true);
    float _e91 = threshold(_e40, 1.792, 0.0);
    float _e94 = threshold(_e40, 1.808, 0.0);
    float _e95 = subtract(_e91, _e94);
    float _e96 = unit_share(_e95);
    Composite _e104 = blend_alpha(_e88, metal::float4(0.2, 0.38, 0.78, 1.0), _e96, 0.55, true);
    Angle _e105 = angle_of(_e40);
    float _e108 = profile(_e105, 0.0, lambert_shape);
    float _e109 = subtract(_e12, _e108);
    float _e112 = threshold(_e109, -0.012, 0.0);
    float _e115 = threshold(_e109, 0.012, 0.0);
    float _e116 = subtract(_e112, _e115);
    float _e117 = unit_share(_e116);
    Composite _e125 = blend_alpha(_e104, metal::float4(0.8, 0.2, 0.17, 1.0), _e117, 1.0, true);
    Angle _e126 = angle_of(_e40);
    float _e129 = profile(_e126, 0.0, half_lambert_shape);
    float _e130 = subtract(_e12, _e129);
    float _e133 = threshold(_e130, -0.012, 0.0);
    float _e136 = threshold(_e130, 0.012, 0.0);
    float _e137 = subtract(_e133, _e136);
    float _e138 = unit_share(_e137);
    Composite _e146 = blend_alpha(_e125, metal::float4(0.18, 0.55, 0.27, 1.0), _e138, 1.0, true);
    Angle _e147 = angle_of(_e40);
    float _e150 = profile(_e147, 0.0, custom_shape);
    float _e151 = subtract(_e12, _e150);
    float _e154 = threshold(_e151, -0.012, 0.0);
    float _e157 = threshold(_e151, 0.012, 0.0);
    float _e158 = subtract(_e154, _e157);
    float _e159 = unit_share(_e158);
    Composite _e167 = blend_alpha(_e146, metal::float4(0.5, 0.31, 0.14, 1.0), _e159, 1.0, true);
    Color _e168 = output(_e167);
    return _e168;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float2 uv_2 [[attribute(3)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float2 uv [[user(loc0), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.uv_2 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view.clip_from_world;
    out.clip = _e12 * world;
    out.uv = vertex_.uv;
    Varyings _e16 = out;
    const auto _tmp = _e16;
    return vs_mainOutput { _tmp.clip, _tmp.uv };
}


struct fs_mainInput {
    metal::float2 uv_2 [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
) {
    const Varyings in = { clip, varyings_1.uv_2 };
    Surface surface = {};
    surface.uv = in.uv;
    Surface _e4 = surface;
    metal::float4 _e5 = shade(_e4);
    metal::float4 _e6 = finite_vec4_(_e5);
    return fs_mainOutput { _e6 };
}
