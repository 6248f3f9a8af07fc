/// Half
///
/// Half of it.
///
/// @param x "Value" default=0 min=none : A number.
fn half(x: f32) -> f32 {
    return 0.5 * x;
}
