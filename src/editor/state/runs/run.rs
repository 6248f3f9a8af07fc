//! A run of the program beside the window: started, read line by line, asked to end, and reaped.

use std::io::{BufRead as _, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use chiaro_locale::tr;

use super::CommandLine;
use crate::state::worker::start;

/// Most lines that wait to be taken: what is more is dropped.
const MOST_LINES: usize = 100_000;
/// Interval at which an ending process is looked at.
const MOMENT: Duration = Duration::from_millis(10);

/// A line that a run has written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum RunLine {
    /// Line of standard output: a result.
    Result(String),
    /// Line of standard error: a message.
    Message(String),
}

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RunEnd {
    /// All is done.
    Done,
    /// The run was asked to end.
    Stopped,
    /// Failure, whose reason the messages tell.
    Failed,
}

#[derive(Default)]
struct RunState {
    lines: Vec<RunLine>,
    end: Option<RunEnd>,
    is_stopped: bool,
}

struct RunShared {
    state: Mutex<RunState>,
    /// The process until it has ended.
    child: Mutex<Option<Child>>,
    changed: Condvar,
    wake: Box<dyn Fn() + Send + Sync>,
}

impl RunShared {
    fn lock(&self) -> MutexGuard<'_, RunState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn child(&self) -> MutexGuard<'_, Option<Child>> {
        self.child.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Reads all lines of an end of the process.
    fn read(&self, from: Option<impl Read>, line: fn(String) -> RunLine) {
        let Some(from) = from else { return };
        for text in BufReader::new(from).split(b'\n').map_while(Result::ok) {
            let text = String::from_utf8_lossy(&text).trim_end().to_owned();
            let mut state = self.lock();
            if !text.is_empty() && state.lines.len() < MOST_LINES {
                state.lines.push(line(text));
            }
            drop(state);
            (self.wake)();
        }
    }

    /// Waits until the process has ended. Whoever asks it to end may do so meanwhile.
    fn reap(&self) {
        let is_done = loop {
            let mut child = self.child();
            let ended = child.as_mut().map(Child::try_wait);
            if let Some(Ok(None)) = ended {
                drop(child);
                drop(self.changed.wait_timeout(self.lock(), MOMENT));
                continue;
            }
            *child = None;
            break matches!(ended, Some(Ok(Some(status))) if status.success());
        };
        let mut state = self.lock();
        state.end = Some(match (is_done, state.is_stopped) {
            (true, _) => RunEnd::Done,
            (false, true) => RunEnd::Stopped,
            (false, false) => RunEnd::Failed,
        });
        drop(state);
        self.changed.notify_all();
        (self.wake)();
    }
}

/// A run of the program. Dropped, it is asked to end.
pub(crate) struct ProgramRun(Arc<RunShared>);

impl ProgramRun {
    /// Starts the program. `wake` is called from other threads for each line, and at the end.
    ///
    /// # Errors
    /// The reason why the program does not start, as a sentence.
    pub(crate) fn start(
        program: &Path,
        line: &CommandLine,
        wake: impl Fn() + Send + Sync + 'static,
    ) -> Result<Self, String> {
        let mut command = Command::new(program);
        command.args(&line.words).current_dir(&line.folder);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let not_started = |error: std::io::Error| {
            let (program, folder) = (program.display(), line.folder.display());
            tr!("{program} does not start in {folder}: {error}")
        };
        let mut child = command.spawn().map_err(not_started)?;
        let (results, messages) = (child.stdout.take(), child.stderr.take());
        let shared = Arc::new(RunShared {
            state: Mutex::default(),
            child: Mutex::new(Some(child)),
            changed: Condvar::new(),
            wake: Box::new(wake),
        });
        let run = Self(shared.clone());
        let reader = shared.clone();
        let messages = start("messages", move || reader.read(messages, RunLine::Message));
        let reader = start("frames", move || {
            shared.read(results, RunLine::Result);
            // All messages are told before the end is.
            let _ = messages.map(std::thread::JoinHandle::join);
            shared.reap();
        });
        match reader {
            Some(_) => Ok(run),
            None => Err(tr!("the system starts no thread").to_owned()),
        }
    }

    /// The lines since the last call.
    pub(crate) fn lines(&self) -> Vec<RunLine> {
        std::mem::take(&mut self.0.lock().lines)
    }

    /// The end of the run; `None` while it goes on, or has lines that were not taken.
    pub(crate) fn end(&self) -> Option<RunEnd> {
        let state = self.0.lock();
        state.end.filter(|_| state.lines.is_empty())
    }

    /// True until the process has ended.
    pub(crate) fn is_going_on(&self) -> bool {
        self.0.lock().end.is_none()
    }

    /// Asks the program to end, which it does with no file half written.
    pub(crate) fn stop(&self) {
        self.0.lock().is_stopped = true;
        if let Some(child) = self.0.child().as_mut() {
            ask_to_end(child);
        }
    }

    /// Waits until the process has ended.
    pub(crate) fn wait(&self) {
        let goes_on = |state: &mut RunState| state.end.is_none();
        drop(self.0.changed.wait_while(self.0.lock(), goes_on));
    }
}

impl Drop for ProgramRun {
    fn drop(&mut self) {
        if self.is_going_on() {
            self.stop();
        }
    }
}

/// Asks a process to end by SIGTERM; ends it where the system has no such request.
fn ask_to_end(child: &mut Child) {
    let asked = cfg!(unix)
        && Command::new("kill")
            .args(["-TERM", &child.id().to_string()])
            .stdin(Stdio::null())
            .status()
            .is_ok_and(|status| status.success());
    if !asked {
        let _ = child.kill();
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn run(script: &str) -> ProgramRun {
        let words = ["-c", script].map(str::to_owned).to_vec();
        let line = CommandLine { folder: std::env::temp_dir(), words };
        ProgramRun::start(Path::new("sh"), &line, || {}).unwrap()
    }

    #[test]
    fn lines_and_the_end_are_told() {
        let done = run("echo one; echo two >&2");
        done.wait();
        assert_eq!(done.end(), None, "before its lines are taken");
        let lines = done.lines();
        assert!(lines.contains(&RunLine::Result("one".to_owned())), "{lines:?}");
        assert!(lines.contains(&RunLine::Message("two".to_owned())), "{lines:?}");
        assert_eq!(done.end(), Some(RunEnd::Done));
        let failed = run("exit 1");
        failed.wait();
        assert_eq!(failed.end(), Some(RunEnd::Failed));
        let nowhere = CommandLine { folder: "/no/such/folder".into(), words: Vec::new() };
        assert!(ProgramRun::start(Path::new("sh"), &nowhere, || {}).is_err());
    }

    #[test]
    fn a_run_that_is_stopped_ends() {
        let endless = run("exec sleep 60");
        assert!(endless.is_going_on());
        endless.stop();
        endless.wait();
        assert_eq!(endless.end(), Some(RunEnd::Stopped));
    }
}
