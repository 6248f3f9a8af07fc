// Brush strokes, from a picture or of bristles, laid over one another in an order that is the same
// everywhere, so that no cell has a seam.
import chiaro::numeric;
import chiaro::total;
import chiaro::noise;
import chiaro::marks;
import chiaro::blue_noise;
import chiaro::convert;

/// Style of brush strokes.
struct Brush {
    /// Length of a stroke over its width.
    aspect: f32,
    /// Size of a stroke over that of its cell.
    size: f32,
    /// Scatter of strokes around the middles of their cells, 0 to 1.
    scatter: f32,
    /// Range of the strokes' angles, both sides together, in radians.
    turn: f32,
    seed: u32,
    /// True if the picture's dark texels are paint; false if its opaque ones are.
    is_dark: bool,
}

fn brush_of(aspect: f32, size: f32, scatter: f32, turn: f32, seed: i32, is_dark: bool) -> Brush {
    return Brush(
        clamp(bounded(aspect), 1.0, 16.0),
        clamp(bounded(size), 0.1, 2.0),
        clamp(bounded(scatter), 0.0, 1.0),
        clamp(bounded(turn), 0.0, 6.28318531),
        bitcast<u32>(seed),
        is_dark,
    );
}

/// Premultiplied paint at a place, of strokes from a picture; `ink` is the share of all strokes
/// that are there.
fn brushed(image: texture_2d<f32>, image_sampler: sampler, at: SpacedPlace, ink: f32,
    style: Brush) -> vec4f {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let level = octave_of(sqrt(area_square(at.stretch)));
    let zoom = floor(level);
    let f = level - zoom;
    // The coarser octave goes as the finer one comes, as with the dots of stippling.
    let coarse_cells = exp2_stable(-2.0 * f);
    let fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    var tile = BLUE_TILE;
    var paint = vec4f(0.0);
    for (var octave = 0; octave < 2; octave++) {
        let amount = ink * select(1.0 - f, fine, octave == 1);
        let scale = power_of_two(i32(zoom) + octave);
        let p = clamp(at.place * scale, vec2f(-4194304.0), vec2f(4194304.0))
            / vec2f(style.aspect, 1.0);
        let corner = vec2i(floor(p));
        let phase = ((corner % vec2i(3)) + vec2i(3)) % vec2i(3);
        for (var i = 0; i < 9; i++) {
            // The nine cells around are of nine kinds, one of each; kinds lie over one another in
            // the same order everywhere.
            let cell = corner + (vec2i(i % 3, i / 3) - phase + vec2i(4)) % vec2i(3) - vec2i(1);
            let turning = cell + vec2i(i32(style.seed & 31u), 7 * (i32(zoom) + octave));
            let late = 0.96875 * blue_part(tile[blue_index(turning)], turning);
            let share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if share <= 0.0 {
                continue;
            }
            let stroke = brush_stroke(p, cell, i32(zoom) + octave, share, style);
            if stroke.share > 0.0 {
                let gx = brush_turned(dx * scale, stroke, style);
                let gy = brush_turned(dy * scale, stroke, style);
                let texel = textureSampleGrad(image, image_sampler, stroke.uv, gx, gy);
                let dark = 1.0 - clamp(luminance(texel), 0.0, 1.0);
                let cover = stroke.share * texel.w * select(1.0, dark, style.is_dark);
                paint = vec4f(texel.xyz * cover, cover) + paint * (1.0 - cover);
            }
        }
    }
    return paint;
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
fn bristles_laid(at: SpacedPlace, ink: f32, style: Brush) -> vec2f {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let level = octave_of(sqrt(area_square(at.stretch)));
    let zoom = floor(level);
    let f = level - zoom;
    let coarse_cells = exp2_stable(-2.0 * f);
    let fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    var tile = BLUE_TILE;
    var paint = vec2f(0.0);
    for (var octave = 0; octave < 2; octave++) {
        let amount = ink * select(1.0 - f, fine, octave == 1);
        let scale = power_of_two(i32(zoom) + octave);
        let p = clamp(at.place * scale, vec2f(-4194304.0), vec2f(4194304.0))
            / vec2f(style.aspect, 1.0);
        let corner = vec2i(floor(p));
        let phase = ((corner % vec2i(3)) + vec2i(3)) % vec2i(3);
        for (var i = 0; i < 9; i++) {
            let cell = corner + (vec2i(i % 3, i / 3) - phase + vec2i(4)) % vec2i(3) - vec2i(1);
            let turning = cell + vec2i(i32(style.seed & 31u), 7 * (i32(zoom) + octave));
            let late = 0.96875 * blue_part(tile[blue_index(turning)], turning);
            let share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if share <= 0.0 {
                continue;
            }
            let stroke = brush_stroke(p, cell, i32(zoom) + octave, share, style);
            if stroke.share > 0.0 {
                let gx = brush_turned(dx * scale, stroke, style);
                let gy = brush_turned(dy * scale, stroke, style);
                let own = lattice_hash(vec3i(cell, i32(zoom) + octave), style.seed + 2u).x;
                let drawn = bristles(stroke.uv, length(vec2f(gx.y, gy.y)), own);
                let cover = stroke.share * drawn.y;
                paint = vec2f(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
        }
    }
    return paint;
}

/// Three random numbers of a bristle, 0 to 1; across a stroke they go over smoothly into those of
/// the next bristle.
fn bristle(row: f32, seed: u32) -> vec3f {
    let first = floor(row);
    let t = row - first;
    let a = unit_of_hash(lattice_hash(vec3i(i32(first), 0, 0), seed));
    let b = unit_of_hash(lattice_hash(vec3i(i32(first) + 1, 0, 0), seed));
    return mix(a, b, t * t * (3.0 - 2.0 * t));
}

/// A stroke of a stiff brush at the place `uv` in it: lightness of its paint in x, coverage in y.
/// `width` is a pixel's share of the stroke's width.
fn bristles(uv: vec2f, width: f32, seed: u32) -> vec2f {
    let across = 2.0 * uv.y - 1.0;
    let own = unit_of_hash(lattice_hash(vec3i(0, 1, 0), seed));
    // Bristles finer than a pixel become their average.
    let seen = clamp(1.75 - 11.0 * width, 0.0, 1.0);
    let chance = mix(vec3f(0.5), bristle(11.0 * uv.y, seed), seen);
    // The tip is round, and every bristle begins and leaves off at its own place.
    let start = 0.03 + 0.12 * chance.x + 0.09 * across * across;
    let end = 0.97 - (0.1 + 0.25 * own.y) * chance.y - 0.12 * across * across;
    let along = eased(uv.x, start, start + 0.05) * (1.0 - eased(uv.x, end - 0.1, end));
    let side = 1.0 - eased(abs(across), 0.78, 0.95);
    let dry = eased(uv.x + 0.55 * chance.z, 0.85, 1.25);
    let shade = 0.8 + 0.16 * own.z + 0.208 * (chance.z - 0.5) - 0.05 * uv.x;
    return vec2f(clamp(shade, 0.0, 1.0), along * side * (1.0 - 0.9 * dry));
}

/// A stroke as seen at a place.
struct Brushstroke {
    /// Place in the stroke's picture, v down.
    uv: vec2f,
    /// Sine and cosine of the stroke's angle.
    turn: vec2f,
    /// Direction of the stroke: 1 forward, -1 backward.
    way: f32,
    /// Share of the stroke that is there, 0 to 1.
    share: f32,
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
fn brush_stroke(p: vec2f, cell: vec2i, zoom: i32, drawn: f32, style: Brush) -> Brushstroke {
    let chance = unit_of_hash(lattice_hash(vec3i(cell, zoom), style.seed));
    let offset = p - (vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5));
    let turn = sin_cos_of(style.turn * (chance.z - 0.5));
    let way = select(-1.0, 1.0, unit_of_hash(lattice_hash(vec3i(cell, zoom), style.seed
        + 1u)).x < 0.5);
    let stroke = Brushstroke(vec2f(0.5), turn, way, 0.0);
    let uv = 0.5 + brush_turned(offset * vec2f(style.aspect, 1.0), stroke, style);
    // The picture's outermost 64th fades, so that no stroke is cut off.
    let from_edge = min(uv, vec2f(1.0) - uv);
    let inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    // A stroke must not reach beyond the cells around its own: a pixel looks at no others.
    let far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    let share = drawn * inside * (1.0 - eased(far, 0.85, 1.0));
    return Brushstroke(uv, turn, way, share);
}

/// A step on the canvas as a step in a stroke's picture.
fn brush_turned(step: vec2f, stroke: Brushstroke, style: Brush) -> vec2f {
    let turned = vec2f(
        stroke.turn.y * step.x + stroke.turn.x * step.y,
        stroke.turn.y * step.y - stroke.turn.x * step.x,
    );
    return turned * vec2f(stroke.way / (style.size * style.aspect), -1.0 / style.size);
}
