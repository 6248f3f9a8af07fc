//! The textures that the passes before the picture draw into.

use crate::look::{Draws, PASSES, Pass, PassOutput};
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
        let extent = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
        let make = |label, format| {
            let texture = target(device, label, extent, format);
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let of_pass = |pass: &Pass| {
            pass.outputs.iter().map(|output| make(pass.name, output.format)).collect()
        };
        let depth = make("depth", DEPTH);
        Self { size, views: PASSES.iter().map(of_pass).collect(), depth }
    }

    /// Begins a pass; `far` is the depth of the far plane.
    pub(crate) fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        index: usize,
        pass: &Pass,
        far: f32,
    ) -> wgpu::RenderPass<'e> {
        let outputs = self.views[index].iter().zip(pass.outputs);
        let attachments: Vec<_> =
            outputs.map(|(view, output)| Some(color_attachment(view, output))).collect();
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(pass.name),
            color_attachments: &attachments,
            depth_stencil_attachment: (pass.draws == Draws::Meshes)
                .then(|| depth_attachment(&self.depth, far)),
            ..Default::default()
        })
    }
}

const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

fn target(
    device: &wgpu::Device,
    label: &str,
    size: wgpu::Extent3d,
    format: wgpu::TextureFormat,
) -> wgpu::Texture {
    let is_read = !format.is_depth_stencil_format();
    let read =
        if is_read { wgpu::TextureUsages::TEXTURE_BINDING } else { wgpu::TextureUsages::empty() };
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | read,
        view_formats: &[],
    })
}

/// A texture of a pass that is cleared before it is drawn into.
fn color_attachment<'v>(
    view: &'v wgpu::TextureView,
    output: &PassOutput,
) -> wgpu::RenderPassColorAttachment<'v> {
    wgpu::RenderPassColorAttachment {
        view,
        depth_slice: None,
        resolve_target: None,
        ops: wgpu::Operations {
            load: wgpu::LoadOp::Clear(output.clear),
            store: wgpu::StoreOp::Store,
        },
    }
}
