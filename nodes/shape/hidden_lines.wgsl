import chiaro::lines;
import chiaro::total;

/// Hidden lines
///
/// Lines of what lies behind, seen through what is in front, as a value: where the next surface
/// ends, folds or meets another. Draw them pale, thin, or broken by a noise or a half-tone. The
/// surface in front shows them, one layer deep: what lies behind two surfaces is not seen, nor are
/// the backs of solids.
///
/// @choice unit "Unit" default=height height="Of the height" pixels="Pixels" scene="Of the scene" :
///   What the width is measured in: thousandths of the picture's height, pixels, or units of the
///   scene at the surface in front.
/// @param width "Width" default=2 min=0 max=40 : Of a whole line, in that unit; lines reach up to
///   1/50 of the picture's height from their edges.
/// @param silhouettes "Silhouettes" default=1 min=0 max=4 : Share of the width where a form ends in
///   front of something else; 0 for none.
/// @param creases "Creases" default=0.5 min=0 max=4 : Share where a surface folds by 30 degrees or
///   more.
/// @param borders "Borders" default=1 min=0 max=4 : Share where two objects, materials or
///   ids meet.
/// @param nearness from=hidden_nearness hidden
/// @param viewport from=viewport hidden
/// @param magnification from=magnification hidden
/// @return line "Line" : From 0 beside hidden lines to 1 on them.
/// @source layers by depth after Everitt 2001; edges as those of the node Outline
fn hidden_lines_height(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    nearness: vec4f,
    viewport: vec2f,
) -> f32 {
    let shares = vec4f(silhouettes, creases, borders, borders);
    let widths = line_widths(line_pixels(width, 0.001 * viewport.y), shares, borders);
    return any_line_covers(nearness, widths, line_reach(viewport.y, LINE_STEPS));
}

fn hidden_lines_pixels(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    nearness: vec4f,
    viewport: vec2f,
) -> f32 {
    let shares = vec4f(silhouettes, creases, borders, borders);
    let widths = line_widths(line_pixels(width, 1.0), shares, borders);
    return any_line_covers(nearness, widths, line_reach(viewport.y, LINE_STEPS));
}

fn hidden_lines_scene(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    nearness: vec4f,
    viewport: vec2f,
    magnification: f32,
) -> f32 {
    let shares = vec4f(silhouettes, creases, borders, borders);
    let widths = line_widths(line_pixels(width, magnification * viewport.y), shares, borders);
    return any_line_covers(nearness, widths, line_reach(viewport.y, LINE_STEPS));
}
