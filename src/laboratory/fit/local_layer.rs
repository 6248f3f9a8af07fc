//! Search for one layer over a picture that is there: its light, its profile and the place that it
//! is confined to.
//!
//! The color of a layer is known at once for any light, profile and place, as the picture is linear
//! in it. Beginnings come from where strokes lie: lights toward their normals, or what a mirror
//! shows there, and places around them. The best few of either kind descend. A search whose layer
//! moves the rest too far goes on with a heavier rest.

use glam::DVec3;

use super::choose::evenly;
use super::lit::{LayerLight, LightingModel};
use super::place::LayerPlace;
use super::solve::{LeastSquares, Minimum, StopRule, descend};
use super::state::ProfileShape;
use super::target::PixelGoal;
use crate::diag::Diagnostic;
use crate::progress::Progress;

/// Largest number of pixels that beginnings are tried at, and descend.
const FEW_PIXELS: usize = 400;
/// Largest number of directions that lights are tried from, for each lighting model.
const MOST_LIGHTS: usize = 24;
/// Cosine from which two directions are the same to begin with.
const ALIKE: f64 = 0.97;
/// Profiles that a search begins with: offset, fall-off and cut-off, in degrees.
const SHAPES: [[f64; 3]; 6] = [
    [0.0, 12.0, 25.0],
    [0.0, 30.0, 55.0],
    [10.0, 20.0, 35.0],
    [20.0, 40.0, 60.0],
    [0.0, 55.0, 90.0],
    [40.0, 60.0, 90.0],
];
/// Profiles of a layer that a place confines already.
const BROAD_SHAPES: [[f64; 3]; 2] = [[20.0, 60.0, 90.0], [60.0, 100.0, 140.0]];
/// Largest number of places that are begun from.
const MOST_PLACES: usize = 6;
/// Radii of places, in parts of the distance that the strokes reach from their middle.
const RADII: [f64; 5] = [0.2, 0.35, 0.6, 1.0, 1.5];
/// Hardness that a place begins with.
const HARDNESS: f64 = 0.3;
/// Number of beginnings of either kind that descend at few pixels.
const DESCENDING: usize = 4;
/// Number of those whose descent goes on at all pixels.
const GOING_ON: usize = 2;
/// Error that a hard profile counts as, as an RMS of a channel.
const SOFT: f64 = 2.0 / 255.0;
/// RMS of a channel that the rest may be moved by, by all layers together, however much is painted.
const REST_MOVED: f64 = 6.0 / 255.0;
/// Factors of the rest's weight that are tried, until it stays.
const HEAVIER: [f64; 3] = [1.0, 6.0, 36.0];

/// A layer that is laid over a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LocalLayer {
    pub(super) lit: LayerLight,
    /// Place that the layer is confined to; `None` for a layer on all of the object.
    pub(super) place: Option<LayerPlace>,
}

impl LocalLayer {
    /// The tone at each of some samples.
    fn tones(&self, samples: &[PaintedSample]) -> Vec<f64> {
        let which = usize::from(self.lit.kind == LightingModel::Specular);
        let lit = self.lit.tone();
        let tone = |sample: &PaintedSample| {
            let weight = self.place.map_or(1.0, |place| place.weight(sample.position));
            if weight > 0.0 { weight * lit(sample.directions[which]) } else { 0.0 }
        };
        samples.iter().map(tone).collect()
    }

    fn moved(&self, by: &[f64]) -> Self {
        let (lit, place) = by.split_at(5);
        Self { lit: self.lit.moved(lit), place: self.place.map(|own| own.moved(place)) }
    }
}

/// A layer with its color, and the picture that it makes.
#[derive(Clone, Debug)]
pub(super) struct LaidLayer {
    pub(super) layer: LocalLayer,
    /// Straight RGB, in the look's space.
    pub(super) color: [f64; 3],
    /// The samples with the layer over them.
    pub(super) samples: Vec<PaintedSample>,
}

/// A pixel with its surface, the color below the next layer, and its goal; colors are in the look's
/// space.
#[derive(Clone, Copy, Debug)]
pub(super) struct PaintedSample {
    /// The normal and the mirrored view.
    pub(super) directions: [DVec3; 2],
    /// Position in the object's own space.
    pub(super) position: DVec3,
    pub(super) below: [f64; 3],
    pub(super) goal: PixelGoal,
}

impl PaintedSample {
    /// The sample with a color of a tone over it.
    fn covered(&self, tone: f64, color: [f64; 3]) -> Self {
        let below = std::array::from_fn(|c| self.below[c] + tone * (color[c] - self.below[c]));
        Self { below, ..*self }
    }

    /// The sample with another weight, if it is of the rest.
    fn held(self, by: f64) -> Self {
        let weight = if self.goal.is_rest { by * self.goal.weight } else { self.goal.weight };
        Self { goal: PixelGoal { weight, ..self.goal }, ..self }
    }

    /// Difference from the goal in each channel.
    fn missing(&self) -> DVec3 {
        DVec3::from(self.goal.color) - DVec3::from(self.below)
    }

    /// Weighted square of the difference from the goal.
    fn squared(&self) -> f64 {
        self.goal.weight * self.missing().length_squared()
    }
}

/// The sum of the squared differences.
pub(super) fn error(samples: &[PaintedSample]) -> f64 {
    samples.iter().map(PaintedSample::squared).sum()
}

/// RMS of a channel by which the rest is off, from 0 to 1.
pub(super) fn rest_moved(samples: &[PaintedSample]) -> f64 {
    let rest = samples.iter().filter(|sample| sample.goal.is_rest);
    let (sum, weight) = rest.fold((0.0, 0.0), |(sum, weight), sample| {
        (sum + sample.squared(), weight + sample.goal.weight)
    });
    (sum / (3.0 * weight).max(1e-12)).sqrt()
}

/// The samples with a layer over them, in the color that brings them nearest to their goals, and
/// that color, straight, in the look's space: for a tone t over b the picture is b + t (c - b),
/// linear in c.
fn covered<'s>(
    samples: &'s [PaintedSample],
    layer: &LocalLayer,
) -> ([f64; 3], impl Iterator<Item = PaintedSample> + use<'s>) {
    let tones = layer.tones(samples);
    let (mut sums, mut squares) = ([0.0; 3], 0.0);
    for (sample, tone) in samples.iter().zip(&tones) {
        let PixelGoal { color, weight, .. } = sample.goal;
        squares += weight * tone * tone;
        for c in 0..3 {
            sums[c] += weight * tone * (color[c] - sample.below[c] * (1.0 - tone));
        }
    }
    let color = sums.map(|sum| (sum / squares.max(1e-12)).clamp(0.0, 1.0));
    (color, samples.iter().zip(tones).map(move |(sample, tone)| sample.covered(tone, color)))
}

/// The next layer over the samples; `None` where nothing helps, or where
/// whatever helps moves the rest too far.
///
/// # Errors
/// None of its own: those of the descent.
pub(super) fn next_layer(
    samples: &[PaintedSample],
    progress: &Progress,
) -> Result<Option<LaidLayer>, Diagnostic> {
    for by in HEAVIER {
        let held: Vec<PaintedSample> = samples.iter().map(|sample| sample.held(by)).collect();
        let Some(layer) = nearest_layer(&held, progress)? else { return Ok(None) };
        let (color, covered) = covered(&held, &layer);
        let own = |(covered, sample): (PaintedSample, &PaintedSample)| PaintedSample {
            goal: sample.goal,
            ..covered
        };
        let covered: Vec<PaintedSample> = covered.zip(samples).map(own).collect();
        if rest_moved(&covered) <= REST_MOVED {
            return Ok(Some(LaidLayer { layer, color, samples: covered }));
        }
        if progress.is_stopped() {
            break;
        }
    }
    Ok(None)
}

/// The layer that brings the samples nearest to their goals; `None` where none helps.
fn nearest_layer(
    samples: &[PaintedSample],
    progress: &Progress,
) -> Result<Option<LocalLayer>, Diagnostic> {
    // Painted pixels and the rest are thinned each for itself, so that a small stroke is not lost.
    let (rest, mut strokes): (Vec<&PaintedSample>, Vec<&PaintedSample>) =
        samples.iter().partition(|sample| sample.goal.is_rest);
    let few = |of: &[&PaintedSample]| -> Vec<PaintedSample> {
        let chosen = evenly(of.len(), FEW_PIXELS / 2);
        let weight = of.len() as f64 / chosen.len().max(1) as f64;
        let heavier = |sample: &PaintedSample| {
            let goal = PixelGoal { weight: weight * sample.goal.weight, ..sample.goal };
            PaintedSample { goal, ..*sample }
        };
        chosen.into_iter().map(|index| heavier(of[index])).collect()
    };
    let thin = [few(&strokes), few(&rest)].concat();
    strokes.sort_by(|a, b| b.squared().total_cmp(&a.squared()));
    let before = error(&thin);
    let few = LocalProblem { samples: &thin, soft: SOFT };
    let until = StopRule { steps: 40, error: 0.0 };
    let mut found: Vec<Minimum<LocalLayer>> = Vec::new();
    // Layers on all of the object come first, and of equal ones the first stays.
    for begun in [layers_by_light(&strokes), layers_by_place(&strokes)] {
        let mut tried: Vec<(f64, LocalLayer)> = begun
            .into_iter()
            .map(|layer| (error_with(&thin, &layer), layer))
            .filter(|(error, _)| *error < before)
            .collect();
        tried.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, layer) in tried.into_iter().take(DESCENDING) {
            found.push(descend(&few, layer, until, progress)?);
        }
    }
    found.sort_by(|a, b| a.error.total_cmp(&b.error));
    let all = LocalProblem { samples, soft: SOFT };
    let mut best: Option<Minimum<LocalLayer>> = None;
    for near in found.into_iter().take(GOING_ON) {
        let far = descend(&all, near.point, until, progress)?;
        if best.as_ref().is_none_or(|best| far.error < best.error) {
            best = Some(far);
        }
    }
    Ok(best.map(|best| best.point))
}

/// The sum of the squared differences with a layer in its best color.
fn error_with(samples: &[PaintedSample], layer: &LocalLayer) -> f64 {
    covered(samples, layer).1.map(|sample| sample.squared()).sum()
}

/// Layers to begin from on all of the object: with lights toward where most is missing among the
/// strokes, which come in that order.
fn layers_by_light(strokes: &[&PaintedSample]) -> Vec<LocalLayer> {
    let mut layers = Vec::new();
    for (which, kind) in LightingModel::ALL.into_iter().enumerate() {
        let mut directions: Vec<DVec3> = middle(strokes, which).into_iter().collect();
        for sample in strokes {
            let direction = sample.directions[which];
            if directions.len() < MOST_LIGHTS
                && directions.iter().all(|other| other.dot(direction) < ALIKE)
            {
                directions.push(direction);
            }
        }
        for direction in directions {
            layers.extend(SHAPES.map(|ends| {
                let shape = ProfileShape::new(ends.map(f64::to_radians));
                LocalLayer { lit: LayerLight { kind, direction, shape }, place: None }
            }));
        }
    }
    layers
}

/// Layers to begin from that are confined to a place: around strokes that wish much the same, the
/// place where most is missing first.
fn layers_by_place(strokes: &[&PaintedSample]) -> Vec<LocalLayer> {
    let count = strokes.len().max(1) as f64;
    let middle_of = strokes.iter().map(|sample| sample.position).sum::<DVec3>() / count;
    let reach =
        strokes.iter().map(|sample| sample.position.distance(middle_of)).fold(0.0, f64::max);
    let mut seeds: Vec<&PaintedSample> = Vec::new();
    for sample in strokes {
        let is_apart =
            |seed: &&PaintedSample| seed.position.distance(sample.position) > RADII[1] * reach;
        if seeds.len() < MOST_PLACES && seeds.iter().all(is_apart) {
            seeds.push(sample);
        }
    }
    let mut layers = Vec::new();
    for (seed, radius) in seeds.iter().flat_map(|seed| RADII.map(|part| (*seed, part * reach))) {
        let near: Vec<&PaintedSample> = strokes
            .iter()
            .filter(|other| {
                other.position.distance(seed.position) <= radius
                    && other.missing().dot(seed.missing()) > 0.0
            })
            .copied()
            .collect();
        let Some(direction) = middle(&near, 0) else { continue };
        let weight: f64 = near.iter().map(|sample| sample.squared()).sum();
        let center = near.iter().map(|sample| sample.position * sample.squared()).sum::<DVec3>();
        let Some(place) = LayerPlace::new(center / weight.max(1e-300), 1.3 * radius, HARDNESS)
        else {
            continue;
        };
        layers.extend(BROAD_SHAPES.map(|ends| {
            let shape = ProfileShape::new(ends.map(f64::to_radians));
            let lit = LayerLight { kind: LightingModel::Diffuse, direction, shape };
            LocalLayer { lit, place: Some(place) }
        }));
    }
    layers
}

/// Direction of the surface in the middle of what is missing; `None` where that has none.
fn middle(strokes: &[&PaintedSample], which: usize) -> Option<DVec3> {
    let sum: DVec3 = strokes.iter().map(|sample| sample.directions[which] * sample.squared()).sum();
    sum.try_normalize()
}

/// Distance from the goals with one layer in its best color, as a least squares problem.
struct LocalProblem<'a> {
    samples: &'a [PaintedSample],
    /// Error that a hard profile counts as, as an RMS of a channel.
    soft: f64,
}

impl LeastSquares for LocalProblem<'_> {
    type Point = LocalLayer;

    fn room(&self, layer: &LocalLayer) -> Vec<[f64; 2]> {
        let mut room = layer.lit.room();
        room.extend(layer.place.iter().flat_map(LayerPlace::room));
        room
    }

    fn moved(&self, layer: &LocalLayer, by: &[f64]) -> Result<LocalLayer, Diagnostic> {
        Ok(layer.moved(by))
    }

    fn patience(&self) -> usize {
        0
    }

    fn residuals(&self, layer: &LocalLayer) -> Result<Vec<f64>, Diagnostic> {
        let (_, covered) = covered(self.samples, layer);
        let mut residuals: Vec<f64> = covered
            .flat_map(|sample| (sample.goal.weight.sqrt() * sample.missing()).to_array())
            .collect();
        let weight: f64 = self.samples.iter().map(|sample| sample.goal.weight).sum();
        residuals.push(self.soft * (3.0 * weight).sqrt() * layer.lit.shape.hardness());
        Ok(residuals)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Spots of a ball, each with a direction and the cosine that it extends to.
    type Spots<'a> = &'a [(DVec3, f64)];

    /// Gray balls beside each other, as many as `copies`, of which the first is painted at some
    /// spots.
    fn balls(spots: Spots<'_>, copies: usize) -> Vec<PaintedSample> {
        let even = super::super::state::even_directions(600);
        let sample = |(copy, direction): (usize, DVec3)| {
            let spot = |(around, within): &(DVec3, f64)| direction.dot(*around) > *within;
            let is_painted = copy == 0 && spots.iter().any(spot);
            let color = if is_painted { [1.0, 0.8, 0.6] } else { [0.4; 3] };
            let weight = if is_painted { 1.0 } else { 0.5 };
            let goal = PixelGoal { pixel: [0; 2], color, weight, is_rest: !is_painted };
            let position = direction + DVec3::X * 3.0 * copy as f64;
            PaintedSample { directions: [direction; 2], position, below: [0.4; 3], goal }
        };
        (0..copies).flat_map(|copy| even.iter().map(move |d| (copy, *d))).map(sample).collect()
    }

    fn around() -> DVec3 {
        DVec3::new(0.4, 0.7, 0.6).normalize()
    }

    /// The samples with up to three layers over them.
    fn lit(samples: Vec<PaintedSample>) -> (Vec<LocalLayer>, Vec<PaintedSample>) {
        let (mut samples, mut layers) = (samples, Vec::new());
        for _ in 0..3 {
            let Some(laid) = next_layer(&samples, &Progress::new()).unwrap() else { break };
            layers.push(laid.layer);
            samples = laid.samples;
        }
        (layers, samples)
    }

    #[test]
    fn a_layer_lies_where_it_was_painted_and_nowhere_else() {
        let samples = balls(&[(around(), 0.85)], 1);
        let LaidLayer { layer, color, samples: covered } =
            next_layer(&samples, &Progress::new()).unwrap().unwrap();
        for (c, wanted) in [1.0, 0.8, 0.6].into_iter().enumerate() {
            assert!((color[c] - wanted).abs() < 0.1, "{color:?}");
        }
        assert!(error(&covered) < 0.1 * error(&samples), "{layer:?}");
        let behind = covered.iter().filter(|sample| sample.directions[0].dot(around()) < 0.3);
        for sample in behind {
            assert!(sample.missing().abs().max_element() < 1e-9, "the far side stays");
        }
    }

    /// A light that falls on all of the object lights each ball alike.
    #[test]
    fn what_recurs_elsewhere_is_lit_at_its_own_place() {
        let samples = balls(&[(around(), 0.85)], 4);
        let LaidLayer { layer, samples: covered, .. } =
            next_layer(&samples, &Progress::new()).unwrap().unwrap();
        let place = layer.place.expect("it is confined");
        assert!(place.center.distance(around()) < 0.4, "{place:?}");
        assert!(error(&covered) < 0.15 * error(&samples), "{}", error(&covered) / error(&samples));
        for sample in covered.iter().filter(|sample| sample.position.x > 1.5) {
            assert!(sample.missing().abs().max_element() < 1e-9, "the other balls stay");
        }
    }

    #[test]
    fn nothing_is_laid_where_nothing_is_missing() {
        let samples: Vec<PaintedSample> = balls(&[(DVec3::Z, 0.9)], 1)
            .into_iter()
            .map(|sample| PaintedSample { below: sample.goal.color, ..sample })
            .collect();
        assert!(next_layer(&samples, &Progress::new()).unwrap().is_none());
    }

    /// The bound is of all that is unpainted, and of all layers together.
    #[test]
    fn more_strokes_move_the_rest_no_further_than_the_bound() {
        let spots: Vec<(DVec3, f64)> = super::super::state::even_directions(7)
            .into_iter()
            .enumerate()
            .map(|(index, direction)| (direction, 0.8 + 0.02 * index as f64))
            .collect();
        for count in [1, 3, 7] {
            let samples = balls(&spots[..count], 2);
            let before = error(&samples);
            let (layers, samples) = lit(samples);
            assert!(!layers.is_empty() && error(&samples) < before, "{count} strokes");
            assert!(rest_moved(&samples) <= REST_MOVED, "{count}: {}", rest_moved(&samples));
        }
    }
}
