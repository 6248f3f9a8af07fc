//! The look as a stack of layers, as in a painting program: another view of the graph. Changes here
//! are edits of the nodes and wires, one undo step each; changes of the graph show here.

mod band_bar;
mod clipboard;
mod cost;
mod drop;
mod masks;
mod picture;
mod presets;
mod row;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::{text, tr, trn};
use eframe::egui;
use eframe::egui::{
    EventFilter, Key, Label, Modifiers, Popup, Rect, Response, RichText, ScrollArea, Stroke, Ui,
    pos2,
};

use super::thumbs::{Shot, Thumbs, key_on, surroundings_key};
use crate::commands::{Command, LibraryCommand, PanelId};
use crate::document::{ColorSpace, Edit, Endpoint, GraphId, Node, Wire};
use crate::fields::shot::ChangedRow;
use crate::ids::{NodeId, NodePath, make_slug};
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::parts::saving::PartChoice;
use crate::state::picture_cost::PictureCost;
use crate::state::revision::{DocumentNumber, LookRevision};
use crate::state::session::Session;
use crate::state::stack::owners::LayerOwners;
use crate::state::stack::tree::{LayerPlace, LayerTree, TreeRow};
use crate::state::stack::{BELOW, normals};
use crate::state::worker::BackgroundJobs;
use crate::values;
use crate::viewport::picture::ViewportPicture;
use crate::viewport::solo_bar;
use crate::widgets::menu::scrolling;
use crate::widgets::rows::{NameEdit, leave_with_pointer, undo_keys};
use crate::widgets::spots::{self, Spot};
use crate::widgets::text::hint;
use crate::widgets::theme;
use cost::LayerShares;
use drop::DropTarget;
use presets::PRESETS;
pub(crate) use presets::{LayerPreset, preset_parts};
use row::{FolderRow, ROW, Row};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::LAYERS,
    text!("Layers"),
    text!("The look as a stack of layers: another view of the same graph"),
    PanelPlace::WITH_DOCUMENT,
    |bench, ui, context| {
        let cost = bench.picture.as_ref().map(ViewportPicture::cost);
        let layers = bench.memory.of::<Layers>();
        layers.show(ui, context.session, (&bench.thumbs, cost))
    },
)
.with_jobs(|bench| &bench.thumbs);

/// Least width of the number of layers beside the button, in points.
const LEAST_COUNT: f32 = 44.0;

/// The panel, and the layers that it found in the graph.
#[derive(Default)]
pub(crate) struct Layers {
    /// Document and revision that the layers were found in.
    of: Option<(DocumentNumber, LookRevision)>,
    tree: LayerTree,
    owners: LayerOwners,
    shares: LayerShares,
    /// Layers that are listed.
    rows: Vec<TreeRow>,
    /// Folders whose layers are not listed.
    closed: HashSet<NodeId>,
    /// Folder that is closed or opened once all rows are shown.
    folding: Option<(NodeId, bool)>,
    renaming: Option<NameEdit<NodeId>>,
    /// Layers that are being dragged.
    dragged: Vec<NodeId>,
    /// True from *Paste above* until the clipboard's text is there: the row keeps the keyboard.
    is_pasting: bool,
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
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        (thumbs, cost): (&Thumbs, Option<&PictureCost>),
    ) -> Vec<Command> {
        self.sync(session);
        if let Some(cost) = cost {
            self.shares.update(cost, &self.owners);
        }
        let mut out = Vec::new();
        self.bar(ui, session, &mut out);
        if !session.view.solo.layers.is_empty() {
            out.extend(solo_bar::show(ui, session));
        }
        if !self.tree.has_output() {
            hint(
                ui,
                tr!("The look has no Output node, so that there is nothing to see as layers."),
            );
            return out;
        }
        ui.spacing_mut().item_spacing.y = 2.0;
        let goal = self.reveal_selected(session);
        let count = self.rows.len();
        let area = ScrollArea::vertical().auto_shrink([false, false]).id_salt("layers");
        area.show_viewport(ui, |ui, viewport| {
            let pitch = ROW + ui.spacing().item_spacing.y;
            ui.set_height(pitch * (count + 1) as f32);
            let top = ui.max_rect().top();
            let rect_of = |index: usize, depth: usize, ui: &Ui| {
                let indent = row::indent(depth, ui.available_width());
                let min = pos2(ui.max_rect().left() + indent, top + index as f32 * pitch);
                Rect::from_min_size(min, egui::vec2(ui.available_width() - 8.0 - indent, ROW))
            };
            if let Some(index) = goal {
                ui.scroll_to_rect(rect_of(index, 0, ui), None);
            }
            let first = (viewport.top() / pitch).floor().max(0.0) as usize;
            let last = ((viewport.bottom() / pitch).ceil().max(0.0) as usize).min(count + 1);
            let mut rows = Vec::new();
            for index in first..last {
                match self.rows.get(index).cloned() {
                    Some(row) => {
                        let rect = rect_of(index, row.depth, ui);
                        let shown = (thumbs, cost);
                        rows.push((index, self.layer(ui, rect, session, shown, &row, &mut out)));
                    }
                    None => self.ground(ui, rect_of(index, 0, ui), session, thumbs, &mut out),
                }
            }
            for (index, response) in &rows {
                self.row_keys(ui, response, *index, session, &mut out);
            }
            self.drag(ui, (top, pitch), &rows, session, &mut out);
        });
        if let Some((id, is_closed)) = self.folding.take() {
            self.fold(&id, is_closed);
            ui.request_repaint();
        }
        out
    }

    /// Opens the folders around the layer that was selected since the panel was shown last. Returns
    /// the number of the layer's row.
    fn reveal_selected(&mut self, session: &Session) -> Option<usize> {
        let selected =
            session.selection.nodes.last().filter(|id| is_selected(session, id)).cloned();
        if self.shown_for == selected {
            return None;
        }
        self.shown_for.clone_from(&selected);
        let id = selected?;
        let around = self.tree.folders_around(&id);
        if around.iter().any(|folder| self.closed.contains(folder)) {
            self.closed.retain(|folder| !around.contains(folder));
            self.list();
        }
        self.rows.iter().position(|row| row.id == id)
    }

    /// Finds the layers anew where the document or its revision has changed.
    fn sync(&mut self, session: &Session) {
        let of = (session.revisions().document, session.revision());
        if self.of != Some(of) {
            if self.of.is_none_or(|old| old.0 != of.0) {
                self.pictures.clear();
                self.closed.clear();
                self.renaming = None;
            }
            self.of = Some(of);
            self.tree = LayerTree::of(session.look(), &session.project.catalog);
            self.owners = LayerOwners::of(session.look(), &self.tree);
            self.shares.forget();
            self.dragged.retain(|id| self.tree.contains(id));
            self.closed.retain(|id| self.tree.is_folder(id));
            self.list();
        }
    }

    fn list(&mut self) {
        self.rows = self.tree.rows(|id| self.closed.contains(id));
    }

    fn bar(&self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        ui.horizontal(|ui| {
            ui.add_enabled_ui(self.tree.has_output(), |ui| {
                let menu = ui.menu_button(tr!("Add layer"), |ui| {
                    scrolling(ui, |ui| {
                        for preset in &PRESETS {
                            let name = preset.name.tr();
                            let button = ui.button(name).on_hover_text(preset.help.tr());
                            let info = || {
                                egui::WidgetInfo::labeled(
                                    egui::Role::MenuItem,
                                    true,
                                    tr!("Add {name}"),
                                )
                            };
                            button.widget_info(info);
                            if button.clicked() {
                                out.extend(add(session, preset));
                                ui.close();
                            }
                        }
                        ui.separator();
                        let help =
                            tr!("An empty folder for layers: they are hidden, masked, faded and \
                                 moved together");
                        if ui.button(tr!("New folder")).on_hover_text(help).clicked() {
                            let place = place_for_new(&self.tree, session);
                            let (id, edit) = self.tree.add_folder(session.look(), &place);
                            out.push(Command::Edit(edit));
                            select(session, vec![id], out);
                            ui.close();
                        }
                    });
                });
                spots::note(ui, Spot::AddLayer, menu.response.rect);
                menu.response
                    .on_hover_text(tr!("Puts a layer over the selected one, or on top of all"));
            });
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let count = self.tree.len();
                let text = trn!(count, "{count} layer", "{count} layers");
                let help =
                    tr!("The uppermost is laid on last, as in a painting program.\nDrag rows to \
                         reorder, or into a folder; Alt and an arrow key move the one with the \
                         keyboard. Ctrl and Shift select several, which are hidden, faded, moved \
                         and deleted together.");
                // Without room it would lie over the button.
                if ui.available_width() > LEAST_COUNT {
                    let label = Label::new(RichText::new(text).color(theme::of(ui).dim));
                    ui.add(label.truncate()).on_hover_text(help);
                }
            });
        });
        ui.add_space(2.0);
    }

    fn layer(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        session: &Session,
        (thumbs, cost): (&Thumbs, Option<&PictureCost>),
        row: &TreeRow,
        out: &mut Vec<Command>,
    ) -> Response {
        let id = &row.id;
        let Some((node, kind)) = session
            .look()
            .graph
            .nodes
            .get(id)
            .and_then(|node| Some((node, session.project.catalog.of(node)?)))
        else {
            return ui.allocate_rect(rect, egui::Sense::hover());
        };
        let acting = self.acting(session, id);
        let is_closed = self.closed.contains(id);
        let folder = row.is_folder.then_some(FolderRow { is_closed });
        let (rows, tree) = (&self.rows[..], &self.tree);
        let cost = cost.map(|cost| self.shares.cost_of(cost, tree, (id, is_closed)));
        let shown_row = Row { session, id, node, kind, tree, rows, acting: &acting, folder, cost };
        let mode = shown_row.mode().unwrap_or_else(|| match row.is_folder {
            true => "alpha".to_owned(),
            false => String::new(),
        });
        let mode = (!self.tree.is_adjustment(id)).then_some(mode);
        let texture = texture(&mut self.pictures, ui, session, thumbs, id, mode.as_deref());
        let is_dragged = self.dragged.contains(id);
        let shown = shown_row.show(ui, rect, texture, is_dragged, &mut self.renaming, out);
        if shown.is_fold_toggled {
            self.folding = Some((id.clone(), !is_closed));
        }
        let mut act = |ui: &mut Ui| self.menu(ui, session, id, out);
        Popup::menu(&shown.more).show(&mut act);
        Popup::context_menu(&shown.whole).show(&mut act);
        shown.whole
    }

    /// Layers that an action on a row is for: all selected ones, if the row's is among them.
    fn acting(&self, session: &Session, id: &NodeId) -> Vec<NodeId> {
        let is_one = is_selected(session, id);
        let selected = session.selection.nodes().filter(|id| is_one && self.tree.contains(id));
        let all: Vec<NodeId> = selected.cloned().collect();
        if all.len() > 1 { all } else { vec![id.clone()] }
    }

    /// Lists the layers in a folder, or no longer.
    fn fold(&mut self, id: &NodeId, is_closed: bool) {
        if is_closed {
            self.closed.insert(id.clone());
        } else {
            self.closed.remove(id);
        }
        self.list();
    }

    /// Shows the menu of a layer, or of all that are selected.
    fn menu(&mut self, ui: &mut Ui, session: &Session, id: &NodeId, out: &mut Vec<Command>) {
        let acting = self.acting(session, id);
        let is_one = acting.len() == 1;
        ChangedRow::of_node(session, &NodePath::root(id.clone())).menu(ui, out);
        let entry = |ui: &mut Ui, label: &str, help: &str, is_on: bool| {
            ui.add_enabled(is_on, egui::Button::new(label)).on_hover_text(help).clicked()
        };
        if entry(ui, tr!("Rename layer"), tr!("F2, or a double click on the name"), true) {
            self.rename(session, id);
        }
        if entry(
            ui,
            if is_one { tr!("Duplicate layer") } else { tr!("Duplicate layers") },
            tr!("Puts a copy over it (Ctrl+D)"),
            true,
        ) {
            self.duplicate(session, id, out);
        }
        self.copy_entries(ui, session, id, out);
        let can = |is_up| self.tree.beside(&acting, is_up, |id| self.closed.contains(id)).is_some();
        if entry(
            ui,
            if is_one { tr!("Move layer up") } else { tr!("Move layers up") },
            tr!("Lays it on later (Alt+Up)"),
            can(true),
        ) {
            self.move_by(session, id, true, out);
        }
        if entry(
            ui,
            if is_one { tr!("Move layer down") } else { tr!("Move layers down") },
            tr!("Lays it on earlier (Alt+Down)"),
            can(false),
        ) {
            self.move_by(session, id, false, out);
        }
        if entry(ui, tr!("Save to the library…"), tr!("So that other looks can have it"), true) {
            let choice = PartChoice::Layers(vec![id.clone()]);
            out.push(Command::Library(LibraryCommand::Offer(choice)));
        }
        let graph = &session.look().graph;
        let kind = graph.nodes.get(id).and_then(|node| session.project.catalog.of(node));
        let help = tr!("Puts a Smooth normal node before it, so that rough scans are lit calmly");
        if kind.is_some_and(|kind| normals::are_plain(graph, kind, id))
            && entry(ui, tr!("Smooth normals"), help, true)
        {
            out.push(Command::Edit(normals::smooth(graph, &GraphId::Look, id)));
        }
        if entry(ui, tr!("Show on the canvas"), tr!("Brings its node into view"), true) {
            out.push(Command::Show(crate::ids::NodePath::root(id.clone())));
        }
        ui.separator();
        let help =
            tr!("They lie on what is below as before, and are hidden, masked and faded together \
                 (Ctrl+G)");
        if entry(ui, tr!("Put into a new folder"), help, true) {
            self.group(session, id, out);
        }
        if self.tree.is_folder(id) {
            let help = tr!("Leaves its layers in its place (Ctrl+Shift+G)");
            if entry(ui, tr!("Take the folder away"), help, true) {
                out.extend(self.tree.ungroup(session.look(), &acting).map(Command::Edit));
            }
        }
        ui.separator();
        if !self.tree.is_adjustment(id) {
            masks::menu(ui, session, &self.tree, id, out);
            ui.separator();
        }
        let help = tr!("Takes it out; the others close up (Del)");
        if entry(ui, if is_one { tr!("Delete layer") } else { tr!("Delete layers") }, help, true) {
            out.push(Command::Edit(self.tree.remove(session.look(), &acting)));
        }
    }

    /// Shows the entries of a layer's menu that copy it, and lay a copied one over it.
    fn copy_entries(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        id: &NodeId,
        out: &mut Vec<Command>,
    ) {
        let acting = self.acting(session, id);
        let label = if acting.len() == 1 { tr!("Copy layer") } else { tr!("Copy layers") };
        let help = tr!("With all that feeds it, for this look or another (Ctrl+C)");
        if ui.button(label).on_hover_text(help).clicked() {
            clipboard::copy(session, &acting, out);
        }
        let help = tr!("Lays what was copied over it (Ctrl+V)");
        if ui.button(tr!("Paste above")).on_hover_text(help).clicked() {
            select(session, vec![id.clone()], out);
            // The text comes as a key would, to the row that has the keyboard.
            ui.memory_mut(|memory| memory.request_focus(row::focus_id(id)));
            ui.send_viewport_cmd(egui::ViewportCommand::RequestPaste);
            self.is_pasting = true;
        }
    }

    fn rename(&mut self, session: &Session, id: &NodeId) {
        let name = session.look().graph.nodes.get(id).map_or("", |node| &node.name);
        self.renaming = Some(NameEdit::new(id.clone(), name));
    }

    fn duplicate(&self, session: &Session, id: &NodeId, out: &mut Vec<Command>) {
        let acting = self.acting(session, id);
        if let Some((ids, edit)) = self.tree.duplicate(session.look(), &acting) {
            out.push(Command::Edit(edit));
            select(session, ids, out);
        }
    }

    fn group(&self, session: &Session, id: &NodeId, out: &mut Vec<Command>) {
        if let Some((id, edit)) = self.tree.group(session.look(), &self.acting(session, id)) {
            out.push(Command::Edit(edit));
            select(session, vec![id], out);
        }
    }

    fn move_by(&self, session: &Session, id: &NodeId, is_up: bool, out: &mut Vec<Command>) {
        let acting = self.acting(session, id);
        let place = self.tree.beside(&acting, is_up, |id| self.closed.contains(id));
        let edit = place.and_then(|place| self.tree.move_to(session.look(), &acting, &place));
        out.extend(edit.map(Command::Edit));
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
        // The menu of *Paste above* may lie beside the panel, and the pointer with it.
        self.is_pasting &= !ui.input(|input| input.pointer.any_pressed());
        if !self.is_pasting {
            leave_with_pointer(ui, response);
        }
        if !response.has_focus() {
            return;
        }
        let filter = EventFilter {
            vertical_arrows: true,
            horizontal_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
        let Some(TreeRow { id, is_folder, place, .. }) = self.rows.get(index).cloned() else {
            return;
        };
        let go_to = |id: &NodeId, out: &mut Vec<Command>| {
            select(session, vec![id.clone()], out);
            ui.memory_mut(|memory| memory.request_focus(row::focus_id(id)));
        };
        for (key, by) in [(Key::ArrowUp, -1), (Key::ArrowDown, 1)] {
            if pressed(Modifiers::ALT, key) {
                self.move_by(session, &id, by < 0, out);
            } else if pressed(Modifiers::NONE, key)
                && let Some(next) =
                    index.checked_add_signed(by).and_then(|next| self.rows.get(next))
            {
                go_to(&next.id, out);
            }
        }
        if pressed(Modifiers::NONE, Key::ArrowLeft) {
            match place.folder.as_ref().filter(|_| !is_folder || self.closed.contains(&id)) {
                Some(folder) => go_to(folder, out),
                None if is_folder => self.folding = Some((id.clone(), true)),
                None => {}
            }
        }
        if pressed(Modifiers::NONE, Key::ArrowRight) && is_folder {
            self.folding = Some((id.clone(), false));
        }
        if pressed(Modifiers::NONE, Key::F2) {
            self.rename(session, &id);
        }
        if pressed(Modifiers::COMMAND, Key::D) {
            self.duplicate(session, &id, out);
        }
        let acting = self.acting(session, &id);
        if pressed(Modifiers::COMMAND | Modifiers::ALT, Key::G) {
            masks::toggle_clip(session, &self.tree, &id, out);
        } else if pressed(Modifiers::COMMAND | Modifiers::SHIFT, Key::G) {
            out.extend(self.tree.ungroup(session.look(), &acting).map(Command::Edit));
        } else if pressed(Modifiers::COMMAND, Key::G) {
            self.group(session, &id, out);
        }
        let is_cut = clipboard::handle(ui, session, &acting, out);
        let is_deleted =
            pressed(Modifiers::NONE, Key::Delete) || pressed(Modifiers::NONE, Key::Backspace);
        if is_cut || is_deleted {
            out.push(Command::Edit(self.tree.remove(session.look(), &acting)));
        }
        out.extend(is_cut.then(|| Command::Tell(clipboard::told(session, &acting))));
        undo_keys(ui, out);
    }

    /// Handles the drag of rows; a line marks the place where they would lie.
    fn drag(
        &mut self,
        ui: &Ui,
        (top, pitch): (f32, f32),
        rows: &[(usize, Response)],
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        if let Some((index, _)) = rows.iter().find(|(_, response)| response.drag_started()) {
            let id = self.rows.get(*index).map(|row| row.id.clone());
            self.dragged = id.map_or_else(Vec::new, |id| self.acting(session, &id));
        }
        if self.dragged.is_empty() {
            return;
        }
        if ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
            self.dragged.clear();
            return;
        }
        let Some(at) = ui.input(|input| input.pointer.latest_pos()) else { return };
        let target = DropTarget::at((at.y - top) / pitch, &self.rows, &self.closed, &self.tree);
        let edit = self.tree.move_to(session.look(), &self.dragged, &target.place);
        if edit.is_some() {
            let stroke = Stroke::new(2.0, theme::of(ui).accent);
            let left = ui.max_rect().left();
            let x = (left + row::indent(target.depth, ui.available_width()))
                ..=(ui.max_rect().right() - 8.0);
            let y = top + target.line as f32 * pitch;
            if target.is_within {
                let rect = Rect::from_x_y_ranges(x, y..=(y + ROW));
                ui.painter().rect_stroke(rect, 4.0, stroke, egui::StrokeKind::Inside);
            } else {
                ui.painter().hline(x, y - 1.0, stroke);
            }
        }
        ui.ctx().set_cursor_icon(egui::CursorIcon::Grabbing);
        if ui.input(|input| !input.pointer.primary_down()) {
            self.dragged.clear();
            out.extend(edit.map(Command::Edit));
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
        let Some(ground) = self.tree.own().ground.clone() else {
            let mut child = ui.new_child(
                egui::UiBuilder::new()
                    .max_rect(rect)
                    .layout(egui::Layout::left_to_right(egui::Align::Center)),
            );
            child.label(RichText::new(tr!("Nothing lies below")).color(theme::of(ui).warning));
            let help = tr!("Adds a Base node: the color under the first layer");
            if child.button(tr!("Add a base")).on_hover_text(help).clicked()
                && let Some(to) = self.tree.own().lowest_inlet()
            {
                out.push(Command::Edit(Edit::Group { edits: add_ground(session, to.clone()) }));
            }
            return;
        };
        let Some(node) = session.look().graph.nodes.get(&ground.node) else { return };
        let Some(kind) = session.project.catalog.of(node) else {
            let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
            let text =
                tr!("The stack ends here: there is no node of kind \"{kind}\".", kind = node.kind);
            child.label(RichText::new(text).color(theme::of(ui).error));
            if child
                .link(tr!("Show {node}", node = ground.node))
                .on_hover_text(tr!("Selects the node and brings it into view"))
                .clicked()
            {
                out.push(Command::Show(crate::ids::NodePath::root(ground.node)));
            }
            return;
        };
        let texture = texture(&mut self.pictures, ui, session, thumbs, &ground.node, None);
        let (tree, rows, id) = (&self.tree, &self.rows[..], &ground.node);
        let row =
            Row { session, id, node, kind, tree, rows, acting: &[], folder: None, cost: None };
        row.show_ground(ui, rect, texture, out);
    }
}

/// Thumbnail of a layer, if there is one; requests it once the window rests.
fn texture(
    pictures: &mut HashMap<NodeId, LayerPicture>,
    ui: &Ui,
    session: &Session,
    thumbs: &Thumbs,
    id: &NodeId,
    mode: Option<&str>,
) -> Option<egui::TextureId> {
    let now = (session.revisions().document, session.revision(), surroundings_key(session));
    let seen = pictures.get(id);
    let is_known = seen.is_some_and(|seen| seen.of == now && thumbs.is_done(seen.key));
    if !is_known {
        thumbs.look_again(ui);
    }
    // One thumbnail at a time: while one is being drawn, preparing the next gains nothing.
    if !is_known && thumbs.rests() && !thumbs.is_busy() && session.journals.held().is_none() {
        let look = picture::of(session.look(), id, mode, is_dark(session, id));
        let lifts = mode.is_some_and(|mode| mode == "add" || mode.is_empty());
        let shot = if lifts { Shot::Lifted } else { Shot::Near };
        let side = (row::PICTURE - 2.0) * ui.pixels_per_point();
        let key = key_on(&look, shot, side, session);
        let shown = seen.and_then(|seen| seen.shown);
        pictures.insert(id.clone(), LayerPicture { of: now, key, shown });
        if !thumbs.is_done(key) {
            let what = (Arc::new(look), session.look.folder());
            thumbs.ask(key, || session.shown_origin(), what, session, shot, side);
        }
    }
    let seen = pictures.get_mut(id)?;
    if thumbs.is_done(seen.key) {
        seen.shown = Some(seen.key);
    }
    thumbs.known(seen.shown?)
}

/// True for a layer of one color that is not seen on a dark ground.
fn is_dark(session: &Session, id: &NodeId) -> bool {
    let color = session.look().graph.nodes.get(id).and_then(|node| {
        let kind = session.project.catalog.of(node)?;
        let port = &kind.inputs[kind.input("color")?];
        values::current(port, node.values.get(&port.name))?.color_in(ColorSpace::Display)
    });
    color.is_some_and(|[r, g, b, _]| r.max(g).max(b) < DARK)
}

/// Commands that add a layer of the preset with this name, as the menu does.
pub(crate) fn add_preset(session: &Session, name: &str) -> Vec<Command> {
    let preset = PRESETS.iter().find(|preset| preset.name.english() == name);
    preset.map(|preset| add(session, preset)).unwrap_or_default()
}

/// Commands that add a new node as a layer: over the selected layer, into the selected folder, or
/// on top of all; with a ground below it where there is none. The edits `first` are of the same
/// step.
pub(crate) fn insert_layer(
    session: &Session,
    (first, id, node): (Vec<Edit>, NodeId, Node),
) -> Vec<Command> {
    let tree = LayerTree::of(session.look(), &session.project.catalog);
    let place = place_for_new(&tree, session);
    let mut edits = tree.insert(session.look(), &place, &id, node);
    edits.extend(first);
    let own = tree.own();
    if own.ground.is_none() && place == (LayerPlace { folder: None, at: own.layers.len() }) {
        edits.extend(add_ground(session, Endpoint::new(id.clone(), BELOW)));
    }
    vec![Command::Edit(Edit::Group { edits }), Command::Show(NodePath::root(id))]
}

/// Place of a new layer: over the selected one, or in the selected folder.
fn place_for_new(tree: &LayerTree, session: &Session) -> LayerPlace {
    let Some(selected) = session.selection.nodes.last().filter(|id| is_selected(session, id))
    else {
        return LayerPlace::default();
    };
    if tree.is_folder(selected) {
        return LayerPlace { folder: Some(selected.clone()), at: 0 };
    }
    // A new layer goes directly over the ground, where the ground is selected.
    let is_ground = tree.own().ground.as_ref().is_some_and(|ground| ground.node == *selected);
    let lowest = || LayerPlace { folder: None, at: tree.own().layers.len() };
    tree.place_of(selected).or_else(|| is_ground.then(lowest)).unwrap_or_default()
}

fn add(session: &Session, preset: &LayerPreset) -> Vec<Command> {
    let tree = LayerTree::of(session.look(), &session.project.catalog);
    let selected = session.selection.nodes.last();
    let beside = selected.filter(|id| is_selected(session, id) && tree.contains(id));
    insert_layer(session, preset.make(session, beside))
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

/// Greatest part of a color that counts as dark, as displayed: the half-tone layer's blue is.
const DARK: f64 = 0.45;

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
