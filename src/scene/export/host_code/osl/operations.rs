//! Operations on numbers, vectors and matrices.

use super::super::dialect::{Dialect as _, Helpers, Kind, Level, Term, ValueType};
use super::super::expressions::result_kind;
use super::Osl;
use crate::wgsl::rename_identifiers;

/// Functions that the language has under the names of WGSL, for floats and for `vector`.
const FUNCTIONS: &[&str] = &[
    "abs",
    "acos",
    "asin",
    "atan",
    "atan2",
    "ceil",
    "clamp",
    "cos",
    "cosh",
    "degrees",
    "exp",
    "exp2",
    "floor",
    "inversesqrt",
    "log",
    "log2",
    "max",
    "min",
    "mix",
    "pow",
    "radians",
    "round",
    "sign",
    "sin",
    "sinh",
    "smoothstep",
    "sqrt",
    "step",
    "tan",
    "tanh",
    "trunc",
];

/// Functions that `vector2.h` and `vector4.h` have.
const OF_STRUCTS: &[&str] = &[
    "abs",
    "acos",
    "asin",
    "atan2",
    "ceil",
    "clamp",
    "cos",
    "exp",
    "floor",
    "log",
    "log2",
    "max",
    "min",
    "pow",
    "sign",
    "sin",
    "smoothstep",
    "sqrt",
    "tan",
];

/// An operation on scalars.
pub(super) fn scalar(operation: &str, kind: Kind, operands: &[Term]) -> Option<Term> {
    if let Some(term) = operator(operation, kind, operands) {
        return Some(term);
    }
    if let Some(term) = conversion(operation, kind, operands) {
        return Some(term);
    }
    let call = |name: &str| Some(Term::call(name, operands));
    match (operation, kind, operands) {
        ("select", _, [condition, yes, no]) => {
            let (condition, yes, no) =
                (condition.at(Level::Or), yes.at(Level::Or), no.at(Level::Choice));
            Some(Term::new(format!("{condition} ? {yes} : {no}"), Level::Choice))
        }
        ("dpdx", Kind::Float, _) => call("Dx"),
        ("dpdy", Kind::Float, _) => call("Dy"),
        ("fract" | "fwidth", Kind::Float, _) => call(operation),
        ("saturate", Kind::Float, [x]) => {
            Some(Term::primary(format!("clamp({}, 0.0, 1.0)", x.text)))
        }
        ("fma", Kind::Float, [x, y, z]) => {
            let product = Term::joined(x, "*", y, Level::Product);
            Some(Term::joined(&product, "+", z, Level::Sum))
        }
        ("abs" | "min" | "max" | "clamp", Kind::Signed, _) => call(operation),
        ("min" | "max", Kind::Unsigned, [x, y]) => {
            let (a, b) = if operation == "min" { (x, y) } else { (y, x) };
            let is_below = Term::call("is_below", &[a.clone(), b.clone()]);
            scalar("select", Kind::Unsigned, &[is_below, x.clone(), y.clone()])
        }
        (_, Kind::Float, _) if FUNCTIONS.contains(&operation) => call(operation),
        _ => None,
    }
}

fn operator(operation: &str, kind: Kind, operands: &[Term]) -> Option<Term> {
    if let [x] = operands {
        let sign = match operation {
            "negate" => "-",
            "!" => "!",
            "~" => "~",
            _ => return None,
        };
        return Some(Term::new(format!("{sign}{}", x.at(Level::Primary)), Level::Unary));
    }
    let [x, y] = operands else { return None };
    let is_unsigned = kind == Kind::Unsigned;
    let not = |term: Term| Term::new(format!("!{}", term.text), Level::Unary);
    Some(match operation {
        "/" if is_unsigned => Term::call("divide_unsigned", operands),
        "%" if is_unsigned => Term::call("remainder_unsigned", operands),
        ">>" if is_unsigned => Term::call("shift_right", operands),
        "<" if is_unsigned => Term::call("is_below", operands),
        ">" if is_unsigned => Term::call("is_below", &[y.clone(), x.clone()]),
        "<=" if is_unsigned => not(Term::call("is_below", &[y.clone(), x.clone()])),
        ">=" if is_unsigned => not(Term::call("is_below", operands)),
        "%" if kind == Kind::Float => Term::call("fmod", operands),
        "*" | "/" | "%" => Term::joined(x, operation, y, Level::Product),
        "+" | "-" => Term::joined(x, operation, y, Level::Sum),
        "==" | "!=" | "<" | "<=" | ">" | ">=" => Term::joined(x, operation, y, Level::Comparison),
        "&" if kind == Kind::Bool => Term::joined(x, "&&", y, Level::And),
        "|" if kind == Kind::Bool => Term::joined(x, "||", y, Level::Or),
        "^" if kind == Kind::Bool => Term::joined(x, "!=", y, Level::Comparison),
        "&&" => Term::joined(x, "&&", y, Level::And),
        "||" => Term::joined(x, "||", y, Level::Or),
        "&" | "|" | "^" | "<<" | ">>" => Term::joined(x, operation, y, Level::Bits),
        _ => return None,
    })
}

fn conversion(operation: &str, kind: Kind, operands: &[Term]) -> Option<Term> {
    let [x] = operands else { return None };
    let cast = |ty: &str| Term::new(format!("({ty}){}", x.at(Level::Primary)), Level::Unary);
    Some(match (operation, kind) {
        ("to_float", Kind::Float) | ("bits_to_float", Kind::Float) => x.clone(),
        ("to_float", Kind::Unsigned) => Term::call("float_of_unsigned", operands),
        ("to_float", _) => cast("float"),
        ("to_signed", Kind::Float) => cast("int"),
        ("to_unsigned", Kind::Float) => Term::call("unsigned_of_float", operands),
        ("to_bool", Kind::Float) => Term::joined(x, "!=", &Term::primary("0.0"), Level::Comparison),
        ("to_bool", Kind::Signed | Kind::Unsigned) => {
            Term::joined(x, "!=", &Term::primary("0"), Level::Comparison)
        }
        ("to_bool" | "to_signed" | "to_unsigned", _) => x.clone(),
        ("bits_to_signed" | "bits_to_unsigned", Kind::Signed | Kind::Unsigned) => x.clone(),
        _ => return None,
    })
}

/// An operation that the language has for whole vectors; `None` for others.
pub(super) fn whole(operation: &str, types: &[ValueType], operands: &[Term]) -> Option<Term> {
    let (count, kind) = vector_among(types)?;
    if types.iter().any(|ty| matches!(ty, ValueType::Matrix(..))) {
        return None;
    }
    let is_own = count == 3;
    if let ("select", [condition, yes, no]) = (operation, operands) {
        let is_float = types.get(1) == Some(&ValueType::Vector(3, Kind::Float));
        let operands = [no.clone(), yes.clone(), condition.clone()];
        return is_float.then(|| Term::call("select", &operands));
    }
    if kind != Kind::Float {
        return None;
    }
    let call = |name: &str| Some(Term::call(name, operands));
    match (operation, operands) {
        ("negate", [x]) => Some(Term::new(format!("-{}", x.at(Level::Primary)), Level::Unary)),
        ("*" | "/", [x, y]) => Some(Term::joined(x, operation, y, Level::Product)),
        ("+" | "-", [x, y]) => Some(Term::joined(x, operation, y, Level::Sum)),
        ("%", _) => call("fmod"),
        ("dot" | "length" | "normalize", _) => call(operation),
        ("cross" | "reflect", _) if is_own => call(operation),
        ("distance", [x, y]) => {
            let apart = Term::joined(x, "-", y, Level::Sum);
            Some(Term::call("length", &[apart]))
        }
        ("dpdx", _) if is_own => call("Dx"),
        ("dpdy", _) if is_own => call("Dy"),
        // The structs are mixed by one share alone.
        ("mix", _) if !is_own => {
            let is_shared = matches!(types.get(2), Some(ValueType::Scalar(_)));
            if is_shared { call("mix") } else { None }
        }
        _ => {
            let known = if is_own { FUNCTIONS } else { OF_STRUCTS };
            if known.contains(&operation) { call(operation) } else { None }
        }
    }
}

fn vector_among(types: &[ValueType]) -> Option<(usize, Kind)> {
    types.iter().find_map(|ty| match ty {
        ValueType::Vector(count, kind) => Some((*count, *kind)),
        _ => None,
    })
}

/// A function that chooses between two values of a type.
pub(super) fn choice(
    types: &[ValueType],
    operands: &[Term],
    helpers: &mut Helpers,
) -> Option<Term> {
    let [_, ty, _] = types else { return None };
    if matches!(ty, ValueType::Array(..)) {
        return None;
    }
    if *ty == ValueType::Vector(3, Kind::Float) {
        // The language chooses between vectors of its own.
        return scalar("select", Kind::Float, operands);
    }
    let word = Osl.ty(ty);
    let source = format!(
        "{word} choose(int condition, {word} yes, {word} no)\n{{\n    \
         if (condition) {{\n        return yes;\n    }}\n    return no;\n}}\n\n"
    );
    helpers.made.insert(format!("choose {word}"), source);
    Some(Term::call("choose", operands))
}

/// An operation on each component, as a function of vectors of one length.
pub(super) fn by_components(
    operation: &str,
    types: &[ValueType],
    operands: &[Term],
    helpers: &mut Helpers,
) -> Option<Term> {
    let (count, _) = vector_among(types)?;
    let kind_of = |ty: &ValueType| match ty {
        ValueType::Scalar(kind) | ValueType::Vector(_, kind) => *kind,
        _ => Kind::Float,
    };
    let deciding = if operation == "select" { types.get(1)? } else { types.first()? };
    let kind = kind_of(deciding);
    let names = ["x", "y", "z"].get(..operands.len())?;
    if let "all" | "any" = operation {
        return reduction(operation, types.first()?, operands, helpers);
    }
    let places: Vec<Term> = names.iter().map(|name| Term::primary(*name)).collect();
    let body = scalar(operation, kind, &places)?.text;
    let result = ValueType::Vector(count, result_kind(operation, kind));
    let component = |ty: &ValueType, name: &str, index: usize| match ty {
        ValueType::Vector(..) => Osl.part(&Term::primary(name), index, ty).text,
        _ => name.to_owned(),
    };
    let items: Vec<Term> = (0..count)
        .map(|index| {
            let item = rename_identifiers(&body, |word| {
                let at = names.iter().position(|name| *name == word)?;
                Some(component(&types[at], word, index))
            });
            Term::primary(item)
        })
        .collect();
    let mut name = function_of(operation).to_owned();
    // Vectors of integers with and without signs are one type here.
    let is_same = |kind| scalar(operation, kind, &places).is_some_and(|it| it.text == body);
    if kind == Kind::Unsigned && !is_same(Kind::Signed) {
        name += "_unsigned";
    }
    let parameters: Vec<String> =
        types.iter().zip(names).map(|(ty, name)| format!("{} {name}", Osl.ty(ty))).collect();
    let parameters = parameters.join(", ");
    let word = Osl.ty(&result);
    let source = format!(
        "{word} {name}({parameters})\n{{\n    return {};\n}}\n\n",
        Term::call(&word, &items).text
    );
    helpers.made.insert(format!("{name} {parameters}"), source);
    Some(Term::call(&name, operands))
}

/// True if all, or any, components hold.
fn reduction(
    operation: &str,
    ty: &ValueType,
    operands: &[Term],
    helpers: &mut Helpers,
) -> Option<Term> {
    let ValueType::Vector(count, _) = ty else { return None };
    let item = |index: usize| Osl.part(&Term::primary("x"), index, ty).text;
    let items: Vec<String> = (0..*count).map(item).collect();
    let sign = if operation == "all" { " && " } else { " || " };
    let source =
        format!("int {operation}({} x)\n{{\n    return {};\n}}\n\n", Osl.ty(ty), items.join(sign));
    helpers.made.insert(format!("{operation} {}", Osl.ty(ty)), source);
    Some(Term::call(operation, operands))
}

/// Name of the function that runs an operation on each component.
fn function_of(operation: &str) -> &str {
    match operation {
        "+" => "add",
        "-" => "subtract",
        "*" => "multiply",
        "/" => "divide",
        "%" => "remainder",
        "==" => "is_equal",
        "!=" => "is_other",
        "<" => "is_less",
        "<=" => "is_at_most",
        ">" => "is_greater",
        ">=" => "is_at_least",
        "&" | "&&" => "both",
        "|" | "||" => "either",
        "^" => "differing",
        "<<" => "shift_left",
        ">>" => "shift_right",
        "!" | "~" => "opposite",
        "negate" => "negated",
        "dpdx" => "Dx",
        "dpdy" => "Dy",
        "select" => "choose",
        "to_float" => "to_floats",
        "to_signed" | "to_unsigned" | "bits_to_signed" | "bits_to_unsigned" => "to_integers",
        "to_bool" => "to_truths",
        other => other,
    }
}

/// Operations that have to do with matrices, as functions.
pub(super) fn of_matrices(
    operation: &str,
    types: &[ValueType],
    operands: &[Term],
    helpers: &mut Helpers,
) -> Option<Term> {
    let shape = |ty: &ValueType| match ty {
        ValueType::Matrix(columns, rows) => Some((*columns, *rows)),
        _ => None,
    };
    let (columns, rows) = types.iter().find_map(shape)?;
    let column = ValueType::Vector(rows, Kind::Float);
    let words: Vec<String> = types.iter().map(|ty| Osl.ty(ty)).collect();
    let list = |count: usize, write: &dyn Fn(usize) -> String, between: &str| {
        (0..count).map(write).collect::<Vec<_>>().join(between)
    };
    let part = |name: &str, index: usize, count: usize| {
        let ty = ValueType::Vector(count, Kind::Float);
        Osl.part(&Term::primary(name), index, &ty).text
    };
    let product = |matrix: &str, vector: &str| {
        list(columns, &|it| format!("{matrix}.c{it} * {}", part(vector, it, columns)), " + ")
    };
    let first = words.first()?;
    let (name, parameters, result, body) = match operation {
        "transpose" => {
            let result = Osl.ty(&ValueType::Matrix(rows, columns));
            let row = Osl.ty(&ValueType::Vector(columns, Kind::Float));
            let turned = |at: usize| {
                let item = |it: usize| part(&format!("m.c{it}"), at, rows);
                format!("{row}({})", list(columns, &item, ", "))
            };
            let body = format!("{result}({})", list(rows, &turned, ", "));
            ("transpose", format!("{first} m"), result, body)
        }
        "matrix_times_vector" => {
            let parameters = format!("{first} m, {} v", words.get(1)?);
            ("multiply", parameters, Osl.ty(&column), product("m", "v"))
        }
        "vector_times_matrix" => {
            let result = Osl.ty(&ValueType::Vector(columns, Kind::Float));
            let dots = list(columns, &|it| format!("dot(v, m.c{it})"), ", ");
            let parameters = format!("{first} v, {} m", words.get(1)?);
            ("multiply", parameters, result.clone(), format!("{result}({dots})"))
        }
        "matrix_times_matrix" => {
            let (result_columns, _) = shape(types.get(1)?)?;
            let result = Osl.ty(&ValueType::Matrix(result_columns, rows));
            let columns = list(result_columns, &|it| product("a", &format!("b.c{it}")), ", ");
            let parameters = format!("{first} a, {} b", words.get(1)?);
            ("multiply", parameters, result.clone(), format!("{result}({columns})"))
        }
        "matrix_times_scalar" => {
            let body = list(columns, &|it| format!("m.c{it} * x"), ", ");
            ("multiply", format!("{first} m, float x"), first.clone(), format!("{first}({body})"))
        }
        "matrix_plus_matrix" | "matrix_minus_matrix" => {
            let is_sum = operation == "matrix_plus_matrix";
            let (name, sign) = if is_sum { ("add", "+") } else { ("subtract", "-") };
            let body = list(columns, &|it| format!("a.c{it} {sign} b.c{it}"), ", ");
            let parameters = format!("{first} a, {first} b");
            (name, parameters, first.clone(), format!("{first}({body})"))
        }
        _ => return None,
    };
    let source = format!("{result} {name}({parameters})\n{{\n    return {body};\n}}\n\n");
    helpers.made.insert(format!("{name} {parameters}"), source);
    Some(Term::call(name, operands))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_of_vectors_are_those_of_the_language() {
        let (x, y) = (Term::primary("a"), Term::primary("b"));
        let operands = [x, y];
        let mut helpers = Helpers::default();
        let float = |count| ValueType::Vector(count, Kind::Float);
        let mut typed = |operation: &str, ty: ValueType| {
            let types = [ty.clone(), ty];
            Osl.typed(operation, &types, &operands, &mut helpers).map(|term| term.text)
        };
        assert_eq!(typed("*", float(2)).as_deref(), Some("a * b"));
        assert_eq!(typed("distance", float(3)).as_deref(), Some("length(a - b)"));
        assert_eq!(typed("<", float(3)).as_deref(), Some("is_less(a, b)"));
        assert_eq!(
            typed("*", ValueType::Vector(3, Kind::Unsigned)).as_deref(),
            Some("multiply(a, b)")
        );
        let made: Vec<&String> = helpers.made.values().collect();
        assert!(
            made[0].contains("return vector(x[0] < y[0], x[1] < y[1], x[2] < y[2]);"),
            "{made:?}"
        );
    }
}
