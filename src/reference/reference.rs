//! The reference as an executor of frame plans.

use super::executor::execute;
use super::modules::Modules;
use super::options::ReferenceOptions;
use crate::frame::{Executor, FramePlan, PictureFuture};
use crate::interp::Precision;
use crate::progress::Progress;

/// Executor on the CPU, in f64; see [`execute`] for results beyond the picture.
#[derive(Clone, Debug, Default)]
pub struct Reference {
    /// Options of the pictures.
    pub options: ReferenceOptions,
}

impl Executor for Reference {
    fn name(&self) -> String {
        "the reference, in f64".to_owned()
    }

    fn picture<'a>(&'a mut self, plan: &'a FramePlan, progress: &'a Progress) -> PictureFuture<'a> {
        Box::pin(async move {
            let modules = Modules::new(plan, Precision::F64)?;
            Ok(execute(plan, &modules, &self.options, progress)?.to_picture())
        })
    }
}
