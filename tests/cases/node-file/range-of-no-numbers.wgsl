/// Half
///
/// Half of it.
///
/// @param x "Value" default=2 range=0..1 : A number.
fn half(x: f32) -> f32 {
    return 0.5 * x;
}
