//! Expressions: the places of their values, and the instructions that compute them.

use std::rc::Rc;

use chiaro_locale::tr;
use naga::{DerivativeAxis, DerivativeControl, Expression, Handle, MathFunction, Span, TypeInner};

use super::globals::no_stage;
use super::images::SampleParts;
use super::layout::{LayoutProblem, scalar_kind};
use super::statements::FunctionCompiler;
use super::unsupported::expression_name;
use super::{Outcome, is_constant};
use crate::interp::instruction::{Derivative, FloatUnary, Instruction, ScalarConversion, Slot};
use crate::interp::{Derivatives, ScalarKind};

/// Compiled form of an expression.
#[derive(Clone)]
pub(super) enum Operand {
    /// Slots of the expression's scalars, which nothing changes while the expression is in scope.
    Value(Rc<[Slot]>),
    /// Pointer.
    Place(MemoryPlace),
}

/// Place in memory, or in a buffer.
#[derive(Clone, Copy)]
pub(super) struct MemoryPlace {
    /// Number of the buffer; `None` for memory.
    pub(super) buffer: Option<u32>,
    /// Slot that holds the number of a slot; `None` for 0.
    pub(super) pointer: Option<Slot>,
    /// Offset that is added to the pointer's number.
    pub(super) offset: u32,
}

impl MemoryPlace {
    /// Place that is known while compiling.
    pub(super) fn fixed(slot: Slot) -> Self {
        Self { buffer: None, pointer: None, offset: slot }
    }

    /// Place whose number a slot holds.
    pub(super) fn at(pointer: Slot) -> Self {
        Self { buffer: None, pointer: Some(pointer), offset: 0 }
    }
}

impl<'a> FunctionCompiler<'a> {
    /// Compiles an expression where it is to be evaluated.
    pub(super) fn expression(&mut self, handle: Handle<Expression>) -> Outcome<()> {
        let expression = &self.function.expressions[handle];
        let slots = match *expression {
            ref constant if is_constant(constant) => return Ok(()),
            Expression::FunctionArgument(_)
            | Expression::LocalVariable(_)
            | Expression::GlobalVariable(_) => {
                return Ok(());
            }
            Expression::Access { base, index } => return self.access(handle, base, index),
            Expression::AccessIndex { base, index } => {
                return self.access_index(handle, base, index);
            }
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.value(vector)?;
                pattern[..size as usize]
                    .iter()
                    .map(|component| vector.get(component.index() as usize).copied())
                    .collect()
            }
            Expression::Load { pointer } => {
                let slots = self.load(pointer, handle)?;
                return self.define(handle, slots);
            }
            Expression::Unary { op, expr } => Some(self.unary(op, expr)?),
            Expression::Binary { op, left, right } => Some(self.binary(op, left, right)?),
            Expression::Select { condition, accept, reject } => {
                Some(self.select_each(condition, accept, reject)?)
            }
            Expression::Relational { fun, argument } => Some(self.relational(fun, argument)?),
            Expression::As { expr, kind, convert } => {
                Some(self.cast(expr, kind, convert.is_some())?)
            }
            Expression::Math { fun: MathFunction::Outer, .. } => None,
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                Some(self.math(fun, arg, [arg1, arg2, arg3])?)
            }
            Expression::Derivative { axis, ctrl, expr } => self.derivative(axis, ctrl, expr)?,
            Expression::ImageSample {
                image,
                sampler,
                gather,
                coordinate,
                array_index,
                offset,
                level,
                depth_ref,
                clamp_to_edge,
            } => Some(self.image_sample(&SampleParts {
                image,
                sampler,
                gather,
                coordinate,
                array_index,
                offset,
                level,
                depth_ref,
                clamp_to_edge,
            })?),
            Expression::ImageLoad { image, coordinate, array_index, sample, level } => {
                Some(self.image_load(image, coordinate, [array_index, sample, level])?)
            }
            Expression::ImageQuery { image, query } => Some(self.image_query(image, query)?),
            Expression::ArrayLength(array) => Some(self.array_length(array)?),
            _ => None,
        };
        match slots {
            Some(slots) => {
                let slots = self.rounded(handle, slots)?;
                self.define(handle, slots)
            }
            None => Err(self.unsupported_expression(handle)),
        }
    }

    /// Rounds the result of an expression to its type: an f16 holds less than the float that stands
    /// for it.
    fn rounded(&mut self, handle: Handle<Expression>, slots: Vec<Slot>) -> Outcome<Vec<Slot>> {
        let is_half = self.inner(handle).scalar() == Some(naga::Scalar::F16);
        if is_half {
            self.map(&slots, |this, a| this.convert(ScalarConversion::HalfInSingle, a))
        } else {
            Ok(slots)
        }
    }

    /// Remembers the value of an expression.
    pub(super) fn define(&mut self, handle: Handle<Expression>, slots: Vec<Slot>) -> Outcome<()> {
        self.assembler.list(slots.len())?;
        self.operands[handle.index()] = Some(Operand::Value(slots.into()));
        Ok(())
    }

    pub(super) fn define_place(
        &mut self,
        handle: Handle<Expression>,
        place: MemoryPlace,
    ) -> Outcome<()> {
        self.operands[handle.index()] = Some(Operand::Place(place));
        Ok(())
    }

    /// Compiled form of an expression that has been evaluated.
    pub(super) fn operand(&mut self, handle: Handle<Expression>) -> Outcome<Operand> {
        if let Some(operand) = &self.operands[handle.index()] {
            return Ok(operand.clone());
        }
        if let Expression::GlobalVariable(variable) = self.function.expressions[handle] {
            return match self.context.globals.operand(variable, self.assembler)? {
                Some(operand) => Ok(operand),
                None => Err(no_stage(self.unsupported_expression(handle))),
            };
        }
        self.constant(handle).map(Operand::Value)
    }

    /// Slots of a value.
    pub(super) fn value(&mut self, handle: Handle<Expression>) -> Outcome<Rc<[Slot]>> {
        match self.operand(handle)? {
            Operand::Value(slots) => Ok(slots),
            Operand::Place(_) => {
                Err(self.unsupported(tr!("a pointer as a value"), self.span(handle)))
            }
        }
    }

    /// Slot of a scalar.
    pub(super) fn scalar(&mut self, handle: Handle<Expression>) -> Outcome<Slot> {
        match *self.value(handle)? {
            [slot] => Ok(slot),
            _ => Err(self.unsupported(tr!("a composite as a scalar"), self.span(handle))),
        }
    }

    /// Place that a pointer points to.
    pub(super) fn place(&mut self, handle: Handle<Expression>) -> Outcome<MemoryPlace> {
        match self.operand(handle)? {
            Operand::Place(place) => Ok(place),
            Operand::Value(_) => {
                Err(self.unsupported(tr!("a value as a pointer"), self.span(handle)))
            }
        }
    }

    /// Place of an argument.
    pub(super) fn argument(&self, index: u32, handle: Handle<Expression>) -> Outcome<Operand> {
        let inner = self.inner(handle);
        let Some(&first) = self.frame.arguments.get(index as usize) else {
            return Err(self.unsupported_expression(handle));
        };
        if is_pointer(inner) {
            return Ok(Operand::Place(MemoryPlace::at(first)));
        }
        let count = self.slots_of(inner, self.span(handle))?;
        Ok(Operand::Value((first..first + count).collect()))
    }

    fn derivative(
        &mut self,
        axis: DerivativeAxis,
        control: DerivativeControl,
        expr: Handle<Expression>,
    ) -> Outcome<Option<Vec<Slot>>> {
        let slots = self.value(expr)?;
        match self.context.options.derivatives {
            Derivatives::Refuse => return Ok(None),
            Derivatives::Zero => return Ok(Some(vec![self.assembler.constant(0)?; slots.len()])),
            Derivatives::Quads => {}
        }
        let [x, y] = match control {
            DerivativeControl::Coarse => [Derivative::CoarseX, Derivative::CoarseY],
            DerivativeControl::Fine | DerivativeControl::None => {
                [Derivative::FineX, Derivative::FineY]
            }
        };
        let along =
            |this: &mut Self, op, a| this.compute(|to| Instruction::Derivative { op, to, a });
        let derivative = match axis {
            DerivativeAxis::X => self.map(&slots, |this, a| along(this, x, a)),
            DerivativeAxis::Y => self.map(&slots, |this, a| along(this, y, a)),
            DerivativeAxis::Width => self.map(&slots, |this, a| {
                let (x, y) = (along(this, x, a)?, along(this, y, a)?);
                let (x, y) = (this.float1(FloatUnary::Abs, x)?, this.float1(FloatUnary::Abs, y)?);
                this.add(x, y)
            }),
        };
        derivative.map(Some)
    }

    /// Type of an expression.
    pub(super) fn inner(&self, handle: Handle<Expression>) -> &'a TypeInner {
        self.types.get(handle, &self.context.module.types)
    }

    /// Kind of an expression's scalars.
    pub(super) fn kind(&self, handle: Handle<Expression>) -> Outcome<ScalarKind> {
        let scalar = self
            .inner(handle)
            .scalar()
            .ok_or_else(|| LayoutProblem::Unsupported(tr!("neither scalar, vector nor matrix")));
        self.checked(scalar.and_then(scalar_kind), handle)
    }

    /// Type of an expression, or if it is a pointer, of its target.
    pub(super) fn pointee(&self, handle: Handle<Expression>) -> &'a TypeInner {
        match self.inner(handle) {
            TypeInner::Pointer { base, .. } => &self.context.module.types[*base].inner,
            other => other,
        }
    }

    pub(super) fn checked<T>(
        &self,
        result: Result<T, LayoutProblem>,
        handle: Handle<Expression>,
    ) -> Outcome<T> {
        result.map_err(|problem| self.locate(problem.diagnose(&self.subject()), self.span(handle)))
    }

    /// Span of an expression in the source.
    pub(super) fn span(&self, handle: Handle<Expression>) -> Span {
        self.function.expressions.get_span(handle)
    }

    #[cold]
    pub(super) fn unsupported_expression(
        &self,
        handle: Handle<Expression>,
    ) -> Box<crate::diag::Diagnostic> {
        let expression = &self.function.expressions[handle];
        let mut error =
            self.unsupported(&expression_name(self.context.module, expression), self.span(handle));
        if matches!(expression, Expression::Derivative { .. }) {
            error.hints.push(
                tr!("`Derivatives::Zero` makes derivatives 0, as where everything is constant")
                    .to_owned(),
            );
        }
        error
    }
}

fn is_pointer(inner: &TypeInner) -> bool {
    matches!(inner, TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. })
}
