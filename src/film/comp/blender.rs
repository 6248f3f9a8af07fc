//! Blender: a script that makes a scene whose compositor puts the picture together.

use chiaro_locale::tr;
use serde_json::json;

use super::{Comp, LayerSpace};
use crate::diag::Diagnostic;
use crate::exr::SampleType;

/// The script, which reads what the picture is from the line that holds [`PLACE`].
const SCRIPT: &str = include_str!("blender.py");
const PLACE: &str = "{}";

pub(super) fn write(comp: &Comp) -> Result<String, Diagnostic> {
    let parts = comp.parts.parts.iter();
    let parts: Vec<_> =
        parts.map(|part| json!({"layer": part.layer, "label": part.label})).collect();
    let data = json!({
        "name": comp.name,
        "first_file": comp.first_file,
        "frames": comp.frames,
        "rate": [comp.rate.frames, comp.rate.seconds],
        "size": comp.size,
        "depth": if comp.samples == SampleType::Half { "16" } else { "32" },
        "parts": parts,
        "whole": comp.parts.whole,
        "is_display": comp.parts.space == LayerSpace::Display,
        "mattes": comp.mattes,
        "output": comp.output,
    });
    let data = serde_json::to_string_pretty(&data).map_err(|error| {
        Diagnostic::error("no-comp", tr!("the document cannot be written: {error}"))
    })?;
    let about = comp.about().replace(char::is_control, " ");
    Ok(format!("# {about}\n{}", SCRIPT.replacen(PLACE, &data, 1)))
}
