//! The example looks against their truth: over lights and views, at many sizes, and from frame to frame.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures are worth reading when a bound is missed")]

mod support;

use std::path::Path;

use chiaro::accuracy::sweep::{LookEffort, StabilityEffort, looks_in, measure_look, measure_stability, stability};
use chiaro::accuracy::{Progress, Stopped};
use chiaro::diag::Diagnostic;
use chiaro::library::Library;
use chiaro::render::Renderer;
use support::eval::{renderer, told};

fn looks() -> Vec<std::path::PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    looks_in(&folder).unwrap_or_else(|problems| panic!("{}", told(&problems)))
}

fn flawless<T>(result: Result<T, Stopped>) -> T {
    result.unwrap_or_else(|stopped| panic!("{}", told(&Vec::<Diagnostic>::from(stopped))))
}

#[allow(clippy::print_stdout, reason = "`--nocapture` shows how near the bounds are")]
fn hold_looks(effort: &LookEffort) {
    let mut precise = Renderer::new(renderer().gpu().precise());
    let mut broken = Vec::new();
    for path in looks() {
        let mut go_on = |_, _| true;
        let mut progress = Progress::new(&mut go_on);
        for measured in flawless(measure_look(&path, Library::built_in(), &mut precise, effort, &mut progress)) {
            let e = &measured.error;
            let line = format!(
                "{:24} {:8} {:3} pictures, NaN {}, max {:.1e}, p999 {:.1e}, rms {:.1e}, edges {} of {} up to {:.1e}; {}",
                measured.look,
                format!("{:?}", measured.tier),
                measured.pictures,
                e.broken,
                e.max,
                e.p999,
                e.rms,
                e.edge_visible,
                e.edges,
                e.edge_max,
                measured.worst_words
            );
            println!("{line}");
            if !measured.holds() {
                broken.push(line);
            }
        }
    }
    assert!(broken.is_empty(), "beyond their bounds:\n{}", broken.join("\n"));
}

#[allow(clippy::print_stdout, reason = "`--nocapture` shows how near the bounds are")]
fn hold_stability(effort: &StabilityEffort) {
    let mut precise = Renderer::new(renderer().gpu().precise());
    let mut broken = Vec::new();
    for path in looks() {
        for mesh in stability::MESHES {
            let mut go_on = |_, _| true;
            let mut progress = Progress::new(&mut go_on);
            let measured =
                flawless(measure_stability(&path, mesh, Library::built_in(), &mut precise, effort, &mut progress));
            let told =
                |f: &stability::Flicker| format!("{:.1e} of {:.1e}, {} of {} seen", f.max, f.truth, f.visible, f.count);
            let line = format!(
                "{:24} {:9} smooth {}, edges {}, silhouettes {}",
                measured.look,
                measured.mesh,
                told(&measured.smooth),
                told(&measured.edges),
                told(&measured.silhouettes)
            );
            println!("{line}");
            if !measured.holds() {
                broken.push(line);
            }
        }
    }
    assert!(broken.is_empty(), "they flicker:\n{}", broken.join("\n"));
}

#[test]
fn looks_are_true_from_everywhere() {
    hold_looks(&LookEffort::quick());
}

#[test]
fn nothing_flickers_while_light_and_camera_turn() {
    hold_stability(&StabilityEffort { frames: 6, side: 96 });
}

#[test]
#[ignore = "hours: scripts/soak"]
fn soak_looks_are_true_from_everywhere() {
    hold_looks(&LookEffort::soak());
}

/// 4096 by 4096 pixels, in 4 GB of memory.
#[test]
#[ignore = "half an hour: scripts/soak"]
fn soak_looks_are_true_in_the_largest_pictures() {
    hold_looks(&LookEffort::large());
}

#[test]
#[ignore = "minutes: scripts/soak"]
fn soak_nothing_flickers_while_light_and_camera_turn() {
    hold_stability(&StabilityEffort { frames: 60, side: 256 });
}
