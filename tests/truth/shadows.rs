//! Shadows by rays of their own in f64, each past all triangles: coverage of pixels at edges, soft
//! shadows, blockers, and hard cases.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]

use std::collections::HashMap;

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::document::{Camera, LightSet, Object, ObjectSet, Projection, Scene, ShadowLink, Tier};
use chiaro::frame::{Executor, FramePlan, PlanOptions, PlanStyle, Setup, SetupLook};
use chiaro::geometry::{Mesh, MeshPart};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::Reference;
use glam::{DMat4, DVec2, DVec3};
use serde_json::{Value as Json, json};

/// Width and height of the pictures.
pub(super) const SIZE: u32 = 96;

/// Height of what the camera sees, which looks down from above.
pub(super) const SEEN: f64 = 4.0;

/// Light of a test.
#[derive(Clone, Copy, Debug)]
pub(super) enum TestLight {
    Sun(DVec3),
    Lamp(DVec3),
    /// A spot at a place that shines along a direction, with a cone wider than what is seen.
    Spot(DVec3, DVec3),
}

impl TestLight {
    fn json(self) -> Json {
        match self {
            Self::Sun(toward) => json!({"direction": toward.to_array(), "space": "world"}),
            Self::Lamp(place) => {
                json!({"type": "point", "position": place.to_array(), "space": "world"})
            }
            Self::Spot(place, aim) => json!({"type": "spot", "position": place.to_array(),
                "aim": aim.to_array(), "inner": 1.2, "outer": 1.4, "space": "world"}),
        }
    }

    /// The light moved aside: a lamp by so much, a sun at a distance of 1.
    fn moved(self, aside: DVec3) -> Self {
        match self {
            Self::Sun(toward) => Self::Sun(toward + aside),
            Self::Lamp(place) => Self::Lamp(place + aside),
            Self::Spot(place, aim) => Self::Spot(place + aside, aim),
        }
    }

    /// The way to it from a place: the direction, of length 1, and how far it is.
    fn way(self, place: DVec3) -> (DVec3, f64) {
        match self {
            Self::Sun(toward) => (toward.normalize(), f64::INFINITY),
            Self::Lamp(lamp) | Self::Spot(lamp, _) => {
                ((lamp - place).normalize(), lamp.distance(place))
            }
        }
    }
}

/// A look that shows an output of a node of a kind.
pub(super) fn shown(kind: &str, output: &str, light: TestLight, values: &Json) -> SetupLook {
    let mut values = values.clone();
    values["light"] = json!("key");
    look(&json!({"lights": {"key": light.json()}, 
            "nodes": [{"id": "shadow", "kind": kind, "values": values},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": format!("shadow.{output}"), "to": "output.color"}]}))
}

/// A look that shows nothing of a light.
pub(super) fn plain() -> SetupLook {
    look(&json!({"nodes": [{"id": "gray", "kind": "color_value"},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "gray", "to": "output.color"}]}))
}

/// A scene over which the camera looks down the y axis from a height, x to the right and -z up. It
/// sees the floor and nothing above itself.
fn from_above(height: f64) -> Scene {
    let camera = Camera {
        eye: [0.0, height, 0.0],
        target: [0.0; 3],
        up: [0.0, 0.0, -1.0],
        fov: 2.0 * (0.5 * SEEN / height).atan(),
        ..Camera::default()
    };
    Scene { backdrop: None, camera, ..Scene::default() }
}

/// A square floor at y = 0.
pub(super) fn floor() -> (Mesh, DMat4) {
    let (mesh, _) = shape("plane");
    (
        mesh,
        DMat4::from_rotation_x(-std::f64::consts::FRAC_PI_2) * DMat4::from_scale(DVec3::splat(8.0)),
    )
}

fn planned(setup: &Setup, style: PlanStyle) -> FramePlan {
    planned_at(setup, style, SIZE)
}

fn planned_at(setup: &Setup, style: PlanStyle, size: u32) -> FramePlan {
    let options = PlanOptions { size: [size; 2], samples: 1, time: 0.0 };
    let planned =
        style.planner(Default::default()).plan(setup, Library::built_in(), &style.live(), &options);
    planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value
}

/// The first number of each pixel on the GPU; exact nodes.
pub(super) fn on_gpu(setup: &Setup) -> Vec<f64> {
    on_gpu_at(setup, SIZE)
}

fn on_gpu_at(setup: &Setup, size: u32) -> Vec<f64> {
    let plan = planned_at(setup, PlanStyle::Specialized, size);
    let drawn = block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"));
    drawn.rgba.iter().map(|pixel| f64::from(pixel[0])).collect()
}

/// All corners of the triangles of placed meshes.
fn triangles(parts: &[(Mesh, DMat4)]) -> Vec<[DVec3; 3]> {
    let of = |(mesh, placed): &(Mesh, DMat4)| {
        let placed = *placed;
        let at = |index: u32| DVec3::from(mesh.positions[index as usize].map(f64::from));
        let corners = mesh.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]].map(at));
        corners.map(|corners| corners.map(|p| placed.transform_point3(p))).collect::<Vec<_>>()
    };
    parts.iter().flat_map(of).collect()
}

/// Distance that a ray comes before a triangle: the plane is met, and the place lies on the same
/// side of all three edges.
fn met(origin: DVec3, direction: DVec3, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let normal = (b - a).cross(c - a);
    let slope = normal.dot(direction);
    if slope == 0.0 {
        return None;
    }
    let distance = normal.dot(a - origin) / slope;
    let place = origin + distance * direction;
    let beside = |from: DVec3, to: DVec3| normal.dot((to - from).cross(place - from)) >= 0.0;
    (distance > 1e-9 && beside(a, b) && beside(b, c) && beside(c, a)).then_some(distance)
}

fn first_met(origin: DVec3, light: TestLight, blockers: &[[DVec3; 3]]) -> Option<f64> {
    let (direction, end) = light.way(origin);
    let distances = blockers.iter().filter_map(|t| met(origin, direction, *t));
    distances.filter(|distance| *distance < end).reduce(f64::min)
}

/// Triangles with the box around each one's shadow on the floor, by x and z.
struct FloorShadows(Vec<([DVec2; 2], [DVec3; 3])>);

impl FloorShadows {
    fn new(light: TestLight, blockers: &[[DVec3; 3]]) -> Self {
        let fallen = |corner: DVec3| {
            let (toward, _) = light.way(corner);
            let place = corner - toward * (corner.y / toward.y);
            DVec2::new(place.x, place.z)
        };
        let boxed = |triangle: &[DVec3; 3]| {
            let [a, b, c] = triangle.map(fallen);
            ([a.min(b).min(c) - 1e-6, a.max(b).max(c) + 1e-6], *triangle)
        };
        Self(blockers.iter().map(boxed).collect())
    }

    /// Triangles whose boxes meet a pixel of the floor: no others can darken a place in it.
    fn of_pixel(&self, pixel: usize) -> Self {
        let [a, b] = [DVec2::ZERO, DVec2::ONE].map(|within| {
            let place = on_floor(pixel, within);
            DVec2::new(place.x, place.z)
        });
        let meets = |[least, most]: &[DVec2; 2]| a.cmple(*most).all() && b.cmpge(*least).all();
        Self(self.0.iter().filter(|(around, _)| meets(around)).copied().collect())
    }

    /// True if anything stands between a place of the floor and the light.
    fn is_dark(&self, place: DVec3, light: TestLight) -> bool {
        let at = DVec2::new(place.x, place.z);
        let near = self
            .0
            .iter()
            .filter(|([least, most], _)| at.cmpge(*least).all() && at.cmple(*most).all());
        let (direction, end) = light.way(place);
        near.filter_map(|(_, triangle)| met(place, direction, *triangle)).any(|d| d < end)
    }
}

/// The place on the floor under a pixel's place, from its upper left corner.
fn on_floor(pixel: usize, within: DVec2) -> DVec3 {
    let (x, y) = (pixel % SIZE as usize, pixel / SIZE as usize);
    let step = SEEN / f64::from(SIZE);
    let [right, down] = [x as f64 + within.x, y as f64 + within.y];
    DVec3::new(right * step - 0.5 * SEEN, 0.0, down * step - 0.5 * SEEN)
}

/// The share of a pixel of the floor in shadow, by so many rays from places of a lattice that has
/// each column, and each row, once.
fn share(pixel: usize, light: TestLight, blockers: &FloorShadows, rays: usize) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let place = |ray: usize| {
        let along = (ray as f64 + 0.5) / rays as f64;
        on_floor(pixel, DVec2::new(along, (ray as f64 * GOLDEN).fract()))
    };
    let blocked = (0..rays).filter(|ray| blockers.is_dark(place(*ray), light)).count();
    blocked as f64 / rays as f64
}

/// A floor of a look, with things above it that wear another.
pub(super) fn scene_on_floor(
    of_floor: SetupLook,
    things: Vec<(Mesh, DMat4)>,
    height: f64,
) -> Setup {
    let (mesh, placed) = floor();
    let mut parts = vec![(of_floor, mesh, placed)];
    parts.extend(things.into_iter().map(|(mesh, placed)| (plain(), mesh, placed)));
    scene_of(parts, from_above(height))
}

/// A box from -1 to 1 of 12 triangles.
pub(super) fn box_of_12() -> Mesh {
    let (mut positions, mut normals, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for side in 0..6 {
        let (axis, sign) = (side / 2, if side % 2 == 0 { 1.0 } else { -1.0 });
        let out = DVec3::AXES[axis] * sign;
        let right = DVec3::AXES[(axis + 1) % 3];
        let up = out.cross(right);
        let first = positions.len() as u32;
        for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            positions.push((out + x * right + y * up).as_vec3().to_array());
            normals.push(out.as_vec3().to_array());
        }
        indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
    }
    let parts = vec![MeshPart { indices: 0..indices.len() as u32, ..MeshPart::default() }];
    Mesh {
        tangents: vec![[1.0, 0.0, 0.0, 1.0]; positions.len()],
        uvs: vec![[0.0; 2]; positions.len()],
        positions,
        normals,
        indices,
        parts,
        ..Mesh::default()
    }
}

/// A box, or an own shape.
fn thing(name: &str) -> (Mesh, DMat4) {
    if name == "box" { (box_of_12(), DMat4::IDENTITY) } else { shape(name) }
}

/// A thing above the camera's view, so that it is not seen itself.
fn hung(name: &str, at: DVec3, size: f64) -> (Mesh, DMat4) {
    let (mesh, fitted) = thing(name);
    let turned = DMat4::from_rotation_y(0.4) * DMat4::from_rotation_x(0.3);
    (mesh, DMat4::from_translation(at) * DMat4::from_scale(DVec3::splat(size)) * turned * fitted)
}

/// Height of the eye, and of things that lights alone see.
pub(super) const EYE: f64 = 50.0;
pub(super) const UNSEEN: f64 = 60.0;

#[test]
fn edges_cover_as_much_of_a_pixel_as_many_rays_find() {
    let above = DVec3::new(0.3, UNSEEN, 0.2);
    for light in [
        TestLight::Sun(DVec3::new(0.02, 1.0, -0.015)),
        TestLight::Lamp(DVec3::new(0.6, 2.0 * UNSEEN, -0.4)),
    ] {
        for name in ["box", "torus"] {
            let thing = hung(name, above, 0.7);
            let blockers = FloorShadows::new(light, &triangles(std::slice::from_ref(&thing)));
            let setup =
                scene_on_floor(shown("cast_shadow", "shadow", light, &json!({})), vec![thing], EYE);
            let drawn = on_gpu(&setup);
            let mut edges: Vec<f64> = Vec::new();
            for (pixel, found) in drawn.iter().enumerate() {
                let blockers = blockers.of_pixel(pixel);
                let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.5, 0.5]];
                let dark =
                    |at: &[f64; 2]| blockers.is_dark(on_floor(pixel, DVec2::from(*at)), light);
                let count = corners.iter().filter(|at| dark(at)).count();
                if count == 0 || count == corners.len() {
                    let wanted = if count == 0 { 0.0 } else { 1.0 };
                    // Half floats hold the picture.
                    assert!((found - wanted).abs() < 0.02, "{name} {light:?} at {pixel}: {found}");
                } else {
                    // The rays of a lattice stand in rows, which miss as much of edges along them.
                    let off = |rays| (found - share(pixel, light, &blockers, rays)).abs();
                    let rough = off(1 << 10);
                    edges.push(if rough > 0.006 { off(1 << 14) } else { rough });
                }
            }
            assert!(edges.len() > 60, "{name}: {} pixels at edges", edges.len());
            edges.sort_by(f64::total_cmp);
            let most = edges[edges.len() - 1];
            let usual = edges[edges.len() * 9 / 10];
            println!("{name} {light:?}: {} at edges, 90% {usual:.4}, most {most:.4}", edges.len());
            // Half floats hold the picture.
            let bound = 1.02 / 64.0;
            assert!(usual < 0.5 * bound && most < bound, "{name} {light:?}: {usual}, {most}");
        }
    }
}

/// The f64 reference goes through the same tree with places in f64, and so does f32 but for
/// roundings at edges.
#[test]
fn the_reference_finds_the_same_shadows() {
    let light = TestLight::Sun(DVec3::new(0.4, 0.8, 0.3));
    let show = |kind: &str| shown(kind, "shadow", light, &json!({}));
    // The reference takes its time; most of what differs lies at edges, as at any size.
    let size = SIZE / 2;
    for kind in ["cast_shadow", "self_shadow"] {
        let (mesh, placed) = floor();
        let (creature, fitted) = shape("creature");
        let parts = vec![
            (show(kind), mesh, placed * DMat4::from_translation(DVec3::new(0.0, 0.0, -0.14))),
            (show(kind), creature, fitted),
        ];
        let scene = Scene {
            camera: Camera { eye: [0.5, 1.5, 4.0], ..Camera::default() },
            ..from_above(EYE)
        };
        let setup = scene_of(parts, scene);
        let drawn = on_gpu_at(&setup, size);
        let truth = {
            let plan = planned_at(&setup, PlanStyle::AsWritten, size);
            block_on(Executor::picture(&mut Reference::default(), &plan, &Progress::new()))
                .unwrap_or_else(|problem| panic!("{}", told(&[problem])))
        };
        let truth = truth.rgba.iter().map(|pixel| f64::from(pixel[0]));
        let far = drawn.iter().zip(truth).filter(|(a, b)| (*a - b).abs() > 1.0 / 64.0).count();
        assert!(drawn.iter().any(|x| *x > 0.9), "{kind}: nothing is in shadow");
        println!("{kind}: {far} of {} pixels differ by more than 1/64", drawn.len());
        assert!(far * 200 < drawn.len(), "{kind}: {far} pixels differ");
    }
}

/// A light that turns moves the edge of a shadow steadily: each step by as much as it should.
#[test]
fn an_edge_follows_its_light_without_swimming() {
    let cube = box_of_12();
    // Its lower edge is above x = 0.
    let beside = DMat4::from_translation(DVec3::new(-4.0, UNSEEN, 0.0))
        * DMat4::from_scale(DVec3::new(4.0, 0.5, 8.0));
    let edge = 0.0;
    let step = SEEN / f64::from(SIZE);
    let mut before: Option<f64> = None;
    for turn in 0..64 {
        // A thirtieth of a pixel a step.
        let moved = f64::from(turn) * step / 30.0;
        let light = TestLight::Sun(DVec3::new(-moved, UNSEEN - 0.5, 0.0));
        let things = vec![(cube.clone(), beside)];
        let setup = scene_on_floor(shown("cast_shadow", "shadow", light, &json!({})), things, EYE);
        let drawn = on_gpu(&setup);
        let row = SIZE as usize / 2;
        let dark: f64 = drawn[row * SIZE as usize..][..SIZE as usize].iter().sum();
        let place = dark * step - 0.5 * SEEN;
        let wanted = edge + moved;
        assert!((place - wanted).abs() < step / 20.0, "{turn}: {place} for {wanted}");
        if let Some(before) = before {
            assert!(place >= before - 1e-3 * step, "{turn}: the edge steps back");
        }
        before = Some(place);
    }
}

/// Shadows of lights with a size, against 4,096 rays from the pixel's middle to all of the light.
#[test]
fn soft_shadows_are_as_soft_as_4096_rays_find() {
    let above = DVec3::new(0.0, 2.0, 0.0);
    let thing = hung("box", above, 0.4);
    let blockers = triangles(std::slice::from_ref(&thing));
    let toward = DVec3::new(0.3, 1.0, 0.1).normalize();
    let lamp = 6.0 * toward;
    for (light, size) in [
        (TestLight::Sun(toward), 0.2),
        (TestLight::Lamp(lamp), 1.2),
        (TestLight::Spot(lamp, -toward), 1.2),
    ] {
        let look = shown("cast_shadow", "shadow", light, &json!({"size": size}));
        let drawn = on_gpu(&scene_on_floor(look, vec![thing.clone()], 1.2));
        let mut errors = Vec::new();
        let (mut lit, mut dark, mut most) = (0, 0, 0.0_f64);
        for pixel in (0..drawn.len()).step_by(91) {
            let place = on_floor(pixel, DVec2::splat(0.5));
            let (way, _) = light.way(place);
            let side = way.any_orthonormal_vector();
            let up = way.cross(side);
            let is_blocked = |ray: &usize| {
                // Rings of the same area.
                let (ring, spoke) = (ray / 64, ray % 64);
                let radius = size * ((ring as f64 + 0.5) / 64.0).sqrt();
                let angle = std::f64::consts::TAU * (spoke as f64 + 0.5) / 64.0;
                let aside = radius * (angle.cos() * side + angle.sin() * up);
                first_met(place, light.moved(aside), &blockers).is_some()
            };
            let share = (0..4096).filter(is_blocked).count() as f64 / 4096.0;
            lit += usize::from(share == 0.0);
            dark += usize::from(share > 0.5);
            let error = (drawn[pixel] - share).abs();
            most = most.max(error);
            if share > 0.0 && share < 1.0 {
                errors.push(error);
            }
        }
        // Of the pixels that see a part of the light.
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        println!("soft {light:?}: mean {mean:.4}, most {most:.4}, {lit} lit, {dark} dark");
        assert!(mean < 0.025 && most < 0.05, "{light:?}: mean {mean}, most {most}");
        assert!(lit > 10 && dark > 2, "{light:?}: {lit} lit, {dark} dark");
    }
}

#[test]
fn the_first_blocker_is_told_with_its_distance() {
    let lower = hung("torus", DVec3::new(0.4, 5.0, 0.0), 0.8);
    let upper = hung("sphere", DVec3::new(0.2, 9.0, 0.3), 1.0);
    let light = TestLight::Lamp(DVec3::new(0.5, 40.0, 0.2));
    let things = vec![lower.clone(), upper.clone()];
    let show = |output: &str| {
        let look = shown("shadow_blocker", output, light, &json!({}));
        on_gpu(&scene_on_floor(look, things.clone(), 2.0))
    };
    let (distances, objects) = (show("distance"), show("object"));
    let [lower, upper] = [lower, upper].map(|thing| triangles(&[thing]));
    let mut edges = 0;
    let mut seen = HashMap::from([(-1, 0), (1, 0), (2, 0)]);
    let tested = || (0..distances.len()).step_by(7);
    for pixel in tested() {
        let at = |within: [f64; 2]| {
            let place = on_floor(pixel, DVec2::from(within));
            match [&lower, &upper].map(|blockers| first_met(place, light, blockers)) {
                [None, None] => (0.0, -1),
                [Some(near), Some(far)] if far < near => (far, 2),
                [None, Some(far)] => (far, 2),
                [Some(near), _] => (near, 1),
            }
        };
        let (wanted, object) = at([0.5, 0.5]);
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        if corners.iter().any(|corner| at(*corner).1 != object) {
            // A pixel at an edge belongs to the shadow.
            edges += 1;
            assert!(objects[pixel] > -0.5, "{pixel}: nothing blocks a part of it");
            continue;
        }
        // The picture holds half floats.
        let is_same = (distances[pixel] - wanted).abs() < 0.01
            && (objects[pixel] - f64::from(object)).abs() < 0.01;
        *seen.entry(object).or_default() += usize::from(is_same);
    }
    println!("blockers: {seen:?} and {edges} at edges of {}", tested().count());
    let whole = edges + seen.values().sum::<usize>();
    assert!(seen.values().all(|count| *count > 50), "{seen:?}");
    assert!((tested().count() - whole) * 200 < tested().count(), "{seen:?}: others differ");
}

/// A ball above a floor hides (r/d)²·cos of what is seen from a place, weighted by the cosine: the
/// form factor of a sphere over the horizon.
#[test]
fn what_stands_close_hides_as_much_as_its_form_factor() {
    let (radius, middle) = (1.0, DVec3::new(0.3, 3.0, -0.2));
    let (ball, fitted) = shape("sphere");
    let ball = (ball, DMat4::from_translation(middle) * fitted);
    let [far, least] = triangles(std::slice::from_ref(&ball)).iter().flatten().fold(
        [0.0_f64, f64::INFINITY],
        |[far, least], corner| {
            let distance = corner.distance(middle);
            [far.max(distance), least.min(distance)]
        },
    );
    assert!(far < radius + 1e-6 && least > radius - 1e-6, "a ball of {least} to {far}");
    let shown = |near: f64, far: f64| {
        let look = look(&json!({"nodes": [
                {"id": "near", "kind": "occlusion", "values": {"near": near, "far": far}},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "near", "to": "output.color"}]}));
        // The camera stands under the ball.
        on_gpu(&scene_on_floor(look, vec![ball.clone()], 1.5))
    };
    let mut errors: Vec<f64> = Vec::new();
    let whole = shown(1e3, 1e3);
    for (pixel, found) in whole.iter().enumerate() {
        let way = middle - on_floor(pixel, DVec2::splat(0.5));
        let square = way.length_squared();
        let wanted = radius * radius / square * way.normalize().y;
        errors.push((found - wanted).abs());
    }
    errors.sort_by(f64::total_cmp);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let most = errors[errors.len() - 1];
    println!("occlusion: mean {mean:.4}, most {most:.4}");
    assert!(mean < 0.012 && most < 0.05, "mean {mean}, most {most}");
    // Nothing of the ball is nearer than 1.5, and all that is seen of it is nearer than 4.2; what
    // is between counts for less.
    assert!(shown(0.0, 1.5).iter().all(|x| *x == 0.0));
    assert_eq!(shown(4.2, 4.2), whole);
    let less = shown(1.0, 4.2);
    assert!(less.iter().zip(&whole).all(|(less, whole)| less <= whole && *less < 0.7 * 0.12));
    assert!(less.iter().sum::<f64>() > 0.2 * whole.iter().sum::<f64>());
}

/// Smooth bodies of facets, whatever their size and place: no pixel that the smooth normal turns to
/// the light is in the body's own shadow, and all that is turned away is.
#[test]
fn no_facet_shows_where_a_smooth_body_turns_from_the_light() {
    for (scale, moved) in [(1.0, 0.0), (0.01, 0.0), (1e4, 0.0), (1.0, 1000.0), (1e-3, 1.0)] {
        let toward = DVec3::new(0.8, 0.5, 0.3);
        let light = TestLight::Sun(toward);
        let at = DVec3::splat(moved);
        let (mesh, fitted) = shape("sphere");
        let placed = DMat4::from_translation(at) * DMat4::from_scale(DVec3::splat(scale)) * fitted;
        let scene = Scene {
            camera: Camera {
                eye: (at + scale * DVec3::new(0.0, 0.0, 5.0)).to_array(),
                target: at.to_array(),
                height: 2.2 * scale,
                projection: Projection::Orthographic,
                ..Camera::default()
            },
            backdrop: None,
            ..Scene::default()
        };
        let show =
            |look: SetupLook| on_gpu(&scene_of(vec![(look, mesh.clone(), placed)], scene.clone()));
        let dark = show(shown("self_shadow", "shadow", light, &json!({})));
        let facing = show(look(&json!({"lights": {"key": light.json()}, "nodes": [
                {"id": "key", "kind": "light", "values": {"light": "key"}},
                {"id": "parts", "kind": "light_parts"}, {"id": "normal", "kind": "normal"},
                {"id": "cosine", "kind": "dot_product"},
                {"id": "half", "kind": "multiply", "values": {"b": 0.5}},
                {"id": "middle", "kind": "add", "values": {"b": 0.5}},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "key", "to": "parts.light"},
                {"from": "parts.direction", "to": "cosine.a"},
                {"from": "normal", "to": "cosine.b"}, {"from": "cosine", "to": "half.a"},
                {"from": "half", "to": "middle.a"}, {"from": "middle", "to": "output.color"}]})));
        let (mut lit, mut away) = (0, 0);
        for (pixel, (dark, own)) in dark.iter().zip(&facing).enumerate() {
            let cosine = 2.0 * own - 1.0;
            let beside = |by: isize| facing.get(pixel.wrapping_add_signed(by)).unwrap_or(&0.0);
            // Outside of the body is nothing, and a pixel at the turn or at an outline has both.
            let side = SIZE as isize;
            let around = [-1, 1, -side, side].map(|by| 2.0 * (beside(by) - own).abs());
            let bound = around.into_iter().fold(0.08, f64::max);
            if *own > 0.0 && cosine > bound {
                lit += 1;
                assert_eq!(*dark, 0.0, "{scale} at {moved}: dark at a cosine of {cosine}");
            } else if *own > 0.0 && cosine < -bound {
                away += 1;
                assert_eq!(*dark, 1.0, "{scale} at {moved}: lit at a cosine of {cosine}");
            }
        }
        assert!(lit > 1000 && away > 300, "{scale} at {moved}: {lit} lit, {away} away");
    }
}

/// The floor's shadows of a cube and a ball by links: pixels in shadow left and right.
fn linked(cube: ShadowLink, of_lights: [&str; 2]) -> [usize; 2] {
    let light = |toward: [f64; 3]| TestLight::Sun(DVec3::from(toward)).json();
    let lights = json!({"key": light([0.0, 1.0, 0.0]), "rim": light([0.0, 1.0, 0.01])});
    let shadow = |id: &str, light: &str| {
        let values = json!({"light": light});
        json!({"id": id, "kind": "cast_shadow", "values": values})
    };
    let floor_look = look(
        &json!({"lights": lights, "nodes": [shadow("a", of_lights[0]), shadow("b", of_lights[1]),
            {"id": "both", "kind": "multiply"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "a", "to": "both.a"}, {"from": "b", "to": "both.b"},
            {"from": "both", "to": "output.color"}]}),
    );
    let things = vec![
        hung("box", DVec3::new(-1.0, UNSEEN, 0.0), 0.6),
        hung("sphere", DVec3::new(1.0, UNSEEN, 0.0), 0.6),
    ];
    let mut setup = scene_on_floor(floor_look, things, EYE);
    setup.objects[1].shadow_link = cube;
    setup.scene.objects =
        setup.objects.iter().map(|object| (object.id.clone(), Object::default())).collect();
    let drawn = on_gpu(&setup);
    let half = |right: bool| {
        let is_there = |pixel: &usize| (pixel % SIZE as usize >= SIZE as usize / 2) == right;
        (0..drawn.len()).filter(is_there).filter(|pixel| drawn[*pixel] > 0.5).count()
    };
    [half(false), half(true)]
}

#[test]
fn objects_cast_the_shadows_that_their_links_say() {
    let of = |shadowed: &str, unshadowed: &str, shadows_on: &str, no_shadows_on: &str| {
        let lights = |text| LightSet::parse(text).expect("a set of lights");
        let objects = |text| ObjectSet::parse(text).expect("a set of objects");
        ShadowLink {
            shadowed: lights(shadowed),
            unshadowed: lights(unshadowed),
            shadows_on: objects(shadows_on),
            no_shadows_on: objects(no_shadows_on),
        }
    };
    let both = linked(ShadowLink::default(), ["key", "key"]);
    assert!(both.iter().all(|count| *count > 300), "{both:?}");
    let ball = [0, both[1]];
    for (link, left) in [
        (of("*", "", "*", ""), both),
        (of("", "", "*", ""), ball),
        (of("rim", "", "*", ""), ball),
        (of("key | rim", "key", "*", ""), ball),
        (of("*", "", "object_0", ""), both),
        (of("*", "", "object_1 | object_2", ""), ball),
        (of("*", "", "*", "{source} - object_2"), ball),
    ] {
        assert_eq!(linked(link.clone(), ["key", "key"]), left, "{link:?}");
    }
    // Lights differ in what casts their shadows within one look.
    assert_eq!(linked(of("rim", "", "*", ""), ["rim", "key"])[0], 0);
    assert!(linked(of("*", "rim", "*", ""), ["key", "key"])[0] > 300);
}

/// A shadow layer multiplies what is below by its color, where the light is kept away, as far as
/// the light is there.
#[test]
fn a_shadow_layer_goes_with_its_light() {
    let below = [0.8, 0.5, 0.3];
    let color = [0.5, 0.25, 1.0];
    let shown = |intensity: f64, values: Json| {
        let mut light = TestLight::Sun(DVec3::Y).json();
        light["intensity"] = intensity.into();
        let mut values = values;
        values["color"] = json!([color[0], color[1], color[2], 1]);
        let floor_look = look(&json!({"lights": {"key": light}, "nodes": [
                {"id": "paint", "kind": "base",
                    "values": {"color": [below[0], below[1], below[2], 1]}},
                {"id": "shadow", "kind": "shadow_layer", "values": values},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "paint", "to": "shadow.below"},
                {"from": "shadow.below", "to": "output.color"}]}));
        let cube = hung("box", DVec3::new(0.0, UNSEEN, 0.0), 0.7);
        let setup = scene_on_floor(floor_look, vec![cube], EYE);
        let plan = planned(&setup, PlanStyle::Specialized);
        block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}")).rgba
    };
    let middle = (SIZE * SIZE / 2 + SIZE / 2) as usize;
    for (intensity, values, share) in [
        (1.0, json!({}), 1.0),
        (3.0, json!({}), 1.0),
        (0.25, json!({}), 0.25),
        (0.0, json!({}), 0.0),
        (1.0, json!({"opacity": 0.5}), 0.5),
        (1.0, json!({"cast": 0.4}), 0.4),
        (1.0, json!({"cast": 0.0}), 0.0),
    ] {
        let drawn = shown(intensity, values.clone());
        for (channel, below) in below.iter().enumerate() {
            let wanted = below * (1.0 + share * (color[channel] - 1.0));
            let [found, beside] = [middle, 0].map(|at| f64::from(drawn[at][channel]));
            // The picture holds half floats.
            assert!((found - wanted).abs() < 2e-3, "{intensity} {values}: {found} for {wanted}");
            assert!((beside - below).abs() < 2e-3, "{intensity} {values}: {beside} in the light");
        }
    }
}

/// Scenes that no ray and no map can make sense of leave numbers from 0 to 1, and shadows where
/// there are any.
#[test]
fn hard_cases_stay_shadows() {
    let flat = DMat4::from_translation(DVec3::new(0.0, UNSEEN, 0.0))
        * DMat4::from_scale(DVec3::new(1.0, 0.0, 1.0));
    let mirrored = DMat4::from_translation(DVec3::new(0.0, UNSEEN, 0.0))
        * DMat4::from_scale(DVec3::new(-0.8, 0.8, 0.8));
    let needle = DMat4::from_translation(DVec3::new(0.0, UNSEEN, 0.0))
        * DMat4::from_scale(DVec3::new(1e-12, 1.0, 1e-12));
    // Triangles of no area: of two corners, and of corners in a row.
    let splinters = {
        let mut mesh = box_of_12();
        for corners in mesh.indices.chunks_exact_mut(3) {
            corners[2] = corners[1];
        }
        let [a, b] = [0, 2].map(|corner: usize| DVec3::from(mesh.positions[corner].map(f64::from)));
        let between = mesh.positions.len() as u32;
        mesh.positions.push((0.25 * a + 0.75 * b).as_vec3().to_array());
        mesh.normals.push(mesh.normals[0]);
        mesh.uvs.push([0.0; 2]);
        mesh.tangents.push(mesh.tangents[0]);
        mesh.indices.extend([0, between, 2]);
        mesh.parts[0].indices.end += 3;
        mesh
    };
    // Two faces in one plane, which is each the other's back.
    let doubled = {
        let mut mesh = box_of_12();
        let turned: Vec<u32> =
            mesh.indices.chunks_exact(3).flat_map(|c| [c[0], c[2], c[1]]).collect();
        mesh.indices.extend(turned);
        mesh.parts[0].indices.end *= 2;
        mesh
    };
    let on_the_floor = DMat4::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    let sun = TestLight::Sun(DVec3::Y);
    let cube = box_of_12;
    // The light, the thing, and whether it casts a shadow.
    for (what, light, (mesh, placed), casts) in [
        ("a mirrored object", sun, (cube(), mirrored), Some(true)),
        ("an object without a height", sun, (cube(), flat), None),
        ("a needle", sun, (cube(), needle), None),
        ("triangles of no area", sun, (splinters, mirrored), Some(false)),
        ("faces in one plane", sun, (doubled, mirrored), Some(true)),
        (
            "a spot in the thing",
            TestLight::Spot(DVec3::new(0.0, UNSEEN, 0.0), -DVec3::Y),
            (cube(), mirrored),
            Some(true),
        ),
        ("a card on the floor", sun, (shape("plane").0, on_the_floor), Some(false)),
        (
            "a lamp in the thing",
            TestLight::Lamp(DVec3::new(0.0, UNSEEN, 0.0)),
            (cube(), mirrored),
            Some(true),
        ),
        ("a lamp on the floor", TestLight::Lamp(DVec3::ZERO), (cube(), mirrored), Some(false)),
        ("a lamp far away", TestLight::Lamp(DVec3::Y * 1e6), (cube(), mirrored), Some(true)),
        ("a sun in the floor", TestLight::Sun(DVec3::X), (cube(), mirrored), Some(false)),
    ] {
        for (kind, tier) in [
            ("cast_shadow", Tier::Exact),
            ("self_shadow", Tier::Exact),
            ("cast_shadow", Tier::Balanced),
            ("self_shadow", Tier::Balanced),
        ] {
            let what = format!("{what}, {kind}, {tier:?}");
            let mut floor_look = shown(kind, "shadow", light, &json!({}));
            floor_look.look.tier = Some(tier);
            let drawn = on_gpu(&scene_on_floor(floor_look, vec![(mesh.clone(), placed)], EYE));
            assert!(drawn.iter().all(|x| (0.0..=1.0).contains(x)), "{what}");
            let dark = drawn.iter().filter(|x| **x > 0.5).count();
            // What is thinner than a texel of a lamp's map casts nothing there.
            let (_, distance) = light.way(DVec3::ZERO);
            let is_thin = tier == Tier::Balanced && distance.is_finite() && distance > 1e5;
            match casts.filter(|_| kind == "cast_shadow" && !is_thin) {
                Some(true) => assert!(dark > 300, "{what}: {dark} pixels in shadow"),
                Some(false) => assert_eq!(dark, 0, "{what}: {dark} pixels in shadow"),
                None if kind == "self_shadow" => assert_eq!(dark, 0, "{what} on a flat floor"),
                None => {}
            }
        }
    }
}

/// A mirrored body in a mirrored light has the mirrored shadow on itself: its triangles run the
/// other way around, and own facets are known all the same.
#[test]
fn a_mirrored_body_has_its_shadow_mirrored() {
    let shadow = |side: f64| {
        let (creature, fitted) = shape("creature");
        let placed = DMat4::from_scale(DVec3::new(side, 1.0, 1.0)) * fitted;
        let light = TestLight::Sun(DVec3::new(0.8 * side, 0.6, 0.3));
        let camera = Camera { eye: [0.0, 0.0, 4.0], ..Camera::default() };
        let look = shown("self_shadow", "shadow", light, &json!({}));
        on_gpu(&scene_of(vec![(look, creature, placed)], Scene { camera, ..from_above(EYE) }))
    };
    let (plain, mirrored) = (shadow(1.0), shadow(-1.0));
    let side = SIZE as usize;
    let opposite = |pixel: usize| mirrored[pixel / side * side + (side - 1 - pixel % side)];
    let dark = plain.iter().filter(|x| **x > 0.9).count();
    assert!(dark > 200, "{dark} pixels in shadow");
    // At edges and outlines a rounding decides.
    let far = plain.iter().enumerate().filter(|(at, x)| (opposite(*at) - **x).abs() > 0.1).count();
    assert!(far * 50 < dark, "{far} pixels differ, of {dark} in shadow");
}
