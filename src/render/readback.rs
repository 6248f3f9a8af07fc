//! Readback of textures and buffers from the GPU.

use std::time::Duration;

use chiaro_locale::tr;
use half::f16;

use super::error::{LimitedSize, RenderError};
use super::gpu::Gpu;
use crate::frame::Picture;

pub(super) async fn read_picture(
    gpu: &Gpu,
    texture: &wgpu::Texture,
) -> Result<Picture, RenderError> {
    let size = [texture.width(), texture.height()];
    let straight = |[r, g, b, alpha]: [f32; 4]| {
        // The target is premultiplied, and the picture straight.
        let scale = if alpha > 0.0 { 1.0 / alpha } else { 0.0 };
        [r * scale, g * scale, b * scale, alpha]
    };
    Ok(Picture { size, rgba: read_numbers(gpu, texture, straight).await? })
}

/// The numbers of a layer beside the picture.
pub(super) async fn read_layer(
    gpu: &Gpu,
    texture: &wgpu::Texture,
) -> Result<Vec<[f32; 3]>, RenderError> {
    read_numbers(gpu, texture, |[x, y, z, _]| [x, y, z]).await
}

/// The texels of a target of the picture's format, each made into what is wanted of it.
async fn read_numbers<T>(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    make: impl Fn([f32; 4]) -> T,
) -> Result<Vec<T>, RenderError> {
    let is_precise = texture.format() == wgpu::TextureFormat::Rgba32Float;
    let mut numbers = Vec::with_capacity(texture.width() as usize * texture.height() as usize);
    let texel = if is_precise { 16 } else { 8 };
    // Rows as they lie in the GPU's memory: pictures of film have so many numbers that each copy
    // would take as long as the drawing.
    read_rows(gpu, texture, texel, |row| match is_precise {
        true => numbers.extend(row.as_chunks().0.iter().map(|texel: &[u8; 16]| {
            let channels = texel.as_chunks().0;
            make([0, 1, 2, 3].map(|channel: usize| f32::from_le_bytes(channels[channel])))
        })),
        false => numbers.extend(row.as_chunks().0.iter().map(|texel: &[u8; 8]| {
            let channels = texel.as_chunks().0;
            make([0, 1, 2, 3].map(|channel: usize| f16::from_le_bytes(channels[channel]).to_f32()))
        })),
    })
    .await?;
    Ok(numbers)
}

/// The texels of a texture, without the padding that GPUs put between rows.
pub(super) async fn read_texture(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    texel_bytes: u32,
) -> Result<Vec<u8>, RenderError> {
    let mut bytes = Vec::new();
    read_rows(gpu, texture, texel_bytes, |row| bytes.extend_from_slice(row)).await?;
    Ok(bytes)
}

/// Rows of a texture from the top, each as its texels.
async fn read_rows(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    texel_bytes: u32,
    mut take: impl FnMut(&[u8]),
) -> Result<(), RenderError> {
    let row = texture.width() * texel_bytes;
    let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let size = u64::from(padded) * u64::from(texture.height());
    let limit = gpu.device.limits().max_buffer_size;
    if size > limit {
        return Err(RenderError::TooLarge { what: LimitedSize::PictureBytes, size, limit });
    }
    let guard = gpu.guard();
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("readback"),
        size,
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu
        .device
        .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("readback") });
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(padded),
        rows_per_image: None,
    };
    let target = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(texture.as_image_copy(), target, texture.size());
    gpu.queue.submit([encoder.finish()]);
    let is_read = read_mapped(gpu, &buffer, |bytes| {
        bytes.chunks_exact(padded as usize).for_each(|padded| take(&padded[..row as usize]));
    });
    guard.finish().await?;
    is_read
}

/// Waits for the GPU, then returns the content of a mappable buffer.
pub(super) fn read_buffer(gpu: &Gpu, buffer: &wgpu::Buffer) -> Result<Vec<u8>, RenderError> {
    read_mapped(gpu, buffer, <[u8]>::to_vec)
}

/// Waits for the GPU, then shows the content of a mappable buffer.
fn read_mapped<T>(
    gpu: &Gpu,
    buffer: &wgpu::Buffer,
    look: impl FnOnce(&[u8]) -> T,
) -> Result<T, RenderError> {
    /// Timeout of the mapping. Another thread that waits for the same device may be the one that
    /// delivers the result, and may do so a moment after this thread has seen that nothing is left
    /// to wait for.
    const PATIENCE: Duration = Duration::from_secs(30);
    let (tell, told) = std::sync::mpsc::sync_channel(1);
    buffer.slice(..).map_async(wgpu::MapMode::Read, move |mapped| drop(tell.send(mapped)));
    let lost = |message: String| RenderError::Lost { message };
    gpu.wait()?;
    match told.recv_timeout(PATIENCE) {
        Ok(Ok(())) => {}
        Ok(Err(error)) => return Err(lost(error.to_string())),
        Err(_) => return Err(lost(tr!("what was asked for never came back").to_owned())),
    }
    let mapped = buffer.slice(..).get_mapped_range().map_err(|error| lost(error.to_string()))?;
    Ok(look(&mapped))
}
