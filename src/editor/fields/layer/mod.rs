//! The selected layer, as far as it can be edited on the object: its light, profile, warp and
//! colors; and all layers that draw a light, those in groups that run for each light among them.

mod highlight;
mod place;
mod regions;

use std::f64::consts::PI;

use chiaro_locale::tr;

use crate::document::{Target, Value};
use crate::fields::bands::{self, Bands};
use crate::fields::edge::{self, ProfileEdge};
use crate::fields::lighting::light_in_view;
use crate::ids::{LightId, NodeId, NodePath};
use crate::placing::Parametrization;
use crate::state::session::Session;
use place::NodeInGraph;

pub(crate) use highlight::{HighlightShape, SelectedHighlight, selected_highlight};
pub(crate) use regions::RegionLayers;

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
    /// Edge after a band, counted from 0.
    Edge(usize),
}

impl Curve {
    /// Curves of a profile.
    pub(crate) const ALL: [Self; 3] = [Self::Offset, Self::Falloff, Self::Cutoff];

    /// Number of the curve in its layer, from the light on.
    pub(crate) fn index(self) -> usize {
        match self {
            Self::Offset => 0,
            Self::Falloff => 1,
            Self::Cutoff => 2,
            Self::Edge(index) => index,
        }
    }

    pub(crate) fn port(self) -> &'static str {
        match self {
            Self::Offset => "offset",
            Self::Falloff => "falloff",
            Self::Cutoff => "cutoff",
            Self::Edge(_) => bands::PORT,
        }
    }

    pub(crate) fn label(self) -> String {
        match self {
            Self::Offset => tr!("Offset").to_owned(),
            Self::Falloff => tr!("Fall-off").to_owned(),
            Self::Cutoff => tr!("Cut-off").to_owned(),
            Self::Edge(index) => tr!("Edge {number}", number = index + 1),
        }
    }
}

/// Values that say how a layer changes over the angle from its light.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum LayerShape {
    /// Offset, fall-off and cut-off in radians, as in the document.
    Profile([Setting<f64>; 3]),
    /// Flat colors with edges between them.
    Bands(Setting<Bands>),
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
    pub(crate) shape: LayerShape,
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
    /// Bands have the edge of their last one, beyond which all is dark.
    pub(crate) fn angles(&self) -> [f64; 3] {
        self.in_order(|setting| setting.value, |bands| &bands.value)
    }

    /// Angles that an edit would change: those of the current key.
    pub(crate) fn angles_at_key(&self) -> [f64; 3] {
        self.in_order(|setting| setting.at_key, |bands| &bands.at_key)
    }

    fn in_order(
        &self,
        of: impl Fn(&Setting<f64>) -> f64,
        of_bands: impl Fn(&Setting<Bands>) -> &Bands,
    ) -> [f64; 3] {
        match &self.shape {
            LayerShape::Profile(shape) => edge::in_order(shape.each_ref().map(of)),
            LayerShape::Bands(bands) => [of_bands(bands).edges.last().copied().unwrap_or(PI); 3],
        }
    }

    /// Settings of the profile; `None` for a layer of bands.
    pub(crate) fn profile(&self) -> Option<&[Setting<f64>; 3]> {
        match &self.shape {
            LayerShape::Profile(shape) => Some(shape),
            LayerShape::Bands(_) => None,
        }
    }

    /// Bands of the layer, with the input that holds them.
    pub(crate) fn bands(&self) -> Option<&Setting<Bands>> {
        match &self.shape {
            LayerShape::Profile(_) => None,
            LayerShape::Bands(bands) => Some(bands),
        }
    }

    /// True if one of the values that shape the layer comes by a wire.
    pub(crate) fn is_shape_wired(&self) -> bool {
        match &self.shape {
            LayerShape::Profile(shape) => shape.iter().any(|setting| setting.is_wired),
            LayerShape::Bands(bands) => bands.is_wired,
        }
    }

    /// Edge that the profile is, as an edit would change it; `None` where it is none.
    pub(crate) fn edge(&self) -> Option<ProfileEdge> {
        self.profile().filter(|_| !self.is_shape_wired())?;
        ProfileEdge::of(self.angles_at_key())
    }

    /// Curves that can be set, with their present angles in radians, from the light on.
    pub(crate) fn curves(&self) -> Vec<(Curve, f64)> {
        match &self.shape {
            LayerShape::Profile(shape) => {
                let all = Curve::ALL.into_iter().zip(self.angles());
                all.filter(|(curve, _)| !shape[curve.index()].is_wired).collect()
            }
            LayerShape::Bands(bands) if bands.is_wired => Vec::new(),
            LayerShape::Bands(bands) => {
                let edges = bands.value.edges.iter().copied().enumerate();
                edges.map(|(index, edge)| (Curve::Edge(index), edge)).collect()
            }
        }
    }

    /// Values that move curves, which lie next to one another, to an angle between their
    /// neighbors; in radians.
    pub(crate) fn moved(&self, curves: &[Curve], angle: f64) -> Vec<(Target, Value)> {
        let (Some(first), Some(last)) = (curves.first(), curves.last()) else { return Vec::new() };
        let between = |angles: &[f64]| {
            let low = first.index().checked_sub(1).and_then(|at| angles.get(at)).copied();
            let high = angles.get(last.index() + 1).copied().unwrap_or(PI);
            angle.clamp(low.unwrap_or(0.0).min(high), high)
        };
        match &self.shape {
            LayerShape::Profile(shape) => {
                let angle = between(&self.angles());
                let targets = curves.iter().filter_map(|curve| shape.get(curve.index()));
                targets.map(|it| (it.target.clone(), Value::Number(angle))).collect()
            }
            LayerShape::Bands(setting) => {
                let mut bands = setting.at_key.clone();
                let angle = between(&bands.edges);
                for curve in curves {
                    if let Some(edge) = bands.edges.get_mut(curve.index()) {
                        *edge = angle;
                    }
                }
                vec![(setting.target.clone(), Value::Ramp(bands.ramp()))]
            }
        }
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
    let shape = place.layer_shape()?;
    let (slope, amount) = (place.number("slope"), place.number("amount"));
    let known = |setting: &Option<Setting<f64>>| {
        setting.as_ref().filter(|it| !it.is_wired).map(|it| it.value)
    };
    let is_kappa_plain = place.is_plain("kappa", "kappa");
    let warp = known(&slope).zip(known(&amount)).filter(|_| is_kappa_plain);
    let leaves_out = if !place.is_plain("normal", "normal") {
        Some(tr!("the normals wired into the layer"))
    } else if warp.is_none() && amount.is_some() {
        Some(tr!("the warp, which depends on what is wired into the layer"))
    } else {
        None
    };
    let colors = [(tr!("Convex"), "convex"), (tr!("Concave"), "concave")];
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
        Some(tr!("the normals wired into the angle"))
    } else if is_warped && warp.is_none() {
        Some(tr!("what is wired into the warp"))
    } else {
        None
    };
    Some(SelectedLayer {
        node: place.id.clone(),
        path: place.path.clone(),
        name: place.name(),
        light: light.light()?,
        shading: Parametrization::of(angle.word("type")?)?,
        shape: LayerShape::Profile(place.shape()?),
        slope,
        amount,
        colors: Vec::new(),
        warp,
        leaves_out,
    })
}
