//! View of the picture: the camera, the moment, and what of the look is shown.

use chiaro_locale::tr;

use crate::document::{Camera, SceneEdit};
use crate::ids::ObjectId;
use crate::state::display::PictureDisplay;
use crate::state::orbit::Orbit;
use crate::state::revision::SoloRevision;
use crate::state::scene::{OpenScene, unit_rotation};
use crate::state::solo::Solo;
use crate::state::wire::ShownWire;

/// Part of an object's transform, which has handles in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TransformPart {
    Place,
    Turn,
    Scale,
}

impl TransformPart {
    pub(crate) const ALL: [Self; 3] = [Self::Place, Self::Turn, Self::Scale];

    /// Label of the switch of its handles.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Place => tr!("Move"),
            Self::Turn => tr!("Turn"),
            Self::Scale => tr!("Scale"),
        }
    }
}

/// View and moment of the picture, and the shown part of the look.
#[derive(Default)]
pub struct ViewState {
    pub(crate) orbit: Orbit,
    /// The view of a scene that has no camera, until its objects are found and framed.
    pub(super) unframed: Option<Orbit>,
    /// Part of the selected object's transform that has handles in the picture.
    pub(crate) handled: Option<TransformPart>,
    /// The moment in the picture, in seconds.
    pub(crate) time: f64,
    /// Wire that is shown in place of the look's own output.
    pub(crate) wire: Option<ShownWire>,
    /// Layers and lights that are shown alone or left out for now.
    pub(crate) solo: Solo,
    /// Revision of the solo, which grows whenever another solo needs another shader.
    pub(crate) solo_revision: SoloRevision,
    /// View that the picture is shown by; `None` for the curve of sRGB.
    pub(super) display: Option<PictureDisplay>,
}

impl ViewState {
    /// View of the camera, with the turn of the lights.
    pub fn orbit(&self) -> &Orbit {
        &self.orbit
    }

    /// The moment in the picture, in seconds.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// View that the picture is shown by; `None` for the curve of sRGB.
    pub(crate) fn display(&self) -> Option<&PictureDisplay> {
        self.display.as_ref()
    }

    /// True if a light is neither muted nor left out by a solo.
    pub fn shines(&self, light: &str) -> bool {
        !self.solo.is_dark(&light.into())
    }

    /// Turns camera and lights as the scene has them, or to their defaults without a scene.
    pub(crate) fn reset(&mut self, open_scene: Option<&OpenScene>) {
        let Some(open_scene) = open_scene else { return self.orbit.reset() };
        let scene = open_scene.scene();
        self.orbit.look_from(&scene.camera);
        self.orbit.illumination = unit_rotation(scene.illumination);
        self.orbit.backdrop = None;
        let has_camera = scene.camera != Camera::default() || scene.file_camera.is_some();
        self.unframed = (!has_camera).then(|| self.orbit.clone());
    }

    /// Brings all objects of a scene that has no camera into view, where they are not yet and
    /// nobody has turned the camera meanwhile. Returns true if it did.
    pub(crate) fn frame_without_camera(
        &mut self,
        open_scene: Option<&OpenScene>,
        aspect: f64,
    ) -> bool {
        let is_untouched = self.unframed.take().is_some_and(|unframed| unframed == self.orbit);
        let sphere = open_scene.and_then(|open_scene| open_scene.sphere(None));
        let Some((center, radius)) = sphere.filter(|_| is_untouched) else { return false };
        let is_cropped = self.orbit.crops(center, radius, aspect);
        if is_cropped {
            self.orbit.frame(center, radius, aspect);
        }
        is_cropped
    }

    /// The edit that sets the scene's camera and backdrop to the present view, and with
    /// `with_lights` the turn of the lights, in a picture of such an aspect, width over height. The
    /// lens of the camera `before` stays where nobody changed it.
    pub(crate) fn as_scene_edit(
        &self,
        before: &Camera,
        aspect: f64,
        with_lights: bool,
    ) -> SceneEdit {
        let camera = SceneEdit::SetCamera { camera: self.orbit.camera_with(before, aspect) };
        let rotation = self.orbit.illumination.to_array();
        let lights = with_lights.then_some(SceneEdit::SetIllumination { rotation });
        let mut edits: Vec<SceneEdit> = std::iter::once(camera).chain(lights).collect();
        edits
            .extend(self.orbit.backdrop.map(|color| SceneEdit::SetBackdrop { color: Some(color) }));
        SceneEdit::Group { edits }
    }

    /// Brings an object of the scene into view, or all of them, or the mesh of a look without a
    /// scene; the direction stays. `aspect` is the picture's width over its height.
    pub(crate) fn frame(
        &mut self,
        open_scene: Option<&OpenScene>,
        only: Option<&ObjectId>,
        aspect: f64,
    ) {
        match open_scene.map(|open_scene| open_scene.sphere(only)) {
            None => self.orbit.frame_object(),
            Some(Some((center, radius))) => self.orbit.frame(center, radius, aspect),
            Some(None) => {}
        }
    }
}
