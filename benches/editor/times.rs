//! Times of many runs, told as their median and 95th percentile.

use chiaro::clock::Clock;

/// Seconds that `work` takes, and what it comes to.
pub(crate) fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let clock = Clock::start();
    let result = work();
    (clock.seconds(), result)
}

/// Median and 95th percentile.
pub(crate) fn spread(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    [50, 95].map(|percent| values.get(values.len() * percent / 100).copied().unwrap_or(f64::NAN))
}

/// Both of them in milliseconds, for a table; the times are in seconds.
pub(crate) fn told(seconds: Vec<f64>) -> String {
    let [median, p95] = spread(seconds).map(|seconds| seconds * 1e3);
    format!("{median:.2} / {p95:.2}")
}
