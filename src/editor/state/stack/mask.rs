//! Masks of layers: a *Mask* node in a layer's opacity, and what says where the layer is shown.

use std::collections::{HashMap, HashSet};

use chiaro_locale::{Text, text};
use glam::{DQuat, DVec2, DVec3};

use super::tree::LayerTree;
use super::{STEP, Stack};
use crate::catalog::Catalog;
use crate::document::{Edit, Endpoint, GraphId, Look, Node, Value, Wire};
use crate::drawing::{NODE_WIDTH, node_height};
use crate::ids::{NodeId, PortName, make_slug};
use crate::state::masks::{MaskLaying, StraightLaying};

/// Kind of the node, and its inputs.
const MASK: &str = "mask";
pub(crate) const SHOWN: &str = "mask";
pub(crate) const OPACITY: &str = "opacity";
pub(crate) const INVERTED: &str = "inverted";
/// Kind of the node that reads the colors of a mesh's points.
pub(crate) const VERTEX_COLOR: &str = "vertex_color";
/// Input of a plain layer that says where it is.
const TONE: &str = "tone";
/// Outputs of layers that say where they are.
const TONES: [&str; 4] = [TONE, "ink", "line", "shadow"];
/// Kinds of the nodes by which several outputs become one coverage.
const PRODUCT: &str = "multiply";
const GREATEST: &str = "maximum";
/// Distance of what feeds a mask from the layer, downward, in points.
const DROP: f64 = 240.0;
/// Step from row to row in which a free place is looked for, in points, and the number of steps.
const STEP_DOWN: f64 = 60.0;
const MOST_STEPS_DOWN: u32 = 200;
/// Greatest numbers of rows of nodes that masks are made of, and of what else there is; the few
/// that are larger may be overlapped.
const MOST_ROWS: usize = 10;
const MOST_ROWS_OF_OTHERS: usize = 22;

/// Source of a mask that a menu offers.
pub(crate) struct MaskSource {
    pub(crate) name: Text,
    pub(crate) help: Text,
    /// Nodes from the source to the mask, each with its values; every one but the first is fed by
    /// the one before.
    chain: &'static [SourceNode],
    /// True if the stack below the layer feeds the first node.
    is_of_stack: bool,
}

/// Node of a source.
struct SourceNode {
    kind: &'static str,
    /// Input that the node before feeds.
    input: &'static str,
    /// Output that feeds the next node; empty for the first.
    output: &'static str,
    numbers: &'static [(&'static str, f64)],
    /// True for a picture that is laid over the sphere around the object.
    is_framed: bool,
    words: &'static [(&'static str, &'static str)],
}

impl SourceNode {
    const fn of(kind: &'static str, input: &'static str) -> Self {
        Self { kind, input, output: "", numbers: &[], is_framed: false, words: &[] }
    }
}

/// Sources, the ones that painters reach for first.
pub(crate) static SOURCES: [MaskSource; 9] = [
    MaskSource {
        name: text!("A picture"),
        help: text!(
            "White shows the layer, black hides it; painted over the mesh's UVs in any paint \
             program. Choose the file in the inspector"
        ),
        chain: &[SourceNode { words: &[("encoding", "data")], ..SourceNode::of("image", "") }],
        is_of_stack: false,
    },
    MaskSource {
        name: text!("A picture from the front"),
        help: text!(
            "Laid straight through the object as it stands, seen from the front, which needs no \
             UVs; the image's Scale and Offset move it. It stays where it is when the object moves"
        ),
        chain: &[
            SourceNode::of("position", ""),
            SourceNode {
                is_framed: true,
                words: &[("encoding", "data"), ("wrap", "clamp")],
                ..SourceNode::of("image", "uv")
            },
        ],
        is_of_stack: false,
    },
    MaskSource {
        name: text!("A picture on the screen"),
        help: text!("Lies on the whole picture, as the camera sees it, and needs no UVs"),
        chain: &[
            SourceNode { output: "uv", ..SourceNode::of("screen_place", "") },
            SourceNode { words: &[("encoding", "data")], ..SourceNode::of("image", "uv") },
        ],
        is_of_stack: false,
    },
    MaskSource {
        name: text!("Vertex colors"),
        help: text!("The brightness of the colors that were painted on the mesh's points"),
        chain: &[SourceNode::of(VERTEX_COLOR, ""), SourceNode::of("color_luminance", "color")],
        is_of_stack: false,
    },
    MaskSource {
        name: text!("Brightness below"),
        help: text!(
            "How bright the layers below are: from black, which hides, to white; Low and High say \
             where it begins and ends"
        ),
        chain: &[
            SourceNode::of("color_luminance", "color"),
            SourceNode::of("smooth_step_value", "value"),
        ],
        is_of_stack: true,
    },
    MaskSource {
        name: text!("What faces the eye"),
        help: text!("The middle of forms; inverted, their rims"),
        chain: &[SourceNode::of("facing", ""), SourceNode::of("smooth_step_value", "value")],
        is_of_stack: false,
    },
    MaskSource {
        name: text!("One object"),
        help: text!("The object of this number in the scene, counted from 0"),
        chain: &[
            SourceNode::of("object_id", ""),
            SourceNode {
                numbers: &[("b", 0.0), ("epsilon", 0.5)],
                words: &[("test", "equal")],
                ..SourceNode::of("compare", "a")
            },
        ],
        is_of_stack: false,
    },
    MaskSource {
        name: text!("Noise"),
        help: text!("Clouds over the surface, which stay on it"),
        chain: &[
            SourceNode { numbers: &[("octaves", 4.0)], ..SourceNode::of("noise", "") },
            SourceNode {
                numbers: &[("low", 0.45), ("high", 0.55)],
                ..SourceNode::of("smooth_step_value", "value")
            },
        ],
        is_of_stack: false,
    },
    MaskSource {
        name: text!("Nothing yet"),
        help: text!("A white mask, which hides nothing until a wire or a number says what"),
        chain: &[],
        is_of_stack: false,
    },
];

/// The node that masks a layer.
pub(crate) fn of<'l>(look: &'l Look, layer: &NodeId) -> Option<(&'l NodeId, &'l Node)> {
    let wire = look.graph.wire_into(layer, &PortName::new(OPACITY))?;
    let (id, node) = look.graph.nodes.get_key_value(&wire.from.node)?;
    (node.kind == MASK).then_some((id, node))
}

/// True if a layer can have a mask, and has none: its opacity is a value.
pub(crate) fn is_free(look: &Look, catalog: &Catalog, layer: &NodeId) -> bool {
    let node = look.graph.nodes.get(layer);
    let kind = node.and_then(|node| catalog.of(node));
    let takes = kind.is_some_and(|kind| kind.input(OPACITY).is_some());
    takes && look.graph.wire_into(layer, &PortName::new(OPACITY)).is_none()
}

/// The output that says where a layer is: its tone, or what is wired into it.
fn tone_of(look: &Look, catalog: &Catalog, layer: &NodeId) -> Option<Endpoint> {
    let kind = catalog.of(look.graph.nodes.get(layer)?)?;
    if let Some(tone) = TONES.iter().find(|name| kind.output(name).is_some()) {
        return Some(Endpoint::new(layer.clone(), *tone));
    }
    look.graph.wire_into(layer, &PortName::new(TONE)).map(|wire| wire.from.clone())
}

/// Region in which a layer, or a folder of layers, is: the greatest of products of outputs. A
/// product of nothing is everywhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Coverage(Vec<Vec<Endpoint>>);

impl Coverage {
    /// True for a region that leaves nothing out, or for that of an empty folder, which is nowhere.
    pub(crate) fn is_idle(&self) -> bool {
        self.0.is_empty() || self.0.iter().any(Vec::is_empty)
    }

    fn outputs(&self) -> impl Iterator<Item = &Endpoint> {
        self.0.iter().flatten()
    }
}

/// Clipping of a layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Clip {
    /// Layer or folder below that the layer is clipped to.
    pub(crate) base: NodeId,
    /// True for a folder that has got further layers since.
    pub(crate) is_stale: bool,
}

impl LayerTree {
    /// Region in which a layer is: its tone, within its mask; of a folder all that its layers have.
    fn coverage(&self, look: &Look, catalog: &Catalog, layer: &NodeId) -> Coverage {
        let mut products = Vec::new();
        let mut open = vec![(layer.clone(), Vec::new())];
        while let Some((id, mut product)) = open.pop() {
            let masked = look.graph.wire_into(&id, &PortName::new(OPACITY));
            product.extend(masked.map(|wire| wire.from.clone()));
            match self.layers_in(&id) {
                Some(inner) => open.extend(inner.rev().map(|id| (id.clone(), product.clone()))),
                None if self.is_adjustment(&id) => {}
                None => {
                    product.splice(0..0, tone_of(look, catalog, &id));
                    products.push(product);
                }
            }
        }
        Coverage(products)
    }

    /// Other layers, and folders, that can mask a layer, from the top, each with its region.
    pub(crate) fn coverages(
        &self,
        look: &Look,
        catalog: &Catalog,
        layer: &NodeId,
    ) -> Vec<(NodeId, Coverage)> {
        // What depends on the layer itself would close a ring.
        let above = dependents(look, layer);
        let others = self.rows(|_| false).into_iter().filter(|row| row.id != *layer);
        let found = others.filter_map(|other| {
            let coverage = self.coverage(look, catalog, &other.id);
            let is_free = !coverage.outputs().any(|output| above.contains(&output.node));
            (is_free && !coverage.is_idle()).then_some((other.id, coverage))
        });
        found.collect()
    }

    /// The layer or folder that a layer can be clipped to, and its region: the one below, or below
    /// those that are clipped themselves, as paint programs have it.
    pub(crate) fn clipping(
        &self,
        look: &Look,
        catalog: &Catalog,
        layer: &NodeId,
    ) -> Option<(NodeId, Coverage)> {
        let stack = self.stack_of(layer)?;
        let mut below = stack.layers.get(stack.index_of(layer)? + 1..)?.iter();
        let base = below.find(|below| {
            !below.is_adjustment() && self.clip_of(look, catalog, &below.id).is_none()
        })?;
        self.coverages(look, catalog, layer).into_iter().find(|(id, _)| *id == base.id)
    }

    /// The clipping of a layer whose mask comes from a layer or folder below alone.
    pub(crate) fn clip_of(&self, look: &Look, catalog: &Catalog, layer: &NodeId) -> Option<Clip> {
        let (mask, _) = of(look, layer)?;
        let source = &look.graph.wire_into(mask, &PortName::new(SHOWN))?.from;
        let stack = self.stack_of(layer)?;
        let below = stack.layers.get(stack.index_of(layer)? + 1..)?;
        below.iter().find_map(|below| {
            let base = below.id.clone();
            let coverage = self.coverage(look, catalog, &base);
            let known: HashSet<&Endpoint> = coverage.outputs().collect();
            let used = made_of(look, source, &known).filter(|used| !used.is_empty())?;
            Some(Clip { base, is_stale: used.len() < known.len() })
        })
    }

    /// The edit that clips a layer anew to all that is in its folder now.
    pub(crate) fn clip_anew(
        &self,
        look: &Look,
        catalog: &Catalog,
        (layer, clip): (&NodeId, &Clip),
    ) -> Option<Edit> {
        let freed = self.stack_of(layer)?.unmask(look, layer)?;
        let mut now = look.clone();
        now.apply(freed.clone()).ok()?;
        let coverage = self.coverage(look, catalog, &clip.base);
        let (_, clipped) = Stack::mask_by(&now, layer, &coverage);
        Some(Edit::Group { edits: vec![freed, clipped] })
    }
}

/// The known outputs that an output is, or is the product or the greatest of; `None` where
/// anything else counts.
fn made_of<'l>(
    look: &'l Look,
    output: &'l Endpoint,
    known: &HashSet<&Endpoint>,
) -> Option<HashSet<&'l Endpoint>> {
    let (mut open, mut seen) = (vec![output], HashSet::new());
    let mut used = HashSet::new();
    while let Some(output) = open.pop() {
        if known.contains(output) {
            used.insert(output);
        } else if seen.insert(&output.node) {
            let kind = look.graph.nodes.get(&output.node).map(|node| node.kind.as_str());
            kind.filter(|kind| [PRODUCT, GREATEST].contains(kind))?;
            let sources = look.graph.wires.iter().filter(|wire| wire.to.node == output.node);
            open.extend(sources.map(|wire| &wire.from));
        }
    }
    Some(used)
}

impl Stack {
    /// Masks a layer by a source; `around` is the sphere around the object, in world space. Returns
    /// the new mask's id with the edit.
    pub(crate) fn mask(
        &self,
        look: &Look,
        layer: &NodeId,
        (source, around): (&MaskSource, (DVec3, f64)),
    ) -> (NodeId, Edit) {
        let mut making = MaskEdits::new(look, layer);
        let mut from = source.is_of_stack.then(|| self.below(layer)).flatten();
        let count = source.chain.len();
        for (place, part) in source.chain.iter().enumerate() {
            let numbers = part.numbers.iter().map(|(port, x)| (*port, Value::Number(*x)));
            let framed = part.is_framed.then(|| frame(around)).into_iter().flatten();
            let words = part.words.iter().map(|(port, word)| (*port, Value::Text((*word).into())));
            let values = numbers.chain(framed).chain(words);
            let id = making.node(part.kind, values, count - place);
            if let Some(from) = from {
                making.wire(from, &id, part.input);
            }
            from = Some(Endpoint::new(id, part.output));
        }
        making.finish(from)
    }

    /// Masks a layer by where others are. Returns the new mask's id with the edit.
    pub(crate) fn mask_by(look: &Look, layer: &NodeId, coverage: &Coverage) -> (NodeId, Edit) {
        let mut making = MaskEdits::new(look, layer);
        let products = coverage.0.iter().map(|product| product.len().saturating_sub(1));
        let mut columns = products.sum::<usize>() + coverage.0.len().saturating_sub(1);
        let mut greatest: Option<Endpoint> = None;
        for product in &coverage.0 {
            let mut outputs = product.iter().cloned();
            let Some(mut part) = outputs.next() else { continue };
            for other in outputs {
                part = making.joined(PRODUCT, [part, other], &mut columns);
            }
            greatest = Some(match greatest {
                None => part,
                Some(before) => making.joined(GREATEST, [before, part], &mut columns),
            });
        }
        making.finish(greatest)
    }

    /// Masks a layer by a picture beside the look. Returns the new mask's id with the edit.
    pub(crate) fn mask_by_picture(
        look: &Look,
        layer: &NodeId,
        (file, laying): (&str, &MaskLaying),
    ) -> (NodeId, Edit) {
        let mut making = MaskEdits::new(look, layer);
        let text = |text: &str| Value::Text(text.to_owned());
        let mut values = vec![("image", text(file)), ("encoding", text("data"))];
        let place = match laying {
            MaskLaying::Uvs => None,
            MaskLaying::Straight(laying) => {
                values.push(("wrap", text("clamp")));
                values.extend(placed(laying));
                Some(making.turned_place(laying))
            }
        };
        let image = making.node("image", values.into_iter(), 1);
        if let Some(place) = place {
            making.wire(place, &image, "uv");
        }
        making.finish(Some(Endpoint::new(image, "")))
    }

    /// Takes a layer's mask away, with what feeds it and nothing else, and gives the layer its
    /// opacity back.
    pub(crate) fn unmask(&self, look: &Look, layer: &NodeId) -> Option<Edit> {
        let (mask, node) = of(look, layer)?;
        // Another mask may give this one its opacity.
        let further = look.graph.wire_into(mask, &PortName::new(OPACITY));
        let kept = further.map_or(Vec::new(), |wire| self.with_own(look, &wire.from.node));
        let own = self.with_own(look, mask).into_iter().filter(|id| !kept.contains(id));
        let mut edits: Vec<Edit> =
            own.map(|id| Edit::RemoveNode { graph: GraphId::Look, id }).collect();
        let (id, port) = (layer.clone(), PortName::new(OPACITY));
        if let Some(further) = further {
            let wire = Wire { from: further.from.clone(), to: Endpoint { node: id, port } };
            edits.push(Edit::AddWire { graph: GraphId::Look, wire, index: None });
        } else if let Some(value) = node.values.get(OPACITY).cloned() {
            edits.push(Edit::SetValue { graph: GraphId::Look, id, port, value, index: None });
        } else if look.graph.nodes.get(layer).is_some_and(|node| node.values.contains_key(&port)) {
            edits.push(Edit::ClearValue { graph: GraphId::Look, id, port });
        }
        Some(Edit::Group { edits })
    }

    /// The output that a layer lies on.
    fn below(&self, layer: &NodeId) -> Option<Endpoint> {
        let next = self.index_of(layer)? + 1;
        self.layers.get(next).map(|layer| &layer.outlet).or(self.ground.as_ref()).cloned()
    }
}

/// Values of an image that lays a picture over a sphere, by positions in world space.
fn frame((center, radius): (DVec3, f64)) -> [(&'static str, Value); 2] {
    placed(&StraightLaying::around(center, radius, DQuat::IDENTITY))
}

/// Values of an image that lies straight through a mesh, by turned places.
fn placed(laying: &StraightLaying) -> [(&'static str, Value); 2] {
    let pair = |pair: DVec2| Value::Vector(pair.to_array().map(short).to_vec());
    [("scale", pair(laying.scale)), ("offset", pair(laying.offset))]
}

/// A number that is finer than a picture's texels, on large objects too, and short enough to be
/// read in files.
fn short(x: f64) -> f64 {
    (x * 1e8).round() / 1e8
}

/// A node with all that it feeds.
fn dependents<'l>(look: &'l Look, node: &'l NodeId) -> HashSet<&'l NodeId> {
    let mut users: HashMap<&NodeId, Vec<&NodeId>> = HashMap::new();
    for wire in &look.graph.wires {
        users.entry(&wire.from.node).or_default().push(&wire.to.node);
    }
    let mut found = HashSet::from([node]);
    let mut open = vec![node];
    while let Some(id) = open.pop() {
        let users = users.get(id).into_iter().flatten();
        open.extend(users.copied().filter(|user| found.insert(user)));
    }
    found
}

/// Edits that make a mask.
struct MaskEdits<'a> {
    look: &'a Look,
    layer: &'a NodeId,
    at: [f64; 2],
    added: Vec<NodeId>,
    edits: Vec<Edit>,
}

impl<'a> MaskEdits<'a> {
    fn new(look: &'a Look, layer: &'a NodeId) -> Self {
        let [x, y] = look.graph.nodes.get(layer).map_or([0.0; 2], |node| node.position);
        Self { look, layer, at: [x - STEP, y + DROP], added: Vec::new(), edits: Vec::new() }
    }

    /// Adds a node so many columns before the mask.
    fn node(
        &mut self,
        kind: &str,
        values: impl Iterator<Item = (&'static str, Value)>,
        before: usize,
    ) -> NodeId {
        let is_taken = |slug: &str| {
            self.look.graph.nodes.contains_key(slug)
                || self.added.iter().any(|id| id.as_str() == slug)
        };
        let id = NodeId::new(make_slug(kind, is_taken));
        let node = Node {
            kind: kind.to_owned(),
            position: [self.at[0] - before as f64 * STEP, self.at[1]],
            values: values.map(|(port, value)| (PortName::new(port), value)).collect(),
            ..Node::default()
        };
        self.added.push(id.clone());
        self.edits.push(Edit::AddNode { graph: GraphId::Look, id: id.clone(), node, index: None });
        id
    }

    /// Adds a node of two outputs so many columns before the mask; the next one comes after it.
    fn joined(&mut self, kind: &str, [a, b]: [Endpoint; 2], columns: &mut usize) -> Endpoint {
        let id = self.node(kind, std::iter::empty(), *columns);
        *columns = columns.saturating_sub(1);
        self.wire(a, &id, "a");
        self.wire(b, &id, "b");
        Endpoint::new(id, "")
    }

    fn wire(&mut self, from: Endpoint, to: &NodeId, port: &str) {
        let wire = Wire { from, to: Endpoint::new(to.clone(), port) };
        self.edits.push(Edit::AddWire { graph: GraphId::Look, wire, index: None });
    }

    /// Adds the nodes of turned places, before the image that they lay.
    fn turned_place(&mut self, laying: &StraightLaying) -> Endpoint {
        let space = laying.is_of_object.then(|| Value::Text("object".to_owned()));
        let position = self.node("position", space.map(|space| ("space", space)).into_iter(), 3);
        let (axis, angle) = laying.turn.to_axis_angle();
        let axis = Value::Vector(axis.to_array().map(short).to_vec());
        let values = [("axis", axis), ("angle", Value::Number(short(angle)))];
        let turned = self.node("rotate_vector", values.into_iter(), 2);
        self.wire(Endpoint::new(position, ""), &turned, "vector");
        Endpoint::new(turned, "")
    }

    /// Moves what was added down to where it lies over no other node.
    fn move_to_free_row(&mut self) {
        let places = self.edits.iter().filter_map(|edit| match edit {
            Edit::AddNode { node, .. } => Some(node.position),
            _ => None,
        });
        let places: Vec<[f64; 2]> = places.collect();
        let (width, height) = (f64::from(NODE_WIDTH), |rows| f64::from(node_height(rows)));
        let (own, other) = (height(MOST_ROWS), height(MOST_ROWS_OF_OTHERS));
        let is_free = |down: &f64| {
            self.look.graph.nodes.values().all(|node| {
                let [x, y] = node.position;
                places.iter().all(|[own_x, own_y]| {
                    let top = own_y + down;
                    (own_x - x).abs() >= width || y >= top + own || y + other <= top
                })
            })
        };
        let found = (0..MOST_STEPS_DOWN).map(|step| f64::from(step) * STEP_DOWN).find(is_free);
        for edit in &mut self.edits {
            if let Edit::AddNode { node, .. } = edit {
                node.position[1] += found.unwrap_or_default();
            }
        }
    }

    /// Adds the mask, with the opacity that the layer has.
    fn finish(mut self, from: Option<Endpoint>) -> (NodeId, Edit) {
        let own = self.look.graph.nodes.get(self.layer);
        let opacity = own.and_then(|node| node.values.get(OPACITY)).cloned();
        let mask = self.node(MASK, opacity.into_iter().map(|value| (OPACITY, value)), 0);
        if let Some(from) = from {
            self.wire(from, &mask, SHOWN);
        }
        let layer = self.layer.clone();
        self.wire(Endpoint::new(mask.clone(), ""), &layer, OPACITY);
        self.move_to_free_row();
        (mask, Edit::Group { edits: self.edits })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;
    use crate::state::masks::painted_of;

    const LOOK: &str = r#"{"lights": {"key": {}}, "nodes": [
        {"id": "base", "kind": "base"},
        {"id": "a", "kind": "light_layer", "values": {"light": "key"}, "at": [260, 0]},
        {"id": "b", "kind": "light_layer", "values": {"light": "key", "opacity": 0.5}},
        {"id": "c", "kind": "blend", "at": [780, 0]},
        {"id": "output", "kind": "output", "at": [1040, 0]}
      ], "wires": [{"from": "base", "to": "a.below"}, {"from": "a.below", "to": "b.below"},
        {"from": "b.tone", "to": "c.tone"}, {"from": "b.below", "to": "c.below"},
        {"from": "c", "to": "output.color"}]}"#;

    const AROUND: (DVec3, f64) = (DVec3::ZERO, 1.0);

    fn setup() -> (Look, Catalog, LayerTree) {
        let look = Look::read(LOOK, "test").value.unwrap();
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&look, Library::built_in());
        let tree = LayerTree::of(&look, &catalog);
        (look, catalog, tree)
    }

    fn problems(look: &Look) -> Vec<String> {
        let checked = crate::compile::check(look, Library::built_in(), None);
        checked.err().unwrap_or_default().iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_mask_that_lies_straight_through_a_mesh_is_read_from_its_nodes() {
        let turn = DQuat::from_euler(glam::EulerRot::YXZ, 0.4, -0.3, 0.2);
        let straight = StraightLaying::around(DVec3::new(0.1, 2.0, -3.0), 4.0, turn);
        for laying in [MaskLaying::Uvs, MaskLaying::Straight(straight.clone())] {
            let (mut look, catalog, _) = setup();
            let (_, edit) = Stack::mask_by_picture(&look, &"b".into(), ("m.png", &laying));
            look.apply(edit).unwrap();
            assert!(!is_free(&look, &catalog, &"b".into()));
            let problems = problems(&look);
            assert!(problems.is_empty(), "{problems:?}");
            let (file, found) = painted_of(&look, &"b".into()).expect("it can be painted");
            assert_eq!(file, "m.png");
            match found {
                MaskLaying::Uvs => assert_eq!(laying, MaskLaying::Uvs),
                MaskLaying::Straight(found) => {
                    assert!(found.is_of_object);
                    for place in [DVec3::ZERO, DVec3::new(3.0, 4.0, -5.0), DVec3::NEG_ONE] {
                        assert!(found.uv(place).distance(straight.uv(place)) < 1e-6);
                    }
                }
            }
        }
    }

    #[test]
    fn every_source_makes_a_mask_that_compiles_and_is_taken_away_again() {
        for source in &SOURCES {
            let (mut look, catalog, tree) = setup();
            let stack = tree.own();
            let before = look.clone();
            assert!(is_free(&look, &catalog, &"b".into()));
            let (mask, edit) = stack.mask(&look, &"b".into(), (source, AROUND));
            look.apply(edit).unwrap();
            assert_eq!(problems(&look), [""; 0], "{}", source.name);
            assert_eq!(of(&look, &"b".into()).map(|(id, _)| id), Some(&mask));
            assert!(!is_free(&look, &catalog, &"b".into()));
            let shown = &look.graph.nodes[&mask];
            assert_eq!(shown.values[OPACITY], Value::Number(0.5), "the layer's own");
            let stack = Stack::of(&look, &catalog);
            assert_eq!(stack.layers.len(), 3, "{}: a mask is no layer", source.name);
            look.apply(stack.unmask(&look, &"b".into()).unwrap()).unwrap();
            assert_eq!(look, before, "{}", source.name);
        }
    }

    #[test]
    fn a_mask_lies_over_no_other_node() {
        for source in &SOURCES {
            let (mut look, catalog, tree) = setup();
            // Nodes below the layers, where there was room once.
            for (id, at) in [("first", [0.0, 300.0]), ("second", [-300.0, 520.0])] {
                let node = Node { kind: "noise".to_owned(), position: at, ..Node::default() };
                look.graph.nodes.insert(id.into(), node);
            }
            let before = look.clone();
            let (_, edit) = tree.own().mask(&look, &"b".into(), (source, AROUND));
            look.apply(edit).unwrap();
            let sized = |(id, node): (&NodeId, &Node)| {
                let kind = catalog.of(node).unwrap();
                let [x, y] = node.position;
                let height = f64::from(node_height(kind.inputs.len() + kind.outputs.len()));
                (id.clone(), [x, y, x + f64::from(NODE_WIDTH), y + height])
            };
            let (old, new): (Vec<_>, Vec<_>) = look
                .graph
                .nodes
                .iter()
                .map(sized)
                .partition(|(id, _)| before.graph.nodes.contains_key(id));
            for (id, [left, top, right, bottom]) in &new {
                for (other, [x0, y0, x1, y1]) in &old {
                    let is_over = left < x1 && x0 < right && top < y1 && y0 < bottom;
                    assert!(!is_over, "{}: {id} lies over {other}", source.name);
                }
            }
        }
    }

    #[test]
    fn a_picture_is_laid_over_the_whole_object() {
        let [(_, scale), (_, offset)] = frame((DVec3::new(3.0, -1.0, 9.0), 2.0));
        assert_eq!(scale, Value::Vector(vec![0.25; 2]));
        assert_eq!(offset, Value::Vector(vec![-0.25, 0.75]), "the middle is the picture's");
        assert_eq!(frame((DVec3::ZERO, 0.0))[0].1, Value::Vector(vec![0.5; 2]), "a point");
    }

    #[test]
    fn a_layer_is_clipped_to_the_one_below() {
        let (mut look, catalog, tree) = setup();
        let (below, coverage) = tree.clipping(&look, &catalog, &"b".into()).unwrap();
        assert_eq!(below.as_str(), "a");
        assert_eq!(coverage, Coverage(vec![vec![Endpoint::new("a", "tone")]]));
        let (_, edit) = Stack::mask_by(&look, &"b".into(), &coverage);
        look.apply(edit).unwrap();
        assert_eq!(problems(&look), [""; 0]);
        let clip = |base: &str| Some(Clip { base: base.into(), is_stale: false });
        assert_eq!(tree.clip_of(&look, &catalog, &"b".into()), clip("a"));
        // Nodes are fed as a whole: what lies above a layer depends on it.
        let ids = |layer: &str| {
            let found = tree.coverages(&look, &catalog, &layer.into());
            found.into_iter().map(|(id, _)| id.to_string()).collect::<Vec<_>>()
        };
        assert_eq!(ids("b"), ["a"]);
        assert_eq!(ids("a"), [""; 0]);
        assert_eq!(ids("c"), ["b", "a"]);
        assert!(tree.clipping(&look, &catalog, &"a".into()).is_none(), "nothing is below");
    }

    /// Adds edits, and finds the layers anew.
    fn after(look: &mut Look, catalog: &Catalog, edit: Edit) -> LayerTree {
        look.apply(edit).unwrap();
        assert_eq!(problems(look), [""; 0]);
        LayerTree::of(look, catalog)
    }

    /// A folder is where any of its layers is, within its own mask; a folder is clipped as a layer
    /// is, and layers that are clipped one over the other share what they are clipped to.
    #[test]
    fn layers_are_clipped_to_folders_and_folders_to_layers() {
        let (mut look, catalog, tree) = setup();
        let noise = SOURCES.iter().find(|source| source.name.english() == "Noise").unwrap();
        // The blend lies where b is, which would close a ring around a folder of both.
        let freed = Edit::RemoveWire {
            graph: GraphId::Look,
            wire: look.graph.wire_into(&"c".into(), &"tone".into()).unwrap().clone(),
        };
        look.apply(freed).unwrap();
        let (folder, edit) = tree.group(&look, &["b".into(), "a".into()]).unwrap();
        let tree = after(&mut look, &catalog, edit);
        let before = look.clone();
        for is_masked in [false, true] {
            look = before.clone();
            let own = is_masked.then(|| tree.own().mask(&look, &folder, (noise, AROUND)).1);
            let mut tree = tree.clone();
            if let Some(edit) = own {
                tree = after(&mut look, &catalog, edit);
            }
            let unclipped = look.clone();
            let (base, coverage) = tree.clipping(&look, &catalog, &"c".into()).unwrap();
            assert_eq!((&base, coverage.0.len()), (&folder, 2));
            let (_, edit) = Stack::mask_by(&look, &"c".into(), &coverage);
            let tree = after(&mut look, &catalog, edit);
            let clip = Clip { base: folder.clone(), is_stale: false };
            assert_eq!(tree.clip_of(&look, &catalog, &"c".into()), Some(clip));
            let count = |kind: &str| look.graph.nodes.values().filter(|n| n.kind == kind).count();
            assert_eq!((count(GREATEST), count(PRODUCT)), (1, if is_masked { 2 } else { 0 }));
            look.apply(tree.own().unmask(&look, &"c".into()).unwrap()).unwrap();
            assert_eq!(look, unclipped, "the layer is freed again");
        }
        let (mut look, catalog, tree) = setup();
        let (folder, edit) = tree.group(&look, &["c".into()]).unwrap();
        let tree = after(&mut look, &catalog, edit);
        let (_, coverage) = tree.clipping(&look, &catalog, &"b".into()).unwrap();
        let (_, edit) = Stack::mask_by(&look, &"b".into(), &coverage);
        let tree = after(&mut look, &catalog, edit);
        let (base, coverage) = tree.clipping(&look, &catalog, &folder).unwrap();
        assert_eq!(base.as_str(), "a", "b is clipped itself");
        let (_, edit) = Stack::mask_by(&look, &folder, &coverage);
        let tree = after(&mut look, &catalog, edit);
        let clip = tree.clip_of(&look, &catalog, &folder).unwrap();
        assert_eq!((clip.base.as_str(), clip.is_stale), ("a", false));
    }

    /// A folder that gets a layer is told from what was clipped to it, until it is clipped anew.
    #[test]
    fn a_folder_that_grew_is_clipped_to_anew() {
        let (mut look, catalog, tree) = setup();
        let (folder, edit) = tree.group(&look, &["a".into()]).unwrap();
        let tree = after(&mut look, &catalog, edit);
        let (base, coverage) = tree.clipping(&look, &catalog, &"b".into()).unwrap();
        assert_eq!(base, folder);
        let (_, edit) = Stack::mask_by(&look, &"b".into(), &coverage);
        let tree = after(&mut look, &catalog, edit);
        let place = super::super::tree::LayerPlace { folder: Some(folder), at: 0 };
        let node = Node {
            kind: "light_layer".to_owned(),
            values: [("light".into(), Value::Text("key".to_owned()))].into_iter().collect(),
            ..Node::default()
        };
        let edits = tree.insert(&look, &place, &"new".into(), node);
        let tree = after(&mut look, &catalog, Edit::Group { edits });
        let clip = tree.clip_of(&look, &catalog, &"b".into()).unwrap();
        assert!(clip.is_stale);
        let anew = tree.clip_anew(&look, &catalog, (&"b".into(), &clip)).unwrap();
        let tree = after(&mut look, &catalog, anew);
        assert!(!tree.clip_of(&look, &catalog, &"b".into()).unwrap().is_stale);
        let (mask, node) = of(&look, &"b".into()).unwrap();
        assert_eq!(node.values[OPACITY], Value::Number(0.5), "the layer's own");
        assert_eq!(look.graph.wires.iter().filter(|wire| wire.from.node == *mask).count(), 1);
    }

    #[test]
    fn nothing_is_clipped_to_what_is_everywhere_or_nowhere() {
        let (mut look, catalog, tree) = setup();
        let band = Node { kind: "band_layer".to_owned(), ..Node::default() };
        let place = super::super::tree::LayerPlace { folder: None, at: 1 };
        let edits = tree.insert(&look, &place, &"band".into(), band);
        let tree = after(&mut look, &catalog, Edit::Group { edits });
        assert!(tree.clipping(&look, &catalog, &"c".into()).is_none(), "bands are everywhere");
        let (_, edit) = tree.add_folder(&look, &place);
        let tree = after(&mut look, &catalog, edit);
        assert!(tree.clipping(&look, &catalog, &"c".into()).is_none(), "an empty folder");
    }
}
