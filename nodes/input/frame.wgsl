/// Frame
///
/// Frames since the start of the scene's time range. Rounded down by steps, it animates on twos or
/// threes.
///
/// @param frame from=frame hidden
/// @return frame "Frame" : From 0.
fn frame(frame: f32) -> f32 {
    return frame;
}
