//! Cost in time: variants are measured in turns with what they are compared with, because machines
//! drift and are shared; the result is a median with its confidence interval.

use serde::Serialize;

use super::MeasureError;
use crate::frame::{FramePlan, PassId};
use crate::progress::Progress;
use crate::render::Renderer;

/// Frames before the first that counts: they create pipelines and fill caches.
const WARM_UP: usize = 2;

/// A median with its 95% confidence interval, in milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct TimeEstimate {
    /// Half of the measurements lie below the median.
    pub median: f64,
    /// Lower end of the interval: the true median is rarely below.
    pub low: f64,
    /// Upper end of the interval: the true median is rarely above.
    pub high: f64,
}

impl TimeEstimate {
    /// The median of `samples`, and the interval by order statistics, which assumes nothing about
    /// the distribution of the samples. Zeros if there are no samples.
    pub fn of(samples: &[f64]) -> Self {
        let mut sorted = samples.to_vec();
        sorted.sort_by(f64::total_cmp);
        let Some(last) = sorted.len().checked_sub(1) else { return Self::default() };
        let count = sorted.len() as f64;
        // The number of samples below the median is binomial(n, 1/2): close enough to normal from
        // six samples on.
        let reach = 0.98 * count.sqrt();
        let low = (0.5 * count - reach).floor().max(0.0) as usize;
        let high = (0.5 * count + reach).ceil() as usize;
        let median = 0.5 * (sorted[last / 2] + sorted[last.div_ceil(2)]);
        Self { median, low: sorted[low.min(last)], high: sorted[high.min(last)] }
    }

    /// True if 0 lies within the interval: no difference was seen beyond the noise.
    pub fn is_noise(&self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }
}

/// Times of one plan in each round, in milliseconds.
#[derive(Clone, Debug, Default)]
pub struct Series {
    /// Times of the whole frame, by round.
    pub frame: Vec<f64>,
    /// Times of each pass, by round.
    pub passes: Vec<(PassId, Vec<f64>)>,
}

impl Series {
    /// The median time of the frame.
    pub fn estimate(&self) -> TimeEstimate {
        TimeEstimate::of(&self.frame)
    }

    /// Additional time of this series over `other` in the same rounds, in milliseconds.
    pub fn over(&self, other: &Self) -> TimeEstimate {
        let pairs: Vec<f64> = self.frame.iter().zip(&other.frame).map(|(a, b)| a - b).collect();
        TimeEstimate::of(&pairs)
    }

    /// Ratio of this series' time to `other`'s in the same rounds.
    pub fn ratio(&self, other: &Self) -> TimeEstimate {
        let pairs: Vec<f64> =
            self.frame.iter().zip(&other.frame).map(|(a, b)| a / b.max(1e-9)).collect();
        TimeEstimate::of(&pairs)
    }
}

/// Measures the plans in turns, `rounds` times each.
///
/// # Errors
/// Errors of the GPU, or `Interruption` if `progress` was stopped.
pub async fn alternate(
    renderer: &mut Renderer,
    plans: &[&FramePlan],
    rounds: usize,
    progress: &Progress,
) -> Result<Vec<Series>, MeasureError> {
    let mut series = vec![Series::default(); plans.len()];
    for round in 0..WARM_UP + rounds {
        progress.step()?;
        // Every other round runs backwards, so that no plan always follows the same one.
        let forwards = round % 2 == 0;
        for turn in 0..plans.len() {
            let index = if forwards { turn } else { plans.len() - 1 - turn };
            let times = renderer.measure(plans[index]).await?;
            if round < WARM_UP {
                continue;
            }
            let of = &mut series[index];
            of.frame.push(times.iter().map(|time| time.duration.as_secs_f64() * 1e3).sum());
            of.passes.resize_with(times.len(), || (PassId::LOOK, Vec::new()));
            for (slot, time) in of.passes.iter_mut().zip(&times) {
                slot.0 = time.id;
                slot.1.push(time.duration.as_secs_f64() * 1e3);
            }
        }
    }
    Ok(series)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_and_its_interval() {
        let samples: Vec<f64> = (1..=25).map(f64::from).collect();
        let estimate = TimeEstimate::of(&samples);
        // The interval reaches 12.5 -+ 4.9 samples.
        assert_eq!((estimate.median, estimate.low, estimate.high), (13.0, 8.0, 19.0));
        assert_eq!(TimeEstimate::of(&[4.0]), TimeEstimate { median: 4.0, low: 4.0, high: 4.0 });
        assert_eq!(TimeEstimate::of(&[]), TimeEstimate::default());
    }

    /// About one experiment in twenty misses the truth, not one in two and not none.
    #[test]
    fn the_interval_holds_the_truth_as_often_as_it_says() {
        let mut state = 9_u64;
        let mut random = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let held = (0..2000).filter(|_| {
            // Samples of a skewed distribution, as times have: the median of -ln(1 - x) is ln 2.
            let samples: Vec<f64> = (0..31).map(|_| -(1.0 - random()).ln()).collect();
            let estimate = TimeEstimate::of(&samples);
            (estimate.low..=estimate.high).contains(&std::f64::consts::LN_2)
        });
        let share = held.count() as f64 / 2000.0;
        assert!((0.93..0.99).contains(&share), "{share}");
    }

    #[test]
    fn drift_does_not_hide_a_difference() {
        let drift = |index: usize| 10.0 + 0.5 * index as f64;
        let with = Series { frame: (0..20).map(|i| drift(i) + 1.0).collect(), passes: Vec::new() };
        let without = Series { frame: (0..20).map(drift).collect(), passes: Vec::new() };
        let difference = with.over(&without);
        assert!((difference.median - 1.0).abs() < 1e-12 && !difference.is_noise());
        assert!(without.over(&without).is_noise());
    }
}
