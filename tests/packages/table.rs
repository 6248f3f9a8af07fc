//! The table of differences between packages' pictures and our own.
//!
//! A line is a package, the API that drew, a look, the greatest difference of a channel of 8 bits,
//! and the number of pixels that differ by more than 1. `CHIARO_BLESS=1` writes the lines that a
//! test measures; lines of others stay.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::{env, fs};

use crate::support::root;

use crate::pictures::Difference;

/// Text at the top of the table.
const HEAD: &str = "\
# Differences of packages' pictures from our own: package, API, look, greatest difference of a
# channel of 8 bits, pixels beyond 1. At 160x120, one sample a pixel, on the software GPU of
# Chromium. Written by CHIARO_BLESS=1 cargo test --test packages.
";

/// Guards the file, which several tests write.
static FILE: Mutex<()> = Mutex::new(());

/// Compares measured lines with the table's, or writes them. Keys are `package api look`.
pub(crate) fn check(measured: &BTreeMap<String, Difference>) {
    let _guard = FILE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut known = read();
    if env::var("CHIARO_BLESS").is_ok_and(|value| value == "1") {
        known.extend(measured.iter().map(|(key, difference)| (key.clone(), *difference)));
        let lines = known.iter().map(|(key, found)| {
            let Difference { greatest, beyond } = found;
            format!("{key} {greatest} {beyond}\n")
        });
        let text = HEAD.to_owned() + &lines.collect::<String>();
        fs::write(path(), text).expect("the table is written");
        return;
    }
    let mut complaints = Vec::new();
    for (key, now) in measured {
        match known.get(key) {
            // A step of 8 bits is what rounding does.
            Some(bound) if now.greatest <= bound.greatest.max(1) && now.beyond <= bound.beyond => {}
            Some(bound) => complaints.push(format!("{key}: {now:?}, the table has {bound:?}")),
            None => complaints.push(format!("{key}: {now:?}, not in the table")),
        }
    }
    let how = "if this is meant: CHIARO_BLESS=1 cargo test --test packages";
    assert!(complaints.is_empty(), "{}\n{how}", complaints.join("\n"));
}

fn path() -> PathBuf {
    root().join("tests/golden/packages.txt")
}

fn read() -> BTreeMap<String, Difference> {
    let text = fs::read_to_string(path()).unwrap_or_default();
    let line = |line: &str| {
        let mut words = line.rsplitn(3, ' ');
        let beyond = words.next()?.parse().ok()?;
        let greatest = words.next()?.parse().ok()?;
        Some((words.next()?.to_owned(), Difference { greatest, beyond }))
    };
    text.lines().filter(|text| !text.starts_with('#')).filter_map(line).collect()
}
