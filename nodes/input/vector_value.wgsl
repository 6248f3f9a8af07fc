/// Vector
///
/// Three numbers to wire to several places, or to expose as a parameter of the look.
///
/// @param vector "Vector" default=0,0,0 : x, y and z.
/// @return vector "Vector" : The same.
fn vector_value(vector: vec3f) -> vec3f {
    return vector;
}
