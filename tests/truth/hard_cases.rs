//! Hard cases of the BADF model, at each of which a straightforward implementation gives NaN,
//! sparkle or the wrong picture. All run on the GPU; those that are one function also run through
//! the interpreter in f64 and f32.
#![cfg(feature = "gpu")]

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, PI};

use crate::support::badf::{self, alpha, angle, f32_of, held};
use crate::support::eval::{draw, eval, look, scene_of, truth};
use crate::support::random::Random;
use chiaro::compile::Live;
use chiaro::document::{Camera, Projection, Scene, Tier, Value};
use chiaro::frame::{EvalSample, SetupLook};
use chiaro::geometry::{Mesh, MeshPart};
use chiaro::interp::{Precision, Value as Number};
use chiaro::library::Library;
use chiaro::render::Picture;
use glam::{DMat4, DVec2, DVec3, DVec4};
use serde_json::{Value as Json, json};

/// Calls a function of the library, on the CPU.
fn call(function: &str, arguments: &[Number], precision: Precision) -> Number {
    let module = &Library::built_in().nodes["profile"].module;
    let program = module.program(function).unwrap_or_else(|problem| panic!("{problem}"));
    program.call(arguments, precision).unwrap_or_else(|problem| panic!("{function}: {problem}"))
}

fn number(x: f64) -> Number {
    Number::Float(x)
}

/// The angle u and alpha by the library's functions, in f64 or f32.
fn interpreted(
    n: DVec3,
    l: DVec3,
    shift: f64,
    [tau, f, c]: [f64; 3],
    precision: Precision,
) -> (f64, f64) {
    let of = |v: DVec3| Number::vec(&v.to_array());
    let n = call("normalize_or", &[of(n), of(DVec3::Z)], precision);
    let u = call("angle_between", &[n, of(l)], precision);
    let shape = call("profile_shape", &[number(tau), number(f), number(c)], precision);
    let warped = call("angle_shifted", &[u.clone(), number(shift)], precision);
    let alpha = call("profile_point", &[warped, shape], precision).as_f64().expect("a number");
    (call("angle_radians", &[u], precision).as_f64().expect("a number"), alpha)
}

/// Inputs of alpha, with the wanted value and its tolerance.
struct Case {
    normal: DVec3,
    light: DVec3,
    shift: f64,
    profile: [f64; 3],
    wanted: f64,
    tolerance: f64,
}

impl Case {
    fn at(u: f64, profile: [f64; 3], wanted: f64, tolerance: f64) -> Self {
        let normal = DVec3::new(f32_of(u.sin()), 0.0, f32_of(u.cos()));
        Self { normal, light: DVec3::Z, shift: 0.0, profile, wanted, tolerance }
    }
}

/// A look that shows the tone of a directional light at +z with parameters that each sample sets;
/// the normal is wired as it is, of any length.
fn profile_look() -> SetupLook {
    let exposed = ["normal.vector", "tone.offset", "tone.falloff", "tone.cutoff", "tone.shift"]
        .map(|target| json!({"name": target.split('.').next_back(), "target": target}));
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "exposed": exposed,
        "nodes": [
            {"id": "normal", "kind": "vector_value"},
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "angle", "kind": "parametrization"},
            {"id": "tone", "kind": "profile"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "normal", "to": "angle.normal"},
            {"from": "light", "to": "angle.light"},
            {"from": "angle", "to": "tone.angle"},
            {"from": "tone", "to": "output.color"}
        ]
    }))
}

fn sample_of(case: &Case) -> EvalSample {
    let [offset, falloff, cutoff] = case.profile;
    let light = chiaro::frame::LightOverride { direction: Some(case.light), ..Default::default() };
    let numbers =
        [("offset", offset), ("falloff", falloff), ("cutoff", cutoff), ("shift", case.shift)];
    let mut values: chiaro::document::Values =
        numbers.into_iter().map(|(name, x)| (name.into(), Value::Number(x))).collect();
    values.insert("vector".into(), Value::Vector(case.normal.to_array().to_vec()));
    EvalSample {
        values,
        lights: [("key".into(), light)].into_iter().collect(),
        ..EvalSample::default()
    }
}

/// Each tier with the error of the tone that it may have beyond the exact tier's, for profiles as
/// narrow as in these cases.
const TIERS: [(Tier, f64); 3] = [(Tier::Exact, 0.0), (Tier::Balanced, 2e-5), (Tier::Fast, 1e-4)];

/// Compares alpha with the wanted values, on the GPU in every tier and in the interpreter; gives
/// the GPU's exact angles.
fn check(cases: &[Case]) -> Vec<f64> {
    let samples: Vec<EvalSample> = cases.iter().map(sample_of).collect();
    let look = profile_look();
    for (tier, more) in TIERS {
        let mut of_tier = profile_look();
        of_tier.look.tier = Some(tier);
        for (case, tone) in cases.iter().zip(eval(&of_tier, "tone.tone", &samples)) {
            let told = || {
                format!("n {} l {} T {} {:?}", case.normal, case.light, case.shift, case.profile)
            };
            // A warp turns the angle, and the steeper the profile is, the more the warp's error
            // shows.
            let [tau, f, _] = badf::sanitized(case.profile);
            let turned = if case.shift == 0.0 || f <= tau { 0.0 } else { 0.05 * more / (f - tau) };
            if tier != Tier::Exact && !(1e-15..1e18).contains(&case.normal.length()) {
                // Cheaper tiers state that they find no direction at such lengths.
                assert!((0.0..=1.0).contains(&tone[0]), "GPU, {tier:?}: {} at {}", tone[0], told());
                continue;
            }
            let error = (tone[0] - case.wanted).abs();
            let bound = case.tolerance + more + turned;
            assert!(error <= bound, "GPU, {tier:?}: {} for {} at {}", tone[0], case.wanted, told());
        }
    }
    for (case, tone) in cases.iter().zip(truth(&look, "tone.tone", &samples)) {
        let error = (tone[0] - case.wanted).abs();
        let told =
            || format!("n {} l {} T {} {:?}", case.normal, case.light, case.shift, case.profile);
        // The library's series end at f32's precision, also in f64.
        assert!(
            error <= case.tolerance + 1e-8,
            "whole look in f64: {} for {} at {}",
            tone[0],
            case.wanted,
            told()
        );
    }
    for case in cases {
        let told =
            || format!("n {} l {} T {} {:?}", case.normal, case.light, case.shift, case.profile);
        let close = |got: f64| (got - case.wanted).abs() <= case.tolerance;
        for precision in [Precision::F64, Precision::F32] {
            let (_, got) =
                interpreted(case.normal, case.light, case.shift, case.profile, precision);
            assert!(close(got), "{precision:?}: {got} for {} at {}", case.wanted, told());
        }
    }
    eval(&look, "angle.angle", &samples).iter().map(|value| value[0]).collect()
}

const LAMBERT: [f64; 3] = [0.0, FRAC_PI_2, FRAC_PI_2];

#[test]
fn case_01_a_dot_product_above_one() {
    // Unit vectors whose dot product with themselves exceeds 1 in f32.
    let mut random = Random::new(1);
    let mut cases = Vec::new();
    while cases.len() < 200 {
        let n = held(random.direction());
        let [x, y, z] = n.to_array().map(|x| x as f32);
        if x * x + y * y + z * z > 1.0 {
            cases.push(Case {
                normal: n,
                light: n,
                shift: 0.0,
                profile: LAMBERT,
                wanted: 1.0,
                tolerance: 2e-7,
            });
        }
    }
    assert!(check(&cases).into_iter().all(|u| u <= 3e-7));
    // Equal normals without a rounding between them make an angle of exactly 0.
    let n = Number::vec(&cases[0].normal.to_array());
    let u = call("angle_between", &[n.clone(), n], Precision::F32);
    assert_eq!(call("angle_radians", &[u], Precision::F32), number(0.0));
}

#[test]
fn case_02_directions_that_nearly_agree() {
    let profile = [0.0, 1e-3, FRAC_PI_2];
    let mut random = Random::new(2);
    let mut cases = Vec::new();
    for _ in 0..500 {
        let n = held(random.direction());
        let l = held(n + 1e-4 * n.cross(random.direction()).normalize());
        let wanted = alpha(angle(n, l), 0.0, profile);
        cases.push(Case { normal: n, light: l, shift: 0.0, profile, wanted, tolerance: 2e-5 });
    }
    for (u, case) in check(&cases).into_iter().zip(&cases) {
        assert!((u - angle(case.normal, case.light)).abs() < 2e-7, "{u}");
    }
}

#[test]
fn case_03_opposite_directions() {
    let mut random = Random::new(3);
    let profile = [0.0, FRAC_PI_2, PI];
    let opposite =
        |n| Case { normal: n, light: -n, shift: 0.0, profile, wanted: 0.0, tolerance: 1e-12 };
    let cases: Vec<Case> = (0..200).map(|_| opposite(held(random.direction()))).collect();
    assert!(check(&cases).into_iter().all(|u| (u - PI).abs() < 3e-7));
}

#[test]
fn case_04_interpolated_normals_are_short() {
    let mut random = Random::new(4);
    let short = |n: DVec3| Case {
        normal: 0.95 * n,
        light: n,
        shift: 0.0,
        profile: LAMBERT,
        wanted: 1.0,
        tolerance: 2e-7,
    };
    let cases: Vec<Case> = (0..200).map(|_| short(random.direction())).collect();
    assert!(check(&cases).into_iter().all(|u| u <= 5e-7));
    // Long, tiny and huge normals.
    for length in [1e-20, 3.0, 1e20] {
        let long = |n: DVec3| Case { normal: length * n, ..short(n) };
        assert!(check(&[long(random.direction())])[0] <= 5e-7, "{length}");
    }
}

#[test]
fn case_05_a_step_is_inclusive() {
    let step = [1.0, 1.0, 1.0];
    check(&[
        Case::at(0.999, step, 1.0, 0.0),
        Case::at(1.0, step, 1.0, 0.0),
        Case::at(1.001, step, 0.0, 0.0),
    ]);
    // The very edge of the step in every direction, where each direction rounds in its own way.
    let mut random = Random::new(5);
    let cases: Vec<Case> = (0..500)
        .map(|_| {
            let l = held(random.direction());
            let aside = l.cross(random.direction()).normalize();
            let normal = held(1.0_f64.cos() * l + 1.0_f64.sin() * aside);
            Case { normal, light: l, shift: 0.0, profile: step, wanted: 1.0, tolerance: 0.0 }
        })
        .collect();
    check(&cases);
}

#[test]
fn case_06_ambient_is_everywhere() {
    let mut random = Random::new(6);
    let mut cases: Vec<Case> = (0..500)
        .map(|_| Case {
            normal: held(random.direction()),
            light: held(random.direction()),
            shift: random.between(-PI, PI),
            profile: [PI, random.between(-1.0, 4.0), random.between(-1.0, 4.0)],
            wanted: 1.0,
            tolerance: 0.0,
        })
        .collect();
    cases.push(Case { shift: -1.0, ..Case::at(PI, [PI, 0.3, 0.6], 1.0, 0.0) });
    cases.push(Case {
        shift: -PI,
        normal: -DVec3::Z,
        ..Case::at(PI, [f32_of(PI), 0.0, 0.0], 1.0, 0.0)
    });
    // An offset of pi as people type it is ambient too.
    let written = ["3.14159".parse().unwrap(), 0.0, 0.0];
    cases.push(Case { shift: -1.0, ..Case::at(PI, written, 1.0, 0.0) });
    check(&cases);
}

#[test]
fn case_07_offsets_are_absolute() {
    let profile = [0.5, 0.7, 1.0];
    check(&[
        Case::at(1.2, profile, 0.0, 0.0),
        Case::at(1.0, profile, 0.0, 1e-6),
        Case::at(0.5, profile, 1.0, 1e-6),
        Case::at(0.49, profile, 1.0, 0.0),
    ]);
    // The inflection lies at the fall-off: the second difference changes its sign there.
    let h = 1e-3;
    let bend = |u: f64| {
        let at = |u: f64| {
            interpreted(DVec3::new(u.sin(), 0.0, u.cos()), DVec3::Z, 0.0, profile, Precision::F64).1
        };
        (at(u - h) - 2.0 * at(u) + at(u + h)) / (h * h)
    };
    assert!(bend(0.65) < -1.0 && bend(0.75) > 1.0, "{} {}", bend(0.65), bend(0.75));
    assert!(bend(0.7).abs() < 0.02 * bend(0.75), "{}", bend(0.7));
}

#[test]
fn case_08_everything_at_pi() {
    let angles = [0.0_f64, 0.3, 1.0, FRAC_PI_2, 2.5, 3.1, PI];
    for pi in [PI, f32_of(PI)] {
        let cases: Vec<Case> = angles
            .iter()
            .map(|&u| Case::at(u, [0.0, pi, pi], (0.5 * u).cos().powi(2), 3e-7))
            .collect();
        check(&cases);
    }
}

#[test]
fn case_09_falloff_at_the_cutoff() {
    let line = |u: f64| ((u.cos() - 0.7_f64.cos()) / (1.0 - 0.7_f64.cos())).max(0.0);
    let cases: Vec<Case> = (0..=80)
        .map(|i| 0.01 * f64::from(i))
        .map(|u| Case::at(u, [0.0, 0.7, 0.7], line(u), 1e-6))
        .collect();
    check(&cases);
}

#[test]
fn case_10_tiny_cutoffs() {
    check(&[Case::at(3e-5, [0.0, 5e-5, 1e-4], (1.0 - 0.09_f64).powf(2.5), 2e-5)]);
    let small: Vec<Case> = (0..=10)
        .map(|i| 1e-5 * f64::from(i))
        .map(|u| {
            Case::at(u, [0.0, 5e-5, 1e-4], (1.0 - (u / 1e-4).powi(2)).max(0.0).powf(2.5), 2e-5)
        })
        .collect();
    check(&small);
}

#[test]
fn case_11_a_gaussian() {
    let f = 3e-4;
    check(&[Case::at(f, [0.0, f, FRAC_PI_2], (-0.5_f64).exp(), 2e-6)]);
    // The profile follows a Gaussian over its whole width.
    let bell: Vec<Case> = (0..=40)
        .map(|i| 3e-5 * f64::from(i))
        .map(|u| Case::at(u, [0.0, f, FRAC_PI_2], (-0.5 * (u / f).powi(2)).exp(), 3e-6))
        .collect();
    check(&bell);
}

#[test]
fn case_12_no_falloff_is_a_step() {
    check(&[Case::at(0.0, [0.0, 0.0, 1.0], 1.0, 0.0), Case::at(1e-3, [0.0, 0.0, 1.0], 0.0, 0.0)]);
    let moved = [0.4, 0.4, 1.0];
    check(&[
        Case::at(0.3999, moved, 1.0, 0.0),
        Case::at(0.4, moved, 1.0, 0.0),
        Case::at(0.4001, moved, 0.0, 0.0),
    ]);
}

#[test]
fn case_13_parameters_out_of_order() {
    let wild = [
        [0.5, 0.7, 0.2],
        [0.5, 2.0, 1.0],
        [0.5, 0.1, 1.0],
        [-1.0, -1.0, 1.0],
        [0.5, 9.0, 9.0],
        [9.0, 0.0, 0.0],
        [-9.0, -9.0, -9.0],
        [0.0, 1e30, -1e30],
        [1e-30, 1e-30, 1e-30],
    ];
    for profile in wild {
        let [tau, f, c] = badf::sanitized(profile);
        let mut last = 1.0;
        let us: Vec<f64> = (0..=90).map(|i| PI * f64::from(i) / 90.0).collect();
        let cases: Vec<Case> = us
            .iter()
            // Angles on an edge are tested by case 5.
            .filter(|u| [tau, f, c].iter().all(|edge| (**u - edge).abs() > 1e-5))
            .map(|&u| Case::at(u, profile, alpha(u, 0.0, profile), 3e-6))
            .collect();
        check(&cases);
        for case in &cases {
            assert!(case.wanted <= last, "{profile:?} is not falling");
            last = case.wanted;
        }
    }
}

#[test]
fn case_14_an_infinite_slope() {
    let profile = [0.0, 2.5, 3.0];
    let us: Vec<f64> = (0..400).map(|i| 2.99 + 5e-5 * f64::from(i)).collect();
    let cases: Vec<Case> =
        us.iter().map(|&u| Case::at(u, profile, alpha(u, 0.0, profile), 3e-4)).collect();
    check(&cases);
    let tones =
        eval(&profile_look(), "tone.tone", &cases.iter().map(sample_of).collect::<Vec<_>>());
    assert!(tones.windows(2).all(|pair| pair[1][0] <= pair[0][0]), "not falling");
    assert!(
        tones.iter().zip(&us).all(|(tone, u)| *u < 3.0 || tone[0] == 0.0),
        "not 0 from the cut-off on"
    );
}

#[test]
fn case_15_curvature_without_bounds() {
    let curved = look(&json!({
        "exposed": [{"name": "slope", "target": "convexity.slope"}],
        "nodes": [{"id": "convexity", "kind": "transition"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "convexity", "to": "output.color"}]
    }));
    let cases = [
        (50.0, 1.0, 1.0),
        (100.0, 1.0, 1.0),
        (-100.0, 1.0, 0.0),
        (1e30, 1.0, 1.0),
        (-1e30, 1.0, 0.0),
        (f64::INFINITY, 1.0, 1.0),
        (f64::NEG_INFINITY, 1.0, 0.0),
        (f64::INFINITY, 0.0, 0.5),
        (f64::NAN, 1.0, 0.5),
        (1e30, 1e30, 1.0),
        (1e-20, 1e30, 1.0),
        (0.0, 1e30, 0.5),
        (0.0, 0.0, 0.5),
    ];
    let samples = cases.map(|(kappa, slope, _)| EvalSample {
        kappa,
        values: [("slope".into(), Value::Number(slope))].into_iter().collect(),
        ..EvalSample::default()
    });
    for tier in [Tier::Balanced, Tier::Fast] {
        let mut of_tier = look(&serde_json::from_str(&curved.look.to_text()).expect("JSON"));
        of_tier.look.tier = Some(tier);
        for ((kappa, slope, wanted), value) in
            cases.iter().zip(eval(&of_tier, "convexity.convexity", &samples))
        {
            assert_eq!(value[0], *wanted, "GPU, {tier:?}: kappa {kappa}, slope {slope}");
        }
    }
    for ((kappa, slope, wanted), value) in
        cases.iter().zip(eval(&curved, "convexity.convexity", &samples))
    {
        assert_eq!(value[0], *wanted, "GPU: kappa {kappa}, slope {slope}");
        for precision in [Precision::F64, Precision::F32] {
            let got = call("transition", &[number(*kappa), number(*slope)], precision)
                .as_f64()
                .unwrap_or(f64::NAN);
            assert!(
                (got - wanted).abs() < 1e-12,
                "{precision:?}: {got} for kappa {kappa}, slope {slope}"
            );
        }
    }
}

#[test]
fn case_16_warps_do_not_come_around() {
    let soft = [0.3, 0.8, 1.5];
    let cases = [
        Case { shift: 1.0, ..Case::at(0.2, soft, 1.0, 0.0) },
        Case { shift: -1.0, ..Case::at(3.0, soft, 0.0, 0.0) },
        Case { shift: PI, ..Case::at(3.0, soft, 1.0, 0.0) },
        Case { shift: -PI, ..Case::at(0.1, soft, 0.0, 0.0) },
        // Half-Lambert, where a cosine beyond pi would come back.
        Case { shift: -1.0, ..Case::at(3.0, [0.0, FRAC_PI_2, PI], 0.0, 1e-12) },
        Case { shift: 1.0, ..Case::at(0.2, [0.0, FRAC_PI_2, PI], 1.0, 0.0) },
    ];
    check(&cases);
}

// Pictures

/// A ball of radius 1 with exact normals, fine enough that its facets are far below a pixel.
fn ball() -> Mesh {
    let (rows, columns) = (160_u32, 320_u32);
    let mut mesh = Mesh::default();
    for row in 0..=rows {
        let theta = PI * f64::from(row) / f64::from(rows);
        for column in 0..=columns {
            let phi = 2.0 * PI * f64::from(column) / f64::from(columns);
            // The pole looks along x, away from the camera.
            let n = DVec3::new(theta.cos(), theta.sin() * phi.cos(), theta.sin() * phi.sin());
            add_vertex(&mut mesh, n, n);
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let a = row * (columns + 1) + column;
            let b = a + columns + 1;
            mesh.indices.extend([a, b, a + 1, a + 1, b, b + 1]);
        }
    }
    one_part(mesh)
}

/// A square with sides of 6 in the plane z = 0.
fn plane(normal: DVec3) -> Mesh {
    let mut mesh = Mesh::default();
    let right = normal.cross(DVec3::Y).normalize() * -1.0;
    let up = normal.cross(right);
    for (x, y) in [(-3.0, -3.0), (3.0, -3.0), (-3.0, 3.0), (3.0, 3.0)] {
        add_vertex(&mut mesh, right * x + up * y, normal);
    }
    mesh.indices = vec![0, 1, 2, 2, 1, 3];
    one_part(mesh)
}

fn add_vertex(mesh: &mut Mesh, position: DVec3, normal: DVec3) {
    mesh.positions.push(position.as_vec3().to_array());
    mesh.normals.push(normal.normalize().as_vec3().to_array());
    let along = normal.cross(if normal.y.abs() < 0.9 { DVec3::Y } else { DVec3::X }).normalize();
    mesh.tangents.push([along.x as f32, along.y as f32, along.z as f32, 1.0]);
    mesh.uvs.push([0.0; 2]);
    mesh.colors.push([1.0; 4]);
}

fn one_part(mut mesh: Mesh) -> Mesh {
    let part = MeshPart {
        material: "default".to_owned(),
        indices: 0..mesh.indices.len() as u32,
        two_sided: true,
        alpha_cutoff: None,
        maps: None,
    };
    mesh.parts = vec![part];
    mesh
}

/// Height of every picture below; a camera without perspective looks along -z. In scene units.
const HEIGHT: f64 = 2.5;

fn parallel() -> Scene {
    let camera =
        Camera { projection: Projection::Orthographic, height: HEIGHT, ..Camera::default() };
    Scene { camera, backdrop: None, ..Scene::default() }
}

fn picture(parts: Vec<(SetupLook, Mesh, DMat4)>, size: [u32; 2], samples: u32) -> Picture {
    draw(&scene_of(parts, parallel()), Library::built_in(), &Live::Keyed, size, samples)
}

/// The point of the plane z = 0 under the middle of a pixel.
fn place(size: [u32; 2], x: f64, y: f64) -> DVec2 {
    let pixel = HEIGHT / f64::from(size[1]);
    DVec2::new(
        (x + 0.5 - 0.5 * f64::from(size[0])) * pixel,
        (0.5 * f64::from(size[1]) - y - 0.5) * pixel,
    )
}

fn pixels(picture: &Picture) -> impl Iterator<Item = (u32, u32, [f32; 4])> + '_ {
    let [width, height] = picture.size;
    (0..height).flat_map(move |y| (0..width).map(move |x| (x, y, picture.pixel(x, y))))
}

/// A look that shows lambda, by curvature that is measured in a tier.
fn convexity_look(slope: f64, tier: Tier) -> SetupLook {
    let mut convexity = look(&json!({
        "nodes": [
            {"id": "kappa", "kind": "kappa"},
            {"id": "convexity", "kind": "transition", "values": {"slope": slope}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "kappa", "to": "convexity.kappa"}, {"from": "convexity", "to": "output.color"}
        ]
    }));
    convexity.look.graph.nodes["kappa"].tier = Some(tier);
    convexity
}

/// Tiers that measure curvature.
const KAPPA_TIERS: [Tier; 3] = [Tier::Exact, Tier::Balanced, Tier::Fast];

/// kappa of a ball where its normal has the z component `nz`. `radius` in viewport heights.
fn ball_kappa(radius: f64, nz: f64) -> f64 {
    (1.0 + nz * nz) / (2.0 * nz.powi(3)) / radius
}

const SLOPE: f64 = 0.05;

/// Largest curvature that a tier measures on flat surfaces.
fn kappa_noise(tier: Tier) -> f64 {
    if tier == Tier::Fast { 1e-3 } else { 0.0 }
}

#[test]
fn case_17_silhouettes_and_depth_edges() {
    for tier in KAPPA_TIERS {
        let size = [240, 240];
        // Two balls of one object, one in front of the other, and a plane behind both.
        let mut pair = ball();
        let second = ball();
        let offset = pair.positions.len() as u32;
        for ((position, normal), tangent) in
            second.positions.iter().zip(&second.normals).zip(&second.tangents)
        {
            pair.positions.push([
                0.35 + 0.5 * position[0],
                0.1 + 0.5 * position[1],
                1.6 + 0.5 * position[2],
            ]);
            pair.normals.push(*normal);
            pair.tangents.push(*tangent);
            pair.uvs.push([0.0; 2]);
            pair.colors.push([1.0; 4]);
        }
        pair.indices.extend(second.indices.iter().map(|index| index + offset));
        let pair = one_part(pair);
        let behind = DMat4::from_translation(DVec3::new(0.0, 0.0, -2.0));
        let parts = vec![
            (convexity_look(SLOPE, tier), pair, DMat4::IDENTITY),
            (convexity_look(SLOPE, tier), plane(DVec3::Z), behind),
        ];
        let picture = picture(parts, size, 1);
        let (mut on_plane, mut compared, mut worst) = (0, 0, 0.0_f64);
        for (x, y, pixel) in pixels(&picture) {
            assert!(
                pixel.iter().all(|c| c.is_finite() && (0.0..=1.0).contains(c)),
                "{pixel:?} at {x}, {y}"
            );
            let at = place(size, f64::from(x), f64::from(y));
            let (far, near) = (at.length(), (at - DVec2::new(0.35, 0.1)).length() / 0.5);
            let margin = 2.0 * HEIGHT / f64::from(size[1]);
            if far > 1.0 + margin && near > 1.0 + 2.0 * margin {
                let off = (f64::from(pixel[0]) - 0.5).abs();
                assert!(
                    off <= kappa_noise(tier) * SLOPE,
                    "{tier:?}: the plane is not flat at {x}, {y}: {off}"
                );
                on_plane += 1;
            } else if (near - 1.0).abs() > 2.0 * margin && (near < 1.0 || far < 1.0 - margin) {
                // The facing halves of both balls are compared, also right beside the depth edge
                // between them.
                let (radius, r) = if near < 1.0 { (0.5, near) } else { (1.0, far) };
                let nz = (1.0 - r * r).max(0.0).sqrt();
                if nz > 0.5 {
                    let wanted = badf::lambda(ball_kappa(radius / HEIGHT, nz), SLOPE);
                    worst = worst.max((f64::from(pixel[0]) - wanted).abs());
                    compared += 1;
                } else {
                    assert!(pixel[0] > 0.5, "a ball's rim is not convex at {x}, {y}: {pixel:?}");
                }
            }
        }
        assert!(on_plane > 5000 && compared > 10000, "{on_plane} {compared}");
        assert!(worst < 0.03, "{tier:?}: {worst}");
    }
}

#[test]
fn case_17_planes_are_flat_however_they_lie() {
    for tier in KAPPA_TIERS {
        for normal in [DVec3::Z, DVec3::new(0.3, 0.5, 0.8), DVec3::new(-0.7, 0.2, 0.4)] {
            let parts =
                vec![(convexity_look(2.0, tier), plane(normal.normalize()), DMat4::IDENTITY)];
            let drawn = picture(parts, [120, 120], 1);
            let flat: Vec<f32> = pixels(&drawn).filter(|p| p.2[3] == 1.0).map(|p| p.2[0]).collect();
            assert!(
                flat.len() > 8000
                    && flat.iter().all(|x| f64::from(x - 0.5).abs() <= 2.0 * kappa_noise(tier)),
                "{normal}: not flat"
            );
        }
    }
}

#[test]
fn case_17_a_ball_has_its_curvature() {
    for tier in KAPPA_TIERS {
        let size = [320, 320];
        let drawn = picture(vec![(convexity_look(SLOPE, tier), ball(), DMat4::IDENTITY)], size, 1);
        let mut worst = [0.0_f64; 2];
        for (x, y, pixel) in pixels(&drawn) {
            let r = place(size, f64::from(x), f64::from(y)).length();
            let nz = (1.0 - r * r).max(0.0).sqrt();
            // A picture's half float resolves lambda to 5e-4.
            let t = (2.0 * f64::from(pixel[0]) - 1.0).clamp(-1.0, 1.0);
            if nz > 0.4 {
                let wanted = ball_kappa(1.0 / HEIGHT, nz);
                let error = (t.atanh() / SLOPE / wanted - 1.0).abs();
                let class = usize::from(nz < 0.6);
                worst[class] = worst[class].max(error);
            } else if r < 0.99 {
                // Below nz = 0.2 the division is clamped, so kappa stays bounded.
                assert!(
                    t > 0.0 && t.atanh() / SLOPE < 2.0 * ball_kappa(1.0 / HEIGHT, 0.2),
                    "{t} at nz {nz}"
                );
            }
        }
        let stated = Library::built_in().nodes["kappa"].error_of(tier).map(|error| error.bound);
        let most = stated.map_or([0.03, 0.06], |bound| [bound; 2]);
        assert!(worst[0] < most[0] && worst[1] < most[1], "{tier:?}: kappa is off by {worst:?}");
    }
}

#[test]
fn case_18_curvature_at_twice_the_resolution() {
    for tier in KAPPA_TIERS {
        let at = |side: u32| {
            picture(vec![(convexity_look(SLOPE, tier), ball(), DMat4::IDENTITY)], [side, side], 1)
        };
        let (small, large) = (at(200), at(400));
        let (mut worst, mut count) = (0.0_f64, 0);
        for (x, y, pixel) in pixels(&small) {
            let r = place([200, 200], f64::from(x), f64::from(y)).length();
            if r < 0.85 {
                let four = [(0, 0), (1, 0), (0, 1), (1, 1)]
                    .map(|(i, j)| f64::from(large.pixel(2 * x + i, 2 * y + j)[0]));
                worst = worst.max((four.iter().sum::<f64>() / 4.0 - f64::from(pixel[0])).abs());
                count += 1;
            }
        }
        assert!(count > 10_000 && worst < 0.01, "{tier:?}: {worst} over {count}");
    }
}

/// Share of a pixel that lies within a cartoon's lit area, by 32 x 32 points of the exact ball.
/// `None` near the silhouette.
fn exact_coverage(
    size: [u32; 2],
    x: u32,
    y: u32,
    center: DVec2,
    light: DVec3,
    edge: f64,
) -> Option<f64> {
    let mut lit = 0;
    for i in 0..32 {
        for j in 0..32 {
            let at = place(
                size,
                f64::from(x) + f64::from(i) / 32.0 - 31.0 / 64.0,
                f64::from(y) + f64::from(j) / 32.0 - 31.0 / 64.0,
            );
            let p = at - center;
            let z2 = 1.0 - p.length_squared();
            // Two pixels inside of the silhouette all neighbors of a pixel have normals of the
            // ball.
            if z2 < 0.06 {
                return None;
            }
            lit += u32::from(angle(DVec3::new(p.x, p.y, z2.sqrt()), light) <= edge);
        }
    }
    Some(f64::from(lit) / 1024.0)
}

#[test]
fn case_19_cartoon_edges_are_covered() {
    cartoon_edges(Tier::Exact, 0.06, 0.02);
    // These tiers take the width from the sum of both derivatives, which on diagonals is too wide
    // by up to the square root of 2.
    cartoon_edges(Tier::Balanced, 0.06, 0.02);
    cartoon_edges(Tier::Fast, 0.15, 0.07);
}

/// Draws cartoons in a tier, and bounds the difference between pixels on and beside their edges and
/// the edge's exact coverage: the largest one, and the mean over pixels on the edge.
fn cartoon_edges(tier: Tier, most: f64, most_mean: f64) {
    let size = [160, 160];
    let mut errors = Vec::new();
    let lights = [
        DVec3::Z,
        DVec3::new(0.5, 0.4, 1.0),
        DVec3::new(-0.9, 0.1, 0.7),
        DVec3::new(0.6, -0.6, 0.2),
    ];
    for (step, light) in lights.into_iter().enumerate() {
        // The ball moves by fractions of a pixel.
        let center = DVec2::new(0.37, -0.21) * step as f64 * HEIGHT / f64::from(size[1]);
        for edge in [FRAC_PI_4, 0.3] {
            let mut cartoon = look(&json!({
                "lights": {"key": {"direction": light.to_array()}},
                "nodes": [
                    {"id": "light", "kind": "light", "values": {"light": "key"}},
                    {"id": "angle", "kind": "parametrization"},
                    {
                        "id": "tone", "kind": "profile",
                        "values": {"offset": edge, "falloff": edge, "cutoff": edge}
                    },
                    {"id": "output", "kind": "output"}
                ],
                "wires": [
                    {"from": "light", "to": "angle.light"},
                    {"from": "angle", "to": "tone.angle"},
                    {"from": "tone", "to": "output.color"}
                ]
            }));
            cartoon.look.tier = Some(tier);
            let moved = DMat4::from_translation(center.extend(0.0));
            let drawn = picture(vec![(cartoon, ball(), moved)], size, 1);
            for (x, y, pixel) in pixels(&drawn) {
                assert!(
                    pixel.iter().all(|c| c.is_finite() && (0.0..=1.0).contains(c)),
                    "{pixel:?} at {x}, {y}"
                );
                let Some(wanted) = exact_coverage(size, x, y, center, light, edge) else {
                    continue;
                };
                let error = (f64::from(pixel[0]) - wanted).abs();
                if wanted > 0.0 && wanted < 1.0 {
                    errors.push(error);
                } else {
                    // Beside the edge the ramp may still leave a trace.
                    assert!(error <= most, "{pixel:?} for {wanted} at {x}, {y}, light {light}");
                }
            }
        }
    }
    let worst = errors.iter().copied().fold(0.0, f64::max);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    assert!(errors.len() > 1000, "{}", errors.len());
    assert!(
        worst <= most && mean <= most_mean,
        "{tier:?}: worst {worst}, mean {mean} over {}",
        errors.len()
    );
}

#[test]
fn case_19_thresholds_and_bands_are_covered() {
    let size = [160, 160];
    for (kind, input, values) in [
        ("threshold", "value", json!({"edge": 0.7})),
        ("bands", "value", json!({"count": 2, "softness": 0})),
    ] {
        let edge = if kind == "threshold" { 0.7_f64 } else { 0.5 };
        let stated = |tier| Library::built_in().nodes[kind].error_of(tier).map(|error| error.bound);
        for tier in [Tier::Exact, Tier::Balanced, Tier::Fast] {
            let bound = stated(tier).unwrap_or(0.06);
            let mut worst = 0.0_f64;
            for step in 0..4 {
                let center =
                    DVec2::new(0.37, -0.21) * f64::from(step) * HEIGHT / f64::from(size[1]);
                let mut cut = look(&json!({
                    "nodes": [
                        {"id": "facing", "kind": "facing"},
                        {"id": "cut", "kind": kind, "values": values},
                        {"id": "output", "kind": "output"}
                    ],
                    "wires": [
                        {"from": "facing", "to": format!("cut.{input}")},
                        {"from": "cut", "to": "output.color"}
                    ]
                }));
                cut.look.tier = Some(tier);
                let drawn = picture(
                    vec![(cut, ball(), DMat4::from_translation(center.extend(0.0)))],
                    size,
                    1,
                );
                for (x, y, pixel) in pixels(&drawn) {
                    let Some(wanted) = exact_coverage(size, x, y, center, DVec3::Z, edge.acos())
                    else {
                        continue;
                    };
                    worst = worst.max((f64::from(pixel[0]) - wanted).abs());
                }
            }
            assert!(worst <= bound, "{kind}, {tier:?}: {worst} beyond {bound}");
            // The stated error is at most half as large again as the measured one.
            assert!(
                tier == Tier::Exact || worst >= bound / 1.5,
                "{kind}, {tier:?}: {worst} far below {bound}"
            );
        }
    }
}

// Stacks

fn chain(base: [f64; 4], layers: &[Json]) -> SetupLook {
    let mut nodes = vec![json!({"id": "base", "kind": "base", "values": {"color": base}})];
    let mut wires = Vec::new();
    let mut below = "base".to_owned();
    for (index, values) in layers.iter().enumerate() {
        let id = format!("blend_{index}");
        nodes.push(json!({"id": id, "kind": "blend", "values": values}));
        wires.push(json!({"from": below, "to": format!("{id}.below")}));
        below = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": below, "to": "output.color"}));
    look(&json!({"nodes": nodes, "wires": wires}))
}

fn value(look: &SetupLook) -> DVec4 {
    DVec4::from_array(eval(look, "", &[EvalSample::default()])[0])
}

#[test]
fn case_20_multiply_without_tone_is_black() {
    let look = chain(
        [0.7, 0.6, 0.5, 1.0],
        &[json!({"mode": "multiply", "tone": 0, "color": [1, 1, 1, 1]})],
    );
    assert_eq!(value(&look), DVec4::new(0.0, 0.0, 0.0, 1.0));
}

#[test]
fn case_20_opacity_zero_changes_nothing() {
    for mode in badf::Mode::ALL.into_iter().chain(badf::Mode::PAINTED) {
        for layer in [
            json!({"mode": mode.word(), "tone": 0.7, "color": [0.2, 0.9, 0.4, 0.0]}),
            json!({"mode": mode.word(), "tone": 0.7, "color": [0.2, 0.9, 0.4, 1.0], "opacity": 0}),
        ] {
            assert_eq!(
                value(&chain([0.75, 0.5, 0.25, 1.0], &[layer])),
                DVec4::new(0.75, 0.5, 0.25, 1.0),
                "{mode:?}"
            );
        }
    }
}

#[test]
fn case_20_every_layer_is_clamped() {
    let layers = |clamped: bool| {
        let layer =
            |mode: &str, x: f64| json!({"mode": mode, "color": [x, x, x, 1], "clamped": clamped});
        [layer("add", 0.8), layer("add", 0.8), layer("subtract", 0.5)]
    };
    let black = [0.0, 0.0, 0.0, 1.0];
    assert_eq!(value(&chain(black, &layers(true))), DVec4::new(0.5, 0.5, 0.5, 1.0));
    let free = value(&chain(black, &layers(false)));
    assert!((free - DVec4::new(1.1, 1.1, 1.1, 1.0)).abs().max_element() < 1e-6, "{free}");
}

/// Every source of NaN in the paper's formulas, in one layer of five, leaves the other four layers
/// unchanged.
#[test]
fn case_21_no_layer_poisons_the_stack() {
    let layers = |profile: Json, kind: &str| {
        let plain = |convex: [f64; 4], blend: &str| {
            json!({
                "light": "key", "convex": convex, "concave": convex, "blend": blend
            })
        };
        let mut odd = plain([0.1, 0.2, 0.3, 1.0], "add");
        let merged = odd.as_object_mut().expect("an object");
        merged.extend(profile.as_object().expect("an object").clone());
        merged.insert("type".to_owned(), json!(kind));
        [
            plain([0.2, 0.0, 0.1, 1.0], "add"),
            plain([0.1, 0.1, 0.0, 1.0], "add"),
            odd,
            plain([0.9, 0.8, 0.7, 1.0], "shade"),
            plain([0.05, 0.0, 0.0, 1.0], "subtract"),
        ]
    };
    let odd_profiles = [
        json!({"offset": 1, "falloff": 1, "cutoff": 1}),
        json!({"offset": 0, "falloff": 0, "cutoff": 0}),
        json!({"offset": 0, "falloff": PI, "cutoff": PI}),
        json!({"offset": 0, "falloff": 5e-5, "cutoff": 1e-4}),
        json!({"offset": 0, "falloff": 0, "cutoff": 1}),
        json!({"offset": 0, "falloff": 2.9, "cutoff": 3.0, "slope": 1e30, "amount": 3}),
    ];
    for profile in odd_profiles {
        for kind in ["diffuse", "specular", "screen_aligned", "half_vector"] {
            let mut nodes = vec![
                json!({"id": "base", "kind": "base", "values": {"color": [0.3, 0.4, 0.5, 1]}}),
            ];
            let mut wires = Vec::new();
            let mut below = "base.below".to_owned();
            for (index, values) in layers(profile.clone(), kind).iter().enumerate() {
                nodes.push(
                    json!({"id": format!("layer_{index}"), "kind": "light_layer", "values": values})
                );
                wires.push(json!({"from": below, "to": format!("layer_{index}.below")}));
                below = format!("layer_{index}.below");
            }
            nodes.push(json!({"id": "output", "kind": "output"}));
            wires.push(json!({"from": below, "to": "output.color"}));
            let look = look(&json!({
                "lights": {"key": {"direction": [0, 0, 1]}}, "nodes": nodes, "wires": wires
            }));
            let places = [
                DVec3::Z,
                -DVec3::Z,
                DVec3::X,
                DVec3::new(1e-6, 0.0, 1.0),
                DVec3::new(0.3, -0.5, 0.6),
            ];
            let samples: Vec<EvalSample> = places
                .iter()
                .flat_map(|&normal| {
                    places.map(|view| EvalSample {
                        normal,
                        view,
                        kappa: f64::INFINITY,
                        ..EvalSample::default()
                    })
                })
                .collect();
            let tones = eval(&look, "layer_2.tone", &samples);
            for ((value, tone), sample) in eval(&look, "", &samples).iter().zip(tones).zip(&samples)
            {
                let rho = tone[0];
                assert!((0.0..=1.0).contains(&rho), "{rho} of {profile} {kind} at {sample:?}");
                let lambert = sample.normal.normalize().z.max(0.0);
                let mut stack = DVec4::new(0.3, 0.4, 0.5, 1.0);
                let steps = [
                    (badf::Mode::Add, [0.2, 0.0, 0.1], lambert),
                    (badf::Mode::Add, [0.1, 0.1, 0.0], lambert),
                    (badf::Mode::Add, [0.1, 0.2, 0.3], rho),
                    (badf::Mode::Shade, [0.9, 0.8, 0.7], lambert),
                    (badf::Mode::Subtract, [0.05, 0.0, 0.0], lambert),
                ];
                for (mode, color, rho) in steps {
                    stack =
                        badf::blend(mode, stack, DVec3::from(color).extend(1.0), rho, 1.0, true);
                }
                let error = (DVec4::from_array(*value) - stack).abs().max_element();
                assert!(error < 1e-6, "{value:?} for {stack} of {profile} {kind} at {sample:?}");
            }
        }
    }
}

#[test]
fn case_21_output_clears_what_a_custom_node_lets_through() {
    let code = "/// Nothing\n///\n/// Not a number.\n///\n/// @param value \"Value\" default=0 : \
                Any.\n/// @return value \"Value\" : NaN.\n\
                fn nothing(value: f32) -> f32 { return bitcast<f32>(0x7fc00000u + u32(value)); }";
    let look = look(&json!({
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.25, 0.5, 0.75, 1]}},
            {"id": "place", "kind": "depth"},
            {"id": "nothing", "kind": "wgsl", "values": {"code": code}},
            {"id": "blend", "kind": "blend", "values": {"color": [1, 1, 1, 1]}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "base", "to": "blend.below"},
            {"from": "place", "to": "nothing.value"},
            {"from": "nothing", "to": "blend.tone"},
            {"from": "blend", "to": "output.color"}
        ]
    }));
    assert!(value(&look).is_finite(), "{}", value(&look));
}

// Keys

fn keyed(keys: &Json) -> SetupLook {
    look(&json!({
        "nodes": [
            {"id": "number", "kind": "number", "values": {"value": 7}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "number", "to": "output.color"}],
        "lights": {"key": {"direction": [0, 0, 1]}},
        "direction_keys": [{"name": "Views", "by": "view", "keys": keys}]
    }))
}

fn seen_from(look: &SetupLook, views: &[DVec3]) -> Vec<f64> {
    let samples: Vec<EvalSample> =
        views.iter().map(|&view| EvalSample { view, ..EvalSample::default() }).collect();
    eval(look, "number.value", &samples).iter().map(|value| value[0]).collect()
}

fn key(direction: DVec3, value: f64) -> Json {
    json!({"direction": direction.to_array(), "values": {"number.value": value}})
}

#[test]
fn case_22_odd_sets_of_keys() {
    let mut random = Random::new(22);
    let views: Vec<DVec3> = (0..100).map(|_| random.direction()).collect();
    assert!(
        seen_from(&keyed(&json!([])), &views).iter().all(|x| *x == 7.0),
        "no keys: the look's own"
    );
    let one = keyed(&json!([key(DVec3::X, 3.0)]));
    assert!(
        seen_from(&one, &views).iter().all(|x| (x - 3.0).abs() < 1e-6),
        "one key holds everywhere"
    );
    for apart in [0.0, 1e-6] {
        // Duplicate keys share a weight, so together they weigh as one.
        let near = (DVec3::X + apart * DVec3::Y) * 5.0;
        let pair = keyed(&json!([key(DVec3::X, 2.0), key(near, 4.0), key(-DVec3::Z, 9.0)]));
        let merged = keyed(&json!([key(DVec3::X, 3.0), key(-DVec3::Z, 9.0)]));
        for (a, b) in seen_from(&pair, &views).iter().zip(seen_from(&merged, &views)) {
            assert!((a - b).abs() < 1e-5, "{a} {b}");
        }
        assert!((seen_from(&pair, &[DVec3::X])[0] - 3.0).abs() < 1e-6);
    }
    // Antipodal keys of any length have symmetric weights.
    let poles = keyed(&json!([key(DVec3::Z * 1e-3, 0.0), key(-DVec3::Z * 40.0, 1.0)]));
    let mirrored: Vec<DVec3> = views.iter().map(|v| -*v).collect();
    for (a, b) in seen_from(&poles, &views).iter().zip(seen_from(&poles, &mirrored)) {
        assert!((a + b - 1.0).abs() < 1e-6 && (0.0..=1.0).contains(a), "{a} {b}");
    }
    assert!((seen_from(&poles, &[DVec3::X])[0] - 0.5).abs() < 1e-6);
}

#[test]
fn case_23_keys_hold_where_they_are() {
    let mut random = Random::new(23);
    for count in 2..8 {
        let mut places: Vec<DVec3> = Vec::new();
        while places.len() < count {
            let place = if places.len() == 1 {
                // The second key lies ten degrees from the first.
                let aside = places[0].cross(random.direction()).normalize();
                places[0] * 10_f64.to_radians().cos() + aside * 10_f64.to_radians().sin()
            } else {
                random.direction()
            };
            if places.iter().all(|other| angle(*other, place) > 0.17) {
                places.push(place);
            }
        }
        // w_k(key_j) is 1 for k = j and 0 otherwise.
        for k in 0..count {
            let keys: Vec<Json> = places
                .iter()
                .enumerate()
                .map(|(j, &place)| key(place, f64::from(u8::from(j == k))))
                .collect();
            let look = keyed(&json!(keys));
            for (j, weight) in seen_from(&look, &places).into_iter().enumerate() {
                assert!(
                    (weight - f64::from(u8::from(j == k))).abs() < 1e-6,
                    "{weight} of key {k} at key {j} of {count}"
                );
            }
            let anywhere: Vec<DVec3> = (0..40).map(|_| random.direction()).collect();
            assert!(seen_from(&look, &anywhere).iter().all(|w| (0.0..=1.0).contains(w)));
        }
    }
}

#[test]
fn case_23_light_directions_never_average_to_nothing() {
    let look = look(&json!({
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "parts", "kind": "light_parts"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "parts.light"}, {"from": "parts.color", "to": "output.color"}
        ],
        "lights": {"key": {"direction": [0, 0, 1]}},
        "direction_keys": [{"name": "Turn", "by": "view", "keys": [
            {"direction": [1, 0, 0], "values": {"lights.key.direction": [0, 1, 0]}},
            {"direction": [-1, 0, 0], "values": {"lights.key.direction": [0, -1, 0]}}
        ]}]
    }));
    let mut random = Random::new(24);
    let mut samples: Vec<EvalSample> = (0..100)
        .map(|_| EvalSample { view: random.direction(), ..EvalSample::default() })
        .collect();
    samples.push(EvalSample { view: DVec3::Y, ..EvalSample::default() });
    samples.push(EvalSample {
        view: DVec3::new(0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2),
        ..EvalSample::default()
    });
    for (value, sample) in eval(&look, "parts.direction", &samples).iter().zip(&samples) {
        let direction = DVec3::from_slice(&value[..3]);
        assert!((direction.length() - 1.0).abs() < 1e-6, "{direction} from {}", sample.view);
        if sample.view.x.abs() > 1e-3 {
            assert_eq!(direction.y.signum(), sample.view.x.signum());
        }
    }
}
