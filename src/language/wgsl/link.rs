//! Linker: resolves `import chiaro::name;` lines.
//!
//! Every file of the shared library is scanned once, however many sources import it.

use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::{Arc, LazyLock, OnceLock};

use chiaro_locale::tr;

use super::embedded::SHADER_LIBRARY;
use super::scan::{Scan, scan};
use crate::diag::{Diagnostic, LineColumn};

/// Root of the shared library in import paths.
const ROOT: &str = "chiaro::";

/// Named text.
#[derive(Clone, Copy, Debug)]
pub struct NamedSource<'a> {
    /// File name, as messages give it.
    pub name: &'a str,
    /// Text of the file.
    pub text: &'a str,
}

/// Sources with their imports resolved: plain WGSL.
#[derive(Clone, Debug, Default)]
pub struct LinkedSource {
    /// Text, ready for naga.
    pub text: String,
    /// Files that the text consists of, in its order.
    pub files: Vec<LinkedFile>,
}

/// File in a [`LinkedSource`].
#[derive(Clone, Debug)]
pub struct LinkedFile {
    /// File name, as messages give it.
    pub name: String,
    /// Byte range in the linked text.
    pub span: Range<usize>,
    /// Scan of the file; ranges in it begin at the file's own beginning.
    pub scan: Arc<Scan>,
}

impl LinkedSource {
    /// File that a byte of the text came from, and the place in it.
    pub fn locate(&self, offset: usize) -> Option<(&str, LineColumn)> {
        let file =
            self.files.iter().find(|file| file.span.contains(&offset)).or(self.files.last())?;
        let text = &self.text[file.span.clone()];
        Some((&file.name, LineColumn::of(text, offset.saturating_sub(file.span.start))))
    }

    /// Byte range of the last source, which nothing imports.
    pub fn last_source(&self) -> Range<usize> {
        self.files.last().map_or(0..0, |file| file.span.clone())
    }

    fn push(&mut self, source: &NamedSource<'_>, scan: Arc<Scan>) {
        let start = self.text.len();
        let mut at = 0;
        // Imports become spaces, so that lines and columns stay true.
        for import in &scan.imports {
            self.text.push_str(&source.text[at..import.span.start]);
            self.text.extend(std::iter::repeat_n(' ', import.span.len()));
            at = import.span.end;
        }
        self.text.push_str(&source.text[at..]);
        if !self.text.ends_with('\n') {
            self.text.push('\n');
        }
        let span = start..self.text.len();
        self.files.push(LinkedFile { name: source.name.to_owned(), span, scan });
    }
}

/// File of the shared library.
struct LibraryFile {
    source: NamedSource<'static>,
    /// Scan of the file, made when the file is first imported.
    scan: OnceLock<Arc<Scan>>,
}

impl LibraryFile {
    fn scan(&self) -> &Arc<Scan> {
        self.scan.get_or_init(|| Arc::new(scan(self.source.text)))
    }
}

/// Files of the shared library by the names that imports give them.
static LIBRARY: LazyLock<HashMap<&'static str, LibraryFile>> = LazyLock::new(|| {
    let file = |&(name, text): &(&'static str, &'static str)| {
        let source = NamedSource { name, text };
        (file_stem(name), LibraryFile { source, scan: OnceLock::new() })
    };
    SHADER_LIBRARY.iter().map(file).collect()
});

/// Texts and scans of all files of the shared library, in no order.
pub fn library_scans() -> impl Iterator<Item = (&'static str, &'static Scan)> {
    LIBRARY.values().map(|file| (file.source.text, &**file.scan()))
}

/// File of the shared library that `import` names.
fn library_file(import: &str) -> Option<&'static LibraryFile> {
    LIBRARY.get(import.strip_prefix(ROOT)?)
}

fn file_stem(path: &str) -> &str {
    let name = path.rsplit('/').next().unwrap_or(path);
    name.strip_suffix(".wgsl").unwrap_or(name)
}

/// Joins `sources`, with the files that they import before them, each file once.
///
/// # Errors
/// A diagnostic for every import that is not in the library, with its file and line.
pub fn link(sources: &[NamedSource<'_>]) -> Result<LinkedSource, Vec<Diagnostic>> {
    let mut linked = LinkedSource::default();
    let mut done = HashSet::new();
    let mut problems = Vec::new();
    for source in sources {
        let scan = Arc::new(scan(source.text));
        add_imports(source, &scan, &mut done, &mut linked, &mut problems);
        linked.push(source, scan);
    }
    if problems.is_empty() { Ok(linked) } else { Err(problems) }
}

/// Adds the files that a source imports. The depth of the recursion is bounded: every library file
/// is entered at most once.
fn add_imports(
    source: &NamedSource<'_>,
    scanned: &Scan,
    done: &mut HashSet<String>,
    linked: &mut LinkedSource,
    problems: &mut Vec<Diagnostic>,
) {
    for import in &scanned.imports {
        let Some(file) = library_file(&import.path) else {
            let known: Vec<_> = SHADER_LIBRARY
                .iter()
                .map(|(path, _)| format!("{ROOT}{}", file_stem(path)))
                .collect();
            problems.push(
                Diagnostic::error(
                    "unknown-import",
                    tr!("there is no `{path}` to import", path = import.path),
                )
                .in_file(source.name)
                .at(LineColumn::of(source.text, import.span.start))
                .suggest(&import.path, known.iter().map(String::as_str)),
            );
            continue;
        };
        if done.insert(import.path.clone()) {
            add_imports(&file.source, file.scan(), done, linked, problems);
            linked.push(&file.source, file.scan().clone());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_import_names_its_line() {
        let problems =
            link(&[NamedSource { name: "a.wgsl", text: "\nimport chiaro::tipes;\n" }]).unwrap_err();
        let text = problems[0].to_string();
        assert!(text.starts_with("a.wgsl:2:1: error[unknown-import]"), "{text}");
        assert!(text.contains("chiaro::types"), "{text}");
    }

    #[test]
    fn a_byte_finds_its_file() {
        let text = "import chiaro::types;\nfn f() -> Color { return Color(0.0); }";
        let linked = link(&[NamedSource { name: "f.wgsl", text }]).unwrap();
        let offset = linked.text.find("fn f()").unwrap();
        assert_eq!(linked.locate(offset), Some(("f.wgsl", LineColumn { line: 2, column: 1 })));
        assert_eq!(linked.locate(0).unwrap().0, "shaders/lib/types.wgsl");
    }
}
