/// Normal
///
/// The surface's normal in world space, toward the side that is seen.
///
/// @param normal from=normal hidden
/// @return normal "Normal" : Unit.
fn normal(normal: vec3f) -> vec3f {
    return normal;
}
