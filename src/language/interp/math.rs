//! Operations on scalars.
//!
//! Each function here takes an operation and its operands: one pair of them or whole rows. The
//! choice of the operation thus stands outside the loop over the lanes, and its meaning is written
//! once for any number of them.

use half::f16;

use super::instruction::{
    Comparison, FloatBinary, FloatUnary, IntBinary, IntUnary, ScalarConversion,
};

/// Operands of one kind, on each of which a function can be run.
pub(super) trait Unary<T, U> {
    /// Stores `f` of every operand.
    fn with(self, f: impl Fn(T) -> U);
}

/// Pairs of operands of one kind, on each of which a function can be run.
pub(super) trait Binary<T, U> {
    /// Stores `f` of every pair.
    fn with(self, f: impl Fn(T, T) -> U);
}

/// Rounding of floats, as a type, so that the machine is compiled once for each.
pub(super) trait Rounding {
    /// Greatest i32 and u32 that the floats of this precision can hold.
    const GREATEST_INTEGERS: (f64, f64);
    /// Nearest float of this precision.
    fn round(x: f64) -> f64;
    /// `x` rounded to f16 in f32 mode, and unchanged in f64 mode.
    fn half(x: f64) -> f64;
    /// `a * b + c`, rounded once.
    fn fma(a: f64, b: f64, c: f64) -> f64;
}

/// Rounding to f64: floats are f64.
pub(super) struct Double;

impl Rounding for Double {
    const GREATEST_INTEGERS: (f64, f64) = (i32::MAX as f64, u32::MAX as f64);

    #[inline(always)]
    fn round(x: f64) -> f64 {
        x
    }

    fn half(x: f64) -> f64 {
        x
    }

    fn fma(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}

/// Rounding to f32: floats are f32, held as f64.
pub(super) struct Single;

impl Rounding for Single {
    const GREATEST_INTEGERS: (f64, f64) = (2_147_483_520.0, 4_294_967_040.0);

    #[inline(always)]
    fn round(x: f64) -> f64 {
        f64::from(x as f32)
    }

    fn half(x: f64) -> f64 {
        f16::from_f64(x).to_f64()
    }

    fn fma(a: f64, b: f64, c: f64) -> f64 {
        f64::from((a as f32).mul_add(b as f32, c as f32))
    }
}

/// Operations on one float; not yet rounded.
#[inline(always)]
pub(super) fn float_unary(op: FloatUnary, each: impl Unary<f64, f64>) {
    match op {
        FloatUnary::Negate => each.with(|x: f64| -x),
        FloatUnary::Abs => each.with(f64::abs),
        FloatUnary::Sign => each.with(sign),
        FloatUnary::Cos => each.with(f64::cos),
        FloatUnary::Cosh => each.with(f64::cosh),
        FloatUnary::Sin => each.with(f64::sin),
        FloatUnary::Sinh => each.with(f64::sinh),
        FloatUnary::Tan => each.with(f64::tan),
        FloatUnary::Tanh => each.with(f64::tanh),
        FloatUnary::Acos => each.with(f64::acos),
        FloatUnary::Asin => each.with(f64::asin),
        FloatUnary::Atan => each.with(f64::atan),
        FloatUnary::Asinh => each.with(f64::asinh),
        FloatUnary::Acosh => each.with(f64::acosh),
        FloatUnary::Atanh => each.with(f64::atanh),
        FloatUnary::Radians => each.with(f64::to_radians),
        FloatUnary::Degrees => each.with(f64::to_degrees),
        FloatUnary::Ceil => each.with(f64::ceil),
        FloatUnary::Floor => each.with(f64::floor),
        FloatUnary::Round => each.with(f64::round_ties_even),
        FloatUnary::Fract => each.with(|x: f64| x - x.floor()),
        FloatUnary::Trunc => each.with(f64::trunc),
        FloatUnary::FrexpFraction => each.with(|x: f64| frexp(x).0),
        FloatUnary::Exp => each.with(f64::exp),
        FloatUnary::Exp2 => each.with(f64::exp2),
        FloatUnary::Log => each.with(f64::ln),
        FloatUnary::Log2 => each.with(f64::log2),
        FloatUnary::Sqrt => each.with(f64::sqrt),
        FloatUnary::InverseSqrt => each.with(|x: f64| 1.0 / x.sqrt()),
        FloatUnary::QuantizeToF16 => each.with(|x: f64| f16::from_f64(x).to_f64()),
    }
}

fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// Operations on two floats; not yet rounded.
#[inline(always)]
pub(super) fn float_binary(op: FloatBinary, each: impl Binary<f64, f64>) {
    match op {
        FloatBinary::Add => each.with(|a, b| a + b),
        FloatBinary::Subtract => each.with(|a, b| a - b),
        FloatBinary::Multiply => each.with(|a, b| a * b),
        FloatBinary::Divide => each.with(|a, b| a / b),
        FloatBinary::Remainder => each.with(|a, b| a % b),
        // The minimum or maximum of a number and NaN is the number.
        FloatBinary::Min => each.with(|a, b| if b < a || a.is_nan() { b } else { a }),
        FloatBinary::Max => each.with(|a, b| if a < b || a.is_nan() { b } else { a }),
        FloatBinary::Step => each.with(|a, b| f64::from(u8::from(a <= b))),
        FloatBinary::Atan2 => each.with(f64::atan2),
        FloatBinary::Pow => each.with(pow),
    }
}

/// `x^y` on the domain of `exp2(y * log2(x))`, which is how WGSL defines it.
fn pow(x: f64, y: f64) -> f64 {
    if x > 0.0 && x.is_finite() && y.is_finite() { x.powf(y) } else { (y * x.log2()).exp2() }
}

/// Comparisons of two floats.
#[inline(always)]
pub(super) fn float_compare(op: Comparison, each: impl Binary<f64, bool>) {
    match op {
        Comparison::Equal => each.with(|a, b| a == b),
        Comparison::NotEqual => each.with(|a, b| a != b),
        Comparison::Less => each.with(|a, b| a < b),
        Comparison::LessEqual => each.with(|a, b| a <= b),
    }
}

/// Fraction with magnitude in [0.5, 1), and the exponent of the power of two to multiply it by.
/// Zeros, infinities and NaN are their own fraction, with exponent 0.
pub(super) fn frexp(x: f64) -> (f64, i32) {
    const MIDDLE: u64 = 1022;
    if x == 0.0 || !x.is_finite() {
        return (x, 0);
    }
    let scale = if x.is_subnormal() { 64 } else { 0 };
    let bits = (x * f64::from(scale).exp2()).to_bits();
    let exponent = (bits >> 52 & 0x7FF) as i32;
    (f64::from_bits(bits & !(0x7FF << 52) | MIDDLE << 52), exponent - MIDDLE as i32 - scale)
}

/// `x * 2^exponent`, rounded once.
pub(super) fn ldexp(mut x: f64, exponent: i32) -> f64 {
    // Beyond these exponents, every finite number has become infinite or zero.
    let mut rest = exponent.clamp(-2200, 2200);
    while rest > 1000 {
        x *= 1000_f64.exp2();
        rest -= 1000;
    }
    // Steps down stay clear of subnormals (53 bits of 1022), so that no number is rounded twice.
    while rest < -969 {
        x *= (-969_f64).exp2();
        rest += 969;
    }
    x * f64::from(rest).exp2()
}

/// Operations on one integer.
#[inline(always)]
pub(super) fn int_unary(op: IntUnary, each: impl Unary<u32, u32>) {
    match op {
        IntUnary::Identity => each.with(|x| x),
        IntUnary::Negate => each.with(u32::wrapping_neg),
        IntUnary::Abs => each.with(|x| x.cast_signed().wrapping_abs() as u32),
        IntUnary::Sign => each.with(|x| x.cast_signed().signum() as u32),
        IntUnary::Complement => each.with(|x| !x),
        IntUnary::LogicalNot => each.with(|x| x ^ 1),
        IntUnary::CountTrailingZeros => each.with(u32::trailing_zeros),
        IntUnary::CountLeadingZeros => each.with(u32::leading_zeros),
        IntUnary::CountOneBits => each.with(u32::count_ones),
        IntUnary::ReverseBits => each.with(u32::reverse_bits),
        IntUnary::FirstTrailingBit => {
            each.with(|x| if x == 0 { u32::MAX } else { x.trailing_zeros() });
        }
        // Index of the topmost bit that differs from the sign; without any, 31 - 32, all ones.
        IntUnary::FirstLeadingBitSigned => each.with(|x| {
            let signed = x.cast_signed();
            31_u32.wrapping_sub(((signed >> 31) ^ signed).leading_zeros())
        }),
        IntUnary::FirstLeadingBitUnsigned => each.with(|x| 31_u32.wrapping_sub(x.leading_zeros())),
    }
}

/// Operations on two integers or bools.
#[inline(always)]
pub(super) fn int_binary(op: IntBinary, each: impl Binary<u32, u32>) {
    let signed = u32::cast_signed;
    match op {
        IntBinary::Add => each.with(u32::wrapping_add),
        IntBinary::Subtract => each.with(u32::wrapping_sub),
        IntBinary::Multiply => each.with(u32::wrapping_mul),
        IntBinary::DivideSigned => {
            each.with(|a, b| if b == 0 { a } else { signed(a).wrapping_div(signed(b)) as u32 });
        }
        IntBinary::DivideUnsigned => each.with(|a, b| a.checked_div(b).unwrap_or(a)),
        IntBinary::RemainderSigned => {
            each.with(|a, b| if b == 0 { 0 } else { signed(a).wrapping_rem(signed(b)) as u32 });
        }
        IntBinary::RemainderUnsigned => each.with(|a, b| a.checked_rem(b).unwrap_or(0)),
        IntBinary::And => each.with(|a, b| a & b),
        IntBinary::Or => each.with(|a, b| a | b),
        IntBinary::Xor => each.with(|a, b| a ^ b),
        IntBinary::ShiftLeft => each.with(u32::wrapping_shl),
        IntBinary::ShiftRightSigned => each.with(|a, b| signed(a).wrapping_shr(b) as u32),
        IntBinary::ShiftRightUnsigned => each.with(u32::wrapping_shr),
        IntBinary::MinSigned => each.with(|a, b| signed(a).min(signed(b)) as u32),
        IntBinary::MinUnsigned => each.with(u32::min),
        IntBinary::MaxSigned => each.with(|a, b| signed(a).max(signed(b)) as u32),
        IntBinary::MaxUnsigned => each.with(u32::max),
        IntBinary::Equal => each.with(|a, b| u32::from(a == b)),
        IntBinary::NotEqual => each.with(|a, b| u32::from(a != b)),
        IntBinary::LessSigned => each.with(|a, b| u32::from(signed(a) < signed(b))),
        IntBinary::LessUnsigned => each.with(|a, b| u32::from(a < b)),
        IntBinary::LessEqualSigned => each.with(|a, b| u32::from(signed(a) <= signed(b))),
        IntBinary::LessEqualUnsigned => each.with(|a, b| u32::from(a <= b)),
    }
}

/// Part of bits `offset..offset + count` that lies within 32 bits, as offset and count.
fn bit_range(offset: u32, count: u32) -> (u32, u32) {
    let offset = offset.min(32);
    (offset, count.min(32 - offset))
}

/// Bits `offset..offset + count` of `x`, moved to the bottom.
pub(super) fn extract_bits(x: u32, offset: u32, count: u32, signed: bool) -> u32 {
    let (offset, count) = bit_range(offset, count);
    if count == 0 {
        return 0;
    }
    let top = u64::from(x) << (64 - offset - count);
    if signed { (top.cast_signed() >> (64 - count)) as u32 } else { (top >> (64 - count)) as u32 }
}

/// `x` with bits `offset..offset + count` replaced by the lowest of `new`.
pub(super) fn insert_bits(x: u32, new: u32, offset: u32, count: u32) -> u32 {
    let (offset, count) = bit_range(offset, count);
    let mask = ((1_u64 << count) - 1) << offset;
    let new = u64::from(new) << offset;
    (u64::from(x) & !mask | new & mask) as u32
}

/// Conversions from the bits of one slot to those of another.
#[inline(always)]
pub(super) fn convert<R: Rounding>(op: ScalarConversion, each: impl Unary<u64, u64>) {
    let float = f64::from_bits;
    let integer = |bits: u64| bits as u32;
    let signed = |bits: u64| f64::from(bits as u32 as i32);
    let (greatest_i32, greatest_u32) = R::GREATEST_INTEGERS;
    let real = |x: f64| R::round(x).to_bits();
    let whole = |x: i32| u64::from(x as u32);
    let at_most = |x: f64, greatest: f64| if x > greatest { greatest } else { x };
    // `as` truncates and saturates, and makes 0 of NaN.
    let normalized = |bits: u64, least: f64, scale: f64| {
        whole((0.5 + scale * float(bits).clamp(least, 1.0)).floor() as i32)
    };
    match op {
        ScalarConversion::FloatToI32 => {
            each.with(|x| whole(at_most(float(x), greatest_i32) as i32));
        }
        ScalarConversion::FloatToU32 => {
            each.with(|x| u64::from(at_most(float(x), greatest_u32) as u32));
        }
        ScalarConversion::FloatToBool => each.with(|x| u64::from(float(x) != 0.0)),
        ScalarConversion::IntToBool => each.with(|x| u64::from(integer(x) != 0)),
        ScalarConversion::I32ToFloat => each.with(|x| real(signed(x))),
        ScalarConversion::U32ToFloat => each.with(|x| real(f64::from(integer(x)))),
        ScalarConversion::FloatToBits => each.with(|x| u64::from((float(x) as f32).to_bits())),
        ScalarConversion::BitsToFloat => {
            each.with(|x| f64::from(f32::from_bits(integer(x))).to_bits());
        }
        ScalarConversion::FrexpExponent => each.with(|x| whole(frexp(float(x)).1)),
        ScalarConversion::IsNan => each.with(|x| u64::from(float(x).is_nan())),
        ScalarConversion::IsInf => each.with(|x| u64::from(float(x).is_infinite())),
        ScalarConversion::ToSnorm8 => each.with(|x| normalized(x, -1.0, 127.0)),
        ScalarConversion::ToUnorm8 => each.with(|x| normalized(x, 0.0, 255.0)),
        ScalarConversion::ToSnorm16 => each.with(|x| normalized(x, -1.0, 32767.0)),
        ScalarConversion::ToUnorm16 => each.with(|x| normalized(x, 0.0, 65535.0)),
        ScalarConversion::ToHalf => each.with(|x| u64::from(f16::from_f64(float(x)).to_bits())),
        ScalarConversion::FromSnorm8 => each.with(|x| real((signed(x) / 127.0).max(-1.0))),
        ScalarConversion::FromUnorm8 => each.with(|x| real(signed(x) / 255.0)),
        ScalarConversion::FromSnorm16 => each.with(|x| real((signed(x) / 32767.0).max(-1.0))),
        ScalarConversion::FromUnorm16 => each.with(|x| real(signed(x) / 65535.0)),
        ScalarConversion::FromHalf => {
            each.with(|x| real(f16::from_bits(integer(x) as u16).to_f64()));
        }
        ScalarConversion::HalfInSingle => each.with(|x| R::half(float(x)).to_bits()),
    }
}
