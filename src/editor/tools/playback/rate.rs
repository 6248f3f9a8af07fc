//! Rate at which frames are really shown.

use std::collections::VecDeque;

/// Time over which frames are counted, in seconds.
const SPAN: f64 = 2.0;

/// Number of times that are kept however old they are, so that a slow rate is told.
const LEAST: usize = 4;

/// Times at which another frame came on the screen, of the last seconds.
#[derive(Debug, Default)]
pub(super) struct ShownRate {
    times: VecDeque<f64>,
}

impl ShownRate {
    /// Notes a frame that is shown from `now` on, in seconds of the window's clock.
    pub(super) fn shown(&mut self, now: f64) {
        self.times.push_back(now);
        let is_old = |first: &f64| now - first > SPAN;
        while self.times.len() > LEAST && self.times.front().is_some_and(is_old) {
            self.times.pop_front();
        }
    }

    /// Forgets all times, as nothing plays.
    pub(super) fn rest(&mut self) {
        self.times.clear();
    }

    /// Frames a second; `None` before there are enough to tell. A frame that stays on the screen
    /// longer than others counts as it does.
    pub(super) fn per_second(&self, now: f64) -> Option<f64> {
        let (first, last) = (self.times.front()?, self.times.back()?);
        let frames = (self.times.len() - 1) as f64;
        let mean = (last - first) / frames.max(1.0);
        let span = (last - first).max(now - first - mean);
        (frames >= 3.0 && span > 0.0).then(|| frames / span)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rate_is_that_of_the_frames_shown() {
        let mut rate = ShownRate::default();
        assert_eq!(rate.per_second(0.0), None);
        (0..48).for_each(|frame| rate.shown(f64::from(frame) / 24.0));
        let told = rate.per_second(47.0 / 24.0).unwrap();
        assert!((told - 24.0).abs() < 1e-6, "{told}");
        // As nothing new comes the rate falls.
        let later = rate.per_second(47.0 / 24.0 + 2.0).unwrap();
        assert!((11.0..13.0).contains(&later), "{later}");
        (0..6).for_each(|frame| rate.shown(10.0 + 3.0 * f64::from(frame)));
        let slow = rate.per_second(25.0).unwrap();
        assert!((slow - 1.0 / 3.0).abs() < 1e-6, "{slow}");
        rate.rest();
        assert_eq!(rate.per_second(5.0), None);
    }
}
