//! Generators: rules that draw samples instead of deriving them from what is painted (the thesis's
//! future work, 12).
//!
//! A generator is prepared once for a tile of a grid, and then makes the tile of each sample
//! independently. A tile depends on the generator's parameters, the grid and the address alone, so
//! it is the same on any number of threads.

mod relief;
mod strokes;

use crate::document::{Address, Hcbtf, Rule};
use crate::progress::Progress;

/// A color, straight RGBA from 0 to 255.
pub(in crate::hcbtf) type Color = [f32; 4];

/// A generator that is prepared and makes tiles.
pub(super) enum Generator {
    /// Generator of [`Rule::Strokes`].
    Strokes(strokes::PreparedStrokes),
    /// Generator of [`Rule::Relief`].
    Relief(Box<relief::PreparedRelief>),
}

impl Generator {
    /// Prepares the generator of a rule; `None` if the rule is not a generator, and if the work is
    /// stopped.
    pub(super) fn new(rule: &Rule, hcbtf: &Hcbtf, progress: &Progress) -> Option<Self> {
        match rule {
            Rule::Strokes(strokes) => {
                strokes::PreparedStrokes::new(strokes, &hcbtf.grid, hcbtf.is_tiling, progress)
                    .map(Self::Strokes)
            }
            Rule::Relief(relief) => relief::PreparedRelief::new(relief, hcbtf, progress)
                .map(|ready| Self::Relief(Box::new(ready))),
            _ => None,
        }
    }

    /// The time that preparing the generator of a rule takes, in tiles, including that for views
    /// and lights that samples share.
    pub(super) fn tiles_ahead(rule: &Rule, samples: &[Address]) -> u64 {
        match rule {
            Rule::Relief(_) if !samples.is_empty() => relief::tiles_ahead(samples),
            // The strokes are placed in less time than a tile takes.
            _ => 0,
        }
    }

    /// The texels of a sample, rows from the top; `None` if the work is stopped.
    pub(super) fn tile(&self, address: Address, progress: &Progress) -> Option<Vec<Color>> {
        match self {
            Self::Strokes(ready) => ready.tile(address, progress),
            Self::Relief(ready) => ready.tile(address, progress),
        }
    }
}
