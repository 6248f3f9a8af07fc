//! Ledgers notice changed shaders, changed engines, and false lines.

use std::fs;
use std::path::{Path, PathBuf};

use chiaro::library::Library;
use chiaro::sweeps::{Case, Effort, Laboratory};

use crate::nodes;
use crate::support::eval::renderer;
use crate::support::ledger::{Ledger, ProofKey, ProofMode};
use crate::support::{files, halved};

fn written(folder: &Path, lines: &[(&str, &ProofKey, f64)]) -> PathBuf {
    let path = folder.join("sweep.txt");
    let line = |(case, key, figure): &(&str, &ProofKey, f64)| {
        format!("{} {figure:e} {case}\n", key.text())
    };
    fs::write(&path, lines.iter().map(line).collect::<String>()).unwrap();
    path
}

/// Cases of a ledger that a commit proves anew.
fn proved(path: &Path, commit: &str, cases: &[String], key: &ProofKey) -> Vec<String> {
    let mut ledger = Ledger::at(path, ProofMode::Turns, commit);
    cases.iter().filter(|case| ledger.is_due(case, key)).cloned().collect()
}

#[test]
fn every_line_has_its_turn_and_a_commit_proves_a_tenth() {
    let folder = tempfile::tempdir().unwrap();
    let key = ProofKey::of_sources(&["tests/support"]);
    let cases: Vec<String> = (0..500).map(|number| format!("case {number}")).collect();
    let lines: Vec<_> = cases.iter().map(|case| (case.as_str(), &key, 1e-7)).collect();
    let path = written(folder.path(), &lines);
    let mut never = cases.clone();
    for commit in 0..100 {
        let anew = proved(&path, &format!("{commit:040x}"), &cases, &key);
        assert!((20..90).contains(&anew.len()), "{} of 500", anew.len());
        never.retain(|case| !anew.contains(case));
    }
    assert!(never.is_empty(), "{never:?} are never proved");
}

#[test]
fn a_forged_line_is_found_when_its_turn_comes() {
    let folder = tempfile::tempdir().unwrap();
    let key = ProofKey::of_sources(&["tests/support"]);
    let path = written(folder.path(), &[("node add", &key, 1e-7)]);
    let run = |commit: u32, truth: f64| {
        let mut ledger = Ledger::at(&path, ProofMode::Turns, &format!("{commit:040x}"));
        ledger.prove("node add", &key, || Ok(truth));
        ledger.complaints
    };
    let honest = (0..100).filter(|commit| !run(*commit, 1.1e-7).is_empty()).count();
    let forged = (0..100)
        .filter(|commit| run(*commit, 3e-3).iter().any(|told| told.contains("is false")))
        .count();
    assert_eq!(honest, 0);
    assert!((3..25).contains(&forged), "{forged} of 100 commits find it");
}

#[test]
fn a_line_with_another_key_counts_for_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let key = ProofKey::of_sources(&["tests/support"]);
    let path = written(folder.path(), &[("node add", &key.with(b"another"), 1e-7)]);
    let mut ledger = Ledger::at(&path, ProofMode::Turns, "");
    ledger.prove("node add", &key, || Err("off by 3".into()));
    assert_eq!(
        (ledger.counts(), ledger.complaints),
        ([1, 0], vec!["node add: off by 3".to_owned()])
    );
}

/// A changed operator in the interpreter, which judges, changes every key; a changed comment
/// changes none.
#[test]
fn a_changed_interpreter_is_another_key() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/language/interp");
    let folder = tempfile::tempdir().unwrap();
    let copy = folder.path().join("interp");
    for path in files::below(&source) {
        let to = copy.join(path.strip_prefix(&source).unwrap());
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(&path, to).unwrap();
    }
    let key = || ProofKey::of_sources_in(folder.path(), &["interp"]).text();
    let before = key();
    assert_eq!(before, ProofKey::of_sources(&["src/language/interp"]).text());
    let file = copy.join("math.rs");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, format!("// Of another mind.\n\n{text}")).unwrap();
    assert_eq!(key(), before, "a comment changes nothing");
    let is_code = |line: &&str| line.contains(" + ") && !line.trim().starts_with("//");
    let sum = text.lines().find(is_code).expect("the interpreter adds");
    let changed = text.replacen(sum, &sum.replacen(" + ", " - ", 1), 1);
    fs::write(&file, changed).unwrap();
    assert_ne!(key(), before);
}

/// A changed digit in a shader changes the keys of its node, and leaves those of other nodes.
#[test]
fn a_changed_constant_in_a_shader_is_another_key() {
    let key = |library: &Library, node: &str| {
        let mut renderer = renderer();
        let mut lab = Laboratory::new(library, &mut renderer).unwrap();
        let case = Case::of(&library.nodes[node]).remove(0);
        nodes::key(&mut lab, &case, &Effort { ordinary: 8, extreme: 8, rounds: 0 }).text()
    };
    let (before, after) = (halved::library("0.5"), halved::library("0.5000001"));
    assert_eq!(key(&before, "half_of"), key(&halved::library("0.5"), "half_of"));
    assert_ne!(key(&before, "half_of"), key(&after, "half_of"));
    assert_eq!(key(&before, "add"), key(&after, "add"));
}
