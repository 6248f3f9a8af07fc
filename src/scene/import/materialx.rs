//! MaterialX documents, read: the material that is assigned first, with its node graphs unrolled.

use std::collections::HashMap;

use chiaro_locale::tr;
use roxmltree::{Document, Node, ParsingOptions};

use super::foreign::{ForeignGraph, ForeignInput, ForeignNode, ForeignSource, bounded};
use super::{MAX_FOREIGN_NODES, MAX_PORTS};
use crate::diag::{Diagnostic, LineColumn};
use crate::document::Value;

/// Most elements and texts of a document.
const MAX_XML_NODES: u32 = 1_000_000;

/// Most steps from an input through graphs and interfaces to its source.
const MAX_STEPS: usize = 256;

/// Most graphs within one another.
const MAX_DEPTH: usize = 32;

/// Kinds of nodes whose row depends on an input, with the input and its default.
const REFINED: [(&str, &str, &str); 6] = [
    ("extract", "index", "0"),
    ("position", "space", "object"),
    ("normal", "space", "object"),
    ("tangent", "space", "object"),
    ("bitangent", "space", "object"),
    ("viewdirection", "space", "world"),
];

/// Elements of a document or a graph that are no nodes.
const OTHER: [&str; 25] = [
    "input",
    "output",
    "parameter",
    "nodegraph",
    "nodedef",
    "implementation",
    "look",
    "lookgroup",
    "materialassign",
    "collection",
    "typedef",
    "member",
    "unit",
    "unitdef",
    "unittypedef",
    "targetdef",
    "geominfo",
    "geompropdef",
    "propertyset",
    "property",
    "variantset",
    "variant",
    "backdrop",
    "include",
    "attributedef",
];

/// Reads a document.
pub(super) fn read(text: &str) -> Result<ForeignGraph, Box<Diagnostic>> {
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: MAX_XML_NODES,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let at = LineColumn { line: error.pos().row, column: error.pos().col };
        let problem = Diagnostic::error("import-xml", tr!("this is no XML: {error}"));
        Box::new(
            problem.at(at).hint(tr!("export the document again from the program that wrote it")),
        )
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "materialx" {
        let message =
            tr!("the document is `{name}`, and no `materialx`", name = root.tag_name().name());
        let problem = Diagnostic::error("import-no-materialx", message);
        return Err(Box::new(
            problem.hint(tr!("choose a file that MaterialX or a program has written")),
        ));
    }
    let mut reader = Reader::new(text, &document);
    reader.containers(root)?;
    reader.inputs()?;
    reader.result(root)?;
    Ok(reader.graph)
}

/// Container: the document, a graph of it, or one use of a graph that is a node.
struct Container<'d> {
    element: Node<'d, 'd>,
    /// Title of the frame of the container's nodes.
    title: String,
    /// The container around it, with the element that gives the interface's values: the node that
    /// uses the graph, or the graph itself.
    outer: Option<(usize, Node<'d, 'd>)>,
    /// Nodes by name: ordinary ones, or uses of graphs.
    members: HashMap<&'d str, Member>,
    depth: usize,
}

#[derive(Clone, Copy)]
enum Member {
    Node(usize),
    Graph(usize),
}

struct Reader<'d> {
    text: &'d str,
    /// Offsets at which lines begin.
    lines: Vec<usize>,
    /// Definitions of nodes, by name.
    definitions: HashMap<&'d str, Node<'d, 'd>>,
    containers: Vec<Container<'d>>,
    /// Container and element of each node of the graph.
    places: Vec<(usize, Node<'d, 'd>)>,
    graph: ForeignGraph,
}

impl<'d> Reader<'d> {
    fn new(text: &'d str, document: &'d Document<'d>) -> Self {
        let graph = ForeignGraph { program: "MaterialX", ..ForeignGraph::default() };
        let ends = text.match_indices('\n').map(|(end, _)| end + 1);
        let lines = std::iter::once(0).chain(ends).collect();
        let definitions = children(document.root_element(), &["nodedef"]);
        let named = |it: Node<'d, 'd>| Some((it.attribute("name")?, it));
        let definitions = definitions.filter_map(named).collect();
        let (containers, places) = (Vec::new(), Vec::new());
        Self { text, lines, definitions, containers, places, graph }
    }

    /// Place of an element. Lines are known, so that a file of many elements is not read anew for
    /// each; columns of a line without an end are counted in bytes.
    fn at(&self, element: Node<'_, '_>) -> LineColumn {
        let offset = element.range().start;
        let line = self.lines.partition_point(|start| *start <= offset).saturating_sub(1);
        let start = self.lines.get(line).copied().unwrap_or_default();
        let before = self.text.get(start..offset).unwrap_or_default();
        let is_long = before.len() > 1000;
        let count = if is_long { before.len() } else { before.chars().count() };
        LineColumn { line: line as u32 + 1, column: count as u32 + 1 }
    }

    fn error(
        &self,
        element: Node<'_, '_>,
        code: &'static str,
        message: String,
        hint: &str,
    ) -> Box<Diagnostic> {
        Box::new(Diagnostic::error(code, message).at(self.at(element)).hint(hint))
    }

    /// Finds all nodes: those of the document, of its graphs, and of each use of a graph that is a
    /// node.
    fn containers(&mut self, root: Node<'d, 'd>) -> Result<(), Box<Diagnostic>> {
        let title = String::new();
        let members = HashMap::new();
        self.containers.push(Container { element: root, title, outer: None, members, depth: 0 });
        let graphs = graphs_of_nodes(root);
        let mut index = 0;
        while index < self.containers.len() {
            for element in self.containers[index].element.children().filter(Node::is_element) {
                self.element(index, element, &graphs)?;
            }
            index += 1;
        }
        Ok(())
    }

    fn element(
        &mut self,
        container: usize,
        element: Node<'d, 'd>,
        graphs: &HashMap<(&str, &str), Node<'d, 'd>>,
    ) -> Result<(), Box<Diagnostic>> {
        let kind = element.tag_name().name();
        let name = element.attribute("name").unwrap_or(kind);
        if kind == "include" {
            let message = tr!(
                "`{file}` is a file of its own and is not read",
                file = element.attribute("href").unwrap_or_default()
            );
            let problem = Diagnostic::warning("import-include", message).at(self.at(element));
            let hint = tr!("flatten the document in the program that wrote it");
            self.graph.problems.push(problem.hint(hint));
            return Ok(());
        }
        let ports = match is_nested(kind) {
            true => children(element, &["input"]).count(),
            false => element.children().filter(Node::is_element).count(),
        };
        if ports > MAX_PORTS {
            let message = tr!("`{name}` has more than {MAX_PORTS} inputs");
            return Err(self.error(element, "too-many", message, tr!("take some of them out")));
        }
        let ty = element.attribute("type").unwrap_or_default();
        let is_graph = kind == "nodegraph" && element.attribute("nodedef").is_none();
        let used = graphs.get(&(kind, ty)).copied();
        let member = if is_graph || used.is_some() {
            let depth = self.containers[container].depth + 1;
            if depth > MAX_DEPTH {
                let message = tr!("`{name}` lies {depth} graphs deep");
                let hint = tr!("flatten the graphs there, and export again");
                return Err(self.error(element, "import-deep", message, hint));
            }
            let outer = &self.containers[container].title;
            let title = if outer.is_empty() { name.to_owned() } else { outer.clone() };
            self.containers.push(Container {
                element: used.unwrap_or(element),
                title,
                outer: Some((container, element)),
                members: HashMap::new(),
                depth,
            });
            Member::Graph(self.containers.len() - 1)
        } else if OTHER.contains(&kind) {
            return Ok(());
        } else {
            self.graph.nodes.push(ForeignNode {
                name: name.to_owned(),
                kind: kind.to_owned(),
                variant: variant(element),
                ty: type_of(element),
                group: self.containers[container].title.clone(),
                height: element.range().start as f64,
                inputs: Vec::new(),
                place: Some(self.at(element)),
            });
            self.places.push((container, element));
            Member::Node(self.graph.nodes.len() - 1)
        };
        if self.graph.nodes.len() > MAX_FOREIGN_NODES || self.containers.len() > MAX_FOREIGN_NODES {
            let message = tr!("the document has more than {MAX_FOREIGN_NODES} nodes");
            let hint = tr!("export the one material that is wanted to a file of its own");
            return Err(self.error(element, "too-many", message, hint));
        }
        self.containers[container].members.insert(name, member);
        Ok(())
    }

    /// Reads the inputs of all nodes.
    fn inputs(&mut self) -> Result<(), Box<Diagnostic>> {
        for index in 0..self.places.len() {
            let (container, element) = self.places[index];
            let mut inputs = Vec::new();
            for input in children(element, &["input", "parameter"]) {
                let name = input.attribute("name").unwrap_or_default().to_owned();
                let source = self.source(container, input)?;
                if input.attribute("type") == Some("filename") {
                    let space = ForeignSource::Value(Value::Text(color_space(input).to_owned()));
                    let name = format!("{name}_space");
                    inputs.push(ForeignInput { name, source: space, is_authored: false });
                }
                // What decides the row is in the row.
                let kind = element.tag_name().name();
                let is_authored = !REFINED.iter().any(|(of, by, _)| *of == kind && *by == name);
                inputs.push(ForeignInput { name, source, is_authored });
            }
            self.graph.nodes[index].inputs = inputs;
        }
        Ok(())
    }

    /// Follows an input, or an output of a graph, to its value or to the node that it reads.
    fn source(
        &self,
        mut container: usize,
        mut element: Node<'d, 'd>,
    ) -> Result<ForeignSource, Box<Diagnostic>> {
        let first = element;
        for _ in 0..MAX_STEPS {
            let output = element.attribute("output").unwrap_or_default();
            let linked = element.attribute("nodename").or(element.attribute("nodegraph"));
            if let Some(name) = linked {
                match self.member(container, name) {
                    Some(Member::Node(index)) => {
                        return Ok(ForeignSource::Link(index, output.to_owned()));
                    }
                    Some(Member::Graph(graph)) => {
                        let mut outputs = children(self.containers[graph].element, &["output"]);
                        let is_named = |it: &Node<'_, '_>| it.attribute("name") == Some(output);
                        let found =
                            if output.is_empty() { outputs.next() } else { outputs.find(is_named) };
                        let Some(found) = found else {
                            let message = tr!("`{name}` has no output `{output}`");
                            let hint = tr!("name one of its outputs, or leave `output` out");
                            return Err(self.error(element, "import-link", message, hint));
                        };
                        (container, element) = (graph, found);
                        continue;
                    }
                    None => {
                        let port = element.attribute("name").unwrap_or_default();
                        let of = element.parent_element().and_then(|it| it.attribute("name"));
                        let message = tr!(
                            "`{port}` of `{node}` reads `{name}`, and there is no such node",
                            node = of.unwrap_or(tr!("the document"))
                        );
                        let hint = tr!("give the input a value, or the name of a node beside it");
                        return Err(self.error(element, "import-link", message, hint));
                    }
                }
            }
            let Some(interface) = element.attribute("interfacename") else {
                return Ok(value(element).map_or(ForeignSource::Nothing, ForeignSource::Value));
            };
            let Some((outer, user)) = self.containers[container].outer else {
                return Ok(ForeignSource::Nothing);
            };
            let is_named = |it: &Node<'_, '_>| it.attribute("name") == Some(interface);
            let own = self.containers[container].element;
            let given = children(user, &["input", "parameter"]).find(is_named);
            let Some(given) = given.or_else(|| children(own, &["input"]).find(is_named)) else {
                let found = self.definition(own).and_then(|definition| {
                    children(definition, &["input"]).find(is_named).and_then(value)
                });
                return Ok(found.map_or(ForeignSource::Nothing, ForeignSource::Value));
            };
            let is_linked = ["nodename", "nodegraph", "interfacename"]
                .iter()
                .any(|it| given.has_attribute(*it));
            if !is_linked {
                let found = value(given);
                let parameter = |value| ForeignSource::Parameter(interface.to_owned(), value);
                return Ok(found.map_or(ForeignSource::Nothing, parameter));
            }
            (container, element) = (outer, given);
        }
        let name = first.attribute("name").unwrap_or_default();
        let message = tr!("`{name}` leads through more than {MAX_STEPS} graphs, or in a circle");
        Err(self.error(first, "import-circle", message, tr!("unlink it there, and export again")))
    }

    /// A node or a graph beside an element, or of the document.
    fn member(&self, container: usize, name: &str) -> Option<Member> {
        let mut at = Some(container);
        while let Some(index) = at {
            let found = self.containers[index].members.get(name);
            if found.is_some() {
                return found.copied();
            }
            at = self.containers[index].outer.map(|(outer, _)| outer);
        }
        None
    }

    /// The definition that a graph implements.
    fn definition(&self, graph: Node<'d, 'd>) -> Option<Node<'d, 'd>> {
        self.definitions.get(graph.attribute("nodedef")?).copied()
    }

    /// Finds what is seen: the first material that a look assigns, else the first material, shader
    /// or output of the document, with what leads there.
    fn result(&mut self, root: Node<'d, 'd>) -> Result<(), Box<Diagnostic>> {
        let assigned = children(root, &["look"])
            .flat_map(|look| children(look, &["materialassign"]))
            .find_map(|assign| assign.attribute("material"));
        let is_material = |node: &&ForeignNode| {
            node.kind == "surfacematerial" && assigned.is_none_or(|name| node.name == name)
        };
        let shader = |node: &ForeignNode| match node.input("surfaceshader")?.source {
            ForeignSource::Link(index, _) => Some((node.name.clone(), index)),
            _ => None,
        };
        let material = self.graph.nodes.iter().find(is_material).and_then(shader);
        let by_type = |ty: &str| {
            let mut nodes = self.graph.nodes.iter().enumerate();
            nodes.find(|(_, node)| node.ty == ty).map(|(index, node)| (node.name.clone(), index))
        };
        if let Some((name, index)) = material.or_else(|| by_type("surfaceshader")) {
            self.graph.name = name;
            self.graph.result = ForeignSource::Link(index, String::new());
            return Ok(());
        }
        for container in 0..self.containers.len() {
            let element = self.containers[container].element;
            if let Some(output) = children(element, &["output"]).next() {
                let name = element.attribute("name").or(output.attribute("name"));
                self.graph.name = name.unwrap_or_default().to_owned();
                self.graph.result = self.source(container, output)?;
                return Ok(());
            }
        }
        let message =
            tr!("the document has no material, no surface shader and no output").to_owned();
        let hint = tr!("export a material, or give a node graph an output");
        Err(self.error(root, "import-empty", message, hint))
    }
}

/// True for what holds nodes of its own.
fn is_nested(kind: &str) -> bool {
    ["nodegraph", "look", "lookgroup"].contains(&kind)
}

/// Graphs of nodes that the document defines itself, by kind and type of the node.
fn graphs_of_nodes<'d>(root: Node<'d, 'd>) -> HashMap<(&'d str, &'d str), Node<'d, 'd>> {
    let mut definitions = HashMap::new();
    for definition in children(root, &["nodedef"]) {
        let names = definition.attribute("name").zip(definition.attribute("node"));
        let Some((name, kind)) = names else { continue };
        let own = definition.attribute("type");
        let mut outputs = children(definition, &["output"]);
        let output = outputs.next().and_then(|output| output.attribute("type"));
        // Nodes of several outputs have a type of their own.
        let output = if outputs.next().is_some() { Some("multioutput") } else { output };
        let ty = own.or(output).unwrap_or_default();
        definitions.insert(name, (kind, ty));
    }
    let mut graphs: Vec<_> = children(root, &["nodegraph"]).collect();
    // Of several graphs of a node, the one for all targets is meant; the last stays.
    graphs.sort_by_key(|graph| !graph.has_attribute("target"));
    let graphs = graphs.into_iter().filter_map(|graph| {
        let key = definitions.get(graph.attribute("nodedef")?)?;
        Some((*key, graph))
    });
    graphs.collect()
}

/// Children of these kinds.
fn children<'d>(
    element: Node<'d, 'd>,
    kinds: &'static [&'static str],
) -> impl Iterator<Item = Node<'d, 'd>> {
    element
        .children()
        .filter(|child| child.is_element() && kinds.contains(&child.tag_name().name()))
}

/// Setting of a node that decides its row.
fn variant(element: Node<'_, '_>) -> String {
    let kind = element.tag_name().name();
    let Some((_, name, default)) = REFINED.into_iter().find(|(refined, ..)| *refined == kind)
    else {
        return String::new();
    };
    let mut inputs = children(element, &["input", "parameter"]);
    let input = inputs.find(|input| input.attribute("name") == Some(name));
    input.and_then(|input| input.attribute("value")).unwrap_or(default).to_owned()
}

/// Type that decides a node's row: that of its result, or of what is taken apart.
fn type_of(element: Node<'_, '_>) -> String {
    let kind = element.tag_name().name();
    let inputs: Vec<_> = children(element, &["input", "parameter"]).collect();
    let of = |name: &str| {
        let input = inputs.iter().find(|input| input.attribute("name") == Some(name));
        input.and_then(|input| input.attribute("type"))
    };
    let taken = match kind {
        "extract" | "separate2" | "separate3" | "separate4" | "convert" => of("in"),
        // Amounts of a mix may be colors, each channel with its own.
        "mix" => of("mix").filter(|ty| *ty != "float").map(|_| "channels"),
        _ => None,
    };
    taken.or(element.attribute("type")).unwrap_or_default().to_owned()
}

/// Color space of an element's numbers: its own, or that of what it lies in.
fn color_space<'d>(element: Node<'d, 'd>) -> &'d str {
    let spaces = element.ancestors().find_map(|element| element.attribute("colorspace"));
    spaces.unwrap_or("lin_rec709")
}

/// Value of an input.
fn value(element: Node<'_, '_>) -> Option<Value> {
    let text = element.attribute("value")?;
    let numbers = || -> Option<Vec<f64>> {
        let numbers = text.split(',').map(|number| number.trim().parse().map(bounded));
        numbers.collect::<Result<_, _>>().ok()
    };
    match element.attribute("type").unwrap_or_default() {
        "float" | "integer" => Some(Value::Number(*numbers()?.first()?)),
        "boolean" => Some(Value::Bool(text.trim() == "true")),
        "color3" | "color4" => {
            let mut numbers = numbers()?;
            numbers.truncate(4);
            if color_space(element) == "srgb_texture" {
                let rgb = numbers.iter_mut().take(3);
                rgb.for_each(|number| *number = crate::document::srgb_to_linear(*number));
            }
            Some(Value::Vector(numbers))
        }
        "vector2" | "vector3" | "vector4" => {
            Some(Value::Vector(numbers()?.into_iter().take(4).collect()))
        }
        "filename" => {
            let prefix = element.ancestors().find_map(|it| it.attribute("fileprefix"));
            Some(Value::Text(prefix.unwrap_or_default().to_owned() + text))
        }
        "string" => Some(Value::Text(text.to_owned())),
        _ => None,
    }
}
