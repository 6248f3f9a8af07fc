//! Texts of the project: short lines, paths and test programs that exist, one spelling.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::scan::literals;
use crate::support::{files, root};

/// Number of characters that a line may have.
const LONGEST: usize = 100;

/// Texts that no hand wraps, with the reason.
const UNWRAPPED: &[(&str, &str)] = &[
    ("docs/accuracy.md", "made by `chiaro accuracy`"),
    ("docs/gallery", "made by `chiaro gallery`"),
    ("docs/nodes.md", "made by `chiaro nodes --markdown`, a line for a node's paragraph"),
    ("tests/cases", "inputs of strangers, and messages as Chiaro prints them"),
    ("tests/golden", "what Chiaro exports"),
    ("tests/packages/crates", "what Chiaro exports"),
    ("tests/packages/last_release", "what Chiaro exported"),
    ("tests/tint", "a program for Node, which has its own width"),
];

/// Kinds of files that people write and read as text; scripts have none.
const KINDS: &[&str] = &["md", "rs", "toml", "wgsl", ""];

/// Files that people write, with their paths from the root and their texts; links to folders are
/// read once, where the folders lie.
fn texts() -> Vec<(String, String)> {
    let folders = ["benches", "docs", "examples", "nodes", "scripts", "shaders", "src", "tests"];
    let files_at_the_top =
        ["CHANGELOG.md", "README.md", "Cargo.toml", ".clippy.toml", ".deny.toml"];
    let below = folders.iter().flat_map(|folder| files::below(&root().join(folder)));
    let all = below.chain(files_at_the_top.iter().map(|name| root().join(name)));
    let mut found = Vec::new();
    for path in all {
        let kind = path.extension().map(|kind| kind.to_string_lossy().into_owned());
        let name = path.strip_prefix(root()).expect("it was found there");
        if !KINDS.contains(&kind.as_deref().unwrap_or_default()) || is_by_link(name) {
            continue;
        }
        let text = fs::read_to_string(&path).expect("a text is UTF-8");
        found.push((name.to_string_lossy().replace('\\', "/"), text));
    }
    assert!(found.len() > 500, "{} files", found.len());
    found
}

/// True if a file lies below a link to a folder, by its path from the root.
fn is_by_link(name: &Path) -> bool {
    name.ancestors().any(|folder| root().join(folder).is_symlink())
}

/// Lines of a text that may be long by nature: tables, code and lines that are one link of
/// Markdown, and values of TOML, whose tables are a line each.
fn long_by_nature(name: &str, text: &str) -> BTreeSet<usize> {
    let mut is_code = false;
    let by_nature = text.lines().enumerate().filter(|(_, line)| {
        let start = line.trim_start();
        if name.ends_with(".toml") {
            return !start.starts_with('#');
        }
        if !name.ends_with(".md") {
            return false;
        }
        is_code ^= start.starts_with("```");
        let is_link = start.starts_with("<a ") || start.starts_with('[') || start.starts_with("![");
        is_code || is_link || start.starts_with('|')
    });
    by_nature.map(|(index, _)| index).collect()
}

#[test]
fn lines_are_short() {
    let mut long = Vec::new();
    for (name, text) in texts() {
        if UNWRAPPED.iter().any(|(path, _)| Path::new(&name).starts_with(path)) {
            continue;
        }
        let by_nature = long_by_nature(&name, &text);
        for (index, line) in text.lines().enumerate() {
            let length = line.chars().count();
            if length > LONGEST && !by_nature.contains(&index) {
                long.push(format!("{name}:{}: {length}", index + 1));
            }
        }
    }
    assert!(long.is_empty(), "lines of more than {LONGEST} characters:\n{}", long.join("\n"));
    for (path, _) in UNWRAPPED {
        assert!(root().join(path).exists(), "UNWRAPPED names {path}, which is gone");
    }
}

/// Paths from the root that a line cites.
fn cited(line: &str) -> impl Iterator<Item = &str> {
    let is_of_path = |c: char| c.is_ascii_alphanumeric() || "_-./*<>{}".contains(c);
    let words = line.split(move |c| !is_of_path(c)).map(|word| word.trim_end_matches(['.', '/']));
    let tops = ["benches/", "docs/", "scripts/", "shaders/", "src/", "tests/"];
    words.filter(move |word| {
        let is_pattern = word.contains(['*', '<', '>', '{', '}']);
        // `tests/ledger/NAME.txt`: a word in capitals stands for many.
        let is_for_many = word
            .split(['/', '.'])
            .any(|part| part.len() > 2 && part.chars().all(|c| c.is_ascii_uppercase() || c == '_'));
        tops.iter().any(|top| word.starts_with(top)) && !is_pattern && !is_for_many
    })
}

/// Names of all test programs.
fn test_programs() -> BTreeSet<String> {
    let folders = fs::read_dir(root().join("tests")).expect("there are tests").flatten();
    let programs = folders.filter(|folder| folder.path().join("main.rs").is_file());
    programs.map(|folder| folder.file_name().to_string_lossy().into_owned()).collect()
}

/// Comments and documents name files that are there, and test programs that Cargo knows. The
/// changelog tells of the past.
#[test]
fn cited_paths_and_test_programs_exist() {
    let programs = test_programs();
    let mut gone = Vec::new();
    for (name, text) in texts() {
        let is_past = name == "CHANGELOG.md" || name.starts_with("tests/golden");
        for (index, line) in text.lines().enumerate().filter(|_| !is_past) {
            let start = line.trim_start();
            let is_prose =
                name.ends_with(".md") || start.starts_with("//") || start.starts_with('#');
            let paths = cited(line).filter(|_| is_prose).filter(|path| !root().join(path).exists());
            gone.extend(paths.map(|path| format!("{name}:{}: {path}", index + 1)));
            let word = |rest: &str| -> String {
                rest.chars().take_while(|c| c.is_ascii_lowercase() || *c == '_').collect()
            };
            let tests = line.split("--test ").skip(1).map(word);
            let unknown = tests.filter(|test| !test.is_empty() && !programs.contains(test));
            gone.extend(unknown.map(|test| format!("{name}:{}: --test {test}", index + 1)));
        }
    }
    assert!(gone.is_empty(), "cited, and not there:\n{}", gone.join("\n"));
}

/// Beginnings of words in British spelling; users read American.
const BRITISH: &[&str] = &[
    "artefact",
    "behaviour",
    "catalogue",
    "centre",
    "colour",
    "draughtsm",
    "favour",
    "fibre",
    "grey",
    "honour",
    "labelled",
    "licence",
    "maths",
    "metre",
    "modelled",
    "modelling",
    "neighbour",
    "optimise",
    "optimisation",
    "normalise",
    "normalisation",
    "parametrise",
    "quantise",
    "rasterise",
    "recognise",
    "organise",
    "realise",
    "specialise",
    "stylise",
    "towards",
    "unoptimis",
    "travelled",
    "travelling",
    "visualise",
];

/// The words of a text in British spelling.
fn british(text: &str) -> impl Iterator<Item = String> {
    let words = text.split(|c: char| !c.is_alphabetic()).map(str::to_lowercase);
    words.filter(|word| BRITISH.iter().any(|start| word.starts_with(start)))
}

/// Texts that users read: documents, nodes and shaders, which exports take along, examples, and the
/// strings of the program.
fn read_by_users() -> Vec<(String, String)> {
    let mut found = Vec::new();
    for (name, text) in texts() {
        if name.starts_with("src/") && name.ends_with(".rs") {
            let shipped = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
            // Rows of `described!` and of lights are documented by their comments.
            let docs = shipped.lines().filter(|line| {
                name.starts_with("src/compiler/document") && line.trim().starts_with("///")
            });
            found.push((name.clone(), literals(shipped).join(" ")));
            found.push((name.clone(), docs.collect::<Vec<_>>().join(" ")));
        } else if name.ends_with(".md") || name.ends_with(".wgsl") {
            // Exports say what shaders say, and cases are of strangers.
            found.extend((!name.starts_with("tests/")).then_some((name, text)));
        }
    }
    let examples: Vec<PathBuf> = files::below(&root().join("examples"))
        .into_iter()
        .filter(|path| path.extension().is_some_and(|kind| kind == "json"))
        .collect();
    found.extend(examples.into_iter().map(|path| {
        let text = fs::read_to_string(&path).expect("an example is UTF-8");
        (path.display().to_string(), text)
    }));
    found
}

#[test]
fn users_read_one_spelling() {
    let mut words = Vec::new();
    for (name, text) in read_by_users() {
        words.extend(british(&text).map(|word| format!("{name}: {word}")));
    }
    words.dedup();
    assert!(words.is_empty(), "British spelling that users read:\n{}", words.join("\n"));
}

#[test]
fn what_is_refused_is_found() {
    let text = "```\nlong\n```\n| table |\n[a](b)\nprose";
    assert_eq!(long_by_nature("a.md", text), BTreeSet::from([0, 1, 3, 4]));
    assert_eq!(long_by_nature("a.rs", text), BTreeSet::new());
    let line = "// see src/gone.rs, `tests/ledger/NAME.txt`, docs/nodes.md. and shaders/*";
    assert_eq!(cited(line).collect::<Vec<_>>(), ["src/gone.rs", "docs/nodes.md"]);
    assert_eq!(
        british("The Greyest colours, greatly.").collect::<Vec<_>>(),
        ["greyest", "colours"]
    );
    assert_eq!(literals("f(\"a\", b) // \"c\""), ["\"a\""]);
}
