import chiaro::total;

/// Length
///
/// How long a vector is.
///
/// @param vector "Vector" default=0,0,0 : Any vector.
/// @return length "Length" : 0 or more.
fn vector_length(vector: vec3f) -> f32 {
    return length_of(vector);
}
