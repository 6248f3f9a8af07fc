//! Outlines against forms whose edges are known: coverage of pixels by many samples in f64.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]

use crate::support::eval::{look, renderer, scene_of, shape};
use crate::support::front::{
    PIXELS, SIZE, drawn, first_numbers, from_front, place, planned, share,
};
use chiaro::frame::{Setup, SetupLook};
use chiaro::geometry::{Mesh, MeshPart};
use chiaro::library::PassId;
use chiaro::reference::Reference;
use glam::{DMat4, DQuat, DVec2, DVec3};
use serde_json::{Value as Json, json};

/// A look that shows an output of an outline whose kinds have these shares of the width: of
/// silhouettes, creases, borders of objects and borders of materials.
fn outlined(output: &str, width: f64, shares: [f64; 4]) -> SetupLook {
    let [silhouettes, creases, borders, material_borders] = shares;
    shown(
        output,
        &json!({"unit": "pixels", "width": width, "silhouettes": silhouettes,
            "creases": creases, "borders": borders, "material_borders": material_borders}),
    )
}

fn shown(output: &str, values: &Json) -> SetupLook {
    look(&json!({"nodes": [{"id": "lines", "kind": "outline", "values": values},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": format!("lines.{output}"), "to": "output.color"}]}))
}

/// The first number of each pixel that shows anything, on the GPU.
fn on_gpu(setup: &Setup) -> Vec<Option<f64>> {
    first_numbers(&drawn(&mut *renderer(), &planned(setup, 1)))
}

/// Greatest and mean difference of lines from the truth, over those pixels within `area` in which a
/// line begins or ends.
fn errors(
    found: &[Option<f64>],
    is_line: &dyn Fn(DVec2) -> bool,
    area: &dyn Fn(DVec2) -> bool,
) -> [f64; 2] {
    let (mut most, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
    for (pixel, found) in found.iter().enumerate() {
        let Some(found) = found.filter(|_| area(place(pixel, DVec2::splat(0.5)))) else { continue };
        let truth = share(pixel, is_line);
        let error = (found - truth).abs();
        most = most.max(error);
        if truth > 0.0 && truth < 1.0 {
            (sum, count) = (sum + error, count + 1.0);
        }
    }
    assert!(count > 50.0, "{count} pixels of edges");
    [most, sum / count]
}

/// Triangles with a normal at each corner.
fn mesh_of(corners: &[[(DVec3, DVec3); 3]]) -> Mesh {
    let all = || corners.iter().flatten();
    let indices: Vec<u32> = (0..3 * corners.len() as u32).collect();
    Mesh {
        positions: all().map(|(at, _)| at.as_vec3().to_array()).collect(),
        normals: all().map(|(_, normal)| normal.as_vec3().to_array()).collect(),
        tangents: vec![[1.0, 0.0, 0.0, 1.0]; indices.len()],
        uvs: vec![[0.0; 2]; indices.len()],
        parts: vec![MeshPart { indices: 0..indices.len() as u32, ..MeshPart::default() }],
        indices,
        ..Mesh::default()
    }
}

/// The unit sphere in so many slices around.
fn sphere_of(slices: usize) -> Mesh {
    let at = |row: usize, slice: usize| {
        let polar = std::f64::consts::PI * row as f64 / (slices / 2) as f64;
        let around = std::f64::consts::TAU * slice as f64 / slices as f64;
        let at = DVec3::new(polar.sin() * around.cos(), polar.cos(), -polar.sin() * around.sin());
        (at, at)
    };
    let mut corners = Vec::new();
    for row in 0..slices / 2 {
        for slice in 0..slices {
            let [a, b] = [at(row, slice), at(row, slice + 1)];
            let [c, d] = [at(row + 1, slice), at(row + 1, slice + 1)];
            corners.extend([[a, c, d], [a, d, b]]);
        }
    }
    mesh_of(&corners)
}

/// A box from -1 to 1 with sharp edges.
fn sharp_box() -> Mesh {
    let mut corners = Vec::new();
    for side in 0..6 {
        let out = DVec3::AXES[side / 2] * if side % 2 == 0 { 1.0 } else { -1.0 };
        let right = DVec3::AXES[(side / 2 + 1) % 3];
        let up = out.cross(right);
        let [a, b, c, d] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| (out + x * right + y * up, out));
        corners.extend([[a, b, c], [a, c, d]]);
    }
    mesh_of(&corners)
}

/// Distance from a place to a piece of a straight line.
fn distance(at: DVec2, [from, to]: [DVec2; 2]) -> f64 {
    let way = to - from;
    let share = ((at - from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
    at.distance(from + share * way)
}

/// A ball in the middle but for a part of a pixel, and its radius in pixels.
fn ball(mesh: Mesh, radius: f64, shift: DVec2, look: SetupLook) -> Setup {
    let placed = DMat4::from_translation((shift / PIXELS).extend(0.0))
        * DMat4::from_scale(DVec3::splat(radius / PIXELS));
    scene_of(vec![(look, mesh, placed)], from_front())
}

#[test]
fn silhouettes_of_a_ball_are_as_wide_as_they_are_told() {
    for (slices, radius, width, bounds) in [
        (256, 50.0, 6.0, [0.1, 0.02]),
        (256, 20.0, 3.0, [0.12, 0.03]),
        // Few slices end up to a quarter of a pixel within the ball that is compared.
        (32, 50.0, 6.0, [0.5, 0.22]),
    ] {
        let (mut most, mut mean) = (0.0_f64, 0.0_f64);
        for shift in [DVec2::ZERO, DVec2::new(0.31, 0.17), DVec2::new(0.5, -0.42)] {
            let look = outlined("line", width, [1.0, 0.0, 0.0, 0.0]);
            let found = on_gpu(&ball(sphere_of(slices), radius, shift, look));
            let is_line = |at: DVec2| at.distance(shift) >= radius - width;
            let errors = errors(&found, &is_line, &|at| at.distance(shift) < radius - 1.0);
            (most, mean) = (most.max(errors[0]), mean.max(errors[1]));
        }
        println!("ball of {slices} slices, {radius} pixels: {most:.3}, mean {mean:.4}");
        assert!(most <= bounds[0] && mean <= bounds[1], "{slices}, {radius}: {most}, {mean}");
    }
}

/// The corners of the turned box in pixels, and how it is turned.
fn turned_box(angle: f64) -> (DQuat, impl Fn(DVec3) -> DVec2) {
    let turn = DQuat::from_rotation_x(0.6)
        * DQuat::from_rotation_y(0.5 + angle)
        * DQuat::from_rotation_z(0.17 + 0.2 * angle);
    (turn, move |corner: DVec3| PIXELS * (turn * corner).truncate())
}

/// Edges of the box: both ends, and the normals of the two sides.
fn box_edges() -> Vec<([DVec3; 2], [DVec3; 2])> {
    let mut edges = Vec::new();
    for axis in 0..3 {
        let (along, a, b) =
            (DVec3::AXES[axis], DVec3::AXES[(axis + 1) % 3], DVec3::AXES[(axis + 2) % 3]);
        for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            let middle = x * a + y * b;
            edges.push(([middle - along, middle + along], [x * a, y * b]));
        }
    }
    edges
}

#[test]
fn creases_and_silhouettes_of_a_box_lie_where_its_edges_are() {
    let (mut crease, mut outer) = ([0.0_f64; 2], [0.0_f64; 2]);
    for step in 0..6 {
        let (turn, seen) = turned_box(0.13 * f64::from(step));
        let is_front = |normal: DVec3| (turn * normal).z > 0.0;
        let of = |wanted: usize| -> Vec<[DVec2; 2]> {
            let edges = box_edges().into_iter();
            let count =
                |sides: [DVec3; 2]| sides.into_iter().filter(|side| is_front(*side)).count();
            edges
                .filter(|(_, sides)| count(*sides) == wanted)
                .map(|(ends, _)| ends.map(&seen))
                .collect()
        };
        let (folds, ends) = (of(2), of(1));
        let near = |edges: &[[DVec2; 2]], at: DVec2| {
            edges.iter().map(|edge| distance(at, *edge)).fold(f64::INFINITY, f64::min)
        };
        let drawn = |shares: [f64; 4]| {
            let look = outlined("line", 4.0, shares);
            let placed = DMat4::from_quat(turn);
            on_gpu(&scene_of(vec![(look, sharp_box(), placed)], from_front()))
        };
        let found = drawn([0.0, 1.0, 0.0, 0.0]);
        let errors_of = |found: &[Option<f64>], edges: &[[DVec2; 2]], width: f64| {
            errors(found, &|at| near(edges, at) <= width, &|at| near(&ends, at) > 2.0)
        };
        let found_errors = errors_of(&found, &folds, 2.0);
        crease = [0, 1].map(|index| crease[index].max(found_errors[index]));
        let found_errors = errors_of(&drawn([1.0, 0.0, 0.0, 0.0]), &ends, 4.0);
        outer = [0, 1].map(|index| outer[index].max(found_errors[index]));
    }
    println!("creases of a box: {crease:.3?}; silhouettes: {outer:.3?}");
    assert!(crease[0] <= 0.2 && crease[1] <= 0.025, "creases: {crease:?}");
    assert!(outer[0] <= 0.55 && outer[1] <= 0.09, "silhouettes: {outer:?}");
}

#[test]
fn two_objects_that_meet_draw_half_of_a_line_each() {
    let width = 5.0;
    let look = || outlined("line", width, [0.0, 0.0, 1.0, 0.0]);
    // The wall cuts a cap off the ball.
    let (radius, depth) = (1.4, 0.7_f64);
    let ring = PIXELS * (radius * radius - depth * depth).sqrt();
    let (wall, _) = shape("plane");
    let parts = vec![
        (
            look(),
            sphere_of(256),
            DMat4::from_translation(DVec3::new(0.0, 0.0, -depth))
                * DMat4::from_scale(DVec3::splat(radius)),
        ),
        (look(), wall, DMat4::from_scale(DVec3::splat(4.0))),
    ];
    let found = on_gpu(&scene_of(parts, from_front()));
    let is_line = |at: DVec2| (at.length() - ring).abs() <= 0.5 * width;
    let [most, mean] = errors(&found, &is_line, &|at| at.length() < 60.0);
    println!("a cap on a wall: {most:.3}, mean {mean:.4}");
    assert!(most <= 0.1 && mean <= 0.03, "{most}, {mean}");
}

#[test]
fn materials_of_an_object_that_meet_draw_half_of_a_line_each() {
    let width = 4.0;
    let at = |x: f64, y: f64| (DVec3::new(x, y, 0.0), DVec3::Z);
    for slope in [0.0, 0.07, 0.23, 0.61, 1.0] {
        // A square that a slanted line cuts in two.
        let [low, high] = [0.013 - 2.0 * slope, 0.013 + 2.0 * slope];
        let [a, b, c, d] = [at(-2.0, -4.0), at(2.0, -4.0), at(2.0, 4.0), at(-2.0, 4.0)];
        let [left, right] = [at(-2.0, low), at(2.0, high)];
        let mut mesh = mesh_of(&[[a, b, right], [a, right, left], [left, right, c], [left, c, d]]);
        mesh.parts = vec![
            MeshPart { material: "low".into(), indices: 0..6, ..MeshPart::default() },
            MeshPart { material: "high".into(), indices: 6..12, ..MeshPart::default() },
        ];
        let mut setup = scene_of(
            vec![(outlined("line", width, [0.0, 0.0, 0.0, 1.0]), mesh, DMat4::IDENTITY)],
            from_front(),
        );
        // Both parts wear one look.
        setup.objects[0].looks = vec![Some(0); 2];
        let found = on_gpu(&setup);
        let ends = [left, right].map(|(at, _)| PIXELS * at.truncate());
        let is_line = |at: DVec2| distance(at, ends) <= 0.5 * width;
        let [most, mean] = errors(&found, &is_line, &|at| at.abs().max_element() < 50.0);
        println!("two materials, slope {slope}: {most:.3}, mean {mean:.4}");
        // What runs along the pixels may lie anywhere between two rows.
        let bounds = if slope == 0.0 { [0.51, 0.51] } else { [0.15, 0.06] };
        assert!(most <= bounds[0] && mean <= bounds[1], "{slope}: {most}, {mean}");
    }
}

/// A look whose outlines show borders of materials and ids, in these shares of a width of four
/// pixels. Its ids count units along x: they change at halves.
fn numbered(output: &str, materials: f64, ids: f64) -> SetupLook {
    look(&json!({"nodes": [
            {"id": "at", "kind": "position", "values": {"space": "object"}},
            {"id": "parts", "kind": "separate_vector"},
            {"id": "lines", "kind": "outline", "values": {"unit": "pixels", "width": 4.0,
                "silhouettes": 0.0, "creases": 0.0, "borders": 0.0,
                "material_borders": materials, "id_borders": ids}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "at", "to": "parts.vector"}, {"from": "parts.x", "to": "output.id"},
            {"from": format!("lines.{output}"), "to": "output.color"}]}))
}

/// Ids and materials have widths of their own, side by side on one surface.
#[test]
fn ids_and_materials_have_lines_of_their_own() {
    let at = |x: f64, y: f64| (DVec3::new(x, y, 0.0), DVec3::Z);
    // A strip of two materials, which meet at y = 0.05; ids change at x = -0.5, 0.5 and so on.
    let square = |low: f64, high: f64| {
        let [a, b, c, d] = [at(-3.0, low), at(3.0, low), at(3.0, high), at(-3.0, high)];
        [[a, b, c], [a, c, d]]
    };
    let mut mesh = mesh_of(&[square(-3.0, 0.05), square(0.05, 3.0)].concat());
    mesh.parts = vec![
        MeshPart { material: "low".into(), indices: 0..6, ..MeshPart::default() },
        MeshPart { material: "high".into(), indices: 6..12, ..MeshPart::default() },
    ];
    let turn = 0.3_f64;
    let drawn_with = |output: &str, materials: f64, ids: f64| {
        let look = numbered(output, materials, ids);
        let placed = DMat4::from_rotation_z(turn);
        let mut setup = scene_of(vec![(look, mesh.clone(), placed)], from_front());
        setup.objects[0].looks = vec![Some(0); 2];
        setup
    };
    let own = |at: DVec2| DVec2::from_angle(-turn).rotate(at) / PIXELS;
    let from_material = |at: DVec2| PIXELS * (own(at).y - 0.05).abs();
    let from_id = |at: DVec2| PIXELS * ((own(at).x - 0.5) - (own(at).x - 0.5).round()).abs();
    for (materials, ids) in [(1.0, 0.0), (0.0, 1.0), (1.0, 0.5)] {
        let is_line = |at: DVec2| {
            from_material(at) <= 2.0 * materials && materials > 0.0
                || from_id(at) <= 2.0 * ids && ids > 0.0
        };
        // Where both are near, the nearer one says the width.
        let is_apart = |at: DVec2| from_material(at).max(from_id(at)) > 6.0;
        let found = on_gpu(&drawn_with("line", materials, ids));
        let [most, mean] =
            errors(&found, &is_line, &|at| is_apart(at) && at.abs().max_element() < 50.0);
        println!("materials {materials}, ids {ids}: {most:.3}, mean {mean:.4}");
        assert!(most <= 0.25 && mean <= 0.06, "{materials}, {ids}: {most}, {mean}");
    }
    let kinds = on_gpu(&drawn_with("kind", 1.0, 1.0));
    for (pixel, kind) in kinds.iter().enumerate() {
        let at = place(pixel, DVec2::splat(0.5));
        let (material, id) = (from_material(at), from_id(at));
        if at.abs().max_element() < 50.0 && material.max(id) > 6.0 && material.min(id) < 1.0 {
            let truth = if material < id { 4.0 } else { 5.0 };
            assert_eq!(*kind, Some(truth), "{at}");
        }
    }
    let plan = planned(&drawn_with("line", 1.0, 0.6), 1);
    let (gpu, truth) = (drawn(&mut *renderer(), &plan), drawn(&mut Reference::default(), &plan));
    let pairs = gpu.rgba.iter().zip(&truth.rgba);
    let far = pairs.filter(|(a, b)| (a[0] - b[0]).abs() > 0.02).count();
    assert!(far * 200 < gpu.rgba.len(), "{far} pixels differ from the reference");
}

#[test]
fn lines_move_with_what_they_are_around() {
    let (radius, width) = (40.0, 5.0);
    let inner = std::f64::consts::PI * (radius - width) * (radius - width);
    let mut before = None;
    for step in 0..=32 {
        let shift = DVec2::new(f64::from(step) / 32.0, 0.3 * f64::from(step) / 32.0);
        let look = outlined("line", width, [1.0, 0.0, 0.0, 0.0]);
        let found = on_gpu(&ball(sphere_of(128), radius, shift, look));
        // The area within the line, which pixels at the outside have no part in.
        let within: f64 = found.iter().flatten().map(|line| 1.0 - line).sum();
        assert!((within - inner).abs() < 0.01 * inner, "step {step}: {within}, not {inner}");
        let change = before.map_or(0.0, |before: f64| (within - before).abs());
        assert!(change < 0.004 * inner, "step {step}: {change} of {inner}");
        before = Some(within);
    }
}

#[test]
fn lines_are_the_same_on_a_gpu_and_in_truth() {
    let (wall, _) = shape("plane");
    for samples in [1, 4] {
        for output in ["line", "kind", "distance"] {
            let look = || outlined(output, 5.0, [1.0, 0.7, 1.0, 0.5]);
            let parts = vec![
                (look(), shape("knot").0, DMat4::from_rotation_x(0.4)),
                (look(), sharp_box(), DMat4::from_rotation_y(0.7)),
                (look(), wall.clone(), DMat4::from_rotation_x(-0.3)),
            ];
            let plan = planned(&scene_of(parts, from_front()), samples);
            let gpu = drawn(&mut *renderer(), &plan);
            let truth = drawn(&mut Reference::default(), &plan);
            let pairs = gpu.rgba.iter().zip(&truth.rgba);
            let far = pairs.filter(|(a, b)| (a[0] - b[0]).abs() > 0.02).count();
            println!("{output}, {samples} samples: {far} pixels differ");
            assert!(far * 200 < gpu.rgba.len(), "{output}, {samples}: {far}");
        }
    }
}

/// With several samples a pixel, ink in front of another object reaches its silhouette, and does
/// not reach beyond.
#[test]
fn ink_ends_where_what_wears_it_ends() {
    let plain = |tone: f64| {
        look(&json!({"nodes": [
            {"id": "tone", "kind": "color_value", "values": {"color": [tone, tone, tone, 1.0]}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "tone", "to": "output.color"}]}))
    };
    let radius = 40.0;
    let (wall, _) = shape("plane");
    let ball = DMat4::from_scale(DVec3::splat(radius / PIXELS));
    let behind =
        DMat4::from_translation(DVec3::new(0.0, 0.0, -3.0)) * DMat4::from_scale(DVec3::splat(4.0));
    let inked = || outlined("line", 5.0, [1.0, 0.0, 1.0, 0.0]);
    for (behind_look, outside) in [(plain(1.0), 1.0), (inked(), 0.0)] {
        let parts = vec![(inked(), sphere_of(256), ball), (behind_look, wall.clone(), behind)];
        let picture = drawn(&mut *renderer(), &planned(&scene_of(parts, from_front()), 4));
        for (pixel, color) in picture.rgba.iter().enumerate() {
            let at = place(pixel, DVec2::splat(0.5)).length();
            let tone = f64::from(color[0]);
            if at > radius - 3.0 && at < radius - 0.8 {
                assert!(tone > 0.99, "{at}: {tone}");
            } else if at > radius + 0.8 && at < radius + 10.0 {
                assert!((tone - outside).abs() < 0.01, "{at}: {tone}");
            } else if outside == 1.0 && at > radius - 3.0 && at < radius + 10.0 {
                assert!(tone > 0.99, "{at}: {tone}, between ink and white");
            }
        }
    }
}

#[test]
fn passes_of_lines_exist_only_where_a_look_asks() {
    let passes = |setup: &Setup| {
        let plan = planned(setup, 1);
        plan.passes.iter().map(|pass| format!("{:?}", pass.id)).collect::<Vec<_>>()
    };
    let asks = |look: SetupLook| {
        let found = passes(&ball(sphere_of(16), 20.0, DVec2::ZERO, look));
        found.len() > 1
    };
    assert!(asks(outlined("line", 4.0, [1.0; 4])));
    assert!(asks(shown("line", &json!({"unit": "scene"}))));
    let unread = look(&json!({"nodes": [{"id": "lines", "kind": "outline"},
            {"id": "tone", "kind": "color_value"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "tone", "to": "output.color"}]}));
    assert!(!asks(unread));
    // An object out of the picture asks for nothing.
    let aside = DVec2::new(500.0, 0.0);
    let away = passes(&ball(sphere_of(16), 20.0, aside, outlined("line", 4.0, [1.0; 4])));
    assert_eq!(away, [format!("{:?}", PassId::LOOK)]);
}

/// A thing with a ball, a fold and a hollow, at some angle.
fn knot_with(look: SetupLook) -> Setup {
    scene_of(vec![(look, shape("knot").0, DMat4::from_rotation_x(0.5))], from_front())
}

#[test]
fn units_say_the_same_width() {
    let drawn = |unit: &str, width: f64| {
        on_gpu(&knot_with(shown("line", &json!({"unit": unit, "width": width}))))
    };
    let pixels = drawn("pixels", 3.2);
    let lines = pixels.iter().flatten().filter(|line| **line > 0.5).count();
    assert!(lines > 300, "{lines} pixels of lines");
    for (unit, width) in [("scene", 3.2 / PIXELS), ("height", 3200.0 / f64::from(SIZE))] {
        let other = drawn(unit, width);
        let is_same = |(a, b): (&Option<f64>, &Option<f64>)| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() < 2e-3,
            (a, b) => a.is_none() && b.is_none(),
        };
        assert!(pixels.iter().zip(&other).all(is_same), "{unit}");
    }
}

/// The fast tier reaches half as far, and is the same within.
#[test]
fn thin_lines_are_the_same_in_the_fast_tier() {
    let drawn = |tier: &str, width: f64| {
        let nodes = json!({"nodes": [
            {"id": "lines", "kind": "outline", "tier": tier,
                "values": {"unit": "pixels", "width": width}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "lines.line", "to": "output.color"}]});
        on_gpu(&ball(sphere_of(64), 50.0, DVec2::ZERO, look(&nodes)))
    };
    let differ = |width: f64| {
        let [exact, fast] = ["exact", "fast"].map(|tier| drawn(tier, width));
        let apart = |(a, b): &(&Option<f64>, &Option<f64>)| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() > 2e-3,
            _ => false,
        };
        exact.iter().zip(&fast).filter(apart).count()
    };
    assert_eq!(differ(5.0), 0);
    assert!(differ(14.0) > 100);
}

/// A wall that reaches out of the picture has no line where the picture ends.
#[test]
fn the_edge_of_the_picture_is_no_edge() {
    let (wall, _) = shape("plane");
    let placed = DMat4::from_rotation_x(-0.7) * DMat4::from_scale(DVec3::splat(20.0));
    let look = outlined("line", 6.0, [1.0; 4]);
    let found = on_gpu(&scene_of(vec![(look, wall, placed)], from_front()));
    assert!(found.iter().all(|line| *line == Some(0.0)));
}
