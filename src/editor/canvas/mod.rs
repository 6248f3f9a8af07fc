//! The node canvas. The canvas owns no graph: it reads the document, keeps a table derived from it,
//! draws the visible part as one mesh, and returns the commands that the artist's gestures ask for.
//!
//! One widget covers the canvas, and what lies under the pointer is found in the table; 5,000 nodes
//! as widgets of their own would cost tens of milliseconds a frame (docs/decisions.md has the
//! measurements).

mod actions;
mod arrange;
mod costs;
mod drag;
mod draw;
mod draw_items;
pub(crate) mod edits;
mod gesture;
mod inplace;
mod marks;
mod mesh;
mod overlay;
pub(crate) mod palette;
mod passes;
mod preview;
mod readings;
mod shot_marks;
mod table;
mod text;
mod view;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::{Text, text, tr};
use eframe::egui;
use eframe::egui::epaint::Mesh;
use eframe::egui::{Pos2, Rect, Response, Role, Sense, Ui, WidgetInfo};

use crate::commands::{Command, GraphCommand};
use crate::diag::Severity;
use crate::document::{GraphId, Wire};
use crate::ids::NodeId;
use crate::library::Type;
use crate::state::revision::{DocumentNumber, ProblemsRevision};
use crate::state::session::Session;
use crate::widgets::theme;
use gesture::Gesture;
use inplace::{Item, TextEditInPlace};
use marks::{IdleReason, Mark};
use palette::Palette;
use shot_marks::ShotMark;
use table::{CanvasItem, Socket, Table};
use view::CanvasView;

/// Largest number of nodes in view that are named for screen readers; a far view of more nodes is a
/// picture, not a form.
const MAX_NAMED: usize = 120;

/// Largest number of nodes in view at which their sockets are named too.
const MAX_WITH_SOCKETS: usize = 30;

/// Message for attempts to change a group of the library.
const READ_ONLY: Text = text!("This group is of the library: make it the look's own to change it");

/// The canvas and its state between frames.
#[derive(Default)]
pub struct Canvas {
    view: CanvasView,
    table: Table,
    buffer: Arc<Mesh>,
    gesture: Gesture,
    hovered: Option<CanvasItem>,
    palette: Option<Palette>,
    marks: HashMap<NodeId, Mark>,
    marks_revision: Option<ProblemsRevision>,
    /// Nodes with values that the open shot changes.
    shot_marks: HashMap<NodeId, ShotMark>,
    /// Fill ratio of the font image, pixels per point, and true for a dark theme.
    fonts: (f32, f32, bool),
    document: Option<DocumentNumber>,
    /// Groups through which the open graph is reached, and the views (zoom and center) in which
    /// other graphs were left.
    place: Vec<NodeId>,
    views: HashMap<Vec<NodeId>, (f32, Pos2)>,
    /// Nodes that add nothing, with the reasons.
    idle: HashMap<NodeId, IdleReason>,
    /// Frame or note that is selected.
    item: Option<Item>,
    editing: Option<TextEditInPlace>,
    /// Item to edit in place as soon as it exists.
    edit_when_there: Option<Item>,
    menu_at: Option<Pos2>,
    menu_hit: Option<CanvasItem>,
    previews: preview::Previews,
    costs: costs::Costs,
    readings: readings::Readings,
    /// Command that the command palette asked for.
    asked: Option<GraphCommand>,
    snaps_to_grid: bool,
    hides_minimap: bool,
    reveal: Option<NodeId>,
    wants_search: bool,
    hint: String,
}

impl Canvas {
    /// Shows the canvas in all available space.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Node canvas")));
        self.view.screen = rect;
        self.sync(ui, session);
        let mut commands = Vec::new();
        let pointer = response
            .contains_pointer()
            .then(|| ui.input(|input| input.pointer.hover_pos()))
            .flatten();
        self.hovered = match self.gesture {
            Gesture::Idle => pointer.and_then(|p| self.hit(p)),
            _ => None,
        };
        self.navigate(ui, &response, pointer);
        self.gestures(ui, &response, session, &mut commands);
        self.keys(ui, pointer, session, &mut commands);
        let latest = ui.input(|input| input.pointer.latest_pos());
        self.draw(ui, session, latest);
        self.draw_previews(ui, session);
        self.draw_costs(ui, session);
        self.draw_readings(ui, session);
        self.name_nodes(ui, session);
        self.minimap(ui);
        self.crumbs(ui, session, &mut commands);
        self.tell(ui, &response, session);
        self.menu(ui, &response, session, &mut commands);
        self.show_palette(ui, session, &mut commands);
        self.edit_in_place(ui, session, &mut commands);
        if session.graph_view().is_read_only() {
            let is_edit =
                |command: &Command| matches!(command, Command::Edit(_) | Command::EditHeld(..));
            // Making the group the look's own, and naming its outputs, changes the look alone.
            let owns = |command: &Command| {
                use crate::document::Edit;
                matches!(command, Command::Edit(Edit::AddDefinition { .. } | Edit::SetAovs { .. }))
            };
            let count = commands.len();
            commands.retain(|command| !is_edit(command) || owns(command));
            if commands.len() < count {
                self.table.forget();
                commands.push(Command::Tell(READ_ONLY.tr().to_owned()));
            }
        }
        commands
    }

    /// Shows the canvas and drops its commands; for measurements.
    pub fn show_alone(&mut self, ui: &mut Ui, session: &Session) {
        drop(self.show(ui, session));
    }

    fn sync(&mut self, ui: &Ui, session: &Session) {
        let revisions = (session.revisions().document, session.revision());
        let language = chiaro_locale::spoken_tag();
        let key = (revisions.0, revisions.1, session.selection.graph_number(), language);
        let is_open =
            self.document == Some(revisions.0) && self.place == session.selection.open_groups();
        let group = match session.selection.graph_id() {
            GraphId::Look => None,
            GraphId::Definition(id) => Some(id.as_str()),
        };
        if self.table.sync(
            key,
            session.graph(),
            &session.project.catalog,
            group,
            &session.graph_view().driving_nodes(),
        ) {
            // Indices in the table have changed, so that gestures that hold some must end.
            self.gesture = Gesture::Idle;
            self.menu_hit = None;
            self.note_passes(session);
            if is_open {
                self.show_added(session);
            }
        }
        self.shot_marks = shot_marks::shot_marks(session);
        self.measure_notes(ui);
        if self.document != Some(session.revisions().document) {
            self.document = Some(session.revisions().document);
            self.views.clear();
            self.place = session.selection.open_groups().to_vec();
            self.begin();
            (self.palette, self.editing, self.item) = (None, None, None);
        } else if self.place != session.selection.open_groups() {
            let left = std::mem::replace(&mut self.place, session.selection.open_groups().to_vec());
            self.views.insert(left, (self.view.zoom, self.view.center));
            match self.views.get(&self.place) {
                Some(&(zoom, center)) => self.set_zoom_and_center(zoom, center),
                None => self.begin(),
            }
            (self.palette, self.editing, self.item) = (None, None, None);
        }
        // When the font image is made anew, galleys refer to glyphs that no longer exist.
        let fill = ui.fonts(|fonts| fonts.font_atlas_fill_ratio());
        let fonts = (fill, ui.pixels_per_point(), ui.visuals().dark_mode);
        if fonts.0 < self.fonts.0 || (fonts.1, fonts.2) != (self.fonts.1, self.fonts.2) {
            self.table.forget_text();
        }
        self.fonts = fonts;
        if self.marks_revision != Some(session.revisions().problems) {
            self.marks_revision = Some(session.revisions().problems);
            self.marks = marks::marks(session);
            self.idle = marks::idle(session);
        }
        if let Some(id) = self.reveal.take()
            && let Some(index) = self.table.index_of(&id)
        {
            self.view.reveal(self.table.nodes[index].rect);
        }
    }

    /// Brings new nodes into view where one of them is selected, as after pasting: these are the
    /// artist's, while others come back by undo. A node whose head is seen stays where it was
    /// dropped.
    fn show_added(&mut self, session: &Session) {
        let added = || self.table.added.iter().map(|&index| &self.table.nodes[index]);
        let seen = self.view.visible();
        let is_away = added().any(|row| !seen.contains(row.rect.min));
        if is_away && added().any(|row| session.selection.nodes.contains(&row.id)) {
            self.view.include(edits::around(added().map(|row| row.rect)));
        }
    }

    fn hit(&self, at: Pos2) -> Option<CanvasItem> {
        // Sockets are not drawn from afar, and so not hit.
        let radius = if self.view.zoom > 0.25 { 9.0 / self.view.zoom.max(0.6) } else { 0.0 };
        self.table.hit(self.view.to_graph(at), radius)
    }

    /// Sockets that a wire from `fixed` may end at.
    fn fitting_sockets(&self, fixed: Socket) -> HashSet<(usize, usize, bool)> {
        let visible = self.view.visible().expand(20.0);
        let near = (0..self.table.nodes.len())
            .filter(|&node| self.table.nodes[node].rect.intersects(visible));
        let sockets = near.flat_map(|node| self.table.sockets(node));
        let fits = sockets.filter(|&socket| socket == fixed || self.fits(fixed, socket));
        fits.map(|socket| (socket.node, socket.port, socket.is_output)).collect()
    }

    /// True if two sockets may be wired.
    fn fits(&self, a: Socket, b: Socket) -> bool {
        if a.is_output == b.is_output || a.node == b.node {
            return false;
        }
        let (output, input) = if a.is_output { (a, b) } else { (b, a) };
        let port = &self.table.nodes[input.node].kind.inputs[input.port];
        let from = self.table.socket_type(output);
        port.takes(&from)
            || self.table.nodes[output.node].kind.is_reroute && port.is_wirable()
            || self.table.nodes[input.node].is_end
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
                let is_selected = session.selection.nodes.contains(&row.id);
                WidgetInfo::labeled(Role::Label, true, self.node_name(row, is_selected))
            });
        }
        if in_view().nth(MAX_WITH_SOCKETS).is_none() && self.view.zoom > 0.25 {
            self.name_sockets(ui, visible);
        }
        let frames =
            self.table.frames.iter().map(|row| (row.rect, tr!("Frame {title}", title = row.title)));
        let notes =
            self.table.notes.iter().map(|row| (row.rect, tr!("Note {text}", text = row.content)));
        for (index, (rect, name)) in frames.chain(notes).enumerate().take(MAX_NAMED) {
            let rect = self.view.rect_to_screen(rect).intersect(self.view.screen);
            if rect.is_positive() {
                let response =
                    ui.interact(rect, ui.scope_id().with(("item", index)), Sense::hover());
                response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
            }
        }
    }

    /// Name of a node with all that its marks say.
    fn node_name(&self, row: &table::NodeRow, is_selected: bool) -> String {
        let is_changed = self.shot_marks.contains_key(&row.id);
        let parts = [
            Some(tr!("Node {title}", title = row.title)),
            is_selected.then(|| tr!("node" => "selected").to_owned()),
            row.is_muted.then(|| tr!("node" => "muted").to_owned()),
            row.each_of.clone(),
            self.idle_of(row).map(|idle| idle.word.tr().to_owned()),
            is_changed.then(|| tr!("node" => "changed by the shot").to_owned()),
            self.marks.get(&row.id).map(|mark| mark.text.clone()),
        ];
        parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
    }

    /// Gives the sockets of nodes in view names, by which wires can be drawn between them.
    fn name_sockets(&self, ui: &Ui, visible: Rect) {
        let nodes = (0..self.table.nodes.len())
            .filter(|&node| self.table.nodes[node].rect.intersects(visible));
        for socket in nodes.flat_map(|node| self.table.sockets(node)) {
            let at = self.view.to_screen(self.table.place(socket));
            let rect =
                Rect::from_center_size(at, egui::Vec2::splat(10.0)).intersect(self.view.screen);
            if !rect.is_positive() {
                continue;
            }
            let row = &self.table.nodes[socket.node];
            let id = ui.scope_id().with(("socket", &row.id, socket.port, socket.is_output));
            ui.interact(rect, id, Sense::hover()).widget_info(|| {
                let kind = &row.kind;
                let node = &row.title;
                let name = if socket.is_output {
                    let port = row.shown(&kind.outputs[socket.port].label);
                    tr!("Output {port} of {node}")
                } else {
                    let port = row.shown(&kind.inputs[socket.port].label);
                    tr!("Input {port} of {node}")
                };
                let name = match self.pass_at(socket) {
                    Some(pass) => tr!("{name}, pass {pass}"),
                    None => name,
                };
                WidgetInfo::labeled(Role::Label, true, name)
            });
        }
    }

    /// Shows a tooltip on the item under the pointer, and sets the hint on possible actions.
    fn tell(&mut self, ui: &Ui, response: &Response, session: &Session) {
        self.hint = self.hint_text().to_owned();
        if self.palette.is_some()
            || !matches!(self.gesture, Gesture::Idle)
            || ui.input(|i| i.pointer.any_down())
        {
            return;
        }
        let text = match self.hovered {
            Some(CanvasItem::Socket(socket)) => self.socket_text(socket),
            Some(CanvasItem::Node(index)) => self.node_text(session, index),
            Some(CanvasItem::Wire(index)) => self.wire_text(index),
            _ => None,
        };
        let ball = match self.hovered {
            Some(CanvasItem::Socket(Socket { node, is_output: true, port: 0 })) => {
                self.ball_of(session, &self.table.nodes[node].id)
            }
            _ => None,
        };
        if let Some(text) = text {
            response.clone().on_hover_ui_at_pointer(|ui| {
                ui.set_max_width(340.0);
                ui.label(text);
                if let Some(ball) = ball {
                    preview::large(ui, ball);
                }
            });
        }
    }

    fn socket_text(&self, socket: Socket) -> Option<String> {
        let row = &self.table.nodes[socket.node];
        let ports = if socket.is_output { &row.kind.outputs } else { &row.kind.inputs };
        let port = &ports[socket.port];
        let ty = self.table.socket_type(socket);
        let mut lines = vec![format!("{} ({})", row.shown(&port.label), ty.label())];
        if !port.help.is_empty() {
            lines.push(row.shown(&port.help).to_owned());
        }
        lines.extend(
            self.pass_at(socket)
                .map(|name| tr!("The pass (AOV) \"{name}\": chiaro render --aov {name}")),
        );
        Some(lines.join("\n"))
    }

    /// Problem of a node, or the reason why it adds nothing, and what the open shot changes of it.
    fn node_text(&self, session: &Session, index: usize) -> Option<String> {
        let texts =
            [self.problem_text(index), self.shot_text(session, &self.table.nodes[index].id)];
        let texts: Vec<String> = texts.into_iter().flatten().collect();
        (!texts.is_empty()).then(|| texts.join("\n"))
    }

    fn problem_text(&self, index: usize) -> Option<String> {
        let row = &self.table.nodes[index];
        if let Some(mark) = self.marks.get(&row.id) {
            let fixes = mark.fixes.iter();
            let fixes = fixes.map(|fix| tr!("Right-click to fix: {fix}", fix = fix.label));
            let lines: Vec<String> = std::iter::once(mark.text.clone()).chain(fixes).collect();
            return Some(lines.join("\n"));
        }
        if row.is_muted {
            return Some(tr!("Muted: what comes in goes out as it is. M unmutes").to_owned());
        }
        self.idle_of(row).map(IdleReason::text)
    }

    /// Reason why a node adds nothing: the compiler's finding, or that no output depends on the
    /// node.
    fn idle_of(&self, row: &table::NodeRow) -> Option<&IdleReason> {
        if row.is_unused { Some(&marks::UNWIRED) } else { self.idle.get(&row.id) }
    }

    /// Conversion of a wire's value: its type, the type that it becomes, and any loss.
    fn wire_text(&self, index: usize) -> Option<String> {
        let wire = self.table.wires.get(index)?;
        let becomes = wire.becomes.as_ref()?;
        let [from, to] = [&wire.ty, becomes].map(Type::label);
        Some(match wire.ty.converts_without_loss(becomes) {
            true => tr!("{from} becomes {to} here"),
            false => tr!("{from} becomes {to} here; something is lost on the way"),
        })
    }

    fn hint_text(&self) -> &'static str {
        match (&self.gesture, self.hovered) {
            (Gesture::Wire(_), _) => {
                tr!("Let go on a bright socket to wire it, on nothing to add a node that fits")
            }
            (Gesture::Move(drag), _) if drag.into.is_some() => {
                tr!("Let go to put the node into this wire · Esc puts back")
            }
            (Gesture::Move(drag), _) if drag.joins.is_some() => {
                tr!("Let go to wire it to its neighbor")
            }
            (Gesture::Move(drag), _) if drag.frame.is_some() => {
                tr!("Let go to put it into the frame")
            }
            (Gesture::Move(_), _) => {
                tr!("Let go to put down · Alt wires to a neighbor, Ctrl does not snap · Esc puts \
                     back")
            }
            (Gesture::Note { .. }, _) => tr!("Let go to put down · the right edge sets the width"),
            (Gesture::Cut { .. }, _) => tr!("Let go to cut the wires that are crossed"),
            (Gesture::Lasso { .. }, _) => tr!("Let go to select what is inside"),
            (Gesture::Box { .. }, _) => tr!("Let go to select what is inside · Shift adds"),
            (Gesture::Pan, _) => tr!("Moving the view"),
            (_, Some(CanvasItem::Socket(Socket { is_output: true, .. }))) => {
                tr!("Drag to an input to wire it")
            }
            (_, Some(CanvasItem::Socket(_))) => {
                tr!("Drag to an output to wire it; a wire that is there is picked up")
            }
            (_, Some(CanvasItem::Node(_))) => {
                tr!("Click to select, drag to move · Del removes · Ctrl+D duplicates · Ctrl+G \
                     groups · M mutes · S swaps")
            }
            (_, Some(CanvasItem::Wire(_))) => {
                tr!("Double-click adds a reroute · Alt-click removes it · Ctrl+right-drag cuts")
            }
            (_, Some(CanvasItem::Frame(_))) => {
                tr!("Drag to move all of it · double-click renames · right-click colors")
            }
            (_, Some(CanvasItem::Note(_))) => {
                tr!("Drag to move · double-click edits · right-click colors")
            }
            _ => {
                tr!("Double-click or Tab adds a node · drag selects · wheel zooms · right or \
                     middle drag moves · F shows all · ? lists keys")
            }
        }
    }

    /// Hint on the actions possible at the pointer.
    pub(crate) fn hint(&self) -> &str {
        &self.hint
    }

    /// Asks for a command, to be run in the next frame.
    pub(crate) fn ask(&mut self, command: GraphCommand) {
        self.asked = Some(command);
    }

    /// Value of a node's first output, where it is the same everywhere; for tests.
    pub fn value_text(&self, session: &Session, id: &str) -> Option<&str> {
        self.value_of(session, &id.into())
    }

    /// True if a node shows a ball as the preview of its output; for tests.
    pub fn has_ball(&self, session: &Session, id: &str) -> bool {
        self.ball_of(session, &id.into()).is_some()
    }

    /// Rectangle of a frame's title on the screen; for tests.
    pub fn frame_title(&self, id: &str) -> Option<Rect> {
        let frame = self.table.frames.iter().find(|frame| frame.id.as_str() == id)?;
        Some(self.view.rect_to_screen(frame.title_rect()))
    }

    /// Rectangle of a note on the screen; for tests.
    pub fn note_rect(&self, id: &str) -> Option<Rect> {
        let note = self.table.notes.iter().find(|note| note.id.as_str() == id)?;
        Some(self.view.rect_to_screen(note.rect))
    }

    /// Word for the reason why a node adds nothing; for tests.
    pub fn idle_word(&self, id: &str) -> Option<&'static str> {
        let row = &self.table.nodes[self.table.index_of(&id.into())?];
        self.idle_of(row).map(|idle| idle.word.english())
    }

    /// Brings a node into view in the next frame.
    pub(crate) fn reveal(&mut self, id: NodeId) {
        self.reveal = Some(id);
    }

    /// Wire under a point of the screen.
    pub(crate) fn wire_at(&self, session: &Session, at: Pos2) -> Option<Wire> {
        match self.table.hit(self.view.to_graph(at), 6.0 / self.view.zoom)? {
            CanvasItem::Wire(row) => {
                session.graph().wires.get(self.table.wires.get(row)?.index).cloned()
            }
            _ => None,
        }
    }

    /// Place of the graph for a new node: under a point of the screen, or in the middle of the
    /// view.
    pub(crate) fn place_for(&self, at: Option<Pos2>) -> Pos2 {
        match at {
            Some(at) => self.view.to_graph(at),
            None => self.view.center - egui::vec2(theme::NODE_WIDTH / 2.0, theme::TITLE_HEIGHT),
        }
    }

    /// Shows a graph that was just opened.
    fn begin(&mut self) {
        self.view.begin(self.table.bounds(), self.table.last());
    }

    /// Shows the whole graph.
    pub fn fit(&mut self) {
        self.view.fit(self.table.bounds());
    }

    /// Rectangle of a node on the screen; for tests.
    pub fn node_rect(&self, id: &str) -> Option<Rect> {
        let index = self.table.index_of(&id.into())?;
        Some(self.view.rect_to_screen(self.table.nodes[index].rect))
    }

    /// Position of a socket on the screen; for tests.
    pub fn socket(&self, node: &str, port: &str, is_output: bool) -> Option<Pos2> {
        let index = self.table.index_of(&node.into())?;
        let kind = &self.table.nodes[index].kind;
        let port = if is_output { kind.output(port)? } else { kind.input(port)? };
        Some(self.view.to_screen(self.table.place(Socket { node: index, port, is_output })))
    }

    /// Zoom, and the point of the graph at the canvas's center; for tests.
    pub fn zoom_and_center(&self) -> (f32, Pos2) {
        (self.view.zoom, self.view.center)
    }

    /// Sets the zoom and the point of the graph at the canvas's center.
    pub fn set_zoom_and_center(&mut self, zoom: f32, center: Pos2) {
        (self.view.zoom, self.view.center) = (zoom, center);
    }

    /// True if a node is marked with an error; for tests.
    pub fn has_error(&self, id: &str) -> bool {
        self.marks.get(id).is_some_and(|mark| mark.severity == Severity::Error)
    }
}
