//! Menu of a cell: keys, copies, resets, and what the scene has in a look's place.

use chiaro_locale::{tr, trn};
use eframe::egui::Ui;

use super::change::Entry;
use super::column::Column;
use super::grid::CellGrid;
use super::selection::{Place, ShownCells};
use super::sheet::{Row, Sheet};
use crate::commands::{Command, SceneCommand};
use crate::document::SceneEdit;
use crate::fields::lighting::Owner;
use crate::fields::marks::{self, FieldTarget};
use crate::ids::LightId;
use crate::library::Type;

/// Shows all entries.
pub(super) fn show(
    ui: &mut Ui,
    sheet: Sheet<'_>,
    shown: ShownCells<'_>,
    grid: &mut CellGrid,
    place: &Place,
    out: &mut Vec<Command>,
) {
    ui.set_min_width(190.0);
    let count = grid.selection.len();
    let of = |one: &'static str, many: String| if count == 1 { one.to_owned() } else { many };
    if !place.1.is_switch() && place.1 != Column::Id {
        let help = tr!("Enter or a double click does, too; all selected cells take what is set");
        if ui.button(of(tr!("Edit"), tr!("Edit {count} cells"))).on_hover_text(help).clicked() {
            grid.begin(ui, sheet, place, None);
            ui.close();
        }
    }
    if ui
        .button(of(tr!("Copy"), tr!("Copy {count} cells")))
        .on_hover_text(tr!("As a table, for Ctrl+V here or elsewhere"))
        .clicked()
    {
        out.push(Command::Copy(grid.copied(sheet, shown)));
        ui.close();
    }
    let help = tr!("The value that the look's light has, or else that of a new light (Delete)");
    let text = of(tr!("Reset"), tr!("Reset {count} cells"));
    if place.1 != Column::Id && ui.button(text).on_hover_text(help).clicked() {
        grid.enter(sheet, shown, &Entry::Reset, None, out);
        ui.close();
    }
    keys(ui, sheet, grid, place, out);
    let ids = replaced(sheet, shown, grid);
    if !ids.is_empty() {
        ui.separator();
        let text = match ids.as_slice() {
            [_] => tr!("As the look has it").to_owned(),
            ids => tr!("As the looks have them ({count})", count = ids.len()),
        };
        let help = tr!("Removes the scene's light: the look's own light of this id shines again");
        if ui.button(text).on_hover_text(help).clicked() {
            let edits = ids.into_iter().map(|id| SceneEdit::RemoveLight { id }).collect();
            out.push(Command::Scene(SceneCommand::Edit(SceneEdit::Group { edits })));
            ui.close();
        }
    }
}

/// Shows what keys do with the cell, and with all selected ones.
fn keys(
    ui: &mut Ui,
    sheet: Sheet<'_>,
    grid: &CellGrid,
    (row, column): &Place,
    out: &mut Vec<Command>,
) {
    let targets = grid.targets(sheet);
    let (Row::Light(id), Some(field)) = (row, column.field()) else { return };
    if targets.is_empty() {
        return;
    }
    ui.separator();
    if targets.len() > 1 {
        let text = trn!(
            count = targets.len(),
            "Key {count} cell at the playhead",
            "Key {count} cells at the playhead"
        );
        if ui
            .button(text)
            .on_hover_text(tr!("Each with its present value, as one step (K)"))
            .clicked()
        {
            out.extend(grid.keying(sheet));
            ui.close();
        }
        return;
    }
    let Some((owned, target)) = sheet.target(id, field) else { return };
    let ty = Type::of_light_field(field);
    let label = field.label();
    let marked = FieldTarget { owned, target, ty: &ty, label, reset: None };
    marks::menu(ui, &marked, out);
}

/// Lights of the scene in selected rows that stand in place of a look's.
fn replaced(sheet: Sheet<'_>, shown: ShownCells<'_>, grid: &CellGrid) -> Vec<LightId> {
    let is_selected = |row: &&Row| {
        shown.columns.iter().any(|column| grid.selection.has(&((*row).clone(), *column)))
    };
    let lights = shown.rows.iter().filter(is_selected).filter_map(|row| match row {
        Row::Light(id) => Some(id),
        Row::Group(_) => None,
    });
    let of_scene = Owner::Scene.lights(sheet.session);
    let is_both = |id: &&LightId| {
        of_scene.is_some_and(|lights| lights.contains_key(*id))
            && sheet.lights.shared().contains_key(*id)
    };
    lights.filter(is_both).cloned().collect()
}
