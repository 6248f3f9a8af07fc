//! Clock of the program: the one place that asks the system for the time.

use std::time::{Duration, Instant, SystemTime};

/// Stopwatch.
#[derive(Clone, Copy, Debug)]
pub struct Clock(Instant);

impl Clock {
    /// Starts the stopwatch.
    #[expect(clippy::disallowed_methods, reason = "the one place that asks the clock")]
    pub fn start() -> Self {
        Self(Instant::now())
    }

    /// Time since the start, in seconds.
    pub fn seconds(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}

/// Time since a moment; zero for moments in the future.
#[expect(clippy::disallowed_methods, reason = "the one place that asks the clock")]
pub fn age(of: SystemTime) -> Duration {
    SystemTime::now().duration_since(of).unwrap_or_default()
}
