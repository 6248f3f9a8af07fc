//! Pictures shown by views of OpenColorIO on the GPU: the numbers of its CPU.

use std::sync::Arc;

use chiaro::compile::Live;
use chiaro::document::{Camera, Scene};
use chiaro::film::{BUILT_IN, ColorConfig};
use chiaro::frame::{PlanOptions, Planner};
use chiaro::library::Library;
use serde_json::json;

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;

/// Largest difference of a channel where white is 1: half a step of 8 bits. Pictures have 16 bits,
/// and powers on GPUs are less exact.
const BOUND: f32 = 0.5 / 255.0;

/// Views with all kinds of steps: ACES 2 for SDR and HDR, ACES 1.3 (whose glow divides by black),
/// and none.
const VIEWS: &[(&str, &str)] = &[
    (BUILT_IN, "sRGB - Display/ACES 2.0 - SDR 100 nits (Rec.709)"),
    (BUILT_IN, "sRGB - Display/Un-tone-mapped"),
    (BUILT_IN, "Rec.2100-PQ - Display/ACES 2.0 - HDR 1000 nits (P3 D65)"),
    ("ocio://cg-config-v2.1.0_aces-v1.3_ocio-v2.3", "sRGB - Display/ACES 1.0 - SDR Video"),
];

/// A sphere whose light goes from dark to far above white, in all hues, on no backdrop.
#[test]
fn the_gpu_shows_what_opencolorio_shows() {
    let light = look(&json!({
        "chiaro": "look", "version": 1, "color_space": "linear",
        "nodes": [
            {"id": "at", "kind": "normal"},
            {"id": "stops", "kind": "multiply", "values": {"b": 5}},
            {"id": "light", "kind": "exponential"},
            {"id": "parts", "kind": "separate_vector"},
            {"id": "color", "kind": "combine_color"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "at", "to": "stops.a"}, {"from": "stops", "to": "light.value"},
            {"from": "light", "to": "parts.vector"}, {"from": "parts.x", "to": "color.red"},
            {"from": "parts.y", "to": "color.green"}, {"from": "parts.z", "to": "color.blue"},
            {"from": "color", "to": "output.color"}
        ]
    }));
    let (mesh, fitted) = shape("sphere");
    let camera = Camera { eye: [0.6, 0.8, 2.9], ..Camera::default() };
    let scene = Scene { camera, backdrop: None, ..Scene::default() };
    let setup = scene_of(vec![(light, mesh, fitted)], scene);
    let options = PlanOptions { size: [64, 64], samples: 1, time: 0.0 };
    let plan = Planner::default()
        .plan(&setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value;
    let mut renderer = renderer();
    let plain = block_on(renderer.picture(&plan)).unwrap();
    let most = plain.rgba.iter().flat_map(|pixel| pixel[..3].to_vec()).fold(0.0, f32::max);
    assert!(most > 3.0, "{most}: some of the light is far above white");
    for (config, name) in VIEWS {
        let view = ColorConfig::open(config).unwrap().view(None, name).unwrap();
        let module = Arc::new(view.module().unwrap());
        block_on(renderer.show_by(Some(&module))).unwrap_or_else(|error| panic!("{name}: {error}"));
        let shown = block_on(renderer.picture(&plan)).unwrap();
        let wanted = view.show(&plain);
        let mut worst = 0.0_f32;
        for ((shown, wanted), plain) in shown.rgba.iter().zip(&wanted.rgba).zip(&plain.rgba) {
            if plain[3] == 0.0 {
                assert_eq!(*shown, [0.0; 4], "{name}: nothing is shown where nothing is");
                continue;
            }
            let scale = wanted.iter().map(|x| x.abs()).fold(1.0, f32::max);
            for (shown, wanted) in shown.iter().zip(wanted) {
                worst = worst.max((shown - wanted).abs() / scale);
            }
        }
        assert!(worst <= BOUND, "{name}: {worst}");
    }
    // Without a view it is the curve of sRGB again, to the bit.
    block_on(renderer.show_by(None)).unwrap();
    assert_eq!(block_on(renderer.picture(&plan)).unwrap(), plain);
}
