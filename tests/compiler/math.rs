//! `docs/math.md`: every citation of it finds a section, every node is in its table, and the
//! functions that it names exist.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use chiaro_compiler::library::Library;

use crate::support::{self, files};

fn root() -> &'static Path {
    support::root()
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn page() -> String {
    read(&root().join("docs/math.md"))
}

/// Lines of the page outside of its blocks of formulas.
fn prose(page: &str) -> Vec<&str> {
    let mut lines = Vec::new();
    let mut is_formula = false;
    for line in page.lines() {
        if line.starts_with("```") {
            is_formula = !is_formula;
        } else if !is_formula {
            lines.push(line);
        }
    }
    lines
}

/// Number of the section that a text begins with: `2.3`, `5` or `D2`.
fn number(text: &str) -> Option<&str> {
    let is_other = |c: char| !c.is_ascii_alphanumeric() && c != '.';
    let end = text.find(is_other).unwrap_or(text.len());
    let word = text[..end].trim_end_matches('.');
    let digits = word.strip_prefix('D').unwrap_or(word);
    let is_number = !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit() || c == '.');
    is_number.then_some(word)
}

/// Numbers of the page's sections, each of which needs an anchor of that name in the line above.
fn sections(page: &str) -> BTreeSet<&str> {
    let mut found = BTreeSet::new();
    for pair in prose(page).windows(2) {
        let (above, heading) = (pair[0], pair[1]);
        if !heading.starts_with("##") {
            continue;
        }
        let Some(section) = number(heading.trim_start_matches('#').trim_start()) else {
            panic!("`{heading}` has no number");
        };
        assert_eq!(above, format!("<a id=\"{section}\"></a>"), "the anchor of `{heading}`");
        assert!(found.insert(section), "there are two sections {section}");
    }
    assert!(found.len() >= 60, "only {} sections are read", found.len());
    found
}

/// Text as one line, without the marks of its comments: a citation may go over the end of a line.
fn in_one_line(text: &str) -> String {
    let lines = text.lines().map(|line| line.trim().trim_start_matches(['/', '!']).trim_start());
    lines.collect::<Vec<_>>().join(" ")
}

/// Numbers of the sections that a text cites, as `math.md 2.3`, `math.md D2` or `math.md 2.1 to
/// 2.3`.
fn citations(text: &str) -> Vec<&str> {
    let mut cited = Vec::new();
    for rest in text.split("math.md ").skip(1) {
        let Some(first) = number(rest) else { continue };
        cited.push(first);
        cited.extend(rest[first.len()..].strip_prefix(" to ").and_then(number));
    }
    cited
}

/// Anchors that the links of a text lead to within its own page.
fn places(text: &str) -> Vec<&str> {
    text.split("](#").skip(1).filter_map(|rest| rest.split(')').next()).collect()
}

/// Rows of the closing table: a kind, and the sections of its formulas.
fn rows(page: &str) -> Vec<(&str, Vec<&str>)> {
    let Some((_, table)) = page.split_once("\n## 18 ") else { panic!("there is no closing table") };
    let mut rows = Vec::new();
    for line in table.lines() {
        let Some(line) = line.strip_prefix("| [`") else { continue };
        let Some((kind, rest)) = line.split_once("`](") else { panic!("`{line}` names no node") };
        rows.push((kind, places(rest)));
    }
    rows
}

/// Files and functions that the page names, as `lib/curve.wgsl: curve_at, hermite`.
fn functions(page: &str) -> Vec<(&str, &str)> {
    let mut named = Vec::new();
    for line in prose(page) {
        let parts = line.split('`').count();
        assert!(parts % 2 == 1, "a name goes over the end of `{line}`");
        for span in line.split('`').skip(1).step_by(2) {
            let Some((file, functions)) = span.split_once(": ") else { continue };
            if file.ends_with(".wgsl") {
                named.extend(functions.split(", ").map(|function| (file, function)));
            }
        }
    }
    named
}

/// The folder that a file's name on the page counts from.
fn folder_of(file: &str) -> &'static str {
    if file.starts_with("lib/") || file.starts_with("passes/") { "shaders" } else { "nodes" }
}

/// The functions of a WGSL file.
fn declared(text: &str) -> BTreeSet<&str> {
    let names = text.lines().filter_map(|line| line.strip_prefix("fn "));
    names.filter_map(|rest| rest.split('(').next()).collect()
}

#[test]
fn every_citation_has_a_section() {
    let page = page();
    let sections = sections(&page);
    for place in places(&page) {
        assert!(sections.contains(place), "the page leads to {place}, which it has not");
    }
    let mut paths: Vec<PathBuf> = Vec::new();
    for folder in ["shaders", "nodes", "src", "tests"] {
        paths.extend(files::below(&root().join(folder)));
    }
    paths.push(root().join("docs/decisions.md"));
    let mut count = 0;
    for path in paths {
        if !path.extension().is_some_and(|end| end == "rs" || end == "wgsl" || end == "md") {
            continue;
        }
        for section in citations(&in_one_line(&read(&path))) {
            let file = path.display();
            assert!(sections.contains(section), "{file} cites {section}, which is not there");
            count += 1;
        }
    }
    assert!(count >= 20, "only {count} citations are read");
    let broken = in_one_line("/// As in docs/math.md\n/// 2.1 to\n/// 2.3, and so on.");
    assert_eq!(citations(&broken), ["2.1", "2.3"]);
}

#[test]
fn every_node_is_in_the_closing_table() {
    let page = page();
    let (sections, rows) = (sections(&page), rows(&page));
    let kinds: BTreeSet<&str> = Library::built_in().kinds().collect();
    let mut listed = BTreeSet::new();
    for (kind, places) in &rows {
        assert!(kinds.contains(kind), "there is no node `{kind}`");
        assert!(listed.insert(*kind), "`{kind}` is listed twice");
        assert!(!places.is_empty(), "`{kind}` has no section");
        for place in places {
            assert!(sections.contains(place), "`{kind}` leads to {place}, which is not there");
        }
    }
    let missing: Vec<&&str> = kinds.difference(&listed).collect();
    assert!(missing.is_empty(), "docs/math.md does not list {missing:?}");
}

/// Every function that the page names exists, and the page names every file of shaders: a new file
/// needs its formulas there.
#[test]
fn every_function_that_is_named_is_there() {
    let page = page();
    let named = functions(&page);
    assert!(named.len() >= 300, "only {} functions are read", named.len());
    for (file, function) in &named {
        let text = read(&root().join(folder_of(file)).join(file));
        assert!(declared(&text).contains(function), "{file} has no function `{function}`");
    }
    let files_named: BTreeSet<PathBuf> =
        named.iter().map(|(file, _)| root().join(folder_of(file)).join(file)).collect();
    for folder in ["shaders", "nodes"] {
        for path in files::below(&root().join(folder)) {
            let is_shader = path.extension().is_some_and(|end| end == "wgsl");
            if is_shader && !declared(&read(&path)).is_empty() {
                assert!(files_named.contains(&path), "{} is not named", path.display());
            }
        }
    }
}
