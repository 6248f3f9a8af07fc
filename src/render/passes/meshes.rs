//! Mesh passes: they come before the looks and draw every object with one sample a pixel: slopes,
//! depth and object numbers.

use super::look::depth_attachment;
use crate::compile::Stage;
use crate::frame::{FramePlan, PassId};
use crate::{RenderError, Renderer};

impl Renderer {
    pub(crate) fn draw_meshes(
        &mut self,
        plan: &FramePlan,
        (pass, stage): (PassId, Stage),
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<(), RenderError> {
        let lists = self.bind_lists(plan, stage, 1)?;
        let Some(buffer) = self.targets.buffer(pass) else { return Ok(()) };
        let attachments = self.targets.attachments(pass);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(pass.label()),
            color_attachments: &attachments,
            // Passes over the picture test it.
            depth_stencil_attachment: Some(depth_attachment(buffer, wgpu::StoreOp::Store)),
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        lists.submit(&self.meshes, &mut pass, None);
        Ok(())
    }
}
