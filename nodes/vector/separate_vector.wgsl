/// Separate vector
///
/// The three numbers of a vector.
///
/// @param vector "Vector" default=0,0,0 : What is taken apart.
fn separate_vector(vector: vec3f) -> VectorParts {
    return VectorParts(vector.x, vector.y, vector.z);
}

struct VectorParts {
    /// The first number.
    x: f32,
    /// The second number.
    y: f32,
    /// The third number.
    z: f32,
}
