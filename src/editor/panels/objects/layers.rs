//! Lights of single nodes of an object's looks: which reach them there, and which they filter. A
//! row says so for this object alone; without one a node is as its look has it.

use chiaro_locale::{Text, text, tr, tr_in};
use eframe::egui::{CollapsingHeader, Id, RichText, Role, ScrollArea, Ui, WidgetInfo};

use crate::commands::SceneCommand;
use crate::document::{LayerLink, LightSet, Object};
use crate::fields::node_links::{is_filter, is_lit};
use crate::fields::row::labelled;
use crate::ids::{NodeId, ObjectId};
use crate::state::scene::OpenScene;
use crate::state::session::Session;
use crate::widgets::text::{self, hint};

/// Words on how such a set is written, for tooltips.
const SETS: Text = text!(
    "{source} is what the look says: {source} - group:rim takes lights away, {source} | eye adds \
     one. * is every light"
);

/// Row for a set of lights of a node.
struct LayerRow {
    label: Text,
    help: Text,
    set: fn(&mut LayerLink) -> &mut LightSet,
}

const REACH: [LayerRow; 2] = [
    LayerRow {
        label: text!("Reached by"),
        help: text!("Lights that reach it on this object."),
        set: |row| &mut row.layered,
    },
    LayerRow {
        label: text!("Not reached by"),
        help: text!("Lights that do not reach it here all the same."),
        set: |row| &mut row.unlayered,
    },
];

const FILTER: [LayerRow; 2] = [
    LayerRow {
        label: text!("Filters lights"),
        help: text!("Lights that it filters on this object; others pass as if it were not there."),
        set: |row| &mut row.filtered,
    },
    LayerRow {
        label: text!("Lets pass by"),
        help: text!("Lights that it does not filter here all the same."),
        set: |row| &mut row.unfiltered,
    },
];

/// Node of the open look's own graph that lights can be kept from.
struct LitNode {
    id: NodeId,
    name: String,
    is_lit: bool,
    is_filter: bool,
}

fn lit_nodes(session: &Session) -> impl Iterator<Item = LitNode> {
    session.look().graph.nodes.iter().filter_map(|(id, node)| {
        let kind = session.project.catalog.of(node)?;
        let (is_lit, is_filter) = (is_lit(kind, node), is_filter(kind, node));
        let name = match node.name.as_str() {
            "" => format!("{} ({id})", tr_in("node", &kind.label)),
            name => name.to_owned(),
        };
        (is_lit || is_filter).then(|| LitNode { id: id.clone(), name, is_lit, is_filter })
    })
}

/// Shows a block for each node that the object has its own lights for, and the menu that adds one.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    open_scene: &OpenScene,
    (id, object): (&ObjectId, &Object),
    out: &mut Vec<SceneCommand>,
) {
    let nodes: Vec<LitNode> =
        open_scene.wears_open(object).then(|| lit_nodes(session)).into_iter().flatten().collect();
    if nodes.is_empty() && object.layers.is_empty() {
        return;
    }
    let mut change = |widget: Option<Id>, change: &dyn Fn(&mut Vec<LayerLink>)| {
        let edit = open_scene.change(id, |object| change(&mut object.layers));
        out.extend(edit.map(|edit| match widget {
            Some(widget) => SceneCommand::EditHeld(widget, edit),
            None => SceneCommand::Edit(edit),
        }));
    };
    let header = CollapsingHeader::new(tr!("Lights of its layers")).id_salt((id, "layers"));
    header.default_open(!object.layers.is_empty()).show(ui, |ui| {
        for (index, row) in object.layers.iter().enumerate() {
            let node = nodes.iter().find(|node| node.id == row.node);
            ui.push_id(index, |ui| block(ui, row, node, index, &mut change));
        }
        let others = || nodes.iter().filter(|node| object.layers.iter().all(|l| l.node != node.id));
        let menu = ui.menu_button(tr!("Add a layer's lights"), |ui| {
            ScrollArea::vertical().max_height(320.0).show(ui, |ui| {
                for node in others() {
                    if ui.button(&node.name).clicked() {
                        let row = LayerLink::new(node.id.clone());
                        change(None, &|layers| layers.push(row.clone()));
                        ui.close();
                    }
                }
                if others().next().is_none() {
                    hint(
                        ui,
                        tr!("The open look has no other node that names lights or filters them."),
                    );
                }
            });
        });
        menu.response.on_hover_text(tr!(
            "Says for a layer, a group or a filter of the look which lights reach it on this \
             object; other objects keep what the look says"
        ));
    });
}

fn block(
    ui: &mut Ui,
    row: &LayerLink,
    node: Option<&LitNode>,
    index: usize,
    change: &mut impl FnMut(Option<Id>, &dyn Fn(&mut Vec<LayerLink>)),
) {
    let name = node.map_or_else(|| row.node.to_string(), |node| node.name.clone());
    ui.horizontal(|ui| {
        ui.label(RichText::new(&name).strong());
        let label = tr!("{name} as the look has it");
        let help = tr!("Takes these sets away: the layer's lights are as the look says");
        let button = ui.small_button(tr!("As the look has it")).on_hover_text(help);
        button.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
        if button.clicked() {
            change(None, &|layers| drop(layers.remove(index)));
        }
    });
    // A node of a look that is not open may be either.
    let (is_lit, is_filter) = node.map_or((true, true), |node| (node.is_lit, node.is_filter));
    let rows = is_lit.then_some(REACH).into_iter().chain(is_filter.then_some(FILTER)).flatten();
    for LayerRow { label, help, set } in rows {
        let mut now = row.clone();
        let shown = set(&mut now).clone();
        labelled(ui, label.tr(), &format!("{help} {SETS}"), |ui, label| {
            let read = |text: &str| LightSet::parse(text).map_err(|why| why.to_string());
            let found = text::formed(ui, label, &shown, |set| set.text().to_owned(), read);
            if let Some((widget, changed)) = found {
                change(Some(widget), &|layers| *set(&mut layers[index]) = changed.clone());
            }
        });
    }
}
