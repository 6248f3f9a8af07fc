import chiaro::direction;

/// Shift direction
///
/// Moves a half-vector, and with it the highlight, along two axes; the same moves a light. A normal
/// that is moved takes the highlight the other way.
///
/// @param direction "Direction" from=normal : The half-vector, with the mesh's axes; or the normal,
///   with axes around the half-vector. Any length.
/// @param x_axis "X axis" from=tangent : Along u of the mesh, or from Axes around a direction.
/// @param y_axis "Y axis" from=bitangent : Along v of the mesh, or from Axes around a direction.
/// @param x "X" default=0 : How far along the first axis: 1 is an eighth of a turn.
/// @param y "Y" default=0 : How far along the second.
/// @return direction "Direction" : Unit.
/// @source Anjyo and Hiramitsu 2003, translation
fn shift_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    return direction_moved(direction_within(direction, x_axis, y_axis), vec2f(x, y));
}
