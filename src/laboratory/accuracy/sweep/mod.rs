//! How far every node can be from the truth, whatever it is fed.
//!
//! [`Case::of`] lists the ways of using a node: choices, widths, tiers. A [`Bench`] is a look with
//! the node alone, every number of it fed by hand; a [`Lab`] runs it on the GPU and in f64, with
//! the same f32-rounded inputs, spread evenly over what is documented and heaped at the edges of
//! arithmetic. Where rounding of the input itself decides, [`bounds`] says so, and the result is
//! held against all that is true within four units in the last place. [`search`] climbs from the
//! worst samples to worse ones and keeps them.

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

pub use bounds::{Judging, bound, judging};
pub use case::{Bench, Case};
pub use looks::{LookBound, LookEffort, LookFigures, looks_in, measure_look};
pub use measure::{CaseFigures, Effort, Finding, Lab};
pub use report::AccuracyReport;
pub use search::{Worst, climb};
pub use stability::{StabilityEffort, StabilityFigures, measure_stability};
pub use survey::{Survey, survey};
