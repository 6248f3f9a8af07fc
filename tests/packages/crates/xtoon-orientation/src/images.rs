//! The images that the look reads.

use crate::error::Error;
use crate::look::{IMAGES, Image};

/// An image on the graphics card.
#[derive(Debug)]
pub(crate) struct LookImage {
    pub(crate) view: wgpu::TextureView,
    pub(crate) sampler: wgpu::Sampler,
}

/// Uploads the images of the look.
pub(crate) fn upload(device: &wgpu::Device, queue: &wgpu::Queue) -> Result<Vec<LookImage>, Error> {
    let sampler = |image: &Image| {
        device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some(image.file),
            address_mode_u: image.wrap,
            address_mode_v: image.wrap,
            mag_filter: image.filter,
            min_filter: image.filter,
            ..Default::default()
        })
    };
    let uploaded = IMAGES.iter().map(|image| {
        let texels = read_flat(image)?;
        Ok(LookImage { view: texels.upload(device, queue, image), sampler: sampler(image) })
    });
    uploaded.collect()
}

/// The layers of a texture: rows of texels or of blocks.
struct Texels<'a> {
    size: wgpu::Extent3d,
    format: wgpu::TextureFormat,
    bytes: std::borrow::Cow<'a, [u8]>,
}

impl Texels<'_> {
    fn upload(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        image: &Image,
    ) -> wgpu::TextureView {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some(image.file),
            size: self.size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: self.format,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let side = self.format.block_dimensions().0;
        let bytes_per_block = self.format.block_copy_size(None).unwrap_or(4);
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(self.size.width / side * bytes_per_block),
            rows_per_image: Some(self.size.height / side),
        };
        queue.write_texture(texture.as_image_copy(), &self.bytes, layout, self.size);
        texture.create_view(&wgpu::TextureViewDescriptor::default())
    }
}

/// Decodes an image file.
fn read_flat<'a>(image: &Image) -> Result<Texels<'a>, Error> {
    let failed =
        |error: image::ImageError| Error::Image { file: image.file, reason: error.to_string() };
    let decoded = image::load_from_memory(image.bytes).map_err(failed)?.into_rgba8();
    let (width, height) = decoded.dimensions();
    Ok(Texels {
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        format: image.format,
        bytes: decoded.into_raw().into(),
    })
}
