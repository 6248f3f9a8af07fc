import chiaro::curvature;

/// Curvature
///
/// How much the surface bulges (above 0) or is hollow (below 0), as it is seen. It is measured
/// against the picture's height, so that detail comes forward as the camera does.
///
/// @choice source "Source" default=surface surface="Surface" detail="Detail" : Surface sees the
///   mesh alone; Detail sees the normal that the Output is given, with its normal and bump maps.
/// @param kappa from=kappa hidden
/// @param kappa_detail from=kappa_detail hidden
/// @error balanced 0.06 : of the curvature itself, where the surface is smooth; the pass looks at
///   four neighbors in place of twelve, so that creases and the noise of scans come out sharper
/// @error fast 0.1 : of the curvature itself, for the surface where it is smooth, of triangles of a
///   pixel or so, and not seen edge-on; large triangles and creases show, and no pass is needed;
///   for details the same as balanced
/// @return kappa "Curvature" : In 1/viewport-height, convex positive, within 10,000.
/// @source Kindlmann et al. 2003, curvature in transfer functions; BADF 3.3
fn kappa_surface(kappa: f32) -> f32 {
    return kappa_safe(kappa);
}

fn kappa_detail(kappa_detail: f32) -> f32 {
    return kappa_safe(kappa_detail);
}
