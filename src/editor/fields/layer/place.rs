//! Nodes of a graph with what feeds them: of the open graph, and in groups, whose inputs lead on to
//! the group's node.

use std::rc::Rc;

use crate::catalog::NodeKind;
use crate::document::{Graph, Node, Target, Value, Wire};
use crate::fields::bands::{self, Bands};
use crate::ids::{GROUP_INPUTS, LightId, NodeId, NodePath, PortName};
use crate::library::Type;
use crate::state::reading::of_library;
use crate::state::session::Session;
use crate::values;

use super::{LayerShape, Setting};

/// Largest number of reroutes that a wire is followed through.
const MOST_REROUTES: usize = 64;

/// Node with its kind, in its graph.
#[derive(Clone)]
pub(super) struct NodeInGraph<'a> {
    pub(super) session: &'a Session,
    pub(super) graph: &'a Graph,
    pub(super) id: &'a NodeId,
    pub(super) node: &'a Node,
    kind: &'a NodeKind,
    /// The node through the groups that it lies in.
    pub(super) path: NodePath,
    /// Node of the group that the graph is looked into from; `None` for the graph that is open.
    around: Option<Rc<Self>>,
    /// Light that the graph runs for, where it runs for each.
    each: Option<LightId>,
}

impl<'a> NodeInGraph<'a> {
    /// A node of the open graph.
    pub(super) fn of(session: &'a Session, id: &NodeId) -> Option<Self> {
        let graph = session.graph();
        let (id, node) = graph.nodes.get_key_value(id.as_str())?;
        let kind = session.project.catalog.of(node)?;
        let path = session.selection.path_of(id);
        Some(Self { session, graph, id, node, kind, path, around: None, each: None })
    }

    /// The nodes of the look's own graph.
    pub(super) fn of_look(session: &'a Session) -> impl Iterator<Item = Self> {
        let graph = &session.look().graph;
        graph.nodes.iter().filter_map(move |(id, node)| {
            let kind = session.project.catalog.of(node)?;
            let path = NodePath::root(id.clone());
            Some(Self { session, graph, id, node, kind, path, around: None, each: None })
        })
    }

    /// The nodes in a group of the look; `each` is the light that the group runs for.
    pub(super) fn inside(self: &Rc<Self>, each: Option<&LightId>) -> impl Iterator<Item = Self> {
        let session = self.session;
        let definition = session.look().definitions.get(self.node.kind.as_str());
        let each = each.or(self.each.as_ref()).cloned();
        let around = Rc::clone(self);
        definition
            .into_iter()
            .flat_map(|definition| {
                definition.graph.nodes.iter().map(|(id, node)| (&definition.graph, id, node))
            })
            .filter_map(move |(graph, id, node)| {
                let kind = session.project.catalog.of(node)?;
                let (path, each) = (around.path.join(id.clone()), each.clone());
                let around = Some(Rc::clone(&around));
                Some(Self { session, graph, id, node, kind, path, around, each })
            })
    }

    /// A node of the same graph.
    fn beside(&self, id: &NodeId) -> Option<Self> {
        let (id, node) = self.graph.nodes.get_key_value(id.as_str())?;
        let kind = self.session.project.catalog.of(node)?;
        let path = match self.path.parent() {
            Some(around) => around.join(id.clone()),
            None => NodePath::root(id.clone()),
        };
        Some(Self { id, node, kind, path, ..self.clone() })
    }

    /// The input of the group around the graph that a wire comes from, with the group's node.
    fn given(&self, wire: &Wire) -> Option<(&Rc<Self>, PortName)> {
        let is_inputs = wire.from.node.as_str() == GROUP_INPUTS;
        self.around.as_ref().filter(|_| is_inputs).map(|around| (around, wire.from.port.clone()))
    }

    /// Node that is wired to an input, through reroutes and out of groups.
    pub(super) fn feeds(&self, port: &str) -> Option<Self> {
        let (mut place, mut port) = (self.clone(), PortName::new(port));
        for _ in 0..MOST_REROUTES {
            let wire = place.graph.wire_into(place.id, &port)?;
            if let Some((around, outer)) = place.given(wire) {
                (place, port) = ((**around).clone(), outer);
                continue;
            }
            let from = place.beside(&wire.from.node)?;
            if !from.kind.is_reroute {
                return Some(from);
            }
            port = from.kind.inputs.first()?.name.clone();
            place = from;
        }
        None
    }

    /// True if an input has its value by a wire, out of the group too.
    pub(super) fn is_wired(&self, port: &str) -> bool {
        match self.graph.wire_into(self.id, &port.into()) {
            None => false,
            Some(wire) => match self.given(wire) {
                Some((around, outer)) => around.is_wired(outer.as_str()),
                None => true,
            },
        }
    }

    fn value(&self, port: &str) -> Option<&Value> {
        let port = &self.kind.inputs[self.kind.input(port)?];
        values::current(port, self.node.values.get(&port.name))
    }

    fn setting<T>(&self, port: &str, read: impl Fn(Option<&Value>) -> T) -> Option<Setting<T>> {
        self.kind.input(port)?;
        let wire = self.graph.wire_into(self.id, &port.into());
        if let Some((around, outer)) = wire.and_then(|wire| self.given(wire)) {
            return around.setting(outer.as_str(), &read as &dyn Fn(Option<&Value>) -> T);
        }
        let target = Target::Input { node: self.path.clone(), port: port.into() };
        let value = read(self.session.keys().value_now(&target).as_ref());
        let at_key = read(self.session.keys().value_at(&target).as_ref());
        Some(Setting { target, value, at_key, is_wired: wire.is_some() })
    }

    pub(super) fn number(&self, port: &str) -> Option<Setting<f64>> {
        self.setting(port, values::number)
    }

    pub(super) fn color(&self, port: &str) -> Option<Setting<[f64; 4]>> {
        let space = self.session.look().color_space;
        self.setting(port, |value| {
            value.and_then(|value| value.color_in(space)).unwrap_or([0.0, 0.0, 0.0, 1.0])
        })
    }

    pub(super) fn word(&self, port: &str) -> Option<&str> {
        match self.value(port)? {
            Value::Text(word) => Some(word),
            _ => None,
        }
    }

    /// The light that the node names, or else the one that its graph runs for.
    pub(super) fn light(&self) -> Option<LightId> {
        let port = self.kind.inputs.iter().find(|port| port.ty == Type::LightName)?;
        match self.word(port.name.as_str()).unwrap_or_default() {
            "" => self.each.clone(),
            word => {
                let id = LightId::new(word);
                self.session.look().lights.contains_key(&id).then_some(id)
            }
        }
    }

    pub(super) fn name(&self) -> String {
        match self.node.name.is_empty() {
            true => of_library(&self.kind.label).to_owned(),
            false => self.node.name.clone(),
        }
    }

    pub(super) fn shape(&self) -> Option<[Setting<f64>; 3]> {
        Some([self.number("offset")?, self.number("falloff")?, self.number("cutoff")?])
    }

    /// The profile of a layer, or its bands.
    pub(super) fn layer_shape(&self) -> Option<LayerShape> {
        if let Some(shape) = self.shape() {
            return Some(LayerShape::Profile(shape));
        }
        let setting = self.setting(bands::PORT, |value| match value {
            Some(Value::Ramp(ramp)) => Bands::of(ramp),
            _ => None,
        })?;
        let Setting { target, value, at_key, is_wired } = setting;
        Some(LayerShape::Bands(Setting { target, value: value?, at_key: at_key?, is_wired }))
    }

    /// True if an input has the surface's own curvature, or normal.
    pub(super) fn is_plain(&self, port: &str, kind: &str) -> bool {
        !self.is_wired(port)
            || self.feeds(port).is_some_and(|from| {
                from.node.kind == kind
                    && (kind != "kappa" || from.word("source") == Some("surface"))
            })
    }
}
