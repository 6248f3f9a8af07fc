//! Normals, object numbers and depth of every object, one sample a pixel.

use super::look::{Bound, cleared, depth_attachment};
use crate::compile::Stage;
use crate::frame::{FramePlan, PassKind};
use crate::{RenderError, Renderer};

impl Renderer {
    pub(crate) fn draw_normals(
        &mut self,
        plan: &FramePlan,
        kind: &PassKind,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<(), RenderError> {
        let stage = if *kind == PassKind::Normals { Stage::Normals } else { Stage::DetailNormals };
        let view = self.uniform(&plan.view.uniform_bytes());
        let mut bound: Vec<(usize, Bound)> = Vec::new();
        for (index, draw) in plan.draws.iter().enumerate() {
            if let Some(shader) = draw.normals.get(kind) {
                bound.push((index, self.bind(shader, stage, draw, &view, 1)?));
            }
        }
        let Some(targets) = self.targets.of(kind) else { return Ok(()) };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("normals"),
            color_attachments: &[
                Some(cleared(&targets.normals, wgpu::Color::TRANSPARENT)),
                Some(cleared(&targets.depths, wgpu::Color::TRANSPARENT)),
            ],
            depth_stencil_attachment: Some(depth_attachment(&targets.buffer)),
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        for (index, bound) in &bound {
            self.submit(&mut pass, &plan.draws[*index], bound);
        }
        Ok(())
    }
}
