//! The material: pipelines, and the passes of a frame.

use std::ops::Range;
use std::sync::Arc;

use crate::error::Error;
use crate::host;
use crate::lights::Lights;
use crate::look::{self, Feed, PASSES, Pass};
use crate::math;
use crate::output::{Encoding, Output, Target};
use crate::scene::{Camera, Mesh, Object};
use crate::shadow_maps::{ShadowMaps, Sphere};
use crate::targets::ShadowTargets;
use crate::uniforms::{self, Place, UniformBuffers, Uniforms};

/// The look *Long shadows* as a material.
#[derive(Debug)]
pub struct Material {
    /// Lights of the look, which may be set between frames.
    pub lights: Lights,
    output: Output,
    pipelines: Vec<PassPipelines>,
    uniforms: UniformBuffers,
    shadows: Option<ShadowTargets>,
}

impl Material {
    /// Format of the view of a target that takes the look's colors as they are made, so that what
    /// is transparent blends as it does in Chiaro.
    /// They are encoded as sRGB: a target must not do so again. Configure a surface with its own
    /// format, this one among `view_formats`, and draw into a view of this one.
    #[must_use]
    pub fn view_format(format: wgpu::TextureFormat) -> wgpu::TextureFormat {
        format.remove_srgb_suffix()
    }

    /// Compiles the look for a kind of target.
    ///
    /// # Errors
    /// A format that encodes colors which are encoded already.
    pub fn new(device: &wgpu::Device, output: Output) -> Result<Self, Error> {
        if output.encoding == Encoding::Shown && output.color.is_srgb() {
            return Err(Error::Encoding { format: output.color });
        }
        let mut pipelines: Vec<_> =
            PASSES.iter().map(|pass| PassPipelines::new(device, pass)).collect();
        // What the first frame needs of a closed mesh, before it is drawn.
        for (pass, pipelines) in PASSES.iter().zip(&mut pipelines) {
            pipelines.pipeline(device, pass, output, Sides::default());
        }
        Ok(Self {
            lights: Lights::default(),
            output,
            pipelines,
            uniforms: UniformBuffers::default(),
            shadows: None,
        })
    }

    /// Draws objects into a target: everything in one call.
    pub fn draw(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        target: &Target<'_>,
        camera: &Camera,
        objects: &[Object<'_>],
    ) {
        let picture = self.prepare(device, queue, encoder, target.size, camera, objects);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("long-shadows"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target.color,
                depth_slice: None,
                resolve_target: target.resolve,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(target.clear),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(depth_attachment(target.depth, self.output.far())),
            ..Default::default()
        });
        picture.paint(&mut pass);
    }

    /// Prepares a picture of objects, to be painted in a render pass of the caller's whose targets
    /// have the same size.
    /// The passes before the picture are drawn here: `objects` are all that the picture shows.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        size: [u32; 2],
        camera: &Camera,
        objects: &[Object<'_>],
    ) -> Picture {
        let mut uniforms = Uniforms::new(device);
        let view = uniforms.add(&camera.uniform());
        let sphere = |it: &Object<'_>| Sphere { center: it.middle(), radius: it.radius() };
        let spheres: Vec<Sphere> = objects.iter().map(sphere).collect();
        let mut maps = ShadowMaps::new(&spheres, device.limits().max_texture_array_layers);
        let mut placed = Vec::new();
        for (id, object) in objects.iter().enumerate() {
            let around = self.surroundings(camera, size, object, id);
            let mut settings = self.settings();
            maps.place(&mut settings, &around);
            let look = PASSES.each_ref().map(|pass| {
                let numbers = pass.numbers?;
                Some(uniforms.add(&numbers(settings, around)))
            });
            let from_middle = math::subtract(camera.eye(), object.middle());
            let is_eye_within = math::length(from_middle) < object.radius();
            let parts = object.mesh.parts.iter().enumerate().map(|(material, part)| PlacedPart {
                indices: part.indices.clone(),
                uniform: uniforms.add(&uniforms::object(object.matrix(), id, material)),
                shows_backs: part.is_two_sided || is_eye_within,
            });
            placed.push(PlacedObject {
                mesh: object.mesh,
                is_mirrored: object.is_mirrored(),
                parts: parts.collect(),
                look,
                caster: uniforms.add(&uniforms::light_caster(object.matrix(), id)),
            });
        }
        let layers = maps.layers.iter().enumerate();
        let layers: Vec<Place> = layers
            .map(|(number, layer)| uniforms.add(&uniforms::light_layer(layer, number)))
            .collect();
        let (buffer, use_of_buffer) = self.uniforms.upload(device, queue, &uniforms);
        let use_of_encoder = Arc::clone(&use_of_buffer);
        encoder.on_submitted_work_done(move || drop(use_of_encoder));
        let frame = FrameUniforms { buffer, view };
        self.draw_shadows(device, encoder, &frame, &placed, (maps.side(size[1]), &layers));
        let draws = self.draws(device, PASSES.len() - 1, &frame, &placed);
        Picture { draws, use_of_buffer }
    }

    /// Parameters and lights as the look's own numbers take them.
    fn settings(&self) -> host::Settings {
        host::Settings { sun_light: self.lights.sun.settings() }
    }

    /// Surroundings of an object, as the look's own numbers take them.
    fn surroundings(
        &self,
        camera: &Camera,
        size: [u32; 2],
        object: &Object<'_>,
        id: usize,
    ) -> host::Surroundings {
        host::Surroundings {
            illumination: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            camera_from_world: math::linear(&camera.camera_from_world),
            eye: camera.eye(),
            parallel: if camera.is_parallel() { camera.toward() } else { [0.0; 3] },
            object_axes: math::axes(&object.matrix()),
            object_middle: object.middle(),
            object_id: id as f64,
            viewport: size.map(f64::from),
            time: 0.0,
            frame: 0.0,
        }
    }

    /// Draws what lights see: each object into each layer. Closed or not, it casts its shadow with
    /// both sides.
    fn draw_shadows(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameUniforms,
        objects: &[PlacedObject<'_>],
        (side, layers): (u32, &[Place]),
    ) {
        let count = layers.len() as u32;
        if self.shadows.as_ref().is_none_or(|shadows| !shadows.fit(side, count)) {
            self.shadows = Some(ShadowTargets::new(device, side, count));
        }
        for (index, pass) in PASSES.iter().enumerate() {
            if pass.draws != look::Draws::Lights {
                continue;
            }
            let sides = Sides { is_mirrored: false, shows_backs: true };
            let pipeline = self.pipelines[index].pipeline(device, pass, self.output, sides);
            for (number, layer) in (0..).zip(layers) {
                let draw = |object: &PlacedObject<'_>| {
                    let group = self.bind_group(device, index, frame, |feed| match feed {
                        Feed::LightLayer => Some(*layer),
                        Feed::LightCaster => Some(object.caster),
                        _ => None,
                    });
                    let buffers = pass.attributes.iter().map(|(_, it)| it.buffer(object.mesh));
                    let indices = object.mesh.indices.clone();
                    let all = 0..object.mesh.index_count;
                    let pipeline = pipeline.clone();
                    let mesh = (buffers.cloned().collect(), (indices, all));
                    Draw { pipeline, group, mesh }
                };
                let draws: Vec<Draw> = objects.iter().map(draw).collect();
                if let Some(shadows) = &self.shadows {
                    let mut drawing = shadows.begin(encoder, index, number);
                    draws.iter().for_each(|draw| draw.paint(&mut drawing));
                }
            }
        }
    }

    /// Draws of a pass: one for each part of each object.
    fn draws(
        &mut self,
        device: &wgpu::Device,
        index: usize,
        frame: &FrameUniforms,
        objects: &[PlacedObject<'_>],
    ) -> Vec<Draw> {
        let pass = &PASSES[index];
        let mut draws = Vec::new();
        for object in objects {
            let buffers = pass.attributes.iter().map(|(_, it)| it.buffer(object.mesh).clone());
            let buffers: Vec<_> = buffers.collect();
            for part in &object.parts {
                let group = self.bind_group(device, index, frame, |feed| match feed {
                    Feed::Object => Some(part.uniform),
                    Feed::Look => object.look[index],
                    _ => None,
                });
                let shows_backs = part.shows_backs;
                let sides = Sides { is_mirrored: object.is_mirrored, shows_backs };
                let pipeline = self.pipelines[index].pipeline(device, pass, self.output, sides);
                let indices = (object.mesh.indices.clone(), part.indices.clone());
                let mesh = (buffers.clone(), indices);
                draws.push(Draw { pipeline, group, mesh });
            }
        }
        draws
    }

    /// The bindings of a pass; `own` has the uniforms of what is drawn.
    fn bind_group(
        &self,
        device: &wgpu::Device,
        index: usize,
        frame: &FrameUniforms,
        own: impl Fn(Feed) -> Option<Place>,
    ) -> wgpu::BindGroup {
        let resource = |feed: Feed| match feed {
            Feed::View => Some(frame.view.of(&frame.buffer)),
            Feed::ShadowMaps(pass) => {
                let shadows = self.shadows.as_ref()?;
                Some(wgpu::BindingResource::TextureView(&shadows.views[pass]))
            }
            feed => own(feed).map(|place| place.of(&frame.buffer)),
        };
        let entries: Vec<_> = (PASSES[index].bindings.iter())
            .filter_map(|&(binding, feed)| {
                Some(wgpu::BindGroupEntry { binding, resource: resource(feed)? })
            })
            .collect();
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(PASSES[index].name),
            layout: &self.pipelines[index].bindings,
            entries: &entries,
        })
    }
}

/// A picture that is ready to be painted.
#[derive(Debug)]
pub struct Picture {
    draws: Vec<Draw>,
    /// Held as long as the numbers of the picture are needed.
    use_of_buffer: Arc<()>,
}

impl Picture {
    /// Paints the picture in a render pass whose targets are those of the material's [`Output`].
    pub fn paint(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draws.iter().for_each(|draw| draw.paint(pass));
        let use_of_pass = Arc::clone(&self.use_of_buffer);
        pass.on_submitted_work_done(move || drop(use_of_pass));
    }
}

/// Uniforms that all draws of a frame share.
struct FrameUniforms {
    buffer: wgpu::Buffer,
    view: Place,
}

/// An object of a frame, with its uniforms.
struct PlacedObject<'a> {
    mesh: &'a Mesh,
    is_mirrored: bool,
    parts: Vec<PlacedPart>,
    /// Numbers of the look, one for each pass that reads them.
    look: [Option<Place>; PASSES.len()],
    caster: Place,
}

/// A part of an object of a frame.
struct PlacedPart {
    indices: Range<u32>,
    uniform: Place,
    shows_backs: bool,
}

/// Vertex buffers, the index buffer, and the indices to draw.
type DrawnMesh = (Vec<wgpu::Buffer>, (wgpu::Buffer, Range<u32>));

/// A call that draws.
#[derive(Debug)]
struct Draw {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    mesh: DrawnMesh,
}

impl Draw {
    fn paint(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        let (buffers, (indices, range)) = &self.mesh;
        for (slot, buffer) in (0..).zip(buffers) {
            pass.set_vertex_buffer(slot, buffer.slice(..));
        }
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(range.clone(), 0, 0..1);
    }
}

/// Sides of triangles that are drawn, and which of them are fronts.
#[derive(Clone, Copy, Debug, Default)]
struct Sides {
    is_mirrored: bool,
    shows_backs: bool,
}

/// Pipelines of a pass, one for each kind of [`Sides`], made when it is needed.
#[derive(Debug)]
struct PassPipelines {
    shader: wgpu::ShaderModule,
    bindings: wgpu::BindGroupLayout,
    layout: wgpu::PipelineLayout,
    by_sides: [Option<wgpu::RenderPipeline>; 4],
}

impl PassPipelines {
    fn new(device: &wgpu::Device, pass: &Pass) -> Self {
        let label = Some(pass.name);
        let source = wgpu::ShaderSource::Wgsl(pass.shader.into());
        let entries: Vec<_> = (pass.bindings.iter())
            .map(|&(binding, feed)| wgpu::BindGroupLayoutEntry {
                binding,
                visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                ty: feed.binding_type(),
                count: None,
            })
            .collect();
        let bindings = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label,
            entries: &entries,
        });
        Self {
            shader: device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source }),
            layout: device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label,
                bind_group_layouts: &[Some(&bindings)],
                immediate_size: 0,
            }),
            bindings,
            by_sides: [const { None }; 4],
        }
    }

    fn pipeline(
        &mut self,
        device: &wgpu::Device,
        pass: &Pass,
        output: Output,
        sides: Sides,
    ) -> wgpu::RenderPipeline {
        let index = 2 * usize::from(sides.is_mirrored) + usize::from(sides.shows_backs);
        let made = || make_pipeline(device, self, pass, output, sides);
        let known = self.by_sides[index].clone().unwrap_or_else(made);
        self.by_sides[index].insert(known).clone()
    }
}

fn make_pipeline(
    device: &wgpu::Device,
    of: &PassPipelines,
    pass: &Pass,
    output: Output,
    sides: Sides,
) -> wgpu::RenderPipeline {
    let attributes: Vec<[wgpu::VertexAttribute; 1]> =
        pass.attributes.iter().map(|&(location, it)| [it.at(location)]).collect();
    let buffers: Vec<_> = (attributes.iter())
        .map(|attributes| {
            Some(wgpu::VertexBufferLayout {
                array_stride: attributes[0].format.size(),
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes,
            })
        })
        .collect();
    let other = (Encoding::Linear, "fs_linear");
    let is_picture = pass.outputs.is_empty();
    let is_other = is_picture && output.encoding == other.0;
    let targets: Vec<_> = if is_picture {
        vec![Some(picture_target(output.color))]
    } else {
        pass.outputs.iter().map(|it| Some(it.format.into())).collect()
    };
    let (depth, samples) = if is_picture {
        (output.depth, output.samples)
    } else {
        (wgpu::TextureFormat::Depth32Float, 1)
    };
    // Maps of lights have depths of their own.
    let is_reversed = output.is_depth_reversed && pass.draws != look::Draws::Lights;
    let nearer =
        if is_reversed { wgpu::CompareFunction::Greater } else { wgpu::CompareFunction::Less };
    let depth_stencil = wgpu::DepthStencilState {
        format: depth,
        depth_write_enabled: Some(true),
        depth_compare: Some(nearer),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(pass.name),
        layout: Some(&of.layout),
        vertex: wgpu::VertexState {
            module: &of.shader,
            entry_point: Some("vs_main"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &buffers,
        },
        primitive: wgpu::PrimitiveState {
            front_face: if sides.is_mirrored { wgpu::FrontFace::Cw } else { wgpu::FrontFace::Ccw },
            cull_mode: (!sides.shows_backs).then_some(wgpu::Face::Back),
            ..Default::default()
        },
        depth_stencil: Some(depth_stencil),
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module: &of.shader,
            entry_point: Some(if is_other { other.1 } else { "fs_main" }),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// The color target of the picture, into which straight colors are blended.
fn picture_target(format: wgpu::TextureFormat) -> wgpu::ColorTargetState {
    let over = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::SrcAlpha,
        dst_factor: wgpu::BlendFactor::OneMinusSrcAlpha,
        operation: wgpu::BlendOperation::Add,
    };
    wgpu::ColorTargetState {
        format,
        blend: Some(wgpu::BlendState { color: over, alpha: wgpu::BlendComponent::OVER }),
        write_mask: wgpu::ColorWrites::ALL,
    }
}

/// A depth buffer that is cleared to the depth of the far plane before it is used, and not read
/// after.
pub(crate) fn depth_attachment(
    view: &wgpu::TextureView,
    far: f32,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations {
            load: wgpu::LoadOp::Clear(far),
            store: wgpu::StoreOp::Discard,
        }),
        stencil_ops: None,
    }
}
