//! What an exposed parameter may be set to.

use crate::compile::{Live, TypedGraph, TypedSource, typed_value};
use crate::diag::Diagnostic;
use crate::document::{LightField, Look, Target, Value};
use crate::library::Type;

/// As alive as `live`, and at least so that values which are set by name are seen.
pub(super) fn live_for_values(live: &Live, any_set: bool) -> Live {
    if any_set && *live == Live::Keyed { Live::Exposed } else { live.clone() }
}

/// What is wrong with setting the exposed parameter `name` of `look` to `value`; `None` where
/// nothing is, or where there is no parameter of that name.
pub fn check_exposed_value(
    look: &Look,
    typed: &TypedGraph,
    name: &str,
    value: &Value,
) -> Option<Diagnostic> {
    let target = &look.exposed.iter().find(|exposed| exposed.name.as_str() == name)?.target;
    let wrong = |message: String| Diagnostic::error("wrong-type", format!("`{name}`: {message}"));
    let (node, port) = match target {
        Target::Input { node, port } => (node, port),
        Target::Light { field, .. } => {
            let ty = Type::of_light_field(LightField::named(field)?);
            return typed_value(value, &ty).err().map(wrong);
        }
    };
    // Words and lights' ids are no inputs of what was typed; setting them compiles the look anew,
    // which tells.
    let is_it = |id: usize| typed.params[id].path == *node && typed.params[id].port == *port;
    let mut inputs = typed.nodes.iter().flat_map(|node| node.inputs.iter().flatten());
    let input =
        inputs.find(|input| matches!(&input.source, TypedSource::Param(id, _) if is_it(*id)))?;
    let is_path = input.ty.is_texture() && matches!(value, Value::Text(_));
    typed_value(value, &input.ty).err().filter(|_| !is_path).map(wrong)
}
