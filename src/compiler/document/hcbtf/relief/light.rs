//! Illumination, glint and finish of a relief.

use serde::{Deserialize, Serialize};

use super::BoundedNumber;

/// Sun and sky of a relief, both of which may change their colors as the sun sinks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Illumination {
    /// Color of the sun when it is high.
    pub sun: [u8; 3],
    /// Color of the sun when it is low.
    pub low_sun: [u8; 3],
    /// Amount of sunlight: 1 shows a surface that faces the sun in its own color.
    pub sun_amount: f64,
    /// Color of the sky, equal from everywhere, when the sun is high.
    pub sky: [u8; 3],
    /// Color of the sky when the sun is low.
    pub low_sky: [u8; 3],
    /// Amount of skylight: 1 shows an open surface under the sky alone in its own color.
    pub sky_amount: f64,
    /// True if the tile stands upright: the sun is low where its direction is near the tile's
    /// horizontal (u and the normal), rather than near the horizon around the normal.
    #[serde(rename = "upright")]
    pub is_upright: bool,
    /// Half the width of a shadow's soft edge, as an angle of the sun, in radians.
    pub softness: f64,
    /// Number of bounces of light between places of the relief.
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
    pub(super) fn bounds(&self) -> impl Iterator<Item = BoundedNumber> {
        let bounds = [
            ("sun_amount", self.sun_amount, 0.0, 8.0),
            ("sky_amount", self.sky_amount, 0.0, 8.0),
            ("softness", self.softness, 0.0, 0.5),
            ("bounces", f64::from(self.bounces), 0.0, 64.0),
        ];
        bounds.into_iter()
    }
}

/// Glint: the specular reflection where the sun is mirrored to the eye.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Glint {
    /// Brightness: 0 is none, 1 as bright as the sun where it is mirrored.
    pub amount: f64,
    /// Sharpness of the highlight: 1 is broad, 500 a spark.
    pub sharpness: f64,
    /// Share of the grains that shine.
    pub share: f64,
    /// Greatest tilt of the grains to any side, so that some shine while others do not, in radians.
    pub lean: f64,
}

impl Default for Glint {
    fn default() -> Self {
        Self { amount: 0.0, sharpness: 40.0, share: 1.0, lean: 0.0 }
    }
}

impl Glint {
    pub(super) fn bounds(&self) -> impl Iterator<Item = BoundedNumber> {
        let bounds = [
            ("amount", self.amount, 0.0, 8.0),
            ("sharpness", self.sharpness, 1.0, 2000.0),
            ("share", self.share, 0.0, 1.0),
            ("lean", self.lean, 0.0, 1.0),
        ];
        bounds.into_iter()
    }
}

/// Finish: the style in which a relief is drawn, as by hand.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Finish {
    /// Number of steps of light; 0 for continuous light.
    pub bands: u32,
    /// Strength of the ink on edges where one part stands before another.
    pub ink: f64,
    /// Width of the ink lines, in texels.
    pub ink_width: f64,
    /// Color of the ink, also of hatching.
    pub ink_color: [u8; 3],
    /// Strength of the hatching of dark places.
    pub hatch: f64,
    /// Number of hatching lines across the tile.
    pub hatch_lines: u32,
    /// Deviation of lines as drawn by hand, in tile widths.
    pub wobble: f64,
    /// Strength of the paper's grain.
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
    pub(super) fn bounds(&self) -> impl Iterator<Item = BoundedNumber> {
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
