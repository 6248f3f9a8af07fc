// Anime face: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds curvature from normals and depth.
// Arguments of both functions: surface texture(0), curvature buffer(0).
// anime-face.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct Curvature {
    /// The size of a pixel in scene units: at depth 1 for perspective, at every depth for parallel
    /// projection.
    float pixel;
    /// 1 for perspective, 0 for parallel projection.
    float perspective;
    /// Height of the picture, in pixels.
    float viewport_height;
    /// 1 where the first row of an image is at the bottom of the picture (OpenGL), 0 where it is at
    /// the top.
    float rows_up;
    /// Samples per pixel of the picture.
    float samples;
};

/// A pixel and its texel of the surface.
struct SeenPixel {
    metal::int2 at;
    char _pad1[8];
    metal::float4 texel;
};

/// The plane of the surface at a pixel: it tells which neighbors lie on the same surface. Changes
/// of depth are along columns and rows of the image.
struct Plane {
    float object;
    float depth;
    /// Change of depth from a pixel to the next.
    metal::float2 rise;
    /// Tolerated difference of a neighbor's depth, for each pixel that the neighbor is away.
    float tolerance;
    char _pad4[4];
};

/// A pixel whose curvature is measured.
struct Center {
    metal::int2 at;
    metal::float2 slope;
    Plane plane;
};

/// Neighbors on the four sides of a center: in the column after it, in the column before it, in the
/// row after it, and in the row before it.
struct Ring {
    /// Weighted changes of slope.x from the center.
    metal::float4 x;
    /// Weighted changes of slope.y from the center.
    metal::float4 y;
    metal::float4 weights;
};

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

/// The number of an object in texels, from 1 on.
float object_number(
    float object
) {
    return object - 4096.0 * metal::floor(object / 4096.0) + 1.0;
}

/// The number of a facet for [`surface_texel`]: the object's, from 1 on, and what materials and
/// ids add, less than 1. `id` is rounded to a whole number; what is none, or beyond a million, is
/// 0.
float facet_number(
    float object,
    float material,
    float id
) {
    float whole = metal::rint(metal::abs(id) <= 1000000.0 ? id : 0.0);
    float parts = 128.0 * (material - 32.0 * metal::floor(material / 32.0)) + whole - 128.0
        * metal::floor(whole / 128.0);
    return object_number(object) + parts / 4096.0;
}

/// The normal that a texel was made from.
metal::float3 normal_of(
    metal::float4 texel
) {
    // Below LEAST_NZ the slope is n.xy by a constant, and n.z is what is left of the length 1;
    // elsewhere that is no less than LEAST_NZ, and the normal points along the slope and 1.
    metal::float2 aside = 0.2 * texel.xy;
    float rest = metal::sqrt(metal::max(1.0 - metal::dot(aside, aside), 0.0));
    float nz = texel.w < 0.0 ? -rest : rest;
    metal::float3 facing = metal::float3(texel.xy, 1.0)
        / metal::float3(metal::sqrt(1.0 + metal::dot(texel.xy, texel.xy)));
    return nz >= 0.2 ? facing : metal::float3(aside, nz);
}

/// A triangle over the whole picture.
metal::float4 whole_picture(
    uint index
) {
    return metal::float4(static_cast<float>(index & 1u) * 4.0 - 1.0,
        static_cast<float>(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// A step in pixels: a share of the picture's height, so that a larger picture measures the same
/// curvature, not a finer one.
int step_pixels(
    constant Curvature& curvature
) {
    return metal::max(naga_f2i32(metal::rint(curvature.viewport_height / 800.0)), 1);
}

/// 1 where a row of the image lies above the row before it, -1 where it lies below.
float row_direction(
    constant Curvature& curvature
) {
    return curvature.rows_up > 0.5 ? 1.0 : -1.0;
}

/// Offset to one of the eight pixels around a pixel, by an index from 0 to 7; the nearest first.
metal::int2 around(
    int index
) {
    int side = as_type<int>(as_type<uint>(1)
        - as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(index & 1))));
    metal::int2 straight = index < 2 ? metal::int2(side, 0) : metal::int2(0, side);
    return index > 3 ? metal::int2(side,
        as_type<int>(as_type<uint>(1) - as_type<uint>(index & 2))) : straight;
}

/// The pixel whose surface a pixel has: its own, or that of a neighbor.
///
/// With several samples a pixel, a look also shades pixels whose middle the object just misses:
/// they have the surface of the nearest of the eight pixels around that shows one.
SeenPixel seen_pixel(
    metal::int2 pixel,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    SeenPixel seen = {};
    bool local = {};
    seen = SeenPixel {pixel, {}, surface.read(metal::uint2(pixel), 0)};
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(),
        surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    if (curvature.samples >= 2.0) {
        local = seen.texel.w == 0.0;
    } else {
        local = false;
    }
    bool may_be_missed = local;
    for (int index = may_be_missed ? 7 : -1; index >= 0; index--) {
        metal::int2 around_value = around(index);
        metal::int2 near = metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel)
            + as_type<metal::uint2>(around_value)), metal::int2(0), last);
        metal::float4 texel = surface.read(metal::uint2(near), 0);
        if (texel.w != 0.0) {
            seen = SeenPixel {near, {}, texel};
        }
    }
    return seen;
}

Plane plane_of(
    float object,
    float depth,
    metal::float3 normal,
    constant Curvature& curvature
) {
    float pixel = curvature.pixel * metal::mix(1.0, depth, curvature.perspective);
    metal::float2 gradient = normal.xy / metal::float2(metal::max(normal.z, 0.02));
    float row_direction_value = row_direction(curvature);
    return Plane {object, depth, pixel * gradient * metal::float2(1.0, row_direction_value), 2.0
        * pixel * (1.0 + metal::length(gradient))};
}

/// Weights of four neighbors that are `distance` pixels away, 0 to 1, by their objects, their
/// depths, and the rises of depth to them on the plane.
metal::float4 neighbor_weights(
    Plane plane,
    metal::float4 objects,
    metal::float4 depths,
    metal::float4 rises,
    float distance
) {
    metal::float4 error = metal::abs(depths - metal::float4(plane.depth) - rises);
    float scale = 1.0 / metal::max(plane.tolerance * distance, 0.000000000000000000000000000001);
    // The weight fades, so that the last bit of a depth does not decide between all and nothing.
    metal::float4 weights = metal::clamp(metal::float4(2.0) - error * scale, metal::float4(0.0),
        metal::float4(1.0));
    return metal::select(metal::float4(0.0), weights, objects == metal::float4(plane.object));
}

/// The center for a pixel; its object is 0 where there is none.
Center center_at(
    metal::int2 pixel,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    SeenPixel seen = seen_pixel(pixel, surface, curvature);
    metal::float4 texel = seen.texel;
    return Center {seen.at, texel.xy,
        plane_of(metal::abs(seen.texel.w), seen.texel.z, normal_of(texel), curvature)};
}

/// The ring that is so many steps away, with its weight.
Ring ring_at(
    Center center,
    int steps,
    float weight,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    int reach = as_type<int>(as_type<uint>(steps) * as_type<uint>(step_pixels(curvature)));
    float distance = static_cast<float>(reach);
    metal::int2 at = center.at;
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(),
        surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 a = surface.read(metal::uint2(metal::int2(metal::min(as_type<int>(as_type<uint>(center.at.x) + as_type<uint>(reach)),
        last.x), center.at.y)), 0);
    metal::float4 b = surface.read(metal::uint2(metal::int2(metal::max(as_type<int>(as_type<uint>(center.at.x) - as_type<uint>(reach)),
        0), center.at.y)), 0);
    metal::float4 c = surface.read(metal::uint2(metal::int2(center.at.x,
        metal::min(as_type<int>(as_type<uint>(center.at.y) + as_type<uint>(reach)), last.y))), 0);
    metal::float4 d = surface.read(metal::uint2(metal::int2(center.at.x,
        metal::max(as_type<int>(as_type<uint>(center.at.y) - as_type<uint>(reach)), 0))), 0);
    // Beyond the image nothing is.
    metal::bool4 is_inside = metal::int4(as_type<int>(as_type<uint>(last.x)
        - as_type<uint>(center.at.x)), center.at.x,
        as_type<int>(as_type<uint>(last.y) - as_type<uint>(center.at.y)), center.at.y)
        >= metal::int4(reach);
    metal::float4 objects = metal::select(metal::float4(0.0),
        metal::abs(metal::float4(a.w, b.w, c.w, d.w)), is_inside);
    metal::float2 rise = distance * center.plane.rise;
    metal::float4 rises = metal::float4(rise.x, -rise.x, rise.y, -rise.y);
    metal::float4 neighbor_weights_value = neighbor_weights(center.plane, objects,
        metal::float4(a.z, b.z, c.z, d.z), rises, distance);
    metal::float4 shares = weight * distance * neighbor_weights_value;
    return Ring {shares * (metal::float4(a.x, b.x, c.x, d.x) - metal::float4(center.slope.x)),
        shares * (metal::float4(a.y, b.y, c.y, d.y) - metal::float4(center.slope.y)), shares
        * distance};
}

/// Two rings as one.
Ring joined(
    Ring a,
    Ring b
) {
    return Ring {a.x + b.x, a.y + b.y, a.weights + b.weights};
}

/// The twelve neighbors one, two and three steps away.
Ring rings_at(
    Center center,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    Ring near = joined(ring_at(center, 1, 1.0, surface, curvature),
        ring_at(center, 2, 0.85, surface, curvature));
    return joined(near, ring_at(center, 3, 0.5, surface, curvature));
}

/// The derivatives along x and y, camera axes, from weighted changes to the four sides, as far as
/// each side counts; 0 where none does.
metal::float2 derivatives(
    metal::float4 changes,
    metal::float4 weights,
    constant Curvature& curvature
) {
    // A side that hardly counts any more is left to the other one, gradually.
    metal::float4 trust = metal::smoothstep(metal::float4(0.0), metal::float4(0.5), weights);
    metal::float4 sides = changes / metal::max(weights, metal::float4(0.000001)) * trust;
    metal::float2 along = (sides.xz - sides.yw)
        / metal::max(trust.xz + trust.yw, metal::float2(0.000001));
    return along * metal::float2(1.0, row_direction(curvature));
}

/// Mean curvature from the neighbors.
float mean_curvature(
    Ring ring,
    constant Curvature& curvature
) {
    metal::float2 along = derivatives(metal::float4(ring.x.xy, ring.y.zw), ring.weights, curvature);
    return metal::clamp(0.5 * (along.x + along.y) * curvature.viewport_height, -10000.0, 10000.0);
}

struct vs_mainInput {
};

struct vs_mainOutput {
    metal::float4 member [[position]];
};

vertex vs_mainOutput vs_main(
  uint index [[vertex_id]]
) {
    return vs_mainOutput { whole_picture(index) };
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
, metal::texture2d<float, metal::access::sample> surface [[texture(0)]]
, constant Curvature& curvature [[buffer(0)]]
) {
    Center center = center_at(naga_f2i32(position.xy), surface, curvature);
    if (center.plane.object == 0.0) {
        return fs_mainOutput { 0.0 };
    }
    return fs_mainOutput { mean_curvature(rings_at(center, surface, curvature), curvature) };
}
