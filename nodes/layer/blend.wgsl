import chiaro::types;
import chiaro::blend;
import chiaro::color;

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
///
/// @param below "Below" wire : The stack of layers below.
/// @param color "Color" default=1,1,1,1 : The layer's color, straight; its alpha is the layer's
///   opacity.
/// @param tone "Tone" default=1 : Where the layer is: 0 nowhere, 1 fully.
/// @choice mode "Mode" default=add add="Add" multiply="Multiply" subtract="Subtract" alpha="Alpha"
///   shade="Shade" screen="Screen" overlay="Overlay" darken="Darken" lighten="Lighten"
///   soft_light="Soft light" hard_light="Hard light" color_dodge="Color dodge"
///   color_burn="Color burn" difference="Difference" exclusion="Exclusion" hue="Hue"
///   saturation="Saturation" color="Color" luminosity="Luminosity" : Add brightens; Multiply keeps
///   only what the tone lights (black where the tone is 0); Subtract darkens; Alpha covers; Shade
///   multiplies within the tone and leaves the rest, as painters expect of a shadow layer. From
///   Screen on they are those of paint programs, within the tone; where nothing is below, the
///   layer covers. Color dodge, Color burn and the last four count colors as from 0 to 1.
/// @param opacity "Opacity" default=1 min=0 max=1 : 0 leaves what is below as it is, in every mode.
///   It counts from 0 to 1, as does the color's alpha, and, but for Add, Multiply and Subtract, the
///   tone.
/// @param clamped "Clamp" default=true : Keeps the stack, which is premultiplied, within 0 and 1
///   after this layer.
/// @return below "Stack" : The stack with this layer on top.
/// @bypass below when opacity = 0 : its opacity is 0
/// @bypass below when tone = 0 and mode != multiply and below = unit : its tone is 0
/// @bypass below when tone = 0 and mode != multiply and clamped = 0 : its tone is 0
/// @bypass below when color = black and mode = add|subtract and below = unit : its color is black
/// @bypass below when color = black and mode = add|subtract and clamped = 0 : its color is black
/// @bound opacity
/// @bound color
/// @bound tone when mode != add|multiply|subtract
/// @unit when clamped = 1
/// @source BADF eq. 2, W3C Compositing and Blending 1
fn blend_add(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool) -> Composite {
    return blend_finish(below, below.xyz + tone * color.xyz, below.w, opacity * color.w, clamped);
}

fn blend_multiply(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_finish(below, below.xyz * (tone * color.xyz), below.w, opacity * color.w, clamped);
}

fn blend_subtract(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_finish(below, below.xyz - tone * color.xyz, below.w, opacity * color.w, clamped);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    let a = opacity * color.w;
    let alpha = below.w + tone * a * (1.0 - below.w);
    return blend_finish(below, below.xyz + tone * (color.xyz - below.xyz), alpha, a, clamped);
}

fn blend_shade(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_finish(below, below.xyz * mix(vec3f(1.0), color.xyz, tone), below.w,
        opacity * color.w, clamped);
}

fn blend_screen(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, screened(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_overlay(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, hard_lit(color.xyz, color_below(below)),
        tone, opacity, clamped);
}

fn blend_darken(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, min(color_below(below), color.xyz), tone, opacity, clamped);
}

fn blend_lighten(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, max(color_below(below), color.xyz), tone, opacity, clamped);
}

fn blend_soft_light(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, soft_lit(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_hard_light(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, hard_lit(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_color_dodge(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, dodged_by(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_color_burn(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, burned_by(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_difference(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, abs(color_below(below) - color.xyz),
        tone, opacity, clamped);
}

fn blend_exclusion(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, excluded(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_hue(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, hued(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_saturation(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, saturated(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_color(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, tinted(color_below(below), color.xyz),
        tone, opacity, clamped);
}

fn blend_luminosity(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_painted(below, color, tinted(color.xyz, color_below(below)),
        tone, opacity, clamped);
}
