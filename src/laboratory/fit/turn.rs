//! A look that is there: its lights, profiles and colors are turned until it shows what was
//! painted.

use super::choose::{Surface, pixels_of, thinned, wearing, wishes_of};
use super::knobs::{Knob, edits, knobs_of};
use super::model::{Model, Painted, Shot};
use super::report::{ComparedPixel, ComparedPixels, Report, compared, painted as painted_of};
use super::rest::Rest;
use super::solve::{Minimum, StopRule, descend, stopped};
use super::state::Setting;
use super::target::{PixelGoal, Target};
use super::{FitOptions, FittedLook};
use crate::diag::Diagnostic;
use crate::document::{Edit, Look};
use crate::frame::Setup;
use crate::library::Library;
use crate::progress::Progress;

/// Quads of pixels that are looked at.
const QUADS: usize = 96;
/// Quads that stand for all, where not all that is wished can be had.
const EVEN_QUADS: usize = 128;
/// Steps at those.
const EVEN_STEPS: usize = 12;
/// Steps of a beginning.
const FIRST_STEPS: usize = 10;
/// Beginnings that go on.
const GOING_ON: usize = 2;
/// How often a look that is near is turned at other pixels.
const ROUNDS: usize = 5;
/// Radians that a soft edge is wide.
const SOFT: f64 = 0.6;

/// Turns look number `look` of `setup` until it shows what `target` wishes. Its nodes and wires
/// stay as they are.
///
/// # Errors
/// `fit-nothing` where the look has nothing that could be turned; `fit-target` where no painted
/// pixel can be compared; `stopped` where it was stopped before it came nearer, else the nearest
/// that it had come to is what was fitted; what is wrong with the setup.
pub fn fit_look(
    setup: &Setup,
    look: usize,
    library: &Library,
    target: &Target,
    options: &FitOptions,
    progress: &Progress,
) -> Result<FittedLook, Vec<Diagnostic>> {
    let one = |problem| vec![problem];
    progress.begin(options.starts.max(1) as u64 + GOING_ON as u64 + 1);
    let shot = Shot { setup, look, library, size: target.size, time: options.time };
    let mut given = thinned(target);
    if options.keep_rest > 0.0 {
        given.extend(Rest::new(&shot, target, options.keep_rest)?.wishes);
    }
    let (model, begin) = model(&shot, &given, options)?;
    let wishes = wishes_of(&model.pixels, &given)?;
    let before = compared(&model, &wishes, &begin).map_err(one)?;
    let missing = missing_of(&before);
    let painted = Painted::new(&model, &wishes, &model.telling(&missing, QUADS));
    let enough = error_of(&painted.wishes, options.enough);
    let mut found: Vec<Minimum<Vec<Setting>>> = Vec::new();
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
    let mut best = Nearest::new(&model, &wishes, begin).map_err(one)?;
    for start in found {
        let far =
            descend(&painted, start.point, StopRule { steps: 40, error: 0.25 * enough }, progress)
                .map_err(one)?;
        progress.add(1);
        best.offer(&model, &wishes, far.point).map_err(one)?;
    }
    if best.error > error_of(&wishes, options.enough) {
        // Not all of it can be had, and what is farthest off must not have its way alone.
        let even = Painted::new(&model, &wishes, &model.even(EVEN_QUADS));
        let until =
            StopRule { steps: EVEN_STEPS, error: error_of(&even.wishes, 0.5 * options.enough) };
        let next = descend(&even, best.state.clone(), until, progress).map_err(one)?;
        best.offer(&model, &wishes, next.point).map_err(one)?;
    }
    let state = best.state;
    let (turned, first) = applied(&model, &state, &setup.looks[look].look).map_err(one)?;
    let worn = wearing(&shot, turned);
    let Polished { look: fitted, edits, after } =
        polished(&Shot { setup: &worn, ..shot }, &given, 0.0, options, progress)?;
    progress.add(1);
    let is_stopped = progress.is_stopped();
    if squares(&missing_of(&after)) >= squares(&missing_of(&before)) {
        if is_stopped {
            return Err(vec![stopped()]);
        }
        // What is written in numbers that people read is no nearer: it stays.
        let report =
            Report::new(&shot, &setup.looks[look].look, target, &before, &before, options)?;
        let misses = painted_of(&before);
        let edit = Edit::Group { edits: Vec::new() };
        return Ok(FittedLook { edit, look: setup.looks[look].look.clone(), report, misses });
    }
    let report =
        Report { is_stopped, ..Report::new(&shot, &fitted, target, &before, &after, options)? };
    if is_stopped && report.changed.is_empty() {
        // No nearer than rounding makes it.
        return Err(vec![stopped()]);
    }
    let edit = Edit::Group { edits: first.into_iter().chain(edits).collect() };
    let misses = painted_of(&after);
    Ok(FittedLook { edit, look: fitted, report, misses })
}

/// A look that was turned to where it is nearest.
pub(super) struct Polished {
    pub(super) look: Look,
    /// What makes it of the look before.
    pub(super) edits: Vec<Edit>,
    /// How far off it is.
    pub(super) after: ComparedPixels,
}

/// Turns a look that is near downhill at all painted pixels; its profiles are to be broad where
/// that costs less than `soft`, an RMS of a channel.
///
/// # Errors
/// As [`fit_look`].
pub(super) fn polished(
    shot: &Shot<'_>,
    given: &[PixelGoal],
    soft: f64,
    options: &FitOptions,
    progress: &Progress,
) -> Result<Polished, Vec<Diagnostic>> {
    let one = |problem| vec![problem];
    let (model, begin) = model(shot, given, options)?;
    let wishes = wishes_of(&model.pixels, given)?;
    let mut best = Nearest::new(&model, &wishes, begin).map_err(one)?;
    let mut is_even = false;
    for _ in 0..ROUNDS {
        // What is painted in eight bits is off by a third of a step.
        if best.error <= error_of(&wishes, 0.4 / 255.0) || progress.is_stopped() {
            break;
        }
        let chosen =
            if is_even { model.even(EVEN_QUADS) } else { model.telling(&best.missing, QUADS) };
        let painted = Painted::new(&model, &wishes, &chosen).softly(soft);
        let steps = if is_even { EVEN_STEPS } else { 25 };
        let until = StopRule { steps, error: error_of(&painted.wishes, 0.1 / 255.0) };
        let before = best.error;
        let next = descend(&painted, best.state.clone(), until, progress).map_err(one)?.point;
        best.offer(&model, &wishes, next).map_err(one)?;
        if best.error > 0.95 * before {
            // What is farthest off cannot be mended: then all of it counts alike, and after that no
            // more is to be had.
            if is_even {
                break;
            }
            is_even = true;
        }
    }
    let state = best.state;
    let (look, edits) = applied(&model, &state, &shot.setup.looks[shot.look].look).map_err(one)?;
    // As it is written, in numbers that people can read.
    let written = knobs_of(&wearing(shot, look.clone()), shot.look, shot.library, &options.keep)?;
    let written: Vec<Setting> = written.into_iter().map(|(_, setting)| setting).collect();
    let after = compared(&model, &wishes, &written).map_err(one)?;
    Ok(Polished { look, edits, after })
}

/// What is nearest so far at all painted pixels, however few a descent looks at.
struct Nearest {
    state: Vec<Setting>,
    /// The sum of squared residuals.
    error: f64,
    /// How far off each pixel is, as much as it counts.
    missing: Vec<f64>,
}

impl Nearest {
    fn new(model: &Model, wishes: &[PixelGoal], state: Vec<Setting>) -> Result<Self, Diagnostic> {
        let missing = missing_of(&compared(model, wishes, &state)?);
        Ok(Self { state, error: squares(&missing), missing })
    }

    /// Takes another one if it is nearer.
    fn offer(
        &mut self,
        model: &Model,
        wishes: &[PixelGoal],
        state: Vec<Setting>,
    ) -> Result<(), Diagnostic> {
        let other = Self::new(model, wishes, state)?;
        if other.error < self.error {
            *self = other;
        }
        Ok(())
    }
}

fn squares(missing: &[f64]) -> f64 {
    missing.iter().map(|miss| miss * miss).sum()
}

/// The look at the painted pixels, with where everything stands.
fn model(
    shot: &Shot<'_>,
    given: &[PixelGoal],
    options: &FitOptions,
) -> Result<(Model, Vec<Setting>), Vec<Diagnostic>> {
    let (knobs, begin): (Vec<Knob>, Vec<Setting>) =
        knobs_of(shot.setup, shot.look, shot.library, &options.keep)?.into_iter().unzip();
    if knobs.is_empty() {
        let problem = Diagnostic::error(
            "fit-nothing",
            "the look has no light, profile or color that could be turned",
        );
        return Err(vec![
            problem
                .hint("what is wired or keyed stays as it is; or begin from nothing with --layers"),
        ]);
    }
    Ok((Model::new(shot, knobs, &pixels_of(given))?, begin))
}

/// A look with what is turned written into it, and the edits that do that.
fn applied(model: &Model, state: &[Setting], look: &Look) -> Result<(Look, Vec<Edit>), Diagnostic> {
    let mut turned = look.clone();
    let edits = edits(&model.knobs, state, look);
    turned.apply(Edit::Group { edits: edits.clone() }).map_err(|problem| *problem)?;
    Ok((turned, edits))
}

/// The sum of squared residuals that is an RMS of `enough` in a channel.
fn error_of(wishes: &[PixelGoal], enough: f64) -> f64 {
    3.0 * enough * enough * wishes.iter().map(|wish| wish.weight).sum::<f64>()
}

/// How far off each pixel is, as much as it counts.
fn missing_of(compared: &ComparedPixels) -> Vec<f64> {
    compared.iter().map(ComparedPixel::miss).collect()
}

/// Where to begin: as it is, then with soft profiles, then also with the lights where most is
/// missing.
fn starts(
    shot: &Shot<'_>,
    given: &[PixelGoal],
    begin: &[Setting],
    missing: &[f64],
    count: usize,
) -> Result<Vec<Vec<Setting>>, Vec<Diagnostic>> {
    let softened = |setting: &Setting| match setting {
        Setting::Profile(shape) => Setting::Profile(shape.softened(SOFT)),
        other => *other,
    };
    let soft: Vec<Setting> = begin.iter().map(softened).collect();
    let mut starts = vec![begin.to_vec()];
    if count > 1 {
        starts.push(soft.clone());
    }
    if count > 2 {
        let surface = Surface::new(shot, &pixels_of(given))?.directions;
        let mut order: Vec<usize> = (0..missing.len()).collect();
        order.sort_by(|&a, &b| missing[b].total_cmp(&missing[a]).then(a.cmp(&b)));
        // Of the quarter of the pixels that are farthest off, by turns the normal and what a mirror
        // would show there.
        let far = order.len() / 4 + 1;
        for start in 2..count {
            let mut next = start;
            let turned = |setting: &Setting| match setting {
                Setting::Direction(_) => {
                    let pixel = order[next * 7919 % far];
                    next += count;
                    Setting::Direction(surface[pixel][start % 2])
                }
                other => *other,
            };
            starts.push(soft.iter().map(turned).collect());
        }
    }
    Ok(starts)
}
