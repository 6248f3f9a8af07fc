import chiaro::lines;
import chiaro::total;

/// Outline
///
/// Ink where forms end, fold and meet, as values to be drawn in any color: silhouettes, creases,
/// borders of objects, of materials and of ids, each as wide as it is told. A silhouette is drawn
/// by what lies in front, as wide as it is; where two surfaces meet, each draws its half of the
/// line. Wire the width to a curvature, a tone or a noise and lines taper.
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
/// @param material_borders "Borders of materials" default=0 min=0 max=4 : Share where two
///   materials of an object meet.
/// @param id_borders "Borders of ids" default=0 min=0 max=4 : Share where the *Id* of a look's
///   *Output* changes within a material.
/// @param nearness from=line_nearness hidden
/// @param middle from=middle_surface hidden
/// @param depth from=depth hidden
/// @param object from=object_id hidden
/// @param viewport from=viewport hidden
/// @param magnification from=magnification hidden
/// @error fast 32 : kind and distance of edges beyond 1/100 of the picture's height, where lines
///   are wider than that, and, with several samples a pixel, in pixels at the silhouettes of what
///   lies behind
/// @source edges in depth, normals and objects after Saito and Takahashi 1990; distances by columns
///   after Meijster et al. 2000; courses after Reshetov 2009
fn outline_height(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    material_borders: f32,
    id_borders: f32,
    nearness: vec4f,
    middle: vec2f,
    depth: f32,
    object: f32,
    viewport: vec2f,
    magnification: f32,
) -> Outline {
    let pixels = magnification * viewport.y;
    let reach = line_reach(viewport.y, LINE_STEPS);
    let own = own_nearness(nearness, middle, depth, object, pixels, reach);
    let shares = vec4f(silhouettes, creases, borders, material_borders);
    let widths = line_widths(line_pixels(width, 0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, own, reach);
}

fn outline_pixels(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    material_borders: f32,
    id_borders: f32,
    nearness: vec4f,
    middle: vec2f,
    depth: f32,
    object: f32,
    viewport: vec2f,
    magnification: f32,
) -> Outline {
    let pixels = magnification * viewport.y;
    let reach = line_reach(viewport.y, LINE_STEPS);
    let own = own_nearness(nearness, middle, depth, object, pixels, reach);
    let shares = vec4f(silhouettes, creases, borders, material_borders);
    let widths = line_widths(line_pixels(width, 1.0), shares, id_borders);
    return drawn_outline(widths, own, reach);
}

fn outline_scene(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    material_borders: f32,
    id_borders: f32,
    nearness: vec4f,
    middle: vec2f,
    depth: f32,
    object: f32,
    viewport: vec2f,
    magnification: f32,
) -> Outline {
    let pixels = magnification * viewport.y;
    let reach = line_reach(viewport.y, LINE_STEPS);
    let own = own_nearness(nearness, middle, depth, object, pixels, reach);
    let shares = vec4f(silhouettes, creases, borders, material_borders);
    let widths = line_widths(line_pixels(width, pixels), shares, id_borders);
    return drawn_outline(widths, own, reach);
}

fn outline_height_fast(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    material_borders: f32,
    id_borders: f32,
    nearness: vec4f,
    viewport: vec2f,
) -> Outline {
    let shares = vec4f(silhouettes, creases, borders, material_borders);
    let widths = line_widths(line_pixels(width, 0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, nearness, line_reach(viewport.y, FEW_LINE_STEPS));
}

fn outline_pixels_fast(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    material_borders: f32,
    id_borders: f32,
    nearness: vec4f,
    viewport: vec2f,
) -> Outline {
    let shares = vec4f(silhouettes, creases, borders, material_borders);
    let widths = line_widths(line_pixels(width, 1.0), shares, id_borders);
    return drawn_outline(widths, nearness, line_reach(viewport.y, FEW_LINE_STEPS));
}

fn outline_scene_fast(
    width: f32,
    silhouettes: f32,
    creases: f32,
    borders: f32,
    material_borders: f32,
    id_borders: f32,
    nearness: vec4f,
    viewport: vec2f,
    magnification: f32,
) -> Outline {
    let shares = vec4f(silhouettes, creases, borders, material_borders);
    let widths = line_widths(line_pixels(width, magnification * viewport.y), shares, id_borders);
    return drawn_outline(widths, nearness, line_reach(viewport.y, FEW_LINE_STEPS));
}

struct Outline {
    /// From 0 beside lines to 1 on them.
    line: f32,
    /// The line's kind where it is drawn: 1 a silhouette, 2 a crease, 3 a border of objects, 4 a
    /// border of materials, 5 a border of ids; 0 beside lines.
    kind: f32,
    /// To the nearest edge of a kind that is drawn, in pixels; as far as lines reach where none is
    /// near.
    distance: f32,
}

fn drawn_outline(line_widths: LineWidths, of_edges: vec4f, reach: f32) -> Outline {
    let signed = clamp(bounded_vec4(of_edges), vec4f(-reach), vec4f(reach));
    let nearness = abs(signed);
    let widths = widths_near(signed, line_widths);
    let covers = lines_cover(nearness, widths, reach);
    let line = max(max(covers.x, covers.y), max(covers.z, covers.w));
    // Kinds that cover as much but for rounding: the first of them.
    let least = line - 0.0009765625;
    var kind = select(4.0, 5.0, signed.w < 0.0);
    kind = select(kind, 3.0, covers.z >= least);
    kind = select(kind, 2.0, covers.y >= least);
    kind = select(kind, 1.0, covers.x >= least);
    let near = select(vec4f(0.0), nearness, widths > vec4f(0.0));
    let nearest = max(max(near.x, near.y), max(near.z, near.w));
    // A share of nothing but rounding is of no kind; widths of round numbers are not at the bound.
    return Outline(line, select(0.0, kind, line > 0.0009765625), reach - nearest);
}
