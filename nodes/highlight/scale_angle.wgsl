import chiaro::types;
import chiaro::angle;
import chiaro::total;

/// Scale angle
///
/// Multiplies an angle before a Profile sees it: above 1 what the profile draws becomes smaller,
/// below 1 larger.
///
/// @param angle "Angle" wire : From a Parametrization or Polar place.
/// @param factor "Factor" default=1 min=0 : By how much; below 0 counts as 0.
/// @return angle "Angle" : Up to pi.
/// @bypass angle when factor = 1 : its factor is 1
fn scale_angle(angle: Angle, factor: f32) -> Angle {
    if factor == 1.0 {
        return angle;
    }
    return angle_of(bounded(angle_radians(angle) * max(bounded(factor), 0.0)));
}
