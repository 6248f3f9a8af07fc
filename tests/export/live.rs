//! Exports in which every value of a look is a parameter.

use std::collections::BTreeSet;
use std::fs;

use crate::support::eval::{scene_of, shape};
use crate::support::root;
use chiaro::document::{Look, Value};
use chiaro::export::{ExportOptions, LANGUAGES, export};
use chiaro::frame::Assets;
use chiaro::ids::is_slug;
use chiaro::library::Library;
use serde_json::{Value as Json, json};

fn example(name: &str) -> Json {
    let path = root().join(format!("examples/looks/{name}.json"));
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).expect("JSON")
}

/// The look with every value exposed, and the warnings.
fn live(json: &Json) -> (Look, Vec<String>) {
    let loaded = Look::read(&json.to_string(), "a.json");
    let mut look = loaded.value.unwrap_or_else(|| panic!("{:?}", loaded.diagnostics));
    let options = ExportOptions { is_live: true, ..ExportOptions::default() };
    let told = options.apply(&mut look, &mut Library::built_in().clone(), false);
    let told = told.unwrap_or_else(|problems| panic!("{problems:?}"));
    (look, told.iter().map(ToString::to_string).collect())
}

fn names(look: &Look) -> BTreeSet<String> {
    look.exposed.iter().map(|exposed| exposed.name.to_string()).collect()
}

/// The description of a look in WGSL.
fn described(look: &Look) -> Json {
    let place = (root(), &mut Assets::default());
    let exported = export(look, Library::built_in(), "a", &LANGUAGES[..1], place);
    let files = exported.unwrap_or_else(|problems| panic!("{problems:?}")).value;
    let file = files.iter().find(|file| file.name == "a.json").expect("a description");
    serde_json::from_slice(&file.bytes).expect("JSON")
}

fn list(json: &Json) -> &[Json] {
    json.as_array().map_or(&[], Vec::as_slice)
}

/// Every parameter has a name of its own, a group and a label, and changes the picture.
#[test]
fn every_value_is_a_parameter_with_a_name_and_a_group() {
    for name in ["figure1-layers", "anime-face", "clay", "figure6-comics"] {
        let document = example(name);
        let before = list(&document["exposed"]).to_vec();
        let (look, told) = live(&document);
        assert!(told.is_empty(), "{name}: {told:?}");
        let described = described(&look);
        let parameters = list(&described["parameters"]);
        let mut seen = BTreeSet::new();
        for (index, parameter) in parameters.iter().enumerate() {
            let own = parameter["name"].as_str().unwrap_or_else(|| panic!("{name}: {parameter}"));
            assert!(is_slug(own) && seen.insert(own), "{name}: {own}");
            assert!(parameter["group"].as_str().is_some_and(|text| !text.is_empty()), "{own}");
            assert!(parameter["label"].as_str().is_some_and(|text| !text.is_empty()), "{own}");
            assert!(index < before.len() || parameter["live"] == json!(true), "{name}: {own}");
        }
        // Values that the artist exposed keep their names and their places.
        let kept: Vec<&Json> = parameters[..before.len()].iter().map(|p| &p["name"]).collect();
        assert_eq!(kept, before.iter().map(|exposed| &exposed["name"]).collect::<Vec<_>>());
        assert!(parameters.len() > before.len() + 10, "{name}: {} values", parameters.len());
    }
    let described = described(&live(&example("figure1-layers")).0);
    let mut parameters = list(&described["parameters"]).iter();
    let offset = parameters.find(|parameter| parameter["name"] == "diffuse_offset");
    let offset = offset.expect("the offset of the layer Diffuse");
    assert_eq!(offset["group"], "Diffuse");
    // Groups stand in the document's order, each in one piece.
    let mut groups: Vec<&str> =
        list(&described["parameters"]).iter().filter_map(|p| p["group"].as_str()).collect();
    groups.dedup();
    assert_eq!(groups, ["Base", "Fill", "Diffuse", "Specular", "Back-light", "Output"]);
    assert_eq!(offset["target"], "diffuse.offset");
    assert_eq!(offset["default"], 0.05);
    assert!(offset["max"].as_f64().is_some_and(|max| max > 3.0), "{offset}");
}

/// Changes every number of a JSON value a little.
fn shaken(value: &mut Json) {
    match value {
        Json::Number(number) => {
            let number = number.as_f64().unwrap_or_default();
            *value = json!(0.9 * number + 0.003);
        }
        Json::Array(parts) => parts.iter_mut().for_each(shaken),
        Json::Object(parts) => parts.values_mut().for_each(shaken),
        _ => {}
    }
}

#[test]
fn names_stay_when_values_change_and_nodes_are_added() {
    for name in ["figure1-layers", "anime-face", "halftone-comic"] {
        let mut document = example(name);
        let before = names(&live(&document).0);
        for node in document["nodes"].as_array_mut().expect("nodes") {
            node.get_mut("values").into_iter().for_each(shaken);
        }
        assert_eq!(names(&live(&document).0), before, "{name}: other values");
    }
    // One more layer of the same name lies over the others.
    let mut document = example("figure1-layers");
    let before = names(&live(&document).0);
    let mut layer = document["nodes"][2].clone();
    assert_eq!(layer["name"], "Diffuse");
    layer["id"] = json!("warm");
    layer["values"]["slope"] = json!(0.4);
    document["nodes"].as_array_mut().expect("nodes").push(layer);
    let wires = document["wires"].as_array_mut().expect("wires");
    wires.last_mut().expect("a wire")["to"] = json!("warm.below");
    wires.push(json!({"from": "warm.below", "to": "output.color"}));
    let after = names(&live(&document).0);
    let lost: Vec<_> = before.difference(&after).collect();
    assert!(lost.is_empty(), "{lost:?}");
    assert!(after.contains("warm_offset") && after.contains("diffuse_offset"), "{after:?}");
}

/// A parameter that is set changes the members of the uniform that say so, and the picture, as the
/// same change of the document does.
#[cfg(feature = "gpu")]
#[test]
fn a_parameter_does_what_its_value_in_the_document_does() {
    use crate::support::eval::look as read;
    use crate::support::front::{drawn, from_front, planned};
    use chiaro::reference::Reference;

    let rows = [
        ("diffuse_cutoff", 2, "cutoff", json!(2.6)),
        ("fill_convex", 1, "convex", json!([0.4, 0.1, 0.2, 1.0])),
        ("specular_convex", 3, "convex", json!([0.1, 0.2, 1.0, 1.0])),
    ];
    for (name, node, port, new) in rows {
        let document = example("figure1-layers");
        let (look, _) = live(&document);
        let mut changed = look.clone();
        let node = changed.graph.nodes.values_mut().nth(node).expect("a node");
        let value: Value = serde_json::from_value(new).expect("a value");
        node.values.insert(port.into(), value.clone());

        let (before, after) = (described(&look), described(&changed));
        let index = list(&before["parameters"]).iter().position(|p| p["name"] == name);
        let index = index.unwrap_or_else(|| panic!("no {name}"));
        let members = |of: &Json| {
            let modules = list(&of["modules"]);
            let draw = modules.iter().find(|module| module["name"] == "draw").expect("a module");
            list(&draw["host"]["members"]).to_vec()
        };
        let mut moved = 0;
        for (old, new) in members(&before).iter().zip(&members(&after)) {
            assert_eq!(old["name"], new["name"]);
            let is_named = list(&old["parameters"]).contains(&json!(index));
            assert!(is_named || old["default"] == new["default"], "{name}: {old}, {new}");
            moved += usize::from(old["default"] != new["default"]);
        }
        assert!(moved > 0, "{name} moves no member");

        let picture = |look: Look, value: Option<Value>| {
            let setup = read(&document);
            let worn = chiaro::frame::SetupLook { look, ..setup };
            let (mesh, fitted) = shape("sphere");
            let mut setup = scene_of(vec![(worn, mesh, fitted)], from_front());
            let values = &mut setup.objects[0].values;
            values.extend(value.map(|value| (name.into(), value)));
            drawn(&mut Reference::default(), &planned(&setup, 1)).rgba
        };
        let apart = |a: &[[f32; 4]], b: &[[f32; 4]]| {
            let pairs = a.iter().flatten().zip(b.iter().flatten());
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
        };
        let (still, by_document) = (picture(look.clone(), None), picture(changed, None));
        let by_parameter = picture(look, Some(value));
        assert!(apart(&still, &by_document) > 0.02, "{name} changes nothing");
        let apart = apart(&by_parameter, &by_document);
        assert!(apart < 1e-5, "{name}: {apart}");
    }
}

/// Values that find no room in the uniform are left out and told.
#[test]
fn a_look_with_too_many_values_says_what_is_left_out() {
    let (mut nodes, mut wires) = (vec![json!({"id": "facing", "kind": "facing"})], Vec::new());
    let mut below = "facing".to_owned();
    // A mix has a color and a number: more than a thousand of them have no room in 16 KiB.
    for index in 0..1100 {
        let id = format!("tint_{index}");
        let color = [0.5, 0.25, f64::from(index) / 2000.0];
        let values = json!({"b": color, "factor": 0.01 + 0.0001 * f64::from(index)});
        nodes.push(json!({"id": id, "kind": "mix_colors", "values": values}));
        wires.push(json!({"from": below, "to": format!("{id}.a")}));
        below = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": below, "to": "output.color"}));
    let (look, told) = live(&json!({"nodes": nodes, "wires": wires}));
    let [told] = told.as_slice() else { panic!("{told:?}") };
    assert!(told.contains("16 KiB") && told.contains(" more"), "{told}");
    assert!(look.exposed.len() > 1000, "{} values", look.exposed.len());
    let described = described(&look);
    let draw = list(&described["modules"]).last().expect("a module");
    let size = |binding: &Json| binding["size"].as_u64().unwrap_or_default();
    let largest = list(&draw["bindings"]).iter().map(size).max().unwrap_or_default();
    assert!(largest > 12 * 1024 && largest <= 16 * 1024, "{largest} bytes");
}
