//! Light and profile of a layer, and the tone that they make.
//!
//! The search uses the formula of the BADF paper (eq. 5, 11) directly and without antialiasing, at
//! the reference's normals and mirrored views: it tries tens of thousands of tones, for which the
//! interpreter would take minutes. The formula only has to come near: the result becomes a look,
//! whose fit goes on with the reference.

use std::f64::consts::PI;

use glam::DVec3;

use super::state::{KnobSetting, ProfileShape};

/// Number of angles, and of initial offsets, at which the complement of a profile is searched for.
const TURNED: u32 = 48;

/// Direction of the surface that a layer's light is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LightingModel {
    Diffuse,
    Specular,
}

impl LightingModel {
    pub(super) const ALL: [Self; 2] = [Self::Diffuse, Self::Specular];

    /// Word for the kind in documents.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Diffuse => "diffuse",
            Self::Specular => "specular",
        }
    }
}

/// Direction, kind and profile of a layer's light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LayerLight {
    pub(super) kind: LightingModel,
    pub(super) direction: DVec3,
    pub(super) shape: ProfileShape,
}

impl LayerLight {
    /// The tone for any direction of the surface: 1 up to the offset, 0 from the cut-off on (BADF
    /// eq. 5).
    pub(super) fn tone(&self) -> impl Fn(DVec3) -> f64 + Sync + use<> {
        let (toward, curve) = (self.direction, ToneCurve::new(&self.shape));
        move |direction| curve.at(toward.dot(direction).clamp(-1.0, 1.0).acos())
    }

    /// Room along each coordinate, down and up: two of the direction, then three of the profile.
    pub(super) fn room(&self) -> Vec<[f64; 2]> {
        [KnobSetting::Direction(self.direction), KnobSetting::Profile(self.shape)]
            .iter()
            .flat_map(KnobSetting::room)
            .collect()
    }

    /// The light moved by `by` along each coordinate.
    pub(super) fn moved(&self, by: &[f64]) -> Self {
        let mut new = *self;
        let (toward, shape) = by.split_at(2);
        if let KnobSetting::Direction(direction) =
            KnobSetting::Direction(self.direction).moved(toward)
        {
            new.direction = direction;
        }
        if let KnobSetting::Profile(shape) = KnobSetting::Profile(self.shape).moved(shape) {
            new.shape = shape;
        }
        new
    }

    /// The complement of this light, from the other side, as nearly as a profile can show it.
    pub(super) fn turned_over(&self) -> Self {
        let own = ToneCurve::new(&self.shape);
        let around = |angle: f64| 1.0 - own.at(PI - angle);
        let angles = || (0..=TURNED).map(|step| PI * f64::from(step) / f64::from(TURNED));
        let cutoff = PI - self.shape.offset;
        let shapes = (0..TURNED).flat_map(|begin| {
            let offset = cutoff * f64::from(begin) / f64::from(TURNED);
            // A steep profile has all but vanished long before its cut-off, so the complement may
            // begin at any angle.
            [0.2, 0.35, 0.5, 0.65, 0.8, 0.95].map(|share| ProfileShape {
                offset,
                width: cutoff - offset,
                share,
            })
        });
        let miss = |shape: &ProfileShape| {
            let curve = ToneCurve::new(shape);
            angles().map(|angle| (curve.at(angle) - around(angle)).powi(2)).sum::<f64>()
        };
        let nearest = shapes.map(|shape| (miss(&shape), shape)).min_by(|a, b| a.0.total_cmp(&b.0));
        Self {
            direction: -self.direction,
            shape: nearest.map_or(self.shape, |(_, shape)| shape),
            ..*self
        }
    }
}

/// A profile with what is the same at all angles.
#[derive(Clone, Copy, Debug)]
struct ToneCurve {
    offset: f64,
    width: f64,
    /// Sine of half the width.
    sine: f64,
    exponent: f64,
}

impl ToneCurve {
    fn new(shape: &ProfileShape) -> Self {
        let ProfileShape { offset, width, share } = *shape;
        // BADF eq. 11: the fall-off is where the curve is steepest.
        let falloff = share * width;
        let (sum, difference) = ((0.5 * (width + falloff)).sin(), (0.5 * (width - falloff)).sin());
        let exponent = (sum * sum + difference * difference) / falloff.sin().powi(2);
        let exponent = if share >= 1.0 { 1.0 } else { exponent };
        Self { offset, width, sine: (0.5 * width).sin(), exponent }
    }

    /// The tone at `angle` radians from the light.
    fn at(&self, angle: f64) -> f64 {
        let beyond = angle - self.offset;
        if beyond <= 0.0 {
            return 1.0;
        }
        let q = (0.5 * beyond).sin() / self.sine;
        if q >= 1.0 || self.width < 1e-6 {
            return 0.0;
        }
        (1.0 - q * q).powf(self.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A profile and its complement add up to 1 only nearly: no profile is exactly the complement
    /// of another.
    #[test]
    fn what_is_turned_over_lies_around() {
        for ends in [[0.3, 0.8, 1.4], [1.9, 2.0, PI], [0.8, 1.2, 1.25], [0.0, 1.0, PI]] {
            let lit = LayerLight {
                kind: LightingModel::Diffuse,
                direction: DVec3::Z,
                shape: ProfileShape::new(ends),
            };
            let over = lit.turned_over();
            assert_eq!((over.kind, over.direction), (lit.kind, -lit.direction));
            for step in 0..=180 {
                let (sin, cos) = f64::from(step).to_radians().sin_cos();
                let place = DVec3::new(sin, 0.0, cos);
                let sum = lit.tone()(place) + over.tone()(place);
                assert!(
                    (sum - 1.0).abs() < 0.12,
                    "{ends:?} at {step} degrees: {sum}, {:?}",
                    over.shape
                );
            }
        }
    }
}
