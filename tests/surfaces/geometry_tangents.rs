//! Tangents equal MikkTSpace's to the bit, and a normal map baked in MikkTSpace's frames gives its
//! normals back.
#![allow(clippy::print_stdout, reason = "figures are worth reading when a bound is missed")]

use std::fmt::Write as _;

use crate::support::random::Random;
use bevy_mikktspace::{Geometry, TangentSpace, generate_tangents};
use chiaro::geometry::{Mesh, SHAPES, import, no_siblings, shape};
use glam::{DVec2, DVec3, Vec3, Vec4};

/// A mesh as input of another implementation of MikkTSpace, which follows the reference to the
/// byte.
struct MikktspaceMesh<'m> {
    mesh: &'m Mesh,
    /// Tangents by corner.
    tangents: Vec<Option<[f32; 4]>>,
}

impl MikktspaceMesh<'_> {
    fn index(&self, face: usize, corner: usize) -> usize {
        self.mesh.indices[face * 3 + corner] as usize
    }
}

impl Geometry for MikktspaceMesh<'_> {
    fn num_faces(&self) -> usize {
        self.mesh.triangle_count()
    }

    fn num_vertices_of_face(&self, _: usize) -> usize {
        3
    }

    fn position(&self, face: usize, corner: usize) -> [f32; 3] {
        self.mesh.positions[self.index(face, corner)]
    }

    fn normal(&self, face: usize, corner: usize) -> [f32; 3] {
        self.mesh.normals[self.index(face, corner)]
    }

    fn tex_coord(&self, face: usize, corner: usize) -> [f32; 2] {
        self.mesh.uvs[self.index(face, corner)]
    }

    fn set_tangent(&mut self, space: Option<TangentSpace>, face: usize, corner: usize) {
        self.tangents[face * 3 + corner] = space.map(|space| space.tangent_encoded());
    }
}

/// The tangent of each corner by the other implementation.
fn expected(mesh: &Mesh) -> Vec<Option<[f32; 4]>> {
    let mut other = MikktspaceMesh { mesh, tangents: vec![None; mesh.indices.len()] };
    generate_tangents(&mut other).expect("it has no errors");
    other.tangents
}

/// Asserts that all tangents of a mesh are the other implementation's; gives the number of corners
/// compared.
fn hold(name: &str, mesh: &Mesh) -> usize {
    let mut held = 0;
    for (corner, (&vertex, wanted)) in mesh.indices.iter().zip(expected(mesh)).enumerate() {
        let found = mesh.tangents[vertex as usize];
        let normal = Vec3::from(mesh.normals[vertex as usize]);
        let along = Vec4::from(found).truncate();
        assert!(
            (along.length() - 1.0).abs() < 1e-5 && along.dot(normal).abs() < 1e-5,
            "{name} {corner}: {found:?}"
        );
        // Where UVs define no direction the reference has no tangent, or one of length 0.
        let Some(wanted) = wanted.filter(|t| Vec4::from(*t).truncate().length() > 0.5) else {
            continue;
        };
        let is_upright = Vec4::from(wanted).truncate().dot(normal).abs() <= 1e-6;
        let is_same = if is_upright {
            found == wanted
        } else {
            Vec4::from(found).distance(wanted.into()) < 1e-5
        };
        assert!(
            is_same,
            "{name}, corner {corner}: {found:?} for {wanted:?} at {:?}",
            mesh.positions[vertex as usize]
        );
        held += 1;
    }
    held
}

fn read(text: &str) -> Mesh {
    import("test.obj", text.as_bytes(), &no_siblings)
        .unwrap_or_else(|problems| panic!("{problems:#?}"))
        .value
}

/// An OBJ of triangles with corners (position, UV): every corner is written anew or, when `shares`,
/// each position and UV once.
fn obj(triangles: &[[([f32; 3], [f32; 2]); 3]], shares: bool) -> String {
    let mut text = String::new();
    let (mut places, mut uvs): (Vec<[f32; 3]>, Vec<[f32; 2]>) = (Vec::new(), Vec::new());
    let mut faces = String::new();
    for triangle in triangles {
        faces += "f";
        for (at, uv) in triangle {
            let place =
                places.iter().position(|p| p == at).filter(|_| shares).unwrap_or_else(|| {
                    let _ = writeln!(text, "v {} {} {}", at[0], at[1], at[2]);
                    places.push(*at);
                    places.len() - 1
                });
            let uv = uvs.iter().position(|p| p == uv).filter(|_| shares).unwrap_or_else(|| {
                let _ = writeln!(text, "vt {} {}", uv[0], uv[1]);
                uvs.push(*uv);
                uvs.len() - 1
            });
            let _ = write!(faces, " {}/{}", place + 1, uv + 1);
        }
        faces += "\n";
    }
    text + &faces
}

/// A wavy square of `n` by `n` cells, mirror-symmetric in x, with a UV for each corner of each
/// triangle.
fn waves(n: usize, uv: impl Fn(f32, f32) -> [f32; 2]) -> Vec<[([f32; 3], [f32; 2]); 3]> {
    let corner = |i: usize, j: usize| {
        let [x, y] = [i, j].map(|k| 2.0 * k as f32 / n as f32 - 1.0);
        ([x, y, 0.2 * (3.0 * x).cos() * (2.0 * y + 0.4).cos()], uv(x, y))
    };
    let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    cells
        .flat_map(|(i, j)| {
            let [a, b, c, d] =
                [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

#[test]
fn own_shapes_have_the_references_tangents() {
    for about in SHAPES {
        let mesh = shape(about.name).unwrap();
        let held = hold(about.name, &mesh);
        assert!(
            held * 10 > mesh.indices.len() * 9,
            "{}: {held} of {}",
            about.name,
            mesh.indices.len()
        );
    }
}

#[test]
fn mirrored_and_cut_uvs_have_the_references_tangents() {
    type Uv = fn(f32, f32) -> [f32; 2];
    let ways: [(&str, Uv); 5] = [
        ("sheared", |x, y| [0.7 * x + 0.1 * y, 0.2 * x + 0.9 * y]),
        ("mirrored", |x, y| [x.abs(), y]),
        ("mirrored twice", |x, y| [x.abs(), y.abs()]),
        ("cut", |x, y| [(x + 1.0).fract(), y + 0.2 * x * x]),
        ("all around", |x, y| [y.atan2(x), x.hypot(y)]),
    ];
    for (name, uv) in ways {
        for shares in [false, true] {
            let mesh = read(&obj(&waves(12, uv), shares));
            assert!(hold(name, &mesh) > 800, "{name}");
        }
    }
}

/// Triangles whose UVs span no area take the tangents of their neighbors; a file that repeats its
/// points gives the same tangents.
#[test]
fn triangles_without_area_have_the_references_tangents() {
    let mut random = Random::new(3);
    for round in 0..300 {
        // With few places and UVs triangles share edges, meet at single points, fold over and lose
        // their area.
        let mut number = |steps: usize| random.index(steps) as f32 / 3.0 - 1.0;
        let places: Vec<[f32; 3]> = (0..8).map(|_| [number(7), number(7), number(7)]).collect();
        let uvs: Vec<[f32; 2]> = (0..5).map(|_| [number(5), number(5)]).collect();
        let corners: Vec<_> = places.iter().map(|at| (*at, *random.pick(&uvs))).collect();
        let count = 2 + random.index(24);
        let triangles: Vec<_> =
            (0..count).map(|_| [0; 3].map(|_| *random.pick(&corners))).collect();
        for shares in [false, true] {
            // A file of triangles without area alone is refused.
            if let Ok(read) = import("test.obj", obj(&triangles, shares).as_bytes(), &no_siblings) {
                hold(&format!("round {round}, {shares}"), &read.value);
            }
        }
    }
}

/// A cone whose tip has one UV: directions of growing u turn all the way around the tip, and
/// opposite ones cancel.
#[test]
fn opposite_directions_have_the_references_tangents() {
    for count in [4, 8, 60, 200] {
        let rim = |k: usize| {
            let turn = std::f32::consts::TAU * (k % count) as f32 / count as f32;
            ([turn.cos(), turn.sin(), 0.0], [k as f32 / count as f32, 0.0])
        };
        let cone: Vec<_> =
            (0..count).map(|k| [rim(k), rim(k + 1), ([0.0, 0.0, 1.0], [0.5, 1.0])]).collect();
        assert!(hold(&format!("a cone of {count}"), &read(&obj(&cone, true))) > 0);
    }
}

/// A point, and an edge, of 300,000 triangles. The reference walks around a point by recursion, and
/// compares all triangles there with each other: neither would end here.
#[test]
fn a_point_of_many_triangles_is_no_harder_than_others() {
    let count = 300_000;
    let mut text = "v 0 0 1\nvt 0.5 0.5\n".to_owned();
    for k in 0..count {
        let turn = std::f64::consts::TAU * f64::from(k) / f64::from(count);
        let _ =
            writeln!(text, "v {} {} 0\nvt {} {}", turn.cos(), turn.sin(), turn.cos(), turn.sin());
    }
    for k in 0..count {
        let (a, b) = (k + 2, (k + 1) % count + 2);
        let _ = writeln!(text, "f {a}/{a} {b}/{b} 1/1");
    }
    // An edge of 300,000 triangles, all of which run along it in one direction.
    text += "v 5 0 -1\nv 5 0 1\n";
    for k in 0..count {
        let turn = std::f64::consts::TAU * f64::from(k) / f64::from(count);
        let _ = writeln!(text, "v {} {} 0", 5.0 + turn.cos(), turn.sin());
        let _ = writeln!(text, "f {}/1 {}/2 {}/{}", count + 2, count + 3, count + 4 + k, k + 2);
    }
    let mesh = read(&text);
    assert!(mesh.triangle_count() > 590_000);
    let apex = mesh.positions.iter().position(|p| *p == [0.0, 0.0, 1.0]).unwrap();
    assert!(mesh.tangents[apex][0] > 0.999, "{:?}", mesh.tangents[apex]);
}

/// Normals that the baked map must give back, the waves' own with smaller waves on them: functions
/// of x and y alone, so that a pixel's place tells them, and mirrored as x is.
#[cfg(feature = "gpu")]
fn known(at: DVec2) -> DVec3 {
    let (wave_x, wave_y) = (3.0 * at.x, 2.0 * at.y + 0.4);
    let x = 0.6 * wave_x.sin() * wave_y.cos() + 0.3 * (7.0 * at.x).sin();
    let y = 0.4 * wave_x.cos() * wave_y.sin() + 0.2 * (5.0 * at.x).cos();
    DVec3::new(x, y, 1.0).normalize()
}

/// The frame at a point of the mesh over (x, y), as a baker interpolates it: tangent, bitangent,
/// normal.
#[cfg(feature = "gpu")]
fn frame_at(mesh: &Mesh, tangents: &[Option<[f32; 4]>], at: DVec2) -> glam::DMat3 {
    let flat = |vertex: u32| {
        let [x, y, _] = mesh.positions[vertex as usize];
        DVec2::new(x.into(), y.into())
    };
    for (face, t) in mesh.indices.chunks_exact(3).enumerate() {
        let [a, b, c] = [flat(t[0]), flat(t[1]), flat(t[2])];
        let area = (b - a).perp_dot(c - a);
        let (v, w) = ((at - a).perp_dot(c - a) / area, (b - a).perp_dot(at - a) / area);
        if v < -1e-6 || w < -1e-6 || v + w > 1.0 + 1e-6 {
            continue;
        }
        let weights = [1.0 - v - w, v, w];
        let mut normal = DVec3::ZERO;
        let mut tangent = DVec3::ZERO;
        for k in 0..3 {
            let [x, y, z, _] = tangents[face * 3 + k].expect("UVs everywhere");
            tangent += weights[k] * DVec3::new(x.into(), y.into(), z.into());
            normal += weights[k] * Vec3::from(mesh.normals[t[k] as usize]).as_dvec3();
        }
        let sign = tangents[face * 3].expect("UVs everywhere")[3];
        return glam::DMat3::from_cols(tangent, f64::from(sign) * normal.cross(tangent), normal);
    }
    panic!("{at} lies beside the mesh");
}

/// Angle between a known normal and the normal that a fragment reads in an orthonormal frame, as
/// Chiaro's, in place of the baker's frame. In radians.
#[cfg(feature = "gpu")]
fn off_by_frame(mesh: &Mesh, tangents: &[Option<[f32; 4]>], at: DVec2) -> f64 {
    let frame = frame_at(mesh, tangents, at);
    let vector = frame.inverse() * known(at);
    let normal = frame.z_axis.normalize();
    let tangent = frame.x_axis.reject_from(normal).normalize();
    let sign = normal.cross(tangent).dot(frame.y_axis).signum();
    let upright = glam::DMat3::from_cols(tangent, sign * normal.cross(tangent), normal);
    (upright * vector).angle_between(known(at))
}

/// A normal map is baked from known normals with the other implementation's tangents, for two
/// halves that share one half of a texture, and drawn by a look.
#[cfg(feature = "gpu")]
#[test]
fn a_baked_normal_map_brings_its_normals_back() {
    use crate::support::eval::{draw, look, scene};
    use chiaro::compile::Live;
    use chiaro::document::{Camera, Projection, Scene};
    use chiaro::library::Library;
    use serde_json::json;

    // Every corner is written anew, as by many exporters, so that only welding finds equal
    // vertices.
    let mesh = read(&obj(&waves(48, |x, y| [x.abs(), 0.5 + 0.4 * y + 0.1 * x.abs()]), false));
    assert!(hold("the mesh", &mesh) > 0);
    let tangents = expected(&mesh);
    let size = 256;
    let mut map = image::RgbImage::new(size, size);
    for (i, j, texel) in map.enumerate_pixels_mut() {
        let [u, v] =
            [f64::from(i) + 0.5, f64::from(size - 1 - j) + 0.5].map(|x| x / f64::from(size));
        // The point of the first half that shows this texel; texels beside the mesh are not read.
        let at = DVec2::new(u, ((v - 0.5 - 0.1 * u) / 0.4).clamp(-1.0, 1.0));
        let vector = (frame_at(&mesh, &tangents, at).inverse() * known(at)).normalize();
        texel.0 = (127.5 * (vector + 1.0)).round().to_array().map(|x| x as u8);
    }
    let folder = tempfile::tempdir().expect("a folder");
    map.save(folder.path().join("map.png")).expect("a picture");

    let mut mapped = look(&json!({
        "nodes": [
            {
                "id": "image", "kind": "image",
                "values": {"image": "map.png", "encoding": "data", "wrap": "clamp"}
            },
            {"id": "map", "kind": "normal_map"},
            {"id": "shown", "kind": "map_range", "values": {"from_low": -1}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "image.color", "to": "map.color"},
            {"from": "map", "to": "shown.value"},
            {"from": "shown", "to": "output.color"}
        ]
    }));
    mapped.folder = folder.path().to_path_buf();
    let camera = Camera { projection: Projection::Orthographic, height: 2.0, ..Camera::default() };
    let drawn = Scene { camera, backdrop: None, ..Scene::default() };
    let setup = scene(mapped, mesh, drawn);
    let picture = draw(&setup, Library::built_in(), &Live::Keyed, [100, 100], 1);

    let (mut worst, mut sum, mut count, mut by_frame) = (0.0_f64, 0.0, 0, 0.0_f64);
    for (y, x) in (1..99).flat_map(|y| (1..99).map(move |x| (y, x))) {
        let [r, g, b, _] = picture.pixel(x, y).map(f64::from);
        let found = 2.0 * DVec3::new(r, g, b) - 1.0;
        let at = DVec2::new(0.02 * (f64::from(x) + 0.5) - 1.0, 1.0 - 0.02 * (f64::from(y) + 0.5));
        let off = found.angle_between(known(at));
        (worst, sum, count) = (worst.max(off), sum + off, count + 1);
        by_frame = by_frame.max(off_by_frame(&setup.objects[0].mesh, &tangents, at));
    }
    let mean = sum / f64::from(count);
    // Eight bits a channel alone make 4e-3, and an orthonormal frame is not quite a baker's.
    assert!(worst < 2e-2 && mean < 5e-3, "{worst:.2e} rad, {mean:.2e} in the mean");
    assert!(by_frame < 2e-4, "{by_frame:.2e} by the frame alone");
}
