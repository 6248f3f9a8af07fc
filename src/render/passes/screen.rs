//! Screen passes: the files of `shaders/passes`, each with the images that earlier passes drew.
//!
//! With one sample a pixel a screen pass runs only where a pixel shows an object: it is drawn at
//! the far plane, and has to lie behind what its surface's pass drew there. The result is the same,
//! which is 0 elsewhere; but a GPU tests depth before it shades, and software Vulkan, which goes
//! through all of a shader for every pixel of a block, shades fewer blocks. Passes of a larger
//! extent run for all pixels near objects; those that are laid over the picture follow the looks.

use std::collections::hash_map::Entry;

use chiaro_locale::tr;

use super::{
    DepthTest, PipelineParts, UNFILTERED, layout_of, targets_of, texels_type, uniform, uniform_type,
};
use crate::frame::{FramePlan, PassId, ScreenExtent, ScreenModule, ScreenResource};
use crate::gpu::Gpu;
use crate::target::FAR_PLANE;
use crate::{RenderError, Renderer};

/// The fixed pipeline of a screen pass.
#[derive(Debug)]
pub(crate) struct ScreenPipeline {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    module: ScreenModule,
}

impl ScreenPipeline {
    /// The pipeline of a pass; `tests_depth` if it is drawn only behind objects.
    ///
    /// # Errors
    /// A file that does not match the pass's row.
    fn new(gpu: &Gpu, pass: PassId, tests_depth: bool) -> Result<Self, RenderError> {
        let refused = |message: String| RenderError::Refused { message };
        let module = ScreenModule::of(pass)
            .map_err(|problems| refused(problems[0].message.clone()))?
            .ok_or_else(|| refused(tr!("`{pass}` draws meshes", pass = pass.label())))?;
        let layout = layout(gpu, pass, &module);
        let parts = PipelineParts {
            label: pass.label(),
            text: &module.text,
            layouts: &[Some(&layout)],
            buffers: &[],
            primitive: wgpu::PrimitiveState::default(),
            depth: tests_depth.then_some(DepthTest::Behind),
            samples: 1,
            targets: &targets_of(gpu, pass),
        };
        let pipeline = parts.pipeline(&gpu.device);
        Ok(Self { pipeline, layout, module })
    }
}

/// A color attachment that is drawn over.
fn kept(view: &wgpu::TextureView) -> wgpu::RenderPassColorAttachment<'_> {
    wgpu::RenderPassColorAttachment {
        view,
        depth_slice: None,
        resolve_target: None,
        ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
    }
}

/// A depth attachment that is read and not changed.
pub(crate) fn tested_depth(view: &wgpu::TextureView) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment { view, depth_ops: None, stencil_ops: None }
}

fn layout(gpu: &Gpu, pass: PassId, module: &ScreenModule) -> wgpu::BindGroupLayout {
    let image = || texels_type(UNFILTERED, wgpu::TextureViewDimension::D2);
    let types = module.bindings.iter().map(|binding| match &binding.holds {
        ScreenResource::Image(_) => (binding.binding, image()),
        ScreenResource::Numbers(_) => (binding.binding, uniform_type(false)),
    });
    layout_of(&gpu.device, pass.label(), wgpu::ShaderStages::FRAGMENT, types)
}

impl Renderer {
    pub(crate) fn draw_screen(
        &mut self,
        plan: &FramePlan,
        pass: PassId,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<(), RenderError> {
        // With several samples, pixels at an outline have values although they show no object.
        let is_over = pass.is_over();
        let is_of_surface = pass.extent() == Some(ScreenExtent::Surface);
        let surface = pass.surface().filter(|_| plan.samples == 1 && is_of_surface);
        let depth = surface.and_then(|surface| self.targets.buffer(surface));
        let picture = self.picture_view().filter(|_| is_over);
        let key = (pass, depth.is_some());
        let ScreenPipeline { pipeline, layout, module } = match self.screens.entry(key) {
            Entry::Occupied(made) => made.into_mut(),
            Entry::Vacant(place) => place.insert(ScreenPipeline::new(&self.gpu, pass, key.1)?),
        };
        let device = &self.gpu.device;
        let uniforms = module.bindings.iter().filter_map(|binding| {
            let ScreenResource::Numbers(numbers) = &binding.holds else { return None };
            let numbers = plan.numbers(numbers);
            let numbers: Vec<f32> = numbers.into_iter().map(|number| number as f32).collect();
            Some((binding.binding, uniform(device, bytemuck::cast_slice(&numbers))))
        });
        let uniforms: Vec<_> = uniforms.collect();
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        let numbers = uniforms.iter();
        let mut entries: Vec<_> =
            numbers.map(|(binding, buffer)| entry(*binding, buffer.as_entire_binding())).collect();
        for binding in &module.bindings {
            let ScreenResource::Image(image) = &binding.holds else { continue };
            let missing = || RenderError::Refused {
                message: tr!("`{pass}` comes before what it reads", pass = pass.label()),
            };
            let view = self.targets.image(*image).ok_or_else(missing)?;
            entries.push(entry(binding.binding, wgpu::BindingResource::TextureView(view)));
        }
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(pass.label()),
            layout,
            entries: &entries,
        });
        let area = plan.screen_area();
        let attachments = match &picture {
            Some(picture) => vec![Some(kept(picture))],
            None => self.targets.attachments(pass),
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(pass.label()),
            color_attachments: &attachments,
            depth_stencil_attachment: depth.map(tested_depth),
            timestamp_writes: Self::stamps(&mut self.timer),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &group, &[]);
        // The images are cleared to what the pass results in elsewhere.
        if !area.is_empty() {
            if depth.is_some() {
                let [width, height] = plan.size.map(|side| side as f32);
                pass.set_viewport(0.0, 0.0, width, height, FAR_PLANE, FAR_PLANE);
            }
            let ([x, y], [width, height]) = (area.begin, area.size());
            pass.set_scissor_rect(x, y, width, height);
            pass.draw(0..3, 0..1);
        }
        Ok(())
    }
}
