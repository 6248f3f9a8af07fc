import chiaro::filter;

/// Combine filters
///
/// One share of two: both filters in a row, both openings together, one taken from the other, or
/// the darker or brighter of both.
///
/// @choice mode "Mode" default=multiply multiply="Multiply" add="Add" subtract="Subtract"
///   minimum="Minimum" maximum="Maximum" : Multiply has one behind the other; Subtract leaves what
///   passes A and not B.
/// @param a "A" default=1 min=0 max=1 : What passes the one.
/// @param b "B" default=1 min=0 max=1 : What passes the other.
/// @return share "Share" : How much of the light passes, from 0 to 1.
/// @unit
fn combine_filters_multiply(a: f32, b: f32) -> f32 {
    return share_kept(a) * share_kept(b);
}

fn combine_filters_add(a: f32, b: f32) -> f32 {
    return min(share_kept(a) + share_kept(b), 1.0);
}

fn combine_filters_subtract(a: f32, b: f32) -> f32 {
    return max(share_kept(a) - share_kept(b), 0.0);
}

fn combine_filters_minimum(a: f32, b: f32) -> f32 {
    return min(share_kept(a), share_kept(b));
}

fn combine_filters_maximum(a: f32, b: f32) -> f32 {
    return max(share_kept(a), share_kept(b));
}
