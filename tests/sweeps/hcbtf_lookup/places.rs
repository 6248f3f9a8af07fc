//! Nodes that make texture coordinates for lookups, against formulas by hand, far away and on
//! either side of 0.

use chiaro::frame::EvalSample;
use glam::{DVec2, DVec3};
use serde_json::{Value as Json, json};

use crate::support::eval::{eval, look, truth};
use crate::support::random::Random;
use crate::support::report::Errors;

/// Outputs of a node for each sample, on the GPU and in f64; the components of a sample's position
/// are wired to `inputs`, in order.
fn outputs(
    kind: &str,
    values: &Json,
    inputs: &[&str],
    outputs: &[&str],
    samples: &[EvalSample],
) -> Vec<[Vec<[f64; 4]>; 2]> {
    let mut wires = vec![
        json!({"from": "place", "to": "parts.vector"}),
        json!({"from": "node", "to": "output.color"}),
    ];
    let numbers = ["parts.x", "parts.y", "parts.z"];
    wires.extend(
        inputs
            .iter()
            .zip(numbers)
            .map(|(input, from)| json!({"from": from, "to": format!("node.{input}")})),
    );
    let look = look(&json!({
        "nodes": [
            {"id": "place", "kind": "position"},
            {"id": "parts", "kind": "separate_vector"},
            {"id": "node", "kind": kind, "values": values},
            {"id": "output", "kind": "output"}
        ],
        "wires": wires
    }));
    let both = |output: &&str| {
        let output = format!("node.{output}");
        [eval(&look, &output, samples), truth(&look, &output, samples)]
    };
    outputs.iter().map(both).collect()
}

/// A texture coordinate that f32 holds exactly, up to thousands of repeats away.
fn coordinate(random: &mut Random) -> DVec2 {
    let axis = |random: &mut Random| {
        let reach = random.between(-8.0, 12.0).exp2();
        f64::from((random.between(-1.0, 1.0) * reach) as f32)
    };
    DVec2::new(axis(random), axis(random))
}

#[test]
fn constant_size_follows_the_distance_in_powers_of_two() {
    let mut random = Random::new(301);
    let mut samples = Vec::new();
    while samples.len() < 2000 {
        let [distance, near] = [0; 2].map(|_| f64::from(random.between(-12.0, 12.0).exp2() as f32));
        // Near a power of two rounding decides which of two equal pictures is *even* and which
        // *odd*, so those distances are left out.
        let octave = (distance / near).log2();
        if (octave - octave.round()).abs() > 1e-3 {
            let position = DVec3::new(distance, near, 0.0);
            samples.push(EvalSample {
                uv: coordinate(&mut random),
                position,
                ..EvalSample::default()
            });
        }
    }
    let fade = 0.625;
    let values = json!({"fade": fade});
    let found =
        outputs("constant_size", &values, &["distance", "near"], &["even", "odd", "mix"], &samples);
    for (place, bound) in [(0, 1e-6), (1, 1e-13)] {
        let mut errors = Errors::new(format!("constant size, {place}"), bound);
        for (index, sample) in samples.iter().enumerate() {
            let octave = (sample.position.x / sample.position.y).log2();
            let low = octave.floor();
            let part = (0.5 + (octave - low - 0.5) / fade).clamp(0.0, 1.0);
            let is_even = low.rem_euclid(2.0) < 0.5;
            let (even, odd, mix) =
                if is_even { (low, low + 1.0, part) } else { (low + 1.0, low, 1.0 - part) };
            for (output, octave) in [(0, even), (1, odd)] {
                let wanted = sample.uv * (-octave).exp2();
                for (axis, wanted) in wanted.to_array().into_iter().enumerate() {
                    let unit = wanted.abs().max(1.0);
                    errors.note(found[output][place][index][axis] / unit, wanted / unit, || {
                        format!("{sample:?}")
                    });
                }
            }
            // Errors of the GPU's logarithm weigh less, by 0.2.
            let slack = if place == 0 { 0.2 } else { 1e-7 };
            errors.note(found[2][place][index][0] * slack, mix * slack, || {
                format!("mix of {sample:?}")
            });
        }
        errors.finish();
    }
}

#[test]
fn constant_size_has_an_answer_everywhere() {
    let hard = [-1.0, -0.0, 0.0, 1e-38, 1.0, 1e30];
    let pairs = hard.iter().flat_map(|x| hard.map(|y| DVec3::new(*x, y, 0.0)));
    let samples: Vec<EvalSample> = pairs
        .map(|position| EvalSample { uv: DVec2::new(-1e9, 0.5), position, ..EvalSample::default() })
        .collect();
    let found = outputs(
        "constant_size",
        &json!({}),
        &["distance", "near"],
        &["even", "odd", "mix"],
        &samples,
    );
    for values in found.iter().flatten().flatten() {
        assert!(values.iter().all(|x| x.is_finite()), "{values:?}");
    }
    for (sample, mix) in samples.iter().zip(&found[2][0]) {
        assert!((0.0..=1.0).contains(&mix[0]), "{sample:?}");
        // Without a distance, or without a distance to compare with, the coordinates are not
        // scaled.
        if sample.position.x <= 0.0 || sample.position.y <= 0.0 {
            assert!(
                mix[0] == 0.0 || sample.position.x * sample.position.y > 0.0,
                "{sample:?}: {mix:?}"
            );
        }
    }
}

/// The three corners of the lattice's triangle around a place, with the place's barycentric
/// coordinates; by Cartesian coordinates.
fn corners(p: DVec2) -> Vec<([i64; 2], f64)> {
    let at = |[i, j]: [i64; 2]| DVec2::new(i as f64 + 0.5 * j as f64, j as f64 * 0.75_f64.sqrt());
    let j = p.y / 0.75_f64.sqrt();
    let i = p.x - 0.5 * j;
    let low = [i.floor() as i64, j.floor() as i64];
    let area = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let triangles = [[[0, 0], [1, 0], [0, 1]], [[1, 1], [0, 1], [1, 0]]];
    triangles
        .into_iter()
        .map(|corners| {
            let corners = corners.map(|[di, dj]| [low[0] + di, low[1] + dj]);
            let [a, b, c] = corners.map(at);
            let whole = area(a, b, c);
            let near = [area(p, b, c), area(a, p, c), area(a, b, p)].map(|part| part / whole);
            corners.into_iter().zip(near).collect::<Vec<_>>()
        })
        .max_by(|one, other| {
            let least = |corners: &Vec<([i64; 2], f64)>| {
                corners.iter().map(|corner| corner.1).fold(1.0, f64::min)
            };
            least(one).total_cmp(&least(other))
        })
        .expect("two triangles")
}

#[test]
fn scattered_cells_count_as_near_as_they_are() {
    let mut random = Random::new(302);
    let (cells, sharpness) = (0.7, 0.4);
    let mut samples = Vec::new();
    while samples.len() < 2000 {
        let uv = DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0))
            * random.between(0.0, 6.0).exp2();
        let uv = uv.as_vec2().as_dvec2();
        if corners(uv * cells).iter().all(|(_, near)| *near > 1e-3) {
            samples.push(EvalSample { uv, ..EvalSample::default() });
        }
    }
    let values = json!({"cells": cells, "sharpness": sharpness, "seed": 5});
    let found = outputs("scatter_uv", &values, &[], &["a", "b", "c", "mix_b", "mix_c"], &samples);
    // The offset of a cell's tile is the same everywhere in the cell, and differs from cell to
    // cell.
    let mut moved: std::collections::HashMap<[i64; 2], DVec2> = std::collections::HashMap::new();
    for (place, bound) in [(1, 1e-9), (0, 2e-4)] {
        let mut errors = Errors::new(format!("scattered shares, {place}"), bound);
        for (index, sample) in samples.iter().enumerate() {
            let corners = corners(sample.uv * cells);
            let most = corners.iter().map(|corner| corner.1).fold(0.0, f64::max);
            let width = 0.5 * (1.0 - sharpness);
            let counts = |near: f64| (1.0 + (near - most) / width).clamp(0.0, 1.0);
            let whole: f64 = corners.iter().map(|corner| counts(corner.1)).sum();
            let mut shares = [0.0; 3];
            for (cell, near) in corners {
                let which = (cell[0] - cell[1]).rem_euclid(3) as usize;
                shares[which] = counts(near) / whole;
                let got = found[which][place][index];
                let by = DVec2::new(got[0], got[1]) - sample.uv;
                let known = *moved.entry(cell).or_insert(by);
                errors.note((by - known).length() * 0.1, 0.0, || {
                    format!("cell {cell:?} at {sample:?}")
                });
                assert!((-1e-4..1.0001).contains(&by.x) && (-1e-4..1.0001).contains(&by.y), "{by}");
            }
            let [a, b, c] = shares;
            let mix_b = if a + b > 0.0 { b / (a + b) } else { 0.0 };
            // Where C alone counts, the share of B beside A does not matter.
            errors.note(found[3][place][index][0] * (a + b), mix_b * (a + b), || {
                format!("B of {sample:?}")
            });
            errors.note(found[4][place][index][0], c, || format!("C of {sample:?}"));
        }
        errors.finish();
    }
    let all: Vec<DVec2> = moved.values().copied().collect();
    let mean = all.iter().sum::<DVec2>() / all.len() as f64;
    assert!(all.len() > 300 && (mean - 0.5).length() < 0.08, "{} cells, {mean}", all.len());
    let twins = all
        .iter()
        .enumerate()
        .filter(|(i, one)| all[..*i].iter().any(|other| (**one - other).length() < 1e-3));
    assert!(twins.count() < 5);
}

#[test]
fn scattered_coordinates_are_finite_everywhere() {
    let far = [-1e30, -1e9, -1000.3, -1e-9, -0.0, 0.5, 1e7, 1e30];
    let samples: Vec<EvalSample> = far
        .iter()
        .flat_map(|u| far.map(|v| EvalSample { uv: DVec2::new(*u, v), ..EvalSample::default() }))
        .collect();
    for values in [
        json!({}),
        json!({"sharpness": 1.0, "cells": 1e20}),
        json!({"sharpness": -3.0, "cells": -2.0}),
    ] {
        let found =
            outputs("scatter_uv", &values, &[], &["a", "b", "c", "mix_b", "mix_c"], &samples);
        for value in found.iter().flatten().flatten() {
            assert!(value.iter().all(|x| x.is_finite()), "{value:?}");
        }
        for mix in found[3..].iter().flatten().flatten() {
            assert!((0.0..=1.0).contains(&mix[0]), "{mix:?}");
        }
    }
}
