//! View of the look: the camera, the mesh in front of it, and the turn of the lights.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DMat3, DQuat, DVec3};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::document::{Camera, Projection};
use crate::frame::{DEFAULT_MESH, View, widened};

/// Mesh name of a flat square.
pub(crate) const PLANE: &str = "shape:plane";
/// Range of the distance from target to eye that the wheel reaches, in scene units.
const DISTANCE: std::ops::RangeInclusive<f64> = 0.2..=200.0;
/// Share of the picture's height, or of its width, that a framed sphere takes.
const FRAMED: f64 = 0.86;
/// Least radius at which a scene can be made out, in parts of the picture's height.
const LEAST_SEEN: f64 = 0.04;

/// Greatest difference of two fields of view that are one lens, in radians.
const SAME_LENS: f64 = 1e-3;
/// Digits after the point of a camera's numbers, where it is one unit away.
const DIGITS: i32 = 5;

/// A camera on a sphere around a target, the illumination frame, and the mesh that the look is
/// judged on.
#[derive(Clone, Debug, PartialEq)]
pub struct Orbit {
    /// Angle around the vertical axis, in radians.
    pub yaw: f64,
    /// Angle above the horizon, in radians.
    pub pitch: f64,
    /// Rotation to world space from the turntable, whose up may lie elsewhere in the world.
    pub upright: DQuat,
    /// Distance from target to eye, in scene units.
    pub distance: f64,
    /// The point that the camera looks at.
    pub target: DVec3,
    /// Vertical field of view, in radians.
    pub fov: f64,
    /// Aspect ratio, width over height, of the picture that a scene's camera was placed for, until
    /// the camera is shown in a picture that may be narrower; 0 for any.
    pub placed_for: f64,
    /// Perspective, or parallel lines.
    pub projection: Projection,
    /// Straight RGBA behind the object; `None` for the scene's own backdrop.
    pub backdrop: Option<[f64; 4]>,
    /// Rotation to world space from the illumination frame.
    pub illumination: DQuat,
    /// Mesh: a path, or `shape:` and the name of a built-in shape.
    pub mesh: String,
    /// True if the mesh's z axis points up, as in many scans and drawings, and not y.
    pub z_is_up: bool,
}

/// Saved form of an [`Orbit`], without the mesh, which is saved for itself.
#[derive(Serialize, Deserialize)]
#[serde(default)]
struct SavedOrbit {
    yaw: f64,
    pitch: f64,
    upright: [f64; 4],
    distance: f64,
    target: [f64; 3],
    fov: f64,
    projection: Projection,
    backdrop: Option<[f64; 4]>,
    illumination: [f64; 4],
    z_is_up: bool,
}

impl Default for SavedOrbit {
    fn default() -> Self {
        Self::of(&Orbit::default())
    }
}

impl SavedOrbit {
    fn of(orbit: &Orbit) -> Self {
        Self {
            yaw: orbit.yaw,
            pitch: orbit.pitch,
            upright: orbit.upright.to_array(),
            distance: orbit.distance,
            target: orbit.target.to_array(),
            fov: orbit.fov,
            projection: orbit.projection,
            backdrop: orbit.backdrop,
            illumination: orbit.illumination.to_array(),
            z_is_up: orbit.z_is_up,
        }
    }

    /// True if a camera can look from here: a file may say anything.
    fn is_sound(&self) -> bool {
        let turns = [self.upright, self.illumination].map(|turn| DQuat::from_array(turn).length());
        let numbers = [self.yaw, self.pitch, self.distance, self.fov];
        let all = numbers.into_iter().chain(self.target).chain(self.backdrop.into_iter().flatten());
        let is_seen = match self.projection {
            Projection::Perspective => Camera::holds_fov(self.fov),
            // The field of view stands for a height at a distance, whatever that is.
            Projection::Orthographic => self.fov > 0.0 && self.fov < PI,
        };
        all.chain(turns).all(f64::is_finite)
            && turns.iter().all(|length| *length > 1e-6)
            && self.distance > 0.0
            && is_seen
    }
}

impl Default for Orbit {
    fn default() -> Self {
        let camera = Camera::default();
        Self {
            yaw: 0.0,
            pitch: 0.0,
            upright: DQuat::IDENTITY,
            distance: DVec3::from(camera.eye).distance(camera.target.into()),
            target: camera.target.into(),
            fov: camera.fov,
            placed_for: 0.0,
            projection: Projection::Perspective,
            backdrop: None,
            illumination: DQuat::IDENTITY,
            mesh: DEFAULT_MESH.to_owned(),
            z_is_up: false,
        }
    }
}

impl Orbit {
    /// The saved form: everything but the mesh.
    pub(crate) fn to_json(&self) -> Value {
        serde_json::to_value(SavedOrbit::of(self)).unwrap_or_default()
    }

    /// Restores everything but the mesh from the result of [`to_json`](Self::to_json); a view that
    /// no camera can look from changes nothing.
    pub(crate) fn recall(&mut self, kept: &Value) {
        // serde would also take a list, as members in their order.
        let Some(kept) = Some(kept)
            .filter(|kept| kept.is_object())
            .and_then(|kept| SavedOrbit::deserialize(kept).ok())
        else {
            return;
        };
        if kept.is_sound() {
            *self = Self {
                yaw: kept.yaw,
                pitch: kept.pitch,
                upright: DQuat::from_array(kept.upright).normalize(),
                distance: kept.distance,
                target: kept.target.into(),
                fov: kept.fov,
                placed_for: 0.0,
                projection: kept.projection,
                backdrop: kept.backdrop,
                illumination: DQuat::from_array(kept.illumination).normalize(),
                mesh: std::mem::take(&mut self.mesh),
                z_is_up: kept.z_is_up,
            };
        }
    }

    /// Direction from target to eye, of length 1.
    pub fn direction(&self) -> DVec3 {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch.sin_cos();
        self.upright * DVec3::new(cos_pitch * sin_yaw, sin_pitch, cos_pitch * cos_yaw)
    }

    /// Right and up of the camera, in world space.
    pub fn right_and_up(&self) -> (DVec3, DVec3) {
        let right = self.upright * DVec3::new(self.yaw.cos(), 0.0, -self.yaw.sin());
        (right, self.direction().cross(right))
    }

    /// The camera in a scene's terms.
    pub fn camera(&self) -> Camera {
        Camera {
            eye: (self.target + self.direction() * self.distance).to_array(),
            target: self.target.to_array(),
            up: (self.upright * DVec3::Y).to_array(),
            projection: self.projection,
            // A parallel view from far away stands for a field of view that no camera has.
            fov: self.fov.clamp(Camera::FOV[0], Camera::FOV[1]),
            height: self.height(),
            aspect: self.placed_for,
        }
    }

    /// The camera in numbers that people read: so many digits as its distance needs, and those of
    /// `before` where nothing moved.
    fn written_camera(&self, before: &Camera) -> Camera {
        let camera = self.camera();
        let scale = self.written_scale();
        let point = |new: [f64; 3], old: [f64; 3], scale: f64| {
            std::array::from_fn(|axis| written(new[axis], old[axis], scale))
        };
        let of_units = 10.0_f64.powi(DIGITS);
        Camera {
            eye: point(camera.eye, before.eye, scale),
            target: point(camera.target, before.target, scale),
            up: point(camera.up, before.up, of_units),
            fov: written(camera.fov, before.fov, of_units),
            height: written(camera.height, before.height, scale),
            ..camera
        }
    }

    /// The scale by which distances of this view are whole numbers as they are written.
    fn written_scale(&self) -> f64 {
        let digits = DIGITS - self.distance.max(1e-3).log10().floor() as i32;
        10.0_f64.powi(digits.clamp(0, 9))
    }

    /// The camera of this view with the lens of `before`, where the view has that lens, as it is
    /// shown in a picture of such an aspect, width over height.
    pub(crate) fn camera_with(&self, before: &Camera, aspect: f64) -> Camera {
        let mut camera = self.written_camera(before);
        if camera.projection != before.projection {
            return camera;
        }
        let mut shown = self.clone();
        shown.look_from(before);
        shown.fit_into(aspect);
        match camera.projection {
            Projection::Perspective if (shown.fov - self.fov).abs() < SAME_LENS => {
                (camera.fov, camera.aspect) = (before.fov, before.aspect);
                camera.height = before.height;
            }
            Projection::Perspective => camera.height = before.height,
            Projection::Orthographic => {
                let height = self.camera().height / before.widening(aspect);
                camera.height = written(height, before.height, self.written_scale());
                (camera.fov, camera.aspect) = (before.fov, before.aspect);
            }
        }
        camera
    }

    /// Widens a view that was placed for a wider picture than `aspect`, width over height, so that
    /// as much is seen in width. A picture without room changes nothing.
    pub(crate) fn fit_into(&mut self, aspect: f64) {
        if !(aspect > 0.0 && aspect.is_finite()) {
            return;
        }
        let widening = self.camera().widening(aspect);
        if widening > 1.0 {
            self.fov = widened(self.fov, widening);
        }
        self.placed_for = 0.0;
    }

    /// Looks from a scene's camera; mesh, backdrop and lights stay.
    pub fn look_from(&mut self, camera: &Camera) {
        let view = View::new(camera, [1, 1], DVec3::ZERO, 1.0);
        let up = DVec3::from(camera.up).try_normalize().unwrap_or(DVec3::Y);
        self.upright = DQuat::from_rotation_arc(DVec3::Y, up);
        self.target = camera.target.into();
        self.distance = DVec3::from(camera.eye).distance(self.target).max(1e-3);
        self.projection = camera.projection;
        self.placed_for = camera.aspect;
        self.fov = match camera.projection {
            Projection::Perspective => camera.fov.clamp(Camera::FOV[0], Camera::FOV[1]),
            Projection::Orthographic => {
                2.0 * (0.5 * camera.height.max(1e-6) / self.distance).atan()
            }
        };
        let to_turntable = self.upright.inverse();
        let (backward, right) =
            (to_turntable * view.backward, to_turntable * view.rotation().row(0));
        self.pitch = backward.y.clamp(-1.0, 1.0).asin();
        self.yaw = (-right.z).atan2(right.x).rem_euclid(2.0 * PI);
    }

    /// Brings a whole sphere into view, in a picture of the given aspect ratio, width over height;
    /// the direction stays.
    pub fn frame(&mut self, center: DVec3, radius: f64, aspect: f64) {
        let radius = if radius.is_finite() { radius.max(1e-3) } else { 1.0 };
        let half = (0.5 * self.fov).tan() * aspect.clamp(0.05, 1.0) * FRAMED;
        self.target = center;
        self.distance = match self.projection {
            Projection::Perspective => radius / half.atan().sin(),
            Projection::Orthographic => radius / half,
        };
    }

    /// Height of the picture at the target, in scene units: the same in either projection, so that
    /// the object keeps its size when the projection changes.
    pub fn height(&self) -> f64 {
        2.0 * self.distance * (self.fov / 2.0).tan()
    }

    /// Turns the camera by a drag, in parts of the picture's height: a drag to the right shows the
    /// object's left side.
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
        // A scene may be larger, or smaller, than the wheel's range; the eye never jumps back into
        // it.
        let (least, most) =
            (DISTANCE.start().min(self.distance), DISTANCE.end().max(self.distance));
        self.distance = (self.distance * factor).clamp(least, most);
    }

    /// Turns the illumination frame as a ball under the pointer, by a drag in parts of the
    /// picture's height.
    pub fn turn_lights(&mut self, dx: f64, dy: f64) {
        let (right, up) = self.right_and_up();
        let axis = up * dx + right * dy;
        if let Some(axis) = axis.try_normalize() {
            let turn = DQuat::from_axis_angle(axis, dx.hypot(dy) * PI);
            self.illumination = (turn * self.illumination).normalize();
        }
    }

    /// Shows the other side in the same light: camera and lights go half around the vertical axis,
    /// so that the picture is that of an object which was turned around.
    pub(crate) fn turn_around(&mut self) {
        let turn = DQuat::from_axis_angle(self.upright * DVec3::Y, PI);
        self.yaw = (self.yaw + PI).rem_euclid(2.0 * PI);
        self.target = turn * self.target;
        self.illumination = (turn * self.illumination).normalize();
    }

    /// True if the other side is shown, as after [`turn_around`](Self::turn_around): camera and
    /// lights lie behind the mesh. A camera alone that goes round the mesh turns nothing around.
    pub(crate) fn is_turned_around(&self) -> bool {
        let front = self.upright.inverse() * self.illumination * DVec3::Z;
        self.yaw.cos() < 0.0 && front.z < 0.0
    }

    /// Turns the illumination frame as the camera was turned since an earlier view, so that the
    /// light comes from the same side of the picture.
    pub(crate) fn take_lights_along(&mut self, before: &Self) {
        let turn = self.world_from_camera() * before.world_from_camera().inverse();
        self.illumination = (turn * self.illumination).normalize();
    }

    /// True if the camera looks from another direction than in an earlier view.
    pub(crate) fn has_turned(&self, before: &Self) -> bool {
        (self.yaw, self.pitch, self.upright) != (before.yaw, before.pitch, before.upright)
    }

    fn world_from_camera(&self) -> DQuat {
        let (right, up) = self.right_and_up();
        DQuat::from_mat3(&DMat3::from_cols(right, up, self.direction()))
    }

    /// Place of a point of the world in the picture: from its middle to the right and up, in
    /// heights of the picture; `None` behind the eye.
    pub(crate) fn place_in_picture(&self, point: DVec3) -> Option<[f64; 2]> {
        let (right, up) = self.right_and_up();
        let from_eye = point - (self.target + self.direction() * self.distance);
        let depth = -from_eye.dot(self.direction());
        let span = match self.projection {
            Projection::Perspective if depth <= 1e-6 => return None,
            Projection::Perspective => 2.0 * depth * (self.fov / 2.0).tan(),
            Projection::Orthographic => self.height(),
        };
        Some([from_eye.dot(right) / span, from_eye.dot(up) / span])
    }

    /// Ray through a place of the picture, from its middle to the right and up, in heights of the
    /// picture: origin and unit direction, in world space.
    pub(crate) fn ray_through(&self, [x, y]: [f64; 2]) -> (DVec3, DVec3) {
        let (right, up) = self.right_and_up();
        let backward = self.direction();
        let eye = self.target + backward * self.distance;
        let plane = right * x + up * y;
        match self.projection {
            Projection::Perspective => {
                (eye, (plane * 2.0 * (self.fov / 2.0).tan() - backward).normalize())
            }
            Projection::Orthographic => (eye + plane * self.height(), -backward),
        }
    }

    /// True if a sphere reaches out of a picture of width `aspect`, in heights, or is too small to
    /// be made out. Pictures that are higher than wide count as square ones.
    pub(crate) fn crops(&self, center: DVec3, radius: f64, aspect: f64) -> bool {
        let (right, _) = self.right_and_up();
        let places = [center, center + right * radius].map(|point| self.place_in_picture(point));
        let [Some(middle), Some(side)] = places else { return true };
        let radius = side[0] - middle[0];
        let is_out = |at: f64, half: f64| at.abs() + radius > half;
        is_out(middle[0], 0.5 * aspect.max(1.0)) || is_out(middle[1], 0.5) || radius < LEAST_SEEN
    }

    /// Radius of the picture of the unit sphere around the target, in parts of the picture's
    /// height.
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

    /// Resets the view; mesh, its up axis, projection and backdrop stay.
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

impl Orbit {
    /// Shows another mesh. The up axis is reset then: one mesh may lie on its back while another
    /// does not.
    pub(crate) fn show_on(&mut self, mesh: &str) {
        let place = |mesh: &str| std::path::absolute(mesh).ok();
        self.z_is_up &= place(&self.mesh) == place(mesh);
        mesh.clone_into(&mut self.mesh);
    }

    /// Looks down at a flat square that lies in the middle: the view in which a painted surface is
    /// judged.
    pub(crate) fn look_at_a_sheet(&mut self) {
        PLANE.clone_into(&mut self.mesh);
        self.z_is_up = true;
        self.yaw = 0.5;
        self.pitch = 0.75;
    }
}

/// A number as it is written: the old one where it stands, or else in steps of one over `scale`.
fn written(new: f64, old: f64, scale: f64) -> f64 {
    let is_same = (new - old).abs() * scale < 0.5;
    if is_same { old } else { (new * scale).round() / scale + 0.0 }
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
    fn what_is_turned_around_has_the_same_light_from_the_eye() {
        let seen = |orbit: &Orbit| {
            let (right, up) = orbit.right_and_up();
            let light = orbit.illumination * DVec3::new(0.3, 0.5, 0.8).normalize();
            DVec3::new(light.dot(right), light.dot(up), light.dot(orbit.direction()))
        };
        let mut orbit = Orbit { yaw: 0.4, pitch: 0.3, ..Orbit::default() };
        let (before, light) = (orbit.clone(), seen(&orbit));
        orbit.turn_around();
        assert!((seen(&orbit) - light).length() < 1e-12, "{} for {light}", seen(&orbit));
        let turned = (before.direction() * DVec3::new(-1.0, 1.0, -1.0)) - orbit.direction();
        assert!(turned.length() < 1e-12, "from behind: {turned}");
        orbit.turn_around();
        assert!((orbit.direction() - before.direction()).length() < 1e-12, "there and back");
        let here = orbit.clone();
        orbit.orbit(0.2, 0.1);
        assert!((seen(&orbit) - light).length() > 0.1, "a camera leaves the lights");
        orbit.take_lights_along(&here);
        assert!((seen(&orbit) - light).length() < 1e-12, "or takes them along");
    }

    #[test]
    fn dragging_right_brings_the_left_side_and_turns_lights_right() {
        let mut orbit = Orbit::default();
        orbit.orbit(0.25, 0.0);
        assert!(orbit.direction().x < -0.7, "the eye goes left: {}", orbit.direction());
        let mut orbit = Orbit::default();
        orbit.turn_lights(0.5, 0.0);
        let light = orbit.illumination * DVec3::Z;
        assert!(
            (light - DVec3::X).length() < 1e-12,
            "a light in front is to the right now: {light}"
        );
        let mut orbit = Orbit::default();
        orbit.turn_lights(0.0, 0.5);
        let light = orbit.illumination * DVec3::Z;
        assert!((light + DVec3::Y).length() < 1e-12, "dragging down brings it below: {light}");
    }

    #[test]
    fn a_view_is_remembered_and_nonsense_is_not() {
        let mut orbit =
            Orbit { z_is_up: true, backdrop: Some([0.1, 0.2, 0.3, 1.0]), ..Orbit::default() };
        orbit.orbit(0.3, 0.1);
        orbit.turn_lights(0.2, 0.4);
        orbit.dolly(0.5);
        let mut other = Orbit { mesh: "own.obj".to_owned(), ..Orbit::default() };
        other.recall(&orbit.to_json());
        assert!(other.illumination.angle_between(orbit.illumination) < 1e-9);
        let kept = Orbit { mesh: "own.obj".to_owned(), illumination: other.illumination, ..orbit };
        assert_eq!(other, kept);
        for text in [
            "null",
            "[]",
            r#"{"yaw": "left"}"#,
            r#"{"distance": 0}"#,
            r#"{"fov": 7}"#,
            r#"{"upright": [0, 0, 0, 0]}"#,
            r#"{"target": [1e308, 1e999, 0]}"#,
        ] {
            let Ok(value) = serde_json::from_str(text) else {
                continue;
            };
            other.recall(&value);
            assert_eq!(other, kept, "{text}");
        }
    }

    #[test]
    fn a_scenes_camera_is_looked_from() {
        let mut cameras = vec![Camera::default()];
        for up in [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.3, -1.0, 0.2]] {
            for eye in [[3.0, 2.0, 1.0], [-1.0, -4.0, 0.5], [0.5, 7.0, 0.0], [0.0, -0.2, -9.0]] {
                cameras.push(Camera { eye, up, target: [0.5, 0.0, 0.0], ..Camera::default() });
            }
        }
        cameras.push(Camera {
            projection: Projection::Orthographic,
            height: 5.4,
            eye: [0.0, 0.0, 12.0],
            ..cameras[0]
        });
        cameras.extend(Camera::FOV.map(|fov| Camera { fov, ..cameras[1] }));
        cameras.push(Camera { aspect: 2.0, ..cameras[1] });
        cameras.push(Camera { aspect: 2.0, ..cameras[cameras.len() - 2] });
        for camera in cameras {
            let mut orbit = Orbit::default();
            orbit.look_from(&camera);
            let mut fitted = orbit.clone();
            fitted.fit_into(1.5);
            for orbit in [&orbit, &fitted] {
                let [wanted, found] = [camera, orbit.camera()]
                    .map(|camera| View::new(&camera, [300, 200], DVec3::ZERO, 2.0));
                assert!(
                    wanted.clip_from_world.abs_diff_eq(found.clip_from_world, 1e-9),
                    "{camera:?}"
                );
            }
        }
    }

    #[test]
    fn what_is_framed_fills_the_picture() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let mut orbit = Orbit { projection, ..Orbit::default() };
            let (center, radius) = (DVec3::new(5.0, 1.0, -3.0), 2.5);
            orbit.frame(center, radius, 1.6);
            let view = View::new(&orbit.camera(), [160, 100], center, radius);
            let (_, up) = orbit.right_and_up();
            // The outermost visible point of the sphere: as seen from the eye, the silhouette leans
            // toward it.
            let highest = (0..900).map(|step| {
                let angle = f64::from(step) * 1e-3 * PI;
                view.clip_from_world
                    .project_point3(
                        center + radius * (up * angle.sin() + orbit.direction() * angle.cos()),
                    )
                    .y
            });
            let highest = highest.fold(0.0, f64::max);
            assert!((highest - FRAMED).abs() < 1e-3, "{highest}");
        }
    }

    #[test]
    fn what_reaches_out_of_the_picture_is_cropped() {
        let orbit = Orbit::default();
        assert!(!orbit.crops(DVec3::ZERO, 1.0, 1.0), "one object stands in the picture");
        assert!(orbit.crops(DVec3::ZERO, 1.2, 2.0));
        assert!(orbit.crops(DVec3::X * 2.0, 1.0, 1.0) && !orbit.crops(DVec3::X, 1.0, 3.0));
        assert!(orbit.crops(DVec3::ZERO, 0.01, 1.0), "too small");
        assert!(orbit.crops(DVec3::Z * 9.0, 1.0, 1.0), "behind the eye");
        let mut framed = orbit.clone();
        framed.frame(DVec3::new(5.0, 1.0, -3.0), 2.5, 1.6);
        assert!(!framed.crops(DVec3::new(5.0, 1.0, -3.0), 2.5, 1.6));
    }

    #[test]
    fn what_is_turned_around_is_known_and_a_camera_behind_is_not() {
        let mut orbit = Orbit::default();
        assert!(!orbit.is_turned_around());
        orbit.turn_around();
        orbit.orbit(0.3, 0.2);
        assert!(orbit.is_turned_around(), "also when it is looked at from a little elsewhere");
        orbit.turn_around();
        assert!(!orbit.is_turned_around());
        let behind = Orbit { yaw: PI, ..Orbit::default() };
        assert!(!behind.is_turned_around(), "the lights are where they were");
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

    #[test]
    fn a_view_that_moved_keeps_the_lens_and_one_that_was_changed_does_not() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let before = Camera { projection, aspect: 1.78, fov: 0.5, ..Camera::default() };
            let mut orbit = Orbit::default();
            orbit.look_from(&before);
            orbit.fit_into(1.2);
            let moved = orbit.camera_with(&before, 1.2);
            assert!((moved.height - before.height).abs() < 1e-9);
            assert_eq!(
                Camera {
                    eye: before.eye,
                    target: before.target,
                    up: before.up,
                    height: before.height,
                    ..moved
                },
                before
            );
            assert_eq!([moved.eye, moved.target, moved.up], [before.eye, before.target, before.up]);
            orbit.orbit(0.3, 0.0);
            let turned = orbit.camera_with(&before, 1.2);
            let digits = |x: f64| x.to_string().len();
            let numbers = turned.eye.iter().chain(&turned.target);
            assert!(numbers.into_iter().all(|x| digits(*x) <= 8), "{turned:?}");
            assert!(turned.eye != before.eye);
            assert_eq!((turned.fov, turned.aspect), (0.5, 1.78));
        }
        let before = Camera { fov: 0.5, aspect: 1.78, ..Camera::default() };
        let mut orbit = Orbit::default();
        orbit.look_from(&before);
        orbit.fit_into(1.2);
        orbit.fov = 0.3;
        let changed = orbit.camera_with(&before, 1.2);
        assert_eq!((changed.fov, changed.aspect), (0.3, 0.0));
    }
}
