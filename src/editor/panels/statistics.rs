//! Statistics of the open look: the numbers of its nodes, wires, lights and groups.

use eframe::egui::{Grid, Ui};

use crate::commands::{Command, PanelId};
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::session::Session;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId("statistics"),
    "Statistics",
    "The numbers of nodes, wires, lights and groups of the look",
    PanelPlace::BELOW_PICTURE,
    |_, ui, context| show(ui, context.session),
);

/// Lists the numbers.
fn show(ui: &mut Ui, session: &Session) -> Vec<Command> {
    let look = session.look();
    let rows = [
        ("Nodes", look.graph.nodes.len()),
        ("Wires", look.graph.wires.len()),
        ("Lights", look.lights.len()),
        ("Groups", look.definitions.len()),
    ];
    Grid::new("statistics").num_columns(2).striped(true).show(ui, |ui| {
        for (label, number) in rows {
            ui.label(label);
            ui.label(format!("{number} {}", label.to_lowercase()));
            ui.end_row();
        }
    });
    Vec::new()
}
