import chiaro::total;

/// Arctangent
///
/// The angle of the slope y/x; with both wired, the direction of the point (x, y) around the
/// origin, where it is 0.
///
/// @param y "Y" default=0 : Up.
/// @param x "X" default=1 : To the right.
/// @return angle "Angle" unit=rad : From -pi to pi, counter-clockwise from the x axis.
fn arctangent(y: f32, x: f32) -> f32 {
    return angle_of_point(y, x);
}
