//! Sheet of all shortcuts, and command palette: both list rows of the table of commands. The
//! palette finds nodes of the open graph too, however many there are, and nodes to add.

use std::sync::Arc;

use chiaro_locale::{Text, tr, tr_in};
use eframe::egui;
use eframe::egui::{
    Align, Align2, Event, Key, Label, Layout, Modifiers, RichText, ScrollArea, TextEdit, Ui, Vec2,
    WidgetInfo, vec2,
};

use crate::canvas::palette;
use crate::catalog::NodeKind;
use crate::commands::table::{self, CommandRow, KeyScope, LIGHT_TABLE, PAINTING_POINTER, POINTER};
use crate::commands::{Command, GraphCommand, keyboard};
use crate::fields::{names, passes};
use crate::ids::NodeId;
use crate::panels::PANELS;
use crate::state::session::Session;
use crate::widgets::theme;

/// Width of the palette, in points.
const WIDTH: f32 = 420.0;
/// Width of the sheet of shortcuts, in points.
const SHEET: f32 = 1080.0;
/// Least width of a column of shortcuts, in points.
const COLUMN: f32 = 320.0;
/// Distance of the sheet from the window's top, where the bar stays in sight, in points.
const BELOW_BAR: f32 = 70.0;
/// Height of a window, in points, below which the sheet covers the bar.
const LOW: f32 = 500.0;
/// Least distance of the sheet from the edges of the window, in points.
const APART: f32 = 8.0;
/// Height of the palette's rows, in points.
const ROW: f32 = 24.0;
/// Largest number of listed nodes; a longer query finds the others.
const MOST_NODES: usize = 40;

/// The sheet or the palette, whichever is open.
#[derive(Default)]
pub(crate) struct Sheet {
    open: Option<OpenSheet>,
    /// Keys and texts that were typed for the palette before its field was there.
    early: Vec<Event>,
}

enum OpenSheet {
    Shortcuts { is_new: bool },
    Commands { query: String, index: usize, is_new: bool },
}

impl Sheet {
    /// Opens the palette of commands, or closes it where it is open.
    pub(crate) fn open_palette(&mut self) {
        self.open = match self.open {
            Some(OpenSheet::Commands { .. }) => None,
            _ => Some(OpenSheet::Commands { query: String::new(), index: 0, is_new: true }),
        };
    }

    /// Opens the sheet of shortcuts, or closes it where it is open.
    pub(crate) fn open_shortcuts(&mut self) {
        self.open = match self.open {
            Some(OpenSheet::Shortcuts { .. }) => None,
            _ => Some(OpenSheet::Shortcuts { is_new: true }),
        };
    }

    /// Keeps what is typed for a palette that is opened in this frame, or was not shown yet:
    /// nobody else takes it, for a slow window gets a word at once with the key that opens the
    /// palette.
    pub(crate) fn keep_early(&mut self, ui: &Ui) {
        let is_new = matches!(self.open, Some(OpenSheet::Commands { is_new: true, .. }));
        let may_open = self.open.is_none() && !keyboard::is_dialog_open(ui.ctx());
        if self.open.is_none() {
            self.early.clear();
        }
        let opens = |event: &Event| match event {
            Event::Key { key, modifiers, pressed: true, .. } => {
                let rows = table::rows().filter(|row| row.command == Command::OpenPalette);
                let mut keys = rows.flat_map(|row| row.keys);
                keys.any(|(wanted, wanted_key)| {
                    key == wanted_key && modifiers.matches_exact(*wanted)
                })
            }
            _ => false,
        };
        ui.input_mut(|input| {
            let from = match () {
                () if is_new => Some(0),
                () if may_open => input.events.iter().position(opens).map(|at| at + 1),
                () => None,
            };
            let Some(from) = from else { return };
            let later = input.events.split_off(from);
            let is_typed =
                |event: &Event| matches!(event, Event::Text(_) | Event::Key { pressed: true, .. });
            let (typed, others): (Vec<Event>, _) = later.into_iter().partition(is_typed);
            self.early.extend(typed);
            input.events.extend(others);
        });
    }

    pub(crate) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Closes the sheet or the palette on Esc, before others take that key.
    pub(crate) fn take_escape(&mut self, ui: &Ui) {
        if self.is_open() && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
            self.open = None;
        }
    }

    /// Shows the open sheet or palette. Returns the chosen command.
    pub(crate) fn show(&mut self, ui: &Ui, session: &Session) -> Option<Command> {
        let shown = self.open.as_mut()?;
        let (mut chosen, is_new) = (None, shown.is_new());
        let early = &mut self.early;
        let screen = ui.ctx().content_rect();
        // A window may be narrower than the sheet, and hardly higher than a few of its rows.
        let width = if matches!(shown, OpenSheet::Shortcuts { .. }) { SHEET } else { WIDTH };
        let frame = egui::Frame::popup(ui.style());
        let around = frame.total_margin().sum();
        let width = width.min(screen.width() - around.x - 2.0 * APART);
        let top = if screen.height() < LOW { APART } else { BELOW_BAR };
        let height = screen.height() - top - around.y - APART;
        let mut is_closed = false;
        let area = egui::Area::new(egui::Id::unique("sheet")).order(egui::Order::Foreground);
        let left = -(width + around.x) / 2.0;
        let area = area.fixed_pos(screen.center_top() + vec2(left, top));
        let response = area.show(ui.ctx(), |ui| {
            frame.show(ui, |ui| match shown {
                OpenSheet::Shortcuts { .. } => is_closed = show_shortcuts(ui, vec2(width, height)),
                OpenSheet::Commands { query, index, is_new } => {
                    // Nothing takes the keyboard while the palette's size is found.
                    if *is_new && !ui.is_sizing_pass() {
                        *is_new = false;
                        ui.input_mut(|input| input.events.append(early));
                        ui.memory_mut(|memory| memory.request_focus(query_id()));
                    }
                    let size = vec2(width, height);
                    chosen = show_commands(ui, session, query, index, size);
                }
            });
        });
        let is_outside = ui.input(|input| {
            let press = input.pointer.any_pressed().then(|| input.pointer.interact_pos()).flatten();
            press.is_some_and(|press| !response.response.rect.contains(press))
        });
        if chosen.is_some() || is_closed || is_outside && !is_new {
            self.open = None;
        }
        chosen
    }
}

impl OpenSheet {
    fn is_new(&mut self) -> bool {
        match self {
            Self::Shortcuts { is_new } => std::mem::replace(is_new, false),
            Self::Commands { is_new, .. } => *is_new,
        }
    }
}

/// Shows the shortcuts in as many columns as have room. Returns true if the sheet is to be closed.
fn show_shortcuts(ui: &mut Ui, size: Vec2) -> bool {
    ui.set_width(size.x);
    let top = ui.cursor().top();
    let head = ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let is_closed = ui.button(tr!("Close")).clicked();
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let heading = RichText::new(tr!("Shortcuts")).heading();
                ui.add(Label::new(heading).truncate());
            });
            is_closed
        })
    });
    ui.spacing_mut().item_spacing.y = 1.0;
    let height = (size.y - (ui.cursor().top() - top)).max(ROW);
    ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
        let count = ((ui.available_width() / COLUMN) as usize).clamp(1, 3);
        ui.columns(count, |columns| {
            for (title, rows) in sections(count) {
                let shortest = |a: &&mut Ui, b: &&mut Ui| {
                    a.min_rect().height().total_cmp(&b.min_rect().height())
                };
                if let Some(column) = columns.iter_mut().min_by(shortest) {
                    list(column, title, &rows);
                }
            }
        });
    });
    head.inner.inner
}

/// Titles and rows of the sheet's parts, for so many columns: the longest part is in two halves
/// beside each other.
fn sections(columns: usize) -> Vec<(&'static str, Vec<(String, String)>)> {
    let told = |rows: &[(Text, Text)]| -> Vec<(String, String)> {
        rows.iter().map(|(key, what)| (key.to_string(), what.to_string())).collect()
    };
    let mut graph: Vec<(String, String)> = rows(KeyScope::Graph).collect();
    let half = if columns > 1 { graph.len().div_ceil(2) } else { graph.len() };
    let rest = graph.split_off(half);
    let mut all = vec![(KeyScope::Graph.label(), graph)];
    if !rest.is_empty() {
        all.push((" ", rest));
    }
    for place in [KeyScope::Window, KeyScope::Picture, KeyScope::Light, KeyScope::Painting] {
        all.push((place.label(), rows(place).collect()));
    }
    all.extend([
        (tr!("With the pointer, in the graph"), told(POINTER)),
        (tr!("With the pointer, on the tile"), told(PAINTING_POINTER)),
        (tr!("In the light table"), told(LIGHT_TABLE)),
    ]);
    all
}

/// Rows of a place; the nine bookmarks are listed as one.
fn rows(place: KeyScope) -> impl Iterator<Item = (String, String)> {
    let rows = table::rows().filter(move |row| row.place == place && !row.keys.is_empty());
    rows.filter_map(|row| match row.command {
        Command::Graph(GraphCommand::GoTo(1)) => {
            Some(("1 … 9".to_owned(), tr!("Go to a bookmark").to_owned()))
        }
        Command::Graph(GraphCommand::Remember(1)) => {
            Some((tr!("Ctrl+1 … 9").to_owned(), tr!("Bookmark this view").to_owned()))
        }
        Command::Graph(GraphCommand::GoTo(_) | GraphCommand::Remember(_)) => None,
        _ => Some((row.text(), row.label.to_string())),
    })
}

fn list(ui: &mut Ui, title: &str, rows: &[(String, String)]) {
    ui.add_space(6.0);
    if !title.is_empty() {
        ui.label(RichText::new(title).strong().color(theme::of(ui).accent));
    }
    for (key, what) in rows {
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.add_space(10.0);
                ui.label(RichText::new(key).color(theme::of(ui).dim));
                // Words of other languages may need more than the keys leave.
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    ui.add(Label::new(what).truncate());
                });
            });
        });
    }
}

/// A row of the palette.
struct Entry {
    label: String,
    /// Key of the command, or a text that tells the row from others.
    aside: String,
    /// Name of the row for screen readers.
    name: String,
    command: Command,
}

/// Field of the palette.
fn query_id() -> egui::Id {
    egui::Id::unique("command query")
}

/// Shows the palette. Returns the chosen command.
fn show_commands(
    ui: &mut Ui,
    session: &Session,
    query: &mut String,
    index: &mut usize,
    size: Vec2,
) -> Option<Command> {
    ui.set_width(size.x);
    let top = ui.cursor().top();
    let key = |ui: &Ui, key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    if key(ui, Key::ArrowDown) {
        *index += 1;
    }
    if key(ui, Key::ArrowUp) {
        *index = index.saturating_sub(1);
    }
    let enter = key(ui, Key::Enter);
    let edit = TextEdit::singleline(query)
        .hint_text(tr!("Find a command or a node"))
        .desired_width(f32::INFINITY);
    let response = ui.add(edit.id(query_id()));
    response.widget_info(|| {
        WidgetInfo::labeled(egui::Role::SearchInput, true, tr!("Find a command or a node"))
    });
    if response.changed() {
        *index = 0;
    }
    let entries = entries(session, query);
    *index = (*index).min(entries.len().saturating_sub(1));
    let mut chosen = enter.then_some(*index);
    let height = (size.y - (ui.cursor().top() - top)).clamp(ROW, ROW * 14.0);
    ui.spacing_mut().item_spacing.y = 0.0;
    ScrollArea::vertical()
        .max_height(height)
        .min_scrolled_height(height)
        .auto_shrink([false, true])
        .show(ui, |ui| {
            for (place, entry) in entries.iter().enumerate() {
                if show_entry(ui, entry, place == *index) {
                    chosen = Some(place);
                }
            }
            if entries.is_empty() {
                ui.label(
                    RichText::new(tr!("Neither a command nor a node of that name"))
                        .color(theme::of(ui).dim),
                );
            }
        });
    chosen.and_then(|place| entries.into_iter().nth(place)).map(|entry| entry.command)
}

/// Shows a row of the palette. Returns true if it was clicked.
fn show_entry(ui: &mut Ui, entry: &Entry, is_current: bool) -> bool {
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), ROW), egui::Sense::click());
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &entry.name));
    let colors = theme::of(ui);
    if is_current || response.hovered() {
        let fill = if is_current { colors.accent_dim } else { colors.field };
        ui.painter().rect_filled(rect, 4.0, fill);
    }
    let font = egui::FontId::proportional(theme::TEXT_SIZE);
    let text =
        |at, align, text: &str, color| ui.painter().text(at, align, text, font.clone(), color);
    text(rect.left_center() + vec2(8.0, 0.0), Align2::LEFT_CENTER, &entry.label, colors.text);
    text(rect.right_center() - vec2(8.0, 0.0), Align2::RIGHT_CENTER, &entry.aside, colors.dim);
    response.clicked()
}

/// Commands, and once there is a query nodes.
fn entries(session: &Session, query: &str) -> Vec<Entry> {
    let command = |row: &CommandRow| Entry {
        label: row.label.to_string(),
        aside: row.text(),
        name: tr!("Command: {label}", label = row.label),
        command: row.command.clone(),
    };
    let node = |(id, title): (&NodeId, String)| Entry {
        name: tr!("Node: {title}"),
        label: title,
        aside: tr!("node {id}"),
        command: Command::Reveal(id.clone()),
    };
    found(query)
        .into_iter()
        .map(command)
        .chain(found_panels(query))
        .chain(found_passes(session, query))
        .chain(found_nodes(session, query).into_iter().map(node))
        .chain(found_kinds(session, query))
        .collect()
}

/// Kinds of nodes to add, where there is a query.
fn found_kinds(session: &Session, query: &str) -> Vec<Entry> {
    if query.trim().is_empty() {
        return Vec::new();
    }
    let entry = |kind: &Arc<NodeKind>| Entry {
        label: tr!("Add {node}", node = names::of(&kind.id, &kind.label)),
        aside: tr_in("node", &kind.category).to_owned(),
        name: tr!("Add a node: {node}", node = names::of(&kind.id, &kind.label)),
        command: Command::AddNode { kind: kind.id.clone(), at: None },
    };
    palette::kinds(&session.project.catalog, query).iter().take(MOST_NODES).map(entry).collect()
}

/// Commands whose label has all words of the query, as it is shown or in English; those that begin
/// with the first word come first.
fn found(query: &str) -> Vec<&'static CommandRow> {
    let query = query.to_lowercase();
    let words: Vec<&str> = query.split_whitespace().collect();
    let rows = table::rows().filter(|row| row.command != Command::OpenPalette);
    let mut found: Vec<&CommandRow> = rows.filter(|row| row.label.has(&words)).collect();
    found.sort_by_key(|row| !words.first().is_some_and(|word| row.label.begins_with(word)));
    found
}

/// Panels, where the query has words of their names.
fn found_panels(query: &str) -> impl Iterator<Item = Entry> {
    let query = query.trim().to_lowercase();
    let fits = move |label: Text| {
        let shown = tr!("Panel {panel}", panel = label);
        let text = format!("{shown} panel {}", label.english()).to_lowercase();
        !query.is_empty() && query.split_whitespace().all(|word| text.contains(word))
    };
    PANELS.iter().filter(move |panel| fits(panel.label)).map(|panel| Entry {
        label: tr!("Panel {panel}", panel = panel.label),
        aside: String::new(),
        name: tr!("Panel: {panel}", panel = panel.label),
        command: Command::ShowPanel(panel.id),
    })
}

/// Outputs that the look names as passes, where the query has words of their names.
fn found_passes(session: &Session, query: &str) -> Vec<Entry> {
    let query = query.trim().to_lowercase();
    let words: Vec<&str> = query.split_whitespace().collect();
    let fits = |name: &str, title: &str| {
        let text = format!("{} pass aov {name} {title}", tr!("Pass")).to_lowercase();
        !words.is_empty() && words.iter().all(|word| text.contains(word))
    };
    let entry = |aov: &crate::document::NamedAov| {
        let title = passes::title_of(session, &aov.from);
        fits(aov.name.as_str(), &title).then(|| Entry {
            label: tr!("Pass {pass}", pass = aov.name),
            aside: title,
            name: tr!("Pass: {pass}", pass = aov.name),
            command: Command::Show(aov.from.node.clone()),
        })
    };
    session.look().aovs.iter().filter_map(entry).collect()
}

/// Nodes of the open graph whose title or id has all words of the query, with their titles; exact
/// matches first.
fn found_nodes<'s>(session: &'s Session, query: &str) -> Vec<(&'s NodeId, String)> {
    let query = query.trim().to_lowercase();
    if query.is_empty() {
        return Vec::new();
    }
    let words: Vec<&str> = query.split_whitespace().collect();
    let named = session.graph().nodes.iter().filter_map(|(id, node)| {
        let kind = session.project.catalog.of(node).map(|kind| &*kind.label);
        let english = if node.name.is_empty() { kind.unwrap_or(id.as_str()) } else { &node.name };
        let title = match node.name.is_empty() {
            true => tr_in("node", english).to_owned(),
            false => node.name.clone(),
        };
        let text = format!("{title} {english} {id}").to_lowercase();
        words.iter().all(|word| text.contains(word)).then_some((id, title))
    });
    let mut found: Vec<(&NodeId, String)> = named.collect();
    found.sort_by_key(|(id, title)| id.as_str() != query && title.to_lowercase() != query);
    found.truncate(MOST_NODES);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_found_by_words() {
        assert_eq!(
            found("group make").first().map(|row| &row.command),
            Some(&Command::Graph(GraphCommand::Group))
        );
        assert_eq!(
            found("tidy").first().map(|row| &row.command),
            Some(&Command::Graph(GraphCommand::Layout))
        );
        assert!(found("xyzzy").is_empty());
    }

    #[test]
    fn nodes_are_found_by_title_and_id() {
        let session =
            Session::new(std::sync::Arc::new(crate::library::Library::built_in().clone()), || {});
        let titles = |query| {
            found_nodes(&session, query)
                .into_iter()
                .map(|(id, _)| id.to_string())
                .collect::<Vec<_>>()
        };
        assert!(titles("").is_empty(), "nobody asked for any");
        assert_eq!(titles("Diff"), ["diffuse"]);
        assert_eq!(titles("out"), ["output"]);
        assert!(titles("xyzzy").is_empty());
    }

    #[test]
    fn nodes_to_add_are_found_after_those_that_are_there() {
        let session = Session::new(Arc::new(crate::library::Library::built_in().clone()), || {});
        let commands = |query| -> Vec<Command> {
            entries(&session, query).into_iter().map(|entry| entry.command).collect()
        };
        let outline = Command::AddNode { kind: "outline".to_owned(), at: None };
        assert_eq!(commands("outline").first(), Some(&outline));
        let light = commands("diffuse");
        assert!(matches!(light[0], Command::Reveal(_)), "{light:?}");
        assert!(found_kinds(&session, " ").is_empty(), "nobody asked for any");
    }
}
