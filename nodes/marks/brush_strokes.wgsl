import chiaro::types;
import chiaro::brush;
import chiaro::marks;
import chiaro::total;

/// Brush strokes
///
/// Lays one painted stroke again and again over a surface, each a little elsewhere and turned a
/// little, as many as a tone needs. The picture holds a single stroke from left to right, its ends
/// inside of the picture; or there is none, and a stiff brush leaves its own. Strokes lie on one
/// another as on a canvas, so that no seam is seen. They keep their size on the picture.
///
/// @param image "Image" widget=path : PNG, JPEG, HDR or EXR: one stroke. Bristles need none.
/// @param value "Tone" default=0 min=0 max=1 : 1 is bare canvas; at 0 all strokes are there.
/// @param place "Place" from=pixel : From Mark place; in pixels where Stretch is not wired.
/// @param stretch "Stretch" default=0,0,0 : From Mark place.
/// @param count "Rows" default=24 min=1 max=1000 : How many rows of strokes there are to the
///   picture's height.
/// @param aspect "Aspect" default=3 min=1 max=16 : How much longer a stroke is than wide.
/// @param size "Size" default=1.4 min=0.1 max=2 : Of a stroke, in its place's size; above 1 strokes
///   overlap.
/// @param scatter "Scatter" default=0.5 min=0 max=1 : How far strokes lie from their places.
/// @param turn "Turn" unit=rad default=0.3 min=0 : How far strokes are turned by chance, to both
///   sides together.
/// @param seed "Seed" default=0 : Another number, other strokes.
/// @choice mask "Ink is" default=alpha alpha="Alpha" dark="Dark" bristles="Bristles" : What of the
///   picture is paint: what is opaque, or what is dark. Bristles reads no picture: every stroke is
///   that of a stiff brush that runs dry, each with bristles of its own.
/// @choice filter "Filter" default=linear linear="Linear" nearest="Nearest" :
///   Linear is smooth; Nearest keeps the squares of pixel art.
/// @choice encoding "Encoding" default=color color="Color" data="Data" :
///   Color for what is seen; Data takes numbers as they are.
/// @param viewport from=viewport hidden
/// @source Klein et al. 2000, art maps; Meier 1996; Kalnins et al. 2002, strokes that keep their
///   size
fn brush_strokes_alpha(
    image: texture_2d<f32>,
    image_sampler: sampler,
    value: f32,
    place: vec2f,
    stretch: vec3f,
    count: f32,
    aspect: f32,
    size: f32,
    scatter: f32,
    turn: f32,
    seed: i32,
    viewport: vec2f,
) -> BrushStrokes {
    let at = spaced(place, stretch, viewport, count);
    let style = brush_of(aspect, size, scatter, turn, seed, false);
    let paint = brushed(image, image_sampler, at, 1.0 - factor_of(value, true), style);
    return BrushStrokes(vec4f(paint.xyz / max(paint.w, 1e-3), 1.0), paint.w);
}

fn brush_strokes_dark(
    image: texture_2d<f32>,
    image_sampler: sampler,
    value: f32,
    place: vec2f,
    stretch: vec3f,
    count: f32,
    aspect: f32,
    size: f32,
    scatter: f32,
    turn: f32,
    seed: i32,
    viewport: vec2f,
) -> BrushStrokes {
    let at = spaced(place, stretch, viewport, count);
    let style = brush_of(aspect, size, scatter, turn, seed, true);
    let paint = brushed(image, image_sampler, at, 1.0 - factor_of(value, true), style);
    return BrushStrokes(vec4f(paint.xyz / max(paint.w, 1e-3), 1.0), paint.w);
}

fn brush_strokes_bristles(
    value: f32,
    place: vec2f,
    stretch: vec3f,
    count: f32,
    aspect: f32,
    size: f32,
    scatter: f32,
    turn: f32,
    seed: i32,
    viewport: vec2f,
) -> BrushStrokes {
    let at = spaced(place, stretch, viewport, count);
    let style = brush_of(aspect, size, scatter, turn, seed, false);
    let paint = bristles_laid(at, 1.0 - factor_of(value, true), style);
    let shade = paint.x / max(paint.y, 1e-3);
    return BrushStrokes(vec4f(shade, shade, shade, 1.0), paint.y);
}

struct BrushStrokes {
    /// The picture's own color, opaque; of bristles how light their paint lies, to multiply a
    /// color by; black where no stroke is.
    color: Color,
    /// How much of the canvas is covered, from 0 to 1.
    ink: f32,
}
