//! SVG of a graph, as the canvas shows it: frames, notes, wires, nodes with their values.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::sync::Arc;

use super::palette::{self, Palette};
use super::svg::{escaped, fitted, short, width, wrapped};
use super::{
    FRAME_MARGIN, FRAME_TITLE, NODE_WIDTH, NOTE_PADDING, ROW_HEIGHT, SOCKET, SocketShape,
    TEXT_SIZE, TITLE_HEIGHT, node_height, row_center, wire_reach,
};
use crate::catalog::values::{InputDisplay, shown};
use crate::catalog::{Catalog, NodeKind};
use crate::document::{Graph, Look, Node};
use crate::ids::NodeId;
use crate::library::Type;

/// Margin around the drawing, in points.
const MARGIN: f32 = 24.0;
/// Gap between the nodes of a group and its ends, in points.
const END_GAP: f32 = 70.0;
/// Greatest number of reroutes that are followed for their type.
const MAX_REROUTES: usize = 64;
/// Height of a note's line, in points.
const LINE: f32 = 17.0;
/// Classes of the types' colors in a drawing.
const TYPES: [(Type, &str); 10] = [
    (Type::Float, "tf"),
    (Type::Int, "ti"),
    (Type::Bool, "tb"),
    (Type::Vec3, "tv"),
    (Type::Color, "tc"),
    (Type::Composite, "tk"),
    (Type::Angle, "ta"),
    (Type::Light, "tl"),
    (Type::Curve, "tr"),
    (Type::Text, "to"),
];

/// Rectangle: x, y, width and height, in points.
type Rect = [f32; 4];

struct Row {
    kind: Arc<NodeKind>,
    title: String,
    node: Node,
    rect: Rect,
    wired: Vec<bool>,
}

impl Row {
    /// The position of an output's or an input's socket.
    fn place(&self, port: usize, is_output: bool) -> [f32; 2] {
        let [x, y, ..] = self.rect;
        let x = if is_output { x + NODE_WIDTH } else { x };
        if self.node.collapsed {
            return [x, y + TITLE_HEIGHT / 2.0];
        }
        [x, y + row_center(if is_output { port } else { self.kind.outputs.len() + port })]
    }
}

/// Ends of a wire: the index of a node and the index of a port each.
struct Joint {
    from: (usize, usize),
    to: (usize, usize),
}

/// Nodes and wires of a graph, laid out.
struct Drawing<'a> {
    look: &'a Look,
    rows: Vec<Row>,
    wires: Vec<Joint>,
}

/// The SVG of one of a look's graphs, dark or light like its reader's screen; `group` is the kind
/// whose graph it is, or `None` for the look's own.
///
/// Lengths are points of the canvas. The catalog must know the look's groups ([`Catalog::sync`]).
pub fn graph_svg(look: &Look, graph: &Graph, catalog: &Catalog, group: Option<&str>) -> String {
    let drawing = Drawing::new(look, graph, catalog, group);
    drawing.svg(graph)
}

/// The SVG of a node of a kind, unwired.
pub fn node_svg(kind: &str, catalog: &Catalog) -> String {
    let mut look = Look::default();
    look.graph.nodes.insert(kind.into(), Node { kind: kind.to_owned(), ..Node::default() });
    graph_svg(&look, &look.graph, catalog, None)
}

/// The rectangle of a node as it is drawn.
fn rect_of(node: &Node, kind: &NodeKind) -> Rect {
    // A position may be any finite number.
    let [x, y] = node.position.map(|x| (x as f32).clamp(-1e6, 1e6));
    let rows = kind.inputs.len() + kind.outputs.len();
    [x, y, NODE_WIDTH, if node.collapsed { TITLE_HEIGHT } else { node_height(rows) }]
}

/// Pairs of a graph's nodes that overlap as drawn, wholly or in part. The catalog must know the
/// look's groups ([`Catalog::sync`]).
pub fn overlapping(graph: &Graph, catalog: &Catalog) -> Vec<[NodeId; 2]> {
    let missing = catalog.missing_in(graph);
    let kind = |id: &NodeId, node: &Node| missing.get(id).or_else(|| catalog.of(node)).cloned();
    let placed =
        graph.nodes.iter().filter_map(|(id, node)| Some((id, rect_of(node, &*kind(id, node)?))));
    let placed: Vec<(&NodeId, Rect)> = placed.collect();
    let overlap = |[x, y, w, h]: Rect, [u, v, wide, high]: Rect| {
        x < u + wide && u < x + w && y < v + high && v < y + h
    };
    let pairs = placed
        .iter()
        .enumerate()
        .flat_map(|(index, one)| placed[..index].iter().map(move |other| (other, one)));
    pairs
        .filter(|(one, other)| overlap(one.1, other.1))
        .map(|(one, other)| [one.0.clone(), other.0.clone()])
        .collect()
}

impl<'a> Drawing<'a> {
    fn new(look: &'a Look, graph: &Graph, catalog: &Catalog, group: Option<&str>) -> Self {
        let missing = catalog.missing_in(graph);
        let mut by_id: HashMap<NodeId, usize> = HashMap::new();
        let mut rows = Vec::new();
        for (id, node) in &graph.nodes {
            let Some(kind) = missing.get(id).or_else(|| catalog.of(node)).cloned() else {
                continue;
            };
            let rect = rect_of(node, &kind);
            let title =
                if node.name.is_empty() { kind.label.to_string() } else { node.name.clone() };
            by_id.insert(id.clone(), rows.len());
            let (node, wired) = (node.clone(), vec![false; kind.inputs.len()]);
            rows.push(Row { title, rect, wired, kind, node });
        }
        for (index, kind) in
            group.and_then(|group| catalog.ends(group)).into_iter().flatten().enumerate()
        {
            let [left, top, right, bottom] =
                bounds(rows.iter().map(|row| row.rect)).unwrap_or([0.0; 4]);
            let height = node_height(kind.inputs.len() + kind.outputs.len());
            let x = if index == 0 { left - END_GAP - NODE_WIDTH } else { right + END_GAP };
            by_id.insert(kind.id.as_str().into(), rows.len());
            rows.push(Row {
                title: kind.label.to_string(),
                rect: [x, ((top + bottom - height) / 2.0).round(), NODE_WIDTH, height],
                wired: vec![false; kind.inputs.len()],
                kind: Arc::new(kind),
                node: Node::default(),
            });
        }
        let mut wires = Vec::new();
        for wire in &graph.wires {
            let (Some(&from), Some(&to)) = (by_id.get(&wire.from.node), by_id.get(&wire.to.node))
            else {
                continue;
            };
            let output = rows[from].kind.output(wire.from.port.as_str());
            let input = rows[to].kind.input(wire.to.port.as_str());
            let (Some(output), Some(input)) = (output, input) else { continue };
            rows[to].wired[input] = true;
            wires.push(Joint { from: (from, output), to: (to, input) });
        }
        Self { look, rows, wires }
    }

    /// The type of an output; that of a reroute is the type of its input.
    fn type_of(&self, (mut node, mut port): (usize, usize)) -> Type {
        for _ in 0..MAX_REROUTES {
            if !self.rows[node].kind.is_reroute {
                break;
            }
            match self.wires.iter().find(|wire| wire.to.0 == node) {
                Some(wire) => (node, port) = wire.from,
                None => break,
            }
        }
        self.rows[node].kind.outputs.get(port).map_or(Type::Float, |port| port.ty.clone())
    }

    fn svg(&self, graph: &Graph) -> String {
        let mut body = String::new();
        let mut rects: Vec<Rect> = self.rows.iter().map(|row| row.rect).collect();
        let index_of: HashMap<&NodeId, usize> = graph.nodes.keys().zip(0..).collect();
        for frame in graph.frames.values() {
            let inside = frame
                .nodes
                .iter()
                .filter_map(|id| index_of.get(id))
                .filter_map(|&index| self.rows.get(index));
            let Some([left, top, right, bottom]) = bounds(inside.map(|row| row.rect)) else {
                continue;
            };
            let top = top - FRAME_TITLE + 6.0;
            let m = FRAME_MARGIN;
            let rect = [left - m, top - m, right - left + 2.0 * m, bottom - top + 2.0 * m];
            rects.push(rect);
            draw_frame(&mut body, rect, &frame.title, &frame.color);
        }
        for note in graph.notes.values() {
            let [x, y] = note.position.map(|x| (x as f32).clamp(-1e6, 1e6));
            let wide = note.width as f32;
            let lines = wrapped(&note.text, TEXT_SIZE, wide - 2.0 * NOTE_PADDING);
            let rect = [x, y, wide, lines.len() as f32 * LINE + 2.0 * NOTE_PADDING];
            rects.push(rect);
            draw_note(&mut body, rect, &lines, &note.color);
        }
        for wire in &self.wires {
            let [x0, y0] = self.rows[wire.from.0].place(wire.from.1, true);
            let [x1, y1] = self.rows[wire.to.0].place(wire.to.1, false);
            let reach = wire_reach(x1 - x0);
            let class = class_of(&self.type_of(wire.from));
            let points = [x0, y0, x0 + reach, y0, x1 - reach, y1, x1, y1].map(short);
            let [x0, y0, ax, ay, bx, by, x1, y1] = points;
            let _ = writeln!(
                body,
                r#"<path class="w {class}" d="M{x0} {y0}C{ax} {ay} {bx} {by} {x1} {y1}"/>"#
            );
        }
        (0..self.rows.len()).for_each(|index| self.draw_node(&mut body, index));
        let [left, top, right, bottom] =
            bounds(rects.into_iter()).unwrap_or([0.0, 0.0, NODE_WIDTH, TITLE_HEIGHT]);
        let (x, y) = (left - MARGIN, top - MARGIN);
        let (w, h) = (right - left + 2.0 * MARGIN, bottom - top + 2.0 * MARGIN);
        let [x, y, w, h] = [x, y, w, h].map(short);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{x} {y} {w} {h}\" width=\"{w}\" \
             height=\"{h}\" \
             font-family=\"system-ui, sans-serif\" \
             font-size=\"{TEXT_SIZE}\">\n<style>\n{}</style>\n\
             <rect class=\"g\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" \
             rx=\"10\"/>\n{body}</svg>\n",
            style(),
        )
    }

    fn draw_node(&self, body: &mut String, index: usize) {
        let row = &self.rows[index];
        let [x, y, w, h] = row.rect;
        let class = category_class(&row.kind.category);
        let muted = if row.node.muted { r#" opacity="0.45""# } else { "" };
        let [left, top, wide, high] = [x, y, w, h].map(short);
        let _ = writeln!(
            body,
            "<g{muted}><rect class=\"n\" x=\"{left}\" y=\"{top}\" width=\"{wide}\" \
             height=\"{high}\" rx=\"6\"/>"
        );
        // Titles are round above, and below too if there is only the title.
        let foot = if row.node.collapsed { 6.0 } else { 0.0 };
        let down = short(TITLE_HEIGHT - 6.0 - foot);
        let level = short(w - 12.0);
        let (last, lower) = (short(w - 2.0 * foot), short(TITLE_HEIGHT - 6.0 - foot));
        let corner = if foot > 0.0 { "a6 6 0 0 1 -6 6" } else { "" };
        let other = if foot > 0.0 { "a6 6 0 0 1 -6 -6" } else { "" };
        let start = short(x + 6.0);
        let _ = writeln!(
            body,
            "<path class=\"{class}\" d=\"M{start} {top}h{level}a6 6 0 0 1 6 \
             6v{down}{corner}h-{last}{other}v-{lower}a6 6 0 0 1 6 -6z\"/>"
        );
        text(
            body,
            "x",
            (x + 10.0, y + TITLE_HEIGHT / 2.0),
            &fitted(&row.title, TEXT_SIZE, w - 18.0),
            "",
        );
        if !row.node.collapsed {
            self.draw_rows(body, row);
        }
        let ends = |is_output: bool| {
            let ports = if is_output { &row.kind.outputs } else { &row.kind.inputs };
            let shown = if row.node.collapsed { 1 } else { usize::MAX };
            let wirable =
                ports.iter().enumerate().filter(move |(_, port)| is_output || port.is_wirable());
            wirable.take(shown).map(move |(port, _)| (port, is_output))
        };
        for (port, is_output) in ends(true).chain(ends(false)) {
            let ty = if is_output {
                self.type_of((index, port))
            } else {
                row.kind.inputs[port].ty.clone()
            };
            socket(body, &ty, row.place(port, is_output));
        }
        body.push_str("</g>\n");
    }

    fn draw_rows(&self, body: &mut String, row: &Row) {
        let [x, y, w, _] = row.rect;
        for (index, port) in row.kind.outputs.iter().enumerate() {
            let at = (x + w - 12.0, y + row_center(index));
            text(body, "x", at, &fitted(&port.label, TEXT_SIZE, w - 24.0), "end");
        }
        for (index, port) in row.kind.inputs.iter().enumerate() {
            let middle = y + row_center(row.kind.outputs.len() + index);
            let is_wired = row.wired[index];
            let mut room = w - 24.0;
            match if is_wired { InputDisplay::Nothing } else { shown(port, &row.node, self.look) } {
                InputDisplay::Nothing => {}
                InputDisplay::Color(color) => {
                    swatch(body, (x + w - 40.0, middle - ROW_HEIGHT / 2.0 + 3.5), color);
                    room -= 34.0;
                }
                InputDisplay::Source(value) => {
                    let value = fitted(&value, TEXT_SIZE, w * 0.5);
                    room -= width(&value, TEXT_SIZE) + 8.0;
                    text(body, "s", (x + w - 12.0, middle), &value, "end");
                }
                InputDisplay::Text(value) => {
                    let value = fitted(&value, TEXT_SIZE, w * 0.5);
                    room -= width(&value, TEXT_SIZE) + 8.0;
                    text(body, "x", (x + w - 12.0, middle), &value, "end");
                }
            }
            let class = if is_wired { "x" } else { "d" };
            text(body, class, (x + 12.0, middle), &fitted(&port.label, TEXT_SIZE, room), "");
        }
    }
}

/// The left, top, right and bottom edge around all rectangles.
fn bounds(rects: impl Iterator<Item = Rect>) -> Option<[f32; 4]> {
    rects.fold(None, |all: Option<[f32; 4]>, [x, y, w, h]| {
        let [left, top, right, bottom] = all.unwrap_or([x, y, x + w, y + h]);
        Some([left.min(x), top.min(y), right.max(x + w), bottom.max(y + h)])
    })
}

fn text(body: &mut String, class: &str, (x, y): (f32, f32), text: &str, anchor: &str) {
    let anchor =
        if anchor.is_empty() { String::new() } else { format!(r#" text-anchor="{anchor}""#) };
    // The middle of the small letters is put on the row's middle.
    let [x, y] = [x, y + 0.35 * TEXT_SIZE].map(short);
    let _ =
        writeln!(body, r#"<text class="{class}" x="{x}" y="{y}"{anchor}>{}</text>"#, escaped(text));
}

fn socket(body: &mut String, ty: &Type, [x, y]: [f32; 2]) {
    let class = class_of(ty);
    let shape = SocketShape::of(ty);
    if shape == SocketShape::Circle {
        let [x, y] = [x, y].map(short);
        let _ = writeln!(body, r#"<circle class="k {class}" cx="{x}" cy="{y}" r="{SOCKET}"/>"#);
        return;
    }
    let corner =
        |(dx, dy): &(f32, f32)| format!("{},{}", short(x + SOCKET * dx), short(y + SOCKET * dy));
    let corners: Vec<String> = shape.outline().iter().map(corner).collect();
    let _ = writeln!(body, r#"<polygon class="k {class}" points="{}"/>"#, corners.join(" "));
}

fn swatch(body: &mut String, (x, y): (f32, f32), color: [f64; 4]) {
    let [red, green, blue, alpha] = color.map(|x| x.clamp(0.0, 1.0));
    let hex = format!("#{:06x}", packed([red, green, blue]));
    let [left, top, high] = [x, y, ROW_HEIGHT - 7.0].map(short);
    let _ = writeln!(
        body,
        r#"<rect class="c" x="{left}" y="{top}" width="28" height="{high}" rx="2" fill="{hex}"/>"#
    );
    if alpha < 1.0 {
        // The left half is opaque, so that the hue of a transparent color is seen.
        let middle = short(x + 14.0);
        let rect = format!(r#"x="{middle}" y="{top}" width="14" height="{high}""#);
        let _ = writeln!(
            body,
            r#"<rect class="b" {rect}/><rect {rect} fill="{hex}" fill-opacity="{alpha:.2}"/>"#
        );
    }
}

fn draw_frame(body: &mut String, [x, y, w, h]: Rect, title: &str, color: &[f64]) {
    let fill = own_color(color);
    let [left, top, wide, high] = [x, y, w, h].map(short);
    let _ = writeln!(
        body,
        r#"<rect class="f" x="{left}" y="{top}" width="{wide}" height="{high}" rx="8"{fill}/>"#
    );
    let title = if title.is_empty() { "Frame" } else { title };
    text(body, "x", (x + 10.0, y + FRAME_TITLE / 2.0), &fitted(title, TEXT_SIZE, w - 20.0), "");
}

fn draw_note(body: &mut String, [x, y, w, h]: Rect, lines: &[String], color: &[f64]) {
    let fill = own_color(color);
    let [left, top, wide, high] = [x, y, w, h].map(short);
    let _ = writeln!(
        body,
        r#"<rect class="o" x="{left}" y="{top}" width="{wide}" height="{high}" rx="4"{fill}/>"#
    );
    for (index, line) in lines.iter().enumerate() {
        text(
            body,
            "x",
            (x + NOTE_PADDING, y + NOTE_PADDING + LINE * (index as f32 + 0.5)),
            line,
            "",
        );
    }
}

/// The style of a color that an artist gave; empty where the theme's color applies.
fn own_color(color: &[f64]) -> String {
    match <[f64; 3]>::try_from(color) {
        Ok(color) => format!(r#" style="fill:#{0:06x};stroke:#{0:06x}""#, packed(color)),
        Err(_) => String::new(),
    }
}

fn packed(color: [f64; 3]) -> u32 {
    color.iter().fold(0, |all, x| all << 8 | (x.clamp(0.0, 1.0) * 255.0).round() as u32)
}

fn class_of(ty: &Type) -> &'static str {
    let color = palette::DARK.of_type(ty);
    TYPES
        .iter()
        .find(|(known, _)| palette::DARK.of_type(known) == color)
        .map_or("to", |(_, class)| class)
}

fn category_class(category: &str) -> String {
    let color = palette::DARK.of_category(category);
    let index = palette::DARK.categories().iter().position(|known| *known == color);
    format!("h{}", index.unwrap_or_default())
}

/// The style sheet of both themes; the reader's screen chooses.
fn style() -> String {
    let plain = "text{stroke:none}.w{fill:none;stroke-width:2.4}.k{stroke-width:1.5}\
                 .n{stroke-width:1}\
                 .f{fill-opacity:.2;stroke-opacity:.6}.o{fill-opacity:.12;stroke-opacity:.45}\n";
    format!(
        "{plain}{}@media (prefers-color-scheme:light){{\n{}}}\n",
        theme(&palette::DARK),
        theme(&palette::LIGHT)
    )
}

fn theme(palette: &Palette) -> String {
    let Palette { canvas, node, node_edge, swatch_edge, text, dim, frame, note, .. } = palette;
    let mut css = format!(
        ".g{{fill:#{canvas:06x}}}.n{{fill:#{node:06x};stroke:#{node_edge:06x}}}\
         .b{{fill:#{node:06x}}}\
         .x{{fill:#{text:06x}}}.d{{fill:#{dim:06x}}}.s{{fill:#{dim:06x};fill-opacity:.7}}\
         .c{{stroke:#{swatch_edge:06x}}}\
         .f{{fill:#{frame:06x};stroke:#{frame:06x}}}.o{{fill:#{note:06x};stroke:#{note:06x}}}\n"
    );
    for (ty, class) in &TYPES {
        let color = palette.of_type(ty);
        let _ = write!(
            css,
            ".{class}{{stroke:#{color:06x}}}.k.{class}{{fill:#{color:06x};stroke:#{node_edge:06x}}}"
        );
    }
    css.push('\n');
    for (index, color) in palette.categories().iter().enumerate() {
        let _ = write!(css, ".h{index}{{fill:#{color:06x}}}");
    }
    css.push('\n');
    css
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::library::Library;

    fn drawn(json: &str) -> String {
        let look = Look::read(json, "test").value.unwrap();
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&look, Library::built_in());
        graph_svg(&look, &look.graph, &catalog, None)
    }

    #[test]
    fn nodes_wires_and_values_are_there() {
        let svg = drawn(
            r#"{"nodes": [{"id": "a", "kind": "base", "name": "Skin <1>",
                "values": {"color": [1, 0.5, 0, 1]}},
                {"id": "b", "kind": "output", "at": [400, 0]}], "wires": [{"from": "a",
                "to": "b.color"}]}"#,
        );
        assert!(svg.contains("Skin &lt;1&gt;") && svg.contains("#ff8000"), "{svg}");
        assert_eq!(svg.matches("class=\"w tk\"").count(), 1, "one wire, of a composite: {svg}");
        assert_eq!(svg.matches("class=\"n\"").count(), 2);
    }

    #[test]
    fn no_nodes_of_an_example_lie_on_each_other() {
        let mut problems = Vec::new();
        for name in crate::examples::documents()
            .filter(|name| !["scenes/", "shots/"].iter().any(|folder| name.starts_with(folder)))
        {
            let text =
                crate::examples::text(Path::new(&format!("{}{name}", crate::examples::PREFIX)))
                    .unwrap();
            let look = Look::read(&text, name).value.unwrap();
            let mut catalog = Catalog::new(Library::built_in());
            catalog.sync(&look, Library::built_in());
            let inner =
                look.definitions.iter().map(|(id, definition)| (id.to_string(), &definition.graph));
            for (graph_name, graph) in inner.chain([(String::new(), &look.graph)]) {
                let found = overlapping(graph, &catalog);
                problems.extend(
                    found
                        .iter()
                        .map(|[one, other]| format!("{name} {graph_name}: {one} and {other}")),
                );
            }
        }
        assert!(problems.is_empty(), "{problems:#?}");
        // A row lower the nodes touch, which is no overlap.
        let two = |y: f32| {
            let json = format!(
                r#"{{"nodes": [{{"id": "a", "kind": "uv", "at": [0, 0]}}, {{"id": "b", "kind": "uv",
                    "at": [100, {y}]}}]}}"#
            );
            let look = Look::read(&json, "test").value.unwrap();
            overlapping(&look.graph, &Catalog::new(Library::built_in())).len()
        };
        let high = node_height(1);
        assert_eq!([two(0.0), two(high - 1.0), two(high), two(-high)], [1, 1, 0, 0]);
    }

    #[test]
    fn unknown_kinds_and_far_places_are_drawn() {
        let svg = drawn(
            r#"{"nodes": [{"id": "a", "kind": "nothing_such", "at": [1e300, -1e300]},
                {"id": "b", "kind": "output"}],
                "wires": [{"from": "a.out", "to": "b.color"}]}"#,
        );
        assert!(
            svg.contains("nothing_such?") && !svg.contains("inf") && !svg.contains("NaN"),
            "{svg}"
        );
    }

    #[test]
    fn every_kind_of_node_is_drawn() {
        let catalog = Catalog::new(Library::built_in());
        for kind in catalog.all().filter(|kind| kind.id != crate::catalog::CUSTOM_KIND) {
            let svg = node_svg(&kind.id, &catalog);
            assert!(
                svg.contains(&escaped(&fitted(&kind.label, TEXT_SIZE, NODE_WIDTH - 18.0))),
                "{}",
                kind.id
            );
            let wirable = kind.inputs.iter().filter(|port| port.is_wirable()).count();
            assert_eq!(
                svg.matches("class=\"k ").count(),
                kind.outputs.len() + wirable,
                "{}",
                kind.id
            );
        }
    }
}
