//! Casters of shadows: they exist while a live node asks for a light that reaches it, and are made
//! anew only where they moved.
#![cfg(feature = "gpu")]

use std::collections::HashMap;
use std::sync::Arc;

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::{Live, Proof};
use chiaro::document::{LightSet, Object, Scene, ShadowLink};
use chiaro::frame::{
    Assets, EffectKind, FramePlan, PlanOptions, Planner, Setup, SetupLook, SetupObject, effects,
};
use chiaro::geometry::Mesh;
use chiaro::ids::ObjectId;
use chiaro::library::Library;
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

/// A look of which a share is the light's shadow.
fn shaded(share: f64) -> SetupLook {
    shaded_by(share, 1.0, &json!([]))
}

/// The same, by a light of an intensity that is exposed or not.
fn shaded_by(share: f64, intensity: f64, exposed: &Json) -> SetupLook {
    look(&json!({"name": "Shaded", "exposed": exposed,
        "lights": {"key": {"direction": [0.5, 1, 0.5], "intensity": intensity}},
        "nodes": [{"id": "shadow", "kind": "shadow", "values": {"light": "key"}},
            {"id": "paint", "kind": "color_value"},
            {"id": "mix", "kind": "mix_colors", "values": {"factor": share}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "paint", "to": "mix.a"}, {"from": "shadow.cast", "to": "mix.b"},
            {"from": "mix", "to": "output.color"}]}))
}

fn pair(share: f64, moved: f64) -> Setup {
    let part = |at: DVec3| {
        let (mesh, fitted) = shape("torus");
        (shaded(share), mesh, DMat4::from_translation(at) * fitted)
    };
    let mut setup = scene_of(
        vec![part(DVec3::ZERO), part(DVec3::new(0.6, 1.0 + moved, 0.6))],
        Scene::default(),
    );
    // Both are one mesh.
    setup.objects[1].mesh = setup.objects[0].mesh.clone();
    setup
}

fn planned(planner: &mut Planner, setup: &Setup) -> FramePlan {
    let options = PlanOptions { size: [64, 64], samples: 1, time: 0.0 };
    planner
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn picture_of(plan: &FramePlan) -> Vec<[f32; 4]> {
    block_on(renderer().picture(plan)).unwrap_or_else(|error| panic!("{error}")).rgba
}

/// True if pictures are the same but for what folding rounds.
fn is_near(a: &[[f32; 4]], b: &[[f32; 4]]) -> bool {
    let mut pairs = a.as_flattened().iter().zip(b.as_flattened());
    a.len() == b.len() && pairs.all(|(a, b)| (a - b).abs() < 1e-3)
}

#[test]
fn casters_exist_while_a_live_node_asks() {
    let mut planner = Planner::default();
    let plan = planned(&mut planner, &pair(0.0, 0.0));
    assert!(plan.casters.is_none(), "the share of the shadow is 0");
    assert!(!plan.draws[0].look.wgsl.contains("casters"));
    let plan = planned(&mut planner, &pair(0.5, 0.0));
    let casters = plan.casters.as_ref().expect("casters");
    assert_eq!(casters.trees().len(), 1, "a mesh has one tree, however often it stands there");
    // What else the node would give is not computed.
    assert!(!plan.draws[0].look.wgsl.contains("fn facet_at"));
    let all = effects(&plan, &HashMap::new());
    let effect = all.iter().find(|effect| effect.kind == EffectKind::Casters).expect("an effect");
    let bytes = casters.size().map(u64::from).iter().product::<u64>() * 16;
    assert_eq!(effect.cost.bytes, bytes);
    assert!(effect.reason.contains("wears Shaded, which sends rays past"), "{}", effect.reason);
}

#[test]
fn casters_are_made_anew_where_objects_move() {
    let mut planner = Planner::default();
    let setup = pair(0.5, 0.0);
    let still = planned(&mut planner, &setup);
    let mut seen = setup.clone();
    seen.scene.camera.eye = [1.0, 1.0, 4.0];
    let turned = planned(&mut planner, &seen);
    let mut elsewhere = setup.clone();
    elsewhere.objects[1].world_from_object = pair(0.5, 0.25).objects[1].world_from_object;
    let moved = planned(&mut planner, &elsewhere);
    let [a, b, c] = [&still, &turned, &moved].map(|plan| plan.casters.clone().expect("casters"));
    assert_eq!(a.hash(), b.hash(), "the camera casts no shadow");
    assert_ne!(a.hash(), c.hash());
    assert!(Arc::ptr_eq(&a.trees()[0], &c.trees()[0]));
    assert_ne!(still.passes[0].input_hash, moved.passes[0].input_hash);
    // The renderer writes what moved, and draws as if it had never seen anything else.
    let mut renderer = renderer();
    let mut picture =
        |plan: &FramePlan| block_on(renderer.picture(plan)).unwrap_or_else(|e| panic!("{e}")).rgba;
    let (first, second, again) = (picture(&still), picture(&moved), picture(&still));
    assert!(first == again, "the picture came back");
    assert!(first != second, "the shadow moved");
    assert!(block_on(renderer.draw(&still)).is_ok_and(|ran| ran.is_empty()));
}

/// An export has no scene to send rays past: it is refused, and the nodes are named.
#[test]
fn an_export_refuses_looks_that_send_rays() {
    let export = |share: f64| {
        let languages = &chiaro::export::LANGUAGES;
        let assets = (std::path::Path::new(""), &mut chiaro::frame::Assets::default());
        chiaro::export::export(&shaded(share).look, Library::built_in(), "a", languages, assets)
    };
    let problems = export(0.5).expect_err("it sends rays");
    let told: Vec<_> = problems
        .iter()
        .map(|problem| (problem.code, problem.place.node.as_ref().map(ToString::to_string)))
        .collect();
    assert_eq!(told[0], ("export-casters", Some("shadow/others".to_owned())), "{problems:?}");
    let cheaper = ["balanced"; 3];
    for (problem, tier) in problems.iter().zip(cheaper) {
        let hint = problem.hints.first().map(String::as_str).unwrap_or_default();
        assert!(hint.contains(&format!("its {tier} tier")), "{problem:?}");
    }
    assert!(export(0.0).is_ok(), "what is not seen sends none");
}

/// Two objects in a look with the shadow of `key` and, if told so, of `rim`, onto which an object
/// casts shadows of `key` alone; `rim` is kept from its node by `links`.
fn two_lights(with_rim: bool, links: &Json) -> Setup {
    let mut rim = json!({"id": "b", "kind": "cast_shadow", "values": {"light": "rim"}});
    rim.as_object_mut().unwrap().extend(links.as_object().unwrap().clone());
    let mut nodes = json!([{"id": "a", "kind": "cast_shadow", "values": {"light": "key"}},
        {"id": "both", "kind": "add"}, {"id": "output", "kind": "output"}]);
    let mut wires = json!([{"from": "a", "to": "both.a"}, {"from": "both", "to": "output.color"}]);
    if with_rim {
        nodes.as_array_mut().unwrap().push(rim);
        wires.as_array_mut().unwrap().push(json!({"from": "b", "to": "both.b"}));
    }
    let lights = json!({"key": {"direction": [0.5, 1, 0.5]}, "rim": {"direction": [-1, 1, 0]}});
    let worn = look(&json!({"name": "Two", "lights": lights, "nodes": nodes, "wires": wires}));
    let mut setup = pair(0.5, 0.0);
    setup.looks = vec![worn];
    setup.objects.iter_mut().for_each(|object| object.looks = vec![Some(0)]);
    let of_key = LightSet::parse("key").unwrap();
    setup.objects[1].shadow_link = ShadowLink { shadowed: of_key, ..ShadowLink::default() };
    // Sets of objects name those of the scene.
    setup.scene.objects =
        setup.objects.iter().map(|object| (object.id.clone(), Object::default())).collect();
    setup
}

/// Lights that a node is kept from make no casters, nor does what is muted or not linked.
#[test]
fn lights_that_reach_no_reader_have_no_casters() {
    let texels_of = |mut planner: Planner, setup: &Setup| {
        planned(&mut planner, setup).casters.expect("casters").texels()
    };
    let texels = |setup: &Setup| texels_of(Planner::default(), setup);
    let of_key = texels(&two_lights(false, &json!({})));
    let of_both = texels(&two_lights(true, &json!({})));
    assert!(of_both != of_key, "the light has other casters");
    let away = two_lights(true, &json!({"unlayered": "rim"}));
    assert!(texels(&away) == of_key, "`unlayered` keeps it away");
    let mut muted = two_lights(true, &json!({}));
    muted.scene.muted = LightSet::parse("rim").unwrap();
    assert!(texels(&muted) == of_key, "it is muted");
    let mut unlinked = two_lights(true, &json!({}));
    for object in &mut unlinked.objects {
        object.light_link.unlinked = LightSet::parse("rim").unwrap();
    }
    assert!(texels(&unlinked) == of_key, "it is not linked");
    // The rule is told, and the truth agrees, which folds nothing away.
    let plan = planned(&mut Planner::default(), &away);
    let told = plan.dropped.iter().find(|one| one.what.contains("`rim` on the node `b`"));
    assert!(told.is_some_and(|one| one.why.contains("`unlayered` (`rim`) has it")));
    let [truth, wanted] = [&away, &two_lights(false, &json!({}))]
        .map(|setup| texels_of(Planner::for_truth(Assets::default()), setup));
    assert!(truth == wanted);
}

/// Casters go to no GPU where no light is left whose shadows are drawn, and the picture is
/// the one without shadows.
#[test]
fn muted_lights_leave_no_casters() {
    let mut setup = pair(0.5, 0.0);
    setup.scene.muted = LightSet::parse("*").unwrap();
    let plan = planned(&mut Planner::default(), &setup);
    assert!(plan.casters.is_none() && !plan.draws[0].look.wgsl.contains("textureLoad"));
    // The rule is told of the light, and the light of the node.
    let all = effects(&plan, &HashMap::new());
    assert!(all.iter().all(|effect| effect.kind != EffectKind::Casters), "{all:?}");
    let why = |what: &str| {
        let told = all.iter().find(|effect| effect.what == what).expect("an effect");
        (told.proof, told.reason.clone())
    };
    let proof = Some(Proof::NoLight);
    assert_eq!(why("light `key`"), (proof, "it is out: `muted` (`*`) has it".to_owned()));
    let reason = "nothing of the light `key` arrives".to_owned();
    assert_eq!(why("node `shadow/others`"), (proof, reason));
    let picture = |setup: &Setup| picture_of(&planned(&mut Planner::default(), setup));
    let shadowed = picture(&pair(0.5, 0.0));
    let mut bare = pair(0.5, 0.0);
    for object in &mut bare.objects {
        object.shadow_link.shadowed = LightSet::parse("").unwrap();
    }
    let unshadowed = picture(&bare);
    assert!(!is_near(&shadowed, &unshadowed), "there are shadows");
    assert!(is_near(&picture(&setup), &unshadowed));
}

/// A lamp of intensity 0 casts no shadow, whether its module knows that or reads it from a uniform.
#[test]
fn lamps_that_are_out_cast_no_shadow() {
    let by = |intensity: f64, exposed: &Json| {
        let mut setup = pair(0.5, 0.0);
        setup.looks.iter_mut().for_each(|worn| *worn = shaded_by(0.5, intensity, exposed));
        planned(&mut Planner::default(), &setup)
    };
    let exposed = json!([{"name": "energy", "target": "lights.key.intensity"}]);
    let (known, read, lit) = (by(0.0, &json!([])), by(0.0, &exposed), by(1.0, &exposed));
    assert!(known.casters.is_none());
    assert!(read.draws[0].look.wgsl.contains("textureLoad"), "{}", read.draws[0].look.wgsl);
    assert!(is_near(&picture_of(&known), &picture_of(&read)));
    assert!(!is_near(&picture_of(&known), &picture_of(&lit)), "a lamp that is on casts a shadow");
}

/// A thousand lights, of which an object is linked to three, cost what the three cost alone: the
/// same code, the same uniform and the same casters.
#[test]
fn lights_that_reach_nothing_cost_nothing() {
    let setup = |count: usize| {
        let light = |index: usize| {
            let (sine, cosine) = (index as f64).sin_cos();
            let light = json!({"type": "point", "position": [3.0 * sine, 3.0, 3.0 * cosine]});
            (format!("light_{index}"), light)
        };
        let lights: serde_json::Map<String, Json> = (0..count).map(light).collect();
        let worn = look(&json!({"name": "Many", "lights": lights,
            "definitions": {"lamps": {
                "outputs": [{"name": "color"}],
                "nodes": [{"id": "lamp", "kind": "light"},
                    {"id": "angle", "kind": "parametrization"}, {"id": "tone", "kind": "profile"},
                    {"id": "shadow", "kind": "cast_shadow"}, {"id": "lit", "kind": "multiply"},
                    {"id": "join", "kind": "sum_of_lights"}],
                "wires": [{"from": "lamp", "to": "angle.light"},
                    {"from": "angle", "to": "tone.angle"}, {"from": "tone", "to": "lit.a"},
                    {"from": "shadow", "to": "lit.b"}, {"from": "lit", "to": "join.value"},
                    {"from": "join", "to": "outputs.color"}]}},
            "nodes": [{"id": "each", "kind": "lamps", "for_each": "*"},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "each", "to": "output.color"}]}));
        let mut setup = pair(0.5, 0.0);
        setup.looks = vec![worn];
        for object in &mut setup.objects {
            object.looks = vec![Some(0)];
            object.light_link.linked = LightSet::parse("light_0 | light_1 | light_2").unwrap();
        }
        setup
    };
    let [many, few] = [1000, 3].map(|count| planned(&mut Planner::default(), &setup(count)));
    assert!(many.draws[0].look.wgsl.contains("light_2"), "{}", many.draws[0].look.wgsl);
    assert_eq!(many.draws[0].look.wgsl, few.draws[0].look.wgsl);
    let numbers = |plan: &FramePlan| {
        plan.draws
            .iter()
            .flat_map(|draw| draw.look_uniforms.values())
            .map(|u| u.numbers.clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(numbers(&many), numbers(&few));
    let [many_casters, few_casters] = [&many, &few].map(|plan| plan.casters.clone().unwrap());
    assert!(many_casters.texels() == few_casters.texels());
    let told = many.dropped.iter().filter(|one| one.kind == EffectKind::Light);
    let rule = "`linked` (`light_0 | light_1 | light_2`) has it not";
    assert_eq!(told.filter(|one| one.why.contains(rule)).count(), 997);
}

/// Each mesh begins a row of the texture, and of rows there are only so many.
#[test]
fn more_casters_than_the_texture_holds_are_refused() {
    let mut setup = pair(0.5, 0.0);
    let one = setup.objects.remove(1);
    let triangle = Mesh {
        indices: one.mesh.indices[..3].to_vec(),
        parts: vec![chiaro::geometry::MeshPart { indices: 0..3, ..one.mesh.parts[0].clone() }],
        positions: one.mesh.positions[..4].to_vec(),
        normals: one.mesh.normals[..4].to_vec(),
        tangents: one.mesh.tangents[..4].to_vec(),
        uvs: one.mesh.uvs[..4].to_vec(),
        ..Mesh::default()
    };
    let object = |number: usize| {
        let mut mesh = triangle.clone();
        mesh.indices = vec![0, 1, 2];
        let id = ObjectId::new(format!("splinter_{number}"));
        // Behind the camera: casters need not be seen.
        let placed = DMat4::from_translation(DVec3::new(0.0, 0.0, 100.0 + number as f64));
        SetupObject { id, mesh: Arc::new(mesh), world_from_object: placed, ..one.clone() }
    };
    setup.objects.extend((0..8192).map(object));
    let options = PlanOptions { size: [64, 64], samples: 1, time: 0.0 };
    let problems = Planner::default()
        .plan(&setup, Library::built_in(), &Live::Keyed, &options)
        .expect_err("they are too many");
    assert_eq!(problems[0].code, "too-many-casters", "{problems:?}");
    assert!(problems[0].message.contains("texels, and 16777216 is the most"), "{problems:?}");
    assert!(!problems[0].hints.is_empty());
    setup.objects.truncate(100);
    assert!(planned(&mut Planner::default(), &setup).casters.is_some());
}

/// The shader finds texels by the width that the texture has.
#[test]
fn rows_are_as_long_in_the_shader_as_in_the_texture() {
    let casters = planned(&mut Planner::default(), &pair(0.5, 0.0)).casters.expect("casters");
    let [width, _] = casters.size();
    assert!(width.is_power_of_two());
    let text = std::fs::read_to_string(crate::support::root().join("shaders/lib/casters.wgsl"));
    let place = format!("vec2i(index & {}, index >> {}u)", width - 1, width.trailing_zeros());
    assert!(text.unwrap().contains(&place), "no {place}");
}
