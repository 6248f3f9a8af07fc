//! Pieces of a program's text: its functions, and the lines between them.

use super::word::words;

/// Piece of a text.
#[derive(Debug)]
pub(super) enum Piece<'m> {
    /// Lines outside of functions.
    Lines(Vec<String>),
    /// A function.
    Function(FunctionText<'m>),
}

/// Text of a function.
#[derive(Debug)]
pub(super) struct FunctionText<'m> {
    /// Lines before the function that belong to it: its comment.
    pub(super) comment: Vec<String>,
    /// Lines from the result's type to the opening brace.
    pub(super) head: Vec<String>,
    /// Lines between the braces.
    pub(super) body: Vec<String>,
    /// The function in naga's IR, with its name in WGSL; none for helpers that naga adds.
    pub(super) ir: Option<(&'m naga::Function, &'m str)>,
}

impl Piece<'_> {
    /// The piece as text.
    pub(super) fn text(&self) -> String {
        let joined = |lines: &[String]| lines.iter().map(|line| line.clone() + "\n").collect();
        match self {
            Self::Lines(lines) => joined(lines),
            Self::Function(FunctionText { comment, head, body, .. }) => {
                let parts: [String; 3] = [joined(comment), joined(head), joined(body)];
                parts.concat() + "}\n"
            }
        }
    }
}

/// Splits the text that naga wrote for `module`.
pub(super) fn split<'m>(text: &str, module: &'m naga::Module) -> Vec<Piece<'m>> {
    let lines: Vec<&str> = text.lines().collect();
    let owned = |lines: &[&str]| lines.iter().map(|&line| line.to_owned()).collect::<Vec<_>>();
    let mut pieces = Vec::new();
    let mut between: Vec<String> = Vec::new();
    let mut at = 0;
    while at < lines.len() {
        let found = function_name(&lines[at..]).and_then(|(name, head)| {
            let body = lines[at + head..].iter().position(|&line| line == "}")?;
            Some((name, head, body))
        });
        let Some((name, head, body)) = found else {
            between.push(lines[at].to_owned());
            at += 1;
            continue;
        };
        if !between.is_empty() {
            pieces.push(Piece::Lines(std::mem::take(&mut between)));
        }
        pieces.push(Piece::Function(FunctionText {
            comment: Vec::new(),
            head: owned(&lines[at..at + head]),
            body: owned(&lines[at + head..at + head + body]),
            ir: ir_of(name, module),
        }));
        at += head + body + 1;
    }
    if !between.is_empty() {
        pieces.push(Piece::Lines(between));
    }
    pieces
}

/// The name of the function that begins with these lines, and the number of lines to its opening
/// brace.
fn function_name<'t>(lines: &[&'t str]) -> Option<(&'t str, usize)> {
    let first = lines[0];
    let begins = first.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    let is_other = ["layout", "cbuffer", "struct", "typedef", "using"];
    let is_other = words(first).next().is_some_and(|word| is_other.contains(&&first[word.span]));
    let bracket = first.find('(').filter(|_| begins && !is_other)?;
    let name = words(&first[..bracket]).last().map(|word| &first[word.span])?;
    for (index, line) in lines.iter().enumerate() {
        let line = line.trim_end();
        if line.ends_with('{') {
            return Some((name, index + 1));
        }
        if line.ends_with([';', '}']) {
            return None;
        }
    }
    None
}

/// The function that naga calls `name`. naga adds `_` to names that end with a digit or are
/// keywords, and a number to names that are taken.
fn ir_of<'m>(name: &str, module: &'m naga::Module) -> Option<(&'m naga::Function, &'m str)> {
    if let Some(point) = module.entry_points.iter().find(|point| point.name == name) {
        return Some((&point.function, &point.name));
    }
    let named = |wanted: &str| {
        let mut functions = module.functions.iter();
        let is_it = |function: &naga::Function| function.name.as_deref() == Some(wanted);
        let found = functions.find(|(_, function)| is_it(function))?.1;
        Some((found, found.name.as_deref()?))
    };
    let bare = base(name);
    named(name).or_else(|| named(name.trim_end_matches('_'))).or_else(|| named(bare?)).or_else(
        || {
            // GLSL has one entry point, whatever its name is.
            let only = module.entry_points.first().filter(|_| name == "main")?;
            Some((&only.function, only.name.as_str()))
        },
    )
}

/// A name without the number that tells it apart from others: `dx` of `dx_1`.
pub(super) fn base(name: &str) -> Option<&str> {
    let (base, number) = name.rsplit_once('_')?;
    let is_number = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit());
    (is_number && !base.is_empty()).then_some(base)
}
