//! Gestures on the canvas: the wheel, clicks, and the drag that begins at each place.

use eframe::egui;
use std::collections::HashSet;

use eframe::egui::{Key, Modifiers, PointerButton, Pos2, Response, Ui, Vec2};

use super::inplace::Item;
use super::palette::{LooseWire, Palette, SearchOutcome};
use super::table::{CanvasItem, Socket};
use super::{Canvas, edits};
use crate::commands::{Command, keyboard};
use crate::document::{Edit, Endpoint};
use crate::drawing::{NODE_WIDTH, ROW_HEIGHT, TITLE_HEIGHT};
use crate::ids::{FrameId, NodeId, NoteId};
use crate::state::session::Session;

/// Drag that is under way.
#[derive(Default)]
pub(super) enum Gesture {
    /// No drag.
    #[default]
    Idle,
    /// The view follows the pointer.
    Pan,
    /// Rectangle of selection, from a point of the graph; `before` are the nodes that were selected
    /// before the drag.
    Box { from: Pos2, before: Vec<NodeId> },
    /// Loop of selection around nodes, in points of the graph; `before` are the nodes that were
    /// selected before the drag.
    Lasso { path: Vec<Pos2>, before: Vec<NodeId> },
    /// Stroke that cuts the wires it crosses, in points of the graph.
    Cut { path: Vec<Pos2> },
    /// Nodes follow the pointer.
    Move(Move),
    /// A note follows the pointer, or its right edge does where `is_resize` is set.
    Note { id: NoteId, from: Pos2, by: Vec2, is_resize: bool },
    /// The loose end of a wire follows the pointer.
    Wire(WireDrag),
}

/// Drag of nodes, and the effects that letting go would have.
#[derive(Default)]
pub(super) struct Move {
    pub(super) nodes: HashSet<usize>,
    /// Point where the pointer took hold, in points of the graph, and the distance that the nodes
    /// have moved.
    pub(super) from: Pos2,
    pub(super) by: Vec2,
    /// Guide lines that edges lie on: true for upright, the line's coordinate, and the range that
    /// it spans.
    pub(super) guides: Vec<(bool, f32, [f32; 2])>,
    /// Wire that the node would be put into, by index in the table.
    pub(super) into: Option<usize>,
    /// Wire that would join the node to a neighbor: output and input.
    pub(super) joins: Option<(Socket, Socket)>,
    /// Frame that the nodes would lie in.
    pub(super) frame: Option<FrameId>,
    /// True while a frame is dragged as a whole; its nodes then neither leave nor join frames.
    pub(super) is_frame: bool,
}

/// Drag of a wire's loose end.
pub(super) struct WireDrag {
    /// End of the wire that stays.
    pub(super) fixed: Socket,
    /// Wire of the graph that was picked up, by index; `None` for a new wire.
    pub(super) picked: Option<usize>,
    /// Socket that the loose end would snap to.
    pub(super) target: Option<Socket>,
}

impl Canvas {
    /// Moves the view: the wheel zooms about the pointer; drags with the middle or right button or
    /// with space pan. A right drag with Ctrl cuts wires.
    pub(super) fn navigate(&mut self, ui: &Ui, response: &Response, pointer: Option<Pos2>) {
        if let Some(at) = pointer.filter(|_| self.palette.is_none()) {
            let (scroll, pinch) =
                ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            let factor = (scroll / 380.0).exp() * pinch;
            if factor != 1.0 {
                self.view.zoom_about(at, factor);
            }
        }
        let modifiers = ui.input(|input| input.modifiers);
        let origin = ui.input(|input| input.pointer.press_origin());
        let is_idle = matches!(self.gesture, Gesture::Idle);
        if is_idle
            && (modifiers.command || modifiers.ctrl)
            && response.drag_started_by(PointerButton::Secondary)
            && let Some(origin) = origin
        {
            self.gesture = Gesture::Cut { path: vec![self.view.to_graph(origin)] };
            return;
        }
        let with_space = response.dragged_by(PointerButton::Primary)
            && ui.input(|input| input.key_down(Key::Space));
        let is_pan = response.dragged_by(PointerButton::Middle)
            || response.dragged_by(PointerButton::Secondary);
        if (is_pan || with_space) && matches!(self.gesture, Gesture::Idle | Gesture::Pan) {
            self.view.pan(response.drag_delta());
            self.gesture = Gesture::Pan;
        }
    }

    /// Handles clicks and drags.
    pub(super) fn gestures(
        &mut self,
        ui: &Ui,
        response: &Response,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let modifiers = ui.input(|input| input.modifiers);
        if response.drag_started_by(PointerButton::Primary)
            && matches!(self.gesture, Gesture::Idle)
            && let Some(origin) = ui.input(|input| input.pointer.press_origin())
        {
            self.start_drag(origin, modifiers, session, out);
        }
        if response.dragged() {
            self.go_on(ui, session, out);
        }
        if response.drag_stopped() {
            let at = ui.input(|input| input.pointer.latest_pos());
            self.finish(at, session, out);
        } else if !response.dragged() && matches!(self.gesture, Gesture::Pan) {
            self.gesture = Gesture::Idle;
        }
        let Some(at) = response.interact_pointer_pos() else { return };
        if response.double_clicked() {
            self.double_click(at, session, out);
        } else if response.clicked() {
            self.click(at, modifiers, session, out);
        }
        if response.secondary_clicked() {
            self.menu_at = Some(at);
            self.menu_hit = self.hit(at);
            if let Some(CanvasItem::Node(index) | CanvasItem::Socket(Socket { node: index, .. })) =
                self.menu_hit
                && !session.selection.nodes.contains(&self.table.nodes[index].id)
            {
                out.push(Command::Select(vec![self.table.nodes[index].id.clone()]));
            }
            self.item = self.item_of(self.menu_hit);
        }
    }

    /// Frame or note under the pointer.
    fn item_of(&self, hit: Option<CanvasItem>) -> Option<Item> {
        match hit? {
            CanvasItem::Frame(index) => Some(Item::Frame(self.table.frames[index].id.clone())),
            CanvasItem::Note(index) => Some(Item::Note(self.table.notes[index].id.clone())),
            _ => None,
        }
    }

    fn double_click(&mut self, at: Pos2, session: &Session, out: &mut Vec<Command>) {
        match self.hit(at) {
            None => self.palette = Some(Palette::new(at, None)),
            Some(CanvasItem::Node(index)) => {
                let row = &self.table.nodes[index];
                let is_title = self.view.to_graph(at).y < row.rect.min.y + TITLE_HEIGHT;
                match self.open(session, &row.id) {
                    Some(open) => out.push(open),
                    None if is_title && !row.is_end => {
                        self.edit_when_there = Some(Item::Node(row.id.clone()));
                    }
                    None => {}
                }
            }
            Some(CanvasItem::Wire(index)) => self.add_reroute(index, at, session, out),
            hit => self.edit_when_there = self.item_of(hit),
        }
    }

    /// Puts a reroute into a wire.
    fn add_reroute(&mut self, wire: usize, at: Pos2, session: &Session, out: &mut Vec<Command>) {
        let Some(kind) = session.project.catalog.get("reroute") else { return };
        let at = self.view.to_graph(at) - egui::vec2(NODE_WIDTH / 2.0, TITLE_HEIGHT + ROW_HEIGHT);
        let (id, mut all) = edits::add(session, kind, at);
        let (Some(input), Some(output)) = (kind.inputs.first(), kind.outputs.first()) else {
            return;
        };
        let row = &self.table.wires[wire];
        let into = Endpoint { node: id.clone(), port: input.name.clone() };
        let from = Endpoint { node: id.clone(), port: output.name.clone() };
        all.push(edits::connect(session, self.endpoint(row.from), into));
        all.push(edits::connect(session, from, self.endpoint(row.to)));
        out.extend([Command::Edit(Edit::Group { edits: all }), Command::Select(vec![id])]);
    }

    fn click(&mut self, at: Pos2, modifiers: Modifiers, session: &Session, out: &mut Vec<Command>) {
        let is_adding = modifiers.shift || modifiers.command;
        let hit = self.hit(at);
        self.item = self.item_of(hit);
        match hit {
            Some(CanvasItem::Wire(index)) if modifiers.alt => {
                let wire = session.graph().wires.get(self.table.wires[index].index);
                out.extend(
                    wire.map(|wire| Command::Edit(edits::disconnect(session, wire.clone()))),
                );
            }
            Some(CanvasItem::Node(index) | CanvasItem::Socket(Socket { node: index, .. })) => {
                let id = self.table.nodes[index].id.clone();
                let mut selection: Vec<NodeId> = if is_adding {
                    session.selection.nodes().cloned().collect()
                } else {
                    Vec::new()
                };
                if selection.contains(&id) {
                    selection.retain(|other| *other != id);
                } else {
                    selection.push(id);
                }
                out.push(Command::Select(selection));
            }
            _ if !is_adding => out.push(Command::Select(Vec::new())),
            _ => {}
        }
    }

    fn start_drag(
        &mut self,
        origin: Pos2,
        modifiers: Modifiers,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let keep = modifiers.shift || modifiers.command;
        let before =
            || if keep { session.selection.nodes().cloned().collect() } else { Vec::new() };
        let from = self.view.to_graph(origin);
        self.gesture = match self.hit(origin) {
            Some(CanvasItem::Socket(socket)) => Gesture::Wire(self.start_wire(socket)),
            // The places of a group's ends are computed, so that a drag there pans the view.
            Some(CanvasItem::Node(index)) if self.table.nodes[index].is_end => Gesture::Pan,
            Some(CanvasItem::Node(index)) => {
                let id = &self.table.nodes[index].id;
                let nodes = if session.selection.nodes.contains(id) {
                    let chosen = session.selection.nodes().filter_map(|id| self.table.index_of(id));
                    chosen.filter(|&index| !self.table.nodes[index].is_end).collect()
                } else {
                    out.push(Command::Select(vec![id.clone()]));
                    HashSet::from([index])
                };
                self.item = None;
                Gesture::Move(Move { nodes, from, ..Move::default() })
            }
            Some(CanvasItem::Frame(index)) => {
                let frame = &self.table.frames[index];
                self.item = Some(Item::Frame(frame.id.clone()));
                Gesture::Move(Move {
                    from,
                    nodes: frame.nodes.iter().copied().collect(),
                    is_frame: true,
                    ..Move::default()
                })
            }
            Some(CanvasItem::Note(index)) => {
                let note = &self.table.notes[index];
                self.item = Some(Item::Note(note.id.clone()));
                let is_resize = note.rect.max.x - from.x < 8.0 / self.view.zoom;
                Gesture::Note { id: note.id.clone(), from, by: Vec2::ZERO, is_resize }
            }
            _ if modifiers.alt => Gesture::Lasso { path: vec![from], before: before() },
            _ => Gesture::Box { from, before: before() },
        };
    }

    fn start_wire(&self, socket: Socket) -> WireDrag {
        if !socket.is_output
            && let Some(wire) = self.table.wire_into(socket)
        {
            let wire = &self.table.wires[wire];
            return WireDrag { fixed: wire.from, picked: Some(wire.index), target: Some(socket) };
        }
        WireDrag { fixed: socket, picked: None, target: None }
    }

    pub(super) fn loose(&self, socket: Socket) -> LooseWire {
        let kind = &self.table.nodes[socket.node].kind;
        let accepts =
            if socket.is_output { Vec::new() } else { kind.inputs[socket.port].accepts.clone() };
        let ty = self.table.socket_type(socket);
        LooseWire { end: self.endpoint(socket), ty, accepts, is_output: socket.is_output }
    }

    /// Takes the Tab key before egui moves the focus by it, while the pointer is on the canvas.
    pub(crate) fn claim_tab(&mut self, ui: &Ui) {
        let is_here = ui
            .input(|input| input.pointer.hover_pos())
            .is_some_and(|at| self.view.screen.contains(at));
        self.wants_search = is_here
            && self.palette.is_none()
            && !keyboard::is_keyboard_taken(ui.ctx())
            && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Tab));
        if self.wants_search {
            ui.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
        }
    }

    /// Shows the search for nodes, and adds the chosen node.
    pub(super) fn show_palette(&mut self, ui: &Ui, session: &Session, out: &mut Vec<Command>) {
        let Some(palette) = &mut self.palette else { return };
        let kind = match palette.show(ui, self.view.screen, &session.project.catalog) {
            SearchOutcome::Open => return,
            SearchOutcome::Closed => {
                self.palette = None;
                return;
            }
            SearchOutcome::Chosen(kind) => kind,
        };
        let Some(palette) = self.palette.take() else { return };
        if let Some((id, _)) = &palette.swaps {
            out.extend(edits::swap(session, id, &kind).map(Command::Edit));
            return;
        }
        let mut at = self.view.to_graph(palette.at);
        let fit = palette.loose.as_ref().and_then(|loose| Some((loose, loose.fit(&kind)?.0)));
        if let Some((loose, port)) = fit {
            // The new node's socket comes to lie where the wire was let go.
            let row = if loose.is_output { kind.outputs.len() + port } else { port };
            at.y -= TITLE_HEIGHT + ROW_HEIGHT * (row as f32 + 0.5);
            if !loose.is_output {
                at.x -= NODE_WIDTH;
            }
        }
        let (id, mut all) = edits::add(session, &kind, at);
        if let Some((loose, port)) = fit {
            let ports = if loose.is_output { &kind.inputs } else { &kind.outputs };
            let new = Endpoint { node: id.clone(), port: ports[port].name.clone() };
            let (from, to) =
                if loose.is_output { (loose.end.clone(), new) } else { (new, loose.end.clone()) };
            all.push(edits::connect(session, from, to));
        }
        out.push(Command::Edit(Edit::Group { edits: all }));
        out.push(Command::Select(vec![id]));
    }
}
