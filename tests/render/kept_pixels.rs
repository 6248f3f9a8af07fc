//! Pixels that are kept from picture to picture: what stands still is shaded once, and every
//! picture is, to the bit, the one that is drawn whole.
#![cfg(feature = "gpu")]

use std::sync::Arc;

use crate::support::eval::{look, renderer, shape, told};
use crate::support::random::Random;
use crate::support::wait::block_on;
use chiaro::compile::{AovSource, Live};
use chiaro::document::{Scene, Tier};
use chiaro::film::{AskedLayers, LayeredPlan, MatteKind};
use chiaro::frame::{AovRequest, FramePlan, PlanOptions, Planner, Setup, SetupLook, SetupObject};
use chiaro::geometry::Mesh;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::{Gpu, Renderer};
use glam::{DMat4, DVec3};
use serde_json::json;

const SIZE: [u32; 2] = [384, 256];

fn object(number: usize, mesh: &Arc<Mesh>, look: usize, matrix: DMat4) -> SetupObject {
    SetupObject {
        id: format!("object{number}").as_str().into(),
        mesh: mesh.clone(),
        world_from_object: matrix,
        looks: vec![Some(look); mesh.parts.len()],
        values: Default::default(),
        light_link: Default::default(),
        shadow_link: Default::default(),
        layers: Default::default(),
        animation: None,
    }
}

/// A look of a layer over a base of this alpha. With a slope it reads curvature, and so the
/// surface around each pixel.
fn layered(number: usize, slope: f64, alpha: f64) -> SetupLook {
    let share = 0.17 * number as f64;
    look(&json!({"name": format!("look {number}"),
        "lights": {"key": {"direction": [1, 2, 3]}},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [share, 0.5, 0.2, alpha]}},
            {"id": "layer", "kind": "light_layer", "values": {"light": "key", "slope": slope,
                "convex": [0.1, share, 0.9], "concave": [0.9, share, 0.1], "blend": "add"}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}]}))
}

/// A look whose color is the shadow of its light.
fn shadowed(tier: Tier) -> SetupLook {
    let mut worn = look(&json!({"name": "shadowed",
        "lights": {"key": {"direction": [0.2, 0.1, 1]}},
        "nodes": [
            {"id": "shadow", "kind": "cast_shadow", "values": {"light": "key"}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "shadow", "to": "output.color"}]}));
    worn.look.tier = Some(tier);
    worn
}

fn at(x: f64, y: f64, z: f64, size: f64) -> DMat4 {
    DMat4::from_translation(DVec3::new(x, y, z)) * DMat4::from_scale(DVec3::splat(size))
}

/// A wall that fills the picture, and three balls before it; the last one moves. The wall's sphere
/// holds all of them, so that the camera's planes stay where they are.
fn room(looks: Vec<SetupLook>) -> Setup {
    let [(wall, wide), (ball, fitted)] = ["plane", "ball"].map(shape);
    let (wall, ball) = (Arc::new(wall), Arc::new(ball));
    let upright = DMat4::from_rotation_x(std::f64::consts::FRAC_PI_2);
    let last = looks.len() - 1;
    let objects = vec![
        object(0, &wall, 0, at(0.0, 0.0, -0.5, 7.0) * upright * wide),
        object(1, &ball, 1.min(last), at(0.6, 0.3, 0.0, 0.3) * fitted),
        object(2, &ball, 2.min(last), at(0.7, -0.4, 0.1, 0.25) * fitted),
        object(3, &ball, last, at(-0.7, 0.0, 0.2, 0.2) * fitted),
    ];
    let scene = Scene { backdrop: Some([0.13, 0.27, 0.71, 0.9]), ..Scene::default() };
    Setup { scene, looks, objects, ..Setup::default() }
}

fn plan_with(planner: &mut Planner, setup: &Setup, samples: u32) -> FramePlan {
    let options = PlanOptions { size: SIZE, samples, time: 0.0 };
    planner
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn plan(setup: &Setup) -> FramePlan {
    plan_with(&mut Planner::default(), setup, 4)
}

/// The bits of the picture and of all layers.
fn bits(renderer: &mut Renderer, plan: &FramePlan) -> Vec<u32> {
    let drawn = block_on(renderer.layered(plan)).unwrap_or_else(|error| panic!("{error}"));
    let picture = drawn.picture.rgba.as_flattened().iter();
    let layers = drawn.layers.iter().flat_map(|layer| layer.as_flattened());
    picture.chain(layers).map(|number| number.to_bits()).collect()
}

/// A renderer that keeps pixels, and one that draws each picture whole.
struct Pair {
    keeping: Renderer,
    gpu: Gpu,
}

impl Pair {
    fn new() -> Self {
        let gpu = renderer().gpu().clone();
        Self { keeping: Renderer::new(gpu.clone()).keeping_pixels(), gpu }
    }

    /// The share of the picture that was shaded, which is the same picture to the bit.
    fn draw(&mut self, plan: &FramePlan, what: &str) -> (usize, usize, f64) {
        let kept = bits(&mut self.keeping, plan);
        let whole = bits(&mut Renderer::new(self.gpu.clone()), plan);
        let different = kept.iter().zip(&whole).filter(|(a, b)| a != b).count();
        assert_eq!((different, kept.len()), (0, whole.len()), "{what}");
        let share = self.keeping.shaded().expect("it is counted");
        (share.objects, share.of, share.pixels)
    }
}

#[test]
fn what_stands_still_is_shaded_once() {
    let mut setup = room(vec![layered(0, 0.0, 1.0), layered(1, 0.2, 1.0), layered(2, 0.0, 1.0)]);
    let mut pair = Pair::new();
    assert_eq!(pair.draw(&plan(&setup), "the first"), (4, 4, 1.0));
    assert_eq!(pair.draw(&plan(&setup), "the same"), (0, 4, 0.0), "nothing is drawn");
    for step in 1..4 {
        setup.objects[3].world_from_object.w_axis.y = 0.1 * f64::from(step);
        let (objects, of, pixels) = pair.draw(&plan(&setup), "the ball moves");
        // The ball, and the wall behind it.
        assert_eq!((objects, of), (2, 4));
        assert!(pixels > 0.01 && pixels < 0.3, "{pixels}");
    }
    // Another backdrop is seen nowhere, and could be everywhere.
    setup.scene.backdrop = Some([1.0, 0.0, 0.0, 1.0]);
    assert_eq!(pair.draw(&plan(&setup), "another backdrop"), (4, 4, 1.0));
    setup.objects.pop();
    let (objects, of, pixels) = pair.draw(&plan(&setup), "the ball is gone");
    // Its sphere was within the wall's, so that the camera stays what it is.
    assert_eq!((objects, of), (1, 3));
    assert!(pixels < 0.3, "{pixels}");
    let plain = Renderer::new(pair.gpu.clone());
    assert_eq!(plain.shaded(), None, "nothing is kept unless it is asked for");
}

#[test]
fn a_camera_or_a_light_that_moves_leaves_nothing() {
    let mut setup = room(vec![layered(0, 0.0, 1.0), layered(1, 0.2, 1.0)]);
    let mut pair = Pair::new();
    pair.draw(&plan(&setup), "the first");
    setup.scene.camera.eye[0] += 0.01;
    assert_eq!(pair.draw(&plan(&setup), "the camera"), (4, 4, 1.0));
    let mut planner = Planner::default();
    for step in 1..4 {
        for look in &mut setup.looks {
            let light = look.look.lights.values_mut().next().expect("a light");
            light.direction[0] = 1.0 + 0.1 * f64::from(step);
        }
        let plan = plan_with(&mut planner, &setup, 4);
        assert_eq!(pair.draw(&plan, "the light"), (4, 4, 1.0));
    }
}

#[test]
fn a_shadow_that_moves_is_drawn_on_what_stands_still() {
    for tier in [Tier::Exact, Tier::Balanced] {
        let mut setup = room(vec![shadowed(tier), layered(1, 0.0, 1.0), layered(2, 0.0, 1.0)]);
        let mut pair = Pair::new();
        let first = plan(&setup);
        let asks = first.casters.is_some() || first.shadow_maps.is_some();
        assert!(asks, "{tier:?}: the wall's look reads shadows");
        pair.draw(&first, "the first");
        let before = bits(&mut pair.keeping, &first);
        setup.objects[3].world_from_object.w_axis.y = 0.2;
        let moved = plan(&setup);
        let (_, _, pixels) = pair.draw(&moved, "the caster moves");
        assert_eq!(pixels, 1.0, "{tier:?}: the wall is not kept");
        assert!(bits(&mut pair.keeping, &moved) != before);
    }
}

/// Objects of all kinds that come, go, move, hide one another and tie, with lines over them, seen
/// through, and with a layer beside the picture.
#[test]
fn pictures_are_the_same_bits_whatever_moves() {
    let mut random = Random::new(25);
    let meshes: Vec<(Arc<Mesh>, DMat4)> =
        ["ball", "cube", "torus"].map(shape).map(|(mesh, fitted)| (Arc::new(mesh), fitted)).into();
    let (mut kept, mut frames) = (0.0, 0);
    for round in 0..8 {
        let alpha = if round % 4 == 3 { 0.5 } else { 1.0 };
        let mut setup = room(vec![
            layered(0, if round % 2 == 0 { 0.0 } else { 0.2 }, 1.0),
            layered(1, 0.2, alpha),
            layered(2, 0.0, 1.0),
            layered(3, 0.0, alpha),
        ]);
        if round % 3 == 1 {
            setup.scene.outlines.width = 4.0;
        }
        if round % 4 == 2 {
            // Without the wall the backdrop is seen; a ball far off holds the camera's planes.
            let fitted = shape("ball").1;
            setup.objects[0] = object(0, &meshes[0].0, 0, at(0.0, 0.0, -9.0, 7.0) * fitted);
        }
        for number in 4..14 {
            let (mesh, fitted) = &meshes[random.index(3)];
            let turn = DMat4::from_quat(random.rotation());
            let place = random.direction() * random.between(0.1, 0.7);
            let matrix = at(place.x, place.y, place.z, random.between(0.05, 0.2)) * turn * *fitted;
            setup.objects.push(object(number, mesh, 1 + random.index(3), matrix));
        }
        // The same surfaces in other looks: whichever is drawn first is seen.
        for number in 14..17 {
            let twin = setup.objects[3 * (number - 14) + 4].clone();
            let looks = vec![Some(1 + random.index(3)); twin.looks.len()];
            let id = format!("object{number}").as_str().into();
            setup.objects.push(SetupObject { id, looks, ..twin });
        }
        let mut planner = Planner::default();
        if round % 2 == 1 {
            let sources = vec![(None, AovSource::Stack)];
            planner.aovs = vec![AovRequest { name: "stack".to_owned(), sources }];
        }
        let samples = if round < 5 { 4 } else { 1 };
        let mut pair = Pair::new();
        for frame in 0..6 {
            let plan = plan_with(&mut planner, &setup, samples);
            let (_, _, pixels) = pair.draw(&plan, &format!("round {round}, frame {frame}"));
            (kept, frames) = (kept + 1.0 - pixels, frames + 1);
            let moving = 3 + random.index(setup.objects.len() - 3);
            let away = random.direction() * 0.1;
            let place = &mut setup.objects[moving].world_from_object.w_axis;
            *place += away.extend(0.0);
            if frame == 3 {
                setup.objects.remove(moving);
            }
        }
    }
    let mean = kept / f64::from(frames);
    assert!(mean > 0.3, "few pixels were kept: {mean}");
}

#[test]
fn depths_that_come_first_come_first_in_what_changes() {
    let path = crate::depth_first::file("kept_pixels", true);
    let mut setup = crate::depth_first::setup(&path, "quick", 1.0);
    // The sphere of the ground holds what moves, so that the camera's planes stay.
    setup.objects[0].world_from_object *= DMat4::from_scale(DVec3::splat(4.0));
    setup.objects[1].world_from_object *= DMat4::from_scale(DVec3::splat(0.3));
    // One planner for all frames, which makes the meshes' tangents once.
    let (mut planner, mut pair) = (Planner::default(), Pair::new());
    for frame in 0..3 {
        let plan = plan_with(&mut planner, &setup, 4);
        assert!(plan.draws.iter().all(|draw| draw.depth_first));
        let (_, of, pixels) = pair.draw(&plan, &format!("frame {frame}"));
        assert_eq!((of, pixels < 1.0), (2, frame > 0), "frame {frame}: {pixels}");
        setup.objects[1].world_from_object.w_axis.x += 0.03;
    }
}

/// Mattes and layers that one draw does not take are drawn beside what is kept.
#[test]
fn further_plans_of_a_frame_leave_what_is_kept() {
    let gpu = renderer().gpu().clone();
    let mut executor = gpu.executor();
    assert!(executor.beside().is_none() && executor.shaded().is_none());
    executor.keep_pixels();
    let mut setup = room(vec![layered(0, 0.0, 1.0), layered(1, 0.2, 1.0)]);
    let mut planner = Planner::default();
    for frame in 0..3 {
        let options = PlanOptions { size: SIZE, samples: 4, time: 0.0 };
        let asked = AskedLayers { mattes: vec![MatteKind::Objects], ..AskedLayers::default() };
        let scene = (&setup, Library::built_in(), &Live::Keyed);
        let planned = LayeredPlan::new(&mut planner, scene, &options, &asked, 7);
        let plan = planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value;
        let kept = block_on(plan.draw(&mut *executor, &Progress::new())).expect("a picture");
        let whole = block_on(plan.draw(&mut *gpu.executor(), &Progress::new())).expect("a picture");
        assert!(kept.picture == whole.picture, "frame {frame}");
        assert!(kept.exr_layers() == whole.exr_layers(), "frame {frame}");
        let share = executor.shaded().expect("it is counted");
        assert_eq!(share.pixels < 0.3, frame > 0, "frame {frame}: {share:?}");
        setup.objects[3].world_from_object.w_axis.y += 0.1;
    }
}
