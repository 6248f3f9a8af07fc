//! Picks tiers: the cheapest that stay under a stated error, or the most accurate that stay within a stated time.
//!
//! Each node's tiers are first measured alone, in error over every station (a view, a turn of the lights, a time) and in
//! time against the exact tier. A choice is then made from these, and measured as a whole; where the errors of several
//! nodes add up beyond the bound, the one that errs most for what it saves goes back, until the whole is within.

use serde::Serialize;

use super::cost::alternate;
use super::truth::Truth;
use super::variant::{Variant, tiers_of};
use super::{ErrorFigures, Estimate, Progress, Stopped};
use crate::compile::Live;
use crate::document::Tier;
use crate::frame::{Assets, PlanOptions, Planner, Setup};
use crate::ids::NodeId;
use crate::library::Library;
use crate::render::Renderer;

/// What is to be kept.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Goal {
    /// No channel of any pixel is farther from the truth; as fast as possible.
    MaxError(f64),
    /// Milliseconds a frame; as accurate as possible.
    MaxTime(f64),
}

/// How to tune.
#[derive(Clone, Debug, PartialEq)]
pub struct TuneOptions {
    /// What is to be kept.
    pub goal: Goal,
    /// The picture whose time counts.
    pub plan: PlanOptions,
    /// The side in pixels of the pictures that are compared with the truth.
    pub error_side: u32,
    /// How often each variant is drawn.
    pub rounds: usize,
    /// Where the error is measured.
    pub stations: usize,
}

/// A node that may have another tier than the exact one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Candidate {
    /// The look, by its index in the setup.
    pub look: usize,
    /// The node.
    pub node: NodeId,
    /// The tier.
    pub tier: Tier,
    /// The largest error over all stations with this node alone in this tier.
    pub error: f64,
    /// Milliseconds that it saves against the exact tier.
    pub saves: Estimate,
}

/// What was chosen.
#[derive(Clone, Debug, Serialize)]
pub struct Tuned {
    /// What was to be kept.
    pub goal: Goal,
    /// Whether it is.
    pub is_met: bool,
    /// The choices that are not exact, as indices of `candidates`.
    pub chosen: Vec<usize>,
    /// Everything that was measured.
    pub candidates: Vec<Candidate>,
    /// The whole with what was chosen, over all stations.
    pub error: ErrorFigures,
    /// Milliseconds a frame, exact.
    pub time_exact: Estimate,
    /// Milliseconds a frame, with what was chosen.
    pub time: Estimate,
    /// Milliseconds that it saves, measured in turns.
    pub saves: Estimate,
    /// The GPU.
    pub adapter: String,
    /// How many stations the errors are over.
    pub stations: usize,
}

impl Tuned {
    /// The tier of each node that could have another: what was chosen, or exact.
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

    /// What was reached, in a sentence or two.
    pub fn summary(&self) -> String {
        let goal = match self.goal {
            Goal::MaxError(most) => format!("an error of at most {most:.2e}"),
            Goal::MaxTime(most) => format!("at most {most} ms a frame"),
        };
        let met = if self.is_met { "met" } else { "missed" };
        format!(
            "tuned for {goal}, {met}: largest error {:.2e} (rms {:.1e}) over {} views, lights and times; {:.3} ms a frame, \
             {:.3} ms exact, {:.3} ms saved ({:.3} to {:.3}), on {}",
            self.error.max,
            self.error.rms,
            self.stations,
            self.time.median,
            self.time_exact.median,
            self.saves.median,
            self.saves.low,
            self.saves.high,
            self.adapter,
        )
    }

    /// Candidates that cannot be told apart from the exact tier in time: they stay exact.
    pub fn ties(&self) -> impl Iterator<Item = &Candidate> {
        self.candidates.iter().filter(|candidate| !is_faster(candidate))
    }
}

fn is_faster(candidate: &Candidate) -> bool {
    candidate.saves.low > 0.0
}

/// Tunes every look of `setups`, which wear the same looks on different meshes: all of them must be within the error; the
/// time is that of the first.
///
/// # Errors
/// What is wrong with the setups, what the GPU refuses, or that `progress` stopped it.
pub fn tune(
    setups: &[Setup],
    library: &Library,
    renderer: &mut Renderer,
    options: &TuneOptions,
    progress: &mut Progress<'_>,
) -> Result<Tuned, Stopped> {
    let exact: Vec<Setup> = setups.iter().map(|setup| Variant::Looks(Tier::Exact).of(setup)).collect();
    let nodes = exact.first().map(|setup| nodes(setup, library)).unwrap_or_default();
    let tries: usize = nodes.iter().map(|(_, _, tiers)| tiers.len()).sum();
    let pictures = options.stations * setups.len() * (3 + tries);
    progress.expect((pictures + (options.rounds + 2) * (2 + nodes.len())) as u64);
    let mut tuner = Tuner::new(&exact, library, renderer, options, progress)?;
    let mut candidates = Vec::new();
    for (look, node, tiers) in &nodes {
        candidates.extend(tuner.candidates(*look, node, tiers, progress)?);
    }
    let time_exact = tuner.times(&[&[]], &candidates, progress)?[0].estimate();
    let mut joint = |chosen: &[usize]| tuner.error(&chosen_of(&candidates, chosen), progress);
    let chosen = choose(&candidates, options.goal, time_exact.median, &mut joint)?;
    let error = tuner.error(&chosen_of(&candidates, &chosen), progress)?;
    let series = tuner.times(&[&[], &chosen], &candidates, progress)?;
    let time = series[1].estimate();
    let is_met = match options.goal {
        Goal::MaxError(most) => error.max <= most,
        Goal::MaxTime(most) => time.median <= most,
    };
    let saves = series[0].over(&series[1]);
    let (adapter, stations) = (tuner.renderer.gpu().name(), options.stations);
    Ok(Tuned { goal: options.goal, is_met, chosen, candidates, error, time_exact, time, saves, adapter, stations })
}

fn chosen_of(candidates: &[Candidate], chosen: &[usize]) -> Vec<Candidate> {
    chosen.iter().map(|&index| candidates[index].clone()).collect()
}

/// Nodes of the looks' own graphs with the tiers that they have beside the exact one.
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

/// Chooses at most one tier a node. `joint` measures the error of a choice as a whole.
///
/// # Errors
/// What `joint` says.
pub fn choose<E>(
    candidates: &[Candidate],
    goal: Goal,
    time_exact: f64,
    joint: &mut dyn FnMut(&[usize]) -> Result<ErrorFigures, E>,
) -> Result<Vec<usize>, E> {
    let place = |index: usize| (candidates[index].look, candidates[index].node.clone());
    let mut usable: Vec<usize> = (0..candidates.len()).filter(|&index| is_faster(&candidates[index])).collect();
    match goal {
        Goal::MaxError(most) => {
            usable.retain(|&index| candidates[index].error <= most);
            // The cheapest of each node.
            usable.sort_by(|&a, &b| candidates[b].saves.median.total_cmp(&candidates[a].saves.median));
            let mut chosen: Vec<usize> = Vec::new();
            for index in usable.clone() {
                if chosen.iter().all(|&other| place(other) != place(index)) {
                    chosen.push(index);
                }
            }
            while !chosen.is_empty() && joint(&chosen)?.max > most {
                let price = |index: usize| candidates[index].error / candidates[index].saves.median.max(1e-9);
                let worst = (0..chosen.len()).max_by(|&a, &b| price(chosen[a]).total_cmp(&price(chosen[b])));
                let Some(gone) = worst.map(|at| chosen.remove(at)) else { break };
                // A less cheap tier of the same node may still do.
                let other = usable
                    .iter()
                    .copied()
                    .find(|&index| place(index) == place(gone) && candidates[index].error < candidates[gone].error);
                chosen.extend(other);
            }
            Ok(chosen)
        }
        Goal::MaxTime(most) => {
            // The least error for what is saved comes first.
            let price = |index: usize| candidates[index].error / candidates[index].saves.median.max(1e-9);
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
    precise: Renderer,
    options: &'a TuneOptions,
    planner: Planner,
    /// Each station's truth, with the index of its setup.
    truths: Vec<(usize, Station, Truth)>,
}

impl<'a> Tuner<'a> {
    fn new(
        setups: &'a [Setup],
        library: &'a Library,
        renderer: &'a mut Renderer,
        options: &'a TuneOptions,
        progress: &mut Progress<'_>,
    ) -> Result<Self, Stopped> {
        let precise = Renderer::new(renderer.gpu().precise());
        let mut tuner =
            Self { setups, library, renderer, precise, options, planner: Planner::default(), truths: Vec::new() };
        let mut truth_planner = Planner::for_truth(Assets::default());
        for (index, setup) in setups.iter().enumerate() {
            for station in stations(setup, options.stations) {
                let plan = tuner.error_plan(&station);
                let truth = Truth::of(&station.of(setup), library, &mut truth_planner, &plan, progress)?;
                tuner.truths.push((index, station, truth));
            }
        }
        Ok(tuner)
    }

    fn error_plan(&self, station: &Station) -> PlanOptions {
        let side = self.options.error_side;
        PlanOptions { size: [side; 2], samples: 1, time: station.time }
    }

    fn with(&self, setup: usize, chosen: &[Candidate]) -> Setup {
        let setup = self.setups.get(setup).cloned().unwrap_or_default();
        chosen.iter().fold(setup, |setup, choice| Variant::of_also(setup, choice.look, &choice.node, choice.tier))
    }

    /// The worst over all stations.
    fn error(&mut self, chosen: &[Candidate], progress: &mut Progress<'_>) -> Result<ErrorFigures, Stopped> {
        let mut figures = Vec::new();
        for at in 0..self.truths.len() {
            let (index, station, truth) = &self.truths[at];
            let setup = station.of(&self.with(*index, chosen));
            let options = self.error_plan(station);
            let plan = self.planner.plan(&setup, self.library, &Live::Keyed, &options)?;
            figures.push(truth.compare(&mut self.precise, &plan)?);
            progress.step()?;
        }
        Ok(ErrorFigures::join(&figures))
    }

    fn times(
        &mut self,
        choices: &[&[usize]],
        candidates: &[Candidate],
        progress: &mut Progress<'_>,
    ) -> Result<Vec<super::Series>, Stopped> {
        let mut plans = Vec::new();
        for chosen in choices {
            let setup = self.with(0, &chosen_of(candidates, chosen));
            plans.push(self.planner.plan(&setup, self.library, &Live::Keyed, &self.options.plan)?);
        }
        alternate(self.renderer, &plans.iter().collect::<Vec<_>>(), self.options.rounds, progress)
    }

    fn candidates(
        &mut self,
        look: usize,
        node: &NodeId,
        tiers: &[Tier],
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Candidate>, Stopped> {
        let alone = |tier| Candidate { look, node: node.clone(), tier, error: 0.0, saves: Estimate::default() };
        let mut candidates: Vec<Candidate> = tiers.iter().map(|&tier| alone(tier)).collect();
        let single: Vec<Vec<usize>> =
            std::iter::once(Vec::new()).chain((0..candidates.len()).map(|index| vec![index])).collect();
        let choices: Vec<&[usize]> = single.iter().map(Vec::as_slice).collect();
        let series = self.times(&choices, &candidates, progress)?;
        for (index, candidate) in candidates.iter_mut().enumerate() {
            candidate.saves = series[0].over(&series[index + 1]);
            candidate.error = self.error(std::slice::from_ref(candidate), progress)?.max;
        }
        Ok(candidates)
    }
}

/// A view, a turn of the lights and a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Around the target, radians: to the right, then up.
    pub orbit: [f64; 2],
    /// Of the illumination frame, radians: around the vertical, then up.
    pub lights: [f64; 2],
    /// Seconds.
    pub time: f64,
}

impl Station {
    /// The setup seen from here.
    pub fn of(&self, setup: &Setup) -> Setup {
        let mut setup = setup.clone();
        setup.turn_camera(self.orbit);
        setup.turn_lights(self.lights);
        setup
    }
}

/// So many stations, the first one as the scene is; the rest spread evenly over views, lights and times.
pub fn stations(setup: &Setup, count: usize) -> Vec<Station> {
    // Multiples of powers of the generalised golden ratio fill a cube evenly (Roberts 2018).
    const STEPS: [f64; 5] = [0.856_674_883_7, 0.733_891_856_6, 0.628_706_720_8, 0.538_597_158_5, 0.461_402_658_3];
    let range = &setup.scene.time;
    let station = |index: usize| {
        let share = |axis: usize| (0.5 + STEPS[axis] * index as f64).fract();
        let turn = |share: f64| std::f64::consts::TAU * share;
        // Even over the sphere, but not onto the poles, where a look is seldom seen.
        let rise = |share: f64| (1.6 * share - 0.8).asin();
        let time = range.start + share(4) * (range.end - range.start);
        Station { orbit: [turn(share(0)), rise(share(1))], lights: [turn(share(2)), rise(share(3))], time }
    };
    let first = Station { orbit: [0.0; 2], lights: [0.0; 2], time: range.start };
    std::iter::once(first).chain((1..count.max(1)).map(station)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn candidate(node: &str, tier: Tier, error: f64, saves: f64) -> Candidate {
        let saves = Estimate { median: saves, low: saves - 0.05, high: saves + 0.05 };
        Candidate { look: 0, node: node.into(), tier, error, saves }
    }

    fn sum(candidates: &[Candidate]) -> impl FnMut(&[usize]) -> Result<ErrorFigures, ()> + '_ {
        |chosen| {
            let max = chosen.iter().map(|&index| candidates[index].error).sum();
            Ok(ErrorFigures { max, ..ErrorFigures::default() })
        }
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
        let mut chosen = choose(&candidates, goal, 10.0, &mut sum(&candidates)).unwrap();
        chosen.sort_unstable();
        assert_eq!(chosen, [0, 2], "too wrong, and lost in the noise, are left out");
    }

    #[test]
    fn errors_that_add_up_are_taken_back() {
        let candidates = [
            candidate("a", Tier::Fast, 0.003, 1.0),
            candidate("a", Tier::Balanced, 0.0005, 0.5),
            candidate("b", Tier::Fast, 0.002, 2.0),
        ];
        let goal = Goal::MaxError(0.004);
        let mut chosen = choose(&candidates, goal, 10.0, &mut sum(&candidates)).unwrap();
        chosen.sort_unstable();
        assert_eq!(chosen, [1, 2]);
    }

    #[test]
    fn the_most_accurate_within_the_time() {
        let candidates = [
            candidate("a", Tier::Fast, 0.05, 3.0),
            candidate("b", Tier::Fast, 0.002, 2.0),
            candidate("c", Tier::Fast, 0.001, 2.0),
        ];
        let chosen = choose(&candidates, Goal::MaxTime(7.0), 10.0, &mut sum(&candidates)).unwrap();
        assert_eq!(chosen, [2, 1]);
        assert!(choose(&candidates, Goal::MaxTime(20.0), 10.0, &mut sum(&candidates)).unwrap().is_empty());
    }

    #[test]
    fn stations_are_spread() {
        let stations = stations(&Setup::default(), 64);
        assert_eq!(stations[0].orbit, [0.0; 2]);
        let octants: std::collections::HashSet<_> = stations[1..]
            .iter()
            .map(|s| {
                (
                    (s.orbit[0] / std::f64::consts::FRAC_PI_2) as i32,
                    s.orbit[1] > 0.0,
                    s.lights[0] > std::f64::consts::PI,
                )
            })
            .collect();
        assert_eq!(octants.len(), 16);
    }
}
