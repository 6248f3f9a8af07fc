//! What the panel shows while nothing is open to be painted.

use eframe::egui::{RichText, Ui};

use super::memory::in_short;
use super::{Wish, command};
use crate::document::{Directions, Grid};
use crate::editor::command::Command;
use crate::editor::theme;

/// A grid to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Preset {
    Small,
    Thesis,
    Large,
    Fine,
}

impl Preset {
    pub(super) const ALL: [Self; 4] = [Self::Small, Self::Thesis, Self::Large, Self::Fine];

    /// What is made.
    pub(crate) fn grid(self) -> Grid {
        let directions = |theta, phi| Directions { theta, phi };
        let of = |side, directions| Grid { size: [side, side], light: directions, view: directions };
        match self {
            Self::Small => of(16, directions(3, 6)),
            Self::Thesis => Grid::THESIS,
            Self::Large => of(64, directions(6, 10)),
            Self::Fine => of(128, directions(3, 8)),
        }
    }

    fn label(self) -> &'static str {
        match self {
            Self::Small => "Small",
            Self::Thesis => "Thesis",
            Self::Large => "Large",
            Self::Fine => "Fine tile",
        }
    }

    fn help(self) -> &'static str {
        match self {
            Self::Small => "Few texels, few directions: to try things out",
            Self::Thesis => "The size of the thesis that HCBTFs come from",
            Self::Large => "The thesis's directions with finer strokes",
            Self::Fine => "Fine strokes that change little with light and eye",
        }
    }
}

/// Shows what to begin with.
pub(super) fn show(ui: &mut Ui, out: &mut Vec<Command>) {
    ui.vertical_centered(|ui| {
        ui.set_max_width(460.0);
        ui.add_space(ui.available_height() * 0.12);
        ui.heading("Paint a surface");
        ui.add_space(4.0);
        let text = "An HCBTF is a tile that you paint as it looks under one light and from one side, then under another: \
                    the surface shows what you painted, and rules fill in the rest.";
        ui.label(RichText::new(text).color(theme::of(ui).dim));
        ui.add_space(12.0);
        for preset in Preset::ALL {
            let grid = preset.grid();
            let directions = grid.light.distinct_count();
            let label = format!(
                "{}: {} x {} texels, {directions} lights x {} views",
                preset.label(),
                grid.size[0],
                grid.size[1],
                grid.view.distinct_count()
            );
            let button = ui.add_sized([400.0, 30.0], eframe::egui::Button::new(label));
            if button.on_hover_text(format!("{}: {}", preset.help(), in_short(&grid))).clicked() {
                out.push(command(Wish::New { grid, keeps_look: false }));
            }
        }
        let other = ui.add_sized([400.0, 30.0], eframe::egui::Button::new("Another grid..."));
        if other.on_hover_text("Any number of texels, lights and views, and what they take in memory").clicked() {
            out.push(command(Wish::AskGrid { changes: false }));
        }
        ui.add_space(8.0);
        if ui.add_sized([400.0, 30.0], eframe::egui::Button::new("Open an .hcbtf file...")).clicked() {
            out.push(Command::Open(None));
        }
        let help = "Images that were painted in other programs: a folder of them, a contact sheet, a sheet of the thesis";
        let import = ui.add_sized([400.0, 30.0], eframe::egui::Button::new("Import painted pictures..."));
        if import.on_hover_text(help).clicked() {
            out.push(command(Wish::AskImport));
        }
        let help = "Paints every sample as the open look shows it: a dear look becomes a quick one, or one to paint on";
        let bake = ui.add_sized([400.0, 30.0], eframe::egui::Button::new("Bake this look onto a tile..."));
        if bake.on_hover_text(help).clicked() {
            out.push(command(Wish::AskBake));
        }
    });
}
