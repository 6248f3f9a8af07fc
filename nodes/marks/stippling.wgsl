import chiaro::marks;
import chiaro::total;

/// Stippling
///
/// Draws a tone by dots of one size: darker means more of them, and every dot of a lighter tone is
/// there in a darker one. Dots are as large on the picture as they are, however far the surface is;
/// which come first is blue noise, so that they lie evenly.
///
/// @param value "Tone" default=0.5 min=0 max=1 : 1 is paper; at 0 all dots are there.
/// @param place "Place" from=pixel : From Mark place; in pixels where Stretch is not wired.
/// @param stretch "Stretch" default=0,0,0 : From Mark place.
/// @param count "Dots" default=120 min=1 max=1000 : How many there are to the picture's height
///   where they are densest.
/// @param size "Size" default=0.7 min=0 max=1.4 : A dot's diameter, in spacings.
/// @param scatter "Scatter" default=0.8 min=0 max=1 : 0 is a grid; with more, dots lie anywhere
///   near their places.
/// @param seed "Seed" default=0 : Another number, other dots.
/// @param viewport from=viewport hidden
/// @return ink "Ink" : 1 in a dot, 0 beside it, antialiased.
/// @unit
/// @source Secord 2002; Ulichney 1993, void and cluster
fn stippling(
    value: f32,
    place: vec2f,
    stretch: vec3f,
    count: f32,
    size: f32,
    scatter: f32,
    seed: i32,
    viewport: vec2f,
) -> f32 {
    let style = Dots(clamp(bounded(size), 0.0, 1.4), clamp(bounded(scatter), 0.0, 1.0),
        bitcast<u32>(seed));
    return stippled(spaced(place, stretch, viewport, count), 1.0 - factor_of(value, true), style);
}
