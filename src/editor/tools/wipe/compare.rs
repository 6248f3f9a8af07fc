//! Drawing of both pictures, on the thread.

use eframe::egui::ColorImage;

use super::{ComparisonRequest, ComparisonResult, ComparisonTarget, PictureComparison};
use crate::accuracy::{PremultipliedPicture, Truth, Variant, compare};
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::Tier;
use crate::frame::{Assets, CullMode, Executor, Picture, PlanOptions, Planner, Setup};
use crate::progress::Progress;
use crate::render::Gpu;
use crate::state::snapshot::CachedPlanner;

/// State of the thread between comparisons.
pub(super) struct Comparer {
    /// Executor, made when first needed, on a device of its own: the window's may not blend 32-bit
    /// floats, and the rounding of a 16-bit picture would show in the difference.
    executor: Option<Box<dyn Executor + Send>>,
    window: Gpu,
    planner: CachedPlanner,
}

impl Comparer {
    pub(super) fn new(window: Gpu) -> Self {
        let planner = CachedPlanner::new(|assets| Planner::new(assets).culling(CullMode::Objects));
        Self { executor: None, window, planner }
    }

    pub(super) async fn run(&mut self, job: ComparisonRequest) -> ComparisonResult {
        let result = self.try_run(&job).await;
        ComparisonResult { moment: job.moment, result }
    }

    async fn try_run(
        &mut self,
        job: &ComparisonRequest,
    ) -> Result<PictureComparison, Vec<Diagnostic>> {
        let library = &job.snapshot.library;
        let options = PlanOptions { size: job.moment.size, samples: 1, time: job.snapshot.time };
        let planner = self.planner.of(&job.snapshot.look, &job.snapshot.library);
        let setup = job.snapshot.setup(&mut planner.assets)?.value;
        let executor = match &mut self.executor {
            Some(executor) => executor,
            none => {
                let gpu = Gpu::headless().await.unwrap_or_else(|_| self.window.clone());
                none.insert(gpu.precise().executor())
            }
        };
        let mut draw = async |setup: &Setup| -> Result<Picture, Vec<Diagnostic>> {
            let plan = planner.plan(setup, library, &Live::Keyed, &options)?.value;
            executor.picture(&plan, &Progress::new()).await.map_err(|problem| vec![problem])
        };
        let present = draw(&setup).await?;
        match job.moment.against {
            ComparisonTarget::Tier(tier) => {
                let other = draw(&Variant::Looks(tier).of(&setup)).await?;
                Ok(together(&present, &other, &PremultipliedPicture::from(&other), |_| false))
            }
            ComparisonTarget::Truth => {
                let truth = truth(job, &Variant::Looks(Tier::Exact).of(&setup), &options)?;
                let wanted = truth.picture().to_picture();
                Ok(together(&present, &wanted, &truth.colors(), |index| truth.is_edge(index)))
            }
        }
    }
}

fn truth(
    job: &ComparisonRequest,
    setup: &Setup,
    options: &PlanOptions,
) -> Result<Truth, Vec<Diagnostic>> {
    let mut planner = Planner::for_truth(Assets::of(&job.snapshot.assets));
    let truth = Truth::of(setup, &job.snapshot.library, &mut planner, options, &job.progress);
    Ok(truth?)
}

fn together(
    present: &Picture,
    other: &Picture,
    wanted: &PremultipliedPicture<'_>,
    is_edge: impl Fn(usize) -> bool,
) -> PictureComparison {
    let got = PremultipliedPicture::from(present);
    let figures = compare(&got, wanted, &is_edge);
    let channels = |(index, (a, b)): (usize, (&[f64; 4], &[f64; 4]))| {
        let of = |channel: usize| {
            let difference = (a[channel] - b[channel]).abs();
            if is_edge(index) {
                0.0
            } else if difference.is_finite() {
                difference as f32
            } else {
                f32::MAX
            }
        };
        [of(0), of(1), of(2)]
    };
    let difference = got.rgba.iter().zip(wanted.rgba.iter()).enumerate().map(channels).collect();
    let image = |picture: &Picture| {
        ColorImage::from_rgba_unmultiplied(
            picture.size.map(|side| side as usize),
            &picture.to_rgba8(),
        )
    };
    let pictures = [image(present), image(other)];
    PictureComparison { pictures, difference, figures }
}
