// Working drawing: made by Chiaro 0.1.0, WGSL.
// Finds where surfaces behind the first end, fold and meet.
// Bindings of group 0: surface 0, curvature 1, front 2.
// working-drawing.json says what to put there and how to draw.

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
// Edges between pixels, told from what a pass over meshes drew: where one surface ends in front of
// another, where it folds, and where two meet (docs/math.md 14). Each pixel at an edge has a
// straight piece of it, whose place between the pixels is found from the surfaces' planes, from how
// a round form turns out of sight, or from the course that the edge takes over the pixels around.
                             
                         

/// Kinds of edges, by their places in a texel; borders of ids are in the place of materials,
/// negative.
const SILHOUETTE = 0;
const CREASE = 1;
const OBJECT_BORDER = 2;
const MATERIAL_BORDER = 3;
const ID_BORDER = 4;
const NO_EDGE = -1;

/// Change of the unit normal, beyond that of a round form, from which an edge is a crease:
/// 2 sin(15 degrees), a bend by 30 degrees.
const LEAST_BEND = 0.5176380902;
/// Pixels along an edge over which its course is followed, to both sides.
const COURSE = 12;
/// Pixels to both sides from which a line through a steep course is fitted.
const NEAR_COURSE = 5;

/// What a pixel shows: a piece of a surface.
struct Facet {
    /// Unit, in camera axes.
    normal: vec3f,
    /// Toward the eye in camera axes, of a length of 1 and more.
    toward: vec3f,
    depth: f32,
    /// The texel's number: the object's, the material's and the id's.
    number: f32,
    /// Change of depth from a pixel to the next, along columns and rows.
    rise: vec2f,
    /// The same where the surface is not seen as steeply: at least LEAST_NZ of it faces the eye.
    gentle_rise: vec2f,
}

/// Size in scene units of a pixel at a depth.
fn pixel_size_at(depth: f32) -> f32 {
    return curvature.pixel * mix(1.0, depth, curvature.perspective);
}

fn facet_at(at: vec2i) -> Facet {
    let texel = textureLoad(surface, at, 0);
    let normal = normal_of(texel);
    let middle = 0.5 * vec2f(textureDimensions(surface));
    let from_middle = (vec2f(at) + 0.5 - middle) * vec2f(1.0, row_direction());
    let toward = vec3f(-curvature.pixel * curvature.perspective * from_middle, 1.0);
    let facing = dot(normal, toward);
    let change = pixel_size_at(texel.z) * normal.xy * vec2f(1.0, row_direction());
    return Facet(normal, toward, texel.z, abs(texel.w), change / max(facing, LEAST_DEPTH_NZ),
        change / max(facing, LEAST_NZ));
}

/// True if the surfaces of two neighbors meet between them. The nearer one may not reach the other
/// more steeply than [`LEAST_NZ`] allows: then it ends in front.
fn meets(own: Facet, other: Facet, step: vec2f) -> bool {
    let is_nearer = own.depth <= other.depth;
    let rise = dot(select(own.rise, own.gentle_rise, is_nearer), step);
    let other_rise = dot(select(other.gentle_rise, other.rise, is_nearer), step);
    let here = own.depth - (other.depth - other_rise);
    let there = own.depth + rise - other.depth;
    let steepness = min(length(own.gentle_rise), length(other.gentle_rise));
    let tolerance = pixel_size_at(min(own.depth, other.depth)) + steepness;
    return here * there <= 0.0 || min(abs(here), abs(there)) <= tolerance;
}

/// A piece of an edge: its kind, the unit normal of a straight line in pixels of the image, and how
/// far along it from the pixel's middle the line lies.
struct Edge {
    kind: i32,
    normal: vec2f,
    offset: f32,
    /// How well the line is known, 0 to 1: little where it runs along the way to the neighbor.
    trust: f32,
}

/// The edge between a pixel and its neighbor.
fn edge_between(own: Facet, pixel: vec2i, step: vec2i) -> Edge {
    let none = Edge(NO_EDGE, vec2f(0.0), 0.0, 0.0);
    let at = pixel + step;
    // Beyond the picture nothing is known, and nothing ends.
    if any(at < vec2i(0)) || any(at >= vec2i(textureDimensions(surface))) {
        return none;
    }
    let other = facet_at(at);
    if other.number == 0.0 {
        return silhouette(own, pixel, step, FAR);
    }
    let toward = vec2f(step);
    let is_same_object = object_in(own.number) == object_in(other.number);
    if !meets(own, other, toward) {
        if own.depth > other.depth {
            return none;
        }
        let middle = 0.5 * (own.depth + other.depth);
        return silhouette(own, pixel, step, select(FAR, middle, is_same_object));
    }
    if !is_same_object {
        return Edge(OBJECT_BORDER, vec2f(0.0), 0.0, 0.0);
    }
    if own.number != other.number {
        let is_material = material_in(own.number) != material_in(other.number);
        let kind = select(ID_BORDER, MATERIAL_BORDER, is_material);
        return Edge(kind, vec2f(0.0), 0.0, 0.0);
    }
    let bend = length(own.normal - other.normal);
    if bend < LEAST_BEND || bend - round_bend(own, other, pixel, step) < LEAST_BEND {
        return none;
    }
    return Edge(CREASE, vec2f(0.0), 0.0, 0.0);
}

/// Change of the normal between two neighbors that a round form would have: what it is to both
/// sides of them.
fn round_bend(own: Facet, other: Facet, pixel: vec2i, step: vec2i) -> f32 {
    let last = vec2i(textureDimensions(surface)) - 1;
    let before = textureLoad(surface, clamp(pixel - step, vec2i(0), last), 0);
    let after = textureLoad(surface, clamp(pixel + 2 * step, vec2i(0), last), 0);
    let bends = vec2f(length(normal_of(before) - own.normal),
        length(normal_of(after) - other.normal));
    let numbers = vec2f(abs(before.w), abs(after.w));
    let shares = select(vec2f(0.0), vec2f(1.0), numbers == vec2f(own.number));
    return dot(bends, shares) / max(shares.x + shares.y, 1.0);
}

/// The line in which the planes of two facets meet, or along which a border runs over one plane.
fn meeting(own: Facet, pixel: vec2i, step: vec2i, kind: i32) -> Edge {
    let other = facet_at(pixel + step);
    let toward = vec2f(step);
    let slope = own.rise - other.rise;
    let steepness = length(slope);
    let here = own.depth - (other.depth - dot(other.rise, toward));
    let side = dot(slope, toward);
    // Planes that are nearly one do not tell where they meet.
    if abs(side) > 0.1 * pixel_size_at(own.depth) && abs(side) > 0.3 * steepness {
        let share = clamp(-here / side, 0.0, 1.0);
        let normal = slope / select(-steepness, steepness, side > 0.0);
        let lean = dot(normal, toward);
        return Edge(kind, normal, share * lean, lean);
    }
    if kind == CREASE {
        return Edge(kind, toward, 0.5, 0.0);
    }
    let course = course_at(pixel, step, own.number, FAR);
    return edge_along(kind, course, toward, course_normal(course, toward));
}

/// The edge of a surface that ends in front of what is farther than `limit`, or of another object.
fn silhouette(own: Facet, pixel: vec2i, step: vec2i, limit: f32) -> Edge {
    let toward = vec2f(step);
    let course = course_at(pixel, step, own.number, limit);
    let last = vec2i(textureDimensions(surface)) - 1;
    let before = facet_at(clamp(pixel - step, vec2i(0), last));
    // Near its outline the facing of a round form goes like the root of the distance.
    let facing = facing_squared(own);
    let change = facing_squared(before) - facing;
    let across = own.normal.xy * vec2f(1.0, row_direction());
    let normal = across / max(length(across), 1e-6);
    let is_round = before.number == own.number && facing < 0.36 && change > 1e-4
        && dot(normal, toward) > 0.5;
    let found = facing / max(change, 1e-4);
    let place = clamp(found, 0.0, 1.0);
    // As far as this is not between the pixels, the form is not as round as its normals.
    let trust = select(0.0, clamp(2.0 - 4.0 * abs(found - place), 0.0, 1.0), is_round);
    let seen = Course(mix(course.place, place, trust), course.slope, mix(course.trust, 1.0, trust));
    let turned = mix(course_normal(course, toward), normal, trust);
    return edge_along(SILHOUETTE, seen, toward, turned / length(turned));
}

/// Square of how much a facet faces the eye; negative for one that is turned away.
fn facing_squared(facet: Facet) -> f32 {
    let facing = dot(facet.normal, facet.toward);
    return facing * abs(facing) / dot(facet.toward, facet.toward);
}

/// The course of an edge past a pixel: how far beyond the pixel's middle it lies, 0 to 1, and how
/// far that changes from one pixel to the next along it.
struct Course {
    place: f32,
    slope: f32,
    /// Share of the rows nearby over which it was followed.
    trust: f32,
}

fn course_normal(course: Course, toward: vec2f) -> vec2f {
    let along = abs(toward.yx);
    return (toward - course.slope * along) / sqrt(1.0 + course.slope * course.slope);
}

fn edge_along(kind: i32, course: Course, toward: vec2f, normal: vec2f) -> Edge {
    let lean = dot(normal, toward);
    return Edge(kind, normal, course.place * lean, course.trust * lean);
}

/// True if a pixel shows the surface with this number, no farther than `limit`.
fn shows(at: vec2i, number: f32, limit: f32) -> bool {
    let last = vec2i(textureDimensions(surface)) - 1;
    let texel = textureLoad(surface, clamp(at, vec2i(0), last), 0);
    return abs(texel.w) == number && texel.z < limit;
}

/// Sums over the rows of a course, to fit a line and a parabola: x is how far along a row lies, y
/// how far beyond the pixel's middle the edge lies there.
struct CourseSums {
    count: f32,
    x: f32,
    y: f32,
    xx: f32,
    xy: f32,
    yy: f32,
    xxy: f32,
}

/// Where a course is bent, a parabola counts: squares of what a line leaves, from what rounding to
/// rows leaves in any case on.
const LEAST_LEFT = 0.09;
const BENT_LEFT = 0.14;

/// The course that fits rows best.
fn fitted_course(sums: CourseSums, is_arc: bool) -> Course {
    let trust = sums.count / (2.0 * f32(NEAR_COURSE) + 1.0);
    let spread = sums.count * sums.xx - sums.x * sums.x;
    let slope = (sums.count * sums.xy - sums.x * sums.y) / spread;
    let straight = (sums.y - slope * sums.x) / sums.count;
    if trust < 1.0 {
        return Course(clamp(straight, 0.0, 1.0), slope, trust);
    }
    // Over all rows x sums to 0, its fourth powers to 1958.
    let bent = (1958.0 * sums.y - sums.xx * sums.xxy)
        / (sums.count * 1958.0 - sums.xx * sums.xx);
    let left = (sums.yy - straight * sums.y - slope * sums.xy) / sums.count;
    let share = clamp((left - LEAST_LEFT) / (BENT_LEFT - LEAST_LEFT), 0.0, 1.0);
    return Course(clamp(mix(straight, bent, select(share, 1.0, is_arc)), 0.0, 1.0), slope, trust);
}

/// The course of the edge between a pixel and its neighbor, by the pixels at which it changes over
/// from one row to the next. A flat course passes the middle of a pixel near each such change; a
/// steep or bent one is fitted.
fn course_at(pixel: vec2i, step: vec2i, number: f32, limit: f32) -> Course {
    let along = abs(step.yx);
    // The first change to both sides: how far along, and how far beyond the pixel.
    var ends = array<vec2f, 2>(vec2f(0.0), vec2f(0.0));
    var changes = 0;
    var sums = CourseSums(1.0, 0.0, 0.5, 0.0, 0.0, 0.25, 0.0);
    for (var side = 0; side < 2; side++) {
        let way = along * (1 - 2 * side);
        var height = 0;
        var is_open = true;
        var row = 1;
        while row <= COURSE && (is_open || row <= NEAR_COURSE) {
            let at = pixel + way * row + step * height;
            var change = 0;
            if shows(at, number, limit) {
                if shows(at + step, number, limit) {
                    change = 1;
                }
            } else {
                change = -1;
            }
            // An edge that runs off more steeply is not followed: it is a corner.
            if change > 0 && shows(at + 2 * step, number, limit) {
                break;
            }
            if change < 0 && !shows(at - step, number, limit) {
                break;
            }
            if change != 0 {
                if is_open {
                    ends[side] = vec2f(f32(row) - 0.5, f32(max(height, height + change)));
                    is_open = false;
                }
                changes += select(0, 1, row <= NEAR_COURSE);
                height += change;
            }
            if row <= NEAR_COURSE {
                let x = f32(row * (1 - 2 * side));
                let y = f32(height) + 0.5;
                sums.count += 1.0;
                sums.x += x;
                sums.y += y;
                sums.xx += x * x;
                sums.xy += x * y;
                sums.yy += y * y;
                sums.xxy += x * x * y;
            }
            row++;
        }
        if is_open {
            ends[side] = vec2f(f32(row) - 0.5, f32(height) + 0.5);
        }
    }
    let length = ends[0].x + ends[1].x;
    let slope = (ends[0].y - ends[1].y) / length;
    let place = ends[1].y + slope * ends[1].x;
    let is_arc = ends[0].y == ends[1].y && place != 0.5;
    if (changes >= 3 || (is_arc && changes >= 2)) && sums.count >= 7.0 {
        return fitted_course(sums, is_arc);
    }
    // The top of an arc lies beyond the changes to both sides, by half a pixel in the mean.
    let rise = select(0.0, 4.0 * ends[0].x * ends[1].x / (length * length), is_arc);
    let trust = sums.count / (2.0 * f32(NEAR_COURSE) + 1.0);
    return Course(clamp(mix(place, 0.5, rise), 0.0, 1.0), slope, trust);
}

/// True if a surface plainly goes on to a neighbor, which most do: that costs little to tell.
fn goes_on(own: Facet, slope: vec2f, size: f32, pixel: vec2i, step: vec2i) -> bool {
    let last = vec2i(textureDimensions(surface)) - 1;
    let texel = textureLoad(surface, clamp(pixel + step, vec2i(0), last), 0);
    let change = abs(texel.xy - slope);
    let error = abs(texel.z - own.depth - dot(own.gentle_rise, vec2f(step)));
    return abs(texel.w) == own.number && error <= size && max(change.x, change.y) < 0.35;
}

/// Codes of the edges of each kind between a pixel and the four beside it, those that are known
/// best; 0 for none, and negative for borders of ids.
fn edges_at(pixel: vec2i) -> vec4f {
    let own = facet_at(pixel);
    if own.number == 0.0 {
        return vec4f(0.0);
    }
    let slope = textureLoad(surface, pixel, 0).xy;
    let size = pixel_size_at(own.depth);
    var left = 0u;
    for (var index = 0; index < 4; index++) {
        left |= select(1u << u32(index), 0u, goes_on(own, slope, size, pixel, around(index)));
    }
    var codes = vec4f(0.0);
    var trust = vec4f(-1.0);
    // Most pixels have no round at all: what a loop does not enter costs nothing everywhere.
    for (var index = select(0, 4, left == 0u); index < 4; index++) {
        if ((left >> u32(index)) & 1u) == 0u {
            continue;
        }
        let step = around(index);
        var edge = edge_between(own, pixel, step);
        if edge.kind == NO_EDGE {
            continue;
        }
        if edge.kind != SILHOUETTE {
            edge = meeting(own, pixel, step, edge.kind);
        }
        let place = min(edge.kind, MATERIAL_BORDER);
        let is_kind = vec4i(place) == vec4i(SILHOUETTE, CREASE, OBJECT_BORDER, MATERIAL_BORDER);
        let is_better = is_kind & (vec4f(edge.trust) > trust);
        trust = select(trust, vec4f(edge.trust), is_better);
        let code = edge_code(edge.normal, edge.offset);
        codes = select(codes, vec4f(select(code, -code, edge.kind == ID_BORDER)), is_better);
    }
    return codes;
}
// Edges of what lies behind the first surface, at the pixels beside them. Where a surface comes out
// from behind another it does not end, though nothing of it lies behind any more.
                        

/// The first surface at each pixel.
@group(0) @binding(2) var front: texture_2d<f32>;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let codes = edges_at(pixel);
    let is_end = codes.x > 0.0 && !comes_out(pixel, edges_of(codes, FINE));
    return vec4f(select(0.0, codes.x, is_end), codes.yzw);
}

/// True if a surface goes on in front, beyond its silhouette behind.
fn comes_out(pixel: vec2i, edges: EdgeLines) -> bool {
    let outward = vec2f(edges.x.x, edges.y.x);
    let is_level = abs(outward.x) >= abs(outward.y);
    let step = vec2i(select(vec2f(0.0, sign(outward.y)), vec2f(sign(outward.x), 0.0), is_level));
    let last = vec2i(textureDimensions(surface)) - 1;
    let own = facet_at(pixel);
    let texel = textureLoad(front, clamp(pixel + step, vec2i(0), last), 0);
    let error = abs(texel.z - own.depth - dot(own.gentle_rise, vec2f(step)));
    let tolerance = 2.0 * (pixel_size_at(own.depth) + length(own.gentle_rise));
    return object_in(texel.w) == object_in(own.number) && error <= tolerance;
}
