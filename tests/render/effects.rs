//! Effects of a scene: leaving one out changes no pixel, an effect that stays has a reason, and
//! passes run again only when their inputs changed.
#![cfg(feature = "gpu")]

use std::collections::{BTreeSet, HashMap, HashSet};
use std::path::Path;
use std::sync::Arc;

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::random::Random;
use crate::support::wait::block_on;
use chiaro::compile::{
    CompileOptions, CompiledShader, Live, Proof, Removal, Stage, VertexAttribute, compile,
};
use chiaro::document::{Camera, Light, LightKind, Projection, Scene, Tier, Value};
use chiaro::frame::{
    CullMode, Effect, EffectKind, EffectState, FramePlan, PassId, PixelArea, PlanOptions, Planner,
    Setup, SetupLook, effects,
};
use chiaro::interp::{self, Derivatives, Precision, Program, Shape};
use chiaro::library::{Context, Library};
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

const SIZE: [u32; 2] = [64, 48];

fn planned(planner: &mut Planner, setup: &Setup, live: &Live) -> FramePlan {
    let options = PlanOptions { size: SIZE, samples: 4, time: 0.0 };
    planner
        .plan(setup, Library::built_in(), live, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn plan(setup: &Setup, cull: CullMode) -> FramePlan {
    planned(&mut Planner::default().culling(cull), setup, &Live::Keyed)
}

fn pixels(plan: &FramePlan) -> Vec<[u32; 4]> {
    let picture = block_on(renderer().picture(plan)).unwrap_or_else(|error| panic!("{error}"));
    picture.rgba.iter().map(|pixel| pixel.map(f32::to_bits)).collect()
}

/// A look of one color and its facing ratio, so that every pixel depends on the surface.
fn plain(name: &str, color: [f64; 3]) -> SetupLook {
    look(&json!({"name": name, "nodes": [
        {"id": "facing", "kind": "facing"},
        {
            "id": "mix", "kind": "mix_values",
            "values": {"a": [color[0], color[1], color[2], 1], "b": [1, 1, 1, 1]}
        },
        {"id": "output", "kind": "output"}
    ], "wires": [{"from": "facing", "to": "mix.factor"}, {"from": "mix", "to": "output.color"}]}))
}

fn dropped(plan: &FramePlan, kind: EffectKind) -> Vec<Proof> {
    plan.dropped
        .iter()
        .filter(|dropped| dropped.kind == kind)
        .map(|dropped| dropped.proof)
        .collect()
}

#[test]
fn objects_that_are_not_seen_change_no_pixel() {
    let mut random = Random::new(80);
    let (mesh, fitted) = shape("knot");
    let mut proofs = HashSet::new();
    let mut seen = 0;
    for index in 0..24 {
        let mut parts = Vec::new();
        for object in 0..6 {
            let place = random.direction() * random.between(0.0, 12.0);
            let scale = match random.index(8) {
                0 => DVec3::ZERO,
                1 => DVec3::new(0.0, 0.7, 0.0),
                2 => DVec3::new(1.0, 0.0, 1.0),
                _ => DVec3::splat(random.between(0.2, 3.0)),
            };
            let matrix =
                DMat4::from_scale_rotation_translation(scale, random.rotation(), place) * fitted;
            let color = [random.unit(), random.unit(), random.unit()];
            parts.push((plain(&format!("look {object}"), color), mesh.clone(), matrix));
        }
        let projection =
            if index % 2 == 0 { Projection::Perspective } else { Projection::Orthographic };
        let camera =
            Camera { eye: [0.0, 1.0, random.between(2.0, 9.0)], projection, ..Camera::default() };
        let mut setup = scene_of(parts, Scene { camera, ..Scene::default() });
        if index % 3 == 0 {
            setup.objects[0].looks.fill(None);
        }
        let (kept, culled) = (plan(&setup, CullMode::Nothing), plan(&setup, CullMode::All));
        assert_eq!(pixels(&kept), pixels(&culled), "scene {index}");
        proofs.extend(dropped(&culled, EffectKind::Object));
        assert_eq!(culled.draws.len() + dropped(&culled, EffectKind::Object).len(), 6);
        seen += culled.draws.len();
    }
    assert_eq!(proofs, HashSet::from([Proof::OffScreen, Proof::NoSurface, Proof::NoLook]));
    assert!(seen > 20, "{seen} objects are seen");
}

#[test]
fn an_object_on_the_edge_of_the_picture_is_kept() {
    let (mesh, fitted) = shape("sphere");
    let at = |x: f64| {
        let parts = vec![(
            plain("look", [0.2, 0.4, 0.8]),
            mesh.clone(),
            DMat4::from_translation(DVec3::X * x) * fitted,
        )];
        let camera = Camera {
            eye: [0.0, 0.0, 5.0],
            target: [0.0; 3],
            projection: Projection::Orthographic,
            height: 2.0,
            ..Camera::default()
        };
        plan(&scene_of(parts, Scene { camera, ..Scene::default() }), CullMode::All).draws.len()
    };
    // The picture is 64 by 48, so that its edge is at 4/3, and the ball's edge is 1 further in.
    assert_eq!([at(0.0), at(2.3), at(-2.3), at(2.4), at(-2.4)], [1, 1, 1, 0, 0]);
}

/// Passes over the picture run only where objects may be seen, and nothing of the picture shows it.
#[test]
fn passes_over_the_picture_stay_where_objects_are() {
    let mut random = Random::new(22);
    let (mesh, fitted) = shape("knot");
    let measuring = look(&json!({"name": "measuring", "nodes": [
        {"id": "transition", "kind": "transition", "values": {"slope": 0.2}},
        {
            "id": "color", "kind": "curvature_color",
            "values": {"convex": [0.9, 0.6, 0.2, 1], "concave": [0.1, 0.2, 0.7, 1]}
        },
        {"id": "lamp", "kind": "light", "values": {"light": "key"}},
        {"id": "tone", "kind": "exaggerated"},
        {"id": "mix", "kind": "mix_values", "values": {"b": [1, 1, 1, 1]}},
        {"id": "output", "kind": "output"}
    ], "wires": [
        {"from": "transition", "to": "color.convexity"},
        {"from": "lamp", "to": "tone.light"},
        {"from": "color", "to": "mix.a"},
        {"from": "tone", "to": "mix.factor"},
        {"from": "mix", "to": "output.color"}
    ], "lights": {"key": {"direction": [0.3, 0.9, 0.4]}}}));
    let (mut parts_of_pictures, mut whole) = (0, 0);
    for index in 0..16 {
        let parts: Vec<_> = (0..1 + index % 3)
            .map(|_| {
                let place = random.direction() * random.between(0.0, 4.0);
                let scale = DVec3::splat(random.between(0.1, 1.5));
                let matrix =
                    DMat4::from_scale_rotation_translation(scale, random.rotation(), place);
                (measuring.clone(), mesh.clone(), matrix * fitted)
            })
            .collect();
        let projection =
            if index % 2 == 0 { Projection::Perspective } else { Projection::Orthographic };
        let eye = [random.between(-1.0, 1.0), 1.0, random.between(0.5, 9.0)];
        let camera = Camera { eye, projection, height: 5.0, ..Camera::default() };
        let setup = scene_of(parts, Scene { camera, backdrop: None, ..Scene::default() });
        for samples in [1, 4] {
            let options = PlanOptions { size: SIZE, samples, time: 0.0 };
            let planned =
                Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
            let plan = planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value;
            let everywhere = FramePlan { covered: PixelArea::whole(SIZE), ..plan.clone() };
            let drawn = pixels(&plan);
            assert_eq!(drawn, pixels(&everywhere), "scene {index}, {samples} samples");
            for (number, pixel) in drawn.iter().enumerate() {
                let at = [number as u32 % SIZE[0], number as u32 / SIZE[0]];
                let is_clear = f32::from_bits(pixel[3]) == 0.0;
                assert!(is_clear || plan.covered.contains(at), "scene {index}: {at:?}");
            }
            assert!(plan.passes.iter().filter(|pass| pass.id.is_screen()).count() >= 5);
            parts_of_pictures += usize::from(plan.screen_area() != PixelArea::whole(SIZE));
            whole += usize::from(plan.screen_area() == PixelArea::whole(SIZE));
        }
    }
    assert!(parts_of_pictures > 6 && whole > 1, "{parts_of_pictures} and {whole}");
}

fn lit(light: &Json) -> SetupLook {
    look(&json!({"name": "lit", "lights": {"key": {"direction": [1, 2, 3]}, "other": light},
    "nodes": [
        {"id": "base", "kind": "base", "values": {"color": [0.2, 0.3, 0.4, 1]}},
        {
            "id": "one", "kind": "light_layer",
            "values": {
                "light": "key", "convex": [0.5, 0.4, 0.3, 1], "concave": [0.5, 0.4, 0.3, 1]
            }
        },
        {
            "id": "two", "kind": "light_layer",
            "values": {
                "light": "other", "convex": [0.3, 0.4, 0.5, 1], "concave": [0.3, 0.4, 0.5, 1]
            }
        },
        {"id": "output", "kind": "output"}
    ],
    "wires": [
        {"from": "base", "to": "one.below"}, {"from": "one.below", "to": "two.below"},
        {"from": "two.below", "to": "output.color"}
    ]}))
}

#[test]
fn lights_that_reach_nothing_change_no_pixel_and_cost_nothing() {
    let (mesh, fitted) = shape("creature");
    let dark = [
        ("out", json!({"direction": [0, 1, 0], "intensity": 0})),
        ("black", json!({"direction": [0, 1, 0], "color": [0, 0, 0]})),
        ("too far", json!({"type": "point", "position": [0, 5, 0], "range": 3.9})),
        (
            "turned away",
            json!({"type": "spot", "position": [0, 0, 4], "aim": [0, 0, 1], "outer": 0.6}),
        ),
    ];
    for (what, light) in &dark {
        let setup = scene_of(vec![(lit(light), mesh.clone(), fitted)], Scene::default());
        let (kept, culled) = (plan(&setup, CullMode::Objects), plan(&setup, CullMode::All));
        assert_eq!(pixels(&kept), pixels(&culled), "{what}");
        assert_eq!(dropped(&culled, EffectKind::Light), [Proof::NoLight], "{what}");
        let lights = |plan: &FramePlan| {
            plan.draws[0].look.host.lights().map(ToString::to_string).collect::<BTreeSet<_>>()
        };
        assert_eq!(lights(&kept), BTreeSet::from(["key".to_owned(), "other".to_owned()]), "{what}");
        assert_eq!(
            lights(&culled),
            BTreeSet::from(["key".to_owned()]),
            "{what}: it still has uniforms"
        );
        let removed = culled.draws[0]
            .look
            .removed
            .iter()
            .any(|removal| removal.path.to_string() == "two/blend");
        assert!(removed, "{what}: {:?}", culled.draws[0].look.removed);
    }
    let near = [
        json!({"type": "point", "position": [0, 5, 0], "range": 4.1}),
        json!({
            "type": "spot", "position": [0, 0, 4], "aim": [0, 0.3, -1], "inner": 0.1, "outer": 0.2
        }),
        json!({
            "type": "spot", "position": [0, 0, 0.5], "aim": [0, 0, 1], "inner": 0.1, "outer": 0.2
        }),
    ];
    for light in &near {
        let culled = plan(
            &scene_of(vec![(lit(light), mesh.clone(), fitted)], Scene::default()),
            CullMode::All,
        );
        assert_eq!(dropped(&culled, EffectKind::Light), [], "{light}");
    }
}

#[test]
fn a_light_of_the_scene_decides_and_one_that_is_keyed_is_never_dark() {
    let (mesh, fitted) = shape("sphere");
    let out = json!({"direction": [0, 1, 0], "intensity": 0});
    let bright = Light { kind: LightKind::Directional, ..Light::default() };
    let scene =
        Scene { lights: [("other".into(), bright)].into_iter().collect(), ..Scene::default() };
    let culled = plan(&scene_of(vec![(lit(&out), mesh.clone(), fitted)], scene), CullMode::All);
    assert_eq!(dropped(&culled, EffectKind::Light), []);
    let mut keyed = lit(&out);
    let text = keyed.look.to_text().replacen(
        "\"nodes\"",
        "\"time_keys\": \
         [{\"target\": \"lights.other.intensity\", \"keys\": [{\"time\": 0, \"value\": 0}, \
         {\"time\": 1, \"value\": 1}]}],\n\"nodes\"",
        1,
    );
    keyed = look(&serde_json::from_str(&text).expect("JSON"));
    assert_eq!(keyed.look.time_keys.len(), 1, "{text}");
    let culled = plan(&scene_of(vec![(keyed, mesh, fitted)], Scene::default()), CullMode::All);
    assert_eq!(dropped(&culled, EffectKind::Light), []);
}

#[test]
fn forty_of_fifty_looks_are_not_compiled_and_equal_ones_once() {
    let (mesh, fitted) = shape("sphere");
    let parts = (0..50).map(|index| {
        // Ten objects are in two rows before the camera, the others far to the side.
        let place = if index % 5 == 0 {
            DVec3::new(f64::from(index) / 5.0 - 4.5, 0.0, 0.0)
        } else {
            DVec3::new(1e3, f64::from(index), 0.0)
        };
        let matrix =
            DMat4::from_translation(0.3 * place) * DMat4::from_scale(DVec3::splat(0.2)) * fitted;
        (plain(&format!("look {index}"), [0.02 * f64::from(index), 0.5, 0.5]), mesh.clone(), matrix)
    });
    let setup = scene_of(parts.collect(), Scene::default());
    let culled = plan(&setup, CullMode::All);
    let looks: HashSet<*const CompiledShader> =
        culled.draws.iter().map(|draw| Arc::as_ptr(&draw.look)).collect();
    assert_eq!((culled.draws.len(), looks.len()), (10, 10));
    assert_eq!(dropped(&culled, EffectKind::Object), [Proof::OffScreen; 40]);

    let same = [0.0, 0.7].map(|x| {
        (
            plain("twin", [0.2, 0.4, 0.6]),
            mesh.clone(),
            DMat4::from_translation(DVec3::X * x) * fitted,
        )
    });
    let twins = plan(&scene_of(same.into(), Scene::default()), CullMode::All);
    assert!(Arc::ptr_eq(&twins.draws[0].look, &twins.draws[1].look));
    assert_eq!(dropped(&twins, EffectKind::Look), [Proof::Equal]);
}

/// A look for every kind of proof that a node can be left out, without lights, with the node that
/// is left out.
fn removable() -> Vec<(Proof, &'static str, Json, Json)> {
    let facing = json!({"id": "facing", "kind": "facing"});
    let noise = json!({"id": "noise", "kind": "noise", "values": {"octaves": 3}});
    let mut looks = vec![
        (
            Proof::Unreachable,
            "noise",
            json!([facing, noise]),
            json!([{"from": "facing", "to": "output.color"}]),
        ),
        (
            Proof::ZeroWeight,
            "mix",
            json!([facing, noise, {"id": "mix", "kind": "mix_values", "values": {"factor": 0}}]),
            json!([
                {"from": "facing", "to": "mix.a"}, {"from": "noise", "to": "mix.b"},
                {"from": "mix", "to": "output.color"}
            ]),
        ),
        (
            Proof::NoEffect,
            "power",
            json!([facing, {"id": "power", "kind": "power", "values": {"exponent": 1}}]),
            json!([
                {"from": "facing", "to": "power.base"}, {"from": "power", "to": "output.color"}
            ]),
        ),
        (
            Proof::Constant,
            "noise",
            json!([
                facing, {"id": "noise", "kind": "noise", "values": {"position": [0.3, 0.2, 0.1]}},
                {"id": "sum", "kind": "add"}
            ]),
            json!([
                {"from": "facing", "to": "sum.a"}, {"from": "noise", "to": "sum.b"},
                {"from": "sum", "to": "output.color"}
            ]),
        ),
        (
            Proof::Equal,
            "twin",
            json!([
                facing, noise, {"id": "twin", "kind": "noise", "values": {"octaves": 3}},
                {"id": "sum", "kind": "add"}, {"id": "all", "kind": "multiply"}
            ]),
            json!([
                {"from": "noise", "to": "sum.a"}, {"from": "twin", "to": "sum.b"},
                {"from": "sum", "to": "all.a"}, {"from": "facing", "to": "all.b"},
                {"from": "all", "to": "output.color"}
            ]),
        ),
    ];
    looks.extend(removable_by_ranges(&facing, &noise));
    looks
}

/// Looks with a node that ranges of values prove to do nothing.
fn removable_by_ranges(facing: &Json, noise: &Json) -> Vec<(Proof, &'static str, Json, Json)> {
    vec![
        // The value is 2 or more, above the edge however wide the pixel is: the mask is 1, and the
        // mix is its B.
        (
            Proof::Ranges,
            "mask",
            json!([
                facing, noise, {"id": "more", "kind": "add", "values": {"b": 2}},
                {"id": "mask", "kind": "threshold", "values": {"edge": 0.5}},
                {"id": "mix", "kind": "mix_values"}
            ]),
            json!([
                {"from": "facing", "to": "more.a"}, {"from": "more", "to": "mask.value"},
                {"from": "mask", "to": "mix.factor"}, {"from": "noise", "to": "mix.a"},
                {"from": "facing", "to": "mix.b"}, {"from": "mix", "to": "output.color"}
            ]),
        ),
        // The same holds for an ambient profile, whose result does not depend on the angle.
        (
            Proof::Ranges,
            "profile",
            json!([
                facing,
                {"id": "profile", "kind": "profile", "values": {"offset": std::f64::consts::PI}},
                {"id": "all", "kind": "multiply"}
            ]),
            json!([
                {"from": "facing", "to": "profile.angle"}, {"from": "profile", "to": "all.a"},
                {"from": "facing", "to": "all.b"}, {"from": "all", "to": "output.color"}
            ]),
        ),
        // The clamp cannot clamp: noise lies in [0, 1], and half of it in [0, 0.5].
        (
            Proof::Ranges,
            "clamp",
            json!([
                noise, {"id": "half", "kind": "multiply", "values": {"b": 0.5}},
                {"id": "clamp", "kind": "clamp_range", "values": {"low": -0.5, "high": 0.75}}
            ]),
            json!([
                {"from": "noise", "to": "half.a"}, {"from": "half", "to": "clamp.value"},
                {"from": "clamp", "to": "output.color"}
            ]),
        ),
        // The factor never exceeds 0.
        (
            Proof::Ranges,
            "mix",
            json!([
                facing, noise, {"id": "less", "kind": "subtract", "values": {"b": 1}},
                {"id": "mix", "kind": "mix_values"}
            ]),
            json!([
                {"from": "noise", "to": "less.a"}, {"from": "less", "to": "mix.factor"},
                {"from": "facing", "to": "mix.a"}, {"from": "noise", "to": "mix.b"},
                {"from": "mix", "to": "output.color"}
            ]),
        ),
        // The look is opaque, so it is never cut.
        (
            Proof::Ranges,
            "output",
            json!([facing]),
            json!([{"from": "facing", "to": "output.color"}]),
        ),
    ]
}

fn removable_look(nodes: &Json, wires: &Json, is_cut: bool) -> SetupLook {
    let mut nodes = nodes.as_array().expect("a list").clone();
    nodes.push(if is_cut {
        json!({"id": "output", "kind": "output", "values": {"cutoff": 0.5}})
    } else {
        json!({"id": "output", "kind": "output"})
    });
    look(&json!({"nodes": nodes, "wires": wires}))
}

/// The scalars of `shade`'s result for a surface, in f32.
fn shaded(shader: &CompiledShader, surface: &HashMap<&str, Vec<f64>>) -> Vec<u32> {
    let options = interp::FunctionOptions {
        derivatives: Derivatives::Zero,
        ..interp::FunctionOptions::default()
    };
    let program =
        Program::compile(&shader.valid.module, "shade", options).expect("it runs on the CPU");
    let argument = |shape: &Shape| {
        let Shape::Struct { members, .. } = shape else { panic!("{shape:?}") };
        let value = |(name, shape): &(String, Shape)| match shape {
            Shape::Scalar(_) => interp::Value::Float(surface[name.as_str()][0]),
            _ => interp::Value::vec(&surface[name.as_str()]),
        };
        interp::Value::Struct(members.iter().map(value).collect())
    };
    let arguments: Vec<_> =
        program.parameters().iter().map(|parameter| argument(&parameter.shape)).collect();
    let mut values = vec![program.call(&arguments, Precision::F32).expect("it ends")];
    let mut bits = Vec::new();
    while let Some(value) = values.pop() {
        match value.parts() {
            // The result of a look that may be cut is a struct whose first member is the color.
            Some(parts) => values.extend(parts.first().cloned()),
            None => bits.extend(
                value.components().unwrap_or_default().iter().map(|x| (*x as f32).to_bits()),
            ),
        }
    }
    bits
}

#[test]
fn every_kind_of_removal_changes_last_digits_alone() {
    let library = Library::built_in();
    let (mesh, fitted) = shape("creature");
    let mut random = Random::new(81);
    let mut proofs = HashSet::new();
    for (proof, node, nodes, wires) in removable() {
        let look = removable_look(&nodes, &wires, node == "output");
        let pruned =
            compile(&look.look, library, &CompileOptions::default()).expect("it compiles").value;
        let whole = compile(
            &look.look,
            library,
            &CompileOptions { unspecialized: true, ..CompileOptions::default() },
        )
        .expect("it compiles")
        .value;
        // Either of two equal nodes may be the one that is removed.
        let is_it =
            |removal: &&Removal| removal.path.to_string() == node || removal.proof == Proof::Equal;
        let removal = pruned.removed.iter().find(is_it);
        let removal = removal.unwrap_or_else(|| {
            panic!("{node} is not removed: {:?}\n{}", pruned.removed, pruned.wgsl)
        });
        assert_eq!(removal.proof, proof, "{removal:?}");
        proofs.insert(proof);
        for _ in 0..200 {
            let unit = |random: &mut Random| random.direction().to_array().to_vec();
            let surface = HashMap::from([
                ("normal", unit(&mut random)),
                ("view", unit(&mut random)),
                ("position", unit(&mut random)),
                ("position_object", unit(&mut random)),
            ]);
            let [left, right] = [&pruned, &whole].map(|shader| shaded(shader, &surface));
            let is_near = |(a, b): (&u32, &u32)| {
                let [a, b] = [a, b].map(|bits| f32::from_bits(*bits));
                (a - b).abs() <= 1e-6 * b.abs().max(1.0) || a.to_bits() == b.to_bits()
            };
            let is_same = left.len() == right.len() && left.iter().zip(&right).all(is_near);
            assert!(is_same, "{node}: {surface:?}\n{left:?} {right:?}\n{}", pruned.wgsl);
        }
        // The GPU draws the same look whole if its values are live, which prunes nothing.
        let setup = scene_of(vec![(look, mesh.clone(), fitted)], Scene::default());
        let live = pixels(&planned(&mut Planner::default(), &setup, &Live::All));
        let baked = pixels(&planned(&mut Planner::default(), &setup, &Live::Keyed));
        let far = |a: &[u32; 4], b: &[u32; 4]| {
            a.iter()
                .zip(b)
                .any(|(a, b)| (f32::from_bits(*a) - f32::from_bits(*b)).abs() > 1.0 / 255.0)
        };
        assert!(!live.iter().zip(&baked).any(|(a, b)| far(a, b)), "{node}");
    }
    let nodes = [
        Proof::Unreachable,
        Proof::ZeroWeight,
        Proof::NoEffect,
        Proof::Constant,
        Proof::Equal,
        Proof::Ranges,
    ];
    assert_eq!(proofs, HashSet::from(nodes));
}

#[test]
fn live_values_are_never_proved_by_ranges() {
    for (_, node, nodes, wires) in removable() {
        let look = removable_look(&nodes, &wires, node == "output");
        let live = CompileOptions { live: Live::All, ..CompileOptions::default() };
        let shader = compile(&look.look, Library::built_in(), &live).expect("it compiles").value;
        let proved: Vec<_> =
            shader.removed.iter().filter(|removal| removal.proof == Proof::Ranges).collect();
        // An opaque look stays opaque, whatever is edited.
        assert!(
            proved.iter().all(|removal| removal.path.to_string() == "output" && node != "output"),
            "{node}: {proved:?}"
        );
    }
}

fn effect<'e>(effects: &'e [Effect], what: &str) -> &'e Effect {
    effects
        .iter()
        .find(|effect| effect.what == what)
        .unwrap_or_else(|| panic!("no {what} in {effects:#?}"))
}

#[test]
fn attributes_textures_lights_and_passes_exist_only_while_something_needs_them() {
    let (mesh, fitted) = shape("creature");
    let with_factor = |factor: f64| {
        let look =
            look(&json!({"name": "one", "lights": {"key": {"direction": [1, 1, 1]}}, "nodes": [
                {"id": "facing", "kind": "facing"},
                // The image does not exist: loading it would be an error.
                {"id": "image", "kind": "image", "values": {"image": "nowhere.png"}},
                {"id": "kappa", "kind": "kappa"},
                {"id": "tinted", "kind": "multiply"},
                {"id": "mix", "kind": "mix_values", "values": {"factor": factor}},
                {"id": "output", "kind": "output"}
            ], "wires": [
                {"from": "image.alpha", "to": "tinted.a"}, {"from": "kappa", "to": "tinted.b"},
                {"from": "facing", "to": "mix.a"}, {"from": "tinted", "to": "mix.b"},
                {"from": "mix", "to": "output.color"}
            ]}));
        scene_of(vec![(look, mesh.clone(), fitted)], Scene::default())
    };
    let options = PlanOptions { size: SIZE, samples: 1, time: 0.0 };
    let wanted =
        Planner::default().plan(&with_factor(0.5), Library::built_in(), &Live::Keyed, &options);
    let problems = wanted.expect_err("the image is needed and is not there");
    assert!(problems.iter().any(|problem| problem.code == "missing-asset"), "{}", told(&problems));

    let unneeded = plan(&with_factor(0.0), CullMode::All);
    let shader = &unneeded.draws[0].look;
    assert_eq!(shader.needs.attributes(), [VertexAttribute::Position, VertexAttribute::Normal]);
    assert!(!shader.needs.context(Context::KAPPA) && !shader.needs.context(Context::named("uv")));
    let names: Vec<&str> = shader.bindings.iter().map(|binding| binding.name.as_str()).collect();
    assert_eq!(names, ["view", "object"], "no image, no uniform, no curvature");
    assert_eq!(unneeded.passes.iter().map(|pass| pass.id).collect::<Vec<_>>(), [PassId::LOOK]);
    pixels(&unneeded);

    let told = effects(&unneeded, &HashMap::new());
    for (what, kind, proof) in [
        ("vertex uv", EffectKind::Attribute, Proof::Unreachable),
        ("vertex tangent", EffectKind::Attribute, Proof::Unreachable),
        ("nowhere.png", EffectKind::Texture, Proof::Unreachable),
        ("light `key`", EffectKind::Light, Proof::Unreachable),
        ("curvature of the surface", EffectKind::Pass, Proof::Unreachable),
        ("uniforms of the look", EffectKind::Uniforms, Proof::Constant),
        ("node `mix`", EffectKind::Node, Proof::ZeroWeight),
    ] {
        let found = effect(&told, what);
        assert_eq!(
            (found.kind, found.state, found.proof),
            (kind, EffectState::Dropped, Some(proof)),
            "{what}"
        );
    }
    for what in ["look", "vertex normal", "node `facing`", "object `object_0`", "one"] {
        assert_eq!(effect(&told, what).state, EffectState::Runs, "{what}");
    }
}

/// A look with curvature of the surface and of its bumps, which come from an image in `folder`.
fn bumpy(folder: &Path, color: [f64; 3]) -> SetupLook {
    let mut bumpy = look(&json!({"name": "bumpy", "nodes": [
        {"id": "image", "kind": "image", "values": {"image": "bumps.png", "encoding": "data"}},
        {"id": "bump", "kind": "bump_map", "values": {"scale": 0.2}},
        {"id": "coarse", "kind": "kappa"},
        {"id": "fine", "kind": "kappa", "values": {"source": "detail"}},
        {"id": "sum", "kind": "add"},
        {"id": "convexity", "kind": "transition", "values": {"slope": 0.3}},
        {
            "id": "color", "kind": "curvature_color",
            "values": {"convex": [color[0], color[1], color[2], 1], "concave": [0, 0, 0, 1]}
        },
        {"id": "output", "kind": "output"}
    ], "wires": [
        {"from": "image.color", "to": "bump.height"}, {"from": "bump", "to": "output.normal"},
        {"from": "coarse", "to": "sum.a"}, {"from": "fine", "to": "sum.b"},
        {"from": "sum", "to": "convexity.kappa"},
        {"from": "convexity", "to": "color.convexity"}, {"from": "color", "to": "output.color"}
    ]}));
    bumpy.folder = folder.to_path_buf();
    bumpy
}

fn write_bumps(folder: &Path, period: u32) {
    let side = 16 * period;
    let picture = image::RgbaImage::from_fn(side, 64, |x, _| {
        let level = if (x / period).is_multiple_of(2) { 20 } else { 230 };
        image::Rgba([level, level, level, 255])
    });
    picture.save(folder.join("bumps.png")).expect("the folder can be written to");
}

const NORMALS: PassId = PassId::named("normals");
const CURVATURE: PassId = PassId::named("curvature");
const SPARSE_CURVATURE: PassId = PassId::named("curvature_sparse");
const DETAIL_NORMALS: PassId = PassId::named("detail_normals");
const DETAIL_CURVATURE: PassId = PassId::named("detail_curvature");
const SPARSE_DETAIL_CURVATURE: PassId = PassId::named("detail_curvature_sparse");

/// Looks of different tiers compute curvature in different ways, side by side: from the same
/// normals, each pass with the objects that read it.
#[test]
fn each_tier_of_curvature_has_a_pass_of_its_own() {
    let folder = tempfile::tempdir().expect("a folder");
    write_bumps(folder.path(), 3);
    let (mesh, fitted) = shape("sphere");
    let colored = |name: &str, color, tier| {
        let mut bumpy = bumpy(folder.path(), color);
        bumpy.look.name = name.to_owned();
        bumpy.look.set_every_tier(tier);
        (bumpy, mesh.clone(), DMat4::from_translation(DVec3::X * color[0]) * fitted)
    };
    let plan =
        |looks| planned(&mut Planner::default(), &scene_of(looks, Scene::default()), &Live::Keyed);
    let passes = |plan: &FramePlan| -> Vec<(PassId, String)> {
        plan.passes.iter().map(|pass| (pass.id, pass.reason.clone())).collect()
    };
    let red = [0.9, 0.1, 0.1];
    let both = passes(&plan(vec![
        colored("careful", red, Tier::Exact),
        colored("quick", [0.1, 0.9, 0.1], Tier::Balanced),
        colored("quickest", [0.4, 0.4, 0.4], Tier::Fast),
    ]));
    let wanted = [
        (NORMALS, "careful"),
        (CURVATURE, "careful"),
        (SPARSE_CURVATURE, "quick"),
        (DETAIL_NORMALS, "careful"),
        (DETAIL_CURVATURE, "careful"),
        (SPARSE_DETAIL_CURVATURE, "quick"),
        (PassId::LOOK, "it is the picture"),
    ];
    assert_eq!(both.len(), wanted.len(), "{both:?}");
    for ((kind, reason), (wanted, word)) in both.iter().zip(&wanted) {
        assert!(kind == wanted && reason.contains(word), "{kind:?}: {reason}");
    }
    // A look alone, of a single tier, needs no other tier's pass.
    let kinds = |tier| {
        passes(&plan(vec![colored("one", red, tier)]))
            .into_iter()
            .map(|pass| pass.0)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        kinds(Tier::Balanced),
        [NORMALS, SPARSE_CURVATURE, DETAIL_NORMALS, SPARSE_DETAIL_CURVATURE, PassId::LOOK]
    );
    assert_eq!(kinds(Tier::Fast), [DETAIL_NORMALS, SPARSE_DETAIL_CURVATURE, PassId::LOOK]);
    // Side by side, looks are the same as alone, on targets that one renderer keeps.
    let mut renderer = renderer();
    let mut draw =
        |looks| block_on(renderer.picture(&plan(looks))).unwrap_or_else(|error| panic!("{error}"));
    let beside = |tier| {
        let (look, mesh, _) = colored("other", red, tier);
        (look, mesh, DMat4::from_translation(DVec3::X * -0.9) * fitted)
    };
    let [exact, sparse] = [Tier::Exact, Tier::Balanced]
        .map(|tier| draw(vec![colored("one", red, tier), beside(tier)]));
    let mixed = draw(vec![colored("one", red, Tier::Balanced), beside(Tier::Exact)]);
    let differing = |a: &chiaro::render::Picture, b: &chiaro::render::Picture| {
        let far =
            |(a, b): &(&[f32; 4], &[f32; 4])| a.iter().zip(*b).any(|(a, b)| (a - b).abs() > 0.02);
        a.rgba.iter().zip(&b.rgba).filter(far).count()
    };
    let [one, other, tiers] =
        [differing(&mixed, &sparse), differing(&mixed, &exact), differing(&exact, &sparse)];
    assert!(tiers > 100, "the tiers differ on bumps, and not in {tiers} pixels");
    assert!(
        one < tiers && other < tiers,
        "each object has its own tier: {one} and {other} of {tiers}"
    );
    assert!(one + other <= tiers + 20, "{one} and {other} of {tiers}");
}

#[test]
fn work_repeats_only_if_what_it_reads_changed() {
    let folder = tempfile::tempdir().expect("a folder");
    write_bumps(folder.path(), 3);
    let (mesh, fitted) = shape("sphere");
    let setup = |color: [f64; 3], camera: Camera| {
        let scene = Scene { camera, ..Scene::default() };
        let mut setup = scene_of(vec![(bumpy(folder.path(), color), mesh.clone(), fitted)], scene);
        setup.objects[0].mesh = Arc::new(mesh.clone());
        setup
    };
    let mut planner = Planner::default();
    let mut renderer = renderer();
    let mut first = setup([0.8, 0.5, 0.2], Camera::default());
    let mut run = |setup: &Setup| {
        let plan = planned(&mut planner, setup, &Live::Keyed);
        let told = effects(&plan, renderer.done());
        let ran = block_on(renderer.draw(&plan)).unwrap_or_else(|error| panic!("{error}"));
        // The effects that were told before drawing are those that happened.
        let runs = told
            .iter()
            .filter(|effect| effect.kind == EffectKind::Pass && effect.state == EffectState::Runs);
        assert_eq!(
            runs.map(|effect| effect.what.as_str()).collect::<Vec<_>>(),
            ran.iter().map(|pass| pass.label()).collect::<Vec<_>>()
        );
        ran
    };
    let all = [NORMALS, CURVATURE, DETAIL_NORMALS, DETAIL_CURVATURE, PassId::LOOK];
    assert_eq!(run(&first), all);
    assert_eq!(run(&first), [], "the same picture again");

    // The mesh keeps its address in memory, as it does in a scene.
    let kept = first.objects[0].mesh.clone();
    first = setup([0.1, 0.5, 0.9], Camera::default());
    first.objects[0].mesh = kept.clone();
    assert_eq!(run(&first), [PassId::LOOK], "another color");

    write_bumps(folder.path(), 4);
    assert_eq!(run(&first), [DETAIL_NORMALS, DETAIL_CURVATURE, PassId::LOOK], "other bumps");

    let mut moved = setup([0.1, 0.5, 0.9], Camera { eye: [1.0, 1.0, 4.0], ..Camera::default() });
    moved.objects[0].mesh = kept;
    assert_eq!(run(&moved), all, "another camera");
}

/// The bumps are seen by the curvature pass although the look itself reads no picture.
#[test]
fn pictures_that_only_the_detail_normals_read_are_read() {
    let folder = tempfile::tempdir().expect("a folder");
    write_bumps(folder.path(), 3);
    let (mesh, fitted) = shape("sphere");
    let setup =
        scene_of(vec![(bumpy(folder.path(), [1.0, 1.0, 1.0]), mesh, fitted)], Scene::default());
    let plan = plan(&setup, CullMode::All);
    let draw = &plan.draws[0];
    assert!(draw.images_of(Stage::DetailNormals).iter().any(|image| image.size == [48, 64]));
    assert!(
        draw.images_of(Stage::Draw).iter().all(|image| image.size == [1, 1]),
        "the look itself binds none"
    );
    let bumpy = pixels(&plan);
    let mut flat = setup.clone();
    flat.looks[0].look.graph.nodes["bump"].values.insert("scale".into(), Value::Number(0.0));
    assert_ne!(bumpy, pixels(&self::plan(&flat, CullMode::All)));
}

/// Costs are counted in the shader itself: the costs of a look's nodes add up to the cost of the
/// look.
#[test]
fn every_effect_has_its_cost() {
    let (mesh, fitted) = shape("sphere");
    let stack =
        look(&json!({"name": "stack", "lights": {"key": {}, "out": {"intensity": 0}}, "nodes": [
            {"id": "base", "kind": "base"},
            {
                "id": "one", "kind": "light_layer",
                "values": {"light": "key", "slope": 0.4, "amount": 0.5, "falloff": 0.6}
            },
            {"id": "idle", "kind": "light_layer", "values": {"light": "key", "opacity": 0}},
            {"id": "output", "kind": "output"}
        ], "wires": [
            {"from": "base", "to": "one.below"}, {"from": "one", "to": "idle.below"},
            {"from": "idle", "to": "output.color"}
        ]}));
    let setup = scene_of(vec![(stack, mesh.clone(), fitted)], Scene::default());
    let plan = plan(&setup, CullMode::All);
    let mut effects = effects(&plan, &HashMap::new());
    let of = |kind| effects.iter().filter(move |effect| effect.kind == kind);
    let runs = |effect: &&Effect| effect.state != EffectState::Dropped;
    let nodes: u64 = of(EffectKind::Node).filter(runs).map(|effect| effect.cost.operations).sum();
    let whole = of(EffectKind::Look).find(runs).unwrap().cost.operations;
    assert!(nodes > 300 && nodes <= whole, "{nodes} of {whole}");
    assert!(whole - nodes < 60, "what belongs to no node unpacks what came in: {nodes} of {whole}");
    let profile = effect(&effects, "node `one/tone`").cost.operations;
    assert!(2 * profile > nodes, "the profile is most of it");
    // An effect that is left out tells its saving: its whole function.
    let saved: u64 = of(EffectKind::Node)
        .filter(|effect| !runs(effect))
        .map(|effect| effect.cost.operations)
        .sum();
    assert!(saved >= profile, "{saved}");
    let vertices = mesh.positions.len() as u64;
    assert_eq!(effect(&effects, "vertex position").cost.bytes, 12 * vertices);
    assert_eq!(effect(&effects, "vertex uv").cost.bytes, 8 * vertices);
    assert_eq!(effect(&effects, "light `key`").cost.bytes, 48);
    assert_eq!(effect(&effects, "curvature").cost.bytes, 4 * u64::from(SIZE[0] * SIZE[1]));
    let times = block_on(renderer().measure(&plan)).unwrap();
    chiaro::render::set_times(&mut effects, &times);
    for effect in effects.iter().filter(|effect| effect.kind == EffectKind::Pass && runs(effect)) {
        assert!(effect.cost.milliseconds.is_some_and(|time| time > 0.0), "{effect:?}");
    }
}
