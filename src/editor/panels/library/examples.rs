//! Looks, scenes and shots that come with the program.

use std::collections::HashMap;
use std::path::PathBuf;

use serde::Deserialize as _;
use serde_json::Value as Json;

use super::super::thumbs::ThumbStage;
use crate::document::{Look, Scene, Shot};
use crate::examples::{GALLERY, PREFIX, documents, subjects, text};

/// Example that can be opened.
pub(crate) struct Example {
    /// Stem of the example's file name.
    pub(crate) stem: &'static str,
    /// Path under which the example is opened.
    pub(crate) path: PathBuf,
    pub(crate) content: ExampleContent,
}

/// Content of an example.
pub(crate) enum ExampleContent {
    Look(Look),
    Scene(Scene),
    Shot(Shot),
}

/// Example by its number; `None` where there is none.
pub(crate) fn example(index: usize) -> Option<Example> {
    let name = documents().nth(index)?;
    let (folder, _) = name.split_once('/')?;
    let (_, file) = name.rsplit_once('/')?;
    let stem = file.strip_suffix(".json")?;
    let path = PathBuf::from(format!("{PREFIX}{name}"));
    let text = text(&path)?;
    let content = match folder {
        "scenes" => ExampleContent::Scene(Scene::read(&text, stem).value?),
        "shots" => ExampleContent::Shot(Shot::read(&text, stem).value?),
        _ => ExampleContent::Look(Look::read(&text, stem).value?),
    };
    Some(Example { stem, path, content })
}

/// Number of examples.
pub(crate) fn count() -> usize {
    documents().count()
}

/// Lists that say more about examples: their tags, and the stages that suit their looks.
pub(super) struct Listing {
    tags: HashMap<&'static str, &'static str>,
    stages: HashMap<String, ThumbStage>,
}

impl Listing {
    /// Reads the lists, which takes about a millisecond.
    pub(super) fn new() -> Self {
        let gallery: Json = serde_json::from_str(GALLERY).unwrap_or_default();
        let sections = gallery["sections"].as_array().into_iter().flatten();
        let entries = sections.flat_map(|section| section["entries"].as_array().into_iter());
        let mut stages = HashMap::new();
        for entry in entries.flatten() {
            if let (Some(file), Ok(stage)) =
                (entry["file"].as_str(), ThumbStage::deserialize(entry))
            {
                // The first picture of a document is the one that it is known by.
                stages.entry(file.to_owned()).or_insert(stage);
            }
        }
        let tags = subjects().into_iter().flat_map(|subject| subject.examples).collect();
        Self { tags, stages }
    }

    /// Tags of an example, by its name.
    pub(super) fn tags(&self, name: &str) -> String {
        self.tags.get(name).copied().unwrap_or_default().to_owned()
    }

    /// Stage of an example's look, by the example's name.
    pub(super) fn stage(&self, name: &str) -> ThumbStage {
        self.stages.get(name).cloned().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_can_be_read() {
        for index in 0..count() {
            let example = example(index).unwrap();
            let text = text(&example.path).unwrap();
            match example.content {
                ExampleContent::Look(_) => {
                    assert!(!Look::read(&text, example.stem).has_errors(), "{}", example.stem);
                }
                ExampleContent::Scene(_) => {
                    assert!(!Scene::read(&text, example.stem).has_errors(), "{}", example.stem);
                }
                ExampleContent::Shot(_) => {
                    assert!(!Shot::read(&text, example.stem).has_errors(), "{}", example.stem);
                }
            }
        }
    }
}
