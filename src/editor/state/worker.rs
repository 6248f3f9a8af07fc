//! Work off the UI thread: the one place of the window that starts threads. The newest request
//! wins.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

use crate::threads;

/// Background threads of a part of the window.
pub(crate) trait BackgroundJobs {
    /// True while a thread works.
    fn is_busy(&self) -> bool;

    /// Waits until the threads are done.
    fn wait(&self);
}

struct State<Q, A> {
    waiting: Option<Q>,
    is_busy: bool,
    /// True while an answer is there and `wake` is being called for it.
    is_waking: bool,
    answers: Vec<A>,
    is_over: bool,
}

struct WorkerShared<Q, A> {
    state: Mutex<State<Q, A>>,
    changed: Condvar,
}

impl<Q, A> WorkerShared<Q, A> {
    fn lock(&self) -> MutexGuard<'_, State<Q, A>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A thread that turns requests into answers.
pub(crate) struct Worker<Q, A> {
    shared: Arc<WorkerShared<Q, A>>,
    thread: Option<JoinHandle<()>>,
}

impl<Q: Send + 'static, A: Send + 'static> Worker<Q, A> {
    /// Starts the thread. `wake` is called for each answer.
    pub(crate) fn new(
        name: &str,
        wake: impl Fn() + Send + 'static,
        mut work: impl FnMut(Q) -> A + Send + 'static,
    ) -> Self {
        Self::waiting(name, wake, async move |request| work(request))
    }

    /// Starts the thread for work that waits for the GPU. `wake` is called for each answer.
    pub(crate) fn waiting(
        name: &str,
        wake: impl Fn() + Send + 'static,
        mut work: impl AsyncFnMut(Q) -> A + Send + 'static,
    ) -> Self {
        let state = State {
            waiting: None,
            is_busy: false,
            is_waking: false,
            answers: Vec::new(),
            is_over: false,
        };
        let shared = Arc::new(WorkerShared { state: Mutex::new(state), changed: Condvar::new() });
        let thread = {
            let shared = shared.clone();
            start(name, move || {
                while let Some(request) = next(&shared) {
                    let answer = wait(work(request));
                    let mut state = shared.lock();
                    state.is_busy = false;
                    state.is_waking = true;
                    state.answers.push(answer);
                    drop(state);
                    shared.changed.notify_all();
                    wake();
                    shared.lock().is_waking = false;
                    shared.changed.notify_all();
                }
            })
        };
        Self { shared, thread }
    }

    /// Requests work, in place of a request that still waits; `make` is given the latter.
    pub(crate) fn request(&self, make: impl FnOnce(Option<Q>) -> Q) {
        let mut state = self.shared.lock();
        let waiting = state.waiting.take();
        state.waiting = Some(make(waiting));
        drop(state);
        self.shared.changed.notify_all();
    }

    /// The answers since the last call, oldest first.
    pub(crate) fn answers(&self) -> Vec<A> {
        std::mem::take(&mut self.shared.lock().answers)
    }

    /// True while a request is worked at or waits.
    pub(crate) fn is_busy(&self) -> bool {
        let state = self.shared.lock();
        state.is_busy || state.waiting.is_some()
    }

    /// True while an answer is on its way: worked at, or made and not taken yet.
    pub(crate) fn owes(&self) -> bool {
        let state = self.shared.lock();
        state.is_busy || state.waiting.is_some() || !state.answers.is_empty()
    }

    /// Waits until no work is left and no call of `wake` is under way.
    pub(crate) fn wait(&self) {
        if self.thread.is_some() {
            let is_busy = |state: &mut State<Q, A>| {
                state.is_busy || state.is_waking || state.waiting.is_some()
            };
            drop(self.shared.changed.wait_while(self.shared.lock(), is_busy));
        }
    }
}

impl<Q: Send + 'static, A: Send + 'static> Worker<Q, A> {
    /// Waits until no work is left, at most for `time`.
    pub(crate) fn wait_at_most(&self, time: Duration) {
        if self.thread.is_some() {
            let is_busy = |state: &mut State<Q, A>| state.is_busy || state.waiting.is_some();
            drop(self.shared.changed.wait_timeout_while(self.shared.lock(), time, is_busy));
        }
    }
}

impl<Q, A> Drop for Worker<Q, A> {
    fn drop(&mut self) {
        self.shared.lock().is_over = true;
        self.shared.changed.notify_all();
        if let Some(thread) = self.thread.take() {
            // The thread ends after its present request; the result no longer matters.
            let _ = thread.join();
        }
    }
}

/// Waits for a request; `None` when the worker is dropped.
fn next<Q, A>(shared: &WorkerShared<Q, A>) -> Option<Q> {
    let is_idle = |state: &mut State<Q, A>| state.waiting.is_none() && !state.is_over;
    let mut state =
        shared.changed.wait_while(shared.lock(), is_idle).unwrap_or_else(PoisonError::into_inner);
    if state.is_over {
        return None;
    }
    state.is_busy = true;
    state.waiting.take()
}

/// Waits for a future on the calling thread: the one place of the window that does, and never the
/// window's own thread.
#[expect(clippy::disallowed_methods, reason = "threads of the window's wait for the GPU")]
pub(crate) fn wait<T>(future: impl Future<Output = T>) -> T {
    pollster::block_on(future)
}

/// Starts a thread; `None` where the system has none to give.
#[expect(clippy::disallowed_methods, reason = "the one place of the window that starts threads")]
pub(crate) fn start(name: &str, work: impl FnOnce() + Send + 'static) -> Option<JoinHandle<()>> {
    threads::builder(name).spawn(work).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uses 20 MB of stack, as drivers do for long shaders.
    fn deep(left: u32) -> u32 {
        let room = std::hint::black_box([1_u8; 1024]);
        if left == 0 { 0 } else { deep(left - 1) + u32::from(room[left as usize % room.len()]) }
    }

    #[test]
    fn work_has_room() {
        let worker = Worker::new("test", || {}, deep);
        worker.request(|_| 20_000);
        worker.wait();
        assert_eq!(worker.answers(), [20_000]);
    }

    #[test]
    fn the_newest_request_is_answered() {
        let worker = Worker::new("test", || {}, |n: u32| n * 2);
        for n in 0..100 {
            worker.request(|_| n);
        }
        worker.wait();
        assert!(!worker.is_busy() && worker.owes(), "done, and not taken yet");
        assert_eq!(worker.answers().last(), Some(&198));
        assert!(!worker.is_busy() && !worker.owes());
    }
}
