//! Bar that tells which layers and lights are soloed or muted.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{RichText, Ui};

use crate::commands::{Command, SceneCommand};
use crate::document::{LightSet, SceneEdit};
use crate::fields::lighting::OwnedLight;
use crate::ids::{LightId, NodeId};
use crate::state::session::Session;
use crate::state::solo::{OF_THE_WINDOW, Solo};
use crate::widgets::theme;

/// Shows the bar, with a button that leads back; nothing while everything is shown.
pub(crate) fn show(ui: &mut Ui, session: &Session) -> Option<Command> {
    let text = sentence(session)?;
    let button = (tr!("Show all"), tr!("Ends every solo, and lets muted lights shine"));
    bar(ui, &text, OF_THE_WINDOW.tr(), &[button])?;
    Some(Command::Solo(Solo::default()))
}

/// Shows a bar of the solo that the scene itself has, with a button that ends it; nothing without
/// one.
pub(super) fn of_scene(ui: &mut Ui, session: &Session) -> Option<Command> {
    let soloed = &session.open_scene()?.scene().soloed;
    if soloed.is_none() {
        return None;
    }
    let text = tr!("Solo: {lights} · in the scene, saved with it", lights = soloed.text());
    let help = tr!(
        "Rendering warns of it, and with --strict refuses. The light table and the mixer set it; S \
         in Lights is of this window only"
    );
    let button = (tr!("End it"), tr!("Lets all lights shine again that are not muted"));
    let edit = SceneEdit::SetSoloedLights { soloed: LightSet::none() };
    bar(ui, &text, help, &[button])?;
    Some(Command::Scene(SceneCommand::Edit(edit)))
}

/// Shows a bar with a text, and with buttons at its end, which have a label and help. Returns the
/// index of the one that was clicked.
pub(super) fn bar(ui: &mut Ui, text: &str, help: &str, buttons: &[(&str, &str)]) -> Option<usize> {
    let frame = egui::Frame::new()
        .fill(theme::of(ui).accent_dim)
        .corner_radius(4.0)
        .inner_margin(egui::Margin::symmetric(8, 3));
    let mut clicked = None;
    frame.show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                for (index, (label, help)) in buttons.iter().enumerate().rev() {
                    if ui.button(*label).on_hover_text(*help).clicked() {
                        clicked = Some(index);
                    }
                }
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    let text = RichText::new(text).color(theme::of(ui).text);
                    ui.add(egui::Label::new(text).truncate()).on_hover_text(help);
                });
            });
        });
    });
    clicked
}

/// Sentence on the soloed and the muted layers and lights.
fn sentence(session: &Session) -> Option<String> {
    let solo = &session.view.solo;
    if solo.is_empty() {
        return None;
    }
    let layer = |id: &NodeId| session.look_with_library().title(id);
    let light = |id: &LightId| {
        OwnedLight::lighting(session, id)
            .map_or(id.as_str(), |owned_light| owned_light.name())
            .to_owned()
    };
    let list = |names: Vec<String>| names.join(", ");
    let mut parts = Vec::new();
    if !solo.layers.is_empty() {
        parts.push(tr!("Solo: {names}", names = list(solo.layers.iter().map(layer).collect())));
    }
    if !solo.lights.is_empty() {
        parts.push(tr!(
            "Solo: light {names}",
            names = list(solo.lights.iter().map(light).collect())
        ));
    }
    if !solo.muted.is_empty() {
        parts.push(tr!(
            "Muted: light {names}",
            names = list(solo.muted.iter().map(light).collect())
        ));
    }
    Some(tr!("{solos} · in this window only", solos = parts.join(" · ")))
}
