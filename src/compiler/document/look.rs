//! A look: one shading graph with its lights, its groups and its keys.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::LightField;
use super::value::{Interpolation, Value, Values};
use crate::ids::{DefinitionId, FrameId, LightId, NodeId, NodePath, NoteId, ObjectId, PortName};

/// Fields that this version does not know. They survive a save, and loading warns about them.
///
/// Parts without an `unknown` of their own (lights, wires, a curve) leave theirs to what they
/// belong to: under the name of its field and what tells the part apart (an id, a wire's input),
/// e.g. `{"lights": {"key": {"flare": 2}}}`.
pub type Unknown = serde_json::Map<String, serde_json::Value>;

/// One shading graph; compiles to one WGSL module.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Look {
    /// What the artist calls it.
    pub name: String,
    /// What it shows and how it is built: a paragraph for who finds it.
    pub about: String,
    /// What the colors mean.
    pub color_space: ColorSpace,
    /// Which implementation is asked for of nodes that do not say their own.
    pub tier: Tier,
    /// What `chiaro tune` measured when it chose tiers; empty where it did not.
    pub tuned: String,
    /// Nodes, wires and frames.
    pub graph: Graph,
    /// The lights that Light nodes name.
    pub lights: IndexMap<LightId, Light>,
    /// Groups, used by nodes whose kind is the definition's id.
    pub definitions: IndexMap<DefinitionId, Definition>,
    /// The inputs that scenes, scripts and exported shaders may set.
    pub exposed: Vec<Exposed>,
    /// Values that change with the direction of a light or of the view.
    pub direction_keys: Vec<DirectionKeys>,
    /// Values that change with time.
    pub time_keys: Vec<TimeKeys>,
    /// Fields of later versions or of other programs.
    pub unknown: Unknown,
}

impl Look {
    /// Asks every node for a tier, also those that say their own, and those in the look's groups.
    pub fn set_every_tier(&mut self, tier: Tier) {
        self.tier = tier;
        let groups = self.definitions.values_mut().map(|definition| &mut definition.graph);
        for graph in std::iter::once(&mut self.graph).chain(groups) {
            graph.nodes.values_mut().for_each(|node| node.tier = None);
        }
    }
}

/// What the numbers of a color mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ColorSpace {
    /// As they are shown (sRGB-encoded); layers blend as in a painting program.
    #[default]
    Display,
    /// Linear light; encoded to sRGB where a picture is shown or written as PNG.
    Linear,
}

/// Nodes and the wires between them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Graph {
    /// In document order.
    pub nodes: IndexMap<NodeId, Node>,
    /// In document order.
    pub wires: Vec<Wire>,
    /// Titled frames on the canvas.
    pub frames: IndexMap<FrameId, Frame>,
    /// Texts on the canvas.
    pub notes: IndexMap<NoteId, Note>,
    /// Views of the canvas that a key brings back.
    pub bookmarks: Vec<Bookmark>,
}

impl Graph {
    /// The wire that feeds an input, if any.
    pub fn wire_into(&self, node: &NodeId, port: &PortName) -> Option<&Wire> {
        self.wires.iter().find(|wire| wire.to.node == *node && wire.to.port == *port)
    }
}

/// One node of a graph.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Node {
    /// A node of the library, or the id of a definition.
    pub kind: String,
    /// The artist's name, used in the generated source; empty for the kind's label.
    pub name: String,
    /// Where it lies on the canvas, in points, x right and y down.
    pub position: [f64; 2],
    /// The values of unwired inputs; what is left out has the node's default.
    pub values: Values,
    /// Which implementation is asked for; unset, as what the node lies in: its group's node, or
    /// else the look.
    pub tier: Option<Tier>,
    /// Whether it is left out: what comes in goes out as it is.
    pub muted: bool,
    /// Whether the canvas shows no more of it than its title.
    pub collapsed: bool,
    /// Fields of later versions or of other programs.
    #[serde(default, skip_serializing_if = "Unknown::is_empty")]
    pub unknown: Unknown,
}

/// One implementation of a node.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize,
)]
#[serde(rename_all = "lowercase")]
pub enum Tier {
    /// The truth, as near as f32 comes.
    #[default]
    Exact,
    /// Errors below what is seen, where that is faster.
    Balanced,
    /// The least time.
    Fast,
}

/// A wire from an output to an input.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Wire {
    /// The output.
    pub from: Endpoint,
    /// The input.
    pub to: Endpoint,
}

/// A port of a node; written `node.port`.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Endpoint {
    /// The node (inside a definition also `inputs` or `outputs`).
    pub node: NodeId,
    /// The port. In a wire's `from`, an empty name means the node's only or first output.
    pub port: PortName,
}

impl Endpoint {
    /// A port of a node.
    pub fn new(node: impl Into<NodeId>, port: impl Into<PortName>) -> Self {
        Self { node: node.into(), port: port.into() }
    }

    /// Reads what [`Display`](std::fmt::Display) writes: `node.port`, or `node` alone.
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

/// A titled rectangle behind nodes. Long looks become functions at frames, named by their titles.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Frame {
    /// What is written on it.
    pub title: String,
    /// Straight RGB; empty for the theme's own.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub color: Vec<f64>,
    /// The nodes in it; the rectangle is drawn around them.
    pub nodes: Vec<NodeId>,
}

/// A text on the canvas.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Note {
    /// What it says; lines end where the text says so, or at the width.
    pub text: String,
    /// Where its corner lies, in points, x right and y down.
    pub position: [f64; 2],
    /// How wide it is, in points.
    pub width: f64,
    /// Straight RGB; empty for the theme's own.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub color: Vec<f64>,
}

impl Note {
    /// How wide a note is that does not say it.
    pub const WIDTH: f64 = 220.0;
}

impl Default for Note {
    fn default() -> Self {
        Self { text: String::new(), position: [0.0; 2], width: Self::WIDTH, color: Vec::new() }
    }
}

/// A view of the canvas that a key brings back.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bookmark {
    /// The key, 1 to 9.
    pub key: u8,
    /// The point of the graph at the canvas's centre.
    pub position: [f64; 2],
    /// Points of the screen for each point of the graph.
    pub zoom: f64,
}

/// A group: a graph with an interface, opened and edited as a graph, used by any number of nodes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Definition {
    /// What a node of this group is called; empty for the id.
    pub label: String,
    /// What it does, for the library and the inspector.
    pub help: String,
    /// Its inputs, outputs of the pseudo node `inputs`.
    pub inputs: Vec<InterfacePort>,
    /// Its outputs, inputs of the pseudo node `outputs`.
    pub outputs: Vec<InterfacePort>,
    /// What is in it.
    pub graph: Graph,
    /// Fields of later versions or of other programs.
    #[serde(default, skip_serializing_if = "Unknown::is_empty")]
    pub unknown: Unknown,
}

/// A port of a group. Whatever is left out comes from the inner port that it is wired to first.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct InterfacePort {
    /// The port's name.
    pub name: PortName,
    /// What is written beside the socket.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// What is said about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub help: Option<String>,
    /// Its value while unwired.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub default: Option<Value>,
    /// The least value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// The greatest value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
}

/// A light. Turning the illumination frame turns every light in it together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Light {
    /// The artist's name; empty for the id.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Directional, point or spot.
    #[serde(rename = "type")]
    pub kind: LightKind,
    /// The frame that `direction`, `position` and `aim` are given in.
    pub space: LightSpace,
    /// Directional lights: toward the light; any length but 0.
    pub direction: [f64; 3],
    /// Point and spot lights: where the light is, in scene units.
    pub position: [f64; 3],
    /// Spot lights: the way the light shines, from the light outward; any length but 0.
    pub aim: [f64; 3],
    /// Spot lights: the half-angle of the full cone, in radians.
    pub inner: f64,
    /// Spot lights: the half-angle at which nothing is left, in radians.
    pub outer: f64,
    /// Straight RGB in the look's color space.
    pub color: [f64; 3],
    /// A factor, 0 or more.
    pub intensity: f64,
    /// Point and spot lights: the distance at which half the intensity is left; 0 for no fading.
    pub half_distance: f64,
    /// Point and spot lights: the distance beyond which nothing is left; 0 for no end.
    pub range: f64,
}

impl Default for Light {
    fn default() -> Self {
        Self {
            name: String::new(),
            kind: LightKind::Directional,
            space: LightSpace::Illumination,
            direction: [0.0, 0.0, 1.0],
            position: [0.0, 0.0, 3.0],
            aim: [0.0, 0.0, -1.0],
            inner: 0.35,
            outer: 0.5,
            color: [1.0; 3],
            intensity: 1.0,
            half_distance: 0.0,
            range: 0.0,
        }
    }
}

/// What a light is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LightKind {
    /// The same direction everywhere, as in the BADF paper.
    #[default]
    Directional,
    /// At a position, shining everywhere.
    Point,
    /// At a position, shining into a cone.
    Spot,
}

/// The frame a light's vectors are given in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LightSpace {
    /// The illumination frame: the BADF paper's L.
    #[default]
    Illumination,
    /// The world.
    World,
    /// The camera: x right, y up, z toward the viewer.
    Camera,
}

/// An input that scenes, scripts and exported shaders may set by name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Exposed {
    /// The parameter's name, a slug.
    pub name: PortName,
    /// The input that it sets.
    pub target: Target,
    /// What is written beside it; empty for the port's label.
    pub label: String,
}

/// Something that a key or an exposed parameter sets: an unwired input of a node,
/// `path/to/node.port`, or a field of a light, `lights.key.direction`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// An unwired input, through the groups it lies in.
    Input {
        /// The node.
        node: NodePath,
        /// Its input.
        port: PortName,
    },
    /// A [`LightField`] of a light.
    Light {
        /// The light.
        light: LightId,
        /// Its field.
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
        Self::parse(&text).ok_or_else(|| serde::de::Error::custom(format!("`{text}` is no target")))
    }
}

impl Target {
    /// The field of a light that a target names; `None` of an input, or where there is no such
    /// field.
    pub fn light_field(&self) -> Option<LightField> {
        match self {
            Self::Light { field, .. } => LightField::named(field),
            Self::Input { .. } => None,
        }
    }

    /// Reads what [`Display`](std::fmt::Display) writes; `None` where there is no `.`.
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

/// Values pinned at directions and interpolated over the sphere between them (BADF 3.4).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DirectionKeys {
    /// What the artist calls it.
    pub name: String,
    /// Which direction decides.
    pub by: KeyDirection,
    /// How weights are computed.
    pub scheme: KeyScheme,
    /// The keys; where a key leaves a target out, it has the look's own value there.
    pub keys: Vec<DirectionKey>,
    /// Fields of later versions or of other programs.
    #[serde(default, skip_serializing_if = "Unknown::is_empty")]
    pub unknown: Unknown,
}

/// Which direction decides between direction keys.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum KeyDirection {
    /// The direction toward a light, in camera axes (x right, y up, z toward the viewer).
    Light(LightId),
    /// The direction from the object's centre to the eye, in world space.
    View,
    /// No direction but one to three numbers, the axes of the space that the keys lie in.
    Drivers(Vec<Driver>),
}

impl KeyDirection {
    /// How many drivers decide; `None` where it is a direction.
    pub fn axes(&self) -> Option<usize> {
        match self {
            Self::Drivers(drivers) => Some(drivers.len()),
            Self::Light(_) | Self::View => None,
        }
    }

    /// The lights that it reads.
    pub fn lights(&self) -> Vec<&LightId> {
        match self {
            Self::Light(light) => vec![light],
            Self::View => Vec::new(),
            Self::Drivers(drivers) => drivers.iter().filter_map(Driver::light).collect(),
        }
    }

    /// The outputs of nodes that it reads.
    pub fn outputs(&self) -> impl Iterator<Item = &OutputPort> {
        let drivers = if let Self::Drivers(drivers) = self { drivers.as_slice() } else { &[] };
        drivers.iter().filter_map(Driver::output)
    }
}

/// A number of the scene that decides between keys.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Driver {
    /// From the eye to the object's centre, scene units.
    Distance,
    /// The angle between the object's front (its z axis) and the direction to the eye: 0 seen from
    /// the front, pi from behind.
    Facing,
    /// How high a light stands over the horizon as the object sees it, radians: pi/2 straight
    /// above, 0 at the horizon.
    Height(LightId),
    /// From this object's centre to another one's, scene units.
    Near(ObjectId),
    /// What an output of a node gives, where that is one number for the whole object.
    Wire(OutputPort),
}

impl Driver {
    /// As many as decide together at most.
    pub const MOST: usize = 3;

    /// The light that it reads.
    pub fn light(&self) -> Option<&LightId> {
        if let Self::Height(light) = self { Some(light) } else { None }
    }

    /// The output that it reads.
    pub fn output(&self) -> Option<&OutputPort> {
        if let Self::Wire(output) = self { Some(output) } else { None }
    }

    /// Whether its value is an angle, in radians.
    pub fn is_angle(&self) -> bool {
        matches!(self, Self::Facing | Self::Height(_))
    }
}

/// An output of a node, through the groups it lies in; written `node.port`, `group/node.port`, or
/// `node` for its first output.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct OutputPort {
    /// The node.
    pub node: NodePath,
    /// Its output; empty for the first.
    pub port: PortName,
}

impl OutputPort {
    /// Reads what [`Display`](std::fmt::Display) writes; `None` where no node is named.
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
        Self::parse(&text).ok_or_else(|| serde::de::Error::custom(format!("`{text}` is no output")))
    }
}

/// How the weights of direction keys are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum KeyScheme {
    /// The sphere's biharmonic functions in closed form.
    #[default]
    Biharmonic,
    /// The continuum limit of the energy of BADF Appendix B, in closed form.
    AppendixB,
    /// The paper's own least squares over a tessellated sphere; for comparison.
    Tessellated,
}

/// One key of [`DirectionKeys`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DirectionKey {
    /// Where; any length but 0. Of drivers: their values, with 0 for those that are not there.
    pub direction: [f64; 3],
    /// The values there.
    pub values: IndexMap<Target, Value>,
    /// Fields of later versions or of other programs.
    #[serde(default, skip_serializing_if = "Unknown::is_empty")]
    pub unknown: Unknown,
}

/// The values of one target over time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimeKeys {
    /// What changes.
    pub target: Target,
    /// In increasing time.
    pub keys: Vec<TimeKey>,
    /// Fields of later versions or of other programs.
    #[serde(default, skip_serializing_if = "Unknown::is_empty")]
    pub unknown: Unknown,
}

/// One key of [`TimeKeys`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimeKey {
    /// In seconds.
    pub time: f64,
    /// The value then.
    pub value: Value,
    /// How it goes on to the next key.
    pub interpolation: Interpolation,
    /// Fields of later versions or of other programs.
    #[serde(default, skip_serializing_if = "Unknown::is_empty")]
    pub unknown: Unknown,
}
