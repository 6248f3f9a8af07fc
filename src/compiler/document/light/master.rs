//! Masters of groups of lights, as a mixer has them.

use crate::document::described::described;
use crate::document::shape::{FieldKind, LINE, NumberBounds, POSITIVE};

/// Stops that a master may dim or brighten by, either way.
pub const MAX_EXPOSURE: f64 = 60.0;

described! {
    /// The master of a group of lights: what every light of the group is multiplied by.
    #[serde(default)]
    pub struct GroupMaster("light group", Line) {
        /// Artist's name of the group; empty for its word.
        #[serde(skip_serializing_if = "String::is_empty")]
        name: String = String::new(), FieldKind::Text(LINE);
        /// A factor on the intensity of each light.
        intensity: f64 = 1.0, FieldKind::Number(POSITIVE);
        /// In stops: each doubles the intensity.
        exposure: f64 = 0.0,
            FieldKind::Number(NumberBounds::new(-MAX_EXPOSURE, MAX_EXPOSURE));
        /// Straight RGB in the looks' color space that each light's color is multiplied by.
        tint: [f64; 3] = [1.0; 3], FieldKind::Color { alpha: false };
    }
}

impl GroupMaster {
    /// Factors on the intensity and on the color of each light of the group.
    pub fn factors(&self) -> (f64, [f64; 3]) {
        (self.intensity * self.exposure.exp2(), self.tint)
    }
}
