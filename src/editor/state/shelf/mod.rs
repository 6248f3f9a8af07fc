//! Snapshots of a look: states of it with a name, kept on a shelf beside the look's file.
//!
//! The look's own document knows nothing of them, so that exports, hashes and merges of looks are
//! as they were: they lie in `NAME.snapshots.json` beside `NAME.json` and are written whenever they
//! change. Before a look has a file, its journal has them. Taking, renaming and deleting are steps
//! in the window's one order of undo.

mod file;
mod likeness;

use std::collections::{HashMap, HashSet};
use std::path::Path;
use std::sync::Arc;

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::document::Look;
use crate::state::document::times::Times;
use crate::state::revision::StepTime;
use file::ShelfFile;
pub(crate) use file::{date_text, file_of};

/// Greatest number of snapshots of a look.
const MOST: usize = 64;
/// Greatest length of all snapshots of a look as text, in bytes; those that undo would bring back
/// may be as long again.
const MOST_BYTES: usize = 32 << 20;
/// Greatest number of steps that can be taken back.
const MOST_STEPS: usize = 64;
/// Greatest length of a name, in characters.
const MOST_NAME: usize = 80;

/// Number of a snapshot, of its own among all that the window has seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct SnapshotId(u64);

/// State of a look with a name.
#[derive(Clone, Debug)]
pub(crate) struct LookSnapshot {
    pub(crate) id: SnapshotId,
    pub(crate) name: String,
    /// Time at which it was taken, in seconds since 1970.
    pub(crate) taken: u64,
    pub(crate) look: Arc<Look>,
    /// Length of the look as text, in bytes.
    length: usize,
}

impl LookSnapshot {
    /// True if a look is as the snapshot has it, however its canvas is laid out.
    pub(crate) fn is_like(&self, look: &Look) -> bool {
        likeness::are_alike(&self.look, look)
    }

    /// True if both hold the same, whichever window read them.
    fn is(&self, other: &Self) -> bool {
        (&self.name, self.taken) == (&other.name, other.taken) && self.look == other.look
    }
}

type Snapshots = Vec<Arc<LookSnapshot>>;

/// Snapshots of the open look, with their past.
#[derive(Default)]
pub(crate) struct SnapshotShelf {
    list: Snapshots,
    /// Label of each done step, and the snapshots before it.
    done: Vec<(String, Snapshots)>,
    /// Label of each undone step, and the snapshots after it, the next to redo last.
    undone: Vec<(String, Snapshots)>,
    pub(crate) times: Times,
    last: SnapshotId,
    file: ShelfFile,
    /// Reason why the file does not hold the snapshots as they are.
    problem: Option<Diagnostic>,
}

impl SnapshotShelf {
    /// Shelf of the look in a file, after that of the look before it.
    pub(crate) fn beside(look: Option<&Path>, before: &Self) -> Self {
        let mut shelf = Self { last: before.last, ..Self::default() };
        if let Some(look) = look {
            let (read, problem) = ShelfFile::read(&file_of(look), &mut shelf.last);
            (shelf.list, shelf.file) = read;
            shelf.problem = problem;
        }
        shelf
    }

    /// All snapshots, the oldest first.
    pub(crate) fn all(&self) -> impl DoubleEndedIterator<Item = &Arc<LookSnapshot>> {
        self.list.iter()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Snapshot of a number; `None` where it was deleted, or is of another look.
    pub(crate) fn of(&self, id: SnapshotId) -> Option<&Arc<LookSnapshot>> {
        self.list.iter().find(|snapshot| snapshot.id == id)
    }

    /// Reason why the file does not hold the snapshots as they are.
    pub(crate) fn problem(&self) -> Option<&Diagnostic> {
        self.problem.as_ref()
    }

    /// Name of the next snapshot, unless somebody gives another.
    pub(crate) fn next_name(&self) -> String {
        let is_used = |name: &String| self.list.iter().any(|snapshot| snapshot.name == *name);
        let mut names = (self.list.len() + 1..).map(|number| format!("Snapshot {number}"));
        names.find(|name| !is_used(name)).unwrap_or_default()
    }

    /// Takes a snapshot of a look, at a time in seconds since 1970, as a step.
    ///
    /// # Errors
    /// A diagnostic where there is no room for one more.
    pub(crate) fn take(
        &mut self,
        look: &Look,
        taken: u64,
        now: StepTime,
    ) -> Result<&LookSnapshot, Box<Diagnostic>> {
        let length = look.to_text().len();
        let total: usize = self.list.iter().map(|snapshot| snapshot.length).sum();
        if self.list.len() >= MOST || total + length > MOST_BYTES {
            let message = match self.list.len() >= MOST {
                true => tr!("a look has at most {MOST} snapshots"),
                false => {
                    tr!("snapshots of a look take at most {size} MiB", size = MOST_BYTES >> 20)
                }
            };
            let problem = Diagnostic::error("too-many-snapshots", message);
            return Err(Box::new(problem.hint(tr!("delete one first: undo brings it back"))));
        }
        self.last.0 += 1;
        let (id, name) = (self.last, self.next_name());
        let label = tr!("take {name}");
        let look = Arc::new(look.clone());
        let mut list = self.list.clone();
        list.push(Arc::new(LookSnapshot { id, name, taken, look, length }));
        self.did(label, list, now);
        self.list.last().map(|snapshot| &**snapshot).ok_or_else(|| Box::new(gone()))
    }

    /// Gives a snapshot another name, as a step.
    ///
    /// # Errors
    /// A diagnostic where there is no such snapshot.
    pub(crate) fn rename(
        &mut self,
        id: SnapshotId,
        name: &str,
        now: StepTime,
    ) -> Result<(), Box<Diagnostic>> {
        let mut list = self.list.clone();
        let found = list.iter_mut().find(|snapshot| snapshot.id == id);
        let found = found.ok_or_else(|| Box::new(gone()))?;
        let name: String = name.trim().chars().take(MOST_NAME).collect();
        if name.is_empty() || name == found.name {
            return Ok(());
        }
        let label = tr!("rename {old} to {name}", old = found.name);
        Arc::make_mut(found).name = name;
        self.did(label, list, now);
        Ok(())
    }

    /// Deletes a snapshot, as a step.
    ///
    /// # Errors
    /// A diagnostic where there is no such snapshot.
    pub(crate) fn delete(&mut self, id: SnapshotId, now: StepTime) -> Result<(), Box<Diagnostic>> {
        let found = self.of(id).ok_or_else(|| Box::new(gone()))?;
        let label = tr!("delete {name}", name = found.name);
        let others = self.list.iter().filter(|snapshot| snapshot.id != id);
        let list = others.cloned().collect();
        self.did(label, list, now);
        Ok(())
    }

    fn did(&mut self, label: String, list: Snapshots, now: StepTime) {
        self.done.push((label, std::mem::replace(&mut self.list, list)));
        self.undone.clear();
        self.times.did((self.done.len(), 0), now);
        while self.done.len() > MOST_STEPS || self.bytes_of_past() > MOST_BYTES {
            self.done.remove(0);
            self.times.fit((self.done.len(), 0));
        }
    }

    /// Length of the snapshots that undo alone would bring back, as text, in bytes.
    fn bytes_of_past(&self) -> usize {
        let here: HashSet<SnapshotId> = self.list.iter().map(|snapshot| snapshot.id).collect();
        let past = self.done.iter().flat_map(|(_, list)| list);
        let past = past.filter(|snapshot| !here.contains(&snapshot.id));
        let mut seen = HashSet::new();
        past.filter(|snapshot| seen.insert(snapshot.id)).map(|snapshot| snapshot.length).sum()
    }

    pub(crate) fn undo(&mut self) -> bool {
        let Some((label, before)) = self.done.pop() else { return false };
        self.undone.push((label, std::mem::replace(&mut self.list, before)));
        self.times.undid();
        true
    }

    pub(crate) fn redo(&mut self, now: StepTime) -> bool {
        let Some((label, after)) = self.undone.pop() else { return false };
        self.done.push((label, std::mem::replace(&mut self.list, after)));
        self.times.redid(now);
        true
    }

    pub(crate) fn undo_label(&self) -> Option<&str> {
        self.done.last().map(|(label, _)| label.as_str())
    }

    pub(crate) fn redo_label(&self) -> Option<&str> {
        self.undone.last().map(|(label, _)| label.as_str())
    }

    /// Number of done steps.
    pub(crate) fn place(&self) -> usize {
        self.done.len()
    }

    /// Labels of all steps: the done ones, then the undone ones, the next to redo first.
    pub(crate) fn labels(&self) -> impl Iterator<Item = &str> {
        self.done.iter().chain(self.undone.iter().rev()).map(|(label, _)| label.as_str())
    }

    /// Changes the looks of all snapshots, also of those that undo brings back. This is no step.
    pub(crate) fn amend(&mut self, change: impl Fn(&mut Look)) {
        let mut changed: HashMap<*const LookSnapshot, Arc<LookSnapshot>> = HashMap::new();
        let past = self.done.iter_mut().chain(&mut self.undone).map(|(_, list)| list);
        for snapshot in std::iter::once(&mut self.list).chain(past).flatten() {
            // Snapshots are shared by the steps, and those before the change keep their places.
            let of = changed.entry(Arc::as_ptr(snapshot)).or_insert_with(|| {
                let mut after = (**snapshot).clone();
                change(Arc::make_mut(&mut after.look));
                Arc::new(after)
            });
            *snapshot = of.clone();
        }
    }

    /// Writes the snapshots beside a look, where they are not there yet as they are. What another
    /// window has put into the file since stays, and is here from then on.
    pub(crate) fn write_beside(&mut self, look: &Path) {
        let path = file_of(look);
        let found = self.file.others(&path, &mut self.last);
        match found {
            Ok(others) => {
                for other in others {
                    if !self.list.iter().any(|snapshot| snapshot.is(&other)) {
                        self.list.push(other);
                    }
                }
                self.problem = self.file.write(path, &self.list).err().map(|problem| *problem);
            }
            Err(problem) => self.problem = Some(*problem),
        }
    }

    /// The snapshots as a journal keeps them.
    pub(crate) fn to_json(&self) -> serde_json::Value {
        file::json_of(&self.list, &[])
    }

    /// Shelf of snapshots that a journal kept, after another.
    pub(crate) fn from_json(json: &serde_json::Value, before: &Self) -> Self {
        let mut shelf = Self { last: before.last, ..Self::default() };
        shelf.list = file::snapshots_of(json, "journal", &mut shelf.last).0;
        shelf
    }
}

fn gone() -> Diagnostic {
    Diagnostic::error("no-snapshot", tr!("that snapshot is not there any more"))
}

#[cfg(test)]
mod tests;
