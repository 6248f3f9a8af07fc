//! The ranges of expressions.

use naga::{
    BinaryOperator as Op, Expression, Handle, Literal, ScalarKind, TypeInner, UnaryOperator,
};

use super::layout::{part_of, parts_of, scalars_of, tops_of, zeros_of};
use super::machine::{
    CallFrame, Knowledge, Machine, NoRanges, Outcome, PathState, Ranges, joined_ranges,
};
use super::range::{Bools, Floats, Ints, Length, Range};

impl<'m> Machine<'m> {
    /// The ranges of an expression that is no pointer.
    pub(super) fn value(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        handle: Handle<Expression>,
    ) -> Outcome<Ranges> {
        match self.expression(frame, state, handle)? {
            Knowledge::Value(ranges) => Ok(ranges),
            _ => Err(NoRanges),
        }
    }

    /// The knowledge of an expression, evaluated once for a state.
    pub(super) fn expression(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        handle: Handle<Expression>,
    ) -> Outcome<Knowledge> {
        if let Some(known) = &state.known[handle.index()] {
            return Ok(known.clone());
        }
        self.step()?;
        let known = self.evaluate(frame, state, handle)?;
        if frame.is_traced {
            self.record(handle, &known);
        }
        state.known[handle.index()] = Some(known.clone());
        Ok(known)
    }

    fn inner<'f>(&self, frame: CallFrame<'f>, handle: Handle<Expression>) -> &'f TypeInner
    where
        'm: 'f,
    {
        frame.info[handle].ty.inner_with(&self.valid.module.types)
    }

    fn evaluate(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        handle: Handle<Expression>,
    ) -> Outcome<Knowledge> {
        let module = &self.valid.module;
        let ranges = match &frame.function.expressions[handle] {
            Expression::Literal(literal) => vec![literal_range(*literal)?],
            Expression::Constant(constant) => self.global(module.constants[*constant].init)?,
            Expression::ZeroValue(ty) => {
                let ty = &module.types[*ty].inner;
                let zeros = zeros_of(module, ty).ok_or(NoRanges)?;
                let is_vector = matches!(ty, TypeInner::Vector { .. });
                if is_vector { super::range::with_length(zeros) } else { zeros }
            }
            Expression::Compose { components, .. } => {
                let mut all = Vec::new();
                for &component in components {
                    all.extend_from_slice(&self.value(frame, state, component)?);
                }
                match self.inner(frame, handle) {
                    TypeInner::Vector { .. } => super::range::with_length(all),
                    _ => all,
                }
            }
            Expression::Splat { size, value } => {
                let value = self.value(frame, state, *value)?;
                super::range::with_length(vec![
                    value.first().ok_or(NoRanges)?.alone();
                    *size as usize
                ])
            }
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.value(frame, state, *vector)?;
                let is_whole = *size as usize == vector.len()
                    && pattern.iter().take(vector.len()).enumerate().all(|(i, &c)| c as usize == i);
                if is_whole {
                    return Ok(Knowledge::Value(vector));
                }
                let taken = pattern
                    .iter()
                    .take(*size as usize)
                    .map(|&c| vector.get(c as usize).map(|range| range.alone()));
                taken.collect::<Option<Vec<_>>>().ok_or(NoRanges)?
            }
            Expression::LocalVariable(local) => {
                let count = state.locals[local.index()].len();
                return Ok(Knowledge::Pointer { local: *local, at: [0].into(), count });
            }
            Expression::GlobalVariable(_) => return Ok(Knowledge::Elsewhere),
            Expression::AccessIndex { base, index } => {
                let index = *index as usize;
                return self.access(frame, state, *base, index..index + 1);
            }
            Expression::Access { base, index } => {
                let [Range::Int(index)] = *self.value(frame, state, *index)? else {
                    return Err(NoRanges);
                };
                let (count, _) = self.parts(frame, *base).ok_or(NoRanges)?;
                // An index out of bounds gives any part.
                let whole = 0..count;
                let is_inside = index.low >= 0 && (index.high as usize) < count;
                let range =
                    if is_inside { index.low as usize..index.high as usize + 1 } else { whole };
                return self.access(frame, state, *base, range);
            }
            Expression::Load { pointer } => return self.load(frame, state, handle, *pointer),
            Expression::Unary { op, expr } => {
                let value = self.value(frame, state, *expr)?;
                value.iter().map(|&x| unary(*op, x)).collect::<Outcome<Vec<_>>>()?
            }
            Expression::Binary { op, left, right } => {
                self.binary(frame, state, *op, *left, *right)?
            }
            Expression::Select { condition, accept, reject } => {
                self.select(frame, state, *condition, *accept, *reject)?
            }
            Expression::Derivative { expr, .. } => {
                let value = self.value(frame, state, *expr)?;
                value.iter().map(|&x| derivative(x)).collect::<Outcome<Vec<_>>>()?
            }
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                let others = [*arg1, *arg2, *arg3];
                self.math(frame, state, handle, *fun, *arg, others)?
            }
            Expression::As { expr, kind, convert } => {
                let value = self.value(frame, state, *expr)?;
                value
                    .iter()
                    .map(|&x| cast(x, *kind, convert.is_some()))
                    .collect::<Outcome<Vec<_>>>()?
            }
            // Images are 8 bits a channel, from 0 to 1, and filtering stays between.
            Expression::ImageSample { depth_ref: None, .. } => {
                vec![Range::Float(Floats::between(0.0, 1.0)); self.scalars(frame, handle)?]
            }
            Expression::FunctionArgument(_) | Expression::CallResult(_) => return Err(NoRanges),
            _ => self.tops(frame, handle)?,
        };
        Ok(Knowledge::Value(ranges.into()))
    }

    fn scalars(&self, frame: CallFrame<'_>, handle: Handle<Expression>) -> Outcome<usize> {
        scalars_of(&self.valid.module, self.inner(frame, handle)).ok_or(NoRanges)
    }

    /// Anything of an expression's type.
    pub(super) fn tops(
        &self,
        frame: CallFrame<'_>,
        handle: Handle<Expression>,
    ) -> Outcome<Vec<Range>> {
        tops_of(&self.valid.module, self.inner(frame, handle)).ok_or(NoRanges)
    }

    fn global(&mut self, handle: Handle<Expression>) -> Outcome<Vec<Range>> {
        self.step()?;
        let module = &self.valid.module;
        Ok(match &module.global_expressions[handle] {
            Expression::Literal(literal) => vec![literal_range(*literal)?],
            Expression::Constant(constant) => self.global(module.constants[*constant].init)?,
            Expression::ZeroValue(ty) => {
                zeros_of(module, &module.types[*ty].inner).ok_or(NoRanges)?
            }
            Expression::Compose { components, .. } => {
                let mut all = Vec::new();
                for &component in components {
                    all.extend(self.global(component)?);
                }
                all
            }
            Expression::Splat { size, value } => {
                let value = self.global(*value)?;
                vec![*value.first().ok_or(NoRanges)?; *size as usize]
            }
            _ => return Err(NoRanges),
        })
    }

    /// The type that an expression has, or that it points at.
    fn pointee<'f>(&self, frame: CallFrame<'f>, handle: Handle<Expression>) -> Option<&'f TypeInner>
    where
        'm: 'f,
    {
        match self.inner(frame, handle) {
            TypeInner::Pointer { base, .. } => Some(&self.valid.module.types[*base].inner),
            TypeInner::ValuePointer { .. } => None,
            inner => Some(inner),
        }
    }

    fn parts(&self, frame: CallFrame<'_>, handle: Handle<Expression>) -> Option<(usize, usize)> {
        match self.inner(frame, handle) {
            TypeInner::ValuePointer { size, .. } => size.map(|size| (size as usize, 1)),
            _ => parts_of(&self.valid.module, self.pointee(frame, handle)?),
        }
    }

    /// The parts `which` of a value, joined, or a pointer to them.
    fn access(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        base: Handle<Expression>,
        which: std::ops::Range<usize>,
    ) -> Outcome<Knowledge> {
        let known = self.expression(frame, state, base)?;
        let part = |index: usize| match self.inner(frame, base) {
            TypeInner::ValuePointer { .. } => Some((index, 1)),
            _ => part_of(&self.valid.module, self.pointee(frame, base)?, index),
        };
        let places = which.map(part).collect::<Option<Vec<_>>>().ok_or(NoRanges)?;
        let size = places.first().ok_or(NoRanges)?.1;
        match known {
            Knowledge::Value(ranges) => {
                let mut all: Option<Vec<Range>> = None;
                for (start, size) in places {
                    let one = ranges.get(start..start + size).ok_or(NoRanges)?;
                    all = Some(match all {
                        Some(known) => joined_ranges(&known, one)?,
                        None => one.to_vec(),
                    });
                }
                let mut all = all.ok_or(NoRanges)?;
                if let [one] = all.as_mut_slice() {
                    *one = one.alone();
                }
                Ok(Knowledge::Value(all.into()))
            }
            Knowledge::Pointer { local, at, .. } => {
                if at.len() * places.len() > 256 {
                    return Err(NoRanges);
                }
                let into =
                    at.iter().flat_map(|from| places.iter().map(move |(start, _)| from + start));
                Ok(Knowledge::Pointer { local, at: into.collect(), count: size })
            }
            Knowledge::Elsewhere => Ok(Knowledge::Elsewhere),
        }
    }

    fn load(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        handle: Handle<Expression>,
        pointer: Handle<Expression>,
    ) -> Outcome<Knowledge> {
        match self.expression(frame, state, pointer)? {
            Knowledge::Pointer { local, at, count } => {
                let scalars = &state.locals[local.index()];
                let mut all: Option<Vec<Range>> = None;
                for &start in at.iter() {
                    let one = scalars.get(start..start + count).ok_or(NoRanges)?;
                    all = Some(match all {
                        Some(known) => joined_ranges(&known, one)?,
                        None => one.to_vec(),
                    });
                }
                state.loaded[handle.index()] = state.versions[local.index()];
                let mut all = all.ok_or(NoRanges)?;
                if let [one] = all.as_mut_slice() {
                    *one = one.alone();
                }
                Ok(Knowledge::Value(all.into()))
            }
            Knowledge::Elsewhere => Ok(Knowledge::Value(self.tops(frame, handle)?.into())),
            Knowledge::Value(_) => Err(NoRanges),
        }
    }

    fn select(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> Outcome<Vec<Range>> {
        let known = self.value(frame, state, condition)?;
        let (on, off) = (self.value(frame, state, accept)?, self.value(frame, state, reject)?);
        if let [Range::Bool(one)] = *known {
            return match one.point() {
                Some(true) => Ok(on.to_vec()),
                Some(false) => Ok(off.to_vec()),
                None => self.open_select(frame, state, condition, accept, reject),
            };
        }
        if known.len() != on.len() || on.len() != off.len() {
            return Err(NoRanges);
        }
        let pick = |((known, on), off): ((&Range, &Range), &Range)| match known {
            Range::Bool(known) => match known.point() {
                Some(true) => Ok(on.alone()),
                Some(false) => Ok(off.alone()),
                None => on.alone().join(off.alone()).ok_or(NoRanges),
            },
            _ => Err(NoRanges),
        };
        known.iter().zip(on.iter()).zip(off.iter()).map(pick).collect()
    }

    /// Either, each with what the condition tells about it.
    fn open_select(
        &mut self,
        frame: CallFrame<'_>,
        state: &PathState,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> Outcome<Vec<Range>> {
        // Both arms are evaluated whatever the condition says, and are on record already.
        let frame = CallFrame { is_traced: false, ..frame };
        let mut all: Option<Vec<Range>> = None;
        for (is_on, arm) in [(true, accept), (false, reject)] {
            let mut way = state.clone();
            if !self.assume(frame, &mut way, condition, is_on)? {
                continue;
            }
            let one = self.value(frame, &mut way, arm)?;
            all = Some(match all {
                Some(known) => joined_ranges(&known, &one)?,
                None => one.to_vec(),
            });
        }
        all.ok_or(NoRanges)
    }

    fn binary(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        op: Op,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Outcome<Vec<Range>> {
        let (a, b) = (self.value(frame, state, left)?, self.value(frame, state, right)?);
        if op == Op::Multiply {
            let shapes = (self.inner(frame, left), self.inner(frame, right));
            if let Some(product) = matrix_product(shapes, &a, &b)? {
                return Ok(product);
            }
        }
        let is_signed = matches!(
            self.inner(frame, left),
            TypeInner::Scalar(scalar) | TypeInner::Vector { scalar, .. }
                if scalar.kind == ScalarKind::Sint
        );
        if let Some(known) = related(frame, op, left, right, &a)? {
            return Ok(known);
        }
        zip(&a, &b, |a, b| binary(op, a, b, is_signed))
    }
}

/// Applies `f` to the scalars of both, repeating a single one.
pub(super) fn zip(
    a: &[Range],
    b: &[Range],
    f: impl Fn(Range, Range) -> Outcome<Range>,
) -> Outcome<Vec<Range>> {
    match (a, b) {
        ([], _) | (_, []) => Err(NoRanges),
        ([one], _) => b.iter().map(|&b| f(*one, b)).collect(),
        (_, [one]) => a.iter().map(|&a| f(a, *one)).collect(),
        _ if a.len() == b.len() => a.iter().zip(b).map(|(&a, &b)| f(a, b)).collect(),
        _ => Err(NoRanges),
    }
}

/// The range of two operands that depend on each other: a square is no less than 0, and a number
/// differs little from its own whole part.
fn related(
    frame: CallFrame<'_>,
    op: Op,
    left: Handle<Expression>,
    right: Handle<Expression>,
    a: &[Range],
) -> Outcome<Option<Vec<Range>>> {
    let floats = |of: &dyn Fn(Floats) -> Floats| {
        let each = a
            .iter()
            .map(|x| if let Range::Float(x) = x { Some(Range::Float(of(*x))) } else { None });
        each.collect::<Option<Vec<_>>>()
    };
    if op == Op::Multiply && left == right {
        return Ok(floats(&Floats::squared));
    }
    if op != Op::Subtract {
        return Ok(None);
    }
    let Expression::Math { fun, arg, .. } = frame.function.expressions[right] else {
        return Ok(None);
    };
    let rest = match fun {
        naga::MathFunction::Floor => Floats::between(0.0, 1.0),
        naga::MathFunction::Round => Floats::between(-0.5, 0.5),
        naga::MathFunction::Trunc => Floats::between(-1.0, 1.0),
        _ => return Ok(None),
    };
    if arg != left {
        return Ok(None);
    }
    Ok(floats(&|x: Floats| {
        if x.low == x.high {
            return x.sub(x.rising(match fun {
                naga::MathFunction::Floor => f64::floor,
                naga::MathFunction::Round => f64::round_ties_even,
                _ => f64::trunc,
            }));
        }
        rest.with_nan(x.nan || x.may_be_infinite())
    }))
}

fn matrix_product(
    shapes: (&TypeInner, &TypeInner),
    a: &[Range],
    b: &[Range],
) -> Outcome<Option<Vec<Range>>> {
    let (rows, inner, columns) = match shapes {
        (TypeInner::Matrix { columns, rows, .. }, TypeInner::Vector { .. }) => {
            (*rows as usize, *columns as usize, 1)
        }
        (TypeInner::Vector { size, .. }, TypeInner::Matrix { columns, .. }) => {
            (1, *size as usize, *columns as usize)
        }
        (TypeInner::Matrix { columns, rows, .. }, TypeInner::Matrix { columns: of_b, .. }) => {
            (*rows as usize, *columns as usize, *of_b as usize)
        }
        _ => return Ok(None),
    };
    let mut product = Vec::with_capacity(rows * columns);
    for column in 0..columns {
        for row in 0..rows {
            let mut sum: Option<Floats> = None;
            for i in 0..inner {
                let (Some(Range::Float(x)), Some(Range::Float(y))) =
                    (a.get(i * rows + row), b.get(column * inner + i))
                else {
                    return Err(NoRanges);
                };
                let term = x.mul(*y);
                sum = Some(sum.map_or(term, |sum| sum.add(term)));
            }
            product.push(Range::Float(sum.ok_or(NoRanges)?));
        }
    }
    Ok(Some(product))
}

/// The numbers that may have been written where naga read `x`: at f64 a constant is any number that
/// rounds to `x`. Numbers of so few digits that their last bits are 0 are what they say.
fn written(x: f32) -> Floats {
    const PLAIN: u32 = 8;
    if !x.is_normal() || x.to_bits().trailing_zeros() >= PLAIN {
        return Floats::constant(x.into());
    }
    let middle = |other: f32| 0.5 * (f64::from(x) + f64::from(other));
    Floats::between(middle(x.next_down()), middle(x.next_up()))
}

fn literal_range(literal: Literal) -> Outcome<Range> {
    Ok(match literal {
        Literal::F32(x) => Range::Float(written(x)),
        Literal::F64(x) | Literal::AbstractFloat(x) => Range::Float(Floats::constant(x)),
        Literal::U32(x) => Range::Int(Ints::between(x.into(), x.into())),
        Literal::I32(x) => Range::Int(Ints::between(x.into(), x.into())),
        Literal::AbstractInt(x) => Range::Int(Ints::between(x, x)),
        Literal::Bool(x) => Range::Bool(Bools::of(x)),
        _ => return Err(NoRanges),
    })
}

fn unary(op: UnaryOperator, x: Range) -> Outcome<Range> {
    Ok(match (op, x) {
        (UnaryOperator::Negate, Range::Float(x)) => Range::Float(x.neg()),
        (UnaryOperator::Negate, Range::Int(x)) => Range::Int(Ints::wrapped(-x.high, -x.low, true)),
        (UnaryOperator::LogicalNot, Range::Bool(x)) => Range::Bool(x.not()),
        (UnaryOperator::BitwiseNot, Range::Int(x)) if x.low < 0 => Range::Int(Ints::all(true)),
        // The type is lost here; both kinds together hold either.
        (UnaryOperator::BitwiseNot, Range::Int(_)) => {
            Range::Int(Ints::between(i32::MIN.into(), u32::MAX.into()))
        }
        _ => return Err(NoRanges),
    })
}

fn binary(op: Op, a: Range, b: Range, is_signed: bool) -> Outcome<Range> {
    match (a, b) {
        (Range::Float(a), Range::Float(b)) => float_binary(op, a, b),
        (Range::Int(a), Range::Int(b)) => int_binary(op, a, b, is_signed),
        (Range::Bool(a), Range::Bool(b)) => {
            let (one, other) = (a.point(), b.point());
            Ok(Range::Bool(match op {
                Op::LogicalAnd | Op::And => Bools {
                    may_be_false: a.may_be_false || b.may_be_false,
                    may_be_true: a.may_be_true && b.may_be_true,
                },
                Op::LogicalOr | Op::InclusiveOr => Bools {
                    may_be_false: a.may_be_false && b.may_be_false,
                    may_be_true: a.may_be_true || b.may_be_true,
                },
                Op::Equal | Op::NotEqual => match (one, other) {
                    (Some(a), Some(b)) => Bools::of((a == b) == (op == Op::Equal)),
                    _ => Bools::ALL,
                },
                _ => return Err(NoRanges),
            }))
        }
        _ => Err(NoRanges),
    }
}

fn float_binary(op: Op, a: Floats, b: Floats) -> Outcome<Range> {
    Ok(Range::Float(match op {
        Op::Add => a.add(b),
        Op::Subtract => a.sub(b),
        Op::Multiply => a.mul(b),
        Op::Divide => a.div(b),
        Op::Modulo => {
            // No larger than either, and of the first one's sign.
            let size = a.abs().high.min(b.abs().high);
            let nan = a.nan || b.nan || b.has(0.0) || a.may_be_infinite();
            Floats {
                low: if a.low < 0.0 { -size } else { 0.0 },
                high: if a.high > 0.0 { size } else { 0.0 },
                nan,
                minus_zero: true,
                length: Length::Any,
            }
        }
        _ => return Ok(Range::Bool(compare(op, a, b)?)),
    }))
}

/// Comparisons of floats; with NaN only `!=` is true.
fn compare(op: Op, a: Floats, b: Floats) -> Outcome<Bools> {
    let may_be_nan = a.nan || b.nan;
    let is_empty = a.is_none() || b.is_none();
    let less = |a: Floats, b: Floats| Bools {
        may_be_true: !is_empty && a.low < b.high,
        may_be_false: is_empty || a.high >= b.low,
    };
    let at_most = |a: Floats, b: Floats| Bools {
        may_be_true: !is_empty && a.low <= b.high,
        may_be_false: is_empty || a.high > b.low,
    };
    let equal = Bools {
        may_be_true: !is_empty && a.low <= b.high && b.low <= a.high,
        may_be_false: is_empty || a.low != a.high || b.low != b.high || a.low != b.low,
    };
    let or_nan = |known: Bools| Bools { may_be_false: known.may_be_false || may_be_nan, ..known };
    Ok(match op {
        Op::Less => or_nan(less(a, b)),
        Op::LessEqual => or_nan(at_most(a, b)),
        Op::Greater => or_nan(less(b, a)),
        Op::GreaterEqual => or_nan(at_most(b, a)),
        Op::Equal => or_nan(equal),
        Op::NotEqual => or_nan(equal).not(),
        _ => return Err(NoRanges),
    })
}

fn int_binary(op: Op, a: Ints, b: Ints, is_signed: bool) -> Outcome<Range> {
    let all = Ints::all(is_signed);
    let bools = |may_be_true: bool, may_be_false: bool| {
        Ok(Range::Bool(Bools { may_be_false, may_be_true }))
    };
    let corners = |of: fn(i64, i64) -> i64| {
        let all = [of(a.low, b.low), of(a.low, b.high), of(a.high, b.low), of(a.high, b.high)];
        let (low, high) =
            all.iter().fold((i64::MAX, i64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
        Ints::wrapped(low, high, is_signed)
    };
    Ok(Range::Int(match op {
        Op::Add => corners(i64::wrapping_add),
        Op::Subtract => corners(i64::wrapping_sub),
        Op::Multiply => match (a.high.checked_mul(b.high), a.low.checked_mul(b.low)) {
            (Some(_), Some(_)) => corners(i64::saturating_mul),
            _ => all,
        },
        Op::Divide if b.low > 0 => corners(|a, b| a / b),
        Op::Modulo if b.low > 0 => {
            let most = b.high - 1;
            Ints::between(
                if a.low < 0 { -most } else { 0 },
                if a.high > 0 { most.min(a.high) } else { 0 },
            )
        }
        Op::And => match (a.point(), b.point()) {
            (Some(a), Some(b)) => Ints::wrapped(a & b, a & b, is_signed),
            (Some(mask), _) => masked(b, mask, all),
            (_, Some(mask)) => masked(a, mask, all),
            _ => all,
        },
        Op::InclusiveOr | Op::ExclusiveOr => match (a.point(), b.point()) {
            (Some(x), Some(y)) => {
                let bits = if op == Op::InclusiveOr { x | y } else { x ^ y };
                Ints::wrapped(bits, bits, is_signed)
            }
            _ => all,
        },
        Op::ShiftLeft => match b.point() {
            Some(by @ 0..=31) => Ints::wrapped(a.low << by, a.high << by, is_signed),
            _ => all,
        },
        Op::ShiftRight => match b.point() {
            Some(by @ 0..=31) => Ints::between(a.low >> by, a.high >> by),
            _ => all,
        },
        Op::Equal => {
            return bools(
                a.low <= b.high && b.low <= a.high,
                a.point().is_none() || a.point() != b.point(),
            );
        }
        Op::NotEqual => {
            return bools(
                a.point().is_none() || a.point() != b.point(),
                a.low <= b.high && b.low <= a.high,
            );
        }
        Op::Less => return bools(a.low < b.high, a.high >= b.low),
        Op::LessEqual => return bools(a.low <= b.high, a.high > b.low),
        Op::Greater => return bools(a.high > b.low, a.low <= b.high),
        Op::GreaterEqual => return bools(a.high >= b.low, a.low < b.high),
        _ => all,
    }))
}

/// Bits under a mask: those of a float's size keep their order.
fn masked(x: Ints, mask: i64, all: Ints) -> Ints {
    let keeps_order = mask == 0x7fff_ffff || mask == 0x7f80_0000;
    if keeps_order {
        return Ints::between(x.magnitude[0] & mask, x.magnitude[1] & mask);
    }
    if mask < 0 {
        return all;
    }
    let most = if x.low >= 0 { mask.min(x.high) } else { mask };
    Ints::between(0, most)
}

/// The range of a derivative: a value differs between pixels by no more than its range is wide.
fn derivative(x: Range) -> Outcome<Range> {
    let Range::Float(x) = x else { return Err(NoRanges) };
    if x.point().is_some() {
        return Ok(Range::Float(Floats::ZERO));
    }
    if x.is_none() {
        return Ok(Range::Float(x));
    }
    let difference = x.sub(x);
    let nan = x.nan || x.may_be_infinite();
    Ok(Range::Float(Floats { minus_zero: true, ..difference }.with_nan(nan)))
}

fn cast(x: Range, to: ScalarKind, is_conversion: bool) -> Outcome<Range> {
    if !is_conversion {
        return bitcast(x, to);
    }
    Ok(match (x, to) {
        (Range::Float(_), ScalarKind::Float) => x,
        (Range::Float(x), ScalarKind::Bool) => Range::Bool(compare(Op::NotEqual, x, Floats::ZERO)?),
        (Range::Float(x), ScalarKind::Sint | ScalarKind::Uint) => {
            let all = Ints::all(to == ScalarKind::Sint);
            if x.is_none() {
                return Ok(Range::Int(all));
            }
            let whole = |x: f64| (x.trunc() as i64).clamp(all.low, all.high);
            let known = Ints::between(whole(x.low), whole(x.high));
            // Cards differ in what they make of NaN and of what is too large.
            let is_inside =
                !x.nan && x.low >= all.low as f64 - 0.5 && x.high <= all.high as f64 - 128.0;
            Range::Int(if is_inside { known } else { all })
        }
        (Range::Int(x), ScalarKind::Float) => {
            let single = |x: i64| f64::from(x as f32);
            let (low, high) = (single(x.low).min(x.low as f64), single(x.high).max(x.high as f64));
            // Beyond 2^24 rounding may go either way.
            let is_exact = x.low.abs().max(x.high.abs()) <= 1 << 24;
            let slack = if is_exact { 0.0 } else { 256.0 };
            Range::Float(Floats { minus_zero: false, ..Floats::between(low - slack, high + slack) })
        }
        (Range::Int(x), ScalarKind::Sint | ScalarKind::Uint) => {
            // The same bits under another sign.
            let all = Ints::all(to == ScalarKind::Sint);
            if all.low <= x.low && x.high <= all.high {
                Range::Int(x)
            } else {
                Range::Int(Ints { magnitude: x.magnitude, ..all })
            }
        }
        (Range::Int(x), ScalarKind::Bool) => Range::Bool(Bools {
            may_be_true: x.point() != Some(0),
            may_be_false: x.low <= 0 && x.high >= 0,
        }),
        (Range::Bool(x), ScalarKind::Bool) => Range::Bool(x),
        (Range::Bool(x), ScalarKind::Float) => {
            let high = f64::from(u8::from(x.may_be_true));
            let low = f64::from(u8::from(!x.may_be_false));
            Range::Float(Floats::between(low, high))
        }
        (Range::Bool(x), _) => {
            Range::Int(Ints::between((!x.may_be_false).into(), x.may_be_true.into()))
        }
        _ => return Err(NoRanges),
    })
}

fn bitcast(x: Range, to: ScalarKind) -> Outcome<Range> {
    let bits = |x: f64| i64::from((x as f32).to_bits());
    Ok(match (x, to) {
        (Range::Float(_), ScalarKind::Float) => x,
        (Range::Float(x), ScalarKind::Sint | ScalarKind::Uint) => {
            let all = Ints::all(to == ScalarKind::Sint);
            if x.is_none() {
                return Ok(Range::Int(all));
            }
            let size = x.abs();
            let most = if x.nan { 0x7fff_ffff } else { bits(size.high) };
            let magnitude = [bits(size.low), most];
            let is_plain = !x.nan && x.is_positive();
            Range::Int(if is_plain {
                Ints::between(magnitude[0], magnitude[1])
            } else {
                Ints { magnitude, ..all }
            })
        }
        (Range::Int(x), ScalarKind::Float) if x.low >= 0 && x.high <= 0x7f80_0000 => {
            let single = |bits: i64| f64::from(f32::from_bits(bits as u32));
            // A subnormal may be taken for 0.
            let low = if x.low < 0x0080_0000 { 0.0 } else { single(x.low) };
            Range::Float(Floats { minus_zero: false, ..Floats::between(low, single(x.high)) })
        }
        (Range::Int(_), ScalarKind::Float) => Range::Float(Floats::ALL),
        (Range::Int(x), _) => {
            let all = Ints::all(to == ScalarKind::Sint);
            if all.low <= x.low && x.high <= all.high {
                Range::Int(x)
            } else {
                Range::Int(Ints { magnitude: x.magnitude, ..all })
            }
        }
        _ => return Err(NoRanges),
    })
}
