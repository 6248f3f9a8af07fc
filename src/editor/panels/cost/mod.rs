//! Cost of the picture as it was just drawn, with the causes of its passes; and on request measured
//! time and error of the look and of each of its nodes, in each tier, in the background: the look
//! as it is set at once, in three drawings, then its tiers, then all of it. A click on a tier
//! adopts it. Counted operations are in `panels::effects`.

mod causes;
mod now;
mod panel;
mod plot;

use std::collections::HashMap;
use std::sync::Arc;

use crate::accuracy::cost::alternate;
use crate::accuracy::{
    BenchOptions, BenchReport, MeasureError, MeasuredNodes, MeasuredTier, MeasurementRow,
    MeasurementSubject, Series, bench,
};
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::{Edit, GraphId, Look, Tier};
use crate::frame::{Assets, PlanOptions, Planner, Setup};
use crate::ids::NodeId;
use crate::progress::{Interruption, Progress};
use crate::render::{Gpu, Renderer};
use crate::state::revision::{DocumentNumber, LookRevision, PictureRevision};
use crate::state::session::Session;
use crate::state::snapshot::RenderSnapshot;
use crate::state::stack::owners::LayerOwners;
use crate::state::stack::tree::LayerTree;
use crate::state::worker::{BackgroundJobs, Worker};
use causes::{CauseRequest, PassCause, causes};
pub(super) use panel::PANEL;

/// Number of times that each variant is drawn: enough for a confidence interval, without a long
/// wait.
const ROUNDS: usize = 15;
/// Number of times that each tier of the look is drawn for the second answer.
const QUICK_ROUNDS: usize = 3;
/// Number of times that the look is drawn for the first answer, once it is warm.
const FIRST_ROUNDS: usize = 1;

/// Extent of a measurement: each is followed by the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum MeasureStage {
    /// The time of the look as it is set.
    AsSet,
    /// The time of the look in each tier.
    Tiers,
    /// Time and error of the look and of its nodes.
    All,
}

impl MeasureStage {
    fn next(self) -> Option<Self> {
        match self {
            Self::AsSet => Some(Self::Tiers),
            Self::Tiers => Some(Self::All),
            Self::All => None,
        }
    }
}

#[derive(Clone)]
struct MeasureRequest {
    snapshot: RenderSnapshot,
    size: [u32; 2],
    progress: Progress,
    stage: MeasureStage,
}

struct Measurement {
    of: CostSubject,
    stage: MeasureStage,
    result: Result<BenchReport, Vec<Diagnostic>>,
}

/// Inputs of a measurement: tiers and positions of nodes do not change its figures.
#[derive(Clone, PartialEq)]
struct CostSubject {
    look: Look,
    mesh: String,
    scene: Option<PictureRevision>,
}

impl CostSubject {
    fn of(look: &Look, mesh: &str, scene: Option<PictureRevision>) -> Self {
        let mut look = Look { tier: Some(Tier::Exact), ..look.clone() };
        for node in look.graph.nodes.values_mut() {
            node.tier = None;
            node.position = [0.0; 2];
        }
        Self { look, mesh: mesh.to_owned(), scene }
    }
}

/// The panel and the last measurement.
pub struct Cost {
    worker: Option<Worker<MeasureRequest, Measurement>>,
    /// Called from another thread when there is more progress to show.
    wake: Arc<dyn Fn() + Send + Sync>,
    progress: Progress,
    done: Option<Measurement>,
    /// Subject that is plotted: the look or a node.
    subject: MeasurementSubject,
    /// True if the last measurement still holds, with the revision that this was found for.
    is_current: (Option<(DocumentNumber, LookRevision)>, bool),
    /// Request that is worked at, for the next stage to follow.
    asked: Option<MeasureRequest>,
    /// Thread that finds the causes of passes, for revisions of the look.
    causer: Worker<(CausesOf, CauseRequest), (CausesOf, Vec<PassCause>)>,
    cause_search: Progress,
    causes: Vec<PassCause>,
    causes_of: Option<CausesOf>,
    /// Layers that nodes work for, in the revision that `is_current` was found for.
    owners: LayerOwners,
}

/// Revision of the look that causes are of.
type CausesOf = (DocumentNumber, LookRevision);

impl Cost {
    /// Starts no measurement by itself. `wake` is called from another thread when there is progress
    /// or a result. Without a GPU nothing can be measured.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Clone + Send + Sync + 'static) -> Self {
        let start = |gpu: Gpu| {
            let mut renderer = None;
            Worker::waiting("measure", wake.clone(), async move |job| {
                measure(&mut renderer, &gpu, &job).await
            })
        };
        Self {
            causer: Worker::new("causes", wake.clone(), |(of, request)| (of, causes(&request))),
            cause_search: Progress::new(),
            causes: Vec::new(),
            causes_of: None,
            owners: LayerOwners::default(),
            asked: None,
            worker: gpu.map(start),
            progress: Progress::new(),
            wake: Arc::new(wake),
            done: None,
            subject: MeasurementSubject::Whole,
            is_current: (None, false),
        }
    }

    /// Report of the last measurement.
    pub fn report(&self) -> Option<&BenchReport> {
        self.done.as_ref().and_then(|done| done.result.as_ref().ok())
    }

    /// Share of the picture's time that each node takes in the tier nearest to the truth, by the
    /// last measurement that still holds.
    pub(crate) fn shares(&self) -> HashMap<NodeId, f64> {
        let mut shares = HashMap::new();
        let Some(report) = self.report().filter(|_| self.is_current.1) else { return shares };
        let is_whole = |row: &&MeasurementRow| row.subject == MeasurementSubject::Whole;
        let whole = report.rows.iter().find(is_whole).map_or(0.0, |row| row.time.median);
        for row in &report.rows {
            if let MeasurementSubject::Node { id, .. } = &row.subject
                && whole > 0.0
            {
                shares.entry(id.clone()).or_insert(row.time.median.max(0.0) / whole);
            }
        }
        shares
    }

    fn start(&mut self, session: &Session, size: [u32; 2]) {
        self.stop();
        // In a scene only the figures of the open look are asked for, as only its tiers can be
        // chosen.
        let snapshot = session.snapshot_of(Arc::new(session.look().clone())).alone();
        self.measure(snapshot, size, MeasureStage::AsSet);
    }

    fn is_measuring(&self) -> bool {
        self.worker.as_ref().is_some_and(Worker::is_busy)
    }

    fn measure(&mut self, snapshot: RenderSnapshot, size: [u32; 2], stage: MeasureStage) {
        let wake = self.wake.clone();
        self.progress = Progress::observed(move |_| wake());
        let request = MeasureRequest { snapshot, size, progress: self.progress.clone(), stage };
        self.asked = Some(request.clone());
        if let Some(worker) = &self.worker {
            worker.request(|_| request);
        }
    }

    fn stop(&mut self) {
        self.progress.stop();
        self.asked = None;
    }

    /// Takes a finished measurement, and finds out whether the last one still holds.
    fn update(&mut self, session: &Session) {
        for done in self.worker.as_ref().map(Worker::answers).unwrap_or_default() {
            // A measurement that was stopped leaves the one before in place.
            let is_stopped =
                done.result.as_ref().is_err_and(|problems| Interruption::is_among(problems));
            if is_stopped {
                continue;
            }
            let next = done.stage.next().filter(|_| done.result.is_ok());
            if let (Some(stage), Some(asked)) = (next, self.asked.take()) {
                self.measure(asked.snapshot, asked.size, stage);
            }
            // Figures of more stay until they are measured again.
            let stays = |known: &Measurement| {
                done.stage < known.stage && known.result.is_ok() && known.of == done.of
            };
            if !self.done.as_ref().is_some_and(stays) {
                self.done = Some(done);
                self.is_current.0 = None;
            }
        }
        let revision = Some((session.revisions().document, session.revision()));
        if self.is_current.0 != revision {
            let now =
                CostSubject::of(session.look(), &session.view.orbit.mesh, session.scene_revision());
            let tree = LayerTree::of(session.look(), &session.project.catalog);
            self.owners = LayerOwners::of(session.look(), &tree);
            self.is_current = (revision, self.done.as_ref().is_some_and(|done| done.of == now));
        }
    }
}

impl BackgroundJobs for Cost {
    fn is_busy(&self) -> bool {
        self.is_measuring() || self.causer.is_busy()
    }

    fn wait(&self) {
        if let Some(worker) = &self.worker {
            worker.wait();
        }
        self.causer.wait();
    }
}

impl Drop for Cost {
    fn drop(&mut self) {
        self.stop();
        self.cause_search.stop();
    }
}

/// Edit that adopts a row's tier, as one step; `None` where the look has that tier already, or
/// where the row is not a choice.
fn adopt(look: &Look, row: &MeasurementRow) -> Option<Edit> {
    if !row.tier.is_choice() {
        return None;
    }
    let tier = row.tier.of_look();
    let set = |id: &NodeId, tier| Edit::SetTier { graph: GraphId::Look, id: id.clone(), tier };
    match &row.subject {
        MeasurementSubject::Whole => {
            let mut edits: Vec<Edit> = Vec::new();
            if look.tier != tier {
                edits.push(Edit::SetLookTier { tier });
            }
            let own = look.graph.nodes.iter().filter(|(_, node)| node.tier.is_some());
            edits.extend(own.map(|(id, _)| set(id, None)));
            match edits.len() {
                0 => None,
                1 => edits.pop(),
                _ => Some(Edit::Group { edits }),
            }
        }
        MeasurementSubject::Node { id, .. } => {
            let node = look.graph.nodes.get(id)?;
            (node.tier.or(look.tier) != tier).then(|| set(id, tier.filter(|_| look.tier != tier)))
        }
        MeasurementSubject::Pass(_) => None,
    }
}

async fn measure(
    renderer: &mut Option<Renderer>,
    window: &Gpu,
    job: &MeasureRequest,
) -> Measurement {
    // The measurement has a device of its own: the window's may have no timestamps, and is busy
    // with drawing the window.
    let renderer = match renderer {
        Some(renderer) => renderer,
        None => {
            let gpu = Gpu::headless().await.unwrap_or_else(|_| window.clone());
            renderer.insert(Renderer::new(gpu))
        }
    };
    let mut run = async || {
        let setup = job.snapshot.setup(&mut Assets::of(&job.snapshot.assets))?.value;
        let plan = PlanOptions { size: job.size, samples: 1, time: job.snapshot.time };
        let (rounds, nodes, truth) = match job.stage {
            MeasureStage::AsSet => {
                return measure_as_set(&setup, renderer, plan, job).await.map_err(Vec::from);
            }
            MeasureStage::Tiers => (QUICK_ROUNDS, MeasuredNodes::None, false),
            MeasureStage::All => (ROUNDS, MeasuredNodes::Tiered, true),
        };
        let options = BenchOptions { plan, rounds, nodes, truth };
        bench(&setup, &job.snapshot.library, renderer, &options, &job.progress)
            .await
            .map_err(Vec::from)
    };
    let result = run().await;
    let scene = job.snapshot.scene.as_ref().map(|scene| scene.revision());
    let of = CostSubject::of(&job.snapshot.look, &job.snapshot.orbit.mesh, scene);
    Measurement { of, stage: job.stage, result }
}

/// Measures the time of the look as it is set, and nothing else.
async fn measure_as_set(
    setup: &Setup,
    renderer: &mut Renderer,
    options: PlanOptions,
    job: &MeasureRequest,
) -> Result<BenchReport, MeasureError> {
    let library = &job.snapshot.library;
    let plan = Planner::default().plan(setup, library, &Live::Keyed, &options)?.value;
    job.progress.expect((FIRST_ROUNDS + 2) as u64);
    let series = alternate(renderer, &[&plan], FIRST_ROUNDS, &job.progress).await?;
    let time = series.first().map(Series::estimate).unwrap_or_default();
    let (subject, tier) = (MeasurementSubject::Whole, MeasuredTier::AsSet);
    let row = MeasurementRow { subject, tier, time, sizes: None, error: None };
    let gpu = renderer.gpu();
    Ok(BenchReport {
        adapter: gpu.name(),
        is_software: gpu.is_software(),
        has_timestamps: gpu.has_timestamps(),
        size: options.size,
        samples: options.samples,
        rounds: FIRST_ROUNDS,
        rows: vec![row],
    })
}
