//! The table of differences between packages' pictures and our own.
//!
//! A line is a package, the API that drew, a look, the greatest difference of a channel of 8 bits,
//! and the number of pixels that differ by more than 1; or a look that the package's program has
//! read, where none draws; or a package and a look that it refuses, with the reason.
//! `CHIARO_BLESS=1` writes the lines that a test measures; lines of others stay.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::{env, fs};

use crate::support::root;

use crate::pictures::Difference;

/// Text at the top of the table.
const HEAD: &str = "\
# Differences of packages' pictures from our own: package, API, look, greatest difference of a
# channel of 8 bits, pixels beyond 1; `read` where the program took the look and none draws. At
# 160x120, one sample a pixel, on a software GPU.
# Written by CHIARO_BLESS=1 cargo test --test packages.
";

/// Word at the end of a look that was read and not drawn.
const READ: &str = " read";

/// Word before the reason of a refusal.
const REFUSED: &str = " refused: ";

/// Guards the file, which several tests write.
static FILE: Mutex<()> = Mutex::new(());

/// Result of a look in a package.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Row {
    /// Drawn, with this difference.
    Drawn(Difference),
    /// Read by what the package is for, or by its compilers, and drawn by nothing.
    Read,
    /// Refused, for this reason.
    Refused(String),
}

impl Row {
    /// The worse of two.
    pub(crate) fn worse(self, other: Self) -> Self {
        match (self, other) {
            (Self::Drawn(one), Self::Drawn(two)) => Self::Drawn(Difference {
                greatest: one.greatest.max(two.greatest),
                beyond: one.beyond.max(two.beyond),
            }),
            (refused @ Self::Refused(_), _) | (_, refused @ Self::Refused(_)) => refused,
            (Self::Read, _) | (_, Self::Read) => Self::Read,
        }
    }

    /// True if a look that was measured now is no worse than the row. A step of 8 bits is what
    /// rounding does.
    fn holds(&self, now: &Self) -> bool {
        match (self, now) {
            (Self::Drawn(bound), Self::Drawn(now)) => {
                now.greatest <= bound.greatest.max(1) && now.beyond <= bound.beyond
            }
            (Self::Refused(one), Self::Refused(two)) => one == two,
            (Self::Read, Self::Read) => true,
            _ => false,
        }
    }
}

/// Compares measured lines with the table's, or writes them. Keys are `package api look`.
pub(crate) fn check(measured: &BTreeMap<String, Difference>) {
    let drawn = measured.iter().map(|(key, found)| (key.clone(), Row::Drawn(*found)));
    check_rows(&drawn.collect());
}

/// Compares rows with the table's, or writes them. Keys are `package api look`; the API of a
/// refusal is `-`.
pub(crate) fn check_rows(measured: &BTreeMap<String, Row>) {
    let _guard = FILE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut known = read();
    if env::var("CHIARO_BLESS").is_ok_and(|value| value == "1") {
        let looks = |key: &str| {
            let mut words = key.split(' ');
            Some((words.next()?.to_owned(), words.nth(1)?.to_owned()))
        };
        // A look that was refused before and is drawn now is not both.
        known.retain(|key, row| {
            let is_refusal = matches!(row, Row::Refused(_));
            let again = measured.iter().find(|(new, _)| looks(new) == looks(key));
            again.is_none_or(|(_, new)| is_refusal == matches!(new, Row::Refused(_)))
        });
        known.extend(measured.iter().map(|(key, row)| (key.clone(), row.clone())));
        let lines = known.iter().map(|(key, row)| match row {
            Row::Drawn(Difference { greatest, beyond }) => format!("{key} {greatest} {beyond}\n"),
            Row::Read => format!("{key}{READ}\n"),
            Row::Refused(reason) => format!("{key}{REFUSED}{reason}\n"),
        });
        let text = HEAD.to_owned() + &lines.collect::<String>();
        fs::write(path(), text).expect("the table is written");
        return;
    }
    let mut complaints = Vec::new();
    for (key, now) in measured {
        match known.get(key) {
            Some(bound) if bound.holds(now) => {}
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

/// All lines of the table by `package api look`.
pub(crate) fn read() -> BTreeMap<String, Row> {
    let text = fs::read_to_string(path()).unwrap_or_default();
    let line = |line: &str| {
        if let Some((key, reason)) = line.split_once(REFUSED) {
            return Some((key.to_owned(), Row::Refused(reason.to_owned())));
        }
        if let Some(key) = line.strip_suffix(READ) {
            return Some((key.to_owned(), Row::Read));
        }
        let mut words = line.rsplitn(3, ' ');
        let beyond = words.next()?.parse().ok()?;
        let greatest = words.next()?.parse().ok()?;
        Some((words.next()?.to_owned(), Row::Drawn(Difference { greatest, beyond })))
    };
    text.lines().filter(|text| !text.starts_with('#')).filter_map(line).collect()
}
