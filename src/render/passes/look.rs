//! Pass of the looks themselves, each object with its own.

use crate::frame::{FramePlan, PassId};
use crate::target::FAR_PLANE;
use crate::{RenderError, Renderer};

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

/// A color attachment that is cleared to one color, and whose samples, if it has several, are
/// averaged into `view`.
fn resolved<'a>(
    view: &'a wgpu::TextureView,
    samples: Option<&'a wgpu::TextureView>,
    color: wgpu::Color,
) -> wgpu::RenderPassColorAttachment<'a> {
    let Some(samples) = samples else { return cleared(view, color) };
    let mut attachment = cleared(samples, color);
    attachment.resolve_target = Some(view);
    // The samples are not needed once they are resolved.
    attachment.ops.store = wgpu::StoreOp::Discard;
    attachment
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
        let Some(stage) = PassId::LOOK.stage() else { return Ok(()) };
        let lists = self.bind_lists(plan, stage, plan.samples)?;
        let (Some(picture), Some(depth)) = (self.picture_view(), &self.targets.depth) else {
            return Ok(());
        };
        let background = background(plan);
        let layers = self.targets.layer_views();
        let color = resolved(&picture, self.targets.multisampled.as_ref(), background);
        let beside = layers.iter().map(|(layer, samples)| {
            Some(resolved(layer, samples.as_ref(), wgpu::Color::TRANSPARENT))
        });
        let colors: Vec<_> = std::iter::once(Some(color)).chain(beside).collect();
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("look"),
            color_attachments: &colors,
            depth_stencil_attachment: Some(depth_attachment(depth, wgpu::StoreOp::Discard)),
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        lists.submit(&self.meshes, &mut pass);
        Ok(())
    }
}
