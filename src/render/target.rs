//! Textures that passes draw into.

use std::collections::HashMap;

use super::gpu::Gpu;
use super::passes::cleared;
use crate::frame::{AovLayer, FramePlan, PassId, PassImage, TexelFormat};

/// Format of the picture: half floats, so that nothing is rounded to eight bits before the picture
/// is shown or written.
pub(super) const PICTURE: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Format of depth buffers.
pub(super) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// Format of the numbers of triangles that the picture's pixels show.
pub(super) const TRIANGLES: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;
/// Depth to which depth buffers are cleared: all that is drawn is nearer.
pub(super) const FAR_PLANE: f32 = 1.0;

/// Textures for one picture size.
#[derive(Debug, Default)]
pub(super) struct Targets {
    key: Option<([u32; 2], u32)>,
    picture: Option<wgpu::Texture>,
    /// Layers beside the picture, each with its samples where a pixel has several.
    layers: Vec<(wgpu::Texture, Option<wgpu::TextureView>)>,
    pub(super) multisampled: Option<wgpu::TextureView>,
    pub(super) depth: Option<wgpu::TextureView>,
    /// Numbers of triangles, where looks are drawn deferred.
    pub(super) triangles: Option<wgpu::TextureView>,
    /// Images that passes before the looks draw.
    images: HashMap<PassImage, wgpu::TextureView>,
    /// Depth buffers of those passes that draw meshes.
    buffers: HashMap<PassId, wgpu::TextureView>,
}

impl Targets {
    /// Creates the textures that `plan` needs and that do not exist yet. Returns true if any was
    /// created.
    pub(super) fn fit(&mut self, gpu: &Gpu, plan: &FramePlan) -> bool {
        let key = (plan.size, plan.samples);
        let mut is_new = false;
        if self.key != Some(key) {
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC;
            *self = Self {
                key: Some(key),
                picture: Some(texture(gpu, plan.size, gpu.picture, 1, usage)),
                layers: Vec::new(),
                multisampled: (plan.samples > 1)
                    .then(|| view(gpu, plan.size, gpu.picture, plan.samples)),
                depth: Some(view(gpu, plan.size, DEPTH, plan.samples)),
                triangles: None,
                images: HashMap::new(),
                buffers: HashMap::new(),
            };
            is_new = true;
        }
        if self.layers.len() != plan.aovs.len() {
            is_new = true;
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
            let layer = |_: &AovLayer| {
                let samples =
                    (plan.samples > 1).then(|| view(gpu, plan.size, gpu.picture, plan.samples));
                (texture(gpu, plan.size, gpu.picture, 1, usage), samples)
            };
            self.layers = plan.aovs.iter().map(layer).collect();
        }
        if plan.deferral.is_ok() && self.triangles.is_none() {
            is_new = true;
            self.triangles = Some(view(gpu, plan.size, TRIANGLES, 1));
        }
        // What lights see has sizes of its own.
        let is_kept = |id: &PassId| !id.writes_picture() && !id.is_of_lights() && !id.is_over();
        for pass in plan.passes.iter().map(|pass| pass.id).filter(is_kept) {
            for image in PassImage::written(pass) {
                let format = format_of(gpu, pass.row().writes[image.output].format);
                self.images.entry(image).or_insert_with(|| {
                    is_new = true;
                    view(gpu, plan.size, format, 1)
                });
            }
            if !pass.is_screen() {
                self.buffers.entry(pass).or_insert_with(|| view(gpu, plan.size, DEPTH, 1));
            }
        }
        is_new
    }

    pub(super) fn picture(&self) -> Option<&wgpu::Texture> {
        self.picture.as_ref()
    }

    /// The layers beside the picture.
    pub(super) fn layers(&self) -> impl Iterator<Item = &wgpu::Texture> {
        self.layers.iter().map(|(layer, _)| layer)
    }

    /// Views of the layers beside the picture, each with that of its samples where a pixel has
    /// several.
    pub(super) fn layer_views(&self) -> Vec<(wgpu::TextureView, Option<wgpu::TextureView>)> {
        let view =
            |layer: &wgpu::Texture| layer.create_view(&wgpu::TextureViewDescriptor::default());
        self.layers.iter().map(|(layer, samples)| (view(layer), samples.clone())).collect()
    }

    /// An image of a pass.
    pub(super) fn image(&self, image: PassImage) -> Option<&wgpu::TextureView> {
        self.images.get(&image)
    }

    /// The depth buffer of a pass that draws meshes.
    pub(super) fn buffer(&self, pass: PassId) -> Option<&wgpu::TextureView> {
        self.buffers.get(&pass)
    }

    /// Color attachments of a pass, cleared to 0.
    pub(super) fn attachments(
        &self,
        pass: PassId,
    ) -> Vec<Option<wgpu::RenderPassColorAttachment<'_>>> {
        let cleared = |image| Some(cleared(self.image(image)?, wgpu::Color::TRANSPARENT));
        PassImage::written(pass).map(cleared).collect()
    }
}

/// The texture format for a texel format.
pub(super) fn format_of(gpu: &Gpu, format: TexelFormat) -> wgpu::TextureFormat {
    match format {
        TexelFormat::Number => wgpu::TextureFormat::R32Float,
        TexelFormat::Numbers => wgpu::TextureFormat::Rgba32Float,
        TexelFormat::Picture => gpu.picture,
    }
}

pub(super) fn texture(
    gpu: &Gpu,
    size: [u32; 2],
    format: wgpu::TextureFormat,
    sample_count: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("target"),
        size: wgpu::Extent3d {
            width: size[0].max(1),
            height: size[1].max(1),
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

fn view(gpu: &Gpu, size: [u32; 2], format: wgpu::TextureFormat, samples: u32) -> wgpu::TextureView {
    let mut usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
    if samples == 1 && format != DEPTH {
        usage |= wgpu::TextureUsages::TEXTURE_BINDING;
    }
    texture(gpu, size, format, samples, usage).create_view(&wgpu::TextureViewDescriptor::default())
}
