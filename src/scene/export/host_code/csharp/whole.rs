//! Operations on whole vectors and matrices.

use super::super::dialect::{Dialect as _, Helpers, Kind, Level, Term, ValueType};
use super::CSharp;
use super::types::AXES;

/// An operation that the structs have as an operator; `None` for others.
pub(super) fn operator(operation: &str, types: &[ValueType], operands: &[Term]) -> Option<Term> {
    let vector = types.iter().find(|ty| matches!(ty, ValueType::Vector(..)))?;
    let ValueType::Vector(_, kind) = vector else { return None };
    if *kind == Kind::Bool || types.iter().any(|ty| matches!(ty, ValueType::Matrix(..))) {
        return None;
    }
    if let ([x], "negate") = (operands, operation) {
        return Some(Term::new(format!("-{}", x.at(Level::Primary)), Level::Unary));
    }
    let ([x, y], [a, b]) = (operands, types) else { return None };
    let level = match operation {
        "*" => Level::Product,
        "/" if *kind == Kind::Float => Level::Product,
        "+" | "-" => Level::Sum,
        _ => return None,
    };
    // The structs are multiplied with numbers as they are, and divided by them.
    let takes_number = |is_left: bool| operation == "*" || (operation == "/" && !is_left);
    let operand = |term: &Term, ty: &ValueType, is_left: bool| match ty {
        ValueType::Scalar(_) if !takes_number(is_left) => {
            Term::primary(format!("new {}({})", CSharp.ty(vector), term.text))
        }
        _ => term.clone(),
    };
    Some(Term::joined(&operand(x, a, true), operation, &operand(y, b, false), level))
}

/// A function of whole vectors and matrices, declared for these types; `None` for operations on
/// components.
pub(super) fn function(
    operation: &str,
    types: &[ValueType],
    operands: &[Term],
    helpers: &mut Helpers,
) -> Option<Term> {
    let (name, source) = source(operation, types, helpers)?;
    helpers.made.insert(format!("{name} {types:?}"), source);
    Some(Term::call(name, operands))
}

/// Declares a function that another calls.
fn need(operation: &str, types: &[ValueType], helpers: &mut Helpers) -> Option<()> {
    function(operation, types, &[], helpers).map(|_| ())
}

fn source(
    operation: &str,
    types: &[ValueType],
    helpers: &mut Helpers,
) -> Option<(&'static str, String)> {
    let [first, ..] = types else { return None };
    let ty = CSharp.ty(first);
    match first {
        ValueType::Matrix(..) => matrix(operation, types, helpers),
        ValueType::Vector(..) if operation == "vector_times_matrix" => {
            matrix(operation, types, helpers)
        }
        ValueType::Vector(count, kind) => {
            let axes = &AXES[..*count];
            let each = |write: &dyn Fn(&str) -> String, between: &str| {
                axes.iter().map(|axis| write(axis)).collect::<Vec<_>>().join(between)
            };
            let word = super::types::word(*kind);
            let pair = [first.clone(), first.clone()];
            Some(match operation {
                "dot" => (
                    "Dot",
                    format!(
                        "static {word} Dot({ty} a, {ty} b) => {};\n",
                        each(&|axis| format!("a.{axis} * b.{axis}"), " + ")
                    ),
                ),
                "cross" => (
                    "Cross",
                    format!(
                        "static {ty} Cross({ty} a, {ty} b) => new {ty}(\n    \
                         a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);\n"
                    ),
                ),
                "length" => {
                    need("dot", &pair, helpers)?;
                    ("Length", format!("static double Length({ty} a) => Math.Sqrt(Dot(a, a));\n"))
                }
                "distance" => {
                    need("length", &pair[..1], helpers)?;
                    (
                        "Distance",
                        format!("static double Distance({ty} a, {ty} b) => Length(a - b);\n"),
                    )
                }
                "normalize" => {
                    need("length", &pair[..1], helpers)?;
                    ("Normalize", format!("static {ty} Normalize({ty} a) => a / Length(a);\n"))
                }
                "reflect" => {
                    need("dot", &pair, helpers)?;
                    (
                        "Reflect",
                        format!(
                            "static {ty} Reflect({ty} a, {ty} n) => a - 2.0 * Dot(n, a) * n;\n"
                        ),
                    )
                }
                "all" => (
                    "All",
                    format!(
                        "static bool All({ty} a) => {};\n",
                        each(&|it| format!("a.{it}"), " && ")
                    ),
                ),
                "any" => (
                    "Any",
                    format!(
                        "static bool Any({ty} a) => {};\n",
                        each(&|it| format!("a.{it}"), " || ")
                    ),
                ),
                _ => return None,
            })
        }
        _ => None,
    }
}

/// Functions that have to do with matrices.
fn matrix(
    operation: &str,
    types: &[ValueType],
    helpers: &mut Helpers,
) -> Option<(&'static str, String)> {
    let names: Vec<String> = types.iter().map(|ty| CSharp.ty(ty)).collect();
    let columns_of = |ty: &ValueType| match ty {
        ValueType::Matrix(columns, rows) => Some((*columns, *rows)),
        _ => None,
    };
    let list = |count: usize, write: &dyn Fn(usize) -> String, between: &str| {
        (0..count).map(write).collect::<Vec<_>>().join(between)
    };
    let ty = names.first()?;
    let (columns, rows) = types.iter().find_map(columns_of)?;
    let column = ValueType::Vector(rows, Kind::Float);
    Some(match operation {
        "transpose" => {
            let result = CSharp.ty(&ValueType::Matrix(rows, columns));
            let turned = |row: usize| {
                let items = list(columns, &|it| format!("m.c{it}.{}", AXES[row]), ", ");
                format!("new Double{columns}({items})")
            };
            (
                "Transpose",
                format!(
                    "static {result} Transpose({ty} m) => new {result}(\n    {});\n",
                    list(rows, &turned, ",\n    ")
                ),
            )
        }
        "matrix_times_vector" => (
            "Multiply",
            format!(
                "static {} Multiply({ty} m, {} v) =>\n    {};\n",
                CSharp.ty(&column),
                names.get(1)?,
                list(columns, &|it| format!("m.c{it} * v.{}", AXES[it]), " + ")
            ),
        ),
        "vector_times_matrix" => {
            need("dot", &[column.clone(), column.clone()], helpers)?;
            let result = CSharp.ty(&ValueType::Vector(columns, Kind::Float));
            (
                "Multiply",
                format!(
                    "static {result} Multiply({ty} v, {} m) =>\n    new {result}({});\n",
                    names.get(1)?,
                    list(columns, &|it| format!("Dot(v, m.c{it})"), ", ")
                ),
            )
        }
        "matrix_times_matrix" => {
            let (result_columns, inner) = columns_of(types.get(1)?)?;
            let vector = ValueType::Vector(inner, Kind::Float);
            need("matrix_times_vector", &[types[0].clone(), vector], helpers)?;
            let result = CSharp.ty(&ValueType::Matrix(result_columns, rows));
            (
                "Multiply",
                format!(
                    "static {result} Multiply({ty} a, {} b) =>\n    new {result}({});\n",
                    names.get(1)?,
                    list(result_columns, &|it| format!("Multiply(a, b.c{it})"), ", ")
                ),
            )
        }
        "matrix_times_scalar" => (
            "Multiply",
            format!(
                "static {ty} Multiply({ty} m, double x) => new {ty}({});\n",
                list(columns, &|it| format!("m.c{it} * x"), ", ")
            ),
        ),
        "matrix_plus_matrix" | "matrix_minus_matrix" => {
            let (name, sign) =
                if operation == "matrix_plus_matrix" { ("Add", "+") } else { ("Subtract", "-") };
            (
                name,
                format!(
                    "static {ty} {name}({ty} a, {ty} b) => new {ty}({});\n",
                    list(columns, &|it| format!("a.c{it} {sign} b.c{it}"), ", ")
                ),
            )
        }
        _ => return None,
    })
}
