// Cook-Torrance, GGX: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_3 buffer(0), object buffer(1), look buffer(2).
// material-ggx.json says what to put there and how to draw.
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

float width_of_roughness(
    float roughness
) {
    float _e1 = bounded(roughness);
    float r_1 = metal::clamp(_e1, 0.0, 1.0);
    return metal::max(r_1 * r_1, 0.001);
}

float schlick(
    float at_normal,
    float cosine
) {
    float m = metal::clamp(1.0 - cosine, 0.0, 1.0);
    float m2_ = m * m;
    return at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m));
}

float ggx(
    Reflection r,
    float width,
    float at_normal_1
) {
    bool local_1 = {};
    if (!((r.n_l <= 0.0))) {
        local_1 = r.n_v <= 0.0;
    } else {
        local_1 = true;
    }
    bool _e13 = local_1;
    if (_e13) {
        return 0.0;
    }
    float a2_ = width * width;
    float bottom = metal::max(r.sine2_ + ((a2_ * r.n_h) * r.n_h), 0.000000000001);
    float distribution = a2_ / (bottom * bottom);
    float toward_light = r.n_v * metal::sqrt(((r.n_l * r.n_l) * (1.0 - a2_)) + a2_);
    float toward_eye = r.n_l * metal::sqrt(((r.n_v * r.n_v) * (1.0 - a2_)) + a2_);
    float visibility = 0.5 / metal::max(toward_light + toward_eye, 0.000000001);
    float _e53 = schlick(at_normal_1, r.v_h);
    return metal::min(((distribution * visibility) * _e53) * r.n_l, 1000000.0);
}

float reflectance_lambert(
    Light light_2,
    metal::float3 normal_2
) {
    metal::float3 _e6 = normalize_or(normal_2, metal::float3(0.0, 0.0, 1.0));
    return metal::max(metal::dot(_e6, light_2.direction), 0.0);
}

float reflectance_ggx(
    Light light_3,
    metal::float3 normal_3,
    metal::float3 view_2,
    float roughness_1,
    float at_normal_2
) {
    metal::float3 _e10 = normalize_or(normal_3, metal::float3(0.0, 0.0, 1.0));
    Reflection _e11 = reflection_of(light_3.direction, _e10, view_2);
    float _e12 = width_of_roughness(roughness_1);
    float _e13 = bounded(at_normal_2);
    float _e17 = ggx(_e11, _e12, metal::clamp(_e13, 0.0, 1.0));
    return _e17;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e5 = reflectance_lambert(_e3, surface_1.normal);
    Composite _e18 = blend_add(metal::float4(0.0784, 0.0863, 0.1098, 1.0), metal::float4(0.2353, 0.2667, 0.3137, 1.0), _e5, 1.0, true);
    Light _e21 = look.key;
    float _e26 = reflectance_ggx(_e21, surface_1.normal, surface_1.view, 0.42, 0.85);
    Composite _e34 = blend_add(_e18, metal::float4(0.9098, 0.9333, 0.9647, 1.0), _e26, 0.5, true);
    Color _e35 = output(_e34);
    return _e35;
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
