//! Layers that are groups of the library with a shape of their own: bands over the angle from a
//! light, and highlights that are moved, by formulas of their own in f64.
#![cfg(feature = "gpu")]

use crate::support::eval::{eval, look};
use crate::support::random::Random;
use chiaro::frame::{EvalSample, SetupLook};
use glam::DVec3;
use serde_json::{Value as Json, json};

/// Distance from an edge within which either side is right, in radians.
const EDGE: f64 = 1e-3;

/// Look of one layer over black.
fn layer(toward: DVec3, kind: &str, values: &Json) -> SetupLook {
    look(&json!({
        "lights": {"key": {"direction": toward.to_array(), "space": "world"}},
        "nodes": [
            {"id": "paint", "kind": "base", "values": {"color": [0, 0, 0, 1]}},
            {"id": "layer", "kind": kind, "values": values},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "paint", "to": "layer.below"},
            {"from": "layer.below", "to": "output.color"}]
    }))
}

#[test]
fn a_band_reaches_from_its_edge_to_the_next() {
    let mut random = Random::new(317);
    let toward = DVec3::new(0.6, 0.0, 0.8);
    let grays = [0.75, 0.5, 0.25];
    let edges = [0.3, 0.5];
    let stop = |at: f64, gray: f64| json!({"at": at, "color": [gray, gray, gray]});
    let stops = [stop(0.0, grays[0]), stop(edges[0], grays[1]), stop(edges[1], grays[2])];
    let values = json!({"light": "key", "bands": {"stops": stops, "interpolation": "stepped"}});
    let bands = layer(toward, "band_layer", &values);
    let mut seen = [0; 3];
    for _ in 0..60 {
        let normal = random.direction();
        let angle = normal.angle_between(toward);
        let edges = edges.map(|at| at * std::f64::consts::PI);
        if edges.iter().any(|edge| (edge - angle).abs() < EDGE) {
            continue;
        }
        let band = edges.iter().filter(|edge| angle > **edge).count();
        seen[band] += 1;
        let drawn = eval(&bands, "layer.below", &[EvalSample { normal, ..EvalSample::default() }]);
        assert!((drawn[0][0] - grays[band]).abs() < 1e-6, "{angle}: {:?}", drawn[0]);
    }
    assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
}

#[test]
fn a_highlight_lies_where_it_was_moved() {
    let mut random = Random::new(318);
    let toward = DVec3::new(-0.48, 0.6, 0.64);
    let (across, up, radius) = (0.35, -0.2, 0.2);
    let values = json!({"light": "key", "across": across, "up": up, "turn": 0.7,
        "offset": radius, "falloff": radius, "cutoff": radius});
    let highlight = layer(toward, "highlight_layer", &values);
    let view = EvalSample::default().view.normalize();
    let half = (toward + view).normalize();
    let x = DVec3::Y.cross(half).normalize();
    let middle = (half + across * x + up * half.cross(x)).normalize();
    let mut seen = [0; 2];
    for _ in 0..60 {
        let normal = (middle + 0.35 * random.direction()).normalize();
        let angle = normal.angle_between(middle);
        if (angle - radius).abs() < EDGE {
            continue;
        }
        let is_in = angle < radius;
        seen[usize::from(is_in)] += 1;
        let sample = EvalSample { normal, ..EvalSample::default() };
        let drawn = eval(&highlight, "layer.tone", &[sample]);
        let wanted = f64::from(u8::from(is_in));
        assert!((drawn[0][0] - wanted).abs() < 1e-6, "{angle}: {:?}", drawn[0]);
    }
    assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
}
