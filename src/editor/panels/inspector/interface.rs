//! Interface of the open group: its name, and the inputs and outputs that it shows to the outside.

use chiaro_locale::{tr, trn};
use eframe::egui;
use eframe::egui::{RichText, TextEdit, Ui};

use crate::commands::Command;
use crate::document::{Definition, Edit, GraphId, InterfacePort};
use crate::fields::row;
use crate::ids::{DefinitionId, GROUP_INPUTS, GROUP_OUTPUTS, PortName};
use crate::state::interface::{free_port, set};
use crate::state::session::Session;
use crate::widgets::text::is_typed;
use crate::widgets::theme;

/// Shows the interface of the open group.
pub(super) fn show(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    let (GraphId::Definition(id), Some(definition)) =
        (session.selection.graph_id(), session.graph_view().definition())
    else {
        return;
    };
    ui.label(
        RichText::new(if definition.label.is_empty() { id.as_str() } else { &definition.label })
            .heading(),
    )
    .on_hover_text(tr!("group {id}"));
    let users = users(session, id);
    let shared = trn!(
        count = users.max(1),
        "What is changed here is this group, wherever it is used.",
        "What is changed here changes all {count} nodes of this group."
    );
    ui.label(RichText::new(shared).color(theme::of(ui).dim));
    ui.add_space(4.0);
    text_row(
        ui,
        tr!("Name"),
        tr!("What its nodes are called"),
        &definition.label,
        id.as_str(),
        |widget, label| {
            out.push(Command::EditHeld(
                widget,
                set(id, definition, |changed| changed.label = label),
            ));
        },
    );
    text_row(
        ui,
        tr!("Help"),
        tr!("What it does, for whoever uses it"),
        &definition.help,
        "",
        |widget, help| {
            out.push(Command::EditHeld(widget, set(id, definition, |changed| changed.help = help)));
        },
    );
    ui.separator();
    ports(ui, tr!("Inputs"), (id, definition), false, out);
    ports(ui, tr!("Outputs"), (id, definition), true, out);
    ui.add_space(6.0);
    let hint = tr!("A wire dropped on \"Group inputs\" or \"Group outputs\" adds a port.");
    ui.label(RichText::new(hint).color(theme::of(ui).dim));
}

fn text_row(
    ui: &mut Ui,
    label: &str,
    help: &str,
    text: &str,
    hint: &str,
    changed: impl FnOnce(egui::Id, String),
) {
    row::labelled(ui, label, help, |ui, id| {
        let mut text = text.to_owned();
        let edit = TextEdit::singleline(&mut text)
            .hint_text(hint)
            .desired_width(f32::INFINITY)
            .char_limit(200);
        let response = ui.add(edit).labelled_by(id);
        if is_typed(ui, &response, &mut text) {
            changed(response.id, text);
        }
    });
}

/// Number of nodes of the look that use a group.
fn users(session: &Session, id: &DefinitionId) -> usize {
    let look = session.look();
    let graphs = look.definitions.values().map(|definition| &definition.graph).chain([&look.graph]);
    graphs.flat_map(|graph| graph.nodes.values()).filter(|node| node.kind == id.as_str()).count()
}

fn list(definition: &mut Definition, is_output: bool) -> &mut Vec<InterfacePort> {
    if is_output { &mut definition.outputs } else { &mut definition.inputs }
}

/// Names of a port's widgets, for screen readers.
struct PortNames {
    label: String,
    up: String,
    down: String,
    remove: String,
}

impl PortNames {
    fn of(port: &PortName, is_output: bool) -> Self {
        if is_output {
            Self {
                label: tr!("Label of output {port}"),
                up: tr!("Move up output {port}"),
                down: tr!("Move down output {port}"),
                remove: tr!("Remove output {port}"),
            }
        } else {
            Self {
                label: tr!("Label of input {port}"),
                up: tr!("Move up input {port}"),
                down: tr!("Move down input {port}"),
                remove: tr!("Remove input {port}"),
            }
        }
    }
}

fn ports(
    ui: &mut Ui,
    title: &str,
    (id, definition): (&DefinitionId, &Definition),
    is_output: bool,
    out: &mut Vec<Command>,
) {
    let ports = if is_output { &definition.outputs } else { &definition.inputs };
    ui.label(RichText::new(title).strong());
    for (index, port) in ports.iter().enumerate() {
        ui.push_id((is_output, &port.name), |ui| {
            ui.horizontal(|ui| {
                let mut label = port.label.clone().unwrap_or_default();
                let width = (ui.available_width() - 136.0).max(60.0);
                let edit = TextEdit::singleline(&mut label)
                    .hint_text(port.name.as_str())
                    .desired_width(width);
                let help = tr!("The label of {port}", port = port.name);
                let response = ui.add(edit).on_hover_text(help);
                let names = PortNames::of(&port.name, is_output);
                response.widget_info(|| {
                    egui::WidgetInfo::labeled(egui::Role::TextInput, true, &names.label)
                });
                if is_typed(ui, &response, &mut label) {
                    let label = (!label.is_empty()).then_some(label);
                    let edit = set(id, definition, |changed| {
                        list(changed, is_output)[index].label = label;
                    });
                    out.push(Command::EditHeld(response.id, edit));
                }
                let button = |ui: &mut Ui, text: &str, name: &str, is_on: bool| {
                    let response = ui.add_enabled(is_on, egui::Button::new(text).small());
                    response
                        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, is_on, name));
                    response.on_hover_text(name).clicked()
                };
                if button(ui, tr!("Up"), &names.up, index > 0) {
                    let edit = set(id, definition, |changed| {
                        list(changed, is_output).swap(index, index - 1);
                    });
                    out.push(Command::Edit(edit));
                }
                if button(ui, tr!("Down"), &names.down, index + 1 < ports.len()) {
                    let edit = set(id, definition, |changed| {
                        list(changed, is_output).swap(index, index + 1);
                    });
                    out.push(Command::Edit(edit));
                }
                if button(ui, "×", &names.remove, true) {
                    out.push(Command::Edit(remove(id, definition, is_output, index)));
                }
            });
        });
    }
    let add = if is_output { tr!("Add output") } else { tr!("Add input") };
    if ui.small_button(add).clicked() {
        let name = free_port(definition, is_output, "value");
        let port = InterfacePort { name, ..InterfacePort::default() };
        out.push(Command::Edit(set(id, definition, |changed| list(changed, is_output).push(port))));
    }
    ui.add_space(4.0);
}

/// Edit that removes a port with the wires to it inside.
fn remove(id: &DefinitionId, definition: &Definition, is_output: bool, index: usize) -> Edit {
    let graph = GraphId::Definition(id.clone());
    let name =
        if is_output { &definition.outputs[index].name } else { &definition.inputs[index].name };
    let leads = |end: &crate::document::Endpoint, node: &str| {
        end.node.as_str() == node && end.port == *name
    };
    let wires = definition.graph.wires.iter().filter(|wire| match is_output {
        true => leads(&wire.to, GROUP_OUTPUTS),
        false => leads(&wire.from, GROUP_INPUTS),
    });
    let mut edits: Vec<Edit> =
        wires.map(|wire| Edit::RemoveWire { graph: graph.clone(), wire: wire.clone() }).collect();
    edits.push(set(id, definition, |changed| drop(list(changed, is_output).remove(index))));
    Edit::Group { edits }
}
