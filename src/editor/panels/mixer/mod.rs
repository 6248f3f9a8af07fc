//! Mixer of the open scene: a channel for each group of lights, as a mixing desk has them, with the
//! group's master as a fader, its exposure, its tint, and what is muted or soloed.

mod channel;

use chiaro_locale::{text, tr};
use eframe::egui::{Align, Layout, ScrollArea, Ui};

use super::lights::add;
use crate::commands::{Command, PanelId};
use crate::fields::mix::{MixedLights, SceneMix};
use crate::ids::LightGroup;
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::session::Session;
use crate::widgets::text::hint;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::MIXER,
    text!("Mixer"),
    text!("The masters of the scene's groups of lights, as faders: dim, tint, mute and solo them"),
    PanelPlace::BELOW_GRAPH,
    |bench, ui, context| bench.memory.of::<Mixer>().show(ui, context.session),
);

/// The panel and its state.
#[derive(Default)]
pub(crate) struct Mixer {
    lights: MixedLights,
}

impl Mixer {
    /// Shows a channel for each group.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        self.lights.sync(session);
        let mut out = Vec::new();
        let Some(mix) = SceneMix::of(session, &self.lights) else {
            hint(ui, tr!("A scene has the masters of groups: add an object, and there is one."));
            add::panels(ui, &mut out);
            return out;
        };
        let groups = self.lights.groups(Some(mix.scene));
        if groups.is_empty() {
            mix.solo_note(ui, &mut out);
            hint(
                ui,
                tr!("No light is of a group yet. Give lights groups in the light table, and each \
                     group has a channel here."),
            );
            add::panels(ui, &mut out);
            return out;
        }
        // The note stands below: what is clicked must not move when it comes or goes.
        ui.with_layout(Layout::bottom_up(Align::LEFT), |ui| {
            mix.solo_note(ui, &mut out);
            let layout = Layout::top_down(Align::LEFT);
            ui.with_layout(layout, |ui| channels(ui, session, mix, &groups, &mut out));
        });
        out
    }
}

/// Shows the channels of groups, beside each other.
fn channels(
    ui: &mut Ui,
    session: &Session,
    mix: SceneMix<'_>,
    groups: &[LightGroup],
    out: &mut Vec<Command>,
) {
    let fader = channel::fader_height(ui.available_height());
    ScrollArea::both().auto_shrink([false, false]).id_salt("mixer").show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            for group in groups {
                ui.push_id(group, |ui| channel::show(ui, session, mix, (group, fader), out));
            }
        });
    });
}
