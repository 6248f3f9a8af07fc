//! The HCBTF that is being painted: the document with its past and its file, the sample at work, and what the rules make of
//! the rest.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::SystemTime;

use crate::diag::Diagnostic;
use crate::document::journal::Op;
use crate::document::{Address, Grid, Hcbtf, HcbtfEdit, History, Rule, Tile, write_atomic};
use crate::editor::session::keeping::Keeping;
use crate::editor::session::times::{Gestures, Times};
use crate::frame::Overlay;
use crate::hcbtf::{self, Filled, Provenance};

/// A new one is filled from the first stroke on: what is painted is blended over all lights and views.
const FIRST_SHARPNESS: f64 = 4.0;

/// Numbers of what is shown, each of something else.
static VERSIONS: AtomicU64 = AtomicU64::new(1);

fn next_version() -> u64 {
    VERSIONS.fetch_add(1, Ordering::Relaxed)
}

/// How a sample came about, as the map tells it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum State {
    /// Somebody painted it.
    Painted,
    /// This rule filled it.
    Filled(usize),
    /// Nothing is there.
    Empty,
}

/// An HCBTF that is being painted.
pub struct Work {
    history: History<Hcbtf>,
    pub(crate) times: Times,
    gestures: Gestures,
    path: Option<PathBuf>,
    /// When the file was written that this was read from or saved to, and how long it was.
    stamp: Option<(SystemTime, u64)>,
    /// What reading the file told.
    pub(crate) load_problems: Vec<Diagnostic>,
    /// The sample at work.
    at: Address,
    /// The one that was at work before.
    before: Address,
    /// The stroke that goes on: its sample as it looks now.
    live: Option<(Address, Arc<Tile>)>,
    /// Everything as it is shown, the stroke that goes on included.
    shown: Arc<Hcbtf>,
    filled: Option<Arc<Filled>>,
    /// What the rules made of one sample, ahead of the rest.
    ahead: Option<(Address, Arc<Tile>)>,
    /// Another number is another picture.
    version: u64,
    /// Another number is another document.
    number: u64,
    pub(super) keeping: Keeping<Hcbtf>,
}

impl Work {
    fn with(hcbtf: Hcbtf, path: Option<PathBuf>) -> Self {
        Self::of_history(History::new(hcbtf), path)
    }

    pub(super) fn of_history(history: History<Hcbtf>, path: Option<PathBuf>) -> Self {
        let shown = Arc::new(history.document().clone());
        let at = shown.painted.keys().next().copied().unwrap_or_default();
        let mut times = Times::default();
        times.fit(history.steps());
        Self {
            history,
            times,
            gestures: Gestures::default(),
            stamp: path.as_deref().and_then(stamp),
            path,
            load_problems: Vec::new(),
            at,
            before: at,
            live: None,
            shown,
            filled: None,
            ahead: None,
            version: next_version(),
            number: next_version(),
            keeping: Keeping::default(),
        }
    }

    /// One that nothing is painted of. What will be painted is blended over all directions, until its rules are changed.
    pub(crate) fn new(grid: Grid) -> Self {
        let rules = vec![Rule::Blend { sharpness: FIRST_SHARPNESS }];
        Self::with(Hcbtf { rules, ..Hcbtf::new(grid) }, None)
    }

    /// The one in a file.
    ///
    /// # Errors
    /// Everything that keeps the file from being used.
    pub(crate) fn open(path: &Path) -> Result<Self, Vec<Diagnostic>> {
        let (hcbtf, notes) = hcbtf::load(path)?;
        let mut work = Self::with(hcbtf, Some(std::path::absolute(path).unwrap_or_else(|_| path.to_owned())));
        work.load_problems = notes;
        Ok(work)
    }

    /// Saves to a file, which is its own from then on.
    ///
    /// # Errors
    /// A diagnostic that says why not; the old file is then as it was.
    pub(crate) fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let is_own = self.path.as_ref() == Some(&path);
        if is_own && self.stamp.is_some() && stamp(&path).is_some_and(|now| Some(now) != self.stamp) {
            let message = "another program has changed this file since it was opened, and nothing was written over it";
            let problem = Diagnostic::error("changed-on-disk", message);
            return Err(Box::new(problem.hint("save under another name, and open the other version beside it")));
        }
        let bytes = hcbtf::write(self.hcbtf()).map_err(|problem| problem.in_file(path.display().to_string()))?;
        write_atomic(&path, &bytes)?;
        self.stamp = stamp(&path);
        self.path = Some(path);
        self.load_problems.clear();
        self.history.mark_saved();
        self.version = next_version();
        self.saved();
        Ok(())
    }

    /// The document as it is, without a stroke that goes on.
    pub fn hcbtf(&self) -> &Hcbtf {
        self.history.document()
    }

    /// How finely it is divided.
    pub(crate) fn grid(&self) -> &Grid {
        &self.history.document().grid
    }

    /// The file, once there is one.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// What people call it.
    pub(crate) fn name(&self) -> String {
        let file = self.path.as_ref().and_then(|path| path.file_name());
        file.map_or_else(|| "New HCBTF".to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// Whether there are changes that no file holds.
    pub fn is_dirty(&self) -> bool {
        !self.history.is_saved()
    }

    /// Lets unsaved changes go: they are no longer asked about.
    pub(crate) fn give_up_changes(&mut self) {
        self.history.mark_saved();
    }

    pub(crate) fn history(&self) -> &History<Hcbtf> {
        &self.history
    }

    /// The sample at work.
    pub fn at(&self) -> Address {
        self.at
    }

    /// The sample that was at work before.
    pub(crate) fn before(&self) -> Address {
        self.before
    }

    /// Works at another sample.
    pub fn go_to(&mut self, address: Address) {
        let address = address.canonical();
        if address != self.at && self.grid().contains(address) {
            self.before = std::mem::replace(&mut self.at, address);
        }
    }

    /// The tile of a sample as it is shown: painted, being painted, or filled.
    pub(crate) fn tile(&self, address: Address) -> Option<&Arc<Tile>> {
        let filled = || self.filled.as_ref().filter(|_| self.state(address) != State::Empty)?.tile(address);
        let ahead = || self.ahead.as_ref().filter(|(at, _)| *at == address.canonical()).map(|(_, tile)| tile);
        self.shown.painted(address).or_else(ahead).or_else(filled)
    }

    /// How a sample came about.
    pub(crate) fn state(&self, address: Address) -> State {
        if self.shown.painted(address).is_some() {
            return State::Painted;
        }
        match self.filled.as_ref().and_then(|filled| filled.provenance(address)) {
            Some(Provenance::Filled { by, .. }) => State::Filled(*by),
            _ => State::Empty,
        }
    }

    /// What the rules made of the rest, as far as that is known.
    pub(crate) fn filled(&self) -> Option<&Arc<Filled>> {
        self.filled.as_ref()
    }

    /// Everything as it is shown, for who fills it.
    pub(crate) fn shown(&self) -> &Arc<Hcbtf> {
        &self.shown
    }

    /// Takes what the rules made.
    pub(crate) fn set_filled(&mut self, filled: Arc<Filled>) {
        (self.filled, self.ahead) = (Some(filled), None);
        self.version = next_version();
    }

    /// Takes what the rules made of one sample, until they have made the rest.
    pub(crate) fn set_ahead(&mut self, address: Address, tile: Arc<Tile>) {
        self.ahead = Some((address, tile));
        self.version = next_version();
    }

    /// Another number is another picture.
    pub(crate) fn version(&self) -> u64 {
        self.version
    }

    /// Another number is another document.
    pub(crate) fn number(&self) -> u64 {
        self.number
    }

    /// What shaders see in place of the file.
    pub(crate) fn overlay(&self) -> Overlay {
        Overlay {
            path: self.path.clone(),
            version: self.version,
            hcbtf: self.shown.clone(),
            filled: self.filled.clone(),
        }
    }

    /// Shows a stroke that goes on, or none.
    pub(crate) fn set_live(&mut self, live: Option<(Address, Arc<Tile>)>) {
        if self.live.is_some() || live.is_some() {
            self.live = live;
            self.show();
        }
    }

    fn show(&mut self) {
        let mut hcbtf = self.hcbtf().clone();
        if let Some((address, tile)) = &self.live {
            hcbtf.painted.insert(address.canonical(), tile.clone());
        }
        self.shown = Arc::new(hcbtf);
        self.version = next_version();
    }

    /// Breaks a gesture, so that whatever comes next is a step of its own.
    pub(crate) fn end_gesture(&mut self) {
        self.gestures.end();
    }

    /// Applies a change. With a `hand`, consecutive changes by it are one step. `now` is when. Returns whether anything
    /// is another now.
    ///
    /// # Errors
    /// A diagnostic where the change is impossible; nothing is changed then.
    pub(crate) fn apply(&mut self, change: HcbtfEdit, hand: Option<u64>, now: u64) -> Result<bool, Box<Diagnostic>> {
        let before = self.history.revision();
        let kept = self.keeping.is_on().then(|| change.clone());
        let gesture = hand.map(|hand| self.gestures.of(hand, before));
        match gesture {
            Some(gesture) => self.history.apply_in(gesture, change)?,
            None => self.history.apply(change)?,
        }
        self.gestures.did(hand, self.history.revision());
        let is_changed = self.history.revision() != before;
        if is_changed {
            self.times.did(self.history.steps(), now);
            self.keeping.note(kept.map(|edit| Op::Edit { gesture, edit }));
        }
        self.live = None;
        self.show();
        Ok(is_changed)
    }

    pub(crate) fn undo(&mut self) -> bool {
        let did = self.history.undo().is_some();
        if did {
            self.times.undid();
            self.keeping.note(Some(Op::Undo));
            self.show();
        }
        did
    }

    pub(crate) fn redo(&mut self, now: u64) -> bool {
        let did = self.history.redo().is_some();
        if did {
            self.times.redid(now);
            self.keeping.note(Some(Op::Redo));
            self.show();
        }
        did
    }
}

fn stamp(path: &Path) -> Option<(SystemTime, u64)> {
    let data = std::fs::metadata(path).ok()?;
    Some((data.modified().ok()?, data.len()))
}
