//! Values as WGSL expressions and literals.

use super::Emitter;
use crate::compile::functions::{CallForm, Code, level, module_key};
use crate::compile::specialize::{Argument, Operation, ValueId};
use crate::interp::{Scalar, Value};
use crate::library::{Conversion, Rate, Type};

impl Emitter<'_> {
    /// WGSL expression that reads a value where fragments are shaded.
    pub(super) fn expression(&self, id: ValueId) -> String {
        let value = &self.special.values[id];
        if matches!(value.rate, Rate::Frame | Rate::Object) {
            let name = self.value_names.get(&id).cloned().unwrap_or_default();
            // A uniform holds no bool.
            return if value.ty == Type::Bool { format!("({name} != 0u)") } else { name };
        }
        match &value.operation {
            Operation::Constant(constant) => match self.value_names.get(&id) {
                Some(name) => name.clone(),
                None => self.literal(constant, &value.ty, value.node),
            },
            Operation::Context(context, _) => self.context_expression(*context),
            Operation::Call { .. } if self.is_nested(id) => {
                let names = self.collected.code_names(0, &[], &[]);
                self.nested(id).wgsl(level::LOWEST, &names)
            }
            Operation::Call { .. } => self.value_names.get(&id).cloned().unwrap_or_default(),
            Operation::Member { value, name, .. } => format!("{}.{name}", self.expression(*value)),
            Operation::Convert { template, value } => {
                if self.specialized.contains_key(&id) {
                    let names = self.collected.code_names(0, &[], &[]);
                    return self.argument(id).wgsl(level::ATOM, &names);
                }
                Conversion::Template(template).apply(&self.expression(*value))
            }
            Operation::LoopField { .. } => {
                let name = self.value_names.get(&id).cloned().unwrap_or_default();
                if value.ty == Type::Bool { format!("({name} != 0u)") } else { name }
            }
            Operation::Loop { .. }
            | Operation::LoopResult { .. }
            | Operation::LoopVariable { .. } => {
                self.value_names.get(&id).cloned().unwrap_or_default()
            }
            // Parameters that stay live are of object rate.
            Operation::Param { value: constant, .. } => {
                self.literal(constant, &value.ty, value.node)
            }
        }
    }

    /// A call with its arguments, or the expression that it comes to, and how strongly it binds.
    pub(super) fn call(&self, id: ValueId) -> (String, u8) {
        let Operation::Call { function, arguments } = &self.special.values[id].operation else {
            return (String::new(), level::ATOM);
        };
        let text = |argument: &Argument| match argument {
            Argument::Value(id) => self.expression(*id),
            Argument::Image(image) => self.image_name(*image),
            Argument::Sampler(image) => format!("{}_sampler", self.image_name(*image)),
        };
        let name = match self.specialized.get(&id) {
            None | Some(CallForm::Original) => {
                self.collected.name(&function.module, &function.name)
            }
            Some(CallForm::Made(index)) => self.collected.made(*index),
            Some(CallForm::Expression(code, _)) => {
                let arguments: Vec<Code> = arguments
                    .iter()
                    .map(|argument| match argument {
                        Argument::Value(id) => self.argument(*id),
                        other => argument_text(&text(other)),
                    })
                    .collect();
                let names = self.collected.code_names(module_key(&function.module), &[], &[]);
                let code = code.with_arguments(&arguments);
                return (code.wgsl(level::LOWEST, &names), code.level());
            }
        };
        let arguments: Vec<String> = arguments.iter().map(text).collect();
        (format!("{name}({})", arguments.join(", ")), level::ATOM)
    }

    /// A value as a part of an expression: by its name, but for conversions that come to
    /// expressions of it.
    fn argument(&self, id: ValueId) -> Code {
        match (&self.special.values[id].operation, self.specialized.get(&id)) {
            (Operation::Convert { value, .. }, Some(CallForm::Expression(code, _)))
                if !self.is_host(id) =>
            {
                code.with_arguments(&[self.argument(*value)])
            }
            (Operation::Call { .. }, _) if self.is_nested(id) => self.nested(id),
            _ => argument_text(&self.expression(id)),
        }
    }

    /// A constant as WGSL writes it; `node` says whose structs are meant.
    pub(super) fn literal(&self, value: &Value, ty: &Type, node: usize) -> String {
        let module = &self.graph.nodes[node].def.module;
        match value {
            Value::Struct(parts) => {
                let declaration = module.declaration(ty.wgsl());
                let parts: Vec<String> = parts
                    .iter()
                    .enumerate()
                    .map(|(i, part)| {
                        let ty = declaration
                            .and_then(|d| d.scanned.fields.get(i))
                            .map(|field| Type::from_wgsl(&field.ty));
                        self.literal(part, &ty.unwrap_or(Type::Float), node)
                    })
                    .collect();
                format!("{}({})", self.type_name(ty, node), parts.join(", "))
            }
            // `array(...)` takes its type from the elements, all of which are vectors.
            Value::Array(parts) => {
                let element =
                    if parts.first().and_then(Value::components).is_some_and(|c| c.len() == 4) {
                        Type::Vec4
                    } else {
                        Type::Float
                    };
                let parts: Vec<String> =
                    parts.iter().map(|part| self.literal(part, &element, node)).collect();
                format!("array({})", parts.join(", "))
            }
            Value::Vector(scalars) => vector_literal(scalars),
            Value::Matrix { columns, components } => {
                let rows = components.len() / columns;
                let numbers: Vec<String> = components.iter().map(|x| float_literal(*x)).collect();
                format!("mat{columns}x{rows}f({})", numbers.join(", "))
            }
            Value::Bool(b) => b.to_string(),
            Value::I32(i) => format!("{i}i"),
            Value::U32(u) => format!("{u}u"),
            Value::Float(x) => float_literal(*x),
        }
    }

    /// A type's name in this module, where a project's own struct may have been renamed.
    pub(super) fn type_name(&self, ty: &Type, node: usize) -> String {
        let module = &self.graph.nodes[node].def.module;
        match ty {
            Type::Prepared(name) => self.collected.name(module, name).to_owned(),
            other => other.wgsl().to_owned(),
        }
    }
}

/// Text of an argument as a part of an expression.
fn argument_text(text: &str) -> Code {
    let level = if text.starts_with('-') { level::UNARY } else { level::ATOM };
    Code::Argument(text.into(), level)
}

fn vector_literal(scalars: &[Scalar]) -> String {
    let kind = match scalars.first() {
        Some(Scalar::Float(_)) | None => "f",
        Some(Scalar::I32(_)) => "i",
        Some(Scalar::U32(_)) => "u",
        Some(Scalar::Bool(_)) => "<bool>",
    };
    let texts: Vec<String> = scalars
        .iter()
        .map(|scalar| match scalar {
            Scalar::Float(x) => float_literal(*x),
            other => other.to_string(),
        })
        .collect();
    let all_same = texts.iter().all(|text| *text == texts[0]);
    let inside = if all_same { texts[0].clone() } else { texts.join(", ") };
    format!("vec{}{kind}({inside})", scalars.len())
}

/// The shortest decimal that reads back as the same f32.
pub(in crate::compile) fn float_literal(x: f64) -> String {
    let x = x as f32;
    if x.is_finite() {
        format!("{x:?}")
    } else {
        // Folding keeps what is not finite from coming here; WGSL has no literal for it.
        "0.0".to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_read_back_exactly() {
        for x in [0.1f32, 1e-30, -3.4e38, 16_777_216.0, std::f32::consts::PI] {
            assert_eq!(float_literal(f64::from(x)).parse::<f32>(), Ok(x));
        }
        assert_eq!(float_literal(1.0), "1.0");
        assert_eq!(vector_literal(&[Scalar::Float(0.5); 3]), "vec3f(0.5)");
        assert_eq!(vector_literal(&[Scalar::Float(0.5), Scalar::Float(1.0)]), "vec2f(0.5, 1.0)");
    }
}
