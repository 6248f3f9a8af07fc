//! Choice of tiers: the cheapest within a stated error, or the most accurate within a stated time.
//!
//! Each node's tiers are first measured alone, in error over every viewpoint (a view, a turn of the
//! lights, a time) and in time against the exact tier. A choice is then made from these
//! measurements, and measured as a whole; where the errors of several nodes add up beyond the
//! bound, the node that errs most for the time it saves goes back, until the whole is within the
//! bound.

use serde::Serialize;

use super::cost::alternate;
use super::measure::Measure;
use super::truth::Truth;
use super::variant::{Variant, distinct_tiers, tiers_of};
use super::viewpoint::{Viewpoint, viewpoints};
use super::{ErrorFigures, MeasureError, TimeEstimate};
use crate::compile::Live;
use crate::document::Tier;
use crate::frame::{Assets, Executor, PlanOptions, Planner, Setup};
use crate::ids::NodeId;
use crate::library::Library;
use crate::progress::Progress;
use crate::render::Renderer;

/// Bound that a choice must keep.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Goal {
    /// Largest error, by the [measure](TuneOptions::measure) of the options; as fast as possible
    /// within it.
    MaxError(f64),
    /// Most time a frame, in milliseconds; as accurate as possible within it.
    MaxTime(f64),
}

/// Options of tuning.
#[derive(Clone, Debug, PartialEq)]
pub struct TuneOptions {
    /// Bound that the choice must keep.
    pub goal: Goal,
    /// Measure that errors are judged by.
    pub measure: Measure,
    /// The picture whose time counts.
    pub plan: PlanOptions,
    /// Side of the pictures that are compared with the truth, in pixels.
    pub error_side: u32,
    /// Number of times each variant is drawn.
    pub rounds: usize,
    /// Number of viewpoints that the error is measured at.
    pub viewpoints: usize,
}

/// A tier that a node may have instead of the exact one, with its error and the time it saves.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Candidate {
    /// Index of the look in the setup.
    pub look: usize,
    /// The node.
    pub node: NodeId,
    /// The tier.
    pub tier: Tier,
    /// Error over all viewpoints with this node alone in this tier, by the measure of the options.
    pub error: f64,
    /// Time saved against the exact tier, in milliseconds.
    pub saves: TimeEstimate,
    /// Cheaper tiers of the same node whose time cannot be told from this one's.
    pub ties: Vec<Tier>,
}

/// The pixel that is farthest from the truth, over all setups and viewpoints.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct WorstPixel {
    /// Error of the pixel: the largest difference of a channel.
    pub error: f64,
    /// Column and row of the pixel.
    pub pixel: [u32; 2],
    /// Side of the picture, in pixels.
    pub side: u32,
    /// Index of the setup.
    pub setup: usize,
    /// Viewpoint of the picture.
    #[serde(rename = "station")]
    pub viewpoint: Viewpoint,
}

/// Result of tuning: the chosen tiers with their errors and times.
#[derive(Clone, Debug, Serialize)]
pub struct TuneReport {
    /// Bound that the choice had to keep.
    pub goal: Goal,
    /// Measure that errors were judged by.
    pub measure: Measure,
    /// True if the choice keeps the bound.
    pub is_met: bool,
    /// Choices that are not exact, as indices of `candidates`.
    pub chosen: Vec<usize>,
    /// All candidates that were measured.
    pub candidates: Vec<Candidate>,
    /// Error of the whole with the choice, over all viewpoints.
    pub error: ErrorFigures,
    /// The pixel that is farthest off with the choice.
    pub worst: WorstPixel,
    /// Error of the whole in the exact tier; no choice can be better.
    pub error_exact: ErrorFigures,
    /// The pixel that is farthest off in the exact tier.
    pub worst_exact: WorstPixel,
    /// Time a frame with the exact tier, in milliseconds.
    pub time_exact: TimeEstimate,
    /// Time a frame with the choice, in milliseconds.
    pub time: TimeEstimate,
    /// Time a frame that the choice saves, measured in turns, in milliseconds.
    pub saves: TimeEstimate,
    /// The GPU's name.
    pub adapter: String,
    /// Number of viewpoints that the errors are taken over.
    #[serde(rename = "stations")]
    pub viewpoints: usize,
}

impl TuneReport {
    /// The tier of each node that could have another than exact: the chosen one, or exact.
    pub fn tiers(&self) -> Vec<(&NodeId, Tier)> {
        let mut tiers: Vec<(&NodeId, Tier)> = Vec::new();
        for (index, candidate) in self.candidates.iter().enumerate() {
            let tier = if self.chosen.contains(&index) { candidate.tier } else { Tier::Exact };
            match tiers.iter_mut().find(|(node, _)| *node == &candidate.node) {
                Some(known) if known.1 == Tier::Exact => known.1 = tier,
                Some(_) => {}
                None => tiers.push((&candidate.node, tier)),
            }
        }
        tiers
    }

    /// Summary of the result, in a sentence or two.
    pub fn summary(&self) -> String {
        let (measure, figures) = (self.measure, &self.error);
        let goal = match self.goal {
            Goal::MaxError(most) => format!("an error ({}) of at most {most:.2e}", measure.word()),
            Goal::MaxTime(most) => format!("at most {most} ms a frame"),
        };
        let met = if self.is_met { "met" } else { "missed" };
        format!(
            "tuned for {goal}, {met}: error {} {:.2e} (max {:.2e}, rms {:.1e}) over {} views, \
             lights and times; {:.3} ms a \
             frame, {:.3} ms exact, {:.3} ms saved ({:.3} to {:.3}), on {}",
            measure.word(),
            measure.of(figures),
            figures.max,
            figures.rms,
            self.viewpoints,
            self.time.median,
            self.time_exact.median,
            self.saves.median,
            self.saves.low,
            self.saves.high,
            self.adapter,
        )
    }

    /// True if the exact tier itself is farther from the truth than the bound, so that no choice
    /// can be within it.
    pub fn is_exact_beyond(&self) -> bool {
        matches!(self.goal, Goal::MaxError(most) if self.measure.of(&self.error_exact) > most)
    }

    /// Candidates that cannot be told apart from the exact tier in time: they stay exact.
    pub fn ties(&self) -> impl Iterator<Item = &Candidate> {
        self.candidates.iter().filter(|candidate| !is_faster(candidate))
    }
}

fn is_faster(candidate: &Candidate) -> bool {
    candidate.saves.low > 0.0
}

/// True if `other` is a tier of the same node that is as fast, as far as can be told, and nearer to
/// the truth.
pub fn is_dominated(candidate: &Candidate, other: &Candidate) -> bool {
    let is_same_node = (candidate.look, &candidate.node) == (other.look, &other.node);
    is_same_node
        && is_faster(other)
        && other.ties.contains(&candidate.tier)
        && other.error < candidate.error
}

/// Tunes every look of `setups`, which use the same looks on different meshes: all setups must be
/// within the error; the time is that of the first.
///
/// # Errors
/// Problems of the setups, errors of the GPU, or `Interruption` if `progress` was stopped.
pub async fn tune(
    setups: &[Setup],
    library: &Library,
    renderer: &mut Renderer,
    options: &TuneOptions,
    progress: &Progress,
) -> Result<TuneReport, MeasureError> {
    let exact: Vec<Setup> =
        setups.iter().map(|setup| Variant::Looks(Tier::Exact).of(setup)).collect();
    let mut nodes = exact.first().map(|setup| nodes(setup, library)).unwrap_or_default();
    if let Some(setup) = exact.first() {
        let (mut planner, of) = (Planner::default(), (setup, library));
        for (look, node, tiers) in &mut nodes {
            *tiers = distinct_tiers(&mut planner, of, &options.plan, (*look, &*node), tiers)?;
        }
        nodes.retain(|(_, _, tiers)| !tiers.is_empty());
    }
    let tries: usize = nodes.iter().map(|(_, _, tiers)| tiers.len()).sum();
    let pictures = options.viewpoints * setups.len() * (4 + tries);
    progress.expect((pictures + (options.rounds + 2) * (2 + nodes.len())) as u64);
    let mut tuner = Tuner::new(&exact, library, renderer, options, progress)?;
    let mut candidates = Vec::new();
    for (look, node, tiers) in &nodes {
        candidates.extend(tuner.candidates(*look, node, tiers, progress).await?);
    }
    let (error_exact, worst_exact) = tuner.error(&[], progress).await?;
    let time_exact = tuner.times(&[&[]], &candidates, progress).await?[0].estimate();
    let mut error_of_choice = async |chosen: &[usize]| {
        let (figures, _) = tuner.error(&chosen_of(&candidates, chosen), progress).await?;
        Ok::<_, MeasureError>(options.measure.of(&figures))
    };
    let chosen = choose(&candidates, options.goal, time_exact.median, &mut error_of_choice).await?;
    let (error, worst) = tuner.error(&chosen_of(&candidates, &chosen), progress).await?;
    let series = tuner.times(&[&[], &chosen], &candidates, progress).await?;
    let time = series[1].estimate();
    Ok(TuneReport {
        goal: options.goal,
        measure: options.measure,
        is_met: match options.goal {
            Goal::MaxError(most) => options.measure.of(&error) <= most,
            Goal::MaxTime(most) => time.median <= most,
        },
        chosen,
        candidates,
        error,
        worst,
        error_exact,
        worst_exact,
        time_exact,
        time,
        saves: series[0].over(&series[1]),
        adapter: tuner.renderer.gpu().name(),
        viewpoints: options.viewpoints,
    })
}

fn chosen_of(candidates: &[Candidate], chosen: &[usize]) -> Vec<Candidate> {
    chosen.iter().map(|&index| candidates[index].clone()).collect()
}

/// Nodes of the looks' own graphs that have more tiers than the exact one, with those tiers: the
/// index of the look, the node, its tiers.
fn nodes(setup: &Setup, library: &Library) -> Vec<(usize, NodeId, Vec<Tier>)> {
    let mut found = Vec::new();
    for (index, look) in setup.looks.iter().enumerate() {
        for (id, node) in &look.look.graph.nodes {
            let mut tiers = tiers_of(&look.look, library, &node.kind);
            tiers.retain(|tier| *tier != Tier::Exact);
            if !tiers.is_empty() {
                found.push((index, id.clone(), tiers));
            }
        }
    }
    found
}

/// Chooses at most one tier a node, as indices of `candidates`. `error_of_choice` measures the
/// error of a choice as a whole. Of tiers that cannot be told apart in time, the one nearer to the
/// truth is taken.
///
/// # Errors
/// Errors of `error_of_choice`.
pub async fn choose<E>(
    candidates: &[Candidate],
    goal: Goal,
    time_exact: f64,
    error_of_choice: &mut impl AsyncFnMut(&[usize]) -> Result<f64, E>,
) -> Result<Vec<usize>, E> {
    let place = |index: usize| (candidates[index].look, candidates[index].node.clone());
    let mut usable: Vec<usize> =
        (0..candidates.len()).filter(|&index| is_faster(&candidates[index])).collect();
    match goal {
        Goal::MaxError(most) => {
            usable.retain(|&index| candidates[index].error <= most);
            // The cheapest candidate of each node.
            usable.sort_by(|&a, &b| {
                candidates[b].saves.median.total_cmp(&candidates[a].saves.median)
            });
            usable.retain({
                let all = usable.clone();
                move |&index| {
                    all.iter().all(|&other| !is_dominated(&candidates[index], &candidates[other]))
                }
            });
            let mut chosen: Vec<usize> = Vec::new();
            for index in usable.clone() {
                if chosen.iter().all(|&other| place(other) != place(index)) {
                    chosen.push(index);
                }
            }
            while !chosen.is_empty() && error_of_choice(&chosen).await? > most {
                let price = |index: usize| {
                    candidates[index].error / candidates[index].saves.median.max(1e-9)
                };
                let worst = (0..chosen.len())
                    .max_by(|&a, &b| price(chosen[a]).total_cmp(&price(chosen[b])));
                let Some(gone) = worst.map(|at| chosen.remove(at)) else { break };
                // A less cheap tier of the same node may still be within the error.
                let other = usable.iter().copied().find(|&index| {
                    place(index) == place(gone) && candidates[index].error < candidates[gone].error
                });
                chosen.extend(other);
            }
            Ok(chosen)
        }
        Goal::MaxTime(most) => {
            // Candidates with the least error for the time they save come first.
            let price =
                |index: usize| candidates[index].error / candidates[index].saves.median.max(1e-9);
            usable.sort_by(|&a, &b| price(a).total_cmp(&price(b)));
            let mut chosen: Vec<usize> = Vec::new();
            let mut time = time_exact;
            for index in usable {
                if time <= most {
                    break;
                }
                let saves = candidates[index].saves.median;
                match chosen.iter().position(|&other| place(other) == place(index)) {
                    None => {
                        chosen.push(index);
                        time -= saves;
                    }
                    Some(at) if candidates[chosen[at]].saves.median < saves => {
                        time -= saves - candidates[chosen[at]].saves.median;
                        chosen[at] = index;
                    }
                    Some(_) => {}
                }
            }
            Ok(chosen)
        }
    }
}

struct Tuner<'a> {
    setups: &'a [Setup],
    library: &'a Library,
    renderer: &'a mut Renderer,
    precise: Box<dyn Executor + Send>,
    options: &'a TuneOptions,
    planner: Planner,
    /// Truth of each viewpoint, with the index of its setup.
    truths: Vec<(usize, Viewpoint, Truth)>,
}

impl<'a> Tuner<'a> {
    fn new(
        setups: &'a [Setup],
        library: &'a Library,
        renderer: &'a mut Renderer,
        options: &'a TuneOptions,
        progress: &Progress,
    ) -> Result<Self, MeasureError> {
        let precise = renderer.gpu().precise().executor();
        let mut tuner = Self {
            setups,
            library,
            renderer,
            precise,
            options,
            planner: Planner::default(),
            truths: Vec::new(),
        };
        let mut truth_planner = Planner::for_truth(Assets::default());
        for (index, setup) in setups.iter().enumerate() {
            for viewpoint in viewpoints(setup, options.viewpoints) {
                let plan = tuner.error_plan(&viewpoint);
                let truth = Truth::of(
                    &viewpoint.of(setup),
                    library,
                    &mut truth_planner,
                    &plan,
                    &progress.part(1),
                )?;
                tuner.truths.push((index, viewpoint, truth));
            }
        }
        Ok(tuner)
    }

    fn error_plan(&self, viewpoint: &Viewpoint) -> PlanOptions {
        let side = self.options.error_side;
        PlanOptions { size: [side; 2], samples: 1, time: viewpoint.time }
    }

    fn with(&self, setup: usize, chosen: &[Candidate]) -> Setup {
        let setup = self.setups.get(setup).cloned().unwrap_or_default();
        chosen.iter().fold(setup, |setup, choice| {
            Variant::of_also(setup, choice.look, &choice.node, choice.tier)
        })
    }

    /// The worst error of the choice over all viewpoints, and the pixel where it is.
    async fn error(
        &mut self,
        chosen: &[Candidate],
        progress: &Progress,
    ) -> Result<(ErrorFigures, WorstPixel), MeasureError> {
        let mut figures = Vec::new();
        let mut worst = WorstPixel::default();
        for at in 0..self.truths.len() {
            let (index, viewpoint, truth) = &self.truths[at];
            let setup = viewpoint.of(&self.with(*index, chosen));
            let options = self.error_plan(viewpoint);
            let plan = self.planner.plan(&setup, self.library, &Live::Keyed, &options)?.value;
            let found = truth.compare(&mut *self.precise, &plan).await?;
            if found.max > worst.error {
                let side = self.options.error_side;
                worst = WorstPixel {
                    error: found.max,
                    pixel: found.worst,
                    side,
                    setup: *index,
                    viewpoint: *viewpoint,
                };
            }
            figures.push(found);
            progress.step()?;
        }
        Ok((ErrorFigures::join(&figures), worst))
    }

    async fn times(
        &mut self,
        choices: &[&[usize]],
        candidates: &[Candidate],
        progress: &Progress,
    ) -> Result<Vec<super::Series>, MeasureError> {
        let mut plans = Vec::new();
        for chosen in choices {
            let setup = self.with(0, &chosen_of(candidates, chosen));
            let options = &self.options.plan;
            plans.push(self.planner.plan(&setup, self.library, &Live::Keyed, options)?.value);
        }
        alternate(self.renderer, &plans.iter().collect::<Vec<_>>(), self.options.rounds, progress)
            .await
    }

    async fn candidates(
        &mut self,
        look: usize,
        node: &NodeId,
        tiers: &[Tier],
        progress: &Progress,
    ) -> Result<Vec<Candidate>, MeasureError> {
        let alone = |tier| Candidate {
            look,
            node: node.clone(),
            tier,
            error: 0.0,
            saves: TimeEstimate::default(),
            ties: Vec::new(),
        };
        let mut candidates: Vec<Candidate> = tiers.iter().map(|&tier| alone(tier)).collect();
        let single: Vec<Vec<usize>> = std::iter::once(Vec::new())
            .chain((0..candidates.len()).map(|index| vec![index]))
            .collect();
        let choices: Vec<&[usize]> = single.iter().map(Vec::as_slice).collect();
        let series = self.times(&choices, &candidates, progress).await?;
        for (index, candidate) in candidates.iter_mut().enumerate() {
            candidate.saves = series[0].over(&series[index + 1]);
            let is_tie = |other: &usize| series[index + 1].over(&series[other + 1]).low <= 0.0;
            candidate.ties =
                (index + 1..tiers.len()).filter(is_tie).map(|other| tiers[other]).collect();
            let (figures, _) = self.error(std::slice::from_ref(candidate), progress).await?;
            candidate.error = self.options.measure.of(&figures);
        }
        Ok(candidates)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn candidate(node: &str, tier: Tier, error: f64, saves: f64) -> Candidate {
        let saves = TimeEstimate { median: saves, low: saves - 0.05, high: saves + 0.05 };
        Candidate { look: 0, node: node.into(), tier, error, saves, ties: Vec::new() }
    }

    /// The choice among `candidates` if their errors add up.
    #[expect(clippy::disallowed_methods, reason = "nothing is waited for: no GPU measures here")]
    fn chosen(candidates: &[Candidate], goal: Goal, time_exact: f64) -> Vec<usize> {
        let mut sum = async |chosen: &[usize]| {
            Ok::<f64, ()>(chosen.iter().map(|&index| candidates[index].error).sum())
        };
        pollster::block_on(choose(candidates, goal, time_exact, &mut sum)).unwrap()
    }

    #[test]
    fn the_cheapest_within_the_error() {
        let candidates = [
            candidate("a", Tier::Balanced, 0.001, 1.0),
            candidate("a", Tier::Fast, 0.05, 3.0),
            candidate("b", Tier::Fast, 0.002, 2.0),
            candidate("c", Tier::Fast, 0.0001, 0.01),
        ];
        let goal = Goal::MaxError(1.0 / 255.0);
        let mut best = chosen(&candidates, goal, 10.0);
        best.sort_unstable();
        assert_eq!(best, [0, 2], "too wrong, and lost in the noise, are left out");
    }

    /// Both are much faster than exact, and the measured times do not tell which of the two is
    /// faster.
    #[test]
    fn of_two_that_cannot_be_told_apart_the_more_accurate() {
        let mut candidates =
            [candidate("a", Tier::Balanced, 0.0005, 1.0), candidate("a", Tier::Fast, 0.003, 1.02)];
        let goal = Goal::MaxError(1.0 / 255.0);
        assert_eq!(chosen(&candidates, goal, 10.0), [1]);
        candidates[0].ties = vec![Tier::Fast];
        assert_eq!(chosen(&candidates, goal, 10.0), [0]);
        // The more accurate one is passed over if it is too far from the truth, or lost in the
        // noise itself.
        candidates[0].error = 0.004;
        assert_eq!(chosen(&candidates, goal, 10.0), [1]);
    }

    #[test]
    fn errors_that_add_up_are_taken_back() {
        let candidates = [
            candidate("a", Tier::Fast, 0.003, 1.0),
            candidate("a", Tier::Balanced, 0.0005, 0.5),
            candidate("b", Tier::Fast, 0.002, 2.0),
        ];
        let goal = Goal::MaxError(0.004);
        let mut best = chosen(&candidates, goal, 10.0);
        best.sort_unstable();
        assert_eq!(best, [1, 2]);
    }

    #[test]
    fn the_most_accurate_within_the_time() {
        let candidates = [
            candidate("a", Tier::Fast, 0.05, 3.0),
            candidate("b", Tier::Fast, 0.002, 2.0),
            candidate("c", Tier::Fast, 0.001, 2.0),
        ];
        let best = chosen(&candidates, Goal::MaxTime(7.0), 10.0);
        assert_eq!(best, [2, 1]);
        assert!(chosen(&candidates, Goal::MaxTime(20.0), 10.0).is_empty());
    }
}
