//! Dialog for the grid of an HCBTF, asked for before one is made or divided otherwise; shows the
//! memory that the grid takes.

use std::sync::Arc;

use chiaro_locale::{tr, trn};
use eframe::egui::{self, Button, Id, Modal, RichText, Ui, WidgetInfo};

use super::memory;
use crate::commands::{Command, PaintCommand};
use crate::document::{Address, Directions, Grid, MAX_ANGLE_STEPS, MAX_TILE_SIDE, Tile};
use crate::hcbtf::Device;
use crate::state::painting::work::OpenPainting;
use crate::state::problem_text::sentence;
use crate::widgets::confirm;
use crate::widgets::number::number_field;
use crate::widgets::rows::lead;
use crate::widgets::theme;

/// Width of labels before fields, in points.
pub(super) const LEAD: f32 = 48.0;

/// Choices in the dialog for a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct GridDialog {
    grid: Grid,
    /// True to divide the open HCBTF otherwise, false to make a new one.
    changes: bool,
}

impl GridDialog {
    /// Dialog that begins with the grid of the open HCBTF, or with that of the thesis.
    pub(super) fn of(work: Option<&OpenPainting>, changes: bool) -> Self {
        Self {
            grid: work.map_or(Grid::THESIS, |work| *work.grid()),
            changes: changes && work.is_some(),
        }
    }
}

/// Shows the dialog while `asked` is set.
pub(super) fn show(
    ui: &Ui,
    asked: &mut Option<GridDialog>,
    work: Option<&OpenPainting>,
    device: &Device,
) -> Option<Command> {
    let GridDialog { mut grid, changes } = (*asked)?;
    let work = work.filter(|_| changes);
    let mut out = None;
    let mut is_over = false;
    let modal = Modal::new(Id::unique("grid")).show(ui.ctx(), |ui| {
        ui.set_width(430.0);
        let enters = confirm::enters(ui);
        let title = if work.is_some() {
            tr!("Divide the painted surface otherwise")
        } else {
            tr!("A new painted surface")
        };
        ui.label(RichText::new(title).heading());
        ui.add_space(6.0);
        fields(ui, &mut grid);
        ui.add_space(6.0);
        memory::table(ui, &grid, None, device);
        ui.add_space(6.0);
        let refused = device.check_painted(&grid).err();
        if let Some(problem) = &refused {
            ui.label(RichText::new(sentence(problem)).color(theme::of(ui).error));
        } else if let Some(work) = work {
            let color =
                if lost(work, &grid) > 0 { ui.visuals().warn_fg_color } else { theme::of(ui).dim };
            ui.label(RichText::new(what_stays(work, &grid)).color(color));
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let label = match work.map(|work| lost(work, &grid)) {
                None => tr!("Make it").to_owned(),
                Some(0) => tr!("Divide it").to_owned(),
                Some(count) => trn!(
                    count,
                    "Divide it, and lose {count} painted sample",
                    "Divide it, and lose {count} painted samples"
                ),
            };
            let is_other = work.is_none_or(|work| *work.grid() != grid);
            let is_ready = refused.is_none() && is_other;
            if ui.add_enabled(is_ready, Button::new(label)).clicked() || enters && is_ready {
                out = Some(Command::Paint(match work {
                    Some(work) => PaintCommand::Divide { grid, lost: lost(work, &grid) },
                    None => PaintCommand::New { grid, keeps_look: false },
                }));
                is_over = true;
            }
            is_over |= ui.button(tr!("Cancel")).clicked();
        });
    });
    is_over |= modal.should_close();
    *asked = (!is_over).then_some(GridDialog { grid, changes });
    out
}

/// Number of painted samples that have no place in another grid.
fn lost(work: &OpenPainting, grid: &Grid) -> usize {
    let stays = |(address, tile): &(&Address, &Arc<Tile>)| {
        grid.contains(**address) && tile.size() == grid.size
    };
    let painted = &work.hcbtf().painted;
    painted.len() - painted.iter().filter(stays).count()
}

/// Text on which painted samples stay in another grid.
fn what_stays(work: &OpenPainting, grid: &Grid) -> String {
    let all = work.hcbtf().painted.len();
    match (lost(work, grid), all) {
        (_, 0) => tr!("Nothing is painted yet").to_owned(),
        (0, _) => tr!("All painted samples stay, at the rings and steps where they are").to_owned(),
        (lost, all) => {
            if work.grid().size == grid.size {
                trn!(
                    all,
                    "{lost} of {all} painted sample would be lost: they are at rings and steps \
                     that there are no more. Undo brings them back",
                    "{lost} of {all} painted samples would be lost: they are at rings and steps \
                     that there are no more. Undo brings them back"
                )
            } else {
                trn!(
                    all,
                    "{lost} of {all} painted sample would be lost: tiles are not resampled to \
                     another size. Undo brings them back",
                    "{lost} of {all} painted samples would be lost: tiles are not resampled to \
                     another size. Undo brings them back"
                )
            }
        }
    }
}

/// Shows the fields of a grid.
pub(super) fn fields(ui: &mut Ui, grid: &mut Grid) {
    size(ui, &mut grid.size);
    directions(ui, tr!("Lights"), &mut grid.light);
    directions(ui, tr!("Views"), &mut grid.view);
}

/// Shows the fields of a tile's size.
pub(super) fn size(ui: &mut Ui, size: &mut [u32; 2]) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        lead(ui, tr!("Tile"), LEAD);
        let [width, height] = size;
        for (value, name, between) in
            [(width, tr!("Texels across"), "x"), (height, tr!("Texels down"), tr!("texels"))]
        {
            let drag = ui.add(number_field(ui, value).range(1..=MAX_TILE_SIDE).speed(0.2));
            drag.widget_info(|| named(name, *value));
            ui.label(between);
        }
    });
}

/// Shows the fields for the numbers of rings and steps.
pub(super) fn directions(ui: &mut Ui, name: &str, directions: &mut Directions) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        lead(ui, name, LEAD);
        let rings = ui.add(
            number_field(ui, &mut directions.theta)
                .range(1..=MAX_ANGLE_STEPS)
                .speed(0.05)
                .suffix(format!(" {}", tr!("rings"))),
        );
        rings.widget_info(|| named(&tr!("{name}: rings"), directions.theta));
        ui.label("x");
        let steps = ui.add(
            number_field(ui, &mut directions.phi)
                .range(1..=MAX_ANGLE_STEPS)
                .speed(0.05)
                .suffix(format!(" {}", tr!("steps"))),
        );
        steps.widget_info(|| named(&tr!("{name}: steps"), directions.phi));
        let count = directions.distinct_count();
        let text = trn!(count, "{count} direction", "{count} directions");
        ui.label(RichText::new(text).color(theme::of(ui).dim));
    });
}

fn named(name: &str, value: u32) -> WidgetInfo {
    WidgetInfo {
        label: Some(name.to_owned()),
        ..egui::WidgetInfo::drag_value(true, f64::from(value))
    }
}
