//! Range and rate of a document that was opened.

use super::Timeline;
use crate::document::TimeRange;

impl Timeline {
    /// Plays a range of times from now on, at its rate, and brings the range into view.
    pub(crate) fn play_range(&mut self, range: TimeRange) {
        let TimeRange { start, end, fps } = range;
        let end = end.max(start + 1.0 / fps.max(1e-3));
        if (self.range, self.fps) != ([start, end], fps) {
            let margin = 0.05 * (end - start);
            (self.range, self.fps) = ([start, end], fps);
            self.seen = [start - margin, end + 2.0 * margin];
        }
    }
}
