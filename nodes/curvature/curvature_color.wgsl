import chiaro::types;

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
///
/// @param convexity "Convexity" default=0.5 min=0 max=1 : From a Curvature transition.
/// @param convex "Convex" default=1,1,1,1 : Straight RGBA, where the surface bulges.
/// @param concave "Concave" same=convex : Straight RGBA, where the surface is hollow; while unset,
///   the convex color, so that there is one color everywhere.
/// @return color "Color" : Between the two, component by component (D7).
/// @bound convexity
/// @bound convex
/// @bound concave
/// @unit alpha
/// @bypass convex when convex = concave : both colors are the same
/// @source BADF eq. 7
fn curvature_color(convexity: f32, convex: Color, concave: Color) -> Color {
    return concave + convexity * (convex - concave);
}
