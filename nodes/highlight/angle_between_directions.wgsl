import chiaro::types;
import chiaro::numeric;
import chiaro::angle;

/// Angle between directions
///
/// The angle that a Profile turns into a tone, between any two directions: a bent half-vector and
/// the normal, a hair's tangent and a light.
///
/// @param a "A" default=0,0,1 : Any length; without a direction it is +z.
/// @param b "B" from=normal : The same.
/// @return angle "Angle" : From 0 (the same direction) to pi.
fn angle_between_directions(a: vec3f, b: vec3f) -> Angle {
    let z = vec3f(0.0, 0.0, 1.0);
    return angle_between(normalize_or(a, z), normalize_or(b, z));
}
