//! Evaluation of a compiled look at surface samples, at full f32 precision.

use std::sync::Arc;

use wgpu::util::DeviceExt as _;

use super::Renderer;
use super::casters::CastersTexture;
use super::error::RenderError;
use super::gpu::Gpu;
use super::pipeline::{DepthUse, LookPipeline, Sides};
use super::readback::read_texture;
use super::shadow_maps::LightTargets;
use super::target::texture;
use crate::compile::{BindingKind, SAMPLES_PER_ROW};
use crate::frame::EvalBatch;

/// Largest number of samples in one run: as many as fit a target that every GPU allows.
const SAMPLES_PER_RUN: usize = (SAMPLES_PER_ROW as usize) * 1024;

impl Renderer {
    /// The root's value at each sample of a batch, in the batch's order: up to four numbers, by the
    /// root's type.
    ///
    /// # Errors
    /// Errors of the GPU.
    pub async fn evaluate(&mut self, batch: &EvalBatch) -> Result<Vec<[f32; 4]>, RenderError> {
        let count = batch.indices.len();
        let mut values = Vec::with_capacity(count);
        let stride = batch.samples.bytes.len().checked_div(count).unwrap_or(0);
        // The size of a storage binding is limited, too.
        let fitting =
            self.gpu.device.limits().max_storage_buffer_binding_size as usize / stride.max(1);
        let per_run = SAMPLES_PER_RUN.min(fitting).max(1);
        for first in (0..count).step_by(per_run) {
            let last = (first + per_run).min(count);
            values.extend(
                self.evaluate_run(
                    batch,
                    &batch.samples.bytes[first * stride..last * stride],
                    last - first,
                )
                .await?,
            );
        }
        Ok(values)
    }

    async fn evaluate_run(
        &mut self,
        batch: &EvalBatch,
        bytes: &[u8],
        count: usize,
    ) -> Result<Vec<[f32; 4]>, RenderError> {
        let guard = self.gpu.guard();
        let pipeline = self.pipelines.get(
            &self.gpu,
            &batch.shader,
            1,
            Sides { both: true, is_mirrored: false },
            DepthUse::Together,
        )?;
        let group = self.bind_samples(batch, bytes, &pipeline)?;
        let rows = (count as u32).div_ceil(SAMPLES_PER_ROW);
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        // Each sample fills a quad of 2x2 pixels, so that derivatives are 0.
        let size = [2 * SAMPLES_PER_ROW, 2 * rows];
        self.gpu.check_size(size)?;
        let target = texture(&self.gpu, size, wgpu::TextureFormat::Rgba32Float, 1, usage);
        run(&self.gpu, &target, &pipeline, &group);
        guard.finish().await?;
        let texels = read_texture(&self.gpu, &target, 16).await?;
        let value = |index: usize| {
            let (x, y) =
                (2 * (index % SAMPLES_PER_ROW as usize), 2 * (index / SAMPLES_PER_ROW as usize));
            let at = 16 * (y * size[0] as usize + x);
            let number = |i: usize| {
                let start = at + 4 * i;
                f32::from_le_bytes([
                    texels[start],
                    texels[start + 1],
                    texels[start + 2],
                    texels[start + 3],
                ])
            };
            [number(0), number(1), number(2), number(3)]
        };
        Ok((0..count).map(value).collect())
    }

    fn bind_samples(
        &mut self,
        batch: &EvalBatch,
        bytes: &[u8],
        pipeline: &LookPipeline,
    ) -> Result<wgpu::BindGroup, RenderError> {
        let samples = self.gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("samples"),
            contents: bytes,
            usage: wgpu::BufferUsages::STORAGE,
        });
        let images = self.images.of(&self.gpu, &batch.images, &batch.shader.needs.images)?;
        // Samples are of no scene, where nothing casts a shadow.
        let casters = match batch.shader.needs.casters() {
            true => Some(CastersTexture::new(&self.gpu, &Arc::default())?),
            false => None,
        };
        let unseen = LightTargets::empty(&self.gpu);
        let mut entries = Vec::new();
        for binding in &batch.shader.bindings {
            let resource = match &binding.kind {
                BindingKind::Samples => Some(samples.as_entire_binding()),
                BindingKind::Image(index) | BindingKind::Hcbtf(index) => {
                    images.get(*index).map(|image| image.texture())
                }
                BindingKind::Sampler(index) => images.get(*index).map(|image| image.sampler()),
                BindingKind::Casters => casters.as_ref().map(CastersTexture::resource),
                BindingKind::Pass(_) => Some(wgpu::BindingResource::TextureView(&unseen)),
                _ => None,
            };
            let missing = || RenderError::unbound(&binding.name);
            entries.push(wgpu::BindGroupEntry {
                binding: binding.binding,
                resource: resource.ok_or_else(missing)?,
            });
        }
        let descriptor = wgpu::BindGroupDescriptor {
            label: Some("samples"),
            layout: &pipeline.layout,
            entries: &entries,
        };
        Ok(self.gpu.device.create_bind_group(&descriptor))
    }
}

fn run(gpu: &Gpu, target: &wgpu::Texture, pipeline: &LookPipeline, group: &wgpu::BindGroup) {
    let view = target.create_view(&wgpu::TextureViewDescriptor::default());
    let mut encoder = gpu
        .device
        .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("samples") });
    {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("samples"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            ..wgpu::RenderPassDescriptor::default()
        });
        // The shader's triangle covers the upper left half of the viewport.
        pass.set_viewport(
            0.0,
            0.0,
            2.0 * target.width() as f32,
            2.0 * target.height() as f32,
            0.0,
            1.0,
        );
        pass.set_pipeline(&pipeline.pipeline);
        pass.set_bind_group(0, group, &[]);
        pass.draw(0..3, 0..1);
    }
    gpu.queue.submit([encoder.finish()]);
}
