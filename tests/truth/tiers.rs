//! Cheaper tiers state how far they may be from the exact tier, and stay within that.
//!
//! The truth is f64 from the formulas themselves; the exact tier in the f64 interpreter is a second
//! witness. Inputs that no formula has an answer for must still give finite numbers.
#![cfg(feature = "gpu")]

use std::f64::consts::{FRAC_PI_2, PI};

use crate::support::badf::{self, angle, f32_of, held, mirrored};
use crate::support::eval::{draw, eval, look, scene_of, shape};
use crate::support::random::Random;
use crate::support::report::Errors;
use chiaro::compile::CompileOptions;
use chiaro::compile::Live;
use chiaro::document::{Scene, Tier, Value, Values};
use chiaro::frame::{EvalSample, LightOverride, PlanOptions, Planner, SetupLook};
use chiaro::interp::{Precision, Scalar, Value as Number};
use chiaro::library::{ArgumentSource, Library, NodeDef, NodeFunction, Type};
use glam::{DMat3, DVec3};
use serde_json::{Value as Json, json};

const CHEAPER: [(Tier, &str); 2] = [(Tier::Balanced, "balanced"), (Tier::Fast, "fast")];

fn node(kind: &str) -> &'static NodeDef {
    &Library::built_in().nodes[kind]
}

/// The error that a node's file states for a tier; where the tier does not exist, for the next
/// better one, which runs in its place.
fn stated(kind: &str, tier: Tier) -> f64 {
    let stated =
        node(kind).errors.iter().filter(|error| error.tier <= tier).max_by_key(|error| error.tier);
    stated.map_or(0.0, |error| error.bound)
}

fn numbers(values: &[(&str, f64)]) -> Values {
    values.iter().map(|(name, x)| ((*name).into(), Value::Number(*x))).collect()
}

fn toward(direction: DVec3) -> indexmap::IndexMap<chiaro::ids::LightId, LightOverride> {
    [("key".into(), LightOverride { direction: Some(direction), ..LightOverride::default() })]
        .into_iter()
        .collect()
}

#[test]
fn every_cheaper_tier_states_its_error() {
    let mut count = 0;
    for def in Library::built_in().nodes.values() {
        for tier in def.tiers().into_iter().filter(|tier| *tier != Tier::Exact) {
            assert!(def.error_of(tier).is_some(), "{} states no error of {tier:?}", def.kind);
            count += 1;
        }
        // A tier exists for every choice of the exact tier, or a choice would make a look dearer.
        for tier in def.tiers() {
            let choices =
                |tier| def.variants.iter().filter(move |v: &&NodeFunction| v.tier == tier).count();
            let count = choices(tier);
            assert!(
                count == 0 || count == choices(Tier::Exact),
                "{} has not every choice in {tier:?}",
                def.kind
            );
        }
    }
    assert!(count >= 10, "{count}");
}

#[test]
fn a_tier_goes_from_the_look_to_groups_to_nodes() {
    let shown = |look_tier: &str, group: Json, inner: Json| {
        let mut within = json!({"id": "curved", "kind": "transition", "values": {"slope": 0.4}});
        if !inner.is_null() {
            within["tier"] = inner;
        }
        let mut outer = json!({"id": "group", "kind": "pack"});
        if !group.is_null() {
            outer["tier"] = group;
        }
        let look = look(&json!({
            "tier": look_tier,
            "definitions": {"pack": {
                "outputs": [{"name": "value"}],
                "nodes": [within],
                "wires": [{"from": "curved", "to": "outputs.value"}]
            }},
            "nodes": [outer, {"id": "output", "kind": "output"}],
            "wires": [{"from": "group", "to": "output.color"}]
        }));
        // As written, functions keep their names.
        let options = CompileOptions { unspecialized: true, ..CompileOptions::default() };
        let shader = chiaro::compile::compile(&look.look, Library::built_in(), &options)
            .expect("flawless")
            .value;
        let functions = ["transition_fast(", "transition_balanced(", "transition("];
        functions
            .iter()
            .position(|function| shader.wgsl.contains(&format!("fn {function}")))
            .expect("one of them")
    };
    let (fast, balanced, exact) = (0, 1, 2);
    assert_eq!(shown("exact", Json::Null, Json::Null), exact);
    assert_eq!(shown("fast", Json::Null, Json::Null), fast);
    assert_eq!(shown("fast", json!("exact"), Json::Null), exact);
    assert_eq!(shown("exact", json!("balanced"), Json::Null), balanced);
    assert_eq!(shown("exact", json!("balanced"), json!("fast")), fast);
    assert_eq!(shown("fast", json!("fast"), json!("exact")), exact);
}

// Angles and profiles

const TYPES: [&str; 4] = ["diffuse", "specular", "screen_aligned", "half_vector"];

fn angle_look(kind: &str, tier: &str) -> SetupLook {
    let exposed = ["offset", "falloff", "cutoff", "shift"]
        .map(|name| json!({"name": name, "target": format!("tone.{name}")}));
    look(&json!({
        "tier": tier,
        "lights": {"key": {"direction": [0, 0, 1]}},
        "exposed": exposed,
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
    }))
}

#[test]
fn angles_in_every_tier() {
    for (tier, word) in CHEAPER {
        for (seed, kind) in TYPES.iter().enumerate() {
            let mut random = Random::new(100 + seed as u64);
            let (mut samples, mut wanted) = (Vec::new(), Vec::new());
            for round in 0..6000 {
                let (n, v) = (held(random.direction()), held(random.direction()));
                let camera = DMat3::from_quat(random.rotation());
                let mut l = random.direction();
                if round % 3 == 0 {
                    let near = match *kind {
                        "diffuse" => n,
                        "specular" => mirrored(n, v),
                        "screen_aligned" => camera * n,
                        _ => mirrored(v, n),
                    };
                    let apart = 10_f64.powf(random.between(-7.0, -1.0));
                    l = (near + apart * random.direction())
                        * if random.chance(0.3) { -1.0 } else { 1.0 };
                }
                let l = l.normalize();
                // Where light and eye are opposite, rounding alone decides the half-vector's
                // direction.
                if *kind == "half_vector" && (l + v).length() < 0.5 {
                    continue;
                }
                wanted.push(match *kind {
                    "diffuse" => angle(n, l),
                    "specular" => angle(mirrored(n, v), l),
                    "screen_aligned" => angle(camera * n, l),
                    _ => angle(n, l + v),
                });
                samples.push(EvalSample {
                    normal: n,
                    view: v,
                    camera,
                    lights: toward(l),
                    ..EvalSample::default()
                });
            }
            let mut errors =
                Errors::new(format!("angle u, {kind}, {word}"), stated("parametrization", tier));
            for ((value, u), sample) in eval(&angle_look(kind, word), "angle.angle", &samples)
                .iter()
                .zip(&wanted)
                .zip(&samples)
            {
                errors.note(value[0], *u, || format!("{sample:?}"));
            }
            errors.finish();
        }
    }
}

/// Random angles, warps and parameters, mostly where alpha is neither 0 nor 1, with fall-offs of
/// `least` to `most` radians from the offset.
fn profile_cases(seed: u64, least: f64, most: f64) -> Vec<(f64, f64, [f64; 3])> {
    let mut random = Random::new(seed);
    let mut cases = Vec::new();
    for _ in 0..12_000 {
        let f = least * (most / least).powf(random.unit());
        let c = random.between(f, PI);
        let tau = if random.chance(0.4) { 0.0 } else { random.between(0.0, PI - c) };
        let shift = if random.chance(0.4) { 0.0 } else { f32_of(random.between(-PI, PI)) };
        let u = if random.chance(0.2) {
            random.between(0.0, PI)
        } else {
            tau + shift + f * random.between(-0.1, 3.0)
        };
        if (0.0..=PI).contains(&u) {
            cases.push((u, shift, [tau, tau + f, (tau + c).min(PI)]));
        }
    }
    cases
}

#[test]
fn profiles_in_every_tier() {
    for (tier, word) in CHEAPER {
        // Only the profile runs in the cheaper tier; the angle is as exact as it can be.
        let mut of_tier = angle_look("diffuse", "exact");
        of_tier.look.graph.nodes["tone"].tier = Some(tier);
        for (least, share) in [(0.2, 0.2), (0.05, 1.0)] {
            let cases = profile_cases(7, least, 1.5);
            let at =
                |u: f64| DVec3::new(f32_of(u.sin() * 0.6), f32_of(u.sin() * 0.8), f32_of(u.cos()));
            let samples: Vec<EvalSample> = cases
                .iter()
                .map(|&(u, shift, [offset, falloff, cutoff])| {
                    let values = numbers(&[
                        ("offset", offset),
                        ("falloff", falloff),
                        ("cutoff", cutoff),
                        ("shift", shift),
                    ]);
                    EvalSample { normal: at(u), values, ..EvalSample::default() }
                })
                .collect();
            let mut errors = Errors::new(
                format!("alpha, f' from {least}, {word}"),
                share * stated("profile", tier),
            );
            let mut steepest =
                Errors::new(format!("alpha, f' from {least}, {word}, infinitely steep"), 2e-3);
            for ((value, (u, shift, p)), sample) in
                eval(&of_tier, "tone.tone", &samples).iter().zip(&cases).zip(&samples)
            {
                let u = angle(sample.normal, DVec3::Z).max(0.0 * u);
                let [tau, f, c] = badf::sanitized(*p);
                let x = (u - shift).clamp(0.0, PI) - tau;
                let base = 1.0 - ((0.5 * x).sin() / (0.5 * (c - tau)).sin()).powi(2);
                let errors = if f - tau > FRAC_PI_2 - 0.1 && base < 1e-3 {
                    &mut steepest
                } else {
                    &mut errors
                };
                errors.note(value[0], badf::alpha(u, *shift, *p), || {
                    format!("u {u} shift {shift} {p:?}")
                });
            }
            errors.finish();
            if steepest.has_any() {
                steepest.finish();
            }
        }
    }
}

/// A narrow profile in a cheaper tier stays between 0 and 1, and is right where the tone is flat.
#[test]
fn narrow_profiles_in_every_tier() {
    for (tier, word) in [(Tier::Exact, "exact")].into_iter().chain(CHEAPER) {
        let mut of_tier = angle_look("diffuse", "exact");
        of_tier.look.graph.nodes["tone"].tier = Some(tier);
        let mut samples = Vec::new();
        let mut wanted = Vec::new();
        for f in [0.0, 1e-38, 1e-12, 1e-6, 3e-4, 1e-3, 0.01, PI] {
            for c in [f, 1e-4, 0.5, FRAC_PI_2, PI, 1e30] {
                for tau in [0.0, 1e-4, 1.0, 3.1, PI, -1.0] {
                    for shift in [0.0, 1e-7, -0.5, PI, -PI, 1e30, -1e30] {
                        for u in [0.0, 1e-7, 3e-4, 0.2, 1.2, 2.9, PI] {
                            let p = [tau, tau + f, tau + c];
                            let values = numbers(&[
                                ("offset", p[0]),
                                ("falloff", p[1]),
                                ("cutoff", p[2]),
                                ("shift", shift),
                            ]);
                            let normal = DVec3::new(f32_of(f64::sin(u)), 0.0, f32_of(f64::cos(u)));
                            let u = angle(normal, DVec3::Z);
                            samples.push(EvalSample { normal, values, ..EvalSample::default() });
                            let [low, high] = [-2e-5, 2e-5].map(|d| badf::alpha(u + d, shift, p));
                            wanted.push((low.max(high), low.min(high), badf::alpha(u, shift, p)));
                        }
                    }
                }
            }
        }
        for ((value, (high, low, at)), sample) in
            eval(&of_tier, "tone.tone", &samples).iter().zip(wanted).zip(&samples)
        {
            let told = || format!("{word}: {} for {at} in [{low}, {high}] at {sample:?}", value[0]);
            assert!(
                value[0] >= low.min(at) - 2e-3 && value[0] <= high.max(at) + 2e-3,
                "{}",
                told()
            );
        }
    }
}

// Curvature

#[test]
fn transitions_in_every_tier() {
    let mut random = Random::new(15);
    let mut samples = Vec::new();
    let special =
        [0.0, -0.0, 1e-45, 1e-38, 1e-7, 0.0625, 1.0, 50.0, 1e4, 1e30, f64::INFINITY, f64::NAN];
    for kappa in special {
        for slope in special.into_iter().filter(|slope| slope.is_finite()) {
            for (a, b) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)] {
                samples.push((a * kappa, b * slope));
            }
        }
    }
    for _ in 0..8000 {
        let a =
            10_f64.powf(random.between(-5.0, 2.0)) * if random.chance(0.5) { -1.0 } else { 1.0 };
        let slope = 10_f64.powf(random.between(-4.0, 1.0));
        samples.push((f32_of(a / slope), f32_of(slope)));
    }
    for (tier, word) in CHEAPER {
        let of_tier = look(&json!({
            "tier": word,
            "exposed": [{"name": "slope", "target": "convexity.slope"}],
            "nodes": [
                {"id": "convexity", "kind": "transition"}, {"id": "output", "kind": "output"}
            ],
            "wires": [{"from": "convexity", "to": "output.color"}]
        }));
        let at = |&(kappa, slope): &(f64, f64)| EvalSample {
            kappa,
            values: numbers(&[("slope", slope)]),
            ..EvalSample::default()
        };
        let at: Vec<EvalSample> = samples.iter().map(at).collect();
        let mut errors = Errors::new(format!("convexity, {word}"), stated("transition", tier));
        let program = node("transition").module.program("transition").expect("it compiles");
        for (value, (kappa, slope)) in
            eval(&of_tier, "convexity.convexity", &at).iter().zip(&samples)
        {
            let wanted = badf::lambda(*kappa, f32_of(*slope));
            errors.note(value[0], wanted, || format!("kappa {kappa} slope {slope}"));
            let witness = program
                .call(&[Number::Float(*kappa), Number::Float(f32_of(*slope))], Precision::F64);
            let witness = witness.ok().and_then(|value| value.as_f64()).expect("a number");
            assert!((witness - wanted).abs() < 2e-7, "{witness} for {wanted} at {kappa}, {slope}");
        }
        errors.finish();
    }
}

/// A look whose readers of curvature are all fast needs no pass; a single exact reader keeps the
/// pass for itself alone.
#[test]
fn fast_curvature_needs_no_pass() {
    let (mesh, matrix) = shape("creature");
    let mut shown = Vec::new();
    for (first, second, wanted) in
        [("fast", "fast", 1), ("fast", "exact", 3), ("exact", "exact", 3)]
    {
        let json = json!({
            "nodes": [
                {"id": "first", "kind": "transition", "tier": first},
                {"id": "second", "kind": "transition", "tier": second},
                {"id": "sum", "kind": "add"},
                {"id": "output", "kind": "output"}
            ],
            "wires": [
                {"from": "first", "to": "sum.a"}, {"from": "second", "to": "sum.b"},
                {"from": "sum", "to": "output.color"}
            ]
        });
        let setup = scene_of(vec![(look(&json), mesh.clone(), matrix)], Scene::default());
        let options = PlanOptions { size: [200, 160], samples: 4, time: 0.0 };
        let plan = Planner::default()
            .plan(&setup, Library::built_in(), &Live::Keyed, &options)
            .expect("a plan")
            .value;
        assert_eq!(plan.passes.len(), wanted, "{first} and {second}: {:?}", plan.passes);
        let source = &plan.draws[0].look.wgsl;
        assert_eq!(source.contains("dpdx"), first == "fast", "{source}");
        assert_eq!(source.contains("curvature_map"), second == "exact", "{source}");
        shown.push(draw(&setup, Library::built_in(), &Live::Keyed, [200, 160], 4));
    }
    // In perspective, on a body with creases, both pictures are alike in the mean, and finite
    // everywhere.
    let [fast, _, exact] = &shown[..] else { panic!("three pictures") };
    let mut differences = Vec::new();
    for (fast, exact) in fast.rgba.iter().zip(&exact.rgba).filter(|pixel| pixel.1[3] == 1.0) {
        assert!(fast.iter().all(|c| c.is_finite()), "{fast:?}");
        differences.push(f64::from(fast[0] - exact[0]).abs());
    }
    let mean = differences.iter().sum::<f64>() / differences.len() as f64;
    assert!(differences.len() > 1000 && mean < 0.1, "{mean} over {}", differences.len());
}

// Thresholds

/// A threshold without softness is hard and inclusive in every tier where nothing changes on the
/// screen.
#[test]
fn thresholds_are_the_same_without_a_screen() {
    let values =
        [-3e38, -1.0, -1e-38, 0.0, 0.2499999, 0.25, 0.3, 0.5, 0.7499999, 0.75, 1.0, 2.0, 3e38];
    for (tier, word) in [(Tier::Exact, "exact")].into_iter().chain(CHEAPER) {
        for softness in [0.0, 0.1, 1.0, 3e38] {
            let cut = look(&json!({
                "tier": word,
                "exposed": [
                    {"name": "value", "target": "cut.value"},
                    {"name": "tone", "target": "cel.value"}
                ],
                "nodes": [
                    {
                        "id": "cut", "kind": "threshold",
                        "values": {"edge": 0.25, "softness": softness}
                    },
                    {
                        "id": "cel", "kind": "bands",
                        "values": {"count": 4, "softness": f64::min(softness, 1.0)}
                    },
                    {"id": "sum", "kind": "add"},
                    {"id": "output", "kind": "output"}
                ],
                "wires": [
                    {"from": "cut", "to": "sum.a"}, {"from": "cel", "to": "sum.b"},
                    {"from": "sum", "to": "output.color"}
                ]
            }));
            let at = |&x: &f64| EvalSample {
                values: numbers(&[("value", x), ("tone", x)]),
                ..EvalSample::default()
            };
            let samples: Vec<EvalSample> = values.iter().map(at).collect();
            let (masks, tones) =
                (eval(&cut, "cut.mask", &samples), eval(&cut, "cel.tone", &samples));
            for ((x, mask), tone) in values.iter().map(|x| f32_of(*x)).zip(&masks).zip(&tones) {
                let told =
                    || format!("{tier:?}, {x}, softness {softness}: {} and {}", mask[0], tone[0]);
                let wide = f64::min(softness, 1e15);
                let hard = f64::from(u8::from(x >= 0.25));
                let wanted =
                    if softness == 0.0 { hard } else { (0.5 + (x - 0.25) / wide).clamp(0.0, 1.0) };
                assert!((mask[0] - wanted).abs() < 1e-6, "mask of {}", told());
                let stairs = (4.0 * x.clamp(0.0, 1.0)).floor().min(3.0);
                let soft = f64::min(softness, 1.0);
                let edge = (4.0 * x.clamp(0.0, 1.0)).round().clamp(1.0, 3.0);
                let wanted = match soft {
                    0.0 => stairs / 3.0,
                    w => {
                        (edge - 1.0 + (0.5 + (4.0 * x.clamp(0.0, 1.0) - edge) / w).clamp(0.0, 1.0))
                            / 3.0
                    }
                };
                assert!((tone[0] - wanted).abs() < 1e-6, "tone of {}: {wanted}", told());
            }
        }
    }
}

// Vectors

#[test]
fn vectors_in_every_tier() {
    for (tier, word) in CHEAPER {
        let looks = ["facing", "mirrored_view", "camera_normal"].map(|kind| {
            let json = json!({
                "tier": word,
                "exposed": [{"name": "vector", "target": "wired.vector"}],
                "nodes": [
                    {"id": "wired", "kind": "vector_value"}, {"id": "node", "kind": kind},
                    {"id": "output", "kind": "output"}
                ],
                "wires": [
                    {"from": "wired", "to": "node.normal"}, {"from": "node", "to": "output.color"}
                ]
            });
            (kind, look(&json))
        });
        let mut random = Random::new(31);
        let samples: Vec<(EvalSample, DVec3)> = (0..4000)
            .map(|_| {
                let length = 10_f64.powf(random.between(-14.0, 17.0));
                let n = (length * random.direction()).to_array().map(f32_of);
                let camera = DMat3::from_quat(random.rotation());
                let values = [("vector".into(), Value::Vector(n.to_vec()))].into_iter().collect();
                (
                    EvalSample {
                        view: held(random.direction()),
                        camera,
                        values,
                        ..EvalSample::default()
                    },
                    n.into(),
                )
            })
            .collect();
        for (kind, of_tier) in &looks {
            let mut errors = Errors::new(format!("{kind}, {word}"), stated(kind, tier));
            let at: Vec<EvalSample> = samples.iter().map(|sample| sample.0.clone()).collect();
            for (value, (sample, n)) in eval(of_tier, "node", &at).iter().zip(&samples) {
                let n = n.normalize();
                let wanted = match *kind {
                    "facing" => DVec3::new(n.dot(sample.view.normalize()).max(0.0), 0.0, 0.0),
                    "mirrored_view" => mirrored(n, sample.view),
                    _ => sample.camera * n,
                };
                for (got, wanted) in value.iter().zip(wanted.to_array()) {
                    errors.note(*got, wanted, || format!("{sample:?}"));
                }
            }
            errors.finish();
        }
    }
}

// Noise

#[test]
fn noises_in_every_tier() {
    let module = &node("noise").module;
    let mut random = Random::new(41);
    for kind in ["value", "perlin", "simplex", "worley"] {
        let mut errors = Errors::new(format!("noise {kind}, fast"), stated("noise", Tier::Fast));
        for octaves in [1, 2, 3, 4, 5, 6, 8] {
            for roughness in [0.0, 0.2, 0.3, 0.5, 0.6, 0.8, 1.0] {
                let of_tier = look(&json!({
                    "tier": "fast",
                    "nodes": [
                        {"id": "node", "kind": "noise",
                         "values": {
                             "kind": kind, "scale": 2, "octaves": octaves, "roughness": roughness
                         }},
                        {"id": "output", "kind": "output"}
                    ],
                    "wires": [{"from": "node", "to": "output.color"}]
                }));
                let place = |random: &mut Random| random.direction() * random.between(0.0, 9.0);
                let samples: Vec<EvalSample> = (0..200)
                    .map(|_| EvalSample { position: place(&mut random), ..EvalSample::default() })
                    .collect();
                let program = module.program(&format!("noise_{kind}")).expect("it compiles");
                for (value, sample) in eval(&of_tier, "node", &samples).iter().zip(&samples) {
                    let p = sample.position.to_array().map(f32_of);
                    let arguments = [
                        Number::vec(&p),
                        Number::Float(2.0),
                        Number::I32(octaves),
                        Number::Float(f32_of(roughness)),
                        Number::I32(0),
                    ];
                    let exact = program
                        .call(&arguments, Precision::F64)
                        .ok()
                        .and_then(|x| x.as_f64())
                        .expect("a number");
                    errors.note(value[0], exact, || {
                        format!("{octaves} octaves, roughness {roughness}, {sample:?}")
                    });
                    if octaves <= 3 && roughness == 0.5 {
                        assert!((value[0] - exact).abs() < 1e-5, "no octave is left out");
                    }
                }
            }
        }
        errors.finish();
    }
}

// Every input

/// Numbers at which arithmetic often fails.
const WILD: [f64; 14] = [
    0.0,
    -0.0,
    1e-45,
    1.17549435e-38,
    1e-7,
    0.5,
    1.0,
    -1.0,
    PI,
    1e10,
    -3.4028234663852886e38,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

fn wild_number(random: &mut Random) -> f64 {
    if random.chance(0.6) { *random.pick(&WILD) } else { random.between(-4.0, 4.0) }
}

/// A wild value of a type; angles and lights are as a Parametrization or a Light gives them.
fn wild(ty: &Type, random: &mut Random) -> Option<Number> {
    let vector = |count: usize, random: &mut Random| {
        Number::Vector((0..count).map(|_| Scalar::Float(wild_number(random))).collect())
    };
    Some(match ty {
        Type::Float => Number::Float(wild_number(random)),
        Type::Int => Number::I32(*random.pick(&[0, 1, -1, 3, 64, i32::MAX, i32::MIN])),
        Type::Bool => Number::Bool(random.chance(0.5)),
        Type::Vec2 => vector(2, random),
        Type::Vec3 => vector(3, random),
        Type::Vec4 | Type::Color | Type::Composite => vector(4, random),
        Type::Angle => {
            let u = *random.pick(&[0.0, 1e-30, 1e-6, 0.3, FRAC_PI_2, PI - 1e-6, PI]);
            Number::Struct(vec![Number::Float((0.5 * u).sin()), Number::Float((0.5 * u).cos())])
        }
        Type::Light => {
            let direction = Number::vec(&random.direction().to_array());
            Number::Struct(vec![
                direction.clone(),
                direction,
                vector(3, random),
                Number::Float(wild_number(random)),
            ])
        }
        Type::Mat3 => {
            let rotation = DMat3::from_quat(random.rotation());
            Number::matrix(&rotation.to_cols_array_2d())
        }
        _ => return None,
    })
}

fn is_finite(value: &Number) -> bool {
    match value {
        Number::Float(x) => x.is_finite(),
        Number::Vector(parts) => parts.iter().all(|part| part.as_f64().is_finite()),
        Number::Matrix { components, .. } => components.iter().all(|x| x.is_finite()),
        Number::Array(parts) | Number::Struct(parts) => parts.iter().all(is_finite),
        _ => true,
    }
}

/// Cheaper tiers of every node give finite numbers for any inputs.
#[test]
fn every_tier_is_total() {
    let mut random = Random::new(51);
    let mut ran = 0;
    for def in Library::built_in().nodes.values() {
        for variant in def.variants.iter().filter(|variant| variant.tier != Tier::Exact) {
            let Ok(program) = def.module.program(&variant.function) else { continue };
            for _ in 0..3000 {
                let mut inputs: Vec<Option<Number>> =
                    def.inputs.iter().map(|input| wild(&input.ty, &mut random)).collect();
                // Directions from the surface context are unit vectors.
                for (input, value) in def.inputs.iter().zip(&mut inputs) {
                    if input.hidden && input.ty == Type::Vec3 {
                        *value = Some(Number::vec(&random.direction().to_array()));
                    }
                }
                let is_prepared = variant.parameters.contains(&ArgumentSource::Prepared);
                let prepared = def.prepare.as_ref().filter(|_| is_prepared).map(|prepare| {
                    let arguments: Vec<Number> = prepare
                        .parameters
                        .iter()
                        .filter_map(|(index, _)| inputs[*index].clone())
                        .collect();
                    let program = def.module.program(&prepare.function).expect("it compiles");
                    program.call(&arguments, Precision::F32).expect("it runs")
                });
                let arguments: Option<Vec<Number>> = variant
                    .parameters
                    .iter()
                    .map(|parameter| match parameter {
                        ArgumentSource::Input(index, ty) if *ty == def.inputs[*index].ty => {
                            inputs[*index].clone()
                        }
                        ArgumentSource::Prepared => prepared.clone(),
                        _ => None,
                    })
                    .collect();
                let Some(arguments) = arguments else { break };
                let value = program.call(&arguments, Precision::F32).expect("it runs");
                assert!(is_finite(&value), "{}{arguments:?} = {value:?}", variant.function);
                ran += 1;
            }
        }
    }
    assert!(ran > 30_000, "{ran}");
}
