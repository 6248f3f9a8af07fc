//! docs/format.md and the JSON Schemas agree with the code. `CHIARO_BLESS=1 cargo test -p
//! chiaro-compiler --test compiler document_format` writes the files that the code makes; the
//! difference is then reviewed like any other.

use std::collections::BTreeMap;
use std::path::PathBuf;

use chiaro_compiler::document::{
    Document, Look, Scene, Shot, Storage, field_tables, hcbtf_schema, look_schema, scene_schema,
    shot_schema,
};
use chiaro_language::diag::has_errors;
use serde_json::Value;

use crate::support;

fn docs(file: &str) -> PathBuf {
    support::root().join("docs").join(file)
}

/// Compares a file of `docs/` with the text that the code makes, or writes the file when blessing.
fn held(file: &str, made: &str) {
    let path = docs(file);
    if std::env::var_os("CHIARO_BLESS").is_some() {
        std::fs::write(&path, made).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(
        committed == made,
        "docs/{file} is not what the code says; see the head of tests/compiler/document_format.rs"
    );
}

#[test]
fn the_schemas_are_those_of_the_code() {
    for (file, schema) in [
        ("look.schema.json", look_schema()),
        ("scene.schema.json", scene_schema()),
        ("shot.schema.json", shot_schema()),
        ("hcbtf.schema.json", hcbtf_schema()),
    ] {
        held(file, &(serde_json::to_string_pretty(&schema).unwrap() + "\n"));
        assert!(jsonschema::draft202012::meta::is_valid(&schema), "{file} is no JSON Schema");
    }
}

#[test]
fn the_tables_are_those_of_the_code() {
    let text = std::fs::read_to_string(docs("format.md")).unwrap().replace("\r\n", "\n");
    let tables: BTreeMap<&str, String> = field_tables().into_iter().collect();
    let mut made = String::new();
    let mut seen = Vec::new();
    let mut skipping = false;
    for line in text.lines() {
        if line == "<!-- end -->" {
            skipping = false;
        }
        if !skipping {
            made += line;
            made += "\n";
        }
        if let Some(name) =
            line.strip_prefix("<!-- fields: ").and_then(|rest| rest.strip_suffix(" -->"))
        {
            made += tables.get(name).unwrap_or_else(|| panic!("no table `{name}`"));
            seen.push(name);
            skipping = true;
        }
    }
    seen.sort_unstable();
    assert_eq!(
        seen,
        tables.keys().copied().collect::<Vec<_>>(),
        "every table is in docs/format.md once"
    );
    held("format.md", &made);
}

#[test]
fn storages_are_told_of_in_the_words_of_the_code() {
    let text = std::fs::read_to_string(docs("format.md")).unwrap();
    // Lines are wrapped as they come.
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for storage in Storage::ALL {
        let line = format!("- `{}`: {}", storage.word(), storage.about());
        assert!(text.contains(&line), "docs/format.md does not say `{line}`");
    }
}

/// Links of docs/format.md lead to its headings.
#[test]
fn links_lead_somewhere() {
    let text = std::fs::read_to_string(docs("format.md")).unwrap();
    let headings: Vec<String> = text
        .lines()
        .filter_map(|line| line.strip_prefix('#').map(|rest| rest.trim_start_matches('#').trim()))
        .map(|heading| heading.to_lowercase().replace(' ', "-"))
        .collect();
    for link in text.split("](#").skip(1).map(|rest| rest.split(')').next().unwrap()) {
        assert!(headings.iter().any(|heading| heading == link), "nothing is headed `{link}`");
    }
}

#[test]
fn the_examples_are_read() {
    let text = std::fs::read_to_string(docs("format.md")).unwrap();
    let blocks: Vec<&str> =
        text.split("```json\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert!(blocks.len() >= 3);
    for block in blocks {
        // An example of a single field stands in the text without braces.
        let block = if block.starts_with('{') { block.to_owned() } else { format!("{{{block}}}") };
        let document = Document::read(&block, "docs/format.md");
        assert!(document.diagnostics().is_empty(), "{:?}\n{block}", document.diagnostics());
    }
}

/// Puts `value` at a path of field names, with `[]` for the only item of a list and `{}` for the
/// only member of a map.
fn nested(path: &[String], value: Value) -> Value {
    let Some((first, rest)) = path.split_first() else { return value };
    let inner = nested(rest, value);
    match first.as_str() {
        "[]" => Value::Array(vec![inner]),
        "{}" => serde_json::json!({ "a": inner }),
        field => Value::Object([(field.to_owned(), inner)].into_iter().collect()),
    }
}

/// Path of every object of the schema, with the names of the object's fields.
fn objects(schema: &Value) -> Vec<(Vec<String>, Vec<String>)> {
    let mut found = Vec::new();
    let mut open: Vec<(Vec<String>, &Value)> = vec![(Vec::new(), schema)];
    let mut seen = Vec::new();
    while let Some((path, at)) = open.pop() {
        if let Some(name) = at["$ref"].as_str() {
            if !seen.contains(&name) {
                seen.push(name);
                open.push((path, schema.pointer(&name[1..]).unwrap()));
            }
            continue;
        }
        for choice in at["anyOf"].as_array().into_iter().flatten() {
            open.push((path.clone(), choice));
        }
        let step = |part: &str| [path.clone(), vec![part.to_owned()]].concat();
        if at["items"].is_object() {
            open.push((step("[]"), &at["items"]));
        }
        if at["additionalProperties"].is_object() {
            open.push((step("{}"), &at["additionalProperties"]));
        }
        if let Some(properties) = at["properties"].as_object() {
            found.push((path.clone(), properties.keys().cloned().collect()));
            open.extend(properties.iter().map(|(name, inner)| (step(name), inner)));
        }
    }
    found
}

/// The reader knows every field of the schemas, and the schemas have every field that the reader
/// knows: the reader warns about any other.
#[test]
fn the_reader_knows_the_fields_of_the_schemas() {
    type Reader = fn(&str) -> Vec<chiaro_language::diag::Diagnostic>;
    let read: [(Value, Reader); 3] = [
        (look_schema(), |text| Look::read(text, "").diagnostics),
        (scene_schema(), |text| Scene::read(text, "").diagnostics),
        (shot_schema(), |text| Shot::read(text, "").diagnostics),
    ];
    for (schema, read) in read {
        let objects = objects(&schema);
        assert!(objects.len() >= 6, "{objects:?}");
        for (path, fields) in objects {
            // `by` of direction keys takes an object with one of several fields, and is no table of
            // fields.
            if path.iter().any(|step| step == "by") {
                continue;
            }
            let mut all: serde_json::Map<String, Value> =
                fields.iter().map(|field| (field.clone(), Value::Null)).collect();
            all.insert("no such field".to_owned(), Value::Null);
            // A curve or a ramp is recognized by its own fields.
            let text = nested(&path, Value::Object(all)).to_string();
            let found = read(&text);
            let unknown: Vec<&str> = found
                .iter()
                .filter(|d| d.code == "unknown-field")
                .map(|d| d.message.as_str())
                .collect();
            assert_eq!(unknown.len(), 1, "{path:?}: {unknown:?}\n{text}");
            assert!(unknown[0].contains("no such field"), "{path:?}: {unknown:?}");
        }
    }
}

/// A field of the schema's tables with its default means the same as no field.
#[test]
fn defaults_are_what_is_left_out() {
    for (schema, empty) in
        [(look_schema(), Look::default().to_text()), (scene_schema(), Scene::default().to_text())]
    {
        let is_look = empty.contains("\"look\"");
        for (path, _) in objects(&schema) {
            let Some(object) = object_at(&schema, &path) else { continue };
            let mut full = serde_json::Map::new();
            let mut bare = serde_json::Map::new();
            for (name, field) in object["properties"].as_object().unwrap() {
                let is_required = object["required"]
                    .as_array()
                    .is_some_and(|r| r.iter().any(|r| r == name.as_str()));
                match field.get("default") {
                    Some(default) => drop(full.insert(name.clone(), default.clone())),
                    None if is_required => {
                        let some = some_value(name);
                        full.insert(name.clone(), some.clone());
                        bare.insert(name.clone(), some);
                    }
                    None => {}
                }
            }
            let texts = [full, bare].map(|object| {
                let text = nested(&path, Value::Object(object)).to_string();
                if is_look {
                    let loaded = Look::read(&text, "");
                    loaded.value.map(|value| value.to_text())
                } else {
                    let loaded = Scene::read(&text, "");
                    // Keys of a scene name its lights, of which there are none here.
                    let problems = loaded.diagnostics;
                    let is_fine = text.contains("_keys") || !has_errors(&problems);
                    assert!(is_fine, "{problems:?}\n{text}");
                    loaded.value.map(|value| value.to_text())
                }
            });
            assert!(texts[0].is_some(), "{path:?}");
            assert_eq!(texts[0], texts[1], "{path:?}");
        }
    }
}

fn some_value(field: &str) -> Value {
    match field {
        "direction" | "axis" => serde_json::json!([0, 1, 0]),
        "points" => serde_json::json!([[0, 0]]),
        "stops" => serde_json::json!([{ "at": 0, "color": [1, 1, 1] }]),
        "color" => serde_json::json!([1, 1, 1]),
        "at" | "time" | "angle" | "value" => 1.into(),
        "by" => "view".into(),
        "from" | "to" | "target" => "a.b".into(),
        _ => "a".into(),
    }
}

/// The object schema that [`objects`] found at a path.
fn object_at<'s>(schema: &'s Value, path: &[String]) -> Option<&'s Value> {
    let mut choices = vec![schema];
    let resolve = |choices: Vec<&'s Value>| -> Vec<&'s Value> {
        let mut open = choices;
        let mut all = Vec::new();
        while let Some(at) = open.pop() {
            match at["$ref"].as_str() {
                Some(name) => open.push(schema.pointer(&name[1..]).unwrap()),
                None => {
                    open.extend(at["anyOf"].as_array().into_iter().flatten());
                    all.push(at);
                }
            }
        }
        all
    };
    for step in path {
        let next = |at: &'s Value| match step.as_str() {
            "[]" => at.get("items"),
            "{}" => at.get("additionalProperties"),
            field => at["properties"].get(field),
        };
        choices = resolve(choices).into_iter().filter_map(next).collect();
    }
    resolve(choices).into_iter().find(|at| at["properties"].is_object())
}
