//! What the program reached when, for who measures how it starts.
//!
//! Where the environment variable `CHIARO_MILESTONES` is set, each milestone is a line of JSON on
//! standard error, the first time that it is reached: `{"milestone":"library","seconds":0.0312}`,
//! in seconds since the program began. Elsewhere telling one costs a look at a flag. `cargo bench
//! --bench editor -- startup` reads them.

use std::collections::BTreeSet;
use std::io::Write as _;
use std::sync::{LazyLock, Mutex, PoisonError};

use crate::clock::Clock;

/// The environment variable that asks for them.
pub const VARIABLE: &str = "CHIARO_MILESTONES";

struct Teller {
    since_start: Clock,
    told: Mutex<BTreeSet<&'static str>>,
}

static TELLER: LazyLock<Option<Teller>> = LazyLock::new(|| {
    let is_wanted = std::env::var_os(VARIABLE).is_some_and(|value| !value.is_empty());
    is_wanted.then(|| Teller { since_start: Clock::start(), told: Mutex::default() })
});

/// Whether anybody wants to know.
pub fn are_told() -> bool {
    TELLER.is_some()
}

/// Tells that the program came this far; the first one told begins to count. Later times of the
/// same one are not told.
pub fn reached(milestone: &'static str) {
    let Some(teller) = &*TELLER else { return };
    let seconds = teller.since_start.seconds();
    if teller.told.lock().unwrap_or_else(PoisonError::into_inner).insert(milestone) {
        let line = serde_json::json!({ "milestone": milestone, "seconds": seconds });
        // Nobody listens any more: then it need not be told.
        let _ = writeln!(std::io::stderr(), "{line}");
    }
}
