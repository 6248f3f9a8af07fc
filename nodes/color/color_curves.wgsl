import chiaro::types;
import chiaro::curve;
import chiaro::total;
import chiaro::antialias;

/// Color curves
///
/// Redraws a color's channels along curves, one for all of them and then one for each: contrast,
/// film looks, split toning.
///
/// @param color "Color" default=0.5,0.5,0.5,1 : Straight RGBA; its alpha stays.
/// @param all "All" : For red, green and blue alike, first.
/// @param red "Red" : At most 16 points, as each of them.
/// @param green "Green" : The same for green.
/// @param blue "Blue" : The same for blue.
/// @return color "Color" : Straight RGBA.
/// @source Fritsch and Butland 1984
fn color_curves(color: Color, all: Curve, red: Curve, green: Curve, blue: Curve) -> Color {
    let c = bounded_vec4(color);
    let w = vec3f(footprint_of(c.x), footprint_of(c.y), footprint_of(c.z));
    let r = curve_at(all, c.x, w.x);
    let g = curve_at(all, c.y, w.y);
    let b = curve_at(all, c.z, w.z);
    // A stepped curve after the first one sees its steps as wide as the color's own.
    return vec4f(curve_at(red, r, w.x), curve_at(green, g, w.y), curve_at(blue, b, w.z), c.w);
}
