import chiaro::numeric;
import chiaro::total;

/// Rotate vector
///
/// Turns a vector about an axis, counter-clockwise as the axis points at you.
///
/// @param vector "Vector" default=0,0,0 : What is turned.
/// @param axis "Axis" default=0,1,0 : Any length; without one, nothing turns.
/// @param angle "Angle" unit=rad default=0 : How far.
/// @return vector "Vector" : As long as before.
/// @bypass vector when angle = 0 : its angle is 0
/// @source Anjyo and Hiramitsu 2003, where it turns a highlight
fn rotate_vector(vector: vec3f, axis: vec3f, angle: f32) -> vec3f {
    let v = bounded_vec3(vector);
    let k = normalize_or(axis, vec3f(0.0));
    let half = sin_cos_of(0.5 * bounded(angle));
    let aside = cross(k, v);
    // By the half-angle, so that a small turn does not cancel.
    return bounded_vec3(v + 2.0 * half.x * (half.y * aside + half.x * cross(k, aside)));
}
