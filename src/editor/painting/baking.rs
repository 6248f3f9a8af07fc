//! The open look becomes an HCBTF: which grid, and which light goes around the tile, is asked for first, then the file.

use eframe::egui::{self, Button, ComboBox, Id, Modal, RichText, Ui, WidgetInfo};

use super::making::{Bake, Job};
use super::{Wish, command, grid, memory};
use crate::document::{Grid, LightKind};
use crate::editor::command::Command;
use crate::editor::panels::problems::sentence;
use crate::editor::session::Session;
use crate::editor::theme;
use crate::frame::{SetupLook, moving_light};
use crate::hcbtf::{Device, check_all_painted};
use crate::ids::LightId;

/// What is asked.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Asked {
    grid: Grid,
    /// The one that was chosen; the first one else.
    light: Option<LightId>,
}

impl Default for Asked {
    fn default() -> Self {
        Self { grid: Grid::THESIS, light: None }
    }
}

impl Asked {
    /// The job, as the session stands now; why not otherwise.
    pub(super) fn job(&self, session: &Session, to: std::path::PathBuf) -> Result<Job, String> {
        let setup = setup(session);
        let light = moving_light(&setup, self.light.as_ref().map(AsRef::as_ref)).map_err(|why| sentence(&why))?;
        let still = session.still();
        Ok(Job::Bake(Box::new(Bake {
            setup,
            library: still.library,
            painting: still.painting,
            grid: self.grid,
            light,
            to,
        })))
    }
}

/// The look as it is, whatever is shown alone or muted in the picture.
fn setup(session: &Session) -> SetupLook {
    SetupLook { look: session.look().clone(), source: session.source().clone(), folder: session.folder() }
}

/// Asks, while `asked` is there. `is_filling` says that what the look shows is not there yet.
pub(super) fn show(
    ui: &Ui,
    asked: &mut Option<Asked>,
    session: &Session,
    device: &Device,
    is_filling: bool,
) -> Option<Command> {
    let state = asked.as_mut()?;
    let mut out = None;
    let mut is_over = false;
    let modal = Modal::new(Id::unique("bake")).show(ui.ctx(), |ui| {
        ui.set_width(430.0);
        ui.label(RichText::new("Bake this look onto a tile").heading());
        let text = "Every texel is painted as the look shows it on a flat tile, from every view and under one light that goes \
                    around; all its other lights stay where they are.";
        ui.label(RichText::new(text).color(theme::of(ui).dim));
        ui.add_space(6.0);
        grid::fields(ui, &mut state.grid);
        light(ui, session, &mut state.light);
        ui.add_space(6.0);
        memory::table(ui, &state.grid, None, device);
        ui.add_space(6.0);
        let named = state.light.as_ref().map(AsRef::as_ref);
        let refused = moving_light(&setup(session), named)
            .map(drop)
            .and_then(|()| check_all_painted(&state.grid))
            .and_then(|()| device.check_painted(&state.grid));
        if let Err(problem) = &refused {
            ui.label(RichText::new(sentence(problem)).color(theme::of(ui).error));
        } else if is_filling {
            ui.label(RichText::new("The rules of what it shows are still at work").color(theme::of(ui).dim));
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let button = ui.add_enabled(refused.is_ok() && !is_filling, Button::new("Bake to..."));
            if button.on_hover_text("Asks which .hcbtf file to write, and opens it when it is done").clicked() {
                out = Some(command(Wish::Bake { to: None }));
            }
            is_over |= ui.button("Cancel").clicked();
        });
    });
    is_over |= modal.should_close();
    if is_over {
        *asked = None;
    }
    out
}

/// Which light goes around.
fn light(ui: &mut Ui, session: &Session, chosen: &mut Option<LightId>) {
    let lights = &session.look().lights;
    let moving = || lights.iter().filter(|(_, light)| light.kind == LightKind::Directional);
    let name = |id: &LightId| lights.get(id).map(|light| light.name.clone()).filter(|name| !name.is_empty());
    let name = |id: &LightId| name(id).unwrap_or_else(|| id.to_string());
    let first = moving().next().map(|(id, _)| id);
    let shown = chosen.as_ref().or(first).map_or_else(|| "none".to_owned(), name);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        ui.add_sized([48.0, 20.0], egui::Label::new("Light"));
        let list = ComboBox::from_id_salt("light").width(180.0).selected_text(shown).show_ui(ui, |ui| {
            for (id, _) in moving() {
                let is_it = chosen.as_ref().or(first) == Some(id);
                if ui.selectable_label(is_it, name(id)).clicked() {
                    *chosen = Some(id.clone());
                }
            }
        });
        list.response.widget_info(|| WidgetInfo::labeled(egui::Role::ComboBox, true, "Light that goes around"));
    });
}
