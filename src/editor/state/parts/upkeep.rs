//! Upkeep of parts that lie in a folder: another name, another content, and their removal.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use chiaro_locale::tr;

use super::saving::{PartDraft, write};
use super::{FoundParts, Part, PartKind};
use crate::catalog::Catalog;
use crate::document::{Document, LoadedDocument, Look};
use crate::files::{Disk, TextDocument as _};

impl FoundParts {
    /// Part of a kind that has a name already, in letters of either case.
    pub(crate) fn namesake(&self, kind: PartKind, name: &str) -> Option<&Arc<Part>> {
        let name = name.trim().to_lowercase();
        let is_kind = |part: &Part| part.content.as_ref().is_ok_and(|content| content.kind == kind);
        self.parts.iter().find(|part| is_kind(part) && part.name.to_lowercase() == name)
    }
}

/// Writes a part over the file of another, whose tags and description stay where it has none.
/// `from` is the folder that the look's images are named from. Returns a sentence on what was done.
///
/// # Errors
/// The reason why the file cannot be written; it is then as it was.
pub(crate) fn replace(
    draft: &PartDraft,
    path: &Path,
    from: Option<&Path>,
    catalog: &Catalog,
) -> Result<String, String> {
    let mut draft = draft.clone();
    if let Document::Look(LoadedDocument { value: Some(old), .. }) = Document::load(&Disk, path) {
        let fields = |look: Look| [look.tags, look.about];
        let own = [&mut draft.look.tags, &mut draft.look.about];
        for (own, old) in own.into_iter().zip(fields(old)) {
            if own.trim().is_empty() {
                *own = old;
            }
        }
    }
    let mut told = write(&draft, path, from, catalog)?;
    told.insert(1, tr!("it replaces what was there").to_owned());
    Ok(told.join(" · "))
}

/// Gives a part another name. Its file keeps the name that scenes know it by. Returns a sentence
/// on what was done.
///
/// # Errors
/// The reason why the part keeps its name.
pub(crate) fn rename(part: &Part, name: &str) -> Result<String, String> {
    let name = name.trim();
    if name.is_empty() {
        return Err(tr!("Give it a name first").to_owned());
    }
    let read = match Document::load(&Disk, &part.path) {
        Document::Look(loaded) if !loaded.has_errors() => Some((loaded.value, loaded.source)),
        _ => None,
    };
    let Some((Some(mut look), source)) = read else {
        return Err(tr!("\"{part}\" cannot be read, and keeps its name", part = part.name));
    };
    name.clone_into(&mut look.name);
    look.save(&part.path, Some(&source)).map_err(|problem| problem.message)?;
    Ok(tr!("\"{part}\" is called \"{name}\" now", part = part.name))
}

/// Deletes the file of a part. Returns a sentence on what was done.
///
/// # Errors
/// The reason why the file cannot be deleted.
pub(crate) fn remove(part: &Part) -> Result<String, String> {
    match fs::remove_file(&part.path) {
        Ok(()) => Ok(tr!("\"{part}\" is removed from the library", part = part.name)),
        Err(error) => {
            let (path, why) = (part.path.display(), error.kind());
            Err(tr!("{path} cannot be deleted: {why}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{draft, found, look_of, read};
    use super::*;
    use crate::document::Value;
    use crate::state::parts::saving::{PartChoice, save};

    const RIM: &str = r#"{"name": "From", "lights": {"back": {}}, "nodes": [
        {"id": "rim", "kind": "light_layer", "name": "Rim", "values": {"light": "back"}}]}"#;

    #[test]
    fn saved_parts_are_found_by_name_replaced_renamed_and_removed() {
        let home = tempfile::tempdir().unwrap();
        let (mut look, catalog) = read(RIM);
        let layers = PartChoice::Layers(vec!["rim".into()]);
        let mut rim = draft(&look, &layers).unwrap();
        rim.look.tags = "edge".to_owned();
        save(&rim, home.path(), None, &catalog).unwrap();
        let there = found(home.path());
        let part = there.namesake(PartKind::Layer, " rim ").unwrap().clone();
        assert!(there.namesake(PartKind::Lights, "Rim").is_none());
        assert!(there.namesake(PartKind::Layer, "Rim 2").is_none());

        // What replaces a part keeps its tags, unless it has its own.
        look.graph.nodes["rim"].values.insert("opacity".into(), Value::Number(0.25));
        let again = draft(&look, &layers).unwrap();
        let told = replace(&again, &part.path, None, &catalog).unwrap();
        assert!(told.contains("it replaces what was there"), "{told}");
        let there = found(home.path());
        let [part] = &there.parts[..] else { panic!("{there:?}") };
        assert_eq!((part.name.as_str(), part.tags.as_str()), ("Rim", "edge"));
        assert!(look_of(part).graph.nodes["rim"].values.contains_key("opacity"));

        assert!(rename(part, " ").is_err());
        let told = rename(part, "Cool edge ").unwrap();
        assert_eq!(told, "\"Rim\" is called \"Cool edge\" now");
        let there = found(home.path());
        let [part] = &there.parts[..] else { panic!("{there:?}") };
        assert_eq!(part.name, "Cool edge");
        assert!(part.path.ends_with("rim.json"), "scenes may name the file");
        assert!(!there.is_read_only);

        remove(part).unwrap();
        assert!(remove(part).unwrap_err().contains("cannot be deleted"));
        assert!(rename(part, "Gone").is_err());
        assert!(found(home.path()).parts.is_empty());
    }
}
