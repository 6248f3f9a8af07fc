import chiaro::antialias;
import chiaro::screen;
import chiaro::total;

/// Half-tone
///
/// Turns a tone into dark dots, lines or crosses, as print does, whose average is the tone. Screens
/// belong to the picture's height, so that every resolution has the same ones. For print in color
/// take one node for each channel of Separate color; printers turn the screens of cyan (red's) by
/// 15 degrees, of magenta (green's) by 75, of yellow (blue's) by 0 and of black by 45.
///
/// @param value "Tone" default=0.5 min=0 max=1 : 1 is paper, 0 is ink.
/// @param place "Place" from=pixel : In pixels; the picture's own, or one that is moved.
/// @choice shape "Shape" default=dots dots="Dots" lines="Lines" crosses="Crosses" : What the screen
///   is made of. Dots grow until they run together.
/// @param lines "Lines" default=60 min=1 max=400 : How many rows of dots there are to the picture's
///   height.
/// @param angle "Angle" unit=rad default=0.785398163 : How far the screen is turned.
/// @param viewport from=viewport hidden
/// @return tone "Tone" : 0 in the ink and 1 beside it, antialiased.
/// @unit
/// @source Ulichney 1987, Digital Halftoning
fn halftone_dots(value: f32, place: vec2f, lines: f32, angle: f32, viewport: vec2f) -> f32 {
    let cell = screen_cells(place, viewport, lines, angle);
    let w = footprint_of_vec2(cell);
    return 1.0 - ink_of_dots(cell, 1.0 - factor_of(value, true), max(w.x, w.y));
}

fn halftone_lines(value: f32, place: vec2f, lines: f32, angle: f32, viewport: vec2f) -> f32 {
    let cell = screen_cells(place, viewport, lines, angle);
    return 1.0 - lines_filtered(cell.y, 1.0 - factor_of(value, true), footprint_of(cell.y));
}

fn halftone_crosses(value: f32, place: vec2f, lines: f32, angle: f32, viewport: vec2f) -> f32 {
    let cell = screen_cells(place, viewport, lines, angle);
    return 1.0 - ink_of_crosses(cell, 1.0 - factor_of(value, true), footprint_of_vec2(cell));
}
