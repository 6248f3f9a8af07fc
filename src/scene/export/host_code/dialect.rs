//! Programming languages of host code: how each writes values, operations and statements.

use std::collections::BTreeSet;

/// Language that host code is written in.
///
/// A float is 64 bits wide. Vectors and arrays are lists of the language, matrices lists of
/// columns, structs what the language has for them.
pub(super) trait Dialect {
    /// Words that the language has for itself, which no value can be called.
    fn keywords(&self) -> &'static [&'static str];

    /// A float. The text has to read as the same f64.
    fn float(&self, value: f64) -> Term;

    /// An integer of 32 bits.
    fn integer(&self, value: i64, kind: Kind) -> Term {
        let level = if value < 0 { Level::Unary } else { Level::Primary };
        Term::new(format!("{value}{}", self.integer_ending(kind)), level)
    }

    /// Letters after the digits of an integer of a kind.
    fn integer_ending(&self, _: Kind) -> &'static str {
        ""
    }

    /// A truth value.
    fn truth(&self, value: bool) -> Term;

    /// An operation on scalars; `kind` is that of the operands. Helpers that the text calls are
    /// told to `helpers`. `None` where the language cannot express the operation.
    fn scalar(
        &self,
        operation: &str,
        kind: Kind,
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term>;

    /// A vector of components, an array of elements or a matrix of columns.
    fn list(&self, items: &[Term], _: &ValueType) -> Term {
        let items: Vec<&str> = items.iter().map(|item| item.text.as_str()).collect();
        Term::primary(format!("[{}]", items.join(", ")))
    }

    /// A list of `count` times the same item.
    fn repeated(&self, item: &Term, count: usize) -> Term;

    /// A struct from its members in order.
    fn structure(&self, name: &str, members: &[(String, Term)]) -> Term;

    /// A member of a struct.
    fn member(&self, base: &Term, name: &str) -> Term {
        Term::primary(format!("{}.{name}", base.at(Level::Primary)))
    }

    /// An element of a list.
    fn element(&self, base: &Term, index: &Term) -> Term {
        Term::primary(format!("{}[{}]", base.at(Level::Primary), index.text))
    }

    /// An index computed at run time, as the language takes it for [`element`](Self::element).
    fn index(&self, index: &Term) -> Term {
        index.clone()
    }

    /// A component of a vector, by an index computed at run time.
    fn component(&self, base: &Term, index: &Term, _: &ValueType) -> Term {
        self.element(base, &self.index(index))
    }

    /// A part of a vector, a matrix or an array, by its index.
    fn part(&self, base: &Term, index: usize, _: &ValueType) -> Term {
        self.element(base, &Term::primary(index.to_string()))
    }

    /// A vector whose components are all the same; `None` for languages that list them.
    fn splat(&self, _value: &Term, _ty: &ValueType) -> Option<Term> {
        None
    }

    /// An operation on whole vectors and matrices, for languages that tell their types apart;
    /// `None` for languages that call [`each`](Self::each) and [`helper`](Self::helper).
    fn typed(
        &self,
        _operation: &str,
        _types: &[ValueType],
        _operands: &[Term],
        _helpers: &mut Helpers,
    ) -> Option<Term> {
        None
    }

    /// A choice between two composite values by one condition, for languages whose operator chooses
    /// between numbers alone; `types` and `operands` are condition, value where it holds, and other
    /// value.
    fn choice(&self, _: &[ValueType], _: &[Term], _: &mut Helpers) -> Option<Term> {
        None
    }

    /// True if a part can be taken of any value; false where the value needs a name first.
    fn takes_parts_of_results(&self) -> bool {
        true
    }

    /// Name of a thing as the language's people write it.
    fn styled(&self, name: &str, _of: NameOf) -> String {
        name.to_owned()
    }

    /// Declarations of the types of vectors and matrices that a text uses; empty for languages
    /// that have lists.
    fn types_of(&self, _text: &str) -> String {
        String::new()
    }

    /// A copy of a composite value that changes of the original do not reach.
    fn copy(&self, value: &Term, ty: &ValueType) -> Term;

    /// Source of a function that runs the scalar operation `body`, an expression of `x`, `y` and
    /// `z`, on each component of vectors.
    fn each(&self, name: &str, arity: usize, kinds: [Kind; 2], body: &str) -> String;

    /// All helper functions of the language.
    fn helpers(&self) -> &'static [HelperSource];

    /// Source of the helper function of this name, and the names of those that it calls.
    fn helper(&self, name: &str) -> Option<(&'static str, &'static [&'static str])> {
        let (_, source, calls) = self.helpers().iter().find(|(known, ..)| *known == name)?;
        Some((*source, *calls))
    }

    /// A type, for languages that write types.
    fn ty(&self, ty: &ValueType) -> String;

    /// The declaration of a value, or of a variable that is set again.
    fn declare(&self, name: &str, ty: &ValueType, value: &Term, is_variable: bool) -> String;

    /// The declaration of a variable that is filled part by part, where the language needs no value
    /// for it.
    fn declare_empty(&self, _name: &str, _ty: &ValueType) -> Option<String> {
        None
    }

    /// An assignment.
    fn assign(&self, place: &Term, value: &Term) -> String {
        format!("{} = {}{}", place.text, value.text, self.end())
    }

    /// End of a statement.
    fn end(&self) -> &'static str {
        ";"
    }

    /// The line that opens a block: `if`, `else`, `while` with a condition, or a function.
    fn open(&self, head: &Head<'_>) -> String;

    /// The line that closes a block; `None` for languages that indent.
    fn close(&self) -> Option<&'static str> {
        Some("}")
    }

    /// Spaces before the lines of a block.
    fn indent(&self) -> &'static str {
        "    "
    }

    /// The statement of an empty block, for languages that need one.
    fn nothing(&self) -> Option<&'static str> {
        None
    }

    /// Lines before and after the members of a struct's declaration; `None` for languages that need
    /// no declaration.
    fn around_members(&self, _name: &str) -> Option<(String, &'static str)> {
        None
    }

    /// The line of a member within a struct's declaration.
    fn declare_member(&self, member: &MemberSource) -> String {
        format!("{} {};", self.ty(&member.ty), member.name)
    }

    /// A struct's declaration; empty where the language needs none.
    fn declare_structure(&self, name: &str, doc: &[String], members: &[MemberSource]) -> String {
        let Some((opening, closing)) = self.around_members(name) else { return String::new() };
        let lines = |lines: Vec<String>, indent: &str| -> String {
            lines.iter().map(|line| format!("{indent}{line}\n")).collect()
        };
        let mut text = lines(self.doc(doc), "");
        text += &format!("{opening}\n");
        for member in members {
            text += &lines(self.doc(&member.doc), self.indent());
            text += &format!("{}{}\n", self.indent(), self.declare_member(member));
        }
        text + &format!("{closing}\n\n")
    }

    /// A constant of the module.
    fn constant(&self, name: &str, ty: &ValueType, value: &Term) -> String;

    /// Lines of a comment about what follows.
    fn doc(&self, lines: &[String]) -> Vec<String>;
}

/// Helper function: its name, its source, and the names of those that it calls.
pub(super) type HelperSource = (&'static str, &'static str, &'static [&'static str]);

/// Thing that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NameOf {
    Function,
    Structure,
    Constant,
    /// Member of a struct.
    Member,
    /// Parameter or local value.
    Value,
}

/// Head of a block.
pub(super) enum Head<'a> {
    /// Runs where the condition holds.
    If(&'a Term),
    /// Runs where no condition before held.
    Else,
    /// Runs where no condition before held and this one does.
    ElseIf(&'a Term),
    /// Runs again and again while the condition holds.
    While(&'a Term),
    /// Runs again and again until it is left.
    Forever,
    /// A function with its parameters.
    Function { name: &'a str, parameters: &'a [(String, ValueType)], result: &'a ValueType },
}

/// The head of a function: `start(a, b)`, with a line for each parameter where the line would be
/// longer than `width`.
pub(super) fn function_head(start: &str, parameters: &[String], width: usize) -> String {
    let short = format!("{start}({})", parameters.join(", "));
    if short.len() <= width {
        return short;
    }
    format!("{start}(\n    {})", parameters.join(",\n    "))
}

/// A member of a struct: name, type and comment.
pub(super) struct MemberSource {
    pub(super) name: String,
    pub(super) ty: ValueType,
    pub(super) doc: Vec<String>,
}

/// Kind of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// A float of 64 bits.
    Float,
    /// `i32`
    Signed,
    /// `u32`
    Unsigned,
    /// `bool`
    Bool,
}

/// Type of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum ValueType {
    /// A single number or truth value.
    Scalar(Kind),
    /// Two to four scalars.
    Vector(usize, Kind),
    /// Columns and rows of floats.
    Matrix(usize, usize),
    /// Elements of one type.
    Array(usize, Box<ValueType>),
    /// A struct by its name.
    Struct(String),
}

impl ValueType {
    /// True for types of more than one scalar.
    pub(super) fn is_composite(&self) -> bool {
        !matches!(self, Self::Scalar(_))
    }

    /// True for lists of scalars: vectors, and arrays of scalars.
    pub(super) fn is_flat(&self) -> bool {
        match self {
            Self::Vector(..) => true,
            Self::Array(_, element) => !element.is_composite(),
            _ => false,
        }
    }
}

/// Strength with which the parts of an expression hold together, the strongest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    /// A name, a number, a call.
    Primary,
    /// `-x`
    Unary,
    /// `x * y`
    Product,
    /// `x + y`
    Sum,
    /// Shifts and operations on bits, which languages order in their own ways.
    Bits,
    /// `x < y`
    Comparison,
    /// `x && y`
    And,
    /// `x || y`
    Or,
    /// A choice between two values.
    Choice,
}

/// Text of an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Term {
    pub(super) text: String,
    pub(super) level: Level,
}

impl Term {
    pub(super) fn new(text: impl Into<String>, level: Level) -> Self {
        Self { text: text.into(), level }
    }

    /// A float with all the digits that tell it apart, and the language's words for what is no
    /// number and for infinity.
    pub(super) fn float(value: f64, nan: &str, infinity: &str) -> Self {
        let text = match value {
            _ if value.is_nan() => return Self::primary(nan),
            _ if value.is_infinite() => infinity.to_owned(),
            _ => format!("{:?}", value.abs()),
        };
        if value.is_sign_negative() {
            Self::new(format!("-{text}"), Level::Unary)
        } else {
            Self::primary(text)
        }
    }

    pub(super) fn primary(text: impl Into<String>) -> Self {
        Self::new(text, Level::Primary)
    }

    /// The text as an operand where terms of that level and stronger ones need no brackets.
    pub(super) fn at(&self, level: Level) -> String {
        if self.level <= level { self.text.clone() } else { format!("({})", self.text) }
    }

    /// Two operands joined by an operator that groups from the left.
    pub(super) fn joined(left: &Self, operator: &str, right: &Self, level: Level) -> Self {
        // What stands at the right needs brackets at the same level; so do comparisons and bits at
        // either side, which languages group differently.
        let stronger = match level {
            Level::Product => Level::Unary,
            Level::Sum => Level::Product,
            Level::Bits => Level::Unary,
            Level::Comparison => Level::Sum,
            Level::And => Level::And,
            Level::Or => Level::Or,
            other => other,
        };
        let left_level = match level {
            Level::Product | Level::Sum | Level::And | Level::Or => level,
            _ => stronger,
        };
        // `a && b || c` reads better with brackets.
        let left_level = if level == Level::Or { Level::Comparison } else { left_level };
        let stronger = if level == Level::Or { Level::Comparison } else { stronger };
        let same = |term: &Self| level == Level::Or && term.level == Level::Or;
        let side = |term: &Self, at| if same(term) { term.text.clone() } else { term.at(at) };
        let text = format!("{} {operator} {}", side(left, left_level), side(right, stronger));
        Self::new(text, level)
    }

    /// A function called with operands.
    pub(super) fn call(function: &str, operands: &[Self]) -> Self {
        let operands: Vec<&str> = operands.iter().map(|term| term.text.as_str()).collect();
        Self::primary(format!("{function}({})", operands.join(", ")))
    }
}

/// Names of the helper functions that a text calls, and the sources of those made for it.
#[derive(Clone, Debug, Default)]
pub(super) struct Helpers {
    pub(super) called: BTreeSet<&'static str>,
    pub(super) made: std::collections::BTreeMap<String, String>,
}

impl Helpers {
    /// Notes that the text calls a helper.
    pub(super) fn call(&mut self, name: &'static str, operands: &[Term]) -> Term {
        self.called.insert(name);
        Term::call(name, operands)
    }

    /// Notes that the text calls the helper of a name; `None` where there is none of that name.
    pub(super) fn call_known(
        &mut self,
        known: &'static [HelperSource],
        name: &str,
        operands: &[Term],
    ) -> Option<Term> {
        let (name, ..) = known.iter().find(|(known, ..)| *known == name)?;
        Some(self.call(name, operands))
    }
}
