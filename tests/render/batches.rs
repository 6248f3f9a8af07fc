//! Scenes of many objects: draws of one look come one after another, from one pipeline, and the
//! picture is that of all objects one by one.
#![cfg(feature = "gpu")]

use std::collections::HashSet;
use std::sync::Arc;

use crate::support::eval::{look, renderer, shape, told};
use crate::support::random::Random;
use crate::support::wait::block_on;
use chiaro::compile::{Live, Stage, Uniform};
use chiaro::document::{Value, Values};
use chiaro::frame::{
    CullMode, Draw, FramePlan, PlanOptions, Planner, Setup, SetupLook, SetupObject,
};
use chiaro::geometry::Mesh;
use chiaro::library::Library;
use chiaro::render::Renderer;
use glam::{DMat4, DVec3};
use serde_json::json;

fn plan(setup: &Setup, samples: u32) -> FramePlan {
    let options = PlanOptions { size: [160, 100], samples, time: 0.0 };
    Planner::default()
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn pixels(renderer: &mut Renderer, plan: &FramePlan) -> Vec<[u32; 4]> {
    let picture = block_on(renderer.picture(plan)).unwrap_or_else(|error| panic!("{error}"));
    picture.rgba.iter().map(|pixel| pixel.map(f32::to_bits)).collect()
}

fn object(number: usize, mesh: &Arc<Mesh>, look: usize, matrix: DMat4) -> SetupObject {
    SetupObject {
        id: format!("object{number}").as_str().into(),
        mesh: mesh.clone(),
        world_from_object: matrix,
        looks: vec![Some(look); mesh.parts.len()],
        values: Values::new(),
        light_link: Default::default(),
        shadow_link: Default::default(),
        layers: Default::default(),
        animation: None,
    }
}

/// A look of a layer that reads curvature; its base has this alpha.
fn layered(number: usize, alpha: f64) -> SetupLook {
    let share = 0.09 * number as f64;
    look(&json!({"name": format!("look {number}"),
        "lights": {"key": {"direction": [1, 2, 3]}},
        "exposed": [{"name": "tint", "target": "base.color"}],
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [share, 0.5, 0.2, alpha]}},
            {"id": "layer", "kind": "light_layer", "values": {"light": "key", "slope": 0.2,
                "convex": [0.1, share, 0.9], "concave": [0.9, share, 0.1], "blend": "add"}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}]}))
}

/// A look whose color follows the side from which an object is seen.
fn keyed() -> SetupLook {
    look(&json!({"name": "keyed",
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.9, 0.1, 0.1]}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "output.color"}],
        "direction_keys": [{"by": "view", "keys": [
            {"direction": [0, 0, 1], "values": {"base.color": [0.1, 0.1, 0.9, 1]}},
            {"direction": [1, 0, 0.2], "values": {"base.color": [0.1, 0.9, 0.1, 1]}}]}]}))
}

/// Places side by side that fill the picture.
fn grid([columns, rows]: [usize; 2]) -> impl Iterator<Item = DMat4> {
    let step = 2.2 / columns as f64;
    (0..columns * rows).map(move |index| {
        let at = DVec3::new((index % columns) as f64, (index / columns) as f64, 0.0);
        let middle = 0.5 * DVec3::new(columns as f64 - 1.0, rows as f64 - 1.0, 0.0);
        DMat4::from_translation(step * (at - middle)) * DMat4::from_scale(DVec3::splat(0.4 * step))
    })
}

/// The plan with its draws as they would be drawn one by one: from back to front, and at one
/// distance in the order of objects and parts.
fn one_by_one(plan: &FramePlan) -> FramePlan {
    let mut plan = plan.clone();
    // An object's number stands in its uniform, before the cutoff and the look's number.
    let number = |draw: &Draw| {
        let numbers = &draw.object_uniform.numbers;
        numbers[numbers.len() - 3]
    };
    plan.draws.sort_by(|a, b| {
        let nearer = b.distance.total_cmp(&a.distance);
        let later = number(a).total_cmp(&number(b));
        nearer.then(later).then(a.indices.start.cmp(&b.indices.start))
    });
    plan
}

#[test]
fn a_thousand_objects_of_ten_looks_are_ten_pipelines_and_ten_lists() {
    let (ball, fitted) = shape("ball");
    let ball = Arc::new(ball);
    let places = grid([40, 25]).enumerate();
    let objects = places.map(|(number, at)| object(number, &ball, number % 10, at * fitted));
    let setup = Setup {
        looks: (0..10).map(|number| layered(number, 1.0)).collect(),
        objects: objects.collect(),
        ..Setup::default()
    };
    let plan = plan(&setup, 1);
    for stage in [Stage::Draw, Stage::Normals] {
        let lists: Vec<usize> = plan.draw_lists(stage).map(<[Draw]>::len).collect();
        let drawn: usize = lists.iter().sum();
        assert_eq!(drawn, 1000, "{stage:?}");
        assert_eq!(lists.len(), 10, "{stage:?}");
    }
    let shaders: HashSet<_> = plan.draws.iter().map(|draw| Arc::as_ptr(&draw.look)).collect();
    let uniforms = plan.draws.iter().flat_map(|draw| draw.look_uniforms.values());
    let uniforms: HashSet<*const Uniform> = uniforms.map(Arc::as_ptr).collect();
    assert_eq!(shaders.len(), 10);
    assert!(uniforms.len() <= 20, "one for each look and stage: {}", uniforms.len());

    // The looks' own pipelines, and those of the normals that they are drawn over.
    let gpu = renderer().gpu().with_own_store();
    let mut renderer = Renderer::new(gpu.clone());
    let first = pixels(&mut renderer, &plan);
    assert_eq!((gpu.pipelines(), gpu.uploads().meshes), (20, 1));
    let one_by_one = one_by_one(&plan);
    assert_eq!(one_by_one.draw_lists(Stage::Draw).count(), 1000);
    assert!(pixels(&mut Renderer::new(gpu.clone()), &one_by_one) == first);
    assert_eq!((gpu.pipelines(), gpu.uploads().meshes), (20, 1));
}

#[test]
fn lists_change_no_pixel_of_objects_that_hide_and_show_one_another() {
    let mut random = Random::new(22);
    let meshes: Vec<(Arc<Mesh>, DMat4)> =
        ["ball", "cube", "plane"].map(shape).map(|(mesh, fitted)| (Arc::new(mesh), fitted)).into();
    let mut joined = 0;
    for round in 0..12 {
        let alpha = |number: usize| if number == 2 && round % 2 == 1 { 0.5 } else { 1.0 };
        let looks: Vec<SetupLook> =
            (0..4).map(|number| layered(number, alpha(number))).chain([keyed()]).collect();
        let mut objects: Vec<SetupObject> = (0..40)
            .map(|number| {
                let (mesh, fitted) = &meshes[random.index(3)];
                let turn = DMat4::from_axis_angle(random.direction(), random.between(0.0, 3.0));
                let size = random.between(0.05, 0.4);
                let mirror = if random.index(6) == 0 { -1.0 } else { 1.0 };
                let scale = DMat4::from_scale(DVec3::new(mirror * size, size, size));
                let at = DMat4::from_translation(random.direction() * random.between(0.0, 1.2));
                object(number, mesh, random.index(looks.len()), at * turn * scale * *fitted)
            })
            .collect();
        for index in 0..6 {
            // The same surface again in another look: whichever is drawn first is seen.
            let number = objects.len();
            let twin = SetupObject {
                id: format!("object{number}").as_str().into(),
                looks: vec![Some((index + 1) % looks.len())],
                ..objects[3 * index].clone()
            };
            objects.push(twin);
        }
        for object in objects.iter_mut().step_by(5).filter(|object| object.looks[0] < Some(4)) {
            let color: Vec<f64> = (0..3).map(|_| random.between(0.0, 1.0)).collect();
            object.values.insert("tint".into(), Value::Vector(color));
        }
        let setup = Setup { looks, objects, ..Setup::default() };
        let plan = plan(&setup, if round % 3 == 0 { 4 } else { 1 });
        let one_by_one = one_by_one(&plan);
        let lists = |plan: &FramePlan| plan.draw_lists(Stage::Draw).count();
        assert!(lists(&plan) <= lists(&one_by_one));
        joined += lists(&one_by_one) - lists(&plan);
        let mut renderer = renderer();
        let together = pixels(&mut renderer, &plan);
        let apart = pixels(&mut renderer, &one_by_one);
        let different = together.iter().zip(&apart).filter(|(a, b)| a != b).count();
        assert_eq!(different, 0, "round {round}");
    }
    assert!(joined > 20, "few draws were joined: {joined}");
}

#[test]
fn values_are_shared_by_objects_of_the_same_values_only() {
    let (ball, fitted) = shape("ball");
    let ball = Arc::new(ball);
    let mut objects: Vec<SetupObject> = grid([4, 3])
        .enumerate()
        .map(|(number, at)| object(number, &ball, number % 2, at * fitted))
        .collect();
    for (number, tint) in [(2, 0.3), (4, 0.6), (6, 0.3)] {
        objects[number].values.insert("tint".into(), Value::Vector(vec![tint; 3]));
    }
    let setup = Setup { looks: vec![layered(0, 1.0), keyed()], objects, ..Setup::default() };
    let plan = plan(&setup, 1);
    let of = |number: usize| {
        let id = format!("object{number}");
        let draw = plan.draws.iter().find(|draw| draw.object.as_str() == id).expect("a draw");
        draw.look_uniforms[&Stage::Draw].clone()
    };
    assert!(Arc::ptr_eq(&of(0), &of(8)) && Arc::ptr_eq(&of(2), &of(6)));
    assert!(of(0) != of(2) && of(2) != of(4));
    // They are seen from other sides.
    assert!(of(1) != of(3) && of(3) != of(5));
    let lists = plan.draw_lists(Stage::Draw).count();
    assert_eq!(lists, 2, "one for each look, whatever the values");
}

/// A look of layers that many lamps in a row light, each a few objects.
fn lamps(count: usize) -> SetupLook {
    let (mut lights, mut nodes) = (serde_json::Map::new(), Vec::new());
    let mut wires = Vec::new();
    nodes.push(json!({"id": "base", "kind": "base", "values": {"color": [0.1, 0.1, 0.1, 1]}}));
    let mut below = "base".to_owned();
    for lamp in 0..count {
        let x = 2.0 * (lamp as f64 + 0.5) / count as f64 - 1.0;
        lights.insert(
            format!("lamp{lamp}"),
            json!({"type": "point", "position": [x, 0.0, 0.3], "range": 0.4}),
        );
        let id = format!("layer{lamp}");
        let values = json!({"light": format!("lamp{lamp}"), "blend": "add",
            "convex": [0.4, 0.3, 0.1], "concave": [0.4, 0.3, 0.1]});
        nodes.push(json!({"id": id, "kind": "light_layer", "values": values}));
        wires.push(json!({"from": below, "to": format!("{id}.below")}));
        below = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": below, "to": "output.color"}));
    look(&json!({"name": "lamps", "lights": lights, "nodes": nodes, "wires": wires}))
}

#[test]
fn a_look_is_not_compiled_for_each_set_of_lights_that_objects_are_lit_by() {
    let (ball, fitted) = shape("ball");
    let ball = Arc::new(ball);
    let places = grid([10, 4]).enumerate();
    let objects = places.map(|(number, at)| object(number, &ball, 0, at * fitted)).collect();
    let setup = Setup { looks: vec![lamps(6)], objects, ..Setup::default() };
    let options = PlanOptions { size: [160, 100], samples: 1, time: 0.0 };
    let plans = [CullMode::All, CullMode::Nothing].map(|cull| {
        let mut planner = Planner::default().culling(cull);
        let planned = planner.plan(&setup, Library::built_in(), &Live::Keyed, &options);
        planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value
    });
    let shaders: HashSet<_> = plans[0].draws.iter().map(|draw| Arc::as_ptr(&draw.look)).collect();
    assert!(shaders.len() <= 4, "{} modules of one look", shaders.len());
    let [lit, whole] = plans.map(|plan| pixels(&mut renderer(), &plan));
    assert!(lit == whole);
    // Some objects lie beyond the range of a single lamp: two sets, and a module for each.
    let few = Setup { looks: vec![lamps(1)], ..setup };
    let plan = plan(&few, 1);
    let shaders: HashSet<_> = plan.draws.iter().map(|draw| Arc::as_ptr(&draw.look)).collect();
    assert_eq!(shaders.len(), 2);
}
