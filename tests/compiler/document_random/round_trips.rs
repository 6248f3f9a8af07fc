//! Documents are written and read without loss, and the schemas agree.

use chiaro_compiler::document::{Document, Look, Scene, Shot};
use chiaro_language::diag::has_errors;
use proptest::prelude::*;

use super::random::Random;

proptest! {
    #[test]
    fn looks_survive(seed: u64, size in 0..12usize) {
        let look = Random::new(seed, size).look();
        prop_assert_eq!(
            look.check().iter().map(ToString::to_string).collect::<Vec<_>>(), Vec::<String>::new()
        );
        let text = look.to_text();
        let loaded = Look::read(&text, "random.json");
        prop_assert!(!has_errors(&loaded.diagnostics), "{:?}\n{}", loaded.diagnostics, text);
        let read = loaded.value.unwrap();
        prop_assert_eq!(&read, &look);
        // Equal texts also mean equal order of nodes and members, and equal signs of zeros.
        prop_assert_eq!(read.to_text(), text.clone());
        // The text is JSON for any reader, not only for the project's own.
        prop_assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok());
    }

    #[test]
    fn scenes_survive(seed: u64, size in 0..6usize) {
        let scene = Random::new(seed, size).scene();
        let text = scene.to_text();
        let loaded = Scene::read(&text, "random.json");
        prop_assert!(!has_errors(&loaded.diagnostics), "{:?}\n{}", loaded.diagnostics, text);
        let read = loaded.value.unwrap();
        prop_assert_eq!(&read, &scene);
        prop_assert_eq!(read.to_text(), text.clone());
        prop_assert!(matches!(Document::read(&text, ""), Document::Scene(_)));
    }

    #[test]
    fn shots_survive(seed: u64, size in 0..6usize) {
        let shot = Random::new(seed, size).shot();
        prop_assert_eq!(
            shot.check().iter().map(ToString::to_string).collect::<Vec<_>>(), Vec::<String>::new()
        );
        let text = shot.to_text();
        let loaded = Shot::read(&text, "random.json");
        prop_assert!(!has_errors(&loaded.diagnostics), "{:?}\n{}", loaded.diagnostics, text);
        let read = loaded.value.unwrap();
        prop_assert_eq!(&read, &shot);
        prop_assert_eq!(read.to_text(), text.clone());
        prop_assert!(matches!(Document::read(&text, ""), Document::Shot(_)));
        // Unchanged, it stays as it was written, and a field that nobody knows stays with it.
        let spaced = text.replacen('{', "{\r\n\t\"later\": [1.50, null],", 1);
        let loaded = Shot::read(&spaced, "own.json");
        let mut read = loaded.value.unwrap();
        prop_assert_eq!(read.to_text_like(&loaded.source), spaced);
        read.name.push('!');
        prop_assert!(read.to_text_like(&loaded.source).contains("\"later\": [1.5, null]"));
    }

    /// White space, line ends, order of fields and spelling of numbers stay while nothing is
    /// changed.
    #[test]
    fn unchanged_texts_stay_as_they_are(seed: u64, size in 0..6usize) {
        let look = Random::new(seed, size).look();
        let json: serde_json::Value = serde_json::from_str(&look.to_text()).unwrap();
        let text = format!(
            "\u{feff}\r\n{}  ", serde_json::to_string_pretty(&json).unwrap().replace('\n', "\r\n\t")
        );
        let loaded = Look::read(&text, "own.json");
        let read = loaded.value.unwrap();
        prop_assert_eq!(&read, &look);
        prop_assert_eq!(read.to_text_like(&loaded.source), text.clone());
        let mut other = read.clone();
        other.name.push('!');
        prop_assert_eq!(other.to_text_like(&loaded.source), other.to_text());
    }

    #[test]
    fn random_documents_fit_the_schemas(seed: u64, size in 0..6usize) {
        let mut random = Random::new(seed, size);
        for (text, schema) in [
            (random.look().to_text(), chiaro_compiler::document::look_schema()),
            (random.scene().to_text(), chiaro_compiler::document::scene_schema()),
            (random.shot().to_text(), chiaro_compiler::document::shot_schema()),
        ] {
            let validator = jsonschema::draft202012::new(&schema).unwrap();
            let json: serde_json::Value = serde_json::from_str(&text).unwrap();
            let errors: Vec<String> =
                validator
                    .iter_errors(&json)
                    .map(|e| format!("{}: {e}", e.instance_path()))
                    .collect();
            prop_assert!(errors.is_empty(), "{:?}\n{}", errors, text);
        }
    }
}
