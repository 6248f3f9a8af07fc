//! Measurement of a bench: its results on the GPU and in f64, with the same inputs, and their
//! distance.

use serde::Serialize;

use super::bounds::{ErrorMetric, bound, counts_inputs, is_stated, judging, moves_together, slack};
use super::case::{Case, NodeBench, Root, feeders, write_textures};
use super::random::{EvenPoints, Random};
use super::slot::{InputSlot, Numbers, SlotKind, SlotTarget, held, next, relate};
use crate::accuracy::MeasureError;
use crate::compile::{CompileOptions, Live};
use crate::diag::Diagnostic;
use crate::document::Value;
use crate::frame::{Assets, EvalBatch, EvalSample, LightOverride, SetupLook, eval_batches};
use crate::ids::{NodePath, PortName};
use crate::interp::Precision;
use crate::library::{Library, SurfacePart, Type};
use crate::reference;
use crate::render::Renderer;
use crate::wgsl::code;

/// Laboratory: the library, the GPU and the assets that all measurements share.
pub struct Laboratory<'a> {
    /// The library, with the feeder nodes.
    pub library: Library,
    /// Renderer on the GPU.
    pub renderer: &'a mut Renderer,
    assets: Assets,
    folder: tempfile::TempDir,
}

/// Extent of the measurements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Number of samples of a case within the documented ranges.
    pub ordinary: usize,
    /// Number of samples of a case at the edges of arithmetic.
    pub extreme: usize,
    /// Rounds of the search for worse inputs; 0 for none.
    pub rounds: usize,
}

impl Effort {
    /// Extent that takes seconds for the whole library.
    pub const QUICK: Self = Self { ordinary: 256, extreme: 512, rounds: 0 };
    /// Extent that takes minutes for the whole library.
    pub const FULL: Self = Self { ordinary: 4000, extreme: 6000, rounds: 8 };
}

/// Result of one sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Numbers that the node was fed with.
    pub numbers: Numbers,
    /// Result of the GPU.
    pub got: Vec<f64>,
    /// True result.
    pub truth: Vec<f64>,
    /// The largest difference of any number of the result.
    pub absolute: f64,
    /// The difference over the output's range, judged as [`judging`] says.
    pub error: f64,
}

/// Errors of a case.
#[derive(Clone, Debug, Serialize)]
pub struct CaseFigures {
    /// Case that was measured.
    pub case: Case,
    /// Number of samples that were compared.
    pub samples: usize,
    /// Number of samples that are within the bound only because f32 cannot tell their inputs from
    /// others.
    pub rounded: usize,
    /// Number of results that were NaN or infinite.
    pub broken: usize,
    /// The largest difference over the samples within the documented ranges.
    pub absolute: f64,
    /// Error that all but one in a thousand of those samples stay below, relative to the output's
    /// range.
    pub p999: f64,
    /// The largest error of all, relative to the output's range.
    pub max: f64,
    /// Bound of the case, relative to the output's range.
    pub bound: f64,
    /// The worst samples, the worst first.
    #[serde(skip)]
    pub worst: Vec<Finding>,
    /// Description of the worst sample.
    pub worst_words: String,
}

impl CaseFigures {
    /// True if the errors are within the bound.
    pub fn holds(&self) -> bool {
        self.broken == 0 && self.max <= self.bound
    }
}

/// Numbers of random neighbors that are judged beside the regular ones, each for samples whose
/// error is above a share of the bound. Several inputs together decide on most steps, and few
/// neighbors show few of their combinations.
const AROUND: [(usize, f64); 3] = [(0, 0.25), (120, 1.0), (1500, 1.0)];

/// Number of the worst samples that are kept.
const KEPT: usize = 6;

impl<'a> Laboratory<'a> {
    /// A laboratory on the GPU of `renderer`.
    ///
    /// # Errors
    /// Textures for image and HCBTF nodes that cannot be written.
    pub fn new(library: &Library, renderer: &'a mut Renderer) -> Result<Self, Vec<Diagnostic>> {
        let told = |error: std::io::Error| {
            vec![Diagnostic::error("write-failed", format!("no temporary folder: {error}"))]
        };
        let folder = tempfile::tempdir().map_err(told)?;
        write_textures(folder.path())?;
        Ok(Self { library: feeders(library), renderer, assets: Assets::default(), folder })
    }

    /// The bench of a case.
    ///
    /// # Errors
    /// A case that the library does not have.
    pub fn bench(&self, case: &Case) -> Result<NodeBench, Vec<Diagnostic>> {
        NodeBench::new(case, &self.library, self.folder.path())
    }

    fn batches(
        &mut self,
        look: &SetupLook,
        root: &Root,
        samples: &[EvalSample],
        unspecialized: bool,
    ) -> Result<Vec<EvalBatch>, Vec<Diagnostic>> {
        let root = root
            .output
            .as_ref()
            .map(|(node, port)| (NodePath::parse(node), PortName::from(port.as_str())));
        let options = CompileOptions {
            root,
            live: Live::Exposed,
            unspecialized,
            ..CompileOptions::default()
        };
        eval_batches(look, &self.library, samples, &options, &mut self.assets)
    }

    /// Results of the GPU, one row of all outputs' numbers for each sample.
    ///
    /// # Errors
    /// Errors of the compiler or the GPU.
    pub async fn run(
        &mut self,
        bench: &NodeBench,
        all: &[Numbers],
    ) -> Result<Vec<Vec<f64>>, MeasureError> {
        let samples: Vec<EvalSample> =
            all.iter().map(|numbers| sample(&bench.slots, numbers)).collect();
        let unspecialized = self.is_unspecialized(bench);
        let mut rows = vec![Vec::new(); samples.len()];
        if rows.is_empty() {
            return Ok(rows);
        }
        for root in &bench.roots {
            for batch in self.batches(&bench.look, root, &samples, unspecialized)? {
                let values = self.renderer.evaluate(&batch).await?;
                collect(&batch, values.iter().map(|value| value.map(f64::from)), &mut rows);
            }
        }
        Ok(rows)
    }

    /// True results: the exact tier in f64, fed with the numbers that the GPU holds.
    ///
    /// # Errors
    /// Errors of the compiler or the interpreter.
    pub fn truth(
        &mut self,
        bench: &NodeBench,
        all: &[Numbers],
    ) -> Result<Vec<Vec<f64>>, MeasureError> {
        let samples: Vec<EvalSample> =
            all.iter().map(|numbers| sample(&bench.slots, numbers)).collect();
        let mut rows = vec![Vec::new(); samples.len()];
        if rows.is_empty() {
            return Ok(rows);
        }
        for root in &bench.roots {
            for mut batch in self.batches(&bench.exact, root, &samples, true)? {
                // The GPU gets unit vectors, and all else that the host computes from a sample,
                // rounded to f32.
                batch.samples.numbers.iter_mut().for_each(|x| *x = held(*x));
                let values =
                    reference::evaluate(&batch, Precision::F64).map_err(|problem| vec![problem])?;
                collect(&batch, values.into_iter(), &mut rows);
            }
        }
        Ok(rows)
    }

    /// Passes to `sink` everything that decides on a case's results, except the engines that judge
    /// them: the modules that the GPU and the interpreter run (without comments), their numbers and
    /// their images, always in the same order.
    ///
    /// # Errors
    /// Errors of the compiler.
    pub fn content(
        &mut self,
        case: &Case,
        effort: &Effort,
        sink: &mut dyn FnMut(&[u8]),
    ) -> Result<(), Vec<Diagnostic>> {
        let bench = self.bench(case)?;
        self.content_of(&bench, &samples(&bench, effort), sink)
    }

    /// Content as of [`content`](Self::content), for chosen samples of a bench.
    ///
    /// # Errors
    /// Errors of the compiler.
    pub fn content_of(
        &mut self,
        bench: &NodeBench,
        all: &[Numbers],
        sink: &mut dyn FnMut(&[u8]),
    ) -> Result<(), Vec<Diagnostic>> {
        sink(format!("{:?} {}", bench.case, bound(&bench.case, &self.library)).as_bytes());
        let all: Vec<EvalSample> =
            all.iter().map(|numbers| sample(&bench.slots, numbers)).collect();
        for root in &bench.roots {
            let run = self.batches(&bench.look, root, &all, self.is_unspecialized(bench))?;
            let truth = self.batches(&bench.exact, root, &all, true)?;
            for batch in run.iter().chain(&truth) {
                sink(code(&batch.shader.wgsl).as_bytes());
                let numbers = batch.samples.numbers.iter().flat_map(|number| number.to_le_bytes());
                sink(&numbers.collect::<Vec<u8>>());
                batch.images.iter().for_each(|image| sink(&image.bytes));
            }
        }
        Ok(())
    }

    /// True if the GPU runs a case without specialization: `prepare`, if the node has one, then
    /// runs in the fragment stage.
    fn is_unspecialized(&self, bench: &NodeBench) -> bool {
        let has_prepare =
            self.library.nodes.get(&bench.case.node).is_some_and(|def| def.prepare.is_some());
        !has_prepare || bench.case.prepared_in_fragment
    }

    /// Measures a case.
    ///
    /// # Errors
    /// Errors of the compiler, the GPU or the interpreter.
    pub async fn measure(
        &mut self,
        case: &Case,
        effort: &Effort,
    ) -> Result<CaseFigures, MeasureError> {
        let bench = self.bench(case)?;
        let samples = samples(&bench, effort);
        let findings = self.compare(&bench, &samples).await?;
        let mut worst = self.sum_up(&bench, findings);
        if effort.rounds > 0 {
            super::search::climb(self, &bench, &mut worst, effort.rounds).await?;
        }
        Ok(worst)
    }

    /// Results of samples, in their order, judged as the case is. The error of a finite result that
    /// no bound applies to is 0.
    ///
    /// # Errors
    /// Errors of the compiler, the GPU or the interpreter.
    pub async fn compare(
        &mut self,
        bench: &NodeBench,
        samples: &[Numbers],
    ) -> Result<Vec<Finding>, MeasureError> {
        let got = self.run(bench, samples).await?;
        let truth = self.truth(bench, samples)?;
        let finding = |((numbers, got), truth): ((&Numbers, Vec<f64>), Vec<f64>)| {
            let (absolute, error) = (
                difference(&got, &truth),
                distance(&got, &truth, least_range(&bench.case, numbers)),
            );
            Finding { numbers: numbers.clone(), got, truth, absolute, error }
        };
        let mut findings: Vec<Finding> = samples.iter().zip(got).zip(truth).map(finding).collect();
        let judging = judging(&bench.case);
        let most = bound(&bench.case, &self.library);
        // A result that no bound applies to only has to be finite.
        let is_above = |finding: &Finding, enough: f64| {
            finding.error > enough
                && finding.got.iter().all(|x| x.is_finite())
                && is_stated(&bench.case, &bench.slots, &finding.numbers)
        };
        self.flush(bench, &|finding| is_above(finding, 0.25 * most), &mut findings)?;
        if judging != ErrorMetric::Plain {
            for (more, share) in AROUND {
                let slack = |finding: &Finding| slack(&bench.case, &bench.slots, &finding.numbers);
                let is_open = |&index: &usize| {
                    is_above(&findings[index], share * most * slack(&findings[index]))
                };
                let open: Vec<usize> = (0..findings.len()).filter(is_open).collect();
                for indices in open.chunks(400) {
                    self.judge(bench, judging, indices, more, &mut findings)?;
                }
            }
        }
        for finding in &mut findings {
            let is_stated = is_stated(&bench.case, &bench.slots, &finding.numbers);
            finding.error /= slack(&bench.case, &bench.slots, &finding.numbers);
            if !is_stated && finding.error.is_finite() {
                finding.error = 0.0;
            }
        }
        Ok(findings)
    }

    /// Judges doubtful samples again with denormals as 0. WGSL allows that, and halving makes
    /// denormals of a few more numbers: a result is right if it is right with either.
    fn flush(
        &mut self,
        bench: &NodeBench,
        doubtful: &dyn Fn(&Finding) -> bool,
        findings: &mut [Finding],
    ) -> Result<(), MeasureError> {
        for below in [1.0, 4.0] {
            let is_tiny = |x: &f64| *x != 0.0 && x.abs() < below * f64::from(f32::MIN_POSITIVE);
            let has_any = |finding: &Finding| finding.numbers.iter().flatten().any(is_tiny);
            let is_open = |i: &usize| has_any(&findings[*i]) && doubtful(&findings[*i]);
            let open: Vec<usize> = (0..findings.len()).filter(is_open).collect();
            let flushed = |x: &f64| if is_tiny(x) { 0.0_f64.copysign(*x) } else { *x };
            let row = |&index: &usize| -> Numbers {
                findings[index]
                    .numbers
                    .iter()
                    .map(|numbers| numbers.iter().map(flushed).collect())
                    .collect()
            };
            let rows: Vec<Numbers> = open.iter().map(row).collect();
            for (&index, truth) in open.iter().zip(self.truth(bench, &rows)?) {
                let finding = &mut findings[index];
                let error =
                    distance(&finding.got, &truth, least_range(&bench.case, &finding.numbers));
                if error < finding.error {
                    (finding.error, finding.absolute, finding.truth) =
                        (error, difference(&finding.got, &truth), truth);
                }
            }
        }
        Ok(())
    }

    /// Judges samples by the true results of their neighbors: the regular ones, and `more` random
    /// ones.
    fn judge(
        &mut self,
        bench: &NodeBench,
        judging: ErrorMetric,
        indices: &[usize],
        more: usize,
        findings: &mut [Finding],
    ) -> Result<(), MeasureError> {
        let together = moves_together(&bench.case);
        let mut around = Vec::new();
        let mut counts = Vec::new();
        for &index in indices {
            let before = around.len();
            neighbors(&bench.slots, &findings[index].numbers, together, more, &mut around);
            counts.push(around.len() - before);
        }
        let truths = self.truth(bench, &around)?;
        let mut first = 0;
        for (&index, count) in indices.iter().zip(counts) {
            let finding = &mut findings[index];
            let mut set: Vec<&[f64]> =
                truths[first..first + count].iter().map(Vec::as_slice).collect();
            set.push(&finding.truth);
            let least = least_range(&bench.case, &finding.numbers);
            let error = match judging {
                ErrorMetric::Steps => nearest(&finding.got, &set, least),
                _ => beyond(&finding.got, &set, least),
            };
            finding.error = finding.error.min(error);
            first += count;
        }
        Ok(())
    }

    fn sum_up(&self, bench: &NodeBench, findings: Vec<Finding>) -> CaseFigures {
        let bound = bound(&bench.case, &self.library);
        let mut measured = CaseFigures {
            case: bench.case.clone(),
            samples: findings.len(),
            rounded: 0,
            broken: 0,
            absolute: 0.0,
            p999: 0.0,
            max: 0.0,
            bound,
            worst: Vec::new(),
            worst_words: String::new(),
        };
        let mut ordinary = Vec::new();
        let mut judged = Vec::new();
        for finding in findings {
            if finding.got.iter().any(|x| !x.is_finite()) {
                measured.broken += 1;
                judged.push(finding);
                continue;
            }
            if !is_stated(&bench.case, &bench.slots, &finding.numbers) {
                continue;
            }
            if bench
                .slots
                .iter()
                .zip(&finding.numbers)
                .all(|(slot, numbers)| slot.is_ordinary(numbers))
            {
                ordinary.push(finding.error);
                measured.absolute = measured.absolute.max(finding.absolute);
            }
            let least = least_range(&bench.case, &finding.numbers);
            measured.rounded += usize::from(
                finding.error <= bound && distance(&finding.got, &finding.truth, least) > bound,
            );
            measured.max = measured.max.max(finding.error);
            judged.push(finding);
        }
        if !ordinary.is_empty() {
            let rank = (ordinary.len() * 999 / 1000).min(ordinary.len() - 1);
            measured.p999 = *ordinary.select_nth_unstable_by(rank, f64::total_cmp).1;
        }
        judged.sort_by(|a, b| b.error.total_cmp(&a.error));
        judged.truncate(KEPT);
        measured.worst_words =
            judged.first().map_or_else(String::new, |finding| words(bench, finding));
        measured.worst = judged;
        measured
    }
}

impl std::fmt::Debug for Laboratory<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "a laboratory of {} nodes", self.library.nodes.len())
    }
}

fn collect(batch: &EvalBatch, values: impl Iterator<Item = [f64; 4]>, rows: &mut [Vec<f64>]) {
    let ty = &batch.shader.root_type;
    for (&index, value) in batch.indices.iter().zip(values) {
        match ty {
            // An angle is compared in radians, which tell more than sine and cosine of its half; a
            // result that is not finite stays so.
            Type::Angle => rows[index].push(2.0 * value[0].atan2(value[1])),
            _ => rows[index].extend(&value[..ty.width().unwrap_or(4)]),
        }
    }
}

/// Samples of a bench: spread evenly within the documented ranges, then at the edges of arithmetic.
fn samples(bench: &NodeBench, effort: &Effort) -> Vec<Numbers> {
    let mut random = Random::of(&bench.case.name());
    let widths: Vec<usize> = bench.slots.iter().map(|slot| slot.width).collect();
    let even = EvenPoints::new(widths.iter().sum());
    let ordinary = |index: usize| -> Numbers {
        let mut shares = even.point(index).into_iter();
        bench
            .slots
            .iter()
            .map(|slot| slot.ordinary(&shares.by_ref().take(slot.width).collect::<Vec<_>>()))
            .collect()
    };
    let mut all: Vec<Numbers> = (0..effort.ordinary).map(ordinary).collect();
    if bench.slots.is_empty() {
        all.truncate(1);
        return all;
    }
    for index in 0..effort.extreme {
        let mut numbers = ordinary(effort.ordinary + index);
        let share = random.pick(&[0.2, 0.5, 1.0]);
        for (slot, numbers) in bench.slots.iter().zip(&mut numbers) {
            if random.chance(share) {
                *numbers = slot.extreme(&mut random);
            }
        }
        if random.chance(0.35) {
            relate(&bench.slots, &mut numbers, &mut random);
        }
        all.push(numbers);
    }
    all
}

/// Appends to `to` the neighbors of a sample, which f32 can hardly tell from it: each number moved
/// by one and by four units in the last place, all numbers moved at once, and `more` neighbors
/// whose numbers are moved at random by up to four units. Numbers of a direction move by units of
/// its largest number; if `together`, all move by units of the largest number of the sample, which
/// is at least 1.
fn neighbors(
    slots: &[InputSlot],
    numbers: &Numbers,
    together: bool,
    more: usize,
    to: &mut Vec<Numbers>,
) {
    let largest = |numbers: &[f64]| numbers.iter().map(|x| x.abs()).fold(0.0, f64::max);
    let all = numbers.iter().map(|numbers| largest(numbers)).fold(1.0, f64::max);
    // A turned angle has as many digits as pi, not as many as itself.
    let is_turned =
        slots.iter().zip(numbers).any(|(slot, numbers)| slot.name == "shift" && numbers[0] != 0.0);
    let moved = |slot: &InputSlot, numbers: &[f64], place: usize, steps: i32| {
        let x = numbers[place];
        let whole = match slot.kind {
            _ if together => all,
            SlotKind::Unit | SlotKind::Direction => largest(numbers),
            SlotKind::HalfAngle if is_turned => largest(numbers),
            _ => return next(x, steps),
        };
        let unit = next(whole, 1) - whole;
        if unit.is_finite() && unit > 0.0 {
            held(x + f64::from(steps) * unit)
        } else {
            next(x, steps)
        }
    };
    for (index, slot) in slots.iter().enumerate().filter(|(_, slot)| slot.is_continuous()) {
        for place in 0..slot.width {
            for steps in [-4, -1, 1, 4] {
                let mut other = numbers.clone();
                other[index][place] = moved(slot, &numbers[index], place, steps);
                to.push(other);
            }
            // A number this small may be lost beside the largest one, so a neighbor has 0 in its
            // place.
            if together && numbers[index][place].abs() < 1e-6 * all {
                let mut other = numbers.clone();
                other[index][place] = 0.0;
                to.push(other);
            }
        }
    }
    // Moves all up, all down, and every other one, every other two, every other four.
    for (period, flip) in [0, 1, 2, 4].into_iter().flat_map(|period| [(period, 1), (period, -1)]) {
        let mut other = numbers.clone();
        let mut count = 0;
        for (index, slot) in slots.iter().enumerate().filter(|(_, slot)| slot.is_continuous()) {
            for (place, x) in other[index].iter_mut().enumerate() {
                let sign = if period > 0 && (count / period) % 2 == 1 { -flip } else { flip };
                *x = moved(slot, &numbers[index], place, 3 * sign);
                count += 1;
            }
        }
        to.push(other);
    }
    let mut random = Random::new(more as u64);
    for _ in 0..more {
        let mut other = numbers.clone();
        for (index, slot) in slots.iter().enumerate().filter(|(_, slot)| slot.is_continuous()) {
            for (place, x) in other[index].iter_mut().enumerate() {
                let steps = random.index(9) as i32 - 4;
                if steps != 0 {
                    *x = moved(slot, &numbers[index], place, steps);
                }
            }
        }
        to.push(other);
    }
}

fn difference(got: &[f64], truth: &[f64]) -> f64 {
    let one = |(a, b): (&f64, &f64)| if (a - b).is_nan() { f64::INFINITY } else { (a - b).abs() };
    got.iter().zip(truth).map(one).fold(0.0, f64::max)
}

/// The largest difference of any number, over the result's range: the largest number of the truth,
/// at least `least`.
fn distance(got: &[f64], truth: &[f64], least: f64) -> f64 {
    difference(got, truth) / range(truth, least)
}

fn range(truth: &[f64], least: f64) -> f64 {
    truth.iter().map(|x| x.abs()).fold(least, f64::max)
}

/// The least range of a sample: 1, or its largest input if the size of inputs counts.
fn least_range(case: &Case, numbers: &Numbers) -> f64 {
    if counts_inputs(case) {
        numbers.iter().flatten().map(|x| x.abs()).fold(1.0, f64::max)
    } else {
        1.0
    }
}

/// Distance of a result from the span of a set of true results, over their range. The set's inputs
/// are whole units in the last place apart, up to four; true results of inputs half a unit beyond
/// count as within the span.
fn beyond(got: &[f64], set: &[&[f64]], least: f64) -> f64 {
    let range = set.iter().map(|truth| range(truth, least)).fold(1.0, f64::max);
    let outside = |(index, x): (usize, &f64)| {
        let of = set.iter().filter_map(|truth| truth.get(index));
        let (low, high) = of
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(*y), high.max(*y)));
        ((low - x).max(x - high) - (high - low) / 16.0).max(0.0)
    };
    got.iter().enumerate().map(outside).fold(0.0, f64::max) / range
}

/// Largest distance of any number of a result from the nearest in a set of true results, over their
/// range.
fn nearest(got: &[f64], set: &[&[f64]], least: f64) -> f64 {
    let one = |(index, x): (usize, &f64)| {
        let of = set
            .iter()
            .filter_map(|truth| truth.get(index).map(|y| (x - y).abs() / range(truth, least)));
        of.fold(f64::INFINITY, f64::min)
    };
    got.iter().enumerate().map(one).fold(0.0, f64::max)
}

/// A sample with these numbers in its slots.
pub fn sample(slots: &[InputSlot], all: &Numbers) -> EvalSample {
    let mut sample = EvalSample::default();
    let mut light = LightOverride::default();
    let vec3 = |numbers: &[f64]| glam::DVec3::from_slice(numbers);
    for (slot, numbers) in slots.iter().zip(all) {
        match slot.place {
            SlotTarget::Value => {
                let value = match (slot.kind, numbers.as_slice()) {
                    (SlotKind::Switch, [x]) => Value::Bool(*x > 0.5),
                    (_, [x]) => Value::Number(*x),
                    (_, more) => Value::Vector(more.to_vec()),
                };
                sample.values.insert(slot.name.as_str().into(), value);
            }
            SlotTarget::Part(part) => set_part(&mut sample, part, numbers),
            SlotTarget::Context(context) => drop(sample.contexts.insert(context, numbers.clone())),
            SlotTarget::LightDirection => light.direction = Some(vec3(numbers)),
            SlotTarget::LightPosition => light.position = Some(vec3(numbers)),
            SlotTarget::LightColor => light.color = Some(vec3(numbers)),
            SlotTarget::LightIntensity => light.intensity = Some(numbers[0]),
        }
    }
    if light != LightOverride::default() {
        sample.lights.insert("key".into(), light);
    }
    sample
}

/// Sets a part of a sample's surface.
fn set_part(sample: &mut EvalSample, part: SurfacePart, numbers: &[f64]) {
    let vec3 = || glam::DVec3::from_slice(numbers);
    match part {
        SurfacePart::Normal => sample.normal = vec3(),
        SurfacePart::Tangent => sample.tangent = Some(vec3()),
        SurfacePart::View => sample.view = vec3(),
        SurfacePart::Position => sample.position = vec3(),
        SurfacePart::Camera => {
            let turn = glam::DQuat::from_slice(numbers);
            sample.camera = glam::DMat3::from_quat(if turn.length() > 1e-9 {
                turn.normalize()
            } else {
                glam::DQuat::IDENTITY
            });
        }
        SurfacePart::Uv => sample.uv = glam::DVec2::from_slice(numbers),
        SurfacePart::VertexColor => {
            sample.vertex_color = [numbers[0], numbers[1], numbers[2], numbers[3]];
        }
        SurfacePart::Kappa => sample.kappa = numbers[0],
        SurfacePart::Time => sample.time = numbers[0],
    }
}

/// Description of a sample and its result.
pub(super) fn words(bench: &NodeBench, finding: &Finding) -> String {
    let fed: Vec<String> = bench
        .slots
        .iter()
        .zip(&finding.numbers)
        .map(|(slot, numbers)| format!("{} {}", slot.name, told(numbers)))
        .collect();
    format!("{} gives {} for {}", fed.join(", "), told(&finding.got), told(&finding.truth))
}

/// Numbers in the shortest form that f32 reads back.
pub fn told(numbers: &[f64]) -> String {
    let one = |x: &f64| {
        let x = *x as f32;
        if x != 0.0 && !(1e-4..1e7).contains(&x.abs()) { format!("{x:e}") } else { format!("{x}") }
    };
    let all: Vec<String> = numbers.iter().map(one).collect();
    if all.len() == 1 { all.concat() } else { format!("({})", all.join(", ")) }
}
