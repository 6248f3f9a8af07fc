//! List of a gallery's documents and their order: a `gallery.json`, or the contents of folders.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::Value as Json;

use crate::diag::Diagnostic;
use crate::document::{Scene, parse_hex, read_text};
use crate::examples;
use crate::files::{Files, WalkBounds};
use crate::frame::{PlacementError, SHAPE_PREFIX, place_camera, turn_lights};

/// Name of the file in a folder that lists the documents of its gallery.
pub const LIST_FILE: &str = "gallery.json";
/// Largest number of entries that are read.
const MOST: usize = 2000;
/// Bounds of the walk through a folder: each folder in it is a section.
const BOUNDS: WalkBounds = WalkBounds { depth: 1, entries: 10 * MOST };

/// Documents of a gallery, in sections.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct List {
    /// Title above all sections.
    pub title: String,
    /// Paragraph below the title.
    pub about: String,
    /// Sections, in order.
    pub sections: Vec<Section>,
}

/// A row of pictures under a title.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// Title of the section.
    pub title: String,
    /// Paragraph below the title.
    pub about: String,
    /// Documents, in order.
    pub shown: Vec<GalleryDocument>,
}

/// A document, and how it is shown: mesh, backdrop, name, camera, lights and time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GalleryDocument {
    /// Path of a look or a scene.
    pub file: PathBuf,
    /// A mesh, named from the working folder, or an own shape for a look; by default the look's
    /// usual one.
    pub mesh: Option<String>,
    /// Backdrop, straight RGBA in display colors; by default the document's own.
    pub backdrop: Option<[f64; 4]>,
    /// Name in the gallery; by default the document's own.
    pub name: Option<String>,
    /// Placement of the camera, as [`place_camera`] reads it; by default the document's own.
    pub camera: Option<String>,
    /// Turn of all lights, as [`turn_lights`] reads it; by default none.
    pub lights: Option<String>,
    /// Time of the picture, in seconds; by default the document's first moment.
    pub time: Option<f64>,
}

impl GalleryDocument {
    /// Places a scene's camera and turns its lights as the list says.
    ///
    /// # Errors
    /// A camera or lights that cannot be read so.
    pub(super) fn place(&self, scene: &mut Scene) -> Result<(), Diagnostic> {
        let bad = |what: &str, wrong: PlacementError| {
            let message = format!("{what} of {} cannot be `{}`", self.file.display(), wrong.found);
            Diagnostic::error("bad-gallery", message).hint(format!("write {}", wrong.wanted))
        };
        if let Some(text) = &self.camera {
            scene.file_camera = None;
            place_camera(&mut scene.camera, text).map_err(|wrong| bad("the camera", wrong))?;
        }
        if let Some(text) = &self.lights {
            turn_lights(scene, text).map_err(|wrong| bad("turn_lights", wrong))?;
        }
        Ok(())
    }
}

/// JSON of a `gallery.json`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ListText {
    #[serde(default)]
    title: String,
    #[serde(default)]
    about: String,
    sections: Vec<SectionText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SectionText {
    #[serde(default)]
    title: String,
    #[serde(default)]
    about: String,
    #[serde(deserialize_with = "entries_text")]
    entries: Vec<EntryText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EntryText {
    file: PathBuf,
    mesh: Option<String>,
    backdrop: Option<String>,
    name: Option<String>,
    camera: Option<String>,
    turn_lights: Option<String>,
    time: Option<f64>,
}

/// Entries, each a path or an object; told apart here and not by serde's untagged enums, so that an
/// error names the field that is wrong.
fn entries_text<'de, D: Deserializer<'de>>(entries: D) -> Result<Vec<EntryText>, D::Error> {
    let entry = |entry: Json| {
        let more = if entry.is_string() { serde_json::json!({ "file": entry }) } else { entry };
        serde_json::from_value(more).map_err(D::Error::custom)
    };
    Vec::<Json>::deserialize(entries)?.into_iter().map(entry).collect()
}

/// List of the examples that the program brings along, which needs no folder.
///
/// # Errors
/// No errors, as a test makes sure.
pub fn examples() -> Result<List, Vec<Diagnostic>> {
    let in_examples =
        |file: &Path| PathBuf::from(format!("{}{}", examples::PREFIX, file.display()));
    parsed(examples::GALLERY, Path::new(LIST_FILE), &in_examples).map_err(|one| vec![one])
}

/// The list of files and folders: a folder's `gallery.json` if it has one, else its looks and
/// scenes by name, and those of the folders in it, a section each.
///
/// # Errors
/// Paths that do not exist, a `gallery.json` that cannot be read, and a list without documents.
pub fn list(files: &dyn Files, paths: &[PathBuf]) -> Result<List, Vec<Diagnostic>> {
    let mut all = List { title: "Gallery".to_owned(), ..List::default() };
    let mut own = Section::default();
    let mut problems = Vec::new();
    for path in paths {
        if !files.is_folder(path) {
            own.shown.push(GalleryDocument { file: path.clone(), ..GalleryDocument::default() });
            continue;
        }
        match of_folder(files, path) {
            Ok(found) => {
                if paths.len() == 1 {
                    (all.title, all.about) = (found.title, found.about);
                }
                all.sections.extend(found.sections);
            }
            Err(problem) => problems.push(problem),
        }
    }
    if !own.shown.is_empty() {
        all.sections.insert(0, own);
    }
    let missing = all
        .sections
        .iter()
        .flat_map(|section| &section.shown)
        .filter(|shown| !files.has_file(&shown.file));
    problems.extend(missing.map(|shown| {
        let problem = Diagnostic::error("missing-file", "there is no such file");
        problem.in_file(shown.file.display().to_string())
    }));
    let count: usize = all.sections.iter().map(|section| section.shown.len()).sum();
    if count > MOST {
        problems.push(
            Diagnostic::error(
                "too-many",
                format!("a gallery shows {MOST} documents at most, and these are {count}"),
            )
            .hint("make several galleries of them"),
        );
    }
    if count == 0 && problems.is_empty() {
        problems.push(
            Diagnostic::error("nothing-to-show", "there is neither a look nor a scene")
                .hint("name looks, scenes, or a folder that holds some"),
        );
    }
    if problems.is_empty() { Ok(all) } else { Err(problems) }
}

fn of_folder(files: &dyn Files, folder: &Path) -> Result<List, Diagnostic> {
    let file = folder.join(LIST_FILE);
    if files.has_file(&file) {
        return read(files, &file);
    }
    let section = |(inner, shown): (PathBuf, Vec<GalleryDocument>)| {
        let title = if inner == folder { String::new() } else { name_of(files, &inner) };
        Section { title, shown, ..Section::default() }
    };
    let sections = documents(files, folder)?.into_iter().map(section).collect();
    Ok(List { title: name_of(files, folder), sections, ..List::default() })
}

fn read(files: &dyn Files, file: &Path) -> Result<List, Diagnostic> {
    let text = read_text(files, file).map_err(|problem| *problem)?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut list = parsed(&text, file, &|named| folder.join(named))?;
    if list.title.is_empty() {
        list.title = name_of(files, folder);
    }
    Ok(list)
}

/// The list in `text`, the content of `file`; `place` tells the path of each file that the list
/// names.
fn parsed(text: &str, file: &Path, place: &dyn Fn(&Path) -> PathBuf) -> Result<List, Diagnostic> {
    let list_file = file.display().to_string();
    let bad =
        |message: String| Diagnostic::error("bad-gallery", message).in_file(list_file.clone());
    let list: ListText =
        serde_json::from_str(text).map_err(|error| {
            bad(error.to_string())
            .hint(
                "write {\"title\", \"about\", \"sections\": [{\"title\", \"about\", \"entries\": \
                 [\"look.json\"]}]}"
            )
            .hint("an entry may say more: \
                   {\"file\", \"name\", \"mesh\", \"backdrop\", \"camera\", \"turn_lights\", \
                   \"time\"}")
        })?;
    let color = |file: &Path, text: String| {
        let told = || bad(format!("the backdrop `{text}` of {} is no color", file.display()));
        parse_hex(&text).ok_or_else(|| told().hint("write it as #f2ead8"))
    };
    let mesh_of = |name: String| {
        let is_own_shape = name.starts_with(SHAPE_PREFIX);
        if is_own_shape { name } else { place(Path::new(&name)).display().to_string() }
    };
    let shown = |entry: EntryText| {
        let EntryText { file, mesh, backdrop, name, camera, turn_lights: lights, time } = entry;
        let backdrop = backdrop.map(|text| color(&file, text)).transpose()?;
        let shown = GalleryDocument {
            file: place(&file),
            mesh: mesh.map(mesh_of),
            backdrop,
            name,
            camera,
            lights,
            time,
        };
        // Placements are tried here, so that errors are told before anything is drawn.
        shown.place(&mut Scene::default()).map_err(|problem| problem.in_file(list_file.clone()))?;
        Ok(shown)
    };
    let section = |section: SectionText| {
        let shown = section.entries.into_iter().map(shown).collect::<Result<_, Diagnostic>>()?;
        Ok(Section { title: section.title, about: section.about, shown })
    };
    let sections = list.sections.into_iter().map(section).collect::<Result<_, Diagnostic>>()?;
    Ok(List { title: list.title, about: list.about, sections })
}

/// The documents in a folder, and in the folders in it, by folder and name.
fn documents(
    files: &dyn Files,
    folder: &Path,
) -> Result<BTreeMap<PathBuf, Vec<GalleryDocument>>, Diagnostic> {
    let found = files.walk(folder, BOUNDS, &|_| true);
    if let Some((path, error)) = found.unreadable.first() {
        let problem =
            Diagnostic::error("cannot-read", format!("the folder cannot be read: {error}"));
        return Err(problem.in_file(path.display().to_string()));
    }
    let is_document = |path: &PathBuf| {
        let is_json =
            path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"));
        is_json && path.file_name().is_some_and(|name| name != LIST_FILE)
    };
    let mut documents: BTreeMap<PathBuf, Vec<GalleryDocument>> = BTreeMap::new();
    for file in found.files.into_iter().filter(is_document) {
        let inner = file.parent().unwrap_or(folder).to_path_buf();
        let shown = GalleryDocument { file, ..GalleryDocument::default() };
        documents.entry(inner).or_default().push(shown);
    }
    Ok(documents)
}

/// A folder's name, as a title.
fn name_of(files: &dyn Files, folder: &Path) -> String {
    let whole = files.canonical(folder).unwrap_or_else(|| folder.to_path_buf());
    let name = whole
        .file_name()
        .map(|name| name.to_string_lossy().replace(['-', '_'], " "))
        .unwrap_or_default();
    let mut letters = name.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::Disk;

    #[test]
    fn folders_become_sections() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str| {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "{}").unwrap();
        };
        ["b.json", "a.json", "more-looks/c.json", "more-looks/c.png", "empty/nothing.txt"]
            .into_iter()
            .for_each(write);
        let found = list(&Disk, &[folder.path().to_path_buf()]).unwrap();
        let titles: Vec<&str> =
            found.sections.iter().map(|section| section.title.as_str()).collect();
        assert_eq!(titles, ["", "More looks"]);
        let names: Vec<_> =
            found.sections[0].shown.iter().map(|shown| shown.file.file_name().unwrap()).collect();
        assert_eq!(names, ["a.json", "b.json"]);
    }

    #[test]
    fn a_list_says_what_and_on_what() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.json"), "{}").unwrap();
        let path = folder.path().join(LIST_FILE);
        let text = r##"{"title": "T", "sections": [{"title": "S", "entries": ["a.json",
            {"file": "a.json", "mesh": "shape:knot", "backdrop": "#ffffff"}]}]}"##;
        std::fs::write(&path, text).unwrap();
        let found = list(&Disk, &[folder.path().to_path_buf()]).unwrap();
        let [plain, with] = found.sections[0].shown.as_slice() else { panic!("{found:?}") };
        assert_eq!(
            (found.title.as_str(), plain.mesh.as_deref(), plain.backdrop),
            ("T", None, None)
        );
        assert_eq!((with.mesh.as_deref(), with.backdrop), (Some("shape:knot"), Some([1.0; 4])));

        std::fs::write(&path, text.replace("entries", "entrys")).unwrap();
        let problems = list(&Disk, &[folder.path().to_path_buf()]).unwrap_err();
        assert!(
            problems[0].message.contains("entrys") && problems[0].to_string().contains(LIST_FILE),
            "{problems:?}"
        );
        std::fs::write(&path, text.replace("#ffffff", "white")).unwrap();
        let problems = list(&Disk, &[folder.path().to_path_buf()]).unwrap_err();
        assert!(
            problems[0].code == "bad-gallery" && problems[0].message.contains("`white`"),
            "{problems:?}"
        );
        std::fs::write(&path, text.replace("\"a.json\", ", "\"b.json\", ")).unwrap();
        assert_eq!(
            list(&Disk, &[folder.path().to_path_buf()]).unwrap_err()[0].code,
            "missing-file"
        );
        std::fs::write(&path, text.replace("backdrop", "backdrp")).unwrap();
        let problems = list(&Disk, &[folder.path().to_path_buf()]).unwrap_err();
        assert!(problems[0].message.contains("`backdrp`"), "{problems:?}");

        // A mesh of the user's own lies beside the list.
        std::fs::write(&path, text.replace("shape:knot", "own.obj")).unwrap();
        let found = list(&Disk, &[folder.path().to_path_buf()]).unwrap();
        let own = folder.path().join("own.obj").display().to_string();
        assert_eq!(found.sections[0].shown[1].mesh.as_ref(), Some(&own));
        assert_eq!(list(&Disk, &[]).unwrap_err()[0].code, "nothing-to-show");
    }

    #[test]
    fn a_list_says_from_where_and_when() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.json"), "{}").unwrap();
        let path = folder.path().join(LIST_FILE);
        let text = r##"{"sections": [{"entries": [{"file": "a.json", "name": "Dusk",
            "camera": "orbit=60,10",
            "turn_lights": "180", "time": 2.5}]}]}"##;
        std::fs::write(&path, text).unwrap();
        let found = list(&Disk, &[folder.path().to_path_buf()]).unwrap();
        let shown = &found.sections[0].shown[0];
        assert_eq!((shown.name.as_deref(), shown.time), (Some("Dusk"), Some(2.5)));
        assert_eq!(
            (shown.camera.as_deref(), shown.lights.as_deref()),
            (Some("orbit=60,10"), Some("180"))
        );
        for (right, wrong) in [("orbit=60,10", "orbit=60"), ("\"180\"", "\"round\"")] {
            std::fs::write(&path, text.replace(right, wrong)).unwrap();
            let problems = list(&Disk, &[folder.path().to_path_buf()]).unwrap_err();
            let is_told = problems[0].message.contains(wrong.trim_matches('"'))
                && problems[0].message.contains("a.json");
            assert!(problems[0].code == "bad-gallery" && is_told, "{problems:?}");
        }
    }

    #[test]
    fn the_examples_are_shown_without_a_folder() {
        let found = examples().unwrap();
        let shown: Vec<&PathBuf> =
            found.sections.iter().flat_map(|section| &section.shown).map(|s| &s.file).collect();
        assert!(!shown.is_empty());
        for file in shown {
            assert!(examples::file(file).is_some(), "{}", file.display());
        }
    }
}
