//! The HCBTF that is being painted: the document with its past and its file, the sample at work,
//! and the samples that the rules fill.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime};

use chiaro_locale::{Text, text, tr};
use serde_json::{Value as Json, json};

use super::home::Home;
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, HcbtfEdit, History, Rule, Tile};
use crate::files::{Files, write_atomic};
use crate::frame::{Overlay, OverlayVersion};
use crate::hcbtf::{self, FilledSamples, Provenance};
use crate::state::document::{FileDocument, FileRefusals, OnDisk, OpenDocument};
use crate::state::paths::absolute;
use crate::state::revision::{GestureId, PaintingNumber, PaintingRevision, StepTime};

/// Sharpness of the blend of a new HCBTF, which is filled from the first stroke on: painted samples
/// are blended over all lights and views.
const FIRST_SHARPNESS: f64 = 4.0;

/// Largest number of texels in all samples for which the rules run while a stroke goes on, and not
/// only after it.
const MOST_LIVE: u64 = 1 << 22;

/// Display name of a new HCBTF.
const NEW: Text = text!("New painted surface");
/// Suffix to the name of an example, for a copy of it, as names are kept.
const COPY: &str = " (copy of the example)";

/// Color that a sample is marked with, and its share in the marked sample.
const MARK: [f64; 3] = [255.0, 0.0, 190.0];
const MARKED: f64 = 0.6;

/// Counter of revisions and document numbers: every number is given once.
static NUMBERS: AtomicU64 = AtomicU64::new(1);

fn next_revision() -> PaintingRevision {
    PaintingRevision(NUMBERS.fetch_add(1, Ordering::Relaxed))
}

fn next_number() -> PaintingNumber {
    PaintingNumber(NUMBERS.fetch_add(1, Ordering::Relaxed))
}

/// Origin of a sample, as the map shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SampleState {
    /// Painted by hand.
    Painted,
    /// Filled by the rule of this index.
    Filled(usize),
    /// Neither painted nor filled.
    Empty,
}

/// Time of a file's last change, and its length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FileStamp {
    modified: SystemTime,
    bytes: u64,
}

impl FileStamp {
    /// Stamp of a file at present.
    fn of(path: &Path) -> Option<Self> {
        let data = std::fs::metadata(path).ok()?;
        Some(Self { modified: data.modified().ok()?, bytes: data.len() })
    }

    /// Stamp for a journal: nanoseconds since 1970, and bytes.
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
    const REFUSALS: FileRefusals = FileRefusals::OF_FILE;

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
    /// Display name while there is no file; empty for a new HCBTF.
    title: String,
    /// Example that this HCBTF is a copy of.
    example: Option<PathBuf>,
    /// The look that the HCBTF was seen in, once another look was opened.
    home: Option<Home>,
    /// The sample at work.
    at: Address,
    /// The sample that was at work before.
    before: Address,
    /// The stroke that goes on: its sample as shown now.
    live: Option<(Address, Arc<Tile>)>,
    /// The HCBTF as shown, the stroke that goes on included.
    shown: Arc<Hcbtf>,
    filled: Option<Arc<FilledSamples>>,
    /// Tile that the rules made of one sample, ahead of the rest.
    ahead: Option<(Address, Arc<Tile>)>,
    /// The sample that shaders see marked.
    marked: Option<Address>,
    /// Revision of the picture: changes whenever shaders see something else.
    revision: PaintingRevision,
    /// Number of the document, different for each one opened.
    number: PaintingNumber,
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
            revision: next_revision(),
            number: next_number(),
        }
    }

    /// A new HCBTF without painted samples. Its rules blend painted samples over all directions,
    /// until they are changed.
    pub(crate) fn new(grid: Grid) -> Self {
        let rules = vec![Rule::Blend { sharpness: FIRST_SHARPNESS }];
        Self::with(Hcbtf { rules, ..Hcbtf::new(grid) }, None)
    }

    /// An HCBTF made from pictures of other programs, with warnings about them; no file holds it.
    pub(crate) fn imported(hcbtf: Hcbtf, notes: Vec<Diagnostic>) -> Self {
        let mut work = Self::with(hcbtf, None);
        work.document.history.mark_unsaved();
        work.document.load_problems = notes;
        work
    }

    /// The HCBTF in a file; of an example, a copy that no file holds.
    ///
    /// # Errors
    /// Problems that keep the file from being used.
    pub(crate) fn open(files: &dyn Files, path: &Path) -> Result<Self, Vec<Diagnostic>> {
        let (hcbtf, notes) = hcbtf::load(files, path)?.into_parts();
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

    /// Saves to a file, which is the HCBTF's own from then on.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub(crate) fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let path = absolute(path);
        self.document.check_saving(&path)?;
        let bytes = hcbtf::write(self.hcbtf())
            .map_err(|problem| problem.in_file(path.display().to_string()))?;
        write_atomic(&path, &bytes)?;
        let file = FileStamp::of(&path);
        self.document.was_written(path, file);
        self.revision = next_revision();
        self.saved();
        Ok(())
    }

    /// Compares the file with its state when it was last read or written.
    pub(crate) fn on_disk(&self) -> OnDisk<()> {
        self.document.on_disk()
    }

    /// Takes another program's version of the file, as one step that can be undone. `now` is the
    /// time of the step. Returns true if the HCBTF changed.
    ///
    /// # Errors
    /// Problems that keep the file from being read; nothing is changed then.
    pub(crate) fn reload(
        &mut self,
        files: &dyn Files,
        now: StepTime,
    ) -> Result<bool, Vec<Diagnostic>> {
        let Some(path) = self.document.path.clone() else { return Ok(false) };
        // The stamp is taken before reading: a change in between is noticed the next time.
        let read = FileStamp::of(&path);
        let (hcbtf, notes) = hcbtf::load(files, &path)?.into_parts();
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

    /// Lets saving write over another program's version of the file, or write the file again where
    /// it is gone.
    pub(crate) fn keep_mine(&mut self) {
        self.document.file = self.document.path.as_deref().and_then(FileStamp::of);
        self.note_file();
    }

    /// The document, without a stroke that goes on.
    pub fn hcbtf(&self) -> &Hcbtf {
        self.document.history.document()
    }

    /// Grid of the HCBTF: its division into lights, views and texels.
    pub(crate) fn grid(&self) -> &Grid {
        &self.document.history.document().grid
    }

    /// File of the HCBTF, once there is one.
    pub fn path(&self) -> Option<&Path> {
        self.document.path.as_deref()
    }

    /// Display name of the HCBTF.
    pub(crate) fn name(&self) -> String {
        match (self.document.path.is_some(), self.title.strip_suffix(COPY)) {
            (false, None) if self.title.is_empty() => NEW.tr().to_owned(),
            (false, Some(example)) => tr!("{example} (copy of the example)"),
            _ => self.kept_name(),
        }
    }

    /// Name of the HCBTF for looks and journals, which keep it in English.
    pub(crate) fn kept_name(&self) -> String {
        match self.document.path.as_ref().and_then(|path| path.file_name()) {
            Some(name) => name.to_string_lossy().into_owned(),
            None if self.title.is_empty() => NEW.english().to_owned(),
            None => self.title.clone(),
        }
    }

    /// Sets the display name for as long as there is no file.
    pub(crate) fn set_title(&mut self, title: &str) {
        self.title = if title == NEW.english() { String::new() } else { title.to_owned() };
    }

    /// Example that this HCBTF is a copy of, as long as it has no file.
    pub(crate) fn example(&self) -> Option<&Path> {
        self.example.as_deref().filter(|_| self.document.path.is_none())
    }

    /// The look that the HCBTF was seen in before another look was opened.
    pub(crate) fn home(&self) -> Option<&Home> {
        self.home.as_ref()
    }

    /// The look of `home`, to rename HCBTFs in.
    pub(crate) fn home_mut(&mut self) -> Option<&mut Home> {
        self.home.as_mut()
    }

    /// Remembers the look that the HCBTF is seen in.
    pub(crate) fn set_home(&mut self, home: Home) {
        self.home = Some(home);
    }

    /// Default name of the file to save to.
    pub(crate) fn suggested(&self) -> String {
        let name = self.title.strip_suffix(COPY).unwrap_or(&self.title);
        format!("{}.hcbtf", if name.is_empty() { "surface" } else { name })
    }

    /// True if there are changes that no file holds.
    pub fn is_dirty(&self) -> bool {
        self.document.is_dirty()
    }

    /// Gives up unsaved changes: they are no longer asked about.
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

    /// Moves on to work at another sample.
    pub fn go_to(&mut self, address: Address) {
        let address = address.canonical();
        if address != self.at && self.grid().contains(address) {
            self.before = std::mem::replace(&mut self.at, address);
        }
    }

    /// The tile of a sample as shown: painted, being painted, or filled.
    pub(crate) fn tile(&self, address: Address) -> Option<&Arc<Tile>> {
        let filled = || {
            self.filled
                .as_ref()
                .filter(|_| self.state(address) != SampleState::Empty)?
                .tile(address)
        };
        let ahead = || {
            self.ahead.as_ref().filter(|(at, _)| *at == address.canonical()).map(|(_, tile)| tile)
        };
        self.shown.painted(address).or_else(ahead).or_else(filled)
    }

    /// The tile of a sample as shown with `stroke`, or with none, in place of the stroke that goes
    /// on.
    pub(crate) fn tile_with<'t>(
        &'t self,
        stroke: Option<&'t (Address, Arc<Tile>)>,
        address: Address,
    ) -> Option<&'t Arc<Tile>> {
        let at = address.canonical();
        let stroke = stroke.filter(|(over, _)| over.canonical() == at).map(|(_, tile)| tile);
        let ahead = || self.ahead.as_ref().filter(|(over, _)| *over == at).map(|(_, tile)| tile);
        let is_filled = |filled: &&Arc<FilledSamples>| {
            matches!(filled.provenance(address), Some(Provenance::Filled { .. }))
        };
        let filled = || self.filled.as_ref().filter(is_filled)?.tile(address);
        stroke.or_else(|| self.hcbtf().painted(address)).or_else(ahead).or_else(filled)
    }

    /// The HCBTF as shown with `stroke`, or with none, in place of the stroke that goes on.
    pub(crate) fn hcbtf_with(&self, stroke: Option<&(Address, Arc<Tile>)>) -> Hcbtf {
        let mut hcbtf = self.hcbtf().clone();
        if let Some((address, tile)) = stroke {
            hcbtf.painted.insert(address.canonical(), tile.clone());
        }
        hcbtf
    }

    /// Origin of a sample.
    pub(crate) fn state(&self, address: Address) -> SampleState {
        if self.shown.painted(address).is_some() {
            return SampleState::Painted;
        }
        match self.filled.as_ref().and_then(|filled| filled.provenance(address)) {
            Some(Provenance::Filled { by, .. }) => SampleState::Filled(*by),
            _ => SampleState::Empty,
        }
    }

    /// The samples that the rules filled, as far as they are known.
    pub(crate) fn filled(&self) -> Option<&Arc<FilledSamples>> {
        self.filled.as_ref()
    }

    /// The HCBTF as shown, for the thread that fills it.
    pub(crate) fn shown(&self) -> &Arc<Hcbtf> {
        &self.shown
    }

    /// Takes the samples that the rules filled.
    pub(crate) fn set_filled(&mut self, filled: Arc<FilledSamples>) {
        (self.filled, self.ahead) = (Some(filled), None);
        self.revision = next_revision();
    }

    /// Takes the tile that the rules made of one sample, until they have made the rest.
    pub(crate) fn set_ahead(&mut self, address: Address, tile: Arc<Tile>) {
        self.ahead = Some((address, tile));
        self.revision = next_revision();
    }

    /// Revision of the picture: changes whenever shaders see something else.
    pub(crate) fn revision(&self) -> PaintingRevision {
        self.revision
    }

    /// Number of the document, different for each one opened.
    pub(crate) fn number(&self) -> PaintingNumber {
        self.number
    }

    /// The HCBTF that shaders see in place of the file.
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
            version: OverlayVersion(self.revision.0),
            hcbtf,
            filled: self.filled.clone(),
        }
    }

    /// Marks a sample for shaders, or none. Returns true if the marked sample changed.
    pub(crate) fn set_marked(&mut self, marked: Option<Address>) -> bool {
        let is_other = self.marked != marked;
        if is_other {
            self.marked = marked;
            self.revision = next_revision();
        }
        is_other
    }

    /// True while a stroke goes on.
    pub(crate) fn is_live(&self) -> bool {
        self.live.is_some()
    }

    /// True if the rules wait until the stroke that goes on is done: they would take all cores from
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
        self.revision = next_revision();
    }

    /// Ends a gesture, so that the next change is a step of its own.
    pub(crate) fn end_gesture(&mut self) {
        self.document.end_gesture();
    }

    /// Applies a change. Consecutive changes of the same `gesture` are one step. `now` is the time
    /// of the step. Returns true if the HCBTF changed.
    ///
    /// # Errors
    /// A diagnostic where the change is impossible; nothing is changed then.
    pub(crate) fn apply(
        &mut self,
        change: HcbtfEdit,
        gesture: Option<GestureId>,
        now: StepTime,
    ) -> Result<bool, Box<Diagnostic>> {
        let is_changed = self.document.apply(change, gesture, now)?;
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

    pub(crate) fn redo(&mut self, now: StepTime) -> bool {
        let did = self.document.redo(now);
        if did {
            self.show();
        }
        did
    }
}

/// A tile that is plainly marked, and whose painting can still be told.
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
