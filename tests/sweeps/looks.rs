//! Example looks against their truth: over lights and views, at many sizes, and from frame to
//! frame.
#![allow(clippy::print_stdout, reason = "figures are worth reading when a bound is missed")]

use std::path::Path;

use crate::support::eval::{renderer, told};
use crate::support::ledger::{Ledger, ProofKey};
use crate::support::wait::block_on;
use chiaro::accuracy::{MeasureError, PremultipliedPicture, Truth};
use chiaro::diag::Diagnostic;
use chiaro::document::{Projection, Tier};
use chiaro::files::Disk;
use chiaro::frame::{Assets, PlanOptions, Planner, Setup, open};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::Renderer;
use chiaro::sweeps::looks::content;
use chiaro::sweeps::{
    LookEffort, StabilityEffort, looks_in, measure_look, measure_stability, stability,
};
use glam::DVec3;

fn looks() -> Vec<std::path::PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    looks_in(&Disk, &folder).unwrap_or_else(|problems| panic!("{}", told(&problems)))
}

fn flawless<T>(result: Result<T, MeasureError>) -> T {
    result.unwrap_or_else(|stopped| panic!("{}", told(&Vec::<Diagnostic>::from(stopped))))
}

/// The key of the verdict on a look's pictures.
fn key(path: &Path, precise: &Renderer, effort: &str, meshes: &[&str], tiers: &[Tier]) -> ProofKey {
    let mut key = ProofKey::of_judges(&["tests/sweeps/looks.rs"])
        .with(precise.gpu().info.driver_info.as_bytes())
        .with(effort.as_bytes());
    let told = content(path, meshes, tiers, Library::built_in(), &mut |bytes| key.add(bytes));
    told.unwrap_or_else(|problems| panic!("{}", self::told(&problems)));
    key
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

#[allow(clippy::print_stdout, reason = "`--nocapture` shows how near the bounds are")]
fn hold_looks(effort: &LookEffort, ledger: &str) {
    let mut precise = Renderer::new(renderer().gpu().precise());
    let mut ledger = Ledger::open(ledger);
    for path in looks() {
        let key = key(&path, &precise, &format!("{effort:?}"), &effort.meshes, &effort.tiers);
        ledger.prove(&stem(&path), &key, || {
            let progress = Progress::new();
            let mut worst = 0.0_f64;
            for measured in flawless(block_on(measure_look(
                &path,
                Library::built_in(),
                &mut precise,
                effort,
                &progress,
            ))) {
                let e = &measured.error;
                let line = format!(
                    "{:24} {:8} {:3} pictures, NaN {}, max {:.1e}, p999 {:.1e}, rms {:.1e}, edges \
                     {} of {} up to {:.1e}; {}",
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
                    return Err(line);
                }
                worst = worst.max(e.rms);
            }
            Ok(worst)
        });
    }
    ledger.close();
}

#[allow(clippy::print_stdout, reason = "`--nocapture` shows how near the bounds are")]
fn hold_stability(effort: &StabilityEffort, ledger: &str) {
    let mut precise = Renderer::new(renderer().gpu().precise());
    let mut ledger = Ledger::open(ledger);
    for path in looks() {
        for mesh in stability::MESHES {
            let key = key(&path, &precise, &format!("{effort:?}"), &[mesh], &[Tier::Exact]);
            ledger.prove(&format!("{} on {mesh}", stem(&path)), &key, || {
                let progress = Progress::new();
                let measured = flawless(block_on(measure_stability(
                    &path,
                    mesh,
                    Library::built_in(),
                    &mut precise,
                    effort,
                    &progress,
                )));
                let told = |f: &stability::Flicker| {
                    format!("{:.1e} of {:.1e}, {} of {} seen", f.max, f.truth, f.visible, f.count)
                };
                let line = format!(
                    "{:24} {:9} smooth {}, edges {}, silhouettes {}",
                    measured.look,
                    measured.mesh,
                    told(&measured.smooth),
                    told(&measured.edges),
                    told(&measured.silhouettes)
                );
                println!("{line}");
                if measured.holds() { Ok(measured.smooth.mean) } else { Err(line) }
            });
        }
    }
    ledger.close();
}

#[test]
fn looks_are_true_from_everywhere() {
    hold_looks(&LookEffort::quick(), "looks");
}

#[test]
fn nothing_flickers_while_light_and_camera_turn() {
    hold_stability(&StabilityEffort { frames: 6, side: 96 }, "stability");
}

#[test]
#[ignore = "hours: scripts/soak"]
fn soak_looks_are_true_from_everywhere() {
    hold_looks(&LookEffort::soak(), "looks-soak");
}

/// Pictures of 4096 by 4096 pixels, of which the rows in the middle are judged; takes 4 GB of
/// memory.
#[test]
#[ignore = "half an hour: scripts/soak"]
fn soak_looks_are_true_in_the_largest_pictures() {
    hold_looks(&LookEffort::large(), "looks-large");
}

#[test]
#[ignore = "minutes: scripts/soak"]
fn soak_nothing_flickers_while_light_and_camera_turn() {
    hold_stability(&StabilityEffort { frames: 60, side: 256 }, "stability-soak");
}

/// A scene whose camera shows the same picture, moved by some pixels.
fn shifted(setup: &Setup, pixels: f64, side: u32) -> Setup {
    let mut setup = setup.clone();
    let camera = &mut setup.scene.camera;
    let [eye, target, up] = [camera.eye, camera.target, camera.up].map(DVec3::from);
    let height = match camera.projection {
        Projection::Perspective => 2.0 * (0.5 * camera.fov).tan() * (eye - target).length(),
        Projection::Orthographic => camera.height,
    };
    let by = pixels * height / f64::from(side) * up.cross(eye - target).normalize();
    (camera.eye, camera.target) = ((eye + by).to_array(), (target + by).to_array());
    setup
}

#[test]
fn only_what_a_step_of_the_grid_explains_is_settled() {
    let side = 96;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks/hatching.json");
    let setup = open(&file, Some("shape:sphere"), &mut Assets::default())
        .unwrap_or_else(|p| panic!("{}", told(&p)))
        .value;
    let options = PlanOptions { size: [side; 2], samples: 1, time: 0.0 };
    let mut planner = Planner::for_truth(Assets::default());
    let mut truth_of = |setup: &Setup| {
        flawless(Truth::of(setup, Library::built_in(), &mut planner, &options, &Progress::new()))
    };
    let aside = truth_of(&shifted(&setup, 1.0 / 256.0, side));
    let mut truth = truth_of(&setup);
    let [here, there] = [truth.colors().rgba.into_owned(), aside.colors().rgba.into_owned()];
    let apart =
        |index: usize| (0..4).map(|c| (here[index][c] - there[index][c]).abs()).fold(0.0, f64::max);
    let inside: Vec<usize> =
        (0..here.len()).filter(|&index| !truth.is_edge(index) && here[index][3] > 0.0).collect();
    let leaping =
        inside.iter().copied().max_by(|a, b| apart(*a).total_cmp(&apart(*b))).expect("pixels");
    let still =
        inside.iter().copied().min_by(|a, b| apart(*a).total_cmp(&apart(*b))).expect("pixels");
    assert!(apart(leaping) > 1e-3 && apart(still) < 1e-5);

    // The leaping pixel gets the color that the camera aside sees; the still pixel gets a wrong
    // one.
    let mut got = PremultipliedPicture { size: [side; 2], rgba: here.clone().into() };
    got.rgba.to_mut()[leaping] = there[leaping];
    let wrong = 2.0 * apart(leaping);
    got.rgba.to_mut()[still][1] += wrong;
    let above = 0.5 * apart(leaping);
    let mut again = Planner::for_truth(Assets::default());
    let settled =
        flawless(truth.settle(&got, |_| above, &setup, Library::built_in(), &mut again, &options));
    assert_eq!(settled, 1);
    assert!(truth.is_edge(leaping) && !truth.is_edge(still));
    let figures = truth.figures(&got);
    assert!((figures.max - wrong).abs() < 1e-12, "what is wrong is told: {}", figures.max);
    assert_eq!(figures.worst, [still as u32 % side, still as u32 / side]);
}

#[test]
fn some_rows_of_a_truth_are_those_of_the_whole() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks/contours.json");
    let setup =
        open(&file, None, &mut Assets::default()).unwrap_or_else(|p| panic!("{}", told(&p))).value;
    let options = PlanOptions { size: [80, 64], samples: 1, time: 0.0 };
    let mut planner = Planner::for_truth(Assets::default());
    let mut rows_of = |rows| {
        let library = Library::built_in();
        flawless(Truth::in_rows(&setup, library, &mut planner, &options, rows, &Progress::new()))
    };
    let (whole, some) = (rows_of(0..64), rows_of(20..33));
    for index in 80 * 20..80 * 33 {
        assert_eq!(whole.colors().rgba[index], some.colors().rgba[index], "pixel {index}");
        assert_eq!(whole.is_edge(index), some.is_edge(index), "pixel {index}");
    }
    let mut got = whole.colors();
    got.rgba.to_mut()[80 * 10 + 40] = [9.0; 4];
    assert_eq!(some.figures(&got).pixels + some.figures(&got).edges, 80 * 13);
    assert_eq!(some.figures(&got).max, 0.0, "what is elsewhere does not count");
}
