//! The numbers that a frame's shaders read, in one buffer.

use std::sync::Arc;

use crate::math::{self, Matrix4};

/// Place of a uniform in the frame's buffer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    offset: u64,
    size: u64,
}

impl Place {
    pub(crate) fn of(self, buffer: &wgpu::Buffer) -> wgpu::BindingResource<'_> {
        let size = wgpu::BufferSize::new(self.size);
        wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer, offset: self.offset, size })
    }
}

/// Uniforms of a frame, collected until all are known.
pub(crate) struct Uniforms {
    bytes: Vec<u8>,
    alignment: usize,
}

impl Uniforms {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        let alignment = device.limits().min_uniform_buffer_offset_alignment as usize;
        Self { bytes: Vec::new(), alignment }
    }

    /// Adds the bytes of a uniform.
    pub(crate) fn add(&mut self, bytes: &[u8]) -> Place {
        self.bytes.resize(self.bytes.len().next_multiple_of(self.alignment), 0);
        let place = Place { offset: self.bytes.len() as u64, size: bytes.len() as u64 };
        self.bytes.extend_from_slice(bytes);
        place
    }
}

/// Buffers for the uniforms of frames. Each has a token that is held wherever the buffer is still
/// needed: a picture, and what is drawn of it until the graphics card is done.
#[derive(Debug, Default)]
pub(crate) struct UniformBuffers(Vec<(wgpu::Buffer, Arc<()>)>);

impl UniformBuffers {
    /// Uploads the uniforms of a frame into a buffer that is needed no more, or into a new one, and
    /// returns it with its token.
    pub(crate) fn upload(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        uniforms: &Uniforms,
    ) -> (wgpu::Buffer, Arc<()>) {
        let size = uniforms.bytes.len() as u64;
        let is_free = |(_, token): &(wgpu::Buffer, Arc<()>)| Arc::strong_count(token) == 1;
        // Those that have become too small are let go.
        self.0.retain(|it| !is_free(it) || it.0.size() >= size);
        let (buffer, token) = match self.0.iter().find(|it| is_free(it)) {
            Some(free) => free.clone(),
            None => {
                let buffer = device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("uniforms"),
                    size: size.next_power_of_two(),
                    usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                });
                let new = (buffer, Arc::new(()));
                self.0.push(new.clone());
                new
            }
        };
        queue.write_buffer(&buffer, 0, &uniforms.bytes);
        (buffer, token)
    }
}

/// Bytes of numbers, filled up with zeros to a multiple of 16.
pub(crate) fn bytes(numbers: impl IntoIterator<Item = f64>) -> Vec<u8> {
    let words = numbers.into_iter().flat_map(|number| (number as f32).to_le_bytes());
    let mut bytes: Vec<u8> = words.collect();
    bytes.resize(bytes.len().next_multiple_of(16), 0);
    bytes
}

/// Columns of three numbers, each on 16 bytes.
fn columns(matrix: math::Matrix3) -> impl Iterator<Item = f64> {
    matrix.into_iter().flat_map(|[x, y, z]| [x, y, z, 0.0])
}

/// Bytes of the uniform `view`. `eye` is the eye and 1, or the direction toward the viewer of a
/// parallel view and 0.
pub(crate) fn view(clip_from_world: Matrix4, camera_from_world: Matrix4, eye: [f64; 4]) -> Vec<u8> {
    let matrices = [clip_from_world, camera_from_world].into_iter().flatten().flatten();
    // The last four say that rows are counted from the top.
    bytes(matrices.chain(eye).chain([1.0, 1.0, 0.0, 0.0]))
}

/// Bytes of the uniform `object`. `id` counts objects from 0, `material` the parts of one.
pub(crate) fn object(world_from_object: Matrix4, id: usize, material: usize) -> Vec<u8> {
    let world_from_normal = math::inverse_transpose(&math::linear(&world_from_object));
    let matrices = world_from_object.into_iter().flatten().chain(columns(world_from_normal));
    bytes(matrices.chain([id as f64, material as f64]))
}

/// Bytes of the uniform of passes over the picture. `pixel` is the size of a pixel in scene units:
/// at depth 1 in perspective, at every depth otherwise.
pub(crate) fn numbers(pixel: f64, is_parallel: bool, height: u32, samples: u32) -> Vec<u8> {
    let perspective = f64::from(u8::from(!is_parallel));
    let rows_up = 0.0;
    bytes([pixel, perspective, height.into(), rows_up, samples.into()])
}

/// Bytes of the look's own numbers, one for each four bytes; `integers` are those that are read as
/// integers.
pub(crate) fn look<const N: usize>(numbers: [f64; N], integers: &[usize]) -> Vec<u8> {
    let word = |(index, number): (usize, f64)| {
        if integers.contains(&index) {
            return (number as i32).to_le_bytes();
        }
        let number = if number.is_nan() { 0.0 } else { number };
        (number.clamp(f32::MIN.into(), f32::MAX.into()) as f32).to_le_bytes()
    };
    numbers.into_iter().enumerate().flat_map(word).collect()
}
