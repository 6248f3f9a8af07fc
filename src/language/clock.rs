//! The one place that asks the clock.

use std::time::{Duration, Instant, SystemTime};

/// How long something took.
#[derive(Clone, Copy, Debug)]
pub struct Clock(Instant);

impl Clock {
    /// Begins to measure.
    #[expect(clippy::disallowed_methods, reason = "the one place that asks the clock")]
    pub fn start() -> Self {
        Self(Instant::now())
    }

    /// Since the start.
    pub fn seconds(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}

/// How long ago something was; nothing for what lies in the future.
#[expect(clippy::disallowed_methods, reason = "the one place that asks the clock")]
pub fn age(of: SystemTime) -> Duration {
    SystemTime::now().duration_since(of).unwrap_or_default()
}
