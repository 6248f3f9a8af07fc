//! Lights that reach nothing: of their shadows no instruction is left, no uniform and no map.

use std::collections::BTreeSet;

use chiaro_compiler::compile::{CompileOptions, CompiledShader, Live, Proof, compile};
use chiaro_compiler::document::{LightInput, Look};
use chiaro_compiler::library::Library;
use chiaro_language::ids::LightId;

/// A look that draws all that is known of the shadows of `rim`, and what is cast of `key`.
fn shaded(tier: &str) -> Look {
    let text = format!(
        r#"{{"chiaro": "look", "tier": "{tier}",
            "lights": {{"key": {{"direction": [0, 1, 1]}}, "rim": {{"direction": [1, 1, 0]}}}},
            "nodes": [
                {{"id": "of_rim", "kind": "shadow", "values": {{"light": "rim", "size": 0.1}}}},
                {{"id": "of_key", "kind": "cast_shadow", "values": {{"light": "key"}}}},
                {{"id": "shares", "kind": "add"}}, {{"id": "blocker", "kind": "add"}},
                {{"id": "all", "kind": "add"}}, {{"id": "both", "kind": "add"}},
                {{"id": "output", "kind": "output"}}],
            "wires": [
                {{"from": "of_rim.cast", "to": "shares.a"}},
                {{"from": "of_rim.self", "to": "shares.b"}},
                {{"from": "of_rim.distance", "to": "blocker.a"}},
                {{"from": "of_rim.object", "to": "blocker.b"}},
                {{"from": "shares", "to": "all.a"}}, {{"from": "blocker", "to": "all.b"}},
                {{"from": "all", "to": "both.a"}}, {{"from": "of_key", "to": "both.b"}},
                {{"from": "both", "to": "output.color"}}]}}"#
    );
    let read = Look::read(&text, "look.json");
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    read.value.unwrap()
}

/// The look as it is compiled for objects that some lights do not reach.
fn compiled(look: &Look, live: Live, out: &[&str]) -> CompiledShader {
    let known =
        |id: &&str| LightInput::all_unlit().map(|input| (LightId::from(*id), input)).collect();
    let dark = out.iter().flat_map(|id| -> BTreeSet<_> { known(id) }).collect();
    let options = CompileOptions { dark, live, ..CompileOptions::default() };
    compile(look, Library::built_in(), &options).expect("a right look").value
}

const NODES: [&str; 3] = ["of_rim/others", "of_rim/own", "of_rim/blocker"];

#[test]
fn shadows_of_lights_that_reach_nothing_are_no_code() {
    for tier in ["exact", "balanced", "fast"] {
        let look = shaded(tier);
        for live in [Live::Keyed, Live::All] {
            let nodes_of_rim = |shader: &CompiledShader| {
                let removed = |path: &&str| {
                    let path = path.to_string();
                    shader
                        .removed
                        .iter()
                        .any(|one| one.path.to_string() == path && one.proof == Proof::NoLight)
                };
                NODES.iter().filter(|path| !removed(path)).count()
            };
            let shadowing = |shader: &CompiledShader| -> BTreeSet<String> {
                shader.host.shadowing_lights().map(ToString::to_string).collect()
            };
            let both = compiled(&look, live.clone(), &[]);
            assert_eq!(nodes_of_rim(&both), 3, "{tier}");
            assert_eq!(shadowing(&both), ["key", "rim"].map(String::from).into(), "{tier}");
            let of_key = compiled(&look, live.clone(), &["rim"]);
            assert_eq!(nodes_of_rim(&of_key), 0, "{tier}: {:?}\n{}", of_key.removed, of_key.wgsl);
            assert_eq!(shadowing(&of_key), ["key".to_owned()].into(), "{tier}");
            assert!(of_key.host.lights().all(|light| light.as_str() == "key"), "{tier}");
            let why = of_key.removed.iter().find(|one| one.path.to_string() == NODES[1]).unwrap();
            assert_eq!(why.reason, "nothing of the light `rim` arrives");
            // Nothing is left to read casters or maps for.
            let none = compiled(&look, live.clone(), &["key", "rim"]);
            assert!(!none.needs.casters() && !none.needs.shadow_maps(), "{tier}");
            assert!(!none.wgsl.contains("textureLoad"), "{tier}: {}", none.wgsl);
        }
    }
}
