//! Overlays of the canvas: the path into groups, the map of the whole graph, and the context menu.

use chiaro_locale::{Text, text, tr};
use eframe::egui;
use eframe::egui::epaint::Mesh;
use eframe::egui::{
    Color32, Pos2, Rect, Response, RichText, Sense, Shape, Ui, UiBuilder, WidgetInfo, vec2,
};

use super::inplace::Item;
use super::mesh::{plain, rounded};
use super::table::{CanvasItem, Socket};
use super::{Canvas, edits};
use crate::commands::{Command, GraphCommand, table};
use crate::document::GraphId;
use crate::fields::names;
use crate::ids::NodeId;
use crate::library::Library;
use crate::state::session::Session;
use crate::widgets::menu;
use crate::widgets::theme;

/// Size of the map, in points of the screen.
const MAP: egui::Vec2 = vec2(168.0, 112.0);

/// Least room for the words on where a group comes from, in points.
const ORIGIN: f32 = 60.0;

/// Colors for frames and notes: name, straight RGB.
const TINTS: [(Text, [f64; 3]); 7] = [
    (text!("Red"), [0.72, 0.28, 0.26]),
    (text!("Orange"), [0.78, 0.5, 0.22]),
    (text!("Yellow"), [0.72, 0.66, 0.26]),
    (text!("Green"), [0.32, 0.58, 0.34]),
    (text!("Teal"), [0.22, 0.56, 0.56]),
    (text!("Blue"), [0.3, 0.42, 0.74]),
    (text!("Violet"), [0.54, 0.36, 0.7]),
];

impl Canvas {
    /// Shows the path of opened groups, and the way back.
    pub(super) fn crumbs(&self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        let path = session.selection.open_groups();
        if path.is_empty() {
            return;
        }
        let bar = Rect::from_min_size(self.view.screen.min, vec2(self.view.screen.width(), 34.0));
        ui.painter().rect_filled(bar, 0.0, theme::of(ui).panel);
        let line = bar.left_bottom()..=bar.right_bottom();
        ui.painter().line_segment([*line.start(), *line.end()], (1.0, theme::of(ui).grid));
        let builder = UiBuilder::new().max_rect(bar.shrink2(vec2(10.0, 5.0))).id_salt("crumbs");
        ui.scope_builder(builder, |ui| {
            ui.horizontal(|ui| {
                let mut crumb = |ui: &mut Ui, name: &str, depth: usize| {
                    let is_here = depth == path.len();
                    let text = RichText::new(name);
                    let text =
                        if is_here { text.strong() } else { text.color(theme::of(ui).accent) };
                    let response = ui.add(egui::Button::new(text).frame(false));
                    response.widget_info(|| {
                        WidgetInfo::labeled(egui::Role::Button, !is_here, tr!("Go to {name}"))
                    });
                    if response.clicked() && !is_here {
                        out.push(Command::OpenGraph(path[..depth].to_vec()));
                    }
                };
                crumb(ui, tr!("Look"), 0);
                for (depth, name) in crumb_names(session, path).iter().enumerate() {
                    ui.label(RichText::new("›").color(theme::of(ui).dim));
                    crumb(ui, name, depth + 1);
                }
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    if session.graph_view().is_read_only() {
                        let help = tr!(
                            "Puts this group into the look's file, for all its nodes in the look. \
                             Then it can be changed"
                        );
                        if ui.button(tr!("Make it the look's own")).on_hover_text(help).clicked() {
                            out.extend(session.graph_view().own_group().map(Command::Edit));
                        }
                        let (from, help) = origin(session);
                        let text = format!("{from}: {}", tr!("look, don't touch"));
                        // A narrow canvas has room for the path and the button alone.
                        if ui.available_width() > ORIGIN {
                            let label = RichText::new(&text).color(theme::of(ui).dim);
                            let label = ui.add(egui::Label::new(label).truncate());
                            label.on_hover_text(format!("{text}\n{help}"));
                        }
                    } else if let GraphId::Definition(id) = session.selection.graph_id() {
                        let help = tr!(
                            "Puts this group into the nodes folder beside the look, where every \
                             look of the folder has it"
                        );
                        if ui.button(tr!("Share with the project")).on_hover_text(help).clicked() {
                            out.push(Command::ShareGroup(id.clone()));
                        }
                    }
                });
            });
        });
    }

    /// Shows the whole graph as a small map in the corner; a drag there moves the view. The map
    /// appears only while part of the graph is out of view.
    pub(super) fn minimap(&mut self, ui: &Ui) {
        let all = self.table.bounds();
        let visible = self.view.visible();
        let screen = self.view.screen;
        let is_small = screen.width() < MAP.x * 2.5 || screen.height() < MAP.y * 2.5;
        if self.hides_minimap || is_small || !all.is_positive() || visible.contains_rect(all) {
            return;
        }
        let place = Rect::from_min_size(screen.max - MAP - vec2(12.0, 12.0), MAP);
        let response = ui.interact(place, ui.scope_id().with("minimap"), Sense::click_and_drag());
        response
            .widget_info(|| WidgetInfo::labeled(egui::Role::Image, true, tr!("Map of the graph")));
        // The view may lie outside of all nodes.
        let world = all.union(visible).expand(40.0);
        let scale = (place.width() / world.width()).min(place.height() / world.height());
        let to_map = |p: Pos2| place.center() + (p - world.center()) * scale;
        let map_rect = |r: Rect| Rect::from_min_max(to_map(r.min), to_map(r.max));
        if let Some(at) =
            response.interact_pointer_pos().filter(|_| response.dragged() || response.clicked())
        {
            self.view.center = world.center() + (at - place.center()) / scale;
        }
        let colors = theme::of(ui);
        let mut mesh = Mesh::default();
        rounded(&mut mesh, place.expand(1.0), 5.0, (true, true), colors.window_edge);
        rounded(&mut mesh, place, 4.0, (true, true), colors.panel.gamma_multiply(0.94));
        for frame in &self.table.frames {
            plain(&mut mesh, map_rect(frame.rect), colors.grid);
        }
        for row in &self.table.nodes {
            plain(
                &mut mesh,
                map_rect(row.rect),
                super::draw::lighter(colors.of_category(&row.kind.category)),
            );
        }
        let painter = ui.painter_at(place.expand(1.0));
        painter.add(Shape::mesh(mesh));
        let seen = map_rect(visible).intersect(place);
        painter.rect(
            seen,
            2.0,
            colors.accent.gamma_multiply(0.08),
            (1.0, colors.accent),
            egui::StrokeKind::Inside,
        );
    }

    /// Shows the context menu of a right click.
    pub(super) fn menu(
        &mut self,
        ui: &Ui,
        response: &Response,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let mut chosen = None;
        response.context_menu(|ui| {
            ui.set_min_width(210.0);
            menu::scrolling(ui, |ui| match self.menu_hit {
                Some(CanvasItem::Node(index) | CanvasItem::Socket(Socket { node: index, .. }))
                    if index < self.table.nodes.len() =>
                {
                    let output = match self.menu_hit {
                        Some(CanvasItem::Socket(socket)) if socket.is_output => Some(socket.port),
                        _ => None,
                    };
                    chosen = self.node_menu(ui, (index, output), session, out);
                }
                Some(CanvasItem::Wire(index)) => self.wire_menu(ui, index, session, out),
                Some(CanvasItem::Frame(_) | CanvasItem::Note(_)) => {
                    self.item_menu(ui, session, out);
                }
                _ => {
                    use GraphCommand as A;
                    const ROWS: [&[A]; 3] = [
                        &[A::AddNode, A::Note, A::Paste],
                        &[A::SelectAll, A::Layout],
                        &[A::ShowAll, A::Minimap, A::Costs, A::SnapGrid],
                    ];
                    chosen = rows(ui, &ROWS);
                    if !session.selection.open_groups().is_empty() {
                        chosen = chosen.or(rows(ui, &[&[A::LeaveGroup]]));
                    }
                }
            });
        });
        if chosen == Some(GraphCommand::Paste) {
            ui.ctx().send_viewport_cmd(egui::ViewportCommand::RequestPaste);
        } else if let Some(action) = chosen {
            self.run(action, self.menu_at, session, out);
        }
    }

    fn node_menu(
        &mut self,
        ui: &mut Ui,
        (index, output): (usize, Option<usize>),
        session: &Session,
        out: &mut Vec<Command>,
    ) -> Option<GraphCommand> {
        use GraphCommand as A;
        let row = &self.table.nodes[index];
        let fixes = self.marks.get(&row.id).map_or(&[][..], |mark| &mark.fixes);
        for fix in fixes {
            if ui
                .button(
                    RichText::new(tr!("Fix: {fix}", fix = fix.label)).color(theme::of(ui).accent),
                )
                .clicked()
            {
                out.push(Command::Edit(fix.edit.clone()));
            }
        }
        if !fixes.is_empty() {
            ui.separator();
        }
        if row.is_end {
            return rows(ui, &[&[A::LeaveGroup]]);
        }
        let id = row.id.clone();
        self.shot_menu(ui, session, &id, out);
        if output.is_some() {
            self.pass_menu(ui, (index, output), session, out);
            ui.separator();
        }
        let group: &[A] = if self.open(session, &id).is_some() {
            &[A::OpenGroup, A::Group, A::Ungroup, A::ShareGroup]
        } else {
            &[A::Group]
        };
        let frame: &[A] = if self.table.frame_of(index).is_some() {
            &[A::Frame, A::Unframe]
        } else {
            &[A::Frame]
        };
        let chosen = rows(
            ui,
            &[
                &[A::Rename, A::Swap, A::Mute, A::Collapse],
                group,
                frame,
                &[A::Copy, A::Cut, A::Duplicate],
                &[A::Upstream, A::Downstream],
                &[A::Delete, A::Dissolve],
            ],
        );
        if output.is_none() {
            self.pass_menu(ui, (index, None), session, out);
        }
        if session.selection.nodes.len() < 2 {
            return chosen;
        }
        let arranged = ui.menu_button(tr!("Arrange"), |ui| {
            rows(
                ui,
                &[
                    &[A::AlignLeft, A::AlignRight, A::AlignTop, A::AlignBottom],
                    &[A::DistributeAcross, A::DistributeDown],
                    &[A::Layout, A::Connect],
                ],
            )
        });
        chosen.or(arranged.inner.flatten())
    }

    fn wire_menu(&mut self, ui: &mut Ui, index: usize, session: &Session, out: &mut Vec<Command>) {
        let Some(wire) =
            self.table.wires.get(index).and_then(|row| session.graph().wires.get(row.index))
        else {
            return;
        };
        if ui.button(tr!("Remove the wire")).clicked() {
            out.push(Command::Edit(edits::disconnect(session, wire.clone())));
        }
        if ui.button(tr!("Show where it comes from")).clicked() {
            out.push(Command::Reveal(wire.from.node.clone()));
        }
        if ui.button(tr!("Show where it leads")).clicked() {
            out.push(Command::Reveal(wire.to.node.clone()));
        }
    }

    fn item_menu(&mut self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        let Some(item) = self.item.clone() else { return };
        if session.graph_view().is_read_only() {
            ui.label(origin(session).0);
            return;
        }
        if ui.button(tr!("Edit the text")).clicked() {
            self.edit_when_there = Some(item.clone());
        }
        if let Item::Frame(id) = &item
            && ui.button(tr!("Select its nodes")).clicked()
        {
            let nodes = session.graph().frames.get(id).map(|frame| frame.nodes.clone());
            out.extend(nodes.map(Command::Select));
        }
        ui.separator();
        let mut tint = None;
        ui.horizontal(|ui| {
            for (name, rgb) in TINTS {
                let (rect, response) = ui.allocate_exact_size(vec2(20.0, 20.0), Sense::click());
                response.widget_info(|| {
                    WidgetInfo::labeled(egui::Role::Button, true, tr!("Color {name}"))
                });
                ui.painter().rect_filled(rect.shrink(1.0), 4.0, color(rgb));
                if response.on_hover_text(name.tr()).clicked() {
                    tint = Some(rgb.to_vec());
                    ui.close();
                }
            }
        });
        if ui.button(tr!("No color")).clicked() {
            tint = Some(Vec::new());
        }
        if let Some(tint) = tint {
            let edit = match &item {
                Item::Frame(id) => edits::set_frame(session, id, |frame| frame.color = tint),
                Item::Note(id) => edits::set_note(session, id, |note| note.color = tint),
                Item::Node(_) | Item::Pass(..) => None,
            };
            out.extend(edit.map(Command::Edit));
        }
        ui.separator();
        let graph = session.selection.graph_id().clone();
        let remove = match item {
            Item::Frame(_) => tr!("Remove the frame"),
            _ => tr!("Remove the note"),
        };
        if ui.button(remove).clicked() {
            out.push(Command::Edit(match item {
                Item::Frame(id) => crate::document::Edit::RemoveFrame { graph, id },
                Item::Note(id) => crate::document::Edit::RemoveNote { graph, id },
                Item::Node(id) | Item::Pass(id, _) => {
                    crate::document::Edit::RemoveNode { graph, id }
                }
            }));
        }
    }
}

/// Converts a color of a document to one of the screen.
pub(super) fn color(rgb: [f64; 3]) -> Color32 {
    let [r, g, b] = rgb.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

/// Shows blocks of menu entries; returns the chosen command.
fn rows(ui: &mut Ui, blocks: &[&[GraphCommand]]) -> Option<GraphCommand> {
    let mut chosen = None;
    for (index, block) in blocks.iter().enumerate() {
        if index > 0 {
            ui.separator();
        }
        let found = block
            .iter()
            .filter_map(|command| Some((*command, table::row_of(&Command::Graph(*command))?)));
        for (command, row) in found {
            let button = egui::Button::new(row.label.tr()).shortcut_text(row.text());
            let response = ui.add(button);
            response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, row.label));
            if response.clicked() {
                chosen = Some(command);
                ui.close();
            }
        }
    }
    chosen
}

/// Names of the groups on a path.
fn crumb_names(session: &Session, path: &[NodeId]) -> Vec<String> {
    let mut graph = Some(&session.look().graph);
    let mut names = Vec::with_capacity(path.len());
    for id in path {
        let node = graph.and_then(|graph| graph.nodes.get(id));
        let kind = node.and_then(|node| session.project.catalog.of(node));
        names.push(match (node, kind) {
            (Some(node), _) if !node.name.is_empty() => node.name.clone(),
            (_, Some(kind)) => names::of(&kind.id, &kind.label).to_owned(),
            _ => id.to_string(),
        });
        graph = node
            .and_then(|node| session.look_with_library().definition_of(&node.kind))
            .map(|definition| &definition.graph);
    }
    names
}

/// Origin of the open group that is not the look's own: a short text, and an explanation.
fn origin(session: &Session) -> (&'static str, &'static str) {
    let is_own = |id: &str| Library::built_in().groups.contains_key(id);
    match session.selection.graph_id() {
        GraphId::Definition(id) if !is_own(id.as_str()) => (
            tr!("Shared by the project"),
            tr!("It lies in the nodes folder beside the look, and every look of the folder has it"),
        ),
        _ => (tr!("From the library"), tr!("It comes with Chiaro, and is the same in every look")),
    }
}
