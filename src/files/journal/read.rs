//! Reader of a journal: restores the same history.

use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;

use chiaro_locale::{tr, trn};

use super::line::{JournalLine, LineReader};
use super::record::{DocumentInfo, Op, Record, VERSION};
use crate::diag::Diagnostic;
use crate::document::{
    Editable, Hcbtf, History, HistoryNumbers, JournalDocument, Look, Scene, Shot, Step,
};

/// Length of the longest image of a document that is accepted, in bytes: that of the largest HCBTF
/// is shorter.
const MAX_IMAGE: usize = 3 << 29;

/// Work restored from a journal.
#[derive(Clone, Debug)]
pub struct RecoveredWork<D: Editable> {
    /// Document with all steps that can be undone and redone.
    pub history: History<D>,
    /// Description of the document: its name, file and window.
    pub about: DocumentInfo,
    /// Text of the document's file when it was read or saved last.
    pub source: Option<String>,
    /// Losses and their reasons. An end that was cut off, as a crash leaves it, is no loss.
    pub damage: Vec<Diagnostic>,
    /// True if the window was closed normally, false after a crash.
    pub is_closed: bool,
}

/// Work restored from a journal of any kind of document.
#[derive(Clone, Debug)]
pub enum RecoveredDocument {
    /// A look.
    Look(Box<RecoveredWork<Look>>),
    /// A scene.
    Scene(Box<RecoveredWork<Scene>>),
    /// A shot.
    Shot(Box<RecoveredWork<Shot>>),
    /// An HCBTF.
    Hcbtf(Box<RecoveredWork<Hcbtf>>),
}

/// Reads a journal of any kind.
///
/// # Errors
/// As [`recover`].
pub fn recover_any(path: &Path) -> Result<RecoveredDocument, Box<Diagnostic>> {
    // A journal with a damaged beginning is reported as that of a look.
    if let Ok(scene) = recover::<Scene>(path) {
        return Ok(RecoveredDocument::Scene(Box::new(scene)));
    }
    if let Ok(shot) = recover::<Shot>(path) {
        return Ok(RecoveredDocument::Shot(Box::new(shot)));
    }
    match recover::<Hcbtf>(path) {
        Ok(hcbtf) => Ok(RecoveredDocument::Hcbtf(Box::new(hcbtf))),
        Err(_) => recover::<Look>(path).map(|look| RecoveredDocument::Look(Box::new(look))),
    }
}

/// Reads a journal.
///
/// # Errors
/// A diagnostic that says why nothing can be brought back. The file is left as it is.
pub fn recover<D: JournalDocument>(path: &Path) -> Result<RecoveredWork<D>, Box<Diagnostic>> {
    let fail = |error: io::Error| {
        let message = tr!("the journal of unsaved work cannot be read: {error}");
        Box::new(Diagnostic::error("cannot-read", message).in_file(path.display().to_string()))
    };
    let file = File::open(path).map_err(fail)?;
    let mut reader = Reader { lines: LineReader::new(BufReader::new(file)), damage: Vec::new() };
    let begun = reader.beginning::<D>().map_err(fail)?;
    let Some(JournalContent { numbers, mut about, source, document, done, undone }) = begun else {
        let message =
            tr!("the journal of unsaved work is damaged where it begins, and nothing can be \
                       brought back from it");
        let problem =
            Diagnostic::error("damaged-journal", message).in_file(path.display().to_string());
        return Err(Box::new(problem.hint(tr!("it is kept until you throw it away"))));
    };
    let mut history = History::restored(document, done, undone, numbers);
    let is_closed = reader.ops(&mut history, &mut about.window).map_err(fail)?;
    history.end_gesture();
    let dropped = history.drop_impossible_steps();
    if dropped > 0 {
        reader.damage.push(damage(trn!(
            dropped,
            "{dropped} older steps can no longer be undone or redone",
            "{dropped} older steps can no longer be undone or redone"
        )));
    }
    Ok(RecoveredWork { history, about, source, damage: reader.damage, is_closed })
}

fn damage(message: impl Into<String>) -> Diagnostic {
    Diagnostic::warning("damaged-journal", message)
}

/// Part of a journal before the edits.
struct JournalContent<D: Editable> {
    numbers: HistoryNumbers,
    about: DocumentInfo,
    source: Option<String>,
    document: D,
    done: Vec<Step<D::Edit>>,
    undone: Vec<Step<D::Edit>>,
}

struct Reader {
    lines: LineReader<BufReader<File>>,
    damage: Vec<Diagnostic>,
}

impl Reader {
    /// Reads the beginning; `None` where it is not whole. A beginning is put in its place whole, so
    /// that a part of one is damage.
    fn beginning<D: JournalDocument>(&mut self) -> io::Result<Option<JournalContent<D>>> {
        let Some(Record::Begin { version, kind, numbers, about }) = self.record::<D>()? else {
            return Ok(None);
        };
        if version != VERSION || kind != D::KIND {
            return Ok(None);
        }
        let (about, mut source, mut document) = (about.into_owned(), None, String::new());
        let (mut done, mut undone) = (Vec::new(), Vec::new());
        loop {
            match self.record::<D>()? {
                Some(Record::Source { text }) => source = Some(text.into_owned()),
                Some(Record::Document { image }) if document.len() + image.len() <= MAX_IMAGE => {
                    document.push_str(&image);
                }
                Some(Record::Done(steps)) => done.extend(steps.into_owned()),
                Some(Record::Undone(steps)) => undone.extend(steps.into_owned()),
                Some(Record::Ready) => break,
                _ => return Ok(None),
            }
        }
        let document = D::from_image(&document).ok();
        Ok(document.map(|document| JournalContent {
            numbers,
            about,
            source,
            document,
            done,
            undone,
        }))
    }

    /// Reads the next record; `None` where it is not whole or not known.
    fn record<D: JournalDocument>(&mut self) -> io::Result<Option<Record<'static, D::Edit>>> {
        match self.lines.next()? {
            JournalLine::Whole(json) => Ok(serde_json::from_str(&json).ok()),
            JournalLine::Damaged | JournalLine::End => Ok(None),
        }
    }

    /// Applies the noted operations again. Operations after one that cannot be applied are left
    /// out: they were made for another document. Keeps the window's state that was noted last.
    /// Returns true if the window was closed.
    fn ops<D: JournalDocument>(
        &mut self,
        history: &mut History<D>,
        window: &mut serde_json::Value,
    ) -> io::Result<bool> {
        let mut is_closed = false;
        loop {
            let json = match self.lines.next()? {
                JournalLine::Whole(json) => json,
                JournalLine::End => return Ok(is_closed),
                JournalLine::Damaged => {
                    if self.lines.has_more() {
                        self.damage.push(damage(tr!(
                            "a part of the journal is damaged; what was done after it is lost"
                        )));
                    }
                    return Ok(false);
                }
            };
            // A record after `Closed` means that work went on.
            is_closed = false;
            let is_done = match serde_json::from_str::<Record<'static, D::Edit>>(&json) {
                Ok(Record::Ops(ops)) => ops.into_owned().into_iter().all(|op| apply(history, op)),
                Ok(Record::Window(members)) => {
                    let members = members.into_owned();
                    match window.as_object_mut() {
                        Some(known) => known.extend(members),
                        None => *window = members.into(),
                    }
                    true
                }
                Ok(Record::Closed) => {
                    is_closed = true;
                    true
                }
                _ => false,
            };
            if !is_done {
                self.damage.push(damage(tr!(
                    "an edit in the journal cannot be repeated; what was done after it is lost"
                )));
                return Ok(false);
            }
        }
    }
}

fn apply<D: JournalDocument>(history: &mut History<D>, op: Op<D::Edit>) -> bool {
    match op {
        Op::Edit { gesture: Some(gesture), edit } => history.apply_in(gesture, edit).is_ok(),
        Op::Edit { gesture: None, edit } => history.apply(edit).is_ok(),
        Op::Undo => history.undo().is_some(),
        Op::Redo => history.redo().is_some(),
    }
}
