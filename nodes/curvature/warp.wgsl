/// Curvature warp
///
/// How far curvature moves the angle that a profile sees: convex parts by plus, concave parts by
/// minus the amount.
///
/// @param convexity "Convexity" default=0.5 min=0 max=1 : From a Curvature transition.
/// @param amount "Amount" unit=rad default=0 min=-pi max=pi : The shape offset t.
/// @return shift "Warp" unit=rad : For a Profile's warp input.
/// @bypass 0 when amount = 0 : its amount is 0
/// @bypass 0 when convexity = 0.5 : the surface counts as flat everywhere
/// @source BADF eq. 8
fn warp(convexity: f32, amount: f32) -> f32 {
    return (2.0 * convexity - 1.0) * clamp(amount, -3.14159265358979324, 3.14159265358979324);
}
