// Ink outlines: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds where surfaces end, fold and meet.
// Arguments of both functions: surface texture(0), curvature buffer(0).
// ink-outlines.json says what to put there and how to draw.
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

/// Edges of four kinds: the unit normals of straight lines, and how far along them the lines lie,
/// in pixels of the image.
struct EdgeLines {
    metal::float4 x;
    metal::float4 y;
    metal::float4 offset;
};

/// What a pixel shows: a piece of a surface.
struct Facet {
    /// Unit, in camera axes.
    metal::float3 normal;
    /// Toward the eye in camera axes, of a length of 1 and more.
    metal::packed_float3 toward;
    float depth;
    /// The texel's number: the object's, the material's and the id's.
    float number;
    char _pad4[4];
    /// Change of depth from a pixel to the next, along columns and rows.
    metal::float2 rise;
    /// The same where the surface is not seen as steeply: at least LEAST_NZ of it faces the eye.
    metal::float2 gentle_rise;
    char _pad6[8];
};

/// A piece of an edge: its kind, the unit normal of a straight line in pixels of the image, and how
/// far along it from the pixel's middle the line lies.
struct Edge {
    int kind;
    char _pad1[4];
    metal::float2 normal;
    float offset;
    /// How well the line is known, 0 to 1: little where it runs along the way to the neighbor.
    float trust;
};

/// The course of an edge past a pixel: how far beyond the pixel's middle it lies, 0 to 1, and how
/// far that changes from one pixel to the next along it.
struct Course {
    float place;
    float slope;
    /// Share of the rows nearby over which it was followed.
    float trust;
};

/// Sums over the rows of a course, to fit a line and a parabola: x is how far along a row lies, y
/// how far beyond the pixel's middle the edge lies there.
struct CourseSums {
    float count;
    float x;
    float y;
    float xx;
    float xy;
    float yy;
    float xxy;
};

struct type_10 {
    metal::float2 inner[2];
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

/// The number of the object in a texel's number, from 1 on; 0 where nothing is.
float object_in(
    float number
) {
    return metal::floor(metal::abs(number));
}

/// The number of the material in a texel's number, from 0 on.
float material_in(
    float number
) {
    return metal::floor(metal::fract(metal::abs(number)) * 32.0);
}

/// The fine code of an edge by its unit normal and its offset, less than 2 pixels; never 0.
float edge_code(
    metal::float2 normal,
    float offset
) {
    float share = normal.x / metal::max(metal::abs(normal.x) + metal::abs(normal.y),
        0.00000000000000000001);
    float turn = normal.y >= 0.0 ? 1.0 - share : 3.0 + share;
    float direction = metal::min(metal::floor(turn * 1024.0), 4095.0);
    float place = metal::floor((metal::clamp(offset, -1.99, 1.99) + 2.0) * 1024.0);
    return place * 4096.0 + direction;
}

/// Codes of few levels from fine ones.
metal::float4 coarse_codes(
    metal::float4 codes
) {
    metal::float4 place = metal::floor(codes / metal::float4(4096.0));
    metal::float4 direction = codes - 4096.0 * place;
    return metal::floor(place * 0.125) * 512.0 + metal::floor(direction * 0.125);
}

/// The edges that codes of so many levels say, each 0 or more.
EdgeLines edges_of(
    metal::float4 codes,
    float levels
) {
    metal::float4 place = metal::floor(codes / metal::float4(levels));
    metal::float4 turn = (codes - levels * place + metal::float4(0.5)) * (4.0 / levels);
    metal::bool4 is_back = turn >= metal::float4(2.0);
    metal::float4 x = metal::select(metal::float4(1.0) - turn, turn - metal::float4(3.0), is_back);
    metal::float4 rest = metal::float4(1.0) - metal::abs(x);
    metal::float4 y = metal::select(rest, -rest, is_back);
    metal::float4 size = metal::sqrt(x * x + y * y);
    return EdgeLines {x / size, y / size, (place + metal::float4(0.5)) * (4.0 / levels)
        - metal::float4(2.0)};
}

/// Distances in pixels between a pixel and the middles of the pieces of edges, by the places of the
/// edges' pixels from it: they tell which piece is the nearest, whichever way it leans. The first
/// edge is a silhouette, which counts on its inner side alone unless `beyond` says both: outside it
/// is [`FAR`].
metal::float4 middle_distances(
    EdgeLines edges,
    metal::float4 columns,
    metal::float4 rows,
    bool beyond
) {
    bool local_1 = {};
    metal::float4 x = columns + edges.x * edges.offset;
    metal::float4 y = rows + edges.y * edges.offset;
    float inward = x.x * edges.x.x + y.x * edges.y.x;
    metal::float4 distances = metal::sqrt(x * x + y * y);
    if (inward < -1.0) {
        local_1 = !beyond;
    } else {
        local_1 = false;
    }
    return metal::float4(local_1 ? 1000000000.0 : distances.x, distances.yzw);
}

/// Distances in pixels between a pixel and the nearest pieces of edges, by the places of the edges'
/// pixels from it. The first is a silhouette, and 0 away beyond it, where a pixel is only touched,
/// unless `beyond` pixels count as those within do.
metal::float4 edge_distances(
    EdgeLines edges,
    metal::float4 columns,
    metal::float4 rows,
    bool beyond
) {
    metal::float4 across = edges.offset + edges.x * columns + edges.y * rows;
    metal::float4 along = metal::abs(edges.y * columns - edges.x * rows);
    // What is farther along than the edge's own pixel lies beyond the edge's end.
    metal::float4 past = metal::max(along - metal::float4(1.0), metal::float4(0.0));
    float inner = beyond ? metal::abs(across.x) : metal::max(across.x, 0.0);
    metal::float4 side = metal::float4(inner, metal::abs(across.yzw));
    return metal::sqrt(side * side + past * past);
}

/// Size in scene units of a pixel at a depth.
float pixel_size_at(
    float depth,
    constant Curvature& curvature
) {
    return curvature.pixel * metal::mix(1.0, depth, curvature.perspective);
}

Facet facet_at(
    metal::int2 at,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    metal::float4 texel = surface.read(metal::uint2(at), 0);
    metal::float3 normal = normal_of(texel);
    metal::float2 middle = 0.5 * static_cast<metal::float2>(metal::uint2(surface.get_width(),
        surface.get_height()));
    float row_direction_value = row_direction(curvature);
    metal::float2 from_middle = (static_cast<metal::float2>(at) + metal::float2(0.5) - middle)
        * metal::float2(1.0, row_direction_value);
    metal::float3 toward = metal::float3(-curvature.pixel * curvature.perspective * from_middle,
        1.0);
    float facing = metal::dot(normal, toward);
    metal::float2 change = pixel_size_at(texel.z, curvature) * normal.xy
        * metal::float2(1.0, row_direction(curvature));
    return Facet {normal, toward, texel.z, metal::abs(texel.w), {}, change
        / metal::float2(metal::max(facing, 0.02)), change / metal::float2(metal::max(facing, 0.2))};
}

/// True if the surfaces of two neighbors meet between them. The nearer one may not reach the other
/// more steeply than [`LEAST_NZ`] allows: then it ends in front.
bool meets(
    Facet own,
    Facet other,
    metal::float2 step,
    constant Curvature& curvature
) {
    bool local_2 = {};
    bool is_nearer = own.depth <= other.depth;
    float rise = metal::dot(is_nearer ? own.gentle_rise : own.rise, step);
    float other_rise = metal::dot(is_nearer ? other.rise : other.gentle_rise, step);
    float here = own.depth - (other.depth - other_rise);
    float there = own.depth + rise - other.depth;
    float steepness = metal::min(metal::length(own.gentle_rise), metal::length(other.gentle_rise));
    float tolerance = pixel_size_at(metal::min(own.depth, other.depth), curvature) + steepness;
    if (!(here * there <= 0.0)) {
        local_2 = metal::min(metal::abs(here), metal::abs(there)) <= tolerance;
    } else {
        local_2 = true;
    }
    return local_2;
}

/// True if a pixel shows the surface with this number, no farther than `limit`.
bool shows(
    metal::int2 at,
    float number,
    float limit,
    metal::texture2d<float, metal::access::sample> surface
) {
    bool local_3 = {};
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(),
        surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 texel = surface.read(metal::uint2(metal::clamp(at, metal::int2(0), last)), 0);
    if (metal::abs(texel.w) == number) {
        local_3 = texel.z < limit;
    } else {
        local_3 = false;
    }
    return local_3;
}

/// The course that fits rows best.
Course fitted_course(
    CourseSums sums,
    bool is_arc
) {
    float trust = sums.count / 11.0;
    float spread = sums.count * sums.xx - sums.x * sums.x;
    float slope = (sums.count * sums.xy - sums.x * sums.y) / spread;
    float straight = (sums.y - slope * sums.x) / sums.count;
    if (trust < 1.0) {
        return Course {metal::clamp(straight, 0.0, 1.0), slope, trust};
    }
    // Over all rows x sums to 0, its fourth powers to 1958.
    float bent = (1958.0 * sums.y - sums.xx * sums.xxy) / (sums.count * 1958.0 - sums.xx * sums.xx);
    float left = (sums.yy - straight * sums.y - slope * sums.xy) / sums.count;
    float share = metal::clamp((left - 0.09) / 0.05, 0.0, 1.0);
    return Course {metal::clamp(metal::mix(straight, bent, is_arc ? 1.0 : share), 0.0, 1.0), slope,
        trust};
}

metal::int2 naga_abs(metal::int2 val) {
    return metal::select(as_type<metal::int2>(-as_type<metal::uint2>(val)), val, val >= 0);
}

/// The course of the edge between a pixel and its neighbor, by the pixels at which it changes over
/// from one row to the next. A flat course passes the middle of a pixel near each such change; a
/// steep or bent one is fitted.
Course course_at(
    metal::int2 pixel,
    metal::int2 step,
    float number,
    float limit,
    metal::texture2d<float, metal::access::sample> surface
) {
    // The first change to both sides: how far along, and how far beyond the pixel.
    type_10 ends = type_10 {{metal::float2(0.0), metal::float2(0.0)}};
    int changes = 0;
    CourseSums sums = CourseSums {1.0, 0.0, 0.5, 0.0, 0.0, 0.25, 0.0};
    int height = {};
    bool is_open = {};
    int row = {};
    bool local_4 = {};
    bool local_5 = {};
    int change = {};
    bool local_6 = {};
    bool local_7 = {};
    bool local_8 = {};
    bool local_9 = {};
    bool local_10 = {};
    bool local_11 = {};
    metal::int2 along = naga_abs(step.yx);
    for (int side = 0; side < 2; side++) {
        metal::int2 way = as_type<metal::int2>(as_type<metal::uint2>(along)
            * as_type<uint>(as_type<int>(as_type<uint>(1)
            - as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(side))))));
        height = 0;
        is_open = true;
        row = 1;
        while(true) {
            if (row <= 12) {
                if (!is_open) {
                    local_5 = row <= 5;
                } else {
                    local_5 = true;
                }
                local_4 = local_5;
            } else {
                local_4 = false;
            }
            if (local_4) {
            } else {
                break;
            }
            {
                metal::int2 at = as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(pixel) + as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(way) * as_type<uint>(row))))) + as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(step) * as_type<uint>(height))));
                change = 0;
                if (shows(at, number, limit, surface)) {
                    bool shows_value = shows(as_type<metal::int2>(as_type<metal::uint2>(at)
                        + as_type<metal::uint2>(step)), number, limit, surface);
                    if (shows_value) {
                        change = 1;
                    }
                } else {
                    change = -1;
                }
                if (change > 0) {
                    bool shows_value_1 = shows(as_type<metal::int2>(as_type<metal::uint2>(at)
                        + as_type<metal::uint2>(as_type<metal::int2>(as_type<uint>(2)
                        * as_type<metal::uint2>(step)))), number, limit, surface);
                    local_6 = shows_value_1;
                } else {
                    local_6 = false;
                }
                if (local_6) {
                    break;
                }
                if (change < 0) {
                    bool shows_value_2 = shows(as_type<metal::int2>(as_type<metal::uint2>(at)
                        - as_type<metal::uint2>(step)), number, limit, surface);
                    local_7 = !shows_value_2;
                } else {
                    local_7 = false;
                }
                if (local_7) {
                    break;
                }
                if (change != 0) {
                    if (is_open) {
                        ends.inner[side] = metal::float2(static_cast<float>(row) - 0.5,
                            static_cast<float>(metal::max(height,
                            as_type<int>(as_type<uint>(height) + as_type<uint>(change)))));
                        is_open = false;
                    }
                    changes = as_type<int>(as_type<uint>(changes)
                        + as_type<uint>(row <= 5 ? 1 : 0));
                    height = as_type<int>(as_type<uint>(height) + as_type<uint>(change));
                }
                if (row <= 5) {
                    float x = static_cast<float>(as_type<int>(as_type<uint>(row)
                        * as_type<uint>(as_type<int>(as_type<uint>(1)
                        - as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(side)))))));
                    float y = static_cast<float>(height) + 0.5;
                    sums.count = sums.count + 1.0;
                    sums.x = sums.x + x;
                    sums.y = sums.y + y;
                    sums.xx = sums.xx + x * x;
                    sums.xy = sums.xy + x * y;
                    sums.yy = sums.yy + y * y;
                    sums.xxy = sums.xxy + x * x * y;
                }
                row = as_type<int>(as_type<uint>(row) + as_type<uint>(1));
            }
        }
        if (is_open) {
            ends.inner[side] = metal::float2(static_cast<float>(row) - 0.5,
                static_cast<float>(height) + 0.5);
        }
    }
    float length = ends.inner[0].x + ends.inner[1].x;
    float slope = (ends.inner[0].y - ends.inner[1].y) / length;
    float place = ends.inner[1].y + slope * ends.inner[1].x;
    if (ends.inner[0].y == ends.inner[1].y) {
        local_8 = place != 0.5;
    } else {
        local_8 = false;
    }
    bool is_arc = local_8;
    if (!(changes >= 3)) {
        if (is_arc) {
            local_10 = changes >= 2;
        } else {
            local_10 = false;
        }
        local_9 = local_10;
    } else {
        local_9 = true;
    }
    if (local_9) {
        local_11 = sums.count >= 7.0;
    } else {
        local_11 = false;
    }
    if (local_11) {
        return fitted_course(sums, is_arc);
    }
    // The top of an arc lies beyond the changes to both sides, by half a pixel in the mean.
    float rise = is_arc ? 4.0 * ends.inner[0].x * ends.inner[1].x / (length * length) : 0.0;
    float trust = sums.count / 11.0;
    return Course {metal::clamp(metal::mix(place, 0.5, rise), 0.0, 1.0), slope, trust};
}

/// Square of how much a facet faces the eye; negative for one that is turned away.
float facing_squared(
    Facet facet
) {
    float facing = metal::dot(facet.normal, facet.toward);
    return facing * metal::abs(facing) / metal::dot(facet.toward, facet.toward);
}

metal::float2 course_normal(
    Course course,
    metal::float2 toward
) {
    metal::float2 along = metal::abs(toward.yx);
    return (toward - course.slope * along)
        / metal::float2(metal::sqrt(1.0 + course.slope * course.slope));
}

Edge edge_along(
    int kind,
    Course course,
    metal::float2 toward,
    metal::float2 normal
) {
    float lean = metal::dot(normal, toward);
    return Edge {kind, {}, normal, course.place * lean, course.trust * lean};
}

/// The edge of a surface that ends in front of what is farther than `limit`, or of another object.
Edge silhouette(
    Facet own,
    metal::int2 pixel,
    metal::int2 step,
    float limit,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    bool local_12 = {};
    bool local_13 = {};
    bool local_14 = {};
    metal::float2 toward = static_cast<metal::float2>(step);
    Course course = course_at(pixel, step, own.number, limit, surface);
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(),
        surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    Facet before = facet_at(metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel)
        - as_type<metal::uint2>(step)), metal::int2(0), last), surface, curvature);
    // Near its outline the facing of a round form goes like the root of the distance.
    float facing = facing_squared(own);
    float change = facing_squared(before) - facing;
    metal::float2 across = own.normal.xy * metal::float2(1.0, row_direction(curvature));
    metal::float2 normal = across / metal::float2(metal::max(metal::length(across), 0.000001));
    if (before.number == own.number) {
        local_12 = facing < 0.36;
    } else {
        local_12 = false;
    }
    if (local_12) {
        local_13 = change > 0.0001;
    } else {
        local_13 = false;
    }
    if (local_13) {
        local_14 = metal::dot(normal, toward) > 0.5;
    } else {
        local_14 = false;
    }
    bool is_round = local_14;
    float found = facing / metal::max(change, 0.0001);
    float place = metal::clamp(found, 0.0, 1.0);
    // As far as this is not between the pixels, the form is not as round as its normals.
    float trust = is_round ? metal::clamp(2.0 - 4.0 * metal::abs(found - place), 0.0, 1.0) : 0.0;
    Course seen = Course {metal::mix(course.place, place, trust), course.slope,
        metal::mix(course.trust, 1.0, trust)};
    metal::float2 turned = metal::mix(course_normal(course, toward), normal, trust);
    return edge_along(0, seen, toward, turned / metal::float2(metal::length(turned)));
}

/// Change of the normal between two neighbors that a round form would have: what it is to both
/// sides of them.
float round_bend(
    Facet own,
    Facet other,
    metal::int2 pixel,
    metal::int2 step,
    metal::texture2d<float, metal::access::sample> surface
) {
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(),
        surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 before = surface.read(metal::uint2(metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel) - as_type<metal::uint2>(step)),
        metal::int2(0), last)), 0);
    metal::float4 after = surface.read(metal::uint2(metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel) + as_type<metal::uint2>(as_type<metal::int2>(as_type<uint>(2) * as_type<metal::uint2>(step)))),
        metal::int2(0), last)), 0);
    metal::float3 normal_of_value = normal_of(after);
    metal::float2 bends = metal::float2(metal::length(normal_of(before) - own.normal),
        metal::length(normal_of_value - other.normal));
    metal::float2 numbers = metal::float2(metal::abs(before.w), metal::abs(after.w));
    metal::float2 shares = metal::select(metal::float2(0.0), metal::float2(1.0),
        numbers == metal::float2(own.number));
    return metal::dot(bends, shares) / metal::max(shares.x + shares.y, 1.0);
}

/// The edge between a pixel and its neighbor.
Edge edge_between(
    Facet own,
    metal::int2 pixel,
    metal::int2 step,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    bool local_15 = {};
    bool local_16 = {};
    Edge none = Edge {-1, {}, metal::float2(0.0), 0.0, 0.0};
    metal::int2 at = as_type<metal::int2>(as_type<metal::uint2>(pixel)
        + as_type<metal::uint2>(step));
    if (!metal::any(at < metal::int2(0))) {
        local_15 = metal::any(at >= static_cast<metal::int2>(metal::uint2(surface.get_width(),
            surface.get_height())));
    } else {
        local_15 = true;
    }
    if (local_15) {
        return none;
    }
    Facet other = facet_at(at, surface, curvature);
    if (other.number == 0.0) {
        return silhouette(own, pixel, step, 1000000000.0, surface, curvature);
    }
    metal::float2 toward = static_cast<metal::float2>(step);
    bool is_same_object = object_in(own.number) == object_in(other.number);
    if (!meets(own, other, toward, curvature)) {
        if (own.depth > other.depth) {
            return none;
        }
        float middle = 0.5 * (own.depth + other.depth);
        return silhouette(own, pixel, step, is_same_object ? middle : 1000000000.0, surface,
            curvature);
    }
    if (!is_same_object) {
        return Edge {2, {}, metal::float2(0.0), 0.0, 0.0};
    }
    if (own.number != other.number) {
        bool is_material = material_in(own.number) != material_in(other.number);
        int kind = is_material ? 3 : 4;
        return Edge {kind, {}, metal::float2(0.0), 0.0, 0.0};
    }
    float bend = metal::length(own.normal - other.normal);
    if (!(bend < 0.5176381)) {
        local_16 = bend - round_bend(own, other, pixel, step, surface) < 0.5176381;
    } else {
        local_16 = true;
    }
    if (local_16) {
        return none;
    }
    return Edge {1, {}, metal::float2(0.0), 0.0, 0.0};
}

/// The line in which the planes of two facets meet, or along which a border runs over one plane.
Edge meeting(
    Facet own,
    metal::int2 pixel,
    metal::int2 step,
    int kind,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    bool local_17 = {};
    Facet other = facet_at(as_type<metal::int2>(as_type<metal::uint2>(pixel)
        + as_type<metal::uint2>(step)), surface, curvature);
    metal::float2 toward = static_cast<metal::float2>(step);
    metal::float2 slope = own.rise - other.rise;
    float steepness = metal::length(slope);
    float here = own.depth - (other.depth - metal::dot(other.rise, toward));
    float side = metal::dot(slope, toward);
    if (metal::abs(side) > 0.1 * pixel_size_at(own.depth, curvature)) {
        local_17 = metal::abs(side) > 0.3 * steepness;
    } else {
        local_17 = false;
    }
    if (local_17) {
        float share = metal::clamp(-here / side, 0.0, 1.0);
        metal::float2 normal = slope / metal::float2(side > 0.0 ? steepness : -steepness);
        float lean = metal::dot(normal, toward);
        return Edge {kind, {}, normal, share * lean, lean};
    }
    if (kind == 1) {
        return Edge {kind, {}, toward, 0.5, 0.0};
    }
    Course course = course_at(pixel, step, own.number, 1000000000.0, surface);
    return edge_along(kind, course, toward, course_normal(course, toward));
}

/// True if a surface plainly goes on to a neighbor, which most do: that costs little to tell.
bool goes_on(
    Facet own,
    metal::float2 slope,
    float size,
    metal::int2 pixel,
    metal::int2 step,
    metal::texture2d<float, metal::access::sample> surface
) {
    bool local_18 = {};
    bool local_19 = {};
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(),
        surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 texel = surface.read(metal::uint2(metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel) + as_type<metal::uint2>(step)),
        metal::int2(0), last)), 0);
    metal::float2 change = metal::abs(texel.xy - slope);
    float error = metal::abs(texel.z - own.depth
        - metal::dot(own.gentle_rise, static_cast<metal::float2>(step)));
    if (metal::abs(texel.w) == own.number) {
        local_18 = error <= size;
    } else {
        local_18 = false;
    }
    if (local_18) {
        local_19 = metal::max(change.x, change.y) < 0.35;
    } else {
        local_19 = false;
    }
    return local_19;
}

/// Codes of the edges of each kind between a pixel and the four beside it, those that are known
/// best; 0 for none, and negative for borders of ids.
metal::float4 edges_at(
    metal::int2 pixel,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    uint left = 0u;
    metal::float4 codes = metal::float4(0.0);
    metal::float4 trust = metal::float4(-1.0);
    Edge edge = {};
    Facet own = facet_at(pixel, surface, curvature);
    if (own.number == 0.0) {
        return metal::float4(0.0);
    }
    metal::float2 slope = surface.read(metal::uint2(pixel), 0).xy;
    float size = pixel_size_at(own.depth, curvature);
    for (int index = 0; index < 4; index++) {
        bool goes_on_value = goes_on(own, slope, size, pixel, around(index), surface);
        left = left | (goes_on_value ? 0u : (1u << static_cast<uint>(index)));
    }
    // Most pixels have no round at all: what a loop does not enter costs nothing everywhere.
    for (int index_1 = left == 0u ? 4 : 0; index_1 < 4; index_1++) {
        if (((left >> static_cast<uint>(index_1)) & 1u) == 0u) {
            continue;
        }
        metal::int2 step = around(index_1);
        edge = edge_between(own, pixel, step, surface, curvature);
        if (edge.kind == -1) {
            continue;
        }
        if (edge.kind != 0) {
            edge = meeting(own, pixel, step, edge.kind, surface, curvature);
        }
        int place = metal::min(edge.kind, 3);
        metal::bool4 is_kind = metal::int4(place) == metal::int4(0, 1, 2, 3);
        metal::bool4 is_better = is_kind & (metal::float4(edge.trust) > trust);
        trust = metal::select(trust, metal::float4(edge.trust), is_better);
        float code = edge_code(edge.normal, edge.offset);
        codes = metal::select(codes, metal::float4(edge.kind == 4 ? -code : code), is_better);
    }
    return codes;
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
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  metal::float4 position [[position]]
, metal::texture2d<float, metal::access::sample> surface [[texture(0)]]
, constant Curvature& curvature [[buffer(0)]]
) {
    return fs_mainOutput { edges_at(naga_f2i32(position.xy), surface, curvature) };
}
