/// Position
///
/// Where the surface is. World is the scene's space, Object sticks to the object as it moves,
/// Camera is measured from the eye: x to the right, y up, z toward the viewer.
///
/// @choice space "Space" default=world world="World" object="Object" camera="Camera" : What the
///   position is measured from.
/// @param position from=position hidden
/// @param position_object from=position_object hidden
/// @param position_camera from=position_camera hidden
/// @return position "Position" : In scene units, or the object's own in object space.
fn position_world(position: vec3f) -> vec3f {
    return position;
}

fn position_object(position_object: vec3f) -> vec3f {
    return position_object;
}

fn position_camera(position_camera: vec3f) -> vec3f {
    return position_camera;
}
