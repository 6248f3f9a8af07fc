//! The documents of a shot: itself, the shots that it changes, and the scene under them.

use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;

use crate::diag::{Diagnostic, WithWarnings, has_errors};
use crate::document::{Document, FrameRate, LoadedDocument, Scene, Shot, SourceMap, read_text};
use crate::files::{Files, shortened};

/// Most shots that lie one over the other.
const MOST: usize = 100;

/// A shot in its file.
#[derive(Clone, Debug)]
pub struct ShotFile {
    /// Path of the file.
    pub path: PathBuf,
    /// The shot.
    pub shot: Shot,
    /// Places of the shot's values in its file.
    pub source: Arc<SourceMap>,
}

/// Shots over a scene.
#[derive(Clone, Debug)]
pub struct ShotStack {
    /// The shot and the shots that it changes, the nearest first.
    pub shots: Vec<ShotFile>,
    /// Path of the scene's file.
    pub scene_path: PathBuf,
    /// The scene as its file has it.
    pub scene: Scene,
    /// Places of the scene's values in its file.
    pub scene_source: Arc<SourceMap>,
}

impl ShotStack {
    /// Reads a shot and what it changes; `None` where the file is no shot.
    ///
    /// # Errors
    /// All errors of the files, a file that is not there, and shots that change one another.
    pub fn load(
        files: &dyn Files,
        path: &Path,
    ) -> Option<Result<WithWarnings<Self>, Vec<Diagnostic>>> {
        match Document::load(files, path) {
            Document::Shot(loaded) => Some(Self::over(files, path, loaded)),
            Document::Look(_) | Document::Scene(_) => None,
        }
    }

    /// Reads what a shot changes.
    ///
    /// # Errors
    /// As [`load`](Self::load).
    pub fn over(
        files: &dyn Files,
        path: &Path,
        loaded: LoadedDocument<Shot>,
    ) -> Result<WithWarnings<Self>, Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let mut shots: Vec<ShotFile> = Vec::new();
        let (mut path, mut loaded) = (path.to_path_buf(), loaded);
        loop {
            problems.append(&mut loaded.diagnostics);
            let Some(shot) = loaded.value.filter(|_| !has_errors(&problems)) else {
                return Err(problems);
            };
            let next = folder(&path).join(&shot.scene);
            shots.push(ShotFile { path, shot, source: loaded.source.into() });
            let last = &shots[shots.len() - 1];
            if !files.has_file(&next) {
                let message = tr!("there is no file `{file}`", file = next.display());
                let problem = Diagnostic::error("missing-asset", message)
                    .hint(tr!("paths of scenes are relative to the shot's own file"));
                problems.push(located(last, problem, "scene"));
                return Err(problems);
            }
            let names = |other: &ShotFile| is_same_file(files, &other.path, &next);
            if let Some(around) = shots.iter().position(names) {
                let circle = shots[around..].iter().map(|shot| shot.path.display().to_string());
                let circle: Vec<String> = circle.collect();
                let message = tr!("shots change one another: {paths}", paths = circle.join(", "));
                let problem = Diagnostic::error("cycle", message)
                    .hint(tr!("let one of them name a scene in `scene`"));
                problems.push(located(last, problem, "scene"));
                return Err(problems);
            }
            if shots.len() >= MOST {
                let message = tr!("more than {MOST} shots lie one over the other");
                let problem = Diagnostic::error("too-many", message);
                problems.push(located(last, problem, "scene"));
                return Err(problems);
            }
            match Document::load(files, &next) {
                Document::Shot(further) => (path, loaded) = (next, further),
                Document::Scene(mut found) => {
                    problems.append(&mut found.diagnostics);
                    let Some(scene) = found.value.filter(|_| !has_errors(&problems)) else {
                        return Err(problems);
                    };
                    let scene_source = found.source.into();
                    let stack = Self { shots, scene_path: next, scene, scene_source };
                    return Ok(WithWarnings::new(stack, problems));
                }
                Document::Look(found) => {
                    problems.extend(found.diagnostics.into_iter().filter(Diagnostic::is_error));
                    let problem =
                        Diagnostic::error("wrong-document", tr!("a shot changes a scene")).hint(
                            tr!(
                                "`{scene}` is a look: name a scene that shows it",
                                scene = last.shot.scene
                            ),
                        );
                    problems.push(located(last, problem, "scene"));
                    return Err(problems);
                }
            }
        }
    }

    /// Folder that names in the scene are relative to.
    pub fn scene_folder(&self) -> &Path {
        folder(&self.scene_path)
    }

    /// Frames per second.
    pub fn rate(&self) -> FrameRate {
        let own = self.nearest(|shot| shot.rate);
        // Rates of television are written with three digits.
        let fps = self.scene.time.fps;
        let of_scene = || {
            let written = [format!("{fps}"), format!("{fps:.3}"), format!("{}", fps.round())];
            written.iter().find_map(|text| text.parse().ok())
        };
        own.or_else(of_scene).unwrap_or(FrameRate::FILM)
    }

    /// The first and the last frame.
    pub fn frames(&self) -> [i32; 2] {
        let rate = self.rate();
        let time = &self.scene.time;
        self.nearest(|shot| shot.frames).unwrap_or_else(|| {
            let first = rate.frame_at(time.start);
            [first, rate.frame_at(time.end).max(first)]
        })
    }

    /// Width and height of the picture, in pixels, where a shot says.
    pub fn size(&self) -> Option<[u32; 2]> {
        self.nearest(|shot| shot.size)
    }

    /// Frames for which everything that shades is held.
    pub fn step(&self) -> u32 {
        self.nearest(|shot| shot.step).unwrap_or(1)
    }

    /// Value that the nearest shot has that says one.
    fn nearest<T>(&self, of: impl Fn(&Shot) -> Option<T>) -> Option<T> {
        self.shots.iter().find_map(|file| of(&file.shot))
    }
}

/// Path of what a file that may be a shot changes: the file itself, where it is none.
pub fn scene_of(files: &dyn Files, path: &Path) -> PathBuf {
    // Looks and scenes, which may be large, are not read for this.
    let names_a_scene =
        |text: &str| text.split("\"scene\"").skip(1).any(|rest| rest.trim_start().starts_with(':'));
    let is_shot = read_text(files, path).is_ok_and(|text| names_a_scene(&text));
    let stack = is_shot.then(|| ShotStack::load(files, path)).flatten();
    match stack {
        Some(Ok(stack)) => stack.value.scene_path,
        _ => path.to_path_buf(),
    }
}

/// The folder that names in a file are relative to.
pub(super) fn folder(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

/// A problem at a place of a shot.
pub(super) fn located(file: &ShotFile, problem: Diagnostic, json_path: &str) -> Diagnostic {
    let mut problem = problem.json_path(json_path);
    file.source.locate(&mut problem);
    problem
}

/// True if two paths lead to one file.
pub(super) fn is_same_file(files: &dyn Files, one: &Path, two: &Path) -> bool {
    let of = |path: &Path| files.canonical(path).unwrap_or_else(|| shortened(path));
    of(one) == of(two)
}

/// The name of a file in a document of a folder. Examples have one name wherever they are named.
pub(super) fn named_from(folder: &Path, file: &Path) -> String {
    let text = file.display().to_string();
    if let Some(example) = text.find(crate::examples::PREFIX) {
        return text[example..].to_owned();
    }
    let (folder, file) = (shortened(folder), shortened(file));
    let (from, to): (Vec<_>, Vec<_>) = (folder.components().collect(), file.components().collect());
    let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    // From one drive to another, and out of a folder above the working folder, no way is known.
    let is_apart =
        folder.is_absolute() != file.is_absolute() || folder.is_absolute() && shared == 0;
    if is_apart || from[shared..].contains(&Component::ParentDir) {
        return file.display().to_string();
    }
    let up = from[shared..].iter().map(|_| Component::ParentDir);
    up.chain(to[shared..].iter().copied()).collect::<PathBuf>().display().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_from_the_folder_of_a_document() {
        let named = |folder: &str, file: &str| named_from(Path::new(folder), Path::new(file));
        assert_eq!(named("shots", "shots/../looks/a.json"), "../looks/a.json");
        assert_eq!(named("", "looks/a.json"), "looks/a.json");
        assert_eq!(named("/p/shots", "/p/looks/a.json"), "../looks/a.json");
        assert_eq!(named("p/shots", "q/looks/a.json"), "../../q/looks/a.json");
        assert_eq!(named("shots", "/p/looks/a.json"), "/p/looks/a.json");
        assert_eq!(named("../shots", "looks/a.json"), "looks/a.json");
        assert_eq!(named("p/shots", "p/example:looks/toon.json"), "example:looks/toon.json");
    }
}
