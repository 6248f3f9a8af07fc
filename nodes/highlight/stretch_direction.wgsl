import chiaro::direction;

/// Stretch direction
///
/// Makes a highlight longer along an axis (above 0) or shorter (below 0): streaks of silk, hair and
/// brushed metal.
///
/// @param direction "Direction" from=normal : The half-vector, with the mesh's axes; or the normal,
///   with axes around the half-vector. Any length.
/// @param x_axis "X axis" from=tangent : Along u of the mesh, or from Axes around a direction.
/// @param y_axis "Y axis" from=bitangent : Along v of the mesh, or from Axes around a direction.
/// @param x "X" default=0 max=1 : How much longer along the first axis; 1 has no end.
/// @param y "Y" default=0 max=1 : How much longer along the second.
/// @return direction "Direction" : Unit.
/// @source Anjyo and Hiramitsu 2003, directional scaling
fn stretch_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    return direction_moved(bent, -min(vec2f(x, y), vec2f(1.0)) * bent.place);
}
