// Edges between pixels, told from what a pass over meshes drew: where one surface ends in front of
// another, where it folds, and where two meet (docs/math.md 14). Each pixel at an edge has a
// straight piece of it, whose place between the pixels is found from the surfaces' planes, from how
// a round form turns out of sight, or from the course that the edge takes over the pixels around.
import chiaro::curvature_map;
import chiaro::edge_code;

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
