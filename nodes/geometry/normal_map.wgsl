import chiaro::types;
import chiaro::surface;

/// Normal map
///
/// Adds detail to the normal from a tangent-space normal map. Wire an Image whose encoding is Data.
///
/// @param color "Color" default=0.5,0.5,1,1 : The map's color here; (0.5, 0.5, 1) leaves the
///   normal as it is.
/// @param strength "Strength" default=1 min=0 max=4 : 0 leaves the normal as it is, 1 is as
///   painted.
/// @choice green "Green" default=up up="Up (OpenGL)" down="Down (DirectX)" : Which way the map's
///   green channel points.
/// @param normal "Normal" from=normal : The normal to add to, world space.
/// @param tangent from=tangent hidden
/// @param bitangent from=bitangent hidden
/// @return normal "Normal" : World space, unit.
/// @bypass normal when strength = 0 : its strength is 0
fn normal_map_up(color: Color, strength: f32, normal: vec3f, tangent: vec3f,
    bitangent: vec3f) -> vec3f {
    return mapped_normal(2.0 * color.xyz - 1.0, strength, normal, tangent, bitangent);
}

fn normal_map_down(color: Color, strength: f32, normal: vec3f, tangent: vec3f,
    bitangent: vec3f) -> vec3f {
    let vector = (2.0 * color.xyz - 1.0) * vec3f(1.0, -1.0, 1.0);
    return mapped_normal(vector, strength, normal, tangent, bitangent);
}
