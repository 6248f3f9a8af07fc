//! Looks of foreign graphs: each node by its recipe, or as a note with a stand-in value.

use std::collections::{HashMap, HashSet};

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::foreign::{ForeignGraph, ForeignInput, ForeignNode, ForeignSource, shown};
use super::layout;
use super::recipe::Recipe;
use super::twins::{Twin, is_by_outputs, twin_of, twin_of_output};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{
    ColorSpace, Endpoint, ExposedValue, Frame, Light, Look, Node, Note, Target, Value, Wire,
};
use crate::ids::{FrameId, LightId, NodeId, NodePath, NoteId, PortName, make_slug};
use crate::library::{Library, Type};

/// Id of the light by which surfaces of the other program are lit.
const KEY: &str = "key";

/// Id of the look's output.
const OUTPUT: &str = "output";

/// Makes a look of a graph.
pub(super) fn look(
    graph: &ForeignGraph,
    twins: &'static [Twin],
    library: &Library,
) -> Result<WithWarnings<Look>, Box<Diagnostic>> {
    let mut builder = Builder {
        graph,
        twins,
        library,
        look: Look { name: graph.name.clone(), color_space: ColorSpace::Linear, ..Look::default() },
        problems: graph.problems.clone(),
        made: vec![None; graph.nodes.len()],
        shared: HashMap::new(),
        parameters: HashMap::new(),
        ids: HashSet::from([OUTPUT.to_owned()]),
        counters: HashMap::new(),
        heights: HashMap::new(),
    };
    for index in order(graph)? {
        builder.node(index);
    }
    builder.finish();
    Ok(WithWarnings::new(builder.look, builder.problems))
}

/// Nodes that lead to the result, each after those that it reads.
fn order(graph: &ForeignGraph) -> Result<Vec<usize>, Box<Diagnostic>> {
    let links = |node: &ForeignNode| {
        let link = |input: &ForeignInput| match input.source {
            ForeignSource::Link(index, _) => Some(index),
            _ => None,
        };
        node.inputs.iter().filter_map(link).collect::<Vec<usize>>()
    };
    let mut order = Vec::new();
    // 1 while a node's sources are visited, 2 after.
    let mut states = vec![0_u8; graph.nodes.len()];
    let ForeignSource::Link(result, _) = graph.result else { return Ok(order) };
    let mut path = vec![(result, links(&graph.nodes[result]))];
    states[result] = 1;
    while let Some((index, left)) = path.last_mut() {
        let index = *index;
        let Some(next) = left.pop() else {
            states[index] = 2;
            order.push(index);
            path.pop();
            continue;
        };
        match states[next] {
            0 => {
                states[next] = 1;
                path.push((next, links(&graph.nodes[next])));
            }
            1 => {
                let node = &graph.nodes[index];
                let other = &graph.nodes[next].name;
                let message =
                    tr!("`{name}` reads `{other}`, which reads it: a circle", name = node.name);
                let problem = Diagnostic::error("import-circle", message);
                let problem = problem.hint(tr!("unlink one of the two there, and export again"));
                return Err(Box::new(match node.place {
                    Some(place) => problem.at(place),
                    None => problem,
                }));
            }
            _ => {}
        }
    }
    Ok(order)
}

/// Source of a value in the look.
#[derive(Clone, Debug, PartialEq)]
enum Source {
    /// The port's own default.
    Default,
    /// A constant.
    Value(Value),
    /// An output.
    Port(Endpoint),
}

/// A foreign node that was made.
#[derive(Clone, Debug)]
struct MadeNode {
    /// Result of the recipe.
    result: Source,
    /// The node's row; `None` for a stand-in.
    twin: Option<&'static Twin>,
}

struct Builder<'a> {
    graph: &'a ForeignGraph,
    twins: &'static [Twin],
    library: &'a Library,
    look: Look,
    problems: Vec<Diagnostic>,
    made: Vec<Option<MadeNode>>,
    /// Nodes without wires, by kind and values: one serves all recipes.
    shared: HashMap<String, NodeId>,
    /// Nodes that hold the material's parameters, by name.
    parameters: HashMap<String, Endpoint>,
    ids: HashSet<String>,
    /// Next number for an id that is taken.
    counters: HashMap<String, usize>,
    /// Height of each node's origin on the other program's canvas.
    heights: HashMap<NodeId, f64>,
}

/// Node that a recipe is made for.
struct RecipeNode<'a> {
    node: &'a ForeignNode,
    /// True where the last node's outputs are named, so that it has to be there.
    is_kept: bool,
}

impl<'a> Builder<'a> {
    /// Makes a foreign node, whose sources are made.
    fn node(&mut self, index: usize) {
        let graph: &'a ForeignGraph = self.graph;
        let node = &graph.nodes[index];
        if is_by_outputs(self.twins, node) {
            return;
        }
        let twin = twin_of(self.twins, node);
        let recipe = twin.and_then(|twin| Recipe::parse(twin.recipe));
        self.made[index] = Some(match (twin, recipe) {
            (Some(twin), Some(recipe)) => {
                self.tell_differences(node, twin, &recipe);
                let making = RecipeNode { node, is_kept: !twin.outputs.is_empty() };
                MadeNode { result: self.make(&recipe, &making, true), twin: Some(twin) }
            }
            _ => MadeNode { result: self.stand_in(node), twin: None },
        });
    }

    /// Tells what a row leaves out.
    fn tell_differences(&mut self, node: &ForeignNode, twin: &Twin, recipe: &Recipe<'_>) {
        if !twin.told.is_empty() {
            let message = format!("`{}` ({}): {}", node.name, node.kind, twin.told);
            self.tell(node, Diagnostic::note("import-differs", message));
        }
        let mut read = HashSet::new();
        recipe.each_input(&mut |name| {
            read.insert(name);
        });
        let is_left = |input: &&ForeignInput| {
            input.is_authored
                && !read.contains(input.name.as_str())
                && !IDLE.contains(&&*input.name)
        };
        let left: Vec<&str> =
            node.inputs.iter().filter(is_left).map(|input| input.name.as_str()).collect();
        if !left.is_empty() {
            let message = tr!(
                "`{name}` ({kind}) has no counterpart here for {left}, which is left out",
                name = node.name,
                kind = node.kind,
                left = left.join(", ")
            );
            self.tell(node, Diagnostic::note("import-left-out", message));
        }
    }

    fn tell(&mut self, node: &ForeignNode, problem: Diagnostic) {
        self.problems.push(match node.place {
            Some(place) => problem.at(place),
            None => problem,
        });
    }

    /// Makes a recipe's nodes.
    fn make(&mut self, recipe: &Recipe<'_>, making: &RecipeNode<'_>, is_last: bool) -> Source {
        match recipe {
            Recipe::Value(value) => Source::Value(value.clone()),
            Recipe::Input { name, words, otherwise } => {
                let found = making.node.input(name).map(|input| self.source(&input.source));
                let found = match found {
                    Some(Source::Value(Value::Text(text))) if !words.is_empty() => {
                        let known = words.iter().find(|(from, _)| *from == text);
                        known.map(|(_, to)| Source::Value(Value::Text((*to).to_owned())))
                    }
                    found => found,
                };
                match (found, otherwise) {
                    (Some(source), _) if source != Source::Default => source,
                    (_, Some(otherwise)) => self.make(otherwise, making, false),
                    _ => Source::Default,
                }
            }
            Recipe::Node { kind, inputs, output } => {
                // What a constant does not choose is not made.
                let chosen = inputs.iter().find(|(port, _)| *port == "condition");
                if *kind == "switch_value"
                    && let Some((_, condition)) = chosen
                {
                    let condition = self.make(condition, making, false);
                    if let Some(number) = number_of(&condition) {
                        let port = if number > 0.5 { "on" } else { "off" };
                        let branch = inputs.iter().find(|(name, _)| *name == port);
                        return branch.map_or(Source::Default, |(_, recipe)| {
                            self.make(recipe, making, is_last)
                        });
                    }
                }
                let inputs: IndexMap<&str, Source> = inputs
                    .iter()
                    .map(|(port, recipe)| (*port, self.make(recipe, making, false)))
                    .collect();
                if *kind == "rotate_vector"
                    && let Some(source) = self.turned_back(&inputs)
                {
                    return source;
                }
                let is_kept = is_last && making.is_kept;
                if let Some(folded) = if is_kept { None } else { folded(kind, &inputs, output) } {
                    return folded;
                }
                let id = self.add(kind, inputs, making.node, is_last);
                Source::Port(Endpoint::new(id, *output))
            }
        }
    }

    /// Source of a vector that two turns leave as it is, or of one that is not given.
    fn turned_back(&self, inputs: &IndexMap<&str, Source>) -> Option<Source> {
        let end = match inputs.get("vector")? {
            Source::Default => return Some(Source::Default),
            Source::Port(end) => end,
            Source::Value(_) => return None,
        };
        let node = self.look.graph.nodes.get(&end.node)?;
        let is_same = |port: &str, sign: f64| {
            let numbers = match (node.values.get(port)?, inputs.get(port)?) {
                (Value::Number(a), Source::Value(Value::Number(b))) => (vec![*a], vec![*b]),
                (Value::Vector(a), Source::Value(Value::Vector(b))) => (a.clone(), b.clone()),
                _ => return None,
            };
            let (a, b) = numbers;
            Some(a.iter().zip(&b).all(|(a, b)| *a == sign * b))
        };
        let is_back = node.kind == "rotate_vector"
            && is_same("axis", 1.0) == Some(true)
            && is_same("angle", -1.0) == Some(true);
        let wire = self.look.graph.wire_into(&end.node, &PortName::new("vector"))?;
        is_back.then(|| Source::Port(wire.from.clone()))
    }

    /// Adds a node, or finds the same one where nothing is wired to it.
    fn add(
        &mut self,
        kind: &str,
        inputs: IndexMap<&str, Source>,
        foreign: &ForeignNode,
        is_last: bool,
    ) -> NodeId {
        let is_free = !inputs.values().any(|source| matches!(source, Source::Port(_)));
        let key = format!("{kind} {inputs:?}");
        if is_free
            && !is_last
            && let Some(id) = self.shared.get(&key)
        {
            return id.clone();
        }
        let name = if is_last { foreign.name.clone() } else { format!("{}_{kind}", foreign.name) };
        let id = self.id(if is_free && !is_last { kind } else { &name });
        let mut node = Node { kind: kind.to_owned(), ..Node::default() };
        if is_last && foreign.name != kind {
            node.name = foreign.name.chars().take(200).collect();
        }
        let def = self.library.nodes.get(kind);
        for (port, source) in inputs {
            let input = def.and_then(|def| Some(&def.inputs[def.input(port)?]));
            let is_setting = input.is_some_and(|input| input.ty.is_setting());
            match source {
                Source::Default => {}
                Source::Value(value) => {
                    let is_switch = input.is_some_and(|input| input.ty == Type::Bool);
                    node.values.insert(port.into(), switched(value, is_switch));
                }
                Source::Port(_) if is_setting => {
                    let message = tr!(
                        "`{name}` ({kind}) is given its {port} by a node, and here it is a fixed \
                         value",
                        name = foreign.name,
                        kind = foreign.kind
                    );
                    let problem = Diagnostic::warning("import-setting", message);
                    self.tell(foreign, problem.hint(tr!("set it in the inspector")));
                }
                Source::Port(from) => {
                    let to = Endpoint::new(id.clone(), port);
                    self.look.graph.wires.push(Wire { from, to });
                }
            }
        }
        if node.values.get("light").is_some_and(|value| *value == Value::Text(KEY.to_owned())) {
            self.light();
        }
        self.look.graph.nodes.insert(id.clone(), node);
        self.heights.insert(id.clone(), foreign.height);
        if !foreign.group.is_empty() && (!is_free || is_last) {
            self.frame(&foreign.group, &id);
        }
        if is_free && !is_last {
            self.shared.insert(key, id.clone());
        }
        id
    }

    /// Adds the light that surfaces are lit by.
    fn light(&mut self) {
        self.look.lights.entry(LightId::new(KEY)).or_insert_with(|| Light {
            name: "Key".to_owned(),
            direction: [0.5, 0.6, 1.0],
            ..Light::default()
        });
    }

    fn frame(&mut self, title: &str, id: &NodeId) {
        let slug = FrameId::new(make_slug(title, |_| false));
        let frame = self.look.graph.frames.entry(slug).or_insert_with(|| Frame {
            title: title.chars().take(200).collect(),
            ..Frame::default()
        });
        frame.nodes.push(id.clone());
    }

    /// Source in the look for one of the foreign graph.
    fn source(&mut self, source: &ForeignSource) -> Source {
        match source {
            ForeignSource::Nothing => Source::Default,
            ForeignSource::Value(value) => Source::Value(value.clone()),
            ForeignSource::Parameter(name, value) => self.parameter(name, value),
            ForeignSource::Link(index, output) => {
                if self.made[*index].is_none() {
                    return self.output(*index, output);
                }
                let Some(made) = &self.made[*index] else { return Source::Default };
                let port = made.twin.and_then(|twin| twin.port(output));
                match (&made.result, port) {
                    (Source::Port(end), Some(port)) => {
                        Source::Port(Endpoint::new(end.node.clone(), port))
                    }
                    (result, _) => result.clone(),
                }
            }
        }
    }

    /// An output that has a row of its own.
    fn output(&mut self, index: usize, output: &str) -> Source {
        let graph: &'a ForeignGraph = self.graph;
        let node = &graph.nodes[index];
        let twin = twin_of_output(self.twins, node, output);
        let recipe = twin.and_then(|twin| Recipe::parse(twin.recipe));
        let (Some(twin), Some(recipe)) = (twin, recipe) else {
            let result = self.stand_in(node);
            self.made[index] = Some(MadeNode { result: result.clone(), twin: None });
            return result;
        };
        if !twin.told.is_empty() {
            let message =
                tr!("`{output}` of `{name}`: {told}", name = node.name, told = tr(twin.told));
            self.tell(node, Diagnostic::note("import-differs", message));
        }
        self.make(&recipe, &RecipeNode { node, is_kept: false }, false)
    }

    /// The node that holds a parameter of the material, exposed by its name.
    fn parameter(&mut self, name: &str, value: &Value) -> Source {
        if let Some(end) = self.parameters.get(name) {
            return Source::Port(end.clone());
        }
        let Some((kind, port, value)) = holder(value) else { return Source::Value(value.clone()) };
        let id = self.id(name);
        let mut node = Node { kind: kind.to_owned(), name: name.to_owned(), ..Node::default() };
        node.values.insert(port.into(), value);
        self.look.graph.nodes.insert(id.clone(), node);
        let target = Target::Input { node: NodePath::parse(id.as_str()), port: port.into() };
        let exposed = ExposedValue { name: id.as_str().into(), target, label: String::new() };
        self.look.exposed.push(exposed);
        let end = Endpoint::new(id, "");
        self.parameters.insert(name.to_owned(), end.clone());
        Source::Port(end)
    }

    /// A note for a node without a twin, and a value in its place.
    fn stand_in(&mut self, node: &ForeignNode) -> Source {
        let variant = if node.variant.is_empty() { "" } else { ":" };
        let kind = format!("{}{variant}{}", node.kind, node.variant);
        let message =
            tr!("`{name}` ({kind}) has no twin here, and came as a note", name = node.name);
        let problem = Diagnostic::warning("import-no-twin", message);
        let hint =
            tr!("its note on the canvas has the values; a stand-in value is wired in its place");
        self.tell(node, problem.hint(hint));
        let (holder, port, value) = match node.ty.as_str() {
            "float" | "integer" | "boolean" => ("number", "value", Value::Number(0.5)),
            "vector2" | "vector3" | "vector4" => {
                ("vector_value", "vector", Value::Vector(vec![0.0, 0.0, 1.0]))
            }
            _ => ("color_value", "color", Value::Vector(vec![0.5, 0.5, 0.5])),
        };
        let id = self.id(&node.name);
        let mut value_node = Node { kind: holder.to_owned(), ..Node::default() };
        value_node.name = format!("Stand-in for {}", node.name).chars().take(200).collect();
        value_node.values.insert(PortName::new(port), value);
        self.look.graph.nodes.insert(id.clone(), value_node);
        self.heights.insert(id.clone(), node.height);
        let mut text = format!("{} ({kind}, {})\nhas no twin here.", node.name, self.graph.program);
        for input in &node.inputs {
            let source = match &input.source {
                ForeignSource::Nothing => continue,
                ForeignSource::Value(value) | ForeignSource::Parameter(_, value) => {
                    format!(" = {}", shown(value))
                }
                ForeignSource::Link(index, output) => {
                    format!(" from {} {output}", self.graph.nodes[*index].name)
                }
            };
            text += &format!("\n{}{}", input.name, source.trim_end());
        }
        let note = Note { text: text.chars().take(10_000).collect(), ..Note::default() };
        self.look.graph.notes.insert(NoteId::new(id.as_str()), note);
        Source::Port(Endpoint::new(id, ""))
    }

    /// An id that is free, made of a name.
    fn id(&mut self, name: &str) -> NodeId {
        let slug = make_slug(name, |_| false);
        let mut id = slug.clone();
        while !self.ids.insert(id.clone()) {
            let counter = self.counters.entry(slug.clone()).or_insert(1);
            *counter += 1;
            id = format!("{slug}_{counter}");
        }
        NodeId::new(id)
    }

    /// Wires the result to the output, and places all nodes.
    fn finish(&mut self) {
        let result = self.source(&self.graph.result.clone());
        let result = match result {
            Source::Port(end) => Some(end),
            Source::Value(value) => {
                let id = self.id("base");
                let mut node = Node { kind: "base".to_owned(), ..Node::default() };
                node.values.insert("color".into(), color(&value));
                self.look.graph.nodes.insert(id.clone(), node);
                Some(Endpoint::new(id, ""))
            }
            Source::Default => None,
        };
        let output = NodeId::new(OUTPUT);
        let node = Node { kind: OUTPUT.to_owned(), ..Node::default() };
        self.look.graph.nodes.insert(output.clone(), node);
        if let Some(from) = result {
            let to = Endpoint::new(output, "color");
            self.look.graph.wires.push(Wire { from, to });
        }
        layout::place(&mut self.look.graph, &self.heights, self.library);
    }
}

/// Inputs whose values other programs write and that say nothing about the picture.
const IDLE: [&str; 3] = ["note", "layer", "defaultgeomprop"];

/// Color for a constant.
fn color(value: &Value) -> Value {
    match value {
        Value::Number(number) => Value::Vector(vec![*number; 3]),
        Value::Vector(numbers) if numbers.len() < 3 => {
            Value::Vector(numbers.iter().copied().chain([0.0; 3]).take(3).collect())
        }
        other => other.clone(),
    }
}

/// A switch as a number, or a number as a switch, as a port wants it.
fn switched(value: Value, is_switch: bool) -> Value {
    match value {
        Value::Bool(on) if !is_switch => Value::Number(f64::from(u8::from(on))),
        Value::Number(number) if is_switch => Value::Bool(number > 0.5),
        value => value,
    }
}

/// Node that holds a value, with its port; `None` for words.
fn holder(value: &Value) -> Option<(&'static str, &'static str, Value)> {
    match value {
        Value::Number(_) => Some(("number", "value", value.clone())),
        Value::Vector(numbers) if numbers.len() == 2 => {
            let numbers = numbers.iter().copied().chain([0.0]).collect();
            Some(("vector_value", "vector", Value::Vector(numbers)))
        }
        Value::Vector(_) => Some(("color_value", "color", value.clone())),
        _ => None,
    }
}

/// Number of a constant; a switch is 0 or 1.
fn number_of(source: &Source) -> Option<f64> {
    match source {
        Source::Value(Value::Number(number)) => Some(*number),
        Source::Value(Value::Bool(on)) => Some(f64::from(u8::from(*on))),
        _ => None,
    }
}

/// True for a constant whose every component is `number`.
fn is_all(source: Option<&Source>, number: f64) -> bool {
    match source {
        Some(Source::Value(Value::Number(one))) => *one == number,
        Some(Source::Value(Value::Vector(all))) => all.iter().all(|one| *one == number),
        _ => false,
    }
}

/// Result of a node whose inputs are constants, or that changes nothing.
fn folded(kind: &str, inputs: &IndexMap<&str, Source>, output: &str) -> Option<Source> {
    let of = |port: &str| inputs.get(port);
    let number = |port: &str| of(port).and_then(number_of);
    let (a, b) = (of("a"), of("b"));
    match kind {
        "multiply" if is_all(b, 1.0) => a.cloned(),
        "multiply" if is_all(a, 1.0) => b.cloned(),
        "add" if is_all(a, 0.0) => b.cloned(),
        "add" | "subtract" if is_all(b, 0.0) => a.cloned(),
        "divide" if is_all(b, 1.0) => a.cloned(),
        "rotate_vector" if number("angle") == Some(0.0) => of("vector").cloned(),
        "power" if number("exponent") == Some(1.0) => of("base").cloned(),
        "add" => each(a?, b?, |a, b| a + b),
        "subtract" => each(a?, b?, |a, b| a - b),
        "multiply" => each(a?, b?, |a, b| a * b),
        "divide" => each(a?, b?, |a, b| if b == 0.0 { 0.0 } else { a / b }),
        "square_root" => Some(Source::Value(Value::Number(number("value")?.max(0.0).sqrt()))),
        "maximum" => each(a?, b?, f64::max),
        "power" => {
            let power = number("base").filter(|base| *base > 0.0)?.powf(number("exponent")?);
            power.is_finite().then_some(Source::Value(Value::Number(power)))
        }
        "compare" => {
            let (a, b) = (number("a")?, number("b")?);
            let holds = match of("test") {
                Some(Source::Value(Value::Text(word))) if word == "greater" => a > b,
                Some(Source::Value(Value::Text(word))) if word == "less" => a < b,
                _ => return None,
            };
            Some(Source::Value(Value::Number(f64::from(u8::from(holds)))))
        }
        "set_alpha" if number("alpha") == Some(1.0) => match of("color") {
            Some(Source::Value(value)) => Some(Source::Value(color(value))),
            _ => None,
        },
        "separate_vector" => match of("vector") {
            Some(Source::Value(Value::Vector(numbers))) => {
                let index = ["x", "y", "z"].iter().position(|name| *name == output)?;
                Some(Source::Value(Value::Number(numbers.get(index).copied().unwrap_or(0.0))))
            }
            Some(Source::Value(Value::Number(number))) => {
                Some(Source::Value(Value::Number(*number)))
            }
            _ => None,
        },
        _ => None,
    }
}

/// A function of two constants, component by component.
fn each(a: &Source, b: &Source, f: impl Fn(f64, f64) -> f64) -> Option<Source> {
    let numbers = |source: &Source| match source {
        Source::Value(Value::Number(number)) => Some(vec![*number]),
        Source::Value(Value::Vector(numbers)) => Some(numbers.clone()),
        _ => None,
    };
    let (a, b) = (numbers(a)?, numbers(b)?);
    let at = |list: &[f64], index: usize| list.get(index).or(list.last()).copied();
    let result: Option<Vec<f64>> =
        (0..a.len().max(b.len())).map(|index| Some(f(at(&a, index)?, at(&b, index)?))).collect();
    Some(Source::Value(match result?.as_slice() {
        [number] => Value::Number(*number),
        numbers => Value::Vector(numbers.to_vec()),
    }))
}
