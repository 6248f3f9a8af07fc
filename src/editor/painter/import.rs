//! Import of painted pictures from other programs as an HCBTF: a dialog asks for the form of the
//! pictures, then for the files.

use std::path::Path;

use chiaro_locale::tr;
use eframe::egui::{self, Button, ComboBox, Id, Modal, RichText, Ui, WidgetInfo};

use super::grid::directions;
use crate::commands::{Command, PaintCommand, PictureImport};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Grid, Hcbtf};
use crate::files::Disk;
use crate::hcbtf::contact::MAX_GAP;
use crate::hcbtf::exchange::{self, ExchangeFormat};
use crate::progress::Progress;
use crate::widgets::confirm;
use crate::widgets::number::number_field;
use crate::widgets::theme;

impl PictureImport {
    /// Reads the pictures at `from` as an HCBTF, with warnings about odd ones.
    ///
    /// # Errors
    /// All problems that prevent the import, and a stop by the user.
    pub(super) fn read(
        self,
        from: &Path,
        progress: &Progress,
    ) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
        let Self { form, light, view, gap, is_tiling } = self;
        let grid =
            exchange::fitted(&Disk, from, form, Grid { size: Grid::THESIS.size, light, view }, gap);
        let (hcbtf, notes) = exchange::import(&Disk, from, form, grid, gap, progress)?.into_parts();
        // Pictures that Chiaro wrote say themselves whether they repeat.
        let is_tiling =
            if exchange::tells_all(&Disk, from, form) { hcbtf.is_tiling } else { is_tiling };
        Ok(WithWarnings::new(Hcbtf { is_tiling, ..hcbtf }, notes))
    }
}

/// Name of a form, and its description.
fn told(form: ExchangeFormat) -> (&'static str, &'static str) {
    match form {
        ExchangeFormat::Folder => (
            tr!("A folder of images"),
            tr!(
                "One PNG a sample: l2.3_v1.4.png is seen with the light at ring 2, step 3 and the \
                 eye at ring 1, step 4. Numbered ones follow each other view by view, and for each \
                 view light by light. One that Chiaro exported tells its own lights and views."
            ),
        ),
        ExchangeFormat::Contact => (
            tr!("A contact sheet"),
            tr!(
                "One PNG with all tiles side by side: views across, lights down, the one straight \
                 above first."
            ),
        ),
        ExchangeFormat::Sheet => (
            tr!("A sheet of the thesis"),
            tr!("One PNG in which every texel is a block of all its lights and views."),
        ),
        ExchangeFormat::Ktx2 => (
            tr!("A KTX2 texture"),
            tr!("The texture that shaders look up, as it was exported; it tells its own grid."),
        ),
    }
}

/// Shows the dialog while `asked` is set. The pictures themselves are asked for next.
pub(super) fn show(ui: &Ui, asked: &mut Option<PictureImport>) -> Option<Command> {
    let mut import = (*asked)?;
    let mut out = None;
    let mut is_over = false;
    let modal = Modal::new(Id::unique("import pictures")).show(ui.ctx(), |ui| {
        ui.set_width(400.0);
        let enters = confirm::enters(ui);
        ui.label(RichText::new(tr!("Import painted pictures")).heading());
        ui.add_space(6.0);
        let chosen = ComboBox::from_id_salt("form").width(220.0).selected_text(told(import.form).0);
        let chosen = chosen.show_ui(ui, |ui| {
            for form in ExchangeFormat::ALL {
                ui.selectable_value(&mut import.form, form, told(form).0);
            }
        });
        chosen.response.widget_info(|| {
            WidgetInfo::labeled(egui::Role::ComboBox, true, tr!("Kind of pictures"))
        });
        ui.label(RichText::new(told(import.form).1).color(theme::of(ui).dim));
        ui.add_space(6.0);
        if import.form != ExchangeFormat::Ktx2 {
            directions(ui, tr!("Lights"), &mut import.light);
            directions(ui, tr!("Views"), &mut import.view);
        }
        if import.form == ExchangeFormat::Contact {
            ui.horizontal(|ui| {
                let label = ui.label(tr!("Texels between the tiles")).id;
                ui.add(number_field(ui, &mut import.gap).range(0..=MAX_GAP).speed(0.1))
                    .labelled_by(label);
            });
        }
        ui.checkbox(&mut import.is_tiling, tr!("The tile repeats"));
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            if ui.add(Button::new(tr!("Choose them..."))).clicked() || enters {
                out = Some(Command::Paint(PaintCommand::Import { import, from: None }));
                is_over = true;
            }
            is_over |= ui.button(tr!("Cancel")).clicked();
        });
    });
    is_over |= modal.should_close();
    *asked = (!is_over).then_some(import);
    out
}
