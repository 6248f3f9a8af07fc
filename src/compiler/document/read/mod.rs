//! Reading of documents: text to value, with all problems reported at once.
//!
//! The parser makes a tree with a place for every value, [`Reader`](reader::Reader) takes typed
//! values out of the tree, and the [descriptions](super::described) of objects give their fields.

mod lists;
pub(super) mod reader;
mod value;

use std::path::Path;
use std::sync::Arc;

use super::described::{Codec as _, DescribedObject, FieldType, PlainCodec};
use super::json::JsonWriter;
use super::json::{self, JsonKind, ValueIndex};
use super::problems::{LineIndex, Problems};
use super::shape::{FieldKind, ObjectShape};
use super::source::{LoadedDocument, SourceMap};
use super::{HcbtfListing, HcbtfManifest, Look, Scene, Shot, UnknownFields, VERSION, read_text};
use crate::diag::Diagnostic;
use crate::files::Files;
use chiaro_locale::{text, tr};
use reader::{PathStep, Reader, with_article};
pub(super) use value::AxisAngle;

/// Document of a file: a look, a scene or a shot.
#[derive(Clone, Debug)]
pub enum Document {
    /// Look, with its source and diagnostics.
    Look(LoadedDocument<Look>),
    /// Scene, with its source and diagnostics.
    Scene(LoadedDocument<Scene>),
    /// Shot, with its source and diagnostics.
    Shot(LoadedDocument<Shot>),
}

impl Document {
    /// Reads a text that may hold any of them: a scene where the text says so or has `objects`, a
    /// shot where the text says so or names a `scene`, otherwise a look.
    pub fn read(text: &str, file: &str) -> Self {
        let parsed = ParsedText::new(text, file);
        match parsed.kind() {
            Some("scene") => Self::Scene(parsed.scene()),
            Some("shot") => Self::Shot(parsed.shot()),
            _ => Self::Look(parsed.look()),
        }
    }

    /// Reads a file that may hold any of them. Where the file cannot be read, the diagnostics of a
    /// look say why.
    pub fn load(files: &dyn Files, path: &Path) -> Self {
        match read_text(files, path) {
            Ok(text) => Self::read(&text, &path.display().to_string()),
            Err(problem) => Self::Look(failed(path, *problem)),
        }
    }

    /// Problems of the document.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        match self {
            Self::Look(look) => &look.diagnostics,
            Self::Scene(scene) => &scene.diagnostics,
            Self::Shot(shot) => &shot.diagnostics,
        }
    }
}

impl Look {
    /// Reads a look from JSON; `file` is its name in diagnostics. See docs/format.md.
    pub fn read(text: &str, file: &str) -> LoadedDocument<Self> {
        ParsedText::new(text, file).look()
    }

    /// Problems of the text itself, whether or not the names in it exist.
    pub(super) fn read_alone(text: &str) -> Vec<Diagnostic> {
        ParsedText::new(text, "").read::<Self>().diagnostics
    }

    /// Reads a look from a file.
    pub fn load(files: &dyn Files, path: &Path) -> LoadedDocument<Self> {
        match read_text(files, path) {
            Ok(text) => Self::read(&text, &path.display().to_string()),
            Err(problem) => failed(path, *problem),
        }
    }
}

impl Scene {
    /// Reads a scene from JSON; `file` is its name in diagnostics. See docs/format.md.
    pub fn read(text: &str, file: &str) -> LoadedDocument<Self> {
        ParsedText::new(text, file).scene()
    }

    /// Reads a scene from a file.
    pub fn load(files: &dyn Files, path: &Path) -> LoadedDocument<Self> {
        match read_text(files, path) {
            Ok(text) => Self::read(&text, &path.display().to_string()),
            Err(problem) => failed(path, *problem),
        }
    }
}

impl Shot {
    /// Reads a shot from JSON; `file` is its name in diagnostics. See docs/format.md.
    pub fn read(text: &str, file: &str) -> LoadedDocument<Self> {
        ParsedText::new(text, file).shot()
    }

    /// Reads a shot from a file.
    pub fn load(files: &dyn Files, path: &Path) -> LoadedDocument<Self> {
        match read_text(files, path) {
            Ok(text) => Self::read(&text, &path.display().to_string()),
            Err(problem) => failed(path, *problem),
        }
    }
}

impl HcbtfManifest {
    /// Reads the manifest of an `.hcbtf` file from JSON; `file` is its name in diagnostics.
    pub fn read(text: &str, file: &str) -> LoadedDocument<Self> {
        with_structure(ParsedText::new(text, file).read(), Self::check)
    }
}

impl HcbtfListing {
    /// Reads the listing of a folder of images from JSON; `file` is its name in diagnostics.
    pub fn read(text: &str, file: &str) -> LoadedDocument<Self> {
        with_structure(ParsedText::new(text, file).read(), Self::check)
    }
}

/// Reads a list that is a part of a document; `name` is the name of the list in diagnostics.
pub(super) fn read_list<T: FieldType>(
    text: &str,
    file: &str,
    name: &'static str,
    kind: &'static FieldKind,
    check: impl Fn(&(T, UnknownFields)) -> Vec<Diagnostic>,
) -> LoadedDocument<(T, UnknownFields)> {
    let mut parsed = ParsedText::new(text, file);
    let value = parsed.value(name, kind);
    with_structure(parsed.loaded(value), check)
}

/// Checks a value by the bounds of its kind: the value is written and read again, so that it obeys
/// every bound of files.
///
/// # Errors
/// A message that names the first wrong field and its bounds.
pub(super) fn check_value<T: FieldType>(value: &T, kind: &'static FieldKind) -> Result<(), String> {
    let mut writer = JsonWriter::trial();
    value.write(&mut writer, None);
    let mut parsed = ParsedText::new(&writer.finish(), "");
    let read: Option<(T, UnknownFields)> = parsed.value("", kind);
    let problems = parsed.loaded(read).diagnostics;
    let Some(problem) = problems.into_iter().find(Diagnostic::is_error) else { return Ok(()) };
    let hint = problem.hints.first().map(|hint| format!(": {hint}")).unwrap_or_default();
    let message = format!("{}{hint}", problem.message);
    Err(match problem.place.json_path {
        Some(path) => format!("`{}`: {message}", path.trim_start_matches('.')),
        None => message,
    })
}

/// Reads a document without the problems that it has as a whole.
pub(super) fn read_unchecked<T: DescribedObject>(text: &str) -> LoadedDocument<T> {
    ParsedText::new(text, "").read()
}

/// Result for a file that could not be read.
fn failed<T>(path: &Path, problem: Diagnostic) -> LoadedDocument<T> {
    let file = path.display().to_string();
    let lines = LineIndex::new("");
    let tree = json::parse(&Arc::from(""), &lines, &mut Problems::new());
    let source = SourceMap { file, lines, tree, kept: Default::default() };
    LoadedDocument { value: None, source, diagnostics: vec![problem] }
}

/// Parsed text before it becomes a look, a scene or a shot.
struct ParsedText {
    source: SourceMap,
    problems: Problems,
}

impl ParsedText {
    fn new(text: &str, file: &str) -> Self {
        let mut problems = Problems::new();
        let lines = LineIndex::new(text);
        let tree = json::parse(&Arc::from(text), &lines, &mut problems);
        Self {
            source: SourceMap { file: file.to_owned(), lines, tree, kept: Default::default() },
            problems,
        }
    }

    /// Kind that the document names, or else seems to be.
    fn kind(&self) -> Option<&'static str> {
        let tree = &self.source.tree;
        let root = tree.root()?;
        let has = |name| tree.member(root, name).is_some();
        let said = tree.member(root, "chiaro").and_then(|at| tree.string(at));
        match said.as_deref() {
            Some("look") => Some("look"),
            Some("scene") => Some("scene"),
            Some("shot") => Some("shot"),
            Some("hcbtf") => Some("hcbtf"),
            Some(_) => None,
            None if has("asset") && (has("meshes") || has("accessors")) => Some("glTF"),
            None if has("objects") && !has("nodes") => Some("scene"),
            None if has("nodes") && !has("objects") => Some("look"),
            None if has("scene") && !has("nodes") => Some("shot"),
            None => None,
        }
    }

    fn look(self) -> LoadedDocument<Look> {
        let loaded = self.read();
        with_structure(loaded, Look::check)
    }

    fn scene(self) -> LoadedDocument<Scene> {
        let loaded = self.read();
        with_structure(loaded, Scene::check)
    }

    fn shot(self) -> LoadedDocument<Shot> {
        let loaded = self.read();
        with_structure(loaded, Shot::check)
    }

    fn read<T: DescribedObject>(mut self) -> LoadedDocument<T> {
        let root = self.root(T::shape());
        let value = root.and_then(|root| self.read_at(root, document));
        self.loaded(value)
    }

    /// Value at the top, which is no document by itself.
    fn value<T: FieldType>(
        &mut self,
        name: &'static str,
        kind: &'static FieldKind,
    ) -> Option<(T, UnknownFields)> {
        let root = self.source.tree.root()?;
        self.read_at(root, |r, at| {
            if !name.is_empty() {
                r.path.push(PathStep::Field(name));
            }
            let mut unknown = UnknownFields::new();
            T::read(r, at, kind, &mut unknown).map(|value| (value, unknown))
        })
    }

    fn read_at<T>(
        &mut self,
        at: ValueIndex,
        read: impl FnOnce(&mut Reader<'_>, ValueIndex) -> Option<T>,
    ) -> Option<T> {
        let mut reader = Reader::new(&self.source.tree, &mut self.problems);
        let value = read(&mut reader, at);
        let kept = std::mem::take(&mut reader.kept);
        self.source.kept = kept;
        value
    }

    fn loaded<T>(self, value: Option<T>) -> LoadedDocument<T> {
        let diagnostics =
            self.problems.finish(&self.source.file, self.source.text(), &self.source.lines);
        LoadedDocument { value, source: self.source, diagnostics }
    }

    /// Top value of a document of the right type and a known version.
    fn root(&mut self, shape: &ObjectShape) -> Option<ValueIndex> {
        let tree = &self.source.tree;
        let root = tree.root()?;
        if tree.kind(root) != JsonKind::Object {
            let message = tr!(
                "expected {noun}, which is an object, found {found}",
                noun = with_article(shape.name),
                found = tree.kind(root).noun()
            );
            let problem = Diagnostic::error("wrong-document", message)
                .hint(text!("a document begins with `{`").tr());
            self.problems.push(tree.start(root), problem);
            return None;
        }
        if let Some(kind) = self.kind().filter(|&kind| kind != shape.name) {
            let hint = match kind {
                "glTF" => tr!("a scene names it as the `mesh` of an object"),
                "scene" => tr!("open it as a scene"),
                "shot" => tr!("open it as a shot, which changes a scene"),
                "hcbtf" => tr!("it lies in an `.hcbtf` file, which a look names"),
                _ => tr!("open it as a look, or name it in the `looks` of a scene's object"),
            };
            let problem = Diagnostic::error(
                "wrong-document",
                tr!(
                    "this is {found}, not {noun}",
                    found = with_article(kind),
                    noun = with_article(shape.name)
                ),
            );
            self.problems.push(tree.start(root), problem.hint(hint));
            return None;
        }
        let version = tree.member(root, "version");
        match version.and_then(|at| tree.number(at).map(|number| (at, number))) {
            Some((at, version)) if version > VERSION as f64 && version.fract() == 0.0 => {
                let message =
                    tr!("this file is version {version}; this Chiaro reads up to {VERSION}");
                let problem = Diagnostic::error("newer-version", message).json_path("version");
                self.problems
                    .push(tree.key_start(at), problem.hint(tr!("update Chiaro to open it")));
                None
            }
            _ => Some(root),
        }
    }
}

/// Reads the document at the top: its kind, and its fields.
fn document<T: DescribedObject>(r: &mut Reader<'_>, at: ValueIndex) -> Option<T> {
    let mut fields = r.object(at, T::shape())?;
    r.field(&fields, "chiaro", |r, at, kind| match kind {
        FieldKind::Word(words) => r.word_at(at, words),
        _ => None,
    });
    let _: Option<f64> = PlainCodec::read(r, &mut fields, "version");
    let schema: Option<String> = PlainCodec::read(r, &mut fields, "$schema");
    fields.unknown.extend(schema.map(|schema| ("$schema".to_owned(), schema.into())));
    T::from_fields(r, &mut fields)
}

/// Adds the problems of the document as a whole, unless parts of it are missing because the text is
/// cut off.
fn with_structure<T>(
    mut loaded: LoadedDocument<T>,
    check: impl Fn(&T) -> Vec<Diagnostic>,
) -> LoadedDocument<T> {
    if let Some(value) = loaded.value.as_ref().filter(|_| !loaded.source.tree.cut) {
        let mut found = check(value);
        loaded.source.locate_all(&mut found);
        loaded.diagnostics.extend(found);
        // A problem without a place, such as the number of problems left out, comes last.
        loaded.diagnostics.sort_by_key(|problem| (problem.place.at.is_none(), problem.place.at));
    }
    loaded
}
