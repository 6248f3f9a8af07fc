//! Small cases as files: an input, and Chiaro's diagnostics about the input in a sibling `.txt`.
//!
//! `tests/cases/SUBJECT/NAME.json` (or `.obj`, `.wgsl`, ...) is read as its subject says, and
//! `tests/cases/SUBJECT/NAME.txt` holds whether the input was read or refused, and every diagnostic
//! with its place in the input. A new case is a file; `CHIARO_BLESS=1` writes the diagnostics of
//! today, which are then reviewed like any other difference.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::{env, fs};

use chiaro_language::diag::{Diagnostic, Severity};

use crate::{files, root};

/// Largest number of characters shown of a line of the input.
const EXCERPT_LENGTH: usize = 90;

/// Holds every case of a subject to the text beside it. `read` gets the input's file name and
/// bytes, and gives whether the input was read, and its diagnostics.
///
/// # Panics
///
/// With the differences of all cases, and where a subject has no cases or a text has no input.
pub fn hold(subject: &str, read: impl Fn(&str, &[u8]) -> (bool, Vec<Diagnostic>)) {
    let folder = root().join("tests/cases").join(subject);
    let is_blessing = env::var_os("CHIARO_BLESS").is_some();
    let mut complaints = String::new();
    let mut expected = BTreeSet::new();
    let (texts, inputs): (Vec<_>, Vec<_>) = files::below(&folder)
        .into_iter()
        .partition(|path| path.extension().is_some_and(|extension| extension == "txt"));
    for input in &inputs {
        let name = input.file_name().unwrap_or_default().to_string_lossy();
        let bytes = fs::read(input).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (is_read, problems) = read(&name, &bytes);
        let said = described(is_read, &problems, &String::from_utf8_lossy(&bytes));
        let path = input.with_extension("txt");
        if is_blessing {
            fs::write(&path, &said).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        }
        let kept = fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
        if kept != said {
            let _ = write!(complaints, "\n{subject}/{name}:\n{}", difference(&kept, &said));
        }
        assert!(expected.insert(path), "{subject}/{name}: another input has this name");
    }
    for text in texts.iter().filter(|text| !expected.contains(*text)) {
        let _ = write!(complaints, "\n{}: its input is gone\n", text.display());
    }
    assert!(!inputs.is_empty(), "{}: there are no cases", folder.display());
    assert!(
        complaints.is_empty(),
        "what is said is not what stands beside the input (-); CHIARO_BLESS=1 writes what is said \
         now (+):\n{complaints}"
    );
}

/// The text beside an input: `read` or `refused`, then each diagnostic with its excerpt and hints.
fn described(is_read: bool, problems: &[Diagnostic], input: &str) -> String {
    let mut text = String::from(if is_read { "read\n" } else { "refused\n" });
    for problem in problems {
        let severity = match problem.severity {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        };
        let _ = write!(text, "\n{severity}[{}]", problem.code);
        let place = &problem.place;
        if let Some(at) = place.at {
            let _ = write!(text, " {}:{}", at.line, at.column);
        }
        if let Some(path) = place.json_path.as_deref().filter(|path| !path.is_empty()) {
            let _ = write!(text, " {path}");
        }
        if let Some(node) = &place.node {
            let _ = write!(text, ", node {node}");
        }
        if let Some(port) = &place.port {
            let _ = write!(text, ", port {port}");
        }
        text.push('\n');
        if let Some(at) = place.at {
            text += &excerpt(input, at.line as usize, at.column as usize);
        }
        let _ = writeln!(text, "  {}", problem.message.replace('\n', "\n  "));
        for hint in &problem.hints {
            let _ = writeln!(text, "  help: {}", hint.replace('\n', "\n  "));
        }
    }
    text
}

/// A line of the input with a mark under the character at `column`; of a long line the part around
/// the mark. Lines and columns from 1.
fn excerpt(input: &str, line: usize, column: usize) -> String {
    let Some(line) = input.lines().nth(line.saturating_sub(1)) else { return String::new() };
    let column = column.saturating_sub(1);
    let is_short = line.chars().count() <= EXCERPT_LENGTH;
    let from = if is_short { 0 } else { column.saturating_sub(EXCERPT_LENGTH / 2) };
    let shown: String = line
        .chars()
        .skip(from)
        .take(EXCERPT_LENGTH)
        .map(|letter| if letter.is_control() { '\u{fffd}' } else { letter })
        .collect();
    format!("    | {}\n    | {}^\n", shown.trim_end(), " ".repeat(column - from))
}

/// Difference of two texts, line by line: lines that are gone (-), new (+) and common to both.
fn difference(kept: &str, said: &str) -> String {
    let (kept, said): (Vec<&str>, Vec<&str>) = (kept.lines().collect(), said.lines().collect());
    // Length of the longest common subsequence of lines from each pair of places on.
    let mut common = vec![vec![0_usize; said.len() + 1]; kept.len() + 1];
    for i in (0..kept.len()).rev() {
        for j in (0..said.len()).rev() {
            common[i][j] = if kept[i] == said[j] {
                common[i + 1][j + 1] + 1
            } else {
                common[i + 1][j].max(common[i][j + 1])
            };
        }
    }
    let (mut i, mut j, mut text) = (0, 0, String::new());
    while i < kept.len() || j < said.len() {
        let (mark, line) = if i < kept.len() && j < said.len() && kept[i] == said[j] {
            (i, j) = (i + 1, j + 1);
            (' ', kept[i - 1])
        } else if j == said.len() || (i < kept.len() && common[i + 1][j] >= common[i][j + 1]) {
            i += 1;
            ('-', kept[i - 1])
        } else {
            j += 1;
            ('+', said[j - 1])
        };
        let _ = writeln!(text, "{mark} {line}");
    }
    text
}
