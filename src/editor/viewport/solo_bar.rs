//! Bar that tells which layers and lights are soloed or muted.

use eframe::egui;
use eframe::egui::{RichText, Ui};

use crate::commands::Command;
use crate::fields::lighting::OwnedLight;
use crate::ids::{LightId, NodeId};
use crate::state::session::Session;
use crate::state::solo::{OF_THE_WINDOW, Solo};
use crate::widgets::theme;

/// Shows the bar, with a button that leads back; nothing while everything is shown.
pub(crate) fn show(ui: &mut Ui, session: &Session) -> Option<Command> {
    let text = sentence(session)?;
    let mut command = None;
    let frame = egui::Frame::new()
        .fill(theme::of(ui).accent_dim)
        .corner_radius(4.0)
        .inner_margin(egui::Margin::symmetric(8, 3));
    frame.show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui
                    .button("Show all")
                    .on_hover_text("Ends every solo, and lets muted lights shine")
                    .clicked()
                {
                    command = Some(Command::Solo(Solo::default()));
                }
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    let label =
                        egui::Label::new(RichText::new(text).color(theme::of(ui).text)).truncate();
                    ui.add(label).on_hover_text(OF_THE_WINDOW);
                });
            });
        });
    });
    command
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
        parts.push(format!("Solo: {}", list(solo.layers.iter().map(layer).collect())));
    }
    if !solo.lights.is_empty() {
        parts.push(format!("Solo: light {}", list(solo.lights.iter().map(light).collect())));
    }
    if !solo.muted.is_empty() {
        parts.push(format!("Muted: light {}", list(solo.muted.iter().map(light).collect())));
    }
    Some(format!("{} · in this window only", parts.join(" · ")))
}
