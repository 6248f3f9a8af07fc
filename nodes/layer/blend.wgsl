import chiaro::types;
import chiaro::blend;

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
///
/// @param below "Below" wire : The stack of layers below.
/// @param color "Color" default=1,1,1,1 : The layer's color, straight; its alpha is the layer's
///   opacity.
/// @param tone "Tone" default=1 : Where the layer is: 0 nowhere, 1 fully.
/// @choice mode "Mode" default=add add="Add" multiply="Multiply" subtract="Subtract" alpha="Alpha"
///   shade="Shade" : Add brightens; Multiply keeps only what the tone lights (black where the tone
///   is 0); Subtract darkens; Alpha covers; Shade multiplies within the tone and leaves the rest,
///   as painters expect of a shadow layer.
/// @param opacity "Opacity" default=1 min=0 max=1 : 0 leaves what is below as it is, in every mode.
///   It counts from 0 to 1, as does the color's alpha, and the tone where the mode is Alpha or
///   Shade.
/// @param clamped "Clamp" default=true : Keeps the stack, which is premultiplied, within 0 and 1
///   after this layer.
/// @return below "Stack" : The stack with this layer on top.
/// @bypass below when opacity = 0 : its opacity is 0
/// @bypass below when tone = 0 and mode = add|subtract|alpha|shade and below = unit : its tone is 0
/// @bypass below when tone = 0 and mode = add|subtract|alpha|shade and clamped = 0 : its tone is 0
/// @bypass below when color = black and mode = add|subtract and below = unit : its color is black
/// @bypass below when color = black and mode = add|subtract and clamped = 0 : its color is black
/// @bound opacity
/// @bound color
/// @bound tone when mode = alpha|shade
/// @unit when clamped = 1
/// @source BADF eq. 2
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
