//! A look: one shading graph with its lights, its groups and its keys.

use chiaro_locale::tr;
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::described::{AUTOMATIC_OR_TIER, described};
use super::light::{Light, LightField, NodeLinks};
use super::set::LightSet;
use super::shape::{F32, FAR, FORMAT, FieldKind, LINE, LONG, MAX_NODES, MAX_WIRES, NumberBounds};
use super::timing::{MAX_MARKERS, Marker, TimeKeys};
use super::value::{Value, Values};
use super::word::WordChoice as _;
use crate::ids::{DefinitionId, FrameId, LightId, NodeId, NodePath, NoteId, ObjectId, PortName};

/// Greatest difference that nobody can see: a step of a screen's 8-bit channel.
pub const MAX_ERROR: f64 = 1.0 / 255.0;

/// Kind of the node that asks whether a light is one of a set.
pub const LIGHT_IN_SET: &str = "light_in_set";

/// Kind of positions on the canvas.
const CANVAS: FieldKind = FieldKind::Numbers(2, 2, NumberBounds::new(-1e9, 1e9));

/// Fields that this version does not know. They survive a save, and loading warns about them.
///
/// Parts without an `unknown` of their own (lights, wires, a curve) leave theirs to the part around
/// them: under the name of its field and the key of the part (an id, a wire's input), e.g.
/// `{"lights": {"key": {"flare": 2}}}`.
pub type UnknownFields = serde_json::Map<String, serde_json::Value>;

described! {
    /// One shading graph with its lights, groups and keys.
    #[serde(default)]
    pub struct Look("look", Lines) {
        /// Type of the document.
        "chiaro": FieldKind::Word(&[("look", "a look")]), words "what it is opened as";
        /// The version of the format.
        "version": FieldKind::Number(FORMAT), json "1";
        /// A JSON Schema for text editors; kept, and not looked at.
        "$schema": FieldKind::Text(LINE), words "none";
        /// Name that the artist gave.
        name: String = String::new(), FieldKind::Text(LINE);
        /// Paragraph on the picture and its construction, for whoever finds the look.
        about: String = String::new(), FieldKind::Text(LONG);
        /// Words to find the look by in a library, apart by spaces.
        tags: String = String::new(), FieldKind::Text(LINE);
        /// Meaning of the numbers of colors.
        color_space: ColorSpace = ColorSpace::Display, FieldKind::Word(ColorSpace::WORDS),
            by DocumentSpace;
        /// Implementation of nodes that do not name their own.
        tier: Option<Tier> = None, FieldKind::Word(AUTOMATIC_OR_TIER), by AutomaticTier;
        /// Greatest difference from the exact picture, in numbers of a color, that counts as unseen
        /// where the tier is automatic: 1/255 is a step of a screen. It is estimated at points of a
        /// surface; `chiaro tune` measures pictures.
        max_error: f64 = MAX_ERROR, FieldKind::Number(NumberBounds::new(0.0, 1.0));
        /// Figures that `chiaro tune` measured when it chose tiers.
        tuned: String = String::new(), FieldKind::Text(LINE);
        /// The lights that Light nodes name, by id.
        lights: IndexMap<LightId, Light> = IndexMap::new(),
            FieldKind::Map(&FieldKind::Object(Light::shape), 1000);
        /// Nodes, wires and frames.
        ..graph: Graph;
        /// Groups by id; a node uses one as its kind.
        definitions: IndexMap<DefinitionId, Definition> = IndexMap::new(),
            FieldKind::Map(&FieldKind::Object(Definition::shape), 10_000);
        /// Inputs that scenes, scripts and exported shaders may set.
        exposed: Vec<ExposedValue> = Vec::new(),
            FieldKind::List(&FieldKind::Object(ExposedValue::shape), 10_000);
        /// Outputs that a picture's file can have as layers of their own, by name.
        aovs: Vec<NamedAov> = Vec::new(),
            FieldKind::List(&FieldKind::Object(NamedAov::shape), 1000);
        /// Values that change with a direction.
        direction_keys: Vec<DirectionKeys> = Vec::new(),
            FieldKind::List(&FieldKind::Object(DirectionKeys::shape), 1000);
        /// Values that change with time.
        time_keys: Vec<TimeKeys> = Vec::new(),
            FieldKind::List(&FieldKind::Object(TimeKeys::shape), 10_000);
        /// Times with a name.
        markers: Vec<Marker> = Vec::new(),
            FieldKind::List(&FieldKind::Object(Marker::shape), MAX_MARKERS);
        unknown;
    }
}

impl Look {
    /// Asks every node for a tier, also nodes with a tier of their own, and those in the look's
    /// groups.
    pub fn set_every_tier(&mut self, tier: Tier) {
        self.tier = Some(tier);
        let groups = self.definitions.values_mut().map(|definition| &mut definition.graph);
        for graph in std::iter::once(&mut self.graph).chain(groups) {
            graph.nodes.values_mut().for_each(|node| node.tier = None);
        }
    }
}

/// Color space of the numbers of colors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ColorSpace {
    /// Colors as shown (sRGB-encoded); layers blend as in a painting program.
    #[default]
    Display,
    /// Linear light; colors are encoded to sRGB where a picture is shown or written as PNG.
    Linear,
}

impl Look {
    /// True if the look names lights by sets: a group runs once for each light of one, some lights
    /// do not reach a node or do not pass through it, or a node asks whether a light is of one.
    pub fn names_light_sets(&self) -> bool {
        let inner = self.definitions.values().map(|definition| &definition.graph);
        let mut graphs = std::iter::once(&self.graph).chain(inner);
        let names = |node: &Node| {
            node.for_each.is_some() || !node.links.is_all() || node.kind == LIGHT_IN_SET
        };
        graphs.any(|graph| graph.nodes.values().any(names))
    }
}

described! {
    /// Nodes and the wires between them.
    #[serde(default)]
    pub struct Graph("graph", Lines) {
        /// The nodes of the graph.
        nodes: IndexMap<NodeId, Node> = IndexMap::new(),
            FieldKind::List(&FieldKind::Object(Node::shape), MAX_NODES), by Nodes;
        /// The wires between them.
        wires: Vec<Wire> = Vec::new(), FieldKind::List(&FieldKind::Object(Wire::shape), MAX_WIRES);
        /// Titled frames on the canvas, by id.
        frames: IndexMap<FrameId, Frame> = IndexMap::new(),
            FieldKind::Map(&FieldKind::Object(Frame::shape), 10_000);
        /// Texts on the canvas, by id.
        notes: IndexMap<NoteId, Note> = IndexMap::new(),
            FieldKind::Map(&FieldKind::Object(Note::shape), 10_000);
        /// Views of the canvas that a key brings back.
        bookmarks: Vec<Bookmark> = Vec::new(),
            FieldKind::List(&FieldKind::Object(Bookmark::shape), 9);
    }
}

impl Graph {
    /// Wire that feeds an input, if any.
    pub fn wire_into(&self, node: &NodeId, port: &PortName) -> Option<&Wire> {
        self.wires.iter().find(|wire| wire.to.node == *node && wire.to.port == *port)
    }
}

described! {
    /// A node of a graph.
    #[serde(default)]
    pub struct Node("node", Line) {
        /// Id within the graph, by which wires and keys name the node.
        "id": FieldKind::Slug, words "the kind, if no other node has that id";
        /// A node of the library, or the id of a definition.
        kind: String = String::new(), FieldKind::Text(64), required;
        /// Artist's name of the node; empty for the kind's label.
        name: String = String::new(), FieldKind::Text(LINE);
        /// Place on the canvas, in points, x right and y down.
        position as "at": [f64; 2] = [0.0; 2], CANVAS;
        /// The values of unwired inputs, by port.
        values: Values = Values::new(), FieldKind::Map(&FieldKind::Value, 1000);
        /// Implementation; of a group's node, that of every node in the group.
        tier: Option<Tier> = None, FieldKind::Word(Tier::WORDS),
            words "that of the group's node it lies in, or else the look's";
        /// Lights that a group runs for, once for each: a light that no node in it names is that
        /// one.
        for_each: Option<LightSet> = None, FieldKind::LightSet, words "once, for no light";
        /// Lights that reach the node, and that pass through it.
        ..links: NodeLinks;
        /// True if the node is left out: inputs go out as they are.
        muted: bool = false, FieldKind::Bool;
        /// True if the canvas shows no more than the node's title.
        collapsed: bool = false, FieldKind::Bool;
        unknown;
    }
}

/// Tier: an implementation of a node.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize,
)]
#[serde(rename_all = "lowercase")]
pub enum Tier {
    /// Exact result, as near as f32 comes.
    #[default]
    Exact,
    /// Faster implementation with errors too small to be seen.
    Balanced,
    /// Fastest implementation.
    Fast,
}

described! {
    /// A wire from an output to an input.
    #[derive(Eq, Hash)]
    pub struct Wire("wire", Line, by to) {
        /// The output, `node.port`; `node` alone is its only or first output.
        from: Endpoint, FieldKind::Output, required;
        /// The input, `node.port`.
        to: Endpoint, FieldKind::Input, required;
    }
}

/// Port of a node; written `node.port`.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Endpoint {
    /// Id of the node (inside a definition also `inputs` or `outputs`).
    pub node: NodeId,
    /// Name of the port. In a wire's `from`, an empty name means the node's only or first output.
    pub port: PortName,
}

impl Endpoint {
    /// Endpoint of a node and a port.
    pub fn new(node: impl Into<NodeId>, port: impl Into<PortName>) -> Self {
        Self { node: node.into(), port: port.into() }
    }

    /// Parses the text that [`Display`](std::fmt::Display) writes: `node.port`, or `node` alone.
    pub fn parse(text: &str) -> Self {
        let (node, port) = text.split_once('.').unwrap_or((text, ""));
        Self::new(node, port)
    }
}

impl Serialize for Endpoint {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Endpoint {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer).map(|text| Self::parse(&text))
    }
}

impl std::fmt::Display for Endpoint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.node.as_str())?;
        if !self.port.as_str().is_empty() {
            write!(f, ".{}", self.port)?;
        }
        Ok(())
    }
}

described! {
    /// A titled rectangle behind nodes.
    #[serde(default)]
    pub struct Frame("frame", Line) {
        /// Text on the frame; it names the function that the frame's nodes become.
        title: String = String::new(), FieldKind::Text(LINE);
        /// Straight RGB, as shown.
        color: Vec<f64> = Vec::new(), FieldKind::Color { alpha: false }, words "the theme's own",
            by CanvasColor;
        /// The ids of the nodes in it.
        nodes: Vec<NodeId> = Vec::new(), FieldKind::List(&FieldKind::Slug, MAX_NODES);
    }
}

described! {
    /// A text on the canvas.
    #[serde(default)]
    pub struct Note("note", Line) {
        /// Text of the note.
        text: String = String::new(), FieldKind::Text(LONG);
        /// Place on the canvas, in points, x right and y down.
        position as "at": [f64; 2] = [0.0; 2], CANVAS;
        /// Width, in points.
        width: f64 = Note::WIDTH, FieldKind::Number(NumberBounds::new(40.0, 1e4));
        /// Straight RGB, as shown.
        color: Vec<f64> = Vec::new(), FieldKind::Color { alpha: false }, words "the theme's own",
            by CanvasColor;
    }
}

impl Note {
    /// Default width of a note, in points.
    pub const WIDTH: f64 = 220.0;
}

described! {
    /// A view of the canvas that a key brings back.
    #[derive(Copy)]
    pub struct Bookmark("bookmark", Line, by key) {
        /// The key.
        key: u8, FieldKind::Number(NumberBounds::whole(1.0, 9.0)), required;
        /// The point of the graph at the canvas's center, x right and y down.
        position as "at": [f64; 2] = [0.0; 2], CANVAS;
        /// Points of the screen for each point of the graph.
        zoom: f64 = 1.0, FieldKind::Number(NumberBounds::new(0.001, 1000.0));
    }
}

described! {
    /// A group: a graph with inputs and outputs, used by nodes whose kind is its id.
    #[serde(default)]
    pub struct Definition("definition", Lines) {
        /// Name of the group's nodes; empty for the id.
        label: String = String::new(), FieldKind::Text(LINE);
        /// Description of the group.
        help: String = String::new(), FieldKind::Text(LONG);
        /// Inputs: inside, outputs of the node `inputs`.
        inputs: Vec<InterfacePort> = Vec::new(),
            FieldKind::List(&FieldKind::Object(InterfacePort::shape), 1000);
        /// Outputs: inside, inputs of the node `outputs`.
        outputs: Vec<InterfacePort> = Vec::new(),
            FieldKind::List(&FieldKind::Object(InterfacePort::shape), 1000);
        /// Nodes and wires of the group.
        ..graph: Graph;
        unknown;
    }
}

described! {
    /// An input or output of a group. What is left out comes from the inner port that it is wired
    /// to first.
    #[derive(Default)]
    pub struct InterfacePort("interface port", Line, by name) {
        /// Name of the port.
        name: PortName, FieldKind::Slug, required;
        /// Text beside the socket.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        label: Option<String> = None, FieldKind::Text(LINE), words "the inner port's";
        /// Help of the port.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        help: Option<String> = None, FieldKind::Text(LONG), words "the inner port's";
        /// Value while unwired.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        default: Option<Value> = None, FieldKind::Value, words "the inner port's";
        /// The least value.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        min: Option<f64> = None, FieldKind::Number(F32), words "the inner port's";
        /// The greatest value, not below `min`.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        max: Option<f64> = None, FieldKind::Number(F32), words "the inner port's";
    }
}

described! {
    /// An input that may be set from outside by name.
    pub struct ExposedValue("exposed parameter", Line, by name) {
        /// The parameter's name, used once.
        name: PortName, FieldKind::Slug, required;
        /// Value that the parameter sets.
        target: Target, FieldKind::Target, required;
        /// Text beside the parameter; empty for the port's label.
        label: String = String::new(), FieldKind::Text(LINE);
    }
}

described! {
    /// An output of a node that films ask for by a name of its own.
    pub struct NamedAov("named output", Line, by name) {
        /// Name of the layer, used once.
        name: PortName, FieldKind::Slug, required;
        /// The output, with the groups around its node; without a port the first.
        from: OutputPort, FieldKind::OutputInGroups, required;
    }
}

/// Target of a key or an exposed parameter: an unwired input of a node, `path/to/node.port`, or a
/// field of a light, `lights.key.direction`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// Unwired input, with the groups around its node.
    Input {
        /// Path of the node.
        node: NodePath,
        /// Name of the input.
        port: PortName,
    },
    /// A [`LightField`] of a light.
    Light {
        /// Id of the light.
        light: LightId,
        /// Name of the field.
        field: String,
    },
}

impl std::fmt::Display for Target {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Input { node, port } => write!(f, "{node}.{port}"),
            Self::Light { light, field } => write!(f, "lights.{light}.{field}"),
        }
    }
}

impl Serialize for Target {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Target {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Self::parse(&text).ok_or_else(|| serde::de::Error::custom(tr!("`{text}` is no target")))
    }
}

impl Target {
    /// Field of a light that the target names; `None` for an input, or an unknown field.
    pub fn light_field(&self) -> Option<LightField> {
        match self {
            Self::Light { field, .. } => LightField::named(field),
            Self::Input { .. } => None,
        }
    }

    /// Parses the text that [`Display`](std::fmt::Display) writes; `None` where there is no `.`.
    pub fn parse(text: &str) -> Option<Self> {
        if let Some((light, field)) =
            text.strip_prefix("lights.").and_then(|rest| rest.split_once('.'))
        {
            return Some(Self::Light { light: light.into(), field: field.into() });
        }
        let (node, port) = text.rsplit_once('.')?;
        let node = NodePath::parse(node);
        (!node.ids().is_empty() && !port.is_empty())
            .then(|| Self::Input { node, port: port.into() })
    }
}

described! {
    /// Values pinned at directions and interpolated over the sphere between them.
    pub struct DirectionKeys("direction keys", Lines) {
        /// Name that the artist gave.
        name: String = String::new(), FieldKind::Text(LINE);
        /// Direction that decides, or numbers: see [drivers](#drivers).
        by: KeyDirection, FieldKind::KeyDirection, required, by DecidedBy;
        /// Scheme by which weights are computed.
        scheme: KeyScheme = KeyScheme::Biharmonic, FieldKind::Word(KeyScheme::WORDS);
        /// The keys.
        keys: Vec<DirectionKey> = Vec::new(),
            FieldKind::List(&FieldKind::Object(DirectionKey::shape), 1000);
        unknown;
    }
}

/// Direction, or numbers, that decide between direction keys.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum KeyDirection {
    /// Direction toward a light, in camera axes (x right, y up, z toward the viewer).
    Light(LightId),
    /// Direction from the object's center to the eye, in world space.
    View,
    /// One to three numbers in place of a direction: the axes of the space that the keys lie in.
    Drivers(Vec<Driver>),
}

impl KeyDirection {
    /// Number of drivers that decide; `None` for a direction.
    pub fn axes(&self) -> Option<usize> {
        match self {
            Self::Drivers(drivers) => Some(drivers.len()),
            Self::Light(_) | Self::View => None,
        }
    }

    /// Lights that the keys depend on.
    pub fn lights(&self) -> Vec<&LightId> {
        match self {
            Self::Light(light) => vec![light],
            Self::View => Vec::new(),
            Self::Drivers(drivers) => drivers.iter().filter_map(Driver::light).collect(),
        }
    }

    /// Outputs of nodes that the keys depend on.
    pub fn outputs(&self) -> impl Iterator<Item = &OutputPort> {
        let drivers = if let Self::Drivers(drivers) = self { drivers.as_slice() } else { &[] };
        drivers.iter().filter_map(Driver::output)
    }
}

/// Driver: a number of the scene that decides between keys.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Driver {
    /// Distance from the eye to the object's center, in scene units.
    Distance,
    /// Angle between the object's front (its z axis) and the direction to the eye, in radians: 0
    /// seen from the front, pi from behind.
    Facing,
    /// Height of a light over the horizon as the object sees it, in radians: pi/2 straight above, 0
    /// at the horizon.
    Height(LightId),
    /// Distance from this object's center to another object's, in scene units.
    Near(ObjectId),
    /// Value of a node's output that is one number for the whole object.
    Wire(OutputPort),
}

impl Driver {
    /// Greatest number of drivers that decide together.
    pub const MOST: usize = 3;

    /// Light that the driver depends on.
    pub fn light(&self) -> Option<&LightId> {
        if let Self::Height(light) = self { Some(light) } else { None }
    }

    /// Output that the driver depends on.
    pub fn output(&self) -> Option<&OutputPort> {
        if let Self::Wire(output) = self { Some(output) } else { None }
    }

    /// True for a driver whose value is an angle, in radians.
    pub fn is_angle(&self) -> bool {
        matches!(self, Self::Facing | Self::Height(_))
    }
}

/// Output of a node, with the groups around it; written `node.port`, `group/node.port`, or `node`
/// for its first output.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct OutputPort {
    /// Path of the node.
    pub node: NodePath,
    /// Name of the output; empty for the first.
    pub port: PortName,
}

impl OutputPort {
    /// Parses the text that [`Display`](std::fmt::Display) writes; `None` where no node is named.
    pub fn parse(text: &str) -> Option<Self> {
        let (node, port) = text.rsplit_once('.').unwrap_or((text, ""));
        let node = NodePath::parse(node);
        (!node.ids().is_empty()).then(|| Self { node, port: port.into() })
    }
}

impl std::fmt::Display for OutputPort {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.node)?;
        if self.port.as_str().is_empty() { Ok(()) } else { write!(f, ".{}", self.port) }
    }
}

impl Serialize for OutputPort {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for OutputPort {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Self::parse(&text).ok_or_else(|| serde::de::Error::custom(tr!("`{text}` is no output")))
    }
}

/// Scheme by which the weights of direction keys are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum KeyScheme {
    /// Biharmonic functions of the sphere in closed form.
    #[default]
    Biharmonic,
    /// Continuum limit of the energy of BADF Appendix B, in closed form.
    AppendixB,
    /// Least squares over a tessellated sphere, as in the paper; for comparison.
    Tessellated,
}

described! {
    /// Values at one direction.
    pub struct DirectionKey("direction key", Line) {
        /// Direction of the key, unless drivers decide; any length but 0. By a light: in camera
        /// axes (x right, y up, z toward the viewer). By view: from the object's center to the eye,
        /// in world space.
        direction: [f64; 3], FieldKind::Direction, words "required, unless drivers decide",
            by KeyPlace;
        /// Place of the key, if drivers decide: a number for each, in their order.
        "at": FieldKind::Numbers(1, 3, FAR), words "required, if drivers decide";
        /// The values there, by target; what is left out has the look's own value.
        values: IndexMap<Target, Value> = IndexMap::new(), FieldKind::TargetValues, by TargetValues;
        unknown;
    }
}
