import chiaro::types;
import chiaro::total;

/// Gamma
///
/// Darkens (above 1) or lifts (below 1) the middle of a color and leaves black and white. Numbers
/// below 0 keep their sign, but for whole even gammas, where the result is positive.
///
/// @param color "Color" default=1,1,1,1 : Straight RGBA; the alpha stays.
/// @param gamma "Gamma" default=1 min=0.01 max=8 : The exponent of each channel.
/// @return color "Color" : Straight RGBA.
/// @bypass color when gamma = 1 : its gamma is 1
/// @unit when color = unit
fn gamma(color: Color, gamma: f32) -> Color {
    return vec4f(powered_vec3(color.xyz, max(bounded(gamma), 0.01)), bounded(color.w));
}
