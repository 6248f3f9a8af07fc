//! What a hand does on the canvas: the state machine of drags, the wheel, clicks and keys.

use eframe::egui;
use std::collections::HashSet;

use eframe::egui::{Key, Modifiers, PointerButton, Pos2, Rect, Response, Ui, Vec2, vec2};

use super::super::command::Command;
use super::super::session::Session;
use super::super::theme::{ROW_HEIGHT, TITLE_HEIGHT};
use super::Canvas;
use super::edits;
use super::palette::{Loose, Outcome, Palette};
use super::table::{Hit, Socket};
use crate::document::{Edit, GraphId};
use crate::ids::NodeId;

/// A drag that is going on.
#[derive(Default)]
pub(super) enum Gesture {
    /// None.
    #[default]
    Idle,
    /// The view follows the pointer.
    Pan,
    /// A rectangle from a point of the graph; with the nodes that were selected before.
    Box { from: Pos2, before: Vec<NodeId> },
    /// Nodes follow the pointer.
    Move { nodes: HashSet<usize>, by: Vec2 },
    /// A wire's loose end follows the pointer.
    Wire(WireDrag),
}

/// A wire with a loose end.
pub(super) struct WireDrag {
    /// The end that stays.
    pub(super) fixed: Socket,
    /// The wire of the graph that was picked up, by index.
    pub(super) picked: Option<usize>,
    /// The socket that it would snap to.
    pub(super) target: Option<Socket>,
}

impl Canvas {
    /// The wheel zooms about the pointer; middle, right or space drags move the view.
    pub(super) fn navigate(&mut self, ui: &Ui, response: &Response, pointer: Option<Pos2>) {
        if let Some(at) = pointer.filter(|_| self.palette.is_none()) {
            let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            let factor = (scroll / 380.0).exp() * pinch;
            if factor != 1.0 {
                self.view.zoom_about(at, factor);
            }
        }
        let with_space = response.dragged_by(PointerButton::Primary) && ui.input(|input| input.key_down(Key::Space));
        let is_pan = response.dragged_by(PointerButton::Middle) || response.dragged_by(PointerButton::Secondary);
        if is_pan || with_space && matches!(self.gesture, Gesture::Idle | Gesture::Pan) {
            self.view.pan(response.drag_delta());
            self.gesture = Gesture::Pan;
        }
    }

    /// Clicks and drags with the first button.
    pub(super) fn gestures(&mut self, ui: &Ui, response: &Response, session: &Session, out: &mut Vec<Command>) {
        let modifiers = ui.input(|input| input.modifiers);
        if response.drag_started_by(PointerButton::Primary)
            && matches!(self.gesture, Gesture::Idle)
            && let Some(origin) = ui.input(|input| input.pointer.press_origin())
        {
            self.start_drag(origin, modifiers, session, out);
        }
        if response.dragged_by(PointerButton::Primary) {
            self.go_on(ui, response.drag_delta(), session, out);
        }
        if response.drag_stopped() {
            let at = ui.input(|input| input.pointer.latest_pos());
            self.finish(at, session, out);
        } else if !response.dragged() && matches!(self.gesture, Gesture::Pan) {
            self.gesture = Gesture::Idle;
        }
        let Some(at) = response.interact_pointer_pos() else { return };
        if response.double_clicked() && self.hit(at).is_none() {
            self.palette = Some(Palette::new(at, None));
        } else if response.clicked() {
            self.click(at, modifiers, session, out);
        }
    }

    fn click(&self, at: Pos2, modifiers: Modifiers, session: &Session, out: &mut Vec<Command>) {
        let is_adding = modifiers.shift || modifiers.command;
        match self.hit(at) {
            Some(Hit::Wire(index)) if modifiers.alt => {
                let wire = session.look().graph.wires.get(self.table.wires[index].index);
                out.extend(
                    wire.map(|wire| Command::Edit(Edit::RemoveWire { graph: GraphId::Look, wire: wire.clone() })),
                );
            }
            Some(Hit::Node(index) | Hit::Socket(Socket { node: index, .. })) => {
                let id = self.table.nodes[index].id.clone();
                let mut selection: Vec<NodeId> =
                    if is_adding { session.selected().cloned().collect() } else { Vec::new() };
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

    fn start_drag(&mut self, origin: Pos2, modifiers: Modifiers, session: &Session, out: &mut Vec<Command>) {
        self.gesture = match self.hit(origin) {
            Some(Hit::Socket(socket)) => Gesture::Wire(self.start_wire(socket)),
            Some(Hit::Node(index)) => {
                let id = &self.table.nodes[index].id;
                let selection: Vec<&NodeId> = session.selected().collect();
                let nodes = if selection.contains(&id) {
                    selection.iter().filter_map(|id| self.table.index_of(id)).collect()
                } else {
                    out.push(Command::Select(vec![id.clone()]));
                    HashSet::from([index])
                };
                Gesture::Move { nodes, by: Vec2::ZERO }
            }
            _ => {
                let keep = modifiers.shift || modifiers.command;
                let before = if keep { session.selected().cloned().collect() } else { Vec::new() };
                Gesture::Box { from: self.view.to_graph(origin), before }
            }
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

    fn go_on(&mut self, ui: &Ui, delta: Vec2, session: &Session, out: &mut Vec<Command>) {
        let Some(at) = ui.input(|input| input.pointer.latest_pos()) else { return };
        let graph_at = self.view.to_graph(at);
        match &mut self.gesture {
            Gesture::Move { nodes, by } => {
                let step = delta / self.view.zoom;
                *by += step;
                self.table.translate(nodes, step);
            }
            Gesture::Box { from, before } => {
                let area = Rect::from_two_pos(*from, graph_at);
                let mut selection = before.clone();
                let inside = self.table.nodes.iter().filter(|row| row.rect.intersects(area)).map(|row| row.id.clone());
                selection.extend(inside.filter(|id| !before.contains(id)));
                if !selection.iter().eq(session.selected()) {
                    out.push(Command::Select(selection));
                }
            }
            Gesture::Wire(drag) => {
                let fixed = drag.fixed;
                let radius = 16.0 / self.view.zoom.max(0.4);
                let target = self.table.socket_at(graph_at, radius, |socket| self.fits(fixed, socket));
                if let Gesture::Wire(drag) = &mut self.gesture {
                    drag.target = target;
                }
            }
            Gesture::Idle | Gesture::Pan => {}
        }
    }

    fn finish(&mut self, at: Option<Pos2>, session: &Session, out: &mut Vec<Command>) {
        match std::mem::take(&mut self.gesture) {
            Gesture::Move { nodes, by } if by != Vec2::ZERO => {
                let ids = nodes.iter().map(|&index| &self.table.nodes[index].id);
                out.push(Command::Edit(edits::translate(session.look(), ids, by)));
                self.table.forget();
            }
            Gesture::Wire(drag) => self.finish_wire(&drag, at, session, out),
            _ => {}
        }
    }

    fn finish_wire(&mut self, drag: &WireDrag, at: Option<Pos2>, session: &Session, out: &mut Vec<Command>) {
        let picked = drag.picked.and_then(|index| session.look().graph.wires.get(index)).cloned();
        let Some(target) = drag.target else {
            if let Some(wire) = picked {
                out.push(Command::Edit(Edit::RemoveWire { graph: GraphId::Look, wire }));
            } else if let Some(at) = at.filter(|at| self.view.screen.contains(*at)) {
                self.palette = Some(Palette::new(at, Some(self.loose(drag.fixed))));
            }
            return;
        };
        let (from, to) = if drag.fixed.is_output { (drag.fixed, target) } else { (target, drag.fixed) };
        let connect = edits::connect(self.endpoint(from), self.endpoint(to));
        match picked {
            Some(wire) if wire.to == self.endpoint(to) => {}
            Some(wire) => {
                let remove = Edit::RemoveWire { graph: GraphId::Look, wire };
                out.push(Command::Edit(Edit::Group { edits: vec![remove, connect] }));
            }
            None => out.push(Command::Edit(connect)),
        }
    }

    fn loose(&self, socket: Socket) -> Loose {
        let kind = &self.table.nodes[socket.node].kind;
        let accepts = if socket.is_output { Vec::new() } else { kind.inputs[socket.port].accepts.clone() };
        let ty = self.table.socket_type(socket);
        Loose { end: self.endpoint(socket), ty, accepts, is_output: socket.is_output }
    }

    /// Takes the Tab key before it moves the focus, while the pointer is on the canvas.
    pub(crate) fn claim_tab(&mut self, ui: &Ui) {
        let is_here = ui.input(|input| input.pointer.hover_pos()).is_some_and(|at| self.view.screen.contains(at));
        self.wants_search = is_here
            && self.palette.is_none()
            && !ui.ctx().egui_wants_keyboard_input()
            && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Tab));
        if self.wants_search {
            ui.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
        }
    }

    /// Keys, while no text is being typed.
    pub(super) fn keys(&mut self, ui: &Ui, pointer: Option<Pos2>, session: &Session, out: &mut Vec<Command>) {
        if self.palette.is_some() || ui.ctx().egui_wants_keyboard_input() {
            return;
        }
        let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
        if pressed(Modifiers::NONE, Key::Escape) {
            self.gesture = Gesture::Idle;
            self.table.forget();
        }
        if let Some(at) = pointer
            && (std::mem::take(&mut self.wants_search) || pressed(Modifiers::NONE, Key::A))
        {
            self.palette = Some(Palette::new(at, None));
        }
        let mut is_delete = false;
        for key in [Key::Delete, Key::Backspace, Key::X] {
            is_delete |= pressed(Modifiers::NONE, key);
        }
        if is_delete {
            out.extend(edits::delete(session.selected().cloned()).map(Command::Edit));
        }
        if pressed(Modifiers::COMMAND, Key::A) {
            out.push(Command::Select(session.look().graph.nodes.keys().cloned().collect()));
        }
        if pressed(Modifiers::COMMAND, Key::D) {
            let selected: Vec<NodeId> = session.selected().cloned().collect();
            let (ids, edit) = edits::duplicate(session.look(), &selected);
            if !ids.is_empty() {
                out.extend([Command::Edit(edit), Command::Select(ids)]);
            }
        }
        if pointer.is_some() && pressed(Modifiers::NONE, Key::F) {
            self.fit();
        }
        self.nudge(&pressed, session, out);
    }

    /// Arrow keys move what is selected.
    fn nudge(&self, pressed: &dyn Fn(Modifiers, Key) -> bool, session: &Session, out: &mut Vec<Command>) {
        const STEP: f32 = 12.0;
        let ways = [
            (Key::ArrowLeft, vec2(-STEP, 0.0)),
            (Key::ArrowRight, vec2(STEP, 0.0)),
            (Key::ArrowUp, vec2(0.0, -STEP)),
            (Key::ArrowDown, vec2(0.0, STEP)),
        ];
        if session.selection.is_empty() {
            return;
        }
        for (_, by) in ways.into_iter().filter(|(key, _)| pressed(Modifiers::NONE, *key)) {
            let edit = edits::translate(session.look(), session.selected(), by);
            out.push(Command::EditHeld(egui::Id::unique("nudge"), edit));
        }
    }

    /// Shows the search, and adds what is chosen.
    pub(super) fn show_palette(&mut self, ui: &Ui, session: &Session, out: &mut Vec<Command>) {
        let Some(palette) = &mut self.palette else { return };
        let kind = match palette.show(ui, self.view.screen, &session.catalog) {
            Outcome::Open => return,
            Outcome::Closed => {
                self.palette = None;
                return;
            }
            Outcome::Chosen(kind) => kind,
        };
        let Some(palette) = self.palette.take() else { return };
        let mut at = self.view.to_graph(palette.at);
        let fit = palette.loose.as_ref().and_then(|loose| Some((loose, loose.fit(&kind)?.0)));
        if let Some((loose, port)) = fit {
            // The socket comes to lie where the wire was let go.
            let row = if loose.is_output { kind.outputs.len() + port } else { port };
            at.y -= TITLE_HEIGHT + ROW_HEIGHT * (row as f32 + 0.5);
            if !loose.is_output {
                at.x -= super::theme::NODE_WIDTH;
            }
        }
        let (id, mut all) = edits::add(session.look(), &kind, at);
        if let Some((loose, port)) = fit {
            let ports = if loose.is_output { &kind.inputs } else { &kind.outputs };
            let new = crate::document::Endpoint { node: id.clone(), port: ports[port].name.clone() };
            let (from, to) = if loose.is_output { (loose.end.clone(), new) } else { (new, loose.end.clone()) };
            all.push(edits::connect(from, to));
        }
        out.push(Command::Edit(Edit::Group { edits: all }));
        out.push(Command::Select(vec![id]));
    }
}
