//! Sweeps: the largest distance of every node from the truth, over all its inputs.
//!
//! [`Case::of`] lists the ways of using a node: choices, widths, tiers. A [`NodeBench`] is a look
//! with the node alone, every number of it fed from a slot; a [`Laboratory`] runs the bench on the
//! GPU and in f64, with the same f32-rounded inputs, spread evenly over the documented ranges and
//! concentrated at the edges of arithmetic. For nodes where rounding of the input itself decides,
//! [`bounds`] says so, and the result is compared with all true results within four units in the
//! last place. [`search`] climbs from the worst samples to worse ones and keeps them.

use chiaro_compiler::{compile, document, library};
use chiaro_files as files;
use chiaro_laboratory::accuracy;
use chiaro_language::{diag, ids, interp, progress, wgsl};
use chiaro_reference as reference;
use chiaro_render as render;
use chiaro_scene::{frame, hcbtf};

pub mod bounds;
pub mod case;
pub mod looks;
pub mod measure;
mod pictures;
pub mod plot;
pub mod random;
pub mod report;
pub mod search;
pub mod slot;
pub mod stability;
pub mod survey;

pub use bounds::{ErrorMetric, bound, judging};
pub use case::{Case, NodeBench};
pub use looks::{LookBound, LookEffort, LookFigures, looks_in, measure_look};
pub use measure::{CaseFigures, Effort, Finding, Laboratory};
pub use report::AccuracyReport;
pub use search::{WorstInput, climb};
pub use stability::{StabilityEffort, StabilityFigures, measure_stability};
pub use survey::{Survey, SurveyPart, survey};
