//! Fit of light layers from nothing: each layer is searched for where most is missing, and all
//! layers are adjusted together after that.
//!
//! A layer is tried with lights from everywhere, and from the directions of the pixels that miss
//! most (their normals, or what a mirror would show there), with a few profiles, at every place in
//! the stack. The best few descend to a minimum, and the best stacks of those go on to the next
//! layer, as one layer's best place is not always the best with the next. If the whole is not near
//! enough, the lowest layer is turned over, and layers are taken out and searched for again.

use chiaro_locale::tr;
use glam::DVec3;
use rayon::iter::{
    IntoParallelIterator as _, IntoParallelRefIterator as _, IntoParallelRefMutIterator as _,
    ParallelIterator as _,
};

use super::beam::{FitStack, WIDTHS, Width, apart, best_of};
use super::build::layered;
use super::choose::{SurfaceSamples, evenly, goals_of, pixels_of, telling, thinned, wearing};
use super::lit::{LayerLight, LightingModel};
use super::model::FitShot;
use super::report::{FitReport, compared_as_is, painted};
use super::rest::UnpaintedPixels;
use super::solve::{Minimum, StopRule, descend, stopped};
use super::stack::{BlendMode, FitLayer, MAX_LAYERS, Search};
use super::state::{ProfileShape, even_directions};
use super::target::{FitTarget, PixelGoal};
use super::turn::{PolishedLook, polished};
use super::{FitOptions, FittedLook};
use crate::diag::Diagnostic;
use crate::document::Edit;
use crate::frame::Setup;
use crate::library::Library;
use crate::progress::Progress;

/// Number of pixels that a search looks at.
const PIXELS: usize = 320;
/// Number of those pixels that every light is tried at.
const FEW_PIXELS: usize = 96;
/// Number of lights from where most is missing.
const TELLING: usize = 12;
/// Profiles that a search begins with: offset, fall-off and cut-off, in degrees.
const SHAPES: [[f64; 3]; 6] = [
    [0.0, 60.0, 90.0],
    [0.0, 70.0, 120.0],
    [10.0, 20.0, 35.0],
    [20.0, 40.0, 60.0],
    [45.0, 60.0, 75.0],
    [70.0, 85.0, 100.0],
];
/// Error that a hard profile counts as if next to nothing is painted, as an RMS of a channel.
const SOFT: f64 = 4.0 / 255.0;
/// Number of times layers are searched for again if the whole is not near enough.
const ROUNDS: usize = 2;

/// Lays up to `layers` light layers over a base so that they show the goals of `target` in `setup`,
/// and puts them in the place of the nodes of look number `look`. Layers that would change nothing
/// are left out.
///
/// # Errors
/// `fit-target` if no painted pixel can be compared; `fit-layers` for no or too many layers;
/// `stopped` if the fit was stopped before there was a layer, while a fit stopped later returns the
/// nearest look so far; problems of the setup.
pub fn fit_layers(
    setup: &Setup,
    look: usize,
    library: &Library,
    target: &FitTarget,
    layers: usize,
    options: &FitOptions,
    progress: &Progress,
) -> Result<FittedLook, Vec<Diagnostic>> {
    let one = |problem| vec![problem];
    if !(1..=MAX_LAYERS).contains(&layers) {
        let message = tr!("{layers} layers cannot be laid; it is 1 to {MAX_LAYERS}");
        return Err(one(Diagnostic::error("fit-layers", message)));
    }
    let shot = FitShot { setup, look, library, size: target.size, time: options.time };
    let rest = UnpaintedPixels::new(&shot, target, options.keep_rest)?;
    // The smaller the painted part, the less evidence there is for a hard edge.
    let soft = SOFT * rest.share;
    let mut given = thinned(target);
    given.extend(rest.goals);
    let chosen = pixels_of(&given);
    let SurfaceSamples { directions, pixels } = SurfaceSamples::new(&shot, &chosen)?;
    let goals = goals_of(&pixels, &given)?;
    let at =
        |most: usize| Search::new(&directions, &goals, &evenly(goals.len(), most)).softly(soft);
    let (whole, even) = (at(goals.len()), at(PIXELS));
    let mut best: Option<FitStack> = None;
    for width in WIDTHS {
        // Another search begins anew, and so does its progress.
        progress.begin(layers as u64 + 2);
        let grower = Grower {
            surface: &directions,
            goals: &goals,
            whole: &whole,
            even: &even,
            soft,
            enough: options.enough,
            width,
            progress,
        };
        let found = grower.grow(layers).map_err(one)?;
        if best.as_ref().is_none_or(|best| found.error < best.error) {
            best = Some(found);
        }
        if progress.is_stopped()
            || best.as_ref().is_some_and(|best| best.error <= whole.error_of(2.0 * options.enough))
        {
            break;
        }
    }
    let stack = whole.taken_over(&best.map(|best| best.point).unwrap_or_default());
    if stack.is_empty() && progress.is_stopped() {
        return Err(one(stopped()));
    }
    let colors = whole.colors(&stack);
    let built = layered(&setup.looks[look].look.name, &stack, &colors);
    let worn = wearing(&shot, built);
    let before = compared_as_is(&shot, &given)?;
    let PolishedLook { look: fitted, after, .. } =
        polished(&FitShot { setup: &worn, ..shot }, &given, soft, options, progress)?;
    progress.add(1);
    let report = FitReport::new(&shot, &fitted, target, &before, &after, options)?;
    let report = FitReport { is_stopped: progress.is_stopped(), ..report };
    let misses = painted(&after);
    Ok(FittedLook {
        edit: Edit::Replace { look: Box::new(fitted.clone()) },
        look: fitted,
        report,
        misses,
    })
}

struct Grower<'a> {
    /// The normal and the mirrored view at each pixel.
    surface: &'a [[DVec3; 2]],
    goals: &'a [PixelGoal],
    /// Search at all pixels, and at a smaller number that stands for all.
    whole: &'a Search,
    even: &'a Search,
    /// Error that a hard profile counts as, as an RMS of a channel.
    soft: f64,
    enough: f64,
    width: Width,
    progress: &'a Progress,
}

impl Grower<'_> {
    /// Grows a stack of up to `most` layers.
    fn grow(&self, most: usize) -> Result<FitStack, Diagnostic> {
        let whole = self.whole;
        let mut best: Vec<FitLayer> = Vec::new();
        let mut beam = vec![best.clone()];
        for _ in 0..most {
            let missing = missing(whole, &best);
            let search = self.search(&missing);
            let mut found = Vec::new();
            for stack in &beam {
                found.extend(self.with_one_more(&search, &search.taken_over(stack), &missing)?);
            }
            let mut found = best_of(found, self.width.beam);
            self.evened(&mut found)?;
            let Some(first) = found.first() else { break };
            best.clone_from(&first.point);
            beam = found.iter().map(|stack| stack.point.clone()).collect();
            self.progress.add(1);
            if whole.error(&whole.taken_over(&best)) <= whole.error_of(self.enough) {
                break;
            }
        }
        let best = self.again(best)?;
        self.progress.add(1);
        Ok(best)
    }

    /// A search at the pixels where most is missing.
    fn search(&self, missing: &[f64]) -> Search {
        Search::new(self.surface, self.goals, &telling(missing, PIXELS)).softly(self.soft)
    }

    /// Lets the stacks that are not near enough descend at evenly spread pixels, and sorts all by
    /// their error over all pixels. Where not all goals can be met, the pixels that are farthest
    /// off must not decide alone.
    fn evened(&self, stacks: &mut [FitStack]) -> Result<(), Diagnostic> {
        let Self { whole, even, .. } = *self;
        let step = |stack: &mut FitStack| -> Result<(), Diagnostic> {
            stack.error = whole.error(&whole.taken_over(&stack.point));
            if stack.error > whole.error_of(self.enough) {
                let until = StopRule { steps: 20, error: even.error_of(0.5 * self.enough) };
                let point =
                    descend(even, even.taken_over(&stack.point), until, self.progress)?.point;
                let error = whole.error(&whole.taken_over(&point));
                if error < stack.error {
                    *stack = Minimum { point, error };
                }
            }
            Ok(())
        };
        stacks.par_iter_mut().try_for_each(step)?;
        stacks.sort_by(|a, b| a.error.total_cmp(&b.error));
        Ok(())
    }

    /// Turns the lowest layer over, then takes each layer out and searches for it again, as long as
    /// that brings the whole nearer.
    fn again(&self, best: Vec<FitLayer>) -> Result<FitStack, Diagnostic> {
        let whole = self.whole;
        let mut best = Minimum { error: whole.error(&whole.taken_over(&best)), point: best };
        for _ in 0..ROUNDS {
            let before = best.error;
            // The lowest layer is turned over first, then each layer is left out in turn.
            for out in std::iter::once(None).chain((0..best.point.len()).map(Some)) {
                if best.error <= whole.error_of(self.enough) || self.progress.is_stopped() {
                    return Ok(best);
                }
                let missing = missing(whole, &best.point);
                let search = self.search(&missing);
                let mut rest = search.taken_over(&best.point);
                let mut found = match out {
                    None => self.turned_over(&search, &rest)?,
                    Some(index) => {
                        rest.remove(index);
                        self.with_one_more(&search, &rest, &missing)?
                    }
                };
                self.evened(&mut found)?;
                if let Some(nearest) =
                    found.into_iter().next().filter(|found| found.error < 0.98 * best.error)
                {
                    best = nearest;
                }
            }
            if best.error > 0.9 * before {
                break;
            }
        }
        Ok(best)
    }

    /// Stacks whose lowest layer is turned over, to cover its complement, at any place: light that
    /// covers a dark base, and dark that covers a light base from the other side, are so nearly the
    /// same picture that a search may find either.
    fn turned_over(
        &self,
        search: &Search,
        layers: &[FitLayer],
    ) -> Result<Vec<FitStack>, Diagnostic> {
        let Some((lowest, rest)) = layers.split_first() else { return Ok(Vec::new()) };
        let lit = lowest.lit.turned_over();
        let tone = search.tone(&lit);
        let over = |(place, mode)| {
            let mut point = rest.to_vec();
            point.insert(place, FitLayer { lit, mode, tone: tone.clone() });
            point
        };
        self.downhill(search, places(rest.len(), search).into_iter().map(over).collect())
    }

    /// The best of some stacks, after descending.
    fn downhill(
        &self,
        search: &Search,
        stacks: Vec<Vec<FitLayer>>,
    ) -> Result<Vec<FitStack>, Diagnostic> {
        let turned = |stack: Vec<FitLayer>, steps: usize, share: f64| {
            descend(
                search,
                stack,
                StopRule { steps, error: search.error_of(share * self.enough) },
                self.progress,
            )
        };
        let begun: Result<Vec<FitStack>, Diagnostic> =
            stacks.into_par_iter().map(|stack| turned(stack, 8, 0.5)).collect();
        best_of(begun?, self.width.beam)
            .into_par_iter()
            .map(|stack| turned(stack.point, 40, 0.2))
            .collect()
    }

    /// Stacks with one more layer, after descending.
    fn with_one_more(
        &self,
        search: &Search,
        layers: &[FitLayer],
        missing: &[f64],
    ) -> Result<Vec<FitStack>, Diagnostic> {
        if self.progress.is_stopped() {
            return Ok(Vec::new());
        }
        let lights = self.lights(missing);
        // Every light is tried at few pixels, and only the best descend at all pixels of the
        // search.
        let few = search.thinned(FEW_PIXELS);
        let below = few.taken_over(layers);
        let places = places(layers.len(), search);
        let tried = |lit: &LayerLight| {
            if self.progress.is_stopped() {
                return None;
            }
            let tone = few.tone(lit);
            let mut best: Option<FitStack> = None;
            for &(place, mode) in &places {
                let mut point = below.clone();
                point.insert(place, FitLayer { lit: *lit, mode, tone: tone.clone() });
                let error = few.error(&point);
                if best.as_ref().is_none_or(|best| error < best.error) {
                    best = Some(Minimum { point, error });
                }
            }
            best.map(|best| (*lit, best))
        };
        let mut found: Vec<(LayerLight, FitStack)> = lights.par_iter().filter_map(tried).collect();
        found.sort_by(|a, b| a.1.error.total_cmp(&b.1.error));
        let begun = apart(found, self.width.beginnings)
            .into_iter()
            .map(|stack| search.taken_over(&stack.point));
        self.downhill(search, begun.collect())
    }

    /// Lights to try: from everywhere, and from where most is missing.
    fn lights(&self, missing: &[f64]) -> Vec<LayerLight> {
        let mut order: Vec<usize> = (0..missing.len()).collect();
        order.sort_by(|&a, &b| missing[b].total_cmp(&missing[a]).then(a.cmp(&b)));
        let mut lights = Vec::new();
        for (which, kind) in LightingModel::ALL.into_iter().enumerate() {
            let mut directions = even_directions(self.width.lights);
            let mut told: Vec<DVec3> = Vec::new();
            for &pixel in order.iter().take(order.len() / 4 + 1) {
                let direction = self.surface[pixel][which];
                if told.len() < TELLING && told.iter().all(|other| other.dot(direction) < 0.97) {
                    told.push(direction);
                }
            }
            directions.extend(told);
            for direction in directions {
                lights.extend(SHAPES.map(|ends| LayerLight {
                    kind,
                    direction,
                    shape: ProfileShape::new(ends.map(f64::to_radians)),
                }));
            }
        }
        lights
    }
}

/// Distance of each pixel from its goal.
fn missing(whole: &Search, layers: &[FitLayer]) -> Vec<f64> {
    let misses = whole.misses(&whole.taken_over(layers));
    misses.chunks_exact(3).map(|miss| miss.iter().map(|x| x * x).sum::<f64>().sqrt()).collect()
}

/// Places in the stack and modes for a layer among `count` others. To add to the base is to cover
/// it, unless the sum is cut off at white.
fn places(count: usize, search: &Search) -> Vec<(usize, BlendMode)> {
    let at = |place: usize| {
        let is_the_same = place == 0 && !search.is_cut_off();
        let modes: &[BlendMode] =
            if is_the_same { &[BlendMode::Alpha] } else { &[BlendMode::Alpha, BlendMode::Add] };
        modes.iter().map(move |mode| (place, *mode))
    };
    (0..=count).flat_map(at).collect()
}
