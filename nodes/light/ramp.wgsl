import chiaro::types;
import chiaro::curve;
import chiaro::total;
import chiaro::antialias;

/// Color ramp
///
/// Turns a number into a colour along a ramp: a tone into paint. Before the first stop and after the last one the
/// colour stays; the edges of a stepped ramp are antialiased.
///
/// @param value "Value" default=0 : Where on the ramp; a tone goes from 0 to 1.
/// @param ramp "Ramp" : Its colours, at most 16.
/// @return color "Color" : Straight RGBA.
fn ramp(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    return ramp_at(ramp, bounded(value), w);
}
