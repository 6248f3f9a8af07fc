import chiaro::surface;

/// Tangent frame
///
/// Three directions at right angles that go along with the mesh's texture coordinates: brushed
/// metal, hair and other streaks follow the tangent.
///
/// @param tangent from=tangent hidden
/// @param bitangent from=bitangent hidden
/// @param normal "Normal" from=normal : The direction that the frame stands on, world space.
fn tangent_frame(tangent: vec3f, bitangent: vec3f, normal: vec3f) -> TangentFrame {
    let frame = world_from_tangent(tangent, bitangent, normal);
    return TangentFrame(frame[0], frame[1], frame[2]);
}

struct TangentFrame {
    /// Unit, along u, world space.
    tangent: vec3f,
    /// Unit, along v, world space.
    bitangent: vec3f,
    /// Unit, the normal that the frame stands on.
    normal: vec3f,
}
