import chiaro::types;
import chiaro::color;
import chiaro::total;

/// Mix colors
///
/// Lays one color on another as paint programs do. For a stack of shading layers take Blend, which
/// knows tones and transparency.
///
/// @choice mode "Mode" default=normal normal="Normal" multiply="Multiply" screen="Screen"
///   overlay="Overlay" soft_light="Soft light" hard_light="Hard light" darken="Darken"
///   lighten="Lighten" add="Add" subtract="Subtract" difference="Difference" divide="Divide"
///   exclusion="Exclusion" color_dodge="Color dodge" color_burn="Color burn" hue="Hue"
///   saturation="Saturation" color="Color" luminosity="Luminosity" : How B acts on A. The last four
///   take that of B and the rest of A; they and both Color modes are meant for colors from 0 to 1,
///   and count others as the nearest of those.
/// @param a "A" default=0,0,0,1 : The color below.
/// @param b "B" default=1,1,1,1 : The color on top.
/// @param factor "Factor" default=0.5 min=0 max=1 : How much of the effect; 0 is A.
/// @return color "Color" : Normal mixes the alpha too; all others keep that of A.
/// @bypass a when factor = 0 : its factor is 0
/// @bypass b when factor = 1 and mode = normal : its factor is 1
/// @bypass a when factor <= 0 : its factor is never above 0
/// @bypass b when factor >= 1 and mode = normal : its factor is never below 1
/// @bypass a when a = b and mode = normal|darken|lighten : both colors are the same
/// @source W3C Compositing and Blending 1
fn mix_colors_normal(a: Color, b: Color, factor: f32) -> Color {
    return mixed_vec4(bounded_vec4(a), bounded_vec4(b), factor_of(factor, true));
}

fn mix_colors_multiply(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, a.xyz * b.xyz, factor);
}

fn mix_colors_screen(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, screened(a.xyz, b.xyz), factor);
}

fn mix_colors_overlay(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, hard_lit(b.xyz, a.xyz), factor);
}

fn mix_colors_soft_light(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, soft_lit(a.xyz, b.xyz), factor);
}

fn mix_colors_hard_light(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, hard_lit(a.xyz, b.xyz), factor);
}

fn mix_colors_darken(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, min(a.xyz, b.xyz), factor);
}

fn mix_colors_lighten(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, max(a.xyz, b.xyz), factor);
}

fn mix_colors_add(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, a.xyz + b.xyz, factor);
}

fn mix_colors_subtract(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, a.xyz - b.xyz, factor);
}

fn mix_colors_difference(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, abs(a.xyz - b.xyz), factor);
}

fn mix_colors_divide(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, vec3f(divided(a.x, b.x), divided(a.y, b.y), divided(a.z, b.z)), factor);
}

fn mix_colors_exclusion(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, excluded(a.xyz, b.xyz), factor);
}

fn mix_colors_color_dodge(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, dodged_by(a.xyz, b.xyz), factor);
}

fn mix_colors_color_burn(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, burned_by(a.xyz, b.xyz), factor);
}

fn mix_colors_hue(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, hued(a.xyz, b.xyz), factor);
}

fn mix_colors_saturation(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, saturated(a.xyz, b.xyz), factor);
}

fn mix_colors_color(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, tinted(a.xyz, b.xyz), factor);
}

fn mix_colors_luminosity(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, tinted(b.xyz, a.xyz), factor);
}
