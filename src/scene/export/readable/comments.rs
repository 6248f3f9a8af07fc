//! Comments of the WGSL source, put where they belong in another language's text.

use super::inline::DeclarationLine;
use super::pieces::{FunctionText, Piece, base};
use super::source::{Anchor, DeclarationComments, Flow, SourceComments};
use super::word::words;

/// Puts all comments in place; one whose statement is not found again is left out.
pub(super) fn place(pieces: &mut [Piece<'_>], source: &SourceComments) {
    for piece in pieces {
        match piece {
            Piece::Lines(lines) => *lines = with_comments(lines, source),
            Piece::Function(function) => {
                let Some((_, name)) = function.ir else { continue };
                if let Some(comments) = source.declaration(name) {
                    function.comment.clone_from(&comments.before);
                    place_inside(function, comments);
                }
            }
        }
    }
}

/// Comments of what is called `name` in the text. naga adds `_` or a number to names.
fn of<'a, T>(name: &str, found: impl Fn(&str) -> Option<&'a T>) -> Option<&'a T> {
    let without_end = || found(name.trim_end_matches('_'));
    found(name).or_else(without_end).or_else(|| found(base(name)?))
}

/// Lines of structs and constants with their comments.
fn with_comments(lines: &[String], source: &SourceComments) -> Vec<String> {
    let mut result = Vec::with_capacity(lines.len());
    let mut within: Option<&DeclarationComments> = None;
    for line in lines {
        if let Some(name) = declared(line) {
            within = of(name, |name| source.declaration(name));
            result.extend(within.iter().flat_map(|comments| &comments.before).cloned());
        } else if line.starts_with('}') {
            within = None;
        } else if let (Some(comments), Some(name)) = (within, member(line)) {
            let comments = of(name, |name| comments.members.get(name));
            let indented = comments.into_iter().flatten().map(|line| format!("    {line}"));
            result.extend(indented);
        }
        result.push(line.clone());
    }
    result
}

/// The name of a struct or a constant that a line begins.
fn declared(line: &str) -> Option<&str> {
    let mut names = words(line).map(|word| &line[word.span]);
    match names.next()? {
        "struct" => names.next(),
        "static" | "const" | "constant" => {
            DeclarationLine::of(line).filter(|found| found.indent == 0).map(|found| found.name)
        }
        _ => None,
    }
}

/// The name of a member in `    float4 clip : SV_Position;` or `    float x [[color(0)]];`.
fn member(line: &str) -> Option<&str> {
    let line = line.strip_prefix("    ").filter(|line| line.ends_with(';'))?;
    let line = line.split(" : ").next().unwrap_or(line);
    let line = line.split('[').next().unwrap_or(line);
    words(line).last().map(|word| &line[word.span])
}

/// Puts comments before the statements of a function.
fn place_inside(function: &mut FunctionText<'_>, comments: &DeclarationComments) {
    let body = &function.body;
    let flow = flow(body);
    let kinds: Vec<Flow> = flow.iter().map(|(_, kind)| *kind).collect();
    let returns = lines_with(body, "return");
    let mut before: Vec<(usize, &[String])> = Vec::new();
    for (anchor, lines) in comments.inside.iter().filter(|(_, lines)| !lines.is_empty()) {
        let at = match anchor {
            Anchor::Value(name, ordinal) => {
                let declares = |line: &String| {
                    let declared = DeclarationLine::of(line)?;
                    of(declared.name, |found| (found == name).then_some(name)).map(|_| ())
                };
                let mut all = body.iter().enumerate().filter(|(_, line)| declares(line).is_some());
                all.nth(*ordinal).map(|(at, _)| at)
            }
            Anchor::Flow(index) if kinds == comments.flow => flow.get(*index).map(|(at, _)| *at),
            Anchor::Return(index) if returns.len() == comments.returns => {
                returns.get(*index).copied()
            }
            Anchor::Flow(_) | Anchor::Return(_) => None,
        };
        before.extend(at.map(|at| (at, lines.as_slice())));
    }
    before.sort_by_key(|(at, _)| *at);
    for (at, lines) in before.into_iter().rev() {
        let line = &function.body[at];
        let indent = " ".repeat(line.len() - line.trim_start().len());
        let is_blank = |line: &String| line.is_empty();
        let indented =
            |line| if is_blank(line) { String::new() } else { format!("{indent}{line}") };
        let lines: Vec<String> = lines.iter().map(indented).collect();
        function.body.splice(at..at, lines);
    }
}

/// The branches and loops of the source in a text, in order, by their lines; what naga adds to
/// loops is left out.
fn flow(body: &[String]) -> Vec<(usize, Flow)> {
    let is_added = |line: &&String| line.contains("loop_init") || line.contains("loop_bound");
    let mut found = Vec::new();
    for (at, line) in body.iter().enumerate().filter(|(_, line)| !is_added(line)) {
        for word in words(line) {
            match &line[word.span] {
                "if" => found.push((at, Flow::Branch)),
                "while" | "for" => found.push((at, Flow::Loop)),
                _ => {}
            }
        }
    }
    found
}

/// The lines in which `word` stands, as often as it does.
fn lines_with(body: &[String], word: &str) -> Vec<usize> {
    let lines = body.iter().enumerate();
    let count = |line: &str| words(line).filter(|found| &line[found.span.clone()] == word).count();
    lines.flat_map(|(at, line)| std::iter::repeat_n(at, count(line))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_find_their_places() {
        let wgsl = "\
/// A pair.
struct Pair {
    /// The first.
    half: f32,
}

/// A number.
const NUMBER: f32 = 1.0;

/// Blends.
fn blend(a: f32) -> f32 {
    // Where it begins.
    let dx = a;
    // Not far.
    if dx > 1.0 {
        // Out.
        return dx;
    }
    return 0.0;
}
";
        let ir = naga::Function::default();
        let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
        let mut pieces = [
            Piece::Lines(lines(
                "struct Pair {\n    float half_;\n};\nstatic const float NUMBER = 1.0;",
            )),
            Piece::Function(FunctionText {
                comment: Vec::new(),
                head: lines("float blend(float a)\n{"),
                body: lines(
                    "    float dx_1 = a;\n    if ((dx_1 > 1.0)) {\n        return dx_1;\n    \
                     }\n    return 0.0;",
                ),
                ir: Some((&ir, "blend")),
            }),
        ];
        place(&mut pieces, &SourceComments::of(wgsl));
        let text: String = pieces.iter().map(Piece::text).collect();
        assert_eq!(
            text,
            "\
/// A pair.
struct Pair {
    /// The first.
    float half_;
};
/// A number.
static const float NUMBER = 1.0;
/// Blends.
float blend(float a)
{
    // Where it begins.
    float dx_1 = a;
    // Not far.
    if ((dx_1 > 1.0)) {
        // Out.
        return dx_1;
    }
    return 0.0;
}
"
        );
    }
}
