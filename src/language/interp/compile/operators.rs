//! Operators, comparisons, selections and conversions.

use chiaro_locale::tr;
use naga::{
    BinaryOperator, Expression, Handle, RelationalFunction, ScalarKind as Kind, TypeInner,
    UnaryOperator,
};

use super::Outcome;
use super::layout::scalar_kind;
use super::statements::FunctionCompiler;
use crate::interp::ScalarKind;
use crate::interp::instruction::{
    Comparison, FloatBinary, FloatUnary, Instruction, IntBinary, IntUnary, ScalarConversion, Slot,
};

/// Binary operator on scalars of one kind.
enum Operation {
    Float(FloatBinary),
    Compare(Comparison),
    Int(IntBinary),
    /// Comparison with left and right exchanged.
    CompareSwapped(Comparison),
    IntSwapped(IntBinary),
}

impl FunctionCompiler<'_> {
    pub(super) fn unary(
        &mut self,
        op: UnaryOperator,
        expr: Handle<Expression>,
    ) -> Outcome<Vec<Slot>> {
        let float = self.kind(expr)? == ScalarKind::Float;
        let slots = self.value(expr)?;
        match op {
            UnaryOperator::Negate if float => {
                self.map(&slots, |this, a| this.float1(FloatUnary::Negate, a))
            }
            UnaryOperator::Negate => self.map(&slots, |this, a| this.int1(IntUnary::Negate, a)),
            UnaryOperator::LogicalNot => {
                self.map(&slots, |this, a| this.int1(IntUnary::LogicalNot, a))
            }
            UnaryOperator::BitwiseNot => {
                self.map(&slots, |this, a| this.int1(IntUnary::Complement, a))
            }
        }
    }

    pub(super) fn binary(
        &mut self,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Outcome<Vec<Slot>> {
        let (a, b) = (self.value(left)?, self.value(right)?);
        if op == BinaryOperator::Multiply {
            match (self.inner(left), self.inner(right)) {
                (TypeInner::Matrix { columns, .. }, TypeInner::Matrix { .. }) => {
                    return self.matrix_matrix(&a, &b, *columns as usize);
                }
                (TypeInner::Matrix { .. }, TypeInner::Vector { .. }) => {
                    return self.matrix_vector(&a, &b);
                }
                (TypeInner::Vector { .. }, TypeInner::Matrix { .. }) => {
                    return self.vector_matrix(&a, &b);
                }
                _ => {}
            }
        }
        let Some(operation) = operation(op, self.kind(left)?) else {
            return Err(
                self.unsupported(tr!("an operator on the wrong type (Binary)"), self.span(left))
            );
        };
        self.zip(&a, &b, |this, a, b| match operation {
            Operation::Float(op) => this.float2(op, a, b),
            Operation::Compare(op) => this.compare(op, a, b),
            Operation::CompareSwapped(op) => this.compare(op, b, a),
            Operation::Int(op) => this.int2(op, a, b),
            Operation::IntSwapped(op) => this.int2(op, b, a),
        })
    }

    pub(super) fn select_each(
        &mut self,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> Outcome<Vec<Slot>> {
        let condition = self.value(condition)?;
        let (accept, reject) = (self.value(accept)?, self.value(reject)?);
        let mut conditions = condition.iter().cycle();
        self.zip(&accept, &reject, |this, accept, reject| {
            let condition = conditions.next().copied().unwrap_or_default();
            this.compute(|to| Instruction::Select { to, condition, accept, reject })
        })
    }

    pub(super) fn relational(
        &mut self,
        fun: RelationalFunction,
        argument: Handle<Expression>,
    ) -> Outcome<Vec<Slot>> {
        let slots = self.value(argument)?;
        match fun {
            RelationalFunction::All => {
                Ok(vec![self.fold(&slots, |this, a, b| this.int2(IntBinary::And, a, b))?])
            }
            RelationalFunction::Any => {
                Ok(vec![self.fold(&slots, |this, a, b| this.int2(IntBinary::Or, a, b))?])
            }
            RelationalFunction::IsNan => {
                self.map(&slots, |this, a| this.convert(ScalarConversion::IsNan, a))
            }
            RelationalFunction::IsInf => {
                self.map(&slots, |this, a| this.convert(ScalarConversion::IsInf, a))
            }
        }
    }

    /// Converts the value if `by_value`, else reinterprets its bits.
    pub(super) fn cast(
        &mut self,
        expr: Handle<Expression>,
        to: Kind,
        by_value: bool,
    ) -> Outcome<Vec<Slot>> {
        let from = self.kind(expr)?;
        if !by_value && self.inner(expr).scalar().is_some_and(|scalar| scalar.width == 2) {
            return Err(self.unsupported(tr!("the bits of an f16 (As)"), self.span(expr)));
        }
        let to = match scalar_kind(naga::Scalar { kind: to, width: 4 }) {
            Ok(kind) => kind,
            Err(problem) => {
                return Err(self.locate(problem.diagnose(&self.subject()), self.span(expr)));
            }
        };
        let slots = self.value(expr)?;
        match conversion(from, to, by_value) {
            Some(op) => self.map(&slots, |this, a| this.convert(op, a)),
            None => Ok(slots.to_vec()),
        }
    }
}

/// Conversion from the slot of one kind to that of another; `None` if the bits are the same.
fn conversion(from: ScalarKind, to: ScalarKind, by_value: bool) -> Option<ScalarConversion> {
    use ScalarKind::{Bool, Float, I32, U32};
    match (from, to) {
        (Float, Float) | (Bool | I32 | U32, I32 | U32) | (Bool, Bool) => None,
        (Float, I32 | U32) if !by_value => Some(ScalarConversion::FloatToBits),
        (_, Float) if !by_value => Some(ScalarConversion::BitsToFloat),
        (Float, I32) => Some(ScalarConversion::FloatToI32),
        (Float, U32) => Some(ScalarConversion::FloatToU32),
        (Float, Bool) => Some(ScalarConversion::FloatToBool),
        (I32 | U32, Bool) => Some(ScalarConversion::IntToBool),
        (I32, Float) => Some(ScalarConversion::I32ToFloat),
        (Bool | U32, Float) => Some(ScalarConversion::U32ToFloat),
    }
}

/// Operation of an operator on scalars of this kind.
fn operation(op: BinaryOperator, kind: ScalarKind) -> Option<Operation> {
    match kind {
        ScalarKind::Float => float_operation(op),
        ScalarKind::I32 => int_operation(op, true),
        ScalarKind::U32 | ScalarKind::Bool => int_operation(op, false),
    }
}

fn float_operation(op: BinaryOperator) -> Option<Operation> {
    Some(match op {
        BinaryOperator::Add => Operation::Float(FloatBinary::Add),
        BinaryOperator::Subtract => Operation::Float(FloatBinary::Subtract),
        BinaryOperator::Multiply => Operation::Float(FloatBinary::Multiply),
        BinaryOperator::Divide => Operation::Float(FloatBinary::Divide),
        BinaryOperator::Modulo => Operation::Float(FloatBinary::Remainder),
        BinaryOperator::Equal => Operation::Compare(Comparison::Equal),
        BinaryOperator::NotEqual => Operation::Compare(Comparison::NotEqual),
        BinaryOperator::Less => Operation::Compare(Comparison::Less),
        BinaryOperator::LessEqual => Operation::Compare(Comparison::LessEqual),
        BinaryOperator::Greater => Operation::CompareSwapped(Comparison::Less),
        BinaryOperator::GreaterEqual => Operation::CompareSwapped(Comparison::LessEqual),
        _ => return None,
    })
}

fn int_operation(op: BinaryOperator, signed: bool) -> Option<Operation> {
    let either = |of_signed, of_unsigned| if signed { of_signed } else { of_unsigned };
    let less = either(IntBinary::LessSigned, IntBinary::LessUnsigned);
    let less_equal = either(IntBinary::LessEqualSigned, IntBinary::LessEqualUnsigned);
    Some(match op {
        BinaryOperator::Add => Operation::Int(IntBinary::Add),
        BinaryOperator::Subtract => Operation::Int(IntBinary::Subtract),
        BinaryOperator::Multiply => Operation::Int(IntBinary::Multiply),
        BinaryOperator::Divide => {
            Operation::Int(either(IntBinary::DivideSigned, IntBinary::DivideUnsigned))
        }
        BinaryOperator::Modulo => {
            Operation::Int(either(IntBinary::RemainderSigned, IntBinary::RemainderUnsigned))
        }
        BinaryOperator::And | BinaryOperator::LogicalAnd => Operation::Int(IntBinary::And),
        BinaryOperator::InclusiveOr | BinaryOperator::LogicalOr => Operation::Int(IntBinary::Or),
        BinaryOperator::ExclusiveOr => Operation::Int(IntBinary::Xor),
        BinaryOperator::ShiftLeft => Operation::Int(IntBinary::ShiftLeft),
        BinaryOperator::ShiftRight => {
            Operation::Int(either(IntBinary::ShiftRightSigned, IntBinary::ShiftRightUnsigned))
        }
        BinaryOperator::Equal => Operation::Int(IntBinary::Equal),
        BinaryOperator::NotEqual => Operation::Int(IntBinary::NotEqual),
        BinaryOperator::Less => Operation::Int(less),
        BinaryOperator::LessEqual => Operation::Int(less_equal),
        BinaryOperator::Greater => Operation::IntSwapped(less),
        BinaryOperator::GreaterEqual => Operation::IntSwapped(less_equal),
    })
}
