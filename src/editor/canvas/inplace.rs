//! Names and notes that are edited in place, on the canvas.

use eframe::egui;
use eframe::egui::{Area, Id, Key, Modifiers, Order, Rect, TextEdit, Ui, WidgetInfo, vec2};

use super::{Canvas, edits};
use crate::commands::Command;
use crate::drawing::{NODE_WIDTH, TEXT_SIZE, TITLE_HEIGHT};
use crate::ids::{FrameId, NodeId, NoteId};
use crate::state::session::Session;

/// Item of the canvas that has a text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Item {
    Node(NodeId),
    Frame(FrameId),
    Note(NoteId),
}

/// Text that is being edited in place.
pub(super) struct TextEditInPlace {
    item: Item,
    text: String,
    is_new: bool,
}

impl Canvas {
    /// Text of an item; `None` if the item does not exist.
    fn text_of(session: &Session, item: &Item) -> Option<String> {
        let graph = session.graph();
        match item {
            Item::Node(id) => graph.nodes.get(id).map(|node| node.name.clone()),
            Item::Frame(id) => graph.frames.get(id).map(|frame| frame.title.clone()),
            Item::Note(id) => graph.notes.get(id).map(|note| note.text.clone()),
        }
    }

    /// Rectangle of an item's text field, on the screen.
    fn place_of(&self, item: &Item) -> Option<Rect> {
        let rect = match item {
            Item::Node(id) => {
                let rect = self.table.nodes[self.table.index_of(id)?].rect;
                Rect::from_min_size(rect.min, vec2(NODE_WIDTH, TITLE_HEIGHT))
            }
            Item::Frame(id) => self.table.frames.iter().find(|row| row.id == *id)?.title_rect(),
            Item::Note(id) => self.table.notes.iter().find(|row| row.id == *id)?.rect,
        };
        Some(self.view.rect_to_screen(rect))
    }

    /// Shows the text field of the item that is being edited.
    pub(super) fn edit_in_place(&mut self, ui: &Ui, session: &Session, out: &mut Vec<Command>) {
        if let Some(item) = self.edit_when_there.take() {
            match Self::text_of(session, &item).filter(|_| !session.graph_view().is_read_only()) {
                Some(text) => self.editing = Some(TextEditInPlace { item, text, is_new: true }),
                // The item may have been made in this frame by a command that is not applied yet:
                // look again in the next frame, and no longer than that.
                None => self.edit_when_there = Some(item).filter(|_| !out.is_empty()),
            }
        }
        let Some(editing) = &self.editing else { return };
        let place = self.place_of(&editing.item);
        let (Some(place), Some(_)) = (place, Self::text_of(session, &editing.item)) else {
            self.editing = None;
            return;
        };
        if ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
            self.editing = None;
            return;
        }
        let is_over = self.show_field(ui, place);
        if is_over && let Some(TextEditInPlace { item, text, .. }) = self.editing.take() {
            out.extend(Self::changed(session, item, text));
        }
    }

    /// Shows the text field at `place`; returns true once the edit is done.
    fn show_field(&mut self, ui: &Ui, place: Rect) -> bool {
        let Some(editing) = &mut self.editing else { return false };
        let is_note = matches!(editing.item, Item::Note(_));
        let size = TEXT_SIZE * self.view.zoom.clamp(0.8, 1.5);
        let width = place.width().max(if is_note { 160.0 } else { 120.0 });
        let area =
            Area::new(Id::unique("edit in place")).order(Order::Foreground).fixed_pos(place.min);
        let label = match &editing.item {
            Item::Node(_) => "Name of the node",
            Item::Frame(_) => "Title of the frame",
            Item::Note(_) => "Text of the note",
        };
        let shown = area.constrain_to(self.view.screen).show(ui.ctx(), |ui| {
            ui.set_width(width);
            let edit = if is_note {
                TextEdit::multiline(&mut editing.text).desired_rows(3)
            } else {
                TextEdit::singleline(&mut editing.text).char_limit(80)
            };
            let edit = edit.font(egui::FontId::proportional(size)).desired_width(width);
            let response = ui.add(edit.id(Id::unique("text in place")));
            response.widget_info(|| WidgetInfo::labeled(egui::Role::TextInput, true, label));
            if std::mem::replace(&mut editing.is_new, false) {
                response.request_focus();
                select_all(ui, response.id, &editing.text);
            }
            response
        });
        let is_done =
            is_note && ui.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::Enter));
        is_done || shown.inner.lost_focus()
    }

    fn changed(session: &Session, item: Item, text: String) -> Option<Command> {
        if Self::text_of(session, &item).as_deref() == Some(text.as_str()) {
            return None;
        }
        let edit = match item {
            Item::Node(id) => Some(Self::rename(session, &id, text)),
            Item::Frame(id) => edits::set_frame(session, &id, |frame| frame.title = text),
            Item::Note(id) => edits::set_note(session, &id, |note| note.text = text),
        };
        edit.map(Command::Edit)
    }
}

/// Selects a field's text, so that typing replaces it.
fn select_all(ui: &Ui, id: Id, text: &str) {
    use egui::text::{CCursor, CCursorRange};
    let mut state = egui::text_edit::TextEditState::load(ui.ctx(), id).unwrap_or_default();
    let range = CCursorRange::two(CCursor::new(0), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(range));
    state.store(ui.ctx(), id);
}
