// Oren-Nayar: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_2 buffer(0), object buffer(1), look buffer(2).
// material-oren-nayar.json says what to put there and how to draw.
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
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};

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

float bounded(
    float x_2
) {
    uint bits = as_type<uint>(x_2);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
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

float oren_nayar(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view,
    float sigma
) {
    float n_l = metal::dot(normal, light);
    float n_v = metal::dot(normal, view);
    if (n_l <= 0.0) {
        return 0.0;
    }
    float s2_ = sigma * sigma;
    float a = 1.0 - ((0.5 * s2_) / (s2_ + 0.33));
    float b = (0.45 * s2_) / (s2_ + 0.09);
    float across = metal::dot(light, view) - (n_l * n_v);
    float larger = metal::max(metal::max(n_l, n_v), 0.001);
    return n_l * (a + ((b * metal::max(across, 0.0)) / larger));
}

float reflectance_oren_nayar(
    Light light_1,
    metal::float3 normal_1,
    metal::float3 view_1,
    float roughness
) {
    float _e4 = bounded(roughness);
    float sigma_1 = metal::clamp(_e4, 0.0, 1.0);
    metal::float3 _e13 = normalize_or(normal_1, metal::float3(0.0, 0.0, 1.0));
    float _e14 = oren_nayar(light_1.direction, _e13, view_1, sigma_1);
    return _e14;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e7 = reflectance_oren_nayar(_e3, surface_1.normal, surface_1.view, 0.9);
    Composite _e20 = blend_add(metal::float4(0.1725, 0.1647, 0.2, 1.0), metal::float4(0.851, 0.7961, 0.698, 1.0), _e7, 1.0, true);
    Color _e21 = output(_e20);
    return _e21;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
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
    metal::float3 normal_2 [[user(loc1), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_2 = is_front ? _e7 : -(_e7);
    surface.normal = normal_2;
    metal::float4 _e15 = view_2.eye;
    float _e20 = view_2.eye.w;
    metal::float4 _e26 = view_2.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    Surface _e34 = surface;
    metal::float4 _e35 = shade(_e34, look);
    metal::float4 _e36 = finite_vec4_(_e35);
    return fs_mainOutput { _e36 };
}
