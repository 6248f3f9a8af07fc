//! Python 3, with its modules `math` and `struct`.
//!
//! Python raises errors where WGSL goes on with infinities and with what is no number, so divisions
//! and most functions of `math` are called by helpers that do not. Its integers have no ends: sums
//! and products are brought back to 32 bits.

use super::dialect::{Dialect, Head, HelperSource, Helpers, Kind, Level, Term, ValueType};
use super::pythonic;

/// Python: vectors, matrices and arrays are lists, structs are dicts.
pub(super) struct Python;

impl Dialect for Python {
    fn keywords(&self) -> &'static [&'static str] {
        &[
            "False",
            "None",
            "True",
            "and",
            "as",
            "assert",
            "async",
            "await",
            "break",
            "class",
            "continue",
            "def",
            "del",
            "elif",
            "else",
            "except",
            "finally",
            "for",
            "from",
            "global",
            "if",
            "import",
            "in",
            "is",
            "lambda",
            "nonlocal",
            "not",
            "or",
            "pass",
            "raise",
            "return",
            "try",
            "while",
            "with",
            "yield",
            "abs",
            "bool",
            "copy",
            "float",
            "int",
            "len",
            "list",
            "math",
            "range",
            "struct",
            "sum",
            "zip",
            "LOOK",
            // Helpers whose names are Python's own, or none of WGSL's.
            "bits_of_float",
            "ceil",
            "cos",
            "quotient",
            "divide_whole",
            "exp",
            "float_of_bits",
            "floor",
            "greater",
            "inverse_sqrt",
            "known",
            "lesser",
            "log",
            "log2",
            "nearest",
            "power_of",
            "remainder",
            "remainder_whole",
            "sign",
            "sin",
            "sqrt",
            "tan",
            "to_i32",
            "to_u32",
            "trunc",
            "wrap_i32",
        ]
    }

    fn float(&self, value: f64) -> Term {
        Term::float(value, "math.nan", "math.inf")
    }

    fn truth(&self, value: bool) -> Term {
        Term::primary(if value { "True" } else { "False" })
    }

    fn scalar(
        &self,
        operation: &str,
        kind: Kind,
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term> {
        operator(operation, kind, operands, helpers)
            .or_else(|| pythonic::conversion(operation, kind, operands, "0", helpers))
            .or_else(|| function(operation, kind, operands, helpers))
    }

    fn repeated(&self, item: &Term, count: usize) -> Term {
        Term::new(format!("[{}] * {count}", item.text), Level::Product)
    }

    fn structure(&self, _: &str, members: &[(String, Term)]) -> Term {
        let member = |(name, term): &(String, Term)| format!("\"{name}\": {}", term.text);
        let members: Vec<String> = members.iter().map(member).collect();
        Term::primary(format!("{{{}}}", members.join(", ")))
    }

    fn member(&self, base: &Term, name: &str) -> Term {
        Term::primary(format!("{}[\"{name}\"]", base.at(Level::Primary)))
    }

    fn copy(&self, value: &Term, ty: &ValueType) -> Term {
        if !ty.is_composite() {
            return value.clone();
        }
        let is_flat = ty.is_flat();
        Term::call(if is_flat { "list" } else { "copy.deepcopy" }, std::slice::from_ref(value))
    }

    fn each(&self, name: &str, arity: usize, _: [Kind; 2], body: &str) -> String {
        let (parameters, names) = match arity {
            1 => ("a", "x in a"),
            2 => ("a, b", "x, y in zip(a, b)"),
            _ => ("a, b, c", "x, y, z in zip(a, b, c)"),
        };
        format!("def {name}({parameters}):\n    return [{body} for {names}]\n\n")
    }

    fn helpers(&self) -> &'static [HelperSource] {
        HELPERS
    }

    fn ty(&self, _: &ValueType) -> String {
        String::new()
    }

    fn declare(&self, name: &str, _: &ValueType, value: &Term, _: bool) -> String {
        format!("{name} = {}", value.text)
    }

    fn end(&self) -> &'static str {
        ""
    }

    fn open(&self, head: &Head<'_>) -> String {
        match head {
            Head::If(condition) => format!("if {}:", condition.text),
            Head::Else => "else:".to_owned(),
            Head::ElseIf(condition) => format!("elif {}:", condition.text),
            Head::While(condition) => format!("while {}:", condition.text),
            Head::Forever => "while True:".to_owned(),
            Head::Function { name, parameters, .. } => {
                let names: Vec<&str> = parameters.iter().map(|(name, _)| name.as_str()).collect();
                format!("def {name}({}):", names.join(", "))
            }
        }
    }

    fn close(&self) -> Option<&'static str> {
        None
    }

    fn nothing(&self) -> Option<&'static str> {
        Some("pass")
    }

    fn constant(&self, name: &str, _: &ValueType, value: &Term) -> String {
        format!("{name} = {}", value.text)
    }

    fn doc(&self, lines: &[String]) -> Vec<String> {
        lines.iter().map(|line| format!("# {line}").trim_end().to_owned()).collect()
    }
}

/// True for the text of a number that is not 0.
fn is_written_out(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_digit())
        && text.parse().is_ok_and(|number: f64| number != 0.0)
}

fn operator(operation: &str, kind: Kind, operands: &[Term], helpers: &mut Helpers) -> Option<Term> {
    let [x, y] = operands else { return pythonic::operator(operation, kind, operands, helpers) };
    Some(match (operation, kind) {
        // A number that is written out is seen not to be 0.
        ("/", Kind::Float) if is_written_out(&y.text) => Term::joined(x, "/", y, Level::Product),
        ("/", Kind::Float) => helpers.call("quotient", operands),
        ("%", Kind::Float) => helpers.call("remainder", operands),
        ("<<", _) => pythonic::within(Term::joined(x, "<<", y, Level::Bits), kind, helpers),
        (">>", _) => Term::joined(x, ">>", y, Level::Bits),
        _ => return pythonic::operator(operation, kind, operands, helpers),
    })
}

fn function(operation: &str, kind: Kind, operands: &[Term], helpers: &mut Helpers) -> Option<Term> {
    if let Some((_, function)) = MATH.iter().find(|(name, _)| *name == operation) {
        return Some(Term::call(function, operands));
    }
    if let Some((_, helper)) = RENAMED.iter().find(|(name, _)| *name == operation) {
        return Some(helpers.call(helper, operands));
    }
    let [x, ..] = operands else { return None };
    Some(match operation {
        "exp2" => helpers.call("power_of", &[Term::primary("2.0"), x.clone()]),
        "select" => pythonic::select(operands)?,
        "sign" if kind != Kind::Float => return None,
        _ => helpers.call_known(HELPERS, operation, operands)?,
    })
}

/// Functions of WGSL that Python has, for all numbers, by its own names.
const MATH: &[(&str, &str)] = &[
    ("abs", "abs"),
    ("asinh", "math.asinh"),
    ("atan", "math.atan"),
    ("atan2", "math.atan2"),
    ("tanh", "math.tanh"),
    ("radians", "math.radians"),
    ("degrees", "math.degrees"),
];

/// Functions of WGSL whose names Python has for others, by the names of their helpers.
const RENAMED: &[(&str, &str)] = &[
    ("min", "lesser"),
    ("max", "greater"),
    ("round", "nearest"),
    ("pow", "power_of"),
    ("inversesqrt", "inverse_sqrt"),
];

/// Helper functions: name, source, and the names of those that each calls.
const HELPERS: &[HelperSource] = &[
    (
        "known",
        "# What a function of math gives; no number where it knows none.\n\
         def known(function, *numbers):\n    \
             try:\n        \
                 return function(*numbers)\n    \
             except ValueError:\n        \
                 return math.nan\n    \
             except OverflowError:\n        \
                 return math.inf\n\n",
        &[],
    ),
    ("sin", "def sin(x):\n    return known(math.sin, x)\n\n", &["known"]),
    ("cos", "def cos(x):\n    return known(math.cos, x)\n\n", &["known"]),
    ("tan", "def tan(x):\n    return known(math.tan, x)\n\n", &["known"]),
    ("asin", "def asin(x):\n    return known(math.asin, x)\n\n", &["known"]),
    ("acos", "def acos(x):\n    return known(math.acos, x)\n\n", &["known"]),
    ("sinh", "def sinh(x):\n    return math.copysign(known(math.sinh, abs(x)), x)\n\n", &["known"]),
    ("cosh", "def cosh(x):\n    return known(math.cosh, x)\n\n", &["known"]),
    ("acosh", "def acosh(x):\n    return known(math.acosh, x)\n\n", &["known"]),
    (
        "atanh",
        "def atanh(x):\n    \
             return known(math.atanh, x) if abs(x) != 1.0 else math.copysign(math.inf, x)\n\n",
        &["known"],
    ),
    ("exp", "def exp(x):\n    return known(math.exp, x)\n\n", &["known"]),
    ("sqrt", "def sqrt(x):\n    return known(math.sqrt, x)\n\n", &["known"]),
    (
        "log",
        "def log(x):\n    return known(math.log, x) if x != 0.0 else -math.inf\n\n",
        &["known"],
    ),
    (
        "log2",
        "def log2(x):\n    return known(math.log2, x) if x != 0.0 else -math.inf\n\n",
        &["known"],
    ),
    (
        "power_of",
        "def power_of(x, y):\n    \
             if x < 0.0:\n        \
                 return math.nan\n    \
             return math.inf if x == 0.0 and y < 0.0 else known(math.pow, x, y)\n\n",
        &["known"],
    ),
    (
        "inverse_sqrt",
        "def inverse_sqrt(x):\n    return quotient(1.0, sqrt(x))\n\n",
        &["quotient", "sqrt"],
    ),
    (
        "quotient",
        "# Division, which Python refuses where the divisor is 0.\n\
         def quotient(a, b):\n    \
             if b != 0.0:\n        \
                 return a / b\n    \
             sign = math.copysign(1.0, a) * math.copysign(1.0, b)\n    \
             return math.nan if a == 0.0 or a != a else sign * math.inf\n\n",
        &[],
    ),
    ("remainder", "def remainder(a, b):\n    return known(math.fmod, a, b)\n\n", &["known"]),
    (
        "divide_whole",
        "def divide_whole(a, b):\n    \
             if b == 0:\n        \
                 return a\n    \
             whole = abs(a) // abs(b)\n    \
             return whole if (a < 0) == (b < 0) else -whole\n\n",
        &[],
    ),
    (
        "remainder_whole",
        "def remainder_whole(a, b):\n    \
             return a - divide_whole(a, b) * b if b != 0 else 0\n\n",
        &["divide_whole"],
    ),
    (
        "wrap_i32",
        "# The number within 32 bits, where Python's integers have no end.\n\
         def wrap_i32(x):\n    \
             return ((x + 0x80000000) & 0xffffffff) - 0x80000000\n\n",
        &[],
    ),
    ("lesser", "def lesser(a, b):\n    return b if b < a or a != a else a\n\n", &[]),
    ("greater", "def greater(a, b):\n    return b if a < b or a != a else a\n\n", &[]),
    (
        "clamp",
        "def clamp(x, low, high):\n    return lesser(greater(x, low), high)\n\n",
        &["lesser", "greater"],
    ),
    (
        "saturate",
        "def saturate(x):\n    return lesser(greater(x, 0.0), 1.0)\n\n",
        &["lesser", "greater"],
    ),
    ("floor", "def floor(x):\n    return float(math.floor(x)) if math.isfinite(x) else x\n\n", &[]),
    ("ceil", "def ceil(x):\n    return float(math.ceil(x)) if math.isfinite(x) else x\n\n", &[]),
    ("trunc", "def trunc(x):\n    return float(math.trunc(x)) if math.isfinite(x) else x\n\n", &[]),
    (
        "nearest",
        "# The nearest whole number, of two the even one.\n\
         def nearest(x):\n    \
             return float(round(x)) if math.isfinite(x) else x\n\n",
        &[],
    ),
    ("fract", "def fract(x):\n    return x - floor(x)\n\n", &["floor"]),
    ("sign", "def sign(x):\n    return float((x > 0.0) - (x < 0.0))\n\n", &[]),
    ("mix", "def mix(a, b, t):\n    return a * (1.0 - t) + b * t\n\n", &[]),
    ("step", "def step(edge, x):\n    return 1.0 if edge <= x else 0.0\n\n", &[]),
    ("fma", "def fma(a, b, c):\n    return a * b + c\n\n", &[]),
    (
        "smoothstep",
        "def smoothstep(low, high, x):\n    \
             t = clamp(quotient(x - low, high - low), 0.0, 1.0)\n    \
             return t * t * (3.0 - 2.0 * t)\n\n",
        &["clamp", "quotient"],
    ),
    (
        "to_i32",
        "def to_i32(x):\n    \
             return 0 if x != x else int(min(max(x, -2147483648.0), 2147483647.0))\n\n",
        &[],
    ),
    (
        "to_u32",
        "def to_u32(x):\n    return 0 if x != x else int(min(max(x, 0.0), 4294967295.0))\n\n",
        &[],
    ),
    ("countonebits", "def countonebits(x):\n    return bin(x & 0xffffffff).count(\"1\")\n\n", &[]),
    (
        "countleadingzeros",
        "def countleadingzeros(x):\n    return 32 - (x & 0xffffffff).bit_length()\n\n",
        &[],
    ),
    (
        "bits_of_float",
        "def bits_of_float(x):\n    \
             most = 3.4028234663852886e38\n    \
             return struct.unpack(\"<I\", struct.pack(\"<f\", min(max(x, -most), most)))[0]\n\n",
        &[],
    ),
    (
        "float_of_bits",
        "def float_of_bits(x):\n    \
             return struct.unpack(\"<f\", struct.pack(\"<I\", x & 0xffffffff))[0]\n\n",
        &[],
    ),
    ("dot", "def dot(a, b):\n    return sum(x * y for x, y in zip(a, b))\n\n", &[]),
    (
        "cross",
        "def cross(a, b):\n    \
             return [\n        \
                 a[1] * b[2] - a[2] * b[1],\n        \
                 a[2] * b[0] - a[0] * b[2],\n        \
                 a[0] * b[1] - a[1] * b[0],\n    \
             ]\n\n",
        &[],
    ),
    ("length", "def length(a):\n    return sqrt(dot(a, a))\n\n", &["dot", "sqrt"]),
    (
        "distance",
        "def distance(a, b):\n    return length([x - y for x, y in zip(a, b)])\n\n",
        &["length"],
    ),
    (
        "normalize",
        "def normalize(a):\n    \
             whole = length(a)\n    \
             return [quotient(x, whole) for x in a]\n\n",
        &["length", "quotient"],
    ),
    (
        "reflect",
        "def reflect(a, n):\n    \
             along = dot(n, a)\n    \
             return [x - 2.0 * along * y for x, y in zip(a, n)]\n\n",
        &["dot"],
    ),
    // Python has these two.
    ("all", "", &[]),
    ("any", "", &[]),
    ("transpose", "def transpose(m):\n    return [list(row) for row in zip(*m)]\n\n", &[]),
    (
        "matrix_times_vector",
        "def matrix_times_vector(m, v):\n    return [dot(row, v) for row in zip(*m)]\n\n",
        &["dot"],
    ),
    (
        "vector_times_matrix",
        "def vector_times_matrix(v, m):\n    return [dot(v, column) for column in m]\n\n",
        &["dot"],
    ),
    (
        "matrix_times_matrix",
        "def matrix_times_matrix(a, b):\n    \
             return [matrix_times_vector(a, column) for column in b]\n\n",
        &["matrix_times_vector"],
    ),
    (
        "matrix_times_scalar",
        "def matrix_times_scalar(m, x):\n    return [[y * x for y in column] for column in m]\n\n",
        &[],
    ),
    (
        "matrix_plus_matrix",
        "def matrix_plus_matrix(a, b):\n    \
             return [[x + y for x, y in zip(c, d)] for c, d in zip(a, b)]\n\n",
        &[],
    ),
    (
        "matrix_minus_matrix",
        "def matrix_minus_matrix(a, b):\n    \
             return [[x - y for x, y in zip(c, d)] for c, d in zip(a, b)]\n\n",
        &[],
    ),
];
