//! Links of an object: the set of lights that reach it, and of those that do not all the same.

use eframe::egui::{Id, Ui};

use crate::commands::SceneCommand;
use crate::document::{LightSet, Object};
use crate::fields::row::labelled;
use crate::ids::ObjectId;
use crate::state::scene::OpenScene;
use crate::widgets::text;

/// Words on how a set is written, for tooltips.
const SETS: &str = "* is every light. key | group:rim - group:set says more: ids, \"names\" and \
                    groups, with | for either, - for without, & for both, and ( )";

/// Shows the links of an object, where the scene has lights to share out.
pub(super) fn show(
    ui: &mut Ui,
    open_scene: &OpenScene,
    id: &ObjectId,
    object: &Object,
    out: &mut Vec<SceneCommand>,
) {
    if open_scene.scene().lights.is_empty() && object.light_link().is_all() {
        return;
    }
    ui.push_id((id, "lights"), |ui| {
        labelled(ui, "Lit by", &format!("Lights that reach it. {SETS}"), |ui, label| {
            let edit = set(ui, label, &object.linked).and_then(|(widget, set)| {
                let edit = open_scene.change(id, |object| object.linked = set)?;
                Some(SceneCommand::EditHeld(widget, edit))
            });
            out.extend(edit);
        });
        let help =
            format!("Lights that do not reach it all the same; {{source}} is Lit by. {SETS}");
        labelled(ui, "Not lit by", &help, |ui, label| {
            let edit = set(ui, label, &object.unlinked).and_then(|(widget, set)| {
                let edit = open_scene.change(id, |object| object.unlinked = set)?;
                Some(SceneCommand::EditHeld(widget, edit))
            });
            out.extend(edit);
        });
    });
}

fn set(ui: &mut Ui, label: Id, set: &LightSet) -> Option<(Id, LightSet)> {
    let read = |text: &str| LightSet::parse(text).map_err(|why| why.to_string());
    text::formed(ui, label, set, |set| set.text().to_owned(), read)
}
