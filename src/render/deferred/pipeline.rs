//! Pipelines of deferred looks, and of surfaces drawn with the numbers of their triangles.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use crate::compile::{CompiledShader, VertexAttribute};
use crate::error::RenderError;
use crate::frame::{DeferredModule, PassId, stack_of};
use crate::gpu::Gpu;
use crate::passes::{
    DepthTest, PipelineParts, UNFILTERED, layout_of, targets_of, texels_type, uniform_type,
};
use crate::pipeline::{SMALL_STACK, Sides, binding_type, blended, vertex_attribute, with_stack};
use crate::target::TRIANGLES;

/// Number of pipelines that are kept; when there are more, all are made anew.
const MOST: usize = 128;

/// Name of the pipelines on the device.
const LABEL: &str = "deferred";

/// A pipeline with its layouts.
#[derive(Clone, Debug)]
pub(super) struct DeferredPipeline {
    pub(super) pipeline: wgpu::RenderPipeline,
    /// Layout of the look's own bindings.
    pub(super) look: wgpu::BindGroupLayout,
    /// Layout of the picture's triangles and the mesh; `None` where meshes are drawn.
    pub(super) mesh: Option<wgpu::BindGroupLayout>,
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct PipelineKey {
    text: String,
    /// Sides of triangles; `None` where the picture is drawn.
    sides: Option<Sides>,
    picture: wgpu::TextureFormat,
}

/// Pipelines in use. Clones share them.
#[derive(Clone, Debug, Default)]
pub(crate) struct DeferredPipelines(Arc<Mutex<HashMap<PipelineKey, PipelineSlot>>>);

/// A pipeline that exists, or is being created by the thread that holds the lock.
type PipelineSlot = Arc<Mutex<Option<DeferredPipeline>>>;

impl DeferredPipelines {
    /// Drops all pipelines.
    pub(crate) fn clear(&self) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// The pipeline that draws a look over the picture.
    ///
    /// # Errors
    /// `TooDeep` for a module that is too deep for a driver's compiler.
    pub(super) fn look(
        &self,
        gpu: &Gpu,
        shader: &CompiledShader,
        module: &DeferredModule,
    ) -> Result<DeferredPipeline, RenderError> {
        let stack = stack_of(shader).map_err(|message| RenderError::TooDeep { message })?;
        self.get(gpu, &module.text, None, || {
            let make = || look_pipeline(gpu, shader, module);
            // The module runs the look three times, one after another.
            if stack <= SMALL_STACK / 4 { Ok(make()) } else { with_stack(4 * stack, make) }
        })
    }

    /// The pipeline that draws a surface with the numbers of its triangles.
    ///
    /// # Errors
    /// `TooDeep` for a module that is too deep for a driver's compiler.
    pub(super) fn surface(
        &self,
        gpu: &Gpu,
        (shader, pass): (&CompiledShader, PassId),
        text: &str,
        sides: Sides,
    ) -> Result<DeferredPipeline, RenderError> {
        let stack = stack_of(shader).map_err(|message| RenderError::TooDeep { message })?;
        self.get(gpu, text, Some(sides), || {
            let make = || surface_pipeline(gpu, (shader, pass), text, sides);
            if stack <= SMALL_STACK { Ok(make()) } else { with_stack(stack, make) }
        })
    }

    fn get(
        &self,
        gpu: &Gpu,
        text: &str,
        sides: Option<Sides>,
        make: impl FnOnce() -> Result<DeferredPipeline, RenderError>,
    ) -> Result<DeferredPipeline, RenderError> {
        let key = PipelineKey { text: text.to_owned(), sides, picture: gpu.picture };
        let slot = {
            let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            if known.len() >= MOST && !known.contains_key(&key) {
                known.clear();
            }
            known.entry(key).or_default().clone()
        };
        let mut slot = slot.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(pipeline) = &*slot {
            return Ok(pipeline.clone());
        }
        let made = make()?;
        *slot = Some(made.clone());
        Ok(made)
    }
}

/// Layout of the bindings of a look's own module.
fn look_layout(device: &wgpu::Device, shader: &CompiledShader) -> wgpu::BindGroupLayout {
    let bindings = shader.bindings.iter();
    let types = bindings.map(|binding| (binding.binding, fixed(binding_type(&binding.kind))));
    layout_of(device, "look", wgpu::ShaderStages::VERTEX_FRAGMENT, types)
}

/// A binding whose place in a buffer does not change from draw to draw.
fn fixed(ty: wgpu::BindingType) -> wgpu::BindingType {
    match ty {
        wgpu::BindingType::Buffer { ty, min_binding_size, .. } => {
            wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size }
        }
        other => other,
    }
}

/// Layout of the picture's triangles, a draw's numbers, the mesh's corners and its attributes.
fn mesh_layout(device: &wgpu::Device, attributes: &[VertexAttribute]) -> wgpu::BindGroupLayout {
    let texture = |sample_type| texels_type(sample_type, wgpu::TextureViewDimension::D2);
    let whole = wgpu::TextureSampleType::Uint;
    let types = [texture(whole), uniform_type(false), texture(whole)].into_iter();
    let bindings = (0..).zip(types.chain(attributes.iter().map(|_| texture(UNFILTERED))));
    layout_of(device, "mesh", wgpu::ShaderStages::FRAGMENT, bindings)
}

fn look_pipeline(gpu: &Gpu, shader: &CompiledShader, module: &DeferredModule) -> DeferredPipeline {
    let look = look_layout(&gpu.device, shader);
    let mesh = mesh_layout(&gpu.device, &module.attributes);
    let parts = PipelineParts {
        label: LABEL,
        text: &module.text,
        layouts: &[Some(&look), Some(&mesh)],
        buffers: &[],
        primitive: wgpu::PrimitiveState::default(),
        depth: Some(DepthTest::Behind),
        samples: 1,
        targets: &[blended(gpu.picture)],
    };
    DeferredPipeline { pipeline: parts.pipeline(&gpu.device), look, mesh: Some(mesh) }
}

fn surface_pipeline(
    gpu: &Gpu,
    (shader, pass): (&CompiledShader, PassId),
    text: &str,
    sides: Sides,
) -> DeferredPipeline {
    let look = look_layout(&gpu.device, shader);
    let formats: Vec<[wgpu::VertexAttribute; 1]> = shader
        .needs
        .attributes()
        .into_iter()
        .map(|attribute| [vertex_attribute(attribute)])
        .collect();
    let buffers: Vec<_> = formats
        .iter()
        .map(|format| {
            Some(wgpu::VertexBufferLayout {
                array_stride: format[0].format.size(),
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: format,
            })
        })
        .collect();
    let mut targets = targets_of(gpu, pass);
    targets.push(Some(TRIANGLES.into()));
    let parts = PipelineParts {
        label: LABEL,
        text,
        layouts: &[Some(&look)],
        buffers: &buffers,
        primitive: sides.primitive(),
        depth: Some(DepthTest::Nearest),
        samples: 1,
        targets: &targets,
    };
    DeferredPipeline { pipeline: parts.pipeline(&gpu.device), look, mesh: None }
}
