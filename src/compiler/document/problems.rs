//! Problems of a text, with their lines and columns.

use crate::diag::{Diagnostic, LineColumn, MAX_PROBLEMS, Severity, more_problems};

/// Distance between the known places of [`LineIndex`], in bytes.
const STRIDE: usize = 4096;

/// Index that finds lines and columns quickly, also in a file that is one long line.
#[derive(Clone, Debug)]
pub(super) struct LineIndex {
    /// Line and column of every [`STRIDE`]th byte.
    marks: Vec<LineColumn>,
}

impl LineIndex {
    pub(super) fn new(text: &str) -> Self {
        let mut place = LineColumn { line: 1, column: 1 };
        let mut marks = Vec::with_capacity(text.len() / STRIDE + 1);
        for block in text.as_bytes().chunks(STRIDE) {
            marks.push(place);
            place = advance(place, block);
        }
        Self { marks }
    }

    /// Line and column of a byte of the same text; offsets past the end give the end.
    pub(super) fn at(&self, text: &str, offset: usize) -> LineColumn {
        let offset = offset.min(text.len());
        let block = (offset / STRIDE).min(self.marks.len().saturating_sub(1));
        let start = self.marks.get(block).copied().unwrap_or(LineColumn { line: 1, column: 1 });
        advance(start, &text.as_bytes()[block * STRIDE..offset])
    }
}

/// Line and column after some more bytes.
fn advance(from: LineColumn, bytes: &[u8]) -> LineColumn {
    let lines = bytes.iter().filter(|&&b| b == b'\n').count() as u32;
    let line_start = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |p| p + 1);
    // Continuation bytes of UTF-8 are no characters of their own.
    let characters = bytes[line_start..].iter().filter(|&&b| b & 0xC0 != 0x80).count() as u32;
    let column = if lines > 0 { 1 } else { from.column };
    LineColumn { line: from.line + lines, column: column + characters }
}

/// Collector of the problems of one text.
pub(super) struct Problems {
    found: Vec<(usize, Diagnostic)>,
    errors: usize,
    warnings: usize,
}

impl Problems {
    pub(super) fn new() -> Self {
        Self { found: Vec::new(), errors: 0, warnings: 0 }
    }

    /// Adds a problem at a byte of the text.
    pub(super) fn push(&mut self, offset: usize, problem: Diagnostic) {
        let count =
            if problem.severity == Severity::Error { &mut self.errors } else { &mut self.warnings };
        *count += 1;
        if *count <= MAX_PROBLEMS {
            self.found.push((offset, problem));
        }
    }

    /// True if a problem of this severity will be reported, and not only counted.
    pub(super) fn takes(&self, problem: &Diagnostic) -> bool {
        let count = if problem.severity == Severity::Error { self.errors } else { self.warnings };
        count < MAX_PROBLEMS
    }

    /// All problems in the order of the text, with file, line and column.
    pub(super) fn finish(mut self, file: &str, text: &str, lines: &LineIndex) -> Vec<Diagnostic> {
        self.found.sort_by_key(|(offset, _)| *offset);
        let place = |(offset, problem): (usize, Diagnostic)| {
            problem.in_file(file).at(lines.at(text, offset))
        };
        let mut all: Vec<Diagnostic> = self.found.into_iter().map(place).collect();
        let left_out =
            self.errors.saturating_sub(MAX_PROBLEMS) + self.warnings.saturating_sub(MAX_PROBLEMS);
        if left_out > 0 {
            all.push(more_problems(left_out).in_file(file));
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_agree_with_counting() {
        let text: String =
            (0..4000).map(|i| ["a", "é\n", "🙂", "\n\n", "xyz"][i * 7 % 5]).collect();
        let lines = LineIndex::new(&text);
        for offset in (0..=text.len() + 10)
            .filter(|offset| *offset > text.len() || text.is_char_boundary(*offset))
        {
            assert_eq!(lines.at(&text, offset), LineColumn::of(&text, offset), "{offset}");
        }
        assert_eq!(LineIndex::new("").at("", 5), LineColumn { line: 1, column: 1 });
    }
}
