//! The range of one scalar.

use crate::interp;

const LARGEST: f64 = f32::MAX as f64;
/// The greatest f64 that rounds to the greatest f32.
pub(super) const ALMOST_INFINITE: f64 = 3.402_823_567_797_336_6e38;
const SMALLEST_NORMAL: f64 = f32::MIN_POSITIVE as f64;

/// The range of a float: a closed interval, with flags for NaN and -0.
///
/// An infinite bound means that the infinity itself is possible. Where no number is possible, only
/// NaN, `low` is above `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::compile) struct Floats {
    pub(in crate::compile) low: f64,
    pub(in crate::compile) high: f64,
    /// True if NaN is possible.
    pub(in crate::compile) nan: bool,
    /// True if a zero in the range may be -0.
    pub(in crate::compile) minus_zero: bool,
    /// Knowledge of the length of the vector that the number is a component of, together with
    /// those beside it. There is none once it is taken out of its vector.
    pub(in crate::compile) length: Length,
}

impl Floats {
    /// Anything.
    pub(super) const ALL: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
        nan: true,
        minus_zero: true,
        length: Length::Any,
    };
    pub(super) const ZERO: Self =
        Self { low: 0.0, high: 0.0, nan: false, minus_zero: false, length: Length::Any };
    /// No number at all.
    const NONE: Self = Self {
        low: f64::INFINITY,
        high: f64::NEG_INFINITY,
        nan: false,
        minus_zero: false,
        length: Length::Any,
    };

    /// Numbers between two bounds; a zero has both signs.
    pub(super) fn between(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            nan: false,
            minus_zero: low <= 0.0 && high >= 0.0 && low < high && low < 0.0,
            length: Length::Any,
        }
    }

    pub(super) fn with_nan(self, nan: bool) -> Self {
        Self { nan: self.nan || nan, ..self }
    }

    /// A number as a document has it: in f64, or rounded to f32 as a shader reads it.
    pub(super) fn constant(x: f64) -> Self {
        if x.is_nan() {
            return Self { nan: true, ..Self::NONE };
        }
        let single = f64::from(x as f32);
        let is_negative = x.is_sign_negative();
        let range = Self {
            low: x.min(single),
            high: x.max(single),
            nan: false,
            minus_zero: x == 0.0 && is_negative,
            length: Length::Any,
        };
        // A graphics card may take a subnormal for 0.
        if x != 0.0 && x.abs() < SMALLEST_NORMAL {
            return Self {
                low: range.low.min(0.0),
                high: range.high.max(0.0),
                minus_zero: is_negative,
                ..range
            };
        }
        range
    }

    /// True if no number is possible.
    pub(in crate::compile) fn is_none(self) -> bool {
        self.low > self.high
    }

    /// The only possible number, if there is just one and no NaN; -0 counts as 0.
    pub(in crate::compile) fn point(self) -> Option<f64> {
        (self.low == self.high && !self.nan && self.low.is_finite()).then_some(self.low)
    }

    pub(super) fn has(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    pub(super) fn may_be_infinite(self) -> bool {
        self.low == f64::NEG_INFINITY || self.high == f64::INFINITY
    }

    /// True if every possible value is a number from `low` to `high`, never NaN.
    pub(in crate::compile) fn is_within(self, low: f64, high: f64) -> bool {
        !self.nan && !self.is_none() && low <= self.low && self.high <= high
    }

    /// Never below 0, nor -0.
    pub(in crate::compile) fn is_positive(self) -> bool {
        self.low >= 0.0 && !self.minus_zero
    }

    pub(super) fn join(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            nan: self.nan || other.nan,
            minus_zero: self.minus_zero || other.minus_zero,
            length: self.length.min(other.length),
        }
    }

    /// The intersection of two ranges.
    pub(super) fn meet(self, other: Self) -> Self {
        Self {
            low: self.low.max(other.low),
            high: self.high.min(other.high),
            nan: self.nan && other.nan,
            minus_zero: self.minus_zero,
            length: self.length,
        }
    }
}

/// The bounds of a result that was computed in f64: as they are where they are exact and f32 can
/// hold them, else outward by `steps` of f32, which covers rounding either way and what WGSL allows
/// an operation to be off.
pub(super) fn outward(low: (f64, bool), high: (f64, bool), steps: u32) -> Floats {
    let low = lower(low, steps);
    let high = upper(high, steps);
    // Results that are not normal may be flushed to 0.
    let low = if low > 0.0 && low < SMALLEST_NORMAL { 0.0 } else { low };
    let high = if high < 0.0 && high > -SMALLEST_NORMAL { 0.0 } else { high };
    let minus_zero = low < 0.0 && high >= 0.0;
    Floats { low: low + 0.0, high: high + 0.0, nan: false, minus_zero, length: Length::Any }
}

fn lower((x, is_exact): (f64, bool), steps: u32) -> f64 {
    if x.is_nan() || x < -ALMOST_INFINITE {
        return f64::NEG_INFINITY;
    }
    if x < -LARGEST {
        return -ALMOST_INFINITE;
    }
    if x > LARGEST {
        return if is_exact && x == f64::INFINITY { x } else { LARGEST };
    }
    let mut single = x as f32;
    if f64::from(single) == x && is_exact {
        return x;
    }
    // The greatest f32 that what was rounded to x cannot lie below; any rounding ends there.
    if f64::from(single) >= x {
        single = single.next_down();
    }
    for _ in 1..steps {
        single = single.next_down();
    }
    f64::from(single)
}

fn upper((x, is_exact): (f64, bool), steps: u32) -> f64 {
    -lower((-x, is_exact), steps)
}

/// The range of an integer, signed or unsigned, by its own numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::compile) struct Ints {
    pub(super) low: i64,
    pub(super) high: i64,
    /// The lower 31 bits, as a number: what is known of a float's size from its bits alone.
    pub(super) magnitude: [i64; 2],
}

const ALL_MAGNITUDES: [i64; 2] = [0, 0x7fff_ffff];

impl Ints {
    pub(super) fn between(low: i64, high: i64) -> Self {
        let is_plain = 0 <= low && high <= ALL_MAGNITUDES[1];
        Self { low, high, magnitude: if is_plain { [low, high] } else { ALL_MAGNITUDES } }
    }

    /// Anything of a type.
    pub(super) fn all(is_signed: bool) -> Self {
        if is_signed {
            Self::between(i32::MIN.into(), i32::MAX.into())
        } else {
            Self::between(0, u32::MAX.into())
        }
    }

    /// `low` to `high` where the type can hold both, else anything: integers wrap around.
    pub(super) fn wrapped(low: i64, high: i64, is_signed: bool) -> Self {
        let all = Self::all(is_signed);
        if all.low <= low && high <= all.high { Self::between(low, high) } else { all }
    }

    pub(super) fn point(self) -> Option<i64> {
        (self.low == self.high).then_some(self.low)
    }

    pub(super) fn join(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            magnitude: [
                self.magnitude[0].min(other.magnitude[0]),
                self.magnitude[1].max(other.magnitude[1]),
            ],
        }
    }
}

/// The range of a truth value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::compile) struct Bools {
    pub(super) may_be_false: bool,
    pub(super) may_be_true: bool,
}

impl Bools {
    pub(super) const ALL: Self = Self { may_be_false: true, may_be_true: true };

    pub(super) fn of(x: bool) -> Self {
        Self { may_be_false: !x, may_be_true: x }
    }

    pub(super) fn not(self) -> Self {
        Self { may_be_false: self.may_be_true, may_be_true: self.may_be_false }
    }

    pub(super) fn point(self) -> Option<bool> {
        match (self.may_be_false, self.may_be_true) {
            (true, false) => Some(false),
            (false, true) => Some(true),
            _ => None,
        }
    }
}

/// The range of a scalar of any kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::compile) enum Range {
    Float(Floats),
    Int(Ints),
    Bool(Bools),
}

impl Range {
    /// The number 0.
    pub(in crate::compile) const ZERO: Self = Self::Float(Floats::ZERO);

    pub(super) fn join(self, other: Self) -> Option<Self> {
        Some(match (self, other) {
            (Self::Float(a), Self::Float(b)) => Self::Float(a.join(b)),
            (Self::Int(a), Self::Int(b)) => Self::Int(a.join(b)),
            (Self::Bool(a), Self::Bool(b)) => Self::Bool(Bools {
                may_be_false: a.may_be_false || b.may_be_false,
                may_be_true: a.may_be_true || b.may_be_true,
            }),
            _ => return None,
        })
    }

    /// The range that holds one known scalar alone.
    pub(super) fn of_scalar(scalar: interp::Scalar) -> Self {
        match scalar {
            interp::Scalar::Bool(x) => Self::Bool(Bools::of(x)),
            interp::Scalar::I32(x) => Self::Int(Ints::between(x.into(), x.into())),
            interp::Scalar::U32(x) => Self::Int(Ints::between(x.into(), x.into())),
            interp::Scalar::Float(x) => Self::Float(Floats::constant(x)),
        }
    }

    /// Ranges of all other values of the kind of `scalar`.
    pub(super) fn any_like(scalar: interp::Scalar) -> Self {
        match scalar {
            interp::Scalar::Bool(_) => Self::Bool(Bools::ALL),
            interp::Scalar::I32(_) => Self::Int(Ints::all(true)),
            interp::Scalar::U32(_) => Self::Int(Ints::all(false)),
            interp::Scalar::Float(_) => Self::Float(Floats::ALL),
        }
    }

    /// Bounds of all possible numbers; `None` if NaN is possible or no number is. A truth value
    /// counts as 0 or 1.
    pub(in crate::compile) fn bounds(self) -> Option<[f64; 2]> {
        match self {
            Self::Float(x) if x.nan || x.is_none() => None,
            Self::Float(x) => Some([x.low, x.high]),
            Self::Int(x) => Some([x.low as f64, x.high as f64]),
            Self::Bool(x) => {
                Some([f64::from(u8::from(!x.may_be_false)), f64::from(u8::from(x.may_be_true))])
            }
        }
    }

    /// True if every possible number lies from `low` to `high`. NaN lies nowhere and is allowed.
    pub(in crate::compile) fn is_number_within(self, low: f64, high: f64) -> bool {
        match self {
            Self::Float(x) => Floats { nan: false, ..x }.is_within(low, high),
            other => other.bounds().is_some_and(|[least, most]| low <= least && most <= high),
        }
    }

    /// The range of a component that is taken out of its vector.
    pub(super) fn alone(self) -> Self {
        match self {
            Self::Float(x) => Self::Float(Floats { length: Length::Any, ..x }),
            other => other,
        }
    }

    /// The range of a float that is made a finite number of f32, 0 in the place of NaN.
    pub(super) fn finite(self) -> Self {
        let Self::Float(x) = self else { return self };
        if x.is_none() {
            return if x.nan { Self::ZERO } else { self };
        }
        let low = x.low.clamp(-LARGEST, LARGEST);
        let numbers = Floats { low, high: x.high.clamp(-LARGEST, LARGEST), nan: false, ..x };
        Self::Float(if x.nan { numbers.join(Floats::ZERO) } else { numbers })
    }

    /// The range cut to [0, 1], where its numbers lie there for another reason.
    pub(in crate::compile) fn within_unit(self) -> Self {
        match self {
            Self::Float(x) => {
                let met = x.meet(Floats { minus_zero: x.minus_zero, ..Floats::between(0.0, 1.0) });
                Self::Float(if met.is_none() { x } else { met })
            }
            other => other,
        }
    }

    /// The only possible truth value, if there is just one.
    pub(in crate::compile) fn truth(self) -> Option<bool> {
        if let Self::Bool(x) = self { x.point() } else { None }
    }

    /// The only possible integer, if there is just one.
    pub(in crate::compile) fn whole(self) -> Option<i64> {
        if let Self::Int(x) = self { x.point() } else { None }
    }

    /// Told apart from any other range, for tables.
    pub(super) fn bits(self) -> [u64; 3] {
        match self {
            Self::Float(x) => {
                let flags =
                    u64::from(x.nan) | u64::from(x.minus_zero) << 1 | (x.length as u64) << 3;
                [x.low.to_bits(), x.high.to_bits(), flags]
            }
            Self::Int(x) => {
                let [least, most] = x.magnitude.map(|m| m as u64 & 0x7fff_ffff);
                [x.low as u64, x.high as u64, 4 | least << 3 | most << 34]
            }
            Self::Bool(x) => [u64::from(x.may_be_false), u64::from(x.may_be_true), u64::MAX],
        }
    }

    /// The only possible value, exact to the bit, if there is just one.
    pub(in crate::compile) fn exactly(self) -> Option<interp::Scalar> {
        match self {
            Self::Float(x) => {
                let point = x.point()?;
                let is_single = f64::from(point as f32) == point;
                (is_single && !(point == 0.0 && x.minus_zero))
                    .then_some(interp::Scalar::Float(point))
            }
            Self::Int(x) => x.point().and_then(|x| i32::try_from(x).ok()).map(interp::Scalar::I32),
            Self::Bool(x) => x.point().map(interp::Scalar::Bool),
        }
    }

    /// True if the range contains a scalar of a result. For tests.
    #[cfg(test)]
    pub(super) fn contains(self, scalar: interp::Scalar) -> bool {
        match (self, scalar) {
            (Self::Float(range), interp::Scalar::Float(x)) => {
                if x.is_nan() {
                    return range.nan;
                }
                range.has(x) && (x != 0.0 || x.is_sign_positive() || range.minus_zero)
            }
            (Self::Int(range), interp::Scalar::I32(x)) => {
                (range.low..=range.high).contains(&x.into())
            }
            (Self::Int(range), interp::Scalar::U32(x)) => {
                (range.low..=range.high).contains(&x.into())
            }
            (Self::Bool(range), interp::Scalar::Bool(x)) => {
                if x {
                    range.may_be_true
                } else {
                    range.may_be_false
                }
            }
            _ => false,
        }
    }
}

/// Vectors of three numbers that are known, with what is known of their length.
pub(super) fn with_length(ranges: Vec<Range>) -> Vec<Range> {
    let [Range::Float(x), Range::Float(y), Range::Float(z)] = ranges.as_slice() else {
        return ranges;
    };
    let middle = |x: &Floats| (!x.nan && x.high - x.low < 1e-6).then_some(0.5 * (x.low + x.high));
    let (Some(a), Some(b), Some(c)) = (middle(x), middle(y), middle(z)) else { return ranges };
    let known = (a * a + b * b + c * c).sqrt();
    let length = if (known - 1.0).abs() <= UNIT_SLACK {
        Length::One
    } else if known < 1.0 {
        Length::AtMostOne
    } else {
        return ranges;
    };
    [x, y, z].map(|x| Range::Float(Floats { length, ..*x })).to_vec()
}

/// Knowledge of the length of a vector, but for rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::compile) enum Length {
    /// Nothing.
    #[default]
    Any,
    /// 1 or less.
    AtMostOne,
    /// 1.
    One,
}

/// The most by which the length of a unit vector may be off.
pub(super) const UNIT_SLACK: f64 = 2e-6;
