//! Cells on the screen, and what the pointer does with them.
//!
//! Cells are painted and not made of widgets each, so that a thousand lights cost what is seen. The
//! head stays at the top and the first columns at the left, in areas of their own over the others.
//! Only the cursor's cell takes the keyboard's focus: Tab goes past the table in one step.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{
    Align2, FontId, Id, Key, Popup, PopupCloseBehavior, Rect, Response, Role, ScrollArea, Sense,
    Stroke, StrokeKind, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::change::{CellChanges, Entry};
use super::column::Column;
use super::editing::CellEdit;
use super::layout::{CellLayout, HEAD, ROW};
use super::selection::{CellSelection, Place, ShownCells};
use super::sheet::{Cell, CellValue, Sheet};
use super::{menu, paint};
use crate::commands::Command;
use crate::document::{LightKind, LightSpace};
use crate::panels::lights::{kind_name, space_name};
use crate::widgets::rows::leave_with_pointer;
use crate::widgets::text::cell as text_cell;
use crate::widgets::{color, theme};

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
    pub(super) follows: bool,
    /// Column that its head's menu hides.
    pub(super) hidden: Option<Column>,
    /// Width of the columns that stay at the left edge.
    pinned: f32,
}

/// Id of a cell's widget.
pub(super) fn id_of(place: &Place) -> Id {
    Id::unique("cell of the light table").with(place)
}

impl CellGrid {
    /// Shows the cells.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        sheet: Sheet<'_>,
        shown: ShownCells<'_>,
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
            let layout =
                CellLayout { shown, lefts, pinned, origin: whole.min, seen: ui.clip_rect() };
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
        layout: &CellLayout<'_>,
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
        for (y, row) in layout.shown.rows.iter().enumerate() {
            let top = layout.rect(y, 0).top();
            let is_seen = top + ROW > area.top() && top < area.bottom();
            // The cursor's cell has the keyboard also where it is scrolled away.
            let is_at = self.selection.cursor().is_some_and(|(at, _)| at == row);
            if !is_seen && !is_at {
                continue;
            }
            for x in layout.columns(is_pinned) {
                let rect = layout.rect(y, x);
                let place = (row.clone(), layout.shown.columns[x]);
                let is_cursor = self.selection.cursor() == Some(&place);
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
        shown: ShownCells<'_>,
        (rect, place): (Rect, &Place),
        is_cursor: bool,
        out: &mut Vec<Command>,
    ) {
        let (row, column) = place;
        let cell = sheet.cell(row, *column);
        let sense = if is_cursor { Sense::click_and_drag() } else { Sense::CLICK | Sense::DRAG };
        let response = ui.interact(rect, id_of(place), sense);
        let is_selected = self.selection.has(place);
        response.widget_info(|| {
            let name = sheet.full_name(row);
            let label = tr!("{label} of {name}", label = column.label());
            let mut info = WidgetInfo::selected(Role::Cell, true, is_selected, label);
            info.current_text_value = Some(sheet.words(&cell));
            info
        });
        paint::cell(ui, sheet, rect, place, &cell, is_selected);
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
            response.on_hover_ui(|ui| paint::help(ui, sheet, place, &cell));
        }
    }

    /// Selects by clicks, turns switches, begins edits.
    fn pointer(
        &mut self,
        ui: &Ui,
        sheet: Sheet<'_>,
        shown: ShownCells<'_>,
        place: &Place,
        (response, cell): (&Response, &Cell),
        out: &mut Vec<Command>,
    ) {
        let modifiers = ui.input(|input| input.modifiers);
        let is_plain = modifiers.is_none();
        let is_pressed = ui.input(|input| input.pointer.primary_pressed());
        // A quick click on a slow machine begins and ends within a frame.
        let is_at = response.is_pointer_button_down_on() || response.clicked();
        if is_pressed && is_at {
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
    fn drag(&mut self, ui: &Ui, layout: &CellLayout<'_>) {
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
        shown: ShownCells<'_>,
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
                    let names: Vec<&str> = match place.1 {
                        Column::Kind => {
                            LightKind::ALL.iter().map(|kind| kind_name(*kind)).collect()
                        }
                        _ => LightSpace::ALL.iter().map(|space| space_name(*space)).collect(),
                    };
                    let mut chosen = None;
                    for name in names {
                        if ui.selectable_label(*now == name, name).clicked() {
                            chosen = Some((Entry::Text(name.to_owned()), false));
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
        layout: &CellLayout<'_>,
        out: &mut Vec<Command>,
    ) {
        let Some(edit) = &mut self.editing else { return };
        let (rows, columns) = (layout.shown.rows, layout.shown.columns);
        let row = rows.iter().position(|row| *row == edit.place.0);
        let column = columns.iter().position(|column| *column == edit.place.1);
        let (Some(row), Some(column)) = (row, column) else { return };
        let name = sheet.full_name(&edit.place.0);
        let name = tr!("New {label} of {name}", label = edit.place.1.label());
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

    fn heads(&mut self, ui: &mut Ui, layout: &CellLayout<'_>, is_pinned: bool) {
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

    fn head(&mut self, ui: &mut Ui, rect: Rect, column: Column, shown: ShownCells<'_>) {
        let id = Id::unique("head of the light table").with(column);
        let response = ui.interact(rect, id, Sense::click());
        let name = tr!("Sort by {label}", label = column.label());
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
            if ui.button(tr!("Select the column")).clicked() {
                self.selection.select_column(shown, column);
                self.follows = true;
            }
            let hide =
                ui.add_enabled(column != Column::Name, egui::Button::new(tr!("Hide the column")));
            if hide.clicked() {
                self.hidden = Some(column);
            }
        });
        let help = tr!("A click sorts: upward, downward, and as the documents have it");
        response.on_hover_text(format!("{}.\n{help}", column.help()));
    }

    /// Gives all selected cells an entry.
    pub(super) fn enter(
        &mut self,
        sheet: Sheet<'_>,
        shown: ShownCells<'_>,
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
}
