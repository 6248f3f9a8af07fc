//! The camera's matrices, in f64.

use glam::{DMat3, DMat4, DVec3, DVec4};

use crate::compile::Uniform;
use crate::document::{Camera, Projection};
use crate::library::MAX_NORMAL_SCALE;

/// Least distance of the near plane of a perspective view, as a share of the far plane's: a nearer
/// plane costs depth precision, because depth is an f32 whose steps are far away.
const NEAREST: f64 = 1e-3;
/// Least distance of the near plane where a surface is that near, as a share of the far plane's:
/// below it, the f32 of a vertex shader cannot tell on which side of the eye a vertex lies.
const LEAST_NEAREST: f64 = 1e-6;

/// A camera resolved for a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Matrix from world to clip space as in WebGPU: x right, y up, z from 0 (near) to 1 (far).
    pub clip_from_world: DMat4,
    /// Matrix from world space to camera axes: x right, y up, z toward the viewer, from the eye.
    pub camera_from_world: DMat4,
    /// Position of the eye, in world space.
    pub eye: DVec3,
    /// Unit direction from the target toward the viewer.
    pub backward: DVec3,
    /// True for perspective, where lines meet at the eye; false for parallel projection.
    pub is_perspective: bool,
    /// Width and height of the picture, in pixels.
    pub viewport: [u32; 2],
    /// Height of the picture at depth 1 for perspective, at every depth for parallel projection, in
    /// scene units.
    pub view_height: f64,
}

impl View {
    /// Resolves `camera` for a picture of `viewport` pixels of a scene within `radius` of `center`.
    pub fn new(camera: &Camera, viewport: [u32; 2], center: DVec3, radius: f64) -> Self {
        let eye = DVec3::from(camera.eye);
        let backward = (eye - DVec3::from(camera.target)).try_normalize().unwrap_or(DVec3::Z);
        let up = DVec3::from(camera.up);
        // An up vector along the line of sight leaves the roll undetermined; any other axis settles
        // it.
        let fallback = if backward.y.abs() < 0.9 { DVec3::Y } else { DVec3::Z };
        let right = up
            .cross(backward)
            .try_normalize()
            .unwrap_or_else(|| fallback.cross(backward).normalize());
        let up = backward.cross(right);
        let rotation = DMat3::from_cols(right, up, backward).transpose();
        let camera_from_world = DMat4::from_mat3(rotation) * DMat4::from_translation(-eye);
        let aspect = f64::from(viewport[0].max(1)) / f64::from(viewport[1].max(1));
        // Everything in the scene lies between these two planes, which are a little farther apart
        // so that nothing is cut.
        let distance = backward.dot(eye - center);
        let reach = radius.max(1e-6) * 1.01;
        let far = (distance + reach).max(1e-3);
        let widening = camera.widening(aspect);
        let (projection, is_perspective, view_height) = match camera.projection {
            Projection::Perspective => {
                let near = (distance - reach).max(far * NEAREST);
                // Documents stay within this range; a camera from elsewhere gets the nearest angle
                // that can be drawn.
                let fov = camera.fov.clamp(Camera::FOV[0], Camera::FOV[1]);
                let fov = widened(fov, widening);
                (
                    perspective(fov, aspect, near, far.max(near * 1.001)),
                    true,
                    2.0 * (0.5 * fov).tan(),
                )
            }
            Projection::Orthographic => {
                let half = 0.5 * camera.height.max(1e-6) * widening;
                let near = distance - reach;
                (orthographic(half * aspect, half, near, far.max(near + 1e-3)), false, 2.0 * half)
            }
        };
        let clip_from_world = projection * camera_from_world;
        Self {
            clip_from_world,
            camera_from_world,
            eye,
            backward,
            is_perspective,
            viewport,
            view_height,
        }
    }

    /// The distance from the eye at which a surface is whole in the picture: nearer surfaces may
    /// lie before the near plane, first in a corner of the picture. 0 without perspective, where no
    /// surface does. In scene units.
    pub(super) fn least_distance(&self) -> f64 {
        if self.is_perspective { self.distance(0.0) / self.corner_cosine() } else { 0.0 }
    }

    /// The view with the near plane moved before a surface at `distance` from the eye, in scene
    /// units. That makes the depth of far surfaces coarser, so the plane stays where it is as long
    /// as nothing is cut.
    pub(super) fn with_surface_at(self, distance: Option<f64>) -> Self {
        let Some(distance) = distance.filter(|distance| *distance < self.least_distance()) else {
            return self;
        };
        let (near, far) = (self.distance(0.0), self.distance(1.0));
        let near = (0.5 * distance * self.corner_cosine()).clamp(far * LEAST_NEAREST, near);
        let [width, height] = self.viewport.map(|side| f64::from(side.max(1)));
        let fov = 2.0 * (0.5 * self.view_height).atan();
        let clip_from_world = perspective(fov, width / height, near, far) * self.camera_from_world;
        Self { clip_from_world, ..self }
    }

    /// The cosine of the angle between the line of sight and a corner of the picture.
    fn corner_cosine(&self) -> f64 {
        let [width, height] = self.viewport.map(|side| f64::from(side.max(1)));
        let half = 0.5 * self.view_height;
        1.0 / (1.0 + half * half * (1.0 + (width / height).powi(2))).sqrt()
    }

    /// The size of a pixel at depth 1 for perspective, at every depth for parallel projection, in
    /// scene units.
    pub fn pixel_size(&self) -> f64 {
        self.view_height / f64::from(self.viewport[1].max(1))
    }

    /// The size of a pixel at `distance` in front of the eye, in scene units.
    pub fn pixel_size_at(&self, distance: f64) -> f64 {
        self.pixel_size() * if self.is_perspective { distance.abs() } else { 1.0 }
    }

    /// The distance in front of the eye, along the line of sight, whose depth in clip space is
    /// `depth`, in scene units.
    pub fn distance(&self, depth: f64) -> f64 {
        // Along the line of sight both z and w of clip space are linear in the distance.
        let clip = |distance: f64| {
            self.clip_from_world * (self.eye - self.backward * distance).extend(1.0)
        };
        let (at_0, at_1) = (clip(0.0), clip(1.0));
        let slope = at_1 - at_0;
        (at_0.z - depth * at_0.w) / (depth * slope.w - slope.z)
    }

    /// The rotation from world space to camera axes.
    pub fn rotation(&self) -> DMat3 {
        DMat3::from_mat4(self.camera_from_world)
    }

    /// The unit direction from `point` toward the viewer, in world space.
    pub fn toward_viewer(&self, point: DVec3) -> DVec3 {
        if self.is_perspective {
            (self.eye - point).try_normalize().unwrap_or(self.backward)
        } else {
            self.backward
        }
    }

    /// The step in which passes over the picture look around: 1/800 of the picture's height, in
    /// pixels.
    pub fn step_pixels(&self) -> u32 {
        (f64::from(self.viewport[1]) / 800.0).round().max(1.0) as u32
    }

    /// The view of a picture that is moved to the right and down, in pixels.
    #[must_use]
    pub(super) fn shifted(self, pixels: [f64; 2]) -> Self {
        // The view stays what it is to the bit.
        if pixels == [0.0; 2] {
            return self;
        }
        let [width, height] = self.viewport.map(|side| f64::from(side.max(1)));
        let shift = DVec3::new(2.0 * pixels[0] / width, -2.0 * pixels[1] / height, 0.0);
        let clip_from_world = DMat4::from_translation(shift) * self.clip_from_world;
        Self { clip_from_world, ..self }
    }

    /// The bytes of the shader's `View` uniform.
    pub fn uniform_bytes(&self) -> Vec<u8> {
        self.uniform_numbers().into_iter().flat_map(|x| (x as f32).to_le_bytes()).collect()
    }

    /// All numbers of the shader's `View` uniform, in order.
    pub fn uniform_numbers(&self) -> Vec<f64> {
        let eye =
            if self.is_perspective { self.eye.extend(1.0) } else { self.backward.extend(0.0) };
        let mut numbers = self.clip_from_world.to_cols_array().to_vec();
        numbers.extend(self.camera_from_world.to_cols_array());
        numbers.extend(eye.to_array());
        // Rows are counted from the top, as those of pixels.
        numbers.extend([1.0, 1.0, 0.0, 0.0]);
        numbers
    }
}

/// A vertical field of view that shows `widening` times the height at every depth, up to the widest
/// that a camera can have. In radians.
pub fn widened(fov: f64, widening: f64) -> f64 {
    (2.0 * ((0.5 * fov).tan() * widening).atan()).min(Camera::FOV[1])
}

/// The perspective matrix from camera axes to clip space with the vertical field of view `fov` in
/// radians; depth 0 at `near`, 1 at `far`.
fn perspective(fov: f64, aspect: f64, near: f64, far: f64) -> DMat4 {
    let scale = 1.0 / (0.5 * fov).tan();
    let depth = far / (near - far);
    DMat4::from_cols(
        DVec4::new(scale / aspect, 0.0, 0.0, 0.0),
        DVec4::new(0.0, scale, 0.0, 0.0),
        DVec4::new(0.0, 0.0, depth, -1.0),
        DVec4::new(0.0, 0.0, near * depth, 0.0),
    )
}

/// The parallel matrix from camera axes to clip space for a box of half a width and half a height;
/// depth 0 at `near`, 1 at `far`.
fn orthographic(half_width: f64, half_height: f64, near: f64, far: f64) -> DMat4 {
    let depth = 1.0 / (near - far);
    DMat4::from_cols(
        DVec4::new(1.0 / half_width, 0.0, 0.0, 0.0),
        DVec4::new(0.0, 1.0 / half_height, 0.0, 0.0),
        DVec4::new(0.0, 0.0, depth, 0.0),
        DVec4::new(0.0, 0.0, near * depth, 1.0),
    )
}

/// The shader's `Object` uniform: of a part of the object `id`, with the alpha cutoff of its
/// material and the material's number.
pub(super) fn object_uniform(
    world_from_object: DMat4,
    id: f64,
    cutoff: f64,
    material: usize,
) -> Uniform {
    let material = material as f64;
    let linear = DMat3::from_mat4(world_from_object);
    // A flattened object has no inverse; its normals are transformed as directions are.
    let normals =
        if linear.determinant().abs() > 1e-12 { linear.inverse().transpose() } else { linear };
    // Normals that are no longer than shaders are promised.
    let largest = normals.to_cols_array().into_iter().map(f64::abs).fold(0.0, f64::max);
    let normals = normals * (MAX_NORMAL_SCALE / largest.max(MAX_NORMAL_SCALE));
    let mut numbers = world_from_object.to_cols_array().to_vec();
    let mut padded = numbers.clone();
    for column in normals.to_cols_array_2d() {
        numbers.extend(column);
        padded.extend(column);
        padded.push(0.0);
    }
    numbers.extend([id, material, cutoff]);
    padded.extend([id, material, cutoff, 0.0]);
    Uniform { bytes: padded.into_iter().flat_map(|x| (x as f32).to_le_bytes()).collect(), numbers }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_target_is_in_the_middle_and_up_is_up() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let camera = Camera { eye: [3.0, 2.0, 4.0], projection, ..Camera::default() };
            let view = View::new(&camera, [200, 100], DVec3::ZERO, 1.0);
            let middle = view.clip_from_world.project_point3(DVec3::ZERO);
            assert!(
                middle.truncate().length() < 1e-12 && middle.z > 0.0 && middle.z < 1.0,
                "{middle}"
            );
            let above = view.clip_from_world.project_point3(DVec3::Y * 0.5);
            assert!(above.y > 0.1 && above.x.abs() < 1e-12);
            assert!((view.rotation() * view.backward - DVec3::Z).length() < 1e-12);
        }
    }

    #[test]
    fn a_narrow_picture_shows_what_the_camera_was_placed_for() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let camera = Camera { projection, aspect: 1.5, ..Camera::default() };
            let side = |camera: &Camera, viewport: [u32; 2]| {
                let view = View::new(camera, viewport, DVec3::ZERO, 1.0);
                let at = view.clip_from_world.project_point3(DVec3::new(0.7, 0.4, 0.0));
                (at.x, at.y)
            };
            let (x, y) = side(&camera, [300, 200]);
            let (square_x, square_y) = side(&camera, [200, 200]);
            assert!(
                (square_x - x).abs() < 1e-12 && (square_y - y / 1.5).abs() < 1e-12,
                "{square_x} {square_y}"
            );
            // A wider picture shows more at the sides, as with any camera.
            let any = Camera { aspect: 0.0, ..camera };
            assert_eq!(side(&camera, [400, 200]), side(&any, [400, 200]));
            assert_eq!(side(&camera, [300, 200]), side(&any, [300, 200]));
        }
    }

    #[test]
    fn every_field_of_view_of_the_format_is_drawn_as_it_is() {
        for fov in [Camera::FOV[0], 0.004, 0.5, 3.12, Camera::FOV[1]] {
            let camera = Camera { fov, ..Camera::default() };
            let view = View::new(&camera, [100, 100], DVec3::ZERO, 1.0);
            let height = 2.0 * (0.5 * fov).tan();
            assert!((view.view_height / height - 1.0).abs() < 1e-12, "{fov}");
            assert!(view.clip_from_world.is_finite());
        }
    }

    #[test]
    fn a_surface_before_the_near_plane_draws_it_in_and_moves_nothing() {
        let camera = Camera { eye: [0.0, 0.0, 1.001], ..Camera::default() };
        let view = View::new(&camera, [200, 100], DVec3::ZERO, 1.0);
        let near = view.distance(0.0);
        assert!(near > 0.001 && view.least_distance() > near);
        assert_eq!(view.with_surface_at(None), view);
        assert_eq!(view.with_surface_at(Some(2.0 * view.least_distance())), view);
        for distance in [1e-3, 1e-5, 0.0] {
            let moved = view.with_surface_at(Some(distance));
            let [was, is] =
                [view, moved].map(|view| view.clip_from_world * DVec4::new(0.3, -0.2, 0.9, 1.0));
            assert!(
                (was.x - is.x).abs().max((was.y - is.y).abs()) < 1e-12 && was.w == is.w,
                "{was} {is}"
            );
            assert!((moved.distance(1.0) - view.distance(1.0)).abs() < 1e-6);
            assert!(moved.distance(0.0) < distance.max(2.1e-6), "{distance}");
        }
        let parallel = Camera { projection: Projection::Orthographic, ..camera };
        assert_eq!(View::new(&parallel, [200, 100], DVec3::ZERO, 1.0).least_distance(), 0.0);
    }

    /// Normals of an object that is scaled to almost nothing are no longer than shaders are
    /// promised, and point where they did.
    #[test]
    fn normals_of_tiny_objects_keep_their_length_in_bounds() {
        for scale in [[1e-20, 1e6, 1e6], [1e-12, 1e12, 1e6], [1e6, 1e-7, 1e-5], [0.0, 1.0, 1.0]] {
            let matrix = DMat4::from_scale(DVec3::from(scale));
            let uniform = object_uniform(matrix, 0.0, 0.0, 0);
            let numbers = &uniform.numbers[16..25];
            // The scaled numbers are rounded in f64; in f32 they are below the bound.
            let is_within = |x: &f64| x.abs() <= MAX_NORMAL_SCALE * (1.0 + f64::EPSILON);
            assert!(numbers.iter().all(is_within), "{numbers:?}");
            let floats =
                uniform.bytes.chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap()));
            assert!(floats.into_iter().all(f32::is_finite));
            if scale[0] > 0.0 {
                let [x, y] = [numbers[0], numbers[4]];
                assert!((x / y / (scale[1] / scale[0]) - 1.0).abs() < 1e-9, "{x} {y}");
            }
        }
    }

    #[test]
    fn looking_straight_down_works() {
        let camera = Camera { eye: [0.0, 5.0, 0.0], ..Camera::default() };
        let view = View::new(&camera, [100, 100], DVec3::ZERO, 1.0);
        assert!(view.clip_from_world.is_finite());
    }
}
