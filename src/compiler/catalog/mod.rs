//! The catalog of kinds of nodes: nodes of the library, groups and custom WGSL nodes, all
//! alike.

pub mod values;
pub mod wires;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::{Text, text};

use crate::document::{Definition, Graph, InterfacePort, Look, Node, Tier, Value};
use crate::ids::{GROUP_INPUTS, GROUP_OUTPUTS, NodeId, PortName};
use crate::library::{Fallback, Library, NodeDef, Preset, Treatment, Type, load_node};

/// The kind of a node whose WGSL is a value of its own.
pub const CUSTOM_KIND: &str = "wgsl";

/// Label of a node with its own WGSL.
const CUSTOM_LABEL: Text = text!("node" => "WGSL node");
/// Name of the value that holds the WGSL of a custom node.
pub const CODE_VALUE: &str = "code";
/// The code of a new custom node.
pub const CUSTOM_CODE: &str = "\
/// My node
///
/// @param value \"Value\" default=0.5 min=0 max=1 : What comes in.
/// @return value \"Value\" : What goes out.
fn my_node(value: f32) -> f32 {
    return value * value;
}
";
/// Greatest depth of groups within groups that is looked into.
const MAX_DEPTH: usize = 16;

/// Port of a node as people see it.
#[derive(Clone, Debug)]
pub struct Port {
    /// Name of the port in wires and files.
    pub name: PortName,
    /// Label that people read.
    pub label: Arc<str>,
    /// Help text: the purpose.
    pub help: String,
    /// Type of the socket or of the setting.
    pub ty: Type,
    /// Inputs: every type that a function of the node takes here.
    pub accepts: Vec<Type>,
    /// Inputs: the value of the port while no wire leads to the port.
    pub fallback: Fallback,
    /// Least value of a number.
    pub min: Option<f64>,
    /// Greatest value of a number.
    pub max: Option<f64>,
    /// Unit of the value, such as `rad`; empty where there is none.
    pub unit: String,
    /// Words of a choice, each with its label.
    pub options: Vec<(String, String)>,
}

impl Port {
    /// True for a port with a socket, false for a setting.
    pub fn is_wirable(&self) -> bool {
        !self.ty.is_setting()
    }

    /// True if an output of type `from` may be wired to this input.
    pub fn takes(&self, from: &Type) -> bool {
        self.is_wirable() && self.accepts.iter().any(|to| from.convert_to(to).is_some())
    }

    /// Port of which only the name is known.
    pub fn named(name: &str) -> Self {
        Self {
            name: name.into(),
            label: name.into(),
            help: String::new(),
            ty: Type::Prepared(String::new()),
            accepts: Vec::new(),
            fallback: Fallback::Wire,
            min: None,
            max: None,
            unit: String::new(),
            options: Vec::new(),
        }
    }
}

/// Kind of node as people see it.
#[derive(Clone, Debug)]
pub struct NodeKind {
    /// Name of the kind in the library, id of a group, or [`CUSTOM_KIND`].
    pub id: String,
    /// Label that people read.
    pub label: Arc<str>,
    /// Category in the palette; the color of the node's title follows from it.
    pub category: String,
    /// Help text: the purpose.
    pub help: String,
    /// Papers that the node is taken from.
    pub sources: Vec<String>,
    /// Inputs in the order of their rows.
    pub inputs: Vec<Port>,
    /// Outputs in the order of their rows, above the inputs.
    pub outputs: Vec<Port>,
    /// Named sets of values.
    pub presets: Vec<Preset>,
    /// Implementations, the exact one first.
    pub tiers: Vec<Tier>,
    /// True for a node that passes on whatever value it is given.
    pub is_reroute: bool,
    /// True for a kind that could not be found or has errors.
    pub is_missing: bool,
}

impl NodeKind {
    /// Index of an input by name.
    pub fn input(&self, name: &str) -> Option<usize> {
        self.inputs.iter().position(|port| port.name.as_str() == name)
    }

    /// Index of an output by name; an empty name is the first.
    pub fn output(&self, name: &str) -> Option<usize> {
        if name.is_empty() {
            return (!self.outputs.is_empty()).then_some(0);
        }
        self.outputs.iter().position(|port| port.name.as_str() == name)
    }

    fn of_node(def: &NodeDef) -> Self {
        let is_reroute = def.special == Treatment::Reroute;
        Self {
            id: def.kind.clone(),
            label: def.label.as_str().into(),
            category: def.category.clone(),
            help: def.help.clone(),
            sources: def.sources.clone(),
            inputs: (0..def.inputs.len())
                .filter(|&index| !def.inputs[index].hidden)
                .map(|i| input_port(def, i))
                .collect(),
            outputs: def
                .outputs
                .iter()
                .map(|output| Port {
                    label: output.label.as_str().into(),
                    help: output.help.clone(),
                    ty: output.ty.clone(),
                    ..Port::named(output.name.as_str())
                })
                .collect(),
            presets: def.presets.clone(),
            tiers: def.tiers(),
            is_reroute,
            is_missing: false,
        }
    }
}

fn input_port(def: &NodeDef, index: usize) -> Port {
    use crate::library::ArgumentSource;
    let input = &def.inputs[index];
    let mut accepts = vec![input.ty.clone()];
    for parameter in def.variants.iter().flat_map(|variant| &variant.parameters) {
        if let ArgumentSource::Input(of, ty) = parameter
            && *of == index
            && !accepts.contains(ty)
        {
            accepts.push(ty.clone());
        }
    }
    if def.special == Treatment::Reroute {
        accepts.extend([Type::Angle, Type::Light, Type::Mat3, Type::Curve, Type::Ramp]);
    }
    Port {
        name: input.name.clone(),
        label: input.label.as_str().into(),
        help: input.help.clone(),
        ty: input.ty.clone(),
        accepts,
        fallback: input.fallback.clone(),
        min: input.min,
        max: input.max,
        unit: input.unit.clone(),
        options: input.options.clone(),
    }
}

/// All kinds that the nodes of a look may have.
#[derive(Debug, Default)]
pub struct Catalog {
    library: HashMap<String, Arc<NodeKind>>,
    /// Kinds of the library in its order, for the palette.
    order: Vec<Arc<NodeKind>>,
    definitions: HashMap<String, Arc<NodeKind>>,
    /// Custom nodes by their code.
    custom: HashMap<String, Arc<NodeKind>>,
}

impl Catalog {
    /// The kinds of a library.
    pub fn new(library: &Library) -> Self {
        let mut catalog = Self::default();
        for def in library.nodes.values() {
            let mut kind = NodeKind::of_node(def);
            kind.category = category(&def.category);
            catalog.add(kind);
        }
        for group in library.groups.values() {
            let find = |kind: &str| library.groups.get(kind).map(|group| &group.definition);
            let mut kind = group_kind(&group.id, &group.definition, library, &find, 0);
            kind.category = category(&group.category);
            catalog.add(kind);
        }
        let mut custom = custom_kind(CUSTOM_CODE);
        custom.label = CUSTOM_LABEL.english().into();
        let help = text!("node" => "A node whose WGSL function you write yourself.");
        custom.help = help.english().to_owned();
        catalog.order.push(Arc::new(custom));
        catalog
    }

    fn add(&mut self, kind: NodeKind) {
        let kind = Arc::new(kind);
        self.library.insert(kind.id.clone(), kind.clone());
        self.order.push(kind);
    }

    /// Replaces the groups and custom nodes in the catalog by those of a look.
    pub fn sync(&mut self, look: &Look, library: &Library) {
        let find = |kind: &str| library.group_of(look, kind);
        let group = |(id, definition): (&crate::ids::DefinitionId, _)| {
            (id.to_string(), Arc::new(group_kind(id.as_str(), definition, library, &find, 0)))
        };
        self.definitions = look.definitions.iter().map(group).collect();
        let own = look.definitions.values().map(|definition| &definition.graph);
        let others = library.groups.values().map(|group| &group.definition.graph);
        let graphs = std::iter::once(&look.graph).chain(own).chain(others);
        let codes: HashSet<&str> =
            graphs.flat_map(|graph| graph.nodes.values()).filter_map(custom_code).collect();
        self.custom.retain(|code, _| codes.contains(code.as_str()));
        for code in codes {
            if !self.custom.contains_key(code) {
                self.custom.insert(code.to_owned(), Arc::new(custom_kind(code)));
            }
        }
    }

    /// Kind of a node; `None` where no kind has the node's name.
    pub fn of(&self, node: &Node) -> Option<&Arc<NodeKind>> {
        match custom_code(node) {
            Some(code) => self.custom.get(code),
            None => self.get(&node.kind),
        }
    }

    /// Kind with an id.
    pub fn get(&self, id: &str) -> Option<&Arc<NodeKind>> {
        self.definitions.get(id).or_else(|| self.library.get(id))
    }

    /// Kinds that can be added: the look's own groups first, then the library.
    pub fn all(&self) -> impl Iterator<Item = &Arc<NodeKind>> {
        self.definitions.values().chain(&self.order)
    }

    /// The two ends of a group, seen from inside: the node that gives the group's inputs and the
    /// node that takes its outputs.
    pub fn ends(&self, group: &str) -> Option<[NodeKind; 2]> {
        let kind = self.get(group)?;
        let end = |id: &str, label: Text, help: Text, inputs: Vec<Port>, outputs: Vec<Port>| {
            let known = Self::stand_in(id, &[], &[]);
            let (label, help) = (label.english().into(), help.english().to_owned());
            NodeKind {
                label,
                help,
                category: "input".to_owned(),
                inputs,
                outputs,
                is_missing: false,
                ..known
            }
        };
        let mut outputs = kind.outputs.clone();
        for port in &mut outputs {
            // The group's output takes the type of the node that is wired to it first, and so may
            // have any type.
            port.accepts = vec![port.ty.clone()];
        }
        Some([
            end(
                GROUP_INPUTS,
                text!("node" => "Group inputs"),
                text!("node" => "What comes into the group."),
                Vec::new(),
                kind.inputs.clone(),
            ),
            end(
                GROUP_OUTPUTS,
                text!("node" => "Group outputs"),
                text!("node" => "What the group gives."),
                outputs,
                Vec::new(),
            ),
        ])
    }

    /// Stand-ins for the kinds of a graph's nodes that do not exist, with the ports that wires and
    /// values name.
    pub fn missing_in(&self, graph: &Graph) -> HashMap<NodeId, Arc<NodeKind>> {
        let is_missing =
            |(_, node): &(&NodeId, &Node)| self.of(node).is_none_or(|kind| kind.is_missing);
        let mut ports: HashMap<&NodeId, (Vec<PortName>, Vec<PortName>)> = HashMap::new();
        for (id, node) in graph.nodes.iter().filter(is_missing) {
            ports.insert(id, (node.values.keys().cloned().collect(), Vec::new()));
        }
        if ports.is_empty() {
            return HashMap::new();
        }
        for wire in &graph.wires {
            if let Some((inputs, _)) = ports.get_mut(&wire.to.node)
                && !inputs.contains(&wire.to.port)
            {
                inputs.push(wire.to.port.clone());
            }
            if let Some((_, outputs)) = ports.get_mut(&wire.from.node)
                && !outputs.contains(&wire.from.port)
            {
                outputs.push(wire.from.port.clone());
            }
        }
        let kind = |id: &NodeId| graph.nodes.get(id).map_or("", |node| node.kind.as_str());
        let stand_in = |(id, (inputs, outputs)): (&NodeId, (Vec<PortName>, Vec<PortName>))| {
            let mut stand_in = Self::stand_in(kind(id), &inputs, &outputs);
            if let Some(known) = graph.nodes.get(id).and_then(|node| self.of(node)) {
                stand_in.label.clone_from(&known.label);
            }
            (id.clone(), Arc::new(stand_in))
        };
        ports.into_iter().map(stand_in).collect()
    }

    /// Stand-in for a kind that does not exist, with the ports that the look names.
    pub fn stand_in(id: &str, inputs: &[PortName], outputs: &[PortName]) -> NodeKind {
        let ports =
            |names: &[PortName]| names.iter().map(|name| Port::named(name.as_str())).collect();
        NodeKind {
            id: id.to_owned(),
            label: format!("{id}?").into(),
            category: String::new(),
            help: "There is no node of this kind.".to_owned(),
            sources: Vec::new(),
            inputs: ports(inputs),
            outputs: ports(outputs),
            presets: Vec::new(),
            tiers: Vec::new(),
            is_reroute: false,
            is_missing: true,
        }
    }
}

fn custom_code(node: &Node) -> Option<&str> {
    if node.kind != CUSTOM_KIND {
        return None;
    }
    match node.values.get(CODE_VALUE) {
        Some(Value::Text(code)) => Some(code),
        _ => Some(""),
    }
}

fn custom_kind(code: &str) -> NodeKind {
    let mut kind = match load_node("custom.wgsl", code, Some(CUSTOM_KIND)) {
        Ok(def) => NodeKind::of_node(&def),
        Err(_) => {
            let mut kind = Catalog::stand_in(CUSTOM_KIND, &[], &[]);
            kind.label = CUSTOM_LABEL.english().into();
            let help = text!("node" => "Its code has errors; they are listed under the canvas.");
            kind.help = help.english().to_owned();
            kind
        }
    };
    kind.category = "utility".to_owned();
    let text = Fallback::Value(Value::Text(CUSTOM_CODE.to_owned()));
    let code =
        Port { label: "Code".into(), ty: Type::Text, fallback: text, ..Port::named(CODE_VALUE) };
    kind.inputs.push(code);
    kind
}

/// Category as people read it. Nodes in a project's `nodes` folder itself would be of the category
/// "nodes", which tells nothing: they get the category "project".
fn category(folder: &str) -> String {
    let category = if folder == "nodes" { text!("node" => "project").english() } else { folder };
    category.to_owned()
}

fn group_kind<'a>(
    id: &str,
    definition: &Definition,
    library: &Library,
    find: &dyn Fn(&str) -> Option<&'a Definition>,
    depth: usize,
) -> NodeKind {
    let inner = |node: &Node| -> Option<NodeKind> {
        if node.kind == CUSTOM_KIND {
            return Some(custom_kind(custom_code(node)?));
        }
        if let Some(inner) = find(&node.kind) {
            return (depth < MAX_DEPTH)
                .then(|| group_kind(&node.kind, inner, library, find, depth + 1));
        }
        library.nodes.get(&node.kind).map(|def| NodeKind::of_node(def))
    };
    let graph = &definition.graph;
    let found: Vec<_> =
        definition.inputs.iter().map(|port| inner_input(graph, port, &inner)).collect();
    let same = |node: &NodeId, other: &PortName| {
        let is_it = |found: &Option<(NodeId, Port)>| {
            found.as_ref().is_some_and(|f| f.0 == *node && f.1.name == *other)
        };
        found.iter().position(is_it).map(|index| definition.inputs[index].name.clone())
    };
    let inputs = found.iter().zip(&definition.inputs).map(|(found, own)| {
        let mut port = found.as_ref().map(|(_, port)| port.clone());
        if let (Some((node, _)), Some(Port { fallback: Fallback::Same(other), .. })) =
            (found, &mut port)
            && let Some(own) = same(node, other)
        {
            other.clone_from(&own);
        }
        named_by(own, port)
    });
    NodeKind {
        id: id.to_owned(),
        label: if definition.label.is_empty() { id } else { &definition.label }.into(),
        category: "group".to_owned(),
        help: definition.help.clone(),
        sources: Vec::new(),
        inputs: inputs.collect(),
        outputs: definition
            .outputs
            .iter()
            .map(|port| named_by(port, inner_output(graph, port, &inner)))
            .collect(),
        presets: Vec::new(),
        tiers: Vec::new(),
        is_reroute: false,
        is_missing: false,
    }
}

/// Inner port that a group's input is wired to first, and its node.
fn inner_input(
    graph: &Graph,
    port: &InterfacePort,
    kind_of: &dyn Fn(&Node) -> Option<NodeKind>,
) -> Option<(NodeId, Port)> {
    let mut from = (GROUP_INPUTS.to_owned(), port.name.clone());
    for _ in 0..MAX_DEPTH {
        let is_it = |wire: &&crate::document::Wire| {
            wire.from.node.as_str() == from.0 && wire.from.port == from.1
        };
        let wire = graph.wires.iter().find(is_it)?;
        let kind = kind_of(graph.nodes.get(&wire.to.node)?)?;
        let index = kind.input(wire.to.port.as_str())?;
        if !kind.is_reroute {
            return Some((wire.to.node.clone(), kind.inputs[index].clone()));
        }
        from = (wire.to.node.to_string(), kind.outputs.first()?.name.clone());
    }
    None
}

/// Inner port that a group's output comes from.
fn inner_output(
    graph: &Graph,
    port: &InterfacePort,
    kind_of: &dyn Fn(&Node) -> Option<NodeKind>,
) -> Option<Port> {
    let mut to = (GROUP_OUTPUTS.to_owned(), port.name.clone());
    for _ in 0..MAX_DEPTH {
        let is_it =
            |wire: &&crate::document::Wire| wire.to.node.as_str() == to.0 && wire.to.port == to.1;
        let wire = graph.wires.iter().find(is_it)?;
        let kind = kind_of(graph.nodes.get(&wire.from.node)?)?;
        let index = kind.output(wire.from.port.as_str())?;
        if !kind.is_reroute {
            return Some(kind.outputs[index].clone());
        }
        to = (wire.from.node.to_string(), kind.inputs.first()?.name.clone());
    }
    None
}

fn named_by(own: &InterfacePort, inner: Option<Port>) -> Port {
    let mut port = inner.unwrap_or_else(|| Port::named(own.name.as_str()));
    port.name = own.name.clone();
    if let Some(label) = &own.label {
        port.label = label.as_str().into();
    }
    if let Some(help) = &own.help {
        port.help.clone_from(help);
    }
    if let Some(default) = &own.default {
        port.fallback = Fallback::Value(default.clone());
    }
    port.min = own.min.or(port.min);
    port.max = own.max.or(port.max);
    port
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_group_has_the_ports_of_what_is_in_it() {
        let catalog = Catalog::new(Library::built_in());
        let layer = catalog.get("light_layer").unwrap();
        let offset = &layer.inputs[layer.input("offset").unwrap()];
        assert_eq!((offset.unit.as_str(), &offset.ty), ("rad", &Type::Float));
        assert_eq!(layer.outputs[0].ty, Type::Composite);
        assert_eq!(layer.inputs[layer.input("light").unwrap()].ty, Type::LightName);
        assert_eq!(&*layer.inputs[layer.input("blend").unwrap()].label, "Blending");
        assert!(layer.inputs[0].takes(&Type::Color) && !layer.inputs[0].takes(&Type::Light));
    }

    #[test]
    fn the_first_custom_node_is_right() {
        let kind = custom_kind(CUSTOM_CODE);
        assert_eq!(kind.inputs.len(), 2, "its value and its code");
        assert_eq!(&*kind.label, "My node");
    }
}
