//! Parameters and lights that may be set from outside.

use std::collections::{BTreeSet, HashMap};

use serde::Serialize;
use serde_json::{Value, json};

use super::modules::Modules;
use crate::compile::{HostStep, ParamId, TypedGraph, TypedNode, TypedSource, node_title};
use crate::document::{Definition, InterfacePort, Light, LightField, Look, Target};
use crate::ids::{LightId, NodePath, PortName};
use crate::library::{Input, Library, Type};

/// A value that may be set from outside, or that keys move.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ExposedParameter {
    /// Name under which the artist exposed the value; none for a value that only keys move.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<PortName>,
    /// Label for people.
    pub label: String,
    /// Help text.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub help: String,
    /// Name of the node or group that the parameter belongs to, with those of groups around it;
    /// parameters of one group belong together.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub group: String,
    /// Target that the parameter sets: `path/to/node.port`, or `lights.key.direction`.
    pub target: String,
    /// Type in Chiaro; none for an input of a node that the look does not use.
    #[serde(rename = "type", skip_serializing_if = "String::is_empty")]
    pub ty: String,
    /// Value in the look.
    pub default: Value,
    /// Least value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// Greatest value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
    /// Unit of the value's numbers.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub unit: String,
    /// Words of a choice.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub options: Vec<String>,
    /// True if setting the parameter changes the picture. A parameter that is not live was decided
    /// when the shader was made (choices), or reaches nothing.
    pub live: bool,
    /// True if keys move the parameter.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub keyed: bool,
}

/// A light of the look.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LightDescription {
    /// Id of the light, as steps name it.
    pub id: LightId,
    /// Label for people.
    pub label: String,
    /// Values of the light in the look: `type`, `space`, `direction` and the rest.
    pub values: Light,
    /// Fields that steps ask for.
    pub fields: BTreeSet<&'static str>,
    /// Uniform members that depend on the light, `module.member`; filled in by the description.
    pub members: Vec<String>,
}

/// The parameters, and the index among them of each live value.
pub(super) struct Parameters {
    pub(super) list: Vec<ExposedParameter>,
    pub(super) index: HashMap<ParamId, usize>,
}

/// The parameters: those that are exposed in the artist's order, then those that only keys move.
pub(super) fn parameters(
    look: &Look,
    library: &Library,
    typed: &TypedGraph,
    modules: &Modules,
) -> Parameters {
    let steps = || {
        modules
            .modules
            .iter()
            .filter_map(|module| module.host())
            .flat_map(|host| &host.source.steps)
    };
    let live: BTreeSet<ParamId> = steps()
        .filter_map(|step| if let HostStep::Param { id, .. } = step { Some(*id) } else { None })
        .collect();
    let live_lights: BTreeSet<&LightId> = steps()
        .filter_map(
            |step| if let HostStep::Context(_, light) = step { light.as_ref() } else { None },
        )
        .collect();
    let mut found = Parameters { list: Vec::new(), index: HashMap::new() };
    let keyed = |target: &Target| typed.keyed.contains(target);
    for exposed in &look.exposed {
        let mut parameter = match &exposed.target {
            Target::Input { node, port } => {
                let id = typed
                    .params
                    .iter()
                    .position(|param| param.path == *node && param.port == *port);
                let Some(id) = id else { continue };
                found.index.entry(id).or_insert(found.list.len());
                ExposedParameter { live: live.contains(&id), ..input(look, library, typed, id) }
            }
            Target::Light { light, field } => ExposedParameter {
                live: live_lights.contains(light),
                ..light_field(look, light, field)
            },
        };
        parameter.name = Some(exposed.name.clone());
        parameter.keyed = keyed(&exposed.target);
        if !exposed.label.is_empty() {
            parameter.label.clone_from(&exposed.label);
        }
        found.list.push(parameter);
    }
    for id in live {
        if let std::collections::hash_map::Entry::Vacant(entry) = found.index.entry(id) {
            entry.insert(found.list.len());
            let target = Target::Input {
                node: typed.params[id].path.clone(),
                port: typed.params[id].port.clone(),
            };
            found.list.push(ExposedParameter {
                live: true,
                keyed: keyed(&target),
                ..input(look, library, typed, id)
            });
        }
    }
    found
}

/// The parameter of an input, with labels and bounds from the library, or from the group around the
/// input where that says more.
fn input<'a>(
    look: &Look,
    library: &Library,
    typed: &'a TypedGraph,
    id: ParamId,
) -> ExposedParameter {
    let param = &typed.params[id];
    let mut parameter = ExposedParameter {
        group: node_title(look, library, &param.path),
        target: format!("{}.{}", param.path, param.port),
        ..ExposedParameter::default()
    };
    let reads = |node: &'a TypedNode| {
        let found = node.inputs.iter().position(|input| {
            matches!(
                input.as_ref().map(|input| &input.source),
                Some(TypedSource::Param(found, _)) if *found == id
            )
        });
        // Choices and other settings are not inputs of the typed node any more.
        found
            .or_else(|| node.def.input(param.port.as_str()).filter(|_| node.path == param.path))
            .map(|at| (node, at))
    };
    if let Some((node, at)) = typed.nodes.iter().find_map(reads) {
        let Input { label, help, ty, min, max, unit, options, .. } = &node.def.inputs[at];
        parameter.label.clone_from(label);
        parameter.help.clone_from(help);
        parameter.ty = ty.to_string();
        parameter.default = match node.inputs[at].as_ref().map(|input| &input.source) {
            Some(TypedSource::Param(_, value)) => json!(value),
            _ => node.choices.get(&at).map_or_else(|| json!(param.value), |word| json!(word)),
        };
        (parameter.min, parameter.max) = (*min, *max);
        parameter.unit.clone_from(unit);
        parameter.options = options.iter().map(|(word, _)| word.clone()).collect();
    }
    if let Some(port) = interface_port(look, library, &param.path, &param.port) {
        let InterfacePort { label, help, min, max, .. } = port;
        if let Some(label) = label {
            parameter.label.clone_from(label);
        }
        if let Some(help) = help {
            parameter.help.clone_from(help);
        }
        parameter.min = min.or(parameter.min);
        parameter.max = max.or(parameter.max);
    }
    parameter
}

/// The port of a group that a path names; `None` if the path names no group.
fn interface_port<'a>(
    look: &'a Look,
    library: &'a Library,
    path: &NodePath,
    port: &PortName,
) -> Option<&'a InterfacePort> {
    let mut graph = &look.graph;
    let mut definition: Option<&Definition> = None;
    for id in path.ids() {
        let kind = &graph.nodes.get(id)?.kind;
        let found = library.group_of(look, kind)?;
        graph = &found.graph;
        definition = Some(found);
    }
    definition?.inputs.iter().find(|interface| interface.name == *port)
}

fn light_field(look: &Look, light: &LightId, field: &str) -> ExposedParameter {
    let of_look = look.lights.get(light);
    let document = of_look.map_or(Value::Null, |light| json!(light));
    let known = LightField::named(field);
    let ty = known.map_or(Type::Float, Type::of_light_field);
    let range = known.and_then(LightField::range);
    let unit = known.map(LightField::unit).unwrap_or_default();
    ExposedParameter {
        label: field.replace('_', " "),
        group: of_look.map_or(light.as_str(), |of_look| of_look.display_name(light)).to_owned(),
        target: format!("lights.{light}.{field}"),
        ty: ty.to_string(),
        default: document.get(field).cloned().unwrap_or_default(),
        min: range.map(|[min, _]| min),
        // Bounds of lengths and factors in files are not meant as ends of a slider.
        max: range.filter(|_| !unit.is_empty()).map(|[_, max]| max),
        unit: unit.to_owned(),
        ..ExposedParameter::default()
    }
}

/// The lights that any step asks for, in the look's order.
pub(super) fn lights(look: &Look, modules: &Modules) -> Vec<LightDescription> {
    let hosts = modules.modules.iter().filter_map(|module| module.host());
    let mut fields: HashMap<&LightId, BTreeSet<&'static str>> = HashMap::new();
    for step in hosts.flat_map(|host| &host.source.steps) {
        if let HostStep::Context(context, Some(light)) = step
            && context.light_input().is_some()
        {
            fields.entry(light).or_default().insert(context.word());
        }
    }
    let describe = |(id, light): (&LightId, &Light)| {
        let fields = fields.get(id)?.clone();
        let label = if light.name.is_empty() { id.to_string() } else { light.name.clone() };
        Some(LightDescription {
            id: id.clone(),
            label,
            values: light.clone(),
            fields,
            members: Vec::new(),
        })
    };
    look.lights.iter().filter_map(describe).collect()
}
