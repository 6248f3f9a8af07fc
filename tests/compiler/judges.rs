//! Keys of the ledgers of long sweeps: the sources that judge a sweep are in its keys.

use std::collections::BTreeSet;
use std::fs;

use crate::support::judges::{COMPUTING, judges, versions};
use crate::support::{files, root};

/// Sweeps that keep a ledger: the file that opens the ledger, and the sources that judge.
fn sweeps() -> Vec<(String, BTreeSet<String>)> {
    let rust = files::below(&root().join("tests")).into_iter();
    let rust = rust.filter(|path| path.extension().is_some_and(|kind| kind == "rs"));
    let mut sweeps = Vec::new();
    for path in rust {
        let text = fs::read_to_string(&path).expect("a source is UTF-8");
        let name = path.strip_prefix(root()).expect("it was found there");
        let name = name.to_string_lossy().replace('\\', "/");
        if text.contains("Ledger::open(") && name != "tests/compiler/judges.rs" {
            assert!(
                text.contains("ProofKey::of_judges(") && text.contains(&format!("\"{name}\"")),
                "{name} keeps a ledger: `ProofKey::of_judges` makes its keys, of the file itself"
            );
            let judges = judges(&[&name]);
            sweeps.push((name, judges));
        }
    }
    sweeps
}

#[test]
fn every_engine_that_a_sweep_uses_judges_it() {
    let sweeps = sweeps();
    assert!(sweeps.len() >= 6, "{sweeps:?}");
    for (name, judges) in &sweeps {
        assert!(judges.contains(name), "{name} judges too");
        let missing: Vec<_> = judges.iter().filter(|path| !root().join(path).exists()).collect();
        assert!(missing.is_empty(), "{name}: there is no {missing:?}");
        // Outside compilers judge what is exported.
        if name == "tests/export/validators.rs" {
            continue;
        }
        let engines = [
            "src/compiler/library/passes",
            "src/language/interp",
            "src/language/wgsl",
            "src/scene/frame",
            "tests/drawing",
        ];
        for engine in engines {
            assert!(judges.contains(engine), "{name} is not judged by {engine}: {judges:?}");
        }
        let executors = ["src/render", "src/reference"];
        assert!(executors.iter().any(|executor| judges.contains(*executor)), "{judges:?}");
    }
}

/// The compiler's code is in no key: the keys hold the modules that the compiler makes, so a change
/// that gives the same modules proves nothing anew.
#[test]
fn makers_of_what_keys_hold_are_no_judges() {
    for (name, judges) in sweeps() {
        let makers = ["src/compiler/compile", "src/compiler", "src/scene/export", "src/cli"];
        assert!(!makers.iter().any(|maker| judges.contains(*maker)), "{name}: {judges:?}");
    }
}

#[test]
fn another_version_of_a_crate_that_computes_is_another_key() {
    let lock = fs::read_to_string(root().join("Cargo.lock")).expect("it lies at the root");
    let known = versions(&lock);
    for name in COMPUTING {
        assert!(known.lines().any(|line| line.starts_with(&format!("{name} "))), "{name}");
        let package = format!("name = \"{name}\"\nversion = \"");
        let other = lock.replacen(&package, &format!("{package}9"), 1);
        assert_ne!(versions(&other), known, "{name}");
    }
}
