//! A look in people's terms: names of its nodes, their inputs and its lights, their values, and the
//! exposed parameters.

use chiaro_locale::{tr, tr_in};

use crate::catalog::{Catalog, Port};
use crate::document::{
    ColorSpace, Definition, Graph, Light, LightField, Look, Node, Target, Tier, Value,
};
use crate::frame::light_field;
use crate::ids::{LightId, NodeId, NodePath, PortName};
use crate::library::{Fallback, Library, Type};
use crate::values;

/// Most nodes whose values are listed together.
const MOST_LISTED: usize = 500;

/// A look with the kinds of its nodes.
#[derive(Clone, Copy)]
pub(crate) struct LookWithLibrary<'a> {
    pub(crate) look: &'a Look,
    pub(crate) catalog: &'a Catalog,
    pub(crate) library: &'a Library,
}

/// An exposed parameter, with everything that an object which sets it needs.
#[derive(Clone, Debug)]
pub(crate) struct Parameter {
    pub(crate) name: PortName,
    pub(crate) label: String,
    pub(crate) help: String,
    pub(crate) port: Port,
    /// The look's own value of the parameter.
    pub(crate) value: Option<Value>,
    /// Color space of a color's numbers.
    pub(crate) space: ColorSpace,
}

impl<'a> LookWithLibrary<'a> {
    /// The group of a kind, the look's own before the library's.
    pub(crate) fn definition_of(self, kind: &str) -> Option<&'a Definition> {
        self.library.group_of(self.look, kind)
    }

    /// The node at a path, through the groups of the look and of the library.
    pub(crate) fn node_at(self, path: &NodePath) -> Option<&'a Node> {
        self.library.node_of(self.look, path.ids()).map(|(_, node)| node)
    }

    /// Port of a target: its label, type, unit, range.
    pub(crate) fn port_at(self, target: &Target) -> Option<Port> {
        match target {
            Target::Input { node, port } => {
                let kind = self.catalog.of(self.node_at(node)?)?;
                kind.inputs.get(kind.input(port.as_str())?).cloned()
            }
            Target::Light { .. } => target.light_field().map(field_port),
        }
    }

    /// Display names of a target: of the node or light, and of the input or field.
    pub(crate) fn names_of(self, target: &Target) -> [String; 2] {
        self.names_of_in(target, of_library)
    }

    /// Names of a target in English, for names that are kept.
    pub(crate) fn english_names_of(self, target: &Target) -> [String; 2] {
        self.names_of_in(target, |label| label)
    }

    fn names_of_in(self, target: &Target, told: fn(&str) -> &str) -> [String; 2] {
        let port = self.port_at(target);
        match target {
            Target::Input { node, port: name } => {
                let owner = self.node_at(node).map(|found| {
                    let kind = self.catalog.of(found).map(|kind| told(&kind.label).to_owned());
                    if found.name.is_empty() {
                        kind.unwrap_or_default()
                    } else {
                        found.name.clone()
                    }
                });
                let name =
                    port.map_or_else(|| name.to_string(), |port| told(&port.label).to_owned());
                [owner.unwrap_or_else(|| node.to_string()), name]
            }
            Target::Light { light, field } => [
                self.light_name(light),
                port.map_or_else(|| field.clone(), |port| told(&port.label).to_owned()),
            ],
        }
    }

    /// Display names along a path, *Back-light / Blend*; ids where there are no such nodes.
    pub(crate) fn title_of_path(self, path: &NodePath) -> String {
        self.title_of_path_in(path, of_library)
    }

    /// Names along a path; `told` gives a label of the library in the language that is wanted.
    pub(crate) fn title_of_path_in(self, path: &NodePath, told: fn(&str) -> &str) -> String {
        let mut graph = Some(&self.look.graph);
        let mut titles: Vec<String> = Vec::with_capacity(path.ids().len());
        for id in path.ids() {
            let node = graph.and_then(|graph| graph.nodes.get(id));
            titles.push(
                node.map_or_else(|| id.to_string(), |node| self.title_of_node_in(id, node, told)),
            );
            let group = node.and_then(|node| self.definition_of(&node.kind));
            graph = group.map(|definition| &definition.graph);
        }
        titles.join(" / ")
    }

    /// Display name of a target with the groups around its node: *Back-light / Blend: Opacity*.
    pub(crate) fn title_of_target(self, target: &Target) -> String {
        let [owner, what] = self.names_of(target);
        match target {
            Target::Input { node, .. } => format!("{}: {what}", self.title_of_path(node)),
            Target::Light { .. } => format!("{owner}: {what}"),
        }
    }

    /// Display name of an output with the groups around its node: *Back-light / Profile: Tone*.
    pub(crate) fn title_of_output(self, node: &NodePath, port: &PortName) -> String {
        let kind = self.node_at(node).and_then(|found| self.catalog.of(found));
        let found = kind.and_then(|kind| kind.outputs.get(kind.output(port.as_str())?));
        let label = found.map_or(port.as_str(), |port| of_library(&port.label));
        format!("{}: {label}", self.title_of_path(node))
    }

    /// Uses of the look's own group that the node of a target lies in; none outside of groups, and
    /// in those of the library.
    pub(crate) fn uses_around(self, target: &Target) -> Vec<NodePath> {
        let Target::Input { node, .. } = target else { return Vec::new() };
        let group = node.parent().and_then(|group| self.look.find(&group));
        group.map_or_else(Vec::new, |group| self.look.uses_of(&group.node.kind.as_str().into()))
    }

    /// Inputs that no wire feeds, of nodes of a graph and of those within the look's own groups
    /// among them, as far as they can be listed.
    pub(crate) fn values_within(self, graph: &Graph, nodes: Vec<NodePath>) -> Vec<Target> {
        let mut open: Vec<(NodePath, &Graph)> =
            nodes.into_iter().rev().map(|path| (path, graph)).collect();
        let (mut found, mut seen) = (Vec::new(), 0);
        while let Some((path, graph)) = open.pop().filter(|_| seen < MOST_LISTED) {
            seen += 1;
            let Some(id) = path.last() else { continue };
            let Some(node) = graph.nodes.get(id) else { continue };
            let ports = self.catalog.of(node).into_iter().flat_map(|kind| &kind.inputs);
            let free = ports.filter(|port| graph.wire_into(id, &port.name).is_none());
            let target =
                |port: &Port| Target::Input { node: path.clone(), port: port.name.clone() };
            found.extend(free.map(target));
            if let Some(group) = self.look.definitions.get(node.kind.as_str()) {
                let inner = group.graph.nodes.keys().rev();
                open.extend(inner.map(|id| (path.join(id.clone()), &group.graph)));
            }
        }
        found
    }

    /// Display name of a node: its own, or that of its kind.
    pub(crate) fn title_of_node(self, id: &NodeId, node: &Node) -> String {
        self.title_of_node_in(id, node, of_library)
    }

    fn title_of_node_in(self, id: &NodeId, node: &Node, told: fn(&str) -> &str) -> String {
        let kind = || self.catalog.of(node).map(|kind| told(&kind.label).to_owned());
        match node.name.is_empty() {
            false => node.name.clone(),
            true => kind().filter(|label| !label.is_empty()).unwrap_or_else(|| id.to_string()),
        }
    }

    /// Display name of a node of the look's own graph.
    pub(crate) fn title(self, id: &NodeId) -> String {
        let node = self.look.graph.nodes.get(id);
        node.map_or_else(|| id.to_string(), |node| self.title_of_node(id, node))
    }

    /// Display name of a light.
    pub(crate) fn light_name(self, id: &LightId) -> String {
        self.look.lights.get(id).map_or(id.as_str(), |light| light_name(id, light)).to_owned()
    }

    /// Value of a target without keys.
    pub(crate) fn own_value(self, target: &Target) -> Option<Value> {
        match target {
            Target::Input { node, port: name } => {
                let node = self.node_at(node)?;
                if let Some(value) = node.values.get(name) {
                    return Some(value.clone());
                }
                let kind = self.catalog.of(node)?;
                let port = &kind.inputs[kind.input(name.as_str())?];
                let same = match &port.fallback {
                    Fallback::Same(other) => &kind.inputs[kind.input(other.as_str())?],
                    _ => port,
                };
                values::current(same, node.values.get(&same.name)).cloned()
            }
            Target::Light { light, field } => light_field(self.look.lights.get(light)?, field),
        }
    }

    /// Parameters that objects may set by name, in the look's order.
    pub(crate) fn parameters(self) -> Vec<Parameter> {
        let parameter = |exposed: &crate::document::ExposedValue| {
            let mut port = self.port_at(&exposed.target)?;
            if port.ty == Type::LightName {
                // A choice like any other, among this look's lights.
                port.ty = Type::Choice;
                port.options = self
                    .look
                    .lights
                    .keys()
                    .map(|id| (id.to_string(), self.light_name(id)))
                    .collect();
            }
            let [owner, what] = self.names_of(&exposed.target);
            let mut help = tr!("{owner}: {what}, exposed as \"{name}\"", name = exposed.name);
            if !port.help.is_empty() {
                help = format!("{}\n{help}", of_library(&port.help));
            }
            if self.look.time_keys.iter().any(|track| track.target == exposed.target) {
                help += tr!("\nThe look keys it in time, which goes over what is set here");
            }
            let label = if exposed.label.is_empty() {
                spoken(exposed.name.as_str())
            } else {
                exposed.label.clone()
            };
            let (name, value, space) =
                (exposed.name.clone(), self.own_value(&exposed.target), self.look.color_space);
            Some(Parameter { name, label, help, port, value, space })
        };
        self.look.exposed.iter().filter_map(parameter).collect()
    }
}

/// Display name of a light.
pub(crate) fn light_name<'a>(id: &'a LightId, light: &'a Light) -> &'a str {
    light.display_name(id)
}

/// A label or a help of the library, in the language that is spoken.
pub(crate) fn of_library(text: &str) -> &str {
    tr_in("node", text)
}

/// A label of a choice, in the language that is spoken.
pub(crate) fn of_choice(label: &str) -> &str {
    tr_in("choice", label)
}

/// Label of a tier.
pub(crate) fn tier_label(tier: Tier) -> &'static str {
    match tier {
        Tier::Exact => tr!("Exact"),
        Tier::Balanced => tr!("Balanced"),
        Tier::Fast => tr!("Fast"),
    }
}

/// Name of a tier within a sentence.
pub(crate) fn tier_word(tier: Tier) -> &'static str {
    match tier {
        Tier::Exact => tr!("exact"),
        Tier::Balanced => tr!("balanced"),
        Tier::Fast => tr!("fast"),
    }
}

/// Label made from an identifier or a phrase: `rim_width` is "Rim width".
pub(crate) fn spoken(name: &str) -> String {
    let words = values::words(name);
    let mut letters = words.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

/// A light's field as a port.
pub(crate) fn field_port(field: LightField) -> Port {
    let range = field.range();
    // Bounds of lengths and factors in files are no end of a slider.
    let max = range.filter(|_| !field.unit().is_empty()).map(|[_, max]| max);
    Port {
        label: field.label().into(),
        ty: Type::of_light_field(field),
        unit: field.unit().to_owned(),
        min: range.map(|[min, _]| min),
        max,
        ..Port::named(field.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOOK: &str = r#"{"lights": {"key": {"name": "Sun"}, "back": {}},
      "nodes": [{"id": "base", "kind": "base", "values": {"color": [1, 0, 0]}},
        {"id": "rim", "kind": "light_layer", "name": "Rim", "values": {"light": "key"}},
        {"id": "output", "kind": "output"}],
      "wires": [{"from": "base", "to": "rim.below"}, {"from": "rim", "to": "output.color"}],
      "exposed": [{"name": "rim_cutoff", "target": "rim.cutoff"},
      {"name": "by", "target": "rim.light"},
        {"name": "sun", "target": "lights.key.intensity", "label": "The sun"}],
      "time_keys": [{"target": "lights.key.intensity", "keys": [{"time": 0, "value": 1}]}]}"#;

    #[test]
    fn what_a_look_exposes_is_called_typed_and_valued() {
        let loaded = Look::read(LOOK, "test");
        assert!(!loaded.has_errors(), "{:?}", loaded.diagnostics);
        let look = loaded.value.unwrap();
        let library = Library::built_in();
        let mut catalog = Catalog::new(library);
        catalog.sync(&look, library);
        let found = LookWithLibrary { look: &look, catalog: &catalog, library }.parameters();
        let labels: Vec<&str> = found.iter().map(|parameter| parameter.label.as_str()).collect();
        assert_eq!(labels, ["Rim cutoff", "By", "The sun"]);
        assert!(
            found[0].port.unit == "rad" && matches!(found[0].value, Some(Value::Number(_))),
            "its default"
        );
        assert_eq!(
            found[1].port.options,
            [("key".into(), "Sun".into()), ("back".into(), "back".into())]
        );
        assert!(
            found[2].help.contains("goes over") && found[2].help.starts_with("Sun: Intensity"),
            "{}",
            found[2].help
        );
    }
}
