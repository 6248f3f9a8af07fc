//! Controls of the brushes, above the picture.

use chiaro_locale::tr;
use eframe::egui::{self, Rect, Response, Role, Sense, Ui, WidgetInfo, vec2};

use super::FitTool;
use super::tools::SIZES;
use crate::commands::{Command, FitCommand, LightBrush, Switch};
use crate::document::ColorSpace;
use crate::widgets::color;
use crate::widgets::icon::icon_toggle;
use crate::widgets::number::number_field;

/// Largest width of a field with its name, in points.
const PERCENT: f32 = 110.0;

impl FitTool {
    /// Shows the button that turns painting on and off.
    pub(crate) fn toggle(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let help =
            tr!("Paint on the picture where it should be lighter or darker, and fit the look to \
                 that (L)");
        if sun(ui, self.is_on).on_hover_text(help).clicked() {
            out.push(Command::Fit(FitCommand::Turn(Switch::Toggle)));
        }
    }

    /// Shows a second row of controls while painting is on.
    pub(crate) fn bar(&mut self, ui: &mut Ui) {
        if !self.is_on {
            return;
        }
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            for kind in LightBrush::ALL {
                let is_it = self.tools.kind == kind;
                let response = ui.selectable_label(is_it, kind.label()).on_hover_text(kind.help());
                let name = tr!("Brush: {brush}", brush = kind.label());
                response
                    .widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, &name));
                if response.clicked() {
                    self.tools.kind = kind;
                }
            }
            let [r, g, b] = self.tools.color;
            let swatch = color::named_swatch(
                ui,
                tr!("Color to paint"),
                [r, g, b, 1.0],
                ColorSpace::Display,
                false,
            );
            if let Some((_, [r, g, b, _])) = swatch {
                self.tools.color = [r, g, b];
                self.tools.kind = LightBrush::Color;
            }
            ui.separator();
            let help =
                tr!("The brush's diameter, in percent of the picture's height ([ and ] change it)");
            percent(ui, true, tr!("Size"), help, &mut self.tools.size, SIZES);
            percent(
                ui,
                true,
                tr!("Hardness"),
                tr!("How sharp the brush's edge is"),
                &mut self.tools.hardness,
                0.0..=1.0,
            );
            // All tools show all controls: a bar that changed its height would resize the picture,
            // which would then be read anew.
            let has_amount = matches!(self.tools.kind, LightBrush::Light | LightBrush::Dark);
            let help =
                tr!("How much lighter or darker Light and Dark make it, as an eye sees it: from \
                     black to white is 100%. A stroke that crosses itself makes no more of it; \
                     another stroke goes on from there");
            percent(ui, has_amount, tr!("Amount"), help, &mut self.tools.amount, 0.01..=1.0);
        });
    }
}

/// Shows a button with a half-painted sun.
fn sun(ui: &mut Ui, is_on: bool) -> Response {
    icon_toggle(ui, is_on, tr!("Paint light"), |painter, at, stroke| {
        painter.circle_stroke(at, 3.6, stroke);
        let right = Rect::everything_right_of(at.x);
        painter.with_clip_rect(right).circle_filled(at, 3.6, stroke.color);
        for ray in 0..8_u8 {
            let way = egui::Vec2::angled(f32::from(ray) * std::f32::consts::FRAC_PI_4);
            painter.line_segment([at + way * 5.6, at + way * 8.0], stroke);
        }
    })
}

/// Shows a field for a fraction, in percent.
fn percent(
    ui: &mut Ui,
    is_enabled: bool,
    label: &str,
    help: &str,
    value: &mut f64,
    range: std::ops::RangeInclusive<f64>,
) {
    let mut shown = *value * 100.0;
    let range = range.start() * 100.0..=range.end() * 100.0;
    let drag = number_field(ui, &mut shown).range(range).speed(0.5).max_decimals(0).suffix("%");
    // Fields wrap in a narrow picture, each together with its name.
    if ui.available_size_before_wrap().x < PERCENT {
        ui.end_row();
        // A row is as high as its first widget, and a label is lower than the field beside it.
        ui.allocate_exact_size(vec2(0.0, ui.spacing().interact_size.y), Sense::hover());
    }
    let id = ui.add_enabled(is_enabled, egui::Label::new(label)).on_hover_text(help).id;
    let field = ui.add_enabled(is_enabled, drag).labelled_by(id);
    if field.on_hover_text(help).on_disabled_hover_text(help).changed() {
        *value = shown / 100.0;
    }
}
