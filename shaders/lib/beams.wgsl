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

/// Bits of the corners of a pixel and of its middle.
const ALL_POINTS = 31u;

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

/// What is above 0 where a triangle keeps the light from a place of a pixel.
struct Inequalities {
    a: Slope,
    b: Slope,
    c: Slope,
    /// How high the triangle stands over the surface, and how far it is from the lamp.
    height: Slope,
    depth: Slope,
    /// Of a triangle that is seen from behind and is no blocker where both hold: how low it stands,
    /// and how soon rays meet it.
    low: Slope,
    soon: Slope,
    is_back: bool,
    /// False where they hold nowhere in the pixel.
    is_met: bool,
}

const NEVER = Slope(-1.0, 0.0, 0.0);
const NOT_MET = Inequalities(NEVER, NEVER, NEVER, NEVER, NEVER, NEVER, NEVER, false, false);

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

/// The samples of spans on four lines. Those of each line stand further than those of the line
/// before, by the golden ratio of a step: so lines round an edge differently, whatever its slope.
fn samples_in(spans: Spans, places: vec4f) -> vec4u {
    let count = f32(LINE_SAMPLES);
    let most = vec4f(count);
    let further = fract(0.5 + 0.6180339887 * (0.5 * f32(PIXEL_LINES)) * places) - 0.5;
    let before = clamp(ceil(count * (spans.first + 0.5) - 0.5 - further), vec4f(0.0), most);
    let until = clamp(floor(count * (spans.last + 0.5) + 0.5 - further), vec4f(0.0), most);
    return samples_below(until) & ~samples_below(before);
}

/// The samples of four lines in which inequalities hold.
fn samples_within(all_of: Inequalities, half: f32, is_level: bool) -> vec4u {
    let places = line_places(half);
    var spans = Spans(vec4f(-1.0), vec4f(1.0));
    spans = clipped(spans, places, all_of.a, is_level);
    spans = clipped(spans, places, all_of.b, is_level);
    spans = clipped(spans, places, all_of.c, is_level);
    spans = clipped(spans, places, all_of.height, is_level);
    spans = clipped(spans, places, all_of.depth, is_level);
    let found = samples_in(spans, places);
    if !all_of.is_back {
        return found;
    }
    spans = clipped(spans, places, all_of.low, is_level);
    spans = clipped(spans, places, all_of.soon, is_level);
    return found & ~samples_in(spans, places);
}

/// True at the corners of a pixel where a slope is 0 or more: the upper ones first.
fn corners_within(slope: Slope) -> vec4<bool> {
    let right = vec4f(-0.5, 0.5, -0.5, 0.5);
    let down = vec4f(-0.5, -0.5, 0.5, 0.5);
    return slope.middle + slope.right * right + slope.down * down >= vec4f(0.0);
}

/// Bits of a pixel's corners and of its middle in which inequalities hold.
fn points_within(all_of: Inequalities) -> u32 {
    var corners = corners_within(all_of.a) & corners_within(all_of.b) & corners_within(all_of.c)
        & corners_within(all_of.height) & corners_within(all_of.depth);
    let least = min(min(all_of.a.middle, all_of.b.middle), min(all_of.c.middle,
        min(all_of.height.middle, all_of.depth.middle)));
    var middle = least >= 0.0;
    if all_of.is_back {
        corners &= !(corners_within(all_of.low) & corners_within(all_of.soon));
        middle = middle && !(all_of.low.middle >= 0.0 && all_of.soon.middle >= 0.0);
    }
    let bits = select(vec4u(0u), vec4u(1u, 2u, 4u, 8u), corners);
    return bits.x | bits.y | bits.z | bits.w | select(0u, 16u, middle);
}

/// The share of a pixel that its samples say: by the lines of either direction, and the more, the
/// more of them edges cross.
fn share_of_samples(samples: PixelSamples) -> f32 {
    let level = line_counts(samples.level) + line_counts(samples.more_level);
    let upright = line_counts(samples.upright) + line_counts(samples.more_upright);
    let weight = vec2f(level.y * level.y, upright.y * upright.y) + 1e-3;
    let share = dot(weight, vec2f(level.x, upright.x)) / (weight.x + weight.y);
    return share / f32(LINE_SAMPLES * PIXEL_LINES / 2);
}

/// Samples on four lines that are kept from the light, and lines of which a part is.
fn line_counts(lines: vec4u) -> vec2f {
    let counts = vec4f(countOneBits(lines));
    let crossed = (lines != vec4u(0u)) & (lines != EVERY_SAMPLE);
    let one = vec4f(1.0);
    return vec2f(dot(counts, one), dot(select(vec4f(0.0), one, crossed), one));
}

/// Where in a pixel a triangle keeps the light away. Its edges count, and a little more, so that
/// light comes through no seam.
fn inequalities_of(beam: Beam, corner: vec3f, second: vec3f, third: vec3f) -> Inequalities {
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
    // A light with a size may see it from the other side.
    let may_turn = abs(facing) <= dot(abs(normal), beam.spread);
    if !(area > 0.0) || (greatest_of(height) <= 0.0 && !may_turn) {
        return NOT_MET;
    }
    let whole = abs(facing);
    let wide = 2e-6 * whole;
    let of_a = edge_slope(beam, side, bc, b - c, wide);
    let of_b = edge_slope(beam, side, ca, c - a, wide);
    let of_c = edge_slope(beam, side, ab, a - b, wide);
    let may_move = vec3f(dot(abs(bc), beam.spread), dot(abs(ca), beam.spread),
        dot(abs(ab), beam.spread));
    let most = vec3f(greatest_of(of_a), greatest_of(of_b), greatest_of(of_c)) + may_move;
    if (any(most < vec3f(0.0)) || whole <= 1e-30) && !may_turn {
        return NOT_MET;
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
    let low = Slope(beam.under * area - height.middle, -height.right, -height.down);
    let soon = Slope(beam.under_end * whole - height.middle,
        beam.under_end * facing_right - height.right, beam.under_end * facing_down - height.down);
    return Inequalities(of_a, of_b, of_c, height, depth, low, soon, facing > 0.0, true);
}

/// How far rays pass inside an edge between two corners, whose cross product from the origin is
/// `across`, and which are `between` apart; `wide` is how far beyond it they may.
fn edge_slope(beam: Beam, side: f32, across: vec3f, between: vec3f, wide: f32) -> Slope {
    let growth = beam.is_lamp * across + cross(beam.way, between);
    return Slope(side * dot(beam.way, across) + wide, -side * dot(growth, beam.across),
        -side * dot(growth, beam.down));
}

/// The greatest value of a slope in a pixel.
fn greatest_of(slope: Slope) -> f32 {
    return slope.middle + 0.5 * (abs(slope.right) + abs(slope.down));
}

/// Bits of samples with those in which inequalities hold.
fn with_samples(found: PixelSamples, all_of: Inequalities) -> PixelSamples {
    return joined_samples(found, PixelSamples(samples_within(all_of, 0.0, true),
        samples_within(all_of, 1.0, true), samples_within(all_of, 0.0, false),
        samples_within(all_of, 1.0, false)));
}

/// The points of a pixel that an object's triangles keep from the light; if `is_rough`, all where
/// any ray of the beam may be kept. `facet` is the triangle that the rays leave, if it is the
/// object's own.
fn points_among(
    casters: Casters,
    row: i32,
    world: Beam,
    facet: Facet,
    is_rough: bool,
) -> u32 {
    let tree = caster_texel(casters, row + 3);
    let begin = i32(tree.x);
    let nodes = i32(tree.y);
    let triangles = begin + 2 * nodes;
    var beam = turned_beam(casters, row, world);
    beam.origin += facet.lift;
    var found = 0u;
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
            let b = caster_texel(casters, at + 1);
            let c = caster_texel(casters, at + 2);
            let all_of = inequalities_of(beam, a.xyz, b.xyz, c.xyz);
            if all_of.is_met && triangle != facet.triangle {
                if is_rough {
                    return ALL_POINTS;
                }
                found |= points_within(all_of);
                if found == ALL_POINTS {
                    return found;
                }
            }
            // All triangles of a node but its last say that more follow.
            triangle = select(-1, triangle + 1, a.w > 0.5);
        }
    }
    return found;
}

/// The points of a pixel that other objects keep from the light than the one that it leaves.
/// `root` is the texel of a tree over objects.
fn points_among_others(
    casters: Casters,
    root: i32,
    beam: Beam,
    object: f32,
    is_rough: bool,
) -> u32 {
    var found = 0u;
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
        found |= points_among(casters, row, beam, NO_FACET, is_rough);
        if found == ALL_POINTS {
            return found;
        }
    }
    return found;
}

/// The samples of a pixel that an object's triangles keep from the light.
fn samples_among(
    casters: Casters,
    row: i32,
    world: Beam,
    facet: Facet,
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
            let b = caster_texel(casters, at + 1);
            let c = caster_texel(casters, at + 2);
            let all_of = inequalities_of(beam, a.xyz, b.xyz, c.xyz);
            if all_of.is_met && triangle != facet.triangle {
                found = with_samples(found, all_of);
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

/// The samples of a pixel that other objects keep from the light.
fn samples_among_others(
    casters: Casters,
    root: i32,
    beam: Beam,
    object: f32,
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
        found = joined_samples(found, samples_among(casters, row, beam, NO_FACET));
        if has_all_samples(found) {
            return found;
        }
    }
    return found;
}
