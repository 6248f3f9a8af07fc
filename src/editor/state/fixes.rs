//! Remedies of problems: what one click can do where one edit is enough, offered on the node and in
//! the list of problems.

use chiaro_locale::tr;

use crate::catalog::{CODE_VALUE, CUSTOM_CODE, NodeKind, Port};
use crate::diag::{Diagnostic, Severity, nearest};
use crate::document::{Edit, Endpoint, Graph, GraphId, Light, Node, Value, Wire};
use crate::ids::{LightId, NodeId, PortName, is_slug, make_slug};
use crate::library::{Fallback, Type};
use crate::state::reading::{of_choice, of_library};
use crate::state::session::Session;
use crate::values;

/// Largest number of lights offered in place of an unknown one.
const MOST_LIGHTS: usize = 4;

/// Inputs along which a direction is bent, and outputs of *Axes around a direction*.
const AXES: [&str; 2] = ["x_axis", "y_axis"];

/// A remedy of a problem.
#[derive(Clone)]
pub(crate) struct Fix {
    /// Label of the remedy's button.
    pub(crate) label: String,
    /// Explanation of the remedy, a sentence without a full stop.
    pub(crate) help: String,
    pub(crate) edit: Edit,
}

impl Fix {
    fn new(label: impl Into<String>, help: impl Into<String>, edit: Edit) -> Self {
        Self { label: label.into(), help: help.into(), edit }
    }
}

/// The node, and the port, that a problem is about.
struct ProblemSpot<'a> {
    session: &'a Session,
    id: GraphId,
    graph: &'a Graph,
    node_id: NodeId,
    node: &'a Node,
    port: Option<PortName>,
}

/// The remedies of a problem, the likeliest first.
pub(crate) fn of(session: &Session, problem: &Diagnostic) -> Vec<Fix> {
    if problem.code == "no-output" {
        return vec![add_output(session)];
    }
    let Some(spot) = ProblemSpot::of(session, problem) else { return Vec::new() };
    let one = match problem.code {
        "unknown-kind" => return spot.known_kinds(),
        "unknown-light" => return spot.known_lights(),
        "unknown-port" => spot.known_port(),
        "unwired" => spot.feed(),
        "out-of-range" => spot.clamp(),
        "unknown-choice" => spot.known_choice(),
        "missing-code" => Some(spot.set(
            CODE_VALUE,
            Value::Text(CUSTOM_CODE.to_owned()),
            tr!("Give it code"),
            tr!("Writes a small function to begin with"),
        )),
        "many-outputs" => Some(spot.remove(tr!("Removes this Output and keeps the first"))),
        "recursive-group" => Some(spot.remove(tr!("Removes the group from within itself"))),
        "level-tangents" | "no-uvs" => spot.axes_around().or_else(|| spot.use_default()),
        _ if problem.severity == Severity::Error => spot.unwire().or_else(|| spot.use_default()),
        _ => spot.use_default(),
    };
    one.into_iter().collect()
}

impl<'a> ProblemSpot<'a> {
    fn of(session: &'a Session, problem: &Diagnostic) -> Option<Self> {
        let path = problem.place.node.as_ref()?;
        let found = session.look().find(path)?;
        Some(Self {
            session,
            graph: session.look().graph_of(&found.graph)?,
            id: found.graph,
            node_id: path.last()?.clone(),
            node: found.node,
            port: problem.place.port.clone(),
        })
    }

    fn kind(&self) -> Option<&NodeKind> {
        self.session.project.catalog.of(self.node).map(|kind| &**kind)
    }

    fn input(&self) -> Option<&Port> {
        let (kind, port) = (self.kind()?, self.port.as_ref()?);
        Some(&kind.inputs[kind.input(port.as_str())?])
    }

    fn wire_into(&self) -> Option<&Wire> {
        self.graph.wire_into(&self.node_id, self.port.as_ref()?)
    }

    fn set(
        &self,
        port: &str,
        value: Value,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> Fix {
        let (graph, id) = (self.id.clone(), self.node_id.clone());
        Fix::new(label, help, Edit::SetValue { graph, id, port: port.into(), value, index: None })
    }

    fn remove(&self, help: &str) -> Fix {
        Fix::new(
            tr!("Remove this one"),
            help,
            Edit::RemoveNode { graph: self.id.clone(), id: self.node_id.clone() },
        )
    }

    fn known_kinds(&self) -> Vec<Fix> {
        let known = self.session.project.catalog.all().map(|kind| kind.id.as_str());
        let fix = |near: &str| {
            let label =
                self.session.project.catalog.get(near).map_or(near, |kind| of_library(&kind.label));
            let edit = Edit::SetKind {
                graph: self.id.clone(),
                id: self.node_id.clone(),
                kind: near.to_owned(),
            };
            Fix::new(
                tr!("Make it {label}"),
                tr!("Changes the kind to `{near}`; values and wires stay"),
                edit,
            )
        };
        nearest(&self.node.kind, known).into_iter().map(fix).collect()
    }

    /// A remedy for a value or a wire at an unknown port: moves the value or the wire to the port
    /// of the nearest name, or else removes it.
    fn known_port(&self) -> Option<Fix> {
        let (kind, port) = (self.kind()?, self.port.as_ref()?);
        let (graph, id) = (self.id.clone(), self.node_id.clone());
        let near = |ports: &[Port]| {
            let names: Vec<&str> = ports.iter().map(|port| port.name.as_str()).collect();
            nearest(port.as_str(), names).first().map(|name| PortName::from(*name))
        };
        if let Some(value) = self.node.values.get(port) {
            let clear =
                Edit::ClearValue { graph: graph.clone(), id: id.clone(), port: port.clone() };
            let free = near(&kind.inputs).filter(|near| !self.node.values.contains_key(near));
            return Some(match free {
                Some(near) => {
                    let label = tr!("Use {near}");
                    let set =
                        Edit::SetValue { graph, id, port: near, value: value.clone(), index: None };
                    Fix::new(
                        label,
                        tr!("Gives the value to the input of the nearest name"),
                        Edit::Group { edits: vec![clear, set] },
                    )
                }
                None => Fix::new(
                    tr!("Remove the value"),
                    tr!("The node has nothing of a name like this"),
                    clear,
                ),
            });
        }
        let (old, is_input) = match self.wire_into() {
            Some(wire) => (wire, true),
            None => (
                self.graph
                    .wires
                    .iter()
                    .find(|w| w.from.node == self.node_id && w.from.port == *port)?,
                false,
            ),
        };
        let remove = Edit::RemoveWire { graph: graph.clone(), wire: old.clone() };
        let near = near(if is_input { &kind.inputs } else { &kind.outputs });
        let is_free = |near: &PortName| !is_input || self.graph.wire_into(&id, near).is_none();
        Some(match near.filter(is_free) {
            Some(near) => {
                let mut wire = old.clone();
                let end = if is_input { &mut wire.to } else { &mut wire.from };
                end.port = near.clone();
                let add = Edit::AddWire { graph, wire, index: None };
                Fix::new(
                    tr!("Wire {near}"),
                    tr!("Moves the wire to the port of the nearest name"),
                    Edit::Group { edits: vec![remove, add] },
                )
            }
            None => Fix::new(
                tr!("Remove the wire"),
                tr!("The node has nothing of a name like this"),
                remove,
            ),
        })
    }

    /// A remedy that wires an input that must be wired: from a node that feeds nothing yet, or from
    /// a new one.
    fn feed(&self) -> Option<Fix> {
        let (port, ty) = (self.port.as_ref()?, self.input()?.ty.clone());
        let kind = match &ty {
            Type::Composite => "base",
            Type::Color => "color_value",
            Type::Angle => "parametrization",
            Type::Light => "light",
            Type::Vec2 | Type::Vec3 | Type::Vec4 => "vector_value",
            _ if Type::Float.convert_to(&ty).is_some() => "number",
            _ => return None,
        };
        // An Output takes a finished stack or color, if there is one that feeds nothing yet.
        let loose = self.loose_end().filter(|_| ty == Type::Composite);
        let (mut edits, from, label, help) = match loose {
            Some(id) => {
                let title = self.session.look_with_library().title(&id);
                (Vec::new(), id, tr!("Wire {title}"), tr!("Wires {title}, which feeds nothing yet"))
            }
            None => {
                let label = self
                    .session
                    .project
                    .catalog
                    .get(kind)
                    .map_or(kind.to_owned(), |kind| of_library(&kind.label).to_owned());
                let (id, edits) = self.new_node(kind);
                (edits, id, tr!("Add {label}"), tr!("Adds a {label} node and wires it here"))
            }
        };
        let to = Endpoint { node: self.node_id.clone(), port: port.clone() };
        let wire = Wire { from: Endpoint::new(from, ""), to };
        edits.push(Edit::AddWire { graph: self.id.clone(), wire, index: None });
        Some(Fix::new(label, help, Edit::Group { edits }))
    }

    fn new_node(&self, kind: &str) -> (NodeId, Vec<Edit>) {
        let id = NodeId::new(make_slug(kind, |slug| self.graph.nodes.contains_key(slug)));
        let [x, y] = self.node.position;
        let mut node =
            Node { kind: kind.to_owned(), position: [x - 260.0, y + 60.0], ..Node::default() };
        if let ("light", Some(light)) = (kind, self.session.look().lights.keys().next()) {
            node.values.insert("light".into(), Value::Text(light.to_string()));
        }
        (id.clone(), vec![Edit::AddNode { graph: self.id.clone(), id, node, index: None }])
    }

    /// The last node whose stack or color feeds nothing.
    fn loose_end(&self) -> Option<NodeId> {
        loose_end(self.session, self.graph, &self.node_id)
    }

    /// A remedy for axes that follow a mesh's UVs, on a mesh without: *Axes around a direction* for
    /// every node of the graph that bends a direction along such axes. They stand around the
    /// half-vector that is there, or around a new one of the first light.
    fn axes_around(&self) -> Option<Fix> {
        let bends = |id: &NodeId, node: &Node| {
            let kind = self.session.project.catalog.of(node)?;
            let is_loose = AXES.iter().all(|port| {
                let is_of_mesh = kind
                    .input(port)
                    .is_some_and(|at| matches!(&kind.inputs[at].fallback, Fallback::Context(_)));
                let is_set = node.values.contains_key(*port);
                is_of_mesh && !is_set && self.graph.wire_into(id, &(*port).into()).is_none()
            });
            is_loose.then(|| id.clone())
        };
        let bent: Vec<NodeId> =
            self.graph.nodes.iter().filter_map(|(id, node)| bends(id, node)).collect();
        if !bent.contains(&self.node_id) {
            return None;
        }
        let mut made = Vec::new();
        let free =
            |kind: &str| NodeId::new(make_slug(kind, |slug| self.graph.nodes.contains_key(slug)));
        let [x, y] = self.node.position;
        let mut add = |kind: &str, place: [f64; 2], id: &NodeId| {
            let mut node = Node { kind: kind.to_owned(), position: place, ..Node::default() };
            if let ("light", Some(light)) = (kind, self.session.look().lights.keys().next()) {
                node.values.insert("light".into(), Value::Text(light.to_string()));
            }
            let (graph, id) = (self.id.clone(), id.clone());
            made.push(Edit::AddNode { graph, id, node, index: None });
        };
        let mut wires = Vec::new();
        let known = |kind: &str| {
            self.graph.nodes.iter().find(|(_, node)| node.kind == kind).map(|(id, _)| id.clone())
        };
        let half = known("half_vector").unwrap_or_else(|| {
            let half = free("half_vector");
            add("half_vector", [x - 520.0, y + 160.0], &half);
            let light = known("light").unwrap_or_else(|| {
                let light = free("light");
                add("light", [x - 780.0, y + 160.0], &light);
                light
            });
            wires.push((Endpoint::new(light, ""), Endpoint::new(half.clone(), "light")));
            half
        });
        let axes = free("axes");
        add("axes", [x - 260.0, y + 160.0], &axes);
        wires.push((Endpoint::new(half, ""), Endpoint::new(axes.clone(), "direction")));
        for id in bent {
            for port in AXES {
                let from = Endpoint::new(axes.clone(), port);
                wires.push((from, Endpoint::new(id.clone(), port)));
            }
        }
        made.extend(wires.into_iter().map(|(from, to)| {
            let wire = Wire { from, to };
            Edit::AddWire { graph: self.id.clone(), wire, index: None }
        }));
        Some(Fix::new(
            tr!("Use Axes around a direction"),
            tr!("Puts the node in, so that highlights keep their shape on a mesh without UVs"),
            Edit::Group { edits: made },
        ))
    }

    fn clamp(&self) -> Option<Fix> {
        let port = self.input()?;
        let (min, max) = (port.min.unwrap_or(f64::NEG_INFINITY), port.max.unwrap_or(f64::INFINITY));
        let value = match self.node.values.get(&port.name)? {
            Value::Number(x) => Value::Number(x.clamp(min, max)),
            Value::Vector(v) => Value::Vector(v.iter().map(|x| x.clamp(min, max)).collect()),
            _ => return None,
        };
        let label = tr!("Set {value}", value = values::short(port, &value));
        let name = port.name.to_string();
        Some(self.set(&name, value, label, tr!("Takes the nearest value in range")))
    }

    fn known_choice(&self) -> Option<Fix> {
        let port = self.input()?;
        let Value::Text(word) = self.node.values.get(&port.name)? else { return None };
        let words = port.options.iter().map(|(word, _)| word.as_str());
        let Some(near) = nearest(word, words).first().map(|word| (*word).to_owned()) else {
            return self.use_default();
        };
        let label = port
            .options
            .iter()
            .find(|(known, _)| *known == near)
            .map_or(&*near, |(_, label)| of_choice(label))
            .to_owned();
        let name = port.name.to_string();
        Some(self.set(
            &name,
            Value::Text(near),
            tr!("Use {label}"),
            tr!("Takes the nearest word that it knows"),
        ))
    }

    fn known_lights(&self) -> Vec<Fix> {
        let port =
            self.kind().and_then(|kind| kind.inputs.iter().find(|port| port.ty == Type::LightName));
        let Some(port) = port else { return Vec::new() };
        let lights = &self.session.look().lights;
        let wrong = match self.node.values.get(&port.name) {
            Some(Value::Text(id)) => id.as_str(),
            _ => "",
        };
        let near =
            nearest(wrong, lights.keys().map(AsRef::as_ref)).first().map(|id| (*id).to_owned());
        let is_near = |id: &LightId| near.as_deref() == Some(id.as_ref());
        let (nearest, others): (Vec<_>, Vec<_>) = lights.iter().partition(|(id, _)| is_near(id));
        let fixes: Vec<Fix> = nearest
            .into_iter()
            .chain(others)
            .take(MOST_LIGHTS)
            .map(|(id, light)| {
                let name = if light.name.is_empty() { id.as_ref() } else { light.name.as_str() };
                let value = Value::Text(id.to_string());
                self.set(
                    port.name.as_str(),
                    value,
                    tr!("Use {name}"),
                    tr!("Names a light that the look has"),
                )
            })
            .collect();
        if !fixes.is_empty() {
            return fixes;
        }
        let id = LightId::new(if is_slug(wrong) { wrong } else { "key" });
        let light = Light { direction: [-0.5, 0.7, 0.6], ..Light::default() };
        let label = tr!("Add light {id}");
        let help = tr!("Adds a light of this name, from the upper left");
        vec![Fix::new(label, help, Edit::AddLight { id, light, index: None })]
    }

    fn unwire(&self) -> Option<Fix> {
        let edit = Edit::RemoveWire { graph: self.id.clone(), wire: self.wire_into()?.clone() };
        Some(Fix::new(
            tr!("Remove the wire"),
            tr!("Takes the wire away, so that the input has its own value"),
            edit,
        ))
    }

    fn use_default(&self) -> Option<Fix> {
        let has =
            |port: &PortName| self.node.values.contains_key(port) && port.as_str() != CODE_VALUE;
        let port = self.port.clone().filter(has)?;
        let edit = Edit::ClearValue { graph: self.id.clone(), id: self.node_id.clone(), port };
        Some(Fix::new(
            tr!("Use the default"),
            tr!("Takes the value away, so that the input has its default"),
            edit,
        ))
    }
}

/// The last node whose stack or color feeds nothing, apart from `except`.
fn loose_end(session: &Session, graph: &Graph, except: &NodeId) -> Option<NodeId> {
    let is_loose =
        |id: &NodeId| id != except && !graph.wires.iter().any(|wire| wire.from.node == *id);
    let makes = |node: &Node, wanted: &Type| {
        let kind = session.project.catalog.of(node);
        kind.and_then(|kind| kind.outputs.first()).is_some_and(|output| output.ty == *wanted)
    };
    let of = |wanted: &Type| {
        graph.nodes.iter().rev().find(|(id, node)| is_loose(id) && makes(node, wanted))
    };
    // A Base comes last: one that feeds nothing is no finished stack, unless there is nothing else.
    let stack =
        graph.nodes.iter().rev().find(|(id, node)| {
            is_loose(id) && makes(node, &Type::Composite) && node.kind != "base"
        });
    stack.or_else(|| of(&Type::Color)).or_else(|| of(&Type::Composite)).map(|(id, _)| id.clone())
}

fn add_output(session: &Session) -> Fix {
    let graph = &session.look().graph;
    let id = NodeId::new(make_slug("output", |slug| graph.nodes.contains_key(slug)));
    let from = loose_end(session, graph, &id);
    let place =
        from.as_ref().and_then(|id| graph.nodes.get(id)).map_or([0.0; 2], |node| node.position);
    let node = Node {
        kind: "output".to_owned(),
        position: [place[0] + 260.0, place[1]],
        ..Node::default()
    };
    let mut edits = vec![Edit::AddNode { graph: GraphId::Look, id: id.clone(), node, index: None }];
    edits.extend(from.map(|from| {
        let wire = Wire { from: Endpoint::new(from, ""), to: Endpoint::new(id, "color") };
        Edit::AddWire { graph: GraphId::Look, wire, index: None }
    }));
    Fix::new(
        tr!("Add an Output"),
        tr!("Adds an Output node, wired to what feeds nothing yet"),
        Edit::Group { edits },
    )
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::diag::Diagnostic;
    use crate::ids::NodePath;
    use crate::library::Library;

    #[test]
    fn axes_of_the_mesh_become_axes_around_the_half_vector() {
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        let add = |kind: &str| Edit::AddNode {
            graph: GraphId::Look,
            id: NodeId::new(kind),
            node: Node { kind: kind.to_owned(), ..Node::default() },
            index: None,
        };
        let edits = ["split_direction", "square_direction"].map(add).to_vec();
        session.apply(Edit::Group { edits }, None).unwrap();
        let problem = Diagnostic::note("level-tangents", "they lie level")
            .node(NodePath::root(NodeId::new("split_direction")));
        let fixes = of(&session, &problem);
        let [fix] = &fixes[..] else { panic!("one remedy, not {}", fixes.len()) };
        assert_eq!(fix.label, "Use Axes around a direction");
        session.apply(fix.edit.clone(), None).unwrap();
        let graph = &session.look().graph;
        for node in ["split_direction", "square_direction"] {
            for port in AXES {
                let wire = graph.wire_into(&NodeId::new(node), &port.into()).expect("wired");
                assert_eq!((wire.from.node.as_str(), wire.from.port.as_str()), ("axes", port));
            }
        }
        let around = graph.wire_into(&NodeId::new("axes"), &"direction".into()).expect("wired");
        assert_eq!(around.from.node.as_str(), "half_vector");
        assert!(of(&session, &problem).is_empty(), "nothing is left to do");
        session.undo();
        assert!(!session.look().graph.nodes.contains_key("axes"), "one step");
    }
}
