//! Problems in words.

use crate::diag::Diagnostic;

/// A problem with its hints, one a line, for people.
pub(crate) fn sentence(problem: &Diagnostic) -> String {
    let mut text = problem.message.clone();
    for hint in &problem.hints {
        text += "\n";
        text += hint;
    }
    text
}
