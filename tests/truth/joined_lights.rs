//! Groups that run for each light of a set: what the nodes that join lights make of them, and the
//! details of a light, by formulas of their own in f64.
#![cfg(feature = "gpu")]

use crate::support::eval::{eval, look, truth};
use crate::support::random::Random;
use chiaro::frame::{EvalSample, SetupLook};
use glam::DVec3;
use serde_json::{Value as Json, json};

/// A directional light of the tests.
#[derive(Clone, Copy, Debug)]
struct TestLight {
    toward: DVec3,
    color: [f64; 3],
    intensity: f64,
}

impl TestLight {
    fn random(random: &mut Random) -> Self {
        let f32s = |v: [f64; 3]| v.map(|x| f64::from(x as f32));
        Self {
            toward: random.direction(),
            color: f32s(std::array::from_fn(|_| random.between(0.0, 1.0))),
            // One in five is out.
            intensity: f64::from(random.between(-0.25, 1.0).max(0.0) as f32),
        }
    }

    fn luminance(&self) -> f64 {
        let [r, g, b] = self.color;
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }
}

/// A look that joins lights by a node of a kind: colors of the lights, by their intensities.
fn joined(kind: &str, lamps: &[TestLight], values: &Json) -> SetupLook {
    let lights: serde_json::Map<String, Json> = lamps
        .iter()
        .enumerate()
        .map(|(number, lamp)| {
            let light = json!({"direction": lamp.toward.to_array(), "color": lamp.color,
                "intensity": lamp.intensity, "space": "world"});
            (format!("lamp_{number}"), light)
        })
        .collect();
    let fed = match kind {
        "sum_of_lights" | "greatest_of_lights" => "value",
        "merged_direction" => "light",
        _ => "color",
    };
    let from = if fed == "light" { "lamp" } else { "parts.color" };
    let mut wires = vec![
        json!({"from": "lamp", "to": "parts.light"}),
        json!({"from": from, "to": format!("join.{fed}")}),
        json!({"from": format!("join.{}", output(kind)), "to": "outputs.color"}),
    ];
    let weight = match kind {
        "mix_of_lights" => Some("weight"),
        "strongest_of_lights" => Some("strength"),
        "first_of_lights" => Some("priority"),
        _ => None,
    };
    wires.extend(
        weight.map(|port| json!({"from": "parts.intensity", "to": format!("join.{port}")})),
    );
    look(&json!({
        "lights": lights,
        "definitions": {"lamps": {
            "outputs": [{"name": "color"}],
            "nodes": [{"id": "lamp", "kind": "light"}, {"id": "parts", "kind": "light_parts"},
                {"id": "join", "kind": kind, "values": values}],
            "wires": wires}},
        "nodes": [{"id": "each", "kind": "lamps", "for_each": "*"},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "each", "to": "output.color"}]
    }))
}

/// Output of a node that joins lights.
fn output(kind: &str) -> &'static str {
    match kind {
        "sum_of_lights" => "sum",
        "greatest_of_lights" => "greatest",
        "layers_of_lights" => "layers",
        "mix_of_lights" => "mix",
        "merged_direction" => "direction",
        _ => "color",
    }
}

/// Result of a node of a kind, by a formula that knows all of them at once.
fn formula(kind: &str, lamps: &[TestLight]) -> [f64; 3] {
    let lit: Vec<&TestLight> = lamps.iter().filter(|lamp| lamp.intensity > 0.0).collect();
    let mean = |weight: &dyn Fn(&TestLight) -> f64| {
        let whole: f64 = lit.iter().map(|lamp| weight(lamp)).sum();
        let channel =
            |k: usize| lit.iter().map(|lamp| weight(lamp) * lamp.color[k]).sum::<f64>() / whole;
        if whole > 0.0 { std::array::from_fn(channel) } else { [0.0; 3] }
    };
    match kind {
        "sum_of_lights" => std::array::from_fn(|k| lit.iter().map(|lamp| lamp.color[k]).sum()),
        "greatest_of_lights" => {
            std::array::from_fn(|k| lit.iter().map(|lamp| lamp.color[k]).fold(0.0, f64::max))
        }
        // Opaque layers: the last one is seen.
        "layers_of_lights" => lit.last().map_or([0.0; 3], |lamp| lamp.color),
        "mix_of_lights" => mean(&|lamp| lamp.intensity),
        "first_of_lights" => {
            let first = lit.iter().max_by(|a, b| a.intensity.total_cmp(&b.intensity));
            first.map_or([0.0; 3], |lamp| lamp.color)
        }
        "strongest_of_lights" => {
            let most = lit.iter().map(|lamp| lamp.intensity).fold(0.0, f64::max);
            mean(&|lamp| 256_f64.powf((lamp.intensity - most) / 0.1))
        }
        "merged_direction" => {
            let sum: DVec3 =
                lit.iter().map(|lamp| lamp.toward * lamp.intensity * lamp.luminance()).sum();
            sum.normalize_or_zero().to_array()
        }
        _ => unreachable!("{kind}"),
    }
}

const KINDS: [&str; 7] = [
    "sum_of_lights",
    "greatest_of_lights",
    "layers_of_lights",
    "mix_of_lights",
    "first_of_lights",
    "strongest_of_lights",
    "merged_direction",
];

#[test]
fn lights_are_joined_by_their_formulas() {
    let mut random = Random::new(311);
    for kind in KINDS {
        for count in [0, 1, 2, 3, 8] {
            let lamps: Vec<TestLight> =
                (0..count).map(|_| TestLight::random(&mut random)).collect();
            let wanted = formula(kind, &lamps);
            let look = joined(kind, &lamps, &json!({}));
            // A group without lights is a value, and no output of a node.
            let output = if count == 0 { "" } else { "each" };
            let [got, exact] =
                [eval, truth].map(|run| run(&look, output, &[EvalSample::default()])[0]);
            for channel in 0..3 {
                let (got, exact, wanted) = (got[channel], exact[channel], wanted[channel]);
                let bound = 1e-5 * wanted.abs().max(1.0);
                assert!((got - wanted).abs() < bound, "{kind} {lamps:?}: {got} for {wanted}");
                assert!((exact - wanted).abs() < 1e-7, "{kind} {lamps:?}: {exact} for {wanted}");
            }
        }
    }
}

#[test]
fn the_order_of_lights_matters_only_where_it_is_meant_to() {
    let mut random = Random::new(312);
    for kind in KINDS.into_iter().filter(|kind| *kind != "layers_of_lights") {
        for _ in 0..3 {
            let mut lamps: Vec<TestLight> =
                (0..6).map(|_| TestLight::random(&mut random)).collect();
            let of = |lamps: &[TestLight]| {
                truth(&joined(kind, lamps, &json!({})), "each", &[EvalSample::default()])[0]
            };
            let first = of(&lamps);
            lamps.reverse();
            lamps.swap(1, 4);
            let other = of(&lamps);
            for (a, b) in first.iter().zip(other) {
                assert!((a - b).abs() < 1e-12, "{kind} {lamps:?}: {first:?} {other:?}");
            }
        }
    }
}

#[test]
fn the_details_of_a_light_are_its_fields_where_it_arrives() {
    let mut random = Random::new(313);
    let spot = json!({"type": "spot", "space": "world", "position": [0.5, 2, 1],
        "aim": [-0.2, -1, -0.3], "inner": 0.3, "outer": 0.8, "half_distance": 1.5, "range": 6,
        "color": [0.25, 0.5, 0.75], "intensity": 2});
    let details = look(&json!({
        "lights": {"key": spot},
        "nodes": [{"id": "of", "kind": "light_details"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "of.color", "to": "output.color"}]
    }));
    let at = |position: DVec3| EvalSample { position, ..EvalSample::default() };
    let places: Vec<DVec3> = (0..200).map(|_| 3.0 * random.direction()).collect();
    let samples: Vec<EvalSample> = places.iter().map(|place| at(*place)).collect();
    let of = |output: &str| eval(&details, &format!("of.{output}"), &samples);
    let [direction, distance, falloff, cone, energy, reach, count] =
        ["direction", "distance", "falloff", "cone", "energy", "reach", "count"].map(of);
    let (light, aim) = (DVec3::new(0.5, 2.0, 1.0), DVec3::new(-0.2, -1.0, -0.3).normalize());
    for (index, place) in places.iter().enumerate() {
        let away = (light - *place).length();
        let toward = (light - *place) / away;
        let left =
            1.0 / (1.0 + (away / 1.5).powi(2)) * (1.0 - (away / 6.0).min(1.0).powi(4)).powi(2);
        let [inner, outer] = [0.3_f64, 0.8].map(f64::cos);
        let t = (((-toward).dot(aim) - outer) / (inner - outer)).clamp(0.0, 1.0);
        let within = t * t * (3.0 - 2.0 * t);
        let close = |got: f64, wanted: f64, what: &str| {
            assert!((got - wanted).abs() < 1e-5, "{what} at {place}: {got} for {wanted}");
        };
        assert!((DVec3::from_slice(&direction[index]) - toward).length() < 1e-5);
        close(distance[index][0], away, "distance");
        close(falloff[index][0], left, "falloff");
        close(cone[index][0], within, "cone");
        close(energy[index][0], 2.0, "energy");
        close(reach[index][0], 2.0 * left * within, "reach");
        close(count[index][0], 1.0, "count");
    }
}

#[test]
fn lights_of_a_set_are_numbered() {
    let numbered = look(&json!({
        "lights": {"a": {}, "b": {"groups": ["two"]}, "c": {"groups": ["two"]}},
        "definitions": {"lamps": {
            "outputs": [{"name": "color"}],
            "nodes": [{"id": "of", "kind": "light_details"},
                {"id": "pair", "kind": "combine_color"},
                {"id": "join", "kind": "layers_of_lights"}],
            "wires": [{"from": "of.index", "to": "pair.red"},
                {"from": "of.count", "to": "pair.green"},
                {"from": "pair", "to": "join.color"}, {"from": "join", "to": "outputs.color"}]}},
        "nodes": [{"id": "each", "kind": "lamps", "for_each": "group:two"},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "each", "to": "output.color"}]
    }));
    // The last light is on top: number 1 of 2.
    assert_eq!(eval(&numbered, "each", &[EvalSample::default()])[0][..2], [1.0, 2.0]);
}

#[test]
fn a_light_of_parts_is_as_told() {
    let made = look(&json!({
        "nodes": [
            {"id": "place", "kind": "position"},
            {"id": "lamp", "kind": "light_from_parts",
                "values": {"color": [0.5, 0.25, 1, 0.5], "intensity": 3}},
            {"id": "parts", "kind": "light_parts"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "place", "to": "lamp.direction"},
            {"from": "lamp", "to": "parts.light"}, {"from": "parts.color", "to": "output.color"}]
    }));
    let at = |position: DVec3| EvalSample { position, ..EvalSample::default() };
    let places = [DVec3::new(3.0, 0.0, 4.0), DVec3::ZERO, DVec3::new(0.0, -1e-9, 0.0)];
    let got = eval(&made, "parts.direction", &places.map(at));
    for (got, place) in got.iter().zip(places) {
        let wanted = if place == DVec3::ZERO { DVec3::Z } else { place.normalize() };
        assert!((DVec3::from_slice(got) - wanted).length() < 1e-6, "{place}: {got:?}");
    }
    let of = |output: &str| eval(&made, output, &[at(DVec3::X)])[0];
    assert_eq!(of("parts.color")[..3], [0.5, 0.25, 1.0]);
    assert_eq!(of("parts.intensity")[0], 3.0);
}

/// A fill counts by one amount where the key's tone is, and by another in its shade.
#[test]
fn a_fill_tints_light_and_shade_apart() {
    let mut random = Random::new(316);
    let (below, color, toward) = ([0.2, 0.1, 0.15], [0.5, 0.75, 0.25], DVec3::new(0.6, 0.0, 0.8));
    for _ in 0..12 {
        let [key, lit, shade] = std::array::from_fn(|_| f64::from(random.between(0.0, 1.0) as f32));
        let fill = look(&json!({
            "lights": {"fill": {"direction": toward.to_array(), "space": "world"}},
            "nodes": [
                {"id": "paint", "kind": "base",
                    "values": {"color": [below[0], below[1], below[2], 1]}},
                {"id": "fill", "kind": "fill_layer", "values": {"key": key, "lit": lit,
                    "shade": shade, "color": [color[0], color[1], color[2], 1]}},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "paint", "to": "fill.below"},
                {"from": "fill.below", "to": "output.color"}]
        }));
        let normal = random.direction();
        let sample = EvalSample { normal, ..EvalSample::default() };
        // Lambert's cosine is the profile that a node begins with.
        let tone = normal.dot(toward).max(0.0) * (shade + (lit - shade) * key);
        let drawn = eval(&fill, "fill.below", &[sample])[0];
        for channel in 0..3 {
            let wanted = (below[channel] + tone * color[channel]).min(1.0);
            assert!((drawn[channel] - wanted).abs() < 2e-6, "{}: {wanted}", drawn[channel]);
        }
    }
}
