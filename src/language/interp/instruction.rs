//! Instructions of the machine. Every operand is the number of a slot, unless stated otherwise.

/// Number of a slot in memory.
pub(super) type Slot = u32;

/// Number of an instruction; while compiling, number of a label.
pub(super) type JumpTarget = u32;

/// Instruction: one step of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Instruction {
    /// Ends the program.
    Halt,
    /// `to = from`
    Copy { to: Slot, from: Slot },
    /// `to[i] = from[i]` for `i < count`; the ranges do not overlap.
    CopyRun { to: Slot, from: Slot, count: u32 },
    /// `to[i] = 0` for `i < count`
    Clear { to: Slot, count: u32 },
    /// float -> float
    FloatUnary { op: FloatUnary, to: Slot, a: Slot },
    /// (float, float) -> float
    FloatBinary { op: FloatBinary, to: Slot, a: Slot, b: Slot },
    /// `a * b + c` with one rounding
    FloatFma { to: Slot, a: Slot, b: Slot, c: Slot },
    /// `a * 2^exponent`; the exponent is an i32.
    FloatScale { to: Slot, a: Slot, exponent: Slot },
    /// (float, float) -> bool
    FloatCompare { op: Comparison, to: Slot, a: Slot, b: Slot },
    /// integer -> integer
    IntUnary { op: IntUnary, to: Slot, a: Slot },
    /// (integer, integer) -> integer or bool
    IntBinary { op: IntBinary, to: Slot, a: Slot, b: Slot },
    /// Bits `offset..offset + count` of `a`, sign-extended if `signed`.
    ExtractBits { to: Slot, a: Slot, offset: Slot, count: Slot, signed: bool },
    /// `a` with the bits `offset..offset + count` replaced by the low bits of `b`.
    InsertBits { to: Slot, a: Slot, b: Slot, offset: Slot, count: Slot },
    /// Conversion from one kind of scalar to another.
    Convert { op: ScalarConversion, to: Slot, a: Slot },
    /// `to = if condition { accept } else { reject }`
    Select { to: Slot, condition: Slot, accept: Slot, reject: Slot },
    /// `to = pointer + min(index, count - 1) * stride`; `count` and `stride` are numbers.
    Index { to: Slot, pointer: Slot, index: Slot, count: u32, stride: u32 },
    /// `to = pointer + offset`; `offset` is a number.
    Offset { to: Slot, pointer: Slot, offset: u32 },
    /// `to[i] = memory[pointer + offset + i]` for `i < count`
    Load { to: Slot, pointer: Slot, offset: u32, count: u32 },
    /// `memory[pointer + offset] = from`
    Store { pointer: Slot, offset: u32, from: Slot },
    /// `to[i] = buffers[buffer][pointer + offset + i]` for `i < count`; beyond the buffer's end the
    /// last scalar.
    LoadBuffer { to: Slot, buffer: u32, pointer: Slot, offset: u32, count: u32 },
    /// Difference of a float between the lanes of a 2x2 quad.
    Derivative { op: Derivative, to: Slot, a: Slot },
    /// Read of a texture, or query of its size; the number is that of a
    /// [`super::image::Operation`].
    Image { operation: u32 },
    /// End of a lane, which from here on only helps its neighbors.
    Kill,
    /// Jump to `target`.
    Jump { target: JumpTarget },
    /// Jump to `target` if the condition is `when`.
    JumpIf { condition: Slot, when: bool, target: JumpTarget },
    /// Jump to the target that the table of that number gives for the selector.
    Switch { selector: Slot, table: u32 },
    /// Jump to `target`, with the number of the next instruction left in `link`.
    Call { target: JumpTarget, link: Slot },
    /// Call of a function that gives the same result for the same arguments; the number is that of
    /// a [`PureCall`].
    CallPure { target: JumpTarget, link: Slot, call: u32 },
    /// Jump to the instruction whose number is in `link`.
    Return { link: Slot },
}

impl Instruction {
    /// Cost of the instruction, counted in [`super::FunctionOptions::step_limit`].
    #[inline(always)]
    pub(super) fn cost(self) -> u64 {
        match self {
            Self::CopyRun { count, .. }
            | Self::Clear { count, .. }
            | Self::Load { count, .. }
            | Self::LoadBuffer { count, .. } => u64::from(count),
            _ => 1,
        }
    }
}

/// Call of a function whose result depends on its arguments, constants and buffers alone, and whose
/// run is long: lanes with the same arguments can share one run, and later runs its result.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct PureCall {
    /// All slots of the arguments.
    pub(super) arguments: Vec<Slot>,
    /// First slot of the result, and number of its slots.
    pub(super) result: Slot,
    pub(super) result_slots: u32,
}

/// Jump table of a switch: the targets of the values of a selector.
#[derive(Clone, Debug, Default)]
pub(super) struct Switch {
    /// Values and their targets, sorted by value once the program is complete.
    pub(super) cases: Vec<(u32, JumpTarget)>,
    /// Target of all other values.
    pub(super) default: JumpTarget,
}

impl Switch {
    /// Target of a value.
    pub(super) fn target(&self, selector: u32) -> JumpTarget {
        let found = self.cases.binary_search_by_key(&selector, |case| case.0);
        found.map_or(self.default, |index| self.cases[index].1)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FloatUnary {
    Negate,
    Abs,
    Sign,
    Cos,
    Cosh,
    Sin,
    Sinh,
    Tan,
    Tanh,
    Acos,
    Asin,
    Atan,
    Asinh,
    Acosh,
    Atanh,
    Radians,
    Degrees,
    Ceil,
    Floor,
    Round,
    Fract,
    Trunc,
    FrexpFraction,
    Exp,
    Exp2,
    Log,
    Log2,
    Sqrt,
    InverseSqrt,
    QuantizeToF16,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FloatBinary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder,
    Min,
    Max,
    Step,
    Atan2,
    Pow,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Comparison {
    Equal,
    NotEqual,
    Less,
    LessEqual,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum IntUnary {
    /// Absolute value of an unsigned integer.
    Identity,
    Negate,
    Abs,
    Sign,
    Complement,
    LogicalNot,
    CountTrailingZeros,
    CountLeadingZeros,
    CountOneBits,
    ReverseBits,
    FirstTrailingBit,
    FirstLeadingBitSigned,
    FirstLeadingBitUnsigned,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum IntBinary {
    Add,
    Subtract,
    Multiply,
    DivideSigned,
    DivideUnsigned,
    RemainderSigned,
    RemainderUnsigned,
    And,
    Or,
    Xor,
    ShiftLeft,
    ShiftRightSigned,
    ShiftRightUnsigned,
    MinSigned,
    MinUnsigned,
    MaxSigned,
    MaxUnsigned,
    Equal,
    NotEqual,
    LessSigned,
    LessUnsigned,
    LessEqualSigned,
    LessEqualUnsigned,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ScalarConversion {
    /// Truncation with saturation; NaN gives 0.
    FloatToI32,
    /// Truncation with saturation; NaN gives 0.
    FloatToU32,
    /// True for a number that is not 0.
    FloatToBool,
    /// True for a number that is not 0.
    IntToBool,
    I32ToFloat,
    U32ToFloat,
    /// Bits of the nearest f32.
    FloatToBits,
    /// The f32 with these bits.
    BitsToFloat,
    FrexpExponent,
    IsNan,
    IsInf,
    ToSnorm8,
    ToUnorm8,
    ToSnorm16,
    ToUnorm16,
    ToHalf,
    FromSnorm8,
    FromUnorm8,
    FromSnorm16,
    FromUnorm16,
    FromHalf,
    /// Float rounded to f16, in f32 mode.
    HalfInSingle,
}

/// Difference within a 2x2 quad, whose lanes are (0, 0), (1, 0), (0, 1), (1, 1); y points down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Derivative {
    /// Difference along the lane's own row.
    FineX,
    /// Difference along the lane's own column.
    FineY,
    /// Difference along the first row.
    CoarseX,
    /// Difference along the first column.
    CoarseY,
}
