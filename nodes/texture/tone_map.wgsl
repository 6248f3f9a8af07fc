import chiaro::types;
import chiaro::total;

/// Tone map
///
/// A tone ramp with a second dimension, painted as a picture: the tone goes from left (dark) to
/// right (light), the detail from below (none) up. Detail by distance makes far things flatter, by
/// focus it guides the eye, by a highlight's tone it turns plastic into metal.
///
/// @param image "Image" widget=path : PNG, JPEG, HDR or EXR.
/// @param tone "Tone" default=0.5 min=0 max=1 : From a Profile.
/// @param detail "Detail" default=1 min=0 max=1 : From Detail, or any number.
/// @choice filter "Filter" default=linear linear="Linear" nearest="Nearest" :
///   Linear is smooth; Nearest keeps the picture's hard edges.
/// @choice encoding "Encoding" default=color color="Color" data="Data" :
///   Color for what is seen; Data takes numbers as they are.
/// @return color "Color" : Straight RGBA.
/// @source Barla et al. 2006
fn tone_map(image: texture_2d<f32>, image_sampler: sampler, tone: f32, detail: f32) -> Color {
    let place = vec2f(factor_of(tone, true), 1.0 - factor_of(detail, true));
    return textureSample(image, image_sampler, place);
}
