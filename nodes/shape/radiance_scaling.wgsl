import chiaro::total;
import chiaro::curvature;
import chiaro::shape;

/// Scale by curvature
///
/// Makes a tone lighter where the surface bulges and darker where it is hollow, and the other way
/// around where it is very light: any shading shows its shape more plainly.
///
/// @param tone "Tone" default=0.5 min=0 max=1 : From a Profile, or any other.
/// @param kappa "Curvature" from=kappa : In 1/viewport-height, convex positive.
/// @param amount "Amount" default=1 min=0 max=4 : How much; below 0 hollows become lighter.
/// @param slope "Slope" default=0.05 min=0 max=1 : How soon the surface counts as curved.
/// @param turning "Turning point" default=0.8 min=0 max=1 : This tone stays, lighter ones go the
///   other way around.
/// @return tone "Tone" : From 0 to 1.
/// @unit
/// @bypass tone when amount = 0 : its amount is 0
/// @bypass tone when slope = 0 : its slope is 0, so that nothing counts as curved
/// @error fast 0.1 : tone, where the surface is smooth, of triangles of a pixel or so; large
///   triangles and creases show, and no pass is needed
/// @source Vergne et al. 2010
fn radiance_scaling(tone: f32, kappa: f32, amount: f32, slope: f32, turning: f32) -> f32 {
    let curved = clamp(bounded(amount), -16.0, 16.0) * curvature_signed(kappa, slope);
    let at = clamp(bounded(turning), 0.001, 0.999);
    let before = clamp(bounded(tone), 0.0, 1.0);
    return clamp(select(radiance_scaled(before, curved, at), before, curved == 0.0), 0.0, 1.0);
}
