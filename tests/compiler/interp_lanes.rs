//! Generated looks in the interpreter's lanes: every entry point compiles with all the resources
//! that it reads, and lanes give the values of single calls.

use std::path::{Path, PathBuf};

use chiaro_compiler::compile::{CompileOptions, Live, Stage, compile};
use chiaro_compiler::document::Look;
use chiaro_compiler::library::Library;
use chiaro_language::interp::{
    self, Bindings, LANES, LanePort, Lanes, Precision, Program, ResourceKind, Sampler, ScalarKind,
    Shape, Texture, TextureDimension, TextureLevel, Value,
};

use crate::support;

fn looks() -> Vec<PathBuf> {
    let folder = support::root().join("examples/looks");
    let mut files: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    files.sort();
    assert!(files.len() >= 10, "the example looks are gone");
    files
}

/// A fixed sequence of numbers, neither random nor regular (a linear congruential generator).
struct Numbers(u64);

impl Numbers {
    /// The next number, from 0 to 1.
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn value(&mut self, shape: &Shape) -> Value {
        match shape {
            Shape::Scalar(kind) => self.scalar(*kind).into(),
            Shape::Vector { kind, size } => {
                Value::Vector((0..*size).map(|_| self.scalar(*kind)).collect())
            }
            Shape::Matrix { columns, rows } => {
                let identity = |i: usize| f64::from(u8::from(i / rows == i % rows));
                let components =
                    (0..columns * rows).map(|i| identity(i) + 0.1 * self.next()).collect();
                Value::Matrix { columns: *columns, components }
            }
            Shape::Array { element, count } => {
                Value::Array((0..*count).map(|_| self.value(element)).collect())
            }
            Shape::Struct { members, .. } => {
                Value::Struct(members.iter().map(|(_, shape)| self.value(shape)).collect())
            }
        }
    }

    fn scalar(&mut self, kind: ScalarKind) -> interp::Scalar {
        match kind {
            ScalarKind::Bool => interp::Scalar::Bool(self.next() < 0.5),
            ScalarKind::I32 => interp::Scalar::I32((self.next() * 3.0) as i32),
            ScalarKind::U32 => interp::Scalar::U32((self.next() * 3.0) as u32),
            ScalarKind::Float => interp::Scalar::Float(self.next()),
        }
    }
}

/// A binding for every resource that a program reads.
fn bindings(program: &Program, numbers: &mut Numbers) -> Bindings {
    let mut bindings = Bindings::new();
    for resource in program.resources() {
        let (group, binding) = (resource.group, resource.binding);
        match &resource.kind {
            ResourceKind::Buffer(shape) => bindings.buffer(group, binding, numbers.value(shape)),
            ResourceKind::Unsized { head, element } => {
                let elements = Value::Array((0..7).map(|_| numbers.value(element)).collect());
                let value = match head {
                    None => elements,
                    Some(head) => {
                        let mut members: Vec<Value> =
                            head.iter().map(|(_, shape)| numbers.value(shape)).collect();
                        members.push(elements);
                        Value::Struct(members)
                    }
                };
                bindings.buffer(group, binding, value)
            }
            ResourceKind::Texture { dimension, .. } => {
                let size = match dimension {
                    TextureDimension::D1 => [4, 1, 1],
                    TextureDimension::D2 => [8, 4, 1],
                    TextureDimension::D3 => [4, 4, 4],
                    TextureDimension::Cube => [4, 4, 6],
                };
                let count = size.iter().product::<u32>();
                let texels = (0..count).map(|_| std::array::from_fn(|_| numbers.next())).collect();
                let texture =
                    Texture::new(*dimension, vec![TextureLevel::f64(size, texels)]).unwrap();
                bindings.texture(group, binding, texture)
            }
            ResourceKind::Sampler { .. } => bindings.sampler(group, binding, Sampler::default()),
        };
    }
    bindings
}

/// Writes an input that varies linearly from lane to lane, by up to `bend`; with `bend` 0 it is the
/// same in all lanes.
fn write(lanes: &mut Lanes<'_>, port: &LanePort, numbers: &mut Numbers, bend: f64) {
    for component in 0..port.size {
        let (base, slope) = (numbers.next() * 2.0 - 1.0, bend * (numbers.next() - 0.5));
        let values: Vec<f64> = (0..LANES).map(|lane| base + slope * lane as f64).collect();
        lanes.write(port, component, &values);
    }
}

fn components(value: &Value) -> Vec<u64> {
    match value.parts() {
        Some(parts) => parts.iter().flat_map(components).collect(),
        // The bits of a NaN may depend on the order of operands, so all NaNs count as equal.
        None => value
            .components()
            .unwrap()
            .iter()
            .map(|x| if x.is_nan() { 0 } else { x.to_bits() })
            .collect(),
    }
}

/// A value for every argument of a program.
fn arguments(program: &Program, numbers: &mut Numbers) -> Vec<Value> {
    program.parameters().iter().map(|parameter| numbers.value(&parameter.shape)).collect()
}

#[test]
fn every_look_runs_in_lanes_as_it_runs_alone() {
    let mut entry_points = 0;
    for path in looks() {
        let look = Look::load(&crate::support::chiaro_files::Disk, &path).value.unwrap();
        for (stage, live) in
            [(Stage::Draw, Live::Exposed), (Stage::Normals, Live::All), (Stage::Eval, Live::All)]
        {
            let options = CompileOptions { live, stage, ..CompileOptions::default() };
            let shader = compile(&look, Library::built_in(), &options).unwrap().value;
            let module = &shader.valid.module;
            for entry in &module.entry_points {
                if entry.stage == naga::ShaderStage::Compute {
                    continue;
                }
                let program = Program::compile(
                    module,
                    &entry.name,
                    interp::FunctionOptions::stage(&interp::Literals::of(&shader.wgsl)),
                )
                .unwrap_or_else(|error| panic!("{} {}: {error}", path.display(), entry.name));
                assert!(
                    program
                        .inputs()
                        .iter()
                        .chain(program.outputs())
                        .all(|port| port.binding.is_some())
                );
                compare(&program, &path);
                entry_points += 1;
            }
        }
    }
    assert!(entry_points >= 50, "only {entry_points} entry points");
}

fn compare(program: &Program, path: &Path) {
    for precision in [Precision::F64, Precision::F32] {
        let mut numbers = Numbers(7);
        let bindings = bindings(program, &mut numbers);
        let bound = program.bind(&bindings, precision).unwrap();
        let mut lanes = bound.lanes().unwrap();
        let mut machine = bound.machine();
        // A single call has no derivatives, so all lanes of a quad get the same arguments.
        let quads: Vec<Vec<Value>> =
            (0..LANES / 4).map(|_| arguments(program, &mut numbers)).collect();
        for lane in 0..LANES {
            lanes.set(lane, &quads[lane / 4]).unwrap();
        }
        let discarded = lanes.run(LANES).unwrap().discarded;
        for lane in (0..LANES).filter(|lane| discarded >> lane & 1 == 0) {
            let alone = machine.call(&quads[lane / 4]).unwrap();
            assert_eq!(
                components(&lanes.get(lane)),
                components(&alone),
                "{} lane {lane}",
                path.display()
            );
        }
    }
}

/// Prints the time of an instruction: `cargo test --release -p chiaro-compiler --test compiler
/// interp_lanes -- --ignored --nocapture`.
#[test]
#[ignore = "it measures, and asserts nothing"]
#[expect(clippy::disallowed_methods, clippy::print_stdout, reason = "it measures")]
fn measure() {
    for path in looks() {
        let look = Look::load(&crate::support::chiaro_files::Disk, &path).value.unwrap();
        let shader = compile(&look, Library::built_in(), &CompileOptions::default()).unwrap().value;
        let program = Program::compile(
            &shader.valid.module,
            "fs_main",
            interp::FunctionOptions::stage(&interp::Literals::of(&shader.wgsl)),
        )
        .unwrap();
        for precision in [Precision::F64, Precision::F32] {
            let mut numbers = Numbers(7);
            let bindings = bindings(&program, &mut numbers);
            let bound = program.bind(&bindings, precision).unwrap();
            let mut lanes = bound.lanes().unwrap();
            let (mut steps, mut batches) = (0, 0);
            let mut spent = std::time::Duration::ZERO;
            while spent.as_secs_f64() < 0.5 {
                program
                    .inputs()
                    .iter()
                    .for_each(|port| write(&mut lanes, port, &mut numbers, 0.02));
                let start = std::time::Instant::now();
                steps += lanes.run(LANES).unwrap().steps;
                spent += start.elapsed();
                batches += 1;
            }
            let lane_seconds = spent.as_secs_f64() / LANES as f64;
            println!(
                "{:28} {precision:?}: {:5.0} instructions, {:.2} ns each per lane, {:.2} us per \
                 pixel",
                path.file_stem().unwrap().display(),
                steps as f64 / f64::from(batches),
                1e9 * lane_seconds / steps as f64,
                1e6 * lane_seconds / f64::from(batches)
            );
        }
    }
}

/// Prints the time of an instruction in a single call, as constant folding makes them.
#[test]
#[ignore = "it measures, and asserts nothing"]
#[expect(clippy::disallowed_methods, clippy::print_stdout, reason = "it measures")]
fn measure_alone() {
    let source = "fn f(n: i32) -> f32 \
                  { var s = 0.0; for (var i = 1; i <= n; i++) { s += 1.0 / f32(i); } return s; }";
    let module = chiaro_language::wgsl::parse(source).unwrap().module;
    let program = Program::compile(&module, "f", interp::FunctionOptions::default()).unwrap();
    let mut machine = program.machine(Precision::F64);
    let start = std::time::Instant::now();
    for _ in 0..100 {
        machine.call(&[Value::I32(100_000)]).unwrap();
    }
    println!("{:.2} ns per round of a loop that sums 1/i", start.elapsed().as_secs_f64() * 100.0);
}
