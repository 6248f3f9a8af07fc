//! Executors, which make the picture of a frame plan.

use std::pin::Pin;

use super::aovs::LayeredPicture;
use super::picture::Picture;
use super::plan::FramePlan;
use crate::diag::Diagnostic;
use crate::progress::Progress;

/// Future of a picture, or of the error that prevents it.
pub type PictureFuture<'a> = Pin<Box<dyn Future<Output = Result<Picture, Diagnostic>> + 'a>>;

/// Future of a picture with its layers, or of the error that prevents it.
pub type LayersFuture<'a> = Pin<Box<dyn Future<Output = Result<LayeredPicture, Diagnostic>> + 'a>>;

/// Share of a picture that was shaded for it, and not taken from the picture before.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ShadedShare {
    /// Number of objects of which any pixel was shaded.
    pub objects: usize,
    /// Number of all objects of the picture.
    pub of: usize,
    /// Share of the picture's pixels in which objects were shaded: 1 for all.
    pub pixels: f64,
}

/// Maker of the picture of a frame plan: a GPU, or the reference. All executors take the same plans
/// and give the same pictures, so that callers that only want a picture need not ask which one they
/// have.
pub trait Executor {
    /// Name of the executor for people: an adapter, or the reference.
    fn name(&self) -> String;

    /// Makes the picture of `plan`. `progress` counts the part that is done, and can stop the work.
    ///
    /// # Errors
    /// Where the plan cannot be drawn, and where the work was stopped.
    fn picture<'a>(&'a mut self, plan: &'a FramePlan, progress: &'a Progress) -> PictureFuture<'a>;

    /// Makes the picture of `plan` with the plan's [layers](FramePlan::aovs), in one draw.
    ///
    /// # Errors
    /// As [`picture`](Self::picture), and more layers than [`most_layers`](Self::most_layers).
    fn layered<'a>(&'a mut self, plan: &'a FramePlan, progress: &'a Progress) -> LayersFuture<'a>;

    /// The most layers beside the picture that one plan may have.
    fn most_layers(&self) -> usize;

    /// Keeps what was drawn of a picture from now on, if it can: pixels in which nothing changes
    /// are not shaded again in the next one. Every picture stays what it is, to the bit.
    fn keep_pixels(&mut self) {}

    /// The executor for further plans of the same picture, such as those of mattes, where this one
    /// keeps pixels that they would draw over.
    fn beside(&mut self) -> Option<&mut dyn Executor> {
        None
    }

    /// The share of the last picture that was shaded; `None` where that is not counted.
    fn shaded(&self) -> Option<ShadedShare> {
        None
    }

    /// Warnings about parts of a plan that will not be drawn as asked for.
    fn warnings(&self, _plan: &FramePlan) -> Vec<Diagnostic> {
        Vec::new()
    }
}
