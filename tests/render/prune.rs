//! Pruning changes nothing: specialized looks against unspecialized ones, live against baked.
#![cfg(feature = "gpu")]

use crate::support::eval::{content, eval_with, look, options, renderer};
use crate::support::examples::{looks, samples};
use crate::support::halved;
use crate::support::ledger::{Ledger, ProofKey, is_found_false};
use crate::support::random::Random;
use crate::support::report::Errors;
use crate::support::stacks::idle_stack;
use chiaro::compile::{CompileOptions, Live, compile};
use chiaro::document::Value;
use chiaro::frame::SetupLook;
use chiaro::library::{BypassResult, Fallback, Library, Limit, NodeDef, Test, Type};
use glam::DVec3;
use serde_json::{Map, Value as Json, json};

/// Compares one way of compiling a look with another.
fn compare(errors: &mut Errors, look: &SetupLook, a: &CompileOptions, b: &CompileOptions) {
    compare_in(Library::built_in(), errors, look, a, b);
}

fn compare_in(
    library: &Library,
    errors: &mut Errors,
    look: &SetupLook,
    a: &CompileOptions,
    b: &CompileOptions,
) {
    let samples = samples(3, 300);
    let (left, right) =
        (eval_with(look, library, a, &samples), eval_with(look, library, b, &samples));
    for ((x, y), sample) in left.iter().zip(&right).zip(&samples) {
        for (x, y) in x.iter().zip(y) {
            errors.note(*x, *y, || format!("{} at {sample:?}", look.look.name));
        }
    }
}

/// Ways of compiling that are compared with baked code, with their error bounds.
fn ways() -> [(&'static str, CompileOptions, f64); 2] {
    [
        (
            "unspecialized",
            CompileOptions { unspecialized: true, ..CompileOptions::default() },
            1.0 / 255.0,
        ),
        ("live", CompileOptions { live: Live::All, ..CompileOptions::default() }, 1e-5),
    ]
}

/// Key of the verdict on a look that is compiled in two ways.
fn key(library: &Library, look: &SetupLook, other: &CompileOptions, bound: f64) -> ProofKey {
    let mut key = ProofKey::of_judges(&["tests/render/prune.rs"])
        .with(renderer().gpu().info.driver_info.as_bytes())
        .with(&bound.to_le_bytes());
    for options in [&CompileOptions::default(), other] {
        content(look, library, options, &samples(3, 300), &mut |bytes| key.add(bytes));
    }
    key
}

/// The largest difference between a look as it is baked and as it is compiled in another way.
fn proof(
    library: &Library,
    look: &SetupLook,
    other: &CompileOptions,
    bound: f64,
) -> Result<f64, String> {
    let mut errors = Errors::new("baked against another way", bound);
    compare_in(library, &mut errors, look, &CompileOptions::default(), other);
    errors.verdict()
}

#[test]
fn examples_are_the_same_unspecialized_and_live() {
    let library = Library::built_in();
    let mut ledger = Ledger::open("pruned-gpu");
    for (name, look) in looks() {
        for (way, other, bound) in ways() {
            let key = key(library, &look, &other, bound);
            let case = format!("{name}, {way}");
            ledger.prove(&case, &key, || proof(library, &look, &other, bound));
        }
    }
    ledger.close();
}

/// A changed digit of a shader, and a forged line of the ledger, are both found.
#[test]
fn a_changed_shader_and_a_forged_line_are_found() {
    let look = halved::look();
    let (before, after) = (halved::library("0.5"), halved::library("0.5000001"));
    let [(_, other, bound), _] = ways();
    let keys = [&before, &halved::library("0.5"), &after]
        .map(|library| key(library, &look, &other, bound).text());
    assert_eq!(keys[0], keys[1]);
    assert_ne!(keys[0], keys[2]);
    let (key, proof) =
        (key(&before, &look, &other, bound), || proof(&before, &look, &other, bound));
    assert!(is_found_false("half", &key, 3e-3, proof), "a forged line");
    assert!(!is_found_false("half", &key, 0.0, proof), "an honest line");
}

#[test]
fn random_stacks_are_the_same_unspecialized_and_live() {
    let mut random = Random::new(70);
    let mut pruned = Errors::new("random stacks: specialized against unspecialized", 2e-5);
    let mut live = Errors::new("random stacks: live against keyed", 2e-5);
    let mut removed = 0;
    for _ in 0..16 {
        let look = idle_stack(&mut random);
        compare(
            &mut pruned,
            &look,
            &CompileOptions::default(),
            &CompileOptions { unspecialized: true, ..CompileOptions::default() },
        );
        compare(
            &mut live,
            &look,
            &CompileOptions::default(),
            &CompileOptions { live: Live::All, ..CompileOptions::default() },
        );
        removed += compile(&look.look, Library::built_in(), &CompileOptions::default())
            .expect("it compiles")
            .value
            .removed
            .len();
    }
    pruned.finish();
    live.finish();
    assert!(removed > 20, "hardly anything was removed: {removed}");
}

/// A suitable value for an input without a condition of a bypass.
fn ordinary(ty: &Type, random: &mut Random) -> Json {
    match ty {
        Type::Bool => json!(random.chance(0.5)),
        Type::Int => json!(random.index(4)),
        Type::Vec2 => json!([random.unit(), random.unit()]),
        Type::Vec3 => json!([random.unit(), random.unit(), random.unit()]),
        Type::Color | Type::Composite => {
            json!([random.unit(), random.unit(), random.unit(), random.unit()])
        }
        _ => json!(random.unit()),
    }
}

fn constant(ty: &Type, x: f64) -> Json {
    match ty {
        Type::Bool => json!(x != 0.0),
        Type::Vec2 => json!([x, x]),
        Type::Vec3 => json!([x, x, x]),
        Type::Color | Type::Composite => json!([x, x, x, x]),
        _ => json!(x),
    }
}

/// A node whose values meet a bypass' conditions; wired-only inputs come from a base.
fn bypassed(def: &NodeDef, index: usize, ty: &Type, random: &mut Random) -> SetupLook {
    let mut values = Map::new();
    let bypass = &def.bypasses[index];
    // Type of a port: a node for any type takes `ty`.
    let type_of = |port: &chiaro::library::Input| {
        let is_wide = def.variants.iter().any(|variant| variant.width.as_ref() == Some(ty));
        let is_first = port.ty == Type::Float
            && is_wide
            && !matches!(port.name.as_str(), "factor" | "low" | "high" | "exponent");
        if is_first { ty.clone() } else { port.ty.clone() }
    };
    for input in def.visible_inputs() {
        if matches!(input.fallback, Fallback::Value(_) | Fallback::Same(_))
            && input.options.is_empty()
        {
            values.insert(input.name.to_string(), ordinary(&type_of(input), random));
        }
    }
    for condition in &bypass.conditions {
        let input = &def.inputs[condition.input];
        let name = input.name.to_string();
        match &condition.test {
            Test::Is(x) => drop(values.insert(name, constant(&type_of(input), *x))),
            Test::Black => drop(values.insert(name, json!([0, 0, 0, 1]))),
            Test::Same(other) => {
                let other = values[def.inputs[*other].name.as_str()].clone();
                values.insert(name, other);
            }
            Test::Word(words) => drop(values.insert(name, json!(random.pick(words)))),
            // Values of `ordinary` lie between 0 and 1; so does a clamped stack.
            Test::Unit | Test::UnitAlpha => {}
            Test::AtMost(limit) | Test::AtLeast(limit) => {
                let side = if matches!(condition.test, Test::AtMost(_)) { -1.0 } else { 1.0 };
                match limit {
                    Limit::Number(number) => {
                        drop(values.insert(name, constant(&type_of(input), number + 0.5 * side)));
                    }
                    // The value is beyond all values of `ordinary`.
                    Limit::Input(other) => {
                        let other = &def.inputs[*other];
                        values
                            .insert(other.name.to_string(), constant(&type_of(other), 2.0 * -side));
                    }
                }
            }
        }
    }
    let mut nodes = vec![
        json!({"id": "base", "kind": "base", "values": {"color": [0.3, 0.6, 0.9, 0.5]}}),
        json!({"id": "output", "kind": "output"}),
    ];
    // An angle comes from a light's parametrization, and is shown through a profile.
    let mut wires = Vec::new();
    let uses = |ty: Type| def.visible_inputs().any(|input| input.ty == ty);
    if uses(Type::Angle) || uses(Type::Light) {
        nodes.push(json!({"id": "light", "kind": "light", "values": {"light": "key"}}));
    }
    if uses(Type::Angle) {
        nodes.push(json!({"id": "angle", "kind": "parametrization"}));
        wires.push(json!({"from": "light", "to": "angle.light"}));
    }
    if def.outputs[0].ty == Type::Angle {
        nodes.push(json!({"id": "tone", "kind": "profile"}));
        wires.push(json!({"from": "node", "to": "tone.angle"}));
        wires.push(json!({"from": "tone", "to": "output.color"}));
    } else if def.outputs[0].ty == Type::Light {
        nodes.push(json!({"id": "seen", "kind": "reflectance", "values": {"model": "lambert"}}));
        wires.push(json!({"from": "node", "to": "seen.light"}));
        wires.push(json!({"from": "seen", "to": "output.color"}));
    } else {
        wires.push(json!({"from": "node", "to": "output.color"}));
    }
    for input in def.visible_inputs().filter(|input| input.fallback == Fallback::Wire) {
        let from = match input.ty {
            Type::Angle => "angle",
            Type::Light => "light",
            _ => "base",
        };
        wires.push(json!({"from": from, "to": format!("node.{}", input.name)}));
    }
    if let BypassResult::Input(port) = bypass.result {
        // The input that takes the node's place is wired if it can be, so that its value is unknown
        // before the fragment.
        let input = &def.inputs[port];
        let is_free =
            bypass.conditions.iter().all(|c| c.input != port && c.test != Test::Same(port));
        let source = match type_of(input) {
            Type::Color => Some("vertex_color"),
            Type::Vec3 => Some("normal"),
            Type::Vec2 => Some("uv"),
            Type::Float => Some("facing"),
            _ => None,
        };
        if let (true, Some(source), Fallback::Value(_)) = (is_free, source, &input.fallback) {
            nodes.push(json!({"id": "source", "kind": source}));
            wires.push(json!({"from": "source", "to": format!("node.{}", input.name)}));
            values.remove(input.name.as_str());
        }
    }
    nodes.push(json!({"id": "node", "kind": def.kind, "values": values}));
    let lights = json!({"key": {"direction": [0.3, 0.5, 0.8]}});
    look(&json!({"lights": lights, "nodes": nodes, "wires": wires}))
}

/// Every `@bypass` of every node: with its conditions met, the node's result is the one that
/// replaces it.
#[test]
fn every_bypass_gives_what_the_node_gives() {
    let library = Library::built_in();
    let mut random = Random::new(71);
    let mut errors = Errors::new("bypassed against not bypassed", 0.0);
    let mut rules = 0;
    for def in library.nodes.values() {
        for index in 0..def.bypasses.len() {
            rules += 1;
            let wide = def.variants.iter().filter_map(|variant| variant.width.clone());
            for ty in [Type::Float].into_iter().chain(wide) {
                for _ in 0..2 {
                    let look = bypassed(def, index, &ty, &mut random);
                    let samples = samples(4, 40);
                    let with = eval_with(&look, library, &options("node"), &samples);
                    let without = eval_with(
                        &look,
                        library,
                        &CompileOptions { unspecialized: true, ..options("node") },
                        &samples,
                    );
                    for (x, y) in with.iter().flatten().zip(without.iter().flatten()) {
                        // A rule that holds for real numbers may be off by a few steps of f32, and
                        // so may the forms of what comes before the node.
                        let step = 4.0 * f64::from(f32::EPSILON) * y.abs().max(1.0);
                        let excess = ((x - y).abs() - step).max(0.0);
                        errors.note(excess, 0.0, || {
                            format!(
                                "{}, {} as {ty:?}\n{}",
                                def.kind,
                                def.bypasses[index].reason,
                                look.look.to_text()
                            )
                        });
                    }
                }
            }
        }
    }
    errors.finish();
    assert!(rules > 25, "{rules} rules");
}

/// Values that make a rule apply remove the node: each rule is reported.
#[test]
fn every_bypass_is_taken() {
    let library = Library::built_in();
    let mut random = Random::new(72);
    for def in library.nodes.values() {
        for (index, bypass) in def.bypasses.iter().enumerate() {
            let look = bypassed(def, index, &Type::Float, &mut random);
            let shader = compile(&look.look, library, &CompileOptions::default())
                .expect("it compiles")
                .value;
            let (node, call) = (chiaro::ids::NodePath::parse("node"), format!("{}(", def.kind));
            let is_gone = shader.removed.iter().any(|removal| removal.path == node)
                || !shader.wgsl.contains(&call);
            assert!(
                is_gone,
                "{}: {} is not taken\n{}",
                def.kind,
                bypass.reason,
                look.look.to_text()
            );
        }
    }
}

#[test]
fn a_value_that_is_edited_prunes_nothing() {
    let mut look = idle_stack(&mut Random::new(73));
    let library = Library::built_in();
    let live = CompileOptions { live: Live::All, ..CompileOptions::default() };
    let before = compile(&look.look, library, &live).expect("it compiles").value;
    for node in look.look.graph.nodes.values_mut().filter(|node| node.kind == "light_layer") {
        node.values.insert("opacity".into(), Value::Number(0.4));
        node.values.insert("slope".into(), Value::Number(0.7));
        node.values.insert("convex".into(), Value::Vector(DVec3::splat(0.3).to_array().to_vec()));
    }
    let after = compile(&look.look, library, &live).expect("it compiles").value;
    assert_eq!(before.wgsl, after.wgsl, "an edited value changed live code");
}
