//! What paints, and where its copies go.

use std::sync::Arc;

use crate::document::Tile;

/// What a stroke does to the texels that it meets.
#[derive(Clone, Debug, PartialEq)]
pub enum Tool {
    /// Lays the brush's color over them.
    Paint,
    /// Takes their alpha away; their color stays beneath.
    Erase,
    /// Carries the color along that lay where the stroke came from: the flow is how much of it
    /// stays on the brush from stamp to stamp, the opacity how much of it is laid down.
    Smudge,
    /// Lays a picture over them, as wide as the brush, again and again. A picture as wide in texels
    /// as the brush is laid on whole texels, so that none is blurred.
    Stamp(Arc<Tile>),
}

/// What the pen's pressure drives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Pressure {
    /// Nothing.
    #[default]
    None,
    /// How large the brush is.
    Size,
    /// How much a stroke covers.
    Opacity,
    /// Both.
    Both,
}

/// A brush.
#[derive(Clone, Debug, PartialEq)]
pub struct Brush {
    /// What it does.
    pub tool: Tool,
    /// Its diameter in texels, at most [`Brush::MAX_SIZE`]. Up to 1 it paints exactly the texel
    /// under the pointer.
    pub size: f64,
    /// Which part of the radius covers wholly, from 0 (soft from the middle on) to 1 (an
    /// antialiased edge).
    pub hardness: f64,
    /// How much a whole stroke covers at most, from 0 to 1.
    pub opacity: f64,
    /// How much of that each stamp adds, from 0 to 1.
    pub flow: f64,
    /// From stamp to stamp, in parts of the size; never less than a quarter of a texel.
    pub spacing: f64,
    /// Straight RGBA as bytes. Its alpha is a further factor of the opacity.
    pub color: [u8; 4],
    /// What the pen's pressure drives.
    pub pressure: Pressure,
}

impl Brush {
    /// Larger brushes paint nothing; in texels.
    pub const MAX_SIZE: f64 = 8192.0;

    /// The brush with all numbers in their ranges; `None` where it can paint nothing.
    pub(super) fn settled(&self) -> Option<Settled> {
        let Self { size, hardness, opacity, flow, spacing, .. } = *self;
        let are_numbers =
            [size, hardness, opacity, flow, spacing].iter().all(|number| number.is_finite());
        (are_numbers && size > 0.0 && size <= Self::MAX_SIZE).then(|| Settled {
            size,
            hardness: hardness.clamp(0.0, 1.0),
            opacity: opacity.clamp(0.0, 1.0),
            flow: flow.clamp(0.0, 1.0),
            spacing: spacing.clamp(0.0, MAX_SPACING),
            pressure: self.pressure,
        })
    }
}

/// Stamps farther apart than so many sizes are as far apart as that.
const MAX_SPACING: f64 = 100.0;
/// Stamps lie at least so many texels apart.
const MIN_STEP: f64 = 0.25;

/// A brush whose numbers can be relied upon.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settled {
    pub(super) size: f64,
    pub(super) hardness: f64,
    opacity: f64,
    pub(super) flow: f64,
    spacing: f64,
    pressure: Pressure,
}

impl Settled {
    /// The diameter in texels.
    pub(super) fn size_at(&self, pressure: f64) -> f64 {
        if matches!(self.pressure, Pressure::Size | Pressure::Both) {
            self.size * pressure
        } else {
            self.size
        }
    }

    /// How much the stroke covers at most, from 0 to 1.
    pub(super) fn opacity_at(&self, pressure: f64) -> f64 {
        if matches!(self.pressure, Pressure::Opacity | Pressure::Both) {
            self.opacity * pressure
        } else {
            self.opacity
        }
    }

    /// From a stamp to the next, in texels.
    pub(super) fn step_at(&self, pressure: f64) -> f64 {
        (self.spacing * self.size_at(pressure)).max(MIN_STEP)
    }
}

impl Default for Brush {
    /// A black, hard, opaque brush of 8 texels.
    fn default() -> Self {
        Self {
            tool: Tool::Paint,
            size: 8.0,
            hardness: 1.0,
            opacity: 1.0,
            flow: 1.0,
            spacing: 0.1,
            color: [0, 0, 0, 255],
            pressure: Pressure::None,
        }
    }
}

/// The copies of a stroke around the tile's middle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Symmetry {
    /// Mirrored along u, left to right.
    pub across_u: bool,
    /// Mirrored along v, top to bottom.
    pub across_v: bool,
    /// So many copies around the middle, a whole turn apart in all; 0 and 1 are the stroke alone.
    /// At most [`Symmetry::MAX_TURNS`] are made.
    pub turns: u32,
}

impl Symmetry {
    /// The most copies around the middle.
    pub const MAX_TURNS: u32 = 32;
}
