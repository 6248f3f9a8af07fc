//! What greets a newcomer: the start page and the tour; and the field that asks for paths where no
//! dialog does.

use std::path::Path;

use eframe::egui::{self, Ui};

use super::App;
use crate::app::dialogs::{Answer, Purpose, Way};
use crate::app::path_field::PathField;
use crate::app::tour::{NOTHING, Tour};
use crate::commands::Command;
use crate::commands::scene::Wish;
use crate::painter as painting;
use crate::state::session::Session;
use crate::widgets::theme;

/// What was open when the start page came: it leaves with that.
#[derive(Debug, PartialEq)]
pub(super) struct StartPage {
    document: u64,
    revision: u64,
    mesh: String,
}

impl StartPage {
    fn over(session: &Session) -> Self {
        let (document, revision) = (session.document_number(), session.revision());
        Self { document, revision, mesh: session.view.mesh.clone() }
    }
}

impl App {
    /// What a window that is opened without a file begins with: where the last one was left, or
    /// else the start page.
    pub fn begin(&mut self) {
        self.resume();
        if self.message.is_none() {
            self.show_start_page();
        }
    }

    /// What a window that is opened with a file begins with: the file, or else the start page,
    /// where what is wrong is told. Returns that, too, for who asked at a terminal.
    pub fn begin_with(&mut self, file: &Path) -> Option<String> {
        self.open(file);
        let wrong = self.safety.unopened();
        if wrong.is_some() {
            self.show_start_page();
        }
        wrong
    }

    /// Shows the start page in place of the panels, until anything is opened or made.
    pub fn show_start_page(&mut self) {
        self.start = Some(StartPage::over(&self.session));
    }

    /// Whether the start page is shown.
    pub fn shows_start_page(&self) -> bool {
        self.start.is_some()
    }

    /// Whether the tour goes on.
    pub fn is_on_tour(&self) -> bool {
        self.tour.is_some()
    }

    /// The start page goes once anything was opened or made.
    pub(super) fn leave_start_page(&mut self) {
        if self.start.as_ref().is_some_and(|page| *page != StartPage::over(&self.session)) {
            self.start = None;
        }
        if self.start.is_none() {
            self.panels.end_start();
        }
    }

    pub(super) fn start_page(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let frame = egui::Frame::new().fill(theme::of(ui).panel);
        egui::CentralPanel::default().frame(frame).show(ui, |ui| {
            commands.extend(self.panels.show_start(ui, &self.session, self.safety.recent()));
        });
    }

    pub(super) fn begin_tour(&mut self) {
        self.session.start_from(NOTHING, "first look");
        self.safety.look();
        self.tour = Some(Tour::new(&self.session));
    }

    /// Shows the tour beside what it speaks of, while it goes on.
    pub(super) fn show_tour(&mut self, ui: &Ui, commands: &mut Vec<Command>) {
        self.tour = self.tour.take().filter(|tour| tour.is_about(&self.session));
        let Some(tour) = self.tour.as_mut().filter(|_| self.start.is_none()) else { return };
        let (asked, goes_on) = tour.show(ui, &self.session);
        commands.extend(asked);
        if !goes_on {
            self.tour = None;
        }
    }

    pub(super) fn open_path_field(&mut self) {
        if self.dialogs.way == Way::Silent {
            return;
        }
        let folder = self.session.folder();
        let folder = if folder.as_os_str().is_empty() {
            std::env::current_dir().unwrap_or_default()
        } else {
            folder
        };
        self.path_field = Some(PathField::new(Purpose::Open, &folder.join(""), false));
    }

    /// Files that were chosen, in a dialog of the system or by their path.
    pub(super) fn chosen_files(&mut self, ui: &Ui) -> Vec<Command> {
        let mut chosen = Vec::new();
        for answer in self.dialogs.answers() {
            match answer {
                Answer::File(purpose, path) => chosen.push((purpose, path)),
                Answer::NoDialog(purpose, path) => {
                    self.path_field = Some(PathField::new(purpose, &path, true));
                }
            }
        }
        if let Some(field) = &mut self.path_field
            && let Some(answer) = field.show(ui.ctx())
        {
            chosen.extend(answer.map(|path| (field.purpose, path)));
            self.path_field = None;
        }
        let command = |(purpose, path)| match purpose {
            Purpose::Open => Command::Open(Some(path)),
            Purpose::Save => Command::SaveTo(path),
            Purpose::Mesh => Command::ShowOn(Some(path)),
            Purpose::AddMesh | Purpose::ObjectMesh | Purpose::ObjectLook | Purpose::SaveScene => {
                Command::Stage(Wish::Chosen(purpose, path))
            }
            Purpose::SavePainting => Command::Paint(painting::Wish::SaveTo(path)),
            Purpose::ImportPainting(import) => {
                Command::Paint(painting::Wish::Import { import, from: Some(path) })
            }
            Purpose::BakeLook => Command::Paint(painting::Wish::Bake { to: Some(path) }),
            Purpose::ExportPainting(form, storage) => {
                Command::Paint(painting::Wish::Export { form, storage, to: Some(path) })
            }
            Purpose::Shaders(language) => Command::ExportLook(language, Some(path)),
            Purpose::Export(export) => Command::Export(export, Some(path)),
            Purpose::Reference => Command::ShowReference(Some(path)),
        };
        chosen.into_iter().map(command).collect()
    }
}
