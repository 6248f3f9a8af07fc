import chiaro::total;

/// Combine tones
///
/// Cuts, joins and crosses shapes of light, as one does with shapes in a drawing program.
///
/// @choice operation "Operation" default=union union="Union" intersection="Intersection"
///   difference="Difference" exclusion="Exclusion" : Union is where either is, Intersection where
///   both are, Difference where A is and B is not, Exclusion where exactly one is.
/// @param a "A" default=0 min=0 max=1 : A tone or a mask.
/// @param b "B" default=0 min=0 max=1 : Another one.
/// @return tone "Tone" : From 0 to 1.
/// @unit
/// @source Anjyo and Hiramitsu 2003, boolean operators
fn combine_tones_union(a: f32, b: f32) -> f32 {
    return max(factor_of(a, true), factor_of(b, true));
}

fn combine_tones_intersection(a: f32, b: f32) -> f32 {
    return min(factor_of(a, true), factor_of(b, true));
}

fn combine_tones_difference(a: f32, b: f32) -> f32 {
    return min(factor_of(a, true), 1.0 - factor_of(b, true));
}

fn combine_tones_exclusion(a: f32, b: f32) -> f32 {
    return abs(factor_of(a, true) - factor_of(b, true));
}
