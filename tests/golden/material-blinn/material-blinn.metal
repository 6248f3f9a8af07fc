// Blinn-Phong: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_3 buffer(0), object buffer(1), look buffer(2).
// material-blinn.json says what to put there and how to draw.
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
typedef metal::float4 Color;
typedef metal::float4 Composite;
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
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;

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
    int shift = static_cast<int>((bits - 1060439283u) >> 23u);
    int exponent_2 = (shift >= 256) ? as_type<int>(as_type<uint>(shift) - as_type<uint>(512)) : shift;
    float mantissa = as_type<float>(bits - (static_cast<uint>(exponent_2) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    float series = (2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111))))))));
    return (static_cast<float>(exponent_2) * LN_2_) + series;
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

float bounded(
    float x_4
) {
    uint bits_1 = as_type<uint>(x_4);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_4 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

float powered(
    float base,
    float exponent
) {
    bool local_1 = {};
    float _e2 = bounded(base);
    float _e3 = bounded(exponent);
    if (_e3 == 1.0) {
        return _e2;
    }
    if (_e3 == 0.0) {
        return 1.0;
    }
    if (_e3 == 2.0) {
        float _e12 = bounded(_e2 * _e2);
        return _e12;
    }
    float magnitude_1 = metal::abs(_e2);
    if (magnitude_1 < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e18 = log_stable(magnitude_1);
    float _e21 = bounded(_e3 * (LOG2_E * _e18));
    float _e22 = exp2_stable(_e21);
    bool is_even = metal::floor(_e3 * 0.5) == (_e3 * 0.5);
    if (_e2 < 0.0) {
        local_1 = !(is_even);
    } else {
        local_1 = false;
    }
    bool _e36 = local_1;
    return _e36 ? -(_e22) : _e22;
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

metal::float3 half_of(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = light + view;
    metal::float3 _e8 = normalize_or((metal::dot(half_, half_) > 0.000000000001) ? half_ : normal, normal);
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
    float exponent_1
) {
    if (cosine < 0.7) {
        float _e7 = powered(metal::max(cosine, 0.0), exponent_1);
        return _e7;
    }
    float _e14 = log1p_negative(metal::min(sine2_, 0.6));
    float _e16 = exp2_stable(((0.5 * exponent_1) * LOG2_E) * _e14);
    return _e16;
}

float width_of_roughness(
    float roughness
) {
    float _e1 = bounded(roughness);
    float r = metal::clamp(_e1, 0.0, 1.0);
    return metal::max(r * r, 0.001);
}

float exponent_of_width(
    float width
) {
    return metal::max((2.0 / (width * width)) - 2.0, 0.0);
}

float reflectance_half_lambert(
    Light light_2,
    metal::float3 normal_2
) {
    metal::float3 _e6 = normalize_or(normal_2, metal::float3(0.0, 0.0, 1.0));
    float half_1 = 0.5 + (0.5 * metal::dot(_e6, light_2.direction));
    return metal::clamp(half_1 * half_1, 0.0, 1.0);
}

float reflectance_blinn_phong(
    Light light_3,
    metal::float3 normal_3,
    metal::float3 view_2,
    float roughness_1
) {
    metal::float3 _e9 = normalize_or(normal_3, metal::float3(0.0, 0.0, 1.0));
    Reflection _e10 = reflection_of(light_3.direction, _e9, view_2);
    float _e11 = width_of_roughness(roughness_1);
    float _e12 = exponent_of_width(_e11);
    float _e15 = cosine_power(_e10.n_h, _e10.sine2_, _e12);
    return metal::min(((0.125 * (_e12 + 8.0)) * _e15) * metal::max(_e10.n_l, 0.0), 1000000.0);
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e5 = reflectance_half_lambert(_e3, surface_1.normal);
    Composite _e18 = blend_add(metal::float4(0.1647, 0.102, 0.0706, 1.0), metal::float4(0.851, 0.5412, 0.1686, 1.0), _e5, 1.0, true);
    Light _e21 = look.key;
    float _e25 = reflectance_blinn_phong(_e21, surface_1.normal, surface_1.view, 0.38);
    Composite _e33 = blend_add(_e18, metal::float4(1.0, 0.9529, 0.8627, 1.0), _e25, 0.3, true);
    Color _e34 = output(_e33);
    return _e34;
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
, constant View& view_3 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_4 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_3.clip_from_world;
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
, constant View& view_3 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_4 };
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
    Surface _e34 = surface;
    metal::float4 _e35 = shade(_e34, look);
    metal::float4 _e36 = finite_vec4_(_e35);
    return fs_mainOutput { _e36 };
}
