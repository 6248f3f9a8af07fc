//! The selected layer, as far as it can be edited on the object: its light, profile, warp and
//! colors.

use std::f64::consts::PI;

use crate::catalog::NodeKind;
use crate::document::{Graph, Node, Target, Value};
use crate::fields::lighting::light_in_view;
use crate::ids::{LightId, NodeId};
use crate::library::Type;
use crate::placing::Parametrization;
use crate::state::session::Session;
use crate::values;

/// Largest number of reroutes that a wire is followed through.
const MOST_REROUTES: usize = 64;

/// Name of the place where a parametrization's angle is 0.
pub(crate) fn middle_name(parametrization: Parametrization) -> &'static str {
    if parametrization.mirrors() { "highlight" } else { "bright middle" }
}

/// Input with its value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Setting<T> {
    pub(crate) target: Target,
    /// Present value, which is drawn.
    pub(crate) value: T,
    /// Value that an edit would change: that of the current key; differs from `value` where keys
    /// are blended.
    pub(crate) at_key: T,
    /// True if the value comes from a wire, so that it cannot be set.
    pub(crate) is_wired: bool,
}

/// Curve of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Curve {
    Offset,
    Falloff,
    Cutoff,
}

impl Curve {
    pub(crate) const ALL: [Self; 3] = [Self::Offset, Self::Falloff, Self::Cutoff];

    pub(crate) fn port(self) -> &'static str {
        match self {
            Self::Offset => "offset",
            Self::Falloff => "falloff",
            Self::Cutoff => "cutoff",
        }
    }

    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Offset => "Offset",
            Self::Falloff => "Fall-off",
            Self::Cutoff => "Cut-off",
        }
    }
}

/// Selected layer: a group with the inputs of a layer, or a profile with the nodes that feed it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SelectedLayer {
    pub(crate) node: NodeId,
    pub(crate) name: String,
    pub(crate) light: LightId,
    pub(crate) shading: Parametrization,
    /// Offset, fall-off and cut-off in radians, as in the document.
    pub(crate) shape: [Setting<f64>; 3],
    pub(crate) slope: Option<Setting<f64>>,
    pub(crate) amount: Option<Setting<f64>>,
    /// Colors of the convex and the concave side, with their names.
    pub(crate) colors: Vec<(&'static str, Setting<[f64; 4]>)>,
    /// Slope and amount, where known.
    pub(crate) warp: Option<(f64, f64)>,
    /// Effects that the curves do not show.
    pub(crate) leaves_out: Option<&'static str>,
}

impl SelectedLayer {
    /// Offset, fall-off and cut-off as the profile uses them: in order, 0 to pi (docs/math.md D2).
    pub(crate) fn angles(&self) -> [f64; 3] {
        self.in_order(|setting| setting.value)
    }

    /// Angles that an edit would change: those of the current key.
    pub(crate) fn angles_at_key(&self) -> [f64; 3] {
        self.in_order(|setting| setting.at_key)
    }

    fn in_order(&self, of: impl Fn(&Setting<f64>) -> f64) -> [f64; 3] {
        let [offset, falloff, cutoff] = [0, 1, 2].map(|index| {
            let value = of(&self.shape[index]);
            if value.is_finite() { value } else { 0.0 }
        });
        let offset = offset.clamp(0.0, PI);
        let cutoff = cutoff.clamp(offset, PI);
        [offset, falloff.clamp(offset, cutoff), cutoff]
    }
}

/// Node with its kind, in the graph that is open.
struct NodeInGraph<'a> {
    session: &'a Session,
    graph: &'a Graph,
    id: &'a NodeId,
    node: &'a Node,
    kind: &'a NodeKind,
}

impl<'a> NodeInGraph<'a> {
    fn of(session: &'a Session, id: &NodeId) -> Option<Self> {
        let graph = session.graph();
        let (id, node) = graph.nodes.get_key_value(id.as_str())?;
        Some(Self { session, graph, id, node, kind: session.project.catalog.of(node)? })
    }

    /// Node that is wired to an input, through reroutes.
    fn feeds(&self, port: &str) -> Option<Self> {
        let mut wire = self.graph.wire_into(self.id, &port.into())?;
        for _ in 0..MOST_REROUTES {
            let place = Self::of(self.session, &wire.from.node)?;
            if !place.kind.is_reroute {
                return Some(place);
            }
            let input = place.kind.inputs.first()?.name.clone();
            wire = self.graph.wire_into(place.id, &input)?;
        }
        None
    }

    fn is_wired(&self, port: &str) -> bool {
        self.graph.wire_into(self.id, &port.into()).is_some()
    }

    fn value(&self, port: &str) -> Option<&Value> {
        let port = &self.kind.inputs[self.kind.input(port)?];
        values::current(port, self.node.values.get(&port.name))
    }

    fn setting<T>(&self, port: &str, read: impl Fn(Option<&Value>) -> T) -> Option<Setting<T>> {
        self.kind.input(port)?;
        let target = self.session.selection.target(self.id, &port.into());
        let value = read(self.session.keys().value_now(&target).as_ref());
        let at_key = read(self.session.keys().value_at(&target).as_ref());
        Some(Setting { target, value, at_key, is_wired: self.is_wired(port) })
    }

    fn number(&self, port: &str) -> Option<Setting<f64>> {
        self.setting(port, values::number)
    }

    fn color(&self, port: &str) -> Option<Setting<[f64; 4]>> {
        let space = self.session.look().color_space;
        self.setting(port, |value| {
            value.and_then(|value| value.color_in(space)).unwrap_or([0.0, 0.0, 0.0, 1.0])
        })
    }

    fn word(&self, port: &str) -> Option<&str> {
        match self.value(port)? {
            Value::Text(word) => Some(word),
            _ => None,
        }
    }

    fn light(&self) -> Option<LightId> {
        let port = self.kind.inputs.iter().find(|port| port.ty == Type::LightName)?;
        let id = LightId::new(self.word(port.name.as_str())?);
        self.session.look().lights.contains_key(&id).then_some(id)
    }

    fn name(&self) -> String {
        if self.node.name.is_empty() { self.kind.label.to_string() } else { self.node.name.clone() }
    }

    fn shape(&self) -> Option<[Setting<f64>; 3]> {
        Some([self.number("offset")?, self.number("falloff")?, self.number("cutoff")?])
    }

    /// True if an input has the surface's own curvature, or normal.
    fn is_plain(&self, port: &str, kind: &str) -> bool {
        !self.is_wired(port)
            || self.feeds(port).is_some_and(|from| {
                from.node.kind == kind
                    && (kind != "kappa" || from.word("source") == Some("surface"))
            })
    }
}

/// Layer of the node that was selected last, if there is one.
pub(crate) fn selected(session: &Session) -> Option<SelectedLayer> {
    if session.graph_view().is_read_only() {
        return None;
    }
    let place = NodeInGraph::of(session, session.selection.nodes.last()?)?;
    group(&place).or_else(|| profile(&place)).or_else(|| {
        // A node for an angle, a light or a warp stands for the profile that it feeds, if that is
        // exactly one.
        let fed = |from: &NodeInGraph<'_>| {
            let mut wires = from.graph.wires.iter().filter(|wire| wire.from.node == *from.id);
            let mut to = wires.by_ref().map(|wire| wire.to.node.clone()).collect::<Vec<_>>();
            to.dedup();
            to
        };
        let found: Vec<SelectedLayer> =
            fed(&place).iter().filter_map(|id| profile(&NodeInGraph::of(session, id)?)).collect();
        (found.len() == 1).then(|| found.into_iter().next()).flatten()
    })
}

/// Selected light: that of a layer, or that of a Light node.
pub(crate) fn selected_light(session: &Session) -> Option<LightId> {
    NodeInGraph::of(session, session.selection.nodes.last()?)?.light()
}

/// The light that handles, placing and looking through are of: the one that was chosen, or else
/// that of the selected layer or node.
pub(crate) fn light_at_hand(session: &Session) -> Option<LightId> {
    let chosen = session.selection.light.as_ref();
    let chosen = chosen.filter(|id| light_in_view(session, id).is_some()).cloned();
    let of_layer = || selected(session).map(|layer| layer.light);
    chosen.or_else(of_layer).or_else(|| selected_light(session))
}

/// Parametrization in the look's groups, which draw the lights that no layer names: one that
/// mirrors, where any does. `None` where no group has an angle.
pub(crate) fn shading_of_sets(session: &Session) -> Option<Parametrization> {
    let graphs = session.look().definitions.values().map(|definition| &definition.graph);
    let angles = graphs.flat_map(|graph| graph.nodes.values());
    let angles = angles.filter(|node| node.kind == "parametrization");
    let all = angles.filter_map(|node| match node.values.get("type") {
        Some(Value::Text(word)) => Parametrization::of(word),
        _ => Some(Parametrization::Diffuse),
    });
    let all: Vec<Parametrization> = all.collect();
    all.iter().find(|shading| shading.mirrors()).or(all.first()).copied()
}

/// Layers of the open graph that a light feeds, the selected one first.
pub(crate) fn fed_by(session: &Session, light: &LightId) -> Vec<SelectedLayer> {
    let chosen = selected(session);
    let nodes = session.graph().nodes.keys();
    let of_graph = nodes.filter_map(|id| {
        let place = NodeInGraph::of(session, id)?;
        group(&place).or_else(|| profile(&place))
    });
    let is_chosen = |layer: &SelectedLayer| chosen.as_ref().is_some_and(|it| it.node == layer.node);
    let others: Vec<SelectedLayer> = of_graph.filter(|layer| !is_chosen(layer)).collect();
    chosen.into_iter().chain(others).filter(|layer| layer.light == *light).collect()
}

fn group(place: &NodeInGraph<'_>) -> Option<SelectedLayer> {
    let shading = Parametrization::of(place.word("type")?)?;
    let shape = place.shape()?;
    let (slope, amount) = (place.number("slope"), place.number("amount"));
    let known = |setting: &Option<Setting<f64>>| {
        setting.as_ref().filter(|it| !it.is_wired).map(|it| it.value)
    };
    let is_kappa_plain = place.is_plain("kappa", "kappa");
    let warp = known(&slope).zip(known(&amount)).filter(|_| is_kappa_plain);
    let leaves_out = if !place.is_plain("normal", "normal") {
        Some("the normals wired into the layer")
    } else if warp.is_none() && amount.is_some() {
        Some("the warp, which depends on what is wired into the layer")
    } else {
        None
    };
    let colors = [("Convex color", "convex"), ("Concave color", "concave")];
    let colors =
        colors.into_iter().filter_map(|(label, port)| Some((label, place.color(port)?))).collect();
    Some(SelectedLayer {
        node: place.id.clone(),
        name: place.name(),
        light: place.light()?,
        shading,
        shape,
        slope,
        amount,
        colors,
        warp,
        leaves_out,
    })
}

fn profile(place: &NodeInGraph<'_>) -> Option<SelectedLayer> {
    if place.node.kind != "profile" {
        return None;
    }
    let angle = place.feeds("angle").filter(|angle| angle.node.kind == "parametrization")?;
    let light = angle.feeds("light").filter(|light| light.node.kind == "light")?;
    let shift = place.feeds("shift").filter(|shift| shift.node.kind == "warp");
    let transition = shift
        .as_ref()
        .and_then(|warp| warp.feeds("convexity"))
        .filter(|from| from.node.kind == "transition");
    let slope = transition.as_ref().and_then(|from| from.number("slope"));
    let amount = shift.as_ref().and_then(|from| from.number("amount"));
    let is_warped = place.is_wired("shift");
    let is_known = transition.as_ref().is_some_and(|from| from.is_plain("kappa", "kappa"));
    let known = |setting: &Option<Setting<f64>>| {
        setting.as_ref().filter(|it| !it.is_wired).map(|it| it.value)
    };
    let warp = known(&slope).zip(known(&amount)).filter(|_| is_known);
    let leaves_out = if !angle.is_plain("normal", "normal") {
        Some("the normals wired into the angle")
    } else if is_warped && warp.is_none() {
        Some("what is wired into the warp")
    } else {
        None
    };
    Some(SelectedLayer {
        node: place.id.clone(),
        name: place.name(),
        light: light.light()?,
        shading: Parametrization::of(angle.word("type")?)?,
        shape: place.shape()?,
        slope,
        amount,
        colors: Vec::new(),
        warp,
        leaves_out,
    })
}
