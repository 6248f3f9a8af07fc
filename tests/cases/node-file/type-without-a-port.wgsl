/// Half
///
/// Half of it.
///
/// @param x "Value" : A matrix.
fn half(x: mat3x3f) -> f32 {
    return x[0][0];
}
