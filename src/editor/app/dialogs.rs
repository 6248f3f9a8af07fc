//! File dialogs of the system, which wait on a thread of their own. Where the system has none to
//! show, the window asks for a path itself.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use crate::clock::Clock;
use crate::commands::FilePurpose;
use crate::state::worker::{start, wait};

/// Time in which nobody can answer a dialog, in seconds: a dialog that ends sooner was never shown,
/// since there is no portal and no program for it.
const UNSEEN: f64 = 0.35;

/// Result of a dialog.
#[derive(Debug)]
pub(crate) enum Answer {
    /// The chosen file.
    File(FilePurpose, PathBuf),
    /// No dialog could be shown; with the path that it would have begun at.
    NoDialog(FilePurpose, PathBuf),
}

/// Way of asking for files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DialogKind {
    /// By the system's dialogs.
    System,
    /// By a path field in the window.
    Window,
    /// Not at all: nobody is there to answer.
    Silent,
}

/// Open dialogs, and their results.
pub(crate) struct Dialogs {
    answers: Arc<Mutex<Vec<Answer>>>,
    wake: Arc<dyn Fn() + Send + Sync>,
    pub(crate) way: DialogKind,
    /// Answers to the next dialogs, for programs that drive the window.
    pub(crate) prepared: VecDeque<PathBuf>,
}

impl Dialogs {
    /// Creates the dialogs. `wake` is called from another thread when a file was chosen.
    pub(crate) fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            answers: Arc::default(),
            wake: Arc::new(wake),
            way: DialogKind::System,
            prepared: VecDeque::new(),
        }
    }

    /// Asks for a file, beginning in the folder of `near`.
    pub(crate) fn ask(&mut self, purpose: FilePurpose, near: Option<&Path>) {
        if let Some(path) = self.prepared.pop_front() {
            return self.answer(Answer::File(purpose, path));
        }
        match self.way {
            DialogKind::System => self.ask_system(purpose, near),
            DialogKind::Window => self.answer(Answer::NoDialog(purpose, suggested(purpose, near))),
            DialogKind::Silent => {}
        }
    }

    fn ask_system(&self, purpose: FilePurpose, near: Option<&Path>) {
        let suggested = suggested(purpose, near);
        let (kind, endings) = purpose.files();
        let mut dialog = rfd::AsyncFileDialog::new();
        if !purpose.is_folder() {
            dialog = dialog.add_filter(kind, endings);
        }
        // A suggested folder does not exist yet, but its parent does.
        if let Some(folder) =
            suggested.ancestors().skip(usize::from(!purpose.is_folder())).find(|path| path.is_dir())
        {
            dialog = dialog.set_directory(folder);
        }
        let name = suggested.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let (answers, wake) = (self.answers.clone(), self.wake.clone());
        let _ = start("dialog", move || {
            let clock = Clock::start();
            let file = match purpose.writes() {
                _ if purpose.is_folder() => wait(dialog.pick_folder()),
                false => wait(dialog.pick_file()),
                true => wait(dialog.set_file_name(name).save_file()),
            };
            let answer = match file {
                Some(file) => Answer::File(purpose, purpose.complete(file.path().to_path_buf())),
                None if clock.seconds() < UNSEEN => Answer::NoDialog(purpose, suggested),
                None => return,
            };
            answers.lock().unwrap_or_else(PoisonError::into_inner).push(answer);
            wake();
        });
    }

    fn answer(&self, answer: Answer) {
        self.answers.lock().unwrap_or_else(PoisonError::into_inner).push(answer);
        (self.wake)();
    }

    /// Results of dialogs since the last call. Once there was no dialog to show, the system is not
    /// asked again.
    pub(crate) fn answers(&mut self) -> Vec<Answer> {
        let answers =
            std::mem::take(&mut *self.answers.lock().unwrap_or_else(PoisonError::into_inner));
        if self.way == DialogKind::System
            && answers.iter().any(|answer| matches!(answer, Answer::NoDialog(..)))
        {
            self.way = DialogKind::Window;
        }
        answers
    }
}

/// Path that a dialog begins at: beside `near`, with the name of `near` where a file is written;
/// `near` itself where a folder is asked for.
fn suggested(purpose: FilePurpose, near: Option<&Path>) -> PathBuf {
    if purpose.is_folder() {
        return near.and_then(|near| std::path::absolute(near).ok()).unwrap_or_default();
    }
    let folder =
        near.and_then(Path::parent).filter(|folder| folder.is_dir()).map(Path::to_path_buf);
    let folder = folder.or_else(|| std::env::current_dir().ok()).unwrap_or_default();
    if !purpose.writes() {
        return folder.join("");
    }
    let name = near
        .and_then(Path::file_name)
        .map_or_else(|| "look.json".into(), std::borrow::ToOwned::to_owned);
    let (_, endings) = purpose.files();
    folder.join(Path::new(&name).with_extension(endings[0]))
}
