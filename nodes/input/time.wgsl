/// Time
///
/// Seconds since the scene began: makes things move.
///
/// @param time from=time hidden
/// @return time "Time" unit=s : In seconds.
fn time(time: f32) -> f32 {
    return time;
}
