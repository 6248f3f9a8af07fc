//! Shadow maps on the GPU: one texture a pass, with a layer for each light that asks. A layer is
//! drawn anew only when its light or its casters moved.

use std::collections::HashMap;
use std::num::NonZeroU64;
use std::sync::Arc;

use chiaro_locale::tr;

use super::gpu::Gpu;
use super::passes::{
    DepthTest, PipelineParts, UNFILTERED, depth_attachment, layout_of, targets_of, texels_type,
    uniform, uniform_type,
};
use super::pipeline::vertex_attribute;
use super::target::{DEPTH, format_of};
use crate::compile::{Needs, VertexAttribute};
use crate::frame::{FramePlan, LightModule, PassId, ShadowMaps};
use crate::{RenderError, Renderer};

/// Textures of what lights see, and the pipelines that draw them.
#[derive(Debug, Default)]
pub(crate) struct LightTargets {
    side: u32,
    layers: u32,
    depth: Option<wgpu::TextureView>,
    textures: HashMap<PassId, wgpu::Texture>,
    /// Hashes of the layers that were drawn, by pass.
    drawn: HashMap<PassId, Vec<u64>>,
    pipelines: HashMap<PassId, LightPipeline>,
}

/// The fixed pipeline of a pass that draws what lights see.
#[derive(Debug)]
struct LightPipeline {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    reads: Option<PassId>,
}

impl LightPipeline {
    fn new(gpu: &Gpu, pass: PassId) -> Result<Self, RenderError> {
        let refused = |message: String| RenderError::Refused { message };
        let module = LightModule::of(pass)
            .map_err(|problems| refused(problems[0].message.clone()))?
            .ok_or_else(|| refused(tr!("`{pass}` draws no lights", pass = pass.label())))?;
        let numbers = [(0, uniform_type(true)), (1, uniform_type(true))];
        let layers = texels_type(UNFILTERED, wgpu::TextureViewDimension::D2Array);
        let bindings = numbers.into_iter().chain(module.reads.map(|_| (2, layers)));
        let stages = wgpu::ShaderStages::VERTEX_FRAGMENT;
        let layout = layout_of(&gpu.device, pass.label(), stages, bindings);
        let attributes = [vertex_attribute(VertexAttribute::Position)];
        let buffer = wgpu::VertexBufferLayout {
            array_stride: attributes[0].format.size(),
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &attributes,
        };
        let parts = PipelineParts {
            label: pass.label(),
            text: &module.text,
            layouts: &[Some(&layout)],
            buffers: &[Some(buffer)],
            primitive: wgpu::PrimitiveState::default(),
            depth: Some(DepthTest::Nearest),
            samples: 1,
            targets: &targets_of(gpu, pass),
        };
        let pipeline = parts.pipeline(&gpu.device);
        Ok(Self { pipeline, layout, reads: module.reads })
    }
}

impl LightTargets {
    /// Creates the textures of the plan's passes. Returns true where any was created, and drops
    /// them where no light is asked about.
    fn fit(&mut self, gpu: &Gpu, plan: &FramePlan) -> bool {
        let Some(maps) = &plan.shadow_maps else {
            self.textures.clear();
            self.drawn.clear();
            self.depth = None;
            return false;
        };
        // A texture of a single layer would be bound as one of no layers in some APIs.
        let layers = maps.layers.len().max(2) as u32;
        if (self.side, self.layers) != (maps.side, layers) || self.depth.is_none() {
            (self.side, self.layers) = (maps.side, layers);
            self.textures.clear();
            self.drawn.clear();
            self.depth = Some(layered(gpu, maps.side, 1, DEPTH).create_view(&one_layer(0)));
        }
        let mut is_new = false;
        for pass in plan.passes.iter().map(|pass| pass.id).filter(|pass| pass.is_of_lights()) {
            self.textures.entry(pass).or_insert_with(|| {
                is_new = true;
                layered(gpu, maps.side, layers, format_of(gpu, pass.row().writes[0].format))
            });
        }
        is_new
    }

    /// Forgets what was drawn: the layers are of unknown content.
    pub(crate) fn forget(&mut self) {
        self.drawn.clear();
    }

    /// All layers of those passes that a module reads, ready to be bound.
    pub(crate) fn views(&self, needs: &Needs) -> Vec<(PassId, wgpu::TextureView)> {
        let view =
            |pass: PassId| Some((pass, self.textures.get(&pass)?.create_view(&all_layers())));
        needs.passes().filter_map(view).collect()
    }

    /// Layers that hold nothing, for looks that are evaluated without a scene.
    pub(crate) fn empty(gpu: &Gpu) -> wgpu::TextureView {
        let format = wgpu::TextureFormat::Rgba32Float;
        layered(gpu, 1, 2, format).create_view(&all_layers())
    }
}

fn all_layers() -> wgpu::TextureViewDescriptor<'static> {
    wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..wgpu::TextureViewDescriptor::default()
    }
}

fn one_layer(layer: u32) -> wgpu::TextureViewDescriptor<'static> {
    wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2),
        base_array_layer: layer,
        array_layer_count: Some(1),
        ..wgpu::TextureViewDescriptor::default()
    }
}

fn layered(gpu: &Gpu, side: u32, layers: u32, format: wgpu::TextureFormat) -> wgpu::Texture {
    let mut usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
    if format != DEPTH {
        usage |= wgpu::TextureUsages::TEXTURE_BINDING;
    }
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("shadow maps"),
        size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: layers },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

/// Uniforms one after another, with the place of each.
fn packed<'u>(alignment: usize, uniforms: impl Iterator<Item = &'u [u8]>) -> (Vec<u8>, Vec<u32>) {
    let (mut bytes, mut places) = (Vec::new(), Vec::new());
    for uniform in uniforms {
        bytes.resize(bytes.len().next_multiple_of(alignment), 0);
        places.push(bytes.len() as u32);
        bytes.extend_from_slice(uniform);
    }
    (bytes, places)
}

impl Renderer {
    /// Makes room for what lights see. Returns true where passes have to be drawn anew.
    pub(crate) fn prepare_shadow_maps(&mut self, plan: &FramePlan) -> Result<bool, RenderError> {
        if let Some(maps) = &plan.shadow_maps {
            self.gpu.check_size([maps.side; 2])?;
        }
        Ok(self.lights.fit(&self.gpu, plan))
    }

    /// Draws what lights see: those layers whose lights or casters moved. Returns true if any did.
    pub(crate) fn draw_lights(
        &mut self,
        plan: &FramePlan,
        pass: PassId,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<bool, RenderError> {
        let Some(maps) = plan.shadow_maps.as_ref().filter(|maps| !maps.layers.is_empty()) else {
            return Ok(false);
        };
        if !self.lights.pipelines.contains_key(&pass) {
            self.lights.pipelines.insert(pass, LightPipeline::new(&self.gpu, pass)?);
        }
        let LightTargets { textures, drawn, pipelines, depth, .. } = &mut self.lights;
        let (Some(light), Some(texture), Some(depth)) =
            (pipelines.get(&pass), textures.get(&pass), depth.as_ref())
        else {
            return Ok(false);
        };
        let drawn = drawn.entry(pass).or_default();
        drawn.resize(maps.layers.len(), 0);
        let layers = maps.layers.iter().enumerate();
        let moved: Vec<_> = layers.filter(|(number, layer)| drawn[*number] != layer.hash).collect();
        if moved.is_empty() {
            return Ok(false);
        }
        let group = light_group(&self.gpu, maps, light, textures);
        let attributes = [VertexAttribute::Position];
        for caster in &maps.casters {
            self.meshes.prepare(&self.gpu, &caster.mesh, &attributes);
        }
        // One time for all layers: from the first one's begin to the last one's end.
        let stamps = Self::stamps(&mut self.timer);
        for (place, (number, layer)) in moved.iter().copied().enumerate() {
            drawn[number] = layer.hash;
            let own = stamps.clone().map(|stamps| wgpu::RenderPassTimestampWrites {
                beginning_of_pass_write_index: stamps
                    .beginning_of_pass_write_index
                    .filter(|_| place == 0),
                end_of_pass_write_index: stamps
                    .end_of_pass_write_index
                    .filter(|_| place + 1 == moved.len()),
                ..stamps
            });
            let view = texture.create_view(&one_layer(number as u32));
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some(pass.label()),
                color_attachments: &[Some(super::passes::cleared(&view, wgpu::Color::TRANSPARENT))],
                depth_stencil_attachment: Some(depth_attachment(depth, wgpu::StoreOp::Discard)),
                timestamp_writes: own.filter(|own| {
                    own.beginning_of_pass_write_index.or(own.end_of_pass_write_index).is_some()
                }),
                ..wgpu::RenderPassDescriptor::default()
            });
            pass.set_pipeline(&light.pipeline);
            for caster in &layer.casters {
                let offsets = [group.layers[number], group.casters[*caster]];
                pass.set_bind_group(0, &group.group, &offsets);
                let mesh = &maps.casters[*caster].mesh;
                self.meshes.bind(&mut pass, mesh, &attributes);
                pass.draw_indexed(0..mesh.indices.len() as u32, 0, 0..1);
            }
        }
        Ok(true)
    }
}

/// The bind group of all layers, with the offsets of layers and objects.
struct LightGroup {
    group: wgpu::BindGroup,
    layers: Vec<u32>,
    casters: Vec<u32>,
}

fn light_group(
    gpu: &Gpu,
    maps: &Arc<ShadowMaps>,
    light: &LightPipeline,
    textures: &HashMap<PassId, wgpu::Texture>,
) -> LightGroup {
    let alignment = gpu.device.limits().min_uniform_buffer_offset_alignment as usize;
    let of_layers = maps.layers.iter().map(|layer| layer.uniform.bytes.as_slice());
    let of_casters = maps.casters.iter().map(|caster| caster.uniform.bytes.as_slice());
    let size = |mut uniforms: std::slice::Iter<'_, &[u8]>| {
        NonZeroU64::new(uniforms.next().map_or(0, |first| first.len()) as u64)
    };
    let sizes = [of_layers.clone().collect::<Vec<_>>(), of_casters.clone().collect::<Vec<_>>()]
        .map(|uniforms| size(uniforms.iter()));
    let (layer_bytes, layers) = packed(alignment, of_layers);
    let (caster_bytes, casters) = packed(alignment, of_casters);
    let buffers = [layer_bytes, caster_bytes].map(|bytes| uniform(&gpu.device, &bytes));
    let part = |index: usize| wgpu::BindGroupEntry {
        binding: index as u32,
        resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
            buffer: &buffers[index],
            offset: 0,
            size: sizes[index],
        }),
    };
    let first = light.reads.and_then(|read| Some(textures.get(&read)?.create_view(&all_layers())));
    let mut entries = vec![part(0), part(1)];
    if let Some(first) = &first {
        entries.push(wgpu::BindGroupEntry {
            binding: 2,
            resource: wgpu::BindingResource::TextureView(first),
        });
    }
    let descriptor = wgpu::BindGroupDescriptor {
        label: Some("shadow maps"),
        layout: &light.layout,
        entries: &entries,
    };
    LightGroup { group: gpu.device.create_bind_group(&descriptor), layers, casters }
}
