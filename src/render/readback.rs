//! Readback of textures and buffers from the GPU.

use std::time::Duration;

use half::f16;

use super::error::RenderError;
use super::gpu::Gpu;
use crate::frame::Picture;

pub(super) async fn read_picture(
    gpu: &Gpu,
    texture: &wgpu::Texture,
) -> Result<Picture, RenderError> {
    let size = [texture.width(), texture.height()];
    let texels = read_numbers(gpu, texture).await?;
    let straight = |[r, g, b, alpha]: [f32; 4]| {
        // The target is premultiplied, and the picture straight.
        let scale = if alpha > 0.0 { 1.0 / alpha } else { 0.0 };
        [r * scale, g * scale, b * scale, alpha]
    };
    Ok(Picture { size, rgba: texels.into_iter().map(straight).collect() })
}

/// The numbers of a layer beside the picture.
pub(super) async fn read_layer(
    gpu: &Gpu,
    texture: &wgpu::Texture,
) -> Result<Vec<[f32; 3]>, RenderError> {
    let texels = read_numbers(gpu, texture).await?;
    Ok(texels.into_iter().map(|[x, y, z, _]| [x, y, z]).collect())
}

/// The texels of a target of the picture's format.
async fn read_numbers(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<[f32; 4]>, RenderError> {
    let is_precise = texture.format() == wgpu::TextureFormat::Rgba32Float;
    let texel = if is_precise { 16 } else { 8 };
    let bytes = read_texture(gpu, texture, texel).await?;
    let texels = bytes.chunks_exact(texel as usize);
    let numbers = texels.map(|pixel| {
        let channel = |i: usize| match is_precise {
            true => f32::from_le_bytes([
                pixel[4 * i],
                pixel[4 * i + 1],
                pixel[4 * i + 2],
                pixel[4 * i + 3],
            ]),
            false => f16::from_le_bytes([pixel[2 * i], pixel[2 * i + 1]]).to_f32(),
        };
        [channel(0), channel(1), channel(2), channel(3)]
    });
    Ok(numbers.collect())
}

/// The texels of a texture, without the padding that GPUs put between rows.
pub(super) async fn read_texture(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    texel_bytes: u32,
) -> Result<Vec<u8>, RenderError> {
    let row = texture.width() * texel_bytes;
    let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let size = u64::from(padded) * u64::from(texture.height());
    let limit = gpu.device.limits().max_buffer_size;
    if size > limit {
        return Err(RenderError::TooLarge { what: "the picture in bytes".to_owned(), size, limit });
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
    let bytes = read_buffer(gpu, &buffer).await;
    guard.finish().await?;
    Ok(bytes?
        .chunks_exact(padded as usize)
        .flat_map(|padded| &padded[..row as usize])
        .copied()
        .collect())
}

/// Waits for the GPU, then returns the content of a mappable buffer.
pub(super) async fn read_buffer(gpu: &Gpu, buffer: &wgpu::Buffer) -> Result<Vec<u8>, RenderError> {
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
        Err(_) => return Err(lost("what was asked for never came back".to_owned())),
    }
    let mapped = buffer.slice(..).get_mapped_range().map_err(|error| lost(error.to_string()))?;
    Ok(mapped.to_vec())
}
