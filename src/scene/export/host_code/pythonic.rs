//! Operations as Python writes them, and GDScript after it: words for `and`, `or` and `not`, and
//! integers that are wider than 32 bits.

use super::dialect::{Helpers, Kind, Level, Term};

/// The term within 32 bits.
pub(super) fn within(term: Term, kind: Kind, helpers: &mut Helpers) -> Term {
    match kind {
        Kind::Signed => helpers.call("wrap_i32", &[term]),
        Kind::Unsigned => Term::new(format!("{} & 0xffffffff", term.at(Level::Unary)), Level::Bits),
        Kind::Float | Kind::Bool => term,
    }
}

/// An operator, but for division of floats and shifts, which the languages write in their own ways.
pub(super) fn operator(
    operation: &str,
    kind: Kind,
    operands: &[Term],
    helpers: &mut Helpers,
) -> Option<Term> {
    if let [x] = operands {
        return Some(match (operation, kind) {
            ("negate", _) => {
                let term = Term::new(format!("-{}", x.at(Level::Primary)), Level::Unary);
                within(term, kind, helpers)
            }
            ("!", _) => Term::new(format!("not {}", x.at(Level::Comparison)), Level::And),
            ("~", Kind::Unsigned) => {
                Term::new(format!("{} ^ 0xffffffff", x.at(Level::Unary)), Level::Bits)
            }
            ("~", _) => Term::new(format!("~{}", x.at(Level::Primary)), Level::Unary),
            _ => return None,
        });
    }
    let [x, y] = operands else { return None };
    Some(match (operation, kind) {
        ("*", _) => within(Term::joined(x, "*", y, Level::Product), kind, helpers),
        ("+" | "-", _) => within(Term::joined(x, operation, y, Level::Sum), kind, helpers),
        ("/", Kind::Signed | Kind::Unsigned) => helpers.call("divide_whole", operands),
        ("%", Kind::Signed | Kind::Unsigned) => helpers.call("remainder_whole", operands),
        ("==" | "!=" | "<" | "<=" | ">" | ">=", _) => {
            Term::joined(x, operation, y, Level::Comparison)
        }
        ("&" | "&&", Kind::Bool) | ("&&", _) => Term::joined(x, "and", y, Level::And),
        ("|" | "||", Kind::Bool) | ("||", _) => Term::joined(x, "or", y, Level::Or),
        ("^", Kind::Bool) => Term::joined(x, "!=", y, Level::Comparison),
        ("&" | "|" | "^", _) => Term::joined(x, operation, y, Level::Bits),
        _ => return None,
    })
}

/// A conversion. `zero` is the language's zero of the kind, for what is a truth value after it.
pub(super) fn conversion(
    operation: &str,
    kind: Kind,
    operands: &[Term],
    zero: &str,
    helpers: &mut Helpers,
) -> Option<Term> {
    let [x] = operands else { return None };
    Some(match (operation, kind) {
        ("to_float" | "bits_to_float", Kind::Float) => x.clone(),
        ("to_float", _) => Term::call("float", operands),
        ("to_signed", Kind::Float) => helpers.call("to_i32", operands),
        ("to_unsigned", Kind::Float) => helpers.call("to_u32", operands),
        ("to_signed" | "to_unsigned", Kind::Bool) => Term::call("int", operands),
        ("to_bool", Kind::Bool) => x.clone(),
        ("to_bool", _) => Term::joined(x, "!=", &Term::primary(zero), Level::Comparison),
        ("bits_to_float", _) => helpers.call("float_of_bits", operands),
        ("bits_to_unsigned", Kind::Float) => helpers.call("bits_of_float", operands),
        ("bits_to_signed", Kind::Float) => {
            let bits = helpers.call("bits_of_float", operands);
            helpers.call("wrap_i32", &[bits])
        }
        ("to_signed" | "bits_to_signed", _) => within(x.clone(), Kind::Signed, helpers),
        ("to_unsigned" | "bits_to_unsigned", _) => within(x.clone(), Kind::Unsigned, helpers),
        _ => return None,
    })
}

/// A choice between two values by a condition; `None` without these three.
pub(super) fn select(operands: &[Term]) -> Option<Term> {
    let [condition, yes, no] = operands else { return None };
    let (condition, yes, no) = (condition.at(Level::Or), yes.at(Level::Or), no.at(Level::Choice));
    Some(Term::new(format!("{yes} if {condition} else {no}"), Level::Choice))
}
