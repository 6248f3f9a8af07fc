//! The cells on the screen: where they stand, how they look, and what the pointer and the keyboard
//! do with them.
//!
//! Cells are painted and not made of widgets each, so that a thousand lights cost what is seen. The
//! head stays at the top and the first columns at the left, in areas of their own over the others.
//! Only the cursor's cell takes the keyboard's focus: Tab goes past the table in one step.

use eframe::egui;
use eframe::egui::{
    Align2, Color32, Event, EventFilter, FontId, Id, Key, Modifiers, Popup, PopupCloseBehavior,
    Pos2, Rect, Response, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui, UiBuilder, WidgetInfo,
    pos2, vec2,
};

use super::change::{CellChanges, Entry, form_of};
use super::column::Column;
use super::selection::{CellSelection, Place, Shown};
use super::sheet::{Cell, CellValue, Origin, Row, Sheet};
use super::{editing::CellEdit, menu};
use crate::commands::Command;
use crate::document::{LightKind, LightSpace, Target};
use crate::fields::mark;
use crate::panels::lights::space_name;
use crate::state::keying::KeyedBy;
use crate::state::reading::spoken;
use crate::widgets::rows::{Icon, draw, leave_with_pointer, picture_frame, undo_keys};
use crate::widgets::text::cell as text_cell;
use crate::widgets::{color, theme};

const ROW: f32 = 22.0;
const HEAD: f32 = 22.0;

/// State of the cells on the screen.
#[derive(Default)]
pub(super) struct CellGrid {
    pub(super) selection: CellSelection,
    /// Column that rows are sorted by, and whether from the greatest to the least.
    pub(super) sort: Option<(Column, bool)>,
    pub(super) editing: Option<CellEdit>,
    /// True while the pointer draws a selection.
    is_dragging: bool,
    /// True if the cursor's cell is to be scrolled into view, with the keyboard's focus.
    follows: bool,
    /// Column that its head's menu hides.
    pub(super) hidden: Option<Column>,
    /// Width of the columns that stay at the left edge.
    pinned: f32,
}

/// Where the cells stand.
struct Layout<'s> {
    shown: Shown<'s>,
    /// Left edges of the columns from the table's own, and the right edge of the last.
    lefts: Vec<f32>,
    /// Number of columns that stay at the left edge.
    pinned: usize,
    /// Upper left corner of the cells, which goes with scrolling.
    origin: Pos2,
    /// Part of the screen that is seen.
    seen: Rect,
}

impl Layout<'_> {
    fn left_of(&self, column: usize) -> f32 {
        let from = if column < self.pinned { self.seen.left() } else { self.origin.x };
        from + self.lefts[column]
    }

    fn rect(&self, row: usize, column: usize) -> Rect {
        let width = self.lefts[column + 1] - self.lefts[column];
        let top = self.origin.y + HEAD + row as f32 * ROW;
        Rect::from_min_size(pos2(self.left_of(column), top), vec2(width, ROW))
    }

    fn head(&self, column: usize) -> Rect {
        let width = self.lefts[column + 1] - self.lefts[column];
        Rect::from_min_size(pos2(self.left_of(column), self.seen.top()), vec2(width, HEAD))
    }

    /// Width of the columns that stay.
    fn pinned_width(&self) -> f32 {
        self.lefts[self.pinned]
    }

    /// Area of the columns that stay, or of the others, without the head.
    fn area(&self, is_pinned: bool) -> Rect {
        let edge = (self.seen.left() + self.pinned_width()).min(self.seen.right());
        let top = (self.seen.top() + HEAD).min(self.seen.bottom());
        let body = Rect::from_min_max(pos2(self.seen.left(), top), self.seen.max);
        if is_pinned { body.with_max_x(edge) } else { body.with_min_x(edge) }
    }

    fn columns(&self, is_pinned: bool) -> std::ops::Range<usize> {
        if is_pinned { 0..self.pinned } else { self.pinned..self.shown.columns.len() }
    }

    /// The cell nearest to a point.
    fn nearest(&self, at: Pos2) -> Option<Place> {
        let rows = self.shown.rows.len().checked_sub(1)?;
        let row = ((at.y - self.origin.y - HEAD) / ROW).max(0.0) as usize;
        let is_pinned = at.x < self.seen.left() + self.pinned_width();
        let columns = self.columns(is_pinned);
        let is_right_of = |column: &usize| self.left_of(*column) <= at.x;
        let column = columns.clone().rev().find(is_right_of).unwrap_or(columns.start);
        let row = self.shown.rows.get(row.min(rows))?.clone();
        Some((row, *self.shown.columns.get(column)?))
    }
}

/// Id of a cell's widget.
fn id_of(place: &Place) -> Id {
    Id::unique("cell of the light table").with(place)
}

impl CellGrid {
    /// Shows the cells.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        sheet: Sheet<'_>,
        shown: Shown<'_>,
        out: &mut Vec<Command>,
    ) {
        self.selection.keep(shown);
        if self.editing.as_ref().is_some_and(|edit| !shown.rows.contains(&edit.place.0)) {
            self.editing = None;
        }
        let mut lefts = vec![0.0];
        for column in shown.columns {
            lefts.push(lefts[lefts.len() - 1] + column.width());
        }
        let size = vec2(lefts[lefts.len() - 1] + 10.0, HEAD + shown.rows.len() as f32 * ROW + 10.0);
        let pinned = shown.columns.iter().take_while(|column| column.is_pinned()).count();
        let area = ScrollArea::both().auto_shrink([false, false]).id_salt("light table");
        area.show(ui, |ui| {
            let (whole, _) = ui.allocate_exact_size(size, Sense::hover());
            let layout = Layout { shown, lefts, pinned, origin: whole.min, seen: ui.clip_rect() };
            self.pinned = layout.pinned_width();
            self.keys(ui, sheet, shown, out);
            self.drag(ui, &layout);
            for is_pinned in [false, true] {
                self.body(ui, sheet, &layout, is_pinned, out);
            }
            for is_pinned in [false, true] {
                self.heads(ui, &layout, is_pinned);
            }
            self.edit_cell(ui, sheet, &layout, out);
            if let Some(place) = self.selection.cursor()
                && let Some(response) = ui.ctx().read_response(id_of(place))
            {
                leave_with_pointer(ui, &response);
            }
        });
    }

    fn body(
        &mut self,
        ui: &mut Ui,
        sheet: Sheet<'_>,
        layout: &Layout<'_>,
        is_pinned: bool,
        out: &mut Vec<Command>,
    ) {
        let area = layout.area(is_pinned);
        let mut ui = ui.new_child(UiBuilder::new().max_rect(area).id_salt(("cells", is_pinned)));
        ui.set_clip_rect(area.intersect(ui.clip_rect()));
        let ui = &mut ui;
        if is_pinned {
            ui.painter().rect_filled(area, 0.0, theme::of(ui).panel);
        }
        let cursor = self.selection.cursor().cloned();
        for (y, row) in layout.shown.rows.iter().enumerate() {
            let top = layout.rect(y, 0).top();
            let is_seen = top + ROW > area.top() && top < area.bottom();
            // The cursor's cell has the keyboard also where it is scrolled away.
            let is_at = cursor.as_ref().is_some_and(|(at, _)| at == row);
            if !is_seen && !is_at {
                continue;
            }
            for x in layout.columns(is_pinned) {
                let rect = layout.rect(y, x);
                let place = (row.clone(), layout.shown.columns[x]);
                let is_cursor = cursor.as_ref() == Some(&place);
                if is_cursor || is_seen && rect.intersects(area) {
                    self.cell(ui, sheet, layout.shown, (rect, &place), is_cursor, out);
                }
            }
            let line = Stroke::new(1.0, theme::of(ui).grid);
            ui.painter().hline(area.x_range(), top + ROW - 0.5, line);
        }
        if is_pinned {
            let line = Stroke::new(1.0, theme::of(ui).grid);
            ui.painter().vline(area.right() - 0.5, area.y_range(), line);
        }
    }

    fn cell(
        &mut self,
        ui: &mut Ui,
        sheet: Sheet<'_>,
        shown: Shown<'_>,
        (rect, place): (Rect, &Place),
        is_cursor: bool,
        out: &mut Vec<Command>,
    ) {
        let (row, column) = place;
        let cell = sheet.cell(row, *column);
        let sense = if is_cursor { Sense::click_and_drag() } else { Sense::CLICK | Sense::DRAG };
        let response = ui.interact(rect, id_of(place), sense);
        let is_selected = self.selection.has(place);
        let text = cell.value.as_ref().map(|value| value.text(sheet.session));
        response.widget_info(|| {
            let label = format!("{} of {}", column.label(), sheet.full_name(row));
            let mut info = WidgetInfo::selected(Role::Cell, true, is_selected, label);
            info.current_text_value = Some(text.clone().unwrap_or_else(|| "none".to_owned()));
            info
        });
        paint(ui, sheet, rect, place, &cell, is_selected);
        if is_cursor {
            let color = theme::of(ui).accent;
            let width = if response.has_focus() { 1.5 } else { 1.0 };
            let stroke = Stroke::new(width, color);
            ui.painter().rect_stroke(rect.shrink(0.5), 2.0, stroke, StrokeKind::Inside);
            if std::mem::take(&mut self.follows) {
                response.request_focus();
                // What stays at the edges covers cells that are scrolled below it.
                let covered = if column.is_pinned() { 0.0 } else { self.pinned };
                let seen = Rect::from_min_max(rect.min - vec2(covered, HEAD), rect.max);
                ui.scroll_to_rect(seen, None);
            }
        }
        self.pointer(ui, sheet, shown, place, (&response, &cell), out);
        self.popup(ui, sheet, shown, place, (&response, &cell), out);
        Popup::context_menu(&response).show(|ui| {
            menu::show(ui, sheet, shown, self, place, out);
        });
        if !response.context_menu_opened() {
            response.on_hover_ui(|ui| help(ui, sheet, place, &cell));
        }
    }

    /// Selects by clicks, turns switches, begins edits.
    fn pointer(
        &mut self,
        ui: &Ui,
        sheet: Sheet<'_>,
        shown: Shown<'_>,
        place: &Place,
        (response, cell): (&Response, &Cell),
        out: &mut Vec<Command>,
    ) {
        let modifiers = ui.input(|input| input.modifiers);
        let is_plain = modifiers.is_none();
        let is_pressed = ui.input(|input| input.pointer.primary_pressed());
        if is_pressed && response.is_pointer_button_down_on() {
            if modifiers.shift {
                self.selection.extend(shown, place.clone());
            } else if modifiers.command {
                self.selection.toggle(place.clone());
            } else if !(place.1.is_switch() && self.selection.has(place)) {
                self.selection.set(place.clone());
            }
            self.is_dragging = true;
            response.request_focus();
            self.follows = true;
        }
        if response.secondary_clicked() && !self.selection.has(place) {
            self.selection.set(place.clone());
        }
        if response.clicked() && is_plain && place.1.is_switch() {
            if let Some(CellValue::Switch(is_on)) = cell.value {
                self.enter(sheet, shown, &Entry::Switch(!is_on), None, out);
            }
        } else if response.double_clicked() && is_plain {
            self.begin(ui, sheet, place, None);
        }
    }

    /// Extends the selection to the cell under the pointer, while that draws it.
    fn drag(&mut self, ui: &Ui, layout: &Layout<'_>) {
        if !ui.input(|input| input.pointer.primary_down()) {
            self.is_dragging = false;
        }
        let at = ui.input(|input| input.pointer.latest_pos());
        let moves = ui.input(|input| input.pointer.is_decidedly_dragging());
        if self.is_dragging
            && moves
            && let Some(place) = at.and_then(|at| layout.nearest(at))
            && self.selection.cursor() != Some(&place)
        {
            self.selection.extend(layout.shown, place);
            self.follows = true;
        }
    }

    fn keys(&mut self, ui: &Ui, sheet: Sheet<'_>, shown: Shown<'_>, out: &mut Vec<Command>) {
        let Some(place) = self.selection.cursor().cloned() else { return };
        let id = id_of(&place);
        if self.editing.is_some() || !ui.memory(|memory| memory.has_focus(id)) {
            return;
        }
        let arrows =
            EventFilter { horizontal_arrows: true, vertical_arrows: true, ..<_>::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
        undo_keys(ui, out);
        let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
        for (key, by) in [
            (Key::ArrowUp, [-1, 0]),
            (Key::ArrowDown, [1, 0]),
            (Key::ArrowLeft, [0, -1]),
            (Key::ArrowRight, [0, 1]),
            (Key::PageUp, [-10, 0]),
            (Key::PageDown, [10, 0]),
            (Key::Home, [0, -1000]),
            (Key::End, [0, 1000]),
        ] {
            for (modifiers, extends) in [(Modifiers::SHIFT, true), (Modifiers::NONE, false)] {
                if pressed(modifiers, key) {
                    self.selection.step(shown, by, extends);
                    self.follows = true;
                }
            }
        }
        if pressed(Modifiers::COMMAND, Key::A) {
            self.selection.select_more(shown);
        }
        let value = sheet.cell(&place.0, place.1).value;
        if let Some(CellValue::Switch(is_on)) = value {
            if pressed(Modifiers::NONE, Key::Space) || pressed(Modifiers::NONE, Key::Enter) {
                self.enter(sheet, shown, &Entry::Switch(!is_on), None, out);
            }
        } else if pressed(Modifiers::NONE, Key::Enter) || pressed(Modifiers::NONE, Key::F2) {
            self.begin(ui, sheet, &place, None);
        }
        if pressed(Modifiers::NONE, Key::Delete) || pressed(Modifiers::NONE, Key::Backspace) {
            self.enter(sheet, shown, &Entry::Reset, None, out);
        }
        self.clipboard(ui, sheet, shown, out);
        self.typing(ui, sheet, &place, out);
    }

    fn clipboard(&mut self, ui: &Ui, sheet: Sheet<'_>, shown: Shown<'_>, out: &mut Vec<Command>) {
        let is_it = |event: &Event| matches!(event, Event::Copy | Event::Cut | Event::Paste(_));
        let events: Vec<Event> = ui.input_mut(|input| {
            let (taken, left) = std::mem::take(&mut input.events).into_iter().partition(is_it);
            input.events = left;
            taken
        });
        for event in events {
            match event {
                Event::Paste(text) => self.paste(sheet, shown, &text, out),
                _ => out.push(Command::Copy(self.copied(sheet, shown))),
            }
        }
    }

    /// Begins an edit with the first letter that is typed; K keys the cells.
    fn typing(&mut self, ui: &Ui, sheet: Sheet<'_>, place: &Place, out: &mut Vec<Command>) {
        let typed = ui.input(|input| {
            input.events.iter().find_map(|event| match event {
                Event::Text(text) => Some(text.clone()),
                _ => None,
            })
        });
        let Some(typed) = typed.filter(|typed| !typed.trim().is_empty()) else { return };
        let keys_value = place.1.field().is_some() && typed.eq_ignore_ascii_case("k");
        ui.input_mut(|input| input.events.retain(|event| !matches!(event, Event::Text(_))));
        if keys_value {
            out.extend(self.keying(sheet));
        } else if !place.1.is_switch() {
            self.begin(ui, sheet, place, Some(typed));
        }
    }

    /// Begins to edit a cell: with a text that replaces the value, or with the value.
    pub(super) fn begin(
        &mut self,
        ui: &Ui,
        sheet: Sheet<'_>,
        place: &Place,
        typed: Option<String>,
    ) {
        let Some(value) = sheet.cell(&place.0, place.1).value else { return };
        let is_list = matches!(place.1, Column::Kind | Column::Space);
        if typed.is_none() && (place.1.is_color() || is_list) {
            Popup::open_id(ui.ctx(), id_of(place).with("popup"));
            return;
        }
        if place.1 == Column::Id {
            return;
        }
        self.editing = Some(CellEdit::new(place.clone(), value.text(sheet.session), typed));
    }

    /// Shows the picker of a color, or the list of words, below a cell while that is open.
    fn popup(
        &mut self,
        ui: &Ui,
        sheet: Sheet<'_>,
        shown: Shown<'_>,
        place: &Place,
        (response, cell): (&Response, &Cell),
        out: &mut Vec<Command>,
    ) {
        let popup = response.id.with("popup");
        if !Popup::is_id_open(ui.ctx(), popup) {
            return;
        }
        let entry = Popup::from_response(response)
            .id(popup)
            .open_memory(None)
            .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
            .show(|ui| match &cell.value {
                Some(CellValue::Color(now)) => {
                    let space = sheet.session.look().color_space;
                    color::pick_in(ui, *now, space).map(|color| (Entry::Color(color), true))
                }
                Some(CellValue::Text(now)) => {
                    let words: Vec<(&str, String)> = match place.1 {
                        Column::Kind => {
                            LightKind::ALL.iter().map(|k| (k.word(), spoken(k.word()))).collect()
                        }
                        _ => {
                            let names = LightSpace::ALL.iter().map(|space| space_name(*space));
                            names.map(|name| (name, name.to_owned())).collect()
                        }
                    };
                    let mut chosen = None;
                    for (word, name) in words {
                        if ui.selectable_label(*now == name, name).clicked() {
                            chosen = Some((Entry::Text(word.to_owned()), false));
                        }
                    }
                    chosen
                }
                _ => None,
            });
        if ui.input(|input| input.key_pressed(Key::Escape)) {
            Popup::close_id(ui.ctx(), popup);
            self.follows = true;
        }
        if let Some((entry, is_held)) = entry.and_then(|shown| shown.inner) {
            self.enter(sheet, shown, &entry, is_held.then_some(popup), out);
            if !is_held {
                Popup::close_id(ui.ctx(), popup);
                self.follows = true;
            }
        }
    }

    fn edit_cell(
        &mut self,
        ui: &mut Ui,
        sheet: Sheet<'_>,
        layout: &Layout<'_>,
        out: &mut Vec<Command>,
    ) {
        let Some(edit) = &mut self.editing else { return };
        let (rows, columns) = (layout.shown.rows, layout.shown.columns);
        let row = rows.iter().position(|row| *row == edit.place.0);
        let column = columns.iter().position(|column| *column == edit.place.1);
        let (Some(row), Some(column)) = (row, column) else { return };
        let name = format!("New {} of {}", edit.place.1.label(), sheet.full_name(&edit.place.0));
        let area = layout.area(column < layout.pinned);
        let count = self.selection.len();
        let Some(text) = edit.show(ui, layout.rect(row, column), area, &name, count) else {
            return;
        };
        self.editing = None;
        self.follows = true;
        if let Some(text) = text {
            self.enter(sheet, layout.shown, &Entry::Text(text), None, out);
        }
    }

    fn heads(&mut self, ui: &mut Ui, layout: &Layout<'_>, is_pinned: bool) {
        let body = layout.area(is_pinned);
        let area = Rect::from_min_max(pos2(body.left(), layout.seen.top()), body.right_top());
        let mut ui = ui.new_child(UiBuilder::new().max_rect(area).id_salt(("heads", is_pinned)));
        ui.set_clip_rect(area.intersect(ui.clip_rect()));
        let ui = &mut ui;
        ui.painter().rect_filled(area, 0.0, theme::of(ui).node);
        for x in layout.columns(is_pinned) {
            let column = layout.shown.columns[x];
            self.head(ui, layout.head(x), column, layout.shown);
        }
    }

    fn head(&mut self, ui: &mut Ui, rect: Rect, column: Column, shown: Shown<'_>) {
        let id = Id::unique("head of the light table").with(column);
        let response = ui.interact(rect, id, Sense::click());
        let name = format!("Sort by {}", column.label());
        response.widget_info(|| WidgetInfo::labeled(Role::ColumnHeader, true, &name));
        let colors = theme::of(ui);
        if response.hovered() || response.has_focus() {
            ui.painter().rect_filled(rect, 0.0, colors.field_hovered);
        }
        let sorted = self.sort.filter(|(by, _)| *by == column).map(|(_, descends)| descends);
        let color = if sorted.is_some() { colors.accent } else { colors.dim };
        let font = FontId::proportional(theme::SMALL_TEXT);
        let inner = rect.shrink2(vec2(6.0, 0.0));
        if column.is_switch() {
            ui.painter().text(rect.center(), Align2::CENTER_CENTER, column.head(), font, color);
        } else if column.is_number() {
            let at = inner.right_center() - vec2(if sorted.is_some() { 9.0 } else { 0.0 }, 0.0);
            ui.painter().text(at, Align2::RIGHT_CENTER, column.head(), font, color);
        } else {
            text_cell(ui, inner, column.head(), font, color);
        }
        if let Some(descends) = sorted {
            let (at, side) = (inner.right_center(), if descends { 1.0 } else { -1.0 });
            let points = vec![
                at + vec2(-3.0, -2.0 * side),
                at + vec2(3.0, -2.0 * side),
                at + vec2(0.0, 2.5 * side),
            ];
            ui.painter().add(egui::Shape::convex_polygon(points, color, Stroke::NONE));
        }
        if response.clicked() {
            self.sort = match sorted {
                None => Some((column, false)),
                Some(false) => Some((column, true)),
                Some(true) => None,
            };
        }
        response.context_menu(|ui| {
            if ui.button("Select the column").clicked() {
                self.selection.select_column(shown, column);
                self.follows = true;
            }
            let hide = ui.add_enabled(column != Column::Name, egui::Button::new("Hide the column"));
            if hide.clicked() {
                self.hidden = Some(column);
            }
        });
        let help = "A click sorts: upward, downward, and as the documents have it";
        response.on_hover_text(format!("{}.\n{help}", column.help()));
    }

    /// Gives all selected cells an entry.
    pub(super) fn enter(
        &mut self,
        sheet: Sheet<'_>,
        shown: Shown<'_>,
        entry: &Entry,
        held: Option<Id>,
        out: &mut Vec<Command>,
    ) {
        let mut changes = CellChanges::new(sheet);
        for (row, column) in self.selection.lines(shown).into_iter().flatten().flatten() {
            changes.set(&row, column, entry);
        }
        out.extend(changes.commands(held));
    }

    fn paste(&self, sheet: Sheet<'_>, shown: Shown<'_>, text: &str, out: &mut Vec<Command>) {
        let lines: Vec<Vec<&str>> = text
            .trim_end_matches(['\n', '\r'])
            .lines()
            .map(|line| line.split('\t').collect())
            .collect();
        let width = lines.iter().map(Vec::len).max().unwrap_or_default();
        let mut changes = CellChanges::new(sheet);
        for ((row, column), [y, x]) in self.selection.covered(shown, [lines.len(), width]) {
            if let Some(text) = lines[y].get(x) {
                changes.set(&row, column, &Entry::Text((*text).to_owned()));
            }
        }
        out.extend(changes.commands(None));
    }

    /// Selected cells as a text: a line a row, with tabs between columns.
    pub(super) fn copied(&self, sheet: Sheet<'_>, shown: Shown<'_>) -> String {
        let text = |place: Option<Place>| {
            let value = place.and_then(|(row, column)| sheet.cell(&row, column).value);
            value.map(|value| value.text(sheet.session)).unwrap_or_default()
        };
        let line = |line: Vec<Option<Place>>| line.into_iter().map(text).collect::<Vec<_>>();
        let lines = self.selection.lines(shown).into_iter();
        lines.map(|cells| line(cells).join("\t")).collect::<Vec<_>>().join("\n")
    }

    /// Targets of the selected cells that keys of the look can move.
    pub(super) fn targets(&self, sheet: Sheet<'_>) -> Vec<Target> {
        let rows = sheet.rows(None, None);
        let mut found = Vec::new();
        for row in &rows {
            let Row::Light(id) = row else { continue };
            let is_of_scene = sheet.session.keys().light_of_scene(id).is_some();
            for column in Column::all().filter(|column| self.selection.has(&(row.clone(), *column)))
            {
                let Some(field) = column.field() else { continue };
                let keyed = sheet.keyed(id, field);
                let free = sheet.target(id, field).filter(|_| !is_of_scene);
                let is_there = sheet.cell(row, column).value.is_some();
                found.extend(keyed.or(free).filter(|_| is_there));
            }
        }
        found
    }

    /// Command that keys the selected cells at the playhead, as one step.
    pub(super) fn keying(&self, sheet: Sheet<'_>) -> Vec<Command> {
        let keys = sheet.session.keys();
        let is_free = |target: &Target| !matches!(keys.keyed_by(target), KeyedBy::Direction(_));
        let targets: Vec<Target> = self.targets(sheet).into_iter().filter(is_free).collect();
        let edits: Vec<_> = targets.iter().filter_map(|target| keys.key_in_time(target)).collect();
        if edits.is_empty() {
            let text = "None of these cells can be keyed in time: keys move the lights of the open \
                        look, where no light of the scene stands in their place";
            return vec![Command::Tell(text.to_owned())];
        }
        let count = edits.len();
        let are = if count == 1 { "value is" } else { "values are" };
        vec![
            Command::Edit(crate::document::Edit::Group { edits }),
            Command::Tell(format!("{count} {are} keyed at the playhead")),
        ]
    }
}

/// Paints a cell.
fn paint(ui: &Ui, sheet: Sheet<'_>, rect: Rect, place: &Place, cell: &Cell, is_selected: bool) {
    let (row, column) = place;
    let colors = theme::of(ui);
    let is_group = matches!(row, Row::Group(_));
    if is_group {
        ui.painter().rect_filled(rect, 0.0, colors.node);
    }
    if is_selected {
        ui.painter().rect_filled(rect, 0.0, colors.accent_dim.gamma_multiply(0.75));
    }
    let inner = rect.shrink2(vec2(6.0, 2.0));
    let Some(value) = &cell.value else {
        let color = colors.dim.gamma_multiply(0.5);
        let font = FontId::proportional(theme::TEXT_SIZE);
        let at = if column.is_number() { inner.right_center() } else { inner.left_center() };
        let align = if column.is_number() { Align2::RIGHT_CENTER } else { Align2::LEFT_CENTER };
        ui.painter().text(at, align, "–", font, color);
        return;
    };
    if let CellValue::Switch(is_on) = value {
        let is_solo = *column == Column::Solo;
        let icon = if is_solo { Icon::Solo } else { Icon::Bulb };
        let ink = match (is_solo, is_on) {
            (true, true) => {
                ui.painter().rect_filled(rect.shrink(3.0), 4.0, colors.accent);
                colors.panel
            }
            (true, false) => colors.dim.gamma_multiply(0.6),
            (false, true) if cell.overridden.is_none() => colors.text,
            _ => colors.dim,
        };
        draw(ui.painter(), icon, rect.center(), ink, *is_on);
        return;
    }
    let is_out = cell.overridden.as_ref().is_some_and(|by| by.left.is_none());
    let is_quiet = is_out || cell.origin == Origin::Inherited || *column == Column::Id;
    let ink = if is_quiet { colors.dim } else { colors.text };
    let mut inner = inner;
    if cell.origin == Origin::Keyed {
        keyed_mark(ui, sheet, place, &mut inner);
    }
    let swatch = match value {
        CellValue::Color(color) => Some(seen(sheet, *color)),
        _ if *column == Column::Name => sheet.swatch(row),
        _ => None,
    };
    if let Some(color) = swatch {
        let side = vec2(14.0, 14.0);
        let at = Rect::from_center_size(inner.left_center() + vec2(7.0, 0.0), side);
        ui.painter().rect_filled(at, 3.0, color);
        picture_frame(ui, at);
        inner.min.x = at.right() + 5.0;
    }
    let text = value.text(sheet.session);
    let left = cell.overridden.as_ref().and_then(|by| by.left.as_ref());
    if let Some(CellValue::Color(color)) = left {
        // What the tint leaves of the color stands beside it.
        let at = Rect::from_center_size(inner.right_center() - vec2(5.0, 0.0), vec2(10.0, 14.0));
        ui.painter().rect_filled(at, 2.0, seen(sheet, *color));
        picture_frame(ui, at);
        inner.max.x = at.left() - 4.0;
    } else if let Some(left) = left {
        let font = FontId::proportional(theme::SMALL_TEXT);
        let text = format!("→ {}", left.text(sheet.session));
        let at = ui.painter().text(
            inner.right_center(),
            Align2::RIGHT_CENTER,
            text,
            font,
            colors.accent,
        );
        inner.max.x = at.left() - 4.0;
    }
    let format = egui::text::TextFormat {
        font_id: FontId::proportional(theme::TEXT_SIZE),
        color: ink,
        italics: cell.origin == Origin::Inherited && !is_group,
        strikethrough: if is_out { Stroke::new(1.0, ink) } else { Stroke::NONE },
        ..<_>::default()
    };
    let mut job = egui::text::LayoutJob::single_section(text, format);
    job.wrap = egui::text::TextWrapping::truncate_at_width(inner.width().max(0.0));
    let galley = ui.fonts_mut(|fonts| fonts.layout_job(job));
    let x = match column.is_number() {
        true => inner.right() - galley.size().x,
        false => inner.left(),
    };
    let at = pos2(x, inner.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, ink);
}

/// Paints the diamond of a keyed cell, and takes its room.
fn keyed_mark(ui: &Ui, sheet: Sheet<'_>, (row, column): &Place, inner: &mut Rect) {
    let (Row::Light(id), Some(field)) = (row, column.field()) else { return };
    let Some(target) = sheet.target(id, field) else { return };
    let (fill, edge) = mark::inks(ui, sheet.session, &target);
    mark::diamond(ui, inner.left_center() + vec2(4.0, 0.0), 4.0, fill, edge);
    inner.min.x += 12.0;
}

fn seen(sheet: Sheet<'_>, color: [f64; 3]) -> Color32 {
    let light = crate::document::Light { color, ..<_>::default() };
    crate::panels::lights::swatch(&light, sheet.session.look().color_space)
}

/// Shows what a cell is, where its value comes from, and how it is changed.
fn help(ui: &mut Ui, sheet: Sheet<'_>, (row, column): &Place, cell: &Cell) {
    ui.set_max_width(320.0);
    ui.strong(format!("{} of {}", column.label(), sheet.full_name(row)));
    let dim = theme::of(ui).dim;
    if cell.value.is_none() {
        let text = match (row, sheet.scene()) {
            (Row::Group(group), None) => {
                let (count, _) = sheet.count(group);
                format!(
                    "{count} lights. Groups have masters in scenes: add an object to begin one."
                )
            }
            (Row::Group(_), _) => "Groups have no such field".to_owned(),
            (Row::Light(_), _) => "Lights of this type have no such field".to_owned(),
        };
        ui.label(egui::RichText::new(text).color(dim));
        return;
    }
    ui.label(sheet.origin_words(row, *column, cell));
    if let Some(by) = &cell.overridden {
        ui.label(egui::RichText::new(&by.by).color(theme::of(ui).accent));
    }
    ui.label(egui::RichText::new(column.help()).color(dim));
    let keys = match (column.is_switch(), form_of(*column).is_some()) {
        (true, _) => "A click or Space turns all selected ones",
        (_, true) => {
            "Enter or double click to change all selected cells; or type: 0.5, *1.2, +0.1, 50%. \
             K keys them, Delete resets them."
        }
        _ if *column == Column::Id => "",
        _ => "Enter or double click to change all selected cells; or just type",
    };
    if !keys.is_empty() {
        ui.label(egui::RichText::new(keys).small().color(dim));
    }
}
