//! The program that computes the numbers of a module's `Look` uniform, as data.

use std::collections::{BTreeSet, HashMap};

use glam::DMat3;
use indexmap::IndexMap;
use serde::Serialize;
use serde_json::{Value, json};

use super::modules::Host;
use crate::compile::{HostInputs, HostStep, LightValues, ParamId};
use crate::ids::LightId;
use crate::interp;
use crate::library::{Context, ContextSource};

/// The program that computes the members of a module's `Look` uniform: run the steps in order, each
/// from the values of earlier ones, then write each member's step into the uniform at the member's
/// offset.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HostDescription {
    /// Name of the WGSL file with the functions that steps call; none where no step calls any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub functions: Option<String>,
    /// Surroundings that steps ask for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub contexts: Vec<ContextDescription>,
    /// Steps, which later steps name by index.
    pub steps: Vec<StepDescription>,
    /// Members of the uniform, in the order of the struct.
    pub members: Vec<MemberDescription>,
    /// The wires that drive direction keys.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drivers: Vec<DriverDescription>,
    /// Indices of the sets of direction keys in the order in which they take effect, where wires
    /// drive them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub key_order: Vec<usize>,
}

/// A wire that drives direction keys: a number for each object and frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DriverDescription {
    /// Name of the wire in `direction_keys`.
    pub wire: String,
    /// Step that computes the wire; its value is clamped to a million around 0, and is 0 where it
    /// is not a number.
    pub step: usize,
}

/// A value of the surroundings.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ContextDescription {
    /// Name of the surrounding in steps.
    pub name: &'static str,
    /// Type of the surrounding in WGSL.
    #[serde(rename = "type")]
    pub ty: &'static str,
    /// Meaning of the surrounding.
    pub meaning: &'static str,
}

/// A step of the program. Vectors, matrices (column after column), arrays and structs (in the order
/// of their members) are lists.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "op", rename_all = "snake_case")]
pub enum StepDescription {
    /// A constant.
    Constant {
        /// Value of the constant.
        value: Value,
    },
    /// The value of a parameter.
    Parameter {
        /// Index in `parameters`.
        parameter: usize,
        /// Type that the parameter is taken as; the same parameter may be a float in one step and a
        /// color in another.
        #[serde(rename = "type")]
        ty: String,
        /// Default of the parameter as that type, ready for use.
        value: Value,
    },
    /// A surrounding.
    Context {
        /// Name in `contexts`.
        context: &'static str,
        /// Light that the surrounding is a field of.
        #[serde(skip_serializing_if = "Option::is_none")]
        light: Option<LightId>,
    },
    /// A call of a function.
    Call {
        /// Name of the function in the file.
        function: String,
        /// Steps that give the arguments.
        arguments: Vec<usize>,
    },
    /// A member of a struct.
    Member {
        /// Step that gives the struct.
        of: usize,
        /// Index of the member, counted from 0.
        member: usize,
    },
}

/// A member of the `Look` uniform.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MemberDescription {
    /// Name of the member in the struct.
    pub name: String,
    /// Type of the member in the look. A `switch` is written as the unsigned integer 0 or 1.
    #[serde(rename = "type")]
    pub ty: String,
    /// Offset of the member in the uniform, in bytes.
    pub offset: u32,
    /// Node that reads the member, and the input or part.
    pub origin: String,
    /// Step that computes the member.
    pub step: usize,
    /// Parameters that the member depends on, by index.
    #[serde(skip_serializing_if = "BTreeSet::is_empty")]
    pub parameters: BTreeSet<usize>,
    /// Lights that the member depends on.
    #[serde(skip_serializing_if = "BTreeSet::is_empty")]
    pub lights: BTreeSet<LightId>,
    /// Surroundings that the member depends on.
    #[serde(skip_serializing_if = "BTreeSet::is_empty")]
    pub contexts: BTreeSet<&'static str>,
    /// Value of the member while parameters have their defaults; none where the member depends on
    /// anything else.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub default: Option<Value>,
}

/// Describes a host; `parameters` gives each live value's index in the description. `None` where
/// the module has no `Look` uniform.
pub(super) fn describe(
    host: &Host,
    parameters: &HashMap<ParamId, usize>,
) -> Option<HostDescription> {
    let program = &host.shader.host;
    if program.members.is_empty() && program.drivers.is_empty() {
        return None;
    }
    let steps = &host.source.steps;
    let used: BTreeSet<Context> = steps.iter().filter_map(context).collect();
    let contexts = used.into_iter().map(|context| ContextDescription {
        name: context.word(),
        ty: context.wgsl_type(),
        meaning: meaning(context),
    });
    let defaults = defaults(host);
    let member = |(index, member): (usize, &crate::compile::UniformMember)| {
        let mut found = MemberDescription {
            name: member.name.clone(),
            ty: member.ty.to_string(),
            offset: member.offset,
            origin: member.origin.clone(),
            step: member.step,
            parameters: BTreeSet::new(),
            lights: BTreeSet::new(),
            contexts: BTreeSet::new(),
            default: None,
        };
        found.depend(steps, parameters);
        if found.lights.is_empty() && found.contexts.is_empty() {
            found.default = defaults.get(index).map(stored);
        }
        found
    };
    Some(HostDescription {
        functions: host.file.clone(),
        contexts: contexts.collect(),
        steps: steps.iter().map(|step| describe_step(step, parameters)).collect(),
        members: program.members.iter().enumerate().map(member).collect(),
        drivers: program
            .drivers
            .iter()
            .map(|driver| DriverDescription { wire: driver.wire.to_string(), step: driver.step })
            .collect(),
        key_order: if program.drivers.is_empty() { Vec::new() } else { program.key_order.clone() },
    })
}

fn context(step: &HostStep) -> Option<Context> {
    if let HostStep::Context(context, _) = step { Some(*context) } else { None }
}

fn describe_step(step: &HostStep, parameters: &HashMap<ParamId, usize>) -> StepDescription {
    match step {
        HostStep::Constant(constant) => StepDescription::Constant { value: value(constant) },
        HostStep::Param { id, ty, value: default } => StepDescription::Parameter {
            parameter: parameters.get(id).copied().unwrap_or_default(),
            ty: ty.to_string(),
            value: value(default),
        },
        HostStep::Context(context, light) => {
            StepDescription::Context { context: context.word(), light: light.clone() }
        }
        HostStep::Call { function, arguments } => {
            StepDescription::Call { function: function.clone(), arguments: arguments.clone() }
        }
        HostStep::Member { value, index } => StepDescription::Member { of: *value, member: *index },
    }
}

impl MemberDescription {
    /// Collects the parameters, lights and surroundings that the member's step depends on.
    fn depend(&mut self, steps: &[HostStep], parameters: &HashMap<ParamId, usize>) {
        let mut seen = BTreeSet::new();
        let mut open = vec![self.step];
        while let Some(index) = open.pop() {
            if !seen.insert(index) {
                continue;
            }
            match steps.get(index) {
                Some(HostStep::Param { id, .. }) => self.parameters.extend(parameters.get(id)),
                Some(HostStep::Context(_, Some(light))) => {
                    self.lights.insert(light.clone());
                }
                Some(HostStep::Context(context, None)) => {
                    self.contexts.insert(context.word());
                }
                Some(HostStep::Call { arguments, .. }) => open.extend(arguments),
                Some(HostStep::Member { value, .. }) => open.push(*value),
                Some(HostStep::Constant(_)) | None => {}
            }
        }
    }
}

/// The members' values with every parameter at its default.
fn defaults(host: &Host) -> Vec<interp::Value> {
    let lights: IndexMap<LightId, LightValues> =
        [(LightId::new(""), LightValues::default())].into();
    let inputs = HostInputs {
        params: &HashMap::new(),
        lights: &lights,
        camera_from_world: DMat3::IDENTITY,
        viewport: [1.0; 2],
        time: 0.0,
        frame: 0.0,
        object_id: 0.0,
    };
    // A program that cannot be run has no defaults; compiling has reported the error.
    host.shader.host.run(&inputs).unwrap_or_default()
}

/// A value in JSON.
pub(super) fn value(value: &interp::Value) -> Value {
    match value {
        interp::Value::Bool(b) => json!(b),
        interp::Value::I32(i) => json!(i),
        interp::Value::U32(u) => json!(u),
        interp::Value::Float(x) => json!(x),
        interp::Value::Vector(scalars) => {
            scalars.iter().map(|scalar| self::value(&(*scalar).into())).collect()
        }
        interp::Value::Matrix { components, .. } => components.iter().map(|x| json!(x)).collect(),
        interp::Value::Array(parts) | interp::Value::Struct(parts) => {
            parts.iter().map(self::value).collect()
        }
    }
}

/// A value as the uniform holds it: with floats of 32 bits.
fn stored(value: &interp::Value) -> Value {
    rounded(self::value(value))
}

/// Rounds numbers to the shortest that read back as the same f32. Values nest a few levels deep.
fn rounded(value: Value) -> Value {
    match value {
        Value::Array(parts) => parts.into_iter().map(rounded).collect(),
        Value::Number(x) if x.is_f64() => {
            let text = x.as_f64().map_or_else(String::new, |x| format!("{:?}", x as f32));
            text.parse().map_or(Value::Null, |x: f64| json!(x))
        }
        other => other,
    }
}

/// The meaning of a surrounding.
fn meaning(context: Context) -> &'static str {
    match context.row().source {
        ContextSource::Host { meaning, .. } => meaning,
        ContextSource::Light(input) => input.help(),
        // Contexts of fragment rate, which steps never ask for.
        ContextSource::Fragment { .. }
        | ContextSource::Pass { .. }
        | ContextSource::Scene { .. } => "",
    }
}
