//! Collector of the diagnostics of one file, up to a bound.

use chiaro_locale::{tr, trn};

use super::NotFilled;
use crate::diag::{Diagnostic, WithWarnings};

/// Greatest number of problems of one file that are told; further ones are counted.
const MAX_TOLD: usize = 20;

/// The diagnostics of one file.
pub(super) struct FileReport {
    file: String,
    /// Part of the file that is being read.
    part: &'static str,
    told: Vec<Diagnostic>,
    untold: usize,
    has_errors: bool,
}

impl FileReport {
    pub(super) fn new(file: &str) -> Self {
        Self { file: file.to_owned(), part: "", told: Vec::new(), untold: 0, has_errors: false }
    }

    /// Sets the part of the file that is read from here on: an entry of an archive, a file of a
    /// folder.
    pub(super) fn reads(&mut self, part: &'static str) {
        self.part = part;
    }

    /// The part of the file that is being read.
    pub(super) fn part(&self) -> &'static str {
        self.part
    }

    /// Adds a diagnostic of this file. The first error is told even beyond the bound.
    pub(super) fn add(&mut self, problem: Diagnostic) {
        let is_first_error = problem.is_error() && !self.has_errors;
        self.has_errors |= problem.is_error();
        if self.told.len() < MAX_TOLD || is_first_error {
            self.told.push(problem.in_file(self.file.as_str()));
        } else {
            self.untold += 1;
        }
    }

    /// Adds the diagnostics of a document that is the part that is being read, with its lines.
    pub(super) fn add_document(&mut self, problems: Vec<Diagnostic>) {
        for mut problem in problems {
            let line = problem.place.at.take().map(|at| tr!(", line {line}", line = at.line));
            let line = line.unwrap_or_default();
            problem.message = format!("`{}`{line}: {}", self.part, problem.message);
            self.add(problem);
        }
    }

    /// Notes that the work was stopped: no other problem is worth telling.
    pub(super) fn stop(&mut self) {
        self.told.clear();
        self.add(NotFilled::Stopped.into());
    }

    /// True if the file cannot be used.
    pub(super) fn has_errors(&self) -> bool {
        self.has_errors
    }

    /// The result of reading: the value with all warnings, or all diagnostics if there is an error.
    pub(super) fn finish<T>(
        mut self,
        value: Option<T>,
    ) -> Result<WithWarnings<T>, Vec<Diagnostic>> {
        if self.untold > 0 {
            let message = trn!(
                count = self.untold,
                "there are {count} more problems, which are not listed",
                "there are {count} more problems, which are not listed"
            );
            self.told.push(Diagnostic::note("more-problems", message).in_file(self.file.as_str()));
        }
        match value {
            Some(value) if !self.has_errors => Ok(WithWarnings::new(value, self.told)),
            _ => Err(self.told),
        }
    }
}
