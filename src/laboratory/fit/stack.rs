//! Stacks of light layers, one over the other, whose best colors are known for any tones.
//!
//! A layer mixes its color over what is below by its tone, or adds it; so the picture is a sum of
//! the colors of base and layers, each multiplied by a factor made of tones. For given tones the
//! best colors are a small linear least squares problem within 0 and 1 for each channel.

use std::sync::Arc;

use glam::DVec3;

use super::choose::evenly;
use super::lit::{LayerLight, LightingModel};
use super::solve::{LeastSquares, solve_in_place};
use super::target::PixelGoal;
use crate::diag::Diagnostic;

/// Largest number of layers.
pub(super) const MAX_LAYERS: usize = 7;
/// Largest number of colors: base and layers.
const MOST: usize = MAX_LAYERS + 1;
/// Channel value from which a goal may be meant brighter.
const SATURATED: f64 = 0.998;

/// Mode of a layer over what is below.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BlendMode {
    Alpha,
    Add,
}

impl BlendMode {
    /// Word for the mode in documents.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Alpha => "alpha",
            Self::Add => "add",
        }
    }
}

/// A layer with its tone at the pixels of a search.
#[derive(Clone, Debug)]
pub(super) struct FitLayer {
    pub(super) lit: LayerLight,
    pub(super) mode: BlendMode,
    pub(super) tone: Arc<[f64]>,
}

/// A search for layers at some of the painted pixels.
#[derive(Debug)]
pub(super) struct Search {
    /// The normal and the mirrored view at each pixel.
    surface: Vec<[DVec3; 2]>,
    goals: Vec<PixelGoal>,
    /// Error that a hard profile counts as, as an RMS of a channel.
    soft: f64,
}

impl Search {
    /// A search at the indices `chosen` among all pixels.
    pub(super) fn new(surface: &[[DVec3; 2]], goals: &[PixelGoal], chosen: &[usize]) -> Self {
        let surface = chosen.iter().map(|&index| surface[index]).collect();
        Self { surface, goals: chosen.iter().map(|&index| goals[index]).collect(), soft: 0.0 }
    }

    /// The search with a preference for broad profiles where that costs less than `soft`, an RMS of
    /// a channel.
    #[must_use]
    pub(super) fn softly(self, soft: f64) -> Self {
        Self { soft, ..self }
    }

    /// The search at no more than `most` of its pixels.
    pub(super) fn thinned(&self, most: usize) -> Self {
        Self::new(&self.surface, &self.goals, &evenly(self.goals.len(), most)).softly(self.soft)
    }

    /// True if a goal is as bright as a channel can be, so that sums may have been cut off.
    pub(super) fn is_cut_off(&self) -> bool {
        self.goals.iter().any(|goal| goal.color.iter().any(|channel| *channel >= SATURATED))
    }

    /// The tone of a layer at each pixel.
    pub(super) fn tone(&self, lit: &LayerLight) -> Arc<[f64]> {
        let which = match lit.kind {
            LightingModel::Diffuse => 0,
            LightingModel::Specular => 1,
        };
        let tone = lit.tone();
        self.surface.iter().map(|directions| tone(directions[which])).collect()
    }

    /// The layers with their tones at this search's pixels.
    pub(super) fn taken_over(&self, layers: &[FitLayer]) -> Vec<FitLayer> {
        layers
            .iter()
            .map(|layer| FitLayer { tone: self.tone(&layer.lit), ..layer.clone() })
            .collect()
    }

    /// The sum of squared residuals that corresponds to an RMS of `enough` in a channel.
    pub(super) fn error_of(&self, enough: f64) -> f64 {
        3.0 * enough * enough * self.goals.iter().map(|goal| goal.weight).sum::<f64>()
    }

    /// The best colors of base and layers, straight RGB, from the base up.
    pub(super) fn colors(&self, layers: &[FitLayer]) -> Vec<[f64; 3]> {
        let count = layers.len() + 1;
        let mut sums = [Sums::default(); 3];
        let adds = layers.iter().any(|layer| layer.mode == BlendMode::Add);
        for (index, goal) in self.goals.iter().enumerate() {
            let factors = factors(layers, index);
            for (channel, sums) in sums.iter_mut().enumerate() {
                // A sum that is cut off at white says nothing about its parts.
                if !(adds && goal.color[channel] >= SATURATED) {
                    sums.add(&factors[..count], goal.color[channel], goal.weight);
                }
            }
        }
        let channels = sums.map(|sums| sums.solve(count));
        (0..count).map(|part| channels.map(|channel| channel[part])).collect()
    }

    /// Weighted differences of each channel of each pixel, with the best colors.
    pub(super) fn misses(&self, layers: &[FitLayer]) -> Vec<f64> {
        let colors = self.colors(layers);
        let mut misses = Vec::with_capacity(3 * self.goals.len());
        for (index, goal) in self.goals.iter().enumerate() {
            let (factors, root) = (factors(layers, index), goal.weight.sqrt());
            for channel in 0..3 {
                let sum: f64 = colors
                    .iter()
                    .zip(&factors)
                    .map(|(color, factor)| color[channel] * factor)
                    .sum();
                misses.push(root * (sum.min(1.0) - goal.color[channel]));
            }
        }
        misses
    }

    /// The sum of the squared differences, with the error that hard profiles count as.
    pub(super) fn error(&self, layers: &[FitLayer]) -> f64 {
        let misses: f64 = self.misses(layers).iter().map(|miss| miss * miss).sum();
        misses + self.hardness(layers).iter().map(|hard| hard * hard).sum::<f64>()
    }

    /// Error that each profile's hardness counts as; empty if the search has no preference for soft
    /// ones.
    fn hardness(&self, layers: &[FitLayer]) -> Vec<f64> {
        if self.soft <= 0.0 {
            return Vec::new();
        }
        let root = self.error_of(self.soft).sqrt();
        layers.iter().map(|layer| root * layer.lit.shape.hardness()).collect()
    }
}

/// Factors of the colors of base and layers at a pixel.
fn factors(layers: &[FitLayer], pixel: usize) -> [f64; MOST] {
    let mut factors = [0.0; MOST];
    factors[0] = 1.0;
    for (part, layer) in layers.iter().enumerate() {
        let tone = layer.tone[pixel];
        if layer.mode == BlendMode::Alpha {
            factors[..=part].iter_mut().for_each(|factor| *factor *= 1.0 - tone);
        }
        factors[part + 1] = tone;
    }
    factors
}

/// The normal equations of one channel.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    products: [[f64; MOST]; MOST],
    right: [f64; MOST],
}

impl Sums {
    fn add(&mut self, factors: &[f64], wished: f64, weight: f64) {
        for (i, a) in factors.iter().enumerate() {
            let weighted = a * weight;
            self.right[i] += weighted * wished;
            for (product, b) in self.products[i].iter_mut().zip(&factors[..=i]) {
                *product += weighted * b;
            }
        }
    }

    /// The best colors within 0 and 1: those that would leave this range are held at its bounds,
    /// one after the other.
    fn solve(&self, count: usize) -> [f64; MOST] {
        let product = |i: usize, j: usize| self.products[i.max(j)][i.min(j)];
        let mut held: [Option<f64>; MOST] = [None; MOST];
        let mut best = [0.0; MOST];
        for _ in 0..=count {
            let free: Vec<usize> = (0..count).filter(|&i| held[i].is_none()).collect();
            let ridge = |i: usize, j: usize| if i == j { 1e-9 } else { 0.0 };
            let mut matrix: Vec<Vec<f64>> = free
                .iter()
                .map(|&i| free.iter().map(|&j| product(i, j) + ridge(i, j)).collect())
                .collect();
            let known = |i: usize| -> f64 {
                (0..count).filter_map(|j| Some(product(i, j) * held[j]?)).sum()
            };
            let mut right: Vec<f64> = free.iter().map(|&i| self.right[i] - known(i)).collect();
            solve_in_place(&mut matrix, &mut right);
            best = held.map(|value| value.unwrap_or(0.0));
            free.iter().zip(&right).for_each(|(&i, value)| best[i] = *value);
            let beyond = |i: &usize| (best[*i] - best[*i].clamp(0.0, 1.0)).abs();
            let Some(worst) = free.into_iter().max_by(|a, b| beyond(a).total_cmp(&beyond(b)))
            else {
                break;
            };
            if beyond(&worst) < 1e-12 {
                break;
            }
            held[worst] = Some(best[worst].clamp(0.0, 1.0));
        }
        best
    }
}

impl LeastSquares for Search {
    type Point = Vec<FitLayer>;

    fn room(&self, layers: &Vec<FitLayer>) -> Vec<[f64; 2]> {
        layers.iter().flat_map(|layer| layer.lit.room()).collect()
    }

    fn moved(&self, layers: &Vec<FitLayer>, by: &[f64]) -> Result<Vec<FitLayer>, Diagnostic> {
        let step = |(layer, by): (&FitLayer, &[f64])| {
            if by.iter().all(|x| *x == 0.0) {
                return layer.clone();
            }
            let lit = layer.lit.moved(by);
            FitLayer { lit, mode: layer.mode, tone: self.tone(&lit) }
        };
        Ok(layers.iter().zip(by.chunks(5)).map(step).collect())
    }

    fn patience(&self) -> usize {
        0
    }

    fn residuals(&self, layers: &Vec<FitLayer>) -> Result<Vec<f64>, Diagnostic> {
        let mut residuals = self.misses(layers);
        residuals.extend(self.hardness(layers));
        Ok(residuals)
    }
}
