// Warped light: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds curvature by direction from normals and depth.
// Arguments of both functions: normals texture(0), depths texture(1), curvature buffer(0).
// warped-light.json says what to put there and how to draw.
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
    float samples;
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
struct SideDifferences {
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

metal::float3 neighbor(
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
    float pixel_3 = _e11 * metal::mix(1.0, center.depth, _e15);
    metal::float2 gradient = -(metal::float3(center.normal).xy) / metal::float2(metal::max(center.normal[2], 0.02));
    float expected = metal::dot(gradient, offset) * pixel_3;
    float error = metal::abs((center.depth - _e3.depth) - expected);
    float tolerance = ((2.0 * pixel_3) * metal::length(offset)) * (1.0 + metal::length(gradient));
    float weight_1 = metal::clamp(2.0 - (error / metal::max(tolerance, 0.000000000000000000000000000001)), 0.0, 1.0);
    metal::float2 _e52 = slope(_e3.normal);
    return metal::float3(_e52, weight_1);
}

float derivative(
    SideDifferences sides
) {
    float forward_1 = sides.forward / metal::max(sides.forward_weight, 0.000001);
    float backward_1 = sides.backward / metal::max(sides.backward_weight, 0.000001);
    metal::float2 trust = metal::float2(metal::smoothstep(0.0, 0.5, sides.forward_weight), metal::smoothstep(0.0, 0.5, sides.backward_weight));
    return ((forward_1 * trust.x) + (backward_1 * trust.y)) / metal::max(trust.x + trust.y, 0.000001);
}

metal::float4 whole_picture(
    uint index_1
) {
    return metal::float4((static_cast<float>(index_1 & 1u) * 4.0) - 1.0, (static_cast<float>(index_1 >> 1u) * 4.0) - 1.0, 0.0, 1.0);
}

metal::int2 covered_near(
    metal::int2 pixel,
    metal::texture2d<float, metal::access::sample> normals
) {
    metal::int2 found = {};
    int k = 7;
    metal::int2 most = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(normals.get_width(), normals.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    found = pixel;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e27 = k;
            k = as_type<int>(as_type<uint>(_e27) - as_type<uint>(1));
        }
        loop_init = false;
        int _e10 = k;
        if (_e10 >= 0) {
        } else {
            break;
        }
        {
            int _e14 = k;
            metal::int2 near = metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel) + as_type<metal::uint2>(RING.inner[_e14])), metal::int2(0), most);
            metal::float4 _e22 = normals.read(metal::uint2(near), 0);
            if (_e22.w != 0.0) {
                found = near;
            }
        }
    }
    metal::int2 _e29 = found;
    return _e29;
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_neg(int val) {
    return as_type<int>(-as_type<uint>(val));
}

float curvature_at(
    metal::int2 pixel_1,
    int first,
    int last,
    metal::texture2d<float, metal::access::sample> normals,
    metal::texture2d<float, metal::access::sample> depths,
    constant Curvature& curvature
) {
    metal::int2 at_2 = {};
    Texel center_1 = {};
    SideDifferences along_x = SideDifferences {0.0, 0.0, 0.0, 0.0};
    SideDifferences along_y = SideDifferences {0.0, 0.0, 0.0, 0.0};
    int k_1 = {};
    at_2 = pixel_1;
    metal::int2 _e4 = at_2;
    Texel _e5 = texel(_e4, normals, depths);
    center_1 = _e5;
    float _e8 = center_1.object;
    if (_e8 == 0.0) {
        float _e13 = curvature.samples;
        if (_e13 < 2.0) {
            return 0.0;
        }
        metal::int2 _e17 = covered_near(pixel_1, normals);
        at_2 = _e17;
        metal::int2 _e18 = at_2;
        Texel _e19 = texel(_e18, normals, depths);
        center_1 = _e19;
        float _e21 = center_1.object;
        if (_e21 == 0.0) {
            return 0.0;
        }
    }
    metal::float3 _e26 = center_1.normal;
    metal::float2 _e27 = slope(_e26);
    float _e42 = curvature.rows_up;
    int up = (_e42 > 0.5) ? 1 : -1;
    float _e50 = curvature.viewport_height;
    int stride = metal::max(naga_f2i32(metal::rint(_e50 / 800.0)), 1);
    k_1 = first;
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e168 = k_1;
            k_1 = as_type<int>(as_type<uint>(_e168) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e58 = k_1;
        if (_e58 <= last) {
        } else {
            break;
        }
        {
            int _e60 = k_1;
            int reach = as_type<int>(as_type<uint>(_e60) * as_type<uint>(stride));
            float distance = static_cast<float>(reach);
            int _e64 = k_1;
            float weight_2 = (WEIGHTS.inner[as_type<int>(as_type<uint>(_e64) - as_type<uint>(1))] * distance) * distance;
            Texel _e70 = center_1;
            metal::int2 _e71 = at_2;
            metal::float3 _e79 = neighbor(_e70, as_type<metal::int2>(as_type<metal::uint2>(_e71) + as_type<metal::uint2>(metal::int2(naga_neg(reach), 0))), metal::float2(-(distance), 0.0), normals, depths, curvature);
            Texel _e80 = center_1;
            metal::int2 _e81 = at_2;
            metal::float3 _e87 = neighbor(_e80, as_type<metal::int2>(as_type<metal::uint2>(_e81) + as_type<metal::uint2>(metal::int2(reach, 0))), metal::float2(distance, 0.0), normals, depths, curvature);
            Texel _e88 = center_1;
            metal::int2 _e89 = at_2;
            metal::float3 _e96 = neighbor(_e88, as_type<metal::int2>(as_type<metal::uint2>(_e89) + as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(up) * as_type<uint>(reach))))), metal::float2(0.0, distance), normals, depths, curvature);
            Texel _e97 = center_1;
            metal::int2 _e98 = at_2;
            metal::float3 _e106 = neighbor(_e97, as_type<metal::int2>(as_type<metal::uint2>(_e98) - as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(up) * as_type<uint>(reach))))), metal::float2(0.0, -(distance)), normals, depths, curvature);
            float _e108 = along_x.forward;
            along_x.forward = _e108 + (((weight_2 * _e87.z) * (_e87.x - _e27.x)) / distance);
            float _e118 = along_x.forward_weight;
            along_x.forward_weight = _e118 + (weight_2 * _e87.z);
            float _e123 = along_x.backward;
            along_x.backward = _e123 + (((weight_2 * _e79.z) * (_e27.x - _e79.x)) / distance);
            float _e133 = along_x.backward_weight;
            along_x.backward_weight = _e133 + (weight_2 * _e79.z);
            float _e138 = along_y.forward;
            along_y.forward = _e138 + (((weight_2 * _e96.z) * (_e96.y - _e27.y)) / distance);
            float _e148 = along_y.forward_weight;
            along_y.forward_weight = _e148 + (weight_2 * _e96.z);
            float _e153 = along_y.backward;
            along_y.backward = _e153 + (((weight_2 * _e106.z) * (_e27.y - _e106.y)) / distance);
            float _e163 = along_y.backward_weight;
            along_y.backward_weight = _e163 + (weight_2 * _e106.z);
        }
    }
    SideDifferences _e170 = along_x;
    float _e171 = derivative(_e170);
    SideDifferences _e172 = along_y;
    float _e173 = derivative(_e172);
    float _e179 = curvature.viewport_height;
    float kappa = (0.5 * (_e171 + _e173)) * _e179;
    return metal::clamp(kappa, -10000.0, 10000.0);
}

metal::float3 slope_change(
    Texel center_2,
    metal::float2 here,
    metal::int2 at_3,
    metal::float2 offset_1,
    float weight,
    metal::texture2d<float, metal::access::sample> normals,
    metal::texture2d<float, metal::access::sample> depths,
    constant Curvature& curvature
) {
    metal::float3 _e5 = neighbor(center_2, at_3, offset_1, normals, depths, curvature);
    float sign = ((offset_1.x + offset_1.y) > 0.0) ? 1.0 : -1.0;
    return (weight * _e5.z) * metal::float3((sign * (_e5.xy - here)) / metal::float2(metal::length(offset_1)), 1.0);
}

metal::float2 slope_derivative(
    metal::float3 forward,
    metal::float3 backward
) {
    float _e7 = derivative(SideDifferences {forward.x, forward.z, backward.x, backward.z});
    float _e13 = derivative(SideDifferences {forward.y, forward.z, backward.y, backward.z});
    return metal::float2(_e7, _e13);
}

metal::float3 tensor_at(
    metal::int2 pixel_2,
    metal::texture2d<float, metal::access::sample> normals,
    metal::texture2d<float, metal::access::sample> depths,
    constant Curvature& curvature
) {
    metal::int2 at_4 = {};
    Texel center_3 = {};
    metal::float3 right = metal::float3(0.0);
    metal::float3 left = metal::float3(0.0);
    metal::float3 above = metal::float3(0.0);
    metal::float3 below = metal::float3(0.0);
    int k_2 = 1;
    at_4 = pixel_2;
    metal::int2 _e2 = at_4;
    Texel _e3 = texel(_e2, normals, depths);
    center_3 = _e3;
    float _e6 = center_3.object;
    if (_e6 == 0.0) {
        float _e11 = curvature.samples;
        if (_e11 < 2.0) {
            return metal::float3(0.0);
        }
        metal::int2 _e16 = covered_near(pixel_2, normals);
        at_4 = _e16;
        metal::int2 _e17 = at_4;
        Texel _e18 = texel(_e17, normals, depths);
        center_3 = _e18;
        float _e20 = center_3.object;
        if (_e20 == 0.0) {
            return metal::float3(0.0);
        }
    }
    metal::float3 _e26 = center_3.normal;
    metal::float2 _e27 = slope(_e26);
    float _e30 = curvature.rows_up;
    int up_1 = (_e30 > 0.5) ? 1 : -1;
    float _e38 = curvature.viewport_height;
    int stride_1 = metal::max(naga_f2i32(metal::rint(_e38 / 800.0)), 1);
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e117 = k_2;
            k_2 = as_type<int>(as_type<uint>(_e117) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e59 = k_2;
        if (_e59 <= 3) {
        } else {
            break;
        }
        {
            int _e62 = k_2;
            int reach_1 = as_type<int>(as_type<uint>(_e62) * as_type<uint>(stride_1));
            float distance_1 = static_cast<float>(reach_1);
            int _e66 = k_2;
            float weight_3 = (WEIGHTS.inner[as_type<int>(as_type<uint>(_e66) - as_type<uint>(1))] * distance_1) * distance_1;
            metal::float3 _e72 = right;
            Texel _e73 = center_3;
            metal::int2 _e74 = at_4;
            metal::float3 _e80 = slope_change(_e73, _e27, as_type<metal::int2>(as_type<metal::uint2>(_e74) + as_type<metal::uint2>(metal::int2(reach_1, 0))), metal::float2(distance_1, 0.0), weight_3, normals, depths, curvature);
            right = _e72 + _e80;
            metal::float3 _e82 = left;
            Texel _e83 = center_3;
            metal::int2 _e84 = at_4;
            metal::float3 _e91 = slope_change(_e83, _e27, as_type<metal::int2>(as_type<metal::uint2>(_e84) - as_type<metal::uint2>(metal::int2(reach_1, 0))), metal::float2(-(distance_1), 0.0), weight_3, normals, depths, curvature);
            left = _e82 + _e91;
            metal::float3 _e93 = above;
            Texel _e94 = center_3;
            metal::int2 _e95 = at_4;
            metal::float3 _e102 = slope_change(_e94, _e27, as_type<metal::int2>(as_type<metal::uint2>(_e95) + as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(up_1) * as_type<uint>(reach_1))))), metal::float2(0.0, distance_1), weight_3, normals, depths, curvature);
            above = _e93 + _e102;
            metal::float3 _e104 = below;
            Texel _e105 = center_3;
            metal::int2 _e106 = at_4;
            metal::float3 _e114 = slope_change(_e105, _e27, as_type<metal::int2>(as_type<metal::uint2>(_e106) - as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(up_1) * as_type<uint>(reach_1))))), metal::float2(0.0, -(distance_1)), weight_3, normals, depths, curvature);
            below = _e104 + _e114;
        }
    }
    metal::float3 _e119 = right;
    metal::float3 _e120 = left;
    metal::float2 _e121 = slope_derivative(_e119, _e120);
    metal::float3 _e122 = above;
    metal::float3 _e123 = below;
    metal::float2 _e124 = slope_derivative(_e122, _e123);
    float _e135 = curvature.viewport_height;
    metal::float3 tensor = metal::float3(_e121.x, 0.5 * (_e121.y + _e124.x), _e124.y) * _e135;
    return metal::clamp(tensor, metal::float3(-10000.0), metal::float3(10000.0));
}

struct vs_mainInput {
};
struct vs_mainOutput {
    metal::float4 member [[position]];
};
vertex vs_mainOutput vs_main(
  uint index [[vertex_id]]
) {
    metal::float4 _e1 = whole_picture(index);
    return vs_mainOutput { _e1 };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  metal::float4 position [[position]]
, metal::texture2d<float, metal::access::sample> normals [[texture(0)]]
, metal::texture2d<float, metal::access::sample> depths [[texture(1)]]
, constant Curvature& curvature [[buffer(0)]]
) {
    metal::float3 _e3 = tensor_at(naga_f2i32(position.xy), normals, depths, curvature);
    return fs_mainOutput { metal::float4(_e3, 1.0) };
}
