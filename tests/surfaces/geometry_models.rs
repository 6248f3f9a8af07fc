//! Real meshes, where the folder of trial meshes exists.

use std::collections::{HashMap, HashSet};
use std::path::PathBuf;

use chiaro::diag::WithWarnings;
use chiaro::files::Disk;
use chiaro::geometry::{Mesh, load};
use glam::{Vec3, Vec4};

/// Text of a mesh file, and the mesh read from it; `None` where the folder of trial meshes is
/// missing.
fn model(name: &str) -> Option<(String, WithWarnings<Mesh>)> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let path =
        ["../shared/models", "../../shared/models"].map(|folder| root.join(folder).join(name));
    let path = path.into_iter().find(|path| path.exists())?;
    let imported = load(&Disk, &path).unwrap_or_else(|problems| panic!("{name}: {}", problems[0]));
    Some((std::fs::read_to_string(&path).unwrap(), imported))
}

/// Number of vertices at each place.
fn at_places(mesh: &Mesh) -> HashMap<[u32; 3], usize> {
    let mut count = HashMap::new();
    for p in &mesh.positions {
        *count.entry(p.map(f32::to_bits)).or_default() += 1;
    }
    count
}

fn volume(mesh: &Mesh) -> f64 {
    let at = |i: u32| Vec3::from(mesh.positions[i as usize]).as_dvec3();
    mesh.indices.chunks(3).map(|t| at(t[0]).cross(at(t[1])).dot(at(t[2])) / 6.0).sum()
}

/// Share of the vertices' places where normals are split; UV seams alone do not count. From 0 to 1.
fn creased(mesh: &Mesh) -> f64 {
    let mut normals: HashMap<[u32; 3], HashSet<[u32; 3]>> = HashMap::new();
    for (p, n) in mesh.positions.iter().zip(&mesh.normals) {
        normals.entry(p.map(f32::to_bits)).or_default().insert(n.map(f32::to_bits));
    }
    normals.values().filter(|n| n.len() > 1).count() as f64 / normals.len() as f64
}

#[test]
fn real_meshes_have_what_their_files_say() {
    for name in ["spot", "suzanne", "teapot", "stanford-bunny", "nefertiti", "rocker-arm"] {
        let Some((text, WithWarnings { value: mesh, warnings: notes })) =
            model(&format!("{name}.obj"))
        else {
            return;
        };
        // Triangles counted from the text: a polygon of n corners gives n - 2.
        let faces = text.lines().filter_map(|line| line.strip_prefix("f "));
        let corners: Vec<usize> =
            faces.clone().map(|face| face.split_whitespace().count()).collect();
        let triangles: usize = corners.iter().map(|n| n - 2).sum();
        let dropped = notes.iter().find(|n| n.code == "mesh-degenerate");
        let dropped: usize =
            dropped.map_or(0, |n| n.message.split(' ').next().unwrap().parse().unwrap());
        assert_eq!(mesh.triangle_count() + dropped, triangles, "{name}");
        assert!(dropped * 1000 <= triangles, "{name}: {dropped} dropped");
        let points: HashSet<&str> =
            faces.flat_map(str::split_whitespace).map(|c| c.split('/').next().unwrap()).collect();
        assert!(at_places(&mesh).len() <= points.len(), "{name}");
        assert_eq!(mesh.has_normals, text.contains("\nvn "), "{name}");
        assert_eq!(mesh.has_uvs, text.contains("\nvt "), "{name}");
        for v in 0..mesh.positions.len() {
            let (normal, tangent) = (Vec3::from(mesh.normals[v]), Vec4::from(mesh.tangents[v]));
            assert!((normal.length() - 1.0).abs() < 1e-5, "{name} {v}");
            assert!((tangent.truncate().length() - 1.0).abs() < 1e-5, "{name} {v}");
            assert!(tangent.truncate().dot(normal).abs() < 1e-5, "{name} {v}");
        }
        let fit = mesh.fit().matrix();
        let farthest =
            mesh.positions.iter().map(|p| fit.transform_point3(Vec3::from(*p).as_dvec3()).length());
        assert!((farthest.fold(0.0, f64::max) - 1.0).abs() < 1e-9, "{name}");
    }
}

#[test]
fn scans_are_smooth_and_machines_have_creases() {
    let Some((_, bunny)) = model("stanford-bunny.obj") else { return };
    let (_, nefertiti) = model("nefertiti.obj").unwrap();
    let (_, spot) = model("spot.obj").unwrap();
    let (_, rocker) = model("rocker-arm.obj").unwrap();
    for (name, mesh) in
        [("bunny", &bunny.value), ("nefertiti", &nefertiti.value), ("spot", &spot.value)]
    {
        assert!(creased(mesh) < 0.02, "{name}: {}", creased(mesh));
    }
    for (name, mesh) in
        [("spot", &spot.value), ("rocker arm", &rocker.value), ("nefertiti", &nefertiti.value)]
    {
        assert!(volume(mesh) > 0.0, "{name}: counter-clockwise from outside");
        let outward = mesh.indices.chunks(3).filter(|t| {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| Vec3::from(mesh.positions[i as usize]));
            (b - a).cross(c - a).dot(mesh.normals[t[0] as usize].into()) > 0.0
        });
        assert!(outward.count() as f64 > 0.995 * mesh.triangle_count() as f64, "{name}");
    }
}
