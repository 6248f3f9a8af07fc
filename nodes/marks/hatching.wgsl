import chiaro::marks;
import chiaro::total;

/// Hatching
///
/// Draws a tone by strokes. Their width and spacing belong to the picture, whatever the distance;
/// darker adds whole strokes between those that are there, and then strokes of another direction,
/// so that lighter tones' strokes are always among darker tones'.
///
/// @param value "Tone" default=0.5 min=0 max=1 : 1 is paper; 0 is the densest hatching.
/// @param place "Place" from=pixel : From Mark place; in pixels where Stretch is not wired.
/// @param stretch "Stretch" default=0,0,0 : From Mark place.
/// @param count "Strokes" default=90 min=1 max=1000 : How many there are to the picture's height
///   where they are densest.
/// @param width "Width" default=0.5 min=0 max=1 : Of a stroke, in spacings.
/// @param layers "Directions" default=2 min=1 max=4 : How many directions cross in the darkest
///   tones.
/// @param cross "Crossing angle" unit=rad default=1.0471975512 : From one direction to the next.
/// @param length "Length" default=24 min=0 max=1000 : Of a stroke, in spacings; 0 is endless.
/// @param taper "Taper" default=0.6 min=0 max=1 : How much of a stroke its pointed ends take.
/// @param wobble "Wobble" default=0.6 min=0 max=10 : How far strokes stray, in spacings.
/// @param pressure "Pressure" default=0.25 min=0 max=1 : At 0 darker means more strokes, at 1 wider
///   ones, as in engraving.
/// @param variation "Variation" default=1 min=0 max=1 : At 0 all strokes between two others grow
///   together, at 1 one after the other.
/// @param seed "Seed" default=0 : Another number, other strokes.
/// @param viewport from=viewport hidden
/// @return ink "Ink" : 1 on a stroke, 0 beside it, antialiased.
/// @unit
/// @source Praun et al. 2001, tonal art maps; Klein et al. 2000, art maps; Kalnins et al. 2002,
///   mobile strokes
fn hatching(
    value: f32,
    place: vec2f,
    stretch: vec3f,
    count: f32,
    width: f32,
    layers: i32,
    cross: f32,
    length: f32,
    taper: f32,
    wobble: f32,
    pressure: f32,
    variation: f32,
    seed: i32,
    viewport: vec2f,
) -> f32 {
    let style = Strokes(
        clamp(bounded(width), 0.0, 1.0),
        clamp(bounded(length), 0.0, 1e4),
        clamp(bounded(taper), 0.0, 1.0),
        clamp(bounded(wobble), 0.0, 100.0),
        clamp(bounded(pressure), 0.0, 1.0),
        clamp(bounded(variation), 0.0, 1.0),
        bitcast<u32>(seed),
    );
    let at = spaced(place, stretch, viewport, count);
    return cross_hatched(at, 1.0 - factor_of(value, true), layers, cross, style);
}
