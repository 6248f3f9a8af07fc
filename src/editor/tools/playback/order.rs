//! Order in which the frames of a range are played.

use chiaro_locale::tr;

/// Behavior at the end of the range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum LoopMode {
    /// Begins again at the first frame.
    #[default]
    Loop,
    /// Stops on the last frame.
    Once,
    /// Goes back to the first frame, and forth again; both ends are shown once.
    PingPong,
}

impl LoopMode {
    pub(crate) const ALL: [Self; 3] = [Self::Loop, Self::Once, Self::PingPong];

    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Loop => tr!("Loop"),
            Self::Once => tr!("Once"),
            Self::PingPong => tr!("Back and forth"),
        }
    }

    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Loop => tr!("Begins again at the end of the range"),
            Self::Once => tr!("Stops on the last frame of the range"),
            Self::PingPong => tr!("Plays backward from the end of the range, and forward again"),
        }
    }
}

/// One round over a range of frames: a sequence of steps, each a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Round {
    /// First and last frame; the last is not before the first.
    first: i32,
    last: i32,
    mode: LoopMode,
}

impl Round {
    /// Round over the frames between two, both included, in whichever order they are given.
    pub(crate) fn new([a, b]: [i32; 2], mode: LoopMode) -> Self {
        Self { first: a.min(b), last: a.max(b), mode }
    }

    /// First and last frame.
    pub(crate) fn range(self) -> [i32; 2] {
        [self.first, self.last]
    }

    /// Number of frames.
    pub(crate) fn count(self) -> u32 {
        self.last.abs_diff(self.first).saturating_add(1)
    }

    pub(crate) fn has(self, frame: i32) -> bool {
        (self.first..=self.last).contains(&frame)
    }

    /// Number of steps.
    pub(crate) fn length(self) -> u32 {
        match self.mode {
            LoopMode::PingPong if self.count() > 1 => self.count().saturating_mul(2) - 2,
            _ => self.count(),
        }
    }

    /// Frame of a step; steps beyond the end begin anew.
    pub(crate) fn frame(self, step: u32) -> i32 {
        let step = step % self.length();
        let count = self.count();
        let from_first = if step < count { step } else { self.length() - step };
        self.first.saturating_add_unsigned(from_first)
    }

    /// Step at which a frame is shown for the first time; that of the nearest frame for one that
    /// is not in the range.
    pub(crate) fn step_of(self, frame: i32) -> u32 {
        frame.clamp(self.first, self.last).abs_diff(self.first)
    }

    /// Number of steps from `step` until a frame is shown; `None` for a frame of no step.
    pub(crate) fn distance(self, step: u32, frame: i32) -> Option<u32> {
        if !self.has(frame) {
            return None;
        }
        let length = self.length();
        let until = |at: u32| (at + length - step % length) % length;
        let there = self.step_of(frame);
        Some(match self.mode {
            LoopMode::PingPong => until(there).min(until((length - there) % length)),
            LoopMode::Loop | LoopMode::Once => until(there),
        })
    }
}

/// Place within a round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PlayOrder {
    pub(crate) round: Round,
    pub(crate) step: u32,
}

impl PlayOrder {
    /// Frame that is shown now.
    pub(crate) fn frame(self) -> i32 {
        self.round.frame(self.step)
    }

    /// Steps until a frame is shown; those outside the round come last of all.
    pub(crate) fn distance(self, frame: i32) -> u32 {
        self.round.distance(self.step, frame).unwrap_or(u32::MAX)
    }

    /// Frames from now on, each step once.
    pub(crate) fn upcoming(self) -> impl Iterator<Item = i32> {
        let length = self.round.length();
        let step = self.step % length;
        (0..length).map(move |ahead| self.round.frame(step.wrapping_add(ahead) % length))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(mode: LoopMode) -> Vec<i32> {
        let round = Round::new([3, 6], mode);
        (0..round.length()).map(|step| round.frame(step)).collect()
    }

    #[test]
    fn rounds_have_their_frames_in_order() {
        assert_eq!(frames(LoopMode::Loop), [3, 4, 5, 6]);
        assert_eq!(frames(LoopMode::Once), [3, 4, 5, 6]);
        assert_eq!(frames(LoopMode::PingPong), [3, 4, 5, 6, 5, 4], "each end is shown once");
        let single = Round::new([7, 7], LoopMode::PingPong);
        assert_eq!((single.length(), single.frame(5)), (1, 7));
        assert_eq!(Round::new([6, 3], LoopMode::Loop).range(), [3, 6]);
        assert_eq!(Round::new([i32::MIN, i32::MAX], LoopMode::Loop).count(), u32::MAX);
    }

    #[test]
    fn what_was_just_shown_is_farthest() {
        let at = |mode, step| PlayOrder { round: Round::new([0, 4], mode), step };
        let distances = |order: PlayOrder| (0..5).map(|frame| order.distance(frame)).collect();
        let all: [Vec<u32>; 3] = [
            distances(at(LoopMode::Loop, 2)),
            distances(at(LoopMode::PingPong, 2)),
            // On the way back from the end.
            distances(at(LoopMode::PingPong, 6)),
        ];
        assert_eq!(all[0], [3, 4, 0, 1, 2]);
        assert_eq!(all[1], [6, 5, 0, 1, 2]);
        assert_eq!(all[2], [2, 1, 0, 5, 6]);
        assert_eq!(at(LoopMode::Loop, 0).distance(9), u32::MAX);
        let order = at(LoopMode::PingPong, 3);
        let shown: Vec<i32> = order.upcoming().collect();
        assert_eq!(shown, [3, 4, 3, 2, 1, 0, 1, 2]);
        for frame in 0..5 {
            let first = shown.iter().position(|shown| *shown == frame).unwrap();
            assert_eq!(order.distance(frame), first as u32, "{frame}");
        }
    }
}
