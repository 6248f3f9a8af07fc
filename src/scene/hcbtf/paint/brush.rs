//! Brushes, and the symmetry of strokes.

use std::sync::Arc;

use crate::document::Tile;

/// Effect of a stroke on the texels that it meets.
#[derive(Clone, Debug, PartialEq)]
pub enum Tool {
    /// Lays the brush's color over the texels.
    Paint,
    /// Removes the texels' alpha; their color stays beneath.
    Erase,
    /// Carries colors along the stroke: the flow is the share that stays on the brush from stamp to
    /// stamp, the opacity the share that is laid down.
    Smudge,
    /// Lays a picture over the texels, as wide as the brush, again and again. A picture as wide in
    /// texels as the brush is laid on whole texels, so that none is blurred.
    Stamp(Arc<Tile>),
}

/// Properties that the pen's pressure drives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Pressure {
    /// Neither size nor opacity.
    #[default]
    None,
    /// The size of the brush.
    Size,
    /// The opacity of the stroke.
    Opacity,
    /// Both size and opacity.
    Both,
}

/// A brush.
#[derive(Clone, Debug, PartialEq)]
pub struct Brush {
    /// Tool of the brush.
    pub tool: Tool,
    /// Diameter, in texels, at most [`Brush::MAX_SIZE`]. Up to 1 the brush paints exactly the texel
    /// under the pointer.
    pub size: f64,
    /// Share of the radius that is covered wholly, from 0 (soft from the middle on) to 1 (an
    /// antialiased edge).
    pub hardness: f64,
    /// Greatest coverage of a whole stroke, from 0 to 1.
    pub opacity: f64,
    /// Share of the opacity that each stamp adds, from 0 to 1.
    pub flow: f64,
    /// Distance from stamp to stamp, as a share of the size; never less than a quarter of a texel.
    pub spacing: f64,
    /// Color, straight RGBA as bytes. Its alpha is a further factor of the opacity.
    pub color: [u8; 4],
    /// Properties that the pen's pressure drives.
    pub pressure: Pressure,
}

impl Brush {
    /// Greatest diameter of a brush, in texels; larger brushes paint nothing.
    pub const MAX_SIZE: f64 = 8192.0;

    /// The brush with all numbers in their ranges; `None` if it can paint nothing.
    pub(super) fn settled(&self) -> Option<ClampedBrush> {
        let Self { size, hardness, opacity, flow, spacing, .. } = *self;
        let are_numbers =
            [size, hardness, opacity, flow, spacing].iter().all(|number| number.is_finite());
        (are_numbers && size > 0.0 && size <= Self::MAX_SIZE).then(|| ClampedBrush {
            size,
            hardness: hardness.clamp(0.0, 1.0),
            opacity: opacity.clamp(0.0, 1.0),
            flow: flow.clamp(0.0, 1.0),
            spacing: spacing.clamp(0.0, MAX_SPACING),
            pressure: self.pressure,
        })
    }
}

/// Greatest distance between stamps, in sizes of the brush.
const MAX_SPACING: f64 = 100.0;
/// Least distance between stamps, in texels.
const MIN_STEP: f64 = 0.25;

/// A brush with all numbers in their ranges.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClampedBrush {
    pub(super) size: f64,
    pub(super) hardness: f64,
    opacity: f64,
    pub(super) flow: f64,
    spacing: f64,
    pressure: Pressure,
}

impl ClampedBrush {
    /// The diameter at a pressure, in texels.
    pub(super) fn size_at(&self, pressure: f64) -> f64 {
        if matches!(self.pressure, Pressure::Size | Pressure::Both) {
            self.size * pressure
        } else {
            self.size
        }
    }

    /// The greatest coverage of the stroke at a pressure, from 0 to 1.
    pub(super) fn opacity_at(&self, pressure: f64) -> f64 {
        if matches!(self.pressure, Pressure::Opacity | Pressure::Both) {
            self.opacity * pressure
        } else {
            self.opacity
        }
    }

    /// The distance from a stamp to the next at a pressure, in texels.
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

/// Symmetry of a stroke: its copies around the tile's middle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Symmetry {
    /// True for copies mirrored along u, left to right.
    pub across_u: bool,
    /// True for copies mirrored along v, top to bottom.
    pub across_v: bool,
    /// Number of copies around the middle, evenly over a whole turn; 0 and 1 are the stroke alone.
    /// At most [`Symmetry::MAX_TURNS`] are made.
    pub turns: u32,
}

impl Symmetry {
    /// Greatest number of copies around the middle.
    pub const MAX_TURNS: u32 = 32;
}
