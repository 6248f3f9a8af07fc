// Minimal: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// figure6-minimal.json says what to put there and how to draw.
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
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
    float kappa;
};
typedef metal::float4 Color;
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
    metal::float3 position;
    metal::float3 normal;
};
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant ProfileShape white_specular_tone_shape = ProfileShape {0.98472655, 0.17410813, 3.6826046, 2.506993, 0.35, 0.26755187, 0.1159523, 0u};

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float clamped = metal::clamp(x, -126.0, 127.99999);
    float whole = metal::rint(clamped);
    float f = clamped - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_1
) {
    float clamped_1 = metal::max(x_1, -126.0);
    float whole_1 = metal::rint(clamped_1);
    float f_1 = clamped_1 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
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

float log1p_negative_small(
    float y
) {
    float z_1 = y / (2.0 - y);
    float z2_1 = z_1 * z_1;
    return (-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111))))))));
}

metal::float2 sin_cos_eighth(
    float x_3
) {
    float y_2 = x_3 * x_3;
    float s = x_3 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 0.0000027557319))))))));
    float c = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-0.000024801588 + (y_2 * 0.0000002755732)))))))));
    return metal::float2(s, c);
}

metal::float2 sin_cos_tiny(
    float x_4
) {
    float y_3 = x_4 * x_4;
    float s_1 = x_4 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334))));
    float c_1 = 1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889)))));
    return metal::float2(s_1, c_1);
}

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen(
    metal::float3 v_1
) {
    metal::float3 _e5 = normalize_moderate(v_1, metal::float3(0.0, 0.0, 1.0));
    return _e5;
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
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y_1 > x_5) ? (HALF_PI - a) : a;
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
    float s_2 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_2 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_2 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_2);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < c_2)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float curvature_signed(
    float kappa,
    float slope
) {
    float a_1 = (((as_type<uint>(kappa) & 2147483647u) > 2139095040u) ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0)) * slope;
    float magnitude = metal::min(metal::abs(a_1), 50.0);
    if (magnitude < 0.0625) {
        float a2_ = a_1 * a_1;
        return a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e32 = exp2_stable(-2.88539 * magnitude);
    float t_2 = (1.0 - _e32) / (1.0 + _e32);
    return (a_1 >= 0.0) ? t_2 : -(t_2);
}

LitLayer light_apply(
    Light light,
    Color color,
    float tone
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4(light.color * split.y, 1.0), tone * split.x};
}

Angle parametrization_specular(
    Light light_1,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 mirrored = ((2.0 * metal::dot(normal, view)) * normal) - view;
    metal::float3 _e8 = normalize_moderate(mirrored, normal);
    return Angle {0.5 * metal::length(_e8 - light_1.direction), 0.5 * metal::length(_e8 + light_1.direction)};
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
        float _e11 = log1p_negative_small(q * q);
        log_base = LOG2_E * _e11;
    } else {
        float _e18 = log2_stable((1.0 - q) * (1.0 + q));
        log_base = _e18;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable_2_(exponent * _e19);
    return metal::min(_e21, 1.0);
}

float profile_point(
    Angle u_2,
    ProfileShape shape
) {
    float s_3 = (u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset);
    if ((s_3 <= 0.0) | false) {
        return 1.0;
    }
    float q_1 = s_3 * shape.scale;
    float _e17 = profile_power(q_1, shape.exponent);
    return _e17;
}

float profile_filtered(
    Angle u_3,
    float w,
    ProfileShape shape_1
) {
    float _e3 = profile_point(u_3, shape_1);
    bool is_wide_1 = w < (0.1 * shape_1.edge_deviation);
    if ((is_wide_1 | (w <= 0.0)) | false) {
        return _e3;
    }
    if (true & (w >= (3.4641016 * shape_1.edge_deviation))) {
        float width = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
        float _e32 = atan2_positive(u_3.half_sin, u_3.half_cos);
        return metal::clamp(0.5 + (((shape_1.offset + shape_1.edge_mean) - (2.0 * _e32)) / width), 0.0, 1.0);
    }
    metal::float2 _e44 = sin_cos_tiny(0.19364917 * w);
    Angle _e45 = angle_turned(u_3, _e44);
    float _e46 = profile_point(_e45, shape_1);
    Angle _e51 = angle_turned(u_3, metal::float2(-(_e44.x), _e44.y));
    float _e52 = profile_point(_e51, shape_1);
    return (((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0;
}

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_2
) {
    metal::float2 _e5 = sin_cos_eighth(0.5 * shift);
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_2);
    return _e8;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    Angle _e6 = parametrization_specular(_e3, surface_1.normal, surface_1.view);
    float _e9 = curvature_signed(surface_1.kappa, 0.35);
    float white_specular_convexity = 0.5 + (0.5 * _e9);
    float white_specular_warp = ((2.0 * white_specular_convexity) - 1.0) * 0.7;
    float _e21 = profile(_e6, white_specular_warp, white_specular_tone_shape);
    Light _e24 = look.key;
    LitLayer _e27 = light_apply(_e24, metal::float4(1.0), _e21);
    metal::float4 output = metal::clamp(metal::float4(metal::float3(0.0) + (_e27.tone * (_e27.color.xyz - metal::float3(0.0))), 1.0), metal::float4(0.0), metal::float4(1.0));
    return output;
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
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_1.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    Varyings _e22 = out;
    const auto _tmp = _e22;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
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
, constant View& view_1 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    Surface surface = {};
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    surface.normal = normal_1;
    metal::float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = metal::normalize(_e11.xyz - (_e16 * in.position));
    metal::float4 _e27 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.kappa = _e27.x;
    Surface _e29 = surface;
    metal::float4 _e30 = shade(_e29, look);
    return fs_mainOutput { _e30 };
}
