//! Document of the window that is rendered: a file, as it is on the disk.

use chiaro_locale::tr;

use crate::document::{FrameRate, TimeRange};
use crate::film::farm::chunk_of;
use crate::frame::{DEFAULT_MESH, SHAPE_PREFIX};
use crate::state::runs::FilmDocument;
use crate::state::session::Session;

/// Frames of a document that says none.
const FRAMES: [i32; 2] = [1, 48];

/// The open shot, or else the scene, or else the look.
///
/// # Errors
/// The reason why nothing can be rendered, as a sentence.
pub(crate) fn document_of(session: &Session) -> Result<FilmDocument, &'static str> {
    if let Some(shot) = session.shot() {
        if !shot.has_file() {
            return Err(tr!(
                "The shot is in no file yet: what is rendered are files. Save it first."
            ));
        }
        return Ok(FilmDocument {
            path: shot.path().to_path_buf(),
            frames: shot.stack().frames(),
            rate: None,
            size: shot.stack().size(),
            mesh: None,
            is_shot: true,
            chunk: Some(chunk_of(shot.stack())),
        });
    }
    if let Some(open_scene) = session.open_scene() {
        let path = open_scene.path();
        let path = path.ok_or(tr!("The scene is in no file yet. Save it first."))?;
        let time = open_scene.scene().time;
        let rate: Option<FrameRate> = format!("{}", time.fps).parse().ok();
        let of_time = |rate: FrameRate| [time.start, time.end].map(|time| rate.frame_at(time));
        let frames = rate.filter(|_| time != TimeRange::default()).map_or(FRAMES, of_time);
        return Ok(FilmDocument {
            path: path.to_path_buf(),
            frames,
            rate: rate.filter(|rate| *rate != FrameRate::FILM),
            size: None,
            mesh: None,
            is_shot: false,
            chunk: None,
        });
    }
    let path = session.path().ok_or(tr!("The look is in no file yet. Save it first."))?;
    let orbit = session.view().orbit();
    let is_default = orbit.mesh == DEFAULT_MESH && !orbit.z_is_up;
    Ok(FilmDocument {
        path: path.to_path_buf(),
        frames: FRAMES,
        rate: None,
        size: None,
        mesh: (!is_default).then(|| (from_anywhere(&orbit.mesh), orbit.z_is_up)),
        is_shot: false,
        chunk: None,
    })
}

/// Path of a mesh from any folder; the name of a built-in shape as it is.
fn from_anywhere(mesh: &str) -> String {
    let path = std::path::absolute(mesh).ok().filter(|_| !mesh.starts_with(SHAPE_PREFIX));
    path.map_or_else(|| mesh.to_owned(), |path| path.to_string_lossy().into_owned())
}

/// True if the window has changes that the files do not have.
pub(crate) fn is_unsaved(session: &Session) -> bool {
    match session.shot() {
        Some(shot) => shot.is_dirty(),
        None => session.is_dirty(),
    }
}

/// Names of passes that looks of the document have, each once.
pub(super) fn named_passes(session: &Session) -> Vec<String> {
    let others = session.open_scene().into_iter().flat_map(|scene| scene.other_looks());
    let others = others.flat_map(|worn| &worn.look.aovs);
    let mut names: Vec<String> =
        session.look().aovs.iter().chain(others).map(|aov| aov.name.to_string()).collect();
    names.sort_unstable();
    names.dedup();
    names
}
