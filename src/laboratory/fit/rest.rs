//! Unpainted pixels: they stay as the look shows them, as far as the options ask for.
//!
//! Two strokes alone have all lights and colors of a look to themselves, and the look between them
//! could become anything. So pixels of the rest are given goals to stay as they are. All together
//! they count in proportion to the painted ones, however many either are; close to a stroke they
//! count less, for light that falls on a place spreads around it.

use std::collections::HashSet;

use super::choose::evenly;
use super::model::{FitShot, Model};
use super::target::{FitTarget, PixelGoal};
use crate::diag::Diagnostic;

/// Number of unpainted pixels that are given goals.
const MOST: usize = 768;
/// Number of pixels of a picture that they are chosen from.
const MOST_SEEN: usize = 65_536;
/// Share by which a change is held back that moves painted pixels and a fully kept rest alike.
const WHOLLY: f64 = 0.8;
/// Distance from a stroke beyond which the rest counts fully, in parts of the picture's height.
const REACH: f64 = 0.1;

/// Goals of the unpainted pixels.
#[derive(Clone, Debug, Default)]
pub(super) struct UnpaintedPixels {
    /// Goals of the pixels that are to stay: the colors that they show.
    pub(super) goals: Vec<PixelGoal>,
    /// Share of the object that was not painted, from 0 to 1.
    pub(super) share: f64,
}

impl UnpaintedPixels {
    /// The unpainted pixels of `target`, kept to the degree `kept`: 0 lets them go, 1 keeps them
    /// fully.
    ///
    /// # Errors
    /// Problems of the look, and shaders that the interpreter cannot run.
    pub(super) fn new(
        shot: &FitShot<'_>,
        target: &FitTarget,
        kept: f64,
    ) -> Result<Self, Vec<Diagnostic>> {
        let model = Model::new(shot, Vec::new(), &seen_of(target.size).collect())?;
        Self::of(&model, target, kept)
    }

    /// The unpainted pixels among those of a model of the look: see [`new`](Self::new).
    ///
    /// # Errors
    /// Shaders that the interpreter cannot run.
    pub(super) fn of(
        model: &Model,
        target: &FitTarget,
        kept: f64,
    ) -> Result<Self, Vec<Diagnostic>> {
        let painted: HashSet<[u32; 2]> = target.goals.iter().map(|goal| goal.pixel).collect();
        let free: Vec<usize> = (0..model.pixels.len())
            .filter(|&place| !painted.contains(&model.pixels[place]))
            .collect();
        let share = free.len() as f64 / model.pixels.len().max(1) as f64;
        if kept <= 0.0 || free.is_empty() {
            return Ok(Self { goals: Vec::new(), share });
        }
        let chosen: Vec<usize> =
            evenly(free.len(), MOST).into_iter().map(|index| free[index]).collect();
        let colors = model.colors(&model.sheet(&chosen), &[]).map_err(|one| vec![one])?;
        let weighed = |(place, color): (&usize, [f64; 3])| {
            let pixel = model.pixels[*place];
            PixelGoal { pixel, color, weight: away(pixel, target), is_rest: true }
        };
        let mut goals: Vec<PixelGoal> =
            chosen.iter().zip(colors).map(weighed).filter(|goal| goal.weight > 0.0).collect();
        let sum = |goals: &[PixelGoal]| goals.iter().map(|goal| goal.weight).sum::<f64>();
        let each = share_of(kept) * sum(&target.goals) / sum(&goals).max(1e-9);
        goals.iter_mut().for_each(|goal| goal.weight *= each);
        Ok(Self { goals, share })
    }
}

/// The pixels of a picture that unpainted ones are chosen from, evenly spread.
pub(super) fn seen_of([width, height]: [u32; 2]) -> impl Iterator<Item = [u32; 2]> {
    let stride = (f64::from(width) * f64::from(height) / MOST_SEEN as f64).sqrt().ceil().max(1.0);
    let seen = move |side: u32| (0..side).step_by(stride as usize);
    seen(height).flat_map(move |y| seen(width).map(move |x| [x, y]))
}

/// Distance of a pixel from all strokes: 0 beside a stroke, 1 beyond the strokes' reach.
fn away([x, y]: [u32; 2], target: &FitTarget) -> f64 {
    let reach = REACH * f64::from(target.size[1]);
    let squared = |goal: &PixelGoal| {
        let [across, down] =
            [f64::from(goal.pixel[0]) - f64::from(x), f64::from(goal.pixel[1]) - f64::from(y)];
        across * across + down * down
    };
    let nearest = target.goals.iter().map(squared).fold(f64::INFINITY, f64::min).sqrt();
    let part = (nearest / reach.max(1.0)).min(1.0);
    // A smooth step, so that the weight of the rest has no visible edge.
    part * part * (3.0 - 2.0 * part)
}

/// Weight of the rest against the painted pixels, all together. If all of a look moves as one, each
/// step of `kept` then moves its optimum toward the rest by an equal share of the way.
fn share_of(kept: f64) -> f64 {
    let held = WHOLLY * kept.clamp(0.0, 1.0);
    held / (1.0 - held)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A value `x` that moves strokes and rest alike, with the goals 1 and 0: the minimum of (1 -
    /// x)^2 + s x^2.
    #[test]
    fn every_step_holds_an_even_share() {
        for step in 0..=10 {
            let kept = f64::from(step) / 10.0;
            let moved = 1.0 / (1.0 + share_of(kept));
            assert!((moved - (1.0 - WHOLLY * kept)).abs() < 1e-12, "{kept}: {moved}");
        }
    }

    #[test]
    fn the_rest_counts_from_a_distance_on() {
        let goal = PixelGoal { pixel: [10, 50], color: [0.5; 3], weight: 1.0, is_rest: false };
        let target = FitTarget { size: [100, 100], goals: vec![goal] };
        let at = |x: u32| away([x, 50], &target);
        assert!(at(11) < 0.05 && (at(15) - 0.5).abs() < 1e-12 && at(20) == 1.0 && at(90) == 1.0);
    }
}
