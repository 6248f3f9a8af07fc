//! Drawing of frames ahead, on a thread of its own: planned, told from frames that are equal, drawn
//! on the window's device, and read back.

use std::collections::HashMap;
use std::sync::{Arc, Weak};

use chiaro_locale::tr;
use eframe::egui::ColorImage;

use super::cache::PictureKey;
use crate::clock::Clock;
use crate::diag::Diagnostic;
use crate::film::PlanHasher;
use crate::frame::FramePlan;
use crate::render::{Gpu, Renderer};
use crate::state::display::PictureDisplay;
use crate::state::revision::RequestNumber;
use crate::state::session::DrawableLook;
use crate::state::snapshot::RenderSnapshot;
use crate::tools::picture_plan::PicturePlanner;

/// Number of pictures that are remembered before those are forgotten that nobody has any more.
const MANY: usize = 1024;

/// Request for a frame.
pub(super) struct FrameRequest {
    /// State of the documents and the view.
    pub(super) basis: RequestNumber,
    pub(super) frame: i32,
    pub(super) showing: DrawableLook,
    /// Snapshot at the frame's time.
    pub(super) snapshot: RenderSnapshot,
    pub(super) size: [u32; 2],
}

/// Answer to a request.
pub(super) struct FrameAnswer {
    pub(super) basis: RequestNumber,
    pub(super) frame: i32,
    pub(super) result: Result<(PictureKey, Arc<ColorImage>), Vec<Diagnostic>>,
    /// Seconds that the answer took; `None` where an equal frame was known.
    pub(super) seconds: Option<f64>,
}

/// Drawer of planned pictures, which tells those that are equal.
pub(crate) struct PictureDrawer {
    renderer: Renderer,
    hasher: PlanHasher,
    /// Pictures that were drawn, as long as somebody has them.
    known: HashMap<PictureKey, Weak<ColorImage>>,
}

impl PictureDrawer {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let renderer = Renderer::new(gpu.clone()).keeping_pixels();
        Self { renderer, hasher: PlanHasher::default(), known: HashMap::new() }
    }

    /// The picture of a plan, shown by a view, with its key, and true if it had to be drawn.
    pub(crate) async fn draw(
        &mut self,
        plan: &FramePlan,
        display: Option<&PictureDisplay>,
    ) -> Result<((PictureKey, Arc<ColorImage>), bool), Vec<Diagnostic>> {
        // The same plan is another picture by another view.
        let of_display = display.map_or(0, PictureDisplay::number);
        let key = u128::from_str_radix(&self.hasher.hash(plan), 16);
        let key = key.map(|plan| PictureKey(plan ^ of_display));
        let key =
            key.map_err(|_| vec![Diagnostic::error("plan-hash", tr!("a plan has no hash"))])?;
        if let Some(known) = self.known.get(&key).and_then(Weak::upgrade) {
            return Ok(((key, known), false));
        }
        let module = display.map(PictureDisplay::module);
        // A view that the device does not take is told where the picture at rest is drawn.
        let _ = self.renderer.show_by(module).await;
        let drawn = self.renderer.picture(plan).await;
        let picture = drawn.map_err(|error| vec![error.into()])?;
        let size = picture.size.map(|side| side as usize);
        let image = Arc::new(ColorImage::from_rgba_unmultiplied(size, &picture.to_rgba8()));
        if self.known.len() >= MANY {
            self.known.retain(|_, known| known.strong_count() > 0);
        }
        self.known.insert(key, Arc::downgrade(&image));
        Ok(((key, image), true))
    }
}

/// State of the thread that draws frames.
pub(super) struct FrameDrawer {
    drawer: PictureDrawer,
    planner: PicturePlanner,
}

impl FrameDrawer {
    pub(super) fn new(gpu: &Gpu) -> Self {
        Self { drawer: PictureDrawer::new(gpu), planner: PicturePlanner::default() }
    }

    pub(super) async fn run(&mut self, request: FrameRequest) -> FrameAnswer {
        let clock = Clock::start();
        let FrameRequest { basis, frame, showing, snapshot, size } = request;
        let drawn = match self.planner.plan(&showing, &snapshot, size) {
            Ok(plan) => self.drawer.draw(&plan.value, snapshot.display.as_ref()).await,
            Err(problems) => Err(problems),
        };
        let was_drawn = drawn.as_ref().is_ok_and(|(_, was_drawn)| *was_drawn);
        let result = drawn.map(|(picture, _)| picture);
        FrameAnswer { basis, frame, result, seconds: was_drawn.then(|| clock.seconds()) }
    }
}
