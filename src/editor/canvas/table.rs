//! Table derived from one revision of a graph: rectangles, sockets, and wires with port names
//! resolved to indices.
//!
//! The document stays the only model; the table is thrown away and made again at each revision (0.5
//! ms for 5,000 nodes), and moved in place while nodes are dragged.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{Galley, Pos2, Rect, Vec2, pos2, vec2};

use super::text::NodeText;
use crate::catalog::{Catalog, NodeKind};
use crate::document::{Graph, LightSet};
use crate::drawing::{
    FRAME_MARGIN, FRAME_TITLE, NODE_WIDTH, TITLE_HEIGHT, node_height, row_center, wire_reach,
};
use crate::fields::names;
use crate::ids::{FrameId, NodeId, NoteId, PortName};
use crate::library::Type;
use crate::state::revision::{DocumentNumber, GraphNumber, LookRevision};

/// Gap between the nodes of a group and its two ends, in points of the graph.
const END_GAP: f32 = 70.0;
/// Largest number of reroutes that are followed to find a type.
const MAX_REROUTES: usize = 64;

/// Socket: the index of a node, and the index of one of its ports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Socket {
    pub(crate) node: usize,
    pub(crate) port: usize,
    pub(crate) is_output: bool,
}

/// Item under the pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CanvasItem {
    Socket(Socket),
    Node(usize),
    Wire(usize),
    Note(usize),
    /// Title of a frame.
    Frame(usize),
}

/// Node as drawn.
pub(crate) struct NodeRow {
    pub(crate) id: NodeId,
    pub(crate) kind: Arc<NodeKind>,
    pub(crate) title: String,
    pub(crate) rect: Rect,
    /// For each input, true if a wire leads to it.
    pub(crate) is_wired: Vec<bool>,
    /// Outputs that the look names as passes, by index.
    pub(crate) named: Vec<(usize, PortName)>,
    /// Type that a reroute passes on.
    passes: Option<Type>,
    pub(crate) is_collapsed: bool,
    pub(crate) is_muted: bool,
    /// Words on the lights that a group runs for, if it does for each.
    pub(crate) each_of: Option<String>,
    /// True for the two ends of a group, which are no nodes of the document.
    pub(crate) is_end: bool,
    /// True if the labels of its kind are Chiaro's own, and so in the user's language.
    pub(crate) is_own: bool,
    /// True if no output of the graph depends on the node.
    pub(crate) is_unused: bool,
    pub(crate) text: NodeText,
}

/// Sources of a table: document, revision, open graph, and tag of the language.
type TableKey = (DocumentNumber, LookRevision, GraphNumber, &'static str);

impl NodeRow {
    /// Text of the node's kind as it is shown.
    pub(crate) fn shown<'a>(&self, text: &'a str) -> &'a str {
        names::shown(self.is_own, text)
    }
}

/// Words on the lights that a group runs for.
fn each_of(set: &LightSet) -> String {
    match set.text() {
        "*" => tr!("each light").to_owned(),
        lights => tr!("each of {lights}"),
    }
}

/// Frame as drawn.
pub(crate) struct FrameRow {
    pub(crate) id: FrameId,
    pub(crate) title: String,
    /// Color of the frame, straight RGB.
    pub(crate) color: Option<[f64; 3]>,
    /// Nodes of the frame, by index.
    pub(crate) nodes: Vec<usize>,
    pub(crate) rect: Rect,
    pub(crate) text: Line,
}

/// Note as drawn.
pub(crate) struct NoteRow {
    pub(crate) id: NoteId,
    pub(crate) content: String,
    pub(crate) color: Option<[f64; 3]>,
    pub(crate) rect: Rect,
    pub(crate) text: Line,
}

/// Text that was laid out, with its size in half points.
pub(crate) type Line = Option<(i32, Arc<Galley>)>;

impl FrameRow {
    /// Rectangle of the title, by which a frame is dragged.
    pub(crate) fn title_rect(&self) -> Rect {
        Rect::from_min_max(self.rect.min, pos2(self.rect.max.x, self.rect.min.y + FRAME_TITLE))
    }
}

/// Wire as drawn.
pub(crate) struct WireRow {
    /// Index of the wire in the graph.
    pub(crate) index: usize,
    pub(crate) from: Socket,
    pub(crate) to: Socket,
    pub(crate) bounds: Rect,
    /// Type of the value that leaves the output.
    pub(crate) ty: Type,
    /// Type that the value is converted to, where the input takes another.
    pub(crate) becomes: Option<Type>,
}

/// Nodes, wires, frames and notes of a graph; nodes and wires in document order.
#[derive(Default)]
pub(crate) struct Table {
    key: Option<TableKey>,
    pub(crate) nodes: Vec<NodeRow>,
    pub(crate) wires: Vec<WireRow>,
    /// Frames, the largest first.
    pub(crate) frames: Vec<FrameRow>,
    pub(crate) notes: Vec<NoteRow>,
    /// Nodes that the table had not before it was made again.
    pub(crate) added: Vec<usize>,
    by_id: HashMap<NodeId, usize>,
}

impl Table {
    /// Makes the table again if `key` differs from the last;
    /// `group` is the kind whose graph is open. Returns true if the table was made again.
    pub(crate) fn sync(
        &mut self,
        key: TableKey,
        graph: &Graph,
        catalog: &Catalog,
        group: Option<&str>,
        driving: &[NodeId],
    ) -> bool {
        if self.key == Some(key) {
            return false;
        }
        self.key = Some(key);
        self.nodes.clear();
        let missing = catalog.missing_in(graph);
        for (id, node) in &graph.nodes {
            let kind = missing.get(id).or_else(|| catalog.of(node)).cloned();
            let Some(kind) = kind else { continue };
            let height = if node.collapsed { TITLE_HEIGHT } else { height(&kind) };
            // A position may be any finite number, and nothing beyond f32 can be drawn.
            let [x, y] = node.position.map(|x| (x as f32).clamp(-1e7, 1e7));
            let is_own = names::is_own(&kind.id);
            let title = match node.name.as_str() {
                "" => names::shown(is_own, &kind.label).to_owned(),
                name => name.to_owned(),
            };
            self.nodes.push(NodeRow {
                id: id.clone(),
                title,
                rect: Rect::from_min_size(pos2(x, y), vec2(NODE_WIDTH, height)),
                is_wired: vec![false; kind.inputs.len()],
                named: Vec::new(),
                passes: None,
                kind,
                is_collapsed: node.collapsed,
                is_muted: node.muted,
                each_of: node.for_each.as_ref().map(each_of),
                is_end: false,
                is_own,
                is_unused: false,
                text: NodeText::default(),
            });
        }
        if let Some(ends) = group.and_then(|group| catalog.ends(group)) {
            self.add_ends(ends, group.is_some_and(names::is_own));
        }
        let by_id =
            self.nodes.iter().enumerate().map(|(index, row)| (row.id.clone(), index)).collect();
        let known = std::mem::replace(&mut self.by_id, by_id);
        let is_new = |index: &usize| !known.contains_key(&self.nodes[*index].id);
        self.added = (0..self.nodes.len()).filter(is_new).collect();
        self.sync_wires(graph);
        self.level_ends();
        self.find_unused(driving);
        self.sync_frames(graph);
        true
    }

    /// Adds the ends of a group, left and right of all its nodes.
    fn add_ends(&mut self, ends: [NodeKind; 2], is_own: bool) {
        let bounds = self.nodes.iter().fold(Rect::NOTHING, |bounds, row| bounds.union(row.rect));
        let bounds = if bounds.is_positive() {
            bounds
        } else {
            Rect::from_min_size(Pos2::ZERO, vec2(60.0, 80.0))
        };
        for (index, kind) in ends.into_iter().enumerate() {
            let size = vec2(NODE_WIDTH, height(&kind));
            let x = if index == 0 {
                bounds.min.x - END_GAP - NODE_WIDTH
            } else {
                bounds.max.x + END_GAP
            };
            let corner = pos2(x, (bounds.center().y - size.y / 2.0).round());
            self.nodes.push(NodeRow {
                id: kind.id.as_str().into(),
                title: [tr!("node" => "Group inputs"), tr!("node" => "Group outputs")][index]
                    .to_owned(),
                rect: Rect::from_min_size(corner, size),
                is_wired: vec![false; kind.inputs.len()],
                named: Vec::new(),
                passes: None,
                kind: Arc::new(kind),
                is_collapsed: false,
                is_muted: false,
                each_of: None,
                is_end: true,
                is_own,
                is_unused: false,
                text: NodeText::default(),
            });
        }
    }

    /// Moves the ends of a group up or down so that their wires run level on average.
    fn level_ends(&mut self) {
        for end in
            (0..self.nodes.len()).filter(|&index| self.nodes[index].is_end).collect::<Vec<_>>()
        {
            let rise = |wire: &WireRow| self.place(wire.to).y - self.place(wire.from).y;
            let way = |wire: &WireRow| if wire.from.node == end { rise(wire) } else { -rise(wire) };
            let own = self.wires.iter().filter(|wire| wire.from.node == end || wire.to.node == end);
            let ways: Vec<f32> = own.map(way).collect();
            if !ways.is_empty() {
                let mean = (ways.iter().sum::<f32>() / ways.len() as f32).round();
                self.nodes[end].rect = self.nodes[end].rect.translate(vec2(0.0, mean));
            }
        }
        for index in 0..self.wires.len() {
            if self.nodes[self.wires[index].from.node].is_end
                || self.nodes[self.wires[index].to.node].is_end
            {
                self.wires[index].bounds = self.wire_bounds(index);
            }
        }
    }

    /// Marks nodes that no output depends on and that drive no keys; without any output, marks
    /// none.
    fn find_unused(&mut self, driving: &[NodeId]) {
        let is_output =
            |row: &NodeRow| row.kind.id == "output" || row.is_end && row.kind.outputs.is_empty();
        let is_root = |row: &NodeRow| is_output(row) || driving.contains(&row.id);
        let mut open: Vec<usize> =
            (0..self.nodes.len()).filter(|&index| is_root(&self.nodes[index])).collect();
        if !self.nodes.iter().any(is_output) {
            return;
        }
        let mut into: HashMap<usize, Vec<usize>> = HashMap::new();
        for wire in &self.wires {
            into.entry(wire.to.node).or_default().push(wire.from.node);
        }
        let mut is_used = vec![false; self.nodes.len()];
        while let Some(index) = open.pop() {
            if !std::mem::replace(&mut is_used[index], true) {
                open.extend(into.get(&index).into_iter().flatten());
            }
        }
        for (row, is_used) in self.nodes.iter_mut().zip(is_used) {
            row.is_unused = !is_used && !row.is_end;
        }
    }

    fn sync_frames(&mut self, graph: &Graph) {
        let color = |color: &[f64]| <[f64; 3]>::try_from(color).ok();
        let frame = |(id, frame): (&FrameId, &crate::document::Frame)| FrameRow {
            id: id.clone(),
            title: frame.title.clone(),
            color: color(&frame.color),
            nodes: frame.nodes.iter().filter_map(|id| self.index_of(id)).collect(),
            rect: Rect::NOTHING,
            text: None,
        };
        self.frames = graph.frames.iter().map(frame).collect();
        (0..self.frames.len()).for_each(|index| self.fit_frame(index));
        self.frames.retain(|frame| !frame.nodes.is_empty());
        self.frames.sort_by(|a, b| b.rect.area().total_cmp(&a.rect.area()));
        let note = |(id, note): (&NoteId, &crate::document::Note)| {
            let [x, y] = note.position.map(|x| (x as f32).clamp(-1e7, 1e7));
            NoteRow {
                id: id.clone(),
                content: note.text.clone(),
                color: color(&note.color),
                rect: Rect::from_min_size(pos2(x, y), vec2(note.width as f32, TITLE_HEIGHT)),
                text: None,
            }
        };
        self.notes = graph.notes.iter().map(note).collect();
    }

    /// Puts a frame around its nodes.
    fn fit_frame(&mut self, index: usize) {
        let nodes = self.frames[index].nodes.iter();
        let rect = nodes.fold(Rect::NOTHING, |all, &node| all.union(self.nodes[node].rect));
        let mut rect = rect.expand(FRAME_MARGIN);
        rect.min.y -= FRAME_TITLE - 6.0;
        self.frames[index].rect = rect;
    }

    /// Drops text that was laid out with fonts that no longer exist.
    pub(crate) fn forget_text(&mut self) {
        for row in &mut self.nodes {
            row.text = NodeText::default();
        }
        self.frames.iter_mut().for_each(|frame| frame.text = None);
        self.notes.iter_mut().for_each(|note| note.text = None);
    }

    /// Forces the next [`sync`](Self::sync) to make the table again.
    pub(crate) fn forget(&mut self) {
        self.key = None;
    }

    fn sync_wires(&mut self, graph: &Graph) {
        self.wires.clear();
        for (index, wire) in graph.wires.iter().enumerate() {
            let (Some(from), Some(to)) =
                (self.index_of(&wire.from.node), self.index_of(&wire.to.node))
            else {
                continue;
            };
            let output = self.nodes[from].kind.output(wire.from.port.as_str());
            let input = self.nodes[to].kind.input(wire.to.port.as_str());
            let (Some(output), Some(input)) = (output, input) else { continue };
            self.nodes[to].is_wired[input] = true;
            let from = Socket { node: from, port: output, is_output: true };
            let to = Socket { node: to, port: input, is_output: false };
            self.wires.push(WireRow {
                index,
                from,
                to,
                bounds: Rect::NOTHING,
                ty: Type::Float,
                becomes: None,
            });
        }
        let into: HashMap<usize, usize> =
            self.wires.iter().enumerate().map(|(i, wire)| (wire.to.node, i)).collect();
        for node in 0..self.nodes.len() {
            if self.nodes[node].kind.is_reroute {
                let socket = Socket { node, port: 0, is_output: true };
                self.nodes[node].passes =
                    into.contains_key(&node).then(|| self.resolved_type(socket, &into));
            }
        }
        for index in 0..self.wires.len() {
            let ty = self.socket_type(self.wires[index].from);
            let to = self.wires[index].to;
            let target = &self.nodes[to.node];
            let accepts = &target.kind.inputs[to.port].accepts;
            let is_free = target.kind.is_reroute || target.kind.is_missing || target.is_end;
            let becomes = || accepts.iter().find(|accepted| ty.convert_to(accepted).is_some());
            self.wires[index].becomes =
                if is_free || accepts.contains(&ty) { None } else { becomes().cloned() };
            self.wires[index].ty = ty;
            self.wires[index].bounds = self.wire_bounds(index);
        }
    }

    /// Type of an output; that of a reroute is its source's.
    fn resolved_type(&self, mut socket: Socket, into: &HashMap<usize, usize>) -> Type {
        for _ in 0..MAX_REROUTES {
            if !self.nodes[socket.node].kind.is_reroute {
                break;
            }
            match into.get(&socket.node) {
                Some(&wire) => socket = self.wires[wire].from,
                None => break,
            }
        }
        self.nodes[socket.node]
            .kind
            .outputs
            .get(socket.port)
            .map_or(Type::Float, |port| port.ty.clone())
    }

    /// Type that a socket gives or takes.
    pub(crate) fn socket_type(&self, socket: Socket) -> Type {
        let NodeRow { kind, passes, .. } = &self.nodes[socket.node];
        if kind.is_reroute {
            return passes.clone().unwrap_or(Type::Prepared("anything".to_owned()));
        }
        let ports = if socket.is_output { &kind.outputs } else { &kind.inputs };
        ports[socket.port].ty.clone()
    }

    fn wire_bounds(&self, index: usize) -> Rect {
        let mut bounds = Rect::NOTHING;
        for p in self.curve(&self.wires[index]) {
            bounds.extend_with(p);
        }
        bounds.expand(4.0)
    }

    pub(crate) fn index_of(&self, id: &NodeId) -> Option<usize> {
        self.by_id.get(id).copied()
    }

    /// Moves nodes while they are dragged.
    pub(crate) fn translate(&mut self, nodes: &HashSet<usize>, delta: Vec2) {
        for &index in nodes {
            self.nodes[index].rect = self.nodes[index].rect.translate(delta);
        }
        for index in 0..self.frames.len() {
            // A frame of which nodes stay behind stays too, so that nodes can be dragged out of it.
            if self.frames[index].nodes.iter().all(|node| nodes.contains(node)) {
                self.fit_frame(index);
            }
        }
        for index in 0..self.wires.len() {
            let wire = &self.wires[index];
            if nodes.contains(&wire.from.node) || nodes.contains(&wire.to.node) {
                self.wires[index].bounds = self.wire_bounds(index);
            }
        }
    }

    /// Position of a socket, in points of the graph.
    pub(crate) fn place(&self, socket: Socket) -> Pos2 {
        let row = &self.nodes[socket.node];
        if row.is_collapsed {
            let x = if socket.is_output { NODE_WIDTH } else { 0.0 };
            return row.rect.min + vec2(x, TITLE_HEIGHT / 2.0);
        }
        if socket.is_output {
            return row.rect.min + vec2(NODE_WIDTH, row_center(socket.port));
        }
        row.rect.min + vec2(0.0, row_center(row.kind.outputs.len() + socket.port))
    }

    /// The four points of a wire's Bézier curve.
    pub(crate) fn curve(&self, wire: &WireRow) -> [Pos2; 4] {
        curve_between(self.place(wire.from), self.place(wire.to))
    }

    /// Bounds of all nodes, frames and notes.
    pub(crate) fn bounds(&self) -> Rect {
        let rects =
            self.nodes.iter().map(|row| row.rect).chain(self.frames.iter().map(|row| row.rect));
        rects
            .chain(self.notes.iter().map(|row| row.rect))
            .fold(Rect::NOTHING, |bounds, rect| bounds.union(rect))
    }

    /// Rectangle of the node that reaches farthest to the right, where a graph ends.
    pub(crate) fn last(&self) -> Rect {
        let ends = self.nodes.iter().map(|row| row.rect);
        ends.max_by(|a, b| a.max.x.total_cmp(&b.max.x)).unwrap_or(Rect::ZERO)
    }

    /// Sockets of a node that wires may be drawn to.
    pub(crate) fn sockets(&self, node: usize) -> impl Iterator<Item = Socket> + '_ {
        let kind = &self.nodes[node].kind;
        let outputs =
            (0..kind.outputs.len()).map(move |port| Socket { node, port, is_output: true });
        let inputs = (0..kind.inputs.len()).filter(|&port| kind.inputs[port].is_wirable());
        outputs.chain(inputs.map(move |port| Socket { node, port, is_output: false }))
    }

    /// Nearest socket within `radius` of a point, among those that fit.
    pub(crate) fn socket_at(
        &self,
        p: Pos2,
        radius: f32,
        fits: impl Fn(Socket) -> bool,
    ) -> Option<Socket> {
        let near =
            self.nodes.iter().enumerate().filter(|(_, row)| row.rect.expand(radius).contains(p));
        let sockets = near.flat_map(|(node, _)| self.sockets(node)).filter(|&socket| fits(socket));
        let by_distance = sockets.map(|socket| (self.place(socket).distance(p), socket));
        by_distance
            .filter(|(distance, _)| *distance <= radius)
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, s)| s)
    }

    /// Socket, topmost node or nearest wire at a point.
    pub(crate) fn hit(&self, p: Pos2, radius: f32) -> Option<CanvasItem> {
        if let Some(socket) = self.socket_at(p, radius, |_| true) {
            return Some(CanvasItem::Socket(socket));
        }
        if let Some(index) = self.nodes.iter().rposition(|row| row.rect.contains(p)) {
            return Some(CanvasItem::Node(index));
        }
        let near = self
            .wires
            .iter()
            .enumerate()
            .filter(|(_, wire)| wire.bounds.expand(radius).contains(p));
        let by_distance = near.map(|(index, wire)| (index, curve_distance(p, &self.curve(wire))));
        let hits = by_distance.filter(|(_, distance)| *distance < radius);
        if let Some((index, _)) = hits.min_by(|a, b| a.1.total_cmp(&b.1)) {
            return Some(CanvasItem::Wire(index));
        }
        if let Some(index) = self.notes.iter().rposition(|note| note.rect.contains(p)) {
            return Some(CanvasItem::Note(index));
        }
        self.frames.iter().rposition(|frame| frame.title_rect().contains(p)).map(CanvasItem::Frame)
    }

    /// Smallest frame around a point, other than frames that hold only nodes of `moved`, by index.
    pub(crate) fn frame_at(&self, p: Pos2, moved: &HashSet<usize>) -> Option<usize> {
        self.frames.iter().rposition(|frame| {
            frame.rect.contains(p) && !frame.nodes.iter().all(|node| moved.contains(node))
        })
    }

    /// Frame that a node is in, by index.
    pub(crate) fn frame_of(&self, node: usize) -> Option<usize> {
        self.frames.iter().position(|frame| frame.nodes.contains(&node))
    }

    /// Wire into an input, by index.
    pub(crate) fn wire_into(&self, socket: Socket) -> Option<usize> {
        self.wires.iter().position(|wire| wire.to == socket)
    }
}

/// Height of a node of a kind, in points of the graph.
pub(crate) fn height(kind: &NodeKind) -> f32 {
    node_height(kind.inputs.len() + kind.outputs.len())
}

/// Bézier curve of a wire from an output to an input, level at both ends.
pub(crate) fn curve_between(from: Pos2, to: Pos2) -> [Pos2; 4] {
    let reach = vec2(wire_reach(to.x - from.x), 0.0);
    [from, from + reach, to - reach, to]
}

/// A point of a Bézier curve.
pub(crate) fn point_at(c: &[Pos2; 4], t: f32) -> Pos2 {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    let sum = c.iter().zip(weights).fold(Vec2::ZERO, |sum, (p, weight)| sum + p.to_vec2() * weight);
    sum.to_pos2()
}

fn curve_distance(p: Pos2, c: &[Pos2; 4]) -> f32 {
    const PIECES: usize = 24;
    let at = |i: usize| point_at(c, i as f32 / PIECES as f32);
    (0..PIECES).map(|i| segment_distance(p, at(i), at(i + 1))).fold(f32::MAX, f32::min)
}

fn segment_distance(p: Pos2, a: Pos2, b: Pos2) -> f32 {
    let d = b - a;
    let t = ((p - a).dot(d) / d.length_sq().max(1e-12)).clamp(0.0, 1.0);
    p.distance(a + d * t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Look;
    use crate::library::Library;

    fn table(json: &str) -> (Look, Table) {
        let look = Look::read(json, "test").value.unwrap();
        let mut table = Table::default();
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&look, Library::built_in());
        table.sync(Default::default(), &look.graph, &catalog, None, &[]);
        (look, table)
    }

    #[test]
    fn what_drives_keys_is_used() {
        let (look, mut table) = table(
            r#"{"nodes": [{"id": "mood", "kind": "number", "at": [0, 0]},
                {"id": "end", "kind": "output", "at": [400, 0]}]}"#,
        );
        assert!(table.nodes[0].is_unused && !table.nodes[1].is_unused);
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&look, Library::built_in());
        let mut graph = GraphNumber::default();
        graph.advance();
        let other = (DocumentNumber::default(), LookRevision::default(), graph, "en");
        table.sync(other, &look.graph, &catalog, None, &["mood".into()]);
        assert!(!table.nodes[0].is_unused);
    }

    #[test]
    fn sockets_nodes_and_wires_are_hit() {
        let (_, table) = table(
            r#"{"nodes": [{"id": "a", "kind": "base", "at": [0, 0]},
                {"id": "b", "kind": "output", "at": [400, 0]}],
                "wires": [{"from": "a.below", "to": "b.color"}]}"#,
        );
        let wire = &table.wires[0];
        assert_eq!(table.hit(table.place(wire.from), 8.0), Some(CanvasItem::Socket(wire.from)));
        assert_eq!(table.hit(pos2(50.0, 10.0), 8.0), Some(CanvasItem::Node(0)));
        let middle = point_at(&table.curve(wire), 0.5);
        assert_eq!(table.hit(middle, 6.0), Some(CanvasItem::Wire(0)));
        assert_eq!(table.hit(pos2(300.0, 300.0), 6.0), None);
    }

    #[test]
    fn an_unknown_kind_keeps_its_wires() {
        let (_, table) = table(
            r#"{"nodes": [{"id": "a", "kind": "nothing_such"},
                {"id": "b", "kind": "output", "at": [400, 0]}],
                "wires": [{"from": "a.out", "to": "b.color"}]}"#,
        );
        assert!(table.nodes[0].kind.is_missing);
        assert_eq!(table.wires.len(), 1);
    }

    #[test]
    fn a_reroute_has_the_type_of_what_it_is_given() {
        let (_, table) = table(
            r#"{"nodes": [{"id": "a", "kind": "base"}, {"id": "r", "kind": "reroute"},
                {"id": "b", "kind": "output"}],
                "wires": [{"from": "r", "to": "b.color"}, {"from": "a", "to": "r.value"}]}"#,
        );
        assert_eq!(table.wires[0].ty, Type::Composite);
    }
}
