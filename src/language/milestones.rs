//! Milestones of the program's start and the times at which they were reached, for measurements.
//!
//! Where the environment variable `CHIARO_MILESTONES` is set, each milestone is a line of JSON on
//! standard error, the first time that it is reached: `{"milestone":"library","seconds":0.0312}`,
//! in seconds since the program began. Elsewhere a milestone costs a look at a flag. `cargo bench
//! --bench editor -- startup` reads the lines.

use std::collections::BTreeSet;
use std::io::Write as _;
use std::sync::{LazyLock, Mutex, PoisonError};

use crate::clock::Clock;

/// Environment variable that asks for milestones.
pub const VARIABLE: &str = "CHIARO_MILESTONES";

struct Reporter {
    since_start: Clock,
    reported: Mutex<BTreeSet<&'static str>>,
}

/// Reporter of milestones; `None` where they are not asked for.
static REPORTER: LazyLock<Option<Reporter>> = LazyLock::new(|| {
    let is_wanted = std::env::var_os(VARIABLE).is_some_and(|value| !value.is_empty());
    is_wanted.then(|| Reporter { since_start: Clock::start(), reported: Mutex::default() })
});

/// True if milestones are reported.
pub fn is_enabled() -> bool {
    REPORTER.is_some()
}

/// Reports that the program reached a milestone; the first one reported starts the clock. Only the
/// first time of each milestone is reported.
pub fn reached(milestone: &'static str) {
    let Some(reporter) = &*REPORTER else { return };
    let seconds = reporter.since_start.seconds();
    if reporter.reported.lock().unwrap_or_else(PoisonError::into_inner).insert(milestone) {
        let line = serde_json::json!({ "milestone": milestone, "seconds": seconds });
        // A write fails where nobody listens any more, and is then not needed.
        let _ = writeln!(std::io::stderr(), "{line}");
    }
}
