//! The HCBTF that is being painted: the document with its past and its file, the sample at work,
//! and what the rules make of the rest.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime};

use serde_json::{Value as Json, json};

use super::home::Home;
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, HcbtfEdit, History, Rule, Tile};
use crate::files::write_atomic;
use crate::frame::Overlay;
use crate::hcbtf::{self, Filled, Provenance};
use crate::state::document::{FileDocument, OnDisk, OpenDocument};
use crate::state::paths::absolute;

/// A new one is filled from the first stroke on: what is painted is blended over all lights and
/// views.
const FIRST_SHARPNESS: f64 = 4.0;

/// With more texels in all samples than these, the rules run once a stroke is done, and not while
/// it goes on.
const MOST_LIVE: u64 = 1 << 22;

/// What one is called that is new.
const NEW: &str = "New HCBTF";
/// What is added to the name of an example, for a copy of it.
const COPY: &str = " (copy of the example)";

/// The color that a sample is marked with, and how much of it there is.
const MARK: [f64; 3] = [255.0, 0.0, 190.0];
const MARKED: f64 = 0.6;

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

/// When a file was written, and how long it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FileStamp {
    modified: SystemTime,
    bytes: u64,
}

impl FileStamp {
    /// Of the file there is now.
    fn of(path: &Path) -> Option<Self> {
        let data = std::fs::metadata(path).ok()?;
        Some(Self { modified: data.modified().ok()?, bytes: data.len() })
    }

    /// For a journal: nanoseconds since 1970, and bytes.
    pub(crate) fn to_json(self) -> Option<Json> {
        let since = self.modified.duration_since(SystemTime::UNIX_EPOCH).ok()?;
        Some(json!({ "modified": u64::try_from(since.as_nanos()).ok()?, "bytes": self.bytes }))
    }

    pub(crate) fn of_json(json: &Json) -> Option<Self> {
        let since = Duration::from_nanos(json.get("modified")?.as_u64()?);
        Some(Self {
            modified: SystemTime::UNIX_EPOCH.checked_add(since)?,
            bytes: json.get("bytes")?.as_u64()?,
        })
    }
}

impl FileDocument for Hcbtf {
    type FileState = Option<FileStamp>;
    type Change = ();
    const FILE: &'static str = "file";
    const SAVED: &'static str = "";

    fn on_disk(document: &OpenDocument<Self>, path: &Path) -> OnDisk<()> {
        match (document.file, FileStamp::of(path)) {
            (Some(was), Some(is)) if was != is => OnDisk::Changed(()),
            (Some(_), None) => OnDisk::Gone,
            _ => OnDisk::Same,
        }
    }
}

/// An HCBTF that is being painted.
pub struct OpenPainting {
    pub(crate) document: OpenDocument<Hcbtf>,
    /// What it is called while it has no file; empty for a new one.
    title: String,
    /// The example that it is a copy of.
    example: Option<PathBuf>,
    /// The look that it was seen in, once another one was opened.
    home: Option<Home>,
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
    /// The sample that shaders see marked.
    marked: Option<Address>,
    /// Another number is another picture.
    version: u64,
    /// Another number is another document.
    number: u64,
}

impl OpenPainting {
    fn with(hcbtf: Hcbtf, path: Option<PathBuf>) -> Self {
        Self::of_history(History::new(hcbtf), path)
    }

    pub(crate) fn of_history(history: History<Hcbtf>, path: Option<PathBuf>) -> Self {
        let shown = Arc::new(history.document().clone());
        let at = shown.painted.keys().next().copied().unwrap_or_default();
        let file = path.as_deref().and_then(FileStamp::of);
        Self {
            document: OpenDocument::new(history, path, file),
            title: String::new(),
            example: None,
            home: None,
            at,
            before: at,
            live: None,
            shown,
            filled: None,
            ahead: None,
            marked: None,
            version: next_version(),
            number: next_version(),
        }
    }

    /// One that nothing is painted of. What will be painted is blended over all directions, until
    /// its rules are changed.
    pub(crate) fn new(grid: Grid) -> Self {
        let rules = vec![Rule::Blend { sharpness: FIRST_SHARPNESS }];
        Self::with(Hcbtf { rules, ..Hcbtf::new(grid) }, None)
    }

    /// One that pictures of other programs were made into, with what was odd about them; no file
    /// holds it.
    pub(crate) fn imported(hcbtf: Hcbtf, notes: Vec<Diagnostic>) -> Self {
        let mut work = Self::with(hcbtf, None);
        work.document.history.mark_unsaved();
        work.document.load_problems = notes;
        work
    }

    /// The one in a file; of an example, a copy that no file holds.
    ///
    /// # Errors
    /// Everything that keeps the file from being used.
    pub(crate) fn open(path: &Path) -> Result<Self, Vec<Diagnostic>> {
        let (hcbtf, notes) = hcbtf::load(path)?;
        if crate::examples::file(path).is_some() {
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            let (title, example) = (format!("{name}{COPY}"), Some(path.to_owned()));
            let mut work = Self { title, example, ..Self::with(hcbtf, None) };
            work.document.load_problems = notes;
            return Ok(work);
        }
        let mut work = Self::with(hcbtf, Some(absolute(path)));
        work.document.load_problems = notes;
        Ok(work)
    }

    /// Saves to a file, which is its own from then on.
    ///
    /// # Errors
    /// A diagnostic that says why not; the old file is then as it was.
    pub(crate) fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let path = absolute(path);
        self.document.check_saving(&path)?;
        let bytes = hcbtf::write(self.hcbtf())
            .map_err(|problem| problem.in_file(path.display().to_string()))?;
        write_atomic(&path, &bytes)?;
        let file = FileStamp::of(&path);
        self.document.was_written(path, file);
        self.version = next_version();
        self.saved();
        Ok(())
    }

    /// Compares the file with what it was when it was read or written last.
    pub(crate) fn on_disk(&self) -> OnDisk<()> {
        self.document.on_disk()
    }

    /// Takes what another program made of the file, as one step that can be undone. `now` is when.
    /// Returns whether anything is another now.
    ///
    /// # Errors
    /// What keeps the file from being read; everything stays as it is then.
    pub(crate) fn reload(&mut self, now: u64) -> Result<bool, Vec<Diagnostic>> {
        let Some(path) = self.document.path.clone() else { return Ok(false) };
        // Taken before it is read: what comes in between is noticed the next time.
        let read = FileStamp::of(&path);
        let (hcbtf, notes) = hcbtf::load(&path)?;
        let is_other = hcbtf != *self.hcbtf();
        if is_other {
            let change = HcbtfEdit::Replace { hcbtf: Box::new(hcbtf) };
            self.apply(change, None, now).map_err(|problem| vec![*problem])?;
        }
        self.document.file = read;
        self.document.load_problems = notes;
        self.document.history.mark_saved();
        self.saved();
        Ok(is_other)
    }

    /// Lets saving write over what another program made of the file, or write it again where it is
    /// gone.
    pub(crate) fn keep_mine(&mut self) {
        self.document.file = self.document.path.as_deref().and_then(FileStamp::of);
        self.note_file();
    }

    /// The document as it is, without a stroke that goes on.
    pub fn hcbtf(&self) -> &Hcbtf {
        self.document.history.document()
    }

    /// How finely it is divided.
    pub(crate) fn grid(&self) -> &Grid {
        &self.document.history.document().grid
    }

    /// The file, once there is one.
    pub fn path(&self) -> Option<&Path> {
        self.document.path.as_deref()
    }

    /// What people call it.
    pub(crate) fn name(&self) -> String {
        match self.document.path.as_ref().and_then(|path| path.file_name()) {
            Some(name) => name.to_string_lossy().into_owned(),
            None if self.title.is_empty() => NEW.to_owned(),
            None => self.title.clone(),
        }
    }

    /// Goes by a name while it has no file.
    pub(crate) fn set_title(&mut self, title: &str) {
        self.title = if title == NEW { String::new() } else { title.to_owned() };
    }

    /// The example that it is a copy of, as long as it has no file.
    pub(crate) fn example(&self) -> Option<&Path> {
        self.example.as_deref().filter(|_| self.document.path.is_none())
    }

    /// The look that it was seen in before another one was opened.
    pub(crate) fn home(&self) -> Option<&Home> {
        self.home.as_ref()
    }

    /// The same, to be named otherwise.
    pub(crate) fn home_mut(&mut self) -> Option<&mut Home> {
        self.home.as_mut()
    }

    /// Remembers the look that it is seen in.
    pub(crate) fn set_home(&mut self, home: Home) {
        self.home = Some(home);
    }

    /// What its file is to be called, if nobody says otherwise.
    pub(crate) fn suggested(&self) -> String {
        let name = self.title.strip_suffix(COPY).unwrap_or(&self.title);
        format!("{}.hcbtf", if name.is_empty() { "surface" } else { name })
    }

    /// Whether there are changes that no file holds.
    pub fn is_dirty(&self) -> bool {
        self.document.is_dirty()
    }

    /// Lets unsaved changes go: they are no longer asked about.
    pub(crate) fn give_up_changes(&mut self) {
        self.document.history.mark_saved();
    }

    pub(crate) fn history(&self) -> &History<Hcbtf> {
        &self.document.history
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
        let filled =
            || self.filled.as_ref().filter(|_| self.state(address) != State::Empty)?.tile(address);
        let ahead = || {
            self.ahead.as_ref().filter(|(at, _)| *at == address.canonical()).map(|(_, tile)| tile)
        };
        self.shown.painted(address).or_else(ahead).or_else(filled)
    }

    /// A sample as it is shown with this stroke, or none, in place of the one that goes on.
    pub(crate) fn tile_with<'t>(
        &'t self,
        stroke: Option<&'t (Address, Arc<Tile>)>,
        address: Address,
    ) -> Option<&'t Arc<Tile>> {
        let at = address.canonical();
        let stroke = stroke.filter(|(over, _)| over.canonical() == at).map(|(_, tile)| tile);
        let ahead = || self.ahead.as_ref().filter(|(over, _)| *over == at).map(|(_, tile)| tile);
        let is_filled = |filled: &&Arc<Filled>| {
            matches!(filled.provenance(address), Some(Provenance::Filled { .. }))
        };
        let filled = || self.filled.as_ref().filter(is_filled)?.tile(address);
        stroke.or_else(|| self.hcbtf().painted(address)).or_else(ahead).or_else(filled)
    }

    /// Everything as it is shown with this stroke, or none, in place of the one that goes on.
    pub(crate) fn hcbtf_with(&self, stroke: Option<&(Address, Arc<Tile>)>) -> Hcbtf {
        let mut hcbtf = self.hcbtf().clone();
        if let Some((address, tile)) = stroke {
            hcbtf.painted.insert(address.canonical(), tile.clone());
        }
        hcbtf
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
        let mut hcbtf = self.shown.clone();
        if let Some(address) = self.marked.filter(|address| self.grid().contains(*address)) {
            let tile = self
                .tile(address)
                .map_or_else(|| Tile::filled(self.grid().size, [0; 4]), |tile| (**tile).clone());
            Arc::make_mut(&mut hcbtf).painted.insert(address, Arc::new(tinted(tile)));
        }
        Overlay {
            path: self.document.path.clone(),
            version: self.version,
            hcbtf,
            filled: self.filled.clone(),
        }
    }

    /// Marks a sample for shaders, or none. Returns whether they see another one now.
    pub(crate) fn set_marked(&mut self, marked: Option<Address>) -> bool {
        let is_other = self.marked != marked;
        if is_other {
            self.marked = marked;
            self.version = next_version();
        }
        is_other
    }

    /// Whether a stroke goes on.
    pub(crate) fn is_live(&self) -> bool {
        self.live.is_some()
    }

    /// Whether the rules wait until the stroke that goes on is done: they would take all cores from
    /// it.
    pub(crate) fn rules_wait(&self) -> bool {
        let texels = self.grid().sample_count() * self.grid().texels() as u64;
        self.is_live() && texels > MOST_LIVE
    }

    /// Shows a stroke that goes on, or none.
    pub(crate) fn set_live(&mut self, live: Option<(Address, Arc<Tile>)>) {
        if self.live.is_some() || live.is_some() {
            self.live = live;
            self.show();
        }
    }

    fn show(&mut self) {
        let hcbtf = self.hcbtf_with(self.live.as_ref());
        if !hcbtf.grid.contains(self.at) {
            self.at = Address::default();
        }
        if self.filled.as_ref().is_some_and(|filled| filled.grid() != hcbtf.grid) {
            self.filled = None;
        }
        self.shown = Arc::new(hcbtf);
        self.version = next_version();
    }

    /// Breaks a gesture, so that whatever comes next is a step of its own.
    pub(crate) fn end_gesture(&mut self) {
        self.document.end_gesture();
    }

    /// Applies a change. With a `hand`, consecutive changes by it are one step. `now` is when.
    /// Returns whether anything is another now.
    ///
    /// # Errors
    /// A diagnostic where the change is impossible; nothing is changed then.
    pub(crate) fn apply(
        &mut self,
        change: HcbtfEdit,
        hand: Option<u64>,
        now: u64,
    ) -> Result<bool, Box<Diagnostic>> {
        let is_changed = self.document.apply(change, hand, now)?;
        self.live = None;
        self.show();
        Ok(is_changed)
    }

    pub(crate) fn undo(&mut self) -> bool {
        let did = self.document.undo();
        if did {
            self.show();
        }
        did
    }

    pub(crate) fn redo(&mut self, now: u64) -> bool {
        let did = self.document.redo(now);
        if did {
            self.show();
        }
        did
    }
}

/// A tile that is plainly marked, and in which what is painted can still be told.
fn tinted(mut tile: Tile) -> Tile {
    for texel in tile.bytes_mut().as_chunks_mut::<4>().0 {
        let [r, g, b, a] = *texel;
        let seen = f64::from(a) / 255.0;
        let mixed = [r, g, b].into_iter().zip(MARK).map(|(own, mark)| {
            let own = f64::from(own) * seen + mark * (1.0 - seen);
            (own + (mark - own) * MARKED).round() as u8
        });
        texel.iter_mut().zip(mixed.chain([a.max(200)])).for_each(|(texel, mixed)| *texel = mixed);
    }
    tile
}
