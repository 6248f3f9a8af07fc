//! Instructions of looks, counted and kept, so that no look grows or shrinks unseen.
//!
//! Counted is the fragment stage in naga's own SPIR-V, each call replaced by the function that it
//! calls: a longer function counts as often as it is called. The counts are exact, the same on
//! every machine, and need no other program.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::{env, fs};

use crate::support::spirv::inlined_instructions;
use crate::support::{files, root};
use chiaro::compile::{CompileOptions, Live, compile};
use chiaro::document::{Look, Tier};
use chiaro::export::fragment_spirv_words;
use chiaro::files::Disk;
use chiaro::library::Library;

/// Folders of the counted looks.
const FOLDERS: [&str; 2] = ["examples/looks", "benches/handwritten/looks"];

/// File of the kept counts: a look's name and its counts in each of the [`TIERS`], a line each.
const FILE: &str = "tests/golden/instructions.txt";

/// First lines of the file.
const HEADER: &str = "\
# Instructions of each look's fragment stage in naga's SPIR-V, functions in the place of calls:
# look, exact, balanced, fast. CHIARO_BLESS=1 cargo test --test export writes them.
";

const TIERS: [Tier; 3] = [Tier::Exact, Tier::Balanced, Tier::Fast];

/// Percentage by which a count may differ from the kept one.
const TOLERANCE: usize = 2;

/// Counts of looks by their names, in each of the [`TIERS`].
type LookCounts = BTreeMap<String, [usize; 3]>;

/// Instructions of a look with every node in one tier, compiled as for export.
fn count(look: &Look, name: &str, tier: Tier) -> usize {
    let mut look = look.clone();
    look.set_every_tier(tier);
    let options = CompileOptions { live: Live::Exposed, ..CompileOptions::default() };
    let shader = compile(&look, Library::built_in(), &options)
        .unwrap_or_else(|problems| panic!("{name}: {}", problems[0]));
    let words =
        fragment_spirv_words(&shader.value.valid).unwrap_or_else(|error| panic!("{name}: {error}"));
    inlined_instructions(&words)
}

/// Counts of all looks, found by a walk so that none is forgotten.
fn counted() -> LookCounts {
    let paths = FOLDERS.iter().flat_map(|folder| files::below(&root().join(folder)));
    let documents: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    let mut counts = LookCounts::new();
    for path in documents {
        let name = path.file_stem().expect("a file").to_string_lossy().into_owned();
        let look = Look::load(&Disk, &path).value.expect("an example opens");
        let of_tiers = TIERS.map(|tier| count(&look, &name, tier));
        assert!(counts.insert(name.clone(), of_tiers).is_none(), "two looks are called {name}");
    }
    counts
}

/// Counts in the text of a file.
fn read(text: &str) -> LookCounts {
    let row = |line: &str| {
        let mut words = line.split_whitespace();
        let name = words.next()?.to_owned();
        let counts: Vec<usize> = words.map(|word| word.parse().ok()).collect::<Option<_>>()?;
        let counts: [usize; 3] = counts.try_into().ok()?;
        Some((name, counts))
    };
    let lines = text.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty());
    lines.map(|line| row(line).unwrap_or_else(|| panic!("{FILE}: `{line}` is no line"))).collect()
}

/// Text of the file that keeps these counts.
fn text(counts: &LookCounts) -> String {
    let mut text = HEADER.to_owned();
    for (name, [exact, balanced, fast]) in counts {
        let _ = writeln!(text, "{name} {exact} {balanced} {fast}");
    }
    text
}

/// Complaints about counts that differ from the kept ones by more than [`TOLERANCE`], and about
/// looks that only one side has.
fn complaints(kept: &LookCounts, now: &LookCounts) -> Vec<String> {
    let mut complaints = Vec::new();
    for (name, counts) in now {
        let Some(before) = kept.get(name) else {
            complaints.push(format!("{name}: no counts are kept, now {counts:?}"));
            continue;
        };
        for (tier, (&before, &count)) in TIERS.iter().zip(before.iter().zip(counts)) {
            let percents = 100.0 * (count as f64 / before as f64 - 1.0);
            let told = format!("{name}, {tier:?}: {before} kept, now {count} ({percents:+.1}%)");
            if 100 * count > (100 + TOLERANCE) * before {
                complaints.push(format!("{told}: the look grew"));
            } else if 100 * count < (100 - TOLERANCE) * before {
                complaints.push(format!("{told}: bless it, so that the gain is kept"));
            }
        }
    }
    let gone = kept.keys().filter(|name| !now.contains_key(*name));
    complaints.extend(gone.map(|name| format!("{name}: counts are kept, and there is no look")));
    complaints
}

/// Counts of all looks are the kept ones within [`TOLERANCE`]. `CHIARO_BLESS=1 cargo test --test
/// export` writes them anew.
#[test]
fn looks_keep_their_instructions() {
    let path = root().join(FILE);
    let now = counted();
    if env::var("CHIARO_BLESS").is_ok_and(|value| value == "1") {
        fs::write(&path, text(&now)).expect("the counts can be written");
        return;
    }
    let complaints = complaints(&read(&fs::read_to_string(&path).unwrap_or_default()), &now);
    let how = "if this is meant: CHIARO_BLESS=1 cargo test --test export, and read the difference";
    assert!(complaints.is_empty(), "{FILE}:\n{}\n{how}", complaints.join("\n"));
}

#[test]
fn growth_and_unkept_gains_are_found() {
    let kept = "# exact, balanced, fast\nclay 1000 500 100\ngone 1 1 1\n";
    let now = "clay 1020 511 97\nnew 1 1 1\n";
    assert_eq!(
        complaints(&read(kept), &read(now)),
        [
            "clay, Balanced: 500 kept, now 511 (+2.2%): the look grew",
            "clay, Fast: 100 kept, now 97 (-3.0%): bless it, so that the gain is kept",
            "new: no counts are kept, now [1, 1, 1]",
            "gone: counts are kept, and there is no look",
        ]
    );
    assert_eq!(read(&text(&read(kept))), read(kept));
}
