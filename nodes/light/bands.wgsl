import chiaro::antialias;
import chiaro::total;

/// Bands
///
/// Cuts a tone into flat bands of the same width, the first 0 and the last 1: cel shading. The
/// edges are antialiased by their own width on the screen.
///
/// @param value "Tone" default=0 min=0 max=1 : Below 0 counts as 0, above 1 as 1.
/// @param count "Bands" default=3 min=2 max=64 : How many; fewer than 2 count as 2.
/// @param softness "Softness" default=0 min=0 max=1 : How much of a band its edge takes; at 1 only
///   a ramp is left.
/// @return tone "Tone" : From 0 to 1.
/// @unit
/// @error balanced 0.15 : tone on the pixels of an edge, in steps between bands; 0 elsewhere
/// @error fast 0.51 : tone on the pixels of an edge, in steps between bands, without antialiasing;
///   0 elsewhere
/// @source Lake et al. 2000, cel shading
fn bands(value: f32, count: i32, softness: f32) -> f32 {
    return stepped_tone(value, footprint_of(value), count, softness);
}

fn bands_balanced(value: f32, count: i32, softness: f32) -> f32 {
    let n = f32(clamp(count, 2, 1024));
    let tone = clamp(bounded(value), 0.0, 1.0);
    let width = edge_width(n * footprint_by_sum(tone), min(softness, 1.0));
    return stairs_quick(n * tone, n, width) / (n - 1.0);
}

fn bands_fast(value: f32, count: i32, softness: f32) -> f32 {
    let n = f32(clamp(count, 2, 1024));
    return stairs_quick(n * clamp(bounded(value), 0.0, 1.0), n, edge_width(0.0, min(softness, 1.0)))
        / (n - 1.0);
}
