//! Patterns of a relief: its heights and its colors.

use serde::{Deserialize, Serialize};

use super::BoundedNumber;
use crate::document::Address;

/// Channel of a painted texel that gives its height.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Luminance: bright texels stand high.
    #[default]
    Luminance,
    /// Alpha: opaque texels stand high; the relief is then opaque everywhere.
    Alpha,
}

/// Pattern of a relief. Colors are straight RGB as bytes, as they are seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "pattern", rename_all = "snake_case", deny_unknown_fields)]
pub enum Pattern {
    /// Heights and colors of painted samples.
    Painted {
        /// Sample that gives the heights.
        heights: Address,
        /// Channel that gives the heights.
        channel: Channel,
        /// True if high and low are exchanged.
        #[serde(rename = "inverted")]
        is_inverted: bool,
        /// Sample that gives the colors.
        colors: Address,
    },
    /// Bricks or blocks in courses.
    Bricks {
        /// Number of bricks in a course.
        columns: u32,
        /// Number of courses.
        rows: u32,
        /// Shift of every second course, in parts of a brick.
        shift: f64,
        /// Width of the joints, in parts of a course's height.
        joint: f64,
        /// Width of the rounded edges, in parts of a course's height.
        bevel: f64,
        /// Variation of the bricks' heights.
        unevenness: f64,
        /// Roughness of the bricks.
        roughness: f64,
        /// Range of the bricks' colors.
        colors: [[u8; 3]; 2],
        /// Color of the mortar.
        joint_color: [u8; 3],
    },
    /// Stones in a binder, as in asphalt and gravel.
    Stones {
        /// Number of large stones along the tile.
        count: u32,
        /// Share of the surface that the large stones take.
        share: f64,
        /// Amount of fine grit between the large stones.
        grit: f64,
        /// Roundness of the stones: 0 is flat with steep sides, 1 is round.
        roundness: f64,
        /// Range of the stones' colors.
        colors: [[u8; 3]; 2],
        /// Color of the binder.
        binder: [u8; 3],
    },
    /// A wall with windows.
    Facade {
        /// Number of windows on a floor.
        columns: u32,
        /// Number of floors.
        floors: u32,
        /// Width and height of a window, in parts of its bay.
        window: [f64; 2],
        /// Width of the frame, in parts of the window's.
        frame: f64,
        /// Height of sills and bands over the wall, in parts of the depth.
        sill: f64,
        /// Roughness of the wall.
        roughness: f64,
        /// Color of the wall.
        wall: [u8; 3],
        /// Color of frames, sills and bands.
        trim: [u8; 3],
        /// Color of the panes, which glint.
        glass: [u8; 3],
        /// Share of the windows that are lit from within when the sun is low.
        lit: f64,
        /// Color of the light within.
        lit_color: [u8; 3],
    },
    /// Openings under round arches.
    Arches {
        /// Number of arches side by side.
        columns: u32,
        /// Number of rows of arches.
        rows: u32,
        /// Width and height of an opening, in parts of its bay.
        opening: [f64; 2],
        /// Width of the ring of stones, in parts of the opening's.
        ring: f64,
        /// Number of courses of the wall in a bay.
        courses: u32,
        /// Roughness of the stone.
        roughness: f64,
        /// Color of the wall.
        wall: [u8; 3],
        /// Color of the ring.
        trim: [u8; 3],
        /// Color seen through the opening.
        inside: [u8; 3],
    },
    /// Ripples, as of sand and water; without any, hills.
    Ripples {
        /// Number of ripples from top to bottom.
        count: u32,
        /// Strength of the ripples' bends.
        bend: f64,
        /// Roughness of the surface.
        roughness: f64,
        /// Colors of the lowest and of the highest place.
        colors: [[u8; 3]; 2],
    },
}

impl Default for Pattern {
    fn default() -> Self {
        Self::Bricks {
            columns: 3,
            rows: 6,
            shift: 0.5,
            joint: 0.12,
            bevel: 0.12,
            unevenness: 0.3,
            roughness: 0.3,
            colors: [[176, 84, 62], [138, 62, 52]],
            joint_color: [186, 176, 160],
        }
    }
}

impl Pattern {
    pub(super) fn bounds(&self) -> impl Iterator<Item = BoundedNumber> {
        let part = |name, value| (name, value, 0.0, 1.0);
        let count = |name, value: u32, most| (name, f64::from(value), 1.0, most);
        let bounds = match self {
            Self::Painted { .. } => Vec::new(),
            Self::Bricks { columns, rows, shift, joint, bevel, unevenness, roughness, .. } => vec![
                count("columns", *columns, 64.0),
                count("rows", *rows, 64.0),
                part("shift", *shift),
                part("joint", *joint),
                part("bevel", *bevel),
                part("unevenness", *unevenness),
                part("roughness", *roughness),
            ],
            Self::Stones { count: stones, share, grit, roundness, .. } => vec![
                count("count", *stones, 64.0),
                part("share", *share),
                part("grit", *grit),
                part("roundness", *roundness),
            ],
            Self::Facade { columns, floors, window, frame, sill, roughness, lit, .. } => vec![
                count("columns", *columns, 32.0),
                count("floors", *floors, 32.0),
                ("window", window[0], 0.05, 0.95),
                ("window", window[1], 0.05, 0.95),
                ("frame", *frame, 0.0, 0.45),
                part("sill", *sill),
                part("roughness", *roughness),
                part("lit", *lit),
            ],
            Self::Arches { columns, rows, opening, ring, courses, roughness, .. } => vec![
                count("columns", *columns, 32.0),
                count("rows", *rows, 32.0),
                ("opening", opening[0], 0.05, 0.95),
                ("opening", opening[1], 0.05, 0.95),
                part("ring", *ring),
                count("courses", *courses, 32.0),
                part("roughness", *roughness),
            ],
            Self::Ripples { count, bend, roughness, .. } => {
                vec![
                    ("count", f64::from(*count), 0.0, 64.0),
                    ("bend", *bend, 0.0, 4.0),
                    part("roughness", *roughness),
                ]
            }
        };
        bounds.into_iter()
    }
}
