//! Shader nodes of Blender, read: the JSON of `blender_nodes.py`, with groups unrolled.

use std::collections::HashMap;

use chiaro_locale::tr;
use serde::Deserialize;

use super::foreign::{ForeignGraph, ForeignInput, ForeignNode, ForeignSource, bounded};
use super::{MAX_FOREIGN_NODES, MAX_PORTS};
use crate::diag::{Diagnostic, LineColumn};
use crate::document::{Curve, Interpolation, Ramp, RampStop, Value};

/// Most groups within one another.
const MAX_DEPTH: usize = 32;

/// Most steps from an input through groups and reroutes to its source.
const MAX_STEPS: usize = 256;

/// Nodes whose row depends on settings, with these.
const REFINED: [(&str, &[&str]); 10] = [
    ("ShaderNodeMapping", &["vector_type"]),
    ("ShaderNodeMath", &["operation"]),
    ("ShaderNodeVectorMath", &["operation"]),
    ("ShaderNodeMix", &["data_type", "blend_type"]),
    (OLD_MIX, &["blend_type"]),
    ("ShaderNodeMapRange", &["data_type", "interpolation_type"]),
    ("ShaderNodeClamp", &["clamp_type"]),
    ("ShaderNodeSeparateColor", &["mode"]),
    ("ShaderNodeCombineColor", &["mode"]),
    ("ShaderNodeTexGradient", &["gradient_type"]),
];

/// The mix of colors of files from before Blender 3.4, which newer ones keep.
const OLD_MIX: &str = "ShaderNodeMixRGB";

/// Inputs and settings of the old mix, with those of the mix that came after.
const OLD_MIX_INPUTS: [(&str, &str); 4] = [
    ("fac", "factor_float"),
    ("color1", "a_color"),
    ("color2", "b_color"),
    ("set_use_clamp", "set_clamp_result"),
];

/// A file.
#[derive(Deserialize)]
struct File {
    #[serde(default)]
    material: String,
    #[serde(flatten)]
    tree: Tree,
    #[serde(default)]
    groups: HashMap<String, Option<Tree>>,
}

#[derive(Deserialize)]
struct Tree {
    nodes: Vec<FileNode>,
    #[serde(default)]
    links: Vec<[String; 4]>,
}

#[derive(Deserialize)]
struct FileNode {
    name: String,
    #[serde(default)]
    label: String,
    kind: String,
    #[serde(default)]
    at: [f64; 2],
    #[serde(default)]
    muted: bool,
    #[serde(default)]
    inputs: Vec<Socket>,
    #[serde(default)]
    outputs: Vec<Socket>,
    #[serde(default)]
    settings: HashMap<String, serde_json::Value>,
    group: Option<String>,
    ramp: Option<FileRamp>,
    #[serde(default)]
    curves: Vec<Vec<[f64; 2]>>,
    image: Option<FileImage>,
}

#[derive(Deserialize)]
struct Socket {
    id: String,
    #[serde(rename = "type", default)]
    ty: String,
    #[serde(default)]
    value: serde_json::Value,
}

#[derive(Deserialize)]
struct FileRamp {
    #[serde(default)]
    interpolation: String,
    stops: Vec<RampStop>,
}

#[derive(Deserialize)]
struct FileImage {
    path: String,
    #[serde(default)]
    space: String,
}

/// Reads a file.
pub(super) fn read(text: &str) -> Result<ForeignGraph, Box<Diagnostic>> {
    let file: File = serde_json::from_str(text).map_err(|error| {
        let at = LineColumn { line: error.line() as u32, column: error.column() as u32 };
        let problem = Diagnostic::error("import-json", tr!("these are no nodes: {error}"));
        let hint =
            tr!("write the file with blender_nodes.py, which `chiaro import --script` prints");
        Box::new(problem.at(at).hint(hint))
    })?;
    let mut reader =
        Reader { file: &file, uses: Vec::new(), places: Vec::new(), nodes: Vec::new() };
    reader.trees()?;
    reader.inputs()?;
    let result = reader.result()?;
    Ok(ForeignGraph {
        name: file.material.chars().take(200).collect(),
        program: "Blender",
        nodes: reader.nodes,
        result,
        problems: Vec::new(),
    })
}

/// One use of a tree: the material's own, or a group's.
struct TreeUse<'f> {
    tree: &'f Tree,
    title: String,
    /// The use around it, with the node that uses the group.
    outer: Option<(usize, &'f FileNode)>,
    depth: usize,
    /// Nodes by name, each with its number where it is one of the graph, or the use of its group.
    members: HashMap<&'f str, (&'f FileNode, Member)>,
    /// Links by node and input.
    links: HashMap<(&'f str, &'f str), (&'f str, &'f str)>,
}

#[derive(Clone, Copy)]
enum Member {
    Node(usize),
    Group(usize),
    /// A node that only hands on: a reroute, the ends of a group.
    Passage,
}

struct Reader<'f> {
    file: &'f File,
    uses: Vec<TreeUse<'f>>,
    /// Use and node of each node of the graph.
    places: Vec<(usize, &'f FileNode)>,
    nodes: Vec<ForeignNode>,
}

/// Name of a socket as recipes know it: `Base Color` is `base_color`.
fn recipe_name(id: &str) -> String {
    let plain = |c: char| {
        if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' }
    };
    id.chars().take(64).map(plain).collect()
}

/// Type of a socket, in words of the tables.
fn type_of(socket: Option<&Socket>) -> &'static str {
    match socket.map(|socket| socket.ty.as_str()) {
        Some("VALUE" | "INT" | "BOOLEAN") => "float",
        Some("VECTOR" | "ROTATION") => "vector3",
        Some("SHADER") => "BSDF",
        _ => "color3",
    }
}

fn error(code: &'static str, message: String, hint: &str) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(code, message).hint(hint))
}

impl<'f> Reader<'f> {
    fn add_use(
        &mut self,
        tree: &'f Tree,
        title: String,
        outer: Option<(usize, &'f FileNode)>,
        depth: usize,
    ) {
        let link = |[from, output, to, input]: &'f [String; 4]| {
            ((to.as_str(), input.as_str()), (from.as_str(), output.as_str()))
        };
        let links = tree.links.iter().map(link).collect();
        self.uses.push(TreeUse { tree, title, outer, depth, members: HashMap::new(), links });
    }

    fn trees(&mut self) -> Result<(), Box<Diagnostic>> {
        let file = self.file;
        self.add_use(&file.tree, String::new(), None, 0);
        let mut index = 0;
        while index < self.uses.len() {
            let tree = self.uses[index].tree;
            for node in &tree.nodes {
                let member = self.node(index, node)?;
                self.uses[index].members.insert(&node.name, (node, member));
            }
            index += 1;
        }
        Ok(())
    }

    fn node(&mut self, index: usize, node: &'f FileNode) -> Result<Member, Box<Diagnostic>> {
        if node.inputs.len().max(node.outputs.len()) > MAX_PORTS {
            let message = tr!("`{name}` has more than {MAX_PORTS} sockets", name = node.name);
            return Err(error("too-many", message, tr!("take some of them out in Blender")));
        }
        let passages = ["NodeReroute", "NodeGroupInput", "NodeGroupOutput", "NodeFrame"];
        if passages.contains(&node.kind.as_str()) {
            return Ok(Member::Passage);
        }
        let file = self.file;
        let group = node.group.as_ref().and_then(|name| file.groups.get(name)?.as_ref());
        let member = if let Some(tree) = group {
            let depth = self.uses[index].depth + 1;
            if depth > MAX_DEPTH {
                let message = tr!("`{name}` lies {depth} groups deep", name = node.name);
                let hint = tr!("ungroup some of them in Blender, and export again");
                return Err(error("import-deep", message, hint));
            }
            let outer = &self.uses[index].title;
            let own = if node.label.is_empty() { &node.name } else { &node.label };
            let title = if outer.is_empty() { own.clone() } else { outer.clone() };
            self.add_use(tree, title, Some((index, node)), depth);
            Member::Group(self.uses.len() - 1)
        } else {
            self.nodes.push(self.foreign(index, node));
            self.places.push((index, node));
            Member::Node(self.nodes.len() - 1)
        };
        if self.nodes.len() > MAX_FOREIGN_NODES || self.uses.len() > MAX_FOREIGN_NODES {
            let message = tr!("the material has more than {MAX_FOREIGN_NODES} nodes");
            return Err(error("too-many", message, tr!("take parts of it out in Blender")));
        }
        Ok(member)
    }

    fn foreign(&self, index: usize, node: &FileNode) -> ForeignNode {
        let settings = REFINED.iter().find(|(kind, _)| *kind == node.kind);
        let word = |name: &&str| match node.settings.get(*name) {
            Some(serde_json::Value::String(word)) => Some(word.clone()),
            Some(serde_json::Value::Bool(on)) => Some(on.to_string()),
            _ => None,
        };
        let mut words: Vec<String> =
            settings.map_or(&[][..], |(_, names)| names).iter().filter_map(word).collect();
        if node.kind == "ShaderNodeMix" && words.first().is_some_and(|word| word != "RGBA") {
            words.truncate(1);
        }
        let mut kind = node.kind.as_str();
        if kind == OLD_MIX {
            words.insert(0, "RGBA".to_owned());
            kind = "ShaderNodeMix";
        }
        let name = if node.label.is_empty() { &node.name } else { &node.label };
        ForeignNode {
            name: name.chars().take(200).collect(),
            kind: kind.to_owned(),
            variant: words.join("-"),
            ty: type_of(node.outputs.first()).to_owned(),
            group: self.uses[index].title.clone(),
            height: -bounded(node.at[1]),
            inputs: Vec::new(),
            place: None,
        }
    }

    fn inputs(&mut self) -> Result<(), Box<Diagnostic>> {
        for index in 0..self.places.len() {
            let (at, node) = self.places[index];
            let mut inputs = Vec::new();
            for socket in &node.inputs {
                let (source, from) = self.source(at, node, socket)?;
                let is_linked = matches!(source, ForeignSource::Link(..));
                let source = self.converted(source, from, type_of(Some(socket)));
                let name = recipe_name(&socket.id);
                inputs.push(ForeignInput { name, source, is_authored: is_linked });
            }
            inputs.extend(settings(node));
            if node.kind == OLD_MIX {
                for input in &mut inputs {
                    let known = OLD_MIX_INPUTS.iter().find(|(old, _)| *old == input.name);
                    if let Some((_, new)) = known {
                        (*new).clone_into(&mut input.name);
                    }
                }
            }
            self.nodes[index].inputs = inputs;
        }
        Ok(())
    }

    /// A source for an input of another type, as Blender converts it: a vector as a number is the
    /// mean of its components, a color its luminance.
    fn converted(&mut self, source: ForeignSource, from: &str, to: &str) -> ForeignSource {
        let (kind, name) = match (from, to) {
            ("vector3", "float") => ("mean", "Mean"),
            ("color3" | "BSDF", "float") => ("luminance", "Luminance"),
            _ => return source,
        };
        if !matches!(source, ForeignSource::Link(..)) {
            return source;
        }
        let input = ForeignInput { name: "in".to_owned(), source, is_authored: true };
        self.nodes.push(ForeignNode {
            name: name.to_owned(),
            kind: kind.to_owned(),
            ty: "float".to_owned(),
            inputs: vec![input],
            ..ForeignNode::default()
        });
        ForeignSource::Link(self.nodes.len() - 1, String::new())
    }

    /// Follows an input to its value or to the node that it reads, with the type of what is read.
    fn source(
        &self,
        mut at: usize,
        mut node: &'f FileNode,
        mut socket: &'f Socket,
    ) -> Result<(ForeignSource, &'static str), Box<Diagnostic>> {
        let first = (&node.name, &socket.id);
        for _ in 0..MAX_STEPS {
            let ty = type_of(Some(socket));
            let tree = &self.uses[at];
            let Some((from, output)) = tree.links.get(&(&*node.name, &*socket.id)).copied() else {
                return Ok((
                    value(socket).map_or(ForeignSource::Nothing, ForeignSource::Value),
                    ty,
                ));
            };
            let Some((source, member)) = tree.members.get(from).copied() else {
                let message = tr!(
                    "`{id}` of `{name}` is linked to `{from}`, which is no node",
                    id = socket.id,
                    name = node.name
                );
                let hint = tr!("write the file again with blender_nodes.py");
                return Err(error("import-link", message, hint));
            };
            let by_id = |sockets: &'f [Socket], id: &str| sockets.iter().find(|it| it.id == id);
            let next = match member {
                Member::Node(index) if !source.muted => {
                    let ty = type_of(by_id(&source.outputs, output));
                    return Ok((ForeignSource::Link(index, recipe_name(output)), ty));
                }
                // What is muted hands on its first input of the same type.
                Member::Node(_) => {
                    let ty = type_of(by_id(&source.outputs, output));
                    let same = source.inputs.iter().find(|it| type_of(Some(it)) == ty);
                    same.map(|socket| (at, source, socket))
                }
                Member::Group(group) => {
                    let members = self.uses[group].tree.nodes.iter();
                    let mut ends = members.filter(|it| it.kind == "NodeGroupOutput");
                    ends.find_map(|end| Some((group, end, by_id(&end.inputs, output)?)))
                }
                Member::Passage if source.kind == "NodeGroupInput" => tree
                    .outer
                    .and_then(|(outer, user)| Some((outer, user, by_id(&user.inputs, output)?))),
                Member::Passage => source.inputs.first().map(|socket| (at, source, socket)),
            };
            let Some(next) = next else {
                return Ok((ForeignSource::Nothing, ty));
            };
            (at, node, socket) = next;
        }
        let (node, socket) = first;
        let message = tr!("`{socket}` of `{node}` leads in a circle");
        Err(error("import-circle", message, tr!("unlink it in Blender, and export again")))
    }

    /// Color of the surface of the material's output.
    fn result(&mut self) -> Result<ForeignSource, Box<Diagnostic>> {
        let mut nodes = self.file.tree.nodes.iter();
        let output = nodes.find(|node| node.kind == "ShaderNodeOutputMaterial");
        let surface = output.and_then(|node| {
            Some((node, node.inputs.iter().find(|socket| socket.id == "Surface")?))
        });
        let Some((node, surface)) = surface else {
            let message = tr!("the material has no Material Output with a surface").to_owned();
            return Err(error(
                "import-empty",
                message,
                tr!("add one in Blender, and export again"),
            ));
        };
        Ok(self.source(0, node, surface)?.0)
    }
}

/// Inputs that a node's settings are.
fn settings(node: &FileNode) -> Vec<ForeignInput> {
    let input = |name: &str, value: Value| ForeignInput {
        name: name.to_owned(),
        source: ForeignSource::Value(value),
        is_authored: false,
    };
    let mut inputs = Vec::new();
    for (name, setting) in &node.settings {
        let value = match setting {
            serde_json::Value::Bool(on) => Value::Bool(*on),
            serde_json::Value::String(word) => Value::Text(word.clone()),
            serde_json::Value::Number(number) => {
                Value::Number(bounded(number.as_f64().unwrap_or_default()))
            }
            _ => continue,
        };
        inputs.push(input(&format!("set_{}", recipe_name(name)), value));
    }
    // What a node holds itself, and shows as its output: a value, a color.
    let held = node.outputs.first().and_then(value);
    if node.inputs.is_empty()
        && let Some(held) = held
    {
        inputs.push(input("held", held));
    }
    if let Some(ramp) = &node.ramp {
        inputs.push(input("ramp", Value::Ramp(ramp_of(ramp))));
    }
    for (index, points) in node.curves.iter().take(4).enumerate() {
        let points = points.iter().take(Curve::MAX_POINTS);
        let points = points.map(|[x, y]| [bounded(*x), bounded(*y)]).collect();
        let curve = Curve { points, interpolation: Interpolation::Smooth };
        inputs.push(input(&format!("curve_{index}"), Value::Curve(curve)));
    }
    if let Some(image) = &node.image {
        inputs.push(input("image", Value::Text(image.path.clone())));
        let encoding = if image.space.starts_with("sRGB") { "color" } else { "data" };
        inputs.push(input("image_space", Value::Text(encoding.to_owned())));
    }
    inputs
}

fn ramp_of(ramp: &FileRamp) -> Ramp {
    let interpolation = match ramp.interpolation.as_str() {
        "CONSTANT" => Interpolation::Stepped,
        "LINEAR" => Interpolation::Linear,
        _ => Interpolation::Smooth,
    };
    let stops = ramp.stops.iter().take(Ramp::MAX_STOPS).map(|stop| RampStop {
        at: bounded(stop.at),
        color: stop.color.iter().take(4).copied().map(bounded).collect(),
    });
    Ramp { stops: stops.collect(), interpolation }
}

/// Value of a socket. The alpha of colors changes nothing in Blender's shaders.
fn value(socket: &Socket) -> Option<Value> {
    match &socket.value {
        serde_json::Value::Bool(on) => Some(Value::Bool(*on)),
        serde_json::Value::Number(number) => Some(Value::Number(bounded(number.as_f64()?))),
        serde_json::Value::Array(numbers) => {
            let numbers: Option<Vec<f64>> =
                numbers.iter().take(3).map(|number| number.as_f64().map(bounded)).collect();
            numbers.filter(|numbers| !numbers.is_empty()).map(Value::Vector)
        }
        _ => None,
    }
}
