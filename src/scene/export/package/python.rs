//! A look in Python: shaders, bindings, parameters and host work as constants and functions.
//!
//! `LOOK` is what `LOOK.js` of other packages has, `SHADERS` the GLSL ES 3.00 of each module, and
//! `prepare(module, state)` gives the bytes of a module's uniform `look`. The text needs
//! `import copy, math, struct` before it.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use super::super::host_code::{PYTHON, translate};
use super::super::program::ParameterSetting;
use super::{PackageRequest, javascript};
use crate::diag::Diagnostic;
use crate::document::Target;
use crate::library::Type;

/// Functions that take what is set from outside.
const HOST: &str = include_str!("shared/host.py");

/// Writes the look.
///
/// # Errors
/// Host work that Python cannot express.
pub(super) fn write(request: &PackageRequest<'_>) -> Result<String, Diagnostic> {
    let (description, work) = (request.description, request.work);
    let described = json!(description);
    let mut modules = Map::new();
    let mut shaders = "SHADERS = {\n".to_owned();
    for module in described["modules"].as_array().into_iter().flatten() {
        let name = module["name"].as_str().unwrap_or_default();
        let object = javascript::module_object(module, &described);
        modules.insert(name.to_owned(), Value::Object(object));
        let source =
            |ending: &str| quoted(&javascript::source(request.sources, "glsl-es300", name, ending));
        let (vertex, fragment) = (source(".vert"), source(".frag"));
        let _ = write!(shaders, "    {}: (\n{vertex},\n{fragment},\n    ),\n", json!(name));
    }
    shaders += "}\n";
    let look = json!({
        "name": described["look"],
        "chiaro": described["chiaro"],
        "colorSpace": described["color_space"],
        "opaque": described["opaque"],
        "tiers": described["tiers"],
        "parameters": javascript::parameters(description, work),
        "lights": javascript::lights(description),
        "images": described["images"],
        "passes": javascript::passes(&described),
        "modules": modules,
    });
    let mut text = "# Parameters, lights, passes and bindings of the look.\n".to_owned();
    let _ = writeln!(text, "LOOK = {}\n", literal(&look, 0));
    let _ = writeln!(text, "# Vertex and fragment shader of each module, GLSL ES 3.00.\n{shaders}");
    let mut functions: Vec<&str> = work.modules.iter().map(|it| it.function.as_str()).collect();
    if work.is_keyed {
        functions.push("keyed");
    }
    if !functions.is_empty() {
        text += &translate(&work.wgsl, &functions, &PYTHON)?;
    }
    text += "\n# Functions that make the numbers of uniforms, with the words that are integers.\n\
             NUMBERS = {\n";
    for module in &work.modules {
        let (name, function) = (json!(module.module), &module.function);
        let _ = writeln!(text, "    {name}: ({function}, {:?}),", module.integers);
    }
    let _ = writeln!(text, "}}\nIS_KEYED = {}", if work.is_keyed { "True" } else { "False" });
    let near: Map<String, Value> =
        work.near.iter().map(|(id, member)| (member.clone(), json!(id))).collect();
    let _ = writeln!(text, "NEAR_OBJECTS = {}\n\n{HOST}\n", literal(&Value::Object(near), 0));
    text += &settings(request);
    Ok(text)
}

/// The function that brings a state into the form that the host work takes.
fn settings(request: &PackageRequest<'_>) -> String {
    let work = request.work;
    let own: Map<String, Value> =
        work.lights.iter().map(|light| (light.id.to_string(), json!(light.light))).collect();
    let mut text = format!(
        "\n# Lights of the look, each in its own frame.\nOWN_LIGHTS = {}\n\n\n\
         # Parameters and lights of a state, as the host work takes them.\n\
         def settings_of(state):\n    \
             parameters = state.get(\"parameters\", {{}})\n    \
             lights = state.get(\"lights\", {{}})\n    \
             return {{\n",
        literal(&Value::Object(own), 0)
    );
    for setting in &work.parameters {
        let _ = writeln!(text, "        \"{}\": {},", setting.member, parameter(setting));
    }
    for light in &work.lights {
        let id = json!(light.id);
        let mut given = String::new();
        for exposed in &request.look.exposed {
            if let Target::Light { light: other, field } = &exposed.target
                && *other == light.id
            {
                let _ = write!(given, ", {{\"{field}\": parameters.get({})}}", json!(exposed.name));
            }
        }
        // What is set outright goes before what a parameter says.
        let _ = writeln!(
            text,
            "        \"{}\": light_of(OWN_LIGHTS[{id}]{given}, lights.get({id}, {{}})),",
            light.member
        );
    }
    if work.parameters.is_empty() && work.lights.is_empty() {
        text += "        \"nothing\": 0.0,\n";
    }
    text + "    }\n"
}

/// The expression of a parameter's value in a state.
fn parameter(setting: &ParameterSetting) -> String {
    let value = javascript::value(&setting.default);
    let own = literal(&value, 0);
    let Some(name) = &setting.name else { return own };
    let given = format!("parameters.get({})", json!(name));
    match setting.ty {
        Type::Bool => format!("truth_of({given}, {own})"),
        Type::Float => format!("number_of({given}, {own})"),
        Type::Int => format!("whole_of({given}, {own})"),
        Type::Color | Type::Composite => format!("vector_of({given}, {own}, True)"),
        Type::Mat3 => {
            let given = format!("{given} or [x for column in {own} for x in column]");
            format!("matrix_of({given})")
        }
        _ => format!("vector_of({given}, {own})"),
    }
}

/// A JSON value as Python, its lines after the first indented by four times `depth`.
pub(super) fn literal(value: &Value, depth: usize) -> String {
    let is_flat = |value: &Value| !value.is_array() && !value.is_object();
    let lines = |open: &str, parts: Vec<String>, close: &str| {
        let inner = "    ".repeat(depth + 1);
        let parts: String = parts.iter().map(|part| format!("{inner}{part},\n")).collect();
        format!("{open}\n{parts}{}{close}", "    ".repeat(depth))
    };
    match value {
        Value::Null => "None".to_owned(),
        Value::Bool(x) => if *x { "True" } else { "False" }.to_owned(),
        Value::Array(parts) if parts.iter().all(is_flat) => {
            let parts: Vec<String> = parts.iter().map(|part| literal(part, depth)).collect();
            format!("[{}]", parts.join(", "))
        }
        Value::Array(parts) => {
            lines("[", parts.iter().map(|part| literal(part, depth + 1)).collect(), "]")
        }
        Value::Object(members) if members.is_empty() => "{}".to_owned(),
        Value::Object(members) => {
            let member = |(name, value): (&String, &Value)| {
                format!("{}: {}", json!(name), literal(value, depth + 1))
            };
            let parts: Vec<String> = members.iter().map(member).collect();
            let short = format!("{{{}}}", parts.join(", "));
            let is_short = short.len() + 4 * depth <= 88 && !short.contains('\n');
            if is_short { short } else { lines("{", parts, "}") }
        }
        other => other.to_string(),
    }
}

/// Text between three quotes.
fn quoted(text: &str) -> String {
    format!("\"\"\"{}\"\"\"", text.replace('\\', "\\\\").replace("\"\"\"", "\\\"\\\"\\\""))
}
