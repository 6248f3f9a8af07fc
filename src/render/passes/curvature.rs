//! What is found from the normals that are on the screen: curvature
//! (`shaders/passes/curvature.wgsl` and its cheaper sibling `curvature_sparse.wgsl`), its tensor
//! (`curvature_tensor.wgsl`), and smoothed normals (`smooth_normals_*.wgsl`).

use wgpu::util::DeviceExt as _;

use crate::Renderer;
use crate::frame::{FramePlan, PassKind};
use crate::gpu::Gpu;
use crate::target::format_of;
use crate::wgsl;

/// The fixed pipeline of one of them.
#[derive(Debug)]
pub(crate) struct CurvaturePass {
    pipeline: wgpu::RenderPipeline,
}

impl CurvaturePass {
    pub(crate) fn new(gpu: &Gpu, name: &str, kind: &PassKind) -> Self {
        let source = wgsl::pass(name).unwrap_or_default().text;
        let descriptor = wgpu::ShaderModuleDescriptor {
            label: Some(name),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        };
        let module = gpu.device.create_shader_module(descriptor);
        let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(name),
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vs_main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fs_main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(format_of(kind).into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline }
    }
}

impl Renderer {
    pub(crate) fn draw_curvature(
        &mut self,
        plan: &FramePlan,
        kind: &PassKind,
        encoder: &mut wgpu::CommandEncoder,
    ) {
        let (Some(targets), Some(name)) = (self.targets.of(kind), kind.shader()) else { return };
        let Some(made) = self.targets.made(kind) else { return };
        // Each level of smoothed normals is made from the one before it.
        let normals = match kind {
            PassKind::SmoothNormals(level @ 2..) => {
                targets.made(&PassKind::SmoothNormals(level - 1))
            }
            _ => Some(&targets.normals),
        };
        let Some(normals) = normals else { return };
        let fixed =
            self.curvature.entry(name).or_insert_with(|| CurvaturePass::new(&self.gpu, name, kind));
        let device = &self.gpu.device;
        let numbers = plan.view.curvature_numbers(plan.samples).map(|number| number as f32);
        let uniform = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("curvature"),
            contents: bytemuck::cast_slice(&numbers),
            usage: wgpu::BufferUsages::UNIFORM,
        });
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(name),
            layout: &fixed.pipeline.get_bind_group_layout(0),
            entries: &[
                entry(0, wgpu::BindingResource::TextureView(normals)),
                entry(1, wgpu::BindingResource::TextureView(&targets.depths)),
                entry(2, uniform.as_entire_binding()),
            ],
        });
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("curvature"),
            color_attachments: &[Some(super::look::cleared(made, wgpu::Color::TRANSPARENT))],
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_pipeline(&fixed.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.draw(0..3, 0..1);
    }
}
