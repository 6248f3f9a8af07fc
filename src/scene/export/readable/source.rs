//! Comments of a WGSL source, by what they stand before.

use std::collections::BTreeMap;

use super::word::words;

/// Comments of a module's source, by the names of its declarations.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::export) struct SourceComments {
    declarations: BTreeMap<String, DeclarationComments>,
}

/// Comments of a declaration, as lines without indentation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct DeclarationComments {
    /// Lines before the declaration.
    pub(super) before: Vec<String>,
    /// Lines before each member of a struct.
    pub(super) members: BTreeMap<String, Vec<String>>,
    /// Lines inside a function, each with what it stands before.
    pub(super) inside: Vec<(Anchor, Vec<String>)>,
    /// Branches and loops of a function, in order.
    pub(super) flow: Vec<Flow>,
    /// Number of a function's returns.
    pub(super) returns: usize,
}

/// Statement of a function that comments stand before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    /// Declaration of a name, counted from 0 among the declarations of this name.
    Value(String, usize),
    /// Branch or loop, by its index among them.
    Flow(usize),
    /// Return, by its index among returns.
    Return(usize),
}

/// Statement that decides which statements run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flow {
    /// `if`
    Branch,
    /// `loop`, `for` or `while`
    Loop,
}

impl SourceComments {
    /// The comments of a module that is formatted as Chiaro formats WGSL: declarations begin at the
    /// left edge, statements and members with a line of their own.
    pub(in crate::export) fn of(wgsl: &str) -> Self {
        let mut found = Self::default();
        let mut pending = Vec::new();
        let mut within = None;
        for line in wgsl.lines() {
            let trimmed = line.trim();
            if trimmed.starts_with("//") {
                pending.push(comment_line(trimmed));
            } else if trimmed.is_empty() && within.is_some() {
                // A blank line parts the statements of a function.
                pending.push(String::new());
            } else if trimmed.is_empty() {
                pending.clear();
            } else if line.starts_with(['}', ')']) {
                pending.clear();
                within = None;
            } else if line.starts_with(char::is_whitespace) {
                let comments = std::mem::take(&mut pending);
                if let Some((name, is_struct)) = &within {
                    let declaration = found.declarations.entry(String::clone(name)).or_default();
                    if *is_struct {
                        declaration.add_member(trimmed, comments);
                    } else {
                        declaration.add_statement(trimmed, comments);
                    }
                }
            } else if let Some((name, is_struct)) = declared(line) {
                let before = std::mem::take(&mut pending);
                found.declarations.entry(name.to_owned()).or_default().before = before;
                within = (!line.ends_with(';')).then(|| (name.to_owned(), is_struct));
            }
        }
        found
    }

    /// The comments of a declaration; `None` for a name of no declaration.
    pub(super) fn declaration(&self, name: &str) -> Option<&DeclarationComments> {
        self.declarations.get(name)
    }
}

/// The name that a line declares, and whether it is a struct's; `None` for lines of attributes.
fn declared(line: &str) -> Option<(&str, bool)> {
    let mut names = words(line).map(|word| &line[word.span]);
    let keyword = names
        .by_ref()
        .find(|word| ["fn", "struct", "const", "override", "alias", "var"].contains(word))?;
    let name = if keyword == "var" {
        // `var<uniform> view: View;`
        let before = line.split(':').next().unwrap_or_default();
        words(before).last().map(|word| &line[word.span])
    } else {
        names.next()
    };
    Some((name?, keyword == "struct"))
}

/// A comment fit for every language: a line that ends with a backslash would join the next one.
fn comment_line(line: &str) -> String {
    let mut line = line;
    while let Some(shorter) = line.strip_suffix('\\').or_else(|| line.strip_suffix("??/")) {
        line = shorter.trim_end();
    }
    line.to_owned()
}

impl DeclarationComments {
    /// `@align(16) name: Type,`
    fn add_member(&mut self, line: &str, mut comments: Vec<String>) {
        comments.retain(|line| !line.is_empty());
        let before = line.split(':').next().unwrap_or_default();
        let name = words(before).last().map(|word| &before[word.span]);
        if let Some(name) = name.filter(|_| !comments.is_empty()) {
            self.members.insert(name.to_owned(), comments);
        }
    }

    fn add_statement(&mut self, line: &str, comments: Vec<String>) {
        let (flow, returns) = (self.flow.len(), self.returns);
        for (word, at) in words(line).map(|word| (&line[word.span.clone()], word.span.end)) {
            match word {
                "if" => self.flow.push(Flow::Branch),
                "loop" => self.flow.push(Flow::Loop),
                // naga tests the condition inside of the loop.
                "while" => self.flow.extend([Flow::Loop, Flow::Branch]),
                "for" => {
                    self.flow.push(Flow::Loop);
                    let condition = line[at..].split(';').nth(1).unwrap_or_default();
                    self.flow.extend((!condition.trim().is_empty()).then_some(Flow::Branch));
                }
                "return" => self.returns += 1,
                _ => {}
            }
        }
        let mut names = words(line).map(|word| &line[word.span]);
        let anchor = match names.next() {
            Some("let" | "var" | "const") => names.next().map(|name| {
                let same = |(anchor, _): &&(Anchor, Vec<String>)| {
                    matches!(anchor, Anchor::Value(other, _) if other == name)
                };
                Anchor::Value(name.to_owned(), self.inside.iter().filter(same).count())
            }),
            Some("if" | "loop" | "while" | "for") => Some(Anchor::Flow(flow)),
            Some("return") => Some(Anchor::Return(returns)),
            _ => None,
        };
        // Declarations without comments are counted too.
        let is_value = matches!(anchor, Some(Anchor::Value(..)));
        if let Some(anchor) = anchor.filter(|_| is_value || !comments.is_empty()) {
            self.inside.push((anchor, comments));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_are_known_by_what_they_stand_before() {
        let wgsl = "\
// A header.

/// A pair.
struct Pair {
    /// The first.
    /// Of two.
    @align(16) a: f32,
    b: f32,
}

/// Blends \\
@fragment
fn blend(a: f32)
    -> f32 {
    let x = a;
    // Why.
    if x > 1.0 {
        // Twice.
        let x = 2.0;
        return x;
    }
    for (var i = 0; i < 2; i++) {
    }
    // Nearly.
    return x;
}
";
        let found = SourceComments::of(wgsl);
        let pair = found.declaration("Pair").unwrap();
        assert_eq!(pair.before, ["/// A pair."]);
        assert_eq!(pair.members["a"], ["/// The first.", "/// Of two."]);
        assert_eq!(pair.members.len(), 1);
        let blend = found.declaration("blend").unwrap();
        assert_eq!(blend.before, ["/// Blends"]);
        assert_eq!(blend.flow, [Flow::Branch, Flow::Loop, Flow::Branch]);
        assert_eq!(blend.returns, 2);
        let commented: Vec<_> =
            blend.inside.iter().filter(|(_, lines)| !lines.is_empty()).cloned().collect();
        let wanted = [
            (Anchor::Flow(0), vec!["// Why.".to_owned()]),
            (Anchor::Value("x".to_owned(), 1), vec!["// Twice.".to_owned()]),
            (Anchor::Return(1), vec!["// Nearly.".to_owned()]),
        ];
        assert_eq!(commented, wanted);
        assert_eq!(SourceComments::of("}\n  λ\nfn\n"), SourceComments::default());
    }
}
