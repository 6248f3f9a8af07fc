//! The matrix of looks and packages, `docs/export.md`, written from the table of differences.

use std::fmt::Write as _;
use std::{env, fs};

use chiaro::export::package::PACKAGES;

use crate::pictures::example_looks;
use crate::support::root;
use crate::table::{self, Row};

/// Text above the tables.
const HEAD: &str = "\
# Looks in other programs

What became of every example look in every package that `chiaro export LOOK --to PACKAGE` writes.
Nothing here is claimed: a number stands where the program that a package is for drew it, with a
mesh and a camera of its own, and is the greatest difference of a channel, of 255, from our own
picture by the same software GPU, 160 by 120 pixels, over all APIs; in brackets the number of pixels
that differ by more than 1. `read` says that compilers, or the program's own tools, took the look,
and nothing drew it. `refused` says that the export ends with a reason and what helps, `·`
that the look was not run. What a host has to do to draw a look by itself is in
[hosts.md](hosts.md).

Written by `CHIARO_BLESS=1 cargo test --test packages` from `tests/golden/packages.txt`, which
`scripts/soak` fills: all looks take hours.

";

/// A column of the matrix: a package, or one of its forms.
struct Column {
    slug: &'static str,
    run_with: &'static str,
}

/// Forms of packages that are judged by themselves, each behind its package.
const FORMS: [(&str, Column); 1] = [(
    "materialx",
    Column {
        slug: "materialx-graph",
        run_with: "the same, of the graph of MaterialX's own nodes alone",
    },
)];

/// All columns, in the order of the packages.
fn columns() -> Vec<Column> {
    let mut columns = Vec::new();
    for package in PACKAGES {
        let run_with = package.run_with.unwrap_or("nothing: the program itself was not run");
        columns.push(Column { slug: package.slug, run_with });
        let forms = FORMS.into_iter().filter(|(of, _)| *of == package.slug);
        columns.extend(forms.map(|(_, column)| column));
    }
    columns
}

/// The document, as the table has it now.
fn document() -> String {
    let rows = table::read();
    let looks = example_looks();
    let mut text = HEAD.to_owned();
    text.push_str("| package | run with | looks drawn | read | refused | not run |\n");
    text.push_str("| --- | --- | --- | --- | --- | --- |\n");
    let cell = |slug: &str, look: &str| -> Option<Row> {
        let of_look = rows.iter().filter(|(key, _)| {
            let mut words = key.split(' ');
            words.next() == Some(slug) && words.nth(1) == Some(look)
        });
        of_look.map(|(_, row)| row.clone()).reduce(Row::worse)
    };
    let columns = columns();
    for column in &columns {
        let cells: Vec<_> = looks.iter().map(|look| cell(column.slug, &look.name)).collect();
        let count = |wanted: fn(&Option<Row>) -> bool| cells.iter().filter(|it| wanted(it)).count();
        let drawn = count(|it| matches!(it, Some(Row::Drawn(_))));
        let refused = count(|it| matches!(it, Some(Row::Refused(_))));
        let read = count(|it| matches!(it, Some(Row::Read)));
        let open = cells.len() - drawn - read - refused;
        let Column { slug, run_with } = column;
        let _infallible =
            writeln!(text, "| `{slug}` | {run_with} | {drawn} | {read} | {refused} | {open} |");
    }
    let reasons = reasons(&rows);
    text.push_str("\n| look |");
    columns.iter().for_each(|column| text += &format!(" `{}` |", column.slug));
    text.push_str("\n| --- |");
    columns.iter().for_each(|_| text.push_str(" --- |"));
    text.push('\n');
    for look in &looks {
        let _infallible = write!(text, "| {} |", look.name);
        for column in &columns {
            let shown = match cell(column.slug, &look.name) {
                Some(Row::Drawn(found)) if found.beyond == 0 => found.greatest.to_string(),
                Some(Row::Drawn(found)) => format!("{} ({})", found.greatest, found.beyond),
                Some(Row::Read) => "read".to_owned(),
                Some(Row::Refused(reason)) => {
                    let number = reasons.iter().position(|one| *one == reason).unwrap_or_default();
                    format!("refused {}", number + 1)
                }
                None => "·".to_owned(),
            };
            let _infallible = write!(text, " {shown} |");
        }
        text.push('\n');
    }
    if !reasons.is_empty() {
        text.push_str("\nRefused:\n\n");
        for (number, reason) in reasons.iter().enumerate() {
            let _infallible = writeln!(text, "{}. {reason}", number + 1);
        }
    }
    text
}

/// All reasons of refusals, each once, in the order of their first look.
fn reasons(rows: &std::collections::BTreeMap<String, Row>) -> Vec<String> {
    let mut reasons: Vec<String> = Vec::new();
    for row in rows.values() {
        if let Row::Refused(reason) = row
            && !reasons.contains(reason)
        {
            reasons.push(reason.clone());
        }
    }
    reasons
}

/// The matrix in the documentation is what the table has.
#[test]
fn the_matrix_is_that_of_the_table() {
    // Written after the other tests have written their lines.
    let path = root().join("docs/export.md");
    let wanted = document();
    if env::var("CHIARO_BLESS").is_ok_and(|value| value == "1") {
        fs::write(&path, wanted).expect("the matrix is written");
        return;
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    let how = "run CHIARO_BLESS=1 cargo test --test packages matrix, after the table is written";
    assert!(found == wanted, "docs/export.md is not what the table says: {how}");
}
