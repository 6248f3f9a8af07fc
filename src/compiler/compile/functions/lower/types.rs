//! Types of naga's IR, as WGSL writes them.

use naga::{Expression, Handle, TypeInner};

use super::{FunctionWriter, NotWritten, WriteResult};

impl FunctionWriter<'_> {
    pub(super) fn inner(&self, handle: Handle<Expression>) -> &TypeInner {
        self.info[handle].ty.inner_with(&self.scope.valid.module.types)
    }

    pub(super) fn type_text(&self, ty: &naga::Type) -> WriteResult<String> {
        match (&ty.name, &ty.inner) {
            (Some(name), TypeInner::Struct { .. }) => Ok(name.clone()),
            (_, inner) => self.inner_text(inner),
        }
    }

    pub(super) fn inner_text(&self, inner: &TypeInner) -> WriteResult<String> {
        let scalar = |scalar: &naga::Scalar| match (scalar.kind, scalar.width) {
            (naga::ScalarKind::Float, 4) => Ok("f"),
            (naga::ScalarKind::Sint, 4) => Ok("i"),
            (naga::ScalarKind::Uint, 4) => Ok("u"),
            (naga::ScalarKind::Bool, _) => Ok("<bool>"),
            _ => Err(NotWritten),
        };
        Ok(match inner {
            TypeInner::Scalar(of) => match scalar(of)? {
                "<bool>" => "bool".to_owned(),
                kind => format!("{kind}32"),
            },
            TypeInner::Vector { size, scalar: of } => {
                format!("vec{}{}", *size as usize, scalar(of)?)
            }
            TypeInner::Matrix { columns, rows, scalar: of, .. } => {
                format!("mat{}x{}{}", *columns as usize, *rows as usize, scalar(of)?)
            }
            TypeInner::Array { base, size: naga::ArraySize::Constant(count), .. } => {
                let base = self.type_text(&self.scope.valid.module.types[*base])?;
                format!("array<{base}, {count}>")
            }
            _ => return Err(NotWritten),
        })
    }
}
