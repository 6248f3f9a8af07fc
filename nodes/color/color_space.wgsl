import chiaro::types;
import chiaro::color;
import chiaro::total;

/// Color space
///
/// Between colors as screens are given them (sRGB) and amounts of light (linear). Light adds up
/// correctly only in linear; most painted pictures are sRGB. Oklab holds lightness, green to red
/// and blue to yellow, in steps that look even.
///
/// @choice conversion "Conversion" default=srgb_to_linear srgb_to_linear="sRGB to linear"
///   linear_to_srgb="Linear to sRGB" srgb_to_oklab="sRGB to Oklab" oklab_to_srgb="Oklab to sRGB" :
///   From which to which.
/// @param color "Color" default=1,1,1,1 : Straight RGBA; the alpha stays. A number below 0 goes by
///   its size.
/// @return color "Color" : Straight RGBA.
/// @source IEC 61966-2-1, Ottosson 2020
fn color_space_srgb_to_linear(color: Color) -> Color {
    return vec4f(linear_of_srgb(color.x), linear_of_srgb(color.y), linear_of_srgb(color.z),
        bounded(color.w));
}

fn color_space_linear_to_srgb(color: Color) -> Color {
    return vec4f(srgb_of_linear(color.x), srgb_of_linear(color.y), srgb_of_linear(color.z),
        bounded(color.w));
}

fn color_space_srgb_to_oklab(color: Color) -> Color {
    return vec4f(bounded_vec3(oklab_of_srgb(color.xyz)), bounded(color.w));
}

fn color_space_oklab_to_srgb(color: Color) -> Color {
    return vec4f(bounded_vec3(srgb_of_oklab(color.xyz)), bounded(color.w));
}
