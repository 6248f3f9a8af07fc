// Beams: all rays from a pixel toward a light at once, past the triangles that `casters.wgsl` tells
// of. A walk goes into each box that any of the rays can meet; each triangle there takes its share
// of the samples along lines across the pixel.
//
// For a place p and its way w to the light, let a, b, c be a triangle's corners from p. The ray
// meets it where w·(a × b), w·(b × c) and w·(c × a) have one sign. Each is linear in the place of
// the pixel, for lamps too, whose ways meet at one point; so what a triangle covers of a line is
// what is left of the line by a few inequalities, and none of its samples needs a ray.
import chiaro::types;
import chiaro::numeric;
import chiaro::casters;

/// Samples along a line.
const LINE_SAMPLES = 32;

const NO_SAMPLES = vec4u(0u);
const ALL_SAMPLES = vec4u(0xffffffffu);

/// Rays from a pixel toward a light.
struct Beam {
    /// The middle of the pixel, and from there to those of its neighbors on the right and below.
    origin: vec3f,
    across: vec3f,
    down: vec3f,
    /// From the middle to the light's place; or the direction toward it, whose length is no end.
    way: vec3f,
    /// 1 where ways end at the light's place, else 0.
    is_lamp: f32,
    /// Greatest offset of rays from the middle one, on each axis: at the pixel, and how much more
    /// at the end of the way.
    margin: vec3f,
    spread: vec3f,
    /// 1 over each component of way + spread, and of way - spread.
    inverse_upward: vec3f,
    inverse_downward: vec3f,
    /// What a rounding may leave between the origin and a surface that it lies on.
    noise: f32,
    /// Up to this far away planes of triangles that are seen from behind are no blockers,
    under: f32,
    /// if the ray meets them within this share of its way.
    under_end: f32,
}

/// Four lines across a pixel: where they start, in pixels from its middle, and how far they go.
struct PixelLines {
    x: vec4f,
    y: vec4f,
    along_x: vec4f,
    along_y: vec4f,
    /// False where no samples are asked for, but if any ray of the beam may be blocked.
    has_samples: bool,
}

const NO_LINES = PixelLines(vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), false);

/// A beam in world space. `size` is the light's radius at the end of the way.
fn beam_of(
    place: vec3f,
    across: vec3f,
    down: vec3f,
    way: vec3f,
    is_lamp: f32,
    size: f32,
) -> Beam {
    let margin = 0.5 * (abs(across) + abs(down));
    let square = max(dot(across + down, across + down), dot(across - down, across - down));
    let under = 0.5 * sqrt(square);
    let length = max(sqrt(dot(way, way)), 1e-30);
    let spread = vec3f(size);
    return Beam(place, across, down, way, is_lamp, margin, spread, inverse_of(way + spread),
        inverse_of(way - spread), 0.0, under, 2.0 * under / length);
}

/// A beam in the space of an object's triangles; the object's row of texels begins at `row`.
fn turned_beam(casters: Casters, row: i32, beam: Beam) -> Beam {
    let x = caster_texel(casters, row);
    let y = caster_texel(casters, row + 1);
    let z = caster_texel(casters, row + 2);
    let turned = transpose(mat3x3f(x.xyz, y.xyz, z.xyz));
    let reach = transpose(mat3x3f(abs(x.xyz), abs(y.xyz), abs(z.xyz)));
    let place = turned * beam.origin + vec3f(x.w, y.w, z.w);
    let across = turned * beam.across;
    let down = turned * beam.down;
    let scale = sqrt(max(max(dot(x.xyz, x.xyz), dot(y.xyz, y.xyz)), dot(z.xyz, z.xyz)));
    let way = turned * beam.way;
    let spread = reach * beam.spread;
    return Beam(place, across, down, way, beam.is_lamp, 0.5 * (abs(across) + abs(down)), spread,
        inverse_of(way + spread), inverse_of(way - spread),
        noise_among(casters, row, beam.origin), scale * beam.under, beam.under_end);
}

/// True if any ray of a beam may meet a box.
fn beam_meets_box(beam: Beam, least: vec3f, most: vec3f) -> bool {
    // At the share t of the way rays are as far from the origin as t·way, give or take
    // margin + t·spread: on each axis two inequalities for t.
    let upward = beam.way + beam.spread;
    let downward = beam.way - beam.spread;
    let reached = (least - beam.margin - beam.origin) * beam.inverse_upward;
    let left = (most + beam.margin - beam.origin) * beam.inverse_downward;
    let none = vec3f(0.0);
    let end = vec3f(select(1e30, 1.0, beam.is_lamp > 0.5));
    let enters = max(select(none, reached, upward >= none), select(none, left, downward < none));
    let leaves = min(select(end, reached, upward < none), select(end, left, downward >= none));
    let enter = max(max(enters.x, enters.y), max(enters.z, 0.0));
    let leave = min(min(leaves.x, leaves.y), min(leaves.z, end.x));
    return enter <= leave * 1.000002;
}

/// Both diagonals of a pixel, from above, then the level and the upright line through its middle;
/// the first and the last sample of a diagonal are corners.
fn crossing_lines() -> PixelLines {
    let along = f32(LINE_SAMPLES) / f32(LINE_SAMPLES - 1);
    let half = 0.5 * along;
    return PixelLines(vec4f(-half, half, -half, 0.0), vec4f(-half, -half, 0.0, -half),
        vec4f(along, -along, along, 0.0), vec4f(along, along, 0.0, along), true);
}

/// Four of `count` parallel lines across a pixel, from number `first` on; the samples of each stand
/// a little further than those of the one before.
fn parallel_lines(first: i32, count: i32, is_level: bool) -> PixelLines {
    let place = (vec4f(0.5, 1.5, 2.5, 3.5) + f32(first)) / f32(count) - 0.5;
    let start = -0.5 + place / f32(LINE_SAMPLES);
    let one = vec4f(1.0);
    let none = vec4f(0.0);
    if is_level {
        return PixelLines(start, place, one, none, true);
    }
    return PixelLines(place, start, none, one, true);
}

/// Parts of four lines, from a share of each to another; nothing where they are the wrong way
/// round.
struct Spans {
    first: vec4f,
    last: vec4f,
}

/// The parts of spans where a value is 0 or more that is `at` in the middle of the pixel and grows
/// by `slope` to its neighbors.
fn clipped(spans: Spans, lines: PixelLines, at: f32, slope: vec2f) -> Spans {
    let start = at + slope.x * lines.x + slope.y * lines.y;
    let growth = slope.x * lines.along_x + slope.y * lines.along_y;
    let is_level = abs(growth) < vec4f(1e-35);
    let root = -start / select(growth, vec4f(1.0), is_level);
    let rises = growth > vec4f(0.0);
    let never = vec4f(2.0);
    let first = max(spans.first, select(spans.first, root, rises & !is_level));
    let last = min(spans.last, select(root, spans.last, rises | is_level));
    return Spans(select(first, never, is_level & (start < vec4f(0.0))), last);
}

/// A bit for each of the first `count` samples of four lines.
fn samples_below(count: vec4f) -> vec4u {
    let some = (vec4u(1u) << vec4u(min(count, vec4f(31.0)))) - vec4u(1u);
    return select(some, ALL_SAMPLES, count > vec4f(31.5));
}

/// The samples in spans, which stand in the middle of equal parts of their lines.
fn samples_in(spans: Spans) -> vec4u {
    let count = f32(LINE_SAMPLES);
    let most = vec4f(count);
    let before = clamp(ceil(count * spans.first - 0.5), vec4f(0.0), most);
    let until = clamp(floor(count * spans.last + 0.5), vec4f(0.0), most);
    return samples_below(until) & ~samples_below(before);
}

/// The samples that a triangle keeps from the light; where none are asked for, all if any ray of
/// the beam may be kept. Its edges count, and a little more, so that light comes through no seam.
fn covered(beam: Beam, lines: PixelLines, corner: vec3f, second: vec3f, third: vec3f) -> vec4u {
    let a = corner - beam.origin;
    let b = second - beam.origin;
    let c = third - beam.origin;
    let ab = cross(a, b);
    let bc = cross(b, c);
    let ca = cross(c, a);
    let normal = ab + bc + ca;
    let area = sqrt(dot(normal, normal));
    let facing = dot(beam.way, normal);
    // Triangles that are seen from behind are turned round.
    let side = select(-1.0, 1.0, facing > 0.0);
    let height = side * dot(normal, a);
    let height_slope = -side * vec2f(dot(normal, beam.across), dot(normal, beam.down));
    let highest = height + 0.5 * (abs(height_slope.x) + abs(height_slope.y));
    let noise = beam.noise * area;
    let may_turn = dot(abs(normal), beam.spread);
    if !(area > 0.0) || (highest <= noise && abs(facing) > may_turn) {
        return NO_SAMPLES;
    }
    let edges = side * vec3f(dot(beam.way, bc), dot(beam.way, ca), dot(beam.way, ab));
    let of_bc = -side * (beam.is_lamp * bc + cross(beam.way, b - c));
    let of_ca = -side * (beam.is_lamp * ca + cross(beam.way, c - a));
    let of_ab = -side * (beam.is_lamp * ab + cross(beam.way, a - b));
    let right = vec3f(dot(of_bc, beam.across), dot(of_ca, beam.across), dot(of_ab, beam.across));
    let below = vec3f(dot(of_bc, beam.down), dot(of_ca, beam.down), dot(of_ab, beam.down));
    let widened = edges + 2e-6 * abs(facing);
    let may_move = vec3f(dot(abs(bc), beam.spread), dot(abs(ca), beam.spread),
        dot(abs(ab), beam.spread));
    let most = widened + 0.5 * (abs(right) + abs(below)) + may_move;
    if any(most < vec3f(0.0)) && abs(facing) > may_turn {
        return NO_SAMPLES;
    }
    if !lines.has_samples {
        return ALL_SAMPLES;
    }
    if abs(facing) <= 1e-30 {
        return NO_SAMPLES;
    }
    var spans = Spans(vec4f(0.0), vec4f(1.0));
    spans = clipped(spans, lines, widened.x, vec2f(right.x, below.x));
    spans = clipped(spans, lines, widened.y, vec2f(right.y, below.y));
    spans = clipped(spans, lines, widened.z, vec2f(right.z, below.z));
    spans = clipped(spans, lines, height - noise, height_slope);
    // The height is this share of the way times what faces the light, which changes for lamps.
    let whole = abs(facing);
    let whole_slope = vec2f(right.x + right.y + right.z, below.x + below.y + below.z);
    if beam.is_lamp > 0.5 {
        // A lamp is no blocker of itself.
        let end = 0.99999;
        spans = clipped(spans, lines, end * whole - height, end * whole_slope - height_slope);
    }
    let found = samples_in(spans);
    if facing < 0.0 || all(found == NO_SAMPLES) {
        return found;
    }
    spans = clipped(spans, lines, beam.under * area - height, -height_slope);
    spans = clipped(spans, lines, beam.under_end * whole - height,
        beam.under_end * whole_slope - height_slope);
    return found & ~samples_in(spans);
}

/// The samples of a beam that an object's triangles keep from the light. `facet` is the one that
/// the rays leave, if it is the object's own.
fn beam_among(
    casters: Casters,
    row: i32,
    world: Beam,
    facet: Facet,
    lines: PixelLines,
) -> vec4u {
    let tree = caster_texel(casters, row + 3);
    let begin = i32(tree.x);
    let nodes = i32(tree.y);
    let triangles = begin + 2 * nodes;
    var beam = turned_beam(casters, row, world);
    beam.origin += facet.lift;
    var found = NO_SAMPLES;
    var node = 0;
    while node < nodes {
        let least = caster_texel(casters, begin + 2 * node);
        let most = caster_texel(casters, begin + 2 * node + 1);
        if !beam_meets_box(beam, least.xyz, most.xyz) {
            node = max(i32(least.w), node + 1);
            continue;
        }
        node += 1;
        var triangle = i32(most.w);
        while triangle >= 0 {
            let at = triangles + 3 * triangle;
            let a = caster_texel(casters, at);
            if triangle != facet.triangle {
                let b = caster_texel(casters, at + 1);
                let c = caster_texel(casters, at + 2);
                found |= covered(beam, lines, a.xyz, b.xyz, c.xyz);
                if all(found == ALL_SAMPLES) {
                    return found;
                }
            }
            // All triangles of a node but its last say that more follow.
            triangle = select(-1, triangle + 1, a.w > 0.5);
        }
    }
    return found;
}

/// The samples of a beam that other objects keep from the light than the one that it leaves.
/// `root` is the texel of a tree over objects.
fn beam_among_others(
    casters: Casters,
    root: i32,
    beam: Beam,
    object: f32,
    lines: PixelLines,
) -> vec4u {
    var found = NO_SAMPLES;
    let end = i32(caster_texel(casters, max(root, 0)).w);
    var node = select(end, root, root >= 0);
    while node < end {
        let least = caster_texel(casters, node);
        let most = caster_texel(casters, node + 1);
        if !beam_meets_box(beam, least.xyz, most.xyz) {
            node = max(i32(least.w), node + 2);
            continue;
        }
        node += 2;
        let row = i32(most.w);
        if row < 0 || caster_texel(casters, max(row, 0) + 3).z == object {
            continue;
        }
        found |= beam_among(casters, row, beam, NO_FACET, lines);
        if all(found == ALL_SAMPLES) {
            return found;
        }
    }
    return found;
}
