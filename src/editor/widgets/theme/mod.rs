//! Colors, sizes and fonts of the window, all in one place.
//!
//! A calm ground with one warm accent lets the picture and the wires stand out. A socket shows its
//! type by color and by shape.

mod colors;

use eframe::egui;
use eframe::egui::{CornerRadius, FontFamily, FontId, Margin, Stroke, TextStyle, Visuals};

pub(crate) use crate::drawing::{NODE_WIDTH, SOCKET, SocketShape, TEXT_SIZE, TITLE_HEIGHT};
pub(crate) use colors::{AXES, Colors, HALO, PLATE, SUN, curve};

/// Colors of the present theme.
pub(crate) fn of(ui: &egui::Ui) -> &'static Colors {
    if ui.visuals().dark_mode { &colors::DARK } else { &colors::LIGHT }
}

/// Size of small text, in points: heads of tables, marks of plots.
pub(crate) const SMALL_TEXT: f32 = 11.0;
/// Sets colors, fonts and spacings for the whole window, in both themes.
pub(crate) fn apply(ctx: &egui::Context) {
    for (theme, colors) in
        [(egui::Theme::Dark, &colors::DARK), (egui::Theme::Light, &colors::LIGHT)]
    {
        ctx.set_visuals_of(theme, visuals(theme.default_visuals(), colors));
        ctx.style_mut_of(theme, |style| {
            style.spacing.item_spacing = egui::vec2(6.0, 5.0);
            style.spacing.button_padding = egui::vec2(8.0, 3.0);
            style.spacing.interact_size.y = 22.0;
            style.spacing.window_margin = Margin::same(8);
            style.interaction.tooltip_delay = 0.4;
            style.text_styles = [
                (TextStyle::Small, FontId::proportional(SMALL_TEXT)),
                (TextStyle::Body, FontId::proportional(TEXT_SIZE)),
                (TextStyle::Button, FontId::proportional(TEXT_SIZE)),
                (TextStyle::Heading, FontId::proportional(16.0)),
                (TextStyle::Monospace, FontId::new(12.0, FontFamily::Monospace)),
            ]
            .into();
        });
    }
}

fn visuals(mut visuals: Visuals, colors: &Colors) -> Visuals {
    visuals.override_text_color = None;
    visuals.panel_fill = colors.panel;
    visuals.window_fill = colors.window;
    visuals.window_stroke = Stroke::new(1.0, colors.window_edge);
    visuals.extreme_bg_color = colors.well;
    visuals.faint_bg_color = colors.window;
    visuals.selection.bg_fill = colors.accent_dim;
    visuals.selection.stroke = Stroke::new(1.0, colors.accent);
    visuals.hyperlink_color = colors.accent;
    visuals.error_fg_color = colors.error;
    visuals.warn_fg_color = colors.warning;
    visuals.slider_trailing_fill = true;
    let widgets = &mut visuals.widgets;
    widgets.noninteractive.fg_stroke.color = colors.text;
    widgets.noninteractive.bg_stroke.color = colors.grid;
    widgets.inactive.fg_stroke.color = colors.text;
    widgets.inactive.bg_fill = colors.field;
    widgets.inactive.weak_bg_fill = colors.field;
    widgets.hovered.fg_stroke.color = colors.text;
    widgets.hovered.bg_fill = colors.field_hovered;
    widgets.hovered.weak_bg_fill = colors.field_hovered;
    widgets.hovered.bg_stroke = Stroke::new(1.0, colors.swatch_edge);
    widgets.active.fg_stroke.color = colors.text;
    widgets.active.bg_fill = colors.accent_dim;
    widgets.active.weak_bg_fill = colors.accent_dim;
    widgets.active.bg_stroke = Stroke::new(1.0, colors.accent);
    widgets.open.fg_stroke.color = colors.text;
    widgets.open.weak_bg_fill = colors.field_hovered;
    let radius = CornerRadius::same(4);
    for state in [
        &mut widgets.noninteractive,
        &mut widgets.inactive,
        &mut widgets.hovered,
        &mut widgets.active,
        &mut widgets.open,
    ] {
        state.corner_radius = radius;
        state.expansion = 0.0;
    }
    visuals
}

/// Frame of a panel.
pub(crate) fn panel(ui: &egui::Ui) -> egui::Frame {
    egui::Frame::new().fill(of(ui).panel).inner_margin(Margin::symmetric(10, 8))
}
