//! Survey: all measurements of an accuracy report, on all cores.
//!
//! Cases and looks are independent of each other, so each is a job; workers take the next one, and
//! the results stand in the report in the order of the jobs, whichever worker finished first.

use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::pin::Pin;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, mpsc};
use std::thread;

use super::case::Case;
use super::looks::{LookEffort, LookFigures, measure_look};
use super::measure::{CaseFigures, Effort, Laboratory};
use super::report::AccuracyReport;
use super::search::WorstInput;
use super::stability::{MESHES, StabilityEffort, StabilityFigures, measure_stability};
use crate::accuracy::MeasureError;
use crate::frame::Executor;
use crate::library::Library;
use crate::progress::Progress;
use crate::render::{Gpu, Renderer};

/// Part of a survey.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurveyPart {
    /// Nodes, each alone.
    Nodes,
    /// Pictures of looks.
    Looks,
    /// Flicker of looks.
    Stability,
}

impl SurveyPart {
    /// All parts, in the order of the report.
    pub const ALL: [Self; 3] = [Self::Nodes, Self::Looks, Self::Stability];
}

/// Nodes and looks that are surveyed.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey {
    /// Parts that are made.
    pub parts: Vec<SurveyPart>,
    /// Kinds of nodes; all kinds if empty.
    pub nodes: Vec<String>,
    /// Extent of the measurements of each node.
    pub effort: Effort,
    /// Files of the looks that are drawn.
    pub looks: Vec<PathBuf>,
    /// Pictures of each look that are compared.
    pub look_effort: LookEffort,
    /// Largest pictures of each look that are compared; none if `None`.
    pub large: Option<LookEffort>,
    /// Extent of the flicker measurements.
    pub stability: StabilityEffort,
}

/// Largest number of workers: each holds pictures and shaders of its own, and the reference renders
/// a picture on all cores anyway.
const MOST_WORKERS: usize = 4;
/// Number of the worst samples of a case that are kept for a test to check.
const KEPT_OF_A_CASE: usize = 2;

/// A job of a worker.
enum SurveyTask {
    Case(Case),
    Look(PathBuf),
    Stability(PathBuf),
    /// The largest pictures of a look: only one worker makes such pictures at a time, as two would
    /// take all memory.
    Large(PathBuf),
}

/// Result of a job.
enum TaskResult {
    Case(CaseFigures, Vec<WorstInput>),
    Look(Vec<LookFigures>),
    Stability(Vec<StabilityFigures>),
    Large(Vec<LookFigures>),
}

/// A message of a worker.
enum WorkerMessage {
    /// The job of this number is done.
    Finished(usize, TaskResult),
    /// The worker failed, or was stopped.
    Failed(MeasureError),
}

/// Function that blocks its thread until a future is done. A survey has threads of its own, and the
/// library itself blocks nowhere: the caller of a survey decides how to wait.
pub type FutureWaiter<'a> = &'a (dyn Fn(Pin<Box<dyn Future<Output = ()> + '_>>) + Sync);

/// Runs all jobs of a survey, each worker on a thread of its own that `wait`s for its device.
///
/// # Errors
/// Problems of a look or a node, a missing GPU or its errors, or `Interruption` if `progress` was
/// stopped.
#[expect(
    clippy::disallowed_methods,
    reason = "the one place of the survey that starts threads: each waits for a device of its own"
)]
pub async fn survey(
    survey: &Survey,
    library: &Library,
    progress: &Progress,
    wait: FutureWaiter<'_>,
) -> Result<AccuracyReport, MeasureError> {
    let has = |part| survey.parts.contains(&part);
    let looks = |part| survey.looks.iter().filter(move |_| has(part)).cloned();
    let mut kinds: Vec<&String> = library.nodes.keys().collect();
    kinds.retain(|_| has(SurveyPart::Nodes));
    kinds.retain(|kind| survey.nodes.is_empty() || survey.nodes.contains(kind));
    kinds.sort_unstable();
    let cases: Vec<Case> =
        kinds.into_iter().flat_map(|kind| Case::of(&library.nodes[kind])).collect();
    let large = survey.large.as_ref().map_or(0, LookEffort::truths);
    let pictures = looks(SurveyPart::Looks).count() * (survey.look_effort.truths() + large);
    let frames = looks(SurveyPart::Stability).count() * MESHES.len() * survey.stability.frames;
    let steps = (cases.len() + pictures + frames) as u64;
    progress.expect(steps);
    let progress = progress.part(steps);
    progress.begin(steps);
    let large = looks(SurveyPart::Looks).filter(|_| survey.large.is_some());
    let large: Vec<SurveyTask> = large.map(SurveyTask::Large).collect();
    // The jobs that take longest come first.
    let small = looks(SurveyPart::Stability)
        .map(SurveyTask::Stability)
        .chain(looks(SurveyPart::Looks).map(SurveyTask::Look))
        .chain(cases.into_iter().map(SurveyTask::Case));
    let first_small = large.len();
    let jobs: Vec<SurveyTask> = large.into_iter().chain(small).collect();

    let gpu = Gpu::headless().await?;
    let report = AccuracyReport {
        adapter: gpu.name(),
        is_software: gpu.is_software(),
        ..AccuracyReport::default()
    };
    let team = SurveyState {
        survey,
        library,
        jobs: &jobs,
        first_small,
        next_large: Mutex::new(0),
        next_small: AtomicUsize::new(first_small),
        progress,
    };
    let workers = thread::available_parallelism().map_or(1, NonZero::get).min(MOST_WORKERS);
    let (tell, told) = mpsc::channel();
    let found = thread::scope(|scope| {
        for _ in 0..workers {
            let tell = tell.clone();
            let team = &team;
            scope.spawn(move || wait(Box::pin(team.work(&tell))));
        }
        drop(tell);
        team.gather(&told)
    })?;
    Ok(report.with(found))
}

/// An executor on a device of its own: software Vulkan keeps memory of each shader as long as the
/// device lives, which sixty looks would fill.
async fn precise() -> Result<Box<dyn Executor + Send>, MeasureError> {
    Ok(Gpu::headless().await?.precise().executor())
}

/// State that workers share.
struct SurveyState<'a> {
    survey: &'a Survey,
    library: &'a Library,
    /// All jobs, the large ones first.
    jobs: &'a [SurveyTask],
    /// Index of the first job that is not large.
    first_small: usize,
    /// Index of the next large job; the worker of a large job holds the lock.
    next_large: Mutex<usize>,
    /// Index of the next other job.
    next_small: AtomicUsize,
    /// Progress of all workers; stopped, too, when one of them fails.
    progress: Progress,
}

impl SurveyState<'_> {
    /// Does one job after the other, and reports the error that ends the work.
    async fn work(&self, tell: &mpsc::Sender<WorkerMessage>) {
        if let Err(why) = self.work_on(tell).await {
            // The error is sent before the stop, so that it arrives before the `Interruption` of
            // the other workers.
            drop(tell.send(WorkerMessage::Failed(why)));
            self.progress.stop();
        }
    }

    /// Does jobs until there are no more, on a device of its own.
    async fn work_on(&self, tell: &mpsc::Sender<WorkerMessage>) -> Result<(), MeasureError> {
        let mut renderer = Renderer::new(Gpu::headless().await?);
        let mut lab = Laboratory::new(self.library, &mut renderer)?;
        while let Some((number, _alone)) = self.next_job() {
            let found = match &self.jobs[number] {
                SurveyTask::Case(case) => self.measure_case(case, &mut lab).await,
                SurveyTask::Look(path) => self.measure_look(path, &mut *precise().await?).await,
                SurveyTask::Stability(path) => {
                    self.measure_stability(path, &mut *precise().await?).await
                }
                SurveyTask::Large(path) => self.measure_large(path, &mut *precise().await?).await,
            }?;
            if tell.send(WorkerMessage::Finished(number, found)).is_err() {
                break;
            }
        }
        Ok(())
    }

    /// The next large job if no other worker has one, else the next other job; the guard is held
    /// until the large job is done.
    fn next_job(&self) -> Option<(usize, Option<MutexGuard<'_, usize>>)> {
        if self.progress.is_stopped() {
            return None;
        }
        if let Ok(mut next) = self.next_large.try_lock()
            && *next < self.first_small
        {
            *next += 1;
            return Some((*next - 1, Some(next)));
        }
        let number = self.next_small.fetch_add(1, Ordering::Relaxed);
        (number < self.jobs.len()).then_some((number, None))
    }

    async fn measure_case(
        &self,
        case: &Case,
        lab: &mut Laboratory<'_>,
    ) -> Result<TaskResult, MeasureError> {
        let measured = lab.measure(case, &self.survey.effort).await?;
        let bench = lab.bench(case)?;
        let worst =
            measured.worst.iter().take(KEPT_OF_A_CASE).filter(|finding| finding.error > 0.0);
        let worst = worst.map(|finding| WorstInput::new(&bench, finding)).collect();
        self.progress.step()?;
        Ok(TaskResult::Case(measured, worst))
    }

    async fn measure_look(
        &self,
        path: &Path,
        precise: &mut dyn Executor,
    ) -> Result<TaskResult, MeasureError> {
        let progress = &self.progress;
        let drawn =
            measure_look(path, self.library, precise, &self.survey.look_effort, progress).await?;
        Ok(TaskResult::Look(drawn))
    }

    async fn measure_stability(
        &self,
        path: &Path,
        precise: &mut dyn Executor,
    ) -> Result<TaskResult, MeasureError> {
        let (effort, progress) = (&self.survey.stability, &self.progress);
        let mut found = Vec::new();
        for mesh in MESHES {
            found.push(
                measure_stability(path, mesh, self.library, precise, effort, progress).await?,
            );
        }
        Ok(TaskResult::Stability(found))
    }

    async fn measure_large(
        &self,
        path: &Path,
        precise: &mut dyn Executor,
    ) -> Result<TaskResult, MeasureError> {
        let effort = self.survey.large.clone().unwrap_or_else(LookEffort::large);
        let drawn = measure_look(path, self.library, precise, &effort, &self.progress).await?;
        Ok(TaskResult::Large(drawn))
    }

    /// Results of all jobs, in their order. The first failure stops all workers.
    fn gather(
        &self,
        told: &mpsc::Receiver<WorkerMessage>,
    ) -> Result<Vec<TaskResult>, MeasureError> {
        let mut found: Vec<Option<TaskResult>> = self.jobs.iter().map(|_| None).collect();
        let mut failed = None;
        // The loop ends when the last worker has dropped its sender.
        for message in told {
            match message {
                WorkerMessage::Finished(number, of) => found[number] = Some(of),
                WorkerMessage::Failed(why) => {
                    failed.get_or_insert(why);
                }
            }
        }
        failed.map_or_else(|| Ok(self.progress.check()?), Err)?;
        Ok(found.into_iter().flatten().collect())
    }
}

impl AccuracyReport {
    fn with(mut self, found: Vec<TaskResult>) -> Self {
        for found in found {
            match found {
                TaskResult::Case(measured, worst) => {
                    self.nodes.push(measured);
                    self.worst.extend(worst);
                }
                TaskResult::Look(drawn) => self.looks.extend(drawn),
                TaskResult::Stability(found) => self.stability.extend(found),
                TaskResult::Large(drawn) => self.large.extend(drawn),
            }
        }
        self
    }
}
