//! Lights in a loop: the copies of a region that differ in nothing but what the host knows of their
//! lights become one body, which runs over an array in the uniform.
//!
//! Regions are unrolled when a look is flattened, and values that are equal are made once, so that
//! what does not depend on a light already stands outside. What is left of each copy is followed
//! from the nodes that join lights: where two copies do the same with the same values, with what
//! the lights before have left, or with values of the host, they can share a body. A run of such
//! copies, one after another, is a loop; copies in between stay as they are. So both ways compute
//! the same.

use std::collections::{BTreeMap, HashMap, HashSet};

use rustc_hash::FxHashMap;

use super::{
    Argument, ComputedValue, Operation, SpecializedGraph, ValueId, before, operands, reachable,
};
use crate::compile::check::TypedNode;
use crate::compile::flatten::RegionIndex;
use crate::compile::intervals;
use crate::compile::{LoopedLights, Loops, RegionCopy};
use crate::ids::{LightId, NodePath};
use crate::library::{Rate, Type};

/// From this many lights on, or from this many operations of all of them on, a loop is worth it.
///
/// Measured on software Vulkan (docs/performance.md, "Many lights"): up to there a loop takes up to
/// a quarter longer, and a driver compiles the code of each light in less than half a second;
/// beyond, a loop is as quick to draw or quicker, and several times quicker to compile.
const MANY_LIGHTS: usize = 32;
const MANY_OPERATIONS: u64 = 4_000;

/// Values that a node that joins lights takes and gives in one copy of its region.
#[derive(Clone, Debug)]
pub(super) struct JoinedCopy {
    pub(super) light: Option<LightId>,
    /// The values of the lights before, by output.
    pub(super) before: Vec<Option<ValueId>>,
    /// The values with this light, by output.
    pub(super) after: Vec<ValueId>,
}

/// The copies of each node that joins lights, by its region and path.
pub(super) type JoinedNodes = BTreeMap<(RegionIndex, NodePath), Vec<JoinedCopy>>;

/// A body that runs once for each light.
#[derive(Clone, Debug)]
pub(in crate::compile) struct LightLoop {
    /// The lights, a round each.
    pub(in crate::compile) lights: Vec<LightId>,
    /// The nodes that join what comes of them.
    pub(in crate::compile) paths: Vec<NodePath>,
    /// Operations of one round.
    pub(in crate::compile) operations: u64,
    /// Values that differ from light to light: by field, one of the host for each round.
    pub(in crate::compile) fields: Vec<Vec<ValueId>>,
    /// Values that are made once for all lights.
    pub(in crate::compile) shared: Vec<ValueId>,
    /// Variables that the rounds change.
    pub(in crate::compile) variables: Vec<LoopVariable>,
}

impl LightLoop {
    fn is_worth_it(&self) -> bool {
        let rounds = self.lights.len();
        rounds >= MANY_LIGHTS || self.operations * rounds as u64 >= MANY_OPERATIONS
    }

    pub(in crate::compile) fn into_looped(self) -> LoopedLights {
        LoopedLights { lights: self.lights, nodes: self.paths, operations: self.operations }
    }
}

/// A variable that keeps what the lights so far have left.
#[derive(Clone, Debug)]
pub(in crate::compile) struct LoopVariable {
    /// The value before the first round.
    pub(in crate::compile) first: ValueId,
    /// The variable where the body reads it.
    pub(in crate::compile) before: ValueId,
    /// The value that a round gives it.
    pub(in crate::compile) after: ValueId,
}

/// Joining nodes that run over the same lights, none of which needs another's result.
struct Chains {
    lights: Vec<Option<LightId>>,
    paths: Vec<NodePath>,
    /// Copies by joining node.
    chains: Vec<Vec<JoinedCopy>>,
}

impl SpecializedGraph {
    /// Makes loops of the copies of regions where that is worth it.
    pub(super) fn with_loops(mut self, joined: JoinedNodes, choice: Loops) -> Self {
        if choice == Loops::Never {
            return self;
        }
        let roots = self.roots();
        let reached = reachable(&self.values, roots.iter().copied());
        let is_reached = |copies: &Vec<JoinedCopy>| {
            copies.last().is_some_and(|last| last.after.iter().any(|&id| reached[id]))
        };
        let joined = joined.into_iter().filter(|(_, copies)| is_reached(copies)).collect();
        for mut chains in self.fused(joined) {
            chains.keep_used(&reached);
            let count = chains.lights.len();
            let mut start = 0;
            while start < count {
                if !self.is_drawn(&chains, start) {
                    start += 1;
                    continue;
                }
                let is_same = |copy: &usize| {
                    self.is_drawn(&chains, *copy) && self.copies_match(&chains, start, *copy)
                };
                let last = (start + 1..count).take_while(is_same).last().unwrap_or(start);
                let copies = start..last + 1;
                start = copies.end;
                if copies.len() < 2 {
                    continue;
                }
                let Some(made) = LoopBuilder::new(&self, &chains, copies.clone()).build() else {
                    continue;
                };
                if choice == Loops::Always || made.light_loop.is_worth_it() {
                    self.replace(made);
                }
            }
        }
        self
    }

    /// The values that the look's module shows, and those that drive keys.
    fn roots(&self) -> Vec<ValueId> {
        self.shown().chain(self.drivers.iter().copied()).collect()
    }

    /// Joining nodes gathered so that one loop may serve several.
    fn fused(&self, joined: JoinedNodes) -> Vec<Chains> {
        // Operands are made before whoever reads them.
        let mut order: Vec<((RegionIndex, NodePath), Vec<JoinedCopy>)> =
            joined.into_iter().collect();
        order.sort_by_key(|(_, copies)| copies.last().map(|last| last.after.clone()));
        let mut groups: Vec<Chains> = Vec::new();
        // The groups whose results a group needs, however far away.
        let mut needs: Vec<HashSet<usize>> = Vec::new();
        for ((_, path), copies) in order {
            let lights: Vec<Option<LightId>> =
                copies.iter().map(|copy| copy.light.clone()).collect();
            let ends = copies.last().into_iter().flat_map(|last| last.after.iter().copied());
            let reached = reachable(&self.values, ends);
            let mut needed: HashSet<usize> = HashSet::new();
            for (index, group) in groups.iter().enumerate() {
                if group.results().any(|id| reached[id]) {
                    needed.insert(index);
                    needed.extend(&needs[index]);
                }
            }
            let fitting = (0..groups.len()).find(|index| {
                groups[*index].lights == lights && !needed.contains(index) && {
                    // No circle: what this node needs may not need the group.
                    needed.iter().all(|other| !needs[*other].contains(index))
                }
            });
            match fitting {
                Some(index) => {
                    groups[index].paths.push(path);
                    groups[index].chains.push(copies);
                    // Who needs the group needs all that it needs.
                    let dependents: Vec<usize> = (0..groups.len())
                        .filter(|&other| other == index || needs[other].contains(&index))
                        .collect();
                    for other in dependents {
                        needs[other].extend(&needed);
                    }
                }
                None => {
                    groups.push(Chains { lights, paths: vec![path], chains: vec![copies] });
                    needs.push(needed);
                }
            }
        }
        groups
    }

    /// True if fragments compute what a copy gives: not the host, which knows lights from one
    /// direction alone, and not a copy before, whose light is the last that adds anything.
    fn is_drawn(&self, chains: &Chains, copy: usize) -> bool {
        let copies = chains.chains.iter().map(|chain| &chain[copy]);
        let mut values = copies.flat_map(|copy| copy.before.iter().zip(&copy.after));
        values.all(|(before, after)| {
            self.values[*after].rate > Rate::Object && *before != Some(*after)
        })
    }

    /// True if a copy does what another does, but for values of the host.
    fn copies_match(&self, chains: &Chains, first: usize, other: usize) -> bool {
        let mut known: HashSet<(ValueId, ValueId)> = HashSet::new();
        let mut open: Vec<(ValueId, ValueId)> = Vec::new();
        for chain in &chains.chains {
            let pairs = chain[first].after.iter().zip(&chain[other].after);
            open.extend(pairs.map(|(a, b)| (*a, *b)));
        }
        while let Some((a, b)) = open.pop() {
            let is_before = || chains.variable_of(&[(first, a), (other, b)]).is_some();
            if a == b || !known.insert((a, b)) || is_before() {
                continue;
            }
            match self.shared_operands(&[a, b]) {
                Some(SharedWork::Field) => {}
                Some(SharedWork::Operands(operands)) => {
                    open.extend(operands.iter().map(|pair| (pair[0], pair[1])));
                }
                None => return false,
            }
        }
        true
    }

    /// The work that values share, if they differ in operands or values of the host alone.
    fn shared_operands(&self, ids: &[ValueId]) -> Option<SharedWork> {
        let first = &self.values[ids[0]];
        let values = || ids.iter().map(|id| &self.values[*id]);
        if !values().all(|value| value.ty == first.ty) {
            return None;
        }
        if values().all(|value| value.rate <= Rate::Object) {
            return is_in_uniforms(&first.ty).then_some(SharedWork::Field);
        }
        if !values().all(|value| is_same_work(&value.operation, &first.operation)) {
            return None;
        }
        let mut each: Vec<_> = values().map(|value| operands(&value.operation)).collect();
        let mut shared = Vec::new();
        while let Some(operand) = each[0].next() {
            let others = each[1..].iter_mut().map(Iterator::next);
            let tuple: Option<Vec<ValueId>> =
                std::iter::once(Some(operand)).chain(others).collect();
            shared.push(tuple?);
        }
        Some(SharedWork::Operands(shared))
    }

    /// Puts a loop in the place of copies.
    fn replace(&mut self, made: MadeLoop) {
        let MadeLoop { body, light_loop, results } = made;
        let index = self.loops.len();
        self.values.extend(body);
        let mut arguments = Vec::new();
        for variable in &light_loop.variables {
            arguments.extend([variable.first, variable.after].map(Argument::Value));
        }
        let first = &self.values[results[0]];
        let (ty, node) = (first.ty.clone(), first.node);
        let id = self.values.len();
        self.values.push(ComputedValue {
            operation: Operation::Loop { index, arguments },
            ty,
            rate: Rate::Fragment,
            node,
            part: None,
            unit: false,
            ranges: None,
        });
        for (variable, result) in results.into_iter().enumerate() {
            self.values[result].operation = Operation::LoopResult { value: id, variable };
        }
        self.loops.push(light_loop);
    }
}

/// The way in which values of several copies are made in one body.
enum SharedWork {
    /// Each is a value of the host: a field of the array.
    Field,
    /// Each is the same work on these.
    Operands(Vec<Vec<ValueId>>),
}

/// True if a uniform may hold a value of a type.
fn is_in_uniforms(ty: &Type) -> bool {
    let is_number = !matches!(ty, Type::Text | Type::Choice | Type::LightName);
    is_number && !ty.is_texture() && !ty.is_scene_resource()
}

fn is_same_work(a: &Operation, b: &Operation) -> bool {
    match (a, b) {
        (
            Operation::Call { function: f, arguments: of_a },
            Operation::Call { function: g, arguments: of_b },
        ) => {
            let is_same = |(a, b): (&Argument, &Argument)| match (a, b) {
                (Argument::Value(_), Argument::Value(_)) => true,
                (a, b) => a == b,
            };
            std::sync::Arc::ptr_eq(&f.module, &g.module)
                && f.name == g.name
                && of_a.len() == of_b.len()
                && of_a.iter().zip(of_b).all(is_same)
        }
        (Operation::Member { index: a, .. }, Operation::Member { index: b, .. }) => a == b,
        (Operation::Convert { template: a, .. }, Operation::Convert { template: b, .. }) => a == b,
        _ => false,
    }
}

impl Chains {
    /// The values of the last copies.
    fn results(&self) -> impl Iterator<Item = ValueId> + '_ {
        self.chains.iter().filter_map(|chain| chain.last()).flat_map(|copy| &copy.after).copied()
    }

    /// Leaves out outputs that neither the look nor a later copy needs.
    fn keep_used(&mut self, reached: &[bool]) {
        for chain in &mut self.chains {
            let Some(last) = chain.last() else { continue };
            let is_kept = |output: usize| chain.iter().any(|copy| reached[copy.after[output]]);
            let kept: Vec<bool> = (0..last.after.len()).map(is_kept).collect();
            for copy in chain.iter_mut() {
                copy.before = chosen(&copy.before, &kept);
                copy.after = chosen(&copy.after, &kept);
            }
        }
    }

    /// The variable, by joining node and output, that values of copies read from those before them.
    fn variable_of(&self, values: &[(usize, ValueId)]) -> Option<(usize, usize)> {
        for (node, chain) in self.chains.iter().enumerate() {
            for output in 0..chain[0].after.len() {
                if values.iter().all(|(copy, id)| chain[*copy].before[output] == Some(*id)) {
                    return Some((node, output));
                }
            }
        }
        None
    }
}

/// A loop that is not yet part of the graph.
struct MadeLoop {
    /// Values that follow those of the graph.
    body: Vec<ComputedValue>,
    light_loop: LightLoop,
    /// Values of the last copy, which the variables hold in the end, by variable.
    results: Vec<ValueId>,
}

struct LoopBuilder<'a> {
    graph: &'a SpecializedGraph,
    chains: &'a Chains,
    copies: std::ops::Range<usize>,
    body: Vec<ComputedValue>,
    known: FxHashMap<Vec<ValueId>, ValueId>,
    light_loop: LightLoop,
    /// Variables by joining node and output.
    variables: HashMap<(usize, usize), ValueId>,
}

impl<'a> LoopBuilder<'a> {
    fn new(
        graph: &'a SpecializedGraph,
        chains: &'a Chains,
        copies: std::ops::Range<usize>,
    ) -> Self {
        let lights = chains.lights[copies.clone()].iter().flatten().cloned().collect();
        let light_loop = LightLoop {
            lights,
            paths: chains.paths.clone(),
            operations: 0,
            fields: Vec::new(),
            shared: Vec::new(),
            variables: Vec::new(),
        };
        Self {
            graph,
            chains,
            copies,
            body: Vec::new(),
            known: FxHashMap::default(),
            light_loop,
            variables: HashMap::new(),
        }
    }

    /// `None` where a copy differs after all.
    fn build(mut self) -> Option<MadeLoop> {
        let mut results = Vec::new();
        let first = self.copies.start;
        for (node, chain) in self.chains.chains.iter().enumerate() {
            for output in 0..chain[first].after.len() {
                let before: Option<Vec<ValueId>> =
                    self.copies.clone().map(|copy| chain[copy].before[output]).collect();
                let before = before?;
                let variable = Operation::LoopVariable { index: self.graph.loops.len() };
                let last = chain[self.copies.end - 1].after[output];
                let id = self.push(&before, variable, last);
                self.variables.insert((node, output), id);
                self.light_loop.variables.push(LoopVariable {
                    first: before[0],
                    before: id,
                    after: id,
                });
                results.push(last);
            }
        }
        let mut at = 0;
        for chain in &self.chains.chains {
            for output in 0..chain[first].after.len() {
                let after: Vec<ValueId> =
                    self.copies.clone().map(|copy| chain[copy].after[output]).collect();
                self.light_loop.variables[at].after = self.value(&after)?;
                at += 1;
            }
        }
        let Self { body, mut light_loop, .. } = self;
        light_loop.operations = body.iter().map(operations_of).sum();
        Some(MadeLoop { body, light_loop, results })
    }

    /// The value in the body that stands for one of each copy; operands first, with a stack of its
    /// own.
    fn value(&mut self, tuple: &[ValueId]) -> Option<ValueId> {
        let mut stack = vec![(tuple.to_vec(), false)];
        while let Some((tuple, is_leaving)) = stack.pop() {
            if self.known.contains_key(&tuple) {
                continue;
            }
            if tuple.iter().all(|id| *id == tuple[0]) {
                self.light_loop.shared.push(tuple[0]);
                self.known.insert(tuple.clone(), tuple[0]);
                continue;
            }
            let by_copy: Vec<(usize, ValueId)> =
                self.copies.clone().zip(tuple.iter().copied()).collect();
            if let Some(place) = self.chains.variable_of(&by_copy) {
                self.known.insert(tuple, self.variables[&place]);
                continue;
            }
            match self.graph.shared_operands(&tuple)? {
                SharedWork::Field => {
                    let operation = Operation::LoopField {
                        index: self.graph.loops.len(),
                        field: self.light_loop.fields.len(),
                    };
                    let id = self.push(&tuple, operation, tuple[0]);
                    self.light_loop.fields.push(tuple.clone());
                    self.known.insert(tuple, id);
                }
                SharedWork::Operands(operands) if is_leaving => {
                    let mut found = operands.iter().map(|tuple| self.known.get(tuple).copied());
                    let operation = self.graph.values[tuple[0]].operation.clone();
                    let operation = with_operands(operation, &mut || found.next().flatten())?;
                    let id = self.push(&tuple, operation, tuple[0]);
                    self.known.insert(tuple, id);
                }
                SharedWork::Operands(operands) => {
                    stack.push((tuple, true));
                    stack.extend(operands.into_iter().map(|operand| (operand, false)));
                }
            }
        }
        self.known.get(tuple).copied()
    }

    /// Adds a value to the body that stands for those of a tuple, with the name of `named`.
    fn push(&mut self, tuple: &[ValueId], operation: Operation, named: ValueId) -> ValueId {
        let values = || tuple.iter().map(|id| &self.graph.values[*id]);
        let ranges = values()
            .map(ComputedValue::ranges_in_fragments)
            .reduce(|a, b| intervals::join(&a?, &b?))
            .flatten();
        let named = &self.graph.values[named];
        let value = ComputedValue {
            operation,
            ty: named.ty.clone(),
            rate: Rate::Fragment,
            node: named.node,
            part: named.part.clone(),
            unit: values().all(|value| value.unit),
            ranges,
        };
        self.body.push(value);
        self.graph.values.len() + self.body.len() - 1
    }
}

fn operations_of(value: &ComputedValue) -> u64 {
    match &value.operation {
        Operation::Call { function, .. } => function.module.operations(&function.name),
        _ => 0,
    }
}

/// An operation on other operands, in the order of [`operands`].
fn with_operands(
    operation: Operation,
    next: &mut dyn FnMut() -> Option<ValueId>,
) -> Option<Operation> {
    Some(match operation {
        Operation::Call { function, arguments } => {
            let argument = |argument: Argument| match argument {
                Argument::Value(_) => next().map(Argument::Value),
                other => Some(other),
            };
            let arguments = arguments.into_iter().map(argument).collect::<Option<_>>()?;
            Operation::Call { function, arguments }
        }
        Operation::Member { index, name, .. } => Operation::Member { value: next()?, index, name },
        Operation::Convert { template, .. } => Operation::Convert { template, value: next()? },
        other => other,
    })
}

/// Items that are chosen.
fn chosen<T: Clone>(items: &[T], is_chosen: &[bool]) -> Vec<T> {
    let pairs = items.iter().zip(is_chosen);
    pairs.filter(|(_, is_chosen)| **is_chosen).map(|(item, _)| item.clone()).collect()
}

/// Values that a node takes and gives in its copy, if it joins lights.
pub(super) fn joined_copy(
    node: &TypedNode,
    inputs: &[Option<ValueId>],
    outputs: &[ValueId],
) -> Option<(RegionCopy, JoinedCopy)> {
    let copy = node.copy.filter(|_| node.def.joins_lights())?;
    let before = node.def.outputs.iter().map(|output| before(node, output, inputs)).collect();
    Some((copy, JoinedCopy { light: node.light.clone(), before, after: outputs.to_vec() }))
}
