//! What accuracy costs in time: the same frame plan on the GPU and in f64, with error and cost side
//! by side.
//!
//! [`bench()`] takes a look apart: the whole of it in each tier, each of its nodes in each tier
//! against the same look without that node, and each pass. Times are measured in turns and told
//! with their confidence interval (see [`cost`]); errors are distances from the reference's picture
//! (see [`error`]). Everything that is measured is a [`variant`] of one setup, so that no two rows
//! can differ by more than what they name.

pub mod bench;
pub mod cost;
pub mod error;
pub mod measure;
pub mod plot;
pub mod report;
pub mod size;
pub mod station;
pub mod sweep;
pub mod truth;
pub mod tune;
pub mod variant;

use crate::diag::Diagnostic;
use crate::render::RenderError;

pub use bench::{BenchOptions, MeasuredNodes, bench};
pub use cost::{Estimate, Series};
pub use error::{Colors, ErrorFigures, compare};
pub use measure::Measure;
pub use report::{Report, Row, Subject};
pub use truth::Truth;
pub use variant::Variant;

/// How far long work has come, and whether it goes on.
pub struct Progress<'a> {
    done: u64,
    total: u64,
    told: &'a mut dyn FnMut(u64, u64) -> bool,
}

impl<'a> Progress<'a> {
    /// Tells `told` how many steps are done of how many; it says whether to go on.
    pub fn new(told: &'a mut dyn FnMut(u64, u64) -> bool) -> Self {
        Self { done: 0, total: 0, told }
    }

    /// More work was found.
    pub fn expect(&mut self, steps: u64) {
        self.total += steps;
    }

    /// A step is done.
    ///
    /// # Errors
    /// That it was stopped.
    pub fn step(&mut self) -> Result<(), Stopped> {
        self.done += 1;
        self.total = self.total.max(self.done);
        if (self.told)(self.done, self.total) { Ok(()) } else { Err(Stopped::Asked) }
    }
}

impl std::fmt::Debug for Progress<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} of {}", self.done, self.total)
    }
}

/// Why a measurement has no result.
#[derive(Debug)]
pub enum Stopped {
    /// It was asked to stop.
    Asked,
    /// What was measured could not be made or drawn.
    Problems(Vec<Diagnostic>),
}

impl From<RenderError> for Stopped {
    fn from(error: RenderError) -> Self {
        Self::Problems(vec![error.into()])
    }
}

impl From<Vec<Diagnostic>> for Stopped {
    fn from(problems: Vec<Diagnostic>) -> Self {
        Self::Problems(problems)
    }
}

impl From<Stopped> for Vec<Diagnostic> {
    fn from(stopped: Stopped) -> Self {
        match stopped {
            Stopped::Asked => {
                vec![Diagnostic::error("stopped", "it was stopped before it was done")]
            }
            Stopped::Problems(problems) => problems,
        }
    }
}
