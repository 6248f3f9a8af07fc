//! Draw lists of a pass, ready to be drawn: one pipeline and one bind group for each look, whatever
//! the number of objects that wear it.
//!
//! All uniforms of a pass lie in one buffer, which is written at once. A bind group has the buffer
//! once, and each draw chooses its object's and its look's part of it by dynamic offsets; uniforms
//! that draws share lie there once.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::sync::Arc;

use super::uniform;
use crate::compile::{BindingKind, CompiledShader, Stage, Uniform};
use crate::frame::{Draw, FramePlan, PixelArea};
use crate::mesh::Meshes;
use crate::pipeline::{DepthUse, LookPipeline, Sides};
use crate::{LimitedSize, RenderError, Renderer};

/// Draw lists of one pass with everything that they read.
pub(super) struct BoundLists<'p>(Vec<BoundList<'p>>);

/// A draw list with its pipeline and bind group.
struct BoundList<'p> {
    pipeline: LookPipeline,
    /// Pipeline of depths, where they are drawn before colors.
    depths: Option<LookPipeline>,
    group: wgpu::BindGroup,
    draws: &'p [Draw],
    /// Offsets of the draws' uniforms, as many for each draw as the module has such bindings.
    offsets: Vec<u32>,
}

/// Identity of a list's bind group: the module and the hashes of its images.
type GroupKey = (*const CompiledShader, Vec<u64>);

/// Identity of a list's pipeline.
type PipelineKey = (*const CompiledShader, Sides, DepthUse);

/// Uniforms of a pass, one after another.
struct UniformBytes {
    bytes: Vec<u8>,
    /// Distance between the places where uniforms may begin.
    alignment: usize,
    /// Places of uniforms that draws share.
    shared: HashMap<*const Uniform, u32>,
}

impl UniformBytes {
    /// Adds a uniform, and returns its offset.
    fn push(&mut self, uniform: &[u8]) -> Result<u32, RenderError> {
        self.bytes.resize(self.bytes.len().next_multiple_of(self.alignment), 0);
        let too_large = |_| RenderError::TooLarge {
            what: LimitedSize::UniformBytes,
            size: self.bytes.len() as u64,
            limit: u32::MAX.into(),
        };
        let offset = u32::try_from(self.bytes.len()).map_err(too_large)?;
        self.bytes.extend_from_slice(uniform);
        Ok(offset)
    }

    /// Adds a uniform that was not added before, and returns its offset.
    fn push_shared(&mut self, uniform: &Arc<Uniform>) -> Result<u32, RenderError> {
        let key = Arc::as_ptr(uniform);
        if let Some(known) = self.shared.get(&key) {
            return Ok(*known);
        }
        let offset = self.push(&uniform.bytes)?;
        self.shared.insert(key, offset);
        Ok(offset)
    }
}

/// A part of the pass's buffer for a binding.
fn part(buffer: &wgpu::Buffer, size: usize) -> Option<wgpu::BindingResource<'_>> {
    // The offset is a draw's own.
    let size = wgpu::BufferSize::new(size as u64)?;
    Some(wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer, offset: 0, size: Some(size) }))
}

impl Renderer {
    /// Prepares all resources that the draws of a pass read.
    pub(super) fn bind_lists<'p>(
        &self,
        plan: &'p FramePlan,
        stage: Stage,
        samples: u32,
    ) -> Result<BoundLists<'p>, RenderError> {
        let view = plan.view.uniform_bytes();
        let view_size = view.len();
        let alignment = self.gpu.device.limits().min_uniform_buffer_offset_alignment as usize;
        let mut uniforms = UniformBytes { bytes: view, alignment, shared: HashMap::new() };
        let lists: Vec<&[Draw]> = plan.draw_lists(stage).collect();
        let offsets = lists.iter().map(|draws| offsets(&mut uniforms, draws, stage));
        let offsets = offsets.collect::<Result<Vec<Vec<u32>>, RenderError>>()?;
        let buffer = uniform(&self.gpu.device, &uniforms.bytes);
        let mut pipelines: HashMap<PipelineKey, LookPipeline> = HashMap::new();
        let mut groups: HashMap<GroupKey, wgpu::BindGroup> = HashMap::new();
        let mut bound = Vec::with_capacity(lists.len());
        for (draws, offsets) in lists.into_iter().zip(offsets) {
            let draw = &draws[0];
            let Some(shader) = draw.module(stage) else { continue };
            let sides = Sides { both: draw.two_sided, is_mirrored: draw.is_mirrored };
            let mut pipeline_of = |depth| match pipelines.entry((Arc::as_ptr(shader), sides, depth))
            {
                Entry::Occupied(known) => Ok::<_, RenderError>(known.get().clone()),
                Entry::Vacant(slot) => {
                    let made = self.pipelines.get(&self.gpu, shader, samples, sides, depth)?;
                    Ok(slot.insert(made).clone())
                }
            };
            let is_depth_first = stage.is_picture() && draw.depth_first;
            let (pipeline, depths) = if is_depth_first {
                (pipeline_of(DepthUse::Before)?, Some(pipeline_of(DepthUse::Alone)?))
            } else {
                (pipeline_of(DepthUse::Together)?, None)
            };
            for draws in draws.chunk_by(|draw, next| Arc::ptr_eq(&draw.mesh, &next.mesh)) {
                self.meshes.prepare(&self.gpu, &draws[0].mesh, &pipeline.attributes);
            }
            let images = draw.images_of(stage).iter().map(|image| image.hash).collect();
            let group = match groups.entry((Arc::as_ptr(shader), images)) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(slot) => {
                    let layout = &pipeline.layout;
                    slot.insert(self.bind_group((shader, draw), (&buffer, view_size), layout)?)
                }
            };
            bound.push(BoundList { pipeline, depths, group: group.clone(), draws, offsets });
        }
        Ok(BoundLists(bound))
    }

    /// The bind group of all draws of a module with the same images as `draw`.
    fn bind_group(
        &self,
        (shader, draw): (&CompiledShader, &Draw),
        (buffer, view_size): (&wgpu::Buffer, usize),
        layout: &wgpu::BindGroupLayout,
    ) -> Result<wgpu::BindGroup, RenderError> {
        let look_size =
            draw.look_uniforms.get(&shader.stage).map_or(0, |uniform| uniform.bytes.len());
        self.look_group((shader, draw), layout, |kind| match kind {
            BindingKind::View => part(buffer, view_size),
            BindingKind::Object => part(buffer, draw.object_uniform.bytes.len()),
            BindingKind::Look => part(buffer, look_size),
            _ => None,
        })
    }
}

/// The offsets of the uniforms of a list's draws, which are added to `uniforms`.
fn offsets(
    uniforms: &mut UniformBytes,
    draws: &[Draw],
    stage: Stage,
) -> Result<Vec<u32>, RenderError> {
    let Some(shader) = draws[0].module(stage) else { return Ok(Vec::new()) };
    let mut offsets = Vec::with_capacity(2 * draws.len());
    for draw in draws {
        for binding in &shader.bindings {
            match binding.kind {
                BindingKind::Object => offsets.push(uniforms.push(&draw.object_uniform.bytes)?),
                BindingKind::Look => {
                    let missing = || RenderError::unbound(&binding.name);
                    let uniform = draw.look_uniforms.get(&stage).ok_or_else(missing)?;
                    offsets.push(uniforms.push_shared(uniform)?);
                }
                _ => {}
            }
        }
    }
    Ok(offsets)
}

impl BoundLists<'_> {
    /// Draws all lists, one after another; depths that come before colors first. Draws without
    /// pixels in `area`, if there is one, are left out.
    pub(super) fn submit(
        &self,
        meshes: &Meshes,
        pass: &mut wgpu::RenderPass<'_>,
        area: Option<PixelArea>,
    ) {
        // What hides most comes first.
        for list in self.0.iter().rev() {
            if let Some(depths) = &list.depths {
                list.submit(depths, meshes, pass, (true, area));
            }
        }
        // Where two draws are equally near, the first one is seen; of draws whose depths are known
        // the last one is.
        let (lists, is_reversed) = (self.0.iter(), self.0.iter().all(|list| list.depths.is_some()));
        let submit = |list: &BoundList<'_>| {
            list.submit(&list.pipeline, meshes, pass, (is_reversed, area));
        };
        if is_reversed { lists.rev().for_each(submit) } else { lists.for_each(submit) }
    }
}

impl BoundList<'_> {
    /// Draws the list, or draws it from its end; without the draws that have no pixels in `area`.
    fn submit(
        &self,
        pipeline: &LookPipeline,
        meshes: &Meshes,
        pass: &mut wgpu::RenderPass<'_>,
        (is_reversed, area): (bool, Option<PixelArea>),
    ) {
        pass.set_pipeline(&pipeline.pipeline);
        let count = self.draws.len();
        let dynamic = self.offsets.len() / count;
        let mut mesh = None;
        for place in 0..count {
            let index = if is_reversed { count - 1 - place } else { place };
            let draw = &self.draws[index];
            if area.is_some_and(|area| !area.meets(&draw.area)) {
                continue;
            }
            if mesh != Some(Arc::as_ptr(&draw.mesh)) {
                meshes.bind(pass, &draw.mesh, &pipeline.attributes);
                mesh = Some(Arc::as_ptr(&draw.mesh));
            }
            let offsets = &self.offsets[index * dynamic..(index + 1) * dynamic];
            pass.set_bind_group(0, &self.group, offsets);
            pass.draw_indexed(draw.indices.clone(), 0, 0..1);
        }
    }
}
