//! GDScript, the language of Godot 4.
//!
//! Functions are static, so that a program calls them by the script's name. Vectors are arrays: the
//! language's own vectors have 32 bits a component, its floats and arrays of them 64. Structs are
//! dictionaries, whose members read as those of objects do.

use super::dialect::{Dialect, Head, HelperSource, Helpers, Kind, Level, Term, ValueType};
use super::pythonic;

/// GDScript: vectors, matrices and arrays are arrays, structs are dictionaries.
pub(super) struct GdScript;

/// Words of the language, and methods of scripts' objects that no function can hide.
const KEYWORDS: &[&str] = &[
    "and",
    "as",
    "assert",
    "await",
    "bool",
    "break",
    "breakpoint",
    "call",
    "class",
    "class_name",
    "connect",
    "const",
    "continue",
    "elif",
    "else",
    "enum",
    "extends",
    "false",
    "float",
    "for",
    "free",
    "func",
    "get",
    "if",
    "in",
    "int",
    "is",
    "load",
    "match",
    "namespace",
    "not",
    "notification",
    "null",
    "or",
    "pass",
    "preload",
    "print",
    "range",
    "reference",
    "return",
    "self",
    "set",
    "signal",
    "static",
    "super",
    "tr",
    "trait",
    "true",
    "unreference",
    "var",
    "void",
    "when",
    "while",
    "yield",
    "Array",
    "Color",
    "Dictionary",
    "INF",
    "NAN",
    "Object",
    "PI",
    "Plane",
    "Quaternion",
    "RefCounted",
    "TAU",
    // Functions of the language, which a value of the same name would hide from readers.
    "abs",
    "absf",
    "absi",
    "atan",
    "atan2",
    "ceilf",
    "clampf",
    "clampi",
    "cosh",
    "cos",
    "deg_to_rad",
    "exp",
    "floorf",
    "fmod",
    "lerp",
    "lerpf",
    "log",
    "maxf",
    "maxi",
    "minf",
    "mini",
    "pow",
    "rad_to_deg",
    "roundf",
    "sign",
    "signf",
    "signi",
    "sin",
    "sinh",
    "sqrt",
    "tan",
    "tanh",
    // Helpers whose names are none of WGSL's.
    "arc_cosine",
    "arc_sine",
    "area_cosine",
    "area_tangent",
    "bits_of_float",
    "count_leading_zeros",
    "count_one_bits",
    "divide_whole",
    "float_of_bits",
    "greater",
    "inverse_sqrt",
    "lesser",
    "logarithm_of_2",
    "nearest",
    "power_of",
    "remainder_whole",
    "shift_left",
    "shift_right",
    "to_i32",
    "to_u32",
    "whole_part",
    "wrap_i32",
];

impl Dialect for GdScript {
    fn keywords(&self) -> &'static [&'static str] {
        KEYWORDS
    }

    fn float(&self, value: f64) -> Term {
        Term::float(value, "NAN", "INF")
    }

    fn truth(&self, value: bool) -> Term {
        Term::primary(if value { "true" } else { "false" })
    }

    fn scalar(
        &self,
        operation: &str,
        kind: Kind,
        operands: &[Term],
        helpers: &mut Helpers,
    ) -> Option<Term> {
        let zero = if kind == Kind::Float { "0.0" } else { "0" };
        operator(operation, kind, operands, helpers)
            .or_else(|| pythonic::conversion(operation, kind, operands, zero, helpers))
            .or_else(|| function(operation, kind, operands, helpers))
    }

    fn repeated(&self, item: &Term, count: usize) -> Term {
        Term::primary(format!("[{}]", vec![item.text.as_str(); count].join(", ")))
    }

    fn structure(&self, _: &str, members: &[(String, Term)]) -> Term {
        let member = |(name, term): &(String, Term)| match is_keyword(name) {
            true => format!("\"{name}\" = {}", term.text),
            false => format!("{name} = {}", term.text),
        };
        let members: Vec<String> = members.iter().map(member).collect();
        Term::primary(format!("{{{}}}", members.join(", ")))
    }

    fn member(&self, base: &Term, name: &str) -> Term {
        let base = base.at(Level::Primary);
        Term::primary(match is_keyword(name) {
            true => format!("{base}[\"{name}\"]"),
            false => format!("{base}.{name}"),
        })
    }

    fn copy(&self, value: &Term, ty: &ValueType) -> Term {
        if !ty.is_composite() {
            return value.clone();
        }
        let is_flat = ty.is_flat();
        let argument = if is_flat { "" } else { "true" };
        Term::primary(format!("{}.duplicate({argument})", value.at(Level::Primary)))
    }

    fn each(&self, name: &str, arity: usize, [kind, _]: [Kind; 2], body: &str) -> String {
        // The condition of a choice is a vector of truth values, and shifts are by whole numbers.
        let first = if name.starts_with("vector_select") { "bool" } else { word(kind) };
        let kinds = [first, word(kind), word(kind)];
        let lists = ["a", "b", "c"];
        let parameters: Vec<String> =
            lists[..arity].iter().map(|list| format!("{list}: Array")).collect();
        let mut text = format!("static func {name}({}) -> Array:\n", parameters.join(", "));
        text += "\tvar all := []\n\tfor i: int in a.size():\n";
        for ((item, list), kind) in ["x", "y", "z"].iter().zip(lists).zip(kinds).take(arity) {
            text += &format!("\t\tvar {item}: {kind} = {list}[i]\n");
        }
        text += &format!("\t\tall.append({body})\n\treturn all\n\n");
        text
    }

    fn helpers(&self) -> &'static [HelperSource] {
        HELPERS
    }

    fn ty(&self, ty: &ValueType) -> String {
        match ty {
            ValueType::Scalar(kind) => word(*kind),
            ValueType::Struct(_) => "Dictionary",
            _ => "Array",
        }
        .to_owned()
    }

    fn declare(&self, name: &str, ty: &ValueType, value: &Term, _: bool) -> String {
        format!("var {name}: {} = {}", self.ty(ty), value.text)
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
            Head::Forever => "while true:".to_owned(),
            Head::Function { name, parameters, result } => {
                let parameter =
                    |(name, ty): &(String, ValueType)| format!("{name}: {}", self.ty(ty));
                let parameters: Vec<String> = parameters.iter().map(parameter).collect();
                format!("static func {name}({}) -> {}:", parameters.join(", "), self.ty(result))
            }
        }
    }

    fn close(&self) -> Option<&'static str> {
        None
    }

    fn indent(&self) -> &'static str {
        "\t"
    }

    fn nothing(&self) -> Option<&'static str> {
        Some("pass")
    }

    fn constant(&self, name: &str, ty: &ValueType, value: &Term) -> String {
        format!("const {name}: {} = {}", self.ty(ty), value.text)
    }

    fn doc(&self, lines: &[String]) -> Vec<String> {
        lines.iter().map(|line| format!("## {line}").trim_end().to_owned()).collect()
    }
}

/// Type of a scalar.
fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Float => "float",
        Kind::Signed | Kind::Unsigned => "int",
        Kind::Bool => "bool",
    }
}

/// True for a word that is no name after a point.
fn is_keyword(name: &str) -> bool {
    KEYWORDS.contains(&name)
}

fn operator(operation: &str, kind: Kind, operands: &[Term], helpers: &mut Helpers) -> Option<Term> {
    let [x, y] = operands else { return pythonic::operator(operation, kind, operands, helpers) };
    Some(match (operation, kind) {
        ("/", Kind::Float) => Term::joined(x, "/", y, Level::Product),
        ("%", Kind::Float) => Term::call("fmod", operands),
        ("<<", _) => {
            let shifted = helpers.call("shift_left", operands);
            pythonic::within(shifted, kind, helpers)
        }
        (">>", Kind::Unsigned) => Term::joined(x, ">>", y, Level::Bits),
        (">>", _) => helpers.call("shift_right", operands),
        _ => return pythonic::operator(operation, kind, operands, helpers),
    })
}

fn function(operation: &str, kind: Kind, operands: &[Term], helpers: &mut Helpers) -> Option<Term> {
    let is_float = kind == Kind::Float;
    if let Some((_, of_floats, of_integers)) = MATH.iter().find(|it| it.0 == operation) {
        let name = if is_float { of_floats } else { of_integers };
        return (!name.is_empty()).then(|| Term::call(name, operands));
    }
    if let Some((_, helper)) = RENAMED.iter().find(|(name, _)| *name == operation) {
        return Some(helpers.call(helper, operands));
    }
    let [x, ..] = operands else { return None };
    Some(match operation {
        "exp2" => Term::call("pow", &[Term::primary("2.0"), x.clone()]),
        "saturate" => {
            let least = Term::call("maxf", &[x.clone(), Term::primary("0.0")]);
            Term::call("minf", &[least, Term::primary("1.0")])
        }
        "min" | "max" => {
            let [_, y] = operands else { return None };
            extreme(operation, is_float, x, y, helpers)
        }
        // Godot's own function takes ends that are in order, and leaves what is no number.
        "clamp" => {
            let [x, low, high] = operands else { return None };
            let least = extreme("max", is_float, x, low, helpers);
            extreme("min", is_float, &least, high, helpers)
        }
        "select" => pythonic::select(operands)?,
        _ => helpers.call_known(HELPERS, operation, operands)?,
    })
}

/// The lesser or the greater of two numbers. Godot's functions pass over a first number that is
/// none, as WGSL's do, but not over a second one.
fn extreme(operation: &str, is_float: bool, x: &Term, y: &Term, helpers: &mut Helpers) -> Term {
    let is_number = y.text.trim_start_matches('-').parse::<f64>().is_ok();
    let operands = [x.clone(), y.clone()];
    match (operation, is_float) {
        ("min", false) => Term::call("mini", &operands),
        (_, false) => Term::call("maxi", &operands),
        ("min", true) if is_number => Term::call("minf", &operands),
        (_, true) if is_number => Term::call("maxf", &operands),
        ("min", true) => helpers.call("lesser", &operands),
        (_, true) => helpers.call("greater", &operands),
    }
}

/// Functions of WGSL that GDScript has: of floats, and of integers where those have one.
const MATH: &[(&str, &str, &str)] = &[
    ("abs", "absf", "absi"),
    ("asinh", "asinh", ""),
    ("atan", "atan", ""),
    ("atan2", "atan2", ""),
    ("ceil", "ceilf", ""),
    ("cos", "cos", ""),
    ("cosh", "cosh", ""),
    ("degrees", "rad_to_deg", ""),
    ("exp", "exp", ""),
    ("floor", "floorf", ""),
    ("log", "log", ""),
    ("radians", "deg_to_rad", ""),
    ("sign", "signf", "signi"),
    ("sin", "sin", ""),
    ("sinh", "sinh", ""),
    ("sqrt", "sqrt", ""),
    ("tan", "tan", ""),
    ("tanh", "tanh", ""),
];

/// Functions of WGSL by the names of their helpers.
const RENAMED: &[(&str, &str)] = &[
    ("acos", "arc_cosine"),
    ("acosh", "area_cosine"),
    ("asin", "arc_sine"),
    ("atanh", "area_tangent"),
    ("countleadingzeros", "count_leading_zeros"),
    ("countonebits", "count_one_bits"),
    ("inversesqrt", "inverse_sqrt"),
    ("log2", "logarithm_of_2"),
    ("pow", "power_of"),
    ("round", "nearest"),
    ("trunc", "whole_part"),
];

/// Helper functions: name, source, and the names of those that each calls.
const HELPERS: &[HelperSource] = &[
    (
        "arc_sine",
        "static func arc_sine(x: float) -> float:\n\treturn NAN if absf(x) > 1.0 else asin(x)\n\n",
        &[],
    ),
    (
        "arc_cosine",
        "static func arc_cosine(x: float) -> float:\n\
         \treturn NAN if absf(x) > 1.0 else acos(x)\n\n",
        &[],
    ),
    (
        "area_cosine",
        "static func area_cosine(x: float) -> float:\n\treturn NAN if x < 1.0 else acosh(x)\n\n",
        &[],
    ),
    (
        "area_tangent",
        "static func area_tangent(x: float) -> float:\n\
         \treturn NAN if absf(x) > 1.0 else 0.5 * log((1.0 + x) / (1.0 - x))\n\n",
        &[],
    ),
    (
        "lesser",
        "## The lesser of two numbers, passing over what is none.\n\
         static func lesser(a: float, b: float) -> float:\n\
         \treturn b if b < a or is_nan(a) else a\n\n",
        &[],
    ),
    (
        "greater",
        "## The greater of two numbers, passing over what is none.\n\
         static func greater(a: float, b: float) -> float:\n\
         \treturn b if a < b or is_nan(a) else a\n\n",
        &[],
    ),
    (
        "logarithm_of_2",
        "static func logarithm_of_2(x: float) -> float:\n\
         \treturn log(x) / 0.6931471805599453\n\n",
        &[],
    ),
    (
        "power_of",
        "static func power_of(x: float, y: float) -> float:\n\
         \treturn NAN if x < 0.0 else pow(x, y)\n\n",
        &[],
    ),
    (
        "inverse_sqrt",
        "static func inverse_sqrt(x: float) -> float:\n\treturn 1.0 / sqrt(x)\n\n",
        &[],
    ),
    (
        "divide_whole",
        "static func divide_whole(a: int, b: int) -> int:\n\
         \t@warning_ignore(\"integer_division\")\n\
         \treturn a if b == 0 else a / b\n\n",
        &[],
    ),
    (
        "remainder_whole",
        "static func remainder_whole(a: int, b: int) -> int:\n\treturn 0 if b == 0 else a % b\n\n",
        &[],
    ),
    (
        "shift_left",
        "static func shift_left(x: int, count: int) -> int:\n\
         \treturn (x & 0xffffffff) << count\n\n",
        &[],
    ),
    (
        "shift_right",
        "## The number shifted to the right, its sign kept. Godot shifts no negative numbers.\n\
         static func shift_right(x: int, count: int) -> int:\n\
         \treturn x >> count if x >= 0 else ~(~x >> count)\n\n",
        &[],
    ),
    (
        "wrap_i32",
        "## The number within 32 bits, of which integers have 64 here.\n\
         static func wrap_i32(x: int) -> int:\n\
         \treturn ((x + 0x80000000) & 0xffffffff) - 0x80000000\n\n",
        &[],
    ),
    (
        "whole_part",
        "static func whole_part(x: float) -> float:\n\
         \treturn floorf(x) if x >= 0.0 else ceilf(x)\n\n",
        &[],
    ),
    (
        "nearest",
        "## The nearest whole number, of two the even one.\n\
         static func nearest(x: float) -> float:\n\
         \tvar low := floorf(x)\n\
         \tvar apart := x - low\n\
         \tif apart == 0.5:\n\
         \t\treturn low if fmod(low, 2.0) == 0.0 else low + 1.0\n\
         \treturn low if apart < 0.5 else low + 1.0\n\n",
        &[],
    ),
    ("fract", "static func fract(x: float) -> float:\n\treturn x - floorf(x)\n\n", &[]),
    (
        "mix",
        "static func mix(a: float, b: float, t: float) -> float:\n\
         \treturn a * (1.0 - t) + b * t\n\n",
        &[],
    ),
    (
        "step",
        "static func step(edge: float, x: float) -> float:\n\
         \treturn 1.0 if edge <= x else 0.0\n\n",
        &[],
    ),
    ("fma", "static func fma(a: float, b: float, c: float) -> float:\n\treturn a * b + c\n\n", &[]),
    (
        "smoothstep",
        "static func smoothstep(low: float, high: float, x: float) -> float:\n\
         \tvar t := minf(maxf((x - low) / (high - low), 0.0), 1.0)\n\
         \treturn t * t * (3.0 - 2.0 * t)\n\n",
        &[],
    ),
    (
        "to_i32",
        "static func to_i32(x: float) -> int:\n\
         \treturn 0 if is_nan(x) else int(clampf(x, -2147483648.0, 2147483647.0))\n\n",
        &[],
    ),
    (
        "to_u32",
        "static func to_u32(x: float) -> int:\n\
         \treturn 0 if is_nan(x) else int(clampf(x, 0.0, 4294967295.0))\n\n",
        &[],
    ),
    (
        "count_one_bits",
        "static func count_one_bits(x: int) -> int:\n\
         \tvar count := 0\n\
         \tfor bit: int in 32:\n\
         \t\tcount += ((x & 0xffffffff) >> bit) & 1\n\
         \treturn count\n\n",
        &[],
    ),
    (
        "count_leading_zeros",
        "static func count_leading_zeros(x: int) -> int:\n\
         \tfor bit: int in 32:\n\
         \t\tif ((x & 0xffffffff) >> (31 - bit)) & 1:\n\
         \t\t\treturn bit\n\
         \treturn 32\n\n",
        &[],
    ),
    (
        "bits_of_float",
        "static func bits_of_float(x: float) -> int:\n\
         \tvar most := 3.4028234663852886e38\n\
         \treturn PackedFloat32Array([clampf(x, -most, most)]).to_byte_array().decode_u32(0)\n\n",
        &[],
    ),
    (
        "float_of_bits",
        "static func float_of_bits(x: int) -> float:\n\
         \tvar bytes := PackedByteArray([0, 0, 0, 0])\n\
         \tbytes.encode_u32(0, x & 0xffffffff)\n\
         \treturn bytes.decode_float(0)\n\n",
        &[],
    ),
    (
        "dot",
        "static func dot(a: Array, b: Array) -> float:\n\
         \tvar sum := 0.0\n\
         \tfor i: int in a.size():\n\
         \t\tsum += a[i] * b[i]\n\
         \treturn sum\n\n",
        &[],
    ),
    (
        "cross",
        "static func cross(a: Array, b: Array) -> Array:\n\
         \treturn [\n\
         \t\ta[1] * b[2] - a[2] * b[1],\n\
         \t\ta[2] * b[0] - a[0] * b[2],\n\
         \t\ta[0] * b[1] - a[1] * b[0],\n\
         \t]\n\n",
        &[],
    ),
    ("length", "static func length(a: Array) -> float:\n\treturn sqrt(dot(a, a))\n\n", &["dot"]),
    (
        "distance",
        "static func distance(a: Array, b: Array) -> float:\n\
         \tvar sum := 0.0\n\
         \tfor i: int in a.size():\n\
         \t\tsum += (a[i] - b[i]) ** 2.0\n\
         \treturn sqrt(sum)\n\n",
        &[],
    ),
    (
        "normalize",
        "static func normalize(a: Array) -> Array:\n\
         \tvar whole := length(a)\n\
         \treturn a.map(func(x: float) -> float: return x / whole)\n\n",
        &["length"],
    ),
    (
        "reflect",
        "static func reflect(a: Array, n: Array) -> Array:\n\
         \tvar along := dot(n, a)\n\
         \tvar all := []\n\
         \tfor i: int in a.size():\n\
         \t\tall.append(a[i] - 2.0 * along * n[i])\n\
         \treturn all\n\n",
        &["dot"],
    ),
    ("all", "static func all(a: Array) -> bool:\n\treturn not a.has(false)\n\n", &[]),
    ("any", "static func any(a: Array) -> bool:\n\treturn a.has(true)\n\n", &[]),
    (
        "transpose",
        "static func transpose(m: Array) -> Array:\n\
         \tvar rows := []\n\
         \tfor row: int in m[0].size():\n\
         \t\trows.append(m.map(func(column: Array) -> float: return column[row]))\n\
         \treturn rows\n\n",
        &[],
    ),
    (
        "matrix_times_vector",
        "static func matrix_times_vector(m: Array, v: Array) -> Array:\n\
         \tvar all := []\n\
         \tfor row: int in m[0].size():\n\
         \t\tvar sum := 0.0\n\
         \t\tfor column: int in m.size():\n\
         \t\t\tsum += m[column][row] * v[column]\n\
         \t\tall.append(sum)\n\
         \treturn all\n\n",
        &[],
    ),
    (
        "vector_times_matrix",
        "static func vector_times_matrix(v: Array, m: Array) -> Array:\n\
         \treturn m.map(func(column: Array) -> float: return dot(v, column))\n\n",
        &["dot"],
    ),
    (
        "matrix_times_matrix",
        "static func matrix_times_matrix(a: Array, b: Array) -> Array:\n\
         \treturn b.map(func(column: Array) -> Array: return matrix_times_vector(a, column))\n\n",
        &["matrix_times_vector"],
    ),
    (
        "matrix_times_scalar",
        "static func matrix_times_scalar(m: Array, x: float) -> Array:\n\
         \tvar scaled := func(column: Array) -> Array:\n\
         \t\treturn column.map(func(y: float) -> float: return y * x)\n\
         \treturn m.map(scaled)\n\n",
        &[],
    ),
    (
        "matrix_plus_matrix",
        "static func matrix_plus_matrix(a: Array, b: Array) -> Array:\n\
         \tvar all := []\n\
         \tfor column: int in a.size():\n\
         \t\tvar sums := []\n\
         \t\tfor row: int in a[column].size():\n\
         \t\t\tsums.append(a[column][row] + b[column][row])\n\
         \t\tall.append(sums)\n\
         \treturn all\n\n",
        &[],
    ),
    (
        "matrix_minus_matrix",
        "static func matrix_minus_matrix(a: Array, b: Array) -> Array:\n\
         \tvar all := []\n\
         \tfor column: int in a.size():\n\
         \t\tvar differences := []\n\
         \t\tfor row: int in a[column].size():\n\
         \t\t\tdifferences.append(a[column][row] - b[column][row])\n\
         \t\tall.append(differences)\n\
         \treturn all\n\n",
        &[],
    ),
];
