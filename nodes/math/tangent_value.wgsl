import chiaro::total;

/// Tangent
///
/// The slope of an angle. Near a quarter turn, where it has no end, it stops at 10 million.
///
/// @param angle "Angle" unit=rad default=0 : Any angle.
/// @return tangent "Tangent" : Sine over cosine, within 10 million.
fn tangent_value(angle: f32) -> f32 {
    let wave = sin_cos_of(angle);
    return wave.x / select(min(wave.y, -1e-7), max(wave.y, 1e-7), wave.y >= 0.0);
}
