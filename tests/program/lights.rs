//! `chiaro lights`: the lights of a scene, and which of them reach which objects.

use std::process::{Command, Output};

use serde_json::{Value as Json, json};

use crate::support::root;

fn lights(scene: &Json, arguments: &[&str]) -> Output {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.json");
    std::fs::write(&path, scene.to_string()).unwrap();
    Command::new(env!("CARGO_BIN_EXE_chiaro"))
        .arg("lights")
        .arg(&path)
        .args(arguments)
        .env("CHIARO_CACHE_DIR", "")
        .output()
        .unwrap()
}

fn scene(hero: &str, floor: &str) -> Json {
    // Figure 1 has a `key` and a `back` light.
    let look = root().join("examples/looks/figure1-layers.json");
    json!({
        "chiaro": "scene", "version": 1,
        "objects": [
            {"id": "hero", "mesh": "shape:ball", "looks": look, "linked": hero},
            {"id": "floor", "mesh": "shape:plane", "looks": look, "unlinked": floor}],
        "lights": {
            "key": {"name": "Key light", "groups": ["set", "sun"]},
            "rim": {"type": "spot", "groups": ["rim"]}}
    })
}

#[test]
fn lights_are_listed_with_their_groups_and_owners() {
    let told = lights(&scene("*", ""), &[]);
    assert!(told.status.success());
    assert_eq!(
        String::from_utf8(told.stdout).unwrap(),
        "key   directional; \"Key light\"; groups set, sun; of the scene\n\
         rim   spot; groups rim; of the scene\n\
         back  directional; of the look Layers\n"
    );
}

#[test]
fn the_matrix_tells_the_rule_that_decides() {
    let scene = scene("key | group:rim - group:set", "{source} - back");
    let told = lights(&scene, &["--matrix"]);
    assert!(told.status.success());
    assert_eq!(
        String::from_utf8(told.stdout).unwrap(),
        "       key  rim  back\n\
         hero    -    x    -\n\
         floor   -    -    x\n\
         \n\
         x: it reaches the object; -: it does not; nothing: no look of the object has it\n\
         \n\
         key does not reach hero: `linked` (`key | group:rim - group:set`) has it not\n\
         back does not reach hero: `linked` (`key | group:rim - group:set`) has it not\n\
         key does not reach floor: `unlinked` (`{source} - back`) has it\n\
         rim does not reach floor: `unlinked` (`{source} - back`) has it\n"
    );
    let told = lights(&scene, &["--matrix", "--json"]);
    let told: Json = serde_json::from_slice(&told.stdout).unwrap();
    assert_eq!(told["lights"][1]["groups"], json!(["rim"]));
    assert_eq!(
        told["matrix"][1],
        json!({"object": "hero", "light": "rim", "reaches": true,
            "rule": "`linked` (`key | group:rim - group:set`) has it"})
    );
    assert_eq!(told["matrix"].as_array().unwrap().len(), 6);
}

/// A look whose back-light is kept from one layer, and whose key light passes by a filter.
#[test]
fn the_matrix_tells_layers_filters_and_shadows() {
    let folder = tempfile::tempdir().unwrap();
    let look = json!({"chiaro": "look", "version": 1, "name": "Drawn",
        "lights": {"key": {"groups": ["set"]}, "back": {"direction": [0, 0, -1]}},
        "definitions": {"tone": {
            "outputs": [{"name": "angle"}],
            "nodes": [{"id": "lamp", "kind": "light", "values": {"light": "key"}},
                {"id": "angle", "kind": "parametrization"},
                {"id": "glass", "kind": "light_filter", "filtered": "* - group:set"}],
            "wires": [{"from": "lamp", "to": "angle.light"}, {"from": "lamp", "to": "glass.light"},
                {"from": "angle", "to": "glass.angle"}, {"from": "glass.angle",
                    "to": "outputs.angle"}]}},
        "nodes": [
            {"id": "wash", "kind": "light_layer", "values": {"light": "back"},
                "unlayered": "back"},
            {"id": "line", "kind": "light_layer", "values": {"light": "back"}},
            {"id": "tone", "kind": "tone"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "wash", "to": "line.below"}, {"from": "line", "to": "output.color"}]});
    let path = folder.path().join("drawn.json");
    std::fs::write(&path, look.to_string()).unwrap();
    let object = |id: &str, more: Json| {
        let mut object = json!({"id": id, "mesh": "shape:ball", "looks": path});
        object.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        object
    };
    let scene = json!({"chiaro": "scene", "version": 1, "objects": [
        object("face", json!({})),
        object("hair", json!({"unshadowed": "back", "no_shadows_on": "face | hair",
            "unlinked": "back",
            "layers": [{"node": "wash", "layered": "{source} | back"}]}))]});
    let told = lights(&scene, &["--matrix"]);
    let (text, said) = (String::from_utf8(told.stdout), String::from_utf8(told.stderr).unwrap());
    assert!(told.status.success(), "{said}");
    assert_eq!(
        text.unwrap(),
        "      key  back\n\
         face   x    ~\n\
         hair   x    -\n\
         \n\
         x: it reaches the object; -: it does not; nothing: no look of the object has it\n\
         ~: it reaches the object, and not all nodes that are about it\n\
         \n\
         back does not reach hair: `unlinked` (`back`) has it\n\
         back does not reach wash of face: `unlayered` (`back`) has it\n\
         key passes by tone/glass of face, hair: `filtered` (`* - group:set`) has it not\n\
         hair casts no shadow of key onto face, itself: `no_shadows_on` (`face | hair`) has it\n\
         hair casts no shadow of back onto face: `unshadowed` (`back`) has it\n"
    );
    let told = lights(&scene, &["--matrix", "--json"]);
    let told: Json = serde_json::from_slice(&told.stdout).unwrap();
    let layers = told["layers"].as_array().unwrap();
    assert!(layers.contains(&json!({"object": "face", "look": "Drawn", "node": "line",
        "light": "back", "relation": "layered", "reaches": true,
        "rule": "`layered` (`*`) has it"})));
    // A lone light of a scene that reaches no object reaches no layer of it either.
    let of_hair = |layer: &&Json| layer["object"] == "hair" && layer["light"] == "back";
    let of_hair: Vec<&Json> = layers.iter().filter(of_hair).collect();
    assert!(of_hair.len() == 2 && of_hair.iter().all(|layer| layer["reaches"] == false));
    let shadows = told["shadows"].as_array().unwrap();
    assert_eq!(shadows.len(), 2 * 2 * 2);
    assert!(shadows.contains(&json!({"light": "key", "caster": "face", "onto": "hair",
        "falls": true, "rule": "`shadowed` (`*`) has it"})));
    assert!(shadows.contains(&json!({"light": "back", "caster": "face", "onto": "hair",
        "falls": false,
        "rule": "the light does not reach it: `unlinked` (`back`) has it"})));
}

#[test]
fn what_lights_are_aimed_at_and_rows_of_nodes_name_is_told_where_it_is_missing() {
    let mut scene = scene("*", "");
    scene["lights"]["rim"]["aimed_at"] = json!("heroe");
    scene["lights"]["bulb"] = json!({"type": "point", "aimed_at": "hero"});
    scene["objects"][0]["layers"] = json!([{"node": "difuse", "layered": "kez"}]);
    let told = lights(&scene, &["--matrix"]);
    let said = String::from_utf8(told.stderr).unwrap();
    assert!(told.status.success(), "{said}");
    for words in [
        "warning[unknown-object]: the light `rim` is aimed at the object `heroe`, which there is",
        "did you mean `hero`?",
        "(at lights.rim.aimed_at)",
        "warning[idle-aim]: the point light `bulb` shines everywhere",
        "warning[unknown-node]: `layers` of object `hero` names the node `difuse`, which none",
        "did you mean `diffuse`?",
        "warning[unknown-light]: `layers[0].layered` of object `hero` names the light `kez`",
    ] {
        assert!(said.contains(words), "{words}\n{said}");
    }
}

#[test]
fn a_link_that_names_nothing_is_warned_about() {
    let told = lights(&scene("kez | group:rimm | \"Key lihgt\"", ""), &["--matrix"]);
    let said = String::from_utf8(told.stderr).unwrap();
    assert!(told.status.success());
    for words in [
        "warning[unknown-light]: `linked` of object `hero` names the light `kez`, which",
        "names the group of lights `rimm`, which there is not",
        "did you mean `rim`?",
        "names the light of the name `Key lihgt`, which there is not",
        "did you mean `Key light`?",
    ] {
        assert!(said.contains(words), "{words}\n{said}");
    }
    let told = lights(&scene("key | ", ""), &[]);
    assert_eq!(told.status.code(), Some(1));
    assert!(String::from_utf8(told.stderr).unwrap().contains("error[bad-light-set]"));
}

#[test]
fn mutes_and_solos_are_told_with_what_decides() {
    let mut scene = scene("*", "");
    scene["muted"] = json!("back | group:rim");
    let words = |scene: &Json| String::from_utf8(lights(scene, &["--matrix"]).stdout).unwrap();
    let told = words(&scene);
    let both = "rim does not reach hero, floor: `muted` (`back | group:rim`) has it\n";
    assert!(told.contains(both), "{told}");
    // A light that is soloed shines, muted or not.
    scene["soloed"] = json!("group:rim");
    let told = words(&scene);
    let both = "key does not reach hero, floor: `soloed` (`group:rim`) has it not\n";
    assert!(told.contains(both), "{told}");
    assert!(!told.contains("rim does not"), "{told}");
    scene["light_groups"] = json!({"rim": {"intensity": 0}, "rims": {"exposure": 1}});
    let told = lights(&scene, &["--matrix"]);
    let (table, said) = (String::from_utf8(told.stdout), String::from_utf8(told.stderr).unwrap());
    let both = "rim does not reach hero, floor: the master of its group `rim` is 0";
    assert!(table.unwrap().contains(both));
    for words in [
        "warning[unknown-light]: the scene has a master of the group `rims`, of which no light is",
        "did you mean `rim`?",
        "warning[soloed-lights]: `rim` is soloed, so that no other light shines",
        "(at soloed)",
    ] {
        assert!(said.contains(words), "{words}\n{said}");
    }
}

#[test]
fn a_solo_that_is_left_on_is_told_and_refused_by_the_strict() {
    let mut scene = scene("*", "");
    scene["soloed"] = json!("key");
    let folder = tempfile::tempdir().unwrap();
    let (path, picture) = (folder.path().join("scene.json"), folder.path().join("made.png"));
    let chiaro = |arguments: &[&str]| {
        let mut chiaro = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        chiaro.env("CHIARO_CACHE_DIR", "").args(arguments).output().unwrap()
    };
    let [path_text, picture_text] = [&path, &picture].map(|path| path.to_str().unwrap());
    let render = ["render", path_text, "-o", picture_text, "-s", "32x24"];
    let strict = [&render[..], &["--strict"]].concat();
    std::fs::write(&path, scene.to_string()).unwrap();
    let refused = chiaro(&strict);
    assert_eq!(refused.status.code(), Some(1));
    let said = String::from_utf8(refused.stderr).unwrap();
    assert!(said.contains("error[soloed-lights]: `key` is soloed"), "{said}");
    assert!(!picture.exists());
    assert_eq!(chiaro(&["check", path_text, "--strict"]).status.code(), Some(1));
    assert_eq!(chiaro(&["check", path_text]).status.code(), Some(0));
    let told = chiaro(&render);
    assert!(told.status.success() && picture.exists());
    assert!(String::from_utf8(told.stderr).unwrap().contains("warning[soloed-lights]"));
    scene["soloed"] = json!("");
    std::fs::write(&path, scene.to_string()).unwrap();
    let done = chiaro(&strict);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
}
