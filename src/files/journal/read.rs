//! Reading a journal: the same history again.

use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;

use super::line::{Line, Lines};
use super::record::{About, Op, Record, VERSION};
use crate::diag::Diagnostic;
use crate::document::{Editable, Hcbtf, History, HistoryNumbers, Journaled, Look, Scene, Step};

/// A longer image of a document is refused: that of the largest HCBTF is shorter.
const MAX_IMAGE: usize = 3 << 29;

/// What a journal gave back.
#[derive(Clone, Debug)]
pub struct Recovered<D: Editable> {
    /// The document with all that can be undone and redone.
    pub history: History<D>,
    /// What it is.
    pub about: About,
    /// What its file held when it was read or saved last.
    pub source: Option<String>,
    /// What could not be brought back, and why. An end that was cut off, as a crash leaves it, is
    /// none.
    pub damage: Vec<Diagnostic>,
    /// Whether the window was closed as windows are, and did not crash.
    pub is_closed: bool,
}

/// What a journal gave back, whichever kind of document it is of.
#[derive(Clone, Debug)]
pub enum Found {
    /// A look.
    Look(Box<Recovered<Look>>),
    /// A scene.
    Scene(Box<Recovered<Scene>>),
    /// An HCBTF.
    Hcbtf(Box<Recovered<Hcbtf>>),
}

/// Reads a journal of any kind.
///
/// # Errors
/// As [`recover`].
pub fn recover_any(path: &Path) -> Result<Found, Box<Diagnostic>> {
    // What is damaged where it begins is told as that of a look.
    if let Ok(scene) = recover::<Scene>(path) {
        return Ok(Found::Scene(Box::new(scene)));
    }
    match recover::<Hcbtf>(path) {
        Ok(hcbtf) => Ok(Found::Hcbtf(Box::new(hcbtf))),
        Err(_) => recover::<Look>(path).map(|look| Found::Look(Box::new(look))),
    }
}

/// Reads a journal.
///
/// # Errors
/// A diagnostic that says why nothing can be brought back. The file is left as it is.
pub fn recover<D: Journaled>(path: &Path) -> Result<Recovered<D>, Box<Diagnostic>> {
    let fail = |error: io::Error| {
        let message = format!("the journal of unsaved work cannot be read: {error}");
        Box::new(Diagnostic::error("cannot-read", message).in_file(path.display().to_string()))
    };
    let file = File::open(path).map_err(fail)?;
    let mut reader = Reader { lines: Lines::new(BufReader::new(file)), damage: Vec::new() };
    let begun = reader.beginning::<D>().map_err(fail)?;
    let Some(Beginning { numbers, mut about, source, document, done, undone }) = begun else {
        let message = "the journal of unsaved work is damaged where it begins, and nothing can be \
                       brought back from it";
        let problem =
            Diagnostic::error("damaged-journal", message).in_file(path.display().to_string());
        return Err(Box::new(problem.hint("it is kept until you throw it away")));
    };
    let mut history = History::restored(document, done, undone, numbers);
    let is_closed = reader.ops(&mut history, &mut about.window).map_err(fail)?;
    history.end_gesture();
    let dropped = history.drop_impossible_steps();
    if dropped > 0 {
        reader
            .damage
            .push(damage(format!("{dropped} older steps can no longer be undone or redone")));
    }
    Ok(Recovered { history, about, source, damage: reader.damage, is_closed })
}

fn damage(message: impl Into<String>) -> Diagnostic {
    Diagnostic::warning("damaged-journal", message)
}

/// What stands before the edits.
struct Beginning<D: Editable> {
    numbers: HistoryNumbers,
    about: About,
    source: Option<String>,
    document: D,
    done: Vec<Step<D::Edit>>,
    undone: Vec<Step<D::Edit>>,
}

struct Reader {
    lines: Lines<BufReader<File>>,
    damage: Vec<Diagnostic>,
}

impl Reader {
    /// `None` where it is not whole. It is put in its place whole, so that is damage.
    fn beginning<D: Journaled>(&mut self) -> io::Result<Option<Beginning<D>>> {
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
        Ok(document.map(|document| Beginning { numbers, about, source, document, done, undone }))
    }

    /// The next record, where it is whole and known.
    fn record<D: Journaled>(&mut self) -> io::Result<Option<Record<'static, D::Edit>>> {
        match self.lines.next()? {
            Line::Whole(json) => Ok(serde_json::from_str(&json).ok()),
            Line::Damaged | Line::End => Ok(None),
        }
    }

    /// Does again what was done. What follows something that cannot be done is left out: it was
    /// made for another document. Notes what the window wanted back last. Returns whether the
    /// window was closed.
    fn ops<D: Journaled>(
        &mut self,
        history: &mut History<D>,
        window: &mut serde_json::Value,
    ) -> io::Result<bool> {
        let mut is_closed = false;
        loop {
            let json = match self.lines.next()? {
                Line::Whole(json) => json,
                Line::End => return Ok(is_closed),
                Line::Damaged => {
                    if self.lines.has_more() {
                        self.damage.push(damage(
                            "a part of the journal is damaged; what was done after it is lost",
                        ));
                    }
                    return Ok(false);
                }
            };
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
                self.damage.push(damage(
                    "an edit in the journal cannot be repeated; what was done after it is lost",
                ));
                return Ok(false);
            }
        }
    }
}

fn apply<D: Journaled>(history: &mut History<D>, op: Op<D::Edit>) -> bool {
    match op {
        Op::Edit { gesture: Some(gesture), edit } => history.apply_in(gesture, edit).is_ok(),
        Op::Edit { gesture: None, edit } => history.apply(edit).is_ok(),
        Op::Undo => history.undo().is_some(),
        Op::Redo => history.redo().is_some(),
    }
}
