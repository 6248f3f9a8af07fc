import chiaro::numeric;
import chiaro::total;

/// Constant size
///
/// Keeps strokes as large on the screen as they were painted, however far the surface is: the
/// repeats of a tile follow the distance in powers of two. Take a lookup or a picture at Even and
/// one at Odd, and mix them by Mix, so that one size fades into the next.
///
/// @param uv "UV" from=uv : Where on the tile, which repeats.
/// @param distance "Distance" from=depth : How far away the surface is, in scene units.
/// @param near "Own size at" default=3 min=0 : The distance at which the tile is as large as its
///   coordinates say. At 0 it is so at every distance.
/// @param fade "Fade" default=0.5 min=0 max=1 : In which part of the way from one size to the next
///   both are seen.
/// @source thesis 12.6
fn constant_size(uv: vec2f, distance: f32, near: f32, fade: f32) -> ConstantSize {
    let ratio = divided(distance, near);
    let octave = select(0.0, logarithm_of(clamp(ratio, 1e-15, 1e15)) * LOG2_E, ratio > 0.0);
    let low = i32(floor(octave));
    let middle = octave - floor(octave) - 0.5;
    let part = clamp(0.5 + middle / clamp(bounded(fade), 0.01, 1.0), 0.0, 1.0);
    // Of two neighboring sizes one is even and one odd: each changes only where the other alone is
    // seen.
    let is_odd = (low & 1) == 1;
    let even = low + (low & 1);
    let odd = low + 1 - (low & 1);
    return ConstantSize(
        bounded_vec2(uv * power_of_two(-even)),
        bounded_vec2(uv * power_of_two(-odd)),
        select(part, 1.0 - part, is_odd),
    );
}

struct ConstantSize {
    /// For one lookup.
    even: vec2f,
    /// For the other.
    odd: vec2f,
    /// How much the lookup at Odd counts, from 0 to 1.
    mix: f32,
}
