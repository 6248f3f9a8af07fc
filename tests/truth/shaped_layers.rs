//! Layers that are groups of the library with a shape of their own: bands over the angle from a
//! light, and highlights that are moved, by formulas of their own in f64; and layers that are drawn
//! where a light does not reach, against the nodes that draw.
#![cfg(feature = "gpu")]

use crate::support::eval::{eval, look, renderer, scene_of, shape, told};
use crate::support::random::Random;
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::Scene;
use chiaro::frame::{EvalSample, PlanOptions, Planner, SetupLook};
use chiaro::library::{Context, Library};
use glam::DVec3;
use serde_json::{Value as Json, json};

/// Distance from an edge within which either side is right, in radians.
const EDGE: f64 = 1e-3;
/// Color below drawn layers.
const PAINT: [f64; 3] = [0.8, 0.5, 0.3];
/// Color of drawn layers.
const INK: [f64; 3] = [0.1, 0.2, 0.4];

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

/// Surface samples in all directions, at places of their own in the picture and near lines.
fn drawn_samples(random: &mut Random) -> Vec<EvalSample> {
    let mut sample = || {
        let mut uniform = |count: usize, size: f64| -> Vec<f64> {
            (0..count).map(|_| size * random.unit()).collect()
        };
        let contexts = [
            (Context::named("pixel"), uniform(2, 2.0)),
            (Context::named("line_nearness"), uniform(4, 20.0)),
        ];
        EvalSample {
            contexts: contexts.into(),
            normal: random.direction(),
            position: random.direction(),
            ..EvalSample::default()
        }
    };
    (0..60).map(|_| sample()).collect()
}

/// Look of a drawn layer at half its opacity over a color, under a light of some intensity.
fn drawn_layer(light: &Json, kind: &str, values: &Json) -> SetupLook {
    let mut values = values.clone();
    values["color"] = json!(INK);
    values["opacity"] = json!(0.5);
    look(&json!({
        "lights": {"key": light},
        "nodes": [
            {"id": "paint", "kind": "base", "values": {"color": PAINT}},
            {"id": "layer", "kind": kind, "values": values},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "paint", "to": "layer.below"},
            {"from": "layer.below", "to": "output.color"}]
    }))
}

/// Holds a drawn layer's ink, and the stack on which it lies, against the ink of each sample.
fn hold_ink(layer: &SetupLook, output: &str, samples: &[EvalSample], wanted: &[f64]) {
    let inks = eval(layer, output, samples);
    let stacks = eval(layer, "layer.below", samples);
    for ((ink, stack), wanted) in inks.iter().zip(&stacks).zip(wanted) {
        assert!((ink[0] - wanted).abs() < 1e-6, "{output}: {} for {wanted}", ink[0]);
        for (channel, (paint, color)) in PAINT.iter().zip(INK).enumerate() {
            let covered = paint + 0.5 * wanted * (color - paint);
            assert!((stack[channel] - covered).abs() < 2e-6, "{output}: {stack:?}, {wanted}");
        }
    }
    assert!(wanted.iter().any(|ink| *ink > 0.5) && wanted.iter().any(|ink| *ink < 0.5));
}

#[test]
fn half_tones_and_strokes_lie_where_the_light_does_not_reach() {
    let mut random = Random::new(319);
    let toward = DVec3::new(0.6, 0.0, 0.8);
    // Numbers that f32 has exactly, so that both looks draw the same tone.
    let (edge, depth) = (1.25, 0.5);
    let halftone = json!({"shape": "lines", "lines": 3, "angle": 0.3});
    let hatching = json!({"count": 4, "width": 0.6, "layers": 3, "cross": 0.7, "length": 9,
        "wobble": 0.3, "pressure": 0.25, "seed": 5});
    for (intensity, more) in [(1.0, 0.0), (4.0, 0.75), (0.5, 0.25), (0.0, 0.0)] {
        let light =
            json!({"direction": toward.to_array(), "space": "world", "intensity": intensity});
        let mut samples = drawn_samples(&mut random);
        samples.retain(|sample| (sample.normal.angle_between(toward) - edge).abs() > EDGE);
        let in_light = f64::max(1.0 - f64::min(intensity, 1.0), more);
        let is_lit = |sample: &EvalSample| sample.normal.angle_between(toward) < edge;
        let shades: Vec<f64> =
            samples.iter().map(|sample| if is_lit(sample) { in_light } else { 1.0 }).collect();
        let draw = |tone: f64, values: &Json, kind: &str| {
            let mut values = values.clone();
            values["value"] = json!(tone);
            look(&json!({
                "lights": {"key": light},
                "nodes": [
                    {"id": "key", "kind": "light", "values": {"light": "key"}},
                    {"id": "place", "kind": "mark_place"},
                    {"id": "ink", "kind": kind, "values": values},
                    {"id": "output", "kind": "output"}],
                "wires": match kind {
                    "hatching" => json!([{"from": "key", "to": "place.light"},
                        {"from": "place.place", "to": "ink.place"},
                        {"from": "place.stretch", "to": "ink.stretch"},
                        {"from": "ink", "to": "output.color"}]),
                    _ => json!([{"from": "key", "to": "place.light"},
                        {"from": "ink", "to": "output.color"}]),
                }
            }))
        };
        for (kind, node, output, values) in [
            ("halftone_layer", "halftone", "ink.tone", &halftone),
            ("hatching_layer", "hatching", "ink.ink", &hatching),
        ] {
            let of_shade =
                |shade: f64| eval(&draw(1.0 - depth * shade, values, node), output, &samples);
            let (lit, unlit) = (of_shade(in_light), of_shade(1.0));
            let inks = samples.iter().enumerate().map(|(at, sample)| {
                let drawn = if is_lit(sample) { lit[at][0] } else { unlit[at][0] };
                if node == "halftone" { 1.0 - drawn } else { drawn }
            });
            let inks: Vec<f64> = inks.collect();
            let mut values = values.clone();
            for (port, value) in [
                ("offset", edge),
                ("falloff", edge),
                ("cutoff", edge),
                ("depth", depth),
                ("more", more),
            ] {
                values[port] = json!(value);
            }
            values["light"] = json!("key");
            let layer = drawn_layer(&light, kind, &values);
            hold_ink(&layer, "layer.ink", &samples, &inks);
            for (found, wanted) in eval(&layer, "layer.shade", &samples).iter().zip(&shades) {
                assert!((found[0] - wanted).abs() < 1e-6, "{kind}: {} for {wanted}", found[0]);
            }
        }
    }
}

#[test]
fn ink_lies_on_outlines() {
    let samples = drawn_samples(&mut Random::new(320));
    // Thousandths of a picture that is one pixel high.
    let values = json!({"width": 900, "creases": 0.75});
    let lines = look(&json!({
        "nodes": [{"id": "lines", "kind": "outline", "values": values},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "lines", "to": "output.color"}]
    }));
    let inks: Vec<f64> = eval(&lines, "lines.line", &samples).iter().map(|line| line[0]).collect();
    let light = json!({"direction": [0, 0, 1]});
    hold_ink(&drawn_layer(&light, "ink_layer", &values), "layer.line", &samples, &inks);
}

/// While a look is edited its values are uniforms, and what a group of the library holds inside is
/// read anew as the document's values are.
#[test]
fn bands_and_highlights_stay_where_they_are_while_they_are_edited() {
    let gray = |at: f64, gray: f64| json!({"at": at, "color": [gray, gray, gray]});
    let stops = [gray(0.0, 0.75), gray(0.3, 0.5), gray(0.5, 0.25)];
    let bands = json!({"light": "key", "bands": {"stops": stops, "interpolation": "stepped"}});
    let highlight = json!({"light": "key", "square": 0.4, "split": 0.2, "star": 0.3});
    for (kind, values) in [("band_layer", bands), ("highlight_layer", highlight)] {
        let (mesh, matrix) = shape("sphere");
        let worn = layer(DVec3::new(0.36, 0.48, 0.8), kind, &values);
        let scene = Scene { backdrop: None, ..Scene::default() };
        let setup = scene_of(vec![(worn, mesh, matrix)], scene);
        let options = PlanOptions { size: [64, 64], samples: 1, time: 0.0 };
        let [edited, settled] = [Live::All, Live::Keyed].map(|live| {
            let plan = Planner::default()
                .plan(&setup, Library::built_in(), &live, &options)
                .unwrap_or_else(|problems| panic!("{kind}: {}", told(&problems)))
                .value;
            block_on(renderer().picture(&plan)).expect("it is drawn").rgba
        });
        let far = edited.iter().zip(&settled).filter(|(live, baked)| {
            live.iter().zip(baked.iter()).any(|(live, baked)| (live - baked).abs() > 0.01)
        });
        let far = far.count();
        assert!(far < 20, "{kind}: {far} of {} pixels differ", settled.len());
        assert!(settled.iter().any(|pixel| pixel[0] > 0.4), "{kind} shows something");
    }
}
