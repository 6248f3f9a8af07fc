//! The scene: meshes in their places, seen by a camera.

use std::ops::Range;

use wgpu::util::DeviceExt as _;

use crate::error::Error;
use crate::math::{self, Matrix4};
use crate::uniforms;

/// A camera: where it stands and what it sees.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    pub(crate) camera_from_world: Matrix4,
    pub(crate) clip_from_camera: Matrix4,
}

impl Camera {
    /// A camera from the matrices of a renderer, each as four columns.
    ///
    /// `camera_from_world` turns and moves, and does not scale; its axes are x right, y up, z
    /// toward the viewer. `clip_from_camera` has depths from 0 (near) to 1 (far), or from 1 to 0
    /// for an [`Output`](crate::Output) whose depth is reversed.
    #[must_use]
    pub fn new(camera_from_world: [[f32; 4]; 4], clip_from_camera: [[f32; 4]; 4]) -> Self {
        Self {
            camera_from_world: math::wide(camera_from_world),
            clip_from_camera: math::wide(clip_from_camera),
        }
    }

    /// A camera in perspective. `fov` is the vertical field of view in radians, `aspect` the
    /// picture's width over its height, `depths` are the distances of the near and far plane.
    #[must_use]
    pub fn perspective(
        eye: [f64; 3],
        target: [f64; 3],
        up: [f64; 3],
        fov: f64,
        aspect: f64,
        [near, far]: [f64; 2],
    ) -> Self {
        let half = (0.5 * fov).tan();
        let depth = far / (near - far);
        let clip_from_camera = [
            [1.0 / half / aspect, 0.0, 0.0, 0.0],
            [0.0, 1.0 / half, 0.0, 0.0],
            [0.0, 0.0, depth, -1.0],
            [0.0, 0.0, near * depth, 0.0],
        ];
        Self { camera_from_world: looking(eye, target, up), clip_from_camera }
    }

    /// A camera of parallel projection. `height` is the picture's height in scene units, `aspect`
    /// its width over its height, `depths` are the distances of the near and far plane.
    #[must_use]
    pub fn orthographic(
        eye: [f64; 3],
        target: [f64; 3],
        up: [f64; 3],
        height: f64,
        aspect: f64,
        [near, far]: [f64; 2],
    ) -> Self {
        let half = 0.5 * height;
        let depth = 1.0 / (near - far);
        let clip_from_camera = [
            [1.0 / (half * aspect), 0.0, 0.0, 0.0],
            [0.0, 1.0 / half, 0.0, 0.0],
            [0.0, 0.0, depth, 0.0],
            [0.0, 0.0, near * depth, 1.0],
        ];
        Self { camera_from_world: looking(eye, target, up), clip_from_camera }
    }

    /// The camera with its depths the other way around: from 1 (near) to 0 (far), for an
    /// [`Output`](crate::Output) whose depth is reversed.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        for [_, _, depth, w] in &mut self.clip_from_camera {
            *depth = *w - *depth;
        }
        self
    }

    pub(crate) fn is_parallel(&self) -> bool {
        self.clip_from_camera[2][3] == 0.0
    }

    /// The eye in world space.
    pub(crate) fn eye(&self) -> [f64; 3] {
        let rotation = math::linear(&self.camera_from_world);
        let moved = math::xyz(self.camera_from_world[3]);
        math::transform(&math::transposed(&rotation), math::scale(moved, -1.0))
    }

    /// Unit direction toward the viewer, in world space.
    pub(crate) fn toward(&self) -> [f64; 3] {
        let axes = math::transposed(&math::linear(&self.camera_from_world));
        math::unit_or(axes[2], [0.0, 0.0, 1.0])
    }

    /// Bytes of the camera's uniform.
    pub(crate) fn uniform(&self) -> Vec<u8> {
        let clip_from_world = math::product(&self.clip_from_camera, &self.camera_from_world);
        let ([x, y, z], w) =
            if self.is_parallel() { (self.toward(), 0.0) } else { (self.eye(), 1.0) };
        uniforms::view(clip_from_world, self.camera_from_world, [x, y, z, w])
    }
}

/// The matrix from the world to the axes of a camera that looks at a target.
fn looking(eye: [f64; 3], target: [f64; 3], up: [f64; 3]) -> Matrix4 {
    let backward = math::unit_or(math::subtract(eye, target), [0.0, 0.0, 1.0]);
    let other = if backward[1].abs() < 0.9 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let instead = math::unit_or(math::cross(other, backward), [1.0, 0.0, 0.0]);
    let right = math::unit_or(math::cross(up, backward), instead);
    let rotation = math::transposed(&[right, math::cross(backward, right), backward]);
    let moved = math::transform(&rotation, math::scale(eye, -1.0));
    let column = |[x, y, z]: [f64; 3], w| [x, y, z, w];
    let [x, y, z] = rotation.map(|axis| column(axis, 0.0));
    [x, y, z, column(moved, 1.0)]
}

/// Vertices and triangles of a mesh, in object space.
#[derive(Clone, Copy, Debug, Default)]
pub struct MeshData<'a> {
    /// Positions of the vertices.
    pub positions: &'a [[f32; 3]],
    /// Unit normals, one for each position.
    pub normals: &'a [[f32; 3]],
    /// Three vertices for each triangle, counterclockwise seen from its front.
    pub indices: &'a [u32],
    /// Parts of the mesh, one for each of its materials; none for one closed part.
    pub parts: &'a [MeshPart],
}

/// A part of a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshPart {
    /// Indices of the part.
    pub indices: Range<u32>,
    /// True for an open part, whose backs are seen.
    pub is_two_sided: bool,
}

/// A mesh that is on the graphics card already: arrays as those of [`MeshData`], each in a buffer
/// of its own, from its start on and without gaps. Buffers may be larger than what they hold.
#[derive(Clone, Debug)]
pub struct MeshBuffers {
    /// Positions: three floats for each vertex.
    pub positions: wgpu::Buffer,
    /// Unit normals: three floats for each vertex.
    pub normals: wgpu::Buffer,
    /// Number of vertices.
    pub vertex_count: u32,
    /// Indices of 32 bits, three for each triangle, counterclockwise seen from its front.
    pub indices: wgpu::Buffer,
    /// Number of indices.
    pub index_count: u32,
    /// Parts of the mesh, one for each of its materials; none for one closed part.
    pub parts: Vec<MeshPart>,
    /// Middle of the box around the positions.
    pub middle: [f32; 3],
    /// Distance of the farthest vertex from the middle.
    pub radius: f32,
}

/// A mesh on the graphics card.
#[derive(Clone, Debug)]
pub struct Mesh {
    pub(crate) position: wgpu::Buffer,
    pub(crate) normal: wgpu::Buffer,
    pub(crate) indices: wgpu::Buffer,
    pub(crate) parts: Vec<MeshPart>,
    /// Middle of the mesh's box, in object space.
    pub(crate) middle: [f64; 3],
    /// Distance of the farthest vertex from the middle.
    pub(crate) radius: f64,
}

impl Mesh {
    /// Uploads a mesh.
    ///
    /// # Errors
    /// A mesh without triangles; an array that has not one entry for each position; an index beyond
    /// the vertices, or a part beyond the indices.
    pub fn new(device: &wgpu::Device, data: &MeshData<'_>) -> Result<Self, Error> {
        let vertices = data.positions.len();
        let lengths = [("normals", data.normals.len())];
        for (name, length) in lengths {
            if length != vertices {
                let reason = format!("it has {vertices} positions and {length} {name}");
                return Err(Error::Mesh { reason });
            }
        }
        if let Some(index) = data.indices.iter().find(|index| **index as usize >= vertices) {
            let reason = format!("index {index} is beyond the last of {vertices} vertices");
            return Err(Error::Mesh { reason });
        }
        let index_count = data.indices.len() as u32;
        let parts = checked_parts(index_count, data.parts)?;
        let (middle, radius) = bounds(data.positions);
        let indices = data.indices.iter().flat_map(|index| index.to_le_bytes()).collect();
        Ok(Self {
            position: vertex_buffer(device, data.positions),
            normal: vertex_buffer(device, data.normals),
            indices: buffer(device, indices, wgpu::BufferUsages::INDEX),
            parts,
            middle,
            radius,
        })
    }

    /// A mesh of buffers that are on the graphics card already.
    ///
    /// # Errors
    /// A buffer that is too small for what it is to hold, or that was not made for it; a mesh
    /// without triangles, or a part beyond the indices. Indices are not looked at.
    pub fn from_buffers(buffers: MeshBuffers) -> Result<Self, Error> {
        let vertices = (wgpu::BufferUsages::VERTEX, buffers.vertex_count);
        let indices = (wgpu::BufferUsages::INDEX, buffers.index_count);
        let all = [
            ("positions", &buffers.positions, vertices, 12),
            ("normals", &buffers.normals, vertices, 12),
            ("indices", &buffers.indices, indices, 4),
        ];
        for (name, buffer, (usage, count), stride) in all {
            if !buffer.usage().contains(usage) {
                let reason = format!("the buffer of {name} has not the usage {usage:?}");
                return Err(Error::Mesh { reason });
            }
            let (size, least) = (buffer.size(), u64::from(count) * stride);
            if size < least {
                let reason =
                    format!("{count} {name} take {least} bytes, and their buffer has {size}");
                return Err(Error::Mesh { reason });
            }
        }
        Ok(Self {
            parts: checked_parts(buffers.index_count, &buffers.parts)?,
            position: buffers.positions,
            normal: buffers.normals,
            indices: buffers.indices,
            middle: buffers.middle.map(f64::from),
            radius: buffers.radius.into(),
        })
    }

    /// The model matrix that moves the mesh to the origin and scales it to radius 1, for which
    /// looks are made: curvature, lines and noise are measured in scene units.
    #[must_use]
    pub fn fit(&self) -> [[f32; 4]; 4] {
        let scale = 1.0 / self.radius.max(1e-20);
        let [x, y, z] = self.middle.map(|it| (-scale * it) as f32);
        let scale = scale as f32;
        [[scale, 0.0, 0.0, 0.0], [0.0, scale, 0.0, 0.0], [0.0, 0.0, scale, 0.0], [x, y, z, 1.0]]
    }
}

/// Parts of a mesh with that number of indices, or why it cannot be drawn.
fn checked_parts(index_count: u32, parts: &[MeshPart]) -> Result<Vec<MeshPart>, Error> {
    let whole = MeshPart { indices: 0..index_count, is_two_sided: false };
    let is_drawn = |part: &MeshPart| {
        let Range { start, end } = part.indices;
        start < end && end <= index_count && (end - start) % 3 == 0
    };
    if let Some(part) = parts.iter().chain([&whole]).find(|part| !is_drawn(part)) {
        let range = &part.indices;
        let reason = format!("indices {range:?} of {index_count} are no triangles of three each");
        return Err(Error::Mesh { reason });
    }
    Ok(if parts.is_empty() { vec![whole] } else { parts.to_vec() })
}

fn buffer(device: &wgpu::Device, bytes: Vec<u8>, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("mesh"),
        contents: &bytes,
        usage,
    })
}

fn vertex_buffer<const N: usize>(device: &wgpu::Device, vectors: &[[f32; N]]) -> wgpu::Buffer {
    let bytes = vectors.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
    buffer(device, bytes, wgpu::BufferUsages::VERTEX)
}

/// Middle of the box of positions, and the distance of the farthest from there.
fn bounds(positions: &[[f32; 3]]) -> ([f64; 3], f64) {
    let Some(first) = positions.first() else { return ([0.0; 3], 0.0) };
    let (mut low, mut high) = (*first, *first);
    for position in positions {
        for axis in 0..3 {
            low[axis] = low[axis].min(position[axis]);
            high[axis] = high[axis].max(position[axis]);
        }
    }
    let middle = std::array::from_fn(|axis| 0.5 * (f64::from(low[axis]) + f64::from(high[axis])));
    let distance =
        |position: &[f32; 3]| math::length(math::subtract(position.map(f64::from), middle));
    (middle, positions.iter().map(distance).fold(0.0, f64::max))
}

/// A mesh in its place.
#[derive(Clone, Copy, Debug)]
pub struct Object<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Model matrix, as four columns; [`Mesh::fit`] gives the one that looks are made for.
    pub world_from_object: [[f32; 4]; 4],
}

impl Object<'_> {
    pub(crate) fn matrix(&self) -> Matrix4 {
        math::wide(self.world_from_object)
    }

    /// Middle of the mesh's box, in world space.
    pub(crate) fn middle(&self) -> [f64; 3] {
        math::transform_point(&self.matrix(), self.mesh.middle)
    }

    /// Radius of a sphere around the middle that holds the mesh, in world space.
    pub(crate) fn radius(&self) -> f64 {
        let scale = math::linear(&self.matrix()).map(math::length);
        self.mesh.radius * scale.into_iter().fold(0.0, f64::max)
    }

    /// True where the model matrix mirrors.
    pub(crate) fn is_mirrored(&self) -> bool {
        let [x, y, z] = math::linear(&self.matrix());
        math::dot(x, math::cross(y, z)) < 0.0
    }
}
