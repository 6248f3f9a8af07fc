//! Opening, saving and closing of files, without loss of work.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{self, RichText, Ui};
use glam::DQuat;

use super::App;
use crate::commands::{Command, PAINTING, PanelId, PictureImport, SceneCommand, TourTopic};
use crate::diag::Diagnostic;
use crate::document::{Grid, Hcbtf};
use crate::examples;
use crate::frame::{SHAPE_PREFIX, UNSAVED_HCBTF};
use crate::import::GraphFile;
use crate::panels::curves::timeline::Timeline;
use crate::panels::library;
use crate::state::crashes::CrashMark;
use crate::state::document::CHANGED_ON_DISK;
use crate::state::painting::work::OpenPainting;
use crate::state::parts::pictures::MovedPictures;
use crate::state::problem_text::sentence;
use crate::state::scene::{LookToOpen, OpenScene, real};
use crate::state::session::painting::is_painting_shown;
use crate::state::session::saving::OwnFiles;
use crate::state::shelf::SnapshotId;
use crate::state::wedge::WedgeSheet;
use crate::widgets::confirm;

/// Least turn of the lights that is worth telling of, in radians.
const TURNED: f64 = 0.01;

/// Action that would lose unsaved changes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum PendingAction {
    New,
    Open(PathBuf),
    /// Opens a look of the scene, which stays.
    Switch(PathBuf),
    /// Puts the scene aside; the look stays open.
    LeaveScene,
    /// Begins a shot over the scene that is open, or over the shot.
    NewShot {
        is_over_shot: bool,
    },
    Example(usize),
    /// Begins a new look from a snapshot.
    CopySnapshot(SnapshotId),
    Tour(TourTopic),
    NewPainting {
        grid: Grid,
        keeps_look: bool,
    },
    OpenPainting {
        path: PathBuf,
        keeps_look: bool,
    },
    /// Makes an HCBTF of pictures.
    ImportPainting {
        path: PathBuf,
        import: PictureImport,
    },
    /// Paints on an HCBTF that was made from another one.
    BeginPainting {
        hcbtf: Arc<Hcbtf>,
    },
    ClosePainting,
    /// Shows the painting in the look that it was painted in.
    ShowPainting,
    Close,
}

impl App {
    /// Opens a look, a scene or an HCBTF, and reports a failure.
    pub fn open(&mut self, path: &Path) {
        if is_painting(path) {
            return self.open_painting(path, false);
        }
        if let Some(sheet) = WedgeSheet::read(path) {
            if sheet.document.is_file() && WedgeSheet::read(&sheet.document).is_none() {
                self.open(&sheet.document);
            }
            return self.show_wedge(sheet);
        }
        self.open_alone(path);
        self.open_lacking_look();
        // Work that came back knows its file by its whole name.
        let file = real(path);
        let of_shot = self.session.shot().is_some_and(|shot| real(shot.path()) == file);
        let is_scene = |open: &OpenScene| open.path().map(real).as_ref() == Some(&file);
        if of_shot || self.session.open_scene().is_some_and(is_scene) {
            self.lay_out();
            self.dock.open(if of_shot { PanelId::SHOT } else { PanelId::OBJECTS });
            self.play_frames_of_shot();
            // The scene was asked for, and the look came with it: the scene is the recent file.
            self.safety.opened(path);
        }
    }

    /// Lets the timeline play the frames of the shot, if one is open.
    pub(super) fn play_frames_of_shot(&mut self) {
        if let Some(shot) = self.session.shot() {
            self.bench.memory.of::<Timeline>().play_range(shot.scene().time);
        }
    }

    /// Shows the sheet of a wedge, whose cells are to be taken.
    pub(super) fn show_wedge(&mut self, sheet: WedgeSheet) {
        self.start = None;
        if sheet.picture().is_file() {
            self.dock.open(PanelId::GRAPH);
        }
        self.bench.wedge.open(sheet);
        self.dock.open(PanelId::WEDGE);
    }

    /// Opens the look that a newly opened scene lacks.
    pub(super) fn open_lacking_look(&mut self) {
        match self.session.look_to_open() {
            Some(LookToOpen::File(path)) => {
                let told = self.message.take();
                self.open_alone(&path);
                self.message = told.or(self.message.take());
            }
            Some(LookToOpen::Unsaved) => self.safety.take_back_unsaved(&mut self.session),
            None => {}
        }
    }

    /// Makes a new look of another program's graph.
    fn import(&mut self, path: &Path, kind: GraphFile) {
        let Some(_going) = self.begin_to_read(path) else { return };
        self.safety.put_aside(&self.session);
        match self.session.import(path, kind) {
            Ok(told) => self.message = Some(told),
            Err(problems) => return self.safety.could_not_open(path, &problems, &self.session),
        }
        self.safety.look();
    }

    fn open_alone(&mut self, path: &Path) {
        if let Some(kind) = self.session.graph_file(path) {
            return self.import(path, kind);
        }
        let Some(_going) = self.begin_to_read(path) else { return };
        self.safety.put_aside(&self.session);
        if let Some(told) = self.safety.reopen(path, &mut self.session) {
            self.message = Some(told).filter(|told| !told.is_empty());
        } else {
            self.message = None;
            if let Err(problems) = self.session.open(path) {
                return self.safety.could_not_open(path, &problems, &self.session);
            }
            self.safety.opened(path);
        }
        self.safety.look();
    }

    /// Notes that a file is being read, until the returned mark is dropped. `None`, with a message,
    /// where the last program ended over that file.
    pub(super) fn begin_to_read(&mut self, path: &Path) -> Option<CrashMark> {
        let mark = self.session.journals.crashes.begin_to_read(path);
        if mark.is_none() {
            self.safety.was_interrupted(path, &self.session);
        }
        mark
    }

    /// Saves to a file, and reports a failure. Returns true if the file is written.
    pub fn save_as(&mut self, path: &Path) -> bool {
        self.write_look(path, OwnFiles::Linked).is_ok()
    }

    /// Saves the look to a file, and reports the result with what became of the files that the look
    /// names.
    ///
    /// # Errors
    /// The problem that was reported.
    pub(super) fn write_look(&mut self, path: &Path, own: OwnFiles) -> Result<(), Box<Diagnostic>> {
        let saved = self.session.save_named(path, own);
        let told = saved.as_ref().map(MovedPictures::told).unwrap_or_default();
        self.tell_saved(path, saved.map(drop))?;
        let orbit = &self.session.view.orbit;
        let is_turned = orbit.illumination.angle_between(DQuat::IDENTITY) > TURNED;
        let is_own = !orbit.mesh.starts_with(SHAPE_PREFIX) || is_turned;
        if is_own && self.session.open_scene().is_none() {
            self.message = Some(tr!(
                "Saved {file}: the look alone. The mesh and the turned lights are kept by a scene, \
                 which the panel Objects saves",
                file = path.display()
            ));
        }
        self.tell_besides(&told);
        Ok(())
    }

    /// Adds words on a document's files to what is told of its saving.
    pub(super) fn tell_besides(&mut self, told: &[String]) {
        if let Some(message) = &mut self.message {
            told.iter().for_each(|told| *message += &format!(" · {told}"));
        }
    }

    /// Reports the result of saving a document to a file, and returns it.
    pub(super) fn tell_saved(
        &mut self,
        path: &Path,
        saved: Result<(), Box<Diagnostic>>,
    ) -> Result<(), Box<Diagnostic>> {
        match &saved {
            Ok(()) => {
                self.message = Some(tr!("Saved {file}", file = path.display()));
                self.safety.opened(path);
            }
            Err(problem) => {
                self.message = Some(sentence(problem).replace('\n', ": "));
                if problem.code == CHANGED_ON_DISK {
                    self.safety.look_at_files(&mut self.session);
                }
            }
        }
        saved
    }

    /// Carries out an action if there are no changes to lose, or if the journal keeps them; else
    /// asks first.
    pub(super) fn do_or_ask(&mut self, pending: PendingAction) {
        self.pending = Some(pending);
        let is_kept = self.keeps_all();
        if !self.is_at_risk() || is_kept {
            self.go_on();
        }
    }

    /// Documents whose changes the pending action would lose, if nothing kept them: the look, and
    /// the scene.
    fn at_risk(&self) -> (bool, bool) {
        let (look, scene) = match self.pending {
            Some(PendingAction::Switch(_)) => (true, false),
            Some(PendingAction::LeaveScene) => (false, true),
            Some(PendingAction::NewShot { .. }) => return self.lacking_under_shot(),
            Some(PendingAction::ClosePainting) => (false, false),
            Some(
                PendingAction::NewPainting { keeps_look, .. }
                | PendingAction::OpenPainting { keeps_look, .. },
            ) => {
                let stays = keeps_look || self.keeps_look();
                (!stays, !stays)
            }
            Some(PendingAction::ImportPainting { .. } | PendingAction::BeginPainting { .. }) => {
                (!self.keeps_look(), !self.keeps_look())
            }
            _ => (true, true),
        };
        let is_scene_dirty = self.session.open_scene().is_some_and(OpenScene::is_dirty);
        (look && self.session.is_look_dirty(), scene && is_scene_dirty)
    }

    /// True for each of look and scene whose file lacks what a shot over it is to show: the shot's
    /// own file, where one is open.
    fn lacking_under_shot(&self) -> (bool, bool) {
        if let Some(shot) = self.session.shot() {
            return (false, shot.is_dirty() || !shot.has_file());
        }
        let open_scene = self.session.open_scene();
        let lacks = |open_scene: &OpenScene| {
            open_scene.is_dirty() || open_scene.path().is_none() || open_scene.wears_unsaved()
        };
        (self.session.is_look_dirty(), open_scene.is_some_and(lacks))
    }

    fn is_at_risk(&self) -> bool {
        self.at_risk() != (false, false) || self.is_painting_at_risk()
    }

    /// True if the journals keep the changes at risk.
    fn keeps_all(&mut self) -> bool {
        (!self.is_painting_at_risk() || self.session.keeps_painting())
            && (self.at_risk() == (false, false) || self.session.keeps_work())
    }

    /// True if the pending action is about the painting, and that is not saved.
    fn is_painting_at_risk(&self) -> bool {
        let is_about = matches!(
            self.pending,
            Some(
                PendingAction::NewPainting { .. }
                    | PendingAction::OpenPainting { .. }
                    | PendingAction::ImportPainting { .. }
                    | PendingAction::BeginPainting { .. }
                    | PendingAction::ClosePainting
                    | PendingAction::Close
            )
        );
        is_about && self.session.is_painting_dirty()
    }

    /// True if Save is to save the painting: where the painting is asked about, or nothing is.
    pub(super) fn saves_painting(&self) -> bool {
        // A look that names a painting without a file is saved after it: the look would name a file
        // that does not exist.
        let is_look_saved = self.pending.is_none() || self.at_risk().0;
        if is_look_saved
            && self.session.painting().is_some_and(|work| work.path().is_none())
            && self.names_unsaved()
        {
            return true;
        }
        // A question about a painting without a file that the open look does not show would come
        // out of the blue.
        let has_place = self.session.painting().is_some_and(|work| work.path().is_some());
        let is_meant = self.pending.is_none() && (has_place || is_painting_shown(&self.session));
        self.session.is_painting_dirty() && (is_meant || self.is_painting_at_risk())
    }

    fn names_unsaved(&self) -> bool {
        self.session.shows_painting(Path::new(UNSAVED_HCBTF))
    }

    /// Carries out the action that waited for a save, if nothing else is to be saved.
    pub(super) fn go_on_if_safe(&mut self) {
        if !self.is_at_risk() {
            self.go_on();
        }
    }

    pub(super) fn go_on(&mut self) {
        if self.pending.is_some() {
            // Another document has another graph.
            self.bench.wedge.enlarge(false);
        }
        match self.pending.take() {
            Some(PendingAction::New) => {
                self.session.start_new();
                self.safety.look();
            }
            Some(PendingAction::Open(path) | PendingAction::Switch(path)) => self.open(&path),
            Some(PendingAction::Example(index)) => {
                self.open_example(index);
                self.safety.look();
            }
            Some(PendingAction::CopySnapshot(id)) => self.copy_snapshot(id),
            Some(PendingAction::Tour(topic)) => self.begin_tour(topic),
            Some(PendingAction::LeaveScene) => {
                self.safety.put_aside(&self.session);
                self.session.leave_scene(false);
                self.safety.look();
            }
            Some(PendingAction::NewPainting { grid, keeps_look }) => {
                self.new_painting(grid, keeps_look);
            }
            Some(PendingAction::OpenPainting { path, keeps_look }) => {
                self.open_painting(&path, keeps_look);
            }
            Some(PendingAction::ImportPainting { path, import }) => {
                self.import_painting(path, import);
            }
            Some(PendingAction::BeginPainting { hcbtf }) => self.begin_made(&hcbtf),
            Some(PendingAction::ClosePainting) => self.close_painting(),
            Some(PendingAction::ShowPainting) => self.go_back_to_painting(),
            Some(PendingAction::NewShot { is_over_shot }) => self.begin_shot(is_over_shot),
            Some(PendingAction::Close) => self.closes = true,
            None => {}
        }
    }

    fn open_example(&mut self, index: usize) {
        let Some(example) = library::example(index) else { return };
        match example.content {
            library::ExampleContent::Scene(scene) => {
                self.session.start_scene(scene, example.stem);
                self.lay_out();
                self.dock.open(PanelId::OBJECTS);
            }
            library::ExampleContent::Look(_) => {
                let text = examples::text(&example.path).unwrap_or_default();
                self.session.start_from(&text, example.stem);
            }
            library::ExampleContent::Shot(_) => self.open(&example.path),
        }
    }

    pub(super) fn ask_about_changes(&mut self, ui: &Ui, commands: &mut Vec<Command>) {
        if self.pending.is_none() || !self.is_at_risk() {
            return;
        }
        if matches!(self.pending, Some(PendingAction::NewShot { .. })) {
            return self.ask_to_save_under_shot(ui, commands);
        }
        let modal = egui::Modal::new(egui::Id::unique("unsaved")).show(ui.ctx(), |ui| {
            ui.set_width(320.0);
            let enters = confirm::enters(ui);
            let name = match self.session.open_scene() {
                _ if self.is_painting_at_risk() && self.at_risk() == (false, false) => {
                    self.session.painting().map(OpenPainting::name).unwrap_or_default()
                }
                Some(open_scene) if !self.at_risk().0 && self.at_risk().1 => {
                    open_scene.name_of_changed()
                }
                _ => self.session.name(),
            };
            ui.label(RichText::new(tr!("{name} has changes")).heading());
            ui.label(tr!("They are lost unless you save them."));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                if ui.button(tr!("Save")).clicked() || enters {
                    commands.push(Command::Save);
                }
                if ui.button(tr!("Do not save")).clicked() {
                    let (look, scene) = self.at_risk();
                    self.session.give_up_changes(look, scene);
                    if let Some(work) =
                        self.session.painting_mut().filter(|_| self.pending.is_some())
                    {
                        work.give_up_changes();
                    }
                    self.go_on();
                }
                if ui.button(tr!("Cancel")).clicked() {
                    self.pending = None;
                }
            });
        });
        if modal.should_close() {
            self.pending = None;
        }
    }

    /// Asks to save what a new shot is to lie over.
    fn ask_to_save_under_shot(&mut self, ui: &Ui, commands: &mut Vec<Command>) {
        let open_scene = self.session.open_scene();
        let name = open_scene.map(OpenScene::name_of_changed).unwrap_or_default();
        let has_files = match (self.session.shot(), open_scene) {
            (Some(_), _) | (None, None) => true,
            (None, Some(scene)) => scene.path().is_some() && !scene.wears_unsaved(),
        };
        let modal =
            egui::Modal::new(egui::Id::unique("under shot")).show(ui.ctx(), |ui| {
                ui.set_width(340.0);
                let enters = confirm::enters(ui);
                ui.label(RichText::new(tr!("A shot lies over files")).heading());
                ui.label(match has_files {
                true => tr!(
                    "Save {name} first: the shot shows it as its file has it, and changes values \
                     over it, frame by frame."
                ),
                false => tr!("Save the scene first, and its look beside it: the shot shows them as \
                              their files have them, and changes values over them, frame by \
                              frame.")
                    .to_owned(),
            });
                ui.add_space(8.0);
                ui.horizontal(|ui| {
                    if ui.button(tr!("Save")).clicked() || enters {
                        commands.push(match has_files {
                            true => Command::Save,
                            false => Command::Scene(SceneCommand::Save),
                        });
                    }
                    if ui.button(tr!("Cancel")).clicked() {
                        self.pending = None;
                    }
                });
            });
        if modal.should_close() {
            self.pending = None;
        }
    }
}

/// True if a file is an HCBTF, by its name.
pub(super) fn is_painting(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(PAINTING))
}
