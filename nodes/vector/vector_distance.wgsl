import chiaro::total;

/// Distance
///
/// How far two points are apart: makes spheres of influence, fog and falloffs.
///
/// @param a "A" default=0,0,0 : The one point.
/// @param b "B" default=0,0,0 : The other point.
/// @return distance "Distance" : 0 or more.
fn vector_distance(a: vec3f, b: vec3f) -> f32 {
    return length_of(bounded_vec3(b) - bounded_vec3(a));
}
