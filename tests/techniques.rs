//! `docs/techniques.md`: every technique has nodes that are there, a look that uses them, and tests that are there.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use chiaro::document::Value;
use chiaro::library::{Fallback, Library};
use serde_json::Value as Json;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Where the links of a cell lead, from `docs/`.
fn links(cell: &str) -> Vec<PathBuf> {
    cell.split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .map(|link| root().join("docs").join(link))
        .collect()
}

/// The looks that a document is of: itself, or those of a scene's objects.
fn looks(path: &Path) -> Vec<Json> {
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let document: Json = serde_json::from_str(&text).unwrap();
    if document["chiaro"] == "look" {
        return vec![document];
    }
    let objects = document["objects"].as_array().unwrap();
    let named: BTreeSet<&str> = objects.iter().filter_map(|object| object["looks"].as_str()).collect();
    named.iter().flat_map(|name| looks(&path.with_file_name(name))).collect()
}

/// The words that a node stands under: its kind, and its kind with each of its choices.
fn words_of_node(node: &Json, found: &mut BTreeSet<String>) {
    let kind = node["kind"].as_str().unwrap();
    found.insert(kind.to_owned());
    let Some(def) = Library::built_in().nodes.get(kind) else { return };
    for input in def.visible_inputs().filter(|input| !input.options.is_empty()) {
        let own = node["values"][input.name.as_str()].as_str();
        let word = match (&input.fallback, own) {
            (_, Some(own)) => own.to_owned(),
            (Fallback::Value(Value::Text(word)), None) => word.clone(),
            _ => continue,
        };
        found.insert(format!("{kind}.{word}"));
    }
}

/// The words of what drives a set of keys.
fn words_of_drivers(by: &Json, found: &mut BTreeSet<String>) {
    match by {
        Json::String(word) => drop(found.insert(format!("by.{word}"))),
        Json::Object(fields) => match fields.get("drivers") {
            Some(drivers) => drivers.as_array().unwrap().iter().for_each(|driver| words_of_drivers(driver, found)),
            None => found.extend(fields.keys().map(|word| format!("by.{word}"))),
        },
        _ => panic!("{by} drives nothing"),
    }
}

#[test]
fn every_technique_has_nodes_looks_and_tests() {
    let text = std::fs::read_to_string(root().join("docs/techniques.md")).unwrap();
    let rows: Vec<Vec<&str>> = text
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| technique") && !line.starts_with("| ---"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    assert!(rows.len() >= 40, "only {} rows are read", rows.len());
    for row in rows {
        let [technique, _, words, examples, tests] = row[..] else { panic!("{row:?} has not five cells") };
        let mut found = BTreeSet::new();
        let examples = links(examples);
        for look in examples.iter().flat_map(|path| looks(path)) {
            look["nodes"].as_array().unwrap().iter().for_each(|node| words_of_node(node, &mut found));
            let sets = look["direction_keys"].as_array().into_iter().flatten();
            sets.for_each(|set| words_of_drivers(&set["by"], &mut found));
        }
        let words: Vec<&str> = words.split('`').filter(|word| !word.trim().is_empty()).collect();
        assert!(!words.is_empty() && !examples.is_empty(), "{technique}: nothing is told of it");
        for word in words {
            assert!(found.contains(word), "{technique}: none of {examples:?} has `{word}`");
        }
        let tests = links(tests);
        assert!(!tests.is_empty() && tests.iter().all(|path| path.is_file()), "{technique}: {tests:?}");
    }
}
