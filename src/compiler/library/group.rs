//! Ports of a group, as those of a node: properties that the group's interface leaves out come from
//! the inner port that the interface port is wired to first.
//!
//! Inspectors and docs show a group like any other node: with types, ranges, choices and help. A
//! document often gives an interface port no more than a name, so the other properties are looked
//! for along the port's first wire, through groups within groups and reroutes, up to a node of the
//! library that has them.

use indexmap::IndexMap;

use super::load::{GroupDef, Library};
use super::node::{Fallback, Input, NodeDef, Output, Treatment};
use super::read::{load_node, plain_input};
use super::types::Type;
use crate::document::{Definition, InterfacePort, Value, Wire};
use crate::ids::{DefinitionId, GROUP_INPUTS, GROUP_OUTPUTS, NodeId, PortName};

/// The kind of a node whose WGSL is a value of its own.
pub const CUSTOM_KIND: &str = "wgsl";
/// Name of the value that holds the WGSL of a custom node.
pub const CUSTOM_CODE: &str = "code";

/// Greatest number of groups and reroutes that a wire is followed through. Groups may contain one
/// another in a document that is wrong, and then a wire has no end.
const MAX_STEPS: usize = 256;

/// Ports of a group, in the form of a node's ports.
#[derive(Clone, Debug, Default)]
pub struct GroupPorts {
    /// Inputs in the order of the interface.
    pub inputs: Vec<Input>,
    /// Outputs in the order of the interface.
    pub outputs: Vec<Output>,
}

impl GroupDef {
    /// Ports of the group, as those of a node.
    pub fn ports(&self, library: &Library) -> GroupPorts {
        GroupPorts::of(&self.definition, &IndexMap::new(), library)
    }
}

impl GroupPorts {
    /// Ports of any definition. `own` are the definitions of its document, which go before those of
    /// the library.
    ///
    /// An input that reaches no node is a number without a value.
    pub fn of(
        definition: &Definition,
        own: &IndexMap<DefinitionId, Definition>,
        library: &Library,
    ) -> Self {
        let finder = Finder { own, library };
        Self {
            inputs: definition.inputs.iter().map(|port| finder.input(definition, port)).collect(),
            outputs: definition
                .outputs
                .iter()
                .map(|port| finder.output(definition, port))
                .collect(),
        }
    }
}

/// Node or group that a node's kind names.
#[expect(clippy::large_enum_variant, reason = "one at a time, on the stack")]
enum NodeOrGroup<'a> {
    Node(std::borrow::Cow<'a, NodeDef>),
    Group(&'a Definition),
}

struct Finder<'a> {
    own: &'a IndexMap<DefinitionId, Definition>,
    library: &'a Library,
}

impl<'a> Finder<'a> {
    fn kind(&self, definition: &'a Definition, id: &NodeId) -> Option<NodeOrGroup<'a>> {
        let node = definition.graph.nodes.get(id)?;
        if let Some(inner) = self.own.get(node.kind.as_str()) {
            return Some(NodeOrGroup::Group(inner));
        }
        if let Some(group) = self.library.groups.get(&node.kind) {
            return Some(NodeOrGroup::Group(&group.definition));
        }
        if node.kind == CUSTOM_KIND {
            let Some(Value::Text(code)) = node.values.get(CUSTOM_CODE) else { return None };
            return load_node("node.wgsl", code, Some(CUSTOM_KIND))
                .ok()
                .map(|def| NodeOrGroup::Node(std::borrow::Cow::Owned(def)));
        }
        self.library
            .nodes
            .get(&node.kind)
            .map(|def| NodeOrGroup::Node(std::borrow::Cow::Borrowed(&**def)))
    }

    /// Interface input, completed with the properties found along its first wire.
    fn input(&self, definition: &'a Definition, port: &'a InterfacePort) -> Input {
        // Order from the outside in: the properties of an outer interface go before those of an
        // inner one.
        let mut said = vec![port];
        let found = self.inner_input(definition, port, &mut said);
        let (place, found) = found.unzip();
        let mut input =
            found.unwrap_or_else(|| plain_input(port.name.as_str(), Type::Float, Fallback::Wire));
        input.name = port.name.clone();
        let first = |get: fn(&InterfacePort) -> Option<&String>| {
            said.iter().find_map(|port| get(port)).cloned()
        };
        if let Some(label) = first(|port| port.label.as_ref()) {
            input.label = label;
        }
        if let Some(help) = first(|port| port.help.as_ref()) {
            input.help = help;
        }
        if let Some(default) = said.iter().find_map(|port| port.default.clone()) {
            input.fallback = Fallback::Value(default);
        }
        if let Fallback::Same(other) = &input.fallback {
            // Input of the group that feeds the other inner input; most groups name both alike.
            let feeds = |own: &&InterfacePort| {
                let inner = self.inner_input(definition, own, &mut vec![*own]);
                inner.is_some_and(|(at, inner)| inner.name == *other && Some(at) == place)
            };
            if let Some(own) = definition.inputs.iter().find(feeds) {
                input.fallback = Fallback::Same(own.name.clone());
            }
        }
        input.min = said.iter().find_map(|port| port.min).or(input.min);
        input.max = said.iter().find_map(|port| port.max).or(input.max);
        input
    }

    /// Input of a library node that an interface input feeds first, and its place: the ids of the
    /// groups around that node and its own.
    fn inner_input(
        &self,
        definition: &'a Definition,
        port: &'a InterfacePort,
        said: &mut Vec<&'a InterfacePort>,
    ) -> Option<(Vec<&'a NodeId>, Input)> {
        let mut definition = definition;
        let mut place = Vec::new();
        let (mut from_node, mut from_port) = (GROUP_INPUTS, port.name.as_str());
        for _ in 0..MAX_STEPS {
            let wire = first_wire_from(definition, from_node, from_port)?;
            match self.kind(definition, &wire.to.node)? {
                NodeOrGroup::Node(def) if def.special == Treatment::Reroute => {
                    from_node = wire.to.node.as_str();
                    from_port = "";
                }
                NodeOrGroup::Node(def) => {
                    place.push(&wire.to.node);
                    return def
                        .input(wire.to.port.as_str())
                        .map(|index| (place, def.inputs[index].clone()));
                }
                NodeOrGroup::Group(inner) => {
                    place.push(&wire.to.node);
                    let next = inner.inputs.iter().find(|next| next.name == wire.to.port)?;
                    said.push(next);
                    definition = inner;
                    (from_node, from_port) = (GROUP_INPUTS, next.name.as_str());
                }
            }
        }
        None
    }

    fn output(&self, definition: &'a Definition, port: &InterfacePort) -> Output {
        let inner = self.inner_output(definition, &port.name);
        let plain = plain_input(port.name.as_str(), Type::Float, Fallback::Wire);
        let (label, help, ty) = match inner {
            Some(output) => (output.label, output.help, output.ty),
            None => (plain.label, plain.help, plain.ty),
        };
        Output {
            name: port.name.clone(),
            label: port.label.clone().unwrap_or(label),
            help: port.help.clone().unwrap_or(help),
            ty,
        }
    }

    /// Output of a library node that feeds an interface output.
    fn inner_output(&self, definition: &'a Definition, port: &PortName) -> Option<Output> {
        let mut definition = definition;
        let (mut to_node, mut to_port) = (NodeId::from(GROUP_OUTPUTS), port.clone());
        for _ in 0..MAX_STEPS {
            let from = &definition.graph.wire_into(&to_node, &to_port)?.from;
            if from.node.as_str() == GROUP_INPUTS {
                let passed = definition.inputs.iter().find(|input| input.name == from.port)?;
                let input = self.input(definition, passed);
                return Some(Output {
                    name: input.name,
                    label: input.label,
                    help: input.help,
                    ty: input.ty,
                });
            }
            match self.kind(definition, &from.node)? {
                NodeOrGroup::Node(def) if def.special == Treatment::Reroute => {
                    to_port = def.inputs.first()?.name.clone();
                    to_node = from.node.clone();
                }
                NodeOrGroup::Node(def) => {
                    return def.output(from.port.as_str()).map(|index| def.outputs[index].clone());
                }
                NodeOrGroup::Group(inner) => {
                    let named = inner.outputs.iter().find(|output| output.name == from.port);
                    let next = named.or_else(|| {
                        inner.outputs.first().filter(|_| from.port.as_str().is_empty())
                    })?;
                    to_port = next.name.clone();
                    to_node = NodeId::from(GROUP_OUTPUTS);
                    definition = inner;
                }
            }
        }
        None
    }
}

/// First wire from an output of a node; from any output where `port` is empty.
fn first_wire_from<'a>(definition: &'a Definition, node: &str, port: &str) -> Option<&'a Wire> {
    let is_from = |wire: &&Wire| {
        wire.from.node.as_str() == node && (port.is_empty() || wire.from.port.as_str() == port)
    };
    definition.graph.wires.iter().find(is_from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Look;

    fn ports_of(definitions: &str, id: &str) -> GroupPorts {
        let loaded =
            Look::read(&format!(r#"{{"definitions": {definitions}, "nodes": []}}"#), "test.json");
        let look = loaded.value.unwrap();
        GroupPorts::of(&look.definitions[id], &look.definitions, Library::built_in())
    }

    fn input<'a>(ports: &'a GroupPorts, name: &str) -> &'a Input {
        ports.inputs.iter().find(|input| input.name.as_str() == name).unwrap()
    }

    #[test]
    fn a_light_layer_has_what_its_nodes_say() {
        let library = Library::built_in();
        let ports = library.groups["light_layer"].ports(library);
        let profile = &library.nodes["profile"];
        let offset = input(&ports, "offset");
        let own = &profile.inputs[profile.input("offset").unwrap()];
        assert_eq!((&offset.ty, &offset.fallback, offset.max), (&own.ty, &own.fallback, own.max));
        assert_eq!((&offset.label, &offset.help, &offset.unit), (&own.label, &own.help, &own.unit));
        // The name differs outside and inside; the choices are the inner ones, the label is the
        // outer one.
        let blend = input(&ports, "blend");
        assert_eq!((blend.ty.clone(), blend.label.as_str()), (Type::Choice, "Blending"));
        assert!(blend.options.iter().any(|option| option.0 == "shade"));
        // The interface's own default goes before the inner node's.
        assert_eq!(input(&ports, "slope").fallback, Fallback::Value(Value::Number(0.0)));
        assert_eq!(input(&ports, "light").ty, Type::LightName);
        assert!(matches!(input(&ports, "normal").fallback, Fallback::Context(_)));
        assert_eq!(ports.outputs[0].ty, Type::Composite);
        assert_eq!(
            (ports.outputs[1].name.as_str(), ports.outputs[1].ty.clone()),
            ("tone", Type::Float)
        );
    }

    #[test]
    fn wires_are_followed_through_groups_and_reroutes() {
        let ports = ports_of(
            r#"{
              "outer": {
                "inputs": [{"name": "width", "help": "Ours."}], "outputs": [{"name": "tone"}],
                "nodes": [{"id": "bend", "kind": "reroute"}, {"id": "in", "kind": "inner"}],
                "wires": [{"from": "inputs.width", "to": "bend.value"},
                {"from": "bend", "to": "in.cut"},
                          {"from": "in", "to": "outputs.tone"}]
              },
              "inner": {
                "inputs": [{"name": "cut", "label": "Cut", "help": "Theirs.", "default": 0.5,
                "max": 2}],
                "outputs": [{"name": "tone"}],
                "nodes": [{"id": "p", "kind": "profile"}],
                "wires": [{"from": "inputs.cut", "to": "p.cutoff"},
                {"from": "p", "to": "outputs.tone"}]
              }
            }"#,
            "outer",
        );
        let width = input(&ports, "width");
        assert_eq!(
            (width.label.as_str(), width.help.as_str(), width.max),
            ("Cut", "Ours.", Some(2.0))
        );
        assert_eq!(
            (&width.fallback, width.unit.as_str()),
            (&Fallback::Value(Value::Number(0.5)), "rad")
        );
        assert_eq!((ports.outputs[0].label.as_str(), &ports.outputs[0].ty), ("Tone", &Type::Float));
    }

    #[test]
    fn what_leads_nowhere_or_in_a_ring_ends() {
        let ports = ports_of(
            r#"{"ring": {
              "inputs": [{"name": "a"}, {"name": "b"}], "outputs": [{"name": "x"},
              {"name": "passed"}],
              "nodes": [{"id": "self", "kind": "ring"}, {"id": "bend", "kind": "reroute"},
              {"id": "odd", "kind": "no"}],
              "wires": [{"from": "inputs.a", "to": "self.a"}, {"from": "self.x", "to": "outputs.x"},
                        {"from": "bend", "to": "bend.value"},
                        {"from": "inputs.b", "to": "outputs.passed"}]
            }}"#,
            "ring",
        );
        assert_eq!(
            (&input(&ports, "a").ty, &input(&ports, "a").fallback),
            (&Type::Float, &Fallback::Wire)
        );
        assert_eq!(ports.outputs.len(), 2);
    }
}
