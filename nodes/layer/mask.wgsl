import chiaro::types;

/// Mask
///
/// Hides parts of a layer: wire it into the layer's Opacity. White shows the layer, black hides it,
/// as in a paint program; any number can be a mask, such as an image, a tone, or a vertex color.
///
/// @param mask "Mask" default=1 : Where the layer is shown: 0 nowhere, 1 fully.
/// @param opacity "Opacity" default=1 min=0 max=1 : The layer's opacity where the mask is white.
/// @param density "Density" default=1 min=0 max=1 : How much the mask hides; at 0 the layer is as
///   without it.
/// @param inverted "Invert" default=false : Black shows the layer, and white hides it.
/// @bound mask
/// @bound opacity
/// @bound density
/// @bypass opacity when density = 0 : its density is 0
/// @bypass opacity when mask = 1 and inverted = 0 : its mask is white
/// @bypass opacity when mask = 0 and inverted = 1 : its mask is black, inverted
/// @bypass 0 when opacity = 0 : its opacity is 0
/// @return opacity "Opacity" : For the Opacity of a layer.
/// @unit
fn mask(mask: f32, opacity: f32, density: f32, inverted: bool) -> f32 {
    let shown = select(mask, 1.0 - mask, inverted);
    return opacity * (1.0 - density * (1.0 - shown));
}
