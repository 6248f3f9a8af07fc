//! Cells of a wedge's sheet: a click takes the values of one.

use eframe::egui::{Button, RichText, ScrollArea, Ui};

use crate::commands::{Command, PanelId};
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::session::Session;
use crate::state::wedge::WedgeSheet;
use crate::widgets::text::hint;
use crate::widgets::theme;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::WEDGE,
    "Wedge",
    "The cells of a sheet of `chiaro wedge`; a click takes the values of one",
    PanelPlace::WITH_DOCUMENT.closed(),
    |bench, ui, context| bench.memory.of::<Wedge>().show(ui, context.session),
);

/// The panel, with the sheet that was opened last.
#[derive(Default)]
pub(crate) struct Wedge {
    sheet: Option<WedgeSheet>,
    /// Cell that was taken last.
    taken: Option<usize>,
}

impl Wedge {
    /// Lists another sheet.
    pub(crate) fn open(&mut self, sheet: WedgeSheet) {
        *self = Self { sheet: Some(sheet), taken: None };
    }

    fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        let Some(sheet) = &self.sheet else {
            hint(ui, "Open a sheet of `chiaro wedge`, or the JSON beside it, to take its values.");
            return out;
        };
        let name = sheet.path.file_stem().unwrap_or_default().to_string_lossy();
        let to = if session.shot().is_some() { "the shot" } else { "what is open" };
        let text = format!("{name} of {}: a click takes it into {to}", sheet.document.display());
        ui.label(RichText::new(text).small().color(theme::of(ui).dim));
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("wedge").show(ui, |ui| {
            for (number, cell) in sheet.cells.iter().enumerate() {
                let text = format!("{}  {}", number + 1, cell.label());
                let button = Button::selectable(self.taken == Some(number), text);
                let help = "Sets these values, as one step that can be undone";
                if ui.add(button.wrap()).on_hover_text(help).clicked() {
                    self.taken = Some(number);
                    out.push(Command::TakeCell(cell.clone()));
                }
            }
        });
        out
    }
}
