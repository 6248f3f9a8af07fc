//! Record of the document that was being read, compiled or drawn when a program crashed: the next
//! window does not repeat that step by itself, and starts.
//!
//! Every running window has a file in the user's state folder. Before a document is read, compiled
//! or drawn for the first time a line in the file says so, and another line after the step; a file
//! without steps under way is empty. The file is locked, and the lock is the system's own: it ends
//! with the program, however that ends. So a step that was begun and not ended, in a file without a
//! lock, was interrupted. Nothing is forced onto the disk: only the program ends in a crash of its
//! own, not the system.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, UNIX_EPOCH};

use serde::{Deserialize, Serialize};

use crate::clock;
use crate::document::Look;
use crate::files::write_atomic;
use crate::state::paths::absolute;
use crate::state::revision::SuspectsRevision;

const ENDING: &str = "running";
/// Largest number of bytes read of a file.
const MOST_BYTES: u64 = 1 << 20;
/// Age from which an empty file that nobody holds may be removed; a younger file may belong to a
/// window that is about to lock it.
const OLD: Duration = Duration::from_secs(60 * 60);

/// Step of work on a document, in order: a later step needs the earlier ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum CrashStep {
    /// Reading the document's file.
    Read,
    /// Compiling its shader.
    Compile,
    /// Drawing its picture, which makes drivers compile the shader, too.
    Draw,
}

/// Identity of a document: its file, or a hash of its content where it has none.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct DocumentOrigin {
    /// Display name of the document.
    pub(crate) name: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    path: Option<PathBuf>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    content: Option<u64>,
}

impl DocumentOrigin {
    pub(crate) fn of_file(path: &Path) -> Self {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        Self { name, path: Some(absolute(path)), content: None }
    }

    /// The document in a file, or else the one in which `look` is open.
    pub(crate) fn new(name: &str, path: Option<&Path>, look: &Look) -> Self {
        match path {
            Some(path) => Self { name: name.to_owned(), ..Self::of_file(path) },
            None => {
                let mut hasher = DefaultHasher::new();
                look.to_text().hash(&mut hasher);
                Self { name: name.to_owned(), path: None, content: Some(hasher.finish()) }
            }
        }
    }

    fn is(&self, other: &Self) -> bool {
        match (&self.path, &other.path) {
            (Some(path), Some(other)) => path == other,
            (None, None) => self.content.is_some() && self.content == other.content,
            _ => false,
        }
    }

    /// Size and time of the document's file at present: a changed file counts as another document.
    fn stamp(&self) -> Option<[u64; 2]> {
        let data = fs::metadata(self.path.as_ref()?).ok()?;
        let modified = data.modified().ok()?.duration_since(UNIX_EPOCH).unwrap_or_default();
        Some([data.len(), modified.as_nanos() as u64])
    }
}

/// A line of a window's file.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Line {
    Begin {
        number: u64,
        step: CrashStep,
        document: DocumentOrigin,
        /// Size of the document's file, and time of its last change.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        stamp: Option<[u64; 2]>,
    },
    End {
        number: u64,
    },
}

impl Line {
    fn to_text(&self) -> String {
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }
}

/// A document with the step under way when a program ended.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Suspect {
    pub(crate) document: DocumentOrigin,
    pub(crate) step: CrashStep,
    stamp: Option<[u64; 2]>,
    /// File of the window that ended.
    told_by: PathBuf,
}

impl Suspect {
    /// True if the document's file is unchanged. Whoever changed it may have mended it.
    fn is_unchanged(&self) -> bool {
        self.document.path.is_none() || self.stamp.is_none() || self.document.stamp() == self.stamp
    }
}

/// Log of this window's steps, and the interrupted steps of others. Clones share one log.
#[derive(Clone, Debug, Default)]
pub(crate) struct CrashLog(Arc<Mutex<State>>);

#[derive(Debug, Default)]
struct State {
    /// Folder of the files; `None` while nothing is kept.
    folder: Option<PathBuf>,
    /// File of this window, once a step was begun.
    own: Option<(PathBuf, File)>,
    /// Number of steps that were begun, and of those that go on.
    begun: u64,
    going: usize,
    suspects: Vec<Suspect>,
    suspects_revision: SuspectsRevision,
}

impl CrashLog {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Keeps this window's file in `folder` from now on, and reads which steps were interrupted
    /// there.
    pub(crate) fn keep_in(&self, folder: &Path) {
        let suspects = interrupted(folder);
        let mut state = self.lock();
        state.folder = Some(folder.to_owned());
        state.suspects = suspects;
        state.suspects_revision.advance();
    }

    /// Notes that a step of work on a document goes on until the returned mark is dropped.
    pub(crate) fn begin(
        &self,
        step: CrashStep,
        document: impl FnOnce() -> DocumentOrigin,
    ) -> CrashMark {
        let is_kept = self.lock().folder.is_some();
        // Computed without holding the lock: hashing or asking for the file takes a moment.
        let begun = is_kept.then(document).map(|document| (document.stamp(), document));
        let mut state = self.lock();
        let number = begun.and_then(|(stamp, document)| {
            let number = state.begun;
            let line = Line::Begin { number, step, document, stamp };
            state.own()?.write_all(line.to_text().as_bytes()).ok()?;
            state.begun += 1;
            state.going += 1;
            Some(number)
        });
        CrashMark { log: self.clone(), number }
    }

    /// Notes that a file is being read until the returned mark is dropped; `None` where the last
    /// program ended while reading that file, which is then not to be read.
    pub(crate) fn begin_to_read(&self, path: &Path) -> Option<CrashMark> {
        let is_held_back =
            self.suspect_in(path).is_some_and(|suspect| suspect.step == CrashStep::Read);
        (!is_held_back).then(|| self.begin(CrashStep::Read, || DocumentOrigin::of_file(path)))
    }

    /// Removes the file of a window that closes in peace: steps that still go on are of no
    /// interest.
    pub(crate) fn close(&self) {
        let mut state = self.lock();
        state.folder = None;
        if let Some((path, file)) = state.own.take() {
            drop(file);
            let _ = fs::remove_file(path);
        }
    }

    /// Revision of the suspects, which grows when a document is suspected, or no longer is.
    pub(crate) fn suspects_revision(&self) -> SuspectsRevision {
        self.lock().suspects_revision
    }

    /// True if any step was interrupted.
    pub(crate) fn is_any(&self) -> bool {
        !self.lock().suspects.is_empty()
    }

    /// The earliest interrupted step of a document; `None` if its file was changed since.
    pub(crate) fn suspect(&self, document: &DocumentOrigin) -> Option<Suspect> {
        let state = self.lock();
        let found = state.suspects.iter().filter(|suspect| suspect.document.is(document));
        found.filter(|suspect| suspect.is_unchanged()).min_by_key(|suspect| suspect.step).cloned()
    }

    /// The earliest interrupted step of the document in a file.
    pub(crate) fn suspect_in(&self, path: &Path) -> Option<Suspect> {
        if self.is_any() { self.suspect(&DocumentOrigin::of_file(path)) } else { None }
    }

    /// Trusts a document again, in this window and in those that start later.
    pub(crate) fn trust(&self, document: &DocumentOrigin) {
        let mut state = self.lock();
        let (gone, left): (Vec<Suspect>, Vec<Suspect>) = std::mem::take(&mut state.suspects)
            .into_iter()
            .partition(|suspect| suspect.document.is(document));
        state.suspects = left;
        state.suspects_revision.advance();
        for told_by in gone.iter().map(|suspect| &suspect.told_by) {
            let others = state.suspects.iter().filter(|suspect| suspect.told_by == *told_by);
            let lines = others.zip(0..).map(|(suspect, number)| {
                let Suspect { document, step, stamp, .. } = suspect.clone();
                Line::Begin { number, step, document, stamp }.to_text()
            });
            let text: String = lines.collect();
            // A failure to write only means that the user is asked once more.
            if text.is_empty() {
                let _ = fs::remove_file(told_by);
            } else {
                let _ = write_atomic(told_by, text.as_bytes());
            }
        }
    }
}

impl State {
    /// File of this window, created at the first call. Where that fails, nothing is kept: the
    /// window works without.
    fn own(&mut self) -> Option<&mut File> {
        let folder = self.folder.as_ref()?;
        if self.own.is_none() {
            fs::create_dir_all(folder).ok()?;
            let ending = format!(".{ENDING}");
            let mut builder = tempfile::Builder::new();
            let file = builder
                .prefix("window-")
                .suffix(&ending)
                .rand_bytes(10)
                .append(true)
                .tempfile_in(folder)
                .ok()?;
            let (file, path) = file.keep().ok()?;
            // A window that only checks whether the file is held releases its lock at once. Where
            // there are no locks, another window takes the steps of this one for interrupted, and
            // asks.
            let _ = file.lock();
            self.own = Some((path, file));
        }
        self.own.as_mut().map(|(_, file)| file)
    }

    fn end(&mut self, number: u64) {
        self.going = self.going.saturating_sub(1);
        let is_last = self.going == 0;
        let Some((_, file)) = &mut self.own else { return };
        let _ = match is_last {
            // The file is opened to append: the next line goes to its beginning.
            true => file.set_len(0),
            false => file.write_all(Line::End { number }.to_text().as_bytes()),
        };
    }
}

impl Drop for State {
    fn drop(&mut self) {
        if let Some((path, _)) =
            self.own.take().filter(|_| self.going == 0 && !std::thread::panicking())
        {
            let _ = fs::remove_file(path);
        }
    }
}

/// A step that goes on until the mark is dropped; in a thread that panics the step never ends.
#[derive(Debug)]
#[must_use = "dropped, it says that what was begun has ended"]
pub(crate) struct CrashMark {
    log: CrashLog,
    number: Option<u64>,
}

impl Drop for CrashMark {
    fn drop(&mut self) {
        if let Some(number) = self.number.filter(|_| !std::thread::panicking()) {
            self.log.lock().end(number);
        }
    }
}

/// The interrupted steps of programs that have ended.
fn interrupted(folder: &Path) -> Vec<Suspect> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut suspects = Vec::new();
    for path in entries.filter(|path| path.extension().is_some_and(|ending| ending == ENDING)) {
        let Some(text) = text_left(&path) else { continue };
        let found = begun_in(&text, &path);
        let is_of_interest = found.iter().any(Suspect::is_unchanged);
        if !is_of_interest && (!found.is_empty() || is_old(&path)) {
            let _ = fs::remove_file(&path);
        }
        suspects.extend(found.into_iter().filter(Suspect::is_unchanged));
    }
    suspects
}

/// Text of a file that no program holds. Others may read the file at the same time.
fn text_left(path: &Path) -> Option<String> {
    let file = OpenOptions::new().read(true).open(path).ok()?;
    if let Err(TryLockError::WouldBlock) = file.try_lock_shared() {
        return None;
    }
    let mut bytes = Vec::new();
    (&file).take(MOST_BYTES).read_to_end(&mut bytes).ok()?;
    Some(String::from_utf8_lossy(&bytes).into_owned())
}

/// The steps that were begun and not ended. The last line may be half written.
fn begun_in(text: &str, told_by: &Path) -> Vec<Suspect> {
    let mut going = Vec::new();
    for line in text.lines().filter_map(|line| serde_json::from_str(line).ok()) {
        match line {
            Line::Begin { number, step, document, stamp } => {
                let told_by = told_by.to_owned();
                going.push((number, Suspect { document, step, stamp, told_by }));
            }
            Line::End { number } => going.retain(|(begun, _)| *begun != number),
        }
    }
    going.into_iter().map(|(_, suspect)| suspect).collect()
}

fn is_old(path: &Path) -> bool {
    let modified = fs::metadata(path).and_then(|data| data.modified());
    modified.is_ok_and(|modified| clock::age(modified) > OLD)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(folder: &Path, name: &str) -> DocumentOrigin {
        let path = folder.join(name);
        fs::write(&path, "{}").unwrap();
        DocumentOrigin::of_file(&path)
    }

    fn kept_in(folder: &Path) -> CrashLog {
        let log = CrashLog::default();
        log.keep_in(folder);
        log
    }

    /// Copy of the state folder as a crash at this moment leaves it: without locks.
    fn after_a_crash(folder: &Path) -> tempfile::TempDir {
        let other = tempfile::tempdir().unwrap();
        for entry in fs::read_dir(folder).unwrap().flatten() {
            fs::copy(entry.path(), other.path().join(entry.file_name())).unwrap();
        }
        other
    }

    #[test]
    fn what_was_interrupted_is_suspected_until_it_is_trusted() {
        let folder = tempfile::tempdir().unwrap();
        let state = folder.path().join("state");
        let [a, b, c] = ["a.json", "b.json", "c.json"].map(|name| file(folder.path(), name));
        let log = kept_in(&state);
        let going = log.begin(CrashStep::Draw, || a.clone());
        drop(log.begin(CrashStep::Compile, || b.clone()));
        let also = log.begin(CrashStep::Compile, || c.clone());
        assert!(!kept_in(&state).is_any(), "another window that runs is at work");
        let left = after_a_crash(&state);
        for _ in 0..2 {
            // Each window learns of the interruption, at the same time too.
            let next = kept_in(left.path());
            assert_eq!(next.suspect(&a).map(|suspect| suspect.step), Some(CrashStep::Draw));
            assert_eq!(next.suspect(&b), None, "that had ended");
        }
        let next = kept_in(left.path());
        next.trust(&a);
        assert_eq!((next.suspect(&a), next.suspect(&c).is_some()), (None, true));
        let after = kept_in(left.path());
        assert_eq!((after.suspect(&a), after.suspect(&c).is_some()), (None, true));
        after.trust(&c);
        assert_eq!(fs::read_dir(left.path()).unwrap().count(), 0, "nothing stays of it");
        drop((going, also));
        assert_eq!(after_a_crash(&state).path().read_dir().unwrap().count(), 1);
        assert!(!kept_in(after_a_crash(&state).path()).is_any());
        drop(log);
        assert_eq!(
            fs::read_dir(&state).unwrap().count(),
            0,
            "a window that is closed leaves nothing"
        );
    }

    #[test]
    fn a_changed_file_is_another_one_and_what_has_none_is_known_by_what_it_says() {
        let folder = tempfile::tempdir().unwrap();
        let state = folder.path().join("state");
        let a = file(folder.path(), "a.json");
        let look = Look { name: "Rim".to_owned(), ..Look::default() };
        let unsaved = DocumentOrigin::new("Rim", None, &look);
        let log = kept_in(&state);
        let going = [
            log.begin(CrashStep::Draw, || a.clone()),
            log.begin(CrashStep::Read, || unsaved.clone()),
        ];
        let left = after_a_crash(&state);
        fs::write(folder.path().join("a.json"), "{\"name\": \"mended\"}").unwrap();
        let next = kept_in(left.path());
        assert_eq!(next.suspect(&a), None);
        assert!(next.suspect(&DocumentOrigin::new("as ever it is called", None, &look)).is_some());
        assert_eq!(next.suspect(&DocumentOrigin::new("Rim", None, &Look::default())), None);
        drop(going);
    }

    #[test]
    fn what_was_begun_stays_small_and_a_line_that_was_cut_off_says_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let a = file(folder.path(), "a.json");
        let state = folder.path().join("state");
        let log = kept_in(&state);
        for _ in 0..1000 {
            drop(log.begin(CrashStep::Draw, || a.clone()));
        }
        let own = fs::read_dir(&state).unwrap().flatten().next().unwrap();
        assert_eq!(own.metadata().unwrap().len(), 0);
        let line =
            Line::Begin { number: 0, step: CrashStep::Draw, document: a, stamp: None }.to_text();
        assert_eq!(begun_in(&line[..line.len() / 2], &state).len(), 0);
        assert_eq!(begun_in(&(line.clone() + &line[..9]), &state).len(), 1);
    }

    #[test]
    fn without_a_folder_nothing_is_kept() {
        let log = CrashLog::default();
        let going = log.begin(CrashStep::Draw, || unreachable!("nobody asks"));
        assert!(!log.is_any() && going.number.is_none());
    }
}
