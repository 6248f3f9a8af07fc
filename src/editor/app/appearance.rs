//! Theme and scale of the window, as settings remember them.

use eframe::egui::{Context, ThemePreference};

use crate::state::settings::{SCALE, Settings, Theme};

/// Gives the window the theme and the scale of its settings.
pub(super) fn apply(settings: &Settings, ctx: &Context) {
    ctx.set_theme(match settings.theme {
        Theme::Dark => ThemePreference::Dark,
        Theme::Light => ThemePreference::Light,
        Theme::System => ThemePreference::System,
    });
    ctx.set_zoom_factor(settings.scale);
}

/// Present theme and scale of the window.
pub(super) fn current(ctx: &Context) -> (Theme, f32) {
    let theme = match ctx.options(|options| options.theme_preference) {
        ThemePreference::Dark => Theme::Dark,
        ThemePreference::Light => Theme::Light,
        ThemePreference::System => Theme::System,
    };
    (theme, ctx.zoom_factor().clamp(*SCALE.start(), *SCALE.end()))
}
