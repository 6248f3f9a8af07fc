//! Nodes as JSON, for scripts and other editors.

use serde_json::{Value as Json, json};

use super::entry::NodeEntry;
use crate::library::{Fallback, Input};

pub(super) fn pretty(value: &Json) -> String {
    serde_json::to_string_pretty(value).unwrap_or_default()
}

pub(super) fn entry(entry: &NodeEntry) -> Json {
    let outputs = entry.outputs.iter().map(|output| {
        json!({
            "name": output.name, "label": output.label, "type": output.ty.to_string(),
            "help": output.help
        })
    });
    let presets = entry.presets.iter().map(|preset| {
        let values: serde_json::Map<String, Json> =
            preset.values.iter().map(|(name, value)| (name.to_string(), json!(value))).collect();
        json!({"label": preset.label, "values": values})
    });
    let errors = entry
        .errors
        .iter()
        .map(|error| json!({"tier": error.tier, "bound": error.bound, "help": error.help}));
    json!({
        "kind": entry.kind,
        "label": entry.label,
        "category": entry.category,
        "group": entry.is_group,
        "help": entry.help,
        "inputs": entry.inputs.iter().map(input).collect::<Vec<_>>(),
        "outputs": outputs.collect::<Vec<_>>(),
        "presets": presets.collect::<Vec<_>>(),
        "also": entry.widths.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "tiers": entry.tiers,
        "errors": errors.collect::<Vec<_>>(),
        "sources": entry.sources,
    })
}

/// JSON of an input; fields that it lacks are left out.
fn input(input: &Input) -> Json {
    let mut told = json!({
        "name": input.name, "label": input.label, "type": input.ty.to_string(), "help": input.help
    });
    match &input.fallback {
        Fallback::Value(value) => told["default"] = json!(value),
        Fallback::Context(context) => told["from"] = json!(context.word()),
        Fallback::Same(other) => told["same"] = json!(other),
        Fallback::Wire => told["wire"] = json!(true),
    }
    for (key, number) in [("min", input.min), ("max", input.max)] {
        if let Some(number) = number {
            told[key] = json!(number);
        }
    }
    if !input.unit.is_empty() {
        told["unit"] = json!(input.unit);
    }
    if !input.options.is_empty() {
        let option = |(word, label): &(String, String)| json!({"word": word, "label": label});
        told["choices"] = input.options.iter().map(option).collect();
    }
    told
}
