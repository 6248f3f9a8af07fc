// Working drawing: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds the nearest edges in each pixel's column.
// Arguments of both functions: surface texture(0), curvature buffer(0), edges texture(1).
// working-drawing.json says what to put there and how to draw.
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

typedef metal::float4 Color;
typedef metal::float4 Composite;
/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    metal::float3 direction;
    /// Unit, toward the light, in the light's own frame.
    metal::float3 own_direction;
    /// Straight RGB.
    metal::packed_float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

struct type_10 {
    metal::float4 inner[16];
};

/// A free function of one number, drawn through points; flat outside of them. The layout is one for
/// uniform buffers.
struct Curve {
    /// x, y and slope (dy/dx, used by the smooth interpolation) of each point, in increasing x.
    type_10 points;
    /// Number of points that count.
    uint count;
    /// 0 straight, 1 smooth (cubic, with the slopes), 2 stepped: each point's y holds until the
    /// next point.
    uint interpolation;
    char _pad3[8];
};

struct type_11 {
    metal::float4 inner[4];
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    type_10 colors;
    /// Places of the stops, in increasing order, four to a vector.
    type_11 places;
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
    char _pad4[8];
};

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    metal::float4 kinds;
    /// Of borders of ids.
    float ids;
    char _pad2[12];
};

constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LN_2 = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
/// What is no nearer than this many pixels is not near at all: less is rounding.
constant float LEAST_NEARNESS = 0.000001;

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
    bool local_1 = {};
    seen = SeenPixel {pixel, {}, surface.read(metal::uint2(pixel), 0)};
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(),
        surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    if (curvature.samples >= 2.0) {
        local_1 = seen.texel.w == 0.0;
    } else {
        local_1 = false;
    }
    bool may_be_missed = local_1;
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
    bool local_2 = {};
    metal::float4 x = columns + edges.x * edges.offset;
    metal::float4 y = rows + edges.y * edges.offset;
    float inward = x.x * edges.x.x + y.x * edges.y.x;
    metal::float4 distances = metal::sqrt(x * x + y * y);
    if (inward < -1.0) {
        local_2 = !beyond;
    } else {
        local_2 = false;
    }
    return metal::float4(local_2 ? 1000000000.0 : distances.x, distances.yzw);
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

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

/// x, or `otherwise` where x is NaN or infinite.
/// @where x is finite : x
float finite_or(
    float x,
    float otherwise
) {
    bool is_finite_value = is_finite(x);
    return is_finite_value ? x : otherwise;
}

/// v with 0 for each component that is NaN or infinite.
/// @where v is finite : v
metal::float3 finite_vec3(
    metal::float3 v
) {
    metal::uint3 exponent = metal::uint3(2139095040u);
    return metal::select(metal::float3(0.0), v, (as_type<metal::uint3>(v) & exponent) != exponent);
}

/// v with 0 for each component that is NaN or infinite.
/// @where v is finite : v
metal::float4 finite_vec4(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
/// @where v is unit : v
/// @where tier is balanced and |v| <= 1e18 and otherwise = 0 :
///   v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
/// @where |v| <= 1e18 : normalize_moderate(v, otherwise)
metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!((largest > 0.000000000000000000000000000001)
        & (largest < 1000000000000000000000000000000.0))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(
    float x
) {
    float clamped = metal::clamp(x, -126.0, 127.99999);
    float whole = metal::rint(clamped);
    float f = clamped - whole;
    // Twice the power, so that half of 2^128 is a number. The bits of 2^-127 are those of 0.
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole))
        + as_type<uint>(126))) << 23u);
}

/// 2^n for n in [-126, 127], by its bits.
float power_of_two(
    int n
) {
    return as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(n) + as_type<uint>(127)))
        << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(
    float x
) {
    uint bits = as_type<uint>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return static_cast<float>(exponent) + z
        * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// ln(x) for normal x > 0.
float log_stable(
    float x
) {
    return LN_2 * log2_stable(x);
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(
    float y
) {
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(
    float y
) {
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return log_stable(metal::max(1.0 - y, 0.000000000000000000000000000000000000011754944));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
/// @where |x| <= 0.1 : sin_cos_tiny(x)
/// @where |x| <= 0.785 : sin_cos_eighth(x)
metal::float2 sin_cos_quarter(
    float x
) {
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    float h = 0.5 * x;
    float h2 = h * h;
    float s = h * (1.0 + h2 * (-0.16666667 + h2
        * (0.008333334 + h2 * (-0.0001984127 + h2 * (0.0000027557319 + h2 * -0.000000025052108)))));
    float one_minus_c = h2 * (0.5 + h2
        * (-0.041666668 + h2 * (0.0013888889 + h2
        * (-0.000024801588 + h2 * (0.0000002755732 + h2 * -0.0000000020876756)))));
    float c = 1.0 - one_minus_c;
    return metal::float2(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
metal::float2 sin_cos_eighth(
    float x
) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666667 + y
        * (0.008333334 + y * (-0.0001984127 + y * 0.0000027557319))));
    float c = 1.0 - y * (0.5 + y * (-0.041666668 + y
        * (0.0013888889 + y * (-0.000024801588 + y * 0.0000002755732))));
    return metal::float2(s, c);
}

/// [`sin_cos_quarter`] for |x| <= 0.1.
metal::float2 sin_cos_tiny(
    float x
) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666667 + y * 0.008333334));
    float c = 1.0 - y * (0.5 + y * (-0.041666668 + y * 0.0013888889));
    return metal::float2(s, c);
}

/// sin(x/2) and cos(x/2) for x in [0, pi], given `left`, which is pi - x: both keep their relative
/// accuracy at both ends, because the smaller angle is halved and its cosine is the other's sine.
metal::float2 sin_cos_half(
    float x,
    float left
) {
    metal::float2 half_ = sin_cos_quarter(0.5 * metal::min(x, left));
    return x <= left ? half_ : half_.yx;
}

/// pi - x for x up to pi, with the digits of pi that an f32 does not hold; 0 where x is the f32
/// next to pi.
float left_to_pi(
    float x
) {
    // pi in two parts. The first is an f32, so that f64 reads the same one; the maximum keeps
    // compilers from making one constant of both.
    float coarse = metal::max(3.1415927 - x, 0.0);
    return metal::max(coarse - 0.00000008742278, 0.0);
}

/// sin(x) and cos(x) for any finite x with |x| < 1e5; [`sin_cos_quarter`] after reduction to a
/// quarter turn.
metal::float2 sin_cos(
    float x
) {
    float turns = metal::rint(x * 0.31830987);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    float r = x - turns * 3.140625 - turns * 0.00096702576 - turns * 0.00000062783295;
    float sign = 1.0 - 2.0 * metal::abs(turns - 2.0 * metal::trunc(turns * 0.5));
    return sign * sin_cos_quarter(metal::clamp(r, -1.5707964, HALF_PI));
}

/// [`normalize_or`] for a third of its price: a vector shorter than 1e-15 or longer than 1e18
/// counts as having no direction.
/// @where v is unit : v
/// @where tier is balanced and |v| <= 1e18 and otherwise = 0 :
///   v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
metal::float3 normalize_quick(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    // Comparisons are false for NaN; what `select` leaves out never reaches the result.
    bool is_usable = (square > 0.000000000000000000000000000001)
        & (square < 1000000000000000000000000000000000000.0);
    return is_usable ? v * metal::rsqrt(is_usable ? square : 1.0) : otherwise;
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
/// @where v is unit : v
/// @where tier is balanced and otherwise = 0 : v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
metal::float2 sin_cos_quick(
    float x
) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666666 + y
        * (0.0083332425 + y * (-0.0001982274 + y * 0.0000026347564))));
    float c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (0.00002477458 - y * 0.00000026297516))));
    return metal::float2(s, c);
}

/// [`sin_cos_quick`] shorter still (absolute error 4.8e-6 and 2.2e-7).
metal::float2 sin_cos_short(
    float x
) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666542 + y * (0.008324197 - y * 0.00018846673)));
    float c = 1.0 + y * (-0.4999999 + y * (0.04166567 + y * (-0.0013868611 + y * 0.000023476086)));
    return metal::float2(s, c);
}

/// log2(1 - y) for y in [0, 1): a series near 0, where 1 - y would round y away, else the
/// hardware's; -100 at 1.
float log2_one_minus(
    float y
) {
    float series = -y * LOG2_E * (1.0 + y * (0.5 + y * (0.33333334 + y * (0.25 + y * 0.2))));
    return y < 0.0625 ? series : metal::log2(metal::max(1.0 - y,
        0.0000000000000000000000000000007888609));
}

/// The angle between the unit vectors d and l, from the chords |d - l| and |d + l|.
/// @where d is unit and l is unit : angle_of_units(d, l)
Angle angle_between(
    metal::float3 d,
    metal::float3 l
) {
    float p = metal::length(d - l);
    float s = metal::length(d + l);
    float k = 1.0 / metal::sqrt(metal::max(p * p + s * s, 0.000000000000000000000000000001));
    return Angle {p * k, s * k};
}

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
float atan2_positive(
    float y,
    float x
) {
    float small = metal::min(y, x);
    float large = metal::max(y, x);
    if (large <= 0.0) {
        return 0.0;
    }
    float t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    bool is_wide = t > 0.41421357;
    float r = is_wide ? (small - large) / (small + large) : t;
    float r2 = r * r;
    float series = r * (1.0 + r2 * (-0.33333334 + r2
        * (0.2 + r2 * (-0.14285715 + r2
        * (0.11111111 + r2 * (-0.09090909 + r2
        * (0.07692308 + r2 * (-0.06666667 + r2 * 0.05882353))))))));
    float a = is_wide ? series + 0.7853982 : series;
    return y > x ? HALF_PI - a : a;
}

/// The angle u in radians.
float angle_radians(
    Angle u
) {
    return 2.0 * atan2_positive(u.half_sin, u.half_cos);
}

/// The angle of `radians`, clamped to [0, pi]; 0 where it is not finite.
Angle angle_of(
    float radians
) {
    float half_angle = 0.5 * metal::clamp(finite_or(radians, 0.0), 0.0, PI);
    metal::float2 sc = sin_cos_quarter(half_angle);
    return Angle {metal::max(sc.x, 0.0), metal::max(sc.y, 0.0)};
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(
    Angle u,
    metal::float2 t
) {
    float s = u.half_sin * t.y - u.half_cos * t.x;
    float c = u.half_cos * t.y + u.half_sin * t.x;
    metal::float2 upper = c <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, c);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    metal::float2 turned = ((s <= 0.0) & (s < c)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

/// u - shift, clamped to [0, pi], for |shift| <= pi (BADF eq. 8 and docs/math.md D3).
Angle angle_shifted(
    Angle u,
    float shift
) {
    return angle_turned(u, sin_cos_quarter(0.5 * metal::clamp(shift, -3.1415927, PI)));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    // An infinite or NaN derivative at a silhouette gives the widest footprint.
    return metal::min(finite_or(w, 0.5), 0.5);
}

/// [`angle_between`] for vectors that are unit but for rounding: half of each chord, without
/// normalizing the two halves again.
Angle angle_of_units(
    metal::float3 d,
    metal::float3 l
) {
    return Angle {0.5 * metal::length(d - l), 0.5 * metal::length(d + l)};
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
/// @where x is finite : x
float bounded(
    float x
) {
    uint bits = as_type<uint>(x);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// [`bounded`], component by component.
/// @where v is finite : v
metal::float2 bounded_vec2(
    metal::float2 v
) {
    metal::uint2 bits = as_type<metal::uint2>(v);
    metal::uint2 magnitude = bits & metal::uint2(2147483647u);
    metal::float2 largest = as_type<metal::float2>((bits & metal::uint2(2147483648u))
        | metal::uint2(2139095039u));
    metal::float2 numbers = metal::select(metal::float2(0.0), largest,
        magnitude == metal::uint2(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint2(2139095040u));
}

/// [`bounded`], component by component.
/// @where v is finite : v
metal::float3 bounded_vec3(
    metal::float3 v
) {
    metal::uint3 bits = as_type<metal::uint3>(v);
    metal::uint3 magnitude = bits & metal::uint3(2147483647u);
    metal::float3 largest = as_type<metal::float3>((bits & metal::uint3(2147483648u))
        | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest,
        magnitude == metal::uint3(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint3(2139095040u));
}

/// [`bounded`], component by component.
/// @where v is finite : v
metal::float4 bounded_vec4(
    metal::float4 v
) {
    metal::uint4 bits = as_type<metal::uint4>(v);
    metal::uint4 magnitude = bits & metal::uint4(2147483647u);
    metal::float4 largest = as_type<metal::float4>((bits & metal::uint4(2147483648u))
        | metal::uint4(2139095039u));
    metal::float4 numbers = metal::select(metal::float4(0.0), largest,
        magnitude == metal::uint4(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint4(2139095040u));
}

/// a / b; 0 where b is 0.
float divided(
    float a,
    float b
) {
    if (metal::abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// x - y floor(x / y): from 0 up to y, without y, with the sign of y; 0 where y is 0.
float modulo_floored(
    float x,
    float y
) {
    float size = metal::abs(y);
    if (size < SMALLEST_NORMAL) {
        return 0.0;
    }
    float turned = y > 0.0 ? x : -x;
    // Rounding may put the remainder just outside of its range, and far outside where x / y has no
    // digits left.
    float left = bounded(turned - size * metal::floor(bounded(turned / size)));
    float wrapped = left < 0.0 ? left + size : left;
    float inside = ((wrapped >= 0.0) & (wrapped < size)) ? wrapped : 0.0;
    return y > 0.0 ? inside : -inside;
}

/// base^exponent for every pair. A negative base is raised as in algebra by a whole exponent and
/// keeps its sign with any other, so that (-4)^0.5 is -2. 0 to a negative power is 0, as division
/// by 0 is; 0^0 is 1.
/// @where tier is balanced and base >= 0 and base <= 1.1 and exponent >= 1e-3 and exponent <= 500 :
///   pow(base, exponent) ~ 3e-4
/// @where tier is balanced and base >= 0 and base <= 1e4 and exponent >= 1e-3 and exponent <= 8 :
///   pow(base, exponent) ~ 3e-4
float powered(
    float base,
    float exponent
) {
    float b = bounded(base);
    float e = bounded(exponent);
    // The result is exact, because an exponent of 1 lets the compiler leave the node out.
    if (e == 1.0) {
        return b;
    }
    if (e == 0.0) {
        return 1.0;
    }
    if (e == 2.0) {
        return bounded(b * b);
    }
    float magnitude = metal::abs(b);
    float raised = exp2_stable(bounded(e * log2_stable(metal::max(magnitude, SMALLEST_NORMAL))));
    bool is_even = metal::floor(e * 0.5) == e * 0.5;
    float signed_ = ((b < 0.0) & !is_even) ? -raised : raised;
    return magnitude < SMALLEST_NORMAL ? 0.0 : signed_;
}

/// [`powered`], component by component.
/// @where tier is balanced and base >= 0 and base <= 1.1 and exponent >= 1e-3 and exponent <= 500 :
///   pow(base, vec3f(exponent)) ~ 3e-4
/// @where tier is balanced and base >= 0 and base <= 1e4 and exponent >= 1e-3 and exponent <= 8 :
///   pow(base, vec3f(exponent)) ~ 3e-4
metal::float3 powered_vec3(
    metal::float3 base,
    float exponent
) {
    return metal::float3(powered(base.x, exponent), powered(base.y, exponent),
        powered(base.z, exponent));
}

/// e^x; 0 far below, the largest number from 88.73 on.
/// @where tier is balanced and |x| <= 80 : exp(x) ~ 3e-5
float exponential_of(
    float x
) {
    return exp2_stable(bounded(x * LOG2_E));
}

/// ln(x); 0 and everything below count as 1.2e-38, the smallest normal number, whose logarithm is
/// -87.34.
/// @where tier is balanced and x >= 1e-30 and x <= 1e30 : log(x) ~ 2e-5
float logarithm_of(
    float x
) {
    return log_stable(metal::max(bounded(x), SMALLEST_NORMAL));
}

/// Mix from a (where t is 0) to b (where t is 1): exact at both ends, and where a is b.
/// @where a = 0 and b = 1 and |t| <= 1e15 : t
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
float mixed(
    float a,
    float b,
    float t
) {
    float d = bounded(b - a);
    return bounded(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
metal::float2 mixed_vec2(
    metal::float2 a,
    metal::float2 b,
    float t
) {
    metal::float2 d = bounded_vec2(b - a);
    return bounded_vec2(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
metal::float3 mixed_vec3(
    metal::float3 a,
    metal::float3 b,
    float t
) {
    metal::float3 d = bounded_vec3(b - a);
    return bounded_vec3(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
metal::float4 mixed_vec4(
    metal::float4 a,
    metal::float4 b,
    float t
) {
    metal::float4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(
    float x,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return x >= high ? 1.0 : 0.0;
    }
    return bounded((x - low) / bounded(span));
}

/// x moved from one range to another, kept within the new one when `clamped`; an empty first range
/// makes a step.
float remapped(
    float x,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    float place = place_between(bounded(x), bounded(from_low), bounded(from_high));
    float bounded_value = bounded(to_low);
    float bounded_value_1 = bounded(to_high);
    return mixed(bounded_value, bounded_value_1, clamped ? metal::clamp(place, 0.0, 1.0) : place);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
/// @where low < high and x is finite and |low| <= 1e30 and |high| <= 1e30 :
///   smoothstep(low, high, x)
float eased(
    float x,
    float low,
    float high
) {
    float t = metal::clamp(place_between(bounded(x), bounded(low), bounded(high)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A factor as it is, or kept within 0 and 1 when `clamped`.
float factor_of(
    float x,
    bool clamped
) {
    float bounded_value = bounded(x);
    float bounded_value_1 = bounded(x);
    return clamped ? metal::clamp(bounded_value_1, 0.0, 1.0) : bounded_value;
}

/// The length of v, also where its square would over- or underflow.
/// @where |v| <= 1e18 : length(v)
float length_of(
    metal::float3 v
) {
    metal::float3 w = bounded_vec3(v);
    float largest = metal::max(metal::max(metal::abs(w.x), metal::abs(w.y)), metal::abs(w.z));
    if (largest < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(largest * metal::length(w / metal::float3(largest)));
}

/// sin(r) for |r| <= 1.6, a quarter turn and some more: a minimax polynomial (absolute error below
/// 6e-9 beside rounding).
float sine_low(
    float r
) {
    float y = r * r;
    float high = metal::fma(y, 0.0000025930888, -0.00019803418);
    float s = metal::fma(r * y, metal::fma(y, metal::fma(y, high, 0.008332972), -0.16666655), r);
    return metal::clamp(s, -1.0, 1.0);
}

/// sin(r + pi turns) for |r| <= 1.6 and whole turns.
float sine_turned(
    float r,
    float turns
) {
    // Odd turns, of which half is left, turn the sign.
    return sine_low(r) * metal::fma(metal::fract(turns * 0.5), -4.0, 1.0);
}

/// sin(x) for every x, in [-1, 1]; beyond 100,000 rounding leaves nothing of the phase. The form of
/// the balanced tier takes x as off by a rounding or two, which far from 0 is more than its bound.
/// @where tier is balanced and |x| <= 1e7 : sin(x) ~ 5e-5
/// @where |x| <= 1.6 : sine_low(x)
/// @where x >= 0 and x <= 4.17 : cosine_low(x - 1.57079632679489662)
/// @where x >= 1.55 and x <= 4.73 : sine_low((3.140625 - x) + 0.000967653589793238463)
/// @where x >= 2.12 and x <= 7.31 : -cosine_low(x - 4.71238898038468986)
/// @where |x| <= 3000 : sine_near(x)
float sine_of(
    float x
) {
    float b = bounded(x);
    float turns = metal::rint(b * 0.31830987);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    float coarse = metal::fma(turns, -0.00096702576, metal::fma(turns, -3.140625, b));
    float r = metal::fma(turns, -0.00000062783295, coarse);
    // Far out, rounding of the turns leaves somewhat more than a quarter turn.
    return sine_turned(metal::clamp(r, -1.6, 1.6), turns);
}

/// [`sine_of`] where two parts of pi are enough.
float sine_near(
    float x
) {
    float turns = metal::rint(x * 0.31830987);
    float r = metal::fma(turns, -0.0009676536, metal::fma(turns, -3.140625, x));
    return sine_turned(r, turns);
}

/// cos(x) for every x, in [-1, 1]; beyond 100,000 rounding leaves nothing of the phase. The form of
/// the balanced tier is that of [`sine_of`].
/// @where tier is balanced and |x| <= 1e7 : cos(x) ~ 5e-5
/// @where |x| <= 2.6 : cosine_low(x)
/// @where x >= 0 and x <= 3.17 : sine_low((1.5703125 - x) + 0.000483826794896619231)
/// @where x >= 0.55 and x <= 5.74 : -cosine_low(x - 3.14159265358979324)
/// @where |x| <= 3000 : cosine_near(x)
float cosine_of(
    float x
) {
    float b = bounded(x);
    float turns = metal::rint(b * 0.31830987 - 0.5);
    float middle = turns + 0.5;
    float coarse = metal::fma(middle, -0.00096702576, metal::fma(middle, -3.140625, b));
    float r = metal::fma(middle, -0.00000062783295, coarse);
    return sine_turned(-metal::clamp(r, -1.6, 1.6), turns);
}

/// [`cosine_of`] where two parts of pi are enough.
float cosine_near(
    float x
) {
    float turns = metal::rint(x * 0.31830987 - 0.5);
    float middle = turns + 0.5;
    float r = metal::fma(middle, 0.0009676536, metal::fma(middle, 3.140625, -x));
    return sine_turned(r, turns);
}

/// cos(r) for |r| <= 2.6: a minimax polynomial (absolute error below 2e-9 beside rounding) that is
/// 1 at 0 and below that elsewhere.
float cosine_low(
    float r
) {
    float y = r * r;
    float high = metal::fma(y, metal::fma(y, 0.0000000018474174, -0.00000027357322),
        0.000024793637);
    return metal::fma(y, metal::fma(y,
        metal::fma(y, metal::fma(y, high, -0.0013888741), 0.041666657), -0.5), 1.0);
}

/// sin(x) and cos(x) for every x; beyond 100,000 rounding leaves nothing of the phase, and the
/// result lies in [-1, 1].
/// @where tier is balanced and |x| <= 1000 : vec2f(sin(x), cos(x)) ~ 5e-5
metal::float2 sin_cos_of(
    float x
) {
    return metal::clamp(sin_cos(bounded(x)), metal::float2(-1.0), metal::float2(1.0));
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
float angle_of_point(
    float y,
    float x
) {
    // Coordinates are halved where they are large, so that the sum of both stays finite.
    metal::float2 p = metal::abs(bounded_vec2(metal::float2(x, y)));
    metal::float2 scaled = metal::max(p.x, p.y) > 1.0 ? 0.5 * p : p;
    float a = atan2_positive(scaled.y, scaled.x);
    float turned = x < 0.0 ? PI - a : a;
    return y < 0.0 ? -turned : turned;
}

/// Farthest that a line is known from its edge, in pixels: so many steps of 1/800 of the picture's
/// height, and at most 31 pixels, as far as an offset fits into a texel.
float line_reach(
    float viewport_height,
    float steps
) {
    return metal::min(steps * metal::max(metal::rint(viewport_height / 800.0), 1.0), 31.0);
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
metal::float4 own_nearness(
    metal::float4 nearness,
    metal::float2 middle,
    float depth,
    float object,
    float pixels,
    float reach
) {
    bool local_3 = {};
    bool local_4 = {};
    bool is_same_object = middle.y == object_number(object);
    float behind = (depth - middle.x) * pixels;
    if (!(metal::abs(middle.y) < 0.5)) {
        if (is_same_object) {
            local_4 = metal::abs(behind) <= 8.0625;
        } else {
            local_4 = false;
        }
        local_3 = local_4;
    } else {
        local_3 = true;
    }
    // Slivers of the same surface are seen on the planes of their own triangles. Bounds are none of
    // the round numbers that depths of things put together by hand have.
    bool is_own = local_3;
    bool is_in_front = behind < (is_same_object ? -8.0625 : -2.0625);
    metal::float4 other = metal::float4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

/// A number of pixels that a width says, 0 or more and less than any reach needs.
float line_pixels(
    float width,
    float pixels
) {
    return metal::clamp(bounded(width), 0.0, 1000000.0)
        * metal::clamp(bounded(pixels), 0.0, 1000000.0);
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths(
    float width,
    metal::float4 shares,
    float ids
) {
    metal::float4 bounded_vec4_value = bounded_vec4(shares);
    metal::float4 widths = metal::min(width, 10000.0)
        * metal::clamp(bounded_vec4_value, metal::float4(0.0), metal::float4(100.0));
    float id_width = metal::min(width, 10000.0) * metal::clamp(bounded(ids), 0.0, 100.0);
    // What no pixel can show is no line.
    return LineWidths {metal::select(metal::float4(0.0), widths, widths > metal::float4(0.000001)),
        id_width > 0.000001 ? id_width : 0.0};
}

/// Widths of the four lines that are near: a negative nearness in the place of materials is that of
/// a border of ids.
metal::float4 widths_near(
    metal::float4 nearness,
    LineWidths widths
) {
    return metal::float4(widths.kinds.xyz, nearness.w < 0.0 ? widths.ids : widths.kinds.w);
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
float inner_line_covers(
    float distance,
    float width
) {
    return metal::clamp(width + 0.5 - distance, 0.0, metal::min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
metal::float4 middle_line_covers(
    metal::float4 distance,
    metal::float4 width
) {
    metal::float4 half_ = 0.5 * width;
    return metal::clamp(metal::min(distance + metal::float4(0.5), half_)
        - metal::max(distance - metal::float4(0.5), -half_), metal::float4(0.0),
        metal::float4(1.0));
}

/// What a line of any kind covers of a pixel, by how much nearer than the reach the edges of each
/// kind are: all lie evenly on both sides.
float any_line_covers(
    metal::float4 nearness,
    LineWidths widths,
    float reach
) {
    metal::float4 near = metal::clamp(bounded_vec4(nearness), metal::float4(-reach),
        metal::float4(reach));
    metal::float4 widths_near_value = widths_near(near, widths);
    metal::float4 own = metal::select(metal::float4(0.0), widths_near_value, metal::abs(near)
        > metal::float4(0.000001));
    metal::float4 covers = middle_line_covers(metal::float4(reach) - metal::abs(near), own);
    return metal::max(metal::max(covers.x, covers.y), metal::max(covers.z, covers.w));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
metal::float4 lines_cover(
    metal::float4 nearness,
    metal::float4 widths,
    float reach
) {
    metal::float4 distance = metal::float4(reach) - nearness;
    metal::float4 covers = metal::float4(inner_line_covers(distance.x, widths.x),
        middle_line_covers(distance, widths).yzw);
    return metal::select(metal::float4(0.0), covers, nearness > metal::float4(0.000001));
}

/// True if a texel belongs to the surface of a plane, so many pixels away.
bool is_same_surface(
    Plane own,
    metal::float4 texel,
    metal::float2 offset
) {
    bool local_5 = {};
    float error = metal::abs(texel.z - own.depth - metal::dot(own.rise, offset));
    if (object_in(texel.w) == object_in(own.object)) {
        local_5 = error <= 3.0 * own.tolerance * metal::max(metal::length(offset), 1.0);
    } else {
        local_5 = false;
    }
    return local_5;
}

int naga_neg(int val) {
    return as_type<int>(-as_type<uint>(val));
}

/// The nearest edge of each kind in a pixel's own column: the coarse code of each, with its row
/// from the pixel; 0 for none, negative for a border of ids. `reach` is how far edges are looked
/// for, in pixels; `of_all` if those of other surfaces count, too.
metal::float4 nearest_in_column(
    metal::int2 pixel,
    Plane own,
    int reach,
    bool of_all,
    metal::texture2d<float, metal::access::sample> surface,
    metal::texture2d<float, metal::access::sample> edges
) {
    metal::float4 nearest = metal::float4(1000000000.0);
    metal::float4 codes = metal::float4(0.0);
    bool local_6 = {};
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(),
        surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    for (int row = metal::max(naga_neg(reach), naga_neg(pixel.y)); row
        <= metal::min(reach, as_type<int>(as_type<uint>(last.y) - as_type<uint>(pixel.y))); row++) {
        metal::int2 at = as_type<metal::int2>(as_type<metal::uint2>(pixel)
            + as_type<metal::uint2>(metal::int2(0, row)));
        metal::float4 found = edges.read(metal::uint2(at), 0);
        if (metal::all(found == metal::float4(0.0))) {
            continue;
        }
        if (!of_all) {
            local_6 = !is_same_surface(own, surface.read(metal::uint2(at), 0),
                metal::float2(0.0, static_cast<float>(row)));
        } else {
            local_6 = false;
        }
        if (local_6) {
            continue;
        }
        metal::float4 fine = metal::abs(found);
        EdgeLines edges_of_value = edges_of(fine, 4096.0);
        metal::float4 middle_distances_value = middle_distances(edges_of_value, metal::float4(0.0),
            metal::float4(static_cast<float>(row)), of_all);
        metal::float4 distances = metal::select(metal::float4(1000000000.0), middle_distances_value,
            fine > metal::float4(0.0));
        metal::bool4 is_nearer = distances < nearest;
        nearest = metal::select(nearest, distances, is_nearer);
        metal::float4 coarse = coarse_codes(fine)
            + metal::float4(262144.0 * (static_cast<float>(row) + 31.0));
        codes = metal::select(codes, metal::select(coarse, -coarse, found < metal::float4(0.0)),
            is_nearer);
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
, metal::texture2d<float, metal::access::sample> edges [[texture(1)]]
) {
    bool local = {};
    metal::int2 pixel = naga_f2i32(position.xy);
    SeenPixel seen_pixel_value = seen_pixel(pixel, surface, curvature);
    metal::float4 seen = seen_pixel_value.texel;
    if (true) {
        local = seen_pixel_value.texel.w == 0.0;
    } else {
        local = false;
    }
    if (local) {
        return fs_mainOutput { metal::float4(0.0) };
    }
    float reach = line_reach(curvature.viewport_height, 16.0);
    Plane own = plane_of(metal::abs(seen_pixel_value.texel.w), seen_pixel_value.texel.z,
        normal_of(seen), curvature);
    return fs_mainOutput { nearest_in_column(pixel, own, naga_f2i32(reach), false, surface,
        edges) };
}
