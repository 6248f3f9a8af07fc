//! Pipelines of looks, cached by the inputs that they were created from. Shared by all renderers of
//! a device.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use chiaro_locale::tr;

use super::error::RenderError;
use super::gpu::Gpu;
use super::target::{DEPTH, format_of};
use crate::compile::{BindingKind, CompiledShader, VertexAttribute};
use crate::frame::{PassId, PassOutput, TexelFormat, stack_of};

/// Stack that any thread has to spare, in bytes; the smallest of our threads have 2 MiB.
pub(super) const SMALL_STACK: usize = 1 << 20;

/// Number of pipelines that are kept: as many as an editing session comes back to, including the
/// small pictures.
const MOST: usize = 192;

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct PipelineKey {
    wgsl: String,
    samples: u32,
    sides: Sides,
    depth: DepthUse,
    /// Format that the picture is drawn in.
    picture: wgpu::TextureFormat,
}

/// Sides of triangles that are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Sides {
    pub(super) both: bool,
    pub(super) is_mirrored: bool,
}

/// Use of the depth buffer by a pipeline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) enum DepthUse {
    /// Depths are tested and written together with colors.
    #[default]
    Together,
    /// Depths are tested and written alone.
    Alone,
    /// Depths were written before, and opaque colors are drawn where they are the nearest.
    Before,
}

/// The vertex's position in modules of looks.
const POSITION: &str = "@builtin(position) clip: vec4f";

/// A fragment that draws nothing but its depth.
const NO_COLOR: &str = "@fragment fn fs_main() -> @location(0) vec4f { return vec4f(); }";

impl Sides {
    /// Assembly of triangles of which these sides are drawn.
    pub(super) fn primitive(self) -> wgpu::PrimitiveState {
        let front = if self.is_mirrored { wgpu::FrontFace::Cw } else { wgpu::FrontFace::Ccw };
        wgpu::PrimitiveState {
            cull_mode: (!self.both).then_some(wgpu::Face::Back),
            front_face: front,
            ..wgpu::PrimitiveState::default()
        }
    }
}

/// A pipeline with the layout and the attributes that must be bound to it.
#[derive(Clone, Debug)]
pub(super) struct LookPipeline {
    pub(super) pipeline: wgpu::RenderPipeline,
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) attributes: Vec<VertexAttribute>,
}

/// Recently used pipelines. Clones share them.
#[derive(Clone, Debug, Default)]
pub(super) struct Pipelines(Arc<Mutex<PipelineTable>>);

/// A pipeline that exists, or is being created by the thread that holds the lock: a module is
/// compiled once, and only threads that draw with it wait for it.
type PipelineSlot = Arc<Mutex<Option<LookPipeline>>>;

#[derive(Debug, Default)]
struct PipelineTable {
    known: HashMap<PipelineKey, (PipelineSlot, u64)>,
    /// Number of requests so far: the pipeline whose request is oldest is dropped first.
    clock: u64,
}

impl PipelineTable {
    fn slot(&mut self, key: PipelineKey) -> PipelineSlot {
        self.clock += 1;
        let clock = self.clock;
        if !self.known.contains_key(&key) && self.known.len() >= MOST {
            let oldest =
                self.known.iter().min_by_key(|(_, (_, used))| *used).map(|(key, _)| key.clone());
            oldest.and_then(|key| self.known.remove(&key));
        }
        let (slot, used) = self.known.entry(key).or_default();
        *used = clock;
        slot.clone()
    }
}

impl Pipelines {
    /// Number of pipelines that are kept.
    pub(super) fn count(&self) -> usize {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).known.len()
    }

    /// Drops all pipelines: some may have been created while the device had no room for them.
    pub(super) fn clear(&self) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).known.clear();
    }

    /// The pipeline of a look's module.
    ///
    /// # Errors
    /// `TooDeep` for a module that is too deep for a driver's compiler.
    pub(super) fn get(
        &self,
        gpu: &Gpu,
        shader: &CompiledShader,
        samples: u32,
        sides: Sides,
        depth: DepthUse,
    ) -> Result<LookPipeline, RenderError> {
        let (wgsl, picture) = (shader.wgsl.clone(), gpu.picture);
        let key = PipelineKey { wgsl, samples, sides, depth, picture };
        let slot = self.0.lock().unwrap_or_else(PoisonError::into_inner).slot(key);
        let mut slot = slot.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(pipeline) = &*slot {
            return Ok(pipeline.clone());
        }
        let stack = stack_of(shader).map_err(|message| RenderError::TooDeep { message })?;
        let make = || make(gpu, shader, samples, sides, depth);
        // A driver's compiler recurses over deep modules, so these get a thread with a larger
        // stack.
        let made = if stack <= SMALL_STACK { make() } else { with_stack(stack, make)? };
        *slot = Some(made.clone());
        Ok(made)
    }
}

/// Does work on a new thread with a stack of `stack` bytes, and waits for it.
pub(super) fn with_stack<T: Send>(
    stack: usize,
    work: impl FnOnce() -> T + Send,
) -> Result<T, RenderError> {
    let no_thread = |error: std::io::Error| RenderError::OutOfMemory {
        message: tr!("there is not enough memory for the compiler of this look: {error}"),
    };
    #[expect(
        clippy::disallowed_methods,
        reason = "the stack of this thread is the caller's not to choose"
    )]
    std::thread::scope(|scope| {
        let thread =
            std::thread::Builder::new().name("pipeline".to_owned()).stack_size(SMALL_STACK + stack);
        let thread = thread.spawn_scoped(scope, work).map_err(no_thread)?;
        thread.join().map_err(|panic| std::panic::resume_unwind(panic))
    })
}

fn make(
    gpu: &Gpu,
    shader: &CompiledShader,
    samples: u32,
    sides: Sides,
    depth: DepthUse,
) -> LookPipeline {
    let device = &gpu.device;
    let read = |wgsl: &str| {
        let source = wgpu::ShaderSource::Wgsl(wgsl.into());
        device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some("look"), source })
    };
    let module = match depth {
        DepthUse::Together => read(&shader.wgsl),
        // Both pipelines must find the same depths, to the bit.
        DepthUse::Alone | DepthUse::Before => {
            read(&shader.wgsl.replacen(POSITION, &format!("@invariant {POSITION}"), 1))
        }
    };
    let no_color = (depth == DepthUse::Alone).then(|| read(NO_COLOR));
    let layout = bind_group_layout(device, shader);
    let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("look"),
        bind_group_layouts: &[Some(&layout)],
        immediate_size: 0,
    });
    let is_mesh = shader.stage.draws_meshes();
    let attributes = if is_mesh { shader.needs.attributes() } else { Vec::new() };
    let formats: Vec<[wgpu::VertexAttribute; 1]> =
        attributes.iter().map(|attribute| [vertex_attribute(*attribute)]).collect();
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
    let depth_stencil = is_mesh.then(|| wgpu::DepthStencilState {
        format: DEPTH,
        depth_write_enabled: Some(depth != DepthUse::Before),
        depth_compare: Some(match depth {
            DepthUse::Together | DepthUse::Alone => wgpu::CompareFunction::Less,
            DepthUse::Before => wgpu::CompareFunction::LessEqual,
        }),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    });
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("look"),
        layout: Some(&pipeline_layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("vs_main"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &buffers,
        },
        primitive: if is_mesh { sides.primitive() } else { wgpu::PrimitiveState::default() },
        depth_stencil,
        multisample: wgpu::MultisampleState { count: samples, ..wgpu::MultisampleState::default() },
        fragment: Some(wgpu::FragmentState {
            module: no_color.as_ref().unwrap_or(&module),
            entry_point: Some("fs_main"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &targets(shader, gpu, depth),
        }),
        multiview_mask: None,
        cache: None,
    });
    LookPipeline { pipeline, layout, attributes }
}

fn targets(
    shader: &CompiledShader,
    gpu: &Gpu,
    depth: DepthUse,
) -> Vec<Option<wgpu::ColorTargetState>> {
    let plain = |format| {
        Some(wgpu::ColorTargetState { format, blend: None, write_mask: wgpu::ColorWrites::ALL })
    };
    let Some(pass) = PassId::of_stage(shader.stage) else {
        // Values of samples.
        return vec![plain(wgpu::TextureFormat::Rgba32Float)];
    };
    let target = |output: &PassOutput| {
        let format = format_of(gpu, output.format);
        match depth {
            DepthUse::Alone => {
                let write_mask = wgpu::ColorWrites::empty();
                Some(wgpu::ColorTargetState { format, blend: None, write_mask })
            }
            DepthUse::Together if output.format == TexelFormat::Picture => blended(format),
            DepthUse::Together | DepthUse::Before => plain(format),
        }
    };
    let written = pass.row().writes;
    // Layers beside the picture are drawn as the picture is.
    let beside = shader.aovs.iter().filter_map(|_| written.first());
    written.iter().chain(beside).map(target).collect()
}

/// The target of the picture. The shader outputs straight color; the target is premultiplied, so
/// that samples can be averaged.
pub(super) fn blended(format: wgpu::TextureFormat) -> Option<wgpu::ColorTargetState> {
    let over = |src_factor| wgpu::BlendComponent {
        src_factor,
        dst_factor: wgpu::BlendFactor::OneMinusSrcAlpha,
        operation: wgpu::BlendOperation::Add,
    };
    let blend = wgpu::BlendState {
        color: over(wgpu::BlendFactor::SrcAlpha),
        alpha: over(wgpu::BlendFactor::One),
    };
    Some(wgpu::ColorTargetState { format, blend: Some(blend), write_mask: wgpu::ColorWrites::ALL })
}

pub(super) fn vertex_attribute(attribute: VertexAttribute) -> wgpu::VertexAttribute {
    let format = match attribute {
        VertexAttribute::Position | VertexAttribute::Normal | VertexAttribute::Rest => {
            wgpu::VertexFormat::Float32x3
        }
        VertexAttribute::Tangent | VertexAttribute::Color => wgpu::VertexFormat::Float32x4,
        VertexAttribute::Uv => wgpu::VertexFormat::Float32x2,
    };
    wgpu::VertexAttribute { format, offset: 0, shader_location: attribute.location() }
}

fn bind_group_layout(device: &wgpu::Device, shader: &CompiledShader) -> wgpu::BindGroupLayout {
    let entries: Vec<_> = shader
        .bindings
        .iter()
        .map(|binding| wgpu::BindGroupLayoutEntry {
            binding: binding.binding,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: binding_type(&binding.kind),
            count: None,
        })
        .map(|mut entry| {
            if matches!(
                entry.ty,
                wgpu::BindingType::Buffer { ty: wgpu::BufferBindingType::Storage { .. }, .. }
            ) {
                entry.visibility = wgpu::ShaderStages::FRAGMENT;
            }
            entry
        })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("look"),
        entries: &entries,
    })
}

pub(super) fn binding_type(kind: &BindingKind) -> wgpu::BindingType {
    let buffer = |ty, has_dynamic_offset| wgpu::BindingType::Buffer {
        ty,
        has_dynamic_offset,
        min_binding_size: None,
    };
    let texture_of = |filterable, view_dimension| wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable },
        view_dimension,
        multisampled: false,
    };
    let texture = |filterable| texture_of(filterable, wgpu::TextureViewDimension::D2);
    match kind {
        BindingKind::View => buffer(wgpu::BufferBindingType::Uniform, false),
        // Every draw of a list has an offset of its own.
        BindingKind::Object | BindingKind::Look => buffer(wgpu::BufferBindingType::Uniform, true),
        BindingKind::Samples => buffer(wgpu::BufferBindingType::Storage { read_only: true }, false),
        BindingKind::Image(_) => texture(true),
        BindingKind::Hcbtf(_) => texture_of(true, wgpu::TextureViewDimension::D2Array),
        BindingKind::Sampler(_) => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        BindingKind::Pass(pass) if pass.is_of_lights() => {
            texture_of(false, wgpu::TextureViewDimension::D2Array)
        }
        BindingKind::Pass(_) | BindingKind::Casters => texture(false),
    }
}
