//! Journal of the edits to an unsaved document, in a file, so that neither a crash nor a full stop
//! loses the work.
//!
//! A [`Journal`] begins with the state of a [`History`] (the document, the steps that can be undone
//! and redone, and the text of its file), and every edit, undo and redo is added as one line.
//! Reading the journal applies them again, by the same code in the same order, and so comes to the
//! same history. Lines carry their number, length and checksum: an end that was cut off is
//! recognized and left out. When a journal has grown long it is begun anew.
//!
//! Journals lie in one folder, each in a [`JournalSlot`] that the program using it holds by a lock
//! of the operating system. docs/format.md describes the file.

mod line;
mod read;
mod record;
mod slot;

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, BufWriter, Seek as _, SeekFrom, Write as _};

use chiaro_locale::tr;
use serde::Serialize;

use crate::document::{History, Step};
use record::{Record, VERSION};

pub use crate::document::JournalDocument;
pub use read::{RecoveredDocument, RecoveredWork, recover, recover_any};
pub use record::{DocumentInfo, HcbtfOp, LookOp, Op, SceneOp, ShotOp};
pub use slot::{JournalSlot, left_behind};

/// Growth after which a journal is begun anew, unless its beginning was larger, in bytes.
const GROWTH: u64 = 8 << 20;
/// Greatest size of the undoable and of the redoable steps that are kept when a journal is begun,
/// in bytes; of more, the newest are kept.
const MAX_PAST: usize = 32 << 20;
/// Size of the steps that share a line, in bytes.
const STEPS_LINE: usize = 1 << 20;

/// Size of the part of the document's image in one line, in bytes.
const IMAGE_LINE: usize = 64 << 20;

/// Journal that is being written.
#[derive(Debug)]
pub struct Journal {
    file: File,
    /// Number of the next line.
    number: u64,
    /// Length of the whole lines, in bytes; whatever lies beyond was not written whole.
    size: u64,
    begun_size: u64,
    line: String,
}

impl Journal {
    /// Begins the journal of a slot with a document as it stands and all its past, in place of any
    /// earlier journal there, at once. `source` is the text of the document's file when it was read
    /// or saved last.
    ///
    /// # Errors
    /// The disk is full, or the folder cannot be written. An earlier journal stays.
    pub fn begin<D: JournalDocument>(
        slot: &JournalSlot,
        about: &DocumentInfo,
        source: Option<&str>,
        history: &History<D>,
    ) -> io::Result<Self> {
        let mut builder = tempfile::Builder::new();
        let unfinished =
            builder.prefix("new-").suffix(slot::UNFINISHED).tempfile_in(slot.folder())?;
        let mut lines =
            LineWriter { to: BufWriter::new(unfinished), number: 0, size: 0, line: String::new() };
        let numbers = history.numbers();
        lines.write::<D::Edit>(&Record::Begin {
            version: VERSION,
            kind: D::KIND.into(),
            numbers,
            about: Cow::Borrowed(about),
        })?;
        if let Some(text) = source {
            lines.write::<D::Edit>(&Record::Source { text: text.into() })?;
        }
        lines.image::<D::Edit>(&history.document().to_image()?, IMAGE_LINE)?;
        lines.steps(history.done(), |steps| Record::Done(Cow::Borrowed(steps)))?;
        lines.steps(history.undone(), |steps| Record::Undone(Cow::Borrowed(steps)))?;
        lines.write::<D::Edit>(&Record::Ready)?;
        let LineWriter { to, number, size, line } = lines;
        let unfinished = to.into_inner().map_err(io::IntoInnerError::into_error)?;
        unfinished.as_file().sync_data()?;
        let file = unfinished.persist(slot.path()).map_err(|error| error.error)?;
        Ok(Self { file, number, size, begun_size: size, line })
    }

    /// Adds operations, all of them or none. The system has them when this method returns, so that
    /// a program that is killed afterwards loses none of them.
    ///
    /// # Errors
    /// The disk is full, for example, or the operations are more than a line holds. The journal is
    /// then as it was; the caller may try again, or begin the journal anew.
    pub fn append<E: Clone + Serialize>(&mut self, ops: &[Op<E>]) -> io::Result<()> {
        if ops.is_empty() {
            return Ok(());
        }
        self.push(&Record::Ops(Cow::Borrowed(ops)))
    }

    /// Notes the state that the window wants back, such as its camera: each member takes the place
    /// of the one that [`DocumentInfo::window`] has.
    ///
    /// # Errors
    /// As [`append`](Self::append).
    pub fn note_window(
        &mut self,
        members: &serde_json::Map<String, serde_json::Value>,
    ) -> io::Result<()> {
        self.push::<()>(&Record::Window(Cow::Borrowed(members)))
    }

    /// Notes that the window was closed normally.
    ///
    /// # Errors
    /// As [`append`](Self::append).
    pub fn close(&mut self) -> io::Result<()> {
        self.push::<()>(&Record::Closed)?;
        self.sync()
    }

    fn push<E: Clone + Serialize>(&mut self, record: &Record<'_, E>) -> io::Result<()> {
        self.push_within(record, line::MAX_LINE)
    }

    /// Adds a record of at most `most` bytes: a longer one could not be read again.
    fn push_within<E: Clone + Serialize>(
        &mut self,
        record: &Record<'_, E>,
        most: u64,
    ) -> io::Result<()> {
        let json = serde_json::to_string(record)?;
        self.line.clear();
        line::push(&mut self.line, self.number, &json);
        if self.line.len() as u64 > most {
            self.line = String::new();
            return Err(io::Error::new(
                io::ErrorKind::InvalidData,
                tr!("more was done at once than a journal's line holds"),
            ));
        }
        if let Err(error) = self.file.write_all(self.line.as_bytes()) {
            // Half a line would hide the lines that follow.
            self.file.set_len(self.size)?;
            self.file.seek(SeekFrom::Start(self.size))?;
            return Err(error);
        }
        self.number += 1;
        self.size += self.line.len() as u64;
        Ok(())
    }

    /// Waits until the disk has the journal, so that not even a power cut loses it.
    ///
    /// # Errors
    /// The disk cannot store the file.
    pub fn sync(&self) -> io::Result<()> {
        self.file.sync_data()
    }

    /// True if the journal is long enough to be begun anew.
    pub fn is_grown(&self) -> bool {
        self.size - self.begun_size > GROWTH.max(self.begun_size)
    }

    /// Size of the journal, in bytes.
    pub fn size(&self) -> u64 {
        self.size
    }
}

/// Writer of the beginning of a journal.
struct LineWriter<W: io::Write> {
    to: W,
    number: u64,
    size: u64,
    line: String,
}

impl<W: io::Write> LineWriter<W> {
    fn write<E: Clone + Serialize>(&mut self, record: &Record<'_, E>) -> io::Result<()> {
        self.line.clear();
        line::push(&mut self.line, self.number, &serde_json::to_string(record)?);
        self.number += 1;
        self.size += self.line.len() as u64;
        self.to.write_all(self.line.as_bytes())
    }

    /// Writes the document's image, in lines of at most about `most` bytes of it.
    fn image<E: Clone + Serialize>(&mut self, image: &str, most: usize) -> io::Result<()> {
        let mut rest = image;
        while !rest.is_empty() {
            let (part, after) = rest.split_at(rest.ceil_char_boundary(most));
            self.write::<E>(&Record::Document { image: part.into() })?;
            rest = after;
        }
        Ok(())
    }

    /// Writes as many of the newest steps as may be kept, oldest first.
    fn steps<'s, E: Clone + Serialize>(
        &mut self,
        steps: &'s [Step<E>],
        record: impl Fn(&'s [Step<E>]) -> Record<'s, E>,
    ) -> io::Result<()> {
        // Index of each line's first step, from the newest step back.
        let mut starts = vec![steps.len()];
        let (mut total, mut in_line) = (0, 0);
        for (index, step) in steps.iter().enumerate().rev() {
            let length = serde_json::to_string(step)?.len();
            total += length;
            if total > MAX_PAST {
                break;
            }
            if in_line == 0 || in_line + length > STEPS_LINE {
                starts.push(index);
                in_line = 0;
            } else if let Some(start) = starts.last_mut() {
                *start = index;
            }
            in_line += length;
        }
        for pair in starts.windows(2).rev() {
            self.write(&record(&steps[pair[1]..pair[0]]))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Address, Grid, Hcbtf, HcbtfEdit, Tile};

    /// A document that is too large for one line comes back from several.
    #[test]
    fn an_image_in_many_lines_is_read_again() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal");
        let mut history = History::new(Hcbtf::new(Grid::THESIS));
        let (address, tile) = (Address::new([2, 3], [1, 0]), Tile::filled([32, 32], [1, 2, 3, 4]));
        history.apply(HcbtfEdit::paint(history.document(), address, tile)).unwrap();
        let about = DocumentInfo { name: "grass, größer".into(), ..DocumentInfo::default() };
        let to = File::create(&path).unwrap();
        let mut lines = LineWriter { to, number: 0, size: 0, line: String::new() };
        let kind = "hcbtf".into();
        let begin = Record::Begin {
            version: VERSION,
            kind,
            numbers: history.numbers(),
            about: Cow::Borrowed(&about),
        };
        lines.write::<HcbtfEdit>(&begin).unwrap();
        lines.image::<HcbtfEdit>(&history.document().to_image().unwrap(), 7).unwrap();
        lines.write::<HcbtfEdit>(&Record::Ready).unwrap();
        assert!(lines.number > 20);
        let found = recover::<Hcbtf>(&path).unwrap();
        assert_eq!(found.history.document(), history.document());
    }

    /// A record that could not be read again is not written.
    #[test]
    fn more_than_a_line_holds_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let slot = JournalSlot::new(folder.path()).unwrap();
        let mut journal = Journal::begin(
            &slot,
            &DocumentInfo::default(),
            None,
            &History::new(Hcbtf::new(Grid::THESIS)),
        )
        .unwrap();
        let size = journal.size();
        let ops = [Op::Edit { gesture: None, edit: HcbtfEdit::SetTiling { is_tiling: false } }];
        let record = Record::Ops(Cow::Borrowed(&ops[..]));
        assert!(journal.push_within(&record, 60).is_err() && journal.size() == size);
        journal.append(&ops).unwrap();
        assert!(journal.size() > size);
        assert!(!recover::<Hcbtf>(slot.path()).unwrap().history.document().is_tiling);
    }
}
