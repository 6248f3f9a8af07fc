import chiaro::types;
import chiaro::total;

/// Brightness and contrast
///
/// Lifts or lowers a color, and spreads or gathers it around a middle. The result may leave 0 to
/// 1.
///
/// @param color "Color" default=1,1,1,1 : Straight RGBA; the alpha stays.
/// @param brightness "Brightness" default=0 min=-1 max=1 : Is added.
/// @param contrast "Contrast" default=0 min=-1 max=1 : At -1 everything is as the middle, at 1
///   twice as far from it.
/// @param middle "Middle" default=0.5 min=0 max=1 : What contrast leaves as it is.
/// @return color "Color" : Straight RGBA.
/// @bypass color when brightness = 0 and contrast = 0 : it changes nothing
fn brightness_contrast(color: Color, brightness: f32, contrast: f32, middle: f32) -> Color {
    return vec4f(bounded_vec3(color.xyz + (contrast * (color.xyz - middle) + brightness)),
        bounded(color.w));
}
