// Curvature in the extent: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds curvature from normals and depth.
// Arguments of both functions: normals texture(0), depths texture(1), curvature buffer(0).
// figure4-extent.json says what to put there and how to draw.
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
struct Sides {
    float forward;
    float forward_weight;
    float backward;
    float backward_weight;
};
struct type_7 {
    float inner[3];
};
constant type_7 WEIGHTS = type_7 {{1.0, 0.85, 0.5}};

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
    metal::float2 offset,
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
    float expected = metal::dot(gradient, offset) * pixel;
    float error = metal::abs((center.depth - _e3.depth) - expected);
    bool is_near = error <= (((2.0 * pixel) * metal::length(offset)) * (1.0 + metal::length(gradient)));
    metal::float2 _e47 = slope(_e3.normal);
    return is_near ? metal::float3(_e47, 1.0) : metal::float3(0.0);
}

float derivative(
    Sides sides
) {
    float forward = sides.forward / metal::max(sides.forward_weight, 0.000001);
    float backward = sides.backward / metal::max(sides.backward_weight, 0.000001);
    float count = ((sides.forward_weight > 0.0) ? 1.0 : 0.0) + ((sides.backward_weight > 0.0) ? 1.0 : 0.0);
    return (forward + backward) / metal::max(count, 1.0);
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

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_neg(int val) {
    return as_type<int>(-as_type<uint>(val));
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
    Sides along_x = Sides {0.0, 0.0, 0.0, 0.0};
    Sides along_y = Sides {0.0, 0.0, 0.0, 0.0};
    int k = 1;
    metal::int2 at_2 = naga_f2i32(position.xy);
    Texel _e3 = texel(at_2, normals, depths);
    if (_e3.object == 0.0) {
        return fs_mainOutput { 0.0 };
    }
    metal::float2 _e9 = slope(_e3.normal);
    float _e24 = curvature.rows_up;
    int up = (_e24 > 0.5) ? 1 : -1;
    float _e32 = curvature.viewport_height;
    int stride = metal::max(naga_f2i32(metal::rint(_e32 / 800.0)), 1);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e144 = k;
            k = as_type<int>(as_type<uint>(_e144) + as_type<uint>(1));
        }
        loop_init = false;
        int _e41 = k;
        if (_e41 <= 3) {
        } else {
            break;
        }
        {
            int _e44 = k;
            int reach = as_type<int>(as_type<uint>(_e44) * as_type<uint>(stride));
            float distance = static_cast<float>(reach);
            int _e48 = k;
            float weight = (WEIGHTS.inner[as_type<int>(as_type<uint>(_e48) - as_type<uint>(1))] * distance) * distance;
            metal::float3 _e61 = neighbour(_e3, as_type<metal::int2>(as_type<metal::uint2>(at_2) + as_type<metal::uint2>(metal::int2(naga_neg(reach), 0))), metal::float2(-(distance), 0.0), normals, depths, curvature);
            metal::float3 _e67 = neighbour(_e3, as_type<metal::int2>(as_type<metal::uint2>(at_2) + as_type<metal::uint2>(metal::int2(reach, 0))), metal::float2(distance, 0.0), normals, depths, curvature);
            metal::float3 _e74 = neighbour(_e3, as_type<metal::int2>(as_type<metal::uint2>(at_2) + as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(up) * as_type<uint>(reach))))), metal::float2(0.0, distance), normals, depths, curvature);
            metal::float3 _e82 = neighbour(_e3, as_type<metal::int2>(as_type<metal::uint2>(at_2) - as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(up) * as_type<uint>(reach))))), metal::float2(0.0, -(distance)), normals, depths, curvature);
            float _e84 = along_x.forward;
            along_x.forward = _e84 + (((weight * _e67.z) * (_e67.x - _e9.x)) / distance);
            float _e94 = along_x.forward_weight;
            along_x.forward_weight = _e94 + (weight * _e67.z);
            float _e99 = along_x.backward;
            along_x.backward = _e99 + (((weight * _e61.z) * (_e9.x - _e61.x)) / distance);
            float _e109 = along_x.backward_weight;
            along_x.backward_weight = _e109 + (weight * _e61.z);
            float _e114 = along_y.forward;
            along_y.forward = _e114 + (((weight * _e74.z) * (_e74.y - _e9.y)) / distance);
            float _e124 = along_y.forward_weight;
            along_y.forward_weight = _e124 + (weight * _e74.z);
            float _e129 = along_y.backward;
            along_y.backward = _e129 + (((weight * _e82.z) * (_e9.y - _e82.y)) / distance);
            float _e139 = along_y.backward_weight;
            along_y.backward_weight = _e139 + (weight * _e82.z);
        }
    }
    Sides _e146 = along_x;
    float _e147 = derivative(_e146);
    Sides _e148 = along_y;
    float _e149 = derivative(_e148);
    float _e155 = curvature.viewport_height;
    float kappa = (0.5 * (_e147 + _e149)) * _e155;
    return fs_mainOutput { metal::clamp(kappa, -10000.0, 10000.0) };
}
