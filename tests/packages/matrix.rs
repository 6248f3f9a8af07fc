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
Nothing here is claimed: a number stands where the program that a package is for drew it, or what
stands in for it where the table says so, with a mesh and a camera of its own. It is the greatest
difference of a channel, of 255, from our own picture by the same software GPU, 160 by 120 pixels,
over all APIs; in brackets the number of pixels that differ by more than 1. `read` says that
compilers, or the program's own tools, took the look, and nothing drew it. `refused` says that the
export ends with a reason and what helps, `·` that the look was not run. By WebGL programs draw rows
from the bottom, and derivatives then come from the other row of each two by two pixels: edges and
bumps differ there, and nothing else does when the rows are turned ([hosts.md](hosts.md) has the
figures, and what a host has to do to draw a look by itself).

Written by `CHIARO_BLESS=1 cargo test --test packages` from `tests/golden/packages.txt`, which
`scripts/soak` fills: all looks take hours.

";

/// A column of the matrix: a package, one of its APIs, or one of its forms.
struct Column {
    slug: &'static str,
    /// API that the lines of the column name; empty where all count.
    api: &'static str,
    run_with: String,
}

impl Column {
    /// Name of the column: `three webgl`.
    fn name(&self) -> String {
        format!("{} {}", self.slug, self.api).trim_end().to_owned()
    }

    /// True for a line of the table about a look in this column.
    fn is_about(&self, key: &str, look: &str) -> bool {
        let words: Vec<&str> = key.split(' ').collect();
        let [slug, api, of] = words[..] else { return false };
        slug == self.slug && of == look && (self.api.is_empty() || [self.api, "-"].contains(&api))
    }
}

/// Packages whose APIs have columns of their own.
const APART: [&str; 2] = ["three", "babylon"];

/// Forms of packages that are judged by themselves: package, name in the table, and what ran them.
const FORMS: [(&str, &str, &str); 2] = [
    (
        "blender",
        "blender-cycles",
        "Blender 5.0.1, Cycles: the look in OSL, 256 samples a pixel beside 64 of ours",
    ),
    ("materialx", "materialx-graph", "the same, of the graph of MaterialX's own nodes alone"),
];

/// All columns, in the order of the packages.
fn columns() -> Vec<Column> {
    let mut columns = Vec::new();
    for package in PACKAGES {
        let slug = package.slug;
        let run_with = package.run_with.unwrap_or("stand-ins alone: the program was not run");
        if APART.contains(&slug) {
            for (api, order) in [("webgpu", "WebGPU"), ("webgl", "WebGL 2, rows from the bottom")] {
                columns.push(Column { slug, api, run_with: format!("{run_with}: {order}") });
            }
        } else {
            columns.push(Column { slug, api: "", run_with: run_with.to_owned() });
        }
        let forms = FORMS.iter().filter(|(of, ..)| *of == slug);
        columns.extend(forms.map(|(_, slug, run_with)| Column {
            slug,
            api: "",
            run_with: (*run_with).to_owned(),
        }));
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
    let cell = |column: &Column, look: &str| -> Option<Row> {
        let of_look = rows.iter().filter(|(key, _)| column.is_about(key, look));
        of_look.map(|(_, row)| row.clone()).reduce(Row::worse)
    };
    let columns = columns();
    for column in &columns {
        let cells: Vec<_> = looks.iter().map(|look| cell(column, &look.name)).collect();
        let count = |wanted: fn(&Option<Row>) -> bool| cells.iter().filter(|it| wanted(it)).count();
        let drawn = count(|it| matches!(it, Some(Row::Drawn(_))));
        let refused = count(|it| matches!(it, Some(Row::Refused(_))));
        let read = count(|it| matches!(it, Some(Row::Read)));
        let open = cells.len() - drawn - read - refused;
        let (name, run_with) = (column.name(), &column.run_with);
        let _infallible =
            writeln!(text, "| `{name}` | {run_with} | {drawn} | {read} | {refused} | {open} |");
    }
    let reasons = reasons(&rows);
    text.push_str("\n| look |");
    columns.iter().for_each(|column| text += &format!(" `{}` |", column.name()));
    text.push_str("\n| --- |");
    columns.iter().for_each(|_| text.push_str(" --- |"));
    text.push('\n');
    for look in &looks {
        let _infallible = write!(text, "| {} |", look.name);
        for column in &columns {
            let shown = match cell(column, &look.name) {
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
            text += &item(number + 1, reason);
        }
    }
    text
}

/// An item of a numbered list, its lines at most 100 characters long.
fn item(number: usize, content: &str) -> String {
    let start = format!("{number}.");
    let indent = " ".repeat(start.len() + 1);
    let mut text = start.clone();
    let mut width = start.len();
    for word in content.split(' ') {
        let length = word.chars().count();
        if width + 1 + length > 100 {
            text.push('\n');
            text += &indent;
            width = indent.len();
        } else {
            text.push(' ');
            width += 1;
        }
        text += word;
        width += length;
    }
    text.push('\n');
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
