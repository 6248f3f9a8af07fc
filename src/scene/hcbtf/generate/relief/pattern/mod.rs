//! Patterns of a relief: heights from 0 to 1, and colors in linear light, at any position on the
//! tile.

mod masonry;
mod nature;
mod painted;

use crate::document::relief::Pattern;
use crate::document::{Hcbtf, Relief, srgb_to_linear};

/// Material of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::hcbtf::generate::relief) struct CellMaterial {
    /// Share of the light that the material reflects, linear RGB.
    pub(in crate::hcbtf::generate::relief) color: [f32; 3],
    /// Alpha, from 0 to 1.
    pub(in crate::hcbtf::generate::relief) alpha: f32,
    /// Gloss, as a factor of the glint.
    pub(in crate::hcbtf::generate::relief) gloss: f32,
    /// Share of the light within that is seen.
    pub(in crate::hcbtf::generate::relief) glow: f32,
    /// Number of the grain that the cell belongs to.
    pub(in crate::hcbtf::generate::relief) grain: u32,
}

impl CellMaterial {
    pub(in crate::hcbtf::generate::relief) fn of(color: [f32; 3]) -> Self {
        Self { color, alpha: 1.0, gloss: 1.0, glow: 0.0, grain: 0 }
    }
}

/// Sampler of a pattern.
pub(in crate::hcbtf::generate::relief) enum PatternSampler<'a> {
    Painted(painted::PaintedPattern<'a>),
    Masonry(masonry::Masonry<'a>),
    Nature(nature::Nature<'a>),
}

impl<'a> PatternSampler<'a> {
    /// A sampler for a relief's pattern; `None` if the pattern needs a sample that is not painted.
    pub(in crate::hcbtf::generate::relief) fn new(
        relief: &'a Relief,
        hcbtf: &'a Hcbtf,
    ) -> Option<Self> {
        let [width, height] = hcbtf.grid.size.map(|side| side as f32);
        let aspect = height / width;
        let seed = relief.seed;
        match &relief.pattern {
            Pattern::Painted { heights, channel, is_inverted, colors } => {
                let (heights, colors) = (hcbtf.painted(*heights)?, hcbtf.painted(*colors)?);
                Some(Self::Painted(painted::PaintedPattern::new(
                    heights,
                    *channel,
                    *is_inverted,
                    colors,
                )))
            }
            pattern
            @ (Pattern::Bricks { .. } | Pattern::Facade { .. } | Pattern::Arches { .. }) => {
                Some(Self::Masonry(masonry::Masonry { pattern, seed, aspect }))
            }
            pattern @ (Pattern::Stones { .. } | Pattern::Ripples { .. }) => {
                Some(Self::Nature(nature::Nature { pattern, seed, aspect }))
            }
        }
    }

    /// The height at a position on the tile, each coordinate a share of its side, y downward.
    pub(in crate::hcbtf::generate::relief) fn height(&self, place: [f32; 2]) -> f32 {
        let height = match self {
            Self::Painted(painted) => painted.height(place),
            Self::Masonry(masonry) => masonry.at(place).0,
            Self::Nature(nature) => nature.at(place).0,
        };
        height.clamp(0.0, 1.0)
    }

    /// The material at a position on the tile.
    pub(in crate::hcbtf::generate::relief) fn material(&self, place: [f32; 2]) -> CellMaterial {
        match self {
            Self::Painted(painted) => painted.material(place),
            Self::Masonry(masonry) => masonry.at(place).1,
            Self::Nature(nature) => nature.at(place).1,
        }
    }
}

/// A color in linear light.
pub(in crate::hcbtf::generate::relief) fn linear(color: [u8; 3]) -> [f32; 3] {
    color.map(|byte| srgb_to_linear(f64::from(byte) / 255.0) as f32)
}

/// A coordinate scaled to a count of equal parts: the index of its part, and its position in that
/// part from 0 to 1.
fn part(at: f32, count: u32) -> (i64, f32) {
    let scaled = at * count as f32;
    ((scaled.floor() as i64).rem_euclid(i64::from(count.max(1))), scaled - scaled.floor())
}
