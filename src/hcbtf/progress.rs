//! How far long work has come, seen and stopped from another thread.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// How far work has come, and whether it is still wanted. Whoever watches and whoever works share one.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    total: AtomicU64,
    is_stopped: AtomicBool,
}

impl Progress {
    /// Nothing is done yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// The work is not wanted any more; it ends soon after.
    pub fn stop(&self) {
        self.is_stopped.store(true, Ordering::Relaxed);
    }

    /// Whether somebody said [`Self::stop`].
    pub fn is_stopped(&self) -> bool {
        self.is_stopped.load(Ordering::Relaxed)
    }

    /// Steps that are done, and how many there will be as far as is known: 0 before the work is laid out.
    pub fn steps(&self) -> [u64; 2] {
        [self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed)]
    }

    /// The share that is done, from 0 to 1.
    pub fn share(&self) -> f64 {
        let [done, total] = self.steps();
        if total == 0 { 0.0 } else { (done as f64 / total as f64).min(1.0) }
    }

    /// The work is laid out.
    pub(super) fn begin(&self, total: u64) {
        self.done.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    /// More steps are done.
    pub(super) fn add(&self, steps: u64) {
        self.done.fetch_add(steps, Ordering::Relaxed);
    }
}
