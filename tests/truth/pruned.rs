//! Parts of a look that the compiler leaves out, and forms that it takes where facts hold, change
//! nothing but the last digits, in the reference.
//!
//! Two transformations make a specialized look of a look as written, and each is tested against it:
//!
//! - Values known before the fragment are computed there, once, in f64, and rounded once: folded
//!   constants, `prepare`, lights. As written, a look computes the same in each fragment, and in
//!   f32 rounds at each step. The two differ by that rounding; a bound limits it.
//! - Parts that cannot change the result are removed, merged or replaced, and functions take the
//!   forms of their `@where` rules. Algebra says that the result is the same, so that in f64 it
//!   differs by a few roundings of f64 alone, in any look; and in f32 by a few of f32, in looks
//!   whose values leave nothing to round when they are folded.

use crate::support::eval::content;
use crate::support::examples::{looks, samples};
use crate::support::ledger::{Ledger, ProofKey, is_found_false};
use crate::support::random::Random;
use crate::support::report::Errors;
use crate::support::{halved, stacks};
use chiaro::compile::{CompileOptions, Live, compile};
use chiaro::diag::Diagnostic;
use chiaro::document::{MAX_ERROR, Node, Tier, Value};
use chiaro::frame::{Assets, SetupLook, eval_batches};
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::reference;

fn told(problems: &[Diagnostic]) -> String {
    problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

fn evaluate(
    look: &SetupLook,
    library: &Library,
    options: &CompileOptions,
    precision: Precision,
) -> Vec<[f64; 4]> {
    let samples = samples(5, 400);
    let batches = eval_batches(look, library, &samples, options, &mut Assets::default())
        .unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let mut values = vec![[f64::NAN; 4]; samples.len()];
    for batch in batches {
        let found =
            reference::evaluate(&batch, precision).unwrap_or_else(|problem| panic!("{problem}"));
        batch.indices.iter().zip(found).for_each(|(&index, value)| values[index] = value);
    }
    values
}

/// Two ways of compiling a look that are compared, and the difference that they may have.
#[derive(Clone)]
struct Comparison {
    name: &'static str,
    /// Tier of a look that names none, and the options.
    ways: [(Option<Tier>, CompileOptions); 2],
    precision: Precision,
    bound: f64,
}

impl Comparison {
    /// The largest difference, as a proof for the ledger.
    fn proof(&self, look: &SetupLook, library: &Library) -> Result<f64, String> {
        let mut errors = Errors::new(self.name, self.bound);
        let [a, b] = self.ways.each_ref().map(|(tier, options)| {
            evaluate(&in_tier(look, *tier), library, options, self.precision)
        });
        for (index, (a, b)) in a.iter().flatten().zip(b.iter().flatten()).enumerate() {
            let place =
                || format!("{}, sample {}\n{}", look.look.name, index / 4, look.look.to_text());
            // The bits of 0 and -0 differ.
            let sign = if a == b && a.to_bits() != b.to_bits() { f64::MIN_POSITIVE } else { 0.0 };
            errors.note(*a + sign, *b, place);
        }
        errors.verdict()
    }

    /// The key of the verdict.
    fn key(&self, look: &SetupLook, library: &Library) -> ProofKey {
        let mut key = ProofKey::of_judges(&["tests/truth/pruned.rs"])
            .with(format!("{:?} {:e}", self.precision, self.bound).as_bytes());
        for (tier, options) in &self.ways {
            let look = in_tier(look, *tier);
            content(&look, library, options, &samples(5, 400), &mut |bytes| key.add(bytes));
        }
        key
    }

    fn prove(&self, ledger: &mut Ledger, case: &str, look: &SetupLook) {
        let library = Library::built_in();
        ledger.prove(case, &self.key(look, library), || self.proof(look, library));
    }
}

/// The look in a tier, if it names none.
fn in_tier(look: &SetupLook, tier: Option<Tier>) -> SetupLook {
    let mut look = look.clone();
    look.look.tier = look.look.tier.or(tier);
    look
}

fn unspecialized(live: Live) -> (Option<Tier>, CompileOptions) {
    let options = CompileOptions { live, unspecialized: true, ..CompileOptions::default() };
    (Some(Tier::Exact), options)
}

fn specialized(live: Live) -> (Option<Tier>, CompileOptions) {
    (Some(Tier::Exact), CompileOptions { live, ..CompileOptions::default() })
}

/// Example looks, and 40 random stacks.
fn looks_and_stacks() -> Vec<(String, SetupLook)> {
    let mut random = Random::new(70);
    let stacks = (0..40).map(|index| (format!("stack {index}"), stacks::idle_stack(&mut random)));
    looks().into_iter().chain(stacks).collect()
}

/// The look with all numbers rounded to 64ths: sums, halves and products of a few of them are exact
/// in f32.
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
fn what_is_removed_or_takes_another_form_changes_nothing_in_f64() {
    let comparison = Comparison {
        name: "f64: specialized against as written",
        ways: [specialized(Live::All), unspecialized(Live::All)],
        precision: Precision::F64,
        bound: 1e-13,
    };
    let mut ledger = Ledger::open("pruned-f64");
    for (case, look) in looks_and_stacks() {
        let bound = comparison.bound * steepness(&case);
        Comparison { bound, ..comparison.clone() }.prove(&mut ledger, &case, &look);
    }
    ledger.close();
}

/// Without a tier, a look differs from the exact one by no more than it allows.
#[test]
fn nobody_sees_the_tiers_that_are_chosen() {
    let comparison = Comparison {
        name: "f64: as chosen against exact",
        ways: [(None, specialized(Live::Keyed).1), specialized(Live::Keyed)],
        precision: Precision::F64,
        bound: MAX_ERROR,
    };
    let mut ledger = Ledger::open("chosen-tiers");
    for (case, look) in looks() {
        comparison.prove(&mut ledger, &case, &look);
    }
    ledger.close();
}

fn baked_against_live(bound: f64) -> Comparison {
    Comparison {
        name: "f32: baked against live",
        ways: [specialized(Live::Keyed), specialized(Live::All)],
        precision: Precision::F32,
        bound,
    }
}

#[test]
fn what_is_folded_or_removed_changes_last_digits_alone_in_f32() {
    let mut ledger = Ledger::open("pruned-f32");
    let mut removed = 0;
    for (case, look) in looks_and_stacks() {
        let look = in_64ths(look);
        let comparison = baked_against_live(8.0 * f64::from(f32::EPSILON) * steepness(&case));
        removed += compile(&look.look, Library::built_in(), &comparison.ways[0].1)
            .expect("it compiles")
            .value
            .removed
            .len();
        comparison.prove(&mut ledger, &case, &look);
    }
    ledger.close();
    assert!(removed > 100, "hardly anything was removed: {removed}");
}

/// Folded examples differ by a few roundings: a layer that ranges prove to cover is a sum of
/// constants, which is rounded once where the shader rounds twice, and more is known of constants
/// than of uniforms, so that functions take shorter forms.
#[test]
fn what_is_folded_in_an_example_differs_by_a_few_roundings() {
    let mut ledger = Ledger::open("pruned-folded");
    for (case, look) in looks() {
        let comparison = baked_against_live(8.0 * f64::from(f32::EPSILON) * steepness(&case));
        comparison.prove(&mut ledger, &case, &look);
    }
    ledger.close();
}

/// Factor by which the steepest part of a look makes more of a rounding before it: paint whose
/// edges are far narrower than its cells, threads that glint, contrast at four scales at once,
/// bands of a sum of ten lights, whose edges take a twenty-fifth of a step, leaves of thirteen
/// cells in a light's picture, and the bars of a window.
fn steepness(case: &str) -> f64 {
    match case {
        "oil-portrait" | "filter-before" => 20.0,
        "silk-ring" => 5.0,
        "lights-summed" => 5.0,
        "shape-exaggerated" => 5.0,
        "filter-after" => 5.0,
        "room-guest" | "room-walls" => 10.0,
        _ => 1.0,
    }
}

/// Ratio of a look's angles to its narrowest ramp, at least 1.
fn narrowness(look: &SetupLook) -> f64 {
    let angle = |node: &Node, port: &str| match node.values.get(port) {
        Some(Value::Number(angle)) => Some(*angle),
        _ => None,
    };
    let of = |node: &Node| {
        let (offset, cutoff) = (angle(node, "offset")?, angle(node, "cutoff")?);
        (cutoff > offset).then(|| cutoff / (cutoff - offset))
    };
    let inner = look.look.definitions.values().map(|definition| &definition.graph);
    let graphs = std::iter::once(&look.look.graph).chain(inner);
    graphs.flat_map(|graph| graph.nodes.values()).filter_map(of).fold(1.0, f64::max)
}

/// Values computed once in f64 are closer to the truth than values rounded at each step.
#[test]
fn rounding_once_is_within_a_few_steps_of_rounding_at_each_step() {
    let mut ledger = Ledger::open("pruned-rounding");
    for (case, look) in looks_and_stacks() {
        // As written, the look's angles are rounded before they are subtracted: a few steps of f32
        // in the angles are more steps of a ramp that is far narrower than its angles are large.
        let step = f64::from(f32::EPSILON) * narrowness(&look);
        let comparison = Comparison {
            name: "f32: baked against as written",
            ways: [specialized(Live::Keyed), unspecialized(Live::All)],
            precision: Precision::F32,
            bound: if step > 2e-6 { 2.0 * step } else { 2e-6 * steepness(&case) },
        };
        comparison.prove(&mut ledger, &case, &look);
    }
    ledger.close();
}

/// A changed digit of a shader changes its key, and a false line of the ledger is found.
#[test]
fn a_changed_shader_and_a_forged_line_are_found() {
    let look = halved::look();
    let comparison = baked_against_live(0.0);
    let (before, after) = (halved::library("0.5"), halved::library("0.5000001"));
    let keys = [&before, &halved::library("0.5"), &after]
        .map(|library| comparison.key(&look, library).text());
    assert_eq!(keys[0], keys[1]);
    assert_ne!(keys[0], keys[2]);
    let (key, proof) = (comparison.key(&look, &before), || comparison.proof(&look, &before));
    assert!(is_found_false("half", &key, 3e-3, proof), "a forged line");
    assert!(!is_found_false("half", &key, 0.0, proof), "an honest line");
}
