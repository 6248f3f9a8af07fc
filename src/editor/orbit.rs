//! Where the viewport looks from, what it looks at, and how the lights are turned.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DQuat, DVec3};

use crate::document::{Camera, Projection};
use crate::frame::DEFAULT_MESH;

/// The closest and the farthest that the eye may be.
const DISTANCE: std::ops::RangeInclusive<f64> = 0.2..=200.0;

/// A camera on a sphere around a target, the illumination frame, and the mesh that the look is judged on.
#[derive(Clone, Debug, PartialEq)]
pub struct Orbit {
    /// Around the vertical axis, in radians.
    pub yaw: f64,
    /// Above the horizon, in radians.
    pub pitch: f64,
    /// From target to eye, in scene units.
    pub distance: f64,
    /// What is looked at.
    pub target: DVec3,
    /// The vertical field of view, in radians.
    pub fov: f64,
    /// Perspective, or parallel lines.
    pub projection: Projection,
    /// Straight RGBA behind the object; `None` for what a scene has.
    pub backdrop: Option<[f64; 4]>,
    /// World from illumination frame.
    pub illumination: DQuat,
    /// A path, or `shape:` and the name of an own shape.
    pub mesh: String,
    /// Whether the mesh's z axis points up, as in many scans and drawings, and not y.
    pub z_is_up: bool,
}

impl Default for Orbit {
    fn default() -> Self {
        let camera = Camera::default();
        Self {
            yaw: 0.0,
            pitch: 0.0,
            distance: DVec3::from(camera.eye).distance(camera.target.into()),
            target: camera.target.into(),
            fov: camera.fov,
            projection: Projection::Perspective,
            backdrop: None,
            illumination: DQuat::IDENTITY,
            mesh: DEFAULT_MESH.to_owned(),
            z_is_up: false,
        }
    }
}

impl Orbit {
    /// From target to eye, of length 1.
    pub fn direction(&self) -> DVec3 {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch.sin_cos();
        DVec3::new(cos_pitch * sin_yaw, sin_pitch, cos_pitch * cos_yaw)
    }

    /// The camera's right and up, in world space.
    pub fn right_and_up(&self) -> (DVec3, DVec3) {
        let right = DVec3::new(self.yaw.cos(), 0.0, -self.yaw.sin());
        (right, self.direction().cross(right))
    }

    /// The camera as a scene has it.
    pub fn camera(&self) -> Camera {
        Camera {
            eye: (self.target + self.direction() * self.distance).to_array(),
            target: self.target.to_array(),
            up: [0.0, 1.0, 0.0],
            projection: self.projection,
            fov: self.fov,
            height: self.height(),
        }
    }

    /// The height of the picture, in scene units, at the target: the same in either projection, so that the object
    /// stays as large when that changes.
    pub fn height(&self) -> f64 {
        2.0 * self.distance * (self.fov / 2.0).tan()
    }

    /// Turns the camera by a drag, in parts of the picture's height: right drags show what is left.
    pub fn orbit(&mut self, dx: f64, dy: f64) {
        self.yaw = (self.yaw - dx * PI).rem_euclid(2.0 * PI);
        let limit = FRAC_PI_2 - 0.01;
        self.pitch = (self.pitch + dy * PI).clamp(-limit, limit);
    }

    /// Moves the target with the pointer, by a drag in parts of the picture's height.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        let (right, up) = self.right_and_up();
        self.target += (up * dy - right * dx) * self.height();
    }

    /// Brings the eye nearer (`factor` below 1) or farther.
    pub fn dolly(&mut self, factor: f64) {
        self.distance = (self.distance * factor).clamp(*DISTANCE.start(), *DISTANCE.end());
    }

    /// Turns the illumination frame as a ball under the pointer, by a drag in parts of the picture's height.
    pub fn turn_lights(&mut self, dx: f64, dy: f64) {
        let (right, up) = self.right_and_up();
        let axis = up * dx + right * dy;
        if let Some(axis) = axis.try_normalize() {
            let turn = DQuat::from_axis_angle(axis, dx.hypot(dy) * PI);
            self.illumination = (turn * self.illumination).normalize();
        }
    }

    /// The radius, in parts of the picture's height, of the sphere of radius 1 around the target.
    pub fn radius_in_picture(&self) -> f64 {
        if self.projection == Projection::Orthographic {
            return 1.0 / self.height();
        }
        let sine = (1.0 / self.distance.max(1.001)).min(1.0);
        sine.asin().tan() / (2.0 * (self.fov / 2.0).tan())
    }

    /// Looks at the whole object again; the direction stays.
    pub fn frame_object(&mut self) {
        self.target = DVec3::ZERO;
        self.distance = Self::default().distance;
    }

    /// As in the beginning; the mesh stays.
    pub fn reset(&mut self) {
        *self = Self {
            mesh: std::mem::take(&mut self.mesh),
            z_is_up: self.z_is_up,
            projection: self.projection,
            backdrop: self.backdrop,
            ..Self::default()
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_camera_starts_as_a_scene_has_it() {
        let camera = Orbit::default().camera();
        let height = camera.height;
        assert_eq!(camera, Camera { height, ..Camera::default() }, "perspective has no height");
    }

    #[test]
    fn dragging_right_brings_the_left_side_and_turns_lights_right() {
        let mut orbit = Orbit::default();
        orbit.orbit(0.25, 0.0);
        assert!(orbit.direction().x < -0.7, "the eye goes left: {}", orbit.direction());
        let mut orbit = Orbit::default();
        orbit.turn_lights(0.5, 0.0);
        let light = orbit.illumination * DVec3::Z;
        assert!((light - DVec3::X).length() < 1e-12, "a light in front is to the right now: {light}");
        let mut orbit = Orbit::default();
        orbit.turn_lights(0.0, 0.5);
        let light = orbit.illumination * DVec3::Z;
        assert!((light + DVec3::Y).length() < 1e-12, "dragging down brings it below: {light}");
    }

    #[test]
    fn the_axes_are_orthonormal() {
        let mut orbit = Orbit::default();
        orbit.orbit(0.3, -0.2);
        let (right, up) = orbit.right_and_up();
        let forward = orbit.direction();
        assert!(right.dot(up).abs() < 1e-12 && right.dot(forward).abs() < 1e-12);
        assert!((right.cross(up) - forward).length() < 1e-12 && up.y > 0.0);
    }
}
