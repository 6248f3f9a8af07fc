// Anisotropic Ward: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_3 buffer(0), object buffer(1), look buffer(2).
// material-ward.json says what to put there and how to draw.
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
    metal::float3 tangent;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
    metal::float4 tangent;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
    metal::float4 tangent;
};
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;

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

float bounded(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

metal::float3 any_orthogonal(
    metal::float3 n_1
) {
    float sign = (n_1.z >= 0.0) ? 1.0 : -1.0;
    float a = -1.0 / (sign + n_1.z);
    return metal::float3(1.0 + (((sign * n_1.x) * n_1.x) * a), ((sign * n_1.x) * n_1.y) * a, -(sign) * n_1.x);
}

metal::float3x3 world_from_tangent(
    metal::float3 tangent,
    metal::float3 bitangent,
    metal::float3 normal
) {
    metal::float3 _e7 = normalize_or(normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e10 = normalize_or(tangent, metal::float3(0.0));
    metal::float3 leaning = _e10 - (metal::dot(_e10, _e7) * _e7);
    bool is_usable = metal::dot(leaning, leaning) > 0.00000001;
    metal::float3 _e17 = any_orthogonal(_e7);
    metal::float3 _e23 = normalize_or(is_usable ? leaning : _e17, metal::float3(1.0, 0.0, 0.0));
    metal::float3 _e31 = normalize_or(_e23 - (metal::dot(_e23, _e7) * _e7), metal::float3(1.0, 0.0, 0.0));
    metal::float3 b = metal::cross(_e7, _e31);
    return metal::float3x3(_e31, (metal::dot(b, bitangent) < 0.0) ? -(b) : b, _e7);
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
    metal::float3 normal_1,
    metal::float3 view
) {
    metal::float3 half_ = light + view;
    metal::float3 _e8 = normalize_or((metal::dot(half_, half_) > 0.000000000001) ? half_ : normal_1, normal_1);
    return _e8;
}

float width_of_roughness(
    float roughness
) {
    float _e1 = bounded(roughness);
    float r = metal::clamp(_e1, 0.0, 1.0);
    return metal::max(r * r, 0.001);
}

float ward(
    metal::float3 light_1,
    metal::float3 normal_2,
    metal::float3 view_1,
    metal::float3 x_axis,
    metal::float3 y_axis,
    metal::float2 widths
) {
    bool local_1 = {};
    float n_l = metal::dot(normal_2, light_1);
    float n_v = metal::dot(normal_2, view_1);
    if (!((n_l <= 0.0))) {
        local_1 = n_v <= 0.0;
    } else {
        local_1 = true;
    }
    bool _e16 = local_1;
    if (_e16) {
        return 0.0;
    }
    metal::float3 _e18 = half_of(light_1, normal_2, view_1);
    float n_h = metal::max(metal::dot(normal_2, _e18), 0.000001);
    metal::float2 slope = metal::float2(metal::dot(_e18, x_axis), metal::dot(_e18, y_axis)) / (widths * n_h);
    float _e32 = exp2_stable(-1.442695 * metal::min(metal::dot(slope, slope), 200.0));
    return metal::min((n_l * _e32) / (((4.0 * widths.x) * widths.y) * metal::sqrt(metal::max(n_l * n_v, 0.000001))), 1000000.0);
}

float reflectance_lambert(
    Light light_2,
    metal::float3 normal_3
) {
    metal::float3 _e6 = normalize_or(normal_3, metal::float3(0.0, 0.0, 1.0));
    return metal::max(metal::dot(_e6, light_2.direction), 0.0);
}

float reflectance_ward(
    Light light_3,
    metal::float3 normal_4,
    metal::float3 view_2,
    metal::float3 tangent_1,
    float roughness_1,
    float across
) {
    metal::float3x3 _e8 = world_from_tangent(tangent_1, metal::float3(0.0), normal_4);
    float _e9 = width_of_roughness(roughness_1);
    float _e10 = width_of_roughness(across);
    metal::float2 widths_1 = metal::max(metal::float2(_e9, _e10), metal::float2(0.0025));
    float _e19 = ward(light_3.direction, _e8[2], view_2, _e8[0], _e8[1], widths_1);
    return _e19;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e5 = reflectance_lambert(_e3, surface_1.normal);
    Composite _e18 = blend_add(metal::float4(0.098, 0.1059, 0.1333, 1.0), metal::float4(0.3529, 0.3961, 0.4392, 1.0), _e5, 1.0, true);
    Light _e21 = look.key;
    float _e27 = reflectance_ward(_e21, surface_1.normal, surface_1.view, surface_1.tangent, 0.5, 0.2);
    Composite _e35 = blend_add(_e18, metal::float4(0.9569, 0.9412, 0.902, 1.0), _e27, 0.55, true);
    Color _e36 = output(_e35);
    return _e36;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_5 [[attribute(1)]];
    metal::float4 tangent_2 [[attribute(2)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
    metal::float4 tangent [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_3 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_5, varyings.tangent_2 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_3.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    metal::float4x4 _e25 = object.world_from_object;
    metal::float3x3 _e39 = object.world_from_normal;
    out.tangent = metal::float4((_e25 * metal::float4(vertex_.tangent.xyz, 0.0)).xyz, (metal::determinant(_e39) < 0.0) ? -(vertex_.tangent.w) : vertex_.tangent.w);
    Varyings _e45 = out;
    const auto _tmp = _e45;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal, _tmp.tangent };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_5 [[user(loc1), center_perspective]];
    metal::float4 tangent_2 [[user(loc2), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_5, varyings_1.tangent_2 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_5 = is_front ? _e7 : -(_e7);
    surface.normal = normal_5;
    metal::float4 _e15 = view_3.eye;
    float _e20 = view_3.eye.w;
    metal::float4 _e26 = view_3.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    metal::float3 _e44 = normalize_or(in.tangent.xyz - (normal_5 * metal::dot(normal_5, in.tangent.xyz)), in.tangent.xyz);
    surface.tangent = _e44;
    Surface _e45 = surface;
    metal::float4 _e46 = shade(_e45, look);
    metal::float4 _e47 = finite_vec4_(_e46);
    return fs_mainOutput { _e47 };
}
