//! Masks of layers: a *Mask* node in a layer's opacity, and what says where the layer is shown.

use chiaro_locale::{Text, text};

use super::tree::LayerTree;
use super::{STEP, Stack};
use crate::catalog::Catalog;
use crate::document::{Edit, Endpoint, GraphId, Look, Node, Value, Wire};
use crate::ids::{NodeId, PortName, make_slug};

/// Kind of the node, and its inputs.
const MASK: &str = "mask";
pub(crate) const SHOWN: &str = "mask";
pub(crate) const OPACITY: &str = "opacity";
pub(crate) const INVERTED: &str = "inverted";
/// Output of a layer that says where it is, and the input of a plain layer that does.
const TONE: &str = "tone";
/// Distance of what feeds a mask from the layer, downward, in points.
const DROP: f64 = 240.0;

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
    numbers: &'static [(&'static str, f64)],
    words: &'static [(&'static str, &'static str)],
}

impl SourceNode {
    const fn of(kind: &'static str, input: &'static str) -> Self {
        Self { kind, input, numbers: &[], words: &[] }
    }
}

/// Sources, the ones that painters reach for first.
pub(crate) static SOURCES: [MaskSource; 7] = [
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
        name: text!("Vertex colors"),
        help: text!("The brightness of the colors that were painted on the mesh's points"),
        chain: &[SourceNode::of("vertex_color", ""), SourceNode::of("color_luminance", "color")],
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
    if kind.output(TONE).is_some() {
        return Some(Endpoint::new(layer.clone(), TONE));
    }
    look.graph.wire_into(layer, &PortName::new(TONE)).map(|wire| wire.from.clone())
}

impl LayerTree {
    /// Other layers whose tone can mask a layer, from the top, each with the output.
    pub(crate) fn tones(
        &self,
        look: &Look,
        catalog: &Catalog,
        layer: &NodeId,
    ) -> Vec<(NodeId, Endpoint)> {
        let others = self.rows(|_| false).into_iter().filter(|row| row.id != *layer);
        // What depends on the layer itself would close a ring.
        let found = others.filter_map(|other| {
            let tone = tone_of(look, catalog, &other.id)?;
            (!depends_on(look, &tone.node, layer)).then_some((other.id, tone))
        });
        found.collect()
    }

    /// The layer below and the output that clips a layer to it.
    pub(crate) fn clipping(
        &self,
        look: &Look,
        catalog: &Catalog,
        layer: &NodeId,
    ) -> Option<(NodeId, Endpoint)> {
        let stack = self.stack_of(layer)?;
        let below = stack.layers.get(stack.index_of(layer)? + 1)?;
        self.tones(look, catalog, layer).into_iter().find(|(id, _)| *id == below.id)
    }
}

impl Stack {
    /// Masks a layer by a source. Returns the new mask's id with the edit.
    pub(crate) fn mask(&self, look: &Look, layer: &NodeId, source: &MaskSource) -> (NodeId, Edit) {
        let mut making = MaskEdits::new(look, layer);
        let mut from = source.is_of_stack.then(|| self.below(layer)).flatten();
        let count = source.chain.len();
        for (place, part) in source.chain.iter().enumerate() {
            let numbers = part.numbers.iter().map(|(port, x)| (*port, Value::Number(*x)));
            let words = part.words.iter().map(|(port, word)| (*port, Value::Text((*word).into())));
            let id = making.node(part.kind, numbers.chain(words), count - place);
            if let Some(from) = from {
                making.wire(from, &id, part.input);
            }
            from = Some(Endpoint::new(id, ""));
        }
        making.finish(from)
    }

    /// Masks a layer by an output.
    pub(crate) fn mask_by(look: &Look, layer: &NodeId, from: Endpoint) -> (NodeId, Edit) {
        MaskEdits::new(look, layer).finish(Some(from))
    }

    /// Masks a layer by a picture beside the look. Returns the new mask's id with the edit.
    pub(crate) fn mask_by_picture(look: &Look, layer: &NodeId, file: &str) -> (NodeId, Edit) {
        let mut making = MaskEdits::new(look, layer);
        let text = |text: &str| Value::Text(text.to_owned());
        let values = [("image", text(file)), ("encoding", text("data"))];
        let image = making.node("image", values.into_iter(), 1);
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

/// True if a node is another one, or is fed by it.
fn depends_on(look: &Look, node: &NodeId, other: &NodeId) -> bool {
    let mut seen = std::collections::HashSet::from([node]);
    let mut open = vec![node];
    while let Some(id) = open.pop() {
        if id == other {
            return true;
        }
        let sources = look.graph.wires.iter().filter(|wire| wire.to.node == *id);
        open.extend(sources.map(|wire| &wire.from.node).filter(|id| seen.insert(id)));
    }
    false
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

    fn wire(&mut self, from: Endpoint, to: &NodeId, port: &str) {
        let wire = Wire { from, to: Endpoint::new(to.clone(), port) };
        self.edits.push(Edit::AddWire { graph: GraphId::Look, wire, index: None });
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
        (mask, Edit::Group { edits: self.edits })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    const LOOK: &str = r#"{"lights": {"key": {}}, "nodes": [
        {"id": "base", "kind": "base"},
        {"id": "a", "kind": "light_layer", "values": {"light": "key"}, "at": [260, 0]},
        {"id": "b", "kind": "light_layer", "values": {"light": "key", "opacity": 0.5}},
        {"id": "c", "kind": "blend", "at": [780, 0]},
        {"id": "output", "kind": "output", "at": [1040, 0]}
      ], "wires": [{"from": "base", "to": "a.below"}, {"from": "a.below", "to": "b.below"},
        {"from": "b.tone", "to": "c.tone"}, {"from": "b.below", "to": "c.below"},
        {"from": "c", "to": "output.color"}]}"#;

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
    fn every_source_makes_a_mask_that_compiles_and_is_taken_away_again() {
        for source in &SOURCES {
            let (mut look, catalog, tree) = setup();
            let stack = tree.own();
            let before = look.clone();
            assert!(is_free(&look, &catalog, &"b".into()));
            let (mask, edit) = stack.mask(&look, &"b".into(), source);
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
    fn a_layer_is_clipped_to_the_one_below() {
        let (mut look, catalog, tree) = setup();
        let (below, tone) = tree.clipping(&look, &catalog, &"b".into()).unwrap();
        assert_eq!((below.as_str(), tone.port.as_str()), ("a", "tone"));
        let (_, edit) = Stack::mask_by(&look, &"b".into(), tone);
        look.apply(edit).unwrap();
        assert_eq!(problems(&look), [""; 0]);
        // Nodes are fed as a whole: what lies above a layer depends on it.
        let ids = |layer: &str| {
            let tones = tree.tones(&look, &catalog, &layer.into());
            tones.into_iter().map(|(id, _)| id.to_string()).collect::<Vec<_>>()
        };
        assert_eq!(ids("b"), ["a"]);
        assert_eq!(ids("a"), [""; 0]);
        assert_eq!(ids("c"), ["b", "a"]);
        assert!(tree.clipping(&look, &catalog, &"a".into()).is_none(), "nothing is below");
    }
}
