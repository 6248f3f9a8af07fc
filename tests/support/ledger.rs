//! Ledgers of long sweeps, `tests/ledger/NAME.txt`: proofs are remembered, so that no case is
//! proved twice.
//!
//! A long sweep is a list of cases. The key of a case is a hash of everything that its verdict
//! depends on: the modules that it draws, their meshes and inputs, the source of the engines that
//! judge it (see [`judges`](crate::judges)), and the driver. The ledger keeps a line a case, `KEY
//! FIGURE CASE`: the figure is the result of the proof, mostly the largest error. A case whose key
//! differs from its line's is proved anew; of the rest a tenth is, chosen by the commit, so that
//! each line is checked within ten or so commits. A false line is found then: the new figure is
//! held against the line's.
//!
//! `CHIARO_LEDGER=write` writes the lines of the proved cases; `CHIARO_LEDGER=all` proves all
//! cases, as `scripts/soak` does.

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;
use std::hash::Hasher as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, PoisonError};
use std::{env, fs};

use siphasher::sip128::{Hasher128 as _, SipHasher13};

use crate::{files, root};

/// Number of commits within which each case is proved anew, on average.
const COMMITS_PER_PROOF: u64 = 10;
/// Factor up to which the figures of two proofs of one case are alike: drivers vectorize for the
/// processor that they find.
const ALIKE_FACTOR: f64 = 2.0;
/// Figure below which all figures count as alike: three units in the last place of 1.
const ALIKE_BELOW: f64 = 4e-7;

/// Hash of everything that a verdict depends on.
#[derive(Clone)]
pub struct ProofKey(SipHasher13);

impl ProofKey {
    /// Key of a verdict that depends on the sources under these folders of the project alone,
    /// without comments.
    pub fn of_sources(folders: &[&str]) -> Self {
        Self::of_sources_in(root(), folders)
    }

    /// Key of the sources under these folders of `root`.
    pub fn of_sources_in(root: &Path, folders: &[&str]) -> Self {
        let mut key = Self(SipHasher13::new());
        for folder in folders {
            key.add(&source_hash(&root.join(folder)).to_le_bytes());
        }
        key
    }

    /// Adds bytes that the verdict depends on too.
    pub fn add(&mut self, bytes: &[u8]) {
        self.0.write_usize(bytes.len());
        self.0.write(bytes);
    }

    /// A copy of the key with a source added, without blank lines and lines that are comments
    /// alone.
    pub fn with_source(&self, text: &str) -> Self {
        self.with(code(text).as_bytes())
    }

    /// A copy of the key with more bytes added.
    pub fn with(&self, bytes: &[u8]) -> Self {
        let mut key = self.clone();
        key.add(bytes);
        key
    }

    /// The key as a ledger holds it: 32 hexadecimal digits.
    pub fn text(&self) -> String {
        format!("{:032x}", self.0.finish128().as_u128())
    }
}

/// Hash of the lines of code of a file or of a folder's sources; remembered for sources of this
/// project.
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

/// A source's lines of code: no blank lines and no lines that are comments alone.
fn code(text: &str) -> String {
    let lines =
        text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//"));
    lines.fold(String::new(), |all, line| all + line + "\n")
}

/// A line of a ledger, without the name of its case.
#[derive(Clone, Debug, PartialEq)]
struct LedgerRow {
    key: String,
    figure: f64,
}

/// The cases of a ledger that are proved anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProofMode {
    /// Cases with another key, and cases whose turn has come in this commit.
    Turns,
    /// All cases.
    All,
    /// Cases with another key; the ledger is then written.
    Write,
}

/// A ledger in use: the lines of its file, and the results of this run.
pub struct Ledger {
    path: PathBuf,
    mode: ProofMode,
    /// The commit's hash, which chooses the cases whose turn has come.
    commit: String,
    known: BTreeMap<String, LedgerRow>,
    now: BTreeMap<String, LedgerRow>,
    proved: usize,
    stand: usize,
    /// Complaints about cases that were proved and about false lines.
    pub complaints: Vec<String>,
}

impl Ledger {
    /// Opens the project's ledger of a sweep.
    pub fn open(name: &str) -> Self {
        let root = root();
        let mode = match env::var("CHIARO_LEDGER").as_deref() {
            Ok("all") => ProofMode::All,
            Ok("write") => ProofMode::Write,
            _ => ProofMode::Turns,
        };
        let head = Command::new("git").args(["rev-parse", "HEAD"]).current_dir(root).output();
        let commit = head
            .map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
            .unwrap_or_default();
        Self::at(&root.join("tests/ledger").join(format!("{name}.txt")), mode, &commit)
    }

    /// Opens the ledger in a file, as at a commit.
    pub fn at(path: &Path, mode: ProofMode, commit: &str) -> Self {
        let text = fs::read_to_string(path).unwrap_or_default();
        let row = |line: &str| {
            let mut parts = line.splitn(3, ' ');
            let (key, figure, case) = (parts.next()?, parts.next()?, parts.next()?);
            Some((case.to_owned(), LedgerRow { key: key.to_owned(), figure: figure.parse().ok()? }))
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

    /// True if a case has to be proved; if not, its line stands.
    pub fn is_due(&mut self, case: &str, key: &ProofKey) -> bool {
        let Some(row) = self.known.get(case).filter(|row| row.key == key.text()) else {
            return true;
        };
        let is_due = match self.mode {
            ProofMode::All => true,
            ProofMode::Write => false,
            ProofMode::Turns => self.has_turn(case),
        };
        if !is_due {
            self.stand += 1;
            self.now.insert(case.to_owned(), row.clone());
        }
        is_due
    }

    /// True if this commit proves a case anew even where its key is unchanged.
    fn has_turn(&self, case: &str) -> bool {
        let mut hasher = SipHasher13::new();
        hasher.write(self.commit.as_bytes());
        hasher.write(case.as_bytes());
        hasher.finish128().h1.is_multiple_of(COMMITS_PER_PROOF)
    }

    /// Notes the result of a proof of a case: its figure, or a complaint.
    pub fn note(&mut self, case: &str, key: &ProofKey, proof: Result<f64, String>) {
        self.proved += 1;
        let figure = match proof {
            Ok(figure) => figure,
            Err(complaint) => {
                self.complaints.push(format!("{case}: {complaint}"));
                return;
            }
        };
        let row = LedgerRow { key: key.text(), figure };
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
    pub fn prove(
        &mut self,
        case: &str,
        key: &ProofKey,
        proof: impl FnOnce() -> Result<f64, String>,
    ) {
        if self.is_due(case, key) {
            let proof = proof();
            self.note(case, key, proof);
        }
    }

    /// The figure of each case of this run: proved now, or taken from its line.
    pub fn figures(&self) -> impl Iterator<Item = (&str, f64)> {
        self.now.iter().map(|(case, row)| (case.as_str(), row.figure))
    }

    /// Number of cases proved anew, and number of cases whose lines stand.
    pub fn counts(&self) -> [usize; 2] {
        [self.proved, self.stand]
    }

    /// Writes the ledger in `ProofMode::Write`, and fails with all complaints.
    #[allow(clippy::print_stdout, reason = "`--nocapture` shows what was proved")]
    pub fn close(self) {
        let name = self.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let [proved, stand] = self.counts();
        println!("{name}: {proved} proved, {stand} as the ledger has them");
        if self.mode == ProofMode::Write {
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

/// True if a ledger whose only line gives `figure` to a case complains of the line in the first
/// commit that proves the case anew.
pub fn is_found_false(
    case: &str,
    key: &ProofKey,
    figure: f64,
    proof: impl FnOnce() -> Result<f64, String>,
) -> bool {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("forged.txt");
    fs::write(&path, format!("{} {figure:e} {case}\n", key.text())).expect("it can be written");
    let mut commits = (0..1000).map(|commit: u32| format!("{commit:040x}"));
    let due = commits.find_map(|commit| {
        let mut ledger = Ledger::at(&path, ProofMode::Turns, &commit);
        ledger.is_due(case, key).then_some(ledger)
    });
    let mut ledger = due.expect("each case has its turn within some tens of commits");
    ledger.note(case, key, proof());
    ledger.complaints.iter().any(|complaint| complaint.contains("the line is false"))
}

/// True if two figures can come from the same proof.
fn are_alike(one: f64, other: f64) -> bool {
    let (least, most) = (one.min(other), one.max(other));
    one == other
        || (least.is_finite()
            && most.is_finite()
            && most <= (ALIKE_FACTOR * least).max(ALIKE_BELOW))
}
