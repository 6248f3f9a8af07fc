//! Controls of placing, over the top of the picture: a row above it would resize the picture, and
//! the places that were clicked would no longer be where they were.

use eframe::egui::{
    ComboBox, Frame, Margin, Rect, Role, Sense, Ui, UiBuilder, Vec2, WidgetInfo, pos2, vec2,
};

use super::{PlacingTool, name};
use crate::commands::{Command, LightMark, PlacingCommand, table};
use crate::state::session::Session;
use crate::widgets::theme;

/// Height of the notices over the top of the picture, below which the bar stands, in points.
const NOTICE: f32 = 36.0;

impl PlacingTool {
    /// Shows the light and the marks.
    pub(super) fn bar(&mut self, ui: &mut Ui, rect: Rect, session: &Session) {
        let id = ui.scope_id().with("placing bar");
        let scene = session.open_scene().map(|open_scene| open_scene.scene());
        let is_soloed = scene.is_some_and(|scene| !scene.soloed.is_none());
        let has_notice = is_soloed || session.view.wire.is_some() || !session.view.solo.is_empty();
        let top = rect.top() + 8.0 + if has_notice { NOTICE } else { 0.0 };
        let room = Rect::from_min_max(pos2(rect.left() + 8.0, top), rect.max - vec2(8.0, 8.0));
        // The size is that of the frame before. Presses beside the widgets must not reach the
        // picture below.
        let known: Option<Vec2> = ui.data(|data| data.get_temp(id));
        let size = known.unwrap_or(vec2(room.width(), 30.0));
        ui.interact(Rect::from_min_size(room.min, size), id, Sense::click_and_drag());
        let frame = Frame::new()
            .fill(theme::of(ui).panel.gamma_multiply(0.92))
            .corner_radius(4.0)
            .inner_margin(Margin::symmetric(8, 4));
        let builder = UiBuilder::new().id_salt("placing").max_rect(room);
        let shown = ui.scope_builder(builder, |ui| {
            frame
                .show(ui, |ui| ui.horizontal_wrapped(|ui| self.controls(ui, session)))
                .response
                .rect
                .size()
        });
        ui.data_mut(|data| data.insert_temp(id, shown.inner));
    }

    fn controls(&mut self, ui: &mut Ui, session: &Session) {
        ui.spacing_mut().item_spacing.x = 5.0;
        let label = ui.label("Place");
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
        let help = "The light that is placed: that of the selected layer, unless another is chosen \
                    here";
        list.response.labelled_by(label.id).on_hover_text(help);
        ui.label("by its");
        for mark in LightMark::ALL {
            let is_it = self.mark == mark;
            let command = Command::Placing(PlacingCommand::By(mark));
            let help = table::help_of(&command);
            let response = ui.selectable_label(is_it, mark.label()).on_hover_text(help);
            let name = format!("Place by its {}", mark.label().to_lowercase());
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, &name));
            if response.clicked() && !is_it {
                self.take(mark);
            }
        }
    }
}
