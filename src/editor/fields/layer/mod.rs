//! The selected layer, as far as it can be edited on the object: its light, profile, warp and
//! colors; and all layers that draw a light, those in groups that run for each light among them.

mod place;
mod regions;

use std::f64::consts::PI;

use crate::document::{Target, Value};
use crate::fields::lighting::light_in_view;
use crate::ids::{LightId, NodeId, NodePath};
use crate::placing::Parametrization;
use crate::state::session::Session;
use place::NodeInGraph;

pub(crate) use regions::RegionLayers;

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
    /// The node with the groups that it lies in.
    pub(crate) path: NodePath,
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
        path: place.path.clone(),
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
        path: place.path.clone(),
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
