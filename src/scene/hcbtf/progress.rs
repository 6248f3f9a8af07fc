//! How far long work has come, seen and stopped from another thread.

use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// How far work has come, and whether it is still wanted. Whoever watches and whoever works share
/// one.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    total: AtomicU64,
    is_stopped: AtomicBool,
    told: Option<Told>,
}

/// Who is told of every step, from the thread that made it.
struct Told(Box<dyn Fn([u64; 2]) + Send + Sync>);

impl fmt::Debug for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Told")
    }
}

impl Progress {
    /// Nothing is done yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Nothing is done yet; `tell` is told of every step that is, and of how many there are, from
    /// whatever thread made it.
    pub fn telling(tell: impl Fn([u64; 2]) + Send + Sync + 'static) -> Self {
        Self { told: Some(Told(Box::new(tell))), ..Self::default() }
    }

    /// The work is not wanted any more; it ends soon after.
    pub fn stop(&self) {
        self.is_stopped.store(true, Ordering::Relaxed);
    }

    /// Whether somebody said [`Self::stop`].
    pub fn is_stopped(&self) -> bool {
        self.is_stopped.load(Ordering::Relaxed)
    }

    /// What [`Self::stop`] sets, for work that looks at a flag.
    pub fn stop_flag(&self) -> &AtomicBool {
        &self.is_stopped
    }

    /// Steps that are done, and how many there will be as far as is known: 0 before the work is
    /// laid out.
    pub fn steps(&self) -> [u64; 2] {
        [self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed)]
    }

    /// The share that is done, from 0 to 1.
    pub fn share(&self) -> f64 {
        let [done, total] = self.steps();
        if total == 0 { 0.0 } else { (done as f64 / total as f64).min(1.0) }
    }

    /// The work is laid out.
    pub fn begin(&self, total: u64) {
        self.done.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    /// More steps are done.
    pub fn add(&self, steps: u64) {
        self.done.fetch_add(steps, Ordering::Relaxed);
        if let Some(Told(tell)) = &self.told {
            tell(self.steps());
        }
    }
}
