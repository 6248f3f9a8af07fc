//! Collects what is to be said of one file, all of it up to a bound.

use super::NotFilled;
use crate::diag::{Diagnostic, Warned};

/// How many problems of one file are told; the others are counted.
const MAX_TOLD: usize = 20;

/// The diagnostics of one file.
pub(super) struct Report {
    file: String,
    /// What of it is read.
    part: &'static str,
    told: Vec<Diagnostic>,
    untold: usize,
    has_errors: bool,
}

impl Report {
    pub(super) fn new(file: &str) -> Self {
        Self { file: file.to_owned(), part: "", told: Vec::new(), untold: 0, has_errors: false }
    }

    /// From here on that part of the file is read: an entry of an archive, a file of a folder.
    pub(super) fn reads(&mut self, part: &'static str) {
        self.part = part;
    }

    /// What is read.
    pub(super) fn part(&self) -> &'static str {
        self.part
    }

    /// Adds a diagnostic of this file. The first error is told however much was said before it.
    pub(super) fn add(&mut self, problem: Diagnostic) {
        let is_first_error = problem.is_error() && !self.has_errors;
        self.has_errors |= problem.is_error();
        if self.told.len() < MAX_TOLD || is_first_error {
            self.told.push(problem.in_file(self.file.as_str()));
        } else {
            self.untold += 1;
        }
    }

    /// Somebody has stopped it: nothing else is worth telling.
    pub(super) fn stop(&mut self) {
        self.told.clear();
        self.add(NotFilled::Stopped.into());
    }

    /// Whether the file cannot be used.
    pub(super) fn has_errors(&self) -> bool {
        self.has_errors
    }

    /// Everything that was said, as the error that it is where something is wrong.
    pub(super) fn finish<T>(mut self, value: Option<T>) -> Result<Warned<T>, Vec<Diagnostic>> {
        if self.untold > 0 {
            let message = format!("there are {} more problems, which are not listed", self.untold);
            self.told.push(Diagnostic::note("more-problems", message).in_file(self.file.as_str()));
        }
        match value {
            Some(value) if !self.has_errors => Ok(Warned::new(value, self.told)),
            _ => Err(self.told),
        }
    }
}
