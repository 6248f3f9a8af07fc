/// Depth
///
/// How far the surface lies in front of the eye, along the viewing axis: for fog and for line
/// weights that fade away. Map range brings it between 0 and 1.
///
/// @param depth from=depth hidden
/// @return depth "Depth" : In scene units.
fn depth(depth: f32) -> f32 {
    return depth;
}
