//! The textures that the passes before the picture draw into.

use crate::look::{PASSES, Pass};
use crate::material::depth_attachment;

/// Textures of all passes, of one size.
#[derive(Debug)]
pub(crate) struct Targets {
    pub(crate) size: [u32; 2],
    /// Views of each pass's outputs.
    pub(crate) views: Vec<Vec<wgpu::TextureView>>,
    depth: wgpu::TextureView,
}

impl Targets {
    pub(crate) fn new(device: &wgpu::Device, size: [u32; 2]) -> Self {
        let [width, height] = size.map(|side| side.max(1));
        let make = |label, format, usage| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let read = wgpu::TextureUsages::TEXTURE_BINDING;
        let of_pass = |pass: &Pass| {
            pass.outputs.iter().map(|output| make(pass.name, output.format, read)).collect()
        };
        let depth = make("depth", wgpu::TextureFormat::Depth32Float, wgpu::TextureUsages::empty());
        Self { size, views: PASSES.iter().map(of_pass).collect(), depth }
    }

    /// Begins a pass.
    pub(crate) fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        index: usize,
        pass: &Pass,
    ) -> wgpu::RenderPass<'e> {
        let attachment = |(view, output): (_, &crate::look::PassOutput)| {
            Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(output.clear),
                    store: wgpu::StoreOp::Store,
                },
            })
        };
        let attachments: Vec<_> =
            self.views[index].iter().zip(pass.outputs).map(attachment).collect();
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(pass.name),
            color_attachments: &attachments,
            depth_stencil_attachment: (pass.draws == crate::look::Draws::Meshes)
                .then(|| depth_attachment(&self.depth)),
            ..Default::default()
        })
    }
}
