//! Fit of an existing look: its lights, profiles and colors are turned until it shows what was
//! painted.

use chiaro_locale::tr;

use super::choose::{SurfaceSamples, goals_of, pixels_of, thinned, wearing};
use super::knobs::{Knob, edits, knobs_of};
use super::model::{FitShot, LookProblem, Model};
use super::report::{ComparedPixel, ComparedPixels, FitReport, compared, painted as painted_of};
use super::rest::UnpaintedPixels;
use super::solve::{Minimum, StopRule, descend, stopped};
use super::state::KnobSetting;
use super::target::{FitTarget, PixelGoal};
use super::{FitOptions, FittedLook};
use crate::diag::Diagnostic;
use crate::document::{Edit, Look};
use crate::frame::Setup;
use crate::library::Library;
use crate::progress::Progress;

/// Number of pixel quads that a descent looks at.
const QUADS: usize = 96;
/// Number of evenly spread quads that stand for all, for goals that cannot all be met.
const EVEN_QUADS: usize = 128;
/// Number of steps at the evenly spread quads.
const EVEN_STEPS: usize = 12;
/// Number of steps from each starting point.
const FIRST_STEPS: usize = 10;
/// Number of starting points whose descent goes on.
const GOING_ON: usize = 2;
/// Number of times a look that is near is turned at other pixels.
const ROUNDS: usize = 5;
/// Width of a soft edge, in radians.
const SOFT: f64 = 0.6;

/// Turns look number `look` of `setup` until it shows the goals of `target`. Its nodes and wires
/// stay as they are.
///
/// # Errors
/// `fit-nothing` if the look has no knobs; `fit-target` if no painted pixel can be compared;
/// `stopped` if the fit was stopped before it came nearer, while a fit stopped later returns the
/// nearest look so far; problems of the setup.
pub fn fit_look(
    setup: &Setup,
    look: usize,
    library: &Library,
    target: &FitTarget,
    options: &FitOptions,
    progress: &Progress,
) -> Result<FittedLook, Vec<Diagnostic>> {
    let one = |problem| vec![problem];
    progress.begin(options.starts.max(1) as u64 + GOING_ON as u64 + 1);
    let shot = FitShot { setup, look, library, size: target.size, time: options.time };
    let mut given = thinned(target);
    if options.keep_rest > 0.0 {
        given.extend(UnpaintedPixels::new(&shot, target, options.keep_rest)?.goals);
    }
    let (model, begin) = model(&shot, &given, options)?;
    let goals = goals_of(&model.pixels, &given)?;
    let before = compared(&model, &goals, &begin).map_err(one)?;
    let missing = missing_of(&before);
    let painted = LookProblem::new(&model, &goals, &model.telling(&missing, QUADS));
    let enough = error_of(&painted.goals, options.enough);
    let mut found: Vec<Minimum<Vec<KnobSetting>>> = Vec::new();
    for start in starts(&shot, &given, &begin, &missing, options.starts)? {
        let until = StopRule { steps: FIRST_STEPS, error: enough };
        found.push(descend(&painted, start, until, progress).map_err(one)?);
        progress.add(1);
        found.sort_by(|a, b| a.error.total_cmp(&b.error));
        if found[0].error <= enough || progress.is_stopped() {
            break;
        }
    }
    found.truncate(GOING_ON);
    let mut best = NearestSettings::new(&model, &goals, begin).map_err(one)?;
    for start in found {
        let far =
            descend(&painted, start.point, StopRule { steps: 40, error: 0.25 * enough }, progress)
                .map_err(one)?;
        progress.add(1);
        best.offer(&model, &goals, far.point).map_err(one)?;
    }
    if best.error > error_of(&goals, options.enough) {
        // Not all goals can be met, and the pixels that are farthest off must not decide alone.
        let even = LookProblem::new(&model, &goals, &model.even(EVEN_QUADS));
        let until =
            StopRule { steps: EVEN_STEPS, error: error_of(&even.goals, 0.5 * options.enough) };
        let next = descend(&even, best.state.clone(), until, progress).map_err(one)?;
        best.offer(&model, &goals, next.point).map_err(one)?;
    }
    let state = best.state;
    let (turned, first) = applied(&model, &state, &setup.looks[look].look).map_err(one)?;
    let worn = wearing(&shot, turned);
    let PolishedLook { look: fitted, edits, after } =
        polished(&FitShot { setup: &worn, ..shot }, &given, 0.0, options, progress)?;
    progress.add(1);
    let is_stopped = progress.is_stopped();
    if squares(&missing_of(&after)) >= squares(&missing_of(&before)) {
        if is_stopped {
            return Err(vec![stopped()]);
        }
        // The fit, written in numbers that people read, is no nearer: the look stays as it was.
        let report =
            FitReport::new(&shot, &setup.looks[look].look, target, &before, &before, options)?;
        let misses = painted_of(&before);
        let edit = Edit::Group { edits: Vec::new() };
        return Ok(FittedLook { edit, look: setup.looks[look].look.clone(), report, misses });
    }
    let report = FitReport {
        is_stopped,
        ..FitReport::new(&shot, &fitted, target, &before, &after, options)?
    };
    if is_stopped && report.changed.is_empty() {
        // Rounding alone accounts for the gain.
        return Err(vec![stopped()]);
    }
    let edit = Edit::Group { edits: first.into_iter().chain(edits).collect() };
    let misses = painted_of(&after);
    Ok(FittedLook { edit, look: fitted, report, misses })
}

/// A look at the nearest minimum, after turning it at all painted pixels.
pub(super) struct PolishedLook {
    pub(super) look: Look,
    /// Edits that make the look of the former one.
    pub(super) edits: Vec<Edit>,
    /// Comparison of the look with the goals.
    pub(super) after: ComparedPixels,
}

/// Turns a look that is near further down at all painted pixels, with a preference for broad
/// profiles where that costs less than `soft`, an RMS of a channel.
///
/// # Errors
/// As [`fit_look`].
pub(super) fn polished(
    shot: &FitShot<'_>,
    given: &[PixelGoal],
    soft: f64,
    options: &FitOptions,
    progress: &Progress,
) -> Result<PolishedLook, Vec<Diagnostic>> {
    let one = |problem| vec![problem];
    let (model, begin) = model(shot, given, options)?;
    let goals = goals_of(&model.pixels, given)?;
    let mut best = NearestSettings::new(&model, &goals, begin).map_err(one)?;
    let mut is_even = false;
    for _ in 0..ROUNDS {
        // Colors painted in eight bits are off by a third of a step.
        if best.error <= error_of(&goals, 0.4 / 255.0) || progress.is_stopped() {
            break;
        }
        let chosen =
            if is_even { model.even(EVEN_QUADS) } else { model.telling(&best.missing, QUADS) };
        let painted = LookProblem::new(&model, &goals, &chosen).softly(soft);
        let steps = if is_even { EVEN_STEPS } else { 25 };
        let until = StopRule { steps, error: error_of(&painted.goals, 0.1 / 255.0) };
        let before = best.error;
        let next = descend(&painted, best.state.clone(), until, progress).map_err(one)?.point;
        best.offer(&model, &goals, next).map_err(one)?;
        if best.error > 0.95 * before {
            // The error of the pixels that are farthest off cannot be reduced: now evenly spread
            // pixels count alike, and if that does not help either, the fit ends.
            if is_even {
                break;
            }
            is_even = true;
        }
    }
    let state = best.state;
    let (look, edits) = applied(&model, &state, &shot.setup.looks[shot.look].look).map_err(one)?;
    // The comparison uses the settings as they are written, in numbers that people can read.
    let written = knobs_of(&wearing(shot, look.clone()), shot.look, shot.library, &options.keep)?;
    let written: Vec<KnobSetting> = written.into_iter().map(|(_, setting)| setting).collect();
    let after = compared(&model, &goals, &written).map_err(one)?;
    Ok(PolishedLook { look, edits, after })
}

/// The nearest settings so far at all painted pixels, however few a descent looks at.
struct NearestSettings {
    state: Vec<KnobSetting>,
    /// Sum of squared residuals.
    error: f64,
    /// Weighted distance of each pixel from its goal.
    missing: Vec<f64>,
}

impl NearestSettings {
    fn new(
        model: &Model,
        goals: &[PixelGoal],
        state: Vec<KnobSetting>,
    ) -> Result<Self, Diagnostic> {
        let missing = missing_of(&compared(model, goals, &state)?);
        Ok(Self { state, error: squares(&missing), missing })
    }

    /// Replaces these settings by others if those are nearer.
    fn offer(
        &mut self,
        model: &Model,
        goals: &[PixelGoal],
        state: Vec<KnobSetting>,
    ) -> Result<(), Diagnostic> {
        let other = Self::new(model, goals, state)?;
        if other.error < self.error {
            *self = other;
        }
        Ok(())
    }
}

fn squares(missing: &[f64]) -> f64 {
    missing.iter().map(|miss| miss * miss).sum()
}

/// The model of the look at the painted pixels, with the settings of its knobs.
fn model(
    shot: &FitShot<'_>,
    given: &[PixelGoal],
    options: &FitOptions,
) -> Result<(Model, Vec<KnobSetting>), Vec<Diagnostic>> {
    let (knobs, begin): (Vec<Knob>, Vec<KnobSetting>) =
        knobs_of(shot.setup, shot.look, shot.library, &options.keep)?.into_iter().unzip();
    if knobs.is_empty() {
        let problem = Diagnostic::error(
            "fit-nothing",
            tr!("the look has no light, profile or color that could be turned"),
        );
        return Err(vec![problem.hint(tr!(
            "what is wired or keyed stays as it is; or begin from nothing with --layers"
        ))]);
    }
    Ok((Model::new(shot, knobs, &pixels_of(given))?, begin))
}

/// A look with settings written into it, and the edits that do that.
fn applied(
    model: &Model,
    state: &[KnobSetting],
    look: &Look,
) -> Result<(Look, Vec<Edit>), Diagnostic> {
    let mut turned = look.clone();
    let edits = edits(&model.knobs, state, look);
    turned.apply(Edit::Group { edits: edits.clone() }).map_err(|problem| *problem)?;
    Ok((turned, edits))
}

/// The sum of squared residuals that corresponds to an RMS of `enough` in a channel.
fn error_of(goals: &[PixelGoal], enough: f64) -> f64 {
    3.0 * enough * enough * goals.iter().map(|goal| goal.weight).sum::<f64>()
}

/// Weighted distance of each pixel from its goal.
fn missing_of(compared: &ComparedPixels) -> Vec<f64> {
    compared.iter().map(ComparedPixel::miss).collect()
}

/// Starting points: the look as it is, then with soft profiles, then also with the lights where
/// most is missing.
fn starts(
    shot: &FitShot<'_>,
    given: &[PixelGoal],
    begin: &[KnobSetting],
    missing: &[f64],
    count: usize,
) -> Result<Vec<Vec<KnobSetting>>, Vec<Diagnostic>> {
    let softened = |setting: &KnobSetting| match setting {
        KnobSetting::Profile(shape) => KnobSetting::Profile(shape.softened(SOFT)),
        other => *other,
    };
    let soft: Vec<KnobSetting> = begin.iter().map(softened).collect();
    let mut starts = vec![begin.to_vec()];
    if count > 1 {
        starts.push(soft.clone());
    }
    if count > 2 {
        let surface = SurfaceSamples::new(shot, &pixels_of(given))?.directions;
        let mut order: Vec<usize> = (0..missing.len()).collect();
        order.sort_by(|&a, &b| missing[b].total_cmp(&missing[a]).then(a.cmp(&b)));
        // Lights come, in turns, from the normal and from the mirrored view of one of the quarter
        // of the pixels that are farthest off.
        let far = order.len() / 4 + 1;
        for start in 2..count {
            let mut next = start;
            let turned = |setting: &KnobSetting| match setting {
                KnobSetting::Direction(_) => {
                    // A large prime as the step spreads the lights over these pixels.
                    let pixel = order[next * 7919 % far];
                    next += count;
                    KnobSetting::Direction(surface[pixel][start % 2])
                }
                other => *other,
            };
            starts.push(soft.iter().map(turned).collect());
        }
    }
    Ok(starts)
}
