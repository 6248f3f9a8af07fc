import chiaro::types;
import chiaro::antialias;
import chiaro::total;

/// Checker
///
/// A chessboard of two colors, antialiased also where many squares share a pixel: to judge texture
/// coordinates, or as a pattern.
///
/// @param uv "UV" from=uv : Where on the board.
/// @param scale "Scale" default=8 : How many squares there are in one unit.
/// @param color_a "Color A" default=1,1,1,1 : The square at the origin.
/// @param color_b "Color B" default=0,0,0,1 : Its neighbors.
/// @return color "Color" : Straight RGBA.
/// @bypass color_a when color_a = color_b : both colors are the same
fn checker(uv: vec2f, scale: f32, color_a: Color, color_b: Color) -> Color {
    let p = bounded_vec2(uv * scale);
    return mixed_vec4(color_b, color_a, checker_filtered(p, footprint_of_vec2(p)));
}
