//! Times of the pass that draws looks, and of those before it.

use chiaro::accuracy::TimeEstimate;
use chiaro::accuracy::cost::alternate;
use chiaro::frame::{FramePlan, PassId};
use chiaro::progress::Progress;
use chiaro::render::Renderer;
use chiaro_test_drawing::wait::block_on;

/// Median milliseconds of the look pass of each plan, and of all passes before it together, in
/// turns, by the GPU's own clock.
pub(super) fn look_passes(
    renderer: &mut Renderer,
    plans: &[FramePlan],
    rounds: usize,
) -> Vec<(f64, f64)> {
    let plans: Vec<&FramePlan> = plans.iter().collect();
    let Ok(series) = block_on(alternate(renderer, &plans, rounds, &Progress::new())) else {
        panic!("it was stopped");
    };
    let median = |times: &[f64]| TimeEstimate::of(times).median;
    let own = |passes: &[(PassId, Vec<f64>)]| {
        let (looks, before): (Vec<_>, Vec<_>) =
            passes.iter().partition(|(pass, _)| *pass == PassId::LOOK);
        let sum = |passes: &[&(PassId, Vec<f64>)]| {
            passes.iter().map(|(_, times)| median(times)).sum::<f64>()
        };
        (sum(&looks), sum(&before))
    };
    series.iter().map(|series| own(&series.passes)).collect()
}
