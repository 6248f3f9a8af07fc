//! Baking of the open look to an HCBTF: a dialog asks for the grid and for the light that goes
//! around the tile, then for the file.

use chiaro_locale::{tr, trn};
use eframe::egui::{
    self, Button, CollapsingHeader, Color32, ComboBox, Id, Modal, RichText, Sense, Ui, WidgetInfo,
    vec2,
};

use super::making::{Bake, MakeRequest, told_seconds};
use super::preview::{self, Preview, PreviewInputs};
use super::{grid, memory};
use crate::commands::{Command, PaintCommand};
use crate::document::{Grid, LightKind};
use crate::frame::{SetupLook, moving_light};
use crate::hcbtf::{Device, check_all_painted};
use crate::ids::LightId;
use crate::state::painting::work::OpenPainting;
use crate::state::problem_text::sentence;
use crate::state::session::Session;
use crate::widgets::confirm;
use crate::widgets::rows::{fitted, lead, picture_frame, whole};
use crate::widgets::theme;

/// Side of a preview, in points.
const SIDE: f32 = 110.0;

/// Choices in the dialog for baking.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BakeDialog {
    grid: Grid,
    /// Light that was chosen; `None` for the first directional light.
    light: Option<LightId>,
}

impl Default for BakeDialog {
    fn default() -> Self {
        Self { grid: Grid::THESIS, light: None }
    }
}

impl BakeDialog {
    /// Job that bakes the session's look as it is now, or the reason why it cannot be baked.
    pub(super) fn job(
        &self,
        session: &Session,
        to: std::path::PathBuf,
    ) -> Result<MakeRequest, String> {
        let setup = setup(session);
        let light = moving_light(&setup, self.light.as_ref().map(AsRef::as_ref))
            .map_err(|why| sentence(&why))?;
        let snapshot = session.snapshot();
        Ok(MakeRequest::Bake(Box::new(Bake {
            setup,
            library: snapshot.library,
            painting: snapshot.painting,
            assets: snapshot.assets,
            grid: self.grid,
            light,
            to,
        })))
    }
}

/// The look as it is in the document, without the soloing and muting of the picture.
fn setup(session: &Session) -> SetupLook {
    SetupLook {
        look: session.look().clone(),
        source: session.look.file.source.clone(),
        folder: session.look.folder(),
    }
}

/// Shows the dialog while `asked` is set. `is_filling` says that rules still fill a painting that
/// the look shows.
pub(super) fn show(
    ui: &Ui,
    asked: &mut Option<BakeDialog>,
    preview: &mut Preview,
    session: &Session,
    device: &Device,
    is_filling: bool,
) -> Option<Command> {
    let state = asked.as_mut()?;
    let mut out = None;
    let mut is_over = false;
    let modal = Modal::new(Id::unique("bake")).show(ui.ctx(), |ui| {
        ui.set_width(460.0);
        let enters = confirm::enters(ui);
        ui.label(RichText::new(tr!("Bake this look onto a tile")).heading());
        let text = tr!(
            "Every texel is painted as the look shows it on a flat tile, from every view and under \
             one light that goes around; all its other lights stay where they are."
        );
        ui.label(RichText::new(text).color(theme::of(ui).dim));
        ui.add_space(6.0);
        grid::fields(ui, &mut state.grid);
        light(ui, session, &mut state.light);
        ui.add_space(6.0);
        let named = state.light.as_ref().map(AsRef::as_ref);
        let light = moving_light(&setup(session), named);
        let refused = light
            .as_ref()
            .map(drop)
            .map_err(Clone::clone)
            .and_then(|()| check_all_painted(&state.grid))
            .and_then(|()| device.check_painted(&state.grid));
        if let (Ok(light), Ok(()), false) = (&light, &refused, is_filling) {
            before_baking(ui, preview, session, &state.grid, light);
        }
        ui.add_space(6.0);
        let title = tr!("Memory: {memory}", memory = memory::in_short(&state.grid));
        CollapsingHeader::new(title).id_salt("memory of a bake").show(ui, |ui| {
            memory::table(ui, &state.grid, None, device);
        });
        ui.add_space(6.0);
        if let Err(problem) = &refused {
            ui.label(RichText::new(sentence(problem)).color(theme::of(ui).error));
        } else if is_filling {
            ui.label(
                RichText::new(tr!("The rules of what it shows are still at work"))
                    .color(theme::of(ui).dim),
            );
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let is_ready = refused.is_ok() && !is_filling;
            let button = ui.add_enabled(is_ready, Button::new(tr!("Bake to...")));
            let button = button.on_hover_text(tr!(
                "Asks which .hcbtf file to write, and opens it when it is done"
            ));
            if button.clicked() || enters && is_ready {
                out = Some(Command::Paint(PaintCommand::Bake { to: None }));
            }
            is_over |= ui.button(tr!("Cancel")).clicked();
        });
    });
    is_over |= modal.should_close();
    if is_over || out.is_some() {
        preview.stop();
    }
    if is_over {
        *asked = None;
    }
    out
}

/// Shows the time that baking takes, the amount it writes, and previews of the result.
fn before_baking(
    ui: &mut Ui,
    preview: &mut Preview,
    session: &Session,
    grid: &Grid,
    light: &LightId,
) {
    let painting = session.painting().map(OpenPainting::revision);
    let of = PreviewInputs {
        look: (session.revisions().document, session.revisions().meaning, painting),
        size: grid.size,
        light: light.clone(),
    };
    let job = || {
        let snapshot = session.snapshot();
        preview::PreviewRequest {
            setup: setup(session),
            library: snapshot.library,
            painting: snapshot.painting,
            assets: snapshot.assets,
        }
    };
    let made = preview.of(&of, job).map(|made| match made {
        Ok(seen) => Ok((seen.tiles.clone(), seen.seconds_of(grid, crate::threads::cores()))),
        Err(problem) => Err(sentence(problem)),
    });
    let count = grid.sample_count();
    let text = match &made {
        None => trn!(count, "{count} sample will be painted", "{count} samples will be painted"),
        Some(Ok((_, seconds))) => trn!(
            count,
            "{count} sample will be painted, in about {time}",
            "{count} samples will be painted, in about {time}",
            time = told_seconds(*seconds)
        ),
        Some(Err(why)) => {
            ui.label(RichText::new(why).color(theme::of(ui).error));
            return;
        }
    };
    ui.label(text);
    ui.horizontal(|ui| {
        let tiles = made.and_then(Result::ok).map(|(tiles, _)| tiles);
        for (index, name) in
            [tr!("Lit from straight above"), tr!("Lit from halfway down")].into_iter().enumerate()
        {
            let tile = tiles.as_ref().map(|tiles| &tiles[index]);
            let texture = tile.map(|tile| {
                (preview.shown[index].of(ui.ctx(), "preview of a bake", tile), tile.size())
            });
            let (rect, response) = ui.allocate_exact_size(vec2(SIDE, SIDE), Sense::hover());
            response.widget_info(|| WidgetInfo::labeled(egui::Role::Image, true, name));
            ui.painter().rect_filled(rect, 3.0, theme::of(ui).canvas);
            if let Some((texture, size)) = texture {
                ui.painter().image(
                    texture,
                    fitted(rect.shrink(1.0), size),
                    whole(),
                    Color32::WHITE,
                );
            }
            picture_frame(ui, rect);
            response.on_hover_text(tr!(
                "{name}, seen from straight above: a preview of what will be painted"
            ));
        }
    });
    let text = tr!(
        "Seen from straight above, lit from straight above and from halfway down. What is finer \
         than a texel is lost."
    );
    ui.label(RichText::new(text).color(theme::of(ui).dim).small());
}

/// Shows the choice of the light that goes around.
fn light(ui: &mut Ui, session: &Session, chosen: &mut Option<LightId>) {
    let lights = &session.look().lights;
    let moving = || lights.iter().filter(|(_, light)| light.kind == LightKind::Directional);
    let name = |id: &LightId| {
        lights.get(id).map(|light| light.name.clone()).filter(|name| !name.is_empty())
    };
    let name = |id: &LightId| name(id).unwrap_or_else(|| id.to_string());
    let first = moving().next().map(|(id, _)| id);
    let shown = chosen.as_ref().or(first).map_or_else(|| tr!("light" => "none").to_owned(), name);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        lead(ui, tr!("Light"), grid::LEAD);
        let list =
            ComboBox::from_id_salt("light").width(180.0).selected_text(shown).show_ui(ui, |ui| {
                for (id, _) in moving() {
                    let is_it = chosen.as_ref().or(first) == Some(id);
                    if ui.selectable_label(is_it, name(id)).clicked() {
                        *chosen = Some(id.clone());
                    }
                }
            });
        list.response.widget_info(|| {
            WidgetInfo::labeled(egui::Role::ComboBox, true, tr!("Light that goes around"))
        });
    });
}
