//! Operators, selections and WGSL's own functions, without those that ranges prove to change
//! nothing.

use naga::common::wgsl::TryToWgsl as _;
use naga::{BinaryOperator as Op, Expression, Handle, TypeInner, UnaryOperator};

use super::{FunctionWriter, NotWritten, WriteResult};
use crate::compile::functions::code::{Code, is_scalar, width_of};
use crate::compile::functions::print::level;
use crate::compile::intervals::Floats;

impl FunctionWriter<'_> {
    pub(super) fn unary(&mut self, op: UnaryOperator, of: Handle<Expression>) -> WriteResult<Code> {
        let code = self.code(of)?;
        Ok(match op {
            UnaryOperator::Negate => Code::Unary("-", Box::new(code)),
            UnaryOperator::LogicalNot => negated(code),
            UnaryOperator::BitwiseNot => Code::Unary("~", Box::new(code)),
        })
    }

    pub(super) fn binary(
        &mut self,
        op: Op,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> WriteResult<Code> {
        let operator = match op {
            Op::Add => "+",
            Op::Subtract => "-",
            Op::Multiply => "*",
            Op::Divide => "/",
            Op::Modulo => "%",
            Op::Equal => "==",
            Op::NotEqual => "!=",
            Op::Less => "<",
            Op::LessEqual => "<=",
            Op::Greater => ">",
            Op::GreaterEqual => ">=",
            Op::And => "&",
            Op::ExclusiveOr => "^",
            Op::InclusiveOr => "|",
            Op::LogicalAnd => "&&",
            Op::LogicalOr => "||",
            Op::ShiftLeft => "<<",
            Op::ShiftRight => ">>",
        };
        // What `false | x` and `true & x` are.
        let neutral = match op {
            Op::InclusiveOr | Op::LogicalOr => Some(false),
            Op::And | Op::LogicalAnd => Some(true),
            _ => None,
        };
        if neutral.is_some() && self.is_truth(left) {
            for (known, other) in [(left, right), (right, left)] {
                if self.truth(known) == neutral {
                    self.is_changed = true;
                    return self.code(other);
                }
            }
        }
        let is_one = |x: Floats| x.point() == Some(1.0);
        let is_matrix =
            |handle: Handle<Expression>| matches!(self.inner(handle), TypeInner::Matrix { .. });
        let is_plain = !is_matrix(left) && !is_matrix(right);
        let count = |handle| self.ranges(handle).map_or(0, |ranges| ranges.len());
        let (of_left, of_right) = (count(left), count(right));
        let same_shape = of_left == of_right;
        if is_plain && matches!(op, Op::Multiply | Op::Divide) {
            let (may_leave_left, may_leave_right) =
                (same_shape || of_left == 1, same_shape || of_right == 1);
            if may_leave_right && self.is_all(right, is_one) {
                self.is_changed = true;
                return self.code(left);
            }
            if op == Op::Multiply && may_leave_left && self.is_all(left, is_one) {
                self.is_changed = true;
                return self.code(right);
            }
        }
        if is_plain && same_shape && op == Op::Add {
            // -0 + 0 is 0.
            let is_zero = |x: Floats| x.point() == Some(0.0);
            let has_sign = |x: Floats| !x.minus_zero;
            if self.is_all(right, is_zero) && self.is_all(left, has_sign) {
                self.is_changed = true;
                return self.code(left);
            }
            if self.is_all(left, is_zero) && self.is_all(right, has_sign) {
                self.is_changed = true;
                return self.code(right);
            }
        }
        let is_arithmetic =
            matches!(op, Op::Add | Op::Subtract | Op::Multiply | Op::Divide | Op::Modulo);
        // A scalar beside a vector, for which naga has made a vector of it.
        let scalar = |handle: Handle<Expression>| match self.function.expressions[handle] {
            Expression::Splat { value, .. } if is_arithmetic => Some(value),
            _ => None,
        };
        let is_vector =
            |handle: Handle<Expression>| matches!(self.inner(handle), TypeInner::Vector { .. });
        let (of_left, of_right) = (is_vector(left), is_vector(right));
        let (a, b) = match (scalar(left), scalar(right)) {
            (Some(a), None) if of_right => (a, right),
            (None, Some(b)) if of_left => (left, b),
            _ => (left, right),
        };
        let is_whole = scalar(left).is_none() && scalar(right).is_none();
        let (a, b) = (self.code(a)?, self.code(b)?);
        let is_plain = is_arithmetic && is_whole && of_left && of_right;
        let (a, b) = if is_plain { scalars_beside(a, b) } else { (a, b) };
        Ok(Code::Binary(operator, Box::new(a), Box::new(b)).simplified())
    }

    pub(super) fn select(
        &mut self,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> WriteResult<Code> {
        let ranges = self.ranges(condition);
        let truths: Option<Vec<bool>> =
            ranges.and_then(|ranges| ranges.iter().map(|range| range.truth()).collect());
        if let Some(truths) = truths
            && let Some(&first) = truths.first()
            && truths.iter().all(|truth| *truth == first)
        {
            self.is_changed = true;
            return self.code(if first { accept } else { reject });
        }
        let parts = vec![self.code(reject)?, self.code(accept)?, self.code(condition)?];
        if parts[0] == parts[1] {
            self.is_changed = true;
            return Ok(parts[0].clone());
        }
        Ok(Code::BuiltIn("select".into(), parts))
    }

    /// The number that an expression is the square of, where that is not negative, nor so large
    /// that its square is infinite.
    fn squared(&self, handle: Handle<Expression>) -> Option<Handle<Expression>> {
        let Expression::Binary { op: Op::Multiply, left, right } =
            self.function.expressions[handle]
        else {
            return None;
        };
        let is_safe = |x: Floats| x.is_positive() && x.is_within(0.0, 1e18);
        (left == right && self.is_all(left, is_safe)).then_some(left)
    }

    pub(super) fn math(
        &mut self,
        fun: naga::MathFunction,
        first: Handle<Expression>,
        rest: &[Handle<Expression>],
    ) -> WriteResult<Code> {
        use naga::MathFunction as Math;
        let ordered =
            |lowest: Option<Handle<Expression>>, x, highest: Option<Handle<Expression>>| {
                let Some(x) = self.floats(x) else { return (false, false) };
                let bounds = |of: Option<Handle<Expression>>| of.and_then(|of| self.floats(of));
                let all = |other: Option<Vec<Floats>>, holds: fn(Floats, Floats) -> bool| {
                    other.is_some_and(|other| {
                        other.len() == x.len() && x.iter().zip(other).all(|(x, o)| holds(*x, o))
                    })
                };
                let is_above = all(bounds(lowest), |x, low| {
                    !x.nan && !low.nan && x.low >= low.high && !x.is_none()
                });
                let is_below = all(bounds(highest), |x, high| {
                    !x.nan && !high.nan && x.high <= high.low && !x.is_none()
                });
                (is_above, is_below)
            };
        let kept = match (fun, rest) {
            (Math::Max, &[other]) => {
                let (is_first, is_second) =
                    (ordered(Some(other), first, None).0, ordered(Some(first), other, None).0);
                if is_first { Some(first) } else { is_second.then_some(other) }
            }
            (Math::Min, &[other]) => {
                let (is_first, is_second) =
                    (ordered(None, first, Some(other)).1, ordered(None, other, Some(first)).1);
                if is_first { Some(first) } else { is_second.then_some(other) }
            }
            (Math::Sqrt, []) => self.squared(first),
            (Math::Abs, []) => self.is_all(first, Floats::is_positive).then_some(first),
            (Math::Saturate, []) => {
                self.is_all(first, |x| x.is_within(0.0, 1.0) && x.is_positive()).then_some(first)
            }
            (Math::Clamp, &[low, high]) => match ordered(Some(low), first, Some(high)) {
                (true, true) => Some(first),
                (true, false) if self.floats(first).is_some() => {
                    self.is_changed = true;
                    let parts = vec![self.code(first)?, self.code(high)?];
                    return Ok(Code::BuiltIn("min".into(), parts));
                }
                (false, true) if self.floats(first).is_some() => {
                    self.is_changed = true;
                    let parts = vec![self.code(first)?, self.code(low)?];
                    return Ok(Code::BuiltIn("max".into(), parts));
                }
                _ => None,
            },
            _ => None,
        };
        if let Some(kept) = kept {
            self.is_changed = true;
            return self.code(kept);
        }
        let name = fun.try_to_wgsl().ok_or(NotWritten)?;
        let mut parts = vec![self.code(first)?];
        for &other in rest {
            parts.push(self.code(other)?);
        }
        let is_splat = |handle: &Handle<Expression>| {
            matches!(self.function.expressions[*handle], Expression::Splat { .. })
        };
        if fun == Math::Mix
            && let Some(Code::BuiltIn(kind, splat)) = parts.last()
            && let [one] = splat.as_slice()
            && width_of(kind).is_some()
            && (is_scalar(one) || rest.last().is_some_and(is_splat))
        {
            let one = one.clone();
            parts.pop();
            parts.push(one);
        }
        Ok(Code::BuiltIn(name.into(), parts))
    }
}

/// A scalar in place of a vector of it, beside a vector that is none itself.
fn scalars_beside(a: Code, b: Code) -> (Code, Code) {
    let splat = |code: &Code| match code {
        Code::BuiltIn(kind, parts) if parts.len() == 1 && width_of(kind).is_some() => {
            match &parts[0] {
                Code::Text(text, _) if text.parse::<f64>().is_ok() => Some(parts[0].clone()),
                _ => None,
            }
        }
        _ => None,
    };
    match (splat(&a), splat(&b)) {
        (Some(a), None) => (a, b),
        (None, Some(b)) => (a, b),
        _ => (a, b),
    }
}

/// The opposite of a condition.
pub(super) fn negated(code: Code) -> Code {
    if let Some(known) = code.truth() {
        return Code::Text((!known).to_string().into(), level::ATOM);
    }
    match code {
        Code::Unary("!", inner) => *inner,
        // Equality alone is the opposite of its opposite for NaN too.
        Code::Binary("==", a, b) => Code::Binary("!=", a, b),
        Code::Binary("!=", a, b) => Code::Binary("==", a, b),
        other => Code::Unary("!", Box::new(other)),
    }
}
