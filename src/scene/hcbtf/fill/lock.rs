//! Look-up of the nearest painted sample among those that agree in the angles that matter.

use std::collections::HashMap;

use glam::DVec3;

use super::plan::{PaintedSample, SAME_ANGLE};
use crate::document::{Address, Direction, Grid, HcbtfAngle as Angle};

/// The angle between unit vectors, in radians: relatively exact for near vectors, and to 1e-8 for
/// opposite ones.
pub(super) fn angle(a: DVec3, b: DVec3) -> f64 {
    2.0 * (0.5 * (a - b).length()).min(1.0).asin()
}

/// The square of the distance between two samples on the product of the two spheres.
pub(super) fn squared_distance(light: DVec3, view: DVec3, other: &PaintedSample<'_>) -> f64 {
    angle(light, other.light).powi(2) + angle(view, other.view).powi(2)
}

/// Angles of a direction that are locked, and so do not matter.
#[derive(Clone, Copy)]
struct LockedAngles {
    theta: bool,
    phi: bool,
}

impl LockedAngles {
    /// The key that agreeing directions have in common; the step around the normal only if the ring
    /// is known, because at the normal every step agrees.
    fn key(self, direction: Direction) -> [u32; 2] {
        match direction {
            _ if self.theta => [0; 2],
            Direction { theta, .. } if self.phi => [theta, 0],
            Direction { theta, phi } => [theta, phi],
        }
    }

    /// True if two directions are equal in the angles that matter.
    fn agree(self, a: Direction, b: Direction) -> bool {
        let is_normal = a.theta == 0 || b.theta == 0;
        (self.theta || a.theta == b.theta) && (self.phi || is_normal || a.phi == b.phi)
    }
}

/// A [`crate::document::Rule::Lock`], ready to look samples up.
pub(super) struct Lock {
    light: LockedAngles,
    view: LockedAngles,
    /// Numbers of the painted samples that may agree, by their common key.
    groups: HashMap<[[u32; 2]; 2], Vec<u32>>,
}

impl Lock {
    pub(super) fn new(angles: &[Angle], painted: &[PaintedSample<'_>]) -> Self {
        let light = LockedAngles {
            theta: angles.contains(&Angle::LightTheta),
            phi: angles.contains(&Angle::LightPhi),
        };
        let view = LockedAngles {
            theta: angles.contains(&Angle::ViewTheta),
            phi: angles.contains(&Angle::ViewPhi),
        };
        let mut lock = Self { light, view, groups: HashMap::new() };
        for (number, sample) in painted.iter().enumerate() {
            lock.groups.entry(lock.key(sample.address)).or_default().push(number as u32);
        }
        lock
    }

    fn key(&self, address: Address) -> [[u32; 2]; 2] {
        [self.light.key(address.light), self.view.key(address.view)]
    }

    /// The number of the nearest painted sample that differs in the locked angles alone; of several
    /// equally near, the first by address.
    pub(super) fn nearest(
        &self,
        address: Address,
        grid: &Grid,
        painted: &[PaintedSample<'_>],
    ) -> Option<u32> {
        let (light, view) = (grid.light.vector(address.light), grid.view.vector(address.view));
        let mut best: Option<(f64, u32)> = None;
        for number in self.groups.get(&self.key(address))? {
            let sample = painted.get(*number as usize)?;
            if self.light.agree(address.light, sample.address.light)
                && self.view.agree(address.view, sample.address.view)
            {
                let distance = squared_distance(light, view, sample).sqrt();
                // Rounding must not decide between two that are equally near.
                if best.is_none_or(|(nearest, _)| distance < nearest - SAME_ANGLE) {
                    best = Some((distance, *number));
                }
            }
        }
        best.map(|(_, number)| number)
    }
}
