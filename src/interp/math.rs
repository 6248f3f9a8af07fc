//! The operations on scalars.

use half::f16;

use super::instruction::{Compare, Conversion, FloatBinary, FloatUnary, IntBinary, IntUnary};

/// How floats are rounded, as a type, so that the machine is compiled once for each.
pub(super) trait Rounding {
    /// The greatest i32 and u32 that the floats of this precision can hold.
    const GREATEST_INTEGERS: (f64, f64);
    /// The nearest float of this precision.
    fn round(x: f64) -> f64;
    /// `a * b + c`, rounded once.
    fn fma(a: f64, b: f64, c: f64) -> f64;
}

/// Floats are f64.
pub(super) struct Double;

impl Rounding for Double {
    const GREATEST_INTEGERS: (f64, f64) = (i32::MAX as f64, u32::MAX as f64);

    fn round(x: f64) -> f64 {
        x
    }

    fn fma(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}

/// Floats are f32, held as f64.
pub(super) struct Single;

impl Rounding for Single {
    const GREATEST_INTEGERS: (f64, f64) = (2_147_483_520.0, 4_294_967_040.0);

    fn round(x: f64) -> f64 {
        f64::from(x as f32)
    }

    fn fma(a: f64, b: f64, c: f64) -> f64 {
        f64::from((a as f32).mul_add(b as f32, c as f32))
    }
}

/// Of one float; not yet rounded.
pub(super) fn float_unary(op: FloatUnary, x: f64) -> f64 {
    match op {
        FloatUnary::Negate => -x,
        FloatUnary::Abs => x.abs(),
        FloatUnary::Sign if x > 0.0 => 1.0,
        FloatUnary::Sign if x < 0.0 => -1.0,
        FloatUnary::Sign => x,
        FloatUnary::Cos => x.cos(),
        FloatUnary::Cosh => x.cosh(),
        FloatUnary::Sin => x.sin(),
        FloatUnary::Sinh => x.sinh(),
        FloatUnary::Tan => x.tan(),
        FloatUnary::Tanh => x.tanh(),
        FloatUnary::Acos => x.acos(),
        FloatUnary::Asin => x.asin(),
        FloatUnary::Atan => x.atan(),
        FloatUnary::Asinh => x.asinh(),
        FloatUnary::Acosh => x.acosh(),
        FloatUnary::Atanh => x.atanh(),
        FloatUnary::Radians => x.to_radians(),
        FloatUnary::Degrees => x.to_degrees(),
        FloatUnary::Ceil => x.ceil(),
        FloatUnary::Floor => x.floor(),
        FloatUnary::Round => x.round_ties_even(),
        FloatUnary::Fract => x - x.floor(),
        FloatUnary::Trunc => x.trunc(),
        FloatUnary::FrexpFraction => frexp(x).0,
        FloatUnary::Exp => x.exp(),
        FloatUnary::Exp2 => x.exp2(),
        FloatUnary::Log => x.ln(),
        FloatUnary::Log2 => x.log2(),
        FloatUnary::Sqrt => x.sqrt(),
        FloatUnary::InverseSqrt => 1.0 / x.sqrt(),
        FloatUnary::QuantizeToF16 => f16::from_f64(x).to_f64(),
    }
}

/// Of two floats; not yet rounded.
pub(super) fn float_binary(op: FloatBinary, a: f64, b: f64) -> f64 {
    match op {
        FloatBinary::Add => a + b,
        FloatBinary::Subtract => a - b,
        FloatBinary::Multiply => a * b,
        FloatBinary::Divide => a / b,
        FloatBinary::Remainder => a % b,
        // Of a number and NaN, the number.
        FloatBinary::Min if b < a || a.is_nan() => b,
        FloatBinary::Max if a < b || a.is_nan() => b,
        FloatBinary::Min | FloatBinary::Max => a,
        FloatBinary::Step => f64::from(u8::from(a <= b)),
        FloatBinary::Atan2 => a.atan2(b),
        FloatBinary::Pow => pow(a, b),
    }
}

/// `x^y` on the domain of `exp2(y * log2(x))`, which is how WGSL defines it.
fn pow(x: f64, y: f64) -> f64 {
    if x > 0.0 && x.is_finite() && y.is_finite() { x.powf(y) } else { (y * x.log2()).exp2() }
}

/// Of two floats.
pub(super) fn float_compare(op: Compare, a: f64, b: f64) -> bool {
    match op {
        Compare::Equal => a == b,
        Compare::NotEqual => a != b,
        Compare::Less => a < b,
        Compare::LessEqual => a <= b,
    }
}

/// A fraction with magnitude in [0.5, 1), and the exponent of the power of two that it is to be multiplied by. Zeros,
/// infinities and NaN are their own fraction, with exponent 0.
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
    // Beyond these, every finite number has become infinite or zero.
    let mut rest = exponent.clamp(-2200, 2200);
    while rest > 1000 {
        x *= 1000_f64.exp2();
        rest -= 1000;
    }
    // Steps down stay clear of subnormals (53 bits of 1022), lest one step round what another rounds again.
    while rest < -969 {
        x *= (-969_f64).exp2();
        rest += 969;
    }
    x * f64::from(rest).exp2()
}

/// Of one integer.
pub(super) fn int_unary(op: IntUnary, x: u32) -> u32 {
    let signed = x as i32;
    match op {
        IntUnary::Identity => x,
        IntUnary::Negate => x.wrapping_neg(),
        IntUnary::Abs => signed.wrapping_abs() as u32,
        IntUnary::Sign => signed.signum() as u32,
        IntUnary::Complement => !x,
        IntUnary::LogicalNot => x ^ 1,
        IntUnary::CountTrailingZeros => x.trailing_zeros(),
        IntUnary::CountLeadingZeros => x.leading_zeros(),
        IntUnary::CountOneBits => x.count_ones(),
        IntUnary::ReverseBits => x.reverse_bits(),
        IntUnary::FirstTrailingBit if x == 0 => u32::MAX,
        IntUnary::FirstTrailingBit => x.trailing_zeros(),
        // The topmost bit that differs from the sign; none gives 31 - 32, all ones.
        IntUnary::FirstLeadingBitSigned => 31_u32.wrapping_sub(((signed >> 31) ^ signed).leading_zeros()),
        IntUnary::FirstLeadingBitUnsigned => 31_u32.wrapping_sub(x.leading_zeros()),
    }
}

/// Of two integers or bools.
pub(super) fn int_binary(op: IntBinary, a: u32, b: u32) -> u32 {
    let (x, y) = (a as i32, b as i32);
    match op {
        IntBinary::Add => a.wrapping_add(b),
        IntBinary::Subtract => a.wrapping_sub(b),
        IntBinary::Multiply => a.wrapping_mul(b),
        IntBinary::DivideSigned if y == 0 => a,
        IntBinary::DivideSigned => x.wrapping_div(y) as u32,
        IntBinary::DivideUnsigned => a.checked_div(b).unwrap_or(a),
        IntBinary::RemainderSigned if y == 0 => 0,
        IntBinary::RemainderSigned => x.wrapping_rem(y) as u32,
        IntBinary::RemainderUnsigned => a.checked_rem(b).unwrap_or(0),
        IntBinary::And => a & b,
        IntBinary::Or => a | b,
        IntBinary::Xor => a ^ b,
        IntBinary::ShiftLeft => a.wrapping_shl(b),
        IntBinary::ShiftRightSigned => x.wrapping_shr(b) as u32,
        IntBinary::ShiftRightUnsigned => a.wrapping_shr(b),
        IntBinary::MinSigned => x.min(y) as u32,
        IntBinary::MinUnsigned => a.min(b),
        IntBinary::MaxSigned => x.max(y) as u32,
        IntBinary::MaxUnsigned => a.max(b),
        IntBinary::Equal => u32::from(a == b),
        IntBinary::NotEqual => u32::from(a != b),
        IntBinary::LessSigned => u32::from(x < y),
        IntBinary::LessUnsigned => u32::from(a < b),
        IntBinary::LessEqualSigned => u32::from(x <= y),
        IntBinary::LessEqualUnsigned => u32::from(a <= b),
    }
}

/// The part of bits `offset..offset + count` that lies within 32 bits, as offset and count.
fn bit_range(offset: u32, count: u32) -> (u32, u32) {
    let offset = offset.min(32);
    (offset, count.min(32 - offset))
}

/// Those bits of `x`, moved to the bottom.
pub(super) fn extract_bits(x: u32, offset: u32, count: u32, signed: bool) -> u32 {
    let (offset, count) = bit_range(offset, count);
    if count == 0 {
        return 0;
    }
    let top = u64::from(x) << (64 - offset - count);
    if signed { (top.cast_signed() >> (64 - count)) as u32 } else { (top >> (64 - count)) as u32 }
}

/// `x` with those bits replaced by the lowest of `new`.
pub(super) fn insert_bits(x: u32, new: u32, offset: u32, count: u32) -> u32 {
    let (offset, count) = bit_range(offset, count);
    let mask = ((1_u64 << count) - 1) << offset;
    let new = u64::from(new) << offset;
    (u64::from(x) & !mask | new & mask) as u32
}

/// From the bits of a slot to those of another.
pub(super) fn convert<R: Rounding>(op: Conversion, bits: u64) -> u64 {
    let float = f64::from_bits(bits);
    let integer = bits as u32;
    let signed = f64::from(integer as i32);
    let (greatest_i32, greatest_u32) = R::GREATEST_INTEGERS;
    let real = |x: f64| R::round(x).to_bits();
    let whole = |x: i32| u64::from(x as u32);
    let at_most = |greatest: f64| if float > greatest { greatest } else { float };
    // `as` truncates and saturates, and makes 0 of NaN.
    let normalized = |least: f64, scale: f64| whole((0.5 + scale * float.clamp(least, 1.0)).floor() as i32);
    match op {
        Conversion::FloatToI32 => whole(at_most(greatest_i32) as i32),
        Conversion::FloatToU32 => u64::from(at_most(greatest_u32) as u32),
        Conversion::FloatToBool => u64::from(float != 0.0),
        Conversion::IntToBool => u64::from(integer != 0),
        Conversion::I32ToFloat => real(signed),
        Conversion::U32ToFloat => real(f64::from(integer)),
        Conversion::FloatToBits => u64::from((float as f32).to_bits()),
        Conversion::BitsToFloat => f64::from(f32::from_bits(integer)).to_bits(),
        Conversion::FrexpExponent => whole(frexp(float).1),
        Conversion::IsNan => u64::from(float.is_nan()),
        Conversion::IsInf => u64::from(float.is_infinite()),
        Conversion::ToSnorm8 => normalized(-1.0, 127.0),
        Conversion::ToUnorm8 => normalized(0.0, 255.0),
        Conversion::ToSnorm16 => normalized(-1.0, 32767.0),
        Conversion::ToUnorm16 => normalized(0.0, 65535.0),
        Conversion::ToHalf => u64::from(f16::from_f64(float).to_bits()),
        Conversion::FromSnorm8 => real((signed / 127.0).max(-1.0)),
        Conversion::FromUnorm8 => real(signed / 255.0),
        Conversion::FromSnorm16 => real((signed / 32767.0).max(-1.0)),
        Conversion::FromUnorm16 => real(signed / 65535.0),
        Conversion::FromHalf => real(f16::from_bits(integer as u16).to_f64()),
    }
}
