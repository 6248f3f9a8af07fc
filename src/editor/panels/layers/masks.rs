//! Masks in the menu of a layer.

use chiaro_locale::tr;
use eframe::egui::{Button, Ui};

use super::row::title_of;
use super::select;
use crate::commands::{Command, MaskCommand};
use crate::document::{Edit, GraphId, Target, Value};
use crate::ids::{NodeId, NodePath, PortName};
use crate::state::masks::IMAGE;
use crate::state::scene::sphere_of_lights;
use crate::state::session::Session;
use crate::state::stack::Stack;
use crate::state::stack::mask::{self, INVERTED, SOURCES, VERTEX_COLOR};
use crate::state::stack::tree::LayerTree;
use crate::widgets::menu;

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
    if mask::of(look, layer).is_some() {
        of_masked(ui, session, (tree, stack), layer, out);
        return;
    }
    let catalog = &session.project.catalog;
    let is_free = mask::is_free(look, catalog, layer);
    let name_of = |id: &NodeId| title_of(session, id);
    let taken = tr!("Its opacity comes by a wire already: put a Mask node into that wire");
    let clipping = tree.clipping(look, catalog, layer);
    let help = match (&clipping, is_free) {
        (_, false) => taken.to_owned(),
        (Some((below, _)), _) if tree.is_folder(below) => tr!(
            "Shows it only where a layer is that lies in {name} now, within its masks (Ctrl+Alt+G)",
            name = name_of(below)
        ),
        (Some((below, _)), _) => tr!(
            "Shows it only where {name} is, within its mask (Ctrl+Alt+G)",
            name = name_of(below)
        ),
        (None, _) => tr!(
            "The layer or folder below is everywhere, so that nothing would be hidden, or there is \
             none"
        )
        .to_owned(),
    };
    let button = Button::new(tr!("Clip to the layer below"));
    let clip = ui.add_enabled(is_free && clipping.is_some(), button);
    menu::why_disabled(&clip, &help);
    if clip.on_hover_text(&help).clicked()
        && let Some((_, coverage)) = clipping
    {
        add(session, Stack::mask_by(look, layer, &coverage), out);
    }
    ui.add_enabled_ui(is_free, |ui| {
        let shown = ui.menu_button(tr!("Mask by"), |ui| {
            let help = tr!(
                "Hides the layer; what is painted on the model with a brush shows it. Kept in a \
                 picture beside the look's file, by the mesh's UVs; where there are none, it lies \
                 straight through the mesh as it is seen now"
            );
            let unsaved = tr!("Save the look first: the mask is a picture beside its file");
            let is_saved = session.path().is_some();
            let button = ui.add_enabled(is_saved, Button::new(tr!("Paint on the model")));
            menu::why_disabled(&button, unsaved);
            if button.on_hover_text(help).clicked() {
                out.push(Command::Mask(MaskCommand::New(layer.clone())));
            }
            sources(ui, session, (tree, stack), layer, out);
        });
        let help = tr!("Hides parts of the layer: white shows it, black hides it");
        shown.response.on_hover_text(help).on_disabled_hover_text(taken);
    });
}

/// Shows the entries that change the mask of a layer.
fn of_masked(
    ui: &mut Ui,
    session: &Session,
    (tree, stack): (&LayerTree, &Stack),
    layer: &NodeId,
    out: &mut Vec<Command>,
) {
    let look = session.look();
    let Some((id, node)) = mask::of(look, layer) else { return };
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
    let clip = tree.clip_of(look, &session.project.catalog, layer);
    if let Some(clip) = clip.as_ref().filter(|clip| clip.is_stale) {
        let name = title_of(session, &clip.base);
        let help = tr!("{name} has got further layers: shows it where those are, too");
        if ui.button(tr!("Clip anew")).on_hover_text(help).clicked() {
            let anew = tree.clip_anew(look, &session.project.catalog, (layer, clip));
            out.extend(anew.map(Command::Edit));
        }
    }
    let (label, help) = match clip {
        Some(clip) => (
            tr!("Unclip"),
            tr!(
                "Shows it where {name} is not, too (Ctrl+Alt+G)",
                name = title_of(session, &clip.base)
            ),
        ),
        None => (
            tr!("Remove mask"),
            tr!("Takes the mask away, with what feeds it alone; the opacity stays").to_owned(),
        ),
    };
    if ui.button(label).on_hover_text(help).clicked() {
        out.extend(stack.unmask(look, layer).map(Command::Edit));
    }
}

/// Shows what can mask a layer: sources, and where other layers are.
fn sources(
    ui: &mut Ui,
    session: &Session,
    (tree, stack): (&LayerTree, &Stack),
    layer: &NodeId,
    out: &mut Vec<Command>,
) {
    let look = session.look();
    for source in &SOURCES {
        if ui.button(source.name.tr()).on_hover_text(source.help.tr()).clicked() {
            let around = sphere_of_lights(session.open_scene());
            let (mask, edit) = stack.mask(look, layer, (source, around));
            let image = node_added(&edit, IMAGE).cloned();
            let reads_colors = node_added(&edit, VERTEX_COLOR).is_some();
            // A picture is what is to be chosen next.
            add(session, (image.clone().unwrap_or(mask), edit), out);
            if let Some(node) = image.map(NodePath::root) {
                out.push(Command::AskImage(Target::Input { node, port: PortName::new(IMAGE) }));
            }
            if reads_colors {
                out.push(Command::Mask(MaskCommand::CheckColors));
            }
        }
    }
    let coverages = tree.coverages(look, &session.project.catalog, layer);
    if !coverages.is_empty() {
        ui.separator();
    }
    for (id, coverage) in coverages {
        let text = match tree.is_folder(&id) {
            true => tr!("Tones in {name}", name = title_of(session, &id)),
            false => tr!("Tone of {name}", name = title_of(session, &id)),
        };
        if ui.button(text).on_hover_text(tr!("Shows it only where that layer is")).clicked() {
            add(session, Stack::mask_by(look, layer, &coverage), out);
        }
    }
}

/// Clips a layer to what is below, or frees it again; leaves one with another mask as it is.
pub(super) fn toggle_clip(
    session: &Session,
    tree: &LayerTree,
    layer: &NodeId,
    out: &mut Vec<Command>,
) {
    let (look, catalog) = (session.look(), &session.project.catalog);
    if tree.clip_of(look, catalog, layer).is_some() {
        let stack = tree.stack_of(layer);
        out.extend(stack.and_then(|stack| stack.unmask(look, layer)).map(Command::Edit));
    } else if mask::is_free(look, catalog, layer)
        && let Some((_, coverage)) = tree.clipping(look, catalog, layer)
    {
        out.push(Command::Edit(Stack::mask_by(look, layer, &coverage).1));
    }
}

/// The first node of a kind that an edit adds.
fn node_added<'e>(edit: &'e Edit, kind: &str) -> Option<&'e NodeId> {
    match edit {
        Edit::Group { edits } => edits.iter().find_map(|edit| node_added(edit, kind)),
        Edit::AddNode { id, node, .. } => (node.kind == kind).then_some(id),
        _ => None,
    }
}

/// Adds a mask, and selects a node of it.
fn add(session: &Session, (mask, edit): (NodeId, Edit), out: &mut Vec<Command>) {
    out.push(Command::Edit(edit));
    select(session, vec![mask], out);
}
