//! Placing of lights by what they do: where a light must stand so that its highlight, its shadow or
//! the edge of its lit part is at a given point of a surface (docs/math.md 13).
//!
//! [`place_light`] inverts the angle of a parametrization, or takes the line through a caster and
//! the place of its shadow; [`terminator_angle`] inverts a profile. Where a goal leaves a light
//! free, the solution nearest to its present direction is chosen: lights move no more than asked.
//! All is f64, without a window; results are in the light's own frame, as documents hold them.

mod angle;
mod profile;

use chiaro_locale::tr;
use glam::{DMat3, DQuat, DVec3};

use crate::document::{Light, LightFrames, LightKind, LightValues};

pub use angle::Parametrization;
pub use profile::terminator_angle;

/// Least cosine between a normal and a direction at which the surface counts as turned to it.
const LEAST_FACING: f64 = 1e-3;
/// Least part of the way to a lamp that lies beyond a caster for the distance to be kept.
const LEAST_BEYOND: f64 = 1e-3;
/// Decimals of numbers that are written: a nanometer of a meter, and less than a second of arc.
const DECIMALS: f64 = 1e9;

/// A point of a surface, as shaders see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Position, in world space.
    pub position: DVec3,
    /// Normal toward the side that is seen; unit, in world space.
    pub normal: DVec3,
    /// Direction toward the eye; unit, in world space.
    pub toward_eye: DVec3,
    /// Rotation from world space to camera axes.
    pub camera_from_world: DMat3,
}

/// Goal of placing a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlacingGoal {
    /// The parametrization has this angle at the point, in radians.
    Angle(Parametrization, f64),
    /// The shadow of this point of a caster, in world space, falls on the point.
    Shadow(DVec3),
}

/// Part of a lamp that stays as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeptDistance {
    /// Distance from the point.
    FromPoint,
    /// Distance from the caster: the lamp was nearer to the point than the caster is.
    FromCaster,
}

/// A light that was placed.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedLight {
    /// The light, with its vectors in its own frame.
    pub light: Light,
    /// The distance that is kept; `None` for a directional light, which has none.
    pub kept: Option<KeptDistance>,
    /// True if a spot light shone past the point, and was aimed at it.
    pub is_aimed: bool,
}

/// Reason why no light can do what was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlacingObstacle {
    /// The surface is turned away from the eye, so that it mirrors from behind.
    TurnedFromEye,
    /// The place of the shadow is turned away from its caster.
    TurnedFromCaster,
    /// The caster and the place of its shadow are one point.
    SamePlace,
    /// The lamp lies on the point, so that it has no direction.
    LampOnPoint,
    /// No light has that angle there.
    NoSuchAngle,
}

impl PlacingObstacle {
    /// The reason in words, as a sentence without its end.
    pub fn words(self) -> &'static str {
        match self {
            Self::TurnedFromEye => tr!("The surface there is turned away from the eye"),
            Self::TurnedFromCaster => {
                tr!(
                    "That place is turned away from the caster, so that no shadow of it falls there"
                )
            }
            Self::SamePlace => {
                tr!("The shadow must fall somewhere else than on its caster's own point")
            }
            Self::LampOnPoint => tr!("The lamp lies on that very point: move it away first"),
            Self::NoSuchAngle => tr!("No light has that angle there"),
        }
    }
}

/// Places a light, whose frames are `frames`, so that `goal` is met at `point`: turns a directional
/// light, moves a lamp at its distance, and turns a spot light so that the point keeps its place in
/// the cone. A spot that shone past the point is aimed at it. A light that is aimed at an object
/// stays so: a directional one moves about the object instead.
///
/// # Errors
/// The reason why no light meets the goal.
pub fn place_light(
    light: &Light,
    frames: &LightFrames,
    point: &SurfacePoint,
    goal: &PlacingGoal,
) -> Result<PlacedLight, PlacingObstacle> {
    let values = LightValues::new(light, frames);
    let (present, distance) = match light.kind {
        LightKind::Directional => (values.direction(), 0.0),
        LightKind::Point | LightKind::Spot => {
            let offset = values.position() - point.position;
            let toward = offset.try_normalize().ok_or(PlacingObstacle::LampOnPoint)?;
            (toward, offset.length())
        }
    };
    let (toward, distance, kept) = match *goal {
        PlacingGoal::Angle(parametrization, angle) => {
            let axes = (present, values.own_from_world);
            (parametrization.toward(point, axes, angle)?, distance, KeptDistance::FromPoint)
        }
        PlacingGoal::Shadow(caster) => {
            let gap = caster - point.position;
            let toward = gap.try_normalize().ok_or(PlacingObstacle::SamePlace)?;
            if toward.dot(point.normal) < LEAST_FACING {
                return Err(PlacingObstacle::TurnedFromCaster);
            }
            if distance > gap.length() * (1.0 + LEAST_BEYOND) {
                (toward, distance, KeptDistance::FromPoint)
            } else {
                let from_caster = values.position().distance(caster).max(gap.length() * 0.1);
                (toward, gap.length() + from_caster, KeptDistance::FromCaster)
            }
        }
    };
    let mut placed = light.clone();
    let target = light.aimed_at.as_ref().and_then(|id| frames.aims.get(id)).copied();
    if let (LightKind::Directional, Some(target)) = (light.kind, target) {
        let around = values.position().distance(target);
        let around = if around > 0.0 { around } else { 1.0 };
        let position = target + toward * around;
        placed.position = written(values.own_from_world * (position - values.own_origin));
        return Ok(PlacedLight { light: placed, kept: None, is_aimed: false });
    }
    if light.kind == LightKind::Directional {
        placed.direction = written(values.own_from_world * toward);
        return Ok(PlacedLight { light: placed, kept: None, is_aimed: false });
    }
    let position = point.position + toward * distance;
    placed.position = written(values.own_from_world * (position - values.own_origin));
    let mut is_aimed = false;
    if light.kind == LightKind::Spot && target.is_none() {
        is_aimed = values.aim().dot(-present) <= values.cone[1];
        let turn = DQuat::from_rotation_arc(-present, -toward);
        let aim = if is_aimed { -toward } else { turn * values.aim() };
        placed.aim = written(values.own_from_world * aim);
    }
    Ok(PlacedLight { light: placed, kept: Some(kept), is_aimed })
}

/// Numbers as they are written in documents.
fn written(vector: DVec3) -> [f64; 3] {
    vector.to_array().map(|x| (x * DECIMALS).round() / DECIMALS + 0.0)
}

#[cfg(test)]
mod tests;
