import chiaro::types;
import chiaro::curve;
import chiaro::total;
import chiaro::antialias;

/// Curve
///
/// Turns a number into another along a curve that you draw: a tone's response, a profile of your
/// own. Before the first point and after the last one it is flat; the steps of a stepped curve are
/// antialiased.
///
/// @param value "Value" default=0 : Where on the curve, from left to right.
/// @param curve "Curve" : Its points, at most 16.
/// @return value "Value" : The curve's height there.
/// @source Fritsch and Butland 1984
fn curve(value: f32, curve: Curve) -> f32 {
    let w = footprint_of(value);
    return curve_at(curve, bounded(value), w);
}
