//! Look of a cell: its value, where that comes from and what the mix leaves of it; and its help.

use chiaro_locale::{tr, trn};
use eframe::egui;
use eframe::egui::{Align2, Color32, FontId, Rect, Stroke, Ui, pos2, vec2};

use super::change::form_of;
use super::column::Column;
use super::selection::Place;
use super::sheet::{Cell, CellValue, Effect, Origin, Row, Sheet};
use crate::document::Light;
use crate::fields::mark;
use crate::fields::shot::{self, ChangedValue};
use crate::panels::lights::swatch as swatch_of;
use crate::widgets::rows::{Icon, draw, picture_frame};
use crate::widgets::text::cell as text_cell;
use crate::widgets::theme;

/// Paints a cell.
pub(super) fn cell(
    ui: &Ui,
    sheet: Sheet<'_>,
    rect: Rect,
    place: &Place,
    cell: &Cell,
    is_selected: bool,
) {
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
        if let Some(text) = note(sheet, row, *column) {
            text_cell(ui, inner, &text, FontId::proportional(theme::TEXT_SIZE), colors.dim);
            return;
        }
        let color = colors.dim.gamma_multiply(0.5);
        let font = FontId::proportional(theme::TEXT_SIZE);
        let at = if column.is_number() { inner.right_center() } else { inner.left_center() };
        let align = if column.is_number() { Align2::RIGHT_CENTER } else { Align2::LEFT_CENTER };
        ui.painter().text(at, align, "–", font, color);
        return;
    };
    if let CellValue::Switch(is_on) = value {
        switch(ui, rect, *column, cell, *is_on);
        return;
    }
    let effect = cell.overridden.as_ref().map(|by| &by.effect);
    let is_out = effect == Some(&Effect::Out);
    let is_quiet = is_out || cell.origin == Origin::Inherited || *column == Column::Id;
    let ink = if is_quiet { colors.dim } else { colors.text };
    let mut inner = inner;
    if let (Row::Light(id), Some(field)) = (row, column.field())
        && let Some((owned, target)) = sheet.target(id, field)
        && ChangedValue::of(sheet.session, owned.owner, &target.to_string()).is_some()
    {
        shot::bar(ui, rect);
    }
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
    let beside = match effect {
        Some(Effect::Left(left)) => Some(left.text(sheet.session)),
        Some(Effect::Objects(count)) => Some(tr!("{count} own")),
        _ => None,
    };
    if let Some(Effect::Left(CellValue::Color(color))) = effect {
        // What the tint leaves of the color stands beside it.
        let at = Rect::from_center_size(inner.right_center() - vec2(5.0, 0.0), vec2(10.0, 14.0));
        ui.painter().rect_filled(at, 2.0, seen(sheet, *color));
        picture_frame(ui, at);
        inner.max.x = at.left() - 4.0;
    } else if let Some(text) = beside {
        let font = FontId::proportional(theme::SMALL_TEXT);
        let (at, ink) = (inner.right_center(), colors.accent);
        let at = ui.painter().text(at, Align2::RIGHT_CENTER, text, font, ink);
        let tip = at.left_center() - vec2(3.0, 0.0);
        let arrow = vec![tip - vec2(5.0, 3.5), tip, tip + vec2(-5.0, 3.5)];
        ui.painter().add(egui::Shape::convex_polygon(arrow, ink, Stroke::NONE));
        inner.max.x = tip.x - 9.0;
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

/// Paints a switch.
fn switch(ui: &Ui, rect: Rect, column: Column, cell: &Cell, is_on: bool) {
    let colors = theme::of(ui);
    let is_solo = column == Column::Solo;
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
    draw(ui.painter(), icon, rect.center(), ink, is_on);
}

/// Text in a cell of a group that has no value.
fn note(sheet: Sheet<'_>, row: &Row, column: Column) -> Option<String> {
    let Row::Group(group) = row else { return None };
    match column {
        Column::Kind => Some(tr!("Group").to_owned()),
        Column::Groups => Some(match sheet.count(group) {
            (count, 0) => trn!(count, "{count} light", "{count} lights"),
            (1, _) => tr!("1 light, out").to_owned(),
            (count, out) => tr!("{count} lights, {out} out"),
        }),
        _ => None,
    }
}

/// Paints the diamond of a keyed cell, and takes its room.
fn keyed_mark(ui: &Ui, sheet: Sheet<'_>, (row, column): &Place, inner: &mut Rect) {
    let (Row::Light(id), Some(field)) = (row, column.field()) else { return };
    let Some((owned, target)) = sheet.target(id, field) else { return };
    let (fill, edge) = mark::inks(ui, owned.keys, &target);
    mark::diamond(ui, inner.left_center() + vec2(4.0, 0.0), 4.0, fill, edge);
    inner.min.x += 12.0;
}

fn seen(sheet: Sheet<'_>, color: [f64; 3]) -> Color32 {
    let light = Light { color, ..<_>::default() };
    swatch_of(&light, sheet.session.look().color_space)
}

/// Shows what a cell is, where its value comes from, and how it is changed.
pub(super) fn help(ui: &mut Ui, sheet: Sheet<'_>, (row, column): &Place, cell: &Cell) {
    ui.set_max_width(320.0);
    let name = sheet.full_name(row);
    ui.strong(tr!("{label} of {name}", label = column.label()));
    let dim = theme::of(ui).dim;
    if let (Row::Light(id), Some(field)) = (row, column.field())
        && let Some((owned, target)) = sheet.target(id, field)
        && let Some(changed) = ChangedValue::of(sheet.session, owned.owner, &target.to_string())
    {
        ui.label(changed.help());
    }
    if cell.value.is_none() {
        let text = match (row, sheet.scene()) {
            (Row::Group(group), None) => {
                let (count, _) = sheet.count(group);
                trn!(
                    count,
                    "{count} light. Groups have masters in scenes: add an object to begin one.",
                    "{count} lights. Groups have masters in scenes: add an object to begin one."
                )
            }
            (Row::Group(_), _) => tr!("Groups have no such field").to_owned(),
            (Row::Light(_), _) => tr!("Lights of this type have no such field").to_owned(),
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
        (true, _) => tr!("A click or Space turns all selected ones"),
        (_, true) => {
            tr!("Enter or double click to change all selected cells; or type: 0.5, *1.2, +0.1, \
                 50%. Alt and an arrow key nudge them, K keys them, Delete resets them.")
        }
        _ if *column == Column::Id => "",
        _ => tr!("Enter or double click to change all selected cells; or just type"),
    };
    if !keys.is_empty() {
        ui.label(egui::RichText::new(keys).small().color(dim));
    }
}
