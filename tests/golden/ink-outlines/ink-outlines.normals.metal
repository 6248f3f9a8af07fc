// Ink outlines: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws normals and depth, for the curvature pass.
// Arguments of both functions: view buffer(0), object buffer(1).
// ink-outlines.json says what to put there and how to draw.
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
struct Surface {
    metal::float3 normal;
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

metal::float3 normalize_seen(
    metal::float3 v_1
) {
    metal::float3 _e5 = normalize_moderate(v_1, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

metal::float2 slope_of(
    metal::float3 normal
) {
    return normal.xy / metal::float2(metal::max(normal.z, 0.2));
}

metal::float4 surface_texel(
    metal::float3 normal_1,
    float depth,
    float number
) {
    metal::float2 _e3 = slope_of(normal_1);
    return metal::float4(_e3, depth, (normal_1.z < 0.0) ? -(number) : number);
}

metal::float3 shade(
    Surface surface
) {
    return surface.normal;
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
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
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
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    bool local = {};
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float4 _e6 = view.eye;
    float _e11 = view.eye.w;
    metal::float3 toward = metal::normalize(_e6.xyz - (_e11 * in.position));
    if (!(is_front)) {
        local = metal::dot(_e3, toward) < -0.1;
    } else {
        local = false;
    }
    bool is_behind = local;
    metal::float3 normal_2 = is_behind ? -(_e3) : _e3;
    Surface surface_1 = Surface {normal_2};
    metal::float4x4 _e29 = view.camera_from_world;
    metal::float3 _e30 = shade(surface_1);
    metal::float3 seen = (_e29 * metal::float4(_e30, 0.0)).xyz;
    metal::float4x4 _e37 = view.camera_from_world;
    float depth_1 = -((_e37 * metal::float4(in.position, 1.0)).z);
    float _e46 = object.id;
    metal::float4 _e49 = surface_texel(seen, depth_1, _e46 + 1.0);
    return fs_mainOutput { _e49 };
}
