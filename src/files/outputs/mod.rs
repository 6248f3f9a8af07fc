//! Guarded outputs of commands: no file that somebody made is lost by a mistyped name.
//!
//! [`Outputs`] is the one way by which a command, or the window for it, writes files. It knows the
//! files that the command reads and refuses to write over them; of other existing files it replaces
//! only those that it recognizes as earlier outputs of the same [`OutputKind`], unless it is
//! forced. All files of one [`Outputs::commit`] come together.

mod kind;
mod staging;

use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Path, PathBuf};

use chiaro_locale::tr;
pub use kind::{OutputKind, sealed_script};
pub use staging::{FileSet, remove_abandoned, remove_unfinished};

use crate::diag::Diagnostic;

/// Bounds of looking through a folder that a command reads: depth, and number of files.
const MAX_DEPTH: usize = 8;
const MAX_FILES: usize = 100_000;
/// Length from which a file cannot be an output of Chiaro, in bytes.
const MAX_KNOWN: u64 = 1 << 30;

/// Identity of a file, whatever it is called: links and `..` lead to the same file.
#[derive(Clone, Debug)]
struct Identity {
    /// Canonical path, without links: another program may put another file there while the command
    /// works.
    place: PathBuf,
    /// Numbers of the device and of the inode, which all names of the file have in common.
    #[cfg(unix)]
    numbers: (u64, u64),
}

impl Identity {
    /// Identity of the file at a path; `None` where there is no file.
    fn of(path: &Path) -> Option<Self> {
        let place = fs::canonicalize(path).ok()?;
        #[cfg(unix)]
        let numbers = {
            use std::os::unix::fs::MetadataExt as _;
            let data = fs::metadata(&place).ok()?;
            (data.dev(), data.ino())
        };
        Some(Self {
            place,
            #[cfg(unix)]
            numbers,
        })
    }

    fn is(&self, other: &Self) -> bool {
        #[cfg(unix)]
        let is_same_file = self.numbers == other.numbers;
        #[cfg(not(unix))]
        let is_same_file = false;
        is_same_file || self.place == other.place
    }
}

/// Files that one command writes, and the files that must not be written over.
#[derive(Debug, Default)]
pub struct Outputs {
    inputs: Vec<(Identity, PathBuf)>,
    /// Documents that the command reads and writes back.
    changed: Vec<(Identity, PathBuf)>,
    is_forced: bool,
    set: FileSet,
    /// Paths of the files in the set.
    added: Vec<PathBuf>,
}

impl Outputs {
    /// Outputs of a command that reads nothing yet. With `is_forced`, files that somebody made are
    /// replaced, too, but not those that the command reads.
    pub fn new(is_forced: bool) -> Self {
        Self { is_forced, ..Self::default() }
    }

    /// Outputs of another thread of the same command: what they must not write over is the same.
    #[must_use]
    pub fn another(&self) -> Self {
        Self {
            inputs: self.inputs.clone(),
            changed: self.changed.clone(),
            is_forced: self.is_forced,
            ..Self::default()
        }
    }

    /// Notes a file that the command reads, or the documents and nodes in a folder. A path that
    /// does not exist is ignored.
    pub fn reads(&mut self, path: &Path) {
        let mut open = vec![(path.to_owned(), 0)];
        while let Some((path, depth)) = open.pop() {
            if path.is_dir() {
                let entries =
                    fs::read_dir(&path).into_iter().flatten().flatten().map(|entry| entry.path());
                let is_read = |path: &PathBuf| {
                    let is_source =
                        path.extension().is_some_and(|ending| ending == "json" || ending == "wgsl");
                    is_source || depth < MAX_DEPTH && path.is_dir()
                };
                open.extend(entries.filter(is_read).map(|path| (path, depth + 1)));
            } else if let Some(identity) =
                Identity::of(&path).filter(|_| self.inputs.len() < MAX_FILES)
            {
                self.inputs.push((identity, path));
            }
        }
    }

    /// Notes a document that the command reads and writes back: a document may replace it, under
    /// whatever name, and no other kind of file.
    pub fn changes(&mut self, path: &Path) {
        self.changed.extend(Identity::of(path).map(|identity| (identity, path.to_owned())));
    }

    /// Checks whether a file of this kind may be written there, before the work is done.
    ///
    /// # Errors
    /// - `would-overwrite`: the command reads the file at the path.
    /// - `file-exists`: somebody made the file at the path.
    pub fn check(&self, path: &Path, kind: OutputKind<'_>) -> Result<(), Diagnostic> {
        self.check_bytes(path, kind, |old| (kind.is_own)(old))
    }

    /// Checks as [`check`](Self::check), and lets `look` see what a file holds that is there: true
    /// for one that may be replaced. What it does not know is judged by the kind. It sees nothing
    /// where files are replaced unseen.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub fn check_looking(
        &self,
        path: &Path,
        kind: OutputKind<'_>,
        mut look: impl FnMut(&[u8]) -> bool,
    ) -> Result<(), Diagnostic> {
        self.check_bytes(path, kind, |old| look(old) || (kind.is_own)(old))
    }

    /// Writes a file, to be seen with all others that were added before [`commit`](Self::commit).
    ///
    /// # Errors
    /// As [`check`](Self::check), and `cannot-write`.
    pub fn add(
        &mut self,
        path: &Path,
        kind: OutputKind<'_>,
        bytes: &[u8],
    ) -> Result<(), Diagnostic> {
        let sealed = kind.has_seal.then(|| kind::sealed(bytes));
        let bytes = sealed.as_deref().unwrap_or(bytes);
        self.check_bytes(path, kind, |old| bytes == old || (kind.is_own)(old))?;
        if self.added.iter().any(|added| added == path) {
            let message = tr!("the same command would write two different files here");
            return Err(in_file(Diagnostic::error("would-overwrite", message), path)
                .hint(tr!("choose two names")));
        }
        self.set.add(path, bytes).map_err(|problem| *problem)?;
        self.added.push(path.to_owned());
        Ok(())
    }

    /// Removes a file when the others appear, unless one of them takes its place.
    pub fn remove(&mut self, path: PathBuf) {
        self.set.remove(path);
    }

    /// Lets all files that were added be seen, in that order. More may be added afterwards, to be
    /// seen together later.
    ///
    /// # Errors
    /// `cannot-write`, as [`FileSet::commit`].
    pub fn commit(&mut self) -> Result<(), Diagnostic> {
        self.added.clear();
        std::mem::take(&mut self.set).commit().map_err(|problem| *problem)
    }

    /// Writes one file alone.
    ///
    /// # Errors
    /// As [`add`](Self::add) and [`commit`](Self::commit).
    pub fn write(
        &mut self,
        path: &Path,
        kind: OutputKind<'_>,
        bytes: &[u8],
    ) -> Result<(), Diagnostic> {
        self.add(path, kind, bytes)?;
        self.commit()
    }

    fn check_bytes(
        &self,
        path: &Path,
        kind: OutputKind<'_>,
        is_known: impl FnOnce(&[u8]) -> bool,
    ) -> Result<(), Diagnostic> {
        let Some(identity) = Identity::of(path) else { return Ok(()) };
        let is_it = |(input, _): &&(Identity, PathBuf)| input.is(&identity);
        let changed = self.changed.iter().find(is_it);
        if changed.is_some() && kind.is_document() {
            return Ok(());
        }
        if let Some((_, input)) = self.inputs.iter().find(is_it).or(changed) {
            let message = if input == path {
                tr!("the same command reads this file, and would write over it").to_owned()
            } else {
                tr!(
                    "this is `{input}`, which the same command reads and would write over",
                    input = input.display()
                )
            };
            let problem = Diagnostic::error("would-overwrite", message);
            return Err(in_file(problem, path).hint(tr!("choose another name for what is written")));
        }
        if self.is_forced {
            return Ok(());
        }
        // The write itself reports a path that is no file.
        if path.is_dir() || known_bytes(path).is_some_and(|old| is_known(&old)) {
            return Ok(());
        }
        let message = if kind.is_document() {
            tr!("this file is there already").to_owned()
        } else {
            tr!(
                "this file is there already, and is not {name} as Chiaro has written it",
                name = tr(kind.name)
            )
        };
        let problem = Diagnostic::error("file-exists", message);
        Err(in_file(problem, path).hint(tr!("choose another name, or replace it with --force")))
    }
}

fn in_file(problem: Diagnostic, path: &Path) -> Diagnostic {
    problem.in_file(path.display().to_string())
}

/// Content of a file; `None` where the file cannot be read, or is longer than any that Chiaro
/// writes.
fn known_bytes(path: &Path) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path).ok()?.take(MAX_KNOWN + 1).read_to_end(&mut bytes).ok()?;
    (bytes.len() as u64 <= MAX_KNOWN).then_some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOTE: OutputKind<'static> = OutputKind {
        name: "a note",
        is_own: &|bytes| bytes.starts_with(b"note:"),
        has_seal: false,
    };

    #[test]
    fn what_somebody_made_is_kept_and_what_was_written_before_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        for number in 0..3 {
            Outputs::new(false).write(&path, NOTE, format!("note: {number}").as_bytes()).unwrap();
        }
        fs::write(&path, "mine").unwrap();
        let problem = Outputs::new(false).write(&path, NOTE, b"note: 3").unwrap_err();
        assert!(problem.code == "file-exists" && problem.message.contains("a note"), "{problem}");
        assert!(problem.hints[0].contains("--force"), "{problem}");
        assert_eq!(fs::read(&path).unwrap(), b"mine");
        assert!(
            Outputs::new(false).write(&path, NOTE, b"mine").is_ok(),
            "nothing is lost by the same again"
        );
        assert_eq!(
            Outputs::new(false).check(&path, OutputKind::DOCUMENT).unwrap_err().code,
            "file-exists"
        );
        Outputs::new(true).write(&path, NOTE, b"note: 4").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"note: 4");
        assert_eq!(
            Outputs::new(true).write(folder.path(), NOTE, b"").unwrap_err().code,
            "cannot-write"
        );
    }

    #[test]
    fn inputs_are_known_by_any_name_and_never_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir_all(path("nodes/inner")).unwrap();
        for name in ["look.json", "nodes/own.wgsl", "nodes/inner/group.json", "nodes/image.png"] {
            fs::write(path(name), "note: an input").unwrap();
        }
        let mut outputs = Outputs::new(true);
        [path("look.json"), path("nodes"), path("there/is/none")]
            .iter()
            .for_each(|path| outputs.reads(path));
        let mut names =
            vec!["look.json", "nodes/../look.json", "nodes/own.wgsl", "nodes/inner/group.json"];
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("look.json", path("link")).unwrap();
            std::os::unix::fs::symlink("link", path("around")).unwrap();
            fs::hard_link(path("look.json"), path("second-name")).unwrap();
            names.extend(["link", "around", "second-name"]);
        }
        for name in names {
            let problem = outputs.write(&path(name), NOTE, b"note: new").unwrap_err();
            assert_eq!(problem.code, "would-overwrite", "{name}: {problem}");
            assert_eq!(fs::read(path(name)).unwrap(), b"note: an input");
        }
        outputs.write(&path("nodes/image.png"), NOTE, b"note: new").unwrap();
        outputs.add(&path("twice"), NOTE, b"note: 1").unwrap();
        assert_eq!(
            outputs.add(&path("twice"), NOTE, b"note: 2").unwrap_err().code,
            "would-overwrite"
        );

        let mut changing = Outputs::new(false);
        changing.changes(&path("look.json"));
        changing.write(&path("nodes/../look.json"), OutputKind::DOCUMENT, b"changed").unwrap();
        assert_eq!(fs::read(path("look.json")).unwrap(), b"changed");
        assert_eq!(
            changing.write(&path("look.json"), NOTE, b"note: new").unwrap_err().code,
            "would-overwrite"
        );
    }
}
