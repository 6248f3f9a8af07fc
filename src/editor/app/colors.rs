//! View that the picture is shown by, remembered from one start to the next.
//!
//! A configuration may be large or lie on a slow disk, and a view of it takes a while to be
//! computed: both are done beside the window, which shows the former view meanwhile.

use std::path::PathBuf;

use super::App;
use crate::commands::{DisplayCommand, FilePurpose};
use crate::diag::Diagnostic;
use crate::state::display::{DisplayChoice, PictureDisplay};
use crate::state::worker::Worker;

/// View to open.
enum WantedView {
    Chosen(DisplayChoice),
    /// The default view of a configuration.
    FirstOf(String),
}

/// View that was asked for, or the reason why there is none.
struct OpenedView {
    /// Number of the request.
    number: u64,
    /// True for a choice that the settings are to remember.
    is_new: bool,
    opened: Result<PictureDisplay, Diagnostic>,
}

/// Opens views beside the window. The newest request counts.
pub(super) struct ColorOpener {
    worker: Worker<(u64, bool, WantedView), OpenedView>,
    /// Number of the last request.
    number: u64,
}

impl ColorOpener {
    /// `wake` is called from another thread when a view is open.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let open = |(number, is_new, wanted): (u64, bool, WantedView)| {
            let choice = match wanted {
                WantedView::Chosen(choice) => Ok(choice),
                WantedView::FirstOf(config) => DisplayChoice::first_of(&config),
            };
            OpenedView { number, is_new, opened: choice.and_then(PictureDisplay::open) }
        };
        Self { worker: Worker::new("views", wake, open), number: 0 }
    }

    /// True while a view is on its way.
    pub(super) fn is_busy(&self) -> bool {
        self.worker.owes()
    }

    /// Waits until the view is open that was asked for.
    pub(super) fn wait(&self) {
        self.worker.wait();
    }

    fn request(&mut self, is_new: bool, wanted: WantedView) {
        self.forget();
        let number = self.number;
        self.worker.request(|_| (number, is_new, wanted));
    }

    /// Lets what was asked for before count no more.
    fn forget(&mut self) {
        self.number += 1;
    }
}

impl App {
    /// Carries out a command about the view that the picture is shown by.
    pub(super) fn apply_to_display(&mut self, command: DisplayCommand) {
        match command {
            DisplayCommand::Show(Some(choice)) => {
                self.colors.request(true, WantedView::Chosen(choice));
            }
            DisplayCommand::Show(None) => {
                self.colors.forget();
                self.session.show_by(None);
                self.safety.change_settings(|settings| settings.display = None);
            }
            DisplayCommand::Open(path) => self.open_colors(path),
        }
    }

    /// Shows the picture by the view that was asked for, from now on. Where it cannot be had the
    /// former one stays, and the message says why.
    pub(super) fn take_colors(&mut self) {
        for OpenedView { number, is_new, opened } in self.colors.worker.answers() {
            if number != self.colors.number {
                continue;
            }
            match opened {
                Ok(display) => {
                    let choice = DisplayChoice::clone(&display.choice);
                    self.session.show_by(Some(display));
                    if is_new {
                        self.safety.change_settings(|settings| settings.display = Some(choice));
                    }
                }
                Err(problem) => self.message = Some(told(&problem)),
            }
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
        self.colors.request(true, WantedView::FirstOf(path.to_string_lossy().into_owned()));
    }

    /// Shows the picture by the view of the settings. A configuration that is gone is told, and
    /// the setting stays: it may come back.
    pub(super) fn show_by_settings(&mut self) {
        match self.safety.settings.display.clone() {
            Some(choice) => self.colors.request(false, WantedView::Chosen(choice)),
            None => self.session.show_by(None),
        }
    }
}

/// A problem of a configuration as a message.
fn told(problem: &Diagnostic) -> String {
    let file = problem.place.file.as_deref().unwrap_or_default();
    format!("{file}: {}", problem.message)
}
