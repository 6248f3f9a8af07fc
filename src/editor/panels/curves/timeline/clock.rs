//! Clock of the timeline: which frame of the range is shown at which time of the window.
//!
//! The clock counts steps of a round over the range. In real time a step lasts as long as a frame,
//! whether the frame is ready or not; playing every frame, the clock waits for the next one.

use crate::state::keying::retime::SAME_TIME;
use crate::tools::playback::order::{LoopMode, PlayOrder, Round};
use crate::tools::playback::{PlayPace, Transport, time_of};

/// Speeds, as factors of the frame rate.
pub(super) const SPEEDS: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 4.0];

/// Part of a frame within which a time counts as the frame's: fields round times to milliseconds.
const NEAR: f64 = 0.05;

/// Place of a running clock.
#[derive(Clone, Copy, Debug, PartialEq)]
struct RunningClock {
    /// Step of the round, with the part of it that has passed.
    step: f64,
    /// The window's clock at that moment, in seconds.
    then: f64,
}

/// Clock with the ways to play.
#[derive(Clone, Debug)]
pub(super) struct PlayClock {
    running: Option<RunningClock>,
    pub(super) mode: LoopMode,
    pub(super) pace: PlayPace,
    pub(super) speed: f64,
    /// Part of the range that is played, in seconds; the whole range without one.
    pub(super) part: Option<[f64; 2]>,
    /// True while a hand moves the playhead.
    pub(super) is_scrubbed: bool,
    /// Time that the clock asked for last, in seconds: another one was set by somebody else.
    asked: f64,
}

impl Default for PlayClock {
    fn default() -> Self {
        Self {
            running: None,
            mode: LoopMode::default(),
            pace: PlayPace::default(),
            speed: 1.0,
            part: None,
            is_scrubbed: false,
            asked: f64::NAN,
        }
    }
}

/// Wants of a moment of playing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ClockTick {
    /// Time of the playhead, in seconds.
    pub(super) time: Option<f64>,
    /// Seconds until the next frame is due; `None` where that depends on other things.
    pub(super) wait: Option<f64>,
    /// True if the range has been played to its end.
    pub(super) ends_round: bool,
}

impl PlayClock {
    pub(super) fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Frames that are played: those that begin within the range or the chosen part of it, the
    /// one at its end included.
    pub(super) fn round(&self, range: [f64; 2], fps: f64) -> Round {
        let [start, end] = self.part.unwrap_or(range);
        let first = (start * fps - NEAR).ceil() as i32;
        let last = (end * fps + NEAR).floor() as i32;
        Round::new([first, last.max(first)], self.mode)
    }

    /// Starts at the playhead, or stops; from the end of the range it starts anew.
    pub(super) fn toggle(&mut self, round: Round, frame: i32, now: f64) {
        let is_at_end = !round.has(frame) || frame == round.range()[1];
        let step = if is_at_end { 0.0 } else { f64::from(round.step_of(frame)) };
        self.running =
            if self.is_running() { None } else { Some(RunningClock { step, then: now }) };
        self.asked = f64::NAN;
    }

    pub(super) fn stop(&mut self) {
        self.running = None;
    }

    /// Goes on from another frame, if the clock runs.
    pub(super) fn go(&mut self, round: Round, frame: i32) {
        if let Some(running) = &mut self.running {
            running.step = f64::from(round.step_of(frame));
            self.asked = f64::NAN;
        }
    }

    /// Goes on to the moment `now`. `present` is the time of the playhead, in seconds; `is_ready`
    /// tells whether a frame can be shown.
    pub(super) fn tick(
        &mut self,
        round: Round,
        (fps, present): (f64, f64),
        now: f64,
        is_ready: impl Fn(i32) -> bool,
    ) -> ClockTick {
        let Some(RunningClock { step, then }) = self.running else { return ClockTick::default() };
        // Somebody else has moved the playhead.
        let moved = (self.asked - present).abs() > SAME_TIME;
        let step =
            if moved { f64::from(round.step_of((present * fps).round() as i32)) } else { step };
        let rate = fps * self.speed;
        let passed = (now - then).max(0.0) * rate;
        let length = f64::from(round.length());
        let mut next = step + passed;
        let mut waits_for_frame = false;
        if self.pace == PlayPace::EveryFrame {
            // One step at a time, and none before its frame is there.
            let whole = step.floor();
            let is_due = next >= whole + 1.0;
            let following = round.frame(((whole + 1.0) % length) as u32);
            waits_for_frame = is_due && !is_ready(following);
            next = match (is_due, waits_for_frame) {
                (false, _) => next,
                (true, true) => whole + 1.0 - 1e-9,
                (true, false) => (whole + 1.0).max((next - whole - 1.0).min(0.5) + whole + 1.0),
            };
        }
        let ends_round = next >= length;
        let is_over = ends_round && self.mode == LoopMode::Once;
        let next = if is_over { length - 1.0 } else { next.rem_euclid(length) };
        self.running = (!is_over).then_some(RunningClock { step: next, then: now });
        let time = time_of(round.frame(next.floor() as u32), fps);
        self.asked = time;
        let until = (next.floor() + 1.0 - next) / rate;
        let wait = (!is_over && !waits_for_frame).then(|| until.clamp(0.001, 1.0));
        ClockTick { time: Some(time), wait, ends_round }
    }

    /// The playhead and the range, as playback follows them.
    pub(super) fn transport(&self, round: Round, fps: f64, present: f64) -> Transport {
        let frame = (present * fps).round() as i32;
        let step = match self.running {
            Some(running) => running.step.floor() as u32 % round.length(),
            None => round.step_of(frame),
        };
        Transport {
            order: PlayOrder { round, step },
            fps,
            wanted_rate: fps * self.speed,
            pace: self.pace,
            is_playing: self.is_running(),
            is_scrubbed: self.is_scrubbed,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames of ticks `dt` seconds apart, the first at once, at 10 frames a second.
    fn played(
        clock: &mut PlayClock,
        dt: f64,
        count: u32,
        is_ready: impl Fn(i32) -> bool,
    ) -> Vec<i32> {
        let round = clock.round([0.2, 0.5], 10.0);
        let mut time = 0.2;
        clock.toggle(round, 2, 0.0);
        let frames = (0..count).map(|at| {
            let tick = clock.tick(round, (10.0, time), f64::from(at) * dt, &is_ready);
            time = tick.time.unwrap_or(time);
            (time * 10.0).round() as i32
        });
        frames.collect()
    }

    #[test]
    fn a_range_is_played_in_each_mode() {
        let mut clock = PlayClock::default();
        let at = |mode| PlayClock { mode, ..PlayClock::default() };
        assert_eq!(played(&mut clock, 0.1001, 6, |_| true), [2, 3, 4, 5, 2, 3]);
        let mut back = at(LoopMode::PingPong);
        assert_eq!(played(&mut back, 0.1001, 8, |_| true), [2, 3, 4, 5, 4, 3, 2, 3]);
        let mut once = at(LoopMode::Once);
        assert_eq!(played(&mut once, 0.1001, 6, |_| true), [2, 3, 4, 5, 5, 5]);
        assert!(!once.is_running());
        let mut twice = PlayClock { speed: 2.0, ..PlayClock::default() };
        assert_eq!(played(&mut twice, 0.1001, 4, |_| true), [2, 4, 2, 4]);
        let mut part = PlayClock { part: Some([0.3, 0.4]), ..PlayClock::default() };
        assert_eq!(played(&mut part, 0.1001, 4, |_| true), [3, 4, 3, 4]);
    }

    #[test]
    fn real_time_leaves_frames_out_and_the_other_pace_waits_for_each() {
        let mut late = PlayClock::default();
        assert_eq!(played(&mut late, 0.25, 3, |_| false), [2, 4, 3], "frames 2, 4.5 and 7 of 4");
        let mut every = PlayClock { pace: PlayPace::EveryFrame, ..PlayClock::default() };
        assert_eq!(played(&mut every, 0.25, 5, |_| true), [2, 3, 4, 5, 2]);
        assert_eq!(
            played(&mut PlayClock { running: None, ..every.clone() }, 0.25, 5, |f| f != 4),
            [2, 3, 3, 3, 3]
        );
        let mut quick = PlayClock { running: None, ..every };
        assert_eq!(played(&mut quick, 0.05, 5, |_| true), [2, 2, 3, 3, 4], "and never hurries");
    }

    #[test]
    fn a_playhead_that_is_moved_is_followed() {
        let mut clock = PlayClock::default();
        let round = clock.round([0.0, 1.0], 10.0);
        clock.toggle(round, 0, 0.0);
        assert_eq!(clock.tick(round, (10.0, 0.0), 0.0, |_| true).time, Some(0.0));
        let tick = clock.tick(round, (10.0, 0.5), 0.1001, |_| true);
        assert_eq!(tick.time, Some(0.6));
        assert!((tick.wait.unwrap() - 0.1).abs() < 1e-3);
        let end = clock.tick(round, (10.0, 0.6), 0.61, |_| true);
        assert!(end.ends_round, "{end:?}");
    }
}
