import chiaro::direction;

/// Split direction
///
/// Cuts a highlight in two along an axis and moves the halves apart, or in four along both: window
/// panes in an eye.
///
/// @param direction "Direction" from=normal : The half-vector, with the mesh's axes; or the normal,
///   with axes around the half-vector. Any length.
/// @param x_axis "X axis" from=tangent : Along u of the mesh, or from Axes around a direction.
/// @param y_axis "Y axis" from=bitangent : Along v of the mesh, or from Axes around a direction.
/// @param x "X" default=0.2 min=0 : How far apart along the first axis.
/// @param y "Y" default=0 min=0 : How far apart along the second.
/// @return direction "Direction" : Unit; it jumps where the highlight is cut.
/// @source Anjyo and Hiramitsu 2003, split
fn split_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    let side = select(vec2f(-1.0), vec2f(1.0), bent.place >= vec2f(0.0));
    return direction_moved(bent, -max(vec2f(x, y), vec2f(0.0)) * side);
}
