/// Combine vector
///
/// A vector from three numbers.
///
/// @param x "X" default=0 : The first.
/// @param y "Y" default=0 : The second.
/// @param z "Z" default=0 : The third.
/// @return vector "Vector" : (x, y, z).
fn combine_vector(x: f32, y: f32, z: f32) -> vec3f {
    return vec3f(x, y, z);
}
