//! Fit of light layers over the look as it is: each lies where it was painted, with a light of its
//! own, and nothing else of the look changes.
//!
//! The picture of the look is the ground, which stays: its pixels count four times as much as the
//! painted ones, but for those close to a stroke. Over it one layer after another is searched for,
//! whose color is known at once for any light and profile, as the picture is linear in it. Lights
//! are tried from where strokes lie (their normals, or what a mirror shows there), and the best few
//! descend. A layer that hardly helps is not laid.
//!
//! The reference draws the picture three times, for the ground, the surface and the result: that
//! bounds the time, not the search, which evaluates the profile's formula.

use std::collections::HashMap;

use glam::DVec3;

use super::build::{APART, name_of, values_of};
use super::choose::{SurfaceSamples, evenly, pixels_of, thinned, wearing};
use super::lit::{LayerLight, LightingModel};
use super::model::FitShot;
use super::report::{FitReport, compared_as_is, painted};
use super::rest::UnpaintedPixels;
use super::solve::{LeastSquares, Minimum, StopRule, descend};
use super::state::ProfileShape;
use super::target::{FitTarget, PixelGoal};
use super::{FitOptions, FittedLook};
use crate::diag::Diagnostic;
use crate::document::{ColorSpace, Edit, Endpoint, Light, Look, Node, Wire, srgb_to_linear};
use crate::frame::Setup;
use crate::ids::{LightId, NodeId, make_slug};
use crate::library::Library;
use crate::progress::Progress;

/// Largest number of layers that are laid over the look.
const MOST_LAYERS: usize = 3;
/// Largest number of pixels that every light is tried at.
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
/// Number of beginnings that descend.
const DESCENDING: usize = 6;
/// Error that a hard profile counts as, as an RMS of a channel.
const SOFT: f64 = 2.0 / 255.0;
/// Share of the squared error that a layer has to take away.
const LEAST_GAIN: f64 = 0.08;

/// Lays light layers over look number `look` of `setup` so that it shows the goals of `target`
/// where they were painted, and stays as it is elsewhere. The given look comes back where no layer
/// brings it nearer.
///
/// # Errors
/// `fit-target` if no painted pixel can be compared; `fit-output` for a look whose output has no
/// color; problems of the setup.
pub fn fit_local(
    setup: &Setup,
    look: usize,
    library: &Library,
    target: &FitTarget,
    options: &FitOptions,
    progress: &Progress,
) -> Result<FittedLook, Vec<Diagnostic>> {
    let given_look = &setup.looks[look].look;
    let Some(top) = top_of(given_look) else {
        let problem = Diagnostic::error("fit-output", "nothing is wired into the look's output");
        return Err(vec![
            problem.hint("wire a color into it: light is painted over what it shows"),
        ]);
    };
    progress.begin(MOST_LAYERS as u64 + 2);
    let shot = FitShot { setup, look, library, size: target.size, time: options.time };
    let rest = UnpaintedPixels::new(&shot, target, 1.0)?;
    let mut given = thinned(target);
    given.extend(rest.goals);
    let before = compared_as_is(&shot, &given)?;
    let surface = SurfaceSamples::new(&shot, &pixels_of(&given))?;
    progress.add(1);
    let is_linear = given_look.color_space == ColorSpace::Linear;
    let own = |color: [f64; 3]| if is_linear { color.map(srgb_to_linear) } else { color };
    let directions: HashMap<[u32; 2], [DVec3; 2]> =
        surface.pixels.iter().copied().zip(surface.directions).collect();
    let mut samples: Vec<PaintedSample> = before
        .iter()
        .filter_map(|one| {
            let goal = one.goal();
            let directions = *directions.get(&goal.pixel)?;
            let goal = PixelGoal { color: own(goal.color), ..goal };
            Some(PaintedSample { directions, below: own(one.missed.shown), goal })
        })
        .collect();
    let mut layers: Vec<(LayerLight, [f64; 3])> = Vec::new();
    for _ in 0..MOST_LAYERS {
        let before = error(&samples);
        let found = next_layer(&samples, progress).map_err(|one| vec![one])?;
        progress.add(1);
        let Some(lit) = found else { break };
        let color = color_of(&samples, &lit);
        let covered: Vec<PaintedSample> =
            samples.iter().map(|sample| sample.covered(&lit, color)).collect();
        if error(&covered) > (1.0 - LEAST_GAIN) * before || progress.is_stopped() {
            break;
        }
        samples = covered;
        layers.push((lit, color));
    }
    let mut fitted = laid_over(given_look, &top, &layers, setup);
    let worn = wearing(&shot, fitted.clone());
    let mut after = compared_as_is(&FitShot { setup: &worn, ..shot }, &given)?;
    progress.add(1);
    let mut report = FitReport::new(&shot, &fitted, target, &before, &after, options)?;
    // The formula is not the shader: what the reference sees decides.
    if report.after >= report.before {
        fitted = given_look.clone();
        after.clone_from(&before);
        report = FitReport::new(&shot, &fitted, target, &before, &after, options)?;
    }
    let report = FitReport { is_stopped: progress.is_stopped(), ..report };
    let misses = painted(&after);
    let edit = Edit::Replace { look: Box::new(fitted.clone()) };
    Ok(FittedLook { look: fitted, edit, report, misses })
}

/// Node of the output, and the wire that ends at its color.
struct LookTop {
    output: NodeId,
    wire: usize,
}

fn top_of(look: &Look) -> Option<LookTop> {
    let (output, _) = look.graph.nodes.iter().find(|(_, node)| node.kind == "output")?;
    let wires = &look.graph.wires;
    let wire = wires.iter().position(|wire| wire.to == Endpoint::new(output.as_str(), "color"))?;
    Some(LookTop { output: output.clone(), wire })
}

/// The look with layers between what it shows and its output, each with a light of its own.
fn laid_over(look: &Look, top: &LookTop, layers: &[(LayerLight, [f64; 3])], setup: &Setup) -> Look {
    let mut new = look.clone();
    let to_frame = setup.illumination().inverse();
    let mut place = look.graph.nodes[&top.output].position;
    for (lit, color) in layers {
        let name = name_of(lit.kind, new.graph.nodes.values().map(|node| node.name.as_str()));
        let light = make_slug("painted light", |id| new.lights.contains_key(id));
        let direction = (to_frame * lit.direction).normalize_or(DVec3::Z).to_array();
        let own = Light { name: name.clone(), direction, ..Light::default() };
        new.lights.insert(LightId::new(light.as_str()), own);
        let id = make_slug("painted light", |id| new.graph.nodes.contains_key(id));
        let values = values_of(lit, &light, *color, "alpha");
        let kind = "light_layer".to_owned();
        let node = Node { kind, name, position: place, values, ..Node::default() };
        new.graph.nodes.insert(NodeId::new(id.as_str()), node);
        let from = std::mem::replace(
            &mut new.graph.wires[top.wire].from,
            Endpoint::new(id.as_str(), "below"),
        );
        new.graph.wires.push(Wire { from, to: Endpoint::new(id.as_str(), "below") });
        place[0] += APART;
    }
    new.graph.nodes[&top.output].position = place;
    new
}

/// A pixel with its surface, the color below the next layer, and its goal; colors are in the look's
/// space.
#[derive(Clone, Copy, Debug)]
struct PaintedSample {
    /// The normal and the mirrored view.
    directions: [DVec3; 2],
    below: [f64; 3],
    goal: PixelGoal,
}

impl PaintedSample {
    fn tone(&self, lit: &LayerLight) -> f64 {
        lit.tone(self.directions[usize::from(lit.kind == LightingModel::Specular)])
    }

    /// The sample with a layer over it.
    fn covered(&self, lit: &LayerLight, color: [f64; 3]) -> Self {
        let tone = self.tone(lit);
        let below = std::array::from_fn(|c| self.below[c] + tone * (color[c] - self.below[c]));
        Self { below, ..*self }
    }

    /// Weighted difference from the goal in each channel.
    fn misses(&self) -> [f64; 3] {
        let root = self.goal.weight.sqrt();
        std::array::from_fn(|c| root * (self.below[c] - self.goal.color[c]))
    }
}

/// The sum of the squared differences.
fn error(samples: &[PaintedSample]) -> f64 {
    samples.iter().flat_map(PaintedSample::misses).map(|miss| miss * miss).sum()
}

/// The color of a layer that brings the samples nearest to their goals, straight, in the look's
/// space: for a tone t over b the picture is b + t (c - b), linear in c.
fn color_of(samples: &[PaintedSample], lit: &LayerLight) -> [f64; 3] {
    let (mut sums, mut squares) = ([0.0; 3], 0.0);
    for sample in samples {
        let tone = sample.tone(lit);
        let PixelGoal { color, weight, .. } = sample.goal;
        squares += weight * tone * tone;
        for c in 0..3 {
            sums[c] += weight * tone * (color[c] - sample.below[c] * (1.0 - tone));
        }
    }
    sums.map(|sum| (sum / squares.max(1e-12)).clamp(0.0, 1.0))
}

/// The light and the profile of the next layer; `None` where nothing helps.
fn next_layer(
    samples: &[PaintedSample],
    progress: &Progress,
) -> Result<Option<LayerLight>, Diagnostic> {
    // Painted pixels and the rest are thinned each for itself, so that a small stroke is not lost.
    let (rest, strokes): (Vec<&PaintedSample>, Vec<&PaintedSample>) =
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
    let before = error(&thin);
    let at = |lit: &LayerLight, samples: &[PaintedSample]| {
        let color = color_of(samples, lit);
        let covered = samples.iter().map(|sample| sample.covered(lit, color));
        covered.flat_map(|sample| sample.misses()).map(|miss| miss * miss).sum::<f64>()
    };
    let mut tried: Vec<(f64, LayerLight)> = beginnings(&strokes)
        .into_iter()
        .map(|lit| (at(&lit, &thin), lit))
        .filter(|(error, _)| *error < before)
        .collect();
    tried.sort_by(|a, b| a.0.total_cmp(&b.0));
    let problem = LocalProblem { samples, soft: SOFT };
    let mut best: Option<Minimum<LayerLight>> = None;
    for (_, lit) in tried.into_iter().take(DESCENDING) {
        let until = StopRule { steps: 40, error: 0.0 };
        let found = descend(&problem, lit, until, progress)?;
        if best.as_ref().is_none_or(|best| found.error < best.error) {
            best = Some(found);
        }
    }
    Ok(best.map(|best| best.point))
}

/// Lights and profiles to begin from: toward where most is missing among the strokes.
fn beginnings(strokes: &[&PaintedSample]) -> Vec<LayerLight> {
    let missed = |sample: &PaintedSample| sample.misses().iter().map(|x| x * x).sum::<f64>();
    let mut order: Vec<&&PaintedSample> = strokes.iter().collect();
    order.sort_by(|a, b| missed(b).total_cmp(&missed(a)));
    let middle = |which: usize| -> DVec3 {
        order.iter().map(|sample| sample.directions[which] * missed(sample)).sum()
    };
    let mut lights = Vec::new();
    for (which, kind) in LightingModel::ALL.into_iter().enumerate() {
        let mut directions: Vec<DVec3> = middle(which).try_normalize().into_iter().collect();
        for sample in &order {
            let direction = sample.directions[which];
            if directions.len() < MOST_LIGHTS
                && directions.iter().all(|other| other.dot(direction) < ALIKE)
            {
                directions.push(direction);
            }
        }
        for direction in directions {
            lights.extend(SHAPES.map(|ends| {
                let shape = ProfileShape::new(ends.map(f64::to_radians));
                LayerLight { kind, direction, shape }
            }));
        }
    }
    lights
}

/// Distance from the goals with one layer in its best color, as a least squares problem.
struct LocalProblem<'a> {
    samples: &'a [PaintedSample],
    /// Error that a hard profile counts as, as an RMS of a channel.
    soft: f64,
}

impl LeastSquares for LocalProblem<'_> {
    type Point = LayerLight;

    fn room(&self, lit: &LayerLight) -> Vec<[f64; 2]> {
        lit.room()
    }

    fn moved(&self, lit: &LayerLight, by: &[f64]) -> Result<LayerLight, Diagnostic> {
        Ok(lit.moved(by))
    }

    fn patience(&self) -> usize {
        0
    }

    fn residuals(&self, lit: &LayerLight) -> Result<Vec<f64>, Diagnostic> {
        let color = color_of(self.samples, lit);
        let covered = self.samples.iter().map(|sample| sample.covered(lit, color));
        let mut residuals: Vec<f64> = covered.flat_map(|sample| sample.misses()).collect();
        let weight: f64 = self.samples.iter().map(|sample| sample.goal.weight).sum();
        residuals.push(self.soft * (3.0 * weight).sqrt() * lit.shape.hardness());
        Ok(residuals)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball of gray, painted white around a direction.
    fn ball(around: DVec3, within: f64) -> Vec<PaintedSample> {
        let even = super::super::state::even_directions(600);
        let sample = |direction: DVec3| {
            let is_painted = direction.dot(around) > within;
            let color = if is_painted { [1.0, 0.8, 0.6] } else { [0.4; 3] };
            let weight = if is_painted { 1.0 } else { 0.5 };
            let goal = PixelGoal { pixel: [0; 2], color, weight, is_rest: !is_painted };
            PaintedSample { directions: [direction; 2], below: [0.4; 3], goal }
        };
        even.into_iter().map(sample).collect()
    }

    #[test]
    fn a_layer_lies_where_it_was_painted_and_nowhere_else() {
        let around = DVec3::new(0.4, 0.7, 0.6).normalize();
        let samples = ball(around, 0.85);
        let lit = next_layer(&samples, &Progress::new()).unwrap().unwrap();
        assert!(lit.direction.angle_between(around) < 0.12, "{}", lit.direction);
        let color = color_of(&samples, &lit);
        for (c, wanted) in [1.0, 0.8, 0.6].into_iter().enumerate() {
            assert!((color[c] - wanted).abs() < 0.1, "{color:?}");
        }
        let covered: Vec<PaintedSample> =
            samples.iter().map(|sample| sample.covered(&lit, color)).collect();
        assert!(error(&covered) < 0.1 * error(&samples));
        let behind = covered.iter().filter(|sample| sample.directions[0].dot(around) < 0.3);
        for sample in behind {
            assert!(sample.misses().iter().all(|miss| miss.abs() < 1e-9), "the far side stays");
        }
    }

    #[test]
    fn nothing_is_laid_where_nothing_is_missing() {
        let samples: Vec<PaintedSample> = ball(DVec3::Z, 0.9)
            .into_iter()
            .map(|sample| PaintedSample { below: sample.goal.color, ..sample })
            .collect();
        assert!(next_layer(&samples, &Progress::new()).unwrap().is_none());
    }
}
