//! A look baked onto an HCBTF: looked up at the grid's directions, the HCBTF shows the look's own
//! colors there.
#![cfg(feature = "gpu")]

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use crate::support::eval::{eval, look};
use chiaro::document::relief::PRESETS;
use chiaro::document::{Directions, Grid, Hcbtf, Look, Rule};
use chiaro::frame::{Assets, EvalSample, LightOverride, SetupLook, moving_light, tile_assets};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{bake_look, bake_look_sampled};
use glam::{DMat3, DQuat, DVec2, DVec3};
use serde_json::json;

const GRID: Grid = Grid {
    size: [3, 2],
    light: Directions { theta: 3, phi: 4 },
    view: Directions { theta: 3, phi: 3 },
};

fn example(name: &str) -> SetupLook {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks").join(name);
    let loaded = Look::read(&std::fs::read_to_string(&path).unwrap(), name);
    SetupLook {
        look: loaded.value.unwrap(),
        source: loaded.source.into(),
        folder: path.parent().unwrap().into(),
    }
}

/// A look that shows an HCBTF alone.
fn showing(path: &Path) -> SetupLook {
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {
                "id": "paint", "kind": "hcbtf_lookup",
                "values": {"sheet": path.display().to_string(), "lookup": "texels"}
            },
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "light", "to": "paint.light"}, {"from": "paint", "to": "output.color"}]
    }))
}

/// Surface samples of every texel under every light and view of the grid, without lights on the
/// horizon, where lit and unlit meet.
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
        // One sample a texel, at the place where the look is evaluated.
        let (assets, progress) = (Assets::default(), Progress::new());
        let baked =
            bake_look_sampled(&setup, Library::built_in(), GRID, &light, &assets, 1, &progress)
                .unwrap();
        let hcbtf = baked.hcbtf;
        assert_eq!(baked.halves_off, None);
        assert_eq!(hcbtf.painted.len() as u64, GRID.sample_count());
        let path = file(&format!("{name}.hcbtf"));
        std::fs::write(&path, chiaro::hcbtf::write(&hcbtf).unwrap()).unwrap();
        let samples = samples();
        let (own, shown) = (eval(&setup, "", &samples), eval(&showing(&path), "", &samples));
        let varies = own.iter().any(|color| (color[0] - own[0][0]).abs() > 0.1);
        assert!(varies, "{name} shows one color");
        for ((own, shown), sample) in own.iter().zip(&shown).zip(&samples) {
            let off =
                own.iter().zip(shown).map(|(own, shown)| (own - shown).abs()).fold(0.0, f64::max);
            assert!(off < 1.0 / 255.0, "{name}: {own:?} {shown:?} at {sample:?}");
        }
    }
}

/// A look of two colors that meet in a straight line at u = 0.3, with an alpha that ends at v =
/// 0.45.
fn edges(color_space: &str) -> SetupLook {
    let code = "fn edges(at: vec2f) -> vec4f \
                { return vec4f(select(vec3f(1.0), vec3f(0.0), at.x < 0.3), \
                select(0.0, 1.0, at.y < 0.45)); }";
    look(&json!({
        "color_space": color_space,
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "uv", "kind": "uv"},
            {"id": "edges", "kind": "wgsl", "values": {"code": code}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "uv", "to": "edges.at"}, {"from": "edges", "to": "output.color"}]
    }))
}

/// A texel on an edge shows the share on either side, as exactly as its samples in rows of their
/// own allow.
#[test]
fn edges_are_smooth_with_samples_enough() {
    let one = Directions { theta: 1, phi: 1 };
    let grid = Grid { size: [4, 4], light: one, view: one };
    let (assets, progress) = (Assets::default(), Progress::new());
    let mut off = Vec::new();
    for (color_space, samples) in
        [("display", 1), ("display", 4), ("display", 16), ("display", 64), ("linear", 64)]
    {
        let setup = edges(color_space);
        let light = moving_light(&setup, None).unwrap();
        let baked = bake_look_sampled(
            &setup,
            Library::built_in(),
            grid,
            &light,
            &assets,
            samples,
            &progress,
        )
        .unwrap();
        let tile = baked.hcbtf.painted.values().next().unwrap().clone();
        let within = 0.5 / f64::from(samples) + 1.0 / 255.0;
        // Of the second column's texels (0.3 - 0.25) / 0.25 is black; of the third row's from the
        // top the same share is opaque.
        let (white, opaque) = (0.8, 0.8);
        let decoded = |byte: u8| match (color_space, f64::from(byte) / 255.0) {
            ("linear", shown) => chiaro::document::srgb_to_linear(shown),
            (_, shown) => shown,
        };
        let [r, _, _, a] = tile.texel(1, 3).map(|byte| byte);
        assert!(
            (decoded(r) - white).abs() < within && a == 255,
            "{samples} {color_space}: {r} {a}"
        );
        let [r, _, _, a] = tile.texel(3, 2);
        assert!((f64::from(a) / 255.0 - opaque).abs() < within && r == 255, "{samples}: {r} {a}");
        assert_eq!(
            [tile.texel(0, 3), tile.texel(2, 3), tile.texel(2, 0)].map(|texel| texel[3]),
            [255, 255, 0]
        );
        assert_eq!([tile.texel(0, 3), tile.texel(2, 3)].map(|texel| texel[0]), [0, 255]);
        // The two halves of the samples differ at edges, and nowhere else.
        assert_eq!(
            baked.halves_off.is_some_and(|off| off > 0.001 && off < 0.2),
            samples > 1,
            "{:?}",
            baked.halves_off
        );
        off.extend(baked.halves_off.filter(|_| color_space == "display"));
    }
    assert!(off[1] < 0.6 * off[0] && off[2] < 0.6 * off[1], "more samples are nearer: {off:?}");
    let setup = edges("display");
    let light = moving_light(&setup, None).unwrap();
    let told = bake_look_sampled(&setup, Library::built_in(), grid, &light, &assets, 3, &progress)
        .unwrap_err();
    assert_eq!(told[0].code, "out-of-range");
}

/// One tile alone is baked in many pieces, and no piece is begun after a stop.
#[test]
fn a_tile_that_is_not_wanted_any_more_is_left_in_the_middle() {
    let one = Directions { theta: 1, phi: 1 };
    let grid = Grid { size: [128, 64], light: one, view: one };
    let setup = edges("display");
    let light = moving_light(&setup, None).unwrap();
    let steps: Arc<Mutex<Vec<[u64; 2]>>> = Arc::default();
    let told = steps.clone();
    let progress = Progress::observed(move |progress| {
        told.lock().unwrap().push(progress.steps());
        progress.stop();
    });
    let made = bake_look(&setup, Library::built_in(), grid, &light, &Assets::default(), &progress);
    assert_eq!(made.unwrap_err()[0].code, "stopped");
    assert_eq!(*steps.lock().unwrap(), [[1, 8]]);
}

#[test]
fn baking_is_the_same_on_any_number_of_threads_and_can_be_stopped() {
    let setup = example("figure6-comics.json");
    let light = moving_light(&setup, None).unwrap();
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            bake_look(
                &setup,
                Library::built_in(),
                GRID,
                &light,
                &Assets::default(),
                &Progress::new(),
            )
            .unwrap()
        })
    };
    assert_eq!(on(1), on(3));
    let stopped = Progress::new();
    stopped.stop();
    let told = bake_look(&setup, Library::built_in(), GRID, &light, &Assets::default(), &stopped)
        .unwrap_err();
    assert_eq!(told[0].code, "stopped");
    assert_eq!(moving_light(&setup, Some("kye")).unwrap_err().code, "bad-argument");
    let fine = Grid { size: [512, 512], ..Grid::THESIS };
    assert_eq!(
        bake_look(&setup, Library::built_in(), fine, &light, &Assets::default(), &Progress::new())
            .unwrap_err()[0]
            .code,
        "too-large"
    );
}

#[test]
fn what_a_look_shows_is_filled_once_and_its_preparation_is_told() {
    let directions = Directions { theta: 2, phi: 2 };
    let grid = Grid { size: [6, 6], light: directions, view: directions };
    let rules = vec![Rule::Relief(Box::new(PRESETS[0].1()))];
    let path = file("relief.hcbtf");
    std::fs::write(&path, chiaro::hcbtf::write(&Hcbtf { rules, ..Hcbtf::new(grid) }).unwrap())
        .unwrap();
    let setup = showing(&path);
    let light = moving_light(&setup, None).unwrap();
    let told: Arc<Mutex<Vec<[u64; 2]>>> = Arc::default();
    let listener = told.clone();
    let filling = Progress::observed(move |progress| {
        listener.lock().unwrap().push(progress.steps());
    });
    let assets =
        tile_assets(&setup, Library::built_in(), &light, Assets::default(), &filling).unwrap();
    let steps = told.lock().unwrap().clone();
    let total = steps[0][1];
    // Steps before the last, the 3 x 3 tiles of 6 rows, are preparation, of which there is much.
    let before = steps.iter().take_while(|[done, _]| *done < total - 9 * 6).count();
    assert!(before >= 12, "{steps:?}");
    assert!(
        steps.iter().all(|[_, of]| *of == total) && steps.iter().any(|[done, _]| *done == total),
        "{steps:?}"
    );
    // The bake finds the HCBTF filled for every view.
    let baked =
        bake_look(&setup, Library::built_in(), GRID, &light, &assets, &Progress::new()).unwrap();
    assert_eq!(told.lock().unwrap().len(), steps.len());
    let alone =
        bake_look(&setup, Library::built_in(), GRID, &light, &Assets::default(), &Progress::new())
            .unwrap();
    assert!(baked == alone);
    filling.stop();
    let stopped = tile_assets(&setup, Library::built_in(), &light, Assets::default(), &filling);
    assert_eq!(stopped.unwrap_err()[0].code, "stopped");
}
