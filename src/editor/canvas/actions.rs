//! Actions of keys, menus and the command palette on the canvas.

use chiaro_locale::{tr, trn};
use eframe::egui;
use eframe::egui::{Event, Id, Pos2, Rect, Ui, Vec2, pos2};

use super::arrange::{self, Link, Side};
use super::inplace::Item;
use super::palette::Palette;
use super::{Canvas, READ_ONLY, edits};
use crate::commands::table::{self, KeyScope};
use crate::commands::{Command, GraphCommand, Heading, keyboard};
use crate::document::{Bookmark, Edit, grouping};
use crate::ids::NodeId;
use crate::state::parts::placing::{self, Recipient};
use crate::state::session::Session;

/// Distance that an arrow key moves nodes, in points of the graph.
const STEP: f32 = 12.0;

impl Canvas {
    /// Runs the commands of pressed keys, while no text is being typed, and the command that the
    /// command palette asked for.
    pub(super) fn keys(
        &mut self,
        ui: &Ui,
        pointer: Option<Pos2>,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let mut commands: Vec<GraphCommand> = self.asked.take().into_iter().collect();
        if self.palette.is_some() || self.editing.is_some() {
            return;
        }
        let is_typing = keyboard::is_keyboard_taken(ui.ctx());
        if !is_typing {
            // Escape first closes a popup that is open over the window, such as a color picker;
            // that press must not also cancel a gesture here.
            let is_free = !egui::Popup::is_any_open(ui.ctx());
            if is_free && keyboard::take(ui, (egui::Modifiers::NONE, egui::Key::Escape)) {
                self.cancel();
            }
            commands
                .extend(std::mem::take(&mut self.wants_search).then_some(GraphCommand::AddNode));
            // What is typed over an open list or menu is meant for that.
            let pressed = if is_free { table::pressed(ui, KeyScope::Graph) } else { Vec::new() };
            commands.extend(pressed.into_iter().filter_map(|command| match command {
                Command::Graph(command) => Some(command),
                _ => None,
            }));
            self.clipboard(ui, pointer, session, out);
        }
        for command in commands {
            self.run(command, pointer, session, out);
        }
    }

    /// Runs copy, cut and paste, which the window system sends as events of their own.
    fn clipboard(
        &mut self,
        ui: &Ui,
        pointer: Option<Pos2>,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let events: Vec<Event> = ui.input_mut(|input| {
            let is_it = |event: &Event| matches!(event, Event::Copy | Event::Cut | Event::Paste(_));
            let (ours, others) = std::mem::take(&mut input.events).into_iter().partition(is_it);
            input.events = others;
            ours
        });
        for event in events {
            match event {
                Event::Copy => self.run(GraphCommand::Copy, pointer, session, out),
                Event::Cut => self.run(GraphCommand::Cut, pointer, session, out),
                Event::Paste(text) => self.paste(&text, pointer, session, out),
                _ => {}
            }
        }
    }

    /// Adds nodes that were copied here, in another window or in a text editor.
    pub(super) fn paste(
        &mut self,
        text: &str,
        pointer: Option<Pos2>,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let at = pointer.map(|at| self.view.to_graph(at));
        let at = at.map(|at| [at.x - super::theme::NODE_WIDTH / 2.0, at.y].map(f64::from));
        let project = &session.project;
        let to = Recipient {
            look: session.look(),
            catalog: &project.catalog,
            library: &project.library,
        };
        match placing::of_text(to, session.selection.graph_id(), text, at) {
            Ok((pasted, told)) => {
                self.item = pasted
                    .notes
                    .first()
                    .cloned()
                    .filter(|_| pasted.nodes.is_empty())
                    .map(Item::Note);
                out.extend([Command::Edit(pasted.edit), Command::Select(pasted.nodes)]);
                out.extend((!told.is_empty()).then_some(Command::Tell(told)));
            }
            Err(problem) => out.push(Command::Tell(
                crate::state::problem_text::sentence(&problem).replace('\n', ": "),
            )),
        }
    }

    fn cancel(&mut self) {
        let was_idle = matches!(self.gesture, super::Gesture::Idle);
        self.gesture = super::Gesture::Idle;
        if !was_idle {
            self.table.forget();
        }
    }

    /// Ids of the selected nodes, without the two ends of a group.
    fn chosen(session: &Session) -> Vec<NodeId> {
        session
            .selection
            .nodes()
            .filter(|id| session.graph().nodes.contains_key(*id))
            .cloned()
            .collect()
    }

    /// Runs a command of the canvas.
    pub(super) fn run(
        &mut self,
        command: GraphCommand,
        pointer: Option<Pos2>,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        if session.graph_view().is_read_only() && changes(command) {
            out.push(Command::Tell(READ_ONLY.tr().to_owned()));
            return;
        }
        let chosen = Self::chosen(session);
        let at = pointer.unwrap_or(self.view.screen.center());
        match command {
            GraphCommand::AddNode => self.palette = Some(Palette::new(at, None)),
            GraphCommand::Swap => {
                let kind = |id| session.project.catalog.of(session.graph().nodes.get(id)?).cloned();
                self.palette = chosen.last().map(|id| Palette::swapping(at, id.clone(), kind(id)));
            }
            GraphCommand::Note => {
                let (id, edit) = edits::note(session, self.view.to_graph(at));
                out.push(Command::Edit(edit));
                self.edit_when_there = Some(Item::Note(id));
            }
            GraphCommand::ShowAll => self.fit(),
            GraphCommand::ShowSelected => self.fit_selected(session),
            GraphCommand::SnapGrid => {
                self.snaps_to_grid = !self.snaps_to_grid;
                let what = if self.snaps_to_grid {
                    tr!("Nodes snap to the grid")
                } else {
                    tr!("Nodes move freely")
                };
                out.push(Command::Tell(what.to_owned()));
            }
            GraphCommand::Minimap => self.hides_minimap = !self.hides_minimap,
            GraphCommand::Costs => self.costs.toggle(),
            GraphCommand::GoTo(key) => self.go_to(session, key),
            GraphCommand::Remember(key) => out.push(Command::Edit(self.remember(session, key))),
            GraphCommand::LeaveGroup => {
                let path = session.selection.open_groups();
                if let Some((_, outer)) = path.split_last() {
                    out.push(Command::OpenGraph(outer.to_vec()));
                }
            }
            GraphCommand::Nudge(way) => self.nudge(way, &chosen, session, out),
            GraphCommand::SelectNext(way) => self.select_next(way, session, out),
            GraphCommand::SelectAll => {
                out.push(Command::Select(session.graph().nodes.keys().cloned().collect()));
            }
            GraphCommand::SelectNone => out.push(Command::Select(Vec::new())),
            GraphCommand::Invert => {
                let others = session
                    .graph()
                    .nodes
                    .keys()
                    .filter(|id| !session.selection.nodes.contains(*id));
                out.push(Command::Select(others.cloned().collect()));
            }
            GraphCommand::Delete if self.item.is_some() => self.delete_item(session, out),
            GraphCommand::Rename if self.item.is_some() || chosen.is_empty() => {
                self.edit_when_there = self.item.clone();
            }
            _ if !chosen.is_empty() => self.run_on(command, &chosen, session, out),
            GraphCommand::NamePass => {
                let text = tr!("Select the node of which an output is to be a pass");
                out.push(Command::Tell(text.to_owned()));
            }
            GraphCommand::Connect => self.fit(),
            GraphCommand::Layout => self.lay_out(&chosen, session, out),
            _ => {}
        }
    }

    /// Runs a command that needs selected nodes.
    fn run_on(
        &mut self,
        command: GraphCommand,
        chosen: &[NodeId],
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let graph = session.selection.graph_id();
        let of = session.graph();
        match command {
            GraphCommand::Delete => {
                out.extend(edits::delete(session, chosen.iter().cloned()).map(Command::Edit));
            }
            GraphCommand::Dissolve => {
                out.extend(edits::dissolve(session, chosen).map(Command::Edit));
            }
            GraphCommand::Duplicate => {
                let (ids, edit) = edits::duplicate(session, chosen);
                out.extend([Command::Edit(edit), Command::Select(ids)]);
            }
            GraphCommand::Copy | GraphCommand::Cut => {
                let text = grouping::copy_text(session.look(), of, chosen, &[]);
                out.push(Command::Copy(text));
                let copied = trn!(
                    count = chosen.len(),
                    "{count} node is copied · Ctrl+V adds it, in this look or another",
                    "{count} nodes are copied · Ctrl+V adds them, in this look or another"
                );
                if command == GraphCommand::Cut {
                    out.extend(edits::delete(session, chosen.iter().cloned()).map(Command::Edit));
                }
                out.push(Command::Tell(copied));
            }
            GraphCommand::Upstream => {
                out.push(Command::Select(edits::stream(session, chosen, true)));
            }
            GraphCommand::Downstream => {
                out.push(Command::Select(edits::stream(session, chosen, false)));
            }
            GraphCommand::Rename => self.edit_when_there = chosen.last().cloned().map(Item::Node),
            GraphCommand::NamePass => {
                if let Some(id) = chosen.last() {
                    self.begin_pass(id, session, out);
                }
            }
            GraphCommand::Mute => {
                let muted = chosen.iter().any(|id| !of.nodes[id].muted);
                let mute =
                    |id: &NodeId| Edit::SetMuted { graph: graph.clone(), id: id.clone(), muted };
                out.push(Command::Edit(Edit::Group { edits: chosen.iter().map(mute).collect() }));
            }
            GraphCommand::Collapse => {
                let collapsed = chosen.iter().any(|id| !of.nodes[id].collapsed);
                let collapse = |id: &NodeId| Edit::SetCollapsed {
                    graph: graph.clone(),
                    id: id.clone(),
                    collapsed,
                };
                out.push(Command::Edit(Edit::Group {
                    edits: chosen.iter().map(collapse).collect(),
                }));
            }
            GraphCommand::Group => {
                if let Some((id, edit)) = edits::group(session, chosen) {
                    out.extend([Command::Edit(edit), Command::Select(vec![id])]);
                }
            }
            GraphCommand::Ungroup => match edits::ungroup(session, chosen) {
                Ok(Some((ids, edit))) => out.extend([Command::Edit(edit), Command::Select(ids)]),
                Ok(None) => out.push(Command::Tell(tr!("No group is selected").to_owned())),
                Err(problem) => out.push(Command::Tell(problem)),
            },
            GraphCommand::OpenGroup => {
                out.extend(chosen.last().and_then(|id| self.open(session, id)));
            }
            GraphCommand::ShareGroup => {
                let kind =
                    chosen.last().and_then(|id| of.nodes.get(id)).map(|node| node.kind.as_str());
                out.extend(
                    kind.filter(|kind| session.look_with_library().definition_of(kind).is_some())
                        .map(|kind| Command::ShareGroup(kind.into())),
                );
            }
            GraphCommand::Frame => {
                if let Some((id, edit)) = edits::frame(session, chosen) {
                    out.push(Command::Edit(edit));
                    self.edit_when_there = Some(Item::Frame(id));
                }
            }
            GraphCommand::Unframe => {
                let edits = edits::leave_frames(session, chosen);
                out.extend((!edits.is_empty()).then_some(Command::Edit(Edit::Group { edits })));
            }
            GraphCommand::Connect => self.connect_chosen(chosen, session, out),
            GraphCommand::Layout => self.lay_out(chosen, session, out),
            _ => self.arrange(command, chosen, session, out),
        }
    }

    /// The command that opens a group's graph; `None` where the node is no group.
    pub(super) fn open(&self, session: &Session, id: &NodeId) -> Option<Command> {
        let kind = &session.graph().nodes.get(id)?.kind;
        session.look_with_library().definition_of(kind)?;
        Some(Command::OpenGraph(session.selection.path_of(id).ids().to_vec()))
    }

    fn delete_item(&mut self, session: &Session, out: &mut Vec<Command>) {
        let graph = session.selection.graph_id().clone();
        out.extend(match self.item.take() {
            Some(Item::Frame(id)) => Some(Command::Edit(Edit::RemoveFrame { graph, id })),
            Some(Item::Note(id)) => Some(Command::Edit(Edit::RemoveNote { graph, id })),
            _ => None,
        });
    }

    /// Wires the selected nodes to one another from left to right.
    fn connect_chosen(&mut self, chosen: &[NodeId], session: &Session, out: &mut Vec<Command>) {
        let mut indices: Vec<usize> =
            chosen.iter().filter_map(|id| self.table.index_of(id)).collect();
        indices.sort_by(|&a, &b| {
            self.table.nodes[a].rect.min.x.total_cmp(&self.table.nodes[b].rect.min.x)
        });
        let pairs = indices.windows(2).filter_map(|pair| self.pair(pair[0], pair[1]));
        let edits: Vec<Edit> = pairs
            .map(|(from, to)| edits::connect(session, self.endpoint(from), self.endpoint(to)))
            .collect();
        if edits.is_empty() {
            self.fit();
        } else {
            out.push(Command::Edit(Edit::Group { edits }));
        }
    }

    fn arrange(
        &mut self,
        command: GraphCommand,
        chosen: &[NodeId],
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let indices: Vec<usize> = chosen.iter().filter_map(|id| self.table.index_of(id)).collect();
        let rects: Vec<Rect> = indices.iter().map(|&index| self.table.nodes[index].rect).collect();
        let places = match command {
            GraphCommand::AlignLeft => arrange::align(&rects, Side::Left),
            GraphCommand::AlignRight => arrange::align(&rects, Side::Right),
            GraphCommand::AlignTop => arrange::align(&rects, Side::Top),
            GraphCommand::AlignBottom => arrange::align(&rects, Side::Bottom),
            GraphCommand::DistributeAcross => arrange::distribute(&rects, true),
            GraphCommand::DistributeDown => arrange::distribute(&rects, false),
            _ => return,
        };
        let ids = indices.iter().map(|&index| self.table.nodes[index].id.clone());
        out.push(Command::Edit(edits::put(session, ids.zip(places))));
    }

    /// Lays out the selected nodes, or all nodes where fewer than two are selected.
    fn lay_out(&mut self, chosen: &[NodeId], session: &Session, out: &mut Vec<Command>) {
        let all: Vec<usize> =
            (0..self.table.nodes.len()).filter(|&index| !self.table.nodes[index].is_end).collect();
        let some: Vec<usize> = chosen.iter().filter_map(|id| self.table.index_of(id)).collect();
        let indices = if some.len() < 2 { all } else { some };
        let mut own = vec![None; self.table.nodes.len()];
        indices.iter().enumerate().for_each(|(place, &index)| own[index] = Some(place));
        let link = |wire: &super::table::WireRow| {
            let below = |socket: super::table::Socket| {
                self.table.place(socket).y - self.table.nodes[socket.node].rect.min.y
            };
            let (from, to) = (own[wire.from.node]?, own[wire.to.node]?);
            Some(Link { from, to, from_y: below(wire.from), to_y: below(wire.to) })
        };
        let links: Vec<Link> = self.table.wires.iter().filter_map(link).collect();
        let rects: Vec<Rect> = indices.iter().map(|&index| self.table.nodes[index].rect).collect();
        let places = arrange::layers(&rects, &links);
        let laid = places.iter().zip(&rects);
        let bounds =
            edits::around(laid.map(|(&place, rect)| Rect::from_min_size(place, rect.size())));
        if !self.view.visible().contains_rect(bounds) {
            self.view.fit(bounds);
        }
        let ids = indices.iter().map(|&index| self.table.nodes[index].id.clone());
        let edit = edits::put(session, ids.zip(places));
        out.push(Command::Edit(edit));
    }

    /// Moves the selected nodes by one arrow key; with nothing selected, selects the node nearest
    /// to the middle of the view.
    fn nudge(&self, way: Heading, chosen: &[NodeId], session: &Session, out: &mut Vec<Command>) {
        if chosen.is_empty() {
            return self.select_next(way, session, out);
        }
        let edit = edits::translate(session, chosen.iter(), way.step() * STEP);
        out.push(Command::EditHeld(Id::unique("nudge"), edit));
    }

    /// Selects the nearest node in a direction.
    fn select_next(&self, way: Heading, session: &Session, out: &mut Vec<Command>) {
        let current = session.selection.nodes.last().and_then(|id| self.table.index_of(id));
        let step = way.step();
        let from = current.map_or(self.view.center, |index| self.table.nodes[index].rect.center());
        let cost = |rect: &Rect| {
            let way: Vec2 = rect.center() - from;
            let along = way.dot(step);
            let aside = (way - step * along).length();
            match current {
                // A node straight ahead is preferred to a near one that lies aside.
                Some(_) => (along > 1.0 && aside < along * 3.0).then_some(along + aside * 2.0),
                None => Some(way.length()),
            }
        };
        let others =
            self.table.nodes.iter().enumerate().filter(|(index, _)| Some(*index) != current);
        let found = others
            .filter_map(|(_, row)| Some((cost(&row.rect)?, &row.id)))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, id)) = found {
            out.push(Command::Reveal(id.clone()));
        }
    }

    fn fit_selected(&mut self, session: &Session) {
        let indices = session.selection.nodes().filter_map(|id| self.table.index_of(id));
        let bounds = edits::around(indices.map(|index| self.table.nodes[index].rect));
        self.view.fit(if bounds.is_positive() { bounds } else { self.table.bounds() });
    }

    fn go_to(&mut self, session: &Session, key: u8) {
        if let Some(bookmark) =
            session.graph().bookmarks.iter().find(|bookmark| bookmark.key == key)
        {
            let [x, y] = bookmark.position.map(|x| x as f32);
            self.set_zoom_and_center(super::view::bounded(bookmark.zoom as f32), pos2(x, y));
        }
    }

    fn remember(&self, session: &Session, key: u8) -> Edit {
        let position = [self.view.center.x, self.view.center.y].map(|x| f64::from(x).round());
        // Three decimals are finer than the eye can tell.
        let zoom = (f64::from(self.view.zoom) * 1000.0).round() / 1000.0;
        let mut bookmarks = session.graph().bookmarks.clone();
        bookmarks.retain(|bookmark| bookmark.key != key);
        bookmarks.push(Bookmark { key, position, zoom });
        bookmarks.sort_by_key(|bookmark| bookmark.key);
        Edit::SetBookmarks { graph: session.selection.graph_id().clone(), bookmarks }
    }

    /// Edit that renames a node; a group's node without a name of its own shows its group's name.
    pub(super) fn rename(session: &Session, id: &NodeId, name: String) -> Edit {
        Edit::SetName { graph: session.selection.graph_id().clone(), id: id.clone(), name }
    }
}

/// True if a command changes the document.
fn changes(command: GraphCommand) -> bool {
    !matches!(
        command,
        GraphCommand::Copy
            | GraphCommand::SelectAll
            | GraphCommand::SelectNone
            | GraphCommand::Invert
            | GraphCommand::Upstream
            | GraphCommand::Downstream
            | GraphCommand::OpenGroup
            | GraphCommand::NamePass
            | GraphCommand::LeaveGroup
            | GraphCommand::Connect
            | GraphCommand::ShowAll
            | GraphCommand::ShowSelected
            | GraphCommand::SnapGrid
            | GraphCommand::Minimap
            | GraphCommand::Costs
            | GraphCommand::GoTo(_)
            | GraphCommand::SelectNext(_)
    )
}
