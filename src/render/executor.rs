//! The renderer as an executor of frame plans.

use crate::diag::Diagnostic;
use crate::frame::{Executor, FramePlan, LayersFuture, PictureFuture, ShadedShare};
use crate::progress::Progress;
use crate::{Gpu, Renderer};

impl Gpu {
    /// An executor on this device, for callers that only want pictures.
    pub fn executor(&self) -> Box<dyn Executor + Send> {
        Box::new(Renderer::new(self.clone()))
    }
}

impl Executor for Renderer {
    fn name(&self) -> String {
        self.gpu().name()
    }

    fn picture<'a>(&'a mut self, plan: &'a FramePlan, progress: &'a Progress) -> PictureFuture<'a> {
        Box::pin(async move {
            // A frame is one submission: it can be stopped before it begins, but not within.
            progress.begin(1);
            progress.check()?;
            let picture = Self::picture(self, plan).await?;
            progress.add(1);
            Ok(picture)
        })
    }

    fn layered<'a>(&'a mut self, plan: &'a FramePlan, progress: &'a Progress) -> LayersFuture<'a> {
        Box::pin(async move {
            progress.begin(1);
            progress.check()?;
            let picture = Self::layered(self, plan).await?;
            progress.add(1);
            Ok(picture)
        })
    }

    fn most_layers(&self) -> usize {
        self.gpu().most_layers()
    }

    fn keep_pixels(&mut self) {
        Self::keep_pixels(self);
    }

    fn beside(&mut self) -> Option<&mut dyn Executor> {
        self.beside_pixels().map(|renderer| renderer as &mut dyn Executor)
    }

    fn shaded(&self) -> Option<ShadedShare> {
        Self::shaded(self)
    }

    fn warnings(&self, plan: &FramePlan) -> Vec<Diagnostic> {
        self.gpu().warnings(plan)
    }
}
