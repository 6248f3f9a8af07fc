//! Passes of the looks themselves, each object with its own, from back to front.

use super::uniform;
use crate::compile::{BindingKind, CompiledShader};
use crate::frame::{Draw, FramePlan, PassImage};
use crate::pipeline::{DepthUse, LookPipeline, Sides};
use crate::target::FAR_PLANE;
use crate::{RenderError, Renderer};

/// A draw with its pipeline and bind group.
pub(super) struct BoundDraw {
    pipeline: LookPipeline,
    group: wgpu::BindGroup,
}

fn sides(draw: &Draw) -> Sides {
    Sides { both: draw.two_sided, is_mirrored: draw.is_mirrored }
}

/// A color attachment that is cleared to one color.
pub(crate) fn cleared(
    view: &wgpu::TextureView,
    color: wgpu::Color,
) -> wgpu::RenderPassColorAttachment<'_> {
    wgpu::RenderPassColorAttachment {
        view,
        depth_slice: None,
        resolve_target: None,
        ops: wgpu::Operations { load: wgpu::LoadOp::Clear(color), store: wgpu::StoreOp::Store },
    }
}

/// A depth attachment that is cleared to the far plane.
pub(super) fn depth_attachment(
    view: &wgpu::TextureView,
    store: wgpu::StoreOp,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(FAR_PLANE), store }),
        stencil_ops: None,
    }
}

impl Renderer {
    pub(crate) fn draw_look(
        &mut self,
        plan: &FramePlan,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<(), RenderError> {
        let view = uniform(&self.gpu.device, &plan.view.uniform_bytes());
        let mut bound = Vec::new();
        let mut depths = Vec::new();
        for draw in &plan.draws {
            let depth = if draw.depth_first { DepthUse::Before } else { DepthUse::Together };
            bound.push(self.bind((&draw.look, depth), draw, &view, plan.samples)?);
        }
        for (draw, bound) in plan.draws.iter().zip(&bound).filter(|(draw, _)| draw.depth_first) {
            let pipeline = self.pipelines.get(
                &self.gpu,
                &draw.look,
                plan.samples,
                sides(draw),
                DepthUse::Alone,
            )?;
            depths.push((draw, BoundDraw { pipeline, group: bound.group.clone() }));
        }
        let (Some(picture), Some(depth)) = (self.picture_view(), &self.targets.depth) else {
            return Ok(());
        };
        let [r, g, b, a] = plan.backdrop.unwrap_or([0.0; 4]);
        // The backdrop is straight, and the target premultiplied.
        let background = wgpu::Color { r: r * a, g: g * a, b: b * a, a };
        let color = match &self.targets.multisampled {
            Some(multisampled) => {
                let mut attachment = cleared(multisampled, background);
                attachment.resolve_target = Some(&picture);
                // The samples are not needed once they are resolved into the picture.
                attachment.ops.store = wgpu::StoreOp::Discard;
                attachment
            }
            None => cleared(&picture, background),
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("look"),
            color_attachments: &[Some(color)],
            depth_stencil_attachment: Some(depth_attachment(depth, wgpu::StoreOp::Discard)),
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        // What hides most comes first.
        for (draw, bound) in depths.iter().rev() {
            self.submit(&mut pass, draw, bound);
        }
        let are_all_known = depths.len() == plan.draws.len();
        let all = plan.draws.iter().zip(&bound);
        // Where two draws are equally near, the first one is seen; of draws whose depths are known
        // the last one is.
        let ordered: Vec<_> = if are_all_known { all.rev().collect() } else { all.collect() };
        for (draw, bound) in ordered {
            self.submit(&mut pass, draw, bound);
        }
        Ok(())
    }

    /// Prepares all resources that a draw reads.
    pub(super) fn bind(
        &mut self,
        (shader, depth): (&CompiledShader, DepthUse),
        draw: &Draw,
        view: &wgpu::Buffer,
        samples: u32,
    ) -> Result<BoundDraw, RenderError> {
        let pipeline = self.pipelines.get(&self.gpu, shader, samples, sides(draw), depth)?;
        self.meshes.prepare(&self.gpu, &draw.mesh, &pipeline.attributes);
        let object = uniform(&self.gpu.device, &draw.object_uniform.bytes);
        let look = draw.look_uniforms.get(&shader.stage).map(|uniform| &uniform.bytes);
        let look =
            look.filter(|bytes| !bytes.is_empty()).map(|bytes| uniform(&self.gpu.device, bytes));
        let images =
            self.images.of(&self.gpu, draw.images_of(shader.stage), &shader.needs.images)?;
        let mut entries = Vec::new();
        for binding in &shader.bindings {
            let resource = match &binding.kind {
                BindingKind::View => Some(view.as_entire_binding()),
                BindingKind::Object => Some(object.as_entire_binding()),
                BindingKind::Look => look.as_ref().map(wgpu::Buffer::as_entire_binding),
                BindingKind::Image(index) | BindingKind::Hcbtf(index) => {
                    images.get(*index).map(|image| image.texture())
                }
                BindingKind::Sampler(index) => images.get(*index).map(|image| image.sampler()),
                BindingKind::Pass(pass) => {
                    let image = PassImage { pass: *pass, output: 0 };
                    self.targets.image(image).map(wgpu::BindingResource::TextureView)
                }
                BindingKind::Samples => None,
            };
            let missing = || RenderError::Refused {
                message: format!("nothing to bind to `{}`", binding.name),
            };
            entries.push(wgpu::BindGroupEntry {
                binding: binding.binding,
                resource: resource.ok_or_else(missing)?,
            });
        }
        let descriptor = wgpu::BindGroupDescriptor {
            label: Some("look"),
            layout: &pipeline.layout,
            entries: &entries,
        };
        let group = self.gpu.device.create_bind_group(&descriptor);
        Ok(BoundDraw { pipeline, group })
    }

    pub(super) fn submit(&self, pass: &mut wgpu::RenderPass<'_>, draw: &Draw, bound: &BoundDraw) {
        pass.set_pipeline(&bound.pipeline.pipeline);
        pass.set_bind_group(0, &bound.group, &[]);
        self.meshes.bind(pass, &draw.mesh, &bound.pipeline.attributes);
        pass.draw_indexed(draw.indices.clone(), 0, 0..1);
    }
}
