//! Commands to the timeline.

/// Command to the timeline, which is brought into view by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TimelineCommand {
    /// Plays the range, or pauses.
    Play,
    /// Moves the playhead to the first frame that is played.
    ToStart,
    /// Moves the playhead to the last frame that is played.
    ToEnd,
    /// Moves the playhead to the key before it.
    ToKeyBefore,
    /// Moves the playhead to the key after it.
    ToKeyAfter,
    /// Names the frame at the playhead.
    AddMarker,
    /// Does something else at the end of the range than before: begins again, stops, or goes back.
    ChangeEnd,
    /// Draws the frames of the range ahead.
    CacheRange,
    /// Keeps the frames, to compare later ones with.
    KeepVersion,
}
