//! The textures that the passes before the picture draw into.

use crate::look::{Draws, PASSES, Pass, PassOutput};
use crate::material::depth_attachment;

/// Textures of the shadow maps.
#[derive(Debug)]
pub(crate) struct ShadowTargets {
    side: u32,
    /// Textures of the passes that draw what lights see, which are the first ones.
    maps: Vec<wgpu::Texture>,
    /// Views of all layers of these.
    pub(crate) views: Vec<wgpu::TextureView>,
    depth: wgpu::TextureView,
}

impl ShadowTargets {
    pub(crate) fn new(device: &wgpu::Device, side: u32, layers: u32) -> Self {
        let make = |label, format, depth_or_array_layers| {
            let size = wgpu::Extent3d { width: side, height: side, depth_or_array_layers };
            target(device, label, size, format)
        };
        let of_lights = PASSES.iter().filter(|pass| pass.draws == Draws::Lights);
        let map = |pass: &Pass| make(pass.name, pass.outputs[0].format, layers.max(1));
        let maps: Vec<wgpu::Texture> = of_lights.map(map).collect();
        let all = wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2Array),
            ..Default::default()
        };
        let views = maps.iter().map(|map| map.create_view(&all)).collect();
        let depth = make("depth", DEPTH, 1);
        let depth = depth.create_view(&wgpu::TextureViewDescriptor::default());
        Self { side, maps, views, depth }
    }

    /// True where the maps have that side and that number of layers.
    pub(crate) fn fit(&self, side: u32, layers: u32) -> bool {
        self.side == side && self.maps[0].depth_or_array_layers() == layers.max(1)
    }

    /// Begins a pass into a layer.
    pub(crate) fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        index: usize,
        layer: u32,
    ) -> wgpu::RenderPass<'e> {
        let pass: &Pass = &PASSES[index];
        let view = self.maps[index].create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2),
            base_array_layer: layer,
            array_layer_count: Some(1),
            ..Default::default()
        });
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(pass.name),
            color_attachments: &[Some(color_attachment(&view, &pass.outputs[0]))],
            depth_stencil_attachment: Some(depth_attachment(&self.depth, 1.0)),
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
