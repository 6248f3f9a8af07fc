//! Parts that are saved, read, put into other looks, and told about.

use std::path::Path;
use std::sync::Arc;

use super::placing::{self, Recipient};
use super::saving::{PartChoice, PartDraft, PartSource, save};
use super::{FoundParts, Part, PartKind, PartsReader, shipped};
use crate::catalog::Catalog;
use crate::document::{Endpoint, GraphId, Look, Value};
use crate::files::Disk;
use crate::ids::NodeId;
use crate::library::Library;
use crate::state::stack::Stack;
use crate::state::stack::tree::LayerTree;
use crate::state::worker::BackgroundJobs as _;

/// Look with a layer that is masked and lit by a group of its own.
const FROM: &str = r##"{"name": "From", "lights": {"key": {"name": "Sun"}, "back": {}}, "nodes": [
    {"id": "base", "kind": "base"},
    {"id": "picture", "kind": "image", "values": {"image": "stroke.png"}, "at": [-200, 300]},
    {"id": "tint", "kind": "tinted", "at": [100, 300]},
    {"id": "rim", "kind": "light_layer", "name": "Rim", "values": {"light": "back"},
      "at": [300, 0]},
    {"id": "over", "kind": "light_layer", "values": {"light": "key"}, "at": [600, 0]},
    {"id": "output", "kind": "output", "at": [900, 0]}],
  "wires": [{"from": "base", "to": "rim.below"}, {"from": "picture", "to": "tint.color"},
    {"from": "tint", "to": "rim.convex"}, {"from": "rim", "to": "over.below"},
    {"from": "over", "to": "output.color"}],
  "time_keys": [{"target": "rim.opacity", "keys": [{"time": 0, "value": 1}]}],
  "definitions": {"tinted": {"label": "Tinted", "inputs": [{"name": "color"}],
    "outputs": [{"name": "color"}], "nodes": [{"id": "gamma", "kind": "gamma"}],
    "wires": [{"from": "inputs.color", "to": "gamma.color"},
      {"from": "gamma", "to": "outputs.color"}]}}}"##;

/// Look of another artist, with a layer of the same name and another group of the same id.
const TO: &str = r##"{"name": "To", "lights": {"key": {"name": "Lamp"}}, "nodes": [
    {"id": "base", "kind": "base"},
    {"id": "rim", "kind": "light_layer", "name": "Rim", "values": {"light": "key"}, "at": [260, 0]},
    {"id": "top", "kind": "light_layer", "values": {"light": "key"}, "at": [520, 0]},
    {"id": "output", "kind": "output", "at": [780, 0]}],
  "wires": [{"from": "base", "to": "rim.below"}, {"from": "rim", "to": "top.below"},
    {"from": "top", "to": "output.color"}],
  "definitions": {"tinted": {"label": "Another", "outputs": [{"name": "color"}],
    "nodes": [{"id": "red", "kind": "color_value"}],
    "wires": [{"from": "red", "to": "outputs.color"}]}}}"##;

pub(super) fn read(text: &str) -> (Look, Catalog) {
    let loaded = Look::read(text, "test");
    assert!(!loaded.has_errors(), "{:?}", loaded.diagnostics);
    let look = loaded.value.unwrap();
    let catalog = synced(&look);
    (look, catalog)
}

fn synced(look: &Look) -> Catalog {
    let mut catalog = Catalog::new(Library::built_in());
    catalog.sync(look, Library::built_in());
    catalog
}

pub(super) fn draft(look: &Look, choice: &PartChoice) -> Result<PartDraft, String> {
    let catalog = synced(look);
    PartSource { look, graph: &look.graph, catalog: &catalog }.draft(choice)
}

fn to<'a>(look: &'a Look, catalog: &'a Catalog) -> Recipient<'a> {
    Recipient { look, catalog, library: Library::built_in() }
}

fn order(look: &Look) -> Vec<String> {
    let layers = Stack::of(look, &synced(look)).layers;
    layers.iter().map(|layer| layer.id.to_string()).collect()
}

pub(super) fn found(folder: &Path) -> FoundParts {
    let reader = PartsReader::new(Arc::new(Disk), || {});
    reader.read(vec![folder.to_path_buf()]);
    reader.wait();
    reader.answer().unwrap().remove(0)
}

pub(super) fn look_of(part: &Part) -> &Look {
    &part.content.as_ref().unwrap().look
}

#[test]
fn a_layer_goes_from_one_look_to_another_through_the_library() {
    let home = tempfile::tempdir().unwrap();
    let (from, catalog) = read(FROM);
    let mut draft = draft(&from, &PartChoice::Layers(vec!["rim".into()])).unwrap();
    assert_eq!((draft.kind, draft.look.name.as_str()), (PartKind::Layer, "Rim"));
    assert_eq!(draft.notes, ["Keys stay with this look"], "what is below is no wire to lack");
    draft.look.tags = "edge cool".to_owned();
    let folder = home.path().join("library/mine");
    let (path, told) = save(&draft, &folder, Some(&home.path().join("looks")), &catalog).unwrap();
    assert!(
        told.contains("linked, not copied: stroke.png") && path.ends_with("rim.json"),
        "{told}"
    );
    let (again, told) = save(&draft, &folder, None, &catalog).unwrap();
    assert!(again.ends_with("rim_2.json") && told.contains("rim.json was there already"), "{told}");

    let parts = found(&home.path().join("library")).parts;
    let part = parts.iter().find(|part| part.path == path).unwrap();
    assert_eq!((part.name.as_str(), part.tags.as_str(), parts.len()), ("Rim", "edge cool", 2));
    let image = |look: &Look| look.graph.nodes["picture"].values["image"].clone();
    assert_eq!(image(look_of(part)), Value::Text("../../looks/stroke.png".to_owned()));
    assert_eq!(PartKind::of(look_of(part), &synced(look_of(part))), Some(PartKind::Layer));
    assert!(placing::shown(look_of(part), PartKind::Layer).is_some());

    let (mut look, catalog) = read(TO);
    let before = look.clone();
    let over: NodeId = "rim".into();
    let placed = placing::layer(to(&look, &catalog), ("Rim", look_of(part)), Some(&over)).unwrap();
    let inverse = look.apply(placed.edit).unwrap();
    assert_eq!(order(&look), ["top", "rim_2", "rim"]);
    assert_eq!(look.graph.nodes["rim_2"].name, "Rim 2", "no two layers have one name");
    assert!(look.graph.wire_into(&"rim_2".into(), &"convex".into()).is_some());
    assert_eq!(look.graph.nodes["tint"].kind, "tinted_2");
    assert_eq!(look.definitions["tinted"].label, "Another", "the look's own group stays");
    for words in [
        "\"Rim\" is copied into this look, over Rim",
        "with its own light back",
        "under another name, as this look has another one, Tinted",
    ] {
        assert!(placed.told.contains(words), "{words}: {}", placed.told);
    }
    let x = |id: &str| look.graph.nodes[id].position[0];
    assert!(x("rim") < x("picture") && x("rim_2") < x("top") && x("top") < x("output"));
    look.apply(inverse).unwrap();
    assert_eq!(look, before, "one step of undo");

    // Where no layer is named it lies on top; a look without a stack of any kind says why not.
    let placed = placing::layer(to(&look, &catalog), ("Silver edge", look_of(part)), None).unwrap();
    look.apply(placed.edit).unwrap();
    assert_eq!(order(&look), ["rim_2", "top", "rim"]);
    assert_eq!(look.graph.nodes["rim_2"].name, "Silver edge", "one layer has the part's name");
    let (bare, catalog) = read("{}");
    assert!(placing::layer(to(&bare, &catalog), ("Rim", look_of(part)), None).is_err());
}

/// A layer that was fitted to painted light has a node beside it, which would lie half over it.
#[test]
fn what_helps_a_layer_does_not_cover_it() {
    let (mut look, catalog) = read(
        r#"{"nodes": [{"id": "base", "kind": "base", "at": [0, 0]},
          {"id": "output", "kind": "output", "at": [260, 0]}],
        "wires": [{"from": "base", "to": "output.color"}]}"#,
    );
    let part = Look::read(
        r#"{"nodes": [
          {"id": "ear", "kind": "light_layer", "at": [520, 0]},
          {"id": "place", "kind": "nearby", "at": [390, 260]}],
        "wires": [{"from": "place.weight", "to": "ear.opacity"}]}"#,
        "test",
    );
    let placed = placing::layer(to(&look, &catalog), ("Ear", &part.value.unwrap()), None).unwrap();
    look.apply(placed.edit).unwrap();
    let catalog = synced(&look);
    let boxes: Vec<_> = look
        .graph
        .nodes
        .values()
        .map(|node| crate::state::arrangement::box_of(node, catalog.of(node).map(|kind| &**kind)))
        .collect();
    for (index, one) in boxes.iter().enumerate() {
        for other in &boxes[index + 1..] {
            assert!(!one.overlaps(other), "{one:?} and {other:?}");
        }
    }
    assert_eq!(look.graph.nodes["ear"].position[1], 0.0, "the layer is on the stack's level");
}

/// Layers in a pass-through folder lie on what is below the folder, and so on a new layer there.
#[test]
fn a_layer_is_laid_under_a_folder_and_into_one() {
    let (mut look, catalog) = read(TO);
    let tree = LayerTree::of(&look, &catalog);
    let (folder, edit) = tree.group(&look, &["top".into()]).unwrap();
    look.apply(edit).unwrap();
    let part = shipped().iter().find(|part| part.name == "Cel shadow").unwrap();
    let part = ("Cel shadow", look_of(part));
    for (over, own, source) in [
        ("rim", vec![folder.as_str(), "cel_shadow", "rim"], "cel_shadow"),
        ("top", vec![folder.as_str(), "rim"], "rim"),
    ] {
        let mut look = look.clone();
        let placed = placing::layer(to(&look, &catalog), part, Some(&over.into())).unwrap();
        look.apply(placed.edit).unwrap();
        assert_eq!(order(&look), own, "over {over}");
        let below = |id: &str| look.graph.wire_into(&id.into(), &"below".into()).unwrap();
        assert_eq!(below("top").from.node.as_str(), source, "over {over}");
        assert_eq!(below(folder.as_str()).from.node.as_str(), source, "over {over}");
    }
}

#[test]
fn a_part_goes_into_a_wire_that_it_fits() {
    let (mut look, catalog) = read(TO);
    let wire = look.graph.wires[1].clone();
    let part = shipped().iter().find(|part| part.name == "Cel shadow").unwrap();
    let placed =
        placing::in_wire(to(&look, &catalog), ("Cel shadow", look_of(part)), &wire).unwrap();
    assert!(placed.told.contains("between Rim and"), "{}", placed.told);
    look.apply(placed.edit).unwrap();
    assert_eq!(order(&look), ["top", "cel_shadow", "rim"]);
    let ramp = shipped().iter().find(|part| part.name == "Dusk").unwrap();
    let told = placing::in_wire(to(&look, &catalog), ("Dusk", look_of(ramp)), &wire).unwrap_err();
    assert!(told.contains("does not fit"), "{told}");
    let at = [400.0, 500.0];
    let placed = placing::nodes(to(&look, &catalog), &GraphId::Look, ("Dusk", look_of(ramp)), at);
    look.apply(placed.unwrap().edit).unwrap();
    assert_eq!(look.graph.nodes["dusk"].position, at);
}

#[test]
fn groups_lights_profiles_and_ramps_are_parts() {
    let (mut look, catalog) = read(FROM);
    let group = draft(&look, &PartChoice::Group("tinted".into())).unwrap();
    assert_eq!((group.kind, group.look.definitions.len()), (PartKind::Group, 1));
    let other = read(TO).0;
    let part = ("Tinted", &group.look);
    let placed =
        placing::nodes(to(&other, &synced(&other)), &GraphId::Look, part, [0.0; 2]).unwrap();
    let mut other = other;
    other.apply(placed.edit).unwrap();
    assert_eq!(other.graph.nodes.last().unwrap().1.kind, "tinted_2");

    let rig = draft(&look, &PartChoice::Lights).unwrap();
    assert_eq!((rig.kind, rig.look.lights.len()), (PartKind::Lights, 2));
    let told = placing::lights(&look, ("Rig", &rig.look)).unwrap_err();
    assert!(told.contains("already"), "{told}");
    let mut other = read(TO).0;
    let placed = placing::lights(&other, ("Rig", &rig.look)).unwrap();
    assert!(placed.told.contains("set anew: Sun · added: back"), "{}", placed.told);
    other.apply(placed.edit).unwrap();
    assert_eq!(other.lights, look.lights);

    let profile = draft(&look, &PartChoice::Profile("over".into())).unwrap();
    assert_eq!((profile.kind, profile.look.graph.nodes.len()), (PartKind::Profile, 1));
    let tight = shipped().iter().find(|part| part.name == "Tight glint").unwrap();
    let layer = &look.graph.nodes["over"];
    let values = placing::values(to(&look, &catalog), layer, look_of(tight), None);
    assert_eq!(values.len(), 3);
    let base = &look.graph.nodes["base"];
    assert!(placing::values(to(&look, &catalog), base, look_of(tight), None).is_empty());
    assert!(draft(&look, &PartChoice::Profile("base".into())).is_err());

    let dusk = shipped().iter().find(|part| part.name == "Dusk").unwrap();
    look.graph.nodes.extend(look_of(dusk).graph.nodes.clone());
    let ramp = draft(&look, &PartChoice::Ramp("dusk".into(), "ramp".into())).unwrap();
    assert_eq!((ramp.kind, ramp.look.name.as_str()), (PartKind::Ramp, "Dusk"));
    let whole = draft(&look, &PartChoice::Look).unwrap();
    assert_eq!((whole.kind, whole.look.graph.nodes.len()), (PartKind::Look, 7));
    assert!(draft(&look, &PartChoice::Nodes(vec!["output".into()])).is_err(), "not a part");
}

#[test]
fn damaged_and_huge_files_say_so_and_others_are_there() {
    let home = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &[u8]| std::fs::write(home.path().join(name), text).unwrap();
    write("broken.json", b"{\"nodes\": [");
    write("binary.json", &[0xff, 0x00, 0x80, 0x01]);
    write("empty.json", b"{}");
    write("good.json", FROM.as_bytes());
    write("notes.txt", b"no part");
    write("scene.json", br#"{"chiaro": "scene", "objects": []}"#);
    write(
        "ring.json",
        br#"{"nodes": [{"id": "a", "kind": "blend"}, {"id": "b", "kind": "blend"}],
        "wires": [{"from": "a", "to": "b.below"}, {"from": "b", "to": "a.below"}]}"#,
    );
    let huge = std::fs::File::create(home.path().join("huge.json")).unwrap();
    huge.set_len(1 << 32).unwrap();
    std::fs::create_dir(home.path().join(".hidden")).unwrap();
    write(".hidden/other.json", FROM.as_bytes());
    let found = found(home.path());
    assert_eq!(found.lacking, None);
    let content = |name: &str| {
        let part = found.parts.iter().find(|part| part.path.ends_with(name)).unwrap();
        part.content.as_ref().map(|content| content.kind).map_err(String::as_str)
    };
    assert_eq!(
        (content("good.json"), content("ring.json")),
        (Ok(PartKind::Look), Ok(PartKind::Nodes))
    );
    assert!(content("huge.json").unwrap_err().contains("larger than 4 MiB"));
    assert!(content("scene.json").unwrap_err().contains("scene"));
    assert!(content("empty.json").unwrap_err().contains("nothing in it"));
    for name in ["broken.json", "binary.json"] {
        assert!(content(name).unwrap_err().len() > 10, "{name}");
    }
    assert_eq!(found.parts.len(), 7, "hidden folders and other files are no parts");
    let missing = super::tests::found(&home.path().join("none"));
    assert!(missing.parts.is_empty() && missing.lacking.is_none());
    assert!(found.is_there && !missing.is_there, "an empty folder is there");
}

#[test]
fn what_is_shipped_is_sound_and_can_be_seen() {
    assert_eq!(shipped().len(), 9);
    for part in shipped() {
        let content = part.content.as_ref().unwrap();
        assert!(!part.tags.is_empty() && !part.about.is_empty() && part.is_shipped());
        let is_seen = placing::shown(&content.look, content.kind).is_some();
        assert_eq!(is_seen, content.kind != PartKind::Ramp, "{}", part.name);
        for node in content.look.graph.nodes.values() {
            let kind = synced(&content.look).of(node).cloned().unwrap();
            assert!(!kind.is_missing, "{}", part.name);
            assert!(
                node.values.keys().all(|port| kind.input(port.as_str()).is_some()),
                "{}",
                part.name
            );
        }
        for wire in &content.look.graph.wires {
            let has = |end: &Endpoint| content.look.graph.nodes.contains_key(&end.node);
            assert!(has(&wire.from) && has(&wire.to), "{}", part.name);
        }
    }
}

#[test]
fn pasted_nodes_bring_the_light_that_does_other_work_than_the_looks_own() {
    let text = |direction: &str| {
        format!(
            r#"{{"lights": {{"back": {{"direction": {direction}}}}}, "nodes": [
              {{"id": "rim", "kind": "light_layer", "values": {{"light": "back"}}}}]}}"#
        )
    };
    let (look, catalog) = read(&text("[0.8, 0.4, -0.5]"));
    let to = Recipient { look: &look, catalog: &catalog, library: Library::built_in() };
    let paste = |text: &str| {
        let (pasted, told) = placing::of_text(to, &GraphId::Look, text, None).unwrap();
        let mut after = look.clone();
        after.apply(pasted.edit).unwrap();
        (after.lights.len(), after.graph.nodes["rim_2"].values["light"].clone(), told)
    };
    let here = paste(&text("[0.8, 0.4, -0.5]"));
    assert_eq!(here, (1, Value::Text("back".to_owned()), String::new()), "in its own look");
    let (count, light, told) = paste(&text("[-0.9, 0.1, -0.3]"));
    assert_eq!((count, light), (2, Value::Text("back_2".to_owned())));
    assert_eq!(told, "Pasted · with its own light back_2");
    assert!(placing::of_text(to, &GraphId::Look, "some words", None).is_err());
}

#[test]
fn pasted_nodes_without_places_do_not_lie_on_one_another() {
    let (look, catalog) = read(r#"{"nodes": [{"id": "end", "kind": "output"}]}"#);
    let to = Recipient { look: &look, catalog: &catalog, library: Library::built_in() };
    let places = |text: &str| {
        let (pasted, _) = placing::of_text(to, &GraphId::Look, text, Some([0.0; 2])).unwrap();
        let mut after = look.clone();
        after.apply(pasted.edit).unwrap();
        ["base", "over"].map(|id| after.graph.nodes[id].position)
    };
    let nodes = r#""nodes": [{"id": "base", "kind": "base"}, {"id": "over", "kind": "blend"}],
        "wires": [{"from": "base", "to": "over.below"}]"#;
    for lights in ["", r#""lights": {"key": {"direction": [0, 0, 1]}},"#] {
        let [base, over] = places(&format!("{{{lights} {nodes}}}"));
        assert!(base[0] + 184.0 < over[0], "{base:?} {over:?}");
    }
}
