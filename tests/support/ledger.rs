//! What was proved already, so that nothing is proved twice: `tests/ledger/NAME.txt`.
//!
//! A long sweep is a list of cases. The key of a case is a hash of everything that its verdict
//! depends on: the modules that it draws, their meshes and inputs, the source of the engines that
//! judge it, and the driver. The ledger keeps a line a case, `KEY FIGURE CASE`: the figure is what
//! the proof came to, mostly the largest error. A case whose key is another than its line's is
//! proved anew; of the rest a tenth is, chosen by the commit, so that each line is checked within
//! ten or so commits, and one that says what is not so is found then: the figure that comes out is
//! held against the line's.
//!
//! `CHIARO_LEDGER=write` writes the lines of what was proved; `CHIARO_LEDGER=all` proves all, as
//! `scripts/soak` does.

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;
use std::hash::Hasher as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, PoisonError};
use std::{env, fs};

use siphasher::sip128::{Hasher128 as _, SipHasher13};

use crate::{files, root};

/// One in so many lines is proved anew in each commit.
const TURNS: u64 = 10;
/// Figures of two proofs of one case are alike up to this factor: drivers vectorize for the
/// processor that they find.
const ALIKE: f64 = 2.0;
/// Figures below this count as alike: three units in the last place of 1.
const NOTHING: f64 = 4e-7;

/// The hash of what a verdict depends on.
#[derive(Clone)]
pub struct Key(SipHasher13);

impl Key {
    /// The key of what depends on the files under these folders of the project alone: Rust and
    /// WGSL, without comments.
    pub fn of_sources(folders: &[&str]) -> Self {
        Self::of_sources_in(root(), folders)
    }

    /// The same below another root.
    pub fn of_sources_in(root: &Path, folders: &[&str]) -> Self {
        let mut key = Self(SipHasher13::new());
        for folder in folders {
            key.add(&source_hash(&root.join(folder)).to_le_bytes());
        }
        key
    }

    /// Lets the verdict depend on more.
    pub fn add(&mut self, bytes: &[u8]) {
        self.0.write_usize(bytes.len());
        self.0.write(bytes);
    }

    /// The same with more.
    pub fn with(&self, bytes: &[u8]) -> Self {
        let mut key = self.clone();
        key.add(bytes);
        key
    }

    /// As it stands in a ledger.
    pub fn text(&self) -> String {
        format!("{:032x}", self.0.finish128().as_u128())
    }
}

/// The hash of a folder's or file's sources, from their lines of code; read once where it lies in
/// this project.
fn source_hash(folder: &Path) -> u128 {
    static KNOWN: Mutex<Option<HashMap<PathBuf, u128>>> = Mutex::new(None);
    let is_ours = folder.starts_with(root());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let known = known.get_or_insert_default();
    if let Some(hash) = known.get(folder).filter(|_| is_ours) {
        return *hash;
    }
    let kinds = ["rs", "wgsl", "json", "mjs"];
    let is_source = |path: &PathBuf| {
        kinds.iter().any(|kind| path.extension().is_some_and(|name| name == *kind))
    };
    let all = if folder.is_file() { vec![folder.to_path_buf()] } else { files::below(folder) };
    let sources: Vec<PathBuf> = all.into_iter().filter(is_source).collect();
    assert!(!sources.is_empty(), "{}: there are no sources to depend on", folder.display());
    let mut hasher = SipHasher13::new();
    for path in sources {
        let text =
            fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let name =
            path.strip_prefix(folder).expect("it was found there").to_string_lossy().into_owned();
        for part in [name.as_str(), &code(&text)] {
            hasher.write_usize(part.len());
            hasher.write(part.as_bytes());
        }
    }
    let hash = hasher.finish128().as_u128();
    known.insert(folder.to_path_buf(), hash);
    hash
}

/// A source without lines that are comments or blank.
fn code(text: &str) -> String {
    let lines =
        text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//"));
    lines.fold(String::new(), |all, line| all + line + "\n")
}

/// A line of a ledger.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    key: String,
    figure: f64,
}

/// Which cases are proved anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Those with another key, and those whose turn it is.
    Turns,
    /// All of them.
    All,
    /// Those with another key; and the ledger is written.
    Write,
}

/// A ledger at work: what it knows, and what this run found.
pub struct Ledger {
    path: PathBuf,
    mode: Mode,
    /// The hash of the commit, which chooses whose turn it is.
    commit: String,
    known: BTreeMap<String, Row>,
    now: BTreeMap<String, Row>,
    proved: usize,
    stand: usize,
    /// What is wrong with cases that were proved, and with lines.
    pub complaints: Vec<String>,
}

impl Ledger {
    /// The project's ledger of a sweep.
    pub fn open(name: &str) -> Self {
        let root = root();
        let mode = match env::var("CHIARO_LEDGER").as_deref() {
            Ok("all") => Mode::All,
            Ok("write") => Mode::Write,
            _ => Mode::Turns,
        };
        let head = Command::new("git").args(["rev-parse", "HEAD"]).current_dir(root).output();
        let commit = head
            .map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
            .unwrap_or_default();
        Self::at(&root.join("tests/ledger").join(format!("{name}.txt")), mode, &commit)
    }

    /// A ledger in a file, at work as it would be in a commit.
    pub fn at(path: &Path, mode: Mode, commit: &str) -> Self {
        let text = fs::read_to_string(path).unwrap_or_default();
        let row = |line: &str| {
            let mut parts = line.splitn(3, ' ');
            let (key, figure, case) = (parts.next()?, parts.next()?, parts.next()?);
            Some((case.to_owned(), Row { key: key.to_owned(), figure: figure.parse().ok()? }))
        };
        let lines = text.lines().filter(|line| !line.starts_with('#'));
        let known = lines.map(|line| {
            row(line).unwrap_or_else(|| panic!("{}: `{line}` is no line", path.display()))
        });
        Self {
            path: path.to_path_buf(),
            mode,
            commit: commit.to_owned(),
            known: known.collect(),
            now: BTreeMap::new(),
            proved: 0,
            stand: 0,
            complaints: Vec::new(),
        }
    }

    /// Whether a case has to be proved; where it has not, its line stands.
    pub fn is_due(&mut self, case: &str, key: &Key) -> bool {
        let Some(row) = self.known.get(case).filter(|row| row.key == key.text()) else {
            return true;
        };
        let is_due = match self.mode {
            Mode::All => true,
            Mode::Write => false,
            Mode::Turns => self.has_turn(case),
        };
        if !is_due {
            self.stand += 1;
            self.now.insert(case.to_owned(), row.clone());
        }
        is_due
    }

    /// Whether this commit proves a case whatever its line says.
    fn has_turn(&self, case: &str) -> bool {
        let mut hasher = SipHasher13::new();
        hasher.write(self.commit.as_bytes());
        hasher.write(case.as_bytes());
        hasher.finish128().h1.is_multiple_of(TURNS)
    }

    /// What a proof of a case came to: its figure, or what is wrong.
    pub fn note(&mut self, case: &str, key: &Key, proof: Result<f64, String>) {
        self.proved += 1;
        let figure = match proof {
            Ok(figure) => figure,
            Err(complaint) => {
                self.complaints.push(format!("{case}: {complaint}"));
                return;
            }
        };
        let row = Row { key: key.text(), figure };
        if let Some(known) = self.known.get(case).filter(|known| known.key == row.key)
            && !are_alike(known.figure, figure)
        {
            let (path, said) = (self.path.display(), known.figure);
            self.complaints.push(format!(
                "{case}: {path} says {said:e}, and it comes to {figure:e}: the line is false"
            ));
        }
        self.now.insert(case.to_owned(), row);
    }

    /// Proves a case where it is due.
    pub fn prove(&mut self, case: &str, key: &Key, proof: impl FnOnce() -> Result<f64, String>) {
        if self.is_due(case, key) {
            let proof = proof();
            self.note(case, key, proof);
        }
    }

    /// What each case of this run came to, in this run or as its line has it.
    pub fn figures(&self) -> impl Iterator<Item = (&str, f64)> {
        self.now.iter().map(|(case, row)| (case.as_str(), row.figure))
    }

    /// How many cases were proved anew, and how many stand as they are in the ledger.
    pub fn counts(&self) -> [usize; 2] {
        [self.proved, self.stand]
    }

    /// Writes the ledger where that is asked for, and fails with everything that is wrong.
    #[allow(clippy::print_stdout, reason = "`--nocapture` shows what was proved")]
    pub fn close(self) {
        let name = self.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let [proved, stand] = self.counts();
        println!("{name}: {proved} proved, {stand} as the ledger has them");
        if self.mode == Mode::Write {
            let mut text = String::from(
                "# What was proved: key, figure, case. CHIARO_LEDGER=write writes it.\n",
            );
            for (case, row) in &self.now {
                let _ = writeln!(text, "{} {:e} {case}", row.key, row.figure);
            }
            fs::create_dir_all(self.path.parent().expect("it lies in a folder"))
                .expect("the folder can be made");
            fs::write(&self.path, text).expect("the ledger can be written");
        }
        assert!(self.complaints.is_empty(), "{name}:\n{}", self.complaints.join("\n"));
    }
}

/// Whether a ledger whose only line gives `figure` to a case complains of it in the first commit
/// that proves the case anew.
pub fn is_found_false(
    case: &str,
    key: &Key,
    figure: f64,
    proof: impl FnOnce() -> Result<f64, String>,
) -> bool {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("forged.txt");
    fs::write(&path, format!("{} {figure:e} {case}\n", key.text())).expect("it can be written");
    let mut commits = (0..1000).map(|commit: u32| format!("{commit:040x}"));
    let due = commits.find_map(|commit| {
        let mut ledger = Ledger::at(&path, Mode::Turns, &commit);
        ledger.is_due(case, key).then_some(ledger)
    });
    let mut ledger = due.expect("each case has its turn within some tens of commits");
    ledger.note(case, key, proof());
    ledger.complaints.iter().any(|complaint| complaint.contains("the line is false"))
}

/// Whether two figures can be of the same proof.
fn are_alike(one: f64, other: f64) -> bool {
    let (least, most) = (one.min(other), one.max(other));
    one == other || (least.is_finite() && most.is_finite() && most <= (ALIKE * least).max(NOTHING))
}
