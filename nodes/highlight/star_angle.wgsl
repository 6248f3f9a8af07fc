import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::angle;
import chiaro::direction;

/// Star
///
/// The angle between two directions, measured so that a Profile draws a star, a flower or a polygon
/// instead of a disk: in between its rays the angle counts for more.
///
/// @param direction "Direction" from=normal : What is held against the star's middle: the normal,
///   where that is a half-vector, or the mirrored view, where it is a light.
/// @param middle "Middle" default=0,0,1 : Where the angle is 0: toward the light.
/// @param x_axis "X axis" default=1,0,0 : Toward the first ray; from Axes around a direction.
/// @param y_axis "Y axis" default=0,1,0 : A quarter turn on.
/// @param rays "Rays" default=4 min=2 max=64 : How many.
/// @param inner "Inner radius" default=0.35 min=0.01 max=1 : How far it reaches between two rays,
///   of how far at a ray.
/// @param round "Roundness" default=0 min=0 max=1 : 1 is a disk.
/// @param turn "Turn" unit=rad default=0 : How far the star is turned, from x to y.
/// @return angle "Angle" : Up to pi.
/// @source Pacanowski et al. 2008
fn star_angle(
    direction: vec3f,
    middle: vec3f,
    x_axis: vec3f,
    y_axis: vec3f,
    rays: i32,
    inner: f32,
    round: f32,
    turn: f32,
) -> Angle {
    let z = vec3f(0.0, 0.0, 1.0);
    let bent = direction_within(direction, x_axis, y_axis);
    let u = angle_between(bent.direction, normalize_or(middle, z));
    let around = (angle_of_point(bent.place.y, bent.place.x) - clamp(bounded(turn), -1e4, 1e4))
        / (2.0 * PI);
    let reach = star_reach(around, f32(clamp(rays, 2, 64)), clamp(inner, 0.01, 1.0),
        clamp(round, 0.0, 1.0));
    return angle_of(angle_radians(u) / reach);
}
