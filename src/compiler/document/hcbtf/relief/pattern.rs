//! Patterns of a relief: its heights and its colors.

use serde::{Deserialize, Serialize};

use super::{BYTES, amount};
use crate::document::Address;
use crate::document::described::{described, described_choice};
use crate::document::hcbtf::AddressFields;
use crate::document::shape::{FieldKind, NumberBounds};
use crate::document::word::WordChoice as _;

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

/// Kind of a count of repeated parts along a side of the tile.
const fn count(most: f64) -> FieldKind {
    FieldKind::Number(NumberBounds::whole(1.0, most))
}

/// Kind of the width and height of an opening, in parts of its bay.
const OPENING: FieldKind = FieldKind::Numbers(2, 2, NumberBounds::new(0.05, 0.95));
/// Kind of a range of colors.
const COLORS: FieldKind = FieldKind::Pair(&BYTES);

described_choice! {
    /// Pattern of a relief. Colors are straight RGB as bytes, as they are seen.
    pub enum Pattern("pattern") {
        /// Heights and colors of painted samples.
        Painted("painted") as PaintedPattern {
            /// Sample that gives the heights.
            heights: Address = Address::default(), FieldKind::Object(AddressFields::shape);
            /// Channel that gives the heights.
            channel: Channel = Channel::Luminance, FieldKind::Word(Channel::WORDS);
            /// True if high and low are exchanged.
            #[serde(rename = "inverted")]
            is_inverted as "inverted": bool = false, FieldKind::Bool;
            /// Sample that gives the colors.
            colors: Address = Address::default(), FieldKind::Object(AddressFields::shape);
        }
        /// Bricks or blocks in courses.
        Bricks("bricks") as BricksPattern {
            /// Number of bricks in a course.
            columns: u32 = 3, count(64.0);
            /// Number of courses.
            rows: u32 = 6, count(64.0);
            /// Shift of every second course, in parts of a brick.
            shift: f64 = 0.5, amount(1.0);
            /// Width of the joints, in parts of a course's height.
            joint: f64 = 0.12, amount(1.0);
            /// Width of the rounded edges, in parts of a course's height.
            bevel: f64 = 0.12, amount(1.0);
            /// Variation of the bricks' heights.
            unevenness: f64 = 0.3, amount(1.0);
            /// Roughness of the bricks.
            roughness: f64 = 0.3, amount(1.0);
            /// Range of the bricks' colors.
            colors: [[u8; 3]; 2] = [[176, 84, 62], [138, 62, 52]], COLORS;
            /// Color of the mortar.
            joint_color: [u8; 3] = [186, 176, 160], BYTES;
        }
        /// Stones in a binder, as in asphalt and gravel.
        Stones("stones") as StonesPattern {
            /// Number of large stones along the tile.
            count: u32 = 9, count(64.0);
            /// Share of the surface that the large stones take.
            share: f64 = 0.75, amount(1.0);
            /// Amount of fine grit between the large stones.
            grit: f64 = 0.8, amount(1.0);
            /// Roundness of the stones: 0 is flat with steep sides, 1 is round.
            roundness: f64 = 0.55, amount(1.0);
            /// Range of the stones' colors.
            colors: [[u8; 3]; 2] = [[112, 110, 108], [168, 160, 148]], COLORS;
            /// Color of the binder.
            binder: [u8; 3] = [46, 46, 52], BYTES;
        }
        /// A wall with windows.
        Facade("facade") as FacadePattern {
            /// Number of windows on a floor.
            columns: u32 = 2, count(32.0);
            /// Number of floors.
            floors: u32 = 2, count(32.0);
            /// Width and height of a window, in parts of its bay.
            window: [f64; 2] = [0.46, 0.58], OPENING;
            /// Width of the frame, in parts of the window's.
            frame: f64 = 0.1, amount(0.45);
            /// Height of sills and bands over the wall, in parts of the depth.
            sill: f64 = 0.5, amount(1.0);
            /// Roughness of the wall.
            roughness: f64 = 0.5, amount(1.0);
            /// Color of the wall.
            wall: [u8; 3] = [226, 206, 178], BYTES;
            /// Color of frames, sills and bands.
            trim: [u8; 3] = [244, 236, 222], BYTES;
            /// Color of the panes, which glint.
            glass: [u8; 3] = [70, 92, 112], BYTES;
            /// Share of the windows that are lit from within when the sun is low.
            lit: f64 = 0.4, amount(1.0);
            /// Color of the light within.
            lit_color: [u8; 3] = [255, 206, 120], BYTES;
        }
        /// Openings under round arches.
        Arches("arches") as ArchesPattern {
            /// Number of arches side by side.
            columns: u32 = 1, count(32.0);
            /// Number of rows of arches.
            rows: u32 = 1, count(32.0);
            /// Width and height of an opening, in parts of its bay.
            opening: [f64; 2] = [0.5, 0.8], OPENING;
            /// Width of the ring of stones, in parts of the opening's.
            ring: f64 = 0.34, amount(1.0);
            /// Number of courses of the wall in a bay.
            courses: u32 = 7, count(32.0);
            /// Roughness of the stone.
            roughness: f64 = 0.5, amount(1.0);
            /// Color of the wall.
            wall: [u8; 3] = [206, 178, 138], BYTES;
            /// Color of the ring.
            trim: [u8; 3] = [232, 212, 176], BYTES;
            /// Color seen through the opening.
            inside: [u8; 3] = [134, 102, 92], BYTES;
        }
        /// Ripples, as of sand and water; without any, hills.
        Ripples("ripples") as RipplesPattern {
            /// Number of ripples from top to bottom.
            count: u32 = 7, FieldKind::Number(NumberBounds::whole(0.0, 64.0));
            /// Strength of the ripples' bends.
            bend: f64 = 1.1, amount(4.0);
            /// Roughness of the surface.
            roughness: f64 = 0.25, amount(1.0);
            /// Colors of the lowest and of the highest place.
            colors: [[u8; 3]; 2] = [[176, 132, 84], [238, 208, 154]], COLORS;
        }
    }
}

impl Default for Pattern {
    fn default() -> Self {
        Self::of_word("bricks").expect("a pattern")
    }
}
