//! Arithmetic on what floats may be. Every result holds for f32 rounded either way, for f64, and
//! for cards that flush subnormal results to 0.

use super::range::{Floats, Length, outward};

/// Steps of f32 that a correctly rounded operation may be off when rounding is free to go either
/// way.
const ROUNDED: u32 = 1;
/// WGSL grants division and roots 2.5 steps.
const LOOSE: u32 = 4;

impl Floats {
    pub(super) fn add(self, other: Self) -> Self {
        let sum = |a: f64, b: f64| {
            let s = a + b;
            // The two-sum of Knuth: what the sum lost.
            let part = s - a;
            (s, s.is_infinite() || (a - (s - part)) + (b - part) == 0.0)
        };
        let meets = |a: f64, b: f64| a.is_infinite() && b.is_infinite() && a != b;
        let nan =
            self.nan || other.nan || meets(self.low, other.high) || meets(self.high, other.low);
        if self.is_none() || other.is_none() {
            return none(nan);
        }
        let low = if meets(self.low, other.low) {
            (f64::NEG_INFINITY, true)
        } else {
            sum(self.low, other.low)
        };
        let high = if meets(self.high, other.high) {
            (f64::INFINITY, true)
        } else {
            sum(self.high, other.high)
        };
        let mut result = outward(low, high, ROUNDED);
        result.minus_zero |= self.minus_zero && other.minus_zero;
        result.with_nan(nan)
    }

    pub(super) fn neg(self) -> Self {
        if self.is_none() {
            return self;
        }
        Self {
            low: -self.high + 0.0,
            high: -self.low + 0.0,
            nan: self.nan,
            minus_zero: self.has(0.0),
            length: self.length,
        }
    }

    pub(super) fn sub(self, other: Self) -> Self {
        self.add(other.neg())
    }

    pub(super) fn mul(self, other: Self) -> Self {
        let nan = self.nan
            || other.nan
            || (self.has(0.0) && other.may_be_infinite())
            || (other.has(0.0) && self.may_be_infinite());
        if self.is_none() || other.is_none() {
            return none(nan);
        }
        let product = |a: f64, b: f64| {
            if a == 0.0 || b == 0.0 {
                return (0.0, true);
            }
            let p = a * b;
            (p, p.is_infinite() && (a.is_infinite() || b.is_infinite()) || a.mul_add(b, -p) == 0.0)
        };
        let corners = [
            product(self.low, other.low),
            product(self.low, other.high),
            product(self.high, other.low),
            product(self.high, other.high),
        ];
        let mut result = from_corners(&corners, ROUNDED);
        result.minus_zero = result.has(0.0) && !(self.is_positive() && other.is_positive());
        result.with_nan(nan)
    }

    /// x times x.
    pub(super) fn squared(self) -> Self {
        let mut size = self.abs().mul(self.abs());
        size.minus_zero = false;
        // The corners are those of the size, and 0 times infinity does not occur.
        size.nan = self.nan;
        size
    }

    pub(super) fn div(self, other: Self) -> Self {
        let nan = self.nan
            || other.nan
            || (self.has(0.0) && other.has(0.0))
            || (self.may_be_infinite() && other.may_be_infinite());
        if self.is_none() || other.is_none() {
            return none(nan);
        }
        // Where a divisor may be subnormal, it may be taken for 0.
        if other.low < f64::from(f32::MIN_POSITIVE) && other.high > -f64::from(f32::MIN_POSITIVE) {
            return quotient_by_zero(self, other, nan);
        }
        let quotient = |a: f64, b: f64| {
            if a.is_infinite() && b.is_infinite() {
                // The limits are told by the other corners and by 0 and infinity.
                return (
                    if (a > 0.0) == (b > 0.0) { f64::INFINITY } else { f64::NEG_INFINITY },
                    false,
                );
            }
            let q = a / b;
            (q, q.is_infinite() || b.is_infinite() || q.mul_add(b, -a) == 0.0)
        };
        let corners = [
            quotient(self.low, other.low),
            quotient(self.low, other.high),
            quotient(self.high, other.low),
            quotient(self.high, other.high),
        ];
        let mut result = from_corners(&corners, LOOSE);
        if self.may_be_infinite() && other.may_be_infinite() {
            result = result.join(Self::ZERO);
        }
        result.minus_zero = result.has(0.0) && !(self.is_positive() && other.low > 0.0);
        result.with_nan(nan)
    }

    pub(super) fn abs(self) -> Self {
        if self.is_none() {
            return self;
        }
        let low = if self.has(0.0) { 0.0 } else { self.low.abs().min(self.high.abs()) };
        Self {
            low,
            high: self.low.abs().max(self.high.abs()),
            nan: self.nan,
            minus_zero: false,
            length: Length::Any,
        }
    }

    pub(super) fn min(self, other: Self) -> Self {
        self.pick(other, f64::min)
    }

    pub(super) fn max(self, other: Self) -> Self {
        self.pick(other, f64::max)
    }

    /// The smaller or the larger; which of two numbers a NaN leaves is open.
    fn pick(self, other: Self, of: fn(f64, f64) -> f64) -> Self {
        let nan = self.nan || other.nan;
        if self.is_none() || other.is_none() {
            return self.join(other).with_nan(nan);
        }
        let mut result = Self {
            low: of(self.low, other.low),
            high: of(self.high, other.high),
            nan,
            minus_zero: self.minus_zero || other.minus_zero,
            length: Length::Any,
        };
        if self.nan {
            result = result.join(other);
        }
        if other.nan {
            result = result.join(self);
        }
        result.with_nan(nan)
    }

    /// A function that never falls and that every number survives exactly: floor, round and their
    /// like.
    pub(super) fn rising(self, f: fn(f64) -> f64) -> Self {
        if self.is_none() {
            return self;
        }
        let (low, high) = (f(self.low), f(self.high));
        Self {
            low: low + 0.0,
            high: high + 0.0,
            nan: self.nan,
            minus_zero: self.minus_zero || self.low < 0.0,
            length: Length::Any,
        }
    }

    /// x - floor(x): rounding may make it 1.
    pub(super) fn fract(self) -> Self {
        let whole = self.low.floor();
        if !self.is_none() && whole.is_finite() && whole == self.high.floor() {
            return self.sub(Self::between(whole, whole));
        }
        Self {
            low: 0.0,
            high: 1.0,
            nan: self.nan || self.may_be_infinite(),
            minus_zero: false,
            length: Length::Any,
        }
    }

    pub(super) fn sign(self) -> Self {
        self.rising(|x| if x == 0.0 { 0.0 } else { x.signum() })
    }

    pub(super) fn sqrt(self) -> Self {
        let nan = self.nan || self.low < 0.0;
        if self.is_none() || self.high < 0.0 {
            return none(nan);
        }
        let root = |x: f64| {
            let r = x.max(0.0).sqrt();
            (r, r.is_infinite() || r.mul_add(r, -x) == 0.0)
        };
        let (low, high) = (root(self.low), root(self.high));
        let mut result = outward(low, high, LOOSE);
        result.low = result.low.max(0.0);
        result.minus_zero = self.minus_zero;
        result.with_nan(nan)
    }

    /// A function that never falls, known to a relative error and an absolute one, and no further
    /// than `limits`.
    pub(super) fn smooth(
        self,
        f: fn(f64) -> f64,
        relative: f64,
        absolute: f64,
        limits: [f64; 2],
    ) -> Self {
        if self.is_none() {
            return self;
        }
        let off = |y: f64| y.abs() * relative + absolute;
        let (low, high) = (f(self.low), f(self.high));
        let low = if low.is_finite() { low - off(low) } else { low };
        let high = if high.is_finite() { high + off(high) } else { high };
        let result = outward((low.max(limits[0]), false), (high.min(limits[1]), false), ROUNDED);
        Self {
            low: result.low.max(limits[0]),
            high: result.high.min(limits[1]),
            nan: self.nan,
            minus_zero: true,
            length: Length::Any,
        }
    }
}

fn none(nan: bool) -> Floats {
    Floats {
        low: f64::INFINITY,
        high: f64::NEG_INFINITY,
        nan,
        minus_zero: false,
        length: Length::Any,
    }
}

fn from_corners(corners: &[(f64, bool); 4], steps: u32) -> Floats {
    // The inexact one of equal corners decides.
    let pick = |better: fn(f64, f64) -> bool| {
        let mut best = corners[0];
        for &corner in &corners[1..] {
            if better(corner.0, best.0) {
                best = corner;
            } else if corner.0 == best.0 {
                best.1 &= corner.1;
            }
        }
        best
    };
    outward(pick(|a, b| a < b), pick(|a, b| a > b), steps)
}

/// The range of a division by a number that may be 0: the sign is all that is known.
fn quotient_by_zero(a: Floats, b: Floats, nan: bool) -> Floats {
    let is_known = b.is_positive() && (a.low >= 0.0 || a.high <= 0.0);
    let mut result = Floats { nan, ..Floats::ALL };
    // A flushed divisor keeps its sign, so that the quotient keeps its own.
    if is_known && a.low >= 0.0 {
        result.low = 0.0;
    } else if is_known {
        result.high = 0.0;
    }
    // 0 / 0 where a subnormal was flushed.
    result.nan |= a.has(0.0)
        || (a.low < f64::from(f32::MIN_POSITIVE) && a.high > -f64::from(f32::MIN_POSITIVE));
    result
}
