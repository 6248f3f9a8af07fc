import chiaro::total;

/// Arccosine
///
/// The angle whose cosine this is.
///
/// @param value "Value" default=1 min=-1 max=1 : Beyond -1 and 1 counts as -1 and 1.
/// @return angle "Angle" unit=rad : From 0 to pi.
fn arccosine(value: f32) -> f32 {
    let x = clamp(bounded(value), -1.0, 1.0);
    return 2.0 * angle_of_point(sqrt(1.0 - x), sqrt(1.0 + x));
}
