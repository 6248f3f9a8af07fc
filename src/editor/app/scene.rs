//! Commands about the scene around the look.

use std::path::{Path, PathBuf};

use chiaro_locale::tr;
use eframe::egui::Ui;

use super::App;
use super::files::PendingAction;
use crate::app::look_export::stem_of;
use crate::commands::{Command, FilePurpose, PanelId, SceneCommand, ShotCommand};
use crate::diag::Diagnostic;
use crate::document::SceneEdit;
use crate::examples;
use crate::frame::{ANY_MATERIAL, SHAPE_PREFIX, look_of};
use crate::ids::{NodePath, ObjectId, make_slug};
use crate::state::parts::pictures::MovedPictures;
use crate::state::paths::tidy;
use crate::state::scene::{OPEN_LOOK, OpenScene};
use crate::state::session::Session;
use crate::state::session::saving::OwnFiles;
use crate::state::shot::{OpenShot, ShotAddress, shots_that_change};
use crate::widgets::spots::{self, Spot};

impl App {
    pub(super) fn apply_scene_command(&mut self, ui: &Ui, command: SceneCommand) {
        match command {
            SceneCommand::Edit(edit) => self.tell(|session| session.apply_to_scene(edit, None)),
            SceneCommand::EditHeld(widget, edit) => {
                let gesture = self.gesture(ui, widget);
                self.tell(|session| session.apply_to_scene(edit, Some(gesture)));
            }
            SceneCommand::Make(id, edit) => self.make(id, edit),
            SceneCommand::Pick(id, material) => self.pick(id, material.as_deref()),
            SceneCommand::Unselect => self.session.select_object(None),
            SceneCommand::Add(Some(mesh)) => self.add_object(&mesh),
            SceneCommand::Add(None) => {
                self.dialogs.ask(FilePurpose::AddMesh, self.near_scene().as_deref());
            }
            SceneCommand::Ask(purpose, id, material) => {
                if let Some(open_scene) = self.session.open_scene_mut() {
                    open_scene.asked = Some((id, material));
                }
                self.dialogs.ask(purpose, self.near_scene().as_deref());
            }
            SceneCommand::Chosen(purpose, path) => self.chosen(purpose, &path),
            SceneCommand::Frame(only) => {
                self.session.frame(only.as_ref(), self.bench.viewport.aspect());
            }
            SceneCommand::Locate(placed) => {
                if let Some(open_scene) = self.session.open_scene_mut() {
                    open_scene.placed = placed;
                }
                if self.session.frame_without_camera(self.bench.viewport.aspect()) {
                    let text =
                        tr!("The scene has no camera of its own, so that the picture shows all \
                             objects; Keep this view in Objects gives it this one");
                    self.message = Some(text.to_owned());
                }
            }
            SceneCommand::KeepView => {
                let aspect = self.bench.viewport.aspect();
                self.tell(|session| session.keep_view(aspect));
            }
            SceneCommand::Save => self.save_scene(),
            SceneCommand::SaveAs => {
                self.session.begin_scene();
                self.dialogs.ask(FilePurpose::SaveScene, self.near_scene().as_deref());
            }
            SceneCommand::SaveWithFiles => {
                let purpose = FilePurpose::SaveSceneWithFiles;
                self.dialogs.ask(purpose, self.near_scene().as_deref());
            }
            SceneCommand::Close => self.do_or_ask(PendingAction::LeaveScene),
            SceneCommand::Shot(command) => self.apply_to_shot(ui, command),
        }
    }

    fn apply_to_shot(&mut self, ui: &Ui, command: ShotCommand) {
        match command {
            ShotCommand::New => self.new_shot(false),
            ShotCommand::NewOver => self.new_shot(true),
            ShotCommand::Edit(edit) => self.tell(|session| session.apply_to_shot(edit, None)),
            ShotCommand::EditHeld(widget, edit) => {
                let gesture = self.gesture(ui, widget);
                self.tell(|session| session.apply_to_shot(edit, Some(gesture)));
            }
            ShotCommand::Reset(at) => self.tell(|session| session.reset_in_shot(&at)),
            ShotCommand::Key(at) => {
                self.tell(|session| session.key_in_shot(&at));
            }
            ShotCommand::KeyAll => self.tell(Session::key_all_in_shot),
            ShotCommand::ResetAll => self.tell(Session::reset_all_in_shot),
            ShotCommand::KeyCameraOfFile => self.tell(Session::key_camera_of_file),
            ShotCommand::Show(at) => self.show_value(ui, &at),
        }
    }

    /// Begins a shot over the scene, or with `is_over_shot` over the open shot. What lies under a
    /// shot are files, so that a save is asked for first, where one lacks.
    fn new_shot(&mut self, is_over_shot: bool) {
        self.start = None;
        self.session.begin_scene();
        self.pending = Some(PendingAction::NewShot { is_over_shot });
        self.go_on_if_safe();
    }

    /// Begins a shot over the files that are open.
    pub(super) fn begin_shot(&mut self, is_over_shot: bool) {
        self.safety.put_aside(&self.session);
        let shot = self.session.shot().filter(|shot| is_over_shot && shot.has_file());
        let over = match (shot, self.session.open_scene()) {
            (Some(shot), _) => shot.name(),
            (None, Some(open_scene)) => open_scene.name(),
            (None, None) => return,
        };
        if let Err(problems) = self.session.begin_shot(is_over_shot) {
            let first = problems.into_iter().find(crate::diag::Diagnostic::is_error);
            self.message = first.map(|problem| problem.message);
            return;
        }
        let text = tr!(
            "A new shot over {over}: what you change from now on is the shot's, and {over} stays \
             as it is. Save asks for the shot's file."
        );
        self.message = Some(text);
        self.open_lacking_look();
        self.lay_out();
        self.dock.open(PanelId::SHOT);
        self.play_frames_of_shot();
        self.safety.look();
    }

    /// Brings a value that the shot changes into view.
    fn show_value(&mut self, ui: &Ui, at: &ShotAddress) {
        let mut steps = at.target.split('.');
        let (first, id) = (steps.next().unwrap_or_default(), steps.next().unwrap_or_default());
        match (&at.look, first) {
            (None, "objects") => {
                self.session.select_object(Some(ObjectId::new(id)));
                self.dock.open(PanelId::OBJECTS);
            }
            (None, "light_groups" | "muted" | "soloed") => self.dock.open(PanelId::MIXER),
            (_, "lights") => {
                self.session.choose_light(id.into());
                self.dock.open(PanelId::LIGHTS);
            }
            (None, _) => self.dock.open(PanelId::OBJECTS),
            (Some(look), _) => {
                let is_open = self.session.shot().and_then(OpenShot::open_look);
                if is_open.as_ref() != Some(look) {
                    return self.do_or_ask(PendingAction::Switch(PathBuf::from(look)));
                }
                let target = at.target.strip_prefix("nodes.").unwrap_or(&at.target);
                let node = target.rsplit_once('.').map_or(target, |(node, _)| node);
                self.dock.open(PanelId::INSPECTOR);
                self.carry_out(ui, Command::Show(NodePath::parse(node)));
            }
        }
    }

    /// Path that a dialog for a file of the scene begins near.
    pub(super) fn near_scene(&self) -> Option<PathBuf> {
        if let Some(shot) = self.session.shot() {
            if shot.has_file() {
                return Some(shot.path().to_path_buf());
            }
            let place = match shot.shot().name.as_str() {
                "" => shot.path().to_path_buf(),
                name => shot.path().with_file_name(format!("{}.json", stem_of(name))),
            };
            let file = place.file_name().unwrap_or_default();
            return Some(tidy(&shot.near.as_ref().map_or(place.clone(), |near| near.join(file))));
        }
        let own = self.session.open_scene().and_then(OpenScene::path);
        own.map(Path::to_path_buf)
            .or_else(|| Some(self.session.path()?.with_file_name("scene.json")))
            .or_else(|| Some(PathBuf::from("scene.json")))
    }

    fn chosen(&mut self, purpose: FilePurpose, path: &Path) {
        let asked = self.session.open_scene_mut().and_then(|open_scene| open_scene.asked.take());
        match (purpose, asked) {
            (FilePurpose::SaveScene | FilePurpose::SaveShot, _) => {
                self.save_scene_and_go_on(path, OwnFiles::Linked);
            }
            (FilePurpose::SaveSceneWithFiles, _) => {
                self.save_scene_and_go_on(path, OwnFiles::Copied);
            }
            (FilePurpose::AddMesh, _) => self.add_object(&path.to_string_lossy()),
            (FilePurpose::ObjectMesh, Some((id, _))) => {
                self.change_object(&id, |open_scene, object| {
                    object.mesh = open_scene.name_of(path);
                });
            }
            (FilePurpose::ObjectLook, Some((id, material))) => {
                self.change_object(&id, |open_scene, object| {
                    object.looks.insert(material, open_scene.name_of(path));
                });
            }
            _ => {}
        }
    }

    pub(super) fn change_object(
        &mut self,
        id: &ObjectId,
        change: impl FnOnce(&OpenScene, &mut crate::document::Object),
    ) {
        let open_scene = self.session.open_scene();
        let edit = open_scene
            .and_then(|open_scene| open_scene.change(id, |object| change(open_scene, object)));
        if let Some(edit) = edit {
            self.tell(|session| session.apply_to_scene(edit, None));
        }
    }

    /// Adds an object, and a scene around the look where there is none.
    fn add_object(&mut self, mesh: &str) {
        self.session.begin_scene();
        let Some(open_scene) = self.session.open_scene() else { return };
        let name = if mesh.starts_with(SHAPE_PREFIX) {
            mesh.to_owned()
        } else {
            open_scene.name_of(Path::new(mesh))
        };
        let (id, edit) = open_scene.add(&name);
        self.make(id, edit);
        self.session.frame(None, self.bench.viewport.aspect());
        self.dock.open(PanelId::OBJECTS);
    }

    fn make(&mut self, id: ObjectId, edit: SceneEdit) {
        let objects = |session: &Session| -> Vec<ObjectId> {
            let open_scene = session.open_scene();
            open_scene.map(|it| it.scene().objects.keys().cloned().collect()).unwrap_or_default()
        };
        let before = objects(&self.session);
        self.tell(|session| session.apply_to_scene(edit, None));
        let after = objects(&self.session);
        if let Some(old) = before.iter().find(|old| !after.contains(old)) {
            self.tell_shots_of(old, &id);
        }
        self.session.select_object(Some(id));
    }

    /// Tells which shots beside the scene's file change values of an object that has another name
    /// now: they name the object as it was.
    fn tell_shots_of(&mut self, old: &ObjectId, new: &ObjectId) {
        let Some(scene) = self.session.open_scene().and_then(OpenScene::path) else { return };
        let files = self.session.assets.source().clone();
        let shots = shots_that_change(&*files, scene, old.as_str());
        let names = shots.iter().filter_map(|path| path.file_name());
        let names: Vec<_> = names.map(|name| name.to_string_lossy().into_owned()).collect();
        if !names.is_empty() {
            self.message = Some(tr!(
                "{shots} still changes values of {old}: once the scene is saved, open it, and move \
                 them to {new} in the panel Shot",
                shots = names.join(", ")
            ));
        }
    }

    /// Selects an object and opens its look.
    fn pick(&mut self, id: ObjectId, material: Option<&str>) {
        let Some(object) =
            self.session.open_scene().and_then(|open_scene| open_scene.scene().objects.get(&id))
        else {
            return;
        };
        let worn = material.map_or_else(
            || object.looks.get(ANY_MATERIAL).map(String::as_str),
            |it| look_of(object, it),
        );
        let worn =
            worn.or_else(|| object.looks.values().next().map(String::as_str)).map(str::to_owned);
        // An object that wears the open look on any of its materials keeps it open, unless another
        // material was pointed at.
        let keeps = material.is_none()
            && self.session.open_scene().is_some_and(|open_scene| open_scene.wears_open(object));
        self.session.select_object(Some(id));
        if let Some(worn) = worn.filter(|_| !keeps) {
            self.open_worn(&worn);
        }
    }

    /// Opens a look of the scene, which stays.
    fn open_worn(&mut self, name: &str) {
        let Some(open_scene) =
            self.session.open_scene().filter(|open_scene| !open_scene.is_open(name))
        else {
            return;
        };
        if open_scene.wears_unsaved() && self.session.path().is_none() {
            self.message = Some(
                tr!("Save this look first: objects of the scene wear it, and it has no file yet")
                    .to_owned(),
            );
            return;
        }
        let path = open_scene.path_of(name);
        // Under a shot a look stays as it is: the shot has what is changed.
        let is_example = examples::file(&path).is_some();
        if is_example && self.session.shot().is_none() {
            let text = tr!(
                "This object wears an example: open that from the start page to change it, or \
                 choose another look"
            );
            self.message = Some(text.to_owned());
            return;
        }
        if name == OPEN_LOOK || !is_example && !path.is_file() {
            self.message = Some(tr!(
                "There is no look {file}: choose another for the object",
                file = path.display()
            ));
            return;
        }
        self.do_or_ask(PendingAction::Switch(path));
    }

    /// Puts an object on another mesh: the object under the pointer, or the selected one, or one
    /// that wears the open look.
    pub(super) fn mesh_of_object(&mut self, mesh: &str) {
        let Some(open_scene) = self.session.open_scene() else { return };
        let objects = &open_scene.scene().objects;
        let under = self.bench.viewport.hovered().filter(|id| objects.contains_key(*id));
        let Some(id) = under.or_else(|| open_scene.selected_or_worn()).cloned() else {
            self.message = Some(
                tr!("Select the object that is to have this mesh, or hold Shift to add one")
                    .to_owned(),
            );
            return;
        };
        let mesh = mesh.to_owned();
        self.change_object(&id, |open_scene, object| {
            object.mesh = if mesh.starts_with(SHAPE_PREFIX) {
                mesh
            } else {
                open_scene.name_of(Path::new(&mesh))
            };
        });
    }

    /// True if a mesh that is dropped now becomes one more object.
    pub(super) fn adds_what_is_dropped(&self, ui: &Ui) -> bool {
        let at = ui.input(|input| input.pointer.latest_pos());
        let panel = spots::find(ui.ctx(), &Spot::Panel(PanelId::OBJECTS));
        let is_on_panel = panel.is_some_and(|panel| at.is_some_and(|at| panel.contains(at)));
        is_on_panel || ui.input(|input| input.modifiers.shift)
    }

    /// Saves the scene; asks for a file where there is none.
    pub(super) fn save_scene(&mut self) {
        if let Some(shot) = self.session.shot() {
            let path = shot.path().to_path_buf();
            return match shot.has_file() {
                true => self.save_scene_and_go_on(&path, OwnFiles::Linked),
                false => self.dialogs.ask(FilePurpose::SaveShot, self.near_scene().as_deref()),
            };
        }
        match self.session.open_scene().map(|open_scene| open_scene.path().map(Path::to_path_buf)) {
            Some(Some(path)) => self.save_scene_and_go_on(&path, OwnFiles::Linked),
            Some(None) => self.dialogs.ask(FilePurpose::SaveScene, self.near_scene().as_deref()),
            None => {}
        }
    }

    fn save_scene_and_go_on(&mut self, path: &Path, own: OwnFiles) {
        let Err(problem) = self.write_scene(path, own) else {
            return self.go_on_if_safe();
        };
        let purpose = match own {
            _ if self.session.shot().is_some() => FilePurpose::SaveShot,
            OwnFiles::Linked => FilePurpose::SaveScene,
            OwnFiles::Copied => FilePurpose::SaveSceneWithFiles,
        };
        self.ask_again(purpose, path, &problem);
    }

    /// Saves the scene to a file, and reports a failure. A look that objects wear and that has no
    /// file yet is saved beside the scene, which names it. Returns true if the files are written.
    pub fn save_scene_as(&mut self, path: &Path) -> bool {
        self.write_scene(path, OwnFiles::Linked).is_ok()
    }

    /// Saves the scene to a file, and reports the result with what became of the files that it
    /// names.
    ///
    /// # Errors
    /// The problem that was reported.
    fn write_scene(&mut self, path: &Path, own: OwnFiles) -> Result<(), Box<Diagnostic>> {
        let look = self.look_beside(path);
        if let Some(look) = &look {
            self.write_look(look, OwnFiles::Linked)?;
        }
        let saved = self.session.save_scene_with(path, own);
        let told = saved.as_ref().map(MovedPictures::told).unwrap_or_default();
        self.tell_saved(path, saved.map(drop))?;
        if let Some(look) = look.as_deref().and_then(Path::file_name) {
            let look = look.to_string_lossy();
            self.message =
                Some(tr!("Saved {file}, and its look {look} beside it", file = path.display()));
        }
        self.tell_besides(&told);
        Ok(())
    }

    /// File beside a scene's for the open look, where objects wear it and it has none yet.
    fn look_beside(&self, scene: &Path) -> Option<PathBuf> {
        let is_worn = self.session.open_scene().is_some_and(OpenScene::wears_unsaved);
        if !is_worn || self.session.path().is_some() {
            return None;
        }
        let file = |slug: &str| scene.with_file_name(format!("{slug}.json"));
        let is_taken = |slug: &str| file(slug) == scene || file(slug).exists();
        let name = match self.session.look().name.as_str() {
            "" => "look",
            name => name,
        };
        Some(file(&make_slug(name, is_taken)))
    }

    /// Adds an object on a mesh (a path, or `shape:` and the name of a built-in shape), like a mesh
    /// that is dropped with Shift.
    pub fn add_mesh(&mut self, mesh: &str) {
        self.add_object(mesh);
    }
}
