// Cook-Torrance, GGX: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_2 buffer(0), object buffer(1), look buffer(2).
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

float schlick(
    float at_normal,
    float cosine
) {
    float m = 1.0 - cosine;
    float m2_ = m * m;
    return at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m));
}

float ggx(
    Reflection r,
    float width,
    float at_normal_1
) {
    if ((r.n_l <= 0.0) | (r.n_v <= 0.0)) {
        return 0.0;
    }
    float a2_ = width * width;
    float bottom = metal::max(r.sine2_ + ((a2_ * r.n_h) * r.n_h), 0.000000000001);
    float distribution = a2_ / (bottom * bottom);
    float toward_light = r.n_v * metal::sqrt(((r.n_l * r.n_l) * (1.0 - a2_)) + a2_);
    float toward_eye = r.n_l * metal::sqrt(((r.n_v * r.n_v) * (1.0 - a2_)) + a2_);
    float visibility = 0.5 / metal::max(toward_light + toward_eye, 0.000000001);
    float _e49 = schlick(at_normal_1, r.v_h);
    return metal::min(((distribution * visibility) * _e49) * r.n_l, 1000000.0);
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    float lambert = metal::max(metal::dot(surface.normal, _e5), 0.0);
    metal::float4 body = metal::float4(metal::float3(0.0784, 0.0863, 0.1098) + (lambert * metal::float3(0.2353, 0.2667, 0.3137)), 1.0);
    metal::float3 _e24 = look.key.direction;
    Reflection _e27 = reflection_of(_e24, surface.normal, surface.view);
    float _e30 = ggx(_e27, 0.1764, 0.85);
    metal::float4 highlight = metal::clamp(metal::float4(body.xyz + (0.5 * ((body.xyz + (_e30 * metal::float3(0.9098, 0.9333, 0.9647))) - body.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return highlight;
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
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_2.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
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
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_2 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    Surface surface_1 = Surface {normal_2, metal::normalize(_e8.xyz - (_e13 * in.position))};
    metal::float4 _e19 = shade(surface_1, look);
    return fs_mainOutput { _e19 };
}
