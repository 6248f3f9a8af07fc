import chiaro::numeric;

/// Normalize
///
/// A vector's direction alone: its length becomes 1. A vector without length, or one too long to
/// measure, becomes 0.
///
/// @param vector "Vector" default=0,0,1 : Any vector.
/// @return direction "Direction" : Unit, or 0.
fn normalize_vector(vector: vec3f) -> vec3f {
    return normalize_or(vector, vec3f(0.0));
}
