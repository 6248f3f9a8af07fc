/// Half
///
/// Half of it.
///
/// @param x "Value" default=0 : A number.
fn half(x: f32) -> f32 {
    return vec2f(x);
}
