//! Linker: resolves `import chiaro::name;` lines.

use std::collections::HashSet;
use std::ops::Range;

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
    parts: Vec<SourceSpan>,
}

#[derive(Clone, Debug)]
struct SourceSpan {
    name: String,
    span: Range<usize>,
}

impl LinkedSource {
    /// File that a byte of the text came from, and the place in it.
    pub fn locate(&self, offset: usize) -> Option<(&str, LineColumn)> {
        let part =
            self.parts.iter().find(|part| part.span.contains(&offset)).or(self.parts.last())?;
        let text = &self.text[part.span.clone()];
        Some((&part.name, LineColumn::of(text, offset.saturating_sub(part.span.start))))
    }

    /// Byte range of the last source, which nothing imports.
    pub fn last_source(&self) -> Range<usize> {
        self.parts.last().map_or(0..0, |part| part.span.clone())
    }

    fn push(&mut self, source: &NamedSource<'_>, scan: &Scan) {
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
        self.parts.push(SourceSpan { name: source.name.to_owned(), span: start..self.text.len() });
    }
}

/// File of the shared library that `import` names.
fn library_file(import: &str) -> Option<NamedSource<'static>> {
    let name = import.strip_prefix(ROOT)?;
    let (path, text) = SHADER_LIBRARY.iter().find(|(path, _)| file_stem(path) == name)?;
    Some(NamedSource { name: path, text })
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
        let scan = scan(source.text);
        add_imports(source, &scan, &mut done, &mut linked, &mut problems);
        linked.push(source, &scan);
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
                    format!("there is no `{}` to import", import.path),
                )
                .in_file(source.name)
                .at(LineColumn::of(source.text, import.span.start))
                .suggest(&import.path, known.iter().map(String::as_str)),
            );
            continue;
        };
        if done.insert(import.path.clone()) {
            let scan = scan(file.text);
            add_imports(&file, &scan, done, linked, problems);
            linked.push(&file, &scan);
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
