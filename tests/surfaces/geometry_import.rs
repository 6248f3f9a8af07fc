//! Small mesh files of every format: whole, wrong and cut short.

use std::io::Cursor;

use crate::motion::bending_bar;
use crate::support::cases::hold;
use chiaro::diag::{Diagnostic, LineColumn, WithWarnings};
use chiaro::files::Disk;
use chiaro::geometry::{Mesh, Siblings, import, load, no_siblings};
use chiaro::library::MAX_COORDINATE;
use glam::{Vec3, Vec4};
use proptest::prelude::*;

fn read(name: &str, bytes: impl AsRef<[u8]>) -> WithWarnings<Mesh> {
    import(name, bytes.as_ref(), &no_siblings)
        .unwrap_or_else(|problems| panic!("{name}: {problems:#?}"))
}

fn errors(name: &str, bytes: impl AsRef<[u8]>) -> Vec<Diagnostic> {
    let problems = import(name, bytes.as_ref(), &no_siblings).expect_err("this file is wrong");
    assert!(problems.iter().any(Diagnostic::is_error));
    assert!(problems.iter().all(|p| p.place.file.as_deref() == Some(name)), "{problems:#?}");
    problems
}

/// Diagnostics of small wrong files: `tests/cases/mesh`.
#[test]
fn wrong_files() {
    hold("mesh", |name, bytes| match import(name, bytes, &no_siblings) {
        Ok(imported) => (true, imported.warnings),
        Err(problems) => {
            assert!(problems.iter().any(Diagnostic::is_error), "{name}: {problems:#?}");
            let is_placed = |p: &Diagnostic| p.place.file.as_deref() == Some(name);
            assert!(problems.iter().all(is_placed), "{name}: {problems:#?}");
            (false, problems)
        }
    });
}

/// Numbers of a mesh that shaders are promised are refused or clamped, whatever attribute has them.
#[test]
fn numbers_of_attributes_are_those_that_shaders_are_promised() {
    let obj = |v: &str, vt: &str, vn: &str| {
        format!(
            "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv {v}\nvt 0 0\nvt {vt}\nvn 0 0 1\nvn {vn}\n\
                 f 1/1/1 2/1/1 3/2/2\n"
        )
    };
    let ply = |vertex: &str| {
        let properties = ["x", "y", "z", "nx", "ny", "nz", "s", "t", "red", "green", "blue"];
        let properties: String =
            properties.iter().map(|name| format!("property float {name}\n")).collect();
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\n{properties}element face 1\n\
                 property list uchar int vertex_index\nend_header\n\
                 0 0 0 0 0 1 0 0 1 1 1\n1 0 0 0 0 1 0 0 1 1 1\n{vertex}\n3 0 1 2\n"
        )
    };
    for none in ["nan", "inf", "-inf", "1e39"] {
        for file in [
            obj(&format!("0 {none} 0 1 0 0"), "1 1", "0 0 1"),
            obj(&format!("0 1 0 1 {none} 0"), "1 1", "0 0 1"),
            obj("0 1 0 1 0 0", &format!("{none} 1"), "0 0 1"),
            obj("0 1 0 1 0 0", "1 1", &format!("0 0 {none}")),
        ] {
            let problems = errors("x.obj", &file);
            assert_eq!(problems[0].code, "mesh-not-finite", "{file}");
        }
        for place in [1, 4, 6, 8] {
            let mut row = ["0", "1", "0", "0", "0", "1", "1", "1", "1", "0", "0"];
            row[place] = none;
            let file = ply(&row.join(" "));
            let problems = errors("x.ply", &file);
            assert_eq!(problems[0].code, "mesh-not-finite", "{file}");
        }
    }
    for far in ["1e7", "-3e38"] {
        let file = obj(&format!("0 1 0 1 {far} 0"), &format!("1 {far}"), "0 0 1");
        let mesh = read("x.obj", file).value;
        check(&mesh);
        assert!(mesh.uvs.iter().flatten().any(|x| f64::from(x.abs()) == MAX_COORDINATE));
    }
}

fn check(mesh: &Mesh) {
    let count = mesh.positions.len();
    assert_eq!(
        [mesh.normals.len(), mesh.tangents.len(), mesh.uvs.len(), mesh.all_colors().len()],
        [count; 4]
    );
    assert!(mesh.indices.iter().all(|&i| (i as usize) < count));
    let parts: Vec<u32> =
        mesh.parts.iter().flat_map(|p| [p.indices.start, p.indices.end]).collect();
    assert!(parts.chunks(2).zip(parts[2..].chunks(2)).all(|(a, b)| a[1] == b[0]));
    assert_eq!((parts.first(), parts.last()), (Some(&0), Some(&(mesh.indices.len() as u32))));
    let colors = mesh.all_colors();
    for v in 0..count {
        let (normal, tangent) = (Vec3::from(mesh.normals[v]), Vec4::from(mesh.tangents[v]));
        assert!((normal.length() - 1.0).abs() < 1e-5);
        assert!((tangent.truncate().length() - 1.0).abs() < 1e-5);
        assert!(tangent.truncate().dot(normal).abs() < 1e-5);
        assert_eq!(tangent.w.abs(), 1.0);
        assert!(
            mesh.positions[v].iter().chain(&mesh.uvs[v]).chain(&colors[v]).all(|x| x.is_finite())
        );
        let is_far = |x: &f32| f64::from(x.abs()) > MAX_COORDINATE;
        assert!(!mesh.uvs[v].iter().chain(&colors[v]).any(is_far));
    }
}

fn area(mesh: &Mesh) -> f32 {
    let at = |i: u32| Vec3::from(mesh.positions[i as usize]);
    mesh.indices
        .chunks(3)
        .map(|t| (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).length() / 2.0)
        .sum()
}

const CUBE: &str = "\
v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

// --- OBJ

#[test]
fn a_cube_keeps_its_edges() {
    let WithWarnings { value: mesh, warnings: notes } = read("dir/cube.obj", CUBE);
    check(&mesh);
    assert_eq!(mesh.name, "cube");
    assert_eq!((mesh.positions.len(), mesh.triangle_count()), (24, 12));
    for t in mesh.indices.chunks(3) {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| Vec3::from(mesh.positions[i as usize]));
        let face = (b - a).cross(c - a).normalize();
        assert!(face.dot(a) > 0.9, "outwards");
        assert!(t.iter().all(|&i| face.distance(mesh.normals[i as usize].into()) < 1e-6));
    }
    assert!(!mesh.has_uvs && !mesh.has_colors && !mesh.has_normals);
    assert_eq!(notes.iter().map(|n| n.code).collect::<Vec<_>>(), ["mesh-normals-made"]);
}

#[test]
fn a_faceted_ball_becomes_smooth() {
    // A ball of 12 by 24 quads, whose edges bend by 15 degrees.
    let mut text = String::new();
    for j in 0..=12 {
        for i in 0..24 {
            let (a, b) = (f64::from(j) * 15f64.to_radians(), f64::from(i) * 15f64.to_radians());
            let ring = if j % 12 == 0 { 0.0 } else { a.sin() };
            text += &format!("v {} {} {}\n", ring * b.cos(), a.cos(), ring * b.sin());
        }
    }
    for j in 0..12 {
        for i in 0..24 {
            let at = |j: i32, i: i32| j * 24 + i % 24 + 1;
            text +=
                &format!("f {} {} {} {}\n", at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i));
        }
    }
    let WithWarnings { value: mesh, warnings: notes } = read("ball.obj", &text);
    check(&mesh);
    for (p, n) in mesh.positions.iter().zip(&mesh.normals) {
        assert!(Vec3::from(*p).normalize().angle_between(Vec3::from(*n)) < 0.03, "{p:?} {n:?}");
    }
    // At the poles the quads have two equal points, so one of their two triangles has no area.
    assert!(notes[0].message.starts_with("48 of 576 triangles"), "{}", notes[0]);
}

#[test]
fn concave_polygons_materials_and_negative_indices() {
    let text = "\
# an L, then a triangle by negative indices, over two lines
mtllib ignored.mtl
o thing
v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0
usemtl skin tone
f 1 2 3 4 5 6
v 0 0 1\nv 1 0 1\nv 0 1 1
usemtl eyes
f -3 -2 \\
  -1
usemtl skin tone
f 7 8 9
";
    let mesh = read("x.obj", text).value;
    check(&mesh);
    assert_eq!(mesh.name, "thing");
    assert!((area(&mesh) - (5.0 + 0.5 + 0.5)).abs() < 1e-5, "{}", area(&mesh));
    let parts: Vec<_> = mesh.parts.iter().map(|p| (p.material.as_str(), p.indices.len())).collect();
    assert_eq!(parts, [("skin tone", 15), ("eyes", 3)]);
    assert!(mesh.normals.iter().all(|n| n[2] > 0.999));
}

#[test]
fn attributes_of_obj() {
    let text = "\
v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 2
f 1/1/1 2/2/1 3/3/1\n";
    let WithWarnings { value: mesh, warnings: notes } = read("x.obj", text);
    check(&mesh);
    assert!(mesh.has_uvs && mesh.has_colors && mesh.has_normals && notes.is_empty());
    assert_eq!(mesh.colors[2], [0.0, 0.0, 0.5, 1.0]);
    assert_eq!(mesh.uvs, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(mesh.normals, [[0.0, 0.0, 1.0]; 3]);
    assert_eq!(mesh.tangents, [[1.0, 0.0, 0.0, 1.0]; 3]);

    let bytes = text.replace("1 0 0\nv 1", "255 0 0\nv 1").replace("0 1 0\nv 0", "0 51 0\nv 0");
    let colors = read("x.obj", bytes).value.colors;
    assert!(
        colors[0] == [1.0, 0.0, 0.0, 1.0]
            && Vec4::from(colors[1]).distance(Vec4::new(0.0, 0.2, 0.0, 1.0)) < 1e-6
    );
}

#[test]
fn mirrored_uvs_split_vertices() {
    // Two squares beside each other; the texture runs from the middle to either side.
    let text = "\
v -1 0 0\nv 0 0 0\nv 1 0 0\nv -1 1 0\nv 0 1 0\nv 1 1 0\nvt 1 0\nvt 0 0\nvt 1 1\nvt 0 1
f 1/1 2/2 5/4 4/3\nf 2/2 3/1 6/3 5/4\n";
    let mesh = read("x.obj", text).value;
    check(&mesh);
    assert_eq!(mesh.positions.len(), 8);
    for (p, t) in mesh.positions.iter().zip(&mesh.tangents) {
        assert!(t[0].abs() > 0.999);
        if p[0] != 0.0 {
            assert_eq!(
                (t[0].signum(), t[3]),
                (p[0].signum(), p[0].signum()),
                "u grows outwards, v up"
            );
        }
    }
}

#[test]
fn tangents_without_uvs_are_level() {
    let mesh = read("cube.obj", CUBE).value;
    for (n, t) in mesh.normals.iter().zip(&mesh.tangents) {
        assert!(t[1].abs() < 1e-6, "{n:?} {t:?}");
    }
}

#[test]
fn all_mistakes_of_an_obj_are_told_up_to_a_bound() {
    let at = errors("x.obj", "v 0 0 0\n  v 1 0 oh\n")[0].place.at;
    assert_eq!(at, Some(LineColumn { line: 2, column: 9 }));
    // All mistakes are told, up to a bound.
    let two = errors("x.obj", "v 0 a 0\nv 1 0 b\n");
    assert_eq!(two.len(), 2);
    let many = errors("x.obj", "v a b c\n".repeat(1000));
    assert_eq!(many.len(), 21);
    assert!(many[20].message.contains("2980 more"), "{}", many[20]);
}

#[test]
fn degenerate_triangles_are_counted() {
    let text = format!("{CUBE}f 1 1 2\nf 1 2 2 1\n");
    let WithWarnings { value: mesh, warnings: notes } = read("x.obj", text);
    assert_eq!(mesh.triangle_count(), 12);
    assert!(notes[0].message.starts_with("3 of 15 triangles"), "{}", notes[0]);
}

// --- PLY

fn ply_header(format: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\ncomment made by hand\nelement vertex 5\nproperty float \
         x\nproperty double y\n\
         property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty \
         float s\n\
         property float t\nelement edge 1\nproperty int a\nproperty list uchar short more\nelement \
         face 2\n\
         property list uchar int vertex_indices\nproperty uchar flags\nend_header\n"
    )
}

/// A square and a triangle on top of it.
const HOUSE: [[f32; 3]; 5] = [[0., 0., 0.], [2., 0., 0.], [2., 2., 0.], [0., 2., 0.], [1., 3., 0.]];

fn ply_text() -> String {
    let mut text = ply_header("ascii");
    for (i, [x, y, z]) in HOUSE.into_iter().enumerate() {
        text += &format!("{x} {y} {z} 255 {} 0 {} 0.5\n", i * 51, x / 2.0);
    }
    text + "7 2 -1 -2\n4 0 1 2 3 9\n3 3 2 4 9\n"
}

fn ply_binary(big: bool) -> Vec<u8> {
    let mut bytes =
        ply_header(if big { "binary_big_endian" } else { "binary_little_endian" }).into_bytes();
    let mut put = |little: &[u8]| {
        let mut little = little.to_vec();
        if big {
            little.reverse();
        }
        bytes.extend(little);
    };
    for (i, [x, y, z]) in HOUSE.into_iter().enumerate() {
        put(&x.to_le_bytes());
        put(&f64::from(y).to_le_bytes());
        put(&z.to_le_bytes());
        [255, i as u8 * 51, 0].iter().for_each(|c| put(&[*c]));
        put(&(x / 2.0).to_le_bytes());
        put(&0.5f32.to_le_bytes());
    }
    put(&7i32.to_le_bytes());
    put(&[2]);
    put(&(-1i16).to_le_bytes());
    put(&(-2i16).to_le_bytes());
    for face in [&[0, 1, 2, 3][..], &[3, 2, 4]] {
        put(&[face.len() as u8]);
        face.iter().for_each(|i: &i32| put(&i.to_le_bytes()));
        put(&[9]);
    }
    bytes
}

#[test]
fn ply_of_every_encoding_is_the_same_mesh() {
    let text = read("house.ply", ply_text()).value;
    check(&text);
    assert_eq!((text.positions.len(), text.triangle_count()), (5, 3));
    assert!(text.has_colors && text.has_uvs);
    assert!((area(&text) - 5.0).abs() < 1e-6);
    let top = text.positions.iter().position(|p| p[1] == 3.0).unwrap();
    assert_eq!((text.colors[top], text.uvs[top]), ([1.0, 0.8, 0.0, 1.0], [0.5, 0.5]));
    for big in [false, true] {
        assert_eq!(read("house.ply", ply_binary(big)).value, text);
    }
    assert_eq!(read("house.ply", ply_text().replace('\n', "\r\n")).value, text);
    // The format is also known by the file's first bytes.
    assert_eq!(read("house", ply_text()).value, text);
}

#[test]
fn ply_strips_normals_and_corner_uvs() {
    let strips = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float \
                  y\nproperty float z\n\
        property float nx\nproperty float ny\nproperty float nz\nelement tristrips 1\n\
        property list int int vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 \
        1 0 0 0 1\n\
        8 0 1 2 3 -1 0 1 2\n";
    let WithWarnings { value: mesh, warnings: notes } = read("x.ply", strips);
    check(&mesh);
    assert!(mesh.has_normals && notes.is_empty());
    assert_eq!(mesh.indices, [0, 1, 2, 2, 1, 3, 0, 1, 2]);

    let wedges = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float \
                  y\nproperty float z\n\
        element face 1\nproperty list uchar int vertex_index\nproperty list uchar float \
        texcoord\nend_header\n\
        0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0.25 0 1 0 0 1\n";
    let mesh = read("x.ply", wedges).value;
    check(&mesh);
    assert_eq!((mesh.has_uvs, mesh.uvs[0]), (true, [0.25, 0.0]));
}

// --- STL

fn stl_text() -> String {
    let mut text = "solid corner\n".to_owned();
    for [a, b, c] in [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]] {
        let corners = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
        text += " facet normal 0 0 0\n  outer loop\n";
        for i in [a, b, c] {
            let [x, y, z]: [f32; 3] = corners[i];
            text += &format!("   vertex {x:e} {y} {z}\n");
        }
        text += "  endloop\n endfacet\n";
    }
    text + "endsolid corner\n"
}

fn stl_binary() -> Vec<u8> {
    let mut bytes = [&b"solid binary, in spite of the word"[..], &[b' '; 46]].concat();
    bytes.extend(4u32.to_le_bytes());
    let text = stl_text();
    let mut numbers = text
        .lines()
        .filter_map(|l| l.trim().strip_prefix("vertex "))
        .flat_map(str::split_whitespace);
    for _ in 0..4 {
        bytes.extend([0; 12]);
        for _ in 0..9 {
            bytes.extend(numbers.next().unwrap().parse::<f32>().unwrap().to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn stl_of_either_kind_is_the_same_mesh() {
    let text = read("x.stl", stl_text()).value;
    check(&text);
    assert_eq!(
        (text.triangle_count(), text.positions.len()),
        (4, 12),
        "all edges of a tetrahedron are creases"
    );
    assert_eq!(read("x.STL", stl_binary()).value, text);
    // STL is welded: a fold of 45 degrees between two facets is smooth, so they share two vertices.
    let fold = "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n\
        facet\nvertex 1 0 0\nvertex 0 0 0\nvertex 0 -1 -1\nendfacet\nendsolid\n";
    assert_eq!(read("x.stl", fold).value.positions.len(), 4);
}

// --- glTF

const POINTS: [[f32; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];

/// Buffer of a glTF: positions, normals, UVs (0,0 is the upper left), linear colors as normalized
/// u8 with padding, u16 indices.
fn gltf_bytes() -> Vec<u8> {
    let mut bytes = Vec::new();
    POINTS.iter().flatten().for_each(|c| bytes.extend(c.to_le_bytes()));
    (0..4).for_each(|_| [0f32, 0., 1.].iter().for_each(|c| bytes.extend(c.to_le_bytes())));
    POINTS
        .iter()
        .for_each(|p| [p[0], 1.0 - p[1]].iter().for_each(|c| bytes.extend(c.to_le_bytes())));
    (0..4).for_each(|_| bytes.extend([255, 55, 0, 255]));
    [0u16, 1, 2, 0, 2, 3].iter().for_each(|i| bytes.extend(i.to_le_bytes()));
    bytes
}

fn gltf_json(buffer: &str) -> String {
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
 "nodes": [{{"translation": [10, 0, 0], "children": [1, 2]}},
           {{"mesh": 0, "scale": [2, 2, 2]}},
           {{"mesh": 0, "scale": [-1, 1, 1],
           "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]}}],
 "meshes": [{{"name": "card", "primitives": [
   {{"attributes": {{"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "COLOR_0": 3}}, "indices": 4,
   "material": 0}}]}}],
 "materials": [{{"name": "leaf", "doubleSided": true, "alphaMode": "MASK", "alphaCutoff": 0.25}}],
 "accessors": [
  {{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0,0,0],
  "max": [1,1,0]}},
  {{"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3"}},
  {{"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"}},
  {{"bufferView": 2, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC3"}},
  {{"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}}],
 "bufferViews": [{{"buffer": 0, "byteLength": 96}}, {{"buffer": 0, "byteOffset": 96,
 "byteLength": 32}},
  {{"buffer": 0, "byteOffset": 128, "byteLength": 16, "byteStride": 4}},
  {{"buffer": 0, "byteOffset": 144, "byteLength": 12}}],
 "buffers": [{{"byteLength": 156{buffer}}}]}}"#
    )
}

pub(crate) fn base64(bytes: &[u8]) -> String {
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let bits =
            chunk.iter().fold(0u32, |bits, b| bits << 8 | u32::from(*b)) << (8 * (3 - chunk.len()));
        for i in 0..4 {
            text.push(if i <= chunk.len() {
                digits[(bits >> (18 - 6 * i) & 63) as usize] as char
            } else {
                '='
            });
        }
    }
    text
}

fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut binary = binary.to_vec();
    binary.resize(binary.len().next_multiple_of(4), 0);
    let length = 12 + 8 + json.len() + 8 + binary.len();
    let mut bytes = b"glTF".to_vec();
    [2, length as u32, json.len() as u32].iter().for_each(|n| bytes.extend(n.to_le_bytes()));
    bytes.extend(b"JSON");
    bytes.extend(json);
    bytes.extend((binary.len() as u32).to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(binary);
    bytes
}

#[test]
fn gltf_by_data_uri_file_and_glb_is_the_same_mesh() {
    let embedded = gltf_json(&format!(
        r#", "uri": "data:application/octet-stream;base64,{}""#,
        base64(&gltf_bytes())
    ));
    let WithWarnings { value: mesh, warnings: notes } = read("x.gltf", embedded);
    check(&mesh);
    assert!(notes.is_empty(), "{notes:?}");
    assert!(mesh.has_normals && mesh.has_uvs && mesh.has_colors);
    assert_eq!((mesh.name.as_str(), mesh.positions.len(), mesh.triangle_count()), ("card", 8, 4));
    let part = &mesh.parts[0];
    assert_eq!(
        (part.material.as_str(), part.two_sided, part.alpha_cutoff),
        ("leaf", true, Some(0.25))
    );
    // The first instance is scaled by 2 and moved. V is turned up; red stays; 55 of 255 in linear
    // light is 0.5018 on the sRGB curve.
    let corner = mesh.positions.iter().position(|p| *p == [12.0, 2.0, 0.0]).unwrap();
    assert_eq!((mesh.uvs[corner], mesh.normals[corner]), ([1.0, 1.0], [0.0, 0.0, 1.0]));
    assert!((mesh.colors[corner][1] - 0.5018).abs() < 1e-3 && mesh.colors[corner][0] == 1.0);
    assert_eq!(mesh.tangents[corner], [1.0, 0.0, 0.0, 1.0]);
    // The second instance is mirrored: x goes to -x, then a quarter turn about y takes -x to +z and
    // the normal z to +x.
    let far = mesh.positions.iter().position(|p| p[2] > 0.9).unwrap();
    assert!(Vec3::from(mesh.normals[far]).distance(Vec3::X) < 1e-6, "{:?}", mesh.normals[far]);
    assert!(
        Vec4::from(mesh.tangents[far]).distance(Vec4::new(0., 0., 1., -1.)) < 1e-6,
        "{:?}",
        mesh.tangents[far]
    );
    for t in mesh.indices.chunks(3) {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| Vec3::from(mesh.positions[i as usize]));
        assert!(
            (b - a).cross(c - a).dot(mesh.normals[t[0] as usize].into()) > 0.0,
            "winding follows the normal"
        );
    }

    let beside: Siblings = &|name| match name {
        "my mesh.bin" => Ok(Box::new(Cursor::new(gltf_bytes()))),
        _ => Err("not found".to_owned()),
    };
    let named = gltf_json(r#", "uri": "my%20mesh.bin""#);
    assert_eq!(import("x.gltf", named.as_bytes(), beside).unwrap().value, mesh);
    assert_eq!(read("x.glb", glb(&gltf_json(""), &gltf_bytes())).value, mesh);
    assert_eq!(read("no ending", glb(&gltf_json(""), &gltf_bytes())).value, mesh);
}

#[test]
fn gltf_tangents_strips_and_sparse() {
    // A mesh of sparse positions over zeros, a triangle strip, and given tangents.
    let mut bytes = Vec::new();
    [1u16, 2, 3].iter().for_each(|i| bytes.extend(i.to_le_bytes()));
    bytes.extend([0; 2]);
    [[1f32, 0., 0.], [0., 1., 0.], [1., 1., 0.]]
        .iter()
        .flatten()
        .for_each(|c| bytes.extend(c.to_le_bytes()));
    (0..4).for_each(|_| [0f32, 1., 0., -1.].iter().for_each(|c| bytes.extend(c.to_le_bytes())));
    let json = r#"{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [
      {"mode": 5, "attributes": {"POSITION": 0, "TANGENT": 1}},
      {"mode": 0, "attributes": {"POSITION": 0}}]}],
     "accessors": [{"componentType": 5126, "count": 4, "type": "VEC3", "min": [0,0,0],
     "max": [1,1,0],
       "sparse": {"count": 3, "indices": {"bufferView": 0, "componentType": 5123},
       "values": {"bufferView": 1}}},
      {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC4"}],
     "bufferViews": [{"buffer": 0, "byteLength": 6},
     {"buffer": 0, "byteOffset": 8, "byteLength": 36},
      {"buffer": 0, "byteOffset": 44, "byteLength": 64}],
     "buffers": [{"byteLength": 108}]}"#;
    let WithWarnings { value: mesh, warnings: notes } = read("x.glb", glb(json, &bytes));
    check(&mesh);
    assert_eq!((mesh.triangle_count(), area(&mesh)), (2, 1.0));
    assert_eq!(mesh.tangents, [[0.0, 1.0, 0.0, -1.0]; 4]);
    assert!(mesh.normals.iter().all(|n| *n == [0.0, 0.0, 1.0]));
    assert_eq!(mesh.parts[0].material, "default");
    assert!(
        notes.iter().any(|n| n.message.contains("1 primitives of points or lines")),
        "{notes:?}"
    );
}

/// A file with more vertices than bytes is refused, by the crate that reads the JSON or by the
/// bound on memory.
#[test]
fn more_vertices_than_bytes_are_refused() {
    let bytes = gltf_bytes();
    let with = |from: &str, to: &str| {
        let json = gltf_json("");
        assert!(json.contains(from), "{from}");
        glb(&json.replacen(from, to, 1), &bytes)
    };
    let huge = with(
        "\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"VEC3\", \"min\"",
        "\"componentType\": 5126, \"count\": 4000000000, \"type\": \"VEC3\", \"min\"",
    );
    assert!(["mesh-syntax", "mesh-too-large"].contains(&errors("x.glb", huge)[0].code));
}

/// A glTF of one triangle with more fields in its JSON: in the root, in the node, in the primitive,
/// among its attributes.
fn triangle_gltf(root: &str, node: &str, primitive: &str, attributes: &str) -> String {
    let points: Vec<u8> =
        [0f32, 0., 0., 1., 0., 0., 0., 1., 0.].iter().flat_map(|x| x.to_le_bytes()).collect();
    let moves: Vec<u8> =
        [0f32, 0., 0., 0., 0., 5., 0., 0., 9.].iter().flat_map(|x| x.to_le_bytes()).collect();
    let data = base64(&[points, moves].concat());
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0{node}}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0{attributes}}}{primitive}}}]}}],
         "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
          {{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"}},
          {{"componentType": 5126, "count": 20000000, "type": "VEC3"}},
          {{"componentType": 5126, "count": 3, "type": "VEC4",
            "sparse": {{"count": 1, "indices": {{"bufferView": 2, "componentType": 5121}},
              "values": {{"bufferView": 0}}}}}}],
         "bufferViews": [{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteOffset": 36,
         "byteLength": 36}},
          {{"buffer": 0, "byteLength": 1}}],
         "buffers": [{{"byteLength": 72, "uri": "data:;base64,{data}"}}]{root}}}"#
    )
}

#[test]
fn gltf_takes_all_that_2_0_allows() {
    let plain = read("x.gltf", triangle_gltf("", "", "", "")).value;
    assert_eq!(plain.triangle_count(), 1);
    // Custom attributes of any count; extras of any kind; animation channels without a node; fields
    // of later versions.
    let channel = r#", "animations": [{"channels": [{"sampler": 0, "target": {"path": "pointer"}}],
        "samplers": []}],
        "cameras": [{}], "textures": 7, "extras": "made by hand", "future": {"a": [1]}"#;
    for json in [
        triangle_gltf("", "", "", r#", "_FEATURE_ID_0": 2, "_X": 99"#),
        triangle_gltf("", r#", "extras": [1]"#, r#", "extras": 5"#, ""),
        triangle_gltf(
            r#", "extensionsRequired": ["KHR_materials_unlit", "KHR_texture_transform"]"#,
            "",
            "",
            "",
        ),
        triangle_gltf(channel, r#", "camera": 9, "skin": 9"#, "", ""),
    ] {
        assert_eq!(read("x.gltf", json).value, plain);
    }
}

/// UVs of a triangle with two sets of them and this material, by the corners (0, 0), (1, 0) and
/// (0, 1) of the first set, with v down as files have it; and the codes of what is noted.
fn uvs_of_material(material: &str) -> (Vec<[f32; 2]>, Vec<&'static str>) {
    let rows = |rows: &[f32]| rows.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let points = rows(&[0., 0., 0., 1., 0., 0., 0., 1., 0.]);
    let (first, second) = (rows(&[0., 0., 1., 0., 0., 1.]), rows(&[0.25, 0.75, 0.5, 0.5, 2., 3.]));
    let data = base64(&[points, first, second].concat());
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "TEXCOORD_0": 1,
          "TEXCOORD_1": 2}}, "material": 0}}]}}],
         "materials": [{material}], "textures": [{{"source": 0}}], "images": [{{"uri": "a.png"}}],
         "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
          {{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}},
          {{"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"}}],
         "bufferViews": [{{"buffer": 0, "byteLength": 36}},
          {{"buffer": 0, "byteOffset": 36, "byteLength": 24}},
          {{"buffer": 0, "byteOffset": 60, "byteLength": 24}}],
         "buffers": [{{"byteLength": 84, "uri": "data:;base64,{data}"}}]}}"#
    );
    let WithWarnings { value: mesh, warnings } = read("x.gltf", json);
    let corner = |wanted: [f32; 3]| mesh.positions.iter().position(|at| *at == wanted).unwrap();
    let corners = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]].map(corner);
    let codes = warnings.iter().map(|note| note.code).filter(|code| *code != "mesh-normals-made");
    (corners.map(|at| mesh.uvs[at]).to_vec(), codes.collect())
}

#[test]
fn uvs_of_a_gltf_are_those_by_which_its_material_lays_its_pictures() {
    const FIRST: [[f32; 2]; 3] = [[0., 1.], [1., 1.], [0., 0.]];
    const SECOND: [[f32; 2]; 3] = [[0.25, 0.25], [0.5, 0.5], [2., -2.]];
    let base = |texture: &str| {
        format!(r#"{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0{texture}}}}}}}"#)
    };
    let moved =
        |words: &str| base(&format!(r#", "extensions": {{"KHR_texture_transform": {{{words}}}}}"#));
    // The example of the extension: the lower left quadrant of the picture, turned clockwise.
    let quadrant = r#""offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]"#;
    for (material, wanted) in [
        (base(""), FIRST),
        (base(r#", "texCoord": 1"#), SECOND),
        (base(r#", "texCoord": 7"#), FIRST),
        (moved(r#""texCoord": 1"#), SECOND),
        (moved(r#""offset": [0.5, 0.25]"#), [[0.5, 0.75], [1.5, 0.75], [0.5, -0.25]]),
        (moved(quadrant), [[0., 0.], [0., 0.5], [0.5, 0.]]),
        (moved(r#""scale": [1e300, 1]"#), FIRST),
        ("{}".to_owned(), FIRST),
    ] {
        let (uvs, noted) = uvs_of_material(&material);
        let apart = uvs.iter().flatten().zip(wanted.iter().flatten()).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f32::max) < 1e-6, "{material}: {uvs:?}");
        assert!(noted.is_empty(), "{material}: {noted:?}");
    }
    // Of a material whose pictures lie differently the first one counts, and that is said.
    let lit = r#"{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
        "occlusionTexture": {"index": 0, "texCoord": 1}}"#;
    let (uvs, noted) = uvs_of_material(lit);
    assert!(uvs == FIRST && noted == ["mesh-unsupported"], "{uvs:?} {noted:?}");
    let (uvs, noted) = uvs_of_material(r#"{"emissiveTexture": {"index": 0, "texCoord": 1}}"#);
    assert!(uvs == SECOND && noted.is_empty(), "{uvs:?} {noted:?}");
}

#[test]
fn gltf_instances_are_copies() {
    let with = |attributes: &str| {
        let node = format!(
            r#", "extensions": {{"EXT_mesh_gpu_instancing": {{"attributes": {{{attributes}}}}}}}"#
        );
        triangle_gltf(r#", "extensionsRequired": ["EXT_mesh_gpu_instancing"]"#, &node, "", "")
    };
    let WithWarnings { value: mesh, warnings: notes } =
        read("x.gltf", with(r#""TRANSLATION": 1, "_ID": 0"#));
    check(&mesh);
    assert_eq!(mesh.triangle_count(), 3);
    let mut depths: Vec<f32> = mesh.positions.iter().map(|p| p[2]).collect();
    depths.dedup();
    assert_eq!(depths, [0.0, 5.0, 9.0]);
    assert!(!notes.iter().any(Diagnostic::is_error));
}

#[test]
fn draco_beside_plain_data_is_no_hindrance() {
    let extension =
        r#", "extensions": {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {}}}"#;
    assert_eq!(read("x.gltf", triangle_gltf("", "", extension, "")).value.triangle_count(), 1);
}

/// Zeros between letters are no sign of UTF-16 in a binary file.
#[test]
fn a_binary_stl_may_begin_as_utf_16_does() {
    let mut binary = stl_binary();
    binary[..4].copy_from_slice(b"a\0b\0");
    read("x.stl", binary);
}

// --- Paths

#[test]
fn load_reads_the_file_and_those_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("card.gltf");
    std::fs::write(&path, gltf_json(r#", "uri": "my%20mesh.bin""#)).unwrap();
    let problems = load(&Disk, &path).unwrap_err();
    assert_eq!(problems[0].code, "mesh-reference");
    assert!(problems[0].message.contains("`my mesh.bin`"), "{}", problems[0]);
    std::fs::write(folder.path().join("my mesh.bin"), gltf_bytes()).unwrap();
    assert_eq!(load(&Disk, &path).unwrap().value.triangle_count(), 4);
    let pipe = folder.path().join("pipe.obj");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    let pipe = made.is_ok_and(|status| status.success()).then_some(pipe);
    for wrong in
        [folder.path().join("absent.obj"), folder.path().to_owned()].into_iter().chain(pipe)
    {
        let problems = load(&Disk, &wrong).unwrap_err();
        assert_eq!(
            (problems[0].code, problems[0].place.file.clone()),
            ("mesh-read", Some(wrong.display().to_string()))
        );
    }
}

// --- Files of unknown origin

fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let embedded = gltf_json(&format!(r#", "uri": "data:;base64,{}""#, base64(&gltf_bytes())));
    vec![
        ("x.obj", format!("{CUBE}vt 0 0\nvn 0 0 1\nusemtl a\nf 1/1/1 2//1 3/1 -1\n").into_bytes()),
        ("x.ply", ply_text().into_bytes()),
        ("x.ply", ply_binary(false)),
        ("x.ply", ply_binary(true)),
        ("x.stl", stl_text().into_bytes()),
        ("x.stl", stl_binary()),
        ("x.gltf", embedded.into_bytes()),
        ("x.glb", glb(&gltf_json(""), &gltf_bytes())),
        ("x.gltf", bending_bar().into_bytes()),
    ]
}

#[test]
fn files_cut_short_are_told_so() {
    for (name, bytes) in samples() {
        read(name, &bytes);
        for length in 0..bytes.len() {
            let result = import(name, &bytes[..length], &no_siblings);
            // OBJ has no end mark, so that a part may be a whole file. In other formats only the
            // last line's end may be missing.
            let rest = bytes[length..].trim_ascii();
            if name != "x.obj" && rest.len() > 1 && !b"endsolid corner".ends_with(rest) {
                assert!(result.is_err(), "{name} cut at {length} of {}", bytes.len());
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn random_bytes_never_panic(
        kind in 0usize..8, bytes in prop::collection::vec(any::<u8>(), 0..600)
    ) {
        let start: [(&str, &[u8]); 8] = [
            ("x.obj", b""), ("x.ply", b""), ("x.stl", b""), ("x.glb", b"glTF"), ("x.gltf", b"{"),
            ("x.stl", b"solid"), ("x", b""),
            ("x.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float \
                        x\nproperty float y\n\
              property float z\nelement face 2\nproperty list uchar uchar \
              vertex_indices\nend_header\n"),
        ];
        let (name, head) = start[kind];
        let _ = import(name, &[head, &bytes].concat(), &no_siblings);
    }

    #[test]
    fn changed_files_never_panic(
        kind in 0usize..9,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0u8..4), 1..6),
    ) {
        let (name, mut bytes) = samples().swap_remove(kind);
        for (place, byte, way) in changes {
            let i = place.index(bytes.len());
            match way {
                0 => bytes[i] = byte,
                1 => bytes[i] = b"0123456789-eE./ \n{}[],\""[byte as usize % 23],
                2 => bytes.insert(i, byte),
                _ => { bytes.remove(i); }
            }
        }
        if let Ok(WithWarnings { value: mesh, .. }) = import(name, &bytes, &no_siblings) {
            check(&mesh);
            if let Some(motion) = &mesh.motion {
                let animation = motion.animations().first().map(|animation| (animation, 0.7));
                check(&mesh.posed(&motion.pose(animation)));
            }
        }
    }
}
