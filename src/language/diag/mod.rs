//! [`Diagnostic`], the one report of all floors: the problem, its place, and remedies.

use std::fmt;
use std::ops::Range;

use chiaro_locale::{tr, trn};
use serde::Serialize;

use crate::ids::{NodePath, PortName};

/// Severity of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// Note, for information only.
    Note,
    /// Warning: the result stands, but is probably not what was meant.
    Warning,
    /// Error: the named thing could not be used.
    Error,
}

/// Line and column in a text, counted from 1; columns count characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct LineColumn {
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
}

impl LineColumn {
    /// Line and column of a byte offset in `text`; offsets past the end give the end.
    pub fn of(text: &str, offset: usize) -> Self {
        let before = &text.as_bytes()[..offset.min(text.len())];
        let line_start = before.iter().rposition(|&b| b == b'\n').map_or(0, |p| p + 1);
        // Continuation bytes of UTF-8 are no characters of their own.
        let characters = before[line_start..].iter().filter(|&&b| b & 0xC0 != 0x80).count();
        let lines = before.iter().filter(|&&b| b == b'\n').count();
        Self { line: lines as u32 + 1, column: characters as u32 + 1 }
    }
}

/// Place of a problem. Every field is optional; [`Diagnostic`]'s display shows those that are set.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Place {
    /// File name, as the user gave it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Line and column in the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<LineColumn>,
    /// JSON path in the document, e.g. `nodes[3].values.offset`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub json_path: Option<String>,
    /// Path of the node, through its groups.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "as_text")]
    pub node: Option<NodePath>,
    /// Port of that node.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub port: Option<PortName>,
    /// Byte range of WGSL source that the message is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wgsl: Option<Range<usize>>,
}

fn as_text<S: serde::Serializer>(
    path: &Option<NodePath>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_str(path.as_ref().expect("skipped when absent"))
}

/// Report of one problem, so that the reader can mend it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Diagnostic {
    /// Severity of the problem.
    pub severity: Severity,
    /// Code: a stable slug for scripts and tests, e.g. `unknown-kind`.
    pub code: &'static str,
    /// Description of the problem, in one sentence without a full stop.
    pub message: String,
    /// Place of the problem.
    #[serde(flatten)]
    pub place: Place,
    /// Remedies.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub hints: Vec<String>,
    /// Index of the remedy that asks whether a known name was meant.
    #[serde(skip)]
    pub suggestion: Option<usize>,
}

impl Diagnostic {
    /// New error.
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, message)
    }

    /// New warning.
    pub fn warning(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, message)
    }

    /// New note.
    pub fn note(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Note, code, message)
    }

    fn new(severity: Severity, code: &'static str, message: impl Into<String>) -> Self {
        let (message, place) = (message.into(), Place::default());
        Self { severity, code, message, place, hints: Vec::new(), suggestion: None }
    }

    /// Adds a remedy.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }

    /// Adds the hint that [`nearest`] gives for `wrong`, if there is one.
    #[must_use]
    pub fn suggest<'a>(mut self, wrong: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        let hint = match nearest(wrong, known).as_slice() {
            [] => return self,
            [one] => tr!("did you mean `{one}`?"),
            [most @ .., last] => {
                let most =
                    most.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
                tr!("did you mean {most} or `{last}`?")
            }
        };
        self.suggestion = Some(self.hints.len());
        self.hint(hint)
    }

    /// Sets the file.
    #[must_use]
    pub fn in_file(mut self, file: impl Into<String>) -> Self {
        self.place.file = Some(file.into());
        self
    }

    /// Sets the line and column.
    #[must_use]
    pub fn at(mut self, at: LineColumn) -> Self {
        self.place.at = Some(at);
        self
    }

    /// Sets the place in the document.
    #[must_use]
    pub fn json_path(mut self, path: impl Into<String>) -> Self {
        self.place.json_path = Some(path.into());
        self
    }

    /// Sets the node.
    #[must_use]
    pub fn node(mut self, path: NodePath) -> Self {
        self.place.node = Some(path);
        self
    }

    /// Sets the port.
    #[must_use]
    pub fn port(mut self, port: PortName) -> Self {
        self.place.port = Some(port);
        self
    }

    /// True for an error, which stops the named thing from being used.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Place { file, at, json_path, node, port, .. } = &self.place;
        let mut location = file.clone().unwrap_or_default();
        if let Some(LineColumn { line, column }) = at {
            let separator = if location.is_empty() { "" } else { ":" };
            location += &format!("{separator}{line}:{column}");
        }
        if !location.is_empty() {
            write!(f, "{location}: ")?;
        }
        let severity = match self.severity {
            Severity::Note => tr!("severity" => "note"),
            Severity::Warning => tr!("severity" => "warning"),
            Severity::Error => tr!("severity" => "error"),
        };
        write!(f, "{severity}[{}]: {}", self.code, self.message)?;
        let mut context = Vec::new();
        match (node, port) {
            (Some(node), Some(port)) => context.push(tr!("node `{node}`, port `{port}`")),
            (Some(node), None) => context.push(tr!("node `{node}`")),
            (None, Some(port)) => context.push(tr!("port `{port}`")),
            (None, None) => {}
        }
        if let Some(path) = json_path {
            context.push(tr!("at {path}"));
        }
        if !context.is_empty() {
            write!(f, " ({})", context.join(", "))?;
        }
        for hint in &self.hints {
            write!(f, "\n  {}", tr!("help: {hint}"))?;
        }
        Ok(())
    }
}

/// Value that can be used, with warnings: the one channel of warnings. A function that makes a
/// value of a file or a graph returns this type; code that shows results to people passes a list
/// down to [`tell`](Self::tell). A scene without what could not be read is such a value, too, and
/// then the errors of the parts that are missing are among its warnings.
#[derive(Clone, Debug, PartialEq)]
pub struct WithWarnings<T> {
    /// Value itself.
    pub value: T,
    /// Warnings and notes, and errors of parts that the value does without, in the order in which
    /// they were found.
    pub warnings: Vec<Diagnostic>,
}

impl<T> WithWarnings<T> {
    /// Value with warnings.
    pub fn new(value: T, warnings: Vec<Diagnostic>) -> Self {
        Self { value, warnings }
    }

    /// Moves the warnings to a list, and returns the value.
    pub fn tell(self, collected: &mut Vec<Diagnostic>) -> T {
        collected.extend(self.warnings);
        self.value
    }

    /// Value and warnings.
    pub fn into_parts(self) -> (T, Vec<Diagnostic>) {
        (self.value, self.warnings)
    }

    /// Another value made of this one, with the same warnings.
    pub fn map<U>(self, make: impl FnOnce(T) -> U) -> WithWarnings<U> {
        WithWarnings { value: make(self.value), warnings: self.warnings }
    }
}

impl<T> From<T> for WithWarnings<T> {
    fn from(value: T) -> Self {
        Self { value, warnings: Vec::new() }
    }
}

/// True if any of the diagnostics is an error.
pub fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(Diagnostic::is_error)
}

/// Greatest number of errors, and of warnings, that are reported of one document; the rest is
/// counted.
pub const MAX_PROBLEMS: usize = 1000;

/// First [`MAX_PROBLEMS`] errors and first [`MAX_PROBLEMS`] others, with a note of the number left
/// out.
pub fn bounded(mut problems: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let (all, mut errors, mut others) = (problems.len(), 0, 0);
    problems.retain(|problem| {
        let count = if problem.is_error() { &mut errors } else { &mut others };
        *count += 1;
        *count <= MAX_PROBLEMS
    });
    if problems.len() < all {
        problems.push(more_problems(all - problems.len()));
    }
    problems
}

/// Note on the number of problems that are not listed.
pub fn more_problems(count: usize) -> Diagnostic {
    Diagnostic::note(
        "more-problems",
        trn!(
            count,
            "there are {count} more problems, which are not listed",
            "there are {count} more problems, which are not listed"
        ),
    )
}

/// Reason of a system's error in words, without the number that the system has for it.
pub fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => tr!("there is no such file").to_owned(),
        _ => {
            let text = error.to_string();
            text.rfind(" (os error ").map_or(text.clone(), |end| text[..end].to_owned())
        }
    }
}

/// Up to three of the `known` names that `wrong` may stand for, best first.
pub fn nearest<'a>(wrong: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let lower = wrong.to_lowercase();
    let mut scored: Vec<(f64, &str)> = known
        .into_iter()
        .map(|name| {
            let candidate = name.to_lowercase();
            let mut score = strsim::jaro_winkler(&lower, &candidate);
            if lower.len() >= 3 && (candidate.contains(&lower) || lower.contains(&candidate)) {
                score += 0.1;
            }
            // One letter too many, too few or another, or two that changed places.
            if lower.len() >= 3 && strsim::osa_distance(&lower, &candidate) == 1 {
                score = score.max(0.9);
            }
            (score, name)
        })
        .filter(|(score, _)| *score >= 0.78)
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    let best = scored.first().map_or(0.0, |s| s.0);
    scored.into_iter().filter(|s| s.0 > best - 0.08).take(3).map(|s| s.1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_counts_characters() {
        assert_eq!(LineColumn::of("a\nλx", 4), LineColumn { line: 2, column: 2 });
        assert_eq!(LineColumn::of("", 9), LineColumn { line: 1, column: 1 });
    }

    #[test]
    fn near_names_are_found() {
        let known = ["profile", "curve", "color_ramp", "profile_preset"];
        assert_eq!(nearest("pofile", known)[0], "profile");
        assert_eq!(nearest("colour_ramp", known), ["color_ramp"]);
        assert!(nearest("zzz", known).is_empty());
    }

    #[test]
    fn display_says_where_and_what_to_do() {
        let text = Diagnostic::error("unknown-port", "there is no port `ofset`")
            .in_file("a.json")
            .at(LineColumn { line: 3, column: 7 })
            .node(NodePath::parse("rim/profile"))
            .port("ofset".into())
            .suggest("ofset", ["offset"])
            .to_string();
        assert_eq!(
            text,
            "a.json:3:7: error[unknown-port]: there is no port `ofset` (node `rim/profile`, port \
             `ofset`)\n  help: did you mean `offset`?"
        );
    }
}
