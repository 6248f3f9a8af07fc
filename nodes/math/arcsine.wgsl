import chiaro::total;

/// Arcsine
///
/// The angle whose sine this is.
///
/// @param value "Value" default=0 min=-1 max=1 : Beyond -1 and 1 counts as -1 and 1.
/// @return angle "Angle" unit=rad : From -pi/2 to pi/2.
fn arcsine(value: f32) -> f32 {
    let x = clamp(bounded(value), -1.0, 1.0);
    return angle_of_point(x, sqrt((1.0 - x) * (1.0 + x)));
}
