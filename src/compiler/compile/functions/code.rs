//! Statements and expressions of a function that is written anew.

use std::rc::Rc;

use super::print::level;

/// Function that a call names.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in crate::compile) enum Callee {
    /// Function as it stands in its file.
    Original(Rc<str>),
    /// Function that is written anew: an index into the functions that were made.
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

    /// Calls `tell` with this expression and all within.
    pub(in crate::compile) fn each(&self, tell: &mut dyn FnMut(&Self)) {
        tell(self);
        for part in self.parts() {
            part.each(tell);
        }
    }

    /// Length of its text, about as long as it will be.
    pub(in crate::compile) fn length(&self) -> usize {
        let mut length = 0;
        self.each(&mut |code| {
            length += match code {
                Self::Text(text, _) | Self::Argument(text, _) | Self::Constant(text) => text.len(),
                Self::Parameter(_) | Self::Local(_) => 8,
                Self::Member(_, name, _) => 1 + name.len(),
                Self::Index(..) => 2,
                Self::Unary(operator, _) => operator.len(),
                Self::Binary(operator, ..) => 2 + operator.len(),
                Self::BuiltIn(name, parts) | Self::Struct(name, parts) => {
                    name.len() + 2 * parts.len()
                }
                Self::Call(_, parts) => 16 + 2 * parts.len(),
            }
        });
        length
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

    /// The truth value that it is written as, if it is one.
    pub(super) fn truth(&self) -> Option<bool> {
        if let Self::Text(text, _) = self { text.parse().ok() } else { None }
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

    /// Number of times that a parameter is read.
    pub(in crate::compile) fn reads(&self, parameter: usize) -> usize {
        let mut count = 0;
        self.each(&mut |code| count += usize::from(*code == Self::Parameter(parameter)));
        count
    }

    /// The expression with arguments in place of parameters.
    #[must_use]
    pub(in crate::compile) fn with_arguments(&self, arguments: &[Self]) -> Self {
        self.replaced(&|code| match code {
            Self::Parameter(index) => arguments.get(*index).cloned(),
            _ => None,
        })
    }

    /// The expression with another in place of a variable.
    #[must_use]
    pub(super) fn with_local(&self, local: usize, value: &Self) -> Self {
        self.replaced(&|code| (*code == Self::Local(local)).then(|| value.clone()))
    }

    /// The expression with others in place of the leaves that `other` gives one for.
    fn replaced(&self, other: &dyn Fn(&Self) -> Option<Self>) -> Self {
        let one = |code: &Self| Box::new(code.replaced(other));
        let all = |codes: &[Self]| codes.iter().map(|code| code.replaced(other)).collect();
        match self {
            Self::Text(..)
            | Self::Argument(..)
            | Self::Parameter(_)
            | Self::Local(_)
            | Self::Constant(_) => return other(self).unwrap_or_else(|| self.clone()),
            Self::Member(of, name, width) => Self::Member(one(of), name.clone(), *width),
            Self::Index(of, index) => Self::Index(one(of), one(index)),
            Self::Unary(operator, of) => Self::Unary(operator, one(of)),
            Self::Binary(operator, a, b) => Self::Binary(operator, one(a), one(b)),
            Self::BuiltIn(name, parts) => Self::BuiltIn(name.clone(), all(parts)),
            Self::Struct(name, parts) => Self::Struct(name.clone(), all(parts)),
            Self::Call(callee, parts) => Self::Call(callee.clone(), all(parts)),
        }
        .simplified()
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
                    Self::Text(text, _) | Self::Argument(text, _) => {
                        let number = text.strip_prefix('-');
                        number.filter(|text| text.parse::<f64>().is_ok()).map(Self::number)
                    }
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
}

/// Names of a vector's components.
pub(super) const COMPONENTS: [&str; 4] = ["x", "y", "z", "w"];

/// Number of components of a vector of floats, by its type.
pub(super) fn width_of(kind: &str) -> Option<usize> {
    ["vec2f", "vec3f", "vec4f"].iter().position(|known| *known == kind).map(|index| index + 2)
}

/// The vector, or the first components of it, whose components a constructor lists in order.
pub(super) fn whole(name: &str, parts: &[Code]) -> Option<Code> {
    let count = width_of(name)?;
    // Of one vector, the constructor converts: its numbers may be of another kind.
    if parts.len() < 2 {
        return None;
    }
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
        Code::BuiltIn(kind, parts) => {
            let width = width_of(kind)?;
            // A conversion of a vector, as above.
            if parts.len() == 1 && !is_scalar(&parts[0]) {
                return None;
            }
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
pub(super) fn is_scalar(code: &Code) -> bool {
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
                code.each(tell);
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A part of a parameter that is a vector with so many components.
    fn part(parameter: usize, name: &str, width: usize) -> Code {
        Code::Member(Box::new(Code::Parameter(parameter)), name.into(), width)
    }

    fn vector(kind: &str, parts: &[Code]) -> Code {
        Code::BuiltIn(kind.into(), parts.to_vec())
    }

    #[test]
    fn a_vector_of_all_components_is_the_vector() {
        let each = ["x", "y", "z"].map(|name| part(0, name, 3));
        assert_eq!(vector("vec3f", &each).simplified(), Code::Parameter(0));
        let parts = [part(0, "xyz", 4), part(0, "w", 4)];
        assert_eq!(vector("vec4f", &parts).simplified(), Code::Parameter(0));
        let first = ["x", "y"].map(|name| part(0, name, 3));
        assert_eq!(vector("vec2f", &first).simplified(), part(0, "xy", 3));
    }

    #[test]
    fn a_vector_of_other_components_stays() {
        let swapped = vector("vec3f", &["x", "z", "y"].map(|name| part(0, name, 3)));
        assert_eq!(swapped.clone().simplified(), swapped);
        let mixed = vector("vec3f", &[part(0, "x", 3), part(1, "y", 3), part(0, "z", 3)]);
        assert_eq!(mixed.clone().simplified(), mixed);
        // Members of a struct, whatever their names.
        let members = vector("vec2f", &["x", "y"].map(|name| part(0, name, 0)));
        assert_eq!(members.clone().simplified(), members);
    }

    /// `vec2f(cell.xy)` of whole numbers is no part of the cell.
    #[test]
    fn a_conversion_stays() {
        let converted = vector("vec2f", &[part(0, "xy", 2)]);
        assert_eq!(converted.clone().simplified(), converted);
        let member = Code::Member(Box::new(converted), "x".into(), 2);
        assert_eq!(member.clone().simplified(), member);
    }

    #[test]
    fn a_part_of_what_was_put_together_is_the_part() {
        let opaque = || vector("vec4f", &[part(0, "xyz", 4), Code::number("1.0")]);
        let of = |vector: Code, name: &str, width| {
            Code::Member(Box::new(vector), name.into(), width).simplified()
        };
        assert_eq!(of(opaque(), "xyz", 4), part(0, "xyz", 4));
        assert_eq!(of(opaque(), "y", 4), part(0, "y", 4));
        assert_eq!(of(opaque(), "w", 4), Code::number("1.0"));
        assert_eq!(of(part(0, "zyx", 4), "x", 3), part(0, "z", 4));
    }

    #[test]
    fn a_negative_number_changes_the_sign_before_it() {
        let code = |operator, number| {
            Code::Binary(operator, Box::new(Code::Parameter(0)), Box::new(Code::number(number)))
        };
        assert_eq!(code("-", "-1.0").simplified(), code("+", "1.0"));
        assert_eq!(code("+", "-1.0").simplified(), code("-", "1.0"));
        assert_eq!(code("*", "-1.0").simplified(), code("*", "-1.0"));
    }
}
