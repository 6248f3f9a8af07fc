//! Names: a type's name says what the type is, and the glossary names types and modules that exist.
//!
//! A name that is a pronoun, a question or a bare participle (`What`, `Of`, `Shown`) tells nobody
//! what the type is, and comes again in the next module for another type. Such names are refused.
//! Those that stand from before are listed in `words_to_rename.txt`; the list may only become
//! shorter, and `CHIARO_BLESS=1` removes renamed types from it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use crate::support::files::below;
use crate::support::root;

/// Type names that do not name a thing.
const RIDDLES: &[&str] = &[
    // Pronouns and questions.
    "All", "Anything", "How", "It", "Of", "One", "Other", "Some", "That", "These", "Thing",
    "Things", "This", "Those", "What", "When", "Where", "Which", "Who", "Whose", "Why",
    // Adverbs and the like.
    "Again", "Here", "Now", "Still", "Then", "There", "Until", "Way",
    // Participles: they say what happened to a thing.
    "Added", "Asked", "Awaited", "Baked", "Begun", "Built", "Called", "Chosen", "Compared", "Done",
    "Drawn", "Filled", "Fitted", "Found", "Given", "Going", "Held", "Kept", "Known", "Laid",
    "Left", "Made", "Making", "Meant", "Measured", "Missed", "Named", "Needed", "Noted", "Offered",
    "Opened", "Parted", "Placed", "Probed", "Put", "Read", "Reading", "Reused", "Running", "Said",
    "Seen", "Shown", "Showing", "Staged", "Taken", "Told", "Tried", "Tuned", "Used", "Waiting",
    "Walked", "Wanted", "Wished", "Worn", "Written",
    // Riddles: the field has another word.
    "Job", "Keeper", "Lamp", "Moment", "Station", "Wardrobe", "Wish",
];

/// The type name that a line declares.
fn declared(line: &str) -> Option<&str> {
    let mut words = line.split_whitespace().filter(|word| !word.starts_with("pub"));
    let keyword = words.next()?;
    if !matches!(keyword, "struct" | "enum" | "trait" | "type" | "union") {
        return None;
    }
    let name = words.next()?.split(['<', '(', ';', ':', '{', '=']).next()?;
    name.starts_with(|c: char| c.is_ascii_uppercase()).then_some(name)
}

/// Every type that `src/` declares, with the files that declare it, by paths from `src/`.
fn declarations() -> BTreeMap<String, BTreeSet<String>> {
    let src = root().join("src");
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for path in below(&src) {
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let file = path.strip_prefix(&src).unwrap().to_string_lossy().replace('\\', "/");
        for name in text.lines().filter_map(declared) {
            found.entry(name.to_owned()).or_default().insert(file.clone());
        }
    }
    found
}

#[test]
fn types_are_called_what_they_are() {
    let list = root().join("tests/compiler/words_to_rename.txt");
    let text = fs::read_to_string(&list).unwrap();
    let allowed: BTreeSet<&str> = text.lines().collect();
    let declarations = declarations();
    let riddles: BTreeSet<String> = RIDDLES
        .iter()
        .filter_map(|name| Some((name, declarations.get(*name)?)))
        .flat_map(|(name, files)| files.iter().map(move |file| format!("{file} {name}")))
        .collect();
    let new: Vec<&String> =
        riddles.iter().filter(|riddle| !allowed.contains(riddle.as_str())).collect();
    assert!(new.is_empty(), "a name says what the thing is, and these do not: {new:#?}");
    let left: Vec<&str> = allowed.iter().copied().filter(|line| riddles.contains(*line)).collect();
    if left.len() == allowed.len() {
        return;
    }
    if std::env::var_os("CHIARO_BLESS").is_some() {
        fs::write(&list, left.iter().map(|line| format!("{line}\n")).collect::<String>()).unwrap();
        return;
    }
    let gone: Vec<&&str> = allowed.iter().filter(|line| !left.contains(line)).collect();
    panic!("these are renamed: take them off the list (CHIARO_BLESS=1 does): {gone:#?}");
}

/// Types and modules in the glossary's last column exist; modules by their paths from `src/` or the
/// top.
#[test]
fn the_glossary_names_what_there_is() {
    let text = fs::read_to_string(root().join("docs/glossary.md")).unwrap();
    let declarations = declarations();
    let mut words = 0;
    let mut last = String::new();
    for row in text.lines().filter(|line| {
        line.starts_with("| ") && !line.starts_with("| word |") && !line.starts_with("| ---")
    }) {
        let cells: Vec<&str> = row.trim_matches('|').split(" | ").map(str::trim).collect();
        let [word, meaning, carriers] = cells.as_slice() else { panic!("three cells: {row}") };
        assert!(!word.is_empty() && !meaning.is_empty(), "{row}");
        assert!(word.to_lowercase() > last, "`{word}` is out of order");
        last = word.to_lowercase();
        words += 1;
        let named = carriers.split('`').skip(1).step_by(2);
        for carrier in named {
            let is_there = match carrier.strip_suffix('/') {
                Some(module) => {
                    root().join("src").join(module).is_dir() || root().join(module).is_dir()
                }
                None if carrier.ends_with(".rs") => root().join("src").join(carrier).is_file(),
                None => declarations.contains_key(carrier),
            };
            assert!(is_there, "`{word}`: there is no `{carrier}`");
        }
    }
    assert!(words > 40, "{words} words");
}

#[test]
fn declarations_are_found() {
    assert_eq!(declared("pub(crate) struct Shown<'a> {"), Some("Shown"));
    assert_eq!(declared("type Of = u32;"), Some("Of"));
    assert_eq!(declared("    pub enum What {"), Some("What"));
    assert_eq!(declared("    type_of(One)"), None);
    assert_eq!(declared("/// struct Shown"), None);
    assert!(declarations()["Progress"].contains("language/progress.rs"));
}
