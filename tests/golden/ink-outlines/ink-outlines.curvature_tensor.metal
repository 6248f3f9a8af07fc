// Ink outlines: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds curvature by direction from normals and depth.
// Arguments of both functions: surface texture(0), curvature buffer(0).
// ink-outlines.json says what to put there and how to draw.
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
struct SeenPixel {
    metal::int2 at;
    char _pad1[8];
    metal::float4 texel;
};
struct Plane {
    float object;
    float depth;
    metal::float2 rise;
    float tolerance;
    char _pad4[4];
};
struct Center {
    metal::int2 at;
    metal::float2 slope;
    Plane plane;
};
struct Ring {
    metal::float4 x;
    metal::float4 y;
    metal::float4 weights;
};

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

metal::float3 normal_of(
    metal::float4 texel
) {
    metal::float2 aside = 0.2 * texel.xy;
    float rest = metal::sqrt(metal::max(1.0 - metal::dot(aside, aside), 0.0));
    float nz = (texel.w < 0.0) ? -(rest) : rest;
    metal::float3 facing = metal::float3(texel.xy, 1.0) / metal::float3(metal::sqrt(1.0 + metal::dot(texel.xy, texel.xy)));
    return (nz >= 0.2) ? facing : metal::float3(aside, nz);
}

metal::float4 whole_picture(
    uint index_1
) {
    return metal::float4((static_cast<float>(index_1 & 1u) * 4.0) - 1.0, (static_cast<float>(index_1 >> 1u) * 4.0) - 1.0, 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int step_pixels(
    constant Curvature& curvature
) {
    float _e2 = curvature.viewport_height;
    return metal::max(naga_f2i32(metal::rint(_e2 / 800.0)), 1);
}

float row_direction(
    constant Curvature& curvature
) {
    float _e2 = curvature.rows_up;
    return (_e2 > 0.5) ? 1.0 : -1.0;
}

metal::int2 around(
    int index_2
) {
    int side = as_type<int>(as_type<uint>(1) - as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(index_2 & 1))));
    metal::int2 straight = (index_2 < 2) ? metal::int2(side, 0) : metal::int2(0, side);
    return (index_2 > 3) ? metal::int2(side, as_type<int>(as_type<uint>(1) - as_type<uint>(index_2 & 2))) : straight;
}

SeenPixel seen_pixel(
    metal::int2 pixel,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    SeenPixel seen = {};
    bool local = {};
    int index_3 = {};
    metal::float4 _e3 = surface.read(metal::uint2(pixel), 0);
    seen = SeenPixel {pixel, {}, _e3};
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    float _e14 = curvature.samples;
    if (_e14 >= 2.0) {
        float _e21 = seen.texel.w;
        local = _e21 == 0.0;
    } else {
        local = false;
    }
    bool may_be_missed = local;
    index_3 = may_be_missed ? 7 : -1;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e47 = index_3;
            index_3 = as_type<int>(as_type<uint>(_e47) - as_type<uint>(1));
        }
        loop_init = false;
        int _e30 = index_3;
        if (_e30 >= 0) {
        } else {
            break;
        }
        {
            int _e33 = index_3;
            metal::int2 _e34 = around(_e33);
            metal::int2 near = metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel) + as_type<metal::uint2>(_e34)), metal::int2(0), last);
            metal::float4 texel_1 = surface.read(metal::uint2(near), 0);
            if (texel_1.w != 0.0) {
                seen = SeenPixel {near, {}, texel_1};
            }
        }
    }
    SeenPixel _e49 = seen;
    return _e49;
}

Plane plane_of(
    float object,
    float depth_1,
    metal::float3 normal_2,
    constant Curvature& curvature
) {
    float _e5 = curvature.pixel;
    float _e8 = curvature.perspective;
    float pixel_2 = _e5 * metal::mix(1.0, depth_1, _e8);
    metal::float2 gradient = normal_2.xy / metal::float2(metal::max(normal_2.z, 0.02));
    float _e19 = row_direction(curvature);
    return Plane {object, depth_1, (pixel_2 * gradient) * metal::float2(1.0, _e19), (2.0 * pixel_2) * (1.0 + metal::length(gradient))};
}

metal::float4 neighbor_weights(
    Plane plane,
    metal::float4 objects,
    metal::float4 depths,
    metal::float4 rises,
    float distance
) {
    metal::float4 error = metal::abs((depths - metal::float4(plane.depth)) - rises);
    float scale = 1.0 / metal::max(plane.tolerance * distance, 0.000000000000000000000000000001);
    metal::float4 weights_1 = metal::clamp(metal::float4(2.0) - (error * scale), metal::float4(0.0), metal::float4(1.0));
    return metal::select(metal::float4(0.0), weights_1, objects == metal::float4(plane.object));
}

Center center_at(
    metal::int2 pixel_1,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    SeenPixel _e1 = seen_pixel(pixel_1, surface, curvature);
    metal::float4 texel_2 = _e1.texel;
    metal::float3 _e8 = normal_of(texel_2);
    Plane _e9 = plane_of(metal::abs(_e1.texel.w), _e1.texel.z, _e8, curvature);
    return Center {_e1.at, texel_2.xy, _e9};
}

Ring ring_at(
    Center center,
    int steps,
    float weight,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    int _e3 = step_pixels(curvature);
    int reach = as_type<int>(as_type<uint>(steps) * as_type<uint>(_e3));
    float distance_1 = static_cast<float>(reach);
    metal::int2 at = center.at;
    metal::int2 last_1 = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 a_1 = surface.read(metal::uint2(metal::int2(metal::min(as_type<int>(as_type<uint>(center.at.x) + as_type<uint>(reach)), last_1.x), center.at.y)), 0);
    metal::float4 b_1 = surface.read(metal::uint2(metal::int2(metal::max(as_type<int>(as_type<uint>(center.at.x) - as_type<uint>(reach)), 0), center.at.y)), 0);
    metal::float4 c = surface.read(metal::uint2(metal::int2(center.at.x, metal::min(as_type<int>(as_type<uint>(center.at.y) + as_type<uint>(reach)), last_1.y))), 0);
    metal::float4 d = surface.read(metal::uint2(metal::int2(center.at.x, metal::max(as_type<int>(as_type<uint>(center.at.y) - as_type<uint>(reach)), 0))), 0);
    metal::bool4 is_inside = metal::int4(as_type<int>(as_type<uint>(last_1.x) - as_type<uint>(center.at.x)), center.at.x, as_type<int>(as_type<uint>(last_1.y) - as_type<uint>(center.at.y)), center.at.y) >= metal::int4(reach);
    metal::float4 objects_1 = metal::select(metal::float4(0.0), metal::abs(metal::float4(a_1.w, b_1.w, c.w, d.w)), is_inside);
    metal::float2 rise = distance_1 * center.plane.rise;
    metal::float4 rises_1 = metal::float4(rise.x, -(rise.x), rise.y, -(rise.y));
    metal::float4 _e86 = neighbor_weights(center.plane, objects_1, metal::float4(a_1.z, b_1.z, c.z, d.z), rises_1, distance_1);
    metal::float4 shares = (weight * distance_1) * _e86;
    return Ring {shares * (metal::float4(a_1.x, b_1.x, c.x, d.x) - metal::float4(center.slope.x)), shares * (metal::float4(a_1.y, b_1.y, c.y, d.y) - metal::float4(center.slope.y)), shares * distance_1};
}

Ring joined(
    Ring a,
    Ring b
) {
    return Ring {a.x + b.x, a.y + b.y, a.weights + b.weights};
}

Ring rings_at(
    Center center_1,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    Ring _e3 = ring_at(center_1, 1, 1.0, surface, curvature);
    Ring _e6 = ring_at(center_1, 2, 0.85, surface, curvature);
    Ring _e7 = joined(_e3, _e6);
    Ring _e10 = ring_at(center_1, 3, 0.5, surface, curvature);
    Ring _e11 = joined(_e7, _e10);
    return _e11;
}

metal::float2 derivatives(
    metal::float4 changes,
    metal::float4 weights,
    constant Curvature& curvature
) {
    metal::float4 trust = metal::smoothstep(metal::float4(0.0), metal::float4(0.5), weights);
    metal::float4 sides = (changes / metal::max(weights, metal::float4(0.000001))) * trust;
    metal::float2 along = (sides.xz - sides.yw) / metal::max(trust.xz + trust.yw, metal::float2(0.000001));
    float _e22 = row_direction(curvature);
    return along * metal::float2(1.0, _e22);
}

float mean_curvature(
    Ring ring,
    constant Curvature& curvature
) {
    metal::float2 _e7 = derivatives(metal::float4(ring.x.xy, ring.y.zw), ring.weights, curvature);
    float _e15 = curvature.viewport_height;
    return metal::clamp((0.5 * (_e7.x + _e7.y)) * _e15, -10000.0, 10000.0);
}

metal::float3 curvature_tensor(
    Ring ring_1,
    constant Curvature& curvature
) {
    metal::float2 _e3 = derivatives(ring_1.x, ring_1.weights, curvature);
    metal::float2 _e6 = derivatives(ring_1.y, ring_1.weights, curvature);
    float _e17 = curvature.viewport_height;
    metal::float3 tensor = metal::float3(_e3.x, 0.5 * (_e6.x + _e3.y), _e6.y) * _e17;
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
, metal::texture2d<float, metal::access::sample> surface [[texture(0)]]
, constant Curvature& curvature [[buffer(0)]]
) {
    Center _e3 = center_at(naga_f2i32(position.xy), surface, curvature);
    if (_e3.plane.object == 0.0) {
        return fs_mainOutput { metal::float4(0.0) };
    }
    Ring _e10 = rings_at(_e3, surface, curvature);
    metal::float3 _e11 = curvature_tensor(_e10, curvature);
    return fs_mainOutput { metal::float4(_e11, 1.0) };
}
