//! Knowledge of expressions, by the record of their ranges.

use naga::{Expression, Handle, TypeInner};

use super::FunctionWriter;
use crate::compile::emit::float_literal;
use crate::compile::functions::code::Code;
use crate::compile::intervals::{self, Floats, Ranges};
use crate::interp::Scalar;

impl FunctionWriter<'_> {
    /// The ranges of an expression, wherever it is evaluated.
    pub(super) fn ranges(&self, handle: Handle<Expression>) -> Option<Ranges> {
        match &self.function.expressions[handle] {
            Expression::FunctionArgument(index) => self.arguments.get(*index as usize).cloned(),
            _ => self.trace.value(handle).cloned(),
        }
    }

    /// True for an expression that is one truth value.
    pub(super) fn is_truth(&self, handle: Handle<Expression>) -> bool {
        matches!(self.inner(handle), TypeInner::Scalar(kind) if kind.kind == naga::ScalarKind::Bool)
    }

    pub(super) fn truth(&self, handle: Handle<Expression>) -> Option<bool> {
        match self.ranges(handle).as_deref() {
            Some([one]) => one.truth(),
            _ => None,
        }
    }

    /// The literal of an expression that has one value only.
    pub(super) fn known(&self, handle: Handle<Expression>) -> Option<Code> {
        let ranges = self.ranges(handle)?;
        let inner = self.inner(handle);
        let scalars: Vec<Scalar> =
            ranges.iter().map(|range| range.exactly()).collect::<Option<_>>()?;
        let one = |scalar: &Scalar, is_unsigned: bool| match scalar {
            Scalar::Float(x) => float_literal(*x),
            Scalar::I32(x) if is_unsigned => format!("{x}u"),
            Scalar::I32(x) => format!("{x}i"),
            Scalar::U32(x) => format!("{x}u"),
            Scalar::Bool(x) => x.to_string(),
        };
        match (inner, scalars.as_slice()) {
            (TypeInner::Scalar(kind), [scalar]) => {
                let is_unsigned = kind.kind == naga::ScalarKind::Uint;
                Some(Code::number(&one(scalar, is_unsigned)))
            }
            (TypeInner::Vector { scalar, .. }, scalars)
                if scalar.kind == naga::ScalarKind::Float =>
            {
                let mut parts: Vec<Code> =
                    scalars.iter().map(|scalar| Code::number(&one(scalar, false))).collect();
                if parts.iter().all(|part| *part == parts[0]) {
                    parts.truncate(1);
                }
                let name = self.inner_text(inner).ok()?;
                Some(Code::BuiltIn(name.into(), parts))
            }
            _ => None,
        }
    }

    pub(super) fn floats(&self, handle: Handle<Expression>) -> Option<Vec<Floats>> {
        intervals::floats(&self.ranges(handle)?)
    }

    pub(super) fn is_all(
        &self,
        handle: Handle<Expression>,
        holds: impl Fn(Floats) -> bool,
    ) -> bool {
        self.floats(handle).is_some_and(|all| !all.is_empty() && all.into_iter().all(holds))
    }
}
