//! WGSL of statements and expressions: brackets only where they are needed, and lines that are not
//! too long.

use super::code::{Callee, Code, Line};
use crate::wgsl::rename_identifiers;

/// Greatest length of a line, as in the library's files.
pub(in crate::compile) const LINE: usize = 100;

/// Levels of WGSL's grammar, from what binds least to what needs no brackets.
pub(in crate::compile) mod level {
    pub(in crate::compile) const LOWEST: u8 = 0;
    /// `&&`, `||`
    pub(in crate::compile) const LOGICAL: u8 = 1;
    /// `&`, `|`, `^`: no operator binds their operands
    pub(in crate::compile) const BITS: u8 = 2;
    pub(in crate::compile) const RELATION: u8 = 3;
    pub(in crate::compile) const SHIFT: u8 = 4;
    pub(in crate::compile) const SUM: u8 = 5;
    pub(in crate::compile) const PRODUCT: u8 = 6;
    pub(in crate::compile) const UNARY: u8 = 7;
    pub(in crate::compile) const ATOM: u8 = 8;
}

/// Names of what code refers to.
pub(in crate::compile) trait CodeNames {
    fn parameter(&self, index: usize) -> String;
    fn local(&self, index: usize) -> String;
    /// The name of a declaration of the module, by the name in its file.
    fn declaration(&self, name: &str) -> String;
    fn made(&self, index: usize) -> String;
}

impl Code {
    pub(in crate::compile) fn level(&self) -> u8 {
        match self {
            Self::Text(_, level) | Self::Argument(_, level) => *level,
            Self::Unary(..) => level::UNARY,
            Self::Binary(operator, ..) => operator_level(operator),
            _ => level::ATOM,
        }
    }

    /// WGSL, in brackets where it binds less than `least`.
    pub(in crate::compile) fn wgsl(&self, least: u8, names: &dyn CodeNames) -> String {
        let text = self.bare(names);
        if self.level() < least { format!("({text})") } else { text }
    }

    fn bare(&self, names: &dyn CodeNames) -> String {
        let all = |parts: &[Self]| {
            let parts: Vec<String> =
                parts.iter().map(|part| part.wgsl(level::LOWEST, names)).collect();
            parts.join(", ")
        };
        match self {
            Self::Text(text, _) => rename_identifiers(text, |name| Some(names.declaration(name))),
            Self::Argument(text, _) => text.to_string(),
            Self::Parameter(index) => names.parameter(*index),
            Self::Local(index) => names.local(*index),
            Self::Constant(name) => names.declaration(name),
            Self::Member(of, name, _) => format!("{}.{name}", of.wgsl(level::ATOM, names)),
            Self::Index(of, index) => {
                format!("{}[{}]", of.wgsl(level::ATOM, names), index.wgsl(level::LOWEST, names))
            }
            Self::Unary(operator, of) => {
                // Two minus signs side by side would be another operator.
                let of = of.wgsl(level::UNARY, names);
                if of.starts_with('-') {
                    format!("{operator}({of})")
                } else {
                    format!("{operator}{of}")
                }
            }
            Self::Binary(operator, a, b) => {
                let (left, right) = operand_levels(operator, a, b);
                format!("{} {operator} {}", a.wgsl(left, names), b.wgsl(right, names))
            }
            Self::BuiltIn(name, parts) => format!("{name}({})", all(parts)),
            Self::Struct(name, parts) => format!("{}({})", names.declaration(name), all(parts)),
            Self::Call(Callee::Original(name), parts) => {
                format!("{}({})", names.declaration(name), all(parts))
            }
            Self::Call(Callee::Made(index), parts) => {
                format!("{}({})", names.made(*index), all(parts))
            }
        }
    }
}

fn operator_level(operator: &str) -> u8 {
    match operator {
        "&&" | "||" => level::LOGICAL,
        "&" | "|" | "^" => level::BITS,
        "<" | "<=" | ">" | ">=" | "==" | "!=" => level::RELATION,
        "<<" | ">>" => level::SHIFT,
        "+" | "-" => level::SUM,
        _ => level::PRODUCT,
    }
}

/// The least levels of an operator's operands.
fn operand_levels(operator: &str, a: &Code, b: &Code) -> (u8, u8) {
    let is_same = |code: &Code| matches!(code, Code::Binary(other, ..) if *other == operator);
    match operator_level(operator) {
        level::LOGICAL => (
            if is_same(a) { level::LOGICAL } else { level::RELATION },
            if is_same(b) { level::LOGICAL } else { level::RELATION },
        ),
        level::BITS => (if is_same(a) { level::BITS } else { level::UNARY }, level::UNARY),
        level::RELATION => (level::SHIFT, level::SHIFT),
        level::SHIFT => (level::UNARY, level::UNARY),
        level::SUM => (level::SUM, level::PRODUCT),
        _ => (level::PRODUCT, level::UNARY),
    }
}

/// Writes statements at an indentation.
pub(in crate::compile) fn write_lines(
    lines: &[Line],
    indent: usize,
    names: &dyn CodeNames,
    out: &mut String,
) {
    let text = |code: &Code| code.wgsl(level::LOWEST, names);
    for line in lines {
        match line {
            Line::Let(index, code) => {
                write_line(&format!("let {} = {};", names.local(*index), text(code)), indent, out);
            }
            Line::Var(index, ty, None) => {
                let ty = rename_identifiers(ty, |name| Some(names.declaration(name)));
                write_line(&format!("var {}: {ty};", names.local(*index)), indent, out);
            }
            Line::Var(index, _, Some(code)) => {
                write_line(&format!("var {} = {};", names.local(*index), text(code)), indent, out);
            }
            Line::Assign(place, code) => {
                write_line(&format!("{} = {};", text(place), text(code)), indent, out);
            }
            Line::If(condition, accept, reject) => {
                write_line(&format!("if {} {{", text(condition)), indent, out);
                write_lines(accept, indent + 1, names, out);
                if !reject.is_empty() {
                    write_line("} else {", indent, out);
                    write_lines(reject, indent + 1, names, out);
                }
                write_line("}", indent, out);
            }
            Line::Loop(body, continuing, break_if) => {
                write_line("loop {", indent, out);
                write_lines(body, indent + 1, names, out);
                if !continuing.is_empty() || break_if.is_some() {
                    write_line("continuing {", indent + 1, out);
                    write_lines(continuing, indent + 2, names, out);
                    if let Some(code) = break_if {
                        write_line(&format!("break if {};", text(code)), indent + 2, out);
                    }
                    write_line("}", indent + 1, out);
                }
                write_line("}", indent, out);
            }
            Line::Switch(selector, cases) => {
                write_line(&format!("switch {} {{", text(selector)), indent, out);
                for (value, body) in cases {
                    let head = if value == "default" { "default" } else { "case " };
                    let value = if value == "default" { "" } else { value };
                    write_line(&format!("{head}{value}: {{"), indent + 1, out);
                    write_lines(body, indent + 2, names, out);
                    write_line("}", indent + 1, out);
                }
                write_line("}", indent, out);
            }
            Line::Break => write_line("break;", indent, out),
            Line::Continue => write_line("continue;", indent, out),
            Line::Discard => write_line("discard;", indent, out),
            Line::Return(code) => write_line(&format!("return {};", text(code)), indent, out),
        }
    }
}

/// Writer of a line at a number of indentations of four blanks: broken after commas and before
/// operators where the line is longer than the library's own.
pub fn write_line(line: &str, indent: usize, out: &mut String) {
    let mut rest = line;
    let mut indent = 4 * indent;
    loop {
        out.extend(std::iter::repeat_n(' ', indent));
        let room = LINE.saturating_sub(indent).max(40);
        if rest.len() <= room {
            out.push_str(rest);
            out.push('\n');
            return;
        }
        let is_operator = |c: u8| b"+-*/%<>=!&|^".contains(&c);
        let bytes = rest.as_bytes();
        let is_break = |at: usize| {
            bytes[at] == b' '
                && (bytes[at - 1] == b',' || (is_operator(bytes[at + 1]) && at + 1 < room))
                && bytes[at + 1] != b'='
        };
        let last = bytes.len().saturating_sub(2).min(room);
        let first = (1..bytes.len().saturating_sub(1)).find(|&at| is_break(at));
        let Some(at) = best_break(bytes, last, is_break).or(first) else {
            out.push_str(rest);
            out.push('\n');
            return;
        };
        out.push_str(&rest[..at]);
        out.push('\n');
        if rest.len() == line.len() {
            indent += 4;
        }
        rest = &rest[at + 1..];
    }
}

/// The place to break a line at, up to `last`: in the outermost brackets that have one in the last
/// two thirds, as far on as may be.
fn best_break(line: &[u8], last: usize, is_break: impl Fn(usize) -> bool) -> Option<usize> {
    let mut depth = 0_i32;
    let mut best: Option<(i32, usize)> = None;
    for (at, &byte) in line.iter().enumerate().take(last + 1) {
        depth += i32::from(matches!(byte, b'(' | b'[' | b'{'));
        depth -= i32::from(matches!(byte, b')' | b']' | b'}'));
        if at > 0 && is_break(at) {
            let is_early = 3 * at < last;
            if best.is_none_or(|(least, place)| depth <= least || 3 * place < last && !is_early) {
                best = Some((depth, at));
            }
        }
    }
    best.map(|(_, at)| at)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parameters by the letters of the alphabet, and declarations by the names in their files.
    struct Letters;

    impl CodeNames for Letters {
        fn parameter(&self, index: usize) -> String {
            ["a", "b", "c", "d"][index].to_owned()
        }

        fn local(&self, index: usize) -> String {
            format!("local_{index}")
        }

        fn declaration(&self, name: &str) -> String {
            name.to_owned()
        }

        fn made(&self, index: usize) -> String {
            format!("made_{index}")
        }
    }

    const A: Code = Code::Parameter(0);
    const B: Code = Code::Parameter(1);
    const C: Code = Code::Parameter(2);
    const D: Code = Code::Parameter(3);

    fn binary(operator: &'static str, a: Code, b: Code) -> Code {
        Code::Binary(operator, Box::new(a), Box::new(b))
    }

    fn unary(operator: &'static str, of: Code) -> Code {
        Code::Unary(operator, Box::new(of))
    }

    fn wgsl(code: &Code) -> String {
        code.wgsl(level::LOWEST, &Letters)
    }

    #[test]
    fn arithmetic_has_the_brackets_that_it_needs() {
        assert_eq!(wgsl(&binary("*", binary("+", A, B), C)), "(a + b) * c");
        assert_eq!(wgsl(&binary("+", A, binary("*", B, C))), "a + b * c");
        assert_eq!(wgsl(&binary("-", A, binary("-", B, C))), "a - (b - c)");
        assert_eq!(wgsl(&binary("-", binary("-", A, B), C)), "a - b - c");
        assert_eq!(wgsl(&binary("/", A, binary("*", B, C))), "a / (b * c)");
        assert_eq!(wgsl(&unary("-", unary("-", A))), "-(-a)");
        assert_eq!(wgsl(&unary("-", Code::number("-1.0"))), "-(-1.0)");
        assert_eq!(wgsl(&unary("-", binary("*", A, B))), "-(a * b)");
        let sum = Box::new(binary("+", A, B));
        assert_eq!(wgsl(&Code::Member(sum, "xy".into(), 3)), "(a + b).xy");
    }

    #[test]
    fn conditions_have_the_brackets_that_they_need() {
        let (first, second) = (|| binary("<", A, B), || binary("<", C, D));
        assert_eq!(wgsl(&binary("&", first(), second())), "(a < b) & (c < d)");
        assert_eq!(wgsl(&binary("&&", first(), second())), "a < b && c < d");
        assert_eq!(wgsl(&unary("!", binary("&", A, B))), "!(a & b)");
        assert_eq!(wgsl(&binary("&", binary("&", A, B), C)), "a & b & c");
        assert_eq!(wgsl(&binary("|", binary("&", A, B), C)), "(a & b) | c");
        assert_eq!(wgsl(&binary("||", binary("&&", A, B), C)), "(a && b) || c");
    }

    #[test]
    fn arguments_need_no_brackets() {
        let parts = vec![binary("+", A, B), unary("-", C)];
        assert_eq!(wgsl(&Code::BuiltIn("max".into(), parts.clone())), "max(a + b, -c)");
        assert_eq!(wgsl(&Code::Call(Callee::Made(2), parts)), "made_2(a + b, -c)");
    }

    /// The lines of a statement that is broken, all of which are short enough.
    fn broken(line: &str, indent: usize) -> Vec<String> {
        let mut text = String::new();
        write_line(line, indent, &mut text);
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        assert!(lines.iter().all(|line| line.len() <= LINE), "{text}");
        let whole: Vec<&str> = lines.iter().map(|line| line.trim_start()).collect();
        assert_eq!(whole.join(" "), line);
        lines
    }

    #[test]
    fn short_lines_stay_whole() {
        let line = format!("return {};", "a".repeat(LINE - 12));
        assert_eq!(broken(&line, 1), [format!("    {line}")]);
    }

    #[test]
    fn long_lines_break_after_commas() {
        let arguments = vec!["some_argument"; 15].join(", ");
        let lines = broken(&format!("let value = some_function({arguments});"), 1);
        assert!(lines.len() > 2);
        for (index, line) in lines.iter().enumerate() {
            let is_last = index + 1 == lines.len();
            assert!(line.ends_with(if is_last { ");" } else { "," }), "{line}");
            let indent = if index == 0 { 4 } else { 8 };
            assert_eq!(line.len() - line.trim_start().len(), indent, "{line}");
        }
    }

    #[test]
    fn lines_break_at_the_outermost_brackets() {
        let color = "vec4f(0.7059, 0.3412, 0.2902, 1.0)";
        let lines =
            broken(&format!("let shadow_color = color_of(convexity, {color}, {color});"), 1);
        assert_eq!(lines[1], format!("        {color});"), "{lines:?}");
    }

    #[test]
    fn long_lines_break_before_operators() {
        let sum = ["some_value * some_factor"; 8].join(" + ");
        let lines = broken(&format!("return {sum};"), 2);
        assert!(lines.len() > 2);
        for line in &lines[1..] {
            assert!(line.trim_start().starts_with(['+', '*']), "{line}");
        }
    }

    #[test]
    fn long_statements_are_broken_where_they_stand() {
        let sum = (1..40).fold(A, |sum, _| binary("+", sum, B));
        let lines = [Line::If(binary("<", A, B), vec![Line::Let(0, sum)], Vec::new())];
        let mut text = String::new();
        write_lines(&lines, 1, &Letters, &mut text);
        assert!(text.starts_with("    if a < b {\n        let local_0 = a + b"), "{text}");
        assert!(text.contains("\n            + b"), "{text}");
        assert!(text.ends_with(" + b;\n    }\n"), "{text}");
        assert!(text.lines().all(|line| line.len() <= LINE), "{text}");
    }
}
