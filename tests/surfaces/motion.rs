//! Meshes that move: nodes, skins, morphs, cameras and animations of small glTF files, against
//! numbers that were computed by hand.

use chiaro::compile::Live;
use chiaro::diag::{Diagnostic, WithWarnings};
use chiaro::document::{Camera, MeshAnimation, Scene};
use chiaro::frame::{Assets, PlanOptions, Planner, PlayedAnimation, Setup};
use chiaro::geometry::{CameraLens, Mesh, import, no_siblings};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{probe_surface, surface_setup};
use glam::{DQuat, DVec3, Vec3};
use serde_json::{Value, json};

use crate::geometry_import::base64;
use crate::support::eval::{look, scene, told};

/// A glTF file in the making: its numbers, and the accessors of them.
#[derive(Default)]
pub(crate) struct GltfNumbers {
    bytes: Vec<u8>,
    pub(crate) views: Vec<Value>,
    pub(crate) accessors: Vec<Value>,
}

impl GltfNumbers {
    /// Adds an accessor, and gives its number.
    pub(crate) fn add(&mut self, kind: &str, component: u32, count: usize, bytes: &[u8]) -> usize {
        let offset = self.bytes.len();
        self.bytes.extend(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views
            .push(json!({"buffer": 0, "byteOffset": offset, "byteLength": bytes.len().max(1)}));
        self.accessors.push(json!({"bufferView": self.views.len() - 1, "type": kind,
            "componentType": component, "count": count}));
        self.accessors.len() - 1
    }

    pub(crate) fn floats(&mut self, kind: &str, numbers: &[f32]) -> usize {
        let width = match kind {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        self.add(kind, 5126, numbers.len() / width, &bytes)
    }

    pub(crate) fn indices(&mut self, indices: &[u16]) -> usize {
        let bytes: Vec<u8> = indices.iter().flat_map(|index| index.to_le_bytes()).collect();
        self.add("SCALAR", 5123, indices.len(), &bytes)
    }

    /// The file, with these members beside the numbers.
    pub(crate) fn file(self, mut members: Value) -> String {
        let uri = format!("data:;base64,{}", base64(&self.bytes));
        members["asset"] = json!({"version": "2.0"});
        members["buffers"] = json!([{"byteLength": self.bytes.len(), "uri": uri}]);
        members["bufferViews"] = self.views.into();
        members["accessors"] = self.accessors.into();
        members.to_string()
    }
}

fn read(file: &str) -> WithWarnings<Mesh> {
    import("x.gltf", file.as_bytes(), &no_siblings)
        .unwrap_or_else(|problems| panic!("{problems:#?}\n{file}"))
}

/// The mesh at a time of its first animation.
fn at(mesh: &Mesh, time: f64) -> Mesh {
    let motion = mesh.motion.as_ref().expect("something moves");
    mesh.posed(&motion.pose(Some((&motion.animations()[0], time))))
}

#[track_caller]
fn assert_near(found: [f32; 3], expected: [f64; 3]) {
    let off = Vec3::from(found).as_dvec3().distance(expected.into());
    assert!(off < 1e-6, "{found:?} is not {expected:?}");
}

/// Rows of a sheet that stands on the ground and is bent, bound to two joints: the lower one at the
/// ground, the upper one at the height of 1. `turn` brings the upper joint to the second key.
fn bar(turn: DQuat, more: impl FnOnce(&mut GltfNumbers, &mut Value)) -> String {
    let mut numbers = GltfNumbers::default();
    let (mut points, mut uvs, mut joints, mut weights) = (vec![], vec![], vec![], vec![]);
    for row in 0..5_u8 {
        let height = 0.5 * f32::from(row);
        // The upper joint takes over from a height of 0.5 to one of 1.5.
        let upper = (height - 0.5).clamp(0.0, 1.0);
        for side in [-0.5_f32, 0.0, 0.5] {
            points.extend([side, height, 0.0]);
            uvs.extend([side + 0.5, 1.0 - height / 2.0]);
            joints.extend([0_u8, 1, 0, 0]);
            weights.extend([1.0 - upper, upper, 0.0, 0.0]);
        }
    }
    let mut triangles = Vec::new();
    for row in 0..4_u16 {
        for side in 0..2_u16 {
            let corner = 3 * row + side;
            triangles.extend([corner, corner + 1, corner + 4, corner, corner + 4, corner + 3]);
        }
    }
    let count = points.len() / 3;
    let positions = numbers.floats("VEC3", &points);
    let coordinates = numbers.floats("VEC2", &uvs);
    let joints = numbers.add("VEC4", 5121, count, &joints);
    let weights = numbers.floats("VEC4", &weights);
    let indices = numbers.indices(&triangles);
    let mut binds = [[0.0_f32; 16]; 2];
    for bind in &mut binds {
        bind.iter_mut().step_by(5).for_each(|diagonal| *diagonal = 1.0);
    }
    binds[1][13] = -1.0;
    let binds = numbers.floats("MAT4", binds.as_flattened());
    let times = numbers.floats("SCALAR", &[0.0, 2.0]);
    let turn = turn.to_array().map(|number| number as f32);
    let turns = numbers.floats("VEC4", &[0.0, 0.0, 0.0, 1.0, turn[0], turn[1], turn[2], turn[3]]);
    let mut members = json!({
        "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"mesh": 0, "skin": 0, "translation": [7, 7, 7]},
            {"children": [2], "name": "lower"},
            {"translation": [0, 1, 0], "name": "upper"},
        ],
        "meshes": [{"name": "bar", "primitives": [{
            "attributes": {"POSITION": positions, "TEXCOORD_0": coordinates, "JOINTS_0": joints,
                "WEIGHTS_0": weights},
            "indices": indices}]}],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": binds}],
        "animations": [{"name": "bend", "channels": [
            {"sampler": 0, "target": {"node": 2, "path": "rotation"}}],
            "samplers": [{"input": times, "output": turns}]}],
    });
    more(&mut numbers, &mut members);
    numbers.file(members)
}

/// A bar that bends by a quarter turn, for tests of files.
pub(crate) fn bending_bar() -> String {
    bar(DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2), |_, _| {})
}

#[test]
fn a_skin_follows_its_joints_and_not_its_node() {
    let WithWarnings { value: mesh, warnings } = read(&bending_bar());
    assert!(warnings.iter().all(|note| note.code == "mesh-normals-made"), "{warnings:?}");
    let motion = mesh.motion.as_ref().unwrap();
    let animation = &motion.animations()[0];
    assert_eq!((animation.name.as_str(), animation.seconds()), ("bend", 2.0));
    let vertex = |x: f32, y: f32| {
        let find = |place: &[f32; 3]| place[0] == x && place[1] == y;
        mesh.positions.iter().position(find).unwrap()
    };
    // At rest the node's own transform does not count.
    assert_eq!(mesh.positions[vertex(0.5, 2.0)], [0.5, 2.0, 0.0]);
    assert!(!mesh.is_deformed());
    let bent = at(&mesh, 2.0);
    assert!(bent.is_deformed() && bent.rest() == mesh.positions);
    // What the upper joint has alone turns about (0, 1): (x, 2) goes to (-1, 1 + x).
    assert_near(bent.positions[vertex(0.5, 2.0)], [-1.0, 1.5, 0.0]);
    assert_near(bent.positions[vertex(-0.5, 0.0)], [-0.5, 0.0, 0.0]);
    // At a height of 1 both have half of it: half of (x, 1) and half of (0, 1 + x).
    assert_near(bent.positions[vertex(0.5, 1.0)], [0.25, 1.25, 0.0]);
    // Halfway in time the turn is an eighth.
    let eighth = std::f64::consts::FRAC_PI_4;
    let half = at(&mesh, 1.0);
    let expected = DQuat::from_rotation_z(eighth) * DVec3::new(0.5, 1.0, 0.0) + DVec3::Y;
    assert_near(half.positions[vertex(0.5, 2.0)], expected.to_array());
    // Tangents of a sheet that bends within its plane turn along.
    let tangent = Vec3::from_slice(&bent.tangents[vertex(0.0, 2.0)]);
    assert!(tangent.distance(Vec3::Y) < 1e-5, "{tangent}");
    assert_eq!(bent.uvs, mesh.uvs);
}

/// A still mesh of the places, UVs and triangles of another, read from a file that has no more.
fn modeled(mesh: &Mesh) -> Mesh {
    let mut obj = String::new();
    for ([x, y, z], [u, v]) in mesh.positions.iter().zip(&mesh.uvs) {
        obj += &format!("v {x:?} {y:?} {z:?}\nvt {u:?} {v:?}\n");
    }
    for [a, b, c] in mesh.indices.as_chunks::<3>().0 {
        let [a, b, c] = [a + 1, b + 1, c + 1];
        obj += &format!("f {a}/{a} {b}/{b} {c}/{c}\n");
    }
    import("x.obj", obj.as_bytes(), &no_siblings).unwrap().value
}

/// Made normals and tangents of a deformed mesh are those of the deformed shape as a still mesh.
#[test]
fn a_bent_sheet_is_shaded_as_one_that_was_modeled_so() {
    let mesh = read(&bar(DQuat::from_rotation_x(0.9), |_, _| {})).value;
    let bent = at(&mesh, 2.0);
    let modeled = modeled(&bent);
    assert_eq!(modeled.positions.len(), bent.positions.len());
    for (vertex, place) in bent.positions.iter().enumerate() {
        let same = modeled.positions.iter().position(|other| other == place).unwrap();
        let off = Vec3::from(bent.normals[vertex]).distance(modeled.normals[same].into());
        assert!(off < 1e-5, "normal at {place:?}: {off}");
        let [own, other] = [bent.tangents[vertex], modeled.tangents[same]];
        let off = Vec3::from_slice(&own).distance(Vec3::from_slice(&other));
        assert!(off < 1e-2 && own[3] == other[3], "tangent at {place:?}: {off}");
    }
    assert!(bent.normals.iter().any(|normal| normal[1].abs() > 0.5), "it is bent");
}

/// Curvature, which passes of a picture make of places and normals, is that of the deformed shape
/// as a still mesh, and none where the sheet is still flat.
#[test]
fn curvature_follows_the_bend() {
    let mesh = read(&bar(DQuat::from_rotation_x(0.9), |_, _| {})).value;
    let still = modeled(&at(&mesh, 2.0));
    let camera = Camera { eye: [0.0, 1.0, 4.0], target: [0.0, 1.0, 0.0], ..Camera::default() };
    let setup = |mesh: Mesh, animation| {
        let look = look(&json!({
            "nodes": [{"id": "base", "kind": "base"}, {"id": "output", "kind": "output"}],
            "wires": [{"from": "base", "to": "output.color"}]}));
        let mut setup = scene(look, mesh, Scene { camera, ..Scene::default() });
        setup.objects[0].animation = animation;
        surface_setup(&setup, true)
    };
    let played = MeshAnimation { loops: false, ..MeshAnimation::default() };
    let moving = setup(mesh, Some(PlayedAnimation { number: 0, played }));
    let still = setup(still, None);
    let curvatures = |setup: &Setup, time: f64| -> Vec<Option<f64>> {
        let options = PlanOptions { size: [48; 2], samples: 1, time };
        let mut planner = Planner::for_probes(Assets::default());
        let plan = planner.plan(setup, Library::built_in(), &Live::All, &options);
        let plan = plan.unwrap_or_else(|problems| panic!("{}", told(&problems))).value;
        let at = |y: u32| probe_surface(&plan, [25, y], &Progress::new()).expect("a plan of it");
        (8..40).step_by(3).map(|y| at(y).map(|surface| surface.kappa)).collect()
    };
    let (flat, bent) = (curvatures(&moving, 0.0), curvatures(&moving, 2.0));
    assert!(flat.iter().flatten().all(|kappa| kappa.abs() < 1e-4), "{flat:?}");
    let expected = curvatures(&still, 0.0);
    assert!(expected.iter().flatten().any(|kappa| kappa.abs() > 0.2), "it is bent: {expected:?}");
    assert!(bent.iter().flatten().count() > 5, "it is seen: {bent:?}");
    for (bent, expected) in bent.iter().zip(&expected) {
        assert_eq!(bent.is_some(), expected.is_some());
        let off = bent.unwrap_or(0.0) - expected.unwrap_or(0.0);
        assert!(off.abs() < 1e-2, "{bent:?} is not {expected:?}");
    }
}

#[test]
fn the_pose_at_rest_is_the_mesh_at_rest() {
    let mesh = read(&bending_bar()).value;
    let still = mesh.posed(&mesh.motion.as_ref().unwrap().pose(None));
    assert_eq!(still.positions, mesh.positions);
    for vertex in 0..mesh.positions.len() {
        let off = Vec3::from(still.normals[vertex]).distance(mesh.normals[vertex].into());
        let tangents = [&still, &mesh].map(|mesh| Vec3::from_slice(&mesh.tangents[vertex]));
        assert!(off < 1e-6 && tangents[0].distance(tangents[1]) < 1e-6, "{vertex}");
    }
}

/// A triangle in a node that turns, moves and grows by curves of each kind.
#[test]
fn nodes_move_by_every_interpolation() {
    let file = |path: &str, kind: &str, interpolation: &str, values: &[f32]| {
        let mut numbers = GltfNumbers::default();
        let points = numbers.floats("VEC3", &[0., 0., 0., 1., 0., 0., 0., 1., 0.]);
        let normals = numbers.floats("VEC3", &[0., 0., 1., 0., 0., 1., 0., 0., 1.]);
        let times = numbers.floats("SCALAR", &[1.0, 2.0]);
        let values = numbers.floats(kind, values);
        numbers.file(json!({
            "nodes": [{"children": [1], "scale": [2, 2, 2]}, {"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": points, "NORMAL": normals}}]}],
            "animations": [{"channels": [{"sampler": 0, "target": {"node": 1, "path": path}}],
                "samplers": [{"input": times, "output": values,
                    "interpolation": interpolation}]}],
        }))
    };
    let of = |path: &str, kind: &str, interpolation: &str, values: &[f32]| {
        let WithWarnings { value: mesh, warnings } = read(&file(path, kind, interpolation, values));
        assert!(warnings.is_empty(), "{warnings:?}");
        move |time: f64| {
            let posed = at(&mesh, time);
            (posed.positions[1], posed.normals[1], posed.tangents[1])
        }
    };
    let moves = [0., 0., 0., 0., 4., 0.];
    let linear = of("translation", "VEC3", "LINEAR", &moves);
    assert_near(linear(1.25).0, [2.0, 2.0, 0.0]);
    assert_near(linear(0.0).0, [2.0, 0.0, 0.0]);
    assert_near(linear(9.0).0, [2.0, 8.0, 0.0]);
    let step = of("translation", "VEC3", "STEP", &moves);
    assert_near(step(1.99).0, [2.0, 0.0, 0.0]);
    assert_near(step(2.0).0, [2.0, 8.0, 0.0]);
    // Halfway between 0 and 4 with tangents of 8 and 0: 2 + (8 - 0) / 8.
    let spline =
        [[0.; 3], [0.; 3], [0., 8., 0.], [0.; 3], [0., 4., 0.], [0.; 3]].as_flattened().to_vec();
    let cubic = of("translation", "VEC3", "CUBICSPLINE", &spline);
    assert_near(cubic(1.5).0, [2.0, 6.0, 0.0]);
    // A quarter turn about y takes x to -z, and the normal z to x. The level tangent goes along.
    let quarter = std::f32::consts::FRAC_1_SQRT_2;
    let turned = of("rotation", "VEC4", "LINEAR", &[0., 0., 0., 1., 0., quarter, 0., quarter]);
    let (place, normal, tangent) = turned(2.0);
    assert_near(place, [0.0, 0.0, -2.0]);
    assert_near(normal, [1.0, 0.0, 0.0]);
    assert_near([tangent[0], tangent[1], tangent[2]], [0.0, 0.0, -1.0]);
    let grown = of("scale", "VEC3", "LINEAR", &[1., 1., 1., 3., 1., 0.]);
    assert_near(grown(1.5).0, [4.0, 0.0, 0.0]);
    assert_near(grown(2.0).1, [0.0, 0.0, 1.0]);
}

#[test]
fn morphs_add_their_targets() {
    let mut numbers = GltfNumbers::default();
    let points = numbers.floats("VEC3", &[0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.]);
    let normals = numbers.floats("VEC3", &[0.0, 0.0, 1.0].repeat(4));
    let indices = numbers.indices(&[0, 1, 2, 0, 2, 3]);
    let rise = numbers.floats("VEC3", &[0., 0., 0., 0., 0., 0., 0., 0., 2., 0., 0., 0.]);
    let lean = numbers.floats("VEC3", &[0.0, 1.0, -1.0].repeat(4));
    let wide = numbers.floats("VEC3", &[0., 0., 0., 4., 0., 0., 4., 0., 0., 0., 0., 0.]);
    let times = numbers.floats("SCALAR", &[0.0, 1.0]);
    let weights = numbers.floats("SCALAR", &[0.25, 0.0, 1.0, 0.5]);
    let file = numbers.file(json!({
        "nodes": [{"mesh": 0, "weights": [0.5, 0.25]}],
        "meshes": [{"weights": [9, 9], "primitives": [{
            "attributes": {"POSITION": points, "NORMAL": normals}, "indices": indices,
            "targets": [{"POSITION": rise, "NORMAL": lean}, {"POSITION": wide}]}]}],
        "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
            "samplers": [{"input": times, "output": weights}]}],
    }));
    let WithWarnings { value: mesh, warnings } = read(&file);
    assert!(warnings.is_empty(), "{warnings:?}");
    // At rest the node's weights count: half of the first, a quarter of the second.
    assert_near(mesh.positions[2], [2.0, 1.0, 1.0]);
    let posed = at(&mesh, 0.5);
    assert_near(posed.positions[2], [2.0, 1.0, 1.25]);
    assert_near(posed.positions[1], [2.0, 0.0, 0.0]);
    let normal = DVec3::new(0.0, 0.625, 0.375).normalize();
    assert_near(posed.normals[0], normal.to_array());
}

#[test]
fn cameras_stand_where_their_nodes_do() {
    let file = bar(DQuat::IDENTITY, |_, members| {
        members["cameras"] = json!([
            {"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 1}},
            {"type": "orthographic", "name": "plan",
                "orthographic": {"xmag": 3, "ymag": 2, "znear": 0, "zfar": 9}},
        ]);
        members["nodes"][2]["camera"] = json!(0);
        members["nodes"][1]["camera"] = json!(1);
    });
    let mesh = read(&file).value;
    let motion = mesh.motion.as_ref().unwrap();
    let names: Vec<&str> = motion.cameras().iter().map(|camera| camera.name.as_str()).collect();
    assert_eq!(names, ["plan", "upper"]);
    let (lens, node) = motion.camera("upper").unwrap();
    assert_eq!(lens, CameraLens::Perspective { fov: 0.7, aspect: 1.5 });
    assert_eq!(motion.pose(None).node(node).w_axis.truncate(), DVec3::Y);
    let plan = CameraLens::Orthographic { half_width: 3.0, half_height: 2.0 };
    assert_eq!(motion.camera("").unwrap().0, plan);
    assert_eq!(motion.camera("side"), None);
}

/// Wrong motion is told and left out; the triangles are there.
#[test]
fn wrong_motion_is_left_out_with_a_warning() {
    type Change = fn(&mut GltfNumbers, &mut Value);
    let cases: [(&str, Change); 13] = [
        ("a time of it is not finite", |numbers, members| {
            let times = numbers.floats("SCALAR", &[0.0, f32::NAN]);
            members["animations"][0]["samplers"][0]["input"] = times.into();
        }),
        ("its times do not grow", |numbers, members| {
            let times = numbers.floats("SCALAR", &[1.0, 0.5]);
            members["animations"][0]["samplers"][0]["input"] = times.into();
        }),
        ("it has not one value for each time", |numbers, members| {
            let times = numbers.floats("SCALAR", &[0.0, 0.5, 1.0]);
            members["animations"][0]["samplers"][0]["input"] = times.into();
        }),
        ("curves have more than", |numbers, members| {
            numbers.accessors.push(json!({"type": "SCALAR", "componentType": 5126,
                "count": 4_000_000_000_u32}));
            members["animations"][0]["samplers"][0]["input"] = (numbers.accessors.len() - 1).into();
        }),
        ("there is no accessor 99", |_, members| {
            members["animations"][0]["samplers"][0]["input"] = 99.into();
        }),
        ("`pointer` cannot be moved", |_, members| {
            members["animations"][0]["channels"][0]["target"]["path"] = "pointer".into();
        }),
        ("there is no node 9", |_, members| {
            members["animations"][0]["channels"][0]["target"]["node"] = 9.into();
        }),
        ("there is no sampler 3", |_, members| {
            members["animations"][0]["channels"][0]["sampler"] = 3.into();
        }),
        ("its joint 9 is no node", |_, members| {
            members["skins"][0]["joints"][1] = 9.into();
        }),
        ("fewer bind matrices than joints", |_, members| {
            members["skins"][0]["joints"] = json!([1, 2, 1]);
        }),
        ("names joint 1; there are 1", |_, members| {
            members["skins"][0] = json!({"joints": [1]});
        }),
        ("were scaled", |numbers, members| {
            let weights = numbers.floats("VEC4", &[0.5, 0.25, 0.0, 0.0].repeat(15));
            members["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = weights.into();
        }),
        ("animations and cameras are left out", |_, members| {
            members["animations"] = json!([{"channels": 7}]);
        }),
    ];
    for (expected, change) in cases {
        let WithWarnings { value: mesh, warnings } = read(&bar(DQuat::IDENTITY, change));
        let told: Vec<&Diagnostic> =
            warnings.iter().filter(|warning| warning.code == "mesh-animation").collect();
        assert_eq!(told.len(), 1, "{expected}: {warnings:?}");
        assert!(told[0].message.contains(expected), "{expected}: {told:?}");
        assert_eq!(mesh.triangle_count(), 16, "{expected}");
        if let Some(motion) = &mesh.motion {
            let animation = motion.animations().first().map(|animation| (animation, 1.0));
            let posed = mesh.posed(&motion.pose(animation));
            assert!(posed.positions.iter().flatten().all(|x| x.is_finite()), "{expected}");
        }
    }
}

/// Poses beyond all numbers leave a mesh that can be drawn.
#[test]
fn a_pose_beyond_all_bounds_stays_within_them() {
    let far = |scale: f32| {
        let file = bar(DQuat::IDENTITY, |numbers, members| {
            let scales = numbers.floats("VEC3", &[[1.0; 3], [scale; 3]].concat());
            members["animations"][0]["channels"][0]["target"]["path"] = "scale".into();
            members["animations"][0]["samplers"][0]["output"] = scales.into();
        });
        at(&read(&file).value, 2.0)
    };
    for scale in [0.0, 1e-38, -1e30, 3e38] {
        let mesh = far(scale);
        assert!(mesh.positions.iter().flatten().all(|x| x.abs() <= 2e12), "{scale}");
        for (normal, tangent) in mesh.normals.iter().zip(&mesh.tangents) {
            assert!((Vec3::from(*normal).length() - 1.0).abs() < 1e-5, "{scale}: {normal:?}");
            let length = Vec3::from_slice(tangent).length();
            assert!((length - 1.0).abs() < 1e-5, "{scale}: {tangent:?}");
        }
    }
}

#[test]
fn equal_poses_are_known_by_their_hash() {
    let mesh = read(&bending_bar()).value;
    let motion = mesh.motion.as_ref().unwrap();
    let hash = |time| motion.surface_hash(&motion.pose(Some((&motion.animations()[0], time))));
    assert_eq!(hash(2.0), hash(99.0));
    assert_eq!(hash(-1.0), motion.surface_hash(&motion.pose(None)));
    assert_ne!(hash(1.0), hash(1.001));
}
