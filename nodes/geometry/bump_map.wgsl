import chiaro::surface;
import chiaro::total;

/// Bump map
///
/// Bends the normal as if the surface were raised by a height: from a picture, a noise or anything
/// else. It needs no texture coordinates.
///
/// @param height "Height" default=0 : How far the surface is raised here.
/// @param scale "Scale" default=0.1 : What a height of 1 is in scene units; below 0 it is pressed
///   in.
/// @param normal "Normal" from=normal : The normal to bend, world space.
/// @param position from=position hidden
/// @return normal "Normal" : World space, unit; slopes steeper than 84 degrees count as 84.
/// @bypass normal when scale = 0 : its scale is 0
/// @source Mikkelsen 2010
fn bump_map(height: f32, scale: f32, normal: vec3f, position: vec3f) -> vec3f {
    let raised = bounded(height * scale);
    let along_x = vec4f(dpdx(position), dpdx(raised));
    let along_y = vec4f(dpdy(position), dpdy(raised));
    return select(bumped_normal(along_x, along_y, normal), bounded_vec3(normal), scale == 0.0);
}
