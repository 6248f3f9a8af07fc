//! Shot over the open scene. While a shot is open, the look and the scene of the window are what
//! the shot makes of their files at the present time, and have no past of their own: an edit of
//! either is told in values (`writing`), which are overrides of the shot's document. That one alone
//! is edited, journaled, undone and saved; the files under it stay as they are.

mod camera_keys;
mod lost;
mod writing;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;
use serde_json::json;

use crate::diag::Diagnostic;
use crate::document::{
    Camera, Document, FrameRate, History, LoadedDocument, Look, Override, Scene, Shot, ShotEdit,
    ShotKey, SourceMap, TimeRange, value_address,
};
use crate::examples;
use crate::files::journal::{DocumentInfo, JournalSlot, RecoveredWork};
use crate::files::{Files, write_atomic};
use crate::frame::{ResolvedShot, Setup, SetupLook, ShotResolver, ShotStack, ValueChange};
use crate::state::document::{OnDisk, OpenDocument, TextFile};
use crate::state::orbit::Orbit;
use crate::state::paths::absolute;
use crate::state::revision::StepTime;
use crate::state::scene::{folder_of, real, relative};
pub(crate) use lost::{ChangedKind, ChangedOwner, LostChange, shots_that_change};
pub(crate) use writing::ShotWriter;

/// Frames of a new shot, and the size of its pictures, in pixels.
const NEW_FRAMES: [i32; 2] = [1, 48];
const NEW_SIZE: [u32; 2] = [1920, 1080];
/// Greatest number of frames of a shot whose camera is keyed at once.
const MOST_CAMERAS: i64 = 10_000;
/// Greatest distance of a key from a place that counts as on it, in frames: times are rounded to
/// microseconds.
pub(crate) const ON_FRAME: f64 = 1e-3;
/// Name in the journal of the place from which a shot names files.
const PLACE: &str = "place";

/// The look that is open, as its file has it.
pub(crate) struct LookUnderShot {
    pub(crate) look: Look,
    pub(crate) source: Arc<SourceMap>,
    pub(crate) folder: PathBuf,
}

/// A shot over the open scene.
pub struct OpenShot {
    pub(crate) document: OpenDocument<Shot>,
    /// The shot as it was resolved last, the shots under it, and the scene.
    stack: ShotStack,
    /// The look that is open, as its file has it.
    pub(crate) look: Option<LookUnderShot>,
    /// The scene under the shot, where values that move are as before the shots.
    scene: Scene,
    resolved: Arc<ResolvedShot>,
    problems: Vec<Diagnostic>,
    /// Problems of the files under the shot: a save of the shot leaves them as they are.
    beneath: Vec<Diagnostic>,
    /// Time at which the open scene is shown, in seconds; `None` before it is shown at any.
    pub(crate) shown_at: Option<f64>,
    /// View that the shot's camera had put the window in last.
    view: Option<FollowedView>,
    /// Folder of the shot that was open when this new one was begun, near which it is saved.
    pub(crate) near: Option<PathBuf>,
}

/// Greatest angle between two turns of the lights that are the same, in radians.
const TURNED: f64 = 1e-4;

/// Part of a view that the shot's camera and lights decide: a hand that turns the view changes it.
#[derive(Clone, PartialEq)]
struct FollowedView {
    turn: [f64; 3],
    target: glam::DVec3,
    upright: glam::DQuat,
    illumination: glam::DQuat,
}

impl FollowedView {
    fn of(orbit: &Orbit) -> Self {
        Self {
            turn: [orbit.yaw, orbit.pitch, orbit.distance],
            target: orbit.target,
            upright: orbit.upright,
            illumination: orbit.illumination,
        }
    }
}

/// A look's value, or one of the scene: the look by the path of its file as changes tell it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ShotAddress {
    pub(crate) look: Option<String>,
    pub(crate) target: String,
}

impl ShotAddress {
    /// The value of a change.
    pub(crate) fn of(change: &ValueChange) -> Self {
        Self { look: change.look.clone(), target: change.target.clone() }
    }

    /// False for what is read once for all frames, and so has no keys: meshes, whether they are
    /// fitted, and which looks objects wear.
    pub(crate) fn can_move(&self) -> bool {
        let of_object = self.target.strip_prefix("objects.").filter(|_| self.look.is_none());
        let field = of_object.and_then(|rest| rest.split_once('.')).map_or("", |(_, field)| field);
        let first = field.split('.').next().unwrap_or_default();
        !["mesh", "looks"].contains(&first) && field != "transform.fit"
    }

    /// The address in words.
    pub(crate) fn text(&self) -> String {
        value_address(self.look.as_deref(), &self.target)
    }
}

impl OpenShot {
    /// The shot that was read from a file, with all that lies under it, and its scene. An example
    /// is a shot that no file holds yet.
    ///
    /// # Errors
    /// Problems that keep the shot, or what it changes, from being read.
    pub(crate) fn opened(
        files: &dyn Files,
        path: &Path,
        loaded: LoadedDocument<Shot>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let file = TextFile::new(loaded.source.clone());
        let own = loaded.diagnostics.len();
        let example = examples::canonical(path);
        let path = example.as_deref().unwrap_or(path);
        let (stack, mut problems) = ShotStack::over(files, path, loaded)?.into_parts();
        let history = History::new(stack.shots[0].shot.clone());
        let mut shot = Self::with(history, file, path, stack);
        if example.is_some() {
            shot.document.path = None;
        }
        shot.beneath = problems.split_off(own);
        shot.document.load_problems = problems;
        Ok(shot)
    }

    /// A new shot over a scene, or over another shot, in which nothing is changed. The shot has no
    /// file yet, and names files as if it lay beside what is under it.
    ///
    /// # Errors
    /// Problems that keep what lies under the shot from being read.
    pub(crate) fn begun(files: &dyn Files, beneath: &Path) -> Result<Self, Vec<Diagnostic>> {
        let place = free_place(beneath);
        let scene = file_name(&beneath.to_string_lossy()).to_string_lossy().into_owned();
        let mut shot = Shot { scene, ..Shot::default() };
        if let Document::Scene(LoadedDocument { value: Some(scene), .. }) =
            Document::load(files, beneath)
        {
            shot.size = Some(NEW_SIZE);
            // A scene that says when it begins and ends is shot from then to then.
            if scene.time == TimeRange::default() {
                (shot.frames, shot.rate) = (Some(NEW_FRAMES), Some(FrameRate::FILM));
            }
        }
        let loaded = Shot::read(&shot.to_text(), &place.display().to_string());
        let mut shot = Self::opened(files, &place, loaded)?;
        shot.document.path = None;
        Ok(shot)
    }

    /// The shot that a journal gave.
    ///
    /// # Errors
    /// Problems that keep what it changes from being read.
    pub(crate) fn taken_back(
        files: &dyn Files,
        found: RecoveredWork<Shot>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let own = found.about.path.clone();
        let place = || found.about.window.get(PLACE)?.as_str().map(str::to_owned);
        let path = PathBuf::from(own.clone().or_else(place).unwrap_or_default());
        let text = found.source.as_deref().unwrap_or("{}");
        let loaded = Shot::read(text, &path.display().to_string());
        let file = TextFile::new(loaded.source.clone());
        let own_problems = loaded.diagnostics.len();
        let (stack, mut problems) = ShotStack::over(files, &path, loaded)?.into_parts();
        let mut shot = Self::with(found.history, file, &path, stack);
        shot.document.path = own.map(PathBuf::from);
        shot.document.is_partial = found.about.is_partial;
        shot.beneath = problems.split_off(own_problems);
        shot.document.load_problems = [found.damage, problems].concat();
        Ok(shot)
    }

    fn with(history: History<Shot>, file: TextFile, path: &Path, mut stack: ShotStack) -> Self {
        stack.shots[0].shot = history.document().clone();
        let resolver = ShotResolver::new(&stack);
        let scene = resolver.scene().clone();
        let (resolved, problems) = resolver.finish().into_parts();
        Self {
            document: OpenDocument::new(history, Some(path.to_owned()), file),
            scene,
            resolved: Arc::new(resolved),
            problems,
            beneath: Vec::new(),
            stack,
            look: None,
            shown_at: None,
            view: None,
            near: None,
        }
    }

    /// The shot document.
    pub fn shot(&self) -> &Shot {
        self.document.document()
    }

    /// File of the shot; of one that is not saved yet, the place from which it names files.
    pub fn path(&self) -> &Path {
        self.document.path.as_deref().unwrap_or(&self.stack.shots[0].path)
    }

    /// True if the shot has been saved, or was opened.
    pub fn has_file(&self) -> bool {
        self.document.path.is_some()
    }

    /// Display name of the shot: its file's.
    pub(crate) fn name(&self) -> String {
        if !self.has_file() {
            return tr!("New shot").to_owned();
        }
        let name = self.path().file_name();
        name.map_or_else(|| tr!("Shot").to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// True if there are changes that no file holds.
    pub fn is_dirty(&self) -> bool {
        self.document.is_dirty()
    }

    /// The shots and the scene under them.
    pub(crate) fn stack(&self) -> &ShotStack {
        &self.stack
    }

    /// Changes by the shots.
    pub fn resolved(&self) -> &Arc<ResolvedShot> {
        &self.resolved
    }

    /// The scene under the shot; values that move are as before the shots.
    pub(crate) fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Frames per second.
    pub(crate) fn rate(&self) -> FrameRate {
        self.stack.rate()
    }

    /// The frame that is shown at a time, in seconds.
    pub(crate) fn frame_at(&self, time: f64) -> i32 {
        self.rate().frame_at(time)
    }

    /// Problems of the shots' files, and of overrides that could not be put in.
    pub(crate) fn problems(&self) -> impl Iterator<Item = &Diagnostic> {
        self.document.load_problems.iter().chain(&self.beneath).chain(&self.problems)
    }

    /// Files under the shot, and that of the open look: what is read anew where they change.
    pub(crate) fn files_under(&self) -> Vec<PathBuf> {
        let shots = self.stack.shots.iter().skip(1).map(|file| file.path.clone());
        let look = self.look.as_ref().map(|look| PathBuf::from(look.source.file()));
        shots.chain([self.stack.scene_path.clone()]).chain(look).collect()
    }

    /// Name in the list of changes of the open look.
    pub(crate) fn open_look(&self) -> Option<String> {
        let look = self.look.as_ref()?;
        Some(ResolvedShot::name_of_look(Path::new(look.source.file())))
    }

    /// The override of a value that this shot itself has.
    pub(crate) fn own(&self, at: &ShotAddress) -> Option<&Override> {
        self.shot().overrides.iter().rev().find(|change| self.is_of(change, at))
    }

    /// True if an override of this shot's file is of a value.
    fn is_of(&self, change: &Override, at: &ShotAddress) -> bool {
        change.target == at.target
            && match (&change.look, &at.look) {
                (None, None) => true,
                (Some(name), Some(look)) => {
                    real(&folder_of(self.path()).join(name)) == real(Path::new(look))
                }
                _ => false,
            }
    }

    /// File of a look that the shot's file names.
    pub(crate) fn file_of_look(&self, name: &str) -> PathBuf {
        real(&folder_of(self.path()).join(name))
    }

    /// Name of a look in this shot's file.
    fn name_of(&self, look: &str) -> String {
        let known = self.shot().overrides.iter().filter_map(|change| change.look.as_deref());
        let folder = folder_of(self.path());
        let file = real(Path::new(look));
        let known = known.into_iter().find(|name| real(&folder.join(name)) == file);
        known.map_or_else(
            || relative(&folder, &folder_of(Path::new(look)).join(file_name(look))),
            str::to_owned,
        )
    }

    /// Brings the scene up to date with the shot's document. The looks are found by the scene, and
    /// brought up to date by the resolver.
    pub(crate) fn resolve_scene(&mut self) -> Scene {
        let shot = &mut self.stack.shots[0];
        shot.shot = self.document.history.document().clone();
        if let Some(path) = &self.document.path {
            shot.path.clone_from(path);
        }
        shot.source = self.document.file.source.clone();
        self.scene = ShotResolver::new(&self.stack).scene().clone();
        self.scene.clone()
    }

    /// The looks of the scene as the shots change them, the open one first where it is known, and
    /// the changes with them.
    pub(crate) fn resolve_looks(
        &mut self,
        files: &dyn Files,
        others: Vec<SetupLook>,
    ) -> (Option<Look>, Vec<SetupLook>) {
        let open = self.look.as_ref().map(|under| SetupLook {
            look: under.look.clone(),
            source: under.source.clone(),
            folder: under.folder.clone(),
        });
        let has_open = open.is_some();
        let looks = open.into_iter().chain(others).collect();
        let mut resolver = ShotResolver::new(&self.stack);
        let scene = resolver.scene().clone();
        let mut setup = Setup { scene, looks, ..Setup::default() };
        resolver.change_looks(files, &mut setup);
        let (resolved, problems) = resolver.finish().into_parts();
        self.resolved = Arc::new(resolved);
        self.problems = problems;
        self.shown_at = None;
        let mut looks = setup.looks;
        let open = has_open.then(|| looks.remove(0).look);
        (open, looks)
    }

    /// Reads anew what lies under the shot. Where that cannot be read, all stays as it was, and the
    /// problems are told.
    pub(crate) fn read_again(&mut self, files: &dyn Files) {
        let text = self.shot().to_text();
        let file = self.path().display().to_string();
        let loaded = Shot::read(&text, &file);
        // What the shot's own text says stays as it was told of the file.
        let own = loaded.diagnostics.len();
        let mut problems = match ShotStack::over(files, self.path(), loaded) {
            Ok(stack) => {
                let (stack, problems) = stack.into_parts();
                self.stack = stack;
                problems
            }
            Err(problems) => problems,
        };
        self.beneath = problems.split_off(own.min(problems.len()));
        if let Some(under) = &mut self.look
            && let Document::Look(read) = Document::load(files, Path::new(under.source.file()))
            && !read.has_errors()
            && let Some(look) = read.value
        {
            (under.look, under.source) = (look, read.source.into());
        }
    }

    /// The camera of the picture at a time, in seconds, where no file has it.
    fn camera_at(&self, time: f64) -> (Camera, [f64; 4]) {
        let scene = self.resolved.scene_at(&self.scene, time);
        let shading = self.resolved.shading_time(time);
        let lights = self.resolved.scene_at(&self.scene, shading).illumination;
        (scene.camera, lights)
    }

    /// The turn of the lights that the shot has at a time, in seconds, where the window shows
    /// another one, which a hand gave it; `None` where both are the same.
    pub(crate) fn lights_turned_from(&self, orbit: &Orbit, time: f64) -> Option<glam::DQuat> {
        let is_put = |view: &FollowedView| view.illumination == orbit.illumination;
        if self.view.as_ref().is_none_or(is_put) {
            return None;
        }
        let lights = crate::state::scene::unit_rotation(self.camera_at(time).1);
        (lights.angle_between(orbit.illumination) > TURNED).then_some(lights)
    }

    /// Puts the window's lights where the shot has them at a time, in seconds; the camera stays.
    pub(crate) fn put_lights(&mut self, orbit: &mut Orbit, time: f64) {
        let lights = crate::state::scene::unit_rotation(self.camera_at(time).1);
        if let Some(view) = &mut self.view {
            (orbit.illumination, view.illumination) = (lights, lights);
        }
    }

    /// True if the window looks from where the shot's camera has put it, whatever its lights do.
    pub(crate) fn is_camera_followed(&self, orbit: &Orbit) -> bool {
        self.view.as_ref().is_some_and(|view| {
            *view == FollowedView { illumination: view.illumination, ..FollowedView::of(orbit) }
        })
    }

    /// True if the window looks from where the shot's camera has put it, with the shot's lights.
    pub(crate) fn is_followed(&self, orbit: &Orbit) -> bool {
        self.view.as_ref().is_some_and(|view| *view == FollowedView::of(orbit))
    }

    /// Puts the window's view where the shot's camera is at a time, in seconds. `of_file` is the
    /// camera that a file brings, if it does.
    pub(crate) fn look_from_camera(
        &mut self,
        orbit: &mut Orbit,
        time: f64,
        of_file: Option<Camera>,
    ) {
        let (camera, lights) = self.camera_at(time);
        orbit.look_from(&of_file.unwrap_or(camera));
        orbit.illumination = crate::state::scene::unit_rotation(lights);
        self.view = Some(FollowedView::of(orbit));
    }

    /// The edit that keys a camera over all frames, by the cameras of times in seconds; `None` for
    /// more frames than anybody edits.
    pub(crate) fn keyed_camera(&self, camera_at: impl Fn(f64) -> Camera) -> Option<ShotEdit> {
        let [first, last] = self.stack.frames();
        let count = i64::from(last) - i64::from(first);
        let rate = self.rate();
        let frames = (count < MOST_CAMERAS).then_some(first..=last)?;
        let cameras: Vec<Camera> = frames.map(|frame| camera_at(rate.time(frame))).collect();
        let changes = camera_keys::camera_overrides(first, &cameras);
        Some(ShotEdit::Group { edits: changes.into_iter().map(ShotEdit::set_override).collect() })
    }

    /// True if the shots place the camera themselves, over the one of a file.
    pub(crate) fn places_camera(&self) -> bool {
        let is_changed = |target| self.resolved.change_of(None, target).is_some();
        is_changed("camera.eye") && is_changed("camera.target")
    }

    /// Compares the shot's file with its text when it was last read or written.
    pub(crate) fn on_disk(&self) -> OnDisk {
        self.document.on_disk()
    }

    /// Takes another program's version of the file, as one step that can be undone. Returns true if
    /// it could be read without an error.
    pub(crate) fn reload(&mut self, text: &str, now: StepTime) -> bool {
        let loaded = Shot::read(text, &self.path().display().to_string());
        let has_errors = loaded.has_errors();
        self.document.load_problems = loaded.diagnostics;
        let Some(shot) = loaded.value.filter(|_| !has_errors) else { return false };
        if shot.to_text() != self.shot().to_text() {
            let edit = ShotEdit::Replace { shot: Box::new(shot) };
            if let Err(problem) = self.document.apply(edit, None, now) {
                self.document.load_problems.push(*problem);
                return false;
            }
        }
        self.document.was_reloaded(loaded.source);
        self.begin_journal(None);
        true
    }

    /// Saves to a file, which is the shot's own from then on.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub(crate) fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let is_own = self.document.check_saving(path)?;
        let (from, to) = (folder_of(self.path()), folder_of(path));
        let mut shot = self.shot().clone();
        if from != to {
            // Another folder has other ways to the same files.
            let name =
                |name: &str| relative(&to, &folder_of(&from.join(name)).join(file_name(name)));
            shot.scene = name(&shot.scene);
            for look in shot.overrides.iter_mut().filter_map(|change| change.look.as_mut()) {
                *look = name(look);
            }
        }
        let text = if is_own { self.document.text_of(&shot) } else { shot.to_text() };
        write_atomic(path, text.as_bytes())?;
        if shot != *self.shot() {
            self.document.history.amend(shot, |_| {});
        }
        self.document.text_was_written(path, &text);
        if self.document.saved() {
            self.begin_journal(None);
        }
        Ok(())
    }

    /// Hands the edits since the last call to the journal.
    pub(crate) fn commit(&mut self, goes_on: bool) {
        if self.document.commit(goes_on) {
            self.begin_journal(None);
        }
    }

    /// Begins the journal with the present shot.
    pub(crate) fn begin_journal(&mut self, slot: Option<JournalSlot>) {
        if !self.document.journal.is_on() {
            return self.document.journal.clear();
        }
        let text = |path: PathBuf| path.to_str().map(str::to_owned);
        let look = self.look.as_ref().map(|look| absolute(Path::new(look.source.file())));
        let about = DocumentInfo {
            name: self.name(),
            path: self.document.path.as_deref().map(absolute).and_then(text),
            is_partial: self.document.is_partial,
            window: json!({
                "look": look.and_then(text),
                PLACE: text(absolute(self.path())),
            }),
        };
        let source = Some(self.document.file.source.text().clone());
        self.document.begin_journal(about, source, slot);
    }
}

/// Index of the key at a frame, or a place between two.
pub(crate) fn key_at(keys: &[ShotKey], frame: f64) -> Option<usize> {
    keys.iter().position(|key| (key.frame - frame).abs() < ON_FRAME)
}

/// A place beside a file where no file is.
fn free_place(beside: &Path) -> PathBuf {
    let name = |number: usize| match number {
        1 => "shot.json".to_owned(),
        number => format!("shot-{number}.json"),
    };
    let places = (1..1000).map(|number| beside.with_file_name(name(number)));
    let mut free = places.filter(|place| !place.exists());
    free.next().unwrap_or_else(|| beside.with_file_name(name(1)))
}

fn file_name(path: &str) -> PathBuf {
    Path::new(path).file_name().map(PathBuf::from).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_read_once_has_no_keys() {
        let can_move =
            |target: &str| ShotAddress { look: None, target: target.to_owned() }.can_move();
        for fixed in ["mesh", "looks", "looks.*", "looks.cap", "transform.fit"] {
            assert!(!can_move(&format!("objects.hob.{fixed}")), "{fixed}");
        }
        for moving in ["objects.hob.transform.rotate", "objects.mesh.visible", "backdrop"] {
            assert!(can_move(moving), "{moving}");
        }
    }
}
