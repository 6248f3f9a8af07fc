//! Probe: the values that it tells are those of the pixel's wires.

use std::path::PathBuf;

use chiaro::compile::Live;
use chiaro::document::Look;
use chiaro::frame::{Assets, PlanOptions, Planner, SetupLook, default_setup};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{ReferenceOptions, WireValue, execute, probe_wires};
use serde_json::{Value as Json, json};

const SIZE: u32 = 64;

fn probed(look: &Json, pixel: [u32; 2]) -> (Option<Vec<WireValue>>, [f64; 4]) {
    let text = look.to_string();
    let loaded = Look::read(&text, "test.json");
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    let look = SetupLook {
        look: loaded.value.unwrap(),
        source: loaded.source.into(),
        folder: PathBuf::new(),
    };
    let mut assets = Assets::default();
    let setup = default_setup(look, "shape:sphere", &mut assets).unwrap().value;
    let options = PlanOptions { size: [SIZE; 2], samples: 1, time: 0.0 };
    let plan = Planner::for_truth(assets)
        .plan(&setup, Library::built_in(), &Live::All, &options)
        .unwrap()
        .value;
    let modules = chiaro::reference::Modules::new(&plan, chiaro::interp::Precision::F64).unwrap();
    let picture = execute(&plan, &modules, &ReferenceOptions::default(), &Progress::new()).unwrap();
    let wires = probe_wires(&plan, pixel, &ReferenceOptions::default(), &Progress::new()).unwrap();
    (wires, picture.straight(pixel[0], pixel[1]))
}

fn of<'w>(wires: &'w [WireValue], node: &str) -> &'w WireValue {
    wires
        .iter()
        .rfind(|wire| wire.node.to_string() == node)
        .unwrap_or_else(|| panic!("no {node} in {wires:?}"))
}

fn lit() -> Json {
    json!({
        "lights": {"key": {"direction": [0.3, 0.4, 0.8]}},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.1, 0.2, 0.3]}},
            {"id": "rim", "kind": "light_layer",
             "values": {
                 "light": "key", "convex": [0.9, 0.7, 0.5], "cutoff": 2.0, "slope": 0.3,
                 "amount": 0.2
             }},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "base", "to": "rim.below"}, {"from": "rim", "to": "output.color"}]
    })
}

/// The last wire is the picture's own pixel everywhere, with a curvature pass around the pixel.
#[test]
fn the_output_wire_is_the_pixel() {
    for pixel in [[32, 32], [20, 40], [45, 25], [12, 31], [33, 51]] {
        let (wires, color) = probed(&lit(), pixel);
        let wires = wires.unwrap_or_else(|| panic!("nothing at {pixel:?}"));
        let stack = of(&wires, "rim/blend");
        for (got, wanted) in stack.double.iter().zip(color) {
            assert!((got - wanted).abs() < 1e-12, "{stack:?} for {color:?} at {pixel:?}");
        }
        assert!(wires.iter().all(WireValue::is_finite));
        // f32 values are near the f64 ones, and not the same.
        assert!(wires.iter().all(|wire| wire.difference() < 1e-4), "{wires:?}");
        assert!(wires.iter().any(|wire| wire.difference() > 0.0));
        let first = |node: &str| wires.iter().position(|wire| wire.node.to_string() == node);
        assert!(
            first("base") < first("rim/blend") && first("rim/tone") < first("rim/blend"),
            "in the order of computing"
        );
    }
}

#[test]
fn nothing_is_drawn_beside_the_object() {
    assert_eq!(probed(&lit(), [1, 1]).0, None);
}

/// The first wire that is no number is the output of a custom node that divides by 0.
#[test]
fn the_first_broken_wire_is_found() {
    let code = "fn broken(tone: f32) -> f32 { return tone / (tone - tone); }";
    let look = json!({
        "nodes": [
            {"id": "facing", "kind": "facing"},
            {"id": "broken", "kind": "wgsl", "values": {"code": code}},
            {
                "id": "sum", "kind": "wgsl",
                "values": {"code": "fn more(tone: f32) -> f32 { return tone + 1.0; }"}
            },
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "facing", "to": "broken.tone"}, {"from": "broken", "to": "sum.tone"},
            {"from": "sum", "to": "output.color"}
        ]
    });
    let (wires, color) = probed(&look, [32, 32]);
    let wires = wires.unwrap();
    let first = wires.iter().find(|wire| !wire.is_finite()).unwrap();
    assert_eq!(first.node.to_string(), "broken");
    assert!(color.iter().all(|x| x.is_finite()), "the picture itself is mended");
}
