//! Thread pool: the one place of the reference that starts threads.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use crate::diag::Diagnostic;
use crate::progress::Progress;
use crate::threads;

/// Runs `job` for each number below `count`, on up to `threads` threads, each with a state of its
/// own. Returns the results by number.
///
/// # Errors
/// The first error by number, of those met before all threads had stopped; or `stopped` if
/// `progress` was stopped.
#[expect(
    clippy::disallowed_methods,
    reason = "the one place that starts threads: pictures of a known size, canceled by a flag"
)]
pub(super) fn run<S, T: Send>(
    threads: usize,
    count: usize,
    progress: &Progress,
    state: impl Fn() -> S + Sync,
    job: impl Fn(&mut S, usize) -> Result<T, Diagnostic> + Sync,
) -> Result<Vec<T>, Diagnostic> {
    let next = AtomicUsize::new(0);
    let has_failed = AtomicBool::new(false);
    let finished = Mutex::new(Vec::with_capacity(count));
    let work = || {
        let mut state = state();
        let mut done = Vec::new();
        while !has_failed.load(Ordering::Relaxed) {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= count {
                break;
            }
            let result =
                progress.check().map_err(Diagnostic::from).and_then(|()| job(&mut state, number));
            has_failed.fetch_or(result.is_err(), Ordering::Relaxed);
            done.push((number, result));
        }
        // No thread panics while it holds the lock; if one did, the scope below would pass the
        // panic on.
        finished.lock().unwrap_or_else(std::sync::PoisonError::into_inner).append(&mut done);
    };
    let helpers = threads.min(count).saturating_sub(1);
    std::thread::scope(|scope| {
        for _ in 0..helpers {
            // If no more threads can be started, the existing ones do the work.
            let _ = threads::builder("reference").spawn_scoped(scope, work);
        }
        work();
    });
    let mut results = finished.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    results.sort_by_key(|(number, _)| *number);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_and_problems_stop_the_work() {
        let progress = Progress::new();
        for threads in 1..4 {
            let squares =
                run(threads, 100, &progress, || (), |(), i| Ok(i * i)).expect("nothing fails");
            assert!(
                squares.iter().enumerate().all(|(i, square)| i * i == *square)
                    && squares.len() == 100
            );
            let failing = |(): &mut (), i| {
                if i < 7 { Ok(()) } else { Err(Diagnostic::error("x", format!("{i}"))) }
            };
            let problem = run(threads, 1_000_000, &progress, || (), failing).expect_err("7 fails");
            assert!(problem.message == "7" || threads > 1, "{problem}");
        }
    }
}
