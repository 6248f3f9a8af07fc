//! Descriptions of exports, held against what a developer who has the folder alone would find.

use std::collections::BTreeSet;
use std::fs;

use crate::support::{files, root};
use chiaro::diag::Diagnostic;
use chiaro::document::{Look, Storage, Tier, Value};
use chiaro::export::{ExportFile, ExportOptions, LANGUAGES, export};
use chiaro::frame::Assets;
use chiaro::library::Library;
use serde_json::{Value as Json, json};

fn read(path: &str) -> Json {
    let text = fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The description of a look in WGSL.
fn described(look: &Json) -> Json {
    let loaded = Look::read(&look.to_string(), "a.json");
    let look = loaded.value.unwrap_or_else(|| panic!("{:?}", loaded.diagnostics));
    let place = (root(), &mut Assets::default());
    let exported = export(&look, Library::built_in(), "a", &LANGUAGES[..1], place);
    let files = exported.unwrap_or_else(|problems| panic!("{problems:?}")).value;
    let file = files.iter().find(|file| file.name == "a.json").expect("a description");
    serde_json::from_slice(&file.bytes).expect("JSON")
}

fn passes(described: &Json) -> &[Json] {
    described["passes"].as_array().expect("passes")
}

/// Keys among drivers have their place in `at`, keys by a direction in `direction`, as in the
/// documents that the looks were exported from.
#[test]
fn direction_keys_are_those_of_the_document() {
    for (name, place, other) in
        [("far-and-turned", "at", "direction"), ("figure5-directional", "direction", "at")]
    {
        let document = read(&format!("examples/looks/{name}.json"));
        let described = read(&format!("tests/golden/{name}/{name}.json"));
        let keys = |of: &Json| of["direction_keys"][0]["keys"].as_array().expect("keys").clone();
        let (wanted, found) = (keys(&document), keys(&described));
        assert_eq!(wanted.len(), found.len(), "{name}");
        for (wanted, found) in wanted.iter().zip(&found) {
            let numbers = |key: &Json| {
                let list = key[place].as_array().unwrap_or_else(|| panic!("{name}: {key}"));
                list.iter().map(|x| x.as_f64().expect("a number")).collect::<Vec<_>>()
            };
            assert_eq!(numbers(wanted), numbers(found), "{name}");
            assert!(found.get(other).is_none(), "{name}: {found}");
        }
    }
}

/// Every member of the camera's and the object's uniforms that any description names is read by a
/// shader of some example.
#[test]
fn nothing_is_described_that_no_shader_reads() {
    let (mut named, mut read_members) = (BTreeSet::new(), BTreeSet::new());
    for path in files::below(&root().join("tests/golden")) {
        let name = path.file_name().expect("a file").to_string_lossy().into_owned();
        let text = || fs::read_to_string(&path).expect("a golden file");
        if name.ends_with(".json") {
            let described: Json = serde_json::from_str(&text()).expect("JSON");
            for module in described["modules"].as_array().expect("modules") {
                for binding in module["bindings"].as_array().expect("bindings") {
                    let binding_name = binding["name"].as_str().expect("a name");
                    if !["view", "object"].contains(&binding_name) {
                        continue;
                    }
                    for member in binding["members"].as_array().into_iter().flatten() {
                        let member_name = member["name"].as_str().expect("a name");
                        named.insert(format!("{binding_name}.{member_name}"));
                    }
                }
            }
        } else if name.ends_with(".wgsl") {
            let text = text();
            let words = text.split(|c: char| !c.is_alphanumeric() && !"_.".contains(c));
            let places = words.filter_map(|word| {
                let mut parts = word.split('.');
                Some(format!("{}.{}", parts.next()?, parts.next()?))
            });
            read_members.extend(places);
        }
    }
    assert!(named.contains("view.clip_from_world"), "{named:?}");
    let unread: Vec<_> = named.difference(&read_members).collect();
    assert!(unread.is_empty(), "described, and read by nothing: {unread:?}");
}

/// A look that cuts parts of its surface away shows both sides, and its description says so.
#[test]
fn the_sides_to_draw_are_described() {
    let look = |output: Json, exposed: Json| {
        json!({
            "nodes": [{"id": "base", "kind": "base"}, output],
            "wires": [{"from": "base", "to": "output.color"}],
            "exposed": exposed
        })
    };
    let output = |values: Json| json!({"id": "output", "kind": "output", "values": values});
    let exposed = || {
        json!([
            {"name": "paint", "target": "base.color"}, {"name": "cut", "target": "output.cutoff"}
        ])
    };
    let rows = [
        (look(output(json!({})), json!([])), "front", json!(null)),
        (look(output(json!({"cutoff": 0.5})), json!([])), "both", json!(null)),
        (look(output(json!({"cutoff": 0})), exposed()), "front", json!(1)),
        (look(output(json!({"cutoff": 0.5})), exposed()), "both", json!(1)),
    ];
    for (look, sides, parameter) in rows {
        let described = described(&look);
        let draw = passes(&described).last().expect("a pass");
        assert_eq!(draw["sides"], json!(sides), "{look}");
        let found = draw.get("sides_parameter").cloned().unwrap_or_default();
        assert_eq!(found, parameter, "{look}");
        if let Some(index) = parameter.as_u64() {
            assert_eq!(described["parameters"][index as usize]["name"], "cut");
        }
    }
    let rich = described(&serde_json::from_str(include_str!("rich.json")).expect("JSON"));
    for pass in passes(&rich) {
        let is_mesh = pass["draws"] == "meshes";
        assert_eq!(pass.get("sides").is_some(), is_mesh, "{pass}");
        assert!(
            !is_mesh || pass["sides"] == "both",
            "its alpha cutoff holds in all passes: {pass}"
        );
    }
}

/// Warnings where a look takes the nearest tiers that an export carries.
fn take_carried(look: &mut Look, library: &mut Library) -> Vec<Diagnostic> {
    let options = ExportOptions { takes_carried_tiers: true, ..ExportOptions::default() };
    options.apply(look, library, false).unwrap_or_else(|problems| panic!("{problems:?}"))
}

/// A package has painted surfaces in little room; their storage is what is asked for, else what the
/// artist chose for a reason.
#[test]
fn painted_surfaces_are_stored_as_the_target_likes() {
    let path = root().join("examples/hcbtf/stripes.json");
    let folder = path.parent().expect("a folder");
    let original = Look::load(&chiaro::files::Disk, &path).value.expect("an example");
    let size = |storage: Option<Storage>, is_package: bool, chosen: Option<&str>| {
        let (mut look, mut library) = (original.clone(), Library::built_in().clone());
        for node in look.graph.nodes.values_mut().filter(|node| node.kind == "hcbtf_lookup") {
            node.values.extend(chosen.map(|word| ("storage".into(), Value::Text(word.to_owned()))));
        }
        let options = ExportOptions { storage, ..ExportOptions::default() };
        options.apply(&mut look, &mut library, is_package).expect("a look");
        let place = (folder, &mut Assets::default());
        let files = export(&look, &library, "a", &LANGUAGES[..1], place).expect("files").value;
        let is_texture = |file: &&ExportFile| file.name.ends_with(".ktx2");
        files.iter().find(is_texture).expect("a texture").bytes.len()
    };
    let [quick, compact, blocks] = Storage::ALL.map(|storage| size(Some(storage), false, None));
    assert!(compact < quick && blocks < quick, "{quick} {compact} {blocks}");
    assert_eq!(size(None, false, None), quick);
    assert_eq!(size(None, true, None), compact);
    assert_eq!(size(None, true, Some("blocks")), blocks);
    assert_eq!(size(Some(Storage::Quick), true, Some("blocks")), quick);
}

/// The nearest tier that an export carries takes the place of one that it does not carry, and that
/// is told by the node's name.
#[test]
fn tiers_that_no_export_carries_are_replaced_aloud() {
    for path in files::below(&root().join("examples/shadows")) {
        let name = path.display().to_string();
        let mut look = Look::load(&chiaro::files::Disk, &path).value.expect("an example");
        let mut library = Library::built_in().clone();
        let told = take_carried(&mut look, &mut library);
        assert!(!told.is_empty(), "{name}: it sends rays");
        for told in &told {
            let node = told.place.node.as_ref().expect("a node is named");
            assert!(told.message.contains(&node.to_string()), "{told}");
            assert!(told.message.contains("balanced") || told.message.contains("fast"), "{told}");
        }
        let exported =
            export(&look, &library, "a", &LANGUAGES[..1], (root(), &mut Assets::default()));
        assert!(exported.is_ok(), "{name}: {:?}", exported.err());
        assert!(take_carried(&mut look, &mut library).is_empty(), "{name}");
    }
}

/// A look whose tiers are all carried keeps them.
#[test]
fn carried_tiers_stay() {
    let path = root().join("examples/looks/clay.json");
    let mut look = Look::load(&chiaro::files::Disk, &path).value.expect("an example");
    look.set_every_tier(Tier::Exact);
    let before = look.to_text();
    let told = take_carried(&mut look, &mut Library::built_in().clone());
    assert!(told.is_empty() && look.to_text() == before, "{told:?}");
}
