//! Wires that drive keys: the outputs that these wires come from, the check that each is one number
//! for an object, and the order in which the keys that they drive take effect.
//!
//! The value of a wire may itself depend on keys. Sets of keys therefore take effect one after the
//! other, each after the sets that move its driver; sets that drive one another have no such order
//! and are refused.

use std::collections::{HashMap, HashSet};

use chiaro_locale::tr;
use petgraph::graph::{DiGraph, NodeIndex};

use super::check::{TypedGraph, TypedInput, TypedNode, TypedSource};
use super::flatten::{FlatGraph, ParamId};
use crate::diag::Diagnostic;
use crate::document::{DirectionKeys, Look, OutputPort, Target};
use crate::ids::{LightId, NodePath, PortName};
use crate::library::{Conversion, Rate, Treatment, Type};

/// An output that drives keys.
#[derive(Clone, Debug)]
pub struct TypedDriver {
    /// Name in the document.
    pub wire: OutputPort,
    /// The node's index.
    pub node: usize,
    /// The output's index.
    pub output: usize,
    /// The conversion of the wire's value to a number.
    pub conversion: Conversion,
}

/// The outputs that drive keys of a look, each once, with what stands behind them; what names
/// nothing is a problem.
pub(super) fn find(
    look: &Look,
    flat: &FlatGraph,
    problems: &mut Vec<Diagnostic>,
) -> Vec<(OutputPort, usize, usize)> {
    let mut found: Vec<(OutputPort, usize, usize)> = Vec::new();
    for (set, keys) in look.direction_keys.iter().enumerate() {
        for wire in keys.by.outputs() {
            if found.iter().any(|(known, ..)| known == wire) {
                continue;
            }
            match flat.output(&wire.node, &wire.port) {
                Ok((node, output)) => found.push((wire.clone(), node, output)),
                Err(problem) => problems.push(problem.json_path(place(set))),
            }
        }
    }
    found
}

/// Types what drives keys: an output that is one number for the whole object.
pub(super) fn typed(
    graph: &TypedGraph,
    look: &Look,
    found: Vec<(OutputPort, usize, usize)>,
) -> (Vec<TypedDriver>, Vec<Diagnostic>) {
    if found.is_empty() {
        return (Vec::new(), Vec::new());
    }
    let rates = rates(graph);
    let mut problems = Vec::new();
    let mut drivers = Vec::new();
    for (wire, node, output) in found {
        let reads = |keys: &DirectionKeys| keys.by.outputs().any(|other| *other == wire);
        let set = look.direction_keys.iter().position(reads).unwrap_or_default();
        let told = |problem: Diagnostic| {
            problem.node(wire.node.clone()).port(wire.port.clone()).json_path(place(set))
        };
        if rates[node] > Rate::Object {
            let message =
                tr!("`{wire}` has another value at every fragment, so that it cannot drive keys");
            let hint = tr!("drive them by what is the same all over an object: values, the time, \
                        lights from one direction, \
                        and what is computed from these");
            problems.push(told(Diagnostic::error("fragment-driver", message).hint(hint)));
            continue;
        }
        let ty = graph.nodes[node].output_type(output);
        match ty.convert_to(&Type::Float) {
            Some(conversion) => drivers.push(TypedDriver { wire, node, output, conversion }),
            None => {
                let ty = ty.label();
                let message =
                    tr!("`{wire}` gives {ty}, which is no number, so that it cannot drive keys");
                problems.push(told(
                    Diagnostic::error("wrong-type", message)
                        .hint(tr!("wire it to a node that makes a number of it")),
                ));
            }
        }
    }
    (drivers, problems)
}

fn place(set: usize) -> String {
    format!("direction_keys[{set}].by")
}

/// Time at which the results of each node are known, while every value may be edited.
fn rates(graph: &TypedGraph) -> Vec<Rate> {
    // A node that was not typed gives nothing to anybody.
    let mut rates = vec![Rate::Fragment; graph.nodes.len()];
    for &index in &graph.order {
        rates[index] = rate(&graph.nodes[index], &rates);
    }
    rates
}

fn rate(node: &TypedNode, known: &[Rate]) -> Rate {
    let of_input = |input: &TypedInput| match &input.source {
        _ if input.ty.is_texture() => Rate::Fragment,
        TypedSource::Wire { node, .. } => known[*node],
        TypedSource::Fixed(_) => Rate::Constant,
        TypedSource::Param(..) => Rate::Object,
        TypedSource::Context(context) => context.rate(),
    };
    let rate = node.inputs.iter().flatten().map(of_input).max().unwrap_or(Rate::Constant);
    // A function that the interpreter cannot run is known in the fragment alone.
    let runs = || node.def.module.program(&node.variant().function).is_ok();
    if rate <= Rate::Object && !runs() { Rate::Fragment } else { rate }
}

impl TypedGraph {
    /// The outputs of the look's own nodes and groups that may drive keys of what `moved` names:
    /// what depends on that itself may not. In the order of the look's nodes, groups last. First
    /// those that may change while nobody edits the look: what depends on a context, on a light, or
    /// on what of `set` names, which is what keys and scenes set; then those that are always the
    /// same.
    pub fn drivable(&self, moved: &[Target], set: &[Target]) -> [Vec<OutputPort>; 2] {
        let changes = self.changing(set);
        let (changing, still): (Vec<_>, Vec<_>) =
            self.may_drive(moved).into_iter().partition(|(_, node)| changes[*node]);
        [changing, still].map(|outputs| outputs.into_iter().map(|(wire, _)| wire).collect())
    }

    /// The outputs that may drive keys, each with the node behind it.
    fn may_drive(&self, moved: &[Target]) -> Vec<(OutputPort, usize)> {
        let (rates, is_moved) = (rates(self), self.moved_by(moved));
        let drives = |index: usize, output: usize| {
            let node = &self.nodes[index];
            let is_number = || node.output_type(output).convert_to(&Type::Float).is_some();
            rates[index] <= Rate::Object
                && !is_moved[index]
                && node.def.special != Treatment::Output
                && is_number()
        };
        let mut found = Vec::new();
        for (index, node) in
            self.nodes.iter().enumerate().filter(|(_, node)| node.path.ids().len() == 1)
        {
            let outputs =
                node.def.outputs.iter().enumerate().filter(|(output, _)| drives(index, *output));
            let named =
                |port: &PortName| OutputPort { node: node.path.clone(), port: port.clone() };
            found.extend(outputs.map(|(_, port)| (named(&port.name), index)));
        }
        let mut of_groups: Vec<(OutputPort, usize)> = Vec::new();
        for (path, outputs) in self.group_outputs.iter().filter(|(path, _)| path.ids().len() == 1) {
            let named = outputs.iter().filter(|(port, _)| !port.as_str().is_empty());
            let outputs = named.filter(|(_, (node, output))| drives(*node, *output));
            let wire = |port: &PortName| OutputPort { node: path.clone(), port: port.clone() };
            of_groups.extend(outputs.map(|(port, (node, _))| (wire(port), *node)));
        }
        of_groups.sort();
        found.extend(of_groups);
        found
    }

    /// For each node, true if its outputs may change while nobody edits the look: by keys that move
    /// the targets of `set`, by a light, or by a context that is not constant.
    fn changing(&self, set: &[Target]) -> Vec<bool> {
        let mut found = self.moved_by(set);
        for &index in &self.order {
            let node = &self.nodes[index];
            let changes = |input: &TypedInput| match &input.source {
                TypedSource::Wire { node, .. } => found[*node],
                TypedSource::Param(..) | TypedSource::Fixed(_) => false,
                TypedSource::Context(context) => context.rate() > Rate::Constant,
            };
            let changes = node.light.is_some() || node.inputs.iter().flatten().any(changes);
            found[index] |= changes;
        }
        found
    }

    /// For each node, true if it depends on any of the targets `moved`.
    fn moved_by(&self, moved: &[Target]) -> Vec<bool> {
        let is_moved = |target: &Target| moved.contains(target);
        let lights: HashSet<&LightId> = moved
            .iter()
            .filter_map(
                |target| if let Target::Light { light, .. } = target { Some(light) } else { None },
            )
            .collect();
        let param = |id: ParamId| {
            let param = &self.params[id];
            is_moved(&Target::Input { node: param.path.clone(), port: param.port.clone() })
        };
        let mut found = vec![false; self.nodes.len()];
        for &index in &self.order {
            let node = &self.nodes[index];
            let reads = |input: &TypedInput| match &input.source {
                TypedSource::Wire { node, .. } => found[*node],
                TypedSource::Param(id, _) => !moved.is_empty() && param(*id),
                TypedSource::Context(_) | TypedSource::Fixed(_) => false,
            };
            let is_lit = node.light.as_ref().is_some_and(|light| lights.contains(light));
            found[index] = is_lit || node.inputs.iter().flatten().any(reads);
        }
        found
    }
}

/// The inputs that a driver's wire depends on.
#[derive(Default)]
struct DriverInputs {
    params: HashSet<ParamId>,
    lights: HashSet<LightId>,
}

fn reads(graph: &TypedGraph, root: usize) -> DriverInputs {
    let mut reads = DriverInputs::default();
    let (mut seen, mut open) = (HashSet::new(), vec![root]);
    while let Some(index) = open.pop() {
        if !seen.insert(index) {
            continue;
        }
        let node = &graph.nodes[index];
        reads.lights.extend(node.light.clone());
        for input in node.inputs.iter().flatten() {
            match &input.source {
                TypedSource::Wire { node, .. } => open.push(*node),
                TypedSource::Param(id, _) => drop(reads.params.insert(*id)),
                TypedSource::Context(_) | TypedSource::Fixed(_) => {}
            }
        }
    }
    reads
}

/// The sets of keys, each after those that move what drives it, else in the document's order; that
/// keys drive one another is a problem.
pub(super) fn order(graph: &TypedGraph, look: &Look) -> (Vec<usize>, Vec<Diagnostic>) {
    let sets = &look.direction_keys;
    if graph.drivers.is_empty() {
        return ((0..sets.len()).collect(), Vec::new());
    }
    let ids: HashMap<(&NodePath, &PortName), ParamId> = graph
        .params
        .iter()
        .enumerate()
        .map(|(id, param)| ((&param.path, &param.port), id))
        .collect();
    let targets: Vec<HashSet<&Target>> = sets
        .iter()
        .map(|keys| keys.keys.iter().flat_map(|key| key.values.keys()).collect())
        .collect();
    let moves = |set: usize, reads: &DriverInputs| {
        targets[set].iter().any(|target| match target {
            Target::Input { node, port } => {
                ids.get(&(node, port)).is_some_and(|id| reads.params.contains(id))
            }
            Target::Light { light, .. } => reads.lights.contains(light),
        })
    };
    let mut before = DiGraph::<(), ()>::new();
    for _ in sets {
        before.add_node(());
    }
    for (set, keys) in sets.iter().enumerate() {
        let mut all = DriverInputs::default();
        for driver in keys
            .by
            .outputs()
            .filter_map(|wire| graph.drivers.iter().find(|driver| driver.wire == *wire))
        {
            let DriverInputs { params, lights } = reads(graph, driver.node);
            all.params.extend(params);
            all.lights.extend(lights);
        }
        for other in 0..sets.len() {
            // A value that two sets move is moved last by the later one.
            let lies_under = other < set && !targets[other].is_disjoint(&targets[set]);
            if lies_under || moves(other, &all) {
                before.add_edge(NodeIndex::new(other), NodeIndex::new(set), ());
            }
        }
    }
    sorted(&before, sets)
}

/// The first that waits for none, again and again.
fn sorted(before: &DiGraph<(), ()>, sets: &[DirectionKeys]) -> (Vec<usize>, Vec<Diagnostic>) {
    let mut order: Vec<usize> = Vec::with_capacity(sets.len());
    let mut is_done = vec![false; sets.len()];
    let waits = |set: usize, is_done: &[bool]| {
        before
            .neighbors_directed(NodeIndex::new(set), petgraph::Incoming)
            .any(|other| !is_done[other.index()])
    };
    while let Some(set) = (0..sets.len()).find(|&set| !is_done[set] && !waits(set, &is_done)) {
        is_done[set] = true;
        order.push(set);
    }
    let is_ring = |ring: &Vec<NodeIndex>| ring.len() > 1 || before.contains_edge(ring[0], ring[0]);
    let rings = petgraph::algo::kosaraju_scc(before).into_iter().filter(is_ring);
    let problems = rings.map(|ring| {
        let mut ring: Vec<usize> = ring.into_iter().map(NodeIndex::index).collect();
        ring.sort_unstable();
        ring_problem(sets, &ring)
    });
    let problems = problems.collect();
    order.extend((0..sets.len()).filter(|&set| !is_done[set]));
    (order, problems)
}

fn ring_problem(sets: &[DirectionKeys], ring: &[usize]) -> Diagnostic {
    let named = |&set: &usize| match sets[set].name.as_str() {
        "" => tr!("set {number}", number = set + 1),
        name => format!("\"{name}\""),
    };
    let names: Vec<String> = ring.iter().map(named).collect();
    let driven = ring
        .iter()
        .copied()
        .find(|&set| sets[set].by.outputs().next().is_some())
        .unwrap_or(ring[0]);
    let wires: Vec<String> = sets[driven].by.outputs().map(|wire| format!("`{wire}`")).collect();
    let message = match names.as_slice() {
        [one] => tr!("the keys {one} move what drives them: {wires}", wires = wires.join(", ")),
        many => tr!("these keys drive one another in a ring: {wires}", wires = many.join(", ")),
    };
    let problem = Diagnostic::error("key-cycle", message).json_path(place(driven));
    let problem = match sets[driven].by.outputs().next() {
        Some(wire) => problem.node(wire.node.clone()).port(wire.port.clone()),
        None => problem,
    };
    problem.hint(tr!("let another wire drive them, or key what it does not depend on"))
}
