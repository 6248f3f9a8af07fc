import chiaro::screen;

/// Screen place
///
/// Where in the picture something is seen: for vignettes, gradients behind a figure, and patterns
/// that lie on the picture and not on surfaces.
///
/// @param pixel from=pixel hidden
/// @param viewport from=viewport hidden
fn screen_place(pixel: vec2f, viewport: vec2f) -> ScreenPlace {
    let place = place_in_picture(pixel, viewport);
    let aspect = viewport.x / max(viewport.y, 1.0);
    return ScreenPlace(pixel, place, vec2f(0.5 + place.x / max(aspect, 1e-6), 0.5 + place.y));
}

struct ScreenPlace {
    /// From the picture's upper left corner, x to the right and y down, in pixels; centers lie at
    /// halves.
    pixel: vec2f,
    /// From the picture's middle, x to the right and y up, in picture heights.
    place: vec2f,
    /// From 0 at the left to 1 at the right, and from 0 below to 1 above: texture coordinates of
    /// the picture.
    uv: vec2f,
}
