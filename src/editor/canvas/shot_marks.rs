//! Values that the open shot changes, marked on the nodes that have them: a bar at the title, and
//! one at the row of each value, as in the inspector.

use std::collections::HashMap;

use eframe::egui::epaint::Mesh;
use eframe::egui::{Rect, Ui, vec2};

use super::Canvas;
use super::draw::{ALL_TEXT, Pen};
use super::mesh::rounded;
use crate::commands::Command;
use crate::document::Target;
use crate::drawing::{ROW_HEIGHT, TITLE_HEIGHT, row_center};
use crate::fields::shot::{ChangedRow, ChangedValue};
use crate::ids::{NodeId, NodePath, PortName};
use crate::state::keying::Owner;
use crate::state::session::Session;

/// Bar's distance from the left edge of a node, and its width, in points of the graph.
const BAR: [f32; 2] = [6.5, 2.5];

/// Inputs of a node that the open shot changes; none where it changes values within a group alone.
#[derive(Default)]
pub(super) struct ShotMark {
    inputs: Vec<PortName>,
}

/// Marks of the nodes of the open graph.
pub(super) fn shot_marks(session: &Session) -> HashMap<NodeId, ShotMark> {
    let mut marks: HashMap<NodeId, ShotMark> = HashMap::new();
    let groups = session.selection.open_groups();
    for changed in ChangedValue::all(session, Owner::Look) {
        let target = &changed.change.target;
        let own = target.strip_prefix("nodes.").and_then(|own| own.rsplit_once('.'));
        if let Some((node, _)) = own {
            if let Some([id, ..]) = NodePath::parse(node).ids().strip_prefix(groups) {
                marks.entry(id.clone()).or_default();
            }
            continue;
        }
        let Some(Target::Input { node, port }) = Target::parse(target) else { continue };
        if let Some([id, inner @ ..]) = node.ids().strip_prefix(groups) {
            let mark = marks.entry(id.clone()).or_default();
            mark.inputs.extend(inner.is_empty().then_some(port));
        }
    }
    marks
}

impl Canvas {
    /// Lines for the tooltip of a node that the open shot changes.
    pub(super) fn shot_text(&self, session: &Session, id: &NodeId) -> Option<String> {
        self.shot_marks.get(id)?;
        let changes = ChangedRow::of_node(session, &session.selection.path_of(id));
        (!changes.is_empty()).then(|| changes.help())
    }

    /// Shows an entry for each value of a node that the open shot changes, with the way back.
    pub(super) fn shot_menu(
        &self,
        ui: &mut Ui,
        session: &Session,
        id: &NodeId,
        out: &mut Vec<Command>,
    ) {
        if self.shot_marks.contains_key(id) {
            ChangedRow::of_node(session, &session.selection.path_of(id)).menu(ui, out);
        }
    }

    /// Draws the bars of a node that the open shot changes.
    pub(super) fn draw_shot_mark(&self, mesh: &mut Mesh, pen: &Pen<'_>, index: usize) {
        let row = &self.table.nodes[index];
        let Some(mark) = self.shot_marks.get(&row.id) else { return };
        let corner = self.view.rect_to_screen(row.rect).min;
        let mut bar = |middle: f32, height: f32| {
            let size = vec2(BAR[1], height - 5.0) * pen.zoom;
            let center = corner + vec2(BAR[0] + BAR[1] / 2.0, middle) * pen.zoom;
            let bar = Rect::from_center_size(center, size.max(vec2(1.5, 3.0)));
            rounded(mesh, bar, pen.zoom, (true, true), pen.colors.second);
        };
        bar(TITLE_HEIGHT / 2.0, TITLE_HEIGHT);
        if row.is_collapsed || pen.zoom <= ALL_TEXT {
            return;
        }
        for (input, port) in row.kind.inputs.iter().enumerate() {
            if mark.inputs.contains(&port.name) {
                bar(row_center(row.kind.outputs.len() + input), ROW_HEIGHT);
            }
        }
    }
}
