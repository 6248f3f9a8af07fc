//! Choice of the tiers of nodes that name none: the cheapest whose difference nobody can see.
//!
//! Every node starts in the tier that its own stated error allows. A small error may still grow on
//! its way to the picture, as in noise that multiplies a sine by thousands. So the graph is run,
//! node by node in f64, for a few points of a surface, once as it is and a few times with an error
//! as large as stated at each node; where the color at the end differs by more than the look
//! allows, the nodes whose errors grow are found by halving, and become exact.
//!
//! The points and the errors are the same in every run, and no scene is asked, so that the window,
//! a render and an export make the same choice. `chiaro tune` measures on a mesh instead.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::check::{TypedGraph, TypedInput, TypedNode, TypedSource};
use super::flatten::{ParamId, TierReason};
use super::host::conversion_program;
use super::intervals;
use super::value::typed_value;
use crate::document::{ColorSpace, Look, MAX_ERROR, Target, Tier, TimeKey, Value, linear_to_srgb};
use crate::ids::{LightId, NodePath, PortName};
use crate::interp::{self, Bindings, BoundProgram, LANES, Lanes, Precision, Program};
use crate::library::{
    ArgumentSource, Context, ContextBounds, ContextSample, Conversion, NodeModule, SurfacePoint,
    Treatment, Type,
};

/// Number of points that a look is run at, in each round.
const POINTS: usize = 16;

/// Number of lanes at each point: one without errors, the others with errors of their own.
const TRIALS: usize = LANES / POINTS;

/// Rounds of a look that allows more than a step of a screen: errors as large move edges, which few
/// points meet.
const ROUNDS: u64 = 8;

/// Side of a picture, in pixels.
const PICTURE_SIDE: f64 = 1600.0;

/// Most nodes that are run in the search, each time that one is counted.
const MAX_WORK: usize = 200_000;

/// Most runs of a look in the search for nodes whose errors grow; beyond these all are exact.
const MAX_RUNS: usize = 40;

/// Numbers of a value in all lanes: a row for each scalar.
type Rows = Vec<[f64; LANES]>;

/// The nodes, among those of `graph` that name no tier, whose stated error would be seen: they are
/// to be exact.
pub(super) fn seen(graph: &TypedGraph, look: &Look) -> HashSet<NodePath> {
    let roots = Roots::of(graph);
    let order = roots.order(graph);
    let candidates: Vec<(usize, f64)> = order
        .iter()
        .map(|&index| (index, stated_error(&graph.nodes[index])))
        .filter(|(_, error)| *error > 0.0)
        .collect();
    if candidates.is_empty() {
        return HashSet::new();
    }
    let steps = Steps::of(graph, order);
    let bound = steps.bound();
    let spread = spread(graph, look);
    let mut trial = ErrorTrial::new((graph, &roots, &spread), &steps, &bound, look.max_error);
    let seen = trial.search(&candidates);
    seen.into_iter().map(|index| graph.nodes[index].path.clone()).collect()
}

/// Ends that a picture depends on: everything that the Output takes, whatever else is shown, and
/// what drives keys.
struct Roots {
    /// Inputs of the Output, by its index, or the output that is shown where there is none.
    output: Result<usize, (usize, usize)>,
    drivers: Vec<(usize, usize)>,
}

impl Roots {
    fn of(graph: &TypedGraph) -> Self {
        let is_output = |index: &&usize| {
            let node = &graph.nodes[**index];
            node.def.special == Treatment::Output && !node.inputs.is_empty()
        };
        let drivers = graph.drivers.iter().map(|driver| (driver.node, driver.output)).collect();
        Self { output: graph.order.iter().find(is_output).copied().ok_or(graph.root), drivers }
    }

    /// Nodes that the roots depend on, each after all that it depends on.
    fn order(&self, graph: &TypedGraph) -> Vec<usize> {
        let mut is_reached = vec![false; graph.nodes.len()];
        let mut open = vec![self.output.unwrap_or_else(|(node, _)| node)];
        open.extend(self.drivers.iter().map(|(node, _)| *node));
        while let Some(index) = open.pop() {
            if !std::mem::replace(&mut is_reached[index], true) {
                open.extend(sources(&graph.nodes[index]));
            }
        }
        graph.order.iter().copied().filter(|&index| is_reached[index]).collect()
    }
}

/// Values between which parameters move: those of keys, and of what scenes and hosts may set half
/// and twice the document's.
fn spread(graph: &TypedGraph, look: &Look) -> HashMap<ParamId, Vec<Value>> {
    let mut spread: HashMap<ParamId, Vec<Value>> = HashMap::new();
    if look.exposed.is_empty() && look.time_keys.is_empty() && look.direction_keys.is_empty() {
        return spread;
    }
    let params = graph.params.iter().enumerate();
    let by_place: HashMap<(&NodePath, &PortName), ParamId> =
        params.map(|(id, param)| ((&param.path, &param.port), id)).collect();
    let mut add = |target: &Target, values: &mut dyn FnMut(&Value) -> Vec<Value>| {
        if let Target::Input { node, port } = target
            && let Some(&id) = by_place.get(&(node, port))
            && let Some(own) = &graph.params[id].value
        {
            spread.entry(id).or_insert_with(|| vec![own.clone()]).extend(values(own));
        }
    };
    for exposed in &look.exposed {
        add(&exposed.target, &mut |own| match own {
            Value::Number(x) => vec![Value::Number(0.5 * x), Value::Number(2.0 * x)],
            _ => Vec::new(),
        });
    }
    for track in &look.time_keys {
        add(&track.target, &mut |_| track.keys.iter().flat_map(reached).collect());
    }
    for key in look.direction_keys.iter().flat_map(|set| &set.keys) {
        for (target, value) in &key.values {
            add(target, &mut |_| vec![value.clone()]);
        }
    }
    spread
}

/// Values of a key and of the ends of its handles, between which the curve stays.
fn reached(key: &TimeKey) -> Vec<Value> {
    let mut values = vec![key.value.clone()];
    if let Value::Number(own) = key.value {
        let handles = key.incoming.iter().chain(&key.outgoing);
        values.extend(handles.map(|[_, value]| Value::Number(own + value)));
    }
    values
}

/// Greatest difference from the exact tier that is stated of a node in the tier that it has, or of
/// a function that it calls; 0 for a node that names its tier itself.
fn stated_error(node: &TypedNode) -> f64 {
    if node.tier_reason == TierReason::Named {
        return 0.0;
    }
    let own = node.def.error_of(node.tier).map_or(0.0, |error| error.bound);
    match node.tier {
        Tier::Exact => 0.0,
        _ => own.max(node.def.module.form_error(&node.variant().function)),
    }
}

/// True if two numbers are no farther apart than `most`, or neither is a number.
fn is_near(a: f64, b: f64, most: f64) -> bool {
    (a - b).abs() <= most || (a.is_nan() && b.is_nan())
}

/// Nodes that a node reads, once for each wire.
fn sources(node: &TypedNode) -> impl Iterator<Item = usize> + '_ {
    node.inputs.iter().flatten().filter_map(|input| match &input.source {
        TypedSource::Wire { node, .. } => Some(*node),
        _ => None,
    })
}

/// Nodes to run, with the programs of their functions and conversions, each once.
struct Steps {
    order: Vec<usize>,
    /// Number of wires that read each node, and one for the root's.
    readers: Vec<usize>,
    programs: Vec<Arc<Program>>,
    by_function: HashMap<(usize, Arc<str>), usize>,
    by_conversion: HashMap<(Type, Type), usize>,
}

impl Steps {
    fn of(graph: &TypedGraph, order: Vec<usize>) -> Self {
        let mut readers = vec![0; graph.nodes.len()];
        for source in order.iter().flat_map(|&index| sources(&graph.nodes[index])) {
            readers[source] += 1;
        }
        // Results that are compared at the end stay.
        let drivers = graph.drivers.iter().map(|driver| driver.node);
        for kept in drivers.chain([graph.root.0]) {
            readers[kept] += 1;
        }
        let mut steps = Self {
            order,
            readers,
            programs: Vec::new(),
            by_function: HashMap::new(),
            by_conversion: HashMap::new(),
        };
        for index in steps.order.clone() {
            let node = &graph.nodes[index];
            steps.add_function(&node.def.module, &node.variant().function);
            if let Some(prepare) = &node.def.prepare {
                steps.add_function(&node.def.module, &prepare.function);
            }
            for input in node.inputs.iter().flatten() {
                if let (Conversion::Template(_), Some(from)) =
                    (&input.conversion, source_type(graph, &input.source))
                    && let Some(program) = conversion_program(&from, &input.ty)
                {
                    let next = steps.programs.len();
                    steps.by_conversion.entry((from, input.ty.clone())).or_insert_with(|| {
                        steps.programs.push(program);
                        next
                    });
                }
            }
        }
        steps
    }

    fn add_function(&mut self, module: &Arc<NodeModule>, function: &str) {
        let key = (Arc::as_ptr(module) as usize, Arc::from(function));
        let next = self.programs.len();
        if let (std::collections::hash_map::Entry::Vacant(entry), Ok(program)) =
            (self.by_function.entry(key), module.program(function))
        {
            self.programs.push(program);
            entry.insert(next);
        }
    }

    /// The programs, ready for lanes; `None` for what reads images.
    fn bound(&self) -> Vec<Option<BoundProgram<'_>>> {
        let bindings = Bindings::new();
        self.programs.iter().map(|p| p.bind(&bindings, Precision::F64).ok()).collect()
    }
}

/// Rows of a value of the document.
fn rows_of_value(value: &Value, ty: &Type) -> Rows {
    rows_of(&typed_value(value, ty).unwrap_or(interp::Value::Float(0.0)))
}

fn source_type(graph: &TypedGraph, source: &TypedSource) -> Option<Type> {
    match source {
        TypedSource::Wire { node, output } => Some(graph.nodes[*node].output_type(*output)),
        TypedSource::Context(context) => Some(Type::from_wgsl(context.wgsl_type())),
        TypedSource::Param(..) | TypedSource::Fixed(_) => None,
    }
}

/// A graph that can be run with errors at some of its nodes.
struct ErrorTrial<'g> {
    graph: &'g TypedGraph,
    roots: &'g Roots,
    spread: &'g HashMap<ParamId, Vec<Value>>,
    steps: &'g Steps,
    lanes: Vec<Option<Lanes<'g>>>,
    contexts: HashMap<(Context, Option<LightId>, u64), Rows>,
    max_error: f64,
    most_runs: usize,
    runs: usize,
    round: u64,
}

impl<'g> ErrorTrial<'g> {
    fn new(
        (graph, roots, spread): (&'g TypedGraph, &'g Roots, &'g HashMap<ParamId, Vec<Value>>),
        steps: &'g Steps,
        bound: &'g [Option<BoundProgram<'g>>],
        max_error: f64,
    ) -> Self {
        let lanes = bound.iter().map(|bound| bound.as_ref()?.lanes().ok()).collect();
        // A long look is run less often.
        let most_runs = (MAX_WORK / steps.order.len().max(1)).clamp(3, MAX_RUNS);
        let contexts = HashMap::new();
        Self {
            graph,
            roots,
            spread,
            steps,
            lanes,
            contexts,
            max_error,
            most_runs,
            runs: 0,
            round: 0,
        }
    }

    /// Nodes among the candidates without whose errors nothing is seen.
    fn search(&mut self, candidates: &[(usize, f64)]) -> Vec<usize> {
        if self.is_unseen(candidates, self.max_error) {
            return Vec::new();
        }
        let all = || candidates.iter().map(|(index, _)| *index).collect();
        let mut seen = self.halves(candidates);
        let mut rest: Vec<(usize, f64)> =
            candidates.iter().filter(|(index, _)| !seen.contains(index)).copied().collect();
        // Errors that are unseen alone may be seen together.
        while self.runs < self.most_runs {
            if self.is_unseen(&rest, self.max_error) {
                return seen;
            }
            seen.extend(rest.drain(..rest.len().div_ceil(2)).map(|(index, _)| index));
        }
        all()
    }

    fn halves(&mut self, candidates: &[(usize, f64)]) -> Vec<usize> {
        // The other half adds its errors.
        if self.runs >= self.most_runs || self.is_unseen(candidates, 0.5 * self.max_error) {
            return Vec::new();
        }
        if let [(one, _)] = candidates {
            return vec![*one];
        }
        let (first, second) = candidates.split_at(candidates.len() / 2);
        let mut seen = self.halves(first);
        seen.extend(self.halves(second));
        seen
    }

    /// True if errors at these nodes change the picture by no more than `most` at any point.
    fn is_unseen(&mut self, erring: &[(usize, f64)], most: f64) -> bool {
        self.runs += 1;
        let erring: HashMap<usize, f64> = erring.iter().copied().collect();
        let rounds = if self.max_error > MAX_ERROR { ROUNDS } else { 1 };
        (0..rounds).all(|round| {
            self.round = round;
            self.run(&erring).iter().all(|(row, is_color)| {
                let shown = |lane: usize| if *is_color { self.shown(row[lane]) } else { row[lane] };
                (0..LANES).all(|lane| is_near(shown(lane), shown(lane - lane % TRIALS), most))
            })
        })
    }

    /// A number of a color as a screen shows it.
    fn shown(&self, x: f64) -> f64 {
        let x = x.clamp(0.0, 1.0);
        match self.graph.color_space {
            ColorSpace::Display => x,
            ColorSpace::Linear => linear_to_srgb(x),
        }
    }

    /// Numbers of the roots in all lanes, each with whether it is a part of a color.
    fn run(&mut self, erring: &HashMap<usize, f64>) -> Vec<([f64; LANES], bool)> {
        let graph = self.graph;
        let mut results: Vec<Rows> = vec![Rows::new(); graph.nodes.len()];
        let mut left = self.steps.readers.clone();
        let mut root: Vec<([f64; LANES], bool)> = Vec::new();
        for &index in &self.steps.order {
            let node = &graph.nodes[index];
            if self.roots.output == Ok(index) {
                for input in node.inputs.iter().flatten() {
                    let is_color = matches!(input.ty, Type::Color | Type::Composite);
                    let rows = self.input(node, input, &results);
                    root.extend(rows.into_iter().map(|row| (row, is_color)));
                }
                continue;
            }
            let mut rows = self.node(node, &results);
            if let Some(&error) = erring.get(&index) {
                let mut random = Random(index as u64 ^ self.round << 32);
                add_errors(&mut rows, &numbers_of(node), error, &mut random);
            }
            results[index] = rows;
            for source in sources(node) {
                left[source] -= 1;
                if left[source] == 0 {
                    results[source] = Rows::new();
                }
            }
        }
        let outputs = self.roots.output.err().into_iter().map(|output| (output, true));
        let drivers = self.roots.drivers.iter().map(|output| (*output, false));
        for ((node, output), is_color) in outputs.chain(drivers) {
            let rows = output_rows(graph, &results, node, output);
            root.extend(rows.into_iter().map(|row| (row, is_color)));
        }
        root
    }

    fn node(&mut self, node: &TypedNode, results: &[Rows]) -> Rows {
        let inputs: Vec<Option<Rows>> = node
            .inputs
            .iter()
            .map(|input| Some(self.input(node, input.as_ref()?, results)))
            .collect();
        let given = |input: usize| inputs.get(input).cloned().flatten().unwrap_or_default();
        let variant = node.variant();
        let mut arguments = Rows::new();
        for parameter in &variant.parameters {
            match parameter {
                ArgumentSource::Input(input, _) => arguments.extend(given(*input)),
                ArgumentSource::Sampler(_) => {}
                ArgumentSource::Choice(input) => {
                    arguments.push([f64::from(node.position(*input)); LANES]);
                }
                ArgumentSource::Prepared => {
                    let Some(prepare) = &node.def.prepare else { continue };
                    let of_prepare: Rows =
                        prepare.parameters.iter().flat_map(|(input, _)| given(*input)).collect();
                    arguments.extend(self.call(node, &prepare.function, &of_prepare, None));
                }
            }
        }
        let outputs = node.def.outputs.iter().map(|output| &output.ty);
        let count = if variant.result_is_struct {
            outputs.map(|ty| intervals::scalars_in(ty).unwrap_or(1)).sum()
        } else {
            intervals::scalars_in(&variant.result).unwrap_or(1)
        };
        self.call(node, &variant.function, &arguments, Some(count))
    }

    /// Rows of a function's result. What cannot be run, because it reads an image, is taken for an
    /// image of strong contrasts.
    fn call(
        &mut self,
        node: &TypedNode,
        function: &str,
        arguments: &[[f64; LANES]],
        count: Option<usize>,
    ) -> Rows {
        let key = (Arc::as_ptr(&node.def.module) as usize, Arc::from(function));
        let program = self.steps.by_function.get(&key).copied();
        let result = program.and_then(|program| self.program(program, arguments));
        match (result, count) {
            (Some(rows), None) => rows,
            (Some(rows), Some(count)) if rows.len() == count => rows,
            (_, count) => contrasts(arguments, count.unwrap_or(1)),
        }
    }

    fn input(&mut self, node: &TypedNode, input: &TypedInput, results: &[Rows]) -> Rows {
        let rows = match &input.source {
            TypedSource::Wire { node, output } => output_rows(self.graph, results, *node, *output),
            TypedSource::Param(..) if input.ty.is_texture() => return Rows::new(),
            TypedSource::Fixed(value) => return rows_of_value(value, &input.ty),
            TypedSource::Param(id, value) => {
                let rows = |value: &Value| rows_of_value(value, &input.ty);
                return match self.spread.get(id) {
                    None => rows(value),
                    Some(values) => {
                        let ends: Vec<Rows> = values.iter().map(rows).collect();
                        between(&ends, *id as u64 ^ self.round << 32)
                    }
                };
            }
            TypedSource::Context(context) => {
                let light = context.light_input().and_then(|_| node.light.clone());
                let key = (*context, light, self.round);
                let seed = hash_of(context.word(), key.1.as_ref().map_or("", AsRef::as_ref));
                let rows = self.contexts.entry(key);
                rows.or_insert_with(|| context_rows(*context, seed, self.round)).clone()
            }
        };
        match (&input.conversion, source_type(self.graph, &input.source)) {
            (Conversion::Template(_), Some(from)) => {
                let program = self.steps.by_conversion.get(&(from, input.ty.clone())).copied();
                let converted = program.and_then(|program| self.program(program, &rows));
                converted.unwrap_or(rows)
            }
            _ => rows,
        }
    }

    /// Result of a program in all lanes; `None` where it takes or gives something else than plain
    /// numbers.
    fn program(&mut self, program: usize, arguments: &[[f64; LANES]]) -> Option<Rows> {
        let code = &self.steps.programs[program];
        let lanes = self.lanes[program].as_mut()?;
        let ports = || {
            let inputs = code.inputs().iter();
            inputs.flat_map(|port| (0..port.size).map(move |component| (port, component)))
        };
        if ports().count() != arguments.len() {
            return None;
        }
        ports().zip(arguments).for_each(|((port, part), row)| lanes.write(port, part, row));
        lanes.run(LANES).ok()?;
        let mut rows = Rows::new();
        for port in code.outputs() {
            for component in 0..port.size {
                let mut row = [0.0; LANES];
                lanes.read(port, component, &mut row);
                rows.push(row);
            }
        }
        Some(rows)
    }
}

/// The part of a node's result that is one of its outputs.
fn output_rows(graph: &TypedGraph, results: &[Rows], node: usize, output: usize) -> Rows {
    let typed = &graph.nodes[node];
    let rows = &results[node];
    if !typed.variant().result_is_struct {
        return rows.clone();
    }
    let width = |ty: &Type| intervals::scalars_in(ty).unwrap_or(1);
    let before = typed.def.outputs.iter().take(output).map(|port| width(&port.ty)).sum();
    let count = typed.def.outputs.get(output).map_or(1, |port| width(&port.ty));
    rows.iter().skip(before).take(count).copied().collect()
}

/// For each scalar of a node's result, true if it is a number that may be off: truth values and
/// integers are not.
fn numbers_of(node: &TypedNode) -> Vec<bool> {
    let variant = node.variant();
    let of = |ty: &Type| {
        let is_number = !matches!(ty, Type::Bool | Type::Int);
        vec![is_number; intervals::scalars_in(ty).unwrap_or(1)]
    };
    if variant.result_is_struct {
        node.def.outputs.iter().flat_map(|output| of(&output.ty)).collect()
    } else {
        of(&variant.result)
    }
}

/// Moves the numbers of all lanes but the first of each point by up to `error`, relative above 1.
fn add_errors(rows: &mut Rows, are_numbers: &[bool], error: f64, random: &mut Random) {
    for (row, _) in rows.iter_mut().zip(are_numbers).filter(|(_, is_number)| **is_number) {
        for (lane, x) in row.iter_mut().enumerate() {
            let share = 2.0 * random.unit() - 1.0;
            if lane % TRIALS != 0 {
                *x += error * share * x.abs().max(1.0);
            }
        }
    }
}

/// A value that moves between others: at each point a mix of two of them.
fn between(ends: &[Rows], seed: u64) -> Rows {
    let mut random = Random(seed);
    let choices: Vec<(usize, usize, f64)> = (0..POINTS)
        .map(|_| {
            let mut index = || (random.unit() * ends.len() as f64) as usize;
            let (one, other) = (index(), index());
            (one, other, random.unit())
        })
        .collect();
    let number = |part: usize, lane: usize| {
        let (one, other, share) = choices[lane / TRIALS];
        let at = |end: usize| ends[end].get(part).map_or(0.0, |row| row[lane]);
        at(one) + share * (at(other) - at(one))
    };
    let count = ends.first().map_or(0, Vec::len);
    (0..count).map(|part| std::array::from_fn(|lane| number(part, lane))).collect()
}

/// FNV-1a of two words.
fn hash_of(one: &str, other: &str) -> u64 {
    one.bytes().chain([0]).chain(other.bytes()).fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    })
}

/// Numbers as an image with strong contrasts gives them, from 0 to 1.
fn contrasts(arguments: &[[f64; LANES]], count: usize) -> Rows {
    const STEEPNESS: f64 = 100.0;
    let number = |lane: usize, part: usize| {
        let phases =
            arguments.iter().enumerate().map(|(i, row)| row[lane] * (1.0 + 0.37 * i as f64));
        (STEEPNESS * phases.sum::<f64>() + part as f64).sin().mul_add(0.5, 0.5)
    };
    (0..count).map(|part| std::array::from_fn(|lane| number(lane, part))).collect()
}

/// A value that is the same in all lanes.
fn rows_of(value: &interp::Value) -> Rows {
    fn push(value: &interp::Value, rows: &mut Rows) {
        match value {
            interp::Value::Vector(scalars) => {
                rows.extend(scalars.iter().map(|scalar| [scalar.as_f64(); LANES]));
            }
            interp::Value::Matrix { components, .. } => {
                rows.extend(components.iter().map(|&x| [x; LANES]));
            }
            interp::Value::Array(parts) | interp::Value::Struct(parts) => {
                parts.iter().for_each(|part| push(part, rows));
            }
            other => rows.extend(other.as_f64().map(|x| [x; LANES])),
        }
    }
    let mut rows = Rows::new();
    push(value, &mut rows);
    rows
}

/// A context at each point of a round; lights and what a scene decides, within their bounds.
fn context_rows(context: Context, seed: u64, round: u64) -> Rows {
    let row = context.row();
    let values: Vec<Rows> = (0..POINTS as u64)
        .map(|point| {
            let point = point + round * POINTS as u64;
            let mut random = Random(1 + point);
            let known = rows_of(&row.sample.value(context, &surface_point(&mut random), None));
            let count = intervals::scalars_in(&Type::from_wgsl(context.wgsl_type()));
            let count = count.unwrap_or(known.len());
            if known.len() == count && matches!(row.sample, ContextSample::Of { .. }) {
                return known;
            }
            let mut random = Random(seed.wrapping_add(point));
            let direction = random.direction();
            let number = |part: usize, random: &mut Random| match (row.sample, row.bounds) {
                // Places in a picture have no end.
                (ContextSample::Own { range: (low, high), .. }, _) => {
                    let low = low.unwrap_or(0.0);
                    let high = high.unwrap_or(low + PICTURE_SIDE);
                    low + (high - low) * random.unit()
                }
                (_, ContextBounds::Unit | ContextBounds::UnitOrShorter) if count == 3 => {
                    direction[part]
                }
                (_, ContextBounds::Intensity) => 1.0,
                (_, ContextBounds::Count) => (PICTURE_SIDE * random.unit()).floor(),
                _ => random.unit(),
            };
            (0..count).map(|part| [number(part, &mut random); LANES]).collect()
        })
        .collect();
    (0..values[0].len())
        .map(|part| std::array::from_fn(|lane| values[lane / TRIALS][part][lane]))
        .collect()
}

fn surface_point(random: &mut Random) -> SurfacePoint {
    let normal = DVec3::from_array(random.direction());
    let tangent = normal.any_orthonormal_vector();
    let view = DVec3::from_array(random.direction());
    SurfacePoint {
        normal,
        tangent,
        bitangent: normal.cross(tangent),
        // Seen from the front.
        view: if view.dot(normal) < 0.0 { -view } else { view },
        position: normal * (0.5 + random.unit()),
        uv: DVec2::new(random.unit(), random.unit()),
        vertex_color: [random.unit(), random.unit(), random.unit(), 1.0],
        kappa: 4.0 * random.unit() - 2.0,
        ..SurfacePoint::default()
    }
}

/// Pseudorandom numbers by SplitMix64 (Steele, Lea and Flood 2014), the same in every run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A direction, even on the sphere.
    fn direction(&mut self) -> [f64; 3] {
        let z = 2.0 * self.unit() - 1.0;
        let turn = std::f64::consts::TAU * self.unit();
        let radius = (1.0 - z * z).max(0.0).sqrt();
        [radius * turn.cos(), radius * turn.sin(), z]
    }
}
