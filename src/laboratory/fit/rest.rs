//! What nobody painted: it stays as the look shows it, as far as that is asked for.
//!
//! Two strokes have all lights and colors of a look for themselves, and what is between them
//! becomes what it will. So pixels of the rest wish to stay. All together they count in proportion
//! to what is painted, however large either is; close to a stroke they count less, for light that
//! falls on a place goes out around it.

use std::collections::HashSet;

use super::choose::evenly;
use super::model::{Model, Shot};
use super::target::{PixelGoal, Target};
use crate::diag::Diagnostic;

/// As many pixels tell of what was not painted.
const MOST: usize = 768;
/// Pixels of a picture that they are chosen from.
const MOST_SEEN: usize = 65_536;
/// Where the rest is kept wholly, something that moves it as much as what is painted is held back
/// by this part.
const WHOLLY: f64 = 0.8;
/// So far from a stroke the rest counts as much as it does anywhere, in parts of the picture's
/// height.
const REACH: f64 = 0.1;

/// What nobody painted.
#[derive(Clone, Debug, Default)]
pub(super) struct Rest {
    /// Pixels that are to stay, with what they show.
    pub(super) wishes: Vec<PixelGoal>,
    /// Of the object, the part that was not painted, from 0 to 1.
    pub(super) share: f64,
}

impl Rest {
    /// The rest of what `target` wishes, kept by so much: 0 lets it go, 1 keeps it wholly.
    ///
    /// # Errors
    /// What is wrong with the look, and what the interpreter cannot run.
    pub(super) fn new(
        shot: &Shot<'_>,
        target: &Target,
        kept: f64,
    ) -> Result<Self, Vec<Diagnostic>> {
        let [width, height] = target.size;
        let stride =
            (f64::from(width) * f64::from(height) / MOST_SEEN as f64).sqrt().ceil().max(1.0)
                as usize;
        let seen = |side: u32| (0..side).step_by(stride);
        let chosen: HashSet<[u32; 2]> =
            seen(height).flat_map(|y| seen(width).map(move |x| [x, y])).collect();
        let painted: HashSet<[u32; 2]> = target.wishes.iter().map(|wish| wish.pixel).collect();
        let model = Model::new(shot, Vec::new(), &chosen)?;
        let free: Vec<usize> = (0..model.pixels.len())
            .filter(|&place| !painted.contains(&model.pixels[place]))
            .collect();
        let share = free.len() as f64 / model.pixels.len().max(1) as f64;
        if kept <= 0.0 || free.is_empty() {
            return Ok(Self { wishes: Vec::new(), share });
        }
        let chosen: Vec<usize> =
            evenly(free.len(), MOST).into_iter().map(|index| free[index]).collect();
        let colors = model.colors(&model.sheet(&chosen), &[]).map_err(|one| vec![one])?;
        let weighed = |(place, color): (&usize, [f64; 3])| {
            let pixel = model.pixels[*place];
            PixelGoal { pixel, color, weight: away(pixel, target), is_rest: true }
        };
        let mut wishes: Vec<PixelGoal> =
            chosen.iter().zip(colors).map(weighed).filter(|wish| wish.weight > 0.0).collect();
        let sum = |wishes: &[PixelGoal]| wishes.iter().map(|wish| wish.weight).sum::<f64>();
        let each = share_of(kept) * sum(&target.wishes) / sum(&wishes).max(1e-9);
        wishes.iter_mut().for_each(|wish| wish.weight *= each);
        Ok(Self { wishes, share })
    }
}

/// How far a pixel is from all strokes: 0 beside one, 1 where it is none of their business.
fn away([x, y]: [u32; 2], target: &Target) -> f64 {
    let reach = REACH * f64::from(target.size[1]);
    let squared = |wish: &PixelGoal| {
        let [across, down] =
            [f64::from(wish.pixel[0]) - f64::from(x), f64::from(wish.pixel[1]) - f64::from(y)];
        across * across + down * down
    };
    let nearest = target.wishes.iter().map(squared).fold(f64::INFINITY, f64::min).sqrt();
    let part = (nearest / reach.max(1.0)).min(1.0);
    part * part * (3.0 - 2.0 * part)
}

/// How much the rest counts against what is painted, all together. Where all of a look moves as
/// one, its optimum is then nearer to the rest by an even share of the way with every step of
/// `kept`.
fn share_of(kept: f64) -> f64 {
    let held = WHOLLY * kept.clamp(0.0, 1.0);
    held / (1.0 - held)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Something that moves strokes and rest alike, of which strokes wish 1 and the rest 0: the
    /// least of (1 - x)^2 + s x^2.
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
        let wish = PixelGoal { pixel: [10, 50], color: [0.5; 3], weight: 1.0, is_rest: false };
        let target = Target { size: [100, 100], wishes: vec![wish] };
        let at = |x: u32| away([x, 50], &target);
        assert!(at(11) < 0.05 && (at(15) - 0.5).abs() < 1e-12 && at(20) == 1.0 && at(90) == 1.0);
    }
}
