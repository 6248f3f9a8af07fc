//! Generators: rules that draw samples instead of deriving them from what is painted (the thesis's
//! future work, 12).
//!
//! A generator is made ready once for a tile of a grid, and then gives the tile of each sample by
//! itself. A tile depends on the generator's parameters, the grid and the address alone, so it is
//! the same on any number of threads.

mod relief;
mod strokes;

use crate::document::{Address, Hcbtf, Rule};
use crate::progress::Progress;

/// Straight RGBA from 0 to 255.
pub(in crate::hcbtf) type Color = [f32; 4];

/// A generator that is ready to give tiles.
pub(super) enum Generator {
    /// Of [`Rule::Strokes`].
    Strokes(strokes::Ready),
    /// Of [`Rule::Relief`].
    Relief(Box<relief::Ready>),
}

impl Generator {
    /// Makes the generator of a rule ready; `None` where the rule is none, and where it is stopped.
    pub(super) fn new(rule: &Rule, hcbtf: &Hcbtf, progress: &Progress) -> Option<Self> {
        match rule {
            Rule::Strokes(strokes) => {
                strokes::Ready::new(strokes, &hcbtf.grid, hcbtf.is_tiling, progress)
                    .map(Self::Strokes)
            }
            Rule::Relief(relief) => relief::Ready::new(relief, hcbtf, progress)
                .map(|ready| Self::Relief(Box::new(ready))),
            _ => None,
        }
    }

    /// Making the generator of a rule ready takes about as long as so many tiles, those of views
    /// and lights included that samples share.
    pub(super) fn tiles_ahead(rule: &Rule, samples: &[Address]) -> u64 {
        match rule {
            Rule::Relief(_) if !samples.is_empty() => relief::tiles_ahead(samples),
            // Its strokes are placed in less time than a tile takes.
            _ => 0,
        }
    }

    /// The texels of a sample, rows from the top; `None` where it is stopped.
    pub(super) fn tile(&self, address: Address, progress: &Progress) -> Option<Vec<Color>> {
        match self {
            Self::Strokes(ready) => ready.tile(address, progress),
            Self::Relief(ready) => ready.tile(address, progress),
        }
    }
}
