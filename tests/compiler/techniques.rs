//! `docs/techniques.md`: every technique has nodes that exist, a look that uses them, and tests
//! that exist.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use chiaro_compiler::document::Value;
use chiaro_compiler::library::{Fallback, Library};
use serde_json::Value as Json;

use crate::support;

fn root() -> &'static Path {
    support::root()
}

/// Files that the links of a cell lead to, from `docs/`.
fn links(cell: &str) -> Vec<PathBuf> {
    cell.split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .map(|link| root().join("docs").join(link))
        .collect()
}

/// Looks of a document: the look itself, or those of a scene's objects.
fn looks(path: &Path) -> Vec<Json> {
    let text =
        std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let document: Json = serde_json::from_str(&text).unwrap();
    if document["chiaro"] == "look" {
        return vec![document];
    }
    let objects = document["objects"].as_array().unwrap();
    let named: BTreeSet<&str> =
        objects.iter().filter_map(|object| object["looks"].as_str()).collect();
    named.iter().flat_map(|name| looks(&path.with_file_name(name))).collect()
}

/// Words that a node is listed under: its kind, and its kind with each of its choices.
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

/// Words for the drivers of a set of keys.
fn words_of_drivers(by: &Json, found: &mut BTreeSet<String>) {
    match by {
        Json::String(word) => drop(found.insert(format!("by.{word}"))),
        Json::Object(fields) => match fields.get("drivers") {
            Some(drivers) => drivers
                .as_array()
                .unwrap()
                .iter()
                .for_each(|driver| words_of_drivers(driver, found)),
            None => found.extend(fields.keys().map(|word| format!("by.{word}"))),
        },
        _ => panic!("{by} drives nothing"),
    }
}

/// Rows of the page's tables, in cells.
fn rows(text: &str) -> Vec<Vec<&str>> {
    let rows: Vec<Vec<&str>> = text
        .lines()
        .filter(|line| {
            line.starts_with("| ") && !line.starts_with("| technique") && !line.starts_with("| ---")
        })
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    assert!(rows.len() >= 40, "only {} rows are read", rows.len());
    rows
}

/// Words between backticks.
fn words(cell: &str) -> Vec<&str> {
    cell.split('`').filter(|word| !word.trim().is_empty()).collect()
}

fn page() -> String {
    std::fs::read_to_string(root().join("docs/techniques.md")).unwrap()
}

/// Texts of a node's or a group's documentation.
fn docs(kind: &str) -> Vec<&'static str> {
    let library = Library::built_in();
    let node = library.nodes.get(kind).into_iter();
    let told = node.flat_map(|node| std::iter::once(&node.help).chain(&node.sources));
    told.chain(library.groups.get(kind).map(|group| &group.definition.help))
        .map(String::as_str)
        .collect()
}

fn about(look: &Json) -> String {
    look["about"].as_str().unwrap_or_default().to_owned()
}

/// Nodes and looks of a technique name the papers that the technique comes from.
#[test]
fn a_techniques_nodes_name_its_papers() {
    let page = page();
    let mut papers = 0;
    for row in rows(&page) {
        let [technique, after, nodes, examples, _] = row[..] else {
            panic!("{row:?} has not five cells")
        };
        let kinds = words(nodes).into_iter().filter_map(|word| word.split('.').next());
        let docs: Vec<String> = match technique {
            // No node does this technique: its looks name the papers.
            "Painted shading" => links(examples)
                .iter()
                .flat_map(|path| looks(path))
                .map(|look| about(&look))
                .collect(),
            _ => kinds.flat_map(docs).map(str::to_owned).collect(),
        };
        for paper in after.split(", ") {
            let mut told = paper.split(' ');
            let is_year = |word: &&str| word.len() == 4 && word.parse::<u32>().is_ok();
            // `Cook and Torrance 1982`, `Kalnins et al. 2002`: who, and when.
            let (Some(who), Some(when)) = (told.next(), told.find(is_year)) else { continue };
            let is_named = docs.iter().any(|text| text.contains(who) && text.contains(when));
            assert!(is_named, "{technique}: no docs of {nodes} name {paper}");
            papers += 1;
        }
    }
    assert!(papers >= 40, "only {papers} papers are read");
}

#[test]
fn every_technique_has_nodes_looks_and_tests() {
    let page = page();
    for row in rows(&page) {
        let [technique, _, words, examples, tests] = row[..] else {
            panic!("{row:?} has not five cells")
        };
        let mut found = BTreeSet::new();
        let examples = links(examples);
        for look in examples.iter().flat_map(|path| looks(path)) {
            let groups = look["definitions"].as_object().into_iter().flatten();
            let inner = groups.map(|(_, group)| &group["nodes"]);
            let nodes = std::iter::once(&look["nodes"]).chain(inner);
            nodes
                .flat_map(|nodes| nodes.as_array().unwrap())
                .for_each(|node| words_of_node(node, &mut found));
            let sets = look["direction_keys"].as_array().into_iter().flatten();
            sets.for_each(|set| words_of_drivers(&set["by"], &mut found));
        }
        let words = self::words(words);
        assert!(!words.is_empty() && !examples.is_empty(), "{technique}: nothing is told of it");
        for word in words {
            assert!(found.contains(word), "{technique}: none of {examples:?} has `{word}`");
        }
        let tests = links(tests);
        assert!(
            !tests.is_empty() && tests.iter().all(|path| path.is_file()),
            "{technique}: {tests:?}"
        );
    }
}
