//! The copies of a stroke around the tile's middle.

use glam::{DMat2, DVec2};

use super::brush::Symmetry;
use super::path;

/// Grid that sines are rounded to, so that they are the same on every machine, and quarter turns
/// exact.
const SINES: f64 = 1.0 / 1_099_511_627_776.0;

/// A copy of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StrokeCopy {
    middle: DVec2,
    /// Turn and mirror image about the middle; the inverse is the transpose.
    pub(super) turn: DMat2,
}

impl StrokeCopy {
    /// The position of the copy while the pen is at `at`.
    pub(super) fn place(&self, at: DVec2) -> DVec2 {
        path::settled(self.middle + self.turn * (at - self.middle))
    }
}

/// All copies that differ, the stroke itself first.
pub(super) fn copies(symmetry: &Symmetry, size: [u32; 2]) -> Vec<StrokeCopy> {
    let middle = DVec2::from(size.map(f64::from)) / 2.0;
    let turns = symmetry.turns.clamp(1, Symmetry::MAX_TURNS);
    let flips = |is_on: bool| if is_on { &[1.0, -1.0][..] } else { &[1.0] };
    let mut copies: Vec<StrokeCopy> = Vec::new();
    for turn in 0..turns {
        let angle = std::f64::consts::TAU * f64::from(turn) / f64::from(turns);
        let [sine, cosine] =
            [angle.sin(), angle.cos()].map(|number| (number / SINES).round() * SINES);
        let turned = DMat2::from_cols(DVec2::new(cosine, sine), DVec2::new(-sine, cosine));
        for (&u, &v) in flips(symmetry.across_u)
            .iter()
            .flat_map(|u| flips(symmetry.across_v).iter().map(move |v| (u, v)))
        {
            let copy = StrokeCopy { middle, turn: turned * DMat2::from_diagonal(DVec2::new(u, v)) };
            // Half a turn equals both mirror images at once, so equal copies are left out.
            if !copies.contains(&copy) {
                copies.push(copy);
            }
        }
    }
    copies
}
