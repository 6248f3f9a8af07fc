//! Diagnostics of small documents, node files and code: the inputs of `tests/cases`, each with its
//! text beside it.

use std::str;

use chiaro_compiler::compile::{CompileOptions, compile};
use chiaro_compiler::document::{Look, Scene};
use chiaro_compiler::library::Library;
use chiaro_language::diag::Diagnostic;
use serde_json::json;

use crate::support::cases::hold;

fn text(bytes: &[u8]) -> &str {
    str::from_utf8(bytes).expect("a case of text is UTF-8")
}

/// Asserts that the diagnostics of a document name its file.
fn in_file(name: &str, problems: Vec<Diagnostic>) -> Vec<Diagnostic> {
    assert!(problems.iter().all(|d| d.place.file.as_deref() == Some(name)), "{problems:?}");
    problems
}

#[test]
fn looks() {
    hold("look", |name, bytes| {
        let loaded = Look::read(text(bytes), name);
        (loaded.value.is_some(), in_file(name, loaded.diagnostics))
    });
}

#[test]
fn scenes() {
    hold("scene", |name, bytes| {
        let loaded = Scene::read(text(bytes), name);
        (loaded.value.is_some(), in_file(name, loaded.diagnostics))
    });
}

/// Looks of `tests/cases/check`, which are read without complaint, compiled.
#[test]
fn checks() {
    hold("check", |name, bytes| {
        let loaded = Look::read(text(bytes), name);
        assert!(loaded.diagnostics.is_empty(), "{name}: {:?}", loaded.diagnostics);
        let look = loaded.value.expect("a look");
        let (is_compiled, mut problems) =
            match compile(&look, Library::built_in(), &CompileOptions::default()) {
                Ok(shader) => (true, shader.warnings),
                Err(problems) => (false, problems),
            };
        loaded.source.locate_all(&mut problems);
        (is_compiled, problems)
    });
}

/// Node files of a project's `nodes/`.
#[test]
fn node_files() {
    hold("node-file", |_, bytes| {
        let mut library = Library::default();
        library.add_file("nodes/own/half.wgsl", text(bytes));
        assert!(library.nodes.is_empty() || library.problems.is_empty());
        (!library.nodes.is_empty(), library.problems)
    });
}

/// Code of a WGSL node that no look can run. A node file with that code is refused with the same
/// diagnostic, and adds no node.
#[test]
fn node_code() {
    hold("node", |name, bytes| {
        let code = text(bytes);
        let mut library = Library::default();
        library.add_file("nodes/own/f.wgsl", code);
        let in_file = &library.problems[0];
        assert!(library.nodes.is_empty(), "{name}: a node file that is refused adds no node");
        assert!(in_file.place.file.is_some() && in_file.place.at.is_some(), "{name}: {in_file}");
        let look = json!({
            "nodes": [
                {"id": "start", "kind": "kappa"},
                {"id": "own", "kind": "wgsl", "values": {"code": code}},
                {"id": "output", "kind": "output"},
            ],
            "wires": [
                {"from": "start", "to": "own.x"},
                {"from": "own", "to": "output.color"},
            ],
        });
        let loaded = Look::read(&look.to_string(), "own.json");
        assert!(loaded.diagnostics.is_empty(), "{name}: {:?}", loaded.diagnostics);
        let look = loaded.value.expect("a look");
        let problems = compile(&look, Library::built_in(), &CompileOptions::default())
            .expect_err("it is refused");
        assert_eq!(problems.len(), 1, "{name}: {problems:?}");
        assert_eq!(problems[0].code, in_file.code, "{name}: {in_file}");
        (false, problems)
    });
}
