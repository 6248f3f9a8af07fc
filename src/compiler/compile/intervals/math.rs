//! WGSL's built-in functions on ranges: exact where they are exact, by the formulas of the
//! specification where it gives some, and no more than what it promises elsewhere.

use naga::{Expression, Handle, MathFunction as Math};

use super::expressions::zip;
use super::machine::{CallFrame, Machine, NoRanges, Outcome, PathState};
use super::range::{Floats, Ints, Length, Range, UNIT_SLACK};

/// The error bound of a card's exp, log, sin and their like, with room to spare.
const RELATIVE: f64 = 1e-4;
const ABSOLUTE: f64 = 1e-3;
/// The greatest number of f32.
const LARGEST: f64 = f32::MAX as f64;

impl Machine<'_> {
    pub(super) fn math(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        handle: Handle<Expression>,
        fun: Math,
        first: Handle<Expression>,
        others: [Option<Handle<Expression>>; 3],
    ) -> Outcome<Vec<Range>> {
        let a = self.value(frame, state, first)?;
        let mut rest = Vec::new();
        for other in others.into_iter().flatten() {
            rest.push(self.value(frame, state, other)?);
        }
        let is_square = others[0] == Some(first);
        if let Some(known) = integers(fun, &a, &rest)? {
            return Ok(known);
        }
        let Some(a) = floats(&a) else { return self.tops(frame, handle) };
        let Some(rest) = rest.iter().map(|b| floats(b)).collect::<Option<Vec<_>>>() else {
            return self.tops(frame, handle);
        };
        let each =
            |of: &dyn Fn(Floats) -> Floats| Ok(a.iter().map(|&x| Range::Float(of(x))).collect());
        if let Some(of) = of_one(fun) {
            return each(&of);
        }
        let rest: Vec<&[Floats]> = rest.iter().map(Vec::as_slice).collect();
        let known = match (fun, rest.as_slice()) {
            (Math::Length, []) => Some(vec![length(&a)]),
            (Math::Normalize, []) => {
                let is_unit = a.iter().all(|x| x.length == Length::One);
                let nan = (!is_unit && length(&a).has(0.0))
                    || a.iter().any(|x| x.nan || x.may_be_infinite());
                let length = if a.len() == 3 && !nan { Length::One } else { Length::Any };
                let one = Floats { length, ..Floats::between(-1.0001, 1.0001) };
                Some(vec![one.with_nan(nan); a.len()])
            }
            (Math::Dot, [b]) => Some(vec![dot(&a, b, is_square)]),
            (Math::Distance, [b]) => {
                let difference: Vec<Floats> = a.iter().zip(*b).map(|(a, b)| a.sub(*b)).collect();
                Some(vec![length(&difference)])
            }
            (Math::Cross, [b]) => cross(&a, b),
            (Math::Clamp, [low, high]) => three(&a, low, high, |x, low, high| x.max(low).min(high)),
            (Math::Mix, [b, t]) => {
                three(&a, b, t, |a, b, t| a.mul(Floats::constant(1.0).sub(t)).add(b.mul(t)))
            }
            (Math::Fma, [b, c]) => three(&a, b, c, |a, b, c| a.mul(b).add(c)),
            (Math::SmoothStep, [high, x]) => three(&a, high, x, smooth_step),
            (Math::Step, [x]) => two(&a, x, step),
            (Math::Pow, [e]) => two(&a, e, power),
            (Math::Min, [b]) => two(&a, b, Floats::min),
            (Math::Max, [b]) => two(&a, b, Floats::max),
            _ => None,
        };
        match known {
            Some(known) => Ok(known.into_iter().map(Range::Float).collect()),
            None => self.tops(frame, handle),
        }
    }
}

/// The floats of ranges that are all of floats.
pub(in crate::compile) fn floats(ranges: &[Range]) -> Option<Vec<Floats>> {
    ranges.iter().map(|x| if let Range::Float(x) = x { Some(*x) } else { None }).collect()
}

/// Abs, min, max and clamp of integers.
fn integers(
    fun: Math,
    a: &[Range],
    rest: &[super::machine::Ranges],
) -> Outcome<Option<Vec<Range>>> {
    if !matches!(a.first(), Some(Range::Int(_))) {
        return Ok(None);
    }
    let by = |of: fn(i64, i64) -> i64| {
        move |a: Range, b: Range| match (a, b) {
            (Range::Int(a), Range::Int(b)) => {
                Ok(Range::Int(Ints::between(of(a.low, b.low), of(a.high, b.high))))
            }
            _ => Err(NoRanges),
        }
    };
    Ok(Some(match (fun, rest) {
        (Math::Min, [b]) => zip(a, b, by(i64::min))?,
        (Math::Max, [b]) => zip(a, b, by(i64::max))?,
        (Math::Clamp, [low, high]) => zip(&zip(a, low, by(i64::max))?, high, by(i64::min))?,
        _ => return Ok(None),
    }))
}

fn of_one(fun: Math) -> Option<fn(Floats) -> Floats> {
    Some(match fun {
        Math::Abs => Floats::abs,
        Math::Saturate => |x| x.max(Floats::ZERO).min(Floats::constant(1.0)),
        Math::Floor => |x| x.rising(f64::floor),
        Math::Ceil => |x| x.rising(f64::ceil),
        Math::Round => |x| x.rising(f64::round_ties_even),
        Math::Trunc => |x| x.rising(f64::trunc),
        Math::Fract => Floats::fract,
        Math::Sign => Floats::sign,
        Math::Sqrt => Floats::sqrt,
        Math::InverseSqrt => |x| Floats::constant(1.0).div(x.sqrt()),
        Math::Radians => |x| x.mul(Floats::constant(std::f64::consts::PI / 180.0)),
        Math::Degrees => |x| x.mul(Floats::constant(180.0 / std::f64::consts::PI)),
        Math::Exp => |x| x.smooth(f64::exp, 1e-2, 0.0, [0.0, f64::INFINITY]),
        Math::Exp2 => |x| x.smooth(f64::exp2, 1e-2, 0.0, [0.0, f64::INFINITY]),
        Math::Log => |x| logarithm(x, f64::ln),
        Math::Log2 => |x| logarithm(x, f64::log2),
        Math::Sin | Math::Cos => {
            |x| Floats::between(-1.001, 1.001).with_nan(x.nan || x.may_be_infinite())
        }
        Math::Tanh => |x| x.smooth(f64::tanh, RELATIVE, ABSOLUTE, [-1.001, 1.001]),
        Math::Atan => |x| x.smooth(f64::atan, RELATIVE, ABSOLUTE, [-1.572, 1.572]),
        Math::Asin | Math::Acos => {
            |x| Floats::between(-3.15, 3.15).with_nan(x.nan || x.low < -1.0 || x.high > 1.0)
        }
        _ => return None,
    })
}

fn logarithm(x: Floats, of: fn(f64) -> f64) -> Floats {
    let nan = x.nan || x.low < 0.0;
    let inside = Floats { low: x.low.max(0.0), ..x };
    if inside.is_none() {
        return Floats { nan: true, ..Floats::ALL };
    }
    // Where a card flushes subnormals it takes them for 0, whose logarithm has no end.
    let inside = if inside.low < f64::from(f32::MIN_POSITIVE) {
        Floats { low: 0.0, ..inside }
    } else {
        inside
    };
    inside.smooth(of, RELATIVE, ABSOLUTE, [f64::NEG_INFINITY, f64::INFINITY]).with_nan(nan)
}

/// `exp2(e * log2(x))`: no less than 0; no more than 1 where the base is not and the exponent does
/// not turn it around.
fn power(x: Floats, e: Floats) -> Floats {
    let nan = x.nan
        || e.nan
        || x.low < 0.0
        || (x.low < f64::from(f32::MIN_POSITIVE) && e.low <= 0.0)
        || x.may_be_infinite()
        || e.may_be_infinite();
    // Rises or falls in both, so that the corners hold the greatest.
    let corners = [x.low.max(0.0), x.high].map(|x| [e.low, e.high].map(|e| x.powf(e)));
    let most = corners.as_flattened().iter().copied().fold(0.0, f64::max);
    let is_known = !nan && most.is_finite() && x.low >= 0.0;
    // A card's logarithm and power: digits are lost with the size of the exponent.
    let most = if is_known { most * 1.01 + 1e-30 } else { f64::INFINITY };
    let most = if most > LARGEST { f64::INFINITY } else { most };
    Floats::between(0.0, most).with_nan(nan)
}

fn step(edge: Floats, x: Floats) -> Floats {
    let nan = edge.nan || x.nan;
    if !nan && x.low >= edge.high {
        return Floats::constant(1.0);
    }
    if !nan && x.high < edge.low {
        return Floats::ZERO;
    }
    Floats::between(0.0, 1.0).with_nan(nan)
}

fn smooth_step(low: Floats, high: Floats, x: Floats) -> Floats {
    let t = x.sub(low).div(high.sub(low)).max(Floats::ZERO).min(Floats::constant(1.0));
    // t t (3 - 2 t) rises from 0 to 1; rounding may pass 1.
    let at = |t: f64| t * t * (3.0 - 2.0 * t);
    if let Some(point) = t.point().filter(|t| *t == 0.0 || *t == 1.0) {
        return Floats { minus_zero: t.minus_zero, ..Floats::between(point, point) };
    }
    let (from, to) = (at(t.low.clamp(0.0, 1.0)), at(t.high.clamp(0.0, 1.0)));
    Floats::between((from - 1e-5).max(0.0), to + 1e-5).with_nan(t.nan)
}

fn dot(a: &[Floats], b: &[Floats], is_square: bool) -> Floats {
    let (of_a, of_b) = (length_of(a), length_of(b));
    if of_a.min(of_b) >= Length::AtMostOne {
        let most = 1.0 + 4.0 * UNIT_SLACK;
        let least = match (is_square, of_a) {
            (true, Length::One) => 2.0 - most,
            (true, _) => 0.0,
            (false, _) => -most,
        };
        return Floats { minus_zero: !is_square, ..Floats::between(least, most) };
    }
    let term = |(a, b): (&Floats, &Floats)| if is_square { a.squared() } else { a.mul(*b) };
    let mut terms = a.iter().zip(b).map(term);
    let first = terms.next().unwrap_or(Floats::ALL);
    terms.fold(first, Floats::add)
}

fn length(a: &[Floats]) -> Floats {
    if let [one] = a {
        return one.abs();
    }
    let most = 1.0 + 2.0 * UNIT_SLACK;
    match length_of(a) {
        Length::One => Floats::between(2.0 - most, most),
        Length::AtMostOne => Floats::between(0.0, most),
        Length::Any => dot(a, a, true).sqrt(),
    }
}

/// Knowledge of the length of a vector of three numbers.
fn length_of(v: &[Floats]) -> Length {
    if v.len() != 3 || v.iter().any(|x| x.nan) {
        return Length::Any;
    }
    v.iter().map(|x| x.length).min().unwrap_or_default()
}

fn cross(a: &[Floats], b: &[Floats]) -> Option<Vec<Floats>> {
    let (&[ax, ay, az], &[bx, by, bz]) = (a, b) else { return None };
    let part = |a: Floats, b: Floats, c: Floats, d: Floats| a.mul(b).sub(c.mul(d));
    Some(vec![part(ay, bz, az, by), part(az, bx, ax, bz), part(ax, by, ay, bx)])
}

fn two(a: &[Floats], b: &[Floats], of: fn(Floats, Floats) -> Floats) -> Option<Vec<Floats>> {
    (a.len() == b.len()).then(|| a.iter().zip(b).map(|(a, b)| of(*a, *b)).collect())
}

/// Component by component; a scalar third argument is repeated.
fn three(
    a: &[Floats],
    b: &[Floats],
    c: &[Floats],
    of: fn(Floats, Floats, Floats) -> Floats,
) -> Option<Vec<Floats>> {
    let third = |index: usize| if c.len() == 1 { c.first() } else { c.get(index) };
    (a.len() == b.len()).then_some(())?;
    a.iter().zip(b).enumerate().map(|(index, (a, b))| Some(of(*a, *b, *third(index)?))).collect()
}
