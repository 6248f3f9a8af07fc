//! Pixels that stay from one picture to the next: the samples of the last picture are kept, and the
//! next one shades only the areas in which an input of some look changed.
//!
//! What is kept lies where it was drawn, so that it takes no memory beside the picture's own; it is
//! forgotten with the targets, and after every error. Only where a frame has further plans, of
//! mattes or of more layers than one draw writes, a second renderer draws these. In an area that
//! changes, all objects that have pixels there are drawn again, in their order, from what a cleared
//! picture begins with: depths that tie, what may be seen through, and passes over the picture need
//! no rule of their own, and the picture is, to the bit, the one that is drawn whole.

use std::collections::HashSet;

use crate::Renderer;
use crate::frame::{FramePlan, LookInputs, PixelArea, ShadedShare};
use crate::passes::BlankPipeline;

/// Side of the blocks of pixels in which areas begin and end: software Vulkan finds other last
/// digits of depths in the blocks that a scissor rectangle cuts.
pub(crate) const BLOCK: u32 = 64;

/// Pixels of the last picture, where they are kept.
#[derive(Debug, Default)]
pub(crate) struct KeptPixels {
    is_on: bool,
    /// Inputs of the looks that the samples were drawn from.
    pub(crate) inputs: Option<LookInputs>,
    pub(crate) blank: Option<BlankPipeline>,
    share: ShadedShare,
    /// Renderer of plans that would draw over what is kept.
    beside: Option<Box<Renderer>>,
}

impl KeptPixels {
    /// The inputs of a plan's looks; `None` where its samples are not kept.
    pub(crate) fn inputs_of(&self, plan: &FramePlan) -> Option<LookInputs> {
        // With one sample a pixel, lines over the picture are drawn into the samples themselves.
        let has_own_samples = plan.samples > 1 || !plan.passes.iter().any(|pass| pass.id.is_over());
        (self.is_on && has_own_samples).then(|| LookInputs::of(plan))
    }

    /// Counts what is shaded of a plan's picture: all, or what has pixels in some areas.
    pub(crate) fn count(&mut self, plan: &FramePlan, areas: Option<&[PixelArea]>) {
        if !self.is_on {
            return;
        }
        let is_shaded = |area: &PixelArea| {
            areas.is_none_or(|areas| areas.iter().any(|changed| changed.meets(area)))
        };
        let shaded = plan.draws.iter().filter(|draw| is_shaded(&draw.area));
        let whole = PixelArea::whole(plan.size).count() as f64;
        // Areas may overlap.
        let pixels =
            areas.map_or(whole, |areas| areas.iter().map(PixelArea::count).sum::<u64>() as f64);
        self.share = ShadedShare {
            objects: shaded.map(|draw| &draw.object).collect::<HashSet<_>>().len(),
            of: plan.draws.iter().map(|draw| &draw.object).collect::<HashSet<_>>().len(),
            pixels: pixels / whole,
        };
    }
}

impl Renderer {
    /// The renderer, changed to keep the samples of each picture: pixels in which nothing changes
    /// are not shaded again in the next one. Made for films: a camera that moves changes all.
    #[must_use]
    pub fn keeping_pixels(mut self) -> Self {
        self.keep_pixels();
        self
    }

    /// Keeps the samples of each picture from now on.
    pub(crate) fn keep_pixels(&mut self) {
        self.kept.is_on = true;
    }

    /// The renderer of further plans of a picture, which has targets of its own; `None` unless
    /// pixels are kept.
    pub(crate) fn beside_pixels(&mut self) -> Option<&mut Self> {
        let made = || Box::new(Self::new(self.gpu.clone()));
        self.kept.is_on.then(|| &mut **self.kept.beside.get_or_insert_with(made))
    }

    /// The share of the last picture that was shaded; `None` unless pixels are kept.
    pub fn shaded(&self) -> Option<ShadedShare> {
        self.kept.is_on.then_some(self.kept.share)
    }
}
