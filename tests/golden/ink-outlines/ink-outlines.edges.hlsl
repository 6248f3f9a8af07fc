// Ink outlines: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds where surfaces end, fold and meet.
// Registers of space 0: surface t0, curvature b0.
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

/// What a pixel shows: a piece of a surface.
struct Facet {
    /// Unit, in camera axes.
    float3 normal;
    /// Toward the eye in camera axes, of a length of 1 and more.
    float3 toward;
    float depth;
    /// The texel's number: the object's, the material's and the id's.
    float number;
    /// Change of depth from a pixel to the next, along columns and rows.
    float2 rise;
    /// The same where the surface is not seen as steeply: at least LEAST_NZ of it faces the eye.
    float2 gentle_rise;
};

/// A piece of an edge: its kind, the unit normal of a straight line in pixels of the image, and how
/// far along it from the pixel's middle the line lies.
struct Edge {
    int kind;
    float2 normal;
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

Texture2D<float4> surface : register(t0);
cbuffer curvature : register(b0) { Curvature curvature; }

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
    bool local = (bool)0;

    seen = ConstructSeenPixel(pixel, surface.Load(int3(pixel, int(0))));
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    if (curvature.samples >= 2.0) {
        local = seen.texel.w == 0.0;
    } else {
        local = false;
    }
    bool may_be_missed = local;
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
    bool local_1 = (bool)0;

    float4 x = columns + edges.x * edges.offset;
    float4 y = rows + edges.y * edges.offset;
    float inward = x.x * edges.x.x + y.x * edges.y.x;
    float4 distances = sqrt(x * x + y * y);
    if (inward < -1.0) {
        local_1 = !beyond;
    } else {
        local_1 = false;
    }
    return float4(local_1 ? 1000000000.0 : distances.x, distances.yzw);
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

/// Size in scene units of a pixel at a depth.
float pixel_size_at(float depth)
{
    return curvature.pixel * lerp(1.0, depth, curvature.perspective);
}

Facet ConstructFacet(float3 normal, float3 toward, float depth, float number, float2 rise,
    float2 gentle_rise) {
    Facet ret = (Facet)0;
    ret.normal = normal;
    ret.toward = toward;
    ret.depth = depth;
    ret.number = number;
    ret.rise = rise;
    ret.gentle_rise = gentle_rise;
    return ret;
}

Facet facet_at(int2 at)
{
    float4 texel = surface.Load(int3(at, int(0)));
    const float3 normal = normal_of(texel);
    float2 middle = 0.5 * float2(NagaDimensions2D(surface));
    float2 from_middle = (float2(at) + (0.5).xx - middle) * float2(1.0, row_direction());
    float3 toward = float3(-curvature.pixel * curvature.perspective * from_middle, 1.0);
    float facing = dot(normal, toward);
    float2 change = pixel_size_at(texel.z) * normal.xy * float2(1.0, row_direction());
    return ConstructFacet(normal, toward, texel.z, abs(texel.w), change / (max(facing, 0.02)).xx,
        change / (max(facing, 0.2)).xx);
}

/// True if the surfaces of two neighbors meet between them. The nearer one may not reach the other
/// more steeply than [`LEAST_NZ`] allows: then it ends in front.
bool meets(Facet own, Facet other, float2 step_)
{
    bool local_2 = (bool)0;

    bool is_nearer = own.depth <= other.depth;
    float rise = dot(is_nearer ? own.gentle_rise : own.rise, step_);
    float other_rise = dot(is_nearer ? other.rise : other.gentle_rise, step_);
    float here = own.depth - (other.depth - other_rise);
    float there = own.depth + rise - other.depth;
    float steepness = min(length(own.gentle_rise), length(other.gentle_rise));
    float tolerance = pixel_size_at(min(own.depth, other.depth)) + steepness;
    if (!(here * there <= 0.0)) {
        local_2 = min(abs(here), abs(there)) <= tolerance;
    } else {
        local_2 = true;
    }
    return local_2;
}

/// True if a pixel shows the surface with this number, no farther than `limit`.
bool shows(int2 at, float number, float limit)
{
    bool local_3 = (bool)0;

    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 texel = surface.Load(int3(clamp(at, (int(0)).xx, last), int(0)));
    if (abs(texel.w) == number) {
        local_3 = texel.z < limit;
    } else {
        local_3 = false;
    }
    return local_3;
}

Course ConstructCourse(float place, float slope, float trust) {
    Course ret = (Course)0;
    ret.place = place;
    ret.slope = slope;
    ret.trust = trust;
    return ret;
}

/// The course that fits rows best.
Course fitted_course(CourseSums sums, bool is_arc)
{
    float trust = sums.count / 11.0;
    float spread = sums.count * sums.xx - sums.x * sums.x;
    float slope = (sums.count * sums.xy - sums.x * sums.y) / spread;
    float straight = (sums.y - slope * sums.x) / sums.count;
    if (trust < 1.0) {
        return ConstructCourse(clamp(straight, 0.0, 1.0), slope, trust);
    }
    // Over all rows x sums to 0, its fourth powers to 1958.
    float bent = (1958.0 * sums.y - sums.xx * sums.xxy) / (sums.count * 1958.0 - sums.xx * sums.xx);
    float left = (sums.yy - straight * sums.y - slope * sums.xy) / sums.count;
    float share = clamp((left - 0.09) / 0.05, 0.0, 1.0);
    return ConstructCourse(clamp(lerp(straight, bent, is_arc ? 1.0 : share), 0.0, 1.0), slope,
        trust);
}

int2 naga_abs(int2 val) {
    return max(val, asint(0u - asuint(val)));
}

typedef float2 ret_Constructarray2_float2_[2];
ret_Constructarray2_float2_ Constructarray2_float2_(float2 arg0, float2 arg1) {
    float2 ret[2] = { arg0, arg1 };
    return ret;
}

CourseSums ConstructCourseSums(float count, float x, float y, float xx, float xy, float yy,
    float xxy) {
    CourseSums ret = (CourseSums)0;
    ret.count = count;
    ret.x = x;
    ret.y = y;
    ret.xx = xx;
    ret.xy = xy;
    ret.yy = yy;
    ret.xxy = xxy;
    return ret;
}

/// The course of the edge between a pixel and its neighbor, by the pixels at which it changes over
/// from one row to the next. A flat course passes the middle of a pixel near each such change; a
/// steep or bent one is fitted.
Course course_at(int2 pixel, int2 step_, float number, float limit)
{
    // The first change to both sides: how far along, and how far beyond the pixel.
    float2 ends[2] = Constructarray2_float2_((0.0).xx, (0.0).xx);
    int changes = int(0);
    CourseSums sums = ConstructCourseSums(1.0, 0.0, 0.5, 0.0, 0.0, 0.25, 0.0);
    int height = (int)0;
    bool is_open = (bool)0;
    int row = (int)0;
    bool local_4 = (bool)0;
    bool local_5 = (bool)0;
    int change = (int)0;
    bool local_6 = (bool)0;
    bool local_7 = (bool)0;
    bool local_8 = (bool)0;
    bool local_9 = (bool)0;
    bool local_10 = (bool)0;
    bool local_11 = (bool)0;

    int2 along = naga_abs(step_.yx);
    for (int side = 0; side < 2; side++) {
        int2 way = asint(asuint(along) * asuint(asint(asuint(int(1))
            - asuint(asint(asuint(int(2)) * asuint(side))))));
        height = int(0);
        is_open = true;
        row = int(1);
        while(true) {
            if (row <= int(12)) {
                if (!is_open) {
                    local_5 = row <= int(5);
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
                int2 at = asint(asuint(asint(asuint(pixel)
                    + asuint(asint(asuint(way) * asuint(row)))))
                    + asuint(asint(asuint(step_) * asuint(height))));
                change = int(0);
                if (shows(at, number, limit)) {
                    if (shows(asint(asuint(at) + asuint(step_)), number, limit)) {
                        change = int(1);
                    }
                } else {
                    change = int(-1);
                }
                if (change > int(0)) {
                    local_6 = shows(asint(asuint(at)
                        + asuint(asint(asuint(int(2)) * asuint(step_)))), number, limit);
                } else {
                    local_6 = false;
                }
                if (local_6) {
                    break;
                }
                if (change < int(0)) {
                    local_7 = !shows(asint(asuint(at) - asuint(step_)), number, limit);
                } else {
                    local_7 = false;
                }
                if (local_7) {
                    break;
                }
                if (change != int(0)) {
                    if (is_open) {
                        ends[min(uint(side), 1u)] = float2(float(row) - 0.5,
                            float(max(height, asint(asuint(height) + asuint(change)))));
                        is_open = false;
                    }
                    changes = asint(asuint(changes) + asuint(row <= int(5) ? int(1) : int(0)));
                    height = asint(asuint(height) + asuint(change));
                }
                if (row <= int(5)) {
                    float x = float(asint(asuint(row)
                        * asuint(asint(asuint(int(1))
                        - asuint(asint(asuint(int(2)) * asuint(side)))))));
                    float y = float(height) + 0.5;
                    sums.count = sums.count + 1.0;
                    sums.x = sums.x + x;
                    sums.y = sums.y + y;
                    sums.xx = sums.xx + x * x;
                    sums.xy = sums.xy + x * y;
                    sums.yy = sums.yy + y * y;
                    sums.xxy = sums.xxy + x * x * y;
                }
                row = asint(asuint(row) + asuint(int(1)));
            }
        }
        if (is_open) {
            ends[min(uint(side), 1u)] = float2(float(row) - 0.5, float(height) + 0.5);
        }
    }
    float length_ = ends[0].x + ends[1].x;
    float slope = (ends[0].y - ends[1].y) / length_;
    float place = ends[1].y + slope * ends[1].x;
    if (ends[0].y == ends[1].y) {
        local_8 = place != 0.5;
    } else {
        local_8 = false;
    }
    bool is_arc = local_8;
    if (!(changes >= int(3))) {
        if (is_arc) {
            local_10 = changes >= int(2);
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
    float rise = is_arc ? 4.0 * ends[0].x * ends[1].x / (length_ * length_) : 0.0;
    float trust = sums.count / 11.0;
    return ConstructCourse(clamp(lerp(place, 0.5, rise), 0.0, 1.0), slope, trust);
}

/// Square of how much a facet faces the eye; negative for one that is turned away.
float facing_squared(Facet facet)
{
    float facing = dot(facet.normal, facet.toward);
    return facing * abs(facing) / dot(facet.toward, facet.toward);
}

float2 course_normal(Course course, float2 toward)
{
    float2 along = abs(toward.yx);
    return (toward - course.slope * along) / (sqrt(1.0 + course.slope * course.slope)).xx;
}

Edge ConstructEdge(int kind, float2 normal, float offset, float trust) {
    Edge ret = (Edge)0;
    ret.kind = kind;
    ret.normal = normal;
    ret.offset = offset;
    ret.trust = trust;
    return ret;
}

Edge edge_along(int kind, Course course, float2 toward, float2 normal)
{
    float lean = dot(normal, toward);
    return ConstructEdge(kind, normal, course.place * lean, course.trust * lean);
}

/// The edge of a surface that ends in front of what is farther than `limit`, or of another object.
Edge silhouette(Facet own, int2 pixel, int2 step_, float limit)
{
    bool local_12 = (bool)0;
    bool local_13 = (bool)0;
    bool local_14 = (bool)0;

    float2 toward = float2(step_);
    const Course course = course_at(pixel, step_, own.number, limit);
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    const Facet before = facet_at(clamp(asint(asuint(pixel) - asuint(step_)), (int(0)).xx, last));
    // Near its outline the facing of a round form goes like the root of the distance.
    const float facing = facing_squared(own);
    float change = facing_squared(before) - facing;
    float2 across = own.normal.xy * float2(1.0, row_direction());
    float2 normal = across / (max(length(across), 1e-6)).xx;
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
        local_14 = dot(normal, toward) > 0.5;
    } else {
        local_14 = false;
    }
    bool is_round = local_14;
    float found = facing / max(change, 0.0001);
    float place = clamp(found, 0.0, 1.0);
    // As far as this is not between the pixels, the form is not as round as its normals.
    float trust = is_round ? clamp(2.0 - 4.0 * abs(found - place), 0.0, 1.0) : 0.0;
    Course seen = ConstructCourse(lerp(course.place, place, trust), course.slope,
        lerp(course.trust, 1.0, trust));
    float2 turned = lerp(course_normal(course, toward), normal, trust);
    return edge_along(int(0), seen, toward, turned / (length(turned)).xx);
}

/// Change of the normal between two neighbors that a round form would have: what it is to both
/// sides of them.
float round_bend(Facet own, Facet other, int2 pixel, int2 step_)
{
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 before = surface.Load(int3(clamp(asint(asuint(pixel) - asuint(step_)), (int(0)).xx,
        last), int(0)));
    float4 after = surface.Load(int3(clamp(asint(asuint(pixel)
        + asuint(asint(asuint(int(2)) * asuint(step_)))), (int(0)).xx, last), int(0)));
    float2 bends = float2(length(normal_of(before) - own.normal),
        length(normal_of(after) - other.normal));
    float2 numbers = float2(abs(before.w), abs(after.w));
    const float2 shares = choose(numbers == (own.number).xx, (1.0).xx, (0.0).xx);
    return dot(bends, shares) / max(shares.x + shares.y, 1.0);
}

/// The edge between a pixel and its neighbor.
Edge edge_between(Facet own, int2 pixel, int2 step_)
{
    bool local_15 = (bool)0;
    bool local_16 = (bool)0;

    Edge none = ConstructEdge(int(-1), (0.0).xx, 0.0, 0.0);
    int2 at = asint(asuint(pixel) + asuint(step_));
    if (!any(at < (int(0)).xx)) {
        local_15 = any(at >= int2(NagaDimensions2D(surface)));
    } else {
        local_15 = true;
    }
    if (local_15) {
        return none;
    }
    const Facet other = facet_at(at);
    if (other.number == 0.0) {
        return silhouette(own, pixel, step_, 1000000000.0);
    }
    float2 toward = float2(step_);
    bool is_same_object = object_in(own.number) == object_in(other.number);
    if (!meets(own, other, toward)) {
        if (own.depth > other.depth) {
            return none;
        }
        float middle = 0.5 * (own.depth + other.depth);
        return silhouette(own, pixel, step_, is_same_object ? middle : 1000000000.0);
    }
    if (!is_same_object) {
        return ConstructEdge(int(2), (0.0).xx, 0.0, 0.0);
    }
    if (own.number != other.number) {
        bool is_material = material_in(own.number) != material_in(other.number);
        int kind = is_material ? int(3) : int(4);
        return ConstructEdge(kind, (0.0).xx, 0.0, 0.0);
    }
    float bend = length(own.normal - other.normal);
    if (!(bend < 0.5176381)) {
        local_16 = bend - round_bend(own, other, pixel, step_) < 0.5176381;
    } else {
        local_16 = true;
    }
    if (local_16) {
        return none;
    }
    return ConstructEdge(int(1), (0.0).xx, 0.0, 0.0);
}

/// The line in which the planes of two facets meet, or along which a border runs over one plane.
Edge meeting(Facet own, int2 pixel, int2 step_, int kind)
{
    bool local_17 = (bool)0;

    const Facet other = facet_at(asint(asuint(pixel) + asuint(step_)));
    float2 toward = float2(step_);
    float2 slope = own.rise - other.rise;
    float steepness = length(slope);
    float here = own.depth - (other.depth - dot(other.rise, toward));
    float side = dot(slope, toward);
    if (abs(side) > 0.1 * pixel_size_at(own.depth)) {
        local_17 = abs(side) > 0.3 * steepness;
    } else {
        local_17 = false;
    }
    if (local_17) {
        float share = clamp(-here / side, 0.0, 1.0);
        float2 normal = slope / (side > 0.0 ? steepness : -steepness).xx;
        float lean = dot(normal, toward);
        return ConstructEdge(kind, normal, share * lean, lean);
    }
    if (kind == int(1)) {
        return ConstructEdge(kind, toward, 0.5, 0.0);
    }
    const Course course = course_at(pixel, step_, own.number, 1000000000.0);
    return edge_along(kind, course, toward, course_normal(course, toward));
}

/// True if a surface plainly goes on to a neighbor, which most do: that costs little to tell.
bool goes_on(Facet own, float2 slope, float size, int2 pixel, int2 step_)
{
    bool local_18 = (bool)0;
    bool local_19 = (bool)0;

    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 texel = surface.Load(int3(clamp(asint(asuint(pixel) + asuint(step_)), (int(0)).xx, last),
        int(0)));
    float2 change = abs(texel.xy - slope);
    float error = abs(texel.z - own.depth - dot(own.gentle_rise, float2(step_)));
    if (abs(texel.w) == own.number) {
        local_18 = error <= size;
    } else {
        local_18 = false;
    }
    if (local_18) {
        local_19 = max(change.x, change.y) < 0.35;
    } else {
        local_19 = false;
    }
    return local_19;
}

/// Codes of the edges of each kind between a pixel and the four beside it, those that are known
/// best; 0 for none, and negative for borders of ids.
float4 edges_at(int2 pixel)
{
    uint left = 0u;
    float4 codes = (0.0).xxxx;
    float4 trust = (-1.0).xxxx;
    Edge edge = (Edge)0;

    const Facet own = facet_at(pixel);
    if (own.number == 0.0) {
        return (0.0).xxxx;
    }
    float2 slope = surface.Load(int3(pixel, int(0))).xy;
    const float size = pixel_size_at(own.depth);
    for (int index = 0; index < 4; index++) {
        const bool goes_on_value = goes_on(own, slope, size, pixel, around(index));
        left = left | (goes_on_value ? 0u : (1u << uint(index)));
    }
    // Most pixels have no round at all: what a loop does not enter costs nothing everywhere.
    for (int index_1 = left == 0u ? 4 : 0; index_1 < 4; index_1++) {
        if (((left >> uint(index_1)) & 1u) == 0u) {
            continue;
        }
        const int2 step_ = around(index_1);
        edge = edge_between(own, pixel, step_);
        if (edge.kind == int(-1)) {
            continue;
        }
        if (edge.kind != int(0)) {
            edge = meeting(own, pixel, step_, edge.kind);
        }
        int place = min(edge.kind, int(3));
        bool4 is_kind = (place).xxxx == int4(int(0), int(1), int(2), int(3));
        bool4 is_better = is_kind & ((edge.trust).xxxx > trust);
        trust = choose(is_better, (edge.trust).xxxx, trust);
        const float code = edge_code(edge.normal, edge.offset);
        codes = choose(is_better, (edge.kind == int(4) ? -code : code).xxxx, codes);
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
    return edges_at(to_int(position.xy));
}
