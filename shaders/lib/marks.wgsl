// Marks that keep their size on the picture: strokes and dots on places that are anchored to
// surfaces. Where a place is enlarged, marks of the next finer octave grow between those that are
// there; so every mark stays where it is, as in art maps (Klein et al. 2000) and tonal art maps
// (Praun et al. 2001). The same octaves serve tone: darker adds whole marks and never takes one
// away.
//
// A place comes with its stretch: products xx, xy and yy of how fast its coordinates change along
// the picture, per picture height.
import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::antialias;
import chiaro::noise;
import chiaro::direction;
import chiaro::screen;
import chiaro::blue_noise;

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    place: vec2f,
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    stretch: vec3f,
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
fn mark_place_of(place: vec2f, along: vec3f, across: vec3f, angle: f32) -> StretchedPlace {
    let turn = sin_cos_of(angle);
    let x = bounded_vec3(turn.y * along + turn.x * across);
    let y = bounded_vec3(turn.y * across - turn.x * along);
    let at = bounded_vec2(place);
    let turned = vec2f(turn.y * at.x + turn.x * at.y, turn.y * at.y - turn.x * at.x);
    let most = vec3f(1e15);
    let stretch = clamp(vec3f(dot(x, x), dot(x, y), dot(y, y)), -most, most);
    return StretchedPlace(bounded_vec2(turned), stretch);
}

/// Gradient along the picture of a coordinate that has the gradient `g` in space, on a surface seen
/// from `view`: a way along the picture is drawn out on the surface, at rims up to eight times.
/// Vectors are unit but for g.
fn gradient_on_picture(g: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let facing = dot(normal, view);
    return g - normal * (dot(g, view) / select(min(facing, -0.125), max(facing, 0.125),
        facing >= 0.0));
}

/// A place on a surface for strokes across an axis of the object.
fn place_across(
    axis: vec3f,
    position: vec3f,
    world_from_normal: mat3x3f,
    normal: vec3f,
    view: vec3f,
    magnification: f32,
    angle: f32,
) -> StretchedPlace {
    let axes = axes_around(axis, vec3f(0.0, 1.0, 0.0));
    let p = bounded_vec3(position);
    let place = vec2f(dot(p, axes[0]), dot(p, axes[2]));
    let along = bounded_vec3(world_from_normal * axes[0]);
    let across = bounded_vec3(world_from_normal * axes[2]);
    return place_on_surface(place, along, across, normal, view, magnification, angle);
}

/// A place on a surface for strokes along u; `unit` is the size of one unit of the texture
/// coordinates.
fn place_along_uv(
    uv: vec2f,
    unit: f32,
    normal: vec3f,
    view: vec3f,
    tangent: vec3f,
    bitangent: vec3f,
    world_from_normal: mat3x3f,
    magnification: f32,
    angle: f32,
) -> StretchedPlace {
    // Enlarging an object stretches its texture coordinates.
    let along = tangent * length_of(tangent * world_from_normal);
    let across = bitangent * length_of(bitangent * world_from_normal);
    let size = clamp(bounded(unit), 1e-3, 1e3);
    return place_on_surface(uv * size, along, across, normal, view, magnification, angle);
}

/// A place on a surface whose coordinates have the gradients `along` and `across` in world space.
fn place_on_surface(
    place: vec2f,
    along: vec3f,
    across: vec3f,
    normal: vec3f,
    view: vec3f,
    magnification: f32,
    angle: f32,
) -> StretchedPlace {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let v = normalize_or(view, vec3f(0.0, 0.0, 1.0));
    let height = 1.0 / clamp(bounded(magnification), 1e-15, 1e15);
    let x = bounded_vec3(gradient_on_picture(along, n, v) * height);
    let y = bounded_vec3(gradient_on_picture(across, n, v) * height);
    return mark_place_of(bounded_vec2(place), x, y, angle);
}

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    place: vec2f,
    stretch: vec3f,
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
fn spaced(place: vec2f, stretch: vec3f, viewport: vec2f, count: f32) -> SpacedPlace {
    let number = clamp(bounded(count), 0.0, 1e5);
    let is_pixel = !(stretch.x + stretch.z > 0.0);
    let scale = select(number, number / max(viewport.y, 1.0), is_pixel);
    // Beyond 2^22 a float has nothing left between whole numbers.
    let p = clamp(bounded_vec2(bounded_vec2(place) * scale), vec2f(-4194304.0), vec2f(4194304.0));
    let s = clamp(bounded_vec3(stretch), vec3f(-1e15), vec3f(1e15));
    return SpacedPlace(p, select(s, vec3f(1.0, 0.0, 1.0), is_pixel));
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
fn area_square(stretch: vec3f) -> f32 {
    let sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

/// Octave of the marks at a place: log2 of how many times finer than the place's own units they
/// must lie, for a squared stretch; within +-16.
fn octave_of(square: f32) -> f32 {
    return clamp(-0.5 * log2_stable(clamp(square, 1e-30, 1e30)), -16.0, 16.0);
}

/// Style of strokes.
struct Strokes {
    /// Width of a stroke, in spacings.
    width: f32,
    /// Length of a stroke, in spacings; 0 for endless strokes.
    length: f32,
    /// Share of a stroke that its ends take, 0 to 1.
    taper: f32,
    /// Distance that strokes stray, in spacings.
    wobble: f32,
    /// Effect of a darker tone: from more strokes at 0 to wider ones at 1.
    pressure: f32,
    /// Growth of the strokes between others: from all together at 0 to one after the other at 1.
    variation: f32,
    seed: u32,
}

/// A stroke as seen at a place.
struct Stroke {
    /// Turn of the stroke among its neighbors, 0 to 1.
    turn: f32,
    /// Width of the stroke at the place, as a share of its full width.
    profile: f32,
}

/// The stroke of a line at x, in one octave. A line's name is an odd number and the octave that it
/// first lies in.
fn stroke_at(line: vec2i, x: f32, zoom: i32, style: Strokes) -> Stroke {
    let own = unit_of_hash(lattice_hash(vec3i(line, 1 << 20u), style.seed));
    if style.length <= 0.0 {
        return Stroke(own.y, 1.0);
    }
    let along = clamp(x * power_of_two(zoom) / style.length, -1e6, 1e6) + own.x;
    let index = floor(along);
    let chance = unit_of_hash(lattice_hash(vec3i(line, i32(index)), style.seed
        + bitcast<u32>(zoom)));
    let from_end = min(along - index, 1.0 - (along - index));
    let slope = clamp(from_end / max(0.5 * style.taper, 1e-6), 0.0, 1.0);
    return Stroke(chance.x, slope * (2.0 - slope));
}

/// A stroke where an octave fades into the next.
fn stroke_between(line: vec2i, x: f32, level: f32, style: Strokes) -> Stroke {
    let zoom = floor(level);
    let a = stroke_at(line, x, i32(zoom), style);
    let b = stroke_at(line, x, i32(zoom) + 1, style);
    let f = level - zoom;
    return Stroke(mix(a.turn, b.turn, f), mix(a.profile, b.profile, f));
}

/// Distance that strokes stray at a place of an octave, in spacings of the place.
fn stray_at(place: vec2f, zoom: i32, seed: u32) -> f32 {
    // The noise changes slowly along a stroke and differs between neighbors.
    let p = place * power_of_two(zoom);
    return (value_noise(vec3f(0.11 * p.x, 0.45 * p.y, 0.5), seed) - 0.5) * 2.0
        * power_of_two(-zoom);
}

/// Share of a footprint of `w` that a band covers whose middle is t away and which reaches `half`
/// to both sides.
fn band_filtered(t: f32, half: f32, w: f32) -> f32 {
    if w < 1e-30 {
        return select(0.0, 1.0, (abs(t) <= half) & (half > 0.0));
    }
    return clamp((clamp(t + 0.5 * w, -half, half) - clamp(t - 0.5 * w, -half, half)) / w, 0.0, 1.0);
}

/// The ink of one direction of strokes. `place` is along and across, in spacings at `level` 0; `w`
/// is the footprint of the coordinate across. The average ink is `ink` times the width, but for
/// tapers.
fn hatched(place: vec2f, w: f32, level: f32, ink: f32, style: Strokes) -> f32 {
    if !(ink > 0.0) {
        return 0.0;
    }
    let number = powered(ink, 1.0 - style.pressure);
    let width = style.width * powered(ink, style.pressure);
    let zoom = floor(level);
    let stray = mix(stray_at(place, i32(zoom), style.seed),
        stray_at(place, i32(zoom) + 1, style.seed), level - zoom);
    let across = place.y + style.wobble * stray;
    // Every whole number of an octave has its stroke; between them those of the next octave grow.
    let density = clamp(level + log2_stable(max(number, 1e-9)), -40.0, 17.0);
    let octave = floor(density);
    let growth = exp2_stable(density - octave) - 1.0;
    let scale = power_of_two(i32(octave));
    let q = clamp(across * scale, -4194304.0, 4194304.0);
    let half = 0.5 * width * exp2_stable(octave - level);
    let footprint = w * scale;
    let whole = i32(round(q));
    let old = stroke_between(line_of(whole, i32(octave)), place.x, level, style);
    let middle = floor(q);
    let young = stroke_between(vec2i(2 * i32(middle) + 1, i32(octave) + 1), place.x, level, style);
    let late = 0.75 * style.variation;
    let grown = clamp((growth - late * young.turn) / (1.0 - late), 0.0, 1.0);
    let a = band_filtered(q - f32(whole), half * old.profile, footprint);
    let b = band_filtered(q - middle - 0.5, half * grown * young.profile, footprint);
    // Strokes finer than a pixel are their average.
    let mean = min(2.0 * half * (1.0 + growth), 1.0);
    return mix(max(a, b), mean, eased(footprint, 0.75, 1.5));
}

/// The name of a whole place's line in an octave: an odd number and the octave that the line first
/// lies in. The line at 0 lies in all.
fn line_of(whole: i32, octave: i32) -> vec2i {
    let power = select(whole & -whole, 1, whole == 0);
    // log2 of a power of two, by its bits.
    let octaves = i32(bitcast<u32>(f32(power)) >> 23u) - 127;
    return select(vec2i(whole / power, octave - octaves), vec2i(0), whole == 0);
}

/// The ink of strokes in up to four directions, each turned by `cross` radians from the one before:
/// the first take the light tones, and the others come in one after the other.
fn cross_hatched(at: SpacedPlace, ink: f32, layers: i32, cross: f32, style: Strokes) -> f32 {
    let x = dpdx(at.place);
    let y = dpdy(at.place);
    let count = clamp(layers, 1, 4);
    let amount = clamp(bounded(ink), 0.0, 1.0) * f32(count);
    var free = 1.0;
    for (var i = 0; i < 4; i++) {
        if i < count {
            let turn = sin_cos_of(f32(i) * cross);
            let along = vec2f(turn.y, turn.x);
            let across = vec2f(-turn.x, turn.y);
            let w = bounded(length(vec2f(dot(across, x), dot(across, y))));
            let s = at.stretch;
            // A place that hardly changes across the strokes counts as one that is drawn out eight
            // times, as in `area_square`.
            let square = dot(vec3f(across.x * across.x, 2.0 * across.x * across.y,
                across.y * across.y), s);
            let level = octave_of(max(square, (s.x + s.z) / 65.0));
            let place = vec2f(dot(along, at.place), dot(across, at.place));
            var own = style;
            own.seed = style.seed + 101u * u32(i);
            free *= 1.0 - hatched(place, w, level, clamp(amount - f32(i), 0.0, 1.0), own);
        }
    }
    return 1.0 - free;
}

/// Style of dots.
struct Dots {
    /// Diameter of a dot, in spacings.
    size: f32,
    /// Scatter of dots around the middles of their cells, 0 to 1.
    scatter: f32,
    seed: u32,
}

/// The square of an offset's length along the picture, for an offset in the units of a stretched
/// place.
fn picture_square(offset: vec2f, stretch: vec3f) -> f32 {
    let area = max(area_square(stretch), 1e-30);
    let square = stretch.z * offset.x * offset.x - 2.0 * stretch.y * offset.x * offset.y
        + stretch.x * offset.y * offset.y;
    return max(square, 0.0) / area;
}

/// The ink of one octave's dots, of which the share `ink` is drawn; `stretch` is that of a unit of
/// the octave.
fn dots_of_octave(place: vec2f, zoom: i32, ink: f32, stretch: vec3f, w: f32, style: Dots) -> f32 {
    let p = clamp(place * power_of_two(zoom), vec2f(-4194304.0), vec2f(4194304.0));
    let corner = floor(p);
    // Within this distance every dot is in one of the nine cells around.
    let reach = 1.0 - 0.5 * style.scatter;
    var tile = BLUE_TILE;
    var sum = 0.0;
    for (var i = 0; i < 9; i++) {
        let cell = vec2i(corner) + vec2i(i % 3 - 1, i / 3 - 1);
        let chance = unit_of_hash(lattice_hash(vec3i(cell, zoom), style.seed));
        let middle = vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5);
        let offset = p - middle;
        // The blue noise tells when a dot's turn is; the dot then grows within 1/32 of all ink.
        let turning = cell + vec2i(i32(style.seed & 31u), zoom * 7);
        let turn = 0.96875 * blue_part(tile[blue_index(turning)], turning);
        let grown = clamp((ink - turn) * 32.0, 0.0, 1.0);
        let radius = 0.5 * style.size * sqrt(grown);
        // Dots that are drawn out far beyond their cell are cut round.
        let far = length(offset) / reach;
        let d = max(sqrt(picture_square(offset, stretch)), far * far * radius);
        sum = max(sum, disk_filtered(d, radius, w));
    }
    return sum;
}

/// The ink of dots whose number, and not whose size, makes the tone.
fn stippled(at: SpacedPlace, ink: f32, style: Dots) -> f32 {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let w = bounded(sqrt(max(picture_square(dx, at.stretch), picture_square(dy, at.stretch))));
    let amount = clamp(bounded(ink), 0.0, 1.0);
    let s = at.stretch;
    let level = octave_of(sqrt(area_square(s)));
    let zoom = floor(level);
    let f = level - zoom;
    // The coarser octave goes as the finer one comes, so that together they are as many as before.
    let coarse_cells = exp2_stable(-2.0 * f);
    let coarse = 1.0 - f;
    let fine = (1.0 - coarse * coarse_cells) / (4.0 * coarse_cells);
    var dots = dots_of_octave(at.place, i32(zoom), amount * coarse, s * exp2_stable(2.0 * zoom), w,
        style);
    if fine > 0.0 {
        let finer = dots_of_octave(at.place, i32(zoom) + 1, amount * fine,
            s * exp2_stable(2.0 * zoom + 2.0), w, style);
        dots = max(dots, finer);
    }
    // Dots finer than a pixel are their average.
    let mean = amount * min(0.785398163397448310 * style.size * style.size, 1.0);
    return mix(dots, mean, eased(w, 0.75, 1.5));
}
