//! Name, description and outlines of a scene.

use chiaro_locale::tr;
use eframe::egui::{CollapsingHeader, TextEdit, Ui};

use super::outlines;
use crate::commands::{Command, SceneCommand};
use crate::document::{Scene, SceneEdit};
use crate::fields::row::labelled;
use crate::fields::shot::{self, ChangedValue};
use crate::state::keying::Owner;
use crate::state::session::Session;
use crate::widgets::text::is_typed;

/// Shows all fields, in a collapsible section.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    scene: &Scene,
    out: &mut Vec<SceneCommand>,
    commands: &mut Vec<Command>,
) {
    let unnamed = tr!("Name, about, outlines");
    let title = if scene.name.is_empty() { unnamed.to_owned() } else { scene.name.clone() };
    let section = CollapsingHeader::new(title).id_salt("words of the scene").show(ui, |ui| {
        labelled(ui, tr!("Scene name"), tr!("What you call this scene"), |ui, label| {
            let mut name = scene.name.clone();
            let response = ui
                .add(TextEdit::singleline(&mut name).desired_width(f32::INFINITY))
                .labelled_by(label);
            if is_typed(ui, &response, &mut name) {
                out.push(SceneCommand::EditHeld(response.id, SceneEdit::SetSceneName { name }));
            }
        });
        labelled(ui, tr!("About"), tr!("What it shows, for who finds it"), |ui, label| {
            let mut about = scene.about.clone();
            let field =
                TextEdit::multiline(&mut about).desired_width(f32::INFINITY).desired_rows(2);
            let response = ui.add(field.hint_text(tr!("What it shows"))).labelled_by(label);
            if response.changed() {
                out.push(SceneCommand::EditHeld(response.id, SceneEdit::SetSceneAbout { about }));
            }
        });
        outlines::show(ui, session, scene, out, commands);
    });
    let header = section.header_response;
    let mut changes = ChangedValue::all(session, Owner::Scene);
    if changes.any(|changed| changed.change.target.starts_with("outlines.")) {
        shot::bar(ui, header.rect);
    }
    header.on_hover_text(tr!("What the scene is called, what it shows, and lines over it"));
}
