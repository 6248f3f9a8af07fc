// Oren-Nayar: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
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
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
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

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e4 = look.key.direction;
    float _e8 = oren_nayar(_e4, surface.normal, surface.view, 0.9);
    metal::float4 body = metal::min(metal::float4(metal::float3(0.1725, 0.1647, 0.2) + (_e8 * metal::float3(0.851, 0.7961, 0.698)), 1.0), metal::float4(1.0));
    return body;
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
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
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
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position))};
    metal::float4 _e19 = shade(surface_1, look);
    return fs_mainOutput { _e19 };
}
