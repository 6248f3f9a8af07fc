//! The node canvas. It owns no graph: it reads the document, keeps a table derived from it, draws what is in view as one
//! mesh, and returns what the artist's hand asks for.
//!
//! One widget covers the canvas, and what lies under the pointer is found in the table; 5,000 nodes as widgets of their
//! own would cost tens of milliseconds a frame (docs/decisions.md has the measurements).

mod draw;
pub(crate) mod edits;
mod gesture;
mod mesh;
mod palette;
mod table;
mod text;
mod view;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use eframe::egui;
use eframe::egui::epaint::Mesh;
use eframe::egui::{Pos2, Rect, Response, Role, Sense, Ui, WidgetInfo};

use super::command::Command;
use super::session::Session;
use super::theme;
use crate::diag::{Diagnostic, Severity};
use crate::document::Endpoint;
use crate::ids::NodeId;
use gesture::Gesture;
use palette::Palette;
use table::{Hit, Socket, Table};
use view::View;

/// As many nodes in view are named for screen readers; a far view of more is a picture, not a form.
const MAX_NAMED: usize = 120;

/// What a node is marked with.
struct Mark {
    severity: Severity,
    text: String,
}

/// The canvas and what it remembers between frames.
#[derive(Default)]
pub struct Canvas {
    view: View,
    table: Table,
    buffer: Arc<Mesh>,
    gesture: Gesture,
    hovered: Option<Hit>,
    palette: Option<Palette>,
    marks: HashMap<NodeId, Mark>,
    marks_number: Option<u64>,
    /// How full the font image was, pixels a point, and whether the theme was dark.
    fonts: (f32, f32, bool),
    document: Option<u64>,
    reveal: Option<NodeId>,
    wants_search: bool,
    hint: String,
}

impl Canvas {
    /// Shows the canvas in all the room there is.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "Node canvas"));
        self.view.screen = rect;
        self.sync(ui, session);
        let mut commands = Vec::new();
        let pointer = response.contains_pointer().then(|| ui.input(|input| input.pointer.hover_pos())).flatten();
        self.hovered = match self.gesture {
            Gesture::Idle => pointer.and_then(|p| self.hit(p)),
            _ => None,
        };
        self.navigate(ui, &response, pointer);
        self.gestures(ui, &response, session, &mut commands);
        self.keys(ui, pointer, session, &mut commands);
        let latest = ui.input(|input| input.pointer.latest_pos());
        self.draw(ui, session, latest);
        self.name_nodes(ui, session);
        self.tell(ui, &response);
        self.show_palette(ui, session, &mut commands);
        commands
    }

    /// Shows the canvas and lets what a hand asks for go; for measuring.
    pub fn show_alone(&mut self, ui: &mut Ui, session: &Session) {
        drop(self.show(ui, session));
    }

    fn sync(&mut self, ui: &Ui, session: &Session) {
        let key = (session.document_number(), session.revision());
        if self.table.sync(key, &session.look().graph, &session.catalog) {
            // Indices are others now.
            self.gesture = Gesture::Idle;
        }
        if self.document != Some(session.document_number()) {
            self.document = Some(session.document_number());
            self.view.fit(self.table.bounds());
            self.palette = None;
        }
        // Where the font image was made anew, galleys point at what is no longer there.
        let fill = ui.fonts(|fonts| fonts.font_atlas_fill_ratio());
        let fonts = (fill, ui.pixels_per_point(), ui.visuals().dark_mode);
        if fonts.0 < self.fonts.0 || (fonts.1, fonts.2) != (self.fonts.1, self.fonts.2) {
            self.table.forget_text();
        }
        self.fonts = fonts;
        if self.marks_number != Some(session.problems_number()) {
            self.marks_number = Some(session.problems_number());
            self.marks = marks(session.all_problems());
        }
        if let Some(id) = self.reveal.take()
            && let Some(index) = self.table.index_of(&id)
        {
            self.view.reveal(self.table.nodes[index].rect);
        }
    }

    fn hit(&self, at: Pos2) -> Option<Hit> {
        // Far away sockets are not drawn, and so not hit.
        let radius = if self.view.zoom > 0.25 { 9.0 / self.view.zoom.max(0.6) } else { 0.0 };
        self.table.hit(self.view.to_graph(at), radius)
    }

    /// The sockets that a wire from `fixed` may end at.
    fn fitting_sockets(&self, fixed: Socket) -> HashSet<(usize, usize, bool)> {
        let visible = self.view.visible().expand(20.0);
        let near = (0..self.table.nodes.len()).filter(|&node| self.table.nodes[node].rect.intersects(visible));
        let sockets = near.flat_map(|node| self.table.sockets(node));
        let fits = sockets.filter(|&socket| socket == fixed || self.fits(fixed, socket));
        fits.map(|socket| (socket.node, socket.port, socket.is_output)).collect()
    }

    /// Whether two sockets may be wired.
    fn fits(&self, a: Socket, b: Socket) -> bool {
        if a.is_output == b.is_output || a.node == b.node {
            return false;
        }
        let (output, input) = if a.is_output { (a, b) } else { (b, a) };
        let port = &self.table.nodes[input.node].kind.inputs[input.port];
        let from = self.table.socket_type(output);
        port.takes(&from) || self.table.nodes[output.node].kind.is_reroute && port.is_wirable()
    }

    fn endpoint(&self, socket: Socket) -> Endpoint {
        let row = &self.table.nodes[socket.node];
        let ports = if socket.is_output { &row.kind.outputs } else { &row.kind.inputs };
        Endpoint { node: row.id.clone(), port: ports[socket.port].name.clone() }
    }

    /// Gives the nodes in view names that screen readers and tests find.
    fn name_nodes(&self, ui: &Ui, session: &Session) {
        let visible = self.view.visible();
        let in_view = || self.table.nodes.iter().filter(|row| row.rect.intersects(visible));
        if in_view().nth(MAX_NAMED).is_some() {
            return;
        }
        for row in in_view() {
            let rect = self.view.rect_to_screen(row.rect).intersect(self.view.screen);
            let response = ui.interact(rect, ui.scope_id().with(("node", &row.id)), Sense::hover());
            response.widget_info(|| {
                let problem = self.marks.get(&row.id).map(|mark| format!(", {}", mark.text));
                let selected = if session.selection.contains(&row.id) { ", selected" } else { "" };
                let name = format!("Node {}{selected}{}", row.title, problem.unwrap_or_default());
                WidgetInfo::labeled(Role::Label, true, name)
            });
        }
    }

    /// Says what is under the pointer, and what may be done with it.
    fn tell(&mut self, ui: &Ui, response: &Response) {
        self.hint = self.hint_text().to_owned();
        if self.palette.is_some() || !matches!(self.gesture, Gesture::Idle) || ui.input(|i| i.pointer.any_down()) {
            return;
        }
        let text = match self.hovered {
            Some(Hit::Socket(socket)) => self.socket_text(socket),
            Some(Hit::Node(index)) => self.marks.get(&self.table.nodes[index].id).map(|mark| mark.text.clone()),
            _ => None,
        };
        if let Some(text) = text {
            response.clone().on_hover_ui_at_pointer(|ui| {
                ui.set_max_width(340.0);
                ui.label(text);
            });
        }
    }

    fn socket_text(&self, socket: Socket) -> Option<String> {
        let kind = &self.table.nodes[socket.node].kind;
        let port = if socket.is_output { &kind.outputs[socket.port] } else { &kind.inputs[socket.port] };
        let ty = self.table.socket_type(socket);
        let help = if port.help.is_empty() { String::new() } else { format!("\n{}", port.help) };
        Some(format!("{} ({ty}){help}", port.label))
    }

    fn hint_text(&self) -> &'static str {
        match (&self.gesture, self.hovered) {
            (Gesture::Wire(_), _) => "Let go on a bright socket to wire it, on nothing to add a node that fits",
            (Gesture::Move { .. }, _) => "Let go to put down · Esc puts back",
            (Gesture::Box { .. }, _) => "Let go to select what is inside · Shift adds",
            (Gesture::Pan, _) => "Moving the view",
            (_, Some(Hit::Socket(Socket { is_output: true, .. }))) => "Drag to an input to wire it",
            (_, Some(Hit::Socket(_))) => "Drag to an output to wire it; a wire that is there is picked up",
            (_, Some(Hit::Node(_))) => "Click to select, drag to move · Del removes · Ctrl+D duplicates",
            (_, Some(Hit::Wire(_))) => "Drag its end at the input to pick it up · Alt-click removes it",
            _ => {
                "Double-click or Tab adds a node · drag selects · wheel zooms · right or middle drag moves · F shows all"
            }
        }
    }

    /// What may be done at the pointer.
    pub(crate) fn hint(&self) -> &str {
        &self.hint
    }

    /// Brings a node into view in the next frame.
    pub(crate) fn reveal(&mut self, id: NodeId) {
        self.reveal = Some(id);
    }

    /// A place of the graph for a new node: at a place of the screen, or in the middle of the view.
    pub(crate) fn place_for(&self, at: Option<Pos2>) -> Pos2 {
        match at {
            Some(at) => self.view.to_graph(at),
            None => self.view.center - egui::vec2(theme::NODE_WIDTH / 2.0, theme::TITLE_HEIGHT),
        }
    }

    /// Shows the whole graph.
    pub fn fit(&mut self) {
        self.view.fit(self.table.bounds());
    }

    /// Where a node is on the screen; for tests.
    pub fn node_rect(&self, id: &str) -> Option<Rect> {
        let index = self.table.index_of(&id.into())?;
        Some(self.view.rect_to_screen(self.table.nodes[index].rect))
    }

    /// Where a socket is on the screen; for tests.
    pub fn socket(&self, node: &str, port: &str, is_output: bool) -> Option<Pos2> {
        let index = self.table.index_of(&node.into())?;
        let kind = &self.table.nodes[index].kind;
        let port = if is_output { kind.output(port)? } else { kind.input(port)? };
        Some(self.view.to_screen(self.table.place(Socket { node: index, port, is_output })))
    }

    /// The zoom and the point of the graph at the canvas's centre; for tests.
    pub fn zoom_and_center(&self) -> (f32, Pos2) {
        (self.view.zoom, self.view.center)
    }

    /// Sets the zoom and the point of the graph at the canvas's centre.
    pub fn set_zoom_and_center(&mut self, zoom: f32, center: Pos2) {
        (self.view.zoom, self.view.center) = (zoom, center);
    }

    /// Whether a node is marked with an error; for tests.
    pub fn has_error(&self, id: &str) -> bool {
        self.marks.get(id).is_some_and(|mark| mark.severity == Severity::Error)
    }
}

/// The worst problem of each node of the look's own graph, and the text of all of them.
fn marks<'a>(problems: impl Iterator<Item = &'a Diagnostic>) -> HashMap<NodeId, Mark> {
    let mut marks: HashMap<NodeId, Mark> = HashMap::new();
    for problem in problems.filter(|problem| problem.severity > Severity::Note) {
        let Some(id) = problem.place.node.as_ref().and_then(|path| path.outermost()) else { continue };
        let text = super::problems::sentence(problem);
        match marks.get_mut(id) {
            Some(mark) => {
                mark.severity = mark.severity.max(problem.severity);
                mark.text += "\n";
                mark.text += &text;
            }
            None => drop(marks.insert(id.clone(), Mark { severity: problem.severity, text })),
        }
    }
    marks
}
