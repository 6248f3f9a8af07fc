//! A look that is baked onto an HCBTF shows, looked up at the grid's directions, what the look itself shows there.
#![cfg(feature = "gpu")]

mod support;

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use chiaro::document::relief::PRESETS;
use chiaro::document::{Directions, Grid, Hcbtf, Look, Rule};
use chiaro::frame::{Assets, EvalSample, LightOverride, SetupLook, moving_light, tile_assets};
use chiaro::hcbtf::Progress;
use chiaro::library::Library;
use chiaro::reference::bake_look;
use glam::{DMat3, DQuat, DVec2, DVec3};
use serde_json::json;
use support::eval::{eval, look};

const GRID: Grid = Grid { size: [3, 2], light: Directions { theta: 3, phi: 4 }, view: Directions { theta: 3, phi: 3 } };

fn example(name: &str) -> SetupLook {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks").join(name);
    let loaded = Look::read(&std::fs::read_to_string(&path).unwrap(), name);
    SetupLook { look: loaded.value.unwrap(), source: loaded.source.into(), folder: path.parent().unwrap().into() }
}

/// A look that shows an HCBTF and nothing else.
fn showing(path: &Path) -> SetupLook {
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "paint", "kind": "hcbtf_lookup", "values": {"sheet": path.display().to_string(), "lookup": "texels"}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "light", "to": "paint.light"}, {"from": "paint", "to": "output.color"}]
    }))
}

/// Every texel under every light and view of the grid; lights on the horizon itself are an edge, and left out.
fn samples() -> Vec<EvalSample> {
    let mut samples = Vec::new();
    for address in GRID.addresses().filter(|address| address.light.theta + 1 < GRID.light.theta) {
        let (view, light) = (GRID.view.vector(address.view), GRID.light.vector(address.light));
        let turn = DQuat::from_rotation_arc(DVec3::Z, view);
        for (x, y) in (0..GRID.size[1]).flat_map(|y| (0..GRID.size[0]).map(move |x| (x, y))) {
            let uv = DVec2::new((f64::from(x) + 0.5) / 3.0, 1.0 - (f64::from(y) + 0.5) / 2.0);
            let light = LightOverride { direction: Some(light), ..LightOverride::default() };
            samples.push(EvalSample {
                tangent: Some(DVec3::X),
                view,
                uv,
                position: DVec3::new(uv.x - 0.5, (uv.y - 0.5) * 2.0 / 3.0, 0.0),
                camera: DMat3::from_cols(turn * DVec3::X, turn * DVec3::Y, view).transpose(),
                lights: [("key".into(), light)].into_iter().collect(),
                ..EvalSample::default()
            });
        }
    }
    samples
}

fn file(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hcbtf_bake");
    std::fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

#[test]
fn a_baked_look_is_the_look_at_the_grids_directions() {
    for name in ["figure6-comics.json", "figure5-directional.json"] {
        let setup = example(name);
        let light = moving_light(&setup, Some("key")).unwrap();
        let hcbtf = bake_look(&setup, Library::built_in(), GRID, &light, &Assets::default(), &Progress::new()).unwrap();
        assert_eq!(hcbtf.painted.len() as u64, GRID.sample_count());
        let path = file(&format!("{name}.hcbtf"));
        std::fs::write(&path, chiaro::hcbtf::write(&hcbtf).unwrap()).unwrap();
        let samples = samples();
        let (own, shown) = (eval(&setup, "", &samples), eval(&showing(&path), "", &samples));
        let varies = own.iter().any(|color| (color[0] - own[0][0]).abs() > 0.1);
        assert!(varies, "{name} shows one colour");
        for ((own, shown), sample) in own.iter().zip(&shown).zip(&samples) {
            let off = own.iter().zip(shown).map(|(own, shown)| (own - shown).abs()).fold(0.0, f64::max);
            assert!(off < 1.0 / 255.0, "{name}: {own:?} {shown:?} at {sample:?}");
        }
    }
}

#[test]
fn baking_is_the_same_on_any_number_of_threads_and_can_be_stopped() {
    let setup = example("figure6-comics.json");
    let light = moving_light(&setup, None).unwrap();
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            bake_look(&setup, Library::built_in(), GRID, &light, &Assets::default(), &Progress::new()).unwrap()
        })
    };
    assert_eq!(on(1), on(3));
    let stopped = Progress::new();
    stopped.stop();
    let told = bake_look(&setup, Library::built_in(), GRID, &light, &Assets::default(), &stopped).unwrap_err();
    assert_eq!(told[0].code, "stopped");
    assert_eq!(moving_light(&setup, Some("kye")).unwrap_err().code, "bad-argument");
    let fine = Grid { size: [512, 512], ..Grid::THESIS };
    assert_eq!(
        bake_look(&setup, Library::built_in(), fine, &light, &Assets::default(), &Progress::new()).unwrap_err()[0].code,
        "too-large"
    );
}

#[test]
fn what_a_look_shows_is_filled_once_and_its_preparation_is_told() {
    let directions = Directions { theta: 2, phi: 2 };
    let grid = Grid { size: [6, 6], light: directions, view: directions };
    let rules = vec![Rule::Relief(Box::new(PRESETS[0].1()))];
    let path = file("relief.hcbtf");
    std::fs::write(&path, chiaro::hcbtf::write(&Hcbtf { rules, ..Hcbtf::new(grid) }).unwrap()).unwrap();
    let setup = showing(&path);
    let light = moving_light(&setup, None).unwrap();
    let told: Arc<Mutex<Vec<[u64; 2]>>> = Arc::default();
    let listener = told.clone();
    let filling = Arc::new(Progress::telling(move |steps| listener.lock().unwrap().push(steps)));
    let assets = tile_assets(&setup, Library::built_in(), &light, Assets::default(), &filling).unwrap();
    let steps = told.lock().unwrap().clone();
    let total = steps[0][1];
    // All that is told before the 3 x 3 tiles of 6 rows is preparation, and there is much of it.
    let before = steps.iter().take_while(|[done, _]| *done < total - 9 * 6).count();
    assert!(before >= 12, "{steps:?}");
    assert!(steps.iter().all(|[_, of]| *of == total) && steps.iter().any(|[done, _]| *done == total), "{steps:?}");
    // Every view finds it filled.
    let baked = bake_look(&setup, Library::built_in(), GRID, &light, &assets, &Progress::new()).unwrap();
    assert_eq!(told.lock().unwrap().len(), steps.len());
    let alone = bake_look(&setup, Library::built_in(), GRID, &light, &Assets::default(), &Progress::new()).unwrap();
    assert!(baked == alone);
    filling.stop();
    let stopped = tile_assets(&setup, Library::built_in(), &light, Assets::default(), &filling);
    assert_eq!(stopped.unwrap_err()[0].code, "stopped");
}
