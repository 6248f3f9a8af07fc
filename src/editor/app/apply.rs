//! Application of commands: the one place that carries out what panels, keys and menus ask for.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

use chiaro_locale::tr;
use eframe::egui::{self, Ui};

use super::App;
use super::files::{self, PendingAction};
use crate::app::look_export::stem_of;
use crate::canvas::edits;
use crate::commands::{
    Command, FilePurpose, FitCommand, MaskCommand, PaintCommand, PanelId, PictureExport,
    TimelineCommand, ViewCommand, keyboard,
};
use crate::diag::Diagnostic;
use crate::document::{Edit, Projection, Target, Value};
use crate::files::relative;
use crate::ids::NodePath;
use crate::panels::curves::timeline::Timeline;
use crate::state::paths::absolute;
use crate::state::revision::GestureId;
use crate::state::scene::{OpenScene, turned_around};
use crate::state::session::Session;
use crate::state::session::painting::is_painting_shown;
use crate::state::session::saving::OwnFiles;
use crate::state::wedge::WedgeSheet;
use crate::tools::flip::FlipBook;
use crate::tools::handles::HandlesSwitch;
use crate::tools::placing::PlacingTool;
use crate::tools::probe::Probe;

/// True if the last message stays while a command is carried out.
fn keeps_message(command: &Command) -> bool {
    use PaintCommand as P;
    match command {
        Command::Select(_)
        | Command::ChooseLight(_)
        | Command::Reveal(_)
        | Command::Show(_)
        | Command::OpenGraph(_)
        | Command::OpenPalette
        | Command::Scale(_)
        | Command::OpenShortcuts
        | Command::Copy(_)
        | Command::CopyShader(..)
        | Command::Graph(_)
        | Command::Sketch(_)
        | Command::Fit(FitCommand::TakeBrush(_) | FitCommand::ResizeBrush { .. }) => true,
        Command::View(command) => !matches!(command, ViewCommand::TurnTo(_)),
        Command::Paint(command) => matches!(
            command,
            P::TakeTool(_)
                | P::ResizeBrush { .. }
                | P::SwapColors
                | P::ToggleTilt
                | P::ToggleCopies
                | P::ToggleArrows
                | P::FitTile
                | P::StepView(_)
                | P::StepLight(_)
                | P::ShowStroke(_)
        ),
        _ => false,
    }
}

impl App {
    /// Carries out a command, and drops the last message unless the command keeps it.
    pub(super) fn apply(&mut self, ui: &Ui, command: Command) {
        if !keeps_message(&command) {
            self.message = None;
            self.refused = None;
        }
        self.carry_out(ui, command);
    }

    /// Carries out a command.
    pub(super) fn carry_out(&mut self, ui: &Ui, command: Command) {
        self.uncover_graph(&command);
        match command {
            Command::Edit(edit) => self.tell(|session| session.apply(edit, None)),
            Command::EditHeld(widget, edit) => {
                let gesture = self.gesture(ui, widget);
                self.tell(|session| session.apply(edit, Some(gesture)));
            }
            Command::Scale(scale) => scale.apply(ui.ctx()),
            Command::Speak(tag) => self.speak(tag),
            Command::Select(ids) => self.session.select(ids),
            Command::Reveal(id) => {
                self.session.select(vec![id.clone()]);
                self.bench.canvas.reveal(id);
            }
            Command::Show(path) => self.show_node(&path),
            Command::OpenGraph(path) => self.session.open_graph(&path),
            Command::Undo => drop(self.session.undo()),
            Command::Redo => drop(self.session.redo()),
            Command::New => self.do_or_ask(PendingAction::New),
            Command::Open(Some(path)) if files::is_painting(&path) => {
                self.do_or_ask(PendingAction::OpenPainting { path, keeps_look: false });
            }
            Command::Open(Some(path)) => match WedgeSheet::read(&path) {
                Some(sheet) => self.show_wedge(sheet),
                None => self.do_or_ask(PendingAction::Open(path)),
            },
            Command::Open(None) => self.dialogs.ask(FilePurpose::Open, self.session.path()),
            Command::OpenPath => self.open_path_field(),
            Command::Forget(path) => self.safety.change_settings(|settings| settings.forget(&path)),
            Command::ShowStart(true) => self.show_start_page(),
            Command::ShowStart(false) => self.start = None,
            Command::StartTour(topic) => self.do_or_ask(PendingAction::Tour(topic)),
            Command::OpenPalette => self.sheet.open_palette(),
            Command::OpenShortcuts => self.sheet.open_shortcuts(),
            command @ (Command::Save
            | Command::SaveAs
            | Command::SaveWithFiles
            | Command::SaveTo(..)) => self.apply_saving(command),
            Command::ShowOn(Some(path)) => self.show_on(&path.to_string_lossy()),
            Command::ShowOn(None) => self.ask_for_mesh(),
            Command::StandUp(z_is_up) => self.stand_up(z_is_up),
            Command::Probe(switch) => {
                let on = switch.turned(self.probe().is_on());
                self.turn_probe(ui, on);
            }
            Command::ShowWire(wire) => self.session.show_wire(wire),
            command @ (Command::Export(..)
            | Command::ExportPicture
            | Command::CopyShader(..)
            | Command::ExportLook(..)
            | Command::CopyPicture
            | Command::CopyWgsl) => self.export(ui, command),
            Command::ShowReference(path) => self.show_or_ask_reference(path.as_deref()),
            Command::AskImage(target) => self.ask_for_image(target),
            Command::TakeImage(path) => self.take_image(&path),
            Command::Display(command) => self.apply_to_display(command),
            Command::CompareFrames(path) => self.compare_frames(path),
            Command::LeaveProbe => self.bench.tools.of_mut::<Probe>().escape(),
            Command::Solo(solo) => self.session.set_solo(solo),
            Command::KeepLightColumns(columns) => self.keep_light_columns(columns),
            Command::KeepFrameMemory(mib) => self.keep_frame_memory(mib),
            Command::KeepFarm(farm) => self.keep_farm(farm),
            Command::ChooseLight(id) => self.session.choose_light(id),
            Command::LinkPointed(is_linked) => self.link_pointed(ui, is_linked),
            Command::ShowPanel(PanelId::PAINT) if is_painting_shown(&self.session) => {
                self.show_painting_panels();
            }
            Command::ShowPanel(panel) => {
                self.start = None;
                self.dock.open(panel);
            }
            Command::GoTo(place) => self.session.go_to(place),
            Command::AddNode { kind, at } => self.add_node(&kind, at),
            Command::ShareGroup(id) => self.message = Some(self.session.share_group(&id)),
            Command::OpenExample(index) => self.do_or_ask(PendingAction::Example(index)),
            Command::Copy(text) => ui.ctx().copy_text(text),
            Command::SelectKey(key) => self.session.selection.key = key,
            Command::SetTime(time) => self.session.set_time(time),
            Command::Timeline(command) => self.ask_timeline(ui, command),
            Command::TakeCell(cell, scope) => self.take_cell(&cell, scope),
            Command::View(command) => self.apply_to_view(command),
            Command::Graph(command) => {
                self.start = None;
                self.bench.canvas.ask(command);
            }
            Command::Library(command) => self.apply_to_library(ui, command),
            Command::Scene(command) => self.apply_scene_command(ui, command),
            Command::Snapshot(command) => self.apply_to_snapshots(command),
            Command::Paint(command) => self.apply_to_painting(ui, command),
            Command::Film(command) => self.apply_to_film(ui, command),
            Command::Fit(command) => self.apply_to_fitting(ui, command),
            Command::Placing(command) => self.apply_to_placing(ui, command),
            Command::Mask(command) => self.apply_to_masking(ui, command),
            Command::Sketch(command) => self.apply_to_sketch(command),
            Command::Recovery(command) => self.apply_to_recovery(command),
            Command::ReadNotes => self.session.read_notes(),
            Command::Tell(text) => self.message = Some(text),
        }
    }

    /// Compares with a picture, or asks which.
    fn show_or_ask_reference(&mut self, picture: Option<&Path>) {
        match picture {
            Some(path) => self.show_reference(path),
            None => self.dialogs.ask(FilePurpose::Reference, self.session.path()),
        }
    }

    /// Links the lights that are selected in *Links* to the object pointed at, or unlinks them.
    fn link_pointed(&mut self, ui: &Ui, is_linked: bool) {
        for command in self.bench.links.link_pointed(&self.session, is_linked) {
            self.carry_out(ui, command);
        }
    }

    /// Asks for a mesh to show the look on.
    fn ask_for_mesh(&mut self) {
        self.dialogs.ask(FilePurpose::Mesh, Some(Path::new(&self.session.view.orbit.mesh)));
    }

    /// Remembers columns of the light table that are shown or hidden by hand.
    fn keep_light_columns(&mut self, columns: BTreeMap<String, bool>) {
        self.safety.change_settings(|settings| settings.light_columns = columns);
    }

    fn keep_farm(&mut self, farm: &str) {
        self.safety.change_settings(|settings| settings.farm = Some(farm.to_owned()));
    }

    fn ask_timeline(&mut self, ui: &Ui, command: TimelineCommand) {
        self.start = None;
        self.dock.open(PanelId::TIMELINE);
        self.bench.memory.of::<Timeline>().ask(command);
        ui.ctx().request_repaint();
    }

    /// Bounds the memory of kept frames from now on, in MiB.
    fn keep_frame_memory(&mut self, mib: u32) {
        self.safety.change_settings(|settings| settings.frame_memory = mib);
        self.bench.tools.playback().set_memory(mib);
    }

    /// Opens rendered frames in the flip book, or asks for them.
    fn compare_frames(&mut self, path: Option<PathBuf>) {
        match path {
            Some(path) => self.bench.tools.of_mut::<FlipBook>().open(path),
            None => self.dialogs.ask(FilePurpose::Frames, self.session.path()),
        }
    }

    /// Saves the look, or asks where to save it.
    fn apply_saving(&mut self, command: Command) {
        match command {
            Command::SaveAs => self.ask_where_to_save(FilePurpose::Save),
            Command::SaveWithFiles => self.ask_where_to_save(FilePurpose::SaveWithFiles),
            Command::SaveTo(path, own) => self.save_to(&path, own),
            _ => self.save(),
        }
    }

    /// Saves the look to a file, and goes on with what waited for it.
    fn save_to(&mut self, path: &Path, own: OwnFiles) {
        match self.write_look(path, own) {
            Ok(()) => self.go_on_if_safe(),
            Err(problem) => {
                let purpose = match own {
                    OwnFiles::Linked => FilePurpose::Save,
                    OwnFiles::Copied => FilePurpose::SaveWithFiles,
                };
                self.ask_again(purpose, path, &problem);
            }
        }
    }

    fn ask_for_image(&mut self, target: Target) {
        self.dialogs.ask(FilePurpose::Image, self.session.path());
        self.asked_image = Some(target);
    }

    /// Gives the input that asked for an image its path, beside the look where that has a file.
    fn take_image(&mut self, path: &Path) {
        let Some(target) = self.asked_image.take() else { return };
        let (folder, path) = (self.session.look.folder(), absolute(path));
        let name = match folder.as_os_str().is_empty() {
            true => path.to_string_lossy().into_owned(),
            false => relative(&absolute(&folder), &path),
        };
        let edit = self.session.keys().set_at(&target, Value::Text(name));
        self.tell(|session| session.apply(edit, None));
    }

    /// Carries out a command that takes a picture or a shader out of the window.
    fn export(&mut self, ui: &Ui, command: Command) {
        match command {
            Command::Export(export, Some(path)) => {
                self.bench.viewport.export(&self.session, export, path);
            }
            Command::Export(export, None) => {
                self.dialogs.ask(FilePurpose::Export(export), self.session.path());
            }
            Command::ExportPicture => {
                let size = self.bench.viewport.size_in_pixels(ui.pixels_per_point());
                let purpose = FilePurpose::Export(PictureExport::Picture(size));
                self.dialogs.ask(purpose, self.session.path());
            }
            Command::CopyShader(language, ending) => {
                self.look_exports.copy(&self.session, language, ending);
            }
            Command::ExportLook(language, Some(folder)) => {
                let options = self.bench.export.options();
                self.look_exports.write(&self.session, language, folder, options);
            }
            Command::ExportLook(language, None) => {
                let near = self.look_exports.suggested(&self.session);
                self.dialogs.ask(FilePurpose::Shaders(language), Some(&near));
            }
            Command::CopyPicture => self.copy_picture(ui),
            Command::CopyWgsl => self.copy_wgsl(ui),
            _ => {}
        }
    }

    /// Opens the graph that a node lies in, selects the node and brings it into view.
    fn show_node(&mut self, path: &NodePath) {
        let ids = path.ids();
        self.session.open_graph(&ids[..ids.len().saturating_sub(1)]);
        if let Some(id) = self.session.graph_view().step_of(path).cloned() {
            self.session.select(vec![id.clone()]);
            self.bench.canvas.reveal(id);
        }
    }

    /// Turns the probe on or off; light on the picture is no longer painted then, since both take
    /// the pointer.
    fn turn_probe(&mut self, ui: &Ui, on: bool) {
        self.bench.tools.of_mut::<Probe>().turn(on);
        if on {
            self.bench.tools.of_mut::<PlacingTool>().turn(false);
            self.apply_to_masking(ui, MaskCommand::Leave);
            self.turn_fitting(ui, false);
            self.dock.open(PanelId::PROBE);
        }
    }

    /// Copies the picture: its panel puts the drawn picture on the clipboard.
    fn copy_picture(&mut self, ui: &Ui) {
        self.start = None;
        self.dock.open(PanelId::PICTURE);
        self.bench.viewport.copy(&self.session, ui.pixels_per_point());
    }

    fn apply_to_view(&mut self, command: ViewCommand) {
        let aspect = self.bench.viewport.aspect();
        match command {
            ViewCommand::TurnTo(view) => self.session.view.orbit = *view,
            ViewCommand::Reset => self.session.reset_view(),
            ViewCommand::TurnAround => self.turn_around(),
            ViewCommand::FrameObject => {
                let selected = self.session.open_scene().and_then(OpenScene::selected);
                let selected = selected.map(|(id, _)| id.clone());
                self.session.frame(selected.as_ref(), aspect);
            }
            ViewCommand::FrameAll => self.session.frame(None, aspect),
            ViewCommand::SwitchProjection => {
                self.session.view.orbit.projection = match self.session.view.orbit.projection {
                    Projection::Perspective => Projection::Orthographic,
                    Projection::Orthographic => Projection::Perspective,
                };
            }
            ViewCommand::LookThrough => match self.bench.viewport.look_through(&self.session) {
                Ok(view) => self.session.view.orbit = view,
                Err(why) => self.message = Some(why),
            },
            ViewCommand::Compare(picture) => self.compare(picture),
            ViewCommand::Vary(subject) => self.vary(subject),
            ViewCommand::ToggleTurntable => self.bench.viewport.toggle_turntable(),
            ViewCommand::ToggleTransform(part) => {
                let shown = &mut self.session.view.handled;
                *shown = (*shown != Some(part)).then_some(part);
            }
            ViewCommand::ToggleHandles => {
                let shown = &mut self.bench.tools.of_mut::<HandlesSwitch>().is_on;
                *shown = !*shown;
            }
        }
    }

    /// Turns the selected object of the scene around; without a scene, camera and lights around the
    /// mesh of the look.
    fn turn_around(&mut self) {
        let Some(open_scene) = self.session.open_scene() else {
            return self.session.view.orbit.turn_around();
        };
        let edit = open_scene.selected().and_then(|(id, _)| {
            open_scene.change(id, |object| {
                object.transform.rotate = turned_around(object.transform.rotate);
            })
        });
        match edit {
            Some(edit) => self.tell(|session| session.apply_to_scene(edit, None)),
            None => self.message = Some(tr!("Select an object first").to_owned()),
        }
    }

    /// Gesture that edits: a widget, for as long as it is held or has the keyboard.
    pub(super) fn gesture(&self, ui: &Ui, widget: egui::Id) -> GestureId {
        let focus = ui.memory(egui::Memory::focused);
        let mut hasher = DefaultHasher::new();
        (widget, self.presses, focus).hash(&mut hasher);
        GestureId(hasher.finish())
    }

    fn add_node(&mut self, kind: &str, at: Option<egui::Pos2>) {
        let Some(kind) = self.session.project.catalog.all().find(|known| known.id == kind).cloned()
        else {
            return;
        };
        let at = self.bench.canvas.place_for(at);
        let (id, edits) = edits::add(&self.session, &kind, at);
        self.tell(|session| session.apply(Edit::Group { edits }, None));
        self.session.select(vec![id]);
    }

    fn ask_where_to_save(&mut self, purpose: FilePurpose) {
        if self.session.shot().is_some() {
            return self.dialogs.ask(FilePurpose::SaveShot, self.near_scene().as_deref());
        }
        let by_name = || PathBuf::from(format!("{}.json", stem_of(&self.session.look().name)));
        let near = self.session.path().map_or_else(by_name, Path::to_path_buf);
        self.dialogs.ask(purpose, Some(&near));
    }

    /// Copies the shader as it is exported: with values folded into it.
    fn copy_wgsl(&mut self, ui: &Ui) {
        let shader = self.session.compilation().baked().map(|shader| shader.wgsl.clone());
        let told = match shader {
            Some(wgsl) => {
                ui.ctx().copy_text(wgsl);
                tr!("The shader is in the clipboard, as WGSL")
            }
            None => tr!("There is no shader to copy until the look compiles: Problems tells why"),
        };
        self.message = Some(told.to_owned());
    }

    /// Gives up a drag on the picture on Esc, before that key does anything else: the view and the
    /// look are as they were.
    pub(super) fn give_up_drag(&mut self, ui: &Ui) {
        if self.bench.viewport.is_dragging()
            && keyboard::take(ui, (egui::Modifiers::NONE, egui::Key::Escape))
            && self.give_up_view()
        {
            self.session.undo();
        }
    }

    /// Puts camera and lights back to where they were when the drag began. Returns true if the last
    /// step of the look is the drag's, and must be undone too.
    fn give_up_view(&mut self) -> bool {
        let Some((view, is_edited)) = self.bench.viewport.give_up(&self.session) else {
            return false;
        };
        self.session.view.orbit = view;
        is_edited
    }

    /// Makes an edit, and shows the problem as a message where it is impossible.
    pub(super) fn tell(&mut self, edit: impl FnOnce(&mut Session) -> Result<(), Box<Diagnostic>>) {
        self.attempt(edit);
    }

    /// Makes an edit as [`tell`](Self::tell) does, and returns what comes of it; `None` where it is
    /// impossible.
    pub(super) fn attempt<T>(
        &mut self,
        edit: impl FnOnce(&mut Session) -> Result<T, Box<Diagnostic>>,
    ) -> Option<T> {
        match edit(&mut self.session) {
            Ok(made) => Some(made),
            Err(problem) => {
                self.message = Some(problem.message);
                // What no shot says is changed in its own file.
                self.refused = problem.place.file.map(PathBuf::from);
                None
            }
        }
    }

    /// Saves everything that changed: the painting, the look, and the scene around it. Asks for a
    /// file where a document has none.
    pub(super) fn save(&mut self) {
        let Some(did_paint) = self.save_painting_first() else {
            return;
        };
        if self.session.shot().is_some() {
            // Look and scene are what the shot makes of their files, which stay.
            return self.save_scene();
        }
        let is_scene_dirty = self.session.open_scene().is_some_and(OpenScene::is_dirty);
        let saves_look = self.session.is_look_dirty() || !is_scene_dirty && !did_paint;
        if saves_look {
            let Some(path) = self.session.path().map(Path::to_path_buf) else {
                return self.ask_where_to_save(FilePurpose::Save);
            };
            if !self.save_as(&path) {
                return;
            }
        }
        // A scene that nobody has saved yet is only asked about if it is the one to save.
        let has_file =
            self.session.open_scene().is_some_and(|open_scene| open_scene.path().is_some());
        let is_wanted = match self.pending {
            None => !saves_look,
            Some(PendingAction::Switch(_)) => false,
            Some(_) => true,
        };
        if is_scene_dirty && (has_file || is_wanted) {
            return self.save_scene();
        }
        self.go_on_if_safe();
    }
}
