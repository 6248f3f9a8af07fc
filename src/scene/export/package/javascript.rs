//! A look in JavaScript: shaders, bindings, parameters and host work as one object.
//!
//! The object is what docs/hosts.md describes as `LOOK.json`, with two differences: a module
//! holds its shaders' texts, and in the place of `host` it has `prepare(state)`, which returns the
//! bytes of its uniform `look`.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use super::super::ExportFile;
use super::super::description::Description;
use super::super::host_code::{JAVASCRIPT, translate};
use super::super::pretty::pretty;
use super::super::program::{HostWork, ParameterSetting};
use crate::diag::Diagnostic;
use crate::document::{Look, Target};
use crate::interp;
use crate::library::Type;

/// Languages of the shaders in the object.
pub(super) const LANGUAGES: [&str; 2] = ["wgsl", "glsl-es300"];

/// Functions that take what is set from outside.
const HOST: &str = include_str!("shared/host.js");

/// Files of a module in a language: slug, module, files.
pub(super) type Source = (&'static str, &'static str, Vec<ExportFile>);

/// Writes the look as an expression.
///
/// # Errors
/// Host work that JavaScript cannot express.
pub(super) fn write(
    look: &Look,
    description: &Description,
    work: &HostWork,
    sources: &[Source],
) -> Result<String, Diagnostic> {
    let mut functions: Vec<&str> =
        work.modules.iter().map(|module| module.function.as_str()).collect();
    if work.is_keyed {
        functions.push("keyed");
    }
    let mut text = "(() => {\n".to_owned();
    if !functions.is_empty() {
        text += &indented(HOST);
        text.push('\n');
        text += &indented(&translate(&work.wgsl, &functions, &JAVASCRIPT)?);
        text.push('\n');
        text += &indented(&settings(look, work));
        text.push('\n');
    }
    let described = json!(description);
    let mut object = Map::new();
    object.insert("name".into(), described["look"].clone());
    object.insert("chiaro".into(), described["chiaro"].clone());
    object.insert("colorSpace".into(), described["color_space"].clone());
    object.insert("opaque".into(), described["opaque"].clone());
    object.insert("tiers".into(), described["tiers"].clone());
    object.insert("parameters".into(), parameters(description, work));
    object.insert("lights".into(), lights(description));
    object.insert("images".into(), described["images"].clone());
    object.insert("passes".into(), passes(&described));
    let mut body = pretty(&Value::Object(object));
    // The modules hold text and functions, which JSON cannot.
    body.truncate(body.trim_end().trim_end_matches('}').trim_end().len());
    body += ",\n  \"modules\": {\n";
    for module in described["modules"].as_array().into_iter().flatten() {
        body += &module_text(module, &described, work, sources);
    }
    body += "  }\n}";
    let _ = writeln!(text, "  return {};\n}})()", indented(&body).trim());
    Ok(text)
}

fn indented(text: &str) -> String {
    // Lines within a text in backquotes keep their place.
    let mut result = String::new();
    let mut is_quoted = false;
    for line in text.lines() {
        if !line.is_empty() && !is_quoted {
            result += "  ";
        }
        result += line;
        result.push('\n');
        if line.matches('`').count() % 2 == 1 {
            is_quoted = !is_quoted;
        }
    }
    result
}

/// Functions that bring a state into the form that the host work takes.
fn settings(look: &Look, work: &HostWork) -> String {
    let mut text = String::new();
    let own: Map<String, Value> =
        work.lights.iter().map(|light| (light.id.to_string(), json!(light.light))).collect();
    let _ = writeln!(text, "// Lights of the look, each in its own frame.");
    let _ = writeln!(text, "const own_lights = {};\n", pretty(&Value::Object(own)).trim_end());
    let _ = writeln!(text, "const settings_of = ({{ parameters = {{}}, lights = {{}} }}) => ({{");
    for setting in &work.parameters {
        let _ = writeln!(text, "  {}: {},", setting.member, parameter(setting));
    }
    for light in &work.lights {
        let id = json!(light.id);
        let mut given = String::new();
        for exposed in &look.exposed {
            if let Target::Light { light: other, field } = &exposed.target
                && *other == light.id
            {
                let _ = write!(given, ", {{ {field}: parameters[{}] }}", json!(exposed.name));
            }
        }
        // What is set outright goes before what a parameter says.
        let _ = writeln!(
            text,
            "  {}: light_of(own_lights[{id}]{given}, lights[{id}] ?? {{}}),",
            light.member
        );
    }
    text += "});\n";
    if !work.near.is_empty() {
        text += "\n// Distances of other objects, in scene units.\n";
    }
    let near: Vec<String> = work
        .near
        .iter()
        .map(|(id, member)| format!("{member}: number_of(around.near[{}], 1e6)", json!(id)))
        .collect();
    let around = "const around = surroundings_of(state);";
    text += &format!("\nconst prepared = (state, numbers, integers) => {{\n  {around}\n");
    if !near.is_empty() {
        let _ = writeln!(text, "  Object.assign(around, {{ {} }});", near.join(", "));
    }
    let settings =
        if work.is_keyed { "keyed(settings_of(state), around)" } else { "settings_of(state)" };
    let _ = writeln!(text, "  return bytes_of(numbers({settings}, around), integers);\n}};");
    text
}

/// The expression of a parameter's value in a state.
fn parameter(setting: &ParameterSetting) -> String {
    let own = value(&setting.default).to_string();
    let Some(name) = &setting.name else { return own };
    let given = format!("parameters[{}]", json!(name));
    match setting.ty {
        Type::Bool => format!("truth_of({given}, {own})"),
        Type::Float | Type::Int => format!("number_of({given}, {own})"),
        Type::Color | Type::Composite => format!("vector_of({given}, {own}, true)"),
        Type::Mat3 => format!("matrix_of({given} ?? {own}.flat())"),
        _ => format!("vector_of({given}, {own})"),
    }
}

/// A value as JSON: lists for vectors, columns for matrices.
pub(super) fn value(value: &interp::Value) -> Value {
    match value {
        interp::Value::Bool(x) => json!(x),
        interp::Value::I32(x) => json!(x),
        interp::Value::U32(x) => json!(x),
        interp::Value::Float(x) => json!(x),
        interp::Value::Vector(scalars) => {
            json!(scalars.iter().map(|scalar| scalar.as_f64()).collect::<Vec<_>>())
        }
        interp::Value::Matrix { columns, components } => {
            let rows = components.len() / columns.max(&1);
            json!(components.chunks(rows.max(1)).collect::<Vec<_>>())
        }
        interp::Value::Array(parts) | interp::Value::Struct(parts) => {
            json!(parts.iter().map(self::value).collect::<Vec<_>>())
        }
    }
}

/// The exposed parameters; colors are lists of four numbers, in the look's own space.
pub(super) fn parameters(description: &Description, work: &HostWork) -> Value {
    let mut list = Vec::new();
    for (index, parameter) in description.parameters.iter().enumerate() {
        let Some(name) = &parameter.name else { continue };
        let mut object = match json!(parameter) {
            Value::Object(object) => object,
            _ => Map::new(),
        };
        object.remove("name");
        object.insert("key".into(), json!(name));
        if let Some(setting) = work.parameters.iter().find(|setting| setting.index == index) {
            object.insert("default".into(), value(&setting.default));
        }
        list.push(Value::Object(object));
    }
    json!(list)
}

pub(super) fn lights(description: &Description) -> Value {
    let light = |light: &super::super::description::LightDescription| {
        let mut object = match json!(light.values) {
            Value::Object(object) => object,
            _ => Map::new(),
        };
        object.insert("id".into(), json!(light.id));
        object.insert("label".into(), json!(light.label));
        object.insert("fields".into(), json!(light.fields));
        Value::Object(object)
    };
    json!(description.lights.iter().map(light).collect::<Vec<_>>())
}

/// The passes; the parameter that decides about sides by its name.
pub(super) fn passes(described: &Value) -> Value {
    let mut passes = described["passes"].clone();
    for pass in passes.as_array_mut().into_iter().flatten() {
        let index = pass["sides_parameter"].as_u64();
        let name =
            index.and_then(|index| described["parameters"][index as usize].get("name").cloned());
        if let Some(object) = pass.as_object_mut() {
            object.remove("sides_parameter");
            if let Some(name) = name {
                object.insert("sides_parameter".into(), name);
            }
        }
    }
    passes
}

/// A module: its bindings with their places in each language.
pub(super) fn module_object(module: &Value, described: &Value) -> Map<String, Value> {
    let name = module["name"].as_str().unwrap_or_default();
    let mut object = Map::new();
    let entry = |stage: &str| {
        let points = module["entry_points"].as_array().into_iter().flatten();
        points.clone().find(|point| point["stage"] == stage).cloned().unwrap_or_default()
    };
    object.insert("purpose".into(), module["purpose"].clone());
    let of = |language: &str| {
        let modules = described["languages"][language]["modules"].as_array().into_iter().flatten();
        modules.clone().find(|found| found["module"] == name).cloned().unwrap_or_default()
    };
    let (wgsl, glsl) = (of("wgsl"), of("glsl-es300"));
    let place = |language: &Value, binding: &Value| {
        let bindings = language["bindings"].as_array().into_iter().flatten();
        bindings.clone().find(|found| found["binding"] == *binding).cloned().unwrap_or_default()
    };
    let attribute = |attribute: &Value| {
        let mut attribute = attribute.clone();
        let names = glsl["attributes"].as_array().into_iter().flatten();
        let own = names.clone().find(|found| found["attribute"] == attribute["name"]);
        attribute["glsl"] = own.map_or(Value::Null, |found| found["name"].clone());
        attribute
    };
    let attributes = entry("vertex")["attributes"].as_array().cloned().unwrap_or_default();
    object.insert("attributes".into(), attributes.iter().map(attribute).collect());
    object.insert("outputs".into(), entry("fragment").get("outputs").cloned().unwrap_or_default());
    let binding = |binding: &Value| {
        let mut binding = binding.clone();
        let (in_wgsl, in_glsl) = (place(&wgsl, &binding["name"]), place(&glsl, &binding["name"]));
        binding["wgsl"] = in_wgsl["at"].clone();
        if !in_glsl.is_null() {
            binding["glsl"] = json!({"name": in_glsl["name"]});
            if let Some(sampler) = in_glsl.get("sampler") {
                binding["glsl"]["sampler"] = sampler.clone();
            }
        }
        binding
    };
    let bindings = module["bindings"].as_array().cloned().unwrap_or_default();
    object.insert("bindings".into(), bindings.iter().map(binding).collect());
    object.insert(
        "entry_points".into(),
        json!({"vertex": entry("vertex")["name"], "fragment": entry("fragment")["name"]}),
    );
    object
}

/// The text of a module's file in a language.
pub(super) fn source(sources: &[Source], language: &str, module: &str, ending: &str) -> String {
    let mut found = sources.iter().filter(|it| it.0 == language && it.1 == module);
    let files = found.next().map(|it| it.2.as_slice()).unwrap_or_default();
    let file = files.iter().find(|file| file.name.ends_with(ending));
    file.map(|file| String::from_utf8_lossy(&file.bytes).into_owned()).unwrap_or_default()
}

/// A module with its texts and its host work.
fn module_text(module: &Value, described: &Value, work: &HostWork, sources: &[Source]) -> String {
    let name = module["name"].as_str().unwrap_or_default();
    let mut body = pretty(&Value::Object(module_object(module, described)));
    body.truncate(body.trim_end().trim_end_matches('}').trim_end().len());
    let source = |language: &str, ending: &str| quoted(&source(sources, language, name, ending));
    let _ = write!(body, ",\n  \"wgsl\": {},\n", source("wgsl", ".wgsl"));
    let _ = writeln!(
        body,
        "  \"glsl\": {{\n    \"vertex\": {},\n    \"fragment\": {}\n  }},",
        source("glsl-es300", ".vert"),
        source("glsl-es300", ".frag")
    );
    if let Some(numbers) = work.modules.iter().find(|it| it.module == name) {
        let _ = writeln!(
            body,
            "  \"prepare\": (state) => prepared(state, {}, {:?}),",
            numbers.function, numbers.integers
        );
    }
    body += "}";
    format!("    {}: {},\n", json!(name), indented(&indented(&body)).trim())
}

/// Text between backquotes.
fn quoted(text: &str) -> String {
    let escaped = text.replace('\\', "\\\\").replace('`', "\\`").replace("${", "\\${");
    format!("`{escaped}`")
}
