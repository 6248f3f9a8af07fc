//! Files that the look and the scene around it depend on, changed by other programs: their own, the
//! project's nodes, the scene's other looks, meshes and images, and the painting.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use chiaro_locale::tr;

use super::watch::{Watch, WatchedPaths};
use crate::compile::CompiledShader;
use crate::files::FileMetadata;
use crate::state::document::OnDisk;
use crate::state::painting::work::OpenPainting;
use crate::state::revision::{DocumentNumber, PictureRevision};
use crate::state::scene::OpenScene;
use crate::state::session::{NodeFiles, Session};
use crate::state::shot::OpenShot;

/// Pause after a change before files are read, since the writer may not be done; in seconds.
const CALM: f64 = 0.15;

/// Conflict with another program's change of the look's own file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Conflict {
    /// Both sides have changed the file; the text is theirs.
    Changed(String),
    /// Another program wrote a text that cannot be read without an error.
    Broken(String),
    /// The file was removed or moved away.
    Gone,
}

/// Conflict with another program's change of the painting's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PaintingConflict {
    /// Both sides have changed the file.
    Changed,
    /// Another program wrote a file that cannot be read.
    Broken,
    /// The file was removed or moved away.
    Gone,
}

/// State of the session that decides which files are watched.
#[derive(Clone, Default)]
struct WatchKey {
    document: DocumentNumber,
    path: Option<PathBuf>,
    mesh: String,
    scene: Option<PictureRevision>,
    shader: Option<Arc<CompiledShader>>,
    painting: Option<PathBuf>,
}

impl WatchKey {
    fn is(&self, session: &Session) -> bool {
        let same_shader = match (&self.shader, session.compilation().baked()) {
            (Some(old), Some(new)) => Arc::ptr_eq(old, new),
            (None, None) => true,
            _ => false,
        };
        same_shader
            && self.document == session.revisions().document
            && self.path.as_deref() == session.path()
            && self.mesh == session.view.orbit.mesh
            && self.scene == session.scene_revision()
            && self.painting.as_deref() == session.painting().and_then(OpenPainting::path)
    }
}

/// Watch over the files of a session.
pub(crate) struct DiskState {
    watch: Watch,
    key: WatchKey,
    is_new: bool,
    look: Option<PathBuf>,
    /// Files of the project's nodes that the watch was told of last.
    project_nodes: Arc<NodeFiles>,
    assets: BTreeMap<PathBuf, Option<FileMetadata>>,
    /// Time of the next check, in seconds of the window's clock.
    due: Option<f64>,
    /// Conflict of the look's file, for the user to decide.
    pub(crate) conflict: Option<Conflict>,
    /// Another program's text of the scene's file, while the scene has changes here too.
    pub(crate) scene_conflict: Option<String>,
    /// True if the scene's file was found broken: its problems stay until it is whole again.
    is_scene_broken: bool,
    /// Conflict of the painting's file.
    pub(crate) painting_conflict: Option<PaintingConflict>,
    /// True if the look's file existed, and the user has not yet read the note that it is gone.
    was_there: bool,
}

impl DiskState {
    /// Creates the watch. `wake` is called from another thread when files may have changed.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        Self {
            watch: Watch::new(wake),
            key: WatchKey::default(),
            is_new: true,
            look: None,
            project_nodes: Arc::default(),
            assets: BTreeMap::new(),
            due: None,
            conflict: None,
            scene_conflict: None,
            is_scene_broken: false,
            painting_conflict: None,
            was_there: false,
        }
    }

    /// Checks files when it is time to. Returns a message, and the time until the next call.
    pub(crate) fn tick(
        &mut self,
        session: &mut Session,
        now: f64,
        came_back: bool,
    ) -> (Option<String>, Option<Duration>) {
        let (told, again) = self.look_at_files(session, now, came_back);
        let has_changed = std::mem::take(&mut session.project.has_changed);
        let of_nodes =
            || has_changed.then(|| tr!("The project's nodes were loaded again").to_owned());
        (told.or_else(of_nodes), again)
    }

    fn look_at_files(
        &mut self,
        session: &mut Session,
        now: f64,
        came_back: bool,
    ) -> (Option<String>, Option<Duration>) {
        if (self.is_new || !self.key.is(session)) && self.watch_files_of(session) {
            // Recovered work may be older than its file.
            self.due = Some(now);
        }
        if !Arc::ptr_eq(&self.project_nodes, &session.project.files) {
            self.project_nodes = session.project.files.clone();
            // A new folder is watched from now on, and may have changed since the nodes were read.
            self.watch.renew(absolute(&self.project_nodes.folders));
            self.due.get_or_insert(now + CALM);
        }
        if self.watch.take() {
            self.due = Some(now + CALM);
        }
        if came_back {
            self.due = Some(now);
        }
        match self.due {
            // A stroke is finished first.
            Some(_) if session.painting().is_some_and(OpenPainting::is_live) => {
                (None, Some(Duration::from_secs_f64(CALM)))
            }
            Some(due) if now >= due => {
                self.due = None;
                (self.check(session), None)
            }
            Some(due) => (None, Some(Duration::from_secs_f64((due - now).max(0.01)))),
            None => (None, None),
        }
    }

    /// Updates the set of watched files. Returns true if they belong to another look.
    fn watch_files_of(&mut self, session: &Session) -> bool {
        let is_other = self.is_new
            || self.key.document != session.revisions().document
            || self.key.path.as_deref() != session.path();
        self.is_new = false;
        self.key = WatchKey {
            document: session.revisions().document,
            path: session.path().map(Path::to_path_buf),
            mesh: session.view.orbit.mesh.clone(),
            scene: session.scene_revision(),
            shader: session.compilation().baked().cloned(),
            painting: session.painting().and_then(OpenPainting::path).map(Path::to_path_buf),
        };
        if is_other {
            self.conflict = None;
            self.is_scene_broken = false;
            self.look = session.path().and_then(|path| std::path::absolute(path).ok());
            self.was_there = self.look.as_ref().is_some_and(|path| path.exists());
        }
        let paths = session.named_files().into_iter();
        let paths = paths.filter_map(|path| std::path::absolute(path).ok());
        let known = std::mem::take(&mut self.assets);
        let disk = session.assets.source();
        let state =
            |path: &PathBuf| known.get(path).copied().unwrap_or_else(|| disk.metadata(path));
        self.assets = paths.map(|path| (path.clone(), state(&path))).collect();
        let links = self.look.iter().filter_map(|path| path.canonicalize().ok());
        let of_shot = session.shot().map(OpenShot::path);
        let scene = session.open_scene().and_then(|open_scene| open_scene.path());
        let scene = of_shot.or(scene).and_then(|path| std::path::absolute(path).ok());
        let painting = self.key.painting.clone();
        let files = self.assets.keys().cloned().chain(self.look.clone());
        let files = files.chain(links).chain(scene).chain(painting).collect();
        let folders = absolute(&session.node_folders());
        let below = absolute(&session.project.files.folders);
        self.watch.set(WatchedPaths { files, folders, below });
        is_other
    }

    /// Dismisses the note that the file is gone.
    pub(crate) fn forget_gone(&mut self) {
        if self.conflict == Some(Conflict::Gone) {
            self.conflict = None;
            self.was_there = false;
        }
    }

    /// Checks all files. Returns a message.
    pub(crate) fn check(&mut self, session: &mut Session) -> Option<String> {
        let mut told = self.check_look(session).or_else(|| self.check_scene(session));
        let of_painting = self.check_painting(session);
        told = told.or(of_painting);
        session.check_nodes();
        let mut changed = None;
        for (path, old) in &mut self.assets {
            let new = session.assets.source().metadata(path);
            if *old != new {
                *old = new;
                // What the window wrote itself is drawn already.
                if session.pictures.is_own(path, new) {
                    continue;
                }
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                changed = Some(match new {
                    Some(_) => tr!("{name} was loaded again"),
                    None => tr!("{name} is not there any more"),
                });
            }
        }
        if let Some(text) = changed {
            session.files_changed();
            told = told.or(Some(text));
        }
        told
    }

    fn check_scene(&mut self, session: &mut Session) -> Option<String> {
        let text = match session.open_scene().map(OpenScene::on_disk) {
            Some(OnDisk::Changed(text)) => text,
            state => {
                if state == Some(OnDisk::Same) && std::mem::take(&mut self.is_scene_broken) {
                    session.scene_is_whole();
                }
                self.scene_conflict = None;
                return None;
            }
        };
        if session.open_scene().is_some_and(OpenScene::is_dirty) {
            self.scene_conflict = Some(text);
            return None;
        }
        let name = session.open_scene().map(OpenScene::name_of_changed).unwrap_or_default();
        // A scene that cannot be read yet is reported among the problems, and checked again when
        // the file changes.
        self.is_scene_broken = !session.reload_scene(&text);
        (!self.is_scene_broken)
            .then(|| tr!("{name} was changed by another program and loaded again"))
    }

    fn check_painting(&mut self, session: &mut Session) -> Option<String> {
        let work = session.painting()?;
        let name = work.name();
        let mut told = None;
        self.painting_conflict = match work.on_disk() {
            OnDisk::Same | OnDisk::Unreadable => None,
            OnDisk::Gone => Some(PaintingConflict::Gone),
            OnDisk::Changed(()) if work.is_dirty() => Some(PaintingConflict::Changed),
            OnDisk::Changed(()) => match session.reload_painting() {
                Ok(is_other) => {
                    told = is_other
                        .then(|| tr!("{name} was changed by another program and loaded again"));
                    None
                }
                Err(_) => Some(PaintingConflict::Broken),
            },
        };
        told
    }

    fn check_look(&mut self, session: &mut Session) -> Option<String> {
        match session.look.on_disk() {
            OnDisk::Same => {
                self.was_there |= self.look.is_some();
                if let Some(Conflict::Broken(_)) = self.conflict.take() {
                    session.look.load_problems.clear();
                }
                None
            }
            OnDisk::Gone => {
                self.conflict = self.was_there.then_some(Conflict::Gone);
                None
            }
            OnDisk::Unreadable => None,
            OnDisk::Changed(text) if session.is_look_dirty() => {
                self.conflict = Some(Conflict::Changed(text));
                None
            }
            OnDisk::Changed(text) => {
                if !session.reload(&text) {
                    self.conflict = Some(Conflict::Broken(text));
                    return None;
                }
                self.conflict = None;
                let name = self
                    .look
                    .as_ref()
                    .and_then(|path| path.file_name())
                    .map(|name| name.to_string_lossy());
                Some(tr!(
                    "{name} was changed by another program and loaded again",
                    name = name.unwrap_or_default()
                ))
            }
        }
    }
}

/// The paths from the root of the disk, as the system's notes have them.
fn absolute<'p, P: FromIterator<PathBuf>>(paths: impl IntoIterator<Item = &'p PathBuf>) -> P {
    paths.into_iter().filter_map(|path| std::path::absolute(path).ok()).collect()
}
