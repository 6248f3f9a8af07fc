//! Features of the Khronos Group's sample assets in files of our own that are made here, each
//! against the same computed anew from the specification (`khr_assets`): SimpleSkin, SimpleMorph,
//! AnimatedMorphCube, MorphStressTest, RiggedSimple, RiggedFigure, CesiumMan, BoxAnimated,
//! InterpolationTest, RecursiveSkeletons, AnimatedTriangle, SimpleSparseAccessor and Cameras.

use chiaro::geometry::{import, no_siblings};
use serde_json::{Value, json};

use crate::gltf_truth::GltfTruth;
use crate::khr_assets::{ComparedCounts, compare};
use crate::motion::{GltfNumbers, bending_bar};

const BYTE: u32 = 5120;
const UNSIGNED_BYTE: u32 = 5121;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const FLOAT: u32 = 5126;

/// Compares a file of our own, all of which is read.
#[track_caller]
fn equal(file: &str) -> ComparedCounts {
    let read = import("x.gltf", file.as_bytes(), &no_siblings);
    let read = read.unwrap_or_else(|problems| panic!("{problems:#?}\n{file}"));
    let left_out = read.warnings.iter().find(|warning| warning.code == "mesh-animation");
    assert!(left_out.is_none(), "{left_out:?}");
    let truth = GltfTruth::read(file.as_bytes(), &|name| Err(name.to_owned()));
    let truth = truth.unwrap_or_else(|why| panic!("{why}\n{file}"));
    compare(&read.value, &truth).unwrap_or_else(|why| panic!("{why}\n{file}"))
}

/// Numbers between -1 and 1 without a pattern, the same in every run.
fn wave(index: usize) -> f32 {
    (1.7 * index as f32 + 0.3).sin()
}

/// Numbers as components of a type; floats stay, all others are of a whole.
fn packed(kind: u32, numbers: &[f32]) -> Vec<u8> {
    let one = |number: &f32| match kind {
        BYTE => ((127.0 * number).round() as i8).to_le_bytes().to_vec(),
        UNSIGNED_BYTE => ((255.0 * number).round() as u8).to_le_bytes().to_vec(),
        SHORT => ((32767.0 * number).round() as i16).to_le_bytes().to_vec(),
        UNSIGNED_SHORT => ((65535.0 * number).round() as u16).to_le_bytes().to_vec(),
        _ => number.to_le_bytes().to_vec(),
    };
    numbers.iter().flat_map(one).collect()
}

impl GltfNumbers {
    /// Adds an accessor of numbers, normalized if they are whole.
    fn packed(&mut self, kind: &str, width: usize, component: u32, numbers: &[f32]) -> usize {
        let bytes = packed(component, numbers);
        let accessor = self.add(kind, component, numbers.len() / width, &bytes);
        if component != FLOAT {
            self.accessors[accessor]["normalized"] = true.into();
        }
        accessor
    }

    /// Adds a wavy sheet of two columns and of as many rows that stands up, half a unit high each,
    /// with normals: its primitive, and the number of its points.
    fn sheet(&mut self, rows: u16) -> (Value, usize) {
        let (mut points, mut normals, mut triangles) = (vec![], vec![], vec![]);
        for row in 0..=rows {
            for side in 0..3_u16 {
                let point = usize::from(3 * row + side);
                points.extend([0.5 * f32::from(side) - 0.5, 0.5 * f32::from(row)]);
                points.push(0.2 * wave(point));
                normals.extend([0.3 * wave(point + 7), 0.3 * wave(point + 11), 1.0]);
                if row > 0 && side > 0 {
                    let corner = 3 * row + side;
                    let [left, below] = [corner - 1, corner - 3];
                    triangles.extend([below - 1, below, corner, below - 1, corner, left]);
                }
            }
        }
        let attributes = json!({"POSITION": self.floats("VEC3", &points),
            "NORMAL": self.floats("VEC3", &normals)});
        let primitive = json!({"attributes": attributes, "indices": self.indices(&triangles)});
        (primitive, points.len() / 3)
    }

    /// Adds a sampler of values at so many keys, half a second apart, and gives it.
    fn sampler(&mut self, keys: usize, values: usize, interpolation: &str) -> Value {
        let times: Vec<f32> = (0..keys).map(|key| 0.25 + 0.5 * key as f32).collect();
        let input = self.floats("SCALAR", &times);
        json!({"input": input, "output": values, "interpolation": interpolation})
    }
}

/// Quaternions of turns that follow one another, four numbers each, of length 1.
fn turns(count: usize, first: usize) -> Vec<f32> {
    let turn = |index: usize| {
        let axis = glam::Vec3::new(wave(index), wave(index + 3), wave(index + 5)).normalize();
        glam::Quat::from_axis_angle(axis, 1.2 * wave(index + 8)).to_array()
    };
    (first..first + count).flat_map(turn).collect()
}

fn identity(translation: [f32; 3]) -> [f32; 16] {
    let mut matrix = glam::Mat4::IDENTITY;
    matrix.w_axis = glam::Vec3::from(translation).extend(1.0);
    matrix.to_cols_array()
}

/// SimpleSkin: a skin of two joints, whose mesh has no normals.
#[test]
fn a_simple_skin() {
    let told = equal(&bending_bar());
    assert_eq!((told.animations, told.triangles), (1, 16));
    assert!(told.poses > 10 && told.vectors[2] > 100 && told.vectors[3] > 100, "{told}");
}

/// RiggedSimple, RiggedFigure, CesiumMan: a line of joints under a node with a matrix, each with
/// curves of all three kinds; joints and weights of every type, and more than four to a vertex.
#[test]
fn a_rigged_figure() {
    const JOINTS: usize = 6;
    for (joint_type, weight_type, sets) in [
        (UNSIGNED_BYTE, FLOAT, 1),
        (UNSIGNED_SHORT, UNSIGNED_BYTE, 1),
        (UNSIGNED_SHORT, UNSIGNED_SHORT, 1),
        (UNSIGNED_BYTE, FLOAT, 2),
    ] {
        let mut numbers = GltfNumbers::default();
        let (mut primitive, count) = numbers.sheet(6);
        for set in 0..sets {
            let (mut joints, mut weights) = (Vec::new(), Vec::new());
            for point in 0..count {
                let share = ((point * 37 % 100) as f32 / 255.0 + 0.2) / f32::from(sets as u8);
                let rest = 1.0 / f32::from(sets as u8) - share;
                weights.extend([share, rest, 0.0, 0.0]);
                let joint = point / 4 + 2 * set;
                joints.extend([joint % JOINTS, (joint + 1) % JOINTS, 0, 0]);
            }
            let bytes: Vec<u8> = match joint_type {
                UNSIGNED_BYTE => joints.iter().map(|joint| *joint as u8).collect(),
                _ => joints.iter().flat_map(|joint| (*joint as u16).to_le_bytes()).collect(),
            };
            let joints = numbers.add("VEC4", joint_type, count, &bytes);
            let weights = numbers.packed("VEC4", 4, weight_type, &weights);
            primitive["attributes"][format!("JOINTS_{set}")] = joints.into();
            primitive["attributes"][format!("WEIGHTS_{set}")] = weights.into();
        }
        let binds: Vec<f32> =
            (0..JOINTS).flat_map(|joint| identity([0.0, -0.5 * joint as f32, 0.0])).collect();
        let binds = numbers.floats("MAT4", &binds);
        // Node 0 stands z up, as exporters do it; joints are nodes 1 to 6, and the mesh is node 7.
        let up = [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1];
        let mut nodes = vec![json!({"matrix": up, "children": [1]})];
        let (mut samplers, mut channels) = (Vec::new(), Vec::new());
        for joint in 1..=JOINTS {
            nodes.push(json!({"translation": [0.0, 0.5, 0.1]}));
            if joint < JOINTS {
                nodes[joint]["children"] = json!([joint + 1]);
            }
            let [moves, scales] = [7, 40].map(|first| {
                let value = |index: usize| 0.1 * wave(index + first * joint);
                (0..9).map(value).collect::<Vec<f32>>()
            });
            let scales: Vec<f32> = scales.iter().map(|scale| 1.0 + scale).collect();
            let values = [
                numbers.floats("VEC3", &moves),
                numbers.floats("VEC4", &turns(3, 5 * joint)),
                numbers.floats("VEC3", &scales),
            ];
            for (path, values) in ["translation", "rotation", "scale"].into_iter().zip(values) {
                channels.push(json!({"sampler": samplers.len(),
                    "target": {"node": joint, "path": path}}));
                samplers.push(numbers.sampler(3, values, "LINEAR"));
            }
        }
        nodes.push(json!({"mesh": 0, "skin": 0}));
        let told = equal(&numbers.file(json!({
            "scene": 0, "scenes": [{"nodes": [0, 7]}], "nodes": nodes,
            "meshes": [{"primitives": [primitive]}],
            "skins": [{"joints": [1, 2, 3, 4, 5, 6], "inverseBindMatrices": binds,
                "skeleton": 1}],
            "animations": [{"channels": channels, "samplers": samplers}],
        })));
        assert_eq!(told.triangles, 24);
        assert!(told.vectors[0] > 500, "{told}");
    }
}

/// BoxAnimated: nodes in nodes, of which the outer and the inner ones move; one has a matrix, and
/// one mirrors what is in it.
#[test]
fn boxes_in_nodes() {
    let mut numbers = GltfNumbers::default();
    let (primitive, _) = numbers.sheet(2);
    let moves = numbers.floats("VEC3", &[0., 0., 0., 0., 2.5, 0., 0., 0., 1.]);
    let spins = numbers.floats("VEC4", &turns(4, 20));
    let samplers = [numbers.sampler(3, moves, "LINEAR"), numbers.sampler(4, spins, "LINEAR")];
    let placed = [0.6, 0.0, -0.8, 0.0, 0.0, 1.5, 0.0, 0.0, 0.8, 0.0, 0.6, 0.0, 3.0, -1.0, 2.0, 1.0];
    let told = equal(&numbers.file(json!({
        "nodes": [
            {"children": [1, 2], "translation": [1.5, 0.0, -2.0], "scale": [2.0, 0.5, 1.0]},
            {"mesh": 0, "children": [3], "rotation": [0.0, 0.6, 0.0, 0.8]},
            {"children": [4], "matrix": placed},
            {"mesh": 0, "scale": [1.0, -1.0, 1.0], "translation": [0.0, 0.25, 4.0]},
            {"mesh": 0, "translation": [0.5, 0.5, 0.5]},
        ],
        "meshes": [{"primitives": [primitive]}],
        "animations": [{"channels": [
                {"sampler": 0, "target": {"node": 0, "path": "translation"}},
                {"sampler": 1, "target": {"node": 1, "path": "rotation"}},
                {"sampler": 1, "target": {"node": 4, "path": "rotation"}}],
            "samplers": samplers}],
    })));
    assert_eq!((told.triangles, told.left_out), (24, 0));
}

/// InterpolationTest: an animation for each property and each way between its keys, and for each
/// type of number that rotations and weights may be stored in.
#[test]
fn all_interpolations() {
    let mut numbers = GltfNumbers::default();
    let (mut primitive, count) = numbers.sheet(1);
    let change: Vec<f32> = (0..3 * count).map(wave).collect();
    primitive["targets"] = json!([{"POSITION": numbers.floats("VEC3", &change)}]);
    let (mut nodes, mut animations) = (Vec::new(), Vec::new());
    let signed = [FLOAT, BYTE, SHORT];
    let cases: [(&str, &str, &[u32]); 4] = [
        ("translation", "VEC3", &[FLOAT]),
        ("scale", "VEC3", &[FLOAT]),
        ("rotation", "VEC4", &signed),
        ("weights", "SCALAR", &[FLOAT, BYTE, SHORT, UNSIGNED_BYTE, UNSIGNED_SHORT]),
    ];
    for (path, kind, types) in cases {
        for interpolation in ["STEP", "LINEAR", "CUBICSPLINE"] {
            for &component in types {
                let width = match kind {
                    "SCALAR" => 1,
                    "VEC3" => 3,
                    _ => 4,
                };
                let per_key = if interpolation == "CUBICSPLINE" { 3 } else { 1 };
                let values: Vec<f32> = match path {
                    "rotation" => turns(4 * per_key, 9 * nodes.len()),
                    _ => (0..4 * per_key * width).map(|n| 0.5 + 0.4 * wave(n)).collect(),
                };
                let values = numbers.packed(kind, width, component, &values);
                let name = format!("{path} {interpolation} {component}");
                animations.push(json!({"name": name,
                    "channels": [{"sampler": 0, "target": {"node": nodes.len(), "path": path}}],
                    "samplers": [numbers.sampler(4, values, interpolation)]}));
                nodes.push(json!({"mesh": 0, "translation": [nodes.len(), 0, 0]}));
            }
        }
    }
    let count = animations.len();
    let told = equal(&numbers.file(json!({"nodes": nodes, "animations": animations,
        "meshes": [{"primitives": [primitive], "weights": [0.5]}]})));
    assert_eq!((told.animations, count), (30, 30));
}

/// SimpleMorph, AnimatedMorphCube and MorphStressTest: eight targets at once in two primitives,
/// some of which change normals and tangents too, one only them, and one a few points of many.
#[test]
fn many_morph_targets() {
    const TARGETS: usize = 8;
    let mut numbers = GltfNumbers::default();
    let (mut first, count) = numbers.sheet(3);
    let tangents: Vec<f32> =
        (0..count).flat_map(|n| [1.0, 0.1 * wave(n), 0.1, [1.0, -1.0][n % 2]]).collect();
    first["attributes"]["TANGENT"] = numbers.floats("VEC4", &tangents).into();
    let (mut second, more) = numbers.sheet(1);
    let mut changes = |count: usize, target: usize| {
        let change = |n: usize| 0.3 * wave(n + 31 * target);
        numbers.floats("VEC3", &(0..3 * count).map(change).collect::<Vec<f32>>())
    };
    let mut targets: Vec<Value> =
        (0..TARGETS).map(|target| json!({"POSITION": changes(count, target)})).collect();
    targets[1]["NORMAL"] = changes(count, 11).into();
    targets[2] = json!({"NORMAL": changes(count, 12), "TANGENT": changes(count, 13)});
    targets[3]["TANGENT"] = changes(count, 14).into();
    first["targets"] = targets.into();
    let of_second = (0..TARGETS).map(|target| json!({"POSITION": changes(more, target + 20)}));
    second["targets"] = of_second.collect::<Vec<_>>().into();
    // A sparse target: nothing but the third and the last point.
    let places = numbers.indices(&[2, count as u16 - 1]);
    let values = numbers.floats("VEC3", &[0.0, 1.0, 0.5, -0.5, 0.0, 2.0]);
    let [places, values] =
        [places, values].map(|index| numbers.accessors[index]["bufferView"].clone());
    numbers.accessors.push(json!({"type": "VEC3", "componentType": FLOAT, "count": count,
        "sparse": {"count": 2, "values": {"bufferView": values},
            "indices": {"bufferView": places, "componentType": UNSIGNED_SHORT}}}));
    first["targets"][4]["POSITION"] = (numbers.accessors.len() - 1).into();
    let values: Vec<f32> = (0..3 * TARGETS).map(|n| wave(n + 2).max(0.0)).collect();
    let values = numbers.floats("SCALAR", &values);
    let samplers = [numbers.sampler(3, values, "LINEAR")];
    let told = equal(&numbers.file(json!({
        "nodes": [{"mesh": 0}, {"mesh": 0, "weights": [0.0, 1.0, 0.5, 0.0, 0.25, 0.0, 0.0, 0.125],
            "rotation": [0.6, 0.0, 0.0, 0.8], "scale": [1.0, 2.0, 1.0]}],
        "meshes": [{"primitives": [first, second], "weights": [0.5, 0, 0, 0, 1, 0, 0, 0]}],
        "animations": [
            {"name": "all", "samplers": samplers,
                "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}},
                    {"sampler": 0, "target": {"node": 1, "path": "weights"}}]},
            {"name": "one", "samplers": samplers,
                "channels": [{"sampler": 0, "target": {"node": 1, "path": "weights"}}]}],
    })));
    assert_eq!((told.animations, told.triangles), (2, 32));
    assert!(told.vectors[0] > 1000 && told.vectors[1] > 500, "{told}");
}

/// RecursiveSkeletons: skins that share a joint, of which one has no bind matrices; a skinned mesh
/// stands in its own joint, which moves it once and not twice, and has a joint of the other in it.
#[test]
fn skeletons_in_skeletons() {
    let mut numbers = GltfNumbers::default();
    let (mut primitive, count) = numbers.sheet(4);
    let joints: Vec<u8> = (0..count).flat_map(|n| [(n % 2) as u8, 1, 0, 0]).collect();
    let weights: Vec<f32> = (0..count)
        .map(|n| n as f32 / count as f32)
        .flat_map(|share| [share, 1.0 - share, 0.0, 0.0])
        .collect();
    let joints = numbers.add("VEC4", UNSIGNED_BYTE, count, &joints);
    primitive["attributes"]["JOINTS_0"] = joints.into();
    primitive["attributes"]["WEIGHTS_0"] = numbers.floats("VEC4", &weights).into();
    let binds = [identity([0.0, -0.5, 0.0]), identity([0.2, -1.0, 0.0])];
    let binds = numbers.floats("MAT4", binds.as_flattened());
    let values = [1, 50, 90].map(|first| numbers.floats("VEC4", &turns(3, first)));
    let samplers = values.map(|values| numbers.sampler(3, values, "LINEAR"));
    let told = equal(&numbers.file(json!({
        "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [
            {"children": [1], "translation": [4.0, 0.0, 0.0], "rotation": [0.0, 0.0, 0.6, 0.8]},
            {"children": [2, 4], "translation": [0.0, 0.5, 0.0]},
            {"children": [3], "translation": [0.0, 0.5, 0.0]},
            {"mesh": 0, "skin": 0, "translation": [9.0, 9.0, 9.0]},
            {"mesh": 0, "skin": 1, "children": [5], "scale": [2.0, 2.0, 2.0]},
            {"translation": [-1.0, 0.25, 0.5], "scale": [1.0, 0.5, 1.0]},
        ],
        "meshes": [{"primitives": [primitive]}],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": binds}, {"joints": [5, 2]}],
        "animations": [{"samplers": samplers, "channels": [
            {"sampler": 0, "target": {"node": 1, "path": "rotation"}},
            {"sampler": 1, "target": {"node": 2, "path": "rotation"}},
            {"sampler": 2, "target": {"node": 4, "path": "rotation"}}]}],
    })));
    assert_eq!(told.triangles, 32);
}

/// AnimatedTriangle: neither indices nor normals, and keys of a whole turn; and Cameras, which
/// stand in the node that turns.
#[test]
fn a_turning_triangle_with_cameras() {
    let mut numbers = GltfNumbers::default();
    let points = numbers.floats("VEC3", &[0., 0., 0., 1., 0., 0., 0., 1., 0.]);
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let turns = [0., 0., 0., 1., 0., 0., half, half, 0., 0., 1., 0., 0., 0., half, -half];
    let turns = numbers.floats("VEC4", &[&turns[..], &[0., 0., 0., 1.]].concat());
    let samplers = [numbers.sampler(5, turns, "LINEAR")];
    let told = equal(&numbers.file(json!({
        "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [
            {"mesh": 0, "children": [1, 2], "rotation": [0, 0, 0, 1]},
            {"camera": 0, "name": "near", "translation": [0.5, 0.5, 3.0]},
            {"camera": 1, "name": "plan", "rotation": [-0.6, 0.0, 0.0, 0.8]},
        ],
        "cameras": [
            {"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}},
            {"type": "orthographic",
                "orthographic": {"xmag": 1.0, "ymag": 1.0, "znear": 0.0, "zfar": 9.0}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": points}}]}],
        "animations": [{"samplers": samplers,
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}]}],
    })));
    assert_eq!((told.animations, told.triangles), (1, 1));
}

/// SimpleSparseAccessor, strips and fans: points that lie among others, some of which a sparse
/// accessor moves, in the three ways of making triangles, within a node that moves.
#[test]
fn sparse_points_in_strips_and_fans() {
    let mut numbers = GltfNumbers::default();
    // Rows of a place and two numbers more, 20 bytes each.
    let rows: Vec<f32> = (0..7)
        .flat_map(|n| {
            let (column, row) = ((n % 2) as f32, (n / 2) as f32);
            [column, row, 0.2 * wave(n), 9.0, 9.0]
        })
        .collect();
    let points = numbers.add("VEC3", FLOAT, 7, &packed(FLOAT, &rows));
    let view = numbers.accessors[points]["bufferView"].as_u64().expect("a view") as usize;
    numbers.views[view]["byteStride"] = 20.into();
    let places = numbers.add("SCALAR", UNSIGNED_BYTE, 2, &[1, 6]);
    let values = numbers.floats("VEC3", &[1.5, -0.25, 0.5, 0.25, 3.5, -0.5]);
    let [places, values] =
        [places, values].map(|index| numbers.accessors[index]["bufferView"].clone());
    numbers.accessors[points]["sparse"] = json!({"count": 2, "values": {"bufferView": values},
        "indices": {"bufferView": places, "componentType": UNSIGNED_BYTE}});
    let order = numbers.indices(&[3, 1, 0, 2, 4, 5]);
    let moves = numbers.floats("VEC3", &(0..18).map(wave).collect::<Vec<f32>>());
    let samplers = [numbers.sampler(2, moves, "CUBICSPLINE")];
    let primitive = |mode: u32| json!({"attributes": {"POSITION": points}, "mode": mode});
    let mut primitives = [4, 5, 6].map(primitive);
    primitives[2]["indices"] = order.into();
    let told = equal(&numbers.file(json!({
        "nodes": [{"mesh": 0, "scale": [-1, 1, 1]}],
        "meshes": [{"primitives": primitives}],
        "animations": [{"samplers": samplers,
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
    })));
    assert_eq!((told.triangles, told.left_out), (2 + 5 + 4, 0));
}
