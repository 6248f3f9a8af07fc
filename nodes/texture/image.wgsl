import chiaro::types;
import chiaro::total;

/// Image
///
/// A picture laid on the surface by its texture coordinates.
///
/// @param image "Image" widget=path : PNG, JPEG, HDR or EXR; `mesh:base_color` is that of the
///   mesh's own material, and so are `mesh:normal`, `mesh:occlusion`, `mesh:emissive` and
///   `mesh:metallic_roughness`.
/// @param uv "UV" from=uv : Where in the picture; u to the right, v up.
/// @param scale "Scale" default=1,1 : How often the picture repeats; negative numbers mirror it.
/// @param offset "Offset" default=0,0 : Moves the picture, in pictures.
/// @choice wrap "Wrap" default=repeat repeat="Repeat" clamp="Clamp" mirror="Mirror" : What is
///   beyond the picture's edges.
/// @choice filter "Filter" default=linear linear="Linear" nearest="Nearest" :
///   Linear is smooth; Nearest keeps the squares of pixel art.
/// @choice encoding "Encoding" default=color color="Color" data="Data" : Color for what is seen;
///   Data for normal maps, heights and masks, whose numbers are taken as they are.
fn image(image: texture_2d<f32>, image_sampler: sampler, uv: vec2f, scale: vec2f,
    offset: vec2f) -> ImageSample {
    let place = bounded_vec2(uv * scale + offset);
    let color = textureSample(image, image_sampler, vec2f(place.x, 1.0 - place.y));
    return ImageSample(color, color.w);
}

struct ImageSample {
    /// Straight RGBA.
    color: Color,
    /// The picture's alpha; 1 where it has none.
    alpha: f32,
}
