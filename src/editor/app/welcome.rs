//! Start page and tour, which greet a newcomer; and the field that asks for paths where no dialog
//! does.

use std::path::Path;

use eframe::egui::{self, Ui};

use super::App;
use crate::app::dialogs::{Answer, DialogKind};
use crate::app::path_field::PathField;
use crate::app::tour::{self, Tour};
use crate::commands::{
    Command, DisplayCommand, FilePurpose, FilmCommand, LibraryCommand, PaintCommand, SceneCommand,
    TourTopic, ViewCommand, is_image,
};
use crate::diag::Diagnostic;
use crate::panels::PanelContext;
use crate::panels::start::{self, Start};
use crate::state::comparison::ComparedPicture;
use crate::state::document::CHANGED_ON_DISK;
use crate::state::revision::{DocumentNumber, LookRevision};
use crate::state::session::Session;
use crate::state::session::saving::OwnFiles;
use crate::widgets::theme;

/// State of the session when the start page came: the page leaves with the first change.
#[derive(Debug, PartialEq)]
pub(super) struct StartPage {
    document: DocumentNumber,
    revision: LookRevision,
    mesh: String,
}

impl StartPage {
    fn over(session: &Session) -> Self {
        let (document, revision) = (session.revisions().document, session.revision());
        Self { document, revision, mesh: session.view.orbit.mesh.clone() }
    }
}

impl App {
    /// Begins in a window that is opened without a file: with the work of the last window, or else
    /// the start page.
    pub fn begin(&mut self) {
        self.resume();
        if self.message.is_none() {
            self.show_start_page();
        }
    }

    /// Begins in a window that is opened with a file: with the file, or else the start page, where
    /// the problem is shown. Returns the problem, too, for users who started the program from a
    /// terminal.
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

    /// True while the start page is shown.
    pub fn shows_start_page(&self) -> bool {
        self.start.is_some()
    }

    /// True while the tour goes on.
    pub fn is_on_tour(&self) -> bool {
        self.tour.is_some()
    }

    /// Leaves the start page once anything was opened or made.
    pub(super) fn leave_start_page(&mut self) {
        if self.start.as_ref().is_some_and(|page| *page != StartPage::over(&self.session)) {
            self.start = None;
        }
        if self.start.is_none() {
            self.bench.memory.of::<Start>().rest();
        }
    }

    pub(super) fn start_page(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let frame = egui::Frame::new().fill(theme::of(ui).panel);
        egui::CentralPanel::default().frame(frame).show(ui, |ui| {
            let context = PanelContext { session: &self.session, safety: &self.safety };
            commands.extend(start::show(&mut self.bench, ui, context));
        });
    }

    pub(super) fn begin_tour(&mut self, topic: TourTopic) {
        tour::begin(topic, &mut self.session);
        self.safety.look();
        self.lay_out();
        self.tour = Some(Tour::new(topic, &self.session));
    }

    /// Shows the tour beside its target, while it goes on.
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
        if self.dialogs.way == DialogKind::Silent {
            return;
        }
        let folder = self.session.look.folder();
        let folder = if folder.as_os_str().is_empty() {
            std::env::current_dir().unwrap_or_default()
        } else {
            folder
        };
        self.path_field = Some(PathField::new(FilePurpose::Open, &folder.join(""), false));
    }

    /// Asks again for a path in the window, which tells why nothing could be written there: a
    /// dialog of the system is gone by then. For a file that another program changed, the window
    /// has offers of its own.
    pub(super) fn ask_again(&mut self, purpose: FilePurpose, path: &Path, problem: &Diagnostic) {
        if self.dialogs.way != DialogKind::Silent && problem.code != CHANGED_ON_DISK {
            let stands_in = self.dialogs.way == DialogKind::Window;
            let field = PathField::new(purpose, path, stands_in);
            self.path_field = Some(field.refused(path, problem));
        }
    }

    /// Commands for files that were chosen, in a dialog of the system or by their path.
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
            FilePurpose::Open => Command::Open(Some(path)),
            FilePurpose::Save => Command::SaveTo(path, OwnFiles::Linked),
            FilePurpose::SaveWithFiles => Command::SaveTo(path, OwnFiles::Copied),
            FilePurpose::Mesh => Command::ShowOn(Some(path)),
            FilePurpose::AddMesh
            | FilePurpose::ObjectMesh
            | FilePurpose::ObjectLook
            | FilePurpose::SaveScene
            | FilePurpose::SaveSceneWithFiles
            | FilePurpose::SaveShot => Command::Scene(SceneCommand::Chosen(purpose, path)),
            FilePurpose::SavePainting => Command::Paint(PaintCommand::SaveTo(path)),
            FilePurpose::ImportPainting(import) => {
                Command::Paint(PaintCommand::Import { import, from: Some(path) })
            }
            FilePurpose::BakeLook => Command::Paint(PaintCommand::Bake { to: Some(path) }),
            FilePurpose::ExportPainting(form, storage) => {
                Command::Paint(PaintCommand::Export { form, storage, to: Some(path) })
            }
            FilePurpose::Shaders(language) => Command::ExportLook(language, Some(path)),
            FilePurpose::Export(export) => Command::Export(export, Some(path)),
            FilePurpose::Image => Command::TakeImage(path),
            FilePurpose::Reference => Command::ShowReference(Some(path)),
            FilePurpose::Colors => Command::Display(DisplayCommand::Open(Some(path))),
            FilePurpose::Comparison => {
                Command::View(ViewCommand::Compare(Some(match is_image(&path) {
                    true => ComparedPicture::Image(path),
                    false => ComparedPicture::LookFile(path),
                })))
            }
            FilePurpose::Frames => Command::CompareFrames(Some(path)),
            FilePurpose::FrameFolder => Command::Film(FilmCommand::ChooseFolder(Some(path))),
            FilePurpose::LibraryFolder => Command::Library(LibraryCommand::AddFolder(Some(path))),
        };
        chosen.into_iter().map(command).collect()
    }
}
