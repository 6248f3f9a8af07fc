// Ink outlines: made by Chiaro 0.1.0, WGSL.
// Finds the nearest edges in each pixel's column.
// Bindings of group 0: surface 0, curvature 1, edges 2.
// ink-outlines.json says what to put there and how to draw.

// Slopes of a surface over the picture, and the texels by which passes over the picture know it
// (docs/math.md 3.3).

/// The least n.z that divides: beyond it every rim would saturate to convex.
const LEAST_NZ = 0.2;

/// The slope n.xy / n.z of a normal in camera axes.
fn slope_of(normal: vec3f) -> vec2f {
    return normal.xy / max(normal.z, LEAST_NZ);
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
fn surface_texel(normal: vec3f, depth: f32, number: f32) -> vec4f {
    return vec4f(slope_of(normal), depth, select(number, -number, normal.z < 0.0));
}

/// Materials of an object, ids and objects that the numbers of texels tell apart; beyond that many
/// they repeat.
const MATERIALS = 32.0;
const IDS = 128.0;
const OBJECTS = 4096.0;

/// The number of an object in texels, from 1 on.
fn object_number(object: f32) -> f32 {
    return object - OBJECTS * floor(object / OBJECTS) + 1.0;
}

/// The number of a facet for [`surface_texel`]: the object's, from 1 on, and what materials and
/// ids add, less than 1. `id` is rounded to a whole number; what is none, or beyond a million, is
/// 0.
fn facet_number(object: f32, material: f32, id: f32) -> f32 {
    let whole = round(select(0.0, id, abs(id) <= 1e6));
    let parts = IDS * (material - MATERIALS * floor(material / MATERIALS))
        + whole - IDS * floor(whole / IDS);
    return object_number(object) + parts / (MATERIALS * IDS);
}

/// The normal that a texel was made from.
fn normal_of(texel: vec4f) -> vec3f {
    // Below LEAST_NZ the slope is n.xy by a constant, and n.z is what is left of the length 1;
    // elsewhere that is no less than LEAST_NZ, and the normal points along the slope and 1.
    let aside = LEAST_NZ * texel.xy;
    let rest = sqrt(max(1.0 - dot(aside, aside), 0.0));
    let nz = select(rest, -rest, texel.w < 0.0);
    let facing = vec3f(texel.xy, 1.0) / sqrt(1.0 + dot(texel.xy, texel.xy));
    return select(vec3f(aside, nz), facing, nz >= LEAST_NZ);
}
// View-centered mean curvature from screen-space slopes (docs/math.md 3), for the curvature passes:
// half the divergence of n.xy / n.z, in camera axes.
//
// Convex is positive. The result is in 1/viewport-height, so that a picture at twice the resolution
// shows the same. A neighbor counts only where it lies on the same surface: on the same object,
// and no farther in depth than the normal's slope explains; otherwise the difference is one-sided,
// and 0 where no neighbor is left.
//
// Fetches are most of what this costs: each neighbor is read once, and brings its slope ready made.
                     

struct Curvature {
    /// The size of a pixel in scene units: at depth 1 for perspective, at every depth for parallel
    /// projection.
    pixel: f32,
    /// 1 for perspective, 0 for parallel projection.
    perspective: f32,
    /// Height of the picture, in pixels.
    viewport_height: f32,
    /// 1 where the first row of an image is at the bottom of the picture (OpenGL), 0 where it is at
    /// the top.
    rows_up: f32,
    /// Samples per pixel of the picture.
    samples: f32,
}

/// The surface that each pixel shows, packed by [`surface_texel`]; 0 where nothing is.
@group(0) @binding(0) var surface: texture_2d<f32>;
@group(0) @binding(1) var<uniform> curvature: Curvature;

/// The least n.z that divides where depths are compared.
const LEAST_DEPTH_NZ = 0.02;
/// Tolerated difference in depth to a neighbor, in multiples of the change that the slope
/// explains.
const DEPTH_TOLERANCE = 2.0;
/// Largest curvature, in 1/viewport-height: beyond, it says no more.
const MOST = 1e4;
/// Weights of the neighbors one, two and three steps away: a derivative of a Gaussian, which does
/// not see the noise of single normals.
const WEIGHT_1 = 1.0;
const WEIGHT_2 = 0.85;
const WEIGHT_3 = 0.5;

/// A triangle over the whole picture.
fn whole_picture(index: u32) -> vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

/// A step in pixels: a share of the picture's height, so that a larger picture measures the same
/// curvature, not a finer one.
fn step_pixels() -> i32 {
    return max(i32(round(curvature.viewport_height / 800.0)), 1);
}

/// 1 where a row of the image lies above the row before it, -1 where it lies below.
fn row_direction() -> f32 {
    return select(-1.0, 1.0, curvature.rows_up > 0.5);
}

/// Offset to one of the eight pixels around a pixel, by an index from 0 to 7; the nearest first.
fn around(index: i32) -> vec2i {
    let side = 1 - 2 * (index & 1);
    let straight = select(vec2i(0, side), vec2i(side, 0), index < 2);
    return select(straight, vec2i(side, 1 - (index & 2)), index > 3);
}

/// A pixel and its texel of the surface.
struct SeenPixel {
    at: vec2i,
    texel: vec4f,
}

/// The pixel whose surface a pixel has: its own, or that of a neighbor.
///
/// With several samples a pixel, a look also shades pixels whose middle the object just misses:
/// they have the surface of the nearest of the eight pixels around that shows one.
fn seen_pixel(pixel: vec2i) -> SeenPixel {
    var seen = SeenPixel(pixel, textureLoad(surface, pixel, 0));
    let last = vec2i(textureDimensions(surface)) - 1;
    let may_be_missed = curvature.samples >= 2.0 && seen.texel.w == 0.0;
    // The nearest comes last and stays: leaving the loop early costs more than it saves. Mostly it
    // has no round at all; a compiler that knew of eight would unroll them for every pixel.
    for (var index = select(-1, 7, may_be_missed); index >= 0; index--) {
        let near = clamp(pixel + around(index), vec2i(0), last);
        let texel = textureLoad(surface, near, 0);
        if texel.w != 0.0 {
            seen = SeenPixel(near, texel);
        }
    }
    return seen;
}

/// The plane of the surface at a pixel: it tells which neighbors lie on the same surface. Changes
/// of depth are along columns and rows of the image.
struct Plane {
    object: f32,
    depth: f32,
    /// Change of depth from a pixel to the next.
    rise: vec2f,
    /// Tolerated difference of a neighbor's depth, for each pixel that the neighbor is away.
    tolerance: f32,
}

fn plane_of(object: f32, depth: f32, normal: vec3f) -> Plane {
    let pixel = curvature.pixel * mix(1.0, depth, curvature.perspective);
    let gradient = normal.xy / max(normal.z, LEAST_DEPTH_NZ);
    return Plane(object, depth, pixel * gradient * vec2f(1.0, row_direction()),
        DEPTH_TOLERANCE * pixel * (1.0 + length(gradient)));
}

/// Weights of four neighbors that are `distance` pixels away, 0 to 1, by their objects, their
/// depths, and the rises of depth to them on the plane.
fn neighbor_weights(plane: Plane, objects: vec4f, depths: vec4f, rises: vec4f,
    distance: f32) -> vec4f {
    let error = abs(depths - plane.depth - rises);
    let scale = 1.0 / max(plane.tolerance * distance, 1e-30);
    // The weight fades, so that the last bit of a depth does not decide between all and nothing.
    let weights = clamp(2.0 - error * scale, vec4f(0.0), vec4f(1.0));
    return select(vec4f(0.0), weights, objects == vec4f(plane.object));
}

/// A pixel whose curvature is measured.
struct Center {
    at: vec2i,
    slope: vec2f,
    plane: Plane,
}

/// The center for a pixel; its object is 0 where there is none.
fn center_at(pixel: vec2i) -> Center {
    let seen = seen_pixel(pixel);
    let texel = seen.texel;
    return Center(seen.at, texel.xy, plane_of(abs(texel.w), texel.z, normal_of(texel)));
}

/// Neighbors on the four sides of a center: in the column after it, in the column before it, in the
/// row after it, and in the row before it.
struct Ring {
    /// Weighted changes of slope.x from the center.
    x: vec4f,
    /// Weighted changes of slope.y from the center.
    y: vec4f,
    weights: vec4f,
}

/// The ring that is so many steps away, with its weight.
fn ring_at(center: Center, steps: i32, weight: f32) -> Ring {
    let reach = steps * step_pixels();
    let distance = f32(reach);
    let at = center.at;
    let last = vec2i(textureDimensions(surface)) - 1;
    let a = textureLoad(surface, vec2i(min(at.x + reach, last.x), at.y), 0);
    let b = textureLoad(surface, vec2i(max(at.x - reach, 0), at.y), 0);
    let c = textureLoad(surface, vec2i(at.x, min(at.y + reach, last.y)), 0);
    let d = textureLoad(surface, vec2i(at.x, max(at.y - reach, 0)), 0);
    // Beyond the image nothing is.
    let is_inside = vec4i(last.x - at.x, at.x, last.y - at.y, at.y) >= vec4i(reach);
    let objects = select(vec4f(0.0), abs(vec4f(a.w, b.w, c.w, d.w)), is_inside);
    let rise = distance * center.plane.rise;
    let rises = vec4f(rise.x, -rise.x, rise.y, -rise.y);
    let shares = weight * distance
        * neighbor_weights(center.plane, objects, vec4f(a.z, b.z, c.z, d.z), rises, distance);
    return Ring(
        shares * (vec4f(a.x, b.x, c.x, d.x) - center.slope.x),
        shares * (vec4f(a.y, b.y, c.y, d.y) - center.slope.y),
        shares * distance,
    );
}

/// Two rings as one.
fn joined(a: Ring, b: Ring) -> Ring {
    return Ring(a.x + b.x, a.y + b.y, a.weights + b.weights);
}

/// The twelve neighbors one, two and three steps away.
fn rings_at(center: Center) -> Ring {
    let near = joined(ring_at(center, 1, WEIGHT_1), ring_at(center, 2, WEIGHT_2));
    return joined(near, ring_at(center, 3, WEIGHT_3));
}

/// The derivatives along x and y, camera axes, from weighted changes to the four sides, as far as
/// each side counts; 0 where none does.
fn derivatives(changes: vec4f, weights: vec4f) -> vec2f {
    // A side that hardly counts any more is left to the other one, gradually.
    let trust = smoothstep(vec4f(0.0), vec4f(0.5), weights);
    let sides = changes / max(weights, vec4f(1e-6)) * trust;
    let along = (sides.xz - sides.yw) / max(trust.xz + trust.yw, vec2f(1e-6));
    return along * vec2f(1.0, row_direction());
}

/// Mean curvature from the neighbors.
fn mean_curvature(ring: Ring) -> f32 {
    let along = derivatives(vec4f(ring.x.xy, ring.y.zw), ring.weights);
    return clamp(0.5 * (along.x + along.y) * curvature.viewport_height, -MOST, MOST);
}
// Straight edges near pixels, each packed into one number that an f32 holds exactly, so that a
// texel has four. Borders of materials and borders of ids share the last one: those of ids are
// negative.
                     

/// Levels of a fine code's direction and of its place, by which an edge is told within 1/2000 of a
/// pixel.
const FINE = 4096.0;
/// Levels of a coarse code's direction and of its place: enough to tell which edge is the nearest.
const COARSE = 512.0;
/// What a coarse code leaves room for below 2^24: the row in which its edge lies.
const ROW = 262144.0;
/// Rows before the first that a code can tell.
const MOST_ROWS = 31.0;
/// A distance farther than any.
const FAR = 1e9;

/// The number of the object in a texel's number, from 1 on; 0 where nothing is.
fn object_in(number: f32) -> f32 {
    return floor(abs(number));
}

/// The number of the material in a texel's number, from 0 on.
fn material_in(number: f32) -> f32 {
    return floor(fract(abs(number)) * MATERIALS);
}

/// Edges of four kinds: the unit normals of straight lines, and how far along them the lines lie,
/// in pixels of the image.
struct EdgeLines {
    x: vec4f,
    y: vec4f,
    offset: vec4f,
}

/// The fine code of an edge by its unit normal and its offset, less than 2 pixels; never 0.
fn edge_code(normal: vec2f, offset: f32) -> f32 {
    let share = normal.x / max(abs(normal.x) + abs(normal.y), 1e-20);
    let turn = select(3.0 + share, 1.0 - share, normal.y >= 0.0);
    let direction = min(floor(turn * (0.25 * FINE)), FINE - 1.0);
    let place = floor((clamp(offset, -1.99, 1.99) + 2.0) * (0.25 * FINE));
    return place * FINE + direction;
}

/// Codes of few levels from fine ones.
fn coarse_codes(codes: vec4f) -> vec4f {
    let place = floor(codes / FINE);
    let direction = codes - FINE * place;
    let share = COARSE / FINE;
    return floor(place * share) * COARSE + floor(direction * share);
}

/// The edges that codes of so many levels say, each 0 or more.
fn edges_of(codes: vec4f, levels: f32) -> EdgeLines {
    let place = floor(codes / levels);
    let turn = (codes - levels * place + 0.5) * (4.0 / levels);
    let is_back = turn >= vec4f(2.0);
    let x = select(1.0 - turn, turn - 3.0, is_back);
    let rest = 1.0 - abs(x);
    let y = select(rest, -rest, is_back);
    let size = sqrt(x * x + y * y);
    return EdgeLines(x / size, y / size, (place + 0.5) * (4.0 / levels) - 2.0);
}

/// Distances in pixels between a pixel and the middles of the pieces of edges, by the places of the
/// edges' pixels from it: they tell which piece is the nearest, whichever way it leans. The first
/// edge is a silhouette, which counts on its inner side alone unless `beyond` says both: outside it
/// is [`FAR`].
fn middle_distances(edges: EdgeLines, columns: vec4f, rows: vec4f, beyond: bool) -> vec4f {
    let x = columns + edges.x * edges.offset;
    let y = rows + edges.y * edges.offset;
    let inward = x.x * edges.x.x + y.x * edges.y.x;
    let distances = sqrt(x * x + y * y);
    return vec4f(select(distances.x, FAR, inward < -1.0 && !beyond), distances.yzw);
}

/// Distances in pixels between a pixel and the nearest pieces of edges, by the places of the edges'
/// pixels from it. The first is a silhouette, and 0 away beyond it, where a pixel is only touched,
/// unless `beyond` pixels count as those within do.
fn edge_distances(edges: EdgeLines, columns: vec4f, rows: vec4f, beyond: bool) -> vec4f {
    let across = edges.offset + edges.x * columns + edges.y * rows;
    let along = abs(edges.y * columns - edges.x * rows);
    // What is farther along than the edge's own pixel lies beyond the edge's end.
    let past = max(along - 1.0, vec4f(0.0));
    let inner = select(max(across.x, 0.0), abs(across.x), beyond);
    let side = vec4f(inner, abs(across.yzw));
    return sqrt(side * side + past * past);
}
// Arithmetic that gives a documented, finite result for every input.
//
// WGSL promises little of exp2, log2, sin, cos and division; where an angle or a profile must be
// exact, the functions here use sums and products alone, which every implementation rounds
// correctly.

const PI: f32 = 3.14159265358979323846;
const HALF_PI: f32 = 1.57079632679489661923;
const LN_2: f32 = 0.693147180559945309417;
const LOG2_E: f32 = 1.44269504088896340736;

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// x, or `otherwise` where x is NaN or infinite.
/// @where x is finite : x
fn finite_or(x: f32, otherwise: f32) -> f32 {
    return select(otherwise, x, is_finite(x));
}

/// v with 0 for each component that is NaN or infinite.
/// @where v is finite : v
fn finite_vec3(v: vec3f) -> vec3f {
    let exponent = vec3u(0x7f800000u);
    return select(vec3f(0.0), v, (bitcast<vec3u>(v) & exponent) != exponent);
}

/// v with 0 for each component that is NaN or infinite.
/// @where v is finite : v
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
/// @where v is unit : v
/// @where tier is balanced and |v| <= 1e18 and otherwise = 0 :
///   v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
/// @where |v| <= 1e18 : normalize_moderate(v, otherwise)
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !((largest > 1e-30) & (largest < 1e30)) {
        return otherwise;
    }
    let scaled = v * (1.0 / largest);
    let square = dot(scaled, scaled);
    // max() passes over a NaN.
    if !is_finite(square) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let clamped = clamp(x, -126.0, 127.999992);
    let whole = round(clamped);
    let f = clamped - whole;
    // Twice the power, so that half of 2^128 is a number. The bits of 2^-127 are those of 0.
    let twice = 2.0 + f * (1.386294405710424 + f * (0.4804529582723118 + f * (0.11100664941567156
        + f * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
}

/// 2^n for n in [-126, 127], by its bits.
fn power_of_two(n: i32) -> f32 {
    return bitcast<f32>(u32(n + 127) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
fn log2_stable(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    let exponent = bitcast<i32>(bits - 0x3f3504f3u) >> 23u;
    let mantissa = bitcast<f32>(bits - (bitcast<u32>(exponent) << 23u));
    let z = (mantissa - 1.0) / (mantissa + 1.0);
    let z2 = z * z;
    return f32(exponent) + z * (2.8853900797881615 + z2 * (0.9617988482912865
        + z2 * (0.5767143098091317 + z2 * 0.43173790132006157)));
}

/// ln(x) for normal x > 0.
fn log_stable(x: f32) -> f32 {
    return LN_2 * log2_stable(x);
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
fn log1p_negative(y: f32) -> f32 {
    if y < 0.25 {
        return log1p_negative_small(y);
    }
    return log_stable(max(1.0 - y, 1.17549435e-38));
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
fn log1p_negative_small(y: f32) -> f32 {
    let z = y / (2.0 - y);
    let z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.333333333333333333
        + z2 * (0.2 + z2 * (0.142857142857142857 + z2 * 0.111111111111111111))));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
/// @where |x| <= 0.1 : sin_cos_tiny(x)
/// @where |x| <= 0.785 : sin_cos_eighth(x)
fn sin_cos_quarter(x: f32) -> vec2f {
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    let h = 0.5 * x;
    let h2 = h * h;
    let s = h * (1.0 + h2 * (-0.166666666666666667
        + h2 * (0.00833333333333333333 + h2 * (-0.000198412698412698413
        + h2 * (0.00000275573192239858907 + h2 * -2.50521083854417188e-8)))));
    let one_minus_c = h2 * (0.5 + h2 * (-0.0416666666666666667
        + h2 * (0.00138888888888888889 + h2 * (-0.0000248015873015873016
        + h2 * (2.75573192239858907e-7 + h2 * -2.08767569878680990e-9)))));
    let c = 1.0 - one_minus_c;
    return vec2f(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
fn sin_cos_eighth(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.166666666666666667 + y * (0.00833333333333333333
        + y * (-0.000198412698412698413 + y * 0.00000275573192239858907))));
    let c = 1.0 - y * (0.5 + y * (-0.0416666666666666667 + y * (0.00138888888888888889
        + y * (-0.0000248015873015873016 + y * 2.75573192239858907e-7))));
    return vec2f(s, c);
}

/// [`sin_cos_quarter`] for |x| <= 0.1.
fn sin_cos_tiny(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.166666666666666667 + y * 0.00833333333333333333));
    let c = 1.0 - y * (0.5 + y * (-0.0416666666666666667 + y * 0.00138888888888888889));
    return vec2f(s, c);
}

/// sin(x/2) and cos(x/2) for x in [0, pi], given `left`, which is pi - x: both keep their relative
/// accuracy at both ends, because the smaller angle is halved and its cosine is the other's sine.
fn sin_cos_half(x: f32, left: f32) -> vec2f {
    let half = sin_cos_quarter(0.5 * min(x, left));
    return select(half.yx, half, x <= left);
}

/// pi - x for x up to pi, with the digits of pi that an f32 does not hold; 0 where x is the f32
/// next to pi.
fn left_to_pi(x: f32) -> f32 {
    // pi in two parts. The first is an f32, so that f64 reads the same one; the maximum keeps
    // compilers from making one constant of both.
    let coarse = max(3.1415927410125732421875 - x, 0.0);
    return max(coarse - 8.742278012618954e-8, 0.0);
}

/// sin(x) and cos(x) for any finite x with |x| < 1e5; [`sin_cos_quarter`] after reduction to a
/// quarter turn.
fn sin_cos(x: f32) -> vec2f {
    let turns = round(x * 0.318309886183790672);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    let r = ((x - turns * 3.140625) - turns * 0.0009670257568359375)
        - turns * 6.27832957300962643e-7;
    let sign = 1.0 - 2.0 * abs(turns - 2.0 * trunc(turns * 0.5));
    return sign * sin_cos_quarter(clamp(r, -HALF_PI, HALF_PI));
}

/// [`normalize_or`] for a third of its price: a vector shorter than 1e-15 or longer than 1e18
/// counts as having no direction.
/// @where v is unit : v
/// @where tier is balanced and |v| <= 1e18 and otherwise = 0 :
///   v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
fn normalize_quick(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    // Comparisons are false for NaN; what `select` leaves out never reaches the result.
    let is_usable = (square > 1e-30) & (square < 1e36);
    return select(otherwise, v * inverseSqrt(select(1.0, square, is_usable)), is_usable);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
/// @where v is unit : v
/// @where tier is balanced and otherwise = 0 : v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
fn normalize_seen(v: vec3f) -> vec3f {
    return normalize_moderate(v, vec3f(0.0, 0.0, 1.0));
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
fn sin_cos_quick(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.16666666 + y * (0.0083332425
        + y * (-0.0001982274 + y * 2.6347564e-6))));
    let c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (2.4774579e-5 - y * 2.6297516e-7))));
    return vec2f(s, c);
}

/// [`sin_cos_quick`] shorter still (absolute error 4.8e-6 and 2.2e-7).
fn sin_cos_short(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.16666542 + y * (0.008324197 - y * 0.00018846673)));
    let c = 1.0 + y * (-0.49999991 + y * (0.04166567 + y * (-0.0013868611 + y * 2.3476086e-5)));
    return vec2f(s, c);
}

/// log2(1 - y) for y in [0, 1): a series near 0, where 1 - y would round y away, else the
/// hardware's; -100 at 1.
fn log2_one_minus(y: f32) -> f32 {
    let series = -y * LOG2_E * (1.0 + y * (0.5
        + y * (0.333333333333333333 + y * (0.25 + y * 0.2))));
    return select(log2(max(1.0 - y, 7.8886091e-31)), series, y < 0.0625);
}
// The types that wires carry beside numbers and vectors. Their names are read from signatures: an
// alias says what the numbers mean, and the compiler converts where the meaning differs.

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// The triangles of all objects that cast shadows, as `shaders/lib/casters.wgsl` reads them.
alias Casters = texture_2d<f32>;

/// What lights see first, a layer for each, as `shaders/lib/shadow_map.wgsl` reads it.
alias ShadowMaps = texture_2d_array<f32>;

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    half_sin: f32,
    /// cos(u/2), 0 or more.
    half_cos: f32,
}

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    direction: vec3f,
    /// Unit, toward the light, in the light's own frame.
    own_direction: vec3f,
    /// Straight RGB.
    color: vec3f,
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    intensity: f32,
}

/// A free function of one number, drawn through points; flat outside of them. The layout is one for
/// uniform buffers.
struct Curve {
    /// x, y and slope (dy/dx, used by the smooth interpolation) of each point, in increasing x.
    points: array<vec4f, 16>,
    /// Number of points that count.
    count: u32,
    /// 0 straight, 1 smooth (cubic, with the slopes), 2 stepped: each point's y holds until the
    /// next point.
    interpolation: u32,
}

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    colors: array<vec4f, 16>,
    /// Places of the stops, in increasing order, four to a vector.
    places: array<vec4f, 4>,
    /// Number of stops that count.
    count: u32,
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    interpolation: u32,
}
// The angle between two directions without inverse trigonometry: acos loses half the digits near 0
// and near pi and is NaN where rounding makes a dot product exceed 1.
                     
                       

/// The angle between the unit vectors d and l, from the chords |d - l| and |d + l|.
/// @where d is unit and l is unit : angle_of_units(d, l)
fn angle_between(d: vec3f, l: vec3f) -> Angle {
    let p = length(d - l);
    let s = length(d + l);
    let k = 1.0 / sqrt(max(p * p + s * s, 1e-30));
    return Angle(p * k, s * k);
}

/// The angle u in radians.
fn angle_radians(u: Angle) -> f32 {
    return 2.0 * atan2_positive(u.half_sin, u.half_cos);
}

/// The angle of `radians`, clamped to [0, pi]; 0 where it is not finite.
fn angle_of(radians: f32) -> Angle {
    let half_angle = 0.5 * clamp(finite_or(radians, 0.0), 0.0, PI);
    let sc = sin_cos_quarter(half_angle);
    return Angle(max(sc.x, 0.0), max(sc.y, 0.0));
}

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
fn atan2_positive(y: f32, x: f32) -> f32 {
    let small = min(y, x);
    let large = max(y, x);
    if large <= 0.0 {
        return 0.0;
    }
    let t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    let is_wide = t > 0.41421356;
    let r = select(t, (small - large) / (small + large), is_wide);
    let r2 = r * r;
    let series = r * (1.0 + r2 * (-0.333333333333333333
        + r2 * (0.2 + r2 * (-0.142857142857142857
        + r2 * (0.111111111111111111 + r2 * (-0.0909090909090909091
        + r2 * (0.0769230769230769231 + r2 * (-0.0666666666666666667
            + r2 * 0.0588235294117647059))))))));
    let a = select(series, series + 0.785398163397448310, is_wide);
    return select(a, HALF_PI - a, y > x);
}

/// u - shift, clamped to [0, pi], for |shift| <= pi (BADF eq. 8 and docs/math.md D3).
fn angle_shifted(u: Angle, shift: f32) -> Angle {
    return angle_turned(u, sin_cos_quarter(0.5 * clamp(shift, -PI, PI)));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
fn angle_footprint(u: Angle) -> f32 {
    let half = vec2f(u.half_sin, u.half_cos);
    let dx = dpdx(half);
    let dy = dpdy(half);
    let w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    // An infinite or NaN derivative at a silhouette gives the widest footprint.
    return min(finite_or(w, 0.5), 0.5);
}

/// [`angle_between`] for vectors that are unit but for rounding: half of each chord, without
/// normalizing the two halves again.
fn angle_of_units(d: vec3f, l: vec3f) -> Angle {
    return Angle(0.5 * length(d - l), 0.5 * length(d + l));
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin * t.y - u.half_cos * t.x;
    let c = u.half_cos * t.y + u.half_sin * t.x;
    let upper = select(vec2f(s, c), vec2f(1.0, 0.0), c <= 0.0);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < c));
    return Angle(turned.x, turned.y);
}
// Arithmetic of the math nodes, with a finite result for every input. NaN becomes 0, an infinite
// or too large result the largest number of its sign, and a number below the smallest normal one
// divides as 0.
                       
                     

const SMALLEST_NORMAL: f32 = 1.17549435e-38;

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
/// @where x is finite : x
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// [`bounded`], component by component.
/// @where v is finite : v
fn bounded_vec2(v: vec2f) -> vec2f {
    let bits = bitcast<vec2u>(v);
    let magnitude = bits & vec2u(0x7fffffffu);
    let largest = bitcast<vec2f>((bits & vec2u(0x80000000u)) | vec2u(0x7f7fffffu));
    let numbers = select(vec2f(0.0), largest, magnitude == vec2u(0x7f800000u));
    return select(numbers, v, magnitude < vec2u(0x7f800000u));
}

/// [`bounded`], component by component.
/// @where v is finite : v
fn bounded_vec3(v: vec3f) -> vec3f {
    let bits = bitcast<vec3u>(v);
    let magnitude = bits & vec3u(0x7fffffffu);
    let largest = bitcast<vec3f>((bits & vec3u(0x80000000u)) | vec3u(0x7f7fffffu));
    let numbers = select(vec3f(0.0), largest, magnitude == vec3u(0x7f800000u));
    return select(numbers, v, magnitude < vec3u(0x7f800000u));
}

/// [`bounded`], component by component.
/// @where v is finite : v
fn bounded_vec4(v: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(v);
    let magnitude = bits & vec4u(0x7fffffffu);
    let largest = bitcast<vec4f>((bits & vec4u(0x80000000u)) | vec4u(0x7f7fffffu));
    let numbers = select(vec4f(0.0), largest, magnitude == vec4u(0x7f800000u));
    return select(numbers, v, magnitude < vec4u(0x7f800000u));
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// x - y floor(x / y): from 0 up to y, without y, with the sign of y; 0 where y is 0.
fn modulo_floored(x: f32, y: f32) -> f32 {
    let size = abs(y);
    if size < SMALLEST_NORMAL {
        return 0.0;
    }
    let turned = select(-x, x, y > 0.0);
    // Rounding may put the remainder just outside of its range, and far outside where x / y has no
    // digits left.
    let left = bounded(turned - size * floor(bounded(turned / size)));
    let wrapped = select(left, left + size, left < 0.0);
    let inside = select(0.0, wrapped, (wrapped >= 0.0) & (wrapped < size));
    return select(-inside, inside, y > 0.0);
}

/// base^exponent for every pair. A negative base is raised as in algebra by a whole exponent and
/// keeps its sign with any other, so that (-4)^0.5 is -2. 0 to a negative power is 0, as division
/// by 0 is; 0^0 is 1.
/// @where tier is balanced and base >= 0 and base <= 1.1 and exponent >= 1e-3 and exponent <= 500 :
///   pow(base, exponent) ~ 3e-4
/// @where tier is balanced and base >= 0 and base <= 1e4 and exponent >= 1e-3 and exponent <= 8 :
///   pow(base, exponent) ~ 3e-4
fn powered(base: f32, exponent: f32) -> f32 {
    let b = bounded(base);
    let e = bounded(exponent);
    // The result is exact, because an exponent of 1 lets the compiler leave the node out.
    if e == 1.0 {
        return b;
    }
    if e == 0.0 {
        return 1.0;
    }
    if e == 2.0 {
        return bounded(b * b);
    }
    let magnitude = abs(b);
    let raised = exp2_stable(bounded(e * log2_stable(max(magnitude, SMALLEST_NORMAL))));
    let is_even = floor(e * 0.5) == e * 0.5;
    let signed = select(raised, -raised, (b < 0.0) & !is_even);
    return select(signed, 0.0, magnitude < SMALLEST_NORMAL);
}

/// [`powered`], component by component.
/// @where tier is balanced and base >= 0 and base <= 1.1 and exponent >= 1e-3 and exponent <= 500 :
///   pow(base, vec3f(exponent)) ~ 3e-4
/// @where tier is balanced and base >= 0 and base <= 1e4 and exponent >= 1e-3 and exponent <= 8 :
///   pow(base, vec3f(exponent)) ~ 3e-4
fn powered_vec3(base: vec3f, exponent: f32) -> vec3f {
    return vec3f(powered(base.x, exponent), powered(base.y, exponent), powered(base.z, exponent));
}

/// e^x; 0 far below, the largest number from 88.73 on.
/// @where tier is balanced and |x| <= 80 : exp(x) ~ 3e-5
fn exponential_of(x: f32) -> f32 {
    return exp2_stable(bounded(x * LOG2_E));
}

/// ln(x); 0 and everything below count as 1.2e-38, the smallest normal number, whose logarithm is
/// -87.34.
/// @where tier is balanced and x >= 1e-30 and x <= 1e30 : log(x) ~ 2e-5
fn logarithm_of(x: f32) -> f32 {
    return log_stable(max(bounded(x), SMALLEST_NORMAL));
}

/// Mix from a (where t is 0) to b (where t is 1): exact at both ends, and where a is b.
/// @where a = 0 and b = 1 and |t| <= 1e15 : t
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
fn mixed(a: f32, b: f32, t: f32) -> f32 {
    let d = bounded(b - a);
    return bounded(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
fn mixed_vec2(a: vec2f, b: vec2f, t: f32) -> vec2f {
    let d = bounded_vec2(b - a);
    return bounded_vec2(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
fn mixed_vec3(a: vec3f, b: vec3f, t: f32) -> vec3f {
    let d = bounded_vec3(b - a);
    return bounded_vec3(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let d = bounded_vec4(b - a);
    return bounded_vec4(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
fn place_between(x: f32, low: f32, high: f32) -> f32 {
    let span = high - low;
    if abs(span) < SMALLEST_NORMAL {
        return select(0.0, 1.0, x >= high);
    }
    return bounded((x - low) / bounded(span));
}

/// x moved from one range to another, kept within the new one when `clamped`; an empty first range
/// makes a step.
fn remapped(x: f32, from_low: f32, from_high: f32, to_low: f32, to_high: f32,
    clamped: bool) -> f32 {
    let place = place_between(bounded(x), bounded(from_low), bounded(from_high));
    return mixed(bounded(to_low), bounded(to_high), select(place, clamp(place, 0.0, 1.0), clamped));
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
/// @where low < high and x is finite and |low| <= 1e30 and |high| <= 1e30 :
///   smoothstep(low, high, x)
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(place_between(bounded(x), bounded(low), bounded(high)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A factor as it is, or kept within 0 and 1 when `clamped`.
fn factor_of(x: f32, clamped: bool) -> f32 {
    return select(bounded(x), clamp(bounded(x), 0.0, 1.0), clamped);
}

/// The length of v, also where its square would over- or underflow.
/// @where |v| <= 1e18 : length(v)
fn length_of(v: vec3f) -> f32 {
    let w = bounded_vec3(v);
    let largest = max(max(abs(w.x), abs(w.y)), abs(w.z));
    if largest < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(largest * length(w / largest));
}

/// sin(x) for every x, in [-1, 1]; beyond 100,000 rounding leaves nothing of the phase. The form of
/// the balanced tier takes x as off by a rounding or two, which far from 0 is more than its bound.
/// @where tier is balanced and |x| <= 1e7 : sin(x) ~ 5e-5
/// @where |x| <= 1.6 : sine_low(x)
/// @where x >= 0 and x <= 4.17 : cosine_low(x - 1.57079632679489662)
/// @where x >= 1.55 and x <= 4.73 : sine_low((3.140625 - x) + 0.000967653589793238463)
/// @where x >= 2.12 and x <= 7.31 : -cosine_low(x - 4.71238898038468986)
/// @where |x| <= 3000 : sine_near(x)
fn sine_of(x: f32) -> f32 {
    let b = bounded(x);
    let turns = round(b * 0.318309886183790672);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    let coarse = fma(turns, -0.0009670257568359375, fma(turns, -3.140625, b));
    let r = fma(turns, -6.27832957300962643e-7, coarse);
    // Far out, rounding of the turns leaves somewhat more than a quarter turn.
    return sine_turned(clamp(r, -1.6, 1.6), turns);
}

/// [`sine_of`] where two parts of pi are enough.
fn sine_near(x: f32) -> f32 {
    let turns = round(x * 0.318309886183790672);
    let r = fma(turns, -0.000967653589793238463, fma(turns, -3.140625, x));
    return sine_turned(r, turns);
}

/// cos(x) for every x, in [-1, 1]; beyond 100,000 rounding leaves nothing of the phase. The form of
/// the balanced tier is that of [`sine_of`].
/// @where tier is balanced and |x| <= 1e7 : cos(x) ~ 5e-5
/// @where |x| <= 2.6 : cosine_low(x)
/// @where x >= 0 and x <= 3.17 : sine_low((1.5703125 - x) + 0.000483826794896619231)
/// @where x >= 0.55 and x <= 5.74 : -cosine_low(x - 3.14159265358979324)
/// @where |x| <= 3000 : cosine_near(x)
fn cosine_of(x: f32) -> f32 {
    let b = bounded(x);
    let turns = round(b * 0.318309886183790672 - 0.5);
    let middle = turns + 0.5;
    let coarse = fma(middle, -0.0009670257568359375, fma(middle, -3.140625, b));
    let r = fma(middle, -6.27832957300962643e-7, coarse);
    return sine_turned(-clamp(r, -1.6, 1.6), turns);
}

/// [`cosine_of`] where two parts of pi are enough.
fn cosine_near(x: f32) -> f32 {
    let turns = round(x * 0.318309886183790672 - 0.5);
    let middle = turns + 0.5;
    let r = fma(middle, 0.000967653589793238463, fma(middle, 3.140625, -x));
    return sine_turned(r, turns);
}

/// sin(r + pi turns) for |r| <= 1.6 and whole turns.
fn sine_turned(r: f32, turns: f32) -> f32 {
    // Odd turns, of which half is left, turn the sign.
    return sine_low(r) * fma(fract(turns * 0.5), -4.0, 1.0);
}

/// sin(r) for |r| <= 1.6, a quarter turn and some more: a minimax polynomial (absolute error below
/// 6e-9 beside rounding).
fn sine_low(r: f32) -> f32 {
    let y = r * r;
    let high = fma(y, 0.000002593088765934226, -0.00019803417671937495);
    let s = fma(r * y, fma(y, fma(y, high, 0.008332972414791584), -0.16666655242443085), r);
    return clamp(s, -1.0, 1.0);
}

/// cos(r) for |r| <= 2.6: a minimax polynomial (absolute error below 2e-9 beside rounding) that is
/// 1 at 0 and below that elsewhere.
fn cosine_low(r: f32) -> f32 {
    let y = r * r;
    let high = fma(y, fma(y, 1.8474174412475008e-9, -2.7357322096577263e-7),
        0.000024793636839604005);
    return fma(y, fma(y, fma(y, fma(y, high, -0.0013888741377741098), 0.041666656732559204), -0.5),
        1.0);
}

/// sin(x) and cos(x) for every x; beyond 100,000 rounding leaves nothing of the phase, and the
/// result lies in [-1, 1].
/// @where tier is balanced and |x| <= 1000 : vec2f(sin(x), cos(x)) ~ 5e-5
fn sin_cos_of(x: f32) -> vec2f {
    return clamp(sin_cos(bounded(x)), vec2f(-1.0), vec2f(1.0));
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
fn angle_of_point(y: f32, x: f32) -> f32 {
    // Coordinates are halved where they are large, so that the sum of both stays finite.
    let p = abs(bounded_vec2(vec2f(x, y)));
    let scaled = select(p, 0.5 * p, max(p.x, p.y) > 1.0);
    let a = atan2_positive(scaled.y, scaled.x);
    let turned = select(a, PI - a, x < 0.0);
    return select(turned, -turned, y < 0.0);
}
// Lines where forms end, fold and meet (docs/math.md 14), as looks draw them from their distances.
                     
                     

/// Steps of 1/800 of the picture's height that lines reach from their edges.
const LINE_STEPS = 16.0;
/// The same in the fast tier.
const FEW_LINE_STEPS = 8.0;

/// What is no nearer than this many pixels is not near at all: less is rounding.
const LEAST_NEARNESS: f32 = 1e-6;

/// Farthest that a line is known from its edge, in pixels: so many steps of 1/800 of the picture's
/// height, and at most 31 pixels, as far as an offset fits into a texel.
fn line_reach(viewport_height: f32, steps: f32) -> f32 {
    return min(steps * max(round(viewport_height / 800.0), 1.0), 31.0);
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
fn own_nearness(nearness: vec4f, middle: vec2f, depth: f32, object: f32, pixels: f32,
    reach: f32) -> vec4f {
    let is_same_object = middle.y == object_number(object);
    let behind = (depth - middle.x) * pixels;
    // Slivers of the same surface are seen on the planes of their own triangles. Bounds are none of
    // the round numbers that depths of things put together by hand have.
    let is_own = abs(middle.y) < 0.5 || (is_same_object && abs(behind) <= 8.0625);
    let is_in_front = behind < select(-2.0625, -8.0625, is_same_object);
    let other = vec4f(select(0.0, reach, is_in_front), 0.0, nearness.z, 0.0);
    return select(other, nearness, is_own);
}

/// A number of pixels that a width says, 0 or more and less than any reach needs.
fn line_pixels(width: f32, pixels: f32) -> f32 {
    return clamp(bounded(width), 0.0, 1e6) * clamp(bounded(pixels), 0.0, 1e6);
}

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    kinds: vec4f,
    /// Of borders of ids.
    ids: f32,
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
fn line_widths(width: f32, shares: vec4f, ids: f32) -> LineWidths {
    let widths = min(width, 1e4) * clamp(bounded_vec4(shares), vec4f(0.0), vec4f(100.0));
    let id_width = min(width, 1e4) * clamp(bounded(ids), 0.0, 100.0);
    // What no pixel can show is no line.
    return LineWidths(select(vec4f(0.0), widths, widths > vec4f(1e-6)),
        select(0.0, id_width, id_width > 1e-6));
}

/// Widths of the four lines that are near: a negative nearness in the place of materials is that of
/// a border of ids.
fn widths_near(nearness: vec4f, widths: LineWidths) -> vec4f {
    return vec4f(widths.kinds.xyz, select(widths.kinds.w, widths.ids, nearness.w < 0.0));
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
fn inner_line_covers(distance: f32, width: f32) -> f32 {
    return clamp(width + 0.5 - distance, 0.0, min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
fn middle_line_covers(distance: vec4f, width: vec4f) -> vec4f {
    let half = 0.5 * width;
    return clamp(min(distance + 0.5, half) - max(distance - 0.5, -half), vec4f(0.0), vec4f(1.0));
}

/// What a line of any kind covers of a pixel, by how much nearer than the reach the edges of each
/// kind are: all lie evenly on both sides.
fn any_line_covers(nearness: vec4f, widths: LineWidths, reach: f32) -> f32 {
    let near = clamp(bounded_vec4(nearness), vec4f(-reach), vec4f(reach));
    let own = select(vec4f(0.0), widths_near(near, widths), abs(near) > vec4f(LEAST_NEARNESS));
    let covers = middle_line_covers(reach - abs(near), own);
    return max(max(covers.x, covers.y), max(covers.z, covers.w));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
fn lines_cover(nearness: vec4f, widths: vec4f, reach: f32) -> vec4f {
    let distance = reach - nearness;
    let covers = vec4f(inner_line_covers(distance.x, widths.x),
        middle_line_covers(distance, widths).yzw);
    return select(vec4f(0.0), covers, nearness > vec4f(LEAST_NEARNESS));
}
// How far pixels are from the nearest edges (docs/math.md 14): first within each column, then over
// the columns, which finds the nearest for few reads however far away it is.
//
// A pixel sees the edges of its own surface alone: a line belongs to what lies in front, and what
// lies behind draws none for it. Lines of what is hidden belong to nothing that is seen there:
// every pixel sees them, on both sides.
                             
                         
                     

/// Codes of edges at each pixel, as `edges_at` of `edge_map.wgsl` finds them.
@group(0) @binding(2) var edges: texture_2d<f32>;

/// Depth by which a surface may leave its plane, in multiples of what tells neighbors apart.
const LEEWAY = 3.0;

/// True if a texel belongs to the surface of a plane, so many pixels away.
fn is_same_surface(own: Plane, texel: vec4f, offset: vec2f) -> bool {
    let error = abs(texel.z - own.depth - dot(own.rise, offset));
    return object_in(texel.w) == object_in(own.object)
        && error <= LEEWAY * own.tolerance * max(length(offset), 1.0);
}

/// The nearest edge of each kind in a pixel's own column: the coarse code of each, with its row
/// from the pixel; 0 for none, negative for a border of ids. `reach` is how far edges are looked
/// for, in pixels; `of_all` if those of other surfaces count, too.
fn nearest_in_column(pixel: vec2i, own: Plane, reach: i32, of_all: bool) -> vec4f {
    let last = vec2i(textureDimensions(surface)) - 1;
    var nearest = vec4f(FAR);
    var codes = vec4f(0.0);
    for (var row = max(-reach, -pixel.y); row <= min(reach, last.y - pixel.y); row++) {
        let at = pixel + vec2i(0, row);
        let found = textureLoad(edges, at, 0);
        if all(found == vec4f(0.0)) {
            continue;
        }
        if !of_all && !is_same_surface(own, textureLoad(surface, at, 0), vec2f(0.0, f32(row))) {
            continue;
        }
        let fine = abs(found);
        let distances = select(vec4f(FAR),
            middle_distances(edges_of(fine, FINE), vec4f(0.0), vec4f(f32(row)), of_all),
            fine > vec4f(0.0));
        let is_nearer = distances < nearest;
        nearest = select(nearest, distances, is_nearer);
        let coarse = coarse_codes(fine) + ROW * (f32(row) + MOST_ROWS);
        codes = select(codes, select(coarse, -coarse, found < vec4f(0.0)), is_nearer);
    }
    return codes;
}
// The nearest edges in each pixel's column, by which the pass after it finds the nearest of all.
                        

/// Steps of 1/800 of the picture's height to which edges are looked for.
const STEPS = 16;
/// 1 where edges of all surfaces count, on both sides; 0 where those of a pixel's own do.
const OF_ALL = 0;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let seen = seen_pixel(pixel).texel;
    if OF_ALL == 0 && seen.w == 0.0 {
        return vec4f(0.0);
    }
    let reach = line_reach(curvature.viewport_height, f32(STEPS));
    let own = plane_of(abs(seen.w), seen.z, normal_of(seen));
    return nearest_in_column(pixel, own, i32(reach), OF_ALL == 1);
}
