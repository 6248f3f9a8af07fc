//! Checks of the values that exposed parameters are set to.

use crate::compile::{Live, TypedGraph, TypedSource, typed_value};
use crate::diag::Diagnostic;
use crate::document::{LightField, Look, Target, Value};
use crate::library::Type;

/// The liveness `live`, raised so that values that are set by name are seen.
pub(super) fn live_for_values(live: &Live, any_set: bool) -> Live {
    if any_set && *live == Live::Keyed { Live::Exposed } else { live.clone() }
}

/// The error of setting the exposed parameter `name` of `look` to `value`; `None` if the value
/// fits, or if there is no parameter of that name.
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
    // Words and lights' ids are not inputs of the typed graph; setting them compiles the look anew,
    // which reports errors.
    let is_it = |id: usize| typed.params[id].path == *node && typed.params[id].port == *port;
    let mut inputs = typed.nodes.iter().flat_map(|node| node.inputs.iter().flatten());
    let input =
        inputs.find(|input| matches!(&input.source, TypedSource::Param(id, _) if is_it(*id)))?;
    let is_path = input.ty.is_texture() && matches!(value, Value::Text(_));
    typed_value(value, &input.ty).err().filter(|_| !is_path).map(wrong)
}
