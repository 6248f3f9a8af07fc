//! Controls of placing.

use chiaro_locale::tr;
use eframe::egui::{ComboBox, Rect, Role, Ui, WidgetInfo};

use super::{PlacingTool, name};
use crate::commands::{Command, LightMark, PlacingCommand, table};
use crate::state::session::Session;
use crate::tools::notice::over_top;

impl PlacingTool {
    /// Shows the light and the marks.
    pub(super) fn bar(&mut self, ui: &mut Ui, rect: Rect, session: &Session) {
        over_top(ui, rect, "placing bar", |ui| self.controls(ui, session));
    }

    fn controls(&mut self, ui: &mut Ui, session: &Session) {
        ui.spacing_mut().item_spacing.x = 5.0;
        let label = ui.label(tr!("placing a light" => "Place"));
        let light = self.light(session);
        let shown = light.as_ref().map_or_else(String::new, |id| name(session, id));
        let list = ComboBox::from_id_salt("light to place").selected_text(shown).width(90.0);
        let list = list.show_ui(ui, |ui| {
            for id in Self::lights(session) {
                let is_it = light.as_ref() == Some(id);
                if ui.selectable_label(is_it, name(session, id)).clicked() {
                    self.chosen = Some(id.clone());
                    self.told = None;
                }
            }
        });
        let help =
            tr!("The light that is placed: that of the selected layer, unless another is chosen \
                 here");
        list.response.labelled_by(label.id).on_hover_text(help);
        ui.label(tr!("placing a light" => "by its"));
        for mark in LightMark::ALL {
            let is_it = self.mark == mark;
            let command = Command::Placing(PlacingCommand::By(mark));
            let help = table::help_of(&command);
            let response = ui.selectable_label(is_it, mark.label()).on_hover_text(help);
            let name = match mark {
                LightMark::Highlight => tr!("Place by its highlight"),
                LightMark::Shadow => tr!("Place by its shadow"),
                LightMark::Terminator => tr!("Place by its terminator"),
            };
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, name));
            if response.clicked() && !is_it {
                self.take(mark);
            }
        }
    }
}
