//! Text field over the cell that is edited.

use chiaro_locale::trn;
use eframe::egui;
use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{Id, Rect, Role, TextEdit, Ui, UiBuilder, WidgetInfo, vec2};

use super::selection::Place;
use crate::widgets::rows::leaves_with_text;
use crate::widgets::theme;

/// Cell that is edited, with the text so far.
pub(super) struct CellEdit {
    pub(super) place: Place,
    text: String,
    /// True until the field was shown once.
    is_new: bool,
    /// True if the whole text is selected at first.
    selects_all: bool,
}

impl CellEdit {
    /// An edit of the cell's text, or of what was typed in its place.
    pub(super) fn new(place: Place, text: String, typed: Option<String>) -> Self {
        let selects_all = typed.is_none();
        Self { place, text: typed.unwrap_or(text), is_new: true, selects_all }
    }

    /// Shows the field over the cell; `count` is the number of cells that will take the text.
    /// Returns the text, or `Some(None)` when the edit is given up.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        cell: Rect,
        area: Rect,
        name: &str,
        count: usize,
    ) -> Option<Option<String>> {
        let id = Id::unique("edited cell of the light table").with(&self.place);
        let width = cell.width().max(72.0);
        let left = cell.left().min(area.right() - width).max(area.left());
        let rect = Rect::from_min_size(egui::pos2(left, cell.top()), vec2(width, cell.height()));
        let mut ui = ui.new_child(UiBuilder::new().max_rect(rect).id_salt("edited cell"));
        ui.set_clip_rect(area.intersect(ui.clip_rect()));
        let ui = &mut ui;
        ui.painter().rect_filled(rect, 2.0, theme::of(ui).well);
        if std::mem::take(&mut self.is_new) {
            ui.memory_mut(|memory| memory.request_focus(id));
            let mut state = TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
            let end = CCursor::new(self.text_len());
            let begin = if self.selects_all { CCursor::new(0) } else { end };
            state.cursor.set_char_range(Some(CCursorRange::two(begin, end)));
            state.store(ui.ctx(), id);
        }
        let edit = TextEdit::singleline(&mut self.text)
            .id(id)
            .desired_width(width)
            .margin(vec2(5.0, 2.0))
            .char_limit(400);
        let response = ui.put(rect, edit);
        response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, name));
        if count > 1 {
            let at = rect.right_center() - vec2(6.0, 0.0);
            let font = egui::FontId::proportional(theme::SMALL_TEXT);
            let text = trn!(count, "{count} cell", "{count} cells");
            let color = theme::of(ui).accent;
            ui.painter().text(at, egui::Align2::RIGHT_CENTER, text, font, color);
        }
        if !response.lost_focus() {
            return None;
        }
        Some(leaves_with_text(ui).then(|| self.text.clone()))
    }

    fn text_len(&self) -> usize {
        self.text.chars().count()
    }
}
