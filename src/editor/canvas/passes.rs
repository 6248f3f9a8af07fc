//! Outputs that the look names as passes (AOVs), on the canvas: a tag beside the output, and the
//! entries of the menu.

use chiaro_locale::tr;
use eframe::egui::Ui;

use super::Canvas;
use super::inplace::Item;
use super::table::Socket;
use crate::commands::Command;
use crate::document::OutputPort;
use crate::fields::passes::{OutputPass, can_be_named};
use crate::ids::{NodeId, PortName};
use crate::state::session::Session;

/// Output of a node of the open graph by its index.
pub(super) fn output_of(session: &Session, node: &NodeId, index: usize) -> Option<OutputPort> {
    let kind = session.project.catalog.of(session.graph().nodes.get(node)?)?;
    let port = kind.outputs.get(index)?.name.clone();
    Some(OutputPort { node: session.selection.path_of(node), port })
}

impl Canvas {
    /// Notes the names of outputs with their nodes, after the table was made again.
    pub(super) fn note_passes(&mut self, session: &Session) {
        if session.look().aovs.is_empty() {
            return;
        }
        for row in &mut self.table.nodes {
            let name = |index: usize| -> Option<(usize, PortName)> {
                let output = output_of(session, &row.id, index)?;
                Some((index, OutputPass::of(session, &output).name()?.clone()))
            };
            row.named = (0..row.kind.outputs.len()).filter_map(name).collect();
        }
    }

    /// Name of an output as a pass.
    pub(super) fn pass_at(&self, socket: Socket) -> Option<&PortName> {
        let named = socket.is_output.then(|| self.table.nodes[socket.node].named.iter())?;
        named.into_iter().find(|(index, _)| *index == socket.port).map(|(_, name)| name)
    }

    /// Outputs of a node that can be passes: index, and label.
    fn nameable(&self, node: usize, session: &Session) -> Vec<(usize, String)> {
        let row = &self.table.nodes[node];
        let nameable = |index: &usize| {
            let output = output_of(session, &row.id, *index);
            output.is_some_and(|output| can_be_named(session, &output))
        };
        let outputs = (0..row.kind.outputs.len()).filter(nameable);
        let label = |index: usize| row.shown(&row.kind.outputs[index].label).to_owned();
        outputs.map(|index| (index, label(index))).collect()
    }

    /// Shows the menu's entries about passes: of the output that was pressed, or of all outputs of
    /// a node.
    pub(super) fn pass_menu(
        &mut self,
        ui: &mut Ui,
        (node, pressed): (usize, Option<usize>),
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let mut outputs = self.nameable(node, session);
        if let Some(pressed) = pressed {
            outputs.retain(|(index, _)| *index == pressed);
        }
        match outputs.as_slice() {
            [] => {}
            [(index, _)] => self.pass_entries(ui, (node, *index), session, out),
            _ => {
                ui.menu_button(tr!("Name as a pass (AOV)"), |ui| {
                    for (index, label) in &outputs {
                        ui.menu_button(label, |ui| {
                            self.pass_entries(ui, (node, *index), session, out);
                        });
                    }
                });
            }
        }
    }

    fn pass_entries(
        &mut self,
        ui: &mut Ui,
        (node, index): (usize, usize),
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let row = &self.table.nodes[node];
        let id = row.id.clone();
        let name = self.pass_at(Socket { node, port: index, is_output: true }).cloned();
        let text = match &name {
            Some(name) => tr!("Rename the pass \"{name}\"..."),
            None => tr!("Name as a pass (AOV)...").to_owned(),
        };
        let help = tr!(
            "Films ask for it by this name: chiaro render --aov NAME, or --aov named for all. It \
             costs nothing where nobody asks"
        );
        if ui.button(text).on_hover_text(help).clicked() {
            self.edit_when_there = Some(Item::Pass(id.clone(), index));
            ui.close();
        }
        let Some(name) = name else { return };
        if ui.button(tr!("Remove the pass \"{name}\"")).clicked() {
            let output = output_of(session, &id, index);
            let edit = output.and_then(|output| OutputPass::of(session, &output).named("").ok());
            out.extend(edit.flatten().map(Command::Edit));
            ui.close();
        }
    }

    /// Begins to name an output of a node: the first without a name, else the first.
    pub(super) fn begin_pass(&mut self, id: &NodeId, session: &Session, out: &mut Vec<Command>) {
        let Some(node) = self.table.index_of(id) else { return };
        let outputs = self.nameable(node, session);
        let is_unnamed = |(index, _): &&(usize, String)| {
            self.pass_at(Socket { node, port: *index, is_output: true }).is_none()
        };
        match outputs.iter().find(is_unnamed).or(outputs.first()) {
            Some((index, _)) => self.edit_when_there = Some(Item::Pass(id.clone(), *index)),
            None => out.push(Command::Tell(tr!(
                "{node} gives nothing that can be a pass: numbers, vectors, colors, angles and \
                 lights can",
                node = self.table.nodes[node].title
            ))),
        }
    }
}
