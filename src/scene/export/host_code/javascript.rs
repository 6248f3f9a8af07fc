//! JavaScript, as ES2022 has it.

use super::dialect::{Dialect, Head, HelperSource, Helpers, Kind, Level, Term, ValueType};

/// JavaScript: vectors, matrices and arrays are arrays, structs are objects.
pub(super) struct JavaScript;

impl Dialect for JavaScript {
    fn keywords(&self) -> &'static [&'static str] {
        &[
            "arguments",
            "async",
            "await",
            "break",
            "case",
            "catch",
            "class",
            "const",
            "continue",
            "debugger",
            "default",
            "delete",
            "do",
            "else",
            "enum",
            "eval",
            "export",
            "extends",
            "false",
            "finally",
            "for",
            "function",
            "if",
            "implements",
            "import",
            "in",
            "instanceof",
            "interface",
            "let",
            "look",
            "new",
            "null",
            "of",
            "package",
            "private",
            "protected",
            "public",
            "return",
            "static",
            "super",
            "switch",
            "this",
            "throw",
            "true",
            "try",
            "typeof",
            "undefined",
            "var",
            "void",
            "while",
            "with",
            "yield",
            "Math",
            "Array",
            "Infinity",
            "NaN",
        ]
    }

    fn float(&self, value: f64) -> Term {
        let Term { text, level } = Term::float(value, "NaN", "Infinity");
        Term::new(text.strip_suffix(".0").unwrap_or(&text), level)
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
        Term::primary(format!("Array({count}).fill({})", item.text))
    }

    fn structure(&self, _: &str, members: &[(String, Term)]) -> Term {
        let member = |(name, term): &(String, Term)| {
            if *name == term.text { name.clone() } else { format!("{name}: {}", term.text) }
        };
        let members: Vec<String> = members.iter().map(member).collect();
        Term::primary(format!("{{ {} }}", members.join(", ")))
    }

    fn copy(&self, value: &Term, ty: &ValueType) -> Term {
        if !ty.is_composite() {
            return value.clone();
        }
        let is_flat = ty.is_flat();
        Term::primary(match is_flat {
            true => format!("[...{}]", value.at(Level::Primary)),
            false => format!("structuredClone({})", value.text),
        })
    }

    fn each(&self, name: &str, arity: usize, _: [Kind; 2], body: &str) -> String {
        let body = if body.starts_with('{') { format!("({body})") } else { body.to_owned() };
        match arity {
            1 => format!("const {name} = (a) => a.map((x) => {body});\n"),
            2 => format!(
                "const {name} = (a, b) => a.map((x, i) => {});\n",
                with_operands(&body, &[("y", "b[i]")])
            ),
            _ => format!(
                "const {name} = (a, b, c) => a.map((x, i) => {});\n",
                with_operands(&body, &[("y", "b[i]"), ("z", "c[i]")])
            ),
        }
    }

    fn helpers(&self) -> &'static [HelperSource] {
        HELPERS
    }

    fn ty(&self, _: &ValueType) -> String {
        String::new()
    }

    fn declare(&self, name: &str, _: &ValueType, value: &Term, is_variable: bool) -> String {
        format!("{} {name} = {};", if is_variable { "let" } else { "const" }, value.text)
    }

    fn open(&self, head: &Head<'_>) -> String {
        match head {
            Head::If(condition) => format!("if ({}) {{", condition.text),
            Head::Else => "} else {".to_owned(),
            Head::ElseIf(condition) => format!("}} else if ({}) {{", condition.text),
            Head::While(condition) => format!("while ({}) {{", condition.text),
            Head::Forever => "for (;;) {".to_owned(),
            Head::Function { name, parameters, .. } => {
                let names: Vec<&str> = parameters.iter().map(|(name, _)| name.as_str()).collect();
                format!("function {name}({}) {{", names.join(", "))
            }
        }
    }

    fn indent(&self) -> &'static str {
        "  "
    }

    fn constant(&self, name: &str, _: &ValueType, value: &Term) -> String {
        format!("const {name} = {};", value.text)
    }

    fn doc(&self, lines: &[String]) -> Vec<String> {
        lines.iter().map(|line| format!("// {line}").trim_end().to_owned()).collect()
    }
}

/// A body with operands in the place of names.
fn with_operands(body: &str, operands: &[(&str, &str)]) -> String {
    crate::wgsl::rename_identifiers(body, |name| {
        operands.iter().find(|(known, _)| *known == name).map(|(_, operand)| (*operand).to_owned())
    })
}

/// An operation on scalars.
fn scalar(operation: &str, kind: Kind, operands: &[Term], helpers: &mut Helpers) -> Option<Term> {
    if let Some(term) = operator(operation, kind, operands) {
        return Some(term);
    }
    if let Some(term) = conversion(operation, kind, operands, helpers) {
        return Some(term);
    }
    let known = MATH.iter().find(|(name, _)| *name == operation);
    if let Some((_, function)) = known {
        return Some(Term::call(function, operands));
    }
    let [x, ..] = operands else { return None };
    Some(match (operation, kind) {
        ("abs", _) => Term::call("Math.abs", operands),
        ("inversesqrt", _) => Term::new(format!("1 / Math.sqrt({})", x.text), Level::Product),
        ("exp2", _) => Term::primary(format!("Math.pow(2, {})", x.text)),
        ("select", _) => {
            let [condition, yes, no] = operands else { return None };
            let (condition, yes, no) =
                (condition.at(Level::Or), yes.at(Level::Or), no.at(Level::Choice));
            Term::new(format!("{condition} ? {yes} : {no}"), Level::Choice)
        }
        ("/", Kind::Signed) => helpers.call("divide_i32", operands),
        ("/", Kind::Unsigned) => helpers.call("divide_u32", operands),
        ("%", Kind::Signed | Kind::Unsigned) => helpers.call("remainder_of", operands),
        _ => helpers.call_known(HELPERS, operation, operands)?,
    })
}

fn operator(operation: &str, kind: Kind, operands: &[Term]) -> Option<Term> {
    let whole = |term: Term| match kind {
        Kind::Signed => Term::new(format!("{} | 0", term.at(Level::Sum)), Level::Bits),
        Kind::Unsigned => Term::new(format!("{} >>> 0", term.at(Level::Sum)), Level::Bits),
        Kind::Float | Kind::Bool => term,
    };
    let bits = |term: Term| match kind {
        Kind::Unsigned => Term::new(format!("({}) >>> 0", term.text), Level::Bits),
        _ => term,
    };
    if let [x] = operands {
        return Some(match operation {
            "negate" => whole(Term::new(format!("-{}", x.at(Level::Primary)), Level::Unary)),
            "!" => Term::new(format!("!{}", x.at(Level::Primary)), Level::Unary),
            "~" => bits(Term::new(format!("~{}", x.at(Level::Primary)), Level::Unary)),
            _ => return None,
        });
    }
    let [x, y] = operands else { return None };
    Some(match (operation, kind) {
        ("*", Kind::Signed) => Term::call("Math.imul", operands),
        ("*", Kind::Unsigned) => whole(Term::call("Math.imul", operands)),
        ("/" | "%", Kind::Signed | Kind::Unsigned) => return None,
        ("*" | "/" | "%", _) => Term::joined(x, operation, y, Level::Product),
        ("+" | "-", _) => whole(Term::joined(x, operation, y, Level::Sum)),
        ("==" | "!=", _) => Term::joined(x, &format!("{operation}="), y, Level::Comparison),
        ("<" | "<=" | ">" | ">=", _) => Term::joined(x, operation, y, Level::Comparison),
        ("&", Kind::Bool) => Term::joined(x, "&&", y, Level::And),
        ("|", Kind::Bool) => Term::joined(x, "||", y, Level::Or),
        ("^", Kind::Bool) => Term::joined(x, "!==", y, Level::Comparison),
        ("&" | "|" | "^" | "<<", _) => bits(Term::joined(x, operation, y, Level::Bits)),
        (">>", Kind::Unsigned) => Term::joined(x, ">>>", y, Level::Bits),
        (">>", _) => Term::joined(x, ">>", y, Level::Bits),
        ("&&", _) => Term::joined(x, "&&", y, Level::And),
        ("||", _) => Term::joined(x, "||", y, Level::Or),
        _ => return None,
    })
}

fn conversion(
    operation: &str,
    kind: Kind,
    operands: &[Term],
    helpers: &mut Helpers,
) -> Option<Term> {
    let [x] = operands else { return None };
    Some(match (operation, kind) {
        ("to_float", Kind::Bool) => Term::primary(format!("Number({})", x.text)),
        ("to_float", _) => x.clone(),
        ("to_signed", Kind::Float) => helpers.call("to_i32", operands),
        ("to_unsigned", Kind::Float) => helpers.call("to_u32", operands),
        ("to_signed" | "to_unsigned", Kind::Bool) => Term::primary(format!("Number({})", x.text)),
        ("to_signed", _) => Term::new(format!("{} | 0", x.at(Level::Sum)), Level::Bits),
        ("to_unsigned", _) => Term::new(format!("{} >>> 0", x.at(Level::Sum)), Level::Bits),
        ("to_bool", Kind::Bool) => x.clone(),
        ("to_bool", _) => Term::joined(x, "!==", &Term::primary("0"), Level::Comparison),
        ("bits_to_float", _) => helpers.call("float_of_bits", operands),
        ("bits_to_unsigned", Kind::Float) => helpers.call("bits_of_float", operands),
        ("bits_to_signed", Kind::Float) => {
            let bits = helpers.call("bits_of_float", operands);
            Term::new(format!("{} | 0", bits.text), Level::Bits)
        }
        ("bits_to_unsigned", _) => Term::new(format!("{} >>> 0", x.at(Level::Sum)), Level::Bits),
        ("bits_to_signed", _) => Term::new(format!("{} | 0", x.at(Level::Sum)), Level::Bits),
        _ => return None,
    })
}

/// Functions of WGSL that JavaScript has, by its own names.
const MATH: &[(&str, &str)] = &[
    ("cos", "Math.cos"),
    ("cosh", "Math.cosh"),
    ("sin", "Math.sin"),
    ("sinh", "Math.sinh"),
    ("tan", "Math.tan"),
    ("tanh", "Math.tanh"),
    ("acos", "Math.acos"),
    ("asin", "Math.asin"),
    ("atan", "Math.atan"),
    ("atan2", "Math.atan2"),
    ("asinh", "Math.asinh"),
    ("acosh", "Math.acosh"),
    ("atanh", "Math.atanh"),
    ("ceil", "Math.ceil"),
    ("floor", "Math.floor"),
    ("trunc", "Math.trunc"),
    ("exp", "Math.exp"),
    ("log", "Math.log"),
    ("log2", "Math.log2"),
    ("sqrt", "Math.sqrt"),
    ("sign", "Math.sign"),
    ("countleadingzeros", "Math.clz32"),
];

/// Helper functions: name, source, and the names of those that each calls.
const HELPERS: &[HelperSource] = &[
    ("min", "const min = (a, b) => (b < a || a !== a ? b : a);\n", &[]),
    ("max", "const max = (a, b) => (a < b || a !== a ? b : a);\n", &[]),
    ("clamp", "const clamp = (x, low, high) => min(max(x, low), high);\n", &["max", "min"]),
    ("saturate", "const saturate = (x) => min(max(x, 0), 1);\n", &["max", "min"]),
    ("fract", "const fract = (x) => x - Math.floor(x);\n", &[]),
    ("radians", "const radians = (x) => (x * Math.PI) / 180;\n", &[]),
    ("degrees", "const degrees = (x) => (x * 180) / Math.PI;\n", &[]),
    (
        "round",
        "// The nearest whole number, of two the even one.\n\
         const round = (x) => {\n  \
           const down = Math.floor(x);\n  \
           const rest = x - down;\n  \
           return rest < 0.5 || (rest === 0.5 && down % 2 === 0) ? down : down + 1;\n\
         };\n",
        &[],
    ),
    ("pow", "const pow = (x, y) => (x < 0 ? NaN : Math.pow(x, y));\n", &[]),
    ("mix", "const mix = (a, b, t) => a * (1 - t) + b * t;\n", &[]),
    ("step", "const step = (edge, x) => (edge <= x ? 1 : 0);\n", &[]),
    ("fma", "const fma = (a, b, c) => a * b + c;\n", &[]),
    (
        "smoothstep",
        "const smoothstep = (low, high, x) => {\n  \
           const t = clamp((x - low) / (high - low), 0, 1);\n  \
           return t * t * (3 - 2 * t);\n\
         };\n",
        &["clamp"],
    ),
    (
        "to_i32",
        "const to_i32 = (x) => Math.trunc(Math.min(Math.max(x || 0, -2147483648), 2147483647));\n",
        &[],
    ),
    (
        "to_u32",
        "const to_u32 = (x) => Math.trunc(Math.min(Math.max(x || 0, 0), 4294967295));\n",
        &[],
    ),
    (
        "countonebits",
        "const countonebits = (x) => {\n  \
           let count = 0;\n  \
           for (let rest = x >>> 0; rest !== 0; rest >>>= 1) count += rest & 1;\n  \
           return count;\n\
         };\n",
        &[],
    ),
    ("divide_i32", "const divide_i32 = (a, b) => (b === 0 ? a : (a / b) | 0);\n", &[]),
    ("divide_u32", "const divide_u32 = (a, b) => (b === 0 ? a : Math.trunc(a / b));\n", &[]),
    ("remainder_of", "const remainder_of = (a, b) => (b === 0 ? 0 : (a % b) + 0);\n", &[]),
    (
        "words",
        "// A 32-bit float and its bits, in one place.\n\
         const float_word = new Float32Array(1);\n\
         const bits_word = new Uint32Array(float_word.buffer);\n",
        &[],
    ),
    (
        "bits_of_float",
        "const bits_of_float = (x) => ((float_word[0] = x), bits_word[0]);\n",
        &["words"],
    ),
    (
        "float_of_bits",
        "const float_of_bits = (bits) => ((bits_word[0] = bits), float_word[0]);\n",
        &["words"],
    ),
    ("dot", "const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);\n", &[]),
    (
        "cross",
        "const cross = (a, b) => [\n  \
           a[1] * b[2] - a[2] * b[1],\n  \
           a[2] * b[0] - a[0] * b[2],\n  \
           a[0] * b[1] - a[1] * b[0],\n\
         ];\n",
        &[],
    ),
    ("length", "const length = (a) => Math.sqrt(dot(a, a));\n", &["dot"]),
    ("distance", "const distance = (a, b) => length(a.map((x, i) => x - b[i]));\n", &["length"]),
    (
        "normalize",
        "const normalize = (a) => {\n  \
           const all = length(a);\n  \
           return a.map((x) => x / all);\n\
         };\n",
        &["length"],
    ),
    ("reflect", "const reflect = (a, n) => a.map((x, i) => x - 2 * dot(n, a) * n[i]);\n", &["dot"]),
    ("all", "const all = (a) => a.every((x) => x);\n", &[]),
    ("any", "const any = (a) => a.some((x) => x);\n", &[]),
    (
        "transpose",
        "const transpose = (m) => m[0].map((_, row) => m.map((column) => column[row]));\n",
        &[],
    ),
    (
        "matrix_times_vector",
        "const matrix_times_vector = (m, v) =>\n  \
           m[0].map((_, row) => m.reduce((sum, column, i) => sum + column[row] * v[i], 0));\n",
        &[],
    ),
    (
        "vector_times_matrix",
        "const vector_times_matrix = (v, m) => m.map((column) => dot(v, column));\n",
        &["dot"],
    ),
    (
        "matrix_times_matrix",
        "const matrix_times_matrix = (a, b) =>\n  \
           b.map((column) => matrix_times_vector(a, column));\n",
        &["matrix_times_vector"],
    ),
    (
        "matrix_times_scalar",
        "const matrix_times_scalar = (m, x) => m.map((column) => column.map((y) => y * x));\n",
        &[],
    ),
    (
        "matrix_plus_matrix",
        "const matrix_plus_matrix = (a, b) =>\n  \
           a.map((column, i) => column.map((x, j) => x + b[i][j]));\n",
        &[],
    ),
    (
        "matrix_minus_matrix",
        "const matrix_minus_matrix = (a, b) =>\n  \
           a.map((column, i) => column.map((x, j) => x - b[i][j]));\n",
        &[],
    ),
];
