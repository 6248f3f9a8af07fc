//! Rust, of edition 2024, without dependencies.

use super::dialect::{
    Dialect, Head, HelperSource, Helpers, Kind, Level, MemberSource, Term, ValueType,
};

/// Rust: vectors, matrices and arrays are arrays, structs are structs; all are copied.
pub(super) struct Rust;

impl Dialect for Rust {
    fn keywords(&self) -> &'static [&'static str] {
        &[
            "Self", "abstract", "as", "async", "await", "become", "box", "break", "const",
            "continue", "crate", "do", "dyn", "else", "enum", "extern", "f64", "false", "final",
            "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move",
            "mut", "override", "priv", "pub", "ref", "return", "self", "static", "struct", "super",
            "trait", "true", "try", "type", "typeof", "union", "unsafe", "unsized", "use",
            "virtual", "where", "while", "yield",
        ]
    }

    fn float(&self, value: f64) -> Term {
        Term::float(value, "f64::NAN", "f64::INFINITY")
    }

    fn integer_ending(&self, kind: Kind) -> &'static str {
        if kind == Kind::Unsigned { "_u32" } else { "_i32" }
    }

    fn truth(&self, value: bool) -> Term {
        Term::primary(value.to_string())
    }

    fn scalar(
        &self,
        operation: &str,
        kind: Kind,
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term> {
        scalar(operation, kind, operands, helpers)
    }

    fn repeated(&self, item: &Term, count: usize) -> Term {
        Term::primary(format!("[{}; {count}]", item.text))
    }

    fn structure(&self, name: &str, members: &[(String, Term)]) -> Term {
        let member = |(name, term): &(String, Term)| {
            let name = member_name(name);
            if name == term.text { name } else { format!("{name}: {}", term.text) }
        };
        let members: Vec<String> = members.iter().map(member).collect();
        Term::primary(format!("{name} {{ {} }}", members.join(", ")))
    }

    fn member(&self, base: &Term, name: &str) -> Term {
        Term::primary(format!("{}.{}", base.at(Level::Primary), member_name(name)))
    }

    fn index(&self, index: &Term) -> Term {
        Term::primary(format!("{} as usize", index.at(Level::Primary)))
    }

    fn copy(&self, value: &Term, _: &ValueType) -> Term {
        value.clone()
    }

    fn each(&self, name: &str, arity: usize, [kind, result]: [Kind; 2], body: &str) -> String {
        let (from, to) = (word(kind), word(result));
        // The condition of a choice is a vector of truth values.
        let first = if name.starts_with("vector_select") { "bool" } else { from };
        // Shifts are by an unsigned number.
        let second = if name.starts_with("vector_shift") { "u32" } else { from };
        let parameters = match arity {
            1 => format!("a: [{first}; N]"),
            2 => format!("a: [{first}; N], b: [{second}; N]"),
            _ => format!("a: [{first}; N], b: [{from}; N], c: [{from}; N]"),
        };
        let operands = match arity {
            1 => "let x = a[i];",
            2 => "let (x, y) = (a[i], b[i]);",
            _ => "let (x, y, z) = (a[i], b[i], c[i]);",
        };
        format!(
            "fn {name}<const N: usize>({parameters}) -> [{to}; N] {{\n    \
             std::array::from_fn(|i| {{\n        {operands}\n        {body}\n    }})\n}}\n"
        )
    }

    fn helpers(&self) -> &'static [HelperSource] {
        HELPERS
    }

    fn ty(&self, ty: &ValueType) -> String {
        match ty {
            ValueType::Scalar(kind) => word(*kind).to_owned(),
            ValueType::Vector(count, kind) => format!("[{}; {count}]", word(*kind)),
            ValueType::Matrix(columns, rows) => format!("[[f64; {rows}]; {columns}]"),
            ValueType::Array(count, element) => format!("[{}; {count}]", self.ty(element)),
            ValueType::Struct(name) => name.clone(),
        }
    }

    fn declare(&self, name: &str, ty: &ValueType, value: &Term, is_variable: bool) -> String {
        let word = if is_variable { "let mut" } else { "let" };
        format!("{word} {name}: {} = {};", self.ty(ty), value.text)
    }

    fn open(&self, head: &Head<'_>) -> String {
        match head {
            Head::If(condition) => format!("if {} {{", condition.text),
            Head::Else => "} else {".to_owned(),
            Head::ElseIf(condition) => format!("}} else if {} {{", condition.text),
            Head::While(condition) => format!("while {} {{", condition.text),
            Head::Forever => "loop {".to_owned(),
            Head::Function { name, parameters, result } => {
                let parameters: Vec<String> = parameters
                    .iter()
                    .map(|(name, ty)| format!("{name}: {}", self.ty(ty)))
                    .collect();
                format!("pub fn {name}({}) -> {} {{", parameters.join(", "), self.ty(result))
            }
        }
    }

    fn around_members(&self, name: &str) -> Option<(String, &'static str)> {
        Some((format!("#[derive(Clone, Copy, Debug, PartialEq)]\npub struct {name} {{"), "}"))
    }

    fn declare_member(&self, member: &MemberSource) -> String {
        format!("pub {}: {},", member_name(&member.name), self.ty(&member.ty))
    }

    fn constant(&self, name: &str, ty: &ValueType, value: &Term) -> String {
        format!("const {name}: {} = {};", self.ty(ty), value.text)
    }

    fn doc(&self, lines: &[String]) -> Vec<String> {
        lines.iter().map(|line| format!("/// {line}").trim_end().to_owned()).collect()
    }
}

/// A member's name: words of Rust that WGSL takes as names are written raw.
fn member_name(name: &str) -> String {
    if matches!(name, "box" | "dyn" | "gen" | "in") { format!("r#{name}") } else { name.to_owned() }
}

/// Name of a scalar's type.
fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Float => "f64",
        Kind::Signed => "i32",
        Kind::Unsigned => "u32",
        Kind::Bool => "bool",
    }
}

/// An operation on scalars.
fn scalar(operation: &str, kind: Kind, operands: &[Term], helpers: &mut Helpers) -> Option<Term> {
    if let Some(term) = operator(operation, kind, operands) {
        return Some(term);
    }
    if let Some(term) = conversion(operation, kind, operands) {
        return Some(term);
    }
    let is_integer = matches!(kind, Kind::Signed | Kind::Unsigned);
    let call = |function: &str| Term::call(&format!("{}::{function}", word(kind)), operands);
    let known = MATH.iter().find(|(name, _)| *name == operation);
    if let Some((_, function)) = known.filter(|_| !is_integer) {
        return Some(call(function));
    }
    let [x, ..] = operands else { return None };
    Some(match (operation, kind) {
        ("min" | "max", _) => call(operation),
        ("abs", Kind::Signed) => call("wrapping_abs"),
        ("abs", Kind::Unsigned) => x.clone(),
        ("sign", Kind::Signed) => call("signum"),
        ("clamp", _) => {
            let [x, low, high] = operands else { return None };
            let ty = word(kind);
            Term::primary(format!("{ty}::min({ty}::max({}, {}), {})", x.text, low.text, high.text))
        }
        ("saturate", _) => Term::primary(format!("f64::min(f64::max({}, 0.0), 1.0)", x.text)),
        ("inversesqrt", _) => Term::new(format!("1.0 / f64::sqrt({})", x.text), Level::Product),
        ("countleadingzeros", _) => counted("leading_zeros", kind, x),
        ("counttrailingzeros", _) => counted("trailing_zeros", kind, x),
        ("countonebits", _) => counted("count_ones", kind, x),
        ("reversebits", _) => call("reverse_bits"),
        ("/", Kind::Signed) => helpers.call("divide_i32", operands),
        ("/", Kind::Unsigned) => helpers.call("divide_u32", operands),
        ("%", Kind::Signed) => helpers.call("remainder_i32", operands),
        ("%", Kind::Unsigned) => helpers.call("remainder_u32", operands),
        ("select", _) => {
            let [condition, yes, no] = operands else { return None };
            let text = format!("if {} {{ {} }} else {{ {} }}", condition.text, yes.text, no.text);
            Term::new(text, Level::Choice)
        }
        _ => helpers.call_known(HELPERS, operation, operands)?,
    })
}

/// A count of bits, of the type of what is counted.
fn counted(function: &str, kind: Kind, x: &Term) -> Term {
    let ty = word(kind);
    Term::new(format!("{ty}::{function}({}) as {ty}", x.text), Level::Unary)
}

fn operator(operation: &str, kind: Kind, operands: &[Term]) -> Option<Term> {
    let is_integer = matches!(kind, Kind::Signed | Kind::Unsigned);
    let call = |function: &str| Term::call(&format!("{}::{function}", word(kind)), operands);
    if let [x] = operands {
        return Some(match operation {
            "negate" if is_integer => call("wrapping_neg"),
            "negate" => Term::new(format!("-{}", x.at(Level::Primary)), Level::Unary),
            "!" | "~" => Term::new(format!("!{}", x.at(Level::Primary)), Level::Unary),
            _ => return None,
        });
    }
    let [x, y] = operands else { return None };
    Some(match (operation, kind) {
        ("+", _) if is_integer => call("wrapping_add"),
        ("-", _) if is_integer => call("wrapping_sub"),
        ("*", _) if is_integer => call("wrapping_mul"),
        ("/" | "%", _) if is_integer => return None,
        ("*" | "/" | "%", _) => Term::joined(x, operation, y, Level::Product),
        ("+" | "-", _) => Term::joined(x, operation, y, Level::Sum),
        ("==" | "!=" | "<" | "<=" | ">" | ">=", _) => {
            Term::joined(x, operation, y, Level::Comparison)
        }
        ("&" | "|" | "^", _) => Term::joined(x, operation, y, Level::Bits),
        ("<<", _) => shifted("wrapping_shl", kind, x, y),
        (">>", _) => shifted("wrapping_shr", kind, x, y),
        ("&&", _) => Term::joined(x, "&&", y, Level::And),
        ("||", _) => Term::joined(x, "||", y, Level::Or),
        _ => return None,
    })
}

/// A shift, by the amount modulo 32.
fn shifted(function: &str, kind: Kind, x: &Term, amount: &Term) -> Term {
    Term::primary(format!("{}::{function}({}, {})", word(kind), x.text, amount.text))
}

fn conversion(operation: &str, kind: Kind, operands: &[Term]) -> Option<Term> {
    let [x] = operands else { return None };
    let cast = |ty: &str| Term::new(format!("{} as {ty}", x.at(Level::Primary)), Level::Unary);
    Some(match (operation, kind) {
        ("to_float", Kind::Bool) => Term::call("f64::from", operands),
        ("to_float", Kind::Float) => x.clone(),
        ("to_float", _) => Term::call("f64::from", operands),
        // `as` truncates and saturates, and makes 0 of what is no number.
        ("to_signed", _) => cast("i32"),
        ("to_unsigned", _) => cast("u32"),
        ("to_bool", Kind::Bool) => x.clone(),
        ("to_bool", Kind::Float) => Term::joined(x, "!=", &Term::primary("0.0"), Level::Comparison),
        ("to_bool", _) => Term::joined(x, "!=", &Term::primary("0"), Level::Comparison),
        ("bits_to_float", Kind::Float) => x.clone(),
        ("bits_to_float", _) => {
            Term::primary(format!("f64::from(f32::from_bits({} as u32))", x.at(Level::Primary)))
        }
        ("bits_to_unsigned", Kind::Float) => {
            Term::primary(format!("({} as f32).to_bits()", x.at(Level::Primary)))
        }
        ("bits_to_signed", Kind::Float) => {
            Term::new(format!("({} as f32).to_bits() as i32", x.at(Level::Primary)), Level::Unary)
        }
        ("bits_to_unsigned", _) => cast("u32"),
        ("bits_to_signed", _) => cast("i32"),
        _ => return None,
    })
}

/// Functions of WGSL that `f64` has, by its own names.
const MATH: &[(&str, &str)] = &[
    ("abs", "abs"),
    ("cos", "cos"),
    ("cosh", "cosh"),
    ("sin", "sin"),
    ("sinh", "sinh"),
    ("tan", "tan"),
    ("tanh", "tanh"),
    ("acos", "acos"),
    ("asin", "asin"),
    ("atan", "atan"),
    ("atan2", "atan2"),
    ("asinh", "asinh"),
    ("acosh", "acosh"),
    ("atanh", "atanh"),
    ("radians", "to_radians"),
    ("degrees", "to_degrees"),
    ("ceil", "ceil"),
    ("floor", "floor"),
    ("round", "round_ties_even"),
    ("trunc", "trunc"),
    ("exp", "exp"),
    ("exp2", "exp2"),
    ("log", "ln"),
    ("log2", "log2"),
    ("sqrt", "sqrt"),
    ("fma", "mul_add"),
];

/// Helper functions: name, source, and the names of those that each calls.
const HELPERS: &[HelperSource] = &[
    ("fract", "fn fract(x: f64) -> f64 {\n    x - x.floor()\n}\n", &[]),
    (
        "sign",
        "fn sign(x: f64) -> f64 {\n    if x > 0.0 {\n        1.0\n    } else if x < 0.0 {\n        \
         -1.0\n    } else {\n        x\n    }\n}\n",
        &[],
    ),
    (
        "pow",
        "fn pow(x: f64, y: f64) -> f64 {\n    if x < 0.0 { f64::NAN } else { x.powf(y) }\n}\n",
        &[],
    ),
    ("mix", "fn mix(a: f64, b: f64, t: f64) -> f64 {\n    a * (1.0 - t) + b * t\n}\n", &[]),
    (
        "step",
        "fn step(edge: f64, x: f64) -> f64 {\n    if edge <= x { 1.0 } else { 0.0 }\n}\n",
        &[],
    ),
    (
        "smoothstep",
        "fn smoothstep(low: f64, high: f64, x: f64) -> f64 {\n    \
         let t = f64::min(f64::max((x - low) / (high - low), 0.0), 1.0);\n    \
         t * t * (3.0 - 2.0 * t)\n}\n",
        &[],
    ),
    (
        "divide_i32",
        "fn divide_i32(a: i32, b: i32) -> i32 {\n    \
         if b == 0 { a } else { a.wrapping_div(b) }\n}\n",
        &[],
    ),
    (
        "divide_u32",
        "fn divide_u32(a: u32, b: u32) -> u32 {\n    a.checked_div(b).unwrap_or(a)\n}\n",
        &[],
    ),
    (
        "remainder_i32",
        "fn remainder_i32(a: i32, b: i32) -> i32 {\n    \
         if b == 0 { 0 } else { a.wrapping_rem(b) }\n}\n",
        &[],
    ),
    (
        "remainder_u32",
        "fn remainder_u32(a: u32, b: u32) -> u32 {\n    a.checked_rem(b).unwrap_or(0)\n}\n",
        &[],
    ),
    (
        "dot",
        "fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {\n    \
         a.iter().zip(&b).map(|(x, y)| x * y).sum()\n}\n",
        &[],
    ),
    (
        "cross",
        "fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {\n    [\n        \
         a[1] * b[2] - a[2] * b[1],\n        a[2] * b[0] - a[0] * b[2],\n        \
         a[0] * b[1] - a[1] * b[0],\n    ]\n}\n",
        &[],
    ),
    (
        "length",
        "fn length<const N: usize>(a: [f64; N]) -> f64 {\n    dot(a, a).sqrt()\n}\n",
        &["dot"],
    ),
    (
        "distance",
        "fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {\n    \
         length(std::array::from_fn::<f64, N, _>(|i| a[i] - b[i]))\n}\n",
        &["length"],
    ),
    (
        "normalize",
        "fn normalize<const N: usize>(a: [f64; N]) -> [f64; N] {\n    \
         let all = length(a);\n    a.map(|x| x / all)\n}\n",
        &["length"],
    ),
    (
        "reflect",
        "fn reflect<const N: usize>(a: [f64; N], n: [f64; N]) -> [f64; N] {\n    \
         let along = 2.0 * dot(n, a);\n    std::array::from_fn(|i| a[i] - along * n[i])\n}\n",
        &["dot"],
    ),
    ("all", "fn all<const N: usize>(a: [bool; N]) -> bool {\n    a.iter().all(|x| *x)\n}\n", &[]),
    ("any", "fn any<const N: usize>(a: [bool; N]) -> bool {\n    a.iter().any(|x| *x)\n}\n", &[]),
    (
        "transpose",
        "fn transpose<const C: usize, const R: usize>(m: [[f64; R]; C]) -> [[f64; C]; R] {\n    \
         std::array::from_fn(|row| std::array::from_fn(|column| m[column][row]))\n}\n",
        &[],
    ),
    (
        "matrix_times_vector",
        "fn matrix_times_vector<const C: usize, const R: usize>(\n    m: [[f64; R]; C],\n    \
         v: [f64; C],\n) -> [f64; R] {\n    \
         std::array::from_fn(|row| (0..C).map(|i| m[i][row] * v[i]).sum())\n}\n",
        &[],
    ),
    (
        "vector_times_matrix",
        "fn vector_times_matrix<const C: usize, const R: usize>(\n    v: [f64; R],\n    \
         m: [[f64; R]; C],\n) -> [f64; C] {\n    m.map(|column| dot(v, column))\n}\n",
        &["dot"],
    ),
    (
        "matrix_times_matrix",
        "fn matrix_times_matrix<const C: usize, const K: usize, const R: usize>(\n    \
         a: [[f64; R]; K],\n    b: [[f64; K]; C],\n) -> [[f64; R]; C] {\n    \
         b.map(|column| matrix_times_vector(a, column))\n}\n",
        &["matrix_times_vector"],
    ),
    (
        "matrix_times_scalar",
        "fn matrix_times_scalar<const C: usize, const R: usize>(\n    m: [[f64; R]; C],\n    \
         x: f64,\n) -> [[f64; R]; C] {\n    \
         m.map(|column| column.map(|y| y * x))\n}\n",
        &[],
    ),
    (
        "matrix_plus_matrix",
        "fn matrix_plus_matrix<const C: usize, const R: usize>(\n    a: [[f64; R]; C],\n    \
         b: [[f64; R]; C],\n) -> [[f64; R]; C] {\n    \
         std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] + b[i][j]))\n}\n",
        &[],
    ),
    (
        "matrix_minus_matrix",
        "fn matrix_minus_matrix<const C: usize, const R: usize>(\n    a: [[f64; R]; C],\n    \
         b: [[f64; R]; C],\n) -> [[f64; R]; C] {\n    \
         std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] - b[i][j]))\n}\n",
        &[],
    ),
];
