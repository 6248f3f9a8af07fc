//! Offer to stand up a mesh that seems to lie on its back, as scans do whose z axis points up.
//!
//! Nothing in a mesh says which way is up, so that it is an offer and no more: for files of formats
//! without a rule, whose mesh is highest along z and does not rest on the plane y = 0. It is made
//! once for each mesh.

use std::collections::BTreeSet;
use std::path::Path;

use chiaro_locale::tr;
use eframe::egui::Ui;

use super::solo_bar;
use super::surface::Surface;
use crate::commands::{Command, SceneCommand};
use crate::document::Transform;
use crate::frame::SHAPE_PREFIX;
use crate::geometry::Bounds;
use crate::state::scene::{file_label, stood_up};
use crate::state::session::Session;

/// Formats whose meshes may have any axis up.
const FORMATS: [&str; 3] = ["obj", "ply", "stl"];
/// Height along z, in heights along y, from which on a mesh seems to lie.
const LYING: f64 = 1.25;
/// Distance from the plane y = 0 in which a mesh rests on it, in its heights.
const RESTING: f64 = 0.02;

/// True if bounds seem to be those of a mesh that lies on its back.
pub(super) fn seems_to_lie(bounds: &Bounds) -> bool {
    let size = bounds.size();
    let rests = bounds.min.y.abs() <= RESTING * size.y;
    size.z > LYING * size.y && size.z >= size.x && !rests
}

/// True for a file that may have any axis up.
fn may_lie(mesh: &str) -> bool {
    let ending = Path::new(mesh).extension().and_then(|ending| ending.to_str());
    !mesh.starts_with(SHAPE_PREFIX)
        && ending.is_some_and(|ending| FORMATS.contains(&&*ending.to_ascii_lowercase()))
}

/// State of the offer.
#[derive(Default)]
pub(super) struct StandUpOffer {
    /// Meshes of which an answer was given.
    answered: BTreeSet<String>,
    /// Mesh of a look without a scene that was looked at, and whether it seems to lie.
    judged: Option<(String, bool)>,
}

impl StandUpOffer {
    /// True if the surface of a look's mesh is wanted, to find out whether it lies.
    pub(super) fn wants_surface(&self, session: &Session) -> bool {
        let orbit = &session.view.orbit;
        let is_known = self.judged.as_ref().is_some_and(|(mesh, _)| *mesh == orbit.mesh);
        session.open_scene().is_none() && !orbit.z_is_up && may_lie(&orbit.mesh) && !is_known
    }

    /// Looks at the surface of a look's mesh.
    pub(super) fn judge(&mut self, session: &Session, surface: Option<&Surface>) {
        let mesh = &session.view.orbit.mesh;
        if let Some(surface) = surface.filter(|surface| surface.key.mesh == *mesh)
            && self.wants_surface(session)
            && let [placed] = surface.parts_seen.placed.as_slice()
        {
            self.judged = Some((mesh.clone(), placed.seems_to_lie));
        }
    }

    /// Mesh that seems to lie, and the command that stands it up.
    pub(super) fn offer(&self, session: &Session) -> Option<(String, Command)> {
        let found = match session.open_scene() {
            Some(open_scene) => {
                let (id, object) = open_scene.selected()?;
                let is_turned = object.transform.rotate != Transform::default().rotate;
                let lies = open_scene.place(id).is_some_and(|placed| placed.seems_to_lie);
                let rotate = stood_up(object.transform.rotate);
                let edit = open_scene.change(id, |object| object.transform.rotate = rotate)?;
                let command = Command::Scene(SceneCommand::Edit(edit));
                (lies && !is_turned && may_lie(&object.mesh))
                    .then(|| (object.mesh.clone(), command))
            }
            None => {
                let orbit = &session.view.orbit;
                let (mesh, lies) = self.judged.as_ref()?;
                (*lies && *mesh == orbit.mesh && !orbit.z_is_up)
                    .then(|| (mesh.clone(), Command::StandUp(true)))
            }
        };
        found.filter(|(mesh, _)| !self.answered.contains(mesh))
    }

    /// Shows the offer, where there is one.
    pub(super) fn show(&mut self, ui: &mut Ui, session: &Session) -> Option<Command> {
        let (mesh, command) = self.offer(session)?;
        let text = tr!("{mesh} seems to lie on its back", mesh = file_label(&mesh));
        let help = tr!("It is longest along z, as scans are whose z axis points up");
        let buttons = [
            (
                tr!("Stand up"),
                tr!("Turns it by a quarter; Options, and Objects in a scene, turn it back"),
            ),
            (tr!("Leave it"), tr!("It lies as it should")),
        ];
        let answer = solo_bar::bar(ui, &text, help, &buttons)?;
        self.answered.insert(mesh);
        (answer == 0).then_some(command)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_that_are_high_along_z_and_stand_on_nothing_seem_to_lie() {
        let bounds = |min: [f32; 3], max: [f32; 3]| Bounds::of(&[min, max]);
        assert!(seems_to_lie(&bounds([-0.25, -0.4, -0.5], [0.25, 0.4, 0.6])), "a bust");
        assert!(!seems_to_lie(&bounds([-1.0, 0.0, -2.0], [1.0, 1.2, 2.0])), "a car on the ground");
        assert!(!seems_to_lie(&bounds([-1.0, -0.5, -0.6], [1.0, 0.5, 0.6])), "a wide one");
        assert!(!seems_to_lie(&bounds([-0.3, -1.0, -0.3], [0.3, 1.0, 0.3])), "a standing one");
        assert!(!seems_to_lie(&Bounds::of(&[])), "nothing");
    }

    #[test]
    fn formats_with_a_rule_and_own_shapes_do_not_lie() {
        assert!(may_lie("scans/bust.OBJ") && may_lie("a.ply") && may_lie("b.stl"));
        assert!(!may_lie("shape:creature") && !may_lie("hero.glb") && !may_lie("noending"));
    }
}
