// The tooth of paper: heights that catch ink (Kalnins et al. 2002).
import chiaro::numeric;
import chiaro::total;
import chiaro::noise;
import chiaro::marks;

/// Ink that the tooth of paper takes: more on its heights and less in its hollows, most so at
/// middle tones, and none of no ink (Kalnins et al. 2002). `height` is from 0 to 1, `tooth` from 0
/// (smooth paper) to 1.
fn caught_ink(ink: f32, height: f32, tooth: f32) -> f32 {
    let amount = clamp(bounded(ink), 0.0, 1.0);
    let rough = clamp(bounded(tooth), 0.0, 1.0);
    return clamp(amount + 8.0 * rough * (height - 0.5) * amount * (1.0 - amount), 0.0, 1.0);
}

/// The height of paper, from 0 to 1 and 1/2 on average. Where an octave fades into the next, both
/// octaves are seen.
fn paper_height(at: SpacedPlace, fiber: f32, seed: u32) -> f32 {
    let x = dpdx(at.place);
    let y = dpdy(at.place);
    let w = bounded(sqrt(max(dot(x, x), dot(y, y))));
    let level = octave_of(sqrt(area_square(at.stretch)));
    let zoom = floor(level);
    let f = level - zoom;
    let fine = clamp(bounded(fiber), 0.0, 1.0);
    var height = paper_octave(at.place, i32(zoom), w, fine, seed);
    if f > 0.0 {
        // Two octaves in one are flatter than each: the contrast that they lose is given back.
        let both = mix(height, paper_octave(at.place, i32(zoom) + 1, w, fine, seed), f);
        height = clamp(0.5 + (both - 0.5) / sqrt(f * f + (1.0 - f) * (1.0 - f)), 0.0, 1.0);
    }
    return height;
}

/// The height of paper in one octave; paper finer than a pixel is flat.
fn paper_octave(place: vec2f, zoom: i32, w: f32, fiber: f32, seed: u32) -> f32 {
    let scale = power_of_two(zoom);
    let p = clamp(place * scale, vec2f(-4194304.0), vec2f(4194304.0));
    let own = seed + 7u * bitcast<u32>(zoom);
    let grain = perlin_noise(vec3f(p, 0.5), own) - 0.5;
    // The felt that the sheet was pressed on: finer, turned, and long in no direction.
    let q = clamp(2.7 * vec2f(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), vec2f(-4194304.0),
        vec2f(4194304.0));
    let felt = perlin_noise(vec3f(q, 0.5), own + 1u) - 0.5;
    let coarse_seen = 1.0 - eased(w * scale, 0.5, 1.0);
    let felt_seen = 1.0 - eased(2.7 * w * scale, 0.5, 1.0);
    return clamp(0.5 + 1.4 * (coarse_seen * grain + fiber * felt_seen * felt), 0.0, 1.0);
}
