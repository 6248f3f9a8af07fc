//! The graph of another program, as its reader hands it to [`build`](super::build).

use chiaro_locale::tr;

use crate::diag::{Diagnostic, LineColumn};
use crate::document::Value;

/// A graph whose groups are unrolled.
#[derive(Debug, Default)]
pub(super) struct ForeignGraph {
    /// Name of the material.
    pub(super) name: String,
    /// Name of the program, for messages.
    pub(super) program: &'static str,
    /// All nodes, in the order of the file.
    pub(super) nodes: Vec<ForeignNode>,
    /// Color of the surface.
    pub(super) result: ForeignSource,
    /// Problems of the file that the graph does without.
    pub(super) problems: Vec<Diagnostic>,
}

/// A node of the other program.
#[derive(Debug, Default)]
pub(super) struct ForeignNode {
    /// Name of the node in the file.
    pub(super) name: String,
    /// Kind of the node, such as `multiply` or `ShaderNodeMath`.
    pub(super) kind: String,
    /// Setting that decides which row of the table is meant, such as an operation.
    pub(super) variant: String,
    /// Type of the result, or of what is taken apart, such as `color3`.
    pub(super) ty: String,
    /// Title of the group that the node lies in; empty for none.
    pub(super) group: String,
    /// Height on the canvas, downward: nodes beside one another keep their order.
    pub(super) height: f64,
    /// Inputs that the file says something about.
    pub(super) inputs: Vec<ForeignInput>,
    /// Place of the node in the file.
    pub(super) place: Option<LineColumn>,
}

/// An input of a node.
#[derive(Debug)]
pub(super) struct ForeignInput {
    /// Name of the input, as recipes know it.
    pub(super) name: String,
    /// Value or link.
    pub(super) source: ForeignSource,
    /// True if the file says so, and the value is no default that the file repeats.
    pub(super) is_authored: bool,
}

/// Source of an input's value.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) enum ForeignSource {
    /// Nothing: the default of the node.
    #[default]
    Nothing,
    /// A value.
    Value(Value),
    /// A parameter of the material, with a name and its value.
    Parameter(String, Value),
    /// An output of a node: its index, and the name of the output; empty for the only one.
    Link(usize, String),
}

impl ForeignNode {
    /// Source of an input.
    pub(super) fn input(&self, name: &str) -> Option<&ForeignInput> {
        self.inputs.iter().find(|input| input.name == name)
    }
}

/// Finite number that a look can hold, for one of a file.
pub(super) fn bounded(number: f64) -> f64 {
    if number.is_nan() { 0.0 } else { number.clamp(-3.4e38, 3.4e38) }
}

/// Text of a value, for notes.
pub(super) fn shown(value: &Value) -> String {
    match value {
        Value::Bool(on) => on.to_string(),
        Value::Number(number) => number.to_string(),
        Value::Vector(numbers) => {
            let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
            numbers.join(", ")
        }
        Value::Text(text) => text.chars().take(200).collect(),
        Value::Curve(_) => tr!("a curve").to_owned(),
        Value::Ramp(_) => tr!("a ramp").to_owned(),
    }
}
