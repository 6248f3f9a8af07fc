//! Changes of a shot whose values are no more, such as those of an object that was renamed in the
//! scene. They stand in no list of what is changed, and stay in the shot's file until they are
//! taken back or moved to what is there now.

use std::path::{Path, PathBuf};

use super::OpenShot;
use crate::diag::Diagnostic;
use crate::document::{Override, ShotEdit};
use crate::files::{Files, WalkBounds};
use crate::frame::ShotStack;
use crate::ids::ObjectId;
use crate::state::scene::{folder_of, real};

/// Bounds of the search for shots beside a scene.
const BESIDE: WalkBounds = WalkBounds { depth: 0, entries: 400 };
/// Largest file that is looked at for a shot, in bytes.
const LARGEST: u64 = 1 << 20;

/// A change of a value that is not there.
pub(crate) struct LostChange<'s> {
    pub(crate) change: &'s Override,
    /// The reason, as a sentence without its end.
    pub(crate) why: &'s str,
}

impl LostChange<'_> {
    /// The object that the value was of, where it was one of the scene.
    pub(crate) fn object(&self) -> Option<&str> {
        object_of(self.change)
    }

    /// The edit that takes the change out of the shot.
    pub(crate) fn taken_back(&self) -> ShotEdit {
        ShotEdit::take_back(self.change.look.clone(), self.change.target.clone())
    }
}

/// The object of a value of the scene.
fn object_of(change: &Override) -> Option<&str> {
    let of_object = change.target.strip_prefix("objects.").filter(|_| change.look.is_none())?;
    Some(of_object.split_once('.')?.0)
}

impl OpenShot {
    /// The shot's own changes of values that are not there, in the order of its file.
    pub(crate) fn lost_changes(&self) -> Vec<LostChange<'_>> {
        let file = self.stack.shots[0].source.file();
        let is_own = |problem: &&Diagnostic| {
            problem.is_error() && problem.place.file.as_deref() == Some(file)
        };
        let own: Vec<&Diagnostic> = self.problems.iter().filter(is_own).collect();
        let lost = |(index, change)| {
            let places = [format!("overrides[{index}].target"), format!("overrides[{index}].look")];
            let of_it = |problem: &&&Diagnostic| {
                problem.place.json_path.as_ref().is_some_and(|path| places.contains(path))
            };
            Some(LostChange { change, why: &own.iter().find(of_it)?.message })
        };
        self.shot().overrides.iter().enumerate().filter_map(lost).collect()
    }

    /// Objects of the scene that the shot changes nothing of yet, to which changes of a lost object
    /// can be moved.
    pub(crate) fn unchanged_objects(&self) -> Vec<&ObjectId> {
        let is_changed = |id: &&ObjectId| {
            self.shot().overrides.iter().any(|change| object_of(change) == Some(id.as_str()))
        };
        self.scene().objects.keys().filter(|id| !is_changed(id)).collect()
    }

    /// The edit that moves all changes of an object to another one, in their places.
    pub(crate) fn moved(&self, from: &str, to: &ObjectId) -> ShotEdit {
        let mut edits = Vec::new();
        for (index, change) in self.shot().overrides.iter().enumerate() {
            let Some(rest) = change.target.strip_prefix(&format!("objects.{from}.")) else {
                continue;
            };
            if change.look.is_some() {
                continue;
            }
            let target = format!("objects.{to}.{rest}");
            let new = Override { target: target.clone(), ..change.clone() };
            edits.push(ShotEdit::take_back(None, change.target.clone()));
            edits.push(ShotEdit::SetOverride {
                look: None,
                target,
                change: Some(Box::new(new)),
                index: Some(index),
            });
        }
        ShotEdit::Group { edits }
    }
}

/// Files of shots in the folder of a scene that lie over it and change values of an object.
pub(crate) fn shots_that_change(files: &dyn Files, scene: &Path, object: &str) -> Vec<PathBuf> {
    let is_small = |path: &Path| {
        path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"))
            && files.metadata(path).is_some_and(|file| file.length <= LARGEST)
    };
    let own = real(scene);
    let changes_it = |path: &PathBuf| {
        if !is_small(path) || real(path) == own {
            return false;
        }
        let Some(Ok(stack)) = ShotStack::load(files, path) else { return false };
        let shot = stack.value.shots.first();
        real(&stack.value.scene_path) == own
            && shot.is_some_and(|file| {
                file.shot.overrides.iter().any(|change| object_of(change) == Some(object))
            })
    };
    let found = files.walk(&folder_of(scene), BESIDE, &|_| false).files;
    let mut found: Vec<PathBuf> = found.into_iter().filter(changes_it).collect();
    found.sort_unstable();
    found
}
