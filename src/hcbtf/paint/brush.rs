//! What paints, and where its copies go.

use std::sync::Arc;

use crate::document::Tile;

/// What a stroke does to the texels that it meets.
#[derive(Clone, Debug, PartialEq)]
pub enum Tool {
    /// Lays the brush's colour over them.
    Paint,
    /// Takes their alpha away; their colour stays beneath.
    Erase,
    /// Carries the colour along that lay where the stroke came from.
    Smudge,
    /// Lays a picture over them, as wide as the brush, again and again.
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
    /// Its diameter in texels.
    pub size: f64,
    /// Which part of the radius covers wholly, from 0 (soft from the middle on) to 1 (an antialiased edge).
    pub hardness: f64,
    /// How much a whole stroke covers at most, from 0 to 1.
    pub opacity: f64,
    /// How much of that each stamp adds, from 0 to 1.
    pub flow: f64,
    /// From stamp to stamp, in parts of the size.
    pub spacing: f64,
    /// Straight RGBA as bytes. Its alpha is a further factor of the opacity.
    pub color: [u8; 4],
    /// What the pen's pressure drives.
    pub pressure: Pressure,
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
    /// So many copies around the middle, a whole turn apart in all; 0 and 1 are the stroke alone. At most
    /// [`Symmetry::MAX_TURNS`] are made.
    pub turns: u32,
}

impl Symmetry {
    /// The most copies around the middle.
    pub const MAX_TURNS: u32 = 32;
}
