//! How finely an HCBTF is divided, asked for before one is made or divided otherwise; what that takes is told at once.

use eframe::egui::{self, Button, DragValue, Id, Label, Modal, RichText, Ui, WidgetInfo};

use super::work::Work;
use super::{Wish, command, memory};
use crate::document::{Directions, Grid, HcbtfEdit, MAX_ANGLE_STEPS, MAX_TILE_SIDE};
use crate::editor::command::Command;
use crate::editor::panels::problems::sentence;
use crate::editor::theme;
use crate::hcbtf::Device;

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Asked {
    grid: Grid,
    /// Whether what is open is divided otherwise, in place of something new.
    changes: bool,
}

impl Asked {
    /// What to begin with: as what is open is divided, or as the thesis divides.
    pub(super) fn of(work: Option<&Work>, changes: bool) -> Self {
        Self { grid: work.map_or(Grid::THESIS, |work| *work.grid()), changes: changes && work.is_some() }
    }
}

/// Asks, while `asked` is there.
pub(super) fn show(ui: &Ui, asked: &mut Option<Asked>, work: Option<&Work>, device: &Device) -> Option<Command> {
    let Asked { mut grid, changes } = (*asked)?;
    let work = work.filter(|_| changes);
    let mut out = None;
    let mut is_over = false;
    let modal = Modal::new(Id::unique("grid")).show(ui.ctx(), |ui| {
        ui.set_width(430.0);
        let title = if work.is_some() { "Divide the HCBTF otherwise" } else { "A new HCBTF" };
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
            ui.label(RichText::new(what_stays(work, &grid)).color(theme::of(ui).dim));
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let label = if work.is_some() { "Divide it" } else { "Make it" };
            let is_other = work.is_none_or(|work| *work.grid() != grid);
            if ui.add_enabled(refused.is_none() && is_other, Button::new(label)).clicked() {
                out = Some(command(match work {
                    Some(_) => Wish::Edit(HcbtfEdit::SetGrid { grid }),
                    None => Wish::New { grid, keeps_look: false },
                }));
                is_over = true;
            }
            is_over |= ui.button("Cancel").clicked();
        });
    });
    is_over |= modal.should_close();
    *asked = (!is_over).then_some(Asked { grid, changes });
    out
}

/// What becomes of what is painted.
fn what_stays(work: &Work, grid: &Grid) -> String {
    let painted = &work.hcbtf().painted;
    let stays = painted.iter().filter(|(address, tile)| grid.contains(**address) && tile.size() == grid.size).count();
    match (stays, painted.len()) {
        (_, 0) => "Nothing is painted yet".to_owned(),
        (stays, all) if stays == all => "All painted samples stay, at the rings and steps where they are".to_owned(),
        (stays, all) => {
            format!("{stays} of {all} painted samples stay; nothing is resampled, and undo brings all back")
        }
    }
}

/// The fields of a grid.
pub(super) fn fields(ui: &mut Ui, grid: &mut Grid) {
    size(ui, &mut grid.size);
    directions(ui, "Lights", &mut grid.light);
    directions(ui, "Views", &mut grid.view);
}

/// The fields of a tile's size.
pub(super) fn size(ui: &mut Ui, size: &mut [u32; 2]) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        ui.add_sized([48.0, 20.0], Label::new("Tile"));
        let [width, height] = size;
        for (value, name, between) in [(width, "Texels across", "x"), (height, "Texels down", "texels")] {
            let drag = ui.add(DragValue::new(value).range(1..=MAX_TILE_SIDE).speed(0.2));
            drag.widget_info(|| named(name, *value));
            ui.label(between);
        }
    });
}

/// How many rings and steps there are.
pub(super) fn directions(ui: &mut Ui, name: &str, directions: &mut Directions) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        ui.add_sized([48.0, 20.0], Label::new(name));
        let rings =
            ui.add(DragValue::new(&mut directions.theta).range(1..=MAX_ANGLE_STEPS).speed(0.05).suffix(" rings"));
        rings.widget_info(|| named(&format!("{name}: rings"), directions.theta));
        ui.label("x");
        let steps = ui.add(DragValue::new(&mut directions.phi).range(1..=MAX_ANGLE_STEPS).speed(0.05).suffix(" steps"));
        steps.widget_info(|| named(&format!("{name}: steps"), directions.phi));
        let text = format!("{} directions", directions.distinct_count());
        ui.label(RichText::new(text).color(theme::of(ui).dim));
    });
}

fn named(name: &str, value: u32) -> WidgetInfo {
    WidgetInfo { label: Some(name.to_owned()), ..egui::WidgetInfo::drag_value(true, f64::from(value)) }
}
