//! Theme, scale and language of the window, as settings remember them.

use chiaro_locale::tr;
use eframe::egui::{Context, ThemePreference, Ui};

use super::App;
use crate::state::languages::LANGUAGES;
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

impl App {
    /// Speaks the language of a tag from now on, or the system's, and remembers it.
    pub(super) fn speak(&mut self, tag: Option<&str>) {
        self.safety.change_settings(|settings| settings.language = tag.map(str::to_owned));
        self.safety.settings.speak();
        self.session.tell_again();
        // What was told before is of the language before.
        self.message = None;
    }

    /// Shows the menu of languages, by their own names.
    pub(super) fn language_menu(&mut self, ui: &mut Ui) {
        let present = self.safety.settings.language.clone();
        let languages = LANGUAGES.iter().map(|language| (Some(language.tag), language.name));
        for (tag, name) in languages.chain([(None, tr!("As the system"))]) {
            if ui.radio(present.as_deref() == tag, name).clicked() {
                self.speak(tag);
                ui.close();
            }
        }
    }
}
