/// UV
///
/// The mesh's texture coordinates: u to the right, v up.
///
/// @param uv from=uv hidden
/// @return uv "UV" : 0 to 1 across the picture; more where the mesh repeats it.
fn uv(uv: vec2f) -> vec2f {
    return uv;
}
