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
         rim   spot; groups rim; of the scene; no look has a light of this id\n\
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
