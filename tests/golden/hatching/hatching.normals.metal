// Hatching: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws normals and depth, for the curvature pass.
// Arguments of both functions: view buffer(0), object buffer(1).
// hatching.json says what to put there and how to draw.
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
struct Fragment {
    metal::float4 normal;
    float depth;
    char _pad2[12];
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
    bool local_1 = {};
    float largest = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest > 0.000000000000000000000000000001) {
        local_1 = largest < 1000000000000000000000000000000.0;
    } else {
        local_1 = false;
    }
    bool _e17 = local_1;
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

metal::float3 shade(
    Surface surface_1
) {
    return surface_1.normal;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view.clip_from_world;
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
    metal::float3 normal [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 normal [[color(0)]];
    float depth [[color(1)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal };
    bool local = {};
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float4 _e10 = view.eye;
    float _e15 = view.eye.w;
    metal::float3 _e19 = normalize_or(_e10.xyz - (_e15 * in.position), _e7);
    if (!(is_front)) {
        local = metal::dot(_e7, _e19) < -0.1;
    } else {
        local = false;
    }
    bool is_behind = local;
    metal::float3 normal = is_behind ? -(_e7) : _e7;
    surface.normal = normal;
    Surface _e32 = surface;
    metal::float3 _e33 = shade(_e32);
    metal::float4x4 _e36 = view.camera_from_world;
    metal::float3 seen = (_e36 * metal::float4(_e33, 0.0)).xyz;
    metal::float4x4 _e43 = view.camera_from_world;
    float depth = -((_e43 * metal::float4(in.position, 1.0)).z);
    float _e52 = object.id;
    const auto _tmp_1 = Fragment {metal::float4(seen, _e52 + 1.0), depth};
    return fs_mainOutput { _tmp_1.normal, _tmp_1.depth };
}
