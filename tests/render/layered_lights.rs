//! Lights that reach some nodes of a look and not others, that pass by filters, and that are told
//! apart within one loop.
#![cfg(feature = "gpu")]

use std::collections::BTreeSet;

use crate::support::eval::{eval_with, look, renderer, scene_of, shape, told, truth};
use crate::support::examples::samples;
use crate::support::wait::block_on;
use chiaro::compile::{CompileOptions, Live, Loops, check, compile, node_reach};
use chiaro::document::{LayerLink, Light, LightRelation, LightSet, Scene};
use chiaro::frame::{FramePlan, PlanOptions, Planner, Setup, SetupLook};
use chiaro::ids::LightId;
use chiaro::library::Library;
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

fn set(text: &str) -> LightSet {
    LightSet::parse(text).unwrap()
}

/// A look of a layer for each of three lights, which two of them share; `links` are those of the
/// layers.
#[expect(clippy::needless_pass_by_value, reason = "JSON is written where it is passed")]
fn layers(links: [Json; 3]) -> SetupLook {
    let lights = ["key", "fill", "key"];
    let layer = |index: usize, color: [f64; 3]| {
        let mut node = json!({"id": format!("layer_{index}"), "kind": "light_layer",
            "values": {"light": lights[index], "blend": "add", "convex": color,
                "concave": color}});
        node.as_object_mut().unwrap().extend(links[index].as_object().unwrap().clone());
        node
    };
    look(&json!({"name": "layers",
        "lights": {"key": {"direction": [1, 2, 3], "groups": ["set"]},
            "fill": {"direction": [-3, 0, 1], "groups": ["set"]}},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.1, 0.05, 0.1, 1]}},
            layer(0, [0.5, 0.3, 0.1]), layer(1, [0.1, 0.3, 0.5]), layer(2, [0.2, 0.2, 0.2]),
            {"id": "output", "kind": "output"}],
        "wires": [
            {"from": "base", "to": "layer_0.below"}, {"from": "layer_0", "to": "layer_1.below"},
            {"from": "layer_1", "to": "layer_2.below"},
            {"from": "layer_2", "to": "output.color"}]}))
}

/// The look without some of its layers.
fn without(muted: &[usize]) -> SetupLook {
    let mut look = layers([json!({}), json!({}), json!({})]);
    for index in muted {
        let id = format!("layer_{index}");
        look.look.graph.nodes.get_mut(id.as_str()).unwrap().muted = true;
    }
    look
}

fn setup(looks: Vec<SetupLook>) -> Setup {
    let (mesh, fitted) = shape("sphere");
    let count = looks.len();
    let part = |(index, look)| {
        let x = 1.1 * (index as f64 - 0.5 * (count - 1) as f64);
        let placed = DMat4::from_translation(x * DVec3::X) * DMat4::from_scale(DVec3::splat(0.5));
        (look, mesh.clone(), placed * fitted)
    };
    scene_of(looks.into_iter().enumerate().map(part).collect(), Scene::default())
}

fn plan(setup: &Setup, live: &Live) -> FramePlan {
    let options = PlanOptions { size: [160, 80], samples: 1, time: 0.0 };
    Planner::default()
        .plan(setup, Library::built_in(), live, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn pixels(setup: &Setup, live: &Live) -> Vec<[u32; 4]> {
    let plan = plan(setup, live);
    let picture = block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"));
    picture.rgba.iter().map(|pixel| pixel.map(f32::to_bits)).collect()
}

#[test]
fn a_light_that_does_not_reach_a_layer_is_not_drawn_there() {
    let links = |layer: usize, link: Json| {
        let mut links = [json!({}), json!({}), json!({})];
        links[layer] = link;
        links
    };
    let cases = [
        (links(0, json!({"unlayered": "key"})), vec![0]),
        (links(2, json!({"layered": "group:set - key"})), vec![2]),
        (links(1, json!({"layered": "*", "unlayered": "group:set"})), vec![1]),
        (links(1, json!({"layered": "fill | key", "unlayered": "{source} - fill"})), vec![]),
    ];
    for (links, muted) in cases {
        for live in [Live::Keyed, Live::All] {
            let own = pixels(&setup(vec![layers(links.clone())]), &live);
            let wanted = pixels(&setup(vec![without(&muted)]), &live);
            assert!(own == wanted, "{links:?} {live:?}");
        }
    }
}

/// One look serves objects whose layers are lit apart, each as if its look said so.
#[test]
fn a_scene_says_which_lights_reach_layers() {
    let row = |layer: usize, layered: &str, unlayered: &str| LayerLink {
        layered: set(layered),
        unlayered: set(unlayered),
        ..LayerLink::new(format!("layer_{layer}").as_str().into())
    };
    let kept = || [json!({"unlayered": "key"}), json!({}), json!({})];
    let mut together = setup(vec![layers(kept()), layers(kept()), layers(kept())]);
    together.objects.iter_mut().for_each(|object| object.looks = vec![Some(0)]);
    together.looks.truncate(1);
    // The first adds to what the look says, the second takes away, the third says nothing.
    together.objects[0].layers = vec![row(0, "{source} | key", "")];
    together.objects[1].layers = vec![row(2, "{source}", "group:set"), row(1, "key", "")];
    let apart = setup(vec![without(&[]), without(&[0, 1, 2]), without(&[0])]);
    for live in [Live::Keyed, Live::All] {
        assert!(pixels(&together, &live) == pixels(&apart, &live), "{live:?}");
    }
    // A light that is left out of a layer is told, with the rule.
    let dropped = plan(&together, &Live::Keyed).dropped;
    let why = dropped.iter().find(|one| one.what == "light `key` on the node `layer_2`").unwrap();
    assert_eq!(why.why, "`unlayered` (`group:set`) has it");
}

/// A light that reaches no layer of an object has no uniform, and its layers no instruction.
#[test]
fn a_light_that_reaches_no_layer_costs_nothing() {
    let dark = json!({"layered": "* - key"});
    let by_layers = setup(vec![layers([dark.clone(), json!({}), dark])]);
    let mut by_link = setup(vec![without(&[])]);
    by_link.objects[0].light_link.unlinked = set("key");
    let [by_layers, by_link] = [by_layers, by_link].map(|setup| plan(&setup, &Live::Keyed));
    let lights: BTreeSet<&LightId> = by_layers.draws[0].look.host.lights().collect();
    assert_eq!(lights, BTreeSet::from([&LightId::from("fill")]));
    assert_eq!(by_layers.draws[0].look.wgsl, by_link.draws[0].look.wgsl);
}

/// A node in a group has the lights that reach the group, and of these those that reach it: by the
/// algebra of sets, for every pair of expressions.
#[test]
fn links_of_nodes_in_groups_are_what_the_algebra_of_sets_says() {
    type SetCase = (&'static str, fn(u8) -> u8);
    let cases: [SetCase; 7] = [
        ("*", |_| 0b1111),
        ("", |_| 0),
        ("b | group:odd", |_| 0b1010),
        ("* - a", |_| 0b1110),
        ("{source}", |around| around),
        ("{source} - group:odd", |around| around & 0b0101),
        ("* - {source}", |around| !around & 0b1111),
    ];
    let ids = ["a", "b", "c", "d"];
    let lights: serde_json::Map<String, Json> = (0..4)
        .map(|index| {
            let groups = if index % 2 == 1 { json!(["odd"]) } else { json!([]) };
            (ids[index].to_owned(), json!({"direction": [index, 1, 1], "groups": groups}))
        })
        .collect();
    for (outer, of_outer) in cases {
        for (inner, of_inner) in cases {
            let lamp = |id: &&str| {
                json!({"id": format!("lamp_{id}"), "kind": "light", "values": {"light": id},
                    "layered": inner})
            };
            let mut lit = look(&json!({"name": "nested", "lights": lights,
                "definitions": {"lamps": {"outputs": [{"name": "light"}],
                    "nodes": ids.iter().map(lamp).collect::<Vec<_>>(),
                    "wires": [{"from": "lamp_a", "to": "outputs.light"}]}},
                "nodes": [{"id": "group", "kind": "lamps"}, {"id": "base", "kind": "base"},
                    {"id": "output", "kind": "output"}],
                "wires": [{"from": "base", "to": "output.color"}]}));
            let group = lit.look.graph.nodes.get_mut("group").unwrap();
            group.links.layered = set(outer);
            let around = of_outer(0b1111);
            let wanted = of_inner(around) & around;
            let typed = check(&lit.look, Library::built_in(), None).unwrap().value;
            let bit =
                |id: &LightId| 1 << ids.iter().position(|known| id.as_str() == *known).unwrap();
            let lit_nodes = typed.nodes.iter().filter(|node| !node.is_unlit);
            let found: u8 = lit_nodes.filter_map(|node| node.light.as_ref()).map(bit).sum();
            assert_eq!(found, wanted, "`{inner}` in `{outer}`");
            // What is told of them is what is compiled.
            let reach = node_reach(&lit.look, Library::built_in());
            let inner_rows = reach.iter().filter(|row| row.node.ids().len() == 2);
            let told: u8 = inner_rows.filter(|row| row.reaches).map(|row| bit(&row.light)).sum();
            assert!(inner == "*" || told == wanted, "`{inner}` in `{outer}`: {reach:?}");
        }
    }
}

/// A look that sums something over four lights.
#[expect(clippy::needless_pass_by_value, reason = "JSON is written where it is passed")]
fn summed(nodes: Json, wires: Json, more: Json) -> SetupLook {
    let mut nodes = nodes.as_array().unwrap().clone();
    nodes.push(json!({"id": "join", "kind": "sum_of_lights"}));
    let mut wires = wires.as_array().unwrap().clone();
    wires.push(json!({"from": "join", "to": "outputs.color"}));
    let mut each = json!({"id": "each", "kind": "lamps", "for_each": "*"});
    each.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    let light = |index: usize| {
        let groups = if index.is_multiple_of(2) { json!(["even"]) } else { json!([]) };
        (
            format!("light_{index}"),
            json!({"direction": [index, 1, 2], "groups": groups,
            "color": [0.1 + 0.2 * index as f64, 0.5, 0.3]}),
        )
    };
    look(&json!({"name": "summed",
        "lights": (0..4).map(light).collect::<serde_json::Map<_, _>>(),
        "definitions": {"lamps": {"outputs": [{"name": "color"}], "nodes": nodes,
            "wires": wires}},
        "nodes": [each, {"id": "output", "kind": "output"}],
        "wires": [{"from": "each", "to": "output.color"}]}))
}

/// The values of a look where every light has code of its own, and where all are gone through in a
/// loop, on the GPU; and in f64 as it is written.
fn values(look: &SetupLook) -> [Vec<[f64; 4]>; 3] {
    let samples = samples(7, 24);
    let [never, always] = [Loops::Never, Loops::Always].map(|loops| {
        let options = CompileOptions { loops, live: Live::Exposed, ..CompileOptions::default() };
        eval_with(look, Library::built_in(), &options, &samples)
    });
    [never, always, truth(look, "", &samples)]
}

fn assert_near(found: &[[f64; 4]], wanted: &[[f64; 4]], what: &str) {
    for (found, wanted) in found.iter().zip(wanted) {
        for (a, b) in found[..3].iter().zip(wanted) {
            assert!((a - b).abs() < 2e-6, "{what}: {found:?} for {wanted:?}");
        }
    }
}

/// Lights are told apart within one group by the sets that they are of, and by their numbers.
#[test]
fn lights_are_told_apart_in_one_group() {
    let facing = json!({"id": "facing", "kind": "facing"});
    let tone = |kind: &str, values: Json, output: &str| {
        let node = json!({"id": "of", "kind": kind, "values": values});
        let nodes = json!([node, {"id": "scaled", "kind": "multiply"}, facing]);
        let wires = json!([{"from": format!("of.{output}"), "to": "scaled.a"},
            {"from": "facing", "to": "scaled.b"}, {"from": "scaled", "to": "join.value"}]);
        summed(nodes, wires, json!({}))
    };
    let plain = summed(json!([facing]), json!([{"from": "facing", "to": "join.value"}]), json!({}));
    // The sum over four lights of what is the same for each.
    let [_, _, four] = values(&plain);
    let numbers: f64 =
        (0..4).map(|index| Light::number_of(&format!("light_{index}").as_str().into())).sum();
    let member = |lights: &str| tone("light_in_set", json!({"lights": lights}), "inside");
    let number = || tone("light_number", json!({}), "number");
    let named = || tone("light_number", json!({"light": "light_3"}), "number");
    let cases = [
        ("group:even | light_1", member("group:even | light_1"), 3.0),
        ("*", member("*"), 4.0),
        ("group:even - light_0", member("group:even - light_0"), 1.0),
        ("light_0", member("light_0"), 1.0),
        ("no light", member(""), 0.0),
        ("numbers", number(), numbers),
        ("a number", named(), 4.0 * Light::number_of(&"light_3".into())),
    ];
    for (what, look, count) in cases {
        let wanted: Vec<[f64; 4]> = four.iter().map(|four| four.map(|x| x * count / 4.0)).collect();
        let [never, always, truth] = values(&look);
        for found in [&never, &always, &truth] {
            assert_near(found, &wanted, what);
        }
    }
    let loops = CompileOptions { loops: Loops::Always, ..CompileOptions::default() };
    let shader = compile(&number().look, Library::built_in(), &loops).unwrap().value;
    assert_eq!(shader.loops.len(), 1, "{}", shader.wgsl);
    // A factor of 1 or 0 is folded away: lights that follow one another share what is left.
    let two = member("light_0 | light_1");
    let shader = compile(&two.look, Library::built_in(), &loops).unwrap().value;
    let rounds: Vec<usize> = shader.loops.iter().map(|of| of.lights.len()).collect();
    assert!(rounds.contains(&2), "{}", shader.wgsl);
}

/// The number of a light is that of its id: other lights may come and go.
#[test]
fn numbers_of_lights_stay_and_lie_apart() {
    let mut numbers: Vec<f64> =
        (0..256).map(|index| Light::number_of(&format!("lamp_{index}").as_str().into())).collect();
    assert!(numbers.iter().all(|number| (0.0..1.0).contains(number)));
    assert!(numbers.iter().all(|number| f64::from(*number as f32) == *number));
    let mean = numbers.iter().sum::<f64>() / 256.0;
    assert!((mean - 0.5).abs() < 0.1, "{mean}");
    numbers.sort_by(f64::total_cmp);
    assert!(numbers.windows(2).all(|pair| pair[0] < pair[1]), "two lights of one number");
    let widest = numbers.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    assert!(widest < 0.05, "{widest}");
}

/// A light that a node does not filter passes as if the node were not there.
#[test]
fn lights_pass_by_what_does_not_filter_them() {
    let nodes = |filtered: &str| {
        json!([{"id": "lamp", "kind": "light"}, {"id": "parts", "kind": "light_parts"},
            {"id": "angle", "kind": "parametrization"}, {"id": "tone", "kind": "profile"},
            {"id": "glass", "kind": "light_filter", "filtered": filtered,
                "values": {"share": 0.25, "color": [0.5, 1, 0.25, 1]}},
            {"id": "lit", "kind": "multiply"}, {"id": "strong", "kind": "multiply"}])
    };
    let wires = json!([{"from": "lamp", "to": "angle.light"},
        {"from": "angle", "to": "glass.angle"}, {"from": "lamp", "to": "glass.light"},
        {"from": "glass.light", "to": "parts.light"},
        {"from": "glass.angle", "to": "tone.angle"}, {"from": "parts.color", "to": "lit.a"},
        {"from": "tone", "to": "lit.b"}, {"from": "lit", "to": "strong.a"},
        {"from": "parts.intensity", "to": "strong.b"}, {"from": "strong", "to": "join.value"}]);
    let of = |filtered: &str, for_each: &str| {
        values(&summed(nodes(filtered), wires.clone(), json!({"for_each": for_each})))
    };
    let [never, always, truth] = of("group:even", "*");
    let ([.., filtered], [.., clear]) = (of("*", "group:even"), of("", "* - group:even"));
    let sum =
        |(a, b): (&[f64; 4], &[f64; 4])| std::array::from_fn(|channel| a[channel] + b[channel]);
    let wanted: Vec<[f64; 4]> = filtered.iter().zip(&clear).map(sum).collect();
    assert!(filtered != clear);
    for found in [&never, &always, &truth] {
        assert_near(found, &wanted, "group:even");
    }
    // By hand: what passes by a glass is what there is without it.
    let mut muted = summed(nodes("*"), wires.clone(), json!({}));
    let group = &mut muted.look.definitions.values_mut().next().unwrap().graph;
    group.nodes.get_mut("glass").unwrap().muted = true;
    let [.., by_hand] = values(&muted);
    let [.., none] = of("", "*");
    assert_near(&none, &by_hand, "no light");
}

/// Lights that do not reach a group are no rounds of it; a node in it may have fewer.
#[test]
fn groups_run_for_the_lights_that_reach_them() {
    let nodes = |link: Json| {
        let mut lamp = json!({"id": "lamp", "kind": "light"});
        lamp.as_object_mut().unwrap().extend(link.as_object().unwrap().clone());
        json!([lamp, {"id": "parts", "kind": "light_parts"}, {"id": "lit", "kind": "multiply"}])
    };
    let wires = json!([{"from": "lamp", "to": "parts.light"},
        {"from": "parts.color", "to": "lit.a"}, {"from": "parts.intensity", "to": "lit.b"},
        {"from": "lit", "to": "join.value"}]);
    let of = |link: Json, more: Json| summed(nodes(link), wires.clone(), more);
    let [.., wanted] = values(&of(json!({}), json!({"for_each": "light_1 | light_2"})));
    let by_group = of(json!({}), json!({"unlayered": "light_0 | light_3"}));
    let by_node = of(json!({"layered": "light_1 | light_2"}), json!({}));
    for look in [by_group, by_node] {
        for found in values(&look) {
            assert_near(&found, &wanted, "two lights");
        }
    }
}

#[test]
fn links_of_nodes_that_mean_nothing_are_told() {
    let mut odd = layers([json!({"layered": "kez"}), json!({}), json!({})]);
    let base = odd.look.graph.nodes.get_mut("base").unwrap();
    (base.links.unlayered, base.links.filtered) = (set("key"), set("fill"));
    let problems = check(&odd.look, Library::built_in(), None).unwrap().warnings;
    let told: Vec<String> = problems.iter().map(ToString::to_string).collect();
    let told = told.join("\n");
    for words in [
        "warning[unknown-light]: `layered` names the light `kez`, which there is not",
        "did you mean `key`?",
        "warning[no-light]: `layered` is for groups, and for nodes that name a light",
        "warning[not-a-filter]: `filtered` is for nodes that one light passes through",
    ] {
        assert!(told.contains(words), "{words}\n{told}");
    }
    let bad = summed(
        json!([{"id": "of", "kind": "light_in_set", "values": {"lights": "light_1 |"}}]),
        json!([{"from": "of", "to": "join.value"}]),
        json!({}),
    );
    let problems = check(&bad.look, Library::built_in(), None).unwrap_err();
    assert_eq!(problems.iter().filter(|problem| problem.code == "bad-light-set").count(), 1);
    // A relation that tells of nothing but objects names its own fields.
    assert_eq!(LightRelation::Filtered.fields(), ["filtered", "unfiltered"]);
}

/// The shadow of a light falls from an object onto another where the sets of both relations say so:
/// by their algebra, for every combination.
#[test]
fn shadows_fall_as_the_algebra_of_sets_says() {
    type SetCase = (&'static str, fn(u8) -> u8);
    let of_lights: [SetCase; 4] = [
        ("*", |_| 0b11),
        ("", |_| 0),
        ("fill", |_| 0b10),
        ("{source} - key", |first| first & 0b10),
    ];
    let of_objects: [SetCase; 5] = [
        ("*", |_| 0b111),
        ("", |_| 0),
        ("object_0 | object_2", |_| 0b101),
        ("* - object_1", |_| 0b101),
        ("{source} & object_2", |first| first & 0b100),
    ];
    let mut lit = setup(vec![without(&[]), without(&[]), without(&[])]);
    for index in 0..3 {
        lit.scene.objects.insert(format!("object_{index}").as_str().into(), Default::default());
    }
    lit.objects[2].light_link.unlinked = set("fill");
    for (shadowed, a) in of_lights {
        for (unshadowed, b) in of_lights {
            for (on, c) in of_objects {
                for (not_on, d) in of_objects {
                    let link = &mut lit.objects[0].shadow_link;
                    (link.shadowed, link.unshadowed) = (set(shadowed), set(unshadowed));
                    let objects = |text| chiaro::document::ObjectSet::parse(text).unwrap();
                    (link.shadows_on, link.no_shadows_on) = (objects(on), objects(not_on));
                    let (lights, objects) = (a(0) & !b(a(0)), c(0) & !d(c(0)));
                    for shadow in lit.shadow_reach() {
                        let [caster, onto] = [&shadow.caster, &shadow.onto].map(|id| {
                            id.as_str().trim_start_matches("object_").parse::<u8>().unwrap()
                        });
                        let light = u8::from(shadow.light.as_str() == "fill");
                        let is_linked = lights >> light & 1 == 1 && objects >> onto & 1 == 1;
                        let is_dark = light == 1 && onto == 2;
                        let wanted = (caster > 0 || is_linked) && !is_dark;
                        assert_eq!(shadow.falls, wanted, "{shadow:?}, {on} without {not_on}");
                    }
                }
            }
        }
    }
}
