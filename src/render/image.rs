//! Images and samplers on the GPU, shared by all renderers of a device.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use wgpu::util::DeviceExt as _;

use super::error::{LimitedSize, RenderError};
use super::gpu::Gpu;
use crate::compile::{ImageShape, ImageUse};
use crate::frame::Image;
use crate::hcbtf::TexelCoding;

#[derive(Debug)]
struct ImageTexture {
    /// Images that are drawn with this texture: the same image may have been read more than once.
    holders: Vec<Weak<Image>>,
    texture: wgpu::Texture,
    view: wgpu::TextureView,
}

impl ImageTexture {
    fn is_in_use(&self) -> bool {
        self.holders.iter().any(|image| image.strong_count() > 0)
    }

    /// Adds an image that is drawn with this texture from now on.
    fn hold(&mut self, image: &Arc<Image>) {
        self.holders.retain(|holder| holder.strong_count() > 0);
        if !self.holders.iter().any(|holder| std::ptr::eq(holder.as_ptr(), Arc::as_ptr(image))) {
            self.holders.push(Arc::downgrade(image));
        }
    }
}

/// Images in use and samplers. Clones share them.
#[derive(Clone, Debug, Default)]
pub(super) struct Images(Arc<Mutex<ImageTable>>);

#[derive(Debug, Default)]
struct ImageTable {
    textures: HashMap<(u64, bool), ImageTexture>,
    samplers: HashMap<(String, String), wgpu::Sampler>,
    uploads: u64,
}

/// An image with its sampler, ready to be bound.
pub(super) struct SampledImage {
    view: wgpu::TextureView,
    sampler: wgpu::Sampler,
}

impl SampledImage {
    pub(super) fn texture(&self) -> wgpu::BindingResource<'_> {
        wgpu::BindingResource::TextureView(&self.view)
    }

    pub(super) fn sampler(&self) -> wgpu::BindingResource<'_> {
        wgpu::BindingResource::Sampler(&self.sampler)
    }
}

impl Images {
    fn lock(&self) -> MutexGuard<'_, ImageTable> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Number of images that were uploaded so far.
    pub(super) fn uploads(&self) -> u64 {
        self.lock().uploads
    }

    /// Drops the textures of images that have no holder any more.
    pub(super) fn keep_recent(&self) {
        self.lock().textures.retain(|_, texture| texture.is_in_use());
    }

    /// Drops all textures: some may have been created while the device had no room for them.
    pub(super) fn clear(&self) {
        self.lock().textures.clear();
    }

    /// The images of a module, in the order of its needs.
    pub(super) fn of(
        &self,
        gpu: &Gpu,
        images: &[Arc<Image>],
        needs: &[ImageUse],
    ) -> Result<Vec<SampledImage>, RenderError> {
        let mut table = self.lock();
        let bindable = |(image, wanted): (&Arc<Image>, &ImageUse)| {
            Ok(SampledImage {
                view: table.texture(gpu, image, wanted)?,
                sampler: table.sampler(gpu, wanted),
            })
        };
        images.iter().zip(needs).map(bindable).collect()
    }
}

impl ImageTable {
    /// The texture of an image, rows from the top; image nodes flip v, which points up, themselves.
    fn texture(
        &mut self,
        gpu: &Gpu,
        image: &Arc<Image>,
        wanted: &ImageUse,
    ) -> Result<wgpu::TextureView, RenderError> {
        let key = (image.hash, wanted.is_decoded);
        if let Some(known) = self.textures.get_mut(&key) {
            known.hold(image);
            return Ok(known.view.clone());
        }
        if let Some(view) = self.changed(gpu, image, wanted) {
            return Ok(view);
        }
        let limits = gpu.device.limits();
        for (what, size, limit) in [
            (
                LimitedSize::ImageSide,
                image.size[0].max(image.size[1]),
                limits.max_texture_dimension_2d,
            ),
            (LimitedSize::HcbtfLayers, image.layers, limits.max_texture_array_layers),
        ] {
            if size > limit {
                return Err(RenderError::TooLarge { what, size: size.into(), limit: limit.into() });
            }
        }
        let size = wgpu::Extent3d {
            width: image.size[0],
            height: image.size[1],
            depth_or_array_layers: image.layers,
        };
        let descriptor = wgpu::TextureDescriptor {
            label: Some("image"),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: match image.coding {
                TexelCoding::Bc7 if gpu.has_blocks() => wgpu::TextureFormat::Bc7RgbaUnorm,
                _ if wanted.is_decoded && wanted.shape == ImageShape::Flat => {
                    wgpu::TextureFormat::Rgba8UnormSrgb
                }
                _ => wgpu::TextureFormat::Rgba8Unorm,
            },
            usage: wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        };
        let order = wgpu::util::TextureDataOrder::LayerMajor;
        let bytes = match descriptor.format {
            wgpu::TextureFormat::Bc7RgbaUnorm => Cow::Borrowed(&*image.bytes),
            _ => image.rgba(),
        };
        let texture = gpu.device.create_texture_with_data(&gpu.queue, &descriptor, order, &bytes);
        // A texture of a single layer would be viewed as a flat one by default.
        let dimension = match wanted.shape {
            ImageShape::Flat => wgpu::TextureViewDimension::D2,
            ImageShape::Hcbtf { .. } => wgpu::TextureViewDimension::D2Array,
        };
        let view = texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(dimension),
            ..wgpu::TextureViewDescriptor::default()
        });
        self.uploads += 1;
        let holders = vec![Arc::downgrade(image)];
        self.textures.insert(key, ImageTexture { holders, texture, view: view.clone() });
        Ok(view)
    }

    /// The texture of the image's former version, updated by the change between the two; `None` if
    /// there is no such texture, or if it is still drawn with. Commands that were submitted before
    /// see the former version.
    fn changed(
        &mut self,
        gpu: &Gpu,
        image: &Arc<Image>,
        wanted: &ImageUse,
    ) -> Option<wgpu::TextureView> {
        let change = image.change.as_ref()?;
        let key = (change.from, wanted.is_decoded);
        let known = self.textures.get(&key)?;
        let size = known.texture.size();
        let is_alike = [size.width, size.height] == image.size
            && size.depth_or_array_layers == image.layers
            && image.coding == TexelCoding::Rgba8;
        if !is_alike || known.is_in_use() {
            return None;
        }
        let stride = 4 * u64::from(image.size[0]);
        for region in &change.regions {
            let row = u64::from(region.layer) * u64::from(image.size[1]) + u64::from(region.at[1]);
            gpu.queue.write_texture(
                wgpu::TexelCopyTextureInfo {
                    texture: &known.texture,
                    mip_level: 0,
                    origin: wgpu::Origin3d { x: region.at[0], y: region.at[1], z: region.layer },
                    aspect: wgpu::TextureAspect::All,
                },
                &image.bytes,
                wgpu::TexelCopyBufferLayout {
                    offset: row * stride + 4 * u64::from(region.at[0]),
                    bytes_per_row: Some(4 * image.size[0]),
                    rows_per_image: Some(image.size[1]),
                },
                wgpu::Extent3d {
                    width: region.size[0],
                    height: region.size[1],
                    depth_or_array_layers: 1,
                },
            );
        }
        let ImageTexture { texture, view, .. } = self.textures.remove(&key)?;
        let holders = vec![Arc::downgrade(image)];
        let changed = ImageTexture { holders, texture, view: view.clone() };
        self.textures.insert((image.hash, wanted.is_decoded), changed);
        Some(view)
    }

    /// The sampler that an image node asks for.
    fn sampler(&mut self, gpu: &Gpu, image: &ImageUse) -> wgpu::Sampler {
        let key = (image.wrap.clone(), image.filter.clone());
        let made = || {
            let address = match image.wrap.as_str() {
                "clamp" => wgpu::AddressMode::ClampToEdge,
                "mirror" => wgpu::AddressMode::MirrorRepeat,
                _ => wgpu::AddressMode::Repeat,
            };
            let filter = if image.filter == "nearest" {
                wgpu::FilterMode::Nearest
            } else {
                wgpu::FilterMode::Linear
            };
            gpu.device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("image"),
                address_mode_u: address,
                address_mode_v: address,
                mag_filter: filter,
                min_filter: filter,
                ..wgpu::SamplerDescriptor::default()
            })
        };
        self.samplers.entry(key).or_insert_with(made).clone()
    }
}
