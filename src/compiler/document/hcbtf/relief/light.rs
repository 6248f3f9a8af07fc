//! Illumination, glint and finish of a relief.

use super::{BYTES, amount};
use crate::document::described::described;
use crate::document::shape::{FieldKind, NumberBounds};

described! {
    /// Sun and sky of a relief, both of which may change their colors as the sun sinks.
    #[serde(default)]
    pub struct Illumination("illumination", Inline) {
        /// Color of the sun when it is high.
        sun: [u8; 3] = [255, 250, 240], BYTES, always;
        /// Color of the sun when it is low.
        low_sun: [u8; 3] = [255, 214, 170], BYTES, always;
        /// Amount of sunlight: 1 shows a surface that faces the sun in its own color.
        sun_amount: f64 = 0.85, amount(8.0), always;
        /// Color of the sky, equal from everywhere, when the sun is high.
        sky: [u8; 3] = [150, 170, 205], BYTES, always;
        /// Color of the sky when the sun is low.
        low_sky: [u8; 3] = [130, 140, 180], BYTES, always;
        /// Amount of skylight: 1 shows an open surface under the sky alone in its own color.
        sky_amount: f64 = 0.45, amount(8.0), always;
        /// True if the tile stands upright: the sun is low where its direction is near the tile's
        /// horizontal (u and the normal), rather than near the horizon around the normal.
        #[serde(rename = "upright")]
        is_upright as "upright": bool = false, FieldKind::Bool, always;
        /// Half the width of a shadow's soft edge, as an angle of the sun, in radians.
        softness: f64 = 0.06, amount(0.5), always;
        /// Number of bounces of light between places of the relief.
        bounces: u32 = 2, FieldKind::Number(NumberBounds::whole(0.0, 64.0)), always;
    }
}

described! {
    /// Glint: the specular reflection where the sun is mirrored to the eye.
    #[serde(default)]
    pub struct Glint("glint", Inline) {
        /// Brightness: 0 is none, 1 as bright as the sun where it is mirrored.
        amount: f64 = 0.0, amount(8.0), always;
        /// Sharpness of the highlight: 1 is broad, 500 a spark.
        sharpness: f64 = 40.0, FieldKind::Number(NumberBounds::new(1.0, 2000.0)), always;
        /// Share of the grains that shine.
        share: f64 = 1.0, amount(1.0), always;
        /// Greatest tilt of the grains to any side, so that some shine while others do not, in
        /// radians.
        lean: f64 = 0.0, amount(1.0), always;
    }
}

described! {
    /// Finish: the style in which a relief is drawn, as by hand.
    #[serde(default)]
    pub struct Finish("finish", Inline) {
        /// Number of steps of light; 0 for continuous light.
        bands: u32 = 0, FieldKind::Number(NumberBounds::whole(0.0, 16.0)), always;
        /// Strength of the ink on edges where one part stands before another.
        ink: f64 = 0.0, amount(1.0), always;
        /// Width of the ink lines, in texels.
        ink_width: f64 = 1.0, FieldKind::Number(NumberBounds::new(0.25, 8.0)), always;
        /// Color of the ink, also of hatching.
        ink_color: [u8; 3] = [40, 34, 44], BYTES, always;
        /// Strength of the hatching of dark places.
        hatch: f64 = 0.0, amount(1.0), always;
        /// Number of hatching lines across the tile.
        hatch_lines: u32 = 12, FieldKind::Number(NumberBounds::whole(1.0, 64.0)), always;
        /// Deviation of lines as drawn by hand, in tile widths.
        wobble: f64 = 0.0, amount(0.1), always;
        /// Strength of the paper's grain.
        grain: f64 = 0.0, amount(1.0), always;
    }
}
