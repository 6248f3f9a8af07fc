//! What the compiler leaves out changes no bit, in the reference.
//!
//! Two things make a settled look of a look as it was written, and they are held against it one at
//! a time:
//!
//! - What is known before the fragment is computed there, once, in f64, and rounded once: folded
//!   constants, `prepare`, lights. As it was written a look computes the same in each fragment, and
//!   in f32 rounds at each step. The two differ by that; a bound holds it.
//! - What cannot change the result is removed, merged or replaced. That changes no bit: not in f64,
//!   where nothing is rounded, of any look; and not in f32, of looks whose values leave nothing to
//!   round when they are folded.

use std::path::{Path, PathBuf};

use crate::support::random::Random;
use crate::support::report::Errors;
use crate::support::{files, stacks};
use chiaro::compile::{Live, Options, compile};
use chiaro::diag::Diagnostic;
use chiaro::document::{Look, Node, Value};
use chiaro::frame::{Assets, EvalSample, SetupLook, eval_batches};
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::reference;
use glam::{DMat3, DVec2};

fn samples(seed: u64, count: usize) -> Vec<EvalSample> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|_| EvalSample {
            normal: random.direction(),
            view: random.direction(),
            position: random.direction() * random.unit(),
            camera: DMat3::from_quat(random.rotation()),
            frame: random.rotation(),
            uv: DVec2::new(random.unit(), random.unit()),
            kappa: random.between(-20.0, 20.0),
            vertex_color: [(); 4].map(|()| random.unit()),
            ..EvalSample::default()
        })
        .collect()
}

fn told(problems: &[Diagnostic]) -> String {
    problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

fn evaluate(
    look: &SetupLook,
    options: &Options,
    samples: &[EvalSample],
    precision: Precision,
) -> Vec<[f64; 4]> {
    let batches = eval_batches(look, Library::built_in(), samples, options, &mut Assets::default())
        .unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let mut values = vec![[f64::NAN; 4]; samples.len()];
    for batch in batches {
        let found =
            reference::evaluate(&batch, precision).unwrap_or_else(|problem| panic!("{problem}"));
        batch.indices.iter().zip(found).for_each(|(&index, value)| values[index] = value);
    }
    values
}

/// Holds one way of compiling a look against another.
fn compare(errors: &mut Errors, look: &SetupLook, ways: [&Options; 2], precision: Precision) {
    let samples = samples(5, 400);
    let [a, b] = ways.map(|options| evaluate(look, options, &samples, precision));
    for (index, (a, b)) in a.iter().flatten().zip(b.iter().flatten()).enumerate() {
        let place = || format!("{}, sample {}\n{}", look.look.name, index / 4, look.look.to_text());
        // 0 and -0 are not the same bits.
        let sign = if a == b && a.to_bits() != b.to_bits() { f64::MIN_POSITIVE } else { 0.0 };
        errors.note(*a + sign, *b, place);
    }
}

fn examples() -> Vec<SetupLook> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    let paths: Vec<PathBuf> = files::below(&folder)
        .into_iter()
        .filter(|path| path.extension().is_some_and(|e| e == "json"))
        .collect();
    assert!(paths.len() >= 6, "{paths:?}");
    let open = |path: PathBuf| {
        let loaded = Look::load(&chiaro::files::Disk, &path);
        SetupLook {
            look: loaded.value.expect("an example opens"),
            source: loaded.source.into(),
            folder: folder.clone(),
        }
    };
    paths.into_iter().map(open).collect()
}

fn unspecialized(live: Live) -> Options {
    Options { live, unspecialized: true, ..Options::default() }
}

fn specialized(live: Live) -> Options {
    Options { live, ..Options::default() }
}

fn stacks(count: usize) -> Vec<SetupLook> {
    let mut random = Random::new(70);
    (0..count).map(|_| stacks::idle_stack(&mut random)).collect()
}

/// The look with all numbers in 64ths: sums, halves and products of a few of them are exact in f32.
fn in_64ths(mut look: SetupLook) -> SetupLook {
    let exact = |x: &mut f64| *x = (*x * 64.0).round() / 64.0;
    for value in look.look.graph.nodes.values_mut().flat_map(|node| node.values.values_mut()) {
        match value {
            Value::Number(x) => exact(x),
            Value::Vector(v) => v.iter_mut().for_each(exact),
            _ => {}
        }
    }
    look
}

#[test]
fn nothing_that_is_removed_changes_a_bit_in_f64() {
    let mut errors = Errors::new("f64: specialized against as written", 0.0);
    for look in examples().into_iter().chain(stacks(40)) {
        compare(
            &mut errors,
            &look,
            [&specialized(Live::All), &unspecialized(Live::All)],
            Precision::F64,
        );
    }
    errors.finish();
}

#[test]
fn nothing_that_is_folded_or_removed_changes_a_bit_in_f32() {
    let mut errors = Errors::new("f32: baked against live", 0.0);
    let mut removed = 0;
    for look in examples().into_iter().chain(stacks(40)).map(in_64ths) {
        let baked = specialized(Live::Keyed);
        removed +=
            compile(&look.look, Library::built_in(), &baked).expect("it compiles").removed.len();
        compare(&mut errors, &look, [&baked, &specialized(Live::All)], Precision::F32);
    }
    errors.finish();
    assert!(removed > 100, "hardly anything was removed: {removed}");
}

/// A layer that ranges prove to cover is a sum of constants, and is rounded once where the shader
/// rounds twice.
#[test]
fn what_is_folded_in_an_example_differs_by_no_more_than_one_rounding() {
    let mut errors = Errors::new("f32: examples, baked against live", f64::from(f32::EPSILON));
    for look in examples() {
        compare(
            &mut errors,
            &look,
            [&specialized(Live::Keyed), &specialized(Live::All)],
            Precision::F32,
        );
    }
    errors.finish();
}

/// How many times as large as a look's narrowest ramp its angles are.
fn narrowness(look: &SetupLook) -> f64 {
    let angle = |node: &Node, port: &str| match node.values.get(port) {
        Some(Value::Number(angle)) => Some(*angle),
        _ => None,
    };
    let of = |node: &Node| {
        let (offset, cutoff) = (angle(node, "offset")?, angle(node, "cutoff")?);
        (cutoff > offset).then(|| cutoff / (cutoff - offset))
    };
    look.look.graph.nodes.values().filter_map(of).fold(1.0, f64::max)
}

/// What is computed once in f64 is closer to the truth than what is rounded at each step.
#[test]
fn rounding_once_is_within_a_few_steps_of_rounding_at_each_step() {
    let ways = [&specialized(Live::Keyed), &unspecialized(Live::All)];
    let mut errors = Errors::new("f32: baked against as written", 1e-6);
    for look in examples().into_iter().chain(stacks(40)) {
        // As it is written, the look's angles are rounded before they are subtracted: a few steps
        // of theirs are more steps of a ramp that is far narrower than its angles are large.
        let step = f64::from(f32::EPSILON) * narrowness(&look);
        if step > 2e-6 {
            let mut narrow = Errors::new("f32: the same with a narrow ramp", 2.0 * step);
            compare(&mut narrow, &look, ways, Precision::F32);
            narrow.finish();
        } else {
            compare(&mut errors, &look, ways, Precision::F32);
        }
    }
    errors.finish();
}
