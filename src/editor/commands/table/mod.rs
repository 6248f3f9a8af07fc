//! Table of all commands that people ask for by name: label, help, keys, and the place where the
//! keys work. Keys, menus, the sheet of shortcuts and the command palette list this table.

mod graph;
mod languages;
mod painting;
mod picture;
mod window;

use std::borrow::Cow;
use std::sync::LazyLock;

use eframe::egui;
use eframe::egui::{Key, Modifiers};

use super::{Command, GraphCommand as G, keyboard};

/// Place where a key works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyScope {
    /// Everywhere.
    Window,
    /// Over the graph, while no text is typed.
    Graph,
    /// Over the picture.
    Picture,
    /// Over the picture while light is painted on it, beside the other keys there.
    Light,
    /// Over the tile that is painted on.
    Painting,
}

impl KeyScope {
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Window => "Everywhere",
            Self::Graph => "In the graph",
            Self::Picture => "In the picture",
            Self::Light => "In the picture, painting light",
            Self::Painting => "On the tile that is painted",
        }
    }
}

/// Menu of the bar above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Menu {
    Paint,
    Export,
    CopyAs,
    Help,
}

/// Row of the table.
#[derive(Clone, Debug)]
pub(crate) struct CommandRow {
    pub(crate) command: Command,
    pub(crate) label: Cow<'static, str>,
    /// Explanation of the command, where the label does not give one.
    help: &'static str,
    /// Keys of the command, any of which will do; the first is shown.
    pub(crate) keys: &'static [(Modifiers, Key)],
    pub(crate) place: KeyScope,
    /// Menu that lists the command.
    pub(crate) menu: Option<Menu>,
    /// True if the command is about the HCBTF that is open to be painted.
    pub(crate) needs_painting: bool,
}

const NONE: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::COMMAND;
const SHIFT: Modifiers = Modifiers::SHIFT;
const ALT: Modifiers = Modifiers::ALT;
const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };

/// All rows. A row whose key has more modifiers stands before one with fewer, as the first that
/// fits takes a key.
static ROWS: LazyLock<Vec<CommandRow>> = LazyLock::new(|| {
    let mut rows = window::files();
    rows.extend(languages::rows());
    rows.extend(window::rows());
    rows.extend(picture::rows());
    rows.extend(painting::rows());
    rows.extend(graph::rows());
    rows
});

/// All rows, in the order of lists.
pub(crate) fn rows() -> impl Iterator<Item = &'static CommandRow> {
    ROWS.iter()
}

/// The row of a command.
pub(crate) fn row_of(command: &Command) -> Option<&'static CommandRow> {
    rows().find(|row| row.command == *command)
}

/// Explanation of a command, with its key, for a tooltip.
pub(crate) fn help_of(command: &Command) -> String {
    row_of(command).map(CommandRow::help_with_key).unwrap_or_default()
}

fn row(
    command: Command,
    label: impl Into<Cow<'static, str>>,
    keys: &'static [(Modifiers, Key)],
    place: KeyScope,
) -> CommandRow {
    let label = label.into();
    CommandRow { command, label, help: "", keys, place, menu: None, needs_painting: false }
}

impl CommandRow {
    fn help(self, help: &'static str) -> Self {
        Self { help, ..self }
    }

    fn in_menu(self, menu: Menu) -> Self {
        Self { menu: Some(menu), ..self }
    }

    fn needing_painting(self) -> Self {
        Self { needs_painting: true, ..self }
    }

    /// First key of the row, as people read it.
    pub(crate) fn text(&self) -> String {
        self.keys.first().map_or_else(String::new, |&(modifiers, key)| key_text(modifiers, key))
    }

    /// Explanation of the command, with its key.
    pub(crate) fn help_with_key(&self) -> String {
        let help = if self.help.is_empty() { &*self.label } else { self.help };
        match self.text() {
            key if key.is_empty() => help.to_owned(),
            key => format!("{help} ({key})"),
        }
    }
}

fn key_text(modifiers: Modifiers, key: Key) -> String {
    let names = [
        (modifiers.command || modifiers.ctrl, "Ctrl+"),
        (modifiers.shift, "Shift+"),
        (modifiers.alt, "Alt+"),
    ];
    let mut text: String =
        names.into_iter().filter(|(is_on, _)| *is_on).map(|(_, name)| name).collect();
    text += match key {
        Key::ArrowLeft => "Left",
        Key::ArrowRight => "Right",
        Key::ArrowUp => "Up",
        Key::ArrowDown => "Down",
        Key::Delete => "Del",
        Key::OpenBracket => "[",
        Key::CloseBracket => "]",
        Key::Questionmark => "?",
        Key::Period => ".",
        Key::Plus => "+",
        Key::Minus => "-",
        other => other.name(),
    };
    text
}

/// Takes the pressed keys of a place, and returns their commands. Copy, cut and paste come as
/// events of their own, and Tab must be taken earlier than here, before it moves the focus.
pub(crate) fn pressed(ui: &egui::Ui, place: KeyScope) -> Vec<Command> {
    let rows = rows().filter(|row| row.place == place);
    let is_event =
        |command: &Command| matches!(command, Command::Graph(G::Copy | G::Cut | G::Paste));
    let rows = rows.filter(|row| !is_event(&row.command));
    // No key is pressed in most frames.
    if !ui.input(|input| {
        input.events.iter().any(|event| matches!(event, egui::Event::Key { pressed: true, .. }))
    }) {
        return Vec::new();
    }
    rows.filter(|row| row.keys.iter().any(|&key| keyboard::take(ui, key)))
        .map(|row| row.command.clone())
        .collect()
}

/// Actions of the pointer on the graph, for the sheet of shortcuts.
pub(crate) const POINTER: &[(&str, &str)] = &[
    ("Double-click on nothing", "Add a node"),
    ("Double-click on a title", "Open the group, or rename"),
    ("Double-click on a wire", "Add a reroute"),
    ("Drag from a socket", "Draw a wire; on nothing: add what fits"),
    ("Drag a node onto a wire", "Insert it there"),
    ("Alt-drag a node", "Wire it to what it comes near"),
    ("Alt-drag on nothing", "Select by a lasso"),
    ("Drag on nothing", "Select by a box"),
    ("Ctrl+right-drag", "Cut wires"),
    ("Alt-click on a wire", "Remove it"),
    ("Wheel", "Zoom"),
    ("Middle or right drag, Space+drag", "Move the view"),
    ("Right-click", "Menu"),
];

/// Keys of the light table, as the sheet of shortcuts lists them; the table takes them where one of
/// its cells has the focus.
pub(crate) const LIGHT_TABLE: &[(&str, &str)] = &[
    ("Enter, F2 or typing", "Change all selected cells"),
    ("0.5  *1.2  +0.1  50%", "Typed: a value or a change"),
    ("Alt+Up, Alt+Down", "Nudge"),
    ("K", "Key, or take the key away"),
    ("Space", "Turn a switch"),
    ("Delete", "Reset"),
    ("Ctrl+C, Ctrl+V", "Copy and paste cells"),
    ("Ctrl+A", "Select more"),
];

/// Actions of the pointer on the tile that is painted, for the sheet of shortcuts.
pub(crate) const PAINTING_POINTER: &[(&str, &str)] = &[
    ("Drag", "Paint, with the tool at hand"),
    ("Alt-click", "Pick a color"),
    ("Shift-click with the stamp", "Take this tile as the stamp"),
    ("Hold V", "Look at the sample from before"),
    ("Alt over the map or the list", "Look at that sample"),
    ("Shift-click on the map", "Copy that sample to the one at work"),
    ("Wheel over the palette", "Brighter or darker"),
    ("Wheel", "Zoom"),
    ("Middle or right drag, Space+drag", "Move the tile"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export;

    #[test]
    fn no_key_does_two_things_in_one_place() {
        for (index, row) in ROWS.iter().enumerate() {
            for other in &ROWS[index + 1..] {
                let are_over_picture = |place| matches!(place, KeyScope::Picture | KeyScope::Light);
                let is_window = row.place == KeyScope::Window || other.place == KeyScope::Window;
                let meet = row.place == other.place || is_window;
                let meet = meet || are_over_picture(row.place) && are_over_picture(other.place);
                let same = row.keys.iter().any(|key| other.keys.contains(key));
                assert!(!(meet && same), "{:?} and {:?}", row.command, other.command);
                assert_ne!(row.command, other.command);
            }
        }
    }

    #[test]
    fn every_language_can_be_exported_and_all_but_binary_ones_copied() {
        for language in export::LANGUAGES {
            let row = row_of(&Command::ExportLook(language.slug, None))
                .unwrap_or_else(|| panic!("{}", language.slug));
            let name =
                language.label.trim_end_matches(|c: char| c.is_ascii_digit() || ".- ".contains(c));
            assert!(
                row.label.contains(name.split(',').next().unwrap()),
                "{} for {}",
                row.label,
                language.label
            );
            // The row of a language must not name an API that the language's own note denies.
            let denied = language
                .note
                .split_once("not for ")
                .map(|(_, rest)| rest.split([':', ',']).next().unwrap());
            assert!(denied.is_none_or(|api| !row.label.contains(api)), "{}", row.label);
            let copies = |row: &CommandRow| {
                let Command::CopyShader(slug, _) = row.command else { return false };
                slug == language.slug
            };
            let is_copied = language.slug == "wgsl" || ROWS.iter().any(copies);
            assert_eq!(is_copied, language.slug != "spirv", "{}", language.slug);
        }
    }

    #[test]
    fn keys_are_told() {
        assert_eq!(row_of(&Command::Graph(G::Ungroup)).unwrap().text(), "Ctrl+Shift+G");
        assert_eq!(row_of(&Command::OpenShortcuts).unwrap().text(), "?");
    }
}
