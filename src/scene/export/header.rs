//! The comment that every exported text begins with.

use super::language::Request;

impl Request<'_> {
    /// The header: the program that made the file, and the bindings; `part` is the part of the
    /// module in the file, `binds` the bindings, a line each.
    pub(super) fn header(&self, part: &str, binds: &[String]) -> String {
        let language = self.language;
        let version = env!("CARGO_PKG_VERSION");
        let mut lines = vec![
            format!("{}: made by Chiaro {version}, {}.", self.title, language.label),
            format!("{part}{}", self.module.purpose),
        ];
        lines.extend(binds.iter().filter(|line| !line.is_empty()).cloned());
        lines.push(format!("{} says what to put there and how to draw.", self.description));
        if language.verified_by.is_none() {
            lines
                .push(format!("UNVERIFIED: no compiler of {} has seen this file.", language.label));
        }
        comment(&lines)
    }
}

/// Lines as a comment, in every language that we write.
pub(super) fn comment(lines: &[String]) -> String {
    lines.iter().map(|line| format!("// {line}\n")).collect()
}

/// A name of any content, made fit for a line of a comment. A backslash at the end of a line would
/// join the next line to it.
pub(super) fn title(name: &str) -> String {
    let name: String =
        name.chars().map(|c| if c.is_control() || c == '\\' { ' ' } else { c }).collect();
    let name = name.trim();
    if name.is_empty() { "A look".to_owned() } else { name.to_owned() }
}

/// `Kind: a, b.`, or nothing where there are no names.
pub(super) fn list(kind: &str, names: &[String]) -> String {
    if names.is_empty() { String::new() } else { format!("{kind}: {}.", names.join(", ")) }
}
