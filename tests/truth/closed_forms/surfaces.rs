//! Surfaces that are known at every point, with meshes of them.

use std::f64::consts::TAU;

use chiaro::document::{Camera, Projection};
use chiaro::geometry::{Mesh, MeshPart};
use glam::{DMat3, DVec3};

/// Inputs of a look at a point. Vectors in world space, of any length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) normal: DVec3,
    /// Direction toward the eye.
    pub(crate) view: DVec3,
    /// Curvature, convex positive. In 1/viewport-height.
    pub(crate) kappa: f64,
}

/// A camera that looks down the z axis, y up, and the rays through its pixels.
pub(crate) struct Eye {
    camera: Camera,
    size: [f64; 2],
}

impl Eye {
    pub(crate) fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let [x, y, _] = camera.eye;
        assert!(camera.target == [0.0; 3] && camera.up == [0.0, 1.0, 0.0] && [x, y] == [0.0; 2]);
        Self { camera: *camera, size: size.map(f64::from) }
    }

    /// Rotation from world to camera axes, which are the same here.
    pub(crate) fn camera_from_world(&self) -> DMat3 {
        DMat3::IDENTITY
    }

    /// Origin and direction of the ray through a pixel's middle.
    fn ray(&self, pixel: [u32; 2]) -> [DVec3; 2] {
        // Coordinates from the middle of the picture, y up. In picture heights.
        let x = (f64::from(pixel[0]) + 0.5 - 0.5 * self.size[0]) / self.size[1];
        let y = 0.5 - (f64::from(pixel[1]) + 0.5) / self.size[1];
        let eye = DVec3::from(self.camera.eye);
        match self.camera.projection {
            Projection::Perspective => {
                let height = 2.0 * (0.5 * self.camera.fov).tan();
                [eye, DVec3::new(x * height, y * height, -1.0)]
            }
            Projection::Orthographic => {
                let height = self.camera.height;
                [DVec3::new(x * height, y * height, eye.z), DVec3::NEG_Z]
            }
        }
    }

    /// Height of the picture at a distance in front of the eye. In scene units.
    fn height_at(&self, distance: f64) -> f64 {
        match self.camera.projection {
            Projection::Perspective => 2.0 * (0.5 * self.camera.fov).tan() * distance,
            Projection::Orthographic => self.camera.height,
        }
    }
}

pub(crate) trait Surface {
    /// Points of a 2x2 quad of pixels for the fragment `own`, which lies on the surface. The other
    /// pixels only serve its derivatives, and lie on the plane of its triangle. `None` where the
    /// points are not known.
    fn quad(&self, eye: &Eye, pixels: [[u32; 2]; 4], own: usize) -> Option<[Point; 4]>;
    fn mesh(&self) -> Mesh;
}

/// The plane z = 0, larger than the picture, with the normal (x TURN, y TURN, 1) at (x, y, 0): a
/// bump without height. Normals are linear on the plane, as interpolated ones are.
pub(crate) struct Plane;

/// Half of the plane's side. In scene units.
const REACH: f32 = 2.0;
/// Slope of the normals along x and y.
const TURN: f64 = 1.5;

impl Surface for Plane {
    fn quad(&self, eye: &Eye, pixels: [[u32; 2]; 4], _: usize) -> Option<[Point; 4]> {
        Some(pixels.map(|pixel| {
            let [from, along] = eye.ray(pixel);
            let at = from - along * (from.z / along.z);
            // nx / nz = x TURN: kappa = (TURN + TURN) / 2 in 1/scene-unit.
            let kappa = TURN * eye.height_at(from.z);
            Point { normal: DVec3::new(at.x * TURN, at.y * TURN, 1.0), view: -along, kappa }
        }))
    }

    fn mesh(&self) -> Mesh {
        let corners = [[-REACH, -REACH], [REACH, -REACH], [REACH, REACH], [-REACH, REACH]];
        let turn = TURN as f32;
        mesh(
            corners.map(|[x, y]| [x, y, 0.0]).to_vec(),
            corners.map(|[x, y]| [x * turn, y * turn, 1.0]).to_vec(),
            vec![0, 1, 2, 0, 2, 3],
        )
    }
}

/// The unit sphere, x^2 + y^2 + z^2 = 1, of which a cap is known.
pub(crate) struct Sphere {
    /// The smallest cosine between normal and line of sight within the cap; n.z in parallel
    /// projection.
    pub(crate) least_facing: f64,
}

impl Sphere {
    fn meet(&self, [from, along]: [DVec3; 2]) -> Option<DVec3> {
        let (a, b, c) = (along.length_squared(), along.dot(from), from.length_squared() - 1.0);
        let root = b * b - a * c;
        let at = from - along * ((b + root.max(0.0).sqrt()) / a);
        (root > 0.0 && at.dot(-along.normalize()) >= self.least_facing).then_some(at)
    }
}

impl Surface for Sphere {
    fn quad(&self, eye: &Eye, pixels: [[u32; 2]; 4], own: usize) -> Option<[Point; 4]> {
        // At the picture's sides curvature is measured from one side only, and so less exactly.
        let is_inside =
            |pixel: [u32; 2]| (0..2).all(|i| (4..eye.size[i] as u32 - 4).contains(&pixel[i]));
        let middle = pixels
            .iter()
            .all(|pixel| is_inside(*pixel))
            .then(|| self.meet(eye.ray(pixels[own])))??;
        let mut points = [None; 4];
        for (point, pixel) in points.iter_mut().zip(pixels) {
            let [from, along] = eye.ray(pixel);
            let on_sphere = self.meet([from, along])?;
            // The triangle touches the sphere at the fragment, up to the triangle's size.
            let on_plane = from + along * ((1.0 - middle.dot(from)) / middle.dot(along));
            let z = on_sphere.z;
            let kappa = match eye.camera.projection {
                Projection::Orthographic => {
                    (1.0 + z * z) / (2.0 * z.powi(3)) * eye.height_at(from.z)
                }
                // No test asks for curvature in perspective.
                Projection::Perspective => 0.0,
            };
            *point = Some(Point { normal: on_plane, view: -along, kappa });
        }
        let [a, b, c, d] = points;
        Some([a?, b?, c?, d?])
    }

    /// A mesh of the half toward the eye, in rings around the z axis.
    fn mesh(&self) -> Mesh {
        const RINGS: u32 = 384;
        const AROUND: u32 = 768;
        let mut positions = vec![[0.0, 0.0, 1.0_f32]];
        let mut indices = Vec::new();
        for ring in 1..=RINGS {
            let theta = 0.25 * TAU * f64::from(ring) / f64::from(RINGS);
            for step in 0..AROUND {
                let phi = TAU * f64::from(step) / f64::from(AROUND);
                let at = [theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()];
                positions.push(at.map(|x| x as f32));
                let next = (step + 1) % AROUND;
                let (outer, inner) =
                    (1 + (ring - 1) * AROUND, (1 + ring.saturating_sub(2) * AROUND, ring > 1));
                match inner {
                    (inner, true) => {
                        indices.extend([inner + step, outer + step, outer + next]);
                        indices.extend([inner + step, outer + next, inner + next]);
                    }
                    _ => indices.extend([0, outer + step, outer + next]),
                }
            }
        }
        mesh(positions.clone(), positions, indices)
    }
}

fn mesh(positions: Vec<[f32; 3]>, normals: Vec<[f32; 3]>, indices: Vec<u32>) -> Mesh {
    let count = positions.len();
    let part = MeshPart { indices: 0..indices.len() as u32, ..MeshPart::default() };
    Mesh {
        positions,
        normals,
        tangents: vec![[1.0, 0.0, 0.0, 1.0]; count],
        uvs: vec![[0.0; 2]; count],
        colors: vec![[1.0; 4]; count],
        indices,
        parts: vec![part],
        ..Mesh::default()
    }
}
