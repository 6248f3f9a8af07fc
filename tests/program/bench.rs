//! Benchmarks and tuning of looks: the measured rows are complete and plausible, and tuned looks
//! keep their bounds.
#![cfg(feature = "gpu")]

use crate::support::eval::look;
use crate::support::wait::block_on;
use chiaro::accuracy::tune::{Goal, TuneOptions, tune};
use chiaro::accuracy::{
    BenchOptions, Measure, MeasureError, MeasuredNodes, MeasuredTier, MeasurementSubject, Variant,
    bench,
};
use chiaro::document::Tier;
use chiaro::frame::{Assets, PlanOptions, Setup, default_setup};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::{Gpu, Renderer};
use serde_json::json;

fn setup() -> Setup {
    let look = look(&json!({
        "name": "Two layers",
        "lights": {"key": {"direction": [0.4, 0.5, 0.8]}},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.1, 0.1, 0.2]}},
            {
                "id": "first", "kind": "light_layer",
                "values": {"light": "key", "convex": [0.6, 0.5, 0.3], "cutoff": 1.9}
            },
            {"id": "second", "kind": "light_layer", "name": "Shine",
             "values": {
                 "light": "key", "type": "specular", "convex": [0.3, 0.3, 0.3], "falloff": 0.2,
                 "cutoff": 0.5
             }},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "base", "to": "first.below"}, {"from": "first", "to": "second.below"},
            {"from": "second", "to": "output.color"}
        ]
    }));
    default_setup(look, "shape:sphere", &mut Assets::default()).unwrap().value
}

fn renderer() -> Renderer {
    Renderer::new(block_on(Gpu::headless()).expect("an adapter; software Vulkan does"))
}

const PLAN: PlanOptions = PlanOptions { size: [96, 96], samples: 1, time: 0.0 };

#[test]
fn a_report_has_the_look_and_its_nodes_in_each_tier_with_errors_and_sizes() {
    let options = BenchOptions { plan: PLAN, rounds: 3, nodes: MeasuredNodes::Tiered, truth: true };
    let progress = Progress::new();
    let report =
        block_on(bench(&setup(), Library::built_in(), &mut renderer(), &options, &progress))
            .unwrap();
    assert!(progress.steps()[0] > 9, "progress is told");
    let rows = |tier, is: &dyn Fn(&MeasurementSubject) -> bool| -> Vec<_> {
        report
            .rows
            .iter()
            .filter(|row| row.tier == MeasuredTier::Named(tier) && is(&row.subject))
            .collect()
    };
    let whole = |subject: &MeasurementSubject| *subject == MeasurementSubject::Whole;
    let named = |wanted: &'static str| {
        move |subject: &MeasurementSubject| {
            let MeasurementSubject::Node { name, .. } = subject else { return false };
            name == wanted
        }
    };
    for tier in [Tier::Exact, Tier::Balanced, Tier::Fast] {
        for row in
            [rows(tier, &whole), rows(tier, &named("Shine")), rows(tier, &named("first"))].concat()
        {
            let error = row.error.as_ref().expect("it was compared");
            assert!(error.pixels > 5000 && error.broken == 0, "{error:?}");
            // The bounds are f32's errors, and those that the tiers' docs state, with the nodes
            // after them.
            let bound = if tier == Tier::Exact { 2e-4 } else { 2e-3 };
            assert!(error.max < bound, "{tier:?} {:?} {error:?}", row.subject);
            assert!(row.time.low <= row.time.median && row.time.median <= row.time.high);
        }
        assert_eq!(rows(tier, &whole).len(), 1);
    }
    let of = |tier| rows(tier, &whole)[0].sizes.clone().unwrap();
    assert!(
        of(Tier::Fast).instructions < of(Tier::Exact).instructions,
        "a cheaper tier has less to do"
    );
    assert!(of(Tier::Exact).memory > 96 * 96 * 12 && of(Tier::Exact).traffic > 96 * 96 * 12);
    // The table and the plot agree with the rows.
    let table = report.table();
    assert!(table.contains("Shine") && table.contains("whole look"), "{table}");
    let svg = chiaro::accuracy::plot::svg(&report, whole, "Two <layers>", Measure::Max);
    assert!(svg.contains("Two &lt;layers&gt;") && svg.matches("<circle").count() == 4, "{svg}");
    let verdict = report.verdict(Measure::P999, 1.0 / 255.0);
    assert!(
        verdict.lines().count() == 4 && verdict.contains("exact: within 3.92e-3 by p99.9"),
        "{verdict}"
    );
    assert!(verdict.contains("automatic: within"), "{verdict}");
    assert!(report.verdict(Measure::Max, 1e-12).contains("fast: beyond"), "{verdict}");
    let described = json!(report);
    assert_eq!(described["rows"][0]["tier"], "exact");
    assert!(described["rows"][0]["error"]["max"].as_f64().unwrap() < 2e-4);
}

#[test]
fn measuring_can_be_stopped() {
    let options =
        BenchOptions { plan: PLAN, rounds: 50, nodes: MeasuredNodes::Every, truth: false };
    let progress = Progress::observed(|progress| {
        if progress.steps()[0] == 4 {
            progress.stop();
        }
    });
    let stopped =
        block_on(bench(&setup(), Library::built_in(), &mut renderer(), &options, &progress));
    assert!(matches!(stopped, Err(MeasureError::Stopped)));
    assert_eq!(progress.steps()[0], 4);
}

#[test]
fn tuning_keeps_the_error_and_an_impossible_goal_is_said_to_be_missed() {
    let options = |goal| TuneOptions {
        goal,
        measure: Measure::Max,
        plan: PLAN,
        error_side: 48,
        rounds: 3,
        viewpoints: 3,
    };
    let (library, setups) = (Library::built_in(), [setup()]);
    let goal = Goal::MaxError(1.0 / 255.0);
    let tuned = block_on(tune(&setups, library, &mut renderer(), &options(goal), &Progress::new()))
        .unwrap();
    assert!(tuned.is_met && tuned.error.max <= 1.0 / 255.0, "{tuned:?}");
    // Two layers have two candidates each, balanced and fast; the output has a tier by the rules of
    // functions that it may call, and is the same in it.
    assert_eq!(tuned.candidates.len(), 4);
    assert!(tuned.candidates.iter().all(|candidate| candidate.error > 0.0));
    // Each chosen tier was measured to save more time than the noise, and there is at most one a
    // node.
    assert!(tuned.chosen.iter().all(|&index| tuned.candidates[index].saves.low > 0.0));
    assert_eq!(tuned.tiers().len(), 2);
    let mut look = setups[0].looks[0].look.clone();
    for (node, tier) in tuned.tiers() {
        Variant::set_tier(&mut look, node, tier);
        assert_eq!(look.graph.nodes[node].tier.or(look.tier), Some(tier));
    }
    let goal = Goal::MaxError(1e-12);
    let missed =
        block_on(tune(&setups, library, &mut renderer(), &options(goal), &Progress::new()))
            .unwrap();
    assert!(!missed.is_met && missed.chosen.is_empty());
    assert!(missed.is_exact_beyond(), "f32 errs by more than that whatever the tier");
    assert!(missed.worst_exact.error == missed.error_exact.max && missed.worst_exact.side == 48);
    assert_eq!(missed.worst_exact, missed.worst, "nothing was chosen");
}

/// An error is allowed by one measure and not by another, and times are kept as well as errors.
#[test]
fn tuning_by_measures_and_by_time() {
    let (library, setups) = (Library::built_in(), [setup()]);
    let tuned = |goal, measure| {
        let options =
            TuneOptions { goal, measure, plan: PLAN, error_side: 48, rounds: 3, viewpoints: 2 };
        block_on(tune(&setups, library, &mut renderer(), &options, &Progress::new())).unwrap()
    };
    let by_max = tuned(Goal::MaxError(1.0), Measure::Max);
    let figures = &by_max.error_exact;
    assert!(figures.rms < figures.p999 && figures.p999 <= figures.max, "{figures:?}");
    // A bound between the two errors is met by one measure and missed by the other.
    let between = 0.5 * (figures.rms + figures.max);
    assert!(tuned(Goal::MaxError(between), Measure::Rms).is_met);
    let missed = tuned(Goal::MaxError(between), Measure::Max);
    assert!(
        !missed.is_met && missed.is_exact_beyond() && missed.summary().contains("(max)"),
        "{}",
        missed.summary()
    );
    assert!(!missed.is_met && missed.summary().len() <= 1000, "a look holds no more than that");
    // With unlimited time nothing cheaper is chosen; with none at all, everything that helps is
    // chosen, and the goal is missed.
    let slow = tuned(Goal::MaxTime(1e9), Measure::P999);
    assert!(slow.is_met && slow.chosen.is_empty());
    let never = tuned(Goal::MaxTime(1e-9), Measure::P999);
    assert!(!never.is_met && !never.is_exact_beyond());
    let helps = |index: &usize| never.candidates[*index].saves.low > 0.0;
    assert_eq!(never.chosen.is_empty(), !(0..never.candidates.len()).any(|index| helps(&index)));
    assert!(never.chosen.iter().all(helps), "what cannot be told apart from exact stays exact");
    assert!(never.ties().all(|tie| tie.saves.low <= 0.0));
}
