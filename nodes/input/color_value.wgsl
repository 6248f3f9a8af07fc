import chiaro::types;

/// Color
///
/// A color to wire to several places, or to expose as a parameter of the look.
///
/// @param color "Color" default=1,1,1,1 : Straight RGBA.
/// @return color "Color" : The same.
fn color_value(color: Color) -> Color {
    return color;
}
