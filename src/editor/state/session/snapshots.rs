//! Snapshots of the session, for threads.

use std::sync::Arc;

use super::Session;
use crate::document::Look;
use crate::state::painting::work::OpenPainting;
use crate::state::revision::PictureRevision;
use crate::state::snapshot::{RenderSnapshot, Stamp};

impl Session {
    /// The document as shown, in the present view.
    pub(crate) fn snapshot(&self) -> RenderSnapshot {
        self.snapshot_of(Arc::new(self.shown_look().into_owned()))
    }

    /// Snapshot with another look in place of the document's.
    pub(crate) fn snapshot_of(&self, look: Arc<Look>) -> RenderSnapshot {
        RenderSnapshot {
            look,
            source: self.look.file.source.clone(),
            folder: self.look.folder(),
            library: self.project.library.clone(),
            orbit: self.view.orbit.clone(),
            time: self.view.time,
            display: self.view.display().cloned(),
            by_camera: self.follows_shot(),
            scene: self.open_scene().map(|open| self.view.solo.lit_scene(open.snapshot())),
            painting: self.painting().map(OpenPainting::overlay),
            assets: self.assets.clone(),
        }
    }

    /// Revision of the scene's picture, if there is a scene.
    pub(crate) fn scene_revision(&self) -> Option<PictureRevision> {
        self.open_scene().map(|open_scene| open_scene.snapshot().revision())
    }

    /// A stamp that changes whenever [`snapshot`](Self::snapshot) does.
    pub(crate) fn stamp(&self) -> Stamp {
        Stamp {
            document: self.revisions.document,
            revision: self.revision(),
            files: self.revisions.files,
            orbit: self.view.orbit.clone(),
            time: self.view.time,
            solo: self.view.solo.clone(),
            preview: self.sketchbook.preview_revision,
            scene: self.scene_revision(),
            painting: self.painting().map(OpenPainting::revision),
        }
    }
}
