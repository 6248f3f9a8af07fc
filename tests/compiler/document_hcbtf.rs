//! Manifests of HCBTFs: their schema, their defaults, and the fields of later versions.

use chiaro_compiler::document::relief::PRESETS;
use chiaro_compiler::document::{
    Address, Bundle, Grid, HcbtfManifest, PaintedSample, Placement, Relief, Rule, StrokeTones,
    Strokes, UnknownFields, hcbtf_schema,
};
use chiaro_language::diag::has_errors;
use serde_json::Value;

/// A manifest with every rule, every pattern of a relief, and every placement of strokes.
fn full() -> HcbtfManifest {
    let mut rules: Vec<Rule> =
        Rule::ABOUT.iter().map(|about| about.fresh().expect("a rule of the word")).collect();
    rules.extend(Strokes::PRESETS.map(|name| Rule::Strokes(Box::new(Strokes::preset(name)))));
    rules.extend(PRESETS.map(|(_, preset)| Rule::Relief(Box::new(preset()))));
    let painted = serde_json::json!({ "rule": "relief", "pattern": { "pattern": "painted" } });
    rules.push(read_rule(&painted));
    let tones = Some(StrokeTones { first: 0.1, all: 0.9, growth: 1.0 / 3.0 });
    let place = Placement::Paths(vec![vec![[0.1, 0.2, 0.3], [-1.0 / 3.0, 0.5, 0.0]], Vec::new()]);
    let bundles = vec![Bundle { place, tones, ..Bundle::default() }];
    rules.push(Rule::Strokes(Box::new(Strokes { bundles, ..Strokes::default() })));
    let Address { light, view } = Address::new([2, 3], [1, 4]);
    HcbtfManifest {
        grid: Grid::THESIS,
        is_tiling: false,
        rules,
        painted: vec![PaintedSample { light, view, file: "samples/l2.3_v1.4.png".to_owned() }],
        unknown: UnknownFields::new(),
    }
}

/// A manifest with one rule, as text.
fn text_with(rule: &Value) -> String {
    let mut manifest: Value = serde_json::from_str(&full().to_text()).unwrap();
    manifest["rules"] = Value::Array(vec![rule.clone()]);
    manifest.to_string()
}

fn read_rule(rule: &Value) -> Rule {
    let manifest = HcbtfManifest { rules: Vec::new(), ..base() };
    let mut text: Value = serde_json::from_str(&manifest.to_text()).unwrap();
    text["rules"] = Value::Array(vec![rule.clone()]);
    let loaded = HcbtfManifest::read(&text.to_string(), "");
    assert!(!has_errors(&loaded.diagnostics), "{rule}: {:?}", loaded.diagnostics);
    loaded.value.unwrap().rules.swap_remove(0)
}

fn base() -> HcbtfManifest {
    HcbtfManifest {
        grid: Grid::THESIS,
        is_tiling: true,
        rules: Vec::new(),
        painted: Vec::new(),
        unknown: UnknownFields::new(),
    }
}

#[test]
fn what_is_written_is_read_and_fits_the_schema() {
    let validator = jsonschema::draft202012::new(&hcbtf_schema()).unwrap();
    for manifest in [full(), base()] {
        let text = manifest.to_text();
        let json: Value = serde_json::from_str(&text).unwrap();
        let errors: Vec<String> = validator
            .iter_errors(&json)
            .map(|error| format!("{}: {error}", error.instance_path()))
            .collect();
        assert!(errors.is_empty(), "{errors:?}\n{text}");
        let loaded = HcbtfManifest::read(&text, "");
        assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
        assert_eq!(loaded.value.unwrap(), manifest);
    }
}

#[test]
fn a_field_that_is_left_out_is_as_the_window_makes_it() {
    for about in Rule::ABOUT {
        let rule = read_rule(&serde_json::json!({ "rule": about.word }));
        assert_eq!(Some(rule), about.fresh(), "{}", about.word);
    }
    let Rule::Relief(relief) = read_rule(&serde_json::json!({ "rule": "relief" })) else {
        panic!("a relief")
    };
    assert_eq!(*relief, Relief::default());
}

/// Adds a field that no version knows to every object of a document, and counts the objects.
fn add_later(at: &mut Value) -> usize {
    match at {
        Value::Object(members) => {
            let count: usize = members.values_mut().map(add_later).sum();
            members.insert("later".to_owned(), serde_json::json!({ "a": [1, count] }));
            count + 1
        }
        Value::Array(items) => items.iter_mut().map(add_later).sum(),
        _ => 0,
    }
}

#[test]
fn every_object_keeps_the_fields_of_later_versions() {
    let mut manifest: Value = serde_json::from_str(&full().to_text()).unwrap();
    // Values without an object inside are kept apart: each problem is counted up to a bound.
    let rules = manifest["rules"].as_array().unwrap().clone();
    for rule in rules {
        manifest["rules"] = Value::Array(vec![rule]);
        let mut later = manifest.clone();
        let count = add_later(&mut later);
        let loaded = HcbtfManifest::read(&later.to_string(), "");
        assert!(!has_errors(&loaded.diagnostics), "{:?}", loaded.diagnostics);
        let told = loaded.diagnostics.iter().filter(|d| d.code == "unknown-field").count();
        assert_eq!(told, count, "{later}");
        let written: Value = serde_json::from_str(&loaded.value.unwrap().to_text()).unwrap();
        assert_eq!(written, later);
    }
}

/// Places of all numbers of a value.
fn numbers(at: &Value, path: &str, found: &mut Vec<String>) {
    match at {
        Value::Number(_) => found.push(path.to_owned()),
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                numbers(item, &format!("{path}/{index}"), found);
            }
        }
        Value::Object(members) => {
            for (name, member) in members {
                numbers(member, &format!("{path}/{name}"), found);
            }
        }
        _ => {}
    }
}

#[test]
fn every_number_of_a_rule_has_bounds_in_files_and_in_memory() {
    let rules: Value = serde_json::to_value(full().rules).unwrap();
    for rule in rules.as_array().unwrap() {
        let mut places = Vec::new();
        numbers(rule, "", &mut places);
        for place in places {
            let mut beyond = rule.clone();
            *beyond.pointer_mut(&place).unwrap() = 1e12.into();
            let loaded = HcbtfManifest::read(&text_with(&beyond), "");
            let is_told = loaded.diagnostics.iter().any(|d| d.code == "out-of-range");
            assert!(is_told, "{place} of {rule}: {:?}", loaded.diagnostics);
            // Whole numbers cannot hold it in memory; the others are checked as edits are.
            if let Ok(rule) = serde_json::from_value::<Rule>(beyond) {
                let why = rule.check(&Grid::THESIS).unwrap_err();
                assert!(why.contains("1000000000000") || why.contains("1e12"), "{place}: {why}");
            }
        }
    }
}
