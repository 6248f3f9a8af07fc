import chiaro::direction;

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
///
/// @param direction "Direction" default=0,0,1 : Any length; without one it is +z.
/// @param up "Up" default=0,1,0 : Where the second axis points as far as it can.
fn axes(direction: vec3f, up: vec3f) -> AxesAround {
    let axes = axes_around(direction, up);
    return AxesAround(axes[0], axes[1]);
}

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    x_axis: vec3f,
    /// Unit, upright.
    y_axis: vec3f,
}
