import chiaro::types;
import chiaro::color;
import chiaro::total;

/// Hue, saturation, value
///
/// Shifts a color: another hue, grayer or stronger, darker or brighter. Grays have no hue and stay
/// gray.
///
/// @param color "Color" default=1,1,1,1 : Straight RGBA; the alpha stays.
/// @param hue "Hue" unit=rad default=0 min=-pi max=pi : Turns the color wheel; a third of a turn
///   makes red green.
/// @param saturation "Saturation" default=1 min=0 max=2 : 0 is gray.
/// @param value "Value" default=1 min=0 max=2 : 0 is black.
/// @return color "Color" : Straight RGBA.
/// @bypass color when hue = 0 and saturation = 1 and value = 1 : it changes nothing
fn hsv_adjust(color: Color, hue: f32, saturation: f32, value: f32) -> Color {
    if hue == 0.0 && saturation == 1.0 && value == 1.0 {
        return bounded_vec4(color);
    }
    let rgb = bounded_vec3(color.xyz);
    return vec4f(hsv_adjusted(rgb, bounded(hue) * 0.159154943091895336, bounded(saturation),
        bounded(value)), bounded(color.w));
}
