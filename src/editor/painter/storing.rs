//! Dialog for the storage of a texture exported as KTX2: explains each storage and the memory it
//! takes.

use chiaro_locale::tr;
use eframe::egui::{Grid as Table, Id, Modal, RichText, Ui};

use super::memory::Memory;
use crate::commands::{Command, PaintCommand};
use crate::document::Storage;
use crate::figures::bytes;
use crate::hcbtf::exchange::ExchangeFormat;
use crate::hcbtf::{Need, needs_at_most};
use crate::state::painting::work::OpenPainting;
use crate::widgets::confirm;
use crate::widgets::theme;

/// Shows the dialog while `asked` is set.
pub(super) fn show(
    ui: &Ui,
    asked: &mut Option<Storage>,
    work: Option<&OpenPainting>,
    memory: &mut Memory,
) -> Option<Command> {
    let storage = asked.as_mut()?;
    let mut out = None;
    let mut is_over = work.is_none();
    let modal = Modal::new(Id::unique("storing")).show(ui.ctx(), |ui| {
        ui.set_width(520.0);
        let enters = confirm::enters(ui);
        ui.label(RichText::new(tr!("Export as a KTX2 texture")).heading());
        let text = tr!(
            "The texture that shaders look up. All storages hold every sample, with smaller levels \
             of the tile for a distance, which the sizes count: they are those of \"with levels\" \
             in the table of memory under Fill rules. They differ in what they take, in how fast \
             they are looked up, and in that Blocks keep colors nearly, not exactly."
        );
        ui.label(RichText::new(text).color(theme::of(ui).dim));
        ui.add_space(6.0);
        if let Some(work) = work {
            choices(ui, work, memory, storage);
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            if ui
                .button(tr!("Export to..."))
                .on_hover_text(tr!("Asks which .ktx2 file to write (Enter)"))
                .clicked()
                || enters
            {
                out = Some(Command::Paint(PaintCommand::Export {
                    form: ExchangeFormat::Ktx2,
                    storage: *storage,
                    to: None,
                }));
                is_over = true;
            }
            is_over |= ui.button(tr!("Cancel")).clicked();
        });
    });
    if is_over || modal.should_close() {
        *asked = None;
    }
    out
}

/// Shows the storages: the memory that each takes, once measured, and its explanation.
fn choices(ui: &mut Ui, work: &OpenPainting, memory: &mut Memory, chosen: &mut Storage) {
    let known = memory.measured(work).map(|(_, _, needs)| needs.clone());
    let most = needs_at_most(work.grid());
    let of = |needs: &[Need], storage| {
        let is_it = |need: &&Need| need.storage == storage && need.has_levels;
        needs.iter().find(is_it).map_or(0, Need::bytes)
    };
    Table::new("storages").num_columns(3).spacing([12.0, 6.0]).show(ui, |ui| {
        for storage in Storage::ALL {
            ui.radio_value(chosen, storage, storage.label());
            let size = match &known {
                Some(needs) => bytes(of(needs, storage)),
                None => tr!("at most {size}", size = bytes(of(&most, storage))),
            };
            ui.label(size);
            ui.label(RichText::new(storage.about()).color(theme::of(ui).dim));
            ui.end_row();
        }
    });
}
