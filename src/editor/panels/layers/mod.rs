//! The look as a stack of layers, as in a painting program: another view of the graph. Changes here
//! are edits of the nodes and wires, one undo step each; changes of the graph show here.

mod band_bar;
mod masks;
mod picture;
mod presets;
mod row;

use std::collections::HashMap;
use std::sync::Arc;

use eframe::egui;
use eframe::egui::{
    EventFilter, Key, Modifiers, Popup, Rect, Response, RichText, ScrollArea, Stroke, Ui, pos2,
};

use super::thumbs::{Shot, Thumbs, key_on, surroundings_key};
use crate::commands::{Command, PanelId};
use crate::document::{Edit, Endpoint, GraphId, Node, Wire};
use crate::fields::shot::ChangedRow;
use crate::ids::{NodeId, NodePath, make_slug};
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::revision::{DocumentNumber, LookRevision};
use crate::state::session::Session;
use crate::state::stack::{BELOW, Stack};
use crate::state::worker::BackgroundJobs;
use crate::viewport::solo_bar;
use crate::widgets::menu::scrolling;
use crate::widgets::rows::{NameEdit, leave_with_pointer, undo_keys};
use crate::widgets::spots::{self, Spot};
use crate::widgets::text::hint;
use crate::widgets::theme;
use presets::{LayerPreset, PRESETS};
use row::{ROW, Row};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::LAYERS,
    "Layers",
    "The look as a stack of layers: another view of the same graph",
    PanelPlace::WITH_DOCUMENT,
    |bench, ui, context| bench.memory.of::<Layers>().show(ui, context.session, &bench.thumbs),
)
.with_jobs(|bench| &bench.thumbs);

/// The panel, and the stack that it found in the graph.
#[derive(Default)]
pub(crate) struct Layers {
    /// Document and revision that the stack was found in.
    of: Option<(DocumentNumber, LookRevision)>,
    stack: Stack,
    renaming: Option<NameEdit<NodeId>>,
    /// Layer that is being dragged.
    dragged: Option<NodeId>,
    /// Node that was selected when the panel was shown last.
    shown_for: Option<NodeId>,
    pictures: HashMap<NodeId, LayerPicture>,
}

/// Thumbnail of a layer, and the state of the look that it was last found to be right in.
struct LayerPicture {
    of: (DocumentNumber, LookRevision, u64),
    key: u64,
    /// Thumbnail that is shown until the one of `key` is there.
    shown: Option<u64>,
}

impl Layers {
    /// Shows the stack.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session, thumbs: &Thumbs) -> Vec<Command> {
        self.sync(session);
        let mut out = Vec::new();
        self.bar(ui, session, &mut out);
        if !session.view.solo.layers.is_empty() {
            out.extend(solo_bar::show(ui, session));
        }
        if !self.stack.has_output() {
            hint(ui, "The look has no Output node, so that there is nothing to see as layers.");
            return out;
        }
        ui.spacing_mut().item_spacing.y = 2.0;
        let count = self.stack.layers.len();
        let selected =
            session.selection.nodes.last().filter(|id| is_selected(session, id)).cloned();
        let goal = selected
            .as_ref()
            .filter(|_| self.shown_for != selected)
            .and_then(|id| self.stack.index_of(id));
        self.shown_for = selected;
        let area = ScrollArea::vertical().auto_shrink([false, false]).id_salt("layers");
        area.show_viewport(ui, |ui, viewport| {
            let pitch = ROW + ui.spacing().item_spacing.y;
            ui.set_height(pitch * (count + 1) as f32);
            let top = ui.max_rect().top();
            let rect_of = |index: usize, ui: &Ui| {
                let min = pos2(ui.max_rect().left(), top + index as f32 * pitch);
                Rect::from_min_size(min, egui::vec2(ui.available_width() - 8.0, ROW))
            };
            if let Some(index) = goal {
                ui.scroll_to_rect(rect_of(index, ui), None);
            }
            let first = (viewport.top() / pitch).floor().max(0.0) as usize;
            let last = ((viewport.bottom() / pitch).ceil().max(0.0) as usize).min(count + 1);
            let mut rows = Vec::new();
            for index in first..last {
                let rect = rect_of(index, ui);
                if index < count {
                    let id = self.stack.layers[index].id.clone();
                    rows.push((index, self.layer(ui, rect, session, thumbs, &id, &mut out)));
                } else {
                    self.ground(ui, rect, session, thumbs, &mut out);
                }
            }
            for (index, response) in &rows {
                self.row_keys(ui, response, *index, session, &mut out);
            }
            self.drag(ui, top, pitch, &rows, session, &mut out);
        });
        out
    }

    /// Finds the stack anew where the document or its revision has changed.
    fn sync(&mut self, session: &Session) {
        let of = (session.revisions().document, session.revision());
        if self.of != Some(of) {
            if self.of.is_none_or(|old| old.0 != of.0) {
                self.pictures.clear();
                self.renaming = None;
            }
            self.of = Some(of);
            self.stack = Stack::of(session.look(), &session.project.catalog);
            self.dragged = self.dragged.take().filter(|id| self.stack.index_of(id).is_some());
        }
    }

    fn bar(&self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        ui.horizontal(|ui| {
            ui.add_enabled_ui(self.stack.has_output(), |ui| {
                let menu = ui.menu_button("Add layer", |ui| {
                    scrolling(ui, |ui| {
                        for preset in &PRESETS {
                            let button = ui.button(preset.name).on_hover_text(preset.help);
                            let name = || {
                                egui::WidgetInfo::labeled(
                                    egui::Role::MenuItem,
                                    true,
                                    format!("Add {}", preset.name),
                                )
                            };
                            button.widget_info(name);
                            if button.clicked() {
                                add(&self.stack, session, preset, out);
                                ui.close();
                            }
                        }
                    });
                });
                spots::note(ui, Spot::AddLayer, menu.response.rect);
                menu.response.on_hover_text("Puts a layer over the selected one, or on top of all");
            });
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let count = self.stack.layers.len();
                let text = format!("{count} {}", if count == 1 { "layer" } else { "layers" });
                let help = "The uppermost is laid on last, as in a painting program.\nDrag rows to \
                            reorder; Alt and an arrow key move the one with the keyboard.";
                ui.label(RichText::new(text).color(theme::of(ui).dim)).on_hover_text(help);
            });
        });
        ui.add_space(2.0);
    }

    fn layer(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        session: &Session,
        thumbs: &Thumbs,
        id: &NodeId,
        out: &mut Vec<Command>,
    ) -> Response {
        let Some((node, kind)) = session
            .look()
            .graph
            .nodes
            .get(id)
            .and_then(|node| Some((node, session.project.catalog.of(node)?)))
        else {
            return ui.allocate_rect(rect, egui::Sense::hover());
        };
        let row = Row { session, id, node, kind };
        let mode = row.mode().unwrap_or_default();
        let texture = self.texture(ui, session, thumbs, id, Some(&mode));
        let is_dragged = self.dragged.as_ref() == Some(id);
        let shown = row.show(ui, rect, texture, is_dragged, &mut self.renaming, out);
        let mut act = |ui: &mut Ui| self.menu(ui, session, id, out);
        Popup::menu(&shown.more).show(&mut act);
        Popup::context_menu(&shown.whole).show(&mut act);
        shown.whole
    }

    /// Shows the menu of a layer.
    fn menu(&mut self, ui: &mut Ui, session: &Session, id: &NodeId, out: &mut Vec<Command>) {
        let Some(index) = self.stack.index_of(id) else { return };
        ChangedRow::of_node(session, &NodePath::root(id.clone())).menu(ui, out);
        let entry = |ui: &mut Ui, label: &str, help: &str, is_on: bool| {
            ui.add_enabled(is_on, egui::Button::new(label)).on_hover_text(help).clicked()
        };
        if entry(ui, "Rename layer", "F2, or a double click on the name", true) {
            self.rename(session, id);
        }
        if entry(ui, "Duplicate layer", "Puts a copy over it (Ctrl+D)", true) {
            self.duplicate(session, index, out);
        }
        if entry(ui, "Move layer up", "Lays it on later (Alt+Up)", index > 0) {
            self.move_by(session, index, -1, out);
        }
        if entry(
            ui,
            "Move layer down",
            "Lays it on earlier (Alt+Down)",
            index + 1 < self.stack.layers.len(),
        ) {
            self.move_by(session, index, 1, out);
        }
        if entry(ui, "Show on the canvas", "Brings its node into view", true) {
            out.push(Command::Show(crate::ids::NodePath::root(id.clone())));
        }
        ui.separator();
        masks::menu(ui, session, &self.stack, id, out);
        ui.separator();
        if entry(ui, "Delete layer", "Takes it out; the others close up (Del)", true) {
            out.push(Command::Edit(self.stack.remove(session.look(), std::slice::from_ref(id))));
        }
    }

    fn rename(&mut self, session: &Session, id: &NodeId) {
        let name = session.look().graph.nodes.get(id).map_or("", |node| &node.name);
        self.renaming = Some(NameEdit::new(id.clone(), name));
    }

    fn duplicate(&self, session: &Session, index: usize, out: &mut Vec<Command>) {
        if let Some((id, edit)) = self.stack.duplicate(session.look(), index) {
            out.push(Command::Edit(edit));
            select(session, vec![id], out);
        }
    }

    fn move_by(&self, session: &Session, index: usize, by: isize, out: &mut Vec<Command>) {
        let Some(to) = index.checked_add_signed(by) else { return };
        out.extend(self.stack.reorder(session.look(), index, to).map(Command::Edit));
    }

    /// Handles the keys of the row that has the focus.
    fn row_keys(
        &mut self,
        ui: &Ui,
        response: &Response,
        index: usize,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        leave_with_pointer(ui, response);
        if !response.has_focus() {
            return;
        }
        let filter = EventFilter { vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
        let id = self.stack.layers[index].id.clone();
        for (key, by) in [(Key::ArrowUp, -1), (Key::ArrowDown, 1)] {
            if pressed(Modifiers::ALT, key) {
                self.move_by(session, index, by, out);
            } else if pressed(Modifiers::NONE, key)
                && let Some(next) =
                    index.checked_add_signed(by).and_then(|next| self.stack.layers.get(next))
            {
                select(session, vec![next.id.clone()], out);
                ui.memory_mut(|memory| memory.request_focus(row::focus_id(&next.id)));
            }
        }
        if pressed(Modifiers::NONE, Key::F2) {
            self.rename(session, &id);
        }
        if pressed(Modifiers::COMMAND, Key::D) {
            self.duplicate(session, index, out);
        }
        if pressed(Modifiers::NONE, Key::Delete) || pressed(Modifiers::NONE, Key::Backspace) {
            // Delete removes all selected layers, if this one is among them.
            let selected: Vec<NodeId> = session
                .selection
                .nodes()
                .filter(|id| self.stack.index_of(id).is_some())
                .cloned()
                .collect();
            let ids = if selected.contains(&id) { selected } else { vec![id] };
            out.push(Command::Edit(self.stack.remove(session.look(), &ids)));
        }
        undo_keys(ui, out);
    }

    /// Handles the drag of a row; a line marks the place where the layer would lie.
    fn drag(
        &mut self,
        ui: &Ui,
        top: f32,
        pitch: f32,
        rows: &[(usize, Response)],
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        if let Some((index, _)) = rows.iter().find(|(_, response)| response.drag_started()) {
            self.dragged = Some(self.stack.layers[*index].id.clone());
        }
        let Some(from) = self.dragged.as_ref().and_then(|id| self.stack.index_of(id)) else {
            return;
        };
        if ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
            self.dragged = None;
            return;
        }
        let Some(at) = ui.input(|input| input.pointer.latest_pos()) else { return };
        let count = self.stack.layers.len();
        let gap = (((at.y - top) / pitch).round().max(0.0) as usize).min(count);
        let to = if gap > from { gap - 1 } else { gap };
        if to != from {
            let y = top + gap as f32 * pitch - 1.0;
            let stroke = Stroke::new(2.0, theme::of(ui).accent);
            ui.painter().hline(ui.max_rect().left()..=ui.max_rect().right() - 8.0, y, stroke);
        }
        ui.ctx().set_cursor_icon(egui::CursorIcon::Grabbing);
        if ui.input(|input| !input.pointer.primary_down()) {
            self.dragged = None;
            out.extend(self.stack.reorder(session.look(), from, to).map(Command::Edit));
        }
    }

    /// Shows the ground that the lowest layer lies on.
    fn ground(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        session: &Session,
        thumbs: &Thumbs,
        out: &mut Vec<Command>,
    ) {
        let Some(ground) = self.stack.ground.clone() else {
            let mut child = ui.new_child(
                egui::UiBuilder::new()
                    .max_rect(rect)
                    .layout(egui::Layout::left_to_right(egui::Align::Center)),
            );
            child.label(RichText::new("Nothing lies below").color(theme::of(ui).warning));
            let help = "Adds a Base node: the color under the first layer";
            if child.button("Add a base").on_hover_text(help).clicked()
                && let Some(to) = self.stack.lowest_inlet()
            {
                out.push(Command::Edit(Edit::Group { edits: add_ground(session, to.clone()) }));
            }
            return;
        };
        let Some(node) = session.look().graph.nodes.get(&ground.node) else { return };
        let Some(kind) = session.project.catalog.of(node) else {
            let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
            let text = format!("The stack ends here: there is no node of kind \"{}\".", node.kind);
            child.label(RichText::new(text).color(theme::of(ui).error));
            if child
                .link(format!("Show {}", ground.node))
                .on_hover_text("Selects the node and brings it into view")
                .clicked()
            {
                out.push(Command::Show(crate::ids::NodePath::root(ground.node)));
            }
            return;
        };
        let texture = self.texture(ui, session, thumbs, &ground.node, None);
        Row { session, id: &ground.node, node, kind }.show_ground(ui, rect, texture, out);
    }

    /// Thumbnail of a layer, if there is one; requests it once the window rests.
    fn texture(
        &mut self,
        ui: &Ui,
        session: &Session,
        thumbs: &Thumbs,
        id: &NodeId,
        mode: Option<&str>,
    ) -> Option<egui::TextureId> {
        let now = (session.revisions().document, session.revision(), surroundings_key(session));
        let seen = self.pictures.get(id);
        let is_known = seen.is_some_and(|seen| seen.of == now && thumbs.is_done(seen.key));
        if !is_known {
            thumbs.look_again(ui);
        }
        // One thumbnail at a time: while one is being drawn, preparing the next gains nothing.
        if !is_known && thumbs.rests() && !thumbs.is_busy() && session.journals.held().is_none() {
            let look = picture::of(session.look(), id, mode);
            let lifts = mode.is_some_and(|mode| mode == "add" || mode.is_empty());
            let shot = if lifts { Shot::Lifted } else { Shot::Near };
            let side = (row::PICTURE - 2.0) * ui.pixels_per_point();
            let key = key_on(&look, shot, side, session);
            let shown = seen.and_then(|seen| seen.shown);
            self.pictures.insert(id.clone(), LayerPicture { of: now, key, shown });
            if !thumbs.is_done(key) {
                let what = (Arc::new(look), session.look.folder());
                thumbs.ask(key, || session.shown_origin(), what, session, shot, side);
            }
        }
        let seen = self.pictures.get_mut(id)?;
        if thumbs.is_done(seen.key) {
            seen.shown = Some(seen.key);
        }
        thumbs.known(seen.shown?)
    }
}

/// Commands that add a layer of the preset with this name, as the menu does.
pub(crate) fn add_preset(session: &Session, name: &str) -> Vec<Command> {
    let mut out = Vec::new();
    if let Some(preset) = PRESETS.iter().find(|preset| preset.name == name) {
        add(&Stack::of(session.look(), &session.project.catalog), session, preset, &mut out);
    }
    out
}

/// Adds a layer over the selected one, and a ground below it where there is none.
fn add(stack: &Stack, session: &Session, preset: &LayerPreset, out: &mut Vec<Command>) {
    let look = session.look();
    let beside = session
        .selection
        .nodes
        .last()
        .filter(|id| is_selected(session, id) && stack.index_of(id).is_some());
    let at = match beside.and_then(|id| stack.index_of(id)) {
        Some(index) => index,
        // A new layer goes directly over the ground, where the ground is selected.
        None if stack
            .ground
            .as_ref()
            .is_some_and(|ground| session.selection.nodes.last() == Some(&ground.node)) =>
        {
            stack.layers.len()
        }
        None => 0,
    };
    let (first, id, node) = preset.make(session, beside);
    let place = stack.insert(look, at, &id, node);
    let mut edits = place;
    edits.extend(first);
    if stack.ground.is_none() && at == stack.layers.len() {
        edits.extend(add_ground(session, Endpoint::new(id.clone(), BELOW)));
    }
    out.push(Command::Edit(Edit::Group { edits }));
    out.push(Command::Show(NodePath::root(id)));
}

/// Edits that add a Base node for an input that has no wire.
fn add_ground(session: &Session, to: Endpoint) -> Vec<Edit> {
    let look = session.look();
    let id = NodeId::new(make_slug("base", |slug| look.graph.nodes.contains_key(slug)));
    let lowest = look.graph.nodes.get(&to.node).map_or([0.0; 2], |node| node.position);
    let node = Node {
        kind: "base".to_owned(),
        position: [lowest[0] - 260.0, lowest[1]],
        ..Node::default()
    };
    let wire = Wire { from: Endpoint::new(id.clone(), BELOW), to };
    vec![
        Edit::AddNode { graph: GraphId::Look, id, node, index: None },
        Edit::AddWire { graph: GraphId::Look, wire, index: None },
    ]
}

/// Names of the input that sets a layer's blend mode.
const MODES: [&str; 2] = ["blend", "mode"];

/// Selects nodes of the look's own graph, which is opened first where a group's is open.
fn select(session: &Session, ids: Vec<NodeId>, out: &mut Vec<Command>) {
    if !session.selection.open_groups().is_empty() {
        out.push(Command::OpenGraph(Vec::new()));
    }
    out.push(Command::Select(ids));
}

/// True if a node of the look's own graph is selected.
fn is_selected(session: &Session, id: &NodeId) -> bool {
    session.selection.open_groups().is_empty() && session.selection.nodes.contains(id)
}
