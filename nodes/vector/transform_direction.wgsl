import chiaro::total;

/// Transform direction
///
/// The same direction, told in other axes: the world's or the camera's (x to the right, y up, z
/// toward the viewer).
///
/// @choice spaces "Spaces" default=camera_of_world camera_of_world="World to camera"
///   world_of_camera="Camera to world" : From which axes to which.
/// @param direction "Direction" from=normal : Any direction; its length stays.
/// @param camera_from_world from=camera_from_world hidden
/// @return direction "Direction" : In the other axes.
fn transform_direction_camera_of_world(direction: vec3f, camera_from_world: mat3x3f) -> vec3f {
    return bounded_vec3(camera_from_world * bounded_vec3(direction));
}

fn transform_direction_world_of_camera(direction: vec3f, camera_from_world: mat3x3f) -> vec3f {
    return bounded_vec3(transpose(camera_from_world) * bounded_vec3(direction));
}
