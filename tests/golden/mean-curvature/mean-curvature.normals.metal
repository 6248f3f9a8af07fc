// Curvature as color: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws normals and depth, for the curvature pass.
// Arguments of both functions: view buffer(0), object buffer(1).
// mean-curvature.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    metal::float4 eye;
};

struct Object {
    metal::float4x4 world_from_object;
    /// The inverse transpose, for normals.
    metal::float3x3 world_from_normal;
    float id;
    char _pad3[12];
};

/// The surface under the fragment, in world space.
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

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return square > 0.000000000000000000000000000001 ? v
        * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
metal::float3 normalize_seen(
    metal::float3 v
) {
    return normalize_moderate(v, metal::float3(0.0, 0.0, 1.0));
}

/// The slope n.xy / n.z of a normal in camera axes.
metal::float2 slope_of(
    metal::float3 normal
) {
    return normal.xy / metal::float2(metal::max(normal.z, 0.2));
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
metal::float4 surface_texel(
    metal::float3 normal,
    float depth,
    float number
) {
    metal::float2 slope_of_value = slope_of(normal);
    return metal::float4(slope_of_value, depth, normal.z < 0.0 ? -number : number);
}

/// The normal that the curvature pass sees.
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
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
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
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 toward = metal::normalize(view.eye.xyz - view.eye.w * in.position);
    if (!is_front) {
        local = metal::dot(facing, toward) < -0.1;
    } else {
        local = false;
    }
    bool is_behind = local;
    metal::float3 normal = is_behind ? -facing : facing;
    Surface surface = Surface {normal};
    metal::float3 seen = (view.camera_from_world * metal::float4(shade(surface), 0.0)).xyz;
    float depth = -(view.camera_from_world * metal::float4(in.position, 1.0)).z;
    return fs_mainOutput { surface_texel(seen, depth, object.id + 1.0) };
}
