//! Whole pictures of painted waves, near and far, against the reference in f64: smaller levels of
//! the tile are read and blended there, by the tile's size on the screen.

use std::path::Path;

use chiaro::accuracy::{ErrorFigures, MeasureError, Truth};
use chiaro::compile::Live;
use chiaro::diag::Diagnostic;
use chiaro::document::{Address, Camera, Grid, Hcbtf, Scene, Tile};
use chiaro::frame::{Assets, PlanOptions, Planner, Setup};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::Renderer;

use super::{BALANCED, Directions, file, stored_as};
use crate::support::eval::{renderer, scene_of, shape, told};
use crate::support::random::Random;
use crate::support::wait::block_on;

/// An HCBTF whose colors follow the directions smoothly, with noise from texel to texel.
fn moss() -> Hcbtf {
    let directions = Directions { theta: 4, phi: 6 };
    let grid = Grid { size: [16, 12], light: directions, view: directions };
    let mut random = Random::new(90);
    let grain: Vec<f64> = (0..grid.texels()).map(|_| random.between(-0.3, 0.3)).collect();
    let mut hcbtf = Hcbtf::new(grid);
    for address in grid.addresses() {
        let Address { light, view } = address;
        let (light, view) = (grid.light.vector(light), grid.view.vector(view));
        let texel = |grain: &f64| {
            let rgb = [0.5 + 0.3 * light.x, 0.4 + 0.3 * view.y, 0.2 + 0.5 * light.z * view.z];
            let [r, g, b] =
                rgb.map(|channel| ((channel + grain).clamp(0.0, 1.0) * 255.0).round() as u8);
            [r, g, b, 255]
        };
        let bytes = grain.iter().flat_map(texel).collect();
        hcbtf.painted.insert(address, Tile::new(grid.size, bytes).expect("its size").into());
    }
    hcbtf
}

/// The lying waves at a distance of `far` from the eye, with the tile repeated `repeats` times.
fn setup(path: &Path, storage: &str, tier: &str, far: f64, repeats: f64) -> Setup {
    let mut look = stored_as(storage, path, "smooth", tier);
    let node = look.look.graph.nodes.get_mut("paint").expect("the lookup");
    node.values.insert("scale".into(), chiaro::document::Value::Vector(vec![repeats, repeats]));
    look.look.lights[0].direction = [0.4, 0.5, 0.8];
    let (mesh, matrix) = shape("waves");
    let camera =
        Camera { eye: (far * glam::DVec3::new(0.1, -0.75, 0.65)).into(), ..Camera::default() };
    scene_of(vec![(look, mesh, matrix)], Scene { camera, ..Scene::default() })
}

fn flawless<T>(result: Result<T, MeasureError>) -> T {
    result.unwrap_or_else(|stopped| panic!("{}", told(&Vec::<Diagnostic>::from(stopped))))
}

fn measured(
    path: &Path,
    precise: &mut Renderer,
    far: f64,
    repeats: f64,
) -> Vec<(String, ErrorFigures)> {
    let options = PlanOptions { size: [96, 72], samples: 1, time: 0.0 };
    let truth = |storage: &str| {
        flawless(Truth::of(
            &setup(path, storage, "exact", far, repeats),
            Library::built_in(),
            &mut Planner::for_truth(Assets::default()),
            &options,
            &Progress::new(),
        ))
    };
    // Blocks have a loss of their own; the reference decodes them as the GPU does.
    let (painted, blocks) = (truth("quick"), truth("blocks"));
    let tiers = [
        ("quick", "exact"),
        ("quick", "balanced"),
        ("quick", "fast"),
        ("compact", "exact"),
        ("blocks", "exact"),
    ];
    tiers
        .into_iter()
        .map(|(storage, tier)| {
            let truth = if storage == "blocks" { &blocks } else { &painted };
            let setup = setup(path, storage, tier, far, repeats);
            let plan =
                Planner::default().plan(&setup, Library::built_in(), &Live::Exposed, &options);
            let plan = plan.unwrap_or_else(|problems| panic!("{}", told(&problems))).value;
            (
                format!("{storage} {tier} from {far} with {repeats}"),
                flawless(block_on(truth.compare(precise, &plan))),
            )
        })
        .collect()
}

/// Smooth lookups are within each tier's bound where a tile of 16 texels takes 15 pixels, so that
/// levels 0 and 1 are read, and where it takes 2, so that levels 2 to 4 are.
#[test]
fn smooth_lookups_are_true_at_any_distance() {
    let path = file("moss", &moss());
    let mut precise = Renderer::new(renderer().gpu().precise());
    for (far, repeats) in [(2.2, 6.0), (5.0, 24.0)] {
        for (what, figures) in measured(&path, &mut precise, far, repeats) {
            println!(
                "{what}: max {:.1e}, p999 {:.1e}, rms {:.1e} of {} pixels, {} broken",
                figures.max, figures.p999, figures.rms, figures.pixels, figures.broken
            );
            // The error that the node's file states for each tier, in any pixel.
            let most = match what.split(' ').nth(1) {
                Some("exact") => 1e-4,
                Some("balanced") => BALANCED,
                _ => 0.55,
            };
            assert!(figures.broken == 0 && figures.pixels > 5_000, "{what}: {figures:?}");
            assert!(figures.max <= most, "{what}: {figures:?}");
        }
    }
}
