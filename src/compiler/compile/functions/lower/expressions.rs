//! Expressions: names, literals, vectors and their parts.

use std::rc::Rc;

use naga::{Expression, Handle, MathFunction, TypeInner};

use super::{FunctionWriter, NotWritten, WriteResult};
use crate::compile::emit::float_literal;
use crate::compile::functions::code::{self, COMPONENTS, Code};
use crate::compile::functions::print::level;

/// Longest text of a literal that is taken over as it was written, in bytes.
const LONGEST_LITERAL: usize = 60;

impl FunctionWriter<'_> {
    /// The code of an expression: its name or its only value, else the code of its parts.
    pub(super) fn code(&mut self, handle: Handle<Expression>) -> WriteResult<Code> {
        if let Some(bound) = self.bound.get(&handle) {
            return Ok(bound.clone());
        }
        let expression = &self.function.expressions[handle];
        // Put together from parts of another vector, it is that vector.
        if let Expression::Compose { ty, components } = expression
            && let Some(whole) = self.whole(&self.scope.valid.module.types[*ty], components)?
        {
            return Ok(whole);
        }
        // A parameter keeps its name though its value is known, so that calls with other values
        // share the function; drivers fold it.
        let is_written = matches!(
            expression,
            Expression::Literal(_)
                | Expression::Constant(_)
                | Expression::LocalVariable(_)
                | Expression::FunctionArgument(_)
        );
        if !is_written && let Some(known) = self.known(handle) {
            // A guard that lets a parameter through leaves the function to other arguments, too.
            let is_guard = matches!(
                expression,
                Expression::Math {
                    fun: MathFunction::Clamp | MathFunction::Min | MathFunction::Max,
                    ..
                }
            );
            if is_guard && let Ok(parameter @ Code::Parameter(_)) = self.of_parts(handle) {
                return Ok(parameter);
            }
            // A vector of constants is the same in other words.
            self.is_changed |= !matches!(
                expression,
                Expression::Compose { .. } | Expression::Splat { .. } | Expression::ZeroValue(_)
            );
            return Ok(known);
        }
        self.of_parts(handle)
    }

    /// The code of an expression by that of its parts.
    fn of_parts(&mut self, handle: Handle<Expression>) -> WriteResult<Code> {
        let expression = &self.function.expressions[handle];
        Ok(match expression {
            Expression::Literal(literal) => self.literal(handle, *literal)?,
            Expression::Constant(constant) => {
                let name = self.scope.valid.module.constants[*constant].name.as_deref();
                Code::Constant(name.ok_or(NotWritten)?.into())
            }
            Expression::ZeroValue(ty) => Code::BuiltIn(
                self.type_text(&self.scope.valid.module.types[*ty])?.into(),
                Vec::new(),
            ),
            Expression::Compose { ty, components } => self.composed(*ty, components)?,
            Expression::Splat { value, .. } => {
                let name = self.inner_text(self.inner(handle))?;
                Code::BuiltIn(name.into(), vec![self.code(*value)?])
            }
            Expression::Swizzle { size, vector, pattern } => {
                self.swizzled(*vector, &pattern[..*size as usize])?
            }
            Expression::AccessIndex { base, index } => self.access(*base, *index)?,
            Expression::Access { base, index } => {
                Code::Index(Box::new(self.code(*base)?), Box::new(self.code(*index)?))
            }
            Expression::FunctionArgument(index) => Code::Parameter(*index as usize),
            Expression::LocalVariable(variable) => {
                Code::Local(*self.variables.get(variable).ok_or(NotWritten)?)
            }
            Expression::Load { pointer } => self.load(*pointer)?,
            Expression::Unary { op, expr } => self.unary(*op, *expr)?,
            Expression::Binary { op, left, right } => self.binary(*op, *left, *right)?,
            Expression::Select { condition, accept, reject } => {
                self.select(*condition, *accept, *reject)?
            }
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                let rest: Vec<_> = [*arg1, *arg2, *arg3].into_iter().flatten().collect();
                self.math(*fun, *arg, &rest)?
            }
            Expression::Derivative { axis, ctrl, expr } => {
                Code::BuiltIn(derivative_name(*axis, *ctrl).into(), vec![self.code(*expr)?])
            }
            Expression::Relational { fun, argument } => {
                let name = match fun {
                    naga::RelationalFunction::All => "all",
                    naga::RelationalFunction::Any => "any",
                    _ => return Err(NotWritten),
                };
                Code::BuiltIn(name.into(), vec![self.code(*argument)?])
            }
            Expression::As { expr, convert, .. } => {
                let ty = self.inner_text(self.inner(handle))?;
                let name = if convert.is_some() { ty } else { format!("bitcast<{ty}>") };
                Code::BuiltIn(name.into(), vec![self.code(*expr)?])
            }
            Expression::ImageSample { .. }
            | Expression::ImageLoad { .. }
            | Expression::ImageQuery { .. } => self.image(expression)?,
            _ => return Err(NotWritten),
        })
    }

    /// The code of a vector, a matrix, an array or a struct, by its components.
    fn composed(
        &mut self,
        ty: Handle<naga::Type>,
        components: &[Handle<Expression>],
    ) -> WriteResult<Code> {
        let ty = &self.scope.valid.module.types[ty];
        let parts =
            components.iter().map(|&part| self.code(part)).collect::<WriteResult<Vec<_>>>()?;
        let name: Rc<str> = self.type_text(ty)?.into();
        Ok(if matches!(ty.inner, TypeInner::Struct { .. }) {
            Code::Struct(name, parts)
        } else {
            Code::BuiltIn(name, parts).simplified()
        })
    }

    /// The vector whose parts are put together again, even where a part is known.
    fn whole(
        &mut self,
        ty: &naga::Type,
        components: &[Handle<Expression>],
    ) -> WriteResult<Option<Code>> {
        if !matches!(ty.inner, TypeInner::Vector { .. }) {
            return Ok(None);
        }
        let mut parts = Vec::with_capacity(components.len());
        for &component in components {
            let is_free = !self.bound.contains_key(&component);
            parts.push(match self.function.expressions[component] {
                Expression::AccessIndex { base, index } if is_free => self.access(base, index)?,
                _ => self.code(component)?,
            });
        }
        let name = self.type_text(ty)?;
        Ok(code::whole(&name, &parts))
    }

    /// A literal as the file has it, or what naga made of constants.
    fn literal(&self, handle: Handle<Expression>, literal: naga::Literal) -> WriteResult<Code> {
        let span = self.function.expressions.get_span(handle);
        let source = self.scope.literals.source();
        let text = span.to_range().and_then(|span| source.get(span)).unwrap_or_default();
        Ok(match literal {
            naga::Literal::F32(x) => {
                let is_number = text.starts_with(|c: char| c.is_ascii_digit())
                    && text.bytes().all(|c| c.is_ascii_digit() || b".eE+-".contains(&c));
                let written = if is_number && text.len() <= LONGEST_LITERAL {
                    let is_float = text.contains(['.', 'e', 'E']);
                    if is_float { text.to_owned() } else { format!("{text}.0") }
                } else {
                    // What naga made of several, with all of its digits.
                    let wide = self.scope.literals.wide(span, x);
                    wide.map_or_else(|| float_literal(x.into()), |wide| format!("{wide:?}"))
                };
                // Only if it is the same number.
                let same = written.parse::<f32>().is_ok_and(|read| read.to_bits() == x.to_bits());
                Code::number(&if same { written } else { float_literal(x.into()) })
            }
            naga::Literal::U32(x) => {
                let hex = text.strip_prefix("0x").and_then(|text| text.strip_suffix('u'));
                let is_same = hex.is_some_and(|hex| u32::from_str_radix(hex, 16) == Ok(x));
                Code::number(&if is_same { text.to_owned() } else { format!("{x}u") })
            }
            naga::Literal::I32(x) if x < 0 => Code::number(&format!("{x}i")),
            naga::Literal::I32(x) => Code::number(&x.to_string()),
            naga::Literal::Bool(x) => Code::Text(x.to_string().into(), level::ATOM),
            _ => return Err(NotWritten),
        })
    }

    /// The code of a variable that is read.
    fn load(&mut self, pointer: Handle<Expression>) -> WriteResult<Code> {
        if let Expression::LocalVariable(variable) = self.function.expressions[pointer]
            && let Some(condition) = self.conditions.get(&variable)
        {
            return Ok(condition.clone());
        }
        self.code(pointer)
    }

    fn swizzled(
        &mut self,
        vector: Handle<Expression>,
        pattern: &[naga::SwizzleComponent],
    ) -> WriteResult<Code> {
        let name: String =
            pattern.iter().map(|component| COMPONENTS[*component as usize]).collect();
        self.member(vector, &name)
    }

    fn member(&mut self, base: Handle<Expression>, name: &str) -> WriteResult<Code> {
        let TypeInner::Vector { size, .. } = *self.inner(base) else { return Err(NotWritten) };
        let of = self.code(base)?;
        Ok(Code::Member(Box::new(of), name.into(), size as usize).simplified())
    }

    fn access(&mut self, base: Handle<Expression>, index: u32) -> WriteResult<Code> {
        let types = &self.scope.valid.module.types;
        let info = self.info;
        let inner = match info[base].ty.inner_with(types) {
            TypeInner::Pointer { base, .. } => &types[*base].inner,
            TypeInner::ValuePointer { size: Some(size), .. } => {
                let (size, of) = (*size as usize, self.code(base)?);
                let name = COMPONENTS[index as usize];
                return Ok(Code::Member(Box::new(of), name.into(), size));
            }
            other => other,
        };
        Ok(match inner {
            TypeInner::Struct { members, .. } => {
                let name = members[index as usize].name.clone().ok_or(NotWritten)?;
                let of = self.code(base)?;
                match of {
                    Code::Struct(_, mut parts) if parts.len() == members.len() => {
                        parts.swap_remove(index as usize)
                    }
                    of => Code::Member(Box::new(of), name.into(), 0),
                }
            }
            TypeInner::Vector { size, .. } => {
                let size = *size as usize;
                let of = self.code(base)?;
                let name = COMPONENTS[index as usize];
                Code::Member(Box::new(of), name.into(), size).simplified()
            }
            _ => {
                Code::Index(Box::new(self.code(base)?), Box::new(Code::number(&index.to_string())))
            }
        })
    }
}

fn derivative_name(axis: naga::DerivativeAxis, control: naga::DerivativeControl) -> String {
    let axis = match axis {
        naga::DerivativeAxis::X => "dpdx",
        naga::DerivativeAxis::Y => "dpdy",
        naga::DerivativeAxis::Width => "fwidth",
    };
    let control = match control {
        naga::DerivativeControl::None => "",
        naga::DerivativeControl::Coarse => "Coarse",
        naga::DerivativeControl::Fine => "Fine",
    };
    format!("{axis}{control}")
}
