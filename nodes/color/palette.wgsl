import chiaro::types;
import chiaro::color;
import chiaro::total;
import chiaro::curve;

/// Palette
///
/// Brings colors into a palette, as a printer's or a game's: the nearest one to the eye, several
/// blended where they are about as near, or one by its number.
///
/// @choice by "By" default=nearest nearest="Nearest" blended="Blended" number="Number" : Nearest
///   and Blended judge by Oklab, as eyes do; Number counts the stops from 0 and begins again after
///   the last.
/// @param color "Color" default=0.5,0.5,0.5,1 : As on screen; its alpha stays.
/// @param number "Number" default=0 min=0 max=15 : Which one.
/// @param softness "Softness" default=0.05 min=0 max=0.5 : Blended: how much farther than the
///   nearest one a color may be and still be seen, in Oklab; black and white are 1 apart.
/// @param palette "Palette" : Its colors are the stops', wherever they are; at most 16.
/// @return color "Color" : Straight RGBA, as on screen.
/// @source Ottosson 2020
fn palette_nearest(color: Color, palette: Ramp) -> Color {
    return vec4f(palette_blend(palette, bounded_vec3(color.xyz), 0.0), bounded(color.w));
}

fn palette_blended(color: Color, softness: f32, palette: Ramp) -> Color {
    return vec4f(palette_blend(palette, bounded_vec3(color.xyz),
        clamp(bounded(softness), 0.0, 4.0)), bounded(color.w));
}

fn palette_number(number: i32, palette: Ramp) -> Color {
    let count = i32(min(palette.count, 16u));
    if count == 0 {
        return vec4f(0.0);
    }
    var colors = palette.colors;
    let turned = number % count;
    return bounded_vec4(colors[select(turned, turned + count, turned < 0)]);
}
