//! Any text gives diagnostics and no panic.

use chiaro_compiler::document::{Document, Look, Scene};
use chiaro_language::diag::has_errors;
use proptest::prelude::*;

use super::random::Random;

/// Reads a text as every kind of document; gives the length of all diagnostics as text.
fn read_all(text: &str) -> usize {
    let shown = |document: Document| {
        document.diagnostics().iter().map(|d| d.to_string().len()).sum::<usize>()
    };
    let look = Look::read(text, "a.json");
    let rewritten = look.value.as_ref().map(|value| Look::read(&value.to_text(), "again.json"));
    // The value read from a broken document is whole: it can be written and read again.
    if let Some(again) = rewritten {
        assert_eq!(again.value, look.value, "{text}");
    }
    let scene = Scene::read(text, "a.json");
    if let Some(scene) = scene.value {
        assert!(Scene::read(&scene.to_text(), "again.json").value.is_some(), "{text}");
    }
    shown(Document::read(text, "a.json"))
}

#[test]
fn every_prefix_of_a_look_gives_diagnostics() {
    for seed in 0..12 {
        let text = Random::new(seed, 3).look().to_text();
        let whole = text.trim_end().len();
        for end in (0..whole).filter(|&end| text.is_char_boundary(end)) {
            let loaded = Look::read(&text[..end], "cut.json");
            assert!(has_errors(&loaded.diagnostics), "nothing is wrong with {}", &text[..end]);
            let own = |code: &str| matches!(code, "truncated" | "empty-file" | "unknown-field");
            let other: Vec<_> = loaded
                .diagnostics
                .iter()
                .filter(|d| !own(d.code))
                .map(ToString::to_string)
                .collect();
            assert!(other.is_empty(), "{other:?}\n{}", &text[..end]);
            assert_eq!(loaded.value.is_some(), end > 0);
        }
    }
}

#[test]
fn every_prefix_of_a_scene_gives_diagnostics() {
    for seed in 0..12 {
        let text = Random::new(seed, 3).scene().to_text();
        for end in (0..text.trim_end().len()).filter(|&end| text.is_char_boundary(end)) {
            let loaded = Scene::read(&text[..end], "cut.json");
            let codes: Vec<_> = loaded
                .diagnostics
                .iter()
                .map(|d| d.code)
                .filter(|c| *c != "unknown-field")
                .collect();
            assert!(
                matches!(codes[..], ["truncated"] | ["empty-file"]),
                "{codes:?}\n{}",
                &text[..end]
            );
        }
    }
}

proptest! {
    #[test]
    fn any_characters(text in ".{0,200}") {
        read_all(&text);
    }

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        read_all(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn anything_that_looks_like_json(
        text in concat!(
            r#"(\{|\}|\[|\]|,|:|"|'|"a"|"id": |"nodes": |null|true|NaN"#,
            r#"|-?[0-9]{1,3}|1e999|0x1|//|/\*|\\|\\u|\n| |x){0,60}"#
        )
    ) {
        read_all(&text);
        let begun = "{".to_owned() + &text;
        read_all(&begun);
    }

    /// Documents with some characters changed, removed or doubled.
    #[test]
    fn broken_documents(
        seed: u64, size in 0..5usize,
        hits in prop::collection::vec((any::<prop::sample::Index>(), 0..4u8, ".{0,3}"), 1..6)
    ) {
        let mut random = Random::new(seed, size);
        for text in [random.look().to_text(), random.scene().to_text()] {
            let mut chars: Vec<char> = text.chars().collect();
            for (index, kind, insert) in &hits {
                let index = index.index(chars.len());
                match kind {
                    0 => drop(chars.remove(index)),
                    1 => drop(chars.splice(index..index, insert.chars())),
                    2 => drop(chars.splice(index..index + 1, insert.chars())),
                    _ => chars.insert(index, chars[index]),
                }
                if chars.is_empty() {
                    break;
                }
            }
            read_all(&chars.into_iter().collect::<String>());
        }
    }

    /// Documents with some values replaced by random ones.
    #[test]
    fn documents_of_wrong_values(seed: u64, size in 0..5usize) {
        let mut random = Random::new(seed, size);
        for text in [random.look().to_text(), random.scene().to_text()] {
            let mut json: serde_json::Value = serde_json::from_str(&text).unwrap();
            for _ in 0..1 + random.below(5) {
                replace_one(&mut random, &mut json);
            }
            read_all(&json.to_string());
        }
    }
}

/// Replaces one value of a JSON text by a random one.
fn replace_one(random: &mut Random, json: &mut serde_json::Value) {
    let mut at = json;
    loop {
        let count = match &*at {
            serde_json::Value::Array(items) => items.len(),
            serde_json::Value::Object(members) => members.len(),
            _ => 0,
        };
        if count == 0 || random.chance(1) {
            let others = serde_json::json!([
                null, true, -1, 1e40, 0, 1.5, "", "a.b", "#12", [], {}, [1, 2, 3], [[1]], {"a": 1}
            ]);
            *at = others[random.below(14)].clone();
            return;
        }
        let index = random.below(count);
        at = match at {
            serde_json::Value::Array(items) => &mut items[index],
            serde_json::Value::Object(members) => members.values_mut().nth(index).unwrap(),
            other => other,
        };
    }
}
