//! Looks and scenes that come with the program.

use std::path::PathBuf;

use crate::document::{Look, Scene};
use crate::examples::{PREFIX, documents, text};

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
}

/// Example by its number; `None` where there is none.
pub(crate) fn example(index: usize) -> Option<Example> {
    let name = documents().nth(index)?;
    let (folder, file) = name.split_once('/')?;
    let stem = file.strip_suffix(".json")?;
    let path = PathBuf::from(format!("{PREFIX}{name}"));
    let text = text(&path)?;
    let content = match folder {
        "scenes" => ExampleContent::Scene(Scene::read(&text, stem).value?),
        _ => ExampleContent::Look(Look::read(&text, stem).value?),
    };
    Some(Example { stem, path, content })
}

/// Number of examples.
pub(crate) fn count() -> usize {
    documents().count()
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
            }
        }
    }
}
