//! Expressions: where their values lie, and what computes them.

use std::rc::Rc;

use naga::{Expression, Handle, MathFunction, Span, TypeInner};

use super::layout::{Problem, scalar_kind};
use super::statements::FunctionCompiler;
use super::unsupported::expression_name;
use super::{Outcome, is_constant};
use crate::interp::instruction::{Instruction, Slot};
use crate::interp::{Derivatives, ScalarKind};

/// What an expression is.
#[derive(Clone)]
pub(super) enum Operand {
    /// The slots of its scalars, which nothing changes while the expression is in scope.
    Value(Rc<[Slot]>),
    /// A pointer.
    Place(Place),
}

/// A place in memory.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// The slot that holds the number of a slot; if none, 0.
    pub(super) pointer: Option<Slot>,
    /// What is added to that.
    pub(super) offset: u32,
}

impl Place {
    /// One that is known while compiling.
    pub(super) fn fixed(slot: Slot) -> Self {
        Self { pointer: None, offset: slot }
    }
}

impl<'a> FunctionCompiler<'a> {
    /// Compiles an expression where it is to be evaluated.
    pub(super) fn expression(&mut self, handle: Handle<Expression>) -> Outcome<()> {
        let expression = &self.function.expressions[handle];
        let slots = match *expression {
            ref constant if is_constant(constant) => return Ok(()),
            Expression::FunctionArgument(_) | Expression::LocalVariable(_) => return Ok(()),
            Expression::Access { base, index } => return self.access(handle, base, index),
            Expression::AccessIndex { base, index } => return self.access_index(handle, base, index),
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.value(vector)?;
                pattern[..size as usize]
                    .iter()
                    .map(|component| vector.get(component.index() as usize).copied())
                    .collect()
            }
            Expression::Load { pointer } => Some(self.load(pointer, handle)?),
            Expression::Unary { op, expr } => Some(self.unary(op, expr)?),
            Expression::Binary { op, left, right } => Some(self.binary(op, left, right)?),
            Expression::Select { condition, accept, reject } => Some(self.select_each(condition, accept, reject)?),
            Expression::Relational { fun, argument } => Some(self.relational(fun, argument)?),
            Expression::As { expr, kind, convert } => Some(self.cast(expr, kind, convert.is_some())?),
            Expression::Math { fun: MathFunction::Outer, .. } => None,
            Expression::Math { fun, arg, arg1, arg2, arg3 } => Some(self.math(fun, arg, [arg1, arg2, arg3])?),
            Expression::Derivative { expr, .. } => self.derivative(expr)?,
            _ => None,
        };
        match slots {
            Some(slots) => self.define(handle, slots),
            None => Err(self.unsupported_expression(handle)),
        }
    }

    /// Remembers the value of an expression.
    pub(super) fn define(&mut self, handle: Handle<Expression>, slots: Vec<Slot>) -> Outcome<()> {
        self.assembler.list(slots.len())?;
        self.operands[handle.index()] = Some(Operand::Value(slots.into()));
        Ok(())
    }

    fn define_place(&mut self, handle: Handle<Expression>, place: Place) -> Outcome<()> {
        self.operands[handle.index()] = Some(Operand::Place(place));
        Ok(())
    }

    /// What an expression that has been evaluated is.
    pub(super) fn operand(&mut self, handle: Handle<Expression>) -> Outcome<Operand> {
        if let Some(operand) = &self.operands[handle.index()] {
            return Ok(operand.clone());
        }
        self.constant(handle).map(Operand::Value)
    }

    /// The slots of a value.
    pub(super) fn value(&mut self, handle: Handle<Expression>) -> Outcome<Rc<[Slot]>> {
        match self.operand(handle)? {
            Operand::Value(slots) => Ok(slots),
            Operand::Place(_) => Err(self.unsupported("a pointer as a value", self.span(handle))),
        }
    }

    /// The slot of a scalar.
    pub(super) fn scalar(&mut self, handle: Handle<Expression>) -> Outcome<Slot> {
        match *self.value(handle)? {
            [slot] => Ok(slot),
            _ => Err(self.unsupported("a composite as a scalar", self.span(handle))),
        }
    }

    /// Where a pointer points.
    pub(super) fn place(&mut self, handle: Handle<Expression>) -> Outcome<Place> {
        match self.operand(handle)? {
            Operand::Place(place) => Ok(place),
            Operand::Value(_) => Err(self.unsupported("a value as a pointer", self.span(handle))),
        }
    }

    /// Where an argument lies.
    pub(super) fn argument(&self, index: u32, handle: Handle<Expression>) -> Outcome<Operand> {
        let inner = self.inner(handle);
        let Some(&first) = self.frame.arguments.get(index as usize) else {
            return Err(self.unsupported_expression(handle));
        };
        if is_pointer(inner) {
            return Ok(Operand::Place(Place { pointer: Some(first), offset: 0 }));
        }
        let count = self.slots_of(inner, self.span(handle))?;
        Ok(Operand::Value((first..first + count).collect()))
    }

    fn access_index(&mut self, handle: Handle<Expression>, base: Handle<Expression>, index: u32) -> Outcome<()> {
        let composite = self.pointee(base);
        let (offset, count) =
            self.checked(self.context.layouts.part(&self.context.module.types, composite, index), base)?;
        match self.operand(base)? {
            Operand::Place(place) => self.define_place(handle, Place { offset: place.offset + offset, ..place }),
            Operand::Value(slots) => match slots.get(offset as usize..(offset + count) as usize) {
                Some(part) => self.define(handle, part.to_vec()),
                None => Err(self.unsupported_expression(handle)),
            },
        }
    }

    fn access(
        &mut self,
        handle: Handle<Expression>,
        base: Handle<Expression>,
        index: Handle<Expression>,
    ) -> Outcome<()> {
        let composite = self.pointee(base);
        let (count, stride) =
            self.checked(self.context.layouts.elements(&self.context.module.types, composite), base)?;
        let index = self.scalar(index)?;
        let operand = self.operand(base)?;
        let to = self.assembler.reserve(1)?;
        match operand {
            Operand::Place(place) => {
                let (pointer, offset) = match place.pointer {
                    Some(pointer) => (pointer, place.offset),
                    None => (self.pointer(place)?, 0),
                };
                self.assembler.emit(Instruction::Index { to, pointer, index, count, stride })?;
                self.define_place(handle, Place { pointer: Some(to), offset })
            }
            Operand::Value(slots) => {
                let first = self.gather(&slots)?;
                let pointer = self.assembler.constant(u64::from(first))?;
                self.assembler.emit(Instruction::Index { to, pointer, index, count, stride })?;
                let part = self.load_from(Place { pointer: Some(to), offset: 0 }, stride)?;
                self.define(handle, part)
            }
        }
    }

    /// The first of neighbours that hold what `slots` hold.
    fn gather(&mut self, slots: &[Slot]) -> Outcome<Slot> {
        if slots.is_sorted_by(|a, b| *b == *a + 1)
            && let Some(&first) = slots.first()
        {
            return Ok(first);
        }
        if let Some(first) = self.assembler.constant_run(slots)? {
            return Ok(first);
        }
        let first = self.assembler.reserve(slots.len() as u32)?;
        self.copy(first, slots)?;
        Ok(first)
    }

    /// A slot that holds the number of the slot at `place`.
    pub(super) fn pointer(&mut self, place: Place) -> Outcome<Slot> {
        match place {
            Place { pointer: None, offset } => self.assembler.constant(u64::from(offset)),
            Place { pointer: Some(pointer), offset: 0 } => Ok(pointer),
            Place { pointer: Some(pointer), offset } => {
                let to = self.assembler.reserve(1)?;
                self.assembler.emit(Instruction::Offset { to, pointer, offset })?;
                Ok(to)
            }
        }
    }

    fn load(&mut self, pointer: Handle<Expression>, handle: Handle<Expression>) -> Outcome<Vec<Slot>> {
        let place = self.place(pointer)?;
        let count = self.slots_of(self.inner(handle), self.span(handle))?;
        self.load_from(place, count)
    }

    fn load_from(&mut self, place: Place, count: u32) -> Outcome<Vec<Slot>> {
        let to = self.assembler.reserve(count)?;
        match place {
            Place { pointer: None, offset } => {
                let from: Vec<Slot> = (offset..offset + count).collect();
                self.copy(to, &from)?;
            }
            Place { pointer: Some(pointer), offset } => {
                self.assembler.emit(Instruction::Load { to, pointer, offset, count })?;
            }
        }
        Ok((to..to + count).collect())
    }

    fn derivative(&mut self, expr: Handle<Expression>) -> Outcome<Option<Vec<Slot>>> {
        match self.context.options.derivatives {
            Derivatives::Refuse => Ok(None),
            Derivatives::Zero => {
                let zero = self.assembler.constant(0)?;
                Ok(Some(vec![zero; self.value(expr)?.len()]))
            }
        }
    }

    /// The type of an expression.
    pub(super) fn inner(&self, handle: Handle<Expression>) -> &'a TypeInner {
        self.types.get(handle, &self.context.module.types)
    }

    /// The kind of an expression's scalars.
    pub(super) fn kind(&self, handle: Handle<Expression>) -> Outcome<ScalarKind> {
        let scalar = self.inner(handle).scalar().ok_or(Problem::Unsupported("neither scalar, vector nor matrix"));
        self.checked(scalar.and_then(scalar_kind), handle)
    }

    /// The type of an expression, or if it is a pointer, of what it points to.
    fn pointee(&self, handle: Handle<Expression>) -> &'a TypeInner {
        match self.inner(handle) {
            TypeInner::Pointer { base, .. } => &self.context.module.types[*base].inner,
            other => other,
        }
    }

    fn checked<T>(&self, result: Result<T, Problem>, handle: Handle<Expression>) -> Outcome<T> {
        result.map_err(|problem| self.locate(problem.diagnose(&self.subject()), self.span(handle)))
    }

    /// Where an expression stands in the source.
    pub(super) fn span(&self, handle: Handle<Expression>) -> Span {
        self.function.expressions.get_span(handle)
    }

    #[cold]
    pub(super) fn unsupported_expression(&self, handle: Handle<Expression>) -> Box<crate::diag::Diagnostic> {
        let expression = &self.function.expressions[handle];
        let mut error = self.unsupported(&expression_name(self.context.module, expression), self.span(handle));
        if matches!(expression, Expression::Derivative { .. }) {
            error.hints.push("`Derivatives::Zero` makes derivatives 0, as where everything is constant".to_owned());
        }
        error
    }
}

fn is_pointer(inner: &TypeInner) -> bool {
    matches!(inner, TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. })
}
