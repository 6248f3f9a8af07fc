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

/// Samples along a line; lines of a pixel, half of them level and half upright.
const LINE_SAMPLES = 32;
const PIXEL_LINES = 16;

/// Bits of samples along the level and the upright lines across a pixel: a bit for each that is
/// kept from the light.
struct PixelSamples {
    level: vec4u,
    more_level: vec4u,
    upright: vec4u,
    more_upright: vec4u,
}

const NO_SAMPLES = PixelSamples(vec4u(0u), vec4u(0u), vec4u(0u), vec4u(0u));
const EVERY_SAMPLE = vec4u(0xffffffffu);
const ALL_SAMPLES = PixelSamples(EVERY_SAMPLE, EVERY_SAMPLE, EVERY_SAMPLE, EVERY_SAMPLE);

fn joined_samples(a: PixelSamples, b: PixelSamples) -> PixelSamples {
    return PixelSamples(a.level | b.level, a.more_level | b.more_level, a.upright | b.upright,
        a.more_upright | b.more_upright);
}

fn has_all_samples(samples: PixelSamples) -> bool {
    let level = samples.level & samples.more_level;
    return all((level & samples.upright & samples.more_upright) == EVERY_SAMPLE);
}

fn has_no_samples(samples: PixelSamples) -> bool {
    let level = samples.level | samples.more_level;
    return all((level | samples.upright | samples.more_upright) == vec4u(0u));
}

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

/// A number that grows evenly over a pixel: in its middle, and how much to its neighbors on the
/// right and below.
struct Slope {
    middle: f32,
    right: f32,
    down: f32,
}

/// What must be 0 or more where a triangle keeps the light away.
struct Inequalities {
    a: Slope,
    b: Slope,
    c: Slope,
    /// How high the triangle stands over the surface, and how far it is from the lamp.
    height: Slope,
    depth: Slope,
}

/// Parts of four lines from one place to another, in pixels from their middles; nothing where they
/// are the wrong way round.
struct Spans {
    first: vec4f,
    last: vec4f,
}

/// Where four lines stand, in pixels from the middle of the pixel: the first or the second half of
/// those of a direction.
fn line_places(half: f32) -> vec4f {
    return (vec4f(0.5, 1.5, 2.5, 3.5) + 4.0 * half) * (2.0 / f32(PIXEL_LINES)) - 0.5;
}

/// The parts of spans where a slope is 0 or more, along level or upright lines.
fn clipped(spans: Spans, places: vec4f, slope: Slope, is_level: bool) -> Spans {
    let growth = select(slope.down, slope.right, is_level);
    let start = slope.middle + select(slope.right, slope.down, is_level) * places;
    if abs(growth) < 1e-35 {
        return Spans(select(spans.first, vec4f(2.0), start < vec4f(0.0)), spans.last);
    }
    let root = start * (-1.0 / growth);
    if growth > 0.0 {
        return Spans(max(spans.first, root), spans.last);
    }
    return Spans(spans.first, min(spans.last, root));
}

/// A bit for each of the first `count` samples of four lines.
fn samples_below(count: vec4f) -> vec4u {
    let some = (vec4u(1u) << vec4u(min(count, vec4f(31.0)))) - vec4u(1u);
    return select(some, EVERY_SAMPLE, count > vec4f(31.5));
}

/// The samples of four lines in which all inequalities hold. Those of each line stand a little
/// further than those of the line before.
fn samples_within(all_of: Inequalities, half: f32, is_level: bool) -> vec4u {
    let places = line_places(half);
    var spans = Spans(vec4f(-1.0), vec4f(1.0));
    spans = clipped(spans, places, all_of.a, is_level);
    spans = clipped(spans, places, all_of.b, is_level);
    spans = clipped(spans, places, all_of.c, is_level);
    spans = clipped(spans, places, all_of.height, is_level);
    spans = clipped(spans, places, all_of.depth, is_level);
    let count = f32(LINE_SAMPLES);
    let most = vec4f(count);
    let before = clamp(ceil(count * (spans.first + 0.5) - 0.5 - places), vec4f(0.0), most);
    let until = clamp(floor(count * (spans.last + 0.5) + 0.5 - places), vec4f(0.0), most);
    return samples_below(until) & ~samples_below(before);
}

fn all_samples_within(all_of: Inequalities) -> PixelSamples {
    return PixelSamples(samples_within(all_of, 0.0, true), samples_within(all_of, 1.0, true),
        samples_within(all_of, 0.0, false), samples_within(all_of, 1.0, false));
}

/// The share of a pixel that its samples say: by the lines that edges cross most.
fn share_of_samples(samples: PixelSamples) -> f32 {
    let level = line_counts(samples.level) + line_counts(samples.more_level);
    let upright = line_counts(samples.upright) + line_counts(samples.more_upright);
    let best = select(upright, level, level.y >= upright.y);
    return best.x / f32(LINE_SAMPLES * PIXEL_LINES / 2);
}

/// Samples on four lines that are kept from the light, and lines of which a part is.
fn line_counts(lines: vec4u) -> vec2f {
    let counts = vec4f(countOneBits(lines));
    let crossed = (lines != vec4u(0u)) & (lines != EVERY_SAMPLE);
    let one = vec4f(1.0);
    return vec2f(dot(counts, one), dot(select(vec4f(0.0), one, crossed), one));
}

/// The samples that a triangle keeps from the light; if `is_rough`, all where any ray of the beam
/// may be kept. Its edges count, and a little more, so that light comes through no seam.
fn covered(beam: Beam, is_rough: bool, corner: vec3f, second: vec3f, third: vec3f) -> PixelSamples {
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
    let height = Slope(side * dot(normal, a) - beam.noise * area, -side * dot(normal, beam.across),
        -side * dot(normal, beam.down));
    let may_turn = dot(abs(normal), beam.spread);
    if !(area > 0.0) || (greatest_of(height) <= 0.0 && abs(facing) > may_turn) {
        return NO_SAMPLES;
    }
    let whole = abs(facing);
    let of_a = edge_slope(beam, side, bc, b - c);
    let of_b = edge_slope(beam, side, ca, c - a);
    let of_c = edge_slope(beam, side, ab, a - b);
    let may_move = vec3f(dot(abs(bc), beam.spread), dot(abs(ca), beam.spread),
        dot(abs(ab), beam.spread));
    let most = vec3f(greatest_of(of_a), greatest_of(of_b), greatest_of(of_c)) + may_move;
    if any(most < vec3f(-2e-6 * whole)) && whole > may_turn {
        return NO_SAMPLES;
    }
    if is_rough {
        return ALL_SAMPLES;
    }
    if whole <= 1e-30 {
        return NO_SAMPLES;
    }
    // What faces the light changes with the place for lamps. A lamp is no blocker of itself.
    let facing_right = of_a.right + of_b.right + of_c.right;
    let facing_down = of_a.down + of_b.down + of_c.down;
    let end = 0.99999;
    var depth = Slope(end * whole - height.middle, end * facing_right - height.right,
        end * facing_down - height.down);
    if beam.is_lamp < 0.5 {
        depth = Slope(1.0, 0.0, 0.0);
    }
    let wide = 2e-6 * whole;
    let found = all_samples_within(Inequalities(
        Slope(of_a.middle + wide, of_a.right, of_a.down),
        Slope(of_b.middle + wide, of_b.right, of_b.down),
        Slope(of_c.middle + wide, of_c.right, of_c.down), height, depth));
    if facing < 0.0 || has_no_samples(found) {
        return found;
    }
    // Backs that are as near as this are no blockers.
    let low = Slope(beam.under * area - height.middle, -height.right, -height.down);
    let soon = Slope(beam.under_end * whole - height.middle,
        beam.under_end * facing_right - height.right, beam.under_end * facing_down - height.down);
    let under = all_samples_within(Inequalities(low, soon, low, height, low));
    return PixelSamples(found.level & ~under.level, found.more_level & ~under.more_level,
        found.upright & ~under.upright, found.more_upright & ~under.more_upright);
}

/// How far rays pass inside an edge between two corners, whose cross product from the origin is
/// `across`, and which are `between` apart.
fn edge_slope(beam: Beam, side: f32, across: vec3f, between: vec3f) -> Slope {
    let growth = beam.is_lamp * across + cross(beam.way, between);
    return Slope(side * dot(beam.way, across), -side * dot(growth, beam.across),
        -side * dot(growth, beam.down));
}

/// The greatest value of a slope in a pixel.
fn greatest_of(slope: Slope) -> f32 {
    return slope.middle + 0.5 * (abs(slope.right) + abs(slope.down));
}

/// The samples of a beam that an object's triangles keep from the light. `facet` is the one that
/// the rays leave, if it is the object's own.
fn beam_among(
    casters: Casters,
    row: i32,
    world: Beam,
    facet: Facet,
    is_rough: bool,
) -> PixelSamples {
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
                found = joined_samples(found,
                    covered(beam, is_rough, a.xyz, b.xyz, c.xyz));
                if has_all_samples(found) {
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
    is_rough: bool,
) -> PixelSamples {
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
        found = joined_samples(found, beam_among(casters, row, beam, NO_FACET, is_rough));
        if has_all_samples(found) {
            return found;
        }
    }
    return found;
}
