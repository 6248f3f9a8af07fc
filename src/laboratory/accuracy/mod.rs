//! Accuracy and its cost in time: the same frame plan on the GPU and in f64, with error and cost
//! side by side.
//!
//! [`bench()`] measures a look in its parts: the whole look in each tier, each of its nodes in each
//! tier against the same look without that node, and each pass. Times are measured in turns and
//! reported with their confidence interval (see [`cost`]); errors are distances from the
//! reference's picture (see [`error`]). Everything that is measured is a [`variant`] of one setup,
//! so that no two rows can differ by more than what they name.

pub mod bench;
pub mod cost;
pub mod error;
pub mod measure;
pub mod plot;
pub mod report;
pub mod size;
pub mod truth;
pub mod tune;
pub mod variant;
pub mod viewpoint;

use crate::diag::Diagnostic;
use crate::progress::Interruption;
use crate::render::RenderError;

pub use bench::{BenchOptions, MeasuredNodes, bench};
pub use cost::{Series, TimeEstimate};
pub use error::{ErrorFigures, PremultipliedPicture, compare};
pub use measure::Measure;
pub use report::{BenchReport, MeasuredTier, MeasurementRow, MeasurementSubject};
pub use truth::Truth;
pub use variant::Variant;

/// Reason why a measurement has no result.
#[derive(Debug)]
pub enum MeasureError {
    /// The caller stopped the measurement.
    Stopped,
    /// The setup could not be compiled or drawn.
    Problems(Vec<Diagnostic>),
}

impl From<Interruption> for MeasureError {
    fn from(_: Interruption) -> Self {
        Self::Stopped
    }
}

impl From<RenderError> for MeasureError {
    fn from(error: RenderError) -> Self {
        Self::Problems(vec![error.into()])
    }
}

impl From<Diagnostic> for MeasureError {
    fn from(problem: Diagnostic) -> Self {
        vec![problem].into()
    }
}

impl From<Vec<Diagnostic>> for MeasureError {
    fn from(problems: Vec<Diagnostic>) -> Self {
        if Interruption::is_among(&problems) { Self::Stopped } else { Self::Problems(problems) }
    }
}

impl From<MeasureError> for Vec<Diagnostic> {
    fn from(error: MeasureError) -> Self {
        match error {
            MeasureError::Stopped => Interruption.into(),
            MeasureError::Problems(problems) => problems,
        }
    }
}
