//! Deferred looks: their surface is drawn with the numbers of its triangles, and each look is a
//! pass over the picture, which shades what a pixel shows once. See `scene/frame/deferred/`.
//!
//! As passes over the picture are, a deferred look is drawn at the far plane, behind what the
//! surface's pass drew: where nothing is, nothing is shaded.

mod mesh;
mod pipeline;

pub(crate) use mesh::NumberedMeshes;
pub(crate) use pipeline::DeferredPipelines;

use std::sync::Arc;

use crate::compile::{BindingKind, CompiledShader};
use crate::frame::{Deferral, DeferredDraw, Draw, FramePlan, PassId};
use crate::passes::{background, cleared, depth_attachment, tested_depth, uniform};
use crate::pipeline::Sides;
use crate::target::FAR_PLANE;
use crate::{RenderError, Renderer};

use mesh::NumberedBuffers;
use pipeline::DeferredPipeline;

/// Resources of deferred looks on a device. Clones share them.
#[derive(Clone, Debug, Default)]
pub(crate) struct DeferredStore {
    pub(crate) meshes: NumberedMeshes,
    pub(crate) pipelines: DeferredPipelines,
}

/// A draw with everything that is bound for it.
struct BoundDraw {
    pipeline: DeferredPipeline,
    look: wgpu::BindGroup,
    buffers: NumberedBuffers,
}

impl Renderer {
    /// The deferred drawing of a plan's looks, where the plan wants it and the device can do it.
    pub(crate) fn deferral<'p>(&self, plan: &'p FramePlan) -> Option<&'p Deferral> {
        let deferral = plan.deferral.as_ref().ok().filter(|_| plan.samples == 1)?;
        let can_draw = |(draw, deferred): (&Draw, &DeferredDraw)| {
            Arc::ptr_eq(&draw.look, &deferred.shader) && mesh::fits(&self.gpu, &draw.mesh)
        };
        let mut draws = plan.draws.iter().zip(&deferral.draws);
        let is_whole = plan.draws.len() == deferral.draws.len();
        (is_whole && draws.all(can_draw)).then_some(deferral)
    }

    /// Draws the surface of every object, with the numbers of triangles.
    pub(crate) fn draw_numbered(
        &mut self,
        plan: &FramePlan,
        deferral: &Deferral,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<(), RenderError> {
        let id = deferral.surface;
        let Some(stage) = id.stage() else { return Ok(()) };
        let view = uniform(&self.gpu.device, &plan.view.uniform_bytes());
        let mut bound = Vec::new();
        for (draw, deferred) in plan.draws.iter().zip(&deferral.draws) {
            let Some(shader) = draw.module(stage) else { continue };
            let sides = Sides { both: draw.two_sided, is_mirrored: draw.is_mirrored };
            let text = &deferred.look.surface;
            let store = &self.gpu.store.deferred;
            let pipeline = store.pipelines.surface(&self.gpu, (shader, id), text, sides)?;
            let attributes = shader.needs.attributes();
            let buffers = store.meshes.get(&self.gpu, &draw.mesh, &attributes, &[]);
            let look = self.deferred_group(shader, draw, &view, &pipeline)?;
            bound.push((draw, deferred, attributes, BoundDraw { pipeline, look, buffers }));
        }
        let (Some(depth), Some(triangles)) = (self.targets.buffer(id), &self.targets.triangles)
        else {
            return Ok(());
        };
        let mut attachments = self.targets.attachments(id);
        attachments.push(Some(cleared(triangles, wgpu::Color::TRANSPARENT)));
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(id.label()),
            color_attachments: &attachments,
            depth_stencil_attachment: Some(depth_attachment(depth, wgpu::StoreOp::Store)),
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        for (draw, deferred, attributes, BoundDraw { pipeline, look, buffers }) in &bound {
            pass.set_pipeline(&pipeline.pipeline);
            pass.set_bind_group(0, look, &[]);
            for (slot, attribute) in (0..).zip(attributes) {
                if let Some(buffer) = buffers.attributes.get(attribute) {
                    pass.set_vertex_buffer(slot, buffer.slice(..));
                }
            }
            pass.set_index_buffer(buffers.indices.slice(..), wgpu::IndexFormat::Uint32);
            // The number of the instance is where the draw's triangles begin.
            pass.draw_indexed(draw.indices.clone(), 0, deferred.first..deferred.first + 1);
        }
        Ok(())
    }

    /// Draws the looks over what the surface's pass drew.
    pub(crate) fn draw_deferred(
        &mut self,
        plan: &FramePlan,
        deferral: &Deferral,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<(), RenderError> {
        let view = uniform(&self.gpu.device, &plan.view.uniform_bytes());
        let mut bound = Vec::new();
        for (draw, deferred) in plan.draws.iter().zip(&deferral.draws) {
            let module = &deferred.look.look;
            let store = &self.gpu.store.deferred;
            let pipeline = store.pipelines.look(&self.gpu, &draw.look, module)?;
            let buffers = store.meshes.get(&self.gpu, &draw.mesh, &[], &module.attributes);
            let look = self.deferred_group(&draw.look, draw, &view, &pipeline)?;
            let numbers = uniform(&self.gpu.device, bytemuck::cast_slice(&deferred.numbers()));
            let Some(triangles) = &self.targets.triangles else { return Ok(()) };
            let texture = wgpu::BindingResource::TextureView;
            let texels = module.attributes.iter().filter_map(|name| buffers.texels.get(name));
            let resources =
                [texture(triangles), numbers.as_entire_binding(), texture(&buffers.corners)];
            let resources = resources.into_iter().chain(texels.map(texture));
            let entries: Vec<_> = (0..)
                .zip(resources)
                .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource })
                .collect();
            let Some(layout) = &pipeline.mesh else { continue };
            let mesh = self.gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("mesh"),
                layout,
                entries: &entries,
            });
            bound.push((deferred.area, pipeline.pipeline, look, mesh));
        }
        let (Some(picture), Some(depth)) =
            (self.picture_view(), self.targets.buffer(deferral.surface))
        else {
            return Ok(());
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(PassId::LOOK.label()),
            color_attachments: &[Some(cleared(&picture, background(plan)))],
            depth_stencil_attachment: Some(tested_depth(depth)),
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        let [width, height] = plan.size.map(|side| side as f32);
        pass.set_viewport(0.0, 0.0, width, height, FAR_PLANE, FAR_PLANE);
        for (area, pipeline, look, mesh) in &bound {
            if area.is_empty() {
                continue;
            }
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, look, &[]);
            pass.set_bind_group(1, mesh, &[]);
            let ([x, y], [width, height]) = (area.begin, area.size());
            pass.set_scissor_rect(x, y, width, height);
            pass.draw(0..3, 0..1);
        }
        Ok(())
    }

    /// The bindings of a look's own module.
    fn deferred_group(
        &self,
        shader: &CompiledShader,
        draw: &Draw,
        view: &wgpu::Buffer,
        pipeline: &DeferredPipeline,
    ) -> Result<wgpu::BindGroup, RenderError> {
        let device = &self.gpu.device;
        let object = uniform(device, &draw.object_uniform.bytes);
        let look = draw.look_uniforms.get(&shader.stage).map(|uniform| &uniform.bytes);
        let look = look.filter(|bytes| !bytes.is_empty()).map(|bytes| uniform(device, bytes));
        self.look_group((shader, draw), &pipeline.look, |kind| match kind {
            BindingKind::View => Some(view.as_entire_binding()),
            BindingKind::Object => Some(object.as_entire_binding()),
            BindingKind::Look => look.as_ref().map(wgpu::Buffer::as_entire_binding),
            _ => None,
        })
    }
}
