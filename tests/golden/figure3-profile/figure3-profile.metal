// Shading profile: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// figure3-profile.json says what to put there and how to draw.
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
struct Look {
    Light key;
    ProfileShape profile_tone_shape;
};
struct Surface {
    metal::float3 normal;
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
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 normal;
};
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant uint PROFILE_STEP = 1u;
constant uint PROFILE_AMBIENT = 2u;

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

float log2_stable(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
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

metal::float2 sin_cos_tiny(
    float x_2
) {
    float y_2 = x_2 * x_2;
    float s = x_2 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334))));
    float c = 1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * 0.0013888889)))));
    return metal::float2(s, c);
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
    float x_3
) {
    float small = metal::min(y_1, x_3);
    float large = metal::max(y_1, x_3);
    if (large <= 0.0) {
        return 0.0;
    }
    float t_2 = small / large;
    bool is_wide = t_2 > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t_2;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a = is_wide ? (series + 0.7853982) : series;
    return (y_1 > x_3) ? (HALF_PI - a) : a;
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
    float s_1 = (u_1.half_sin * t.y) - (u_1.half_cos * t.x);
    float c_1 = (u_1.half_cos * t.y) + (u_1.half_sin * t.x);
    metal::float2 upper = (c_1 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_1, c_1);
    metal::float2 turned = ((s_1 <= 0.0) & (s_1 < c_1)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

Angle angle_turned_2_(
    Angle u_2,
    metal::float2 t_1
) {
    float s_2 = u_2.half_sin - (u_2.half_cos * 0.0);
    float c_2 = u_2.half_cos + (u_2.half_sin * 0.0);
    metal::float2 upper_1 = (c_2 <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, c_2);
    metal::float2 turned_1 = ((s_2 <= 0.0) & (s_2 < c_2)) ? metal::float2(0.0, 1.0) : upper_1;
    return Angle {turned_1.x, turned_1.y};
}

LitLayer light_apply(
    Light light,
    Color color,
    float tone
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0), metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4((color.xyz * light.color) * split.y, 1.0), tone * split.x};
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
    float _e21 = exp2_stable(exponent * _e19);
    return metal::clamp(_e21, 0.0, 1.0);
}

float profile_point(
    Angle u_3,
    ProfileShape shape
) {
    float s_3 = (u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset);
    if ((s_3 <= 0.0) | (shape.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    if (shape.kind == PROFILE_STEP) {
        return (s_3 <= 0.0000004) ? 1.0 : 0.0;
    }
    float q_1 = s_3 * shape.scale;
    float _e27 = profile_power(q_1, shape.exponent);
    return _e27;
}

float profile_filtered(
    Angle u_4,
    float w,
    ProfileShape shape_1
) {
    float _e3 = profile_point(u_4, shape_1);
    bool is_wide_1 = w < (0.1 * shape_1.edge_deviation);
    if ((is_wide_1 | (w <= 0.0)) | (shape_1.kind == PROFILE_AMBIENT)) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145) & (w >= (3.4641016 * shape_1.edge_deviation))) {
        float width = metal::sqrt((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation));
        float _e36 = atan2_positive(u_4.half_sin, u_4.half_cos);
        return metal::clamp(0.5 + (((shape_1.offset + shape_1.edge_mean) - (2.0 * _e36)) / width), 0.0, 1.0);
    }
    metal::float2 _e48 = sin_cos_tiny(0.19364917 * w);
    Angle _e49 = angle_turned(u_4, _e48);
    float _e50 = profile_point(_e49, shape_1);
    Angle _e55 = angle_turned(u_4, metal::float2(-(_e48.x), _e48.y));
    float _e56 = profile_point(_e55, shape_1);
    return (((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0;
}

float profile(
    Angle angle,
    float shift,
    ProfileShape shape_2
) {
    Angle _e6 = angle_turned_2_(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered(_e6, _e7, shape_2);
    return _e8;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    metal::float3 _e14 = look.key.direction;
    Angle profile_angle = Angle {0.5 * metal::length(surface_1.normal - _e5), 0.5 * metal::length(surface_1.normal + _e14)};
    ProfileShape _e23 = look.profile_tone_shape;
    float _e24 = profile(profile_angle, 0.0, _e23);
    Light _e27 = look.key;
    LitLayer _e33 = light_apply(_e27, metal::float4(0.949, 0.8941, 0.7843, 1.0), _e24);
    metal::float4 output = metal::clamp(metal::float4(metal::float3(0.1098, 0.1333, 0.1882) + (_e33.tone * _e33.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));
    return output;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal };
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
    metal::float3 normal [[user(loc0), center_perspective]];
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
    const Varyings in = { clip, varyings_1.normal };
    Surface surface = {};
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    surface.normal = normal;
    Surface _e8 = surface;
    metal::float4 _e9 = shade(_e8, look);
    return fs_mainOutput { _e9 };
}
