//! Examples embedded in the crate: looks, scenes, shots, meshes and HCBTFs, as files with names
//! that hold in any folder.
//!
//! `example:hcbtf/arch.json` is `examples/hcbtf/arch.json` of the source. Such a name may stand
//! wherever a path may, behind any folder, so that a document with such a reference can be saved
//! anywhere. The meshes of examples are the program's own shapes, and files in `meshes/`.

use std::path::{Component, Path, PathBuf};

/// Prefix of the names of examples.
pub const PREFIX: &str = "example:";

// `EXAMPLES`: name and content of each example, in the order in which they are best looked at
// (`examples/order.txt`).
include!(concat!(env!("OUT_DIR"), "/examples.rs"));

/// Folder of shots, and of the films that they are of.
const SHOTS: &str = "shots/";

/// Contents of the gallery: `examples/gallery.json`.
pub const GALLERY: &str = include_str!("examples/gallery.json");

/// Subjects of the examples, and the examples of each, the best first: `examples/order.txt`.
const ORDER: &str = include_str!("examples/order.txt");

/// Subject that examples are sorted under.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subject {
    /// Title of the subject.
    pub title: &'static str,
    /// Line on what the examples have in common.
    pub about: &'static str,
    /// Names of the examples, without [`PREFIX`], each with its tags: words to find it by.
    pub examples: Vec<(&'static str, &'static str)>,
}

/// Subjects of all example documents, in the order of [`documents`].
pub fn subjects() -> Vec<Subject> {
    let mut subjects: Vec<Subject> = Vec::new();
    for line in ORDER.lines() {
        let (first, rest) = line.split_once(" | ").unwrap_or((line, ""));
        match (first.strip_prefix("# "), subjects.last_mut()) {
            (Some(title), _) => {
                subjects.push(Subject { title, about: rest, examples: Vec::new() });
            }
            (None, Some(subject)) => subject.examples.push((first, rest)),
            (None, None) => {}
        }
    }
    subjects
}

/// Names of all example looks, scenes, shots and HCBTFs, without [`PREFIX`]. The looks and the
/// scene of a film lie with its shots, which show them.
pub fn documents() -> impl Iterator<Item = &'static str> {
    let is_shown = |(name, bytes): &&(&'static str, &'static [u8])| {
        name.ends_with(".json") && (!name.starts_with(SHOTS) || is_shot(bytes))
    };
    EXAMPLES.iter().filter(is_shown).map(|(name, _)| *name)
}

/// True if an example document is a shot, told without reading all of it.
fn is_shot(bytes: &[u8]) -> bool {
    const KIND: &[u8] = b"\"chiaro\": \"shot\"";
    bytes.windows(KIND.len()).any(|part| part == KIND)
}

/// Names of all example files, without [`PREFIX`].
pub fn names() -> impl Iterator<Item = &'static str> {
    EXAMPLES.iter().map(|(name, _)| *name)
}

/// Content of the example that `path` names; `None` where `path` names no example.
pub fn file(path: &Path) -> Option<&'static [u8]> {
    let name = name(path)?;
    EXAMPLES.iter().find(|(known, _)| *known == name).map(|(_, bytes)| *bytes)
}

/// Text of the example document that `path` names; `None` where `path` names no example. References
/// to other examples in the text get names that hold in any folder.
pub fn text(path: &Path) -> Option<String> {
    let name = name(path)?;
    let text = std::str::from_utf8(file(path)?).ok()?;
    let mut text = text.to_owned();
    for folder in ["looks", "shadows", "hcbtf", "images", "meshes", "scenes"] {
        text = text.replace(&format!("\"../{folder}/"), &format!("\"{PREFIX}{folder}/"));
    }
    // References to files beside a document, such as images.
    for (beside, _) in EXAMPLES.iter().filter(|(name, _)| !name.ends_with(".json")) {
        let name = beside.rsplit('/').next().unwrap_or(beside);
        text = text.replace(&format!("\"{name}\""), &format!("\"{PREFIX}{beside}\""));
    }
    // Shots name scenes and shots beside them, and the scene of a film its looks.
    let (folder, _) = name.rsplit_once('/').unwrap_or_default();
    let beside = documents_in(folder).filter(|_| name.starts_with(SHOTS));
    for (other, file) in beside.filter(|(other, _)| *other != name) {
        text = text.replace(&format!("\"{file}\""), &format!("\"{PREFIX}{other}\""));
    }
    Some(text)
}

/// Path of the example that `path` names, the same wherever it is named from; `None` where `path`
/// names no example.
pub fn canonical(path: &Path) -> Option<PathBuf> {
    file(path)?;
    Some(PathBuf::from(format!("{PREFIX}{}", name(path)?)))
}

/// Names of the documents of a folder, with their file names.
fn documents_in(folder: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let all = EXAMPLES.iter().map(|(name, _)| *name).filter(|name| name.ends_with(".json"));
    all.filter_map(|name| name.rsplit_once('/').map(|(of, file)| (name, of, file)))
        .filter(move |(_, of, _)| *of == folder)
        .map(|(name, _, file)| (name, file))
}

/// Name of the example in a path, without [`PREFIX`].
fn name(path: &Path) -> Option<String> {
    let mut parts: Option<Vec<&str>> = None;
    for component in path.components() {
        match (component, &mut parts) {
            (Component::Normal(part), parts) => {
                match (part.to_str()?.strip_prefix(PREFIX), parts) {
                    (Some(first), parts) => *parts = Some(vec![first]),
                    (None, Some(parts)) => parts.push(part.to_str()?),
                    (None, None) => {}
                }
            }
            (Component::ParentDir, Some(parts)) => drop(parts.pop()),
            _ => {}
        }
    }
    parts.map(|parts| parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_examples_name_is_an_example_in_any_folder() {
        let city = Path::new("/a/example:scenes/../hcbtf/city.json");
        let text = text(city).unwrap();
        assert!(text.contains("\"example:hcbtf/city.hcbtf\"") && !text.contains("\"city.hcbtf\""));
        assert!(
            file(Path::new("examples/hcbtf/city.json")).is_none()
                && file(Path::new("example:city")).is_none()
        );
        for name in documents() {
            let text = super::text(Path::new(&format!("{PREFIX}{name}"))).unwrap();
            assert!(!text.contains("\"../"), "{name}");
        }
        for (name, wanted) in [
            ("shots/evening-020.json", "\"scene\": \"example:shots/evening.json\""),
            ("shots/evening.json", "\"scene\": \"example:scenes/lit-room-day.json\""),
            ("shots/nightfall/nightfall.json", "\"example:shots/nightfall/meadow.json\""),
            ("shots/nightfall/meadow.json", "\"mesh\": \"example:shots/nightfall/hob.glb\""),
            ("shots/nightfall/meadow.json", "\"looks\": \"example:shots/nightfall/sky.json\""),
        ] {
            let text = super::text(Path::new(&format!("{PREFIX}{name}"))).unwrap();
            assert!(text.contains(wanted), "{name}: {text}");
        }
    }

    #[test]
    fn an_example_has_one_path_wherever_it_is_named_from() {
        let of = |path: &str| canonical(Path::new(path));
        let evening = Some(PathBuf::from("example:shots/evening.json"));
        assert_eq!(of("example:shots/evening.json"), evening);
        assert_eq!(of("/a/example:scenes/../shots/evening.json"), evening);
        assert_eq!(of("example:shots/example:shots/evening.json"), evening);
        assert_eq!(of("example:shots/none.json"), None);
        assert!(documents().any(|name| name == "shots/nightfall/nightfall-010.json"));
        assert!(documents().all(|name| name != "shots/nightfall/meadow.json"), "it is of the film");
    }

    #[test]
    fn every_document_has_one_subject_and_tags() {
        let subjects = subjects();
        let listed = subjects.iter().flat_map(|subject| &subject.examples);
        assert!(listed.clone().map(|(name, _)| *name).eq(documents()), "in the same order");
        assert!(listed.clone().all(|(_, tags)| !tags.is_empty()));
        assert!(subjects.iter().all(|subject| !subject.about.is_empty()));
    }
}
