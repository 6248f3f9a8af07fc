//! Snapshot of the viewport that a thread can take along, and a stamp that tells whether it still
//! holds.

use std::path::PathBuf;
use std::sync::Arc;

use glam::DQuat;

use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Look, SourceMap};
use crate::frame::{AssetStore, Assets, Overlay, Planner, Setup, SetupLook, default_setup};
use crate::library::Library;
use crate::state::display::PictureDisplay;
use crate::state::orbit::Orbit;
use crate::state::revision::{
    DocumentNumber, FilesRevision, LookRevision, PaintingRevision, PictureRevision, PreviewRevision,
};
use crate::state::scene::SceneSnapshot;
use crate::state::solo::Solo;

/// A look with everything that its picture depends on, but for the size.
#[derive(Clone)]
pub(crate) struct RenderSnapshot {
    pub(crate) look: Arc<Look>,
    pub(crate) source: Arc<SourceMap>,
    /// Folder that the look's assets are relative to.
    pub(crate) folder: PathBuf,
    pub(crate) library: Arc<Library>,
    pub(crate) orbit: Orbit,
    /// Moment, in seconds.
    pub(crate) time: f64,
    /// View that pictures are shown by; `None` for the curve of sRGB.
    pub(crate) display: Option<PictureDisplay>,
    /// True if the picture is seen from the camera of the scene, or of the shot over it, in its
    /// light.
    pub(crate) by_camera: bool,
    /// The scene around the look; without one the look is on a mesh of its own.
    pub(crate) scene: Option<Arc<SceneSnapshot>>,
    /// The HCBTF that is being painted, in place of its file.
    pub(crate) painting: Option<Overlay>,
    /// Assets that all pictures of the window share.
    pub(crate) assets: AssetStore,
}

impl RenderSnapshot {
    /// The snapshot without the objects that do not wear the look.
    #[must_use]
    pub(crate) fn alone(self) -> Self {
        let scene = self.scene.map(|scene| Arc::new(scene.alone()));
        Self { scene, ..self }
    }

    /// Scene of the snapshot, with warnings about the mesh. The look is the first of its looks. Of
    /// a scene, missing parts are left out and reported.
    ///
    /// # Errors
    /// Problems of the mesh, without a scene.
    pub(crate) fn setup(
        &self,
        assets: &mut Assets,
    ) -> Result<WithWarnings<Setup>, Vec<Diagnostic>> {
        assets.share(&self.assets);
        assets.begin_picture();
        assets.overlay(self.painting.clone());
        let look = SetupLook {
            look: (*self.look).clone(),
            source: self.source.clone(),
            folder: self.folder.clone(),
        };
        let (mut setup, notes) = match &self.scene {
            Some(scene) => scene.setup(look, assets),
            None => default_setup(look, &self.orbit.mesh, assets)?,
        }
        .into_parts();
        if self.orbit.z_is_up && self.scene.is_none() {
            setup.stand_up();
        }
        see_from(&mut setup, &self.orbit, self.by_camera && self.scene.is_some());
        Ok(WithWarnings::new(setup, notes))
    }
}

/// Looks at a setup as the window does: in its own camera and light, where it has one and
/// `by_camera` is true, else in those of a view.
pub(crate) fn see_from(setup: &mut Setup, orbit: &Orbit, by_camera: bool) {
    if orbit.backdrop.is_some() {
        setup.hold("backdrop");
    }
    setup.scene.backdrop = orbit.backdrop.or(setup.scene.backdrop);
    if by_camera {
        return;
    }
    // The window is looked into from anywhere, not from a file's camera.
    setup.scene.file_camera = None;
    setup.scene.camera = orbit.camera();
    setup.scene.illumination = DQuat::to_array(&orbit.illumination);
    for held in ["camera", "illumination"] {
        setup.hold(held);
    }
}

/// A planner that keeps meshes and images, and compiled shaders of the last look alone.
pub(crate) struct CachedPlanner {
    planner: Planner,
    make: fn(Assets) -> Planner,
    last: Option<(Arc<Look>, Arc<Library>)>,
}

impl CachedPlanner {
    /// Creates the planner; `make` makes one from assets.
    pub(crate) fn new(make: fn(Assets) -> Planner) -> Self {
        Self { planner: make(Assets::default()), make, last: None }
    }

    /// The planner, for this look and these nodes.
    pub(crate) fn of(&mut self, look: &Arc<Look>, library: &Arc<Library>) -> &mut Planner {
        let is_same =
            |(last, of): &(Arc<Look>, Arc<Library>)| **last == **look && Arc::ptr_eq(of, library);
        if !self.last.as_ref().is_some_and(is_same) {
            self.planner = (self.make)(std::mem::take(&mut self.planner.assets));
            self.last = Some((look.clone(), library.clone()));
        }
        &mut self.planner
    }
}

/// Key of one moment of a session: the same stamp is the same look in the same view.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stamp {
    pub(super) document: DocumentNumber,
    pub(super) revision: LookRevision,
    pub(super) files: FilesRevision,
    pub(super) orbit: Orbit,
    pub(super) time: f64,
    pub(super) solo: Solo,
    pub(super) preview: PreviewRevision,
    /// Revision of the scene, if there is one.
    pub(super) scene: Option<PictureRevision>,
    pub(super) painting: Option<PaintingRevision>,
}

impl Stamp {
    /// The stamp with the camera and the moment left out: equal while the document, its files and
    /// the mesh are the same.
    #[must_use]
    pub(crate) fn without_view(self) -> Self {
        let orbit = Orbit { mesh: self.orbit.mesh, ..Orbit::default() };
        Self { orbit, time: 0.0, ..self }
    }
}
