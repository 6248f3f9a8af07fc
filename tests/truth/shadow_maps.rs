//! Shadows from maps: against rays, by scale, by objects, and when they are drawn.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]

use std::collections::HashMap;

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::document::{Camera, Scene};
use chiaro::frame::{Executor, FramePlan, PassId, PlanOptions, PlanStyle, Setup, SetupLook};
use chiaro::geometry::Mesh;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::Reference;
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

/// Width and height of the pictures.
const SIZE: u32 = 128;

/// Lights of the tests: a sun, a lamp and a spot.
fn lights() -> [(&'static str, Json); 3] {
    [
        ("sun", json!({"direction": [0.4, 0.8, 0.3], "space": "world"})),
        ("lamp", json!({"type": "point", "position": [1.5, 2.5, 1.0], "space": "world"})),
        (
            "spot",
            json!({"type": "spot", "position": [-1.0, 3.0, 1.2], "aim": [0.3, -1.0, -0.4],
                "space": "world"}),
        ),
    ]
}

/// A look that shows what a node says of a light, in a tier.
fn shown(kind: &str, output: &str, light: &Json, tier: &str) -> SetupLook {
    look(&json!({"lights": {"key": light},
            "nodes": [{"id": "shadow", "kind": kind, "tier": tier, "values": {"light": "key"}},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": format!("shadow.{output}"), "to": "output.color"}]}))
}

fn planned(setup: &Setup, style: PlanStyle) -> Result<FramePlan, String> {
    let options = PlanOptions { size: [SIZE; 2], samples: 1, time: 0.0 };
    let mut planner = style.planner(Default::default());
    let planned = planner.plan(setup, Library::built_in(), &style.live(), &options);
    planned.map(|planned| planned.value).map_err(|problems| told(&problems))
}

fn specialized(setup: &Setup) -> FramePlan {
    planned(setup, PlanStyle::Specialized).unwrap_or_else(|told| panic!("{told}"))
}

/// The first number of each pixel on the GPU.
fn on_gpu(setup: &Setup) -> Vec<f64> {
    let plan = specialized(setup);
    let drawn = block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"));
    drawn.rgba.iter().map(|pixel| f64::from(pixel[0])).collect()
}

fn by_reference(setup: &Setup) -> Vec<f64> {
    let plan = planned(setup, PlanStyle::AsWritten).unwrap_or_else(|told| panic!("{told}"));
    let picture = block_on(Executor::picture(&mut Reference::default(), &plan, &Progress::new()))
        .unwrap_or_else(|problem| panic!("{}", told(&[problem])));
    picture.rgba.iter().map(|pixel| f64::from(pixel[0])).collect()
}

/// A floor at y = -1, eight wide.
fn floor() -> (Mesh, DMat4) {
    let (mesh, _) = shape("plane");
    let turned = DMat4::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    (mesh, DMat4::from_translation(-DVec3::Y) * turned * DMat4::from_scale(DVec3::splat(8.0)))
}

/// A thing of a size at a place.
fn placed(name: &str, at: DVec3, size: f64) -> (Mesh, DMat4) {
    let (mesh, fitted) = shape(name);
    (mesh, DMat4::from_translation(at) * DMat4::from_scale(DVec3::splat(size)) * fitted)
}

/// Things that wear the same look, seen from the front and above.
fn scene(look: &SetupLook, things: Vec<(Mesh, DMat4)>, scale: f64) -> Setup {
    let camera = Camera { eye: [0.3, 1.8 * scale, 5.0 * scale], ..Camera::default() };
    let things = things.into_iter().map(|(mesh, place)| (look.clone(), mesh, place));
    scene_of(things.collect(), Scene { backdrop: None, camera, ..Scene::default() })
}

/// A floor with a creature, a ring that reaches into its light, and a ball.
fn court() -> Vec<(Mesh, DMat4)> {
    vec![
        floor(),
        placed("creature", DVec3::ZERO, 1.0),
        placed("torus", DVec3::new(0.9, 0.5, 0.6), 0.45),
        placed("sphere", DVec3::new(-1.3, -0.5, 0.4), 0.5),
    ]
}

/// Share of pixels that differ by more than a half, and the mean difference.
fn apart(a: &[f64], b: &[f64]) -> (f64, f64) {
    let count = a.len() as f64;
    let far = a.iter().zip(b).filter(|(a, b)| (*a - *b).abs() > 0.5).count() as f64 / count;
    (far, a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum::<f64>() / count)
}

#[test]
fn maps_show_what_rays_find() {
    for (name, light) in &lights() {
        for kind in ["cast_shadow", "self_shadow"] {
            let [exact, balanced, fast] = ["exact", "balanced", "fast"]
                .map(|tier| on_gpu(&scene(&shown(kind, "shadow", light, tier), court(), 1.0)));
            let dark = exact.iter().sum::<f64>() / exact.len() as f64;
            let [(balanced_far, balanced_mean), (fast_far, fast_mean)] =
                [apart(&exact, &balanced), apart(&exact, &fast)];
            println!(
                "{kind} of a {name}: {dark:.3} dark; balanced {balanced_far:.4} of pixels far, \
                 {balanced_mean:.4} in the mean; fast {fast_far:.4}, {fast_mean:.4}"
            );
            assert!(dark > 0.02, "{kind} of a {name}: hardly any shadow");
            assert!(balanced_far < 0.01 && fast_far < 0.02, "{kind} of a {name}");
            assert!(balanced_mean < 0.01 && balanced_mean < fast_mean, "{kind} of a {name}");
        }
    }
}

/// Maps know what is nearest to the light: the lit side of a blocker, where rays from the surface
/// meet the other side first.
#[test]
fn blockers_of_maps_are_those_of_rays_by_their_lit_side() {
    for (name, light) in &lights() {
        let said = |tier: &str, output: &str| {
            let look = shown("shadow_blocker", output, light, tier);
            let things = vec![floor(), placed("sphere", DVec3::new(0.0, 0.3, 0.0), 0.5)];
            on_gpu(&scene(&look, things, 1.0))
        };
        let [exact, fast] = ["exact", "fast"].map(|tier| said(tier, "distance"));
        let both = exact.iter().zip(&fast).filter(|(a, b)| **a > 0.05 && **b > 0.05);
        // A ball of radius 0.5 is no thicker than 1.
        let fits = |(a, b): &(&f64, &f64)| (-0.03..1.03).contains(&(**b - **a));
        let (count, near) = (both.clone().count(), both.filter(fits).count());
        println!("{name}: {near} of {count} pixels");
        assert!(count > 200 && near * 100 > count * 97, "{name}: {near} of {count}");
        let [exact, fast] = ["exact", "fast"].map(|tier| said(tier, "object"));
        let (far, _) = apart(&exact, &fast);
        assert!(exact.contains(&1.0) && far < 0.02, "{name}: {far} of the objects differ");
    }
}

/// The f64 reference draws the same maps, but for roundings at edges.
#[test]
fn the_reference_draws_the_same_maps() {
    for (name, light) in &lights()[..2] {
        for tier in ["balanced", "fast"] {
            let things = vec![floor(), placed("torus", DVec3::new(0.2, 0.3, 0.0), 0.8)];
            let setup = scene(&shown("cast_shadow", "shadow", light, tier), things, 1.0);
            let (far, mean) = apart(&on_gpu(&setup), &by_reference(&setup));
            println!("{name} {tier}: {far:.5} far, {mean:.5} in the mean");
            assert!(far < 0.002 && mean < 0.002, "{name} {tier}: {far}, {mean}");
        }
    }
}

/// No offset is tuned to a scale: a thimble and a city have the same shadows.
#[test]
fn neither_acne_nor_gaps_at_any_scale() {
    for scale in [1e-3, 1.0, 1e4] {
        for tier in ["balanced", "fast"] {
            let (_, light) = &lights()[0];
            let ball = |kind: &str, tier: &str| {
                let things = vec![placed("sphere", DVec3::ZERO, scale)];
                on_gpu(&scene(&shown(kind, "shadow", light, tier), things, scale))
            };
            // What the normal is turned away from, and nothing else, is in a ball's own shadow.
            let (far, mean) = apart(&ball("self_shadow", "exact"), &ball("self_shadow", tier));
            assert!(far == 0.0 && mean < 1e-4, "{scale} {tier}: {far}, {mean}");
            assert!(ball("cast_shadow", tier).iter().all(|dark| *dark == 0.0), "{scale} {tier}");
        }
    }
}

/// A map is drawn anew only when the light or what casts shadows moves.
#[test]
fn maps_are_drawn_only_when_something_moved() {
    const FIRST: PassId = PassId::named("shadow_map");
    let (_, light) = &lights()[0];
    let look = shown("cast_shadow", "shadow", light, "fast");
    let ball = placed("sphere", DVec3::new(0.0, 0.3, 0.0), 0.5);
    let mut setup = scene(&look, vec![floor(), ball], 1.0);
    let mut renderer = renderer();
    let mut ran = |setup: &Setup| {
        block_on(renderer.draw(&specialized(setup))).unwrap_or_else(|error| panic!("{error}"))
    };
    assert!(ran(&setup).contains(&FIRST), "the first time");
    setup.scene.camera.eye[0] = 0.9;
    let turned = ran(&setup);
    assert!(turned.contains(&PassId::LOOK) && !turned.contains(&FIRST), "only the camera moved");
    setup.objects[1].world_from_object.w_axis.x += 0.2;
    assert!(ran(&setup).contains(&FIRST), "the ball moved");
    assert!(!ran(&setup).contains(&FIRST), "nothing moved");
    let other = json!({"direction": [0.1, 0.8, 0.3], "space": "world"});
    for look in &mut setup.looks {
        *look = shown("cast_shadow", "shadow", &other, "fast");
    }
    assert!(ran(&setup).contains(&FIRST), "the light moved");
}

/// Looks that ask for no shadow, and lights that no look asks about, cost no map.
#[test]
fn only_lights_that_are_asked_about_have_maps() {
    let (_, sun) = &lights()[0];
    let (_, lamp) = &lights()[1];
    let looks = |tier: &str| {
        look(&json!({"lights": {"key": sun, "other": lamp},
            "nodes": [{"id": "shadow", "kind": "cast_shadow", "tier": tier,
                    "values": {"light": "key"}},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "shadow", "to": "output.color"}]}))
    };
    let plan = specialized(&scene(&looks("fast"), court(), 1.0));
    let maps = plan.shadow_maps.as_ref().expect("it asks for a map");
    assert_eq!(maps.layers.len(), 1, "the sun's");
    assert_eq!(maps.layers[0].casters.len(), 4);
    assert!(plan.casters.is_none(), "no rays");
    let plan = specialized(&scene(&looks("exact"), court(), 1.0));
    assert!(plan.shadow_maps.is_none() && plan.casters.is_some(), "rays alone");
    let labels: HashMap<_, _> = plan.passes.iter().map(|pass| (pass.id, &pass.reason)).collect();
    assert!(labels.keys().all(|pass| !pass.is_of_lights()), "{labels:?}");
}

/// A region that runs for each light asks each light's own map, in a loop as in code for each.
#[test]
fn lights_of_a_loop_have_maps_of_their_own() {
    let lights: serde_json::Map<String, Json> = (0..12)
        .map(|n| {
            let (sine, cosine) = (f64::from(n) * 0.52).sin_cos();
            let toward = json!({"direction": [sine, 0.9, cosine], "space": "world"});
            let lamp = json!({"type": "point", "position": [sine, 2.0, cosine], "space": "world"});
            (format!("light_{n}"), if n % 4 == 3 { lamp } else { toward })
        })
        .collect();
    let shaded = |tier: &str| {
        let shadow = json!({"id": "shadow", "kind": "cast_shadow", "tier": tier});
        look(&json!({"lights": lights, "definitions": {"own": {
                "inputs": [], "outputs": [{"name": "color"}],
                "nodes": [shadow, {"id": "share", "kind": "multiply", "values": {"b": 0.0833}},
                    {"id": "sum", "kind": "sum_of_lights"}],
                "wires": [{"from": "shadow", "to": "share.a"}, {"from": "share", "to": "sum.value"},
                    {"from": "sum", "to": "outputs.color"}]}},
            "nodes": [{"id": "each", "kind": "own", "for_each": "*"},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "each", "to": "output.color"}]}))
    };
    let things = || vec![floor(), placed("torus", DVec3::new(0.2, 0.3, 0.0), 0.8)];
    let setup = scene(&shaded("fast"), things(), 1.0);
    let plan = specialized(&setup);
    let maps = plan.shadow_maps.as_ref().expect("it asks for maps");
    assert_eq!(maps.layers.len(), 9 + 3 * 6, "a layer for each sun, six for each lamp");
    let [maps, rays] = [on_gpu(&setup), on_gpu(&scene(&shaded("exact"), things(), 1.0))];
    let (_, mean) = apart(&maps, &rays);
    println!("12 lights: {mean:.5} in the mean");
    assert!(rays.iter().any(|share| (0.05..0.9).contains(share)), "shadows of some lights alone");
    assert!(mean < 0.005, "{mean}");
}

#[test]
fn too_many_maps_are_refused() {
    let lamps: serde_json::Map<String, Json> = (0..43)
        .map(|n| {
            let place = [f64::from(n), 3.0, 1.0];
            (format!("lamp{n}"), json!({"type": "point", "position": place, "space": "world"}))
        })
        .collect();
    let shadows = (0..43).map(|n| {
        json!({"id": format!("s{n}"), "kind": "cast_shadow", "tier": "fast",
            "values": {"light": format!("lamp{n}")}})
    });
    let sums = (0..43).map(|n| json!({"id": format!("a{n}"), "kind": "add"}));
    let mut nodes: Vec<Json> = shadows.chain(sums).collect();
    nodes.push(json!({"id": "output", "kind": "output"}));
    let mut wires = vec![json!({"from": "a42", "to": "output.color"})];
    for n in 0..43 {
        wires.push(json!({"from": format!("s{n}"), "to": format!("a{n}.a")}));
        if n > 0 {
            wires.push(json!({"from": format!("a{}", n - 1), "to": format!("a{n}.b")}));
        }
    }
    let many = look(&json!({"lights": lamps, "nodes": nodes, "wires": wires}));
    let told = planned(&scene(&many, court(), 1.0), PlanStyle::Specialized).expect_err("258 maps");
    assert!(told.contains("too-many-shadow-maps") && told.contains("258"), "{told}");
}
