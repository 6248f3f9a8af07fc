//! Operations on numbers and truth values.

use super::super::dialect::{HelperSource, Helpers, Kind, Level, Term};
use super::types::word;

/// An operation on scalars.
pub(super) fn scalar(
    operation: &str,
    kind: Kind,
    operands: &[Term],
    helpers: &mut Helpers,
) -> Option<Term> {
    if let Some(term) = operator(operation, kind, operands) {
        return Some(term);
    }
    if let Some(term) = conversion(operation, kind, operands, helpers) {
        return Some(term);
    }
    if let Some((_, function)) = MATH.iter().find(|(name, _)| *name == operation) {
        return Some(Term::call(function, operands));
    }
    let is_integer = matches!(kind, Kind::Signed | Kind::Unsigned);
    let [x, ..] = operands else { return None };
    Some(match (operation, kind) {
        ("abs", Kind::Unsigned) => x.clone(),
        ("abs", _) => Term::call("Math.Abs", operands),
        ("sign", Kind::Signed) => Term::call("Math.Sign", operands),
        ("min", _) if is_integer => Term::call("Math.Min", operands),
        ("max", _) if is_integer => Term::call("Math.Max", operands),
        ("clamp", _) if is_integer => {
            let [x, low, high] = operands else { return None };
            Term::primary(format!("Math.Min(Math.Max({}, {}), {})", x.text, low.text, high.text))
        }
        ("exp2", _) => Term::primary(format!("Math.Pow(2.0, {})", x.text)),
        ("log2", _) => Term::primary(format!("Math.Log({}, 2.0)", x.text)),
        ("inversesqrt", _) => Term::new(format!("1.0 / Math.Sqrt({})", x.text), Level::Product),
        ("select", _) => {
            let [condition, yes, no] = operands else { return None };
            let (condition, yes, no) =
                (condition.at(Level::Or), yes.at(Level::Or), no.at(Level::Choice));
            Term::new(format!("{condition} ? {yes} : {no}"), Level::Choice)
        }
        ("/", Kind::Signed) => helper("DivideInt", operands, helpers),
        ("/", Kind::Unsigned) => helper("DivideUInt", operands, helpers),
        ("%", Kind::Signed) => helper("RemainderInt", operands, helpers),
        ("%", Kind::Unsigned) => helper("RemainderUInt", operands, helpers),
        _ => {
            let name = super::function_of(operation);
            helpers.call_known(HELPERS, &name, operands)?
        }
    })
}

fn helper(name: &'static str, operands: &[Term], helpers: &mut Helpers) -> Term {
    helpers.call(name, operands)
}

fn operator(operation: &str, kind: Kind, operands: &[Term]) -> Option<Term> {
    if let [x] = operands {
        return Some(match operation {
            "negate" => Term::new(format!("-{}", x.at(Level::Primary)), Level::Unary),
            "!" => Term::new(format!("!{}", x.at(Level::Primary)), Level::Unary),
            "~" => Term::new(format!("~{}", x.at(Level::Primary)), Level::Unary),
            _ => return None,
        });
    }
    let [x, y] = operands else { return None };
    Some(match (operation, kind) {
        ("/" | "%", Kind::Signed | Kind::Unsigned) => return None,
        ("*" | "/" | "%", _) => Term::joined(x, operation, y, Level::Product),
        ("+" | "-", _) => Term::joined(x, operation, y, Level::Sum),
        ("==" | "!=" | "<" | "<=" | ">" | ">=", _) => {
            Term::joined(x, operation, y, Level::Comparison)
        }
        ("&" | "&&", Kind::Bool) | ("&&", _) => Term::joined(x, "&&", y, Level::And),
        ("|" | "||", Kind::Bool) | ("||", _) => Term::joined(x, "||", y, Level::Or),
        ("^", Kind::Bool) => Term::joined(x, "!=", y, Level::Comparison),
        ("&" | "|" | "^", _) => Term::joined(x, operation, y, Level::Bits),
        ("<<" | ">>", _) => {
            // The amount is an `int`; the language takes it modulo 32, as WGSL does.
            let amount = Term::new(format!("(int){}", y.at(Level::Primary)), Level::Unary);
            Term::joined(x, operation, &amount, Level::Bits)
        }
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
    let cast = |ty: &str| Term::new(format!("({ty}){}", x.at(Level::Primary)), Level::Unary);
    let choice = |yes: &str, no: &str| {
        Term::new(format!("{} ? {yes} : {no}", x.at(Level::Or)), Level::Choice)
    };
    Some(match (operation, kind) {
        ("to_float", Kind::Float) => x.clone(),
        ("to_float", Kind::Bool) => choice("1.0", "0.0"),
        ("to_float", _) => cast("double"),
        ("to_signed", Kind::Float) => helpers.call("ToInt", operands),
        ("to_unsigned", Kind::Float) => helpers.call("ToUInt", operands),
        ("to_signed", Kind::Bool) => choice("1", "0"),
        ("to_unsigned", Kind::Bool) => choice("1u", "0u"),
        ("to_signed" | "bits_to_signed", Kind::Signed)
        | ("to_unsigned" | "bits_to_unsigned", Kind::Unsigned)
        | ("to_bool", Kind::Bool)
        | ("bits_to_float", Kind::Float) => x.clone(),
        ("to_signed" | "bits_to_signed", Kind::Unsigned) => {
            Term::primary(format!("unchecked((int){})", x.at(Level::Primary)))
        }
        ("to_unsigned" | "bits_to_unsigned", Kind::Signed) => {
            Term::primary(format!("unchecked((uint){})", x.at(Level::Primary)))
        }
        ("to_bool", Kind::Float) => Term::joined(x, "!=", &Term::primary("0.0"), Level::Comparison),
        ("to_bool", _) => Term::joined(x, "!=", &Term::primary("0"), Level::Comparison),
        ("bits_to_float", _) => {
            let bits = if kind == Kind::Unsigned {
                format!("unchecked((int){})", x.at(Level::Primary))
            } else {
                x.text.clone()
            };
            Term::primary(format!("BitConverter.Int32BitsToSingle({bits})"))
        }
        ("bits_to_signed", Kind::Float) => Term::primary(format!(
            "BitConverter.SingleToInt32Bits((float){})",
            x.at(Level::Primary)
        )),
        ("bits_to_unsigned", Kind::Float) => Term::primary(format!(
            "unchecked(({})BitConverter.SingleToInt32Bits((float){}))",
            word(Kind::Unsigned),
            x.at(Level::Primary)
        )),
        _ => return None,
    })
}

/// Functions of WGSL that `Math` has, by its names.
const MATH: &[(&str, &str)] = &[
    ("cos", "Math.Cos"),
    ("cosh", "Math.Cosh"),
    ("sin", "Math.Sin"),
    ("sinh", "Math.Sinh"),
    ("tan", "Math.Tan"),
    ("tanh", "Math.Tanh"),
    ("acos", "Math.Acos"),
    ("asin", "Math.Asin"),
    ("atan", "Math.Atan"),
    ("atan2", "Math.Atan2"),
    ("asinh", "Math.Asinh"),
    ("acosh", "Math.Acosh"),
    ("atanh", "Math.Atanh"),
    ("ceil", "Math.Ceiling"),
    ("floor", "Math.Floor"),
    ("trunc", "Math.Truncate"),
    // Of two whole numbers the even one.
    ("round", "Math.Round"),
    ("exp", "Math.Exp"),
    ("log", "Math.Log"),
    ("sqrt", "Math.Sqrt"),
];

/// Helper functions: name, source, and the names of those that each calls.
pub(super) const HELPERS: &[HelperSource] = &[
    ("Min", "static double Min(double a, double b) => b < a || double.IsNaN(a) ? b : a;\n", &[]),
    ("Max", "static double Max(double a, double b) => a < b || double.IsNaN(a) ? b : a;\n", &[]),
    (
        "Clamp",
        "static double Clamp(double x, double low, double high) => Min(Max(x, low), high);\n",
        &["Max", "Min"],
    ),
    ("Saturate", "static double Saturate(double x) => Clamp(x, 0.0, 1.0);\n", &["Clamp"]),
    ("Fract", "static double Fract(double x) => x - Math.Floor(x);\n", &[]),
    ("Radians", "static double Radians(double x) => x * (Math.PI / 180.0);\n", &[]),
    ("Degrees", "static double Degrees(double x) => x * (180.0 / Math.PI);\n", &[]),
    ("Sign", "static double Sign(double x) => x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;\n", &[]),
    (
        "Pow",
        "static double Pow(double x, double y) => x < 0.0 ? double.NaN : Math.Pow(x, y);\n",
        &[],
    ),
    ("Mix", "static double Mix(double a, double b, double t) => a * (1.0 - t) + b * t;\n", &[]),
    ("Step", "static double Step(double edge, double x) => edge <= x ? 1.0 : 0.0;\n", &[]),
    ("Fma", "static double Fma(double a, double b, double c) => a * b + c;\n", &[]),
    (
        "SmoothStep",
        "static double SmoothStep(double low, double high, double x)\n{\n    \
         double t = Clamp((x - low) / (high - low), 0.0, 1.0);\n    \
         return t * t * (3.0 - 2.0 * t);\n}\n",
        &["Clamp"],
    ),
    (
        "ToInt",
        "static int ToInt(double x) =>\n    \
         double.IsNaN(x) ? 0 : (int)Math.Min(Math.Max(x, int.MinValue), int.MaxValue);\n",
        &[],
    ),
    (
        "ToUInt",
        "static uint ToUInt(double x) =>\n    \
         double.IsNaN(x) ? 0u : (uint)Math.Min(Math.Max(x, 0.0), uint.MaxValue);\n",
        &[],
    ),
    (
        "DivideInt",
        "static int DivideInt(int a, int b) => b == 0 ? a : b == -1 ? unchecked(-a) : a / b;\n",
        &[],
    ),
    ("DivideUInt", "static uint DivideUInt(uint a, uint b) => b == 0 ? a : a / b;\n", &[]),
    (
        "RemainderInt",
        "static int RemainderInt(int a, int b) => b == 0 || b == -1 ? 0 : a % b;\n",
        &[],
    ),
    ("RemainderUInt", "static uint RemainderUInt(uint a, uint b) => b == 0 ? 0 : a % b;\n", &[]),
    (
        "Countonebits",
        "static uint Countonebits(uint x)\n{\n    \
         uint count = 0;\n    \
         for (; x != 0; x >>= 1)\n    {\n        count += x & 1;\n    }\n    \
         return count;\n}\n",
        &[],
    ),
];
