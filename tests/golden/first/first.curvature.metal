// First look: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds curvature from normals and depth.
// Arguments of both functions: normals texture(0), depths texture(1), curvature buffer(0).
// first.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
};
struct Texel {
    metal::packed_float3 normal;
    float object;
    float depth;
    char _pad3[12];
};

Texel texel(
    metal::int2 at,
    metal::texture2d<float, metal::access::sample> normals,
    metal::texture2d<float, metal::access::sample> depths
) {
    bool local = {};
    metal::int2 size = static_cast<metal::int2>(metal::uint2(normals.get_width(), normals.get_height()));
    if (!(metal::any(at < metal::int2(0)))) {
        local = metal::any(at >= size);
    } else {
        local = true;
    }
    bool _e14 = local;
    if (_e14) {
        return Texel {metal::float3(0.0), 0.0, 0.0};
    }
    metal::float4 normal_1 = normals.read(metal::uint2(at), 0);
    metal::float4 _e27 = depths.read(metal::uint2(at), 0);
    return Texel {normal_1.xyz, normal_1.w, _e27.x};
}

metal::float2 slope(
    metal::float3 normal
) {
    return normal.xy / metal::float2(metal::max(normal.z, 0.2));
}

metal::float3 neighbour(
    Texel center,
    metal::int2 at_1,
    metal::float2 step,
    metal::texture2d<float, metal::access::sample> normals,
    metal::texture2d<float, metal::access::sample> depths,
    constant Curvature& curvature
) {
    Texel _e3 = texel(at_1, normals, depths);
    if (_e3.object != center.object) {
        return metal::float3(0.0);
    }
    float _e11 = curvature.pixel;
    float _e15 = curvature.perspective;
    float pixel = _e11 * metal::mix(1.0, center.depth, _e15);
    metal::float2 gradient = -(metal::float3(center.normal).xy) / metal::float2(metal::max(center.normal[2], 0.02));
    float expected = metal::dot(gradient, step) * pixel;
    float error = metal::abs((center.depth - _e3.depth) - expected);
    bool is_near = error <= ((2.0 * pixel) * (1.0 + metal::length(gradient)));
    metal::float2 _e45 = slope(_e3.normal);
    return is_near ? metal::float3(_e45, 1.0) : metal::float3(0.0);
}

float derivative(
    float here,
    metal::float2 before,
    metal::float2 after
) {
    float total = before.y + after.y;
    if (total == 0.0) {
        return 0.0;
    }
    float forward = (after.x - here) * after.y;
    float backward = (here - before.x) * before.y;
    return (forward + backward) / total;
}

struct vs_mainInput {
};
struct vs_mainOutput {
    metal::float4 member [[position]];
};
vertex vs_mainOutput vs_main(
  uint index [[vertex_id]]
) {
    return vs_mainOutput { metal::float4((static_cast<float>(index & 1u) * 4.0) - 1.0, (static_cast<float>(index >> 1u) * 4.0) - 1.0, 0.0, 1.0) };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
};
struct fs_mainOutput {
    float member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  metal::float4 position [[position]]
, metal::texture2d<float, metal::access::sample> normals [[texture(0)]]
, metal::texture2d<float, metal::access::sample> depths [[texture(1)]]
, constant Curvature& curvature [[buffer(0)]]
) {
    metal::int2 at_2 = naga_f2i32(position.xy);
    Texel _e3 = texel(at_2, normals, depths);
    if (_e3.object == 0.0) {
        return fs_mainOutput { 0.0 };
    }
    metal::float2 _e9 = slope(_e3.normal);
    metal::float3 _e17 = neighbour(_e3, as_type<metal::int2>(as_type<metal::uint2>(at_2) + as_type<metal::uint2>(metal::int2(-1, 0))), metal::float2(-1.0, 0.0), normals, depths, curvature);
    metal::float3 _e25 = neighbour(_e3, as_type<metal::int2>(as_type<metal::uint2>(at_2) + as_type<metal::uint2>(metal::int2(1, 0))), metal::float2(1.0, 0.0), normals, depths, curvature);
    float _e28 = curvature.rows_up;
    int up = (_e28 > 0.5) ? 1 : -1;
    metal::float3 _e40 = neighbour(_e3, as_type<metal::int2>(as_type<metal::uint2>(at_2) + as_type<metal::uint2>(metal::int2(0, up))), metal::float2(0.0, 1.0), normals, depths, curvature);
    metal::float3 _e47 = neighbour(_e3, as_type<metal::int2>(as_type<metal::uint2>(at_2) - as_type<metal::uint2>(metal::int2(0, up))), metal::float2(0.0, -1.0), normals, depths, curvature);
    float _e51 = derivative(_e9.x, _e17.xz, _e25.xz);
    float _e55 = derivative(_e9.y, _e47.yz, _e40.yz);
    float _e61 = curvature.viewport_height;
    float kappa = (0.5 * (_e51 + _e55)) * _e61;
    return fs_mainOutput { metal::clamp(kappa, -10000.0, 10000.0) };
}
