//! Hint for highlights with a shape: rough surfaces break them into flecks, and smoothed normals
//! hold them together.

use chiaro_locale::tr;
use eframe::egui::{RichText, Ui};

use crate::commands::Command;
use crate::fields::InspectedNode;
use crate::state::stack::normals;
use crate::values;
use crate::widgets::theme;

/// Inputs that shape a highlight, each of them at 0 for none.
const SHAPES: [&str; 4] = ["split", "split_up", "square", "star"];

/// Shows the hint and the button that smooths, for a shape that the mesh's own normals draw.
pub(super) fn row(ui: &mut Ui, subject: &InspectedNode<'_>, out: &mut Vec<Command>) {
    let InspectedNode { session, id, node, kind } = subject;
    let is_shaped = SHAPES.iter().any(|name| {
        let port = kind.input(name).map(|index| &kind.inputs[index]);
        let value = port.and_then(|port| values::current(port, node.values.get(&port.name)));
        values::number(value) != 0.0
    });
    let has_all = SHAPES.iter().all(|name| kind.input(name).is_some());
    if !has_all || !is_shaped || !normals::are_plain(session.graph(), kind, id) {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        let text = tr!("On a rough scan its shape breaks into flecks.");
        ui.label(RichText::new(text).small().color(theme::of(ui).dim));
        let help = tr!(
            "Puts a Smooth normal node before it, whose Scale says how much; a larger highlight \
             helps, too"
        );
        if ui.small_button(tr!("Smooth normals")).on_hover_text(help).clicked() {
            let edit = normals::smooth(session.graph(), session.selection.graph_id(), id);
            out.push(Command::Edit(edit));
        }
    });
}
