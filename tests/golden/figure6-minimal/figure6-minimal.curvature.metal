// Minimal: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds curvature from normals and depth.
// Arguments of both functions: normals texture(0), depths texture(1), curvature buffer(0).
// figure6-minimal.json says what to put there and how to draw.
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
struct type_3 {
    metal::int2 inner[8];
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
struct type_8 {
    float inner[3];
};
constant type_3 RING = type_3 {{metal::int2(1, 0), metal::int2(-1, 0), metal::int2(0, 1), metal::int2(0, -1), metal::int2(1, 1), metal::int2(-1, 1), metal::int2(1, -1), metal::int2(-1, -1)}};
constant type_8 WEIGHTS = type_8 {{1.0, 0.85, 0.5}};

Texel texel(
    metal::int2 at_1,
    metal::texture2d<float, metal::access::sample> normals,
    metal::texture2d<float, metal::access::sample> depths
) {
    bool local_1 = {};
    metal::int2 size = static_cast<metal::int2>(metal::uint2(normals.get_width(), normals.get_height()));
    if (!(metal::any(at_1 < metal::int2(0)))) {
        local_1 = metal::any(at_1 >= size);
    } else {
        local_1 = true;
    }
    bool _e14 = local_1;
    if (_e14) {
        return Texel {metal::float3(0.0), 0.0, 0.0};
    }
    metal::float4 normal_1 = normals.read(metal::uint2(at_1), 0);
    metal::float4 _e27 = depths.read(metal::uint2(at_1), 0);
    return Texel {normal_1.xyz, normal_1.w, _e27.x};
}

metal::float2 slope(
    metal::float3 normal
) {
    return normal.xy / metal::float2(metal::max(normal.z, 0.2));
}

metal::float3 neighbour(
    Texel center_1,
    metal::int2 at_2,
    metal::float2 offset,
    metal::texture2d<float, metal::access::sample> normals,
    metal::texture2d<float, metal::access::sample> depths,
    constant Curvature& curvature
) {
    Texel _e3 = texel(at_2, normals, depths);
    if (_e3.object != center_1.object) {
        return metal::float3(0.0);
    }
    float _e11 = curvature.pixel;
    float _e15 = curvature.perspective;
    float pixel = _e11 * metal::mix(1.0, center_1.depth, _e15);
    metal::float2 gradient = -(metal::float3(center_1.normal).xy) / metal::float2(metal::max(center_1.normal[2], 0.02));
    float expected = metal::dot(gradient, offset) * pixel;
    float error = metal::abs((center_1.depth - _e3.depth) - expected);
    float tolerance = ((2.0 * pixel) * metal::length(offset)) * (1.0 + metal::length(gradient));
    float weight = metal::clamp(2.0 - (error / metal::max(tolerance, 0.000000000000000000000000000001)), 0.0, 1.0);
    metal::float2 _e52 = slope(_e3.normal);
    return metal::float3(_e52, weight);
}

float derivative(
    Sides sides
) {
    float forward = sides.forward / metal::max(sides.forward_weight, 0.000001);
    float backward = sides.backward / metal::max(sides.backward_weight, 0.000001);
    metal::float2 trust = metal::float2(metal::smoothstep(0.0, 0.5, sides.forward_weight), metal::smoothstep(0.0, 0.5, sides.backward_weight));
    return ((forward * trust.x) + (backward * trust.y)) / metal::max(trust.x + trust.y, 0.000001);
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
    metal::int2 at = {};
    Texel center = {};
    int k = 0;
    bool local = {};
    Sides along_x = Sides {0.0, 0.0, 0.0, 0.0};
    Sides along_y = Sides {0.0, 0.0, 0.0, 0.0};
    int k_1 = 1;
    at = naga_f2i32(position.xy);
    metal::int2 _e4 = at;
    Texel _e5 = texel(_e4, normals, depths);
    center = _e5;
    float _e8 = center.object;
    if (_e8 == 0.0) {
        uint2 loop_bound = uint2(4294967295u);
        bool loop_init = true;
        while(true) {
            if (metal::all(loop_bound == uint2(0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                int _e33 = k;
                k = as_type<int>(as_type<uint>(_e33) + as_type<uint>(1));
            }
            loop_init = false;
            int _e13 = k;
            if (_e13 < 8) {
                float _e19 = center.object;
                local = _e19 == 0.0;
            } else {
                local = false;
            }
            bool _e23 = local;
            if (_e23) {
            } else {
                break;
            }
            {
                int _e27 = k;
                at = as_type<metal::int2>(as_type<metal::uint2>(naga_f2i32(position.xy)) + as_type<metal::uint2>(RING.inner[_e27]));
                metal::int2 _e30 = at;
                Texel _e31 = texel(_e30, normals, depths);
                center = _e31;
            }
        }
        float _e36 = center.object;
        if (_e36 == 0.0) {
            return fs_mainOutput { 0.0 };
        }
    }
    metal::float3 _e41 = center.normal;
    metal::float2 _e42 = slope(_e41);
    float _e57 = curvature.rows_up;
    int up = (_e57 > 0.5) ? 1 : -1;
    float _e65 = curvature.viewport_height;
    int stride = metal::max(naga_f2i32(metal::rint(_e65 / 800.0)), 1);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e185 = k_1;
            k_1 = as_type<int>(as_type<uint>(_e185) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e74 = k_1;
        if (_e74 <= 3) {
        } else {
            break;
        }
        {
            int _e77 = k_1;
            int reach = as_type<int>(as_type<uint>(_e77) * as_type<uint>(stride));
            float distance = static_cast<float>(reach);
            int _e81 = k_1;
            float weight_1 = (WEIGHTS.inner[as_type<int>(as_type<uint>(_e81) - as_type<uint>(1))] * distance) * distance;
            Texel _e87 = center;
            metal::int2 _e88 = at;
            metal::float3 _e96 = neighbour(_e87, as_type<metal::int2>(as_type<metal::uint2>(_e88) + as_type<metal::uint2>(metal::int2(naga_neg(reach), 0))), metal::float2(-(distance), 0.0), normals, depths, curvature);
            Texel _e97 = center;
            metal::int2 _e98 = at;
            metal::float3 _e104 = neighbour(_e97, as_type<metal::int2>(as_type<metal::uint2>(_e98) + as_type<metal::uint2>(metal::int2(reach, 0))), metal::float2(distance, 0.0), normals, depths, curvature);
            Texel _e105 = center;
            metal::int2 _e106 = at;
            metal::float3 _e113 = neighbour(_e105, as_type<metal::int2>(as_type<metal::uint2>(_e106) + as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(up) * as_type<uint>(reach))))), metal::float2(0.0, distance), normals, depths, curvature);
            Texel _e114 = center;
            metal::int2 _e115 = at;
            metal::float3 _e123 = neighbour(_e114, as_type<metal::int2>(as_type<metal::uint2>(_e115) - as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(up) * as_type<uint>(reach))))), metal::float2(0.0, -(distance)), normals, depths, curvature);
            float _e125 = along_x.forward;
            along_x.forward = _e125 + (((weight_1 * _e104.z) * (_e104.x - _e42.x)) / distance);
            float _e135 = along_x.forward_weight;
            along_x.forward_weight = _e135 + (weight_1 * _e104.z);
            float _e140 = along_x.backward;
            along_x.backward = _e140 + (((weight_1 * _e96.z) * (_e42.x - _e96.x)) / distance);
            float _e150 = along_x.backward_weight;
            along_x.backward_weight = _e150 + (weight_1 * _e96.z);
            float _e155 = along_y.forward;
            along_y.forward = _e155 + (((weight_1 * _e113.z) * (_e113.y - _e42.y)) / distance);
            float _e165 = along_y.forward_weight;
            along_y.forward_weight = _e165 + (weight_1 * _e113.z);
            float _e170 = along_y.backward;
            along_y.backward = _e170 + (((weight_1 * _e123.z) * (_e42.y - _e123.y)) / distance);
            float _e180 = along_y.backward_weight;
            along_y.backward_weight = _e180 + (weight_1 * _e123.z);
        }
    }
    Sides _e187 = along_x;
    float _e188 = derivative(_e187);
    Sides _e189 = along_y;
    float _e190 = derivative(_e189);
    float _e196 = curvature.viewport_height;
    float kappa = (0.5 * (_e188 + _e190)) * _e196;
    return fs_mainOutput { metal::clamp(kappa, -10000.0, 10000.0) };
}
