import chiaro::types;
import chiaro::convert;
import chiaro::total;

/// Luminance
///
/// How bright a color looks, as one number: green counts most, blue least (Rec. 709 weights, on
/// the numbers as they stand).
///
/// @param color "Color" default=1,1,1,1 : The alpha does not count.
/// @return luminance "Luminance" : 0 for black, 1 for white.
/// @unit when color = unit
/// @source ITU-R BT.709
fn color_luminance(color: Color) -> f32 {
    return bounded(luminance(color));
}
