//! Constant expressions, of functions and of the module.

use std::rc::Rc;

use chiaro_locale::tr;
use naga::{Expression, Handle, Literal, Span};

use super::Outcome;
use super::expressions::Operand;
use super::statements::FunctionCompiler;
use super::unsupported::expression_name;
use crate::interp::instruction::Slot;

/// Constant expression of the function, or of the module.
#[derive(Clone, Copy)]
enum Constant {
    Local(Handle<Expression>),
    Global(Handle<Expression>),
}

impl<'a> FunctionCompiler<'a> {
    /// Slots of a constant expression of the function.
    pub(super) fn constant(&mut self, root: Handle<Expression>) -> Outcome<Rc<[Slot]>> {
        self.evaluate(Constant::Local(root))
    }

    /// Slots of a constant expression of the module.
    pub(super) fn global_constant(&mut self, root: Handle<Expression>) -> Outcome<Rc<[Slot]>> {
        self.evaluate(Constant::Global(root))
    }

    fn evaluate(&mut self, root: Constant) -> Outcome<Rc<[Slot]>> {
        let mut pending = vec![root];
        let mut result: Option<Rc<[Slot]>> = None;
        while let Some(&constant) = pending.last() {
            result = self.known(constant);
            if result.is_none() {
                let before = pending.len();
                let parts = self.parts(constant, root)?;
                pending.extend(parts.iter().copied().filter(|&part| self.known(part).is_none()));
                if pending.len() > before {
                    continue;
                }
                let slots: Rc<[Slot]> = self.join(constant, &parts)?.into();
                self.remember(constant, slots.clone());
                result = Some(slots);
            }
            pending.pop();
        }
        result.ok_or_else(|| {
            self.unsupported(tr!("an expression that is not valid naga IR"), self.span_of(root))
        })
    }

    fn known(&self, constant: Constant) -> Option<Rc<[Slot]>> {
        match constant {
            Constant::Global(handle) => self.assembler.globals.get(&handle).cloned(),
            Constant::Local(handle) => match &self.operands[handle.index()] {
                Some(Operand::Value(slots)) => Some(slots.clone()),
                _ => None,
            },
        }
    }

    fn remember(&mut self, constant: Constant, slots: Rc<[Slot]>) {
        match constant {
            Constant::Global(handle) => {
                self.assembler.globals.insert(handle, slots);
            }
            Constant::Local(handle) => self.operands[handle.index()] = Some(Operand::Value(slots)),
        }
    }

    fn constant_expression(&self, constant: Constant) -> &'a Expression {
        match constant {
            Constant::Local(handle) => &self.function.expressions[handle],
            Constant::Global(handle) => &self.context.module.global_expressions[handle],
        }
    }

    fn span_of(&self, constant: Constant) -> Span {
        match constant {
            Constant::Local(handle) => self.span(handle),
            Constant::Global(handle) => self.context.module.global_expressions.get_span(handle),
        }
    }

    /// Parts that a constant is made of.
    fn parts(&self, constant: Constant, root: Constant) -> Outcome<Vec<Constant>> {
        let beside = |handle: Handle<Expression>| match constant {
            Constant::Local(_) => Constant::Local(handle),
            Constant::Global(_) => Constant::Global(handle),
        };
        match self.constant_expression(constant) {
            Expression::Literal(_) | Expression::ZeroValue(_) => Ok(Vec::new()),
            Expression::Constant(named) => {
                Ok(vec![Constant::Global(self.context.module.constants[*named].init)])
            }
            Expression::Compose { components, .. } => {
                Ok(components.iter().map(|&part| beside(part)).collect())
            }
            Expression::Splat { value, .. } => Ok(vec![beside(*value)]),
            other => {
                Err(self
                    .unsupported(&expression_name(self.context.module, other), self.span_of(root)))
            }
        }
    }

    /// Slots of a constant whose parts are known.
    fn join(&mut self, constant: Constant, parts: &[Constant]) -> Outcome<Vec<Slot>> {
        match *self.constant_expression(constant) {
            Expression::Literal(literal) => {
                Ok(vec![self.literal(literal, self.span_of(constant))?])
            }
            Expression::ZeroValue(ty) => {
                let count = self.slots_of(&self.context.module.types[ty].inner, Span::UNDEFINED)?;
                self.assembler.list(count as usize)?;
                Ok(vec![self.assembler.constant(0)?; count as usize])
            }
            Expression::Splat { size, .. } => {
                let value = parts.first().and_then(|&part| self.known(part));
                Ok(value.map_or_else(Vec::new, |slots| slots.repeat(size as usize)))
            }
            _ => {
                let parts: Vec<Rc<[Slot]>> =
                    parts.iter().filter_map(|&part| self.known(part)).collect();
                self.assembler.list(parts.iter().map(|slots| slots.len()).sum())?;
                Ok(parts.iter().flat_map(|slots| slots.iter().copied()).collect())
            }
        }
    }

    fn literal(&mut self, literal: Literal, span: Span) -> Outcome<Slot> {
        match literal {
            Literal::F32(x) => {
                let single = f64::from(x);
                let literals = self.context.options.literals;
                let wide = literals.and_then(|literals| literals.wide(span, x));
                self.assembler.wide_float(wide.unwrap_or(single), single)
            }
            Literal::F64(x) | Literal::AbstractFloat(x) => self.assembler.float(x),
            Literal::U32(x) => self.assembler.constant(u64::from(x)),
            Literal::I32(x) => self.assembler.constant(u64::from(x as u32)),
            Literal::AbstractInt(x) => self.assembler.constant(u64::from(x as u32)),
            Literal::Bool(x) => self.assembler.constant(u64::from(x)),
            Literal::F16(x) => self.assembler.float(x.to_f64()),
            Literal::U64(_) | Literal::I64(_) | Literal::U16(_) | Literal::I16(_) => {
                Err(self.unsupported(tr!("an integer not of 32 bits (Literal)"), span))
            }
        }
    }
}
