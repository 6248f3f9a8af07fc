//! Bars whose parts go into a menu "..." at their end where the panel has no room for them, so that
//! none is lost.

use std::fmt::Debug;
use std::hash::Hash;
use std::ops::Range;

use chiaro_locale::tr;
use eframe::egui::{Id, Role, Ui, UiBuilder, WidgetInfo};

use super::menu;

/// Least width of the button of the menu, in points.
const BUTTON: f32 = 20.0;

/// Layout of a bar: indices of its parts by row. The index `shown`, where a row has it, is the
/// button of the menu with the parts from there on.
#[derive(Debug, PartialEq)]
struct BarPlan {
    rows: Vec<Range<usize>>,
    /// Number of parts that have room.
    shown: usize,
}

impl BarPlan {
    /// Lays out parts of these widths in rows of `room`, `gap` apart, as the first of them that
    /// have room beside a button of the width `more`. All lengths are in points.
    fn new(widths: &[f32], gap: f32, room: f32, rows: usize, more: f32) -> Self {
        let all = wrapped(widths, gap, room);
        if all.len() <= rows {
            return Self { rows: all, shown: widths.len() };
        }
        let with_more = |shown: usize| {
            let widths: Vec<f32> = widths[..shown].iter().copied().chain([more]).collect();
            Self { rows: wrapped(&widths, gap, room), shown }
        };
        let fitting = (0..widths.len()).rev().map(with_more);
        fitting.into_iter().find(|plan| plan.rows.len() <= rows).unwrap_or_else(|| with_more(0))
    }
}

/// Rows that widths fill one after the other, as indices.
fn wrapped(widths: &[f32], gap: f32, room: f32) -> Vec<Range<usize>> {
    let mut rows = Vec::new();
    let (mut start, mut end) = (0, 0.0);
    for (index, width) in widths.iter().enumerate() {
        let next = if index == start { *width } else { end + gap + width };
        if index > start && next > room {
            rows.push(start..index);
            (start, end) = (index, *width);
        } else {
            end = next;
        }
    }
    rows.push(start..widths.len());
    rows
}

/// Shows the parts of a bar, the most needed first: in the row of `ui`, or else in at most so many
/// rows below each other. Parts without room there are in a menu after them. `add` shows a part, in
/// the bar or in the menu.
pub(crate) fn overflowing<P: Copy + Debug + Hash>(
    ui: &mut Ui,
    salt: &str,
    rows: usize,
    parts: &[P],
    mut add: impl FnMut(&mut Ui, P),
) {
    let bar = ui.scope_id().with(("bar", salt));
    let more = bar.with("more");
    let keys: Vec<Id> = parts.iter().map(|part| bar.with(("part", part))).collect();
    // The widths are those of the frame in which a part was last in the bar.
    let known = |ui: &Ui, key: Id| ui.data(|data| data.get_temp::<f32>(key)).unwrap_or_default();
    let (gap, room) = (ui.spacing().item_spacing.x, ui.available_width());
    let planned = |ui: &Ui| {
        let widths: Vec<f32> = keys.iter().map(|key| known(ui, *key)).collect();
        BarPlan::new(&widths, gap, room, rows, known(ui, more).max(BUTTON))
    };
    let plan = planned(ui);
    let mut is_new = false;
    let mut show_row = |ui: &mut Ui, row: Range<usize>| {
        for index in row {
            let key = if index < plan.shown { keys[index] } else { more };
            let shown = ui.scope_builder(UiBuilder::new().id_salt(key), |ui| {
                match parts.get(index).filter(|_| index < plan.shown) {
                    Some(part) => add(ui, *part),
                    None => rest(ui, &parts[plan.shown..], &mut add),
                }
            });
            let width = shown.response.rect.width();
            is_new |= known(ui, key) == 0.0 && width > 0.0;
            ui.data_mut(|data| data.insert_temp(key, width));
        }
    };
    let is_in_row = ui.layout().is_horizontal();
    for row in plan.rows.clone() {
        match is_in_row {
            true => show_row(ui, row),
            false => drop(ui.horizontal(|ui| show_row(ui, row))),
        }
    }
    if is_new || planned(ui) != plan {
        ui.ctx().request_discard("the parts of a bar have other widths");
        // Where the frame cannot be drawn anew, the next one is right.
        ui.ctx().request_repaint();
    }
}

/// Shows the menu of the parts without room.
fn rest<P: Copy + Debug + Hash>(ui: &mut Ui, parts: &[P], add: &mut impl FnMut(&mut Ui, P)) {
    let button = menu::staying(ui, "...", |ui| {
        for part in parts {
            ui.push_id(part, |ui| ui.horizontal(|ui| add(ui, *part)));
        }
    });
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("More of this bar")));
    button.on_hover_text(tr!("Controls that have no room in this bar"));
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTHS: [f32; 4] = [60.0, 30.0, 40.0, 20.0];

    fn plan(room: f32, rows: usize) -> BarPlan {
        BarPlan::new(&WIDTHS, 5.0, room, rows, 15.0)
    }

    /// The plan whose rows end before these parts.
    fn ending(ends: &[usize], shown: usize) -> BarPlan {
        let starts = std::iter::once(&0).chain(ends);
        BarPlan { rows: starts.zip(ends).map(|(&start, &end)| start..end).collect(), shown }
    }

    #[test]
    fn a_bar_with_room_has_all_its_parts_and_no_menu() {
        assert_eq!(plan(165.0, 1), ending(&[4], 4));
        assert_eq!(plan(95.0, 2), ending(&[2, 4], 4));
        assert_eq!(BarPlan::new(&[], 5.0, 0.0, 1, 15.0), ending(&[0], 0));
    }

    #[test]
    fn the_last_parts_go_first_and_the_menu_has_room_after_the_others() {
        // 60 + 5 + 30 + 5 + 40 would fit, but not with the button after them.
        assert_eq!(plan(150.0, 1), ending(&[3], 2));
        assert_eq!(plan(115.0, 1), ending(&[3], 2));
        assert_eq!(plan(114.0, 1), ending(&[2], 1));
        assert_eq!(plan(10.0, 1), ending(&[1], 0));
        assert_eq!(plan(80.0, 2), ending(&[1, 3], 2));
    }

    #[test]
    fn no_part_is_lost_and_no_row_is_wider_than_the_bar() {
        for room in 15..200 {
            for rows in 1..4 {
                let room = room as f32;
                let BarPlan { rows: planned, shown } = plan(room, rows);
                assert!(planned.len() <= rows, "{room}: {planned:?}");
                let last = planned.last().unwrap().end;
                assert_eq!(last, if shown < WIDTHS.len() { shown + 1 } else { shown });
                for row in planned {
                    let width = |at: usize| if at < shown { WIDTHS[at] } else { 15.0 };
                    let all: f32 = row.clone().map(width).sum();
                    let gaps = row.len().saturating_sub(1) as f32 * 5.0;
                    assert!(row.len() == 1 || all + gaps <= room, "{room}: {row:?}");
                }
            }
        }
    }
}
