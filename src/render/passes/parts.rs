//! Pipelines of passes, by what differs between them: one module with `vs_main` and `fs_main`.

use crate::frame::PassId;
use crate::gpu::Gpu;
use crate::target::{DEPTH, format_of};

/// Parts of a pipeline that differ.
pub(crate) struct PipelineParts<'a> {
    pub(crate) label: &'a str,
    /// Source of the module, in WGSL.
    pub(crate) text: &'a str,
    pub(crate) layouts: &'a [Option<&'a wgpu::BindGroupLayout>],
    /// Vertex buffers; none where one triangle covers the picture.
    pub(crate) buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub(crate) primitive: wgpu::PrimitiveState,
    pub(crate) depth: Option<DepthTest>,
    /// Samples a pixel.
    pub(crate) samples: u32,
    pub(crate) targets: &'a [Option<wgpu::ColorTargetState>],
}

/// Test of depths in a pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DepthTest {
    /// The nearest surface is drawn, and its depth is written.
    Nearest,
    /// Fragments behind a surface that was drawn before, whose depth stays, are drawn.
    Behind,
    /// All fragments are drawn, and their depth is written.
    Any,
}

impl DepthTest {
    fn state(self) -> wgpu::DepthStencilState {
        let (writes, compare) = match self {
            Self::Nearest => (true, wgpu::CompareFunction::Less),
            Self::Behind => (false, wgpu::CompareFunction::Greater),
            Self::Any => (true, wgpu::CompareFunction::Always),
        };
        wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(writes),
            depth_compare: Some(compare),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }
    }
}

impl PipelineParts<'_> {
    /// The pipeline of these parts.
    pub(crate) fn pipeline(&self, device: &wgpu::Device) -> wgpu::RenderPipeline {
        let label = Some(self.label);
        let source = wgpu::ShaderSource::Wgsl(self.text.into());
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label,
            bind_group_layouts: self.layouts,
            immediate_size: 0,
        });
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vs_main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: self.buffers,
            },
            primitive: self.primitive,
            depth_stencil: self.depth.map(DepthTest::state),
            multisample: wgpu::MultisampleState {
                count: self.samples,
                ..wgpu::MultisampleState::default()
            },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fs_main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: self.targets,
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// Targets of the images that a pass writes, or of the picture that it is laid over.
pub(crate) fn targets_of(gpu: &Gpu, pass: PassId) -> Vec<Option<wgpu::ColorTargetState>> {
    if pass.is_over() {
        return vec![Some(wgpu::ColorTargetState {
            format: gpu.picture,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::ALL,
        })];
    }
    let written = pass.row().writes.iter();
    written.map(|output| Some(format_of(gpu, output.format).into())).collect()
}

/// A layout of these bindings, which the stages see alike.
pub(crate) fn layout_of(
    device: &wgpu::Device,
    label: &str,
    visibility: wgpu::ShaderStages,
    bindings: impl IntoIterator<Item = (u32, wgpu::BindingType)>,
) -> wgpu::BindGroupLayout {
    let entry = |(binding, ty)| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let entries: Vec<_> = bindings.into_iter().map(entry).collect();
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries };
    device.create_bind_group_layout(&descriptor)
}

/// A uniform, whose place in its buffer a draw chooses if `has_offset`.
pub(crate) fn uniform_type(has_offset: bool) -> wgpu::BindingType {
    wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Uniform,
        has_dynamic_offset: has_offset,
        min_binding_size: None,
    }
}

/// A texture whose texels are read and not filtered.
pub(crate) fn texels_type(
    sample_type: wgpu::TextureSampleType,
    view_dimension: wgpu::TextureViewDimension,
) -> wgpu::BindingType {
    wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false }
}

/// Numbers of a texture that are read and not filtered.
pub(crate) const UNFILTERED: wgpu::TextureSampleType =
    wgpu::TextureSampleType::Float { filterable: false };
