//! Statements and expressions of a function that is written anew, and their WGSL.

use std::rc::Rc;

use crate::wgsl::rename_identifiers;

/// Greatest length of a line, as in the library's files.
const LINE: usize = 100;

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

/// Function that a call names.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in crate::compile) enum Callee {
    /// As it stands in its file.
    Original(Rc<str>),
    /// Written anew: an index into the functions that were made.
    Made(usize),
}

/// Expression.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in crate::compile) enum Code {
    /// Text that is written as it is, but for names of declarations, with its level.
    Text(Rc<str>, u8),
    /// Text of the caller, with its level.
    Argument(Rc<str>, u8),
    /// Parameter of the function, by index.
    Parameter(usize),
    /// Variable of the function, by index.
    Local(usize),
    /// Constant of the module, by the name in its file.
    Constant(Rc<str>),
    /// Part of a struct, or of a vector with so many components.
    Member(Box<Self>, Rc<str>, usize),
    Index(Box<Self>, Box<Self>),
    Unary(&'static str, Box<Self>),
    Binary(&'static str, Box<Self>, Box<Self>),
    /// Call of a function of WGSL itself, or a value of one of its types.
    BuiltIn(Rc<str>, Vec<Self>),
    /// Value of a struct, by the name in its file.
    Struct(Rc<str>, Vec<Self>),
    Call(Callee, Vec<Self>),
}

/// Statement.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in crate::compile) enum Line {
    Let(usize, Code),
    Var(usize, Rc<str>, Option<Code>),
    Assign(Code, Code),
    If(Code, Vec<Self>, Vec<Self>),
    /// Body, what follows each turn, and the condition that ends the loop after it.
    Loop(Vec<Self>, Vec<Self>, Option<Code>),
    /// Selector and cases; the last text is `default`.
    Switch(Code, Vec<(String, Vec<Self>)>),
    Break,
    Continue,
    Discard,
    Return(Code),
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
    pub(super) fn number(text: &str) -> Self {
        let level = if text.starts_with('-') { level::UNARY } else { level::ATOM };
        Self::Text(text.into(), level)
    }

    /// True for what is no longer than a name: repeating it costs nothing.
    pub(in crate::compile) fn is_simple(&self) -> bool {
        match self {
            Self::Parameter(_) | Self::Local(_) | Self::Constant(_) => true,
            Self::Text(text, level) | Self::Argument(text, level) => {
                *level >= level::UNARY && text.len() <= 24
            }
            Self::Member(of, _, _) => of.is_simple(),
            _ => false,
        }
    }

    fn parts(&self) -> Vec<&Self> {
        match self {
            Self::Text(..)
            | Self::Argument(..)
            | Self::Parameter(_)
            | Self::Local(_)
            | Self::Constant(_) => Vec::new(),
            Self::Member(of, ..) | Self::Unary(_, of) => vec![of],
            Self::Index(a, b) | Self::Binary(_, a, b) => vec![a, b],
            Self::BuiltIn(_, parts) | Self::Struct(_, parts) | Self::Call(_, parts) => {
                parts.iter().collect()
            }
        }
    }

    fn parts_mut(&mut self) -> Vec<&mut Self> {
        match self {
            Self::Text(..)
            | Self::Argument(..)
            | Self::Parameter(_)
            | Self::Local(_)
            | Self::Constant(_) => Vec::new(),
            Self::Member(of, ..) | Self::Unary(_, of) => vec![of],
            Self::Index(a, b) | Self::Binary(_, a, b) => vec![a, b],
            Self::BuiltIn(_, parts) | Self::Struct(_, parts) | Self::Call(_, parts) => {
                parts.iter_mut().collect()
            }
        }
    }

    /// Calls `tell` with this expression and all within.
    pub(in crate::compile) fn each(&self, tell: &mut dyn FnMut(&Self)) {
        tell(self);
        for part in self.parts() {
            part.each(tell);
        }
    }

    /// Number of operators and calls.
    pub(in crate::compile) fn size(&self) -> usize {
        let mut size = 0;
        self.each(&mut |code| {
            size += usize::from(matches!(
                code,
                Self::Unary(..)
                    | Self::Binary(..)
                    | Self::BuiltIn(..)
                    | Self::Struct(..)
                    | Self::Call(..)
            ));
        });
        size
    }

    /// True if it calls a function, other than WGSL's own.
    pub(super) fn has_calls(&self) -> bool {
        let mut found = false;
        self.each(&mut |code| found |= matches!(code, Self::Call(..)));
        found
    }

    /// True if it names anything that a module declares.
    pub(in crate::compile) fn names_declarations(&self) -> bool {
        let mut found = false;
        self.each(&mut |code| {
            found |= matches!(code, Self::Constant(_) | Self::Struct(..) | Self::Call(..));
        });
        found
    }

    /// How often a parameter is read.
    pub(in crate::compile) fn reads(&self, parameter: usize) -> usize {
        let mut count = 0;
        self.each(&mut |code| count += usize::from(*code == Self::Parameter(parameter)));
        count
    }

    /// The expression with arguments in place of parameters.
    #[must_use]
    pub(in crate::compile) fn with_arguments(&self, arguments: &[Self]) -> Self {
        if let Self::Parameter(index) = self {
            return arguments.get(*index).cloned().unwrap_or_else(|| self.clone());
        }
        let mut code = self.clone();
        for part in code.parts_mut() {
            *part = part.with_arguments(arguments);
        }
        code.simplified()
    }

    /// The expression with another in place of a variable.
    #[must_use]
    pub(super) fn with_local(&self, local: usize, value: &Self) -> Self {
        if *self == Self::Local(local) {
            return value.clone();
        }
        let mut code = self.clone();
        for part in code.parts_mut() {
            *part = part.with_local(local, value);
        }
        code.simplified()
    }

    /// The expression where its parts have become something simpler: a vector put together from
    /// the components of another is that other.
    #[must_use]
    pub(super) fn simplified(self) -> Self {
        match self {
            Self::BuiltIn(name, parts) => match whole(&name, &parts) {
                Some(whole) => whole,
                None => Self::BuiltIn(name, parts),
            },
            Self::Member(of, name, width) => match part_of_vector(&of, &name) {
                Some(part) => part,
                None => Self::Member(of, name, width),
            },
            Self::Binary(operator @ ("+" | "-"), a, b) => {
                // a - -1 is a + 1.
                let positive = match &*b {
                    Self::Text(text, _) => text.strip_prefix('-').map(Self::number),
                    _ => None,
                };
                match positive {
                    Some(b) => {
                        Self::Binary(if operator == "+" { "-" } else { "+" }, a, Box::new(b))
                    }
                    None => Self::Binary(operator, a, b),
                }
            }
            other => other,
        }
    }

    fn level(&self) -> u8 {
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

const COMPONENTS: [&str; 4] = ["x", "y", "z", "w"];

/// The vector, or the first components of it, whose components a constructor lists in order.
pub(super) fn whole(name: &str, parts: &[Code]) -> Option<Code> {
    let count = match name {
        "vec2f" => 2,
        "vec3f" => 3,
        "vec4f" => 4,
        _ => return None,
    };
    let mut of: Option<(&Code, usize)> = None;
    let mut next = 0;
    for part in parts {
        let Code::Member(base, name, width) = part else { return None };
        if *width == 0 || of.is_some_and(|known| known != (base, *width)) {
            return None;
        }
        of = Some((base, *width));
        for component in name.split("").filter(|c| !c.is_empty()) {
            if COMPONENTS.get(next) != Some(&component) {
                return None;
            }
            next += 1;
        }
    }
    let (base, width) = of.filter(|_| next == count)?;
    Some(if width == count {
        base.clone()
    } else {
        Code::Member(Box::new(base.clone()), COMPONENTS[..count].concat().into(), width)
    })
}

/// Components of a vector that was put together from parts, or a part of a part.
fn part_of_vector(of: &Code, name: &str) -> Option<Code> {
    let index = |c: char| COMPONENTS.iter().position(|known| known.starts_with(c));
    match of {
        Code::BuiltIn(kind, parts) if matches!(&**kind, "vec2f" | "vec3f" | "vec4f") => {
            let width = usize::from(kind.as_bytes()[3] - b'0');
            let mut scalars: Vec<Code> = Vec::with_capacity(width);
            for part in parts {
                match part {
                    Code::Member(base, outer, of) if *of > 0 => {
                        scalars.extend(
                            outer
                                .chars()
                                .map(|c| Code::Member(base.clone(), c.to_string().into(), *of)),
                        );
                    }
                    part if is_scalar(part) || parts.len() == width => scalars.push(part.clone()),
                    _ => return None,
                }
            }
            if scalars.len() == 1 {
                scalars = vec![scalars[0].clone(); width];
            }
            if scalars.len() != width {
                return None;
            }
            let picked: Vec<Code> =
                name.chars().map(|c| scalars.get(index(c)?).cloned()).collect::<Option<_>>()?;
            if let [one] = picked.as_slice() {
                return Some(one.clone());
            }
            let kind = format!("vec{}f", picked.len());
            // Anything but another vector is longer than what it stands for.
            whole(&kind, &picked)
        }
        Code::Member(base, outer, width) if *width > 0 && outer.len() > 1 => {
            let picked: Option<String> =
                name.chars().map(|c| outer.chars().nth(index(c)?)).collect();
            Some(Code::Member(base.clone(), picked?.into(), *width))
        }
        _ => None,
    }
}

/// True for what is surely a number, not a vector.
fn is_scalar(code: &Code) -> bool {
    match code {
        Code::Text(text, _) => text.parse::<f64>().is_ok(),
        Code::Member(_, name, width) => *width > 0 && name.len() == 1,
        _ => false,
    }
}

/// Calls `tell` with every expression of some statements, and of those within.
pub(in crate::compile) fn each_code(lines: &[Line], tell: &mut dyn FnMut(&Code)) {
    for line in lines {
        match line {
            Line::Let(_, code) | Line::Return(code) | Line::Var(_, _, Some(code)) => {
                code.each(tell)
            }
            Line::Assign(place, code) => {
                place.each(tell);
                code.each(tell);
            }
            Line::If(condition, accept, reject) => {
                condition.each(tell);
                each_code(accept, tell);
                each_code(reject, tell);
            }
            Line::Loop(body, continuing, break_if) => {
                each_code(body, tell);
                each_code(continuing, tell);
                if let Some(code) = break_if {
                    code.each(tell);
                }
            }
            Line::Switch(selector, cases) => {
                selector.each(tell);
                cases.iter().for_each(|(_, body)| each_code(body, tell));
            }
            Line::Var(_, _, None) | Line::Break | Line::Continue | Line::Discard => {}
        }
    }
}

/// Removes variables that nothing reads.
pub(super) fn without_unread(mut lines: Vec<Line>) -> Vec<Line> {
    loop {
        let mut read = std::collections::HashSet::new();
        each_code(&lines, &mut |code| {
            if let Code::Local(index) = code {
                read.insert(*index);
            }
        });
        let before = count(&lines);
        lines = kept(lines, &read);
        if count(&lines) == before {
            return lines;
        }
    }
}

fn kept(lines: Vec<Line>, read: &std::collections::HashSet<usize>) -> Vec<Line> {
    let is_kept = |line: &Line| match line {
        Line::Let(index, _) | Line::Var(index, ..) => read.contains(index),
        _ => true,
    };
    let inside = |line: Line| match line {
        Line::If(condition, accept, reject) => {
            Line::If(condition, kept(accept, read), kept(reject, read))
        }
        Line::Loop(body, continuing, end) => {
            Line::Loop(kept(body, read), kept(continuing, read), end)
        }
        Line::Switch(selector, cases) => Line::Switch(
            selector,
            cases.into_iter().map(|(value, body)| (value, kept(body, read))).collect(),
        ),
        other => other,
    };
    lines.into_iter().filter(is_kept).map(inside).collect()
}

fn count(lines: &[Line]) -> usize {
    let inner = |line: &Line| match line {
        Line::If(_, accept, reject) => count(accept) + count(reject),
        Line::Loop(body, continuing, _) => count(body) + count(continuing),
        Line::Switch(_, cases) => cases.iter().map(|(_, body)| count(body)).sum(),
        _ => 0,
    };
    lines.len() + lines.iter().map(inner).sum::<usize>()
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

/// Writes a line, broken after commas and before operators where it is too long.
pub(in crate::compile) fn write_line(line: &str, indent: usize, out: &mut String) {
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
        let Some(at) = (1..=last).rev().find(|&at| is_break(at)).or(first) else {
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
