//! The one place that does what panels, keys and menus ask for.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

use eframe::egui::{self, Ui};

use super::App;
use super::files::{self, Pending};
use crate::app::dialogs::Purpose;
use crate::app::dock;
use crate::app::look_export::stem_of;
use crate::canvas::edits;
use crate::commands::Command;
use crate::commands::shortcuts::{self, Action};
use crate::diag::Diagnostic;
use crate::document::{Edit, Storage};
use crate::hcbtf::exchange::Form;
use crate::painter as painting;
use crate::state::painting::look;
use crate::state::safety::Wish;
use crate::state::safety::crashes::DocumentOrigin;
use crate::state::session::Session;
use crate::state::stage::Stage;
use crate::tools::fitting;
use crate::viewport::Export;

impl App {
    pub(super) fn apply(&mut self, ui: &Ui, command: Command) {
        if !matches!(
            command,
            Command::Act(_)
                | Command::Select(_)
                | Command::Reveal(_)
                | Command::Show(_)
                | Command::OpenGraph(_)
        ) {
            self.message = None;
        }
        match command {
            Command::Edit(edit) => self.tell(|session| session.apply(edit, None)),
            Command::EditHeld(widget, edit) => {
                let hand = self.hand(ui, widget);
                self.tell(|session| session.apply(edit, Some(hand)));
            }
            Command::Select(ids) => self.session.select(ids),
            Command::Reveal(id) => {
                self.session.select(vec![id.clone()]);
                self.canvas.reveal(id);
            }
            Command::Show(path) => {
                let ids = path.ids();
                self.session.open_graph(&ids[..ids.len().saturating_sub(1)]);
                if let Some(id) = self.session.step_here(&path).cloned() {
                    self.session.select(vec![id.clone()]);
                    self.canvas.reveal(id);
                }
            }
            Command::OpenGraph(path) => self.session.open_graph(&path),
            Command::Undo => drop(self.session.undo()),
            Command::Redo => drop(self.session.redo()),
            Command::New => self.do_or_ask(Pending::New),
            Command::Open(Some(path)) if files::is_painting(&path) => {
                self.do_or_ask(Pending::OpenPainting { path, keeps_look: false });
            }
            Command::Open(Some(path)) => self.do_or_ask(Pending::Open(path)),
            Command::Open(None) => self.dialogs.ask(Purpose::Open, self.session.path()),
            Command::OpenPath => self.open_path_field(),
            Command::Forget(path) => self.safety.change_settings(|settings| settings.forget(&path)),
            Command::ShowStart(true) => self.show_start_page(),
            Command::ShowStart(false) => self.start = None,
            Command::StartTour => self.do_or_ask(Pending::Tour),
            Command::Save => self.save(),
            Command::SaveAs => self.ask_where_to_save(),
            Command::SaveTo(path) => {
                if self.save_as(&path) {
                    self.go_on_if_safe();
                }
            }
            Command::ShowOn(Some(path)) => self.show_on(&path.to_string_lossy()),
            Command::StandUp(z_is_up) => self.stand_up(z_is_up),
            Command::ShowOn(None) => {
                self.dialogs.ask(Purpose::Mesh, Some(Path::new(&self.session.view.mesh)));
            }
            Command::Probe(on) => {
                self.probe.turn(on);
                if on {
                    self.turn_fitting(false);
                    self.dock.open(dock::Panel::Probe);
                }
            }
            Command::ShowWire(wire) => self.session.show_wire(wire),
            Command::Export(export, Some(path)) => {
                self.viewport.export(&self.session, export, path);
            }
            Command::Export(export, None) => {
                self.dialogs.ask(Purpose::Export(export), self.session.path());
            }
            Command::ExportLook(language, Some(folder)) => {
                self.look_exports.write(&self.session, language, folder);
            }
            Command::ExportLook(language, None) => {
                let near = self.look_exports.suggested(&self.session);
                self.dialogs.ask(Purpose::Shaders(language), Some(&near));
            }
            Command::CopyPicture => {
                // The panel of the picture takes what was drawn to the clipboard.
                self.start = None;
                self.dock.open(dock::Panel::Picture);
                self.viewport.copy(&self.session, ui.pixels_per_point());
            }
            Command::CopyWgsl => self.copy_wgsl(ui),
            Command::ShowReference(Some(path)) => self.viewport.show_reference(path),
            Command::ShowReference(None) => {
                self.dialogs.ask(Purpose::Reference, self.session.path());
            }
            Command::LeaveProbe => self.probe.escape(),
            Command::Solo(solo) => self.session.set_solo(solo),
            Command::ShowPanel(dock::Panel::Paint) if look::shows(&self.session) => {
                self.show_painting_panels();
            }
            Command::ShowPanel(panel) => {
                self.start = None;
                self.dock.open(panel);
            }
            Command::GoTo(place) => self.session.go_to(place),
            Command::AddNode { kind, at } => self.add_node(&kind, at),
            Command::ShareGroup(id) => self.message = Some(self.session.share_group(&id)),
            Command::OpenExample(index) => self.do_or_ask(Pending::Example(index)),
            Command::Copy(text) => ui.ctx().copy_text(text),
            Command::SelectKey(key) => self.session.key = key,
            Command::SetTime(time) => self.session.time = time,
            Command::TurnTo(view) => self.session.view = *view,
            Command::Stage(wish) => self.apply_to_stage(ui, wish),
            Command::Paint(wish) => self.apply_to_painting(ui, wish),
            Command::Fit(wish) => self.apply_to_fitting(wish),
            Command::Safety(wish) => self.apply_to_safety(wish),
            Command::Tell(text) => self.message = Some(text),
            Command::Act(action) => self.act(ui, action),
        }
    }

    fn apply_to_safety(&mut self, wish: Wish) {
        if wish == Wish::OpenAnother {
            self.dialogs.ask(Purpose::Open, self.session.path());
        }
        if wish == Wish::ReadAgain
            && let Some(path) = self.safety.interrupted()
        {
            self.session.crashes.trust(&DocumentOrigin::of_file(&path));
            return self.open(&path);
        }
        let painting = self.painting_number();
        self.message = self.safety.apply(wish, &mut self.session);
        self.open_lacking_look();
        self.show_painting_taken_back(painting);
    }

    /// What edits: a widget, for as long as it is held or has the keyboard.
    pub(super) fn hand(&self, ui: &Ui, widget: egui::Id) -> u64 {
        let focus = ui.memory(egui::Memory::focused);
        let mut hasher = DefaultHasher::new();
        (widget, self.presses, focus).hash(&mut hasher);
        hasher.finish()
    }

    /// Does what the command palette chose.
    fn act(&mut self, ui: &Ui, action: Action) {
        let command = match action {
            Action::New => Command::New,
            Action::Open => Command::Open(None),
            Action::Save => Command::Save,
            Action::SaveAs => Command::SaveAs,
            Action::Undo => Command::Undo,
            Action::Redo => Command::Redo,
            Action::Probe => Command::Probe(!self.probe.is_on()),
            Action::PaintLight => Command::Fit(fitting::Wish::Turn(!self.fitting.is_on())),
            Action::FitLook => Command::Fit(fitting::Wish::Fit(fitting::What::ThisLook)),
            Action::LightTool(_) | Action::LightBrush { .. } => return self.fitting.act(action),
            Action::OpenPath => Command::OpenPath,
            Action::Start => Command::ShowStart(true),
            Action::Tour => Command::StartTour,
            Action::CopyPicture => Command::CopyPicture,
            Action::CopyWgsl => Command::CopyWgsl,
            Action::CopyShader(language, ending) => {
                return self.look_exports.copy(&self.session, language, ending);
            }
            Action::Export(language) => Command::ExportLook(language, None),
            Action::ExportPicture => {
                let size = self.viewport.size_in_pixels(ui.pixels_per_point());
                Command::Export(Export::Picture(size), None)
            }
            Action::Paint => Command::ShowPanel(dock::Panel::Paint),
            Action::PaintShown => Command::Paint(painting::Wish::PaintShown),
            Action::NewHcbtf(preset) => {
                Command::Paint(painting::Wish::New { grid: preset.grid(), keeps_look: false })
            }
            Action::NewHcbtfOf => Command::Paint(painting::Wish::AskGrid { changes: false }),
            Action::GridOfHcbtf => Command::Paint(painting::Wish::AskGrid { changes: true }),
            Action::TileOfHcbtf => Command::Paint(painting::Wish::AskSynthesis),
            Action::BakeLook => Command::Paint(painting::Wish::AskBake),
            Action::SaveHcbtf => Command::Paint(painting::Wish::Save),
            Action::SaveHcbtfAs => Command::Paint(painting::Wish::SaveAs),
            Action::CloseHcbtf => Command::Paint(painting::Wish::Close),
            Action::ImportHcbtf => Command::Paint(painting::Wish::AskImport),
            Action::ExportHcbtf(Form::Ktx2) => Command::Paint(painting::Wish::AskTexture),
            Action::ExportHcbtf(form) => Command::Paint(painting::Wish::Export {
                form,
                storage: Storage::default(),
                to: None,
            }),
            Action::Tool(_)
            | Action::Brush { .. }
            | Action::SwapColors
            | Action::Flat
            | Action::Copies
            | Action::Arrows
            | Action::FitTile
            | Action::StepView(_)
            | Action::StepLight(_) => return self.painting.act(action, &mut self.session),
            Action::Commands | Action::Shortcuts => return self.sheet.open(action),
            Action::ResetView
            | Action::FrameObject
            | Action::FrameAll
            | Action::Projection
            | Action::Turntable
            | Action::Handles => {
                return self.viewport.act(action, &mut self.session);
            }
            action => {
                self.start = None;
                return self.canvas.ask(action);
            }
        };
        self.apply(ui, command);
    }

    fn add_node(&mut self, kind: &str, at: Option<egui::Pos2>) {
        let Some(kind) = self.session.catalog.all().find(|known| known.id == kind).cloned() else {
            return;
        };
        let at = self.canvas.place_for(at);
        let (id, edits) = edits::add(&self.session, &kind, at);
        self.tell(|session| session.apply(Edit::Group { edits }, None));
        self.session.select(vec![id]);
    }

    fn ask_where_to_save(&mut self) {
        let by_name = || PathBuf::from(format!("{}.json", stem_of(&self.session.look().name)));
        let near = self.session.path().map_or_else(by_name, Path::to_path_buf);
        self.dialogs.ask(Purpose::Save, Some(&near));
    }

    /// Copies the shader as it is exported: with values folded into it.
    fn copy_wgsl(&mut self, ui: &Ui) {
        let shader = self.session.baked().map(|shader| shader.wgsl.clone());
        let told = match shader {
            Some(wgsl) => {
                ui.ctx().copy_text(wgsl);
                "The shader is in the clipboard, as WGSL"
            }
            None => "There is no shader to copy until the look compiles: Problems tells why",
        };
        self.message = Some(told.to_owned());
    }

    /// Esc gives up a drag on the picture, before it does anything else: what was changed is as it
    /// was.
    pub(super) fn give_up_drag(&mut self, ui: &Ui) {
        if self.viewport.is_dragging()
            && shortcuts::take(ui, (egui::Modifiers::NONE, egui::Key::Escape))
            && self.viewport.give_up(&mut self.session)
        {
            self.session.undo();
        }
    }

    pub(super) fn tell(&mut self, edit: impl FnOnce(&mut Session) -> Result<(), Box<Diagnostic>>) {
        if let Err(problem) = edit(&mut self.session) {
            self.message = Some(problem.message);
        }
    }

    /// Saves what has changed: the look, and the scene around it. Asks where what has no file is to
    /// go.
    pub(super) fn save(&mut self) {
        let Some(did_paint) = self.save_painting_first() else { return };
        let is_scene_dirty = self.session.stage().is_some_and(Stage::is_dirty);
        let saves_look = self.session.is_look_dirty() || !is_scene_dirty && !did_paint;
        if saves_look {
            let Some(path) = self.session.path().map(Path::to_path_buf) else {
                return self.ask_where_to_save();
            };
            if !self.save_as(&path) {
                return;
            }
        }
        // A scene that nobody has saved yet is only asked about where it is what is to be saved.
        let has_file = self.session.stage().is_some_and(|stage| stage.path().is_some());
        let is_wanted = match self.pending {
            None => !saves_look,
            Some(Pending::Switch(_)) => false,
            Some(_) => true,
        };
        if is_scene_dirty && (has_file || is_wanted) {
            return self.save_scene();
        }
        self.go_on_if_safe();
    }
}
