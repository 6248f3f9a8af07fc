// Ink outlines: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds the nearest edges in each pixel's column.
// Registers of space 0: surface t0, curvature b0, edges t1.
// ink-outlines.json says what to put there and how to draw.

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
    int2 at;
    float4 texel;
};

/// The plane of the surface at a pixel: it tells which neighbors lie on the same surface. Changes
/// of depth are along columns and rows of the image.
struct Plane {
    float object;
    float depth;
    /// Change of depth from a pixel to the next.
    float2 rise;
    /// Tolerated difference of a neighbor's depth, for each pixel that the neighbor is away.
    float tolerance;
};

/// A pixel whose curvature is measured.
struct Center {
    int2 at;
    float2 slope;
    Plane plane;
};

/// Neighbors on the four sides of a center: in the column after it, in the column before it, in the
/// row after it, and in the row before it.
struct Ring {
    /// Weighted changes of slope.x from the center.
    float4 x;
    /// Weighted changes of slope.y from the center.
    float4 y;
    float4 weights;
};

/// Edges of four kinds: the unit normals of straight lines, and how far along them the lines lie,
/// in pixels of the image.
struct EdgeLines {
    float4 x;
    float4 y;
    float4 offset;
};

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
    float3 direction;
    /// Unit, toward the light, in the light's own frame.
    float3 own_direction;
    /// Straight RGB.
    float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// A free function of one number, drawn through points; flat outside of them. The layout is one for
/// uniform buffers.
struct Curve {
    /// x, y and slope (dy/dx, used by the smooth interpolation) of each point, in increasing x.
    float4 points[16];
    /// Number of points that count.
    uint count;
    /// 0 straight, 1 smooth (cubic, with the slopes), 2 stepped: each point's y holds until the
    /// next point.
    uint interpolation;
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    float4 colors[16];
    /// Places of the stops, in increasing order, four to a vector.
    float4 places[4];
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
};

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    float4 kinds;
    /// Of borders of ids.
    float ids;
};

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2 = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
/// What is no nearer than this many pixels is not near at all: less is rounding.
static const float LEAST_NEARNESS = 1e-6;

Texture2D<float4> surface : register(t0);
cbuffer curvature : register(b0) { Curvature curvature; }
Texture2D<float4> edges : register(t1);

struct FragmentInput {
    float4 position_1 : SV_Position;
};

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
}

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
}

/// `accept` where the condition holds, else `reject`, component by component.
float2 choose(bool2 condition, float2 accept, float2 reject)
{
    return float2(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y);
}

/// The slope n.xy / n.z of a normal in camera axes.
float2 slope_of(float3 normal)
{
    return normal.xy / (max(normal.z, 0.2)).xx;
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
float4 surface_texel(float3 normal, float depth, float number)
{
    const float2 slope_of_value = slope_of(normal);
    return float4(slope_of_value, depth, normal.z < 0.0 ? -number : number);
}

/// The number of an object in texels, from 1 on.
float object_number(float object)
{
    return object - 4096.0 * floor(object / 4096.0) + 1.0;
}

/// The number of a facet for [`surface_texel`]: the object's, from 1 on, and what materials and
/// ids add, less than 1. `id` is rounded to a whole number; what is none, or beyond a million, is
/// 0.
float facet_number(float object, float material, float id)
{
    float whole = round(abs(id) <= 1000000.0 ? id : 0.0);
    float parts = 128.0 * (material - 32.0 * floor(material / 32.0)) + whole - 128.0
        * floor(whole / 128.0);
    return object_number(object) + parts / 4096.0;
}

/// The normal that a texel was made from.
float3 normal_of(float4 texel)
{
    // Below LEAST_NZ the slope is n.xy by a constant, and n.z is what is left of the length 1;
    // elsewhere that is no less than LEAST_NZ, and the normal points along the slope and 1.
    float2 aside = 0.2 * texel.xy;
    float rest = sqrt(max(1.0 - dot(aside, aside), 0.0));
    float nz = texel.w < 0.0 ? -rest : rest;
    float3 facing = float3(texel.xy, 1.0) / (sqrt(1.0 + dot(texel.xy, texel.xy))).xxx;
    return nz >= 0.2 ? facing : float3(aside, nz);
}

/// A triangle over the whole picture.
float4 whole_picture(uint index)
{
    return float4(float(index & 1u) * 4.0 - 1.0, float(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// A step in pixels: a share of the picture's height, so that a larger picture measures the same
/// curvature, not a finer one.
int step_pixels()
{
    return max(to_int(round(curvature.viewport_height / 800.0)), int(1));
}

/// 1 where a row of the image lies above the row before it, -1 where it lies below.
float row_direction()
{
    return curvature.rows_up > 0.5 ? 1.0 : -1.0;
}

/// Offset to one of the eight pixels around a pixel, by an index from 0 to 7; the nearest first.
int2 around(int index)
{
    int side = asint(asuint(int(1)) - asuint(asint(asuint(int(2)) * asuint(index & int(1)))));
    int2 straight = index < int(2) ? int2(side, int(0)) : int2(int(0), side);
    return index > int(3) ? int2(side, asint(asuint(int(1)) - asuint(index & int(2)))) : straight;
}

SeenPixel ConstructSeenPixel(int2 at, float4 texel) {
    SeenPixel ret = (SeenPixel)0;
    ret.at = at;
    ret.texel = texel;
    return ret;
}

uint2 NagaDimensions2D(Texture2D<float4> tex)
{
    uint4 ret;
    tex.GetDimensions(0, ret.x, ret.y, ret.z);
    return ret.xy;
}

/// The pixel whose surface a pixel has: its own, or that of a neighbor.
///
/// With several samples a pixel, a look also shades pixels whose middle the object just misses:
/// they have the surface of the nearest of the eight pixels around that shows one.
SeenPixel seen_pixel(int2 pixel)
{
    SeenPixel seen = (SeenPixel)0;
    bool local_1 = (bool)0;

    seen = ConstructSeenPixel(pixel, surface.Load(int3(pixel, int(0))));
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    if (curvature.samples >= 2.0) {
        local_1 = seen.texel.w == 0.0;
    } else {
        local_1 = false;
    }
    bool may_be_missed = local_1;
    for (int index = may_be_missed ? 7 : -1; index >= 0; index--) {
        int2 near = clamp(asint(asuint(pixel) + asuint(around(index))), (int(0)).xx, last);
        float4 texel = surface.Load(int3(near, int(0)));
        if (texel.w != 0.0) {
            seen = ConstructSeenPixel(near, texel);
        }
    }
    return seen;
}

Plane ConstructPlane(float object, float depth, float2 rise, float tolerance) {
    Plane ret = (Plane)0;
    ret.object = object;
    ret.depth = depth;
    ret.rise = rise;
    ret.tolerance = tolerance;
    return ret;
}

Plane plane_of(float object, float depth, float3 normal)
{
    float pixel = curvature.pixel * lerp(1.0, depth, curvature.perspective);
    float2 gradient = normal.xy / (max(normal.z, 0.02)).xx;
    const float row_direction_value = row_direction();
    return ConstructPlane(object, depth, pixel * gradient * float2(1.0, row_direction_value), 2.0
        * pixel * (1.0 + length(gradient)));
}

/// Weights of four neighbors that are `distance` pixels away, 0 to 1, by their objects, their
/// depths, and the rises of depth to them on the plane.
float4 neighbor_weights(Plane plane, float4 objects, float4 depths, float4 rises, float distance_)
{
    float4 error = abs(depths - (plane.depth).xxxx - rises);
    float scale = 1.0 / max(plane.tolerance * distance_, 1e-30);
    // The weight fades, so that the last bit of a depth does not decide between all and nothing.
    float4 weights = clamp((2.0).xxxx - error * scale, (0.0).xxxx, (1.0).xxxx);
    return choose(objects == (plane.object).xxxx, weights, (0.0).xxxx);
}

Center ConstructCenter(int2 at, float2 slope, Plane plane) {
    Center ret = (Center)0;
    ret.at = at;
    ret.slope = slope;
    ret.plane = plane;
    return ret;
}

/// The center for a pixel; its object is 0 where there is none.
Center center_at(int2 pixel)
{
    const SeenPixel seen = seen_pixel(pixel);
    float4 texel = seen.texel;
    return ConstructCenter(seen.at, texel.xy, plane_of(abs(texel.w), texel.z, normal_of(texel)));
}

Ring ConstructRing(float4 x, float4 y, float4 weights) {
    Ring ret = (Ring)0;
    ret.x = x;
    ret.y = y;
    ret.weights = weights;
    return ret;
}

/// The ring that is so many steps away, with its weight.
Ring ring_at(Center center_, int steps, float weight)
{
    int reach = asint(asuint(steps) * asuint(step_pixels()));
    float distance_ = float(reach);
    int2 at = center_.at;
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 a = surface.Load(int3(int2(min(asint(asuint(at.x) + asuint(reach)), last.x), at.y),
        int(0)));
    float4 b = surface.Load(int3(int2(max(asint(asuint(at.x) - asuint(reach)), int(0)), at.y),
        int(0)));
    float4 c = surface.Load(int3(int2(at.x, min(asint(asuint(at.y) + asuint(reach)), last.y)),
        int(0)));
    float4 d = surface.Load(int3(int2(at.x, max(asint(asuint(at.y) - asuint(reach)), int(0))),
        int(0)));
    // Beyond the image nothing is.
    bool4 is_inside = int4(asint(asuint(last.x) - asuint(at.x)), at.x,
        asint(asuint(last.y) - asuint(at.y)), at.y) >= (reach).xxxx;
    const float4 objects = choose(is_inside, abs(float4(a.w, b.w, c.w, d.w)), (0.0).xxxx);
    float2 rise = distance_ * center_.plane.rise;
    float4 rises = float4(rise.x, -rise.x, rise.y, -rise.y);
    const float4 neighbor_weights_value = neighbor_weights(center_.plane, objects,
        float4(a.z, b.z, c.z, d.z), rises, distance_);
    float4 shares = weight * distance_ * neighbor_weights_value;
    return ConstructRing(shares * (float4(a.x, b.x, c.x, d.x) - (center_.slope.x).xxxx), shares
        * (float4(a.y, b.y, c.y, d.y) - (center_.slope.y).xxxx), shares * distance_);
}

/// Two rings as one.
Ring joined(Ring a, Ring b)
{
    return ConstructRing(a.x + b.x, a.y + b.y, a.weights + b.weights);
}

/// The twelve neighbors one, two and three steps away.
Ring rings_at(Center center_)
{
    const Ring near = joined(ring_at(center_, int(1), 1.0), ring_at(center_, int(2), 0.85));
    return joined(near, ring_at(center_, int(3), 0.5));
}

/// The derivatives along x and y, camera axes, from weighted changes to the four sides, as far as
/// each side counts; 0 where none does.
float2 derivatives(float4 changes, float4 weights)
{
    // A side that hardly counts any more is left to the other one, gradually.
    float4 trust = smoothstep((0.0).xxxx, (0.5).xxxx, weights);
    float4 sides = changes / max(weights, (1e-6).xxxx) * trust;
    float2 along = (sides.xz - sides.yw) / max(trust.xz + trust.yw, (1e-6).xx);
    return along * float2(1.0, row_direction());
}

/// Mean curvature from the neighbors.
float mean_curvature(Ring ring)
{
    const float2 along = derivatives(float4(ring.x.xy, ring.y.zw), ring.weights);
    return clamp(0.5 * (along.x + along.y) * curvature.viewport_height, -10000.0, 10000.0);
}

/// The number of the object in a texel's number, from 1 on; 0 where nothing is.
float object_in(float number)
{
    return floor(abs(number));
}

/// The number of the material in a texel's number, from 0 on.
float material_in(float number)
{
    return floor(frac(abs(number)) * 32.0);
}

/// The fine code of an edge by its unit normal and its offset, less than 2 pixels; never 0.
float edge_code(float2 normal, float offset)
{
    float share = normal.x / max(abs(normal.x) + abs(normal.y), 1e-20);
    float turn = normal.y >= 0.0 ? 1.0 - share : 3.0 + share;
    float direction = min(floor(turn * 1024.0), 4095.0);
    float place = floor((clamp(offset, -1.99, 1.99) + 2.0) * 1024.0);
    return place * 4096.0 + direction;
}

/// Codes of few levels from fine ones.
float4 coarse_codes(float4 codes)
{
    float4 place = floor(codes / (4096.0).xxxx);
    float4 direction = codes - 4096.0 * place;
    return floor(place * 0.125) * 512.0 + floor(direction * 0.125);
}

EdgeLines ConstructEdgeLines(float4 x, float4 y, float4 offset) {
    EdgeLines ret = (EdgeLines)0;
    ret.x = x;
    ret.y = y;
    ret.offset = offset;
    return ret;
}

/// The edges that codes of so many levels say, each 0 or more.
EdgeLines edges_of(float4 codes, float levels)
{
    float4 place = floor(codes / (levels).xxxx);
    float4 turn = (codes - levels * place + (0.5).xxxx) * (4.0 / levels);
    bool4 is_back = turn >= (2.0).xxxx;
    const float4 x = choose(is_back, turn - (3.0).xxxx, (1.0).xxxx - turn);
    float4 rest = (1.0).xxxx - abs(x);
    const float4 y = choose(is_back, -rest, rest);
    float4 size = sqrt(x * x + y * y);
    return ConstructEdgeLines(x / size, y / size, (place + (0.5).xxxx) * (4.0 / levels)
        - (2.0).xxxx);
}

/// Distances in pixels between a pixel and the middles of the pieces of edges, by the places of the
/// edges' pixels from it: they tell which piece is the nearest, whichever way it leans. The first
/// edge is a silhouette, which counts on its inner side alone unless `beyond` says both: outside it
/// is [`FAR`].
float4 middle_distances(EdgeLines edges, float4 columns, float4 rows, bool beyond)
{
    bool local_2 = (bool)0;

    float4 x = columns + edges.x * edges.offset;
    float4 y = rows + edges.y * edges.offset;
    float inward = x.x * edges.x.x + y.x * edges.y.x;
    float4 distances = sqrt(x * x + y * y);
    if (inward < -1.0) {
        local_2 = !beyond;
    } else {
        local_2 = false;
    }
    return float4(local_2 ? 1000000000.0 : distances.x, distances.yzw);
}

/// Distances in pixels between a pixel and the nearest pieces of edges, by the places of the edges'
/// pixels from it. The first is a silhouette, and 0 away beyond it, where a pixel is only touched,
/// unless `beyond` pixels count as those within do.
float4 edge_distances(EdgeLines edges, float4 columns, float4 rows, bool beyond)
{
    float4 across = edges.offset + edges.x * columns + edges.y * rows;
    float4 along = abs(edges.y * columns - edges.x * rows);
    // What is farther along than the edge's own pixel lies beyond the edge's end.
    float4 past = max(along - (1.0).xxxx, (0.0).xxxx);
    float inner = beyond ? abs(across.x) : max(across.x, 0.0);
    float4 side = float4(inner, abs(across.yzw));
    return sqrt(side * side + past * past);
}

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(float x)
{
    return (asuint(x) & 2139095040u) != 2139095040u;
}

/// x, or `otherwise` where x is NaN or infinite.
/// @where x is finite : x
float finite_or(float x, float otherwise)
{
    const bool is_finite_value = is_finite(x);
    return is_finite_value ? x : otherwise;
}

/// v with 0 for each component that is NaN or infinite.
/// @where v is finite : v
float3 finite_vec3(float3 v)
{
    uint3 exponent = (2139095040u).xxx;
    return choose((asuint(v) & exponent) != exponent, v, (0.0).xxx);
}

/// v with 0 for each component that is NaN or infinite.
/// @where v is finite : v
float4 finite_vec4(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return choose((asuint(v) & exponent) != exponent, v, (0.0).xxxx);
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
/// @where v is unit : v
/// @where tier is balanced and |v| <= 1e18 and otherwise = 0 :
///   v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
/// @where |v| <= 1e18 : normalize_moderate(v, otherwise)
float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!((largest > 1e-30) & (largest < 1e30))) {
        return otherwise;
    }
    float3 scaled = v * (1.0 / largest);
    float square = dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
{
    float clamped = clamp(x, -126.0, 127.99999);
    float whole = round(clamped);
    float f = clamped - whole;
    // Twice the power, so that half of 2^128 is a number. The bits of 2^-127 are those of 0.
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
}

/// 2^n for n in [-126, 127], by its bits.
float power_of_two(int n)
{
    return asfloat(uint(asint(asuint(n) + asuint(int(127)))) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(float x)
{
    uint bits = asuint(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = asint(bits - 1060439283u) >> 23u;
    float mantissa = asfloat(bits - (asuint(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return float(exponent) + z * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// ln(x) for normal x > 0.
float log_stable(float x)
{
    return LN_2 * log2_stable(x);
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(float y)
{
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(float y)
{
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return log_stable(max(1.0 - y, 1.1754944e-38));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
/// @where |x| <= 0.1 : sin_cos_tiny(x)
/// @where |x| <= 0.785 : sin_cos_eighth(x)
float2 sin_cos_quarter(float x)
{
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    float h = 0.5 * x;
    float h2 = h * h;
    float s = h * (1.0 + h2 * (-0.16666667 + h2
        * (0.008333334 + h2 * (-0.0001984127 + h2 * (2.7557319e-6 + h2 * -2.5052108e-8)))));
    float one_minus_c = h2 * (0.5 + h2
        * (-0.041666668 + h2 * (0.0013888889 + h2
        * (-2.4801588e-5 + h2 * (2.755732e-7 + h2 * -2.0876756e-9)))));
    float c = 1.0 - one_minus_c;
    return float2(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
float2 sin_cos_eighth(float x)
{
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666667 + y
        * (0.008333334 + y * (-0.0001984127 + y * 2.7557319e-6))));
    float c = 1.0 - y * (0.5 + y * (-0.041666668 + y
        * (0.0013888889 + y * (-2.4801588e-5 + y * 2.755732e-7))));
    return float2(s, c);
}

/// [`sin_cos_quarter`] for |x| <= 0.1.
float2 sin_cos_tiny(float x)
{
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666667 + y * 0.008333334));
    float c = 1.0 - y * (0.5 + y * (-0.041666668 + y * 0.0013888889));
    return float2(s, c);
}

/// sin(x/2) and cos(x/2) for x in [0, pi], given `left`, which is pi - x: both keep their relative
/// accuracy at both ends, because the smaller angle is halved and its cosine is the other's sine.
float2 sin_cos_half(float x, float left)
{
    const float2 half_ = sin_cos_quarter(0.5 * min(x, left));
    return x <= left ? half_ : half_.yx;
}

/// pi - x for x up to pi, with the digits of pi that an f32 does not hold; 0 where x is the f32
/// next to pi.
float left_to_pi(float x)
{
    // pi in two parts. The first is an f32, so that f64 reads the same one; the maximum keeps
    // compilers from making one constant of both.
    float coarse = max(3.1415927 - x, 0.0);
    return max(coarse - 8.742278e-8, 0.0);
}

/// sin(x) and cos(x) for any finite x with |x| < 1e5; [`sin_cos_quarter`] after reduction to a
/// quarter turn.
float2 sin_cos(float x)
{
    float turns = round(x * 0.31830987);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    float r = x - turns * 3.140625 - turns * 0.00096702576 - turns * 6.2783295e-7;
    float sign_ = 1.0 - 2.0 * abs(turns - 2.0 * trunc(turns * 0.5));
    return sign_ * sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
}

/// [`normalize_or`] for a third of its price: a vector shorter than 1e-15 or longer than 1e18
/// counts as having no direction.
/// @where v is unit : v
/// @where tier is balanced and |v| <= 1e18 and otherwise = 0 :
///   v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
float3 normalize_quick(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    // Comparisons are false for NaN; what `select` leaves out never reaches the result.
    bool is_usable = (square > 1e-30) & (square < 1e36);
    return is_usable ? v * rsqrt(is_usable ? square : 1.0) : otherwise;
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
/// @where v is unit : v
/// @where tier is balanced and otherwise = 0 : v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return square > 1e-30 ? v * rsqrt(max(square, 1e-30)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
float3 normalize_seen(float3 v)
{
    return normalize_moderate(v, float3(0.0, 0.0, 1.0));
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
float2 sin_cos_quick(float x)
{
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666666 + y
        * (0.0083332425 + y * (-0.0001982274 + y * 2.6347564e-6))));
    float c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (2.477458e-5 - y * 2.6297516e-7))));
    return float2(s, c);
}

/// [`sin_cos_quick`] shorter still (absolute error 4.8e-6 and 2.2e-7).
float2 sin_cos_short(float x)
{
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666542 + y * (0.008324197 - y * 0.00018846673)));
    float c = 1.0 + y * (-0.4999999 + y * (0.04166567 + y * (-0.0013868611 + y * 2.3476086e-5)));
    return float2(s, c);
}

/// log2(1 - y) for y in [0, 1): a series near 0, where 1 - y would round y away, else the
/// hardware's; -100 at 1.
float log2_one_minus(float y)
{
    float series = -y * LOG2_E * (1.0 + y * (0.5 + y * (0.33333334 + y * (0.25 + y * 0.2))));
    return y < 0.0625 ? series : log2(max(1.0 - y, 7.888609e-31));
}

Angle ConstructAngle(float half_sin, float half_cos) {
    Angle ret = (Angle)0;
    ret.half_sin = half_sin;
    ret.half_cos = half_cos;
    return ret;
}

/// The angle between the unit vectors d and l, from the chords |d - l| and |d + l|.
/// @where d is unit and l is unit : angle_of_units(d, l)
Angle angle_between(float3 d, float3 l)
{
    float p = length(d - l);
    float s = length(d + l);
    float k = 1.0 / sqrt(max(p * p + s * s, 1e-30));
    return ConstructAngle(p * k, s * k);
}

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
float atan2_positive(float y, float x)
{
    float small = min(y, x);
    float large = max(y, x);
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
float angle_radians(Angle u)
{
    return 2.0 * atan2_positive(u.half_sin, u.half_cos);
}

/// The angle of `radians`, clamped to [0, pi]; 0 where it is not finite.
Angle angle_of(float radians_)
{
    float half_angle = 0.5 * clamp(finite_or(radians_, 0.0), 0.0, PI);
    const float2 sc = sin_cos_quarter(half_angle);
    return ConstructAngle(max(sc.x, 0.0), max(sc.y, 0.0));
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, float2 t)
{
    float s = u.half_sin * t.y - u.half_cos * t.x;
    float c = u.half_cos * t.y + u.half_sin * t.x;
    float2 upper = c <= 0.0 ? float2(1.0, 0.0) : float2(s, c);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    float2 turned = ((s <= 0.0) & (s < c)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
}

/// u - shift, clamped to [0, pi], for |shift| <= pi (BADF eq. 8 and docs/math.md D3).
Angle angle_shifted(Angle u, float shift)
{
    return angle_turned(u, sin_cos_quarter(0.5 * clamp(shift, -3.1415927, PI)));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    // An infinite or NaN derivative at a silhouette gives the widest footprint.
    return min(finite_or(w, 0.5), 0.5);
}

/// [`angle_between`] for vectors that are unit but for rounding: half of each chord, without
/// normalizing the two halves again.
Angle angle_of_units(float3 d, float3 l)
{
    return ConstructAngle(0.5 * length(d - l), 0.5 * length(d + l));
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
/// @where x is finite : x
float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = bits & 2147483647u;
    float largest = asfloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// [`bounded`], component by component.
/// @where v is finite : v
float2 bounded_vec2(float2 v)
{
    uint2 bits = asuint(v);
    uint2 magnitude = bits & (2147483647u).xx;
    float2 largest = asfloat((bits & (2147483648u).xx) | (2139095039u).xx);
    const float2 numbers = choose(magnitude == (2139095040u).xx, largest, (0.0).xx);
    return choose(magnitude < (2139095040u).xx, v, numbers);
}

/// [`bounded`], component by component.
/// @where v is finite : v
float3 bounded_vec3(float3 v)
{
    uint3 bits = asuint(v);
    uint3 magnitude = bits & (2147483647u).xxx;
    float3 largest = asfloat((bits & (2147483648u).xxx) | (2139095039u).xxx);
    const float3 numbers = choose(magnitude == (2139095040u).xxx, largest, (0.0).xxx);
    return choose(magnitude < (2139095040u).xxx, v, numbers);
}

/// [`bounded`], component by component.
/// @where v is finite : v
float4 bounded_vec4(float4 v)
{
    uint4 bits = asuint(v);
    uint4 magnitude = bits & (2147483647u).xxxx;
    float4 largest = asfloat((bits & (2147483648u).xxxx) | (2139095039u).xxxx);
    const float4 numbers = choose(magnitude == (2139095040u).xxxx, largest, (0.0).xxxx);
    return choose(magnitude < (2139095040u).xxxx, v, numbers);
}

/// a / b; 0 where b is 0.
float divided(float a, float b)
{
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// x - y floor(x / y): from 0 up to y, without y, with the sign of y; 0 where y is 0.
float modulo_floored(float x, float y)
{
    float size = abs(y);
    if (size < SMALLEST_NORMAL) {
        return 0.0;
    }
    float turned = y > 0.0 ? x : -x;
    // Rounding may put the remainder just outside of its range, and far outside where x / y has no
    // digits left.
    const float left = bounded(turned - size * floor(bounded(turned / size)));
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
float powered(float base, float exponent)
{
    const float b = bounded(base);
    const float e = bounded(exponent);
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
    float magnitude = abs(b);
    const float raised = exp2_stable(bounded(e * log2_stable(max(magnitude, SMALLEST_NORMAL))));
    bool is_even = floor(e * 0.5) == e * 0.5;
    float signed_ = ((b < 0.0) & !is_even) ? -raised : raised;
    return magnitude < SMALLEST_NORMAL ? 0.0 : signed_;
}

/// [`powered`], component by component.
/// @where tier is balanced and base >= 0 and base <= 1.1 and exponent >= 1e-3 and exponent <= 500 :
///   pow(base, vec3f(exponent)) ~ 3e-4
/// @where tier is balanced and base >= 0 and base <= 1e4 and exponent >= 1e-3 and exponent <= 8 :
///   pow(base, vec3f(exponent)) ~ 3e-4
float3 powered_vec3(float3 base, float exponent)
{
    return float3(powered(base.x, exponent), powered(base.y, exponent), powered(base.z, exponent));
}

/// e^x; 0 far below, the largest number from 88.73 on.
/// @where tier is balanced and |x| <= 80 : exp(x) ~ 3e-5
float exponential_of(float x)
{
    return exp2_stable(bounded(x * LOG2_E));
}

/// ln(x); 0 and everything below count as 1.2e-38, the smallest normal number, whose logarithm is
/// -87.34.
/// @where tier is balanced and x >= 1e-30 and x <= 1e30 : log(x) ~ 2e-5
float logarithm_of(float x)
{
    return log_stable(max(bounded(x), SMALLEST_NORMAL));
}

/// Mix from a (where t is 0) to b (where t is 1): exact at both ends, and where a is b.
/// @where a = 0 and b = 1 and |t| <= 1e15 : t
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
float mixed(float a, float b, float t)
{
    const float d = bounded(b - a);
    return bounded(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
float2 mixed_vec2(float2 a, float2 b, float t)
{
    const float2 d = bounded_vec2(b - a);
    return bounded_vec2(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
float3 mixed_vec3(float3 a, float3 b, float t)
{
    const float3 d = bounded_vec3(b - a);
    return bounded_vec3(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
float4 mixed_vec4(float4 a, float4 b, float t)
{
    const float4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(float x, float low, float high)
{
    float span = high - low;
    if (abs(span) < SMALLEST_NORMAL) {
        return x >= high ? 1.0 : 0.0;
    }
    return bounded((x - low) / bounded(span));
}

/// x moved from one range to another, kept within the new one when `clamped`; an empty first range
/// makes a step.
float remapped(float x, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float place = place_between(bounded(x), bounded(from_low), bounded(from_high));
    const float bounded_value = bounded(to_low);
    const float bounded_value_1 = bounded(to_high);
    return mixed(bounded_value, bounded_value_1, clamped ? clamp(place, 0.0, 1.0) : place);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
/// @where low < high and x is finite and |low| <= 1e30 and |high| <= 1e30 :
///   smoothstep(low, high, x)
float eased(float x, float low, float high)
{
    float t = clamp(place_between(bounded(x), bounded(low), bounded(high)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A factor as it is, or kept within 0 and 1 when `clamped`.
float factor_of(float x, bool clamped)
{
    const float bounded_value = bounded(x);
    const float bounded_value_1 = bounded(x);
    return clamped ? clamp(bounded_value_1, 0.0, 1.0) : bounded_value;
}

/// The length of v, also where its square would over- or underflow.
/// @where |v| <= 1e18 : length(v)
float length_of(float3 v)
{
    const float3 w = bounded_vec3(v);
    float largest = max(max(abs(w.x), abs(w.y)), abs(w.z));
    if (largest < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(largest * length(w / (largest).xxx));
}

/// sin(r) for |r| <= 1.6, a quarter turn and some more: a minimax polynomial (absolute error below
/// 6e-9 beside rounding).
float sine_low(float r)
{
    float y = r * r;
    float high = mad(y, 2.5930888e-6, -0.00019803418);
    float s = mad(r * y, mad(y, mad(y, high, 0.008332972), -0.16666655), r);
    return clamp(s, -1.0, 1.0);
}

/// sin(r + pi turns) for |r| <= 1.6 and whole turns.
float sine_turned(float r, float turns)
{
    // Odd turns, of which half is left, turn the sign.
    return sine_low(r) * mad(frac(turns * 0.5), -4.0, 1.0);
}

/// sin(x) for every x, in [-1, 1]; beyond 100,000 rounding leaves nothing of the phase. The form of
/// the balanced tier takes x as off by a rounding or two, which far from 0 is more than its bound.
/// @where tier is balanced and |x| <= 1e7 : sin(x) ~ 5e-5
/// @where |x| <= 1.6 : sine_low(x)
/// @where x >= 0 and x <= 4.17 : cosine_low(x - 1.57079632679489662)
/// @where x >= 1.55 and x <= 4.73 : sine_low((3.140625 - x) + 0.000967653589793238463)
/// @where x >= 2.12 and x <= 7.31 : -cosine_low(x - 4.71238898038468986)
/// @where |x| <= 3000 : sine_near(x)
float sine_of(float x)
{
    const float b = bounded(x);
    float turns = round(b * 0.31830987);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    float coarse = mad(turns, -0.00096702576, mad(turns, -3.140625, b));
    float r = mad(turns, -6.2783295e-7, coarse);
    // Far out, rounding of the turns leaves somewhat more than a quarter turn.
    return sine_turned(clamp(r, -1.6, 1.6), turns);
}

/// [`sine_of`] where two parts of pi are enough.
float sine_near(float x)
{
    float turns = round(x * 0.31830987);
    float r = mad(turns, -0.0009676536, mad(turns, -3.140625, x));
    return sine_turned(r, turns);
}

/// cos(x) for every x, in [-1, 1]; beyond 100,000 rounding leaves nothing of the phase. The form of
/// the balanced tier is that of [`sine_of`].
/// @where tier is balanced and |x| <= 1e7 : cos(x) ~ 5e-5
/// @where |x| <= 2.6 : cosine_low(x)
/// @where x >= 0 and x <= 3.17 : sine_low((1.5703125 - x) + 0.000483826794896619231)
/// @where x >= 0.55 and x <= 5.74 : -cosine_low(x - 3.14159265358979324)
/// @where |x| <= 3000 : cosine_near(x)
float cosine_of(float x)
{
    const float b = bounded(x);
    float turns = round(b * 0.31830987 - 0.5);
    float middle = turns + 0.5;
    float coarse = mad(middle, -0.00096702576, mad(middle, -3.140625, b));
    float r = mad(middle, -6.2783295e-7, coarse);
    return sine_turned(-clamp(r, -1.6, 1.6), turns);
}

/// [`cosine_of`] where two parts of pi are enough.
float cosine_near(float x)
{
    float turns = round(x * 0.31830987 - 0.5);
    float middle = turns + 0.5;
    float r = mad(middle, 0.0009676536, mad(middle, 3.140625, -x));
    return sine_turned(r, turns);
}

/// cos(r) for |r| <= 2.6: a minimax polynomial (absolute error below 2e-9 beside rounding) that is
/// 1 at 0 and below that elsewhere.
float cosine_low(float r)
{
    float y = r * r;
    float high = mad(y, mad(y, 1.8474174e-9, -2.7357322e-7), 2.4793637e-5);
    return mad(y, mad(y, mad(y, mad(y, high, -0.0013888741), 0.041666657), -0.5), 1.0);
}

/// sin(x) and cos(x) for every x; beyond 100,000 rounding leaves nothing of the phase, and the
/// result lies in [-1, 1].
/// @where tier is balanced and |x| <= 1000 : vec2f(sin(x), cos(x)) ~ 5e-5
float2 sin_cos_of(float x)
{
    return clamp(sin_cos(bounded(x)), (-1.0).xx, (1.0).xx);
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
float angle_of_point(float y, float x)
{
    // Coordinates are halved where they are large, so that the sum of both stays finite.
    float2 p = abs(bounded_vec2(float2(x, y)));
    float2 scaled = max(p.x, p.y) > 1.0 ? 0.5 * p : p;
    const float a = atan2_positive(scaled.y, scaled.x);
    float turned = x < 0.0 ? PI - a : a;
    return y < 0.0 ? -turned : turned;
}

/// Farthest that a line is known from its edge, in pixels: so many steps of 1/800 of the picture's
/// height, and at most 31 pixels, as far as an offset fits into a texel.
float line_reach(float viewport_height, float steps)
{
    return min(steps * max(round(viewport_height / 800.0), 1.0), 31.0);
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
float4 own_nearness(float4 nearness, float2 middle, float depth, float object, float pixels,
    float reach)
{
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    bool is_same_object = middle.y == object_number(object);
    float behind = (depth - middle.x) * pixels;
    if (!(abs(middle.y) < 0.5)) {
        if (is_same_object) {
            local_4 = abs(behind) <= 8.0625;
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
    float4 other = float4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

/// A number of pixels that a width says, 0 or more and less than any reach needs.
float line_pixels(float width, float pixels)
{
    return clamp(bounded(width), 0.0, 1000000.0) * clamp(bounded(pixels), 0.0, 1000000.0);
}

LineWidths ConstructLineWidths(float4 kinds, float ids) {
    LineWidths ret = (LineWidths)0;
    ret.kinds = kinds;
    ret.ids = ids;
    return ret;
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths(float width, float4 shares, float ids)
{
    float4 widths = min(width, 10000.0) * clamp(bounded_vec4(shares), (0.0).xxxx, (100.0).xxxx);
    float id_width = min(width, 10000.0) * clamp(bounded(ids), 0.0, 100.0);
    const float4 choose_value = choose(widths > (1e-6).xxxx, widths, (0.0).xxxx);
    const LineWidths linewidths = ConstructLineWidths(choose_value, id_width
        > 1e-6 ? id_width : 0.0);
    // What no pixel can show is no line.
    return linewidths;
}

/// Widths of the four lines that are near: a negative nearness in the place of materials is that of
/// a border of ids.
float4 widths_near(float4 nearness, LineWidths widths)
{
    return float4(widths.kinds.xyz, nearness.w < 0.0 ? widths.ids : widths.kinds.w);
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
float inner_line_covers(float distance_, float width)
{
    return clamp(width + 0.5 - distance_, 0.0, min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
float4 middle_line_covers(float4 distance_, float4 width)
{
    float4 half_ = 0.5 * width;
    return clamp(min(distance_ + (0.5).xxxx, half_) - max(distance_ - (0.5).xxxx, -half_),
        (0.0).xxxx, (1.0).xxxx);
}

/// What a line of any kind covers of a pixel, by how much nearer than the reach the edges of each
/// kind are: all lie evenly on both sides.
float any_line_covers(float4 nearness, LineWidths widths, float reach)
{
    float4 near = clamp(bounded_vec4(nearness), (-reach).xxxx, (reach).xxxx);
    const float4 own = choose(abs(near) > (1e-6).xxxx, widths_near(near, widths), (0.0).xxxx);
    const float4 covers = middle_line_covers((reach).xxxx - abs(near), own);
    return max(max(covers.x, covers.y), max(covers.z, covers.w));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
float4 lines_cover(float4 nearness, float4 widths, float reach)
{
    float4 distance_ = (reach).xxxx - nearness;
    float4 covers = float4(inner_line_covers(distance_.x, widths.x),
        middle_line_covers(distance_, widths).yzw);
    return choose(nearness > (1e-6).xxxx, covers, (0.0).xxxx);
}

/// True if a texel belongs to the surface of a plane, so many pixels away.
bool is_same_surface(Plane own, float4 texel, float2 offset)
{
    bool local_5 = (bool)0;

    float error = abs(texel.z - own.depth - dot(own.rise, offset));
    if (object_in(texel.w) == object_in(own.object)) {
        local_5 = error <= 3.0 * own.tolerance * max(length(offset), 1.0);
    } else {
        local_5 = false;
    }
    return local_5;
}

int naga_neg(int val) {
    return asint(0u - asuint(val));
}

/// The nearest edge of each kind in a pixel's own column: the coarse code of each, with its row
/// from the pixel; 0 for none, negative for a border of ids. `reach` is how far edges are looked
/// for, in pixels; `of_all` if those of other surfaces count, too.
float4 nearest_in_column(int2 pixel, Plane own, int reach, bool of_all)
{
    float4 nearest = (1000000000.0).xxxx;
    float4 codes = (0.0).xxxx;
    bool local_6 = (bool)0;

    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    for (int row = max(naga_neg(reach), naga_neg(pixel.y)); row
        <= min(reach, asint(asuint(last.y) - asuint(pixel.y))); row++) {
        int2 at = asint(asuint(pixel) + asuint(int2(int(0), row)));
        float4 found = edges.Load(int3(at, int(0)));
        if (all(found == (0.0).xxxx)) {
            continue;
        }
        if (!of_all) {
            local_6 = !is_same_surface(own, surface.Load(int3(at, int(0))),
                float2(0.0, float(row)));
        } else {
            local_6 = false;
        }
        if (local_6) {
            continue;
        }
        float4 fine = abs(found);
        const float4 middle_distances_value = middle_distances(edges_of(fine, 4096.0), (0.0).xxxx,
            (float(row)).xxxx, of_all);
        const float4 distances = choose(fine > (0.0).xxxx, middle_distances_value,
            (1000000000.0).xxxx);
        bool4 is_nearer = distances < nearest;
        nearest = choose(is_nearer, distances, nearest);
        float4 coarse = coarse_codes(fine) + (262144.0 * (float(row) + 31.0)).xxxx;
        codes = choose(is_nearer, choose(found < (0.0).xxxx, -coarse, coarse), codes);
    }
    return codes;
}

float4 vs_main(uint index : SV_VertexID) : SV_Position
{
    return whole_picture(index);
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    float4 position = input.position_1;
    bool local = (bool)0;

    int2 pixel = to_int(position.xy);
    float4 seen = seen_pixel(pixel).texel;
    if (true) {
        local = seen.w == 0.0;
    } else {
        local = false;
    }
    if (local) {
        return (0.0).xxxx;
    }
    const float reach = line_reach(curvature.viewport_height, 16.0);
    const Plane own = plane_of(abs(seen.w), seen.z, normal_of(seen));
    return nearest_in_column(pixel, own, to_int(reach), false);
}
