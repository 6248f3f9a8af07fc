//! What lights a relief, what of it shines, and how it is drawn.

use serde::{Deserialize, Serialize};

use super::Bounded;

/// The sun and the sky of a relief, both of which may change their colors as the sun sinks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Illumination {
    /// The sun when it is high.
    pub sun: [u8; 3],
    /// The sun when it is low.
    pub low_sun: [u8; 3],
    /// 1 shows a surface that faces the sun in its own color.
    pub sun_amount: f64,
    /// The sky, equal from everywhere, when the sun is high.
    pub sky: [u8; 3],
    /// The sky when the sun is low.
    pub low_sky: [u8; 3],
    /// 1 shows an open surface under the sky alone in its own color.
    pub sky_amount: f64,
    /// Whether the tile stands upright: the sun is low where its direction is near the tile's
    /// horizontal (u and the normal), rather than near the horizon around the normal.
    #[serde(rename = "upright")]
    pub is_upright: bool,
    /// Half the width of a shadow's soft edge, as an angle of the sun, in radians.
    pub softness: f64,
    /// How often light goes on from one place to another.
    pub bounces: u32,
}

impl Default for Illumination {
    fn default() -> Self {
        Self {
            sun: [255, 250, 240],
            low_sun: [255, 214, 170],
            sun_amount: 0.85,
            sky: [150, 170, 205],
            low_sky: [130, 140, 180],
            sky_amount: 0.45,
            is_upright: false,
            softness: 0.06,
            bounces: 2,
        }
    }
}

impl Illumination {
    pub(super) fn bounds(&self) -> impl Iterator<Item = Bounded> {
        let bounds = [
            ("sun_amount", self.sun_amount, 0.0, 8.0),
            ("sky_amount", self.sky_amount, 0.0, 8.0),
            ("softness", self.softness, 0.0, 0.5),
            ("bounces", f64::from(self.bounces), 0.0, 64.0),
        ];
        bounds.into_iter()
    }
}

/// What shines where the sun is mirrored to the eye.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Glint {
    /// How bright: 0 is none, 1 as bright as the sun where it is mirrored.
    pub amount: f64,
    /// 1 is broad, 500 a spark.
    pub sharpness: f64,
    /// Which part of the grains shines.
    pub share: f64,
    /// How far the grains lean to any side, in radians: so some shine while others do not.
    pub lean: f64,
}

impl Default for Glint {
    fn default() -> Self {
        Self { amount: 0.0, sharpness: 40.0, share: 1.0, lean: 0.0 }
    }
}

impl Glint {
    pub(super) fn bounds(&self) -> impl Iterator<Item = Bounded> {
        let bounds = [
            ("amount", self.amount, 0.0, 8.0),
            ("sharpness", self.sharpness, 1.0, 2000.0),
            ("share", self.share, 0.0, 1.0),
            ("lean", self.lean, 0.0, 1.0),
        ];
        bounds.into_iter()
    }
}

/// How a relief is drawn, as by hand.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Finish {
    /// Steps of light, 0 for all of them.
    pub bands: u32,
    /// How strongly edges are inked where something stands before something else.
    pub ink: f64,
    /// How wide, in texels.
    pub ink_width: f64,
    /// The ink, also of hatching.
    pub ink_color: [u8; 3],
    /// How strongly the dark is hatched.
    pub hatch: f64,
    /// Hatching lines across the tile.
    pub hatch_lines: u32,
    /// How far lines stray as from a hand, in tile widths.
    pub wobble: f64,
    /// How much paper shows.
    pub grain: f64,
}

impl Default for Finish {
    fn default() -> Self {
        Self {
            bands: 0,
            ink: 0.0,
            ink_width: 1.0,
            ink_color: [40, 34, 44],
            hatch: 0.0,
            hatch_lines: 12,
            wobble: 0.0,
            grain: 0.0,
        }
    }
}

impl Finish {
    pub(super) fn bounds(&self) -> impl Iterator<Item = Bounded> {
        let bounds = [
            ("bands", f64::from(self.bands), 0.0, 16.0),
            ("ink", self.ink, 0.0, 1.0),
            ("ink_width", self.ink_width, 0.25, 8.0),
            ("hatch", self.hatch, 0.0, 1.0),
            ("hatch_lines", f64::from(self.hatch_lines), 1.0, 64.0),
            ("wobble", self.wobble, 0.0, 0.1),
            ("grain", self.grain, 0.0, 1.0),
        ];
        bounds.into_iter()
    }
}
