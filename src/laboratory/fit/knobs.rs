//! Knobs, the parts of a look that a fit turns: directions of its lights, profiles and colors, with
//! the inputs that hold them.

use std::collections::HashSet;

use indexmap::IndexMap;

use crate::compile::{Param, TypedGraph, TypedInput, TypedSource, check};
use crate::diag::Diagnostic;
use crate::document::{Edit, Light, LightKind, Look, Ramp, Target, Value};
use crate::frame::Setup;
use crate::ids::{LightId, NodePath, PortName};
use crate::library::{Library, Type};

use super::KeptParts;
use super::state::{KnobSetting, ProfileShape};

/// The ports of a profile, which belong together.
const ENDS: [&str; 3] = ["offset", "falloff", "cutoff"];

/// Largest number of ramp stops that are turned: each is a color of its own, and a few strokes
/// could not determine more of them.
const MOST_STOPS: usize = 24;

/// A part of a look that a fit turns.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Knob {
    /// Direction toward a directional light.
    Direction(LightId),
    /// Offset, fall-off and cut-off of a profile.
    Profile(NodePath),
    /// A color of an input; its alpha stays.
    Color { node: NodePath, port: PortName, alpha: f64 },
    /// A color of a ramp, by the index of its stop; the stop's place and alpha stay.
    Stop { node: NodePath, port: PortName, index: usize, ramp: Ramp },
}

impl Knob {
    /// Noun for people, and the place of the knob in the look.
    pub(super) fn told(&self) -> (&'static str, String) {
        match self {
            Self::Direction(light) => ("light", light.to_string()),
            Self::Profile(node) => ("profile", node.to_string()),
            Self::Color { node, port, .. } => ("color", format!("{node}.{port}")),
            Self::Stop { node, port, index, .. } => ("color", format!("{node}.{port}[{index}]")),
        }
    }

    /// The inputs that the knob sets.
    pub(super) fn inputs(&self) -> Vec<(NodePath, PortName)> {
        match self {
            Self::Direction(_) => Vec::new(),
            Self::Profile(node) => ENDS.map(|port| (node.clone(), port.into())).to_vec(),
            Self::Color { node, port, .. } | Self::Stop { node, port, .. } => {
                vec![(node.clone(), port.clone())]
            }
        }
    }

    /// The values of the knob's inputs, in their order. `before` is the current value of the input:
    /// the stops of a ramp are set one after the other.
    pub(super) fn values(&self, setting: &KnobSetting, before: Option<&Value>) -> Vec<Value> {
        match (self, setting) {
            (Self::Stop { index, ramp, .. }, KnobSetting::Color(color)) => {
                let before = if let Some(Value::Ramp(before)) = before { before } else { ramp };
                vec![Value::Ramp(with_stop(before, *index, *color))]
            }
            (Self::Profile(_), KnobSetting::Profile(shape)) => {
                shape.ends().map(Value::Number).to_vec()
            }
            (Self::Color { alpha, .. }, KnobSetting::Color([r, g, b])) => {
                vec![Value::Vector(vec![*r, *g, *b, *alpha])]
            }
            _ => Vec::new(),
        }
    }
}

/// Edits that write settings into a look, in numbers that people can read: five decimals are finer
/// than a tenth of a pixel.
pub(super) fn edits(knobs: &[Knob], state: &[KnobSetting], look: &Look) -> Vec<Edit> {
    let mut edits = Vec::new();
    let mut values: IndexMap<(NodePath, PortName), Value> = IndexMap::new();
    for (knob, setting) in knobs.iter().zip(state) {
        if let (Knob::Direction(id), KnobSetting::Direction(direction)) = (knob, setting) {
            edits.extend(look.lights.get(id).map(|light| {
                let light = Light { direction: direction.to_array().map(short), ..light.clone() };
                Edit::SetLight { id: id.clone(), light }
            }));
        }
        let inputs = knob.inputs();
        let before = inputs.first().and_then(|input| values.get(input));
        let new = knob.values(setting, before);
        values.extend(inputs.into_iter().zip(new));
    }
    edits.extend(values.into_iter().filter_map(|((path, port), value)| {
        let found = look.find(&path)?;
        let (graph, id) = (found.graph, path.last()?.clone());
        Some(Edit::SetValue { graph, id, port, value: shortened(value), index: None })
    }));
    edits
}

/// The ramp with another color at a stop, which keeps its alpha.
fn with_stop(ramp: &Ramp, index: usize, color: [f64; 3]) -> Ramp {
    let mut ramp = ramp.clone();
    if let Some(stop) = ramp.stops.get_mut(index) {
        stop.color.iter_mut().zip(color).for_each(|(channel, new)| *channel = new);
    }
    ramp
}

fn short(x: f64) -> f64 {
    (x * 1e5).round() / 1e5
}

fn shortened(value: Value) -> Value {
    match value {
        Value::Number(x) => Value::Number(short(x)),
        // An opaque color needs no alpha.
        Value::Vector(v) => {
            let is_opaque = v.len() == 4 && v[3] == 1.0;
            Value::Vector(v.into_iter().take(if is_opaque { 3 } else { 4 }).map(short).collect())
        }
        Value::Ramp(mut ramp) => {
            ramp.stops
                .iter_mut()
                .flat_map(|stop| &mut stop.color)
                .for_each(|channel| *channel = short(*channel));
            Value::Ramp(ramp)
        }
        other => other,
    }
}

/// All knobs of a look, with their settings. Wired and keyed values, and those set by the scene,
/// are no knobs; nor are the stops of a ramp that would make more than [`MOST_STOPS`] together with
/// those of other ramps.
///
/// # Errors
/// Problems of the look.
pub(super) fn knobs_of(
    setup: &Setup,
    index: usize,
    library: &Library,
    keep: &KeptParts,
) -> Result<Vec<(Knob, KnobSetting)>, Vec<Diagnostic>> {
    let look = &setup.looks[index].look;
    let located = |mut problems: Vec<Diagnostic>| {
        setup.looks[index].source.locate_all(&mut problems);
        problems
    };
    let typed = check(look, library, None).map_err(located)?.value;
    let fixed = fixed(setup, index, &typed);
    let live = reaching(&typed);
    let mut knobs = Vec::new();
    if !keep.lights {
        knobs.extend(lights(setup, look, &typed, &live, &fixed));
    }
    let mut known = HashSet::new();
    let mut stops_left = MOST_STOPS;
    for node in live.iter().map(|&node| &typed.nodes[node]) {
        for input in node.inputs.iter().flatten() {
            let TypedSource::Param(id, _) = &input.source else { continue };
            let param = &typed.params[*id];
            let found = if ENDS.contains(&param.port.as_str()) {
                profile(param, &typed.params).filter(|_| !keep.profiles)
            } else {
                color(param, input, look).filter(|_| !keep.colors)
            };
            if let Some(Value::Ramp(ramp)) = param.value.as_ref().filter(|_| !keep.colors)
                && ramp.stops.len() <= stops_left
            {
                let target = Target::Input { node: param.path.clone(), port: param.port.clone() };
                let stops = stops(param, ramp);
                if !fixed.contains(&target)
                    && stops.iter().all(|(knob, _)| known.insert(knob.told()))
                {
                    stops_left -= stops.len();
                    knobs.extend(stops);
                }
                continue;
            }
            let Some((knob, setting)) = found else { continue };
            let is_base = keep.base && node.def.kind == "base";
            let is_fixed = knob
                .inputs()
                .into_iter()
                .any(|(node, port)| fixed.contains(&Target::Input { node, port }));
            if !is_base && !is_fixed && known.insert(knob.told()) {
                knobs.push((knob, setting));
            }
        }
    }
    Ok(knobs)
}

/// Targets that keys move, and those that objects set.
fn fixed(setup: &Setup, index: usize, typed: &TypedGraph) -> HashSet<Target> {
    let mut fixed: HashSet<Target> = typed.keyed.iter().cloned().collect();
    for object in setup.objects.iter().filter(|object| object.looks.contains(&Some(index))) {
        let is_set = |name: &PortName| object.values.contains_key(name);
        fixed.extend(
            typed.exposed.iter().filter(|exposed| is_set(&exposed.name)).map(|e| e.target.clone()),
        );
    }
    fixed
}

/// The nodes that reach the output, in order.
fn reaching(typed: &TypedGraph) -> Vec<usize> {
    let mut reaches = vec![false; typed.nodes.len()];
    reaches[typed.root.0] = true;
    for &node in typed.order.iter().rev() {
        if !reaches[node] {
            continue;
        }
        for input in typed.nodes[node].inputs.iter().flatten() {
            if let TypedSource::Wire { node: from, .. } = &input.source {
                reaches[*from] = true;
            }
        }
    }
    (0..typed.nodes.len()).filter(|&node| reaches[node]).collect()
}

fn lights(
    setup: &Setup,
    look: &Look,
    typed: &TypedGraph,
    live: &[usize],
    fixed: &HashSet<Target>,
) -> Vec<(Knob, KnobSetting)> {
    let mut named: Vec<&LightId> = Vec::new();
    for id in live.iter().filter_map(|&node| typed.nodes[node].light.as_ref()) {
        if !named.contains(&id) {
            named.push(id);
        }
    }
    let free = |id: &&LightId| {
        let target = Target::Light { light: (*id).clone(), field: "direction".to_owned() };
        !setup.scene.lights.contains_key(*id) && !fixed.contains(&target)
    };
    let knob = |id: &LightId| {
        let light = look.lights.get(id).filter(|light| light.kind == LightKind::Directional)?;
        let direction = glam::DVec3::from(light.direction).try_normalize()?;
        Some((Knob::Direction(id.clone()), KnobSetting::Direction(direction)))
    };
    named.into_iter().filter(free).filter_map(knob).collect()
}

/// The profile that a parameter is an end of, if all of its ends are parameters.
fn profile(param: &Param, params: &[Param]) -> Option<(Knob, KnobSetting)> {
    let end = |name: &str| {
        let it =
            params.iter().find(|other| other.path == param.path && other.port.as_str() == name)?;
        match it.value {
            Some(Value::Number(x)) => Some(x),
            _ => None,
        }
    };
    let shape = ProfileShape::new([end(ENDS[0])?, end(ENDS[1])?, end(ENDS[2])?]);
    Some((Knob::Profile(param.path.clone()), KnobSetting::Profile(shape)))
}

/// The color knobs of a ramp.
fn stops(param: &Param, ramp: &Ramp) -> Vec<(Knob, KnobSetting)> {
    let stop = |(index, color): (usize, &Vec<f64>)| {
        let &[r, g, b, ..] = color.as_slice() else { return None };
        let knob = Knob::Stop {
            node: param.path.clone(),
            port: param.port.clone(),
            index,
            ramp: ramp.clone(),
        };
        Some((knob, KnobSetting::Color([r, g, b].map(|x| x.clamp(0.0, 1.0)))))
    };
    ramp.stops.iter().map(|stop| &stop.color).enumerate().filter_map(stop).collect()
}

fn color(param: &Param, input: &TypedInput, look: &Look) -> Option<(Knob, KnobSetting)> {
    if !matches!(input.ty, Type::Color | Type::Composite) {
        return None;
    }
    let [r, g, b, alpha] = param.value.as_ref()?.color_in(look.color_space)?;
    let knob = Knob::Color { node: param.path.clone(), port: param.port.clone(), alpha };
    Some((knob, KnobSetting::Color([r, g, b].map(|x| x.clamp(0.0, 1.0)))))
}
