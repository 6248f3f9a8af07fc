import chiaro::types;
import chiaro::color;
import chiaro::total;

/// Color space
///
/// Between colours as screens are given them (sRGB) and amounts of light (linear). Light adds up correctly only in
/// linear; most painted pictures are sRGB.
///
/// @choice conversion "Conversion" default=srgb_to_linear srgb_to_linear="sRGB to linear" linear_to_srgb="Linear to sRGB" :
///   From which to which.
/// @param color "Color" default=1,1,1,1 : Straight RGBA; the alpha stays. A number below 0 goes by its size.
/// @return color "Color" : Straight RGBA.
/// @unit when color = unit
/// @source IEC 61966-2-1
fn color_space_srgb_to_linear(color: Color) -> Color {
    return vec4f(linear_of_srgb(color.x), linear_of_srgb(color.y), linear_of_srgb(color.z), bounded(color.w));
}

fn color_space_linear_to_srgb(color: Color) -> Color {
    return vec4f(srgb_of_linear(color.x), srgb_of_linear(color.y), srgb_of_linear(color.z), bounded(color.w));
}
