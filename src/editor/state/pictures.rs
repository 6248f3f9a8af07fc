//! Pictures that the window itself writes beside a look: new masks, their strokes, and copies.
//!
//! The step of the look that brought a picture takes its file along when it is taken back, as long
//! as the file is as it came, and brings it again when it is repeated. Once the look is saved, its
//! file may name the picture, so that undo leaves it where it is.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::document::{Look, Value};
use crate::files::{Disk, FileMetadata, Files as _, WalkBounds, shortened, write_atomic};
use crate::state::paths::absolute;
use crate::state::shelf;

/// Largest picture that undo takes away, in bytes: it is kept for redo.
const MOST_BYTES: usize = 4 << 20;
/// Largest number of pictures that undo takes away.
const MOST: usize = 64;
/// Largest numbers of entries beside a look, and of documents there, that are searched for the
/// name of a picture.
const MOST_ENTRIES: usize = 2000;
const MOST_DOCUMENTS: usize = 200;
/// Largest document that is searched, in bytes.
const MOST_TEXT: u64 = 4 << 20;

/// Picture that is about to be written beside a look, or a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct CarriedPicture {
    /// Name of the file.
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
}

/// Picture that came with a step of the look.
#[derive(Debug)]
struct BroughtPicture {
    file: PathBuf,
    bytes: Vec<u8>,
    /// True while its step is taken back, and the file with it.
    is_away: bool,
}

/// Pictures that the window wrote.
#[derive(Debug, Default)]
pub(crate) struct OwnPictures {
    brought: Vec<BroughtPicture>,
    /// States of files as the window left them.
    states: BTreeMap<PathBuf, FileMetadata>,
}

impl OwnPictures {
    /// Writes a picture.
    ///
    /// # Errors
    /// A diagnostic that names the file; the old one is then as it was.
    pub(crate) fn write(&mut self, file: &Path, bytes: &[u8]) -> Result<(), Box<Diagnostic>> {
        write_atomic(file, bytes)?;
        self.states.extend(Disk.metadata(file).map(|state| (absolute(file), state)));
        Ok(())
    }

    /// Writes a picture for a step of the look that is about to be done.
    ///
    /// # Errors
    /// A diagnostic that names the file.
    pub(crate) fn bring(&mut self, file: &Path, bytes: Vec<u8>) -> Result<(), Box<Diagnostic>> {
        self.write(file, &bytes)?;
        self.brought.retain(|other| other.file != file);
        if bytes.len() <= MOST_BYTES {
            if self.brought.len() >= MOST {
                self.brought.remove(0);
            }
            self.brought.push(BroughtPicture { file: file.to_owned(), bytes, is_away: false });
        }
        Ok(())
    }

    /// Takes pictures away that none of the looks in a folder names any longer, and brings them
    /// again where one does once more. Returns true if a file came or went.
    ///
    /// # Errors
    /// A diagnostic that names the file that does not come back.
    pub(crate) fn follow(
        &mut self,
        looks: &[&Look],
        folder: &Path,
    ) -> Result<bool, Box<Diagnostic>> {
        let (mut has_changed, mut back) = (false, Vec::new());
        for picture in &mut self.brought {
            let is_there = Disk.metadata(&picture.file).is_some();
            let is_named = looks.iter().any(|look| names(look, folder, &picture.file));
            match (is_named, picture.is_away) {
                (true, true) => {
                    picture.is_away = false;
                    if !is_there {
                        back.push((picture.file.clone(), picture.bytes.clone()));
                    }
                }
                (false, false) if is_there => {
                    let most = picture.bytes.len() as u64;
                    let is_same =
                        Disk.read(&picture.file, most).is_ok_and(|bytes| bytes == picture.bytes);
                    picture.is_away = is_same && std::fs::remove_file(&picture.file).is_ok();
                    has_changed |= picture.is_away;
                }
                _ => {}
            }
        }
        for (file, bytes) in back {
            self.write(&file, &bytes)?;
            has_changed = true;
        }
        Ok(has_changed)
    }

    /// Lets all pictures stay: a file names them.
    pub(crate) fn settle(&mut self) {
        self.brought.clear();
    }

    /// True if a file is as the window itself wrote it; `file` is its path from the root.
    pub(crate) fn is_own(&self, file: &Path, state: Option<FileMetadata>) -> bool {
        state.is_some() && self.states.get(file).copied() == state
    }
}

/// True if a look in a folder names a file.
fn names(look: &Look, folder: &Path, file: &Path) -> bool {
    let groups = look.definitions.values().map(|definition| &definition.graph);
    let graphs = std::iter::once(&look.graph).chain(groups);
    let mut values = graphs.flat_map(|graph| graph.nodes.values()).flat_map(|n| n.values.values());
    values.any(
        |value| matches!(value, Value::Text(text) if !text.is_empty() && folder.join(text) == file),
    )
}

/// A name that no file of a folder has: a stem and an ending, with a number where need be.
/// `is_taken` refuses further ones.
///
/// # Errors
/// A diagnostic where a thousand names are taken.
pub(crate) fn free_name(
    folder: &Path,
    (stem, end): (&str, &str),
    is_taken: impl Fn(&str) -> bool,
) -> Result<String, Box<Diagnostic>> {
    let numbered = (2..1000).map(|number| format!("{stem}-{number}{end}"));
    let mut all = std::iter::once(format!("{stem}{end}")).chain(numbered);
    all.find(|name| Disk.metadata(&folder.join(name)).is_none() && !is_taken(name)).ok_or_else(
        || {
            let problem = tr!("there are too many pictures of that name in the folder");
            Box::new(Diagnostic::error("no-name", problem).in_file(folder.display().to_string()))
        },
    )
}

/// True if a file lies in a folder, or in one below it, by the letters of their paths.
pub(crate) fn is_within(folder: &Path, file: &Path) -> bool {
    let whole = |path: &Path| shortened(&absolute(path));
    whole(file).starts_with(whole(folder))
}

/// True if another document may show a picture that a look names: the picture lies elsewhere, or a
/// document beside the look names it, too. The look's own snapshots do not count.
pub(crate) fn is_shared(look: &Path, picture: &str) -> bool {
    let folder = look.parent().unwrap_or(Path::new(""));
    let file = folder.join(picture);
    if !is_within(folder, &file) {
        return true;
    }
    let Some(name) = file.file_name().map(|name| format!("{}\"", name.to_string_lossy())) else {
        return false;
    };
    let own = [look.to_owned(), shelf::file_of(look)].map(|path| absolute(&path));
    let bounds = WalkBounds { depth: 0, entries: MOST_ENTRIES };
    let found = Disk.walk(&absolute(folder), bounds, &|_| false);
    let is_document =
        |path: &&PathBuf| path.extension().is_some_and(|end| end == "json") && !own.contains(path);
    found.files.iter().filter(is_document).take(MOST_DOCUMENTS).any(|path| {
        let text = Disk.read(path, MOST_TEXT).unwrap_or_default();
        let text = String::from_utf8_lossy(&text);
        text.match_indices(&name).any(|(at, _)| text[..at].ends_with(['"', '/', '\\']))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_shared_with_documents_beside_the_look_that_name_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let write = |name: &str, text: &str| std::fs::write(path(name), text).unwrap();
        let look = path("a.json");
        write("a.json", r#"{"image": "m.png"}"#);
        write("a.snapshots.json", r#"{"image": "m.png"}"#);
        write("b.json", r#"{"image": "other-m.png", "note": "m.png is a mask"}"#);
        assert!(!is_shared(&look, "m.png") && !is_shared(&look, "masks/m.png"));
        assert!(is_shared(&look, "../m.png"), "it lies elsewhere");
        assert!(is_shared(&look, &path("../m.png").display().to_string()));
        write("b.json", r#"{"image": "./m.png"}"#);
        assert!(is_shared(&look, "m.png"));
    }

    #[test]
    fn free_names_count_up() {
        let folder = tempfile::tempdir().unwrap();
        let name = |taken: &str| {
            free_name(folder.path(), ("a-mask", ".png"), |name| name == taken).unwrap()
        };
        assert_eq!((name(""), name("a-mask.png")), ("a-mask.png".into(), "a-mask-2.png".into()));
        std::fs::write(folder.path().join("a-mask.png"), "").unwrap();
        assert_eq!(name("a-mask-2.png"), "a-mask-3.png");
    }
}
