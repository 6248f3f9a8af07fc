//! The one [`Diagnostic`] that every floor reports with: what is wrong, where, and what to do.

use std::fmt;
use std::ops::Range;

use serde::Serialize;

use crate::ids::{NodePath, PortName};

/// How much a diagnostic matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// For information only.
    Note,
    /// The result stands, but is probably not what was meant.
    Warning,
    /// The thing named could not be used.
    Error,
}

/// A place in a text, counted from 1; columns count characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct LineColumn {
    /// From 1.
    pub line: u32,
    /// From 1, in characters.
    pub column: u32,
}

impl LineColumn {
    /// The place of a byte offset in `text`; offsets past the end give the end.
    pub fn of(text: &str, offset: usize) -> Self {
        let before = &text.as_bytes()[..offset.min(text.len())];
        let line_start = before.iter().rposition(|&b| b == b'\n').map_or(0, |p| p + 1);
        // Bytes that continue a UTF-8 sequence are no characters of their own.
        let characters = before[line_start..].iter().filter(|&&b| b & 0xC0 != 0x80).count();
        let lines = before.iter().filter(|&&b| b == b'\n').count();
        Self { line: lines as u32 + 1, column: characters as u32 + 1 }
    }
}

/// Everything known of where a problem is. All of it is optional; [`Diagnostic`]'s display shows
/// what there is.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Place {
    /// The file, as the user named it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Where in the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<LineColumn>,
    /// Where in the document, e.g. `nodes[3].values.offset`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub json_path: Option<String>,
    /// The node, through its groups.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "as_text")]
    pub node: Option<NodePath>,
    /// The port of that node.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub port: Option<PortName>,
    /// The bytes of WGSL source that the message speaks of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wgsl: Option<Range<usize>>,
}

fn as_text<S: serde::Serializer>(
    path: &Option<NodePath>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_str(path.as_ref().expect("skipped when absent"))
}

/// One problem, told so that the reader can mend it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Diagnostic {
    /// How much it matters.
    pub severity: Severity,
    /// A stable slug for scripts and tests, e.g. `unknown-kind`.
    pub code: &'static str,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// Where.
    #[serde(flatten)]
    pub place: Place,
    /// What to do about it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub hints: Vec<String>,
}

impl Diagnostic {
    /// An error.
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, message)
    }

    /// A warning.
    pub fn warning(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, message)
    }

    /// A note.
    pub fn note(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Note, code, message)
    }

    fn new(severity: Severity, code: &'static str, message: impl Into<String>) -> Self {
        Self { severity, code, message: message.into(), place: Place::default(), hints: Vec::new() }
    }

    /// Adds what to do about it.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }

    /// Adds the hint that [`nearest`] gives for `wrong`, if there is one.
    #[must_use]
    pub fn suggest<'a>(self, wrong: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        match nearest(wrong, known).as_slice() {
            [] => self,
            [one] => self.hint(format!("did you mean `{one}`?")),
            [most @ .., last] => {
                let most =
                    most.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
                self.hint(format!("did you mean {most} or `{last}`?"))
            }
        }
    }

    /// Names the file.
    #[must_use]
    pub fn in_file(mut self, file: impl Into<String>) -> Self {
        self.place.file = Some(file.into());
        self
    }

    /// Names the line and column.
    #[must_use]
    pub fn at(mut self, at: LineColumn) -> Self {
        self.place.at = Some(at);
        self
    }

    /// Names the place in the document.
    #[must_use]
    pub fn json_path(mut self, path: impl Into<String>) -> Self {
        self.place.json_path = Some(path.into());
        self
    }

    /// Names the node.
    #[must_use]
    pub fn node(mut self, path: NodePath) -> Self {
        self.place.node = Some(path);
        self
    }

    /// Names the port.
    #[must_use]
    pub fn port(mut self, port: PortName) -> Self {
        self.place.port = Some(port);
        self
    }

    /// Whether it stops the thing it speaks of from being used.
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
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        };
        write!(f, "{severity}[{}]: {}", self.code, self.message)?;
        let mut context = Vec::new();
        match (node, port) {
            (Some(node), Some(port)) => context.push(format!("node `{node}`, port `{port}`")),
            (Some(node), None) => context.push(format!("node `{node}`")),
            (None, Some(port)) => context.push(format!("port `{port}`")),
            (None, None) => {}
        }
        if let Some(path) = json_path {
            context.push(format!("at {path}"));
        }
        if !context.is_empty() {
            write!(f, " ({})", context.join(", "))?;
        }
        for hint in &self.hints {
            write!(f, "\n  help: {hint}")?;
        }
        Ok(())
    }
}

/// A value that can be used, and what is odd about it: the one channel of warnings. Whoever makes a
/// value of a file or a graph returns this; whoever shows something to people passes a list down to
/// [`tell`](Self::tell).
#[derive(Clone, Debug, PartialEq)]
pub struct Warned<T> {
    /// The value.
    pub value: T,
    /// Warnings and notes, in the order in which they were found; no errors.
    pub warnings: Vec<Diagnostic>,
}

impl<T> Warned<T> {
    /// A value with what is odd about it.
    pub fn new(value: T, warnings: Vec<Diagnostic>) -> Self {
        Self { value, warnings }
    }

    /// Hands the warnings to whoever collects them, and the value to the caller.
    pub fn tell(self, collected: &mut Vec<Diagnostic>) -> T {
        collected.extend(self.warnings);
        self.value
    }

    /// The value and the warnings.
    pub fn into_parts(self) -> (T, Vec<Diagnostic>) {
        (self.value, self.warnings)
    }

    /// Another value made of this one, with the same warnings.
    pub fn map<U>(self, make: impl FnOnce(T) -> U) -> Warned<U> {
        Warned { value: make(self.value), warnings: self.warnings }
    }
}

impl<T> From<T> for Warned<T> {
    fn from(value: T) -> Self {
        Self { value, warnings: Vec::new() }
    }
}

/// Whether any of them is an error.
pub fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(Diagnostic::is_error)
}

/// As many errors, and as many warnings, as are told of one document; the rest is counted.
pub const MAX_PROBLEMS: usize = 1000;

/// The first [`MAX_PROBLEMS`] errors and the first [`MAX_PROBLEMS`] others, with how many more
/// there are.
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

/// Tells how many problems are not told.
pub fn more_problems(count: usize) -> Diagnostic {
    Diagnostic::note(
        "more-problems",
        format!("there are {count} more problems, which are not listed"),
    )
}

/// Why the system refused something, in words, without the number that it has for that.
pub fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => {
            let text = error.to_string();
            text.rfind(" (os error ").map_or(text.clone(), |end| text[..end].to_owned())
        }
    }
}

/// Up to three of the `known` names that could have been meant by `wrong`, best first.
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
