//! The own shapes against their mathematical definitions.

use std::collections::{HashMap, HashSet};

use chiaro::geometry::{Mesh, SHAPES, shape};
use glam::{Vec3, Vec4};

/// Index of each vertex's place, equal for vertices at the same place.
fn places(mesh: &Mesh) -> Vec<usize> {
    let mut known = HashMap::new();
    mesh.positions
        .iter()
        .map(|p| (*p).map(|c| (c + 0.0).to_bits()))
        .map(|key| {
            let next = known.len();
            *known.entry(key).or_insert(next)
        })
        .collect()
}

fn triangles(mesh: &Mesh) -> Vec<[usize; 3]> {
    mesh.indices.chunks_exact(3).map(|t| [t[0] as usize, t[1] as usize, t[2] as usize]).collect()
}

/// Euler characteristic: vertices - edges + faces, after asserting that every edge is used once in
/// either direction.
fn euler(mesh: &Mesh, name: &str) -> i64 {
    let places = places(mesh);
    let mut edges = HashSet::new();
    for t in triangles(mesh) {
        for k in 0..3 {
            let edge = (places[t[k]], places[t[(k + 1) % 3]]);
            assert!(edges.insert(edge), "{name}: edge {edge:?} is used twice in one direction");
        }
    }
    for (a, b) in &edges {
        assert!(
            edges.contains(&(*b, *a)),
            "{name}: there is a hole at {:?}",
            mesh.positions[places.iter().position(|p| p == a).unwrap()]
        );
    }
    let used: HashSet<usize> = edges.iter().map(|e| e.0).collect();
    used.len() as i64 - edges.len() as i64 / 2 + mesh.triangle_count() as i64
}

/// True if the triangles around every place form one ring.
fn is_manifold(mesh: &Mesh) -> bool {
    let places = places(mesh);
    // The next neighbor around a place, by place and neighbor.
    let mut next: HashMap<(usize, usize), usize> = HashMap::new();
    let mut degree: HashMap<usize, usize> = HashMap::new();
    for t in triangles(mesh) {
        for k in 0..3 {
            let [a, b, c] = [k, k + 1, k + 2].map(|i| places[t[i % 3]]);
            next.insert((a, b), c);
            *degree.entry(a).or_default() += 1;
        }
    }
    let mut start: HashMap<usize, usize> = HashMap::new();
    next.keys().for_each(|&(a, b)| {
        start.insert(a, b);
    });
    start.iter().all(|(&a, &first)| {
        let (mut at, mut steps) = (first, 0);
        loop {
            at = next[&(a, at)];
            steps += 1;
            if at == first || steps > degree[&a] {
                return steps == degree[&a];
            }
        }
    })
}

/// The enclosed volume, positive where triangles are counter-clockwise seen from outside.
fn volume(mesh: &Mesh) -> f64 {
    let at = |i: usize| Vec3::from(mesh.positions[i]).as_dvec3();
    triangles(mesh).iter().map(|t| at(t[0]).cross(at(t[1])).dot(at(t[2])) / 6.0).sum()
}

#[test]
fn closed_shapes_have_the_euler_characteristic_of_their_kind() {
    for (name, expected) in [
        ("sphere", 2),
        ("torus", 0),
        ("blob", 2),
        ("knot", 0),
        ("creature", 2),
        ("cube", 2),
        ("vase", 2),
    ] {
        let mesh = shape(name).unwrap();
        assert_eq!(euler(&mesh, name), expected, "{name}");
        assert!(is_manifold(&mesh), "{name}");
    }
}

#[test]
fn volumes_are_those_of_the_formulas() {
    let near = |name: &str, expected: f64| {
        let found = volume(&shape(name).unwrap());
        assert!((found / expected - 1.0).abs() < 0.005, "{name}: {found} instead of {expected}");
    };
    let pi = std::f64::consts::PI;
    near("sphere", 4.0 / 3.0 * pi);
    near("torus", 2.0 * pi * pi * 0.7 * 0.3 * 0.3);
    // Pappus's theorem: the tube's cross section times the length of its curve.
    let point = |t: f64| {
        let ring = 0.68 + 0.3 * (3.0 * t).cos();
        glam::DVec3::new(ring * (2.0 * t).cos(), ring * (2.0 * t).sin(), 0.36 * (3.0 * t).sin())
    };
    let steps = 100_000;
    let length: f64 = (0..steps)
        .map(|i| [i, i + 1].map(|i| f64::from(i) / f64::from(steps) * 2.0 * pi))
        .map(|[a, b]| point(a).distance(point(b)))
        .sum();
    near("knot", length * pi * 0.2 * 0.2);
    // A cube grown by a radius: the inner cube, its faces, edges (four quarter cylinders each way)
    // and corners (a ball).
    let (inner, r) = (1.28f64, 0.16f64);
    near(
        "cube",
        inner.powi(3)
            + 6.0 * inner * inner * r
            + 3.0 * inner * pi * r * r
            + 4.0 / 3.0 * pi * r.powi(3),
    );
    for name in ["blob", "creature", "vase"] {
        assert!(volume(&shape(name).unwrap()) > 0.1, "{name}");
    }
}

/// The thesis's scenes have their numbers of triangles: a surface of 5,000 with a ball of 400, and
/// a city of 27,860.
#[test]
fn the_thesis_scenes_have_their_triangles() {
    for (name, count) in [("waves", 5_000), ("ball", 400), ("city", 27_860)] {
        assert_eq!(shape(name).unwrap().triangle_count(), count, "{name}");
    }
    assert_eq!(euler(&shape("ball").unwrap(), "ball"), 2);
    let city = shape("city").unwrap();
    let mut walls = 0;
    for quad in city.indices.chunks_exact(6) {
        // Walls show whole repeats of a texture: their corners lie at whole texture coordinates.
        let is_wall = city.normals[quad[0] as usize][1].abs() < 0.5;
        walls += usize::from(is_wall);
        for &v in quad {
            let v = v as usize;
            let uv = city.uvs[v];
            assert!(!is_wall || uv.iter().all(|x| *x == x.round()), "{uv:?}");
            let p = city.positions[v];
            assert!(
                p[0].abs() <= 1.0001 && p[2].abs() <= 1.0001 && (0.0..0.9).contains(&p[1]),
                "{p:?}"
            );
        }
        // Seen by a viewer of the wall u grows to the right and v up: the tangent frame is
        // right-handed.
        assert_eq!(city.tangents[quad[0] as usize][3], 1.0);
    }
    assert_eq!(walls, 4 * 2_785);
}

#[test]
fn every_shape_is_sound() {
    for about in SHAPES {
        let name = about.name;
        let mesh = shape(name).unwrap();
        assert_eq!(mesh.name, name);
        let count = mesh.positions.len();
        let lengths =
            [mesh.normals.len(), mesh.tangents.len(), mesh.uvs.len(), mesh.all_colors().len()];
        assert_eq!(lengths, [count; 4], "{name}");
        assert!(mesh.indices.iter().all(|&i| (i as usize) < count), "{name}");
        assert!(mesh.has_uvs && mesh.has_normals && !mesh.has_colors, "{name}");
        assert_eq!(
            (mesh.parts.len(), mesh.parts[0].indices.clone()),
            (1, 0..mesh.indices.len() as u32),
            "{name}"
        );
        assert!(mesh.colors.is_empty(), "{name}");
        for v in 0..count {
            let (normal, tangent) = (Vec3::from(mesh.normals[v]), Vec4::from(mesh.tangents[v]));
            assert!(
                mesh.positions[v].iter().chain(&mesh.uvs[v]).all(|x| x.is_finite()),
                "{name} {v}"
            );
            assert!((normal.length() - 1.0).abs() < 1e-5, "{name} {v}: {normal}");
            assert!((tangent.truncate().length() - 1.0).abs() < 1e-5, "{name} {v}: {tangent}");
            assert!(tangent.truncate().dot(normal).abs() < 1e-5, "{name} {v}");
            assert_eq!(tangent.w.abs(), 1.0, "{name} {v}");
        }
        let radius = mesh.bounds().radius;
        assert!((0.7..1.7).contains(&radius), "{name}: {radius}");
    }
    assert!(shape("teapot").is_none());
}

#[test]
fn normals_agree_with_the_triangles() {
    for about in SHAPES {
        let mesh = shape(about.name).unwrap();
        let mut against = 0;
        for t in triangles(&mesh) {
            let [a, b, c] = t.map(|i| Vec3::from(mesh.positions[i]));
            let face = (b - a).cross(c - a).normalize_or_zero();
            against += usize::from(t.iter().any(|&i| face.dot(mesh.normals[i].into()) < 0.2));
        }
        // In the creature's narrowest folds a triangle is wider than the fold.
        let allowed = if about.name == "creature" { mesh.triangle_count() / 200 } else { 0 };
        assert!(against <= allowed, "{}: {against} of {}", about.name, mesh.triangle_count());
    }
}

#[test]
fn the_sphere_is_one() {
    let mesh = shape("sphere").unwrap();
    for (p, n) in mesh.positions.iter().zip(&mesh.normals) {
        assert!(Vec3::from(*p).distance(Vec3::from(*n)) < 1e-6);
    }
    // The sphere's tangent points east, its bitangent north.
    for (v, uv) in mesh.uvs.iter().enumerate().filter(|(_, uv)| (0.01..0.99).contains(&uv[1])) {
        let longitude = (f64::from(uv[0]) - 0.5) * std::f64::consts::TAU;
        let east = Vec3::new(longitude.cos() as f32, 0.0, -longitude.sin() as f32);
        let tangent = Vec4::from(mesh.tangents[v]);
        assert!(tangent.truncate().dot(east) > 0.999, "{uv:?} {tangent} {east}");
        let north = Vec3::from(mesh.normals[v]).cross(tangent.truncate()) * tangent.w;
        assert!(north.y > 0.0, "{uv:?}");
    }
}

#[test]
fn the_organic_shapes_are_dense_and_hollow() {
    for name in ["blob", "creature"] {
        let mesh = shape(name).unwrap();
        assert!(
            (30_000..=90_000).contains(&mesh.triangle_count()),
            "{name}: {}",
            mesh.triangle_count()
        );
        // An edge is concave where the neighbor's far corner lies in front of the triangle.
        let places = places(&mesh);
        let mut apex: HashMap<(usize, usize), Vec3> = HashMap::new();
        let at = |i: usize| Vec3::from(mesh.positions[i]);
        for t in triangles(&mesh) {
            for k in 0..3 {
                apex.insert((places[t[k]], places[t[(k + 1) % 3]]), at(t[(k + 2) % 3]));
            }
        }
        let (mut concave, mut all) = (0, 0);
        for t in triangles(&mesh) {
            let normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).normalize_or_zero();
            for k in 0..3 {
                let across = apex[&(places[t[(k + 1) % 3]], places[t[k]])] - at(t[k]);
                concave += usize::from(normal.dot(across) > 1e-4);
                all += 1;
            }
        }
        let share = concave as f64 / all as f64;
        assert!((0.1..0.7).contains(&share), "{name}: {share}");
    }
}
