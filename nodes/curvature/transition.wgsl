import chiaro::curvature;

/// Curvature transition
///
/// From concave (0) over flat (0.5) to convex (1), as softly or sharply as you choose. (The BADF
/// paper writes it lambda = 0.5 + 0.5 tanh(slope * kappa), with kappa for the curvature.)
///
/// @param kappa "Curvature" from=kappa : In 1/viewport-height, convex positive.
/// @param slope "Slope" default=0.05 : How fast flat becomes convex; 0 is 0.5 everywhere.
/// @return convexity "Convexity" : From 0 (concave) to 1 (convex).
/// @unit
/// @bypass 0.5 when slope = 0 : its slope is 0, which is flat everywhere
/// @error balanced 5e-7 : convexity
/// @error fast 7e-4 : convexity
/// @source BADF eq. 7
fn transition(kappa: f32, slope: f32) -> f32 {
    return 0.5 + 0.5 * curvature_signed(kappa, slope);
}

fn transition_balanced(kappa: f32, slope: f32) -> f32 {
    return 0.5 + 0.5 * curvature_signed_balanced(kappa, slope);
}

fn transition_fast(kappa: f32, slope: f32) -> f32 {
    return 0.5 + 0.5 * curvature_signed_fast(kappa, slope);
}
