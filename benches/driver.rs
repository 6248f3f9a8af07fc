//! Benchmark of drivers: the CPU time that a driver takes to compile generated modules.
//!
//! `MESA_SHADER_CACHE_DISABLE=true cargo bench --no-default-features --features gpu --bench driver
//! -- before=FOLDER now=FOLDER` compares modules of the same names in folders, which
//! `benches/driver/modules` exports, with a program of any commit. A word without `=` chooses the
//! modules whose names have it. A row of each module and folder has medians in CPU milliseconds
//! (all threads of the process): compilation by the driver, as a part of the first folder's with
//! its 95% interval, naga's reading and writing of the module, and a picture of 16x16 pixels.
//!
//! Compilation is that of the pipeline and of its first picture, less a second picture, less what
//! naga takes to write SPIR-V: drivers in software compile only where something is drawn. Folders
//! take turns, and a pipeline is never the second of its kind: a factor that differs each time
//! stands in the module, so that no cache knows it. docs/performance.md holds the figures.
#![allow(clippy::print_stdout, reason = "it is what a benchmark is for")]
#![allow(missing_docs, reason = "a program")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use chiaro::accuracy::TimeEstimate;
use chiaro::clock::Clock;
use chiaro::export::spirv_words;
use chiaro::render::Gpu;
use chiaro::wgsl;
use chiaro_test_drawing::wait::block_on;
use naga::{AddressSpace, Binding, Module, ShaderStage, TypeInner};
use wgpu::util::{BufferInitDescriptor, DeviceExt};

const ROUNDS: usize = 11;
/// Width and height of the pictures, in pixels.
const SIZE: u32 = 16;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// A triangle over the whole picture, for all attributes alike.
const CORNERS: [[f32; 4]; 3] =
    [[-1.0, -1.0, 0.5, 1.0], [3.0, -1.0, 0.5, 1.0], [-1.0, 3.0, 0.5, 1.0]];

/// A folder of modules, `NAME.wgsl`.
struct ModuleFolder {
    /// Word for the folder in the table.
    name: String,
    path: PathBuf,
}

impl ModuleFolder {
    fn file(&self, module: &str) -> PathBuf {
        self.path.join(format!("{module}.wgsl"))
    }
}

/// CPU times of one compilation, in milliseconds.
struct CompileTimes {
    /// Compilation by the driver.
    driver: f64,
    /// Reading and validation of WGSL, and writing of SPIR-V, by naga.
    naga: f64,
    /// A picture once everything is compiled.
    picture: f64,
}

/// CPU time of all threads of this process, in milliseconds; the time of a clock where the system
/// does not tell (`/proc`, Linux).
fn cpu_ms(clock: &Clock) -> f64 {
    // A running thread's time is brought up to date where the thread yields.
    std::thread::yield_now();
    let of_thread = |thread: std::fs::DirEntry| -> Option<f64> {
        let text = std::fs::read_to_string(thread.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse().ok()
    };
    std::fs::read_dir("/proc/self/task")
        .map(|threads| threads.flatten().filter_map(of_thread).sum::<f64>() * 1e-6)
        .unwrap_or_else(|_| clock.seconds() * 1e3)
}

/// The module with a factor of `1 + number / 1e6` on the picture's color, which no cache has met.
fn varied(text: &str, number: usize) -> String {
    let (head, result) = text.rsplit_once("return ").expect("a fragment stage, last in the module");
    let (result, tail) = result.split_once(';').expect("an end of the statement");
    format!("{head}return (1.0 + {number}e-6) * ({result});{tail}")
}

/// Locations of the attributes of the vertex stage.
fn attributes(module: &Module) -> Vec<u32> {
    let location = |binding: Option<&Binding>| match binding {
        Some(Binding::Location { location, .. }) => Some(*location),
        _ => None,
    };
    let vertex = module.entry_points.iter().find(|point| point.stage == ShaderStage::Vertex);
    let arguments = vertex.into_iter().flat_map(|point| &point.function.arguments);
    arguments
        .flat_map(|argument| match &module.types[argument.ty].inner {
            TypeInner::Struct { members, .. } => {
                members.iter().filter_map(|member| location(member.binding.as_ref())).collect()
            }
            _ => Vec::from_iter(location(argument.binding.as_ref())),
        })
        .collect()
}

fn pipeline(
    device: &wgpu::Device,
    shader: &wgpu::ShaderModule,
    locations: &[u32],
) -> wgpu::RenderPipeline {
    let attributes: Vec<[wgpu::VertexAttribute; 1]> = locations
        .iter()
        .map(|location| {
            let format = wgpu::VertexFormat::Float32x4;
            [wgpu::VertexAttribute { format, offset: 0, shader_location: *location }]
        })
        .collect();
    let buffers: Vec<_> = attributes
        .iter()
        .map(|attributes| {
            Some(wgpu::VertexBufferLayout {
                array_stride: attributes[0].format.size(),
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes,
            })
        })
        .collect();
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: wgpu::VertexState {
            module: shader,
            entry_point: Some("vs_main"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &buffers,
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Less),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: shader,
            entry_point: Some("fs_main"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: FORMAT,
                blend: Some(wgpu::BlendState::ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// An empty texture of one texel.
fn texture(
    device: &wgpu::Device,
    dimension: naga::ImageDimension,
    is_array: bool,
) -> wgpu::TextureView {
    let is_volume = dimension == naga::ImageDimension::D3;
    let is_cube = dimension == naga::ImageDimension::Cube;
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d {
            width: 1,
            height: 1,
            depth_or_array_layers: if is_cube { 6 } else { 1 },
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: if is_volume { wgpu::TextureDimension::D3 } else { wgpu::TextureDimension::D2 },
        format: FORMAT,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    let dimension = match (dimension, is_array) {
        (naga::ImageDimension::D3, _) => wgpu::TextureViewDimension::D3,
        (naga::ImageDimension::Cube, _) => wgpu::TextureViewDimension::Cube,
        (_, true) => wgpu::TextureViewDimension::D2Array,
        (_, false) => wgpu::TextureViewDimension::D2,
    };
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(dimension),
        ..wgpu::TextureViewDescriptor::default()
    })
}

/// Resources that a module reads: matrices of 1 in every uniform buffer, and empty textures.
fn bind_group(
    device: &wgpu::Device,
    module: &Module,
    layout: &wgpu::BindGroupLayout,
) -> wgpu::BindGroup {
    enum BoundResource {
        Buffer(wgpu::Buffer),
        Texture(wgpu::TextureView),
        Sampler(wgpu::Sampler),
    }
    // Bytes that a uniform buffer has at most.
    let units: Vec<u8> = (0..4096_u32)
        .flat_map(|at| if at % 16 % 5 == 0 { 1.0_f32 } else { 0.0 }.to_le_bytes())
        .collect();
    let bound: Vec<(u32, BoundResource)> = module
        .global_variables
        .iter()
        .filter_map(|(_, variable)| {
            let binding = variable.binding.as_ref()?.binding;
            let bound = match (variable.space, &module.types[variable.ty].inner) {
                (AddressSpace::Uniform, _) => {
                    BoundResource::Buffer(device.create_buffer_init(&BufferInitDescriptor {
                        label: None,
                        contents: &units,
                        usage: wgpu::BufferUsages::UNIFORM,
                    }))
                }
                (_, TypeInner::Sampler { .. }) => BoundResource::Sampler(
                    device.create_sampler(&wgpu::SamplerDescriptor::default()),
                ),
                (_, TypeInner::Image { dim, arrayed, .. }) => {
                    BoundResource::Texture(texture(device, *dim, *arrayed))
                }
                _ => return None,
            };
            Some((binding, bound))
        })
        .collect();
    let entries: Vec<_> = bound
        .iter()
        .map(|(binding, bound)| wgpu::BindGroupEntry {
            binding: *binding,
            resource: match bound {
                BoundResource::Buffer(buffer) => buffer.as_entire_binding(),
                BoundResource::Texture(view) => wgpu::BindingResource::TextureView(view),
                BoundResource::Sampler(sampler) => wgpu::BindingResource::Sampler(sampler),
            },
        })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
}

/// A device with a picture to draw on.
struct PictureTarget {
    gpu: Gpu,
    clock: Clock,
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
    corners: wgpu::Buffer,
}

impl PictureTarget {
    fn new(gpu: Gpu) -> Self {
        let attachment = |format| {
            let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let corners = CORNERS.as_flattened().iter().flat_map(|number| number.to_le_bytes());
        let corners = gpu.device.create_buffer_init(&BufferInitDescriptor {
            label: None,
            contents: &corners.collect::<Vec<u8>>(),
            usage: wgpu::BufferUsages::VERTEX,
        });
        let [color, depth] = [FORMAT, DEPTH].map(attachment);
        Self { gpu, clock: Clock::start(), color, depth, corners }
    }

    /// CPU milliseconds of `work`, and its result.
    fn timed<T>(&self, work: impl FnOnce() -> T) -> (f64, T) {
        let start = cpu_ms(&self.clock);
        let result = work();
        (cpu_ms(&self.clock) - start, result)
    }

    /// Draws the triangle and waits for the picture.
    fn draw(&self, pipeline: &wgpu::RenderPipeline, group: &wgpu::BindGroup, attributes: u32) {
        let mut encoder =
            self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, group, &[]);
        for slot in 0..attributes {
            pass.set_vertex_buffer(slot, self.corners.slice(..));
        }
        pass.draw(0..3, 0..1);
        drop(pass);
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.device.poll(wgpu::PollType::wait_indefinitely()).expect("a device that answers");
    }

    fn compile(&self, text: &str) -> CompileTimes {
        let device = &self.gpu.device;
        let valid = wgsl::parse(text).unwrap_or_else(|error| panic!("{}", error.message));
        let attributes = attributes(&valid.module);
        let (written, _) = self.timed(|| spirv_words(&valid).expect("SPIR-V can express it"));
        let source = wgpu::ShaderSource::Wgsl(text.into());
        let (read, shader) = self.timed(|| {
            device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
        });
        let (created, pipeline) = self.timed(|| pipeline(device, &shader, &attributes));
        let group = bind_group(device, &valid.module, &pipeline.get_bind_group_layout(0));
        let count = attributes.len() as u32;
        let [(first, ()), (second, ())] =
            [(); 2].map(|()| self.timed(|| self.draw(&pipeline, &group, count)));
        CompileTimes {
            driver: created + first - second - written,
            naga: read + written,
            picture: second,
        }
    }
}

/// Prints the rows of a module.
fn report(target: &PictureTarget, module: &str, folders: &[ModuleFolder]) {
    let folders: Vec<(&ModuleFolder, String)> = folders
        .iter()
        .filter_map(|folder| Some((folder, std::fs::read_to_string(folder.file(module)).ok()?)))
        .collect();
    let mut times: Vec<Vec<CompileTimes>> = folders.iter().map(|_| Vec::new()).collect();
    for round in 0..ROUNDS {
        for ((_, text), times) in folders.iter().zip(&mut times) {
            times.push(target.compile(&varied(text, round + 1)));
        }
    }
    let column = |times: &[CompileTimes], of: fn(&CompileTimes) -> f64| -> Vec<f64> {
        times.iter().map(of).collect()
    };
    let first = column(&times[0], |times| times.driver);
    for ((folder, _), times) in folders.iter().zip(&times) {
        let driver = column(times, |times| times.driver);
        let ratios: Vec<f64> = driver.iter().zip(&first).map(|(own, first)| own / first).collect();
        let ratio = TimeEstimate::of(&ratios);
        let [driver, naga, picture] =
            [driver, column(times, |times| times.naga), column(times, |times| times.picture)]
                .map(|times| TimeEstimate::of(&times).median);
        println!(
            "| {module} | {} | {driver:.1} | {:.2} ({:.2} to {:.2}) | {naga:.1} | {picture:.1} |",
            folder.name, ratio.median, ratio.low, ratio.high,
        );
    }
}

/// Names of the modules that draw looks in a folder.
fn modules(folder: &Path) -> BTreeSet<String> {
    let files = std::fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .flatten();
    // Passes before a look have a second word: `NAME.curvature.wgsl`.
    let stem = |name: &str| {
        name.strip_suffix(".wgsl").filter(|stem| !stem.contains('.')).map(str::to_owned)
    };
    files.filter_map(|file| stem(file.file_name().to_str()?)).collect()
}

fn main() {
    let arguments: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let folder = |argument: &String| {
        let (name, path) = argument.split_once('=')?;
        Some(ModuleFolder { name: name.to_owned(), path: path.into() })
    };
    let folders: Vec<ModuleFolder> = arguments.iter().filter_map(folder).collect();
    let words: Vec<&String> = arguments.iter().filter(|word| !word.contains('=')).collect();
    let Some(first) = folders.first() else {
        println!("nothing to compare: name folders of modules, as before=FOLDER now=FOLDER");
        return;
    };
    let target =
        PictureTarget::new(block_on(Gpu::headless()).expect("a GPU, a software one for one"));
    let cache = std::env::var("MESA_SHADER_CACHE_DISABLE").unwrap_or_default();
    println!("{}, MESA_SHADER_CACHE_DISABLE={cache}, {ROUNDS} rounds\n", target.gpu.name());
    println!("| look | modules | driver | of the first | naga | picture |");
    println!("| --- | --- | ---: | ---: | ---: | ---: |");
    for module in modules(&first.path) {
        if words.is_empty() || words.iter().any(|word| module.contains(word.as_str())) {
            report(&target, &module, &folders);
        }
    }
}
