//! Changes of a shot whose values are no more, such as those of an object that was renamed in the
//! scene. They stand in no list of what is changed, and stay in the shot's file until they are
//! taken back or moved to what is there now.

use std::path::{Path, PathBuf};

use super::OpenShot;
use crate::diag::Diagnostic;
use crate::document::{Override, ShotEdit};
use crate::files::{Files, WalkBounds};
use crate::frame::ShotStack;
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

impl<'s> LostChange<'s> {
    /// The thing that the value was of, where changes of it can be moved to another one.
    pub(crate) fn owner(&self) -> Option<ChangedOwner<'s>> {
        ChangedOwner::of(self.change)
    }

    /// The edit that takes the change out of the shot.
    pub(crate) fn taken_back(&self) -> ShotEdit {
        ShotEdit::take_back(self.change.look.clone(), self.change.target.clone())
    }
}

/// Kind of a thing whose values a shot changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ChangedKind {
    Object,
    Light,
    /// A node of a look, by its path.
    Node,
}

/// Object, light or node whose values a shot changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ChangedOwner<'s> {
    /// Name of the look in the shot's file; `None` for what the scene has.
    pub(crate) look: Option<&'s str>,
    pub(crate) kind: ChangedKind,
    pub(crate) id: &'s str,
}

impl<'s> ChangedOwner<'s> {
    /// The owner of the value that a change is of.
    fn of(change: &'s Override) -> Option<Self> {
        let (look, target) = (change.look.as_deref(), change.target.as_str());
        let in_list = |list: &str| Some(target.strip_prefix(list)?.split_once('.')?.0);
        let (kind, id) = if let Some(id) = in_list("lights.") {
            (ChangedKind::Light, id)
        } else if look.is_none() {
            (ChangedKind::Object, in_list("objects.")?)
        } else {
            let node = target.strip_prefix("nodes.").unwrap_or(target).rsplit_once('.')?.0;
            // What is within a group goes with the group.
            (ChangedKind::Node, node.split('/').next()?)
        };
        Some(Self { look, kind, id })
    }

    /// The address of one of its values as that of another thing of the same kind.
    pub(crate) fn moved(&self, target: &str, to: &str) -> Option<String> {
        let (list, rest) = match self.kind {
            ChangedKind::Object => ("objects.", target.strip_prefix("objects.")?),
            ChangedKind::Light => ("lights.", target.strip_prefix("lights.")?),
            ChangedKind::Node => match target.strip_prefix("nodes.") {
                Some(rest) => ("nodes.", rest),
                None => ("", target),
            },
        };
        let rest = rest.strip_prefix(self.id).filter(|rest| rest.starts_with(['.', '/']))?;
        Some(format!("{list}{to}{rest}"))
    }
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

    /// The shot's own changes of values of a thing.
    pub(crate) fn changes_of(&self, owner: ChangedOwner<'_>) -> impl Iterator<Item = &Override> {
        self.shot().overrides.iter().filter(move |it| ChangedOwner::of(it) == Some(owner))
    }

    /// The edit that moves all changes of a thing to another one of the same kind, in their places
    /// and with their keys.
    pub(crate) fn moved(&self, from: ChangedOwner<'_>, to: &str) -> ShotEdit {
        let mut edits = Vec::new();
        for (index, change) in self.shot().overrides.iter().enumerate() {
            let is_of_it = ChangedOwner::of(change) == Some(from);
            let Some(target) = from.moved(&change.target, to).filter(|_| is_of_it) else {
                continue;
            };
            let new = Override { target: target.clone(), ..change.clone() };
            edits.push(ShotEdit::take_back(change.look.clone(), change.target.clone()));
            edits.push(ShotEdit::SetOverride {
                look: change.look.clone(),
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
                let owner = ChangedOwner { look: None, kind: ChangedKind::Object, id: object };
                file.shot.overrides.iter().any(|it| ChangedOwner::of(it) == Some(owner))
            })
    };
    let found = files.walk(&folder_of(scene), BESIDE, &|_| false).files;
    let mut found: Vec<PathBuf> = found.into_iter().filter(changes_it).collect();
    found.sort_unstable();
    found
}
