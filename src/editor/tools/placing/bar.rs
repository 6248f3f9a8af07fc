//! Controls of placing, above the picture.

use eframe::egui::{ComboBox, Role, Ui, WidgetInfo};

use super::{PlacingTool, name};
use crate::commands::{Command, LightMark, PlacingCommand, table};
use crate::state::session::Session;

impl PlacingTool {
    /// Shows a row with the light and the marks, while placing is on.
    pub(super) fn bar(&mut self, ui: &mut Ui, session: &Session) {
        if !self.is_on {
            return;
        }
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let label = ui.label("Place");
            let light = self.light(session);
            let shown = light.as_ref().map_or_else(String::new, |id| name(session, id));
            let list = ComboBox::from_id_salt("light to place").selected_text(shown);
            let list = list.show_ui(ui, |ui| {
                for id in Self::lights(session) {
                    let is_it = light.as_ref() == Some(id);
                    if ui.selectable_label(is_it, name(session, id)).clicked() {
                        self.chosen = Some(id.clone());
                        self.told = None;
                    }
                }
            });
            let help = "The light that is placed: that of the selected layer, unless another is \
                        chosen here";
            list.response.labelled_by(label.id).on_hover_text(help);
            ui.label("by its");
            for mark in LightMark::ALL {
                let is_it = self.mark == mark;
                let command = Command::Placing(PlacingCommand::By(mark));
                let keys = table::row_of(&command).map(table::CommandRow::text);
                let help = match keys.filter(|keys| !keys.is_empty()) {
                    Some(keys) => format!("{} ({keys})", mark.help()),
                    None => mark.help().to_owned(),
                };
                let response = ui.selectable_label(is_it, mark.label()).on_hover_text(help);
                let name = format!("Place by its {}", mark.label().to_lowercase());
                response
                    .widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, &name));
                if response.clicked() && !is_it {
                    self.take(mark);
                }
            }
        });
    }
}
