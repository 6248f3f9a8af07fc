//! Times of the pass that draws looks.

use chiaro::accuracy::TimeEstimate;
use chiaro::accuracy::cost::alternate;
use chiaro::frame::{FramePlan, PassId};
use chiaro::progress::Progress;
use chiaro::render::Renderer;
use chiaro_test_drawing::wait::block_on;

/// Median milliseconds of the look pass of each plan, in turns, by the GPU's own clock.
pub(super) fn look_passes(renderer: &mut Renderer, plans: &[FramePlan], rounds: usize) -> Vec<f64> {
    let plans: Vec<&FramePlan> = plans.iter().collect();
    let Ok(series) = block_on(alternate(renderer, &plans, rounds, &Progress::new())) else {
        panic!("it was stopped");
    };
    let own = |passes: &[(PassId, Vec<f64>)]| {
        let times = passes.iter().find(|(pass, _)| *pass == PassId::LOOK);
        TimeEstimate::of(times.map_or(&[], |(_, times)| times)).median
    };
    series.iter().map(|series| own(&series.passes)).collect()
}
