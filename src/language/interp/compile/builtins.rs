//! Built-in functions of WGSL, by the formulas of its specification.

use chiaro_locale::tr;
use naga::{Expression, Handle, MathFunction as Math, TypeInner};

use super::Outcome;
use super::linear::transpose;
use super::statements::FunctionCompiler;
use crate::interp::ScalarKind;
use crate::interp::instruction::{
    Comparison, FloatBinary, FloatUnary, Instruction, IntBinary, IntUnary, ScalarConversion, Slot,
};

impl FunctionCompiler<'_> {
    pub(super) fn math(
        &mut self,
        fun: Math,
        first: Handle<Expression>,
        others: [Option<Handle<Expression>>; 3],
    ) -> Outcome<Vec<Slot>> {
        let kind = self.kind(first)?;
        let mut arguments: Vec<Vec<Slot>> = vec![self.value(first)?.to_vec()];
        for other in others.into_iter().flatten() {
            arguments.push(self.value(other)?.to_vec());
        }
        if arguments.len() != fun.argument_count() {
            return Err(self.unsupported(
                tr!("a function with a wrong number of arguments (Math)"),
                self.span(first),
            ));
        }
        if let Some(op) = float_unary(fun, kind) {
            return self.map(&arguments[0], |this, a| this.float1(op, a));
        }
        if let Some(op) = int_unary(fun, kind) {
            return self.map(&arguments[0], |this, a| this.int1(op, a));
        }
        if let [a, b] = arguments.as_slice() {
            if let Some(op) = float_binary(fun, kind) {
                return self.zip(a, b, |this, a, b| this.float2(op, a, b));
            }
            if let Some(op) = int_binary(fun, kind) {
                return self.zip(a, b, |this, a, b| this.int2(op, a, b));
            }
        }
        let arguments: Vec<&[Slot]> = arguments.iter().map(Vec::as_slice).collect();
        match *arguments {
            [a] => self.of_one(fun, a, first),
            [a, b] => self.of_two(fun, kind, a, b),
            [a, b, c] => self.of_three(fun, kind, [a, b, c]),
            [a, b, offset, count] if fun == Math::InsertBits => {
                let (offset, count) = (offset[0], count[0]);
                self.zip(a, b, |this, a, b| {
                    this.compute(|to| Instruction::InsertBits { to, a, b, offset, count })
                })
            }
            _ => Err(self.unsupported(tr!("an unknown function (Math)"), self.span(first))),
        }
    }

    fn of_one(
        &mut self,
        fun: Math,
        a: &[Slot],
        argument: Handle<Expression>,
    ) -> Outcome<Vec<Slot>> {
        let columns = if let TypeInner::Matrix { columns, .. } = self.inner(argument) {
            *columns as usize
        } else {
            1
        };
        match fun {
            Math::Saturate => {
                let (zero, one) = (self.float_constant(0.0)?, self.float_constant(1.0)?);
                self.map(a, |this, a| this.clamp(a, zero, one))
            }
            Math::Modf => {
                let whole = self.map(a, |this, a| this.float1(FloatUnary::Trunc, a))?;
                let fraction = self.zip(a, &whole, Self::subtract)?;
                Ok([fraction, whole].concat())
            }
            Math::Frexp => {
                let fraction = self.map(a, |this, a| this.float1(FloatUnary::FrexpFraction, a))?;
                let exponent =
                    self.map(a, |this, a| this.convert(ScalarConversion::FrexpExponent, a))?;
                Ok([fraction, exponent].concat())
            }
            Math::Length => Ok(vec![self.length(a)?]),
            Math::Normalize => {
                let length = self.length(a)?;
                self.map(a, |this, a| this.divide(a, length))
            }
            Math::Transpose => Ok(transpose(a, columns)),
            Math::Determinant => Ok(vec![self.determinant(a, columns)?]),
            Math::Inverse => self.inverse(a, columns),
            _ => self.packing(fun, a),
        }
    }

    fn of_two(
        &mut self,
        fun: Math,
        kind: ScalarKind,
        a: &[Slot],
        b: &[Slot],
    ) -> Outcome<Vec<Slot>> {
        match (fun, a, b) {
            (Math::Dot, ..) if kind == ScalarKind::Float => Ok(vec![self.dot(a, b)?]),
            (Math::Dot, ..) => Ok(vec![self.int_dot(a, b)?]),
            (Math::Dot4I8Packed | Math::Dot4U8Packed, &[a], &[b]) => {
                let signed = fun == Math::Dot4I8Packed;
                let (a, b) = (self.unpack(a, 4, signed)?, self.unpack(b, 4, signed)?);
                Ok(vec![self.int_dot(&a, &b)?])
            }
            (Math::Cross, &[ax, ay, az], &[bx, by, bz]) => {
                Ok(self.cross([ax, ay, az], [bx, by, bz])?.to_vec())
            }
            (Math::Distance, ..) => {
                let difference = self.zip(a, b, Self::subtract)?;
                Ok(vec![self.length(&difference)?])
            }
            (Math::Reflect, incident, normal) => {
                let two = self.float_constant(2.0)?;
                let cosine = self.dot(normal, incident)?;
                let twice = self.multiply(two, cosine)?;
                let across = self.map(normal, |this, n| this.multiply(twice, n))?;
                self.zip(incident, &across, Self::subtract)
            }
            (Math::Ldexp, ..) => self.zip(a, b, |this, a, exponent| {
                this.compute(|to| Instruction::FloatScale { to, a, exponent })
            }),
            _ => Err(self.unknown(fun)),
        }
    }

    fn of_three(
        &mut self,
        fun: Math,
        kind: ScalarKind,
        [a, b, c]: [&[Slot]; 3],
    ) -> Outcome<Vec<Slot>> {
        let float = kind == ScalarKind::Float;
        match fun {
            Math::Clamp if float => {
                self.zip3([a, b, c], |this, [x, low, high]| this.clamp(x, low, high))
            }
            Math::Clamp => {
                let signed = kind == ScalarKind::I32;
                self.zip3([a, b, c], |this, [x, low, high]| this.int_clamp(x, low, high, signed))
            }
            Math::Fma => self.zip3([a, b, c], |this, [a, b, c]| {
                this.compute(|to| Instruction::FloatFma { to, a, b, c })
            }),
            Math::Mix => self.zip3([a, b, c], |this, [a, b, t]| this.mix(a, b, t)),
            Math::SmoothStep => {
                self.zip3([a, b, c], |this, [low, high, x]| this.smoothstep(low, high, x))
            }
            Math::FaceForward => {
                let zero = self.float_constant(0.0)?;
                let cosine = self.dot(b, c)?;
                let facing = self.compare(Comparison::Less, cosine, zero)?;
                self.map(a, |this, a| {
                    let turned = this.float1(FloatUnary::Negate, a)?;
                    this.choose(facing, a, turned)
                })
            }
            Math::Refract => self.refract(a, b, c[0]),
            Math::ExtractBits => {
                let (offset, count, signed) = (b[0], c[0], kind == ScalarKind::I32);
                self.map(a, |this, a| {
                    this.compute(|to| Instruction::ExtractBits { to, a, offset, count, signed })
                })
            }
            _ => Err(self.unknown(fun)),
        }
    }

    /// Applies `f` to the components of three vectors; a scalar is repeated.
    fn zip3(
        &mut self,
        [a, b, c]: [&[Slot]; 3],
        mut f: impl FnMut(&mut Self, [Slot; 3]) -> Outcome<Slot>,
    ) -> Outcome<Vec<Slot>> {
        let mut third = c.iter().cycle().copied();
        self.zip(a, b, |this, a, b| f(this, [a, b, third.next().unwrap_or_default()]))
    }

    fn clamp(&mut self, x: Slot, low: Slot, high: Slot) -> Outcome<Slot> {
        let raised = self.float2(FloatBinary::Max, x, low)?;
        self.float2(FloatBinary::Min, raised, high)
    }

    fn int_clamp(&mut self, x: Slot, low: Slot, high: Slot, signed: bool) -> Outcome<Slot> {
        let (min, max) = if signed {
            (IntBinary::MinSigned, IntBinary::MaxSigned)
        } else {
            (IntBinary::MinUnsigned, IntBinary::MaxUnsigned)
        };
        let raised = self.int2(max, x, low)?;
        self.int2(min, raised, high)
    }

    /// Emits `a * (1 - t) + b * t`.
    fn mix(&mut self, a: Slot, b: Slot, t: Slot) -> Outcome<Slot> {
        let one = self.float_constant(1.0)?;
        let rest = self.subtract(one, t)?;
        let from_a = self.multiply(a, rest)?;
        let from_b = self.multiply(b, t)?;
        self.add(from_a, from_b)
    }

    /// Emits `t * t * (3 - 2 * t)` with `t = clamp((x - low) / (high - low), 0, 1)`.
    fn smoothstep(&mut self, low: Slot, high: Slot, x: Slot) -> Outcome<Slot> {
        let [zero, one, two, three] = [0.0, 1.0, 2.0, 3.0].map(|x| self.float_constant(x));
        let above = self.subtract(x, low)?;
        let width = self.subtract(high, low)?;
        let ratio = self.divide(above, width)?;
        let t = self.clamp(ratio, zero?, one?)?;
        let square = self.multiply(t, t)?;
        let twice = self.multiply(two?, t)?;
        let rest = self.subtract(three?, twice)?;
        self.multiply(square, rest)
    }

    /// Emits a refracted vector. With `c = normal . incident` and `k = 1 - ratio^2 (1 - c^2)`: 0 if
    /// `k < 0`, else `ratio * incident - (ratio * c + sqrt(k)) * normal`.
    fn refract(&mut self, incident: &[Slot], normal: &[Slot], ratio: Slot) -> Outcome<Vec<Slot>> {
        let (zero, one) = (self.float_constant(0.0)?, self.float_constant(1.0)?);
        let cosine = self.dot(normal, incident)?;
        let cosine_squared = self.multiply(cosine, cosine)?;
        let sine_squared = self.subtract(one, cosine_squared)?;
        let ratio_squared = self.multiply(ratio, ratio)?;
        let refracted_squared = self.multiply(ratio_squared, sine_squared)?;
        let k = self.subtract(one, refracted_squared)?;
        let total = self.compare(Comparison::Less, k, zero)?;
        let root = self.float1(FloatUnary::Sqrt, k)?;
        let scaled = self.multiply(ratio, cosine)?;
        let along = self.add(scaled, root)?;
        self.zip(incident, normal, |this, incident, normal| {
            let onward = this.multiply(ratio, incident)?;
            let inward = this.multiply(along, normal)?;
            let refracted = this.subtract(onward, inward)?;
            this.choose(total, zero, refracted)
        })
    }

    fn int_dot(&mut self, a: &[Slot], b: &[Slot]) -> Outcome<Slot> {
        let products = self.zip(a, b, |this, a, b| this.int2(IntBinary::Multiply, a, b))?;
        self.fold(&products, |this, a, b| this.int2(IntBinary::Add, a, b))
    }

    /// Packs a vector into, or unpacks it from, a u32.
    fn packing(&mut self, fun: Math, a: &[Slot]) -> Outcome<Vec<Slot>> {
        let packed = match fun {
            Math::Pack4x8snorm => self.convert_and_pack(ScalarConversion::ToSnorm8, a)?,
            Math::Pack4x8unorm => self.convert_and_pack(ScalarConversion::ToUnorm8, a)?,
            Math::Pack2x16snorm => self.convert_and_pack(ScalarConversion::ToSnorm16, a)?,
            Math::Pack2x16unorm => self.convert_and_pack(ScalarConversion::ToUnorm16, a)?,
            Math::Pack2x16float => self.convert_and_pack(ScalarConversion::ToHalf, a)?,
            Math::Pack4xI8 | Math::Pack4xU8 => self.pack(a)?,
            Math::Pack4xI8Clamp => self.clamp_and_pack(a, -128, 127, true)?,
            Math::Pack4xU8Clamp => self.clamp_and_pack(a, 0, 255, false)?,
            Math::Unpack4xI8 => return self.unpack(a[0], 4, true),
            Math::Unpack4xU8 => return self.unpack(a[0], 4, false),
            Math::Unpack4x8snorm => {
                return self.unpack_and_convert(a[0], 4, true, ScalarConversion::FromSnorm8);
            }
            Math::Unpack4x8unorm => {
                return self.unpack_and_convert(a[0], 4, false, ScalarConversion::FromUnorm8);
            }
            Math::Unpack2x16snorm => {
                return self.unpack_and_convert(a[0], 2, true, ScalarConversion::FromSnorm16);
            }
            Math::Unpack2x16unorm => {
                return self.unpack_and_convert(a[0], 2, false, ScalarConversion::FromUnorm16);
            }
            Math::Unpack2x16float => {
                return self.unpack_and_convert(a[0], 2, false, ScalarConversion::FromHalf);
            }
            _ => return Err(self.unknown(fun)),
        };
        Ok(vec![packed])
    }

    fn convert_and_pack(&mut self, op: ScalarConversion, a: &[Slot]) -> Outcome<Slot> {
        let converted = self.map(a, |this, a| this.convert(op, a))?;
        self.pack(&converted)
    }

    fn clamp_and_pack(&mut self, a: &[Slot], low: i32, high: i32, signed: bool) -> Outcome<Slot> {
        let (low, high) = (self.int_constant(low as u32)?, self.int_constant(high as u32)?);
        let clamped = self.map(a, |this, a| this.int_clamp(a, low, high, signed))?;
        self.pack(&clamped)
    }

    /// Packs the low bits of each integer side by side, the first lowest.
    fn pack(&mut self, a: &[Slot]) -> Outcome<Slot> {
        let width = 32_u32.checked_div(a.len() as u32).unwrap_or(0);
        let count = self.int_constant(width)?;
        let mut packed = self.int_constant(0)?;
        for (index, &b) in (0..).zip(a) {
            let offset = self.int_constant(index * width)?;
            packed =
                self.compute(|to| Instruction::InsertBits { to, a: packed, b, offset, count })?;
        }
        Ok(packed)
    }

    /// Unpacks the integers that [`pack`](Self::pack) put together.
    fn unpack(&mut self, a: Slot, parts: u32, signed: bool) -> Outcome<Vec<Slot>> {
        let count = self.int_constant(32 / parts)?;
        (0..parts)
            .map(|index| {
                let offset = self.int_constant(index * (32 / parts))?;
                self.compute(|to| Instruction::ExtractBits { to, a, offset, count, signed })
            })
            .collect()
    }

    fn unpack_and_convert(
        &mut self,
        a: Slot,
        parts: u32,
        signed: bool,
        op: ScalarConversion,
    ) -> Outcome<Vec<Slot>> {
        let integers = self.unpack(a, parts, signed)?;
        self.map(&integers, |this, a| this.convert(op, a))
    }

    #[cold]
    fn unknown(&self, fun: Math) -> Box<crate::diag::Diagnostic> {
        self.unsupported(&tr!("`{fun:?}` on the wrong types (Math)"), naga::Span::UNDEFINED)
    }
}

fn float_unary(fun: Math, kind: ScalarKind) -> Option<FloatUnary> {
    Some(match fun {
        Math::Abs | Math::Sign if kind != ScalarKind::Float => return None,
        Math::Abs => FloatUnary::Abs,
        Math::Sign => FloatUnary::Sign,
        Math::Cos => FloatUnary::Cos,
        Math::Cosh => FloatUnary::Cosh,
        Math::Sin => FloatUnary::Sin,
        Math::Sinh => FloatUnary::Sinh,
        Math::Tan => FloatUnary::Tan,
        Math::Tanh => FloatUnary::Tanh,
        Math::Acos => FloatUnary::Acos,
        Math::Asin => FloatUnary::Asin,
        Math::Atan => FloatUnary::Atan,
        Math::Asinh => FloatUnary::Asinh,
        Math::Acosh => FloatUnary::Acosh,
        Math::Atanh => FloatUnary::Atanh,
        Math::Radians => FloatUnary::Radians,
        Math::Degrees => FloatUnary::Degrees,
        Math::Ceil => FloatUnary::Ceil,
        Math::Floor => FloatUnary::Floor,
        Math::Round => FloatUnary::Round,
        Math::Fract => FloatUnary::Fract,
        Math::Trunc => FloatUnary::Trunc,
        Math::Exp => FloatUnary::Exp,
        Math::Exp2 => FloatUnary::Exp2,
        Math::Log => FloatUnary::Log,
        Math::Log2 => FloatUnary::Log2,
        Math::Sqrt => FloatUnary::Sqrt,
        Math::InverseSqrt => FloatUnary::InverseSqrt,
        Math::QuantizeToF16 => FloatUnary::QuantizeToF16,
        _ => return None,
    })
}

fn float_binary(fun: Math, kind: ScalarKind) -> Option<FloatBinary> {
    Some(match fun {
        Math::Min | Math::Max if kind != ScalarKind::Float => return None,
        Math::Min => FloatBinary::Min,
        Math::Max => FloatBinary::Max,
        Math::Step => FloatBinary::Step,
        Math::Atan2 => FloatBinary::Atan2,
        Math::Pow => FloatBinary::Pow,
        _ => return None,
    })
}

fn int_unary(fun: Math, kind: ScalarKind) -> Option<IntUnary> {
    Some(match (fun, kind) {
        (Math::Abs, ScalarKind::I32) => IntUnary::Abs,
        (Math::Sign, ScalarKind::I32) => IntUnary::Sign,
        (Math::CountTrailingZeros, _) => IntUnary::CountTrailingZeros,
        (Math::CountLeadingZeros, _) => IntUnary::CountLeadingZeros,
        (Math::CountOneBits, _) => IntUnary::CountOneBits,
        (Math::ReverseBits, _) => IntUnary::ReverseBits,
        (Math::FirstTrailingBit, _) => IntUnary::FirstTrailingBit,
        (Math::FirstLeadingBit, ScalarKind::I32) => IntUnary::FirstLeadingBitSigned,
        (Math::FirstLeadingBit, _) => IntUnary::FirstLeadingBitUnsigned,
        (Math::Abs, _) => IntUnary::Identity,
        _ => return None,
    })
}

fn int_binary(fun: Math, kind: ScalarKind) -> Option<IntBinary> {
    Some(match (fun, kind) {
        (Math::Min, ScalarKind::I32) => IntBinary::MinSigned,
        (Math::Min, _) => IntBinary::MinUnsigned,
        (Math::Max, ScalarKind::I32) => IntBinary::MaxSigned,
        (Math::Max, _) => IntBinary::MaxUnsigned,
        _ => return None,
    })
}
