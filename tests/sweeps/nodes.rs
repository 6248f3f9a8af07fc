//! Every node of the library, in every choice, width and tier, on the GPU against f64.
#![allow(clippy::print_stdout, reason = "figures are worth reading when a bound is missed")]

use std::sync::{Arc, Mutex};

use crate::support::eval::{renderer, told};
use crate::support::ledger::{Ledger, ProofKey};
use crate::support::wait::block_on;
use chiaro::accuracy::MeasureError;
use chiaro::diag::Diagnostic;
use chiaro::files::Disk;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::sweeps::{
    Case, CaseFigures, Effort, Laboratory, LookEffort, StabilityEffort, Survey, SurveyPart,
    looks_in, survey,
};

fn sweep(effort: &Effort) -> Vec<CaseFigures> {
    let mut renderer = renderer();
    let mut lab = Laboratory::new(Library::built_in(), &mut renderer)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let mut kinds: Vec<&str> = Library::built_in().nodes.keys().map(String::as_str).collect();
    kinds.sort_unstable();
    let mut all = Vec::new();
    for kind in kinds {
        for case in Case::of(&Library::built_in().nodes[kind]) {
            let measured =
                block_on(lab.measure(&case, effort)).unwrap_or_else(|stopped: MeasureError| {
                    let problems: Vec<Diagnostic> = stopped.into();
                    panic!("{}: {}", case.name(), told(&problems))
                });
            all.push(measured);
        }
    }
    all
}

/// A line with a case's figures.
fn line(one: &CaseFigures) -> String {
    format!(
        "{:50} {:8} {:6} {:5} {:3} abs {:.1e} p999 {:.1e} max {:.1e} of {:.0e}  {}",
        one.case.name(),
        format!("{:?}", one.case.tier),
        one.samples,
        one.rounded,
        one.broken,
        one.absolute,
        one.p999,
        one.max,
        one.bound,
        if one.holds() { "" } else { &one.worst_words }
    )
}

#[allow(clippy::print_stdout, reason = "`--nocapture` shows how near the bounds are")]
fn hold(all: &[CaseFigures]) {
    let mut broken = Vec::new();
    for one in all {
        let line = line(one);
        println!("{line}");
        if !one.holds() {
            broken.push(line);
        }
    }
    assert!(broken.is_empty(), "{} beyond their bounds:\n{}", broken.len(), broken.join("\n"));
}

/// The key of a case's verdict.
pub(crate) fn key(lab: &mut Laboratory<'_>, case: &Case, effort: &Effort) -> ProofKey {
    let mut key = ProofKey::of_judges(&["tests/sweeps/nodes.rs"])
        .with(lab.renderer.gpu().info.driver_info.as_bytes());
    let content = lab.content(case, effort, &mut |bytes| key.add(bytes));
    content.unwrap_or_else(|problems| panic!("{}: {}", case.name(), told(&problems)));
    key
}

#[test]
fn every_node_keeps_its_bound() {
    let effort = Effort::QUICK;
    let mut ledger = Ledger::open("nodes");
    let mut renderer = renderer();
    let mut lab = Laboratory::new(Library::built_in(), &mut renderer)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let mut kinds: Vec<&str> = Library::built_in().nodes.keys().map(String::as_str).collect();
    kinds.sort_unstable();
    for case in kinds.into_iter().flat_map(|kind| Case::of(&Library::built_in().nodes[kind])) {
        let name = format!("{}, {:?}", case.name(), case.tier);
        let key = key(&mut lab, &case, &effort);
        ledger.prove(&name, &key, || {
            let measured = block_on(lab.measure(&case, &effort))
                .map_err(|stopped| told(&Vec::<Diagnostic>::from(stopped)))?;
            // The verdict covers the documented domain alone: outside of it the figures depend on
            // the thread, which may count denormals as 0.
            if measured.holds() { Ok(measured.p999) } else { Err(line(&measured)) }
        });
    }
    ledger.close();
}

#[test]
#[ignore = "minutes: scripts/soak"]
fn soak_every_node_keeps_its_bound() {
    hold(&sweep(&Effort::FULL));
}

/// Outputs of a node on the GPU and in the truth, for inputs with these numbers; others are 0.
fn one(node: &str, inputs: &[(&str, &[f64])]) -> [Vec<f64>; 2] {
    let mut renderer = renderer();
    let mut lab = Laboratory::new(Library::built_in(), &mut renderer)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let case = Case::of(&Library::built_in().nodes[node]).remove(0);
    let bench = lab.bench(&case).unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let of = |name: &str| inputs.iter().find(|input| input.0 == name).map(|input| input.1.to_vec());
    let numbers = bench
        .slots
        .iter()
        .map(|slot| of(&slot.name).unwrap_or_else(|| vec![0.0; slot.width]))
        .collect();
    let findings = block_on(lab.compare(&bench, &[numbers]));
    let mut findings =
        findings.unwrap_or_else(|stopped| panic!("{}", told(&Vec::<Diagnostic>::from(stopped))));
    let finding = findings.remove(0);
    [finding.got, finding.truth]
}

/// An angle of pi turned by another pi stays at pi, on the GPU and in f64.
#[test]
fn a_turn_by_pi_beyond_pi_ends_at_pi() {
    let quarter = [std::f64::consts::FRAC_PI_2];
    let inputs: [(&str, &[f64]); 4] =
        [("angle", &[1.0, 0.0]), ("falloff", &quarter), ("cutoff", &quarter), ("shift", &[-7.0])];
    for tone in one("profile", &inputs) {
        assert_eq!(tone, [0.0]);
    }
}

/// A tangent that nearly lies along the normal still gives an orthogonal frame.
#[test]
fn a_tangent_beside_the_normal_gives_a_frame_at_right_angles() {
    let normal = [-1.0, -2.3e-4, 2.4e-4];
    let inputs: [(&str, &[f64]); 3] = [
        ("normal", &normal),
        ("surface_normal", &[0.0, 1.0, 0.0]),
        ("surface_tangent", &[-1.0, 0.0, 1.2e-4]),
    ];
    for frame in one("tangent_frame", &inputs) {
        let along: f64 = (0..3).map(|i| frame[i] * frame[6 + i]).sum();
        assert!(along.abs() < 3e-7, "{along} of {frame:?}");
    }
}

/// A point beside the origin has an angle as long as f32 tells the point from the origin.
#[test]
fn the_smallest_point_has_an_angle() {
    let least = [-f64::from(f32::MIN_POSITIVE)];
    for angle in one("arctangent", &[("y", &least), ("x", &least)]) {
        assert!((angle[0] + 0.75 * std::f64::consts::PI).abs() < 1e-6, "{angle:?}");
    }
}

/// A survey by several workers gives the figures of one worker alone, in the same order.
#[test]
fn a_survey_by_several_workers_is_that_of_one() {
    let library = Library::built_in();
    let kinds = ["profile", "add", "facing"];
    let effort = Effort { ordinary: 64, extreme: 64, rounds: 1 };
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["b", "a"] {
        let look = include_str!("../../examples/looks/figure3-profile.json");
        std::fs::write(folder.path().join(format!("{name}.json")), look).expect("it is written");
    }
    let tiny = LookEffort {
        meshes: vec!["shape:sphere"],
        viewpoints: 2,
        sides: vec![24],
        ..LookEffort::quick()
    };
    let wanted = Survey {
        parts: SurveyPart::ALL.to_vec(),
        nodes: kinds.map(str::to_owned).to_vec(),
        effort,
        looks: looks_in(&Disk, folder.path()).expect("the folder is listed"),
        look_effort: tiny.clone(),
        large: Some(LookEffort { sides: vec![48], ..tiny }),
        stability: StabilityEffort { frames: 2, side: 24 },
    };
    let steps: Arc<Mutex<Vec<[u64; 2]>>> = Arc::default();
    let observed = steps.clone();
    let progress = Progress::observed(move |progress| {
        observed.lock().unwrap().push(progress.steps());
    });
    let report = block_on(survey(&wanted, library, &progress, &|worker| block_on(worker)))
        .unwrap_or_else(|stopped| {
            let problems: Vec<Diagnostic> = stopped.into();
            panic!("{}", self::told(&problems))
        });
    let names = |all: &[chiaro::sweeps::LookFigures]| -> Vec<String> {
        all.iter().map(|one| format!("{} {:?}", one.look, one.tier)).collect()
    };
    let all = ["a Exact", "a Balanced", "a Fast", "b Exact", "b Balanced", "b Fast"];
    assert_eq!(
        (names(&report.looks), names(&report.large)),
        (all.map(str::to_owned).to_vec(), all.map(str::to_owned).to_vec())
    );
    assert!(
        report
            .large
            .iter()
            .all(|one| one.worst_words.is_empty() || one.worst_words.contains("48 px"))
    );
    assert_eq!(report.stability.iter().map(|one| one.look.as_str()).collect::<String>(), "aabb");
    let mut renderer = renderer();
    let mut lab = Laboratory::new(library, &mut renderer)
        .unwrap_or_else(|problems| panic!("{}", self::told(&problems)));
    let mut alone = Vec::new();
    for kind in ["add", "facing", "profile"] {
        for case in Case::of(&library.nodes[kind]) {
            let measured =
                block_on(lab.measure(&case, &effort)).unwrap_or_else(|_| panic!("{}", case.name()));
            alone.push(serde_json::json!(measured));
        }
    }
    assert_eq!(report.nodes.iter().map(|one| serde_json::json!(one)).collect::<Vec<_>>(), alone);
    let total = alone.len() as u64 + 2 * (2 + 2 + 2 * 2);
    assert_eq!(progress.steps(), [total; 2], "every step is counted, once");
    let steps = std::mem::take(&mut *steps.lock().unwrap());
    assert!(
        steps.len() as u64 >= total && steps.iter().all(|[done, of]| done <= of && *of == total),
        "every step is told: {steps:?}"
    );

    // A stopped survey ends before its last step.
    let progress = Progress::observed(|progress| {
        if progress.steps()[0] >= 3 {
            progress.stop();
        }
    });
    assert!(matches!(
        block_on(survey(&wanted, library, &progress, &|worker| block_on(worker))),
        Err(MeasureError::Stopped)
    ));
    let [most, _] = progress.steps();
    assert!(most < total, "{most} of {total}");
}
