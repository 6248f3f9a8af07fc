//! Directions toward a light at which a parametrization has a given angle (docs/math.md 1.2).

use std::f64::consts::TAU;

use glam::{DMat3, DVec3};

use super::{LEAST_FACING, PlacingObstacle, SurfacePoint};

/// Number of half-vectors around the normal that the nearest one is looked for among.
const SAMPLES: u32 = 180;
/// Number of steps that narrow the nearest one down: each leaves less than two thirds of the rest.
const STEPS: u32 = 60;

/// Direction of the surface that the angle to the light is measured from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parametrization {
    /// The normal.
    Diffuse,
    /// The mirrored view.
    Specular,
    /// The normal in camera axes, against the light in its own frame.
    ScreenAligned,
    /// The normal, against the direction halfway between light and eye.
    HalfVector,
}

impl Parametrization {
    /// Parametrization of a word in documents.
    pub fn of(word: &str) -> Option<Self> {
        Some(match word {
            "diffuse" => Self::Diffuse,
            "specular" => Self::Specular,
            "screen_aligned" => Self::ScreenAligned,
            "half_vector" => Self::HalfVector,
            _ => return None,
        })
    }

    /// True if the middle of what is lit moves with the eye: a highlight.
    pub fn mirrors(self) -> bool {
        matches!(self, Self::Specular | Self::HalfVector)
    }

    /// Direction toward the light at which the angle is `angle`, in radians: the nearest to the
    /// `present` one. Unit, in world space; `own_from_world` turns to the light's own frame.
    ///
    /// # Errors
    /// The reason why there is none.
    pub(super) fn toward(
        self,
        point: &SurfacePoint,
        (present, own_from_world): (DVec3, DMat3),
        angle: f64,
    ) -> Result<DVec3, PlacingObstacle> {
        let (normal, view) = (point.normal, point.toward_eye);
        if self.mirrors() && normal.dot(view) < LEAST_FACING {
            return Err(PlacingObstacle::TurnedFromEye);
        }
        let axis = match self {
            Self::Diffuse => normal,
            Self::Specular => (2.0 * normal.dot(view) * normal - view).normalize_or(normal),
            Self::ScreenAligned => own_from_world.transpose() * (point.camera_from_world * normal),
            Self::HalfVector => return nearest_by_half_vector(point, present, angle),
        };
        Ok(turned_from(axis, present, angle))
    }
}

/// Direction at an angle from `axis`, on the side of `present`.
fn turned_from(axis: DVec3, present: DVec3, angle: f64) -> DVec3 {
    let aside = present - axis * axis.dot(present);
    // A light on the axis may go to any side.
    let aside =
        if aside.length() > 1e-9 { aside.normalize() } else { axis.any_orthonormal_vector() };
    (axis * angle.cos() + aside * angle.sin()).normalize()
}

/// Direction toward the light whose half-vector is at `angle` from the normal: half-vectors lie on
/// a cone, each is half of one light's way to the eye, and the light nearest to `present` is found
/// by going around the cone.
fn nearest_by_half_vector(
    point: &SurfacePoint,
    present: DVec3,
    angle: f64,
) -> Result<DVec3, PlacingObstacle> {
    let (normal, view) = (point.normal, point.toward_eye);
    let (across, along) = normal.any_orthonormal_pair();
    let toward = |turn: f64| {
        let (sin, cos) = turn.sin_cos();
        let half = normal * angle.cos() + (across * cos + along * sin) * angle.sin();
        // Light and eye lie on one side of their half-vector.
        let facing = half.dot(view);
        (facing > LEAST_FACING).then(|| 2.0 * facing * half - view)
    };
    let nearness = |turn: f64| toward(turn).map_or(f64::NEG_INFINITY, |light| light.dot(present));
    let step = TAU / f64::from(SAMPLES);
    let best = (0..SAMPLES)
        .map(|index| f64::from(index) * step)
        .max_by(|a, b| nearness(*a).total_cmp(&nearness(*b)))
        .filter(|turn| toward(*turn).is_some())
        .ok_or(PlacingObstacle::NoSuchAngle)?;
    let (mut least, mut most) = (best - step, best + step);
    for _ in 0..STEPS {
        let thirds = [least + (most - least) / 3.0, most - (most - least) / 3.0];
        if nearness(thirds[0]) < nearness(thirds[1]) {
            least = thirds[0];
        } else {
            most = thirds[1];
        }
    }
    let refined = toward(0.5 * (least + most)).or_else(|| toward(best));
    refined.map(DVec3::normalize).ok_or(PlacingObstacle::NoSuchAngle)
}
