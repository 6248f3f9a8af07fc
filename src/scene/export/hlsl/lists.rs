//! Values of structs and arrays as lists in braces.
//!
//! naga makes a struct by a function, `ConstructPair(1.0, 2.0)`, and zeros of an array by a cast,
//! `(float[4])0`. Compilers of HLSL want constants of a module without calls ("initializer must be
//! a compile-time constant"), and some know no cast to an array. A list in braces is the same value
//! to all of them, where it has a number for every member: those that fill up space, too.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::super::readable::{replace_words, words};
use super::fillings::{self, Structs};

/// Beginning of the names of naga's functions that make structs and arrays.
const CONSTRUCT: &str = "Construct";

/// The text with lists in the place of constructing functions where a constant is given, and of
/// zeros of arrays; constructing functions that nothing calls any more are left out.
pub(super) fn with_lists(text: &str) -> String {
    let structs = fillings::structs(text);
    let lines = text.lines().map(|line| line_with_lists(line, &structs) + "\n");
    with_named_arguments(&without_uncalled(&lines.collect::<String>()))
}

/// The text with the members' names for the numbered arguments of constructing functions.
fn with_named_arguments(text: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(|line| line.to_owned() + "\n").collect();
    for head in 0..lines.len() {
        let is_constructor =
            lines[head].contains(&format!(" {CONSTRUCT}")) && lines[head].ends_with(") {\n");
        if !is_constructor || lines[head].starts_with(' ') {
            continue;
        }
        let end = (head..lines.len()).find(|&at| lines[at] == "}\n").unwrap_or(head);
        let filled = |line: &String| {
            let (member, argument) = line.trim().strip_prefix("ret.")?.split_once(" = ")?;
            let argument = argument.strip_suffix(';')?;
            let is_numbered = argument.strip_prefix("arg")?.bytes().all(|c| c.is_ascii_digit());
            // `ret` is the result.
            (is_numbered && member != "ret").then(|| (argument.to_owned(), member.to_owned()))
        };
        let names: BTreeMap<String, String> = lines[head..end].iter().filter_map(filled).collect();
        for line in &mut lines[head..end] {
            *line = replace_words(line, |word| names.get(word).cloned());
        }
    }
    lines.concat()
}

fn line_with_lists(line: &str, structs: &Structs<'_>) -> String {
    let is_constant = line.starts_with("static const ");
    let line = if is_constant { in_braces(line, structs) } else { line.to_owned() };
    zeros_in_braces(&line).unwrap_or(line)
}

/// `float4 colors[2] = (float4[2])0;` as `float4 colors[2] = { (float4)0, (float4)0 };`; `None` for
/// other lines.
fn zeros_in_braces(line: &str) -> Option<String> {
    let (variable, value) = line.split_once(" = (")?;
    let (ty, count) = value.strip_suffix("])0;")?.split_once('[')?;
    let count: usize = count.parse().ok()?;
    let mut list = String::new();
    for index in 0..count {
        let _ = write!(list, "{}({ty})0", if index == 0 { "" } else { ", " });
    }
    Some(format!("{variable} = {{ {list} }};"))
}

/// A list of values that is being read.
struct OpenList<'a> {
    /// Character that ends the list.
    end: char,
    /// Members of the list's struct that are still to come; none of a list without a struct.
    members: &'a [fillings::Member<'a>],
}

impl OpenList<'_> {
    /// Zeros of the members that come next and fill up space, each made by `zero`.
    fn fill(&mut self, text: &mut String, zero: &str) {
        while let [member, rest @ ..] = self.members
            && member.is_filling
        {
            text.push_str(zero);
            self.members = rest;
        }
    }
}

/// A line with `ConstructX(a, b)` as `{a, b}`, at any depth.
fn in_braces(line: &str, structs: &Structs<'_>) -> String {
    let mut text = String::with_capacity(line.len());
    let mut open: Vec<OpenList<'_>> = Vec::new();
    let mut rest = line;
    while let Some(next) = rest.chars().next() {
        let word = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let word = &rest[..word.unwrap_or(rest.len())];
        if let Some(ty) = word.strip_prefix(CONSTRUCT)
            && rest[word.len()..].starts_with('(')
        {
            text.push('{');
            let members = structs.get(ty).map_or(&[][..], Vec::as_slice);
            let mut list = OpenList { end: '}', members };
            list.fill(&mut text, "0, ");
            open.push(list);
            rest = &rest[word.len() + 1..];
            continue;
        }
        let taken = word.len().max(next.len_utf8());
        match (next, open.last_mut()) {
            ('(', _) => {
                open.push(OpenList { end: ')', members: &[] });
                text.push('(');
            }
            (',', Some(list)) => {
                list.members = list.members.get(1..).unwrap_or_default();
                list.fill(&mut text, ", 0");
                text.push(',');
            }
            (')', Some(list)) => {
                list.members = list.members.get(1..).unwrap_or_default();
                list.fill(&mut text, ", 0");
                text.push(list.end);
                open.pop();
            }
            _ => text.push_str(&rest[..taken]),
        }
        rest = &rest[taken..];
    }
    text
}

/// The text without constructing functions that nothing calls.
fn without_uncalled(text: &str) -> String {
    let mut text = text.to_owned();
    // A function may be called by one that is removed, so that a removal may allow another.
    while let Some(name) = uncalled(&text) {
        let Some(start) = text.find(&format!(" {name}(")) else { return text };
        let start = text[..start].rfind('\n').map_or(0, |end| end + 1);
        let is_definition = text[start..].lines().next().is_some_and(|line| line.ends_with('{'));
        if !is_definition {
            return text;
        }
        let Some(end) = text[start..].find("\n}\n") else { return text };
        let end = start + end + "\n}\n".len();
        let end = if text[end..].starts_with('\n') { end + 1 } else { end };
        text.replace_range(start..end, "");
        let typedef = format!(" ret_{name}");
        let of_type = text.lines().filter(|line| line.contains(&typedef)).collect::<Vec<_>>();
        if let [one] = of_type[..]
            && one.starts_with("typedef ")
        {
            text = text.replacen(&format!("{one}\n"), "", 1);
        }
    }
    text
}

/// A constructing function whose name stands in the text only once.
fn uncalled(text: &str) -> Option<String> {
    let mut names: Vec<&str> = words(text)
        .map(|word| &text[word.span])
        .filter(|word| word.starts_with(CONSTRUCT))
        .collect();
    names.sort_unstable();
    let once = names.chunk_by(|a, b| a == b).find(|uses| uses.len() == 1)?;
    let is_function = text.contains(&format!(" {}(", once[0]));
    is_function.then(|| once[0].to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_are_lists_and_their_functions_go() {
        let text = "\
Inner ConstructInner(float arg0) {
    Inner ret = (Inner)0;
    ret.a = arg0;
    return ret;
}

Pair ConstructPair(Inner arg0, float2 arg1) {
    Pair ret = (Pair)0;
    return ret;
}

static const Pair PAIR = ConstructPair(ConstructInner((1.0 + 0.5)), float2(2.0, 3.0));
static const float2 NONE[2] = (float2[2])0;
Pair ConstructUsed(float arg0) {
    Pair ret = (Pair)0;
    ret.a = arg0;
    return ret;
}
float4 fs_main() {
    float2 sums[2] = (float2[2])0;
    return ConstructUsed(1.0).a;
}
";
        let wanted = "\
static const Pair PAIR = {{(1.0 + 0.5)}, float2(2.0, 3.0)};
static const float2 NONE[2] = { (float2)0, (float2)0 };
Pair ConstructUsed(float a) {
    Pair ret = (Pair)0;
    ret.a = a;
    return ret;
}
float4 fs_main() {
    float2 sums[2] = { (float2)0, (float2)0 };
    return ConstructUsed(1.0).a;
}
";
        assert_eq!(with_lists(text), wanted);
    }

    #[test]
    fn lists_have_zeros_for_what_fills_up_space() {
        let text = "\
struct Pair {
    float2 a;
    int _pad1_0;
    int _pad1_1;
    float4 b[2];
    float c;
    int _end_pad_0;
};

static const Pair PAIR = ConstructPair(float2(1.0, 2.0), Constructarray2_float4_(A, f(B, C)), 3.0);
";
        let wanted = "static const Pair PAIR = {float2(1.0, 2.0), 0, 0, {A, f(B, C)}, 3.0, 0};\n";
        let lists = with_lists(text);
        assert!(lists.ends_with(wanted), "{lists}");
    }

    #[test]
    fn broken_text_is_left_alone() {
        for text in
            ["static const A a = ConstructA(1.0\n", ")))\n", "A ConstructA(\n", "λ = (x])0;\n"]
        {
            let lists = with_lists(text);
            assert!(lists.ends_with('\n') && lists.lines().count() == 1, "{lists}");
        }
    }
}
