//! Every node of the library, in every choice, width and tier, on the GPU against f64.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures are worth reading when a bound is missed")]

mod support;

use chiaro::accuracy::Stopped;
use chiaro::accuracy::sweep::{Case, Effort, Lab, Measured};
use chiaro::diag::Diagnostic;
use chiaro::library::Library;
use support::eval::{renderer, told};

fn sweep(effort: &Effort) -> Vec<Measured> {
    let mut renderer = renderer();
    let mut lab = Lab::new(Library::built_in(), &mut renderer).unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let mut kinds: Vec<&str> = Library::built_in().nodes.keys().map(String::as_str).collect();
    kinds.sort_unstable();
    let only = std::env::var("SWEEP_NODE").ok();
    let mut all = Vec::new();
    for kind in kinds.into_iter().filter(|kind| only.as_deref().is_none_or(|only| only == *kind)) {
        for case in Case::of(&Library::built_in().nodes[kind]) {
            let measured = lab.measure(&case, effort).unwrap_or_else(|stopped: Stopped| {
                let problems: Vec<Diagnostic> = stopped.into();
                panic!("{}: {}", case.name(), told(&problems))
            });
            all.push(measured);
        }
    }
    all
}

fn hold(all: &[Measured]) {
    let mut broken = Vec::new();
    for one in all {
        let line = format!(
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
        );
        println!("{line}");
        if !one.holds() {
            broken.push(line);
        }
    }
    assert!(broken.is_empty(), "{} beyond their bounds:\n{}", broken.len(), broken.join("\n"));
}

#[test]
fn every_node_keeps_its_bound() {
    let quick = Effort { rounds: std::env::var("SWEEP_ROUNDS").map_or(0, |n| n.parse().unwrap()), ..Effort::QUICK };
    hold(&sweep(&quick));
}

#[test]
#[ignore = "minutes: scripts/soak"]
fn soak_every_node_keeps_its_bound() {
    hold(&sweep(&Effort::FULL));
}
