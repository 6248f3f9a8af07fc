import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::angle;
import chiaro::direction;

/// Polar place
///
/// Where a direction lies around another one: how far, and in which direction around. A Curve over
/// the second and Scale angle on the first draw highlights of any star-like shape.
///
/// @param direction "Direction" from=normal : What is placed; any length.
/// @param middle "Middle" default=0,0,1 : Around what: toward the light.
/// @param x_axis "X axis" default=1,0,0 : Where around is 0; from Axes around a direction.
/// @param y_axis "Y axis" default=0,1,0 : Where around is a quarter.
fn polar_place(direction: vec3f, middle: vec3f, x_axis: vec3f, y_axis: vec3f) -> PolarPlace {
    let bent = direction_within(direction, x_axis, y_axis);
    let u = angle_between(bent.direction, normalize_or(middle, vec3f(0.0, 0.0, 1.0)));
    let turn = angle_of_point(bent.place.y, bent.place.x) / (2.0 * PI);
    return PolarPlace(u, select(turn, turn + 1.0, turn < 0.0));
}

struct PolarPlace {
    /// From 0 in the middle to pi.
    angle: Angle,
    /// In turns, from 0 to 1.
    around: f32,
}
