import chiaro::types;
import chiaro::total;

/// Invert color
///
/// The negative of a color, wholly or in part.
///
/// @param color "Color" default=1,1,1,1 : Straight RGBA; the alpha stays.
/// @param amount "Amount" default=1 min=0 max=1 : 0 leaves the color as it is, 1 is its negative.
/// @return color "Color" : Straight RGBA.
/// @bypass color when amount = 0 : its amount is 0
/// @unit when color = unit
fn negative_color(color: Color, amount: f32) -> Color {
    let rgb = bounded_vec3(color.xyz);
    return vec4f(mixed_vec3(rgb, bounded_vec3(1.0 - rgb), clamp(bounded(amount), 0.0, 1.0)),
        bounded(color.w));
}
