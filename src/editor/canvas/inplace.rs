//! Names and notes that are edited in place, on the canvas.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Area, Id, Key, Modifiers, Order, Rect, TextEdit, Ui, WidgetInfo, vec2};

use super::passes::output_of;
use super::{Canvas, edits};
use crate::commands::Command;
use crate::document::Edit;
use crate::drawing::{NODE_WIDTH, ROW_HEIGHT, TEXT_SIZE, TITLE_HEIGHT, row_center};
use crate::fields::passes::OutputPass;
use crate::ids::{FrameId, NodeId, NoteId};
use crate::state::session::Session;
use crate::widgets::rows::leaves_with_text;
use crate::widgets::theme;

/// Item of the canvas that has a text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Item {
    Node(NodeId),
    Frame(FrameId),
    Note(NoteId),
    /// Output of a node, by its index, that has or gets a name as a pass.
    Pass(NodeId, usize),
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
            Item::Pass(node, index) => {
                let output = output_of(session, node, *index)?;
                let pass = OutputPass::of(session, &output);
                Some(pass.name().map_or_else(|| pass.suggested(), ToString::to_string))
            }
        }
    }

    /// Rectangle of an item's text field, on the screen.
    fn place_of(&self, item: &Item) -> Option<Rect> {
        let rect = match item {
            Item::Node(id) => {
                let rect = self.table.nodes[self.table.index_of(id)?].rect;
                Rect::from_min_size(rect.min, vec2(NODE_WIDTH, TITLE_HEIGHT))
            }
            Item::Pass(node, index) => {
                let row = &self.table.nodes[self.table.index_of(node)?];
                let below = if row.is_collapsed { 0.0 } else { row_center(*index) - 10.0 };
                Rect::from_min_size(row.rect.min + vec2(0.0, below), vec2(NODE_WIDTH, ROW_HEIGHT))
            }
            Item::Frame(id) => self.table.frames.iter().find(|row| row.id == *id)?.title_rect(),
            Item::Note(id) => self.table.notes.iter().find(|row| row.id == *id)?.rect,
        };
        Some(self.view.rect_to_screen(rect))
    }

    /// Shows the text field of the item that is being edited.
    pub(super) fn edit_in_place(&mut self, ui: &Ui, session: &Session, out: &mut Vec<Command>) {
        if let Some(item) = self.edit_when_there.take() {
            // The name of an output as a pass is the look's, whosever the group around it is.
            let can_change = !session.graph_view().is_read_only() || matches!(item, Item::Pass(..));
            match Self::text_of(session, &item).filter(|_| can_change) {
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
        let escapes = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        if escapes || !leaves_with_text(ui) {
            self.editing = None;
            return;
        }
        let is_entered = ui.input(|input| input.key_pressed(Key::Enter));
        let is_over = self.show_field(ui, session, place);
        if is_over && let Some(TextEditInPlace { item, text, .. }) = self.editing.take() {
            match Self::changed(session, item.clone(), text.clone()) {
                Ok(edit) => out.extend(edit.map(Command::Edit)),
                Err(problem) => {
                    // The text stays to be mended; leaving it gives it up.
                    let editing = TextEditInPlace { item, text, is_new: true };
                    self.editing = is_entered.then_some(editing);
                    out.push(Command::Tell(problem));
                }
            }
        }
    }

    /// Shows the text field at `place`; returns true once the edit is done.
    fn show_field(&mut self, ui: &Ui, session: &Session, place: Rect) -> bool {
        let Some(editing) = &mut self.editing else { return false };
        let is_note = matches!(editing.item, Item::Note(_));
        let size = TEXT_SIZE * self.view.zoom.clamp(0.8, 1.5);
        let width = place.width().max(if is_note { 160.0 } else { 120.0 });
        let area =
            Area::new(Id::unique("edit in place")).order(Order::Foreground).fixed_pos(place.min);
        let label = match &editing.item {
            Item::Node(_) => tr!("Name of the node"),
            Item::Frame(_) => tr!("Title of the frame"),
            Item::Note(_) => tr!("Text of the note"),
            Item::Pass(..) => tr!("Name of the pass"),
        };
        let problem = Self::changed(session, editing.item.clone(), editing.text.clone()).err();
        let colors = theme::of(ui);
        let ink = if problem.is_some() { colors.error } else { colors.text };
        let shown = area.constrain_to(self.view.screen).show(ui.ctx(), |ui| {
            ui.set_width(width);
            let edit = if is_note {
                TextEdit::multiline(&mut editing.text).desired_rows(3)
            } else {
                TextEdit::singleline(&mut editing.text).char_limit(80)
            };
            let edit = edit.font(egui::FontId::proportional(size)).desired_width(width);
            let edit = edit.text_color(ink);
            let response = ui.add(edit.id(Id::unique("text in place")));
            response.widget_info(|| WidgetInfo::labeled(egui::Role::TextInput, true, label));
            if std::mem::replace(&mut editing.is_new, false) {
                response.request_focus();
                select_all(ui, response.id, &editing.text);
            }
            if let Some(problem) = &problem {
                egui::Frame::popup(ui.style()).show(ui, |ui| {
                    ui.label(egui::RichText::new(problem).small().color(colors.error));
                });
            }
            response
        });
        let is_done =
            is_note && ui.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::Enter));
        is_done || shown.inner.lost_focus()
    }

    /// Edit that gives an item its new text; `None` where nothing changes.
    ///
    /// # Errors
    /// A sentence on what keeps it from being the text.
    fn changed(session: &Session, item: Item, text: String) -> Result<Option<Edit>, String> {
        if let Item::Pass(node, index) = &item {
            let output = output_of(session, node, *index);
            return output.map_or(Ok(None), |output| OutputPass::of(session, &output).named(&text));
        }
        if Self::text_of(session, &item).as_deref() == Some(text.as_str()) {
            return Ok(None);
        }
        Ok(match item {
            Item::Node(id) => Some(Self::rename(session, &id, text)),
            Item::Frame(id) => edits::set_frame(session, &id, |frame| frame.title = text),
            Item::Note(id) => edits::set_note(session, &id, |note| note.text = text),
            Item::Pass(..) => None,
        })
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
