//! Whoever makes the picture of a frame plan.

use std::pin::Pin;

use super::picture::Picture;
use super::plan::FramePlan;
use crate::diag::Diagnostic;
use crate::progress::Progress;

/// A picture under way, or why there is none.
pub type PictureFuture<'a> = Pin<Box<dyn Future<Output = Result<Picture, Diagnostic>> + 'a>>;

/// Whoever makes the picture of a frame plan: a GPU, or the reference. They take the same plans and
/// give the same pictures, so that nobody who only wants a picture asks which one it is.
pub trait Executor {
    /// Who draws, for people: an adapter, or the reference.
    fn name(&self) -> String;

    /// The picture of `plan`. `progress` counts how far it is, and stops it.
    ///
    /// # Errors
    /// What cannot be drawn, and that it was stopped.
    fn picture<'a>(&'a mut self, plan: &'a FramePlan, progress: &'a Progress) -> PictureFuture<'a>;

    /// What of a plan will not be drawn as it was asked for.
    fn warnings(&self, plan: &FramePlan) -> Vec<Diagnostic> {
        let _ = plan;
        Vec::new()
    }
}
