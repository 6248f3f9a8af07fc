//! Functions of Chiaro's library that guard numbers, or calculate them better than a GPU promises,
//! by what they are in real numbers: hosts of MaterialX calculate as they like.

use super::symbols::Symbol;
use super::terms::{TermId, Terms, Truth};

/// Functions whose result is the change of a value from one pixel to the next. MaterialX does not
/// tell it; without a change edges are as sharp as pixels are.
const FOOTPRINTS: [&str; 6] = [
    "angle_footprint",
    "footprint_of",
    "footprint_by_sum",
    "footprint_of_vec2",
    "footprint_of_vec3",
    "profile_ramped_footprint",
];

/// The result of a function of the library; `None` for those that are followed.
pub(super) fn result_of(terms: &mut Terms, name: &str, arguments: &[Symbol]) -> Option<Symbol> {
    if FOOTPRINTS.contains(&name) {
        return Some(Symbol::Number(terms.number(0.0)));
    }
    match name {
        "is_finite" => return Some(Symbol::Truth(Truth::Known(true))),
        "finite_or" | "finite_vec3" | "finite_vec4" | "bounded" | "bounded_vec2"
        | "bounded_vec3" | "bounded_vec4" => return arguments.first().cloned(),
        _ => {}
    }
    let number = |place: usize| match arguments.get(place) {
        Some(Symbol::Number(id)) => Some(*id),
        _ => None,
    };
    let x = number(0)?;
    Some(Symbol::Number(match name {
        "exp2_stable" => {
            let two = terms.number(2.0);
            terms.each("power", &[two, x])
        }
        "log2_stable" => {
            let (log, scale) = (terms.each("ln", &[x]), terms.number(std::f64::consts::LOG2_E));
            terms.each("multiply", &[log, scale])
        }
        "log_stable" => terms.each("ln", &[x]),
        "log1p_negative" | "log1p_negative_small" => {
            let (one, least) = (terms.number(1.0), terms.number(f64::from(f32::MIN_POSITIVE)));
            let rest = terms.each("subtract", &[one, x]);
            let rest = terms.each("max", &[rest, least]);
            terms.each("ln", &[rest])
        }
        "sin_cos" | "sin_cos_of" | "sin_cos_quarter" | "sin_cos_eighth" | "sin_cos_tiny"
        | "sin_cos_quick" | "sin_cos_short" => {
            let parts = [terms.each("sin", &[x]), terms.each("cos", &[x])];
            terms.combine(&parts)
        }
        "sine_of" | "sine_near" | "sine_low" => terms.each("sin", &[x]),
        "cosine_of" | "cosine_near" | "cosine_low" => terms.each("cos", &[x]),
        "atan2_positive" => terms.each("atan2", &[x, number(1)?]),
        "normalize_seen" | "normalize_seen_balanced" => terms.unit(x),
        "normalize_or" | "normalize_quick" | "normalize_moderate" => unit_or(terms, x, number(1)?),
        _ => return None,
    }))
}

/// A vector at length 1, or another where it has no length.
fn unit_or(terms: &mut Terms, vector: TermId, otherwise: TermId) -> TermId {
    let unit = terms.unit(vector);
    // Of these it is known that they have a length.
    let is_sure =
        unit == vector || terms.term(unit).origin != super::terms::Origin::Node("normalize");
    if is_sure {
        return unit;
    }
    let (square, least) = (terms.node("dotproduct", &[vector, vector], 1), terms.number(1e-30));
    let has_length = terms.test("ifgreater", square, least);
    terms.choose(&has_length, unit, otherwise)
}
