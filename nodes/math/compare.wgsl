import chiaro::total;

/// Compare
///
/// 1 where a comparison holds, 0 elsewhere, without antialiasing: for counters, ids and switches.
/// For edges that are seen, take Threshold.
///
/// @choice test "Test" default=less less="A < B" greater="A > B" equal="A = B" :
///   Exactly one of the three holds.
/// @param a "A" default=0 : The one.
/// @param b "B" default=0 : The other.
/// @param epsilon "Tolerance" default=0 min=0 : How far apart A and B may be and still count as
///   equal.
/// @return result "Result" : 0 or 1.
/// @unit
fn compare_less(a: f32, b: f32, epsilon: f32) -> f32 {
    return select(0.0, 1.0, bounded(bounded(a) - bounded(b)) < -abs(bounded(epsilon)));
}

fn compare_greater(a: f32, b: f32, epsilon: f32) -> f32 {
    return select(0.0, 1.0, bounded(bounded(a) - bounded(b)) > abs(bounded(epsilon)));
}

fn compare_equal(a: f32, b: f32, epsilon: f32) -> f32 {
    return select(0.0, 1.0, abs(bounded(bounded(a) - bounded(b))) <= abs(bounded(epsilon)));
}
