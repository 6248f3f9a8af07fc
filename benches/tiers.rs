//! Benchmark of cheaper forms of nodes: each candidate against the exact form, on the GPU.
//!
//! `cargo bench --no-default-features --features gpu --bench tiers [-- FILTER]` prints a table for
//! each file of `benches/tiers/` (`-- looks` or `-- looks/figure6`: for the example looks, as whole
//! frames; `-- curvature`: for its tiers and per vertex, with errors); docs/performance.md holds
//! the figures. Such a file is WGSL with functions `fn name(n: vec3f, l: vec3f, s: f32) -> f32`:
//! the others are compared with `exact`, and `nothing` is the cost that all of them share. Each
//! function is drawn over the whole target, many times in each pixel, with unit vectors n and l
//! that change smoothly over the screen and s in [-1, 1]. All functions of a file take turns, round
//! by round; a ratio is the median over the rounds of (candidate - nothing) / (exact - nothing),
//! with its 95% confidence interval.
#![allow(clippy::print_stdout, reason = "what it is for")]
#![allow(missing_docs, reason = "a program")]

#[path = "tiers/curvature.rs"]
mod curvature;
use std::path::{Path, PathBuf};

use chiaro::compile::Live;
use chiaro::document::Tier;
use chiaro::frame::{Assets, FramePlan, PlanOptions, Planner, open};
use chiaro::library::Library;
use chiaro::render::{Gpu, Renderer};
use chiaro::wgsl::{Declaration, DeclarationKind, NamedSource, link, scan};
use chiaro_test_drawing::wait::block_on;

const SIZE: u32 = 256;
const REPEATS: u32 = 32;
const ROUNDS: usize = 41;

const FRAME: &str = "
@group(0) @binding(0) var<uniform> repeats: vec4u;
@group(0) @binding(1) var image: texture_2d<f32>;
@group(0) @binding(2) var linear_sampler: sampler;
@group(0) @binding(3) var nearest_sampler: sampler;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn fs_main(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let place = at.xy / 128.0 - 1.0;
    var sum = 0.0;
    for (var i = 0u; i < repeats.x; i++) {
        let t = f32(i) * 0.1963;
        let n = normalize(vec3f(place.x + t * 0.1, place.y - t * 0.05, 0.3 + t));
        let l = normalize(vec3f(place.y + t, 1.5 - t, place.x * 0.7));
        sum += CANDIDATE(n, l, clamp(place.x * 0.7 + 0.3 - 0.1 * t, -1.0, 1.0));
    }
    return vec4f(sum);
}
";

struct Candidate {
    name: String,
    pipeline: wgpu::RenderPipeline,
    times: Vec<f64>,
}

struct Bench {
    gpu: Gpu,
    view: wgpu::TextureView,
    layout: wgpu::BindGroupLayout,
    group: wgpu::BindGroup,
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    read: wgpu::Buffer,
}

impl Bench {
    fn new(gpu: Gpu) -> Self {
        let device = &gpu.device;
        let target = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        let buffer = |size, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let uniform = buffer(16, wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST);
        let numbers: Vec<u8> = [REPEATS, 0, 0, 0].iter().flat_map(|x| x.to_le_bytes()).collect();
        gpu.queue.write_buffer(&uniform, 0, &numbers);
        let queries = device.create_query_set(&wgpu::QuerySetDescriptor {
            label: None,
            ty: wgpu::QueryType::Timestamp,
            count: 2,
        });
        let resolved = buffer(16, wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC);
        let read = buffer(16, wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        let view = target.create_view(&wgpu::TextureViewDescriptor::default());
        let (layout, group) = bindings(&gpu, &uniform);
        Self { gpu, view, layout, group, queries, resolved, read }
    }

    fn candidate(&self, name: &str, library: &str) -> Candidate {
        let source = format!("{library}\n{}", FRAME.replace("CANDIDATE", name));
        let device = &self.gpu.device;
        // Our own validator has no f16, so such modules are not validated here.
        if !source.starts_with("enable") {
            chiaro::wgsl::parse(&source)
                .unwrap_or_else(|error| panic!("{name}: {}", error.message));
        }
        let source = wgpu::ShaderSource::Wgsl(source.into());
        let module =
            device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(name), source });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(name),
            layout: Some(&device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: None,
                bind_group_layouts: &[Some(&self.layout)],
                immediate_size: 0,
            })),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vs_main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fs_main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(wgpu::TextureFormat::Rgba32Float.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Candidate { name: name.to_owned(), pipeline, times: Vec::new() }
    }

    /// Time of one pass, in milliseconds.
    fn time(&self, candidate: &Candidate) -> f64 {
        let device = &self.gpu.device;
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &self.view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations::default(),
                })],
                timestamp_writes: Some(wgpu::RenderPassTimestampWrites {
                    query_set: &self.queries,
                    beginning_of_pass_write_index: Some(0),
                    end_of_pass_write_index: Some(1),
                }),
                ..wgpu::RenderPassDescriptor::default()
            });
            pass.set_pipeline(&candidate.pipeline);
            pass.set_bind_group(0, &self.group, &[]);
            pass.draw(0..3, 0..1);
        }
        encoder.resolve_query_set(&self.queries, 0..2, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.read, 0, 16);
        self.gpu.queue.submit([encoder.finish()]);
        self.read.slice(..).map_async(wgpu::MapMode::Read, |_| {});
        device.poll(wgpu::PollType::wait_indefinitely()).expect("a device that answers");
        let bytes = self.read.slice(..).get_mapped_range().expect("mapped").to_vec();
        self.read.unmap();
        let tick =
            |at: usize| u64::from_le_bytes(bytes[at..at + 8].try_into().expect("eight bytes"));
        (tick(8) - tick(0)) as f64 * f64::from(self.gpu.queue.get_timestamp_period()) * 1e-6
    }
}

/// Bindings of the numbers, and of a picture of 512x512 texels with its samplers.
fn bindings(gpu: &Gpu, uniform: &wgpu::Buffer) -> (wgpu::BindGroupLayout, wgpu::BindGroup) {
    let device = &gpu.device;
    let size = wgpu::Extent3d { width: 512, height: 512, depth_or_array_layers: 1 };
    let image = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let texels: Vec<u8> =
        (0..512 * 512 * 4_u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    let rows = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(512 * 4),
        rows_per_image: None,
    };
    gpu.queue.write_texture(image.as_image_copy(), &texels, rows, size);
    let sampler = |filter| {
        let repeat = wgpu::AddressMode::Repeat;
        device.create_sampler(&wgpu::SamplerDescriptor {
            address_mode_u: repeat,
            address_mode_v: repeat,
            mag_filter: filter,
            min_filter: filter,
            ..wgpu::SamplerDescriptor::default()
        })
    };
    let samplers = [wgpu::FilterMode::Linear, wgpu::FilterMode::Nearest].map(sampler);
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty,
        count: None,
    };
    let numbers = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Uniform,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let texture = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: true },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let filtering = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: None,
        entries: &[entry(0, numbers), entry(1, texture), entry(2, filtering), entry(3, filtering)],
    });
    let view = image.create_view(&wgpu::TextureViewDescriptor::default());
    let bound = |binding, resource| wgpu::BindGroupEntry { binding, resource };
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &layout,
        entries: &[
            bound(0, uniform.as_entire_binding()),
            bound(1, wgpu::BindingResource::TextureView(&view)),
            bound(2, wgpu::BindingResource::Sampler(&samplers[0])),
            bound(3, wgpu::BindingResource::Sampler(&samplers[1])),
        ],
    });
    (layout, group)
}

fn median(numbers: &mut [f64]) -> (f64, f64, f64) {
    numbers.sort_by(f64::total_cmp);
    // The order statistics that enclose the median in 95 of 100 samples.
    let (n, spread) = (numbers.len() as f64, 0.98 * (numbers.len() as f64).sqrt());
    let at = |x: f64| numbers[(x.max(0.0) as usize).min(numbers.len() - 1)];
    (at(n / 2.0), at(n / 2.0 - spread), at(n / 2.0 + spread))
}

fn run(bench: &Bench, file: &Path) {
    let text = std::fs::read_to_string(file).expect("a file that can be read");
    let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    // naga requires the directive at the start, before imported code.
    let (enabled, text) =
        text.strip_prefix("enable f16;").map_or(("", &*text), |rest| ("enable f16;\n", rest));
    if !enabled.is_empty() && !bench.gpu.device.features().contains(wgpu::Features::SHADER_F16) {
        println!("\n{name}: this adapter has no f16");
        return;
    }
    let linked = link(&[NamedSource { name: &name, text }])
        .unwrap_or_else(|problems| panic!("{problems:?}"));
    let own = scan(text);
    let library = format!("{enabled}{}", linked.text);
    let is_candidate =
        |d: &Declaration| d.fields.iter().map(|field| field.name.as_str()).eq(["n", "l", "s"]);
    let mut candidates: Vec<Candidate> = own
        .declarations
        .iter()
        .filter(|d| d.kind == DeclarationKind::Function && is_candidate(d))
        .map(|d| bench.candidate(&d.name, &library))
        .collect();
    for round in 0..ROUNDS + 3 {
        for candidate in &mut candidates {
            let time = bench.time(candidate);
            if round >= 3 {
                candidate.times.push(time);
            }
        }
    }
    let times = |name: &str| {
        candidates.iter().find(|c| c.name == name).map(|c| c.times.clone()).expect("the function")
    };
    let (nothing, exact) = (times("nothing"), times("exact"));
    println!(
        "\n{name}\n| form | ns per evaluation | of exact | 95% interval |\n| --- | ---: | ---: | \
         --- |"
    );
    let per = 1e6 / f64::from(SIZE * SIZE * REPEATS);
    for candidate in candidates.iter().filter(|c| c.name != "nothing") {
        let own = |round: usize| candidate.times[round] - nothing[round];
        let mut costs: Vec<f64> = (0..ROUNDS).map(|round| own(round) * per).collect();
        let mut ratios: Vec<f64> =
            (0..ROUNDS).map(|round| own(round) / (exact[round] - nothing[round])).collect();
        let (ratio, low, high) = median(&mut ratios);
        println!(
            "| {} | {:.2} | {ratio:.3} | {low:.3} to {high:.3} |",
            candidate.name,
            median(&mut costs).0
        );
    }
}

/// Time of a whole frame, passes included, by the clock, in milliseconds: looks have no timestamps
/// of their own.
#[expect(clippy::disallowed_methods, reason = "a benchmark reads the clock")]
fn frame_time(renderer: &mut Renderer, plan: &FramePlan) -> f64 {
    let start = std::time::Instant::now();
    block_on(renderer.draw(plan)).expect("a look that draws");
    renderer.gpu().device.poll(wgpu::PollType::wait_indefinitely()).expect("a device that answers");
    start.elapsed().as_secs_f64() * 1e3
}

/// Prints the times of whole frames of the example looks in each tier, the tiers taking turns.
fn looks(filter: &str) {
    let mut renderer = Renderer::new(gpu());
    println!(
        "\nwhole frames, 800x600, one sample a pixel\n| look | exact | balanced | of exact | fast \
         | of exact |"
    );
    println!("| --- | ---: | ---: | --- | ---: | --- |");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    for file in files.iter().filter(|file| file.to_string_lossy().contains(filter)) {
        let mut assets = Assets::default();
        let mut setup =
            open(file, None, &mut assets).unwrap_or_else(|problems| panic!("{problems:?}")).value;
        let mut plans = Vec::new();
        for tier in [Tier::Exact, Tier::Balanced, Tier::Fast] {
            // No two frames in a row have the same camera, or passes would be left out because
            // nothing changed.
            for _ in 0..2 {
                setup.looks.iter_mut().for_each(|worn| worn.look.tier = Some(tier));
                setup.scene.camera.target = [0.002 * plans.len() as f64, 0.0, 0.0];
                let options = PlanOptions { size: [800, 600], samples: 1, time: 0.0 };
                let plan =
                    Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
                plans.push(plan.unwrap_or_else(|problems| panic!("{problems:?}")).value);
            }
        }
        let mut times = [const { Vec::new() }; 3];
        for round in 0..ROUNDS + 3 {
            for (tier, times) in times.iter_mut().enumerate() {
                let time = frame_time(&mut renderer, &plans[2 * tier + round % 2]);
                if round >= 3 {
                    times.push(time);
                }
            }
        }
        let ratio = |tier: usize| {
            let mut ratios: Vec<f64> =
                times[tier].iter().zip(&times[0]).map(|(own, exact)| own / exact).collect();
            let (ratio, low, high) = median(&mut ratios);
            format!("{ratio:.3} ({low:.3} to {high:.3})")
        };
        let of = [ratio(1), ratio(2)];
        let milliseconds = times.map(|mut times| median(&mut times).0);
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        let [exact, balanced, fast] = milliseconds;
        println!(
            "| {name} | {exact:.2} ms | {balanced:.2} ms | {} | {fast:.2} ms | {} |",
            of[0], of[1]
        );
    }
}

/// A GPU as `Gpu::headless` opens it, with 16-bit numbers if the adapter has them.
fn gpu() -> Gpu {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::PRIMARY;
    let adapter = block_on(
        wgpu::Instance::new(descriptor).request_adapter(&wgpu::RequestAdapterOptions::default()),
    );
    let adapter = adapter.expect("a GPU, a software one for one");
    let wanted = wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::SHADER_F16;
    let required_features = adapter.features() & wanted;
    let descriptor =
        wgpu::DeviceDescriptor { required_features, ..wgpu::DeviceDescriptor::default() };
    let (device, queue) = block_on(adapter.request_device(&descriptor)).expect("a device");
    Gpu::new(device, queue, adapter.get_info())
}

fn main() {
    let filter =
        std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();
    let bench = Bench::new(gpu());
    println!("{}", bench.gpu.name());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/tiers");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    if filter == "curvature" {
        curvature::check();
        return curvature::run(gpu());
    }
    if let Some(filter) = filter.strip_prefix("looks") {
        return looks(filter.trim_start_matches('/'));
    }
    for file in files.iter().filter(|file| file.to_string_lossy().contains(&filter)) {
        run(&bench, file);
    }
}
