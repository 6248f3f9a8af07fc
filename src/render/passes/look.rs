//! Pass of the looks themselves, each object with its own.

use super::blank::BlankPipeline;
use crate::frame::{FramePlan, LookInputs, PassId, PixelArea};
use crate::kept::BLOCK;
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

/// A color attachment whose samples, if it has several, are averaged into `view`.
fn resolved<'a>(
    view: &'a wgpu::TextureView,
    samples: Option<&'a wgpu::TextureView>,
    ops: wgpu::Operations<wgpu::Color>,
) -> wgpu::RenderPassColorAttachment<'a> {
    let store = if samples.is_some() { ops.store } else { wgpu::StoreOp::Store };
    wgpu::RenderPassColorAttachment {
        view: samples.unwrap_or(view),
        depth_slice: None,
        resolve_target: samples.map(|_| view),
        ops: wgpu::Operations { store, ..ops },
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
    /// Draws the looks: all, or what changed since the samples of `before` were drawn. Returns the
    /// inputs of the samples that are there now, where they are kept.
    pub(crate) fn draw_look(
        &mut self,
        plan: &FramePlan,
        before: Option<&LookInputs>,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<Option<LookInputs>, RenderError> {
        let Some(stage) = PassId::LOOK.stage() else { return Ok(None) };
        let lists = self.bind_lists(plan, stage, plan.samples)?;
        let (Some(picture), Some(depth)) = (self.picture_view(), &self.targets.depth) else {
            return Ok(None);
        };
        let inputs = self.kept.inputs_of(plan);
        let changed =
            inputs.as_ref().zip(before).and_then(|both| both.0.changed_since(both.1, BLOCK));
        self.kept.count(plan, changed.as_deref());
        // The samples are not needed once they are resolved, unless they are kept.
        let store = if inputs.is_some() { wgpu::StoreOp::Store } else { wgpu::StoreOp::Discard };
        let of_color = |color| wgpu::Operations { load: load(&changed, color), store };
        let background = background(plan);
        let layers = self.targets.layer_views();
        let samples = self.targets.multisampled.as_ref();
        let color = resolved(&picture, samples, of_color(background));
        let beside = layers.iter().map(|(layer, samples)| {
            Some(resolved(layer, samples.as_ref(), of_color(wgpu::Color::TRANSPARENT)))
        });
        let colors: Vec<_> = std::iter::once(Some(color)).chain(beside).collect();
        let mut of_depth = depth_attachment(depth, store);
        of_depth.depth_ops = Some(wgpu::Operations { load: load(&changed, FAR_PLANE), store });
        let counts = (plan.samples, layers.len());
        let blank = changed.as_ref().map(|_| {
            BlankPipeline::prepare(&mut self.kept.blank, &self.gpu, counts, background, encoder)
        });
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("look"),
            color_attachments: &colors,
            depth_stencil_attachment: Some(of_depth),
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        let (Some(changed), Some(blank)) = (&changed, blank) else {
            lists.submit(&self.meshes, &mut pass, None);
            drop(pass);
            return Ok(inputs);
        };
        for area in changed {
            let ([x, y], [width, height]) = (area.begin, area.size());
            pass.set_scissor_rect(x, y, width, height);
            blank.draw(&mut pass);
            lists.submit(&self.meshes, &mut pass, Some(*area));
        }
        drop(pass);
        Ok(inputs)
    }
}

/// The beginning of an attachment: blank, or what is kept where only some areas change.
fn load<V>(changed: &Option<Vec<PixelArea>>, blank: V) -> wgpu::LoadOp<V> {
    if changed.is_some() { wgpu::LoadOp::Load } else { wgpu::LoadOp::Clear(blank) }
}
