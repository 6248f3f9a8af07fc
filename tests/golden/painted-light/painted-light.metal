// Painted light: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// painted-light.json says what to put there and how to draw.
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
    Light lamp;
    Light window;
};
struct Surface {
    metal::float3 normal;
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
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;
constant ProfileShape body_tone_shape = ProfileShape {0.60240144, 0.7981933, 21.601328, 1.0, 1.84858, 0.06173407, 0.021818977, 0u};
constant ProfileShape light_tone_shape = ProfileShape {0.9976349, 0.06873576, 2.5909312, 1.0, 0.13758, 0.5226457, 0.18761672, 0u};
constant ProfileShape behind_tone_shape = ProfileShape {0.9921977, 0.12467473, 2.425296, 1.7791567, 0.25, 0.46467006, 0.1911372, 0u};

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
    float clamped_2 = metal::clamp(x_2, -150.0, 127.99999);
    float whole = metal::rint(clamped_2);
    float f = (clamped_2 - whole) * LN_2_;
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
    float t_1 = small / large;
    bool is_wide = t_1 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_1;
    float r2_ = r * r;
    float series_1 = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series_1 + 0.7853982) : series_1;
    return (y_1 > x_5) ? (HALF_PI - a) : a;
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
    float w_1 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    float _e13 = finite_or(w_1, 0.5);
    return metal::min(_e13, 0.5);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

Composite blend_finish(
    Composite below,
    metal::float3 blended,
    float alpha,
    float opacity,
    bool clamped
) {
    if (opacity <= 0.0) {
        return below;
    }
    metal::float4 mixed = metal::float4(below.xyz + (opacity * (blended - below.xyz)), alpha);
    return clamped ? metal::clamp(mixed, metal::float4(0.0), metal::float4(1.0)) : mixed;
}

Composite blend_add(
    Composite below_1,
    Color color,
    float tone,
    float opacity_1,
    bool clamped_1
) {
    Composite _e12 = blend_finish(below_1, below_1.xyz + (tone * color.xyz), below_1.w, opacity_1 * color.w, clamped_1);
    return _e12;
}

Color output(
    Composite color_1
) {
    Color _e1 = straight(color_1);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

metal::float2 light_split(
    float intensity
) {
    return metal::float2(metal::min(intensity, 1.0), metal::max(intensity, 1.0));
}

LitLayer light_apply(
    Light light,
    Color color_2,
    float tone_1
) {
    metal::float2 _e4 = light_split(light.intensity);
    return LitLayer {metal::float4((color_2.xyz * light.color) * _e4.y, color_2.w), tone_1 * _e4.x};
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

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.window;
    Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    float _e8 = profile(_e5, 0.0, body_tone_shape);
    Light _e11 = look.window;
    LitLayer _e17 = light_apply(_e11, metal::float4(0.18708, 0.62392, 0.48886, 1.0), _e8);
    Composite _e27 = blend_add(metal::float4(0.14678, 0.1201, 0.28662, 1.0), _e17.color, _e17.tone, 1.0, true);
    Light _e30 = look.lamp;
    Angle _e32 = parametrization_diffuse(_e30, surface_1.normal);
    float _e35 = profile(_e32, 0.0, light_tone_shape);
    Light _e38 = look.lamp;
    LitLayer _e44 = light_apply(_e38, metal::float4(0.81701, 0.67278, 0.30725, 1.0), _e35);
    Composite _e49 = blend_add(_e27, _e44.color, _e44.tone, 1.0, true);
    Light _e52 = look.back;
    Angle _e54 = parametrization_diffuse(_e52, surface_1.normal);
    float _e57 = profile(_e54, 0.0, behind_tone_shape);
    Light _e60 = look.back;
    LitLayer _e66 = light_apply(_e60, metal::float4(0.08, 0.09, 0.1, 1.0), _e57);
    Composite _e71 = blend_add(_e49, _e66.color, _e66.tone, 1.0, true);
    Color _e72 = output(_e71);
    return _e72;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
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


struct fs_mainInput {
    metal::float3 normal_1 [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.normal_1 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_1 = is_front ? _e7 : -(_e7);
    surface.normal = normal_1;
    Surface _e12 = surface;
    metal::float4 _e13 = shade(_e12, look);
    metal::float4 _e14 = finite_vec4_(_e13);
    return fs_mainOutput { _e14 };
}
