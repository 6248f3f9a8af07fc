//! View that the picture is shown by, remembered from one start to the next.

use std::path::PathBuf;

use super::App;
use crate::commands::{DisplayCommand, FilePurpose};
use crate::diag::Diagnostic;
use crate::state::display::{DisplayChoice, PictureDisplay};

impl App {
    /// Carries out a command about the view that the picture is shown by.
    pub(super) fn apply_to_display(&mut self, command: DisplayCommand) {
        match command {
            DisplayCommand::Show(choice) => self.show_by(choice),
            DisplayCommand::Open(path) => self.open_colors(path),
        }
    }

    /// Shows the picture by a view, or by the curve of sRGB, from now on. Where the view cannot be
    /// had the former one stays, and the message says why.
    fn show_by(&mut self, choice: Option<DisplayChoice>) {
        match choice.clone().map(PictureDisplay::open).transpose() {
            Ok(display) => {
                self.session.show_by(display);
                self.safety.change_settings(|settings| settings.display = choice);
            }
            Err(problem) => self.message = Some(told(&problem)),
        }
    }

    /// Shows the picture by the first view of a configuration, or asks for one.
    fn open_colors(&mut self, path: Option<PathBuf>) {
        let Some(path) = path else {
            let choice = self.session.view().display().map(|display| display.choice.clone());
            let near = choice.map(|choice| PathBuf::from(&choice.config));
            let near = near.filter(|path| path.is_file());
            return self.dialogs.ask(FilePurpose::Colors, near.as_deref());
        };
        match DisplayChoice::first_of(&path.to_string_lossy()) {
            Ok(choice) => self.show_by(Some(choice)),
            Err(problem) => self.message = Some(told(&problem)),
        }
    }

    /// Shows the picture by the view of the settings. A configuration that is gone is told, and
    /// the setting stays: it may come back.
    pub(super) fn show_by_settings(&mut self) {
        let choice = self.safety.settings.display.clone();
        match choice.map(PictureDisplay::open).transpose() {
            Ok(display) => self.session.show_by(display),
            Err(problem) => self.message = Some(told(&problem)),
        }
    }
}

/// A problem of a configuration as a message.
fn told(problem: &Diagnostic) -> String {
    let file = problem.place.file.as_deref().unwrap_or_default();
    format!("{file}: {}", problem.message)
}
