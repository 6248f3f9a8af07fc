//! Surface samples and pictures through the library, as `chiaro eval` and `chiaro render` run them.

use std::cell::Cell;
use std::ops::{Deref, DerefMut};
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError, TryLockError};

use chiaro_compiler::compile::{CompileOptions, Live};
use chiaro_compiler::document::{Look, Scene, Tier};
use chiaro_compiler::library::{Library, Type};
use chiaro_language::diag::Diagnostic;
use chiaro_language::ids::{NodePath, ObjectId, PortName};
use chiaro_language::wgsl::code;
use chiaro_render::{Gpu, Picture, Renderer};
use chiaro_scene::frame::{
    Assets, EvalSample, PlanOptions, Planner, Setup, SetupLook, SetupObject, eval_batches,
    object_matrix,
};
use chiaro_scene::geometry::Mesh;
use chiaro_test_support::wait::block_on;

/// A renderer that a test has for as long as it holds this.
pub struct RendererLoan {
    kind: LoanKind,
}

enum LoanKind {
    /// One of the two that the test program has.
    Shared(MutexGuard<'static, Renderer>),
    /// One for this test alone.
    Own(Box<Renderer>),
}

thread_local! {
    /// True while this thread holds a shared renderer: waiting for another, it could wait for
    /// itself.
    static HOLDS_SHARED: Cell<bool> = const { Cell::new(false) };
}

impl Deref for RendererLoan {
    type Target = Renderer;

    fn deref(&self) -> &Renderer {
        match &self.kind {
            LoanKind::Shared(renderer) => renderer,
            LoanKind::Own(renderer) => renderer,
        }
    }
}

impl DerefMut for RendererLoan {
    fn deref_mut(&mut self) -> &mut Renderer {
        match &mut self.kind {
            LoanKind::Shared(renderer) => renderer,
            LoanKind::Own(renderer) => renderer,
        }
    }
}

impl Drop for RendererLoan {
    fn drop(&mut self) {
        if matches!(self.kind, LoanKind::Shared(_)) {
            HOLDS_SHARED.set(false);
        }
    }
}

/// A renderer of the test program that is free; tests that find none free wait for one. A test that
/// holds one already is given one of its own, on a device that is there.
pub fn renderer() -> RendererLoan {
    static GPUS: [OnceLock<Gpu>; 2] = [const { OnceLock::new() }; 2];
    static RENDERERS: [OnceLock<Mutex<Renderer>>; 2] = [const { OnceLock::new() }; 2];
    let gpu = |index: usize| {
        let make = || block_on(Gpu::headless()).expect("a Vulkan device, lavapipe for one");
        GPUS[index].get_or_init(make).clone()
    };
    if HOLDS_SHARED.get() {
        return RendererLoan { kind: LoanKind::Own(Box::new(Renderer::new(gpu(0)))) };
    }
    let shared =
        |index: usize| RENDERERS[index].get_or_init(|| Mutex::new(Renderer::new(gpu(index))));
    let lend = |renderer| {
        HOLDS_SHARED.set(true);
        RendererLoan { kind: LoanKind::Shared(renderer) }
    };
    for index in 0..RENDERERS.len() {
        match shared(index).try_lock() {
            Ok(free) => return lend(free),
            Err(TryLockError::Poisoned(poisoned)) => return lend(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => {}
        }
    }
    lend(shared(0).lock().unwrap_or_else(PoisonError::into_inner))
}

/// A look of JSON, read without any diagnostic; exact, if it names no tier.
pub fn look(json: &serde_json::Value) -> SetupLook {
    let text = serde_json::to_string_pretty(json).expect("JSON");
    let loaded = Look::read(&text, "test.json");
    let problems: Vec<String> = loaded.diagnostics.iter().map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{}\n{text}", problems.join("\n"));
    let mut look = loaded.value.expect("a look");
    look.tier.get_or_insert(Tier::Exact);
    SetupLook { look, source: loaded.source.into(), folder: PathBuf::new() }
}

/// Options that show one output, `node.port`, and keep exposed parameters live.
pub fn options(output: &str) -> CompileOptions {
    let (node, port) = output.rsplit_once('.').unwrap_or((output, ""));
    let root = (!output.is_empty()).then(|| (NodePath::parse(node), PortName::from(port)));
    CompileOptions { root, live: Live::Exposed, ..CompileOptions::default() }
}

/// Text of the first ten problems, a line each.
pub fn told(problems: &[Diagnostic]) -> String {
    problems.iter().take(10).map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

/// Values of the look at each sample, or of one output (`node.port`).
pub fn eval(look: &SetupLook, output: &str, samples: &[EvalSample]) -> Vec<[f64; 4]> {
    eval_with(look, Library::built_in(), &options(output), samples)
}

/// [`eval`] with any library and options. An angle is given in radians, in the first number.
pub fn eval_with(
    look: &SetupLook,
    library: &Library,
    options: &CompileOptions,
    samples: &[EvalSample],
) -> Vec<[f64; 4]> {
    eval_on(&mut renderer(), look, library, options, samples)
}

/// Hands `sink` everything that the values of a look's samples depend on, except the engines that
/// run the shaders: modules without their comments, numbers and images.
pub fn content(
    look: &SetupLook,
    library: &Library,
    options: &CompileOptions,
    samples: &[EvalSample],
    sink: &mut dyn FnMut(&[u8]),
) {
    let batches = eval_batches(look, library, samples, options, &mut Assets::default())
        .unwrap_or_else(|problems| panic!("{}\n{}", told(&problems), look.look.to_text()));
    for batch in &batches {
        sink(code(&batch.shader.wgsl).as_bytes());
        let numbers = batch.samples.numbers.iter().flat_map(|number| number.to_le_bytes());
        sink(&numbers.collect::<Vec<u8>>());
        batch.images.iter().for_each(|image| sink(&image.bytes));
    }
}

/// Values of [`eval`] with any library and options, on any device.
pub fn eval_on(
    renderer: &mut Renderer,
    look: &SetupLook,
    library: &Library,
    options: &CompileOptions,
    samples: &[EvalSample],
) -> Vec<[f64; 4]> {
    let batches = eval_batches(look, library, samples, options, &mut Assets::default())
        .unwrap_or_else(|problems| panic!("{}\n{}", told(&problems), look.look.to_text()));
    let mut answers = vec![[f64::NAN; 4]; samples.len()];
    for batch in &batches {
        let values = block_on(renderer.evaluate(batch)).unwrap_or_else(|error| {
            panic!("{error}\n{}\n{}", look.look.to_text(), batch.shader.wgsl)
        });
        for (&index, value) in batch.indices.iter().zip(values) {
            let [a, b, ..] = value.map(f64::from);
            answers[index] = match batch.shader.root_type {
                Type::Angle => [2.0 * a.atan2(b), 0.0, 0.0, 0.0],
                _ => value.map(f64::from),
            };
        }
    }
    answers
}

/// [`eval`] on the reference, in the exact tier as written: nothing folded, every value in f64.
pub fn truth(look: &SetupLook, output: &str, samples: &[EvalSample]) -> Vec<[f64; 4]> {
    let options = CompileOptions { unspecialized: true, ..options(output) };
    let batches =
        eval_batches(look, Library::built_in(), samples, &options, &mut Assets::default())
            .unwrap_or_else(|problems| panic!("{}\n{}", told(&problems), look.look.to_text()));
    let mut answers = vec![[f64::NAN; 4]; samples.len()];
    for batch in &batches {
        let values = chiaro_reference::evaluate(batch, chiaro_language::interp::Precision::F64)
            .unwrap_or_else(|problem| panic!("{problem}\n{}", batch.shader.wgsl));
        for (&index, value) in batch.indices.iter().zip(values) {
            let [a, b, ..] = value;
            answers[index] = match batch.shader.root_type {
                Type::Angle => [2.0 * a.atan2(b), 0.0, 0.0, 0.0],
                _ => value,
            };
        }
    }
    answers
}

/// A scene of one mesh that wears `look`, in the mesh's own size (not fitted).
pub fn scene(look: SetupLook, mesh: Mesh, scene: Scene) -> Setup {
    scene_of(vec![(look, mesh, glam::DMat4::IDENTITY)], scene)
}

/// A scene of several meshes, each with its look and its place.
pub fn scene_of(parts: Vec<(SetupLook, Mesh, glam::DMat4)>, scene: Scene) -> Setup {
    let mut setup = Setup { scene, ..Setup::default() };
    for (index, (look, mesh, world_from_object)) in parts.into_iter().enumerate() {
        setup.objects.push(SetupObject {
            id: ObjectId::new(format!("object_{index}")),
            looks: vec![Some(index); mesh.parts.len()],
            mesh: mesh.into(),
            world_from_object,
            values: Default::default(),
            light_link: Default::default(),
            shadow_link: Default::default(),
            layers: Default::default(),
            animation: None,
        });
        setup.looks.push(look);
    }
    setup
}

/// An own shape, with the matrix that fits it into a sphere of radius 1.
pub fn shape(name: &str) -> (Mesh, glam::DMat4) {
    let mesh = Assets::default()
        .mesh(std::path::Path::new(""), &format!("shape:{name}"))
        .expect("a shape")
        .value;
    let matrix = object_matrix(&chiaro_compiler::document::Transform::default(), &mesh);
    (Mesh::clone(&mesh), matrix)
}

/// Draws a picture of a scene.
pub fn draw(
    setup: &Setup,
    library: &Library,
    live: &Live,
    size: [u32; 2],
    samples: u32,
) -> Picture {
    let options = PlanOptions { size, samples, time: 0.0 };
    let plan = Planner::default()
        .plan(setup, library, live, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value;
    block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"))
}
