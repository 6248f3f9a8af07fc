//! Range and rate of a document that was opened.

use std::mem;

use super::Timeline;
use crate::commands::Command;
use crate::document::TimeRange;
use crate::state::session::Session;

/// Part of a frame within which the playhead counts as on the frame.
const NEAR: f64 = 0.05;

impl Timeline {
    /// Takes frames and rate of the open shot whenever the document has others, be it by an edit,
    /// by undo or by another program. The playhead stays on its frame where the rate changes.
    pub(super) fn follow(&mut self, session: &Session) -> Option<Command> {
        let shot = session.shot();
        let of_shot = shot.map(|shot| (shot.path().to_path_buf(), shot.scene().time));
        if self.of_shot == of_shot {
            return None;
        }
        let before = mem::replace(&mut self.of_shot, of_shot);
        let (path, range) = self.of_shot.clone()?;
        self.play_range(range);
        let (_, old) = before.filter(|(file, old)| *file == path && old.fps != range.fps)?;
        let frame = session.view.time * old.fps;
        let is_on_frame = (frame - frame.round()).abs() < NEAR;
        is_on_frame.then(|| {
            Command::SetTime(shot.map_or(0.0, |shot| shot.rate().time_within(frame.round())))
        })
    }

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
