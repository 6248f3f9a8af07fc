//! Every formula of the BADF model on the GPU against f64, by the paper's own formulas.
#![cfg(feature = "gpu")]

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::support::badf::{self, Mode, angle, f32_of, held, mirrored};
use crate::support::eval::{eval, eval_with, look, options};
use crate::support::random::Random;
use crate::support::report::Errors;
use chiaro::document::{Value, Values};
use chiaro::frame::{EvalSample, LightOverride, SetupLook};
use chiaro::interp::{Precision, Value as Number};
use glam::{DMat3, DQuat, DVec3, DVec4};
use serde_json::json;

const TYPES: [&str; 4] = ["diffuse", "specular", "screen_aligned", "half_vector"];

fn numbers(values: &[(&str, f64)]) -> Values {
    values.iter().map(|(name, x)| ((*name).into(), Value::Number(*x))).collect()
}

fn toward(direction: DVec3) -> indexmap::IndexMap<chiaro::ids::LightId, LightOverride> {
    [("key".into(), LightOverride { direction: Some(direction), ..LightOverride::default() })]
        .into_iter()
        .collect()
}

/// A look of a light, a parametrization and a profile whose parameters each sample sets.
fn profile_look() -> SetupLook {
    let exposed = ["offset", "falloff", "cutoff", "shift"]
        .map(|name| json!({"name": name, "target": format!("tone.{name}")}));
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "exposed": exposed,
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "angle", "kind": "parametrization"},
            {"id": "tone", "kind": "profile"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "angle.light"},
            {"from": "angle", "to": "tone.angle"},
            {"from": "tone", "to": "output.color"}
        ]
    }))
}

/// The look with the profile's parameters wired from the surface, so that `prepare` runs in the
/// fragment, in f32.
fn profile_look_per_fragment() -> SetupLook {
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "angle", "kind": "parametrization"},
            {"id": "place", "kind": "position"},
            {"id": "parts", "kind": "separate_vector"},
            {"id": "tone", "kind": "profile"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "angle.light"},
            {"from": "angle", "to": "tone.angle"},
            {"from": "place", "to": "parts.vector"},
            {"from": "parts.x", "to": "tone.offset"},
            {"from": "parts.y", "to": "tone.falloff"},
            {"from": "parts.z", "to": "tone.cutoff"},
            {"from": "tone", "to": "output.color"}
        ]
    }))
}

/// A normal at an angle from the light at +z, and the angle that its f32 components stand for.
fn at_angle(u: f64) -> (DVec3, f64) {
    // The normal lies in a plane along no axis, so that every component is rounded.
    let aside = DVec3::new(0.6, 0.8, 0.0);
    let normal = DVec3::new(f32_of(u.sin() * aside.x), f32_of(u.sin() * aside.y), f32_of(u.cos()));
    (normal, angle(normal, DVec3::Z))
}

fn sample_of(u: f64, shift: f64, [offset, falloff, cutoff]: [f64; 3]) -> (EvalSample, f64) {
    let (normal, u) = at_angle(u);
    let values =
        numbers(&[("offset", offset), ("falloff", falloff), ("cutoff", cutoff), ("shift", shift)]);
    (
        EvalSample {
            normal,
            values,
            position: DVec3::new(offset, falloff, cutoff),
            ..EvalSample::default()
        },
        u,
    )
}

/// Angles from 0 to pi, denser at both ends.
fn angles() -> Vec<f64> {
    let even = (0..=64).map(|i| PI * f64::from(i) / 64.0);
    let small = (1..=16).map(|i| 10_f64.powf(-0.4 * f64::from(i)));
    even.chain(small.clone()).chain(small.map(|x| PI - x)).collect()
}

#[test]
fn the_angles_of_all_parametrizations() {
    for (index, kind) in TYPES.iter().enumerate() {
        let look = look(&json!({
            "lights": {"key": {"direction": [0, 0, 1]}},
            "nodes": [
                {"id": "light", "kind": "light", "values": {"light": "key"}},
                {"id": "angle", "kind": "parametrization", "values": {"type": kind}},
                {"id": "tone", "kind": "profile"},
                {"id": "output", "kind": "output"}
            ],
            "wires": [
                {"from": "light", "to": "angle.light"},
                {"from": "angle", "to": "tone.angle"},
                {"from": "tone", "to": "output.color"}
            ]
        }));
        let mut random = Random::new(index as u64);
        let mut samples = Vec::new();
        let mut wanted = Vec::new();
        for round in 0..4000 {
            let turn = random.rotation();
            let camera = DMat3::from_quat(random.rotation());
            let (n, v) = (held(random.direction()), held(random.direction()));
            let mut own = random.direction();
            if round % 4 == 0 {
                // A light close to, or opposite to, the direction at which the angle is 0.
                let near = match *kind {
                    "diffuse" => turn.inverse() * n,
                    "specular" => turn.inverse() * mirrored(n, v),
                    "screen_aligned" => camera * n,
                    _ => turn.inverse() * mirrored(v, n),
                };
                let apart = 10_f64.powf(random.between(-7.0, -1.0));
                own = (near + apart * random.direction())
                    * if random.chance(0.3) { -1.0 } else { 1.0 };
            }
            let l = turn * own.normalize();
            wanted.push(match *kind {
                "diffuse" => angle(n, l),
                "specular" => angle(mirrored(n, v), l),
                "screen_aligned" => angle(camera * n, own),
                _ => angle(n, l + v.normalize()),
            });
            samples.push(EvalSample {
                normal: n,
                view: v,
                camera,
                frame: turn,
                lights: toward(own),
                ..EvalSample::default()
            });
        }
        // Rounding a unit vector to f32 turns it by up to 1e-7, and so does rounding the camera's
        // matrix.
        let mut errors = Errors::new(
            format!("angle u, {kind}"),
            if *kind == "half_vector" { 4e-7 } else { 5e-7 },
        );
        for ((value, u), sample) in
            eval(&look, "angle.angle", &samples).iter().zip(&wanted).zip(&samples)
        {
            // Where light and eye are opposite, rounding alone decides the half-vector's direction.
            let l = sample.frame * sample.lights["key"].direction.unwrap_or(DVec3::Z).normalize();
            if *kind == "half_vector" && (l + sample.view).length() < 0.5 {
                assert!(value[0].is_finite());
                continue;
            }
            errors.note(value[0], *u, || format!("{sample:?}"));
        }
        errors.finish();
    }
}

fn check_alpha(
    name: &str,
    bound: f64,
    look: &SetupLook,
    cases: &[(f64, f64, [f64; 3])],
    round: bool,
) {
    let held_case = |&(u, shift, p): &(f64, f64, [f64; 3])| {
        if round { (u, f32_of(shift), p.map(f32_of)) } else { (u, shift, p) }
    };
    let cases: Vec<_> = cases.iter().map(held_case).collect();
    let (mut samples, angles): (Vec<_>, Vec<_>) =
        cases.iter().map(|&(u, shift, p)| sample_of(u, shift, p)).unzip();
    if look.look.exposed.is_empty() {
        samples.iter_mut().for_each(|sample| sample.values.clear());
    }
    let mut errors = Errors::new(name, bound);
    let mut steepest = Errors::new(format!("{name}, at the cut-off where f' > pi/2"), 5e-4);
    for ((value, (_, shift, parameters)), u) in
        eval(look, "tone.tone", &samples).iter().zip(&cases).zip(angles)
    {
        let [tau, f, c] = badf::sanitized(*parameters);
        let x = (u - shift).clamp(0.0, PI) - tau;
        // At the very edge of a step one rounding of u decides; `hard_cases` tests those edges one
        // by one.
        if (c - tau <= 0.0 || f - tau <= 2e-9) && x.abs() < 2e-6 {
            assert!(value[0] == 0.0 || value[0] == 1.0);
            continue;
        }
        // Beyond pi/2 the exponent lies between 1/2 and 1, and the slope at the cut-off is
        // infinite: 1e-7 in the base is up to 3e-4 in alpha.
        let base = 1.0 - ((0.5 * x).sin() / (0.5 * (c - tau)).sin()).powi(2);
        let is_steepest = f - tau > FRAC_PI_2 && base < 1e-3;
        let errors = if is_steepest { &mut steepest } else { &mut errors };
        errors.note(value[0], badf::alpha(u, *shift, *parameters), || {
            format!("u {u} shift {shift} {parameters:?}")
        });
    }
    if steepest.has_any() {
        steepest.finish();
    }
    errors.finish();
}

/// A grid of sanitized parameters around an offset, with fall-offs from `least` on.
fn grid(offsets: &[f64], least: f64) -> Vec<(f64, f64, [f64; 3])> {
    let mut cases = Vec::new();
    for &tau in offsets {
        for c in [0.05, 0.3, 0.7, 1.0, FRAC_PI_2, 2.0, 2.6, 3.0, PI] {
            for part in [0.01, 0.1, 0.3, 0.5, 0.8, 1.0] {
                if c * part >= least && tau + c <= PI + 1e-9 {
                    cases.extend(
                        angles().into_iter().map(|u| (u, 0.0, [tau, tau + c * part, tau + c])),
                    );
                }
            }
        }
    }
    cases
}

#[test]
fn alpha_without_an_offset() {
    check_alpha("alpha, tau = 0, f >= .2", 2e-6, &profile_look(), &grid(&[0.0], 0.2), false);
}

#[test]
fn alpha_with_offsets() {
    check_alpha(
        "alpha, tau > 0, f' >= .2",
        2e-6,
        &profile_look(),
        &grid(&[0.01, 0.4, 1.3, 2.5], 0.2),
        false,
    );
}

#[test]
fn alpha_of_narrow_profiles() {
    for (least, most, bound) in [(0.1_f64, 1.0_f64, 1e-6), (0.01, 0.1, 1e-6), (1e-3, 1e-2, 1e-6)] {
        let mut random = Random::new(7);
        let cases: Vec<_> = (0..8000)
            .map(|_| {
                let f = least * (most / least).powf(random.unit());
                let c = random.between(f, PI);
                // An angle at which the profile is neither 0 nor 1.
                (f * random.between(0.0, 3.0), 0.0, [0.0, f, c])
            })
            .collect();
        check_alpha(
            &format!("alpha, tau = 0, {least} <= f < {most}"),
            bound,
            &profile_look(),
            &cases,
            false,
        );
        let moved: Vec<_> = cases
            .iter()
            .map(|&(u, _, [_, f, c])| {
                let tau = random.between(0.0, PI - c).max(0.0);
                (u + tau, 0.0, [tau, f + tau, (c + tau).min(PI)])
            })
            .collect();
        // sin and cos of (u - tau) / 2 carry one rounding each, and the profile is 1/f steep.
        check_alpha(
            &format!("alpha, tau > 0, {least} <= f' < {most}"),
            3e-7 / least + 2e-6,
            &profile_look(),
            &moved,
            false,
        );
    }
}

#[test]
fn alpha_with_warps() {
    let mut random = Random::new(8);
    let cases: Vec<_> = (0..8000)
        .map(|_| {
            let tau = random.between(0.0, 2.5);
            let c = random.between(tau + 0.25, PI + 0.3).min(PI);
            let f = random.between(tau + 0.2, c.max(tau + 0.21));
            (random.between(0.0, PI), random.between(-PI, PI), [tau, f, c])
        })
        .collect();
    check_alpha("alpha, warped, f' >= .2", 3e-6, &profile_look(), &cases, false);
}

#[test]
fn alpha_of_parameters_out_of_order() {
    let mut random = Random::new(9);
    let odd = |random: &mut Random| match random.index(8) {
        0 => 0.0,
        1 => PI,
        2 => random.between(-10.0, 10.0),
        3 => 1e30,
        4 => -1e30,
        _ => random.between(-0.5, 3.6),
    };
    let mut cases = Vec::new();
    while cases.len() < 8000 {
        let parameters = [odd(&mut random), odd(&mut random), odd(&mut random)];
        let [tau, f, c] = badf::sanitized(parameters);
        // Narrow and near-ambient profiles have tests of their own; at the corner f' = c' = pi the
        // exponent depends on the last digit of pi.
        let is_plain = |x: f64| x == 0.0 || (0.2..3.0).contains(&x);
        if is_plain(f - tau) && is_plain(c - tau) && !(PI - 1e-4..PI).contains(&tau) {
            cases.push((random.between(0.0, PI), 0.0, parameters));
        }
    }
    check_alpha("alpha, parameters out of order (D2)", 3e-6, &profile_look(), &cases, false);
}

#[test]
fn alpha_of_parameters_wired_per_fragment() {
    let cases: Vec<_> = grid(&[0.0, 0.4, 1.3], 0.2);
    check_alpha(
        "alpha, prepare in the fragment, f' >= .2",
        4e-6,
        &profile_look_per_fragment(),
        &cases,
        true,
    );
}

/// Angles near 0, in the middle and near pi, as f32 holds them; the last is the f32 next to pi.
fn far_and_wide() -> Vec<f64> {
    let powers = || (1..=13).map(|i| 10_f64.powf(-0.5 * f64::from(i)));
    let near_pi = [5, 2, 1, 0].map(|i| f64::from(f32::from_bits((PI as f32).to_bits() - i)));
    let small = powers().filter(|x| *x > 1e-4);
    let all = small.chain([0.5, 1.0, 1.5, 1.6, 2.0, 2.5]).chain(powers().map(|x| PI - x));
    all.map(f32_of).chain(near_pi).collect()
}

/// alpha of an angle with a profile's parameters, by the library's functions in the f32 of the CPU.
fn in_f32(u: f64, [offset, falloff, cutoff]: [f64; 3]) -> f64 {
    let module = &chiaro::library::Library::built_in().nodes["profile"].module;
    let call = |function: &str, arguments: &[Number]| {
        let program = module.program(function).unwrap_or_else(|problem| panic!("{problem}"));
        program.call(arguments, Precision::F32).unwrap_or_else(|problem| panic!("{problem}"))
    };
    let shape = call("profile_shape", &[offset, falloff, cutoff].map(Number::Float));
    let half = Number::Struct(vec![Number::Float((0.5 * u).sin()), Number::Float((0.5 * u).cos())]);
    call("profile_point", &[half, shape]).as_f64().expect("a number")
}

/// Profiles over a footprint (docs/math.md 2.4) against the mean of 200 points of it. Errors are
/// greatest at the ends of the slope, where a derivative jumps.
#[test]
fn a_profile_over_a_footprint_is_its_mean() {
    let module = &chiaro::library::Library::built_in().nodes["profile"].module;
    let call = |function: &str, arguments: &[Number]| {
        let program = module.program(function).unwrap_or_else(|problem| panic!("{problem}"));
        program.call(arguments, Precision::F64).unwrap_or_else(|problem| panic!("{problem}"))
    };
    let mut random = Random::new(22);
    // By footprints below a tenth of the deviation, and above: greatest error, sum, count.
    let mut errors = [[0.0_f64; 3]; 2];
    for index in 0..40 {
        let tau = random.between(0.0, 1.0);
        let c = if index % 5 == 0 { PI } else { random.between(tau + 0.1, PI) };
        let f = if index % 7 == 0 { c } else { random.between(tau + 0.05, c) };
        let shape = call("profile_shape", &[tau, f, c].map(Number::Float));
        let deviation = shape.parts().and_then(|parts| parts[6].as_f64()).expect("a deviation");
        for share in [0.03, 0.09, 0.2, 0.5, 0.95] {
            let w = (share * deviation).min(0.5);
            for step in 0..40 {
                let u = 0.5 * w + (PI - w) * f64::from(step) / 39.0;
                let at = |part: i32| u + w * ((f64::from(part) + 0.5) / 200.0 - 0.5);
                let mean =
                    (0..200).map(|part| badf::alpha(at(part), 0.0, [tau, f, c])).sum::<f64>();
                let half = [(0.5 * u).sin(), (0.5 * u).cos()].map(Number::Float).to_vec();
                for function in ["profile_filtered", "profile_filtered_quick"] {
                    let given = [Number::Struct(half.clone()), Number::Float(w), shape.clone()];
                    let got = call(function, &given).as_f64().expect("a number");
                    let error = (got - mean / 200.0).abs();
                    let [most, sum, count] = &mut errors[usize::from(share > 0.1)];
                    (*most, *sum, *count) = (most.max(error), *sum + error, *count + 1.0);
                }
            }
        }
    }
    let [narrow, wide] = errors.map(|[most, sum, count]| (most, sum / count));
    assert!(narrow.0 < 1.1e-2 && narrow.1 < 6e-5, "{narrow:?}");
    assert!(wide.0 < 9e-3 && wide.1 < 1e-4, "{wide:?}");
}

#[test]
fn alpha_of_parameters_wired_near_0_and_near_pi() {
    let issue = [0.0, f32_of(PI - 2.653_59e-6), f32_of(PI)];
    assert!((badf::alpha(2.5, 0.0, issue) - 0.315_322_4).abs() < 1e-7, "cos(1.25)");
    let mut cases = vec![(2.5, 0.0, issue)];
    for tau in [0.0, 1e-5, 3e-3] {
        for c in far_and_wide() {
            for f in far_and_wide() {
                let [_, f, c] = [tau, f, c].map(f32_of);
                // Profiles that are narrow beside their cut-off have tests of their own.
                if tau + 0.05 * (c - tau) < f && f <= c {
                    let parts = [0.1, 0.4, 0.7, 0.95, (f - tau) / (c - tau)];
                    cases.extend(parts.map(|part| (tau + part * (c - tau), 0.0, [tau, f, c])));
                }
            }
        }
    }
    // Near pi the slope at the cut-off is infinite, and rounding of the angle shows.
    cases.retain(|(u, _, _)| *u < 3.1);
    let mut errors = Errors::new("alpha, prepare in f32 on the CPU, everywhere", 2e-5);
    for &(u, _, parameters) in &cases {
        let parameters = parameters.map(f32_of);
        errors.note(in_f32(u, parameters), badf::alpha(u, 0.0, parameters), || {
            format!("u {u} {parameters:?}")
        });
    }
    errors.finish();
    check_alpha(
        "alpha, prepare in the fragment, everywhere",
        2e-5,
        &profile_look_per_fragment(),
        &cases,
        true,
    );
}

#[test]
fn the_two_forms_of_the_truth_agree() {
    let mut errors = Errors::new("f64: eq. 5, 10, 11 to the letter against 1 - q^2", 1e-11);
    for (u, shift, parameters) in grid(&[0.0, 0.4, 1.3], 0.05) {
        let [tau, _, c] = parameters;
        // At c itself a base of 1e-17 in place of 0 is raised to a power below 1, and the result
        // exceeds the bound.
        if (u - c).abs() > 1e-3 && c - tau > 0.1 {
            errors.note(
                badf::alpha_by_the_letter(u, shift, parameters),
                badf::alpha(u, shift, parameters),
                || format!("{u} {parameters:?}"),
            );
        }
    }
    errors.finish();
}

#[test]
fn the_special_cases_of_section_3_2() {
    type Shape = fn(f64) -> f64;
    let cases: [(&str, [f64; 3], Shape); 5] = [
        ("Lambert", [0.0, FRAC_PI_2, FRAC_PI_2], |u| u.cos().max(0.0)),
        ("half-Lambert", [0.0, FRAC_PI_2, PI], |u| 0.5 + 0.5 * u.cos()),
        // gamma = 1/sin^2 f is Phong's exponent.
        ("Phong", [0.0, 0.4, FRAC_PI_2], |u| u.cos().max(0.0).powf(1.0 / 0.4_f64.sin().powi(2))),
        ("cartoon", [FRAC_PI_4, FRAC_PI_4, FRAC_PI_4], |u| if u <= FRAC_PI_4 { 1.0 } else { 0.0 }),
        ("ambient", [PI, 0.1, 0.2], |_| 1.0),
    ];
    for (name, parameters, shape) in cases {
        let us = angles().into_iter().filter(|u| name != "cartoon" || (u - FRAC_PI_4).abs() > 1e-6);
        let (samples, us): (Vec<_>, Vec<_>) = us.map(|u| sample_of(u, 0.0, parameters)).unzip();
        let mut errors =
            Errors::new(format!("3.2 {name}"), if name == "Phong" { 1e-6 } else { 5e-7 });
        for (value, u) in eval(&profile_look(), "tone.tone", &samples).iter().zip(us) {
            errors.note(value[0], shape(u), || format!("{u}"));
        }
        errors.finish();
    }
    // Presets of the node have these parameters.
    let library = chiaro::library::Library::built_in();
    let presets = &library.nodes["profile"].presets;
    for label in ["Lambert", "Half-Lambert", "Phong specular", "Cartoon", "Ambient"] {
        assert!(presets.iter().any(|preset| preset.label == label), "{label}");
    }
}

/// Transition, color and warp by curvature.
#[test]
fn curvature_moves_and_colors() {
    let curved = look(&json!({
        "exposed": [
            {"name": "slope", "target": "convexity.slope"},
            {"name": "amount", "target": "warp.amount"},
            {"name": "convex", "target": "color.convex"},
            {"name": "concave", "target": "color.concave"}
        ],
        "nodes": [
            {"id": "convexity", "kind": "transition"},
            {"id": "warp", "kind": "warp"},
            {"id": "color", "kind": "curvature_color"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "convexity", "to": "warp.convexity"},
            {"from": "convexity", "to": "color.convexity"},
            {"from": "color", "to": "output.color"}
        ]
    }));
    let mut random = Random::new(11);
    let signed_power = |random: &mut Random, low, high| {
        10_f64.powf(random.between(low, high)) * if random.chance(0.5) { -1.0 } else { 1.0 }
    };
    let samples: Vec<EvalSample> = (0..6000)
        .map(|_| {
            let mut values = numbers(&[
                ("slope", signed_power(&mut random, -6.0, 2.0)),
                ("amount", random.between(-4.0, 4.0)),
            ]);
            for name in ["convex", "concave"] {
                values.insert(name.into(), Value::Vector((0..4).map(|_| random.unit()).collect()));
            }
            EvalSample {
                kappa: f32_of(signed_power(&mut random, -3.0, 5.0)),
                values,
                ..EvalSample::default()
            }
        })
        .collect();
    let number = |sample: &EvalSample, name: &str| match &sample.values[name] {
        Value::Number(x) => *x,
        other => panic!("{other:?}"),
    };
    let color = |sample: &EvalSample, name: &str| match &sample.values[name] {
        Value::Vector(v) => DVec4::from_slice(v),
        other => panic!("{other:?}"),
    };
    let mut transition = Errors::new("curvature transition lambda (eq. 7)", 2e-7);
    let mut warp = Errors::new("curvature warp T (eq. 8)", 1e-6);
    let mut mixed = Errors::new("curvature color (eq. 7)", 3e-7);
    let all = |output| eval(&curved, output, &samples);
    let (lambdas, warps, colors) =
        (all("convexity.convexity"), all("warp.shift"), all("color.color"));
    for (index, sample) in samples.iter().enumerate() {
        let lambda = badf::lambda(sample.kappa, number(sample, "slope"));
        transition.note(lambdas[index][0], lambda, || format!("{sample:?}"));
        warp.note(warps[index][0], badf::warp(lambda, number(sample, "amount")), || {
            format!("{sample:?}")
        });
        let wanted = lambda * color(sample, "convex") + (1.0 - lambda) * color(sample, "concave");
        for (got, wanted) in colors[index].iter().zip(wanted.to_array()) {
            mixed.note(*got, wanted, || format!("{sample:?}"));
        }
    }
    [transition, warp, mixed].into_iter().for_each(Errors::finish);
}

/// An unset concave color is the convex one, which may come from a value, a wire, or a scene.
#[test]
fn an_unset_concave_color_is_the_convex_one() {
    let base = json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "exposed": [{"name": "convex", "target": "layer.convex"}],
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0, 0, 0]}},
            {"id": "tint", "kind": "combine_vector", "values": {"x": 0.2, "y": 0.6, "z": 0.4}},
            {"id": "layer", "kind": "light_layer",
             "values": {
                 "light": "key", "convex": [0.2, 0.6, 0.4], "offset": 3.2, "slope": 1,
                 "blend": "alpha"
             }},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}]
    });
    let at = |kappa: f64| EvalSample { kappa, ..EvalSample::default() };
    let mut samples = vec![at(0.0), at(3.0), at(-3.0), at(0.3)];
    let check = |case: &str,
                 edited: &serde_json::Value,
                 samples: &[EvalSample],
                 wanted: fn(f64) -> [f64; 3]| {
        for (sample, got) in samples.iter().zip(eval(&look(edited), "", samples)) {
            let wanted = wanted(sample.kappa);
            let far = got.iter().zip(wanted).any(|(got, wanted)| (got - wanted).abs() > 1e-6);
            assert!(!far, "{case}: {got:?} for {wanted:?} at kappa {}", sample.kappa);
        }
    };
    check("value", &base, &samples, |_| [0.2, 0.6, 0.4]);
    let mut wired = base.clone();
    wired["wires"].as_array_mut().unwrap().push(json!({"from": "tint", "to": "layer.convex"}));
    wired["exposed"] = json!([]);
    check("wire", &wired, &samples, |_| [0.2, 0.6, 0.4]);
    // An exposed concave color has a value of its own, which begins with the convex one.
    let mut exposed = base.clone();
    exposed["exposed"]
        .as_array_mut()
        .unwrap()
        .push(json!({"name": "concave", "target": "layer.concave"}));
    check("exposed", &exposed, &samples, |_| [0.2, 0.6, 0.4]);
    for sample in &mut samples {
        sample.values.insert("convex".into(), Value::Vector(vec![0.9, 0.1, 0.5]));
    }
    check("scene sets convex", &base, &samples, |_| [0.9, 0.1, 0.5]);
    for sample in &mut samples {
        sample.values.insert("concave".into(), Value::Vector(vec![0.1, 0.3, 0.5]));
    }
    check("scene sets both", &exposed, &samples, |kappa| {
        let lambda = 0.5 + 0.5 * kappa.tanh();
        [0.1 + lambda * 0.8, 0.3 - lambda * 0.2, 0.5]
    });
}

#[test]
fn the_blends() {
    for mode in Mode::ALL.into_iter().chain(Mode::PAINTED) {
        // Quotients of a dodge and a burn grow as the layer nears white or black.
        let is_quotient = matches!(mode, Mode::Painted("color_dodge" | "color_burn"));
        let bound = match mode {
            Mode::Painted(_) if is_quotient => 1e-4,
            Mode::Painted(_) => 2e-6,
            _ => 4e-7,
        };
        for clamped in [true, false] {
            let look = look(&json!({
                "exposed": [
                    {"name": "base", "target": "base.color"},
                    {"name": "color", "target": "blend.color"},
                    {"name": "tone", "target": "blend.tone"},
                    {"name": "opacity", "target": "blend.opacity"}
                ],
                "nodes": [
                    {"id": "base", "kind": "base"},
                    {
                        "id": "blend", "kind": "blend",
                        "values": {"mode": mode.word(), "clamped": clamped}
                    },
                    {"id": "output", "kind": "output"}
                ],
                "wires": [
                    {"from": "base", "to": "blend.below"}, {"from": "blend", "to": "output.color"}
                ]
            }));
            let mut random = Random::new(20);
            let number = |random: &mut Random| match random.index(6) {
                0 => 0.0,
                1 => 1.0,
                // Both sides see the same number.
                _ => f64::from(random.unit() as f32),
            };
            let mut samples = Vec::new();
            let mut wanted = Vec::new();
            for _ in 0..1500 {
                let mut color = || DVec4::from_array([(); 4].map(|()| number(&mut random)));
                let (base, layer) = (color(), color());
                let (rho, opacity) = (number(&mut random), number(&mut random));
                let mut values = numbers(&[("tone", rho), ("opacity", opacity)]);
                values.insert("base".into(), Value::Vector(base.to_array().to_vec()));
                values.insert("color".into(), Value::Vector(layer.to_array().to_vec()));
                wanted.push(badf::blend(
                    mode,
                    badf::premultiplied(base),
                    layer,
                    rho,
                    opacity,
                    clamped,
                ));
                samples.push(EvalSample { values, ..EvalSample::default() });
            }
            let clamping = if clamped { "clamped" } else { "free" };
            let mut errors =
                Errors::new(format!("blend {}, {clamping} (eq. 2, D8)", mode.word()), bound);
            for ((value, wanted), sample) in
                eval(&look, "blend.below", &samples).iter().zip(&wanted).zip(&samples)
            {
                for (got, wanted) in value.iter().zip(wanted.to_array()) {
                    errors.note(*got, wanted, || format!("{:?}", sample.values));
                }
            }
            errors.finish();
            let mut errors =
                Errors::new(format!("the same, straight: {} {clamping}", mode.word()), 5.0 * bound);
            for (value, wanted) in eval(&look, "", &samples).iter().zip(&wanted) {
                // Dividing by a small alpha multiplies rounding.
                let scale = wanted.w.clamp(1e-3, 1.0);
                for (got, wanted) in value.iter().zip(badf::straight(*wanted).to_array()) {
                    errors.note(got * scale, wanted * scale, || format!("{wanted:?}"));
                }
            }
            errors.finish();
        }
    }
}

/// A look of a base and a layer whose opacity, tone and alphas are wired from the surface or
/// exposed.
fn look_of_shares(mode: Mode, is_wired: bool) -> SetupLook {
    let mut json = json!({
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.9, 0.5, 0.1, 1]}},
            {"id": "color", "kind": "set_alpha", "values": {"color": [0.2, 0.4, 0.6, 1]}},
            {"id": "blend", "kind": "blend", "values": {"mode": mode.word()}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "base", "to": "blend.below"},
            {"from": "color", "to": "blend.color"},
            {"from": "blend", "to": "output.color"}
        ]
    });
    let ports =
        ["opacity", "tone", "alpha"].iter().zip(["blend.opacity", "blend.tone", "color.alpha"]);
    if is_wired {
        let more = [
            json!({"id": "place", "kind": "position"}),
            json!({"id": "parts", "kind": "separate_vector"}),
        ];
        json["nodes"].as_array_mut().expect("nodes").extend(more);
        let wires = json["wires"].as_array_mut().expect("wires");
        wires.push(json!({"from": "place", "to": "parts.vector"}));
        wires.extend(
            ports
                .zip(["x", "y", "z"])
                .map(|((_, port), axis)| json!({"from": format!("parts.{axis}"), "to": port})),
        );
    } else {
        json["exposed"] =
            ports.map(|(name, target)| json!({"name": name, "target": target})).collect();
    }
    look(&json)
}

/// Opacity, mask and alpha count from 0 to 1: beyond 1 they cover, and do not go on past the color.
#[test]
fn shares_count_from_0_to_1() {
    let base = DVec4::new(0.9, 0.5, 0.1, 1.0);
    let shares = [-40.0, -0.5, 0.0, 0.3, 1.0, 1.5, 2.0, 40.0];
    let mut exposed = Vec::new();
    for opacity in shares {
        for tone in shares {
            for alpha in shares {
                let values = numbers(&[("opacity", opacity), ("tone", tone), ("alpha", alpha)]);
                let position = DVec3::new(opacity, tone, alpha);
                exposed.push(EvalSample { values, position, ..EvalSample::default() });
            }
        }
    }
    for mode in Mode::ALL.into_iter().chain(Mode::PAINTED) {
        for is_wired in [false, true] {
            let mut samples = exposed.clone();
            let look = look_of_shares(mode, is_wired);
            if is_wired {
                samples.iter_mut().for_each(|sample| sample.values.clear());
            }
            let mut errors =
                Errors::new(format!("shares, {}, wired {is_wired}", mode.word()), 4e-7);
            let truth = crate::support::eval::truth(&look, "blend.below", &samples);
            for ((value, in_f64), sample) in
                eval(&look, "blend.below", &samples).iter().zip(truth).zip(&samples)
            {
                let [opacity, tone, alpha] = sample.position.to_array();
                let color = DVec4::new(0.2, 0.4, 0.6, alpha);
                let wanted = badf::blend(mode, base, color, tone, opacity, true).to_array();
                for k in 0..4 {
                    errors.note(value[k], wanted[k], || format!("{:?}", sample.position));
                    assert!(
                        (in_f64[k] - wanted[k]).abs() < 1e-12,
                        "{mode:?} {:?}",
                        sample.position
                    );
                }
            }
            errors.finish();
        }
    }
    // Numbers of the issue, where the layer used to cover with (0, 0, 0.3).
    let issue = badf::blend(
        Mode::Alpha,
        DVec4::new(0.9, 0.9, 0.9, 1.0),
        DVec4::new(0.2, 0.4, 0.6, 1.0),
        1.0,
        2.0,
        true,
    );
    assert!(issue.distance(DVec4::new(0.2, 0.4, 0.6, 1.0)) < 1e-15);
}

/// The alpha of a base and the share of convex and concave colors also count from 0 to 1.
#[test]
fn shares_of_bases_and_of_curvature_count_from_0_to_1() {
    let look = look(&json!({
        "exposed": [{"name": "share", "target": "share.value"}],
        "nodes": [
            {"id": "share", "kind": "number"},
            {"id": "color", "kind": "set_alpha", "values": {"color": [0.2, 0.4, 0.6, 1]}},
            {"id": "base", "kind": "base"},
            {
                "id": "tint", "kind": "curvature_color",
                "values": {"convex": [0.2, 0.4, 0.6], "concave": [0.9, 0.5, 0.1]}
            },
            {"id": "blend", "kind": "blend"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "share", "to": "color.alpha"},
            {"from": "share", "to": "tint.convexity"},
            {"from": "color", "to": "base.color"},
            {"from": "base", "to": "blend.below"},
            {"from": "tint", "to": "blend.color"},
            {"from": "blend", "to": "output.color"}
        ]
    }));
    for (share, bound) in [(-3.0, 0.0), (0.25, 0.25), (1.0, 1.0), (7.0, 1.0)] {
        let sample = EvalSample { values: numbers(&[("share", share)]), ..EvalSample::default() };
        let samples = [sample];
        let expected = [
            ("base.below", [0.2 * bound, 0.4 * bound, 0.6 * bound, bound]),
            ("tint.color", [0.9 - 0.7 * bound, 0.5 - 0.1 * bound, 0.1 + 0.5 * bound, 1.0]),
        ];
        for (output, wanted) in expected {
            let found = eval(&look, output, &samples)[0];
            let far = found.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(far < 3e-7, "{output} {share}: {found:?} for {wanted:?}");
        }
    }
}

/// No bounds are emitted for shares that are known to lie in 0 to 1.
#[test]
fn bounds_that_change_nothing_are_left_out() {
    let text = |look: &SetupLook| {
        let samples = [EvalSample::default()];
        let library = chiaro::library::Library::built_in();
        let batches = chiaro::frame::eval_batches(
            look,
            library,
            &samples,
            &options(""),
            &mut Default::default(),
        );
        batches.unwrap_or_else(|problems| panic!("{problems:?}"))[0].shader.wgsl.clone()
    };
    let wired = text(&look_of_shares(Mode::Alpha, true));
    assert_eq!(wired.matches("= clamp(parts.").count(), 2, "{wired}");
    assert_eq!(wired.matches("= vec4f(color.xyz, clamp(color.w, 0.0, 1.0))").count(), 1, "{wired}");
    // Uniforms are bounded on the host.
    assert!(!text(&look_of_shares(Mode::Alpha, false)).contains("clamp(parts"), "exposed");
    // Colors that are set from outside are bounded on the host, and mixing them by curvature keeps
    // the bounds.
    let exposed = look(&json!({
        "exposed": [
            {"name": "convex", "target": "layer.convex"},
            {"name": "concave", "target": "layer.concave"}
        ],
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "base", "kind": "base"},
            {
                "id": "layer", "kind": "light_layer",
                "values": {"light": "key", "blend": "alpha", "slope": 0.1}
            },
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}]
    }));
    assert!(!text(&exposed).contains("unit_"), "{}", text(&exposed));
    for mode in Mode::ALL {
        for (tier, kind) in [
            ("exact", "directional"),
            ("balanced", "directional"),
            ("fast", "directional"),
            ("exact", "point"),
        ] {
            let layered = look(&json!({
                "tier": tier,
                "lights": {"key": {"type": kind, "direction": [0, 0, 1]}},
                "nodes": [
                    {"id": "base", "kind": "base"},
                    {
                        "id": "layer", "kind": "light_layer",
                        "values": {"light": "key", "blend": mode.word(),
                        "slope": 0.1, "amount": 0.3, "convex": [0.2, 0.4, 0.6, 0.5],
                        "concave": [0.9, 0.5, 0.1],
                        "opacity": 0.75, "falloff": 0.5}},
                    {"id": "output", "kind": "output"}
                ],
                "wires": [
                    {"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}
                ]
            }));
            let text = text(&layered);
            assert!(
                !text.contains("unit_share") && !text.contains("with_unit_alpha"),
                "{tier} {kind} {mode:?}\n{text}"
            );
        }
    }
}

/// A layer of BADF's table 1, with random numbers.
struct Layer {
    kind: &'static str,
    light: usize,
    profile: [f64; 3],
    slope: f64,
    amount: f64,
    convex: DVec4,
    concave: DVec4,
    mode: Mode,
    opacity: f64,
    clamped: bool,
}

struct Stack {
    base: DVec4,
    lights: Vec<(DVec3, DVec3, f64)>,
    layers: Vec<Layer>,
}

impl Stack {
    fn random(random: &mut Random) -> Self {
        let color = |random: &mut Random| DVec4::from_array([(); 4].map(|()| random.unit()));
        let lights = (0..3)
            .map(|_| (random.direction(), color(random).truncate(), random.between(0.0, 2.0)))
            .collect();
        let layer = |random: &mut Random| {
            let tau = random.between(0.0, 1.5) * f64::from(u8::from(random.chance(0.6)));
            let c = random.between(tau + 0.3, PI);
            Layer {
                kind: TYPES[random.index(4)],
                light: random.index(3),
                profile: [tau, random.between(tau + 0.25, c), c],
                slope: random.between(-0.5, 0.5),
                amount: random.between(-0.8, 0.8),
                convex: color(random),
                concave: color(random),
                mode: *random.pick(&Mode::ALL),
                opacity: random.unit(),
                clamped: random.chance(0.7),
            }
        };
        let base =
            color(random).truncate().extend(if random.chance(0.5) { 1.0 } else { random.unit() });
        let layers = (0..1 + random.index(6)).map(|_| layer(random)).collect();
        Self { base, lights, layers }
    }

    fn look(&self) -> SetupLook {
        let mut nodes =
            vec![json!({"id": "base", "kind": "base", "values": {"color": self.base.to_array()}})];
        let mut wires = Vec::new();
        let mut below = "base".to_owned();
        for (index, layer) in self.layers.iter().enumerate() {
            let id = format!("layer_{index}");
            let [offset, falloff, cutoff] = layer.profile;
            nodes.push(json!({"id": id, "kind": "light_layer", "values": {
                "light": format!("light_{}", layer.light), "type": layer.kind,
                "offset": offset, "falloff": falloff, "cutoff": cutoff,
                "slope": layer.slope, "amount": layer.amount,
                "convex": layer.convex.to_array(), "concave": layer.concave.to_array(),
                "blend": layer.mode.word(), "opacity": layer.opacity, "clamped": layer.clamped
            }}));
            wires.push(json!({"from": format!("{below}.below"), "to": format!("{id}.below")}));
            below = id;
        }
        nodes.push(json!({"id": "output", "kind": "output"}));
        wires.push(json!({"from": format!("{below}.below"), "to": "output.color"}));
        let lights: serde_json::Map<String, serde_json::Value> = self
            .lights
            .iter()
            .enumerate()
            .map(|(index, (direction, color, intensity))| {
                let light = json!({
                    "direction": direction.to_array(), "color": color.to_array(),
                    "intensity": intensity
                });
                (format!("light_{index}"), light)
            })
            .collect();
        look(&json!({"lights": lights, "nodes": nodes, "wires": wires}))
    }

    fn value(&self, sample: &EvalSample) -> DVec4 {
        let (n, v) = (sample.normal.normalize(), sample.view.normalize());
        let mut stack = badf::premultiplied(self.base);
        for layer in &self.layers {
            let (own, light_color, intensity) = self.lights[layer.light];
            let l = sample.frame * own;
            let u = match layer.kind {
                "diffuse" => angle(n, l),
                "specular" => angle(mirrored(n, v), l),
                "screen_aligned" => angle(sample.camera * n, own),
                _ => angle(n, l + v),
            };
            let lambda = badf::lambda(sample.kappa, layer.slope);
            let rho = badf::alpha(u, badf::warp(lambda, layer.amount), layer.profile)
                * intensity.min(1.0);
            let color = lambda * layer.convex + (1.0 - lambda) * layer.concave;
            let lit = (color.truncate() * light_color * intensity.max(1.0)).extend(color.w);
            stack = badf::blend(layer.mode, stack, lit, rho, layer.opacity, layer.clamped);
        }
        badf::straight(stack)
    }
}

#[test]
fn stacks_of_light_layers() {
    let mut random = Random::new(30);
    let mut errors = Errors::new("whole looks: 1 to 6 light layers", 1e-5);
    for _ in 0..24 {
        let stack = Stack::random(&mut random);
        let look = stack.look();
        let samples: Vec<EvalSample> = (0..150)
            .map(|_| EvalSample {
                normal: held(random.direction()),
                view: held(random.direction()),
                kappa: f32_of(random.between(-8.0, 8.0)),
                frame: random.rotation(),
                camera: DMat3::from_quat(random.rotation()),
                ..EvalSample::default()
            })
            .collect();
        for (value, sample) in eval(&look, "", &samples).iter().zip(&samples) {
            let wanted = stack.value(sample);
            for (got, wanted) in value.iter().zip(wanted.to_array()) {
                errors.note(got / wanted.abs().max(1.0), wanted / wanted.abs().max(1.0), || {
                    format!("{sample:?}\n{}", look.look.to_text())
                });
            }
        }
    }
    errors.finish();
}

/// Distance and cone attenuation of a light by the formulas of docs and document: half at the half
/// distance, ended by a quartic window, smoothstep between the cosines of the cone.
fn faded(distance: f64, half: f64, range: f64) -> f64 {
    let fading = if half > 0.0 { 1.0 / (1.0 + (distance / half).powi(2)) } else { 1.0 };
    let window =
        if range > 0.0 { (1.0 - (distance / range).powi(4)).max(0.0).powi(2) } else { 1.0 };
    fading * window
}

fn lamp(kind: &str, space: &str) -> SetupLook {
    look(&json!({
        "lights": {"key": {
            "type": kind, "space": space, "position": [1.0, 2.0, 3.0], "aim": [-0.5, -0.6, -1.0],
            "direction": [1, 2, 3],
            "inner": 0.3, "outer": 0.9, "intensity": 1.75, "color": [0.2, 0.5, 0.9],
            "half_distance": 2.5, "range": 9.0
        }},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "parts", "kind": "light_parts"},
            {"id": "angle", "kind": "parametrization", "values": {"type": "screen_aligned"}},
            {"id": "tone", "kind": "profile"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "parts.light"},
            {"from": "light", "to": "angle.light"},
            {"from": "angle", "to": "tone.angle"},
            {"from": "parts.color", "to": "output.color"}
        ]
    }))
}

#[test]
fn lights_of_every_kind_in_every_space() {
    let unit = |v: [f64; 3]| DVec3::from(v).normalize();
    for kind in ["directional", "point", "spot"] {
        for space in ["illumination", "world", "camera"] {
            let look = lamp(kind, space);
            let mut random = Random::new(40);
            let samples: Vec<EvalSample> = (0..1200)
                .map(|_| EvalSample {
                    normal: held(random.direction()),
                    position: (random.direction() * random.between(0.0, 8.0))
                        .to_array()
                        .map(f32_of)
                        .into(),
                    frame: random.rotation(),
                    camera: DMat3::from_quat(random.rotation()),
                    ..EvalSample::default()
                })
                .collect();
            let all = |output| eval(&look, output, &samples);
            let (directions, intensities) = (all("parts.direction"), all("parts.intensity"));
            let (colors, screen) = (all("parts.color"), all("angle.angle"));
            let title = |what| format!("{kind} light in {space} space: {what}");
            let mut direction_errors = Errors::new(title("direction"), 1e-6);
            let mut intensity_errors = Errors::new(title("intensity"), 3e-6);
            let mut screen_errors = Errors::new(title("screen-aligned u"), 1e-6);
            for (index, sample) in samples.iter().enumerate() {
                let world_from_own = match space {
                    "illumination" => DMat3::from_quat(sample.frame),
                    "camera" => sample.camera.transpose(),
                    _ => DMat3::IDENTITY,
                };
                let to_light = world_from_own * DVec3::new(1.0, 2.0, 3.0) - sample.position;
                let (direction, mut intensity) = match kind {
                    "directional" => (world_from_own * unit([1.0, 2.0, 3.0]), 1.75),
                    _ => (to_light.normalize(), 1.75 * faded(to_light.length(), 2.5, 9.0)),
                };
                if kind == "spot" {
                    let away = angle(-direction, world_from_own * unit([-0.5, -0.6, -1.0])).cos();
                    let t =
                        ((away - 0.9_f64.cos()) / (0.3_f64.cos() - 0.9_f64.cos())).clamp(0.0, 1.0);
                    intensity *= t * t * (3.0 - 2.0 * t);
                }
                for axis in 0..3 {
                    direction_errors
                        .note(directions[index][axis], direction[axis], || format!("{sample:?}"));
                }
                intensity_errors.note(intensities[index][0], intensity, || format!("{sample:?}"));
                let own = world_from_own.transpose() * direction;
                screen_errors.note(
                    screen[index][0],
                    angle(sample.camera * sample.normal, own),
                    || format!("{sample:?}"),
                );
                assert_eq!(colors[index], [0.2, 0.5, 0.9, 1.0].map(f32_of));
            }
            [direction_errors, intensity_errors, screen_errors]
                .into_iter()
                .for_each(Errors::finish);
        }
    }
}

#[test]
fn lights_without_fading_and_with_hard_cones() {
    let mut json = json!({
        "lights": {
            "key": {
                "type": "spot", "position": [0, 0, 2], "aim": [0, 0, -3], "inner": 0.5, "outer": 0.5
            }
        },
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "parts", "kind": "light_parts"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "parts.light"}, {"from": "parts.color", "to": "output.color"}
        ]
    });
    let at = |x: f64| EvalSample { position: DVec3::new(x, 0.0, 0.0), ..EvalSample::default() };
    let edge = 2.0 * 0.5_f64.tan();
    let samples = [at(0.0), at(edge - 1e-3), at(edge + 1e-3), at(1e20), at(f64::NAN)];
    let values = eval(&look(&json), "parts.intensity", &samples);
    assert_eq!(values.iter().map(|v| v[0]).collect::<Vec<_>>()[..4], [1.0, 1.0, 0.0, 0.0]);
    json["lights"]["key"]["type"] = json!("point");
    for sample in [
        at(0.0),
        at(1e6),
        EvalSample { position: DVec3::new(0.0, 0.0, 2.0), ..EvalSample::default() },
    ] {
        let look = look(&json);
        let value = eval(&look, "parts.intensity", std::slice::from_ref(&sample))[0][0];
        assert_eq!(value, 1.0, "a light without fading fades at {:?}", sample.position);
        let direction = eval(&look, "parts.direction", &[sample])[0];
        assert!(direction.iter().all(|x| x.is_finite()), "{direction:?}");
    }
}

/// An intensity below 1 fades the tone; above 1 it brightens the color.
#[test]
fn intensity_fades_or_brightens() {
    let look = look(&json!({
        "lights": {"key": {"direction": [0, 0, 1], "color": [1.0, 0.5, 0.25]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {
                "id": "lit", "kind": "light_apply",
                "values": {"color": [0.2, 0.4, 0.8, 0.6], "tone": 0.5}
            },
            {"id": "base", "kind": "base"},
            {"id": "blend", "kind": "blend", "values": {"mode": "alpha"}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "lit.light"},
            {"from": "base", "to": "blend.below"},
            {"from": "lit.color", "to": "blend.color"},
            {"from": "lit.tone", "to": "blend.tone"},
            {"from": "blend", "to": "output.color"}
        ]
    }));
    let intensities = [0.0, 0.25, 1.0, 1.5, 4.0, -2.0];
    let samples = intensities.map(|intensity| EvalSample {
        lights: [(
            "key".into(),
            LightOverride { intensity: Some(intensity), ..LightOverride::default() },
        )]
        .into_iter()
        .collect(),
        ..EvalSample::default()
    });
    let mut errors = Errors::new("light_apply: intensity", 2e-7);
    let (colors, tones) = (eval(&look, "lit.color", &samples), eval(&look, "lit.tone", &samples));
    for ((intensity, color), tone) in intensities.into_iter().zip(&colors).zip(&tones) {
        let intensity: f64 = intensity.max(0.0);
        errors.note(tone[0], 0.5 * intensity.min(1.0), || format!("{intensity}"));
        let bright = intensity.max(1.0);
        for (got, wanted) in color.iter().zip([0.2 * bright, 0.2 * bright, 0.2 * bright, 0.6]) {
            errors.note(*got / bright, wanted / bright, || format!("{intensity}"));
        }
    }
    errors.finish();
}

/// A turn of the illumination frame turns all lights in it together, and nothing else.
#[test]
fn the_illumination_frame_turns_its_lights_together() {
    let stack = Stack::random(&mut Random::new(50));
    let mut look = stack.look();
    let mut random = Random::new(51);
    for light in look.look.lights.values_mut() {
        light.direction = random.direction().to_array();
    }
    for node in look.look.graph.nodes.values_mut().filter(|node| node.kind == "light_layer") {
        // Screen-aligned layers do not depend on the frame, so all layers get another type.
        node.values.insert(
            "type".into(),
            Value::Text((*random.pick(&["diffuse", "specular", "half_vector"])).to_owned()),
        );
    }
    // Turning frame, surface and eye together changes nothing; and turning the lights themselves
    // equals turning the frame.
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 1.1);
    let still: Vec<EvalSample> = (0..200)
        .map(|_| EvalSample {
            normal: random.direction(),
            view: random.direction(),
            kappa: 1.0,
            ..EvalSample::default()
        })
        .collect();
    let turned: Vec<EvalSample> = still
        .iter()
        .map(|s| EvalSample {
            normal: turn * s.normal,
            view: turn * s.view,
            frame: turn,
            ..s.clone()
        })
        .collect();
    let by_frame: Vec<EvalSample> =
        still.iter().map(|s| EvalSample { frame: turn, ..s.clone() }).collect();
    let by_hand: Vec<EvalSample> = still
        .iter()
        .map(|s| {
            let lights = look.look.lights.iter().map(|(id, light)| {
                let direction = Some(turn * DVec3::from(light.direction));
                (id.clone(), LightOverride { direction, ..LightOverride::default() })
            });
            EvalSample { lights: lights.collect(), ..s.clone() }
        })
        .collect();
    let all = |samples: &[EvalSample]| {
        eval_with(&look, chiaro::library::Library::built_in(), &options(""), samples)
    };
    let mut errors = Errors::new("illumination frame turned", 5e-6);
    for (a, b) in [(all(&still), all(&turned)), (all(&by_frame), all(&by_hand))] {
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            errors.note(*a, *b, String::new);
        }
    }
    errors.finish();
    assert_ne!(all(&still), all(&by_frame), "the frame turns nothing");
}
