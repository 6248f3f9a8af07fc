//! Passes of the looks themselves, each object with its own, from back to front.

use super::uniform;
use crate::compile::{BindingKind, CompiledShader};
use crate::frame::{Draw, FramePlan, PassImage};
use crate::pipeline::{LookPipeline, Sides};
use crate::target::FAR_PLANE;
use crate::{RenderError, Renderer};

/// A draw with its pipeline and bind group.
pub(super) struct BoundDraw {
    pipeline: LookPipeline,
    group: wgpu::BindGroup,
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
pub(crate) fn depth_attachment(
    view: &wgpu::TextureView,
    store: wgpu::StoreOp,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(FAR_PLANE), store }),
        stencil_ops: None,
    }
}

/// The color behind everything, premultiplied as the picture is.
pub(crate) fn background(plan: &FramePlan) -> wgpu::Color {
    let [r, g, b, a] = plan.backdrop.unwrap_or([0.0; 4]);
    wgpu::Color { r: r * a, g: g * a, b: b * a, a }
}

impl Renderer {
    pub(crate) fn draw_look(
        &mut self,
        plan: &FramePlan,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<(), RenderError> {
        let view = uniform(&self.gpu.device, &plan.view.uniform_bytes());
        let mut bound = Vec::new();
        for draw in &plan.draws {
            bound.push(self.bind(&draw.look, draw, &view, plan.samples)?);
        }
        let (Some(picture), Some(depth)) = (self.picture_view(), &self.targets.depth) else {
            return Ok(());
        };
        let background = background(plan);
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
        for (draw, bound) in plan.draws.iter().zip(&bound) {
            self.submit(&mut pass, draw, bound);
        }
        Ok(())
    }

    /// Prepares all resources that a draw reads.
    pub(super) fn bind(
        &mut self,
        shader: &CompiledShader,
        draw: &Draw,
        view: &wgpu::Buffer,
        samples: u32,
    ) -> Result<BoundDraw, RenderError> {
        let sides = Sides { both: draw.two_sided, is_mirrored: draw.is_mirrored };
        let pipeline = self.pipelines.get(&self.gpu, shader, samples, sides)?;
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
