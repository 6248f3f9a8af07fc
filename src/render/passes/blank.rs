//! Blank areas: pixels that are shaded anew begin as those of a cleared picture do.
//!
//! Attachments can be cleared only whole, so one triangle is drawn over the area. Its color comes
//! from a texel that is cleared as the picture is: whichever way a device rounds colors that it
//! clears to, the same number is there.

use super::{DepthTest, PipelineParts, UNFILTERED, cleared, layout_of, texels_type};
use crate::gpu::Gpu;
use crate::target::texture;

const LABEL: &str = "blank";

/// Pipeline that makes pixels of the picture, its layers and its depth blank.
#[derive(Debug)]
pub(crate) struct BlankPipeline {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    /// The color behind everything, as the picture has it.
    texel: wgpu::TextureView,
    /// Samples a pixel, and layers beside the picture.
    counts: (u32, usize),
}

impl BlankPipeline {
    /// The pipeline for so many samples a pixel, and layers beside the picture.
    fn new(gpu: &Gpu, (samples, layers): (u32, usize)) -> Self {
        let texels = texels_type(UNFILTERED, wgpu::TextureViewDimension::D2);
        let layout = layout_of(&gpu.device, LABEL, wgpu::ShaderStages::FRAGMENT, [(0, texels)]);
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        let texel = texture(gpu, [1, 1], gpu.picture, 1, usage)
            .create_view(&wgpu::TextureViewDescriptor::default());
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(LABEL),
            layout: &layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&texel),
            }],
        });
        let parts = PipelineParts {
            label: LABEL,
            text: &text(layers),
            layouts: &[Some(&layout)],
            buffers: &[],
            primitive: wgpu::PrimitiveState::default(),
            depth: Some(DepthTest::Any),
            samples,
            targets: &vec![Some(gpu.picture.into()); 1 + layers],
        };
        Self { pipeline: parts.pipeline(&gpu.device), group, texel, counts: (samples, layers) }
    }

    /// The pipeline for so many samples a pixel and layers, made where `known` is another; its
    /// color is set to `color`.
    pub(crate) fn prepare<'a>(
        known: &'a mut Option<Self>,
        gpu: &Gpu,
        counts: (u32, usize),
        color: wgpu::Color,
        encoder: &mut wgpu::CommandEncoder,
    ) -> &'a Self {
        let known = match known.take().filter(|known| known.counts == counts) {
            Some(same) => known.insert(same),
            None => known.insert(Self::new(gpu, counts)),
        };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(LABEL),
            color_attachments: &[Some(cleared(&known.texel, color))],
            ..wgpu::RenderPassDescriptor::default()
        });
        known
    }

    /// Makes the pixels of the pass's scissor rectangle blank.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}

/// The module for so many layers beside the picture, whose pixels are 0; the triangle lies on the
/// far plane.
fn text(layers: usize) -> String {
    let outputs: String =
        (1..=layers).map(|at| format!(" @location({at}) layer_{at}: vec4f,")).collect();
    let zeros = ", vec4f()".repeat(layers);
    format!(
        "@group(0) @binding(0) var behind: texture_2d<f32>;\n\
         struct Blank {{ @location(0) picture: vec4f,{outputs} }}\n\
         @vertex fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {{\n    \
             let corner = vec2f(vec2u(index & 1u, index >> 1u));\n    \
             return vec4f(4.0 * corner - 1.0, 1.0, 1.0);\n\
         }}\n\
         @fragment fn fs_main() -> Blank {{\n    \
             return Blank(textureLoad(behind, vec2i(), 0){zeros});\n\
         }}\n"
    )
}
