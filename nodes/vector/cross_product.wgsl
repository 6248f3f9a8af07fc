import chiaro::total;

/// Cross product
///
/// A vector at right angles to two others, by the right-hand rule. Where these are parallel it is
/// 0.
///
/// @param a "A" default=1,0,0 : The one.
/// @param b "B" default=0,1,0 : The other.
/// @return cross "Cross product" : As long as the area between both.
fn cross_product(a: vec3f, b: vec3f) -> vec3f {
    return bounded_vec3(cross(bounded_vec3(a), bounded_vec3(b)));
}
