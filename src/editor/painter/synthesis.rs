//! Dialog for a new tile made of patches of the painted one: asks for the layout and shows the new
//! tile before it is taken. The painted tile stays as it is.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::epaint::Mesh;
use eframe::egui::{
    Align2, Button, Color32, FontId, Id, Modal, Rect, RichText, Sense, Shape, TextureId, Ui,
    WidgetInfo, pos2, vec2,
};

use super::making::{HcbtfWorker, MakeRequest, SynthesizedTile, bar};
use super::textures::TileTexture;
use super::{grid, memory};
use crate::commands::{Command, PaintCommand};
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf};
use crate::hcbtf::{Device, FilledSamples, Synthesis};
use crate::state::painting::work::OpenPainting;
use crate::state::problem_text::sentence;
use crate::widgets::confirm;
use crate::widgets::number::number_field;
use crate::widgets::rows::lead;
use crate::widgets::theme;

/// Side of a picture, in points.
const SIDE: f32 = 220.0;

/// Choices in the dialog, and the result of the last ones.
pub(super) struct SynthesisDialog {
    how: Synthesis,
    /// HCBTF that patches are taken from, in its state when the dialog was opened.
    of: Arc<Hcbtf>,
    filled: Option<Arc<FilledSamples>>,
    at: Address,
    /// Choices of the last request.
    asked: Option<Synthesis>,
    made: Option<Result<SynthesizedTile, Diagnostic>>,
    before: TileTexture,
    after: TileTexture,
}

impl SynthesisDialog {
    pub(super) fn of(work: &OpenPainting, filled: Option<Arc<FilledSamples>>) -> Self {
        let of = work.shown().clone();
        let how = Synthesis { size: of.grid.size, seed: 1, patch: None };
        let (before, after) = (TileTexture::default(), TileTexture::default());
        Self { how, of, filled, at: work.at(), asked: None, made: None, before, after }
    }

    /// Takes the result.
    pub(super) fn take(&mut self, made: Result<SynthesizedTile, Diagnostic>) {
        self.made = Some(made);
    }
}

/// Shows the dialog while `asked` is set; `work` is the open painting.
pub(super) fn show(
    ui: &Ui,
    asked: &mut Option<SynthesisDialog>,
    making: &mut HcbtfWorker,
    work: Option<&OpenPainting>,
    device: &Device,
) -> Option<Command> {
    let state = asked.as_mut()?;
    let mut out = None;
    let mut is_over = work.is_none();
    let modal = Modal::new(Id::unique("synthesis")).show(ui.ctx(), |ui| {
        ui.set_width(2.0 * SIDE + 12.0);
        let enters = confirm::enters(ui);
        ui.label(RichText::new(tr!("New tile from this painting")).heading());
        let text = tr!(
            "Patches of the painted tile are laid side by side, in all samples at the same places, \
             and cut where that is seen least. The new tile repeats; what is painted stays as it \
             is."
        );
        ui.label(RichText::new(text).color(theme::of(ui).dim));
        ui.add_space(6.0);
        fields(ui, state);
        ui.add_space(6.0);
        let own = work.and_then(|work| work.tile(state.at)).cloned();
        let made = state.made.as_ref().filter(|_| making.share().is_none());
        let new = made.and_then(|made| made.as_ref().ok()?.1.clone());
        ui.horizontal(|ui| {
            let before =
                own.map(|tile| (state.before.of(ui.ctx(), "painted tile", &tile), tile.size()));
            // Both pictures show texels at the same size.
            let most = state.how.size.into_iter().chain(state.of.grid.size).max().unwrap_or(1);
            picture(ui, tr!("Painted"), before, most);
            let after = new.map(|tile| (state.after.of(ui.ctx(), "new tile", &tile), tile.size()));
            picture(ui, tr!("New"), after, most);
        });
        match making.share() {
            Some(share) => {
                ui.horizontal(|ui| {
                    if ui
                        .button(tr!("Stop"))
                        .on_hover_text(tr!("Lays no more patches, until something is changed"))
                        .clicked()
                    {
                        making.stop();
                        state.made = None;
                    }
                    bar(ui, share);
                });
            }
            None => {
                let lines = ui.spacing().interact_size.y;
                let (text, is_wrong) = told(state, device);
                let color = if is_wrong { theme::of(ui).error } else { theme::of(ui).dim };
                ui.allocate_ui(vec2(2.0 * SIDE, lines), |ui| {
                    ui.label(RichText::new(text).color(color))
                });
            }
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let ready = ready(state, device).filter(|_| making.share().is_none());
            let button =
                ui.add_enabled(ready.is_some(), Button::new(tr!("Begin it as a new painting")));
            let button = button.on_hover_text(tr!("Opens it to be painted on, without a file yet"));
            if button.clicked() || enters && ready.is_some() {
                out = ready.map(|hcbtf| Command::Paint(PaintCommand::Begin { hcbtf }));
                is_over = true;
            }
            is_over |= ui.button(tr!("Cancel")).clicked();
        });
    });
    if state.asked != Some(state.how) {
        state.asked = Some(state.how);
        state.made = None;
        let (hcbtf, filled) = (state.of.clone(), state.filled.clone());
        making.begin(MakeRequest::Synthesize { hcbtf, filled, how: state.how, at: state.at });
    }
    if is_over || modal.should_close() {
        making.stop();
        *asked = None;
    }
    out
}

/// New HCBTF, once it is made and fits the device.
fn ready(asked: &SynthesisDialog, device: &Device) -> Option<Arc<Hcbtf>> {
    let (hcbtf, _) = asked.made.as_ref()?.as_ref().ok()?;
    device.check_painted(&hcbtf.grid).is_ok().then(|| hcbtf.clone())
}

/// Text on the result, and true if it is an error.
fn told(asked: &SynthesisDialog, device: &Device) -> (String, bool) {
    let grid = Grid { size: asked.how.size, ..asked.of.grid };
    let refused = device.check_painted(&grid).err();
    let wrong = asked.made.as_ref().and_then(|made| made.as_ref().err()).or(refused.as_ref());
    match (wrong, &asked.made) {
        (Some(problem), _) => (sentence(problem), true),
        (None, Some(Ok((hcbtf, _)))) => {
            let (painted, all) = (hcbtf.painted.len(), hcbtf.grid.sample_count());
            let memory = memory::in_short(&grid);
            (tr!("{painted} of {all} samples are painted: {memory}"), false)
        }
        (None, _) => (tr!("Stopped: change something to lay it anew").to_owned(), false),
    }
}

fn fields(ui: &mut Ui, asked: &mut SynthesisDialog) {
    let how = &mut asked.how;
    grid::size(ui, &mut how.size);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let help = tr!("Another number lays other patches");
        let label = lead(ui, tr!("Seed"), grid::LEAD).on_hover_text(help).id;
        ui.add(number_field(ui, &mut how.seed).speed(0.1)).labelled_by(label).on_hover_text(help);
        if ui.button(tr!("Another")).on_hover_text(tr!("Takes the next number")).clicked() {
            how.seed = how.seed.wrapping_add(1);
        }
        ui.add_space(12.0);
        let shortest = asked.of.grid.size[0].min(asked.of.grid.size[1]);
        let mut is_own = how.patch.is_some();
        let help =
            tr!("Large patches keep large forms whole; else they are half as wide as the tile");
        if ui.checkbox(&mut is_own, tr!("Patches of")).on_hover_text(help).changed() {
            how.patch = is_own.then_some(shortest / 2);
        }
        let mut texels = how.patch.unwrap_or(shortest / 2);
        let most = shortest.min(how.size[0]).min(how.size[1]).saturating_sub(1).max(3);
        let drag = number_field(ui, &mut texels)
            .range(3..=most)
            .speed(0.1)
            .suffix(format!(" {}", tr!("texels")));
        let drag = ui.add_enabled(is_own, drag);
        drag.widget_info(|| WidgetInfo {
            label: Some(tr!("Texels along a patch").to_owned()),
            ..WidgetInfo::drag_value(is_own, f64::from(texels))
        });
        if drag.changed() {
            how.patch = Some(texels);
        }
    });
}

/// Shows a tile repeated twice in each direction, so that its seams are seen; a tile with `most`
/// texels along a side fills the picture.
fn picture(ui: &mut Ui, name: &str, tile: Option<(TextureId, [u32; 2])>, most: u32) {
    let (rect, response) = ui.allocate_exact_size(vec2(SIDE, SIDE), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(eframe::egui::Role::Image, true, name));
    let colors = theme::of(ui);
    ui.painter().rect_filled(rect, 3.0, colors.canvas);
    let font = FontId::proportional(theme::SMALL_TEXT);
    if let Some((texture, size)) = tile {
        let [width, height] = size.map(|side| side as f32);
        let scale = SIDE / 2.0 / most as f32;
        let side = vec2(width, height) * scale;
        let first = rect.center() - side;
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        let mut mesh = Mesh::with_texture(texture);
        for (column, row) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let at = first + vec2(column * side.x, row * side.y);
            mesh.add_rect_with_uv(Rect::from_min_size(at, side), whole, Color32::WHITE);
        }
        ui.painter().add(Shape::mesh(mesh));
    }
    let at = rect.left_top() + vec2(6.0, 4.0);
    let galley = ui.painter().layout_no_wrap(name.to_owned(), font, Color32::WHITE);
    let ground = Align2::LEFT_TOP.anchor_size(at, galley.size()).expand2(vec2(4.0, 1.0));
    ui.painter().rect_filled(ground, 3.0, theme::PLATE);
    ui.painter().galley(at, galley, Color32::WHITE);
}
