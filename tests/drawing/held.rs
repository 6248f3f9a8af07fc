//! One node at a time on the GPU: each of its numbers is set for each sample, and no number is
//! known before the fragment.

use chiaro_compiler::document::{Value, Values};
use chiaro_compiler::library::{Input, Library, NodeDef, Type};
use chiaro_scene::frame::{EvalSample, SetupLook};
use serde_json::{Map, Value as Json, json};

use crate::eval::{eval_with, look, options};

/// Numbers of all inputs that are no choices, in the order of `numeric`.
pub type SampleInputs<'a> = &'a [Vec<f64>];

/// The library with nodes that hand a value on at each fragment, so that the compiler knows nothing
/// of the value.
pub fn library() -> Library {
    let mut library = Library::built_in().clone();
    for (name, ty, default) in [
        ("float", "f32", "0"),
        ("vec2", "vec2f", "0,0"),
        ("vec3", "vec3f", "0,0,0"),
        ("color", "Color", "0,0,0,1"),
    ] {
        let code = format!(
            "import chiaro::types;\n\n/// Hold\n///\n/// Not known before the fragment.\n///\n\
             /// @param value \"Value\" default={default} : Any.\n/// @param depth from=depth \
             hidden\n\
             /// @return value \"Value\" : The same.\n\
             fn hold_{name}(value: {ty}, depth: f32) -> {ty} {{\n    return select(value, value + \
             1.0, depth > 1e30);\n}}\n"
        );
        library.add_file(&format!("nodes/test/hold_{name}.wgsl"), &code);
    }
    assert!(library.problems.is_empty(), "{:?}", library.problems);
    library
}

/// The kind of the node that holds a value of a type.
pub fn hold_of(ty: &Type) -> &'static str {
    match ty {
        Type::Vec2 => "hold_vec2",
        Type::Vec3 => "hold_vec3",
        Type::Color | Type::Composite => "hold_color",
        _ => "hold_float",
    }
}

/// Number of components of a type.
pub fn width(ty: &Type) -> usize {
    match ty {
        Type::Vec2 => 2,
        Type::Vec3 => 3,
        Type::Color | Type::Composite => 4,
        _ => 1,
    }
}

/// The visible inputs that carry numbers.
pub fn numeric(def: &NodeDef) -> Vec<&Input> {
    let is_number = |input: &&Input| {
        input.options.is_empty()
            && !matches!(
                input.ty,
                Type::Curve
                    | Type::Ramp
                    | Type::Image
                    | Type::Hcbtf
                    | Type::LightName
                    | Type::Text
                    | Type::Light
                    | Type::Angle
            )
    };
    def.visible_inputs().filter(is_number).collect()
}

/// A node of a kind with every number held, each settable under the input's own name.
pub fn bench(def: &NodeDef, choice: &[(&str, &str)], types: &[Type]) -> SetupLook {
    let mut nodes = vec![json!({"id": "output", "kind": "output"})];
    let (mut wires, mut exposed) = (Vec::new(), Vec::new());
    for (input, ty) in numeric(def).iter().zip(types) {
        let hold = format!("hold_{}", input.name);
        nodes.push(json!({"id": hold, "kind": hold_of(ty)}));
        wires.push(json!({"from": hold, "to": format!("node.{}", input.name)}));
        exposed.push(json!({"name": input.name.as_str(), "target": format!("{hold}.value")}));
    }
    // A light input is fed the light `key`; an angle input, that light's angle with the surface's
    // normal.
    let feeds = def.visible_inputs().filter_map(|input| match input.ty {
        Type::Light => Some(("light", &input.name)),
        Type::Angle => Some(("angle", &input.name)),
        _ => None,
    });
    let feeds: Vec<_> = feeds.collect();
    if !feeds.is_empty() {
        nodes.push(json!({"id": "light", "kind": "light", "values": {"light": "key"}}));
        nodes.push(json!({"id": "angle", "kind": "parametrization"}));
        wires.push(json!({"from": "light", "to": "angle.light"}));
        wires.extend(
            feeds.iter().map(|(from, port)| json!({"from": from, "to": format!("node.{port}")})),
        );
    }
    let values: Map<String, Json> =
        choice.iter().map(|(port, word)| ((*port).to_owned(), json!(word))).collect();
    nodes.push(json!({"id": "node", "kind": def.kind, "values": values}));
    let is_shown = def.outputs.first().is_some_and(|output| output.ty.width().is_some());
    nodes.push(json!({"id": "blank", "kind": "color_value"}));
    wires.push(json!({"from": if is_shown { "node" } else { "blank" }, "to": "output.color"}));
    let lights = json!({"key": {"direction": [0, 0, 1]}});
    look(&json!({"lights": lights, "nodes": nodes, "wires": wires, "exposed": exposed}))
}

/// A sample of a surface with these numbers as inputs of the node on a [`bench()`].
pub fn sample(def: &NodeDef, inputs: SampleInputs<'_>, at: &EvalSample) -> EvalSample {
    let value = |numbers: &Vec<f64>| match numbers.as_slice() {
        [x] => Value::Number(*x),
        more => Value::Vector(more.to_vec()),
    };
    let values: Values = numeric(def)
        .iter()
        .zip(inputs)
        .map(|(input, numbers)| (input.name.clone(), value(numbers)))
        .collect();
    EvalSample { values, ..at.clone() }
}

/// Values of all outputs of a node, one after the other in a row for each sample.
pub fn run(
    def: &NodeDef,
    choice: &[(&str, &str)],
    types: &[Type],
    rows: &[Vec<Vec<f64>>],
    library: &Library,
) -> Vec<Vec<f64>> {
    let at = vec![EvalSample::default(); rows.len()];
    run_at(def, choice, types, rows, &at, library)
}

/// [`run`] at samples of a surface, one for each row.
pub fn run_at(
    def: &NodeDef,
    choice: &[(&str, &str)],
    types: &[Type],
    rows: &[Vec<Vec<f64>>],
    at: &[EvalSample],
    library: &Library,
) -> Vec<Vec<f64>> {
    let look = bench(def, choice, types);
    let samples: Vec<EvalSample> =
        rows.iter().zip(at).map(|(row, at)| sample(def, row, at)).collect();
    let mut all = vec![Vec::new(); rows.len()];
    for output in &def.outputs {
        // A node for any width gives the width of its first input.
        let wide = types
            .first()
            .filter(|_| output.ty == Type::Float && def.variants.iter().any(|v| v.width.is_some()));
        let numbers = width(wide.unwrap_or(&output.ty));
        let values =
            eval_with(&look, library, &options(&format!("node.{}", output.name)), &samples);
        for (row, value) in all.iter_mut().zip(values) {
            row.extend(&value[..numbers]);
        }
    }
    all
}

/// The name and the words of a kind's choice, or one pair of empty words.
pub fn words(def: &NodeDef) -> Vec<(String, String)> {
    let choice = def.visible_inputs().find(|input| !input.options.is_empty());
    choice.map_or_else(
        || vec![(String::new(), String::new())],
        |input| {
            input.options.iter().map(|(word, _)| (input.name.to_string(), word.clone())).collect()
        },
    )
}
