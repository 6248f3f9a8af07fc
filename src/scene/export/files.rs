//! An export's files on their way into a folder.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::File;
use crate::diag::Diagnostic;
use crate::document::{read_text, write_atomic};

/// The file in `folder` that an export must not write over: the look itself, or any other JSON file in the place of the
/// description that no export has written. `None` where nothing is in the way.
pub fn in_the_way(files: &[File], folder: &Path, look: Option<&Path>) -> Option<PathBuf> {
    let own = look.and_then(|look| std::fs::canonicalize(look).ok());
    files.iter().map(|file| folder.join(&file.name)).find(|path| {
        let is_own = own.is_some() && std::fs::canonicalize(path).ok() == own;
        is_own || path.extension().is_some_and(|ending| ending == "json") && path.exists() && !is_description(path)
    })
}

/// Whether a file is a description that an export wrote, so that the next one may take its place.
fn is_description(path: &Path) -> bool {
    let Ok(Value::Object(members)) = read_text(path).map_or(Ok(Value::Null), |text| serde_json::from_str(&text)) else {
        return false;
    };
    ["chiaro", "format", "passes", "modules", "languages"].iter().all(|name| members.contains_key(*name))
}

/// Writes every file into a folder, which is made where there is none; or none, where one of them would take the place
/// of a document. Returns where they are, in the same order.
///
/// # Errors
/// What is in the way, or why a file cannot be written.
pub fn write(files: &[File], folder: &Path, look: Option<&Path>) -> Result<Vec<PathBuf>, Vec<Diagnostic>> {
    if let Err(error) = std::fs::create_dir_all(folder) {
        let problem = Diagnostic::error("cannot-write", format!("the folder cannot be made: {error}"));
        return Err(vec![problem.in_file(folder.display().to_string()).hint("choose another folder")]);
    }
    if let Some(path) = in_the_way(files, folder, look) {
        let message = "the export's description would replace this file, which no export has written";
        let problem = Diagnostic::error("would-overwrite", message);
        return Err(vec![problem.in_file(path.display().to_string()).hint("choose another folder")]);
    }
    let paths: Vec<PathBuf> = files.iter().map(|file| folder.join(&file.name)).collect();
    for (file, path) in files.iter().zip(&paths) {
        write_atomic(path, &file.bytes).map_err(|problem| vec![*problem])?;
    }
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nobodys_document_is_written_over() {
        let folder = tempfile::tempdir().unwrap();
        let description =
            r#"{"look": "Rim", "chiaro": "1", "format": 1, "passes": [], "modules": [], "languages": {}}"#;
        let files = [File::text("rim.wgsl".into(), "//".into()), File::text("rim.json".into(), description.into())];
        let inner = folder.path().join("made/too");
        for _ in 0..2 {
            let written = write(&files, &inner, None).unwrap();
            assert_eq!(written, [inner.join("rim.wgsl"), inner.join("rim.json")], "an export may be repeated");
        }
        let path = folder.path().join("rim.json");
        for text in ["{\"nodes\": []}", "not JSON", "[]", "null"] {
            std::fs::write(&path, text).unwrap();
            let problems = write(&files, folder.path(), Some(&path)).unwrap_err();
            assert_eq!(problems[0].code, "would-overwrite");
            assert_eq!(write(&files, folder.path(), None).unwrap_err().len(), 1, "whoever's it is");
            assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
            assert!(!folder.path().join("rim.wgsl").exists(), "all or nothing");
        }
    }
}
