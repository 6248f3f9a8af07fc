import chiaro::lines;
import chiaro::total;

/// Outline
///
/// Ink where forms end, fold and meet, as values to be drawn in any color: silhouettes, creases,
/// borders of objects and borders of looks, each as wide as it is told. A silhouette is drawn by
/// what lies in front, as wide as it is; where two surfaces meet, each draws its half of the line.
/// Wire the width to a curvature, a tone or a noise and lines taper.
///
/// @choice unit "Unit" default=height height="Of the height" pixels="Pixels" scene="Of the scene" :
///   What the width is measured in: thousandths of the picture's height, pixels, or units of the
///   scene, so that lines grow as the camera comes near.
/// @param width "Width" default=4 min=0 max=40 : Of a whole line, in that unit; lines reach up to
///   1/50 of the picture's height from their edges.
/// @param silhouettes "Silhouettes" default=1 min=0 max=4 : Share of the width where a form ends in
///   front of something else; 0 for none.
/// @param creases "Creases" default=0.5 min=0 max=4 : Share where a surface folds by 30 degrees or
///   more.
/// @param borders "Borders of objects" default=1 min=0 max=4 : Share where two objects meet.
/// @param look_borders "Borders of looks" default=0 min=0 max=4 : Share where two looks of an object
///   meet.
/// @param nearness from=line_nearness hidden
/// @param viewport from=viewport hidden
/// @param magnification from=magnification hidden
/// @source edges in depth, normals and objects after Saito and Takahashi 1990; distances by columns
///   after Meijster et al. 2000; courses after Reshetov 2009
fn outline_height(width: f32, silhouettes: f32, creases: f32, borders: f32, look_borders: f32,
    nearness: vec4f, viewport: vec2f) -> Outline {
    return drawn_outline(line_pixels(width, 0.001 * viewport.y),
        vec4f(silhouettes, creases, borders, look_borders), nearness, viewport.y);
}

fn outline_pixels(width: f32, silhouettes: f32, creases: f32, borders: f32, look_borders: f32,
    nearness: vec4f, viewport: vec2f) -> Outline {
    return drawn_outline(line_pixels(width, 1.0),
        vec4f(silhouettes, creases, borders, look_borders), nearness, viewport.y);
}

fn outline_scene(width: f32, silhouettes: f32, creases: f32, borders: f32, look_borders: f32,
    nearness: vec4f, viewport: vec2f, magnification: f32) -> Outline {
    return drawn_outline(line_pixels(width, magnification * viewport.y),
        vec4f(silhouettes, creases, borders, look_borders), nearness, viewport.y);
}

struct Outline {
    /// From 0 beside lines to 1 on them.
    line: f32,
    /// The line's kind where it is drawn: 1 a silhouette, 2 a crease, 3 a border of objects, 4 a
    /// border of looks; 0 beside lines.
    kind: f32,
    /// To the nearest edge of a kind that is drawn, in pixels; as far as lines reach where none is
    /// near.
    distance: f32,
}

fn drawn_outline(width: f32, shares: vec4f, nearness: vec4f, height: f32) -> Outline {
    let reach = line_reach(height);
    let widths = line_widths(width, shares);
    let covers = lines_cover(nearness, widths, reach);
    let line = max(max(covers.x, covers.y), max(covers.z, covers.w));
    var kind = 4.0;
    kind = select(kind, 3.0, covers.z == line);
    kind = select(kind, 2.0, covers.y == line);
    kind = select(kind, 1.0, covers.x == line);
    let near = select(vec4f(0.0), nearness, widths > vec4f(0.0));
    let nearest = max(max(near.x, near.y), max(near.z, near.w));
    return Outline(line, select(0.0, kind, line > 0.0), reach - nearest);
}
