//! Writing of an export's files into a folder.

use std::path::{Path, PathBuf};

use chiaro_locale::{text, tr};
use serde_json::Value;

use super::ExportFile;
use crate::diag::Diagnostic;
use crate::files::{OutputKind, Outputs, make_folder, read_text};

/// The first file in `folder` that an export must not overwrite: one that the export reads, or one
/// that no export has written. `None` if the way is free.
pub fn in_the_way(files: &[ExportFile], folder: &Path, outputs: &Outputs) -> Option<PathBuf> {
    check(files, folder, outputs).err().and_then(|problem| problem.place.file).map(PathBuf::from)
}

/// Checks that an export's files may be written into a folder.
///
/// # Errors
/// As [`Outputs::check`], for the first file that may not.
fn check(files: &[ExportFile], folder: &Path, outputs: &Outputs) -> Result<(), Diagnostic> {
    let earlier = EarlierDescriptions::of(files, folder);
    files.iter().try_for_each(|file| {
        earlier.with_kind(file, |kind| outputs.check(&folder.join(&file.name), kind))
    })
}

/// Texts of the descriptions of earlier exports in a folder.
struct EarlierDescriptions(Vec<String>);

impl EarlierDescriptions {
    fn of(files: &[ExportFile], folder: &Path) -> Self {
        let descriptions =
            files.iter().map(|file| folder.join(&file.name)).filter(|path| is_description(path));
        Self(descriptions.filter_map(|path| read_text(&path).ok()).collect())
    }

    /// Calls `then` with the kind of a file. A file of an earlier export is known by the comment
    /// that it begins with; a file in a format without comments, by the description that names it.
    fn with_kind<T>(&self, file: &ExportFile, then: impl FnOnce(OutputKind<'_>) -> T) -> T {
        let quoted = serde_json::Value::from(file.name.as_str()).to_string();
        let is_description_file = file.name.ends_with(".json");
        let is_own = |bytes: &[u8]| {
            let text = String::from_utf8_lossy(&bytes[..bytes.len().min(HEAD)]);
            let has_header = text.lines().take(10).any(|line| line.contains(": made by Chiaro "));
            let is_named = || self.0.iter().any(|description| description.contains(&quoted));
            if is_description_file {
                describes(bytes) || is_named()
            } else {
                has_header || is_named()
            }
        };
        then(OutputKind {
            name: text!("a file of an export").english(),
            is_own: &is_own,
            has_seal: false,
        })
    }
}

/// Length of the beginning of a file that is searched for the comment, in bytes.
const HEAD: usize = 4096;

/// True if a file is a description that an export wrote, so that the next export may replace it.
fn is_description(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "json")
        && read_text(path).is_ok_and(|text| describes(text.as_bytes()))
}

fn describes(text: &[u8]) -> bool {
    let Ok(Value::Object(members)) = serde_json::from_slice(text) else { return false };
    let has_all = |names: &[&str]| names.iter().all(|name| members.contains_key(*name));
    has_all(&["chiaro", "format", "passes", "modules", "languages"])
        || has_all(&["chiaro", "package", "tiers", "files"])
}

/// Writes all files into a folder, which is made if there is none; or no file, where one of them
/// would replace a file that somebody made. All files appear at once, the description last. Returns
/// their paths, in the order of `files`.
///
/// # Errors
/// The file that is in the way, or the reason why a file cannot be written.
pub fn write(
    files: &[ExportFile],
    folder: &Path,
    outputs: &mut Outputs,
) -> Result<Vec<PathBuf>, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    make_folder(folder).map_err(|problem| one(problem.hint(tr!("choose another folder"))))?;
    check(files, folder, outputs).map_err(one)?;
    let earlier = EarlierDescriptions::of(files, folder);
    let (last, first): (Vec<_>, Vec<_>) =
        files.iter().partition(|file| file.name.ends_with(".json"));
    for file in first.into_iter().chain(last) {
        let path = folder.join(&file.name);
        if let Some(inner) = path.parent().filter(|inner| *inner != folder) {
            make_folder(inner).map_err(|problem| one(*problem))?;
        }
        earlier.with_kind(file, |kind| outputs.add(&path, kind, &file.bytes)).map_err(one)?;
    }
    outputs.commit().map_err(one)?;
    Ok(files.iter().map(|file| folder.join(&file.name)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nobodys_document_is_written_over() {
        let folder = tempfile::tempdir().unwrap();
        let description = r#"{"look": "Rim", "chiaro": "1", "format": 1, "passes": [],
            "modules": [], "languages": {}}"#;
        let files = [
            ExportFile::text("rim.wgsl".into(), SHADER.into()),
            ExportFile::text("rim.json".into(), description.into()),
        ];
        let inner = folder.path().join("made/too");
        for _ in 0..2 {
            let written = write(&files, &inner, &mut Outputs::new(false)).unwrap();
            assert_eq!(
                written,
                [inner.join("rim.wgsl"), inner.join("rim.json")],
                "an export may be repeated"
            );
        }
        let path = folder.path().join("rim.json");
        for text in ["{\"nodes\": []}", "not JSON", "[]", "null"] {
            std::fs::write(&path, text).unwrap();
            let mut own = Outputs::new(true);
            own.reads(&path);
            let problems = write(&files, folder.path(), &mut own).unwrap_err();
            assert_eq!(problems[0].code, "would-overwrite");
            let nobodys = &mut Outputs::new(false);
            assert_eq!(
                write(&files, folder.path(), nobodys).unwrap_err().len(),
                1,
                "whoever's it is"
            );
            assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
            assert!(!folder.path().join("rim.wgsl").exists(), "all or nothing");
        }
    }

    const SHADER: &str = "// Rim: made by Chiaro 0.1.0, WGSL.\n";

    #[test]
    fn a_shader_that_somebody_wrote_is_not_written_over() {
        let folder = tempfile::tempdir().unwrap();
        let description = r#"{"chiaro": "1", "format": 1, "passes": [],
            "modules": [{"file": "rim.spv"}], "languages": {}}"#;
        let files = [
            ExportFile::text("rim.wgsl".into(), SHADER.into()),
            ExportFile { name: "rim.spv".into(), bytes: vec![3, 2, 35, 7] },
            ExportFile::text("rim.json".into(), description.into()),
        ];
        let path = |name: &str| folder.path().join(name);
        for name in ["rim.wgsl", "rim.spv"] {
            std::fs::write(path(name), "fn mine() {}").unwrap();
            let problems = write(&files, folder.path(), &mut Outputs::new(false)).unwrap_err();
            assert_eq!(problems[0].code, "file-exists", "{problems:?}");
            assert_eq!(in_the_way(&files, folder.path(), &Outputs::new(false)), Some(path(name)));
            assert_eq!(std::fs::read_to_string(path(name)).unwrap(), "fn mine() {}");
            assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "all or nothing");
            std::fs::remove_file(path(name)).unwrap();
        }
        write(&files, folder.path(), &mut Outputs::new(false)).unwrap();
        // Another version of Chiaro writes another text, and other words of SPIR-V: the description
        // names the files.
        std::fs::write(path("rim.wgsl"), "// Rim: made by Chiaro 0.0.9, WGSL.\n").unwrap();
        std::fs::write(path("rim.spv"), [3, 2, 35, 8]).unwrap();
        write(&files, folder.path(), &mut Outputs::new(false)).unwrap();
        assert_eq!(std::fs::read(path("rim.spv")).unwrap(), [3, 2, 35, 7]);
    }
}
