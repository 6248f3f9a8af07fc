import chiaro::numerics;

/// Half
///
/// Half of it.
///
/// @param x "Value" default=0 : A number.
fn half(x: f32) -> f32 {
    return 0.5 * x;
}
