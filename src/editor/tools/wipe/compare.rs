//! Drawing of both pictures, on the thread.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::ColorImage;

use super::image::fitted;
use super::{ComparisonInputs, ComparisonRequest, ComparisonResult, PictureComparison};
use crate::accuracy::{PremultipliedPicture, Truth, Variant, compare};
use crate::compile::Live;
use crate::diag::{Diagnostic, has_errors};
use crate::document::{Document, Tier};
use crate::frame::{Assets, CullMode, Executor, Picture, PlanOptions, Planner, Setup};
use crate::progress::Progress;
use crate::render::Gpu;
use crate::state::comparison::ComparedPicture;
use crate::state::session::Session;
use crate::state::snapshot::{CachedPlanner, RenderSnapshot};

/// Source of a picture, for the thread.
pub(super) enum PictureSource {
    /// The look of a snapshot of the session.
    Look(Box<RenderSnapshot>),
    /// The look in another tier.
    Tier(Box<RenderSnapshot>, Tier),
    Truth(Box<RenderSnapshot>),
    /// The look in a file, in place of that of a snapshot of the session.
    LookFile(Box<RenderSnapshot>, PathBuf),
    Image(Box<RenderSnapshot>, PathBuf),
    /// Nothing, for a reason.
    Missing(Diagnostic),
}

impl PictureSource {
    /// Source of a picture in the present view.
    pub(super) fn of(picture: &ComparedPicture, session: &Session) -> Self {
        let now = || Box::new(session.snapshot());
        match picture {
            ComparedPicture::Present => Self::Look(now()),
            ComparedPicture::Truth => Self::Truth(now()),
            ComparedPicture::Tier(tier) => Self::Tier(now(), *tier),
            ComparedPicture::Snapshot(id) => match session.shelf().of(*id) {
                Some(snapshot) => Self::Look(Box::new(session.snapshot_of(snapshot.look.clone()))),
                None => Self::Missing(Diagnostic::error(
                    "no-snapshot",
                    tr!("the snapshot was deleted, or is of another look; undo may bring it back"),
                )),
            },
            ComparedPicture::Saved => match session.path() {
                Some(path) => Self::LookFile(now(), path.to_owned()),
                None => Self::Missing(Diagnostic::error(
                    "no-file",
                    tr!("the look is in no file yet: save it, and change it"),
                )),
            },
            ComparedPicture::LookFile(path) => Self::LookFile(now(), path.clone()),
            ComparedPicture::Image(path) => Self::Image(now(), path.clone()),
        }
    }
}

/// State of the thread between comparisons.
pub(super) struct Comparer {
    /// Executor, made when first needed, on a device of its own: the window's may not blend 32-bit
    /// floats, and the rounding of a 16-bit picture would show in the difference.
    executor: Option<Box<dyn Executor + Send>>,
    window: Gpu,
    /// Planners of the left picture and of the right one.
    planners: [CachedPlanner; 2],
}

impl Comparer {
    pub(super) fn new(window: Gpu) -> Self {
        let planner =
            || CachedPlanner::new(|assets| Planner::new(assets).culling(CullMode::Objects));
        Self { executor: None, window, planners: [planner(), planner()] }
    }

    pub(super) async fn run(&mut self, job: ComparisonRequest) -> ComparisonResult {
        let result = self.try_run(&job).await;
        ComparisonResult { moment: job.moment, result }
    }

    async fn try_run(
        &mut self,
        job: &ComparisonRequest,
    ) -> Result<PictureComparison, Vec<Diagnostic>> {
        let [left, right] = &job.sources;
        let present = self.picture(0, left, &job.moment).await?;
        if let PictureSource::Truth(snapshot) = right {
            let truth = truth(snapshot, &job.moment, &job.progress)?;
            let wanted = truth.picture().to_picture();
            return Ok(together(&present, &wanted, &truth.colors(), |index| truth.is_edge(index)));
        }
        let other = self.picture(1, right, &job.moment).await?;
        Ok(together(&present, &other, &PremultipliedPicture::from(&other), |_| false))
    }

    /// Draws the picture of a source on a side.
    async fn picture(
        &mut self,
        side: usize,
        source: &PictureSource,
        moment: &ComparisonInputs,
    ) -> Result<Picture, Vec<Diagnostic>> {
        match source {
            PictureSource::Look(snapshot) | PictureSource::Truth(snapshot) => {
                self.draw(side, snapshot, None, moment).await
            }
            PictureSource::Tier(snapshot, tier) => {
                self.draw(side, snapshot, Some(*tier), moment).await
            }
            PictureSource::LookFile(snapshot, path) => {
                let snapshot = from_file(snapshot, path)?;
                let drawn = self.draw(side, &snapshot, None, moment).await;
                drawn.map_err(|problems| problems.into_iter().map(|of| told(of, path)).collect())
            }
            PictureSource::Image(snapshot, path) => {
                let image = Assets::of(&snapshot.assets)
                    .image(Path::new(""), &path.display().to_string())
                    .map_err(|problem| vec![problem])?;
                Ok(fitted(image.size, &image.rgba(), moment.size))
            }
            PictureSource::Missing(problem) => Err(vec![problem.clone()]),
        }
    }

    async fn draw(
        &mut self,
        side: usize,
        snapshot: &RenderSnapshot,
        tier: Option<Tier>,
        moment: &ComparisonInputs,
    ) -> Result<Picture, Vec<Diagnostic>> {
        let executor = match &mut self.executor {
            Some(executor) => executor,
            none => {
                let gpu = Gpu::headless().await.unwrap_or_else(|_| self.window.clone());
                none.insert(gpu.precise().executor())
            }
        };
        let planner = self.planners[side].of(&snapshot.look, &snapshot.library);
        let mut setup = snapshot.setup(&mut planner.assets)?.value;
        if let Some(tier) = tier {
            setup = Variant::Looks(tier).of(&setup);
        }
        let options = PlanOptions { size: moment.size, samples: 1, time: snapshot.time };
        let plan = planner.plan(&setup, &snapshot.library, &Live::Keyed, &options)?.value;
        executor.picture(&plan, &Progress::new()).await.map_err(|problem| vec![problem])
    }
}

/// A snapshot with the look of a file in place of its own.
fn from_file(snapshot: &RenderSnapshot, path: &Path) -> Result<RenderSnapshot, Vec<Diagnostic>> {
    let files = snapshot.assets.source();
    let Document::Look(loaded) = Document::load(&**files, path) else {
        let problem = Diagnostic::error("not-a-look", tr!("it is a scene or a shot"));
        let hint =
            tr!("\"Another document...\" holds scenes and shots against the timeline's frames");
        return Err(vec![told(problem.hint(hint), path)]);
    };
    if has_errors(&loaded.diagnostics) {
        let errors = loaded.diagnostics.into_iter().filter(Diagnostic::is_error);
        return Err(errors.map(|problem| told(problem, path)).collect());
    }
    let none = || vec![told(Diagnostic::error("not-a-look", tr!("there is no look in it")), path)];
    let look = Arc::new(loaded.value.ok_or_else(none)?);
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    Ok(RenderSnapshot { look, source: Arc::new(loaded.source), folder, ..snapshot.clone() })
}

/// A problem with the name of its file.
fn told(mut problem: Diagnostic, path: &Path) -> Diagnostic {
    problem.message = format!("{}: {}", path.display(), problem.message);
    problem
}

fn truth(
    snapshot: &RenderSnapshot,
    moment: &ComparisonInputs,
    progress: &Progress,
) -> Result<Truth, Vec<Diagnostic>> {
    let options = PlanOptions { size: moment.size, samples: 1, time: snapshot.time };
    let mut planner = Planner::for_truth(Assets::of(&snapshot.assets));
    let setup: Setup = snapshot.setup(&mut planner.assets)?.value;
    let setup = Variant::Looks(Tier::Exact).of(&setup);
    Ok(Truth::of(&setup, &snapshot.library, &mut planner, &options, progress)?)
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
