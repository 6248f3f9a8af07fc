//! Masks in the menu of a layer.

use chiaro_locale::{tr, tr_in};
use eframe::egui::{Button, Ui};

use super::select;
use crate::commands::{Command, MaskCommand};
use crate::document::{Edit, GraphId, Value};
use crate::ids::{NodeId, NodePath, PortName};
use crate::state::session::Session;
use crate::state::stack::Stack;
use crate::state::stack::mask::{self, INVERTED, SOURCES};
use crate::state::stack::tree::LayerTree;

/// Shows the entries that mask a layer, or that change the mask which it has.
pub(super) fn menu(
    ui: &mut Ui,
    session: &Session,
    tree: &LayerTree,
    layer: &NodeId,
    out: &mut Vec<Command>,
) {
    let look = session.look();
    let Some(stack) = tree.stack_of(layer) else { return };
    if let Some((id, node)) = mask::of(look, layer) {
        let is_inverted = matches!(node.values.get(INVERTED), Some(Value::Bool(true)));
        let help = tr!("What was hidden is shown, and what was shown is hidden");
        if ui.button(tr!("Invert mask")).on_hover_text(help).clicked() {
            out.push(Command::Edit(Edit::SetValue {
                graph: GraphId::Look,
                id: id.clone(),
                port: PortName::new(INVERTED),
                value: Value::Bool(!is_inverted),
                index: None,
            }));
        }
        let help = tr!("Selects it, to set it in the inspector");
        if ui.button(tr!("Show mask")).on_hover_text(help).clicked() {
            out.push(Command::Show(NodePath::root(id.clone())));
        }
        if session.mask_file(layer).is_some() {
            let help = tr!("Shows and hides parts of the layer with a brush on the model");
            if ui.button(tr!("Paint mask")).on_hover_text(help).clicked() {
                out.push(Command::Mask(MaskCommand::Paint(layer.clone())));
            }
        }
        let help = tr!("Takes the mask away, with what feeds it alone; the opacity stays");
        if ui.button(tr!("Remove mask")).on_hover_text(help).clicked() {
            out.extend(stack.unmask(look, layer).map(Command::Edit));
        }
        return;
    }
    let catalog = &session.project.catalog;
    let is_free = mask::is_free(look, catalog, layer);
    let name_of = |id: &NodeId| {
        let node = look.graph.nodes.get(id);
        let name = node.map(|node| match node.name.is_empty() {
            true => {
                catalog.of(node).map_or(String::new(), |kind| tr_in("node", &kind.label).to_owned())
            }
            false => node.name.clone(),
        });
        name.unwrap_or_default()
    };
    let taken = tr!("Its opacity comes by a wire already: put a Mask node into that wire");
    let clipping = tree.clipping(look, catalog, layer);
    let help = match (&clipping, is_free) {
        (_, false) => taken.to_owned(),
        (Some((below, _)), _) => tr!("Shows it only where {name} is", name = name_of(below)),
        (None, _) => tr!("The layer below has no tone that says where it is").to_owned(),
    };
    let button = Button::new(tr!("Clip to the layer below"));
    let clip = ui.add_enabled(is_free && clipping.is_some(), button);
    if clip.on_hover_text(&help).on_disabled_hover_text(&help).clicked()
        && let Some((_, tone)) = clipping
    {
        add(session, Stack::mask_by(look, layer, tone), out);
    }
    ui.add_enabled_ui(is_free, |ui| {
        let shown = ui.menu_button(tr!("Mask by"), |ui| {
            let help = tr!(
                "Hides the layer; what is painted on the model with a brush shows it. Kept in a \
                 picture beside the look's file, by the mesh's UVs"
            );
            let unsaved = tr!("Save the look first: the mask is a picture beside its file");
            let is_saved = session.path().is_some();
            let button = ui.add_enabled(is_saved, Button::new(tr!("Paint on the model")));
            if button.on_hover_text(help).on_disabled_hover_text(unsaved).clicked() {
                out.push(Command::Mask(MaskCommand::New(layer.clone())));
            }
            for source in &SOURCES {
                if ui.button(source.name.tr()).on_hover_text(source.help.tr()).clicked() {
                    add(session, stack.mask(look, layer, source), out);
                }
            }
            let tones = tree.tones(look, catalog, layer);
            if !tones.is_empty() {
                ui.separator();
            }
            for (id, tone) in tones {
                let text = tr!("Tone of {name}", name = name_of(&id));
                if ui.button(text).on_hover_text(tr!("Shows it only where that layer is")).clicked()
                {
                    add(session, Stack::mask_by(look, layer, tone), out);
                }
            }
        });
        let help = tr!("Hides parts of the layer: white shows it, black hides it");
        shown.response.on_hover_text(help).on_disabled_hover_text(taken);
    });
}

/// Adds a mask, and selects it.
fn add(session: &Session, (mask, edit): (NodeId, Edit), out: &mut Vec<Command>) {
    out.push(Command::Edit(edit));
    select(session, vec![mask], out);
}
