//! Another look, scene or shot as the other version: drawn on the fly, at the times, in the size
//! and in the view of the present frames.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;

use super::version::KeyedPicture;
use crate::compile::Live;
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::Document;
use crate::frame::{
    AssetStore, Assets, CullMode, PlanOptions, Planner, Setup, open as open_document,
};
use crate::library::Library;
use crate::render::Gpu;
use crate::state::display::PictureDisplay;
use crate::state::orbit::Orbit;
use crate::state::session::Session;
use crate::state::snapshot::see_from;
use crate::tools::picture_plan::SAMPLES;
use crate::tools::playback::drawing::PictureDrawer;
use crate::tools::playback::{FrameView, Playback};

/// All that frames of a document depend on beside its file and their time.
#[derive(Clone, PartialEq)]
pub(super) struct DocumentView {
    view: FrameView,
    size: [u32; 2],
    fps: f64,
}

impl DocumentView {
    /// The view of the present frames, which are drawn in a size.
    pub(super) fn of(session: &Session, playback: &Playback, size: [u32; 2], fps: f64) -> Self {
        Self { view: playback.view(session), size, fps }
    }

    /// The request for a frame of a document at a time, in seconds.
    pub(super) fn frame(&self, path: &Path, session: &Session, time: f64) -> DocumentFrame {
        DocumentFrame {
            path: path.to_path_buf(),
            orbit: session.view.orbit.clone(),
            by_camera: self.view.by_camera,
            size: self.size,
            time,
            display: session.view().display().cloned(),
            library: session.project.library.clone(),
            assets: session.assets.clone(),
        }
    }
}

/// Request for a frame of a document.
pub(super) struct DocumentFrame {
    path: PathBuf,
    /// View of the window; it has the mesh for a look.
    orbit: Orbit,
    by_camera: bool,
    size: [u32; 2],
    /// Time, in seconds.
    time: f64,
    /// View that it is shown by.
    display: Option<PictureDisplay>,
    library: Arc<Library>,
    assets: AssetStore,
}

/// A document that was read.
struct ReadDocument {
    path: PathBuf,
    mesh: String,
    library: Arc<Library>,
    setup: Setup,
    /// True for a look, which has neither camera nor objects of its own.
    is_look: bool,
}

/// Drawer of documents: one at a time is kept as it was read.
pub(super) struct DocumentDrawer {
    drawer: Option<PictureDrawer>,
    planner: Planner,
    read: Option<ReadDocument>,
}

impl DocumentDrawer {
    pub(super) fn new(gpu: Option<&Gpu>) -> Self {
        Self {
            drawer: gpu.map(PictureDrawer::new),
            planner: Planner::default().culling(CullMode::Objects),
            read: None,
        }
    }

    /// Reads the document anew for the next frame.
    fn read(&mut self, frame: &DocumentFrame) -> Result<&ReadDocument, Vec<Diagnostic>> {
        let is_it = |read: &ReadDocument| {
            read.path == frame.path
                && read.mesh == frame.orbit.mesh
                && Arc::ptr_eq(&read.library, &frame.library)
        };
        if !self.read.as_ref().is_some_and(is_it) {
            self.read = None;
            let mut assets = Assets::of(&frame.assets);
            let is_look =
                matches!(Document::load(&**assets.source(), &frame.path), Document::Look(_));
            let mesh = is_look.then_some(frame.orbit.mesh.as_str());
            let WithWarnings { value: mut setup, .. } =
                open_document(&frame.path, mesh, &mut assets)?;
            if is_look && frame.orbit.z_is_up {
                setup.stand_up();
            }
            self.planner = Planner::new(assets).culling(CullMode::Objects);
            self.read = Some(ReadDocument {
                path: frame.path.clone(),
                mesh: frame.orbit.mesh.clone(),
                library: frame.library.clone(),
                setup,
                is_look,
            });
        }
        let nothing = || vec![Diagnostic::error("cannot-read", tr!("nothing is there"))];
        self.read.as_ref().ok_or_else(nothing)
    }

    /// The picture of a frame.
    pub(super) async fn draw(
        &mut self,
        frame: DocumentFrame,
    ) -> Result<KeyedPicture, Box<Diagnostic>> {
        let file = frame.path.display().to_string();
        self.try_draw(frame).await.map_err(|problems| {
            let first = problems.into_iter().find(Diagnostic::is_error);
            let mut first = first.unwrap_or_else(|| {
                Diagnostic::error("cannot-draw", tr!("the document is not drawn"))
            });
            first.message = format!("{file}: {}", first.message);
            Box::new(first)
        })
    }

    async fn try_draw(&mut self, frame: DocumentFrame) -> Result<KeyedPicture, Vec<Diagnostic>> {
        let read = self.read(&frame)?;
        let mut setup = read.setup.clone();
        see_from(&mut setup, &frame.orbit, frame.by_camera && !read.is_look);
        let options = PlanOptions { size: frame.size, samples: SAMPLES, time: frame.time };
        let plan = self.planner.plan(&setup, &frame.library, &Live::Keyed, &options)?.value;
        let Some(drawer) = &mut self.drawer else {
            return Err(vec![Diagnostic::error(
                "no-gpu",
                tr!("there is no device to draw it with"),
            )]);
        };
        drawer.draw(&plan, frame.display.as_ref()).await.map(|(picture, _)| picture)
    }
}
