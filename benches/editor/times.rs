//! Times of many runs, reported as their median and 95th percentile.

use chiaro::clock::Clock;

/// Time that `work` takes in seconds, and its result.
pub(crate) fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let clock = Clock::start();
    let result = work();
    (clock.seconds(), result)
}

/// Median and 95th percentile of `values`.
pub(crate) fn spread(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    [50, 95].map(|percent| values.get(values.len() * percent / 100).copied().unwrap_or(f64::NAN))
}

/// Median and 95th percentile of times in seconds, as text for a table, in milliseconds.
pub(crate) fn told(seconds: Vec<f64>) -> String {
    let [median, p95] = spread(seconds).map(|seconds| seconds * 1e3);
    format!("{median:.2} / {p95:.2}")
}
