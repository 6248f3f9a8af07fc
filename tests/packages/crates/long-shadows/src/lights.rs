//! The lights of the look.

#![allow(clippy::approx_constant, reason = "values are those that the artist chose")]

use crate::host::LightSettings;

/// A light that shines from everywhere in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight {
    /// Direction toward the light, of any length, in the light's own frame.
    pub direction: [f32; 3],
    /// Straight RGB.
    pub color: [f32; 3],
    /// Factor on the color.
    pub intensity: f32,
}

/// Lights of the look. A light's own frame is that of the illumination, of the world, of the
/// camera (x right, y up, z toward the viewer), or of the object, whose origin is the object's
/// middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lights {
    /// The light Evening sun, in the world's frame.
    pub sun: DirectionalLight,
}

/// Lights as the artist has set them.
impl Default for Lights {
    fn default() -> Self {
        Self {
            sun: DirectionalLight {
                direction: [0.86, 0.36, 0.42],
                color: [1.0; 3],
                intensity: 1.0,
            },
        }
    }
}

/// Fields that a kind of light does not have.
const UNSET: LightSettings = LightSettings {
    direction: [0.0, 0.0, 1.0],
    position: [0.0; 3],
    aim: [0.0, 0.0, -1.0],
    color: [1.0; 3],
    intensity: 1.0,
    inner: 0.0,
    outer: 0.0,
    half_distance: 0.0,
    range: 0.0,
    aimed_at: [0.0; 4],
    shadow_map: [0.0, 0.0, 1.0, -1.0],
};

impl DirectionalLight {
    pub(crate) fn settings(&self) -> LightSettings {
        LightSettings {
            direction: self.direction.map(f64::from),
            color: self.color.map(f64::from),
            intensity: self.intensity.into(),
            ..UNSET
        }
    }
}
