//! Writer of the journal of an open document, on a thread of its own: a slow disk holds up no hand.
//!
//! Edits of one gesture that set the same value again and again, such as all of a drag, are joined
//! for a moment before they are written, and the disk itself is waited for only when no edit was
//! made for a while.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

use chiaro_locale::tr;

use crate::clock::Clock;
use crate::diag::Diagnostic;
use crate::document::History;
use crate::files::journal::{DocumentInfo, Journal, JournalDocument, JournalSlot, Op};
use crate::state::revision::MessageNumber;
use crate::state::worker::start;

/// Interval of writing while a gesture goes on.
const OFTEN: Duration = Duration::from_millis(100);
/// Time without edits after which the disk is made to write.
const REST: Duration = Duration::from_secs(1);
/// Time from a failure to the next attempt, in seconds.
const RETRY: f64 = 3.0;

/// Shortest interval of writing the window's values, such as its view, in seconds: a turntable
/// changes them in every frame.
const WINDOW: f64 = 0.25;

/// Values that a window wants back beside a document, by name.
type Members = serde_json::Map<String, serde_json::Value>;

/// A whole document, for a journal to begin with.
pub(crate) struct JournalStart<D: JournalDocument> {
    pub(crate) about: DocumentInfo,
    pub(crate) source: Option<Arc<str>>,
    pub(crate) history: History<D>,
    /// Slot that the document was in, if it was taken back.
    pub(crate) slot: Option<JournalSlot>,
}

enum Message<D: JournalDocument> {
    Begin(Box<JournalStart<D>>),
    /// The values that the window wants back beside the document, from now on.
    Window(Members),
    /// Operations on the document; true if their gesture goes on.
    Ops(Vec<Op<D::Edit>>, bool),
    /// The journal stays in its slot, for whoever wants it; true if the window closes in peace.
    Leave(bool),
    /// The journal is no longer needed.
    Discard,
}

#[derive(Default)]
struct WriterState {
    /// Number of the message that was handled last.
    handled: Mutex<MessageNumber>,
    changed: Condvar,
    wants_to_begin: AtomicBool,
    problem: Mutex<Option<Diagnostic>>,
}

/// Writer of a document's journal, as the UI thread sees it.
pub(crate) struct JournalWriter<D: JournalDocument> {
    sender: Option<Sender<Message<D>>>,
    /// Number of the message that was sent last.
    sent: MessageNumber,
    shared: Arc<WriterState>,
    thread: Option<JoinHandle<()>>,
    /// True if there is a journal of the document, as far as the UI thread knows.
    pub(crate) has_begun: bool,
    /// True if the operations that were sent last may wait for more of their gesture.
    goes_on: bool,
}

impl<D> JournalWriter<D>
where
    D: JournalDocument + Send + 'static,
    D::Edit: Send,
{
    /// Starts the thread, which keeps journals in `folder`. `wake` is called from another thread
    /// when a problem appears or disappears.
    pub(crate) fn new(folder: PathBuf, wake: impl Fn() + Send + 'static) -> Self {
        let (sender, receiver) = channel();
        let shared = Arc::new(WriterState::default());
        let mut writer: Writer<D> = Writer {
            folder,
            slot: None,
            journal: None,
            waiting: WaitingOps::default(),
            is_synced: true,
            window: Members::new(),
            is_noted: true,
            noted: None,
            shared: shared.clone(),
            failed: None,
            wake: Box::new(wake),
        };
        let thread = start("journal", move || writer.run(&receiver));
        Self {
            sender: Some(sender),
            sent: MessageNumber::default(),
            shared,
            thread,
            has_begun: false,
            goes_on: false,
        }
    }

    fn send(&mut self, message: Message<D>) {
        self.sent.advance();
        // Without a thread nothing is kept, which `problem` reports.
        let _ = self.sender.as_ref().map(|sender| sender.send(message));
    }

    /// True if the journal wants the whole document rather than operations.
    pub(crate) fn wants_to_begin(&self) -> bool {
        !self.has_begun || self.shared.wants_to_begin.load(Ordering::Relaxed)
    }

    /// Begins the journal, or begins it anew.
    pub(crate) fn begin(&mut self, standing: JournalStart<D>) {
        self.has_begun = true;
        self.shared.wants_to_begin.store(false, Ordering::Relaxed);
        self.send(Message::Begin(Box::new(standing)));
    }

    /// Adds operations. While their gesture goes on they may wait for a moment.
    pub(crate) fn add(&mut self, ops: Vec<Op<D::Edit>>, goes_on: bool) {
        if !ops.is_empty() || self.goes_on && !goes_on {
            self.goes_on = goes_on;
            self.send(Message::Ops(ops, goes_on));
        }
    }

    /// Notes the values that the window wants back beside any document. They alone are not worth a
    /// journal, and go into the one that there is.
    pub(crate) fn note_window(&mut self, members: Members) {
        self.send(Message::Window(members));
    }

    /// Leaves the journal in its slot.
    pub(crate) fn leave(&mut self, in_peace: bool) {
        self.has_begun = false;
        self.send(Message::Leave(in_peace));
    }

    /// Removes the journal.
    pub(crate) fn discard(&mut self) {
        self.has_begun = false;
        self.send(Message::Discard);
    }

    /// Waits until the system has everything that was sent.
    pub(crate) fn wait(&self) {
        if self.thread.is_some() {
            let handled = self.shared.handled.lock().unwrap_or_else(PoisonError::into_inner);
            drop(self.shared.changed.wait_while(handled, |handled| *handled < self.sent));
        }
    }

    /// The reason why work is not kept, if it is not.
    pub(crate) fn problem(&self) -> Option<Diagnostic> {
        if self.thread.is_none() {
            return Some(problem(tr!("the system gives no thread to write it")));
        }
        self.shared.problem.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

impl<D: JournalDocument> Drop for JournalWriter<D> {
    fn drop(&mut self) {
        // The thread ends when nobody can send any more, after it has written everything that was
        // sent.
        self.sender = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

fn problem(why: impl std::fmt::Display) -> Diagnostic {
    let message = tr!("a crash now would lose what is not saved: {why}");
    Diagnostic::warning("not-kept", message)
        .hint(tr!("editing goes on; save often, or make room on the disk"))
}

/// Operations that are about to be written.
struct WaitingOps<D: JournalDocument> {
    ops: Vec<Op<D::Edit>>,
    /// True if the last operation is the first of its gesture. Later ones of the same gesture never
    /// replace it: the first makes the undo step, and removes the steps that could be redone.
    is_first: bool,
}

impl<D: JournalDocument> Default for WaitingOps<D> {
    fn default() -> Self {
        Self { ops: Vec::new(), is_first: false }
    }
}

impl<D: JournalDocument> WaitingOps<D> {
    /// Adds an operation after those that wait, or replaces the last of them if the new one sets
    /// the same value anyway.
    fn join(&mut self, op: Op<D::Edit>) {
        let last = self.ops.last_mut();
        let (goes_on, sets_the_same) = match (&last, &op) {
            (
                Some(Op::Edit { gesture: Some(old), edit: covered }),
                Op::Edit { gesture: Some(new), edit },
            ) if old == new => (true, D::covers(covered, edit)),
            _ => (false, false),
        };
        match last {
            Some(last) if sets_the_same && !self.is_first => *last = op,
            _ => {
                self.is_first = !goes_on;
                self.ops.push(op);
            }
        }
    }
}

/// The part of the writer that lives on the thread and owns the journal.
struct Writer<D: JournalDocument> {
    folder: PathBuf,
    slot: Option<JournalSlot>,
    journal: Option<Journal>,
    waiting: WaitingOps<D>,
    is_synced: bool,
    window: Members,
    /// True if the journal has the present `window`.
    is_noted: bool,
    /// Time since `window` was last written.
    noted: Option<Clock>,
    shared: Arc<WriterState>,
    failed: Option<Clock>,
    wake: Box<dyn Fn() + Send>,
}

impl<D: JournalDocument> Writer<D> {
    fn run(&mut self, receiver: &Receiver<Message<D>>) {
        let mut since: Option<Clock> = None;
        loop {
            let pause = match &since {
                Some(since) => OFTEN.saturating_sub(Duration::from_secs_f64(since.seconds())),
                None if self.failed.is_some() => Duration::from_secs_f64(RETRY),
                None if self.is_to_note() => Duration::from_secs_f64(WINDOW),
                None if !self.is_synced => REST,
                None => Duration::MAX,
            };
            let message = match pause {
                Duration::MAX => receiver.recv().map_err(|_| RecvTimeoutError::Disconnected),
                pause => receiver.recv_timeout(pause),
            };
            match message {
                Ok(message) => {
                    let goes_on = matches!(message, Message::Ops(_, true) | Message::Window(_));
                    self.handle(message);
                    let is_due = |noted: &Clock| noted.seconds() >= WINDOW;
                    if self.is_to_note() && self.noted.as_ref().is_none_or(is_due) {
                        self.note_window();
                    }
                    if !goes_on
                        || since
                            .as_ref()
                            .is_some_and(|since| since.seconds() >= OFTEN.as_secs_f64())
                    {
                        self.write();
                    }
                    self.shared.handled.lock().unwrap_or_else(PoisonError::into_inner).advance();
                    self.shared.changed.notify_all();
                }
                Err(RecvTimeoutError::Timeout) if since.is_some() => self.write(),
                Err(RecvTimeoutError::Timeout) if self.failed.is_some() => self.ask_to_begin(),
                Err(RecvTimeoutError::Timeout) if self.is_to_note() => self.note_window(),
                Err(RecvTimeoutError::Timeout) => self.sync(),
                Err(RecvTimeoutError::Disconnected) => {
                    self.write();
                    self.note_window();
                    return;
                }
            }
            since = if self.waiting.ops.is_empty() {
                None
            } else {
                since.or_else(|| Some(Clock::start()))
            };
        }
    }

    fn handle(&mut self, message: Message<D>) {
        match message {
            Message::Begin(standing) => {
                // The document includes the operations that wait.
                self.waiting.ops.clear();
                let begun = self.begin(*standing);
                self.is_synced = true;
                self.take(begun);
            }
            Message::Window(members) => {
                self.window = members;
                self.is_noted = false;
            }
            Message::Ops(ops, _) => ops.into_iter().for_each(|op| self.waiting.join(op)),
            Message::Leave(in_peace) => {
                self.write();
                self.note_window();
                let closed = match self.journal.as_mut() {
                    Some(journal) if in_peace => journal.close(),
                    _ => Ok(()),
                };
                self.take(closed);
                (self.journal, self.slot) = (None, None);
            }
            Message::Discard => {
                self.waiting.ops.clear();
                self.journal = None;
                if let Some(slot) = self.slot.take() {
                    slot.discard();
                }
                self.take(Ok(()));
            }
        }
    }

    fn begin(
        &mut self,
        JournalStart { about, source, history, slot }: JournalStart<D>,
    ) -> std::io::Result<()> {
        self.journal = None;
        if slot.is_some() {
            self.slot = slot;
        }
        if self.slot.is_none() {
            self.slot = Some(JournalSlot::new(&self.folder)?);
        }
        if let Some(slot) = &self.slot {
            self.journal = Some(Journal::begin(slot, &about, source.as_deref(), &history)?);
            self.is_noted = self.window.is_empty();
            self.note_window();
        }
        Ok(())
    }

    fn write(&mut self) {
        let ops = std::mem::take(&mut self.waiting.ops);
        if ops.is_empty() {
            return;
        }
        let Some(journal) = &mut self.journal else {
            // The journal could not be begun; the owner of the document is asked for it again after
            // a while.
            if self.failed.as_ref().is_none_or(|failed| failed.seconds() > RETRY) {
                self.ask_to_begin();
            }
            return;
        };
        let written = journal.append(&ops);
        self.is_synced = false;
        if journal.is_grown() {
            self.shared.wants_to_begin.store(true, Ordering::Relaxed);
        }
        self.take(written);
    }

    /// True if there is a journal without the window's present values.
    fn is_to_note(&self) -> bool {
        !self.is_noted && self.journal.is_some()
    }

    /// Writes the window's values, where the journal does not have them. They are nobody's work: a
    /// failure is not reported here, but by the next edit.
    fn note_window(&mut self) {
        if !self.is_noted
            && let Some(journal) = &mut self.journal
        {
            self.is_noted = true;
            self.noted = Some(Clock::start());
            self.is_synced = false;
            let _ = journal.note_window(&self.window);
        }
    }

    fn ask_to_begin(&mut self) {
        self.failed = self.failed.is_some().then(Clock::start);
        self.shared.wants_to_begin.store(true, Ordering::Relaxed);
        (self.wake)();
    }

    fn sync(&mut self) {
        self.is_synced = true;
        let synced = self.journal.as_ref().map_or(Ok(()), Journal::sync);
        self.take(synced);
    }

    /// Reports a failure once, and its end once. Operations missing in a journal cannot be made up
    /// for, so the journal is begun anew then.
    fn take(&mut self, result: std::io::Result<()>) {
        let problem = result.err().map(|error| problem(reason(&error)));
        if problem.is_some() {
            self.journal = None;
            self.failed = Some(Clock::start());
        } else if self.journal.is_some() {
            self.failed = None;
        }
        let mut told = self.shared.problem.lock().unwrap_or_else(PoisonError::into_inner);
        let is_new = told.is_some() != problem.is_some();
        *told = problem;
        drop(told);
        if is_new {
            (self.wake)();
        }
    }
}

fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::StorageFull => tr!("the disk is full").to_owned(),
        std::io::ErrorKind::PermissionDenied | std::io::ErrorKind::ReadOnlyFilesystem => {
            tr!("the folder for unsaved work may not be written").to_owned()
        }
        _ => tr!("the folder for unsaved work cannot be written ({error})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Edit, GraphId, Look, Node, Value};
    use crate::files::journal::LookOp;

    /// The document, and every state that undo and redo lead through.
    fn all_of(mut history: History<Look>) -> Vec<String> {
        let mut all = vec![history.document().to_text()];
        while history.undo().is_some() {
            all.push(history.document().to_text());
        }
        while history.redo().is_some() {
            all.push(history.document().to_text());
        }
        all
    }

    fn done(ops: &[LookOp]) -> History<Look> {
        let mut look = Look::default();
        look.graph.nodes.insert("a".into(), Node::default());
        let mut history = History::new(look);
        ops.iter().for_each(|op| apply(&mut history, op));
        history
    }

    fn apply(history: &mut History<Look>, op: &LookOp) {
        match op.clone() {
            Op::Edit { gesture: Some(gesture), edit } => history.apply_in(gesture, edit).unwrap(),
            Op::Edit { gesture: None, edit } => history.apply(edit).unwrap(),
            Op::Undo => drop(history.undo()),
            Op::Redo => drop(history.redo()),
        }
    }

    #[test]
    fn joined_edits_come_to_the_same() {
        let mut fewer = 0;
        for seed in 0..400_u64 {
            let mut bits = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
            let mut below = |count: u64| {
                bits ^= bits << 13;
                bits ^= bits >> 7;
                bits ^= bits << 17;
                (bits >> 11) % count
            };
            let (mut ops, mut plain) = (Vec::new(), done(&[]));
            let mut gesture = 0;
            for _ in 0..12 {
                gesture += u64::from(below(5) == 0);
                let set = |port: &str, value: u64| Edit::SetValue {
                    graph: GraphId::Look,
                    id: "a".into(),
                    port: port.into(),
                    value: Value::Number(value as f64),
                    index: None,
                };
                let op = match below(12) {
                    0 => Op::Undo,
                    1 => Op::Redo,
                    2 => Op::Edit {
                        gesture: Some(gesture),
                        edit: Edit::SetLookName { name: below(3).to_string() },
                    },
                    3 => Op::Edit { gesture: None, edit: set("a", below(3)) },
                    4..7 => Op::Edit { gesture: Some(gesture), edit: set("b", below(3)) },
                    _ => Op::Edit { gesture: Some(gesture), edit: set("a", below(3)) },
                };
                // Only an operation that changed the document is noted.
                let before = plain.revision();
                apply(&mut plain, &op);
                if plain.revision() > before {
                    ops.push(op);
                }
            }
            let mut waiting = WaitingOps::<Look>::default();
            ops.iter().cloned().for_each(|op| waiting.join(op));
            fewer += ops.len() - waiting.ops.len();
            let joined = done(&waiting.ops);
            assert_eq!(plain.steps(), joined.steps(), "{ops:?}");
            assert_eq!(all_of(plain), all_of(joined), "{ops:?}");
        }
        assert!(fewer > 200, "edits are joined: {fewer}");
    }
}
