import chiaro::antialias;
import chiaro::total;

/// Threshold
///
/// 0 below an edge, 1 from the edge on, antialiased by its own width on the screen: cuts a hard
/// shape out of anything smooth. Where the value does not change on the screen the edge is hard,
/// and the edge itself is 1.
///
/// @param value "Value" default=0 : What is cut.
/// @param edge "Edge" default=0.5 : From here on the result is 1.
/// @param softness "Softness" default=0 min=0 max=1 : How wide the edge is in the value; 0 is as
///   sharp as can be.
/// @return mask "Mask" : 0 or 1, between them on the edge.
/// @unit
/// @error balanced 0.15 : mask on the edge's pixels, where edges on diagonals are a little soft; 0
///   elsewhere
/// @error fast 0.51 : mask on the edge's pixels, which are not antialiased; 0 elsewhere
/// @source Decaudin 1996, cartoon-looking rendering
fn threshold(value: f32, edge: f32, softness: f32) -> f32 {
    let w = footprint_of(value);
    return step_filtered(bounded(value), bounded(edge), edge_width(w, softness));
}

fn threshold_balanced(value: f32, edge: f32, softness: f32) -> f32 {
    let x = bounded(value);
    return step_quick(x, bounded(edge), edge_width(footprint_by_sum(x), softness));
}

fn threshold_fast(value: f32, edge: f32, softness: f32) -> f32 {
    return step_quick(bounded(value), bounded(edge), edge_width(0.0, softness));
}
