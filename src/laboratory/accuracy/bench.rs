//! Benchmark of a setup's looks: cost and distance from the truth of the whole look, of each node
//! and of each pass.

use super::cost::{Series, alternate};
use super::error::VISIBLE;
use super::report::{BenchReport, MeasuredTier, MeasurementRow, MeasurementSubject};
use super::size::Sizes;
use super::truth::Truth;
use super::variant::{Variant, can_be_left_out, distinct_tiers, tiers_of};
use super::{ErrorFigures, MeasureError, PremultipliedPicture, TimeEstimate};
use crate::compile::Live;
use crate::document::Tier;
use crate::frame::{Assets, Executor, FramePlan, PlanOptions, Planner, Setup};
use crate::ids::NodeId;
use crate::library::Library;
use crate::progress::Progress;
use crate::render::Renderer;

/// Options of a benchmark.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchOptions {
    /// The picture that is drawn: size, samples and time.
    pub plan: PlanOptions,
    /// Number of times each variant is drawn.
    pub rounds: usize,
    /// Nodes that are measured beside the whole look.
    pub nodes: MeasuredNodes,
    /// True if the picture is compared with the reference's.
    pub truth: bool,
}

/// Selection of the nodes that a report has rows of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredNodes {
    /// No nodes: the whole look and its passes only.
    None,
    /// Nodes that have more than one tier.
    Tiered,
    /// Nodes that have more than one tier, and nodes that can be left out.
    Every,
}

/// Measures `setup` on `renderer`'s GPU.
///
/// # Errors
/// Problems of the setup, errors of the GPU, or `Interruption` if `progress` was stopped.
pub async fn bench(
    setup: &Setup,
    library: &Library,
    renderer: &mut Renderer,
    options: &BenchOptions,
    progress: &Progress,
) -> Result<BenchReport, MeasureError> {
    let mut nodes = nodes(setup, library, options.nodes);
    let mut planner = Planner::default();
    for node in &mut nodes {
        let (place, tiers) = ((node.look, &node.id), &node.tiers);
        node.tiers = distinct_tiers(&mut planner, (setup, library), &options.plan, place, tiers)?;
    }
    let every = options.nodes == MeasuredNodes::Every;
    nodes.retain(|node| node.tiers.len() > 1 || (every && node.can_be_left_out));
    let tiers = look_tiers(setup, library);
    progress.expect(((options.rounds + 2) * (1 + nodes.len())) as u64);
    let precise = renderer.gpu().precise().executor();
    let mut bench = Bench { setup, library, renderer, precise, options, planner };
    let truth = if options.truth { Some(bench.truth(progress).await?) } else { None };
    let mut rows = bench.looks(&tiers, truth.as_ref(), progress).await?;
    for node in &nodes {
        rows.extend(bench.node(node, truth.as_ref(), progress).await?);
    }
    Ok(BenchReport {
        adapter: renderer.gpu().name(),
        is_software: renderer.gpu().is_software(),
        has_timestamps: renderer.gpu().has_timestamps(),
        size: options.plan.size,
        samples: options.plan.samples,
        rounds: options.rounds,
        rows,
    })
}

/// A node to measure, with the tiers it is measured in.
struct BenchNode {
    look: usize,
    id: NodeId,
    name: String,
    kind: String,
    tiers: Vec<Tier>,
    can_be_left_out: bool,
}

fn nodes(setup: &Setup, library: &Library, wanted: MeasuredNodes) -> Vec<BenchNode> {
    let of_look = |(index, look): (usize, &crate::frame::SetupLook)| {
        let look = &look.look;
        let measured = look.graph.nodes.iter().map(move |(id, node)| BenchNode {
            look: index,
            id: id.clone(),
            name: if node.name.is_empty() { id.to_string() } else { node.name.clone() },
            kind: node.kind.clone(),
            tiers: tiers_of(look, library, &node.kind),
            can_be_left_out: can_be_left_out(look, library, &node.kind),
        });
        measured.collect::<Vec<_>>()
    };
    let all = setup.looks.iter().enumerate().flat_map(of_look);
    let is_wanted = |node: &BenchNode| match wanted {
        MeasuredNodes::None => false,
        MeasuredNodes::Tiered => node.tiers.len() > 1,
        MeasuredNodes::Every => node.tiers.len() > 1 || node.can_be_left_out,
    };
    all.filter(is_wanted).collect()
}

fn look_tiers(setup: &Setup, library: &Library) -> Vec<Tier> {
    let kinds = setup
        .looks
        .iter()
        .flat_map(|look| look.look.graph.nodes.values().map(move |node| (look, node)));
    let mut tiers: Vec<Tier> =
        kinds.flat_map(|(look, node)| tiers_of(&look.look, library, &node.kind)).collect();
    tiers.sort_unstable();
    tiers.dedup();
    tiers
}

struct Bench<'a> {
    setup: &'a Setup,
    library: &'a Library,
    renderer: &'a mut Renderer,
    precise: Box<dyn Executor + Send>,
    options: &'a BenchOptions,
    planner: Planner,
}

impl Bench<'_> {
    fn plan(&mut self, variant: &Variant) -> Result<FramePlan, MeasureError> {
        let setup = variant.of(self.setup);
        Ok(self.planner.plan(&setup, self.library, &Live::Keyed, &self.options.plan)?.value)
    }

    /// The truth of the setup, [settled](Truth::settle) with the exact tier's picture.
    async fn truth(&mut self, progress: &Progress) -> Result<Truth, MeasureError> {
        let exact = Variant::Looks(Tier::Exact);
        let setup = exact.of(self.setup);
        let options = &self.options.plan;
        let mut planner = Planner::for_truth(Assets::default());
        let mut truth = Truth::of(&setup, self.library, &mut planner, options, &progress.part(1))?;
        let plan = FramePlan { samples: 1, ..self.plan(&exact)? };
        let got = self.precise.picture(&plan, &Progress::new()).await?;
        truth.settle(
            &PremultipliedPicture::from(&got),
            |_| VISIBLE,
            &setup,
            self.library,
            &mut planner,
            options,
        )?;
        Ok(truth)
    }

    async fn error(
        &mut self,
        plan: &FramePlan,
        truth: Option<&Truth>,
    ) -> Result<Option<ErrorFigures>, MeasureError> {
        // The picture is compared with one sample a pixel, as the truth has.
        let plan = FramePlan { samples: 1, ..plan.clone() };
        match truth {
            Some(truth) => Ok(Some(truth.compare(&mut *self.precise, &plan).await?)),
            None => Ok(None),
        }
    }

    /// Rows of the whole look, in each tier, in those that are chosen automatically and in those
    /// that the document asks for; each with the rows of its passes.
    async fn looks(
        &mut self,
        tiers: &[Tier],
        truth: Option<&Truth>,
        progress: &Progress,
    ) -> Result<Vec<MeasurementRow>, MeasureError> {
        let mut variants: Vec<(MeasuredTier, Variant)> =
            tiers.iter().map(|&tier| (MeasuredTier::Named(tier), Variant::Looks(tier))).collect();
        if tiers.len() > 1 {
            variants.push((MeasuredTier::Automatic, Variant::Automatic));
        }
        let asked = Variant::Asked.of(self.setup);
        let is_one_of_them =
            variants.iter().any(|(_, variant)| same_looks(&variant.of(self.setup), &asked));
        if !is_one_of_them {
            variants.push((MeasuredTier::AsSet, Variant::Asked));
        }
        let plans = variants
            .iter()
            .map(|(_, variant)| self.plan(variant))
            .collect::<Result<Vec<_>, _>>()?;
        let series = alternate(
            self.renderer,
            &plans.iter().collect::<Vec<_>>(),
            self.options.rounds,
            progress,
        )
        .await?;
        let mut rows = Vec::new();
        for (((tier, _), plan), series) in variants.into_iter().zip(&plans).zip(&series) {
            let error = self.error(plan, truth).await?;
            let passes =
                series.passes.iter().filter(|_| series.passes.len() > 1).map(|(pass, times)| {
                    MeasurementRow {
                        subject: MeasurementSubject::Pass(*pass),
                        tier,
                        time: TimeEstimate::of(times),
                        sizes: None,
                        error: None,
                    }
                });
            let row = MeasurementRow {
                subject: MeasurementSubject::Whole,
                tier,
                time: series.estimate(),
                sizes: Some(Sizes::of(plan)),
                error,
            };
            rows.push(row);
            rows.extend(passes);
        }
        Ok(rows)
    }

    /// Rows of a node: each of its tiers, against the same look without the node.
    async fn node(
        &mut self,
        node: &BenchNode,
        truth: Option<&Truth>,
        progress: &Progress,
    ) -> Result<Vec<MeasurementRow>, MeasureError> {
        let (look, id) = (node.look, &node.id);
        let mut variants: Vec<Variant> =
            node.tiers.iter().map(|&tier| Variant::Node { look, node: id.clone(), tier }).collect();
        if node.can_be_left_out {
            variants.push(Variant::Without { look, node: id.clone() });
        }
        let plans =
            variants.iter().map(|variant| self.plan(variant)).collect::<Result<Vec<_>, _>>()?;
        let series = alternate(
            self.renderer,
            &plans.iter().collect::<Vec<_>>(),
            self.options.rounds,
            progress,
        )
        .await?;
        // A node that cannot be left out is measured against its own cheapest tier, which then
        // costs nothing.
        let without = series.last().cloned().unwrap_or_default();
        let sizes_without = plans.last().map(Sizes::of).unwrap_or_default();
        let mut rows = Vec::new();
        for ((&tier, plan), series) in node.tiers.iter().zip(&plans).zip(&series) {
            let subject = MeasurementSubject::Node {
                look: self.setup.looks[look].look.name.clone(),
                id: id.clone(),
                name: node.name.clone(),
                kind: node.kind.clone(),
            };
            let sizes = Sizes::of(plan).over(&sizes_without);
            let error = self.error(plan, truth).await?;
            rows.push(MeasurementRow {
                subject,
                tier: MeasuredTier::Named(tier),
                time: Series::over(series, &without),
                sizes: Some(sizes),
                error,
            });
        }
        Ok(rows)
    }
}

fn same_looks(a: &Setup, b: &Setup) -> bool {
    a.looks.iter().zip(&b.looks).all(|(a, b)| a.look == b.look)
}
