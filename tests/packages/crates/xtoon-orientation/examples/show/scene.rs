//! Ink at the turn: made by Chiaro 0.1.0. The scene that the look was exported with, and the file
//! of a picture.

use std::error::Error;

use xtoon_orientation::{Camera, Mesh, MeshData, MeshPart};

/// Color behind the mesh, premultiplied.
pub const BACKDROP: wgpu::Color = wgpu::Color { r: 0.16, g: 0.165, b: 0.18, a: 1.0 };

/// Model matrix of the mesh.
pub const WORLD_FROM_OBJECT: [[f32; 4]; 4] = [
    [0.39729494, 0.0, 0.0, 0.0],
    [0.0, 0.39729494, 0.0, 0.0],
    [0.0, 0.0, 0.39729494, 0.0],
    [-1.1918848, 0.7945899, -0.14302619, 1.0],
];

/// The camera of a picture; `aspect` is its width over its height.
pub fn camera(aspect: f64) -> Camera {
    let eye = [0.0, 0.0, 4.4];
    let target = [0.0, 0.0, 0.0];
    let depths = [3.39, 5.41];
    Camera::perspective(eye, target, [0.0, 1.0, 0.0], 0.5, aspect, depths)
}

/// The mesh of `mesh.bin`: the numbers of vertices and of indices, vertex arrays of floats, and the
/// indices, all of four bytes.
pub fn mesh(device: &wgpu::Device) -> Result<Mesh, Box<dyn Error>> {
    let words = include_bytes!("mesh.bin").chunks_exact(4).map(|word| word.try_into());
    let words: Vec<[u8; 4]> = words.collect::<Result<_, _>>()?;
    let [vertices, indices] = [words[0], words[1]].map(|word| u32::from_le_bytes(word) as usize);
    let mut rest = &words[2..];
    let positions = take::<3>(&mut rest, vertices);
    let normals = take::<3>(&mut rest, vertices);
    let indices: Vec<u32> = rest[..indices].iter().map(|word| u32::from_le_bytes(*word)).collect();
    let parts = [MeshPart { indices: 0..6912, is_two_sided: false }];
    let data =
        MeshData { positions: &positions, normals: &normals, indices: &indices, parts: &parts };
    Ok(Mesh::new(device, &data)?)
}

/// Takes an array of vectors from the front of words.
fn take<const N: usize>(words: &mut &[[u8; 4]], count: usize) -> Vec<[f32; N]> {
    let (own, rest) = words.split_at(N * count);
    *words = rest;
    let vector = |words: &[[u8; 4]]| std::array::from_fn(|i| f32::from_le_bytes(words[i]));
    own.chunks_exact(N).map(vector).collect()
}

/// Writes a texture of four bytes a texel into a PNG file.
pub fn save(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    texture: &wgpu::Texture,
    file: &str,
) -> Result<(), Box<dyn Error>> {
    let (width, height) = (texture.width(), texture.height());
    let bytes_per_row = (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(bytes_per_row) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(bytes_per_row),
        rows_per_image: None,
    };
    let place = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(texture.as_image_copy(), place, texture.size());
    queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |_| ());
    device.poll(wgpu::PollType::wait_indefinitely())?;
    let padded = buffer.get_mapped_range(..)?;
    let mut bytes = Vec::new();
    for row in padded.chunks(bytes_per_row as usize) {
        for texel in row[..4 * width as usize].chunks_exact(4) {
            bytes.extend(straight(texel));
        }
    }
    let picture = image::RgbaImage::from_raw(width, height, bytes).ok_or("bytes are missing")?;
    Ok(picture.save(file)?)
}

/// A texel without its alpha multiplied in, as pictures are stored.
fn straight(texel: &[u8]) -> [u8; 4] {
    let alpha = texel[3];
    let divide = |x: u8| match alpha {
        0 => 0,
        _ => (255.0 * f32::from(x) / f32::from(alpha) + 0.5).min(255.0) as u8,
    };
    [divide(texel[0]), divide(texel[1]), divide(texel[2]), alpha]
}
