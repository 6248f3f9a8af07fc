// Light that wraps: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_3 buffer(0), object buffer(1), look buffer(2).
// material-wrap.json says what to put there and how to draw.
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
    metal::float3 view;
};
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
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
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float clamped = metal::max(x, -126.0);
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

float log1p_negative(
    float y_1
) {
    if (y_1 < 0.25) {
        float _e3 = log1p_negative_small(y_1);
        return _e3;
    }
    float _e7 = log2_stable(1.0 - y_1);
    return LN_2_ * _e7;
}

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_1
) {
    return v_1 * metal::rsqrt(metal::max(metal::dot(v_1, v_1), 0.000000000000000000000000000001));
}

metal::float3 half_of(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = light + view;
    metal::float3 _e8 = normalize_moderate((metal::dot(half_, half_) > 0.000000000001) ? half_ : normal, normal);
    return _e8;
}

float sine_squared(
    metal::float3 a,
    metal::float3 b
) {
    metal::float3 across = metal::cross(a, b);
    return metal::min(metal::dot(across, across), 1.0);
}

Reflection reflection_of(
    metal::float3 light_1,
    metal::float3 normal_1,
    metal::float3 view_1
) {
    metal::float3 _e3 = half_of(light_1, normal_1, view_1);
    float n_h = metal::clamp(metal::dot(normal_1, _e3), 0.0, 1.0);
    float v_h = metal::clamp(metal::dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection {metal::dot(normal_1, light_1), metal::dot(normal_1, view_1), n_h, v_h, _e14};
}

float cosine_power(
    float cosine,
    float sine2_,
    float exponent
) {
    if (cosine < 0.7) {
        return metal::pow(cosine, exponent);
    }
    float _e12 = log1p_negative(metal::min(sine2_, 0.6));
    float _e14 = exp2_stable(((0.5 * exponent) * LOG2_E) * _e12);
    return _e14;
}

float reflectance_blinn_phong(
    Light light_2,
    metal::float3 normal_2,
    metal::float3 view_2,
    float roughness
) {
    Reflection _e5 = reflection_of(light_2.direction, normal_2, view_2);
    float width = roughness * roughness;
    float e = (2.0 / (width * width)) - 2.0;
    float _e14 = cosine_power(_e5.n_h, _e5.sine2_, e);
    return ((0.125 * (e + 8.0)) * _e14) * metal::max(_e5.n_l, 0.0);
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    float wrap = metal::max((metal::dot(surface.normal, _e5) + 0.7) / 1.7, 0.0);
    metal::float4 body = metal::min(metal::float4(metal::float3(0.2902, 0.1137, 0.1333) + (wrap * metal::float3(0.851, 0.4706, 0.3725)), 1.0), metal::float4(1.0));
    Light _e30 = look.key;
    float _e34 = reflectance_blinn_phong(_e30, surface.normal, surface.view, 0.6);
    metal::float4 highlight = metal::clamp(metal::float4(body.xyz + (0.25 * ((body.xyz + (_e34 * metal::float3(1.0, 0.8902, 0.8))) - body.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return highlight;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_3 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_3 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_3 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_3.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_3 [[user(loc1), center_perspective]];
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
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_3 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_3 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_3.eye;
    float _e13 = view_3.eye.w;
    Surface surface_1 = Surface {normal_3, metal::normalize(_e8.xyz - (_e13 * in.position))};
    metal::float4 _e19 = shade(surface_1, look);
    return fs_mainOutput { _e19 };
}
