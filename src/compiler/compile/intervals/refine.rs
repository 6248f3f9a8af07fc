//! Refinement: the ranges that a condition implies for the values in it.

use naga::{BinaryOperator as Op, Expression, Handle, UnaryOperator};

use super::machine::{CallFrame, Knowledge, Machine, NoRanges, Outcome, PathState};
use super::range::{Floats, Range};

/// The depth to which a condition or a place is followed.
const MOST_DEPTH: usize = 8;

impl Machine<'_> {
    /// Narrows a state to where a condition is `is_on`; `false` where it never is.
    pub(super) fn assume(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        condition: Handle<Expression>,
        is_on: bool,
    ) -> Outcome<bool> {
        self.assume_within(frame, state, condition, is_on, 0)
    }

    fn assume_within(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        condition: Handle<Expression>,
        is_on: bool,
        depth: usize,
    ) -> Outcome<bool> {
        self.step()?;
        if depth > MOST_DEPTH {
            return Ok(true);
        }
        match frame.function.expressions[condition] {
            Expression::Unary { op: UnaryOperator::LogicalNot, expr } => {
                self.assume_within(frame, state, expr, !is_on, depth + 1)
            }
            Expression::Binary { op, left, right } => match (op, is_on) {
                (Op::LogicalAnd | Op::And, true) | (Op::LogicalOr | Op::InclusiveOr, false) => {
                    Ok(self.assume_within(frame, state, left, is_on, depth + 1)?
                        && self.assume_within(frame, state, right, is_on, depth + 1)?)
                }
                _ => self.assume_order(frame, state, op, left, right, is_on),
            },
            _ => Ok(true),
        }
    }

    fn assume_order(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        op: Op,
        left: Handle<Expression>,
        right: Handle<Expression>,
        is_on: bool,
    ) -> Outcome<bool> {
        let (a, b) = (self.value(frame, state, left)?, self.value(frame, state, right)?);
        let (&[Range::Float(a)], &[Range::Float(b)]) = (&*a, &*b) else { return Ok(true) };
        // A comparison that fails says nothing about order where a NaN may have made it fail.
        let has_nan = a.nan || b.nan;
        let op = match (op, is_on, has_nan) {
            (Op::NotEqual, false, _) => Op::Equal,
            (_, true, _) => op,
            (Op::Less, false, false) => Op::GreaterEqual,
            (Op::LessEqual, false, false) => Op::Greater,
            (Op::Greater, false, false) => Op::LessEqual,
            (Op::GreaterEqual, false, false) => Op::Less,
            _ => return Ok(true),
        };
        let any = Floats { nan: false, ..Floats::ALL };
        let (for_a, for_b) = match op {
            Op::Less => {
                (Floats { high: before(b.high), ..any }, Floats { low: after(a.low), ..any })
            }
            Op::LessEqual => (Floats { high: b.high, ..any }, Floats { low: a.low, ..any }),
            Op::Greater => {
                (Floats { low: after(b.low), ..any }, Floats { high: before(a.high), ..any })
            }
            Op::GreaterEqual => (Floats { low: b.low, ..any }, Floats { high: a.high, ..any }),
            Op::Equal => (Floats { nan: false, ..b }, Floats { nan: false, ..a }),
            _ => return Ok(true),
        };
        Ok(self.narrow(frame, state, left, 0, a.meet(for_a), 0)?
            && self.narrow(frame, state, right, 0, b.meet(for_b), 0)?)
    }

    /// Narrows the scalar at `index` of an expression, and of what it was taken from; `false` where
    /// nothing is left.
    fn narrow(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        handle: Handle<Expression>,
        index: usize,
        to: Floats,
        depth: usize,
    ) -> Outcome<bool> {
        if to.is_none() {
            return Ok(false);
        }
        if depth > MOST_DEPTH {
            return Ok(true);
        }
        if let Some(Knowledge::Value(ranges)) = &mut state.known[handle.index()] {
            let mut narrowed = ranges.to_vec();
            if let Some(Range::Float(old)) = narrowed.get_mut(index) {
                // A sign of zero that was told apart stays so.
                *old = Floats { minus_zero: old.minus_zero, ..old.meet(to) };
                if old.is_none() {
                    return Ok(false);
                }
            }
            *ranges = narrowed.into();
        }
        match frame.function.expressions[handle] {
            Expression::AccessIndex { base, index: part } => {
                let Some(Knowledge::Value(_)) = &state.known[base.index()] else { return Ok(true) };
                let inner = frame.info[base].ty.inner_with(&self.valid.module.types);
                let (start, _) = super::layout::part_of(&self.valid.module, inner, part as usize)
                    .ok_or(NoRanges)?;
                self.narrow(frame, state, base, start + index, to, depth + 1)
            }
            Expression::Load { pointer } => {
                let Knowledge::Pointer { local, at, .. } =
                    self.expression(frame, state, pointer)?
                else {
                    return Ok(true);
                };
                let is_current = state.loaded[handle.index()] == state.versions[local.index()];
                if let (true, [start]) = (is_current, &*at) {
                    let mut scalars = state.locals[local.index()].to_vec();
                    if let Some(Range::Float(old)) = scalars.get_mut(start + index) {
                        *old = Floats { minus_zero: old.minus_zero, ..old.meet(to) };
                        if old.is_none() {
                            return Ok(false);
                        }
                    }
                    state.locals[local.index()] = scalars.into();
                }
                Ok(true)
            }
            _ => Ok(true),
        }
    }
}

/// The largest f64 below; what holds for it holds for f32.
fn before(x: f64) -> f64 {
    if x == f64::NEG_INFINITY { f64::NAN } else { x.next_down() }
}

fn after(x: f64) -> f64 {
    if x == f64::INFINITY { f64::NAN } else { x.next_up() }
}
