//! What a relief is of: its heights and its colors.

use serde::{Deserialize, Serialize};

use super::Bounded;
use crate::document::Address;

/// Which number of a painted texel is its height.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// What is bright stands high.
    #[default]
    Luminance,
    /// What is opaque stands high; it is then seen as opaque everywhere.
    Alpha,
}

/// What a relief is of. Colors are straight RGB as bytes, as they are seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "pattern", rename_all = "snake_case", deny_unknown_fields)]
pub enum Pattern {
    /// Of what is painted.
    Painted {
        /// The sample that gives the heights.
        heights: Address,
        /// By which of its numbers.
        channel: Channel,
        /// Whether high and low change places.
        #[serde(rename = "inverted")]
        is_inverted: bool,
        /// The sample that gives the colors.
        colors: Address,
    },
    /// Bricks or blocks in courses.
    Bricks {
        /// Bricks in a course.
        columns: u32,
        /// Courses.
        rows: u32,
        /// By which part of a brick every second course is moved.
        shift: f64,
        /// The joints, in parts of a course's height.
        joint: f64,
        /// How far the edges are rounded, in parts of a course's height.
        bevel: f64,
        /// How much bricks differ in height.
        unevenness: f64,
        /// How rough they are.
        roughness: f64,
        /// Bricks are of colors between these.
        colors: [[u8; 3]; 2],
        /// The mortar.
        joint_color: [u8; 3],
    },
    /// Stones in a binder, as in asphalt and gravel.
    Stones {
        /// Large stones along the tile.
        count: u32,
        /// How much of the surface they take.
        share: f64,
        /// How much fine grit lies between them.
        grit: f64,
        /// 0 is flat with steep sides, 1 is round.
        roundness: f64,
        /// Stones are of colors between these.
        colors: [[u8; 3]; 2],
        /// What holds them.
        binder: [u8; 3],
    },
    /// A wall with windows.
    Facade {
        /// Windows on a floor.
        columns: u32,
        /// Floors.
        floors: u32,
        /// A window's width and height, in parts of its bay.
        window: [f64; 2],
        /// The frame's width, in parts of the window's.
        frame: f64,
        /// How far sills and bands stand out, in parts of the depth.
        sill: f64,
        /// How rough the wall is.
        roughness: f64,
        /// The wall.
        wall: [u8; 3],
        /// Frames, sills and bands.
        trim: [u8; 3],
        /// The panes; they glint.
        glass: [u8; 3],
        /// Which part of the windows is lit from within when the sun is low.
        lit: f64,
        /// The light within.
        lit_color: [u8; 3],
    },
    /// Openings under round arches.
    Arches {
        /// Arches side by side.
        columns: u32,
        /// Rows of them.
        rows: u32,
        /// An opening's width and height, in parts of its bay.
        opening: [f64; 2],
        /// The width of the ring of stones, in parts of the opening's.
        ring: f64,
        /// Courses of the wall in a bay.
        courses: u32,
        /// How rough the stone is.
        roughness: f64,
        /// The wall.
        wall: [u8; 3],
        /// The ring.
        trim: [u8; 3],
        /// What is seen through the opening.
        inside: [u8; 3],
    },
    /// Ripples, as of sand and water; without any, hills.
    Ripples {
        /// Ripples from top to bottom.
        count: u32,
        /// How much they bend.
        bend: f64,
        /// How rough they are.
        roughness: f64,
        /// From the lowest to the highest.
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
    pub(super) fn bounds(&self) -> impl Iterator<Item = Bounded> {
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
