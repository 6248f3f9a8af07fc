//! The examples embedded in the program are those of the source tree.

use std::collections::BTreeSet;
use std::path::Path;

use chiaro_compiler::document::Scene;
use chiaro_compiler::examples::{PREFIX, file, names};
use chiaro_language::ids::ObjectId;
use serde_json::Value as Json;

#[test]
fn every_example_is_there_as_it_lies_in_the_source() {
    let root = crate::support::root().join("examples");
    let mut found = BTreeSet::new();
    let folders = ["looks", "shadows", "hcbtf", "scenes", "images", "meshes", "shots"];
    for folder in folders.into_iter().chain(["shots/nightfall"]) {
        for entry in std::fs::read_dir(root.join(folder)).unwrap() {
            let entry = entry.unwrap();
            let name = format!("{folder}/{}", entry.file_name().to_str().unwrap());
            if entry.file_type().unwrap().is_dir() {
                assert_eq!(name, "shots/nightfall", "a folder of its own is walked, too");
                continue;
            }
            let path = Path::new("somewhere/else").join(format!("{PREFIX}{name}"));
            assert_eq!(file(&path).unwrap(), std::fs::read(root.join(&name)).unwrap(), "{name}");
            found.insert(name);
        }
    }
    assert_eq!(found, names().map(str::to_owned).collect());
}

/// The three acts of the lit room are one scene: nothing but what they are called and the masters
/// of its groups of lights differs.
#[test]
fn the_acts_of_the_lit_room_differ_by_the_mixer_alone() {
    let scenes = ["day", "dusk", "night"].map(|act| {
        let path = format!("examples/scenes/lit-room-{act}.json");
        let text = std::fs::read_to_string(crate::support::root().join(path)).unwrap();
        let mut scene: Json = serde_json::from_str(&text).unwrap();
        let fields = scene.as_object_mut().unwrap();
        let masters = fields.remove("light_groups").unwrap();
        for told in ["name", "about"] {
            fields.remove(told).unwrap();
        }
        (scene, masters)
    });
    let [(day, bright), (dusk, red), (night, dark)] = &scenes;
    assert!(day == dusk && dusk == night, "the acts are scenes of their own");
    assert!(bright != red && red != dark && dark != bright, "two acts are one");
}

/// All that a head is made of casts its shadow on neck and scarf at least, and nothing of it on a
/// face: that is painted.
#[test]
fn hair_casts_nothing_on_the_face() {
    let path = crate::support::root().join("examples/scenes/face-map.json");
    let scene = Scene::load(&crate::support::chiaro_files::Disk, &path).value.unwrap();
    for (id, object) in &scene.objects {
        let (figure, _) = id.as_str().split_once('-').unwrap();
        let onto = object.shadow_link().objects(&scene.objects);
        let falls = |part: &str| onto.contains(&ObjectId::new(format!("{figure}-{part}")));
        assert!(falls("neck") && falls("scarf"), "{id}: {onto:?}");
        assert!(onto.iter().all(|onto| !onto.as_str().ends_with("-head")), "{id}: {onto:?}");
    }
}
