//! Drags under way: their course and their result.

use std::collections::HashSet;

use eframe::egui::{Pos2, Rect, Ui, Vec2, vec2};

use super::gesture::{Gesture, Move, WireDrag};
use super::palette::Palette;
use super::table::{CanvasItem, Socket, point_at};
use super::{Canvas, arrange, edits};
use crate::catalog::NodeKind;
use crate::commands::Command;
use crate::document::{Edit, Endpoint, GraphId, InterfacePort};
use crate::ids::{GROUP_INPUTS, NodeId};
use crate::state::interface;
use crate::state::session::Session;

/// Spacing of the grid that nodes snap to, in points of the graph.
const GRID: f32 = 24.0;
/// Distance within which an edge snaps, in points of the screen.
const REACH: f32 = 5.0;
/// Distance below which a node dragged with Alt is wired to its neighbor, in points of the graph.
const NEAR: f32 = 90.0;

impl Canvas {
    pub(super) fn go_on(&mut self, ui: &Ui, session: &Session, out: &mut Vec<Command>) {
        let Some(at) = ui.input(|input| input.pointer.latest_pos()) else { return };
        let graph_at = self.view.to_graph(at);
        match &mut self.gesture {
            Gesture::Move(_) => self.go_on_moving(ui, graph_at),
            Gesture::Box { from, before } => {
                let area = Rect::from_two_pos(*from, graph_at);
                let before = before.clone();
                self.select_where(&before, session, out, |rect| rect.intersects(area));
            }
            Gesture::Lasso { path, before } => {
                path.push(graph_at);
                let (path, before) = (path.clone(), before.clone());
                self.select_where(&before, session, out, |rect| is_inside(rect.center(), &path));
            }
            Gesture::Cut { path } => path.push(graph_at),
            Gesture::Note { id, from, by, is_resize } => {
                *by = graph_at - *from;
                let (id, by, is_resize) = (id.clone(), *by, *is_resize);
                if let Some((row, note)) = self
                    .table
                    .notes
                    .iter_mut()
                    .find(|row| row.id == id)
                    .zip(session.graph().notes.get(&id))
                {
                    let corner = Pos2::new(note.position[0] as f32, note.position[1] as f32);
                    row.rect.set_width(if is_resize {
                        (note.width as f32 + by.x).max(60.0)
                    } else {
                        row.rect.width()
                    });
                    row.rect = Rect::from_min_size(
                        if is_resize { corner } else { corner + by },
                        row.rect.size(),
                    );
                    row.text = None;
                }
            }
            Gesture::Wire(drag) => {
                let fixed = drag.fixed;
                let radius = 16.0 / self.view.zoom.max(0.4);
                let target =
                    self.table.socket_at(graph_at, radius, |socket| self.fits(fixed, socket));
                if let Gesture::Wire(drag) = &mut self.gesture {
                    drag.target = target;
                }
            }
            Gesture::Idle | Gesture::Pan => {}
        }
    }

    fn select_where(
        &self,
        before: &[NodeId],
        session: &Session,
        out: &mut Vec<Command>,
        is_inside: impl Fn(Rect) -> bool,
    ) {
        let mut selection = before.to_vec();
        let inside =
            self.table.nodes.iter().filter(|row| is_inside(row.rect)).map(|row| row.id.clone());
        selection.extend(inside.filter(|id| !before.contains(id)));
        if !selection.iter().eq(session.selection.nodes()) {
            out.push(Command::Select(selection));
        }
    }

    fn go_on_moving(&mut self, ui: &Ui, pointer: Pos2) {
        let modifiers = ui.input(|input| input.modifiers);
        let Gesture::Move(drag) = &mut self.gesture else { return };
        let nodes = drag.nodes.clone();
        let (by, wished) = (drag.by, pointer - drag.from);
        // Bounds of the nodes as they would be without snapping.
        let moved = edits::around(nodes.iter().map(|&index| self.table.nodes[index].rect))
            .translate(wished - by);
        let is_free = modifiers.command || modifiers.ctrl;
        let (snapped, guides) =
            if is_free { (wished, Vec::new()) } else { self.snapped(moved, wished, &nodes) };
        self.table.translate(&nodes, snapped - by);
        let into = self.wire_under(&nodes);
        let joins = if modifiers.alt { self.neighbor(&nodes) } else { None };
        let frame =
            self.table.frame_at(pointer, &nodes).map(|index| self.table.frames[index].id.clone());
        if let Gesture::Move(drag) = &mut self.gesture {
            (drag.by, drag.guides, drag.into, drag.joins, drag.frame) =
                (snapped, guides, into, joins, frame);
        }
    }

    /// Distance that the nodes move, adjusted so that an edge lies on a neighbor's edge or their
    /// corner on the grid, and the guide lines to draw.
    fn snapped(
        &self,
        moved: Rect,
        wished: Vec2,
        nodes: &HashSet<usize>,
    ) -> (Vec2, Vec<(bool, f32, [f32; 2])>) {
        let visible = self.view.visible();
        let rows = self.table.nodes.iter().enumerate();
        let others =
            rows.filter(|(index, row)| !nodes.contains(index) && row.rect.intersects(visible));
        let snap = arrange::snap(moved, others.map(|(_, row)| row.rect), REACH / self.view.zoom);
        let mut shift = snap.shift;
        if self.snaps_to_grid {
            let to_grid = |x: f32| (x / GRID).round() * GRID - x;
            if snap.upright.is_none() {
                shift.x = to_grid(moved.min.x);
            }
            if snap.level.is_none() {
                shift.y = to_grid(moved.min.y);
            }
        }
        let upright = snap.upright.map(|(at, reach)| (true, at, reach));
        (
            wished + shift,
            upright.into_iter().chain(snap.level.map(|(at, reach)| (false, at, reach))).collect(),
        )
    }

    /// Index of the wire under a lone unwired node, if the node can be put into that wire.
    fn wire_under(&self, nodes: &HashSet<usize>) -> Option<usize> {
        let mut indices = nodes.iter();
        let (Some(&node), None) = (indices.next(), indices.next()) else { return None };
        if self.table.wires.iter().any(|wire| wire.from.node == node || wire.to.node == node) {
            return None;
        }
        let rect = self.table.nodes[node].rect;
        let near =
            self.table.wires.iter().enumerate().filter(|(_, wire)| wire.bounds.intersects(rect));
        let crosses = |index: usize| {
            let curve = self.table.curve(&self.table.wires[index]);
            (1..16).any(|step| rect.shrink(6.0).contains(point_at(&curve, step as f32 / 16.0)))
        };
        near.map(|(index, _)| index)
            .filter(|&index| crosses(index))
            .find(|&index| self.insertion(node, index).is_some())
    }

    /// Input and output by which a node is put into a wire, by index.
    fn insertion(&self, node: usize, wire: usize) -> Option<(usize, usize)> {
        let wire = &self.table.wires[wire];
        let kind = &self.table.nodes[node].kind;
        let target = &self.table.nodes[wire.to.node];
        let into = target.kind.inputs.get(wire.to.port)?;
        let takes = |index: &usize| kind.inputs[*index].takes(&wire.ty);
        let exact = |index: &usize| kind.inputs[*index].ty == wire.ty;
        let input = (0..kind.inputs.len()).find(|index| takes(index) && exact(index));
        let input = input.or_else(|| (0..kind.inputs.len()).find(takes))?;
        let gives = |index: &usize| {
            into.takes(&kind.outputs[*index].ty) || target.kind.is_reroute || target.is_end
        };
        let exact = |index: &usize| kind.outputs[*index].ty == into.ty;
        let output = (0..kind.outputs.len()).find(|index| gives(index) && exact(index));
        let output = output
            .or_else(|| (0..kind.outputs.len()).find(|index| gives(index) || kind.is_reroute))?;
        Some((input, output))
    }

    /// The best wire between two nodes, from `a` to `b`: first free inputs, then exact types.
    pub(super) fn pair(&self, a: usize, b: usize) -> Option<(Socket, Socket)> {
        let (from, to) = (&self.table.nodes[a], &self.table.nodes[b]);
        let (output, input) = edits::best_pair(&from.kind, &to.kind, |input| !to.is_wired[input])?;
        Some((
            Socket { node: a, port: output, is_output: true },
            Socket { node: b, port: input, is_output: false },
        ))
    }

    /// Best wire to the nearest node left or right of the dragged node.
    fn neighbor(&self, nodes: &HashSet<usize>) -> Option<(Socket, Socket)> {
        let mut indices = nodes.iter();
        let (Some(&node), None) = (indices.next(), indices.next()) else { return None };
        let rect = self.table.nodes[node].rect;
        let others = self.table.nodes.iter().enumerate().filter(|(index, _)| *index != node);
        let mut near: Vec<(f32, usize)> = others
            .map(|(index, row)| {
                (rect.distance_sq_to_pos(row.rect.clamp(rect.center())).sqrt(), index)
            })
            .filter(|(distance, _)| *distance < NEAR)
            .collect();
        near.sort_by(|a, b| a.0.total_cmp(&b.0));
        near.into_iter().find_map(|(_, other)| {
            let is_right = self.table.nodes[other].rect.center().x > rect.center().x;
            if is_right { self.pair(node, other) } else { self.pair(other, node) }
        })
    }

    pub(super) fn finish(&mut self, at: Option<Pos2>, session: &Session, out: &mut Vec<Command>) {
        match std::mem::take(&mut self.gesture) {
            Gesture::Move(drag) if drag.by != Vec2::ZERO || drag.joins.is_some() => {
                self.finish_move(&drag, session, out);
            }
            Gesture::Note { id, by, is_resize, .. } if by != Vec2::ZERO => {
                let edit = edits::set_note(session, &id, |note| {
                    if is_resize {
                        note.width = (note.width + f64::from(by.x)).round().clamp(60.0, 2000.0);
                    } else {
                        let [x, y] = note.position;
                        note.position =
                            [(x + f64::from(by.x)).round(), (y + f64::from(by.y)).round()];
                    }
                });
                out.extend(edit.map(Command::Edit));
                self.table.forget();
            }
            Gesture::Cut { path } => self.finish_cut(&path, session, out),
            Gesture::Wire(drag) => self.finish_wire(&drag, at, session, out),
            _ => {}
        }
    }

    fn finish_move(&mut self, drag: &Move, session: &Session, out: &mut Vec<Command>) {
        let ids: Vec<NodeId> =
            drag.nodes.iter().map(|&index| self.table.nodes[index].id.clone()).collect();
        let mut all = vec![edits::translate(session, ids.iter(), drag.by)];
        if let (Some(wire), [id]) = (drag.into, ids.as_slice())
            && let Some(node) = self.table.index_of(id)
            && let Some((input, output)) = self.insertion(node, wire)
        {
            let row = &self.table.wires[wire];
            let into = self.endpoint(Socket { node, port: input, is_output: false });
            let from = self.endpoint(Socket { node, port: output, is_output: true });
            all.push(edits::connect(session, self.endpoint(row.from), into));
            all.push(edits::connect(session, from, self.endpoint(row.to)));
        }
        if let Some((from, to)) = drag.joins {
            all.push(edits::connect(session, self.endpoint(from), self.endpoint(to)));
        }
        if !drag.is_frame {
            // The nodes leave a frame of which other nodes stay behind, and join the frame below
            // the pointer.
            let leaves = |id: &NodeId| {
                let index = self.table.index_of(id)?;
                let frame = &self.table.frames[self.table.frame_of(index)?];
                Some(
                    drag.frame.as_ref() != Some(&frame.id)
                        && !frame.nodes.iter().all(|node| drag.nodes.contains(node)),
                )
            };
            let changing: Vec<NodeId> =
                ids.into_iter().filter(|id| leaves(id).unwrap_or(drag.frame.is_some())).collect();
            all.extend(edits::join_frame(session, &changing, drag.frame.as_ref()));
        }
        let edit = if all.len() == 1 { all.remove(0) } else { Edit::Group { edits: all } };
        out.push(Command::Edit(edit));
        self.table.forget();
    }

    /// Removes every wire that a stroke crosses.
    fn finish_cut(&self, path: &[Pos2], session: &Session, out: &mut Vec<Command>) {
        let is_cut = |wire: &super::table::WireRow| self.is_cut(wire, path);
        let cut = self.table.wires.iter().filter(|wire| is_cut(wire));
        let wires = cut.filter_map(|wire| session.graph().wires.get(wire.index));
        let edits: Vec<Edit> = wires.map(|wire| edits::disconnect(session, wire.clone())).collect();
        out.extend((!edits.is_empty()).then_some(Command::Edit(Edit::Group { edits })));
    }

    /// True if a stroke crosses a wire.
    pub(super) fn is_cut(&self, wire: &super::table::WireRow, path: &[Pos2]) -> bool {
        const PIECES: usize = 24;
        let mut bounds = Rect::NOTHING;
        path.iter().for_each(|&p| bounds.extend_with(p));
        if !wire.bounds.intersects(bounds) {
            return false;
        }
        let curve = self.table.curve(wire);
        let points: Vec<Pos2> =
            (0..=PIECES).map(|i| point_at(&curve, i as f32 / PIECES as f32)).collect();
        points.windows(2).any(|piece| path.windows(2).any(|stroke| crosses(piece, stroke)))
    }

    fn finish_wire(
        &mut self,
        drag: &WireDrag,
        at: Option<Pos2>,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let picked = drag.picked.and_then(|index| session.graph().wires.get(index)).cloned();
        let Some(target) = drag.target else {
            if let Some(at) = at
                && let Some(edit) = self.new_port(drag, at, session)
            {
                out.push(Command::Edit(edit));
            } else if let Some(wire) = picked {
                out.push(Command::Edit(edits::disconnect(session, wire)));
            } else if let Some(at) = at.filter(|at| self.view.screen.contains(*at)) {
                self.palette = Some(Palette::new(at, Some(self.loose(drag.fixed))));
            }
            return;
        };
        let (from, to) =
            if drag.fixed.is_output { (drag.fixed, target) } else { (target, drag.fixed) };
        let connect = edits::connect(session, self.endpoint(from), self.endpoint(to));
        match picked {
            Some(wire) if wire.to == self.endpoint(to) => {}
            Some(wire) => {
                let remove = edits::disconnect(session, wire);
                out.push(Command::Edit(Edit::Group { edits: vec![remove, connect] }));
            }
            None => out.push(Command::Edit(connect)),
        }
    }

    /// Edit that adds a port to the open group, where a wire is let go on one of the group's ends.
    fn new_port(&self, drag: &WireDrag, at: Pos2, session: &Session) -> Option<Edit> {
        let Some(CanvasItem::Node(index)) = self.hit(at) else { return None };
        let row = &self.table.nodes[index];
        let is_output = row.id.as_str() != GROUP_INPUTS;
        let (GraphId::Definition(id), Some(definition)) =
            (session.selection.graph_id(), session.graph_view().definition())
        else {
            return None;
        };
        if !row.is_end || drag.fixed.is_output != is_output || session.graph_view().is_read_only() {
            return None;
        }
        let fixed = self.endpoint(drag.fixed);
        let name = interface::free_port(definition, is_output, fixed.port.as_str());
        // The new input's default is the inner node's own value, so that the picture stays the
        // same.
        let own = session.graph().nodes.get(&fixed.node).filter(|_| !is_output);
        let default = own.and_then(|node| node.values.get(&fixed.port)).cloned();
        let port = InterfacePort { name: name.clone(), default, ..InterfacePort::default() };
        let interface = interface::set(id, definition, |changed| {
            if is_output { changed.outputs.push(port) } else { changed.inputs.push(port) }
        });
        let end = Endpoint { node: row.id.clone(), port: name };
        let (from, to) = if is_output { (fixed, end) } else { (end, fixed) };
        Some(Edit::Group { edits: vec![interface, edits::connect(session, from, to)] })
    }

    /// Endpoint in the document (node and port name) of a socket.
    pub(super) fn endpoint(&self, socket: Socket) -> Endpoint {
        let row = &self.table.nodes[socket.node];
        let kind: &NodeKind = &row.kind;
        let ports = if socket.is_output { &kind.outputs } else { &kind.inputs };
        Endpoint { node: row.id.clone(), port: ports[socket.port].name.clone() }
    }
}

/// True if two straight pieces cross.
fn crosses(a: &[Pos2], b: &[Pos2]) -> bool {
    let side = |p: Pos2, q: Pos2, r: Pos2| (q - p).x * (r - p).y - (q - p).y * (r - p).x;
    let (&[a0, a1], &[b0, b1]) = (a, b) else { return false };
    side(a0, a1, b0) * side(a0, a1, b1) < 0.0 && side(b0, b1, a0) * side(b0, b1, a1) < 0.0
}

/// True if a point lies within a loop: a ray to the right crosses the loop an odd number of times.
fn is_inside(p: Pos2, path: &[Pos2]) -> bool {
    let far = p + vec2(1e8, 0.371);
    let closing = [path.last().copied().unwrap_or(p), path.first().copied().unwrap_or(p)];
    let count =
        path.windows(2).chain([&closing[..]]).filter(|piece| crosses(piece, &[p, far])).count();
    count % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    #[test]
    fn a_loop_has_an_inside() {
        let path =
            [pos2(0.0, 0.0), pos2(10.0, 0.0), pos2(10.0, 10.0), pos2(5.0, 3.0), pos2(0.0, 10.0)];
        assert!(is_inside(pos2(2.0, 2.0), &path));
        assert!(!is_inside(pos2(5.0, 6.0), &path), "the notch is outside");
        assert!(!is_inside(pos2(-1.0, 2.0), &path));
    }

    #[test]
    fn strokes_cross() {
        assert!(crosses(&[pos2(0.0, 0.0), pos2(4.0, 4.0)], &[pos2(0.0, 4.0), pos2(4.0, 0.0)]));
        assert!(!crosses(&[pos2(0.0, 0.0), pos2(1.0, 1.0)], &[pos2(0.0, 4.0), pos2(4.0, 0.0)]));
    }
}
